//! The teacher typing how many were for each choice.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::class::{ClassChange, ClassRound, MOST_PEOPLE, Session, Vote};
use crate::messages::Key;
use crate::quiz::letter;
use crate::widgets::flow::Run;
use crate::widgets::input::TextField;
use crate::widgets::{Lines, Look, Role, Words};

pub(super) const ROWS: u16 = 2;
/// Most letters that are typed.
const LONGEST: usize = 40;

/// Counts on their way in: "4 17 9 2".
#[derive(Debug, Clone)]
pub(super) struct TallyEntry {
    pub(super) vote: Vote,
    question: usize,
    field: TextField,
}

impl TallyEntry {
    /// What was counted before, to be put right, or nothing.
    pub(super) fn new(round: &ClassRound, question: usize, vote: Vote) -> Self {
        let counts = round.tally(question, vote).unwrap_or_default();
        let counts: Vec<String> = counts.iter().map(ToString::to_string).collect();
        Self {
            vote,
            question,
            field: TextField::new(&counts.join(" "), LONGEST),
        }
    }

    /// Takes a key of what is typed: figures, and what stands between them.
    pub(super) fn typed(&mut self, key: Key) -> bool {
        let is_own = match key {
            Key::Char(c) => c.is_ascii_digit() || (matches!(c, ' ' | ',') && !self.is_empty()),
            Key::Backspace | Key::Delete | Key::Left | Key::Right => !self.is_empty(),
            _ => false,
        };
        is_own && self.field.update(key)
    }

    fn is_empty(&self) -> bool {
        self.field.text().trim().is_empty()
    }

    /// What is typed as counts, one for each choice; `None` while nothing is.
    ///
    /// # Errors
    /// What is wrong with it, in words.
    fn counts(&self, round: &ClassRound) -> Result<Option<Vec<u32>>, String> {
        let text = self.field.text();
        let parts = text.split([' ', ',']).filter(|part| !part.is_empty());
        let counts: Vec<Option<u32>> = parts.map(|part| part.parse().ok()).collect();
        if counts.is_empty() {
            return Ok(None);
        }
        let choices = round.choices(self.question).len();
        let last = letter(choices.saturating_sub(1));
        if counts.len() != choices {
            let found = counts.len();
            return Err(format!(
                "a number for each of A to {last}: {choices} of them, not {found}"
            ));
        }
        let all = counts.into_iter().collect::<Option<Vec<u32>>>();
        let fits = |counts: &Vec<u32>| {
            let sum: u64 = counts.iter().map(|count| u64::from(*count)).sum();
            sum <= MOST_PEOPLE as u64
        };
        let all = all.filter(fits).map(Some);
        all.ok_or_else(|| format!("no more than {MOST_PEOPLE} in all"))
    }

    /// Puts what is typed into the round; says whether there is nothing to be put right first.
    pub(super) fn give(&self, session: &mut Session) -> bool {
        let counts = self.counts(session.round());
        counts.is_ok_and(|counts| {
            session.enter(&ClassChange::Count {
                question: self.question,
                vote: self.vote,
                counts,
            })
        })
    }

    /// Draws what is typed, with what is to be done.
    pub(super) fn draw(&self, round: &ClassRound, foot: Rect, buf: &mut Buffer, look: &Look) {
        let choices = round.choices(self.question).len();
        let letters: Vec<String> = (0..choices).map(|i| letter(i).to_string()).collect();
        let mut lines = Lines::new(foot, buf, *look);
        let head = format!("Count {}: {}", letters.join(" "), self.field.shown());
        let (note, role) = match self.counts(round) {
            Ok(Some(counts)) => (format!("{} in all", counts.iter().sum::<u32>()), Role::Text),
            Ok(None) => (String::new(), Role::Text),
            Err(reason) => (reason, Role::Warn),
        };
        let name = format!("Count {}", letters.join(" "));
        let recorded = |_| Words::text_field(&name, self.field.text());
        lines.clicked_as(recorded, Some(true), |lines| {
            lines.pair(&head, &note, Role::Title, role);
        });
        lines.recorded_too(|_| Words::text(Run::new(note.as_str(), role)));
        let next = match (self.vote, self.is_empty()) {
            (Vote::First, true) => "Count hands or cards, and type the numbers: 4 17 9 2",
            (Vote::Second, true) => "Count again, or Enter: all keep their vote.",
            _ => "Enter: that is the vote.",
        };
        lines.line(next, Role::Key);
    }
}

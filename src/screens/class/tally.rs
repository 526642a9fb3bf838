//! The teacher types the number of votes for each choice.

use strum::{EnumMessage, IntoStaticStr};

use super::stage::Stage;
use super::{ClassAction, question};
use crate::class::{ClassChange, ClassRound, MOST_PEOPLE, Session, Vote};
use crate::messages::Key;
use crate::quiz::{Question, letter};
use crate::screens::View;
use crate::widgets::input::{KeyTable, TextField};
use crate::widgets::panel::Panel;
use crate::widgets::panels::Heading;
use crate::widgets::{Role, draw_question};

/// The maximum number of characters that can be typed.
const LONGEST: usize = 40;

/// The counts in the example of what to type; the example has one count for each choice.
const EXAMPLE: [&str; 6] = ["4", "17", "9", "2", "5", "3"];

/// Counts that are being typed: "4 17 9 2".
#[derive(Debug, Clone)]
pub(super) struct Tally {
    vote: Vote,
    question: usize,
    field: TextField,
}

/// What the keys do while votes are being counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum CountAction {
    /// enter the counts
    Count,
}

/// The keys, except those that all steps share.
pub(super) fn keys() -> KeyTable<CountAction> {
    KeyTable::new("class").on(Key::Enter, CountAction::Count, "enter")
}

impl Tally {
    /// Begins with the earlier counts, so that they can be corrected, or with none.
    pub(super) fn new(round: &ClassRound, question: usize, vote: Vote) -> Self {
        let counts = round.tally(question, vote).unwrap_or_default();
        let counts: Vec<String> = counts.iter().map(ToString::to_string).collect();
        Self {
            vote,
            question,
            field: TextField::new(&counts.join(" "), LONGEST),
        }
    }

    /// Handles a key that edits the counts; returns whether the key was used.
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

    /// The typed counts, one per choice; `None` if nothing has been typed.
    ///
    /// # Errors
    /// What is wrong with the counts.
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
                "a number for each of A to {last}: {choices} numbers, not {found}"
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

    /// Enters the typed counts into the round; returns whether they are valid.
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

    /// The question, and below it the typed counts, with the instruction.
    pub(super) fn view<'s>(
        &'s self,
        play: &'s Stage,
        question: &'s Question,
    ) -> View<'s, ClassAction> {
        let heading = match self.vote {
            Vote::First => Heading::new(
                &["First vote", "Vote 1"],
                "Show your card, or raise your hand.",
            ),
            Vote::Second => Heading::new(
                &["Second vote", "Vote 2"],
                "Who has changed their mind? Show your card once more.",
            ),
        };
        // Until the second vote is counted, the first one is shown.
        let shown = (self.vote == Vote::Second).then_some(Vote::First);
        let mut words = play.words();
        question::write(play, question, shown, |_| None, &mut words);
        let choices = play.round().choices(self.question).len();
        let letters: Vec<String> = (0..choices).map(|i| letter(i).to_string()).collect();
        let mut foot = Panel::new("");
        let label = format!("Count {}: ", letters.join(" "));
        foot.text_field(label, self.field.around_cursor(), true, None);
        let take = ClassAction::Count(CountAction::Count);
        match (self.counts(play.round()), self.vote) {
            (Err(reason), _) => foot.line(reason, Role::Warn),
            (Ok(None), Vote::First) => {
                let example = EXAMPLE.get(..choices).unwrap_or(&EXAMPLE).join(" ");
                let words = format!("Count hands or cards, and type the numbers: {example}");
                foot.line(words, Role::Key);
            }
            (Ok(None), Vote::Second) => foot.prompt("all keep their vote", take),
            (Ok(Some(counts)), _) => {
                let all: u32 = counts.iter().sum();
                foot.prompt(format!("record these votes, {all} in all"), take);
            }
        }
        let draw = move |area, buf: &mut _, look: &_| {
            draw_question(area, buf, look, question, None);
        };
        let view = play.step_view(Some(heading), question::beside(question), draw, words);
        view.with_foot(foot)
    }
}

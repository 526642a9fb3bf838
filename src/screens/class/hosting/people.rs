//! Who is in, and who has voted: names that are shown when the teacher asks for them.

use std::cmp::Ordering;

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::{Hosting, HostingAction};
use crate::class::{ClassChange, ClassRound, LONGEST_NAME, Vote};
use crate::messages::{Key, Mouse};
use crate::screens::class::view::column;
use crate::widgets::input::{KeyTable, ListAction, ListView, TextField};
use crate::widgets::panels::draw_panel;
use crate::widgets::{Lines, Look, Outcome, Role, areas, text};

/// Rows below the names.
const FOOT: u16 = 3;

/// The page of names.
#[derive(Debug, Clone)]
pub(super) struct People {
    /// The rows in their order: those who have not voted first, those who were removed last.
    rows: Vec<Row>,
    list: ListView,
    doing: Doing,
    /// Whom the question before the teacher is about. It is answered later, and by then others
    /// may have come or gone.
    asked: Option<usize>,
    /// How many are away and never voted.
    away: usize,
}

/// A row of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Row {
    Person(usize),
    /// Somebody who was removed.
    Removed(usize),
}

/// What is being done with the one at the mark.
#[derive(Debug, Clone)]
enum Doing {
    Nothing,
    /// Another name is typed.
    Rename(TextField),
    /// Who this stranger really is, is being chosen.
    Merge(usize),
}

impl People {
    /// The page, at a step where this vote is open.
    pub(super) fn new(round: &ClassRound, vote: Option<Vote>, away: usize) -> Self {
        let mut people = Self {
            rows: Vec::new(),
            list: ListView::default(),
            doing: Doing::Nothing,
            asked: None,
            away,
        };
        people.renew(round, vote, away);
        people
    }

    /// Shows how things stand now. The mark stays at whom it was at.
    pub(super) fn renew(&mut self, round: &ClassRound, vote: Option<Vote>, away: usize) {
        let marked = self.row();
        let question = round.place().question;
        let voted = |person: &usize| {
            vote.is_some_and(|vote| round.ballot(question, *person).said(vote).is_some())
        };
        let mut people: Vec<usize> = (0..round.teams().len()).collect();
        people.sort_by_key(voted);
        let removed = (0..round.removed().count()).map(Row::Removed);
        self.rows = people.into_iter().map(Row::Person).chain(removed).collect();
        self.away = away;
        let at = self.rows.iter().position(|row| Some(*row) == marked);
        if let Some(at) = at {
            self.list.choose(at);
        }
    }

    /// Somebody is no longer on the list, and those behind have moved up.
    pub(super) fn gone(&mut self, person: usize) {
        let moved = |it: usize| match it.cmp(&person) {
            Ordering::Less => Some(it),
            Ordering::Equal => None,
            Ordering::Greater => Some(it - 1),
        };
        let is_typing = matches!(self.doing, Doing::Rename(_));
        if is_typing && self.at() == Some(person) {
            self.doing = Doing::Nothing;
        }
        if let Doing::Merge(from) = self.doing {
            self.doing = moved(from).map_or(Doing::Nothing, Doing::Merge);
        }
        self.asked = self.asked.and_then(moved);
        // The mark goes to whoever stands there next.
        let mark = self.list.chosen(self.rows.len());
        let gone_at = self.rows.iter().position(|row| *row == Row::Person(person));
        self.rows.retain_mut(|row| match row {
            Row::Person(it) => match moved(*it) {
                Some(now) => {
                    *it = now;
                    true
                }
                None => false,
            },
            Row::Removed(_) => true,
        });
        if gone_at.is_some_and(|at| at < mark) {
            self.list.choose(mark - 1);
        }
    }

    /// The row at the mark.
    fn row(&self) -> Option<Row> {
        self.rows.get(self.list.chosen(self.rows.len())).copied()
    }

    /// The one at the mark, if they are on the list.
    fn at(&self) -> Option<usize> {
        match self.row()? {
            Row::Person(person) => Some(person),
            Row::Removed(_) => None,
        }
    }

    /// The keys; `shut` is what closing or opening the door is called.
    pub(super) fn keys(&self, shut: &'static str) -> KeyTable<HostingAction> {
        use HostingAction::{Back, List, Merge, NotYet, Remove, RemoveAway, Rename, Shut};
        let keys = KeyTable::new("class");
        match &self.doing {
            Doing::Rename(_) => {
                keys.on(Key::Enter, Rename, "that is the name")
                    .on(Key::Escape, NotYet, "as it was")
            }
            Doing::Merge(_) => {
                let list = ListView::keys("this is who it is");
                keys.with(list, List).on(Key::Escape, NotYet, "as it was")
            }
            Doing::Nothing => keys
                .with(
                    ListView::keys(match self.row() {
                        Some(Row::Removed(_)) => "let in again",
                        _ => "rename",
                    }),
                    List,
                )
                .on('m', Merge, "is somebody else")
                .when(self.at().is_some() && self.rows.len() > 1)
                .on(Key::Delete, Remove, "remove")
                .or([(Key::Char('x'), Remove)])
                .when(self.at().is_some())
                .on('a', RemoveAway, "remove who is away")
                .when(self.away > 0)
                .on('c', Shut, shut)
                .on(Key::Escape, Back, "back")
                .or([(Key::Char('w'), Back)]),
        }
    }

    /// Takes a key that types; says whether it was one.
    pub(super) fn typed(&mut self, key: Key) -> bool {
        match &mut self.doing {
            Doing::Rename(field) => field.update(key),
            _ => false,
        }
    }

    /// What is asked before an action is done.
    pub(super) fn confirmation(
        &mut self,
        action: HostingAction,
        round: &ClassRound,
    ) -> Option<String> {
        self.asked = self.at();
        let name = |person: usize| round.teams().get(person).cloned().unwrap_or_default();
        match (&self.doing, action) {
            (Doing::Nothing, HostingAction::Remove) => Some(format!(
                "Take {} off the list, with all they said? They stay out until you let them in \
                 again.",
                name(self.asked?)
            )),
            (Doing::Merge(from), HostingAction::List(ListAction::Open)) => {
                let into = self.asked.filter(|into| into != from)?;
                Some(format!(
                    "{} is {}? The two become one.",
                    name(*from),
                    name(into)
                ))
            }
            _ => None,
        }
    }

    /// Does what a key stands for; gives what is to change in the round.
    pub(super) fn act(&mut self, action: HostingAction, round: &ClassRound) -> Option<ClassChange> {
        let person = self.at();
        let asked = self.asked.take();
        match (action, std::mem::replace(&mut self.doing, Doing::Nothing)) {
            (HostingAction::List(action), doing) => {
                match (self.list.act(action, self.rows.len()), doing) {
                    (Outcome::Done(_), Doing::Merge(from)) => {
                        let into = asked.filter(|into| *into != from)?;
                        return Some(ClassChange::Merge { from, into });
                    }
                    (Outcome::Done(_), _) => {
                        if let Some(Row::Removed(removed)) = self.row() {
                            return Some(ClassChange::Readmit { removed });
                        }
                        let name = round.teams().get(person?)?;
                        let field = TextField::new(name, 2 * LONGEST_NAME);
                        self.doing = Doing::Rename(field);
                    }
                    (_, doing) => self.doing = doing,
                }
                None
            }
            (HostingAction::Merge, _) => {
                self.doing = Doing::Merge(person?);
                None
            }
            (HostingAction::Rename, Doing::Rename(field)) => {
                let name = round.renamed(person?, field.text())?;
                let person = person?;
                Some(ClassChange::Rename { person, name })
            }
            (HostingAction::Remove, _) => Some(ClassChange::Remove { person: asked? }),
            _ => None,
        }
    }

    /// Where the names stand in an area, and what is said below them.
    fn places(area: Rect) -> [Rect; 2] {
        let inside = column(area).inner(Margin::new(1, 1));
        areas::upper(inside, inside.height - FOOT.min(inside.height))
    }

    /// Takes the mouse: it chooses somebody, and a second click opens the name. Says whether
    /// that was done.
    pub(super) fn mouse(&mut self, mouse: &Mouse, area: Rect) -> bool {
        let [place, _] = Self::places(area);
        let (at, count) = (self.list.chosen(self.rows.len()), self.rows.len());
        let row = ListView::line_at(place, mouse.cell(), at, count);
        let outcome = self.list.mouse(mouse, count, row);
        // Whom somebody really is, is asked once more.
        matches!((outcome, &self.doing), (Outcome::Done(_), Doing::Nothing))
    }

    /// Draws the list.
    pub(super) fn draw(
        &self,
        hosting: &Hosting,
        round: &ClassRound,
        area: Rect,
        buf: &mut Buffer,
        look: &Look,
    ) {
        let frame = column(area);
        let (present, all) = (hosting.present(), round.teams().len());
        let title = match hosting.handed_in() {
            0 => format!("{present} in, {all} on the list"),
            handed => format!("{present} in, {all} on the list, {handed} handed in"),
        };
        draw_panel(buf, frame, &title, look.charset, &look.theme);
        let [above, below] = Self::places(area);
        let at = self.list.chosen(self.rows.len());
        let first = ListView::first_shown(at, self.rows.len(), above.height);
        let mut lines = Lines::new(above, buf, *look);
        if self.rows.is_empty() {
            lines.paragraph("Nobody is in yet.", Role::Text);
        }
        let removed: Vec<&str> = round.removed().collect();
        for (i, row) in self
            .rows
            .iter()
            .enumerate()
            .skip(first)
            .take(above.height.into())
        {
            let (name, state) = match row {
                Row::Person(person) => (
                    round.teams().get(*person).map_or("", String::as_str),
                    state_of(*person, hosting, round),
                ),
                Row::Removed(removed_at) => (
                    removed.get(*removed_at).copied().unwrap_or_default(),
                    "removed".to_owned(),
                ),
            };
            let name = match &self.doing {
                Doing::Rename(field) if i == at => field.shown(),
                _ => name.to_owned(),
            };
            let room = usize::from(lines.width()).saturating_sub(text::width(&state) + 5);
            let name = text::clipped(&look.charset.text(&name), room);
            lines.choice(i == at, Role::Text, |lines, mark, role| {
                lines.pair(&format!("{mark} {name} "), &state, role, Role::Dim);
            });
        }
        let mut lines = Lines::new(below, buf, *look);
        lines.gap();
        let words = match &self.doing {
            Doing::Merge(from) => {
                let name = round.teams().get(*from).map_or("", String::as_str);
                format!("Who is \"{name}\" really? Choose, then Enter.")
            }
            Doing::Rename(_) => "Type the name, then Enter.".into(),
            Doing::Nothing if hosting.shut => "The door is closed: nobody new can come in.".into(),
            Doing::Nothing => match hosting.handed_in_where() {
                Some(folder) => format!("Handed in: carrom gather \"{folder}\" --out class.html"),
                None => String::new(),
            },
        };
        lines.paragraph(&words, Role::Key);
    }
}

/// Whether somebody has voted, has handed in and is away.
fn state_of(person: usize, hosting: &Hosting, round: &ClassRound) -> String {
    let ballot = round.ballot(round.place().question, person);
    let voted = match (ballot.first, ballot.second) {
        (_, Some(_)) => "voted again",
        (Some(_), None) => "has voted",
        (None, None) => "no vote yet",
    };
    let presence = hosting.presence.get(person);
    let handed = match presence.is_some_and(|it| it.has_handed_in) {
        true => ", handed in",
        false => "",
    };
    let away = match presence.is_some_and(|it| it.line.is_some()) {
        true => "",
        false => ", away",
    };
    format!("{voted}{handed}{away}")
}

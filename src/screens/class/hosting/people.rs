//! The list of participants and of who has voted; names are shown only on the teacher's request.

use super::{ClassAction, HostingAction};
use crate::class::{ClassChange, ClassRound, LONGEST_NAME, Participant, Session, Vote};
use crate::messages::Key;
use crate::widgets::input::{KeyTable, ListAction, ListView, TextField};
use crate::widgets::panel::Panel;
use crate::widgets::{Outcome, Role};

/// The page of names.
#[derive(Debug, Clone, Default)]
pub(in crate::screens::class) struct People {
    list: ListView,
    /// The marked row.
    marked: Option<PersonRow>,
    doing: PersonEdit,
    /// The participant whom the open confirmation is about. Other participants may join or leave
    /// before the teacher answers.
    asked: Option<String>,
}

/// A row of the list, identified by the participant's name, which is unique.
#[derive(Debug, Clone, PartialEq, Eq)]
enum PersonRow {
    Person(String),
    Removed(String),
}

/// The action in progress on a participant.
#[derive(Debug, Clone, Default)]
enum PersonEdit {
    #[default]
    Nothing,
    /// A new name is being typed.
    Rename(String, TextField),
    /// The teacher is choosing who this participant really is.
    Merge(String),
}

/// The rows in order: first those who have not voted, last those who were removed.
fn rows(session: &Session) -> Vec<PersonRow> {
    let round = session.round();
    let question = round.place().question;
    let voted = |it: &&Participant| {
        let open = session.open_vote();
        open.is_some_and(|vote| it.ballot(question).said(vote).is_some())
    };
    let mut people: Vec<_> = round.participants().iter().collect();
    people.sort_by_key(voted);
    let people = people.iter().map(|it| PersonRow::Person(it.name().into()));
    let removed = round.removed().map(|name| PersonRow::Removed(name.into()));
    people.chain(removed).collect()
}

fn number(session: &Session, name: &str) -> Option<usize> {
    let mut all = session.round().participants().iter();
    all.position(|it| it.name() == name)
}

impl People {
    /// The page for the current state of the session.
    pub(super) fn new(session: &Session) -> Self {
        let mut people = Self::default();
        people.renew(session);
        people
    }

    /// Keeps the mark on the same row; if that row is gone, the mark moves to the next one, or to
    /// the last.
    pub(super) fn renew(&mut self, session: &Session) {
        let rows = rows(session);
        let marked = self.marked.as_ref();
        if let Some(at) = rows.iter().position(|row| Some(row) == marked) {
            self.list.choose(at);
        }
        self.marked = rows.get(self.list.chosen(rows.len())).cloned();
        let gone = match &self.doing {
            PersonEdit::Rename(name, _) | PersonEdit::Merge(name) => {
                number(session, name).is_none()
            }
            PersonEdit::Nothing => false,
        };
        if gone {
            self.doing = PersonEdit::Nothing;
        }
    }

    /// The marked participant, unless they have been removed.
    fn at(&self) -> Option<&str> {
        match self.marked.as_ref()? {
            PersonRow::Person(name) => Some(name),
            PersonRow::Removed(_) => None,
        }
    }

    /// The keys; `shut` is the label for closing or opening the round.
    pub(super) fn keys(&self, session: &Session, shut: &'static str) -> KeyTable<HostingAction> {
        use HostingAction::{Back, List, Merge, NotYet, Remove, RemoveAway, Rename, Shut};
        let keys = KeyTable::new("class");
        match &self.doing {
            PersonEdit::Rename(..) => {
                keys.on(Key::Enter, Rename, "use this name")
                    .on(Key::Escape, NotYet, "cancel")
            }
            PersonEdit::Merge(_) => {
                let list = ListView::keys("same person");
                keys.with(list, List).on(Key::Escape, NotYet, "cancel")
            }
            PersonEdit::Nothing => keys
                .with(
                    ListView::keys(match self.marked {
                        Some(PersonRow::Removed(_)) => "let in again",
                        _ => "rename",
                    }),
                    List,
                )
                .on('m', Merge, "joined twice")
                .when(self.at().is_some() && rows(session).len() > 1)
                .on(Key::Delete, Remove, "remove")
                .or([(Key::Char('x'), Remove)])
                .when(self.at().is_some())
                .on('a', RemoveAway, "remove absentees")
                .when(!session.away().is_empty())
                .on('c', Shut, shut)
                .on(Key::Escape, Back, "back")
                .or([(Key::Char('w'), Back)]),
        }
    }

    /// Handles a key that edits text; returns whether the key was used.
    pub(super) fn typed(&mut self, key: Key) -> bool {
        match &mut self.doing {
            PersonEdit::Rename(_, field) => field.update(key),
            _ => false,
        }
    }

    /// The question before an action.
    pub(super) fn confirmation(
        &mut self,
        action: HostingAction,
        session: &Session,
    ) -> Option<String> {
        let opens = match action {
            HostingAction::List(ListAction::Open) => true,
            // A second click opens the row.
            HostingAction::List(ListAction::Point(at)) => {
                self.marked.is_some() && rows(session).get(at) == self.marked.as_ref()
            }
            _ => false,
        };
        self.asked = self.at().map(str::to_owned);
        let asked = self.asked.as_ref();
        match (&self.doing, action) {
            (_, HostingAction::RemoveAway) => {
                let away = session.away().len();
                Some(format!(
                    "Remove everyone who is away and has no vote ({away})? They can join again."
                ))
            }
            (PersonEdit::Nothing, HostingAction::Remove) => Some(format!(
                "Remove {} with all their votes? They stay out until you let them in \
                 again.",
                asked?
            )),
            (PersonEdit::Merge(from), _) if opens => {
                let into = asked.filter(|into| *into != from)?;
                Some(format!(
                    "Merge {from} into {into}? They become one participant."
                ))
            }
            _ => None,
        }
    }

    /// Carries out an action; returns the change to the round.
    pub(super) fn act(&mut self, action: HostingAction, session: &Session) -> Option<ClassChange> {
        let asked = self.asked.take().and_then(|name| number(session, &name));
        match (action, std::mem::take(&mut self.doing)) {
            (HostingAction::List(action), doing) => {
                let rows = rows(session);
                let outcome = self.list.act(action, rows.len());
                self.marked = rows.get(self.list.chosen(rows.len())).cloned();
                match (outcome, doing) {
                    (Outcome::Done(_), PersonEdit::Merge(from)) => {
                        let into = asked?;
                        let from = number(session, &from).filter(|from| *from != into)?;
                        return Some(ClassChange::Merge { from, into });
                    }
                    (Outcome::Done(_), _) => match self.marked.as_ref()? {
                        PersonRow::Removed(name) => {
                            let removed = session.round().removed().position(|it| it == name)?;
                            return Some(ClassChange::Readmit { removed });
                        }
                        PersonRow::Person(name) => {
                            let field = TextField::new(name, 2 * LONGEST_NAME);
                            self.doing = PersonEdit::Rename(name.clone(), field);
                        }
                    },
                    (_, doing) => self.doing = doing,
                }
                None
            }
            (HostingAction::Merge, _) => {
                self.doing = PersonEdit::Merge(self.at()?.to_owned());
                None
            }
            (HostingAction::Rename, PersonEdit::Rename(old, field)) => {
                let person = number(session, &old)?;
                let name = session.round().renamed(person, field.text())?;
                self.marked = Some(PersonRow::Person(name.clone()));
                Some(ClassChange::Rename { person, name })
            }
            (HostingAction::Remove, _) => Some(ClassChange::Remove { person: asked? }),
            _ => None,
        }
    }

    /// The list of participants.
    pub(super) fn panel(&self, session: &Session) -> Panel<ClassAction> {
        let round = session.round();
        let (present, all) = (session.present(), round.participants().len());
        let mut panel = Panel::new(match session.handed_in() {
            0 => format!("{present} in, {all} on the list"),
            handed => format!("{present} in, {all} on the list, {handed} handed in"),
        });
        let words = match &self.doing {
            PersonEdit::Merge(from) => format!("Who is \"{from}\" really? Choose the name."),
            PersonEdit::Rename(..) => "Type the name.".into(),
            PersonEdit::Nothing if session.is_shut() => {
                "The round is closed: nobody new can join.".into()
            }
            PersonEdit::Nothing => match session.handed_in_where() {
                Some(folder) => format!("Handed in: carrom gather \"{folder}\" --out class.html"),
                None => String::new(),
            },
        };
        if !words.is_empty() {
            panel.paragraph(words, Role::Key);
            panel.gap();
            panel.pin();
        }
        let rows = rows(session);
        if rows.is_empty() {
            panel.paragraph("Nobody has joined yet.", Role::Text);
        }
        for (at, row) in rows.iter().enumerate() {
            let chosen = self.marked.as_ref() == Some(row);
            let (name, state) = match row {
                PersonRow::Person(name) => {
                    let one = number(session, name).and_then(|it| round.participants().get(it));
                    (name, one.map(|it| state_of(it, round)).unwrap_or_default())
                }
                PersonRow::Removed(name) => (name, "removed".to_owned()),
            };
            match &self.doing {
                PersonEdit::Rename(_, field) if chosen => {
                    panel.text_field("name", field.around_cursor(), true, None);
                }
                _ => {
                    let action = HostingAction::List(ListAction::Point(at));
                    let action = ClassAction::Hosting(action);
                    panel.row((name, Role::Text), (state, Role::Dim), chosen, action);
                }
            }
        }
        panel
    }
}

/// The state of a participant, in words: the vote, and whether they have handed in or are away.
fn state_of(one: &Participant, round: &ClassRound) -> String {
    let ballot = one.ballot(round.place().question);
    let voted = match Vote::BOTH.map(|vote| ballot.vote(vote)) {
        [_, Some(_)] => "voted again",
        [Some(_), None] => "has voted",
        [None, None] => "no vote yet",
    };
    let handed = if one.has_handed_in() {
        ", handed in"
    } else {
        ""
    };
    let away = if one.is_present() { "" } else { ", away" };
    format!("{voted}{handed}{away}")
}

//! The pages about pupils on their own devices: how to join, and who has joined.

mod joining;
mod people;
mod qr;

use strum::{EnumMessage, IntoStaticStr};

use super::ClassAction;
use crate::class::Session;
use crate::messages::Key;
use crate::screens::{Context, View};
use crate::widgets::input::{KeyTable, ListAction};
use people::People;

/// What the keys do on the pages about pupils on their own devices.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum HostingAction {
    /// show how to join: the address and the code
    #[strum(serialize = "door")]
    Joining,
    /// show who has joined, and who has voted
    Names,
    /// continue the round
    GoOn,
    /// close the round to newcomers, or open it again
    Shut,
    /// choose a pupil
    List(ListAction),
    /// change the name
    Rename,
    /// merge a pupil who joined twice
    Merge,
    /// remove this pupil
    Remove,
    /// remove everyone who is away and has no vote
    RemoveAway,
    /// go back to the previous page
    Back,
    /// cancel
    NotYet,
}

/// A page about pupils on their own devices.
#[derive(Debug, Clone)]
pub(super) enum HostPage {
    /// How to join.
    Joining,
    People(People),
}

/// The keys that are available at every step.
pub(super) fn step_keys() -> KeyTable<HostingAction> {
    KeyTable::new("class")
        .on('j', HostingAction::Joining, "how to join")
        .on('w', HostingAction::Names, "who is in")
}

impl HostPage {
    pub(super) fn keys(&self, session: &Session) -> KeyTable<HostingAction> {
        use HostingAction::{GoOn, Joining, Names, Shut};
        let shut = match session.is_shut() {
            true => "let them in",
            false => "no newcomers",
        };
        match self {
            Self::Joining => KeyTable::new("class")
                .on(Key::Enter, GoOn, "back to the round")
                .or([(Key::Char(' '), GoOn), (Key::Char('j'), GoOn)])
                .on('w', Names, "who is in")
                .on('c', Shut, shut),
            Self::People(people) => {
                let keys = people.keys(session, shut);
                keys.or([(Key::Char('j'), Joining)])
            }
        }
    }

    /// Handles a key that edits text; returns whether the key was used.
    pub(super) fn typed(&mut self, key: Key) -> bool {
        match self {
            Self::People(people) => people.typed(key),
            Self::Joining => false,
        }
    }

    /// The question before an action that cannot be undone.
    pub(super) fn confirmation(
        &mut self,
        action: HostingAction,
        session: &Session,
    ) -> Option<String> {
        match self {
            Self::People(people) => people.confirmation(action, session),
            Self::Joining => None,
        }
    }

    /// Carries out an action; returns the page to show next.
    pub(super) fn act(
        page: Option<Self>,
        action: HostingAction,
        session: &mut Session,
    ) -> Option<Self> {
        match (action, page) {
            (HostingAction::Joining, _) => Some(Self::Joining),
            (HostingAction::Names, _) => Some(Self::People(People::new(session))),
            (HostingAction::GoOn, Some(_)) => {
                session.begin();
                None
            }
            (HostingAction::Back, _) => session.gathers().then_some(Self::Joining),
            (HostingAction::Shut, page) => {
                session.turn_key();
                page
            }
            (HostingAction::RemoveAway, page) => {
                session.remove_away();
                page
            }
            (action, Some(Self::People(mut people))) => {
                if let Some(change) = people.act(action, session) {
                    session.edit_people(&change);
                }
                Some(Self::People(people))
            }
            (_, page) => page,
        }
    }

    /// Updates the page to the current state.
    pub(super) fn renew(&mut self, session: &Session) {
        if let Self::People(people) = self {
            people.renew(session);
        }
    }

    pub(super) fn view<'s>(&'s self, session: &'s Session, cx: &Context) -> View<'s, ClassAction> {
        match self {
            Self::Joining => joining::view(session, cx),
            Self::People(people) => View::text(people.panel(session)),
        }
    }
}

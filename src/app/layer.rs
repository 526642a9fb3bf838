//! The layers that can cover a screen: its help page, a notice or a question.

use strum::{EnumMessage, IntoStaticStr};

use crate::game::Rules;
use crate::messages::Key;
use crate::screens::Confirmation;
use crate::widgets::Outcome;
use crate::widgets::input::{KeyTable, Rebound};

#[derive(Debug, Clone)]
pub(super) enum AppLayer {
    /// The page that explains the screen.
    Help {
        /// How far the page has been scrolled, in lines.
        scrolled: u16,
        /// The rules of the game that is on the screen.
        rules: Option<Rules>,
    },
    /// A notice, which is shown until a key is pressed.
    Notice(String),
    Confirm(Confirmation),
    /// Asks whether to leave even though something has not been saved yet.
    Leave(Confirmation),
}

/// What the keys do in a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(super) enum LayerAction {
    /// scroll
    Scroll(i16),
    /// look up a term in the glossary
    Glossary,
    /// read the rules of the game
    Rules(Rules),
    /// agree
    Agree,
    /// decline
    Decline,
}

impl AppLayer {
    /// The keys for the layer. Any other key closes the layer, unless the layer is a question.
    pub(super) fn keys(&self, rebound: &Rebound) -> KeyTable<LayerAction> {
        use LayerAction::{Agree, Decline, Glossary, Rules, Scroll};
        let table = KeyTable::new("layer");
        let table = match self {
            Self::Notice(_) => table,
            Self::Help { rules, .. } => table
                .each([(Key::Up, Scroll(-1)), (Key::Down, Scroll(1))], "scroll")
                .or([(Key::PageUp, Scroll(-10)), (Key::PageDown, Scroll(10))])
                .each(rules.map(|rules| ('r', Rules(rules))), "rules")
                .on(Key::Char('g'), Glossary, "glossary"),
            Self::Confirm(question) | Self::Leave(question) => table
                .on(Key::Char('y'), Agree, question.yes)
                .or([(Key::Enter, Agree)])
                .on(Key::Char('n'), Decline, question.no)
                .or([(Key::Escape, Decline)]),
        };
        table.rebound(rebound)
    }

    /// Handles a key; if the key closes the layer, returns `Done` with the key's action, if it has
    /// one. `most` is the number of lines by which a help page can be scrolled.
    pub(super) fn press(
        &mut self,
        key: Key,
        most: u16,
        rebound: &Rebound,
    ) -> Outcome<Option<LayerAction>> {
        let action = self.keys(rebound).find(key);
        match (self, action) {
            (Self::Help { scrolled, .. }, Some(LayerAction::Scroll(by))) => {
                *scrolled = scrolled.saturating_add_signed(by).min(most);
                Outcome::Used
            }
            (Self::Confirm(_) | Self::Leave(_), None) => Outcome::Used,
            _ => Outcome::Done(action),
        }
    }
}

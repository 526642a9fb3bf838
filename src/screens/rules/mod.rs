//! The page of rules.

use strum::{EnumMessage, IntoStaticStr};

use super::{Context, Next, Route, Screen, View};
use crate::game::{RuleLine, Rules};
use crate::messages::Key;
use crate::widgets::Role;
use crate::widgets::input::KeyTable;
use crate::widgets::panel::Panel;

/// What the keys do on the page of rules.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum RulesAction {
    /// read another set of rules
    Show(Rules),
    /// scroll the rules
    Scroll(i16),
    /// go back
    Leave,
}

/// The page with one set of rules.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RulesScreen {
    pub(crate) rules: Rules,
}

impl Screen for RulesScreen {
    type Action = RulesAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "rules";

    fn route(&self, _cx: &Context) -> Route {
        Route::Rules(self.rules)
    }

    fn keys(&self, _cx: &Context) -> KeyTable<RulesAction> {
        use RulesAction::{Leave, Scroll, Show};
        let [before, after] = [Rules::ALL.len() - 1, 1]
            .map(|step| Rules::ALL[(self.rules as usize + step) % Rules::ALL.len()]);
        KeyTable::new("rules")
            .each([(Key::Up, Scroll(-1)), (Key::Down, Scroll(1))], "scroll")
            .each(
                [(Key::Right, Show(after)), (Key::Left, Show(before))],
                "other rules",
            )
            .on(Key::Escape, Leave, "back")
    }

    fn act(&mut self, action: RulesAction, _cx: &mut Context) -> Next {
        match action {
            RulesAction::Show(rules) => self.rules = rules,
            RulesAction::Scroll(rows) => return Next::scroll(rows),
            RulesAction::Leave => return Next::Back,
        }
        Next::Stay
    }

    fn view<'s>(&'s self, _cx: &'s Context) -> View<'s, RulesAction> {
        let name = <&str>::from(self.rules);
        let mut panel = Panel::new(format!("the rules: {name}"));
        panel.from_top = true;
        for line in self.rules.page() {
            match line {
                RuleLine::Heading(heading) => {
                    panel.gap();
                    panel.heading(heading);
                }
                RuleLine::Rule(rule) => panel.item(rule, Role::Text),
            }
        }
        panel.gap();
        for rules in Rules::ALL.into_iter().filter(|rules| *rules != self.rules) {
            let prompt = match rules {
                Rules::Solo => "the rules of the board of the day".into(),
                rules => format!("the {} rules", <&str>::from(rules)),
            };
            panel.prompt(prompt, RulesAction::Show(rules));
        }
        View::text(panel)
    }
}

//! The view of the home screen.

use super::suggestion::{Suggestion, is_new};
use super::{ENTRIES, Home, HomeAction, LAB, LEARN};
use crate::screens::{Context, View};
use crate::widgets::input::ListAction;
use crate::widgets::panel::Panel;
use crate::widgets::{Role, Room, SplitLayout};

const MENU: u16 = 42;
/// The width of the menu without the descriptions.
const NARROW: u16 = 31;
const WIDE: u16 = 78;

fn layout(room: Room) -> SplitLayout {
    let menu = match room.area.width < WIDE {
        true => NARROW,
        false => MENU,
    };
    SplitLayout::with_open_panel(room, menu)
}

pub(super) fn view<'s>(home: &'s Home, cx: &Context) -> View<'s, HomeAction> {
    let hit = |area| home.picture.picture(area);
    View::drawn("a glancing hit", hit, menu(home, cx)).laid_out(layout)
}

fn menu(home: &Home, cx: &Context) -> Panel<HomeAction> {
    let suggestions = home.suggestions(cx);
    let chosen = home.list.chosen(suggestions.len() + ENTRIES.len());
    let mut panel = Panel::new("");
    panel.line("Aim. Predict where both go.", Role::Text);
    panel.line("Then watch, and read why.", Role::Text);
    panel.gap();
    let point = |line| HomeAction::List(ListAction::Point(line));
    for (line, it) in suggestions.iter().enumerate() {
        let style = (Role::Key, line == chosen);
        panel.entry(it.key(), (it.text(), ""), style, point(line));
    }
    panel.gap();
    for (line, (letter, name, about, _)) in (suggestions.len()..).zip(&ENTRIES) {
        let style = (Role::Text, line == chosen);
        panel.entry(*letter, (*name, *about), style, point(line));
        // Suggestions arrive later, and nothing should move when they do.
        if home.history.is_known() {
            panel.worth(1, Panel::gap);
        }
    }
    if is_new(&home.history, &cx.book) {
        first_steps(&suggestions, &mut panel);
    }
    panel
}

/// The first steps for a new player.
fn first_steps(suggestions: &[Suggestion], panel: &mut Panel<HomeAction>) {
    let find_out = { suggestions.iter() }.position(|it| *it == Suggestion::FindOut);
    panel.worth(3, |panel| {
        panel.gap();
        let first = "New here? Begin in the lab: predict where both will go, and watch";
        panel.prompt(first, HomeAction::Open(LAB));
    });
    panel.worth(2, |panel| {
        if let Some(find_out) = find_out {
            let second = "then find out what you believe";
            panel.prompt(second, HomeAction::Suggested(find_out));
        }
        panel.prompt("and read the suggested chapter", HomeAction::Open(LEARN));
    });
}

//! The view of the home screen.

use super::{ENTRIES, Home, HomeAction, HomeLine};
use crate::screens::{Context, View};
use crate::widgets::input::ListAction;
use crate::widgets::panel::Panel;
use crate::widgets::{Role, Room, SplitLayout};

const MENU: u16 = 42;
/// The width of the menu without the descriptions.
const NARROW: u16 = 31;
const WIDE: u16 = 78;

fn layout(room: Room) -> SplitLayout {
    let menu = if room.area.width < WIDE { NARROW } else { MENU };
    SplitLayout::with_open_panel(room, menu)
}

pub(super) fn view<'s>(home: &'s Home, cx: &Context) -> View<'s, HomeAction> {
    let hit = |area| home.picture.picture(area);
    View::drawn("a glancing hit", hit, menu(home, cx)).laid_out(layout)
}

fn menu(home: &Home, cx: &Context) -> Panel<HomeAction> {
    let lines = home.lines(cx);
    let chosen = home.list.chosen(lines.len());
    let mut panel = Panel::new("");
    panel.worth(2, |panel| {
        panel.line("Aim. Predict where both go.", Role::Text);
        panel.line("Then watch, and read why.", Role::Text);
        panel.gap();
    });
    for (at, line) in lines.into_iter().enumerate() {
        let point = HomeAction::List(ListAction::Point(at));
        let style = |role| (role, at == chosen);
        match line {
            HomeLine::Class => {
                panel.entry('j', ("Back to your class", ""), style(Role::Key), point);
                panel.gap();
            }
            HomeLine::Next => {
                if let Some(next) = home.ahead.step() {
                    panel.entry('n', (&*next.words, ""), style(Role::Key), point);
                    panel.paragraph(&next.why, Role::Dim);
                    panel.gap();
                }
            }
            HomeLine::Entry(entry) => {
                let (letter, name, about, _) = &ENTRIES[entry];
                panel.entry(*letter, (*name, *about), style(Role::Text), point);
            }
        }
    }
    panel.worth(1, |panel| {
        panel.gap();
        home.ahead.write_done(panel);
    });
    panel
}

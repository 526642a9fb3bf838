//! The view of the list of levels.

use super::LevelsAction;
use crate::levels::{Level, Shelf};
use crate::numbers::counted;
use crate::screens::View;
use crate::screens::levels::words;
use crate::widgets::input::ListAction;
use crate::widgets::panel::Panel;
use crate::widgets::{Role, Room, SplitLayout};

/// The mark beside the level to win next.
const NEXT: &str = "next";
/// The width of the panel on a narrow screen, where the titles need the room.
const NARROW_PANEL: u16 = 24;

/// The areas of the list and of the panel.
fn layout(room: Room) -> SplitLayout {
    if room.area.width < 80 {
        SplitLayout::with_panel(room, NARROW_PANEL)
    } else {
        SplitLayout::new(room)
    }
}

/// The list, and the description of the chosen level.
pub(super) fn view<'s>(shelf: &Shelf) -> View<'s, LevelsAction> {
    let at = shelf.at.checked_sub(shelf.count());
    let problem = at.and_then(|i| shelf.library().problems.get(i));
    let about = if let Some(problem) = problem {
        let mut panel = Panel::new("what is wrong");
        panel.paragraph(problem.to_string(), Role::Warn);
        panel.gap();
        panel.paragraph("The other levels can still be played.", Role::Text);
        panel
    } else if let Some((_, level)) = shelf.get(shelf.at) {
        about(level, shelf.stars(shelf.at))
    } else {
        let mut panel = Panel::new("the level");
        panel.paragraph("There are no levels here.", Role::Text);
        panel
    };
    View::panels(list(shelf), about).laid_out(layout)
}

/// All levels, grouped by pack, followed by the files that were left out.
fn list(shelf: &Shelf) -> Panel<LevelsAction> {
    let mut panel = Panel::new("levels");
    let mut number = 0;
    for pack in &shelf.library().packs {
        let members = number..number + pack.levels.len();
        let won = members.clone().filter(|n| shelf.stars(*n) > 0).count();
        panel.gap();
        let count = pack.levels.len();
        panel.heading(format!("{}: {won} of {count} won", pack.title()));
        number = members.end;
        members.for_each(|at| choice(shelf, at, &mut panel));
    }
    let problems = shelf.library().problems.len();
    if problems > 0 {
        panel.gap();
        panel.heading(format!("left out: {}", counted(problems, "file")));
        (number..number + problems).for_each(|at| choice(shelf, at, &mut panel));
    }
    panel
}

/// The line of a level or a problem.
fn choice(shelf: &Shelf, at: usize, panel: &mut Panel<LevelsAction>) {
    let action = LevelsAction::List(ListAction::Point(at));
    let chosen = at == shelf.at;
    let Some((_, level)) = shelf.get(at) else {
        let problem = shelf.library().problems.get(at - shelf.count());
        let path = problem.map_or("", |problem| &problem.file);
        let file = path.rsplit(['/', '\\']).next().unwrap_or_default();
        let file = file.escape_debug().to_string();
        return panel.row((file, Role::Warn), ("", Role::Warn), chosen, action);
    };
    let side = match shelf.stars(at) {
        0 if shelf.next() == Some(at) => NEXT.to_owned(),
        0 => String::new(),
        stars => words::stars(stars),
    };
    let name = format!("{} {}", at + 1, level.title);
    panel.row((name, Role::Text), (side, Role::Key), chosen, action);
}

/// The description of a level.
fn about(level: &Level, stars: u8) -> Panel<LevelsAction> {
    let mut panel = Panel::new("the level");
    panel.paragraph(&level.title, Role::Title);
    if stars > 0 {
        panel.line(words::stars(stars), Role::Good);
    }
    panel.gap();
    for goal in &level.goals {
        panel.paragraph(goal.describe(&level.scene), Role::Text);
    }
    panel.gap();
    let dials = level.adjust.dials();
    let dials = dials.map(|(dial, _)| words::dial_words(dial).0);
    let dials = dials.collect::<Vec<_>>().join(", ");
    panel.paragraph(format!("You set: {dials}."), Role::Dim);
    panel.gap();
    panel.prompt("play it", LevelsAction::List(ListAction::Open));
    panel.prompt("the board of the day", LevelsAction::Board);
    panel
}

//! The view of the set-up page.

use std::collections::BTreeSet;

use super::ClassAction;
use super::set_up::{RoundKind, SetUp, SetUpAction, SetUpRow};
use crate::class::{MOST_TEAMS, WayOfVoting};
use crate::quiz::CourseKind;
use crate::screens::View;
use crate::screens::view::WIDEST;
use crate::widgets::input::{ListAction, TextField};
use crate::widgets::panel::Panel;
use crate::widgets::{Role, Room, SplitLayout, areas};

/// Two panels of the same width.
fn halves(room: Room) -> SplitLayout {
    let area = areas::middle(room.area, WIDEST);
    SplitLayout::with_panel(Room { area, ..room }, area.width / 2)
}

/// The teams with the ways to start, and the kinds of round.
pub(super) fn view(set_up: &SetUp) -> View<'_, ClassAction> {
    let mut teams = Panel::new(format!("teams, 1 to {MOST_TEAMS}"));
    let mut round = Panel::new("the questions");
    for (at, row) in set_up.rows().into_iter().enumerate() {
        let action = SetUpAction::List(ListAction::Point(at));
        let panel = match row {
            SetUpRow::Kind(_) => &mut round,
            _ => &mut teams,
        };
        panel.part(ClassAction::SetUp, |panel| {
            write(set_up, row, action, panel);
        });
    }
    if set_up.can_preview() {
        round.gap();
        round.prompt(
            "see the questions",
            ClassAction::SetUp(SetUpAction::Preview),
        );
    }
    if let Some(trouble) = &set_up.trouble {
        teams.gap();
        teams.paragraph(trouble, Role::Warn);
    }
    View::panels(teams, round).laid_out(halves)
}

fn write(set_up: &SetUp, row: SetUpRow, action: SetUpAction, panel: &mut Panel<SetUpAction>) {
    let chosen = row == set_up.at();
    let around = |field: &TextField| {
        let shown = |text: &str| text.chars().filter(|c| !c.is_control()).collect::<String>();
        let (before, after) = match chosen {
            true => field.around_cursor(),
            false => (field.text(), ""),
        };
        (shown(before), shown(after))
    };
    let mut typed = |label: &str, field: Option<&TextField>| {
        let (before, after) = field.map(around).unwrap_or_default();
        panel.text_field(label, (&before, &after), chosen, Some(action));
    };
    let (name, side) = match row {
        SetUpRow::Team(team) => {
            return typed(&format!("team {}", team + 1), set_up.teams.get(team));
        }
        SetUpRow::Add => return typed("add a team: type its name", None),
        SetUpRow::Class if set_up.class.text().is_empty() => {
            return typed("class name in exports: none", None);
        }
        SetUpRow::Class => return typed("class", Some(&set_up.class)),
        SetUpRow::Kind(kind) => {
            let sign = if set_up.kind == kind { '●' } else { '○' };
            let (name, about) = words(set_up, kind, chosen);
            let name = format!("{sign} {name}");
            match kind {
                RoundKind::Code => typed(&format!("{name}: "), Some(&set_up.code)),
                _ => panel.row((name, Role::Text), ("", Role::Dim), chosen, action),
            }
            return panel.marked("    ", about, Role::Dim);
        }
        SetUpRow::Nicknames => {
            let state = if set_up.nicknames { "on" } else { "off" };
            ("nicknames given automatically", state)
        }
        SetUpRow::Start(WayOfVoting::Teams) => {
            panel.gap();
            ("Start with these teams", "")
        }
        SetUpRow::Start(WayOfVoting::Tally) => ("Start with hands or cards", ""),
        SetUpRow::Start(WayOfVoting::Devices) => ("Start on pupils' own devices", ""),
        SetUpRow::Earlier => ("Resume an earlier round", ""),
    };
    panel.row((name, Role::Text), (side, Role::Dim), chosen, action);
}

/// The name and description of a kind of round.
fn words(set_up: &SetUp, kind: RoundKind, chosen: bool) -> (String, String) {
    let course = set_up.course(kind);
    let count = course.as_ref().map_or(0, CourseKind::length);
    let name = course.as_ref().map_or("", CourseKind::name);
    match kind {
        RoundKind::Mixed | RoundKind::Quick => {
            (name.into(), format!("{count} questions, all kinds mixed"))
        }
        RoundKind::Hits => (name.into(), format!("{count} questions, where to?")),
        RoundKind::Topic => {
            let name = match chosen {
                true => format!("< {name} >"),
                false => name.into(),
            };
            (format!("one topic, {count} questions"), name)
        }
        RoundKind::Own => {
            let count = set_up.own.concepts.len();
            // A file can have several errors.
            let problems = set_up.own.problems.iter();
            let files: BTreeSet<&str> = problems.map(|it| it.file.as_str()).collect();
            let left = match files.len() {
                0 => String::new(),
                1 => ", one file left out".into(),
                left => format!(", {left} files left out"),
            };
            (name.into(), format!("of {count}{left}"))
        }
        RoundKind::Code => ("by its code".into(), "such as mixed-7".into()),
    }
}

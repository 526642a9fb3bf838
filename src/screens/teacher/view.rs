//! The view of the screen for teachers.

use super::{SHEETS, Teacher, TeacherAction, TeacherTask};
use crate::messages::HandInFolder;
use crate::numbers::{capital, counted};
use crate::paper::guide::GUIDES;
use crate::progress::long_day;
use crate::screens::View;
use crate::screens::view::WIDEST;
use crate::widgets::input::ListAction;
use crate::widgets::panel::Panel;
use crate::widgets::{Role, Room, SplitLayout, areas};

impl HandInFolder {
    const fn name(self) -> &'static str {
        match self {
            Self::Devices => "handed in to this computer",
            Self::Here => "the folder of the program",
            Self::Downloads => "Downloads",
            Self::Documents => "Documents",
            Self::Desktop => "Desktop",
        }
    }
}

/// The width of the list, in columns.
const LIST: u16 = 36;

/// The list, and a wider panel with room for the paths of the files.
fn layout(room: Room) -> SplitLayout {
    let area = areas::middle(room.area, WIDEST);
    SplitLayout::with_panel(Room { area, ..room }, area.width.saturating_sub(LIST))
}

pub(super) fn view(teacher: &Teacher) -> View<'_, TeacherAction> {
    let mut list = Panel::new("for teachers");
    for (at, task) in TeacherTask::ALL.iter().copied().enumerate() {
        let action = TeacherAction::List(ListAction::Point(at));
        let name = (task.name(), Role::Text);
        list.row(name, ("", Role::Dim), task == teacher.task(), action);
    }
    let mut panel = Panel::new("what it is");
    let task = teacher.task();
    panel.heading(task.name());
    panel.paragraph(task.about(), Role::Text);
    panel.gap();
    write_choice(teacher, &mut panel);
    if teacher.can_change() {
        panel.prompt("another", TeacherAction::Change(1));
    }
    let is_possible = task != TeacherTask::Report || teacher.chosen_round().is_some();
    if is_possible {
        let words = match task {
            TeacherTask::Class => "set it up",
            _ => "write it",
        };
        panel.prompt(words, TeacherAction::List(ListAction::Open));
    }
    if !teacher.written.is_empty() {
        panel.gap();
    }
    for (words, role) in &teacher.written {
        panel.paragraph(words, *role);
    }
    View::panels(list, panel).laid_out(layout)
}

/// Writes the values that the teacher can set for the chosen task.
fn write_choice(teacher: &Teacher, panel: &mut Panel<TeacherAction>) {
    match teacher.task() {
        TeacherTask::Class | TeacherTask::Page => {}
        TeacherTask::Worksheet | TeacherTask::Moodle | TeacherTask::Scorm => {
            panel.text_field("code", teacher.code.around_cursor(), true, None);
            match &teacher.refused {
                Some(reason) => panel.paragraph(format!("The code: {reason}."), Role::Warn),
                None => panel.paragraph(
                    "even12-7: 12 questions about everything. speeds-7: one topic. The help \
                     explains codes.",
                    Role::Dim,
                ),
            }
        }
        TeacherTask::Cards => {
            let sheets = counted(SHEETS[teacher.picked()].into(), "sheet");
            panel.fact("for the class", sheets);
        }
        TeacherTask::Gradebook => {
            panel.fact("files", HandInFolder::ALL[teacher.picked()].name());
        }
        TeacherTask::Guide => {
            let guide = &GUIDES[teacher.picked()];
            panel.fact(guide.name, "");
            panel.paragraph(capital(guide.about), Role::Dim);
        }
        TeacherTask::Report => match teacher.chosen_round() {
            None => panel.paragraph(
                "There is no saved round yet: first play one with your class.",
                Role::Dim,
            ),
            Some((round, day)) => {
                let class = match round.class() {
                    "" => "without a name",
                    class => class,
                };
                panel.fact("class", class);
                panel.fact("round", round.code().to_string());
                if let Some(day) = day {
                    panel.fact("day", long_day(*day));
                }
            }
        },
    }
}

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

impl TeacherTask {
    const fn name(self) -> &'static str {
        match self {
            Self::Class => "A round with a class",
            Self::Worksheet => "Worksheet with its key",
            Self::Cards => "Voting cards",
            Self::Moodle => "Questions for Moodle",
            Self::Scorm => "Round for a learning platform",
            Self::Report => "Report of a class round",
            Self::Gradebook => "Gradebook",
            Self::Page => "carrom as one file for browsers",
            Self::Guide => "Guides",
        }
    }

    const fn about(self) -> &'static str {
        match self {
            Self::Class => {
                "Teams at one keyboard, raised hands, paper cards, or each pupil on a device of \
                 their own. No internet is needed."
            }
            Self::Worksheet => {
                "Two HTML files to print: the questions with space for answers, and the worked \
                 solutions with the wrong answers to listen for. The code fixes the questions; the \
                 same code opens them on a screen."
            }
            Self::Cards => {
                "Cards A to D for pupils to vote with, one sheet for each pupil, folded twice. An \
                 HTML file to print."
            }
            Self::Moodle => {
                "The questions of a round for Moodle's question bank, with pictures, and feedback \
                 for each misconception. In Moodle: Question bank, Import, Moodle XML format."
            }
            Self::Scorm => {
                "A SCORM 1.2 package, a ZIP file to upload. The platform opens the round for each pupil and \
                 receives the score, the time and each answer. In Moodle: Add an activity, SCORM package."
            }
            Self::Page => {
                "All of carrom in one HTML file for phones, tablets and computers. It works without \
                 internet: send it to pupils, or put it on the school's server. It includes your own levels, \
                 chapters and questions, if carrom was started with them."
            }
            Self::Report => {
                "An HTML page and two tables for a spreadsheet: the votes on every question, what \
                 wrong answers suggest, and what to teach next."
            }
            Self::Gradebook => {
                "An HTML page with the results of all pupils, from the files that they have handed in: \
                 by pupil, by round and by question, and what the pupils believe."
            }
            Self::Guide => {
                "How to run a class, how to write questions, what is simulated, and more. HTML files to read or print."
            }
        }
    }
}

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
            let sheets = counted(SHEETS[teacher.sheets].into(), "sheet");
            panel.fact("for the class", sheets);
        }
        TeacherTask::Gradebook => {
            panel.fact("files", HandInFolder::ALL[teacher.folder].name());
        }
        TeacherTask::Guide => {
            let guide = &GUIDES[teacher.guide];
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

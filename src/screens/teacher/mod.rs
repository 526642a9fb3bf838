//! The screen on which a teacher prepares lessons and evaluates their results, without the command
//! line.

mod view;

use std::sync::Arc;

use jiff::civil::Date;
use strum::{EnumCount, EnumMessage, IntoStaticStr};

use super::{Context, Next, Route, Screen, View};
use crate::class::ClassRound;
use crate::messages::{
    FileContent, FileKind, HandInFolder, Input, Kept, Key, StoreReply, StoreRequest,
};
use crate::paper::Paper;
use crate::paper::guide::{GUIDES, guide_page};
use crate::paper::worksheet::{Worksheet, cards};
use crate::quiz::{Code, Round};
use crate::widgets::Role;
use crate::widgets::input::{KeyTable, ListAction, ListView, TextField};

/// The largest number of characters in a code that is typed.
const LONGEST: usize = 40;
/// The numbers of sheets of cards to choose from.
const SHEETS: [u16; 8] = [1, 8, 16, 20, 24, 28, 32, 40];

#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum TeacherAction {
    /// choose what to make, and make it
    List(ListAction),
    /// change the number of sheets, the folder, the round or the guide
    Change(isize),
    /// go back
    Back,
}

/// What can be made, in the order of a lesson. The message of each variant is its name in the list,
/// and its doc comment is its description beside the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount, EnumMessage)]
enum TeacherTask {
    /// Teams at one keyboard, raised hands, paper cards, or each pupil on a device of their own. No
    /// internet is needed.
    #[strum(message = "A round with a class")]
    Class,
    /// Two HTML files to print: the questions with space for answers, and the worked solutions with
    /// the wrong answers to listen for. The code fixes the questions; the same code opens them on a
    /// screen.
    #[strum(message = "Worksheet with its key")]
    Worksheet,
    /// Cards A to D for pupils to vote with, one sheet for each pupil, folded twice. An HTML file
    /// to print.
    #[strum(message = "Voting cards")]
    Cards,
    /// The questions of a round for Moodle's question bank, with pictures, and feedback for each
    /// misconception. In Moodle: Question bank, Import, Moodle XML format.
    #[strum(message = "Questions for Moodle")]
    Moodle,
    /// A SCORM 1.2 package, a ZIP file to upload. The platform opens the round for each pupil and
    /// receives the score, the time and each answer. In Moodle: Add an activity, SCORM package.
    #[strum(message = "Round for a learning platform")]
    Scorm,
    /// An HTML page and two tables for a spreadsheet: the votes on every question, what wrong
    /// answers suggest, and what to teach next.
    #[strum(message = "Report of a class round")]
    Report,
    /// An HTML page with the results of all pupils, from the files that they have handed in: by
    /// pupil, by round and by question, and what the pupils believe.
    #[strum(message = "Gradebook")]
    Gradebook,
    /// All of carrom in one HTML file for phones, tablets and computers. It works without internet:
    /// send it to pupils, or put it on the school's server. It includes your own levels, chapters
    /// and questions, if carrom was started with them.
    #[strum(message = "carrom as one file for browsers")]
    Page,
    /// How to run a class, how to write questions, what is simulated, and more. HTML files to read
    /// or print.
    #[strum(message = "Guides")]
    Guide,
}

impl TeacherTask {
    const ALL: &[Self] = &[
        Self::Class,
        Self::Worksheet,
        Self::Cards,
        Self::Moodle,
        #[cfg(not(target_family = "wasm"))]
        Self::Scorm,
        Self::Report,
        Self::Gradebook,
        #[cfg(not(target_family = "wasm"))]
        Self::Page,
        Self::Guide,
    ];

    fn name(self) -> &'static str {
        self.get_message().unwrap_or_default()
    }

    fn about(self) -> String {
        let lines = self.get_documentation().unwrap_or_default().lines();
        lines.collect::<Vec<_>>().join(" ")
    }
}

#[derive(Debug, Clone)]
pub(crate) struct Teacher {
    tasks: ListView,
    /// The code of the round for a worksheet or for a learning platform.
    code: TextField,
    /// The reason why the code is refused.
    refused: Option<String>,
    /// For each task, the index of the chosen value: in [`SHEETS`], [`HandInFolder::ALL`], `rounds`
    /// or [`GUIDES`].
    picked: [usize; TeacherTask::COUNT],
    /// The saved class rounds that can be read, newest first, each with its day if it is known.
    rounds: Vec<(Arc<ClassRound>, Option<Date>)>,
    /// The files last written for the chosen task, or the reasons why they were not written.
    written: Vec<(String, Role)>,
}

impl Teacher {
    /// Requests the saved class rounds.
    pub(crate) fn ask(cx: &mut Context) -> Self {
        cx.ask(StoreRequest::List(FileKind::Class));
        let mut picked = [0; TeacherTask::COUNT];
        picked[TeacherTask::Cards as usize] = SHEETS.len() - 2;
        Self {
            tasks: ListView::default(),
            code: TextField::new("even12-7", LONGEST),
            refused: None,
            picked,
            rounds: Vec::new(),
            written: Vec::new(),
        }
    }

    fn task(&self) -> TeacherTask {
        TeacherTask::ALL[self.tasks.chosen(TeacherTask::ALL.len())]
    }

    /// Whether the chosen task needs the code of a round.
    fn needs_code(&self) -> bool {
        use TeacherTask::{Moodle, Scorm, Worksheet};
        matches!(self.task(), Worksheet | Moodle | Scorm)
    }

    /// The index of the value that is chosen for the chosen task.
    fn picked(&self) -> usize {
        self.picked[self.task() as usize]
    }

    /// The chosen round of a class, with its day.
    fn chosen_round(&self) -> Option<&(Arc<ClassRound>, Option<Date>)> {
        self.rounds.get(self.picked())
    }

    /// How many values the chosen task offers.
    fn choices(&self) -> usize {
        match self.task() {
            TeacherTask::Cards => SHEETS.len(),
            TeacherTask::Gradebook => HandInFolder::ALL.len(),
            TeacherTask::Report => self.rounds.len(),
            TeacherTask::Guide => GUIDES.len(),
            _ => 0,
        }
    }

    fn can_change(&self) -> bool {
        self.choices() > 1
    }

    fn change(&mut self, by: isize) {
        let (task, count) = (self.task(), self.choices());
        if count > 0 {
            let at = &mut self.picked[task as usize];
            *at = (*at + count).saturating_add_signed(by) % count;
        }
        self.written.clear();
    }

    /// The round of the typed code; `None` if the code is refused, and the reason is then shown.
    fn quiz_round(&mut self, cx: &Context) -> Option<Round> {
        let code = Code::read(self.code.text()).map_err(|error| error.to_string());
        let code = code.and_then(|code| code.with_own(&cx.own)?.same_for_all());
        match code {
            Ok(code) => Some(Round::of(code)),
            Err(reason) => {
                self.refused = Some(reason);
                None
            }
        }
    }

    fn done(&mut self, place: &str) {
        self.written.push((format!("Written: {place}"), Role::Good));
    }

    fn failed(&mut self, words: String) {
        self.written.push((words, Role::Warn));
    }

    fn make(&mut self, cx: &mut Context) -> Next {
        self.written.clear();
        match self.task() {
            TeacherTask::Class => {
                return Next::Open(Route::Class {
                    code: None,
                    teams: Vec::new(),
                    name: String::new(),
                });
            }
            TeacherTask::Worksheet => {
                if let Some(round) = self.quiz_round(cx) {
                    let (code, sheet) = (round.code(), Worksheet::new(&round, None));
                    cx.export(format!("worksheet-{code}.html"), sheet.sheet_html());
                    cx.export(format!("key-{code}.html"), sheet.key_html());
                }
            }
            TeacherTask::Moodle => {
                if let Some(round) = self.quiz_round(cx) {
                    let name = format!("moodle-{}.xml", round.code());
                    let sheet = Worksheet::new(&round, None);
                    cx.export(name, Worksheet::moodle_xml(&[sheet]));
                }
            }
            TeacherTask::Scorm => {
                if let Some(round) = self.quiz_round(cx) {
                    let code = round.code();
                    cx.export_page(format!("scorm-{code}.zip"), Some(code.clone()));
                }
            }
            TeacherTask::Page => cx.export_page("carrom.html".into(), None),
            TeacherTask::Cards => {
                let sheets = SHEETS[self.picked()];
                cx.export("cards.html".into(), cards(sheets.into(), Paper::default()));
            }
            TeacherTask::Report => {
                if let Some((round, _)) = self.chosen_round() {
                    cx.ask(StoreRequest::Export(FileContent::Class(Arc::clone(round))));
                }
            }
            TeacherTask::Gradebook => {
                cx.ask(StoreRequest::Gather(HandInFolder::ALL[self.picked()]));
            }
            TeacherTask::Guide => {
                let guide = &GUIDES[self.picked()];
                let name = format!("carrom-{}.html", guide.name);
                cx.export(name, guide_page(guide.markdown));
            }
        }
        Next::Stay
    }
}

impl Screen for Teacher {
    type Action = TeacherAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "teacher";
    const ROUTE: Route = Route::Teacher;

    fn keys(&self, _cx: &Context) -> KeyTable<TeacherAction> {
        use TeacherAction::{Back, Change, List};
        let made = match self.task() {
            TeacherTask::Class => "open",
            _ => "write it",
        };
        let list = ListView::keys_of_form(made, self.needs_code());
        KeyTable::new("teacher")
            .with(list, List)
            .by([Key::Left, Key::Right], Change, [-1, 1], "change")
            .when(self.can_change())
            .on(Key::Escape, Back, "back")
    }

    fn typed(&mut self, key: Key, _cx: &mut Context) -> bool {
        let of_code = |c: char| c.is_ascii_alphanumeric() || c == '-';
        let is_of_code = !matches!(key, Key::Char(c) if !of_code(c));
        let used = self.needs_code() && is_of_code && self.code.update(key);
        if used {
            self.refused = None;
            self.written.clear();
        }
        used
    }

    fn act(&mut self, action: TeacherAction, cx: &mut Context) -> Next {
        match action {
            TeacherAction::List(action) => {
                let before = self.task();
                let outcome = self.tasks.act(action, TeacherTask::ALL.len());
                if self.task() != before {
                    self.written.clear();
                    self.refused = None;
                }
                return Next::of(outcome, |_| self.make(cx));
            }
            TeacherAction::Change(by) => self.change(by),
            TeacherAction::Back => return Next::Back,
        }
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Paste(text) if self.needs_code() => {
                self.code.paste(text.trim());
                self.refused = None;
            }
            Input::Exported(Ok(place)) => self.done(place),
            Input::Exported(Err(reason)) => {
                self.failed(format!("Nothing could be written: {reason}."));
            }
            Input::Kept(answer) => match &answer.done {
                StoreReply::Classes(Ok(rounds)) => {
                    let round = |it: &Kept<ClassRound>| {
                        let round = it.content.as_deref().ok()?;
                        Some((Arc::new(round.clone()), it.day))
                    };
                    self.rounds = rounds.iter().filter_map(round).collect();
                    self.picked[TeacherTask::Report as usize] = 0;
                }
                StoreReply::Exported(Ok(places)) => self.done(places),
                StoreReply::Gathered(Ok(book)) => {
                    book.notes.iter().for_each(|note| self.failed(note.clone()));
                    cx.export("gradebook.html".into(), book.html.clone());
                }
                StoreReply::Exported(Err(reason)) | StoreReply::Gathered(Err(reason)) => {
                    self.failed(reason.clone());
                }
                _ => return Next::Ignored,
            },
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn resumed(&mut self, cx: &mut Context) {
        cx.ask(StoreRequest::List(FileKind::Class));
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        self.act(TeacherAction::List(ListAction::Choose(by.into())), cx)
    }

    fn view<'s>(&'s self, _cx: &'s Context) -> View<'s, TeacherAction> {
        view::view(self)
    }
}

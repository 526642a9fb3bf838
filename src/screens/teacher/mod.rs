//! The screen on which a teacher prepares lessons and evaluates their results, without the command
//! line.

mod view;

use std::sync::Arc;

use jiff::civil::Date;
use strum::{EnumMessage, IntoStaticStr};

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

/// What can be made, in the order of a lesson.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum TeacherTask {
    Class,
    Worksheet,
    Cards,
    Moodle,
    Scorm,
    Report,
    Gradebook,
    Page,
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
}

#[derive(Debug, Clone)]
pub(crate) struct Teacher {
    tasks: ListView,
    /// The code of the round for a worksheet or for a learning platform.
    code: TextField,
    /// The reason why the code is refused.
    refused: Option<String>,
    /// The index in [`SHEETS`].
    sheets: usize,
    /// The index in [`HandInFolder::ALL`].
    folder: usize,
    /// The saved class rounds that can be read, newest first, each with its day if it is known.
    rounds: Vec<(Arc<ClassRound>, Option<Date>)>,
    round: usize,
    /// The index in [`GUIDES`].
    guide: usize,
    /// The files last written for the chosen task, or the reasons why they were not written.
    written: Vec<(String, Role)>,
}

impl Teacher {
    /// Requests the saved class rounds.
    pub(crate) fn ask(cx: &mut Context) -> Self {
        cx.ask(StoreRequest::List(FileKind::Class));
        Self {
            tasks: ListView::default(),
            code: TextField::new("even12-7", LONGEST),
            refused: None,
            sheets: SHEETS.len() - 2,
            folder: 0,
            rounds: Vec::new(),
            round: 0,
            guide: 0,
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

    /// The chosen round of a class, with its day.
    fn chosen_round(&self) -> Option<&(Arc<ClassRound>, Option<Date>)> {
        self.rounds.get(self.round)
    }

    /// How many values the chosen task offers, and the index of the chosen one.
    fn choice(&mut self) -> (usize, &mut usize) {
        match self.task() {
            TeacherTask::Cards => (SHEETS.len(), &mut self.sheets),
            TeacherTask::Gradebook => (HandInFolder::ALL.len(), &mut self.folder),
            TeacherTask::Report => (self.rounds.len(), &mut self.round),
            _ => (GUIDES.len(), &mut self.guide),
        }
    }

    fn can_change(&self) -> bool {
        use TeacherTask::{Cards, Gradebook, Guide, Report};
        match self.task() {
            Cards | Guide => true,
            Gradebook => HandInFolder::ALL.len() > 1,
            Report => self.rounds.len() > 1,
            _ => false,
        }
    }

    fn change(&mut self, by: isize) {
        let (count, at) = self.choice();
        if count > 0 {
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
                let sheets = SHEETS[self.sheets];
                cx.export("cards.html".into(), cards(sheets.into(), Paper::default()));
            }
            TeacherTask::Report => {
                if let Some((round, _)) = self.chosen_round() {
                    cx.ask(StoreRequest::Export(FileContent::Class(Arc::clone(round))));
                }
            }
            TeacherTask::Gradebook => {
                cx.ask(StoreRequest::Gather(HandInFolder::ALL[self.folder]));
            }
            TeacherTask::Guide => {
                let guide = &GUIDES[self.guide];
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
        // In a text field, these keys move the cursor to its ends.
        let ends = match self.needs_code() {
            true => [Key::Home, Key::End].as_slice(),
            false => &[],
        };
        let list = ListView::keys(made).without_keys(ends);
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
                    self.round = 0;
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

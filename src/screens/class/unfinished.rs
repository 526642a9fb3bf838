//! A round on devices that was interrupted by a crash or by the end of a lesson. The teacher can
//! resume it instead of starting another round.

use super::earlier::head_count;
use super::{ClassAction, ClassScene};
use crate::class::{ClassRound, WayOfVoting};
use crate::messages::{FileKind, Kept, StoreAnswer, StoreReply, StoreRequest};
use crate::progress::long_day;
use crate::quiz::Code;
use crate::screens::{Context, View};
use crate::widgets::input::{KeyTable, ListAction, ListView};
use crate::widgets::panel::Panel;
use crate::widgets::{Outcome, Role, text};

const CHOICES: [&str; 2] = ["resume it", "begin another round"];

/// The page on which an interrupted round can be resumed.
#[derive(Debug, Clone)]
pub(super) struct Unfinished {
    /// The round that begins if the interrupted one is not resumed, the name of its class, and
    /// whether the class is given nicknames.
    code: Option<Code>,
    name: String,
    nicknames: bool,
    /// The interrupted round; `None` until it has been found.
    stopped: Option<Kept<ClassRound>>,
    list: ListView,
    /// The ticket for loading it.
    loading: Option<u64>,
    /// Why the round cannot be resumed.
    trouble: Option<String>,
}

impl Unfinished {
    /// Looks for an interrupted round that has this code and is for this class, if they are given.
    pub(super) fn ask(code: Option<Code>, name: &str, nicknames: bool, cx: &mut Context) -> Self {
        cx.ask(StoreRequest::List(FileKind::Class));
        Self {
            code,
            name: name.to_owned(),
            nicknames,
            stopped: None,
            list: ListView::default(),
            loading: None,
            trouble: None,
        }
    }

    /// The page on which another round begins: the round itself if its code is known, otherwise the
    /// set-up page.
    fn another(&self, cx: &mut Context) -> ClassScene {
        let Some(code) = self.code.clone() else {
            return ClassScene::SetUp;
        };
        let round = ClassRound::with_devices(code).of_class(&self.name);
        ClassScene::play(round.with_nicknames(self.nicknames), cx)
    }

    /// The latest round on devices that has this code and is of this class, if it is not over and
    /// somebody has joined.
    fn find<'k>(&self, kept: &'k [Kept<ClassRound>]) -> Option<&'k Kept<ClassRound>> {
        let is_meant = |round: &ClassRound| {
            let is_class = self.name.is_empty() || round.is_of_class(&self.name);
            let is_code = self.code.as_ref().is_none_or(|code| code == round.code());
            round.way() == WayOfVoting::Devices && is_class && is_code
        };
        let mut rounds = kept
            .iter()
            .filter_map(|it| Some((it, it.content.as_ref().ok()?)));
        let (latest, round) = rounds.find(|(_, round)| is_meant(round))?;
        let is_stopped = round.join_code().is_some() && !round.participants().is_empty();
        is_stopped.then_some(latest)
    }

    /// Handles the answer to a request; returns the page that follows.
    pub(super) fn take_answer(
        &mut self,
        answer: &StoreAnswer,
        cx: &mut Context,
    ) -> Option<ClassScene> {
        match &answer.done {
            StoreReply::Classes(kept) if self.stopped.is_none() => {
                self.stopped = kept.as_ref().ok().and_then(|kept| self.find(kept)).cloned();
                self.stopped.is_none().then(|| self.another(cx))
            }
            StoreReply::Class(loaded)
                if self.loading.take_if(|it| *it == answer.ticket).is_some() =>
            {
                let resumed = ClassScene::resume(loaded, answer.ticket, cx);
                resumed.map_err(|trouble| self.trouble = Some(trouble)).ok()
            }
            _ => None,
        }
    }

    pub(super) fn keys(&self) -> KeyTable<ListAction> {
        match self.stopped {
            Some(_) => ListView::keys(CHOICES[self.list.chosen(CHOICES.len())]),
            None => KeyTable::new("list"),
        }
    }

    /// Carries out the action of a key or a click; returns the page that follows.
    pub(super) fn act(&mut self, action: ListAction, cx: &mut Context) -> Option<ClassScene> {
        let stopped = self.stopped.as_ref()?;
        match self.list.act(action, CHOICES.len()) {
            Outcome::Done(0) => {
                self.trouble = None;
                self.loading =
                    Some(cx.ask(StoreRequest::Load(FileKind::Class, stopped.name.clone())));
                None
            }
            Outcome::Done(_) => Some(self.another(cx)),
            _ => None,
        }
    }

    pub(super) fn view(&self) -> View<'_, ClassAction> {
        let mut panel = Panel::new("an interrupted round");
        let mut beside = Panel::new("the round");
        let stopped = self.stopped.as_ref();
        if let Some((kept, round)) = stopped.and_then(|it| Some((it, it.content.as_ref().ok()?))) {
            // The code of the questions is not shown, because pupils could use it to play the round
            // in advance.
            let called = match round.class() {
                "" => "A class",
                class => class,
            };
            let question = round.place().question + 1;
            let count = head_count(round);
            panel.paragraph(
                format!("{called} stopped at question {question} with {count}: resume it?"),
                Role::Title,
            );
            panel.gap();
            for (at, name) in CHOICES.into_iter().enumerate() {
                let chosen = at == self.list.chosen(CHOICES.len());
                let action = ClassAction::Unfinished(ListAction::Point(at));
                panel.row((name, Role::Text), ("", Role::Dim), chosen, action);
            }
            panel.gap();
            if let Some(trouble) = &self.trouble {
                panel.paragraph(trouble, Role::Warn);
                panel.gap();
            }
            panel.paragraph(
                "If you resume it, it keeps its address and its code: devices that still show the \
                 page reconnect automatically, with every vote. Otherwise it stays in the list of \
                 earlier rounds.",
                Role::Dim,
            );
            beside.fact("questions", round.questions().len().to_string());
            if let Some(code) = round.join_code() {
                beside.fact("code", code.to_string());
            }
            if let Some(address) = round.address() {
                beside.fact("at", address.to_string());
            }
            if let (Some(day), Some(age)) = (kept.day, kept.age) {
                beside.fact("saved on", long_day(day));
                beside.fact("age", text::ago(age));
            }
        } else {
            panel.paragraph("Looking for an interrupted round …", Role::Text);
        }
        View::panels(panel, beside)
    }
}

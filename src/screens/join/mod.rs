//! A pupil's device in a class: joining, voting, and seeing the true answer.

mod form;
mod joined;
mod link;
mod view;

#[cfg(not(target_family = "wasm"))]
pub(crate) use form::{code_of, host_of};

use std::time::Duration;

use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::recall::Recall;
use super::{Confirmation, Context, Next, Route, Screen, Settings, SharedAction, View};
use crate::class::protocol::{HostMessage, PupilStep, Refusal};
use crate::class::{JoinCode, Said, is_nickname};
use crate::files::tidy_name;
use crate::game::is_player_name;
use crate::gradebook::HandIn;
use crate::messages::{Input, Key, Mouse};
use crate::numbers::counted;
use crate::widgets::hit::WatchAction;
use crate::widgets::input::{KeyTable, ListAction};
use crate::widgets::panel::Panel;
use crate::widgets::{AnswerAction, AnswerInput, Asking, AskingAction, Outcome, Role, SplitLayout};
use form::JoinForm;
use joined::{Doing, JoinedClass};
use link::Link;

/// Actions on a pupil's device.
#[derive(Debug, Clone, Copy, PartialEq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum JoinAction {
    /// choose what to type, or join
    Form(ListAction),
    /// vote
    Ask(AskingAction),
    /// take back the vote
    TakeBack,
    /// watch the collision
    Watch(WatchAction),
    /// hand in everything that you have answered on your own, for the teacher
    HandIn,
    /// go back to the answer, or leave the class
    Leave,
}

impl JoinAction {
    /// The action for entering an answer; a click on a choice gives the answer at once.
    const fn answer(action: AnswerAction) -> Self {
        Self::Ask(AskingAction::Answer(match action {
            AnswerAction::Choose(choice) => AnswerAction::Give(choice),
            action => action,
        }))
    }
}

/// A pupil's device in a class.
#[derive(Debug, Clone)]
pub(crate) struct Join {
    form: JoinForm,
    link: Option<Link>,
    joined: Option<JoinedClass>,
    /// The answers that the pupil gave while playing alone, requested once the pupil has joined.
    history: Recall,
}

impl Join {
    /// The screen before joining, with the known values filled in. `address` is `None` if the host
    /// has served the page. If a pupil joins `again`, the form is skipped.
    pub(crate) fn new(
        address: Option<&str>,
        code: Option<JoinCode>,
        again: bool,
        cx: &mut Context,
    ) -> Self {
        let player = &cx.settings.player;
        let name = match *player == Settings::default().player {
            true => "",
            false => player,
        };
        let mut join = Self {
            form: JoinForm::new(address, code, name),
            link: None,
            joined: None,
            history: Recall::default(),
        };
        if again {
            let entry = join.form.entry();
            join.enter(entry, cx);
        }
        join
    }

    /// The pupil's seat and connection, once they have joined.
    fn joined(&self) -> Option<(&JoinedClass, &Link)> {
        self.joined.as_ref().zip(self.link.as_ref())
    }

    fn is_over(&self) -> bool {
        let joined = self.joined.as_ref();
        joined.is_some_and(|joined| joined.state.step == PupilStep::End)
    }

    /// The number of answers that can be handed in now: none during a question.
    fn answers(&self) -> usize {
        let is_free = self.joined.as_ref().is_some_and(|joined| {
            let is_beside = matches!(joined.state.step, PupilStep::Lobby | PupilStep::End);
            is_beside && matches!(joined.doing, Doing::Look)
        });
        let history = self.history.history().filter(|_| is_free);
        history.map_or(0, |history| history.attempts.len())
    }

    fn enter(&mut self, entry: Option<form::Entry>, cx: &mut Context) {
        if let Some(it) = entry {
            // On a page served by the class, the player is the pupil who has joined.
            let name = tidy_name(&it.name);
            if it.address.is_empty() && is_player_name(&name) {
                cx.change_player(name);
            }
            self.link = Some(Link::dial(it, cx));
        }
    }

    /// Casts the vote that is open, or withdraws it.
    fn vote(&mut self, said: Option<Said>, cx: &mut Context) {
        if let (Some(joined), Some(link)) = (&self.joined, &mut self.link)
            && let Some(vote) = joined.state.step.vote()
        {
            link.vote(joined.state.q, vote, said, cx);
        }
    }

    /// Leaves the class.
    fn hang_up(&mut self, cx: &mut Context) {
        if let Some(link) = &mut self.link {
            link.hang_up(cx);
        }
        self.link = None;
        self.joined = None;
    }

    /// Hands in all answers that the pupil gave while playing alone.
    fn hand_in(&mut self, cx: &mut Context) {
        let (Some(history), Some(link)) = (self.history.history(), &mut self.link) else {
            return;
        };
        // The host replaces the player's name with the name used in the class.
        let hand_in = HandIn::new(&cx.settings.player, "", history.attempts.clone());
        let revealed = match hand_in.value() {
            Ok(file) => match link.hand_in(file, cx) {
                true => return,
                false => "There are too many answers to send. On the Progress page, the h key writes them to a file for your teacher.".to_owned(),
            },
            Err(reason) => format!("Your answers cannot be sent: {reason}"),
        };
        cx.notify(revealed);
    }
}

impl Screen for Join {
    type Action = JoinAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "class";

    fn route(&self, _cx: &Context) -> Route {
        Route::Join {
            address: None,
            code: self.form.code(),
            again: false,
        }
    }

    fn status(&self, _cx: &Context) -> String {
        match &self.joined {
            Some(joined) => format!(
                "{}  question {} of {}",
                joined.state.name,
                joined.state.q + 1,
                joined.state.of
            ),
            None => String::new(),
        }
    }

    fn keys(&self, _cx: &Context) -> KeyTable<JoinAction> {
        use JoinAction::{Ask, Form, HandIn, Leave, TakeBack, Watch};
        let keys = KeyTable::new("join");
        let Some((joined, _)) = self.joined() else {
            return match &self.link {
                None => keys.with(self.form.keys(), Form),
                Some(_) => keys,
            }
            .on(Key::Escape, Leave, "back");
        };
        match &joined.doing {
            Doing::Look => keys.on('h', HandIn, "hand in").when(self.answers() > 0).on(
                Key::Escape,
                Leave,
                "leave",
            ),
            Doing::Vote(asking) => {
                let (may_take_back, leave) = match asking.sure() {
                    None => (joined.has_voted(), "leave"),
                    Some(_) => (false, "change it"),
                };
                keys.with(asking.keys("join", "vote"), Ask)
                    .on(Key::Delete, TakeBack, "take it back")
                    .when(may_take_back)
                    .on(Key::Escape, Leave, leave)
                    .when(asking.leaves_escape())
            }
            Doing::Watch(reveal) => keys
                .with(reveal.keys(), Watch)
                .on(Key::Escape, Leave, "leave"),
        }
    }

    fn typed(&mut self, key: Key, _cx: &mut Context) -> bool {
        self.link.is_none() && self.form.typed(key)
    }

    fn act(&mut self, action: JoinAction, cx: &mut Context) -> Next {
        match (action, &mut self.joined) {
            (JoinAction::Form(action), _) => {
                let entry = self.form.act(action);
                self.enter(entry, cx);
            }
            (JoinAction::Ask(action), Some(joined)) => {
                if let Doing::Vote(asking) = &mut joined.doing
                    && let Outcome::Done((response, sure)) = asking.act(action)
                {
                    asking.back();
                    let sure = Some(sure);
                    self.vote(Some(Said { response, sure }), cx);
                }
            }
            (JoinAction::TakeBack, Some(joined)) => {
                if let (Doing::Vote(asking), Some(question)) = (&mut joined.doing, &joined.question)
                {
                    *asking = Asking::new(AnswerInput::new(&question.form));
                }
                self.vote(None, cx);
            }
            (JoinAction::Watch(action), Some(joined)) => {
                if let Doing::Watch(reveal) = &mut joined.doing {
                    reveal.act(action);
                }
            }
            (JoinAction::HandIn, Some(_)) => {
                let answers = counted(self.answers(), "answer");
                return Next::Confirm(Confirmation::new(
                    format!(
                        "Send your teacher the answers you gave on your own ({answers}), with their results? Your votes in this round are not included."
                    ),
                    "hand in",
                    "not yet",
                ));
            }
            (JoinAction::Leave, Some(joined)) => {
                if let Doing::Vote(asking) = &mut joined.doing
                    && asking.back()
                {
                    return Next::Stay;
                }
                return Next::Confirm(Confirmation::new(
                    "Leave the class? With the same name on this device you can return to your place.",
                    "leave the class",
                    "stay",
                ));
            }
            (JoinAction::Leave, None) if self.link.is_some() => self.hang_up(cx),
            (JoinAction::Leave, None) => return Next::Back,
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn confirmed(&mut self, action: JoinAction, cx: &mut Context) -> Next {
        if action == JoinAction::HandIn {
            self.hand_in(cx);
            return Next::Stay;
        }
        cx.class = Some(self.form.route());
        self.hang_up(cx);
        Next::Back
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Paste(text) if self.link.is_none() => self.form.paste(text),
            Input::Joined(news) => {
                let pace = cx.settings.pace();
                let came = self.link.as_mut().and_then(|link| link.take(news, cx));
                match came {
                    Some(HostMessage::State(state)) => match &mut self.joined {
                        Some(joined) => joined.take(*state, pace),
                        None => {
                            if is_nickname(&state.name) {
                                self.form.take_nickname(&state.name, cx);
                            }
                            self.joined = Some(JoinedClass::new(*state, pace));
                            self.history = Recall::ask(cx);
                        }
                    },
                    // A round that is over stays on the screen, even if its host starts another.
                    Some(HostMessage::No {
                        why: Refusal::Code | Refusal::Closed,
                    }) if self.is_over() => {}
                    Some(HostMessage::No { why }) => {
                        self.link = None;
                        self.joined = None;
                        self.form.trouble = Some(why.to_string());
                    }
                    None => {}
                }
            }
            Input::Kept(answer) => self.history.take(answer),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn point(&mut self, mouse: &Mouse, picture: Rect, _cx: &mut Context) -> Next {
        match &mut self.joined {
            Some(joined) if picture.contains(mouse.cell().into()) => joined.point(mouse, picture),
            _ => Next::Ignored,
        }
    }

    fn wheel(&mut self, by: i8, _cx: &mut Context) -> Next {
        Next::Shared(SharedAction::Scroll(by.into()))
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        if let Some(link) = &mut self.link {
            link.advance(passed, cx);
        }
        if let Some(joined) = &mut self.joined {
            joined.advance(passed, cx.settings.pace());
        }
    }

    fn shares_time(&self) -> bool {
        true
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        let link = self.link.as_ref().and_then(Link::wake);
        let joined = self.joined.as_ref();
        let joined = joined.and_then(|joined| joined.wake(cx.settings.pace()));
        link.into_iter().chain(joined).min()
    }

    fn view<'s>(&'s self, _cx: &'s Context) -> View<'s, JoinAction> {
        let Some((joined, link)) = self.joined() else {
            let mut panel = Panel::new("your class");
            match &self.link {
                Some(link) => {
                    panel.paragraph("Joining the class ..", Role::Text);
                    if let Some(why) = link.held_up {
                        panel.gap();
                        panel.paragraph(why.to_string(), Role::Warn);
                    }
                }
                None => panel.part(JoinAction::Form, |panel| self.form.write(panel)),
            }
            return View::alone(SplitLayout::card, panel);
        };
        view::view(joined, link, self.answers())
    }
}

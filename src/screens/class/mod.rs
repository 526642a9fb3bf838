//! A round for a class in front of one screen: with teams at one keyboard, with hands or cards, or
//! with pupils on their own devices.
//!
//! A question goes through the `ClassStep`s of [`crate::class`]; `play` runs them, and each step
//! with its own actions has its own module.

mod earlier;
mod ending;
mod hosting;
mod play;
mod preview;
mod question;
mod scores;
mod set_up;
mod set_up_view;
mod shot;
mod stage;
mod talk;
mod tally;
#[cfg(test)]
mod tests;
mod unfinished;
mod vote;

use std::sync::Arc;
use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::kept_files::{KeptAction, KeptFiles};
use super::{Confirmation, Context, Next, Route, Screen, SharedAction, View};
use crate::class::{ClassRound, WayOfVoting};
use crate::messages::{Input, Key, Mouse};
use crate::quiz::{Code, Round};
use crate::widgets::big::{Align, Big};
use crate::widgets::hit::WatchAction;
use crate::widgets::input::{KeyTable, ListAction};
use crate::widgets::{Item, Look, Palette, Role, Words, areas, sheet};
use ending::EndAction;
use hosting::HostingAction;
use play::ClassPlay;
use set_up::{SetUp, SetUpAction, SetUpRow};
use tally::CountAction;
use unfinished::Unfinished;
use vote::VoteAction;

/// What the keys do in a class round. Each page has its own actions, and so does each step at which
/// the class can do more than continue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ClassAction {
    SetUp(SetUpAction),
    Earlier(KeptAction),
    Unfinished(ListAction),
    /// On the pages about pupils on their own devices.
    Hosting(HostingAction),
    /// At any step.
    Round(RoundAction),
    /// While teams are voting.
    Vote(VoteAction),
    /// While votes are being counted.
    Count(CountAction),
    /// While the collision is being replayed.
    Watch(WatchAction),
    /// After the last question.
    End(EndAction),
}

/// What the keys do at any step of a class round.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum RoundAction {
    /// go on
    Forward,
    /// go back one step
    Backward,
    /// go to the previous or next question, at the step where you left it
    Leap(isize),
    /// blank the screen; press the key again to return
    Pause,
    /// switch between dark on light, for a projector, and light on dark
    Light,
    /// go straight to the shot, if there is little to discuss
    ToTheShot,
    /// show a one-minute countdown, or add half a minute
    Countdown,
    /// show only the question's text, as large as possible
    WordsAlone,
    /// show pupils' names on the scoreboard, or the results of each question
    BoardNames,
    /// write a report to print, and two tables for a spreadsheet: answers and questions
    Tables,
    /// go back, or leave the round
    Leave,
}

/// A round for a class in front of one screen.
#[derive(Debug, Clone)]
pub(crate) struct Class {
    set_up: SetUp,
    scene: ClassScene,
    /// Whether the screen is blank until somebody continues.
    paused: bool,
}

/// The current page.
#[derive(Debug, Clone)]
enum ClassScene {
    SetUp,
    /// The questions of the round that is being set up.
    Preview(Round),
    Earlier(KeptFiles<ClassRound>),
    Unfinished(Unfinished),
    Play(Box<ClassPlay>),
}

impl ClassScene {
    /// A round from its start.
    fn play(round: ClassRound, cx: &mut Context) -> Self {
        let ticket = cx.ticket();
        Self::Play(Box::new(ClassPlay::new(round, ticket, cx)))
    }

    /// A round that has been loaded with this ticket, at the step where it was left.
    ///
    /// # Errors
    /// A sentence that says why the round cannot be resumed.
    fn resume(
        loaded: &Result<Box<ClassRound>, String>,
        ticket: u64,
        cx: &mut Context,
    ) -> Result<Self, String> {
        let round = loaded.as_deref();
        let round = round.map_err(|it| format!("The round cannot be resumed: {it}."))?;
        let play = ClassPlay::new(round.clone(), ticket, cx);
        Ok(Self::Play(Box::new(play)))
    }
}

impl Class {
    /// The set-up page, with the known values filled in.
    pub(crate) fn new(code: Option<&Code>, teams: &[String], name: &str, cx: &Context) -> Self {
        Self {
            set_up: SetUp::new(code, teams, name, Arc::clone(&cx.own)),
            scene: ClassScene::SetUp,
            paused: false,
        }
    }

    /// A round on pupils' own devices: an interrupted one if the teacher resumes it, otherwise a
    /// new one.
    pub(crate) fn with_devices(
        code: Option<&Code>,
        name: &str,
        nicknames: bool,
        cx: &mut Context,
    ) -> Self {
        let unfinished = Unfinished::ask(code.cloned(), name, nicknames, cx);
        let mut class = Self::new(None, &[], name, cx);
        class.set_up.nicknames = nicknames;
        class.set_up.put(SetUpRow::Start(WayOfVoting::Devices));
        class.scene = ClassScene::Unfinished(unfinished);
        class
    }

    /// Shows the page that follows, if one does.
    fn go(&mut self, next: Option<ClassScene>) {
        if let Some(scene) = next {
            self.scene = scene;
        }
    }

    fn leave(&mut self, cx: &mut Context) -> Next {
        match &mut self.scene {
            ClassScene::SetUp | ClassScene::Unfinished(_) => Next::Back,
            ClassScene::Earlier(_) | ClassScene::Preview(_) => {
                self.scene = ClassScene::SetUp;
                Next::Stay
            }
            ClassScene::Play(play) if !play.asks_before_leaving() => {
                play.leave(cx);
                Next::Back
            }
            ClassScene::Play(play) => {
                let what = match play.unsaved {
                    true => "It is not saved and will be lost. The e key writes its tables.",
                    false => "It is saved, and you can resume it later.",
                };
                Next::Confirm(Confirmation::new(
                    format!("Leave the round? {what}"),
                    "leave the round",
                    "stay",
                ))
            }
        }
    }
}

impl Screen for Class {
    type Action = ClassAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "class";

    fn route(&self, _cx: &Context) -> Route {
        Route::Class {
            code: match &self.scene {
                ClassScene::Play(play) => Some(play.stage.round().code().clone()),
                _ => None,
            },
            teams: Vec::new(),
            name: String::new(),
        }
    }

    fn status(&self, _cx: &Context) -> String {
        match &self.scene {
            ClassScene::Play(play) if !self.paused => {
                let of = play.stage.round().questions().len();
                let place = format!("question {} of {of}", play.stage.number() + 1);
                match play.stage.step().vote().filter(|_| !play.is_over()) {
                    // The code is not shown, because pupils could use it to play the round in
                    // advance.
                    Some(vote) if play.stage.session.is_hosted() => {
                        format!("{place}  {}", play.stage.session.turnout(vote))
                    }
                    None if play.stage.session.is_hosted() => place,
                    _ => format!("{place}  code {}", play.stage.round().code()),
                }
            }
            _ => String::new(),
        }
    }

    fn keys(&self, _cx: &Context) -> KeyTable<ClassAction> {
        use RoundAction::{Leave, Pause};
        let round = KeyTable::new("class");
        if self.paused {
            let keys = round.on('p', Pause, "go on").or([(Key::Escape, Pause)]);
            return keys.map(ClassAction::Round);
        }
        let keys = KeyTable::new("class");
        let keys = match &self.scene {
            ClassScene::SetUp => keys.with(self.set_up.keys(), ClassAction::SetUp),
            ClassScene::Preview(_) => keys,
            ClassScene::Earlier(rounds) => {
                keys.with(rounds.keys("resume it"), ClassAction::Earlier)
            }
            ClassScene::Unfinished(unfinished) => {
                keys.with(unfinished.keys(), ClassAction::Unfinished)
            }
            ClassScene::Play(play) => return play.keys(),
        };
        keys.with(round.on(Key::Escape, Leave, "back"), ClassAction::Round)
    }

    fn typed(&mut self, key: Key, _cx: &mut Context) -> bool {
        match &mut self.scene {
            ClassScene::SetUp => self.set_up.typed(key),
            ClassScene::Play(play) if !self.paused => play.typed(key),
            _ => false,
        }
    }

    fn act(&mut self, action: ClassAction, cx: &mut Context) -> Next {
        match (action, &mut self.scene) {
            (ClassAction::Round(RoundAction::Pause), _) => self.paused = !self.paused,
            (ClassAction::Round(RoundAction::Light), _) => {
                cx.settings.palette = match cx.settings.palette {
                    Palette::Light => Palette::Dark,
                    Palette::Dark | Palette::Mono => Palette::Light,
                };
            }
            (ClassAction::Round(RoundAction::Leave), _) => return self.leave(cx),
            (ClassAction::SetUp(action), ClassScene::SetUp) => {
                let outcome = self.set_up.act(action, cx);
                return Next::of(outcome, |scene| {
                    self.scene = scene;
                    Next::Stay
                });
            }
            (ClassAction::Earlier(action), ClassScene::Earlier(rounds)) => {
                return rounds.act(action, cx);
            }
            (ClassAction::Unfinished(action), ClassScene::Unfinished(unfinished)) => {
                let next = unfinished.act(action, cx);
                self.go(next);
            }
            (action, ClassScene::Play(play)) => return play.act(action, cx),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn confirmed(&mut self, action: ClassAction, cx: &mut Context) -> Next {
        match (&mut self.scene, action) {
            (ClassScene::Earlier(rounds), ClassAction::Earlier(_)) => rounds.remove(cx),
            (ClassScene::Play(play), ClassAction::Hosting(action)) => play.host(action, cx),
            (ClassScene::Play(play), ClassAction::Round(_)) => {
                play.leave(cx);
                return Next::Back;
            }
            // While the question was open, a round has been loaded.
            _ => {}
        }
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match (input, &mut self.scene) {
            (Input::Paste(text), ClassScene::SetUp) => self.set_up.paste(text),
            (Input::Kept(answer), ClassScene::Earlier(rounds)) => {
                let next = earlier::take_answer(rounds, answer, cx);
                self.go(next);
            }
            (Input::Kept(answer), ClassScene::Unfinished(unfinished)) => {
                let next = unfinished.take_answer(answer, cx);
                self.go(next);
            }
            (Input::Kept(answer), ClassScene::Play(play)) => play.take_answer(answer, cx),
            (Input::Hosted(news), ClassScene::Play(play)) => play.take_news(news, cx),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn point(&mut self, mouse: &Mouse, picture: Rect, _cx: &mut Context) -> Next {
        match &mut self.scene {
            ClassScene::Play(play) if !self.paused => Next::after(play.point(mouse, picture)),
            _ => Next::Ignored,
        }
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        let list = ListAction::Choose(by.into());
        let action = match &self.scene {
            _ if self.paused => None,
            ClassScene::Preview(_) => None,
            ClassScene::SetUp => Some(ClassAction::SetUp(SetUpAction::List(list))),
            ClassScene::Earlier(_) => Some(ClassAction::Earlier(KeptAction::List(list))),
            ClassScene::Unfinished(_) => Some(ClassAction::Unfinished(list)),
            ClassScene::Play(play) => play.wheel(by),
        };
        let pages = Next::Shared(SharedAction::Scroll(by.into()));
        action.map_or(pages, |action| self.act(action, cx))
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        if let ClassScene::Play(play) = &mut self.scene {
            play.advance(passed, cx.settings.pace());
        }
    }

    fn shares_time(&self) -> bool {
        true
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        match &self.scene {
            ClassScene::Play(play) if !self.paused => play.wake(cx.settings.pace()),
            _ => None,
        }
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, ClassAction> {
        match &self.scene {
            _ if self.paused => View::picture_alone(draw_pause),
            ClassScene::SetUp => set_up_view::view(&self.set_up),
            ClassScene::Preview(round) => preview::view(round),
            ClassScene::Earlier(rounds) => earlier::view(rounds),
            ClassScene::Unfinished(unfinished) => unfinished.view(),
            ClassScene::Play(play) => play.view(cx),
        }
    }
}

/// Draws the blank screen of a pause.
fn draw_pause(area: Rect, buf: &mut Buffer, look: &Look) {
    sheet::note(area, || Item::new(Words::large("paused", Role::Dim)));
    if let Some(big) = Big::fit("paused", area.width, area.height / 2, look.charset) {
        let [_, place] = areas::upper(area, area.height.saturating_sub(big.rows()) / 2);
        big.draw(place, buf, look, Role::Dim, Align::Centre);
    }
}

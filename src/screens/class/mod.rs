//! A round for a class round one screen: one keyboard, a projector, teams.
//!
//! A question goes through the `ClassStep`s of [`crate::class`]; `play` knows the way
//! through them, and every step has a view of its own.

mod earlier;
mod ending_view;
mod heading;
mod hosting;
mod play;
mod question_view;
mod scores_view;
mod set_up;
mod set_up_view;
mod shown;
mod shown_view;
mod spread_view;
mod step_view;
mod tally_entry;
mod unfinished;
mod view;
mod vote_entry;
mod vote_view;
mod words;

use std::sync::Arc;
use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::kept_files::KeptAction;
use super::{Confirmation, Context, Next, Place, Screen, View};
use crate::class::ClassRound;
use crate::messages::{Input, Key, Mouse};
use crate::quiz::Code;
use crate::widgets::hit::WatchAction;
use crate::widgets::input::{KeyTable, ListAction};
use crate::widgets::{AnswerAction, Outcome, Palette, SplitLayout};
use earlier::EarlierRounds;
use heading::WIDEST;
use hosting::HostingAction;
use play::ClassPlay;
use set_up::{SetUp, SetUpAction, SetUpEnd, SetUpRow};
use unfinished::{Unfinished, UnfinishedEnd};

/// What keys do in a class round.
#[derive(Debug, Clone, Copy, PartialEq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum ClassAction {
    /// set up the round
    SetUp(SetUpAction),
    /// choose an earlier round
    Earlier(KeptAction),
    /// continue the interrupted round, or begin another
    Unfinished(ListAction),
    /// manage the pupils on their own devices
    Hosting(HostingAction),
    /// go on
    Forward,
    /// go back one step
    Backward,
    /// go to the previous or next question, where you left it
    Leap(isize),
    /// go to the previous or next page
    TurnPage(isize),
    /// choose a team, or go on
    Teams(ListAction),
    /// let this team enter or correct its vote
    Team(usize),
    /// take back the team's vote
    TakeBack,
    /// vote
    Vote(AnswerAction),
    /// leave the vote unchanged
    NotYet,
    /// show or hide what is typed
    ShowTyped,
    /// watch the collision
    Watch(WatchAction),
    /// blank the screen; press the key again to return
    Pause,
    /// switch between dark on light, for a projector, and light on dark
    Light,
    /// enter the counts
    Count,
    /// go straight to the shot, if there is little to discuss
    ToTheShot,
    /// show a one-minute countdown, or add half a minute
    Countdown,
    /// show the question's words alone, as large as they fit
    WordsAlone,
    /// show pupils' names on the scoreboard, or what each question showed
    BoardNames,
    /// write two tables for a spreadsheet: answers and questions
    Tables,
    /// turn the page, or scroll
    Scroll(i16),
    /// go back, or leave the round
    Leave,
}

/// A round for a class round one screen.
#[derive(Debug, Clone)]
pub(crate) struct Class {
    scene: ClassScene,
    /// Whether the screen is blank until someone goes on.
    paused: bool,
}

/// What is on the screen.
#[derive(Debug, Clone)]
enum ClassScene {
    SetUp(Box<SetUp>),
    Earlier(Box<EarlierRounds>),
    Unfinished(Box<Unfinished>),
    Play(Box<ClassPlay>),
}

impl Class {
    /// The page on which a round is set up, with what is known of it already.
    pub(crate) fn new(code: Option<&Code>, teams: &[String], name: &str, cx: &Context) -> Self {
        let set_up = SetUp::new(code, teams, name, Arc::clone(&cx.own));
        Self {
            scene: ClassScene::SetUp(Box::new(set_up)),
            paused: false,
        }
    }

    /// A round on devices of their own: one that was stopped, if the teacher wants that, or
    /// another one.
    pub(crate) fn with_devices(code: Option<&Code>, name: &str, cx: &mut Context) -> Self {
        let unfinished = Unfinished::ask(code.cloned(), name, cx);
        Self {
            scene: ClassScene::Unfinished(Box::new(unfinished)),
            paused: false,
        }
    }

    /// Goes on from a round that was stopped; another one begins at once if its code is known.
    fn after_unfinished(&mut self, end: Option<UnfinishedEnd>, cx: &mut Context) {
        let ClassScene::Unfinished(unfinished) = &self.scene else {
            return;
        };
        self.scene = match (end, unfinished.other()) {
            (None, _) => return,
            (Some(UnfinishedEnd::TakeUp(play)), _) => ClassScene::Play(play),
            (Some(UnfinishedEnd::Another), (Some(code), name)) => {
                let round = ClassRound::with_devices(code.clone()).of_class(name);
                ClassScene::Play(Box::new(ClassPlay::new(round, cx)))
            }
            (Some(UnfinishedEnd::Another), (None, name)) => {
                let mut set_up = SetUp::new(None, &[], name, Arc::clone(&cx.own));
                set_up.put(SetUpRow::Devices);
                ClassScene::SetUp(Box::new(set_up))
            }
        };
    }

    fn set_up(&mut self, outcome: Outcome<SetUpEnd>, cx: &mut Context) -> Next {
        match outcome {
            Outcome::Ignored => return Next::Ignored,
            Outcome::Used => {}
            Outcome::Done(SetUpEnd::Start(play)) => self.scene = ClassScene::Play(play),
            Outcome::Done(SetUpEnd::Earlier) => {
                if let ClassScene::SetUp(set_up) = &self.scene {
                    let earlier = EarlierRounds::ask(*set_up.clone(), cx);
                    self.scene = ClassScene::Earlier(Box::new(earlier));
                }
            }
        }
        Next::Stay
    }

    fn leave(&mut self, cx: &mut Context) -> Next {
        match &mut self.scene {
            ClassScene::SetUp(_) | ClassScene::Unfinished(_) => Next::Back,
            ClassScene::Earlier(earlier) => {
                self.scene = ClassScene::SetUp(Box::new(earlier.set_up.clone()));
                Next::Stay
            }
            ClassScene::Play(play) if !play.asks_before_leaving() => {
                play.leave(cx);
                Next::Back
            }
            ClassScene::Play(play) => {
                let what = match play.unsaved {
                    true => "It cannot be saved: it is lost then. e writes its tables.",
                    false => "After that it is kept, to be taken up again.",
                };
                Next::Confirm(Confirmation::new(
                    format!("Leave the round? {what}"),
                    "leave the round",
                    "stay",
                ))
            }
        }
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        match &mut self.scene {
            _ if self.paused => Next::Ignored,
            ClassScene::Earlier(earlier) => earlier.mouse(mouse, cx),
            // Their views take it.
            ClassScene::SetUp(_) | ClassScene::Unfinished(_) => Next::Ignored,
            ClassScene::Play(play) if play.host_page.is_some() => Next::Ignored,
            ClassScene::Play(play) => {
                let (room, look) = (cx.room(), cx.settings.look());
                if let Some(action) = view::meant_by(play, mouse, room, &look) {
                    return self.act(action, cx);
                }
                let step = play.step_view(room, &look);
                let picture = step.map(|step| step.picture());
                Next::after(picture.is_some_and(|picture| play.point(mouse, picture)))
            }
        }
    }
}

impl Screen for Class {
    type Action = ClassAction;

    fn title(&self) -> String {
        "class".into()
    }

    fn place(&self, _cx: &Context) -> Place {
        Place::Class {
            code: match &self.scene {
                ClassScene::Play(play) => Some(play.round().code().clone()),
                _ => None,
            },
            teams: Vec::new(),
            name: String::new(),
        }
    }

    fn status(&self, _cx: &Context) -> String {
        match &self.scene {
            ClassScene::Play(play) if !self.paused => {
                let of = play.round().questions().len();
                let place = format!("question {} of {of}", play.number() + 1);
                match play.step().vote().filter(|_| !play.is_over()) {
                    // Whoever has the code could play the round first.
                    Some(vote) if play.session.is_hosted() => {
                        format!("{place}  {}", play.session.turnout(vote))
                    }
                    None if play.session.is_hosted() => place,
                    _ => format!("{place}  code {}", play.round().code()),
                }
            }
            _ => String::new(),
        }
    }

    fn keys(&self, _cx: &Context) -> KeyTable<ClassAction> {
        use ClassAction::{Earlier, Leave, Pause, SetUp};
        let keys = KeyTable::new("class");
        match &self.scene {
            _ if self.paused => keys.on('p', Pause, "go on").or([(Key::Escape, Pause)]),
            ClassScene::SetUp(set_up) => {
                let keys = keys.with(set_up.keys(), SetUp);
                keys.on(Key::Escape, Leave, "back")
            }
            ClassScene::Earlier(earlier) => {
                let keys = keys.with(earlier.rounds.keys("take it up"), Earlier);
                keys.on(Key::Escape, Leave, "back")
            }
            ClassScene::Unfinished(unfinished) => {
                let keys = keys.with(unfinished.keys(), ClassAction::Unfinished);
                keys.on(Key::Escape, Leave, "back")
            }
            ClassScene::Play(play) => play.keys(),
        }
    }

    fn about(&self, _cx: &Context) -> Vec<&'static str> {
        vec![
            "You need one laptop and one projector. Up to eight teams share the keyboard, or everyone uses their own phone or laptop. Each question has the same steps: you read it out; everyone predicts in silence; the teams enter their first vote; all see how many voted for each answer, and discuss; the teams may change their votes; then come the shot, the explanation and the scores.",
            "Let every team write down its answer in silence: then nobody copies from the team that types first.",
            "Rims are smooth unless a question says otherwise. A question gives up to ten points, depending on how close the last vote is. There are no timers, and speed does not matter.",
            "carrom saves after each vote. You can leave when the bell rings and continue the round another day.",
        ]
    }

    fn typed(&mut self, key: Key, _cx: &mut Context) -> bool {
        match &mut self.scene {
            ClassScene::SetUp(set_up) => set_up.typed(key),
            ClassScene::Play(play) if !self.paused => play.typed(key),
            _ => false,
        }
    }

    fn act(&mut self, action: ClassAction, cx: &mut Context) -> Next {
        match (action, &mut self.scene) {
            (ClassAction::Pause, _) => self.paused = !self.paused,
            (ClassAction::Light, _) => {
                cx.settings.palette = match cx.settings.palette {
                    Palette::Light => Palette::Dark,
                    Palette::Dark | Palette::Mono => Palette::Light,
                };
            }
            (ClassAction::Leave, _) => return self.leave(cx),
            (ClassAction::Hosting(action), ClassScene::Play(play)) => {
                let page = play.host_page.as_mut();
                let asked = page.and_then(|it| it.confirmation(action, &play.session));
                if let Some(words) = asked {
                    return Next::Confirm(Confirmation::new(words, "yes", "no"));
                }
                play.host(action, cx);
            }
            (ClassAction::SetUp(action), ClassScene::SetUp(set_up)) => {
                let outcome = set_up.act(action, cx);
                return self.set_up(outcome, cx);
            }
            (ClassAction::Earlier(action), ClassScene::Earlier(earlier)) => {
                return earlier.rounds.act(action, cx);
            }
            (ClassAction::Unfinished(action), ClassScene::Unfinished(unfinished)) => {
                let end = unfinished.act(action, cx);
                self.after_unfinished(end, cx);
            }
            (ClassAction::Scroll(rows), ClassScene::Play(play)) => {
                view::scroll(play, rows, cx.room(), &cx.settings.look());
            }
            (action, ClassScene::Play(play)) => play.act(action, cx),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn confirmed(&mut self, action: ClassAction, cx: &mut Context) -> Next {
        match (&mut self.scene, action) {
            (ClassScene::Earlier(earlier), _) => {
                earlier.rounds.remove(cx);
                Next::Stay
            }
            (ClassScene::Play(play), ClassAction::Hosting(action)) => {
                play.host(action, cx);
                Next::Stay
            }
            (ClassScene::Play(play), _) => {
                play.leave(cx);
                Next::Back
            }
            _ => Next::Back,
        }
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match (input, &mut self.scene) {
            (Input::Mouse(mouse), _) => return self.mouse(mouse, cx),
            (Input::Paste(text), ClassScene::SetUp(set_up)) => set_up.paste(text),
            (Input::Kept(answer), ClassScene::Earlier(earlier)) => {
                if let Some(play) = earlier.take_answer(answer, cx) {
                    self.scene = ClassScene::Play(play);
                }
            }
            (Input::Kept(answer), ClassScene::Unfinished(unfinished)) => {
                let end = unfinished.take_answer(answer, cx);
                self.after_unfinished(end, cx);
            }
            (Input::Kept(answer), ClassScene::Play(play)) => play.take_answer(answer, cx),
            (Input::Hosted(news), ClassScene::Play(play)) => play.take_news(news, cx),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        let by = ListAction::Choose(by.into());
        match &self.scene {
            ClassScene::SetUp(_) => self.act(ClassAction::SetUp(SetUpAction::List(by)), cx),
            ClassScene::Unfinished(_) => self.act(ClassAction::Unfinished(by), cx),
            ClassScene::Play(_) => self.act(ClassAction::Hosting(HostingAction::List(by)), cx),
            ClassScene::Earlier(_) => Next::Ignored,
        }
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

    fn view<'s>(&'s self, _cx: &'s Context) -> Option<View<'s, ClassAction>> {
        match &self.scene {
            _ if self.paused => None,
            ClassScene::SetUp(set_up) => Some(set_up_view::view(set_up)),
            ClassScene::Unfinished(unfinished) => Some(unfinished.view()),
            ClassScene::Play(play) => {
                let panel = view::panel(play)?;
                Some(View::alone(
                    |room| SplitLayout::text_of(room, WIDEST),
                    panel,
                ))
            }
            _ => None,
        }
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        match &self.scene {
            _ if self.paused => view::paused(area, buf, &look),
            ClassScene::Earlier(earlier) => earlier.draw(area, buf, &look),
            // Their views draw them.
            ClassScene::SetUp(_) | ClassScene::Unfinished(_) => {}
            ClassScene::Play(play) => view::draw(play, cx.room(), buf, &look),
        }
    }
}

//! Playing a level: set the shot, predict the paths after the first collision, watch, and see the
//! result.

mod board;
mod dials;
mod made_shot;
mod view;

use std::time::Duration;

use ratatui::layout::Rect;

use crate::levels::{Level, Patience};
use crate::messages::{Key, Mouse, MouseKind};
use crate::physics::Shot;
use crate::quiz::Ray;
use crate::screens::levels::words;
use crate::screens::{Context, Next, Route, Screen, SharedAction, StrikeGuard, View};
use crate::widgets::hit::point_at;
use crate::widgets::input::{FormAction, KeyTable, RayAction, SettingsForm};
use crate::widgets::replay::{ShotAction, ShotImpact, impacts};
use crate::widgets::{Outcome, RayInput};

use dials::Dials;
use made_shot::MadeShot;

#[derive(Debug, Clone)]
pub(crate) struct LevelPlay {
    /// The number of the level on the shelf, counted from 0.
    number: usize,
    dials: Dials,
    /// The form; the keys change the dial that is selected in it.
    form: SettingsForm,
    /// The number of hints shown so far.
    hints: usize,
    /// The number of shots since the level was opened.
    shots: u32,
    /// The results of the earlier shots, the latest last.
    earlier: Vec<EarlierShot>,
    phase: LevelPhase,
    /// Why the last shot could not be played.
    trouble: Option<String>,
    guard: StrikeGuard,
}

#[derive(Debug, Clone)]
enum LevelPhase {
    /// Setting the shot.
    Aim,
    /// Predicting the paths after the first collision.
    Predict(Box<PendingShot>),
    Watch(Box<MadeShot>),
}

/// The summary of a shot that was made.
#[derive(Debug, Clone, PartialEq, Eq)]
struct EarlierShot {
    /// The number of the shot, counted from 1.
    number: u32,
    set: String,
    /// The result in short: the first goal that was missed or, if none was, the first goal.
    watched: String,
}

/// The next shot, and the prediction being entered for its first impact.
#[derive(Debug, Clone)]
struct PendingShot {
    rays: RayInput,
    shot: Shot,
    impact: ShotImpact,
}

/// What the keys do in a level.
#[derive(Debug, Clone, Copy, PartialEq, strum::IntoStaticStr, strum::EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum LevelAction {
    /// go on: predict where the discs will go, or shoot
    Go,
    /// set the shot
    Set(FormAction),
    /// restore the level's initial aim
    Reset,
    /// show a hint; press again for the next one
    Hint,
    /// show me a shot that wins; it earns no star
    ShowMe,
    /// predict first, or just shoot
    Predict,
    /// predict where a disc will go
    Say(RayAction),
    /// watch the shot
    Watch(ShotAction),
    /// go to the next level
    NextLevel,
    /// go back to aiming
    AimAgain,
    /// go back
    Back,
}

impl LevelPlay {
    /// The level with this number; `None` if there is no such level.
    pub(crate) fn new(number: usize, cx: &mut Context) -> Option<Self> {
        let (_, level) = cx.shelf.get(number)?;
        let dials = Dials::new(level.clone());
        cx.shelf.at = number;
        Some(Self {
            number,
            dials,
            form: SettingsForm::default(),
            hints: 0,
            shots: 0,
            earlier: Vec::new(),
            phase: LevelPhase::Aim,
            trouble: None,
            guard: StrikeGuard::default(),
        })
    }

    fn level(&self) -> &Level {
        &self.dials.level
    }

    /// Whether the picture shows one impact, not the whole board.
    fn is_enlarged(&self) -> bool {
        match &self.phase {
            LevelPhase::Aim => false,
            LevelPhase::Predict(_) => true,
            LevelPhase::Watch(made) => made.player.zoom().is_some(),
        }
    }

    /// The rays of an impact that the player has to predict.
    fn asks(&self, impact: &ShotImpact) -> impl Iterator<Item = Ray> {
        let asked = impact
            .discs
            .map(|disc| self.level().say_first.contains(&disc));
        let both = Ray::BOTH.into_iter().zip(asked);
        both.filter_map(|(ray, asked)| asked.then_some(ray))
    }

    /// Goes from aiming to predicting, or to the shot if there is nothing to predict.
    fn go(&mut self, cx: &mut Context) {
        let scene = self.level().aimed(&self.dials.aim);
        let shot = match scene.play(Patience::AKey) {
            Ok(shot) => shot,
            Err(error) => {
                self.trouble = Some(format!("This shot cannot be played: {error}."));
                return;
            }
        };
        self.trouble = None;
        let first = impacts(&shot, scene.stroke.disc).next();
        let asked = first.map(|impact| self.asks(&impact).collect::<Vec<_>>());
        let asked = asked.unwrap_or_default();
        if let (Some(impact), true, false) = (first, cx.settings.predict, asked.is_empty()) {
            let both = RayInput::new(impact.collision.side());
            let rays = match asked.as_slice() {
                [one] => both.only(*one),
                _ => both,
            };
            let pending = PendingShot { rays, shot, impact };
            self.phase = LevelPhase::Predict(Box::new(pending));
        } else {
            self.shoot(shot, !asked.is_empty(), None, cx);
        }
    }

    fn shoot(&mut self, shot: Shot, to_say: bool, said: Option<RayInput>, cx: &mut Context) {
        self.shots += 1;
        let mut made = self.made(shot, to_say, said, cx);
        made.record_said(self.number, cx);
        made.keep_if_watched(self.number, cx);
        self.phase = LevelPhase::Watch(Box::new(made));
    }

    fn made(&self, shot: Shot, to_say: bool, said: Option<RayInput>, cx: &Context) -> MadeShot {
        let watched = (cx.settings.watch_rate, cx.settings.reduced_motion);
        let count = (self.shots, self.hints);
        MadeShot::new(self.level(), shot, count, to_say, said, watched)
    }

    /// Plays the stored solution, without changing the player's own aim.
    fn show(&mut self, cx: &Context) {
        let solution = self.level().aimed(&self.level().solution);
        if let Ok(shot) = solution.play(Patience::AKey) {
            self.form.give_up();
            let made = self.made(shot, false, None, cx).shown();
            self.phase = LevelPhase::Watch(Box::new(made));
        }
    }

    /// The key for the next hint or, after the last one, for the solution.
    fn hint_key(&self) -> (LevelAction, &'static str) {
        match self.hints < self.level().hints.len() {
            true => (LevelAction::Hint, "hint"),
            false => (LevelAction::ShowMe, "show me"),
        }
    }

    fn next_level(&self, cx: &Context) -> Next {
        let number = self.number + 1;
        if number < cx.shelf.count() {
            Next::Replace(Route::Level { number })
        } else {
            Next::Back
        }
    }
}

impl Screen for LevelPlay {
    type Action = LevelAction;

    const HELP: &'static str = include_str!("help.txt");

    fn title(&self) -> String {
        self.level().title.clone()
    }

    fn route(&self, _cx: &Context) -> Route {
        Route::Level {
            number: self.number,
        }
    }

    fn status(&self, cx: &Context) -> String {
        let place = format!("level {} of {}", self.number + 1, cx.shelf.count());
        match cx.shelf.stars(self.number) {
            0 => place,
            stars => format!("{place}   {}", words::stars(stars)),
        }
    }

    fn keys(&self, cx: &Context) -> KeyTable<LevelAction> {
        use LevelAction::{AimAgain, Back, Go, NextLevel, Predict, Reset};
        let table = KeyTable::new("level");
        let (hint, hint_name) = self.hint_key();
        match &self.phase {
            LevelPhase::Aim => {
                let says = !self.level().say_first.is_empty();
                let go = match says && cx.settings.predict {
                    true => "predict",
                    false => "shoot",
                };
                let form = self
                    .form
                    .keys(&self.dials)
                    .without_keys(&[Key::PageUp, Key::PageDown]);
                table
                    .on(Key::Enter, Go, go)
                    .or([(Key::Char(' '), Go)])
                    .when(!self.form.is_typing())
                    .with(form, LevelAction::Set)
                    .on(Key::Char('h'), hint, hint_name)
                    .on(Key::Escape, Back, "back")
                    .when(!self.form.is_typing())
                    .on(Key::Char('r'), Reset, "")
                    .on(Key::Char('p'), Predict, "")
                    .when(says)
            }
            LevelPhase::Predict(pending) => table
                .with(pending.rays.keys("next, then shoot"), LevelAction::Say)
                .on(Key::Escape, AimAgain, "back"),
            LevelPhase::Watch(made) if made.player.zoom().is_some() => {
                table.with(made.player.keys(), LevelAction::Watch)
            }
            LevelPhase::Watch(made) => {
                let end = LevelAction::Watch(ShotAction::Seek(f64::INFINITY));
                let (watched, won) = (made.watched, made.win.is_some());
                let again = match made.is_shown {
                    true => "try it",
                    false => "try again",
                };
                table
                    .on(Key::Enter, NextLevel, "next level")
                    .or([' ', 'n'].map(|key| (key, NextLevel)))
                    .when(watched && won)
                    .on(Key::Enter, AimAgain, again)
                    .or([(' ', AimAgain)])
                    .when(watched && !won)
                    .on(Key::Char('h'), hint, hint_name)
                    .when(watched && !won && !made.is_shown)
                    .with(made.player.keys(), LevelAction::Watch)
                    .on(Key::Escape, AimAgain, "aim")
                    .on(Key::Enter, end, "")
                    .when(!watched)
            }
        }
    }

    fn act(&mut self, action: LevelAction, cx: &mut Context) -> Next {
        if action != LevelAction::Go {
            self.guard.release();
        }
        match (&mut self.phase, action) {
            (_, LevelAction::Go) if !self.guard.allows() => {}
            (_, LevelAction::Go) => self.go(cx),
            (_, LevelAction::Set(action)) => self.form.act(action, &mut self.dials),
            (_, LevelAction::Reset) => {
                self.form.give_up();
                self.dials.reset();
            }
            (_, LevelAction::Hint) => {
                self.hints = (self.hints + 1).min(self.level().hints.len());
                return Next::Shared(SharedAction::Scroll(i16::MAX));
            }
            (_, LevelAction::ShowMe) => self.show(cx),
            (_, LevelAction::Predict) => cx.settings.predict ^= true,
            (LevelPhase::Predict(pending), LevelAction::Say(action)) => {
                if pending.rays.act(action) == Outcome::Done(()) {
                    let PendingShot { rays, shot, .. } = (**pending).clone();
                    self.shoot(shot, true, Some(rays), cx);
                }
            }
            (LevelPhase::Watch(made), LevelAction::Watch(action)) => {
                made.watch(action, self.number, cx);
            }
            (_, LevelAction::NextLevel) => return self.next_level(cx),
            (phase, LevelAction::AimAgain) => {
                self.guard = StrikeGuard::default();
                if let LevelPhase::Watch(made) = std::mem::replace(phase, LevelPhase::Aim)
                    && !made.is_shown
                {
                    made.keep(self.number, cx);
                    let watched = made.in_short().map(|watched| EarlierShot {
                        number: self.shots,
                        set: self.dials.setting(),
                        watched,
                    });
                    self.earlier.extend(watched);
                }
            }
            (_, LevelAction::Back) => return Next::Back,
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn point(&mut self, mouse: &Mouse, picture: Rect, cx: &mut Context) -> Next {
        let pressed = mouse.kind == MouseKind::Down;
        if !mouse.is_held() || !picture.contains(mouse.cell().into()) {
            return Next::Ignored;
        }
        self.guard.release();
        match &mut self.phase {
            LevelPhase::Aim => {
                let view = board::view(&self.dials.level, picture);
                let (at, near) = (view.to_world(mouse.place()), view.per_row());
                self.dials.drag(&mut self.form, at, near, pressed);
            }
            LevelPhase::Predict(pending) => {
                let (collision, rays) = (&pending.impact.collision, &mut pending.rays);
                point_at(picture, collision, rays, mouse.place(), pressed);
            }
            LevelPhase::Watch(made) => match made.player.clicked().filter(|_| pressed) {
                Some(action) => made.watch(action, self.number, cx),
                None => return Next::Ignored,
            },
        }
        Next::Stay
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        self.guard.release();
        match &mut self.phase {
            LevelPhase::Aim => self.dials.wheel(&mut self.form, f64::from(-by)),
            LevelPhase::Predict(_) => return Next::Ignored,
            LevelPhase::Watch(made) => {
                if let Some(action) = made.player.wheel(by) {
                    made.watch(action, self.number, cx);
                }
            }
        }
        Next::Stay
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        self.guard.advance(passed);
        if let LevelPhase::Watch(made) = &mut self.phase {
            made.player.advance(passed, cx.settings.pace());
            made.keep_if_watched(self.number, cx);
        }
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        match &self.phase {
            LevelPhase::Aim => self.guard.wake(),
            LevelPhase::Predict(_) => None,
            LevelPhase::Watch(made) => made.player.wake(cx.settings.pace()),
        }
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, LevelAction> {
        view::view(self, cx)
    }
}

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
use crate::widgets::input::{FormAction, KeyTable, RayAction, SettingsForm};
use crate::widgets::replay::{ImpactPrediction, ShotAction, ShotImpact, impacts};
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
    /// The earlier shots, the latest last: what was set, and the result in brief.
    earlier: Vec<[String; 2]>,
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

/// The next shot, and the prediction being entered for its first impact.
#[derive(Debug, Clone)]
struct PendingShot {
    prediction: ImpactPrediction,
    shot: Shot,
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

    /// The prediction that the level requires for an impact, if it requires one.
    fn asked(&self, impact: ShotImpact) -> Option<ImpactPrediction> {
        let both = RayInput::new(impact.collision.side());
        let say_first = &self.level().say_first;
        let rays = match impact.discs.map(|disc| say_first.contains(&disc)) {
            [true, true] => both,
            [true, false] => both.only(Ray::Striker),
            [false, true] => both.only(Ray::Target),
            [false, false] => return None,
        };
        Some(ImpactPrediction { impact, rays })
    }

    /// Goes from aiming to predicting, or to the shot if there is nothing to predict.
    fn go(&mut self, cx: &mut Context) {
        let scene = self.level().aimed(&self.dials.aim);
        let played = scene.play(Patience::AKey);
        let error = played.as_ref().err();
        self.trouble = error.map(|error| format!("This shot cannot be played: {error}."));
        let Ok(shot) = played else {
            return;
        };
        let first = impacts(&shot, scene.stroke.disc).next();
        match first.and_then(|impact| self.asked(impact)) {
            Some(prediction) if cx.settings.predict => {
                let pending = PendingShot { prediction, shot };
                self.phase = LevelPhase::Predict(Box::new(pending));
            }
            asked => self.shoot(shot, asked.is_some(), None, cx),
        }
    }

    fn shoot(&mut self, shot: Shot, to_say: bool, said: Option<RayInput>, cx: &mut Context) {
        self.shots += 1;
        let mut made = MadeShot::new(self, shot, to_say, said, cx);
        if let Some(attempt) = made.attempt(self.number, cx) {
            cx.record(attempt);
        }
        made.keep_if_watched(self.number, cx);
        self.phase = LevelPhase::Watch(Box::new(made));
    }

    /// Goes back to aiming; lists a shot that the player has made, and saves a win.
    fn aim_again(&mut self, cx: &mut Context) {
        self.guard = StrikeGuard::default();
        if let LevelPhase::Watch(made) = std::mem::replace(&mut self.phase, LevelPhase::Aim)
            && !made.is_shown
        {
            made.keep(self.number, cx);
            let set = format!("shot {}: {}", self.shots, self.dials.setting());
            self.earlier
                .extend(made.in_short().map(|result| [set, result]));
        }
    }

    /// Plays the stored solution, without changing the player's own aim.
    fn show(&mut self, cx: &mut Context) {
        self.aim_again(cx);
        let solution = self.level().aimed(&self.level().solution);
        if let Ok(shot) = solution.play(Patience::AKey) {
            self.form.give_up();
            let mut made = MadeShot::new(self, shot, false, None, cx);
            (made.win, made.is_shown) = (None, true);
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
            Next::Replace(Route::Level(number))
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
        Route::Level(self.number)
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
                let form = self.form.keys(&self.dials);
                let form = form.without_keys(&[Key::PageUp, Key::PageDown]);
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
            LevelPhase::Predict(pending) => {
                let keys = pending.prediction.rays.keys("next, then shoot");
                table
                    .with(keys, LevelAction::Say)
                    .on(Key::Escape, AimAgain, "back")
            }
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
                if pending.prediction.rays.act(action) == Outcome::Done(()) {
                    let PendingShot { prediction, shot } = (**pending).clone();
                    self.shoot(shot, true, Some(prediction.rays), cx);
                }
            }
            (LevelPhase::Watch(made), LevelAction::Watch(action)) => {
                made.watch(action, self.number, cx);
            }
            (_, LevelAction::NextLevel) => return self.next_level(cx),
            (_, LevelAction::AimAgain) => self.aim_again(cx),
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
                pending.prediction.point(mouse, picture);
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

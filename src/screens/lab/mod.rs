//! The lab: set up one glancing collision, predict where both discs will go, and watch the
//! collision.

mod field;
mod mystery;
mod notebook;
mod pieces;
mod view;

use std::time::Duration;

use ratatui::layout::Rect;

use super::{Context, Next, Route, Screen, Settings, View};
use crate::messages::{Input, Key, Mouse, MouseKind, PlayerAction};
use crate::physics::{CollisionSpec, Frame};
use crate::progress::{NotedHit, Observation, ObservationPlace};
use crate::quiz::{Rays, RaysGrade};
use crate::widgets::hit::{
    Markings, Sighting, SightingAction, Watch, WatchAction, drag_offset, point_at,
};
use crate::widgets::input::{
    CollisionField, EntryAction, FormAction, FormFields, KeyTable, RayAction, SettingsForm,
};
use crate::widgets::{Outcome, RayInput};

use mystery::Mystery;
use notebook::{Notebook, NotebookAction};

pub(crate) use field::LabSettings;

#[derive(Debug, Clone, Default)]
pub(crate) struct Lab {
    settings: LabSettings,
    /// The form; the keys change the setting that is selected in it.
    form: SettingsForm,
    phase: LabPhase,
    /// Whether the picture shows the outcome of the settings at once.
    live: bool,
    /// Whether the set-up comes from a link or another screen and is not saved for the next visit.
    lent: bool,
    /// Whether the outcome is hidden, at the request of a link, until the player has predicted it.
    hidden: bool,
    /// What the player saw in the hit that is being explained, if carrom asked.
    observed: Option<Observation>,
}

#[derive(Debug, Clone, Default)]
enum LabPhase {
    /// Setting up the hit.
    #[default]
    Aim,
    /// Predicting where both discs will go.
    Predict(RayInput),
    /// Observing the hit after this prediction, without any explanation.
    See(Box<Sighting>, Rays),
    Watch(Box<Watch>),
    /// Looking at earlier hits.
    Notebook(Box<Notebook>),
}

/// What the keys do in the lab.
#[derive(Debug, Clone, Copy, PartialEq, strum::IntoStaticStr, strum::EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum LabAction {
    /// go on: predict where both will go, or shoot
    Go,
    /// set up the collision
    Set(FormAction),
    /// next set of pieces
    NextSet,
    /// choose discs that slip, or discs that stick together
    Contact,
    /// a mystery coin: find its mass from the two angles
    MysteryCoin,
    /// predict before each shot, or just watch
    Predict,
    /// live: the picture shows the outcome as you change the settings
    Live,
    /// restore the initial settings
    Reset,
    /// open the notebook: all your hits as a table, and as a plot
    OpenNotebook,
    /// look at the hits in the notebook
    Notebook(NotebookAction),
    /// predict where the two discs will go
    Say(RayAction),
    /// enter the mass of the mystery coin
    Weigh(EntryAction),
    /// watch without any explanation, and say what you saw
    See(SightingAction),
    /// watch the collision
    Watch(WatchAction),
    /// set up another shot
    SetUp,
    /// go back
    Back,
}

impl Lab {
    /// The lab with a collision set up, whose outcome may be hidden.
    pub(crate) fn of(setup: CollisionSpec, hidden: bool) -> Self {
        let mut lab = Self::default();
        lab.settings.setup = setup;
        lab.lent = true;
        lab.hidden = hidden;
        lab
    }

    /// The lab as it was left.
    pub(crate) fn resume(cx: &Context) -> Self {
        Self {
            settings: cx.lab.clone().unwrap_or_default(),
            ..Self::default()
        }
    }

    /// Whether the picture may be live: after enough correct predictions, and unless it would show
    /// the mass of a mystery coin or a hidden outcome.
    fn may_live(&self, cx: &Context) -> bool {
        cx.settings.predicted >= Settings::ENOUGH_PREDICTED
            && !self.settings.hides_mass()
            && !self.hidden
    }

    /// Whether a prediction is required before the shot.
    fn predicts(&self, cx: &Context) -> bool {
        self.hidden || cx.settings.predict && !self.is_live(cx)
    }

    fn is_live(&self, cx: &Context) -> bool {
        self.live && self.may_live(cx)
    }

    /// Goes from aiming to predicting, or to the shot if no prediction is required.
    fn go(&mut self, cx: &mut Context) {
        if self.predicts(cx) {
            let side = self.settings.setup.collision().side();
            self.phase = LabPhase::Predict(RayInput::new(side));
        } else {
            self.shoot(None, cx);
        }
    }

    fn shoot(&mut self, said: Option<Rays>, cx: &mut Context) {
        let collision = self.settings.setup.collision();
        let truth = Rays::from(&collision.outcome());
        if said.is_some_and(|said| RaysGrade::new(&said, &truth).is_right()) {
            cx.settings.predicted = Settings::ENOUGH_PREDICTED.min(cx.settings.predicted + 1);
        }
        if !self.settings.hides_mass() {
            let hit = NotedHit::new(self.settings.setup, said);
            let player = cx.settings.player.clone();
            cx.note(PlayerAction::NoteHit(player, Box::new(hit)));
        }
        self.hidden = false;
        self.observed = None;
        if let Some(said) = said
            && cx.settings.asks_what_is_seen()
        {
            let sighting = Sighting::new(collision, Markings::ALL, cx.settings.pace());
            self.phase = LabPhase::See(Box::new(sighting), said);
            return;
        }
        self.explain(said, cx);
    }

    /// Shows the collision with its explanation.
    fn explain(&mut self, said: Option<Rays>, cx: &Context) {
        let collision = self.settings.setup.collision();
        let watch = Watch::new(collision, said, cx.settings.pace());
        self.phase = LabPhase::Watch(Box::new(watch));
    }
}

/// Why the picture cannot be live.
fn not_live(settings: &LabSettings, predicted: u8) -> String {
    if settings.hides_mass() {
        return "The live picture would show the mass of the mystery coin.".into();
    }
    format!(
        "The live picture shows the answer. It opens after {} right predictions; you have {predicted}.",
        Settings::ENOUGH_PREDICTED
    )
}

impl Screen for Lab {
    type Action = LabAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "lab";

    fn route(&self, _cx: &Context) -> Route {
        match self.settings.hides_mass() {
            true => Route::Lab,
            false => Route::LabOf {
                setup: self.settings.setup,
                hidden: self.hidden,
            },
        }
    }

    fn status(&self, _cx: &Context) -> String {
        let setup = &self.settings.setup;
        let (m1, e) = (setup.m1_g, setup.restitution);
        let (name, m2) = match self.settings.hides_mass() {
            true => ("mystery coin", "?".to_owned()),
            false => (pieces::pieces_name(setup), setup.m2_g.to_string()),
        };
        format!("{name}: {m1} g on {m2} g   e = {e:.2}")
    }

    fn keys(&self, cx: &Context) -> KeyTable<LabAction> {
        use LabAction::{
            Back, Contact, Go, Live, MysteryCoin, NextSet, OpenNotebook, Predict, Reset, SetUp,
        };
        let key = Key::Char;
        let table = KeyTable::new("lab");
        let contact = self.settings.field(CollisionField::Contact);
        let go = if self.predicts(cx) {
            "predict"
        } else {
            "shoot"
        };
        match &self.phase {
            LabPhase::Aim => table
                .on(Key::Enter, Go, go)
                .or([(key(' '), Go)])
                .when(!self.form.is_typing())
                .with(self.form.keys(&self.settings), LabAction::Set)
                .on(key('s'), NextSet, "pieces")
                .on(key('b'), Contact, "slip/stick")
                .when(contact.locked.is_none())
                .on(key('m'), MysteryCoin, "mystery coin")
                .on(key('n'), OpenNotebook, "notebook")
                .when(!self.hidden)
                .on(key('v'), Live, if self.may_live(cx) { "live" } else { "" })
                .when(!self.hidden)
                .on(Key::Escape, Back, "back")
                .when(!self.form.is_typing())
                .on(key('p'), Predict, "")
                .when(!self.hidden)
                .on(key('r'), Reset, ""),
            LabPhase::Notebook(notebook) => {
                table
                    .with(notebook.keys(), LabAction::Notebook)
                    .on(Key::Escape, SetUp, "back")
            }
            LabPhase::Predict(rays) => table
                .with(rays.keys("next, then shoot"), LabAction::Say)
                .on(Key::Escape, SetUp, "back"),
            LabPhase::See(sighting, _) => {
                table
                    .with(sighting.keys(), LabAction::See)
                    .on(Key::Escape, SetUp, "set up")
            }
            LabPhase::Watch(watch) => {
                let weighing = watch.is_revealed() && watch.frame == Frame::Laboratory;
                let coin = self.settings.mystery.as_ref().filter(|_| weighing);
                let mass = coin.map_or(KeyTable::new("mystery"), Mystery::keys);
                let weighs = !mass.rows().is_empty();
                let is_layer = |action| weighs && matches!(action, WatchAction::ToggleLayer(_));
                table
                    .with(mass, LabAction::Weigh)
                    .on(key(' '), SetUp, "new shot")
                    .or([(Key::Enter, SetUp)])
                    .when(watch.clock().is_over())
                    .with(watch.keys().without(is_layer), LabAction::Watch)
                    .on(Key::Escape, SetUp, "set up")
                    .or([(key('n'), SetUp)])
                    .on(Key::Enter, LabAction::Watch(WatchAction::GoOn), "")
            }
        }
    }

    fn act(&mut self, action: LabAction, cx: &mut Context) -> Next {
        let may_live = self.may_live(cx);
        let (settings, form) = (&mut self.settings, &mut self.form);
        match (&mut self.phase, action) {
            (_, LabAction::Go) => self.go(cx),
            (_, LabAction::Set(action)) => form.act(action, settings),
            (_, LabAction::NextSet) => {
                form.commit(settings);
                settings.mystery = None;
                pieces::put_out_next(&mut settings.setup);
            }
            (_, LabAction::Contact) => {
                form.step_at(CollisionField::Contact as usize, 1.0, settings);
            }
            (_, LabAction::MysteryCoin) => {
                form.commit(settings);
                let coin = Mystery::put_out(&mut settings.setup, cx.next_seed());
                settings.mystery = Some(coin);
            }
            (_, LabAction::Predict) => cx.settings.predict ^= true,
            (_, LabAction::Live) if !may_live => {
                cx.notify(not_live(settings, cx.settings.predicted));
            }
            (_, LabAction::Live) => self.live ^= true,
            (_, LabAction::Reset) => {
                form.give_up();
                *settings = LabSettings::default();
            }
            (LabPhase::Predict(rays), LabAction::Say(action)) => {
                if rays.act(action) == Outcome::Done(()) {
                    let said = rays.said();
                    self.shoot(said, cx);
                }
            }
            (LabPhase::See(sighting, said), LabAction::See(action)) => {
                if let Outcome::Done(seen) = sighting.act(action) {
                    let said = *said;
                    let truth = Rays::from(&settings.setup.collision().outcome());
                    let rays = seen.map(|seen| [said, truth, seen]);
                    self.observed = rays.map(|rays| cx.observe(ObservationPlace::Lab, rays));
                    self.explain(Some(said), cx);
                }
            }
            (LabPhase::Watch(watch), LabAction::Watch(action)) => watch.act(action),
            (LabPhase::Watch(_), LabAction::Weigh(action)) => {
                settings.mystery.iter_mut().for_each(|it| it.act(action));
            }
            (_, LabAction::OpenNotebook) => {
                form.commit(settings);
                self.phase = LabPhase::Notebook(Box::new(Notebook::ask(cx)));
            }
            (LabPhase::Notebook(notebook), LabAction::Notebook(NotebookAction::Clear)) => {
                return notebook.ask_to_clear();
            }
            (LabPhase::Notebook(notebook), LabAction::Notebook(action)) => {
                if let Some(setup) = notebook.act(action, cx) {
                    *settings = LabSettings {
                        setup,
                        mystery: None,
                    };
                    self.phase = LabPhase::Aim;
                }
            }
            (_, LabAction::SetUp) => self.phase = LabPhase::Aim,
            (_, LabAction::Back) => {
                if !self.lent {
                    cx.lab = Some(settings.clone());
                }
                return Next::Back;
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn confirmed(&mut self, _cleared: LabAction, cx: &mut Context) -> Next {
        if let LabPhase::Notebook(notebook) = &mut self.phase {
            notebook.clear(cx);
        }
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match (input, &mut self.phase) {
            (Input::Kept(answer), LabPhase::Notebook(notebook)) => notebook.take(answer),
            (Input::Exported(exported), _) => cx.notify_of_export("table of your hits", exported),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, LabAction> {
        view::view(self, cx)
    }

    fn point(&mut self, mouse: &Mouse, picture: Rect, cx: &mut Context) -> Next {
        let pressed = mouse.kind == MouseKind::Down;
        if !mouse.is_held() || !picture.contains(mouse.cell().into()) {
            return Next::Ignored;
        }
        let hit = view::hit_area(self, picture, cx);
        let collision = self.settings.setup.collision();
        match &mut self.phase {
            LabPhase::Aim => {
                self.form.give_up();
                let offset = drag_offset(hit, &collision, mouse.place());
                let offset_mm = (offset * 2000.0).round() / 2.0;
                self.settings
                    .set(CollisionField::Offset as usize, offset_mm);
            }
            LabPhase::Predict(rays) => point_at(picture, &collision, rays, mouse.place(), pressed),
            LabPhase::Notebook(_) => return Next::Ignored,
            LabPhase::See(sighting, _) => sighting.point(picture, mouse.place(), pressed),
            LabPhase::Watch(_) if !pressed => return Next::Ignored,
            LabPhase::Watch(watch) if watch.clock().is_over() => self.phase = LabPhase::Aim,
            LabPhase::Watch(watch) => watch.act(WatchAction::GoOn),
        }
        Next::Stay
    }

    fn wheel(&mut self, by: i8, _cx: &mut Context) -> Next {
        match &mut self.phase {
            LabPhase::Aim => {
                let speed = CollisionField::Speed as usize;
                self.form.step_at(speed, f64::from(-by), &mut self.settings);
            }
            LabPhase::Predict(_) | LabPhase::See(..) => return Next::Ignored,
            LabPhase::Notebook(notebook) => notebook.choose(by.into()),
            LabPhase::Watch(watch) => watch.act(WatchAction::Step(-by)),
        }
        Next::Stay
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        match &mut self.phase {
            LabPhase::Watch(watch) => watch.advance(passed, cx.settings.pace()),
            LabPhase::See(sighting, _) => sighting.advance(passed, cx.settings.pace()),
            _ => {}
        }
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        match &self.phase {
            LabPhase::Watch(watch) => watch.wake(cx.settings.pace()),
            LabPhase::See(sighting, _) => sighting.wake(cx.settings.pace()),
            _ => None,
        }
    }
}

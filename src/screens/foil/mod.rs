//! The foil: one particle that passes a target, a beam of millions, and the counts of 1913.

mod beam_page;
mod cautions;
mod field;
mod guess;
mod measured_page;
mod plot;
mod run;
mod setup;
mod tracks_page;
mod view;
mod words;

use std::time::Duration;

use ratatui::layout::Rect;

use super::route::FoilPage;
use super::{Context, Next, Route, Screen, View};
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::quiz::Response;
use crate::widgets::input::{FormAction, KeyTable, SettingsForm};
use crate::widgets::{AnswerAction, AnswerInput, Outcome, svg};

pub(crate) use plot::{FoilFigure, FoilFigureAction};
pub(crate) use setup::FoilSetup;

use field::{FoilFields, OFFSET};
use run::BeamRun;
use setup::Obstacle::{Hard, Nucleus};

/// What the keys do at the foil.
#[derive(Debug, Clone, Copy, PartialEq, strum::IntoStaticStr, strum::EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum FoilAction {
    /// go to the next or previous page
    TurnPage(isize),
    /// open a page by its name
    Open(FoilPage),
    /// change a setting
    Set(FormAction),
    /// open the page for a whole beam of these particles
    WholeBeam,
    /// start a beam, let it continue, or start another
    Throw,
    /// stop the beam at once
    Stop,
    /// predict what will happen
    Guess(AnswerAction),
    /// cancel the beam
    LeaveGuess,
    /// show the counts on a logarithmic or a linear scale
    Scale,
    /// show the other plot of the same counts
    OtherPlot,
    /// export the plot as an SVG picture
    Export,
    /// predict before the beam starts, or just watch
    Predict,
    /// restore the initial settings
    Reset,
    /// go back
    Back,
}

#[derive(Debug, Clone, Default)]
pub(crate) struct FoilScreen {
    fields: FoilFields,
    /// The form; the keys change the setting that is selected in it.
    form: SettingsForm,
    /// The prediction before a beam, while the player is making it.
    guess: Option<AnswerInput>,
    /// The beam with the current settings, once it has been started.
    run: Option<Box<BeamRun>>,
    /// The number of earlier beams.
    runs: u64,
    /// Whether the player has switched away from the scale that is usual for this law.
    other_scale: bool,
    /// Whether the counts of 1913 are shown relative to the law.
    levelled: bool,
}

impl FoilScreen {
    /// The foil, opened at a page.
    pub(crate) fn at(page: FoilPage) -> Self {
        let mut foil = Self::default();
        foil.fields.page = page;
        foil
    }

    /// Whether counts are on a logarithmic scale, which is usual for a nucleus because its counts
    /// cover many powers of ten.
    fn is_log(&self) -> bool {
        (self.fields.setup.obstacle == Nucleus) != self.other_scale
    }

    fn is_running(&self) -> bool {
        let running = self.run.as_ref().is_some_and(|run| run.is_running());
        self.fields.page == FoilPage::Counts && running
    }

    /// Stops the beam, or continues it.
    fn halt(&mut self, halted: bool) {
        if let Some(run) = &mut self.run {
            run.halted = halted;
        }
    }

    /// Changes a setting, and discards the beam if the new settings require another one.
    fn edit(&mut self, how: impl FnOnce(&mut SettingsForm, &mut FoilFields)) {
        let before = self.fields.setup;
        how(&mut self.form, &mut self.fields);
        let after = &self.fields.setup;
        if after.law() != before.law() || after.particles_exponent != before.particles_exponent {
            (self.guess, self.run) = (None, None);
        }
    }

    /// Accepts a number that was typed but not confirmed with Enter.
    fn commit(&mut self) {
        self.edit(|form, fields| form.commit(fields));
    }

    fn turn_to(&mut self, page: FoilPage) {
        self.commit();
        self.halt(true);
        // The chosen setting remains chosen if the new page has it.
        let rows = self.fields.rows();
        let chosen = rows.get(self.form.selected(rows.len()));
        let chosen = chosen.map(|row| row.name);
        self.fields.page = page;
        let mut others = self.fields.rows().into_iter();
        let place = others.position(|row| Some(row.name) == chosen);
        self.form = SettingsForm::at(place.unwrap_or(0));
        self.guess = None;
    }

    fn turn_by(&mut self, pages: isize) {
        let next = (self.fields.page as isize + pages).rem_euclid(FoilPage::ALL.len() as isize);
        self.turn_to(FoilPage::ALL[next as usize]);
    }

    /// Starts a beam: continues a stopped one, or begins another, after a prediction if one is
    /// required.
    fn throw(&mut self, predict: bool, seed: u64) {
        self.commit();
        match &self.run {
            Some(run) if !run.is_over() => self.halt(false),
            None if predict => {
                self.guess = Some(AnswerInput::Choice {
                    chosen: None,
                    count: guess::CHOICES.len(),
                });
            }
            _ => self.begin(None, seed),
        }
    }

    /// Begins a beam of new particles; without a new prediction, the previous one remains valid.
    fn begin(&mut self, said: Option<f64>, seed: u64) {
        let said = said.or_else(|| self.run.as_ref()?.said);
        let seed = seed.wrapping_add(self.runs);
        self.runs = self.runs.wrapping_add(1);
        let (law, particles) = (self.fields.setup.law(), self.fields.setup.particles());
        let run = BeamRun::new(law, seed, particles, said);
        (self.guess, self.run) = (None, Some(Box::new(run)));
    }

    /// Computes the particles for the next frame. Their number does not depend on the time that has
    /// passed, so a slow frame does not make the next one slower.
    fn throw_on(&mut self) {
        if let Some(run) = &mut self.run {
            run.advance();
        }
    }

    fn export(&mut self, cx: &mut Context) {
        self.commit();
        let page = self.fields.page.name().replace(' ', "-");
        let look = cx.settings.look();
        let svg = svg::of_panel(view::title(self), &look, |area, _| {
            vec![view::picture(self, area, look)]
        });
        cx.export(format!("carrom-foil-{page}.svg"), svg);
    }

    /// Changes the particle's offset by `steps` times the step of the form.
    fn step_offset(&mut self, steps: i8) {
        self.edit(|_, fields| OFFSET.step(&mut fields.setup, steps.into()));
    }

    /// Handles the mouse over the picture of one particle: dragging it, or moving it step by step
    /// with the wheel; returns whether the mouse was used.
    fn move_particle(&mut self, mouse: &Mouse, picture: Rect) -> bool {
        match mouse.kind {
            MouseKind::ScrollUp => self.step_offset(1),
            MouseKind::ScrollDown => self.step_offset(-1),
            MouseKind::Down | MouseKind::Drag => {
                self.form.give_up();
                let offset = tracks_page::offset_at(picture, &self.fields.setup, mouse.cell());
                self.edit(|_, fields| OFFSET.set(&mut fields.setup, offset));
            }
            MouseKind::Up => return false,
        }
        true
    }
}

impl Screen for FoilScreen {
    type Action = FoilAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "foil";

    fn route(&self, _cx: &Context) -> Route {
        Route::Foil(self.fields.page)
    }

    fn status(&self, _cx: &Context) -> String {
        let setup = &self.fields.setup;
        let metal = setup.metal().name;
        match (self.fields.page, setup.obstacle) {
            (FoilPage::Measured, _) => "Geiger and Marsden, silver and gold".into(),
            (FoilPage::Tracks, Hard) => "a hard target".into(),
            (FoilPage::Counts, Hard) => format!("{}s", setup.obstacle_name()),
            (_, Nucleus) => format!("α-particles of {:.2} MeV on {metal}", setup.energy_mev),
        }
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Exported(exported) => {
                cx.notify_of_export("plot", exported);
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, _passed: Duration, _cx: &mut Context) {
        self.throw_on();
    }

    fn wake(&self, _cx: &Context) -> Option<Duration> {
        self.is_running().then_some(Duration::ZERO)
    }

    fn point(&mut self, mouse: &Mouse, picture: Rect, cx: &mut Context) -> Next {
        let pressed = mouse.kind == MouseKind::Down;
        if !picture.contains(mouse.cell().into()) {
            return Next::Ignored;
        }
        match self.fields.page {
            FoilPage::Tracks => return Next::after(self.move_particle(mouse, picture)),
            FoilPage::Counts if pressed && self.is_running() => self.halt(true),
            FoilPage::Counts if pressed && self.guess.is_none() => {
                self.throw(cx.settings.predict, cx.seed());
            }
            FoilPage::Measured if pressed => self.levelled = !self.levelled,
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn wheel(&mut self, by: i8, _cx: &mut Context) -> Next {
        match self.fields.page {
            FoilPage::Tracks => self.step_offset(-by),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, FoilAction> {
        view::view(self, cx)
    }

    fn keys(&self, _cx: &Context) -> KeyTable<FoilAction> {
        use FoilAction::{Back, Export, LeaveGuess, OtherPlot, Predict, Reset, Scale};
        use FoilAction::{Stop, Throw, TurnPage, WholeBeam};
        let table = KeyTable::new("foil");
        if self.is_running() {
            return table
                .on(Key::Escape, Stop, "stop the beam")
                .or([(Key::Enter, Stop), (Key::Char(' '), Stop)])
                .on('l', Scale, "scale")
                .on(Key::Tab, TurnPage(1), "next page")
                .or([(Key::BackTab, TurnPage(-1))]);
        }
        let typing = self.form.is_typing();
        // On this screen these keys turn pages and scroll.
        let own = [Key::Tab, Key::BackTab, Key::PageUp, Key::PageDown];
        if let Some(guess) = &self.guess {
            let keys = guess.keys().without_keys(&own);
            let keys = keys.renamed("predict and start", |action| action == AnswerAction::Enter);
            let keys = keys.renamed("", |action| matches!(action, AnswerAction::Choose(_)));
            return table
                .with(keys, FoilAction::Guess)
                .on(Key::Escape, LeaveGuess, "back")
                .on(Key::Tab, TurnPage(1), "")
                .or([(Key::BackTab, TurnPage(-1))]);
        }
        let form = || self.form.keys(&self.fields).without_keys(&own);
        let throw = match &self.run {
            _ if self.fields.page == FoilPage::Tracks => "a whole beam",
            None => "start the beam",
            Some(run) if run.is_over() => "another beam",
            Some(_) => "go on",
        };
        let table = match self.fields.page {
            FoilPage::Tracks => table
                .with(form(), FoilAction::Set)
                .on(Key::Enter, WholeBeam, throw)
                .or([(' ', WholeBeam)])
                .when(!typing),
            FoilPage::Counts => table
                .on(Key::Enter, Throw, throw)
                .or([(' ', Throw)])
                .when(!typing)
                .with(form(), FoilAction::Set)
                .on('l', Scale, "scale"),
            FoilPage::Measured => {
                let others = [Key::Left, Key::Right, Key::Char(' ')];
                table
                    .on(Key::Enter, OtherPlot, "the other plot")
                    .or(others.map(|key| (key, OtherPlot)))
            }
        };
        table
            .on(Key::Tab, TurnPage(1), "next page")
            .or([(Key::BackTab, TurnPage(-1))])
            .on(Key::Escape, Back, "back")
            .when(!typing)
            .on('e', Export, "export")
            .on('p', Predict, "")
            .on('r', Reset, "")
            .when(self.fields.page != FoilPage::Measured)
    }

    fn act(&mut self, action: FoilAction, cx: &mut Context) -> Next {
        match action {
            FoilAction::TurnPage(by) => self.turn_by(by),
            FoilAction::Open(page) => self.turn_to(page),
            FoilAction::Set(action) => self.edit(|form, fields| form.act(action, fields)),
            FoilAction::WholeBeam => self.turn_to(FoilPage::Counts),
            FoilAction::Throw => self.throw(cx.settings.predict, cx.seed()),
            FoilAction::Stop => self.halt(true),
            FoilAction::Guess(action) => {
                if let Some(guess) = &mut self.guess
                    && guess.act(action) == Outcome::Done(())
                    && let Some(Response::Choice(chosen)) = guess.said()
                {
                    let said = guess::CHOICES.get(chosen).map(|(_, share)| *share);
                    self.begin(said, cx.seed());
                }
            }
            FoilAction::LeaveGuess => self.guess = None,
            FoilAction::Scale => self.other_scale ^= true,
            FoilAction::OtherPlot => self.levelled ^= true,
            FoilAction::Export => self.export(cx),
            FoilAction::Predict => cx.settings.predict ^= true,
            FoilAction::Reset => self.edit(|form, fields| {
                form.give_up();
                fields.setup = FoilSetup::default();
            }),
            FoilAction::Back => return Next::Back,
        }
        Next::Stay
    }
}

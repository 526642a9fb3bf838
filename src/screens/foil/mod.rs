//! The foil: one particle past a target, a beam of millions, and what was counted in
//! 1913.

mod beam_page;
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

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Context, Help, Hint, Next, OldScreen};
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::widgets::{NumberEntry, Outcome, Scroll, svg};

pub(crate) use field::Field;
pub(crate) use plot::FoilFigure;
pub(crate) use setup::Setup;

use run::Run;
use setup::Obstacle::{Hard, Nucleus};

/// A page of the foil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Page {
    /// One particle, and some beside it.
    #[default]
    Tracks,
    /// A beam, counted by angle.
    Counts,
    /// Geiger and Marsden's counts.
    Measured,
}

impl Page {
    /// All pages, in their order.
    pub const ALL: [Self; 3] = [Self::Tracks, Self::Counts, Self::Measured];

    /// Its name on the tab.
    const fn name(self) -> &'static str {
        match self {
            Self::Tracks => "one particle",
            Self::Counts => "a beam",
            Self::Measured => "counted in 1913",
        }
    }
}

/// The foil.
#[derive(Debug, Clone, Default)]
pub(crate) struct Foil {
    setup: Setup,
    page: Page,
    /// The setting that keys change, and the number being typed for it.
    field: usize,
    entry: NumberEntry,
    /// How far the text of the page is scrolled.
    scroll: Scroll,
    /// The answer chosen among the guesses, while one is asked for.
    guess: Option<usize>,
    /// The beam, since the setting last changed.
    run: Option<Run>,
    /// Beams thrown before it.
    runs: u64,
    /// Whether counts are on the scale that is not the usual one for their law.
    other_scale: bool,
    /// Whether the counts of 1913 are shown as shares of the law.
    levelled: bool,
    /// Whether the last number typed was out of range, and held to it.
    held: bool,
}

impl Foil {
    /// The foil at one of its pages.
    pub(crate) fn at(page: Page) -> Self {
        Self {
            page,
            ..Self::default()
        }
    }

    fn fields(&self) -> &'static [Field] {
        Field::on(self.page, &self.setup)
    }

    /// The setting that keys change; `None` on a page without any.
    fn field(&self) -> Option<Field> {
        let fields = self.fields();
        let last = fields.len().checked_sub(1)?;
        fields.get(self.field.min(last)).copied()
    }

    /// Whether counts are on a logarithmic scale: usual for a nucleus, whose counts
    /// cover many powers of ten.
    fn is_log(&self) -> bool {
        (self.setup.obstacle == Nucleus) != self.other_scale
    }

    fn is_running(&self) -> bool {
        self.page == Page::Counts && self.run.as_ref().is_some_and(Run::is_running)
    }

    /// Stops the beam, or lets it go on.
    fn halt(&mut self, halted: bool) {
        if let Some(run) = &mut self.run {
            run.set_halted(halted);
        }
    }

    /// Changes the setting; a beam of another setting is no longer this one's.
    fn change(&mut self, change: impl FnOnce(&mut Setup)) {
        let before = self.setup;
        change(&mut self.setup);
        if self.setup.law() != before.law()
            || self.setup.particles_exponent != before.particles_exponent
        {
            self.run = None;
        }
        if self.setup != before {
            self.scroll = Scroll::default();
        }
    }

    fn commit_entry(&mut self) {
        if let Some(value) = self.entry.take() {
            self.set(value);
        }
    }

    /// Sets the chosen setting to a number that was typed.
    fn set(&mut self, value: f64) {
        if let Some(field) = self.field() {
            self.held = !field.allows(&self.setup, value);
            self.change(|setup| field.set(setup, value));
        }
    }

    fn choose(&mut self, field: usize) {
        self.commit_entry();
        self.field = field % self.fields().len().max(1);
    }

    fn step(&mut self, steps: f64) {
        self.commit_entry();
        if let Some(field) = self.field() {
            self.change(|setup| field.step(setup, steps));
        }
    }

    fn turn_to(&mut self, page: Page) {
        self.commit_entry();
        self.halt(true);
        // The setting that was chosen stays chosen, if the page has it.
        let chosen = self.field();
        self.page = page;
        let place = |field| self.fields().iter().position(|other| *other == field);
        self.field = chosen.and_then(place).unwrap_or(0);
        self.scroll = Scroll::default();
        self.guess = None;
    }

    fn turn_by(&mut self, pages: usize) {
        let here = Page::ALL.iter().position(|page| *page == self.page);
        let next = (here.unwrap_or(0) + pages) % Page::ALL.len();
        self.turn_to(Page::ALL[next]);
    }

    /// Throws a beam: lets a halted one go on, or begins another, after a guess if one is
    /// wanted.
    fn throw(&mut self, cx: &Context) {
        match &self.run {
            Some(run) if !run.is_over() => self.halt(false),
            Some(_) => self.begin(None, cx.seed()),
            None if cx.settings.predict => {
                self.guess = Some(guess::CHOICES.len() / 2);
                self.scroll = Scroll::default();
            }
            None => self.begin(None, cx.seed()),
        }
    }

    /// Begins a beam of new particles; what was said of the last one of its kind still
    /// stands.
    fn begin(&mut self, said: Option<f64>, seed: u64) {
        let said = said.or_else(|| self.run.as_ref().and_then(|run| run.said));
        let seed = seed.wrapping_add(self.runs);
        self.runs = self.runs.wrapping_add(1);
        let (law, particles) = (self.setup.law(), self.setup.particles());
        self.run = Some(Run::new(law, seed, particles, said));
        self.scroll = Scroll::default();
    }

    fn key(&mut self, key: Key, cx: &mut Context) -> Next {
        self.held = false;
        if self.is_running() {
            return self.running_key(key);
        }
        if let Some(chosen) = self.guess {
            return self.guess_key(chosen, key, cx);
        }
        if self.field().is_some_and(Field::is_number) {
            match self.entry.update(key) {
                Outcome::Used => return Next::Stay,
                Outcome::Done(value) => {
                    self.set(value);
                    return Next::Stay;
                }
                Outcome::Ignored => {}
            }
        }
        match key {
            Key::Tab => self.turn_by(1),
            Key::BackTab => self.turn_by(Page::ALL.len() - 1),
            Key::PageUp => self.scroll_by(-8, cx),
            Key::PageDown => self.scroll_by(8, cx),
            Key::Char('e' | 'E') => {
                self.commit_entry();
                let name = format!("carrom-foil-{}.svg", self.page.name().replace(' ', "-"));
                let look = cx.settings.look();
                let svg = svg::of_panel(view::title(self), &look, |area, _| {
                    vec![view::picture(self, area, look)]
                });
                cx.export(name, svg);
            }
            Key::Char('p' | 'P') => cx.settings.predict = !cx.settings.predict,
            _ if self.page == Page::Measured => return self.measured_key(key, cx),
            Key::Up => self.choose(self.field + self.fields().len() - 1),
            Key::Down => self.choose(self.field + 1),
            Key::Left => self.step(-1.0),
            Key::Right => self.step(1.0),
            Key::Char('r' | 'R') => {
                self.entry.take();
                self.change(|setup| *setup = Setup::default());
            }
            Key::Enter | Key::Char(' ') if self.page == Page::Counts => {
                self.commit_entry();
                self.throw(cx);
            }
            Key::Enter | Key::Char(' ') => self.turn_to(Page::Counts),
            Key::Char('l' | 'L') if self.page == Page::Counts => {
                self.other_scale = !self.other_scale;
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    /// Keys while a beam is under way: Escape stops it at once.
    fn running_key(&mut self, key: Key) -> Next {
        match key {
            Key::Escape | Key::Enter | Key::Char(' ') => self.halt(true),
            Key::Tab => self.turn_by(1),
            Key::BackTab => self.turn_by(Page::ALL.len() - 1),
            Key::Char('l' | 'L') => self.other_scale = !self.other_scale,
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn guess_key(&mut self, chosen: usize, key: Key, cx: &Context) -> Next {
        let count = guess::CHOICES.len();
        match key {
            Key::Up => self.guess = Some((chosen + count - 1) % count),
            Key::Down => self.guess = Some((chosen + 1) % count),
            Key::Enter | Key::Char(' ') => {
                self.guess = None;
                let said = guess::CHOICES.get(chosen).map(|choice| choice.share);
                self.begin(said, cx.seed());
            }
            Key::Escape => self.guess = None,
            Key::Tab => self.turn_by(1),
            Key::BackTab => self.turn_by(Page::ALL.len() - 1),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn measured_key(&mut self, key: Key, cx: &Context) -> Next {
        match key {
            Key::Up => self.scroll_by(-1, cx),
            Key::Down => self.scroll_by(1, cx),
            Key::Left | Key::Right | Key::Enter | Key::Char(' ') => self.levelled = !self.levelled,
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn scroll_by(&mut self, rows: i16, cx: &Context) {
        let area = view::FoilLayout::new(cx.body).beside.panel;
        let mut scroll = self.scroll;
        scroll.by(rows, area, cx.settings.look(), |lines| {
            view::write_panel(self, lines, cx);
        });
        self.scroll = scroll;
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &Context) -> Next {
        let layout = view::FoilLayout::new(cx.body);
        let cell = (mouse.column, mouse.row);
        let pressed = mouse.kind == MouseKind::Down;
        if pressed && let Some(page) = layout.tab_at(cell) {
            self.turn_to(page);
            return Next::Stay;
        }
        let in_panel = layout.beside.panel.contains(cell.into());
        if in_panel {
            match mouse.kind {
                MouseKind::ScrollUp => self.scroll_by(-1, cx),
                MouseKind::ScrollDown => self.scroll_by(1, cx),
                MouseKind::Down if !self.is_running() => {
                    let row = usize::from(layout.row_of_text(self, cell, cx));
                    if self.guess.is_some() {
                        match row.checked_sub(beam_page::GUESS_HEAD) {
                            Some(i) if i < guess::CHOICES.len() => self.guess = Some(i),
                            _ => return Next::Ignored,
                        }
                    } else if row < self.fields().len() {
                        self.choose(row);
                    }
                }
                _ => return Next::Ignored,
            }
            return Next::Stay;
        }
        if !layout.beside.picture.contains(cell.into()) {
            return Next::Ignored;
        }
        let held = pressed || mouse.kind == MouseKind::Drag;
        match self.page {
            Page::Tracks if held => {
                self.entry.take();
                let offset = tracks_page::offset_at(layout.beside.picture, &self.setup, cell);
                self.change(|setup| Field::Offset.set(setup, offset));
            }
            Page::Tracks => match mouse.kind {
                MouseKind::ScrollUp => self.change(|setup| Field::Offset.step(setup, 1.0)),
                MouseKind::ScrollDown => self.change(|setup| Field::Offset.step(setup, -1.0)),
                _ => return Next::Ignored,
            },
            Page::Counts if pressed && self.is_running() => return self.running_key(Key::Escape),
            Page::Counts if pressed && self.guess.is_none() => {
                self.commit_entry();
                self.throw(cx);
            }
            Page::Measured if pressed => self.levelled = !self.levelled,
            _ => return Next::Ignored,
        }
        Next::Stay
    }
}

impl OldScreen for Foil {
    fn title(&self) -> String {
        "foil".into()
    }

    fn status(&self, _cx: &Context) -> String {
        let setup = &self.setup;
        match (self.page, setup.obstacle) {
            (Page::Measured, _) => "Geiger and Marsden, silver and gold".into(),
            (Page::Tracks, Hard) => "a hard target".into(),
            (Page::Counts, Hard) => format!("{}s", setup.obstacle_name()),
            (_, Nucleus) => format!(
                "α particles of {:.2} MeV on {}",
                setup.energy_mev,
                setup.metal().name
            ),
        }
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Key(key) => self.key(*key, cx),
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            Input::Exported(exported) => {
                cx.tell_of_export("plot", exported);
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, _passed: Duration, _cx: &mut Context) -> Next {
        // As many particles a picture whatever time it took, so that a beam is never in
        // the way of the next picture.
        if let Some(run) = &mut self.run {
            run.advance();
        }
        Next::Stay
    }

    fn wake(&self, _cx: &Context) -> Option<Duration> {
        self.is_running().then_some(Duration::ZERO)
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }

    fn keys(&self, _cx: &Context) -> Vec<Hint> {
        if self.is_running() {
            return vec![
                Hint::new("Esc", "stop the beam"),
                Hint::new("l", "scale"),
                Hint::new("Tab", "next page"),
            ];
        }
        if self.guess.is_some() {
            return vec![
                Hint::new("Up Down", "choose"),
                Hint::new("Enter", "say it, and throw"),
                Hint::new("Esc", "back"),
            ];
        }
        let change = [
            Hint::new("Up Down", "choose"),
            Hint::new("Left Right", "change"),
        ];
        let mut keys = Vec::new();
        match self.page {
            Page::Tracks => {
                keys.extend(change);
                keys.push(Hint::new("0-9", "type"));
                keys.push(Hint::new("Enter", "a whole beam"));
            }
            Page::Counts => {
                let enter = match &self.run {
                    None => "throw the beam",
                    Some(run) if run.is_over() => "another beam",
                    Some(_) => "go on",
                };
                keys.push(Hint::new("Enter", enter));
                keys.extend(change);
                keys.push(Hint::new("l", "scale"));
            }
            Page::Measured => {
                keys.push(Hint::new("Enter", "the other plot"));
                keys.push(Hint::new("PageUp PageDown", "read"));
            }
        }
        keys.push(Hint::new("Tab", "next page"));
        keys.push(Hint::new("Esc", "back"));
        keys.push(Hint::new("e", "export"));
        keys
    }

    fn help(&self, _cx: &Context) -> Help {
        Help {
            text: vec![
                "A glancing hit, once more, and then a million times. Nobody can aim a particle at an atom; but throw many, evenly, and the angles they leave at tell what is in there.",
                "One particle: set its offset b and see how it is turned. A hard target reflects it; a nucleus repels it from afar, on a hyperbola. r_min is how near it comes.",
                "A beam: particle after particle, each with a random offset, counted by angle in steps of 5°. The line is what the law leads one to expect. A plane beam has its offsets even over a line, as on a board; a beam in space has them even over a disc.",
                "In a foil every nucleus has its share of the beam: the thicker the foil, the less room around each. Each particle is taken to meet one nucleus only, and the target to stay where it is.",
                "Counted in 1913: Geiger and Marsden's own numbers beside the law.",
            ],
            keys: vec![
                Hint::new("Tab", "next page; Shift+Tab the one before"),
                Hint::new("Up Down", "choose a setting, an answer, or scroll a text"),
                Hint::new(
                    "Left Right",
                    "change the setting; on the last page, the other plot",
                ),
                Hint::new("0-9 . -", "type a number; Enter sets it, Esc gives it up"),
                Hint::new("Enter", "throw a beam, let it go on, or throw another"),
                Hint::new("Esc", "stop a beam at once"),
                Hint::new("l", "counts on a logarithmic scale, or on an even one"),
                Hint::new("p", "say first what will happen, or just watch"),
                Hint::new("e", "export the plot as an SVG picture"),
                Hint::new("r", "back to the first setting"),
                Hint::new(
                    "PageUp PageDown",
                    "scroll a text that is longer than its place",
                ),
                Hint::new(
                    "mouse",
                    "drag the particle up and down; click a tab, a setting, the plot",
                ),
            ],
        }
    }
}

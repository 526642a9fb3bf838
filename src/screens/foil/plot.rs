//! A page of the foil as a figure: its picture alone, and the keys that work it.

use std::time::Duration;

use ratatui::layout::Rect;

use super::{BeamRun, FoilField, FoilPage, FoilScreen, FoilSetup, tracks_page, view};
use crate::messages::{Key, Mouse, MouseKind};
use crate::physics::rutherford::FM;
use crate::widgets::Look;
use crate::widgets::picture::Picture;

/// Ten million particles: enough for some to be turned back, by a foil too.
const PARTICLES_EXPONENT: u32 = 7;

/// What the chance of the first beam hangs on: the same for all, as in a book.
const SEED: u64 = 1913;

/// Steps of the offset that `<` and `>` go at once.
const LEAP: f64 = 10.0;

/// The picture of a page of the foil.
#[derive(Debug, Clone)]
pub(crate) struct FoilFigure(FoilScreen);

impl FoilFigure {
    /// A page as the foil first shows it, with the counts of 1913 `levelled` or not. A
    /// beam is thrown: at once, or so that one can watch it if it is `watched`.
    pub(crate) fn new(page: FoilPage, levelled: bool, watched: bool) -> Self {
        let mut setup = FoilSetup {
            particles_exponent: PARTICLES_EXPONENT,
            ..FoilSetup::default()
        };
        // The offset d/2, which turns a particle by a right angle.
        setup.offset_fm = setup.scatterer().head_on_approach / 2.0 / FM;
        let mut foil = FoilScreen {
            setup,
            levelled,
            ..FoilScreen::at(page)
        };
        if page == FoilPage::Counts {
            foil.begin(None, SEED);
        }
        let mut plot = Self(foil);
        while !watched && plot.is_running() {
            plot.advance();
        }
        plot
    }

    /// Its title.
    pub(crate) fn title(&self) -> &'static str {
        view::title(&self.0)
    }

    /// Whether a beam is under way.
    fn is_running(&self) -> bool {
        self.0.is_running()
    }

    /// What its keys are, for the bottom line.
    pub(crate) fn keys(&self) -> Vec<(&'static str, &'static str)> {
        match self.0.page {
            FoilPage::Tracks => vec![("Left Right", "offset")],
            FoilPage::Counts if self.is_running() => vec![("Space", "stop"), ("l", "scale")],
            FoilPage::Counts => vec![("Space", "throw"), ("l", "scale")],
            FoilPage::Measured => vec![("Space", "the other plot")],
        }
    }

    /// Takes a key; says whether it meant anything.
    pub(crate) fn update(&mut self, key: Key) -> bool {
        let by = match key {
            Key::Left => -1.0,
            Key::Right => 1.0,
            Key::Char('<') => -LEAP,
            Key::Char('>') => LEAP,
            _ => 0.0,
        };
        let foil = &mut self.0;
        match (foil.page, key) {
            (FoilPage::Tracks, _) if by != 0.0 => {
                foil.edit(|_, fields| FoilField::Offset.step(&mut fields.setup, by))
            }
            (FoilPage::Counts, Key::Escape | Key::Char(' ')) if foil.is_running() => {
                foil.halt(true)
            }
            (FoilPage::Counts, Key::Char(' ')) => match &foil.run {
                Some(run) if !run.is_over() => foil.halt(false),
                _ => foil.begin(None, SEED),
            },
            (FoilPage::Counts, Key::Char('l' | 'L')) => foil.other_scale = !foil.other_scale,
            (FoilPage::Measured, Key::Char(' ')) => foil.levelled = !foil.levelled,
            _ => return false,
        }
        true
    }

    /// Takes the mouse over its picture; says whether it meant anything.
    pub(crate) fn mouse(&mut self, mouse: &Mouse, area: Rect) -> bool {
        let pressed = mouse.kind == MouseKind::Down;
        let held = pressed || mouse.kind == MouseKind::Drag;
        match (self.0.page, mouse.kind) {
            (FoilPage::Tracks, _) if held => {
                let cell = (mouse.column, mouse.row);
                let offset = tracks_page::offset_at(area, &self.0.setup, cell);
                self.0
                    .edit(|_, fields| FoilField::Offset.set(&mut fields.setup, offset));
                true
            }
            (FoilPage::Tracks, MouseKind::ScrollUp) => self.update(Key::Right),
            (FoilPage::Tracks, MouseKind::ScrollDown) => self.update(Key::Left),
            _ => pressed && self.update(Key::Char(' ')),
        }
    }

    /// Throws the particles between two pictures.
    pub(crate) fn advance(&mut self) {
        self.0.run.iter_mut().for_each(BeamRun::advance);
    }

    /// When it next needs time.
    pub(crate) fn wake(&self) -> Option<Duration> {
        self.is_running().then_some(Duration::ZERO)
    }

    /// What it shows.
    pub(crate) fn picture(&self, area: Rect, look: &Look) -> Picture {
        view::picture(&self.0, area, *look)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_beam_that_is_watched_ends_as_one_that_is_thrown_at_once() {
        let whole = FoilFigure::new(FoilPage::Counts, false, false);
        let mut watched = FoilFigure::new(FoilPage::Counts, false, true);
        assert!(whole.wake().is_none() && watched.wake().is_some());
        let mut pictures = 0;
        while watched.wake().is_some() {
            watched.advance();
            pictures += 1;
        }
        assert!(pictures > 60, "{pictures}");
        let counts = |plot: &FoilFigure| *plot.0.run.as_ref().unwrap().counts();
        assert_eq!(counts(&watched), counts(&whole));
        assert!(watched.update(Key::Char(' ')) && watched.wake().is_some());
        assert!(watched.update(Key::Escape) && watched.wake().is_none());
        assert!(!watched.update(Key::Escape));
    }
}

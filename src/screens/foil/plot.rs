//! A page of the foil as a figure: its picture alone, and the keys that work it.

use std::time::Duration;

use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::{BeamRun, FoilField, FoilPage, FoilScreen, FoilSetup, view};
use crate::messages::{Key, Mouse, MouseKind};
use crate::physics::rutherford::FM;
use crate::widgets::Look;
use crate::widgets::input::KeyTable;
use crate::widgets::picture::Picture;

/// Ten million particles: enough for some to be turned back, by a foil too.
const PARTICLES_EXPONENT: u32 = 7;

/// What the chance of the first beam hangs on: the same for all, as in a book.
const SEED: u64 = 1913;

/// Steps of the offset that `<` and `>` go at once.
const LEAP: i8 = 10;

/// What keys do to a page of the foil that is a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum FoilFigureAction {
    /// change the offset
    Offset(i8),
    /// throw a beam, or stop it
    Beam,
    /// the other scale
    Scale,
    /// the other plot
    OtherPlot,
}

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

    /// The keys that work it.
    pub(crate) fn keys(&self) -> KeyTable<FoilFigureAction> {
        use FoilFigureAction::{Beam, Offset, OtherPlot, Scale};
        let keys = KeyTable::new("foil-figure");
        match self.0.page {
            FoilPage::Tracks => keys
                .by([Key::Left, Key::Right], Offset, [-1, 1], "offset")
                .or([('<', Offset(-LEAP)), ('>', Offset(LEAP))]),
            FoilPage::Counts => {
                let running = self.is_running();
                keys.on(Key::Char(' '), Beam, if running { "stop" } else { "throw" })
                    .on(Key::Escape, Beam, "")
                    .when(running)
                    .on(Key::Char('l'), Scale, "scale")
            }
            FoilPage::Measured => keys.on(Key::Char(' '), OtherPlot, "the other plot"),
        }
    }

    /// Does what a key stands for.
    pub(crate) fn act(&mut self, action: FoilFigureAction) {
        let foil = &mut self.0;
        match action {
            FoilFigureAction::Offset(by) => {
                let offset = FoilField::Offset.stepped(&foil.setup, by.into());
                foil.edit(|_, fields| FoilField::Offset.set(&mut fields.setup, offset));
            }
            FoilFigureAction::Beam if foil.is_running() => foil.halt(true),
            FoilFigureAction::Beam => match &foil.run {
                Some(run) if !run.is_over() => foil.halt(false),
                _ => foil.begin(None, SEED),
            },
            FoilFigureAction::Scale => foil.other_scale = !foil.other_scale,
            FoilFigureAction::OtherPlot => foil.levelled = !foil.levelled,
        }
    }

    /// Takes a key; says whether it meant anything.
    fn update(&mut self, key: Key) -> bool {
        let action = self.keys().find(key);
        action.is_some_and(|action| {
            self.act(action);
            true
        })
    }

    /// Takes the mouse over its picture; says whether it meant anything.
    pub(crate) fn mouse(&mut self, mouse: &Mouse, area: Rect) -> bool {
        match self.0.page {
            FoilPage::Tracks => self.0.move_particle(mouse, area),
            _ => mouse.kind == MouseKind::Down && self.update(Key::Char(' ')),
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
        let counts = |plot: &FoilFigure| plot.0.run.as_ref().unwrap().counts;
        assert_eq!(counts(&watched), counts(&whole));
        assert!(watched.update(Key::Char(' ')) && watched.wake().is_some());
        assert!(watched.update(Key::Escape) && watched.wake().is_none());
        assert!(!watched.update(Key::Escape));
    }
}

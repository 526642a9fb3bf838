//! A page of the foil as a figure: its picture alone, and its keys.

use std::time::Duration;

use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::field::shown_counts;
use super::{FoilScreen, view};
use crate::beams::CountedFor;
use crate::messages::{Key, Mouse, MouseKind};
use crate::physics::rutherford::FM;
use crate::screens::route::FoilPage;
use crate::widgets::Look;
use crate::widgets::input::KeyTable;
use crate::widgets::picture::Picture;

/// Ten million particles: enough for some to be deflected by more than 90°, even by a foil.
const PARTICLES_EXPONENT: u32 = 7;

/// The seed of the first beam: fixed, so that everyone sees the same figure, as in a book.
const SEED: u64 = 1913;

/// The number of steps by which `<` and `>` change the offset.
const LEAP: i8 = 10;

/// What the keys do on a page of the foil that is shown as a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum FoilFigureAction {
    /// change the offset
    Offset(i8),
    /// start a beam, or stop it
    Beam,
    /// switch to the other scale
    Scale,
    /// count on a small screen, or in whole rings of 5°
    CountFor,
    /// show the other plot
    OtherPlot,
}

/// The picture of a page of the foil.
#[derive(Debug, Clone)]
pub(crate) struct FoilFigure(FoilScreen);

impl FoilFigure {
    /// A page in its initial state, with the counts of 1913 relative to the law if `levelled`. A
    /// beam is computed at once, or frame by frame if it is `watched`.
    pub(crate) fn new(page: FoilPage, levelled: bool, watched: bool) -> Self {
        let mut foil = FoilScreen::at(page);
        foil.levelled = levelled;
        let setup = &mut foil.fields.setup;
        setup.particles_exponent = PARTICLES_EXPONENT;
        // The offset d/2, which deflects a particle by 90°.
        setup.offset_fm = setup.scatterer().head_on_approach / 2.0 / FM;
        if page == FoilPage::Counts {
            foil.begin(None, SEED);
        }
        let mut plot = Self(foil);
        while !watched && plot.0.is_running() {
            plot.advance();
        }
        plot
    }

    /// This figure with particles counted in whole `rings` or on a small screen.
    pub(crate) fn counted_in(mut self, rings: bool) -> Self {
        self.0.fields.setup.counted_for = match rings {
            true => CountedFor::Ring,
            false => CountedFor::Steradian,
        };
        self
    }

    pub(crate) fn title(&self) -> &'static str {
        view::title(&self.0)
    }

    /// The keys that control the figure.
    pub(crate) fn keys(&self) -> KeyTable<FoilFigureAction> {
        use FoilFigureAction::{Beam, CountFor, Offset, OtherPlot, Scale};
        let keys = KeyTable::new("foil-figure");
        match self.0.fields.page {
            FoilPage::Tracks => keys
                .by([Key::Left, Key::Right], Offset, [-1, 1], "offset")
                .or([('<', Offset(-LEAP)), ('>', Offset(LEAP))]),
            FoilPage::Counts => {
                let running = self.0.is_running();
                let other = shown_counts(self.0.fields.setup.counted_for.other());
                keys.on(Key::Char(' '), Beam, if running { "stop" } else { "start" })
                    .on(Key::Escape, Beam, "")
                    .when(running)
                    .on(Key::Char('l'), Scale, "scale")
                    .on(Key::Char('c'), CountFor, other)
            }
            FoilPage::Measured => keys.on(Key::Char(' '), OtherPlot, "the other plot"),
        }
    }

    pub(crate) fn act(&mut self, action: FoilFigureAction) {
        let foil = &mut self.0;
        match action {
            FoilFigureAction::Offset(by) => foil.step_offset(by),
            FoilFigureAction::Beam if foil.is_running() => foil.halt(true),
            FoilFigureAction::Beam => foil.throw(false, SEED),
            FoilFigureAction::Scale => foil.other_scale = !foil.other_scale,
            FoilFigureAction::CountFor => {
                foil.fields.setup.counted_for = foil.fields.setup.counted_for.other();
            }
            FoilFigureAction::OtherPlot => foil.levelled = !foil.levelled,
        }
    }

    /// Handles the mouse over the figure's picture; returns whether the mouse was used.
    pub(crate) fn mouse(&mut self, mouse: &Mouse, area: Rect) -> bool {
        match self.0.fields.page {
            FoilPage::Tracks => return self.0.move_particle(mouse, area),
            _ if mouse.kind != MouseKind::Down => return false,
            FoilPage::Counts => self.act(FoilFigureAction::Beam),
            FoilPage::Measured => self.act(FoilFigureAction::OtherPlot),
        }
        true
    }

    /// Computes the particles for the next frame.
    pub(crate) fn advance(&mut self) {
        self.0.throw_on();
    }

    /// The time until the figure must next be advanced.
    pub(crate) fn wake(&self) -> Option<Duration> {
        self.0.is_running().then_some(Duration::ZERO)
    }

    pub(crate) fn picture(&self, area: Rect, look: &Look) -> Picture {
        view::picture(&self.0, area, *look)
    }
}

#[cfg(test)]
mod tests {
    use super::super::beam_page::expected_at;
    use super::*;

    fn press(figure: &mut FoilFigure, key: Key) -> bool {
        let action = figure.keys().find(key);
        action.map(|action| figure.act(action)).is_some()
    }

    /// The curve agrees with the statements about a small screen in chapter 10 and in the quiz.
    #[test]
    fn on_a_small_screen_the_counts_decrease_as_the_texts_say() {
        let figure = FoilFigure::new(FoilPage::Counts, false, false);
        assert_eq!(
            figure.0.fields.setup.counted_for(),
            Some(CountedFor::Steradian)
        );
        let run = figure.0.run.as_ref().unwrap();
        let at =
            |degrees| expected_at(&run.law, CountedFor::Steradian, run.thrown(), degrees).unwrap();
        assert_eq!((at(15.0) / at(150.0)).round(), 2999.0);
        assert_eq!((at(60.0) / at(120.0)).round(), 9.0);
        // Halving a small angle makes the count about sixteen times as high.
        for small in [4.0, 10.0, 20.0] {
            let times = at(small / 2.0) / at(small);
            assert!((times - 16.0).abs() < 0.4, "{times}");
        }
        // The bars are on the same scale as the curve. Where many particles are counted, the bars
        // meet the curve, apart from the effect of the law's curvature within a bin of 5°.
        for bin in 2..6 {
            let bar = run.counts.bins[bin] as f64 / CountedFor::Steradian.in_bin(bin);
            let bent = bar / at(5.0 * bin as f64 + 2.5);
            assert!((0.9..1.2).contains(&bent), "{bin}: {bent}");
        }
    }

    #[test]
    fn a_watched_beam_ends_with_the_same_counts_as_one_computed_at_once() {
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
        assert!(press(&mut watched, Key::Char(' ')) && watched.wake().is_some());
        assert!(press(&mut watched, Key::Escape) && watched.wake().is_none());
        assert!(!press(&mut watched, Key::Escape));
    }
}

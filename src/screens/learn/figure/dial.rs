//! What a student sets in a figure: the impact angle or another quantity.

use super::{LiveFigure, momenta};
use crate::lessons::{FigureKind, FilmSetting};
use crate::numbers::tidy;

/// The name of the dial for the impact angle.
pub(super) const ALPHA: &str = "α";

/// A value between two ends, set in steps.
pub(super) struct FigureDial {
    /// The dial's name in the line of keys.
    pub(super) name: &'static str,
    value: f64,
    /// The smallest and the largest value, and the step.
    range: (f64, f64, f64),
}

impl FigureDial {
    /// The dial of a figure, if it has one.
    pub(super) fn of(figure: &LiveFigure) -> Option<Self> {
        use FigureKind::{Angles, Curves, Energy, Frames, Triangle};
        let (kind, collision) = (figure.figure.kind, &figure.collision);
        let (name, value, range) = match kind {
            Angles | Curves | Energy | Frames | Triangle { .. } => {
                (ALPHA, figure.alpha_deg(), (0.0, 90.0, 1.0))
            }
            FigureKind::Force { time_ms } => {
                let (shortest, longest) = FigureKind::CONTACT_MS;
                ("time", time_ms, (shortest, longest, 0.1))
            }
            FigureKind::Film { mut filming } => {
                let sets = filming.sets;
                let name = match sets {
                    FilmSetting::Rate => "frame rate",
                    other => other.into(),
                };
                (name, *filming.of(sets), sets.range())
            }
            FigureKind::Parts => ("e", collision.restitution, (0.0, 1.0, 0.05)),
            FigureKind::Coalesce | FigureKind::Explosion { .. } => {
                let angle_deg = momenta::angle_deg(kind, collision);
                ("angle", angle_deg, (0.0, 180.0, 5.0))
            }
            _ => return None,
        };
        Some(Self { name, value, range })
    }

    /// The value after `by` steps.
    pub(super) fn stepped(&self, by: i8) -> f64 {
        let (_, _, step) = self.range;
        self.value + f64::from(by) * step
    }

    /// The value at the fraction `share` of the range.
    pub(super) fn at(&self, share: f64) -> f64 {
        let (least, most, _) = self.range;
        least + share * (most - least)
    }

    /// The multiple of the dial's step that is nearest to `value`, within the range.
    pub(super) fn nearest(&self, value: f64) -> f64 {
        let (least, most, step) = self.range;
        tidy((value / step).round() * step).clamp(least, most)
    }
}

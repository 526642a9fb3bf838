//! What a student sets in a figure, other than α.

use super::{film, momenta};
use crate::lessons::FigureKind;
use crate::numbers::tidy;
use crate::physics::Collision;

/// A value between two ends, set in steps.
pub(super) struct FigureDial {
    /// The dial's name in the line of keys.
    pub(super) name: &'static str,
    value: f64,
    ends: (f64, f64),
    step: f64,
}

impl FigureDial {
    /// The dial of a kind of figure, if it has one.
    pub(super) fn of(kind: FigureKind, collision: &Collision) -> Option<Self> {
        let (name, value, ends, step) = match kind {
            FigureKind::Force { time_ms } => ("time", time_ms, FigureKind::CONTACT_MS, 0.1),
            FigureKind::Film { mut filming } => {
                let (least, most, step) = filming.sets.range();
                let name = film::name(filming.sets);
                (name, *filming.of(filming.sets), (least, most), step)
            }
            FigureKind::Parts => ("e", collision.restitution, (0.0, 1.0), 0.05),
            FigureKind::Coalesce | FigureKind::Explosion { .. } => (
                "angle",
                momenta::angle_deg(kind, collision),
                (0.0, 180.0),
                5.0,
            ),
            _ => return None,
        };
        Some(Self {
            name,
            value,
            ends,
            step,
        })
    }

    /// The value after `by` steps.
    pub(super) fn stepped(&self, by: i8) -> f64 {
        self.value + f64::from(by) * self.step
    }

    /// The value at the fraction `share` of the range.
    pub(super) fn at(&self, share: f64) -> f64 {
        let (least, most) = self.ends;
        least + share * (most - least)
    }

    /// The multiple of the dial's step that is nearest to `value`, within the range.
    pub(super) fn nearest(&self, value: f64) -> f64 {
        let (least, most) = self.ends;
        tidy((value / self.step).round() * self.step).clamp(least, most)
    }
}

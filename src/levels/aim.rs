//! The settings that a player can change before the shot of a level.

use super::quantity as q;
use crate::files::{Fields, NumberSpec, Range, all};

/// A setting that a level may leave to the player, in the units shown on the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dial {
    /// The direction of the shot, in degrees from +x, anticlockwise.
    Direction,
    /// The speed of the shot, in m/s.
    Speed,
    /// The x coordinate of the disc that is shot, in mm.
    Place,
    /// The mass of the disc that is shot, in grams.
    Mass,
    /// The coefficient of restitution between discs.
    Restitution,
}

impl Dial {
    /// All dials, in the order in which they are declared; `LevelAim` relies on this order.
    pub const ALL: [Self; 5] = [
        Self::Direction,
        Self::Speed,
        Self::Place,
        Self::Mass,
        Self::Restitution,
    ];

    /// The name of the dial in a file, its step and its range.
    const fn facts(self) -> (&'static str, f64, &'static NumberSpec) {
        match self {
            Self::Direction => ("direction_deg", 0.5, &q::DIRECTION),
            Self::Speed => ("speed", 0.05, &q::SPEED),
            Self::Place => ("place_mm", 1.0, &q::COORDINATE),
            Self::Mass => ("mass_g", 0.5, &q::MASS),
            Self::Restitution => ("restitution", 0.05, &q::RESTITUTION),
        }
    }

    /// The name of the dial in a file.
    pub const fn field(self) -> &'static str {
        self.facts().0
    }

    /// The names of all dials in a file.
    pub(super) fn fields() -> [&'static str; 5] {
        Self::ALL.map(Self::field)
    }

    /// The step of the dial; in the built-in packs, every solution is a whole number of steps away
    /// from the initial aim.
    pub const fn step(self) -> f64 {
        self.facts().1
    }

    const fn quantity(self) -> &'static NumberSpec {
        self.facts().2
    }

    /// The dials that are named in a table of a file.
    fn named_in(fields: &Fields) -> impl Iterator<Item = Self> {
        Self::ALL
            .into_iter()
            .filter(|dial| fields.has(dial.field()))
    }
}

/// The setting of each dial, in the units shown on the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LevelAim([f64; 5]);

impl LevelAim {
    /// Creates an aim with the `setting` of each dial.
    pub(super) fn new(setting: impl FnMut(Dial) -> f64) -> Self {
        Self(Dial::ALL.map(setting))
    }

    /// The setting of a dial.
    pub const fn get(&self, dial: Dial) -> f64 {
        self.0[dial as usize]
    }

    /// This aim with a different setting of one dial.
    #[must_use]
    pub(crate) const fn with(mut self, dial: Dial, setting: f64) -> Self {
        self.0[dial as usize] = setting;
        self
    }
}

/// The dials that the player may change, with their ranges.
#[derive(Debug, Clone, PartialEq)]
pub struct Adjust(Vec<(Dial, Range)>);

impl Adjust {
    /// The dials that the player may change, each with its range.
    pub fn dials(&self) -> impl Iterator<Item = (Dial, Range)> + '_ {
        self.0.iter().copied()
    }

    /// The range of a dial; `None` if the player may not change the dial.
    pub(crate) fn range(&self, dial: Dial) -> Option<Range> {
        self.dials()
            .find_map(|(d, range)| (d == dial).then_some(range))
    }

    pub(super) fn from_fields(fields: &Fields) -> Option<Self> {
        let range = |dial: Dial| fields.range(dial.field(), dial.quantity());
        let dials = Dial::named_in(fields).map(|dial| Some((dial, range(dial)?)));
        let dials = all(dials.collect())?;
        if dials.is_empty() {
            let any = Dial::fields().join(", ");
            return fields.refuse_table(format!("expected at least one of {any}, found nothing"));
        }
        Some(Self(dials))
    }

    /// Reads the settings of the dials; any dial that is left out has the same setting as in
    /// `start`.
    pub(super) fn read_setting(&self, fields: &Fields, start: LevelAim) -> Option<LevelAim> {
        let settings = Dial::named_in(fields).map(|dial| {
            let name = dial.field();
            let setting = fields.number(name, dial.quantity())?;
            let Some(range) = self.range(dial) else {
                return fields.refuse(name, "expected only settings that [adjust] allows");
            };
            if !range.holds(setting) {
                let message = format!(
                    "expected {} to {}, as [adjust] allows, found {setting}",
                    range.from, range.to
                );
                return fields.refuse(name, message);
            }
            Some((dial, setting))
        });
        let settings = all(settings.collect())?;
        let set = |aim: LevelAim, (dial, setting)| aim.with(dial, setting);
        Some(settings.into_iter().fold(start, set))
    }
}

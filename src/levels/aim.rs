//! What a player may set before the shot of a level, and what was set.

use super::quantity as q;
use crate::files::{Fields, NumberSpec, Range, all};

/// Something a player may be free to set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dial {
    /// Direction of the shot, in degrees from +x, anticlockwise.
    Direction,
    /// Speed of the shot, in m/s.
    Speed,
    /// Where the disc that is set off starts: its x in mm.
    Place,
    /// Mass of the disc that is set off, in grams.
    Mass,
    /// Restitution of disc on disc.
    Restitution,
}

impl Dial {
    /// All dials, the most used first.
    pub const ALL: [Self; 5] = [
        Self::Direction,
        Self::Speed,
        Self::Place,
        Self::Mass,
        Self::Restitution,
    ];

    /// Its name in a file.
    pub const fn field(self) -> &'static str {
        match self {
            Self::Direction => "direction_deg",
            Self::Speed => "speed",
            Self::Place => "place_mm",
            Self::Mass => "mass_g",
            Self::Restitution => "restitution",
        }
    }

    /// The names of all dials in a file.
    pub(super) const FIELDS: [&str; 5] = [
        Self::Direction.field(),
        Self::Speed.field(),
        Self::Place.field(),
        Self::Mass.field(),
        Self::Restitution.field(),
    ];

    /// What one press of a key changes; every solution in the packs that come with
    /// carrom is a whole number of these away from where the level starts.
    pub const fn step(self) -> f64 {
        match self {
            Self::Direction | Self::Mass => 0.5,
            Self::Speed | Self::Restitution => 0.05,
            Self::Place => 1.0,
        }
    }

    const fn quantity(self) -> &'static NumberSpec {
        match self {
            Self::Direction => &q::DIRECTION,
            Self::Speed => &q::SPEED,
            Self::Place => &q::COORDINATE,
            Self::Mass => &q::MASS,
            Self::Restitution => &q::RESTITUTION,
        }
    }
}

/// The setting of every dial, in the units of the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LevelAim {
    /// Direction of the shot, in degrees from +x, anticlockwise.
    pub direction_deg: f64,
    /// Speed of the shot, in m/s.
    pub speed: f64,
    /// Where the disc that is set off starts: its x in mm.
    pub place_mm: f64,
    /// Mass of the disc that is set off, in grams.
    pub mass_g: f64,
    /// Restitution of disc on disc.
    pub restitution: f64,
}

impl LevelAim {
    /// The setting of a dial.
    pub const fn get(&self, dial: Dial) -> f64 {
        match dial {
            Dial::Direction => self.direction_deg,
            Dial::Speed => self.speed,
            Dial::Place => self.place_mm,
            Dial::Mass => self.mass_g,
            Dial::Restitution => self.restitution,
        }
    }

    /// The same aim with one dial set anew.
    #[must_use]
    pub const fn with(mut self, dial: Dial, setting: f64) -> Self {
        match dial {
            Dial::Direction => self.direction_deg = setting,
            Dial::Speed => self.speed = setting,
            Dial::Place => self.place_mm = setting,
            Dial::Mass => self.mass_g = setting,
            Dial::Restitution => self.restitution = setting,
        }
        self
    }
}

/// Which dials a player may turn, and how far.
#[derive(Debug, Clone, PartialEq)]
pub struct Adjust(Vec<(Dial, Range)>);

impl Adjust {
    /// The dials that may be turned, each with its range.
    pub fn dials(&self) -> impl Iterator<Item = (Dial, Range)> + '_ {
        self.0.iter().copied()
    }

    /// How far a dial may be turned; `None` if it is fixed.
    pub fn range(&self, dial: Dial) -> Option<Range> {
        self.dials()
            .find_map(|(d, range)| (d == dial).then_some(range))
    }

    pub(super) fn from_fields(fields: &Fields) -> Option<Self> {
        let there = Dial::ALL
            .into_iter()
            .filter(|dial| fields.has(dial.field()));
        let dials = there.map(|dial| Some((dial, fields.range(dial.field(), dial.quantity())?)));
        let dials = all(dials.collect())?;
        if dials.is_empty() {
            let any = Dial::FIELDS.join(", ");
            return fields.refuse_table(format!("expected at least one of {any}, found nothing"));
        }
        Some(Self(dials))
    }

    /// Reads a setting of the dials; those that are left out stay as in `start`.
    pub(super) fn read_setting(&self, fields: &Fields, start: LevelAim) -> Option<LevelAim> {
        let there = Dial::ALL
            .into_iter()
            .filter(|dial| fields.has(dial.field()));
        let settings = there.map(|dial| {
            let name = dial.field();
            let setting = fields.number(name, dial.quantity())?;
            let Some(range) = self.range(dial) else {
                return fields.refuse(name, "expected only what [adjust] lets the player set");
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

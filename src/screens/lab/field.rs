//! What can be set in the lab: one place for a setting's name, unit, range and step.

use super::setup::Setup;
use crate::physics::Bond;

/// One setting of the lab.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Field {
    /// Impact parameter b.
    Offset,
    /// Impact angle α: the same as the offset, said by the line of impact.
    ImpactAngle,
    /// Direction of the striker.
    Aim,
    /// Speed of the striker.
    Speed,
    /// Restitution.
    Restitution,
    /// Slip or stick.
    Contact,
    /// Mass of the striker.
    StrikerMass,
    /// Mass of the target.
    CoinMass,
    /// Radius of the striker.
    StrikerRadius,
    /// Radius of the target.
    CoinRadius,
    /// Speed of the target.
    CoinSpeed,
    /// Direction of the target.
    CoinAim,
}

/// Name, unit, decimals, range and step of a numeric setting.
struct Scale {
    name: &'static str,
    unit: &'static str,
    decimals: usize,
    range: (f64, f64),
    step: f64,
}

impl Field {
    /// All settings, in the order of the panel.
    pub(crate) const ALL: [Self; 12] = [
        Self::Offset,
        Self::ImpactAngle,
        Self::Aim,
        Self::Speed,
        Self::Restitution,
        Self::Contact,
        Self::StrikerMass,
        Self::CoinMass,
        Self::StrikerRadius,
        Self::CoinRadius,
        Self::CoinSpeed,
        Self::CoinAim,
    ];

    fn scale(self, setup: &Setup) -> Scale {
        let scale = |name, unit, decimals, range, step| Scale {
            name,
            unit,
            decimals,
            range,
            step,
        };
        // Past the touching distance there are misses, and a little beyond nothing new.
        let widest = setup.reach_mm() * 1.25;
        match self {
            Self::Offset => scale("offset b", "mm", 1, (-widest, widest), 0.5),
            Self::ImpactAngle => scale("impact angle", "°", 1, (-90.0, 90.0), 1.0),
            Self::Aim => scale("aim", "°", 0, (-180.0, 180.0), 5.0),
            Self::Speed => scale("speed", "m/s", 2, (0.1, 20.0), 0.25),
            Self::Restitution => scale("restitution e", "", 2, (0.0, 1.0), 0.05),
            Self::Contact => scale("contact", "", 0, (0.0, 1.0), 1.0),
            Self::StrikerMass => scale("striker mass", "g", 1, (0.1, 1000.0), 0.5),
            Self::CoinMass => scale("coin mass", "g", 1, (0.1, 1000.0), 0.5),
            Self::StrikerRadius => scale("striker radius", "mm", 2, (5.0, 60.0), 0.5),
            Self::CoinRadius => scale("coin radius", "mm", 2, (5.0, 60.0), 0.5),
            Self::CoinSpeed => scale("coin speed", "m/s", 2, (0.0, 20.0), 0.25),
            Self::CoinAim => scale("coin aim", "°", 0, (-180.0, 180.0), 5.0),
        }
    }

    /// Its name on the panel.
    pub(crate) fn name(self, setup: &Setup) -> &'static str {
        self.scale(setup).name
    }

    /// Its value in the units of the screen; slip is 0 and stick is 1, and the impact
    /// angle of a miss is that of the graze it comes nearest to.
    pub(crate) fn value(self, setup: &Setup) -> f64 {
        match self {
            Self::Offset => setup.offset_mm,
            Self::ImpactAngle => (setup.offset_mm / setup.reach_mm())
                .clamp(-1.0, 1.0)
                .asin()
                .to_degrees(),
            Self::Aim => setup.aim_deg,
            Self::Speed => setup.speed,
            Self::Restitution => setup.restitution,
            Self::Contact => f64::from(u8::from(setup.bond == Bond::Stick)),
            Self::StrikerMass => setup.m1_g,
            Self::CoinMass => setup.m2_g,
            Self::StrikerRadius => setup.r1_mm,
            Self::CoinRadius => setup.r2_mm,
            Self::CoinSpeed => setup.target_speed,
            Self::CoinAim => setup.target_deg,
        }
    }

    /// Its value with its unit, as shown.
    pub(crate) fn shown(self, setup: &Setup) -> String {
        if self == Self::Contact {
            let word = match setup.bond {
                Bond::Slip => "slip",
                Bond::Stick => "stick",
            };
            return word.into();
        }
        if self == Self::ImpactAngle && setup.offset_mm.abs() > setup.reach_mm() {
            return "a miss".into();
        }
        let scale = self.scale(setup);
        let value = self.value(setup);
        let number = format!("{value:.*}", scale.decimals);
        match scale.unit {
            "" => number,
            "°" => format!("{number}°"),
            unit => format!("{number} {unit}"),
        }
    }

    /// Whether a number is in its range; of a direction every one is.
    pub(crate) fn allows(self, setup: &Setup, value: f64) -> bool {
        let (low, high) = self.scale(setup).range;
        matches!(self, Self::Aim | Self::CoinAim) || (low..=high).contains(&value)
    }

    /// Its range, as shown.
    pub(crate) fn range(self, setup: &Setup) -> String {
        let scale = self.scale(setup);
        let (low, high) = scale.range;
        let unit = match scale.unit {
            "" | "°" => scale.unit.to_owned(),
            unit => format!(" {unit}"),
        };
        format!("from {low} to {high}{unit}")
    }

    /// Sets it, held to its range; directions wrap round. What is out of range is
    /// brought to the nearest value that is in it.
    pub(crate) fn set(self, setup: &mut Setup, value: f64) {
        let scale = self.scale(setup);
        let (low, high) = scale.range;
        let value = match self {
            Self::Aim | Self::CoinAim => wrap_degrees(value),
            _ => value.clamp(low, high),
        };
        match self {
            Self::Offset => setup.offset_mm = value,
            Self::ImpactAngle => {
                setup.offset_mm = setup.reach_mm() * value.to_radians().sin();
            }
            Self::Aim => setup.aim_deg = value,
            Self::Speed => setup.speed = value,
            Self::Restitution => setup.restitution = value,
            Self::Contact => setup.bond = if value > 0.5 { Bond::Stick } else { Bond::Slip },
            Self::StrikerMass => setup.m1_g = value,
            Self::CoinMass => setup.m2_g = value,
            Self::StrikerRadius => setup.r1_mm = value,
            Self::CoinRadius => setup.r2_mm = value,
            Self::CoinSpeed => setup.target_speed = value,
            Self::CoinAim => setup.target_deg = value,
        }
        // A smaller disc may leave the offset out of reach.
        let (low, high) = Self::Offset.scale(setup).range;
        setup.offset_mm = setup.offset_mm.clamp(low, high);
    }

    /// Moves it by `steps` steps and onto the grid of steps.
    pub(crate) fn step(self, setup: &mut Setup, steps: f64) {
        if self == Self::Contact {
            let other = 1.0 - self.value(setup);
            return self.set(setup, other);
        }
        let size = self.scale(setup).step;
        let value = self.value(setup) / size + steps;
        // Within a thousandth of the grid counts as on it.
        let onto = if steps > 0.0 {
            (value + 1e-3).floor()
        } else {
            (value - 1e-3).ceil()
        };
        self.set(setup, onto * size);
    }
}

/// A direction in (−180, 180].
fn wrap_degrees(degrees: f64) -> f64 {
    180.0 - (180.0 - degrees).rem_euclid(360.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_setting_stays_in_its_range() {
        for field in Field::ALL {
            for wild in [-1e9, -0.0, 0.0, 1e9, 37.25] {
                let mut setup = Setup::default();
                field.set(&mut setup, wild);
                let (low, high) = field.scale(&setup).range;
                let value = field.value(&setup);
                assert!((low..=high).contains(&value), "{field:?} {value}");
            }
        }
    }

    #[test]
    fn steps_land_on_the_grid() {
        let mut setup = Setup::default();
        Field::Offset.set(&mut setup, 7.3);
        Field::Offset.step(&mut setup, 1.0);
        assert_eq!(setup.offset_mm, 7.5);
        Field::Offset.set(&mut setup, 7.3);
        Field::Offset.step(&mut setup, -1.0);
        assert_eq!(setup.offset_mm, 7.0);
        Field::Offset.step(&mut setup, -1.0);
        assert_eq!(setup.offset_mm, 6.5);
    }

    #[test]
    fn directions_wrap_round() {
        let mut setup = Setup::default();
        Field::Aim.set(&mut setup, 180.0);
        Field::Aim.step(&mut setup, 1.0);
        assert_eq!(setup.aim_deg, -175.0);
        Field::Aim.set(&mut setup, 725.0);
        assert_eq!(setup.aim_deg, 5.0);
    }

    #[test]
    fn a_smaller_disc_brings_the_offset_back_into_reach() {
        let mut setup = Setup::default();
        Field::Offset.set(&mut setup, 37.0);
        Field::CoinRadius.set(&mut setup, 5.0);
        assert_eq!(setup.offset_mm, 25.0);
    }
}

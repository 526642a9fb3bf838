//! What can be set in the lab: one place for a setting's name, unit, range and step.

use super::mystery::Mystery;
use crate::numbers::fixed;
use crate::physics::{Bond, CollisionSpec, ImpactPoint};
use crate::widgets::input::{Field, FieldValue, FormFields};

/// What the lab is set to.
#[derive(Debug, Clone, Default)]
pub(crate) struct LabSettings {
    pub(super) setup: CollisionSpec,
    /// The coin's mass is hidden, or was until it had been weighed.
    pub(super) mystery: Option<Mystery>,
}

impl LabSettings {
    /// A setting as it stands, with why it cannot be changed.
    pub(super) fn field(&self, field: LabField) -> Field {
        let mut shown = field.field(&self.setup);
        let secret = self.mystery.as_ref().filter(|coin| coin.is_open());
        if secret.is_some() && field == LabField::CoinMass {
            shown.shown = "? g".into();
        }
        if secret.is_some_and(|coin| coin.locks(field)) {
            shown.locked = Some("A mystery coin: weigh it first.");
        } else if field == LabField::Restitution && self.setup.bond == Bond::Stick {
            shown.locked = Some("Rims that stick do not bounce, whatever e is.");
        }
        shown
    }
}

impl FormFields for LabSettings {
    fn fields(&self) -> Vec<Field> {
        LabField::ALL.map(|field| self.field(field)).into()
    }

    /// A coin that was weighed and is then changed is an ordinary one.
    fn set(&mut self, at: usize, value: f64) {
        let before = self.setup.m2_g;
        if let Some(field) = LabField::ALL.get(at) {
            field.set(&mut self.setup, value);
        }
        if self.setup.m2_g.to_bits() != before.to_bits() {
            self.mystery = None;
        }
    }
}

/// One setting of the lab.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LabField {
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

impl LabField {
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

    /// Its place among all.
    pub(super) fn place(self) -> usize {
        Self::ALL
            .iter()
            .position(|field| *field == self)
            .unwrap_or(0)
    }

    /// The setting as it stands. Of directions every number is one.
    pub(crate) fn field(self, setup: &CollisionSpec) -> Field {
        let widest = widest_mm(setup);
        let any = (f64::NEG_INFINITY, f64::INFINITY);
        let (name, about) = self.words();
        let (unit, decimals, range, step) = match self {
            Self::Offset => (" mm", 1, (-widest, widest), 0.5),
            Self::ImpactAngle => ("°", 1, (-90.0, 90.0), 1.0),
            Self::Aim | Self::CoinAim => ("°", 0, any, 5.0),
            Self::Speed => (" m/s", 2, (0.1, 20.0), 0.25),
            Self::Restitution => ("", 2, (0.0, 1.0), 0.05),
            Self::Contact => ("", 0, (0.0, 1.0), 1.0),
            Self::StrikerMass | Self::CoinMass => (" g", 1, (0.1, 1000.0), 0.5),
            Self::StrikerRadius | Self::CoinRadius => (" mm", 2, (5.0, 60.0), 0.5),
            Self::CoinSpeed => (" m/s", 2, (0.0, 20.0), 0.25),
        };
        let value = self.value(setup);
        // Of a distance off-centre the picture shows the side.
        let side = match setup.offset_mm() {
            mm if mm > 0.0 => " right",
            mm if mm < 0.0 => " left",
            _ => "",
        };
        let is_miss = setup.offset_mm().abs() > setup.contact_distance_mm();
        let shown = match (self, setup.bond) {
            (Self::Contact, Bond::Slip) => "slip".into(),
            (Self::Contact, Bond::Stick) => "stick".into(),
            (Self::ImpactAngle, _) if is_miss => "a miss".into(),
            (Self::Offset, _) => format!("{}{unit}{side}", fixed(value.abs(), decimals)),
            (Self::ImpactAngle, _) => fixed(value.abs(), decimals) + unit,
            _ => fixed(value, decimals) + unit,
        };
        let value = match self {
            Self::Contact => FieldValue::Choice {
                at: value as usize,
                count: 2,
            },
            _ => FieldValue::number(value, range, step, unit),
        };
        Field::new(name, shown, value, about)
    }

    /// Its name, and what it is.
    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Offset => (
                "offset b",
                "how far off-centre they meet: + the coin lies to the right, - to the left",
            ),
            Self::ImpactAngle => (
                "impact angle",
                "the same offset, as the angle between the striker's way and n",
            ),
            Self::Aim => (
                "aim",
                "which way the striker slides; everything turns with it",
            ),
            Self::Speed => (
                "speed",
                "how fast the striker comes; no angle depends on it",
            ),
            Self::Restitution => (
                "restitution e",
                "how fast they part along n, over how fast they meet: 1 loses no energy",
            ),
            Self::Contact => (
                "contact",
                "slip: smooth rims push along n alone; stick: they hold together",
            ),
            Self::StrikerMass => (
                "striker mass",
                "how heavy the striker is; what counts is the ratio",
            ),
            Self::CoinMass => (
                "coin mass",
                "how heavy the coin is; equal masses part at 90°",
            ),
            Self::StrikerRadius => (
                "striker radius",
                "with the coin's it sets how wide the target is",
            ),
            Self::CoinRadius => (
                "coin radius",
                "with the striker's it sets how wide the target is",
            ),
            Self::CoinSpeed => (
                "coin speed",
                "how fast the coin moves before; 0: it is at rest",
            ),
            Self::CoinAim => ("coin aim", "which way the coin moves before, if it moves"),
        }
    }

    /// Its value in the units of the screen; slip is 0 and stick is 1, and the impact
    /// angle of a miss is that of the graze it comes nearest to.
    pub(crate) fn value(self, setup: &CollisionSpec) -> f64 {
        match self {
            Self::Offset => setup.offset_mm(),
            Self::ImpactAngle => (setup.offset_mm() / setup.contact_distance_mm())
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

    /// Sets it, held to its range; directions wrap round. What is out of range is
    /// brought to the nearest value that is in it.
    pub(crate) fn set(self, setup: &mut CollisionSpec, value: f64) {
        let value = match (self, self.field(setup).value) {
            (Self::Aim | Self::CoinAim, _) => wrap_degrees(value),
            (_, FieldValue::Number { range, .. }) => value.clamp(range.0, range.1),
            (_, FieldValue::Choice { .. }) => value,
        };
        // Whatever else changes, they meet as far off-centre as before.
        let offset_mm = match self {
            Self::Offset => value,
            Self::ImpactAngle => setup.contact_distance_mm() * value.to_radians().sin(),
            _ => setup.offset_mm(),
        };
        match self {
            Self::Offset | Self::ImpactAngle => {}
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
        let widest = widest_mm(setup);
        let offset_mm = offset_mm.clamp(-widest, widest);
        setup.point = ImpactPoint::Offset { offset_mm };
    }

    /// Moves it by `steps` steps and onto the grid of steps.
    pub(crate) fn step(self, setup: &mut CollisionSpec, steps: f64) {
        let value = self.field(setup).value.stepped(steps);
        self.set(setup, value);
    }
}

/// The largest offset in mm. Past the touching distance there are misses, and a little
/// beyond nothing new.
fn widest_mm(setup: &CollisionSpec) -> f64 {
    setup.contact_distance_mm() * 1.25
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
        for field in LabField::ALL {
            for wild in [-1e9, -0.0, 0.0, 1e9, 37.25] {
                let mut setup = CollisionSpec::default();
                field.set(&mut setup, wild);
                let value = field.value(&setup);
                let (low, high) = match field.field(&setup).value {
                    FieldValue::Number { range, .. } if range.1.is_finite() => range,
                    FieldValue::Number { .. } => (-180.0, 180.0),
                    FieldValue::Choice { .. } => (0.0, 1.0),
                };
                assert!((low..=high).contains(&value), "{field:?} {value}");
            }
        }
    }

    #[test]
    fn steps_land_on_the_grid() {
        let mut setup = CollisionSpec::default();
        LabField::Offset.set(&mut setup, 7.3);
        LabField::Offset.step(&mut setup, 1.0);
        assert_eq!(setup.offset_mm(), 7.5);
        LabField::Offset.set(&mut setup, 7.3);
        LabField::Offset.step(&mut setup, -1.0);
        assert_eq!(setup.offset_mm(), 7.0);
        LabField::Offset.step(&mut setup, -1.0);
        assert_eq!(setup.offset_mm(), 6.5);
    }

    #[test]
    fn what_sticks_has_no_restitution_to_set() {
        let mut settings = LabSettings::default();
        assert_eq!(settings.field(LabField::Restitution).locked, None);
        settings.set(LabField::Contact.place(), 1.0);
        let locked = settings.field(LabField::Restitution).locked;
        assert!(locked.is_some_and(|why| why.contains("stick")));
        assert_eq!(settings.field(LabField::CoinMass).locked, None);
    }

    #[test]
    fn directions_wrap_round() {
        let mut setup = CollisionSpec::default();
        LabField::Aim.set(&mut setup, 180.0);
        LabField::Aim.step(&mut setup, 1.0);
        assert_eq!(setup.aim_deg, -175.0);
        LabField::Aim.set(&mut setup, 725.0);
        assert_eq!(setup.aim_deg, 5.0);
    }

    #[test]
    fn a_smaller_disc_brings_the_offset_back_into_reach() {
        let mut setup = CollisionSpec::default();
        LabField::Offset.set(&mut setup, 37.0);
        LabField::CoinRadius.set(&mut setup, 5.0);
        assert_eq!(setup.offset_mm(), 25.0);
    }
}

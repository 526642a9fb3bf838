//! A collision described by the fields that files, commands and screens use.

use std::fmt::Display;

use glam::DVec2;

use super::angle::unit_vector;
use super::units::{deg_from_rad, g_from_kg, m_from_mm, mm_from_m, rad_from_deg};
use super::{Bond, Collision, Disc, Rims};
use crate::numbers::{tidy, typed};

/// Two discs about to collide, in the units used in files and on the screen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CollisionSpec {
    /// Mass of the striker in g.
    pub m1_g: f64,
    /// Mass of the target in g.
    pub m2_g: f64,
    /// Radius of the striker in mm.
    pub r1_mm: f64,
    /// Radius of the target in mm.
    pub r2_mm: f64,
    /// Speed of the striker in m/s.
    pub speed: f64,
    /// Direction of the striker in degrees from +x, anticlockwise.
    pub(crate) aim_deg: f64,
    /// Speed of the target in m/s.
    pub target_speed: f64,
    /// Direction of the target in degrees from +x, anticlockwise.
    pub target_deg: f64,
    /// The point of impact.
    pub point: ImpactPoint,
    /// Coefficient of restitution, 0 to 1.
    pub restitution: f64,
    /// Whether the discs slip past each other or stick.
    pub bond: Bond,
    /// Friction at the rims and the spins before the collision; they have no effect on discs that
    /// stick.
    pub rims: Rims,
}

/// The point of impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ImpactPoint {
    /// Given by the impact angle.
    Angle {
        /// α in degrees, −90 to 90, positive if the target is to the right.
        alpha_deg: f64,
    },
    /// Given by the impact parameter.
    Offset {
        /// b in mm, positive if the target is to the right.
        offset_mm: f64,
    },
}

/// The range of one number of a [`CollisionSpec`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FieldRange {
    /// The field's name in files.
    pub name: &'static str,
    /// The quantity and its unit: "a mass in g".
    pub what: &'static str,
    /// The minimum allowed value.
    pub least: f64,
    /// The maximum allowed value.
    pub most: f64,
}

impl FieldRange {
    pub(crate) const fn new(name: &'static str, what: &'static str, least: f64, most: f64) -> Self {
        Self {
            name,
            what,
            least,
            most,
        }
    }

    /// The value, if it is in range.
    ///
    /// # Errors
    /// Returns a message that says what was expected and quotes what was `found`.
    pub(crate) fn check(&self, value: f64, found: impl Display) -> Result<f64, String> {
        if (self.least..=self.most).contains(&value) {
            return Ok(value);
        }
        let (least, most) = (typed(self.least), typed(self.most));
        let what = self.what;
        Err(format!(
            "expected {what} from {least} to {most}, found {found}"
        ))
    }
}

impl Default for CollisionSpec {
    /// The worked shot: 15 g on 15 g at 4 m/s and 30°, smooth and without energy loss.
    fn default() -> Self {
        Self {
            m1_g: 15.0,
            m2_g: 15.0,
            r1_mm: 15.0,
            r2_mm: 15.0,
            speed: 4.0,
            aim_deg: 0.0,
            target_speed: 0.0,
            target_deg: 90.0,
            point: ImpactPoint::Angle { alpha_deg: 30.0 },
            restitution: 1.0,
            bond: Bond::Slip,
            rims: Rims::default(),
        }
    }
}

impl CollisionSpec {
    /// The largest offset as a multiple of r₁ + r₂: beyond 1 the discs miss each other, so slightly
    /// more is enough.
    pub(crate) const WIDEST: f64 = 1.25;

    /// The fields that lessons, concept questions and the lab use, with their ranges.
    pub(crate) const RANGES: [FieldRange; 13] = [
        FieldRange::new("m1_g", "a mass in g", 0.1, 1000.0),
        FieldRange::new("m2_g", "a mass in g", 0.1, 1000.0),
        FieldRange::new("r1_mm", "a radius in mm", 5.0, 60.0),
        FieldRange::new("r2_mm", "a radius in mm", 5.0, 60.0),
        FieldRange::new("speed", "a speed in m/s", 0.1, 20.0),
        FieldRange::new("alpha_deg", "an impact angle in degrees", -90.0, 90.0),
        FieldRange::new("offset_mm", "an offset in mm", -150.0, 150.0),
        FieldRange::new("restitution", "a coefficient of restitution", 0.0, 1.0),
        FieldRange::new("target_speed", "a speed in m/s", 0.0, 20.0),
        FieldRange::new("target_deg", "a direction in degrees", -180.0, 180.0),
        FieldRange::new("rim_friction", "a coefficient of friction", 0.0, 10.0),
        FieldRange::new("spin1", "a spin in rad/s", -1000.0, 1000.0),
        FieldRange::new("spin2", "a spin in rad/s", -1000.0, 1000.0),
    ];

    /// The names of the fields in files.
    pub(crate) fn field_names() -> Vec<&'static str> {
        let names = Self::RANGES.iter().map(|range| range.name);
        names.chain(["stick"]).collect()
    }

    /// Whether files have a field of this name.
    pub(crate) fn has(field: &str) -> bool {
        field == "stick" || Self::RANGES.iter().any(|range| range.name == field)
    }

    /// Sets a field of [`RANGES`](Self::RANGES), or `stick`, from its text.
    ///
    /// # Errors
    /// Returns a message that says what was expected if there is no such field or the value is not
    /// valid for it.
    pub(crate) fn set(&mut self, field: &str, written: &str) -> Result<(), String> {
        if field == "stick" {
            self.bond = match written {
                "true" => Bond::Stick,
                "false" => Bond::Slip,
                _ => return Err(format!("stick: expected true or false, found {written}")),
            };
            return Ok(());
        }
        let Some(range) = Self::RANGES.iter().find(|range| range.name == field) else {
            let names = Self::RANGES.map(|range| range.name).join(", ");
            return Err(format!(
                "expected a field of a shot ({names}, stick), found {field}"
            ));
        };
        let value = range
            .check(written.parse().unwrap_or(f64::NAN), written)
            .map_err(|expected| format!("{field}: {expected}"))?;
        match field {
            "m1_g" => self.m1_g = value,
            "m2_g" => self.m2_g = value,
            "r1_mm" => self.r1_mm = value,
            "r2_mm" => self.r2_mm = value,
            "speed" => self.speed = value,
            "restitution" => self.restitution = value,
            "target_speed" => self.target_speed = value,
            "target_deg" => self.target_deg = value,
            "rim_friction" => self.rims.friction = value,
            "spin1" => self.rims.spins[0] = value,
            "spin2" => self.rims.spins[1] = value,
            "offset_mm" => self.point = ImpactPoint::Offset { offset_mm: value },
            _ => self.point = ImpactPoint::Angle { alpha_deg: value },
        }
        Ok(())
    }

    /// Checks the names of fields that are written together.
    ///
    /// # Errors
    /// Returns a message that says what was expected if two of the fields exclude each other.
    pub(crate) fn check_fields<'a>(names: impl IntoIterator<Item = &'a str>) -> Result<(), String> {
        let points = |name: &&str| ["alpha_deg", "offset_mm"].contains(name);
        match names.into_iter().filter(points).count() {
            0 | 1 => Ok(()),
            _ => Err(
                "expected alpha_deg or offset_mm, found both: each sets where the discs meet"
                    .into(),
            ),
        }
    }

    /// Checks conditions on several fields together.
    ///
    /// # Errors
    /// Returns a message that says what was expected if a condition is not met.
    pub(crate) fn check(&self) -> Result<(), String> {
        let most = Self::WIDEST * self.contact_distance_mm();
        match self.point {
            ImpactPoint::Offset { offset_mm } if offset_mm.abs() > most => Err(format!(
                "offset_mm: expected at most {most} mm, {} times the sum of the radii, found {offset_mm}",
                Self::WIDEST
            )),
            _ => Ok(()),
        }
    }

    /// Whether the point of impact is given by the offset rather than by the angle.
    pub(crate) fn is_by_offset(&self) -> bool {
        matches!(self.point, ImpactPoint::Offset { .. })
    }

    /// Distance between the centres at contact, r₁ + r₂, in mm.
    pub(crate) fn contact_distance_mm(&self) -> f64 {
        self.r1_mm + self.r2_mm
    }

    /// The impact parameter b in mm, positive if the target is to the right.
    pub(crate) fn offset_mm(&self) -> f64 {
        match self.point {
            ImpactPoint::Offset { offset_mm } => offset_mm,
            ImpactPoint::Angle { alpha_deg } => {
                tidy(self.contact_distance_mm() * rad_from_deg(alpha_deg).sin())
            }
        }
    }

    pub(crate) fn collision(&self) -> Collision {
        let striker = Disc::from_g_mm(self.m1_g, self.r1_mm);
        let target = Disc::from_g_mm(self.m2_g, self.r2_mm);
        let u1 = self.speed * unit_vector(self.aim_deg);
        Collision {
            u2: self.target_speed * unit_vector(self.target_deg),
            restitution: self.restitution,
            bond: self.bond,
            rims: match self.bond {
                Bond::Slip => self.rims,
                Bond::Stick => Rims::default(),
            },
            ..Collision::at_offset(striker, target, u1, 0.0).meeting_at(self.point)
        }
    }
}

impl From<&Collision> for CollisionSpec {
    /// The fields of a collision, with rounding noise removed.
    fn from(collision: &Collision) -> Self {
        let degrees = |v: DVec2| tidy(deg_from_rad(v.to_angle()));
        let moves = collision.u2 != DVec2::ZERO;
        Self {
            m1_g: tidy(g_from_kg(collision.striker.mass)),
            m2_g: tidy(g_from_kg(collision.target.mass)),
            r1_mm: tidy(mm_from_m(collision.striker.radius)),
            r2_mm: tidy(mm_from_m(collision.target.radius)),
            speed: tidy(collision.u1.length()),
            aim_deg: degrees(collision.u1),
            target_speed: tidy(collision.u2.length()),
            target_deg: if moves { degrees(collision.u2) } else { 90.0 },
            point: ImpactPoint::Offset {
                offset_mm: tidy(mm_from_m(collision.offset)),
            },
            restitution: collision.restitution,
            bond: collision.bond,
            rims: collision.rims,
        }
    }
}

impl Collision {
    /// The same collision at another point of impact.
    #[must_use]
    pub(crate) fn meeting_at(self, point: ImpactPoint) -> Self {
        match point {
            ImpactPoint::Angle { alpha_deg } => self.with_alpha_deg(alpha_deg),
            ImpactPoint::Offset { offset_mm } => Self {
                offset: m_from_mm(offset_mm),
                offset_rest: 0.0,
                ..self
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_fields_it_is_the_worked_shot() {
        let after = CollisionSpec::default().collision().outcome();
        assert!((after.v1.length() - 2.0).abs() < 1e-12);
        assert!((after.v2.length() - 12.0_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn fields_outside_their_ranges_are_refused() {
        let mut spec = CollisionSpec::default();
        assert_eq!(spec.set("m2_g", "40"), Ok(()));
        assert!((spec.collision().target.mass - 0.040).abs() < 1e-15);
        for (field, value, message) in [
            (
                "m1_g",
                "-3",
                "m1_g: expected a mass in g from 0.1 to 1000, found -3",
            ),
            (
                "speed",
                "NaN",
                "speed: expected a speed in m/s from 0.1 to 20, found NaN",
            ),
            ("stick", "yes", "stick: expected true or false, found yes"),
        ] {
            assert_eq!(spec.set(field, value), Err(message.to_owned()));
        }
        assert!(spec.set("mass", "3").is_err());
        assert_eq!(spec.set("offset_mm", "40"), Ok(()));
        assert!(spec.check().is_err());
    }

    #[test]
    fn every_field_is_set_by_its_name() {
        for range in CollisionSpec::RANGES {
            let mut spec = CollisionSpec::default();
            let written = (0.3 * range.least + 0.7 * range.most).to_string();
            assert_eq!(spec.set(range.name, &written), Ok(()));
            assert_ne!(spec, CollisionSpec::default(), "{}", range.name);
        }
    }
}

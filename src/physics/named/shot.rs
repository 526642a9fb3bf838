//! A collision by the fields that files write it with.

use glam::DVec2;

use super::super::units::{kg_from_g, m_from_mm, rad_from_deg};
use super::super::{Bond, Collision, Disc};

/// A collision as a chapter or a concept question writes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shot {
    m1_g: f64,
    m2_g: f64,
    r1_mm: f64,
    r2_mm: f64,
    speed: f64,
    place: Place,
    restitution: f64,
    stick: bool,
    target_speed: f64,
    target_deg: f64,
}

/// Where the two meet.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    /// By the impact angle in degrees.
    Angle(f64),
    /// By the offset in millimetres.
    Offset(f64),
}

impl Default for Shot {
    /// The worked shot: 15 g on 15 g at 4 m/s and 30°, smooth and without loss.
    fn default() -> Self {
        Self {
            m1_g: 15.0,
            m2_g: 15.0,
            r1_mm: 15.0,
            r2_mm: 15.0,
            speed: 4.0,
            place: Place::Angle(30.0),
            restitution: 1.0,
            stick: false,
            target_speed: 0.0,
            target_deg: 90.0,
        }
    }
}

/// A field's name, what it is and the least and the most it may be.
type Scale = (&'static str, &'static str, f64, f64);

/// The fields that hold a number.
const SCALES: [Scale; 10] = [
    ("m1_g", "a mass in g", 0.1, 1000.0),
    ("m2_g", "a mass in g", 0.1, 1000.0),
    ("r1_mm", "a radius in mm", 5.0, 60.0),
    ("r2_mm", "a radius in mm", 5.0, 60.0),
    ("speed", "a speed in m/s", 0.1, 20.0),
    ("alpha_deg", "an impact angle in degrees", -90.0, 90.0),
    ("offset_mm", "an offset in mm", -150.0, 150.0),
    ("restitution", "a restitution", 0.0, 1.0),
    ("target_speed", "a speed in m/s", 0.0, 20.0),
    ("target_deg", "a direction in degrees", -180.0, 180.0),
];

impl Shot {
    /// The names of its fields in a file.
    pub fn field_names() -> Vec<&'static str> {
        let names = SCALES.iter().map(|(name, ..)| *name);
        names.chain(["stick"]).collect()
    }

    /// Whether a shot has a field of this name.
    pub fn has(field: &str) -> bool {
        field == "stick" || SCALES.iter().any(|(name, ..)| *name == field)
    }

    /// Sets a field from what is written for it.
    ///
    /// # Errors
    /// What was expected, if there is no such field or the value is none for it.
    pub fn set(&mut self, field: &str, written: &str) -> Result<(), String> {
        if field == "stick" {
            self.stick = match written {
                "true" => true,
                "false" => false,
                _ => return Err(format!("stick: expected true or false, found {written}")),
            };
            return Ok(());
        }
        let Some((_, what, least, most)) = SCALES.iter().find(|(name, ..)| *name == field) else {
            let names: Vec<_> = SCALES.iter().map(|(name, ..)| *name).collect();
            let names = names.join(", ");
            return Err(format!(
                "expected a field of a shot ({names}, stick), found {field}"
            ));
        };
        let wrong = || format!("{field}: expected {what} from {least} to {most}, found {written}");
        let value: f64 = written.parse().map_err(|_| wrong())?;
        if !(*least..=*most).contains(&value) {
            return Err(wrong());
        }
        let slot = match field {
            "m1_g" => &mut self.m1_g,
            "m2_g" => &mut self.m2_g,
            "r1_mm" => &mut self.r1_mm,
            "r2_mm" => &mut self.r2_mm,
            "speed" => &mut self.speed,
            "restitution" => &mut self.restitution,
            "target_speed" => &mut self.target_speed,
            "target_deg" => &mut self.target_deg,
            "offset_mm" => {
                self.place = Place::Offset(value);
                return Ok(());
            }
            _ => {
                self.place = Place::Angle(value);
                return Ok(());
            }
        };
        *slot = value;
        Ok(())
    }

    /// Whether it says where the two meet by the offset rather than by the angle.
    pub fn is_by_offset(&self) -> bool {
        matches!(self.place, Place::Offset(_))
    }

    /// Checks the names of fields that are written together.
    ///
    /// # Errors
    /// What was expected.
    pub fn check_fields<'a>(names: impl IntoIterator<Item = &'a str>) -> Result<(), String> {
        let places = |name: &&str| ["alpha_deg", "offset_mm"].contains(name);
        match names.into_iter().filter(places).count() {
            0 | 1 => Ok(()),
            _ => Err("expected alpha_deg or offset_mm, found both: \
                      each says where the two meet"
                .into()),
        }
    }

    /// Checks what no field can tell alone.
    ///
    /// # Errors
    /// What was expected.
    pub fn check(&self) -> Result<(), String> {
        let most = 1.25 * (self.r1_mm + self.r2_mm);
        match self.place {
            Place::Offset(offset) if offset.abs() > most => Err(format!(
                "offset_mm: expected at most {most} mm, 1.25 times both radii, found {offset}"
            )),
            _ => Ok(()),
        }
    }

    /// The collision; the striker moves along +x.
    pub fn collision(&self) -> Collision {
        let disc = |mass_g: f64, radius_mm: f64| Disc {
            mass: kg_from_g(mass_g),
            radius: m_from_mm(radius_mm),
        };
        let head_on = Collision {
            striker: disc(self.m1_g, self.r1_mm),
            target: disc(self.m2_g, self.r2_mm),
            u1: DVec2::new(self.speed, 0.0),
            u2: self.target_velocity(),
            offset: 0.0,
            restitution: self.restitution,
            bond: if self.stick { Bond::Stick } else { Bond::Slip },
        };
        match self.place {
            Place::Angle(alpha_deg) => head_on.with_alpha(rad_from_deg(alpha_deg)),
            Place::Offset(offset_mm) => Collision {
                offset: m_from_mm(offset_mm),
                ..head_on
            },
        }
    }

    /// Exactly nothing for a target at rest, whatever its direction.
    fn target_velocity(&self) -> DVec2 {
        if self.target_speed > 0.0 {
            self.target_speed * DVec2::from_angle(rad_from_deg(self.target_deg))
        } else {
            DVec2::ZERO
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_said_is_the_worked_shot() {
        let after = Shot::default().collision().outcome();
        assert!((after.v1.length() - 2.0).abs() < 1e-12);
        assert!((after.v2.length() - 12.0_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn fields_are_held_to_their_ranges() {
        let mut shot = Shot::default();
        assert_eq!(shot.set("m2_g", "40"), Ok(()));
        assert!((shot.collision().target.mass - 0.040).abs() < 1e-15);
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
            assert_eq!(shot.set(field, value), Err(message.to_owned()));
        }
        assert!(shot.set("mass", "3").is_err());
        assert_eq!(shot.set("offset_mm", "40"), Ok(()));
        assert!(shot.check().is_err());
    }
}

//! Numbers that describe beams and Rutherford's atom, not a collision of two discs.

use super::super::beam::Beam;
use super::super::rutherford::{ALPHA_CHARGE, FM, GOLD_DENSITY, MEASURED_SHARE, MEV, Rutherford};
use super::super::units::rad_from_deg;

/// The fields from which a [`Constant`] is computed, in the units used in files.
#[derive(Debug, Clone, Copy, PartialEq)]
struct ConstantFields {
    angle_deg: f64,
    to_deg: f64,
    z: f64,
    energy_mev: f64,
    thickness_um: f64,
}

impl Default for ConstantFields {
    /// The default values: α-particles from radium C on Geiger and Marsden's gold foil of 1913.
    fn default() -> Self {
        Self {
            angle_deg: 60.0,
            to_deg: 120.0,
            z: 79.0,
            energy_mev: 7.69,
            thickness_um: 0.21,
        }
    }
}

impl ConstantFields {
    fn angle(&self) -> f64 {
        rad_from_deg(self.angle_deg)
    }

    fn centre(&self) -> Rutherford {
        Rutherford::new(ALPHA_CHARGE, self.z, self.energy_mev * MEV)
    }

    /// Atoms per square metre of the foil; the density is that of gold.
    fn atoms_per_area(&self) -> f64 {
        GOLD_DENSITY * self.thickness_um * 1e-6
    }
}

/// The solid angle of 1 mm² at 1 cm, in steradians.
const SCREEN: f64 = 1e-6 / 1e-4;

type ConstantFormula = fn(&ConstantFields) -> Option<f64>;

/// The names and their formulas.
const ALL: [(&str, ConstantFormula); 9] = [
    ("board_share", |f| Some(Beam::Board.share_beyond(f.angle()))),
    ("space_share", |f| Some(Beam::Space.share_beyond(f.angle()))),
    ("rutherford_d_fm", |f| {
        Some(f.centre().head_on_approach / FM)
    }),
    ("rutherford_b_fm", |f| {
        Some(f.centre().impact_parameter(f.angle())? / FM)
    }),
    ("rutherford_r_fm", |f| {
        Some(f.centre().closest_approach(f.angle())? / FM)
    }),
    ("rutherford_share", |f| {
        f.centre().share_into(f.angle(), SCREEN, f.atoms_per_area())
    }),
    ("measured_share", |_| Some(MEASURED_SHARE)),
    ("rutherford_beyond", |f| {
        Some(f.centre().cross_section_beyond(f.angle())? * f.atoms_per_area())
    }),
    ("rutherford_ratio", |f| {
        let count = |deg| f.centre().differential_cross_section(rad_from_deg(deg));
        Some(count(f.angle_deg)? / count(f.to_deg)?)
    }),
];

/// A number that does not follow from a collision.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Constant {
    of: ConstantFormula,
    fields: ConstantFields,
}

impl Constant {
    /// The constant with this name, with its default fields.
    pub(crate) fn named(name: &str) -> Option<Self> {
        let (_, of) = ALL.into_iter().find(|(known, _)| *known == name)?;
        Some(Self {
            of,
            fields: ConstantFields::default(),
        })
    }

    /// Sets a field from its text.
    ///
    /// # Errors
    /// If there is no such field, or the text is not a number in its range, returns a message that
    /// says what was expected.
    pub(crate) fn set(&mut self, field: &str, written: &str) -> Result<(), String> {
        let fields = &mut self.fields;
        let (slot, least, most) = match field {
            "angle_deg" => (&mut fields.angle_deg, 0.001, 180.0),
            "to_deg" => (&mut fields.to_deg, 0.001, 180.0),
            "z" => (&mut fields.z, 1.0, 118.0),
            "energy_mev" => (&mut fields.energy_mev, 0.01, 1000.0),
            "thickness_um" => (&mut fields.thickness_um, 0.001, 100.0),
            _ => {
                return Err(format!(
                    "expected angle_deg, to_deg, z, energy_mev or thickness_um, found {field}"
                ));
            }
        };
        let wrong = || format!("{field}: expected {least} to {most}, found {written}");
        let value: f64 = written.parse().map_err(|_| wrong())?;
        if !(least..=most).contains(&value) {
            return Err(wrong());
        }
        *slot = value;
        Ok(())
    }

    /// The value, in the unit that the constant's name contains.
    pub(crate) fn value(&self) -> Option<f64> {
        (self.of)(&self.fields).filter(|value| value.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(name: &str, fields: &[(&str, &str)]) -> f64 {
        let mut constant = Constant::named(name).unwrap();
        for (field, written) in fields {
            constant.set(field, written).unwrap();
        }
        constant.value().unwrap()
    }

    #[test]
    fn well_known_values_are_reproduced() {
        assert!((value("board_share", &[]) - 0.5).abs() < 1e-12);
        assert!((value("space_share", &[]) - 0.25).abs() < 1e-12);
        assert!((value("rutherford_d_fm", &[]) - 29.6).abs() < 0.05);
        assert!((value("rutherford_share", &[("angle_deg", "45")]) - 3.2e-7).abs() < 0.05e-7);
        // The count at 60° divided by that at 120°: (sin 60° / sin 30°)⁴ = 9.
        assert!((value("rutherford_ratio", &[]) - 9.0).abs() < 1e-9);
        // For scattering straight back, the closest approach is d itself.
        let back = value("rutherford_r_fm", &[("angle_deg", "180")]);
        assert!((back - value("rutherford_d_fm", &[])).abs() < 1e-9);
    }

    #[test]
    fn the_manual_lists_every_constant() {
        let manual = include_str!("../../../docs/lessons.md");
        for (name, _) in ALL {
            assert!(manual.contains(&format!("`{name}`")), "{name}");
        }
    }
}

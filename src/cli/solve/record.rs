//! A problem read from one line of JSON.
//!
//! The deserializer is written by hand rather than derived, so that every error names its field and
//! a line is read in one pass without allocating.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};

use super::problem::Problem;

#[derive(Debug, Clone, Copy, serde::Deserialize)]
#[serde(field_identifier, rename_all = "snake_case")]
enum ProblemKey {
    M1G,
    M2G,
    U1,
    U2,
    AlphaDeg,
    OffsetMm,
    R1Mm,
    R2Mm,
    Restitution,
    Stick,
    RimFriction,
    Spin1,
    Spin2,
}

impl<'de> Deserialize<'de> for Problem {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(ProblemVisitor)
    }
}

struct ProblemVisitor;

impl<'de> Visitor<'de> for ProblemVisitor {
    type Value = Problem;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object with m1_g, m2_g, u1 and alpha_deg")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Problem, A::Error> {
        let mut problem = Problem::default();
        while let Some(field) = map.next_key()? {
            match field {
                ProblemKey::M1G => set(&mut problem.m1_g, "m1_g", &mut map)?,
                ProblemKey::M2G => set(&mut problem.m2_g, "m2_g", &mut map)?,
                ProblemKey::U1 => set(&mut problem.u1, "u1", &mut map)?,
                ProblemKey::U2 => set(&mut problem.u2, "u2", &mut map)?,
                ProblemKey::AlphaDeg => set(&mut problem.alpha_deg, "alpha_deg", &mut map)?,
                ProblemKey::OffsetMm => set(&mut problem.offset_mm, "offset_mm", &mut map)?,
                ProblemKey::R1Mm => set(&mut problem.r1_mm, "r1_mm", &mut map)?,
                ProblemKey::R2Mm => set(&mut problem.r2_mm, "r2_mm", &mut map)?,
                ProblemKey::Restitution => set(&mut problem.restitution, "restitution", &mut map)?,
                ProblemKey::Stick => set(&mut problem.stick, "stick", &mut map)?,
                ProblemKey::RimFriction => {
                    set(&mut problem.rim_friction, "rim_friction", &mut map)?;
                }
                ProblemKey::Spin1 => set(&mut problem.spin1, "spin1", &mut map)?,
                ProblemKey::Spin2 => set(&mut problem.spin2, "spin2", &mut map)?,
            }
        }
        Ok(problem)
    }
}

/// Reads the value of one field, which may occur only once per line.
fn set<'de, T: Deserialize<'de>, A: MapAccess<'de>>(
    slot: &mut Option<T>,
    field: &'static str,
    map: &mut A,
) -> Result<(), A::Error> {
    if slot.is_some() {
        return Err(Error::duplicate_field(field));
    }
    let value = map.next_value();
    *slot = Some(value.map_err(|error: A::Error| Error::custom(format_args!("{field}: {error}")))?);
    Ok(())
}

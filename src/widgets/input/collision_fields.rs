//! The settings of a collision: one table of names, ranges, steps and units for the lab, for
//! figures in chapters and for all other screens that set up a collision.

use strum::VariantArray;

use super::{Field, FieldRow, FieldValue};
use crate::numbers::fixed;
use crate::physics::{Bond, CollisionSpec, ImpactPoint};

/// One setting of a collision.
#[derive(Debug, Clone, Copy, PartialEq, Eq, VariantArray)]
pub(crate) enum CollisionField {
    /// Impact parameter b.
    Offset,
    /// Impact angle α, an alternative way to set the offset.
    ImpactAngle,
    /// Direction of the striker.
    Aim,
    /// Speed of the striker.
    Speed,
    /// Coefficient of restitution.
    Restitution,
    /// Whether the rims slip or stick.
    Contact,
    /// Mass of the striker.
    StrikerMass,
    /// Mass of the coin.
    CoinMass,
    /// Radius of the striker.
    StrikerRadius,
    /// Radius of the coin.
    CoinRadius,
    /// Initial speed of the coin.
    CoinSpeed,
    /// Initial direction of the coin.
    CoinAim,
    /// Coefficient of friction between the rims.
    RimFriction,
    /// Spin of the striker; shown only if the rims have friction or a disc spins.
    StrikerSpin,
    /// Spin of the coin; shown under the same conditions as the striker's spin.
    CoinSpin,
}

type Row = FieldRow<CollisionSpec>;

/// All settings, in the order of [`CollisionField`] and of the panel in the lab.
static ROWS: [Row; CollisionField::VARIANTS.len()] = [
    Row {
        name: "offset b",
        about: "how far off-centre the hit is: + coin to the right, - coin to the left",
        now: |spec| {
            let (offset, widest) = (spec.offset_mm(), widest_mm(spec));
            let value = FieldValue::number(offset, (-widest, widest), 0.5, " mm");
            let shown = format!("{} mm{}", fixed(offset.abs(), 1), side(offset));
            (value, shown)
        },
        put: |spec, offset_mm| spec.point = ImpactPoint::Offset { offset_mm },
    },
    Row {
        name: "impact angle",
        about: "the same offset, as the angle between the striker's path and n",
        now: |spec| {
            let alpha = alpha_deg(spec);
            let value = FieldValue::number(alpha, within("alpha_deg"), 1.0, "°");
            let shown = match spec.offset_mm().abs() > spec.contact_distance_mm() {
                true => "a miss".into(),
                false => fixed(alpha.abs(), 1) + "°",
            };
            (value, shown)
        },
        put: |spec, alpha_deg| {
            let offset_mm = spec.contact_distance_mm() * alpha_deg.to_radians().sin();
            spec.point = ImpactPoint::Offset { offset_mm };
        },
    },
    Row {
        name: "aim",
        about: "the striker's direction; everything turns with it",
        now: |spec| FieldValue::decimal(spec.aim_deg, ANY, 5.0, (0, "°")),
        put: |spec, degrees| spec.aim_deg = wrap_degrees(degrees),
    },
    Row {
        name: "speed",
        about: "the striker's speed; no angle depends on it if the coin is at rest and nothing spins",
        now: |spec| ranged("speed", spec.speed, 0.25, (2, " m/s")),
        put: |spec, speed| spec.speed = speed,
    },
    Row {
        name: "restitution e",
        about: "speed of separation over speed of approach along n; 1: no energy lost",
        now: |spec| ranged("restitution", spec.restitution, 0.05, (2, "")),
        put: |spec, restitution| spec.restitution = restitution,
    },
    Row {
        name: "contact",
        about: "slip: smooth rims push only along n; stick: rims hold together",
        now: |spec| FieldValue::choice((spec.bond == Bond::Stick).into(), &["slip", "stick"]),
        put: |spec, at| spec.bond = if at > 0.5 { Bond::Stick } else { Bond::Slip },
    },
    Row {
        name: "striker mass",
        about: "the striker's mass; only the ratio matters",
        now: |spec| ranged("m1_g", spec.m1_g, 0.5, (1, " g")),
        put: |spec, grams| spec.m1_g = grams,
    },
    Row {
        name: "coin mass",
        about: "the coin's mass; equal masses leave at 90° to each other",
        now: |spec| ranged("m2_g", spec.m2_g, 0.5, (1, " g")),
        put: |spec, grams| spec.m2_g = grams,
    },
    Row {
        name: "striker radius",
        about: "the striker's radius; the discs touch if b is at most r₁ + r₂",
        now: |spec| ranged("r1_mm", spec.r1_mm, 0.5, (2, " mm")),
        put: |spec, radius_mm| spec.r1_mm = radius_mm,
    },
    Row {
        name: "coin radius",
        about: "the coin's radius; the discs touch if b is at most r₁ + r₂",
        now: |spec| ranged("r2_mm", spec.r2_mm, 0.5, (2, " mm")),
        put: |spec, radius_mm| spec.r2_mm = radius_mm,
    },
    Row {
        name: "coin speed",
        about: "the coin's initial speed; 0: it is at rest",
        now: |spec| ranged("target_speed", spec.target_speed, 0.25, (2, " m/s")),
        put: |spec, speed| spec.target_speed = speed,
    },
    Row {
        name: "coin aim",
        about: "the coin's initial direction, if it moves",
        now: |spec| FieldValue::decimal(spec.target_deg, ANY, 5.0, (0, "°")),
        put: |spec, degrees| spec.target_deg = wrap_degrees(degrees),
    },
    Row {
        name: "rim friction μᵣ",
        about: "friction between the rims; 0: smooth, as on the board",
        now: |spec| ranged("rim_friction", spec.rims.friction, 0.05, (2, "")),
        put: |spec, friction| spec.rims.friction = friction,
    },
    Row {
        name: "striker spin",
        about: "the striker's spin before the collision; + anticlockwise",
        now: |spec| ranged("spin1", spec.rims.spins[0], 10.0, (1, " rad/s")),
        put: |spec, spin| spec.rims.spins[0] = spin,
    },
    Row {
        name: "coin spin",
        about: "the coin's spin before the collision; + anticlockwise",
        now: |spec| ranged("spin2", spec.rims.spins[1], 10.0, (1, " rad/s")),
        put: |spec, spin| spec.rims.spins[1] = spin,
    },
];

impl CollisionField {
    /// The form field for this setting, with its current value.
    pub(crate) fn field(self, spec: &CollisionSpec) -> Field {
        ROWS[self as usize].field(spec)
    }

    /// Sets the value, clamped to its range. When a radius changes, the offset stays the same, or
    /// is clamped to its new range.
    pub(crate) fn set(self, spec: &mut CollisionSpec, value: f64) {
        set_at(self as usize, spec, value);
    }
}

/// All settings with their current values, in the order of [`CollisionField`]. Without friction,
/// spin has no effect, so the spins, which come last, are left out unless a disc spins.
pub(crate) fn collision_fields(spec: &CollisionSpec) -> Vec<Field> {
    let shown = match spec.rims.is_plain() {
        true => CollisionField::StrikerSpin as usize,
        false => ROWS.len(),
    };
    ROWS[..shown].iter().map(|row| row.field(spec)).collect()
}

/// Sets the field at an index, like [`CollisionField::set`].
pub(crate) fn set_at(at: usize, spec: &mut CollisionSpec, value: f64) {
    let offset_mm = spec.offset_mm();
    spec.point = ImpactPoint::Offset { offset_mm };
    if let Some(row) = ROWS.get(at) {
        row.set(spec, value);
    }
    let widest = widest_mm(spec);
    let offset_mm = spec.offset_mm().clamp(-widest, widest);
    spec.point = ImpactPoint::Offset { offset_mm };
}

/// The range of a direction: every number is valid.
const ANY: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// The range of values that a field may have in a file.
fn within(name: &str) -> (f64, f64) {
    let range = CollisionSpec::RANGES.iter().find(|it| it.name == name);
    range.map_or(ANY, |range| (range.least, range.most))
}

/// A number with the range that it may have in a file under this name, and its text.
fn ranged(
    name: &str,
    value: f64,
    step: f64,
    decimals_and_unit: (usize, &'static str),
) -> (FieldValue, String) {
    FieldValue::decimal(value, within(name), step, decimals_and_unit)
}

/// The impact angle in degrees; for a miss, the angle of a graze on the same side.
fn alpha_deg(spec: &CollisionSpec) -> f64 {
    let ratio = spec.offset_mm() / spec.contact_distance_mm();
    ratio.clamp(-1.0, 1.0).asin().to_degrees()
}

/// Describes the side on which the coin lies.
fn side(offset_mm: f64) -> &'static str {
    match offset_mm {
        mm if mm > 0.0 => " right",
        mm if mm < 0.0 => " left",
        _ => "",
    }
}

/// The largest offset in mm, slightly more than r₁ + r₂, so that a miss can be set.
fn widest_mm(spec: &CollisionSpec) -> f64 {
    spec.contact_distance_mm() * CollisionSpec::WIDEST
}

/// Wraps a direction to the range (−180, 180].
fn wrap_degrees(degrees: f64) -> f64 {
    180.0 - (180.0 - degrees).rem_euclid(360.0)
}

#[cfg(test)]
mod tests {
    use super::CollisionField as F;
    use super::*;

    fn step(field: F, spec: &mut CollisionSpec, steps: f64) {
        let value = field.field(spec).value.stepped(steps);
        field.set(spec, value);
    }

    #[test]
    fn every_setting_stays_in_its_range() {
        for at in 0..ROWS.len() {
            for wild in [-1e9, -0.0, 0.0, 1e9, 37.25] {
                let mut spec = CollisionSpec::default();
                spec.rims.friction = 0.2;
                spec.rims.spins = [1.0; 2];
                set_at(at, &mut spec, wild);
                let field = &collision_fields(&spec)[at];
                let (value, (low, high)) = match field.value {
                    FieldValue::Number { value, range, .. } if range.1.is_finite() => {
                        (value, range)
                    }
                    FieldValue::Number { value, .. } => (value, (-180.0, 180.0)),
                    FieldValue::Choice { at, .. } => (at as f64, (0.0, 1.0)),
                    FieldValue::Text(_) => continue,
                };
                assert!((low..=high).contains(&value), "{} {value}", field.name);
            }
        }
    }

    #[test]
    fn steps_end_on_the_grid() {
        let mut spec = CollisionSpec::default();
        F::Offset.set(&mut spec, 7.3);
        step(F::Offset, &mut spec, 1.0);
        assert_eq!(spec.offset_mm(), 7.5);
        F::Offset.set(&mut spec, 7.3);
        for expected in [7.0, 6.5] {
            step(F::Offset, &mut spec, -1.0);
            assert_eq!(spec.offset_mm(), expected);
        }
    }

    #[test]
    fn directions_wrap_around() {
        let mut spec = CollisionSpec::default();
        F::Aim.set(&mut spec, 180.0);
        step(F::Aim, &mut spec, 1.0);
        assert_eq!(spec.aim_deg, -175.0);
        F::Aim.set(&mut spec, 725.0);
        assert_eq!(spec.aim_deg, 5.0);
    }

    #[test]
    fn a_smaller_disc_reduces_the_offset_to_its_range() {
        let mut spec = CollisionSpec::default();
        F::Offset.set(&mut spec, 37.0);
        F::CoinRadius.set(&mut spec, 5.0);
        assert_eq!(spec.offset_mm(), 25.0);
    }
}

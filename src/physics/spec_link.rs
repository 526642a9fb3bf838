//! A collision as part of a link: `m1:15,m2:5.5,b:12,e:0.8`.

use super::{Bond, CollisionSpec, FieldRange, ImpactPoint};

/// The striker's direction, which files do not contain.
const AIM: FieldRange = FieldRange::new("aim", "a direction in degrees", -180.0, 180.0);

/// The field name in files for each short name.
const SHORT: [(&str, &str); 14] = [
    ("m1", "m1_g"),
    ("m2", "m2_g"),
    ("r1", "r1_mm"),
    ("r2", "r2_mm"),
    ("u", "speed"),
    ("alpha", "alpha_deg"),
    ("b", "offset_mm"),
    ("e", "restitution"),
    ("u2", "target_speed"),
    ("dir2", "target_deg"),
    ("stick", "stick"),
    ("mu", "rim_friction"),
    ("spin1", "spin1"),
    ("spin2", "spin2"),
];

impl CollisionSpec {
    /// The fields whose values differ from those of the worked shot; empty if there are none. Each
    /// number is written with all its digits, so that [`from_link`](Self::from_link) gives exactly
    /// the same collision.
    pub fn to_link(self) -> String {
        let usual = Self::default();
        let mut parts = Vec::new();
        let mut put = |name: &str, value: f64, usual: f64| {
            if value.to_bits() != usual.to_bits() {
                parts.push(format!("{name}:{value}"));
            }
        };
        put("m1", self.m1_g, usual.m1_g);
        put("m2", self.m2_g, usual.m2_g);
        put("r1", self.r1_mm, usual.r1_mm);
        put("r2", self.r2_mm, usual.r2_mm);
        put("u", self.speed, usual.speed);
        put("aim", self.aim_deg, usual.aim_deg);
        match self.point {
            ImpactPoint::Angle { alpha_deg } => put("alpha", alpha_deg, 30.0),
            ImpactPoint::Offset { offset_mm } => put("b", offset_mm, f64::NAN),
        }
        put("e", self.restitution, usual.restitution);
        put("u2", self.target_speed, usual.target_speed);
        put("dir2", self.target_deg, usual.target_deg);
        put("mu", self.rims.friction, 0.0);
        put("spin1", self.rims.spins[0], 0.0);
        put("spin2", self.rims.spins[1], 0.0);
        if self.bond == Bond::Stick {
            parts.push("stick:true".into());
        }
        parts.join(",")
    }

    /// Reads the text that [`to_link`](Self::to_link) gives.
    ///
    /// # Errors
    /// Returns a message that says what was expected instead.
    pub fn from_link(text: &str) -> Result<Self, String> {
        let mut spec = Self::default();
        let mut named = Vec::new();
        for part in text.split(',').filter(|part| !part.is_empty()) {
            let (name, value) = part.split_once(':').unwrap_or((part, ""));
            if name == AIM.name {
                spec.aim_deg = AIM.check(value.parse().unwrap_or(f64::NAN), value)?;
                continue;
            }
            let field = SHORT.iter().find(|(short, _)| *short == name);
            let Some((_, field)) = field else {
                let names = SHORT.map(|(short, _)| short).join(", ");
                return Err(format!(
                    "a collision such as m1:15,m2:5.5,b:12,e:0.8, with any of {names}, aim"
                ));
            };
            spec.set(field, value)?;
            named.push(*field);
        }
        Self::check_fields(named)?;
        spec.check()?;
        Ok(spec)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::Rims;

    #[test]
    fn a_link_gives_exactly_the_same_collision() {
        let usual = CollisionSpec::default();
        let offset = |offset_mm| CollisionSpec {
            point: ImpactPoint::Offset { offset_mm },
            ..usual
        };
        for spec in [
            usual,
            offset(0.0),
            offset(-12.345_678_901_234_5),
            CollisionSpec {
                m1_g: 0.1 + 0.2,
                m2_g: 5.5,
                aim_deg: -75.0,
                target_speed: 1e-7,
                restitution: 0.8,
                bond: Bond::Stick,
                ..usual
            },
            CollisionSpec {
                rims: Rims {
                    friction: 0.2,
                    spins: [-30.25, 1e-3],
                },
                ..usual
            },
        ] {
            assert_eq!(CollisionSpec::from_link(&spec.to_link()), Ok(spec));
        }
        assert_eq!(usual.to_link(), "");
        let linked = CollisionSpec::from_link("m1:15,m2:5.5,b:12,e:0.8").unwrap();
        assert_eq!(linked.to_link(), "m2:5.5,b:12,e:0.8");
    }

    #[test]
    fn a_malformed_link_reports_what_was_expected() {
        for (link, message) in [
            ("m1", "m1_g: expected a mass in g from 0.1 to 1000, found "),
            (
                "m1:1e9",
                "m1_g: expected a mass in g from 0.1 to 1000, found 1e9",
            ),
            (
                "aim:200",
                "expected a direction in degrees from -180 to 180, found 200",
            ),
            (
                "b:40",
                "offset_mm: expected at most 37.5 mm, 1.25 times the sum of the radii, found 40",
            ),
            (
                "b:1,alpha:3",
                "expected alpha_deg or offset_mm, found both: each sets where the discs meet",
            ),
        ] {
            assert_eq!(CollisionSpec::from_link(link), Err(message.to_owned()));
        }
        assert!(CollisionSpec::from_link("mass:3").is_err());
    }
}

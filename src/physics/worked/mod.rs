//! A collision worked out step by step, as a teacher would write it on the board.
//!
//! The steps are data: a title, the reason for the step and the lines of working with the numbers
//! filled in. The code that shows them chooses the layout and the symbols. In the working, masses
//! are in g, lengths in mm and speeds in m/s.

mod number;
mod rough;
mod slip;
mod stick;
mod words;

pub(crate) use number::{beside, number};

use glam::DVec2;

use super::units::{g_from_kg, mm_from_m};
use super::{Bond, Collision, CollisionOutcome, Meeting};
use number::{degrees, vector};

/// One step of a worked solution.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WorkedStep {
    /// What the step does.
    pub title: &'static str,
    /// The reason for the step, or what the step means, in a sentence or two; may be empty.
    pub why: String,
    /// The working, one formula or result per line; a line that continues the previous line begins
    /// with spaces.
    pub lines: Vec<String>,
}

/// The whole solution: what is known, the working, a check and the result in words. The problem
/// gives the impact angle or, if `by_offset` is set, the offset and both radii.
pub(crate) fn steps(collision: &Collision, by_offset: bool) -> Vec<WorkedStep> {
    let outcome = collision.outcome();
    let mut steps = vec![knowns(collision, by_offset)];
    if by_offset {
        steps.push(where_they_meet(collision));
    }
    if outcome.meeting == Meeting::Hit {
        steps.extend(match collision.bond {
            Bond::Slip => slip::steps(collision, &outcome),
            Bond::Stick => stick::steps(collision, &outcome),
        });
        steps.push(check(collision, &outcome));
    }
    steps.push(WorkedStep {
        title: "In words",
        why: words::result(collision, &outcome),
        lines: Vec::new(),
    });
    steps
}

fn knowns(c: &Collision, by_offset: bool) -> WorkedStep {
    let body = |name: &str, sub: char, mass: f64, u: DVec2| {
        let (components, speed) = (vector(u, 0.0), number(u.length()));
        let velocity = match u.length() > 0.0 {
            true => format!("{components} m/s, speed {speed} m/s"),
            false => "0, at rest".to_owned(),
        };
        format!("{name}  m{sub} = {} g   u{sub} = {velocity}", grams(mass))
    };
    let mut lines = vec![
        body("striker", '₁', c.striker.mass, c.u1),
        body("target ", '₂', c.target.mass, c.u2),
    ];
    let plain = c.rims.is_plain();
    if by_offset || c.bond == Bond::Stick || !plain {
        let (r1, r2) = (c.striker.radius, c.target.radius);
        lines.push(format!("radii    r₁ = {} mm   r₂ = {} mm", mm(r1), mm(r2)));
    }
    lines.push(match c.alpha() {
        _ if by_offset => format!("offset   b = {} mm", mm(c.offset)),
        Some(alpha) => format!("impact angle  α = {}", degrees(alpha)),
        None => "impact angle  none: the striker does not move relative to the target".to_owned(),
    });
    lines.push(match c.bond {
        Bond::Slip if c.rims.friction > 0.0 => {
            format!("restitution  e = {}, rough rims", number(c.restitution))
        }
        Bond::Slip => format!("restitution  e = {}, smooth discs", number(c.restitution)),
        Bond::Stick => "perfectly inelastic: the discs move on together".to_owned(),
    });
    if !plain {
        lines.extend(rough::knowns(c));
    }
    WorkedStep {
        title: "What we know",
        why: "The impact angle α is measured from the striker's velocity relative to the target \
              to the line of impact n through both centres. α is positive when the target's centre \
              lies to the right of that velocity."
            .to_owned(),
        lines,
    }
}

fn where_they_meet(c: &Collision) -> WorkedStep {
    let (r1, r2, reach) = (c.striker.radius, c.target.radius, c.contact_distance());
    let (sum, b) = (mm(reach), mm(c.offset));
    let squareness = match c.alpha() {
        Some(alpha) => {
            let (sine, alpha) = (beside(c.offset / reach, 1.0), degrees(alpha));
            format!("sin α = b / (r₁ + r₂) = {b} / {sum} = {sine},  α = {alpha}")
        }
        None if c.offset.abs() > reach => {
            let b = mm(c.offset.abs());
            format!("b is {b} mm and r₁ + r₂ only {sum} mm: the discs miss each other")
        }
        None => "u₁ = u₂: the distance between the discs never changes".to_owned(),
    };
    WorkedStep {
        title: "Do the discs collide, and at which impact angle?",
        why: "When the discs touch, their centres are r₁ + r₂ apart, and the offset b is the \
              side opposite α in the right-angled triangle with that hypotenuse."
            .to_owned(),
        lines: vec![
            format!("r₁ + r₂ = {} + {} = {sum} mm", mm(r1), mm(r2)),
            squareness,
        ],
    }
}

/// Speeds and angles after a hit.
fn directions(c: &Collision, after: &CollisionOutcome) -> WorkedStep {
    let separation = match after.separation {
        Some(angle) => format!("angle between the paths, from v₁ to v₂: {}", degrees(angle)),
        None => {
            "angle between the paths: undefined, because a disc at rest has no direction".into()
        }
    };
    let mut lines = vec![
        angle_line("θ₁", after.theta1, c.u1, after.v1),
        angle_line("θ₂", after.theta2, c.u1, after.v2),
        separation,
    ];
    if let Some(throw) = c.throw().filter(|throw| *throw != 0.0) {
        lines.push(format!(
            "throw from n: tan δ = Jₜ / Jₙ, δ = {}",
            degrees(throw)
        ));
    }
    WorkedStep {
        title: "Read off the angles",
        why: "Both angles are measured from the striker's original direction u₁: θ₁ to the \
              striker's final direction, θ₂ to the target's."
            .to_owned(),
        lines,
    }
}

/// The line about the angle `name`, from the striker's original velocity `from` to a body's final
/// velocity `to`. Recoil angles count clockwise, all others anticlockwise.
fn angle_line(name: &str, angle: Option<f64>, from: DVec2, to: DVec2) -> String {
    let (body, sign) = match name {
        "θ₁" => ("striker", "v₁"),
        "θ₂" => ("target", "v₂"),
        _ => ("pair", "V"),
    };
    let speed = format!("{sign} = {} m/s", number(to.length()));
    match angle {
        Some(angle) => {
            let way = match degrees(angle.abs()).as_str() {
                "0°" => "straight on",
                "180°" => "straight back",
                _ if (angle > 0.0) == (body == "target") => "clockwise from u₁",
                _ => "anticlockwise from u₁",
            };
            format!("{name} = {}  ({way}), {speed}", degrees(angle))
        }
        None if to.length() <= 0.0 => format!("{name}: undefined, because the {body} is at rest"),
        None if from.length() <= 0.0 => {
            format!("{name}: undefined, because u₁ = 0 has no direction; {speed}")
        }
        None => format!("{name}: undefined"),
    }
}

fn check(c: &Collision, after: &CollisionOutcome) -> WorkedStep {
    let (m1, m2) = (g_from_kg(c.striker.mass), g_from_kg(c.target.mass));
    let scale = m1 * c.u1.length() + m2 * c.u2.length();
    let before_p = vector(m1 * c.u1 + m2 * c.u2, scale);
    let after_p = vector(m1 * after.v1 + m2 * after.v2, scale);
    let sticks = c.bond == Bond::Stick;
    let carried = if sticks {
        "(m₁ + m₂) V"
    } else {
        "m₁v₁ + m₂v₂"
    };
    let rotates = after.energy_rotation > 0.0;
    let mut kept = match (sticks, rotates) {
        (true, true) => "½ (m₁ + m₂) V² + ½ I ω²",
        (true, false) => "½ (m₁ + m₂) V²",
        (false, true) => "moving + rotating",
        (false, false) => "½ m₁v₁² + ½ m₂v₂²",
    }
    .to_owned();
    if rotates {
        let moving = number(after.energy_after - after.energy_rotation);
        kept += &format!(" = {moving} + {}", number(after.energy_rotation));
    }
    let (came, left) = (number(after.energy_before), number(after.energy_after));
    let spinning = c.rims.spins != [0.0; 2] && !sticks;
    let sum = if spinning {
        "moving + rotating"
    } else {
        "½ m₁u₁² + ½ m₂u₂²"
    };
    let mut lines = vec![
        format!("momentum before  m₁u₁ + m₂u₂ = {before_p} g m/s"),
        format!("momentum after   {carried} = {after_p} g m/s"),
        format!("energy before    {sum} = {came} J"),
        format!("energy after     {kept} = {left} J"),
    ];
    let share = after.energy_lost / after.energy_before;
    let lost = share > 1e-12;
    if lost {
        let (energy, percent) = (number(after.energy_lost), number(100.0 * share));
        lines.push(format!(
            "lost             {energy} J, {percent} % of the energy"
        ));
    }
    WorkedStep {
        title: "Check",
        why: if lost {
            "With no external force during the short contact, momentum is conserved. Kinetic \
             energy need not be: the energy lost has become heat and sound."
        } else {
            "With no external force during the short contact, momentum is conserved. At e = 1 \
             kinetic energy is conserved, too."
        }
        .to_owned(),
        lines,
    }
}

/// The speed in m/s against which rounding noise is judged.
fn speed_scale(c: &Collision) -> f64 {
    c.u1.length() + c.u2.length()
}

fn grams(mass: f64) -> String {
    number(g_from_kg(mass))
}

fn mm(length: f64) -> String {
    number(mm_from_m(length))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{Disc, Rims};
    use proptest::prelude::*;

    /// The value of a line of working with + − × /, and with brackets only around negative numbers
    /// and denominators.
    fn calculated(working: &str) -> f64 {
        let plain = working.replace('−', "-").replace(['(', ')'], " ");
        let words: Vec<&str> = plain.split_whitespace().collect();
        // Each term of the sum is a product. A product in the denominator means division by each of
        // its factors.
        let (mut sum, mut product, mut sign) = (0.0, f64::NAN, 1.0);
        let mut by = "";
        for word in words {
            match word {
                "+" | "-" => {
                    sum += sign * product;
                    (product, sign, by) = (f64::NAN, if word == "-" { -1.0 } else { 1.0 }, "");
                }
                "×" if by == "/" || by == "/ ×" => by = "/ ×",
                "×" | "/" => by = word,
                number => {
                    let number: f64 = number.parse().unwrap();
                    product = match by {
                        "" => number,
                        "×" => product * number,
                        _ => product / number,
                    };
                }
            }
        }
        sum + sign * product
    }

    #[test]
    fn the_printed_figures_of_rough_rims_give_the_printed_results() {
        let mut checked = 0;
        for (alpha, friction, spins) in [
            (30.0, 0.05, [0.0, 0.0]),
            (17.3, 0.2, [31.7, -12.9]),
            (-52.9, 0.333, [-310.0, 77.7]),
            (0.0, 0.1, [120.0, 0.0]),
            (71.0, 1.7, [0.0, 250.0]),
        ] {
            for (m1, m2, e) in [(15.0, 15.0, 1.0), (15.0, 5.5, 0.8), (7.3, 19.1, 0.37)] {
                let c = Collision {
                    u2: DVec2::new(-0.7, 0.31),
                    restitution: e,
                    rims: Rims { friction, spins },
                    ..Collision::at_offset(
                        Disc::from_g_mm(m1, 20.65),
                        Disc::from_g_mm(m2, 15.9),
                        DVec2::new(3.7, 0.0),
                        0.0,
                    )
                }
                .with_alpha_deg(alpha);
                let outcome = c.outcome();
                for step in rough::steps(&c, &outcome, outcome.tangent.unwrap()) {
                    for line in step.lines {
                        let mut parts = line.rsplitn(3, " = ");
                        let (Some(result), Some(working)) = (parts.next(), parts.next()) else {
                            continue;
                        };
                        let working = working.trim_start_matches("    = ");
                        if working.contains(|c: char| c.is_alphabetic()) {
                            continue;
                        }
                        let result = result.split_whitespace().next().unwrap();
                        assert_eq!(number(calculated(working)), result, "{line}");
                        checked += 1;
                    }
                }
            }
        }
        assert_eq!(
            checked,
            15 * 7,
            "seven lines of each collision are calculated again"
        );
    }

    fn whole_text(steps: &[WorkedStep]) -> String {
        let part = |s: &WorkedStep| format!("{}\n{}\n{}\n", s.title, s.why, s.lines.join("\n"));
        steps.iter().map(part).collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        /// The solution of any collision (light or heavy discs, moving or at rest, hit or miss) has
        /// no NaN or infinity.
        #[test]
        fn every_solution_can_be_read(
            masses in (-15.0..9.0_f64, -15.0..9.0_f64),
            radii in (-3.0..3.0_f64, -3.0..3.0_f64),
            velocities in prop::array::uniform4(prop_oneof![Just(0.0), -1e9..1e9_f64, -1e-200..1e-200_f64]),
            share in prop_oneof![Just(0.0), Just(1.0), -1.5..1.5_f64],
            restitution in prop_oneof![Just(0.0), Just(1.0), 0.0..1.0_f64],
            stick in any::<bool>(),
            by_offset in any::<bool>(),
            rims in (prop_oneof![Just(0.0), 0.0..10.0_f64], prop::array::uniform2(prop_oneof![Just(0.0), -1e9..1e9_f64])),
        ) {
            let disc = |mass: f64, radius: f64| Disc {
                mass: 10.0_f64.powf(mass),
                radius: 10.0_f64.powf(radius),
            };
            let [a, b, c, d] = velocities;
            let hit = Collision {
                u2: DVec2::new(c, d),
                restitution,
                bond: if stick { Bond::Stick } else { Bond::Slip },
                rims: Rims { friction: rims.0, spins: rims.1 },
                ..Collision::at_offset(disc(masses.0, radii.0), disc(masses.1, radii.1), DVec2::new(a, b), 0.0)
            };
            let offset = share * hit.contact_distance();
            let text = whole_text(&steps(&Collision { offset, ..hit }, by_offset));
            for never in ["NaN", "inf"] {
                prop_assert!(!text.contains(never), "{}", text);
            }
        }
    }
}

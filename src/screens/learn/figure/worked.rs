//! The worked solution, a step at a time.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::LiveFigure;
use crate::physics::Collision;
use crate::physics::worked::{self, WorkedStep};
use crate::screens::lab::LabField;
use crate::widgets::{Lines, Look, Role, Words};

/// What the student sets in a solution of their own.
pub(super) const FIELDS: [LabField; 5] = [
    LabField::StrikerMass,
    LabField::CoinMass,
    LabField::Speed,
    LabField::ImpactAngle,
    LabField::Restitution,
];

/// All steps of the solution.
pub(super) fn steps(collision: &Collision) -> Vec<WorkedStep> {
    worked::steps(collision, false)
}

/// Draws the step at hand: below the settings, one of which is chosen, if there are
/// any; with its results left `blank` from a step on, counted from 1.
pub(super) fn draw(
    shown: &LiveFigure,
    chosen: Option<usize>,
    blank: Option<usize>,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) {
    let mut lines = Lines::new(area, buf, *look);
    if let Some(chosen) = chosen {
        let setup = shown.setup();
        for (i, field) in FIELDS.into_iter().enumerate() {
            let (mark, role) = Role::Dim.of_choice(i == chosen);
            let (_, value) = Role::Text.of_choice(i == chosen);
            let field = field.field(&setup);
            let recorded = |_| Words::Field {
                name: field.name.to_string(),
                value: field.shown.clone(),
                locked: false,
            };
            lines.clicked_as(recorded, Some(i == chosen), |lines| {
                let name = format!("{mark} {}", field.name);
                lines.pair(&name, &field.shown, role, value);
            });
        }
        lines.gap();
    }
    let number = shown.step();
    let Some(step) = steps(shown.collision()).into_iter().nth(number) else {
        return;
    };
    lines.paragraph(&format!("{}. {}", number + 1, step.title), Role::Title);
    let is_blank = blank.is_some_and(|blank| number + 1 >= blank);
    if step.lines.is_empty() {
        // The result in words.
        lines.gap();
        let words = if is_blank { GAP } else { &step.why };
        return lines.paragraph(words, Role::Text);
    }
    if chosen.is_none() {
        lines.gap();
        lines.paragraph(&step.why, Role::Dim);
        lines.gap();
    }
    for line in &step.lines {
        let line = if is_blank {
            without_result(line)
        } else {
            line.clone()
        };
        lines.equation(&line, 4, Role::Text);
    }
}

/// What stands in place of a result.
const GAP: &str = "____";

/// A line of working without what it finds: a formula stays, and the numbers that are
/// put into it; from the first value on there is a gap.
fn without_result(line: &str) -> String {
    let equality = || line.match_indices('=').map(|(at, _)| at);
    let value = equality().find(|at| is_value(&line[at + 1..]));
    // θ₁: undefined, or a separation.
    let told = line
        .find(": ")
        .filter(|at| value.is_none_or(|value| *at < value));
    match (told, value) {
        (Some(at), _) | (None, Some(at)) => format!("{} {GAP}", &line[..=at]),
        (None, None) if line.contains('=') => line.into(),
        (None, None) => GAP.into(),
    }
}

/// Whether a text begins with a number or with the parts of a vector.
fn is_value(text: &str) -> bool {
    let text = text.trim_start().trim_start_matches(['(', '−']);
    text.starts_with(|first: char| first.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{Bond, CollisionSpec};

    #[test]
    fn a_blank_keeps_the_formula_and_what_is_put_into_it() {
        let blank = [
            (
                "n = (cos α, −sin α) = (0.7071, −0.7071)",
                "n = (cos α, −sin α) = ____",
            ),
            (
                "v₁ₙ = [(m₁ − e m₂) u₁ₙ] / (m₁ + m₂)",
                "v₁ₙ = [(m₁ − e m₂) u₁ₙ] / (m₁ + m₂)",
            ),
            (
                "    = [(20 − 40) × 2.121] / 60 = −0.7071 m/s",
                "    = [(20 − 40) × 2.121] / 60 = ____",
            ),
            (
                "θ₁ = 63.43°  (anticlockwise from u₁), v₁ = 2.236 m/s",
                "θ₁ = ____",
            ),
            (
                "θ₁: undefined, because u₁ = 0 has no direction; v₁ = 2 m/s",
                "θ₁: ____",
            ),
            (
                "separation, from v₁ to v₂: 108.4°",
                "separation, from v₁ to v₂: ____",
            ),
            (
                "energy after     ½ I ω² = 0.01 + 0.02 = 0.03 J",
                "energy after     ½ I ω² = ____",
            ),
            ("lost             0.09 J, 42 % of it", "____"),
        ];
        for (line, expected) in blank {
            assert_eq!(without_result(line), expected);
        }
    }

    /// However the pieces meet: what the blank steps find is nowhere to be read in them.
    #[test]
    fn a_blank_tells_nothing_of_the_end() {
        let setup = CollisionSpec {
            m1_g: 20.0,
            m2_g: 41.0,
            speed: 3.1,
            ..CollisionSpec::default()
        };
        for (bond, restitution) in [(Bond::Slip, 1.0), (Bond::Slip, 0.7), (Bond::Stick, 0.0)] {
            let collision = CollisionSpec {
                bond,
                restitution,
                ..setup
            }
            .collision();
            let outcome = collision.outcome();
            let angles = [outcome.theta1, outcome.theta2, outcome.separation];
            let mut found: Vec<_> = angles.into_iter().flatten().map(f64::to_degrees).collect();
            found.extend([outcome.energy_after, outcome.energy_lost, outcome.spin]);
            found.retain(|found| *found > 1e-9);
            let last = steps(&collision).into_iter().rev().take(4);
            let text: String = last
                .flat_map(|step| step.lines)
                .map(|line| without_result(&line) + "\n")
                .collect();
            for found in found {
                let digits = worked::number(found);
                assert!(!text.contains(&digits), "{digits} in\n{text}");
            }
        }
    }
}

//! The worked solution, a step at a time.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::Shown;
use crate::physics::Collision;
use crate::physics::worked::{self, Given, Step};
use crate::screens::lab::Field;
use crate::widgets::{Lines, Look, Role};

/// What the student sets in a solution of their own.
pub(super) const FIELDS: [Field; 5] = [
    Field::StrikerMass,
    Field::CoinMass,
    Field::Speed,
    Field::ImpactAngle,
    Field::Restitution,
];

/// All steps of the solution.
pub(super) fn steps(collision: &Collision) -> Vec<Step> {
    worked::steps(collision, Given::Angle)
}

/// Draws the step at hand: below the settings, one of which is chosen, if there are
/// any; with its results left `blank` from a step on, counted from 1.
pub(super) fn draw(
    shown: &Shown,
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
            let (mark, role) = if i == chosen {
                (">", Role::Selected)
            } else {
                (" ", Role::Dim)
            };
            let name = format!("{mark} {}", field.name(&setup));
            let value = if i == chosen {
                Role::Selected
            } else {
                Role::Text
            };
            lines.pair(&name, &field.shown(&setup), role, value);
        }
        lines.gap();
    }
    let number = shown.step();
    let Some(step) = steps(shown.collision()).into_iter().nth(number) else {
        return;
    };
    lines.paragraph(&format!("{}. {}", number + 1, step.title), Role::Title);
    if chosen.is_none() {
        lines.gap();
        lines.paragraph(&step.why, Role::Dim);
        lines.gap();
    }
    if step.lines.is_empty() && chosen.is_some() {
        lines.paragraph(&step.why, Role::Text);
    }
    let is_blank = blank.is_some_and(|blank| number + 1 >= blank);
    for line in &step.lines {
        let line = if is_blank {
            without_result(line)
        } else {
            line.clone()
        };
        lines.paragraph(&line, Role::Text);
    }
    if is_blank && step.lines.is_empty() {
        lines.paragraph("____", Role::Key);
    }
}

/// A line of working with a gap after its last sign of equality.
fn without_result(line: &str) -> String {
    match line.rsplit_once('=') {
        Some((before, _)) => format!("{before}= ____"),
        None => "____".into(),
    }
}

//! The worked solution, step by step.

use crate::messages::Key;
use crate::physics::worked::{self, WorkedStep};
use crate::physics::{Collision, CollisionSpec};
use crate::screens::learn::figure::FigureAction;
use crate::widgets::Role;
use crate::widgets::input::{
    CollisionField, Field, FormAction, FormFields, KeyTable, SettingsForm,
};
use crate::widgets::panel::Panel;

/// A worked solution, open at a step.
#[derive(Debug, Clone)]
pub(in crate::screens::learn) struct WorkedFigure {
    /// The current step, counted from 0.
    step: usize,
    /// The first step with blank results, counted from 1; `None` once the results are shown.
    blank: Option<usize>,
    /// The settings, if the student sets the numbers.
    form: Option<SettingsForm>,
}

/// The numbers that the student can set.
const FIELDS: [CollisionField; 5] = [
    CollisionField::StrikerMass,
    CollisionField::CoinMass,
    CollisionField::Speed,
    CollisionField::ImpactAngle,
    CollisionField::Restitution,
];

/// The numbers that the student has set.
struct OwnNumbers(CollisionSpec);

impl FormFields for OwnNumbers {
    fn fields(&self) -> Vec<Field> {
        FIELDS.map(|field| field.field(&self.0)).into()
    }

    fn set(&mut self, at: usize, value: f64) {
        if let Some(field) = FIELDS.get(at) {
            field.set(&mut self.0, value);
        }
    }
}

fn numbers(collision: &Collision) -> OwnNumbers {
    OwnNumbers(CollisionSpec::from(collision))
}

/// All steps of the solution.
fn steps(collision: &Collision) -> Vec<WorkedStep> {
    worked::steps(collision, false)
}

fn last(collision: &Collision) -> usize {
    steps(collision).len().saturating_sub(1)
}

impl WorkedFigure {
    /// A solution to read. If a step `blank`, counted from 1, is given, the solution opens at that
    /// step and, while `hidden`, leaves the results out from that step on.
    pub(super) fn given(blank: Option<usize>, hidden: bool) -> Self {
        Self {
            step: blank.map_or(0, |step| step - 1),
            blank: blank.filter(|_| hidden),
            form: None,
        }
    }

    /// A solution with numbers that the student sets.
    pub(super) fn of_own() -> Self {
        Self {
            step: 0,
            blank: None,
            form: Some(SettingsForm::default()),
        }
    }

    /// Shows the blank results.
    pub(super) fn reveal(&mut self) {
        self.blank = None;
    }

    fn step(&self, collision: &Collision) -> usize {
        self.step.min(last(collision))
    }

    pub(super) fn title(&self, collision: &Collision) -> String {
        let (step, last) = (self.step(collision), last(collision));
        format!("worked out: step {} of {}", step + 1, last + 1)
    }

    /// The keys that control the solution.
    pub(super) fn keys(&self, collision: &Collision) -> KeyTable<FigureAction> {
        let steps =
            |keys: [Key; 2]| KeyTable::new("figure").by(keys, FigureAction::Step, [-1, 1], "step");
        let Some(form) = &self.form else {
            return steps([Key::Left, Key::Right]);
        };
        // Tab and the page keys are left to the page.
        let page = [Key::Tab, Key::BackTab, Key::PageUp, Key::PageDown];
        let set = form.keys(&numbers(collision)).without_keys(&page);
        // On a small screen the keys for the solution's steps have priority over those for typing
        // a number.
        let set = set.renamed("set", |action| matches!(action, FormAction::Step(_)));
        let set = set.renamed("", |action| matches!(action, FormAction::Number(_)));
        let set = set.map(FigureAction::Set);
        let steps_by = [',', '.'].map(Key::Char);
        // While a number is being typed, a point or a comma belongs to the number.
        let set = match form.is_typing() {
            true => set,
            false => set.without_keys(&steps_by),
        };
        set.with(steps(steps_by), |step| step).distinct()
    }

    /// Whether a number is being typed.
    pub(super) fn is_typing(&self) -> bool {
        self.form.as_ref().is_some_and(SettingsForm::is_typing)
    }

    pub(super) fn act(&mut self, action: FigureAction, collision: &mut Collision) {
        match (action, &mut self.form) {
            (FigureAction::Step(by), _) => {
                let step = self.step(collision).saturating_add_signed(by);
                self.step = step.min(last(collision));
            }
            (FigureAction::Set(action), Some(form)) => {
                let mut numbers = numbers(collision);
                form.act(action, &mut numbers);
                *collision = numbers.0.collision();
            }
            _ => {}
        }
    }

    /// Writes the current step, below the settings, if there are any.
    pub(in crate::screens::learn) fn write(
        &self,
        collision: &Collision,
        panel: &mut Panel<FigureAction>,
    ) {
        if let Some(form) = &self.form {
            let numbers = numbers(collision);
            panel.part(FigureAction::Set, |panel| form.write(&numbers, panel));
            panel.gap();
        }
        let number = self.step(collision);
        let Some(step) = steps(collision).into_iter().nth(number) else {
            return;
        };
        panel.paragraph(format!("{}. {}", number + 1, step.title), Role::Title);
        let is_blank = self.blank.is_some_and(|blank| number + 1 >= blank);
        if step.lines.is_empty() {
            // The result in words.
            panel.gap();
            let words = if is_blank { GAP.into() } else { step.why };
            return panel.paragraph(words, Role::Text);
        }
        if self.form.is_none() {
            panel.gap();
            panel.paragraph(step.why, Role::Dim);
            panel.gap();
        }
        for line in step.lines {
            panel.working(match is_blank {
                true => without_result(&line),
                false => line,
            });
        }
    }
}

/// The placeholder of a result.
const GAP: &str = "____";

/// A line of working without its results: the formula and the substituted numbers remain, but the
/// first value and all that follows it are replaced by a gap.
fn without_result(line: &str) -> String {
    let equality = || line.match_indices('=').map(|(at, _)| at);
    let value = equality().find(|at| is_value(&line[at + 1..]));
    // In a line such as `θ₁: undefined`, the result follows a colon.
    let revealed = line.find(": ").filter(|at| value.is_none_or(|it| *at < it));
    match (revealed, value) {
        (Some(at), _) | (None, Some(at)) => format!("{} {GAP}", &line[..=at]),
        (None, None) if line.contains('=') => line.into(),
        (None, None) => GAP.into(),
    }
}

/// Whether a string begins with a number or with the components of a vector.
fn is_value(text: &str) -> bool {
    let text = text.trim_start().trim_start_matches(['(', '−']);
    text.starts_with(|first: char| first.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{Bond, CollisionSpec};

    #[test]
    fn a_blank_keeps_the_formula_and_the_substituted_numbers() {
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
                "angle between the paths, from v₁ to v₂: 108.4°",
                "angle between the paths, from v₁ to v₂: ____",
            ),
            (
                "energy after     ½ I ω² = 0.01 + 0.02 = 0.03 J",
                "energy after     ½ I ω² = ____",
            ),
            ("lost             0.09 J, 42 % of the energy", "____"),
        ];
        for (line, expected) in blank {
            assert_eq!(without_result(line), expected);
        }
    }

    /// Whatever the kind of collision, blank steps do not show the values that the student has to
    /// find.
    #[test]
    fn a_blank_step_does_not_show_its_result() {
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

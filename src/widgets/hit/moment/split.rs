//! The steps that resolve velocities along n and t.

use glam::DVec2;

use super::Moment;
use crate::widgets::Role;
use crate::widgets::hit::explanation_step::ExplanationStep;
use crate::widgets::hit::names::part_name;
use crate::widgets::hit::sketch::{ArrowScale, NamedVelocity, Root, Sketch};

impl Moment<'_> {
    /// Draws the velocities of a step, with their components along n and t.
    pub(super) fn parts(&self, sketch: &mut Sketch, step: ExplanationStep, axes: [DVec2; 2]) {
        let (before, after) = (self.before(), self.after());
        let all: Vec<_> = (0..2)
            .flat_map(|body| {
                let roots = [self.root_before(body), self.root_after(body)];
                roots.into_iter().zip([before[body], after[body]])
            })
            .flat_map(|(root, v)| {
                let parts = axes.map(|axis| (root, v.dot(axis) * axis));
                parts.into_iter().chain([(root, v)])
            })
            .collect();
        // All steps have the same scale, so the arrows keep their lengths.
        let along = match self.target_rests() {
            true => before[0].dot(axes[0]) * axes[0],
            false => DVec2::ZERO,
        };
        let scale = ArrowScale::fit_rooted(&self.stage, along, &all);
        match step {
            ExplanationStep::Coin => {
                if self.target_rests() {
                    let [along, _] = self.parts_before(0, before[0], axes);
                    sketch.velocity(&scale, self.root_before(0), &along);
                }
                self.split_after(sketch, &scale, 1, axes);
            }
            ExplanationStep::Striker => {
                self.split_after(sketch, &scale, 0, axes);
                sketch.velocity(&scale, self.root_after(1), &self.velocity_after(1));
            }
            _ => {
                for body in 0..2 {
                    self.split_before(sketch, &scale, (body, self.root_before(body)), axes);
                }
            }
        }
    }

    /// Determines where the initial velocity of a disc is drawn. If the target is at rest, the
    /// arrow begins at the centre, so that its component along n points to where the target's
    /// component begins. If both discs move, the arrow ends at the centre, so that each disc has
    /// its arrows on its own side; but if the other disc is right behind, the arrow begins at the
    /// centre.
    fn root_before(&self, body: usize) -> Root {
        let centre = self.stage.centres[body];
        if self.target_rests() || self.stage.runs_ahead(body, self.before()[body]) {
            Root::From(centre)
        } else {
            Root::UpTo(centre)
        }
    }

    fn root_after(&self, body: usize) -> Root {
        Root::From(self.stage.centres[body])
    }

    /// Draws an initial velocity with its components, unless the disc is at rest.
    pub(super) fn split_before(
        &self,
        sketch: &mut Sketch,
        scale: &ArrowScale,
        (body, root): (usize, Root),
        axes: [DVec2; 2],
    ) {
        let v = self.before()[body];
        if scale.is_still(v) {
            return;
        }
        let name = self.names().before[body].to_owned();
        let role = Role::Incoming;
        let parts = self.parts_before(body, v, axes);
        sketch.split(scale, (body, root), NamedVelocity { name, v, role }, &parts);
    }

    /// Draws a final velocity with its components; without friction the component along t is
    /// unchanged, so it keeps its name.
    fn split_after(&self, sketch: &mut Sketch, scale: &ArrowScale, body: usize, axes: [DVec2; 2]) {
        let whole = self.velocity_after(body);
        let [mut along, mut across] = self.parts_before(body, whole.v, axes);
        if self.watch.outcome.friction_impulse != 0.0 {
            across.name = part_name(&whole.name, 'ₜ');
        }
        along.name = match scale.is_still(across.v) {
            true => whole.name.clone(),
            false => part_name(&whole.name, 'ₙ'),
        };
        let root = self.root_after(body);
        sketch.split(scale, (body, root), whole, &[along, across]);
    }

    /// The arrow and name of a velocity after the collision.
    fn velocity_after(&self, body: usize) -> NamedVelocity {
        NamedVelocity {
            name: self.names().after[body].to_owned(),
            v: self.after()[body],
            role: [Role::StrikerOut, Role::CoinOut][body],
        }
    }

    /// The components of a velocity along n and t, named as initial components.
    fn parts_before(&self, body: usize, v: DVec2, axes: [DVec2; 2]) -> [NamedVelocity; 2] {
        let name = self.names().before[body];
        let part = |axis: DVec2, sign, role| NamedVelocity {
            name: part_name(name, sign),
            v: v.dot(axis) * axis,
            role,
        };
        [
            part(axes[0], 'ₙ', Role::NormalPart),
            part(axes[1], 'ₜ', Role::TangentPart),
        ]
    }
}

//! The picture of a collision at one moment.

mod axes;
mod discs;
mod rims;
mod split;
mod velocities;

use glam::DVec2;

use super::explanation_step::ExplanationStep;
use super::names::VelocityNames;
use super::sketch::{ArrowScale, Root, Sketch};
use super::{HitLayout, Overlay, Watch};
use crate::physics::Frame;
use crate::widgets::Role;
use crate::widgets::picture::{self, Pen, Picture};

/// The mark at the point where the rims touch.
const CONTACT: &str = "●";

/// The data needed to draw one moment of a collision.
pub(super) struct Moment<'a> {
    pub(super) watch: &'a Watch,
    pub(super) stage: HitLayout,
}

impl Moment<'_> {
    /// The velocity of the reference frame.
    fn drift(&self) -> DVec2 {
        self.watch.frame.velocity(&self.stage.collision)
    }

    /// The position of a disc at a given time of the shot, in the chosen frame.
    fn place(&self, body: usize, time: f64) -> DVec2 {
        let position = match &self.watch.shot {
            Some(shot) => shot.at(body, time).position,
            // Two discs with equal velocities never touch; each follows its own path.
            None => {
                let left = self.watch.clock.contact - time;
                let (p1, p2) = self.stage.collision.positions_before(left);
                [p1, p2][body]
            }
        };
        position - self.drift() * (time - self.watch.clock.contact)
    }

    /// The current positions of the discs, in the chosen frame.
    fn now(&self) -> [DVec2; 2] {
        [0, 1].map(|body| self.place(body, self.watch.clock.time()))
    }

    /// Whether lines and arrows are drawn on top of the discs at the contact.
    fn is_explaining(&self) -> bool {
        self.watch.clock.at_contact() && self.watch.step() > Some(ExplanationStep::Contact)
    }

    /// Whether the discs move on as one body.
    fn sticks(&self) -> bool {
        self.stage.collision.coalesces()
    }

    /// The velocities before the contact, in the chosen frame.
    fn before(&self) -> [DVec2; 2] {
        let collision = &self.stage.collision;
        [collision.u1, collision.u2].map(|u| u - self.drift())
    }

    /// Whether the target is at rest before the collision, in the chosen frame.
    fn target_rests(&self) -> bool {
        self.before()[1] == DVec2::ZERO
    }

    /// The velocities after the contact, for the arrows at the current time. If the pair moves on
    /// together, both are the velocity of the centre of mass, except in the centre-of-mass frame:
    /// there they are the velocities of the discs as the pair rotates.
    fn after(&self) -> [DVec2; 2] {
        let shared = [self.watch.outcome.v1, self.watch.outcome.v2];
        if self.sticks() && self.watch.frame == Frame::CentreOfMass {
            let since = (self.watch.clock.time() - self.watch.clock.contact).max(0.0);
            let turned = DVec2::from_angle(-self.watch.outcome.spin * since);
            let centres = self.stage.collision.centres_after();
            return [0, 1].map(|body| turned.rotate(centres[body] - shared[body]));
        }
        shared.map(|v| v - self.drift())
    }

    /// The pen for the geometry of the contact: it draws on top of the discs at the contact, and
    /// behind them at other times.
    fn pen(&self, role: Role) -> Pen {
        if self.watch.clock.at_contact() {
            Pen::new(role)
        } else {
            Pen::new(role).on(picture::DrawLayer::Trail)
        }
    }

    fn shows(&self, layer: Overlay) -> bool {
        self.watch.layers.shows(layer)
    }

    /// Whether the only velocities in the completed picture are the initial ones, with their
    /// components.
    fn is_split_alone(&self) -> bool {
        self.shows(Overlay::Split) && !self.shows(Overlay::Velocities)
    }

    /// The step whose velocities are drawn together with their components.
    fn split_step(&self) -> Option<ExplanationStep> {
        let step = self.watch.step()?;
        match step {
            ExplanationStep::Split | ExplanationStep::Coin | ExplanationStep::Striker => Some(step),
            ExplanationStep::Whole if self.is_split_alone() => Some(ExplanationStep::Split),
            _ => None,
        }
    }

    /// The whole picture: paths, discs and layers.
    pub(super) fn picture(&self) -> Picture {
        let mut sketch = Sketch::new(self.stage);
        let time = self.watch.clock.time();
        let met = self.watch.clock.has_met();
        let now = self.now();
        if self.shows(Overlay::Trails) {
            self.trails(&mut sketch.picture, time);
        }
        for (body, at) in now.into_iter().enumerate() {
            self.disc(&mut sketch.picture, body, at);
            self.mark(&mut sketch.picture, body, at, time);
        }
        let (step, split) = (self.watch.step(), self.split_step());
        let revealed = step == Some(ExplanationStep::Whole);
        // In the centre-of-mass frame the momenta cancel, so there is no triangle.
        let flat = self.watch.frame == Frame::CentreOfMass || !self.watch.outcome.hit();
        if revealed && self.shows(Overlay::Triangle) && !flat {
            self.triangle(&mut sketch);
        }
        let outcome = &self.watch.outcome;
        let axes = outcome.normal.zip(outcome.tangent).map(|(n, t)| [n, t]);
        if let Some(axes @ [n, t]) = axes {
            if step >= Some(ExplanationStep::Line) && (!revealed || self.shows(Overlay::Lines)) {
                self.axes(&mut sketch, split.is_some(), n, t);
            }
            if let Some(step) = split {
                self.parts(&mut sketch, step, axes);
            }
        }
        if let Some(wanted) = &self.watch.wanted
            && self.shows(Overlay::Prediction)
            && self.watch.frame == Frame::Laboratory
        {
            sketch.wanted_way(wanted);
        }
        if step == Some(ExplanationStep::Friction) {
            self.friction(&mut sketch);
        }
        let scale = ArrowScale::fit(&self.stage, self.before(), self.after());
        if split.is_none() && self.shows(Overlay::Velocities) {
            let at = if met { self.stage.centres } else { now };
            self.incoming(&mut sketch, &scale, at);
        }
        if revealed {
            if let Some(axes) = axes.filter(|_| split.is_none() && self.shows(Overlay::Split)) {
                let centre = Root::From(self.stage.centres[0]);
                self.split_before(&mut sketch, &scale, (0, centre), axes);
            }
            self.departures(&mut sketch, &scale);
        }
        if step.is_some_and(|step| split.is_none() && step != ExplanationStep::Line) {
            self.spins(&mut sketch, now);
        }
        if met && self.watch.outcome.hit() {
            sketch.picture.reserve(DVec2::ZERO);
            if split.is_none() && !revealed {
                sketch.picture.text(DVec2::ZERO, CONTACT, Role::Contact);
            }
        }
        if self.watch.measured {
            self.measures(&mut sketch);
        }
        sketch.picture
    }

    fn names(&self) -> VelocityNames {
        VelocityNames::new(&self.stage.collision, self.watch.frame)
    }
}

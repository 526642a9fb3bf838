//! Spins and friction at the rims: a mark on each disc, arrows for the spins, and the impulses
//! along the tangent.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec2;

use super::Moment;
use crate::numbers::{significant, true_minus};
use crate::physics::units::g_from_kg;
use crate::widgets::Role;
use crate::widgets::hit::explanation_step::ExplanationStep;
use crate::widgets::hit::sketch::Sketch;
use crate::widgets::picture::{Pen, Picture};

/// The inner end of the mark on a disc, as a fraction of the radius; the outer end is at the rim.
const MARK: f64 = 0.6;
/// The radius of the curved arrow that shows a spin, in radii of the disc.
const TURN: f64 = 0.8;
/// The angle spanned by the arrow of the faster spin, in radians.
const LONGEST_TURN: f64 = 0.6 * PI;
/// The length of the arrows of friction's impulse, in radii of the larger disc. They show only its
/// direction, because Jₜ is small compared with Jₙ.
const IMPULSE: f64 = 1.2;

impl Moment<'_> {
    /// Whether the discs have marks, which they do if they spin or can be set spinning.
    fn has_marks(&self) -> bool {
        !self.stage.collision.rims.is_plain()
    }

    /// The spins before the contact, or after it once friction has been explained.
    fn spins_now(&self) -> [f64; 2] {
        match self.watch.step() >= Some(ExplanationStep::Friction) {
            true => self.watch.outcome.spins,
            false => self.stage.collision.rims.spins,
        }
    }

    /// The direction of a disc's mark; at the contact, both marks point up.
    fn mark_angle(&self, body: usize, time: f64) -> f64 {
        let since = time - self.watch.clock.contact;
        let spins = match since > 0.0 {
            true => self.watch.outcome.spins,
            false => self.stage.collision.rims.spins,
        };
        FRAC_PI_2 + spins[body] * since
    }

    /// Draws the mark on a disc, which turns with the disc.
    pub(super) fn mark(&self, picture: &mut Picture, body: usize, at: DVec2, time: f64) {
        if !self.has_marks() {
            return;
        }
        let direction = DVec2::from_angle(self.mark_angle(body, time));
        let radius = self.stage.radius(body);
        let [inner, outer] = [MARK * radius, radius].map(|away| at + away * direction);
        picture.line(inner, outer, Pen::new(Role::Contact).bold());
    }

    /// Draws the spins of both discs.
    pub(super) fn spins(&self, sketch: &mut Sketch, now: [DVec2; 2]) {
        if self.has_marks() {
            let spins = self.spins_now();
            (0..2).for_each(|body| sketch.spin(body, spins, now[body], true));
        }
    }

    /// Draws friction's impulse on each disc: an arrow along the tangent at the point of contact.
    pub(super) fn friction(&self, sketch: &mut Sketch) {
        let outcome = &self.watch.outcome;
        let Some((n, t)) = outcome.normal.zip(outcome.tangent) else {
            return;
        };
        if outcome.friction_impulse == 0.0 {
            return;
        }
        let value = significant(g_from_kg(outcome.friction_impulse.abs()));
        let on_target = outcome.friction_impulse.signum() * t;
        let unit = self.stage.unit();
        let discs = [
            (-on_target, -n, Role::StrikerOut, "on the striker"),
            (on_target, n, Role::CoinOut, "on the coin"),
        ];
        for (way, side, role, whose) in discs {
            let from = 0.15 * unit * side;
            let tip = from + IMPULSE * unit * way;
            sketch.picture.arrow(from, tip, Pen::new(role).bold());
            sketch
                .label(format!("Jₜ {whose} = {value} g m/s"), tip, way, role)
                .short("Jₜ");
        }
    }
}

impl Sketch {
    /// Draws the spin of a disc as an arrow around its centre, and the value of the spin beside the
    /// disc. The length of the arrow is relative to the faster of the two `spins`.
    pub(in crate::widgets::hit) fn spin(
        &mut self,
        body: usize,
        spins: [f64; 2],
        at: DVec2,
        figures: bool,
    ) {
        let (spin, radius) = (spins[body], self.stage.radius(body));
        let name = ["ω₁", "ω₂"][body];
        let outwards = self.stage.centres[body].try_normalize().unwrap_or(DVec2::X);
        let anchor = at + radius * outwards;
        let label = self.label(name, anchor, outwards, Role::Arc);
        if figures {
            let short = format!("{name} = {}", true_minus(&significant(spin)));
            label.text = format!("{short} rad/s");
            label.short(short);
        }
        if spin == 0.0 {
            return;
        }
        // The arrow is on the side opposite to the contact, away from the velocities.
        let middle = outwards.to_angle();
        let turn = LONGEST_TURN * spin / spins[0].abs().max(spins[1].abs());
        let (start, end) = (middle - turn / 2.0, middle + turn / 2.0);
        let pen = Pen::new(Role::Arc);
        self.picture.arc(at, TURN * radius, start, end, pen);
        let point = |angle: f64| at + TURN * radius * DVec2::from_angle(angle);
        let start = point(end - 0.35 * spin.signum());
        self.picture.arrow(start, point(end), pen);
    }
}

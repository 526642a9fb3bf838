//! The steps of the explanation at the contact, and their texts.

use glam::DVec2;

use super::{Face, Watch};
use crate::numbers::{Intermediate, significant, true_minus};
use crate::physics::impact::reduced_mass;
use crate::physics::units::g_from_kg;
use crate::physics::{Bond, Collision, CollisionOutcome, Frame, Meeting};
use crate::widgets::Role;

/// The time for looking at the picture, in seconds.
const LOOK: f64 = 3.0;
/// The time for reading one word, in seconds, at 150 words per minute.
const WORD: f64 = 0.4;
/// The shortest duration of a step, in seconds.
const SHORTEST: f64 = 5.0;
/// Components that differ by less than this, in m/s, are printed as equal.
const ALIKE: f64 = 0.005;

/// One step of the explanation. Each step adds something to the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum ExplanationStep {
    /// The rims touch.
    Contact,
    /// The line of impact and the tangent.
    Line,
    /// The initial velocities, resolved along n and t.
    Split,
    /// Friction between the rims: the slip velocity, and the impulse along t.
    Friction,
    /// The target's final velocity.
    Coin,
    /// The striker's final velocity.
    Striker,
    /// Both final velocities with their angles, and the triangle of momenta.
    Whole,
}

impl ExplanationStep {
    /// The steps that explain a collision, in order.
    pub(super) fn of(collision: &Collision, outcome: &CollisionOutcome) -> &'static [Self] {
        use ExplanationStep::{Coin, Contact, Friction, Line, Split, Striker, Whole};
        match (outcome.meeting, collision.bond) {
            (Meeting::Miss, _) => &[Whole],
            (Meeting::Graze, _) => &[Contact, Line, Whole],
            (Meeting::Hit, Bond::Stick) => &[Contact, Line, Split, Whole],
            (Meeting::Hit, Bond::Slip) if collision.rims.friction > 0.0 => {
                &[Contact, Line, Split, Friction, Coin, Striker, Whole]
            }
            (Meeting::Hit, Bond::Slip) => &[Contact, Line, Split, Coin, Striker, Whole],
        }
    }
}

/// The text of each step.
impl Watch {
    /// How many seconds a step lasts if no key is pressed: enough to look at the picture and read
    /// the text.
    pub(super) fn hold(&self, step: ExplanationStep) -> f64 {
        let words = self.step_words(step).split_whitespace().count() as f64;
        (LOOK + WORD * words).max(SHORTEST)
    }

    /// The heading of a step: its number, the total number of steps, and its name.
    pub(super) fn step_heading(&self, step: ExplanationStep) -> String {
        let steps = ExplanationStep::of(&self.collision, &self.outcome);
        let [striking, struck] = names(self.faces);
        let number = steps.iter().position(|it| *it == step).map_or(1, |i| i + 1);
        let name = match step {
            ExplanationStep::Contact => "contact",
            ExplanationStep::Line => "line of impact",
            ExplanationStep::Split => "the components",
            ExplanationStep::Friction => "friction at the rims",
            ExplanationStep::Coin => &format!("what the {struck} gets"),
            ExplanationStep::Striker => &format!("what the {striking} keeps"),
            ExplanationStep::Whole => "the result",
        };
        format!("{number} of {}: {name}", steps.len())
    }

    /// The text of a step. The last step has no text here, because every screen explains that step
    /// differently.
    pub(super) fn step_words(&self, step: ExplanationStep) -> String {
        let sticks = self.collision.coalesces();
        let words = match step {
            ExplanationStep::Contact if self.outcome.meeting == Meeting::Graze => {
                "A graze: the rims only just touch, and no force acts."
            }
            ExplanationStep::Contact => {
                "The rims touch at one point. At this instant each disc exerts a force on the \
                 other: equal in size, opposite in direction."
            }
            ExplanationStep::Line if sticks => {
                "The line of impact n joins the two centres; the tangent t is at right angles to \
                 it. Smooth rims exert a force along n only. These rims are joined, so a force \
                 acts along t as well."
            }
            ExplanationStep::Line if self.is_rough() => {
                "The line of impact n joins the two centres: along n the discs push each other \
                 apart. The tangent t is at right angles to it: the rims slide past each other \
                 along t, and friction acts."
            }
            ExplanationStep::Line => {
                "The line of impact n joins the two centres: the force acts only along n. The \
                 tangent t is at right angles to it."
            }
            ExplanationStep::Split if self.is_rough() => {
                let slip = speed(self.collision.slip().unwrap_or_default());
                return format!(
                    "So resolve the velocities. The components along n change as for smooth discs. \
                     Along t the two rims slide past each other at uₛ = {slip}, spins included."
                );
            }
            ExplanationStep::Split => return self.split(sticks),
            ExplanationStep::Friction => return self.friction(),
            ExplanationStep::Coin => return self.coin(),
            ExplanationStep::Striker => return self.striker(),
            ExplanationStep::Whole => "",
        };
        words.to_owned()
    }

    /// Whether the target is at rest before the collision and velocities have their
    /// laboratory-frame names.
    fn is_plain(&self) -> bool {
        self.frame == Frame::Laboratory && self.collision.u2 == DVec2::ZERO
    }

    fn is_rough(&self) -> bool {
        self.collision.rims.friction > 0.0
    }

    /// Explains friction's impulse: how large it can be, and how large it must be to stop the slip.
    fn friction(&self) -> String {
        let (collision, outcome) = (&self.collision, &self.outcome);
        let slip = collision.slip().unwrap_or_default().abs();
        if is_none(slip) {
            return "The rims do not slip past each other, so there is no friction, Jₜ = 0, and the \
                    spins do not change."
                .into();
        }
        let discs = collision.discs();
        let mu = reduced_mass(discs[0].mass, discs[1].mass);
        let limit = collision.rims.friction * outcome.impulse;
        let stops = mu * slip / 3.0;
        let [limit_text, stops_text] = [limit, stops].map(|it| significant(g_from_kg(it)));
        let end = match collision.rub_stops() {
            true => format!("So the slip stops: Jₜ = {stops_text} g m/s."),
            false => format!("So Jₜ = {limit_text} g m/s, and the rims slip throughout."),
        };
        let [one, other] = outcome.spins.map(|spin| significant(spin.abs()));
        let spins = match one == other {
            true => format!("The discs now spin at {one} rad/s."),
            false => format!("The discs now spin at {one} and {other} rad/s."),
        };
        format!(
            "Friction opposes the slip. Its impulse is at most μᵣJₙ = {limit_text} g m/s; {stops_text} \
             g m/s would stop the slip. {end} {spins}"
        )
    }

    /// The components of a velocity along n and t, in m/s.
    fn parts(&self, v: DVec2) -> [f64; 2] {
        let seen = v - self.frame.velocity(&self.collision);
        let axes = [self.outcome.normal, self.outcome.tangent];
        axes.map(|axis| axis.map_or(0.0, |axis| seen.dot(axis)))
    }

    fn split(&self, sticks: bool) -> String {
        let [u1n, u1t] = self.parts(self.collision.u1);
        match (sticks, self.is_plain()) {
            (true, true) => "So resolve u into u₁ₙ along n and u₁ₜ along t. Here forces act along \
                             both, so the collision changes both components."
                .into(),
            (true, false) => "So resolve the velocities along n and along t. Here forces act \
                              along both, so the collision changes both components."
                .into(),
            (false, true) if is_none(u1t) => "So resolve u: it is all along n. There is no \
                                              component along t, so the collision acts on all of u."
                .into(),
            (false, true) => format!(
                "So resolve u: the collision changes u₁ₙ = {} along n, but not u₁ₜ = {} along t.",
                speed(u1n),
                speed(u1t)
            ),
            (false, false) => "So resolve both velocities. The collision changes only the \
                               components along n, not those along t."
                .into(),
        }
    }

    fn coin(&self) -> String {
        let [_, name] = names(self.faces);
        let [[u1n, _], [v2n, _]] = [self.collision.u1, self.outcome.v2].map(|v| self.parts(v));
        if !self.is_plain() || self.is_rough() {
            return self.changed(1, &format!("What the {name} gets"));
        }
        let share = match is_none(v2n - u1n) {
            true => "It gets all of u₁ₙ".to_owned(),
            false => format!(
                "It gets (1 + e) m₁ / (m₁ + m₂) = {} of u₁ₙ",
                self.fraction(v2n)
            ),
        };
        format!(
            "The {name} was pushed along n, so it leaves along n. {share}: v₂ = {}.",
            speed(v2n)
        )
    }

    fn striker(&self) -> String {
        let [name, _] = names(self.faces);
        let [v1n, v1t] = self.parts(self.outcome.v1);
        if !self.is_plain() || self.is_rough() {
            return self.changed(0, &format!("What the {name} keeps"));
        }
        let whole = speed(v1n.hypot(v1t));
        match (is_none(v1n), is_none(v1t)) {
            (true, true) => {
                format!(
                    "The {name} has no component u₁ₜ, and nothing is left of u₁ₙ: the {name} stops."
                )
            }
            (true, false) => {
                format!("The {name} keeps u₁ₜ. Nothing is left of u₁ₙ, so v₁ = u₁ₜ = {whole}.")
            }
            (false, across) => {
                let (keeps, end) = match across {
                    true => ("has no component u₁ₜ", String::new()),
                    false => ("keeps u₁ₜ", format!(" Together: v₁ = {whole}.")),
                };
                let goes = match v1n > 0.0 {
                    true => "moves on",
                    false => "rebounds",
                };
                let along = format!(
                    "Along n it has (m₁ − e m₂) / (m₁ + m₂) = {} of u₁ₙ: it {goes} at {}",
                    self.fraction(v1n),
                    speed(v1n)
                );
                format!("The {name} {keeps}. {along}.{end}")
            }
        }
    }

    /// A final component along n as a fraction of the striker's initial component along n, with as
    /// many digits as the printed speeds require.
    fn fraction(&self, after: f64) -> String {
        let [before, _] = self.parts(self.collision.u1);
        let read = (100.0 * before).round() / 100.0;
        let fraction = Intermediate::new(after / before, |fraction| speed(fraction * read));
        true_minus(&fraction.to_string())
    }

    /// The text on how the components of a disc's velocity change, for all cases except one: the
    /// laboratory frame with the target at rest and smooth rims.
    fn changed(&self, body: usize, title: &str) -> String {
        let [un, ut] = self.parts([self.collision.u1, self.collision.u2][body]);
        let [vn, vt] = self.parts([self.outcome.v1, self.outcome.v2][body]);
        let keeps = match is_none(vt) {
            _ if !is_none(vt - ut) => format!(
                "Friction changes the component along t from {} to {}.",
                sideways(ut),
                sideways(vt)
            ),
            true => "The component along t is zero, before and after.".to_owned(),
            false => format!("The component along t stays at {}.", speed(vt)),
        };
        format!(
            "{title}. {keeps} The component along n was {} and is now {}.",
            signed(un),
            signed(vn)
        )
    }
}

/// Whether a component would be printed as zero.
fn is_none(v: f64) -> bool {
    v.abs() < ALIKE
}

fn speed(v: f64) -> String {
    format!("{:.2} m/s", v.abs())
}

/// Formats a component along t.
fn sideways(v: f64) -> String {
    match is_none(v) {
        true => "zero".into(),
        false => true_minus(&format!("{v:.2} m/s")),
    }
}

/// Formats a component along n, with its direction in words.
fn signed(v: f64) -> String {
    match (is_none(v), v > 0.0) {
        (true, _) => "zero".into(),
        (_, true) => format!("{} forwards", speed(v)),
        (_, false) => format!("{} backwards", speed(v)),
    }
}

/// The names of the two discs.
fn names(faces: [Face; 2]) -> [&'static str; 2] {
    let name = |face: Face| match face.role {
        Role::Striker => "striker",
        Role::Queen => "queen",
        Role::Marble => "marble",
        _ => "coin",
    };
    match faces.map(name) {
        ["striker", other] => ["striker", other],
        [one, other] if one == other => ["striking disc", "struck disc"],
        both => both,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::{Disc, Rims};
    use crate::widgets::hit::HitPace;

    fn words(collision: &Collision, frame: Frame, step: ExplanationStep) -> String {
        let watch = Watch::new(*collision, None, HitPace::Still).seen_from(frame);
        watch.step_words(step)
    }

    fn hit(m1: f64, m2: f64, alpha_deg: f64) -> Collision {
        let [striker, coin] = [m1, m2].map(|mass| Disc::from_g_mm(mass, 15.0));
        Collision::at_angle(striker, coin, 4.0 * DVec2::X, alpha_deg.to_radians())
    }

    /// With 4 m/s at 30°, u₁ₙ = 3.46 and u₁ₜ = 2; the final components along n are u₁ₙ times 2
    /// m₁/(m₁ + m₂) and (m₁ − m₂)/(m₁ + m₂).
    #[test]
    fn the_numbers_agree_with_the_closed_forms() {
        let lab = |m2, step| words(&hit(15.0, m2, 30.0), Frame::Laboratory, step);
        assert!(lab(15.0, ExplanationStep::Split).contains("u₁ₙ = 3.46 m/s along n"));
        assert!(lab(15.0, ExplanationStep::Split).contains("u₁ₜ = 2.00 m/s along t"));
        assert!(lab(15.0, ExplanationStep::Coin).contains("all of u₁ₙ: v₂ = 3.46 m/s"));
        assert!(lab(15.0, ExplanationStep::Striker).contains("v₁ = u₁ₜ = 2.00 m/s"));
        assert!(lab(45.0, ExplanationStep::Coin).contains("= 0.500 of u₁ₙ: v₂ = 1.73 m/s"));
        assert!(
            lab(45.0, ExplanationStep::Striker)
                .contains("= −0.500 of u₁ₙ: it rebounds at 1.73 m/s")
        );
        assert!(lab(5.0, ExplanationStep::Coin).contains("= 1.50 of u₁ₙ: v₂ = 5.20 m/s"));
        assert!(
            lab(5.0, ExplanationStep::Striker).contains("= 0.500 of u₁ₙ: it moves on at 1.73 m/s")
        );
        // √(4 + 3), from both components.
        assert!(lab(5.0, ExplanationStep::Striker).contains("v₁ = 2.65 m/s"));
    }

    #[test]
    fn in_the_centre_of_mass_frame_the_component_along_n_is_reversed() {
        let seen = words(
            &hit(15.0, 15.0, 30.0),
            Frame::CentreOfMass,
            ExplanationStep::Striker,
        );
        assert!(seen.contains("was 1.73 m/s forwards"), "{seen}");
        assert!(seen.contains("is now 1.73 m/s backwards"), "{seen}");
        assert!(seen.contains("stays at 1.00 m/s"), "{seen}");
    }

    #[test]
    fn every_step_lasts_long_enough_to_be_read() {
        let collision = hit(15.0, 15.0, 30.0);
        let watch = Watch::new(collision, None, HitPace::Still);
        for step in ExplanationStep::of(&collision, &collision.outcome()) {
            let words = watch.step_words(*step).split_whitespace().count() as f64;
            // For a text like this, 200 words per minute is fast reading.
            assert!(watch.hold(*step) >= f64::max(5.0, words / 200.0 * 60.0));
        }
    }

    /// Jₙ = 51.96 g m/s, so friction's impulse is at most 2.598 g m/s; stopping the slip would
    /// require 7.5 g × 2 m/s / 3.
    #[test]
    fn the_step_about_friction_has_the_numbers_of_the_closed_form() {
        let rough = |friction, step| {
            let rims = Rims {
                friction,
                spins: [0.0; 2],
            };
            let collision = Collision {
                rims,
                ..hit(15.0, 15.0, 30.0)
            };
            words(&collision, Frame::Laboratory, step)
        };
        let said = rough(0.05, ExplanationStep::Friction);
        for part in [
            "at most μᵣJₙ = 2.60 g m/s; 5.00 g m/s would stop",
            "Jₜ = 2.60 g m/s, and the rims slip",
            "spin at 23.1 rad/s",
        ] {
            assert!(said.contains(part), "{said}");
        }
        let said = rough(0.2, ExplanationStep::Friction);
        assert!(said.contains("the slip stops: Jₜ = 5.00 g m/s"), "{said}");
        let said = rough(0.2, ExplanationStep::Striker);
        assert!(said.contains("from 2.00 m/s to 1.67 m/s"), "{said}");
        let said = rough(0.2, ExplanationStep::Coin);
        assert!(said.contains("from zero to 0.33 m/s"), "{said}");
    }

    #[test]
    fn for_a_head_on_collision_no_component_along_t_is_mentioned() {
        let head_on = hit(15.0, 15.0, 0.0);
        assert!(words(&head_on, Frame::Laboratory, ExplanationStep::Split).contains("all along n"));
        let striker = words(&head_on, Frame::Laboratory, ExplanationStep::Striker);
        assert!(striker.contains("the striker stops"), "{striker}");
    }
}

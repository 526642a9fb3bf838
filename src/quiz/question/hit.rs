//! A hit on a target at rest, as described to the player: where will the two discs go?

use glam::DVec2;

use crate::physics::units::{deg_from_rad, g_from_kg, mm_from_m, rad_from_deg};
use crate::physics::{Collision, CollisionOutcome, ImpactPoint};

use super::{Family, Pieces, Rays, Topic};
use crate::numbers::{self, significant};

/// A hit, described by the numbers that the player reads. Everything else follows from them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// The striker and the target.
    pub pieces: Pieces,
    /// The point of impact.
    pub given: ImpactPoint,
    /// The coefficient of restitution e, from 0 to 1.
    pub restitution: f64,
    /// The speed of the striker in m/s.
    pub speed: f64,
    /// The direction of the striker in the picture in degrees, anticlockwise from the right. The
    /// angles in the answer are measured from this direction.
    pub direction_deg: f64,
}

impl From<&Collision> for Hit {
    /// Describes a collision of smooth discs, with the target at rest, as a hit given by its
    /// offset.
    fn from(collision: &Collision) -> Self {
        Self {
            pieces: Pieces::Own {
                striker: collision.striker,
                target: collision.target,
            },
            given: ImpactPoint::Offset {
                // A head-on hit is described as exactly head-on, in spite of rounding errors.
                offset_mm: (collision.offset * 1e9).round() / 1e6,
            },
            restitution: collision.restitution,
            speed: numbers::tidy(collision.u1.length()),
            direction_deg: numbers::tidy(deg_from_rad(collision.u1.to_angle())),
        }
    }
}

impl Hit {
    /// The collision that this hit describes.
    pub fn collision(&self) -> Collision {
        let u1 = self.speed * DVec2::from_angle(rad_from_deg(self.direction_deg));
        let [striker, target] = self.pieces.discs();
        Collision {
            restitution: self.restitution,
            ..Collision::at_offset(striker, target, u1, 0.0).meeting_at(self.given)
        }
    }

    /// This hit with another coefficient of restitution.
    pub(in crate::quiz) fn with_restitution(&self, restitution: f64) -> Self {
        Self {
            restitution,
            ..*self
        }
    }

    /// This hit with another impact angle, in degrees.
    pub(in crate::quiz) fn at_angle(&self, alpha_deg: f64) -> Self {
        Self {
            given: ImpactPoint::Angle { alpha_deg },
            ..*self
        }
    }

    /// This hit with the two discs exchanged, at the same impact angle.
    pub(in crate::quiz) fn exchanged(&self) -> Self {
        let [target, striker] = self.pieces.discs();
        Self {
            pieces: Pieces::Own { striker, target },
            ..self.at_angle(deg_from_rad(self.alpha()))
        }
    }

    /// The outcome of the hit.
    pub fn outcome(&self) -> CollisionOutcome {
        self.collision().outcome()
    }

    /// Where the two discs actually go.
    pub fn truth(&self) -> Rays {
        Rays::from(&self.outcome())
    }

    /// The impact angle α in radians, which is positive if the target lies to the right; 0 for a
    /// miss, which no question is about.
    pub fn alpha(&self) -> f64 {
        self.collision().alpha().unwrap_or(0.0)
    }

    /// Whether the hit is head-on.
    pub fn head_on(&self) -> bool {
        self.collision().offset.abs() <= 0.0
    }

    /// The side on which the target lies, as the sign of α: 1 for the right and for
    /// a head-on hit, −1 for the left.
    pub fn side(&self) -> f64 {
        self.collision().side()
    }

    /// The side on which the target lies, in words: "right" or "left".
    pub(crate) fn side_name(&self) -> &'static str {
        if self.side() < 0.0 { "left" } else { "right" }
    }

    /// Mass of the striker divided by the mass of the target.
    pub(crate) fn mass_ratio(&self) -> f64 {
        let [m1, m2] = self.pieces.discs().map(|disc| disc.mass);
        m1 / m2
    }

    /// Whether the two masses are equal.
    pub(in crate::quiz) fn masses_are_equal(&self) -> bool {
        self.mass_ratio().total_cmp(&1.0).is_eq()
    }

    /// Both masses in grams.
    pub(in crate::quiz) fn masses_g(&self) -> [f64; 2] {
        self.pieces.discs().map(|disc| g_from_kg(disc.mass))
    }

    /// The beginning of the first sentence: "A striker of 15.0 g hits a coin of 5.50 g at rest",
    /// where `striker` is the name of the striker and `does` the verb.
    pub(in crate::quiz) fn who(&self, striker: &str, does: &str) -> String {
        let [m1, m2] = self.masses_g().map(significant);
        let name = self.pieces.target_name();
        let mass = match self.masses_are_equal() {
            true => "the same mass".to_owned(),
            false => format!("{m2} g"),
        };
        format!("A {striker} of {m1} g {does} a {name} of {mass} at rest")
    }

    /// The verb phrase for a striker with this speed: "moving at 3.00 m/s hits".
    pub(in crate::quiz) fn hits(&self) -> String {
        format!("moving at {} m/s hits", significant(self.speed))
    }

    /// A sentence that says whether energy is lost: "Some energy is lost: e = 0.500."
    pub(in crate::quiz) fn loss(&self) -> String {
        let how_much = if self.restitution < 1.0 { "Some" } else { "No" };
        let e = significant(self.restitution);
        format!("{how_much} energy is lost: e = {e}.")
    }

    /// The distance between the centres at contact, r₁ + r₂, in millimetres.
    pub fn reach_mm(&self) -> f64 {
        mm_from_m(self.collision().contact_distance())
    }

    /// The topic of the hit: "equal masses, by offset".
    pub fn topic(&self) -> Topic {
        let ratio = self.mass_ratio();
        let pieces = if ratio > 1.0 {
            "heavier-striker"
        } else if ratio < 1.0 {
            "heavier-target"
        } else {
            "equal-masses"
        };
        let place = match self.given {
            _ if self.head_on() => "-head-on",
            ImpactPoint::Angle { .. } => "",
            ImpactPoint::Offset { .. } => "-by-offset",
        };
        let loss = if self.restitution < 1.0 { "-lossy" } else { "" };
        Topic::with_id(format!("{pieces}{place}{loss}"))
    }

    /// The topic under which the quiz asks about hits like this one. Questions about hits with a
    /// loss exist only for some pieces, and these questions give the angle. Any other hit with a
    /// loss is therefore reviewed by its angle instead of its offset, or without the loss.
    pub(crate) fn reviewed_as(&self) -> Topic {
        let by_angle = self.at_angle(deg_from_rad(self.alpha())).topic();
        let topics = [self.topic(), by_angle, self.with_restitution(1.0).topic()];
        let is_asked = |topic: &&Topic| topic.families_of_figures().contains(&Family::WhereTo);
        let found = topics.iter().find(is_asked).cloned();
        found.unwrap_or_else(|| self.topic())
    }

    /// Describes the hit in words, without details that only the picture shows.
    pub fn setting(&self) -> String {
        let name = self.pieces.target_name();
        let side = self.side_name();
        let place = match self.given {
            _ if self.head_on() => "The collision is head-on (offset 0).".to_owned(),
            ImpactPoint::Angle { .. } => format!(
                "Seen along the path, the {name} lies to the {side}; the line of impact is at {} to \
                 the path.",
                numbers::degrees(self.alpha().abs())
            ),
            ImpactPoint::Offset { offset_mm } => format!(
                "Seen along the striker's path, the {name}'s centre lies {} to the {side}; r₁ + r₂ = \
                 {}.",
                numbers::millimetres(offset_mm.abs()),
                numbers::millimetres(self.reach_mm())
            ),
        };
        let who = self.who("striker", &self.hits());
        format!("{who}. {place} {}", self.loss())
    }
}

//! A collision as a problem, and its outcome.
//!
//! The problem is two discs, their velocities and spins, the offset at which they meet, and how
//! they rebound, rub or stick. The point of contact, the line of impact and the final velocities
//! follow from that and are computed, never stored.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec2;

use super::Disc;
use super::angle::{angle_between, signed_angle};
use super::capture::capture;
use super::impact::{Contact, kinetic_energy, reduced_mass};
use super::rims::{self, Rims};
use super::units::rad_from_deg;

/// How the two surfaces behave at contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Bond {
    /// The discs do not stick. Unless their rims have friction, no force acts perpendicular to the
    /// line of impact.
    #[default]
    Slip,
    /// The discs stick where they touch and move on as one body; restitution plays no part.
    Stick,
}

/// Two discs about to meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collision {
    /// Body 1.
    pub striker: Disc,
    /// Body 2.
    pub target: Disc,
    /// Velocity of the striker before the collision, in m/s.
    pub u1: DVec2,
    /// Velocity of the target before the collision, in m/s.
    pub u2: DVec2,
    /// Impact parameter b in metres: how far the target's centre is to the right of the line along
    /// which the striker moves relative to the target.
    pub offset: f64,
    /// The rounding error of [`offset`](Self::offset), in metres, if that offset comes from an
    /// impact angle within a degree of a graze, otherwise 0: b is the offset plus this error. Near
    /// a graze, cos α depends on digits of b that `offset` alone cannot represent.
    pub offset_rest: f64,
    /// Coefficient of restitution e, 0 to 1; it has no effect on discs that stick.
    pub restitution: f64,
    /// Whether the discs slip past each other or stick.
    pub bond: Bond,
    /// Friction at the rims and the spins before the collision. They have no effect on discs that
    /// stick, which are assumed to arrive without spin.
    pub rims: Rims,
}

/// How the two discs met.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Meeting {
    /// The discs pass without touching, or never approach each other.
    Miss,
    /// The discs touch at |b| = r₁ + r₂ and exchange nothing.
    Graze,
    /// The discs collide.
    Hit,
}

/// The outcome of a [`Collision`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CollisionOutcome {
    /// How the two discs met.
    pub(crate) meeting: Meeting,
    /// Line of impact n, the unit vector from centre 1 to centre 2 at contact;
    /// `None` for a miss.
    pub normal: Option<DVec2>,
    /// Tangent t, n turned anticlockwise by a right angle; `None` for a miss.
    pub tangent: Option<DVec2>,
    /// Velocity of the striker after the collision, in m/s. For discs that stick, the velocity of
    /// the pair's centre of mass.
    pub v1: DVec2,
    /// Velocity of the target after the collision, in m/s. For discs that stick, the same as `v1`.
    pub v2: DVec2,
    /// Angular velocity of a pair that sticks, in rad/s, positive clockwise (the
    /// sense it has for a positive offset); 0 for discs that slip.
    pub(crate) spin: f64,
    /// Angular velocities after the collision, in rad/s, positive anticlockwise, for discs that
    /// slip; 0 for a pair that sticks.
    pub spins: [f64; 2],
    /// Scattering angle θ₁ from u₁ to v₁ in radians, positive anticlockwise, in (−π, π]; `None` if
    /// either is zero.
    pub theta1: Option<f64>,
    /// Recoil angle θ₂ from u₁ to v₂ in radians, positive clockwise, in (−π, π]; `None` if either
    /// is zero.
    pub theta2: Option<f64>,
    /// Angle between v₁ and v₂ in radians, in [0, π]; `None` if either is zero.
    pub separation: Option<f64>,
    /// Magnitude of the impulse that each disc exerts on the other, in N·s; for discs that slip,
    /// its component along n.
    pub impulse: f64,
    /// Impulse Jₜ of friction on the target along t (and on the striker against it), in N·s.
    pub friction_impulse: f64,
    /// Kinetic energy before the collision, in joules; it includes the energy of the spins.
    pub energy_before: f64,
    /// Kinetic energy after the collision, in joules; it includes
    /// [`energy_rotation`](Self::energy_rotation).
    pub energy_after: f64,
    /// The rotational energy after the collision, in joules.
    pub energy_rotation: f64,
    /// Kinetic energy lost, in joules.
    pub energy_lost: f64,
}

impl CollisionOutcome {
    /// Whether the discs touched, even if they only grazed each other.
    pub fn hit(&self) -> bool {
        self.meeting != Meeting::Miss
    }
}

impl Collision {
    /// A smooth, perfectly elastic collision at impact angle `alpha` radians with a target at rest.
    /// For any other collision, change the fields that differ; `alpha` remains the impact angle
    /// whatever the velocities, the masses and the restitution.
    pub fn at_angle(striker: Disc, target: Disc, u1: DVec2, alpha: f64) -> Self {
        Self::at_offset(striker, target, u1, 0.0).with_alpha(alpha)
    }

    /// A smooth, perfectly elastic collision at `offset` metres with a target at rest.
    pub fn at_offset(striker: Disc, target: Disc, u1: DVec2, offset: f64) -> Self {
        Self {
            striker,
            target,
            u1,
            u2: DVec2::ZERO,
            offset,
            offset_rest: 0.0,
            restitution: 1.0,
            bond: Bond::Slip,
            rims: Rims::default(),
        }
    }

    /// The same collision at impact angle `alpha` radians, −π/2 to π/2:
    /// b = (r₁ + r₂) sin α.
    #[must_use]
    pub fn with_alpha(self, alpha: f64) -> Self {
        self.with_angle(alpha, FRAC_PI_2 - alpha.abs())
    }

    /// The same collision at an impact angle of `alpha_deg` degrees, −90 to 90. Near a graze this
    /// is more precise than [`with_alpha`](Self::with_alpha), because 90° − α is exact in degrees.
    #[must_use]
    pub fn with_alpha_deg(self, alpha_deg: f64) -> Self {
        self.with_angle(
            rad_from_deg(alpha_deg),
            rad_from_deg(90.0 - alpha_deg.abs()),
        )
    }

    /// The same collision at impact angle `alpha`; `from_graze` is π/2 − |α|.
    fn with_angle(self, alpha: f64, from_graze: f64) -> Self {
        // One degree.
        const NEAR_GRAZE: f64 = PI / 180.0;
        let reach = self.contact_distance();
        let offset = reach * alpha.sin();
        let offset_rest = if from_graze < NEAR_GRAZE {
            // r₁ + r₂ − |b| = (r₁ + r₂)(1 − cos(90° − α)), without subtracting nearly equal
            // numbers.
            let short = 2.0 * reach * (from_graze / 2.0).sin().powi(2);
            (reach - offset.abs() - short) * offset.signum()
        } else {
            0.0
        };
        Self {
            offset,
            offset_rest,
            ..self
        }
    }

    /// Distance between the centres at contact, r₁ + r₂, in metres.
    pub fn contact_distance(&self) -> f64 {
        self.striker.radius + self.target.radius
    }

    /// Striker and target.
    pub(crate) fn discs(&self) -> [Disc; 2] {
        [self.striker, self.target]
    }

    /// The slip speed uₛ = (u₁ − u₂)·t + ω₁r₁ + ω₂r₂ in m/s: the speed of the striker's rim
    /// relative to the target's rim on arrival at the contact, positive along t. `None` for a miss.
    pub(crate) fn slip(&self) -> Option<f64> {
        let relative = self.relative_velocity();
        self.normal()
            .map(|n| rims::slip(self.discs(), relative, self.rims.spins, n))
    }

    /// Whether friction stops the slip before the contact ends.
    pub(crate) fn rub_stops(&self) -> bool {
        let mu = reduced_mass(self.striker.mass, self.target.mass);
        let needed = mu * self.slip().unwrap_or_default().abs() / 3.0;
        needed <= self.rims.friction * self.outcome().impulse
    }

    /// The throw δ in radians: the angle from the line of impact to the velocity that the
    /// collision gives the target, positive from n towards t; `None` for a miss, a graze or discs
    /// that stick.
    pub(crate) fn throw(&self) -> Option<f64> {
        let outcome = self.outcome();
        (outcome.meeting == Meeting::Hit && self.bond == Bond::Slip)
            .then(|| outcome.friction_impulse.atan2(outcome.impulse))
    }

    /// Whether the discs move on as one body: they stick, and do not just graze each other.
    pub(crate) fn coalesces(&self) -> bool {
        self.bond == Bond::Stick && self.outcome().meeting == Meeting::Hit
    }

    /// Velocity of the striker relative to the target, w = u₁ − u₂, in m/s.
    pub fn relative_velocity(&self) -> DVec2 {
        self.u1 - self.u2
    }

    /// Impact angle α in radians, from the relative velocity to the line of impact, positive if the
    /// target's centre is to the right; `None` for a miss.
    pub fn alpha(&self) -> Option<f64> {
        self.relative_velocity().try_normalize()?;
        self.sine().map(f64::asin)
    }

    /// +1 if the target is to the right of the striker's path or the collision is head-on; −1 if it
    /// is to the left.
    pub fn side(&self) -> f64 {
        if self.offset < 0.0 { -1.0 } else { 1.0 }
    }

    /// Line of impact n at contact; `None` for a miss or without relative motion.
    pub fn normal(&self) -> Option<DVec2> {
        let along = self.relative_velocity().try_normalize()?;
        let sine = self.sine()?;
        Some(self.cosine(sine) * along - sine * along.perp())
    }

    /// The centres of striker and target at contact, with the point of contact at the origin. For a
    /// miss, these are the centres at the closest approach, with the origin between them; without
    /// relative motion, the discs are side by side, with the target on the right.
    pub(crate) fn placed_at_contact(&self) -> (DVec2, DVec2) {
        let apart = match (self.normal(), self.relative_velocity().try_normalize()) {
            (Some(normal), _) => self.contact_distance() * normal,
            (None, Some(along)) => -self.offset * along.perp(),
            (None, None) => self.contact_distance() * DVec2::X,
        };
        let share1 = self.striker.radius / self.contact_distance();
        (-share1 * apart, (1.0 - share1) * apart)
    }

    /// The centres of striker and target `time` seconds before they are
    /// [placed at contact](Self::placed_at_contact).
    pub(crate) fn positions_before(&self, time: f64) -> (DVec2, DVec2) {
        let (centre1, centre2) = self.placed_at_contact();
        (centre1 - time * self.u1, centre2 - time * self.u2)
    }

    /// The final velocities, and the quantities that follow from them.
    pub fn outcome(&self) -> CollisionOutcome {
        let Some(normal) = self.normal() else {
            return self.after(None, self.u1, self.u2, self.rims.spins);
        };
        let contact = Contact {
            m1: self.striker.mass,
            m2: self.target.mass,
            u1: self.u1,
            u2: self.u2,
            normal,
            restitution: self.restitution,
        };
        let grazes = self.sine().is_some_and(|sine| self.cosine(sine) <= 0.0);
        match contact.resolve() {
            Some(impact) if !grazes => match self.bond {
                Bond::Slip => match contact.rub(&impact, self.discs(), self.rims) {
                    None => CollisionOutcome {
                        impulse: impact.impulse,
                        energy_lost: impact.energy_lost,
                        ..self.after(Some(normal), impact.v1, impact.v2, self.rims.spins)
                    },
                    Some(rub) => CollisionOutcome {
                        impulse: impact.impulse,
                        friction_impulse: rub.impulse,
                        energy_lost: impact.energy_lost + rub.energy_lost,
                        ..self.after(Some(normal), rub.v1, rub.v2, rub.spins)
                    },
                },
                Bond::Stick => self.captured(normal),
            },
            _ => CollisionOutcome {
                meeting: Meeting::Graze,
                ..self.after(Some(normal), self.u1, self.u2, self.rims.spins)
            },
        }
    }

    /// Velocity of the common centre of mass, (m₁u₁ + m₂u₂) / (m₁ + m₂), in m/s.
    pub(crate) fn centre_of_mass_velocity(&self) -> DVec2 {
        let (m1, m2) = (self.striker.mass, self.target.mass);
        self.u1 * (m1 / (m1 + m2)) + self.u2 * (m2 / (m1 + m2))
    }

    /// Velocities of the two centres right after the contact, in m/s. For discs that slip, these
    /// are v₁ and v₂. A pair that sticks rotates about its centre of mass with ω, so each centre
    /// moves at V + ω × r, where V is the velocity of the centre of mass and r the position of the
    /// centre relative to it.
    pub(crate) fn centres_after(&self) -> [DVec2; 2] {
        let outcome = self.outcome();
        let (centre1, centre2) = self.placed_at_contact();
        let apart = centre2 - centre1;
        let (m1, m2) = (self.striker.mass, self.target.mass);
        // The spin is positive clockwise.
        let turning = -outcome.spin * apart.perp();
        [
            outcome.v1 - turning * (m2 / (m1 + m2)),
            outcome.v2 + turning * (m1 / (m1 + m2)),
        ]
    }

    fn captured(&self, normal: DVec2) -> CollisionOutcome {
        let shared = self.centre_of_mass_velocity();
        let relative_speed = self.relative_velocity().length();
        let pair = capture(self.striker, self.target, self.offset, relative_speed);
        let free = self.after(Some(normal), shared, shared, [0.0; 2]);
        CollisionOutcome {
            spin: pair.spin,
            impulse: self.striker.mass * (shared - self.u1).length(),
            energy_after: free.energy_after + pair.rotation_energy,
            energy_rotation: pair.rotation_energy,
            energy_lost: pair.energy_lost,
            ..free
        }
    }

    /// An outcome with these velocities and spins and no energy loss; it is a hit if there is a
    /// line of impact.
    fn after(
        &self,
        normal: Option<DVec2>,
        v1: DVec2,
        v2: DVec2,
        spins: [f64; 2],
    ) -> CollisionOutcome {
        let energy = |a: DVec2, b: DVec2| {
            kinetic_energy(self.striker.mass, a) + kinetic_energy(self.target.mass, b)
        };
        let rotation = |spins| Rims::rotation_energy(self.discs(), spins);
        CollisionOutcome {
            meeting: normal.map_or(Meeting::Miss, |_| Meeting::Hit),
            normal,
            tangent: normal.map(DVec2::perp),
            v1,
            v2,
            spin: 0.0,
            spins,
            theta1: signed_angle(self.u1, v1),
            // The arguments are swapped because the recoil angle is positive clockwise.
            theta2: signed_angle(v2, self.u1),
            separation: angle_between(v1, v2),
            impulse: 0.0,
            friction_impulse: 0.0,
            energy_before: energy(self.u1, self.u2) + rotation(self.rims.spins),
            energy_after: energy(v1, v2) + rotation(spins),
            energy_rotation: rotation(spins),
            energy_lost: 0.0,
        }
    }

    /// sin α = b / (r₁ + r₂), or `None` beyond ±1. A value within rounding error of ±1 counts as
    /// ±1, because b and the radii rarely agree to the last bit.
    fn sine(&self) -> Option<f64> {
        let sine = self.offset / self.contact_distance();
        let beyond = sine.abs() - 1.0;
        if beyond.abs() <= 4.0 * f64::EPSILON {
            Some(sine.signum())
        } else if beyond < 0.0 {
            Some(sine)
        } else {
            None
        }
    }

    /// cos α from sin α for |α| ≤ π/2, exact at both ends.
    fn cosine(&self, sine: f64) -> f64 {
        if self.offset_rest == 0.0 {
            return ((1.0 - sine) * (1.0 + sine)).sqrt();
        }
        let reach = self.contact_distance();
        let short = reach - self.offset.abs() - self.offset_rest * self.offset.signum();
        (short.max(0.0) / reach * (1.0 + sine.abs())).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::units::deg_from_rad;

    fn carrom(alpha_deg: f64) -> Collision {
        let piece = Disc::from_g_mm(15.0, 15.9);
        let u1 = DVec2::new(4.0, 0.0);
        Collision::at_angle(piece, piece, u1, rad_from_deg(alpha_deg))
    }

    fn deg(angle: Option<f64>) -> f64 {
        deg_from_rad(angle.unwrap())
    }

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-12, "{a} is not {b}");
    }

    #[test]
    fn equal_pieces_at_30_degrees_leave_at_right_angles() {
        let after = carrom(30.0).outcome();
        assert_eq!(after.meeting, Meeting::Hit);
        close(after.v1.length(), 2.0);
        close(after.v2.length(), 2.0 * 3.0_f64.sqrt());
        close(deg(after.theta1), 60.0);
        close(deg(after.theta2), 30.0);
        close(deg(after.separation), 90.0);
        close(after.energy_after, after.energy_before);
        close(after.energy_before, 0.12);
    }

    #[test]
    fn marbles_of_20_and_40_grams_leave_with_the_velocities_calculated_by_hand() {
        let after = Collision::at_angle(
            Disc::from_g_mm(20.0, 8.0),
            Disc::from_g_mm(40.0, 10.0),
            DVec2::new(3.0, 0.0),
            rad_from_deg(45.0),
        )
        .outcome();
        assert!((after.v1 - DVec2::new(1.0, 2.0)).length() < 1e-12);
        assert!((after.v2 - DVec2::new(1.0, -1.0)).length() < 1e-12);
        close(deg(after.theta1), deg_from_rad(2.0_f64.atan()));
        close(deg(after.theta2), 45.0);
        close(deg(after.separation), 45.0 + deg_from_rad(2.0_f64.atan()));
    }

    #[test]
    fn the_line_of_impact_follows_the_sign_convention() {
        let shot = carrom(30.0);
        let normal = shot.normal().unwrap();
        assert!((normal - DVec2::from_angle(rad_from_deg(-30.0))).length() < 1e-15);
        let tangent = shot.outcome().tangent.unwrap();
        assert!((tangent - DVec2::new(0.5, 0.75_f64.sqrt())).length() < 1e-15);
        close(deg(shot.alpha()), 30.0);
        close(shot.offset, shot.contact_distance() / 2.0);
    }

    #[test]
    fn a_negative_offset_is_the_mirror_image() {
        let (right, left) = (carrom(30.0).outcome(), carrom(-30.0).outcome());
        let mirrored = |v: DVec2| DVec2::new(v.x, -v.y);
        assert!((mirrored(right.v1) - left.v1).length() < 1e-15);
        assert!((mirrored(right.v2) - left.v2).length() < 1e-15);
        close(deg(left.theta1), -60.0);
        close(deg(left.theta2), -30.0);
        close(deg(left.separation), 90.0);
    }

    #[test]
    fn a_head_on_hit_between_equals_leaves_the_striker_without_direction() {
        for direction in 0..100 {
            let u1 = 4.0 * DVec2::from_angle(f64::from(direction));
            let after = Collision { u1, ..carrom(0.0) }.outcome();
            assert_eq!(after.v1, DVec2::ZERO);
            assert_eq!(after.theta1, None);
            assert_eq!(after.theta2, Some(0.0));
            assert_eq!(after.separation, None);
        }
    }

    #[test]
    fn a_light_striker_rebounds_straight_back_from_a_head_on_hit() {
        let after = Collision {
            striker: Disc::from_g_mm(5.5, 15.9),
            ..carrom(0.0)
        }
        .outcome();
        assert_eq!(after.theta1, Some(PI));
        assert_eq!(after.separation, Some(PI));
    }

    /// A target at rest leaves at u (1 + e) m₁/(m₁ + m₂) cos α, however thin the hit.
    #[test]
    fn near_a_graze_no_digits_are_lost() {
        for short_deg in [0.9, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8] {
            for side in [1.0, -1.0] {
                let alpha_deg = 90.0 - short_deg;
                let shot = carrom(0.0).with_alpha_deg(side * alpha_deg);
                let after = shot.outcome();
                // The subtraction is exact, because both numbers are near 90.
                let cos = rad_from_deg(90.0 - alpha_deg).sin();
                let relative = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-13, "{a} {b}");
                assert_eq!(after.meeting, Meeting::Hit);
                relative(after.v2.length(), 4.0 * cos);
                relative(after.v2.x, 4.0 * cos * cos);
                relative(after.v1.y, side * 4.0 * cos * rad_from_deg(alpha_deg).sin());
            }
        }
    }

    #[test]
    fn a_miss_changes_nothing() {
        let shot = Collision {
            offset: 0.04,
            ..carrom(0.0)
        };
        let after = shot.outcome();
        assert_eq!(after.meeting, Meeting::Miss);
        assert!(!after.hit());
        assert_eq!((after.v1, after.v2), (shot.u1, shot.u2));
        assert_eq!((after.normal, shot.alpha()), (None, None));
        assert_eq!(after.theta1, Some(0.0));
        assert_eq!((after.theta2, after.separation), (None, None));
        close(after.impulse, 0.0);
    }

    #[test]
    fn a_graze_touches_and_exchanges_nothing() {
        // In metres, the sum of 20.65 mm and 15.9 mm equals 36.55 mm to the last bit.
        for offset in [0.03655, -0.03655] {
            for bond in [Bond::Slip, Bond::Stick] {
                let shot = Collision {
                    bond,
                    ..Collision::at_offset(
                        Disc::from_g_mm(15.0, 20.65),
                        Disc::from_g_mm(5.5, 15.9),
                        DVec2::new(1.7, 2.9),
                        offset,
                    )
                };
                let after = shot.outcome();
                assert_eq!(after.meeting, Meeting::Graze);
                assert!(after.hit());
                assert_eq!((after.v1, after.v2), (shot.u1, DVec2::ZERO));
                assert_eq!(shot.alpha(), Some(FRAC_PI_2.copysign(offset)));
                assert_eq!(after.theta2, None);
            }
        }
        assert_eq!(carrom(90.0).outcome().meeting, Meeting::Graze);
    }

    #[test]
    fn without_relative_motion_they_never_meet() {
        let shot = Collision {
            u2: DVec2::new(4.0, 0.0),
            ..carrom(30.0)
        };
        assert_eq!(shot.outcome().meeting, Meeting::Miss);
        assert_eq!(shot.alpha(), None);
        assert_eq!(shot.outcome().separation, Some(0.0));
    }

    #[test]
    fn slip_without_restitution_is_not_the_same_as_sticking() {
        let slip = Collision {
            restitution: 0.0,
            ..carrom(30.0)
        };
        let stick = Collision {
            bond: Bond::Stick,
            ..slip
        };
        let (slip, stick) = (slip.outcome(), stick.outcome());
        let normal = slip.normal.unwrap();
        close((slip.v1 - slip.v2).dot(normal), 0.0);
        assert!((slip.v1 - slip.v2).length() > 1.0);
        assert_eq!(stick.v1, stick.v2);
        assert!((stick.v1 - DVec2::new(2.0, 0.0)).length() < 1e-15);
        assert_eq!(stick.separation, Some(0.0));
    }

    #[test]
    fn sticking_off_centre_conserves_angular_momentum_and_turns_clockwise() {
        let shot = Collision {
            bond: Bond::Stick,
            u2: DVec2::new(-1.0, 0.5),
            ..carrom(30.0)
        };
        let after = shot.outcome();
        // Angular momentum about the common centre of mass, positive anticlockwise.
        let (centre1, centre2) = shot.placed_at_contact();
        let (m1, m2) = (shot.striker.mass, shot.target.mass);
        let middle = (m1 * centre1 + m2 * centre2) / (m1 + m2);
        let before = m1 * (centre1 - middle).perp_dot(shot.u1 - after.v1)
            + m2 * (centre2 - middle).perp_dot(shot.u2 - after.v2);
        let inertia = super::super::capture::moment_of_inertia(shot.striker, shot.target);
        assert!((before + inertia * after.spin).abs() < 1e-18);
        assert!(after.spin > 0.0);
        close(after.energy_rotation, 0.5 * inertia * after.spin.powi(2));
        let sum = after.energy_after + after.energy_lost;
        close(sum, after.energy_before);
    }

    #[test]
    fn the_discs_touch_at_the_origin_and_are_apart_before() {
        let shot = Collision {
            u2: DVec2::new(-1.0, 0.5),
            striker: Disc::from_g_mm(15.0, 20.65),
            ..carrom(30.0)
        };
        let (centre1, centre2) = shot.placed_at_contact();
        close(centre1.length(), shot.striker.radius);
        close(centre2.length(), shot.target.radius);
        close((centre2 - centre1).length(), shot.contact_distance());
        let (before1, before2) = shot.positions_before(0.1);
        assert!((before1 + 0.1 * shot.u1 - centre1).length() < 1e-15);
        assert!((before2 + 0.1 * shot.u2 - centre2).length() < 1e-15);
        assert!((before2 - before1).length() > shot.contact_distance());
        // The offset is how far the target is to the right of the relative path.
        let along = shot.relative_velocity().normalize();
        close((before2 - before1).perp_dot(along), shot.offset);
    }

    #[test]
    fn a_miss_is_placed_at_the_closest_approach() {
        let shot = Collision {
            offset: -0.05,
            u2: DVec2::new(-1.0, 0.5),
            ..carrom(0.0)
        };
        let gap = |time| {
            let (centre1, centre2) = shot.positions_before(time);
            (centre2 - centre1).length()
        };
        close(gap(0.0), 0.05);
        assert!(gap(0.01) > gap(0.0) && gap(-0.01) > gap(0.0));
    }

    /// By hand: two discs of 15 g and 15 mm, b = 15 mm, 4 m/s. μ = 7.5 g and I = 1687.5 + 1687.5 +
    /// 7.5 · 900 = 10125 g mm², so ω = 7.5 · 15 · 4000 / 10125 = 44.4 rad/s, and each centre, 15 mm
    /// from the centre of mass, moves around it at 2/3 m/s.
    #[test]
    fn the_centres_of_a_pair_that_sticks_rotate_about_their_centre_of_mass() {
        let piece = Disc::from_g_mm(15.0, 15.0);
        let hit = Collision {
            bond: Bond::Stick,
            ..Collision::at_offset(piece, piece, DVec2::new(4.0, 0.0), 0.015)
        };
        let [v1, v2] = hit.centres_after();
        let shared = hit.outcome().v1;
        close((v1 - shared).length(), 2.0 / 3.0);
        close((v2 - shared).length(), 2.0 / 3.0);
        // Both centres move perpendicular to the line between them, and the pair turns clockwise:
        // the striker, which is above, moves to the right.
        let normal = hit.normal().unwrap();
        close((v1 - shared).dot(normal), 0.0);
        assert!(v1.x > shared.x && v2.x < shared.x);
    }

    #[test]
    fn the_velocities_after_the_contact_carry_all_momentum_and_agree_with_the_record() {
        for (bond, offset) in [
            (Bond::Slip, 0.012),
            (Bond::Stick, 0.012),
            (Bond::Stick, -0.03),
            (Bond::Stick, 0.0),
            (Bond::Stick, 0.05),
        ] {
            let hit = Collision {
                u2: DVec2::new(-0.5, 1.0),
                bond,
                ..Collision::at_offset(
                    Disc::from_g_mm(15.0, 20.65),
                    Disc::from_g_mm(5.5, 15.9),
                    DVec2::new(3.0, 0.4),
                    offset,
                )
            };
            let after = hit.centres_after();
            let momentum = |v: [DVec2; 2]| hit.striker.mass * v[0] + hit.target.mass * v[1];
            let before = momentum([hit.u1, hit.u2]);
            assert!((momentum(after) - before).length() < 1e-15);
            let shot = hit.shot(0.02, 0.04).unwrap();
            for (body, v) in after.into_iter().enumerate() {
                // Just after the contact; rotation is negligible after 1 ns.
                let recorded = shot.at(body, 0.02 + 1e-9).velocity;
                assert!((recorded - v).length() < 1e-5, "{bond:?} {offset}");
            }
        }
    }
}

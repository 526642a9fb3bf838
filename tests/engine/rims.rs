//! Friction between the rims: the closed form against conservation laws and against a stiff contact
//! that is integrated in time.

use carrom::physics::{Bond, Collision, CollisionOutcome, Disc, Rims};
use glam::DVec2;
use proptest::prelude::*;

fn disc(mass_g: f64, radius_mm: f64) -> Disc {
    Disc::from_g_mm(mass_g, radius_mm)
}

fn inertia(disc: Disc) -> f64 {
    0.5 * disc.mass * disc.radius * disc.radius
}

fn reduced_mass(c: &Collision) -> f64 {
    c.striker.mass * c.target.mass / (c.striker.mass + c.target.mass)
}

/// The greatest speed of a centre, or of a rim about its centre, before the collision, in m/s.
fn fastest(c: &Collision) -> f64 {
    let rims = [
        c.rims.spins[0] * c.striker.radius,
        c.rims.spins[1] * c.target.radius,
    ];
    let speeds = [c.u1.length(), c.u2.length(), rims[0].abs(), rims[1].abs()];
    speeds.into_iter().fold(0.0, f64::max)
}

/// The slip speed at the contact for these velocities and spins, in m/s.
fn slip(c: &Collision, normal: DVec2, [v1, v2]: [DVec2; 2], spins: [f64; 2]) -> f64 {
    (v1 - v2).dot(normal.perp()) + spins[0] * c.striker.radius + spins[1] * c.target.radius
}

fn energy(c: &Collision, v: [DVec2; 2], spins: [f64; 2]) -> f64 {
    let of = |disc: Disc, v: DVec2, spin: f64| {
        0.5 * disc.mass * v.length_squared() + 0.5 * inertia(disc) * spin * spin
    };
    of(c.striker, v[0], spins[0]) + of(c.target, v[1], spins[1])
}

prop_compose! {
    fn rough()(
        masses in (-1.5..1.5_f64, -1.5..1.5_f64),
        radii in (5.0..50.0_f64, 5.0..50.0_f64),
        u in (-5.0..5.0_f64, -5.0..5.0_f64, -5.0..5.0_f64, -5.0..5.0_f64),
        alpha_deg in -89.9..=89.9_f64,
        restitution in prop_oneof![Just(0.0), Just(1.0), 0.0..=1.0],
        friction in prop_oneof![Just(0.0), Just(f64::INFINITY), 0.0..2.0],
        spins in prop_oneof![Just([0.0; 2]), prop::array::uniform2(-300.0..300.0)],
    ) -> Collision {
        let striker = disc(10_f64.powf(masses.0), radii.0);
        let target = disc(10_f64.powf(masses.1), radii.1);
        Collision {
            u2: DVec2::new(u.2, u.3),
            restitution,
            rims: Rims { friction, spins },
            ..Collision::at_offset(striker, target, DVec2::new(u.0, u.1), 0.0)
        }.with_alpha_deg(alpha_deg)
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn momentum_and_angular_momentum_about_any_point_are_conserved(
        c in rough(),
        x in -1.0..1.0_f64,
        y in -1.0..1.0_f64,
    ) {
        let after = c.outcome();
        let normal = after.normal.unwrap();
        let point = DVec2::new(x, y);
        // The point of contact is the origin.
        let arms = [-c.striker.radius * normal - point, c.target.radius * normal - point];
        let discs = [c.striker, c.target];
        let sums = |v: [DVec2; 2], spins: [f64; 2]| {
            let linear = discs[0].mass * v[0] + discs[1].mass * v[1];
            let angular: f64 = (0..2)
                .map(|i| discs[i].mass * arms[i].perp_dot(v[i]) + inertia(discs[i]) * spins[i])
                .sum();
            (linear, angular)
        };
        let before = sums([c.u1, c.u2], c.rims.spins);
        let left = sums([after.v1, after.v2], after.spins);
        let total: f64 = discs.iter().map(|disc| disc.mass).sum();
        let size = total * fastest(&c);
        prop_assert!((left.0 - before.0).length() <= 1e-12 * size);
        let reach = arms[0].length() + arms[1].length() + c.contact_distance();
        prop_assert!((left.1 - before.1).abs() <= 1e-12 * size * reach);
    }

    #[test]
    fn energy_never_increases_and_the_loss_is_the_difference(c in rough()) {
        let after = c.outcome();
        let before = energy(&c, [c.u1, c.u2], c.rims.spins);
        let left = energy(&c, [after.v1, after.v2], after.spins);
        prop_assert!((after.energy_before - before).abs() <= 1e-12 * before);
        prop_assert!((after.energy_after - left).abs() <= 1e-12 * before);
        prop_assert!((before - left - after.energy_lost).abs() <= 1e-11 * before);
        prop_assert!(after.energy_lost >= 0.0);
        prop_assert!(left <= before * (1.0 + 1e-12));
    }

    /// Velocities, energy lost and impulse agree to the last bit, whatever the spins are.
    #[test]
    fn without_friction_nothing_differs_from_smooth_rims(c in rough()) {
        let smooth = Collision { rims: Rims::default(), ..c }.outcome();
        let spins = c.rims.spins;
        let spinning = Collision { rims: Rims { friction: 0.0, spins }, ..c }.outcome();
        let bits = |v: DVec2| v.to_array().map(f64::to_bits);
        prop_assert_eq!(bits(smooth.v1), bits(spinning.v1));
        prop_assert_eq!(bits(smooth.v2), bits(spinning.v2));
        prop_assert_eq!(smooth.energy_lost.to_bits(), spinning.energy_lost.to_bits());
        prop_assert_eq!(smooth.impulse.to_bits(), spinning.impulse.to_bits());
        prop_assert_eq!(spinning.spins, spins);
        let still = Collision { rims: Rims { friction: 0.0, spins: [0.0; 2] }, ..c }.outcome();
        prop_assert_eq!(still, smooth);
        prop_assert_eq!(still.energy_before.to_bits(), smooth.energy_before.to_bits());
    }

    #[test]
    fn with_unlimited_friction_the_rims_roll_without_slip(c in rough()) {
        let spins = c.rims.spins;
        let c = Collision { rims: Rims { friction: f64::INFINITY, spins }, ..c };
        let after = c.outcome();
        let left = slip(&c, after.normal.unwrap(), [after.v1, after.v2], after.spins);
        prop_assert!(left.abs() <= 1e-12 * fastest(&c) * 50.0, "{}", left);
    }

    /// Along n nothing changes: the discs separate at e times the speed of approach.
    #[test]
    fn friction_changes_nothing_along_the_line_of_impact(c in rough()) {
        let rough = c.outcome();
        let smooth = Collision { rims: Rims::default(), ..c }.outcome();
        let normal = rough.normal.unwrap();
        let along = |o: &CollisionOutcome| [o.v1.dot(normal), o.v2.dot(normal)];
        for (a, b) in along(&rough).into_iter().zip(along(&smooth)) {
            prop_assert!((a - b).abs() <= 1e-12 * fastest(&c) * 50.0);
        }
        prop_assert_eq!(rough.impulse.to_bits(), smooth.impulse.to_bits());
    }
}

/// The tangent of the throw angle when a 15 g striker without spin hits a 5.5 g coin at rest.
fn thrown(alpha: f64, restitution: f64, friction: f64) -> f64 {
    let c = Collision {
        restitution,
        rims: Rims {
            friction,
            spins: [0.0; 2],
        },
        ..Collision::at_angle(
            disc(15.0, 15.9),
            disc(5.5, 15.9),
            DVec2::new(4.0, 0.0),
            alpha,
        )
    };
    let after = c.outcome();
    let normal = after.normal.unwrap();
    after.v2.dot(normal.perp()) / after.v2.dot(normal)
}

#[test]
fn the_throw_follows_its_formula() {
    for restitution in [0.0, 0.5, 0.8, 1.0] {
        for friction in [0.0_f64, 0.02, 0.05, 0.2, 1.0] {
            for deg in 1..90 {
                let alpha = f64::from(deg).to_radians();
                let expected = friction.min(alpha.tan() / (3.0 * (1.0 + restitution)));
                let tan = thrown(alpha, restitution, friction);
                assert!((tan - expected).abs() <= 1e-13, "{deg}° {tan} {expected}");
            }
        }
    }
}

#[test]
fn the_throw_is_greatest_where_the_rims_just_stop_slipping() {
    for (restitution, friction) in [(1.0, 0.05), (1.0, 0.2), (0.5, 0.1)] {
        let best = f64::atan(3.0 * (1.0 + restitution) * friction);
        let most = thrown(best, restitution, friction);
        assert!((most - friction).abs() < 1e-14);
        for deg in 1..90 {
            let alpha = f64::from(deg).to_radians();
            assert!(thrown(alpha, restitution, friction) <= most + 1e-14);
        }
        // Below that angle the throw is smaller, because the rims stop slipping before the contact
        // ends.
        assert!(thrown(0.99 * best, restitution, friction) < 0.995 * most);
    }
}

/// By hand: 15 g discs with a radius of 15 mm, 4 m/s, α = 30°, e = 1, μᵣ = 0.05.
/// Jₙ = 15 × 4 cos 30° = 51.96, Jₜ = 0.05 Jₙ = 2.598 (less than 7.5 × 2 / 3 = 5) g m/s, and
/// ω = −2 × 2.598 / (15 × 0.015).
#[test]
fn an_example_worked_by_hand() {
    let piece = disc(15.0, 15.0);
    let c = Collision {
        rims: Rims {
            friction: 0.05,
            spins: [0.0; 2],
        },
        ..Collision::at_angle(piece, piece, DVec2::new(4.0, 0.0), 30_f64.to_radians())
    };
    let after = c.outcome();
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
    let impulse = 0.05 * 60.0 * 0.75_f64.sqrt();
    close(1000.0 * after.friction_impulse, impulse);
    for spin in after.spins {
        close(spin, -2.0 * impulse / (15.0 * 0.015));
    }
    let normal = after.normal.unwrap();
    close(after.v1.dot(normal), 0.0);
    close(after.v1.dot(normal.perp()), 2.0 - impulse / 15.0);
    // The paths are less than 90° apart, because the coin is thrown towards the striker's side.
    close(
        after.separation.unwrap().to_degrees(),
        90.0 - 0.05_f64.atan().to_degrees(),
    );
    // In the engine's record, the discs leave with the same velocities.
    let shot = c.shot(0.02, 0.05).unwrap();
    assert!((shot.at(0, 0.04).velocity - after.v1).length() < 1e-12);
    assert!((shot.at(1, 0.04).velocity - after.v2).length() < 1e-12);
    let moved = shot.at(1, 0.05).position - shot.at(1, 0.02).position;
    assert!((moved - 0.03 * after.v2).length() < 1e-12);
    assert!((shot.energy_after() + after.energy_rotation - after.energy_after).abs() < 1e-15);
}

#[test]
fn discs_that_stick_arrive_without_spin() {
    let piece = disc(15.0, 15.0);
    let sticking = Collision {
        bond: Bond::Stick,
        ..Collision::at_angle(piece, piece, DVec2::new(4.0, 0.0), 0.5)
    };
    let spinning = Collision {
        rims: Rims {
            friction: 0.3,
            spins: [10.0, -5.0],
        },
        ..sticking
    };
    assert_eq!(spinning.outcome().v1, sticking.outcome().v1);
    assert_eq!(spinning.outcome().spins, [0.0; 2]);
}

/// A contact of finite stiffness, integrated in time with fourth-order Runge–Kutta steps.
///
/// The force of Walton and Braun (1986) acts along the line between the centres. It is k δ while
/// the overlap δ grows, and k/e² (δ − δ₀) with δ₀ = (1 − e²) δ_max while the overlap shrinks, so
/// the discs separate at e times the speed of approach. Coulomb friction μ F acts along the rims,
/// opposite to the slip; once the slip has stopped, friction keeps it at 0 as far as μ F allows.
struct StiffContact<'a> {
    c: &'a Collision,
    /// Stiffness k in N/m.
    stiffness: f64,
    normal: DVec2,
    /// The current part of the force law.
    phase: Phase,
}

#[derive(Clone, Copy)]
struct Phase {
    /// The greatest overlap in m, once it has been reached.
    most: Option<f64>,
    /// The sign of the slip; `None` once it has stopped.
    sliding: Option<f64>,
}

/// The displacement of centre 2 relative to centre 1 since the start of the contact, the velocities
/// and the spins.
#[derive(Clone, Copy)]
struct State {
    apart: DVec2,
    v: [DVec2; 2],
    spins: [f64; 2],
}

impl State {
    fn plus(self, rate: &Self, time: f64) -> Self {
        let v = [0, 1].map(|i| self.v[i] + time * rate.v[i]);
        let spins = [0, 1].map(|i| self.spins[i] + time * rate.spins[i]);
        let apart = self.apart + time * rate.apart;
        Self { apart, v, spins }
    }
}

impl StiffContact<'_> {
    /// The line between the centres, and the overlap, calculated without subtracting nearly equal
    /// lengths.
    fn place(&self, state: &State) -> (DVec2, f64) {
        let reach = self.c.contact_distance();
        let line = reach * self.normal + state.apart;
        let grown = 2.0 * reach * self.normal.dot(state.apart) + state.apart.length_squared();
        (line.normalize(), -grown / (reach + line.length()))
    }

    /// How fast the overlap is growing.
    fn closing(&self, state: &State) -> f64 {
        (state.v[0] - state.v[1]).dot(self.place(state).0)
    }

    fn slip(&self, state: &State) -> f64 {
        slip(self.c, self.place(state).0, state.v, state.spins)
    }

    fn force(&self, overlap: f64) -> f64 {
        let e2 = self.c.restitution * self.c.restitution;
        let force = match self.phase.most {
            None => self.stiffness * overlap,
            Some(most) => self.stiffness / e2 * (overlap - (1.0 - e2) * most),
        };
        force.max(0.0)
    }

    fn rate(&self, state: &State) -> State {
        let (n, overlap) = self.place(state);
        let force = self.force(overlap);
        let limit = self.c.rims.friction * force;
        let relative = state.v[0] - state.v[1];
        let friction = match self.phase.sliding {
            Some(sign) => sign * limit,
            // This keeps d(slip)/dt at 0 while the line between the centres turns.
            None => {
                let turning = -relative.dot(n.perp()) / self.c.contact_distance();
                let needed = -reduced_mass(self.c) / 3.0 * turning * relative.dot(n);
                needed.clamp(-limit, limit)
            }
        };
        let push = force * n + friction * n.perp();
        let discs = [self.c.striker, self.c.target];
        State {
            apart: -relative,
            v: [-push / discs[0].mass, push / discs[1].mass],
            spins: discs.map(|disc| -disc.radius * friction / inertia(disc)),
        }
    }

    fn step(&self, state: &State, time: f64) -> State {
        let k1 = self.rate(state);
        let k2 = self.rate(&state.plus(&k1, time / 2.0));
        let k3 = self.rate(&state.plus(&k2, time / 2.0));
        let k4 = self.rate(&state.plus(&k3, time));
        let weighted = [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)];
        weighted.into_iter().fold(*state, |sum, (rate, weight)| {
            sum.plus(&rate, weight * time / 6.0)
        })
    }

    /// Integrates in steps of `time` until `signal` is no longer positive, handling the end of the
    /// slip on the way. The time of each event is found by bisection.
    fn run(&mut self, mut state: State, time: f64, signal: fn(&Self, &State) -> f64) -> State {
        // A step may end at an event, so a phase may need more steps than a quarter period has.
        for _ in 0..100_000 {
            let next = self.step(&state, time);
            let slips = |it: &Self, state: &State| {
                it.phase.sliding.map_or(1.0, |sign| sign * it.slip(state))
            };
            let ends = signal(self, &next) <= 0.0;
            let stops = slips(self, &next) <= 0.0;
            if !ends && !stops {
                state = next;
                continue;
            }
            let until = |event: &dyn Fn(&Self, &State) -> f64| {
                let (mut low, mut high) = (0.0, time);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    let before = event(self, &self.step(&state, middle)) > 0.0;
                    *(if before { &mut low } else { &mut high }) = middle;
                }
                high
            };
            let end = if ends { until(&signal) } else { f64::INFINITY };
            let stop = if stops { until(&slips) } else { f64::INFINITY };
            state = self.step(&state, end.min(stop));
            if stop <= end {
                self.phase.sliding = None;
            }
            if end <= stop {
                return state;
            }
        }
        panic!("the contact does not end: {:?}", self.c);
    }

    /// The velocities and spins after the contact, with `steps` steps in each quarter period. The
    /// contact is so short that the discs move by only about `shift` times the sum of their radii.
    fn outcome(c: &Collision, steps: f64, shift: f64) -> State {
        let normal = c.normal().unwrap();
        let lasts = shift * c.contact_distance() / fastest(c);
        let stiffness = reduced_mass(c) / (lasts * lasts);
        let quarter = std::f64::consts::FRAC_PI_2 * lasts;
        let start = State {
            apart: DVec2::ZERO,
            v: [c.u1, c.u2],
            spins: c.rims.spins,
        };
        let sign = slip(c, normal, start.v, start.spins).signum();
        let phase = Phase {
            most: None,
            sliding: Some(sign),
        };
        let mut contact = StiffContact {
            c,
            stiffness,
            normal,
            phase,
        };
        let closed = contact.run(start, quarter / steps, StiffContact::closing);
        let most = contact.place(&closed).1;
        contact.phase.most = Some(most);
        if c.restitution == 0.0 {
            return closed;
        }
        contact.run(closed, c.restitution * quarter / steps, |it, state| {
            it.force(it.place(state).1)
        })
    }
}

/// A uniform number from 0 to 1 (SplitMix64).
fn uniform(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *seed;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

/// A random contact: mass ratios up to 1:100, radius ratios up to 1:4, the target moving or at
/// rest, each disc with or without spin, e = 0 or from 0.05 to 1, μᵣ from 0 to 1.5, impact angles
/// up to 89°.
fn random_contact(seed: &mut u64) -> Collision {
    let mut from = |low: f64, high: f64| low + (high - low) * uniform(seed);
    let striker = disc(10_f64.powf(from(0.0, 2.0)), from(10.0, 40.0));
    let target = disc(10_f64.powf(from(0.0, 2.0)), from(10.0, 40.0));
    let u1 = DVec2::new(from(-5.0, 5.0), from(-5.0, 5.0));
    let u2 = DVec2::new(from(-5.0, 5.0), from(-5.0, 5.0)) * from(-0.5, 1.0).max(0.0);
    let restitution = from(-0.05, 1.0);
    let spins = [0, 1].map(|_| from(-200.0, 200.0) * from(-0.5, 1.0).max(0.0));
    Collision {
        u2,
        restitution: if restitution < 0.05 { 0.0 } else { restitution },
        rims: Rims {
            friction: from(-0.1, 1.5).max(0.0),
            spins,
        },
        ..Collision::at_offset(striker, target, u1, 0.0)
    }
    .with_alpha_deg(from(-89.0, 89.0))
}

/// The worst difference between the closed form and the integration, relative to the greatest
/// speed before or after the contact.
fn worst_difference(contacts: usize, steps: f64, shift: f64) -> f64 {
    let mut seed = 28;
    let one = |_| {
        let c = random_contact(&mut seed);
        let (after, rub) = (c.outcome(), StiffContact::outcome(&c, steps, shift));
        let radii = [c.striker.radius, c.target.radius];
        let rims = [0, 1].map(|i| radii[i] * after.spins[i]);
        let scale = [
            after.v1.length(),
            after.v2.length(),
            rims[0].abs(),
            rims[1].abs(),
        ]
        .into_iter()
        .fold(fastest(&c), f64::max);
        let velocities = (after.v1 - rub.v[0])
            .length()
            .max((after.v2 - rub.v[1]).length());
        let spins = [0, 1].map(|i| radii[i] * (after.spins[i] - rub.spins[i]).abs());
        velocities.max(spins[0]).max(spins[1]) / scale
    };
    (0..contacts).map(one).fold(0.0, f64::max)
}

fn listed(errors: &[f64]) -> String {
    let errors: Vec<_> = errors.iter().map(|error| format!("{error:.1e}")).collect();
    errors.join(", ")
}

/// Prints and checks how the difference decreases as the contact and the steps get shorter.
fn check_convergence(contacts: usize) {
    let by_time = [1e-5, 1e-6, 1e-7].map(|shift| worst_difference(contacts, 16.0, shift));
    let listed_times = listed(&by_time);
    println!("{contacts} contacts, shifts of 1e-5, 1e-6, 1e-7: {listed_times}");
    // The error is of first order in the duration of the contact.
    assert!(by_time.windows(2).all(|pair| pair[1] < pair[0] / 5.0));
    let by_step = [4.0, 8.0, 16.0, 32.0].map(|steps| worst_difference(contacts, steps, 1e-8));
    let listed_steps = listed(&by_step);
    println!("{contacts} contacts, 4, 8, 16, 32 steps per quarter period: {listed_steps}");
    // The integration is of fourth order: half the step gives a sixteenth of the error, until the
    // error due to the finite contact time is reached.
    assert!(
        by_step
            .windows(2)
            .all(|pair| pair[1] < pair[0] / 8.0 || pair[1] < 5e-7)
    );
    assert!(by_step[3] <= 1e-6, "{by_step:?}");
}

#[test]
fn the_closed_form_agrees_with_a_stiff_contact_integrated_in_time() {
    check_convergence(200);
}

#[test]
#[ignore = "takes minutes"]
fn the_closed_form_agrees_with_a_hundred_thousand_stiff_contacts() {
    check_convergence(100_000);
}

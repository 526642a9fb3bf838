//! Tests of the sampler against the closed forms, and against computing each particle's angle.

use std::f64::consts::PI;

use rand::Rng;

use super::sampler::generator;
use super::*;
use crate::physics::beam::Beam;
use crate::physics::rutherford::{MEV, RADIUM_C_ENERGY, Rutherford};

const DISC: ScatteringLaw = ScatteringLaw {
    target: BeamTarget::Hard,
    beam: Beam::Board,
};

const SPHERE: ScatteringLaw = ScatteringLaw {
    target: BeamTarget::Hard,
    beam: Beam::Space,
};

/// α-particles from radium C on gold, in a beam so narrow that every bin gets enough particles: the
/// outermost particles are scattered by 2.5°.
fn coulomb(beam: Beam) -> ScatteringLaw {
    let scatterer = Rutherford::radium_c_on_gold();
    let half_width = scatterer.impact_parameter(2.5_f64.to_radians());
    ScatteringLaw {
        target: BeamTarget::Coulomb {
            scatterer,
            half_width: half_width.unwrap(),
        },
        beam,
    }
}

fn foil(thickness: f64) -> ScatteringLaw {
    ScatteringLaw {
        target: METALS[0].foil(thickness, RADIUM_C_ENERGY),
        beam: Beam::Space,
    }
}

fn thrown(law: &ScatteringLaw, seed: u64, particles: u64) -> Counts {
    let mut counts = Counts::default();
    Sampler::new(law).throw(seed, 0..particles, &mut counts);
    counts
}

/// Fraction of the beam beyond an edge, from the closed forms in `physics` alone.
type Beyond<'a> = &'a dyn Fn(f64) -> f64;

fn chi_squared(counts: &Counts, beyond: Beyond) -> f64 {
    let total = counts.total() as f64;
    let edge = |bin: usize| (bin as f64 * PI / 36.0).min(PI);
    (0..BINS)
        .map(|bin| {
            let expected = total * (beyond(edge(bin)) - beyond(edge(bin + 1)));
            assert!(
                expected > 5.0,
                "bin {bin} is too empty to judge: {expected}"
            );
            (counts.bins[bin] as f64 - expected).powi(2) / expected
        })
        .sum()
}

/// The probability that χ² with k = 35 degrees of freedom exceeds `x`: one minus the integral of
/// t^(k/2−1) e^(−t/2) / (2^(k/2) Γ(k/2)) over t from 0 to `x`, by Simpson's rule.
fn chance_beyond(x: f64) -> f64 {
    let half = 35.0 / 2.0;
    // Γ(35/2) = 33!! √π / 2¹⁷.
    let double_factorial: f64 = (1..=33).step_by(2).map(f64::from).product();
    let gamma = double_factorial * PI.sqrt() / 2_f64.powi(17);
    let density = |x: f64| x.powf(half - 1.0) * (-x / 2.0).exp() / (2_f64.powf(half) * gamma);
    let pieces = 20_000;
    let step = x / f64::from(pieces);
    let sum: f64 = (0..=pieces)
        .map(|i| {
            let weight = match i {
                0 => 1.0,
                _ if i == pieces => 1.0,
                _ if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            weight * density(f64::from(i) * step)
        })
        .sum();
    1.0 - sum * step / 3.0
}

#[test]
fn chance_beyond_agrees_with_published_tables() {
    // Upper points of χ² with 35 degrees of freedom.
    for (x, chance) in [
        (34.336, 0.5),
        (49.802, 0.05),
        (57.342, 0.01),
        (66.619, 0.001),
    ] {
        assert!((chance_beyond(x) / chance - 1.0).abs() < 1e-3, "{x}");
    }
}

/// Compares 10⁷ particles in 36 bins with the closed forms.
#[test]
fn ten_million_particles_agree_with_the_closed_forms() {
    let gold = Rutherford::radium_c_on_gold();
    let sigma = |angle| gold.cross_section_beyond(angle).unwrap_or(f64::INFINITY);
    let whole = sigma(2.5_f64.to_radians());
    let cases: [(&str, ScatteringLaw, Beyond); 4] = [
        ("disc", DISC, &|a| Beam::Board.share_within((a / 2.0).cos())),
        ("sphere", SPHERE, &|a| {
            Beam::Space.share_within((a / 2.0).cos())
        }),
        ("Coulomb", coulomb(Beam::Space), &|a| {
            (sigma(a) / whole).min(1.0)
        }),
        ("plane Coulomb", coulomb(Beam::Board), &|a| {
            (sigma(a) / whole).min(1.0).sqrt()
        }),
    ];
    for (name, law, beyond) in cases {
        let counts = thrown(&law, 1913, 10_000_000);
        assert_eq!(counts.total(), 10_000_000);
        let chance = chance_beyond(chi_squared(&counts, beyond));
        assert!((0.001..=0.999).contains(&chance), "{name}: p = {chance}");
    }
}

/// The table of edges gives exactly the same counts as computing each angle.
#[test]
fn every_particle_is_in_the_bin_of_its_angle() {
    for law in [
        DISC,
        SPHERE,
        coulomb(Beam::Space),
        coulomb(Beam::Board),
        foil(2.1e-7),
    ] {
        const PARTICLES: u64 = 300_000;
        let mut counts = Counts::default();
        let mut numbers = generator(7, 0);
        for _ in 0..PARTICLES {
            let even = numbers.next_u64() as f64 / 2_f64.powi(64);
            let nearness = match law.beam {
                Beam::Board => even,
                Beam::Space => even.sqrt(),
            };
            let bin = (law.angle(nearness) / BIN_WIDTH) as usize;
            counts.bins[bin.min(BINS - 1)] += 1;
        }
        assert_eq!(thrown(&law, 7, PARTICLES), counts, "{law:?}");
    }
}

#[test]
fn a_beam_can_be_computed_in_any_number_of_batches() {
    let law = coulomb(Beam::Space);
    let whole = thrown(&law, 5, 100_003);
    let sampler = Sampler::new(&law);
    let mut counts = Counts::default();
    for part in [70_001..100_003, 0..3, 3..4, 4..4, 4..70_001] {
        sampler.throw(5, part, &mut counts);
    }
    assert_eq!(counts, whole);
    assert_ne!(thrown(&law, 6, 100_003), whole);
}

/// The meaning of a seed never changes: the generator must be O'Neill's PCG64 (XSL-RR 128/64).
#[test]
fn the_generator_is_pcg64_as_defined() {
    const A: u128 = 0x2360_ed05_1fc6_5da4_4385_df64_9fcc_f645;
    let c = (0x0a02_bdbf_7bb3_c0a7_u128 << 1) | 1;
    let mut state = u128::wrapping_add(42, c).wrapping_mul(A).wrapping_add(c);
    let mut numbers = generator(42, 0);
    for i in 0..100 {
        assert_eq!(generator(42, i).next_u64(), {
            state = state.wrapping_mul(A).wrapping_add(c);
            let folded = (state >> 64) as u64 ^ state as u64;
            folded.rotate_right((state >> 122) as u32)
        });
        numbers.next_u64();
    }
    assert_eq!(numbers.next_u64(), generator(42, 100).next_u64());
}

#[test]
fn shares_and_angles_are_inverse_functions() {
    for law in [DISC, SPHERE, coulomb(Beam::Space), foil(2e-6)] {
        for deg in 10..180 {
            let angle = f64::from(deg).to_radians();
            assert!((law.angle(law.nearness(angle)) - angle).abs() < 1e-9);
        }
        assert!(law.share_beyond(PI) <= 0.0 && law.share_beyond(0.0) >= 1.0);
        assert!((law.angle(0.0) - PI).abs() < 1e-12);
    }
}

/// The count per steradian, integrated over a band of directions, is the count in the band.
#[test]
fn the_share_per_steradian_integrates_to_the_share_of_a_ring() {
    for law in [SPHERE, coulomb(Beam::Space), foil(2e-6)] {
        for deg in [5.0_f64, 15.0, 60.0, 90.0, 150.0, 179.0] {
            let (angle, half) = (deg.to_radians(), 1e-5);
            let ring = law.share_beyond(angle - half) - law.share_beyond(angle + half);
            let steradians = 2.0 * PI * ((angle - half).cos() - (angle + half).cos());
            if let Some(share) = law.share_per_steradian(angle) {
                assert!(
                    (share * steradians / ring - 1.0).abs() < 1e-6,
                    "{law:?} {deg}"
                );
            } else {
                assert!(ring <= 0.0, "{law:?} {deg}");
            }
        }
    }
    assert_eq!(DISC.share_per_steradian(1.0), None);
    let sphere: f64 = (0..BINS).map(|bin| CountedFor::Steradian.in_bin(bin)).sum();
    assert!((sphere - 4.0 * PI).abs() < 1e-12);
}

/// The fraction that a foil scatters by more than a given angle is n t σ, so it is proportional to
/// the thickness.
#[test]
fn a_foil_scatters_few_particles_backwards() {
    let back = foil(2.1e-7).share_beyond(PI / 2.0);
    let sigma = Rutherford::radium_c_on_gold()
        .cross_section_beyond(PI / 2.0)
        .unwrap();
    assert!((back / (5.9e28 * 2.1e-7 * sigma) - 1.0).abs() < 1e-12);
    // With d = 29.6 fm, 1 particle in 117,000 is scattered backwards.
    assert!((1.0 / back / 117_000.0 - 1.0).abs() < 0.01, "{back}");
    assert!((foil(4.2e-7).share_beyond(PI / 2.0) / back - 2.0).abs() < 1e-12);
    // Halving the energy doubles the distance d and quadruples the count.
    let slow = ScatteringLaw {
        target: METALS[0].foil(2.1e-7, 7.69 * MEV / 2.0),
        beam: Beam::Space,
    };
    assert!((slow.share_beyond(PI / 2.0) / back - 4.0).abs() < 1e-12);
}

#[test]
fn the_counts_of_1913_are_those_of_the_publication() {
    let angles = GEIGER_MARSDEN;
    assert_eq!(angles.len(), 11);
    assert!((angles[0].angle.to_degrees() - 150.0).abs() < 1e-12);
    assert!(angles.is_sorted_by(|one, next| one.angle > next.angle));
    assert!((angles[10].gold - 132_000.0).abs() < 1e-9);
    let sum: f64 = angles.iter().map(|angle| angle.silver).sum();
    assert!((sum - 134_294.9).abs() < 1e-6, "{sum}");
}

/// The counts for gold deviate by −15 % to +23 %, above the law at all angles below 40° and below
/// it at all others.
#[test]
fn the_counts_for_gold_follow_the_law_within_a_band() {
    let gold = Series::new(|angle| angle.gold);
    let (low, high) = gold.band();
    assert!((low + 0.15).abs() < 0.005 && (high - 0.23).abs() < 0.005);
    for point in &gold.points {
        assert_eq!(gold.excess(*point) > 0.0, point.0 < 40_f64.to_radians());
    }
    let mean: f64 = gold.points.iter().map(|point| gold.excess(*point)).sum();
    assert!(mean.abs() < 1e-12);
}

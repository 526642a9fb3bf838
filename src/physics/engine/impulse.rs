//! Impulses at several contacts at once.
//!
//! Simultaneous contacts of the same disc cannot be resolved one after another: the result would
//! depend on the order, and a symmetric break would become asymmetric. All contacts must reverse
//! their approach speeds at once, each with its own e, and no contact may pull. This is a linear
//! complementarity problem: Σ K J ≥ (1+e) w with J ≥ 0, and equality wherever J > 0. Energy never
//! increases: it changes by −½ Σ (1−e) J w.
//!
//! For linear complementarity problems, see R. W. Cottle, J.-S. Pang and R. E. Stone, *The Linear
//! Complementarity Problem* (1992); for simultaneous impacts without friction, see F. Pfeiffer and
//! C. Glocker, *Multibody Dynamics with Unilateral Contacts* (1996).

use glam::DVec2;

use super::body::Body;
use super::work::Work;

/// Two discs that are in contact and approach each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touch {
    pub(super) discs: [usize; 2],
    /// The unit vector from the first centre to the second.
    pub(super) normal: DVec2,
    /// The required change (1+e) w of the normal speed at this contact, in m/s.
    pub(super) wanted: f64,
}

/// The impulses of simultaneous contacts, one for each contact, in N s; `None` if finding them
/// requires too much work.
pub(super) fn simultaneous(
    touches: &[Touch],
    bodies: &[Body],
    work: &mut Work,
) -> Option<Vec<f64>> {
    match touches {
        [one, two] => Some(two_at_once(one, two, bodies).to_vec()),
        _ => many_at_once(touches, bodies, work),
    }
}

/// The change in the normal speed at `a` caused by a unit impulse at `b`.
fn coupling(a: &Touch, b: &Touch, bodies: &[Body]) -> f64 {
    let mut sum = 0.0;
    for (end_a, &disc_a) in a.discs.iter().enumerate() {
        for (end_b, &disc_b) in b.discs.iter().enumerate() {
            if disc_a == disc_b {
                let sign = if end_a == end_b { 1.0 } else { -1.0 };
                sum += sign / bodies[disc_a].mass;
            }
        }
    }
    sum * a.normal.dot(b.normal)
}

/// The change in the normal speed at a contact caused by a unit impulse at the same contact.
fn yielding(touch: &Touch, bodies: &[Body]) -> f64 {
    1.0 / bodies[touch.discs[0]].mass + 1.0 / bodies[touch.discs[1]].mass
}

/// Solves the problem for two contacts by Cramer's rule, which treats the two contacts identically,
/// bit for bit.
fn two_at_once(a: &Touch, b: &Touch, bodies: &[Body]) -> [f64; 2] {
    let (k_a, k_b) = (yielding(a, bodies), yielding(b, bodies));
    let k_ab = coupling(a, b, bodies);
    let determinant = k_a * k_b - k_ab * k_ab;
    let j_a = (a.wanted * k_b - k_ab * b.wanted) / determinant;
    let j_b = (b.wanted * k_a - k_ab * a.wanted) / determinant;
    if j_a < 0.0 {
        [0.0, b.wanted / k_b]
    } else if j_b < 0.0 {
        [a.wanted / k_a, 0.0]
    } else {
        [j_a, j_b]
    }
}

/// Solves the problem by projected Gauss–Seidel iteration: each sweep corrects one contact after
/// another.
fn many_at_once(touches: &[Touch], bodies: &[Body], work: &mut Work) -> Option<Vec<f64>> {
    let coupled = coupled(touches, bodies);
    work.add(touches.len() * touches.len());
    let a_sweep = coupled.iter().map(Vec::len).sum();
    let mut impulses = vec![0.0; touches.len()];
    let largest = touches.iter().map(|touch| touch.wanted).fold(0.0, f64::max);
    for _sweep in 0..10_000 {
        work.add(a_sweep);
        if work.is_too_much() {
            return None;
        }
        let mut change = 0.0_f64;
        for (t, touch) in touches.iter().enumerate() {
            let given: f64 = coupled[t].iter().map(|&(o, k)| k * impulses[o]).sum();
            let own = yielding(touch, bodies);
            let before = impulses[t];
            impulses[t] = (before + (touch.wanted - given) / own).max(0.0);
            change = change.max((impulses[t] - before).abs() * own);
        }
        if change <= 1e-15 * largest {
            break;
        }
    }
    Some(impulses)
}

/// For each contact, the contacts that share a disc with it, including the contact itself, and how
/// strongly their impulses change its normal speed.
fn coupled(touches: &[Touch], bodies: &[Body]) -> Vec<Vec<(usize, f64)>> {
    let shares = |a: &Touch, b: &Touch| a.discs.iter().any(|disc| b.discs.contains(disc));
    touches
        .iter()
        .map(|touch| {
            let others = touches.iter().enumerate();
            let others = others.filter(|(_, other)| shares(touch, other));
            others
                .map(|(o, other)| (o, coupling(touch, other, bodies)))
                .collect()
        })
        .collect()
}

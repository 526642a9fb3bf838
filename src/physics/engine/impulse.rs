//! Impulses at contacts: one by itself, or several at once on shared discs.
//!
//! One contact: the impulse along the line of impact that turns the approach speed
//! around and keeps the share e of it, J = (1+e) μ w.
//!
//! Several contacts at the very same instant cannot be taken one after another: the
//! order would decide, and a symmetric break would come out lopsided. Each wants its
//! own approach speed turned around with its own e, all at once, and none may pull:
//! a linear complementarity problem, Σ K J = (1+e) w with J ≥ 0. Energy never rises:
//! it changes by −½ Σ (1−e) J w.

use glam::DVec2;

/// Two discs in contact and approaching.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    pub(super) discs: [usize; 2],
    /// Unit vector from the first centre to the second.
    pub(super) normal: DVec2,
    /// Speed of approach along it, positive.
    pub(super) approach: f64,
    pub(super) restitution: f64,
}

impl Contact {
    /// What this contact wants: the change of its normal speed.
    fn wanted(&self) -> f64 {
        (1.0 + self.restitution) * self.approach
    }
}

/// The impulse of a contact by itself, in N s.
pub(super) fn single(contact: &Contact, inverse_mass: &[f64]) -> f64 {
    let [i, j] = contact.discs;
    contact.wanted() / (inverse_mass[i] + inverse_mass[j])
}

/// The impulses of contacts at the same instant, one a contact, in N s.
pub(super) fn simultaneous(contacts: &[Contact], inverse_mass: &[f64]) -> Vec<f64> {
    match contacts {
        [one, two] => two_at_once(one, two, inverse_mass).to_vec(),
        _ => many_at_once(contacts, inverse_mass),
    }
}

/// Change of the normal speed at `a` by a unit impulse at `b`.
fn coupling(a: &Contact, b: &Contact, inverse_mass: &[f64]) -> f64 {
    let mut sum = 0.0;
    for (end_a, &disc_a) in a.discs.iter().enumerate() {
        for (end_b, &disc_b) in b.discs.iter().enumerate() {
            if disc_a == disc_b {
                let sign = if end_a == end_b { 1.0 } else { -1.0 };
                sum += sign * inverse_mass[disc_a];
            }
        }
    }
    sum * a.normal.dot(b.normal)
}

/// Cramer's rule; it treats both alike to the last bit.
fn two_at_once(a: &Contact, b: &Contact, inverse_mass: &[f64]) -> [f64; 2] {
    let own = |c: &Contact| inverse_mass[c.discs[0]] + inverse_mass[c.discs[1]];
    let (k_a, k_b, k_ab) = (own(a), own(b), coupling(a, b, inverse_mass));
    let (w_a, w_b) = (a.wanted(), b.wanted());
    let determinant = k_a * k_b - k_ab * k_ab;
    let j_a = (w_a * k_b - k_ab * w_b) / determinant;
    let j_b = (w_b * k_a - k_ab * w_a) / determinant;
    if j_a < 0.0 {
        [0.0, w_b / k_b]
    } else if j_b < 0.0 {
        [w_a / k_a, 0.0]
    } else {
        [j_a, j_b]
    }
}

/// Projected Gauss–Seidel: sweep over the contacts, giving each what it lacks.
fn many_at_once(contacts: &[Contact], inverse_mass: &[f64]) -> Vec<f64> {
    let mut impulses = vec![0.0; contacts.len()];
    let largest = contacts.iter().map(Contact::wanted).fold(0.0, f64::max);
    for _sweep in 0..10_000 {
        let mut change = 0.0_f64;
        for (c, contact) in contacts.iter().enumerate() {
            let given: f64 = contacts
                .iter()
                .zip(&impulses)
                .map(|(other, j)| coupling(contact, other, inverse_mass) * j)
                .sum();
            let own = inverse_mass[contact.discs[0]] + inverse_mass[contact.discs[1]];
            let before = impulses[c];
            impulses[c] = (before + (contact.wanted() - given) / own).max(0.0);
            change = change.max((impulses[c] - before).abs() * own);
        }
        if change <= 1e-15 * largest {
            break;
        }
    }
    impulses
}

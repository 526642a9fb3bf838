//! The generators of questions, one file a family.
//!
//! A generator draws figures with the dice and makes a whole [`Question`] of them: the
//! text, the picture, the true answer, what each misconception would answer, and why the
//! truth is true. It need not care whether the answers can be told apart:
//! [`Family::ask`](super::Family::ask) draws again until they can.
//!
//! [`Question`]: super::Question

pub(super) mod both_moving;
pub(super) mod centre_of_mass;
mod choices;
pub(super) mod concept;
pub(super) mod energy_share;
pub(super) mod from_angle;
pub(super) mod from_offset;
pub(super) mod from_picture;
mod hit_kinds;
mod in_short;
pub(super) mod largest_deflection;
pub(super) mod make_it_so;
pub(super) mod restitution;
pub(super) mod rutherford;
pub(super) mod separation;
mod setting;
pub(super) mod slip_or_stick;
pub(super) mod speeds;
pub(super) mod unequal_masses;
pub(super) mod weigh;
pub mod where_to;

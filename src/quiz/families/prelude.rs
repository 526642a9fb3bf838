//! Imports used in nearly every family of calculated questions.

pub(super) use super::hit_draws::{
    ALL, EQUAL, HitDraws, NO_LOSS, UNEQUAL, direction_deg, drawn, here_e, in_degrees, in_short,
    off_centre, pair, place, read_off, read_off_angle, unmarked, within_readings,
};
pub(super) use super::outline::Outline;
pub(super) use crate::numbers::{
    Intermediate, bare_degrees, bare_millimetres, degrees, fixed, significant, true_minus,
};
pub(super) use crate::physics::units::{deg_from_rad, mm_from_m, rad_from_deg};
pub(super) use crate::physics::{Collision, Disc, ImpactPoint, RestingTarget};
pub(super) use crate::quiz::question::Misconception::*;
pub(super) use crate::quiz::question::{
    Dice, Difficulty, Hit, Illustration, Markings, Measure, Pieces, Question,
};

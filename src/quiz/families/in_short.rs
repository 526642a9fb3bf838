//! A hit in one sentence, where the question needs its room for something else.

use crate::physics::units::g_from_kg;
use crate::quiz::words::{bare_millimetres, degrees, significant};
use crate::quiz::{Hit, Placement};

/// The hit with its masses, its speed and where the two meet, without a word on loss.
pub(super) fn in_short(hit: &Hit) -> String {
    let place = match hit.given {
        Placement::Angle { .. } => format!(
            "the line of impact makes {} with its path",
            degrees(hit.alpha().abs())
        ),
        Placement::Offset { offset_mm } => format!(
            "the offset is {} mm, the two radii make {} mm together",
            bare_millimetres(offset_mm.abs()),
            bare_millimetres(hit.reach_mm())
        ),
    };
    format!("{} at {} m/s; {place}.", who(hit), significant(hit.speed))
}

/// What hits what: "A striker of 15.0 g hits a resting coin of 5.50 g".
pub(super) fn who(hit: &Hit) -> String {
    format!(
        "A striker of {} g hits a resting {} of {} g",
        significant(g_from_kg(hit.pieces.striker().mass)),
        hit.pieces.target_name(),
        significant(g_from_kg(hit.pieces.target().mass))
    )
}

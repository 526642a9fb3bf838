//! The picture of a collision, which explains the final directions of the discs. It is used in the
//! lab, in the quiz and for every enlarged impact.

mod after;
mod explain;
mod explanation_step;
mod layers;
mod moment;
mod names;
mod pencil;
mod playback;
mod reveal;
mod setup;
mod sighting;
mod sketch;
mod stage;
#[cfg(test)]
mod tests;
mod watch;

pub(crate) use crate::widgets::input::degrees;
pub(crate) use after::after_picture;
pub(crate) use explain::{explain, turns_a_second};
pub(crate) use layers::{Overlay, Overlays};
pub(crate) use names::VelocityNames;
pub(crate) use pencil::{protractor_picture, scale_picture};
pub(crate) use playback::{FRAME, HitPace};
pub(crate) use reveal::Reveal;
pub(crate) use setup::{
    CONTACT, Markings, aim_picture, contact_picture, drag_offset, point_at, setup_picture,
};
pub(crate) use sighting::{Sighting, SightingAction, write_observation};
pub(crate) use stage::HitLayout;
pub(crate) use watch::{Face, Watch, WatchAction};

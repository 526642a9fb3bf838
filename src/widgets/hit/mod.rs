//! The hit: two discs that meet off-centre, shown so that one sees why they part
//! as they do. The lab, the quiz and every zoomed-in impact show this one picture.

mod after;
mod layers;
mod moment;
mod pencil;
mod playback;
mod setup;
mod sketch;
mod stage;
mod telling;
#[cfg(test)]
mod tests;
mod watch;

pub use after::after_picture;
pub use layers::{Overlay, Overlays};
pub use pencil::{protractor_picture, scale_picture};
pub use playback::{FRAME, Playback};
pub use setup::{HitResponse, Markings, drag_offset, point_at, setup_picture};
pub use sketch::WantedWay;
pub use stage::{HitLayout, degrees, side};
pub use telling::Telling;
pub use watch::{Face, Watch, WatchAction};

//! The hit: two discs that meet off-centre, shown so that one sees why they part
//! as they do. The lab, the quiz and every zoomed-in impact show this one picture.

mod after;
mod angles;
mod arrows;
mod inset;
mod labels;
mod layers;
mod mark;
mod picture;
mod playback;
mod setup;
mod stage;
mod telling;
mod watch;

pub use after::draw_after;
pub use layers::{Layer, Layers};
pub use mark::Mark;
pub use playback::{FRAME, Playback};
pub use setup::{Markings, drag_offset, draw_aim, draw_setup, draw_setup_of, point_at};
pub use stage::{Stage, degrees, side};
pub use telling::Telling;
pub use watch::{Face, Watch, WatchAction};

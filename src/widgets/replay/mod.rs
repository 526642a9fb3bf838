//! A recorded shot played back on the board: its clock, and the impacts in it that can
//! be looked at one by one.

mod clock;
mod impact;
mod player;

pub use clock::{ShotClock, WatchRate};
pub use impact::{Impact, impacts};
pub use player::{ShotAction, ShotPlayer};

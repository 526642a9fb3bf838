//! A recorded shot played back on the board: its clock, and the impacts in it that can
//! be looked at one by one.

mod clock;
mod impact;

pub use clock::Clock;
pub use impact::{Impact, impacts};

//! A collision by the names that files use: its fields, and the numbers that texts ask
//! for. `docs/lessons.md` lists both.

mod constant;
mod quantity;
mod shot;

pub use constant::Constant;
pub use quantity::Quantity;
pub use shot::Shot;

//! The numbers that texts ask for by name. `docs/lessons.md` lists them.

mod constant;
mod quantity;

pub use constant::Constant;
pub use quantity::Quantity;

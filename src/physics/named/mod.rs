//! The numbers that lessons and other texts refer to by name. `docs/lessons.md` lists them.

mod constant;
mod quantity;

pub(crate) use constant::Constant;
pub(crate) use quantity::Quantity;

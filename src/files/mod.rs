//! What all files have in common that come from outside: how they are read, and how
//! one says what is wrong with them.

mod fault;
mod list;
mod read;
mod source;
mod tables;

pub use fault::{Fault, harmless};
pub use list::{List, embedded, list};
pub use read::{LARGEST, read, read_stdin};
pub use source::Source;
pub use tables::newer;

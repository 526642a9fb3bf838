//! What all files have in common: how those from outside are read, how one says what is
//! wrong with them, and how whole ones are written.

mod draft;
mod fault;
mod list;
mod put;
mod read;
mod source;

pub use draft::{Draft, UNFINISHED, settle};
pub use fault::{Fault, harmless};
pub use list::{List, embedded, list};
pub use put::{Document, Existing, Unwritten, put};
pub use read::{LARGEST, read, read_stdin};
pub use source::Source;

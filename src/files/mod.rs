//! What all files have in common: how those from outside are read, how one says what is
//! wrong with them, and how whole ones are written.

mod draft;
mod error;
mod letters;
mod list;
mod put;
mod read;
mod source;
mod tables;

pub use draft::{UNFINISHED, UnplacedFile, fsync_dir};
pub use error::{FileError, escape_control, escape_control_lines};
pub use letters::{is_invisible, tidy_name};
pub use list::{List, embedded, list, not_a_file};
pub use put::{Document, Existing, Unwritten, put};
pub use read::{LARGEST, read, read_stdin};
pub use source::{BYTE_ORDER_MARK, Source};
pub use tables::newer;

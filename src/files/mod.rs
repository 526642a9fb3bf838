//! What all files have in common: how those from outside are read, how one says what is
//! wrong with them, and how whole ones are written.

mod draft;
mod error;
mod expectation;
mod fields;
mod letters;
mod list;
mod number;
mod put;
mod read;
mod source;

pub use draft::{UNFINISHED, UnplacedFile, fsync_dir};
pub use error::{FileError, FileErrors, escape_control, escape_control_lines};
pub use fields::{Fields, newer};
pub(crate) use fields::{all, is_id};
pub use letters::{NO_NAME, is_blank_name, is_invisible, tidy_name};
pub use list::{List, embedded, list, not_a_file};
pub use number::{NumberSpec, Range};
pub use put::{Document, Existing, Unwritten, put};
pub use read::{LARGEST, read, read_stdin};
pub use source::{BYTE_ORDER_MARK, Source};

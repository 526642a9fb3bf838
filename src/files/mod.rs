//! Reads external files, reports their errors, and writes files atomically.

mod csv_table;
mod draft;
mod error;
mod expectation;
mod fields;
mod json;
mod letters;
mod library;
mod lines;
mod list;
mod number;
mod put;
mod read;
mod source;

pub use csv_table::csv_table;
pub(crate) use draft::{UNFINISHED, UnplacedFile, fsync_dir};
pub use error::{FileError, LONGEST_QUOTE, escape_control, escape_control_lines, quoted};
pub(crate) use error::{FileErrors, brief};
pub(crate) use fields::Fields;
pub use fields::newer;
pub(crate) use fields::{all, is_id};
pub(crate) use json::write_json;
pub(crate) use letters::{NO_NAME, is_blank_name};
pub use letters::{is_invisible, tidy_name};
pub(crate) use letters::{one_line, percent_encoded, short_name};
pub use library::FileLibrary;
pub use lines::read_line;
pub(crate) use list::not_a_file;
pub use list::{List, embedded, list};
pub(crate) use number::{NumberSpec, Range};
pub use put::{Document, put};
pub(crate) use put::{Existing, Unwritten};
pub use read::read;
pub(crate) use read::{LARGEST, STDIN, read_given};
pub(crate) use source::{BYTE_ORDER_MARK, Source};

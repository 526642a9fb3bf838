//! What all files have in common: how those from outside are read, how one says what is
//! wrong with them, and how whole ones are written.

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
pub use draft::{UNFINISHED, UnplacedFile, fsync_dir};
pub use error::{
    FileError, FileErrors, LONGEST_QUOTE, brief, escape_control, escape_control_lines, quoted,
};
pub use fields::{Fields, newer};
pub(crate) use fields::{all, is_id};
pub use json::write_json;
pub use letters::{NO_NAME, is_blank_name, is_invisible, tidy_name};
pub(crate) use letters::{one_line, percent_encoded, short_name};
pub use library::FileLibrary;
pub use lines::read_line;
pub use list::{List, embedded, list, not_a_file};
pub use number::{NumberSpec, Range};
pub use put::{Document, Existing, Unwritten, put};
pub use read::{LARGEST, read, read_stdin};
pub use source::{BYTE_ORDER_MARK, Source};

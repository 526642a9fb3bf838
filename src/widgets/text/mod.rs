//! Letters in cells: character sets, line breaking, formulas, large type and bars, and a record of
//! the text (`sheet`) for shells that can show more than cells.

pub(crate) mod areas;
pub mod bar;
pub(crate) mod big;
pub(crate) mod blocks;
pub mod cells;
mod charset;
pub(crate) mod flow;
pub mod formula;
pub mod keys;
mod lines;
mod look;
mod scroll;
pub(crate) mod sheet;
pub(crate) mod signs;
mod terms;
mod wrap;

pub use areas::PictureSizes;
pub(crate) use areas::Room;
pub use blocks::Blocks;
pub use charset::Charset;
pub(crate) use lines::Lines;
pub use look::Look;
pub(crate) use scroll::{PAGE_ROWS, hint_below};
pub use sheet::{Item, Section, Sheet, SheetKind, Words, recorded};
pub use terms::held;
pub(crate) use terms::unbroken;
pub(crate) use wrap::sentence_ends;
pub(crate) use wrap::{ago, clipped};
pub use wrap::{equation, width, wrap};

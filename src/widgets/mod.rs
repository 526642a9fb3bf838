//! Everything that is drawn: the layer between numbers and the cells of the screen.
//!
//! Widgets know how to draw, but do not know the screens or the app. Two of the player's choices
//! affect all of them: the [`Charset`] (which glyphs) and the [`Theme`] (which colours).
//!
//! ```text
//!    answer   a question's picture, and the answer being entered
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    replay   the replay of a shot on the board, and its impacts one by one, predicted or watched
//!    curves   the outcome of a collision at every impact angle, with the collision below
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    hit      the picture of a collision, with its clock, layers and frames
//!    board    a picture of the board
//!    measured a picture of a measured collision
//!    tracks   a picture of paths past a nucleus
//!    plot     a picture of curves, bars and points over two axes
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    svg      pictures and screens as vectors
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    panels   frames, and the facts about a collision
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    input    keys as data, and widgets for them: numbers, rays, lists, forms, text
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    panel    the text beside a picture, as a list of blocks
//!    ink      pictures drawn into cells
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    picture  marks in metres, and their positions on the screen
//!    text     letters in cells: character sets, rows, formulas, large type
//! ──────────────────────────────────────────────────────────────────────────────────────
//!    theme    roles and their colours
//! ```

mod answer;
pub(crate) mod board;
pub(crate) mod curves;
pub(crate) mod hit;
pub(crate) mod ink;
pub mod input;
mod measured;
pub(crate) mod panel;
pub(crate) mod panels;
pub mod picture;
pub(crate) mod plot;
pub(crate) mod replay;
pub(crate) mod svg;
pub mod text;
pub(crate) mod theme;
pub(crate) mod tracks;

pub use answer::draw_question;
pub(crate) use answer::{AnswerAction, AnswerInput, question_picture};
pub(crate) use answer::{Asking, AskingAction, lettered, write_beside_truth};
pub use ink::gallery::gather;
pub(crate) use input::{NumberEntry, NumberInput, RayInput, brief};
pub use input::{Outcome, shown};
pub(crate) use measured::{measured_picture, measured_rows, measured_words, points_picture};
pub use panels::SplitLayout;
pub use svg::painted::{PaintedCell, PaintedPicture, glyph_shape, inks, painted};
pub use text::bar;
pub use text::{
    Blocks, Charset, Item, Look, PictureSizes, Section, Sheet, SheetKind, Words, cells, formula,
    keys, recorded,
};
pub(crate) use text::{Lines, PAGE_ROWS, Room, areas, big, flow, sheet, signs};
pub use theme::{Depth, Palette, Role, Theme};

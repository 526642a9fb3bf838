//! Documents to print or hand in.
//!
//! A document is written as HTML by [`html_page()`] (self-contained, for A4 or US letter paper,
//! with nothing to load or run) or as [`Markdown`] with its pictures in files beside it. The
//! pictures look as they do on the screen, but are drawn as vectors, each as an `Svg`. They work in
//! black and white too: every mark with a meaning has a name, a dash pattern or a width in addition
//! to its colour.
//!
//! External text is safe everywhere: HTML is written with [`maud::html!`], which escapes its
//! input, and [`Markdown`] and pictures do the same. [`clean()`] deals with what escaping cannot
//! fix: it removes control characters and direction marks, and truncates very long names.
//!
//! ```
//! use carrom::paper::{Markdown, Paper, clean, html_page};
//! use maud::html;
//!
//! let name = clean("Ada <3", 40);
//! let page = html_page("A sheet", "", Paper::A4, [html! { h1 { (name) } }]);
//! assert!(page.contains("<h1>Ada &lt;3</h1>"));
//!
//! let mut text = Markdown::new();
//! text.heading(1, &name).picture("A stroke", "sheet-pictures/stroke.svg");
//! assert!(text.text().starts_with("# Ada \\<3"));
//! ```

pub mod class_report;
mod clean;
pub mod gradebook;
pub(crate) mod guide;
mod markdown;
mod measured;
mod page;
pub mod report;
pub mod worksheet;

pub use clean::clean;
pub use markdown::Markdown;
pub use measured::measured_html;
pub use page::{Paper, html_page};

/// The attribute by which a page names each class that it is about, so that `carrom class --forget`
/// finds it.
pub(crate) const CLASS_MARK: &str = "data-class";

use crate::widgets::picture::Picture;
use crate::widgets::svg::Svg;
use crate::widgets::{Blocks, Charset, Depth, Look, Palette, Theme};

/// The look of pictures on paper.
const LOOK: Look = Look {
    charset: Charset::Unicode,
    blocks: Blocks::Quadrants,
    theme: Theme::new(Palette::Light, Depth::True),
};
/// The scale of pictures: letters are 10.5 CSS pixels (about 8 points) high.
const SCALE: f64 = 0.75;

/// A picture for paper. `words` is its text alternative.
fn svg(words: &str, picture: &Picture) -> Svg {
    Svg::new(words, picture, &LOOK, SCALE)
}

//! Documents for paper: what is printed, handed in or put on a wall.
//!
//! A document is written as HTML on a [`Page`] (self-contained, A4, nothing is loaded
//! and nothing runs) or as [`Markdown`] with its pictures in files beside it. Pictures
//! are vectors with true lines and text, an [`Svg`] each; a [`Chart`] is a plot,
//! [`hit_picture`], [`seen_picture`] and [`aim_picture`] draw a hit, [`tracks_picture`]
//! two particles past a nucleus. All of them are meant for black and white too: an
//! [`Ink`] is a strength before it is a colour.
//!
//! Text from outside is safe everywhere: HTML is written with [`maud::html!`], which
//! escapes what it is given, Markdown and pictures escape by themselves. What no
//! escaping mends (control characters, marks that turn the text beside them round, names
//! without end) is taken out by [`clean()`].
//!
//! ```
//! use carrom::paper::{Ink, Markdown, Page, Stroke, Svg, clean};
//! use glam::dvec2;
//! use maud::html;
//!
//! let mut picture = Svg::new("A stroke from corner to corner", 60.0, 30.0);
//! picture.line(dvec2(0.0, 0.0), dvec2(60.0, 30.0), Stroke::new(Ink::Accent));
//!
//! let name = clean("Ada <3", 40);
//! let page = Page::new("A sheet").sheet(html! { h1 { (name) } (picture) });
//! assert!(page.html().contains("<h1>Ada &lt;3</h1>"));
//!
//! let mut text = Markdown::new();
//! text.heading(1, &name).picture("A stroke", "sheet-pictures/stroke.svg");
//! assert!(text.text().starts_with("# Ada \\<3"));
//! ```

mod chart;
mod clean;
mod hit;
mod markdown;
mod page;
pub mod report;
mod svg;
mod tracks;
pub mod worksheet;

pub use chart::{Chart, Mark};
pub use clean::clean;
pub use hit::{After, Shown, aim_picture, hit_picture, seen_picture};
pub use markdown::Markdown;
pub use page::Page;
pub use svg::{Anchor, Ink, Stroke, Svg};
pub use tracks::tracks_picture;

//! The outer structure of an HTML document.

use maud::{DOCTYPE, Markup, PreEscaped, html};
use strum::{EnumString, VariantNames};

use super::clean;

/// The common style of all documents.
const STYLE: &str = include_str!("page.css");
/// The maximum number of columns in a title; windows and file names do not show more.
const TITLE: usize = 120;
/// With this policy nothing is loaded and nothing runs, even if the escaping fails.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

/// The size of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, EnumString, VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum Paper {
    /// 210 mm × 297 mm.
    #[default]
    A4,
    /// 8.5 in × 11 in.
    Letter,
}

impl Paper {
    /// Additional rules for this paper; the common rules are for A4.
    const fn style(self) -> &'static str {
        match self {
            Self::A4 => "",
            Self::Letter => {
                "@page { size: letter } @media screen { .sheet { width: 8.5in; min-height: 11in } }"
            }
        }
    }
}

/// An HTML document with these sheets of paper.
///
/// It is self-contained: it includes the style and the pictures. On a screen the sheets follow one
/// below the other; in print each begins on a new page. `h1` to `h3`, `p`, `table`, `figure` and
/// `svg` are styled, and `.dim` is secondary text. The additional `style` is inserted unchanged; it
/// can use the colours `--text`, `--dim`, `--faint`, `--wash` and `--accent`. The window shows the
/// title, which is also the suggested file name when the document is printed to a file.
pub fn html_page(
    title: &str,
    style: &str,
    paper: Paper,
    sheets: impl IntoIterator<Item = Markup>,
) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="generator" content=(concat!("carrom ", env!("CARGO_PKG_VERSION")));
                title { (clean(title, TITLE)) }
                style { (PreEscaped(STYLE)) (PreEscaped(style)) (PreEscaped(paper.style())) }
            }
            body {
                @for sheet in sheets {
                    section.sheet { (sheet) }
                }
            }
        }
    };
    page.into_string() + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_is_plain_text() {
        let page = html_page("</title><script>alert(1)</script>", "", Paper::A4, []);
        assert!(page.starts_with("<!DOCTYPE html><html lang=\"en\">"));
        assert!(page.contains("<title>&lt;/title&gt;&lt;script&gt;"));
        assert!(!page.contains("<script"));
    }

    #[test]
    fn sheets_are_in_order() {
        let sheets = [html! { "first" }, html! { "second" }];
        let page = html_page("two", ".x { color: red }", Paper::A4, sheets);
        assert_eq!(page.matches("class=\"sheet\"").count(), 2);
        assert!(page.find("first") < page.find("second"));
        assert!(page.contains(".x { color: red }</style>"));
    }
}

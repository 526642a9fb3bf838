//! The frame of an HTML document.

use maud::{DOCTYPE, Markup, PreEscaped, html};
use strum::{EnumString, VariantNames};

use super::clean;

/// The common style of all documents.
const STYLE: &str = include_str!("page.css");
/// Columns of a title: window and file names are cut there anyway.
const TITLE: usize = 120;
/// Nothing is loaded and nothing runs, even if something gets past the escaping.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

/// The paper that is printed on.
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

/// An HTML document of these sheets of paper.
///
/// It is self-contained: style and pictures are in it. On a screen the sheets lie below
/// one another; printed, each begins on a new page. `h1` to `h3`, `p`, `table`, `figure`
/// and `svg` are styled, `.dim` is text of second rank, and `--text`, `--dim`,
/// `--faint`, `--wash` and `--accent` are the colours for a `style` of one's own, which is
/// written into the document as it is. The title is that of the window and becomes the
/// name of the file when it is printed to one.
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
    fn a_title_is_text_and_nothing_else() {
        let page = html_page("</title><script>alert(1)</script>", "", Paper::A4, []);
        assert!(page.starts_with("<!DOCTYPE html><html lang=\"en\">"));
        assert!(page.contains("<title>&lt;/title&gt;&lt;script&gt;"));
        assert!(!page.contains("<script"));
    }

    #[test]
    fn sheets_come_in_order() {
        let sheets = [html! { "first" }, html! { "second" }];
        let page = html_page("two", ".x { color: red }", Paper::A4, sheets);
        assert_eq!(page.matches("class=\"sheet\"").count(), 2);
        assert!(page.find("first") < page.find("second"));
        assert!(page.contains(".x { color: red }</style>"));
    }
}

//! The built-in guides for teachers, and their conversion from Markdown into pages for a browser.

use maud::{PreEscaped, html};
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use super::{Paper, html_page};

const STYLE: &str = include_str!("guide.css");

/// A guide, with its name on the command line.
#[derive(Debug)]
pub(crate) struct Guide {
    pub(crate) name: &'static str,
    /// A few words about its contents, for a list of guides.
    pub(crate) about: &'static str,
    pub(crate) markdown: &'static str,
}

/// The guide in the file of this name in `docs`.
macro_rules! guide {
    ($name:literal, $about:literal) => {
        Guide {
            name: $name,
            about: $about,
            markdown: include_str!(concat!("../../docs/", $name, ".md")),
        }
    };
}

/// All guides, in the order in which a teacher needs them.
pub(crate) static GUIDES: [Guide; 16] = [
    guide!("start", "the first ten minutes"),
    guide!("class", "a round with a class"),
    guide!("privacy", "what is kept, who sees it, how to delete it"),
    guide!("lesson-plans", "three lessons of 45 minutes"),
    guide!("worksheets", "a round on paper"),
    guide!("sets", "choosing the questions"),
    guide!("judging", "how answers are judged"),
    guide!("model", "what is simulated, and what is left out"),
    guide!("measuring", "a filmed collision, measured"),
    guide!("glossary", "the terms of mechanics"),
    guide!("rules", "the rules of carrom, with the numbers of the laws"),
    Guide {
        name: "levels",
        about: "how to write a level",
        markdown: include_str!("../../levels/README.md"),
    },
    guide!("lessons", "how to write a chapter"),
    guide!("concepts", "how to write questions in words"),
    guide!("solve", "the JSON of carrom solve"),
    guide!("accessibility", "what is accessible, and what is not yet"),
];

/// A built-in guide as an HTML document. A link to another guide (`class.md`) leads to that guide's
/// page in the same folder (`class.html`); any other link becomes plain text.
pub(crate) fn guide_page(markdown: &str) -> String {
    // The first line is the title, in which code may be marked.
    let title = markdown.lines().next().unwrap_or_default();
    let title = title.trim_start_matches("# ").replace('`', "");
    let mut body = String::new();
    let mut is_linked = false;
    let events = Parser::new_ext(markdown, Options::ENABLE_TABLES);
    let linked = events.filter_map(|event| match event {
        Event::Start(Tag::Link { .. }) | Event::End(TagEnd::Link) => {
            let event = page_link(event, is_linked);
            is_linked = matches!(event, Some(Event::Start(_)));
            event
        }
        event => Some(event),
    });
    pulldown_cmark::html::push_html(&mut body, linked);
    let sheet = html! { div.guide { (PreEscaped(body)) } };
    html_page(&title, STYLE, Paper::A4, [sheet])
}

/// The start or the end of a link to another guide's page; `None` for any other link.
fn page_link(mut event: Event<'_>, is_linked: bool) -> Option<Event<'_>> {
    let is_page = match &mut event {
        Event::Start(Tag::Link { dest_url, .. }) => {
            let page = dest_url.strip_suffix(".md")?;
            let is_beside = !page.contains('/');
            *dest_url = format!("{page}.html").into();
            is_beside
        }
        _ => is_linked,
    };
    is_page.then_some(event)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_lead_to_other_guides_and_nowhere_else() {
        let page = guide_page("# One\n\n[two](two.md), [three](https://far.away), [a](b/c.md)");
        assert!(page.contains("<title>One</title>"), "{page}");
        assert!(
            page.contains("<a href=\"two.html\">two</a>, three, a"),
            "{page}"
        );
        assert_eq!(page.matches("<a").count(), 1);
    }
}

//! Converts a guide from Markdown into a page for a browser.

use maud::{PreEscaped, html};
use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd};

use super::{Paper, html_page};

const STYLE: &str = include_str!("guide.css");

/// A built-in guide as an HTML document. A link to another guide (`class.md`) leads to that guide's
/// page in the same folder (`class.html`); any other link becomes plain text.
pub(crate) fn guide_page(markdown: &str) -> String {
    let events: Vec<_> = Parser::new_ext(markdown, Options::ENABLE_TABLES).collect();
    let mut body = String::new();
    let mut is_linked = false;
    let linked = events.iter().cloned().filter_map(|event| match event {
        Event::Start(Tag::Link { .. }) | Event::End(TagEnd::Link) => {
            let event = page_link(event, is_linked);
            is_linked = matches!(event, Some(Event::Start(_)));
            event
        }
        event => Some(event),
    });
    pulldown_cmark::html::push_html(&mut body, linked);
    let sheet = html! { div.guide { (PreEscaped(body)) } };
    html_page(&title(&events), STYLE, Paper::A4, [sheet])
}

/// The start or the end of a link to another guide's page; `None` for any other link.
fn page_link(event: Event<'_>, is_linked: bool) -> Option<Event<'_>> {
    match event {
        Event::Start(Tag::Link {
            link_type,
            dest_url,
            title,
            id,
        }) => {
            let page = dest_url
                .strip_suffix(".md")
                .filter(|name| !name.contains('/'))?;
            let dest_url = format!("{page}.html").into();
            Some(Event::Start(Tag::Link {
                link_type,
                dest_url,
                title,
                id,
            }))
        }
        end => is_linked.then_some(end),
    }
}

/// The text of the first heading.
fn title(events: &[Event]) -> String {
    let heading = events
        .iter()
        .skip_while(|event| {
            !matches!(
                event,
                Event::Start(Tag::Heading {
                    level: HeadingLevel::H1,
                    ..
                })
            )
        })
        .take_while(|event| !matches!(event, Event::End(TagEnd::Heading(_))));
    let words = heading.filter_map(|event| match event {
        Event::Text(text) | Event::Code(text) => Some(text.as_ref()),
        _ => None,
    });
    words.collect()
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

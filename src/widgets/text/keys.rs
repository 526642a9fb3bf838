//! The bottom line of the screen, which names the keys.

use ratatui::text::{Line, Span};
use unicode_width::UnicodeWidthStr;

use crate::widgets::{Charset, Look, Role};

/// The keys of a screen in one line: each hint is a key and its label. Hints that do not fit into
/// `width` are left out completely, so the most useful hints should come first; the last hint
/// (usually help) is always kept if there is room for any hint.
///
/// ```
/// use carrom::widgets::{Look, keys::key_line};
/// let hints = [("Space", "again"), (". ,", "step"), ("?", "help")];
/// let line = key_line(&hints, 80, &Look::default());
/// assert_eq!(line.to_string(), " Space again  . , step  ? help");
/// ```
pub fn key_line(hints: &[(impl AsRef<str>, &str)], width: u16, look: &Look) -> Line<'static> {
    let (charset, theme) = (look.charset, look.theme);
    let written: Vec<(String, String)> = hints
        .iter()
        .map(|(key, does)| {
            let key = match (charset, key.as_ref()) {
                // The two arrows are written as one character each, because "->" would look like
                // two keys.
                (Charset::Ascii, "←→") => "<>".to_owned(),
                (Charset::Ascii, "↑↓") => "^v".to_owned(),
                (_, key) => charset.text(key).into_owned(),
            };
            (key, charset.text(does).into_owned())
        })
        .collect();
    let size = |(key, does): &(String, String)| key.width() + does.width() + 3;
    let mut room = usize::from(width);
    let mut line = Line::default();
    let last = written.last().map_or(0, size);
    let count = written.len();
    for (i, hint) in written.into_iter().enumerate() {
        let kept_for_last = if i + 1 < count { last } else { 0 };
        let needed = size(&hint);
        // There is one space before the first hint and two spaces before every other hint.
        if needed.saturating_sub(1) + kept_for_last > room {
            continue;
        }
        room = room.saturating_sub(needed);
        let gap = if line.spans.is_empty() { " " } else { "  " };
        let (key, does) = hint;
        line.push_span(Span::raw(gap));
        line.push_span(Span::styled(key, theme.style(Role::Key)));
        line.push_span(Span::raw(" "));
        line.push_span(Span::styled(does, theme.style(Role::Dim)));
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hints_are_complete_or_absent_and_help_stays() {
        let hints = [("Space", "shoot"), ("←→", "offset"), ("?", "help")];
        for charset in [Charset::Ascii, Charset::Unicode] {
            for width in 0..60u16 {
                let look = Look {
                    charset,
                    ..Look::default()
                };
                let line = key_line(&hints, width, &look);
                assert!(line.width() <= usize::from(width), "{width}");
                let text = line.to_string();
                for (key, does) in [("Space", "shoot"), ("?", "help")] {
                    assert_eq!(text.contains(key), text.contains(&format!("{key} {does}")));
                }
                assert_eq!(text.contains("? help"), width >= 7, "{width} {text}");
            }
        }
    }
}

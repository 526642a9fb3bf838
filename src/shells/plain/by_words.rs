//! Removes the parts of a text that are only for users of a keyboard, a mouse or a screen.

/// The mark before the name of a key in a text that is not yet in spoken form.
pub(super) const KEY: char = '\u{e0f0}';

/// Beginnings that are left out of sentences, because only sighted users need them; the rest of the
/// sentence is kept.
const LEADS: [&str; 4] = [
    "Drag the point: ",
    "Now turn the rays: ",
    "Look at the picture: ",
    "In the picture, find where the two will touch, and the line of impact: ",
];

/// A text without the sentences that are only for users of a keyboard, a mouse or a screen.
pub(super) fn by_words(text: &str) -> String {
    let mut kept: Vec<String> = Vec::new();
    for sentence in sentences(text) {
        let lead = LEADS.iter().find_map(|lead| sentence.strip_prefix(lead));
        let said = lead.map_or_else(|| sentence.to_owned(), crate::numbers::capital);
        if !said.contains(KEY) && !is_for_hands(&said) {
            kept.push(said);
        }
    }
    kept.join(" ")
}

/// The starts of sentences about the keyboard, the mouse or the screen.
const FOR_HANDS: [&str; 6] = [
    "Drag ",
    "Press ",
    "Click ",
    "Watch ",
    "Turn the ray",
    "With the mouse",
];

/// Other phrases in sentences about the keyboard or the mouse.
const BY_HAND: [&str; 9] = [
    "Enter",
    "Esc ",
    "Esc,",
    "Space",
    "Tab ",
    "with the arrows",
    "the mouse",
    "the wheel",
    "click",
];

/// Whether a sentence is only for users of a keyboard, a mouse or a screen.
fn is_for_hands(sentence: &str) -> bool {
    FOR_HANDS.iter().any(|it| sentence.starts_with(it))
        // A sentence such as "u switches it", in which the name of the key is a single character.
        || sentence.get(1..).is_some_and(|it| it.starts_with(" switches it"))
        || BY_HAND.iter().any(|it| sentence.contains(it))
}

/// Splits a text after each sentence.
fn sentences(text: &str) -> Vec<&str> {
    let mut cut = Vec::new();
    let mut begin = 0;
    for (at, _) in text.match_indices([' ', '\n']) {
        if text[begin..at].ends_with(['.', '?', '!']) {
            cut.push(&text[begin..at]);
            begin = at + 1;
        }
    }
    cut.push(&text[begin..]);
    cut
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mouse_and_key_instructions_are_left_out() {
        for (text, read) in [
            ("Drag the point along it.", ""),
            (
                "Drag the point once more. At 30° it is 4.",
                "At 30° it is 4.",
            ),
            (
                "Drag the point: for 20 g it goes on.",
                "For 20 g it goes on.",
            ),
            (
                "No figures. Look at the picture: where will they go?",
                "No figures. Where will they go?",
            ),
            (
                "v₁ = 3.46 m/s. So it is. Yes?",
                "v₁ = 3.46 m/s. So it is. Yes?",
            ),
            ("One", "One"),
            ("", ""),
        ] {
            assert_eq!(by_words(text), read, "{text}");
        }
        assert_eq!(
            by_words(&format!("First. Press {KEY}o to go. Last.")),
            "First. Last."
        );
    }
}

//! Decides which characters in external text are visible and which are unsafe.

use unicode_segmentation::UnicodeSegmentation;
use unicode_width::UnicodeWidthChar;

/// The maximum number of zero-width marks, such as accents, on one letter of a name.
const MOST_UPON: usize = 2;

/// Whether a character is invisible: a control character, a mark that changes the direction of the
/// following text, a zero-width space, or a noncharacter such as U+FFFE.
pub fn is_invisible(letter: char) -> bool {
    letter.is_control()
        || matches!(letter,
            '\u{00ad}' | '\u{061c}' | '\u{180e}' | '\u{200b}' | '\u{200e}' | '\u{200f}'
            | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}'
            | '\u{fff9}'..='\u{fffb}')
        || u32::from(letter) & 0xfffe == 0xfffe
}

/// Whether a character is visible only as part of a sequence.
pub(super) fn hides(letter: char) -> bool {
    matches!(letter, '\u{200d}' | '\u{e0000}'..='\u{e007f}')
}

/// Whether a cluster is an emoji, even one made of several characters: a family, or the flag of a
/// region, which is encoded in tag characters.
pub(super) fn is_picture(letter: &str) -> bool {
    const FLAG: char = '\u{1f3f4}';
    const LAST_TAG: char = '\u{e007f}';
    let is_emoji = |c: char| matches!(c, '\u{200d}' | '\u{fe0f}' | '\u{2190}'..='\u{2bff}' | '\u{1f000}'..='\u{1faff}');
    let is_tag = |c: char| ('\u{e0020}'..='\u{e007e}').contains(&c);
    let tags = letter.strip_prefix(FLAG);
    match tags.and_then(|rest| rest.strip_suffix(LAST_TAG)) {
        Some(tags) => tags.chars().all(is_tag),
        None => {
            letter.chars().all(is_emoji)
                && !letter.starts_with('\u{200d}')
                && !letter.ends_with('\u{200d}')
        }
    }
}

/// Text on one line, with a single space between words.
pub(crate) fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A path for use in a URI: special characters are percent-encoded.
pub(crate) fn percent_encoded(path: &[u8]) -> String {
    let plain = |byte: &u8| byte.is_ascii_alphanumeric() || b"-._/".contains(byte);
    let written = path.iter().map(|byte| match plain(byte) {
        true => char::from(*byte).to_string(),
        false => format!("%{byte:02X}"),
    });
    written.collect()
}

/// The name shown for a stored name without a visible letter.
pub(crate) const NO_NAME: &str = "No name";

/// Whether a character is blank although Unicode classifies it as a letter, a symbol or an accent:
/// a filler, an empty pattern or an unwritten vowel.
fn is_blank(letter: char) -> bool {
    matches!(letter,
        '\u{034f}' | '\u{115f}' | '\u{1160}' | '\u{17b4}' | '\u{17b5}' | '\u{180b}'..='\u{180f}'
        | '\u{2800}' | '\u{3164}' | '\u{ffa0}' | '\u{16fe4}' | '\u{1bca0}'..='\u{1bca3}'
        | '\u{1d159}' | '\u{1d173}'..='\u{1d17a}')
}

/// Whether a name contains a blank letter and no visible one. Earlier versions accepted such names,
/// so files may contain them.
pub(crate) fn is_blank_name(name: &str) -> bool {
    name.chars().any(is_blank) && tidy_name(name).is_empty()
}

/// A person's name as it is shown and stored: its letters, with one space between words and at most
/// a few accents per letter. The result is empty if no letter is visible.
pub fn tidy_name(name: &str) -> String {
    let mut tidy = String::new();
    let mut upon = 0;
    for letter in name.chars() {
        if letter.is_whitespace() {
            if !tidy.is_empty() && !tidy.ends_with(' ') {
                tidy.push(' ');
            }
            continue;
        }
        let bare = letter.width().unwrap_or(0) == 0;
        upon = if bare { upon + 1 } else { 0 };
        let fits = !bare || (upon <= MOST_UPON && !tidy.is_empty() && !tidy.ends_with(' '));
        if fits && !is_invisible(letter) && !joins(letter) {
            tidy.push(letter);
        }
    }
    let is_visible =
        |letter: char| letter != ' ' && letter.width().unwrap_or(0) > 0 && !is_blank(letter);
    if !tidy.contains(is_visible) {
        return String::new();
    }
    tidy.truncate(tidy.trim_end().len());
    tidy
}

/// Like [`tidy_name`], but with at most `letters` letters. A letter may consist of several
/// characters.
pub(crate) fn short_name(name: &str, letters: usize) -> String {
    const BYTES: usize = 8;
    let name = tidy_name(name);
    let mut bytes = 0;
    let letters = name.graphemes(true).take(letters).take_while(|letter| {
        bytes += letter.len();
        bytes <= BYTES * letters
    });
    letters.collect::<String>().trim_end().to_owned()
}

/// Whether a character only determines how its neighbours are joined.
fn joins(letter: char) -> bool {
    matches!(letter, '\u{200c}' | '\u{200d}' | '\u{fe00}'..='\u{fe0f}'
        | '\u{e0000}'..='\u{e01ef}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_emoji_of_several_characters_are_pictures() {
        let wales = "\u{1f3f4}\u{e0067}\u{e0062}\u{e0077}\u{e006c}\u{e0073}\u{e007f}";
        for picture in ["👩‍👩‍👧", "❤️‍🔥", wales] {
            assert!(is_picture(picture), "{picture}");
        }
        let hidden = "a\u{e0041}";
        let open = wales.trim_end_matches('\u{e007f}');
        for other in [
            "a\u{200d}",
            "👩\u{200d}",
            "\u{200d}",
            hidden,
            open,
            "क्\u{200d}ष",
        ] {
            assert!(!is_picture(other), "{other:?}");
        }
    }

    #[test]
    fn names_are_kept_and_invisible_characters_are_removed() {
        for name in [
            "Ada",
            "Zoë Müller-Łukasiewicz",
            "Zoe\u{308}",
            "球 さん",
            "שלום",
            "=1+1",
        ] {
            assert_eq!(tidy_name(name), name);
        }
        assert_eq!(tidy_name("  Ada\n\x1b[31m "), "Ada [31m");
        assert_eq!(tidy_name("a\u{202e}b\u{200b}c\u{fffe}\u{200d}"), "abc");
        for nobody in [
            "",
            " \t",
            "\u{200b}",
            "\u{fffe}",
            "\u{301}",
            "\u{200d}\u{202e}",
            "\u{2800}",
            "\u{3164} \u{3164}",
            "\u{115f}\u{1160}",
            "\u{1160}",
            "\u{ffa0}",
            "\u{180e}\u{180b}",
            "\u{2800}\u{fe0f}\u{301}",
            "\u{1d159}\u{34f}",
        ] {
            assert_eq!(tidy_name(nobody), "", "{nobody:?}");
        }
        // A name with a visible letter is not blank, and keeps its blank letters.
        for name in ["\u{2800}a", "한\u{3164}", "\u{1112}\u{1161}", "❤", "٣"] {
            assert_eq!(tidy_name(name), name);
            assert!(!is_blank_name(name));
        }
        assert!(is_blank_name("\u{2800}") && !is_blank_name("") && !is_blank_name("\u{200b}"));
        let pile = format!("e{}", "\u{301}".repeat(1000));
        assert_eq!(tidy_name(&pile), "e\u{301}\u{301}");
    }
}

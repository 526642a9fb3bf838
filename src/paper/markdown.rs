//! A Markdown document.

use crate::files::percent_encoded;

/// A Markdown document: CommonMark with GitHub's tables.
///
/// All text passed to it is plain text and is shown literally. Each text should be one line, as
/// returned by [`clean`](super::clean()); line breaks become spaces.
///
/// Pictures are files beside the document. GitHub, GitLab and most editors do not show pictures
/// inside a document (as data URIs or inline SVG) for security reasons, but all of them show SVG
/// files.
#[derive(Debug, Clone, Default)]
pub struct Markdown {
    text: String,
}

impl Markdown {
    /// An empty document.
    pub fn new() -> Self {
        Self::default()
    }

    /// A heading of `level` 1 to 6.
    pub fn heading(&mut self, level: usize, text: &str) -> &mut Self {
        let marks = "#".repeat(level.clamp(1, 6));
        // Markdown would remove hashes at the end, so they are escaped as well.
        self.block(&format!("{marks} {}", escape(text)))
    }

    /// A paragraph.
    pub fn paragraph(&mut self, text: &str) -> &mut Self {
        self.block(&escape(text))
    }

    /// A paragraph in bold.
    pub fn strong(&mut self, text: &str) -> &mut Self {
        match text.trim() {
            "" => self,
            text => self.block(&format!("**{}**", escape(text))),
        }
    }

    /// A list with a bullet before each item.
    pub fn list<T: AsRef<str>>(&mut self, items: impl IntoIterator<Item = T>) -> &mut Self {
        let item = |item: T| format!("- {}", escape(item.as_ref()));
        self.lines(items.into_iter().map(item))
    }

    /// A list numbered from 1.
    pub fn numbered<T: AsRef<str>>(&mut self, items: impl IntoIterator<Item = T>) -> &mut Self {
        let item = |(number, item): (usize, T)| format!("{number}. {}", escape(item.as_ref()));
        self.lines((1..).zip(items).map(item))
    }

    /// A table with a header row. Each row should have as many cells as the header.
    pub fn table<T: AsRef<str>>(
        &mut self,
        heads: &[&str],
        rows: impl IntoIterator<Item = Vec<T>>,
    ) -> &mut Self {
        let line = |cells: Vec<String>| format!("| {} |", cells.join(" | "));
        let row = |cells: Vec<T>| line(cells.iter().map(|it| escape(it.as_ref())).collect());
        let head = [
            line(heads.iter().map(|it| escape(it)).collect()),
            line(vec!["---".to_owned(); heads.len()]),
        ];
        self.lines(head.into_iter().chain(rows.into_iter().map(row)))
    }

    /// A picture in the file `place`, a path relative to the document's folder with `/` as the
    /// separator; `words` describes it.
    pub fn picture(&mut self, words: &str, place: &str) -> &mut Self {
        self.block(&format!(
            "![{}]({})",
            escape(words),
            percent_encoded(place.as_bytes())
        ))
    }

    /// A horizontal rule.
    pub fn rule(&mut self) -> &mut Self {
        self.block("---")
    }

    /// The whole document.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// A block of several lines.
    fn lines(&mut self, lines: impl Iterator<Item = String>) -> &mut Self {
        self.block(&lines.collect::<Vec<_>>().join("\n"))
    }

    fn block(&mut self, block: &str) -> &mut Self {
        if !self.text.is_empty() {
            self.text.push('\n');
        }
        self.text.push_str(block);
        self.text.push('\n');
        self
    }
}

/// Escapes plain text for Markdown.
fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    let words = text.split(char::is_whitespace).filter(|it| !it.is_empty());
    for (i, word) in words.enumerate() {
        if i > 0 {
            escaped.push(' ');
        }
        let mut before = None;
        // Some characters make a list, a heading or a rule, but only at the start of a line; others
        // turn a word into a link.
        let numbered = i == 0
            && word
                .strip_suffix(['.', ')'])
                .is_some_and(|number| number.bytes().all(|it| it.is_ascii_digit()));
        let lower = word.to_lowercase();
        let address = lower.contains("://") || lower.contains('@') || lower.contains("www.");
        let mut letters = word.chars().peekable();
        while let Some(letter) = letters.next() {
            // Many programs format the text between doubled characters, as in `==text==`.
            let is_double = before == Some(letter) || letters.peek() == Some(&letter);
            let special = match letter {
                '\\' | '`' | '*' | '_' | '[' | ']' | '{' | '}' | '<' | '>' | '&' | '|' | '~'
                | '$' | '#' | '^' => true,
                '-' => i == 0,
                '+' | '=' => i == 0 || is_double,
                '%' => is_double,
                '.' | ')' if numbered => true,
                '.' | ':' | '@' => address,
                _ => false,
            };
            if special && !(letter == '-' && before.is_some_and(char::is_alphanumeric)) {
                escaped.push('\\');
            }
            escaped.push(letter);
            before = Some(letter);
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulldown_cmark::{Event, Options, Parser, Tag};

    const NASTY: [&str; 22] = [
        "<script>alert(1)</script>",
        "</details> <!-- &amp; &#x202e;",
        "[a](http://b.c) ![d](e) [^1]: [x]: y",
        "*a* **b** _c_ __d__ ~~e~~ ~f~ `g` ``h``",
        "# a #",
        "- a",
        "+ a",
        "1. a",
        "10) a",
        "> a",
        "= === ---",
        "---",
        "===",
        "a | b | c",
        "$x$ $$y$$",
        "\\",
        "a\\",
        "\\| \\*",
        "https://carrom.invalid/a_b www.carrom.invalid WWW.x a@b.c",
        "- [ ] a",
        "{#id .class}",
        "=HYPERLINK(\"x\")",
    ];

    /// The text of a document, and every tag in it.
    fn read(document: &str) -> (Vec<String>, Vec<String>) {
        let (mut texts, mut tags) = (vec![String::new()], Vec::new());
        // Typographic quotes and dashes are not part of the meaning.
        let options = Options::all() - Options::ENABLE_SMART_PUNCTUATION;
        for event in Parser::new_ext(document, options) {
            match event {
                Event::Text(text) => texts.last_mut().unwrap().push_str(&text),
                Event::Start(tag) => {
                    if let Tag::Image { dest_url, .. } = &tag {
                        tags.push(format!("picture {dest_url}"));
                    } else {
                        tags.push(format!("{:?}", tag.to_end()));
                    }
                }
                Event::End(_) => texts.push(String::new()),
                Event::SoftBreak => texts.last_mut().unwrap().push(' '),
                other => tags.push(format!("{other:?}")),
            }
        }
        texts.retain(|text| !text.is_empty());
        (texts, tags)
    }

    #[test]
    fn all_input_is_read_back_as_plain_text() {
        for text in NASTY {
            let mut document = Markdown::new();
            document.paragraph(text);
            let found = read(document.text());
            assert_eq!(found.0, [text], "{document:?}");
            assert_eq!(found.1, ["Paragraph"], "{document:?}");
            let mut document = Markdown::new();
            document.heading(2, text);
            let found = read(document.text());
            assert_eq!(found.0, [text], "{document:?}");
            assert_eq!(found.1.len(), 1, "{document:?}");
        }
    }

    #[test]
    fn lists_and_tables_keep_their_structure() {
        let mut document = Markdown::new();
        document.list(NASTY);
        let (texts, tags) = read(document.text());
        assert_eq!(texts, NASTY);
        assert_eq!(tags.len(), 1 + NASTY.len(), "{tags:?}");
        let mut document = Markdown::new();
        document.table(&["a", "b|c"], NASTY.map(|text| vec![text, text]));
        let (texts, tags) = read(document.text());
        assert_eq!(texts.len(), 2 + 2 * NASTY.len());
        assert_eq!(texts[2..], NASTY.map(|text| [text, text]).concat());
        let cells = tags.iter().filter(|tag| *tag == "TableCell").count();
        assert_eq!(cells, texts.len());
        // The tags of the cells, of the table, of its header, and of one row per text.
        assert_eq!(tags.len(), cells + 2 + NASTY.len(), "{tags:?}");
    }

    #[test]
    fn pictures_are_read_back() {
        let mut document = Markdown::new();
        document.picture("a ](x) b", "my report (1)-pictures/a%20b.svg");
        let (texts, tags) = read(document.text());
        assert_eq!(texts, ["a ](x) b"]);
        assert_eq!(
            tags,
            [
                "Paragraph",
                "picture my%20report%20%281%29-pictures/a%2520b.svg"
            ]
        );
    }

    #[test]
    fn marks_of_other_programs_are_escaped_too() {
        for (text, escaped) in [
            ("a ==b== c", r"a \=\=b\=\= c"),
            ("a ++b++", r"a \+\+b\+\+"),
            ("a %%b%%", r"a \%\%b\%\%"),
            ("50 % = 1+1", "50 % = 1+1"),
        ] {
            assert_eq!(escape(text), escaped);
        }
    }

    #[test]
    fn plain_words_are_not_escaped() {
        for text in [
            "well-aimed, at 30° (of 45°): 4.5 m/s!",
            "Ada's 1. try",
            "θ₁ = 60°",
            "6.9°",
        ] {
            assert_eq!(escape(text), text);
        }
    }
}

//! The glossary: the terms of mechanics listed in `assets/glossary.toml`.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use crate::quiz::Passage;

/// An entry of the glossary.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct GlossaryEntry {
    /// The term, such as "impact angle".
    pub term: String,
    /// The symbol, such as "α".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub symbol: Option<String>,
    /// The unit, such as "°".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// The heading under which the term is listed; entries with the same heading are adjacent.
    pub topic: String,
    /// The meaning of the term, in one sentence.
    pub meaning: String,
    /// The id of the chapter in which the term is introduced.
    pub chapter: String,
    /// The title of the page in that chapter.
    pub page: String,
}

impl GlossaryEntry {
    /// All entries, grouped by topic.
    pub fn all() -> &'static [Self] {
        #[derive(Default, Deserialize)]
        struct Glossary {
            entry: Vec<GlossaryEntry>,
        }
        static ALL: LazyLock<Vec<GlossaryEntry>> = LazyLock::new(|| {
            let text = include_str!("../../assets/glossary.toml");
            toml::from_str::<Glossary>(text).unwrap_or_default().entry
        });
        &ALL
    }

    /// The page that introduces the term.
    pub(crate) fn introduced_by(&'static self) -> Passage {
        Passage {
            chapter: &self.chapter,
            page: &self.page,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;
    use std::path::Path;

    use super::*;
    use crate::files::FileLibrary;
    use crate::lessons::{Book, ChapterLibrary};

    /// The source text of a page in a chapter.
    struct WrittenPage {
        chapter: String,
        title: String,
        text: String,
    }

    /// All pages of the built-in chapters, in reading order.
    fn written_pages() -> Vec<WrittenPage> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/lessons");
        let mut pages = Vec::new();
        for chapter in &ChapterLibrary::embedded().chapters {
            let name = format!("{:02}-{}.md", chapter.number, chapter.id);
            let file = fs::read_to_string(folder.join(name)).unwrap();
            for page in file.split("\n# ").skip(1) {
                let (title, text) = page.split_once('\n').unwrap();
                let text = text.to_lowercase();
                pages.push(WrittenPage {
                    chapter: chapter.id.clone(),
                    title: title.to_owned(),
                    text: text.split_whitespace().collect::<Vec<_>>().join(" "),
                });
            }
        }
        pages
    }

    /// The part that the singular and plural forms of a term have in common.
    fn stem(term: &str) -> &str {
        term.strip_suffix('y').unwrap_or(term)
    }

    fn uses(text: &str, term: &str) -> bool {
        let mut found = text.match_indices(stem(term));
        found.any(|(at, _)| !text[..at].ends_with(char::is_alphabetic))
    }

    /// Whether the term is in bold type, which marks the sentence in which it is explained.
    fn introduces(text: &str, term: &str) -> bool {
        let mut bold = text.split("**").skip(1).step_by(2);
        bold.any(|words| words.starts_with(stem(term)))
    }

    #[test]
    fn each_term_is_introduced_on_its_page_and_not_used_before() {
        let pages = written_pages();
        let mut faults = Vec::new();
        for entry in GlossaryEntry::all() {
            let GlossaryEntry { term, page, .. } = entry;
            let is_named = |it: &WrittenPage| it.chapter == entry.chapter && it.title == *page;
            let Some(at) = pages.iter().position(is_named) else {
                faults.push(format!("{term}: no page {page} in {}", entry.chapter));
                continue;
            };
            for (i, it) in pages.iter().enumerate() {
                if (i == at) != introduces(&it.text, term) {
                    faults.push(format!("{term}: bold on {}, {}?", it.chapter, it.title));
                }
                if i < at && uses(&it.text, term) {
                    faults.push(format!(
                        "{term}: used before, on {}, {}",
                        it.chapter, it.title
                    ));
                }
            }
        }
        assert!(faults.is_empty(), "{}", faults.join("\n"));
    }

    #[test]
    fn entries_are_sentences_grouped_by_topic() {
        let all = GlossaryEntry::all();
        assert!(all.len() >= 30);
        let terms: BTreeSet<&str> = all.iter().map(|it| it.term.as_str()).collect();
        assert_eq!(terms.len(), all.len(), "a term is listed twice");
        let mut topics: Vec<&str> = all.iter().map(|it| it.topic.as_str()).collect();
        topics.dedup();
        let different: BTreeSet<&str> = topics.iter().copied().collect();
        assert_eq!(topics.len(), different.len(), "{topics:?}");
        for it in all {
            assert!(
                it.meaning.ends_with('.') && !it.meaning.contains(". "),
                "{it:?}"
            );
            assert!(it.symbol.as_deref() != Some("") && it.unit.as_deref() != Some(""));
        }
    }

    #[test]
    fn the_guide_lists_the_same_entries() {
        let book = Book::default();
        let rows = GlossaryEntry::all().iter().map(|it| {
            let symbol = it.symbol.as_deref().unwrap_or_default();
            let unit = it.unit.as_deref().unwrap_or_default();
            let page = book.named(it.introduced_by()).unwrap();
            [it.term.as_str(), symbol, unit, &it.meaning, &page].join(" | ")
        });
        let guide = include_str!("../../docs/glossary.md");
        let listed = guide.lines().filter_map(|line| {
            let cells: Vec<&str> = line
                .strip_prefix('|')?
                .strip_suffix('|')?
                .split('|')
                .collect();
            Some(
                cells
                    .into_iter()
                    .map(str::trim)
                    .collect::<Vec<_>>()
                    .join(" | "),
            )
        });
        let is_head = |row: &String| row.starts_with("Term |") || row.starts_with("---");
        let listed: Vec<String> = listed.filter(|row| !is_head(row)).collect();
        assert_eq!(listed, rows.collect::<Vec<_>>());
    }
}

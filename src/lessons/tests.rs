use std::collections::BTreeMap;

use super::*;
use crate::files::FileLibrary;
use crate::quiz::concepts;
use crate::quiz::{Misconception, Topic};

#[test]
fn the_chapters_in_the_program_are_whole() {
    let library = ChapterLibrary::embedded();
    assert_eq!(library.problems, []);
    assert!(!library.chapters.is_empty());
}

#[test]
fn each_misconception_and_each_topic_leads_to_a_page_that_exists() {
    let book = Book::default();
    for belief in Misconception::ALL {
        let named = book.named(belief.settled_by());
        assert!(named.is_some(), "{belief:?}: {:?}", belief.settled_by());
    }
    let written = concepts::all().iter().map(|concept| concept.topic());
    for topic in Topic::all().chain(written) {
        let named = topic.taught_on().and_then(|page| book.named(page));
        assert!(named.is_some(), "{topic}: {:?}", topic.taught_on());
    }
}

/// Symbols and the chapters that use them, from the table in `docs/notation.md`.
fn notation() -> BTreeMap<&'static str, &'static str> {
    let mut notation = BTreeMap::new();
    for row in include_str!("../../docs/notation.md").lines() {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        if let ["", symbol, _, _, chapters, ""] = cells[..] {
            let before = notation.insert(symbol, chapters);
            assert!(before.is_none(), "{symbol} has two meanings");
        }
    }
    notation
}

/// Whether a cell such as `from 4` or `3, 9` names the chapter.
fn names_chapter(cell: &str, chapter: usize) -> bool {
    match cell.strip_prefix("from ") {
        Some(first) => first.parse().is_ok_and(|first: usize| chapter >= first),
        None => cell.split(", ").any(|number| number.parse() == Ok(chapter)),
    }
}

/// The words of a line, without the indices of symbols.
fn words(line: &str) -> impl Iterator<Item = &str> {
    let ends = |c: char| !c.is_alphabetic() || "ₙₜₓᵧ".contains(c);
    line.split(ends).filter(|word| !word.is_empty())
}

/// The symbols of a formula: all its words that are no functions.
fn in_formula(formula: &Formula) -> Vec<String> {
    let functions = ["sin", "cos", "tan", "arcsin"];
    let line = formula.inline();
    let symbols = words(&line).filter(|word| !functions.contains(word));
    symbols.map(String::from).collect()
}

/// The symbols of a text: those of its formulas, and every word with a Greek letter.
fn in_text(text: &[Inline]) -> Vec<String> {
    let of_piece = |piece: &Inline| match piece {
        Inline::Formula(formula) => in_formula(formula),
        Inline::Text(text, _) => {
            let greek = |word: &&str| word.contains(|c| ('Α'..='ω').contains(&c));
            words(text).filter(greek).map(String::from).collect()
        }
        Inline::Live(_) => Vec::new(),
    };
    text.iter().flat_map(of_piece).collect()
}

fn in_blocks(blocks: &[TextBlock]) -> Vec<String> {
    let of_block = |block: &TextBlock| match block {
        TextBlock::Paragraph(text) | TextBlock::Item(_, text) => in_text(text),
        TextBlock::Formula(formula) => in_formula(formula),
    };
    blocks.iter().flat_map(of_block).collect()
}

fn on_page(page: &ChapterPage) -> Vec<String> {
    let mut symbols = in_blocks(&page.text);
    if let Some(checkpoint) = &page.checkpoint {
        for blocks in [&checkpoint.question, &checkpoint.hint, &checkpoint.after] {
            symbols.extend(in_blocks(blocks));
        }
        if let CheckpointKind::Choice(choices) = &checkpoint.asked {
            let texts = choices.iter().flat_map(|it| [&it.text, &it.why]);
            symbols.extend(texts.flat_map(|text| in_text(text)));
        }
    }
    symbols
}

#[test]
fn each_symbol_of_a_chapter_has_one_meaning_in_the_notation() {
    let notation = notation();
    for (chapter, number) in ChapterLibrary::embedded_once().chapters.iter().zip(1..) {
        for page in &chapter.pages {
            for symbol in on_page(page) {
                let chapters = notation.get(&*symbol);
                assert!(
                    chapters.is_some_and(|cell| names_chapter(cell, number)),
                    "chapter {number}, {}: docs/notation.md has no meaning of {symbol} here",
                    page.title
                );
            }
        }
    }
}

//! How hard the texts are to read: the Flesch–Kincaid grade, which is roughly the number of years
//! of schooling that a reader needs. Formulas, numbers, tables, headings and directives are left
//! out.

use std::fs;
use std::path::Path;

use carrom::quiz::{Dice, Difficulty, Family, concepts};

/// Short words in formulas, and units.
const SYMBOLS: [&str; 9] = ["mm", "kg", "fm", "mj", "ms", "mev", "sin", "cos", "tan"];

/// Parts of words in which two adjacent vowels belong to two syllables.
const APART: [&str; 9] = [
    "ia", "iu", "area", "idea", "being", "going", "ratio", "react", "create",
];

/// A word in lower case; `None` for a part of a formula, a number or a unit.
fn word(token: &str) -> Option<String> {
    let token = token.trim_matches(|c: char| !c.is_alphanumeric() && c != '°');
    let word = token.to_lowercase();
    let is_word = |c: char| c.is_ascii_lowercase() || "-'’".contains(c);
    let is_short = word.len() == 1 && word != "a" && word != "i";
    let is_left_out = word.is_empty() || is_short || SYMBOLS.contains(&word.as_str());
    (!is_left_out && word.chars().all(is_word)).then_some(word)
}

/// The number of syllables, counted as groups of vowels without silent endings.
fn syllables(word: &str) -> usize {
    let of_part = |part: &str| {
        let is_vowel = |c: char| "aeiouy".contains(c);
        let mut groups = 0;
        let mut in_group = false;
        for c in part.chars() {
            groups += usize::from(is_vowel(c) && !in_group);
            in_group = is_vowel(c);
        }
        let ends = |endings: &[&str]| endings.iter().any(|it| part.ends_with(it));
        let is_silent = ends(&["e"]) && !ends(&["le", "ee", "ie", "oe"])
            || ends(&["ed"]) && !ends(&["ted", "ded", "eed", "ied"])
            || ends(&["es"])
                && !ends(&[
                    "ses", "xes", "zes", "ches", "shes", "ces", "ges", "ies", "les",
                ]);
        let apart = APART.iter().filter(|it| part.contains(*it)).count();
        (groups + apart).saturating_sub(is_silent.into()).max(1)
    };
    let parts = word.split('-').filter(|part| !part.is_empty());
    parts.map(of_part).sum()
}

/// The Flesch–Kincaid grade of these paragraphs.
fn grade<'t>(paragraphs: impl IntoIterator<Item = &'t str>) -> f64 {
    let (mut sentences, mut words, mut all_syllables) = (0, 0, 0);
    for paragraph in paragraphs {
        let mut open = false;
        for token in paragraph.split_whitespace() {
            if let Some(word) = word(token) {
                words += 1;
                all_syllables += syllables(&word);
                open = true;
            }
            let end = token.trim_end_matches(['"', '”', ')', '*']);
            if end.ends_with(['.', '?', '!']) {
                sentences += usize::from(open);
                open = false;
            }
        }
        sentences += usize::from(open);
    }
    let [sentences, words, syllables] =
        [sentences, words, all_syllables].map(|count| f64::from(count as u32));
    0.39 * words / sentences + 11.8 * syllables / words - 15.59
}

/// The paragraphs of a chapter, with a 0 for each formula and each computed number.
fn paragraphs(chapter: &str) -> Vec<String> {
    let (_, pages) = chapter.split_once("\n+++\n").unwrap();
    let mut paragraphs = vec![String::new()];
    for line in pages.lines() {
        let line = line.trim();
        let is_text = !line.starts_with(['#', ':']) && !line.starts_with("---");
        let line = line.strip_prefix("- ").unwrap_or(line);
        let begins = line.is_empty() || line.starts_with('[') || !is_text;
        if begins || line.starts_with("$$") {
            paragraphs.push(String::new());
        }
        if is_text && !line.starts_with("$$") {
            let text = line.trim_start_matches("[ ]").trim_start_matches("[x]");
            let last = paragraphs.last_mut().unwrap();
            last.push_str(text);
            last.push(' ');
        }
    }
    let without = |text: &String| {
        let mut kept = String::new();
        let mut inside = None;
        for c in text.chars() {
            match (inside, c) {
                (None, '$') => inside = Some('$'),
                (None, '{') => inside = Some('}'),
                (Some(end), c) if c == end => {
                    inside = None;
                    kept.push('0');
                }
                (None, c) => kept.push(c),
                (Some(_), _) => {}
            }
        }
        kept
    };
    paragraphs.iter().map(without).collect()
}

/// Prints a grade; returns a message if it is more than `most`.
fn assert_readable(name: &str, grade: f64, most: f64) -> Option<String> {
    println!("{name:<40}{grade:5.1}");
    (grade > most).then(|| format!("{name}: grade {grade:.1}, more than {most}"))
}

#[test]
fn the_chapters_are_easy_to_read() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/lessons");
    let files = fs::read_dir(folder).unwrap();
    let mut files: Vec<_> = files.map(|file| file.unwrap().path()).collect();
    files.sort();
    assert_eq!(files.len(), 17);
    let hard = (1..).zip(&files).filter_map(|(number, file)| {
        let text = fs::read_to_string(file).unwrap();
        let paragraphs = paragraphs(&text);
        let grade = grade(paragraphs.iter().map(String::as_str));
        let most = if number <= 6 { 9.0 } else { 11.0 };
        assert_readable(&format!("chapter {number}"), grade, most)
    });
    let hard: Vec<_> = hard.collect();
    assert!(hard.is_empty(), "{}", hard.join("\n"));
}

#[test]
fn the_explanations_are_easy_to_read() {
    let mut hard = Vec::new();
    for &family in Family::ALL.iter() {
        let asked = Difficulty::ALL.into_iter().flat_map(|difficulty| {
            let ask = move |seed| family.ask(difficulty, &mut Dice::new(seed));
            (0..20).filter_map(ask).map(|(question, _)| question.why)
        });
        let texts: Vec<String> = asked.collect();
        let grade = grade(texts.iter().flat_map(|text| text.lines()));
        hard.extend(assert_readable(family.id(), grade, 11.0));
    }
    let written = grade(concepts::all().iter().map(|it| it.why.as_str()));
    hard.extend(assert_readable("questions in words", written, 11.0));
    assert!(hard.is_empty(), "{}", hard.join("\n"));
}

#[test]
fn a_long_sentence_of_long_words_has_a_high_grade() {
    let easy = grade(["The coin leaves along the line. It is fast."]);
    let hard = grade([
        "Considering the conservation of kinetic energy and momentum simultaneously, the \
         participants' velocities are unambiguously determined by the geometrical configuration.",
    ]);
    assert!(easy < 3.0 && hard > 15.0, "{easy} {hard}");
    for (word, count) in [
        ("velocity", 4),
        ("impulse", 2),
        ("moves", 1),
        ("collided", 3),
    ] {
        assert_eq!(syllables(word), count, "{word}");
    }
}

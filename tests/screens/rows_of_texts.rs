//! Every text of carrom, broken into rows of several widths: no formula breaks inside a term.

use carrom::lessons::{ChapterLibrary, CheckpointKind, Inline, TextBlock};
use carrom::levels::LevelLibrary;
use carrom::quiz::concepts;
use carrom::quiz::{Dice, Difficulty, Family, Form, Misconception};
use carrom::widgets::Charset;
use carrom::widgets::text::wrap;

/// The tested widths of texts, from a little less than the width of a panel at 80×24. In fewer
/// columns not every term fits.
const COLUMNS: [usize; 5] = [26, 31, 38, 47, 70];

/// The texts of chapters; each live number is replaced by a number with four digits.
fn chapters() -> Vec<String> {
    let mut texts = Vec::new();
    for chapter in &ChapterLibrary::embedded_once().chapters {
        for page in &chapter.pages {
            let mut blocks: Vec<&TextBlock> = page.text.iter().collect();
            if let Some(checkpoint) = &page.checkpoint {
                blocks.extend(checkpoint.question.iter().chain(&checkpoint.after));
                if let CheckpointKind::Choice(choices) = &checkpoint.asked {
                    let inlines = choices.iter().flat_map(|it| [&it.text, &it.why]);
                    texts.extend(inlines.map(|inline| plain(inline)));
                }
            }
            texts.extend(blocks.into_iter().filter_map(|block| match block {
                TextBlock::Paragraph(inline) | TextBlock::Item(_, inline) => Some(plain(inline)),
                TextBlock::Formula(_) => None,
            }));
        }
    }
    texts
}

fn plain(inline: &[Inline]) -> String {
    let word = |piece: &Inline| match piece {
        Inline::Text(text, _) => text.clone(),
        Inline::Formula(formula) => formula.inline(),
        Inline::Live(_) => "12.34".into(),
    };
    inline.iter().map(word).collect()
}

fn levels() -> Vec<String> {
    let packs = LevelLibrary::embedded_once().packs.iter();
    let levels = packs.flat_map(|pack| &pack.levels);
    let texts = levels.flat_map(|level| level.hints.iter().chain([&level.explanation]));
    texts.cloned().collect()
}

/// The texts of the questions: those of every family, and all questions in words.
fn questions() -> Vec<String> {
    let drawn = Family::ALL.iter().flat_map(|family| {
        let dice = (0..40).flat_map(|seed| Difficulty::ALL.map(|it| (it, seed)));
        dice.filter_map(|(it, seed)| Some(family.ask(it, &mut Dice::new(seed))?.0))
    });
    let mut texts: Vec<String> = drawn
        .flat_map(|question| {
            let mut texts = vec![question.text, question.why];
            texts.extend(question.beliefs.into_iter().map(|belief| belief.says));
            if let Form::Choice { options, .. } = question.form {
                texts.extend(options);
            }
            texts
        })
        .collect();
    for concept in concepts::all() {
        texts.extend([&concept.ask, &concept.right, &concept.why].map(Clone::clone));
        let wrongs = concept.wrongs.iter();
        texts.extend(wrongs.flat_map(|wrong| [wrong.choice.clone(), wrong.says.clone()]));
    }
    texts.extend(Misconception::ALL.iter().map(|it| it.advice().to_owned()));
    texts
}

/// Whether the term around a break does not fit in a row, so that it had to be broken.
fn is_too_long(before: &str, after: &str, columns: usize) -> bool {
    let tail = before.rfind("= ").map_or(before, |at| &before[at..]);
    let head = after
        .split_inclusive([',', ':', '='])
        .next()
        .unwrap_or_default();
    let head = head.trim_end_matches([' ', '=']);
    tail.chars().count() + 1 + head.chars().count() > columns
}

/// The reason why a row must not be broken between these two parts of a text.
fn fault(before: &str, after: &str) -> Option<&'static str> {
    let last = before.split(' ').next_back().unwrap_or_default();
    let first = after.split(' ').next().unwrap_or_default();
    let function = last.trim_start_matches(['(', '-', '−']);
    let open = before
        .rfind('(')
        .is_some_and(|at| !before[at..].contains(')'));
    if ["/", "·", "×"].contains(&first) {
        Some("begins with an operator of a term")
    } else if ["+", "−", "-", "/", "·", "×", "=", "±"].contains(&last) {
        Some("ends with an operator")
    } else if ["sin", "cos", "tan", "sin²", "cos²", "sin⁴"].contains(&function) && first != "of"
    {
        Some("ends with a function")
    } else if open && ["+", "−", "-"].contains(&first) {
        Some("begins with a sign in brackets")
    } else {
        None
    }
}

#[test]
fn no_formula_breaks_inside_a_term() {
    let mut faults = Vec::new();
    let texts = [chapters(), levels(), questions()].concat();
    assert!(texts.len() > 3000, "{}", texts.len());
    for text in &texts {
        for columns in COLUMNS {
            for charset in [Charset::Ascii, Charset::Unicode] {
                let rows = wrap(&charset.text(text), columns);
                for pair in rows.windows(2) {
                    if let Some(fault) = fault(&pair[0], &pair[1])
                        && !is_too_long(&pair[0], &pair[1], columns)
                    {
                        faults.push(format!("{columns}: {fault}: {} | {}", pair[0], pair[1]));
                    }
                }
            }
        }
    }
    faults.sort();
    faults.dedup();
    assert!(
        faults.is_empty(),
        "{} faults:\n{}",
        faults.len(),
        faults.join("\n")
    );
}

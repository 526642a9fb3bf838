//! Checks how questions and formulas are read aloud, and how typed lines are handled.

use super::by_words::by_words;
use super::formula::aloud;
use super::page::{read, unit};
use super::{PlainReader, spoken};
use crate::app::App;
use crate::lessons::{ChapterLibrary, CheckpointKind, Inline, TextBlock};
use crate::quiz::{
    Answer, Code, Confidence, Course, CourseKind, Family, Form, Round, concepts, explain,
};
use crate::screens::{Route, Settings};
use crate::shells::Headless;

#[test]
fn every_question_is_read_aloud_completely() {
    for &family in Family::ALL {
        for seed in 0..20 {
            let course = Course::new(CourseKind::Topic(family));
            let round = Round::of(Code { course, seed });
            for question in round.questions() {
                let mut lines = vec![by_words(&question.text)];
                if let Form::Choice { options, .. } = &question.form {
                    lines.extend(options.iter().map(ToString::to_string));
                }
                for said in question.beliefs.iter().map(|belief| belief.said) {
                    let explained = explain(question, &Answer::new(said, Confidence::Sure));
                    lines.extend([explained.title.to_owned(), explained.text.to_string()]);
                    lines.push(question.form.words(&said).to_string());
                }
                lines.iter().for_each(|line| assert_spoken(&read(line)));
            }
        }
    }
    for concept in concepts::all() {
        let wrongs = concept.wrongs.iter();
        let choices = wrongs.flat_map(|wrong| [&wrong.choice, &wrong.says]);
        let own = [&concept.ask, &concept.right, &concept.why];
        own.into_iter()
            .chain(choices)
            .for_each(|text| assert_spoken(&read(text)));
    }
}

#[test]
fn no_symbol_in_a_chapter_formula_is_read_as_a_unit() {
    let units = ["metre", "gram", "second", "joule", "volt", "percent"];
    let mut formulas = 0;
    let chapters = &ChapterLibrary::embedded_once().chapters;
    for page in chapters.iter().flat_map(|chapter| &chapter.pages) {
        let checkpoint = page.checkpoint.iter();
        let asked = checkpoint.flat_map(|it| [&it.question, &it.hint, &it.after]);
        let blocks = std::iter::once(&page.text).chain(asked).flatten();
        let mut pieces: Vec<&Inline> = Vec::new();
        let mut all = Vec::new();
        for block in blocks {
            match block {
                TextBlock::Formula(formula) => all.push(formula),
                TextBlock::Paragraph(line) | TextBlock::Item(_, line) => pieces.extend(line),
            }
        }
        let choices = page.checkpoint.iter().map(|it| &it.asked);
        for choice in choices.flat_map(|asked| match asked {
            CheckpointKind::Choice(choices) => &choices[..],
            _ => &[],
        }) {
            pieces.extend(choice.text.iter().chain(&choice.why));
        }
        all.extend(pieces.into_iter().filter_map(|piece| match piece {
            Inline::Formula(formula) => Some(formula),
            _ => None,
        }));
        formulas += all.len();
        for formula in all {
            let said = spoken(&aloud(formula));
            assert!(!units.iter().any(|unit| said.contains(unit)), "{said}");
            assert_spoken(&said);
        }
    }
    assert!(formulas > 100, "{formulas}");
}

/// A pupil's name may be a single letter, or look like a setting.
#[test]
fn a_requested_text_is_accepted_unchanged() {
    for text in ["q", "h", "r", "a=b", "class = 1"] {
        let place = Route::Join {
            address: None,
            code: None,
            again: false,
        };
        let mut app = App::new(place, Settings::default(), 1);
        let mut reader = PlainReader::new(&mut app);
        let mut held = Headless::from(app);
        reader.begin(&mut held);
        reader.hear(text, &mut held);
        assert!(!held.app().has_quit(), "{text}");
        let said = reader.hear("repeat", &mut held).join("\n");
        let spoken = read(text);
        assert!(said.contains(&format!(": {spoken}")), "{text}:\n{said}");
    }
}

/// The value stays as it was, and the reply does not list the possible values.
#[test]
fn a_number_that_cannot_be_typed_is_refused_in_one_line() {
    let mut app = App::new(Route::Lab, Settings::default(), 1);
    let mut reader = PlainReader::new(&mut app);
    let mut held = Headless::from(app);
    reader.begin(&mut held);
    for speed in ["1000000000", "-100000000", "fast"] {
        let said = reader.hear(&format!("speed = {speed}"), &mut held);
        assert!(said[0].starts_with("Please type a number"), "{said:?}");
        let now = reader.hear("repeat", &mut held).join("\n");
        assert!(now.contains("speed: 4.00 metres per second"), "{now}");
    }
    reader.hear("speed = 7.25", &mut held);
    let now = reader.hear("repeat", &mut held).join("\n");
    assert!(now.contains("speed: 7.25 metres per second"), "{now}");
}

#[test]
fn file_names_are_read_unchanged() {
    for (text, expected) in [
        (
            "left out: a_2*x-1=b/01-bad.md:1: expected +++, found v = 2 m/s",
            "left out: a_2*x-1=b/01-bad.md:1: expected plus plus plus, found v equals 2 metres per second",
        ),
        ("kept in /home/p_1/x=2.", "kept in /home/p_1/x=2."),
        ("slip/stick", "slip/stick"),
        ("b/(r_1 + r_2)", "b over (r 1 plus r 2)"),
    ] {
        assert_eq!(read(text), expected);
    }
}

#[test]
fn a_unit_may_have_two_words() {
    for (value, expected) in [("60.0 g m/s", "g m/s"), ("12 mm", "mm"), ("none", "")] {
        assert_eq!(unit(value), expected);
    }
}

/// Asserts that a line contains only words.
fn assert_spoken(line: &str) {
    let plain = |c: char| c.is_ascii_alphanumeric() || " .,;:?!'\"()-/".contains(c);
    assert!(line.chars().all(plain), "{line}");
    let words = line.split(|c: char| !c.is_ascii_alphanumeric());
    for word in words {
        assert!(!spoken::is_function(word), "{word}: {line}");
    }
    for never in [
        "?.",
        "!.",
        "  ",
        " 1 metres",
        " 1 grams",
        " 1 degrees",
        "the the ",
        // No instruction may require a mouse or sight.
        "Drag the ",
        "drag the ",
        "Press ",
        "ook at the picture",
        "ook at the figure",
        "ook again",
        " click ",
        "the mouse",
    ] {
        assert!(!line.contains(never), "{never}: {line}");
    }
    // A subscript must not follow a unit.
    for unit in ["metres ", "metre ", "grams ", "seconds "] {
        for (at, _) in line.match_indices(unit) {
            let next = line[at + unit.len()..].chars().next();
            assert!(!next.is_some_and(|c| c.is_ascii_digit()), "{line}");
        }
    }
}

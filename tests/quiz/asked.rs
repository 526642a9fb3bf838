//! The message to a pupil's device while a question is open: it contains everything that is shown,
//! and nothing about the answer.

use std::collections::BTreeSet;

use carrom::class::{AskedQuestion, RevealedTruth};
use carrom::quiz::{Dice, Difficulty, Family, Form, Illustration, Measure, Question, Rays};
use carrom::widgets::{Charset, Depth, Look, Palette, Theme, draw_question};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Questions of every family, including every question in words, each once.
fn all() -> Vec<Question> {
    let mut all = Vec::new();
    let mut asked_before = BTreeSet::new();
    for (family, difficulty) in Family::ALL
        .iter()
        .flat_map(|it| Difficulty::ALL.map(|d| (it, d)))
    {
        let many = match family {
            Family::Concept | Family::Ideas => 400,
            _ => 12,
        };
        for seed in 0..many {
            let asked = family.ask(difficulty, &mut Dice::new(seed));
            let question = asked.map(|(question, _)| question);
            all.extend(question.filter(|it| asked_before.insert(format!("{it:?}"))));
        }
    }
    all
}

/// The same question with another right answer and without feedback.
fn otherwise(question: &Question) -> Question {
    let mut other = question.clone();
    other.beliefs.clear();
    other.replies.clear();
    other.figures.clear();
    other.why = "Because.".into();
    match &mut other.form {
        Form::Rays { truth, .. } => *truth = Rays::new(1.25, -0.75),
        Form::Number { truth, .. } => *truth = 12_345.678,
        Form::Choice { right, options } => *right = (*right + 1) % options.len(),
        Form::Shot(aim) => aim.offset += 0.00123,
    }
    other
}

fn sent(question: &Question) -> String {
    serde_json::to_string(&AskedQuestion::new(question)).unwrap()
}

#[test]
fn messages_do_not_depend_on_the_answer() {
    let all = all();
    for family in Family::ALL {
        assert!(all.iter().any(|it| it.family == *family), "{}", family.id());
    }
    for question in &all {
        let message = sent(question);
        assert_eq!(message, sent(&otherwise(question)), "{}", question.text);
        // The message contains no feedback either.
        for says in question.beliefs.iter().map(|it| it.says.as_str()) {
            assert!(!message.contains(says), "{says}");
        }
        for says in question.replies.values().chain([&question.why]) {
            assert!(!message.contains(says.as_str()), "{says}");
        }
        for belief in &question.beliefs {
            assert!(
                !message.contains(&format!("\"{}\"", belief.misconception.id())),
                "{message}"
            );
        }
        assert!(message.len() < 8000, "{}", message.len());
    }
}

/// No number in the message's picture is the one that the question asks for, unless the text also
/// contains it.
#[test]
fn no_figure_in_the_message_is_the_right_number() {
    for question in all() {
        let Form::Number { quantity, truth } = &question.form else {
            continue;
        };
        let message: serde_json::Value = serde_json::from_str(&sent(&question)).unwrap();
        let mut figures = Vec::new();
        collect(&message["picture"], &mut figures);
        for figure in figures {
            let scaled = match quantity {
                Measure::Angle => figure.to_degrees(),
                Measure::Share => 100.0 * figure,
                Measure::Mass | Measure::Length => 1000.0 * figure,
                _ => figure,
            };
            let near = (scaled.abs() - truth.abs()).abs() < 1e-9 * truth.abs().max(1e-9);
            let printed = quantity.print(*truth);
            let given = question.text.contains(printed.split(' ').next().unwrap());
            assert!(!near || given, "{truth}: {}\n{message}", question.text);
        }
    }
}

fn collect(value: &serde_json::Value, figures: &mut Vec<f64>) {
    match value {
        serde_json::Value::Number(x) => figures.extend(x.as_f64()),
        serde_json::Value::Array(items) => items.iter().for_each(|it| collect(it, figures)),
        serde_json::Value::Object(fields) => fields.values().for_each(|it| collect(it, figures)),
        _ => {}
    }
}

fn drawn(question: &Question) -> Buffer {
    let area = Rect::new(0, 0, 60, 24);
    let mut buf = Buffer::empty(area);
    let look = Look {
        charset: Charset::Unicode,
        theme: Theme::new(Palette::Dark, Depth::True),
        ..Look::default()
    };
    draw_question(area, &mut buf, &look, question, None);
    buf
}

#[test]
fn a_device_shows_what_the_board_shows() {
    for question in all() {
        let message = sent(&question);
        let asked: AskedQuestion = serde_json::from_str(&message).unwrap();
        let there = asked.question().unwrap_or_else(|| panic!("{message}"));
        assert_eq!(there.text, question.text);
        let [here, there_too] = [&question, &there].map(drawn);
        let pairs = here.content().iter().zip(there_too.content());
        let apart = pairs.filter(|(a, b)| a != b).count();
        // For a collision that has already happened, only the angles are sent, so the last bit of a
        // sine may move a dot into the adjacent cell.
        let most = match question.picture {
            Illustration::After { .. } => 12,
            _ => 0,
        };
        assert!(
            apart <= most,
            "{apart}, {}: {}",
            question.family.id(),
            question.text
        );
        // Once the answer is revealed, the message contains the whole answer.
        let told = RevealedTruth::new(&question, question.why.clone(), Some(10.0));
        let told = serde_json::to_string(&told).unwrap();
        let told: RevealedTruth = serde_json::from_str(&told).unwrap();
        let there = told.revealed(there).unwrap();
        let truth = question.form.truth();
        assert!(
            question.form.distance(&there.form.truth(), &truth) < 1e-6,
            "{}",
            question.text
        );
        if let (
            Illustration::Before { collision: a, .. } | Illustration::After { collision: a },
            Illustration::Before { collision: b, .. } | Illustration::After { collision: b },
        ) = (&there.picture, &question.picture)
        {
            assert_eq!(a, b, "{}", question.text);
        }
    }
}

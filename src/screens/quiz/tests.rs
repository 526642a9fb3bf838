//! Tests of every form of answer with every picture, independent of the families of questions.

use std::sync::Arc;

use glam::DVec2;
use ratatui::buffer::Buffer;

use super::*;
use crate::messages::Input;
use crate::physics::rutherford::Rutherford;
use crate::physics::{Collision, Disc};
use crate::quiz::concepts::{Library, QuestionSet};
use crate::quiz::{AimTask, Illustration, Markings, Measure, Ray};
use crate::screens::{AnyScreen, Hosted, Settings};
use crate::widgets::cells::text;

const SIZES: [(u16, u16); 7] = [
    (0, 0),
    (7, 3),
    (60, 18),
    (80, 22),
    (120, 38),
    (58, 90),
    (300, 98),
];

const SET: &str = "format = 1\ntitle = \"A set\"\n\
    [[question]]\ncode = \"7\"\nnumber = 1\n\
    [[question]]\ncode = \"7\"\nnumber = 2\n";

/// A set of two questions, the first of which has this picture and this form of answer.
fn set_with(picture: Illustration, form: Form) -> Code {
    let mut set = QuestionSet::read("set.toml", SET.as_bytes(), &Library::default()).unwrap();
    let first = &mut set.questions[0].question;
    first.text = "What happens? Assume smooth discs.".into();
    first.why = "This is the explanation.".into();
    first.beliefs = vec![];
    (first.picture, first.form) = (picture, form);
    Code::of_set(&Arc::new(set))
}

/// A round whose current question is set by the test.
struct TestRound {
    quiz: Hosted<Quiz>,
    cx: Context,
}

impl TestRound {
    fn of(picture: Illustration, form: Form) -> Self {
        let quiz = Quiz::new(set_with(picture, form));
        let settings = Settings {
            reduced_motion: true,
            ..Settings::default()
        };
        let mut cx = Context::new(settings, 7);
        cx.body = Rect::new(0, 1, 80, 22);
        let quiz = Hosted::new(quiz);
        Self { quiz, cx }
    }

    fn press(&mut self, keys: &str) {
        for c in keys.chars() {
            let key = match c {
                '\n' => Key::Enter,
                // Skips to the end of the explanation.
                '$' => Key::End,
                _ => Key::Char(c),
            };
            self.quiz.press(key, &mut self.cx);
        }
    }

    fn mouse(&mut self, kind: MouseKind, (column, row): (u16, u16)) {
        let mouse = Input::Mouse(Mouse::over(kind, (column, row)));
        self.quiz.input(&mouse, &mut self.cx);
    }

    fn screen(&mut self) -> String {
        let body = self.cx.body;
        let mut buf = Buffer::empty(Rect::new(0, 0, body.width, body.bottom() + 1));
        self.quiz.draw(&mut buf, &self.cx);
        text(&buf)
    }
}

fn hit(offset_mm: f64) -> Collision {
    let disc = Disc::from_g_mm(15.0, 15.0);
    Collision::at_offset(disc, disc, DVec2::new(4.0, 0.0), offset_mm / 1000.0)
}

/// The coin must leave at 30°, so the offset is sin 30° times the sum of the radii.
fn aim() -> AimTask {
    AimTask {
        collision: hit(0.0),
        ray: Ray::Target,
        wanted: 30_f64.to_radians(),
        offset: 0.015,
    }
}

fn choice() -> Form {
    Form::Choice {
        options: [
            "more than 90°",
            "exactly 90°",
            "less than 90°, whatever the masses and the offset are, as long as the collision is \
             not head-on",
        ]
        .map(String::from)
        .into(),
        right: 1,
    }
}

fn number() -> Form {
    Form::Number {
        quantity: Measure::Times,
        truth: 16.0,
    }
}

fn before() -> Illustration {
    Illustration::Before {
        collision: hit(0.0),
        shown: Markings::default(),
    }
}

fn after() -> Illustration {
    Illustration::After {
        collision: hit(15.0),
    }
}

fn tracks() -> Illustration {
    Illustration::Tracks {
        rutherford: Rutherford::radium_c_on_gold(),
        angles: [1.0, 2.0],
    }
}

/// Each picture with each form of answer that it can have.
fn all() -> Vec<(Illustration, Form)> {
    let rays = Quiz::new(Code::hits(7)).round.questions()[0].form.clone();
    let mut all = vec![(before(), Form::Shot(aim()))];
    for picture in [Illustration::Nothing, before(), after(), tracks()] {
        all.extend([choice(), number(), rays.clone()].map(|form| (picture, form)));
    }
    all
}

#[test]
fn every_form_is_drawn_in_every_phase_at_any_size() {
    for (picture, form) in all() {
        let about = format!("{picture:?} {form:?}");
        let mut sitting = TestRound::of(picture, form.clone());
        let look = |sitting: &mut TestRound, phase: &str| {
            for (width, height) in SIZES {
                sitting.cx.body = Rect::new(0, 1, width, height);
                let screen = sitting.screen();
                let printable = |b: u8| b == b'\n' || (b' '..=b'~').contains(&b);
                assert!(screen.bytes().all(printable), "{about}\n{screen}");
                assert!(!screen.contains("NaN"), "{about}\n{screen}");
                if width >= 60 {
                    assert!(screen.contains(phase), "{about}: {phase}\n{screen}");
                }
            }
            sitting.cx.body = Rect::new(0, 1, 80, 22);
        };
        look(&mut sitting, "What happens?");
        sitting.press("1\n");
        if let Form::Rays { .. } = form {
            sitting.press("1\n");
        }
        look(&mut sitting, "How sure are you?");
        sitting.press("2$");
        look(&mut sitting, "of 10 points");
        assert_eq!(sitting.quiz.screen.answers.len(), 1);
    }
}

#[test]
fn after_a_wrong_shot_the_right_one_is_shown() {
    let mut sitting = TestRound::of(before(), Form::Shot(aim()));
    sitting.press("-5\n3$");
    let screen = sitting.screen();
    assert!(screen.contains("offset 5.00 mm left"), "{screen}");
    // The true answer fills two rows of the panel.
    assert!(
        screen.contains("offset 15.0 mm") && screen.contains("||        right "),
        "{screen}"
    );
    assert!(
        screen.contains("your shot") && screen.contains("mark"),
        "{screen}"
    );
    sitting.press("\n");
    let screen = sitting.screen();
    assert!(screen.contains("the shot that does it"), "{screen}");
    assert!(screen.contains("v2 = 3.46 m/s"), "4 cos 30 deg\n{screen}");
    sitting.press("\n");
    assert!(matches!(sitting.quiz.screen.phase, QuizPhase::Asked(_)));
    // After a correct shot, no correction is shown.
    let mut sitting = TestRound::of(before(), Form::Shot(aim()));
    sitting.press("15\n3$\n");
    assert!(matches!(sitting.quiz.screen.phase, QuizPhase::Asked(_)));
}

#[test]
fn the_coin_can_be_dragged_to_set_the_offset() {
    let mut sitting = TestRound::of(before(), Form::Shot(aim()));
    let offset = |sitting: &TestRound| match &sitting.quiz.screen.phase {
        QuizPhase::Asked(asked) => asked.asking.input().said(),
        _ => None,
    };
    // The striker's path is horizontal, on row 11; the striker's right-hand side is below it. The
    // 20 rows of the picture span 6.6 radii of 15 mm, and the coin moves by half of the offset, so
    // a row is 9.9 mm of offset; the offset is rounded to half a millimetre.
    for (row, rows) in [(11, 0.0), (12, 1.0), (13, 2.0), (9, -2.0)] {
        sitting.mouse(MouseKind::Drag, (30, row));
        let Some(Response::Shot(offset)) = offset(&sitting) else {
            panic!("no offset");
        };
        assert!((offset - 0.0099 * rows).abs() < 0.000_3, "{row}: {offset}");
    }
}

#[test]
fn a_click_on_any_row_of_a_choice_chooses_it() {
    for size in [(60, 18), (80, 22), (120, 38)] {
        for picture in [Illustration::Nothing, after()] {
            let mut sitting = TestRound::of(picture, choice());
            sitting.cx.body = Rect::new(0, 1, size.0, size.1);
            for (i, words) in [(2, "C less than"), (0, "A more than"), (1, "B exactly")] {
                let screen = sitting.screen();
                let mut rows = screen.lines().enumerate();
                let found = rows.find_map(|(row, line)| Some((row, line.find(words)?)));
                let Some((row, column)) = found else {
                    panic!("{words}\n{screen}");
                };
                sitting.mouse(MouseKind::Down, (column as u16 + 2, row as u16));
                let screen = sitting.screen();
                assert!(screen.contains(&format!("> {words}")), "{i}\n{screen}");
            }
        }
    }
}

#[test]
fn enter_right_after_the_digit_of_the_confidence_does_not_skip_the_verdict() {
    let mut sitting = TestRound::of(Illustration::Nothing, number());
    sitting.press("2\n3\n");
    let screen = sitting.screen();
    assert!(screen.contains("of 10 points"), "{screen}");
    sitting.press("\n");
    assert!(matches!(sitting.quiz.screen.phase, QuizPhase::Asked(_)));

    let mut sitting = TestRound::of(Illustration::Nothing, number());
    sitting.press("2\n3");
    sitting.quiz.advance(SETTLING, &mut sitting.cx);
    sitting.press("\n");
    assert!(matches!(sitting.quiz.screen.phase, QuizPhase::Asked(_)));
}

/// A set has only one round, whose code contains a hash of its questions.
#[test]
fn another_round_of_a_set_has_the_same_code() {
    let code = set_with(Illustration::Nothing, number());
    let mut quiz = Quiz::new(code.clone());
    quiz.again(&mut Context::new(Settings::default(), 7));
    assert_eq!(quiz.round.code(), &code);
}

/// Rays that are 4.2° off are not right, but earn nearly all the points.
#[test]
fn a_sure_answer_that_is_nearly_right_is_not_marked_as_wrong() {
    let question = Quiz::new(Code::hits(7)).round.questions()[0].clone();
    let Response::Rays(truth) = question.form.truth() else {
        panic!("a round of hits asks for rays");
    };
    let marked = |off_deg: f64| {
        let turned = |angle: Option<f64>| angle.map(|angle| angle + off_deg.to_radians());
        let said = Response::Rays(Rays {
            striker: turned(truth.striker),
            target: turned(truth.target),
        });
        let answer = Answer::new(said, crate::quiz::Confidence::Sure);
        let attempt = Attempt::of_quiz("Ada", &Code::hits(7), 1, &question, &answer);
        assert!(!attempt.right);
        summary::was_far_off(&attempt)
    };
    assert!(!marked(4.2));
    assert!(marked(60.0));
}

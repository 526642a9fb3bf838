//! Every form of answer and every picture, whatever family they come from.

use glam::DVec2;
use ratatui::buffer::Buffer;

use super::*;
use crate::messages::Input;
use crate::physics::rutherford::Rutherford;
use crate::physics::{Collision, Disc};
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

/// A round with a question of the test's own at hand.
struct TestRound {
    quiz: Hosted<Quiz>,
    cx: Context,
}

impl TestRound {
    fn of(picture: Illustration, form: Form) -> Self {
        let mut quiz = Quiz::new(Code::hits(7));
        let question = Question {
            text: "What comes of it? Assume smooth discs.".into(),
            why: "So it is.".into(),
            beliefs: vec![],
            picture,
            form,
            ..quiz.round.questions()[0].clone()
        };
        quiz.phase = QuizPhase::Asked(Box::new(OpenQuestion {
            asking: Asking::new(AnswerInput::new(&question.form)),
            question,
        }));
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
                // All that a hit tells.
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

/// The coin is to go off at 30°: sin 30° of both radii together.
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
        options: ["more than 90°", "exactly 90°", "less than 90°, whatever the masses are and however it is hit, as long as it is not head-on at all"]
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

/// Each picture with each form it may have.
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
        look(&mut sitting, "What comes of it?");
        sitting.press("1\n");
        if let Form::Rays { .. } = form {
            sitting.press("1\n");
        }
        look(&mut sitting, "How sure are you?");
        sitting.press("2$");
        look(&mut sitting, "of 10 points");
        assert_eq!(sitting.quiz.screen().answers.len(), 1);
    }
}

#[test]
fn a_shot_is_seen_as_it_was_and_then_as_it_should_have_been() {
    let mut sitting = TestRound::of(before(), Form::Shot(aim()));
    sitting.press("-5\n3$");
    let screen = sitting.screen();
    assert!(screen.contains("offset 5.00 mm left"), "{screen}");
    // It takes two rows of the panel.
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
    assert!(matches!(sitting.quiz.screen().phase, QuizPhase::Asked(_)));
    // What hits the mark has nothing to be put right.
    let mut sitting = TestRound::of(before(), Form::Shot(aim()));
    sitting.press("15\n3$\n");
    assert!(matches!(sitting.quiz.screen().phase, QuizPhase::Asked(_)));
}

#[test]
fn the_coin_is_dragged_to_where_it_is_to_be_hit() {
    let mut sitting = TestRound::of(before(), Form::Shot(aim()));
    let offset = |sitting: &TestRound| match &sitting.quiz.screen().phase {
        QuizPhase::Asked(asked) => asked.asking.input().said(),
        _ => None,
    };
    // The way is level and in the middle, on row 11; to its right is below. The picture is
    // 6.6 radii of 15 mm over 20 rows, and the coin has half of the offset: 9.9 mm a row,
    // set to half a millimetre.
    for (row, rows) in [(11, 0.0), (12, 1.0), (13, 2.0), (9, -2.0)] {
        sitting.mouse(MouseKind::Drag, (30, row));
        let Some(Response::Shot(offset)) = offset(&sitting) else {
            panic!("no offset");
        };
        assert!((offset - 0.0099 * rows).abs() < 0.000_3, "{row}: {offset}");
    }
}

#[test]
fn a_choice_is_clicked_wherever_its_rows_are() {
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

//! Rounds of the quiz over thousands of seeds: the true answer is right, every misconception is
//! recognized by its answer, and every text is readable.

use std::sync::LazyLock;

use carrom::physics::ImpactPoint;
use carrom::progress::{Attempt, Summary, calibration};
use carrom::quiz::misconceptions::OF_RAYS as ALL;
use carrom::quiz::{
    Answer, Code, Confidence, Fit, Form, Grade, Hit, Misconception, Pieces, Question, RIGHT_DEG,
    Ray, Rays, Response, Round, explain, hits,
};
use carrom::widgets::{Charset, text::wrap};
use glam::DVec2;

use crate::thorough::cases;

const SEEDS: u64 = 2_000;

static ROUNDS: LazyLock<Vec<Round>> = LazyLock::new(|| {
    let codes = (0..SEEDS).map(Code::hits);
    codes.map(Round::of).collect()
});

fn questions() -> impl Iterator<Item = &'static Question> {
    ROUNDS.iter().flat_map(Round::questions)
}

fn drawn() -> impl Iterator<Item = Hit> {
    (0..SEEDS).flat_map(hits).map(|(_, hit)| hit)
}

/// The true rays of a question.
fn truth(question: &Question) -> Rays {
    match question.form.truth() {
        Response::Rays(rays) => rays,
        other => panic!("not rays: {other:?}"),
    }
}

/// The side on which the target lies.
fn side(question: &Question) -> f64 {
    match question.form {
        Form::Rays { side, .. } => side,
        ref other => panic!("not rays: {other:?}"),
    }
}

/// The rays that misconceptions lead to, each with the ray that is enough to reveal the
/// misconception, if there is one.
fn beliefs(question: &Question) -> impl Iterator<Item = (Misconception, Rays, Option<Ray>)> {
    question.beliefs.iter().map(|belief| match belief.said {
        Response::Rays(rays) => (belief.misconception, rays, belief.telltale),
        other => panic!("not rays: {other:?}"),
    })
}

fn sure(rays: Rays) -> Answer {
    Answer::new(Response::Rays(rays), Confidence::Sure)
}

/// The angle from `a` to `b`, anticlockwise; `None` if `b` is at rest.
fn turn(a: DVec2, b: DVec2) -> Option<f64> {
    (b.length() > 1e-9 * a.length()).then(|| a.perp_dot(b).atan2(a.dot(b)))
}

/// Where the two discs go, calculated from an impulse along the line of centres.
fn by_impulse(question: &Hit) -> Rays {
    let (m1, r1, m2, r2) = match question.pieces {
        Pieces::Equal => (15.0, 15.0, 15.0, 15.0),
        Pieces::Tournament => (15.0, 20.65, 5.5, 15.9),
        Pieces::Marbles => (20.0, 12.4, 40.0, 15.6),
        Pieces::Own { .. } => unreachable!("no round asks about discs set in the lab"),
    };
    let u = question.speed * DVec2::from_angle(question.direction_deg.to_radians());
    let sine = match question.given {
        ImpactPoint::Angle { alpha_deg } => alpha_deg.to_radians().sin(),
        ImpactPoint::Offset { offset_mm } => offset_mm / (r1 + r2),
    };
    // The target's centre lies to the right of the path by `sine` times the contact distance.
    let right = DVec2::new(u.y, -u.x) / question.speed;
    let normal = u / question.speed * (1.0 - sine * sine).sqrt() + right * sine;
    let impulse = (1.0 + question.restitution) * u.dot(normal) / (1.0 / m1 + 1.0 / m2);
    Rays {
        striker: turn(u, u - impulse / m1 * normal),
        target: turn(impulse / m2 * normal, u),
    }
}

#[test]
fn the_true_rays_follow_from_an_impulse_along_the_line_of_centres() {
    for question in drawn() {
        let gap = question.truth().gap(&by_impulse(&question));
        assert!(gap < 1e-9, "{question:?}: off by {gap}");
    }
}

#[test]
fn the_right_answer_earns_full_credit_and_is_never_diagnosed() {
    for question in questions() {
        let answer = sure(truth(question));
        let grade = Grade::new(question, &answer);
        assert!(grade.right);
        assert!((grade.credit - 1.0).abs() < 1e-12);
        assert!((grade.points() - Grade::MOST).abs() < 1e-12);
        assert_eq!(question.belief_of(&answer), None);
        assert_eq!(explain(question, &answer).title, "right");
    }
}

#[test]
fn each_misconception_is_recognized_by_its_answer() {
    let mut met = [0; ALL.len()];
    for question in questions() {
        for belief in &question.beliefs {
            let place = ALL.into_iter().position(|it| it == belief.misconception);
            met[place.expect("a misconception of rays")] += 1;
            let answer = Answer::new(belief.said, Confidence::Sure);
            assert!(!Grade::new(question, &answer).right);
            let (found, fit) = question.belief_of(&answer).expect("a diagnosis");
            assert_eq!(found.misconception, belief.misconception);
            assert_eq!(fit, Fit::Whole);
        }
    }
    for (misconception, times) in ALL.into_iter().zip(met) {
        assert!(times > 100, "{misconception:?} occurred {times} times");
    }
}

#[test]
fn a_small_inaccuracy_changes_no_diagnosis() {
    let slip = 0.99 * RIGHT_DEG.to_radians();
    let nudged = |rays: Rays, a: f64, b: f64| Rays {
        striker: rays.striker.map(|angle| angle + a * slip),
        target: rays.target.map(|angle| angle + b * slip),
    };
    for question in questions().take(2_000) {
        for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let right = sure(nudged(truth(question), a, b));
            assert_eq!(question.belief_of(&right), None);
            for (misconception, rays, _) in beliefs(question) {
                let answer = sure(nudged(rays, a, b));
                let (found, _) = question.belief_of(&answer).expect("a diagnosis");
                assert_eq!(found.misconception, misconception);
            }
        }
    }
}

#[test]
fn one_ray_that_reveals_a_misconception_is_enough() {
    for question in questions().take(2_000) {
        for (_, held, telltale) in beliefs(question) {
            let Some(ray) = telltale else {
                continue;
            };
            let wild = Some(-2.2 * side(question));
            let mut rays = held;
            match ray {
                Ray::Striker => rays.target = wild,
                Ray::Target => rays.striker = wild,
            }
            let answer = sure(rays);
            let (found, fit) = question.belief_of(&answer).expect("a diagnosis");
            assert_eq!(fit, Fit::OneRay(ray), "{question:?}");
            let (_, named, _) = beliefs(question)
                .find(|(misconception, ..)| *misconception == found.misconception)
                .expect("a prediction");
            let off = named.apart(&held, ray).expect("an angle");
            assert!(off <= RIGHT_DEG.to_radians());
        }
    }
}

/// Fails unless the text fits the panel beside the picture, even spelt out in ASCII.
fn assert_readable(text: &str, lines: usize) {
    for stranger in ["NaN", "inf", "-0.0", "  ", " -1", "{", "}"] {
        assert!(!text.contains(stranger), "{stranger:?} in {text:?}");
    }
    let ascii = Charset::Ascii.text(text);
    let unknown = |text: &str| text.matches('?').count();
    assert!(
        ascii.is_ascii() && unknown(&ascii) == unknown(text),
        "{text:?}"
    );
    let taken = wrap(&ascii, 28).len();
    assert!(taken <= lines, "{taken} lines: {text}");
}

#[test]
fn every_text_is_readable_and_fits() {
    let angles = [
        None,
        Some(-3.0),
        Some(-0.4),
        Some(0.0),
        Some(0.9),
        Some(2.0),
    ];
    for question in questions().take(cases(500, 2_000)) {
        assert_readable(&question.text, 10);
        let mut answers: Vec<Rays> = beliefs(question).map(|(_, rays, _)| rays).collect();
        answers.push(truth(question));
        for striker in angles {
            answers.extend(angles.map(|target| Rays { striker, target }));
        }
        for rays in answers {
            let explanation = explain(question, &sure(rays));
            assert_readable(&explanation.text, 13);
            assert!(explanation.title.len() <= 28);
            let sentences = explanation.text.matches(['.', ':']).count();
            assert!(sentences >= 2);
        }
    }
}

#[test]
fn a_round_has_ten_different_questions() {
    let mut left = 0;
    for (seed, round) in (0..).zip(ROUNDS.iter()) {
        assert_eq!(round.code().seed, seed);
        assert_eq!(round.questions().len(), 10);
        for (i, question) in round.questions().iter().enumerate() {
            assert!(!round.questions()[..i].contains(question));
            left += usize::from(side(question) < 0.0);
        }
    }
    // In nine out of ten questions, the target is on the left or the right. Half of these targets
    // should be on the left; the range is five standard deviations in each direction.
    assert!((8_660..9_340).contains(&left), "{left}");
}

#[test]
fn a_code_always_gives_the_same_round() {
    let rounds = [0, 1, 7, 42, 999_999, u64::MAX].map(|seed| {
        let round = Round::of(Code::hits(seed));
        let questions = round.questions().iter().map(|question| {
            let direction_deg = question.figures["direction_deg"].as_f64();
            format!("[{}°] {}\n", direction_deg.unwrap(), question.text)
        });
        format!("== {seed} ==\n{}", questions.collect::<String>())
    });
    insta::assert_snapshot!("rounds", rounds.join("\n"));
}

/// The summary of the answers to a round.
fn summary(round: &Round, answers: &[Answer]) -> Summary<'static> {
    let answered = (1..).zip(round.questions().iter().zip(answers));
    let attempt = |(number, (question, answer)): (u32, (&Question, &Answer))| {
        Attempt::of_quiz("Ada", round.code(), number, question, answer)
    };
    Summary::new(Vec::leak(answered.map(attempt).collect()))
}

#[test]
fn a_round_answered_according_to_one_misconception_names_it() {
    for misconception in ALL {
        for round in &ROUNDS[..50] {
            let answers: Vec<Answer> = round
                .questions()
                .iter()
                .map(|question| {
                    let held = beliefs(question).find(|(held, ..)| *held == misconception);
                    sure(held.map_or(truth(question), |(_, rays, _)| rays))
                })
                .collect();
            let summary = summary(round, &answers);
            let met = round.questions().len() - summary.right();
            // A single answer is not enough to name a misconception.
            if met > 1 {
                assert_eq!(summary.most_held(), Some(misconception));
                assert_eq!(summary.named()[0].times, met);
            } else {
                assert_eq!(summary.most_held(), None);
            }
            // The points of the round are the sum of the points of all questions, including
            // negative points.
            let each = summary.attempts.iter().map(Attempt::earned);
            let sum: f64 = each.sum();
            assert!((summary.points() - sum).abs() < 0.051 * answers.len() as f64);
            assert!(summary.points() <= summary.most());
        }
    }
}

#[test]
fn the_summaries_of_a_perfect_round_and_of_no_answers_are_right() {
    let round = Round::of(Code::hits(3));
    let answers: Vec<Answer> = round.questions().iter().map(|q| sure(truth(q))).collect();
    let summary = summary(&round, &answers);
    assert!((summary.points() - 100.0).abs() < 1e-9);
    assert_eq!(summary.right(), 10);
    assert!(summary.mean_error().is_some_and(|error| error < 1e-9));
    let [guess, _, sure] = calibration(summary.attempts).map(|it| it.tally);
    assert_eq!((sure.attempts, sure.right), (10, 10));
    assert_eq!((guess.attempts, guess.right), (0, 0));

    let none = Summary::new(&[]);
    assert_eq!(none.mean_error(), None);
    assert_eq!(none.calibration_words(), "");
    assert!(none.points().abs() < 1e-12);
}

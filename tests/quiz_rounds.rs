//! Rounds of the quiz over thousands of seeds: the truth is the truth, every
//! misconception is known by its answer, every text can be read.

use std::sync::LazyLock;

use carrom::quiz::misconceptions::{ALL, FIT_DEG};
use carrom::quiz::{
    Answer, Confidence, Fit, Given, Grade, Pieces, Question, Rays, Round, Summary, diagnose,
    explain,
};
use carrom::widgets::text::wrap;
use glam::DVec2;

const SEEDS: u64 = 2_000;

static ROUNDS: LazyLock<Vec<Round>> = LazyLock::new(|| (0..SEEDS).map(Round::new).collect());

fn questions() -> impl Iterator<Item = Question> {
    ROUNDS.iter().flat_map(Round::questions).copied()
}

fn sure(rays: Rays) -> Answer {
    Answer {
        rays,
        confidence: Confidence::Sure,
    }
}

/// The angle from `a` to `b`, anticlockwise; `None` if `b` is at rest.
fn turn(a: DVec2, b: DVec2) -> Option<f64> {
    (b.length() > 1e-9 * a.length()).then(|| a.perp_dot(b).atan2(a.dot(b)))
}

/// Where the two go, by an impulse along the line of centres.
fn by_impulse(question: &Question) -> Rays {
    let (m1, r1, m2, r2) = match question.pieces {
        Pieces::Equal => (15.0, 15.0, 15.0, 15.0),
        Pieces::Tournament => (15.0, 20.65, 5.5, 15.9),
        Pieces::Marbles => (20.0, 12.4, 40.0, 15.6),
        Pieces::Own { .. } => unreachable!("no round asks about own pieces"),
    };
    let u = question.speed * DVec2::from_angle(question.direction_deg.to_radians());
    let sine = match question.given {
        Given::Angle { alpha_deg } => alpha_deg.to_radians().sin(),
        Given::Offset { offset_mm } => offset_mm / (r1 + r2),
    };
    // The target's centre lies `sine` of the way to the right of the path.
    let right = DVec2::new(u.y, -u.x) / question.speed;
    let normal = u / question.speed * (1.0 - sine * sine).sqrt() + right * sine;
    let impulse = (1.0 + question.restitution) * u.dot(normal) / (1.0 / m1 + 1.0 / m2);
    Rays {
        striker: turn(u, u - impulse / m1 * normal),
        target: turn(impulse / m2 * normal, u),
    }
}

#[test]
fn the_truth_is_that_of_an_impulse_along_the_line_of_centres() {
    for question in questions() {
        let gap = question.truth().gap(&by_impulse(&question));
        assert!(gap < 1e-9, "{question:?}: off by {gap}");
    }
}

#[test]
fn the_truth_earns_all_and_is_never_diagnosed() {
    for question in questions() {
        let answer = sure(question.truth());
        let grade = Grade::new(&question, &answer);
        assert!(grade.is_right());
        assert!((grade.credit() - 1.0).abs() < 1e-12);
        assert!((grade.points() - Grade::MOST).abs() < 1e-12);
        assert_eq!(diagnose(&question, &answer), None);
        assert_eq!(explain(&question, &answer).title, "right");
    }
}

#[test]
fn each_misconception_is_known_by_its_answer() {
    let mut met = [0; ALL.len()];
    for question in questions() {
        for (i, misconception) in ALL.into_iter().enumerate() {
            let Some(prediction) = misconception.predict(&question) else {
                continue;
            };
            met[i] += 1;
            let answer = sure(prediction.rays);
            assert!(!Grade::new(&question, &answer).is_right());
            let diagnosis = diagnose(&question, &answer).expect("a diagnosis");
            assert_eq!(diagnosis.misconception, misconception, "{question:?}");
            assert_eq!(diagnosis.fit, Fit::Whole);
        }
    }
    for (misconception, times) in ALL.into_iter().zip(met) {
        assert!(times > 100, "{misconception:?} was met {times} times");
    }
}

#[test]
fn a_slip_of_the_hand_changes_no_diagnosis() {
    let slip = 0.99 * FIT_DEG.to_radians();
    let nudged = |rays: Rays, a: f64, b: f64| Rays {
        striker: rays.striker.map(|angle| angle + a * slip),
        target: rays.target.map(|angle| angle + b * slip),
    };
    for question in questions().take(2_000) {
        for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let right = sure(nudged(question.truth(), a, b));
            assert_eq!(diagnose(&question, &right), None);
            for misconception in ALL {
                if let Some(prediction) = misconception.predict(&question) {
                    let answer = sure(nudged(prediction.rays, a, b));
                    let diagnosis = diagnose(&question, &answer).expect("a diagnosis");
                    assert_eq!(diagnosis.misconception, misconception, "{question:?}");
                }
            }
        }
    }
}

#[test]
fn one_ray_that_gives_a_misconception_away_is_enough() {
    for question in questions().take(2_000) {
        for misconception in ALL {
            let Some(prediction) = misconception.predict(&question) else {
                continue;
            };
            let Some(ray) = prediction.telltale else {
                continue;
            };
            let wild = Some(-2.2 * question.side());
            let mut rays = prediction.rays;
            match ray {
                carrom::quiz::Ray::Striker => rays.target = wild,
                carrom::quiz::Ray::Target => rays.striker = wild,
            }
            let diagnosis = diagnose(&question, &sure(rays)).expect("a diagnosis");
            assert_eq!(diagnosis.fit, Fit::OneRay(ray), "{question:?}");
            let named = diagnosis
                .misconception
                .predict(&question)
                .expect("a prediction");
            let off = named.rays.apart(&prediction.rays, ray).expect("an angle");
            assert!(off <= FIT_DEG.to_radians());
        }
    }
}

/// As long as the panel beside the picture can take, even spelt out in ASCII.
fn assert_readable(text: &str, lines: usize) {
    for stranger in ["NaN", "inf", "-0.0", "  ", " -1", "{", "}"] {
        assert!(!text.contains(stranger), "{stranger:?} in {text:?}");
    }
    let ascii = text.replace('°', " deg");
    assert!(ascii.is_ascii(), "{text:?}");
    let taken = wrap(&ascii, 28).len();
    assert!(taken <= lines, "{taken} lines: {text}");
}

#[test]
fn every_text_can_be_read() {
    let angles = [
        None,
        Some(-3.0),
        Some(-0.4),
        Some(0.0),
        Some(0.9),
        Some(2.0),
    ];
    for question in questions().take(2_000) {
        assert_readable(&question.text(), 10);
        let mut answers: Vec<Rays> = ALL
            .into_iter()
            .filter_map(|misconception| misconception.predict(&question))
            .map(|prediction| prediction.rays)
            .collect();
        answers.push(question.truth());
        for striker in angles {
            answers.extend(angles.map(|target| Rays { striker, target }));
        }
        for rays in answers {
            let explanation = explain(&question, &sure(rays));
            assert_readable(&explanation.text, 12);
            assert!(explanation.title.len() <= 28);
            let sentences = explanation.text.matches(['.', ':']).count();
            assert!(sentences >= 2);
        }
    }
}

#[test]
fn a_round_is_ten_different_questions() {
    let mut left = 0;
    for (seed, round) in (0..).zip(ROUNDS.iter()) {
        assert_eq!(round.seed(), seed);
        assert_eq!(round.questions().len(), Round::LENGTH);
        for (i, question) in round.questions().iter().enumerate() {
            assert!(!round.questions()[..i].contains(question));
            left += usize::from(question.side() < 0.0);
        }
    }
    // Nine questions in ten have a side; five standard deviations about a half.
    assert!((8_660..9_340).contains(&left), "{left}");
}

#[test]
fn a_code_is_the_same_round_for_ever() {
    for seed in [0, 1, 7, 42, 999_999, u64::MAX] {
        let round = Round::new(seed);
        let text: Vec<String> = round
            .questions()
            .iter()
            .map(|question| format!("[{}°] {}", question.direction_deg, question.text()))
            .collect();
        insta::assert_snapshot!(format!("round_{seed}"), text.join("\n"));
    }
}

#[test]
fn a_round_of_one_belief_names_it() {
    for misconception in ALL {
        for round in &ROUNDS[..50] {
            let answers: Vec<Answer> = round
                .questions()
                .iter()
                .map(|question| {
                    let held = misconception.predict(question);
                    sure(held.map_or(question.truth(), |prediction| prediction.rays))
                })
                .collect();
            let summary = Summary::new(round.questions().iter().zip(&answers));
            let met = Round::LENGTH - summary.right();
            if met > 0 {
                assert_eq!(summary.most_held(), Some((misconception, met)));
                assert_eq!(summary.advice(), misconception.advice);
            } else {
                assert_eq!(summary.most_held(), None);
            }
            assert!(summary.points() >= 0.0 && summary.points() <= summary.most());
        }
    }
}

#[test]
fn the_summary_of_a_perfect_round_and_of_none() {
    let round = Round::new(3);
    let answers: Vec<Answer> = round.questions().iter().map(|q| sure(q.truth())).collect();
    let summary = Summary::new(round.questions().iter().zip(&answers));
    assert!((summary.points() - 100.0).abs() < 1e-9);
    assert_eq!(summary.right(), 10);
    assert!(summary.mean_error().is_some_and(|error| error < 1e-9));
    assert_eq!(summary.calibration(Confidence::Sure), (10, 10));
    assert_eq!(summary.calibration(Confidence::Guess), (0, 0));

    let none = Summary::new([]);
    assert_eq!(none.mean_error(), None);
    assert_eq!(none.calibration_words(), "");
    assert!(none.points().abs() < 1e-12);
}

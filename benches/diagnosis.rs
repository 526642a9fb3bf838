//! Measures how often carrom names the right misconception: `cargo bench --bench diagnosis`.
//!
//! Simulated students answer rounds of *Find out*, of the mixed course and of the older mixed
//! course. The benchmark prints how many of them have their own misconception named first. `-- 50`
//! simulates 50 students of each kind instead of 200.
//!
//! The code below calculates a student's rays and numbers without the grader's physics. From
//! several choices, the student picks the one that fits the belief. If the belief predicts nothing,
//! the student either guesses or knows the answer. Each angle has a random error of 2° (one
//! standard deviation), every other number one of 2 %.

use std::f64::consts::{PI, TAU};
use std::thread;

use carrom::quiz::{
    Answer, Clue, Code, Confidence, Course, CourseKind, Form, Measure, Misconception, Question,
    Ray, Rays, Response, Round, named,
};
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// The standard deviation of an angle, in degrees, and of any other number, as a fraction of that
/// number.
const NOISE: (f64, f64) = (2.0, 0.02);

/// What a student believes.
#[derive(Clone, Copy, PartialEq)]
enum Belief {
    /// Both discs leave at the impact angle.
    CopiesTheAngle,
    /// Both discs leave at 45°.
    HalfAndHalf,
    /// The angle between the paths is 90°, whatever the masses and the loss.
    AlwaysSquare,
    /// All answers are calculated as for equal masses.
    IgnoresMass,
    /// Both angles are right, but exchanged.
    Swapped,
    /// A heavier striker goes straight on; a heavier target reflects the striker like a wall.
    HeavyUnmoved,
    /// The head-on formula is used for the whole velocity, at any angle.
    HeadOnFormula,
    /// The right angle is in the centre-of-mass frame, and every angle in that frame is confused
    /// with the angle in the laboratory frame.
    SquareInTheCentreFrame,
    /// No misconception; every answer is right.
    Knows,
    /// No misconception; every answer is a guess.
    Guesses,
}

use Belief::*;

impl Belief {
    const ALL: [Self; 10] = [
        CopiesTheAngle,
        HalfAndHalf,
        AlwaysSquare,
        IgnoresMass,
        Swapped,
        HeavyUnmoved,
        HeadOnFormula,
        SquareInTheCentreFrame,
        Knows,
        Guesses,
    ];

    fn name(self) -> &'static str {
        match self {
            CopiesTheAngle => "copies the angle",
            HalfAndHalf => "45/45",
            AlwaysSquare => "always 90°",
            IgnoresMass => "ignores mass",
            Swapped => "swapped",
            HeavyUnmoved => "heavier unmoved",
            HeadOnFormula => "head-on formula",
            SquareInTheCentreFrame => "90° in the centre's frame",
            Knows => "knows",
            Guesses => "guesses",
        }
    }

    /// The misconception that carrom should name.
    fn right(self) -> Option<Misconception> {
        Some(match self {
            CopiesTheAngle => Misconception::CopiedAngle,
            HalfAndHalf => Misconception::HalfAndHalf,
            AlwaysSquare | IgnoresMass => Misconception::AlwaysSquare,
            Swapped => Misconception::Swapped,
            HeavyUnmoved => Misconception::HeavyUnmoved,
            HeadOnFormula => Misconception::OneLineFormula,
            SquareInTheCentreFrame => Misconception::FramesMixed,
            Knows | Guesses => return None,
        })
    }
}

/// A simulated student.
struct Student {
    belief: Belief,
    /// Whether the student knows the answer if the belief predicts nothing; otherwise they guess.
    knows_elsewhere: bool,
    dice: Pcg64,
}

/// The numbers in a question about a collision with a target at rest.
struct HitFigures {
    m1: f64,
    m2: f64,
    /// The impact angle, in degrees.
    alpha: f64,
    e: f64,
    u: f64,
}

impl HitFigures {
    fn read(question: &Question) -> Option<Self> {
        let figure = |name: &str| question.figures.get(name)?.as_f64();
        let alpha = match figure("alpha_deg") {
            Some(alpha) => alpha.abs(),
            None => {
                let reach = figure("r1_mm")? + figure("r2_mm")?;
                (figure("offset_mm")?.abs() / reach).asin().to_degrees()
            }
        };
        Some(Self {
            m1: figure("m1_g")?,
            m2: figure("m2_g")?,
            alpha,
            e: figure("restitution")?,
            u: figure("speed")?,
        })
    }

    /// The angles of striker and target in degrees from the original direction, each positive on its
    /// own side, from the impulse along the line of centres; `None` for a disc that stays at rest.
    fn angles(&self) -> (Option<f64>, Option<f64>) {
        let (sin, cos) = self.alpha.to_radians().sin_cos();
        let given_up = (1.0 + self.e) * self.m2 / (self.m1 + self.m2) * cos;
        // The striker's final velocity: forwards, and to the side away from the target.
        let (ahead, aside) = (1.0 - given_up * cos, given_up * sin);
        let moves = ahead.hypot(aside) > 1e-9;
        (
            moves.then(|| aside.atan2(ahead).to_degrees()),
            Some(self.alpha),
        )
    }

    /// The same collision with equal masses.
    fn as_equals(&self) -> Self {
        Self {
            m1: self.m1,
            m2: self.m1,
            ..*self
        }
    }

    /// Both speeds after the collision, as if it were head-on.
    fn head_on_speeds(&self) -> (f64, f64) {
        let all = self.m1 + self.m2;
        (
            ((self.m1 - self.e * self.m2) / all * self.u).abs(),
            (1.0 + self.e) * self.m1 / all * self.u,
        )
    }
}

/// The rays that a student predicts, in degrees, each positive on its own side; `None` for a disc
/// that stays at rest.
type Angles = (Option<f64>, Option<f64>);

impl Student {
    fn new(belief: Belief, knows_elsewhere: bool, seed: u64) -> Self {
        Self {
            belief,
            knows_elsewhere,
            dice: Pcg64::seed_from_u64(seed),
        }
    }

    fn uniform(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.dice.random::<f64>()
    }

    /// A random number from the standard normal distribution (Box and Muller).
    fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.dice.random::<f64>()).ln()).sqrt();
        radius * (TAU * self.dice.random::<f64>()).cos()
    }

    /// The student's answer to a question.
    fn answer(&mut self, question: &Question) -> Answer {
        let said = match self.believed(question) {
            Some(said) => self.with_noise(question, said),
            None if self.belief == Knows || self.belief != Guesses && self.knows_elsewhere => {
                self.with_noise(question, question.form.truth())
            }
            None => self.guess(question),
        };
        Answer::new(said, Confidence::ThinkSo)
    }

    /// The answer that the belief predicts, if any.
    fn believed(&self, question: &Question) -> Option<Response> {
        match &question.form {
            Form::Rays { side, .. } => {
                let (striker, target) = self.angles(&HitFigures::read(question)?)?;
                let turned = |angle: Option<f64>| angle.map(|deg| side * deg.to_radians());
                Some(Response::Rays(Rays {
                    striker: turned(striker),
                    target: turned(target),
                }))
            }
            Form::Number { .. } => self.number(question).map(Response::Number),
            Form::Choice { .. } => {
                let right = self.belief.right()?;
                let held = question.beliefs.iter();
                held.clone()
                    .find(|it| it.misconception == right)
                    .map(|it| it.said)
            }
            Form::Shot(aim) => {
                let wanted = aim.wanted.abs().to_degrees();
                let alpha = match (self.belief, aim.ray) {
                    (CopiesTheAngle, Ray::Striker) => wanted,
                    (AlwaysSquare | IgnoresMass, Ray::Striker) => 90.0 - wanted,
                    _ => return None,
                };
                let offset = aim.collision.contact_distance() * alpha.to_radians().sin();
                (alpha > 0.0).then(|| Response::Shot(aim.offset.signum() * offset))
            }
        }
    }

    /// The directions that the belief predicts for both discs.
    fn angles(&self, hit: &HitFigures) -> Option<Angles> {
        let both = |striker: f64, target: f64| Some((Some(striker), Some(target)));
        match self.belief {
            CopiesTheAngle => both(hit.alpha, hit.alpha),
            HalfAndHalf => both(45.0, 45.0),
            AlwaysSquare => both(90.0 - hit.alpha, hit.alpha),
            IgnoresMass => Some(hit.as_equals().angles()),
            Swapped => {
                let (striker, target) = hit.angles();
                Some((target, striker))
            }
            HeavyUnmoved if hit.m1 > hit.m2 => both(0.0, hit.alpha),
            HeavyUnmoved if hit.m1 < hit.m2 => Some((Some(180.0 - 2.0 * hit.alpha), None)),
            _ => None,
        }
    }

    /// The number that the belief predicts.
    fn number(&self, question: &Question) -> Option<f64> {
        let asked = question.figures.get("asked").and_then(|it| it.as_str());
        let asked = asked.unwrap_or_default();
        let family = question.family.id();
        let figure = |name: &str| question.figures.get(name)?.as_f64();
        if family == "both-moving" {
            let [u1, u2] = ["speed", "target_speed"].map(figure);
            return match (self.belief, asked) {
                // Equal discs exchange their whole velocities.
                (HeadOnFormula, "striker-speed") => u2,
                (HeadOnFormula, "target-speed") => u1,
                (HalfAndHalf | AlwaysSquare | IgnoresMass, "separation") => Some(90.0),
                (SquareInTheCentreFrame, "separation") => Some(180.0),
                _ => None,
            };
        }
        if (family, asked) == ("centre-of-mass", "theta1") || asked == "theta2" {
            return match self.belief {
                SquareInTheCentreFrame => figure("turn_deg"),
                Swapped => {
                    let (theta1, theta2) = HitFigures::read(question)?.angles();
                    if asked == "theta1" { theta2 } else { theta1 }
                }
                _ => None,
            };
        }
        let hit = HitFigures::read(question)?;
        let parting = matches!(family, "separation") || asked == "separation";
        if parting {
            let (striker, target) = self.angles(&hit)?;
            return match (striker, target) {
                (Some(striker), Some(target)) if self.belief != Swapped => Some(striker + target),
                _ => None,
            };
        }
        match (self.belief, family, asked) {
            (CopiesTheAngle, "centre-of-mass", "turn") => Some(hit.alpha),
            (SquareInTheCentreFrame, "centre-of-mass", "turn") => hit.angles().0,
            (HeadOnFormula, "speeds", "striker") => Some(hit.head_on_speeds().0),
            (HeadOnFormula, "speeds", "target") => Some(hit.head_on_speeds().1),
            (IgnoresMass, "speeds", "target") => {
                let equal = hit.as_equals();
                Some(equal.head_on_speeds().1 * hit.alpha.to_radians().cos())
            }
            (IgnoresMass, "centre-of-mass", "centre-speed") => {
                Some((hit.u + figure("target_speed").unwrap_or(0.0)) / 2.0)
            }
            (IgnoresMass, "weigh", _) => Some(hit.m1),
            (AlwaysSquare | IgnoresMass, _, "striker mass") => Some(hit.m2),
            (HalfAndHalf, "energy-share", "kept" | "passed") => Some(50.0),
            (HalfAndHalf, "largest-deflection", "alpha") => Some(45.0),
            (CopiesTheAngle, "largest-deflection", "alpha") => hit.angles().0,
            (HeavyUnmoved, "largest-deflection", "theta1") => Some(0.0),
            _ => None,
        }
    }

    /// The same answer with random errors.
    fn with_noise(&mut self, question: &Question, said: Response) -> Response {
        let (angle, share) = NOISE;
        match said {
            Response::Rays(rays) => {
                let mut shaken =
                    |it: Option<f64>| it.map(|it| it + (angle * self.normal()).to_radians());
                Response::Rays(Rays {
                    striker: shaken(rays.striker),
                    target: shaken(rays.target),
                })
            }
            Response::Number(x) => Response::Number(match question.form {
                Form::Number {
                    quantity: Measure::Angle,
                    ..
                } => x + angle * self.normal(),
                _ => x * (1.0 + share * self.normal()),
            }),
            Response::Shot(offset) => Response::Shot(offset * (1.0 + share * self.normal())),
            choice @ Response::Choice(_) => choice,
        }
    }

    /// A guess: rays anywhere in the quarter turn on their own side or, sometimes, on the other;
    /// angles within a quarter or a half turn, shares and e anywhere, other numbers within a
    /// factor of two.
    fn guess(&mut self, question: &Question) -> Response {
        match &question.form {
            Form::Rays { side, .. } => {
                let mut ray = || {
                    let sign = if self.dice.random::<f64>() < 0.9 {
                        1.0
                    } else {
                        -1.0
                    };
                    Some(side * sign * self.dice.random::<f64>() * PI / 2.0)
                };
                Response::Rays(Rays {
                    striker: ray(),
                    target: ray(),
                })
            }
            Form::Number { quantity, truth } => Response::Number(match quantity {
                Measure::Angle if *truth > 90.0 => self.uniform(0.0, 180.0),
                Measure::Angle => self.uniform(0.0, 90.0),
                Measure::Share => self.uniform(0.0, 100.0),
                Measure::Restitution => self.uniform(0.0, 1.0),
                _ => truth * self.uniform(-1.0, 1.0).exp2(),
            }),
            Form::Choice { options, .. } => {
                Response::Choice((self.dice.next_u64() % options.len() as u64) as usize)
            }
            Form::Shot(aim) => {
                Response::Shot(aim.collision.contact_distance() * self.uniform(-1.0, 1.0))
            }
        }
    }

    /// Answers a whole round; returns the evidence in the answers.
    fn play(&mut self, code: Code) -> Vec<Clue> {
        let mut round = Round::of(code);
        let mut answers: Vec<Answer> = Vec::new();
        while let Some(question) = round.questions().get(answers.len()) {
            answers.push(self.answer(question));
            round.go_on(&answers);
        }
        let answered = round.questions().iter().zip(&answers);
        answered
            .map(|(question, answer)| Clue::new(question, answer))
            .collect()
    }
}

/// The results of many students of one kind in one course.
#[derive(Default)]
struct Outcome {
    students: usize,
    /// The number of students whose misconception is named first; for students without one, the
    /// number for whom any is named.
    named: usize,
    /// The wrong misconceptions that were named first.
    others: Vec<Misconception>,
    /// The number of questions that each student was asked, in ascending order.
    asked: Vec<usize>,
}

fn outcome(belief: Belief, knows: bool, course: &Course, students: u64) -> Outcome {
    let mut outcome = Outcome::default();
    for seed in 0..students {
        let mut student = Student::new(belief, knows, 1_000 + seed);
        let code = Code {
            course: course.clone(),
            seed,
        };
        let clues = student.play(code);
        let first = named(&clues).first().map(|it| it.misconception);
        outcome.students += 1;
        outcome.asked.push(clues.len());
        if first.is_some() && (first == belief.right() || belief.right().is_none()) {
            outcome.named += 1;
        }
        outcome
            .others
            .extend(first.filter(|it| Some(*it) != belief.right()));
    }
    outcome.asked.sort_unstable();
    outcome
}

/// The misconceptions in a list, each with its count.
fn counted(misconceptions: &[Misconception]) -> String {
    let count = |it: &Misconception| misconceptions.iter().filter(|other| *other == it).count();
    let mut all: Vec<_> = Misconception::ALL
        .iter()
        .map(|it| (count(it), it.id()))
        .collect();
    all.retain(|(count, _)| *count > 0);
    all.sort_by(|a, b| b.cmp(a));
    let each = all
        .iter()
        .take(4)
        .map(|(count, id)| format!("{id} {count}"));
    each.collect::<Vec<_>>().join(", ")
}

fn main() {
    let students = std::env::args().filter_map(|arg| arg.parse().ok()).next();
    let students = students.unwrap_or(200);
    let courses = [
        ("find out, at most 12", Course::new(CourseKind::FindOut)),
        ("mixed, 20", Course::of(CourseKind::Even, 20)),
        ("mixed, 10", Course::of(CourseKind::Even, 10)),
        ("older mixed, 20", Course::of(CourseKind::Mixed, 20)),
        ("older mixed, 10", Course::of(CourseKind::Mixed, 10)),
    ];
    println!("{students} students of each kind; the share whose own misconception is named first");
    println!("(for students who know or guess: the share for whom any is named)\n");
    let only = std::env::args().find_map(|arg| arg.strip_prefix("only=").map(str::to_owned));
    for (name, course) in &courses {
        if only
            .as_ref()
            .is_some_and(|only| !name.starts_with(only.as_str()))
        {
            continue;
        }
        println!("{name}");
        let kinds: Vec<(Belief, bool)> = Belief::ALL
            .into_iter()
            .flat_map(|belief| match belief.right() {
                Some(_) => vec![(belief, false), (belief, true)],
                None => vec![(belief, belief == Knows)],
            })
            .collect();
        let of = |kinds: &[(Belief, bool)]| -> Vec<Outcome> {
            let each = kinds.iter();
            each.map(|(belief, knows)| outcome(*belief, *knows, course, students))
                .collect()
        };
        let (first, second) = kinds.split_at(kinds.len() / 2);
        let outcomes: Vec<Outcome> = thread::scope(|scope| {
            let second = scope.spawn(|| of(second));
            let mut all = of(first);
            all.extend(second.join().unwrap_or_default());
            all
        });
        for ((belief, knows), outcome) in kinds.iter().zip(outcomes) {
            let elsewhere = match (belief.right(), knows) {
                (None, _) => "",
                (_, true) => "else knows",
                (_, false) => "else guesses",
            };
            println!(
                "  {:27}{elsewhere:14}{:5.1} %  median {:2} questions  {}",
                belief.name(),
                100.0 * outcome.named as f64 / outcome.students as f64,
                outcome
                    .asked
                    .get(outcome.asked.len() / 2)
                    .copied()
                    .unwrap_or(0),
                counted(&outcome.others),
            );
        }
        println!();
    }
}

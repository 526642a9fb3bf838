//! Simulated students. The rays and numbers of their answers are calculated here, without the
//! grader's code. Among choices, they take the one that agrees with their belief. If their belief
//! gives no answer, they either guess or know the right answer. Every angle has a random error with
//! a standard deviation of 2°, and every other number has a relative error with a standard
//! deviation of 2 %.

use std::f64::consts::{PI, TAU};

use carrom::quiz::{
    Answer, Confidence, Form, Measure, Misconception, Question, Ray, Rays, Response,
};
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// The standard deviation of an angle, in degrees, and the relative standard deviation of any other
/// number.
const NOISE: (f64, f64) = (2.0, 0.02);

/// What a student believes.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Belief {
    /// Both leave at the impact angle.
    CopiesTheAngle,
    /// Both leave at 45°.
    HalfAndHalf,
    /// The angle between the paths is always 90°, whatever the masses and the loss.
    AlwaysSquare,
    /// All masses are treated as equal.
    IgnoresMass,
    /// Both angles are right, but swapped.
    Swapped,
    /// A heavier striker goes straight on; a heavier target reflects the striker like a wall.
    HeavyUnmoved,
    /// The head-on formula is used with the whole velocity, at any angle.
    HeadOnFormula,
    /// The 90° between the paths is expected in the centre-of-mass frame, and the angles of that
    /// frame are confused with those of the laboratory frame.
    SquareInTheCentreFrame,
    /// No misconception; every answer is right.
    Knows,
    /// No misconception; every answer is a guess.
    Guesses,
}

use Belief::*;

impl Belief {
    pub(crate) const ALL: [Self; 10] = [
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

    pub(crate) fn name(self) -> &'static str {
        match self {
            CopiesTheAngle => "copies the angle",
            HalfAndHalf => "45/45",
            AlwaysSquare => "always 90°",
            IgnoresMass => "ignores mass",
            Swapped => "swapped",
            HeavyUnmoved => "heavier unmoved",
            HeadOnFormula => "head-on formula",
            SquareInTheCentreFrame => "90° in the CM frame",
            Knows => "knows",
            Guesses => "guesses",
        }
    }

    /// The misconception that should be named.
    pub(crate) fn right(self) -> Option<Misconception> {
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

pub(crate) struct Student {
    pub(crate) belief: Belief,
    /// Whether they know the answer when their belief gives none; otherwise they guess.
    pub(crate) knows_elsewhere: bool,
    pub(crate) dice: Pcg64,
}

/// The figures of a question about a hit on a target at rest, as a student reads them.
struct HitFigures {
    m1: f64,
    m2: f64,
    /// Impact angle, in degrees.
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

    /// The angles of the striker and the target to the original direction, in degrees, each
    /// positive on its own side, calculated from the impulse along the line of impact; `None` for a
    /// striker that stops.
    fn angles(&self) -> (Option<f64>, Option<f64>) {
        let (sin, cos) = self.alpha.to_radians().sin_cos();
        let given_up = (1.0 + self.e) * self.m2 / (self.m1 + self.m2) * cos;
        // The components of the striker's final velocity, as fractions of its initial speed:
        // straight ahead, and sideways, away from the target.
        let (ahead, aside) = (1.0 - given_up * cos, given_up * sin);
        let moves = ahead.hypot(aside) > 1e-9;
        (
            moves.then(|| aside.atan2(ahead).to_degrees()),
            Some(self.alpha),
        )
    }

    /// The same hit with equal masses.
    fn as_equals(&self) -> Self {
        Self {
            m1: self.m1,
            m2: self.m1,
            ..*self
        }
    }

    /// Both final speeds by the head-on formula, which ignores the angle.
    fn head_on_speeds(&self) -> (f64, f64) {
        let all = self.m1 + self.m2;
        (
            ((self.m1 - self.e * self.m2) / all * self.u).abs(),
            (1.0 + self.e) * self.m1 / all * self.u,
        )
    }
}

/// The rays that a student predicts, in degrees, each positive on its own side; `None` for a disc
/// that is at rest afterwards.
type Angles = (Option<f64>, Option<f64>);

impl Student {
    pub(crate) fn new(belief: Belief, knows_elsewhere: bool, seed: u64) -> Self {
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

    pub(crate) fn answer(&mut self, question: &Question) -> Answer {
        let said = match self.believed(question) {
            Some(said) => self.with_noise(question, said),
            None if self.belief == Knows || self.belief != Guesses && self.knows_elsewhere => {
                self.with_noise(question, question.form.truth())
            }
            None => self.guess(question),
        };
        Answer::new(said, Confidence::ThinkSo)
    }

    /// The answer that follows from their belief, if there is one.
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

    /// The angles that they predict.
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

    /// The number that follows from their belief; it depends on what is asked for.
    fn number(&self, question: &Question) -> Option<f64> {
        let asked = question.figures.get("asked").and_then(|it| it.as_str());
        let asked = asked.unwrap_or_default();
        let family = question.family.id();
        let figure = |name: &str| question.figures.get(name)?.as_f64();
        if family == "both-moving" {
            let [u1, u2] = ["speed", "target_speed"].map(figure);
            return match (self.belief, asked) {
                // By the head-on formula, equal discs exchange their whole velocities.
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

    /// The answer with a random error.
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

    /// A guess: each ray anywhere in the quadrant on its own side, or sometimes on the other; an
    /// angle up to 90° or 180°; any share or e; any other number within a factor of two.
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
}

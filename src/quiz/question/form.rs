//! How a question is answered, and the correct answer.

use crate::physics::Collision;
use crate::physics::units::{deg_from_rad, mm_from_m};

use super::tolerance::{NUMBER_BY_CHANCE, RAYS_BY_CHANCE, RIGHT_DEG, is_within};
use super::{Measure, Ray, Rays, Response};
use crate::numbers::millimetres;

/// How a question is answered, and the correct answer.
#[derive(Debug, Clone, PartialEq)]
pub enum Form {
    /// The answer consists of two rays, which the player turns or types.
    Rays {
        /// Where the two discs actually go.
        truth: Rays,
        /// The side on which the target lies: 1 for the right, −1 for the left.
        side: f64,
        /// The name of the target.
        target: &'static str,
    },
    /// The answer is a number.
    Number {
        /// The quantity that the number measures.
        quantity: Measure,
        /// The true value, in the unit of the quantity.
        truth: f64,
    },
    /// The answer is one of several options.
    Choice {
        /// The options, of which there are two to five.
        options: Vec<String>,
        /// The index of the right option, counted from 0.
        right: usize,
    },
    /// The player sets the offset of a shot.
    Shot(AimTask),
}

/// A shot that has to send one of the two discs in a given direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AimTask {
    /// The hit as a head-on collision; the player sets the offset.
    pub collision: Collision,
    /// The disc that has to go in the required direction.
    pub ray: Ray,
    /// The required direction: θ₁ or θ₂ in radians, with the signs of [`Rays`].
    pub wanted: f64,
    /// An offset, in metres, that sends the disc in this direction.
    pub offset: f64,
}

impl AimTask {
    /// Where the two discs go with this offset, in metres; `None` if the shot misses.
    pub(crate) fn rays(&self, offset: f64) -> Option<Rays> {
        let outcome = self.with(offset).outcome();
        outcome.hit().then(|| Rays::from(&outcome))
    }

    /// The hit with this offset, in metres.
    pub(crate) fn with(&self, offset: f64) -> Collision {
        Collision {
            offset,
            ..self.collision
        }
    }

    /// The largest offset that can be set, in millimetres on either side: slightly more than for a
    /// graze.
    pub(crate) fn furthest_offset_mm(&self) -> f64 {
        (1.1 * mm_from_m(self.collision.contact_distance())).ceil()
    }

    /// The error of the disc's direction with this offset, in radians from 0 to π; `None` if the
    /// disc does not move or if the shot misses.
    pub(crate) fn error(&self, offset: f64) -> Option<f64> {
        let wanted = Rays::new(self.wanted, self.wanted);
        self.rays(offset)?.apart(&wanted, self.ray)
    }
}

impl Form {
    /// Whether an answer is of the kind that the form requires, and is in range.
    ///
    /// Answers come from devices, files and databases that anybody can change. Each answer is
    /// checked here before it is used, so that later code can rely on it.
    pub fn accepts(&self, said: &Response) -> bool {
        match (self, said) {
            (Self::Rays { .. }, Response::Rays(rays)) => rays.are_in_range(),
            (Self::Number { quantity, .. }, Response::Number(x)) => quantity.allows(*x),
            (Self::Choice { options, .. }, Response::Choice(i)) => *i < options.len(),
            (Self::Shot(aim), Response::Shot(offset)) => {
                let most = aim.furthest_offset_mm();
                is_within(mm_from_m(*offset), -most, most)
            }
            _ => false,
        }
    }

    /// The probability that a guess fits one given answer.
    pub(crate) fn by_chance(&self) -> f64 {
        match self {
            Self::Rays { .. } => RAYS_BY_CHANCE,
            Self::Number { .. } | Self::Shot(_) => NUMBER_BY_CHANCE,
            Self::Choice { options, .. } => 1.0 / options.len().max(2) as f64,
        }
    }

    /// The right answer.
    pub fn truth(&self) -> Response {
        match self {
            Self::Rays { truth, .. } => Response::Rays(*truth),
            Self::Number { truth, .. } => Response::Number(*truth),
            Self::Choice { right, .. } => Response::Choice(*right),
            Self::Shot(aim) => Response::Shot(aim.offset),
        }
    }

    /// The distance of an answer from `truth` or from the answer that a misconception leads to, in
    /// units of the tolerance: 0 means the same answer, and 1 is the largest distance that counts
    /// as right. The distance between answers of different kinds is infinite.
    pub fn distance(&self, said: &Response, truth: &Response) -> f64 {
        match (self, said, truth) {
            (Self::Number { quantity, .. }, Response::Number(said), Response::Number(truth)) => {
                quantity.distance(*said, *truth)
            }
            _ => self.spacing(said, truth),
        }
    }

    /// The largest error in either direction with which an answer still counts as `said`: in the
    /// unit of its quantity for a number, in degrees for a ray, in metres for an offset.
    pub(crate) fn tolerance(&self, said: &Response) -> f64 {
        match (self, said) {
            (Self::Number { quantity, .. }, Response::Number(x)) => quantity.tolerance(*x),
            (Self::Shot(aim), Response::Shot(offset)) => {
                let graze = aim.collision.contact_distance().copysign(*offset);
                let errors = [0.0, graze].map(|mut far| {
                    // The direction changes monotonically with the offset, so bisection finds the
                    // limit.
                    let mut near = *offset;
                    for _ in 0..40 {
                        let middle = f64::midpoint(near, far);
                        match self.distance(&Response::Shot(middle), said) <= 1.0 {
                            true => near = middle,
                            false => far = middle,
                        }
                    }
                    (near - offset).abs()
                });
                errors[0].max(errors[1])
            }
            _ => RIGHT_DEG,
        }
    }

    /// The distance between two answers in units of the largest tolerance: see
    /// [`Measure::spacing`].
    pub(crate) fn spacing(&self, a: &Response, b: &Response) -> f64 {
        let angle = |angle: f64| deg_from_rad(angle) / RIGHT_DEG;
        match (self, a, b) {
            (Self::Rays { .. }, Response::Rays(a), Response::Rays(b)) => angle(a.gap(b)),
            (Self::Number { quantity, .. }, Response::Number(a), Response::Number(b)) => {
                quantity.spacing(*a, *b)
            }
            (Self::Choice { .. }, Response::Choice(a), Response::Choice(b)) if a == b => 0.0,
            (Self::Shot(aim), Response::Shot(a), Response::Shot(b)) => {
                match (aim.rays(*a), aim.rays(*b)) {
                    (None, None) => 0.0,
                    (Some(a), Some(b)) => a.apart(&b, aim.ray).map_or(f64::INFINITY, angle),
                    _ => f64::INFINITY,
                }
            }
            _ => f64::INFINITY,
        }
    }

    /// An answer in words, of any length: "striker 60.0° left, coin 30.0° right".
    pub fn words(&self, said: &Response) -> String {
        match (self, said) {
            (Self::Rays { target, .. }, Response::Rays(rays)) => rays.words(target),
            (Self::Number { quantity, .. }, Response::Number(x)) => quantity.print(*x),
            (Self::Choice { options, .. }, Response::Choice(i)) => {
                options.get(*i).cloned().unwrap_or_else(|| "-".into())
            }
            (Self::Shot(_), Response::Shot(offset)) => {
                let length = millimetres(mm_from_m(offset.abs()));
                match *offset {
                    offset if offset > 0.0 => format!("offset {length} right"),
                    offset if offset < 0.0 => format!("offset {length} left"),
                    _ => "head-on".into(),
                }
            }
            _ => "-".into(),
        }
    }

    /// An answer in at most ten columns, for a table: "60 30", "63.4°", "B", "12.5 mm". The signs
    /// of the rays are relative to the side on which the target lies, as they are while the player
    /// turns the rays.
    pub(crate) fn brief(&self, said: &Response) -> String {
        match (self, said) {
            (Self::Rays { side, .. }, Response::Rays(rays)) => {
                let whole = |ray| match rays.get(ray) {
                    Some(angle) => format!("{:.0}", (side * deg_from_rad(angle)).round() + 0.0),
                    None => "rest".into(),
                };
                format!("{:>4}{:>5}", whole(Ray::Striker), whole(Ray::Target))
            }
            (Self::Choice { .. }, Response::Choice(i)) => letter(*i).to_string(),
            (Self::Shot(_), Response::Shot(offset)) => {
                format!("{:.1} mm", mm_from_m(offset.abs()))
            }
            _ => self.words(said),
        }
    }
}

/// The letter of a choice, such as "A"; choices are counted from 0.
pub fn letter(choice: usize) -> char {
    u8::try_from(choice)
        .ok()
        .filter(|i| *i < 26)
        .map_or('?', |i| char::from(b'A' + i))
}

//! The parts of a question that a pupil's device receives: the text and the picture, and later the
//! right answer. A [`Question`] itself is never sent, because it contains the answer.

use glam::DVec2;
use serde::{Deserialize, Serialize};
use serde_json::Map;

use super::ballot::Said;
use crate::physics::resting_target::mass_ratio_from_angles;
use crate::physics::rutherford::Rutherford;
use crate::physics::{Bond, Collision, Disc, Rims};
use crate::quiz::{
    AimTask, Difficulty, Family, Form, Illustration, Markings, Measure, Pieces, Question, Ray,
    Rays, Response,
};

/// A question as a pupil's device receives it, without the answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AskedQuestion {
    /// The id of the question's family.
    family: String,
    text: String,
    form: AskedForm,
    picture: AskedPicture,
}

/// How a question is answered, without the answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum AskedForm {
    /// The answer is two rays; `side` is the target's side, and `target` is its name.
    Rays { side: f64, target: String },
    /// The answer is a number; `measure` is the name of its quantity in files.
    Number { measure: String },
    /// The answer is one of these options.
    Choice { options: Vec<String> },
    /// The answer is a shot that sends the striker or the target in this direction, in radians.
    Shot {
        hit: AskedHit,
        striker: bool,
        wanted: f64,
    },
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum AskedPicture {
    Nothing,
    Before {
        hit: AskedHit,
        /// Whether the picture shows the offset, the impact angle and the numbers.
        shown: [bool; 3],
    },
    /// Both angles in radians, both radii, and the striker's initial direction: many masses and
    /// energy losses are consistent with them.
    After {
        angles: [f64; 2],
        radii: [f64; 2],
        along: [f64; 2],
    },
    /// Two angles, and the closest approach in a head-on collision.
    Tracks {
        angles: [f64; 2],
        nearest: f64,
    },
}

/// The visible properties of two discs about to collide, without e and the kind of contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct AskedHit {
    masses: [f64; 2],
    radii: [f64; 2],
    u: [[f64; 2]; 2],
    offset: f64,
    offset_rest: f64,
}

impl AskedHit {
    fn of(collision: &Collision) -> Self {
        let discs = [collision.striker, collision.target];
        Self {
            masses: discs.map(|disc| disc.mass),
            radii: discs.map(|disc| disc.radius),
            u: [collision.u1, collision.u2].map(Into::into),
            offset: collision.offset,
            offset_rest: collision.offset_rest,
        }
    }

    /// The collision; `None` if the numbers are invalid.
    fn collision(&self) -> Option<Collision> {
        let mut sizes = self.masses.iter().chain(&self.radii);
        let mut others = { self.u.iter() }
            .flatten()
            .chain([&self.offset, &self.offset_rest]);
        let is_good = sizes.all(|x| x.is_finite() && *x > 0.0) && others.all(|x| x.is_finite());
        let disc = |i: usize| Disc {
            mass: self.masses[i],
            radius: self.radii[i],
        };
        is_good.then(|| Collision {
            u2: self.u[1].into(),
            offset_rest: self.offset_rest,
            ..Collision::at_offset(disc(0), disc(1), self.u[0].into(), self.offset)
        })
    }
}

impl AskedQuestion {
    /// The parts of a question that are sent while it is open.
    pub fn new(question: &Question) -> Self {
        Self {
            family: question.family.id().into(),
            text: question.text.clone(),
            form: match &question.form {
                Form::Rays { side, target, .. } => AskedForm::Rays {
                    side: *side,
                    target: (*target).into(),
                },
                Form::Number { quantity, .. } => AskedForm::Number {
                    measure: quantity.id().into(),
                },
                Form::Choice { options, .. } => AskedForm::Choice {
                    options: options.clone(),
                },
                Form::Shot(aim) => AskedForm::Shot {
                    hit: AskedHit::of(&aim.with(0.0)),
                    striker: aim.ray == Ray::Striker,
                    wanted: aim.wanted,
                },
            },
            picture: match &question.picture {
                Illustration::Nothing => AskedPicture::Nothing,
                Illustration::Before { collision, shown } => AskedPicture::Before {
                    hit: AskedHit::of(collision),
                    shown: [shown.offset, shown.angle, shown.figures],
                },
                Illustration::After { collision } => {
                    let outcome = collision.outcome();
                    match (outcome.theta1, outcome.theta2) {
                        (Some(theta1), Some(theta2)) => AskedPicture::After {
                            angles: [theta1, theta2],
                            radii: [collision.striker.radius, collision.target.radius],
                            along: collision.u1.normalize_or_zero().into(),
                        },
                        _ => AskedPicture::Nothing,
                    }
                }
                Illustration::Tracks { rutherford, angles } => AskedPicture::Tracks {
                    angles: *angles,
                    nearest: rutherford.head_on_approach,
                },
            },
        }
    }

    /// A question that can be drawn and answered, built only from what was sent: its right answer
    /// is meaningless. `None` if the message is invalid.
    pub fn question(&self) -> Option<Question> {
        Some(Question {
            family: Family::with_id(&self.family)?,
            difficulty: Difficulty::Easy,
            topic: "".into(),
            text: self.text.clone(),
            picture: self.picture.illustration()?,
            form: self.form.form()?,
            beliefs: Vec::new(),
            replies: std::collections::BTreeMap::new(),
            why: String::new(),
            figures: Map::new(),
        })
    }
}

impl AskedForm {
    fn form(&self) -> Option<Form> {
        Some(match self {
            Self::Rays { side, target } => Form::Rays {
                truth: Rays::new(0.0, 0.0),
                side: side.signum(),
                target: [Pieces::Equal, Pieces::Marbles]
                    .map(Pieces::target_name)
                    .into_iter()
                    .find(|name| name == target)?,
            },
            Self::Number { measure } => Form::Number {
                quantity: Measure::with_id(measure)?,
                truth: 0.0,
            },
            Self::Choice { options } => Form::Choice {
                options: options.clone(),
                right: 0,
            },
            Self::Shot {
                hit,
                striker,
                wanted,
            } => Form::Shot(AimTask {
                collision: hit.collision()?,
                ray: if *striker { Ray::Striker } else { Ray::Target },
                wanted: Some(*wanted).filter(|it| it.is_finite())?,
                offset: 0.0,
            }),
        })
    }
}

impl AskedPicture {
    fn illustration(&self) -> Option<Illustration> {
        Some(match self {
            Self::Nothing => Illustration::Nothing,
            Self::Before { hit, shown } => Illustration::Before {
                collision: hit.collision()?,
                shown: Markings {
                    offset: shown[0],
                    angle: shown[1],
                    figures: shown[2],
                },
            },
            Self::After {
                angles,
                radii,
                along,
            } => Illustration::After {
                collision: hit_of_angles(*angles, *radii, (*along).into())?,
            },
            Self::Tracks { angles, nearest } => Illustration::Tracks {
                rutherford: Rutherford {
                    head_on_approach: Some(*nearest).filter(|it| it.is_finite() && *it > 0.0)?,
                },
                angles: *angles,
            },
        })
    }
}

/// A lossless collision with these paths: one of many that look the same.
fn hit_of_angles([theta1, theta2]: [f64; 2], radii: [f64; 2], along: DVec2) -> Option<Collision> {
    let is_good = radii.iter().all(|it| it.is_finite() && *it > 0.0) && along.is_normalized();
    let ratio = mass_ratio_from_angles(theta1, theta2, 1.0).filter(|_| is_good)?;
    let [striker, target] =
        [(ratio, radii[0]), (1.0, radii[1])].map(|(mass, radius)| Disc { mass, radius });
    Some(Collision::at_angle(striker, target, along, theta2))
}

/// The right answer, once it is revealed, and its explanation for this pupil.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RevealedTruth {
    /// The right answer.
    truth: Said,
    /// The explanation, and the feedback on the pupil's answer.
    pub why: String,
    /// This pupil's points for the question, if they have voted.
    pub points: Option<f64>,
    /// The real collision, if there is one to watch.
    hit: Option<TrueHit>,
}

/// A collision with everything that determines its outcome.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct TrueHit {
    seen: AskedHit,
    restitution: f64,
    sticks: bool,
    #[serde(default)]
    rim_friction: f64,
    #[serde(default)]
    spins: [f64; 2],
}

impl TrueHit {
    fn collision(self) -> Option<Collision> {
        let is_good = self.spins.iter().all(|spin| spin.is_finite());
        let rims = Rims {
            friction: self.rim_friction.max(0.0),
            spins: self.spins,
        };
        Some(Collision {
            restitution: self.restitution.clamp(0.0, 1.0),
            bond: if self.sticks { Bond::Stick } else { Bond::Slip },
            rims: if is_good { rims } else { Rims::default() },
            ..self.seen.collision()?
        })
    }
}

impl RevealedTruth {
    /// The right answer to a question, its explanation, and the points for an answer.
    pub fn new(question: &Question, why: String, points: Option<f64>) -> Self {
        Self {
            truth: question.form.truth().into(),
            why,
            points,
            hit: question.picture.collision().map(|hit| TrueHit {
                seen: AskedHit::of(hit),
                restitution: hit.restitution,
                sticks: hit.bond == Bond::Stick,
                rim_friction: hit.rims.friction,
                spins: hit.rims.spins,
            }),
        }
    }

    /// The question with its right answer and its real collision; `None` if the right answer does
    /// not fit the question.
    pub fn revealed(&self, mut asked: Question) -> Option<Question> {
        let true_answer = self.truth.response;
        if !asked.form.accepts(&true_answer) {
            return None;
        }
        match (&mut asked.form, true_answer) {
            (Form::Rays { truth, .. }, Response::Rays(rays)) => *truth = rays,
            (Form::Number { truth, .. }, Response::Number(x)) => *truth = x,
            (Form::Choice { right, .. }, Response::Choice(i)) => *right = i,
            (Form::Shot(aim), Response::Shot(offset)) => aim.offset = offset,
            _ => return None,
        }
        asked.why.clone_from(&self.why);
        if let Some(hit) = self.hit.and_then(TrueHit::collision) {
            if let Illustration::Before { collision, .. } | Illustration::After { collision } =
                &mut asked.picture
            {
                *collision = hit;
            }
            if let Form::Shot(aim) = &mut asked.form {
                aim.collision = hit;
            }
        }
        Some(asked)
    }
}

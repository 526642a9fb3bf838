//! A question of any family: its text, its picture, the right answer, and the answers that
//! misconceptions lead to.

use std::collections::BTreeMap;

use crate::physics::Frame;

use super::{
    Answer, Difficulty, Family, Figures, Form, Illustration, Misconception, Ray, Response, Topic,
};

/// Answers that are closer to each other than this, in units of the largest tolerance, cannot be
/// told apart. The value is more than 2, so no response can fit two answers that are this far
/// apart.
pub const MIN_SEPARATION: f64 = 2.0625;

/// A question, ready to be asked on a screen, on paper or line by line.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// The family of the question.
    pub family: Family,
    /// The difficulty of the question.
    pub difficulty: Difficulty,
    /// The topic of the question: "equal masses, by offset".
    pub topic: Topic,
    /// The question in words.
    pub text: String,
    /// The picture beside the question.
    pub picture: Illustration,
    /// How the question is answered, and the correct answer.
    pub form: Form,
    /// The answers that misconceptions lead to, except those that happen to be right.
    pub beliefs: Vec<WrongAnswer>,
    /// The feedback for wrong choices that no known misconception leads to, by the index of the
    /// choice, counted from 0. A choice that is not listed has no separate feedback.
    pub replies: BTreeMap<usize, String>,
    /// The explanation of the right answer, with the numbers of the question: one to four short
    /// sentences.
    pub why: String,
    /// The figures that determine the question; they are stored with every answer.
    pub figures: Figures,
}

/// The answer that a misconception leads to.
#[derive(Debug, Clone, PartialEq)]
pub struct WrongAnswer {
    /// The misconception that leads to the answer.
    pub misconception: Misconception,
    /// The answer that the misconception leads to.
    pub said: Response,
    /// The ray that reveals the misconception by itself; `None` if only both rays together reveal
    /// it.
    pub telltale: Option<Ray>,
    /// One or two sentences that say what is wrong with this answer, with the numbers of the
    /// question.
    pub says: String,
}

impl WrongAnswer {
    /// For the codes of rounds, the misconception that this answer shows: see
    /// [`Misconception::in_codes`]. This is also `None` for a choice that showed no known
    /// misconception when the codes were fixed.
    pub fn in_codes(&self) -> Option<Misconception> {
        match (self.misconception, self.said) {
            (Misconception::LossOpensAngle, Response::Choice(_)) => None,
            (misconception, _) => misconception.in_codes(),
        }
    }
}

/// How much of an answer fits a misconception.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fit {
    /// The whole answer.
    Whole,
    /// Only the ray that reveals the misconception; the other ray does not fit.
    OneRay(Ray),
}

impl Question {
    /// The frame in which the collision is shown after the answer, which is the frame that the
    /// question is about.
    pub(crate) fn seen_from(&self) -> Frame {
        match self.family {
            Family::CentreOfMass => Frame::CentreOfMass,
            _ => Frame::Laboratory,
        }
    }

    /// The smallest distance, in units of the largest tolerance, between any two of these answers:
    /// the right one and those that misconceptions lead to. Choices are 0 or infinitely far apart.
    pub fn clearance(&self) -> f64 {
        let held = self.beliefs.iter().map(|belief| belief.said);
        let answers: Vec<Response> = held.chain([self.form.truth()]).collect();
        nearest(&answers, |a, b| self.form.spacing(a, b))
    }

    /// Whether an answer shows which misconception it fits, if any, and cannot simply be copied
    /// from the text. Only questions for which this is true are asked.
    pub(crate) fn is_clear(&self) -> bool {
        let revealed = match &self.form {
            Form::Number { quantity, truth } => self.text.contains(&quantity.print(*truth)),
            Form::Rays { .. } | Form::Choice { .. } | Form::Shot(_) => false,
        };
        !revealed && self.clearance() > MIN_SEPARATION
    }

    /// All wrong answers that have separate feedback, each with the misconception behind it, if
    /// any: first the answers that misconceptions lead to, then other choices.
    pub(crate) fn wrong_answers(&self) -> Vec<(Response, Option<Misconception>, &str)> {
        let beliefs = self.beliefs.iter();
        let beliefs = beliefs.map(|it| (it.said, Some(it.misconception), it.says.as_str()));
        let replies = self.replies.iter();
        let replies =
            replies.map(|(choice, says)| (Response::Choice(*choice), None, says.as_str()));
        beliefs.chain(replies).collect()
    }

    /// The wrong answer that an answer fits best, if it fits any, and how much of the answer fits.
    ///
    /// A right answer fits no misconception. A fit of the whole answer takes precedence over a fit
    /// of the telltale ray alone. Among equal fits the closest one is chosen, with distances
    /// rounded to a fortieth of the tolerance (a tenth of a degree); among equally close fits, the
    /// one that comes first in [`OF_RAYS`](crate::quiz::misconceptions::OF_RAYS). A telltale ray
    /// must also be wrong.
    pub fn belief_of(&self, answer: &Answer) -> Option<(&WrongAnswer, Fit)> {
        if self.form.is_right(&answer.said) {
            return None;
        }
        let fits = self.beliefs.iter().filter_map(|belief| {
            let (fit, distance) = self.fit(belief, &answer.said)?;
            Some((belief, fit, distance))
        });
        fits.min_by_key(|(_, fit, distance)| (*fit != Fit::Whole, (40.0 * distance).round() as i64))
            .map(|(belief, fit, _)| (belief, fit))
    }

    /// How far an answer may be from the answer of a misconception and still fit that
    /// misconception, as a fraction of the largest tolerance: 1 except for small angles,
    /// percentages and values of e.
    pub(in crate::quiz) fn width(&self, belief: &WrongAnswer) -> f64 {
        match (&self.form, belief.said) {
            (Form::Number { quantity, .. }, Response::Number(x)) => quantity.width(x),
            _ => 1.0,
        }
    }

    /// The probability that a guess fits the answer of a misconception to this extent. One of two
    /// rays is as easily guessed as a number.
    pub(crate) fn by_chance(&self, fit: Fit) -> f64 {
        match fit {
            Fit::Whole => self.form.by_chance(),
            Fit::OneRay(_) => super::tolerance::NUMBER_BY_CHANCE,
        }
    }

    /// How much of `said` fits the answer of a misconception, and the distance between the two
    /// answers.
    fn fit(&self, belief: &WrongAnswer, said: &Response) -> Option<(Fit, f64)> {
        let distance = self.form.distance(said, &belief.said);
        if distance <= 1.0 {
            return Some((Fit::Whole, distance));
        }
        let ray = belief.telltale?;
        let (Form::Rays { truth, .. }, Response::Rays(said), Response::Rays(held)) =
            (&self.form, said, &belief.said)
        else {
            return None;
        };
        let near = super::tolerance::RIGHT_DEG.to_radians();
        let gap = said.apart(held, ray)?;
        let from_truth = said.apart(truth, ray).unwrap_or(f64::INFINITY);
        let fits = gap <= near && from_truth > near;
        fits.then_some((Fit::OneRay(ray), gap / near))
    }
}

/// The smallest distance between any two of these items; infinite if there are fewer than two.
pub(in crate::quiz) fn nearest<T>(all: &[T], distance: impl Fn(&T, &T) -> f64) -> f64 {
    let pairs = (1..)
        .zip(all)
        .flat_map(|(next, a)| all[next..].iter().map(move |b| (a, b)));
    pairs
        .map(|(a, b)| distance(a, b))
        .fold(f64::INFINITY, f64::min)
}

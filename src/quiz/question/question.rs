//! A question of any family: its text, its picture, the right answer, and the answers of
//! misconceptions.

use std::collections::BTreeMap;

use crate::physics::Frame;

use super::{
    Answer, Difficulty, Family, Figures, Form, Illustration, Misconception, Ray, Response, Topic,
};

/// Answers closer to each other than this, in units of the largest tolerance, cannot be told apart.
/// It is more than 2, so that no answer fits two of them.
pub const MIN_SEPARATION: f64 = 2.0625;

/// A question, ready to be asked on a screen, on paper or line by line.
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// Its family.
    pub family: Family,
    /// How hard it is.
    pub difficulty: Difficulty,
    /// Its topic: "equal masses, by offset".
    pub topic: Topic,
    /// The question in words.
    pub text: String,
    /// The picture beside it.
    pub picture: Illustration,
    /// How it is answered, and the true answer.
    pub form: Form,
    /// The answers of misconceptions, except any that happen to be right.
    pub beliefs: Vec<WrongAnswer>,
    /// The feedback for wrong choices without a known misconception, by the index of the choice,
    /// counted from 0; a choice that is not listed has no feedback of its own.
    pub replies: BTreeMap<usize, String>,
    /// The explanation of the right answer with the question's numbers: one to four short
    /// sentences.
    pub why: String,
    /// The numbers that determine the question, with the units in their names, to be stored with
    /// every answer.
    pub figures: Figures,
}

/// The answer that a misconception leads to.
#[derive(Debug, Clone, PartialEq)]
pub struct WrongAnswer {
    /// The misconception.
    pub misconception: Misconception,
    /// Its answer.
    pub said: Response,
    /// The ray that reveals the misconception by itself; `None` if only both rays together do.
    pub telltale: Option<Ray>,
    /// One or two sentences on what is wrong with this answer, with the question's numbers.
    pub says: String,
}

impl WrongAnswer {
    /// The misconception that this answer counts as in the codes of rounds: see
    /// [`Misconception::in_codes`]. Also `None` for a choice that showed no known misconception
    /// when the codes were fixed.
    pub fn in_codes(&self) -> Option<Misconception> {
        match (self.misconception, self.said) {
            (Misconception::LossOpensAngle, Response::Choice(_)) => None,
            (misconception, _) => misconception.in_codes(),
        }
    }
}

/// The misconception that an answer fits best.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Diagnosis {
    /// The misconception.
    pub misconception: Misconception,
    /// How much of the answer fits this misconception.
    pub fit: Fit,
}

/// How much of an answer fits a misconception.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fit {
    /// The whole answer.
    Whole,
    /// Only the ray that reveals it; the other ray has an error of its own.
    OneRay(Ray),
}

impl Question {
    /// The frame in which the collision is shown after the answer: the frame that the question asks
    /// about.
    pub(crate) fn seen_from(&self) -> Frame {
        match self.family {
            Family::CentreOfMass => Frame::CentreOfMass,
            _ => Frame::Laboratory,
        }
    }

    /// The smallest distance between any two of the right answer and the misconceptions' answers,
    /// in units of the largest tolerance. Choices are 0 or infinitely far apart.
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

    /// All wrong answers with feedback of their own, and the misconception behind each, if any:
    /// those of misconceptions, then other choices.
    pub(crate) fn wrong_answers(&self) -> Vec<(Response, Option<Misconception>, &str)> {
        let beliefs = self.beliefs.iter();
        let beliefs = beliefs.map(|it| (it.said, Some(it.misconception), it.says.as_str()));
        let replies = self.replies.iter();
        let replies =
            replies.map(|(choice, says)| (Response::Choice(*choice), None, says.as_str()));
        beliefs.chain(replies).collect()
    }

    /// Finds the misconception that an answer fits best, if it fits one.
    ///
    /// A right answer fits none. A fit of the whole answer takes precedence over a fit of the
    /// telltale ray alone. Among equal fits the closest is chosen, in steps of a fortieth of the
    /// tolerance (a tenth of a degree), and then the first in
    /// [`OF_RAYS`](crate::quiz::misconceptions::OF_RAYS). A telltale ray must also be wrong.
    pub fn diagnose(&self, answer: &Answer) -> Option<Diagnosis> {
        self.belief_of(answer).map(|(belief, fit)| Diagnosis {
            misconception: belief.misconception,
            fit,
        })
    }

    /// The misconception that an answer fits best, and how much of the answer fits.
    pub(in crate::quiz) fn belief_of(&self, answer: &Answer) -> Option<(&WrongAnswer, Fit)> {
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

    /// The misconceptions that an answer could show.
    pub fn could_show(&self) -> impl Iterator<Item = Misconception> {
        self.beliefs.iter().map(|belief| belief.misconception)
    }

    /// How far an answer may be from a misconception's answer and still fit it, as a fraction of
    /// the largest tolerance: 1 except for small angles, shares and e.
    pub(in crate::quiz) fn width(&self, belief: &WrongAnswer) -> f64 {
        match (&self.form, belief.said) {
            (Form::Number { quantity, .. }, Response::Number(x)) => quantity.width(x),
            _ => 1.0,
        }
    }

    /// The chance that a guess fits a misconception's answer to this extent: both rays, or one of
    /// them, which is as easily guessed as a number.
    pub(crate) fn by_chance(&self, fit: Fit) -> f64 {
        match fit {
            Fit::Whole => self.form.by_chance(),
            Fit::OneRay(_) => super::tolerance::NUMBER_BY_CHANCE,
        }
    }

    /// How `said` fits a misconception's answer, and the distance between them.
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

/// The smallest distance between any two of these; infinite if there are fewer than two.
pub(in crate::quiz) fn nearest<T>(all: &[T], distance: impl Fn(&T, &T) -> f64) -> f64 {
    let pairs = (1..)
        .zip(all)
        .flat_map(|(next, a)| all[next..].iter().map(move |b| (a, b)));
    pairs
        .map(|(a, b)| distance(a, b))
        .fold(f64::INFINITY, f64::min)
}

//! Which misconception an answer fits.

use crate::physics::units::rad_from_deg;

use super::super::grade::is_right;
use super::super::words::tenths;
use super::super::{Answer, Question, Ray, Rays};
use super::{ALL, FIT_DEG, Misconception, Prediction};

/// The misconception that an answer fits best.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Diagnosis {
    /// Which one.
    pub misconception: &'static Misconception,
    /// How much of the answer fits it.
    pub fit: Fit,
}

/// How much of an answer fits a misconception.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fit {
    /// Both rays.
    Whole,
    /// The ray that gives it away; the other one is off in its own way.
    OneRay(Ray),
}

/// Finds the misconception that an answer fits best, if it fits one.
///
/// A right answer fits none. A fit of both rays goes before a fit of the telltale ray
/// alone; among those the nearest goes first, to a tenth of a degree, and then the
/// first in [`ALL`]. A ray fits within [`FIT_DEG`]; a telltale ray must also be off
/// the truth by more than that.
pub fn diagnose(question: &Question, answer: &Answer) -> Option<Diagnosis> {
    if is_right(question, &answer.rays) {
        return None;
    }
    let truth = question.truth();
    ALL.into_iter()
        .filter_map(|misconception| {
            let prediction = misconception.predict(question)?;
            let (fit, distance) = fit(&prediction, &answer.rays, &truth)?;
            Some((Diagnosis { misconception, fit }, distance))
        })
        .min_by_key(|(diagnosis, distance)| (diagnosis.fit != Fit::Whole, tenths(*distance)))
        .map(|(diagnosis, _)| diagnosis)
}

/// How `said` fits a prediction, and how far off it is in radians.
fn fit(prediction: &Prediction, said: &Rays, truth: &Rays) -> Option<(Fit, f64)> {
    let near = rad_from_deg(FIT_DEG);
    let gap = said.gap(&prediction.rays);
    if gap <= near {
        return Some((Fit::Whole, gap));
    }
    let ray = prediction.telltale?;
    let distance = said.apart(&prediction.rays, ray)?;
    let from_truth = said.apart(truth, ray).unwrap_or(f64::INFINITY);
    (distance <= near && from_truth > near).then_some((Fit::OneRay(ray), distance))
}

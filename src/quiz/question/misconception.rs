//! Something students are known to believe.

use std::fmt;

use super::{Hit, Ray, Rays};

/// A prediction that differs from the truth by less is the truth, in radians.
const SAME: f64 = 1e-9;

/// Something students are known to believe.
pub struct Misconception {
    /// Its name in files.
    pub id: &'static str,
    /// Its name as shown: "the angle was copied".
    pub name: &'static str,
    /// What to try next against it.
    pub advice: &'static str,
    /// Where it sends the two; `None` where it has nothing to say.
    pub(in crate::quiz) predicts: fn(&Hit) -> Option<Prediction>,
    /// One or two sentences on what is wrong, on the figures of the hit.
    pub(in crate::quiz) says: fn(&Hit) -> String,
}

/// Where a misconception sends the two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prediction {
    /// Both rays.
    pub rays: Rays,
    /// The ray that gives the misconception away whatever the other one does; `None`
    /// if only both together do.
    pub telltale: Option<Ray>,
}

impl Prediction {
    pub(in crate::quiz) const fn new(rays: Rays, telltale: Option<Ray>) -> Self {
        Self { rays, telltale }
    }
}

impl Misconception {
    /// A misconception that says nothing of where both discs go.
    pub(in crate::quiz) const fn in_words(
        id: &'static str,
        name: &'static str,
        advice: &'static str,
    ) -> Self {
        Self {
            id,
            name,
            advice,
            predicts: |_| None,
            says: |_| String::new(),
        }
    }

    /// Where it sends the two of a hit; `None` where it has nothing to say or happens
    /// to be right.
    pub fn predict(&self, hit: &Hit) -> Option<Prediction> {
        (self.predicts)(hit).filter(|prediction| prediction.rays.gap(&hit.truth()) > SAME)
    }

    /// What is wrong with its rays, in one or two sentences.
    pub fn say(&self, hit: &Hit) -> String {
        (self.says)(hit)
    }
}

impl PartialEq for Misconception {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Eq for Misconception {}

impl fmt::Debug for Misconception {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Misconception").field(&self.id).finish()
    }
}

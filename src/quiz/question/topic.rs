//! What questions are about: their topics, and which families ask about which.
//!
//! What a player knows and when it comes back is noted by topic. One family may ask about
//! several, and several may ask about one, each in its own way. The written questions are
//! about the subjects of their files, which need not stand here: a teacher's own are free.

use std::borrow::Cow;
use std::fmt;

use super::Family::{self, *};

/// What a question is about. Keep it by its [`id`](Self::id), which stays the same for good;
/// show its [`name`](Self::name). Two with the same id are one topic.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Topic(Cow<'static, str>);

/// The topics of the families of figures: the id, the name, and who asks about it, besides
/// written questions.
#[rustfmt::skip]
static TOPICS: [(&str, &str, &[Family]); 41] = [
    ("equal-masses", "equal masses", &[WhereTo, FromAngle]),
    ("equal-masses-by-offset", "equal masses, by offset", &[WhereTo, FromOffset]),
    ("equal-masses-head-on", "equal masses, head-on", &[WhereTo, UnequalMasses]),
    ("equal-masses-lossy", "equal masses, lossy", &[WhereTo, FromAngle]),
    ("heavier-striker", "heavier striker", &[WhereTo, UnequalMasses]),
    ("heavier-striker-by-offset", "heavier striker, by offset", &[WhereTo, FromOffset]),
    ("heavier-striker-head-on", "heavier striker, head-on", &[WhereTo, UnequalMasses]),
    ("heavier-target", "heavier target", &[WhereTo, UnequalMasses]),
    ("heavier-target-by-offset", "heavier target, by offset", &[WhereTo, FromOffset]),
    ("heavier-target-head-on", "heavier target, head-on", &[WhereTo, UnequalMasses]),
    ("heavier-target-lossy", "heavier target, lossy", &[WhereTo, UnequalMasses]),
    ("from-the-picture", "from the picture", &[FromPicture]),
    ("target-speed", "target's speed", &[Speeds]),
    ("striker-speed", "striker's speed", &[Speeds]),
    ("corner-heavier-striker", "separation, heavier striker", &[Separation]),
    ("corner-lighter-striker", "separation, lighter striker", &[Separation]),
    ("corner-with-loss", "separation, with loss", &[Separation, Restitution]),
    ("corner-without-loss", "separation, without loss", &[Separation]),
    ("energy-lost", "energy lost", &[EnergyShare]),
    ("energy-of-target", "energy the target takes", &[EnergyShare]),
    ("energy-of-striker", "energy the striker keeps", &[EnergyShare]),
    ("square-in-spite-of-loss", "90° in spite of loss", &[Restitution]),
    ("e-for-square", "e for a right angle", &[Restitution]),
    ("e-from-angles", "e from the angles", &[Restitution]),
    ("e-head-on", "e of a head-on hit", &[Restitution]),
    ("aim-for-largest-turn", "aim for the largest turn", &[LargestDeflection]),
    ("limit-of-turn", "is there a limit?", &[LargestDeflection]),
    ("largest-turn", "the largest turn", &[LargestDeflection]),
    ("mass-from-angles", "mass from the angles", &[Weigh]),
    ("mass-from-momentum", "mass from the momentum", &[Weigh]),
    ("which-is-heavier", "which is heavier?", &[Weigh]),
    ("smooth-no-spring", "smooth, e = 0", &[SlipOrStick]),
    ("smooth-no-loss", "smooth, no loss", &[SlipOrStick]),
    ("sticking", "sticking together", &[SlipOrStick]),
    ("both-moving", "both moving", &[BothMoving]),
    ("centre-of-mass", "the centre of mass", &[CentreOfMass]),
    ("counts-at-two-angles", "counts at two angles", &[Rutherford]),
    ("counts-angle-and-energy", "counts, angle and energy", &[Rutherford]),
    ("angle-of-count", "the angle of a count", &[Rutherford]),
    ("send-coin", "send the coin", &[MakeItSo]),
    ("send-striker", "send the striker", &[MakeItSo]),
];

impl Topic {
    /// The topic of an id. Every id is one's: an unknown one is that of a written question,
    /// and is named by its words.
    pub fn with_id(id: impl Into<Cow<'static, str>>) -> Self {
        Self(id.into())
    }

    /// The topic of the subject of a written question, which is the name of its file.
    pub(in crate::quiz) fn of_subject(subject: &str) -> Self {
        Self::with_id(subject.replace(' ', "-"))
    }

    /// The topics of the families of figures.
    #[cfg(test)]
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        TOPICS.iter().map(|(id, ..)| Self::with_id(*id))
    }

    /// What it is kept by: "corner-with-loss".
    pub fn id(&self) -> &str {
        &self.0
    }

    fn known(&self) -> Option<&'static (&'static str, &'static str, &'static [Family])> {
        TOPICS.iter().find(|(id, ..)| *id == self.0)
    }

    /// Its name as shown: "separation, with loss".
    pub fn name(&self) -> String {
        match self.known() {
            Some((_, name, _)) => (*name).into(),
            None => self.0.replace('-', " "),
        }
    }

    /// The families of figures that ask about it.
    pub(in crate::quiz) fn families_of_figures(&self) -> &'static [Family] {
        self.known().map_or(&[], |(.., families)| families)
    }
}

impl From<&'static str> for Topic {
    fn from(id: &'static str) -> Self {
        Self::with_id(id)
    }
}

impl fmt::Display for Topic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.name())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn ids_and_names_are_each_one_topic() {
        let ids: BTreeSet<_> = TOPICS.iter().map(|it| it.0).collect();
        assert_eq!(ids.len(), TOPICS.len());
        let names: BTreeSet<_> = TOPICS.iter().map(|it| it.1).collect();
        assert_eq!(names.len(), TOPICS.len());
    }
}

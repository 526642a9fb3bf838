//! What questions are about: their topics, and which families ask about which.
//!
//! What a player knows and when it comes back is noted by topic. One family may ask about
//! several, and several may ask about one, each in its own way. The written questions are
//! about the subjects of their files, which need not stand here: a teacher's own are free.

use std::borrow::Cow;
use std::fmt;

use super::Family::{
    self, BothMoving, CentreOfMass, EnergyShare, FromAngle, FromOffset, FromPicture,
    LargestDeflection, MakeItSo, Restitution, Rutherford, Separation, SlipOrStick, Speeds,
    UnequalMasses, Weigh, WhereTo,
};

/// What a question is about. Keep it by its [`id`](Self::id), which stays the same for good;
/// show its [`name`](Self::name). Two with the same id are one topic.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Topic(Cow<'static, str>);

/// A topic of the families of figures.
struct KnownTopic {
    id: &'static str,
    name: &'static str,
    /// Who asks about it, besides written questions.
    families: &'static [Family],
}

const fn known(id: &'static str, name: &'static str, families: &'static [Family]) -> KnownTopic {
    KnownTopic { id, name, families }
}

#[rustfmt::skip]
static TOPICS: [KnownTopic; 41] = [
    known("equal-masses", "equal masses", &[WhereTo, FromAngle]),
    known("equal-masses-by-offset", "equal masses, by offset", &[WhereTo, FromOffset]),
    known("equal-masses-head-on", "equal masses, head-on", &[WhereTo, UnequalMasses]),
    known("equal-masses-lossy", "equal masses, lossy", &[WhereTo, FromAngle]),
    known("heavier-striker", "heavier striker", &[WhereTo, UnequalMasses]),
    known("heavier-striker-by-offset", "heavier striker, by offset", &[WhereTo, FromOffset]),
    known("heavier-striker-head-on", "heavier striker, head-on", &[WhereTo, UnequalMasses]),
    known("heavier-target", "heavier target", &[WhereTo, UnequalMasses]),
    known("heavier-target-by-offset", "heavier target, by offset", &[WhereTo, FromOffset]),
    known("heavier-target-head-on", "heavier target, head-on", &[WhereTo, UnequalMasses]),
    known("heavier-target-lossy", "heavier target, lossy", &[WhereTo, UnequalMasses]),
    known("from-the-picture", "from the picture", &[FromPicture]),
    known("target-speed", "target's speed", &[Speeds]),
    known("striker-speed", "striker's speed", &[Speeds]),
    known("corner-heavier-striker", "the corner, heavier striker", &[Separation]),
    known("corner-lighter-striker", "the corner, lighter striker", &[Separation]),
    known("corner-with-loss", "the corner, with loss", &[Separation, Restitution]),
    known("corner-without-loss", "the corner, without loss", &[Separation]),
    known("energy-lost", "energy lost", &[EnergyShare]),
    known("energy-of-target", "energy the target takes", &[EnergyShare]),
    known("energy-of-striker", "energy the striker keeps", &[EnergyShare]),
    known("square-in-spite-of-loss", "90° in spite of loss", &[Restitution]),
    known("e-for-square", "e for a right angle", &[Restitution]),
    known("e-from-angles", "e from the angles", &[Restitution]),
    known("e-head-on", "e of a head-on hit", &[Restitution]),
    known("aim-for-largest-turn", "aim for the largest turn", &[LargestDeflection]),
    known("limit-of-turn", "is there a limit?", &[LargestDeflection]),
    known("largest-turn", "the largest turn", &[LargestDeflection]),
    known("mass-from-angles", "mass from the angles", &[Weigh]),
    known("mass-from-momentum", "mass from the momentum", &[Weigh]),
    known("which-is-heavier", "which is heavier?", &[Weigh]),
    known("smooth-no-spring", "smooth, e = 0", &[SlipOrStick]),
    known("smooth-no-loss", "smooth, no loss", &[SlipOrStick]),
    known("sticking", "sticking together", &[SlipOrStick]),
    known("both-moving", "both moving", &[BothMoving]),
    known("centre-of-mass", "the centre of mass", &[CentreOfMass]),
    known("counts-at-two-angles", "counts at two angles", &[Rutherford]),
    known("counts-angle-and-energy", "counts, angle and energy", &[Rutherford]),
    known("angle-of-count", "the angle of a count", &[Rutherford]),
    known("send-coin", "send the coin", &[MakeItSo]),
    known("send-striker", "send the striker", &[MakeItSo]),
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
    pub(in crate::quiz) fn all() -> impl Iterator<Item = Self> {
        TOPICS.iter().map(|known| Self::with_id(known.id))
    }

    /// What it is kept by: "corner-with-loss".
    pub fn id(&self) -> &str {
        &self.0
    }

    fn known(&self) -> Option<&'static KnownTopic> {
        TOPICS.iter().find(|known| known.id == self.0)
    }

    /// Its name as shown: "the corner, with loss".
    pub fn name(&self) -> String {
        match self.known() {
            Some(known) => known.name.into(),
            None => self.0.replace('-', " "),
        }
    }

    /// The families of figures that ask about it.
    pub(in crate::quiz) fn families_of_figures(&self) -> &'static [Family] {
        self.known().map_or(&[], |known| known.families)
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
        let ids: BTreeSet<_> = TOPICS.iter().map(|it| it.id).collect();
        assert_eq!(ids.len(), TOPICS.len());
        let names: BTreeSet<_> = TOPICS.iter().map(|it| it.name).collect();
        assert_eq!(names.len(), TOPICS.len());
    }
}

//! Which families ask about which topics.
//!
//! A topic is what a question is about, in a few words; what is known and when it comes
//! back is noted by topic. One family may ask about several, and several may ask about
//! one, each in its own way.

use super::{Family, concepts};

impl Family {
    /// The topics of its questions; those of the written questions are the subjects of
    /// their files, and not listed here.
    const fn topics(self) -> &'static [&'static str] {
        match self {
            Self::WhereTo => &[
                "equal masses",
                "equal masses, by offset",
                "equal masses, head-on",
                "equal masses, lossy",
                "heavier striker",
                "heavier striker, by offset",
                "heavier striker, head-on",
                "heavier target",
                "heavier target, by offset",
                "heavier target, head-on",
                "heavier target, lossy",
            ],
            Self::FromAngle => &["equal masses", "equal masses, lossy"],
            Self::FromOffset => &[
                "equal masses, by offset",
                "heavier striker, by offset",
                "heavier target, by offset",
            ],
            Self::FromPicture => &["from the picture"],
            Self::UnequalMasses => &[
                "equal masses, head-on",
                "heavier striker",
                "heavier striker, head-on",
                "heavier target",
                "heavier target, head-on",
                "heavier target, lossy",
            ],
            Self::Speeds => &["coin's speed", "marble's speed", "striker's speed"],
            Self::Separation => &[
                "the corner, heavier striker",
                "the corner, lighter striker",
                "the corner, with loss",
                "the corner, without loss",
            ],
            Self::EnergyShare => &[
                "energy lost",
                "energy the coin takes",
                "energy the marble takes",
                "energy the striker keeps",
            ],
            Self::Restitution => &[
                "90° in spite of loss",
                "e for a right angle",
                "e from the angles",
                "e of a head-on hit",
                "the corner with loss",
            ],
            Self::LargestDeflection => &[
                "aim for the largest turn",
                "is there a limit?",
                "the largest turn",
            ],
            Self::Weigh => &[
                "mass from the angles",
                "mass from the momentum",
                "which is heavier?",
            ],
            Self::SlipOrStick => &["smooth, e = 0", "smooth, no loss", "sticking together"],
            Self::BothMoving => &["both moving"],
            Self::CentreOfMass => &["the centre of mass"],
            Self::Rutherford => &[
                "counts at two angles",
                "counts, angle and energy",
                "the angle of a count",
            ],
            Self::MakeItSo => &["send the coin", "send the striker"],
            Self::Concept => &[],
        }
    }

    /// The families that ask about a topic; none where nothing asks about it, as the
    /// title of a chapter.
    pub fn asking(topic: &str) -> Vec<Self> {
        let asks = |family: &Self| match family {
            Self::Concept => concepts::all().iter().any(|it| it.topic() == topic),
            family => family.topics().contains(&topic),
        };
        Self::ALL.into_iter().filter(asks).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::super::{Dice, Difficulty};
    use super::*;

    #[test]
    fn every_family_asks_about_its_topics_and_no_others() {
        for family in Family::ALL {
            let mut met = BTreeSet::new();
            for (seed, difficulty) in (0..500).flat_map(|s| Difficulty::ALL.map(|d| (s, d))) {
                let asked = family.ask(difficulty, &mut Dice::new(seed));
                met.extend(asked.map(|(question, _)| question.topic));
            }
            let listed: BTreeSet<String> = match family {
                Family::Concept => concepts::all().iter().map(|it| it.topic()).collect(),
                family => family.topics().iter().map(|it| (*it).into()).collect(),
            };
            assert_eq!(met, listed, "{family:?}");
        }
    }

    #[test]
    fn a_topic_may_belong_to_several_families_and_to_none() {
        let asking = Family::asking("equal masses");
        assert_eq!(asking, [Family::WhereTo, Family::FromAngle]);
        // In figures, and in words.
        let asking = Family::asking("both moving");
        assert_eq!(asking, [Family::BothMoving, Family::Concept]);
        assert_eq!(Family::asking("Momentum is a vector"), []);
    }
}

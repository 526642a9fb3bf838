//! Where in the chapters something is taught.

use super::Topic;

/// A page of the program's own chapters, by names that stay when others come before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Passage {
    /// The id of the chapter.
    pub chapter: &'static str,
    /// The title of the page.
    pub page: &'static str,
}

/// The pages that teach what questions are about: chapter and page, and the ids of the
/// topics. Which topics a chapter has, and in which order, is part of the format of codes
/// such as `read-abd-7`; a page may change.
#[rustfmt::skip]
static TAUGHT: [(&str, &str, &[&str]); 23] = [
    ("momentum-is-a-vector", "One law, two lines", &["momentum"]),
    ("the-line-of-impact", "The whole method", &["line-of-impact", "send-coin", "from-the-picture"]),
    ("the-right-angle", "Step 3: conclude", &["right-angle", "corner-without-loss"]),
    ("speeds-and-angles", "Which way?", &["equal-masses", "angles-and-speeds", "send-striker"]),
    ("speeds-and-angles", "From the offset", &["equal-masses-by-offset"]),
    ("speeds-and-angles", "The other coin", &["target-speed", "striker-speed"]),
    ("speeds-and-angles", "The split of energy", &["energy-of-target", "energy-of-striker", "energy"]),
    ("marbles", "Along n", &["heavier-striker-head-on", "heavier-target-head-on", "equal-masses-head-on"]),
    ("marbles", "Which way, how fast?", &["heavier-target", "unequal-masses", "heavier-target-by-offset"]),
    ("marbles", "Heavy on light", &["heavier-striker", "heavier-striker-by-offset"]),
    ("marbles", "What the angle shows", &["corner-heavier-striker", "corner-lighter-striker", "which-is-heavier"]),
    ("five-confusions", "Five, with both moving", &["both-moving"]),
    ("the-impact-parameter", "How far off-centre", &["offset"]),
    ("the-impact-parameter", "The greatest deflection", &["aim-for-largest-turn", "limit-of-turn", "largest-turn"]),
    ("weighing-by-angle", "From two angles to a mass", &["mass-from-angles", "measuring"]),
    ("momentum-is-a-vector", "And along x", &["mass-from-momentum"]),
    ("to-the-atom", "How many, and where", &["counts-at-two-angles", "angle-of-count", "scattering"]),
    ("to-the-atom", "What sets the count", &["counts-angle-and-energy"]),
    ("the-centre-of-mass", "One turn for both", &["centre-of-mass", "frames"]),
    ("when-energy-is-lost", "The coefficient of restitution", &["energy-lost", "e-head-on", "e-from-angles"]),
    ("when-energy-is-lost", "What happens to the right angle?", &["equal-masses-lossy", "heavier-target-lossy", "corner-with-loss"]),
    ("when-energy-is-lost", "A right angle with a loss", &["square-in-spite-of-loss", "e-for-square"]),
    ("when-energy-is-lost", "No rebound", &["smooth-no-spring", "smooth-no-loss", "sticking", "loss-and-grip"]),
];

impl Topic {
    /// The topics that the chapter of an id teaches.
    pub(in crate::quiz) fn taught_in(chapter: &str) -> impl Iterator<Item = Self> {
        let taught = TAUGHT.iter().filter(move |taught| taught.0 == chapter);
        taught.flat_map(|(.., ids)| ids.iter().map(|id| Self::with_id(*id)))
    }

    /// The page that teaches it; `None` of a teacher's own subjects.
    pub fn taught_on(&self) -> Option<Passage> {
        let mut taught = TAUGHT.iter();
        let (chapter, page, _) = taught.find(|(.., ids)| ids.contains(&self.id()))?;
        Some(Passage { chapter, page })
    }
}

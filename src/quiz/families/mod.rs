//! The families of questions, one file a family.
//!
//! A family draws figures with the dice and declares a whole [`Question`] of them: the
//! text, the picture, the true answer, what each misconception would answer, and why the
//! truth is true. It need not care whether the answers can be told apart: [`Family::ask`]
//! draws again until they can. A new family is a file of its own, and a line in the table
//! here; its topics stand in the table of topics.

use crate::quiz::question::{Dice, Difficulty, Family, Question};

mod both_moving;
mod centre_of_mass;
pub(super) mod concept;
mod energy_share;
mod hit_draws;
mod hit_kinds;
mod largest_deflection;
mod make_it_so;
mod outline;
mod restitution;
mod rutherford;
mod separation;
mod slip_or_stick;
mod speeds;
mod weigh;
pub(super) mod where_to;

/// How many draws a question may take before a family is given up: a guard against a
/// family that has nothing clear to ask. A test sees that none needs a twentieth of it.
const DRAWS: usize = 20_000;

/// One draw, clear or not; `None` where the figures drawn make no question.
type Draw = fn(Difficulty, &mut Dice) -> Option<Question>;

/// What is declared of a family.
struct FamilyEntry {
    family: Family,
    id: &'static str,
    name: &'static str,
    draw: Draw,
}

const fn declared(family: Family, id: &'static str, name: &'static str, draw: Draw) -> FamilyEntry {
    FamilyEntry {
        family,
        id,
        name,
        draw,
    }
}

/// All families, in the order in which they are taught, which is that of [`Family`].
#[rustfmt::skip]
static TABLE: [FamilyEntry; 17] = [
    declared(Family::WhereTo, "where-to", "where will they go?", where_to::ask),
    declared(Family::FromAngle, "from-angle", "angles from the angle", where_to::from_angle),
    declared(Family::FromOffset, "from-offset", "angles from the offset", where_to::from_offset),
    declared(Family::FromPicture, "from-picture", "from the picture alone", where_to::from_picture),
    declared(Family::UnequalMasses, "unequal-masses", "unequal masses", where_to::unequal_masses),
    declared(Family::Speeds, "speeds", "speeds after the hit", speeds::ask),
    declared(Family::Separation, "separation", "more or less than 90°?", separation::ask),
    declared(Family::EnergyShare, "energy-share", "shares of energy", energy_share::ask),
    declared(Family::Restitution, "restitution", "what e does", restitution::ask),
    declared(Family::LargestDeflection, "largest-deflection", "the most it can be turned", largest_deflection::ask),
    declared(Family::Weigh, "weigh", "weighing by angles", weigh::ask),
    declared(Family::SlipOrStick, "slip-or-stick", "slip or stick", slip_or_stick::ask),
    declared(Family::BothMoving, "both-moving", "both moving", both_moving::ask),
    declared(Family::CentreOfMass, "centre-of-mass", "the centre of mass", centre_of_mass::ask),
    declared(Family::Rutherford, "rutherford", "Rutherford's counts", rutherford::ask),
    declared(Family::MakeItSo, "make-it-so", "make it so", make_it_so::ask),
    declared(Family::Concept, "concept", "ideas in words", concept::ask),
];

impl Family {
    /// All families, in the order in which they are taught.
    pub const ALL: [Self; TABLE.len()] = {
        let mut all = [Self::WhereTo; TABLE.len()];
        let mut i = 0;
        while i < all.len() {
            all[i] = TABLE[i].family;
            i += 1;
        }
        all
    };

    const fn entry(self) -> &'static FamilyEntry {
        &TABLE[self as usize]
    }

    /// Its name in files and in the codes of rounds.
    pub const fn id(self) -> &'static str {
        self.entry().id
    }

    /// Its name as shown.
    pub const fn name(self) -> &'static str {
        self.entry().name
    }

    /// The family of an `id`.
    pub fn with_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|family| family.id() == id)
    }

    /// A question of this family that is clear, with the draws it took. The same dice
    /// always bring the same question: the draws of a family are part of the format of
    /// a round's code. `None` only where a family has nothing clear to ask.
    pub fn ask(self, difficulty: Difficulty, dice: &mut Dice) -> Option<(Question, usize)> {
        (1..=DRAWS).find_map(|draws| {
            let question = Question {
                family: self,
                difficulty,
                ..(self.entry().draw)(difficulty, dice)?
            };
            question.is_clear().then_some((question, draws))
        })
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::quiz::concepts;
    use crate::quiz::question::Topic;

    #[test]
    fn the_table_has_every_family_at_its_place() {
        for (place, family) in Family::ALL.into_iter().enumerate() {
            assert_eq!(family as usize, place);
            assert_eq!(Family::with_id(family.id()), Some(family));
        }
    }

    #[test]
    fn every_family_asks_about_its_topics_and_no_others() {
        for family in Family::ALL {
            let mut met = BTreeSet::new();
            for (seed, difficulty) in (0..500).flat_map(|s| Difficulty::ALL.map(|d| (s, d))) {
                let asked = family.ask(difficulty, &mut Dice::new(seed));
                met.extend(asked.map(|(question, _)| question.topic));
            }
            let listed: BTreeSet<Topic> = match family {
                Family::Concept => concepts::all().iter().map(|it| it.topic()).collect(),
                family => Topic::all()
                    .filter(|it| it.families_of_figures().contains(&family))
                    .collect(),
            };
            assert_eq!(met, listed, "{family:?}");
        }
    }

    #[test]
    fn a_topic_may_belong_to_several_families_and_to_none() {
        let asking = |id| Topic::with_id(id).families();
        assert_eq!(asking("equal-masses"), [Family::WhereTo, Family::FromAngle]);
        assert_eq!(
            asking("corner-with-loss"),
            [Family::Separation, Family::Restitution]
        );
        // In figures, and in words.
        assert_eq!(asking("both-moving"), [Family::BothMoving, Family::Concept]);
        assert_eq!(asking("momentum-is-a-vector"), []);
    }
}

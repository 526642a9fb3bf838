//! The families of questions, one file per family.
//!
//! A family draws random numbers and builds a whole [`Question`] from them: the text, the picture,
//! the right answer, the answer that each misconception leads to, and the explanation. A family
//! need not check whether the answers are clearly different: [`Family::ask`] draws again until they
//! are. To add a family, add a file, a variant at the end of [`Family`], and a row at the end of
//! the table below; then list the family's topics in the table of topics.

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
mod prelude;
mod restitution;
mod rutherford;
mod separation;
mod slip_or_stick;
mod speeds;
mod weigh;
pub(super) mod where_to;

/// The maximum number of draws for a question, which guards against a family that has no clear
/// questions. A test checks that no family needs more than a twentieth of this number.
const DRAWS: usize = 20_000;

/// Makes one draw, whether or not its answers are clearly different; returns `None` if the numbers
/// are unsuitable.
type Draw = fn(Difficulty, &mut Dice) -> Option<Question>;

/// The name of each family as shown, and its generator, in the order of [`Family`].
#[rustfmt::skip]
static TABLE: [(&str, Draw); Family::ALL.len()] = [
    ("where will they go?", where_to::ask),
    ("directions from the angle", where_to::from_angle),
    ("directions from the offset", where_to::from_offset),
    ("from the picture alone", where_to::from_picture),
    ("unequal masses, or a loss", where_to::unequal_masses),
    ("speeds after collisions", speeds::ask),
    ("more or less than 90°?", separation::ask),
    ("shares of energy", energy_share::ask),
    ("what e does", restitution::ask),
    ("the greatest deflection", largest_deflection::ask),
    ("weighing by angles", weigh::ask),
    ("smooth or glued rims", slip_or_stick::ask),
    ("both moving", both_moving::ask),
    ("the centre of mass", centre_of_mass::ask),
    ("Rutherford's counts", rutherford::ask),
    ("make it so", make_it_so::ask),
    ("ideas in words", |difficulty, dice| concept::ask(Family::Concept, difficulty, dice)),
    ("more ideas in words", |difficulty, dice| concept::ask(Family::Ideas, difficulty, dice)),
];

impl Family {
    /// The name of the family as shown.
    pub const fn name(self) -> &'static str {
        TABLE[self as usize].0
    }

    /// Generates a clear question of this family; also returns the number of draws. The same dice
    /// must always give the same question, because the codes of rounds depend on it. Returns `None`
    /// only if a family has no clear questions.
    pub fn ask(self, difficulty: Difficulty, dice: &mut Dice) -> Option<(Question, usize)> {
        (1..=DRAWS).find_map(|draws| {
            let question = Question {
                family: self,
                difficulty,
                ..TABLE[self as usize].1(difficulty, dice)?
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
    fn families_are_numbered_in_order_and_found_by_their_ids() {
        for (place, family) in Family::ALL.iter().enumerate() {
            assert_eq!(*family as usize, place);
            assert_eq!(Family::with_id(family.id()), Some(*family));
        }
    }

    #[test]
    fn every_family_asks_about_its_topics_and_no_others() {
        for &family in Family::ALL {
            let mut met = BTreeSet::new();
            for (seed, difficulty) in (0..500).flat_map(|s| Difficulty::ALL.map(|d| (s, d))) {
                let asked = family.ask(difficulty, &mut Dice::new(seed));
                met.extend(asked.map(|(question, _)| question.topic));
            }
            let listed: BTreeSet<Topic> = match family {
                Family::Concept | Family::Ideas => {
                    concepts::of(family).iter().map(|it| it.topic()).collect()
                }
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
        // This topic has calculated questions and questions in words.
        assert_eq!(asking("both-moving"), [Family::BothMoving, Family::Concept]);
        assert_eq!(asking("momentum-is-a-vector"), []);
    }
}

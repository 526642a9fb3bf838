//! Questions about given topics, as needed for a review.

use crate::quiz::question::{Dice, Difficulty, Family, Question, Topic};

/// The number of draws for a topic before another difficulty or another family is tried:
/// enough for the rarest topic.
const DRAWS: usize = 200;

/// A question about each of these topics, from the families that `families` returns for the topic,
/// in random order but with easy questions first as far as possible. No family comes twice in a row
/// as long as a remaining topic has another family, because it is best to return to an idea after
/// doing something else. A topic without questions is left out.
pub(super) fn questions(
    topics: &[Topic],
    families: fn(&Topic) -> Vec<Family>,
    dice: &mut Dice,
) -> Vec<Question> {
    let all = topics.iter().map(|topic| (topic, families(topic)));
    let mut left: Vec<_> = all.filter(|(_, all)| !all.is_empty()).collect();
    dice.shuffle(&mut left);
    let count = left.len();
    let mut questions: Vec<Question> = Vec::with_capacity(count);
    while !left.is_empty() {
        let last = questions.last().map(|question| question.family);
        let another = |family: &Family| Some(*family) != last;
        // If the only family for a topic is that of the previous question, the topic is postponed,
        // unless nothing else is left.
        let next = left.iter().position(|(_, all)| all.iter().any(another));
        let (topic, mut families) = left.remove(next.unwrap_or(0));
        dice.shuffle(&mut families);
        families.sort_by_key(|family| !another(family));
        let difficulty = Difficulty::rising(questions.len(), count);
        questions.extend(about(topic, &families, difficulty, dice));
    }
    questions
}

/// A question about a topic, from the first of these families that has such a question, and of this
/// difficulty if possible.
fn about(
    topic: &Topic,
    families: &[Family],
    difficulty: Difficulty,
    dice: &mut Dice,
) -> Option<Question> {
    let others = Difficulty::ALL.into_iter().filter(|it| *it != difficulty);
    let difficulties: Vec<_> = std::iter::once(difficulty).chain(others).collect();
    families.iter().find_map(|family| {
        difficulties.iter().find_map(|difficulty| {
            (0..DRAWS).find_map(|_| {
                let (question, _) = family.ask(*difficulty, dice)?;
                (question.topic == *topic).then_some(question)
            })
        })
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::quiz::concepts;

    /// All topics.
    fn all() -> Vec<Topic> {
        let asked = |seed| {
            let mut dice = Dice::new(seed);
            let of = |family: Family| {
                Difficulty::ALL.map(|difficulty| family.ask(difficulty, &mut dice))
            };
            let found: Vec<_> = Family::ALL.iter().copied().flat_map(of).flatten().collect();
            found.into_iter().map(|(question, _)| question.topic)
        };
        let mut topics: BTreeSet<Topic> = (0..200).flat_map(asked).collect();
        topics.extend(concepts::all().iter().map(|concept| concept.topic()));
        topics.into_iter().collect()
    }

    #[test]
    fn every_topic_can_be_reviewed_and_is_asked_once() {
        let topics = all();
        assert!(topics.len() > 50);
        for seed in 0..10 {
            let questions = questions(&topics, Topic::families, &mut Dice::new(seed));
            let mut asked: Vec<_> = questions.iter().map(|it| it.topic.clone()).collect();
            asked.sort();
            assert_eq!(asked, topics);
        }
    }

    #[test]
    fn the_families_of_a_topic_take_turns_and_none_comes_twice_in_a_row() {
        let topics = ["equal-masses", "heavier-striker", "target-speed"].map(Topic::with_id);
        let mut met = BTreeSet::new();
        for seed in 0..100 {
            let questions = questions(&topics, Topic::families, &mut Dice::new(seed));
            let families: Vec<_> = questions.iter().map(|it| it.family).collect();
            assert!(families.windows(2).all(|pair| pair[0] != pair[1]));
            met.extend(families.iter().map(|family| family.id()));
        }
        let all = ["from-angle", "speeds", "unequal-masses", "where-to"];
        assert_eq!(met.into_iter().collect::<Vec<_>>(), all);
        // A topic that has only one family is still included; an unknown topic is left out.
        let same = ["striker-speed", "target-speed", "a-chapter"].map(Topic::with_id);
        assert_eq!(
            questions(&same, Topic::families, &mut Dice::new(7)).len(),
            2
        );
    }
}

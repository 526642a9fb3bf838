//! Rounds about what the player has read in the chapters, and nothing else.

use std::collections::BTreeSet;
use std::fmt;

use super::review;
use crate::quiz::question::{Dice, Question, Topic};

/// The ids of the built-in chapters, each with its letter in codes. The letters never change: a new
/// chapter gets the next letter.
const LETTERS: [(char, &str); 17] = [
    ('a', "momentum-is-a-vector"),
    ('b', "the-line-of-impact"),
    ('c', "the-right-angle"),
    ('d', "speeds-and-angles"),
    ('e', "a-worked-shot"),
    ('f', "marbles"),
    ('g', "five-confusions"),
    ('h', "the-impact-parameter"),
    ('i', "weighing-by-angle"),
    ('j', "to-the-atom"),
    ('k', "the-centre-of-mass"),
    ('l', "when-energy-is-lost"),
    ('m', "impulse"),
    ('n', "elastic-and-inelastic"),
    ('o', "energy-and-the-centre-of-mass"),
    ('p', "rough-rims"),
    ('q', "measuring-a-collision"),
];

/// A set of chapters, at least one of which teaches a topic that has questions. In codes the
/// chapters are letters: `read-abd-7` asks about chapters 1, 2 and 4.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChaptersRead(BTreeSet<char>);

impl ChaptersRead {
    /// The set of chapters with these ids; `None` if there are no questions about any of them.
    pub(crate) fn of<'a>(ids: impl IntoIterator<Item = &'a str>) -> Option<Self> {
        let letter = |id| LETTERS.get(Self::order_of(id)).map(|(letter, _)| *letter);
        Self::of_letters(ids.into_iter().filter_map(letter))
    }

    /// The position of a chapter among the built-in chapters, for sorting; other chapters come
    /// last.
    pub(crate) fn order_of(id: &str) -> usize {
        let found = LETTERS.iter().position(|(_, known)| *known == id);
        found.unwrap_or(LETTERS.len())
    }

    /// The set of chapters for the letters in a code; `None` if a letter is unknown or repeated, if
    /// the letters are not in alphabetical order, or if there are no questions about the chapters.
    pub(super) fn parse(letters: &str) -> Option<Self> {
        let chapters = Self::of_letters(letters.chars())?;
        (chapters.to_string() == letters).then_some(chapters)
    }

    fn of_letters(letters: impl Iterator<Item = char>) -> Option<Self> {
        let known = |letter: &char| LETTERS.iter().any(|(known, _)| known == letter);
        let chapters = Self(letters.filter(known).collect());
        let taught = chapters.topics().next().is_some();
        taught.then_some(chapters)
    }

    /// The topics that these chapters teach.
    fn topics(&self) -> impl Iterator<Item = Topic> {
        let ids = LETTERS.iter().filter(|(letter, _)| self.0.contains(letter));
        ids.flat_map(|(_, id)| Topic::taught_in(id))
    }

    /// At most `count` different questions about the topics that these chapters teach. Every topic
    /// is chosen once before any is chosen again. As far as possible, easy questions come first.
    pub(super) fn questions(&self, count: usize, dice: &mut Dice) -> Vec<Question> {
        let topics: Vec<Topic> = self.topics().collect();
        let topics = dice.in_turn(&topics, count);
        let mut questions = review::questions(&topics, Topic::families_in_codes, dice);
        let mut asked = BTreeSet::new();
        questions.retain(|question| asked.insert(question.text.clone()));
        questions
    }
}

impl fmt::Display for ChaptersRead {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|letter| write!(f, "{letter}"))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Code, Round};
    use super::*;

    #[test]
    fn a_round_asks_only_about_the_chapters_read_and_repeats_no_question() {
        for (code, chapters) in [
            ("read-b-7", &["the-line-of-impact"][..]),
            ("read-bf-7", &["the-line-of-impact", "marbles"]),
            ("read-abcdefghijklmnopq-42", &LETTERS.map(|(_, id)| id)),
        ] {
            let round = Round::of(Code::parse(code).unwrap());
            assert_eq!(round, Round::of(Code::parse(code).unwrap()));
            let questions = round.questions();
            assert!((3..=10).contains(&questions.len()), "{code}");
            for (i, question) in questions.iter().enumerate() {
                let taught = question.topic.taught_on().unwrap().chapter;
                assert!(chapters.contains(&taught), "{code}: {}", question.topic);
                let again = |other: &Question| other.text == question.text;
                assert!(!questions[..i].iter().any(again), "{code}");
            }
        }
    }

    #[test]
    fn chapters_without_questions_give_no_round() {
        assert_eq!(ChaptersRead::of(["a-worked-shot"]), None);
        assert_eq!(ChaptersRead::of(["my-own-chapter"]), None);
        let read = ChaptersRead::of(["marbles", "my-own-chapter", "the-line-of-impact"]);
        assert_eq!(read.unwrap().to_string(), "bf");
    }
}

//! The definition of a round, and the code that fixes the round.

use std::fmt;

use std::sync::Arc;
use thiserror::Error;

use super::ChaptersRead;
use crate::quiz::concepts::{Library, QuestionSet};
use crate::quiz::families;
use crate::quiz::question::{Family, Misconception, Topic};

/// The names of personal rounds, which are stored with answers in the same form as
/// codes.
const PERSONAL: [&str; 2] = ["review", "met"];

/// The prefix before the chapters' letters in a code.
const READ: &str = "read";

/// The definition of a round.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// Which questions the round asks.
    pub kind: CourseKind,
    /// The number of questions.
    pub count: usize,
}

/// Which questions a round asks.
#[derive(Debug, Clone, PartialEq)]
pub enum CourseKind {
    /// Ten hits to predict; this is the round whose code is a bare number.
    Hits,
    /// A few questions of all kinds.
    Quick,
    /// All kinds of questions, mixed by an older rule, for existing codes.
    Mixed,
    /// All kinds of questions, mixed so that the common misconceptions are tested often enough to
    /// be detected.
    Even,
    /// A round that finds out what a student believes: each question depends on the answers so far.
    /// The round begins with a question about equal masses.
    FindOut,
    /// A round that finds out what a student believes, but can begin with any question; for
    /// existing codes.
    FindOutFromAny,
    /// Questions that can show this misconception.
    Check(Misconception),
    /// All kinds of questions, with no feedback until the end.
    Exam,
    /// Questions before a unit.
    Before,
    /// The parallel questions after the unit: with the same seed, these are different questions
    /// that test the same ideas.
    After,
    /// Questions of one family.
    Topic(Family),
    /// Questions about the topics that these chapters teach.
    Read(ChaptersRead),
    /// Questions about these topics, which the player has read about or answered questions about.
    Met(Vec<Topic>),
    /// One question about each of these topics, which are due for review, with those that have been
    /// due longest first. If there are many topics, only the first ones are included.
    Review(Vec<Topic>),
    /// A teacher's own questions in words. A code that has just been read does not contain the
    /// questions yet: [`Code::with_own`] adds them.
    Own(Arc<Library>),
    /// A set that a teacher has put together. A code that has just been read does not contain the
    /// questions yet: [`Code::with_own`] adds them.
    Set(Arc<QuestionSet>),
}

impl CourseKind {
    /// The kinds in the menu that are always available to everyone, apart from rounds on a single
    /// topic.
    pub const ALWAYS: [Self; 5] = [
        Self::FindOut,
        Self::Quick,
        Self::Even,
        Self::Hits,
        Self::Exam,
    ];

    /// The name of this kind in codes.
    pub fn id(&self) -> &'static str {
        self.entry().0
    }

    /// The name of this kind as shown.
    pub fn name(&self) -> &'static str {
        self.entry().1
    }

    /// The number of questions in a round of this kind, unless another number is chosen.
    pub fn length(&self) -> usize {
        self.entry().2
    }

    /// The name in codes, the name as shown, and the usual number of questions.
    fn entry(&self) -> (&'static str, &'static str, usize) {
        match self {
            Self::Hits => ("hits", "ten hits", families::where_to::LENGTH),
            Self::Quick => ("quick", "quick five", 5),
            Self::Mixed => ("mixed", "older mixed ten", 10),
            Self::Even => ("even", "mixed ten", 10),
            Self::FindOut => ("beliefs", "find out what you believe", 12),
            Self::FindOutFromAny => ("find-out", "older find out", 12),
            Self::Check(misconception) => (misconception.id(), misconception.name(), 2),
            Self::Exam => ("exam", "exam", 15),
            Self::Before => ("before", "before the unit", 10),
            Self::After => ("after", "after the unit", 10),
            Self::Topic(family) => (family.id(), family.name(), 6),
            Self::Read(_) => (READ, "what you have read", 10),
            Self::Met(_) => ("met", "topics you have met", 10),
            Self::Review(due) => ("review", "review", due.len().min(Course::REVIEWED)),
            Self::Own(_) => ("own", "your own questions", 10),
            Self::Set(set) => {
                let count = match set.questions.len() {
                    0 => Course::MOST,
                    count => count,
                };
                ("set", "a set of questions", count)
            }
        }
    }

    /// Whether the kind depends on one player's record, so that its rounds have no code.
    pub fn is_personal(&self) -> bool {
        matches!(self, Self::Met(_) | Self::Review(_))
    }

    /// The kind with this `id`; `None` for a kind that depends on one player's record.
    pub fn with_id(id: &str) -> Option<Self> {
        let topics = Self::topics().map(Self::Topic);
        let checks = Misconception::ALL.iter().copied().map(Self::Check);
        let read = || ChaptersRead::parse(id.strip_prefix(READ)?.strip_prefix('-')?);
        Self::ALWAYS
            .into_iter()
            .chain([Self::Mixed, Self::FindOutFromAny, Self::Own(Arc::default())])
            .chain([Self::Set(Arc::default()), Self::Before, Self::After])
            .chain(topics)
            .chain(checks)
            .find(|kind| kind.id() == id)
            .or_else(|| read().map(Self::Read))
    }

    /// The families that have a round on a single topic: all except [`Family::WhereTo`], for which
    /// there is a separate course.
    pub fn topics() -> impl Iterator<Item = Family> {
        let all = Family::ALL.iter().copied();
        all.filter(|family| *family != Family::WhereTo)
    }
}

impl Course {
    /// The maximum number of questions in a round.
    pub const MOST: usize = 60;
    /// The maximum number of questions in a review; the remaining topics are left for the next
    /// review.
    pub const REVIEWED: usize = 10;

    /// Creates a course of the usual length.
    pub fn new(kind: CourseKind) -> Self {
        let count = kind.length();
        Self { kind, count }
    }

    /// Creates a course of `count` questions, clamped to the range from 1 to [`Course::MOST`]; a
    /// round of ten hits always has ten, a review has one question per topic but at most
    /// [`Course::REVIEWED`], and a set has all of its questions.
    pub fn of(kind: CourseKind, count: usize) -> Self {
        let count = match kind {
            CourseKind::Hits | CourseKind::Review(_) | CourseKind::Set(_) => kind.length(),
            _ => count.clamp(1, Self::MOST),
        };
        Self { kind, count }
    }

    /// Whether feedback is given only at the end.
    pub(crate) fn feedback_at_end(&self) -> bool {
        use CourseKind::{After, Before, Exam};
        matches!(self.kind, Exam | Before | After) || self.follows_answers()
    }

    /// Whether questions depend on earlier answers, so that the round can neither be printed nor
    /// given to a class.
    pub(crate) fn follows_answers(&self) -> bool {
        use CourseKind::{FindOut, FindOutFromAny};
        matches!(self.kind, FindOut | FindOutFromAny)
    }
}

/// The code of a round: the same code gives the same questions on every machine and in every
/// version.
///
/// Examples: `even-7`; with a count, `even12-7`; for a topic, `speeds-7`; for a misconception,
/// `copied-angle-7`; for what some chapters teach, `read-abd-7`; for ten hits, `hits-7` or simply
/// `7`. Only `own-7` and the code of a set, `set-7`, also depend on the teacher's files, and only
/// `beliefs-7` and `find-out-7` on the answers.
#[derive(Debug, Clone, PartialEq)]
pub struct Code {
    /// The definition of the round.
    pub course: Course,
    /// The seed of the random choices.
    pub seed: u64,
}

/// The reason why a text is not the code of a round.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NoCode {
    /// The text does not look like a code.
    #[error(
        "expected the code of a round, such as mixed-7, quick-7, exam-7, a topic such as \
         speeds-7, or 7 for ten hits"
    )]
    Unlike,
    /// A round cannot have that many questions.
    #[error(
        "expected 1 to {} questions in the code of a round, as in mixed12-7",
        Course::MOST
    )]
    Count,
    /// A round of ten hits always has ten questions.
    #[error("expected the code of ten hits without a number of questions, as in hits-7")]
    Hits,
    /// A review, or a round about topics that a player has met, depends on that player's record.
    #[error(
        "a review has no code, because it is different for everyone; choose it in carrom quiz, or \
         give a code such as mixed-7"
    )]
    Personal,
}

impl Code {
    /// The code of the ten hits with this seed.
    pub fn hits(seed: u64) -> Self {
        Self {
            course: Course::new(CourseKind::Hits),
            seed,
        }
    }

    /// Reads a code; returns `None` if the text is not a code. Letter case and surrounding spaces
    /// do not matter.
    pub fn parse(text: &str) -> Option<Self> {
        Self::read(text).ok()
    }

    /// Reads a code. Letter case and surrounding spaces do not matter.
    ///
    /// # Errors
    /// Returns the reason if the text is not a code.
    pub fn read(text: &str) -> Result<Self, NoCode> {
        let text = text.trim().to_ascii_lowercase();
        let (name, seed) = text.rsplit_once('-').unwrap_or(("hits", &text));
        if !seed.bytes().all(|b| b.is_ascii_digit()) {
            return Err(NoCode::Unlike);
        }
        let seed = seed.parse().map_err(|_| NoCode::Unlike)?;
        let id = name.trim_end_matches(|c: char| c.is_ascii_digit());
        if PERSONAL.contains(&id) {
            return Err(NoCode::Personal);
        }
        let kind = CourseKind::with_id(id).ok_or(NoCode::Unlike)?;
        let course = match &name[id.len()..] {
            "" => Course::new(kind),
            count => {
                let fixed = kind == CourseKind::Hits;
                let course = (count.parse().ok())
                    .map(|count| (count, Course::of(kind, count)))
                    // A code is invalid if its number of questions would be changed.
                    .filter(|(count, course)| course.count == *count);
                let no_count = if fixed { NoCode::Hits } else { NoCode::Count };
                course.ok_or(no_count)?.1
            }
        };
        Ok(Self { course, seed })
    }

    /// Reads the round that is stored with an answer. The result is a code in its usual spelling,
    /// or the name of a personal round, which cannot be opened again.
    ///
    /// # Errors
    /// Returns the reason if the text is neither.
    pub(crate) fn read_noted(text: &str) -> Result<(String, Option<Self>), NoCode> {
        match Self::read(text) {
            Ok(code) => Ok((code.to_string(), Some(code))),
            Err(NoCode::Personal) => {
                let text = text.trim().to_ascii_lowercase();
                let (name, seed) = text.rsplit_once('-').ok_or(NoCode::Unlike)?;
                let seed: u64 = seed.parse().map_err(|_| NoCode::Unlike)?;
                let count = name.trim_start_matches(|c: char| c.is_ascii_lowercase());
                let counts = 1..=Course::MOST;
                let fits = count.is_empty() || count.parse().is_ok_and(|it| counts.contains(&it));
                match fits {
                    true => Ok((format!("{name}-{seed}"), None)),
                    false => Err(NoCode::Count),
                }
            }
            Err(other) => Err(other),
        }
    }

    /// The code, if its questions are the same for everyone, whatever their answers.
    ///
    /// # Errors
    /// Returns the reason in words if the questions depend on the answers.
    pub(crate) fn same_for_all(self) -> Result<Self, String> {
        match self.course.follows_answers() {
            true => Err(format!(
                "expected a round that is the same for everyone; the questions of {self} depend on \
                 the answers"
            )),
            false => Ok(self),
        }
    }

    /// The code with a teacher's own questions or set added, if the code requires them.
    ///
    /// # Errors
    /// Returns the reason in words if the code requires such questions but there are none.
    pub fn with_own(mut self, own: &Arc<Library>) -> Result<Self, String> {
        if let CourseKind::Own(library) = &mut self.course.kind {
            if own.concepts.is_empty() {
                return Err(format!(
                    "expected questions of your own for the code {self}; --concepts gives their folder"
                ));
            }
            *library = Arc::clone(own);
        }
        if let CourseKind::Set(_) = &self.course.kind {
            let set = own.sets.iter().find(|set| set.seed == self.seed);
            return set.map(Self::of_set).ok_or_else(|| {
                format!(
                    "expected the set with the code {self}; --set gives its file, and a set whose \
                     questions have changed has another code"
                )
            });
        }
        Ok(self)
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (kind, seed) = (&self.course.kind, self.seed);
        let count = match self.course.count {
            usual if usual == kind.length() => String::new(),
            count => count.to_string(),
        };
        match kind {
            CourseKind::Hits => write!(f, "{seed}"),
            CourseKind::Read(chapters) => write!(f, "{READ}-{chapters}{count}-{seed}"),
            _ => write!(f, "{}{count}-{seed}", kind.id()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_code_is_printed_as_it_was_read() {
        for text in [
            "7",
            "mixed-7",
            "mixed12-18446744073709551615",
            "even-7",
            "even20-7",
            "find-out-7",
            "find-out8-7",
            "copied-angle-7",
            "heavy-unmoved4-7",
            "quick-0",
            "exam-3",
            "speeds-12",
            "from-angle4-12",
            "own-7",
            "own3-7",
            "set-7",
            "read-a-7",
            "read-abdl5-12",
        ] {
            let code = Code::parse(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!(code.to_string(), text);
        }
        assert_eq!(Code::parse(" Hits-7 "), Code::parse("7"));
        assert_eq!(Code::parse("mixed10-7"), Code::parse("mixed-7"));
    }

    #[test]
    fn the_round_of_a_stored_answer_is_named_by_its_code() {
        let noted = |text| Code::read_noted(text).map(|(name, code)| (name, code.is_some()));
        for (text, name, is_code) in [
            (" MIXED10-007 ", "mixed-7", true),
            ("hits-7", "7", true),
            ("own3-7", "own3-7", true),
            ("Review-7", "review-7", false),
            ("review4-7", "review4-7", false),
        ] {
            assert_eq!(noted(text), Ok((name.into(), is_code)), "{text}");
        }
        for text in [
            "",
            "=1-1",
            "mixed",
            "review",
            "review99-7",
            "review=1-7",
            "@review-7",
        ] {
            assert!(noted(text).is_err(), "{text}");
        }
        let long = format!("review{}-7", "0".repeat(1000));
        assert_eq!(noted(&long), Err(NoCode::Count));
    }

    #[test]
    fn an_invalid_code_is_refused() {
        for text in [
            "",
            "-",
            "mixed",
            "mixed-",
            "mixed--7",
            "-7",
            "mixed-+7",
            "nothing-7",
            "review-7",
            "hits12-7",
            "mixed0-7",
            "mixed61-7",
            "set5-7",
            "mixed99999999999999999999-7",
            "mixed-18446744073709551616",
            "7.5",
            "sieben",
            "read-7",
            "read--7",
            "read-ba-7",
            "read-az-7",
            "read-e-7",
        ] {
            assert_eq!(Code::parse(text), None, "{text}");
        }
    }
}

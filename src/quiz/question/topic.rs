//! What questions are about: the topics of questions, and the families that ask about each topic.
//!
//! Knowledge and reviews are stored by topic. One family may ask about several topics, and several
//! families may ask about one topic, each in its own way. The topic of a question in words is the
//! name of the question's file. Such topics need not be listed here, because teachers choose their
//! own.

use std::borrow::Cow;
use std::fmt;
use std::sync::LazyLock;

use serde::{Deserialize, de::DeserializeOwned};

use super::{Family, Figures, Passage};

/// What a question is about. Store a topic by its [`id`](Self::id), which never changes; show its
/// [`name`](Self::name). Topics with the same id are equal.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Topic(Cow<'static, str>);

/// The description of a topic, which is a row of `assets/topics.csv`. The topics of each chapter,
/// and their order, must not change, because codes such as `read-abd-7` depend on them; pages may
/// change.
#[derive(Deserialize)]
struct TopicRow {
    id: String,
    name: String,
    /// The ids of the generated families that ask about this topic.
    families: String,
    chapter: String,
    page: String,
}

static ROWS: LazyLock<Vec<TopicRow>> =
    LazyLock::new(|| rows(include_str!("../../../assets/topics.csv")));

/// The rows of a table in `assets`.
fn rows<T: DeserializeOwned>(text: &str) -> Vec<T> {
    let rows = csv::Reader::from_reader(text.as_bytes()).into_deserialize();
    rows.filter_map(Result::ok).collect()
}

/// The topic of the question on a page of a chapter, which is a row of `assets/checkpoints.csv`.
#[derive(Deserialize)]
struct CheckpointRow {
    chapter: String,
    page: String,
    topic: String,
}

static CHECKPOINTS: LazyLock<Vec<CheckpointRow>> =
    LazyLock::new(|| rows(include_str!("../../../assets/checkpoints.csv")));

/// The page on a topic for a case that the topic's usual page does not cover, which is a row of
/// `assets/topic_pages.csv`.
#[derive(Deserialize)]
struct CaseRow {
    topic: String,
    case: String,
    chapter: String,
    page: String,
}

static CASES: LazyLock<Vec<CaseRow>> =
    LazyLock::new(|| rows(include_str!("../../../assets/topic_pages.csv")));

/// The case that a question is about, which follows from its figures: "lossy", "unequal" (masses)
/// or "equal".
pub(in crate::quiz) fn case(figures: &Figures) -> &'static str {
    let figure = |name: &str| figures.get(name).and_then(|it| it.as_f64());
    if figure("restitution").is_some_and(|e| e < 1.0) {
        "lossy"
    } else if figure("m1_g") != figure("m2_g") {
        "unequal"
    } else {
        "equal"
    }
}

impl Topic {
    /// The topic under which the question on a chapter's page is reviewed; `None` for chapters
    /// written by a teacher.
    pub(crate) fn of_checkpoint(chapter: &str, page: &str) -> Option<Self> {
        let mut rows = CHECKPOINTS.iter();
        let row = rows.find(|row| row.chapter == chapter && row.page == page)?;
        Some(Self::with_id(row.topic.as_str()))
    }

    /// The topic with this id. An unknown id belongs to a question in words; the name of the topic
    /// then consists of the words in the id.
    pub fn with_id(id: impl Into<Cow<'static, str>>) -> Self {
        Self(id.into())
    }

    /// The topics of the generated families.
    #[cfg(test)]
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        ROWS.iter()
            .filter(|it| !it.families.is_empty())
            .map(|it| Self::with_id(it.id.as_str()))
    }

    /// The id of the topic: "corner-with-loss".
    pub fn id(&self) -> &str {
        &self.0
    }

    fn known(&self) -> Option<&'static TopicRow> {
        ROWS.iter().find(|row| row.id == self.0)
    }

    /// The name of the topic as shown: "separation, with loss".
    pub fn name(&self) -> String {
        match self.known() {
            Some(row) => row.name.clone(),
            None => self.0.replace('-', " "),
        }
    }

    /// The generated families with questions about this topic.
    pub(in crate::quiz) fn families_of_figures(&self) -> Vec<Family> {
        let families = self.known().map_or("", |row| &row.families);
        families.split(' ').filter_map(Family::with_id).collect()
    }

    /// The topics that the chapter with this id teaches.
    pub(crate) fn taught_in(chapter: &str) -> impl Iterator<Item = Self> {
        let taught = ROWS.iter().filter(move |row| row.chapter == chapter);
        taught.map(|row| Self::with_id(row.id.as_str()))
    }

    /// The page that teaches this topic; `None` for a subject chosen by a teacher.
    pub fn taught_on(&self) -> Option<Passage> {
        let TopicRow { chapter, page, .. } = self.known()?;
        Some(Passage { chapter, page })
    }

    /// The page that teaches the part of this topic that a question with these figures is about.
    pub(crate) fn taught_for(&self, figures: &Figures) -> Option<Passage> {
        let case = case(figures);
        let mut rows = CASES.iter();
        let found = rows.find(|row| row.topic == self.0 && row.case == case);
        let of_case = found.map(|CaseRow { chapter, page, .. }| Passage { chapter, page });
        of_case.or_else(|| self.taught_on())
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
    fn no_two_topics_have_the_same_id_or_name() {
        let lines = include_str!("../../../assets/topics.csv").lines().count();
        assert_eq!(ROWS.len(), lines - 1);
        let of = |text: fn(&TopicRow) -> &str| ROWS.iter().map(text).collect::<BTreeSet<_>>();
        assert_eq!(of(|it| &it.id).len(), ROWS.len());
        assert_eq!(of(|it| &it.name).len(), ROWS.len());
    }

    #[test]
    fn the_topic_table_names_only_known_families() {
        for row in ROWS.iter().filter(|row| !row.families.is_empty()) {
            for id in row.families.split(' ') {
                assert!(Family::with_id(id).is_some(), "{}: {id}", row.id);
            }
        }
    }
}

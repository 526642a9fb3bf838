//! The descriptions of the misconceptions, which are read from `assets/misconceptions.toml`.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;

use crate::quiz::question::{Figures, Misconception, Passage, Topic, case};

/// The description of a misconception.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Description {
    name: String,
    advice: String,
    chapter: String,
    page: String,
    source: String,
    elsewhere: Vec<Elsewhere>,
}

/// A page that corrects a misconception in questions about these topics. "centre-of-mass/turn"
/// stands for the questions on the topic "centre-of-mass" that ask for Θ ("turn"), and
/// "target-speed/unequal" for the questions on "target-speed" with unequal masses and no loss.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Elsewhere {
    topics: Vec<String>,
    chapter: String,
    page: String,
}

/// The kind of source for a misconception: a study, a common slip, or a plausible wrong step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// A study that describes the misconception: "Hestenes et al. 1992: greater mass implies
    /// greater force".
    Study(&'static str),
    /// A slip in algebra or reading, rather than a belief.
    Slip,
    /// The result of a plausible wrong step; we know of no study that describes this misconception.
    Ours,
}

impl Misconception {
    /// The name as shown: "always 90°".
    pub fn name(self) -> &'static str {
        &self.description().name
    }

    /// Advice on what to try next to correct the misconception.
    pub fn advice(self) -> &'static str {
        &self.description().advice
    }

    /// The source for this misconception.
    pub fn origin(self) -> Origin {
        match self.description().source.as_str() {
            "slip" => Origin::Slip,
            "ours" => Origin::Ours,
            study => Origin::Study(study),
        }
    }

    /// The page of a chapter that corrects the misconception.
    pub(crate) fn settled_by(self) -> Passage {
        let Description { chapter, page, .. } = self.description();
        Passage { chapter, page }
    }

    /// The page that corrects the misconception in a question about this topic with these figures.
    pub(crate) fn settled_in(self, topic: &Topic, figures: &Figures) -> Passage {
        let names = Self::names_of_case(topic, figures);
        let elsewhere = self.description().elsewhere.iter();
        let of_name = |name| elsewhere.clone().find(|it| it.topics.contains(name));
        let found = names.iter().find_map(of_name);
        found.map_or_else(
            || self.settled_by(),
            |Elsewhere { chapter, page, .. }| Passage { chapter, page },
        )
    }

    /// The names that `elsewhere` may use for a question, starting with the most specific: by what
    /// the question asks for, by its masses and loss, and by its topic.
    pub(crate) fn names_of_case(topic: &Topic, figures: &Figures) -> [String; 3] {
        let asked = figures.get("asked").and_then(|it| it.as_str());
        let id = topic.id();
        let of = |part: &str| format!("{id}/{part}");
        [
            of(asked.unwrap_or_default()),
            of(case(figures)),
            id.to_owned(),
        ]
    }

    /// The topics, and the names of cases such as `topic/asked`, for which `elsewhere` gives a
    /// page.
    #[cfg(test)]
    pub(crate) fn settled_elsewhere(self) -> impl Iterator<Item = &'static str> {
        let elsewhere = self.description().elsewhere.iter();
        elsewhere.flat_map(|it| it.topics.iter().map(String::as_str))
    }

    fn description(self) -> &'static Description {
        static ALL: LazyLock<BTreeMap<String, Description>> = LazyLock::new(|| {
            let text = include_str!("../../../assets/misconceptions.toml");
            toml::from_str(text).unwrap_or_default()
        });
        static NONE: LazyLock<Description> = LazyLock::new(Description::default);
        ALL.get(self.id()).unwrap_or(&NONE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_misconception_is_described_and_nothing_else_is() {
        let text = include_str!("../../../assets/misconceptions.toml");
        let described: BTreeMap<String, toml::Table> = toml::from_str(text).unwrap();
        let described: Vec<&str> = described.keys().map(String::as_str).collect();
        let mut known: Vec<&str> = Misconception::ALL.iter().map(|it| it.id()).collect();
        known.sort_unstable();
        assert_eq!(described, known);
        for it in Misconception::ALL {
            let Description {
                name,
                advice,
                chapter,
                page,
                source,
                elsewhere,
            } = it.description();
            for topic in elsewhere.iter().flat_map(|it| &it.topics) {
                let id = topic.split('/').next().unwrap_or_default().to_owned();
                assert!(Topic::with_id(id).taught_on().is_some(), "{topic}");
            }
            assert!(
                [name, advice, chapter, page, source]
                    .iter()
                    .all(|text| !text.is_empty()),
                "{name}"
            );
        }
    }
}

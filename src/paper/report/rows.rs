//! The tables of the report.

use std::collections::BTreeMap;

use crate::lessons::{Bookmark, Chapter, ChapterLibrary};
use crate::levels::{Level, LevelLibrary, MOST_STARS, Pack, Starred};
use crate::paper::clean;
use crate::progress::words::degrees;
use crate::progress::{HeldBelief, LATELY, Mastery, TopicStanding, Trend};
use crate::quiz::NAMED_ODDS;

/// The maximum number of columns in the name of a topic, and in any other name in a table.
const TOPIC: usize = 60;
const NAME: usize = 34;
/// The maximum number of rows in each table, so that everything fits on one page.
const MOST_TOPICS: usize = 10;
const MOST_BELIEFS: usize = 6;
const MOST_CHAPTERS: usize = 12;
const MOST_PACKS: usize = 10;

/// A cell of a table.
#[derive(Debug, Clone)]
pub(super) enum ReportCell {
    /// The name of what the row is about.
    Name(String),
    Text(String),
    /// Text to notice.
    Strong(String),
    Number(String),
    /// A share from 0 to 1, drawn as a bar where that is possible, and the text beside it.
    Share(f64, String),
}

impl ReportCell {
    fn state(name: &str, is_strong: bool) -> Self {
        match is_strong {
            true => Self::Strong(name.to_owned()),
            false => Self::Text(name.to_owned()),
        }
    }

    pub(super) fn text(&self) -> &str {
        match self {
            Self::Name(text) | Self::Text(text) | Self::Strong(text) => text,
            Self::Number(text) | Self::Share(_, text) => text,
        }
    }
}

/// A table of the report with its title.
#[derive(Debug, Clone, Default)]
pub(super) struct ReportSection {
    pub(super) title: &'static str,
    pub(super) heads: &'static [&'static str],
    pub(super) rows: Vec<Vec<ReportCell>>,
    /// The sentence in place of a table without rows.
    pub(super) none: &'static str,
    /// The text below the table: how many rows are left out, and what the numbers mean.
    pub(super) notes: Vec<String>,
}

impl ReportSection {
    /// The first `most` rows, with a note on the number of further rows.
    fn cut(rows: impl Iterator<Item = Vec<ReportCell>>, most: usize) -> Self {
        let mut rows: Vec<_> = rows.collect();
        let more = rows.len().saturating_sub(most);
        rows.truncate(most);
        let more = (more > 0).then(|| format!("and {more} more"));
        Self {
            rows,
            notes: more.into_iter().collect(),
            ..Self::default()
        }
    }
}

pub(super) fn topics(met: &[TopicStanding]) -> ReportSection {
    let row = |topic: &TopicStanding| {
        let (all, lately, mastery) = (&topic.all, &topic.lately, topic.mastery());
        let share = lately.right as f64 / LATELY as f64;
        vec![
            ReportCell::Name(clean(&topic.name, TOPIC)),
            ReportCell::state(mastery.name(), mastery == Mastery::Solid),
            ReportCell::Number(of((all.right, all.attempts))),
            ReportCell::Share(share, of((lately.right, lately.attempts))),
            ReportCell::Number(degrees(all.mean_error_deg())),
        ]
    };
    ReportSection {
        title: "Topics",
        heads: &["topic", "state", "right", "of the last five", "error"],
        none: "No quiz questions yet.",
        ..ReportSection::cut(met.iter().map(row), MOST_TOPICS)
    }
}

pub(super) fn beliefs(held: &[HeldBelief]) -> ReportSection {
    let row = |belief: &HeldBelief| {
        let trend = belief.trend();
        vec![
            ReportCell::Text(belief.misconception.name().to_owned()),
            ReportCell::Number(belief.before.to_string()),
            ReportCell::Number(belief.since.to_string()),
            ReportCell::state(trend.name(), matches!(trend, Trend::New | Trend::Held)),
        ]
    };
    let mut section = ReportSection {
        title: "Misconceptions",
        heads: &["what wrong answers had in common", "before", "since", ""],
        none: "No known misconception stands out in the answers.",
        ..ReportSection::cut(held.iter().map(row), MOST_BELIEFS)
    };
    section.notes.push(format!(
        "How many answers fitted the misconception, out of the questions that could have shown it: \
         in the first half of the answers, and since. A misconception is listed once it explains \
         the answers {NAMED_ODDS} times better than guessing does."
    ));
    section
}

/// The chapters that have been started, in the order of the table of contents.
pub(super) fn chapters(
    library: &ChapterLibrary,
    marks: &BTreeMap<String, Bookmark>,
) -> ReportSection {
    let row = |chapter: &Chapter| {
        let mark = marks.get(&chapter.id)?;
        Some(vec![
            ReportCell::Name(clean(&chapter.title, NAME)),
            ReportCell::Number(of((mark.seen(chapter), chapter.pages.len()))),
            ReportCell::Number(of((mark.right(chapter), chapter.checkpoints()))),
        ])
    };
    ReportSection {
        title: "Chapters",
        heads: &["chapter", "pages read", "questions right"],
        none: "None started yet.",
        ..ReportSection::cut(library.chapters.iter().filter_map(row), MOST_CHAPTERS)
    }
}

/// The packs in which stars have been won.
pub(super) fn packs(library: &LevelLibrary, stars: &[Starred]) -> ReportSection {
    let row = |pack: &Pack| {
        let stars = stars_of(pack, stars);
        let name = || ReportCell::Name(clean(&pack.title(), NAME));
        (stars.0 > 0).then(|| vec![name(), ReportCell::Number(of(stars))])
    };
    ReportSection {
        title: "Levels",
        heads: &["pack", "stars"],
        none: "No stars yet.",
        ..ReportSection::cut(library.packs.iter().filter_map(row), MOST_PACKS)
    }
}

/// The number of stars won in a pack, and the total number.
pub(super) fn stars_of(pack: &Pack, stars: &[Starred]) -> (usize, usize) {
    let won = |level: &Level| {
        let of_it = { stars.iter() }.filter(|it| it.pack == pack.name && it.level == level.id);
        let most = of_it.map(|it| it.stars.min(MOST_STARS)).max();
        usize::from(most.unwrap_or(0))
    };
    let most = usize::from(MOST_STARS) * pack.levels.len();
    (pack.levels.iter().map(won).sum(), most)
}

/// Two numbers as "2 of 6".
pub(super) fn of((some, all): (usize, usize)) -> String {
    format!("{some} of {all}")
}

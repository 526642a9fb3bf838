//! The tables of the report.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::lessons;
use crate::levels::{self, MOST_STARS};
use crate::paper::clean;
use crate::progress::{Attempt, LESSON, Starred};

/// Columns of a name in a table.
const NAME: usize = 34;

/// The first rows of a table, and how many more there are.
#[derive(Debug, Clone)]
pub(super) struct Cut<T> {
    pub(super) rows: Vec<T>,
    pub(super) more: usize,
}

impl<T> Cut<T> {
    pub(super) fn new(mut rows: Vec<T>, most: usize) -> Self {
        let more = rows.len().saturating_sub(most);
        rows.truncate(most);
        Self { rows, more }
    }

    /// "and 3 more"; nothing where there are none.
    pub(super) fn and_more(&self) -> Option<String> {
        (self.more > 0).then(|| format!("and {} more", self.more))
    }
}

/// A chapter that was begun.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct ChapterRow {
    pub(super) title: String,
    /// How many of its questions were answered right at least once.
    pub(super) right: usize,
    /// How many questions it has.
    pub(super) questions: usize,
}

/// The chapters that were begun, in their order.
pub(super) fn chapters(library: &lessons::Library, attempts: &[Attempt]) -> Vec<ChapterRow> {
    // By chapter the pages that were answered, and whether ever right.
    let mut answered: BTreeMap<String, BTreeMap<u32, bool>> = BTreeMap::new();
    for attempt in attempts.iter().filter(|it| it.family == LESSON) {
        let question: Value = serde_json::from_str(&attempt.question).unwrap_or_default();
        if let Some(id) = question["chapter"].as_str() {
            let pages = answered.entry(id.to_owned()).or_default();
            *pages.entry(attempt.number).or_default() |= attempt.right;
        }
    }
    let row = |chapter: &lessons::Chapter| {
        let pages = answered.get(&chapter.id)?;
        let asks = |number: u32| {
            let at = usize::try_from(number).ok()?.checked_sub(1)?;
            chapter.pages.get(at)?.checkpoint.as_ref()
        };
        // A chapter may have changed since it was read.
        let right = pages
            .iter()
            .filter(|(page, right)| **right && asks(**page).is_some());
        let questions = chapter
            .pages
            .iter()
            .filter(|page| page.checkpoint.is_some());
        Some(ChapterRow {
            title: clean(&chapter.title, NAME),
            right: right.count(),
            questions: questions.count(),
        })
    };
    library.chapters.iter().filter_map(row).collect()
}

/// A pack of levels.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct PackRow {
    pub(super) title: String,
    pub(super) stars: usize,
    pub(super) most: usize,
}

/// All packs with the stars won in them.
pub(super) fn packs(library: &levels::Library, stars: &[Starred]) -> Vec<PackRow> {
    let row = |pack: &levels::Pack| {
        let won = |level: &levels::Level| {
            let of_it = stars
                .iter()
                .filter(|it| it.pack == pack.name && it.level == level.id);
            let most = of_it.map(|it| it.stars.min(MOST_STARS)).max();
            usize::from(most.unwrap_or(0))
        };
        PackRow {
            title: clean(&pack.title(), NAME),
            stars: pack.levels.iter().map(won).sum(),
            most: usize::from(MOST_STARS) * pack.levels.len(),
        }
    };
    library.packs.iter().map(row).collect()
}

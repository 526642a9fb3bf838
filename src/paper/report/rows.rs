//! The tables of the report.

use std::collections::BTreeMap;

use crate::lessons::{self, Bookmark};
use crate::levels::{self, MOST_STARS, Starred};
use crate::paper::clean;

/// The maximum number of columns in a name in a table.
const NAME: usize = 34;

/// The first rows of a table, and the number of further rows.
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

    /// "and 3 more"; `None` if there are no more.
    pub(super) fn and_more(&self) -> Option<String> {
        (self.more > 0).then(|| format!("and {} more", self.more))
    }
}

/// A chapter that has been started.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct ChapterRow {
    pub(super) title: String,
    /// The number of pages seen, and the total number of pages.
    pub(super) read: (usize, usize),
    /// The number of questions whose latest answer was right, and the total number of questions.
    pub(super) right: (usize, usize),
    /// Whether the chapter has been read and answered completely.
    pub(super) done: bool,
}

/// The chapters that have been started, in the order of the table of contents.
pub(super) fn chapters(
    library: &lessons::ChapterLibrary,
    marks: &BTreeMap<String, Bookmark>,
) -> Vec<ChapterRow> {
    let row = |chapter: &lessons::Chapter| {
        let mark = marks.get(&chapter.id)?;
        Some(ChapterRow {
            title: clean(&chapter.title, NAME),
            read: (mark.seen(chapter), chapter.pages.len()),
            right: (mark.right(chapter), chapter.checkpoints()),
            done: mark.is_done(chapter),
        })
    };
    library.chapters.iter().filter_map(row).collect()
}

/// Two numbers as "2 of 6".
pub(super) fn of((some, all): (usize, usize)) -> String {
    format!("{some} of {all}")
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct PackRow {
    pub(super) title: String,
    pub(super) stars: usize,
    pub(super) most: usize,
}

/// All packs with the stars won in them.
pub(super) fn packs(library: &levels::LevelLibrary, stars: &[Starred]) -> Vec<PackRow> {
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

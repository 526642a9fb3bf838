//! The one-page report on a player's progress, for a portfolio or a teacher.

mod html;
mod markdown;
mod pictures;
mod rows;

pub(crate) use pictures::ReportPicture;

use std::collections::{BTreeMap, BTreeSet};

use jiff::civil::Date;

use super::clean;
use crate::lessons::{Bookmark, Chapter, ChapterLibrary};
use crate::levels::{LevelLibrary, Starred};
use crate::messages::History;
use crate::numbers::counted;
use crate::progress::{
    Attempt, Calendar, Calibrated, LESSON, Mastery, ObservationCounts, Tally, beliefs, calibration,
    long_day, topics,
};
use crate::quiz::{Measure, RIGHT_DEG};
use rows::ReportSection;

/// The maximum number of columns in the player's name.
const NAME: usize = 44;

/// The data of a report.
#[derive(Debug, Clone, Copy)]
pub struct Sources<'a> {
    /// The player's name.
    pub player: &'a str,
    /// All of the player's answers and observations.
    pub history: &'a History,
    /// The player's bookmarks, by chapter id.
    pub marks: &'a BTreeMap<String, Bookmark>,
    /// The levels that the player has won.
    pub stars: &'a [Starred],
    /// What the player should do next.
    pub next: &'a str,
    /// All available levels.
    pub levels: &'a LevelLibrary,
    /// All available chapters.
    pub lessons: &'a ChapterLibrary,
}

/// The one-page report on a player's progress.
///
/// It fits on one sheet of A4: long tables are cut short, and the number of further rows is given.
#[derive(Debug, Clone)]
pub struct Report<'a> {
    name: String,
    attempts: &'a [Attempt],
    calendar: &'a Calendar,
    next: String,
    all: Tally,
    topics: ReportSection,
    calibration: [Calibrated; 3],
    beliefs: ReportSection,
    chapters: ReportSection,
    packs: ReportSection,
    /// What the observations show, in sentences.
    seen: Vec<String>,
    /// The number of topics that are solid.
    solid: usize,
    /// The number of chapters that have been completely read and answered, and the total number.
    done: (usize, usize),
    /// The number of stars won, and the total number of stars.
    stars: (usize, usize),
}

impl<'a> Report<'a> {
    /// Computes the contents of the report.
    pub fn new(sources: &Sources<'a>) -> Self {
        let attempts = &sources.history.attempts;
        // The chapters have a separate table.
        let mut met = topics(attempts.iter().filter(|it| it.family != LESSON));
        met.sort_by_key(|topic| std::cmp::Reverse(topic.all.attempts));
        let solid = met.iter().filter(|it| it.mastery() == Mastery::Solid);
        let solid = solid.count();
        let chapters = &sources.lessons.chapters;
        let is_done = |chapter: &&Chapter| {
            let mark = sources.marks.get(&chapter.id);
            mark.is_some_and(|mark| mark.is_done(chapter))
        };
        let packs = sources.levels.packs.iter();
        let stars = packs.map(|pack| rows::stars_of(pack, sources.stars));
        let (won, most): (Vec<_>, Vec<_>) = stars.unzip();
        let name = Some(clean(sources.player, NAME)).filter(|it| !it.is_empty());
        Self {
            name: name.unwrap_or_else(|| "a player without a name".into()),
            attempts,
            calendar: &sources.history.calendar,
            next: clean(sources.next, 300),
            all: Tally::of(attempts),
            topics: rows::topics(&met),
            calibration: calibration(attempts),
            beliefs: rows::beliefs(&beliefs(attempts)),
            chapters: rows::chapters(sources.lessons, sources.marks),
            packs: rows::packs(sources.levels, sources.stars),
            seen: ObservationCounts::new(&sources.history.observations).words(),
            solid,
            done: (chapters.iter().filter(is_done).count(), chapters.len()),
            stars: (won.iter().sum(), most.iter().sum()),
        }
    }

    /// The number of answers, and the days of the first and the last answer.
    fn span(&self) -> String {
        let count = counted(self.all.attempts, "answer");
        let times = self.attempts.iter().filter_map(|it| it.time_s);
        let days: BTreeSet<Date> = times.filter_map(|time| self.calendar.day(time)).collect();
        match (days.first(), days.last()) {
            (Some(first), Some(last)) if first == last => {
                format!("{count} on {}", long_day(*first))
            }
            (Some(first), Some(last)) => {
                let (days, [first, last]) = (days.len(), [first, last].map(|day| long_day(*day)));
                format!("{count} on {days} days, from {first} to {last}")
            }
            _ => count,
        }
    }

    /// Where the results come from, and the rules by which they were calculated.
    fn origin(&self) -> String {
        let today = self.calendar.today();
        let when = today.map_or(String::new(), |day| format!(" on {}", long_day(day)));
        format!(
            "Written by carrom{when} from the answers saved on this computer. Days begin at \
             midnight in that computer's time zone. Right: a direction within {RIGHT_DEG}° of \
             the true one, the right choice, or {}. {} A chapter is done when all of it has been \
             read and answered.",
            Measure::RIGHT,
            Mastery::MEANING,
        )
    }
}

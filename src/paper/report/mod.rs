//! The one-page report on a player's progress, for a portfolio or a teacher.

mod html;
mod markdown;
mod pictures;
mod rows;

pub(crate) use pictures::ReportPicture;

use std::collections::{BTreeMap, BTreeSet};

use jiff::civil::Date;

use super::clean;
use crate::lessons::{self, Bookmark};
use crate::levels;
use crate::levels::Starred;
use crate::messages::History;
use crate::numbers::counted;
use crate::progress::{
    Attempt, Calendar, Calibrated, HeldBelief, LESSON, Mastery, ObservationCounts, Tally,
    TopicStanding, beliefs, calibration, ends_deg, long_day, topics,
};
use crate::quiz::{Measure, RIGHT_DEG};
use rows::{ChapterRow, Cut, PackRow};

/// The maximum number of columns in the player's name.
const NAME: usize = 44;
/// The maximum number of rows in each table, so that everything fits on one page.
const MOST_TOPICS: usize = 10;
const MOST_BELIEFS: usize = 6;
const MOST_CHAPTERS: usize = 12;
const MOST_PACKS: usize = 10;

/// The data of a report.
#[derive(Debug, Clone, Copy)]
pub struct Sources<'a> {
    /// The player's name.
    pub player: &'a str,
    /// All of the player's answers.
    pub history: &'a History,
    /// The player's bookmarks, by chapter id.
    pub marks: &'a BTreeMap<String, Bookmark>,
    /// The levels that the player has won.
    pub stars: &'a [Starred],
    /// What the player should do next.
    pub next: &'a str,
    /// All available levels.
    pub levels: &'a levels::LevelLibrary,
    /// All available chapters.
    pub lessons: &'a lessons::ChapterLibrary,
}

/// The one-page report on a player's progress.
///
/// It fits on one sheet of A4: long tables are cut short, and the number of further rows is given.
#[derive(Debug, Clone)]
pub struct Report<'a> {
    name: String,
    attempts: &'a [Attempt],
    calendar: &'a Calendar,
    next: &'a str,
    all: Tally,
    topics: Cut<TopicStanding>,
    calibration: [Calibrated; 3],
    beliefs: Cut<HeldBelief>,
    chapters: Cut<ChapterRow>,
    packs: Cut<PackRow>,
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
        let chapters = rows::chapters(sources.lessons, sources.marks);
        let done = chapters.iter().filter(|it| it.done).count();
        let packs = rows::packs(sources.levels, sources.stars);
        let won = packs.iter().map(|pack| pack.stars).sum();
        let most = packs.iter().map(|pack| pack.most).sum();
        let begun: Vec<_> = packs.into_iter().filter(|pack| pack.stars > 0).collect();
        let name = clean(sources.player, NAME);
        Self {
            name: if name.is_empty() {
                "a player without a name".into()
            } else {
                name
            },
            attempts,
            calendar: &sources.history.calendar,
            next: sources.next,
            all: Tally::of(attempts),
            topics: Cut::new(met, MOST_TOPICS),
            calibration: calibration(attempts),
            beliefs: Cut::new(beliefs(attempts), MOST_BELIEFS),
            chapters: Cut::new(chapters, MOST_CHAPTERS),
            packs: Cut::new(begun, MOST_PACKS),
            seen: ObservationCounts::new(&sources.history.observations).words(),
            solid,
            done: (done, sources.lessons.chapters.len()),
            stars: (won, most),
        }
    }

    /// The report as an HTML document that contains its pictures.
    pub fn html(&self) -> String {
        Self::html_of_all(std::slice::from_ref(self))
    }

    /// Several reports as one HTML document, each on its own page.
    pub(crate) fn html_of_all(reports: &[Self]) -> String {
        html::document(reports)
    }

    /// The report as a Markdown document. Its pictures are in `folder`, a path relative to the
    /// document.
    pub fn markdown(&self, folder: &str) -> String {
        markdown::document(self, folder)
    }

    /// All pictures for which there are enough answers.
    pub fn pictures(&self) -> Vec<ReportPicture> {
        pictures::all(self)
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

    /// The mean errors of the first ten angles and of the last ten.
    fn ends(&self) -> Option<(f64, f64)> {
        ends_deg(self.attempts)
    }

    fn next(&self) -> String {
        clean(self.next, 300)
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

//! The path through carrom: the player's next step, the reason for it, and the progress so far.
//!
//! The order is fixed, and each step, once taken, changes what led to it, so the path has no loops:
//!
//! 1. a misconception that is not settled: the page about it, then a check. A failed check is
//!    repeated on the next day at the earliest;
//! 2. a chapter that has been begun;
//! 3. *Find out*, while almost nothing is known about the player;
//! 4. a chapter for a missed topic: the first chapter that is neither done nor known, up to the
//!    chapter that teaches the topic; if most answers are right, only the chapter that teaches it;
//! 5. a review of the topics that are due, once a day;
//! 6. the next chapter that is neither done nor known; if most answers are right, questions about
//!    it instead, because the player may know it already;
//! 7. the next pack of levels;
//! 8. the table.

use indexmap::{IndexMap, IndexSet};

use crate::lessons::{Book, Chapter};
use crate::levels::Shelf;
use crate::numbers::counted;
use crate::progress::{Attempt, Calendar, Due, Tally, UnsettledBelief, page_about, unsettled};
use crate::quiz::{ChaptersRead, Confidence, CourseKind, Misconception, Topic};

/// With fewer quiz answers than this, the path suggests *Find out*.
const ENOUGH_ANSWERS: usize = 3;
/// The maximum number of chapters that one round asks about.
const ASKED_AT_ONCE: usize = 3;

/// A player with fewer quiz answers than this is new.
const NEW: usize = 10;
/// The topics for a new player: collisions of equal masses, in pictures.
const FIRST_TOPICS: [&str; 3] = ["equal-masses", "equal-masses-by-offset", "from-the-picture"];

/// What is known about a player.
#[derive(Debug, Clone, Copy)]
pub struct PathSoFar<'a> {
    /// All answers, in the order in which they were given.
    pub attempts: &'a [Attempt],
    /// The current time, and the player's calendar.
    pub calendar: &'a Calendar,
    /// The chapters, with the player's bookmarks.
    pub book: &'a Book,
    /// The levels, with the player's stars.
    pub shelf: &'a Shelf,
}

/// A step that the path can suggest.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// Read the page about a misconception.
    ReadPage {
        /// The index of the chapter.
        chapter: usize,
        /// The index of the page.
        page: usize,
    },
    /// Answer questions that show whether the player still holds a misconception.
    Check(Misconception),
    /// Continue a chapter, or begin one.
    Read {
        /// The index of the chapter.
        chapter: usize,
        /// The index of the page to continue at; `None` if the chapter was never opened.
        page: Option<usize>,
    },
    /// Find out what the player believes.
    FindOut,
    /// Review the topics that are due.
    Review(Due),
    /// Play the level with this index, which is the next in its pack.
    Level(usize),
    /// Answer questions about chapters that have not been read.
    Ask(ChaptersRead),
    /// Play at the table.
    Table,
}

/// The next step, and the reason for it.
#[derive(Debug, Clone, PartialEq)]
pub struct NextStep {
    /// What to do.
    pub step: Step,
    /// The step in a few words: "Continue chapter 4, page 3".
    pub words: String,
    /// The reason, in a sentence or two.
    pub why: String,
}

/// How much of the path is done, and how long it is in total.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PathDone {
    /// The number of chapters that are finished or known, and the total number.
    pub chapters: (usize, usize),
    /// The number of named misconceptions that are settled, and the total number of named ones.
    pub beliefs: (usize, usize),
    /// The number of packs in which every level has been won, and the total number.
    pub packs: (usize, usize),
}

/// For each topic, whether the last answer shows that the player knows it; `None` if that answer
/// was right but marked "guess".
type TopicsAsked<'a> = IndexMap<&'a str, Option<bool>>;

impl<'a> PathSoFar<'a> {
    /// The next step.
    pub fn next_step(&self) -> NextStep {
        let topics = self.topics_asked();
        let answers = self.quiz_answers().count();
        self.belief()
            .or_else(|| self.begun())
            .or_else(|| (answers < ENOUGH_ANSWERS).then(find_out))
            .or_else(|| self.missed(&topics))
            .or_else(|| self.review())
            .or_else(|| self.next_chapter(&topics))
            .or_else(|| self.pack())
            .unwrap_or_else(|| {
                let why = "Every chapter is done or known, and every level is won.";
                NextStep::new(Step::Table, "Play at the table", why)
            })
    }

    /// How much is done.
    pub fn done(&self) -> PathDone {
        let topics = self.topics_asked();
        let chapters = self.chapters().len();
        let open = (0..chapters).filter(|at| self.is_open(*at, &topics));
        let known = chapters - open.count();
        let (held, named) = unsettled(self.attempts);
        let mut packs: IndexMap<&str, bool> = IndexMap::new();
        for (number, (pack, _)) in self.shelf.levels().enumerate() {
            *packs.entry(&pack.name).or_insert(true) &= self.shelf.stars(number) > 0;
        }
        PathDone {
            chapters: (known, chapters),
            beliefs: (named - held.len(), named),
            packs: (packs.values().filter(|won| **won).count(), packs.len()),
        }
    }

    /// The topics of a round without a code: equal masses, the topics of the chapters that were
    /// read, and, unless the player is new, the topics that were answered before.
    pub fn topics_met(&self) -> Vec<Topic> {
        let read = self.book.read_through();
        let taught = read.flat_map(|chapter| Topic::taught_in(&chapter.id));
        let is_new = self.quiz_answers().count() < NEW;
        let answered = self.quiz_answers().filter(|_| !is_new);
        let answered = answered.map(|it| Topic::with_id(it.topic.clone()));
        let first = FIRST_TOPICS.map(Topic::with_id).into_iter();
        let all = first.chain(taught).chain(answered);
        // A teacher's own topics have no questions here.
        let all: IndexSet<Topic> = all.filter(|it| !it.families().is_empty()).collect();
        all.into_iter().collect()
    }

    fn quiz_answers(&self) -> impl Iterator<Item = &'a Attempt> {
        self.attempts.iter().filter(|it| it.is_of_quiz())
    }

    fn chapters(&self) -> &'a [Chapter] {
        &self.book.library().chapters
    }

    fn is_today(&self, attempt: &Attempt) -> bool {
        let day = attempt.time_s.and_then(|time_s| self.calendar.day(time_s));
        day == self.calendar.today()
    }

    fn belief(&self) -> Option<NextStep> {
        let (unsettled, _) = unsettled(self.attempts);
        let ready = |it: &&UnsettledBelief| !(it.failed_check() && self.is_today(it.last));
        let belief = unsettled.iter().find(ready)?;
        let misconception = belief.misconception;
        let name = misconception.name();
        let why = match belief.shown.len() {
            1 => format!("Because one of your answers showed this: {name}."),
            times => format!("Because {times} of your answers showed this: {name}."),
        };
        let passage = page_about(misconception, belief.shown.iter().copied())?;
        let (chapter, page) = self.book.find(passage)?;
        let number = self.chapters()[chapter].number;
        let mark = self.book.mark(passage.chapter);
        let has_seen = mark.is_some_and(|mark| mark.pages.contains_key(passage.page));
        Some(match has_seen {
            false => {
                let words = format!("Read chapter {number}, page {}", page + 1);
                NextStep::new(Step::ReadPage { chapter, page }, words, why)
            }
            true => {
                let why = format!("{why} Chapter {number}, page {}, covers it.", page + 1);
                NextStep::new(Step::Check(misconception), "Check with two questions", why)
            }
        })
    }

    fn begun(&self) -> Option<NextStep> {
        let (chapter, page) = self.book.begun()?;
        let of_it = &self.chapters()[chapter];
        let seen = self.book.mark(&of_it.id).map_or(0, |mark| mark.seen(of_it));
        let why = match of_it.pages.len() - seen {
            0 => "One of its questions is not answered yet.".into(),
            _ => format!("You have read {seen} of its {} pages.", of_it.pages.len()),
        };
        let words = format!("Continue chapter {}, page {}", of_it.number, page + 1);
        let page = Some(page);
        Some(NextStep::new(Step::Read { chapter, page }, words, why))
    }

    /// The ids of the topics about which the player has been asked, in the quiz or in a chapter.
    fn topics_asked(&self) -> TopicsAsked<'a> {
        let mut asked = TopicsAsked::new();
        for attempt in self.attempts {
            if let Some(topic) = attempt.quiz_topic() {
                let guessed = attempt.confidence == Some(Confidence::Guess);
                let known = (!attempt.right || !guessed).then_some(attempt.right);
                asked.insert(topic, known);
            }
        }
        asked
    }

    /// Whether a chapter is neither done nor known. A chapter is known if at least one of its
    /// topics was asked about, and the last answers show that the player knows all such topics. A
    /// chapter without topics is known if the chapter before it is.
    fn is_open(&self, at: usize, topics: &TopicsAsked) -> bool {
        !self.book.is_done(&self.chapters()[at]) && !self.is_known(at, topics)
    }

    fn is_known(&self, at: usize, topics: &TopicsAsked) -> bool {
        let mut taught = Topic::taught_in(&self.chapters()[at].id).peekable();
        if taught.peek().is_none() {
            return at > 0 && self.is_known(at - 1, topics);
        }
        let mut asked = taught.filter_map(|it| topics.get(it.id())).peekable();
        asked.peek().is_some() && asked.all(|known| *known == Some(true))
    }

    /// Whether at least four in five quiz answers are right. If so, the path leads straight to the
    /// chapters that teach missed topics, and asks about the others if there are questions on them.
    fn knows_most(&self) -> bool {
        let all = Tally::of(self.quiz_answers());
        5 * all.right >= 4 * all.attempts
    }

    /// The chapter to read for a missed topic. The topics of a chapter count as missed if more of
    /// them were last answered wrong than right.
    fn missed(&self, topics: &TopicsAsked) -> Option<NextStep> {
        let knows_most = self.knows_most();
        let missed = |at: usize| {
            let taught: Vec<Topic> = Topic::taught_in(&self.chapters()[at].id).collect();
            let last = |right| {
                let is_it = move |it: &&Topic| topics.get(it.id()) == Some(&Some(right));
                taught.iter().filter(is_it)
            };
            let wrong = last(false).next().cloned()?;
            let count = last(false).count();
            // If a player knows most topics, a single slip is left to the review.
            (count > last(true).count() && (count > 1 || !knows_most)).then_some(wrong)
        };
        let mut open = (0..self.chapters().len()).filter(|at| self.is_open(*at, topics));
        let (teacher, topic) = open.find_map(|at| Some((at, missed(at)?)))?;
        let chapter = match knows_most {
            true => teacher,
            false => (0..=teacher).find(|at| self.is_open(*at, topics))?,
        };
        let name = topic.name();
        let mut why = format!("Because you missed this: {}.", name.trim_end_matches('?'));
        if chapter != teacher {
            let [first, last] = [chapter, teacher].map(|at| self.chapters()[at].number);
            why += &format!(" Chapter {last} teaches it, and builds on chapter {first}.");
        }
        Some(self.begin(chapter, why))
    }

    fn begin(&self, chapter: usize, why: String) -> NextStep {
        let words = format!("Read chapter {}", self.chapters()[chapter].number);
        let page = None;
        NextStep::new(Step::Read { chapter, page }, words, why)
    }

    fn review(&self) -> Option<NextStep> {
        let is_review = |it: &&Attempt| it.is_of_review() && self.is_today(it);
        if self.attempts.iter().rev().any(|it| is_review(&it)) {
            return None;
        }
        let due = Due::of(self.attempts, self.calendar);
        let (first, all) = (due.first().len(), due.now.len());
        let words = format!("Review {}", counted(first, "topic"));
        let why = match all - first {
            0 => "You missed these, or it is time to repeat them.".into(),
            _ => format!("{all} topics are due. Ten a day is enough."),
        };
        (first > 0).then(|| NextStep::new(Step::Review(due), words, why))
    }

    fn next_chapter(&self, topics: &TopicsAsked) -> Option<NextStep> {
        let all = self.chapters().len();
        let last = self.chapters().iter().rposition(|it| self.book.is_done(it));
        let after = last.map_or(0, |last| last + 1);
        let from_there = (after..all).chain(0..after);
        let mut open = from_there.filter(|at| self.is_open(*at, topics));
        if self.knows_most() {
            let mut open: Vec<usize> = open.collect();
            open.sort_unstable();
            return self.ask(&open);
        }
        let why = format!("You have read {} chapters.", self.book.done());
        open.next().map(|chapter| self.begin(chapter, why))
    }

    /// Questions about the first few of these chapters. If none has questions, the step is to read
    /// the first one.
    fn ask(&self, open: &[usize]) -> Option<NextStep> {
        let has_questions = |it: &&Chapter| ChaptersRead::of([it.id.as_str()]).is_some();
        let asked = open.iter().map(|at| &self.chapters()[*at]);
        let asked: Vec<_> = asked.filter(has_questions).take(ASKED_AT_ONCE).collect();
        let Some(chapters) = ChaptersRead::of(asked.iter().map(|it| it.id.as_str())) else {
            let why = "You have not read it yet.".to_owned();
            return open.first().map(|chapter| self.begin(*chapter, why));
        };
        let numbers: Vec<String> = asked.iter().map(|it| it.number.to_string()).collect();
        let named = match numbers.split_last() {
            Some((last, [])) => format!("chapter {last}"),
            Some((last, others)) => format!("chapters {} and {last}", others.join(", ")),
            None => String::new(),
        };
        let words = format!("Questions on {named}");
        let why = format!("You have not read {named}. If you know it already, you can skip it.");
        Some(NextStep::new(Step::Ask(chapters), words, why))
    }

    fn pack(&self) -> Option<NextStep> {
        let level = self.shelf.next()?;
        let (pack, _) = self.shelf.get(level)?;
        let won = (0..).zip(self.shelf.levels());
        let won = won.filter(|(at, (of, _))| of.name == pack.name && self.shelf.stars(*at) > 0);
        let (won, all) = (won.count(), pack.levels.len());
        let words = format!("Levels: {}", pack.title().to_lowercase());
        let why = format!("You have won {won} of the {all} levels in this pack.");
        Some(NextStep::new(Step::Level(level), words, why))
    }
}

fn find_out() -> NextStep {
    let why = "At most twelve questions, and your answers choose the chapters for you. Guessing is \
               fine.";
    NextStep::new(Step::FindOut, "Find out what you believe", why)
}

impl NextStep {
    fn new(step: Step, words: impl Into<String>, why: impl Into<String>) -> Self {
        let (words, why) = (words.into(), why.into());
        Self { step, words, why }
    }
}

impl Step {
    /// The quiz round of this step, if it has one.
    pub fn round(&self) -> Option<CourseKind> {
        match self {
            Self::Check(misconception) => Some(CourseKind::Check(*misconception)),
            Self::FindOut => Some(CourseKind::FindOut),
            Self::Review(due) => due.course(),
            Self::Ask(chapters) => Some(CourseKind::Read(chapters.clone())),
            _ => None,
        }
    }

    /// The index of the chapter that this step leads to.
    pub fn chapter(&self) -> Option<usize> {
        match self {
            Self::ReadPage { chapter, .. } | Self::Read { chapter, .. } => Some(*chapter),
            _ => None,
        }
    }
}

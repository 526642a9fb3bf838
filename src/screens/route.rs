//! The routes of the app.

use std::sync::Arc;

use strum::IntoStaticStr;

use crate::class::JoinCode;
use crate::game::{BoardCode, Rules};
use crate::measure::Measurement;
use crate::physics::CollisionSpec;
use crate::quiz::{Answer, Code};

/// A screen to open, with its contents. The name of a route is the one used in links.
#[derive(Debug, Clone, PartialEq, IntoStaticStr)]
#[strum(serialize_all = "lowercase")]
pub enum Route {
    /// The first screen.
    Home,
    /// The lab.
    Lab,
    /// The lab with a collision set up.
    #[strum(serialize = "lab")]
    LabOf {
        /// The collision.
        setup: CollisionSpec,
        /// Whether its outcome is hidden until the player has predicted it.
        hidden: bool,
    },
    /// The table of contents of the chapters.
    Learn,
    /// The glossary.
    Glossary,
    /// The chapter with this index among all chapters, at the page where the player left it.
    #[strum(serialize = "lesson")]
    Chapter(usize),
    /// A page of a chapter, to look something up; the chapter's bookmark does not change.
    #[strum(serialize = "lesson")]
    Page {
        /// The chapter's index among all chapters.
        chapter: usize,
        /// The page, from 0.
        page: usize,
    },
    /// The round of the quiz with this code; with `None` the player chooses one.
    Quiz(Option<Code>),
    /// An interrupted round of the quiz, to resume.
    #[strum(serialize = "quiz")]
    OpenRound {
        /// The code of the round.
        code: Code,
        /// The answers so far, in the order of the questions. They are already saved.
        answers: Vec<Answer>,
        /// Whether the last answer is still being explained.
        is_explained: bool,
    },
    /// A round for a class that shares one screen.
    Class {
        /// The code of the round; with `None` the teacher chooses one.
        code: Option<Code>,
        /// The names of the teams, as far as they are known.
        teams: Vec<String>,
        /// The name of the class; may be empty.
        name: String,
    },
    /// A round for a class in which each pupil uses their own device.
    #[strum(serialize = "class")]
    Host {
        /// The code of the round; with `None` the teacher chooses one.
        code: Option<Code>,
        /// The name of the class; may be empty.
        name: String,
        /// Whether carrom gives nicknames to the devices instead of asking for names.
        nicknames: bool,
    },
    /// The screen on which a teacher prepares lessons and evaluates their results.
    Teacher,
    /// A pupil's device in a class.
    Join {
        /// The address of the class, empty if it is unknown; `None` if its host has served the
        /// page.
        address: Option<String>,
        /// The class's join code, if it is known.
        code: Option<JoinCode>,
        /// Whether the pupil has already joined once and is rejoining without the form.
        again: bool,
    },
    /// The foil, with its beams of many particles, at a page.
    Foil(FoilPage),
    /// The table: carrom itself.
    Table,
    /// The board for one player with this code; with `None` it is the board of the day.
    Board(Option<BoardCode>),
    /// A set of rules of carrom.
    Rules(Rules),
    /// A measured collision.
    Measured(Arc<Measurement>),
    /// The player's progress.
    Progress,
    /// The player's settings.
    Settings,
    /// The list of levels.
    Levels,
    /// The level with this index among all levels.
    Level(usize),
}

/// A page of the foil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FoilPage {
    /// The path of one particle, with those of some others.
    #[default]
    Tracks,
    /// A beam, with its particles counted by angle.
    Counts,
    /// Geiger and Marsden's counts.
    Measured,
}

impl FoilPage {
    /// All pages, in the order of their tabs.
    pub const ALL: [Self; 3] = [Self::Tracks, Self::Counts, Self::Measured];

    /// Its name on the tab.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Tracks => "one particle",
            Self::Counts => "a beam",
            Self::Measured => "counted in 1913",
        }
    }
}

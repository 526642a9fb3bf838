//! The routes of the app.

use std::sync::Arc;

use crate::class::JoinCode;
use crate::game::{BoardCode, Rules};
use crate::measure::Measurement;
use crate::physics::CollisionSpec;
use crate::quiz::{Answer, Code};

/// A screen to open, with its contents.
#[derive(Debug, Clone, PartialEq)]
pub enum Route {
    /// The first screen.
    Home,
    /// The lab.
    Lab,
    /// The lab with a collision set up.
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
    /// A chapter, at the page where the player left it.
    Chapter {
        /// Its index among all chapters.
        number: usize,
    },
    /// A page of a chapter, to look something up; the chapter's bookmark does not change.
    Page {
        /// The chapter's index among all chapters.
        number: usize,
        /// The page, from 0.
        page: usize,
    },
    /// The quiz.
    Quiz {
        /// The code of the round to play; with `None` the player chooses one.
        code: Option<Code>,
    },
    /// An interrupted round of the quiz, to resume.
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
        /// The address of the class, if it is known; `None` if its host has served the page.
        address: Option<String>,
        /// The class's join code, if it is known.
        code: Option<JoinCode>,
        /// Whether the pupil has already joined once and is rejoining without the form.
        again: bool,
    },
    /// The foil: beams of many particles.
    Foil,
    /// A page of the foil.
    FoilAt {
        /// The page.
        page: FoilPage,
    },
    /// The table: carrom itself.
    Table,
    /// A board for one player.
    Board {
        /// The code of the board; with `None` it is the board of the day.
        code: Option<BoardCode>,
    },
    /// The rules of carrom.
    Rules {
        /// The set of rules.
        rules: Rules,
    },
    /// A measured collision.
    Measured {
        /// The measurement.
        measurement: Arc<Measurement>,
    },
    /// The player's progress.
    Progress,
    /// The player's settings.
    Settings,
    /// The list of levels.
    Levels,
    /// A level.
    Level {
        /// Its index among all levels.
        number: usize,
    },
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

//! The routes of the app.

use crate::class::JoinCode;
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
        /// The hit.
        setup: CollisionSpec,
    },
    /// The contents of the lessons.
    Learn,
    /// The glossary.
    Glossary,
    /// A chapter, where it was left.
    Chapter {
        /// Its place among all chapters, from 0.
        number: usize,
    },
    /// A page of a chapter, to look something up: where the chapter was left stays.
    Page {
        /// The chapter's place among all, from 0.
        number: usize,
        /// The page, from 0.
        page: usize,
    },
    /// The quiz.
    Quiz {
        /// The code of the round to play; with `None` one is chosen there.
        code: Option<Code>,
    },
    /// A round of the quiz, resumed where it was left.
    OpenRound {
        /// The code of the round.
        code: Code,
        /// The answers so far, in the order of the questions. They are already saved.
        answers: Vec<Answer>,
        /// Whether the last of them is still being explained.
        is_explained: bool,
    },
    /// A round for a class round one screen.
    Class {
        /// The code of the round; `None` leaves it to be chosen.
        code: Option<Code>,
        /// The names of the teams, as far as they are known.
        teams: Vec<String>,
        /// The name of the class; may be empty.
        name: String,
    },
    /// A round for a class on devices of their own.
    Host {
        /// The code of the round; `None` leaves it to be chosen.
        code: Option<Code>,
        /// The name of the class; may be empty.
        name: String,
    },
    /// A pupil's device in a class.
    Join {
        /// The address of the class, if it is known; `None` if its host has served the page.
        address: Option<String>,
        /// Its code, if that is known.
        code: Option<JoinCode>,
        /// Whether the pupil had joined and returns without a question.
        again: bool,
    },
    /// The foil: beams of many particles.
    Foil,
    /// One of its pages.
    FoilAt {
        /// The page.
        page: FoilPage,
    },
    /// The table: carrom itself.
    Table,
    /// What the player has done so far.
    Progress,
    /// The player's settings.
    Settings,
    /// The list of levels.
    Levels,
    /// A level.
    Level {
        /// Its place among all levels, from 0.
        number: usize,
    },
}

/// A page of the foil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FoilPage {
    /// One particle, and some beside it.
    #[default]
    Tracks,
    /// A beam, counted by angle.
    Counts,
    /// Geiger and Marsden's counts.
    Measured,
}

impl FoilPage {
    /// All pages, in their order.
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

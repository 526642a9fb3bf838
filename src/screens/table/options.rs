//! What is agreed at the table before the first break.

use crate::game::{Hands, PieceSet, Rules, Seat, Setup, Team};

/// Helps drawn while aiming, each to be switched on or off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Aids {
    /// The way of the striker to the first disc it meets.
    pub line: bool,
    /// The striker as it will stand when it meets it.
    pub ghost: bool,
    /// Where both will leave that hit.
    pub rays: bool,
}

impl Default for Aids {
    fn default() -> Self {
        Self {
            line: true,
            ghost: true,
            rays: true,
        }
    }
}

/// Everything that can be chosen for a game.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// Singles or doubles.
    pub hands: Hands,
    /// The rules.
    pub rules: Rules,
    /// The pieces.
    pub set: PieceSet,
    /// Helps while aiming.
    pub aids: Aids,
    /// Whether the players call the first impact before each stroke.
    pub call: bool,
}

impl Options {
    /// The game these options make, its packs shaken by `seed`.
    pub fn setup(&self, seed: u64) -> Setup {
        Setup {
            rules: self.rules,
            hands: if self.rules == Rules::Practice {
                Hands::Two
            } else {
                self.hands
            },
            set: self.set,
            first_breaker: Seat::South,
            seed: Some(seed),
        }
    }

    /// What the player at a seat is called.
    pub fn seat_name(&self, seat: Seat) -> &'static str {
        match seat {
            _ if self.rules == Rules::Practice => "you",
            Seat::South => "South",
            Seat::East => "East",
            Seat::North => "North",
            Seat::West => "West",
        }
    }

    /// What a team is called.
    pub fn team_name(&self, team: Team) -> &'static str {
        match (self.hands, team) {
            _ if self.rules == Rules::Practice => "you",
            (Hands::Two, Team::First) => "South",
            (Hands::Two, Team::Second) => "North",
            (Hands::Four, Team::First) => "South + North",
            (Hands::Four, Team::Second) => "East + West",
        }
    }
}

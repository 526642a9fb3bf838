//! The seats, the teams and the order of turns.

use std::ops::{Index, IndexMut};

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// A side of the board, named as on a map with y to the north.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, strum::IntoStaticStr,
)]
#[serde(rename_all = "snake_case")]
pub enum Seat {
    /// Below the board, facing up.
    #[default]
    South,
    /// On the right of the board.
    East,
    /// Above the board.
    North,
    /// On the left of the board.
    West,
}

impl Seat {
    /// The four seats, each the right-hand neighbour of the previous one.
    pub const ALL: [Self; 4] = [Self::South, Self::East, Self::North, Self::West];

    /// The neighbour to the right.
    pub const fn right(self) -> Self {
        Self::ALL[(self as usize + 1) % 4]
    }

    /// The seat across the board.
    pub(crate) const fn opposite(self) -> Self {
        self.right().right()
    }

    /// The anticlockwise angle of [`Seat::turn`] in degrees.
    pub fn turned_by_deg(self) -> f64 {
        90.0 * f64::from(self as u8)
    }

    /// Turns a position relative to South into the corresponding position relative to this seat, by
    /// quarter turns without rounding.
    pub fn turn(self, from_south: DVec2) -> DVec2 {
        match self {
            Self::South => from_south,
            Self::East => DVec2::new(-from_south.y, from_south.x),
            Self::North => -from_south,
            Self::West => DVec2::new(from_south.y, -from_south.x),
        }
    }

    /// The reverse of [`Seat::turn`].
    pub(crate) fn turn_back(self, at: DVec2) -> DVec2 {
        match self {
            Self::South | Self::North => self.turn(at),
            Self::East => Self::West.turn(at),
            Self::West => Self::East.turn(at),
        }
    }
}

/// One of the two teams: a player in singles, a pair of partners in doubles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Team {
    /// South, and in doubles North as well.
    First,
    /// North, or in doubles East and West.
    Second,
}

impl Team {
    /// Both teams.
    pub const BOTH: [Self; 2] = [Self::First, Self::Second];

    /// The other team.
    pub const fn other(self) -> Self {
        match self {
            Self::First => Self::Second,
            Self::Second => Self::First,
        }
    }
}

/// One value for each team, the first team's first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ByTeam<T>([T; 2]);

impl<T> Index<Team> for ByTeam<T> {
    type Output = T;

    fn index(&self, team: Team) -> &T {
        &self.0[team as usize]
    }
}

impl<T> IndexMut<Team> for ByTeam<T> {
    fn index_mut(&mut self, team: Team) -> &mut T {
        &mut self.0[team as usize]
    }
}

/// The number of players.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Hands {
    /// Singles: South against North.
    #[default]
    Two,
    /// Doubles: partners sit opposite each other, South and North against East and West.
    Four,
}

impl Hands {
    /// The seat that plays after `seat`: the player across the board in singles, the right-hand
    /// neighbour in doubles (22b).
    pub const fn next(self, seat: Seat) -> Seat {
        match self {
            Self::Two => seat.opposite(),
            Self::Four => seat.right(),
        }
    }

    /// The team of the player at `seat`.
    pub const fn team(self, seat: Seat) -> Team {
        match (self, seat) {
            (_, Seat::South) | (Self::Four, Seat::North) => Team::First,
            _ => Team::Second,
        }
    }

    /// Whether there is a player at `seat`.
    pub const fn plays(self, seat: Seat) -> bool {
        matches!(
            (self, seat),
            (Self::Four, _) | (_, Seat::South | Seat::North)
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turning_and_turning_back_is_exact() {
        let at = DVec2::new(0.1, -0.3);
        for seat in Seat::ALL {
            assert_eq!(seat.turn_back(seat.turn(at)), at);
        }
        assert_eq!(Seat::East.turn(DVec2::new(0.0, -1.0)), DVec2::new(1.0, 0.0));
    }

    #[test]
    fn law_22b_in_doubles_the_turn_passes_to_the_right_and_partners_sit_opposite() {
        let mut seat = Seat::South;
        for next in [Seat::East, Seat::North, Seat::West, Seat::South] {
            seat = Hands::Four.next(seat);
            assert_eq!(seat, next);
        }
        for seat in Seat::ALL {
            let team = Hands::Four.team(seat);
            assert_eq!(team, Hands::Four.team(seat.opposite()));
            assert_eq!(team.other(), Hands::Four.team(seat.right()));
        }
    }

    #[test]
    fn in_singles_south_and_north_take_turns() {
        assert_eq!(Hands::Two.next(Seat::South), Seat::North);
        assert_eq!(Hands::Two.next(Seat::North), Seat::South);
        assert_eq!(Hands::Two.team(Seat::North), Team::Second);
        assert!(!Hands::Two.plays(Seat::East));
    }
}

//! How long a game will probably last.

use super::options::Options;
use crate::game::{Length, Player, Rules};

/// The mean number of strokes in a board between two computers of the same strength, from the
/// weakest to the strongest: `cargo bench --bench strength -- 100 lengths`.
const STROKES: [(Rules, [f64; 5]); 3] = [
    (Rules::Tournament, [54.9, 38.9, 25.6, 16.1, 11.7]),
    (Rules::Friendly, [50.8, 33.4, 24.5, 16.1, 11.9]),
    (Rules::Points, [37.1, 27.2, 17.9, 9.7, 6.2]),
];
/// The mean number of boards in a tournament game, from the games measured for [`STROKES`].
const BOARDS: [f64; 5] = [7.8, 7.7, 7.4, 6.6, 5.9];
/// The mean number of games in a match between equals: two or three with the same probability.
const GAMES: f64 = 2.5;
/// The mean time for one stroke in seconds: a person aims in about 20 s, the computer in 2 s, and
/// the discs move for about 4 s.
const SECONDS: f64 = 15.0;

impl Options {
    /// The estimated length of this game in minutes, or of one board if the game is open-ended,
    /// rounded to the accuracy of the estimate; `None` if there is only one player.
    ///
    /// Both sides are assumed to be as strong as the computer, or as a regular player if no
    /// computer takes part.
    pub(super) fn minutes(&self) -> Option<u32> {
        let computer = { self.seats() }.find(|seat| self.player(*seat) == Player::Computer);
        let strength = computer.map(|seat| self.company.strengths[seat as usize]);
        let strength = strength.unwrap_or_default() as usize;
        let (_, strokes) = STROKES
            .iter()
            .find(|(rules, _)| *rules == self.setup.rules)?;
        let boards = match (self.setup.rules, self.setup.length) {
            (Rules::Tournament, Length::Game) => BOARDS[strength],
            (Rules::Tournament, Length::Match) => BOARDS[strength] * GAMES,
            _ => 1.0,
        };
        let minutes = boards * strokes[strength] * SECONDS / 60.0;
        let step = if minutes < 10.0 { 1.0 } else { 5.0 };
        Some(((minutes / step).round() * step).max(1.0) as u32)
    }
}

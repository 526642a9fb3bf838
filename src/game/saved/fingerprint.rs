//! The state of a game as one number.

use std::fmt;

use crate::game::laws::{Rules, Taken};
use crate::game::seat::Team;
use crate::game::table::Game;
use crate::numbers::{FNV_START, fnv1a};

/// A hash of a game's positions, turn, dues, queen and score. If even a single bit of these data
/// differs, the hashes differ too, except with a probability of about 10⁻¹⁹.
///
/// The algorithm is 64-bit FNV-1a. The order of these data is part of the file format, and so is
/// the order in which pieces, seats and teams are declared. The hash detects damage and differences
/// between machines, not forgery.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Fingerprint(u64);

impl Fingerprint {
    /// The fingerprint of a game.
    pub fn of(game: &Game) -> Self {
        let mut hash = Self(FNV_START);
        for coin in game.coins() {
            hash.take(&[coin.piece as u8]);
            hash.take(&coin.at.x.to_bits().to_le_bytes());
            hash.take(&coin.at.y.to_bits().to_le_bytes());
        }
        let team = |team: Option<Team>| team.map_or(0, |team| team as u8 + 1);
        let play = game.play();
        hash.take(&[
            game.seat() as u8,
            play.is_unbroken().into(),
            team(play.queen_covered_by),
            team(play.won.map(|won| won.winner)),
        ]);
        let score = game.score();
        hash.take(&[score.boards]);
        for team in Team::BOTH {
            hash.take(&[play.owed[team], score.points[team], score.games[team]]);
        }
        if game.setup().rules == Rules::Points {
            for team in Team::BOTH {
                let Taken { white, black } = play.taken[team];
                hash.take(&[white, black]);
            }
        }
        hash
    }

    /// Reads what [`Display`](fmt::Display) writes; `None` for anything else.
    pub fn parse(text: &str) -> Option<Self> {
        let digit = |c: char| matches!(c, '0'..='9' | 'a'..='f');
        if text.len() != 16 || !text.chars().all(digit) {
            return None;
        }
        u64::from_str_radix(text, 16).ok().map(Self)
    }

    fn take(&mut self, bytes: &[u8]) {
        self.0 = fnv1a(self.0, bytes);
    }
}

impl fmt::Display for Fingerprint {
    /// Sixteen hexadecimal digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_fnv_1a() {
        // Test vectors of the FNV reference.
        let of = |bytes: &[u8]| {
            let mut hash = Fingerprint(0xcbf2_9ce4_8422_2325);
            hash.take(bytes);
            hash.0
        };
        assert_eq!(of(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(of(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(of(b"foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn only_the_written_form_of_a_fingerprint_can_be_read() {
        let hash = Fingerprint(0x0012_3456_789a_bcde);
        assert_eq!(Fingerprint::parse(&hash.to_string()), Some(hash));
        for text in [
            "",
            "+123456789abcdef",
            "00123456789ABCDE",
            "00123456789abcdef",
        ] {
            assert_eq!(Fingerprint::parse(text), None, "{text}");
        }
    }
}

//! How pupils join a round on their own devices: the code on the screen, and the token that returns
//! a pupil to their seat.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

/// The letters of a [`JoinCode`]: all except the vowels and Y, so that codes do not spell words.
const LETTERS: &[u8; 20] = b"BCDFGHJKLMNPQRSTVWXZ";

/// The code for joining a class: six consonants, new for each round.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct JoinCode([u8; Self::LENGTH]);

impl JoinCode {
    /// The number of letters.
    pub const LENGTH: usize = 6;

    /// The code made from a random number. There are 20⁶ codes, 64 million.
    pub fn of(mut random: u64) -> Self {
        Self(std::array::from_fn(|_| {
            let letter = LETTERS[(random % LETTERS.len() as u64) as usize];
            random /= LETTERS.len() as u64;
            letter
        }))
    }
}

impl fmt::Display for JoinCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let letters = self.0.map(char::from);
        f.write_str(&String::from_iter(letters))
    }
}

/// The message for a string that is not a [`JoinCode`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("expected a six-letter class code, such as BCDFGH")]
pub struct NoJoinCode;

impl FromStr for JoinCode {
    type Err = NoJoinCode;

    /// Accepts upper and lower case, and ignores spaces and hyphens.
    fn from_str(text: &str) -> Result<Self, NoJoinCode> {
        let mut code = [0; Self::LENGTH];
        let mut letters = text.chars().filter(|it| !matches!(it, ' ' | '-'));
        for place in &mut code {
            let letter = letters.next().ok_or(NoJoinCode)?.to_ascii_uppercase();
            let known = LETTERS.iter().find(|it| char::from(**it) == letter);
            *place = *known.ok_or(NoJoinCode)?;
        }
        match letters.next() {
            None => Ok(Self(code)),
            Some(_) => Err(NoJoinCode),
        }
    }
}

/// The token that returns a participant to their seat: a secret of 128 random bits that only the
/// host and the device know.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct SeatToken(u128);

impl SeatToken {
    /// The token made from a random number.
    pub const fn of(random: u128) -> Self {
        Self(random)
    }

    /// A number below `limit` that reveals next to nothing about the token.
    pub(super) fn number_below(self, limit: usize) -> usize {
        (self.0 % limit.max(1) as u128) as usize
    }
}

/// The token is a secret, so it must not appear in crash reports.
impl fmt::Debug for SeatToken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("SeatToken")
    }
}

impl fmt::Display for SeatToken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:032x}", self.0)
    }
}

impl FromStr for SeatToken {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let is_hex = text.len() == 32 && text.bytes().all(|it| it.is_ascii_hexdigit());
        let number = u128::from_str_radix(text, 16).ok().filter(|_| is_hex);
        number.map(Self).ok_or("expected 32 hexadecimal digits")
    }
}

impl TryFrom<String> for SeatToken {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse()
    }
}

impl From<SeatToken> for String {
    fn from(token: SeatToken) -> Self {
        token.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_code_is_read_with_blanks_hyphens_and_in_any_case() {
        let code = JoinCode::of(0);
        assert_eq!(code.to_string(), "BBBBBB");
        assert_eq!(" b-b bbBb ".parse(), Ok(code));
        for random in [1, 19, 20, 63_999_999, u64::MAX] {
            let code = JoinCode::of(random);
            assert_eq!(code.to_string().parse(), Ok(code));
        }
        for text in ["", "BCDFG", "BCDFGHJ", "BCDFGA", "BCDFG1", "ÄCDFGH"] {
            assert_eq!(text.parse::<JoinCode>(), Err(NoJoinCode), "{text}");
        }
    }

    #[test]
    fn tokens_read_back_as_written_and_other_strings_are_refused() {
        let token = SeatToken::of(u128::MAX / 7);
        assert_eq!(token.to_string().parse(), Ok(token));
        assert_eq!(format!("{token:?}"), "SeatToken");
        for text in [
            "",
            "12",
            "+2345678901234567890123456789012",
            &"g".repeat(32),
            &"1".repeat(33),
        ] {
            assert!(text.parse::<SeatToken>().is_err(), "{text}");
        }
    }
}

//! The player's answer, and the text that stores it in databases and files.

use super::{Confidence, Rays};
use crate::physics::units::{deg_from_rad, m_from_mm, mm_from_m, rad_from_deg};

/// An answer to a question, in the form that the question requires.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Response {
    /// Where the two discs will go.
    Rays(Rays),
    /// A number, in the unit of its [`Measure`](super::Measure).
    Number(f64),
    /// A choice, by its index counted from 0.
    Choice(usize),
    /// A shot with this offset, in metres; if the offset is positive, the target is on the right.
    Shot(f64),
}

impl Response {
    /// The rays, if the answer consists of rays.
    pub const fn rays(self) -> Option<Rays> {
        match self {
            Self::Rays(rays) => Some(rays),
            _ => None,
        }
    }

    /// The text that stores the answer: "rays 60 still", "number 2.1", "choice 2" (counted from 1),
    /// "shot 15" (angles in degrees, the offset in millimetres).
    pub fn to_text(self) -> String {
        match self {
            Self::Rays(rays) => {
                let [striker, target] = [rays.striker, rays.target].map(|angle| match angle {
                    Some(angle) => deg_from_rad(angle).to_string(),
                    None => STILL.into(),
                });
                format!("rays {striker} {target}")
            }
            Self::Number(x) => format!("number {x}"),
            Self::Choice(i) => format!("choice {}", i.saturating_add(1)),
            Self::Shot(offset) => format!("shot {}", mm_from_m(offset)),
        }
    }

    /// Reads the text that [`Self::to_text`] writes; `None` if it is invalid.
    pub fn parse(text: &str) -> Option<Self> {
        let finite = |text: &str| text.parse().ok().filter(|x: &f64| x.is_finite());
        // `None` means that the disc stays still.
        let angle = |text: &str| match text {
            STILL => Some(None),
            text => finite(text).map(|angle| Some(rad_from_deg(angle))),
        };
        let words: Vec<&str> = text.split(' ').collect();
        match *words.as_slice() {
            ["rays", striker, target] => Some(Self::Rays(Rays {
                striker: angle(striker)?,
                target: angle(target)?,
            })),
            ["number", x] => finite(x).map(Self::Number),
            ["choice", i] => Some(Self::Choice(i.parse::<usize>().ok()?.checked_sub(1)?)),
            ["shot", offset] => finite(offset).map(|offset| Self::Shot(m_from_mm(offset))),
            _ => None,
        }
    }
}

/// The word for a disc that stays still.
const STILL: &str = "still";

/// An answer, and how sure the player is of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// The answer itself.
    pub said: Response,
    /// How sure the player is.
    pub confidence: Confidence,
}

impl Answer {
    /// An answer with this confidence.
    pub const fn new(said: Response, confidence: Confidence) -> Self {
        Self { said, confidence }
    }

    /// The text of the answer, followed by how sure the player is: "choice 2 think-so".
    pub fn to_text(self) -> String {
        format!("{} {}", self.said.to_text(), self.confidence.id())
    }

    /// Reads the text that [`Self::to_text`] writes; `None` if it is invalid.
    pub fn parse(text: &str) -> Option<Self> {
        let (said, confidence) = text.rsplit_once(' ')?;
        Some(Self {
            said: Response::parse(said)?,
            confidence: Confidence::with_id(confidence)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_read_back_as_written() {
        for text in [
            "rays 60 still",
            "rays -0.5 30.25",
            "number 2.1",
            "choice 2",
            "shot -15.5",
        ] {
            let said = Response::parse(text).unwrap_or_else(|| panic!("{text}"));
            assert_eq!(Response::parse(&said.to_text()), Some(said), "{text}");
        }
        assert_eq!(Response::Choice(0).to_text(), "choice 1");
    }

    #[test]
    fn an_invalid_answer_is_refused() {
        for text in [
            "",
            "rays",
            "rays 1",
            "rays 1 2 3",
            "number NaN",
            "number inf",
            "choice 0",
            "choice -1",
            "choice 1.5",
            "shot",
            "Choice 1",
            "choice  1",
            "ray 1 2",
        ] {
            assert_eq!(Response::parse(text), None, "{text}");
        }
    }
}

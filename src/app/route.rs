//! Places by their names, as the command line and links have them.

use super::Data;
use crate::quiz::Code;
use crate::screens::Place;

impl Data {
    /// The place of this name. `value` is what is to be seen there, a chapter, a level or the
    /// code of a round; it may be empty.
    ///
    /// # Errors
    /// What was expected instead, in words.
    pub fn place(&self, name: &str, value: &str) -> Result<Place, String> {
        Ok(match name {
            "home" => Place::Home,
            "learn" | "lesson" if value.is_empty() => Place::Learn,
            "learn" | "lesson" => {
                let number = self.book.library().find(value);
                let expected =
                    "the number or the name of a chapter, such as 2 or the-line-of-impact";
                Place::Chapter {
                    number: number.ok_or(expected)?,
                }
            }
            "lab" => Place::Lab,
            "foil" => Place::Foil,
            "table" => Place::Table,
            "quiz" => Place::Quiz {
                code: self.round(value)?,
            },
            "class" => Place::Class {
                code: self.round(value)?,
                teams: Vec::new(),
                name: String::new(),
            },
            "join" => Place::Join {
                address: None,
                code: None,
                again: false,
            },
            "levels" | "level" if value.is_empty() => Place::Levels,
            "levels" | "level" => {
                let number = self.shelf.find(value);
                Place::Level {
                    number: number.ok_or("the id of a level, such as dead-stop")?,
                }
            }
            "progress" => Place::Progress,
            "settings" => Place::Settings,
            _ => return Err("a screen, such as quiz".into()),
        })
    }

    /// The round of a code, with the questions of the teacher's own where it asks for them; none
    /// where nothing is said.
    fn round(&self, code: &str) -> Result<Option<Code>, String> {
        if code.is_empty() {
            return Ok(None);
        }
        let code = Code::parse(code).ok_or("the code of a round, such as mixed-7")?;
        code.with_own(&self.own).map(Some)
    }
}

//! From the bytes of a file to its questions.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

use super::figures::fill;
use super::{Concept, Wrong};
use crate::files::{self, FileError, Source, escape_control};
use crate::physics::CollisionSpec;
use crate::quiz::{Difficulty, Misconception};

/// The format that this program reads.
const FORMAT: u32 = 1;
/// Most letters of a question.
const ASK: usize = 240;
/// Most letters of a choice.
const CHOICE: usize = 90;
/// Most letters of what is said to a wrong choice.
const SAYS: usize = 200;
/// Most letters of the explanation.
const WHY: usize = 320;
/// How many wrong choices a question may have.
const WRONGS: std::ops::RangeInclusive<usize> = 2..=3;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(rename = "format")]
    _format: u32,
    item: Vec<Item>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Item {
    id: Spanned<String>,
    difficulty: Level,
    ask: Spanned<String>,
    right: Spanned<String>,
    /// The place of the right choice, from 1, where the choices have an order.
    right_place: Option<Spanned<usize>>,
    why: Spanned<String>,
    wrong: Spanned<Vec<Mistake>>,
    hit: Option<Spanned<BTreeMap<String, Spanned<Field>>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Mistake {
    choice: Spanned<String>,
    misconception: Option<Spanned<String>>,
    says: Spanned<String>,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Level {
    Easy,
    Middle,
    Hard,
}

/// The value of a field of a hit.
#[derive(Deserialize)]
#[serde(untagged, expecting = "expected a number, true or false")]
enum Field {
    Truth(bool),
    Number(f64),
}

/// Adds the questions of a file to `concepts`, which they are to differ from.
///
/// # Errors
/// The first thing that is wrong with it.
pub(super) fn file(
    subject: &str,
    name: &str,
    bytes: &[u8],
    concepts: &mut Vec<Concept>,
) -> Result<(), FileError> {
    let source = Source::of_bytes(name, bytes, files::LARGEST)?;
    let file: File = source.tables("a file of questions", FORMAT)?;
    for item in &file.item {
        let reader = Reader {
            source,
            hit: read_hit(source, item)?,
        };
        let concept = reader.concept(subject, item)?;
        if concepts.iter().any(|other| other.id == concept.id) {
            let message = format!("expected an id of its own, found {} once more", concept.id);
            return Err(source.fault(item.id.span().start, "id", message));
        }
        concepts.push(concept);
    }
    Ok(())
}

/// The hit of a question.
fn read_hit(source: Source, item: &Item) -> Result<Option<CollisionSpec>, FileError> {
    let Some(fields) = &item.hit else {
        return Ok(None);
    };
    let mut shot = CollisionSpec::default();
    for (field, value) in fields.get_ref() {
        let written = match value.get_ref() {
            Field::Truth(truth) => truth.to_string(),
            Field::Number(number) => number.to_string(),
        };
        shot.set(field, &written)
            .map_err(|message| source.fault(value.span().start, "hit", message))?;
    }
    let at = fields.span().start;
    if fields.get_ref().contains_key("alpha_deg") && fields.get_ref().contains_key("offset_mm") {
        let message = "expected alpha_deg or offset_mm, found both";
        return Err(source.fault(at, "hit", message));
    }
    shot.check()
        .map_err(|message| source.fault(at, "hit", message))?;
    Ok(Some(shot))
}

/// Reads the texts of one question.
struct Reader<'a> {
    source: Source<'a>,
    hit: Option<CollisionSpec>,
}

impl Reader<'_> {
    fn concept(&self, subject: &str, item: &Item) -> Result<Concept, FileError> {
        let wrongs = item.wrong.get_ref();
        if !WRONGS.contains(&wrongs.len()) {
            let message = format!(
                "expected {} or {} tables [[item.wrong]], found {}",
                WRONGS.start(),
                WRONGS.end(),
                wrongs.len()
            );
            return Err(self.fault(&item.wrong, "wrong", message));
        }
        let place = self.fault(&item.id, "id", "");
        let concept = Concept {
            id: self.id(&item.id)?,
            subject: subject.into(),
            difficulty: match item.difficulty {
                Level::Easy => Difficulty::Easy,
                Level::Middle => Difficulty::Middle,
                Level::Hard => Difficulty::Hard,
            },
            ask: self.text(&item.ask, "ask", ASK)?,
            right: self.text(&item.right, "right", CHOICE)?,
            wrongs: wrongs
                .iter()
                .map(|wrong| self.wrong(wrong))
                .collect::<Result<_, _>>()?,
            why: self.text(&item.why, "why", WHY)?,
            ordered: item.right_place.is_some(),
            hit: self.hit.map(|shot| shot.collision()),
            file: place.file,
            line: place.line.unwrap_or(1),
            before_right: self.before_right(item)?,
        };
        for (place, wrong) in concept.wrongs.iter().enumerate() {
            let earlier = concept.wrongs.iter().take(place).map(|other| &other.choice);
            let stands = |choice: &String| *choice == wrong.choice;
            if stands(&concept.right) || earlier.into_iter().any(stands) {
                let message = format!("expected a choice of its own, found {} twice", wrong.choice);
                return Err(self.fault(&item.wrong, "choice", message));
            }
        }
        Ok(concept)
    }

    fn wrong(&self, wrong: &Mistake) -> Result<Wrong, FileError> {
        Ok(Wrong {
            choice: self.text(&wrong.choice, "choice", CHOICE)?,
            misconception: self.misconception(wrong)?,
            says: self.text(&wrong.says, "says", SAYS)?,
        })
    }

    fn misconception(&self, wrong: &Mistake) -> Result<Option<&'static Misconception>, FileError> {
        let Some(id) = &wrong.misconception else {
            return Ok(None);
        };
        match Misconception::with_id(id.get_ref()) {
            Some(known) => Ok(Some(known)),
            None => {
                let found = escape_control(id.get_ref(), 40);
                let message = format!("expected the id of a misconception, found {found}");
                Err(self.fault(id, "misconception", message))
            }
        }
    }

    fn id(&self, id: &Spanned<String>) -> Result<String, FileError> {
        let bare = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        let id_text = id.get_ref();
        if id_text.is_empty() || id_text.len() > 40 || !id_text.chars().all(bare) {
            let message = "expected 1 to 40 lower-case letters, digits and hyphens";
            return Err(self.fault(id, "id", message));
        }
        Ok(id_text.clone())
    }

    fn before_right(&self, item: &Item) -> Result<usize, FileError> {
        let Some(place) = &item.right_place else {
            return Ok(0);
        };
        let count = item.wrong.get_ref().len() + 1;
        if !(1..=count).contains(place.get_ref()) {
            let message = format!(
                "expected a place from 1 to {count}, found {}",
                place.get_ref()
            );
            return Err(self.fault(place, "right_place", message));
        }
        Ok(place.get_ref() - 1)
    }

    /// A text with its figures, of 1 to `most` letters.
    fn text(&self, text: &Spanned<String>, field: &str, most: usize) -> Result<String, FileError> {
        let words: Vec<_> = text.get_ref().split_whitespace().collect();
        let filled =
            fill(&words.join(" "), self.hit).map_err(|message| self.fault(text, field, message))?;
        let count = filled.chars().count();
        if count == 0 || count > most || filled.chars().any(char::is_control) {
            let message = format!(
                "expected printable text of 1 to {most} letters, found {count}: {}",
                escape_control(&filled, 40)
            );
            return Err(self.fault(text, field, message));
        }
        Ok(filled)
    }

    fn fault<T>(&self, at: &Spanned<T>, field: &str, message: impl Into<String>) -> FileError {
        self.source.fault(at.span().start, field, message)
    }
}

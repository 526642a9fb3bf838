//! Reads questions from the contents of a file.

use std::collections::BTreeSet;

use super::figures::fill;
use super::{Concept, Wrong};
use crate::files::{self, Fields, FileErrors, Source, all, escape_control, one_line};
use crate::physics::CollisionSpec;
use crate::quiz::question::{Difficulty, Family, Misconception};

/// The version of the format that this program reads.
const FORMAT: u32 = 1;
/// The maximum number of characters in a question.
const ASK: usize = 240;
/// The maximum number of characters in a choice.
const CHOICE: usize = 90;
/// The maximum number of characters in the feedback for a wrong choice.
const SAYS: usize = 200;
/// The maximum number of characters in the explanation.
const WHY: usize = 320;
/// The permitted number of wrong choices.
pub(super) const WRONGS: std::ops::RangeInclusive<usize> = 2..=3;

/// The fields of a question.
const ITEM: [&str; 8] = [
    "id",
    "difficulty",
    "ask",
    "right",
    "right_place",
    "why",
    "wrong",
    "hit",
];

/// Adds the questions of a file to `concepts`; no two may have the same id.
///
/// # Errors
/// Returns all errors in the file.
pub(super) fn file(
    subject: &str,
    name: &str,
    bytes: &[u8],
    concepts: &mut Vec<Concept>,
) -> Result<(), FileErrors> {
    let source = Source::of_bytes(name, bytes, files::LARGEST)?;
    let known = ["format", "item"];
    let read = source.document("a file of questions", FORMAT..=FORMAT, &known, |fields| {
        let mut read: Vec<Option<Concept>> = Vec::new();
        for item in fields.tables("item", 1..=usize::MAX, &ITEM)? {
            let concept = concept(subject, name, &item).and_then(|concept| {
                let mut others = concepts.iter().chain(read.iter().flatten());
                if others.any(|other| other.id == concept.id) {
                    let id = concept.id;
                    return item.refuse("id", format!("expected a unique id, found {id} twice"));
                }
                Some(concept)
            });
            read.push(concept);
        }
        all(read)
    })?;
    concepts.extend(read);
    Ok(())
}

fn concept(subject: &str, file: &str, item: &Fields) -> Option<Concept> {
    let hit = item.or("hit", None, |name| {
        read_hit(&item.table(name, &CollisionSpec::field_names())?).map(Some)
    });
    // If the hit is invalid, the texts are checked with the default hit instead.
    let filled = hit.unwrap_or_else(|| Some(CollisionSpec::default()));
    let id = item.id("id");
    let difficulty = item.word("difficulty", &Difficulty::ALL.map(|it| (it.id(), it)));
    let ask = text(item, "ask", ASK, filled);
    let right = text(item, "right", CHOICE, filled);
    let why = text(item, "why", WHY, filled);
    let wrongs = item.tables("wrong", WRONGS, &["choice", "misconception", "says"]);
    let wrongs = wrongs.and_then(|wrongs| all(wrongs.iter().map(|it| wrong(it, filled)).collect()));
    let wrongs = wrongs?;
    let before_right = item.or("right_place", 0, |name| {
        let count = wrongs.len() + 1;
        let place = item.whole(name, &format!("a place from 1 to {count}"), 1..=count);
        Some(place? - 1)
    });
    let concept = Concept {
        id: id?.into(),
        family: Family::Concept,
        subject: subject.into(),
        difficulty: difficulty?,
        ask: ask?,
        right: right?,
        wrongs,
        why: why?,
        ordered: item.has("right_place"),
        hit: hit?.map(|shot| shot.collision()),
        file: file.into(),
        line: item.line(),
        before_right: before_right?,
    };
    let mut choices = BTreeSet::from([&concept.right]);
    let again = concept.wrongs.iter().find(|it| !choices.insert(&it.choice));
    if let Some(Wrong { choice, .. }) = again {
        let message = format!("expected different choices, found {choice} twice");
        return item.refuse("wrong", message);
    }
    Some(concept)
}

/// Reads a hit from its fields.
pub(crate) fn read_hit(fields: &Fields) -> Option<CollisionSpec> {
    let mut shot = CollisionSpec::default();
    fields.each(|name, written| shot.set(name, written))?;
    if fields.has("alpha_deg") && fields.has("offset_mm") {
        return fields.refuse_table("expected alpha_deg or offset_mm, found both");
    }
    match shot.check() {
        Ok(()) => Some(shot),
        Err(message) => fields.refuse_table(message),
    }
}

fn wrong(fields: &Fields, hit: Option<CollisionSpec>) -> Option<Wrong> {
    let choice = text(fields, "choice", CHOICE, hit);
    let says = text(fields, "says", SAYS, hit);
    let misconception = fields.or("misconception", None, |name| {
        fields.text_as(name, |id| {
            let unknown = || {
                let found = escape_control(id, 40);
                format!(
                    "expected the id of a misconception (carrom misconceptions prints all), found {found}"
                )
            };
            Misconception::with_id(id).map(Some).ok_or_else(unknown)
        })
    });
    Some(Wrong {
        choice: choice?,
        misconception: misconception?,
        says: says?,
    })
}

/// Reads a text of 1 to `most` characters and fills in its figures.
fn text(
    fields: &Fields,
    name: &'static str,
    most: usize,
    hit: Option<CollisionSpec>,
) -> Option<String> {
    fields.text_as(name, |text| {
        let filled = fill(&one_line(text), hit)?;
        let count = filled.chars().count();
        if count == 0 || count > most || filled.chars().any(char::is_control) {
            let found = escape_control(&filled, 40);
            return Err(format!(
                "expected text of 1 to {most} printable characters, found {count}: {found}"
            ));
        }
        Ok(filled)
    })
}

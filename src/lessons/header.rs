//! The header of a chapter: the format, title, description and shots.

use std::collections::BTreeMap;

use super::{CollisionSpec, words::Words};
use crate::files::{Fields, Source, all, is_id, one_line};
use crate::quiz::concepts::read_hit;

/// The version of the chapter format that this program reads.
const FORMAT: u32 = 1;
/// The line that precedes and follows a header.
const FENCE: &str = "+++";
/// The maximum length of a title, in characters.
const TITLE: usize = 32;
/// The maximum length of a description, in characters.
const ABOUT: usize = 100;

/// The header of a chapter; invalid parts are `None`.
pub(super) struct Header {
    pub(super) title: Option<String>,
    pub(super) about: Option<String>,
    pub(super) shots: Option<Shots>,
    /// The first line after the header.
    pub(super) ends: usize,
}

/// The named shots of a chapter.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Shots(BTreeMap<String, CollisionSpec>);

impl Shots {
    /// Takes a shot from the words of a directive: the named shot, or `usual` if the words name no
    /// shot, changed by the fields in the words. `None` if there is neither a shot nor a field.
    pub(super) fn take(
        &self,
        words: &mut Words,
        usual: Option<CollisionSpec>,
    ) -> Result<Option<CollisionSpec>, String> {
        let named = match words.first() {
            None => None,
            Some(name) => Some(*self.0.get(&name).ok_or_else(|| self.unknown(&name))?),
        };
        let fields = words.fields(CollisionSpec::has);
        CollisionSpec::check_fields(fields.iter().map(|(name, _)| name.as_str()))?;
        let mut shot = match named.or(usual) {
            None if fields.is_empty() => return Ok(None),
            shot => shot.unwrap_or_default(),
        };
        for (field, value) in fields {
            shot.set(&field, &value)?;
        }
        shot.check()?;
        Ok(Some(shot))
    }

    fn unknown(&self, name: &str) -> String {
        let known: Vec<_> = self.0.keys().map(String::as_str).collect();
        match known.as_slice() {
            [] => format!(
                "expected fields such as alpha_deg=45, because no shot has a name here, found {name}"
            ),
            known => format!(
                "expected a shot of the header ({}), found {name}",
                known.join(", ")
            ),
        }
    }
}

/// Reads the header of a file; `None` if the file has no header in this format.
pub(super) fn read(source: &Source) -> Option<Header> {
    let mut lines = source.text().split_inclusive('\n');
    let first = lines.next().unwrap_or_default();
    if first.trim_end() != FENCE {
        return source.refuse(1, "expected a header between two lines of +++");
    }
    let is_closing = |line: &&str| line.trim_end() == FENCE;
    let inside = lines.by_ref().take_while(|line| !is_closing(line));
    let inside: Vec<_> = inside.collect();
    let length: usize = inside.iter().map(|line| line.len()).sum();
    let ends = inside.len() + 2;
    if source.text().lines().count() < ends {
        return source.refuse(ends - 1, "expected +++ at the end of the header");
    }
    let part = source.part(first.len()..first.len() + length);
    let known = ["format", "title", "about", "shot"];
    let header = part.tables("a chapter", FORMAT..=FORMAT, &known, |fields| {
        Some(Header {
            title: line(fields, "title", TITLE),
            about: line(fields, "about", ABOUT),
            shots: fields.or("shot", Shots::default(), |_| shots(fields)),
            ends: ends + 1,
        })
    });
    source.absorb(part);
    header
}

/// Reads a text as a single line.
fn line(fields: &Fields, name: &str, most: usize) -> Option<String> {
    fields.text(name, most).map(one_line)
}

fn shots(fields: &Fields) -> Option<Shots> {
    let shots = fields.table("shot", &[])?;
    let tables = shots.named_tables(&CollisionSpec::field_names())?;
    let read = tables.into_iter().map(|(id, table)| {
        let shot = read_hit(&table);
        if !is_id(id) || id == "own" {
            let message = "expected a name of lower-case letters, digits and hyphens";
            return table.refuse_table(message);
        }
        Some((id.to_owned(), shot?))
    });
    Some(Shots(all(read.collect())?.into_iter().collect()))
}

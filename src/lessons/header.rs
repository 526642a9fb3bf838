//! The header of a chapter: format, title, what it is about, its shots.

use std::collections::BTreeMap;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::CollisionSpec;
use super::source::{FORMAT, Source, SourceLine};
use super::words::Words;
use crate::files::{FileError, newer};

/// What stands before and after a header.
const FENCE: &str = "+++";
/// Most letters of a title.
const TITLE: usize = 32;
/// Most letters of what a chapter is about.
const ABOUT: usize = 100;

/// The header of a chapter.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Header {
    pub(super) title: String,
    pub(super) about: String,
    pub(super) shots: Shots,
    /// The first line after it.
    pub(super) ends: usize,
}

/// The named shots of a chapter.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Shots(BTreeMap<String, CollisionSpec>);

impl Shots {
    /// Takes a shot out of the words of a directive: its name, or else `usual`, and
    /// the fields that change it. `None` if none of these is there.
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
                "expected fields such as alpha_deg=45, as no shot has a name here, found {name}"
            ),
            known => format!(
                "expected a shot of the header ({}), found {name}",
                known.join(", ")
            ),
        }
    }
}

/// Reads the header of a file.
///
/// # Errors
/// The first thing that is wrong with it.
pub(super) fn read(source: &Source) -> Result<Header, FileError> {
    let mut lines = source.lines();
    let first = lines.next().map(|(_, line)| line.trim_end());
    if first != Some(FENCE) {
        return Err(source.fault(1, "expected a header between two lines of +++"));
    }
    let inside: Vec<SourceLine> = lines
        .take_while(|(_, line)| line.trim_end() != FENCE)
        .collect();
    let ends = inside.len() + 2;
    if source.text.lines().count() < ends {
        return Err(source.fault(ends - 1, "expected +++ at the end of the header"));
    }
    let text = inside
        .iter()
        .map(|(_, line)| *line)
        .collect::<Vec<_>>()
        .join("\n");
    let tables = Tables {
        source,
        text: &text,
    };
    let document = DeTable::parse(&text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        tables.fault(at, error.message().trim())
    })?;
    let mut header = Header {
        title: String::new(),
        about: String::new(),
        shots: Shots::default(),
        ends: ends + 1,
    };
    let mut format = None;
    for (key, value) in document.get_ref() {
        let at = value.span().start;
        match key.get_ref().as_ref() {
            "format" => format = Some((at, number(value))),
            "title" => header.title = tables.words(value, "title", TITLE)?,
            "about" => header.about = tables.words(value, "about", ABOUT)?,
            "shot" => header.shots = tables.shots(value)?,
            other => {
                let at = key.span().start;
                let message = format!("expected format, title, about or shot, found {other}");
                return Err(tables.fault(at, message));
            }
        }
    }
    check_format(&tables, format)?;
    for (name, value) in [("title", &header.title), ("about", &header.about)] {
        if value.is_empty() {
            return Err(source.fault(1, format!("{name}: expected a text, found nothing")));
        }
    }
    Ok(header)
}

fn check_format(tables: &Tables, format: Option<(usize, Option<f64>)>) -> Result<(), FileError> {
    let expected = f64::from(FORMAT);
    match format {
        None => Err(tables
            .source
            .fault(1, format!("expected format = {FORMAT}, found none"))),
        Some((_, Some(found))) if (found - expected).abs() <= 0.0 => Ok(()),
        Some((at, Some(found))) if found > expected => {
            Err(tables.fault(at, format!("format: {}", newer(found, FORMAT))))
        }
        Some((at, _)) => Err(tables.fault(at, format!("expected format = {FORMAT}"))),
    }
}

/// The number a value holds.
fn number(value: &Spanned<DeValue>) -> Option<f64> {
    match value.get_ref() {
        DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
            .ok()
            .map(|n| n as f64),
        DeValue::Float(float) => float.as_str().parse().ok(),
        _ => None,
    }
}

/// The text of the header, to find the line of a fault in.
struct Tables<'a> {
    source: &'a Source<'a>,
    text: &'a str,
}

impl Tables<'_> {
    /// A fault at a byte of the header.
    fn fault(&self, at: usize, message: impl Into<String>) -> FileError {
        let before = self.text.bytes().take(at).filter(|byte| *byte == b'\n');
        self.source.fault(2 + before.count(), message)
    }

    fn words(
        &self,
        value: &Spanned<DeValue>,
        name: &str,
        most: usize,
    ) -> Result<String, FileError> {
        let text = value.get_ref().as_str().map(str::trim);
        if text.is_some_and(|text| text.contains(|c: char| c.is_control() && c != '\n')) {
            // The text of the file has none, but an escape may stand for one.
            let message = format!("{name}: expected no control characters");
            return Err(self.fault(value.span().start, message));
        }
        let fits = |text: &&str| (1..=most).contains(&text.chars().count());
        match text.filter(fits).filter(|text| !text.contains('\n')) {
            Some(text) => Ok(text.to_owned()),
            None => {
                let message = format!("{name}: expected one line of 1 to {most} letters");
                Err(self.fault(value.span().start, message))
            }
        }
    }

    fn shots(&self, value: &Spanned<DeValue>) -> Result<Shots, FileError> {
        let DeValue::Table(shots) = value.get_ref() else {
            return Err(self.fault(value.span().start, "shot: expected tables [shot.NAME]"));
        };
        let mut read = BTreeMap::new();
        for (name, fields) in shots {
            let at = name.span().start;
            let bare = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
            let id = name.get_ref().as_ref();
            if id.is_empty() || !id.chars().all(bare) || id == "own" {
                let message = "shot: expected a name of lower-case letters, digits and hyphens";
                return Err(self.fault(at, message));
            }
            let DeValue::Table(fields) = fields.get_ref() else {
                return Err(self.fault(at, "shot: expected a table of fields"));
            };
            let names = fields.keys().map(|name| name.get_ref().as_ref());
            CollisionSpec::check_fields(names).map_err(|message| self.fault(at, message))?;
            let mut shot = CollisionSpec::default();
            for (field, value) in fields {
                let at = value.span().start;
                let written = match value.get_ref() {
                    DeValue::Boolean(stick) => stick.to_string(),
                    _ => number(value).map(|n| n.to_string()).unwrap_or_default(),
                };
                shot.set(field.get_ref(), &written)
                    .map_err(|message| self.fault(at, message))?;
            }
            shot.check().map_err(|message| self.fault(at, message))?;
            read.insert(id.to_owned(), shot);
        }
        Ok(Shots(read))
    }
}

//! Reading the fields of a table, so that every fault names file, line, field and
//! what was expected.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::quantity::{NumberSpec, Range};
use crate::files::{FileError, Source, escape_control};
use glam::DVec2;

/// A table whose fields are asked for one by one.
#[derive(Debug, Clone)]
pub(super) struct Fields<'a> {
    source: Source<'a>,
    path: String,
    /// Where the table begins in the text.
    at: usize,
    table: &'a DeTable<'a>,
    /// The fields asked for so far.
    known: Vec<&'static str>,
}

type Value<'a> = &'a Spanned<DeValue<'a>>;

impl<'a> Fields<'a> {
    pub(super) fn of_document(source: Source<'a>, document: &'a Spanned<DeTable<'a>>) -> Self {
        Self::new(source, "", 0, document.get_ref())
    }

    fn new(source: Source<'a>, path: &str, at: usize, table: &'a DeTable<'a>) -> Self {
        Self {
            source,
            path: path.into(),
            at,
            table,
            known: Vec::new(),
        }
    }

    /// A fault of a field: at its value, or at the table where it is missing.
    pub(super) fn fault_at(&self, name: &str, message: impl Into<String>) -> FileError {
        let at = self.table.get(name).map_or(self.at, |v| v.span().start);
        self.source.fault(at, &self.path_of(name), message)
    }

    /// A fault of the table itself.
    pub(super) fn fault(&self, message: impl Into<String>) -> FileError {
        self.source.fault(self.at, &self.path, message)
    }

    fn path_of(&self, name: &str) -> String {
        if self.path.is_empty() {
            name.into()
        } else {
            format!("{}.{name}", self.path)
        }
    }

    fn unlike(&self, name: &str, expected: &str, found: &DeValue) -> FileError {
        self.fault_at(name, format!("expected {expected}, found {}", shown(found)))
    }

    fn missing(&self, name: &str, expected: &str) -> FileError {
        self.fault_at(name, format!("expected {expected}, found nothing"))
    }

    fn get(&mut self, name: &'static str) -> Option<Value<'a>> {
        self.known.push(name);
        self.table.get(name)
    }

    fn require(&mut self, name: &'static str, expected: &str) -> Result<Value<'a>, FileError> {
        self.get(name).ok_or_else(|| self.missing(name, expected))
    }

    /// Whether the table has the field.
    pub(super) fn has(&self, name: &str) -> bool {
        self.table.contains_key(name)
    }

    /// A table in the table.
    pub(super) fn table(&mut self, name: &'static str) -> Result<Option<Self>, FileError> {
        let Some(value) = self.get(name) else {
            return Ok(None);
        };
        let expected = format!("a table [{name}]");
        self.as_table(name, &expected, value).map(Some)
    }

    /// A table that must be there.
    pub(super) fn required_table(&mut self, name: &'static str) -> Result<Self, FileError> {
        let expected = format!("a table [{name}]");
        let value = self.require(name, &expected)?;
        self.as_table(name, &expected, value)
    }

    /// At least one and at most `most` tables of the same name.
    pub(super) fn tables(
        &mut self,
        name: &'static str,
        most: usize,
    ) -> Result<Vec<Self>, FileError> {
        let expected = format!("1 to {most} tables [[{name}]]");
        let value = self.require(name, &expected)?;
        let DeValue::Array(list) = value.get_ref() else {
            return Err(self.unlike(name, &expected, value.get_ref()));
        };
        if list.is_empty() || list.len() > most {
            let message = format!("expected {expected}, found {}", list.len());
            return Err(self.fault_at(name, message));
        }
        list.iter()
            .map(|value| self.as_table(name, &expected, value))
            .collect()
    }

    fn as_table(&self, name: &str, expected: &str, value: Value<'a>) -> Result<Self, FileError> {
        match value.get_ref() {
            DeValue::Table(table) => Ok(Self::new(
                self.source,
                &self.path_of(name),
                value.span().start,
                table,
            )),
            other => Err(self.unlike(name, expected, other)),
        }
    }

    /// A number within the bounds of a quantity, in the unit of the file.
    pub(super) fn number(
        &mut self,
        name: &'static str,
        quantity: &NumberSpec,
    ) -> Result<Option<f64>, FileError> {
        self.get(name)
            .map(|value| {
                number(value.get_ref())
                    .filter(|&x| quantity.allows(x))
                    .ok_or_else(|| self.unlike(name, &quantity.to_string(), value.get_ref()))
            })
            .transpose()
    }

    /// A number that must be there.
    pub(super) fn required_number(
        &mut self,
        name: &'static str,
        quantity: &NumberSpec,
    ) -> Result<f64, FileError> {
        self.number(name, quantity)?
            .ok_or_else(|| self.missing(name, &quantity.to_string()))
    }

    /// A range `[from, to]` with both ends within the bounds of a quantity.
    pub(super) fn range(
        &mut self,
        name: &'static str,
        quantity: &NumberSpec,
    ) -> Result<Option<Range>, FileError> {
        let Some(value) = self.get(name) else {
            return Ok(None);
        };
        let expected = format!("[from, to], {quantity}");
        let range = pair(value.get_ref())
            .filter(|&(from, to)| quantity.allows(from) && quantity.allows(to) && from < to)
            .map(|(from, to)| Range { from, to });
        range
            .map(Some)
            .ok_or_else(|| self.unlike(name, &expected, value.get_ref()))
    }

    /// A range that must be there.
    pub(super) fn required_range(
        &mut self,
        name: &'static str,
        quantity: &NumberSpec,
    ) -> Result<Range, FileError> {
        self.range(name, quantity)?
            .ok_or_else(|| self.missing(name, &format!("[from, to], {quantity}")))
    }

    /// A place `[x, y]`, each within the bounds of a quantity.
    pub(super) fn place(
        &mut self,
        name: &'static str,
        quantity: &NumberSpec,
    ) -> Result<DVec2, FileError> {
        let expected = format!("[x, y], {quantity}");
        let value = self.require(name, &expected)?;
        pair(value.get_ref())
            .filter(|&(x, y)| quantity.allows(x) && quantity.allows(y))
            .map(|(x, y)| DVec2::new(x, y))
            .ok_or_else(|| self.unlike(name, &expected, value.get_ref()))
    }

    /// A whole number from 0 to `most`; `expected` says what it stands for.
    pub(super) fn whole(
        &mut self,
        name: &'static str,
        expected: &str,
        most: usize,
    ) -> Result<usize, FileError> {
        let value = self.require(name, expected)?;
        whole(value.get_ref())
            .filter(|&n| n <= most)
            .ok_or_else(|| self.unlike(name, expected, value.get_ref()))
    }

    /// The number of one of `count` discs.
    pub(super) fn disc(&mut self, name: &'static str, count: usize) -> Result<usize, FileError> {
        self.whole(name, &disc_number(count), count.saturating_sub(1))
    }

    /// A list of 1 to `most` different discs.
    pub(super) fn discs(
        &mut self,
        name: &'static str,
        count: usize,
        most: usize,
    ) -> Result<Vec<usize>, FileError> {
        let expected = format!(
            "a list of 1 to {most} different discs, {}",
            disc_number(count)
        );
        let value = self.require(name, &expected)?;
        let unlike = |found: &DeValue| self.unlike(name, &expected, found);
        let DeValue::Array(list) = value.get_ref() else {
            return Err(unlike(value.get_ref()));
        };
        let mut discs = Vec::new();
        for item in list {
            match whole(item.get_ref()).filter(|disc| *disc < count && !discs.contains(disc)) {
                Some(disc) => discs.push(disc),
                None => return Err(unlike(item.get_ref())),
            }
        }
        if discs.is_empty() || discs.len() > most {
            return Err(unlike(value.get_ref()));
        }
        Ok(discs)
    }

    /// Printable text of 1 to `most` characters; line breaks count as spaces do.
    pub(super) fn text(&mut self, name: &'static str, most: usize) -> Result<&'a str, FileError> {
        let expected = format!("text of 1 to {most} characters");
        let value = self.require(name, &expected)?;
        text(value.get_ref(), most).ok_or_else(|| self.no_text(name, &expected, value.get_ref()))
    }

    /// A list of at most `items` texts of 1 to `most` characters each.
    pub(super) fn texts(
        &mut self,
        name: &'static str,
        items: usize,
        most: usize,
    ) -> Result<Vec<String>, FileError> {
        let expected = format!("a list of 1 to {items} texts of 1 to {most} characters");
        let value = self.require(name, &expected)?;
        let DeValue::Array(list) = value.get_ref() else {
            return Err(self.unlike(name, &expected, value.get_ref()));
        };
        if list.is_empty() || list.len() > items {
            return Err(self.unlike(name, &expected, value.get_ref()));
        }
        list.iter()
            .map(|item| {
                text(item.get_ref(), most)
                    .map(|text| text.trim().to_owned())
                    .ok_or_else(|| self.no_text(name, &expected, item.get_ref()))
            })
            .collect()
    }

    fn no_text(&self, name: &str, expected: &str, found: &DeValue) -> FileError {
        match found.as_str() {
            Some(text) if !text.chars().all(is_printable) => {
                let expected = format!("{expected}, none of them a control character");
                self.unlike(name, &expected, found)
            }
            _ => self.unlike(name, expected, found),
        }
    }

    /// One of some words, with what it stands for.
    pub(super) fn word<T: Copy>(
        &mut self,
        name: &'static str,
        words: &[(&str, T)],
    ) -> Result<T, FileError> {
        let names: Vec<_> = words.iter().map(|(word, _)| *word).collect();
        let expected = format!("one of {}", names.join(", "));
        let value = self.require(name, &expected)?;
        let found = value.get_ref().as_str();
        words
            .iter()
            .find(|(word, _)| found == Some(word))
            .map(|&(_, meant)| meant)
            .ok_or_else(|| self.unlike(name, &expected, value.get_ref()))
    }

    /// Faults the first field that nobody asked for.
    pub(super) fn finish(self) -> Result<(), FileError> {
        let unknown = self
            .table
            .keys()
            .filter(|key| !self.known.contains(&key.get_ref().as_ref()))
            .min_by_key(|key| key.span().start);
        let Some(key) = unknown else {
            return Ok(());
        };
        let message = format!("unknown field; expected one of {}", self.known.join(", "));
        let path = self.path_of(key.get_ref());
        Err(self.source.fault(key.span().start, &path, message))
    }
}

fn disc_number(count: usize) -> String {
    match count {
        0 | 1 => "disc 0, the only one".into(),
        _ => format!("a disc from 0 to {}", count - 1),
    }
}

fn number(value: &DeValue) -> Option<f64> {
    match value {
        DeValue::Integer(n) if n.radix() == 10 => n.as_str().parse().ok(),
        DeValue::Integer(n) => i32::from_str_radix(n.as_str(), n.radix())
            .ok()
            .map(f64::from),
        DeValue::Float(x) => x.as_str().parse().ok(),
        _ => None,
    }
}

fn whole(value: &DeValue) -> Option<usize> {
    let n = value.as_integer()?;
    usize::from_str_radix(n.as_str(), n.radix()).ok()
}

fn pair(value: &DeValue) -> Option<(f64, f64)> {
    let list = value.as_array()?;
    let at = |i: usize| list.get(i).and_then(|item| number(item.get_ref()));
    (list.len() == 2).then_some((at(0)?, at(1)?))
}

fn text<'a>(value: &'a DeValue, most: usize) -> Option<&'a str> {
    let text = value.as_str()?;
    let good =
        !text.trim().is_empty() && text.chars().count() <= most && text.chars().all(is_printable);
    good.then_some(text)
}

/// Line breaks are laid out anew.
fn is_printable(c: char) -> bool {
    !c.is_control() || c == '\n' || c == '\r'
}

/// A value as a message shows it.
fn shown(value: &DeValue) -> String {
    match value {
        DeValue::String(text) => format!("the text \"{}\"", escape_control(text, 40)),
        DeValue::Integer(n) => escape_control(&n.to_string(), 40),
        DeValue::Float(x) => escape_control(x.as_str(), 40),
        DeValue::Boolean(truth) => truth.to_string(),
        DeValue::Datetime(_) => "a date".into(),
        DeValue::Array(list) => shown_list(list.iter().map(Spanned::get_ref)),
        DeValue::Table(_) => "a table".into(),
    }
}

fn shown_list<'a>(items: impl ExactSizeIterator<Item = &'a DeValue<'a>>) -> String {
    let count = items.len();
    let short: Option<Vec<_>> = items
        .take(4)
        .map(|item| (item.is_integer() || item.is_float()).then(|| shown(item)))
        .collect();
    match (count, short) {
        (0, _) => "an empty list".into(),
        (1..=4, Some(numbers)) => format!("[{}]", numbers.join(", ")),
        _ => format!("a list of {count}"),
    }
}

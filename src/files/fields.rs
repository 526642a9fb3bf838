//! Reads external TOML field by field, so that every error names the file, the line and the
//! field, what was expected and what was found.
//!
//! Errors are noted and reading continues: the caller gets `None` for an invalid value, still reads
//! the other fields, and stops only when it needs the value. So one run reports all errors in a
//! file.

use std::ops::RangeInclusive;

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeTable, DeValue, ValueDeserializer};

use super::expectation::expectation;
use super::number::{NumberSpec, Range};
use super::source::Rank;
use super::{FileErrors, Source, escape_control};

/// The quotes that word processors use instead of straight ones.
const TYPOGRAPHIC_QUOTES: [char; 8] = ['“', '”', '„', '‟', '‘', '’', '«', '»'];

type Value<'a> = &'a Spanned<DeValue<'a>>;

/// A table whose fields are read one by one.
#[derive(Debug, Clone)]
pub(crate) struct Fields<'a> {
    source: &'a Source<'a>,
    path: String,
    /// The position in the text at which the table begins.
    at: usize,
    table: &'a DeTable<'a>,
    /// The fields that the table may have; `[]` if any names are allowed.
    known: Vec<&'static str>,
}

impl Source<'_> {
    /// Reads TOML with `format` set to one of the `formats` that can still be read. `what` names
    /// the document in messages, such as "a saved game"; `known` lists its fields.
    ///
    /// # Errors
    /// Returns all errors; for a file in a newer format, returns only that error.
    pub(crate) fn document<T>(
        self,
        what: &str,
        formats: RangeInclusive<u32>,
        known: &[&'static str],
        read: impl FnOnce(&Fields) -> Option<T>,
    ) -> Result<T, FileErrors> {
        let made = self.tables(what, formats, known, read);
        self.finish(made)
    }

    /// Like [`Self::document`], but errors are recorded in the source.
    pub(crate) fn tables<T>(
        &self,
        what: &str,
        formats: RangeInclusive<u32>,
        known: &[&'static str],
        read: impl FnOnce(&Fields) -> Option<T>,
    ) -> Option<T> {
        let (oldest, format) = formats.into_inner();
        let (document, errors) = DeTable::parse_recoverable(self.text());
        let mut broken = None;
        for error in errors {
            let at = error.span().map_or(0, |span| span.start);
            // Most further errors on the same line are caused by the first one.
            let line = self.line_near(at).as_ptr();
            if broken.replace(line) == Some(line) {
                continue;
            }
            let message = self.syntax_error(at, error.message());
            self.note(Rank::Syntax, at, self.key_near(at), message);
        }
        let mut fields = Fields::new(self, "", 0, document.get_ref());
        fields.known = known.into();
        let expected = format!("{what} with `format = {format}`");
        if !fields.has("format") && !fields.is_misspelt("format") {
            // A file without a format is a different kind of file, so its other fields are not
            // checked.
            return fields.refuse("format", format!("expected {expected}, found nothing"));
        }
        let fields = fields.only(known);
        let found = fields.whole("format", &expected, 0..=u32::MAX as usize)?;
        if found > format as usize {
            self.forget();
            fields.refuse("format", newer(found, format))
        } else if found < oldest as usize {
            fields.refuse("format", format!("expected {expected}, found {found}"))
        } else {
            read(&fields)
        }
    }

    /// The message for a TOML syntax error at a byte, with a hint if a likely cause is recognized.
    fn syntax_error(&self, at: usize, message: &str) -> String {
        let line = self.line_near(at);
        let values = values(line);
        let first_words = values.iter().filter_map(|it| it.split_whitespace().next());
        let mut words = first_words.map(|word| word.trim_end_matches([',', '}']));
        if let Some((word, number)) = words.find_map(|word| Some((word, with_a_point(word)?))) {
            return format!("expected a number, found {word}; write {number} with a decimal point");
        }
        if let Some(number) = values.iter().find_map(|value| without_a_unit(value)) {
            return format!("expected a number, found one with a unit; write {number} alone");
        }
        let message = message.trim();
        if line.contains(TYPOGRAPHIC_QUOTES) {
            return format!("{message}; use straight quotes: \"...\"");
        }
        message.into()
    }
}

/// The value of a line's key, or the values of an inline table: "hit = { alpha_deg = 30 }".
fn values(line: &str) -> Vec<&str> {
    let value = line.split_once('=').map_or("", |(_, value)| value.trim());
    match value.strip_prefix('{') {
        Some(table) => table.split('=').skip(1).map(str::trim).collect(),
        None => vec![value],
    }
}

/// Rewrites a number with a decimal comma so that it has a decimal point.
fn with_a_point(text: &str) -> Option<String> {
    let number = text.replacen(',', ".", 1);
    let is_one = text.contains(',') && number.parse::<f64>().is_ok();
    is_one.then_some(number)
}

/// The number in a value with a unit, such as "40 g"; the unit is already in the field's name.
fn without_a_unit(value: &str) -> Option<&str> {
    let unit = value.find(|c: char| !c.is_ascii_digit() && !matches!(c, '.' | '-' | '+'))?;
    let (number, unit) = value.split_at(unit);
    let is_unit = unit
        .trim_start()
        .starts_with(|c: char| c.is_alphabetic() || matches!(c, '°' | '%'));
    (is_unit && number.parse::<f64>().is_ok()).then_some(number)
}

/// The message about a file in a newer format.
pub fn newer(found: impl std::fmt::Display, format: u32) -> String {
    format!(
        "{found} is newer than {format}, the latest this version reads; a newer version may open it"
    )
}

impl<'a> Fields<'a> {
    fn new(source: &'a Source<'a>, path: &str, at: usize, table: &'a DeTable<'a>) -> Self {
        Self {
            source,
            path: path.into(),
            at,
            table,
            known: Vec::new(),
        }
    }

    /// The table with its known fields; notes an error for each unknown field.
    pub(crate) fn only(mut self, known: &[&'static str]) -> Self {
        self.known = known.into();
        for key in self.table.keys() {
            let name = key.get_ref().as_ref();
            if self.is_known(name) {
                continue;
            }
            let mut message = format!("unknown field; expected one of {}", known.join(", "));
            if let Some(meant) = self.meant_by(name) {
                message += &format!("; did you mean {meant}?");
            }
            let path = self.path_of(name);
            self.source
                .note(Rank::UnknownField, key.span().start, &path, message);
        }
        self
    }

    fn is_known(&self, name: &str) -> bool {
        self.known.is_empty() || self.known.contains(&name)
    }

    /// The missing field whose name is similar to an unknown one.
    fn meant_by(&self, name: &str) -> Option<&'static str> {
        let missing = self.known.iter().copied().filter(|it| !self.has(it));
        missing
            .map(|it| (strsim::osa_distance(name, it), it))
            .filter(|(distance, _)| *distance <= 2 && distance * 2 <= name.len())
            .min()
            .map(|(_, it)| it)
    }

    /// Notes an error in a field, at its value, or at the table if the field is missing; always
    /// returns `None`, for the caller to return.
    pub(crate) fn refuse<T>(&self, name: &str, message: impl Into<String>) -> Option<T> {
        let at = self.table.get(name).map_or(self.at, |v| v.span().start);
        self.refuse_at(at, name, message)
    }

    /// Notes an error in the table itself; always returns `None`.
    pub(crate) fn refuse_table<T>(&self, message: impl Into<String>) -> Option<T> {
        self.source.note(Rank::Value, self.at, &self.path, message);
        None
    }

    /// Notes an error in an item of a list, counted from 0; always returns `None`.
    pub(crate) fn refuse_item<T>(
        &self,
        name: &str,
        item: usize,
        message: impl Into<String>,
    ) -> Option<T> {
        let list = self.table.get(name).and_then(|it| it.get_ref().as_array());
        let item = list.and_then(|list| list.get(item));
        self.refuse_at(item.map_or(self.at, |it| it.span().start), name, message)
    }

    fn refuse_at<T>(&self, at: usize, name: &str, message: impl Into<String>) -> Option<T> {
        let path = self.path_of(name);
        self.source.note(Rank::Value, at, &path, message);
        None
    }

    fn path_of(&self, name: &str) -> String {
        if self.path.is_empty() {
            name.into()
        } else {
            format!("{}.{name}", self.path)
        }
    }

    /// The line of the file on which the table begins.
    pub(crate) fn line(&self) -> usize {
        self.source.line_of(self.at)
    }

    pub(crate) fn has(&self, name: &str) -> bool {
        self.table.contains_key(name)
    }

    /// The result of `read` for a field, or `usual` if the field is missing.
    pub(crate) fn or<T>(
        &self,
        name: &'static str,
        usual: T,
        read: impl FnOnce(&'static str) -> Option<T>,
    ) -> Option<T> {
        if self.has(name) {
            read(name)
        } else {
            Some(usual)
        }
    }

    /// The result of `read` for a required field; `expected` describes it.
    fn value<T>(
        &self,
        name: &str,
        expected: &str,
        read: impl FnOnce(Value<'a>) -> Option<T>,
    ) -> Option<T> {
        #[cfg(test)]
        assert!(self.is_known(name), "{name} is not among the known fields");
        match self.table.get(name) {
            Some(value) => read(value).or_else(|| self.unlike(name, expected, value)),
            // The message about the unknown field already suggests this field.
            None if self.is_misspelt(name) => None,
            None => self.refuse(name, format!("expected {expected}, found nothing")),
        }
    }

    fn is_misspelt(&self, name: &str) -> bool {
        let keys = self.table.keys().map(|key| key.get_ref().as_ref());
        keys.filter(|key| !self.is_known(key))
            .any(|key| self.meant_by(key) == Some(name))
    }

    fn unlike<T>(&self, name: &str, expected: &str, found: Value) -> Option<T> {
        let (at, value) = (found.span().start, found.get_ref());
        let mut message = format!("expected {expected}, found {}", shown(value));
        let number = match value {
            DeValue::String(text) => with_a_point(text.trim()),
            // Two numbers with decimal commas are read as three or four numbers.
            DeValue::Array(list) if list.len() > 2 => {
                let written = self.source.text().get(found.span()).unwrap_or_default();
                let mut words = written.trim_matches(['[', ']']).split_whitespace();
                words.find_map(|word| with_a_point(word.trim_end_matches(',')))
            }
            _ => None,
        };
        if let Some(number) = number {
            message += &format!("; write {number} with a decimal point");
        }
        self.refuse_at(at, name, message)
    }

    /// A required table with these known fields.
    pub(crate) fn table(&self, name: &str, known: &[&'static str]) -> Option<Self> {
        let table = self.value(name, &format!("a table [{name}]"), |value| {
            self.inner(name, value)
        })?;
        Some(table.only(known))
    }

    /// A list of tables with the same name and these known fields; `count` is the permitted length
    /// of the list.
    pub(crate) fn tables(
        &self,
        name: &str,
        count: RangeInclusive<usize>,
        known: &[&'static str],
    ) -> Option<Vec<Self>> {
        let expected = format!("{} to {} tables [[{name}]]", count.start(), count.end());
        let tables = self.list(name, &expected, count, |value| self.inner(name, value))?;
        Some(tables.into_iter().map(|it| it.only(known)).collect())
    }

    /// The names of all fields that the table has.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        self.table.keys().map(|key| key.get_ref().as_ref())
    }

    /// The tables in this one, with their names; any names are allowed.
    pub(crate) fn named_tables(&self, known: &[&'static str]) -> Option<Vec<(&'a str, Self)>> {
        let table = |name| Some((name, self.table(name, known)?));
        all(self.names().map(table).collect())
    }

    fn inner(&self, name: &str, value: Value<'a>) -> Option<Self> {
        let table = value.get_ref().as_table()?;
        let path = self.path_of(name);
        Some(Self::new(self.source, &path, value.span().start, table))
    }

    /// A list whose length must be within `count`.
    fn list<T>(
        &self,
        name: &str,
        expected: &str,
        count: RangeInclusive<usize>,
        mut item: impl FnMut(Value<'a>) -> Option<T>,
    ) -> Option<Vec<T>> {
        let list = self.value(name, expected, |value| {
            let list = value.get_ref().as_array()?;
            count.contains(&list.len()).then_some(list)
        })?;
        let read = list
            .iter()
            .map(|value| item(value).or_else(|| self.unlike(name, expected, value)));
        all(read.collect())
    }

    /// A number within the bounds of its kind, in the unit of the file.
    pub(crate) fn number(&self, name: &str, spec: &NumberSpec) -> Option<f64> {
        self.value(name, &spec.to_string(), |value| {
            number(value.get_ref()).filter(|&x| spec.allows(x))
        })
    }

    /// Two numbers in a list, both within the bounds of their kind; `names` describes them, such as
    /// "[x, y]".
    pub(crate) fn pair(&self, name: &str, names: &str, spec: &NumberSpec) -> Option<[f64; 2]> {
        self.value(name, &format!("{names}, {spec}"), |value| {
            pair(value.get_ref()).filter(|pair| pair.iter().all(|&x| spec.allows(x)))
        })
    }

    /// A range `[from, to]` with both ends within the bounds of a kind of number.
    pub(crate) fn range(&self, name: &str, spec: &NumberSpec) -> Option<Range> {
        self.value(name, &format!("[from, to], {spec}"), |value| {
            let [from, to] = pair(value.get_ref())?;
            let good = spec.allows(from) && spec.allows(to) && from < to;
            good.then_some(Range { from, to })
        })
    }

    /// A whole number within bounds; `expected` describes it.
    pub(crate) fn whole(
        &self,
        name: &str,
        expected: &str,
        bounds: RangeInclusive<usize>,
    ) -> Option<usize> {
        self.value(name, expected, |value| {
            whole(value.get_ref()).filter(|n| bounds.contains(n))
        })
    }

    /// A list of different whole numbers below `end`; `count` is the permitted length of the list.
    pub(crate) fn different(
        &self,
        name: &str,
        expected: &str,
        count: RangeInclusive<usize>,
        end: usize,
    ) -> Option<Vec<usize>> {
        let mut seen = Vec::new();
        self.list(name, expected, count, |value| {
            let n = whole(value.get_ref()).filter(|n| *n < end && !seen.contains(n))?;
            seen.push(n);
            Some(n)
        })
    }

    /// Printable text of 1 to `most` characters, unchanged; line breaks are allowed.
    pub(crate) fn text(&self, name: &str, most: usize) -> Option<&'a str> {
        let expected = format!("text of 1 to {most} printable characters");
        self.value(name, &expected, |value| text(value.get_ref(), most))
    }

    /// A list of strings, without surrounding spaces; `count` is the permitted length of the list.
    pub(crate) fn texts(
        &self,
        name: &str,
        count: RangeInclusive<usize>,
        most: usize,
    ) -> Option<Vec<String>> {
        let (least, items) = (count.start(), count.end());
        let expected =
            format!("a list of {least} to {items} strings of 1 to {most} printable characters");
        self.list(name, &expected, count, |value| {
            Some(text(value.get_ref(), most)?.trim().to_owned())
        })
    }

    /// The result of `read` for a string, or its message as an error.
    pub(crate) fn text_as<T>(
        &self,
        name: &str,
        read: impl FnOnce(&'a str) -> Result<T, String>,
    ) -> Option<T> {
        let text = self.value(name, "text", |value| value.get_ref().as_str())?;
        match read(text) {
            Ok(made) => Some(made),
            Err(message) => self.refuse(name, message),
        }
    }

    /// A list of any strings.
    pub(crate) fn any_texts(&self, name: &str) -> Option<Vec<&'a str>> {
        self.list(name, "a list of strings", 0..=usize::MAX, |value| {
            value.get_ref().as_str()
        })
    }

    /// A name of 1 to 40 lower-case letters, digits and hyphens.
    pub(crate) fn id(&self, name: &str) -> Option<&'a str> {
        let expected = "1 to 40 lower-case letters, digits and hyphens";
        self.value(name, expected, |value| {
            value.get_ref().as_str().filter(|id| is_id(id))
        })
    }

    /// The value of a field that must be one of these words.
    pub(crate) fn word<T: Clone>(&self, name: &str, words: &[(&str, T)]) -> Option<T> {
        let names: Vec<_> = words.iter().map(|(word, _)| *word).collect();
        let expected = format!("one of {}", names.join(", "));
        self.value(name, &expected, |value| {
            let found = value.get_ref().as_str()?;
            let (_, meant) = words.iter().find(|(word, _)| found == *word)?;
            Some(meant.clone())
        })
    }

    /// Passes the name and the value of every known field to `set`, with numbers in decimal form,
    /// and notes the errors that `set` returns.
    pub(crate) fn each(&self, mut set: impl FnMut(&str, &str) -> Result<(), String>) -> Option<()> {
        let fields = self
            .table
            .iter()
            .filter(|(key, _)| self.is_known(key.get_ref()));
        let set = fields.map(|(key, value)| {
            let written = match value.get_ref() {
                DeValue::Boolean(truth) => truth.to_string(),
                DeValue::String(text) => text.to_string(),
                other => number(other).map_or_else(|| shown(other), |n| n.to_string()),
            };
            let name = key.get_ref().as_ref();
            let Err(message) = set(name, &written) else {
                return Some(());
            };
            let without_name = message
                .strip_prefix(name)
                .and_then(|it| it.strip_prefix(": "));
            self.refuse(name, without_name.unwrap_or(&message))
        });
        all(set.collect()).map(|_: Vec<()>| ())
    }

    /// A field, read by serde.
    pub(crate) fn parsed<T: DeserializeOwned>(&self, name: &str, expected: &str) -> Option<T> {
        let value = self.value(name, expected, Some)?;
        self.parse(name, value)
    }

    /// A table, read by serde. Anything else is refused first, because serde would also accept a
    /// list of a struct's fields.
    pub(crate) fn table_parsed<T: DeserializeOwned>(
        &self,
        name: &str,
        expected: &str,
    ) -> Option<T> {
        let table = |value: Value<'a>| value.get_ref().as_table().map(|_| value);
        let value = self.value(name, expected, table)?;
        self.parse(name, value)
    }

    /// The items of a list, read by serde.
    pub(crate) fn all_parsed<T: DeserializeOwned>(
        &self,
        name: &str,
        expected: &str,
    ) -> Option<Vec<T>> {
        let list = self.value(name, expected, |value| value.get_ref().as_array())?;
        all(list.iter().map(|value| self.parse(name, value)).collect())
    }

    fn parse<T: DeserializeOwned>(&self, name: &str, value: Value<'a>) -> Option<T> {
        T::deserialize(ValueDeserializer::from(value.clone()))
            .map_err(|error| {
                let at = error.span().unwrap_or(value.span()).start;
                self.refuse_at::<T>(at, name, expectation(error.message().trim()))
            })
            .ok()
    }
}

/// All items, or `None` if any is `None`. The caller has collected them, so every item has been
/// read, even after a fault.
pub(crate) fn all<T>(items: Vec<Option<T>>) -> Option<Vec<T>> {
    items.into_iter().collect()
}

/// Whether this is an id: 1 to 40 lower-case letters, digits and hyphens.
pub(crate) fn is_id(id: &str) -> bool {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    (1..=40).contains(&id.len()) && id.chars().all(plain)
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

fn pair(value: &DeValue) -> Option<[f64; 2]> {
    let list = value.as_array()?;
    let at = |i: usize| list.get(i).and_then(|item| number(item.get_ref()));
    (list.len() == 2).then_some([at(0)?, at(1)?])
}

fn text<'a>(value: &'a DeValue, most: usize) -> Option<&'a str> {
    // Line breaks are allowed, because the text is wrapped again.
    let printable = |c: char| !c.is_control() || c == '\n' || c == '\r';
    let text = value.as_str()?;
    let good =
        !text.trim().is_empty() && text.chars().count() <= most && text.chars().all(printable);
    good.then_some(text)
}

/// A value as shown in a message.
fn shown(value: &DeValue) -> String {
    match value {
        DeValue::String(text) => format!("the text \"{}\"", escape_control(text, 40)),
        DeValue::Integer(n) => escape_control(&n.to_string(), 40),
        DeValue::Float(x) => escape_control(x.as_str(), 40),
        DeValue::Boolean(truth) => truth.to_string(),
        DeValue::Datetime(_) => "a date".into(),
        DeValue::Array(list) if list.is_empty() => "an empty list".into(),
        DeValue::Array(list) => {
            let number = |item: &Spanned<DeValue>| {
                let item = item.get_ref();
                (item.is_integer() || item.is_float()).then(|| shown(item))
            };
            let numbers: Option<Vec<_>> = list.iter().take(5).map(number).collect();
            match numbers {
                Some(numbers) if numbers.len() < 5 => format!("[{}]", numbers.join(", ")),
                _ => format!("a list of {}", list.len()),
            }
        }
        DeValue::Table(_) => "a table".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The error message for a document with this line.
    fn shown(line: &str) -> String {
        let text = format!("format = 1\n{line}\n");
        let source = Source::of_bytes("a.toml", text.as_bytes(), 1000).unwrap();
        let read = source.document("a thing", 1..=1, &["format", "hit", "ask"], |_| Some(()));
        read.unwrap_err().to_string()
    }

    #[test]
    fn common_mistakes_get_a_hint_in_inline_tables_too() {
        for (line, hint) in [
            ("hit = 35,0", "write 35.0 with a decimal point"),
            (
                "hit = { m = 5.5, a = 35,0 }",
                "write 35.0 with a decimal point",
            ),
            ("hit = 40 g", "write 40 alone"),
            ("hit = { m = 15 g, a = 35 }", "write 15 alone"),
            ("ask = “How far?”", "use straight quotes"),
        ] {
            let shown = shown(line);
            assert!(shown.contains(hint), "{line}: {shown}");
        }
    }
}

//! From the bytes of a file to its tables.

use toml::Spanned;
use toml::de::DeTable;

use super::fault::Fault;
use super::fields::Fields;

/// The format that this program reads and writes.
pub const FORMAT: u32 = 1;

/// Largest file that is looked at, in bytes.
pub const LARGEST_FILE: usize = 1 << 20;

/// A file's text and its name, for messages.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source<'a> {
    pub(super) name: &'a str,
    text: &'a str,
}

impl Source<'_> {
    /// The fault that `message` describes, at a byte of the text.
    pub(super) fn fault(&self, at: usize, field: &str, message: impl Into<String>) -> Fault {
        let before = self.text.as_bytes().iter().take(at);
        Fault {
            file: self.name.into(),
            line: Some(1 + before.filter(|&&byte| byte == b'\n').count()),
            field: (!field.is_empty()).then(|| field.into()),
            message: message.into(),
        }
    }

    /// The key that the line around a byte sets, if it sets one.
    fn key_near(&self, at: usize) -> &str {
        let start = self
            .text
            .get(..at)
            .and_then(|before| before.rfind('\n'))
            .map_or(0, |newline| newline + 1);
        let line = self.text.get(start..).unwrap_or_default();
        let line = line.lines().next().unwrap_or_default();
        let key = line.split_once('=').map_or("", |(key, _)| key.trim());
        let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        if key.chars().all(bare) { key } else { "" }
    }
}

/// Reads a file of the format: `read` takes what it knows from the tables, and
/// what is left over is a fault.
///
/// # Errors
///
/// The first thing that is wrong with the file.
pub(super) fn read_document<T>(
    name: &str,
    bytes: &[u8],
    read: impl FnOnce(&mut Fields) -> Result<T, Fault>,
) -> Result<T, Fault> {
    let source = text_of(name, bytes)?;
    let document = parse(source)?;
    let mut fields = Fields::of_document(source, &document);
    check_format(&mut fields, source)?;
    let made = read(&mut fields)?;
    fields.finish()?;
    Ok(made)
}

fn text_of<'a>(name: &'a str, bytes: &'a [u8]) -> Result<Source<'a>, Fault> {
    let empty = Source { name, text: "" };
    if bytes.len() > LARGEST_FILE {
        return Err(empty.fault(0, "", "expected a file of at most 1 MiB, found more"));
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(Source { name, text }),
        Err(error) => {
            let good = bytes.get(..error.valid_up_to()).unwrap_or_default();
            let text = std::str::from_utf8(good).unwrap_or_default();
            let source = Source { name, text };
            let field = source.key_near(text.len());
            Err(source.fault(text.len(), field, "expected UTF-8 text, found other bytes"))
        }
    }
}

fn parse<'a>(source: Source<'a>) -> Result<Spanned<DeTable<'a>>, Fault> {
    DeTable::parse(source.text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        source.fault(at, source.key_near(at), error.message().trim())
    })
}

fn check_format(fields: &mut Fields, source: Source) -> Result<(), Fault> {
    let expected = format!("`format = {FORMAT}`");
    if source.text.trim().is_empty() {
        let message = format!("expected {expected}, found an empty file");
        return Err(source.fault(0, "format", message));
    }
    let found = fields.whole("format", &expected, u32::MAX as usize)?;
    match found.checked_sub(FORMAT as usize) {
        Some(0) => Ok(()),
        Some(_) => Err(fields.fault_at(
            "format",
            format!("{found} is newer than the {FORMAT} this carrom reads; a newer carrom may open the file"),
        )),
        None => Err(fields.fault_at("format", format!("expected {expected}, found {found}"))),
    }
}

//! From the bytes of a file to its tables.

use toml::Spanned;
use toml::de::DeTable;

use super::fields::Fields;
use crate::files::{self, FileError, Source, newer};

/// The format that this program reads and writes.
pub const FORMAT: u32 = 1;

/// Reads a file of the format: `read` takes what it knows from the tables, and
/// what is left over is a fault.
///
/// # Errors
///
/// The first thing that is wrong with the file.
pub(super) fn read_document<T>(
    name: &str,
    bytes: &[u8],
    read: impl FnOnce(&mut Fields) -> Result<T, FileError>,
) -> Result<T, FileError> {
    let source = Source::of_bytes(name, bytes, files::LARGEST)?;
    let document = parse(source)?;
    let mut fields = Fields::of_document(source, &document);
    check_format(&mut fields, source)?;
    let made = read(&mut fields)?;
    fields.finish()?;
    Ok(made)
}

fn parse<'a>(source: Source<'a>) -> Result<Spanned<DeTable<'a>>, FileError> {
    DeTable::parse(source.text()).map_err(|error| source.fault_of(&error))
}

fn check_format(fields: &mut Fields, source: Source) -> Result<(), FileError> {
    let expected = format!("`format = {FORMAT}`");
    if source.text().trim().is_empty() {
        let message = format!("expected {expected}, found an empty file");
        return Err(source.fault(0, "format", message));
    }
    let found = fields.whole("format", &expected, u32::MAX as usize)?;
    match found.checked_sub(FORMAT as usize) {
        Some(0) => Ok(()),
        Some(_) => Err(fields.fault_at("format", newer(found, FORMAT))),
        None => Err(fields.fault_at("format", format!("expected {expected}, found {found}"))),
    }
}

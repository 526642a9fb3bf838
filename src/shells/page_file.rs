//! carrom as one HTML file: unchanged, with a teacher's own files, or in a package for a learning
//! platform.

use std::borrow::Cow;
use std::io::{Cursor, Write};
use std::path::Path;
use std::{env, fs};

use anyhow::{Context, anyhow};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::quiz::Code;

/// The page that was built into this program, if there is one.
const EMBEDDED: Option<&str> = include!(concat!(env!("OUT_DIR"), "/page.rs"));
/// The file name of the page.
const NAME: &str = "carrom.html";
/// The element of a page that holds added files.
const OWN: [&str; 2] = ["<script type=\"application/json\" id=\"own\">", "</script>"];
/// The path of the added file that contains the code of the round to report to a learning platform.
const ROUND: &str = "scorm/round";

/// A file to add to a page: its path in the page, and its text.
pub type OwnFile = (String, String);

/// carrom as one HTML file, and a teacher's own files to add to it.
#[derive(Debug)]
pub struct PageFile {
    text: Cow<'static, str>,
    /// The files to add, or the errors in them.
    own: Result<Vec<OwnFile>, String>,
}

impl PageFile {
    /// A page with this text, and the files to add to it, or the errors in them.
    pub fn new(text: impl Into<Cow<'static, str>>, own: Result<Vec<OwnFile>, String>) -> Self {
        Self {
            text: text.into(),
            own,
        }
    }

    /// The page in the given file, or else the one in this program or beside it.
    ///
    /// # Errors
    /// If there is no page, or if it cannot be read.
    pub fn find(given: Option<&Path>, own: Result<Vec<OwnFile>, String>) -> anyhow::Result<Self> {
        let beside =
            || Some(env::current_exe().ok()?.parent()?.join(NAME)).filter(|it| it.is_file());
        let path = match (given, EMBEDDED) {
            (Some(path), _) => path.to_owned(),
            (None, Some(page)) => return Ok(Self::new(page, own)),
            (None, None) => beside().ok_or_else(|| {
                anyhow!(
                    "this program contains no page. Put {NAME} beside it, or give its path with \
                     --page; .ci/page in carrom's sources builds it"
                )
            })?,
        };
        let text = fs::read_to_string(&path);
        let text = text.with_context(|| format!("cannot read {}", path.display()))?;
        Ok(Self::new(text, own))
    }

    /// The page without a teacher's files, including those that the given page already contained.
    /// This copy is served to the devices of a class: the files may contain the answers to the
    /// questions of the class.
    pub(super) fn text(&self) -> Cow<'_, str> {
        match with_files(&self.text, &[]) {
            Ok(page) => page.into(),
            Err(_) => Cow::Borrowed(&self.text),
        }
    }

    /// The page with the teacher's files, as HTML; if the code of a round is given, as a SCORM 1.2
    /// package that opens this round.
    ///
    /// # Errors
    /// If the text is not that of a carrom page, or if there are errors in the teacher's files.
    pub fn document(&self, round: Option<&Code>) -> anyhow::Result<Vec<u8>> {
        let mut own = self.own.clone().map_err(anyhow::Error::msg)?;
        own.extend(round.map(|code| (ROUND.into(), code.to_string())));
        let page = with_files(&self.text, &own)?;
        match round {
            Some(code) => package(&code.to_string(), &page),
            None => Ok(page.into_bytes()),
        }
    }
}

/// A SCORM 1.2 package: the page and a manifest that names it.
fn package(code: &str, page: &str) -> anyhow::Result<Vec<u8>> {
    let manifest = include_str!("imsmanifest.xml").replace("{code}", code);
    let mut package = ZipWriter::new(Cursor::new(Vec::new()));
    // No time is stored, so the same page always gives the same package.
    let options = SimpleFileOptions::default();
    for (name, text) in [("imsmanifest.xml", manifest.as_str()), ("index.html", page)] {
        package.start_file(name, options)?;
        package.write_all(text.as_bytes())?;
    }
    Ok(package.finish()?.into_inner())
}

/// Adds these files to a page.
fn with_files(page: &str, own: &[OwnFile]) -> anyhow::Result<String> {
    let [begin, end] = OWN;
    let odd = || anyhow!("this is not a carrom page");
    let (before, rest) = page.split_once(begin).ok_or_else(odd)?;
    let (_, after) = rest.split_once(end).ok_or_else(odd)?;
    // No file may close the element that holds it.
    let json = serde_json::to_string(own)?.replace('<', "\\u003c");
    Ok(format!("{before}{begin}{json}{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_stay_inside_their_element_in_the_page() {
        let page = format!("a{}[]{}b", OWN[0], OWN[1]);
        let own = [("lessons/x.md".to_owned(), "</script><b>".to_owned())];
        let with = with_files(&page, &own).unwrap();
        assert_eq!(
            with,
            format!(
                "a{}[[\"lessons/x.md\",\"\\u003c/script>\\u003cb>\"]]{}b",
                OWN[0], OWN[1]
            )
        );
        // Adding the files again replaces them.
        assert_eq!(with_files(&with, &own).unwrap(), with);
        assert!(with_files("<html>", &own).is_err());
        // The devices of a class do not get them.
        assert_eq!(PageFile::new(with, Ok(Vec::new())).text(), page);
    }
}

//! `carrom page`: carrom as one HTML file, including a teacher's own levels, chapters and
//! questions.

use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use std::{env, fs};

use anyhow::{Context, anyhow};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::{Failure, GlobalOptions, written};
use crate::files::{self, FileError, FileErrors};
use crate::quiz::Code;

/// The page that was built into this program, if there is one.
const EMBEDDED: Option<&str> = include!(concat!(env!("OUT_DIR"), "/page.rs"));
const NAME: &str = "carrom.html";
/// The element of a page that holds added files.
const OWN: [&str; 2] = ["<script type=\"application/json\" id=\"own\">", "</script>"];
/// The path of the added file that contains the code of the round to report to a learning platform.
const ROUND: &str = "scorm/round";
/// The maximum number of files that are read from one folder.
const MOST_FILES: usize = 500;

/// Write carrom as one HTML file for any browser
///
/// It contains the levels, chapters and questions in words from --levels, --lessons and --concepts,
/// so a class gets them by opening the file.
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  carrom page --out carrom.html
  carrom page --concepts mine --out physics-10b.html
  carrom page --scorm quick-7 --out quick-7.zip

A SCORM package is a ZIP file to upload to a learning platform (Moodle: Add an activity, SCORM
package). It opens the round and reports the score for accuracy from 0 to 100, whether the round
is complete, the time, and each answer. A pupil who comes back continues where they stopped.")]
pub(super) struct Args {
    /// The file to write
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// The page to start from (default: the one in this program, or carrom.html beside it)
    #[arg(long, value_name = "FILE")]
    page: Option<PathBuf>,
    /// Write a SCORM 1.2 package for a learning platform: it opens this round and reports the
    /// result
    #[arg(long, value_name = "CODE", value_parser = round)]
    scorm: Option<Code>,
    /// Replace an existing file
    #[arg(long)]
    force: bool,
}

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    let problems = options.problems();
    if !problems.is_empty() {
        let problems: Vec<_> = problems.iter().map(ToString::to_string).collect();
        return Err(Failure::input(problems.join("\n")));
    }
    let page = page(args.page.as_deref()).map_err(Failure::Input)?;
    let mut own = own_files(options).map_err(Failure::input)?;
    let Some(code) = &args.scorm else {
        let page = with_files(&page, &own).map_err(Failure::Input)?;
        return written::write_named_beside(&args.out, &[(args.out.clone(), page)], args.force);
    };
    let code = code.clone().with_own(&options.own());
    let code = code.map_err(Failure::input)?.to_string();
    own.push((ROUND.into(), code.clone()));
    let page = with_files(&page, &own).map_err(Failure::Input)?;
    let package = package(&code, &page).map_err(Failure::Input)?;
    written::write_named_beside(&args.out, &[(args.out.clone(), package)], args.force)
}

/// Reads the code of a round whose questions are the same for everyone.
fn round(text: &str) -> Result<Code, String> {
    Code::read(text)
        .map_err(|error| error.to_string())?
        .same_for_all()
}

/// A SCORM 1.2 package: the page and a manifest that names it.
fn package(code: &str, page: &str) -> anyhow::Result<Vec<u8>> {
    let manifest = format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="carrom-{code}" version="1.0"
    xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2"
    xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="carrom">
    <organization identifier="carrom">
      <title>carrom: {code}</title>
      <item identifier="round" identifierref="page">
        <title>carrom: {code}</title>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="page" type="webcontent" adlcp:scormtype="sco" href="index.html">
      <file href="index.html"/>
    </resource>
  </resources>
</manifest>
"#
    );
    let mut package = ZipWriter::new(Cursor::new(Vec::new()));
    // Without a time: the same page gives the same package.
    let options = SimpleFileOptions::default();
    for (name, text) in [("imsmanifest.xml", manifest.as_str()), ("index.html", page)] {
        package.start_file(name, options)?;
        package.write_all(text.as_bytes())?;
    }
    Ok(package.finish()?.into_inner())
}

/// The page to start from.
pub(super) fn page(given: Option<&Path>) -> anyhow::Result<String> {
    let beside = || Some(env::current_exe().ok()?.parent()?.join(NAME)).filter(|it| it.is_file());
    let path = match (given, EMBEDDED) {
        (Some(path), _) => path.to_owned(),
        (None, Some(page)) => return Ok(page.to_owned()),
        (None, None) => beside().ok_or_else(|| {
            anyhow!(
                "this program contains no page. Put {NAME} beside it, or give its path with --page; \
                 .ci/page in carrom's sources builds it"
            )
        })?,
    };
    fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))
}

/// A file for a page: its path in the page, and its text.
type OwnFile = (String, String);

fn with_files(page: &str, own: &[OwnFile]) -> anyhow::Result<String> {
    let [begin, end] = OWN;
    let parts = page.split_once(begin).and_then(|(before, rest)| {
        let (_, after) = rest.split_once(end)?;
        Some((before, after))
    });
    let (before, after) = parts.ok_or_else(|| anyhow!("this is not a carrom page"))?;
    // No file may close the element that holds it.
    let json = serde_json::to_string(own)?.replace('<', "\\u003c");
    Ok(format!("{before}{begin}{json}{end}{after}"))
}

/// The files in the given folders, under the paths that a page uses for them.
fn own_files(options: &GlobalOptions) -> Result<Vec<OwnFile>, FileErrors> {
    let [levels, lessons, concepts] = options.own_folders();
    let mut own = Vec::new();
    for folder in levels {
        let packs = add(&mut own, folder, "toml", &pack(folder))?;
        for inner in packs {
            add(&mut own, &inner, "toml", &pack(&inner))?;
        }
    }
    for folder in lessons {
        add(&mut own, folder, "md", "lessons")?;
    }
    for folder in concepts {
        add(&mut own, folder, "toml", "concepts")?;
    }
    Ok(own)
}

/// The path of a folder of levels in a page.
fn pack(folder: &Path) -> String {
    let name = folder.file_name().unwrap_or_default();
    format!("levels/{}", name.display())
}

/// Adds the files of a folder, and returns the folders in it.
fn add(
    own: &mut Vec<OwnFile>,
    folder: &Path,
    ending: &str,
    place: &str,
) -> Result<Vec<PathBuf>, FileError> {
    let list = files::list(folder, ending, MOST_FILES)?;
    for path in &list.files {
        let bytes = files::read(path, files::LARGEST)?;
        let name = path.file_name().unwrap_or_default().display();
        own.push((
            format!("{place}/{name}"),
            String::from_utf8_lossy(&bytes).into_owned(),
        ));
    }
    Ok(list.folders)
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
    }
}

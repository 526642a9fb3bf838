//! Crash reports.

use std::backtrace::Backtrace;
use std::fs;
use std::io::{self, Write as _};
use std::panic::{self, PanicHookInfo};
use std::path::{Path, PathBuf};
use std::thread;

use super::guard;
use crate::files::UnplacedFile;

/// The name of the file with the report.
const FILE: &str = "crash.log";

/// Makes a panic write a report to `crash.log` in `folder`, if one is given; the folder is created
/// if it does not exist. A panic in the calling thread, which should be the drawing thread, also
/// restores the terminal and prints one line to standard error. A panic in any other thread does
/// not touch the screen.
pub fn report_crashes(folder: Option<PathBuf>) {
    let drawing = thread::current().id();
    panic::set_hook(Box::new(move |info| {
        let fatal = thread::current().id() == drawing;
        if fatal {
            guard::restore();
        }
        let saved = folder.as_deref().map(|folder| save(folder, &report(info)));
        if fatal {
            let saved = match saved {
                Some(Ok(path)) => format!("a report is in {}", path.display()),
                Some(Err(error)) => format!("no report could be saved: {error}"),
                None => "no folder is known for a report".into(),
            };
            let line = format!("carrom: stopped by an internal error: {}", what(info));
            // The terminal's window may have been closed, and with it standard error. A panic in
            // this hook would end the process at once.
            let _ = writeln!(io::stderr(), "{line}; {saved}");
        }
    }));
}

/// The panic message and its location, in one line.
fn what(info: &PanicHookInfo) -> String {
    let payload = info.payload();
    let message = (payload.downcast_ref::<&str>().copied())
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("no message");
    let unknown = || "an unknown place".to_owned();
    let place = info.location().map_or_else(unknown, ToString::to_string);
    format!("{message} (at {place})")
}

/// The crash report, with all details.
fn report(info: &PanicHookInfo) -> String {
    let (version, what) = (env!("CARGO_PKG_VERSION"), what(info));
    let thread = thread::current();
    let thread = thread.name().unwrap_or("without a name");
    let trace = Backtrace::force_capture();
    format!("carrom {version}\n{what}\nthread: {thread}\n\n{trace}\n")
}

fn save(folder: &Path, report: &str) -> io::Result<PathBuf> {
    fs::create_dir_all(folder)?;
    let path = folder.join(FILE);
    UnplacedFile::write(folder, report, false)?.replace(&path)?;
    Ok(path)
}

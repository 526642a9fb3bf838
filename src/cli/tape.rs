//! `carrom tape`: plays a script without a terminal.

use std::path::{Path, PathBuf};

use anyhow::anyhow;

use super::{Failure, GlobalOptions};
use crate::files::{self, Existing, Source};
use crate::shells::Headless;
use crate::shells::tape::{PlayError, Tape, play};
use crate::store::Store;

/// Play a script without a terminal, on simulated time
///
/// Each line is one instruction; # starts a comment. Without --data-dir, the same tape
/// always gives the same screens, byte for byte. If an instruction fails, the run stops,
/// reports the line number and writes no screenshot.
#[derive(Debug, clap::Args)]
#[command(after_help = INSTRUCTIONS)]
pub(super) struct Args {
    /// The script
    file: PathBuf,
    /// Folder for the screenshots; created if it does not exist
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
    /// Also write each screenshot as a picture, NAME.svg beside NAME.txt
    #[arg(long)]
    svg: bool,
}

const INSTRUCTIONS: &str = r#"Instructions:
  Run "quiz --seed 7"      must come first: the arguments of carrom (default: none)
  Set Size 100x30          columns x rows (default 80x24)
  Set Charset ascii        or unicode
  Set Color none           or 16, 256, truecolor
  Set Day 2026-01-05       fixes the clock at noon on this day (default: no clock)
  Type "60"                one key per character
  Right 5                  a key by its name, and a count: Up Down Left Right Enter
                           Escape Tab Shift+Tab Backspace Delete Space PageUp PageDown
                           Home End F1 Ctrl+C
  Click 40,12              column,row from the top left, which is 0,0
  Drag 40,12 44,12         from, to
  Hold 40,12 44,12         the same without releasing the button
  Release 44,12            releases the button over this cell
  Scroll down 3            or up; over a cell: Scroll up 1 40,12
  Sleep 1.5s               or 200ms; simulated, so it takes no time
  At "Ada"                 switches to the device of a pupil; At "teacher" switches back
  Lose "Ada"               disconnects Ada's device; Reach "Ada" reconnects it
  Screenshot impact        writes impact.txt
  Expect "90.0"            fails unless the screen shows this
  Refuse "NaN"             fails if the screen shows this"#;

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    let file = args.file.display();
    let tape = read(&args.file).map_err(Failure::Input)?;
    let open = |arguments: &str| {
        let (app, options) = super::open_within(arguments, options)?;
        Ok(match options.given_data_dir() {
            Some(folder) => {
                let store = Store::in_folder(folder)
                    .timeless()
                    .with_own(&app.context().own);
                Headless::keeping(app, 80, 24, store)
            }
            None => Headless::from(app),
        })
    };
    let screenshots = play(&tape, open).map_err(|error| {
        let message = anyhow!("{file}:{error}");
        match error {
            PlayError::Run { .. } | PlayError::Pupil { .. } => Failure::Input(message),
            _ => Failure::Work(message),
        }
    })?;
    let mut documents = Vec::new();
    for screenshot in &screenshots {
        let mut keep = |kind: &str, content: String| {
            let path = args.out.join(format!("{}.{kind}", screenshot.name));
            documents.push((path, content));
        };
        keep("txt", screenshot.text());
        if args.svg {
            keep("svg", screenshot.svg());
        }
    }
    files::put(&documents, Existing::Go)?;
    super::print_names(&documents)
}

fn read(path: &Path) -> anyhow::Result<Tape> {
    let bytes = files::read(path, files::LARGEST)?;
    let name = path.display().to_string();
    let source = Source::of_bytes(&name, &bytes, files::LARGEST)?;
    Tape::parse(source.text()).map_err(|error| anyhow!("{name}:{error}"))
}

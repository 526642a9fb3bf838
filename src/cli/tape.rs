//! `carrom tape`: plays a script without a terminal.

use std::path::{Path, PathBuf};

use anyhow::anyhow;

use super::{Failure, GlobalOptions};
use crate::files::{self, Existing, Source};
use crate::shells::Headless;
use crate::shells::tape::{INSTRUCTIONS, PlayFault, Tape, play};
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
        match error.fault {
            PlayFault::Run(_) | PlayFault::Pupil(_) => Failure::Input(message),
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

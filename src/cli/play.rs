//! `carrom` itself: the game in the terminal.

use std::env;
use std::hash::{BuildHasher, RandomState};
use std::io::{self, BufReader};
use std::process::ExitCode;
use std::sync::Arc;

use super::options::Auto;
use super::{Failure, GlobalOptions, OpenCommand, app, page};
use crate::shells::host::HostOptions;
use crate::shells::terminal::{self, Ending};
use crate::shells::{PageFile, plain};
use anyhow::anyhow;

/// Opens the game at a screen and runs it until the player quits.
pub(super) fn run(
    options: &GlobalOptions,
    screen: Option<&OpenCommand>,
    plain: bool,
) -> Result<ExitCode, Failure> {
    let env = |name: &str| env::var(name).ok();
    if !plain {
        terminal::check(env).map_err(|error| {
            Failure::input(format!(
                "{error}; without a terminal, use --plain: carrom then reads and writes plain lines"
            ))
        })?;
    }
    terminal::report_crashes(options.data_dir());
    let auto = Auto {
        charset: terminal::charset(env),
        depth: terminal::depth(env),
    };
    // A random seed is short enough to pass on to a friend.
    let any_seed = || RandomState::new().hash_one(()) % 1_000_000;
    let seed = options.seed.unwrap_or_else(any_seed);
    let mut app =
        app(screen, options, options.data_dir().as_deref(), auto, seed).map_err(Failure::input)?;
    let store = options.store().with_own(&app.context().own);
    let host = host_options(options, screen).map_err(Failure::Input)?;
    if plain {
        let input = BufReader::new(io::stdin());
        plain::run(app, store, host, input, &mut io::stdout().lock())
            .map_err(|error| anyhow!(error))?;
        return Ok(ExitCode::SUCCESS);
    }
    app.settings_mut().sees = true;
    Ok(match terminal::run(app, store, host)? {
        Ending::Quit => ExitCode::SUCCESS,
        // A shell reports the same status for a process that was ended by a signal.
        Ending::Signal(signal) => ExitCode::from(128 + signal as u8),
    })
}

/// The page that is served to a class, and the port on which it is served.
///
/// # Errors
/// If the given page cannot be read.
fn host_options(
    options: &GlobalOptions,
    screen: Option<&OpenCommand>,
) -> anyhow::Result<HostOptions> {
    let (port, given) = screen.map_or((None, None), OpenCommand::port_and_page);
    let page = match (PageFile::find(given, page::own_files(options)), given) {
        (Err(error), Some(_)) => return Err(error),
        (found, _) => found.map(Arc::new).map_err(|error| error.to_string()),
    };
    let page = Some(page);
    Ok(HostOptions { port, page })
}

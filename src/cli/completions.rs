//! `carrom completions`: a script that lets a shell complete carrom's arguments.

use clap::Command;
use clap_complete::Shell;

use super::Failure;

/// Print the completions for a shell.
///
/// For example: carrom completions bash > ~/.local/share/bash-completion/completions/carrom
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The shell
    shell: Shell,
}

pub(super) fn run(args: &Args, mut command: Command) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command, "carrom", &mut script);
    super::print(&script)
}

//! The `carrom` command: parse the command line, run, print the error.

use std::io;
use std::process::ExitCode;

use carrom::cli::{
    Status,
    solve::{self, SolveArgs, SolveError},
};
use clap::{Parser, Subcommand};

/// A game of glancing collisions.
#[derive(Parser)]
#[command(version)]
struct Cli {
    /// Signs to write with: auto, ascii or unicode
    #[arg(long, global = true, default_value = "auto")]
    charset: String,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Solve(SolveArgs),
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    let Command::Solve(args) = cli.command;
    let unicode = cli.charset != "ascii";
    match solve::run(&args, unicode, io::stdin().lock(), io::stdout().lock()) {
        Ok(Status::Done) => ExitCode::SUCCESS,
        Ok(Status::Failed) => ExitCode::from(1),
        Err(error) => {
            eprintln!("carrom solve: {error}");
            ExitCode::from(match error {
                SolveError::Argument(_) => 2,
                SolveError::Io(_) => 1,
            })
        }
    }
}

//! The command line: one room a subcommand.

pub mod solve;

/// How a command ended when it could do its work at all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Everything was done: exit code 0.
    Done,
    /// Some of the work failed: exit code 1.
    Failed,
}

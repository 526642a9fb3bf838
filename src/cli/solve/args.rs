//! The options of `carrom solve`.

use super::problem::{Problem, number};
use crate::cli::Failure;
use crate::physics::Collision;

/// Work out one collision, or many with --batch.
#[derive(Debug, Clone, clap::Args)]
#[command(
    after_help = "Angles are in degrees. The striker moves along +x; the impact angle runs from its \
                  motion as the target sees it to the line of centres, positive when the target \
                  lies to the right."
)]
pub(in crate::cli) struct Args {
    #[command(flatten)]
    problem: Problem,

    /// Print one JSON object instead of the worked solution
    #[arg(long)]
    pub(super) json: bool,

    /// Say the solution in plain lines to be read aloud; without an impact angle or an
    /// offset, ask for the hit first
    #[arg(long, conflicts_with_all = ["json", "batch"])]
    pub(in crate::cli) plain: bool,

    /// Read problems from standard input as JSON Lines and answer one line each
    #[arg(
        long,
        long_help = "Read problems from standard input as JSON Lines and answer one line each\n\n\
                     A problem is {\"m1_g\":15,\"m2_g\":15,\"u1\":[4,0],\"alpha_deg\":30}, with \
                     \"u2\", \"restitution\" and \"stick\" as wanted; \"offset_mm\", \"r1_mm\" and \
                     \"r2_mm\" may stand in place of \"alpha_deg\". Blank lines are passed over.",
        conflicts_with_all = [
            "m1_g", "m2_g", "u1", "alpha_deg", "offset_mm", "r1_mm", "r2_mm", "u2",
            "restitution", "stick"
        ]
    )]
    pub(super) batch: bool,
}

impl Args {
    /// Whether it is said where the two meet.
    pub(in crate::cli) fn is_complete(&self) -> bool {
        self.problem.alpha_deg.is_some() || self.problem.offset_mm.is_some()
    }

    /// The collision that is asked for, and whether it was given by the offset.
    pub(super) fn collision(&self) -> Result<(Collision, bool), Failure> {
        if !self.is_complete() {
            return Err(Failure::input(
                "--alpha-deg: missing: expected this, or --offset-mm with --r1-mm and --r2-mm; \
                 --plain asks for it",
            ));
        }
        let [speed, _] = self.problem.u1.unwrap_or_default();
        let collision = number("speed", speed).and_then(|_| self.problem.collision());
        collision.map_err(|fault| {
            let option = fault.field.replace('_', "-");
            Failure::input(format!("--{option}: {}", fault.message))
        })
    }
}

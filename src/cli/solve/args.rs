//! The options of `carrom solve`.

use super::problem::{Problem, number};
use crate::cli::Failure;
use crate::physics::Collision;

/// Solve one collision, or many with --batch
#[derive(Debug, Clone, clap::Args)]
#[command(
    after_help = "Angles are in degrees. The striker moves along +x. The impact angle is the angle \
                  from the striker's velocity relative to the target to the line of centres, positive \
                  if the target is on the right."
)]
pub(in crate::cli) struct Args {
    #[command(flatten)]
    problem: Problem,

    /// Print one JSON object instead of the worked solution
    #[arg(long)]
    pub(super) json: bool,

    /// Print the solution in plain lines to be read aloud; without an impact angle or an
    /// offset, ask for the collision first
    #[arg(long, conflicts_with_all = ["json", "batch"])]
    pub(in crate::cli) plain: bool,

    /// Read problems from standard input as JSON Lines and answer each with one line
    #[arg(
        long,
        long_help = "Read problems from standard input as JSON Lines and answer each with one line\n\n\
                     A problem is {\"m1_g\":15,\"m2_g\":15,\"u1\":[4,0],\"alpha_deg\":30}; \
                     \"u2\", \"restitution\" and \"stick\" are optional; \"offset_mm\", \"r1_mm\" and \
                     \"r2_mm\" can replace \"alpha_deg\". Blank lines are skipped.",
        conflicts_with_all = [
            "m1_g", "m2_g", "u1", "alpha_deg", "offset_mm", "r1_mm", "r2_mm", "u2",
            "restitution", "stick"
        ]
    )]
    pub(super) batch: bool,
}

impl Args {
    /// Whether the impact angle or the offset is given.
    pub(in crate::cli) fn is_complete(&self) -> bool {
        self.problem.alpha_deg.is_some() || self.problem.offset_mm.is_some()
    }

    /// The collision, and whether it was given by the offset.
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

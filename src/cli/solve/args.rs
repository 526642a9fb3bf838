//! The options of `carrom solve`.

use super::problem::{Problem, Solvable, number};
use crate::cli::Failure;

/// The sign conventions of the input.
const SIGNS: &str = "Angles are in degrees. The striker moves along +x. The impact angle is the angle \
                     from the striker's velocity relative to the target to the line of centres, \
                     positive if the target is on the right.";

/// The sign conventions of the answers.
const SIGNS_OF_ANSWERS: &str = "In JSON, +y is 90 degrees anticlockwise from +x. theta1_deg \
     is the angle from u1 to v1, positive anticlockwise. theta2_deg is the angle from u1 to v2, \
     positive clockwise. For discs that stick, spin_rad_s is the angular velocity, positive \
     clockwise; spin_ccw_rad_s is the same, positive anticlockwise. With rim_friction, spin1 or \
     spin2, spin1_ccw_rad_s and spin2_ccw_rad_s are the spins after the collision, positive \
     anticlockwise, as are spin1 and spin2. \"assumed\" lists what was assumed because the \
     problem does not give it, and what was ignored. `carrom guide solve` describes every \
     field.";

/// Solve one collision, or many with --batch
#[derive(Debug, Clone, clap::Args)]
#[command(
    after_help = SIGNS,
    after_long_help = format!("{SIGNS}\n\n{SIGNS_OF_ANSWERS}")
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
                     \"u2\", \"restitution\" and \"stick\" are optional, as are \"rim_friction\", \
                     \"spin1\" and \"spin2\"; \"offset_mm\", \"r1_mm\" and \"r2_mm\" can replace \
                     \"alpha_deg\". Blank lines are skipped.",
        conflicts_with_all = [
            "m1_g", "m2_g", "u1", "alpha_deg", "offset_mm", "r1_mm", "r2_mm", "u2",
            "restitution", "stick", "rim_friction", "spin1", "spin2"
        ]
    )]
    pub(super) batch: bool,
}

impl Args {
    /// Whether the arguments give an impact angle or an offset.
    pub(in crate::cli) fn is_complete(&self) -> bool {
        self.problem.alpha_deg.is_some() || self.problem.offset_mm.is_some()
    }

    /// The collision, with the default masses and speed if they are not given.
    pub(super) fn solvable(&self) -> Result<Solvable, Failure> {
        if !self.is_complete() {
            return Err(Failure::input(
                "--alpha-deg: missing: expected this, or --offset-mm with --r1-mm and --r2-mm; \
                 --plain asks for it",
            ));
        }
        let (problem, assumed) = self.problem.with_usual();
        let [speed, _] = problem.u1.unwrap_or_default();
        let solvable = number("speed", speed).and_then(|_| problem.solvable());
        let mut solvable = solvable.map_err(|fault| {
            let option = fault.field.replace('_', "-");
            Failure::input(format!("--{option}: {}", fault.message))
        })?;
        solvable.assumed.splice(..0, assumed);
        Ok(solvable)
    }
}

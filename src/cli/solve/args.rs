//! The options of `carrom solve`, and the problem they describe.

use super::problem::{Problem, ProblemError, number};
use crate::physics::Collision;

/// Work out one collision, or many with --batch.
#[derive(Debug, Clone, clap::Args)]
#[command(
    after_help = "Angles are in degrees. The striker moves along +x; the impact angle runs from its \
                  motion as the target sees it to the line of centres, positive when the target \
                  lies to the right."
)]
pub(in crate::cli) struct Args {
    /// Mass of the striker in grams
    #[arg(
        long,
        value_name = "G",
        default_value_t = 15.0,
        allow_negative_numbers = true
    )]
    m1_g: f64,

    /// Mass of the target in grams
    #[arg(
        long,
        value_name = "G",
        default_value_t = 15.0,
        allow_negative_numbers = true
    )]
    m2_g: f64,

    /// Speed of the striker in m/s, along +x
    #[arg(
        long,
        value_name = "M/S",
        default_value_t = 4.0,
        allow_negative_numbers = true
    )]
    speed: f64,

    /// Impact angle in degrees, -90 to 90
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    alpha_deg: Option<f64>,

    /// Offset of the target's centre to the right of the striker's path in mm,
    /// instead of the impact angle
    #[arg(
        long,
        value_name = "MM",
        allow_negative_numbers = true,
        conflicts_with = "alpha_deg",
        requires_all = ["r1_mm", "r2_mm"]
    )]
    offset_mm: Option<f64>,

    /// Radius of the striker in mm
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    r1_mm: Option<f64>,

    /// Radius of the target in mm
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    r2_mm: Option<f64>,

    /// Velocity of the target in m/s, as X,Y
    #[arg(
        long,
        value_name = "X,Y",
        default_value = "0,0",
        value_parser = pair,
        allow_hyphen_values = true
    )]
    u2: [f64; 2],

    /// Coefficient of restitution, 0 to 1
    #[arg(
        long,
        value_name = "E",
        default_value_t = 1.0,
        allow_negative_numbers = true
    )]
    restitution: f64,

    /// The discs stick where they touch and go on as one
    #[arg(long)]
    stick: bool,

    /// Print one JSON object instead of the worked solution
    #[arg(long)]
    pub(super) json: bool,

    /// Say the solution in plain lines to be read aloud; without an impact angle or an
    /// offset, ask for the hit first
    #[arg(long, conflicts_with_all = ["json", "batch"])]
    pub(super) plain: bool,

    /// Read problems from standard input as JSON Lines and answer one line each
    #[arg(
        long,
        long_help = "Read problems from standard input as JSON Lines and answer one line each\n\n\
                     A problem is {\"m1_g\":15,\"m2_g\":15,\"u1\":[4,0],\"alpha_deg\":30}, with \
                     \"u2\", \"restitution\" and \"stick\" as wanted; \"offset_mm\", \"r1_mm\" and \
                     \"r2_mm\" may stand in place of \"alpha_deg\". Blank lines are passed over.",
        conflicts_with_all = [
            "m1_g", "m2_g", "speed", "alpha_deg", "offset_mm", "r1_mm", "r2_mm", "u2",
            "restitution", "stick"
        ]
    )]
    pub(super) batch: bool,
}

impl Args {
    /// Whether it is said where the two meet.
    pub(super) fn is_complete(&self) -> bool {
        self.alpha_deg.is_some() || self.offset_mm.is_some()
    }

    /// The collision that is asked for, and whether it was given by the offset.
    pub(super) fn collision(&self) -> Result<(Collision, bool), ProblemError> {
        if !self.is_complete() {
            return Err(ProblemError {
                field: "--alpha-deg".into(),
                message: "missing: expected this, or --offset-mm with --r1-mm and --r2-mm; \
                          --plain asks for it"
                    .into(),
            });
        }
        let speed = number("speed", self.speed).map_err(as_option)?;
        let problem = Problem {
            m1_g: Some(self.m1_g),
            m2_g: Some(self.m2_g),
            u1: Some([speed, 0.0]),
            u2: Some(self.u2),
            alpha_deg: self.alpha_deg,
            offset_mm: self.offset_mm,
            r1_mm: self.r1_mm,
            r2_mm: self.r2_mm,
            restitution: Some(self.restitution),
            stick: Some(self.stick),
        };
        problem.collision().map_err(as_option)
    }
}

/// A fault of a field as a fault of the option that set it.
fn as_option(fault: ProblemError) -> ProblemError {
    ProblemError {
        field: format!("--{}", fault.field.replace('_', "-")),
        ..fault
    }
}

fn pair(text: &str) -> Result<[f64; 2], String> {
    let number = |part: &str| part.trim().parse::<f64>().ok();
    text.split_once(',')
        .and_then(|(x, y)| Some([number(x)?, number(y)?]))
        .ok_or_else(|| "expected two numbers in m/s with a comma between, as in -1,0.5".to_owned())
}

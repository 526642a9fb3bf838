//! `carrom figure`: draws a figure from the lessons as a picture, without a terminal.

use std::path::PathBuf;

use super::options::Auto;
use super::{Failure, GlobalOptions, print, written};
use crate::files::brief;
use crate::screens::KeptSettings;
use crate::screens::learn::draw_figure;
use crate::widgets::{Charset, Depth, Palette};

/// Draw a figure from the lessons as an SVG picture
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Figures: lab, split, triangle, frames, curves, angles, energy, worked, solve, foil,\n\
                  shots.\n\
                  Fields after the name change the worked shot:\n  \
                  carrom figure curves alpha_deg=45 --svg curves.svg\n  \
                  carrom figure lab m1_g=20 m2_g=40 speed=3 alpha_deg=45 --svg marbles.svg\n\
                  docs/lessons.md lists them all."
)]
pub(super) struct Args {
    /// The figure and its fields
    #[arg(value_name = "NAME [FIELD=VALUE]", required = true)]
    words: Vec<String>,
    /// The file to write (default: standard output)
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// Replace an existing file
    #[arg(long, requires = "svg")]
    force: bool,
    /// Dark on light, for paper and slides
    #[arg(long)]
    light: bool,
}

/// Figures are drawn in Unicode and full colour by default.
const AUTO: Auto = Auto {
    charset: Charset::Unicode,
    depth: Depth::True,
};

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    let mut settings = options.settings(AUTO, &KeptSettings::default());
    if args.light {
        settings.palette = Palette::Light;
    }
    let words = shlex::try_join(args.words.iter().map(String::as_str));
    let words = words.map_err(Failure::input)?;
    let picture = draw_figure(&words, &settings.look());
    let picture = picture.map_err(|error| Failure::input(brief(&error.to_string())))?;
    match &args.svg {
        Some(path) => written::write_beside(&[(path.clone(), picture)], args.force),
        None => print(picture.as_bytes()),
    }
}

//! `carrom measure`: analyses a filmed collision.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use strum::VariantNames;

use super::written::{NamedFile, named_file, write_named_beside};
use super::{Failure, GlobalOptions, given, print_json, print_text};
use crate::measure::{Given, LARGEST, Measurement, Reading, SlowingDown, read};
use crate::paper::measured_html;
use crate::physics::units::{kg_from_g, m_from_mm};

/// Analyse a filmed collision: the tracks of two bodies, compared with the exact prediction
///
/// Reads the tables that Tracker (physlets.org/tracker) exports or copies, or any table with the
/// time and the x and y of two bodies, and prints every quantity of the collision with its
/// uncertainty. See carrom guide measuring.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The tracks of both bodies, or two files with one body each; - reads standard input
    #[arg(required = true, num_args = 1..=2, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The columns of the time and of x and y of each body, by their headings or numbers
    #[arg(long, value_name = "t,x1,y1,x2,y2", value_delimiter = ',')]
    columns: Vec<String>,
    /// Millimetres per pixel, or per unit of columns without a unit; two numbers for x and y, the
    /// second negative if y points down
    #[arg(long, value_name = "MM[,MM]", value_parser = scale)]
    scale: Option<[f64; 2]>,
    /// Mass of the first body in grams
    #[arg(long, value_name = "G", requires = "m2_g", value_parser = positive)]
    m1_g: Option<f64>,
    /// Mass of the second body in grams
    #[arg(long, value_name = "G", requires = "m1_g", value_parser = positive)]
    m2_g: Option<f64>,
    /// Radius of the first body in millimetres
    #[arg(long, value_name = "MM", requires = "r2_mm", value_parser = positive)]
    r1_mm: Option<f64>,
    /// Radius of the second body in millimetres
    #[arg(long, value_name = "MM", requires = "r1_mm", value_parser = positive)]
    r2_mm: Option<f64>,
    /// Coefficient of restitution for the prediction, 0 to 1
    #[arg(long, value_name = "E", default_value = "1", value_parser = restitution)]
    restitution: f64,
    /// Whether the bodies slow down; auto: only if the data show it clearly
    #[arg(long, value_name = "WHEN", default_value = "auto", value_parser = slowing())]
    slowing: SlowingDown,
    /// Open a screen with a picture
    #[arg(long, conflicts_with_all = ["json", "report"])]
    pub(super) screen: bool,
    /// Print one JSON object
    #[arg(long, conflicts_with = "report")]
    json: bool,
    /// Write a report with a picture, to print or to hand in
    #[arg(long, value_name = "FILE.html")]
    #[arg(value_parser = |path: &str| named_file(path, ["html", "htm"]))]
    report: Option<NamedFile>,
    /// Replace an existing report
    #[arg(long, requires = "report")]
    force: bool,
}

fn number(text: &str, is_allowed: impl Fn(f64) -> bool, what: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok().filter(|it| is_allowed(*it));
    number.ok_or_else(|| format!("expected {what}"))
}

fn positive(text: &str) -> Result<f64, String> {
    let what = "a number from 0.000001 to 1000000";
    number(text, |x| (1e-6..=1e6).contains(&x), what)
}

fn restitution(text: &str) -> Result<f64, String> {
    number(text, |x| (0.0..=1.0).contains(&x), "a number from 0 to 1")
}

fn scale(text: &str) -> Result<[f64; 2], String> {
    let one = |text| {
        let is_allowed = |x: f64| (1e-6..=1e6).contains(&x.abs());
        let what = "one or two numbers in millimetres, such as 0.52 or 0.52,-0.52";
        number(text, is_allowed, what).map(m_from_mm)
    };
    match text.split_once(',') {
        None => one(text).map(|both| [both, both]),
        Some((x, y)) => Ok([one(x)?, one(y)?]),
    }
}

fn slowing() -> impl TypedValueParser<Value = SlowingDown> {
    let names = PossibleValuesParser::new(SlowingDown::VARIANTS);
    names.map(|name| name.parse().unwrap_or_default())
}

impl Args {
    pub(super) fn measurement(&self) -> Result<Measurement, Failure> {
        let files = self.files.iter();
        let contents = files.map(|path| given::named_bytes(path, LARGEST));
        let contents: Vec<_> = contents.collect::<Result<_, _>>()?;
        let named = contents
            .iter()
            .map(|(name, bytes)| (name.as_str(), &bytes[..]));
        let named: Vec<_> = named.collect();
        let reading = Reading {
            columns: self.columns.clone(),
            scale: self.scale,
            takes_pixels: self.screen,
        };
        let tracks = read(&named, &reading).map_err(Failure::input)?;
        let masses_g = self.m1_g.zip(self.m2_g);
        let radii_mm = self.r1_mm.zip(self.r2_mm);
        let given = Given {
            masses: masses_g.map(|(m1, m2)| [m1, m2].map(kg_from_g)),
            radii: radii_mm.map(|(r1, r2)| [r1, r2].map(m_from_mm)),
            scale: 1.0,
            restitution: self.restitution,
            slowing: self.slowing,
        };
        let name = contents.first().map_or("", |(name, _)| name.as_str());
        Measurement::new(tracks, given).map_err(|fault| Failure::input(fault.of_file(name)))
    }
}

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    let measurement = args.measurement()?;
    if let Some(report) = &args.report {
        let name = |path: &PathBuf| {
            let name = path.file_name().unwrap_or(path.as_os_str());
            name.to_string_lossy().into_owned()
        };
        let files: Vec<_> = args.files.iter().map(name).collect();
        let html = measured_html(&measurement, &files);
        let document = (report.path.clone(), html);
        return write_named_beside(&[document], args.force);
    }
    if args.json {
        return print_json(&measurement.json());
    }
    print_text(measurement.text().trim_end(), options)
}

//! The pictures of the report.

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

use super::Report;
use crate::paper::{LOOK, svg};
use crate::progress::{Calibrated, calibration_words};
use crate::quiz::RIGHT_DEG;
use crate::widgets::Role;
use crate::widgets::picture::{self, Pen, View};
use crate::widgets::plot::{REACH, errors_picture, sureness_picture};
use crate::widgets::svg::Svg;

/// Each share over time is calculated from this many of the last answers at one confidence level,
/// or from fewer at the start.
const SHARED: usize = 10;
/// The total number of answers is divided by this and rounded down to a multiple of ten; if the
/// result is more than [`SHARED`], it is used instead.
const GROUPS: usize = 40;
/// The sizes, in columns and rows, of a picture in the wide left column of the page and of a
/// picture in the narrow right one.
const WIDE: Rect = Rect::new(0, 0, 60, 14);
const NARROW: Rect = Rect::new(0, 0, 40, 14);
/// The fill of the target range.
const WASH: Pen = Pen::new(Role::Border).aged(0.8);

/// A picture of the report.
#[derive(Debug, Clone)]
pub struct ReportPicture {
    /// Its name, usable as a file name.
    pub name: &'static str,
    /// Its heading.
    pub title: &'static str,
    /// How to read it, or what it shows.
    pub legend: String,
    /// The picture as a vector drawing.
    pub svg: Svg,
}

impl Report<'_> {
    /// All pictures for which there are enough answers.
    pub fn pictures(&self) -> Vec<ReportPicture> {
        let pictures = [errors(self), calibration(self), over_time(self)];
        pictures.into_iter().flatten().collect()
    }
}

/// The error of each answer and the mean error of the last few answers; if there are many answers,
/// the mean errors of groups of answers.
fn errors(report: &Report) -> Option<ReportPicture> {
    let (picture, group) = errors_picture(report.attempts, usize::MAX, WIDE, LOOK)?;
    let words = "Angle error of each answer in degrees, in the order of the answers";
    let legend = match group {
        1 => {
            format!(
                "Dots are right answers, crosses wrong ones; the line is the mean of {REACH} \
                 answers."
            )
        }
        _ => format!(
            "The line shows the means of {group} answers each; right is within {RIGHT_DEG}°."
        ),
    };
    Some(ReportPicture {
        name: "errors",
        title: "Angle error over time",
        legend,
        svg: svg(words, &picture),
    })
}

/// The share of right answers at each confidence level, drawn over its target range.
fn calibration(report: &Report) -> Option<ReportPicture> {
    let said = |it: &Calibrated| it.tally.attempts > 0;
    if !report.calibration.iter().any(said) {
        return None;
    }
    let rows = report.calibration.len() as f64;
    let paper = Rect {
        x: 9,
        width: NARROW.width - 11,
        height: NARROW.height - 3,
        ..NARROW
    };
    let view = View::stretch(paper, DVec2::ZERO, dvec2(100.0, rows));
    let mut picture = picture::Picture::new(view).within(NARROW);
    let below = |rows: f64| -rows * view.per_row();
    for percent in [0, 50, 80, 100] {
        let x = f64::from(percent);
        picture.line(dvec2(x, 0.0), dvec2(x, rows), Role::BoardLine);
        picture.text(dvec2(x, below(1.0)), percent.to_string(), Role::Dim);
    }
    picture.text(dvec2(25.0, below(2.2)), "right (%)", Role::Dim);
    picture.fill(dvec2(55.0, below(2.5)), dvec2(63.0, below(1.9)), WASH);
    picture.text(dvec2(84.0, below(2.2)), "calibrated", Role::Dim);
    for (row, it) in report.calibration.iter().enumerate() {
        let y = row as f64 + 0.5;
        let (from, to) = Calibrated::honest(it.confidence);
        picture.fill(
            dvec2(100.0 * from, y - 0.3),
            dvec2(100.0 * to, y + 0.3),
            WASH,
        );
        let name = dvec2(-5.0 * view.per_column(), y);
        picture.text(name, it.confidence.name(), Role::Text);
        let Some(share) = it.tally.share_right() else {
            picture.text(dvec2(50.0, y), "none yet", Role::Dim);
            continue;
        };
        let end = dvec2(100.0 * share, y);
        let pen = Pen::new(Role::StrikerOut).bold();
        picture.line(dvec2(0.0, y), end, pen);
        picture.text(end, "●", Role::StrikerOut);
        let counted = format!("{} of {}", it.tally.right, it.tally.attempts);
        // Beside the dot, on the side with more space.
        let aside = (0.5 * counted.len() as f64 + 1.0) * view.per_column();
        let x = end.x + if share > 0.6 { -aside } else { aside };
        picture.text(dvec2(x, y + 0.2), counted, Role::Text);
    }
    let words = "Share of right answers at each confidence level, with its target range";
    Some(ReportPicture {
        name: "calibration",
        title: "Confidence and right answers",
        legend: calibration_words(&report.calibration).into(),
        svg: svg(words, &picture),
    })
}

/// The share of right answers among the last few answers at each confidence level, over time.
fn over_time(report: &Report) -> Option<ReportPicture> {
    // If there are many answers, each share uses more of them, so that the line is smooth.
    let reach = SHARED.max(report.attempts.len() / GROUPS / 10 * 10);
    let picture = sureness_picture(report.attempts, usize::MAX, reach, NARROW, LOOK)?;
    let words = "Share of right answers among the last few at each confidence level, over time";
    Some(ReportPicture {
        name: "calibration-over-time",
        title: "Confidence and right answers over time",
        legend: format!(
            "Right answers (%) among the last {reach} at each level. Well calibrated: sure above \
             80, think so 50 to 80, guess below."
        ),
        svg: svg(words, &picture),
    })
}

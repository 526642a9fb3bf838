//! The pictures of the report.

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

use super::Report;
use crate::paper::{LOOK, svg};
use crate::progress::{Calibrated, calibration_over_time, calibration_words, smoothed_errors_deg};
use crate::quiz::{Confidence, RIGHT_DEG};
use crate::widgets::Role;
use crate::widgets::picture::{self, Pen, Side, View};
use crate::widgets::plot::{Axis, Plot};
use crate::widgets::svg::Svg;

/// How many answers the line of errors takes the mean of.
const REACH: usize = 5;
/// How many answers of one confidence a share is taken of, at least.
const SHARED: usize = 10;
/// Of how many parts of all answers a share is taken, where those are more.
const GROUPS: usize = 40;
/// More answers than this are drawn as means of groups.
const MOST_MARKS: usize = 120;
/// Columns and rows of a picture over the whole width, and of one beside another.
const WIDE: Rect = Rect::new(0, 0, 60, 14);
const NARROW: Rect = Rect::new(0, 0, 40, 14);
/// What fills the range that is hoped for.
const WASH: Pen = Pen::new(Role::Border).aged(0.8);

/// A picture of the report.
#[derive(Debug, Clone)]
pub struct ReportPicture {
    /// Its name, fit for a file.
    pub name: &'static str,
    /// What it is about.
    pub title: &'static str,
    /// How to read it, or what to make of it.
    pub legend: String,
    /// The picture.
    pub svg: Svg,
}

/// All pictures there are.
pub(super) fn all(report: &Report) -> Vec<ReportPicture> {
    let pictures = [errors(report), calibration(report), over_time(report)];
    pictures.into_iter().flatten().collect()
}

/// The error of each answer and the mean of the last few; of many answers, the means of
/// groups of them.
fn errors(report: &Report) -> Option<ReportPicture> {
    let errors = smoothed_errors_deg(report.attempts, REACH);
    let (first, last) = (errors.first()?, errors.last()?);
    let group = errors.len().div_ceil(MOST_MARKS);
    let line: Vec<DVec2> = match group {
        1 => errors
            .iter()
            .map(|(number, _, mean)| at(*number, *mean))
            .collect(),
        _ => errors
            .chunks(group)
            .filter_map(|group| {
                let sum: f64 = group.iter().map(|(_, error, _)| error).sum();
                let (number, ..) = group.get(group.len() / 2)?;
                Some(at(*number, sum / group.len() as f64))
            })
            .collect(),
    };
    let highest = match group {
        1 => errors
            .iter()
            .map(|(_, error, _)| *error)
            .fold(0.0, f64::max),
        _ => line.iter().map(|point| point.y).fold(0.0, f64::max),
    };
    let top = (10.0 * (highest / 10.0).floor() + 10.0).clamp(20.0, 180.0);
    let (from, to) = (first.0 as f64, (last.0 as f64).max(first.0 as f64 + 9.0));
    let words = format!(
        "Angle error in degrees of {} answers in the order in which they were given",
        errors.len()
    );
    let x = Axis::linear("answer", from - 0.5, to + 0.5);
    let y = Axis::linear("off by (°)", 0.0, top);
    let mut plot = Plot::new(WIDE, LOOK, x, y);
    plot.band(0.0, RIGHT_DEG, WASH);
    plot.curve(line.iter().copied(), Pen::new(Role::StrikerOut).bold());
    if group == 1 {
        for (number, error, _) in &errors {
            let right = report.attempts.get(number - 1).is_some_and(|it| it.right);
            let (mark, role) = if right {
                ('●', Role::StrikerOut)
            } else {
                ('○', Role::Dim)
            };
            plot.mark(at(*number, *error), mark, role);
        }
    }
    let legend = match group {
        1 => format!("Dots are right, rings not yet; the line is the mean of {REACH}."),
        _ => format!("The line is the mean of each {group} answers; right is within {RIGHT_DEG}°."),
    };
    Some(ReportPicture {
        name: "errors",
        title: "How far off, over time",
        legend,
        svg: svg(&words, &plot.picture()),
    })
}

fn at(number: usize, y: f64) -> DVec2 {
    dvec2(number as f64, y)
}

/// Of each confidence the share that was right, on the range for which it pays.
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
    picture.text(dvec2(84.0, below(2.2)), "honest range", Role::Dim);
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
        let side = if share > 0.6 {
            Side::AboveLeft
        } else {
            Side::AboveRight
        };
        picture.label(counted, end, &[side], Role::Text);
    }
    let words = "Share of right answers of each confidence, beside the range it is for";
    Some(ReportPicture {
        name: "calibration",
        title: "How sure, and how right",
        legend: calibration_words(&report.calibration).into(),
        svg: svg(words, &picture),
    })
}

/// Of each confidence the share that was right among the last few, as time went by.
fn over_time(report: &Report) -> Option<ReportPicture> {
    // Of many answers, the share of more of them: the line shall not tremble.
    let reach = SHARED.max(report.attempts.len() / GROUPS / 10 * 10);
    let shares = calibration_over_time(report.attempts, reach);
    let points = || shares.iter().flatten();
    let first = points().map(|(number, _)| *number).min()? as f64;
    let last = points().map(|(number, _)| *number).max()? as f64;
    let words = "Share of right answers among the last few of each confidence, over time";
    // With room for the names at the end of the lines.
    let x = Axis::linear(
        "answer",
        first - 0.5,
        first + 1.3 * (last - first).max(9.0) + 0.5,
    );
    let y = Axis::linear("right (%)", 0.0, 100.0).every(50.0);
    let mut plot = Plot::new(NARROW, LOOK, x, y);
    plot.band(50.0, 80.0, WASH);
    for (confidence, shares) in Confidence::ALL.into_iter().zip(&shares) {
        let pen = match confidence {
            Confidence::Sure => Pen::new(Role::StrikerOut).bold(),
            Confidence::ThinkSo => Pen::new(Role::Text).dashed(),
            Confidence::Guess => Pen::new(Role::Dim).dotted(),
        };
        let step = shares.len().div_ceil(MOST_MARKS).max(1);
        // Thinned from the end, so that the last one is always there.
        let mut line: Vec<_> = shares.iter().rev().step_by(step).collect();
        line.reverse();
        let line: Vec<_> = line
            .iter()
            .map(|(n, share)| at(*n, 100.0 * share))
            .collect();
        if let [only] = line[..] {
            plot.mark(only, '●', Role::StrikerOut);
        }
        plot.curve(line.iter().copied(), pen);
        if let Some(end) = line.last() {
            let sides = [Side::Right, Side::AboveRight, Side::BelowRight];
            plot.label(confidence.name(), *end, &sides, Role::Text);
        }
    }
    Some(ReportPicture {
        name: "calibration-over-time",
        title: "How sure, and how right, over time",
        legend: format!(
            "Right of the last {reach} answers of each. Honest is: sure above 80, think so \
             from 50 to 80, guess below."
        ),
        svg: svg(words, &plot.picture()),
    })
}

//! The pictures of the report.

use glam::{DVec2, dvec2};

use super::Report;
use crate::paper::{Anchor, Chart, Ink, Mark, Stroke, Svg};
use crate::progress::{Calibrated, calibration_over_time, calibration_words, smoothed_errors_deg};
use crate::quiz::{Confidence, RIGHT_DEG};
use crate::widgets::plot::Axis;

/// How many answers the line of errors takes the mean of.
const REACH: usize = 5;
/// How many answers of one confidence a share is taken of, at least.
const SHARED: usize = 10;
/// Of how many parts of all answers a share is taken, where those are more.
const GROUPS: usize = 40;
/// More answers than this are drawn as means of groups.
const MOST_MARKS: usize = 120;
/// Least distance of two labels.
const APART: f64 = 12.0;

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
    let mut chart = Chart::new(
        &words,
        410.0,
        176.0,
        x,
        Axis::linear("off by (°)", 0.0, top),
    );
    chart.band(0.0, RIGHT_DEG, Ink::Wash);
    chart.curve(line.iter().copied(), Stroke::new(Ink::Accent).wide(2.0));
    if group == 1 {
        for (number, error, _) in &errors {
            let right = report.attempts.get(number - 1).is_some_and(|it| it.right);
            let (mark, ink) = if right {
                (Mark::Dot, Ink::Accent)
            } else {
                (Mark::Ring, Ink::Dim)
            };
            chart.mark(at(*number, *error), mark, ink);
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
        svg: chart.picture(),
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
    const WIDTH: f64 = 262.0;
    const ROW: f64 = 42.0;
    let (left, right) = (58.0, WIDTH - 14.0);
    let mut svg = Svg::new(
        "Share of right answers of each confidence, beside the range it is for",
        WIDTH,
        176.0,
    );
    let x = |share: f64| left + share * (right - left);
    let bottom = 3.0 * ROW + 12.0;
    for percent in [0, 50, 80, 100] {
        let at = x(f64::from(percent) / 100.0);
        svg.line(
            dvec2(at, 8.0),
            dvec2(at, bottom),
            Stroke::new(Ink::Faint).wide(0.6),
        );
        let text = format!("{percent}");
        svg.label(&text, dvec2(at, bottom + 10.0), Anchor::Middle, Ink::Dim);
    }
    svg.label(
        "right (%)",
        dvec2(x(0.25), bottom + 28.0),
        Anchor::Middle,
        Ink::Dim,
    );
    svg.rectangle(
        dvec2(x(0.56), bottom + 23.0),
        dvec2(x(0.64), bottom + 33.0),
        Ink::Wash,
    );
    svg.label(
        "honest range",
        dvec2(x(0.67), bottom + 28.0),
        Anchor::Start,
        Ink::Dim,
    );
    for (row, it) in report.calibration.iter().rev().enumerate() {
        let y = 8.0 + ROW * (row as f64 + 0.5);
        let (from, to) = Calibrated::honest(it.confidence);
        svg.rectangle(dvec2(x(from), y - 13.0), dvec2(x(to), y + 13.0), Ink::Wash);
        svg.label(
            it.confidence.name(),
            dvec2(0.0, y),
            Anchor::Start,
            Ink::Text,
        );
        let Some(share) = it.tally.share_right() else {
            svg.label("none yet", dvec2(x(0.5), y), Anchor::Middle, Ink::Dim);
            continue;
        };
        svg.line(
            dvec2(x(0.0), y),
            dvec2(x(share), y),
            Stroke::new(Ink::Accent).wide(2.0),
        );
        svg.circle(dvec2(x(share), y), 4.5, Some(Ink::Accent), None);
        let counted = format!("{} of {}", it.tally.right, it.tally.attempts);
        let (anchor, off) = if share > 0.6 {
            (Anchor::End, -10.0)
        } else {
            (Anchor::Start, 10.0)
        };
        svg.label(&counted, dvec2(x(share) + off, y - 9.0), anchor, Ink::Text);
    }
    Some(ReportPicture {
        name: "calibration",
        title: "How sure, and how right",
        legend: calibration_words(&report.calibration).into(),
        svg,
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
    let x = Axis::linear("answer", first - 0.5, last.max(first + 9.0) + 0.5);
    let y = Axis::linear("right (%)", 0.0, 100.0).every(50.0);
    // Room for the names at the end of the lines.
    let mut chart = Chart::with_room(words, 262.0, 176.0, 58.0, x, y);
    chart.band(50.0, 80.0, Ink::Wash);
    chart.level(50.0, Stroke::new(Ink::Faint));
    chart.level(80.0, Stroke::new(Ink::Faint));
    let mut names = Vec::new();
    for (confidence, shares) in Confidence::ALL.into_iter().zip(&shares) {
        let stroke = match confidence {
            Confidence::Sure => Stroke::new(Ink::Accent).wide(2.2),
            Confidence::ThinkSo => Stroke::new(Ink::Text).wide(1.5).dashed(),
            Confidence::Guess => Stroke::new(Ink::Dim).wide(1.5).dotted(),
        };
        let step = shares.len().div_ceil(MOST_MARKS).max(1);
        // Thinned from the end, so that the last one is always there.
        let mut line: Vec<_> = shares.iter().rev().step_by(step).collect();
        line.reverse();
        let line: Vec<_> = line
            .iter()
            .map(|(n, share)| at(*n, 100.0 * share))
            .collect();
        if let ([only], Some(_)) = (line.as_slice(), shares.last()) {
            chart.mark(*only, Mark::Dot, Ink::Accent);
        }
        chart.curve(line.iter().copied(), stroke);
        if let Some(end) = line.last() {
            names.push((*end, confidence.name()));
        }
    }
    // Names keep their distance, from the lowest line up.
    names.sort_by(|a, b| a.0.y.total_cmp(&b.0.y));
    let mut lowest = f64::INFINITY;
    for (end, name) in names {
        let Some(height) = chart.height(end.y) else {
            continue;
        };
        let wanted = height.min(lowest - APART);
        lowest = wanted;
        let off = dvec2(6.0, wanted - height);
        chart.label(name, end, off, Anchor::Start, Ink::Text);
    }
    Some(ReportPicture {
        name: "calibration-over-time",
        title: "How sure, and how right, over time",
        legend: format!(
            "Right of the last {reach} answers of each. Honest is: sure above 80, think so \
             from 50 to 80, guess below."
        ),
        svg: chart.picture(),
    })
}

//! Plots of a player's answers, for the screen and for reports.

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

use super::{Axis, Plot};
use crate::progress::{Attempt, Calibrated, calibration_over_time, smoothed_errors_deg};
use crate::quiz::{Confidence, RIGHT_DEG};
use crate::widgets::picture::{LabelSide as S, Pen, Picture};
use crate::widgets::{Look, Role};

/// The number of answers over which each point of the error line is averaged.
pub(crate) const REACH: usize = 5;
/// The number of answers above which the plot shows means of groups instead of single answers.
const MOST_MARKS: usize = 120;

/// Plots the error of each recent answer, and the mean of the last few errors; if there are many
/// answers, plots the means of groups instead. Also returns the size of a group. `None` if no
/// answer was an angle.
pub(crate) fn errors_picture(
    attempts: &[Attempt],
    last: usize,
    area: Rect,
    look: Look,
) -> Option<(Picture, usize)> {
    let errors = smoothed_errors_deg(attempts, REACH);
    let shown = &errors[errors.len().saturating_sub(last)..];
    let (first, last) = (shown.first()?.0 as f64, shown.last()?.0 as f64);
    let at = |number: usize, y: f64| dvec2(number as f64, y);
    let group = shown.len().div_ceil(MOST_MARKS);
    let mean = |group: &[(usize, f64, f64)]| match group {
        [(number, _, mean)] => at(*number, *mean),
        _ => {
            let sum: f64 = group.iter().map(|(_, error, _)| error).sum();
            at(group[group.len() / 2].0, sum / group.len() as f64)
        }
    };
    let line: Vec<DVec2> = shown.chunks(group).map(mean).collect();
    let highest = match group {
        1 => shown.iter().map(|(_, error, _)| *error).fold(0.0, f64::max),
        _ => line.iter().map(|point| point.y).fold(0.0, f64::max),
    };
    // The top of the axis is a multiple of ten, with some space above the highest value unless
    // that value is 180.
    let top = (10.0 * (highest / 10.0).floor() + 10.0).clamp(20.0, 180.0);
    let from = first.min((last - 9.0).max(1.0));
    let to = last.max(from + 9.0);
    let numbers = Axis::linear("answer", from - 0.5, to + 0.5);
    let mut plot = Plot::new(area, look, numbers, Axis::linear("off by (°)", 0.0, top));
    plot.hline(RIGHT_DEG, Pen::new(Role::Good).dashed());
    plot.curve(line, Pen::new(Role::StrikerOut).bold());
    for (number, error, _) in shown.iter().filter(|_| group == 1) {
        let right = attempts.get(number - 1).is_some_and(|it| it.right);
        let (sign, role) = match right {
            true => ('o', Role::Good),
            false => ('x', Role::Predicted),
        };
        plot.mark(at(*number, *error), sign, role);
    }
    let above = [S::AboveLeft, S::Above, S::AboveRight];
    plot.label("right", dvec2(to, RIGHT_DEG), &above, Role::Good);
    Some((plot.picture(), group))
}

/// Plots, for each confidence level, how the fraction of right answers among its last `reach`
/// answers changes over the recent answers. `None` if there are too few answers.
pub(crate) fn sureness_picture(
    attempts: &[Attempt],
    last: usize,
    reach: usize,
    area: Rect,
    look: Look,
) -> Option<Picture> {
    let hidden = attempts.len().saturating_sub(last);
    let mut lines = calibration_over_time(attempts, reach);
    for line in &mut lines {
        line.retain(|(number, _)| *number > hidden);
    }
    let first = lines.iter().flatten().map(|(number, _)| *number).min()?;
    let (from, to) = (first as f64, attempts.len().max(first + 9) as f64);
    let numbers = Axis::linear("answer", from - 0.5, to + 0.5);
    let shares = Axis::linear("right (%)", 0.0, 100.0).every(20.0);
    let mut plot = Plot::new(area, look, numbers, shares);
    for limit in [Confidence::Guess, Confidence::ThinkSo] {
        let (_, limit) = Calibrated::honest(limit);
        plot.hline(100.0 * limit, Pen::new(Role::Dim).dotted());
    }
    for (confidence, line) in Confidence::ALL.into_iter().zip(&lines) {
        let (pen, sign) = match confidence {
            Confidence::Guess => (Pen::new(Role::Dim).dotted(), 'g'),
            Confidence::ThinkSo => (Pen::new(Role::CoinOut).dashed(), 't'),
            Confidence::Sure => (Pen::new(Role::StrikerOut).bold(), 's'),
        };
        // The points are thinned out from the end, so that the last point is always included.
        let step = line.len().div_ceil(MOST_MARKS * 2).max(1);
        let points = line.iter().rev().step_by(step);
        let points: Vec<_> = points
            .map(|(n, share)| dvec2(*n as f64, 100.0 * share))
            .collect();
        plot.curve(points.iter().rev().copied(), pen);
        if let Some(end) = points.first() {
            plot.mark(*end, sign, pen.role);
            let sides = [S::Above, S::AboveLeft, S::Below, S::BelowLeft];
            plot.label(confidence.name(), *end, &sides, pen.role);
        }
    }
    Some(plot.picture())
}

//! The picture of a measured collision: the measured points, the fitted paths and the predicted
//! paths.

use glam::DVec2;
use ratatui::layout::Rect;

use super::Role;
use super::picture::{Body, LabelSide, Pen, Picture, View};
use crate::measure::{Known, Leg, LineFrom, Measurement, line};

/// The maximum number of points drawn for each leg of a path.
const MOST_POINTS: usize = 150;
/// The radius of a point in columns.
const POINT: f64 = 0.22;
/// The roles for each body: its points before the collision, its points after the collision, and
/// the body itself.
const ROLES: [[Role; 3]; 2] = [
    [Role::Incoming, Role::StrikerOut, Role::Striker],
    [Role::CoinOut, Role::CoinOut, Role::Coin],
];

/// The picture of a measurement, with this many columns and at most this many rows.
pub(crate) fn measured_picture(columns: u16, rows: u16, measurement: &Measurement) -> Picture {
    let fit = &measurement.fit;
    let (state, model) = (&fit.state, &fit.model);
    let radii = measurement.given.radii.unwrap_or([0.0; 2]);
    let mut low = DVec2::INFINITY;
    let mut high = DVec2::NEG_INFINITY;
    for track in &measurement.tracks {
        for point in &track.points {
            (low, high) = (low.min(point.at), high.max(point.at));
        }
    }
    for (body, radius) in radii.iter().enumerate() {
        let centre = state.centre(body);
        (low, high) = (low.min(centre - *radius), high.max(centre + *radius));
    }
    let margin = 0.06 * low.distance(high).max(1e-9);
    let size = high - low + 2.0 * margin;
    // A cell is twice as high as it is wide.
    let fitting = (0.5 * f64::from(columns) * size.y / size.x).ceil() as u16;
    let area = Rect::new(0, 0, columns, fitting.clamp(8, rows));
    let view = View::fit(area, low - margin, high + margin);
    let radius = POINT * view.per_column();
    let mut picture = Picture::new(view);
    for (body, track) in measurement.tracks.iter().enumerate() {
        let [before, after, disc] = ROLES[body];
        let centre = state.centre(body);
        let ends = (track.points.first(), track.points.last());
        let (Some(first), Some(last)) = ends else {
            continue;
        };
        let start = state.at(body, first.t, model);
        let fitted = state.at(body, last.t, model);
        picture.line(start, centre, Pen::new(Role::Trail));
        picture.line(centre, fitted, Pen::new(Role::Trail));
        if let Some(predicted) = measurement.predicted() {
            let end = predicted.at(body, last.t, model);
            picture.line(centre, end, Pen::new(Role::Predicted).dashed());
        }
        let step = track.points.len().div_ceil(2 * MOST_POINTS).max(1);
        let points = track.points.iter().step_by(step).map(|point| {
            let role = if point.t < state.time() {
                before
            } else {
                after
            };
            Body::new(point.at, radius, role, ' ')
        });
        picture.discs(points);
        if radii[body] > 0.0 {
            picture.ring(centre, radii[body], disc, (['1', '2'][body], centre));
        }
        let (sign, out) = (["₁", "₂"][body], state.velocity(body, Leg::After));
        picture.label(
            format!("v{sign} {}", track.name),
            last.at,
            &LabelSide::towards(out),
            after,
        );
        let into = state.velocity(body, Leg::Before);
        if start.distance(centre) > margin {
            picture.label(
                format!("u{sign}"),
                start,
                &LabelSide::towards(-into),
                before,
            );
        }
    }
    let known: &Known = &measurement.known;
    let along = line(state, known);
    let reach = match known.line {
        LineFrom::Centres => 1.6 * radii[0].max(radii[1]),
        LineFrom::Impulse => 1.5 * margin,
    };
    let pen = Pen::new(Role::LineOfImpact).dotted();
    picture.line(
        state.centre(0) - reach * along,
        state.centre(1) + reach * along,
        pen,
    );
    picture
}

/// The picture described in words.
pub(crate) fn measured_words(measurement: &Measurement) -> String {
    let [first, second] = measurement.names();
    format!(
        "The measured points of {first} and {second} before and after their contact, the fitted \
         paths, the paths predicted from the state before (dashed) and the line of impact (dotted)"
    )
}

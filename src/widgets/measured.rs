//! The picture of a measured collision: its points, the fitted paths and the predicted ones.

use glam::DVec2;
use ratatui::layout::Rect;

use super::Role;
use super::picture::{DrawLayer, LabelSide, Pen, Picture, View, around};
use crate::measure::{Leg, LineFrom, Measurement, line};

/// At most twice this number of points of each track are drawn, because a track has two legs.
const MOST_POINTS: usize = 150;
/// The width of the margin, as a fraction of the diagonal of the rectangle inside it.
const MARGIN: f64 = 0.06;
/// The roles for each body: for its points before the contact, for its points after the contact,
/// and for the body itself.
const ROLES: [[Role; 3]; 2] = [
    [Role::Incoming, Role::StrikerOut, Role::Striker],
    [Role::CoinOut, Role::CoinOut, Role::Coin],
];

/// The height, in rows, at which a picture `columns` wide leaves no space empty.
pub(crate) fn measured_rows(columns: u16, measurement: &Measurement) -> u16 {
    let [low, high] = corners(measurement);
    let size = high - low;
    // A cell is twice as high as it is wide.
    (0.5 * f64::from(columns) * size.y / size.x).ceil() as u16
}

/// The lower left and the upper right corner of the smallest rectangle that contains the measured
/// points and the discs at contact, with a margin.
fn corners(measurement: &Measurement) -> [DVec2; 2] {
    let points = measurement.tracks.iter().flat_map(|track| &track.points);
    let points = points.map(|point| (point.at, 0.0));
    let radii = measurement.given.radii.unwrap_or([0.0; 2]);
    let discs = [0, 1].map(|body| (measurement.fit.state.centre(body), radii[body]));
    let [low, high] = around(points.chain(discs));
    let margin = MARGIN * low.distance(high).max(1e-9);
    [low - margin, high + margin]
}

/// A picture of the measured points alone, which fills an area.
pub(crate) fn points_picture(area: Rect, measurement: &Measurement) -> Picture {
    let [low, high] = corners(measurement);
    let mut picture = Picture::new(View::fit(area, low, high));
    for (track, roles) in measurement.tracks.iter().zip(ROLES) {
        let step = track.points.len().div_ceil(2 * MOST_POINTS).max(1);
        for point in track.points.iter().step_by(step) {
            let is_before = point.t < measurement.fit.state.time();
            let role = if is_before { roles[0] } else { roles[1] };
            picture.dot(point.at, Pen::new(role).bold().on(DrawLayer::Point));
        }
    }
    picture
}

/// The picture of a measurement, which fills an area.
pub(crate) fn measured_picture(area: Rect, measurement: &Measurement) -> Picture {
    let fit = &measurement.fit;
    let (state, model) = (&fit.state, &fit.model);
    let radii = measurement.given.radii.unwrap_or([0.0; 2]);
    let [low, high] = corners(measurement);
    let margin = MARGIN * low.distance(high);
    let mut picture = points_picture(area, measurement);
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
        if radii[body] > 0.0 {
            picture.ring(centre, radii[body], disc, (['1', '2'][body], centre));
        }
        let sign = ["₁", "₂"][body];
        let text = format!("v{sign} {}", track.name);
        let outwards = LabelSide::towards(state.velocity(body, Leg::After));
        picture.label(text, last.at, &outwards, after);
        if start.distance(centre) > margin {
            let outwards = LabelSide::towards(-state.velocity(body, Leg::Before));
            picture.label(format!("u{sign}"), start, &outwards, before);
        }
    }
    let known = &measurement.known;
    let along = line(state, known);
    let reach = match known.line {
        LineFrom::Centres => 1.6 * radii[0].max(radii[1]),
        LineFrom::Impulse => 1.5 * margin,
    };
    let from = state.centre(0) - reach * along;
    let to = state.centre(1) + reach * along;
    picture.line(from, to, Pen::new(Role::LineOfImpact).dotted());
    picture
}

/// The text alternative of the picture.
pub(crate) fn measured_words(measurement: &Measurement) -> String {
    let [first, second] = measurement.names();
    format!(
        "The measured points of {first} and {second} before and after their contact, the fitted \
         paths, the paths predicted from the state before the contact (dashed) and the line of \
         impact (dotted)"
    )
}

//! A plot of one column of the notebook against another, over the exact curve.

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

use super::Notebook;
use super::columns::{NotebookColumn, number};
use crate::physics::CollisionSpec;
use crate::progress::NotedHit;
use crate::widgets::input::{CollisionField, FieldValue};
use crate::widgets::picture::{Pen, Picture};
use crate::widgets::plot::{Axis, Plot};
use crate::widgets::{Charset, Look, Role};

/// The number of pieces of the curve.
const PIECES: u32 = 360;

/// The plot of the chosen columns: a point for each hit, over the exact curve, along which one
/// setting varies and the others are those of the chosen hit.
pub(super) fn picture(notebook: &Notebook, area: Rect, look: &Look) -> Picture {
    let hits = notebook.hits();
    let axes = notebook.axes();
    let point = |hit: &NotedHit| Some(dvec2(axes[0].value(hit)?, axes[1].value(hit)?));
    let chosen = notebook.chosen();
    let curve = chosen.map_or_else(Vec::new, |(_, hit)| curve(axes, &hit.setup, hits));
    let all = curve.iter().copied().chain(hits.iter().filter_map(point));
    let all: Vec<DVec2> = all.filter(|at| at.is_finite()).collect();
    let [x, y] = [0, 1].map(|axis| {
        let values = all.iter().map(|at| at[axis]);
        let (from, to) = ends(values);
        Axis::linear(axes[axis].name(), from, to)
    });
    let mut plot = Plot::new(area, *look, x, y);
    plot.curve(curve, Pen::new(Role::StrikerOut));
    let signs = match look.charset {
        Charset::Ascii => ['o', 'O'],
        Charset::Unicode => ['○', '●'],
    };
    for at in hits.iter().filter_map(point) {
        plot.mark(at, signs[0], Role::CoinOut);
    }
    if let Some(at) = chosen.and_then(|(_, hit)| point(hit)) {
        plot.mark(at, signs[1], Role::Title);
    }
    plot.picture()
}

/// The setting that is varied along the curve of two columns: a setting that one of them shows,
/// otherwise the impact angle.
pub(super) fn varied(axes: [&NotebookColumn; 2]) -> CollisionField {
    let own = axes.iter().find_map(|column| column.setting());
    own.unwrap_or(CollisionField::ImpactAngle)
}

/// The exact values of both columns while one setting varies. The other settings are those of
/// `setup`.
fn curve(axes: [&NotebookColumn; 2], setup: &CollisionSpec, hits: &[NotedHit]) -> Vec<DVec2> {
    let field = varied(axes);
    let (from, to) = range(field, setup, hits);
    let at = |i: u32| {
        let mut spec = *setup;
        let value = from + (to - from) * f64::from(i) / f64::from(PIECES);
        field.set(&mut spec, value);
        let [x, y] = axes.map(|column| column.exact(&spec).unwrap_or(f64::NAN));
        dvec2(x, y)
    };
    (0..=PIECES).map(at).collect()
}

/// The range over which the curve varies a setting: all values of an angle, an offset and e (an
/// impact angle or an offset to the left only if one of the hits has one), up to 1 for the friction
/// between the rims, and for any other setting up to 1.5 times the largest value in the hits (at
/// least 100 for a spin).
fn range(field: CollisionField, setup: &CollisionSpec, hits: &[NotedHit]) -> (f64, f64) {
    let FieldValue::Number { range, .. } = field.field(setup).value else {
        return (0.0, 0.0);
    };
    let is_left = hits.iter().any(|hit| hit.setup.offset_mm() < 0.0);
    let from_left = |most: f64| if is_left { (-most, most) } else { (0.0, most) };
    let values = hits.iter().filter_map(|hit| number(field, &hit.setup));
    let most = 1.5 * values.map(f64::abs).fold(0.0, f64::max);
    match field {
        CollisionField::ImpactAngle => from_left(90.0),
        CollisionField::Offset => from_left(setup.contact_distance_mm()),
        CollisionField::Restitution => range,
        CollisionField::Aim | CollisionField::CoinAim => (-180.0, 180.0),
        CollisionField::RimFriction => (0.0, 1.0_f64.min(range.1)),
        CollisionField::StrikerSpin | CollisionField::CoinSpin => {
            (-most.max(100.0), most.max(100.0))
        }
        _ => (range.0, most.clamp(range.0, range.1)),
    }
}

/// The limits of an axis for these values. The axis starts at 0 if all values are positive and the
/// smallest is less than 0.6 times the largest.
fn ends(values: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    let most = values.fold(f64::NEG_INFINITY, f64::max);
    if !(least.is_finite() && most.is_finite()) {
        return (0.0, 1.0);
    }
    let is_near_zero = least > 0.0 && least < 0.6 * most;
    let from = if is_near_zero { 0.0 } else { least };
    let width = most - from;
    // A constant, apart from rounding.
    if width <= 1e-6 * most.abs().max(1e-6) {
        let margin = 0.1 * most.abs().max(1.0);
        return (from - margin, most + margin);
    }
    (from, most + 0.02 * width)
}

/// The plot in sentences.
pub(super) fn in_words(notebook: &Notebook) -> Vec<String> {
    let [x, y] = notebook.axes();
    let points = notebook.hits().iter();
    let points = points.filter(|hit| [x, y].iter().all(|it| it.value(hit).is_some()));
    let (x, y, count) = (x.symbol, y.symbol, points.count());
    vec![format!(
        "A plot of {y} against {x}, with {count} points and the exact curve for the chosen hit."
    )]
}

/// The explanation of the curve, for the panel beside the plot.
pub(super) fn about_curve(notebook: &Notebook) -> String {
    let axes = notebook.axes();
    let field = varied(axes);
    let mut columns = NotebookColumn::all().iter();
    let column = columns.find(|it| it.setting() == Some(field));
    let symbol = column.map_or("α", |it| it.symbol);
    format!(
        "The line is exact. Along it only {symbol} varies; the other settings are those of the chosen hit. A \
         point with other settings may lie beside it."
    )
}

#[cfg(test)]
mod tests {
    use strum::VariantArray;

    use super::*;

    #[test]
    fn every_setting_can_be_plotted() {
        for field in CollisionField::VARIANTS {
            let column = NotebookColumn::all()
                .iter()
                .find(|it| it.setting() == Some(*field));
            assert!(column.is_some(), "{field:?}");
        }
    }

    /// Each hit lies on the curve for its own settings, whatever is plotted.
    #[test]
    fn the_curve_passes_through_the_chosen_hit() {
        let hit = |link| NotedHit::new(CollisionSpec::from_link(link).unwrap(), None);
        let hits = [
            hit("m2:5.5,b:12,e:0.8,u:3"),
            hit("b:-9,u2:1.5,dir2:30"),
            hit("m1:20,m2:40,r1:12.4,r2:15.6,b:20"),
            hit("b:11,stick:true"),
            hit("b:-13,mu:0.15,spin1:40,spin2:-20"),
        ];
        let numbers = || NotebookColumn::all().iter().filter(|it| it.is_number());
        for it in &hits {
            for x in numbers() {
                for y in numbers() {
                    let near = [x, y].map(|column| column.exact(&it.setup));
                    let [Some(at_x), Some(at_y)] = near else {
                        continue;
                    };
                    let curve = curve([x, y], &it.setup, &hits);
                    let size = |axis: usize| {
                        let (from, to) = ends(curve.iter().map(|at| at[axis]));
                        to - from
                    };
                    let size = dvec2(size(0), size(1));
                    let gap = curve.windows(2).map(|ends| {
                        let [a, b] = [ends[0], ends[1]].map(|at| (at - dvec2(at_x, at_y)) / size);
                        let along = b - a;
                        let share = (-a.dot(along) / along.length_squared()).clamp(0.0, 1.0);
                        (a + if share.is_nan() { 0.0 } else { share } * along).length()
                    });
                    let gap = gap.fold(f64::INFINITY, f64::min);
                    assert!(gap < 0.02, "{} against {}: {gap}", y.id, x.id);
                }
            }
        }
    }
}

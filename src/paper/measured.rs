//! The report on a measured collision.

use maud::html;
use ratatui::layout::Rect;

use super::{LOOK, Paper, clean, html_page, svg};
use crate::measure::Measurement;
use crate::widgets::{measured_picture, measured_rows, measured_words};

const STYLE: &str = include_str!("measured.css");
/// The size of the picture, in columns and rows.
const COLUMNS: u16 = 90;
const FEWEST_ROWS: u16 = 10;
const MOST_ROWS: u16 = 36;
/// The maximum width of a file name, in columns.
const NAME: usize = 80;

/// The report, in HTML, on a measurement made from these files.
pub fn measured_html(measurement: &Measurement, files: &[String]) -> String {
    let rows = measured_rows(COLUMNS, measurement).clamp(FEWEST_ROWS, MOST_ROWS);
    let area = Rect::new(0, 0, COLUMNS, rows);
    let picture = svg(
        &measured_words(measurement),
        &measured_picture(area, measurement),
    );
    let warnings = measurement.warnings();
    let files: Vec<_> = files.iter().map(|name| clean(name, NAME)).collect();
    let sheet = html! {
        p.dim { "carrom · a measured collision" }
        h1 { bdi { (files.join(", ")) } }
        figure {
            (picture)
            figcaption {
                "Points: the tracks. Solid lines: the fitted paths. Dashed: predicted from the state \
                 before the contact. Dotted: the line of impact."
            }
        }
        h2 { "In words" }
        ul { @for sentence in measurement.sentences() { li { (LOOK.charset.text(&sentence)) } } }
        @if !warnings.is_empty() {
            h2 { "Before you trust it" }
            ul.warn { @for warning in warnings { li { (warning) } } }
        }
        @for section in measurement.sections() {
            h2 { (section.title) }
            table {
                @for row in section.rows { tr { td { (row.name) } td { (LOOK.charset.text(&row.text)) } } }
            }
        }
        p.dim {
            "± is the 68 % interval, from the scatter of the points about the fitted paths; masses and \
             scale are taken as exact."
        }
    };
    html_page("A measured collision", STYLE, Paper::A4, [sheet])
}

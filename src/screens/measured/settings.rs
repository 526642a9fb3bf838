//! What a pupil sets after opening a file: masses, radii, the scale and the value of e for the
//! prediction.

use crate::measure::Given;
use crate::numbers::short;
use crate::physics::units::{g_from_kg, kg_from_g, m_from_mm, mm_from_m};
use crate::widgets::input::{Field, FieldRow, FieldValue, FormFields};

/// The settings, in the units of the form; 0 means that a value is not set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct MeasuredSettings {
    masses_g: [f64; 2],
    radii_mm: [f64; 2],
    scale: f64,
    restitution: f64,
}

impl MeasuredSettings {
    pub(super) fn new(given: &Given) -> Self {
        Self {
            masses_g: given.masses.map_or([0.0; 2], |both| both.map(g_from_kg)),
            radii_mm: given.radii.map_or([0.0; 2], |both| both.map(mm_from_m)),
            scale: given.scale,
            restitution: given.restitution,
        }
    }

    /// The given values after applying these settings.
    pub(super) fn given(&self, before: &Given) -> Given {
        let both = |values: [f64; 2], si: fn(f64) -> f64| {
            values.iter().all(|it| *it > 0.0).then(|| values.map(si))
        };
        Given {
            masses: both(self.masses_g, kg_from_g),
            radii: both(self.radii_mm, m_from_mm),
            scale: self.scale,
            restitution: self.restitution,
            ..*before
        }
    }
}

const MASSES: (f64, f64) = (0.0, 10_000.0);
const RADII: (f64, f64) = (0.0, 1_000.0);
const SCALES: (f64, f64) = (0.001, 1_000.0);
const OF_BOTH: &str = "Unless both masses are set, equal masses are assumed.";
const OF_RADII: &str = "If both radii are set, the line of impact is found from the centres.";
const OF_SCALE: &str = "All coordinates are multiplied by this number. For a file in pixels, set \
                        the millimetres per pixel.";

/// A value and its text. The text begins with a number even if the value is not set, so that a
/// browser page shows a number field.
fn number(value: f64, range: (f64, f64), step: f64, unit: &'static str) -> (FieldValue, String) {
    let note = if value > 0.0 { "" } else { " (not set)" };
    let shown = format!("{}{unit}{note}", short(value, 4));
    (FieldValue::number(value, range, step, unit), shown)
}

macro_rules! row {
    ($name:literal, $about:expr, $of:ident $([$body:literal])?, $range:expr, $step:literal, $unit:literal) => {
        FieldRow {
            name: $name,
            about: $about,
            now: |it| number(it.$of$([$body])?, $range, $step, $unit),
            put: |it, value| it.$of$([$body])? = value,
        }
    };
}

static ROWS: [FieldRow<MeasuredSettings>; 6] = [
    row!("mass m₁", OF_BOTH, masses_g[0], MASSES, 0.5, " g"),
    row!("mass m₂", OF_BOTH, masses_g[1], MASSES, 0.5, " g"),
    row!("radius r₁", OF_RADII, radii_mm[0], RADII, 0.5, " mm"),
    row!("radius r₂", OF_RADII, radii_mm[1], RADII, 0.5, " mm"),
    row!("scale", OF_SCALE, scale, SCALES, 0.01, ""),
    FieldRow {
        name: "predict with e",
        about: "The prediction uses this coefficient of restitution.",
        now: |it| {
            let value = FieldValue::number(it.restitution, (0.0, 1.0), 0.05, "");
            (value, short(it.restitution, 4))
        },
        put: |it, value| it.restitution = value,
    },
];

impl FormFields for MeasuredSettings {
    fn fields(&self) -> Vec<Field> {
        ROWS.iter().map(|row| row.field(self)).collect()
    }

    fn set(&mut self, at: usize, value: f64) {
        if let Some(row) = ROWS.get(at) {
            row.set(self, value);
        }
    }
}

//! The columns of the notebook.

use std::sync::LazyLock;

use crate::numbers::{fixed, tidy, true_minus};
use crate::physics::named::Quantity;
use crate::physics::{Collision, CollisionSpec};
use crate::progress::NotedHit;
use crate::quiz::Ray;
use crate::widgets::brief;
use crate::widgets::input::{CollisionField as Field, FieldValue};

/// A column of the table on the screen and of the exported one.
#[derive(Debug)]
pub(super) struct NotebookColumn {
    /// The column's heading in a file, with the unit.
    pub(super) id: &'static str,
    /// The column's heading on the screen.
    pub(super) symbol: &'static str,
    /// The column's unit on the screen; may be empty.
    pub(super) unit: &'static str,
    decimals: usize,
    pub(super) of: ColumnSource,
}

/// Where the values of a column come from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum ColumnSource {
    Setting(Field),
    /// A predicted angle, in degrees with the signs of the screen.
    Said(Ray),
    /// A true angle, in degrees with the signs of the screen.
    True(Ray),
    /// A quantity that follows from the settings.
    Result(Quantity),
}

use ColumnSource::{Result, Said, Setting, True};

/// The name in a file, the symbol and the unit; the decimals; and the source.
type ColumnRow = ([&'static str; 3], usize, ColumnSource);

/// The settings and the angles.
const COLUMNS: [ColumnRow; 19] = [
    (["b_mm", "b", "mm"], 1, Setting(Field::Offset)),
    (["alpha_deg", "α", "°"], 1, Setting(Field::ImpactAngle)),
    (["m1_g", "m₁", "g"], 1, Setting(Field::StrikerMass)),
    (["m2_g", "m₂", "g"], 1, Setting(Field::CoinMass)),
    (["e", "e", ""], 2, Setting(Field::Restitution)),
    (["contact", "contact", ""], 0, Setting(Field::Contact)),
    (["u1_m_s", "u₁", "m/s"], 2, Setting(Field::Speed)),
    (["aim_deg", "aim", "°"], 0, Setting(Field::Aim)),
    (["u2_m_s", "u₂", "m/s"], 2, Setting(Field::CoinSpeed)),
    (["aim2_deg", "aim₂", "°"], 0, Setting(Field::CoinAim)),
    (["r1_mm", "r₁", "mm"], 2, Setting(Field::StrikerRadius)),
    (["r2_mm", "r₂", "mm"], 2, Setting(Field::CoinRadius)),
    (["rim_friction", "μᵣ", ""], 2, Setting(Field::RimFriction)),
    (
        ["spin1_rad_s", "ω₁", "rad/s"],
        1,
        Setting(Field::StrikerSpin),
    ),
    (["spin2_rad_s", "ω₂", "rad/s"], 1, Setting(Field::CoinSpin)),
    (["said_theta1_deg", "said θ₁", "°"], 1, Said(Ray::Striker)),
    (["said_theta2_deg", "said θ₂", "°"], 1, Said(Ray::Target)),
    (["theta1_deg", "θ₁", "°"], 1, True(Ray::Striker)),
    (["theta2_deg", "θ₂", "°"], 1, True(Ray::Target)),
];

/// The results: the name in a file, and the name of the quantity.
const RESULTS: [(&str, &str); 16] = [
    ("v1_m_s", "v1"),
    ("v2_m_s", "v2"),
    ("separation_deg", "separation_deg"),
    ("px_before_g_m_s", "px"),
    ("py_before_g_m_s", "py"),
    ("p1x_g_m_s", "p1x"),
    ("p1y_g_m_s", "p1y"),
    ("p2x_g_m_s", "p2x"),
    ("p2y_g_m_s", "p2y"),
    ("px_after_g_m_s", "px_after"),
    ("py_after_g_m_s", "py_after"),
    ("energy_before_mj", "energy_before_mj"),
    ("energy_after_mj", "energy_after_mj"),
    ("throw_deg", "throw_deg"),
    ("spin1_after_rad_s", "spin1_after"),
    ("spin2_after_rad_s", "spin2_after"),
];

static ALL: LazyLock<Vec<NotebookColumn>> = LazyLock::new(|| {
    let columns = COLUMNS.map(|([id, symbol, unit], decimals, of)| NotebookColumn {
        id,
        symbol,
        unit,
        decimals,
        of,
    });
    let results = RESULTS.into_iter().filter_map(|(id, name)| {
        let quantity = Quantity::named(name)?;
        Some(NotebookColumn {
            id,
            symbol: quantity.symbol,
            unit: quantity.unit,
            decimals: quantity.decimals,
            of: Result(quantity),
        })
    });
    columns.into_iter().chain(results).collect()
});

impl NotebookColumn {
    /// All columns, in their order.
    pub(super) fn all() -> &'static [Self] {
        &ALL
    }

    /// The index of the column with this name in a file.
    pub(super) fn index(id: &str) -> usize {
        Self::all().iter().position(|it| it.id == id).unwrap_or(0)
    }

    /// The column with this name in a file.
    pub(super) fn named(id: &str) -> &'static Self {
        &Self::all()[Self::index(id)]
    }

    /// Whether the column has numbers that can be plotted.
    pub(super) fn is_number(&self) -> bool {
        self.of != Setting(Field::Contact)
    }

    /// The setting that the column shows, if it shows one.
    pub(super) fn setting(&self) -> Option<Field> {
        match self.of {
            Setting(field) => Some(field),
            _ => None,
        }
    }

    /// The column's symbol and unit.
    pub(super) fn name(&self) -> String {
        match self.unit {
            "" => self.symbol.to_owned(),
            unit => format!("{} ({unit})", self.symbol),
        }
    }

    /// The number in this column for a hit; `None` if the hit has none.
    pub(super) fn value(&self, hit: &NotedHit) -> Option<f64> {
        match self.of {
            Said(ray) => angle(&hit.setup.collision(), hit.said.as_ref()?.get(ray)),
            _ => self.exact(&hit.setup),
        }
    }

    /// The exact number for these settings: for a predicted angle, the true one.
    pub(super) fn exact(&self, setup: &CollisionSpec) -> Option<f64> {
        let collision = setup.collision();
        match self.of {
            // A miss has no impact angle, although the form shows it as a graze.
            Setting(Field::ImpactAngle) => Some(collision.alpha()?.to_degrees()),
            Setting(field) => number(field, setup),
            Said(ray) | True(ray) => {
                let outcome = collision.outcome();
                angle(&collision, [outcome.theta1, outcome.theta2][ray as usize])
            }
            Result(quantity) => quantity.of(&collision),
        }
    }

    /// The text for a hit on the screen.
    pub(super) fn shown(&self, hit: &NotedHit) -> String {
        match self.value(hit) {
            Some(value) => true_minus(&fixed(value, self.decimals)),
            None => self.word(hit),
        }
    }

    /// The text for a hit in a file, with all digits.
    pub(super) fn cell(&self, hit: &NotedHit) -> String {
        match self.value(hit) {
            Some(value) => (tidy(value) + 0.0).to_string(),
            None => self.word(hit),
        }
    }

    /// The text for a hit that has no number in this column.
    fn word(&self, hit: &NotedHit) -> String {
        match self.of {
            Said(_) if hit.said.is_none() => String::new(),
            Said(_) | True(_) => brief(None),
            Setting(field @ Field::Contact) => field.field(&hit.setup).shown,
            _ => String::new(),
        }
    }
}

/// The value of a setting, if it is a number.
pub(super) fn number(field: Field, setup: &CollisionSpec) -> Option<f64> {
    match field.field(setup).value {
        FieldValue::Number { value, .. } => Some(value),
        FieldValue::Choice { .. } | FieldValue::Text(_) => None,
    }
}

/// An angle in degrees with the sign that it has on the screen.
fn angle(collision: &Collision, angle: Option<f64>) -> Option<f64> {
    Some(collision.side() * angle?.to_degrees() + 0.0)
}

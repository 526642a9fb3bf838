//! The figures of a question or an answer, as JSON.

use serde_json::{Map, Value};

/// The figures of a question or an answer. Each name ends in the unit.
pub type Figures = Map<String, Value>;

/// The figures in a JSON object; any other value has none.
pub(crate) fn figures(value: Value) -> Figures {
    match value {
        Value::Object(figures) => figures,
        _ => Figures::new(),
    }
}

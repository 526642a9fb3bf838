//! The figures of a question or an answer, as JSON.

use serde_json::{Map, Value};

/// The figures of a question or an answer, by names that end in the unit.
pub type Figures = Map<String, Value>;

/// The figures in a JSON object; none in any other value.
pub(crate) fn figures(value: Value) -> Figures {
    match value {
        Value::Object(figures) => figures,
        _ => Figures::new(),
    }
}

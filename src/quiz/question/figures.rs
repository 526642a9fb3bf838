//! The figures of a question or an answer, as JSON.

use serde_json::{Map, Value};

/// The figures of a question or an answer. The name of a number ends in its unit, if it has one
/// other than m/s.
pub type Figures = Map<String, Value>;

/// The figures in a JSON object; any other value has none.
pub(crate) fn figures(value: Value) -> Figures {
    match value {
        Value::Object(figures) => figures,
        _ => Figures::new(),
    }
}

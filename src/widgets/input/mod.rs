//! Input: keys as data, and the widgets that handle them: numbers, rays, lists, forms and text.

mod collision_fields;
mod form;
mod key_table;
mod list_view;
mod number_entry;
mod number_input;
mod outcome;
mod ray_input;
mod text_field;

pub(crate) use collision_fields::{CollisionField, collision_fields, set_at};
pub(crate) use form::{Field, FieldRow, FieldValue, FormAction, FormFields, SettingsForm};
pub use key_table::{KeyRow, KeyTable, Rebound};
pub(crate) use list_view::{ListAction, ListView};
pub(crate) use number_entry::{EntryAction, NumberEntry};
pub(crate) use number_input::{NumberAction, NumberInput};
pub use outcome::Outcome;
pub(crate) use ray_input::{RayAction, RayInput, brief};
pub use ray_input::{degrees, shown};
pub use text_field::TextField;

//! What the player gives: keys as data, and the parts that take them: numbers, rays,
//! lists, forms, names.

mod collision_fields;
mod form;
mod key_table;
mod list_view;
mod number_entry;
mod number_input;
mod outcome;
mod ray_input;
mod text_field;

pub use collision_fields::{CollisionField, collision_fields, set_at};
pub use form::{Field, FieldRow, FieldValue, FormAction, FormFields, SettingsForm};
pub use key_table::{KeyAction, KeyRow, KeyTable, Rebound};
pub use list_view::{ListAction, ListView};
pub use number_entry::{EntryAction, NumberEntry};
pub use number_input::{NumberAction, NumberInput};
pub use outcome::Outcome;
pub use ray_input::{RayAction, RayInput, brief, degrees, shown};
pub use text_field::TextField;

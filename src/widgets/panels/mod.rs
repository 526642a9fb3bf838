//! Frames and their contents: a picture with a panel beside it, the facts of a collision, and
//! predictions next to the true directions.

mod heading;
mod impact_facts;
mod panel;
mod said_true;
mod split_layout;

pub(crate) use heading::Heading;
pub(crate) use impact_facts::{
    contact_distance, impact_angle, masses, offset, reason, rim_facts, separation,
};
pub(crate) use panel::draw_panel;
pub(crate) use said_true::said_and_true;
pub use split_layout::SplitLayout;

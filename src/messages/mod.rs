//! What goes into the app and what comes out of it: keys, the mouse, the size of the
//! screen; what a shell shall do, and what came of it.
//!
//! Each shell translates its own world into these types, so that the app never
//! learns which one drives it.

mod class;
mod effect;
mod input;
mod key;
mod store;

pub use crate::class::{HostCall, HostNews, LineId, OpenDoor};
pub use class::{JoinCall, JoinNews};
pub use effect::Effect;
pub use input::{Input, Mouse, MouseKind};
pub use key::Key;
pub use store::{History, Kept, KeptGame, StoreAnswer, StoreCall, StoreReply, StoreRequest};

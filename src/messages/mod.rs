//! The inputs and effects of the app: keys, the mouse and the size of the screen; requests to a
//! shell, and their results.
//!
//! Each shell translates its own events into these types, so the app does not know which
//! shell drives it.

mod class;
mod effect;
mod input;
mod key;
mod store;

pub use crate::class::{ConnectionId, HostCall, HostNews, JoinDetails};
pub use class::{JoinCall, JoinNews};
pub use effect::Effect;
pub use input::{Input, Mouse, MouseKind};
pub use key::Key;
pub use store::{
    History, Kept, KeptGame, KnownPlayer, StoreAnswer, StoreCall, StoreReply, StoreRequest,
};

//! The inputs and effects of the app: keys, mouse events and the size of the screen; requests to a
//! shell, and the results of these requests.
//!
//! Each shell translates its own events into these types, so the app does not know which
//! shell drives it.

mod class;
mod effect;
mod input;
mod key;
mod store;

pub use crate::class::{ConnectionId, HostCall, HostNews, JoinDetails, Newcomer};
pub use class::{JoinCall, JoinNews};
pub use effect::Effect;
pub use input::{Input, Mouse, MouseKind};
pub use key::Key;
pub use store::{
    FileContent, FileKind, GatheredBook, HandInFolder, History, Kept, KeptGame, KnownPlayer,
    PlayerAction, StoreAnswer, StoreCall, StoreReply, StoreRequest,
};

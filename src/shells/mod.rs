//! The shells that run the app: in a terminal, in plain lines, from a tape or in a test.
//!
//! Each shell supplies time, translates its own inputs into [`Input`](crate::messages::Input)s and
//! carries out effects. All of them drive the same [`App`](crate::app::App) in the same way: they
//! advance its time only while the app requests it, and normally in steps of at least one
//! [`FRAME`].

#[cfg(not(target_family = "wasm"))]
use std::sync::mpsc::{Receiver, RecvTimeoutError};
#[cfg(not(target_family = "wasm"))]
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

pub mod classroom;
#[cfg(not(target_family = "wasm"))]
pub mod client;
pub mod headless;
mod holder;
#[cfg(not(target_family = "wasm"))]
pub mod host;
#[cfg(not(target_family = "wasm"))]
mod outside;
#[cfg(not(target_family = "wasm"))]
mod page_file;
pub mod plain;
pub mod tape;
#[cfg(not(target_family = "wasm"))]
pub mod terminal;

pub use classroom::Classroom;
pub use headless::Headless;
pub use holder::AppHolder;
#[cfg(not(target_family = "wasm"))]
pub use page_file::{OwnFile, PageFile};

/// The shortest time between two frames: a sixtieth of a second.
pub const FRAME: Duration = Duration::from_nanos(16_666_667);

/// Locks a mutex. A poisoned lock is still usable here, because the data is always consistent.
#[cfg(not(target_family = "wasm"))]
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Waits for a message, but not longer than `patience`; `None` means for ever.
#[cfg(not(target_family = "wasm"))]
fn receive<T>(channel: &Receiver<T>, patience: Option<Duration>) -> Result<T, RecvTimeoutError> {
    match patience {
        Some(patience) => channel.recv_timeout(patience),
        None => Ok(channel.recv()?),
    }
}

//! Requests from the app to the shell that drives it.

use super::{HostCall, JoinCall, StoreCall};

/// Something that only the outside world can do.
#[derive(Debug, Clone, PartialEq)]
pub enum Effect {
    /// Read or change stored data, and return the
    /// [`StoreAnswer`](super::StoreAnswer) as an input.
    Keep(StoreCall),
    /// On the teacher's side, host a class on pupils' devices, and return what arrives as an
    /// [`Input::Hosted`](super::Input::Hosted).
    Host(HostCall),
    /// On a pupil's side, connect to such a class, and return what arrives as an
    /// [`Input::Joined`](super::Input::Joined).
    Join(JoinCall),
    /// Write text to a file of this name for the player (in a terminal, in the folder where carrom
    /// was started), and return its path as an [`Input::Exported`](super::Input::Exported). (A
    /// [`StoreRequest`](super::StoreRequest) exports to the data folder instead.)
    Export {
        /// Letters, digits, hyphens and an extension.
        name: String,
        /// The text.
        content: String,
    },
}

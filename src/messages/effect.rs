//! What the app asks of the shell that drives it.

use super::{HostCall, JoinCall, StoreCall};

/// A thing only the world outside can do.
#[derive(Debug, Clone, PartialEq)]
pub enum Effect {
    /// Leave the program.
    Quit,
    /// Do something with what is kept, and hand the
    /// [`StoreAnswer`](super::StoreAnswer) back as an input.
    Keep(StoreCall),
    /// Do something for a class on its own devices, of which this is the teacher's carrom,
    /// and hand what is heard back as an [`Input::Hosted`](super::Input::Hosted).
    Host(HostCall),
    /// Do something for a pupil of such a class, and hand what is heard back as an
    /// [`Input::Joined`](super::Input::Joined).
    Join(JoinCall),
    /// Write a text to a file of this name where the player is, in a terminal the folder
    /// it was started in, and hand back as an [`Input::Exported`](super::Input::Exported)
    /// where it is. (What a [`StoreRequest`](super::StoreRequest) exports goes to the folder for data
    /// instead, with whatever else is kept.)
    Export {
        /// The name: letters, digits, hyphens and an ending.
        name: String,
        /// The text.
        content: String,
    },
}

//! Requests from the app to the shell that drives it.

use super::{HostCall, JoinCall, StoreCall};
use crate::quiz::Code;

/// Something that only the outside world can do.
#[derive(Debug, Clone, PartialEq)]
pub enum Effect {
    /// Read or change stored data, and return the
    /// [`StoreAnswer`](super::StoreAnswer) as an input.
    Keep(StoreCall),
    /// On the teacher's side, host a class on the pupils' devices, and return the resulting events
    /// as an [`Input::Hosted`](super::Input::Hosted).
    Host(HostCall),
    /// On a pupil's side, connect to a class that is hosted in this way, and return the resulting
    /// events as an [`Input::Joined`](super::Input::Joined).
    Join(JoinCall),
    /// Write text to a file with this name for the player, and return the path of the file as an
    /// [`Input::Exported`](super::Input::Exported). In a terminal the file is in the folder where
    /// carrom was started. (A [`StoreRequest`](super::StoreRequest) exports to the data folder
    /// instead.)
    Export {
        /// The name of the file, which consists of letters, digits, hyphens and an extension.
        name: String,
        /// The content of the file.
        content: String,
    },
    /// In a terminal, write the page for browsers, including the player's own levels, chapters and
    /// questions, to a file with this name, and return an
    /// [`Input::Exported`](super::Input::Exported).
    ExportPage {
        /// The name of the file.
        name: String,
        /// If given, the file is a SCORM package that opens the round with this code.
        round: Option<Code>,
    },
}

//! A class on its own devices: what a pupil's carrom asks of whoever reaches the host, and what it
//! hears.

/// What a pupil's carrom asks of whoever reaches the host.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum JoinCall {
    /// Reach the host at this address; hang up on any other.
    Dial(String),
    /// Say this.
    Say(String),
    /// Remember what brings the pupil back there, and under which name.
    Remember {
        /// What brings them back, as text.
        seat: String,
        /// Their name.
        name: String,
        /// The code of the class.
        code: String,
    },
    /// Hang up.
    HangUp,
}

/// What a pupil's carrom hears.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum JoinNews {
    /// The host is reached.
    Reached,
    /// The host says this.
    Heard(String),
    /// The host cannot be reached, or no longer: why.
    Lost(String),
    /// What was remembered of an earlier time there: the token, and the name.
    Remembered(String, String),
    /// The device was asleep or out of sight, and is back.
    Awake,
}

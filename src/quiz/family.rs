//! The families of questions: what is asked and how it is answered.

/// A family of questions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Family {
    /// Where will the two go? Answered by two rays.
    WhereTo,
}

impl Family {
    /// All families, in the order in which they are taught.
    pub const ALL: [Self; 1] = [Self::WhereTo];

    /// Its name in files.
    pub const fn id(self) -> &'static str {
        match self {
            Self::WhereTo => "where-to",
        }
    }

    /// Its name as shown.
    pub const fn name(self) -> &'static str {
        match self {
            Self::WhereTo => "where will they go?",
        }
    }
}

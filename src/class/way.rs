//! The ways in which a class votes.

use strum::{EnumString, IntoStaticStr, VariantArray};

/// A way in which a class votes. In files, it has a name such as "devices".
///
/// - **Teams** type their votes one after the other at the teacher's keyboard. Each has its
///   own name and [`Ballot`](super::Ballot).
/// - A **tally** is for a class without devices: hands or printed cards are counted, and the
///   teacher types the number of votes for each choice. There are no names; the counts are those of
///   [`ClassRound::tally`](super::ClassRound::tally), for the choices of
///   [`ClassRound::choices`](super::ClassRound::choices).
/// - With **devices** everyone votes on their own device; people join by
///   [`ClassChange::Join`](super::ClassChange::Join), each with a name and a ballot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, EnumString, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum WayOfVoting {
    /// Teams at one keyboard.
    #[default]
    Teams,
    /// Counted hands or cards.
    Tally,
    /// Everyone votes on their own device.
    Devices,
}

impl WayOfVoting {
    /// The voters: "one team", "3 teams"; "3 of you" if each votes alone.
    pub fn voters(self, count: usize) -> String {
        match (self, count) {
            (Self::Teams, 1) => "one team".into(),
            (Self::Teams, count) => format!("{count} teams"),
            (_, 1) => "one of you".into(),
            (_, count) => format!("{count} of you"),
        }
    }

    /// The largest number of teams or people who each have a ballot.
    pub const fn most(self) -> usize {
        match self {
            Self::Teams => super::MOST_TEAMS,
            Self::Tally => 0,
            Self::Devices => super::MOST_PEOPLE,
        }
    }
}

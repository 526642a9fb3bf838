//! The families of questions by name; what they ask is declared a floor above.

use strum::{EnumString, IntoStaticStr, VariantArray};

/// A family of questions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, EnumString, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum Family {
    /// Where will the two go, whatever the pieces and the loss?
    WhereTo,
    /// Both rays from the impact angle, equal masses.
    FromAngle,
    /// Both rays from the offset, equal masses.
    FromOffset,
    /// Both rays from the picture alone, without a figure.
    FromPicture,
    /// Both rays with unequal masses.
    UnequalMasses,
    /// How fast each one leaves.
    Speeds,
    /// What corner the two ways out make.
    Separation,
    /// What share of the energy each one has after the hit.
    EnergyShare,
    /// What the coefficient of restitution does, and what it is.
    Restitution,
    /// How far a striker can be turned at most.
    LargestDeflection,
    /// A mass from what is seen after the hit.
    Weigh,
    /// Slipping with e = 0 against sticking: how the two go on.
    SlipOrStick,
    /// Two equal discs that both move: who sees 90°?
    BothMoving,
    /// Its speed, and the angle Θ by which it sees both turned.
    CentreOfMass,
    /// How many are counted at two angles.
    Rutherford,
    /// Choose the offset that sends a disc where it is to go.
    MakeItSo,
    /// The written questions, one idea each.
    Concept,
    /// Those that were written after the codes of [`Concept`](Self::Concept) were fixed.
    Ideas,
}

impl Family {
    /// All families, in the order in which they are taught.
    pub const ALL: &'static [Self] = Self::VARIANTS;

    /// Its name in files and in the codes of rounds.
    pub fn id(self) -> &'static str {
        self.into()
    }

    /// The family of an `id`.
    pub fn with_id(id: &str) -> Option<Self> {
        id.parse().ok()
    }
}

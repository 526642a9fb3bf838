//! The families of questions by name; a higher layer declares what they ask.

use strum::{EnumString, IntoStaticStr, VariantArray};

/// A family of questions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, EnumString, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum Family {
    /// Where will the two discs go, for any pieces and any loss?
    WhereTo,
    /// Both rays from the impact angle, equal masses.
    FromAngle,
    /// Both rays from the offset, equal masses.
    FromOffset,
    /// Both rays from the picture alone, without numbers.
    FromPicture,
    /// Both rays with unequal masses.
    UnequalMasses,
    /// The final speed of each disc.
    Speeds,
    /// The angle between the paths.
    Separation,
    /// What share of the energy each disc has after the collision.
    EnergyShare,
    /// The effects of the coefficient of restitution, and its value.
    Restitution,
    /// The greatest deflection of a striker.
    LargestDeflection,
    /// A mass, calculated from what can be seen after the collision.
    Weigh,
    /// Smooth rims with e = 0, compared with rims that stick: how the two move on.
    SlipOrStick,
    /// Two equal discs that both move: in which frame is the angle between their paths 90°?
    BothMoving,
    /// The speed of the centre-of-mass frame, and the scattering angle Θ in it.
    CentreOfMass,
    /// The counts at two angles.
    Rutherford,
    /// Choose the offset that sends a disc in a given direction.
    MakeItSo,
    /// The questions in words, one idea each.
    Concept,
    /// Questions in words that were written after the codes of [`Concept`](Self::Concept) were
    /// fixed.
    Ideas,
}

impl Family {
    /// All families, in the order in which they are taught.
    pub const ALL: &'static [Self] = Self::VARIANTS;

    /// Its name in files and in the codes of rounds.
    pub fn id(self) -> &'static str {
        self.into()
    }

    /// The family with this `id`.
    pub fn with_id(id: &str) -> Option<Self> {
        id.parse().ok()
    }
}

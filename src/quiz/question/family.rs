//! The names of the families of questions; a higher layer defines what each family asks.

use strum::{EnumString, IntoStaticStr, VariantArray};

/// A family of questions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, EnumString, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum Family {
    /// Both rays, for any pieces, with or without loss.
    WhereTo,
    /// Both rays from the impact angle, with equal masses.
    FromAngle,
    /// Both rays from the offset; hard questions have unequal masses.
    FromOffset,
    /// Both rays from the picture alone, without numbers.
    FromPicture,
    /// Both rays with unequal masses; easy head-on hits may also be between equal masses.
    UnequalMasses,
    /// The final speed of one of the discs.
    Speeds,
    /// The angle between the paths.
    Separation,
    /// The fraction of the energy that each disc has after the collision.
    EnergyShare,
    /// The effects of the coefficient of restitution, and how to find its value.
    Restitution,
    /// The greatest deflection of a striker.
    LargestDeflection,
    /// A mass that is calculated from what can be seen after the collision.
    Weigh,
    /// Smooth rims with e = 0, compared with rims that stick: how do the two discs move on?
    SlipOrStick,
    /// Two equal discs that are both moving: in which frame is the angle between their paths 90°?
    BothMoving,
    /// The speed of the centre-of-mass frame, and the scattering angle Θ in it.
    CentreOfMass,
    /// The counts of scattered particles at two angles.
    Rutherford,
    /// The offset that sends a disc in a given direction.
    MakeItSo,
    /// Questions in words, each about one idea.
    Concept,
    /// Questions in words that were written after the codes with [`Concept`](Self::Concept) were
    /// fixed.
    Ideas,
}

impl Family {
    /// All families, in the order in which they are taught.
    pub const ALL: &'static [Self] = Self::VARIANTS;

    /// The name in files and in the codes of rounds.
    pub fn id(self) -> &'static str {
        self.into()
    }

    /// The family with this `id`.
    pub fn with_id(id: &str) -> Option<Self> {
        id.parse().ok()
    }
}

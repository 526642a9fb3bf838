//! The families of questions: what is asked and how it is answered.

use super::dice::Dice;
use super::{Difficulty, Question, families};

/// A family of questions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
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
}

/// How many draws a question may take before a family is given up: a guard against a
/// family that has nothing clear to ask. A test sees that none needs a twentieth of it.
const DRAWS: usize = 20_000;

impl Family {
    /// All families, in the order in which they are taught.
    pub const ALL: [Self; 17] = [
        Self::WhereTo,
        Self::FromAngle,
        Self::FromOffset,
        Self::FromPicture,
        Self::UnequalMasses,
        Self::Speeds,
        Self::Separation,
        Self::EnergyShare,
        Self::Restitution,
        Self::LargestDeflection,
        Self::Weigh,
        Self::SlipOrStick,
        Self::BothMoving,
        Self::CentreOfMass,
        Self::Rutherford,
        Self::MakeItSo,
        Self::Concept,
    ];

    /// Its name in files and in the codes of rounds.
    pub const fn id(self) -> &'static str {
        match self {
            Self::WhereTo => "where-to",
            Self::FromAngle => "from-angle",
            Self::FromOffset => "from-offset",
            Self::FromPicture => "from-picture",
            Self::UnequalMasses => "unequal-masses",
            Self::Speeds => "speeds",
            Self::Separation => "separation",
            Self::EnergyShare => "energy-share",
            Self::Restitution => "restitution",
            Self::LargestDeflection => "largest-deflection",
            Self::Weigh => "weigh",
            Self::SlipOrStick => "slip-or-stick",
            Self::BothMoving => "both-moving",
            Self::CentreOfMass => "centre-of-mass",
            Self::Rutherford => "rutherford",
            Self::MakeItSo => "make-it-so",
            Self::Concept => "concept",
        }
    }

    /// Its name as shown.
    pub const fn name(self) -> &'static str {
        match self {
            Self::WhereTo => "where will they go?",
            Self::FromAngle => "angles from the angle",
            Self::FromOffset => "angles from the offset",
            Self::FromPicture => "from the picture alone",
            Self::UnequalMasses => "unequal masses",
            Self::Speeds => "speeds after the hit",
            Self::Separation => "more or less than 90°?",
            Self::EnergyShare => "shares of energy",
            Self::Restitution => "what e does",
            Self::LargestDeflection => "the most it can be turned",
            Self::Weigh => "weighing by angles",
            Self::SlipOrStick => "slip or stick",
            Self::BothMoving => "both moving",
            Self::CentreOfMass => "the centre of mass",
            Self::Rutherford => "Rutherford's counts",
            Self::MakeItSo => "make it so",
            Self::Concept => "ideas in words",
        }
    }

    /// The family of an `id`.
    pub fn with_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|family| family.id() == id)
    }

    /// A question of this family that is clear, with the draws it took. The same dice
    /// always bring the same question: the draws of a family are part of the format of
    /// a round's code. `None` only where a family has nothing clear to ask.
    pub fn ask(self, difficulty: Difficulty, dice: &mut Dice) -> Option<(Question, usize)> {
        (1..=DRAWS).find_map(|draws| {
            let question = self.draw(difficulty, dice)?;
            question.is_clear().then_some((question, draws))
        })
    }

    /// One draw, clear or not; `None` where the figures drawn make no question.
    fn draw(self, difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
        match self {
            Self::WhereTo => families::where_to::ask(difficulty, dice),
            Self::FromAngle => families::from_angle::ask(difficulty, dice),
            Self::FromOffset => families::from_offset::ask(difficulty, dice),
            Self::FromPicture => families::from_picture::ask(difficulty, dice),
            Self::UnequalMasses => families::unequal_masses::ask(difficulty, dice),
            Self::Speeds => families::speeds::ask(difficulty, dice),
            Self::Separation => families::separation::ask(difficulty, dice),
            Self::EnergyShare => families::energy_share::ask(difficulty, dice),
            Self::Restitution => families::restitution::ask(difficulty, dice),
            Self::LargestDeflection => families::largest_deflection::ask(difficulty, dice),
            Self::Weigh => families::weigh::ask(difficulty, dice),
            Self::SlipOrStick => families::slip_or_stick::ask(difficulty, dice),
            Self::BothMoving => families::both_moving::ask(difficulty, dice),
            Self::CentreOfMass => families::centre_of_mass::ask(difficulty, dice),
            Self::Rutherford => families::rutherford::ask(difficulty, dice),
            Self::MakeItSo => families::make_it_so::ask(difficulty, dice),
            Self::Concept => families::concept::ask(difficulty, dice),
        }
    }
}

//! The names of the misconceptions; a higher layer defines their predictions and the feedback.

use strum::{EnumString, IntoStaticStr, VariantArray};

/// A misconception that students may have. The first misconceptions are about the directions of
/// both discs. The others affect other answers (a speed, a fraction, a ratio, a choice in words).
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumString, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum Misconception {
    /// The scattering angle is assumed to be the impact angle.
    CopiedAngle,
    /// The 90° rule for equal masses is applied to all masses.
    AlwaysSquare,
    /// The two discs are assumed to leave at 45° each.
    HalfAndHalf,
    /// The angles of striker and target are swapped.
    Swapped,
    /// The heavier disc is assumed to move on, or to stay at rest, as if there were no collision.
    HeavyUnmoved,
    /// The striker is assumed to keep its direction, although it is not the heavier one
    /// (otherwise this is [`HeavyUnmoved`](Self::HeavyUnmoved)).
    StraightOn,
    /// The target is assumed to be pushed along the striker's path, not along the line of
    /// impact.
    PushedAhead,
    /// The striker is assumed to follow the target to the same side.
    SameSide,
    /// Both angles are right, but each is on the wrong side.
    SidesExchanged,
    /// The striker is assumed to rebound from the target as from a wall.
    OffAWall,
    /// α is assumed to be 90° · b / (r₁ + r₂), although sin α is b / (r₁ + r₂).
    OffsetAsAngle,
    /// e is assumed to be 1, although it is less. With equal masses this means "always 90°".
    Lossless,
    /// The striker is assumed to stop in a head-on collision, as it does with equal masses.
    AlwaysStops,
    /// Momenta in different directions are added as plain numbers.
    ScalarMomentum,
    /// The final speeds are assumed to add up to the original speed.
    SpeedsAdd,
    /// Momentum is assumed to be lost along with the energy.
    MomentumLost,
    /// Momentum is assumed to be conserved for each body by itself.
    EachKeepsMomentum,
    /// Momentum is assumed to be conserved only if something still moves afterwards.
    GoneAtRest,
    /// Momentum and kinetic energy are assumed to be the same quantity.
    MomentumAsEnergy,
    /// Kinetic energy is given a direction and components.
    EnergyComponents,
    /// Bodies that stay together are assumed to exert a larger impulse than bodies that rebound.
    StickingHitsHarder,
    /// The forces of the two discs on each other are assumed to differ.
    HeavierPushesHarder,
    /// The head-on formula is used with the whole velocity.
    OneLineFormula,
    /// Sine and cosine are swapped.
    SineCosine,
    /// The angles are assumed to depend on the speed.
    SpeedOpensAngle,
    /// Energy is assumed to be proportional to speed.
    EnergyAsSpeed,
    /// The heavier disc is assumed to get more energy.
    HeavyTakesEnergy,
    /// All angles, or all offsets, are assumed to be equally likely.
    EveryAngleAlike,
    /// A ratio is inverted, or the two masses are swapped in a formula.
    UpsideDown,
    /// A heavier striker is assumed to rebound, and a lighter one to follow the target.
    HeavyRebounds,
    /// More particles are expected at the larger of two angles.
    CountsReversed,
    /// An inverse proportion is assumed to be a direct proportion.
    DirectForInverse,
    /// The deflection of a heavier striker is assumed to have no limit.
    BeyondLargest,
    /// The whole velocity is multiplied by e.
    LossOnEverything,
    /// e is assumed to be the fraction of the energy that is left.
    EAsEnergy,
    /// A loss is assumed to make the angle between the paths larger.
    LossOpensAngle,
    /// A right angle is assumed to be impossible with a loss.
    LossForbidsSquare,
    /// Friction at the contact is assumed to have no effect.
    GripIgnored,
    /// At e = 0 smooth rims are assumed to stop all tangential motion.
    GripStopsAll,
    /// An angle in one frame is used in another frame.
    FramesMixed,
    /// The frame's velocity is subtracted where it must be added.
    FrameReversed,
    /// The centre of mass is assumed to be halfway between the discs, whatever the masses.
    HalfwayCentre,
    /// The right angle is assumed to hold in the laboratory frame, even though both discs are
    /// moving.
    SquareOnTheGround,
    /// The whole angle is used instead of half the angle.
    HalfAngleForgotten,
    /// The count is assumed to decrease with the angle as 1/sin²(Θ/2), which is slower than
    /// the true 1/sin⁴(Θ/2).
    TooGentle,
    /// It is assumed that nothing heavy or fast ever bounces back.
    NeverBack,
    /// The rules for a target at rest are used even though the target is moving.
    CoinAtRest,
    /// The impact angle is subtracted once instead of twice.
    DoubleAngleForgotten,
    /// The larger force is assumed to have the larger impulse, whatever its duration.
    ForceAsImpulse,
    /// The longer contact is assumed to have the larger impulse, whatever the force.
    TimeAsImpulse,
    /// Friction with the board is assumed to change the momentum noticeably during a contact.
    FrictionInContact,
    /// A perfectly inelastic collision is assumed to lose all of the kinetic energy.
    AllEnergyLost,
    /// Two bodies that coalesce are assumed to move on halfway between their paths.
    HalfwayDirection,
    /// Kinetic energy is assumed to be conserved while two bodies coalesce, as bullet and block do
    /// in a ballistic pendulum.
    EnergyThroughImpact,
    /// An explosion is assumed to produce momentum.
    MomentumFromExplosion,
    /// The loss of energy is assumed to depend on the frame.
    LossByFrame,
    /// The reduced mass is assumed to be between the two masses.
    ReducedAsMean,
    /// Friction is assumed only to slow things down and never to change a direction.
    FrictionOnlySlows,
    /// Discs that do not spin before the collision are assumed not to spin afterwards.
    NoSpinFromRest,
    /// A careful measurement is assumed to give the true value.
    CarefulIsExact,
    /// A measured value that differs from the expected value is assumed to disprove it, whatever
    /// the uncertainty.
    AnyDifferenceDisproves,
    /// More points are assumed to remove an error that all points share.
    FramesCureScale,
    /// A wrong scale is assumed to change angles and ratios, too.
    ScaleTurnsAngles,
}

impl Misconception {
    /// All misconceptions.
    pub const ALL: &'static [Self] = Self::VARIANTS;

    /// The most common misconceptions. At first, the round that finds out a student's beliefs takes
    /// these to be more likely than the others.
    pub const COMMON: [Self; 7] = [
        Self::CopiedAngle,
        Self::AlwaysSquare,
        Self::HalfAndHalf,
        Self::Swapped,
        Self::HeavyUnmoved,
        Self::OneLineFormula,
        Self::FramesMixed,
    ];

    /// For the codes of rounds, the misconception that this one counts as, so that a code still
    /// gives the same questions even though `upside-down` has been split; `None` for misconceptions
    /// that were added later.
    pub fn in_codes(self) -> Option<Self> {
        match self {
            Self::HeavyRebounds
            | Self::CountsReversed
            | Self::DirectForInverse
            | Self::LossOpensAngle
            | Self::FrameReversed => Some(Self::UpsideDown),
            Self::EachKeepsMomentum
            | Self::GoneAtRest
            | Self::MomentumAsEnergy
            | Self::EnergyComponents
            | Self::StickingHitsHarder
            | Self::ForceAsImpulse
            | Self::TimeAsImpulse
            | Self::FrictionInContact
            | Self::AllEnergyLost
            | Self::HalfwayDirection
            | Self::EnergyThroughImpact
            | Self::MomentumFromExplosion
            | Self::LossByFrame
            | Self::ReducedAsMean
            | Self::FrictionOnlySlows
            | Self::NoSpinFromRest
            | Self::CarefulIsExact
            | Self::AnyDifferenceDisproves
            | Self::FramesCureScale
            | Self::ScaleTurnsAngles => None,
            _ => Some(self),
        }
    }

    /// Whether this is `other`, or one of the misconceptions into which `other` was split later.
    pub(crate) fn is_part_of(self, other: Self) -> bool {
        self == other || self.in_codes() == Some(other)
    }

    /// The name in files.
    pub fn id(self) -> &'static str {
        self.into()
    }

    /// The misconception with this `id`; ids used by earlier versions are still valid.
    pub fn with_id(id: &str) -> Option<Self> {
        match id {
            "linear-offset" => Some(Self::OffsetAsAngle),
            id => id.parse().ok(),
        }
    }
}

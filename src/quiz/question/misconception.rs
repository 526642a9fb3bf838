//! What students may believe, by name; what each predicts and is told is declared a
//! floor above.

use strum::{EnumString, IntoStaticStr, VariantArray};

/// Something students may believe. First those that say where both discs of a hit
/// will go; then those that show in something else (a speed, a share, a ratio, a choice of
/// words), in the order in which their subjects are taught.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumString, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "kebab-case")]
pub enum Misconception {
    /// The scattering angle is taken to be the impact angle.
    CopiedAngle,
    /// The right angle of equal masses is taken to hold for all.
    AlwaysSquare,
    /// The two are taken to share a right angle evenly.
    HalfAndHalf,
    /// The striker's angle is given to the target and the target's to the striker.
    Swapped,
    /// The heavier disc is taken to go on, or to lie, as if nothing had hit it.
    HeavyUnmoved,
    /// The striker is taken to keep its direction, though it is not the heavier one
    /// (that is another belief).
    StraightOn,
    /// The target is taken to be pushed along the striker's path, not along the line of
    /// impact.
    PushedAhead,
    /// The striker is taken to be drawn after the target.
    SameSide,
    /// Both angles right, each to the wrong side.
    SidesExchanged,
    /// The target is taken to throw the striker back as a wall would.
    OffAWall,
    /// α is taken to be 90° · b / (r₁ + r₂), where it is the sine that is b / (r₁ + r₂).
    OffsetAsAngle,
    /// e < 1 is taken for e = 1. With equal masses that is "always 90°".
    Lossless,
    /// What equal masses do head-on is taken to hold for all.
    AlwaysStops,
    /// Momenta of different directions added like plain numbers.
    ScalarMomentum,
    /// Speeds taken to add up to the speed before.
    SpeedsAdd,
    /// Momentum taken to be lost with the energy.
    MomentumLost,
    /// Momentum taken to be conserved for each body by itself.
    EachKeepsMomentum,
    /// Momentum taken to be conserved only if something still moves afterwards.
    GoneAtRest,
    /// Momentum and kinetic energy taken for one quantity.
    MomentumAsEnergy,
    /// Kinetic energy given a direction and components.
    EnergyComponents,
    /// Bodies that stay together taken to exert the larger impulse.
    StickingHitsHarder,
    /// The two forces of a hit taken to differ.
    HeavierPushesHarder,
    /// The formula for a head-on hit used on the whole velocity.
    OneLineFormula,
    /// Sine and cosine exchanged.
    SineCosine,
    /// Angles taken to depend on how fast the hit is.
    SpeedOpensAngle,
    /// Energy taken in proportion to speed.
    EnergyAsSpeed,
    /// The heavier disc taken to have the more energy.
    HeavyTakesEnergy,
    /// All angles, or all offsets, taken to do alike.
    EveryAngleAlike,
    /// A ratio inverted, or the two masses swapped in a formula.
    UpsideDown,
    /// The heavier striker is taken to rebound and the lighter one to go on.
    HeavyRebounds,
    /// The larger angle taken to have the larger count.
    CountsReversed,
    /// An inverse proportion taken for a direct one.
    DirectForInverse,
    /// No limit to how far a heavier striker can be turned.
    BeyondLargest,
    /// e taken off the whole velocity.
    LossOnEverything,
    /// e taken as the share of energy that is kept.
    EAsEnergy,
    /// A loss taken to make the angle between the paths larger.
    LossOpensAngle,
    /// A right angle taken to be impossible with loss.
    LossForbidsSquare,
    /// Grip at the contact taken to do nothing.
    GripIgnored,
    /// Grip at the contact taken to stop all motion across it.
    GripStopsAll,
    /// An angle of one frame read in another.
    FramesMixed,
    /// The frame's velocity subtracted where it must be added.
    FrameReversed,
    /// The centre of mass taken halfway, whatever the masses.
    HalfwayCentre,
    /// The right angle looked for on the ground although both move.
    SquareOnTheGround,
    /// The whole angle used where its half belongs.
    HalfAngleForgotten,
    /// A law falling too gently: a square where the fourth power belongs.
    TooGentle,
    /// Nothing heavy or fast taken ever to come back.
    NeverBack,
    /// The rules for a target at rest used although it moves.
    CoinAtRest,
    /// An angle turned by the impact angle where it is turned by twice as much.
    DoubleAngleForgotten,
}

impl Misconception {
    /// All of them.
    pub const ALL: &'static [Self] = Self::VARIANTS;

    /// Those that most students bring along; questions that find out what one believes look
    /// for them first.
    pub const COMMON: [Self; 7] = [
        Self::CopiedAngle,
        Self::AlwaysSquare,
        Self::HalfAndHalf,
        Self::Swapped,
        Self::HeavyUnmoved,
        Self::OneLineFormula,
        Self::FramesMixed,
    ];

    /// Which misconception the codes of rounds count this one as, so that a code still brings the
    /// same questions although `upside-down` was split; `None` for those added later.
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
            | Self::StickingHitsHarder => None,
            _ => Some(self),
        }
    }

    /// Its name in files.
    pub fn id(self) -> &'static str {
        self.into()
    }

    /// The misconception of an `id`; ids of former versions have theirs for ever.
    pub fn with_id(id: &str) -> Option<Self> {
        match id {
            "linear-offset" => Some(Self::OffsetAsAngle),
            id => id.parse().ok(),
        }
    }
}

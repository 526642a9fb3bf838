//! The misconceptions in words: what each is called, and what to try against it.

use crate::quiz::question::Misconception;

impl Misconception {
    /// Its name as shown: "the angle was copied".
    pub const fn name(self) -> &'static str {
        self.words().0
    }

    /// What to try next against it.
    pub const fn advice(self) -> &'static str {
        self.words().1
    }

    /// Its name, and what to try next against it.
    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::CopiedAngle => (
                "the angle was copied",
                "In the lab, change the offset step by step and watch both angles: as the coin's \
                 grows, the striker's shrinks.",
            ),
            Self::AlwaysSquare => (
                "always 90°",
                "In the lab, hit off-centre with equal masses: 90°. Then change one mass or e and \
                 watch the angle grow or shrink.",
            ),
            Self::HalfAndHalf => (
                "half and half",
                "In the lab, move the offset from 0 to a graze: equal pieces share evenly at one \
                 offset only.",
            ),
            Self::Swapped => (
                "the two were swapped",
                "Before you answer, find the line through the two centres: it is the coin's way \
                 out.",
            ),
            Self::HeavyUnmoved => (
                "the heavier is not moved",
                "In the lab, make one piece ten times as heavy as the other and look closely: it \
                 still turns, a little.",
            ),
            Self::StraightOn => (
                "the striker goes straight on",
                "In the lab, watch the striker alone: only a hit that barely grazes leaves it on \
                 its path.",
            ),
            Self::PushedAhead => (
                "pushed straight ahead",
                "In the lab, switch on the line of impact and see the coin leave along it every \
                 time.",
            ),
            Self::SameSide => (
                "both to one side",
                "Before you answer, ask what moves sideways before the hit. Nothing: so afterwards \
                 the two must balance.",
            ),
            Self::SidesExchanged => (
                "left and right exchanged",
                "Look along the striker's path, as if you were riding on it, and say first on \
                 which side the coin lies.",
            ),
            Self::OffAWall => (
                "bounced as off a wall",
                "In the lab, make the target heavier and heavier: only then does the striker \
                 bounce as off a wall.",
            ),
            Self::OffsetAsAngle => (
                "the offset read as an angle",
                "In the lab, set half the largest offset and read the impact angle: 30°, not 45°.",
            ),
            Self::Lossless => (
                "the loss was forgotten",
                "In the lab, turn e down from 1 and watch the striker's ray alone.",
            ),
            Self::AlwaysStops => (
                "the striker always stops",
                "In the lab, hit head-on with a heavier striker and then with a lighter one.",
            ),
            Self::ScalarMomentum => (
                "momentum added like plain numbers",
                "In the lab, switch on the triangle: two arrows add tip to tail, and their lengths \
                 do not.",
            ),
            Self::SpeedsAdd => (
                "speeds shared out like a sum",
                "In the lab, read both speeds after a hit at 45° and add them: the sum is more \
                 than there was before.",
            ),
            Self::MomentumLost => (
                "momentum lost with the energy",
                "In the lab, turn e down and watch the momentum in the numbers: it does not \
                 change.",
            ),
            Self::HeavierPushesHarder => (
                "the heavier pushes harder",
                "Think of two skaters who push off each other: one push, two ends, and the lighter \
                 one gains more speed from it.",
            ),
            Self::OneLineFormula => (
                "the head-on formula at an angle",
                "Split the velocity along the line of impact first. The head-on formula is for \
                 that part alone.",
            ),
            Self::SineCosine => (
                "sine and cosine exchanged",
                "Try the limits: head-on, at 0°, the coin takes all. The cosine is the one that is \
                 1 there.",
            ),
            Self::SpeedOpensAngle => (
                "angles that depend on the speed",
                "In the lab, change the speed alone and watch the angles: they stay as they are.",
            ),
            Self::EnergyAsSpeed => (
                "energy taken as speed",
                "Half the speed is a quarter of the energy: square the share before you answer.",
            ),
            Self::HeavyTakesEnergy => (
                "energy shared out by mass",
                "In the lab, hit head-on with a heavier and heavier coin, and watch the share it \
                 takes: it is largest when the masses are equal.",
            ),
            Self::EveryAngleAlike => (
                "all angles equally likely",
                "In the foil, throw a beam at the discs and watch which angles fill up first.",
            ),
            Self::UpsideDown => (
                "a ratio turned upside down",
                "Before you work it out, say in words which of the two is the larger, and check \
                 the answer against it.",
            ),
            Self::BeyondLargest => (
                "no limit for the heavier striker",
                "In the lab, take the 15 g striker on the 5.5 g coin and try to turn it by 30°: no \
                 offset does it.",
            ),
            Self::LossOnEverything => (
                "the loss taken off everything",
                "In the lab, turn e down and watch the part across the line of impact: it stays as \
                 it was.",
            ),
            Self::EAsEnergy => (
                "e taken as a share of energy",
                "e compares speeds of parting and of meeting. Energy goes with the square, and \
                 only a part of it is at stake.",
            ),
            Self::LossForbidsSquare => (
                "with loss never 90°",
                "In the lab, take a striker half as heavy as the coin, e = 0.5, and look at the \
                 angle between the paths.",
            ),
            Self::GripIgnored => (
                "grip at the contact forgotten",
                "In the lab, let the two stick and compare with e = 0: sticking takes the motion \
                 across the line too.",
            ),
            Self::GripStopsAll => (
                "slipping taken as sticking",
                "In the lab, set e = 0 without sticking: the striker still slides off along the \
                 tangent.",
            ),
            Self::FramesMixed => (
                "an angle of another frame",
                "In the lab, press f to change the frame of the same hit, and watch which angles \
                 change.",
            ),
            Self::HalfwayCentre => (
                "the centre of mass taken halfway",
                "The centre of mass lies nearer the heavier disc, and moves more like it.",
            ),
            Self::SquareOnTheGround => (
                "90° looked for on the board",
                "In the lab, let both move and press f until you ride with the coin: seen from \
                 there, they part at 90°.",
            ),
            Self::HalfAngleForgotten => (
                "the angle not halved",
                "The law has half the angle in it: at 180° the sine of the half is 1, and the \
                 count is smallest.",
            ),
            Self::TooGentle => (
                "a square for the fourth power",
                "In the foil, look at the counts on a small screen: at half of a small angle \
                 there are not four times as many, but about sixteen.",
            ),
            Self::NeverBack => (
                "nothing ever comes back",
                "In the foil, aim one particle straight at the centre: it stops, and goes back \
                 the way it came.",
            ),
            Self::DoubleAngleForgotten => (
                "the angle not doubled",
                "Off a wall a ball turns by 180° less twice the angle: once on the way in, once on \
                 the way out.",
            ),
        }
    }
}

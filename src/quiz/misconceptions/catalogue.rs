//! The misconceptions in words: what each is called, what to try against it, and the page
//! of a chapter that settles it.

use crate::quiz::question::{Misconception, Passage};

impl Misconception {
    /// Its name as shown: "the angle was copied".
    pub const fn name(self) -> &'static str {
        self.entry().0
    }

    /// What to try next against it.
    pub const fn advice(self) -> &'static str {
        self.entry().1
    }

    /// The page of a chapter that settles it.
    pub const fn settled_by(self) -> Passage {
        self.entry().2
    }

    /// Its name, what to try next against it, and the page that settles it.
    const fn entry(self) -> (&'static str, &'static str, Passage) {
        match self {
            Self::CopiedAngle => (
                "the angle was copied",
                "In the lab, change the offset step by step and watch both angles: as the coin's \
                 grows, the striker's shrinks.",
                page("five-confusions", "Two: how far is it turned?"),
            ),
            Self::AlwaysSquare => (
                "always 90°",
                "In the lab, hit off-centre with equal masses: 90°. Then change one mass or e and \
                 watch the angle grow or shrink.",
                page("five-confusions", "Five: always square?"),
            ),
            Self::HalfAndHalf => (
                "half and half",
                "In the lab, move the offset from 0 to a graze: equal pieces share evenly at one \
                 offset only.",
                page("speeds-and-angles", "Which way?"),
            ),
            Self::Swapped => (
                "the two were swapped",
                "Before you answer, find the line through the two centres: it is the coin's way \
                 out.",
                page("the-line-of-impact", "What can"),
            ),
            Self::HeavyUnmoved => (
                "the heavier is not moved",
                "In the lab, make one piece ten times as heavy as the other and look closely: it \
                 still turns, a little.",
                page("marbles", "Heavy on light"),
            ),
            Self::StraightOn => (
                "the striker goes straight on",
                "In the lab, watch the striker alone: only a hit that barely grazes leaves it on \
                 its path.",
                page("the-line-of-impact", "What can"),
            ),
            Self::PushedAhead => (
                "pushed straight ahead",
                "In the lab, switch on the line of impact and see the coin leave along it every \
                 time.",
                page("five-confusions", "One: which way does it push?"),
            ),
            Self::SameSide => (
                "both to one side",
                "Before you answer, ask what moves sideways before the hit. Nothing: so afterwards \
                 the two must balance.",
                page("momentum-is-a-vector", "Now off-centre"),
            ),
            Self::SidesExchanged => (
                "left and right exchanged",
                "Look along the striker's path, as if you were riding on it, and say first on \
                 which side the coin lies.",
                page("the-line-of-impact", "Where can they push?"),
            ),
            Self::OffAWall => (
                "bounced as off a wall",
                "In the lab, make the target heavier and heavier: only then does the striker \
                 bounce as off a wall.",
                page("five-confusions", "Two: how far is it turned?"),
            ),
            Self::OffsetAsAngle => (
                "the offset read as an angle",
                "In the lab, set half the largest offset and read the impact angle: 30°, not 45°.",
                page("the-impact-parameter", "How far off-centre"),
            ),
            Self::Lossless => (
                "the loss was forgotten",
                "In the lab, turn e down from 1 and watch the striker's ray alone.",
                page("when-energy-is-lost", "What becomes of the right angle?"),
            ),
            Self::AlwaysStops => (
                "the striker always stops",
                "In the lab, hit head-on with a heavier striker and then with a lighter one.",
                page("marbles", "Along n"),
            ),
            Self::ScalarMomentum => (
                "momentum added like plain numbers",
                "In the lab, switch on the triangle: two arrows add tip to tail, and their lengths \
                 do not.",
                page("momentum-is-a-vector", "And along x"),
            ),
            Self::SpeedsAdd => (
                "speeds shared out like a sum",
                "In the lab, read both speeds after a hit at 45° and add them: the sum is more \
                 than there was before.",
                page("speeds-and-angles", "The other coin"),
            ),
            Self::MomentumLost => (
                "momentum lost with the energy",
                "In the lab, turn e down and watch the momentum in the numbers: it does not \
                 change.",
                page("when-energy-is-lost", "How springy is a hit?"),
            ),
            Self::HeavierPushesHarder => (
                "the heavier pushes harder",
                "Think of two skaters who push off each other: one push, two ends, and the lighter \
                 one gains more speed from it.",
                page("the-line-of-impact", "Where can they push?"),
            ),
            Self::OneLineFormula => (
                "the head-on formula at an angle",
                "Split the velocity along the line of impact first. The head-on formula is for \
                 that part alone.",
                page("five-confusions", "Three: new formulas?"),
            ),
            Self::SineCosine => (
                "sine and cosine exchanged",
                "Try the limits: head-on, at 0°, the coin takes all. The cosine is the one that is \
                 1 there.",
                page("speeds-and-angles", "From full to thin"),
            ),
            Self::SpeedOpensAngle => (
                "angles that depend on the speed",
                "In the lab, change the speed alone and watch the angles: they stay as they are.",
                page("the-impact-parameter", "The same aim, only faster"),
            ),
            Self::EnergyAsSpeed => (
                "energy taken as speed",
                "Half the speed is a quarter of the energy: square the share before you answer.",
                page("speeds-and-angles", "A share of the energy"),
            ),
            Self::HeavyTakesEnergy => (
                "energy shared out by mass",
                "In the lab, hit head-on with a heavier and heavier coin, and watch the share it \
                 takes: it is largest when the masses are equal.",
                page("speeds-and-angles", "The split of energy"),
            ),
            Self::EveryAngleAlike => (
                "all angles equally likely",
                "In the foil, throw a beam at the discs and watch which angles fill up first.",
                page("to-the-atom", "Shots without aiming"),
            ),
            Self::UpsideDown => (
                "a ratio turned upside down",
                "Before you work it out, say in words which of the two is the larger, and check \
                 the answer against it.",
                page("weighing-by-angle", "From two angles to a mass"),
            ),
            Self::BeyondLargest => (
                "no limit for the heavier striker",
                "In the lab, take the 15 g striker on the 5.5 g coin and try to turn it by 30°: no \
                 offset does it.",
                page("the-impact-parameter", "No sharper than this"),
            ),
            Self::LossOnEverything => (
                "the loss taken off everything",
                "In the lab, turn e down and watch the part across the line of impact: it stays as \
                 it was.",
                page("when-energy-is-lost", "As soft as can be"),
            ),
            Self::EAsEnergy => (
                "e taken as a share of energy",
                "e compares speeds of parting and of meeting. Energy goes with the square, and \
                 only a part of it is at stake.",
                page("when-energy-is-lost", "How springy is a hit?"),
            ),
            Self::LossForbidsSquare => (
                "with loss never 90°",
                "In the lab, take a striker half as heavy as the coin, e = 0.5, and look at the \
                 angle between the paths.",
                page("when-energy-is-lost", "Another pair gets it"),
            ),
            Self::GripIgnored => (
                "grip at the contact forgotten",
                "In the lab, let the two stick and compare with e = 0: sticking takes the motion \
                 across the line too.",
                page("when-energy-is-lost", "Glued"),
            ),
            Self::GripStopsAll => (
                "slipping taken as sticking",
                "In the lab, set e = 0 without sticking: the striker still slides off along the \
                 tangent.",
                page("when-energy-is-lost", "As soft as can be"),
            ),
            Self::FramesMixed => (
                "an angle of another frame",
                "In the lab, press f to change the frame of the same hit, and watch which angles \
                 change.",
                page("five-confusions", "Where the right angle hides"),
            ),
            Self::HalfwayCentre => (
                "the centre of mass taken halfway",
                "The centre of mass lies nearer the heavier disc, and moves more like it.",
                page("the-centre-of-mass", "Where nothing seems to move"),
            ),
            Self::SquareOnTheGround => (
                "90° looked for on the board",
                "In the lab, let both move and press f until you ride with the coin: seen from \
                 there, they part at 90°.",
                page("five-confusions", "Five, on the move"),
            ),
            Self::HalfAngleForgotten => (
                "the angle not halved",
                "The law has half the angle in it: at 180° the sine of the half is 1, and the \
                 count is smallest.",
                page("to-the-atom", "How many, and where"),
            ),
            Self::TooGentle => (
                "a square for the fourth power",
                "In the foil, look at the counts on a small screen: at half of a small angle \
                 there are not four times as many, but about sixteen.",
                page("to-the-atom", "How many, and where"),
            ),
            Self::NeverBack => (
                "nothing ever comes back",
                "In the foil, aim one particle straight at the centre: it stops, and goes back \
                 the way it came.",
                page("to-the-atom", "One in 8000"),
            ),
            Self::CoinAtRest => (
                "a moving coin taken to be at rest",
                "In the lab, let both move and press f until you ride with the coin: there, and \
                 only there, it is at rest before the hit.",
                page("five-confusions", "Five, on the move"),
            ),
            Self::DoubleAngleForgotten => (
                "the angle not doubled",
                "Off a wall a ball turns by 180° less twice the angle: once on the way in, once on \
                 the way out.",
                page("the-centre-of-mass", "One turn for both"),
            ),
        }
    }
}

/// A page of the program's own chapters.
const fn page(chapter: &'static str, page: &'static str) -> Passage {
    Passage { chapter, page }
}

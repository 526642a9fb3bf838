//! The misconceptions that show in something other than two rays: in a speed, a share,
//! a ratio, a choice of words.

use crate::quiz::question::Misconception;

/// All of them, in the order in which their subjects are taught.
pub(crate) static ALL: [&Misconception; 24] = [
    &SCALAR_MOMENTUM,
    &SPEEDS_ADD,
    &MOMENTUM_LOST,
    &HEAVIER_PUSHES_HARDER,
    &ONE_LINE_FORMULA,
    &SINE_COSINE,
    &SPEED_OPENS_ANGLE,
    &ENERGY_AS_SPEED,
    &HEAVY_TAKES_ENERGY,
    &EVERY_ANGLE_ALIKE,
    &UPSIDE_DOWN,
    &BEYOND_LARGEST,
    &LOSS_ON_EVERYTHING,
    &E_AS_ENERGY,
    &LOSS_FORBIDS_SQUARE,
    &GRIP_IGNORED,
    &GRIP_STOPS_ALL,
    &FRAMES_MIXED,
    &HALFWAY_CENTRE,
    &SQUARE_ON_THE_GROUND,
    &HALF_ANGLE_FORGOTTEN,
    &TOO_GENTLE,
    &NEVER_BACK,
    &DOUBLE_ANGLE_FORGOTTEN,
];

/// Momenta of different directions added like plain numbers.
pub(crate) static SCALAR_MOMENTUM: Misconception = Misconception::in_words(
    "scalar-momentum",
    "momentum added like plain numbers",
    "In the lab, switch on the triangle: two arrows add tip to tail, and their lengths do not.",
);

/// Speeds taken to add up to the speed before.
pub(crate) static SPEEDS_ADD: Misconception = Misconception::in_words(
    "speeds-add",
    "speeds shared out like a sum",
    "In the lab, read both speeds after a hit at 45° and add them: the sum is more than \
     there was before.",
);

/// Momentum taken to be lost with the energy.
pub(crate) static MOMENTUM_LOST: Misconception = Misconception::in_words(
    "momentum-lost",
    "momentum lost with the energy",
    "In the lab, turn e down and watch the momentum in the numbers: it does not change.",
);

/// The two forces of a hit taken to differ.
pub(crate) static HEAVIER_PUSHES_HARDER: Misconception = Misconception::in_words(
    "heavier-pushes-harder",
    "the heavier pushes harder",
    "Think of two skaters who push off each other: one push, two ends, and the lighter one \
     gains more speed from it.",
);

/// The formula for a head-on hit used on the whole velocity.
pub(crate) static ONE_LINE_FORMULA: Misconception = Misconception::in_words(
    "one-line-formula",
    "the head-on formula at an angle",
    "Split the velocity along the line of impact first. The head-on formula is for that part \
     alone.",
);

/// Sine and cosine exchanged.
pub(crate) static SINE_COSINE: Misconception = Misconception::in_words(
    "sine-cosine",
    "sine and cosine exchanged",
    "Try the limits: head-on, at 0°, the coin takes all. The cosine is the one that is 1 \
     there.",
);

/// Angles taken to depend on how fast the hit is.
pub(crate) static SPEED_OPENS_ANGLE: Misconception = Misconception::in_words(
    "speed-opens-angle",
    "angles that hang on the speed",
    "In the lab, change the speed alone and watch the angles: nothing about them moves.",
);

/// Energy taken in proportion to speed.
pub(crate) static ENERGY_AS_SPEED: Misconception = Misconception::in_words(
    "energy-as-speed",
    "energy taken as speed",
    "Half the speed is a quarter of the energy: square the share before you answer.",
);

/// The heavier disc taken to have the more energy.
pub(crate) static HEAVY_TAKES_ENERGY: Misconception = Misconception::in_words(
    "heavy-takes-energy",
    "energy shared out by mass",
    "In the lab, hit head-on with a heavier and heavier coin, and watch the share it takes: \
     it is largest when the masses are equal.",
);

/// All angles, or all offsets, taken to do alike.
pub(crate) static EVERY_ANGLE_ALIKE: Misconception = Misconception::in_words(
    "every-angle-alike",
    "all angles equally likely",
    "In the foil, throw a beam at the discs and watch which angles fill up first.",
);

/// A ratio turned upside down.
pub(crate) static UPSIDE_DOWN: Misconception = Misconception::in_words(
    "upside-down",
    "a ratio turned upside down",
    "Before you work it out, say in words which of the two is the larger, and check the \
     answer against it.",
);

/// No limit to how far a heavier striker can be turned.
pub(crate) static BEYOND_LARGEST: Misconception = Misconception::in_words(
    "beyond-largest",
    "no limit for the heavier striker",
    "In the lab, take the 15 g striker on the 5.5 g coin and try to turn it by 30°: no \
     offset does it.",
);

/// e taken off the whole velocity.
pub(crate) static LOSS_ON_EVERYTHING: Misconception = Misconception::in_words(
    "loss-on-everything",
    "the loss taken off everything",
    "In the lab, turn e down and watch the part across the line of impact: it stays as it was.",
);

/// e taken as the share of energy that is kept.
pub(crate) static E_AS_ENERGY: Misconception = Misconception::in_words(
    "e-as-energy",
    "e taken as a share of energy",
    "e compares speeds of parting and of meeting. Energy goes with the square, and only a \
     part of it is at stake.",
);

/// A right angle taken to be impossible with loss.
pub(crate) static LOSS_FORBIDS_SQUARE: Misconception = Misconception::in_words(
    "loss-forbids-square",
    "with loss never 90°",
    "In the lab, take a striker half as heavy as the coin, e = 0.5, and look at the corner.",
);

/// Grip at the contact taken to do nothing.
pub(crate) static GRIP_IGNORED: Misconception = Misconception::in_words(
    "grip-ignored",
    "grip at the contact forgotten",
    "In the lab, let the two stick and compare with e = 0: sticking takes the motion across \
     the line too.",
);

/// Grip at the contact taken to stop all motion across it.
pub(crate) static GRIP_STOPS_ALL: Misconception = Misconception::in_words(
    "grip-stops-all",
    "slipping taken as sticking",
    "In the lab, set e = 0 without sticking: the striker still slides off along the tangent.",
);

/// An angle of one frame read in another.
pub(crate) static FRAMES_MIXED: Misconception = Misconception::in_words(
    "frames-mixed",
    "an angle of another frame",
    "In the lab, press f to change the frame of the same hit, and watch which angles change.",
);

/// The centre of mass taken halfway, whatever the masses.
pub(crate) static HALFWAY_CENTRE: Misconception = Misconception::in_words(
    "halfway-centre",
    "the centre of mass taken halfway",
    "The centre of mass lies nearer the heavier disc, and moves more like it.",
);

/// The right angle looked for on the ground although both move.
pub(crate) static SQUARE_ON_THE_GROUND: Misconception = Misconception::in_words(
    "square-on-the-ground",
    "90° sought on the ground",
    "In the lab, let both move and press f until you ride with the coin: there the corner is \
     square.",
);

/// The whole angle used where its half belongs.
pub(crate) static HALF_ANGLE_FORGOTTEN: Misconception = Misconception::in_words(
    "half-angle-forgotten",
    "the half of the angle forgotten",
    "Counts go with half the angle: at 180° the sine of the half is 1, and the count is \
     least.",
);

/// A law falling too gently: a square where the fourth power belongs.
pub(crate) static TOO_GENTLE: Misconception = Misconception::in_words(
    "too-gentle",
    "a square for the fourth power",
    "In the foil, halve the angle and watch the count: not four times, but about sixteen.",
);

/// Nothing heavy or fast taken ever to come back.
pub(crate) static NEVER_BACK: Misconception = Misconception::in_words(
    "never-back",
    "nothing ever comes back",
    "In the foil, aim one particle dead at the centre: it stops, and returns the way it came.",
);

/// An angle turned by the impact angle where it is turned by twice as much.
pub(crate) static DOUBLE_ANGLE_FORGOTTEN: Misconception = Misconception::in_words(
    "double-angle-forgotten",
    "the double of the angle forgotten",
    "Off a wall a ball turns by 180° less twice the angle: once on the way in, once on \
     the way out.",
);

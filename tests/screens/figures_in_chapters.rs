//! Each number that a chapter's text contains but the engine does not print, computed from the
//! engine and from the data of the figures. If a sentence, a figure or the physics changes, these
//! tests show what no longer agrees.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use carrom::beams::{
    BIN_WIDTH, BeamTarget, CountedFor, Counts, GEIGER_MARSDEN, METALS, ScatteringLaw, Series,
};
use carrom::physics::beam::Beam;
use carrom::physics::rutherford::{
    FM, GOLD_CHARGE, GOLD_DENSITY, MEASURED_SHARE, MEV, RADIUM_C_ENERGY, Rutherford,
};
use carrom::physics::units::{deg_from_rad, rad_from_deg};
use carrom::physics::{Collision, CollisionOutcome, Disc, Rims};
use glam::DVec2;

/// A number in a sentence.
struct Claim {
    /// The number of the chapter.
    chapter: usize,
    /// The text around the number, with the number in square brackets.
    words: &'static str,
    /// The computed value.
    is: f64,
}

impl Claim {
    /// The sentence without the brackets.
    fn sentence(&self) -> String {
        self.words.replace(['[', ']'], "")
    }

    /// The number, and the unit to which it is rounded.
    fn says(&self) -> (f64, f64) {
        let (_, rest) = self.words.split_once('[').unwrap();
        let (said, _) = rest.split_once(']').unwrap();
        let fractions = [
            ("half", 1.0 / 2.0),
            ("third", 1.0 / 3.0),
            ("quarter", 1.0 / 4.0),
            ("three quarters", 3.0 / 4.0),
            ("twice", 2.0),
            ("four times", 4.0),
        ];
        if let Some((_, number)) = fractions.iter().find(|(name, _)| *name == said) {
            return (*number, 1e-9);
        }
        let digits = said.replace(' ', "").replace('−', "-");
        let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
        // A number that ends in three zeros is rounded to thousands.
        let zeros = match digits.ends_with("000") {
            true => 3,
            false => 0,
        };
        let unit = 10_f64.powi(zeros - i32::try_from(decimals).unwrap());
        (digits.parse().unwrap(), unit)
    }
}

/// Numbers that cannot be computed: years, given values, measurements by others.
const NAMED: [&str; 25] = [
    "(A real coin has a mass of about 5.5 g;",
    "a real coin: 5.5 g,",
    "a target of 25 g,",
    "angle between the paths is 120°.",
    "Nitrogen: mass 14.",
    "Rutherford and Royds (1909)",
    "Before 1911",
    "In 1911 Rutherford",
    "For their paper of 1913",
    "One in 8000",
    "In 1909 Geiger and Marsden found that about 1 α-particle in 8000",
    "The 1 in 8000, often quoted",
    "The same: 1 in 8000.",
    "(1 fm is 10⁻¹⁵ m)",
    "a screen of 1 mm² at 1 cm.",
    "A 15 g striker at",
    "hits a resting 15 g coin head-on",
    "Compare two head-on collisions of 15 g discs",
    "and the striker has a mass of 15 g.",
    "so the mass is 15 g divided by",
    "their thin gold foil of 0.21 micrometres",
    "gold 0.21 micrometres thick",
    "to within 20 %.",
    "they agree within 20 %.",
    "You cannot tell: 20 % is a lot.",
];

fn after(m1_g: f64, m2_g: f64, speed: f64, alpha_deg: f64, restitution: f64) -> CollisionOutcome {
    let (striker, target) = (Disc::from_g_mm(m1_g, 15.0), Disc::from_g_mm(m2_g, 15.0));
    let hit = Collision::at_angle(striker, target, DVec2::new(speed, 0.0), 0.0);
    let hit = hit.with_alpha_deg(alpha_deg);
    Collision { restitution, ..hit }.outcome()
}

/// The component of the striker's final velocity along n.
fn along(outcome: &CollisionOutcome) -> f64 {
    outcome.v1.dot(outcome.normal.unwrap())
}

fn degrees(angle: Option<f64>) -> f64 {
    deg_from_rad(angle.unwrap())
}

fn energy_share(outcome: &CollisionOutcome, mass_g: f64, speed: f64) -> f64 {
    0.5 * mass_g / 1000.0 * speed * speed / outcome.energy_before
}

/// α-particles of this energy, in J, on a gold foil of this thickness, in m.
fn gold_foil(energy: f64, thickness: f64) -> ScatteringLaw {
    ScatteringLaw {
        target: METALS[0].foil(thickness, energy),
        beam: Beam::Space,
    }
}

/// The ratio of the counts on a small screen at the first and at the second angle, in degrees.
fn on_the_screen(at_deg: f64, than_at_deg: f64) -> f64 {
    let law = gold_foil(RADIUM_C_ENERGY, 2.1e-7);
    let count = |deg| law.share_per_steradian(rad_from_deg(deg)).unwrap();
    count(at_deg) / count(than_at_deg)
}

/// The factor by which a change of the beam or the foil changes the count on a small screen at 60°.
fn at_60(changed: ScatteringLaw) -> f64 {
    let at = |law: ScatteringLaw| law.share_per_steradian(rad_from_deg(60.0)).unwrap();
    at(changed) / at(gold_foil(RADIUM_C_ENERGY, 2.1e-7))
}

fn claims() -> Vec<Claim> {
    let mut claims = Vec::new();
    let mut claim = |chapter, words, is| claims.push(Claim { chapter, words, is });
    let equal = |alpha_deg| after(15.0, 15.0, 1.0, alpha_deg, 1.0);
    let share_of_target = |hit: CollisionOutcome| energy_share(&hit, 15.0, hit.v2.length());
    let sine = |deg: f64| rad_from_deg(deg).sin();

    // Chapters 1 to 4: equal masses, and 10 g on 30 g.
    claim(
        1,
        "but [half] of the energy would be missing",
        2.0 * 1.0 / 4.0,
    );
    claim(
        1,
        "three times the mass, so it has a [third] of the speed",
        10.0 / 30.0,
    );
    // The friction of the table, during a contact of a millisecond.
    let slowing = 0.12 * 9.80665;
    claim(1, "may slow a puck by [1.2] m/s every second.", slowing);
    claim(1, "the loss is only [0.0012] m/s.", slowing / 1000.0);
    claim(
        2,
        "[60]° and 30° make a right angle",
        degrees(equal(30.0).theta1),
    );
    claim(
        2,
        "60° and [30]° make a right angle",
        degrees(equal(30.0).theta2),
    );
    claim(3, "number answer=[90]", degrees(equal(40.0).separation));
    claim(
        4,
        "[half] of it, even this far off-centre",
        share_of_target(equal(45.0)),
    );
    claim(
        4,
        "The first coin keeps [half] its speed.",
        equal(30.0).v1.length(),
    );
    let both = degrees(equal(20.0).theta1) + degrees(equal(20.0).theta2);
    claim(4, "from (0°, [90]°) to (90°, 0°)", both);

    // Chapter 5: 30 g on 10 g.
    let uneven = after(30.0, 10.0, 2.0, 60.0, 1.0);
    let came = uneven.normal.unwrap().x * 2.0;
    let across = uneven.v1.dot(uneven.tangent.unwrap());
    claim(5, "The striker keeps 20/40 of its [1.00] m/s:", came);
    claim(
        5,
        "The striker keeps [20]/40 of its 1.00 m/s:",
        40.0 * along(&uneven) / came,
    );
    claim(
        5,
        "(The components add up to [2.23] m/s,",
        along(&uneven) + across,
    );
    claim(
        5,
        "The striker keeps the remaining [quarter]",
        1.0 - share_of_target(equal(30.0)),
    );

    // Chapter 6: 20 g on 40 g, and the other way round.
    let marbles = after(20.0, 40.0, 3.0, 45.0, 1.0);
    let came = 3.0 * sine(45.0);
    claim(6, "or minus one [third]", -along(&marbles) / came);
    claim(6, "The heavy puck gets 40/60 of [2.12] m/s", came);
    claim(
        6,
        "The heavy puck gets [40]/60 of 2.12 m/s",
        60.0 * marbles.v2.length() / came,
    );
    claim(6, "$t_x$ and $t_y$ are [0.707],", marbles.normal.unwrap().x);
    claim(6, "and $n_y$ is [−0.707].", marbles.normal.unwrap().y);
    let heavy = after(40.0, 20.0, 3.0, 45.0, 1.0);
    claim(
        6,
        "the heavy puck keeps a [third] of its velocity",
        along(&heavy) / came,
    );
    // Rolling balls keep their spin in the collision and finally roll again. The final velocity is
    // 5/7 of the velocity right after the collision plus 2/7 of the velocity before it.
    let ball = equal(30.0);
    claim(
        6,
        "an equal ball at α = [30]° is deflected by 34°, not 60°.",
        degrees(ball.theta2),
    );
    let rolling = 5.0 / 7.0 * ball.v1 + 2.0 / 7.0 * DVec2::new(1.0, 0.0);
    claim(
        6,
        "an equal ball at α = 30° is deflected by [34]°, not 60°.",
        deg_from_rad(rolling.to_angle()),
    );
    claim(
        6,
        "an equal ball at α = 30° is deflected by 34°, not [60]°.",
        degrees(ball.theta1),
    );

    // Chapters 7 and 8.
    claim(
        7,
        "Yes: $90 deg - [20] deg$.",
        90.0 - degrees(equal(20.0).theta1),
    );
    claim(7, "By [140]°.", 180.0 - 2.0 * 20.0);
    claim(
        7,
        "the striker transfers [three quarters] of its energy",
        share_of_target(equal(30.0)),
    );
    claim(
        8,
        "It is not 0.6 times 90°, which would be [54]°",
        0.6 * 90.0,
    );
    claim(
        8,
        "than half of the range, which ends at [30] mm.",
        2.0 * 15.0,
    );

    // Chapter 9: weighing.
    claim(9, "$sin 153.4 deg$ is [0.448]", sine(153.4));
    claim(9, "$sin 63.4 deg$ is [0.894]", sine(63.4));
    let unknown = after(15.0, 10.0, 4.0, 35.0, 1.0);
    let (theta1, theta2) = (degrees(unknown.theta1), degrees(unknown.theta2));
    let ratio = sine(theta1 + 2.0 * theta2) / sine(theta1);
    claim(9, "number answer=[10]", 15.0 / ratio);
    claim(9, "15 g divided by [1.50], or 10 g.", ratio);
    claim(9, "15 g divided by 1.50, or [10] g.", 15.0 / ratio);

    // Chapter 10: shots without aiming.
    let on_board = Beam::Board.share_beyond(rad_from_deg(60.0));
    claim(10, "number answer=[50]", 100.0 * on_board);
    claim(10, "or [50] % of the hits", 100.0 * on_board);
    claim(
        10,
        "so b must be below [half] of $r_1 + r_2$",
        rad_from_deg(60.0).cos(),
    );
    let in_space = Beam::Space.share_beyond(rad_from_deg(60.0));
    claim(
        10,
        "Half the radius gives a [quarter] of the area",
        in_space,
    );
    // Gold.
    let gold = Rutherford::radium_c_on_gold();
    let d = gold.head_on_approach;
    claim(
        10,
        "number answer=[90]",
        deg_from_rad(gold.scattering_angle(d / 2.0)),
    );
    claim(10, "At an energy of [7.69] MeV", RADIUM_C_ENERGY / MEV);
    claim(10, "{rutherford_d_fm: [29.6]}", d / FM);
    claim(10, "to_deg=120: [9]}", on_the_screen(60.0, 120.0));
    claim(
        10,
        "to_deg=150: [2999]}, as the line in the figure shows",
        on_the_screen(15.0, 150.0),
    );
    let faster = gold_foil(2.0 * RADIUM_C_ENERGY, 2.1e-7);
    claim(10, "It falls to a [quarter].", at_60(faster));
    let charged = Rutherford::new(2.0, 2.0 * GOLD_CHARGE, RADIUM_C_ENERGY).head_on_approach;
    claim(
        10,
        "Twice the charge of the nucleus gives [four times] the count.",
        (charged / d).powi(2),
    );
    let thicker = gold_foil(RADIUM_C_ENERGY, 4.2e-7);
    claim(
        10,
        "Twice the thickness of the foil gives [twice] the count.",
        at_60(thicker),
    );
    // The counts of 1913.
    let [least, .., most] = GEIGER_MARSDEN;
    let (low, high) = Series::new(|angle| angle.gold).band();
    claim(
        10,
        "at angles Θ from [15]° to 150°",
        deg_from_rad(most.angle),
    );
    claim(
        10,
        "at angles Θ from 15° to [150]°",
        deg_from_rad(least.angle),
    );
    claim(10, "fell from [132 000] to 33.1", most.gold);
    claim(10, "fell from 132 000 to [33.1]", least.gold);
    claim(10, "falls by a factor of [4000]", most.gold / least.gold);
    claim(10, "from its mean by only [−15] % to +23 %", 100.0 * low);
    claim(10, "from its mean by only −15 % to +[23] %", 100.0 * high);
    let (low, high) = Series::new(|angle| angle.silver).band();
    claim(10, "the range is [−15] % to +41 %", 100.0 * low);
    claim(10, "the range is −15 % to +[41] %", 100.0 * high);
    // Shares of the thin foil.
    let law = gold_foil(RADIUM_C_ENERGY, 2.1e-7);
    claim(
        10,
        "about 1 in [117 000]",
        1.0 / law.share_beyond(rad_from_deg(90.0)),
    );
    claim(10, "With Z = [79] and 5.9×10²⁸ atoms", GOLD_CHARGE);
    claim(10, "With Z = 79 and [5.9]×10²⁸ atoms", GOLD_DENSITY / 1e28);
    let share = law.share_per_steradian(rad_from_deg(45.0)).unwrap() * 0.01;
    claim(10, "{rutherford_share angle_deg=45: [3.2]e-7}", share * 1e7);
    claim(10, "{measured_share: [3.7]e-7}", MEASURED_SHARE * 1e7);
    claim(
        10,
        "3.7 less 20 % is [3.0], and 3.2 is more than that.",
        3.7 * 0.8,
    );

    // Chapters 11 and 12.
    claim(11, "[60] g m/s divided by 60 g", 20.0 * 3.0);
    claim(11, "60 g m/s divided by [60] g", 20.0 + 40.0);
    claim(11, "This is one [half], and", 10.0 / 20.0);
    claim(
        11,
        "The [21.5]° of chapter 8",
        deg_from_rad((5.5_f64 / 15.0).asin()),
    );
    claim(12, "number answer=[30]", 15.0 / 0.5);
    let right = degrees(after(15.0, 30.0, 3.0, 40.0, 0.5).separation);
    claim(
        12,
        "{separation_deg slip restitution=0.5 m2_g=30: [90.0]}",
        right,
    );
    let soft = after(15.0, 15.0, 3.0, 35.0, 0.0);
    let came = 3.0 * rad_from_deg(35.0).cos();
    claim(
        12,
        "At e = 0 it keeps [half] of its component along n",
        along(&soft) / came,
    );

    // Chapter 13: the force of a contact.
    let impulse = after(15.0, 15.0, 4.0, 0.0, 1.0).impulse;
    let average = |seconds: f64| impulse / seconds;
    let in_grams = 1000.0 * impulse;
    let slower = after(15.0, 15.0, 3.0, 0.0, 1.0).impulse;
    claim(13, "In SI units, J is [0.045] kg m/s", slower);
    claim(13, ", or [0.045] N s: one newton", slower);
    claim(13, "Use SI units: [0.060] N s", impulse);
    claim(13, " and [0.0012] s. ---", 1.2 / 1000.0);
    claim(13, "F is [0.060] N s divided", impulse);
    claim(13, "by [0.0012] s, or", 1.2 / 1000.0);
    claim(13, "or [50] N: the weight", average(1.2e-3));
    claim(13, "of about [5] kg.", average(1.2e-3) / 9.80665);
    // The curve is half a period of a sine: its average is 2/π of its height.
    let greatest = average(1.2e-3) * std::f64::consts::FRAC_PI_2;
    claim(13, "greatest force is [78.5] N.", greatest);
    claim(13, "[half] the time", 0.6 / 1.2);
    claim(
        13,
        "means [twice] the force",
        average(0.6e-3) / average(1.2e-3),
    );
    claim(13, ", [100] N.", average(0.6e-3));
    claim(13, "by [8] m/s.", 4.0 + 4.0);
    claim(13, "So the impulse is [120] g m/s", 2.0 * in_grams);
    let friction = 0.12 * 9.80665 * 0.015;
    claim(13, "the force of friction is about [0.018] N.", friction);
    claim(13, "[0.018] N is about 6000 times smaller", friction);
    let smaller = average(0.6e-3) / friction;
    claim(13, "0.018 N is about [6000] times smaller", smaller);
    claim(13, "than the average force of [100] N", average(0.6e-3));
    claim(
        13,
        "the impulse of friction is [18] g m/s",
        1000.0 * friction,
    );

    // Chapter 14: collisions that lose energy, and explosions.
    let half = after(15.0, 15.0, 4.0, 0.0, 0.5);
    let [slow, fast] = [half.v1, half.v2].map(DVec2::length);
    claim(14, "= [2] m/s, and they approached at", fast - slow);
    claim(14, "the sums of the squares: [16] before", 4.0 * 4.0);
    claim(14, "16 before, [1] + 9 afterwards.", slow * slow);
    claim(14, "1 + [9] afterwards.", fast * fast);
    claim(14, "The sum falls from [16] to 10", 4.0 * 4.0);
    claim(
        14,
        "The sum falls from 16 to [10]",
        slow * slow + fast * fast,
    );
    claim(14, "so the joined pucks ([80] g) move on at", 20.0 + 60.0);
    claim(14, "the speed falls to a [quarter].", 20.0 / 80.0);
    claim(
        14,
        "a 16th of the square of the speed leave a [quarter] of the energy",
        80.0 / 20.0 / 16.0,
    );
    claim(14, "a [16]th of the square", (80.0_f64 / 20.0).powi(2));
    let [right, up] = [20.0 * 3.0, 40.0 * 2.0_f64];
    let sum = right.hypot(up);
    claim(
        14,
        "The momenta are [60] and 80 g m/s, at right angles",
        right,
    );
    claim(14, "The momenta are 60 and [80] g m/s, at right angles", up);
    claim(14, "so the momentum is [100] g m/s. The mass is 60 g", sum);
    claim(14, "100 g m/s. The mass is [60] g", 20.0 + 40.0);
    claim(14, "The sum is not [140] g m/s:", right + up);
    claim(14, "the upward momentum, [80] g m/s, divided", up);
    claim(14, "the momentum to the right, [60] g m/s.", right);
    claim(14, "The tangent is [80]/60, so", up);
    claim(14, "The tangent is 80/[60], so", right);
    claim(
        14,
        "so the angle is [53.1]°.",
        deg_from_rad(up.atan2(right)),
    );
    claim(14, "It is not [45]°,", 90.0 / 2.0);
    claim(14, "(Use g = [9.81] m/s².)", 9.80665);
    // The height, in centimetres, that a body reaches if it starts upwards at this speed.
    let height = |v: f64| 100.0 * v * v / (2.0 * 9.80665);
    claim(14, "is [20.4] cm. If you", height(20.0 * 10.0 / 100.0));
    // If no energy were lost, ½ m u² = (m + M) g h: h is m/(m + M) of the height for the speed u.
    claim(
        14,
        "you get [204] cm, ten times as much.",
        height(20.0) * 10.0 / 100.0,
    );
    claim(14, "A body of [50] g is at rest.", 20.0 + 30.0);
    claim(
        14,
        "opposite, [60] g m/s each, so the 30 g piece",
        20.0 * 3.0,
    );
    claim(14, "gets more of it, [90] mJ", 0.5 * 20.0 * 9.0);
    claim(14, "A body of [85] g at rest explodes", 20.0 + 40.0 + 25.0);
    claim(14, "The first two momenta are [60] and 80 g m/s.", right);
    claim(14, "The first two momenta are 60 and [80] g m/s.", up);
    claim(14, "closes the triangle: its length is [100] g m/s.", sum);
    claim(
        14,
        "A mass of 25 g has this momentum at [4] m/s.",
        sum / 25.0,
    );
    claim(14, "A body of [60] g flies at", 20.0 + 40.0);
    claim(14, "with a momentum of [100] g m/s. It explodes", sum);
    claim(14, "The 20 g piece has a momentum of [60] g m/s.", right);
    claim(14, "([100] − 60 = 40 would be right", sum);
    claim(14, "(100 − [60] = 40 would be right", right);
    claim(14, "(100 − 60 = [40] would be right", sum - right);

    // Chapter 15: the energy in two parts.
    claim(15, "the total momentum, [50] + 40 g m/s", 20.0 * 2.5);
    claim(15, "the total momentum, 50 + [40] g m/s", 40.0 * 1.0);
    claim(15, "by [60] g. Then multiply half of 60 g", 20.0 + 40.0);
    claim(15, "Then multiply half of [60] g by", 20.0 + 40.0);
    claim(15, "[800]/60 is", 20.0 * 40.0);
    claim(15, "800/[60] is", 20.0 + 40.0);
    claim(15, "½ · [13.3] g · (3 m/s)²", 800.0 / 60.0);
    claim(15, "not a [quarter], because", 0.5 * 0.5);
    claim(15, "e² is a [quarter], so", 0.5 * 0.5);

    // Chapter 16: rough rims.
    let rough = |friction: f64, alpha_deg: f64| {
        let disc = Disc::from_g_mm(15.0, 15.0);
        let hit = Collision::at_angle(disc, disc, DVec2::new(4.0, 0.0), 0.0);
        let rims = Rims {
            friction,
            spins: [0.0; 2],
        };
        Collision { rims, ..hit }.with_alpha_deg(alpha_deg)
    };
    let smooth = degrees(rough(0.0, 30.0).outcome().theta2);
    claim(16, "24.5}°, not at [30]°", smooth);
    claim(16, "ω₁ r₁ = [−1.50] m/s", -100.0 * 0.015);
    claim(
        16,
        "At ω₁ = [−133] rad/s, there would be no slip",
        -2.0 / 0.015,
    );
    claim(16, "spins clockwise: ω₁ = [−100] rad/s", -100.0);
    claim(16, "Both radii are [15] mm", 15.0);
    claim(16, "15 mm is [0.015] m", 15.0 / 1000.0);
    claim(16, "The slip speed is 2.00 − [1.50]", 100.0 * 0.015);
    claim(16, "μ = [7.5] g, and", 15.0 * 15.0 / 30.0);
    claim(16, "7.5 × 2.00 / 3 = [5.0] g m/s", 7.5 * 2.0 / 3.0);
    // 1 + mr²/I: I = ½mr² for a disc, and 2/5 mr² for a sphere. The text has the reciprocals.
    claim(
        16,
        "the factor 1/[3] in the formulas becomes 2/7",
        1.0 + 2.0,
    );
    claim(
        16,
        "the factor 1/3 in the formulas becomes 2/[7]",
        2.0 * (1.0 + 2.5),
    );
    claim(16, "= 6 × 0.05 = [0.3], so", 6.0 * 0.05);
    let thrown = rough(0.05, 30.0).outcome();
    let throw = 30.0 - degrees(thrown.theta2);
    claim(16, "The coin leaves at 30.0° − [2.9]°", throw);
    let error_mm = 300.0 * rad_from_deg(throw).tan();
    claim(
        16,
        "a distance of 30 cm, this is an error of [15] mm",
        error_mm,
    );
    let edge = deg_from_rad(f64::atan(6.0 * 0.05));
    claim(16, "number answer=[16.7]", edge);
    claim(16, "so α = [16.7]°", edge);
    let apart = |alpha_deg: f64| alpha_deg - degrees(rough(0.05, alpha_deg).outcome().theta2);
    assert!(apart(edge - 1.0) < apart(edge) - 0.1 && (apart(60.0) - apart(edge)).abs() < 1e-9);

    // Chapter 17: measuring a real collision.
    let [one, two] = [0.682_689_492, 0.954_499_736];
    claim(17, "the true value in [68] % of all", 100.0 * one);
    claim(17, "\"[87]° ± 3°\"", 90.0 - 3.0);
    claim(17, "means from [84]° to", 87.0 - 3.0);
    claim(17, "You find [84]° ± 3°", 84.0);
    claim(17, "How many uncertainties is [84]° ± 3°", 84.0);
    claim(17, "[6]°/3°", 90.0 - 84.0);
    claim(17, "= [2.0], so the difference", 6.0 / 3.0);
    claim(17, "the difference is [2.0] σ", 6.0 / 3.0);
    claim(
        17,
        "a larger difference once in [22] measurements",
        1.0 / (1.0 - two),
    );
    claim(17, "A result of [84]° ± 1°", 84.0);
    claim(17, "would disagree, by [6] σ", (90.0 - 84.0) / 1.0);
    claim(17, "the uncertainty at [120] frames", 4.0 * 30.0);
    claim(17, "[2]°/2 = 1°", 2.0);
    claim(17, "2°/2 = [1]°", 2.0 / f64::sqrt(120.0 / 30.0));
    claim(17, "you would need [480] frames", 4.0 * 120.0);
    claim(17, "marks are [20] mm above", 1000.0 * 0.02);
    claim(17, "Divide 1.00 by [0.98]", 1.00 - 0.02);
    claim(17, "1.00/[0.98]", 1.00 - 0.02);
    claim(17, "= [1.02], so they are", 1.00 / (1.00 - 0.02));
    claim(17, "the error is only [1] %", 100.0 * 0.02 / (2.0 - 0.02));
    claim(17, "It is tilted by [20]°", 20.0);
    let shrunk = rad_from_deg(20.0).cos();
    claim(17, "too short: [94] % of the true length", 100.0 * shrunk);
    claim(17, "because cos 20° = [0.94]", shrunk);
    claim(17, "cos [20]°", 20.0);
    claim(17, "is known to 3 %, the other to [4] %", 4.0);
    claim(17, "√([9] + 16)", 9.0);
    claim(17, "√(9 + [16])", 16.0);
    claim(17, "= 5, so the uncertainty is [5] %", f64::hypot(3.0, 4.0));
    claim(17, "less than [7] %", 3.0 + 4.0);
    claim(17, "the uncertainty is ±[0.04]", 0.05 * 0.8);
    claim(17, "Film at [60] frames", 60.0);
    claims
}

/// The source of each chapter, by its number.
fn chapters() -> BTreeMap<usize, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/lessons");
    let files = fs::read_dir(folder)
        .unwrap()
        .map(|file| file.unwrap().path());
    let markdown = files.filter(|path| path.extension().is_some_and(|it| it == "md"));
    let chapter = |path: std::path::PathBuf| {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        (
            name[..2].parse().unwrap(),
            fs::read_to_string(path).unwrap(),
        )
    };
    markdown.map(chapter).collect()
}

fn on_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn every_claim_is_in_its_chapter_and_is_true() {
    let chapters = chapters();
    for claim in claims() {
        let Claim { chapter, words, is } = claim;
        let text = on_one_line(&chapters[&chapter]);
        assert!(
            text.contains(&claim.sentence()),
            "chapter {chapter} does not contain: {words}"
        );
        let (says, unit) = claim.says();
        let off = (is - says).abs();
        assert!(
            off <= 0.5 * unit + 1e-9,
            "chapter {chapter}: {words}: it is {is}"
        );
    }
}

/// The numbers in a text, in order, each with the text before it.
fn numbers(text: &str) -> Vec<(f64, &str)> {
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let mut numbers = Vec::new();
    let mut from = 0;
    while let Some(start) = text[from..].find(|c: char| c.is_ascii_digit()) {
        let start = from + start;
        let rest = &text[start..];
        let length = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        let written = rest[..length].trim_end_matches('.');
        from = start + length;
        numbers.push((written.parse().unwrap(), &text[..from]));
    }
    numbers
}

/// The text outside and the text inside all pairs of these signs.
fn parted(text: &str, [open, close]: [&str; 2]) -> (String, String) {
    let (mut outside, mut inside) = (String::new(), String::new());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(open) {
        let (within, behind) = after.split_once(close).unwrap();
        outside += &format!("{before} ");
        inside += &format!("{within} ");
        rest = behind;
    }
    (outside + rest, inside)
}

/// The text without this word and any number that follows it, as in "chapter 3".
fn unnumbered(text: &str, word: &str) -> String {
    let mut parts = text.split(word);
    let mut kept = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        kept += part.trim_start_matches(|c: char| c.is_ascii_digit());
    }
    kept
}

/// Every number in a sentence is printed by the engine, given by a shot of the chapter, or listed
/// here.
#[test]
fn every_number_has_a_source() {
    for (chapter, text) in chapters() {
        let (_, rest) = text.split_once("+++").unwrap();
        let (header, body) = rest.split_once("+++").unwrap();
        let (directives, prose): (Vec<&str>, Vec<&str>) =
            body.lines().partition(|line| line.starts_with("::"));
        let is_item = |line: &&&str| {
            line.split_once(". ")
                .is_none_or(|(n, _)| n.parse::<u8>().is_err())
        };
        let prose: Vec<&str> = prose.iter().filter(is_item).copied().collect();
        let mut prose = on_one_line(&prose.join("\n"));
        let (_, printed) = parted(&prose, ["{", "}"]);
        let directives = directives.join("\n");
        let given = [header, &directives, &printed].map(numbers).concat();
        let given = given.iter().map(|(number, _)| *number);
        let given: Vec<f64> = given.chain([0.0, 90.0, 180.0]).collect();
        let claims = claims().into_iter().filter(|it| it.chapter == chapter);
        for words in claims
            .map(|it| it.sentence())
            .chain(NAMED.map(String::from))
        {
            prose = prose.replace(&words, " ");
        }
        for signs in [["{", "}"], ["$$", "$$"], ["$", "$"], ["`", "`"]] {
            prose = parted(&prose, signs).0;
        }
        for word in ["chapter ", "Chapter ", "step ", "Step "] {
            prose = unnumbered(&prose, word);
        }
        for (number, before) in numbers(&prose) {
            let near: Vec<&str> = before.split(' ').rev().take(9).collect();
            let near: Vec<&str> = near.into_iter().rev().collect();
            assert!(
                given.contains(&number),
                "chapter {chapter}: this number has no source: … {}",
                near.join(" ")
            );
        }
    }
}

/// The bars of the figure agree with what the chapter and the quiz say about a small screen: the
/// expected counts follow the law.
#[test]
fn the_bars_of_the_beam_agree_with_the_text() {
    let law = gold_foil(RADIUM_C_ENERGY, 2.1e-7);
    assert!(matches!(law.target, BeamTarget::Coulomb { .. }));
    let counts = Counts::expected(&law, 1_000_000_000_000);
    let screen = |bin: usize| counts[bin] / CountedFor::Steradian.in_bin(bin);
    let ring = |bin: usize| counts[bin] / CountedFor::Ring.in_bin(bin);
    let at = |deg: f64| (deg / deg_from_rad(BIN_WIDTH)) as usize;
    // From the bin that begins at 15° to the one that begins at 150°, the counts on the screen fall
    // by about as much as the law does between the middles of the bins, 17.5° and 152.5°. In rings,
    // the factor is only about 65 % of that.
    let [on_screen, in_rings] = [
        screen(at(16.0)) / screen(at(151.0)),
        ring(at(16.0)) / ring(at(151.0)),
    ];
    let law_there = (rad_from_deg(76.25).sin() / rad_from_deg(8.75).sin()).powi(4);
    assert!(
        (on_screen / law_there - 1.0).abs() < 0.05,
        "{on_screen} {law_there}"
    );
    assert!(
        (0.5..0.7).contains(&(in_rings / on_screen)),
        "{in_rings} {on_screen}"
    );
    // The count per solid angle at half the angle, in a ring half as wide, is about 16 times as
    // great.
    let share = |from: usize, to: usize| counts[from..to].iter().sum::<f64>();
    let size = |from, to| {
        (from..to)
            .map(|bin| CountedFor::Steradian.in_bin(bin))
            .sum::<f64>()
    };
    let sixteen = share(2, 3) / size(2, 3) / (share(4, 6) / size(4, 6));
    assert!((15.0..16.5).contains(&sixteen), "{sixteen}");
}

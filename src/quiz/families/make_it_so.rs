//! "Make it so": choose the offset that sends a disc in a given direction, and shoot.

use super::prelude::*;
use crate::physics::units::m_from_mm;
use crate::quiz::question::{AimTask, Ray, Topic};

/// Sets of pieces whose striker is light enough to be deflected by any angle.
const LIGHT: [Pieces; 3] = [
    Pieces::Marbles,
    Pieces::Own {
        striker: Disc::from_g_mm(10.0, 14.0),
        target: Disc::from_g_mm(30.0, 16.0),
    },
    Pieces::Own {
        striker: Disc::from_g_mm(15.0, 15.0),
        target: Disc::from_g_mm(45.0, 20.0),
    },
];

pub(super) fn ask(difficulty: Difficulty, dice: &mut Dice) -> Option<Question> {
    let (pieces, wanted_deg) = match difficulty {
        Difficulty::Easy | Difficulty::Middle => {
            (Pieces::Equal, f64::from(5 * (3 + dice.below(13))))
        }
        Difficulty::Hard => (*dice.pick(&LIGHT)?, f64::from(5 * (6 + dice.below(21)))),
    };
    // At 90° some wrong answers would be head-on hits or grazes.
    if (wanted_deg - 90.0).abs() < 1.0 {
        return None;
    }
    let hit = Hit {
        pieces,
        given: ImpactPoint::Angle { alpha_deg: 0.0 },
        restitution: 1.0,
        speed: f64::from(2 + dice.below(4)),
        direction_deg: direction_deg(difficulty, dice),
    };
    let task = ShotTask {
        hit,
        side: if dice.coin() { -1.0 } else { 1.0 },
        wanted_deg,
    };
    match difficulty {
        Difficulty::Easy => task.target(),
        Difficulty::Middle | Difficulty::Hard => task.striker(),
    }
}

/// The shot to make.
struct ShotTask {
    hit: Hit,
    /// The side on which the target must lie: 1 for the right, −1 for the left.
    side: f64,
    /// The required angle between the path of the disc and the striker's original direction, in
    /// degrees.
    wanted_deg: f64,
}

impl ShotTask {
    /// Asks where to aim to send the coin in this direction; the coin leaves along the line of
    /// impact.
    fn target(&self) -> Option<Question> {
        let reach_mm = self.hit.reach_mm();
        let wanted = rad_from_deg(self.wanted_deg);
        let why = format!(
            "The coin leaves along the line of impact, which must be at {}° to the striker's \
             direction. So",
            bare_degrees(wanted)
        );
        self.asks(Ray::Target, wanted)
            .wrong(OffsetAsAngle, self.at(reach_mm * self.wanted_deg / 90.0))
            .says(
                "You assumed that the offset is proportional to the angle. It is proportional \
                   to the sine of the angle.",
            )
            .wrong(SineCosine, self.at(reach_mm * wanted.cos()))
            .says(
                "You used the cosine instead of the sine. An offset of 0 is head-on and sends the \
                 coin straight ahead.",
            )
            .wrong(SidesExchanged, self.at(-reach_mm * wanted.sin()))
            .says(
                "With this offset the coin leaves on the other side. It always leaves on the \
                   side on which it lies.",
            )
            .why(self.why(&why, wanted))
    }

    /// Asks where to aim to deflect the striker by this angle; the striker is not heavier than its
    /// target, and no energy is lost.
    fn striker(&self) -> Option<Question> {
        let reach_mm = self.hit.reach_mm();
        let wanted = rad_from_deg(self.wanted_deg);
        // In the centre-of-mass frame the striker is deflected by Θ = 180° − 2α, and sin(Θ − θ₁) =
        // (m₁/m₂) sin θ₁, which follows from θ₁ = atan2(sin Θ, cos Θ + m₁/m₂).
        let ratio = self.hit.mass_ratio();
        let turn = wanted + (ratio * wanted.sin()).clamp(-1.0, 1.0).asin();
        let alpha = rad_from_deg(90.0) - turn / 2.0;
        let equal = self.hit.masses_are_equal();
        let name = self.hit.pieces.target_name();
        let why = if equal {
            format!(
                "The angle between the paths is 90°, so the coin must leave at 90° − {}° = {}. \
                 That is the line of impact:",
                bare_degrees(wanted),
                degrees(alpha)
            )
        } else {
            let shown = self.shown(alpha);
            let half =
                |turn: f64| format!("{:.*}", shown.decimals(), 90.0 - deg_from_rad(turn) / 2.0);
            let turn_of = |ratio: f64| wanted + (ratio * wanted.sin()).asin();
            let turn = Intermediate::angle(turn, half);
            let of_turn =
                |ratio: f64| format!("{:.*}", turn.decimals(), deg_from_rad(turn_of(ratio)));
            format!(
                "In the centre-of-mass frame sin(Θ − {theta}°) = m₁ / m₂ × sin {theta}° = {ratio} × \
                 sin {theta}°, so Θ = {turn}°. α = 90° − {turn}° / 2 = {shown}°, and",
                ratio = Intermediate::new(ratio, of_turn),
                theta = bare_degrees(wanted),
            )
        };
        // The first two wrong answers exist only for an angle below 90°; for larger angles no
        // offset corresponds to them.
        let across = self.wanted_deg < 90.0;
        let if_so = |so: bool, offset_mm: f64| so.then_some(self.at(offset_mm));
        self.asks(Ray::Striker, alpha)
            .wrong(
                AlwaysSquare,
                if_so(!equal && across, reach_mm * wanted.cos()),
            )
            .says("Your offset fits an angle close to 90° between the paths. That is right only for equal masses.")
            .wrong(CopiedAngle, if_so(across, reach_mm * wanted.sin()))
            .says(format!(
                "You used the line of impact, the {name}'s path, as the striker's path."
            ))
            .wrong(
                OffsetAsAngle,
                self.at(reach_mm * deg_from_rad(alpha) / 90.0),
            )
            .says("You made the offset proportional to α. It is proportional to sin α.")
            .wrong(SidesExchanged, self.at(-reach_mm * alpha.sin()))
            .says(format!(
                "With this offset the striker leaves on the other side, away from the {name}."
            ))
            .wrong(FramesMixed, if_so(!equal, reach_mm * (wanted / 2.0).cos()))
            .says(format!(
                "You used {} as Θ, but it is the angle in the laboratory frame.",
                degrees(wanted)
            ))
            .why(self.why(&why, alpha))
    }

    /// Converts an offset in millimetres for a target on the right to an offset in metres for the
    /// actual side.
    fn at(&self, offset_mm: f64) -> f64 {
        self.side * m_from_mm(offset_mm)
    }

    /// The explanation: a sentence on the impact angle, followed by the offset for `alpha`, which
    /// is in radians.
    fn why(&self, angle: &str, alpha: f64) -> String {
        let reach_mm = self.hit.reach_mm();
        format!(
            "{angle} b = {} mm × sin {}° = {} mm.",
            bare_millimetres(reach_mm),
            self.shown(alpha),
            significant(reach_mm * alpha.sin())
        )
    }

    /// The impact angle, with enough digits for the printed value to give the printed offset.
    fn shown(&self, alpha: f64) -> Intermediate {
        let reach_mm = self.hit.reach_mm();
        Intermediate::angle(alpha, |alpha| significant(reach_mm * alpha.sin()))
    }

    /// The question for which this impact angle, in radians, is the solution.
    fn asks(&self, ray: Ray, alpha: f64) -> Outline {
        let hit = &self.hit;
        let name = hit.pieces.target_name();
        let [m1_g, m2_g] = hit.masses_g();
        let [m1, m2] = [m1_g, m2_g].map(significant);
        let reach_mm = hit.reach_mm();
        let wanted = rad_from_deg(self.wanted_deg);
        // The striker is deflected to the side away from its target.
        let (sent, asked, rightward) = match ray {
            Ray::Target => (name, "target", self.side > 0.0),
            Ray::Striker => ("striker", "striker", self.side < 0.0),
        };
        let masses = if hit.masses_are_equal() {
            format!("Both have a mass of {m1} g")
        } else {
            format!("The striker has a mass of {m1} g, the {name} of {m2} g")
        };
        let text = format!(
            "Make the {sent} leave at {} to the {} of the striker's original direction. {masses}; \
             the {name} is at rest, r₁ + r₂ = {} mm, and no energy is lost. Choose the offset and \
             shoot.",
            degrees(wanted),
            if rightward { "right" } else { "left" },
            bare_millimetres(reach_mm)
        );
        let shown = Markings {
            offset: true,
            ..Markings::FIGURES
        };
        let collision = hit.collision();
        Outline::new(text, Illustration::before(collision, shown))
            .named(asked, Topic::with_id(format!("send-{sent}")))
            .figure("m1_g", m1_g)
            .figure("m2_g", m2_g)
            .figure("r1_mm", mm_from_m(collision.striker.radius))
            .figure("r2_mm", mm_from_m(collision.target.radius))
            .figure("speed", hit.speed)
            .figure("direction_deg", hit.direction_deg)
            .figure("wanted_deg", self.wanted_deg)
            .figure("side", if self.side < 0.0 { "left" } else { "right" })
            .shot(AimTask {
                collision,
                ray,
                wanted: self.side * wanted,
                offset: self.at(reach_mm * alpha.sin()),
            })
    }
}

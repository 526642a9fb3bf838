//! The opponent's stroke in words, with the angles. Left, right, top and bottom refer to the
//! screen, with South at the bottom, regardless of who plays.

use std::f64::consts::PI;

use glam::DVec2;

use super::hand::Slip;
use super::story::{Chance, Fall, FirstContact, Story};
use crate::game::Piece;
use crate::numbers::capital;
use crate::physics::units::{deg_from_rad, mm_from_m};

/// Below this angle, in radians (1.5°), a hit is called full and a path straight.
const FULL: f64 = 0.026;

/// A striker that keeps less than this fraction of its speed in a hit is said to nearly stop.
const NEARLY_STOPPED: f64 = 0.05;

/// The smallest error in direction that is mentioned, in radians: it rounds to 0.1°.
const SMALLEST_SLIP: f64 = 0.05 * PI / 180.0;

/// Who describes the stroke: this determines the grammatical person.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Teller {
    /// First person: the opponent describes its own stroke.
    I,
    /// Second person: a hint for the player.
    You,
}

/// The name of the pocket in a corner, numbered as in the engine: "top right pocket".
pub(super) const fn pocket(corner: usize) -> &'static str {
    let pockets = [
        "bottom left pocket",
        "bottom right pocket",
        "top left pocket",
        "top right pocket",
    ];
    pockets[corner & 3]
}

/// A side of a path, as seen on the screen.
struct SideOfPath {
    /// "45° to the left".
    towards: &'static str,
    /// "20 mm to the left of its centre".
    beside: &'static str,
}

impl SideOfPath {
    /// The left or right side of a path along `heading`, as seen on the screen.
    fn of(heading: DVec2, left: bool) -> Self {
        let side = if left { 1.0 } else { -1.0 };
        let out = side * heading.perp();
        let (towards, beside) = match out.x.abs() >= out.y.abs() {
            true if out.x < 0.0 => ("to the left", "to the left of"),
            true => ("to the right", "to the right of"),
            false if out.y > 0.0 => ("upwards", "above"),
            false => ("downwards", "below"),
        };
        Self { towards, beside }
    }
}

/// The intention behind a stroke, whether it succeeded (`played` is the story of the result) and
/// the reason for the aim.
pub(super) fn plan(story: &Story, breaking: bool, played: &Story) -> String {
    let Some(hit) = &story.first_hit else {
        return "I found no coin that I could reach, so I played a quiet stroke.".to_owned();
    };
    let Some(fall) = &story.fall else {
        let why = match (breaking, played.first_hit) {
            (true, Some(_)) => "I broke the pack to spread the coins.",
            (true, None) => "I wanted to break the pack, to spread the coins.",
            (false, _) => "I saw no coin that I could count on, so I played for a better position.",
        };
        return format!("{why} {}", capital(&met(story, Teller::I)));
    };
    let goal = |fall: &Fall| (fall.coin, fall.corner);
    let came_about =
        played.fall.as_ref().map(goal) == Some(goal(fall)) && played.also >= story.also;
    let also = match story.also {
        0 => String::new(),
        1 => ", and one more piece after it".to_owned(),
        more => format!(", and {more} more pieces after it"),
    };
    let is_cut = story.is_plain_cut() && !breaking;
    let (past, infinitive) = match (is_cut, breaking) {
        (true, _) if is_full(hit) => ("played", "play"),
        (true, _) => ("cut", "cut"),
        (false, true) => ("broke the pack and sent", "break the pack and send"),
        (false, false) => ("sent", "send"),
    };
    let verb = match came_about {
        true => past.to_owned(),
        false => format!("wanted to {infinitive}"),
    };
    let met = match (is_cut, met(story, Teller::I)) {
        (true, met) => format!(": {met}"),
        (false, met) => format!(". {}", capital(&met)),
    };
    format!("I {verb} {}{also}{met}", into_pocket(fall))
}

impl Story {
    /// What fell into which pocket, in a few words; `None` if nothing fell.
    pub fn brief(&self) -> Option<String> {
        let fall = into_pocket(self.fall.as_ref()?);
        let also = match self.also {
            0 => String::new(),
            1 => ", and one more".to_owned(),
            more => format!(", and {more} more"),
        };
        Some(format!("{fall}{also}"))
    }
}

/// Which piece fell into which pocket, and how it got there if not directly.
fn into_pocket(fall: &Fall) -> String {
    let by = match fall.sent_by {
        Piece::Striker => String::new(),
        Piece::Queen => " by way of the queen".to_owned(),
        other if other == fall.piece => format!(" by way of another {other}"),
        other => format!(" by way of a {other}"),
    };
    let off = match fall.cushions {
        0 => String::new(),
        1 => " off a cushion".to_owned(),
        more => format!(" off {more} cushions"),
    };
    let (piece, pocket) = (fall.piece, pocket(fall.corner));
    format!("the {piece} into the {pocket}{by}{off}")
}

/// The first hit: the cut, the offset and the striker's path; empty if there was none.
pub(super) fn met(story: &Story, teller: Teller) -> String {
    let Some(hit) = &story.first_hit else {
        return String::new();
    };
    // The hand makes errors, so the opponent describes its intention.
    let [i_aimed, my, meets, leaves, goes, stops] = [
        ["I aimed", "aim"],
        ["my", "your"],
        ["was to meet", "meets"],
        ["was to leave", "leaves"],
        ["was to go", "will go"],
        ["was to nearly stop", "will nearly stop"],
    ]
    .map(|words| words[teller as usize]);
    let piece = hit.piece;
    let article = if piece == Piece::Queen { "the" } else { "a" };
    let other = story.fall.is_some_and(|fall| fall.coin != hit.coin);
    let before = match hit.cushions {
        0 if !other => String::new(),
        0 => format!("{my} striker {meets} {article} {piece} first: "),
        1 => format!("{my} striker {meets} {article} {piece} after one cushion: "),
        more => format!("{my} striker {meets} {article} {piece} after {more} cushions: "),
    };
    let recoil = if is_full(hit) {
        format!("a full hit sends the {piece} straight on along the line of impact.")
    } else {
        // For positive α the coin is right of the path, so the aim is left of the coin's centre.
        let right = hit.alpha > 0.0;
        format!(
            "the {piece} {leaves} along the line of impact, {} {}, so {i_aimed} {:.1} mm {} its \
             centre.",
            degrees(hit.alpha),
            SideOfPath::of(hit.heading, !right).towards,
            mm_from_m(hit.offset.abs()),
            SideOfPath::of(hit.heading, right).beside,
        )
    };
    let striker = match hit.theta1.filter(|_| hit.kept > NEARLY_STOPPED) {
        None => stops.to_owned(),
        Some(turn) if turn.abs() < FULL => format!("{goes} straight on"),
        Some(turn) if turn.abs() > PI - FULL => format!("{goes} straight back"),
        Some(turn) => {
            let side = SideOfPath::of(hit.heading, turn > 0.0);
            format!("{leaves} {} {}", degrees(turn), side.towards)
        }
    };
    format!("{before}{recoil} {} striker {striker}.", capital(my))
}

fn is_full(hit: &FirstContact) -> bool {
    hit.alpha.abs() < FULL
}

/// How reliable the stroke was, if it was tried often enough.
pub(super) fn odds(chance: Chance) -> Option<String> {
    (chance.of >= 4).then(|| {
        let of = chance.of;
        let worked = match chance.fell {
            0 => format!("none of {of} tries"),
            all if all == of => format!("all {of} tries"),
            some => format!("{some} of {of} tries"),
        };
        format!("When I imagined playing it with an unsteady hand, {worked} worked.")
    })
}

impl Slip {
    /// The error in a stroke along `heading`, in one sentence that begins with `stroke`, for
    /// example "My stroke".
    pub(crate) fn in_words(self, stroke: &str, heading: DVec2) -> String {
        let turned = self.turn.atan();
        let percent = (100.0 * self.push).round();
        let direction = (turned.abs() >= SMALLEST_SLIP).then(|| {
            let side = SideOfPath::of(heading, turned > 0.0);
            format!("{} off {}", degrees(turned), side.towards)
        });
        let strength = (percent != 0.0).then(|| {
            let way = if percent > 0.0 { "hard" } else { "soft" };
            format!("{:.0} % too {way}", percent.abs())
        });
        let slips: Vec<String> = direction.into_iter().chain(strength).collect();
        if slips.is_empty() {
            return format!("{stroke} was just right.");
        }
        format!("{stroke} was {}.", slips.join(" and "))
    }
}

/// The size of an angle: in tenths of a degree below 10°, in whole degrees above.
fn degrees(angle: f64) -> String {
    let size = deg_from_rad(angle.abs());
    if size < 9.95 {
        format!("{size:.1}°")
    } else {
        format!("{size:.0}°")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::laws::Rules;
    use crate::game::{Coin, Game, GameSetup, PieceSet};
    use crate::physics::units::rad_from_deg;
    use crate::physics::{Board, Limits, Motion, play};

    fn coin(piece: Piece, x_mm: f64, y_mm: f64) -> Coin {
        Coin {
            piece,
            at: DVec2::new(x_mm, y_mm) / 1000.0,
        }
    }

    fn described(coins: &[Coin], set: PieceSet, striker: Motion) -> String {
        let mut game = Game::new(GameSetup {
            rules: Rules::Practice,
            set,
            ..GameSetup::default()
        });
        game.lay_out(coins.to_vec()).unwrap();
        let (discs, motions) = game.discs(striker);
        let shot = play(&Board::default(), &discs, &motions, Limits::default());
        let story = Story::of(&game, &shot.unwrap());
        plan(&story, false, &story)
    }

    /// A stroke along +y that meets a coin at (100, 100) mm at `alpha_deg`.
    fn at_angle(set: PieceSet, alpha_deg: f64, speed: f64) -> Motion {
        let reach = set.striker_radius() + set.coin_radius();
        let offset = reach * rad_from_deg(alpha_deg).sin();
        Motion {
            position: DVec2::new(0.1 - offset, -0.2),
            velocity: DVec2::Y * speed,
        }
    }

    #[test]
    fn a_cut_is_described_with_its_angles() {
        // Up the board, 45° to the right: along the diagonal into the top right pocket.
        let target = [coin(Piece::White, 100.0, 100.0)];
        let set = PieceSet::EqualMass;
        assert_eq!(
            described(&target, set, at_angle(set, 45.0, 2.0)),
            "I cut the white coin into the top right pocket: the white coin was to leave along \
             the line of impact, 45° to the right, so I aimed 25.8 mm to the left of its \
             centre. My striker was to leave 45° to the left."
        );
        // 15 g on 5.5 g: tan θ₁ = k sin α cos α / (1 − k cos²α) with k = 11/20.5,
        // which is 20.1° at 45°.
        let set = PieceSet::Tournament;
        let words = described(&target, set, at_angle(set, 45.0, 2.0));
        assert!(
            words.ends_with("My striker was to leave 20° to the left."),
            "{words}"
        );
    }

    #[test]
    fn a_full_hit_a_combination_and_a_miss_are_described() {
        let set = PieceSet::EqualMass;
        let diagonal = Motion {
            position: DVec2::splat(-0.1),
            velocity: DVec2::splat(1.5),
        };
        let one = [coin(Piece::Queen, 100.0, 100.0)];
        assert_eq!(
            described(&one, set, diagonal),
            "I played the queen into the top right pocket: a full hit sends the queen \
             straight on along the line of impact. My striker was to nearly stop."
        );
        let two = [
            coin(Piece::Black, 50.0, 50.0),
            coin(Piece::White, 150.0, 150.0),
        ];
        assert_eq!(
            described(&two, set, diagonal),
            "I sent the white coin into the top right pocket by way of a black coin. My \
             striker was to meet a black coin first: a full hit sends the black coin straight \
             on along the line of impact. My striker was to nearly stop."
        );
        let aside = [coin(Piece::Black, -300.0, 0.0)];
        assert_eq!(
            described(&aside, set, diagonal),
            "I found no coin that I could reach, so I played a quiet stroke."
        );
    }

    #[test]
    fn a_failed_stroke_is_described_as_an_intention() {
        let hit = FirstContact {
            coin: 0,
            piece: Piece::White,
            cushions: 0,
            heading: DVec2::Y,
            alpha: 0.5,
            offset: 0.02,
            theta1: None,
            kept: 0.0,
        };
        let fall = Fall {
            coin: 0,
            piece: Piece::White,
            corner: 3,
            sent_by: Piece::Striker,
            cushions: 0,
        };
        let meant = Story {
            first_hit: Some(hit),
            fall: Some(fall),
            also: 0,
        };
        let other = |corner| Story {
            fall: Some(Fall { corner, ..fall }),
            ..meant
        };
        let first = |meant: &Story, breaking, played: &Story| {
            let described = plan(meant, breaking, played);
            described
                .split([':', '.'])
                .next()
                .unwrap_or_default()
                .to_owned()
        };
        let at = "the white coin into the top right pocket";
        assert_eq!(first(&meant, false, &other(3)), format!("I cut {at}"));
        for missed in [Story::default(), other(2)] {
            let wanted = format!("I wanted to cut {at}");
            assert_eq!(first(&meant, false, &missed), wanted);
            let wanted = format!("I wanted to break the pack and send {at}");
            assert_eq!(first(&meant, true, &missed), wanted);
        }
        let spread = Story {
            fall: None,
            ..meant
        };
        let wanted = "I wanted to break the pack, to spread the coins";
        assert_eq!(first(&spread, true, &Story::default()), wanted);
        let broke = "I broke the pack to spread the coins";
        assert_eq!(first(&spread, true, &spread), broke);
    }

    #[test]
    fn sides_are_those_of_the_screen_for_every_seat() {
        // The strokes go up the board from South, down it from North and across it from East.
        for (heading, left, right) in [
            (DVec2::Y, "to the left of", "to the right of"),
            (DVec2::NEG_Y, "to the right of", "to the left of"),
            (DVec2::NEG_X, "below", "above"),
        ] {
            let turned = DVec2::from_angle(0.3).rotate(heading);
            assert_eq!(SideOfPath::of(turned, true).beside, left);
            assert_eq!(SideOfPath::of(turned, false).beside, right);
        }
        for (corner, at) in Board::default().pockets().enumerate() {
            let row = if at.y > 0.0 { "top" } else { "bottom" };
            let column = if at.x > 0.0 { "right" } else { "left" };
            assert_eq!(pocket(corner), format!("{row} {column} pocket"));
        }
    }

    #[test]
    fn only_a_noticeable_slip_is_described() {
        let slip = |turn_deg: f64, push| {
            let turn = rad_from_deg(turn_deg).tan();
            Slip { turn, push }.in_words("My stroke", DVec2::Y)
        };
        assert_eq!(slip(0.0, 0.0), "My stroke was just right.");
        assert_eq!(slip(-1.24, 0.001), "My stroke was 1.2° off to the right.");
        assert_eq!(slip(0.01, -0.05), "My stroke was 5 % too soft.");
        assert_eq!(
            slip(12.0, 0.2),
            "My stroke was 12° off to the left and 20 % too hard."
        );
    }
}

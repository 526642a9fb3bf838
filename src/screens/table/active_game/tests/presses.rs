//! Counts the key presses that set a stroke.
//!
//! A computer player chooses each stroke of whole boards. A person who intends the same stroke
//! begins with the aim that the screen shows at the start of the turn, and sets the position, the
//! direction and the strength, in this order, with the keys that need the fewest presses. The
//! screen carries out every press, and the stroke that was set is played.

use std::collections::HashSet;

use super::*;
use crate::game::opponent::{self, Strength};
use crate::game::{GameStage, Strike};
use crate::screens::Settings;
use crate::screens::table::aim::{SPEEDS, along_the_screen};
use crate::widgets::input::EntryAction;

/// The tolerances within which a stroke counts as set: in metres, degrees and m/s. On a straight
/// path to a disc, the intended direction runs from the striker's position, as set with the keys,
/// to its position at the first contact.
const NEAR: (f64, f64, f64) = (0.001, 0.1, 0.05);
/// A margin for rounding errors in the tolerances.
const ROUNDING: f64 = 1e-9;
/// The smallest number of strokes to measure: as many as in the first measurement.
const STROKES: usize = 660;

const PLACES: [AimAction; 4] = [
    AimAction::Place(1),
    AimAction::Place(-1),
    AimAction::Place(10),
    AimAction::Place(-10),
];
const DIRECTIONS: [AimAction; 8] = [
    AimAction::NextShot(1),
    AimAction::NextShot(-1),
    AimAction::Turn(1),
    AimAction::Turn(-1),
    AimAction::Turn(10),
    AimAction::Turn(-10),
    AimAction::TurnFar(1),
    AimAction::TurnFar(-1),
];
const STRENGTHS: [AimAction; 4] = [
    AimAction::Strength(1),
    AimAction::Strength(-1),
    AimAction::Strength(10),
    AimAction::Strength(-10),
];

/// The aim after an action.
fn after(game: &mut ActiveGame, aim: Aim, action: AimAction, cx: &Context) -> Aim {
    game.aim = aim;
    game.aim_by(action, cx);
    game.aim
}

/// Types a number, then presses the given key. Returns the number of presses if that sets the aim.
fn typed(
    game: &mut ActiveGame,
    number: &str,
    last: AimAction,
    reached: impl Fn(&ActiveGame) -> bool,
    cx: &Context,
) -> Option<usize> {
    for digit in number.chars() {
        game.aim_by(AimAction::Number(EntryAction::Type(digit)), cx);
    }
    game.aim_by(last, cx);
    reached(game).then_some(number.chars().count() + 1)
}

/// A number without the zeros that need not be typed.
fn shortest(number: f64) -> String {
    let text = format!("{number:.1}");
    let text = text.strip_suffix(".0").unwrap_or(&text);
    text.strip_prefix("0.")
        .map_or(text.to_owned(), |tenths| format!(".{tenths}"))
}

/// Sets part of the aim with the fewest presses: with `keys` only, or by typing a number, if that
/// needs fewer. Returns the number of presses.
fn set(
    game: &mut ActiveGame,
    keys: &[AimAction],
    (number, last): (String, AimAction),
    reached: impl Fn(&ActiveGame) -> bool,
    cx: &Context,
) -> usize {
    let begun = game.aim;
    let by_typing = typed(game, &number, last, &reached, cx);
    let set = game.aim;
    // Each round adds one press.
    let mut aims = vec![begun];
    let mut seen = HashSet::new();
    for presses in 0..by_typing.unwrap_or(usize::MAX) {
        for aim in &aims {
            game.aim = *aim;
            if reached(game) {
                return presses;
            }
        }
        let mut next = Vec::new();
        for aim in &aims {
            for key in keys {
                let aim = after(game, *aim, *key, cx);
                let seat = game.seat();
                let parts = [aim.place.x, aim.place.y, aim.shown_deg(seat), aim.speed];
                if seen.insert(parts.map(f64::to_bits)) {
                    next.push(aim);
                }
            }
        }
        if next.is_empty() {
            break;
        }
        aims = next;
    }
    game.aim = set;
    by_typing.expect("a stroke that keys can set")
}

/// The numbers of presses that set the position, the direction and the strength of a stroke.
fn presses(game: &mut ActiveGame, meant: &Strike, cx: &Context) -> [usize; 3] {
    let seat = game.seat();
    let along = along_the_screen(seat, game.game().setup().rules).dot(meant.place) * 1000.0;
    let last = AimAction::Place(if along < 0.0 { -1 } else { 1 });
    let reached = |game: &ActiveGame| {
        game.aim.place.distance(meant.place) <= NEAR.0 + ROUNDING
            && game.game().check_place(game.aim.place).is_ok()
    };
    let typed = (shortest(along.abs().round()), last);
    let place = set(game, &PLACES, typed, reached, cx);

    // With a straight path to a disc, the player intends a point of contact; off a cushion, a
    // direction.
    let preview = Preview::of(meant, game.game());
    let contact = preview
        .filter(|it| it.way.len() == 2)
        .and_then(|it| it.hit.ok());
    let way = contact.map_or(meant.velocity, |hit| hit.ghost() - game.aim.place);
    let mut wanted = game.aim;
    wanted.point_at(wanted.place + way, seat);
    let enter = AimAction::Number(EntryAction::Enter);
    let direction = set(
        game,
        &DIRECTIONS,
        (shortest(wanted.shown_deg(seat)), enter),
        |game| game.aim.heading(seat).angle_to(way).abs() <= (NEAR.1 + 0.005).to_radians(),
        cx,
    );

    let speed = meant.velocity.length().max(SPEEDS.0);
    let strength = set(
        game,
        &STRENGTHS,
        (shortest(speed), AimAction::Strength(1)),
        |game| (game.aim.speed - speed).abs() <= NEAR.2 + ROUNDING,
        cx,
    );
    [place, direction, strength]
}

/// The presses for each stroke of whole boards between computer players.
fn script() -> Vec<[usize; 3]> {
    let cx = Context::new(Settings::default(), 1);
    let mut script = Vec::new();
    for seed in 1.. {
        let mut game = ActiveGame::new(Options::two_people(), seed);
        while matches!(game.game().stage(), GameStage::Playing) {
            let strengths = [Strength::Beginner, Strength::Regular, Strength::Club];
            let strength = strengths[seed as usize % strengths.len()];
            let number = script.len() as u64;
            let Some(decision) = opponent::think(game.game(), strength, number) else {
                game.pass();
                continue;
            };
            // Next to a coin or a base circle, the computer can put the striker between two steps.
            let lines = game.game().base_lines();
            let meant = Strike {
                place: lines.nearest_on_steps(decision.meant.position).unwrap(),
                velocity: decision.meant.velocity,
                call: None,
            };
            script.push(presses(&mut game, &meant, &cx));
            let set = game.aim.strike(game.seat());
            game.make(Move::Strike(set)).unwrap();
        }
        if script.len() >= STROKES {
            break;
        }
    }
    script
}

/// The median and the 90th percentile.
fn quantiles(mut counts: Vec<usize>) -> (usize, usize) {
    counts.sort_unstable();
    let at = |share: usize| counts[(counts.len() - 1) * share / 100];
    (at(50), at(90))
}

#[test]
fn half_of_all_strokes_are_set_and_struck_with_twelve_presses() {
    let script = script();
    let names = ["place", "direction", "strength"];
    for (part, name) in names.into_iter().enumerate() {
        let (median, p90) = quantiles(script.iter().map(|it| it[part]).collect());
        println!("{name:10} {median:3} {p90:3}");
    }
    // One more press strikes.
    let (median, p90) = quantiles(
        script
            .iter()
            .map(|it| it.iter().sum::<usize>() + 1)
            .collect(),
    );
    println!(
        "{:10} {median:3} {p90:3}  ({} strokes)",
        "stroke",
        script.len()
    );
    assert!(script.len() >= STROKES);
    assert!(median <= 12 && p90 <= 20, "{median} {p90}");
}

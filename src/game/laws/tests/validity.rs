//! Detects states that no game can have; the other tests use it to check games.

use glam::DVec2;

use super::super::ending::MOST_POINTS;
use super::super::points::QUEEN;
use super::super::{BoardWon, Rules};
use crate::game::score::Score;
use crate::game::validity::check_coins;
use crate::game::{Coin, Colour, Game, GameSetup, Hands, Piece, Seat, Team};

/// The total number of points on a board of point carrom.
pub(super) const ALL_POINTS: u8 = 9 * 2 + 9 + QUEEN;

/// The first inconsistency of a game, if there is any.
pub(super) fn flaw(game: &Game) -> Option<&'static str> {
    let (play, setup) = (game.play(), game.setup());
    if check_coins(game.coins(), setup.set).is_err() {
        return Some("coins cannot be at these positions");
    }
    if !(setup.hands.plays(play.seat) && setup.hands.plays(setup.first_breaker)) {
        return Some("nobody sits at the seat whose turn it is");
    }
    if play.queen_on_board() && play.queen_covered_by.is_some() {
        return Some("the queen cannot be covered while she is on the board");
    }
    for team in Team::BOTH {
        let colour = game.colour(team);
        if play.owed[team] > 0 && play.in_pockets(colour) > 0 {
            return Some("a coin is owed although there is one to pay with");
        }
        let cleared = play.on_board(colour) == 0;
        let ends = !matches!(setup.rules, Rules::Points | Rules::Practice);
        if cleared && play.won.is_none() && ends {
            return Some("a colour has no coins left, yet the board has not ended");
        }
    }
    let mut boards = game.finished.iter().chain(game.play.won.as_ref());
    let most = match setup.rules {
        Rules::Points => ALL_POINTS,
        _ => MOST_POINTS,
    };
    if boards.any(|won| won.points > most) {
        return Some("a board is worth at most 12 points, or 32 in point carrom");
    }
    if setup.rules == Rules::Points {
        let taken: u8 = Team::BOTH.iter().map(|team| play.points_taken(*team)).sum();
        let left = play.on_board(Colour::White) * 2 + play.on_board(Colour::Black);
        let queen = match play.queen_covered_by {
            Some(_) => 0,
            None => QUEEN,
        };
        if taken + left + queen != ALL_POINTS {
            return Some("points have appeared or vanished");
        }
    }
    let ended = |played: usize| {
        let score = Score::after(setup, game.finished.iter().take(played));
        score.match_winner(setup).is_some()
    };
    let on = (1..=game.finished.len()).any(ended);
    on.then_some("a board was played after the match had ended")
}

fn spoilt(spoil: impl FnOnce(&mut Game)) -> &'static str {
    let mut game = Game::new(GameSetup::default());
    assert_eq!(flaw(&game), None);
    spoil(&mut game);
    flaw(&game).unwrap_or("none")
}

#[test]
fn impossible_games_are_detected() {
    let white = |at| Coin {
        piece: Piece::White,
        at,
    };
    let won = |points| BoardWon {
        winner: Team::First,
        points,
    };
    let found = [
        spoilt(|game| game.play.coins.push(white(DVec2::splat(0.2)))),
        spoilt(|game| game.play.coins[3].at = game.play.coins[4].at),
        spoilt(|game| game.play.coins[3].at.y = f64::NAN),
        spoilt(|game| game.play.seat = Seat::East),
        spoilt(|game| game.play.queen_covered_by = Some(Team::Second)),
        spoilt(|game| {
            game.play.coins.pop();
            game.play.owed[Team::Second] = 1;
        }),
        spoilt(|game| game.play.coins.retain(|coin| coin.piece != Piece::Black)),
        spoilt(|game| game.play.won = Some(won(13))),
        spoilt(|game| game.finished = vec![won(12); 6]),
    ];
    let words = [
        "positions",
        "positions",
        "positions",
        "sits",
        "queen",
        "owed",
        "ended",
        "12",
        "after",
    ];
    for (flaw, word) in found.iter().zip(words) {
        assert!(flaw.contains(word), "{flaw}: {word}");
    }
}

#[test]
fn in_doubles_any_seat_may_break_and_in_singles_only_two() {
    for seat in Seat::ALL {
        for hands in [Hands::Two, Hands::Four] {
            let game = Game::new(GameSetup {
                hands,
                first_breaker: seat,
                ..GameSetup::default()
            });
            assert_eq!(flaw(&game), None);
            assert_eq!(hands.plays(seat), game.seat() == seat);
        }
    }
}

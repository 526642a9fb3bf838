//! Laws that rarely apply, each tested with a complete game in which it does. The games are files
//! in `tests/saves/laws`, and `carrom replay FILE` shows them.

use carrom::game::{BoardWon, Game, RulingEffect, SavedGame, Team};

/// The game before and after the last move of a file, the laws that the referee cited for this
/// move, and the end of the board.
fn end_of(name: &str, bytes: &[u8]) -> (Game, Game, Vec<String>, BoardWon) {
    let (saved, after) = SavedGame::read(name, bytes).unwrap();
    let mut last = None;
    let each = |before, _: &_, _, rulings| last = Some((before, rulings));
    saved.record.play_through(each).unwrap();
    let (before, rulings): (Game, Vec<carrom::game::Ruling>) = last.unwrap();
    let laws = rulings.iter().filter_map(|ruling| ruling.law);
    let laws = laws.map(|law| law.to_string()).collect();
    let won = rulings.iter().flat_map(|ruling| &ruling.effects);
    let mut won = won.filter_map(|effect| match effect {
        RulingEffect::BoardWon(won) => Some(*won),
        _ => None,
    });
    let won = won.next_back().unwrap();
    (before, after, laws, won)
}

#[test]
fn the_queen_brings_no_points_from_22_points_on() {
    let file = include_bytes!("../saves/laws/queen-at-22.toml");
    let (before, after, laws, won) = end_of("queen-at-22.toml", file);
    assert!(before.score().points[won.winner] >= 22);
    assert_eq!(after.play().queen_covered_by, Some(won.winner));
    let left = after.play().on_board(after.colour(won.winner.other()));
    assert_eq!(won.points, left, "the coins alone");
    assert!(laws.contains(&"25a".to_owned()), "{laws:?}");
}

#[test]
fn after_eight_boards_the_leader_has_won_the_game() {
    let file = include_bytes!("../saves/laws/eight-boards.toml");
    let (_, after, laws, _) = end_of("eight-boards.toml", file);
    let score = after.score();
    assert_eq!(score.boards, 8);
    assert!(Team::BOTH.iter().all(|team| score.points[*team] < 25));
    assert!(laws.contains(&"29a".to_owned()), "{laws:?}");
}

#[test]
fn queen_and_both_last_coins_in_one_stroke_win() {
    let file = include_bytes!("../saves/laws/law-77a.toml");
    let (before, _, laws, won) = end_of("law-77a.toml", file);
    assert_eq!(laws, ["77a"]);
    assert_eq!((won.winner, won.points), (before.team(before.seat()), 3));
}

#[test]
fn both_last_coins_with_the_queen_on_the_board_lose() {
    let file = include_bytes!("../saves/laws/law-78a.toml");
    let (before, _, laws, won) = end_of("law-78a.toml", file);
    assert_eq!(laws, ["78a"]);
    let striker = before.team(before.seat());
    assert_eq!((won.winner, won.points), (striker.other(), 3));
}

use super::laying::{Queen, Table, expect, expect_end, lay};
use crate::game::laws::{Rules, RulingEffect, Taken};
use crate::game::pieces::Piece;
use crate::game::score::Length;
use crate::game::seat::Team;
use crate::game::table::{Game, GameSetup, GameStage};

use Piece::{Black, Queen as Red, Striker, White};

fn points(white: u8, black: u8, queen: Queen) -> Table {
    lay(Rules::Points, white, black, queen)
}

/// A board on which North has pocketed everything so far.
fn points_of_north(white: u8, black: u8, queen: Queen) -> Table {
    let mut table = points(white, black, queen);
    let play = &mut table.0.play;
    (play.taken[Team::First], play.taken[Team::Second]) = Default::default();
    play.taken[Team::Second] = Taken::default().with(9 - white, 9 - black);
    table
}

#[test]
fn either_colour_counts_and_keeps_the_turn() {
    let mut table = points(9, 9, Queen::OnBoard);
    let rulings = table.pocket(&[Black]);
    expect(&table, &rulings, "house", &[], true);
    let rulings = table.pocket(&[White, Black]);
    expect(&table, &rulings, "house", &[], true);
    assert_eq!(
        rulings[0].text,
        "Two coins fell, which makes 4 points, so the turn continues."
    );
    assert_eq!(table.0.points()[Team::First], 4);
    let rulings = table.pocket(&[]);
    expect(&table, &rulings, "house", &[], false);
    // The other side, too, may pocket either colour.
    table.pocket(&[White]);
    assert_eq!(table.0.points()[Team::Second], 2);
    assert_eq!(table.0.points()[Team::First], 4);
}

#[test]
fn the_striker_costs_a_white_coin_if_there_is_one_and_nothing_stays_owed() {
    let mut table = points(8, 8, Queen::OnBoard);
    let rulings = table.pocket(&[Striker]);
    expect(&table, &rulings, "house", &[White], false);
    assert_eq!(
        rulings[0].text,
        "The striker fell and one white coin goes back, which leaves 1 point, so the turn passes."
    );
    assert_eq!(table.0.points()[Team::First], 1);
    let mut black = points(9, 8, Queen::OnBoard);
    let rulings = black.pocket(&[Striker]);
    expect(&black, &rulings, "house", &[Black], false);
    let mut none = points(9, 9, Queen::OnBoard);
    let rulings = none.pocket(&[Striker]);
    expect(&none, &rulings, "house", &[], false);
    assert_eq!(none.0.play().owed[Team::First], 0);
}

#[test]
fn the_queen_counts_five_points_once_any_coin_covers_her() {
    let mut table = points(9, 9, Queen::OnBoard);
    let rulings = table.pocket(&[Red]);
    expect(&table, &rulings, "house", &[], true);
    assert!(table.0.play().queen_to_cover());
    assert_eq!(table.0.points()[Team::First], 0);
    let rulings = table.pocket(&[Black]);
    expect(&table, &rulings, "house", &[], true);
    assert_eq!(table.0.points()[Team::First], 6);

    let mut missed = points(9, 9, Queen::ToCover);
    let rulings = missed.pocket(&[]);
    expect(&missed, &rulings, "house", &[Red], false);
    let mut sunk = points(9, 8, Queen::ToCover);
    let rulings = sunk.pocket(&[Black, Striker]);
    expect(&sunk, &rulings, "house", &[Red, Black], false);
}

#[test]
fn seventeen_points_win_the_game() {
    // South has six white coins and four black ones: 16 points.
    let mut table = points(3, 5, Queen::OnBoard);
    assert_eq!(table.0.points()[Team::First], 16);
    let rulings = table.pocket(&[Black]);
    expect_end(&rulings, "house", Team::First, 17);
    assert_eq!(table.0.stage(), GameStage::GameOver(Team::First));
    assert!(
        rulings[0].text.contains("won by 17 points to 0"),
        "{}",
        rulings[0].text
    );
    table.0.next_board().unwrap();
    assert_eq!(table.0.points()[Team::First], 0);
    assert_eq!(table.0.score().games[Team::First], 1);

    // If the striker falls with two white coins, one of them goes back.
    let mut sunk = points(3, 5, Queen::OnBoard);
    let rulings = sunk.pocket(&[White, White, Striker]);
    expect_end(&rulings, "house", Team::First, 18);
    assert_eq!(sunk.0.points()[Team::First], 18);
    let mut back = points(3, 5, Queen::OnBoard);
    let rulings = back.pocket(&[White, Striker]);
    expect(&back, &rulings, "house", &[White], false);
}

#[test]
fn the_last_piece_needs_no_cover_and_the_queen_decides_a_tie() {
    // South has 11 points and takes the queen last: 16 to 16.
    let mut table = points_of_north(0, 0, Queen::OnBoard);
    table.0.play.taken[Team::First] = Taken { white: 2, black: 7 };
    table.0.play.taken[Team::Second] = Taken { white: 7, black: 2 };
    let rulings = table.pocket(&[Red]);
    expect_end(&rulings, "house", Team::First, 16);
    assert!(
        rulings[0]
            .effects
            .contains(&RulingEffect::QueenCovered(crate::game::Colour::White))
    );

    // North has the queen and 16 points; South pockets the last coin.
    let mut table = points_of_north(0, 1, Queen::Black);
    table.0.play.taken[Team::First] = Taken { white: 7, black: 1 };
    table.0.play.taken[Team::Second] = Taken { white: 2, black: 7 };
    expect_end(&table.pocket(&[Black]), "house", Team::Second, 16);
}

#[test]
fn a_missed_break_passes_the_turn_and_one_board_is_a_whole_game() {
    let mut table = Table(Game::new(GameSetup {
        rules: Rules::Points,
        length: Length::Board,
        ..GameSetup::default()
    }));
    table.strike(false, &[]);
    assert!(!table.turn_continues());
    let mut table = points(3, 5, Queen::OnBoard);
    table.0.setup.length = Length::Board;
    table.pocket(&[White]);
    assert_eq!(table.0.stage(), GameStage::MatchOver(Team::First));
}

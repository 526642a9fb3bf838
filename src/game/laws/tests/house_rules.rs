use glam::DVec2;

use super::laying::{Queen, Table, expect, expect_end, lay};
use crate::game::laws::Rules;
use crate::game::pieces::{Coin, Colour, Piece};
use crate::game::seat::{Seat, Team};
use crate::game::table::{Game, GameSetup, GameStage};
use crate::game::validity::GameError;

use Piece::{Black, Striker, White};

fn friendly(white: u8, black: u8, queen: Queen) -> Table {
    lay(Rules::Friendly, white, black, queen)
}

#[test]
fn friendly_ones_own_coins_keep_the_turn_and_others_do_not() {
    let mut table = friendly(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[White]);
    expect(&table, &rulings, "house", &[], true);
    let rulings = table.pocket(&[Black]);
    expect(&table, &rulings, "house", &[], false);
}

#[test]
fn friendly_the_striker_costs_one_coin_and_the_turn_and_nothing_stays_owed() {
    let mut table = friendly(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[Striker, White]);
    expect(&table, &rulings, "house", &[White], false);
    assert_eq!(table.on_board(Colour::White), 5);

    let mut full = friendly(9, 9, Queen::OnBoard);
    let rulings = full.pocket(&[Striker]);
    expect(&full, &rulings, "house", &[], false);
    assert_eq!(full.0.play().owed[Team::First], 0);
}

#[test]
fn friendly_the_queen_may_be_taken_first_and_must_be_covered() {
    let mut table = friendly(9, 9, Queen::OnBoard);
    let rulings = table.pocket(&[Piece::Queen]);
    expect(&table, &rulings, "house", &[], true);
    assert!(table.0.play().queen_to_cover());
    let rulings = table.pocket(&[White]);
    expect(&table, &rulings, "house", &[], true);
    assert_eq!(table.0.play().queen_covered_by, Some(Team::First));

    let mut missed = friendly(9, 9, Queen::ToCover);
    let rulings = missed.pocket(&[]);
    expect(&missed, &rulings, "house", &[Piece::Queen], false);
    let mut sunk = friendly(5, 9, Queen::ToCover);
    let rulings = sunk.pocket(&[Striker, White]);
    expect(&sunk, &rulings, "house", &[Piece::Queen, White], false);
}

#[test]
fn friendly_announces_the_coins_of_the_other_side_and_what_goes_back() {
    let said = |mut table: Table, fell: &[Piece]| table.pocket(fell)[0].text.clone();
    assert_eq!(
        said(friendly(9, 9, Queen::OnBoard), &[Black]),
        "White pocketed none of its coins, so the turn passes. One black coin fell and stays down."
    );
    assert_eq!(
        said(friendly(9, 9, Queen::OnBoard), &[White, Black, Black]),
        "White pocketed one white coin, so the turn continues. Two black coins fell and stay down."
    );
    assert_eq!(
        said(friendly(9, 9, Queen::OnBoard), &[Striker]),
        "The striker fell and White has no coin to put back. The turn passes."
    );
    assert_eq!(
        said(friendly(5, 9, Queen::ToCover), &[Striker]),
        "The striker fell, so the queen and one of White's coins go back. The turn passes."
    );
}

#[test]
fn friendly_first_to_clear_wins_the_board() {
    let mut table = friendly(1, 4, Queen::White);
    let rulings = table.pocket(&[White]);
    expect_end(&rulings, "house", Team::First, 7);
    assert_eq!(rulings.len(), 1, "the board is the game");
    assert_eq!(table.0.stage(), GameStage::GameOver(Team::First));
    table.0.next_board().unwrap();
    assert_eq!(table.0.seat(), Seat::North, "the other side breaks");

    let mut left = friendly(1, 4, Queen::OnBoard);
    expect_end(&left.pocket(&[White]), "house", Team::First, 4);
    let mut given = friendly(4, 1, Queen::Black);
    expect_end(&given.pocket(&[Black]), "house", Team::Second, 7);
    let mut covered = friendly(1, 4, Queen::OnBoard);
    expect_end(
        &covered.pocket(&[White, Piece::Queen]),
        "house",
        Team::First,
        7,
    );
}

#[test]
fn friendly_clearing_both_colours_at_once_wins_by_a_point() {
    let mut table = friendly(1, 1, Queen::OnBoard);
    let rulings = table.pocket(&[White, Black]);
    expect_end(&rulings, "house", Team::First, 1);
    assert_eq!(table.0.stage(), GameStage::GameOver(Team::First));
}

#[test]
fn friendly_the_last_coin_with_the_striker_comes_back() {
    let mut table = friendly(1, 4, Queen::White);
    let rulings = table.pocket(&[White, Striker]);
    expect(&table, &rulings, "house", &[White], false);
    let mut both = friendly(1, 1, Queen::White);
    expect_end(
        &both.pocket(&[White, Black, Striker]),
        "house",
        Team::Second,
        1,
    );
}

#[test]
fn friendly_a_missed_break_passes_the_turn() {
    let mut table = Table(Game::new(GameSetup {
        rules: Rules::Friendly,
        ..GameSetup::default()
    }));
    table.strike(false, &[]);
    assert_eq!(table.0.seat(), Seat::North);
}

fn practice() -> Table {
    Table(Game::new(GameSetup {
        rules: Rules::Practice,
        ..GameSetup::default()
    }))
}

#[test]
fn in_a_practice_game_nothing_costs_anything() {
    let mut table = practice();
    let falls: [&[Piece]; 4] = [&[], &[Striker], &[Piece::Queen, Striker], &[Black]];
    for fallen in falls {
        let rulings = table.pocket(fallen);
        expect(&table, &rulings, "house", &[], true);
    }
    assert_eq!(table.0.seat(), Seat::South);
}

#[test]
fn in_a_practice_game_the_striker_and_the_coins_may_be_placed_anywhere() {
    let mut table = practice();
    assert!(table.0.check_place(DVec2::new(0.2, 0.2)).is_ok());
    assert!(table.0.check_place(DVec2::ZERO).is_err());
    let coin = |x| Coin {
        piece: White,
        at: DVec2::new(x, 0.0),
    };
    table.0.lay_out(vec![coin(0.1), coin(0.2)]).unwrap();
    assert_eq!(table.0.coins().len(), 2);
    assert_eq!(
        table.0.lay_out(vec![coin(0.1), coin(0.11)]),
        Err(GameError::Overlap)
    );
    assert_eq!(
        table.0.lay_out(vec![coin(0.4)]),
        Err(GameError::OffTheBoard)
    );
    assert!(matches!(
        table.0.lay_out(vec![coin(f64::NAN); 10]),
        Err(GameError::TooMany { found: 10, .. })
    ));
    expect_end(&table.pocket(&[White, White]), "house", Team::First, 0);
    table.0.next_board().unwrap();
    assert_eq!(table.0.coins().len(), 19);
    assert_eq!(
        friendly(5, 5, Queen::OnBoard).0.lay_out(vec![]),
        Err(GameError::NotInPractice)
    );
}

#[test]
fn in_a_game_the_striker_keeps_to_its_base_lines() {
    let table = friendly(5, 5, Queen::OnBoard);
    let lines = table.0.base_lines();
    assert!(table.0.check_place(lines.at(0.1)).is_ok());
    assert!(table.0.check_place(DVec2::new(0.0, -0.1)).is_err());
}

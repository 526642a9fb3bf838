use glam::DVec2;

use super::laying::{Queen, cited, expect, table};
use crate::game::laws::RulingEffect;
use crate::game::pieces::{Colour, Piece};
use crate::game::seat::Team;

use Piece::{Black, Striker, White};
const QUEEN: Piece = Piece::Queen;

#[test]
fn law_65_the_queen_may_be_taken_after_a_coin_of_ones_own_and_must_be_covered() {
    let mut table = table(8, 9, Queen::OnBoard);
    let rulings = table.pocket(&[QUEEN]);
    expect(&table, &rulings, "65", &[], true);
    assert_eq!(rulings[0].effects.last(), Some(&RulingEffect::MustCover));
    assert!(table.0.play().queen_to_cover());
}

#[test]
fn law_65_a_coin_of_ones_own_in_the_next_stroke_covers_her() {
    let mut table = table(8, 9, Queen::ToCover);
    let rulings = table.pocket(&[White]);
    expect(&table, &rulings, "65", &[], true);
    assert_eq!(table.0.play().queen_covered_by, Some(Team::First));
}

#[test]
fn law_66_she_goes_back_to_the_exact_centre() {
    let mut table = table(8, 9, Queen::ToCover);
    table.pocket(&[]);
    let queen = table.0.coins().last().unwrap();
    assert_eq!((queen.piece, queen.at), (QUEEN, DVec2::ZERO));
}

#[test]
fn law_68a_the_queen_pocketed_before_any_coin_of_ones_own_comes_back_and_costs_the_turn() {
    let mut table = table(9, 9, Queen::OnBoard);
    let rulings = table.pocket(&[QUEEN]);
    expect(&table, &rulings, "68a", &[QUEEN], false);
}

#[test]
fn law_68a_an_opponents_coin_with_her_gives_no_right_and_stays_down() {
    let mut table = table(9, 9, Queen::OnBoard);
    let rulings = table.pocket(&[QUEEN, Black]);
    expect(&table, &rulings, "68a", &[QUEEN], false);
    assert_eq!(
        rulings[0].announced(),
        "White had not pocketed a coin of its own before the queen, so she goes back and the turn \
         passes (law 68a). One black coin fell and stays down."
    );
    assert_eq!(table.on_board(Colour::Black), 8);
}

#[test]
fn law_68b_the_queen_pocketed_while_a_coin_is_owed_comes_back_and_costs_the_turn() {
    let mut table = table(9, 9, Queen::OnBoard).white_owes(1);
    let rulings = table.pocket(&[QUEEN, White, White]);
    expect(&table, &rulings, "68b", &[QUEEN, White], false);
    assert_eq!(cited(&rulings), ["68b", "51a"]);
    assert_eq!(table.on_board(Colour::White), 8);
}

#[test]
fn law_68b_with_the_striker_another_due_is_added() {
    let mut table = table(9, 9, Queen::OnBoard).white_owes(1);
    let rulings = table.pocket(&[QUEEN, Striker]);
    expect(&table, &rulings, "68b", &[QUEEN], false);
    assert_eq!(table.0.play().owed[Team::First], 2);
}

#[test]
fn law_68b_ones_coins_that_fell_with_queen_and_striker_come_back_and_pay_nothing() {
    let mut table = table(9, 9, Queen::OnBoard).white_owes(1);
    let rulings = table.pocket(&[QUEEN, White, Striker]);
    expect(&table, &rulings, "68b", &[QUEEN, White], false);
    assert_eq!(table.0.play().owed[Team::First], 2);
}

#[test]
fn law_68c_all_nine_back_after_a_due_was_paid_still_gives_the_right_to_the_queen() {
    let mut table = table(9, 9, Queen::OnBoard).white_has_pocketed_before();
    let rulings = table.pocket(&[QUEEN]);
    expect(&table, &rulings, "68c", &[], true);
    assert!(table.0.play().queen_to_cover());
}

#[test]
fn law_68d_queen_and_striker_with_all_nine_on_the_board_cost_the_turn() {
    let mut table = table(9, 9, Queen::OnBoard);
    let rulings = table.pocket(&[QUEEN, Striker]);
    expect(&table, &rulings, "68d", &[QUEEN], false);
    assert_eq!(table.0.play().owed[Team::First], 1);
}

#[test]
fn law_69_an_uncovered_queen_goes_back() {
    let mut table = table(5, 5, Queen::ToCover);
    let rulings = table.pocket(&[Black]);
    expect(&table, &rulings, "69", &[QUEEN], false);
    assert!(!table.0.play().queen_to_cover());
}

#[test]
fn law_70a_a_coin_of_ones_own_in_the_same_stroke_covers_her() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[White, QUEEN]);
    expect(&table, &rulings, "70a", &[], true);
    assert_eq!(table.0.play().queen_covered_by, Some(Team::First));
    assert_eq!(
        rulings[0].effects[0],
        RulingEffect::QueenCovered(Colour::White)
    );
}

#[test]
fn law_70b_the_queen_pocketed_with_one_of_nine_coins_is_not_covered() {
    let mut table = table(9, 9, Queen::OnBoard);
    let rulings = table.pocket(&[White, QUEEN]);
    expect(&table, &rulings, "70b", &[], true);
    assert!(table.0.play().queen_to_cover());
    let rulings = table.pocket(&[]);
    expect(&table, &rulings, "69", &[QUEEN], false);
}

#[test]
fn law_70b_the_queen_pocketed_with_two_of_nine_coins_is_covered() {
    let mut table = table(9, 9, Queen::OnBoard);
    let rulings = table.pocket(&[White, QUEEN, White]);
    expect(&table, &rulings, "70b", &[], true);
    assert_eq!(table.0.play().queen_covered_by, Some(Team::First));
}

#[test]
fn law_71a_queen_coin_and_striker_all_come_back_with_a_due_and_the_turn_continues() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[QUEEN, White, Striker]);
    expect(&table, &rulings, "71a", &[QUEEN, White, White], true);
    assert_eq!(table.on_board(Colour::White), 6);
}

#[test]
fn law_71a_holds_for_the_last_coin_too() {
    let mut table = table(1, 5, Queen::OnBoard);
    let rulings = table.pocket(&[QUEEN, White, Striker]);
    expect(&table, &rulings, "71a", &[QUEEN, White, White], true);
}

#[test]
fn law_72a_after_queen_and_striker_she_and_a_due_come_back_and_the_turn_continues() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[QUEEN, Striker]);
    expect(&table, &rulings, "72a", &[QUEEN, White], true);
    assert!(!table.0.play().queen_to_cover());
}

#[test]
fn law_73a_after_the_striker_instead_of_a_cover_queen_and_due_come_back() {
    let mut table = table(5, 5, Queen::ToCover);
    let rulings = table.pocket(&[Striker]);
    expect(&table, &rulings, "73a", &[QUEEN, White], false);
}

#[test]
fn law_73a_an_opponents_coin_along_with_the_striker_stays_down() {
    let mut table = table(5, 5, Queen::ToCover);
    let rulings = table.pocket(&[Striker, Black]);
    expect(&table, &rulings, "73a", &[QUEEN, White], false);
    assert_eq!(table.on_board(Colour::Black), 4);
}

#[test]
fn law_74a_the_striker_with_the_cover_gives_one_more_stroke_to_cover_her() {
    let mut table = table(5, 5, Queen::ToCover);
    let rulings = table.pocket(&[White, Striker]);
    expect(&table, &rulings, "74a", &[White, White], true);
    assert_eq!(rulings[0].effects.last(), Some(&RulingEffect::MustCover));
    assert_eq!(table.on_board(Colour::White), 6);
    let rulings = table.pocket(&[]);
    expect(&table, &rulings, "69", &[QUEEN], false);
}

#[test]
fn law_74a_she_stays_down_if_that_stroke_covers_her() {
    let mut table = table(1, 5, Queen::ToCover);
    table.pocket(&[White, Striker]);
    table.pocket(&[White]);
    assert_eq!(table.0.play().queen_covered_by, Some(Team::First));
}

#[test]
fn a_covered_queen_is_out_of_play() {
    let mut table = table(5, 5, Queen::Black);
    let rulings = table.pocket(&[Striker]);
    expect(&table, &rulings, "45a", &[White], false);
    assert_eq!(table.0.play().queen_covered_by, Some(Team::Second));
}

use super::laying::{Queen, cited, expect, put_back, table};
use crate::game::laws::RulingEffect;
use crate::game::pieces::{CENTRE_CIRCLE_RADIUS, Colour, OUTER_CIRCLE_RADIUS, Piece, PieceSet};
use crate::game::seat::Team;

use Piece::{Black, Striker, White};

#[test]
fn law_45a_the_striker_alone_costs_one_coin_and_the_turn() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[Striker]);
    expect(&table, &rulings, "45a", &[White], false);
    assert_eq!(table.on_board(Colour::White), 6);
    let coin = table.0.coins().last().unwrap();
    let radius = PieceSet::Tournament.coin_radius();
    let out = coin.at.length();
    assert!(out + radius <= OUTER_CIRCLE_RADIUS + 1e-12);
    assert!(out - radius >= CENTRE_CIRCLE_RADIUS, "law 62b");
    assert!(coin.at.y > 0.0, "far from the player who owes it");
}

#[test]
fn law_45b_a_due_waits_until_a_pocketed_coin_can_pay_it() {
    let mut table = table(9, 9, Queen::OnBoard);
    let rulings = table.pocket(&[Striker]);
    expect(&table, &rulings, "45a", &[], false);
    assert_eq!(cited(&rulings), ["45a", "45b"]);
    assert_eq!(
        rulings[1].effects,
        [RulingEffect::StillOwed(Colour::White, 1)]
    );
    assert_eq!(table.0.play().owed[Team::First], 1);
}

#[test]
fn law_46_after_striker_and_own_coins_these_and_a_due_come_back_and_the_turn_continues() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[White, Striker, White]);
    expect(&table, &rulings, "46", &[White, White, White], true);
    assert_eq!(table.on_board(Colour::White), 6);
}

#[test]
fn law_46_the_last_coin_with_the_striker_does_not_end_the_board() {
    let mut table = table(1, 5, Queen::White);
    let rulings = table.pocket(&[White, Striker]);
    expect(&table, &rulings, "46", &[White, White], true);
    assert_eq!(table.on_board(Colour::White), 2);
}

#[test]
fn law_46_at_nine_coins_the_due_of_the_stroke_stays_owed() {
    let mut table = table(9, 9, Queen::OnBoard);
    let rulings = table.pocket(&[White, Striker]);
    expect(&table, &rulings, "46", &[White], true);
    assert_eq!(table.0.play().owed[Team::First], 1);
}

#[test]
fn law_47_after_striker_and_opponents_coins_these_stay_down_and_a_coin_and_the_turn_are_lost() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[Black, Striker]);
    expect(&table, &rulings, "47", &[White], false);
    assert_eq!(table.on_board(Colour::Black), 4);
}

#[test]
fn law_48_after_striker_and_both_colours_own_coins_and_a_due_come_back_and_the_turn_continues() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[Black, White, Striker]);
    expect(&table, &rulings, "48", &[White, White], true);
    assert_eq!(
        (table.on_board(Colour::White), table.on_board(Colour::Black)),
        (6, 4)
    );
}

#[test]
fn law_51a_a_due_is_paid_by_the_first_coin_pocketed_and_the_turn_continues() {
    let mut table = table(9, 9, Queen::OnBoard).white_owes(2);
    let rulings = table.pocket(&[White]);
    expect(&table, &rulings, "21", &[White], true);
    assert_eq!(cited(&rulings), ["21", "51a"]);
    assert_eq!(table.0.play().owed[Team::First], 1);
    assert_eq!(table.on_board(Colour::White), 9);
}

#[test]
fn law_51a_a_coin_pocketed_by_the_opponent_pays_too() {
    let mut table = table(9, 9, Queen::OnBoard);
    table.0.play.owed[Team::Second] = 1;
    let rulings = table.pocket(&[Black]);
    assert_eq!(cited(&rulings), ["21", "51a"]);
    assert_eq!(put_back(&rulings), [Black]);
    assert_eq!(table.0.play().owed[Team::Second], 0);
    let coin = table.0.coins().last().unwrap();
    assert!(coin.at.y < 0.0, "far from Black, who owed it");
}

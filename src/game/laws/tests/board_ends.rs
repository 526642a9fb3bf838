use super::laying::{Queen, Table, cited, expect_end, put_back, table};
use super::validity::flaw;
use crate::game::laws::{BoardWon, Ruling, RulingEffect};
use crate::game::pieces::{Colour, Piece};
use crate::game::seat::Team::{self, First as White, Second as Black};
use crate::game::stroke::StrokeError;
use crate::game::table::GameStage;
use crate::game::validity::GameError;

const QUEEN: Piece = Piece::Queen;
const OWN: Piece = Piece::White;
const OTHER: Piece = Piece::Black;
const STRIKER: Piece = Piece::Striker;

#[test]
fn law_25a_the_first_to_pocket_all_nine_wins_a_point_for_each_coin_left() {
    let mut table = table(1, 4, Queen::Black);
    expect_end(&table.pocket(&[OWN]), "25a", White, 4);
    assert_eq!(table.0.score().points[White], 4);
    assert!(matches!(table.0.stage(), GameStage::BoardOver(_)));
}

#[test]
fn law_25b_the_winners_queen_is_worth_three() {
    let mut table = table(1, 4, Queen::White);
    expect_end(&table.pocket(&[OWN]), "25a", White, 7);
}

#[test]
fn law_25b_the_queen_may_be_covered_by_the_last_coin_in_the_same_stroke_or_the_next() {
    let mut together = table(1, 4, Queen::OnBoard);
    expect_end(&together.pocket(&[OWN, QUEEN]), "25a", White, 7);
    assert_eq!(together.0.play().queen_covered_by, Some(White));
    let mut next = table(1, 4, Queen::ToCover);
    expect_end(&next.pocket(&[OWN]), "25a", White, 7);
}

#[test]
fn law_26c_the_losers_queen_is_worth_nothing() {
    let mut table = table(4, 1, Queen::White);
    expect_end(&table.pocket(&[OTHER]), "25a", Black, 4);
}

#[test]
fn law_25a_pocketing_the_opponents_last_coin_wins_the_board_for_the_opponent() {
    let mut table = table(4, 1, Queen::Black);
    expect_end(&table.pocket(&[OTHER, OWN]), "25a", Black, 6);
}

#[test]
fn law_27_from_22_points_on_the_queen_is_worth_nothing() {
    for (score, points) in [(21, 7), (22, 4)] {
        let mut table = table(1, 4, Queen::White).score(score, 0);
        expect_end(&table.pocket(&[OWN]), "25a", White, points);
    }
}

#[test]
fn law_28_a_board_is_worth_twelve_points_at_most() {
    let mut most = table(1, 9, Queen::White);
    expect_end(&most.pocket(&[OWN]), "25a", White, 12);
    let mut more = table(9, 1, Queen::OnBoard);
    expect_end(&more.pocket(&[OTHER, STRIKER]), "84a", Black, 12);
}

#[test]
fn law_28_dues_are_written_off_at_the_end() {
    let mut table = table(9, 1, Queen::White).white_owes(2);
    let rulings = table.pocket(&[OTHER, STRIKER]);
    expect_end(&rulings, "25a", Black, 9);
    assert!(put_back(&rulings).is_empty());
    assert_eq!(table.0.play().owed[White], 0);
}

#[test]
fn law_29_the_end_of_the_game_is_announced_at_25_points() {
    let mut table = table(1, 4, Queen::White).score(21, 3);
    let rulings = table.pocket(&[OWN]);
    assert_eq!(cited(&rulings), ["25a", "29a"]);
    assert_eq!(rulings[1].effects, [RulingEffect::GameWon(White)]);
    assert_eq!(rulings[1].text, "White wins the game by 28 to 3.");
    assert_eq!(table.0.stage(), GameStage::GameOver(White));
}

/// A game in which these `boards` have been played and South breaks again.
fn after(mut table: Table, boards: &[(Team, u8)]) -> Table {
    table.0.finished = boards
        .iter()
        .map(|(winner, points)| BoardWon {
            winner: *winner,
            points: *points,
        })
        .collect();
    assert_eq!(table.0.colour(White), Colour::White);
    assert_eq!(flaw(&table.0), None);
    table
}

/// After these six boards, South wins the seventh by 4, and North wins the eighth by 12 with all
/// nine coins and the queen in one stroke.
fn eighth_board(six: &[(Team, u8)]) -> (Table, Vec<Ruling>) {
    let mut game = after(table(1, 4, Queen::Black), six);
    expect_end(&game.pocket(&[OWN]), "25a", White, 4);
    assert!(matches!(game.0.stage(), GameStage::BoardOver(_)));
    game.0.next_board().unwrap();
    assert_eq!(game.0.board_number(), 8);
    let rulings = game.pocket(&[&[QUEEN][..], &[OWN; 9]].concat());
    expect_end(&rulings, "25a", Black, 12);
    (game, rulings)
}

#[test]
fn law_29a_the_leader_after_eight_boards_wins_the_game() {
    let six = [
        (White, 2),
        (Black, 1),
        (White, 2),
        (Black, 1),
        (White, 2),
        (Black, 1),
    ];
    let (game, rulings) = eighth_board(&six);
    assert_eq!(cited(&rulings), ["25a", "29a"]);
    assert_eq!(game.0.stage(), GameStage::GameOver(Black));
}

#[test]
fn law_29b_a_tie_after_eight_boards_is_decided_by_an_extra_board() {
    let six = [
        (White, 2),
        (Black, 1),
        (White, 3),
        (Black, 1),
        (White, 5),
        (Black, 0),
    ];
    let (mut game, rulings) = eighth_board(&six);
    assert_eq!(game.0.score().points[White], 14);
    assert_eq!(cited(&rulings), ["25a", "29b"]);
    assert_eq!(rulings[1].effects, [RulingEffect::ExtraBoard]);
    assert!(matches!(game.0.stage(), GameStage::BoardOver(_)));
    game.0.next_board().unwrap();
    assert_eq!(game.0.board_number(), 9);
}

#[test]
fn law_30_the_match_ends_with_the_second_game() {
    let first = [(White, 12), (White, 12), (White, 12)];
    let second = [(White, 12), (Black, 12), (White, 12)];
    let mut game = after(table(1, 4, Queen::White), &[first, second].concat());
    let rulings = game.pocket(&[OWN]);
    assert_eq!(cited(&rulings), ["25a", "29a", "30"]);
    assert_eq!(game.0.stage(), GameStage::MatchOver(White));
    assert_eq!(game.0.next_board(), Err(GameError::MatchOver));
    assert_eq!(game.0.no_place(), Err(StrokeError::Ended));
}

/// Asserts which law ends the board and who wins it, and by how many points: `below_22` at a score
/// at which the queen is worth points, `from_22` at a score at which she is not.
#[track_caller]
fn ends(
    lay: impl Fn() -> Table,
    fallen: &[Piece],
    law: &str,
    winner: Team,
    below_22: u8,
    from_22: u8,
) {
    for (score, points) in [(21, below_22), (22, from_22)] {
        let mut table = if winner == White {
            lay().score(score, 0)
        } else {
            lay().score(0, score)
        };
        expect_end(&table.pocket(fallen), law, winner, points);
    }
}

#[test]
fn law_75a_covering_the_queen_with_both_last_coins_wins_by_three_or_one() {
    ends(
        || table(1, 1, Queen::ToCover),
        &[OWN, OTHER],
        "75a",
        White,
        3,
        1,
    );
}

#[test]
fn law_76a_the_opponents_last_coin_instead_of_a_cover_loses_ones_coins_and_the_queen() {
    ends(|| table(4, 1, Queen::ToCover), &[OTHER], "76a", Black, 7, 4);
}

#[test]
fn law_77a_queen_and_both_last_coins_win_by_three_or_one() {
    ends(
        || table(1, 1, Queen::OnBoard),
        &[OWN, QUEEN, OTHER],
        "77a",
        White,
        3,
        1,
    );
}

#[test]
fn law_78a_both_last_coins_with_the_queen_on_the_board_lose_by_three_or_one() {
    ends(
        || table(1, 1, Queen::OnBoard),
        &[OWN, OTHER],
        "78a",
        Black,
        3,
        1,
    );
}

#[test]
fn law_79a_the_opponents_last_coin_with_the_queen_on_the_board_loses_ones_coins_and_the_queen() {
    ends(|| table(4, 1, Queen::OnBoard), &[OTHER], "79a", Black, 7, 4);
}

#[test]
fn law_80a_ones_last_coin_with_the_queen_on_the_board_loses_by_three_or_one() {
    ends(|| table(1, 4, Queen::OnBoard), &[OWN], "80a", Black, 3, 1);
}

#[test]
fn law_81a_ones_last_coin_and_striker_with_the_queen_on_the_board_lose_by_four_or_two() {
    ends(
        || table(1, 4, Queen::OnBoard),
        &[OWN, STRIKER],
        "81a",
        Black,
        4,
        2,
    );
}

#[test]
fn law_82a_queen_and_both_last_coins_with_the_striker_lose() {
    let fallen = [QUEEN, OWN, OTHER, STRIKER];
    ends(|| table(1, 1, Queen::OnBoard), &fallen, "82a", Black, 4, 2);
}

#[test]
fn law_83a_both_last_coins_and_striker_after_covering_the_queen_lose_by_two() {
    let fallen = [OWN, OTHER, STRIKER];
    ends(|| table(1, 1, Queen::White), &fallen, "83a", Black, 2, 2);
}

#[test]
fn law_84a_the_opponents_last_coin_and_striker_with_the_queen_on_the_board_lose_one_more_point() {
    let fallen = [OTHER, STRIKER];
    ends(|| table(4, 1, Queen::OnBoard), &fallen, "84a", Black, 8, 5);
}

#[test]
fn law_85a_both_last_coins_and_striker_after_the_opponent_covered_the_queen_lose_by_four_or_two() {
    let fallen = [OWN, OTHER, STRIKER];
    ends(|| table(1, 1, Queen::Black), &fallen, "85a", Black, 4, 2);
}

#[test]
fn both_last_coins_with_the_queen_covered_win_as_in_law_75a() {
    let fallen = [OWN, OTHER];
    ends(|| table(1, 1, Queen::White), &fallen, "25a", White, 3, 1);
    ends(|| table(1, 1, Queen::Black), &fallen, "25a", White, 1, 1);
}

#[test]
fn the_striker_with_both_last_coins_before_the_queen_is_covered_loses_as_in_78a_and_82a() {
    let fallen = [OWN, OTHER, STRIKER];
    ends(|| table(1, 1, Queen::OnBoard), &fallen, "78a", Black, 4, 2);
    ends(|| table(1, 1, Queen::ToCover), &fallen, "82a", Black, 4, 2);
}

#[test]
fn the_striker_with_the_opponents_last_coin_instead_of_a_cover_costs_one_more_point() {
    let fallen = [OTHER, STRIKER];
    ends(|| table(4, 1, Queen::ToCover), &fallen, "76a", Black, 8, 5);
}

#[test]
fn law_79a_counts_the_queen_too_when_she_falls_with_the_opponents_last_coin() {
    let fallen = [OTHER, QUEEN];
    ends(|| table(4, 1, Queen::OnBoard), &fallen, "79a", Black, 7, 4);
}

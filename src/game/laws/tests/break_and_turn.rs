use super::laying::{Queen, Table, cited, expect, spread, stroke, table};
use crate::game::laws::{BoardWon, Rules, RulingEffect};
use crate::game::pieces::{Colour, Piece};
use crate::game::seat::{Hands, Seat, Team};
use crate::game::stroke::StrokeError;
use crate::game::table::{Game, GameSetup, GameStage};
use crate::game::validity::GameError;

fn unbroken() -> Table {
    Table(Game::new(GameSetup::default()))
}

/// Pockets all white coins and the queen in one stroke: the breaker wins the board.
fn clear_white(table: &mut Table) {
    let mut all = vec![Piece::White; 9];
    all.push(Piece::Queen);
    table.pocket(&all);
}

#[test]
fn law_16_the_breaker_has_white() {
    let mut table = unbroken();
    assert_eq!(table.0.colour(Team::First), Colour::White);
    assert_eq!(table.0.colour(Team::Second), Colour::Black);
    clear_white(&mut table);
    table.0.next_board().unwrap();
    assert_eq!(table.0.seat(), Seat::North);
    assert_eq!(table.0.colour(Team::Second), Colour::White);
}

#[test]
fn law_17_the_slightest_touch_is_a_break() {
    let mut table = unbroken();
    let rulings = table.strike(true, &[]);
    expect(&table, &rulings, "21", &[], false);
    assert!(!table.0.play().is_unbroken());
    assert_eq!(cited(&table.strike(false, &[])), ["21"]);
}

#[test]
fn law_18a_a_break_that_touches_nothing_may_be_tried_twice_more() {
    let mut table = unbroken();
    for _ in 0..2 {
        let rulings = table.strike(false, &[]);
        expect(&table, &rulings, "18a", &[], true);
        assert!(table.0.play().is_unbroken());
    }
    let rulings = table.strike(true, &[Piece::White]);
    expect(&table, &rulings, "21", &[], true);
}

#[test]
fn law_18b_after_three_misses_the_break_passes_and_the_colours_stay() {
    let mut table = unbroken();
    for _ in 0..2 {
        table.strike(false, &[]);
    }
    let rulings = table.strike(false, &[]);
    expect(&table, &rulings, "18b", &[], false);
    assert_eq!(table.0.colour(Team::Second), Colour::Black);
    let rulings = table.strike(false, &[]);
    assert_eq!(cited(&rulings), ["18a"]);
    assert_eq!(table.0.seat(), Seat::North);
}

#[test]
fn law_18c_pocketing_the_striker_at_an_untouched_pack_costs_the_turn_but_no_due() {
    let mut table = unbroken();
    let rulings = table.strike(false, &[Piece::Striker]);
    expect(&table, &rulings, "18c", &[], false);
    assert_eq!(table.0.play().owed[Team::First], 0);
    assert!(table.0.play().is_unbroken());
}

#[test]
fn law_18c_does_not_cover_a_striker_that_touched_the_pack() {
    let mut table = unbroken();
    let rulings = table.strike(true, &[Piece::Striker]);
    assert_eq!(cited(&rulings), ["45a", "45b"]);
    assert_eq!(table.0.play().owed[Team::First], 1);
}

#[test]
fn law_21_pocketing_ones_own_coin_keeps_the_turn() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[Piece::White]);
    expect(&table, &rulings, "21", &[], true);
    assert_eq!(
        rulings[0].effects,
        [RulingEffect::TurnContinues(Seat::South)]
    );
}

#[test]
fn law_21_pocketing_nothing_passes_the_turn() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[]);
    expect(&table, &rulings, "21", &[], false);
    assert_eq!(rulings[0].effects, [RulingEffect::TurnPasses(Seat::North)]);
}

#[test]
fn law_21_an_opponents_coin_stays_down_and_the_turn_passes() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[Piece::Black]);
    expect(&table, &rulings, "21", &[], false);
    assert_eq!(table.on_board(Colour::Black), 4);
}

#[test]
fn law_21_an_opponents_coin_together_with_ones_own_keeps_the_turn() {
    let mut table = table(5, 5, Queen::OnBoard);
    let rulings = table.pocket(&[Piece::Black, Piece::White]);
    expect(&table, &rulings, "21", &[], true);
    assert_eq!(
        (table.on_board(Colour::White), table.on_board(Colour::Black)),
        (4, 4)
    );
}

#[test]
fn law_22a_the_break_alternates_in_a_game_and_the_first_break_alternates_between_games() {
    let mut table = unbroken();
    let mut breakers = Vec::new();
    loop {
        breakers.push(table.0.seat());
        clear_white(&mut table);
        if let GameStage::GameOver(_) = table.0.stage() {
            break;
        }
        table.0.next_board().unwrap();
    }
    use Seat::{North, South};
    assert_eq!(breakers, [South, North, South, North, South]);
    table.0.next_board().unwrap();
    assert_eq!(table.0.seat(), North, "the second game");
    assert_eq!(table.0.board_number(), 1);
    assert_eq!(table.0.score().games[Team::First], 1);
}

#[test]
fn the_break_still_alternates_after_hundreds_of_friendly_boards() {
    let mut game = Game::new(GameSetup {
        rules: Rules::Friendly,
        ..GameSetup::default()
    });
    let won = |winner| BoardWon { winner, points: 1 };
    game.finished = (0..300).map(|i| won(Team::BOTH[i % 2])).collect();
    for seat in [Seat::North, Seat::South, Seat::North] {
        game.play.won = Some(won(Team::First));
        game.next_board().unwrap();
        assert_eq!(game.seat(), seat);
    }
}

#[test]
fn law_22b_in_doubles_turn_and_break_pass_to_the_right() {
    let mut table = Table(Game::new(GameSetup {
        hands: Hands::Four,
        first_breaker: Seat::East,
        ..GameSetup::default()
    }));
    assert_eq!(table.0.colour(Team::Second), Colour::White);
    for seat in [Seat::East, Seat::North, Seat::West, Seat::South] {
        assert_eq!(table.0.seat(), seat);
        table.strike(true, &[]);
    }
    assert_eq!(table.0.seat(), Seat::East);
    clear_white(&mut table);
    table.0.next_board().unwrap();
    assert_eq!(table.0.seat(), Seat::North);
    assert_eq!(table.0.colour(Team::First), Colour::White);
}

#[test]
fn in_doubles_partners_share_coins_dues_and_the_queen() {
    let mut table = Table(Game::new(GameSetup {
        hands: Hands::Four,
        ..GameSetup::default()
    }));
    table.strike(true, &[Piece::Striker]);
    spread(&mut table.0.play.coins);
    assert_eq!(table.0.play().owed[Team::First], 1);
    table.strike(true, &[]);
    assert_eq!(table.0.seat(), Seat::North);
    let rulings = table.strike(true, &[Piece::White, Piece::White]);
    assert_eq!(cited(&rulings), ["21", "51a"]);
    assert_eq!(table.on_board(Colour::White), 8);
    table.strike(true, &[Piece::Queen]);
    table.strike(true, &[Piece::White]);
    assert_eq!(table.0.play().queen_covered_by, Some(Team::First));
}

#[test]
fn an_impossible_stroke_changes_nothing() {
    let mut table = table(5, 5, Queen::OnBoard);
    let before = table.0.clone();
    let mut bad = stroke(table.0.coins(), true, &[Piece::White]);
    bad.pocketed.clear();
    assert!(matches!(
        table.0.apply(&bad),
        Err(StrokeError::Miscounted { .. })
    ));
    assert_eq!(table.0, before);
    assert_eq!(table.0.next_board(), Err(GameError::StillPlaying));
}

#[test]
fn keeping_the_previous_game_allows_undo() {
    let mut table = table(5, 5, Queen::OnBoard);
    let before = table.0.clone();
    table.pocket(&[Piece::White]);
    assert_ne!(table.0, before);
    let after = table.0.clone();
    table.0 = before;
    table.pocket(&[Piece::White]);
    assert_eq!(table.0, after);
}

#[test]
fn no_place_for_the_striker_passes_the_turn_and_uncovers_the_queen() {
    let mut table = table(5, 5, Queen::ToCover);
    let rulings = table.0.no_place().unwrap();
    expect(&table, &rulings, "house", &[Piece::Queen], false);
}

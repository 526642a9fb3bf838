//! Boards for one player on the screen: the board of the day, and boards opened by their codes.

use std::time::Duration;

use carrom::app::App;
use carrom::game::opponent::clearing;
use carrom::game::{BoardCode, Strike};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;

use crate::folder::Folder;

const LONG: Duration = Duration::from_secs(120);
/// Noon on 26 November 2026 (UTC), in seconds since the start of 1970.
const NOON_S: i64 = 1_795_694_400;

fn opened(route: Route, store: Store) -> Headless {
    Headless::keeping(App::new(route, Settings::default(), 1), 80, 24, store)
}

fn board(code: &str, store: Store) -> Headless {
    let code = BoardCode::parse(code).ok();
    opened(Route::Board(code), store)
}

fn timeless() -> Store {
    Store::in_memory().timeless()
}

/// The panel's text without line breaks.
fn words(game: &mut Headless) -> String {
    let screen = game.screen();
    let side = |line: &str| {
        line.rsplit_once("||")
            .map(|(_, side)| side.replace('|', " "))
    };
    let rows: Vec<_> = screen.lines().filter_map(side).collect();
    rows.join(" ")
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
}

/// Types a stroke, strikes, and waits for its end.
fn play(game: &mut Headless, strike: &Strike) {
    let mm = strike.place.x * 1000.0;
    let side = if mm < 0.0 { '[' } else { ']' };
    let degrees = strike.velocity.to_angle().to_degrees().rem_euclid(360.0);
    let speed = strike.velocity.length();
    game.pass(LONG);
    game.press(&format!(
        "{:.1}{side}{degrees:.1}<Enter>{speed:.1}+",
        mm.abs()
    ));
    game.press(" ");
    assert!(game.settle(LONG), "{}", game.screen());
}

/// Clears the board as the search does.
fn clear(game: &mut Headless, code: &str) -> usize {
    let strikes = clearing(BoardCode::parse(code).unwrap()).unwrap();
    for (number, strike) in strikes.iter().enumerate() {
        let said = words(game);
        assert!(said.contains(&format!("Stroke {} ", number + 1)), "{said}");
        play(game, strike);
        game.press("<Enter>");
    }
    strikes.len()
}

#[test]
fn a_board_is_cleared_and_its_result_is_kept() {
    let folder = Folder::new("boards");
    let store = || Store::in_folder(folder.path()).timeless();
    let mut game = board("2026-11-26", store());
    let said = words(&mut game);
    assert!(said.contains("your best not cleared yet"), "{said}");
    game.press("<Enter>");
    assert_eq!(game.app().address().0, "board=2026-11-26");
    let par = clear(&mut game, "2026-11-26");
    let said = words(&mut game);
    assert!(
        said.contains(&format!("Cleared in {par} strokes: par!")),
        "{said}"
    );
    let result = format!("carrom, board of 26 November 2026, {par} strokes, par {par}:");
    assert!(said.contains(&result), "{said}");
    assert!(said.contains("carrom board 2026-11-26"), "{said}");
    game.pass(LONG);
    game.press("<Enter>");
    let best = format!("your best {par} strokes");
    assert!(words(&mut game).contains(&best), "{}", game.screen());

    // The second attempt begins with a stroke that pockets nothing; the better result counts.
    game.press("<Enter>");
    game.press("90<Enter>0.2+ ");
    assert!(game.settle(LONG));
    let said = words(&mut game);
    assert!(said.contains("Nothing fell, six coins to go."), "{said}");
    drop(game);

    // After a restart, the board, the attempt and the best result are still there.
    let mut game = board("2026-11-26", store());
    assert!(words(&mut game).contains(&best), "{}", game.screen());
    let mut other = App::new(Route::Board(None), Settings::default(), 1);
    other.settings_mut().player = "Bo".into();
    let mut other = Headless::keeping(other, 80, 24, store());
    other.press("20261126<Enter>");
    assert!(words(&mut other).contains("not cleared yet"));
    let mut table = opened(Route::Table, store());
    table.press("s");
    let screen = table.screen();
    assert!(screen.contains("board of 26 November 2026"), "{screen}");
    // The attempt that was interrupted continues with its second stroke.
    table.press("<Enter>");
    assert!(
        words(&mut table).contains("Stroke 2 (par"),
        "{}",
        table.screen()
    );
}

#[test]
fn the_board_of_the_day_follows_the_date() {
    let today = || Store::in_memory().at(NOON_S);
    let mut game = opened(Route::Board(None), today());
    assert!(words(&mut game).contains("Board of 26 November 2026"));
    game.press("<Right>");
    let said = words(&mut game);
    assert!(said.contains("The next board is tomorrow's."), "{said}");
    game.press("<Left>");
    assert!(words(&mut game).contains("Board of 25 November 2026"));
    assert_eq!(game.app().address().0, "board=2026-11-25");
    game.press("<Right>");
    assert!(words(&mut game).contains("Board of 26 November 2026"));

    for (route, key) in [(Route::Table, "b"), (Route::Levels, "b")] {
        let mut game = opened(route.clone(), today());
        game.press(key);
        assert!(words(&mut game).contains("Board of 26 November 2026"));
        game.press("<Escape>");
        let (address, _) = game.app().address();
        assert!(["table", "levels"].contains(&&*address), "{address}");
    }

    let mut game = opened(Route::Board(None), timeless());
    let said = words(&mut game);
    assert!(said.contains("Today's date is unknown."), "{said}");
    game.press("<Enter>");
    assert_eq!(words(&mut game), said, "there is no board to play");
}

#[test]
fn a_typed_code_opens_its_board_and_a_wrong_one_is_refused() {
    let mut game = board("4711", timeless());
    assert!(words(&mut game).contains("Everyone with this code has the same board."));
    for wrong in ["0", "1.5", "-3", "1000000", "20261301", "999999999"] {
        game.press(&format!("{wrong}<Enter>"));
        let said = words(&mut game);
        assert!(
            said.contains("Expected the code of a board"),
            "{wrong}: {said}"
        );
        assert!(said.contains("Board 4711"), "{wrong}: {said}");
    }
    game.press("20270101<Enter>");
    assert!(words(&mut game).contains("Board of 1 January 2027"));
    game.press("12<Enter>");
    assert!(words(&mut game).contains("Board 12"));
    game.press("<Left>");
    assert!(words(&mut game).contains("This board does not belong to a day."));
}

#[test]
fn a_stroke_cannot_be_taken_back_and_there_are_no_hints() {
    let mut game = board("4711", timeless());
    game.press("<Enter>");
    let before = words(&mut game);
    assert!(before.contains("coins"), "{before}");
    game.press("h");
    assert_eq!(words(&mut game), before);
    play(
        &mut game,
        &clearing(BoardCode::parse("4711").unwrap()).unwrap()[0],
    );
    game.press("<Enter>");
    let before = words(&mut game);
    assert!(before.contains("Stroke 2 "), "{before}");
    game.press("zp");
    assert_eq!(words(&mut game), before);
    game.press("<Escape>");
    assert!(
        game.screen().contains("Leave this game?"),
        "{}",
        game.screen()
    );
    game.press("y");
    assert!(words(&mut game).contains("Board 4711"));
}

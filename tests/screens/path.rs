//! The next step on the screens that show it, and the player to whom it belongs.

use carrom::app::App;
use carrom::messages::{PlayerAction, StoreCall, StoreRequest};
use carrom::progress::Attempt;
use carrom::quiz::{Answer, Code, Confidence, Round};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;

/// 15 January 2027.
const NOW_S: i64 = 1_800_000_000;

/// A store in which these players have answered one question each.
fn store(players: &[&str]) -> Store {
    let mut store = Store::in_memory().at(NOW_S);
    let round = Round::of(Code::parse("from-angle-7").unwrap());
    let question = &round.questions()[0];
    let answer = Answer::new(question.form.truth(), Confidence::Sure);
    for player in players {
        let attempt = Attempt::of_quiz(player, round.code(), 1, question, &answer);
        let request = StoreRequest::Note(PlayerAction::Record(Box::new(attempt)));
        store.answer(&StoreCall { ticket: 0, request });
    }
    store
}

fn game(route: Route, players: &[&str]) -> Headless {
    let settings = Settings {
        player: "Mia".into(),
        reduced_motion: true,
        ..Settings::default()
    };
    Headless::keeping(App::new(route, settings, 7), 80, 24, store(players))
}

#[test]
fn home_marks_one_first_step_and_explains_it_before_it_begins() {
    let mut home = game(Route::Home, &[]);
    let screen = home.screen();
    assert!(
        screen.contains("> n  Find out what you believe"),
        "{screen}"
    );
    assert!(screen.contains("At most twelve questions"), "{screen}");
    assert!(screen.lines().next().unwrap().contains("Mia"), "{screen}");
    home.press("b");
    let screen = home.screen();
    assert!(screen.contains("Up to twelve questions"), "{screen}");
    home.press("<Enter>");
    let screen = home.screen();
    assert!(screen.contains("question 1 of at most 12"), "{screen}");
}

#[test]
fn learn_progress_and_the_end_of_a_round_show_the_same_step_as_home() {
    let answers = "22<Enter>22<Enter>3<End><Enter>".repeat(3);
    let mut round = game(Route::Quiz(Code::parse("from-angle3-7")), &[]);
    let first = round.screen();
    round.press(&answers);
    let screen = round.screen();
    assert!(screen.contains("0 of 3 right"), "{first}{screen}");
    let step = screen.lines().find_map(|line| line.split_once("x: "));
    let step = step
        .unwrap_or_else(|| panic!("{screen}"))
        .1
        .trim_matches(['|', ' ', '.']);
    assert!(step.starts_with("Read chapter"), "{screen}");
    for keys in ["<Escape><Escape>", "e", "<Escape>p"] {
        round.press(keys);
        let screen = round.screen();
        assert!(screen.contains(step), "{keys}: {step}\n{screen}");
    }
    round.press("<Enter>");
    assert!(round.screen().contains("page"), "{}", round.screen());
}

#[test]
fn the_players_are_listed_with_their_last_day_and_a_new_one_needs_confirmation() {
    let mut game = game(Route::Settings, &["Mia", "Ada"]);
    game.press("<End><Enter>");
    let screen = game.screen();
    for text in ["Players", "Ada", "Mia", "15 January 2027", "someone new"] {
        assert!(screen.contains(text), "{text}\n{screen}");
    }
    game.press("<End><Enter>mia<Enter>");
    let screen = game.screen();
    assert!(screen.contains("Begin a new record for mia?"), "{screen}");
    assert!(screen.contains("a player called Mia"), "{screen}");
    game.press("n");
    assert!(!game.screen().contains("Begin a new record"));
    // A known player needs no confirmation.
    game.press("<Escape><Home><Enter><Escape>");
    let screen = game.screen();
    assert!(screen.lines().next().unwrap().contains("Ada"), "{screen}");
}

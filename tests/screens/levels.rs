//! The levels on the screen: the list, and each level played by keys and by mouse.

use std::time::Duration;

use carrom::app::App;
use carrom::cli;
use carrom::levels::{Level, Shelf};
use carrom::messages::{Key, MouseKind};
use carrom::progress::LEVEL;
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::widgets::Charset;
use proptest::prelude::*;

use crate::folder::Folder;
use crate::thorough::cases;

const LONG: Duration = Duration::from_secs(120);

fn embedded() -> Shelf {
    Shelf::default()
}

fn open(place: Route, settings: Settings, size: (u16, u16)) -> Headless {
    let app = App::new(place, settings, 1);
    let mut game = Headless::new(app, size.0, size.1);
    game.pass(LONG);
    game
}

#[test]
fn a_key_press_that_continues_never_shoots() {
    for key in ["<Enter>", " "] {
        let mut game = level(number("dead-stop"));
        game.press("p47<Enter><Enter>");
        for _ in 0..90 {
            game.press(key);
            game.pass(Duration::from_millis(33));
        }
        let screen = game.screen();
        assert!(screen.contains("> direction"), "{screen}");
        assert!(
            squeezed(&screen).contains("Toosoonafterthelastpress"),
            "{screen}"
        );
        game.pass(LONG);
        game.press(key);
        assert!(game.screen().contains("shot 2"), "{}", game.screen());
    }
}

fn level(number: usize) -> Headless {
    open(Route::Level(number), Settings::default(), (80, 24))
}

fn number(id: &str) -> usize {
    embedded().find(id).unwrap()
}

/// Types the stored solution of a level.
fn set(game: &mut Headless, level: &Level) {
    for (dial, _) in level.adjust.dials() {
        game.press(&format!("{}<Enter><Down>", level.solution.get(dial)));
    }
}

/// Shoots, predicts that every disc goes straight ahead, and waits.
fn shoot(game: &mut Headless) {
    game.key(Key::Enter);
    while game.screen().contains("predict it") {
        game.press("0<Enter>");
    }
    assert!(game.settle(LONG));
}

/// The panel's text on all its pages, in one line.
fn all_pages(game: &mut Headless) -> String {
    let mut text = String::new();
    for _ in 0..20 {
        let screen = game.screen();
        let side = |line: &str| line.rsplit_once("||").map(|(_, side)| side.to_owned());
        let rows: Vec<_> = screen.lines().filter_map(side).collect();
        text += &rows.join(" ").replace('|', " ");
        text.push(' ');
        game.key(Key::PageDown);
    }
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn every_level_is_won_by_its_solution_and_shows_its_whole_explanation() {
    let shelf = embedded();
    for (number, (_, level)) in shelf.levels().enumerate() {
        for size in [(80, 24), (60, 20)] {
            let place = Route::Level(number);
            let mut game = open(place, Settings::default(), size);
            set(&mut game, level);
            shoot(&mut game);
            let screen = game.screen();
            assert!(screen.contains("Won!"), "{}\n{screen}", level.id);
            assert!(
                game.app().context().shelf.stars(number) >= 2,
                "{}",
                level.id
            );
            let read = all_pages(&mut game);
            for word in level.explanation.split_whitespace() {
                let word = Charset::Ascii.text(word);
                assert!(read.contains(&*word), "{}: {word}", level.id);
            }
            assert!(read.contains("Enter: the next level.") || read.contains("last level"));
        }
    }
}

/// A ray does not count as predicted until it has been turned or its angle typed: Enter alone
/// neither makes the shot nor earns the star for the prediction.
#[test]
fn enter_alone_gives_no_answer() {
    let shelf = embedded();
    let mut asked = 0;
    for (number, (_, level)) in shelf.levels().enumerate() {
        let mut game = open(Route::Level(number), Settings::default(), (80, 24));
        set(&mut game, level);
        game.key(Key::Enter);
        if !game.screen().contains("predict it") {
            continue;
        }
        asked += 1;
        game.press("<Enter><Enter> <Enter>");
        let screen = game.screen();
        assert!(screen.contains("predict it"), "{}\n{screen}", level.id);
        assert!(squeezed(&screen).contains("Turntheray,ortype"), "{screen}");
        game.key(Key::Escape);
        assert_eq!(game.app().context().shelf.stars(number), 0, "{}", level.id);
    }
    assert!(asked > 20);
}

/// The last replay speed chosen applies to the next shot.
#[test]
fn the_last_speed_chosen_is_remembered() {
    let mut game = level(number("follow-on"));
    game.press("p<Enter>");
    assert!(game.screen().contains("real speed"), "{}", game.screen());
    game.press("--<Escape>");
    game.pass(LONG);
    game.press("<Enter>");
    assert!(game.screen().contains("1/4 speed"), "{}", game.screen());
}

/// The other disc leaves along the line of impact, so the impact angle would reveal its direction.
#[test]
fn the_answer_is_not_shown_before_the_question() {
    let mut asked = 0;
    for (number, (_, level)) in embedded().levels().enumerate() {
        let mut game = open(Route::Level(number), Settings::default(), (120, 40));
        set(&mut game, level);
        game.key(Key::Enter);
        let screen = game.screen();
        if screen.contains("predict it") && level.say_first != [level.scene.stroke.disc] {
            asked += 1;
            let given = screen.contains("impact angle") || screen.contains("alpha =");
            assert!(!given, "{}\n{screen}", level.id);
            assert!(screen.contains("r1 + r2") && screen.contains("offset b"));
        }
    }
    assert!(asked > 20);
}

#[test]
fn the_last_shots_are_listed_beside_the_dials() {
    let mut game = level(number("dead-stop"));
    for angle in ["45", "60", "58"] {
        game.press(&format!("{angle}<Enter>"));
        shoot(&mut game);
        game.key(Key::Enter);
    }
    let screen = game.screen();
    assert!(!screen.contains("shot 1:"), "{screen}");
    assert!(screen.contains("shot 2: 60.0 deg"), "{screen}");
    assert!(screen.contains("shot 3: 58.0 deg"), "{screen}");
}

#[test]
fn a_shot_is_listed_even_if_the_solution_is_shown_after_it() {
    let mut game = level(number("dead-stop"));
    game.press("45<Enter>");
    shoot(&mut game);
    game.press("hhh");
    assert!(game.settle(LONG));
    assert!(game.screen().contains("a shot that wins"));
    game.key(Key::Enter);
    let shown = all_pages(&mut game);
    assert!(shown.contains("shot 1: 45.0 deg"), "{shown}");
}

#[test]
fn a_level_is_won_by_arrow_keys_alone() {
    let mut game = level(number("dead-stop"));
    game.press(&"<Left>".repeat(16));
    assert!(game.screen().contains("53.0 deg"), "{}", game.screen());
    shoot(&mut game);
    assert!(game.screen().contains("Won!"));
}

#[test]
fn directions_change_in_fine_or_big_steps_and_stay_in_range() {
    let mut game = level(number("dead-stop"));
    game.press(",");
    assert!(game.screen().contains("45.05 deg"), "{}", game.screen());
    game.press(".>");
    assert!(game.screen().contains("40.0 deg"));
    game.press("-300<Enter>");
    assert!(game.screen().contains("60.0 deg"), "-300 is 60");
    game.press("5000<Enter>");
    let screen = game.screen();
    let mut rows = screen.lines();
    let set = rows.any(|row| row.contains("> direction ") && row.contains(" 75.0 deg"));
    assert!(set, "{screen}");
    game.press("r");
    assert!(game.screen().contains("45.0 deg"));
}

#[test]
fn a_win_is_shown_at_the_end_and_saved_even_if_left_before() {
    let at = number("dead-stop");
    let mut game = level(at);
    game.press("53<Enter><Enter>0<Enter>");
    game.pass(Duration::from_millis(100));
    assert!(game.screen().contains("Space: go on"), "{}", game.screen());
    assert_eq!(game.app().context().shelf.stars(at), 0);
    game.key(Key::Escape);
    assert_eq!(game.app().context().shelf.stars(at), 3);
}

#[test]
fn a_right_prediction_earns_the_third_star() {
    for (said, stars) in [("0", 3), ("20", 2)] {
        let at = number("dead-stop");
        let mut game = level(at);
        game.press(&format!("53<Enter><Enter>{said}<Enter>"));
        assert!(game.settle(LONG));
        assert_eq!(game.app().context().shelf.stars(at), stars);
        let screen = game.screen();
        assert!(screen.contains("you said"), "{screen}");
        let advice = all_pages(&mut game).contains("predict the paths within 4 deg");
        assert_eq!(advice, stars < 3);
    }
}

#[test]
fn a_prediction_is_saved_as_an_answer_even_if_the_level_is_lost() {
    for (id, keys, right) in [
        ("dead-stop", "53<Enter><Enter>0<Enter>", true),
        ("dead-stop", "53<Enter><Enter>20<Enter>", false),
        ("half-ball", "<Enter>0<Enter>0<Enter>", false),
    ] {
        let mut game = level(number(id));
        game.press(keys);
        let answers = game.attempts();
        let [answer] = answers.as_slice() else {
            panic!("{answers:?}");
        };
        assert_eq!((answer.family.as_str(), answer.right), (LEVEL, right));
        assert_eq!(answer.question["level"], id);
        assert_eq!(answer.fault(), None, "{answer:?}");
        let one = answer.answer.contains_key("angle_deg");
        assert_eq!(one, id == "dead-stop", "{answer:?}");
    }
}

#[test]
fn without_predictions_the_player_just_shoots() {
    let mut game = level(number("dead-stop"));
    game.press("p53<Enter><Enter>");
    assert!(!game.screen().contains("predict it"));
    assert!(game.settle(LONG));
    assert!(game.screen().contains("Won!"));
    assert!(all_pages(&mut game).contains("predict the paths first"));
}

#[test]
fn a_miss_shows_the_missed_goals_and_keeps_the_aim() {
    let mut game = level(number("dead-stop"));
    game.press("47<Enter>");
    shoot(&mut game);
    let screen = game.screen();
    assert!(screen.contains("Not yet"), "{screen}");
    assert!(squeezed(&screen).contains("required0to0.15m/s"), "{screen}");
    assert!(screen.contains("Enter: try again"), "{screen}");
    game.key(Key::Enter);
    assert!(game.screen().contains("47.0 deg"));
    game.press("20<Enter>");
    shoot(&mut game);
    assert!(squeezed(&game.screen()).contains("wasnotinthefirsthit"));
    assert!(game.screen().contains("shot 2"));
    assert_eq!(game.app().context().shelf.next(), Some(0));
}

#[test]
fn hints_are_shown_one_by_one() {
    let shelf = embedded();
    let (_, dead_stop) = shelf.get(number("dead-stop")).unwrap();
    let mut game = level(number("dead-stop"));
    assert!(!game.screen().contains("Hint"));
    for hint in &dead_stop.hints {
        game.press("h");
        let screen = game.screen();
        let first = hint.split_whitespace().next().unwrap();
        assert!(screen.contains(first), "{screen}");
    }
    assert!(all_pages(&mut game).contains("Hint 2 of 2"));
    assert!(!all_pages(&mut game).contains("another hint"));
}

#[test]
fn the_impact_is_shown_enlarged_with_its_layers() {
    let mut game = level(number("half-ball"));
    shoot(&mut game);
    game.press("i");
    assert!(game.settle(LONG));
    let screen = game.screen();
    assert!(screen.contains("impact 1 of"), "{screen}");
    assert!(screen.contains("separation"), "{screen}");
    game.press("f");
    assert!(squeezed(&game.screen()).contains("moveinoppositedirections"));
    game.key(Key::Escape);
    assert!(game.screen().contains("shot 1"));
    game.key(Key::Escape);
    assert!(game.screen().contains("> direction"));
    game.key(Key::Escape);
    assert!(game.screen().contains("n next to win"));
}

#[test]
fn the_list_shows_the_levels_won_and_the_next_level_follows() {
    let shelf = embedded();
    let mut game = open(Route::Levels, Settings::default(), (80, 24));
    let all = shelf.count();
    assert!(game.screen().contains(&format!("0 of {all} won")));
    game.key(Key::Enter);
    set(&mut game, shelf.get(0).unwrap().1);
    shoot(&mut game);
    game.key(Key::Enter);
    assert!(game.screen().contains(&format!("level 2 of {all}")));
    game.key(Key::Escape);
    let screen = game.screen();
    assert!(screen.contains(&format!("1 of {all} won")), "{screen}");
    assert!(screen.contains("**"), "{screen}");
    assert!(screen.contains("> 2 "), "{screen}");
}

#[test]
fn every_title_fits_the_list_on_a_small_screen() {
    let shelf = embedded();
    let mut game = open(Route::Levels, Settings::default(), (60, 20));
    for (number, (_, level)) in shelf.levels().enumerate() {
        let line = format!("> {} {}", number + 1, level.title);
        let screen = game.screen();
        assert!(screen.contains(&line), "{line}\n{screen}");
        game.key(Key::Down);
    }
}

/// The solution is played after the last hint. It earns no star, and the player's aim stays.
#[test]
fn a_shot_that_wins_is_shown_after_the_last_hint_and_earns_no_star() {
    for (number, (_, level)) in embedded().levels().enumerate() {
        let mut game = open(Route::Level(number), Settings::default(), (80, 24));
        let dial = |screen: &str| {
            screen
                .lines()
                .find(|row| row.contains("> "))
                .map(str::to_owned)
        };
        let before = dial(&game.screen());
        assert!(before.is_some());
        for _ in &level.hints {
            assert!(!game.screen().contains("h show me"), "{}", level.id);
            game.press("h");
        }
        assert!(game.screen().contains("h show me"), "{}", level.id);
        game.press("h");
        assert!(game.settle(LONG));
        let read = all_pages(&mut game);
        assert!(read.contains("This shot wins: "), "{}: {read}", level.id);
        assert!(
            read.contains("It was shown to you and earns no star."),
            "{read}"
        );
        assert!(!read.contains("Won"), "{}: {read}", level.id);
        assert_eq!(game.app().context().shelf.stars(number), 0, "{}", level.id);
        game.press("<Enter>");
        assert_eq!(dial(&game.screen()), before, "{}", level.id);
    }
}

#[test]
fn the_masses_are_shown_while_aiming_except_unknown_ones() {
    let panel = |id: &str| all_pages(&mut level(number(id)));
    for (id, masses) in [
        ("hard-left", "masses 15.0 on 45.0 g"),
        ("two-angles-one-mass", "masses 20.0 on ? g"),
        ("cannon", "masses 15.0 on 15.0 g"),
        ("the-odd-one", "masses 15.0 on ? g"),
    ] {
        let shown = panel(id);
        assert!(shown.contains(masses), "{id}: {shown}");
    }
}

/// In a level about weighing, the mass of the coin is shown only after the win.
#[test]
fn an_unknown_mass_is_shown_after_the_win() {
    let mut game = level(number("two-angles-one-mass"));
    shoot(&mut game);
    game.press("i");
    assert!(game.settle(LONG));
    let screen = game.screen();
    assert!(screen.contains("20.0 on ? g"), "{screen}");
    assert!(!all_pages(&mut game).contains("11"), "{screen}");
    game.press("<Escape><Enter>11<Enter>");
    shoot(&mut game);
    assert!(game.screen().contains("Won!"));
    game.press("i");
    assert!(game.settle(LONG));
    assert!(game.screen().contains("11.0 on 11.0 g"));
}

#[test]
fn the_mouse_aims_the_shot_and_the_wheel_sets_its_speed() {
    let mut game = level(number("follow-on"));
    let before = game.screen();
    game.drag((20, 5), (20, 3));
    let pointed = game.screen();
    assert_ne!(before, pointed);
    assert!(!pointed.contains("40.0 deg"), "{pointed}");
    game.mouse(MouseKind::ScrollUp, (20, 5));
    assert!(game.screen().contains("3.05 m/s"), "{}", game.screen());
}

#[test]
fn the_disc_is_dragged_along_its_line() {
    let mut game = level(number("square-corner"));
    let screen = game.screen();
    let (row, line) = screen
        .lines()
        .enumerate()
        .find(|(_, line)| line.contains("(S)"))
        .unwrap();
    let column = line.find("(S)").unwrap() as u16 + 1;
    game.drag((column, row as u16), (column + 4, row as u16));
    assert!(!game.screen().contains("place                        0 mm"));
    assert!(game.screen().contains("50.0 deg"), "the direction stays");
}

/// A teacher's own folder, with one good level and two invalid ones.
fn own_levels() -> Folder {
    let folder = Folder::new("levels");
    let good = include_str!("../../levels/first-hits/01-dead-stop.toml");
    let own = good
        .replace("dead-stop", "my-own")
        .replace("Dead stop", "Mine");
    folder.file("1-good.toml", own);
    folder.file("2-heavy.toml", good.replace("= 15\n", "= -15\n"));
    folder.file("3-noise.toml", [0xff; 1000]);
    folder
}

#[test]
fn invalid_files_of_a_teacher_are_listed_and_the_rest_can_be_played() {
    let folder = own_levels();
    let arguments = format!("levels --levels '{}'", folder.path().display());
    let mut game = Headless::new(cli::open(&arguments).unwrap(), 80, 40);
    game.press("<End>");
    let screen = game.screen();
    assert!(screen.contains("left out: 2 files"), "{screen}");
    let number = embedded().count() + 1;
    assert!(screen.contains(&format!("{number} Mine")), "{screen}");
    assert!(squeezed(&game.screen()).contains("expectedUTF-8"));
    game.press("<Enter><Up>");
    assert!(squeezed(&game.screen()).contains("disc.mass_g"));
    game.press("<Up><Enter>");
    assert!(game.screen().contains("carrom : Mine"));
    game.press("53<Enter>");
    shoot(&mut game);
    assert!(game.screen().contains("Won!"));
    assert!(all_pages(&mut game).contains("last level"));
}

/// The text of a screen's panel, without spaces and line breaks.
fn squeezed(screen: &str) -> String {
    let side = |line: &str| line.rsplit_once("||").map(|(_, side)| side.to_owned());
    let rows = screen.lines().filter_map(side);
    rows.map(|row| row.replace(['|', ' '], "")).collect()
}

#[test]
fn a_level_is_opened_by_its_name() {
    let title = |arguments: &str| {
        let mut game = Headless::new(cli::open(arguments).unwrap(), 80, 24);
        game.screen().lines().next().unwrap().to_owned()
    };
    assert!(title("levels half-ball").contains("Half a disc"));
    assert!(title("levels first-hits/half-ball").contains("Half a disc"));
    let wrong = cli::open("levels nonsense").err().unwrap();
    assert!(wrong.contains("expected the id of a level"), "{wrong}");
    let wrong = cli::open("levels --levels /no/such/folder").err().unwrap();
    assert!(wrong.contains("expected an existing folder"), "{wrong}");
}

fn keys() -> impl Strategy<Value = Vec<Key>> {
    let named = prop::sample::select(vec![
        Key::Enter,
        Key::Escape,
        Key::Tab,
        Key::BackTab,
        Key::Up,
        Key::Down,
        Key::Left,
        Key::Right,
        Key::PageUp,
        Key::PageDown,
        Key::Home,
        Key::End,
        Key::Backspace,
        Key::Char(' '),
        Key::Char('i'),
        Key::Char('h'),
        Key::Char('n'),
        Key::Char('x'),
    ]);
    let any = prop::char::range(' ', '~').prop_map(Key::Char);
    prop::collection::vec(prop_oneof![3 => named, 1 => any], 0..60)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(12, 48)))]

    #[test]
    fn any_keys_at_any_size_can_be_drawn(
        number in 0usize..embedded().count(),
        keys in keys(),
        sizes in prop::collection::vec((0u16..300, 0u16..100), 1..4),
        clicks in prop::collection::vec((0u16..120, 0u16..40), 0..8),
    ) {
        let mut game = level(number);
        let mut clicks = clicks.into_iter();
        for (i, key) in keys.into_iter().enumerate() {
            game.key(key);
            if i % 5 == 0 {
                game.pass(Duration::from_millis(300));
                if let Some(at) = clicks.next() {
                    game.drag(at, (at.0 + 3, at.1));
                }
            }
            let screen = game.screen();
            prop_assert!(!screen.contains("NaN"));
        }
        for (columns, rows) in sizes {
            game.resize(columns, rows);
            let screen = game.screen();
            prop_assert!(!screen.contains("NaN"));
            // A random U may have switched to Unicode.
            if game.app().settings().charset == Charset::Ascii {
                prop_assert!(screen.bytes().all(|b| b == b'\n' || (b' '..=b'~').contains(&b)));
            }
        }
    }
}

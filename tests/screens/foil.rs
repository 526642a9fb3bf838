//! The foil on the screen, by keys and by mouse.

use std::time::Duration;

use carrom::app::App;
use carrom::messages::Key;
use carrom::screens::{FoilPage, Route, Settings};
use carrom::shells::{FRAME, Headless};

const LONG: Duration = Duration::from_secs(120);

fn foil(predict: bool, seed: u64) -> Headless {
    let settings = Settings {
        predict,
        ..Settings::default()
    };
    Headless::new(
        App::new(Route::Foil(FoilPage::default()), settings, seed),
        100,
        30,
    )
}

/// The page of the beam, set to `10^exponent` particles.
fn beam(exponent: u32, predict: bool, seed: u64) -> Headless {
    let mut game = foil(predict, seed);
    game.press("<Tab><Down><Down><Down><Down><Down><Left><Left><Left>");
    for _ in 3..exponent {
        game.key(Key::Right);
    }
    game
}

/// The number after `name` in the panel.
fn number(game: &mut Headless, name: &str) -> u64 {
    let screen = game.screen();
    let line = screen.lines().find(|line| line.contains(name));
    let value = line.unwrap().rsplit(name).next().unwrap();
    let digits: String = value.chars().filter(char::is_ascii_digit).collect();
    digits.parse().unwrap()
}

#[test]
fn a_beam_of_a_hundred_million_runs_to_its_end() {
    let mut game = beam(8, false, 1);
    assert!(game.screen().contains("100,000,000"));
    game.key(Key::Enter);
    assert_eq!(game.app().wake(), Some(Duration::ZERO));
    assert!(game.settle(LONG));
    assert_eq!(number(&mut game, "|| sent "), 100_000_000);
    // The expected count is 854; the tolerance is five standard deviations.
    let back = number(&mut game, "|| counted ");
    assert!((708..1000).contains(&back), "{back}");
}

#[test]
fn escape_stops_a_beam_at_once_and_enter_continues_it() {
    let mut game = beam(8, false, 1);
    game.key(Key::Enter);
    game.pass(FRAME * 20);
    game.key(Key::Escape);
    assert_eq!(game.app().wake(), None);
    let stopped = number(&mut game, "stopped at");
    assert!((1_000_000..50_000_000).contains(&stopped), "{stopped}");
    game.pass(LONG);
    assert_eq!(number(&mut game, "stopped at"), stopped);
    game.key(Key::Enter);
    game.pass(FRAME * 20);
    assert!(number(&mut game, "sent so far") > stopped);
    // The first Escape stops the beam, and the second leaves the foil.
    game.press("<Escape><Escape>");
    assert!(game.screen().contains("carrom : home"));
}

#[test]
fn a_beam_pauses_while_another_page_is_open() {
    let mut game = beam(8, false, 1);
    game.key(Key::Enter);
    game.pass(FRAME * 5);
    game.press("<Tab>");
    assert_eq!(game.app().wake(), None);
    game.press("<Shift+Tab>");
    assert!(game.screen().contains("stopped at"));
}

#[test]
fn a_seed_determines_the_beam() {
    let thrown = |seed| {
        let mut game = beam(4, false, seed);
        game.key(Key::Enter);
        assert!(game.settle(LONG));
        game.screen()
    };
    assert_eq!(thrown(7), thrown(7));
    assert_ne!(thrown(7), thrown(8));
}

#[test]
fn a_beam_starts_once_the_share_has_been_predicted() {
    let mut game = beam(3, true, 1);
    game.key(Key::Enter);
    assert!(game.screen().contains("how many are deflected"));
    assert_eq!(game.app().wake(), None);
    // Nothing is answered before an option is chosen.
    game.press("<Enter><Enter>");
    assert!(game.screen().contains("how many are deflected"));
    // Option C is half of the particles.
    game.press("c<Enter>");
    assert!(game.settle(LONG));
    assert!(game.screen().contains("59,000"));
    // Another beam with the same settings needs no new prediction; one with other settings does.
    game.key(Key::Enter);
    assert!(game.app().wake().is_some());
    game.press("<Escape><Left><Enter>");
    assert!(game.screen().contains("how many are deflected"));
}

#[test]
fn hard_targets_scatter_back_as_the_closed_forms_predict() {
    // The expected shares are cos² 45° for spheres and cos 45° for discs.
    let mut game = foil(false, 1);
    game.press("<Left><Tab><Enter>");
    assert!(game.settle(LONG));
    let spheres = number(&mut game, "|| counted ");
    assert!((497_500..502_500).contains(&spheres), "{spheres}");
    game.press("<Down><Left><Enter>");
    assert!(game.settle(LONG));
    let discs = number(&mut game, "|| counted ");
    assert!((704_800..709_400).contains(&discs), "{discs}");
}

#[test]
fn the_mouse_turns_pages_and_drags_the_particle() {
    let mut game = foil(true, 1);
    let at = |game: &mut Headless, text: &str| {
        let screen = game.screen();
        let (row, line) = screen
            .lines()
            .enumerate()
            .find(|(_, line)| line.contains(text))
            .unwrap();
        (line.find(text).unwrap() as u16 + 1, row as u16)
    };
    let before = number(&mut game, "offset b");
    game.drag((20, 12), (20, 5));
    assert_ne!(number(&mut game, "offset b"), before);
    let energy = at(&mut game, "energy");
    game.click(energy);
    assert!(game.screen().contains("> energy"));
    let tab = at(&mut game, "counted in 1913");
    game.click(tab);
    assert!(game.screen().contains(">counted in 1913"));
    game.click((20, 12));
    assert!(game.screen().contains("deviation from the law"));
    let tab = at(&mut game, "a beam");
    game.click(tab);
    game.click((20, 12));
    let answer = at(&mut game, "1 in 10,000");
    game.click(answer);
    assert!(game.screen().contains("> G 1 in 10,000"));
}

/// The page compares the counts of 1913 with the law, and explains the “1 in 8000” of 1909.
#[test]
fn the_last_page_shows_what_was_counted_and_what_was_not() {
    let mut game = foil(true, 1);
    game.press("<Tab><Tab>");
    let mut text = String::new();
    for _ in 0..8 {
        let screen = game.screen();
        let rows = screen.lines().filter_map(|line| line.rsplit_once("||"));
        let rows: Vec<&str> = rows
            .map(|(_, side)| side.trim_matches(['|', ' ']))
            .collect();
        text += &(rows.join(" ") + " ");
        game.key(Key::PageDown);
    }
    for said in [
        "-15% to +23%",
        "3.7x10^-7",
        "3.2x10^-7",
        "1909",
        "thick platinum plate",
        "1 in 117,000",
    ] {
        assert!(text.contains(said), "{said} is not in {text}");
    }
}

/// An aluminium nucleus is too light for the law, and its charge is too small; a gold nucleus has
/// neither problem.
#[test]
fn both_pages_warn_about_a_light_nucleus() {
    for (wide, high) in [(80, 24), (120, 40)] {
        let mut game = Headless::new(
            App::new(Route::Foil(FoilPage::default()), Settings::default(), 1),
            wide,
            high,
        );
        for page in ["<Down>", "<Tab>"] {
            game.press(page);
            assert!(
                !panel(&mut game).contains("touching distance"),
                "{wide}: {page}"
            );
        }
        // Aluminium comes before gold.
        game.press("<Shift+Tab><Left>");
        for page in ["", "<Tab>"] {
            game.press(page);
            let text = panel(&mut game);
            for said in [
                "d = 4.9 fm is less than the touching distance of the two nuclei, about 5.5 fm",
                "15 % larger (by the factor 1 + 4/27): 5.6 fm",
            ] {
                assert!(text.contains(said), "{wide}: {said} is not in {text}");
            }
        }
    }
}

/// All of the text in the panel, on one line; the panel is then scrolled back to its top.
fn panel(game: &mut Headless) -> String {
    let mut text = String::new();
    for _ in 0..6 {
        let screen = game.screen();
        let rows = screen.lines().filter_map(|line| line.rsplit_once("||"));
        for row in rows.map(|(_, side)| side.trim_matches(['|', ' '])) {
            text += row;
            text += " ";
        }
        game.key(Key::PageDown);
    }
    for _ in 0..6 {
        game.key(Key::PageUp);
    }
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn a_number_out_of_range_shows_the_range() {
    let mut game = foil(true, 1);
    game.press("<Down><Down>500<Enter>");
    let screen = game.screen();
    assert!(screen.contains("10.00 MeV") && screen.contains("from 4 to 10 MeV"));
    game.press("5<Enter>");
    assert!(!game.screen().contains("from 4 to 10"));
}

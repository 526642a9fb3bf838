//! A measured collision: its conclusion, its settings and its report.

use carrom::app::App;
use carrom::measure::{Given, Measurement, Reading, read};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use carrom::widgets::Charset;

use crate::folder::Folder;

const FILMS: [(&str, &str); 3] = [
    (
        "pucks.txt",
        include_str!("../../assets/examples/measured/pucks.txt"),
    ),
    (
        "coins.csv",
        include_str!("../../assets/examples/measured/coins.csv"),
    ),
    (
        "careless.csv",
        include_str!("../../assets/examples/measured/careless.csv"),
    ),
];

/// The screen after a file has been opened as on the web page: without masses, radii or scale.
fn opened(folder: &Folder, film: usize, size: (u16, u16), charset: Charset) -> Headless {
    let (name, text) = FILMS[film];
    let reading = Reading {
        takes_pixels: true,
        ..Reading::default()
    };
    let tracks = read(&[(name, text.as_bytes())], &reading).unwrap();
    let measurement = Measurement::new(tracks, Given::default()).unwrap();
    let route = Route::Measured(measurement.into());
    let settings = Settings {
        charset,
        ..Settings::default()
    };
    let store = Store::in_folder(folder.path()).at(1_800_000_000);
    Headless::keeping(App::new(route, settings, 1), size.0, size.1, store)
}

fn assert_shows(game: &mut Headless, parts: &[&str]) {
    let screen = game.screen();
    for part in parts {
        assert!(screen.contains(part), "{part}\n{screen}");
    }
}

/// The text of all pages of results.
fn all_results(game: &mut Headless) -> String {
    game.press("a");
    let mut text = String::new();
    for _ in 0..14 {
        text += &game.screen();
        game.press("<PageDown>");
    }
    game.press("<Escape>");
    text
}

#[test]
fn the_first_screen_has_the_conclusion_and_the_main_numbers() {
    let folder = Folder::new("measured");
    for film in 0..FILMS.len() {
        for size in [(80, 24), (120, 40)] {
            for charset in [Charset::Unicode, Charset::Ascii] {
                let mut game = opened(&folder, film, size, charset);
                let numbers = ["u", "v", "e", "angle", "E kept"];
                assert_shows(&mut game, &["Angle between the paths", "all results"]);
                assert_shows(&mut game, &numbers);
            }
        }
    }
}

#[test]
fn every_result_is_one_key_away() {
    let folder = Folder::new("measured");
    let mut game = opened(&folder, 0, (120, 40), Charset::Unicode);
    assert!(!game.screen().contains("Coefficient of restitution"));
    game.press("a");
    assert_shows(
        &mut game,
        &[
            "all results",
            "Coefficient of restitution",
            "Momentum agrees",
        ],
    );
    game.press("<Escape>");
    assert_shows(&mut game, &["what it shows"]);
}

/// With the radii, the line of impact is the line of centres; twice the scale doubles the speeds.
#[test]
fn masses_radii_and_scale_can_be_set_after_opening() {
    let folder = Folder::new("measured");
    let mut game = opened(&folder, 0, (120, 40), Charset::Unicode);
    assert_shows(&mut game, &["The masses are assumed", "0.8079"]);
    game.press("m");
    assert_shows(&mut game, &["mass m₁", "not set", "predict with e"]);
    game.press("30<Enter><Down>30<Enter><Down>25<Enter><Down>25<Enter>");
    assert_shows(&mut game, &["30 g", "25 mm"]);
    game.press("<Escape>");
    let screen = game.screen();
    assert!(!screen.contains("The masses are assumed"), "{screen}");
    let text = all_results(&mut game);
    for part in ["m₁ = 30 g", "m₂ = 30 g", "r₁ = 25 mm", "r₂ = 25 mm"] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    game.press("m<End><Up>2<Enter><Escape>");
    assert_shows(&mut game, &["1.61"]);
    // Scaled tracks contradict the radii, and the screen reports this.
    assert_shows(&mut game, &["The tracks contradict"]);
}

/// A mass that is typed but not confirmed is kept when the player moves to the next row.
#[test]
fn an_unconfirmed_number_is_kept_and_one_mass_alone_is_not_used() {
    let folder = Folder::new("measured");
    let mut game = opened(&folder, 0, (120, 40), Charset::Unicode);
    game.press("m30<Down>");
    assert_shows(&mut game, &["30 g"]);
    game.press("<Escape>");
    assert_shows(&mut game, &["The masses are assumed"]);
    game.press("m60<Enter><Escape>");
    let text = all_results(&mut game);
    assert!(text.contains("m₂ = 60 g"), "{text}");
}

#[test]
fn a_film_in_pixels_opens_and_gets_its_scale_on_the_screen() {
    let folder = Folder::new("measured");
    let mut game = opened(&folder, 2, (120, 40), Charset::Unicode);
    game.press("m<End><Up>0.5<Enter><Escape>a");
    assert_shows(&mut game, &["scale × 0.5"]);
}

#[test]
fn the_report_has_what_was_set() {
    let folder = Folder::new("measured");
    let mut game = opened(&folder, 0, (120, 40), Charset::Unicode);
    game.press("m30<Enter><Down>30<Enter><Escape>e");
    assert_shows(&mut game, &["The report is in"]);
    let (name, html) = game.exports().last().cloned().unwrap();
    assert_eq!(name, "measured-collision.html");
    assert!(html.contains("m₁ = 30 g, m₂ = 30 g"), "{html}");
}

/// In the list of results, a symbol at the start of an item keeps its case: "v₁", not "V₁".
#[test]
fn a_symbol_at_the_start_of_a_result_keeps_its_case() {
    let folder = Folder::new("measured");
    let mut game = opened(&folder, 0, (120, 40), Charset::Unicode);
    let text = all_results(&mut game);
    assert!(
        text.contains("- v₁ along x: ") && !text.contains("V₁"),
        "{text}"
    );
}

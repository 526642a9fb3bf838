//! The lab's notebook, and links to one hit.

use std::time::Duration;

use carrom::app::{App, Data};
use carrom::messages::Key;
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use carrom::widgets::recorded;

use crate::folder::Folder;

const LONG: Duration = Duration::from_secs(120);

fn lab(folder: &Folder) -> Headless {
    let app = App::new(Route::Lab, Settings::default(), 1);
    let store = Store::in_folder(folder.path()).at(1_800_000_000);
    Headless::keeping(app, 120, 40, store)
}

/// Makes twenty hits at α = 4°, 8°, …, 80° with the app's keys, predicting 60° and 30° each time.
fn make_twenty(game: &mut Headless) {
    for number in 1..=20 {
        game.press(&format!("<Down>{}<Enter><Up>", 4 * number));
        game.press("<Enter>60<Enter>30<Enter>");
        assert!(game.settle(LONG));
        game.press("<Escape>");
    }
}

#[test]
fn twenty_hits_are_kept_plotted_exported_and_cleared() {
    let folder = Folder::new("notebook");
    let mut game = lab(&folder);
    make_twenty(&mut game);
    drop(game);
    // After a restart, the hits are still there.
    let mut game = lab(&folder);
    game.press("n");
    let screen = game.screen();
    assert!(
        screen.contains("> 20") && screen.contains("80.0"),
        "{screen}"
    );
    game.press("<Home>");
    assert!(game.screen().contains(">  1"), "{}", game.screen());

    game.press("e");
    let (name, text) = game.exports().last().cloned().unwrap();
    assert_eq!(name, "carrom-notebook.csv");
    let mut table = csv::Reader::from_reader(text.as_bytes());
    let heads = table.headers().unwrap().clone();
    let column = |name: &str| heads.iter().position(|it| it == name).unwrap();
    let rows: Vec<_> = table.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 20);
    for (number, row) in (1..).zip(&rows) {
        let value = |name: &str| row[column(name)].parse::<f64>().unwrap();
        let alpha = f64::from(4 * number);
        // Equal masses at 4 m/s: v1 = u sin α, v2 = u cos α, θ1 = 90° − α, θ2 = α.
        for (name, expected) in [
            ("alpha_deg", alpha),
            ("said_theta1_deg", 60.0),
            ("said_theta2_deg", 30.0),
            ("theta1_deg", 90.0 - alpha),
            ("theta2_deg", alpha),
            ("v1_m_s", 4.0 * alpha.to_radians().sin()),
            ("v2_m_s", 4.0 * alpha.to_radians().cos()),
            ("px_before_g_m_s", 60.0),
            ("px_after_g_m_s", 60.0),
            ("py_after_g_m_s", 0.0),
            ("energy_before_mj", 120.0),
            ("energy_after_mj", 120.0),
        ] {
            assert!((value(name) - expected).abs() < 1e-9, "{name}: {row:?}");
        }
        assert_eq!(&row[column("time")], "2027-01-15T08:00:00Z");
        assert_eq!(&row[column("contact")], "slip");
        assert!(row[column("link")].starts_with("lab=b:"), "{row:?}");
    }

    game.press("<Escape>g");
    let plot = game.screen();
    assert!(
        plot.contains("against") && plot.matches('o').count() >= 19,
        "{plot}"
    );
    game.press("yyyyX");
    assert_ne!(game.screen(), plot);

    game.press("C");
    assert!(game.screen().contains("All 20 hits"), "{}", game.screen());
    game.press("<Escape>");
    assert!(game.screen().contains("Hit 1 of 20"), "{}", game.screen());
    game.press("C<Enter>");
    assert!(
        game.screen().contains("nothing here yet"),
        "{}",
        game.screen()
    );
    drop(game);
    let mut game = lab(&folder);
    game.press("n");
    assert!(
        game.screen().contains("nothing here yet"),
        "{}",
        game.screen()
    );
}

#[test]
fn a_hit_of_the_notebook_can_be_set_up_again() {
    let mut game = Headless::from(App::new(Route::Lab, Settings::default(), 1));
    game.press("12<Enter><Enter>60<Enter>30<Enter><Escape>5<Enter>n<Enter>");
    assert_eq!(game.app().address().0, "lab=b:12");
}

#[test]
fn each_player_has_their_own_notebook_and_a_mystery_coin_is_left_out() {
    let mut game = Headless::from(App::new(Route::Lab, Settings::default(), 1));
    game.press("m<Enter>60<Enter>30<Enter><Escape>n");
    assert!(
        game.screen().contains("nothing here yet"),
        "{}",
        game.screen()
    );
    game.press("<Escape>r<Enter>60<Enter>30<Enter><Escape>n");
    assert!(game.screen().contains(">  1"), "{}", game.screen());
    game.press("<Escape>");
    game.app_mut().settings_mut().player = "Bo".into();
    game.press("n");
    assert!(
        game.screen().contains("nothing here yet"),
        "{}",
        game.screen()
    );
}

/// The words that the web page receives.
fn words(game: &mut Headless) -> String {
    let (_, sheets) = recorded(|| game.screen());
    let items = sheets.iter().flat_map(|sheet| &sheet.sections);
    let items = items.flat_map(|section| &section.items);
    let words = items.map(|item| serde_json::to_string(&item.words).unwrap());
    words.collect::<Vec<_>>().join(" ")
}

#[test]
fn a_hidden_outcome_stays_hidden_until_it_has_been_predicted() {
    let link = "m2:5.5,b:12,e:0.8,hide";
    let settings = Settings {
        predict: false,
        predicted: 3,
        ..Settings::default()
    };
    let route = Data::default().route("lab", link).unwrap();
    let mut game = Headless::new(App::new(route, settings, 1), 80, 24);
    // The exact outcome of this hit: θ1 = 16.6°, θ2 = 23.6°.
    let outcome = ["v1", "v2", "energy kept", "separation"];
    for keys in [
        "",
        "v",
        "p",
        "n",
        "<Enter>",
        "50<Enter>",
        "<Escape>",
        "<Enter>50<Enter>40",
    ] {
        game.press(keys);
        let screen = game.screen();
        for text in outcome {
            assert!(!screen.contains(text), "{keys}: {text}\n{screen}");
            assert!(!words(&mut game).contains(text), "{keys}: {text}");
        }
        assert_eq!(game.app().address().0, format!("lab={link}"), "{keys}");
        assert!(game.app().keys().find(Key::Char('v')).is_none());
    }
    game.press("<Enter>");
    assert!(game.settle(LONG));
    let screen = game.screen();
    assert!(screen.contains("energy kept"), "{screen}");
    game.press("<Escape>");
    assert_eq!(game.app().address().0, "lab=m2:5.5,b:12,e:0.8");
}

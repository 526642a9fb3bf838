//! The lab on the screen, by keys.

use std::time::Duration;

use carrom::app::App;
use carrom::messages::Key;
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;

use crate::every_screen::shows_negative_nothing;

const LONG: Duration = Duration::from_secs(120);

/// The lab without predictions.
fn lab() -> Headless {
    let settings = Settings {
        predict: false,
        ..Settings::default()
    };
    Headless::new(App::new(Route::Lab, settings, 1), 100, 30)
}

/// The value beside a name in the panel.
fn beside(game: &mut Headless, name: &str) -> f64 {
    let screen = game.screen();
    let line = screen.lines().find(|line| line.contains(name));
    let value = line
        .and_then(|line| line.rsplit(name).next())
        .unwrap_or_default();
    let value = value.split_whitespace().next().unwrap_or_default();
    value
        .parse()
        .unwrap_or_else(|_| panic!("{name}: {value}\n{screen}"))
}

/// Equal discs of radius r that approach at speed w and stick at b = 2r sin α: in the
/// centre-of-mass frame ω r = (μ b w / I) r = w sin α / 3, with μ = m/2 and I = m r² + 2 m r².
#[test]
fn discs_that_stick_rotate_about_their_centre_of_mass() {
    for offset_mm in [0.0, 6.0, -15.0, 27.0] {
        let mut game = lab();
        game.press(&format!("b{offset_mm}<Enter><Enter>"));
        assert!(game.settle(LONG));
        let board = game.screen();
        for never in [
            "in opposite directions",
            "share one velocity",
            "v1 =",
            "v2 =",
        ] {
            assert!(!board.contains(never), "{board}");
        }
        assert!(board.contains("V = 2.00 m/s"), "{board}");
        game.press("f");
        let going_round = 4.0 * (offset_mm / 30.0_f64).abs() / 3.0;
        for name in ["striker w1", "coin w2"] {
            let shown = beside(&mut game, name);
            assert!((shown - going_round).abs() < 0.006, "{name} {shown}");
        }
        let screen = game.screen();
        assert!(!screen.contains("in opposite directions"), "{screen}");
        assert_eq!(screen.contains("stay together"), offset_mm != 0.0);
    }
}

#[test]
fn a_number_out_of_range_shows_the_range() {
    let mut game = lab();
    game.press("500<Enter>");
    let screen = game.screen();
    assert!(screen.contains("37.5 mm") && screen.contains("from -37.5 to 37.5 mm"));
    game.key(Key::Down);
    assert!(!game.screen().contains("from -37.5"));
    game.press("<Down><Down>999<Enter>");
    assert!(game.screen().contains("from 0.1 to 20 m/s"));
    game.press("<Down>2<Enter>");
    assert!(game.screen().contains("from 0 to 1"));
    game.press("0.5<Enter>");
    assert!(!game.screen().contains("from 0 to 1"));
}

#[test]
fn at_the_end_both_arrows_are_visible_and_both_discs_are_complete() {
    for set in 0..3 {
        for ratio in [0.1, 0.3, 0.5, 0.75, 0.9] {
            let mut game = lab();
            game.press(&"s".repeat(set));
            let reach = [30.0, 36.55, 28.0][set];
            game.press(&format!("{:.1}<Enter><Enter>", ratio * reach));
            assert!(game.settle(LONG));
            let contact = game.screen();
            game.press("<Space>");
            assert!(game.settle(LONG));
            let end = game.screen();
            let picture = |screen: &str| -> Vec<String> {
                let rows = screen.lines().skip(1).take(28);
                rows.map(|row| row.chars().take(70).collect()).collect()
            };
            let heads = |screen: &str| {
                let picture = picture(screen).join("\n");
                ["v1 = ", "v2 = "].map(|name| picture.matches(name).count())
            };
            assert_eq!(heads(&end), [1, 1], "{set} {ratio}\n{end}");
            assert_eq!(heads(&end), heads(&contact));
            // If a disc left the picture, its letter would be outside, or the frame would cut off
            // its rim.
            let rows = picture(&end);
            let letters = |letter| rows.iter().any(|row| row.contains(letter));
            assert!(letters('S') && letters('C'), "{set} {ratio}\n{end}");
        }
    }
}

#[test]
fn a_negligible_number_has_no_sign() {
    for (field, values) in [
        (0, ["-0.04", "-0", "0", "-1e-9"]),
        (1, ["-0.04", "-0", "0", "-1e-9"]),
        (2, ["-0.4", "-0", "360", "-360"]),
        (11, ["-0.4", "-0", "360", "-360"]),
    ] {
        for value in values {
            let mut game = Headless::new(App::new(Route::Lab, Settings::default(), 1), 100, 30);
            game.press(&"<Down>".repeat(field));
            game.press(&format!("{value}<Enter>"));
            let mut seen = vec![game.screen()];
            game.press("<Enter>-0.04<Enter>");
            seen.push(game.screen());
            game.press("-0.04<Enter>");
            assert!(game.settle(LONG));
            seen.push(game.screen());
            for screen in seen {
                assert!(
                    !shows_negative_nothing(&screen),
                    "{field} {value}\n{screen}"
                );
            }
        }
    }
}

/// Predicts both directions of the worked shot correctly.
fn say_it_right(game: &mut Headless) {
    game.press("<Enter>60<Enter>30<Enter>");
    assert!(game.settle(LONG));
    game.press("<Escape>");
}

#[test]
fn the_picture_is_live_after_three_right_predictions_and_not_before() {
    let mut game = Headless::new(App::new(Route::Lab, Settings::default(), 1), 100, 30);
    game.press("<Enter>10<Enter>80<Enter>");
    assert!(game.settle(LONG));
    game.press("<Escape>");
    for _ in 0..3 {
        game.press("v");
        let screen = game.screen();
        assert!(screen.contains("right predictions"), "{screen}");
        game.press("<Escape>");
        assert!(!game.screen().contains("live:"), "{}", game.screen());
        say_it_right(&mut game);
    }
    assert!(
        !game.screen().contains("60.0"),
        "the picture is live only on request"
    );
    game.press("v");
    assert!(game.screen().contains("live:") && game.screen().contains("60.0"));
    // α = 45° at b = 30 mm sin 45° = 21.2 mm; discs that stick have no curves.
    game.press("<Down>45<Enter>");
    assert!(game.screen().contains("45.0 deg") && game.screen().contains("speed, in units"));
    game.press("b");
    assert!(
        !game.screen().contains("speed, in units"),
        "{}",
        game.screen()
    );
    // The unknown mass is not revealed.
    game.press("bm");
    assert!(!game.screen().contains("live:"), "{}", game.screen());
}

#[test]
fn the_set_up_of_the_lab_is_saved_but_not_that_of_a_chapter() {
    let mut game = Headless::new(App::new(Route::Lab, Settings::default(), 1), 80, 24);
    game.press("-12<Enter><Escape>l");
    assert!(game.screen().contains("12.0 mm left"), "{}", game.screen());
    game.press("<Escape>e<Home><Down><Enter>o");
    assert!(game.screen().contains("30.0"), "{}", game.screen());
    game.press("7<Enter><Escape><Escape><Escape>l");
    assert!(game.screen().contains("12.0 mm left"), "{}", game.screen());
}

/// The lab with the setting that asks what the player saw.
fn watched_lab() -> Headless {
    let settings = Settings {
        sees: true,
        ..Settings::default()
    };
    Headless::new(App::new(Route::Lab, settings, 1), 100, 30)
}

#[test]
fn what_was_seen_is_asked_before_any_angle_and_kept_apart_from_the_answers() {
    let mut game = watched_lab();
    game.press("<Enter>30<Enter>60<Enter>");
    for _ in 0..100 {
        let screen = game.screen();
        if screen.contains("What did you see?") {
            break;
        }
        for number in ["v1", "v2", "30.0", "60.0", "theta"] {
            assert!(!screen.contains(number), "{number}\n{screen}");
        }
        game.pass(Duration::from_millis(50));
    }
    // Nothing is filled in, and Enter alone gives no answer.
    let screen = game.screen();
    assert!(screen.matches(" _ ").count() >= 2, "{screen}");
    game.press("<Enter><Enter>");
    assert!(game.screen().contains("What did you see?"));
    game.press("32<Enter>57<Enter><End>");
    let screen = game.screen();
    assert!(
        screen.contains("you saw") && screen.contains("32.0, 57.0"),
        "{screen}"
    );
    assert!(screen.contains("saw something closer"), "{screen}");
    let history = game.history();
    assert_eq!(history.attempts, []);
    let [seen] = &history.observations[..] else {
        panic!("{:?}", history.observations);
    };
    assert!(seen.follows_prediction() && !seen.is_right() && !seen.was_expected());
    assert!((seen.truth.striker.unwrap().to_degrees() - 60.0).abs() < 1e-9);
}

#[test]
fn what_was_seen_can_be_skipped_and_switched_off() {
    let mut game = watched_lab();
    game.press("<Enter>60<Enter>30<Enter>s");
    assert!(game.settle(LONG));
    assert!(game.screen().contains("energy kept"), "{}", game.screen());
    assert_eq!(game.history().observations, []);
    game.press("<Escape>");
    game.app_mut().settings_mut().observe = false;
    game.press("<Enter>60<Enter>30<Enter>");
    assert!(game.settle(LONG));
    assert!(game.screen().contains("energy kept"), "{}", game.screen());
}

const TO_FRICTION: &str =
    "<Home><Down><Down><Down><Down><Down><Down><Down><Down><Down><Down><Down><Down>";

/// 15 g discs at 30° and 4 m/s: the impulse of friction could be up to 10.4 g m/s, but 5 g m/s
/// stops the slip, so both discs spin at 2 × 5 / (15 × 0.015) = 44.4 rad/s.
#[test]
fn rim_friction_adds_a_step_and_shows_both_spins_before_and_after() {
    let mut game = lab();
    game.press(TO_FRICTION);
    assert!(
        game.screen().contains("friction between the"),
        "{}",
        game.screen()
    );
    assert!(!game.screen().contains("spin"), "{}", game.screen());
    game.press("0.2<Enter>");
    assert!(game.screen().contains("coin spin"), "{}", game.screen());
    game.press("<Enter>");
    let mut steps = Vec::new();
    for _ in 0..7 {
        game.press(" ");
        steps.push(game.screen());
    }
    for (step, part) in [
        (0, "1 of 7: contact"),
        (0, "omega1 = 0.0"),
        (3, "4 of 7: friction at the"),
        (3, "J_t on the coin = 5.00 g m/s"),
        (3, "J_t = 5.00 g m/s"),
        (3, "omega2 = -44.4"),
        (4, "v2_t = 0.33 m/s"),
        (6, "0.0 -> -44.4"),
    ] {
        assert!(steps[step].contains(part), "{part}\n{}", steps[step]);
    }
    let screen = game.screen();
    for part in ["5.5 deg", "84.5 deg", "24.5 deg", "95.8 %"] {
        assert!(screen.contains(part), "{part}\n{screen}");
    }
    // Discs that stick do not slip, so the setting is locked.
    game.press("<Escape>b");
    game.press(TO_FRICTION);
    game.press("<Right>");
    assert!(
        game.screen().contains("Discs that stick do not"),
        "{}",
        game.screen()
    );
}

//! The player's own keys, from a file to the screen.

use std::process::Command;

use carrom::cli;
use carrom::shells::Headless;
use carrom::widgets::input::KeyRow;

use crate::folder::Folder;

fn lab(folder: &Folder) -> Headless {
    let path = folder.path().to_str().unwrap();
    let app = cli::open(&format!("--data-dir '{path}' lab")).unwrap();
    Headless::new(app, 80, 24)
}

#[test]
fn the_players_own_key_works_and_is_shown_in_the_help() {
    let folder = Folder::new("rebound");
    let text = "format = 1\n[keys]\n\"lab.next-set\" = [\"z\"]\n";
    folder.file("keys.toml", text);
    let mut game = lab(&folder);
    let before = game.screen();
    game.press("s");
    assert_eq!(game.screen(), before, "the default key no longer works");
    game.press("z");
    assert_ne!(game.screen(), before);
    assert!(game.screen().contains("z pieces"));
    game.press("?<PageDown><PageDown><PageDown>");
    assert!(game.screen().contains("next set of pieces"));
}

#[test]
fn a_bad_file_is_reported_line_by_line_and_the_default_keys_are_used() {
    let folder = Folder::new("rebound-bad");
    let text = "format = 1\n[keys]\n\"lab.nothing\" = [\"z\"]\n\"everywhere.help\" = [\"Hlep\"]\n";
    folder.file("keys.toml", text);
    let mut game = lab(&folder);
    let screen = game
        .screen()
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    for told in [
        "carrom uses the default keys.",
        "keys.toml:3: keys.lab.nothing: unknown action",
        "keys.toml:4: keys.everywhere.help: expected a key",
    ] {
        let told = told.replace(' ', "");
        let screen = screen.replace([' ', '|'], "");
        assert!(screen.contains(&told), "{told}\n{screen}");
    }
    game.press(" ");
    game.press("?");
    assert!(game.screen().contains("help: lab"));
}

#[test]
fn keys_that_once_scrolled_only_the_lab_scroll_every_panel() {
    let folder = Folder::new("rebound-scroll");
    let text = "format = 1\n[keys]\n\"lab.scroll\" = [\"F9\", \"F10\"]\n";
    folder.file("keys.toml", text);
    let mut game = lab(&folder);
    game.press("<Enter>60<Enter>30<Enter>");
    let keys = game.app().keys();
    let row = keys.rows().iter().find(|row| row.id == "everywhere.scroll");
    assert_eq!(row.map(KeyRow::shown).as_deref(), Some("F9 F10"));
}

#[test]
fn the_printed_key_table_is_a_valid_key_file() {
    let folder = Folder::new("rebound-all");
    let path = folder.path().to_str().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(["--data-dir", path, "keys"])
        .output()
        .unwrap();
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("\"everywhere.help\" = [\"?\"]  # explain this screen"),
        "{text}"
    );
    folder.file("keys.toml", &text);
    let usual = Headless::new(cli::open("lab").unwrap(), 80, 24).screen();
    assert_eq!(lab(&folder).screen(), usual);
}

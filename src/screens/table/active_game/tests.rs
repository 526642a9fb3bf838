mod presses;

use std::time::Duration;

use super::*;
use crate::game::SavedGame;
use crate::messages::{FileContent, Key};
use crate::screens::Settings;
use crate::widgets::hit::HitPace;

fn still() -> Context {
    let settings = Settings {
        reduced_motion: true,
        ..Settings::default()
    };
    Context::new(settings, 1)
}

fn playing(options: Options) -> Playing {
    ActiveGame::new(options, 4).into()
}

/// Options with a computer at every seat.
fn computers() -> Options {
    Options::default().with(|options| options.company.players = [Player::Computer; 4])
}

fn press(playing: &mut Playing, keys: &str, cx: &mut Context) {
    for letter in keys.chars() {
        let key = match letter {
            '\n' => Key::Enter,
            '\t' => Key::Tab,
            '^' => Key::Up,
            other => Key::Char(other),
        };
        if let Some(action) = playing.keys().find(key) {
            playing.act(action, cx);
        }
    }
}

/// Asserts that replaying the record gives the game on the table, bit for bit, even after it has
/// been written to a file and read back.
fn assert_recorded(active: &ActiveGame, cx: &Context) {
    let FileContent::Game(saved) = active.saved(cx) else {
        panic!("a game is saved as a game");
    };
    let text = saved.text().unwrap();
    let (read, game) = SavedGame::read("a game", text.as_bytes()).unwrap();
    assert_eq!(&game, active.game());
    let again = ActiveGame::resume_saved(&read, 1).unwrap();
    assert_eq!(again.options, active.options);
    assert_eq!(again.history.len(), active.history.len());
    assert_eq!(again.calls(), active.calls());
}

#[test]
fn replaying_the_record_gives_the_game_on_the_table() {
    let mut cx = still();
    let mut people = playing(Options::two_people());
    press(&mut people, "c[[97.3 60\n30\n\n", &mut cx);
    press(&mut people, "c]]]]268 \n+++++}101 \n{{300.55 \n", &mut cx);
    assert_eq!(people.game.history.len(), 4);
    assert!(people.game.history.past(0).unwrap().called.is_some());
    assert_recorded(&people.game, &cx);

    let options = Options::default();
    let mut practice = playing(options.with(|it| it.setup.rules = Rules::Practice));
    press(&mut practice, "91 \np\t ^^^^^^^^ p80 \n85 \nz", &mut cx);
    assert_eq!(practice.game.history.len(), 3);
    assert_recorded(&practice.game, &cx);
}

#[test]
fn the_computer_shows_its_stroke_and_then_plays_it() {
    let mut cx = still();
    let mut playing = playing(computers());
    // No key press is needed.
    assert!(playing.wake(HitPace::Still).is_some());
    playing.advance(Duration::ZERO, &mut cx);
    assert!(matches!(playing.phase, GamePhase::Show(_)));
    assert_eq!(playing.game.history.len(), 0);
    playing.advance(Duration::from_secs(2), &mut cx);
    assert!(matches!(playing.phase, GamePhase::Watch(_)));
    assert!(playing.game.history.past(0).unwrap().meant.is_some());
    assert_recorded(&playing.game, &cx);
    press(&mut playing, "\n", &mut cx);
    assert!(matches!(playing.phase, GamePhase::Show(_)));
}

#[test]
fn computers_play_on_by_themselves_unless_steps_wait_for_a_key() {
    let mut cx = Context::new(Settings::default(), 1);
    let mut playing = playing(computers());
    while !matches!(playing.phase, GamePhase::Watch(_)) {
        playing.advance(playing.wake(HitPace::Flowing).unwrap(), &mut cx);
    }
    let mut waits = playing.clone();
    let mut passed = 0;
    while matches!(playing.phase, GamePhase::Watch(_)) {
        let wake = playing.wake(HitPace::Flowing);
        assert!(wake.is_some() && passed < 100_000);
        playing.advance(wake.unwrap(), &mut cx);
        passed += 1;
    }
    assert!(matches!(playing.phase, GamePhase::Show(_)));
    // If steps wait for a key, the computers wait, too.
    cx.settings.wait_at_beats = true;
    waits.advance(Duration::from_secs(60), &mut cx);
    waits.advance(Duration::from_secs(60), &mut cx);
    assert!(matches!(waits.phase, GamePhase::Watch(_)));
    assert_eq!(waits.wake(HitPace::Waiting), None);
}

#[test]
fn nothing_moves_except_a_stroke_that_is_being_watched() {
    let mut cx = Context::new(Settings::default(), 1);
    let mut playing = playing(Options::two_people());
    playing.advance(Duration::from_secs(2), &mut cx);
    assert_eq!(playing.wake(HitPace::Still), None);
    press(&mut playing, " ", &mut cx);
    assert!(playing.wake(HitPace::Still).is_some());
    playing.advance(Duration::from_secs(60), &mut cx);
    assert_eq!(playing.wake(HitPace::Still), None);
}

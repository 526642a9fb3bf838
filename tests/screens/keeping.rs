//! The messages that the player sees when saving is slow or fails.

use std::fs;
use std::path::PathBuf;
use std::time::Duration;

use carrom::app::App;
use carrom::messages::{Input, StoreAnswer, StoreCall, StoreReply, StoreRequest};
use carrom::quiz::Code;
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;

use crate::folder::Folder;

#[test]
fn slow_and_failed_saves_are_reported_each_time() {
    let app = App::new(Route::Lab, Settings::default(), 1);
    let mut game = Headless::from(app);
    let kept = |ticket, unsaved| {
        let done = match unsaved {
            0 => Ok(()),
            _ => Err("it is locked".into()),
        };
        Input::Kept(Box::new(StoreAnswer {
            ticket,
            done: StoreReply::Noted(done),
            unsaved,
            notice: None,
        }))
    };
    let head = |game: &mut Headless| game.screen().lines().next().unwrap().to_owned();
    let calm = head(&mut game);
    game.input(&Input::Saving(901));
    assert!(head(&mut game).contains("saving"));
    game.input(&kept(901, 0));
    assert_eq!(head(&mut game), calm);
    game.input(&Input::Saving(902));
    game.input(&kept(902, 1));
    assert!(head(&mut game).contains("not saved: 1"));
    assert!(game.screen().contains("it is locked"));
    game.press("?");
    game.input(&kept(903, 2));
    assert!(
        head(&mut game).contains("not saved: 2"),
        "{}",
        game.screen()
    );
    assert!(
        !game.screen().contains("it is locked"),
        "the notice does not appear each time"
    );
    // After a successful save, another failure is reported again.
    game.input(&kept(904, 0));
    assert_eq!(head(&mut game), calm);
    game.input(&kept(905, 1));
    assert!(game.screen().contains("it is locked"));
    assert!(head(&mut game).contains("not saved: 1"));
}

/// A store that cannot write as long as a file occupies the place of its folder.
struct Blocked(Folder);

impl Blocked {
    fn new(name: &str) -> Self {
        let blocked = Self(Folder::new(name));
        fs::write(blocked.place(), "").unwrap();
        blocked
    }

    fn place(&self) -> PathBuf {
        self.0.path().join("data")
    }

    fn free(&self) {
        fs::remove_file(self.place()).unwrap();
    }

    fn game(&self, place: Route) -> Headless {
        let app = App::new(place, Settings::default(), 7);
        Headless::keeping(app, 80, 24, Store::in_folder(&self.place()).timeless())
    }

    /// The numbers of the answered questions, as they are saved.
    fn kept(&self) -> Vec<u32> {
        let request = StoreRequest::Recall(None);
        let mut store = Store::in_folder(&self.place()).only_looking();
        match store.answer(&StoreCall { ticket: 0, request }).done {
            StoreReply::Recalled(Ok(history)) => {
                history.attempts.iter().map(|it| it.number).collect()
            }
            other => panic!("{other:?}"),
        }
    }
}

fn a_round() -> Route {
    let code = Some(Code::hits(7));
    Route::Quiz(code)
}

/// Closes a notice, if there is one.
fn heed(game: &mut Headless) {
    if game.screen().contains("please note") {
        game.press("x");
    }
}

/// Answers the question on the screen.
fn answer(game: &mut Headless) {
    game.press("60<Enter>30<Enter>2");
    heed(game);
    game.press("<End><Enter>");
}

#[test]
fn unsaved_changes_are_saved_later_in_their_order() {
    let blocked = Blocked::new("keeping-later");
    let mut game = blocked.game(a_round());
    for unsaved in 1..=3 {
        answer(&mut game);
        let screen = game.screen();
        assert!(
            screen.contains(&format!("not saved: {unsaved}")),
            "{screen}"
        );
    }
    game.pass(Duration::from_secs(5));
    assert!(game.screen().contains("not saved: 3"));
    blocked.free();
    game.pass(Duration::from_secs(5));
    assert!(!game.screen().contains("not saved"), "{}", game.screen());
    assert_eq!(blocked.kept(), [1, 2, 3]);
    assert_eq!(game.app().wake(), None, "no retry is left");
    answer(&mut game);
    assert_eq!(blocked.kept(), [1, 2, 3, 4]);
}

#[test]
fn the_next_answer_saves_pending_ones_first() {
    let blocked = Blocked::new("keeping-next");
    let mut game = blocked.game(a_round());
    answer(&mut game);
    answer(&mut game);
    blocked.free();
    answer(&mut game);
    assert_eq!(blocked.kept(), [1, 2, 3]);
    assert!(!game.screen().contains("not saved"));
}

#[test]
fn leaving_with_unsaved_answers_is_confirmed() {
    for keys in ["<Ctrl+C>", "q", "<Escape>y"] {
        let blocked = Blocked::new("keeping-leave");
        let mut game = blocked.game(a_round());
        answer(&mut game);
        if keys != "<Ctrl+C>" {
            game.press("<Escape>y");
            heed(&mut game);
            game.press("<Escape>");
        }
        assert!(game.screen().contains("not saved: 1"), "{}", game.screen());
        let before = game.screen();
        game.press(keys);
        assert!(
            game.screen().contains("Leave?"),
            "{keys}: {}",
            game.screen()
        );
        assert!(!game.has_quit());
        game.press("n");
        assert_eq!(game.screen(), before);
        game.press(keys);
        // As soon as everything is saved, leaving needs no confirmation.
        blocked.free();
        game.pass(Duration::from_secs(5));
        assert!(!game.screen().contains("Leave?"), "{}", game.screen());
        game.press(keys);
        assert!(game.has_quit());
        assert_eq!(blocked.kept(), [1]);
    }
    let blocked = Blocked::new("keeping-leave-twice");
    let mut game = blocked.game(a_round());
    answer(&mut game);
    game.press("<Ctrl+C><Ctrl+C>");
    assert!(
        game.has_quit(),
        "a second request leaves without confirmation"
    );
}

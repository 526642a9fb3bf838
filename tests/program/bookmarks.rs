//! carrom saves each player's position in each chapter, and keeps it even if the chapter changes.

use std::fs;
use std::path::Path;
use std::time::Duration;

use carrom::app::{App, Data};
use carrom::files::FileLibrary;
use carrom::lessons::{Book, ChapterLibrary};
use carrom::messages::{Effect, Input, Key, StoreCall, StoreReply, StoreRequest};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use crate::child::{self, Player};
use crate::folder::Folder;
#[cfg(unix)]
use crate::pty::{Pty, carrom as carrom_in_terminal};

fn settings(player: &str) -> Settings {
    Settings {
        reduced_motion: true,
        player: player.into(),
        ..Settings::default()
    }
}

/// Opens the contents, or the chapter with this number (counted from 1), for a player.
fn open(folder: &Path, player: &str, chapter: Option<usize>) -> Headless {
    let place = chapter.map_or(Route::Learn, |number| Route::Chapter(number - 1));
    let app = App::new(place, settings(player), 1);
    Headless::keeping(app, 80, 24, Store::in_folder(folder))
}

fn shows(game: &mut Headless, text: &str) {
    let screen = game.screen();
    assert!(screen.contains(text), "{text} is not shown:\n{screen}");
}

/// The number of answers stored in a folder.
fn attempts(folder: &Path) -> usize {
    open(folder, "anyone", None).attempts().len()
}

#[test]
fn a_chapter_reopens_where_it_was_left() {
    let folder = Folder::new("bookmarks-place");
    let mut game = open(folder.path(), "Ada", Some(2));
    shows(&mut game, "page 1 of 5");
    game.press("2<Enter>nn");
    shows(&mut game, "page 3 of 5");
    drop(game);
    // Open the chapter directly, and from the contents.
    let mut game = open(folder.path(), "Ada", Some(2));
    shows(&mut game, "page 3 of 5");
    let mut game = open(folder.path(), "Ada", None);
    shows(&mut game, "read 3 of 5");
    game.press("<Home><Down>");
    shows(&mut game, "read on at page 3");
    shows(&mut game, "3 of 5");
    game.press("<Enter>");
    shows(&mut game, "page 3 of 5");
    game.press("bb");
    shows(&mut game, "+ Along the line");
    // After "ask again", the question is still open when the chapter is opened again.
    game.press("r");
    drop(game);
    let mut game = open(folder.path(), "Ada", Some(2));
    shows(&mut game, "page 1 of 5");
    assert!(!game.screen().contains("+ Along the line"));
    assert_eq!(attempts(folder.path()), 1, "the record of answers stays");
}

#[test]
fn a_finished_chapter_opens_at_its_first_page() {
    let folder = Folder::new("bookmarks-end");
    let mut game = open(folder.path(), "Ada", Some(2));
    game.press("nnnnn");
    shows(&mut game, "carrom : learn");
    let mut game = open(folder.path(), "Ada", None);
    shows(&mut game, "right 0 of 3");
    game.press("<Home><Down>");
    shows(&mut game, "Enter: read it.");
    game.press("<Enter>");
    shows(&mut game, "page 1 of 5");
}

#[test]
fn the_value_of_a_dial_is_saved() {
    let folder = Folder::new("bookmarks-dial");
    for leave in ["<Escape>", "n"] {
        let mut game = open(folder.path(), "Ada", Some(3));
        game.press("Ry");
        while !game.screen().contains("A shot of your own") {
            game.press("n");
        }
        game.press("<Home><Right><Right><Right>");
        shows(&mut game, "alpha = 3 deg");
        game.press(leave);
        drop(game);
        let mut game = open(folder.path(), "Ada", Some(3));
        if leave == "n" {
            game.press("<PageUp>");
        }
        shows(&mut game, "alpha = 3 deg");
    }
}

#[test]
fn each_player_has_bookmarks_of_their_own() {
    let folder = Folder::new("bookmarks-players");
    open(folder.path(), "Ada", Some(2)).press("nn");
    open(folder.path(), "Bo", Some(2)).press("n");
    shows(&mut open(folder.path(), "Ada", Some(2)), "page 3 of 5");
    shows(&mut open(folder.path(), "Bo", Some(2)), "page 2 of 5");
    shows(&mut open(folder.path(), "球", Some(2)), "page 1 of 5");
    // Deleting one player's bookmarks does not delete the other player's.
    open(folder.path(), "Ada", None).press("Ay");
    shows(&mut open(folder.path(), "Ada", Some(2)), "page 1 of 5");
    shows(&mut open(folder.path(), "Bo", Some(2)), "page 2 of 5");
}

#[test]
fn the_bookmarks_of_one_chapter_or_of_all_can_be_deleted() {
    let folder = Folder::new("bookmarks-reset");
    for chapter in [1, 2, 3] {
        open(folder.path(), "Ada", Some(chapter)).press("2<Enter>n");
    }
    let answered = attempts(folder.path());
    assert!(answered > 0);
    let mut game = open(folder.path(), "Ada", None);
    game.press("<Home><Down>R");
    shows(&mut game, "Forget chapter 2?");
    shows(&mut game, "y forget it");
    game.press("n");
    shows(&mut game, "read 2 of 5");
    assert!(!game.screen().contains("Forget"));
    game.press("Ry");
    assert!(!game.screen().contains("read 2 of 5"));
    shows(&mut open(folder.path(), "Ada", Some(2)), "page 1 of 5");
    shows(&mut open(folder.path(), "Ada", Some(3)), "page 2 of");
    let mut game = open(folder.path(), "Ada", None);
    game.press("A");
    shows(&mut game, "Forget all chapters?");
    game.press("<Escape>");
    shows(&mut game, "carrom : learn");
    game.press("Ay");
    for mut game in [game, open(folder.path(), "Ada", None)] {
        let screen = game.screen();
        assert!(!screen.contains("2/"), "{screen}");
        game.press("A");
        assert!(!game.screen().contains("Forget"), "there is nothing left");
    }
    // Delete the bookmark from within a chapter.
    let mut game = open(folder.path(), "Ada", Some(3));
    game.press("nnRy");
    shows(&mut game, "page 1 of");
    shows(&mut open(folder.path(), "Ada", Some(3)), "page 1 of");
    assert_eq!(
        attempts(folder.path()),
        answered,
        "the record of answers stays"
    );
}

const HEADER: &str = "+++\nformat = 1\ntitle = \"Mine\"\nabout = \"A\"\n+++\n";
const ASKED: &str =
    ":::choice\nWhich one?\n- [ ] This.\n  Said to this.\n- [x] That.\n  Said to that.\n:::\n\n";

/// Opens the player's own chapter with these pages, at its bookmark.
fn own(folder: &Path, pages: &str) -> Headless {
    let file = folder.join("77-mine.md");
    fs::write(&file, format!("{HEADER}{pages}")).unwrap();
    let mut library = ChapterLibrary::default();
    library.add_file(&file);
    assert_eq!(library.problems, []);
    let place = Route::Chapter(0);
    let book = Book::new(library);
    let data = Data {
        book,
        ..Data::default()
    };
    let app = App::with_data(data, place, settings("Ada"), 1);
    Headless::keeping(app, 80, 24, Store::in_folder(folder))
}

#[test]
fn a_chapter_that_has_changed_still_opens() {
    let text = "Text.\n\n";
    let one = format!("# One\n{text}");
    let two = format!("# Two\n{ASKED}");
    let three = format!("# Three\n{text}");
    let before = format!("{one}{two}{three}");
    let asked_anew = two.replace("Which one?", "Which is it?");
    let number =
        format!("# Two\n:::number answer=1 tolerance=1\nHow many?\n---\nOne.\n:::\n\n{three}");
    let zero = "# Zero\nText.\n\n";
    for (pages, page, answered) in [
        (before.clone(), "page 2 of 3", true),
        (format!("{zero}{before}"), "page 3 of 4", true),
        (format!("{two}{one}"), "page 1 of 2", true),
        (one.clone(), "page 1 of 1", false),
        (
            format!("{one}{}", two.replace("Two", "2")),
            "page 1 of 2",
            false,
        ),
        (format!("{one}{asked_anew}"), "page 2 of 2", false),
        (format!("{one}{number}"), "page 2 of 3", false),
    ] {
        let folder = Folder::new("bookmarks-changed");
        let mut game = own(folder.path(), &before);
        game.press("nn");
        game.press("b2<Enter>");
        shows(&mut game, "Said to that.");
        let mut game = own(folder.path(), &pages);
        shows(&mut game, page);
        assert_eq!(game.screen().contains("Said to that."), answered, "{pages}");
        // The chapter can be read to the end, and is then done.
        game.press(&"b".repeat(5));
        for key in ["1", "<Enter>", "n"].repeat(5) {
            // In the list of chapters, `n` takes the next step, which leads out of the chapters.
            if key != "n" || !game.screen().contains("carrom : learn") {
                game.press(key);
            }
        }
        // This may lead to the first screen, which asks for confirmation before carrom ends.
        game.press("<Escape><Escape>");
        if game.screen().contains("Leave carrom?") {
            game.press("n");
        }
        game.press("e");
        shows(&mut game, "1 of 1 chapters done");
        // If the chapter is restored, the bookmarks that fit it are shown again.
        let mut game = own(folder.path(), &before);
        game.press("<Escape>");
        shows(&mut game, "of 3");
    }
}

fn drawn(app: &App) -> String {
    use ratatui::{Terminal, backend::TestBackend};
    let mut terminal = Terminal::new(TestBackend::new(80, 24)).unwrap();
    terminal.draw(|frame| app.draw(frame)).unwrap();
    carrom::widgets::cells::text(terminal.backend().buffer())
}

#[test]
fn nothing_is_shown_or_saved_before_the_bookmark_is_known() {
    let folder = Folder::new("bookmarks-waiting");
    open(folder.path(), "Ada", Some(2)).press("2<Enter>nn");
    let mut store = Store::in_folder(folder.path());
    for place in [Route::Learn, Route::Chapter(1)] {
        let mut app = App::new(place, settings("Ada"), 1);
        let asked = app.update(&Input::Resize(80, 24));
        // The contents page also requests the data that the next step depends on.
        let Some(Effect::Keep(request)) = asked.first() else {
            panic!("{asked:?}");
        };
        assert_eq!(request.request, StoreRequest::Marks("Ada".into()));
        for key in [
            Key::Char('n'),
            Key::Down,
            Key::Enter,
            Key::Char('R'),
            Key::Char('y'),
        ] {
            assert_eq!(app.update(&Input::Key(key)), [], "{key}");
            let screen = drawn(&app);
            assert!(screen.contains("Loading"), "{screen}");
            for wrong in ["done", "page 1", "0 of", "/5"] {
                assert!(!screen.contains(wrong), "{wrong}\n{screen}");
            }
        }
        let answer = store.answer(request);
        let _ = app.update(&Input::Kept(Box::new(answer)));
        let screen = drawn(&app);
        assert!(
            screen.contains("read 3 of 5") || screen.contains("page 3 of 5"),
            "{screen}"
        );
    }
}

#[test]
fn without_storage_data_is_kept_in_memory() {
    let folder = Folder::new("bookmarks-nowhere");
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    for store in [Store::in_folder(&file), Store::nowhere()] {
        let app = App::new(Route::Chapter(1), settings("Ada"), 1);
        let mut game = Headless::keeping(app, 80, 24, store);
        shows(&mut game, "Your progress cannot be saved");
        game.press("x");
        shows(&mut game, "page 1 of 5");
        game.press("2<Enter>nn");
        assert!(
            !game.screen().contains("cannot be saved"),
            "the notice is shown once"
        );
        game.press("<Escape>");
        shows(&mut game, "read 3 of 5");
        game.press("<Escape>e<Home><Down><Enter>");
        shows(&mut game, "page 3 of 5");
        game.press("<Escape>Ry");
        assert!(!game.screen().contains("read 3 of 5"));
    }
}

/// Reads a chapter again and again, answers its questions, and reports how many pages it has
/// turned.
#[test]
fn child_reads() {
    let Some((folder, words)) = child::told() else {
        return;
    };
    let chapter = words[1].parse().unwrap();
    let mut game = open(&folder, &words[0], Some(chapter));
    for number in 1..=words[2].parse().unwrap() {
        // Answers with a number, with a choice, or with one ray and then the other.
        while game.screen().contains("n skip") {
            game.press("1<Enter>");
        }
        game.settle(Duration::from_secs(60));
        game.press("n");
        if game.screen().contains("carrom : learn") {
            game.press("<Up><Enter>");
        }
        assert!(!game.screen().contains("please note"));
        child::say(number);
    }
}

fn marks(
    folder: &Path,
    player: &str,
) -> std::collections::BTreeMap<String, carrom::lessons::Bookmark> {
    let request = StoreCall {
        ticket: 0,
        request: StoreRequest::Marks(player.into()),
    };
    let answer = Store::in_folder(folder).answer(&request);
    assert_eq!(answer.notice, None);
    match answer.done {
        StoreReply::Marks(Ok(marks)) => marks,
        other => panic!("{other:?}"),
    }
}

#[test]
fn four_readers_at_once_lose_nothing() {
    let folder = Folder::new("bookmarks-four");
    // Three of the readers are the same player: two read the same chapter, and one reads another.
    let readers = [("Ada", "1"), ("Ada", "2"), ("Ada", "2"), ("球", "2")];
    let start = |(name, chapter)| {
        Player::start(
            "bookmarks::child_reads",
            folder.path(),
            &[name, chapter, "8"],
        )
    };
    for player in readers.map(start) {
        assert_eq!(player.end(), Some(8));
    }
    let library = ChapterLibrary::embedded_once();
    for (name, number) in [("Ada", 0), ("Ada", 1), ("球", 1)] {
        let chapter = &library.chapters[number];
        let mark = &marks(folder.path(), name)[&chapter.id];
        assert_eq!(mark.seen(chapter), chapter.pages.len(), "{name}");
        assert_eq!(mark.answered(chapter), chapter.checkpoints(), "{name}");
    }
    assert_eq!(marks(folder.path(), "球").len(), 1);
}

#[test]
fn a_killed_chapter_reopens_at_the_page_last_seen() {
    let folder = Folder::new("bookmarks-killed");
    let mut chance = Pcg64::seed_from_u64(12);
    let chapter = &ChapterLibrary::embedded_once().chapters[2];
    for _ in 0..15 {
        let before = marks(folder.path(), "Ada");
        let at = before.get(&chapter.id).map_or(0, |mark| mark.page(chapter));
        let player = Player::start(
            "bookmarks::child_reads",
            folder.path(),
            &["Ada", "3", "1000"],
        );
        let turned = player.kill(chance.random_range(1..6), &mut chance).unwrap();
        let now = marks(folder.path(), "Ada")[&chapter.id].page(chapter);
        let pages = chapter.pages.len();
        // The process may have turned one more page than it had time to report.
        let expected = [turned, turned + 1].map(|turned| (at + turned) % pages);
        assert!(
            expected.contains(&now),
            "from page {at} by {turned} pages to page {now}"
        );
    }
}

#[cfg(unix)]
#[test]
fn the_real_game_in_a_terminal_reopens_where_it_was_left() {
    let folder = Folder::new("bookmarks-pty");
    let data = folder.path().to_str().unwrap();
    let start = |arguments: &[&str]| {
        let mut all = arguments.to_vec();
        all.extend(["--data-dir", data]);
        Pty::start(carrom_in_terminal(&all))
    };
    let mut pty = start(&["learn"]);
    pty.wait_for("0 of 17 chapters done");
    pty.press("\x1b[B\r");
    pty.wait_for("page 1 of 5");
    pty.press("2\r");
    pty.wait_for("+ Along the line");
    pty.press("n");
    pty.wait_for("page 2 of 5");
    pty.press("n");
    pty.wait_for("page 3 of 5");
    pty.press("\x03");
    assert_eq!(pty.wait(), 0);
    let mut pty = start(&["learn", "2"]);
    pty.wait_for("page 3 of 5");
    pty.press("\x1b");
    pty.wait_for("read 3 of 5");
    pty.press("Ry");
    pty.wait_until("the pages to count as unread", |screen| {
        !screen.contains("read 3 of 5")
    });
    pty.press("\x03");
    assert_eq!(pty.wait(), 0);
    let pty = start(&["learn", "2"]);
    pty.wait_for("page 1 of 5");
}

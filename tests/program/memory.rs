//! Answers are saved even if carrom is killed, several players answer at once, or the database is
//! damaged.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use carrom::app::App;
use carrom::levels::Starred;
use carrom::messages::{PlayerAction, StoreCall, StoreReply, StoreRequest};
use carrom::progress::{Attempt, Calendar, Due};
use carrom::quiz::{Code, Course, Round};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
#[cfg(unix)]
use rustix::process::Signal;

use crate::child::{self, Player};
use crate::folder::Folder;
use crate::keys::said;
#[cfg(unix)]
use crate::pty::{Pty, carrom as carrom_in_terminal};
use crate::thorough::cases;

/// The answers that are stored in a folder, of one player or of all.
fn kept(folder: &Path, player: Option<&str>) -> Vec<Attempt> {
    let request = StoreCall {
        ticket: 0,
        request: StoreRequest::Recall(player.map(str::to_owned)),
    };
    let answer = Store::in_folder(folder).answer(&request);
    assert_eq!(answer.notice, None);
    match answer.done {
        StoreReply::Recalled(Ok(history)) => history.attempts,
        other => panic!("{other:?}"),
    }
}

fn app(place: Route, player: &str) -> App {
    let settings = Settings {
        reduced_motion: true,
        player: player.into(),
        ..Settings::default()
    };
    App::new(place, settings, 7)
}

fn quiz(folder: &Path, player: &str) -> Headless {
    let code = Some(Code::hits(7));
    let app = app(Route::Quiz(code), player);
    Headless::keeping(app, 80, 24, Store::in_folder(folder))
}

/// Answers the question on the screen and waits for its explanation; starts another round when the
/// current one is over.
fn answer(game: &mut Headless) {
    if game.screen().contains("all answered") {
        game.press("n");
    }
    game.press("60<Enter>30<Enter>2<End>");
    let screen = game.screen();
    assert!(
        screen.contains(" right  code") && screen.contains("of 10 points"),
        "{screen}"
    );
}

/// Gives the requested number of answers, and reports the number of each as soon as its explanation
/// is on the screen.
#[test]
fn child_answers() {
    let Some((folder, words)) = child::told() else {
        return;
    };
    let mut game = quiz(&folder, &words[0]);
    for number in 1..=words[1].parse().unwrap() {
        answer(&mut game);
        assert!(!game.screen().contains("please note"));
        child::say(number);
        game.press("<Enter>");
    }
}

#[test]
fn kills_during_answers_lose_no_answer() {
    let folder = Folder::new("memory-killed");
    let mut chance = Pcg64::seed_from_u64(100);
    let mut before = 0;
    let kills = cases(25, 100);
    for kill in 0..kills {
        let player = Player::start("memory::child_answers", folder.path(), &["Ada", "1000"]);
        let answers = chance.random_range(0..4);
        let said = player.kill(answers, &mut chance).unwrap_or(0);
        let now = kept(folder.path(), Some("Ada")).len();
        // One more answer may have been saved than was reported.
        assert!(
            now == before + said || now == before + said + 1,
            "kill {kill}: {before} and {said} answers were given, {now} are saved"
        );
        before = now;
    }
    assert!(before > kills);
}

#[test]
fn four_players_who_answer_at_once_lose_no_answer() {
    const EACH: usize = 40;
    let folder = Folder::new("memory-four");
    let names = ["Ada", "Bo", "Ada", "球"];
    let each = EACH.to_string();
    let start = |name| Player::start("memory::child_answers", folder.path(), &[name, &each]);
    for player in names.map(start) {
        assert_eq!(player.end(), Some(EACH));
    }
    assert_eq!(kept(folder.path(), None).len(), 4 * EACH);
    for (name, count) in [("Ada", 2), ("Bo", 1), ("球", 1)] {
        assert_eq!(kept(folder.path(), Some(name)).len(), count * EACH);
    }
}

#[test]
fn an_answer_is_saved_before_its_explanation_is_shown() {
    let folder = Folder::new("memory-before");
    let mut game = quiz(folder.path(), "Ada");
    game.press("60<Enter>30<Enter>");
    assert_eq!(kept(folder.path(), None).len(), 0);
    game.press("3");
    let attempts = kept(folder.path(), Some("Ada"));
    assert_eq!(attempts.len(), 1);
    assert_eq!((attempts[0].seed, attempts[0].number), (7, 1));
    assert!(attempts[0].time_s.is_some());
    let answer = &attempts[0].answer;
    assert!((answer["theta1_deg"].as_f64().unwrap().abs() - 60.0).abs() < 1e-9);
}

/// Plays a round at this time with right answers only. The player is sure of each answer or, if
/// `guessing`, says "guess" for every other one.
fn play_rightly(folder: &Path, code: Code, time_s: i64, guessing: bool) {
    let round = Round::of(code.clone());
    let place = Route::Quiz(Some(code));
    let store = Store::in_folder(folder).at(time_s);
    let mut game = Headless::keeping(app(place, "Ada"), 80, 24, store);
    for (i, question) in round.questions().iter().enumerate() {
        game.press(&said(&question.form, &question.form.truth()));
        game.press(if guessing && i % 2 == 0 { "1" } else { "3" });
        game.press("<End>");
        let screen = game.screen();
        assert!(screen.contains(" of 10 points"), "{screen}");
        // Enter pressed right after the digit would not close the verdict, so wait first.
        game.settle(Duration::from_secs(1));
        game.press("<Enter>");
        assert!(game.screen().contains("carrom : quiz"));
    }
    assert!(game.screen().contains("all answered"), "{}", game.screen());
}

#[test]
fn topics_are_no_longer_due_after_a_correct_review() {
    const START_S: i64 = 1_800_000_000;
    const DAY_S: i64 = 86_400;
    let folder = Folder::new("memory-review");
    let due = |time_s| {
        let calendar = Calendar::utc(Some(time_s));
        Due::of(&kept(folder.path(), Some("Ada")), &calendar)
    };
    for (day, code) in [(0, "mixed-7"), (1, "mixed-2")] {
        let code = Code::parse(code).unwrap();
        play_rightly(folder.path(), code, START_S + day * DAY_S, true);
    }
    // Guessed topics are due at once, known topics after one day.
    let now_s = START_S + 3 * DAY_S;
    assert!(!due(START_S + DAY_S).now.is_empty());
    let mut before = due(now_s).now;
    assert!(before.len() > Course::REVIEWED, "{before:?}");
    for seed in 0.. {
        let Some(kind) = due(now_s).course() else {
            break;
        };
        let asked = due(now_s).first().to_vec();
        let course = Course::new(kind);
        play_rightly(folder.path(), Code { course, seed }, now_s, false);
        before.retain(|topic| !asked.contains(topic));
        assert_eq!(due(now_s).now, before);
    }
    assert!(before.is_empty());
    // The topics are due again after their interval.
    assert!(!due(now_s + 2 * DAY_S).now.is_empty());
}

#[cfg(unix)]
#[test]
fn the_real_game_in_a_terminal_saves_every_explained_answer() {
    let folder = Folder::new("memory-pty");
    let data = folder.path().to_str().unwrap();
    let settings = "format = 1\nwhat_you_saw = \"no\"\n";
    fs::write(folder.path().join("settings.toml"), settings).unwrap();
    let mut chance = Pcg64::seed_from_u64(5);
    let mut answered = 0;
    for _ in 0..6 {
        let mut pty = Pty::start(carrom_in_terminal(&[
            "quiz",
            "--seed",
            "7",
            "--data-dir",
            data,
        ]));
        pty.wait_for("question 1 of 10");
        // With reduced motion nothing moves; the contact is shown first.
        pty.press("M");
        for number in 1..=chance.random_range(1..4) {
            pty.wait_for(&format!("question {number} of 10"));
            pty.press("60\r30\r");
            pty.wait_for("How sure are you?");
            pty.press("2");
            pty.wait_for("contact");
            // Skip to the end of the hit.
            pty.press("\x1b[F");
            pty.wait_for("of 10 points");
            answered += 1;
            assert_eq!(kept(folder.path(), None).len(), answered);
            pty.press("\r");
        }
        pty.signal(Signal::KILL);
        pty.wait();
    }
    assert_eq!(kept(folder.path(), None).len(), answered);
}

#[test]
fn a_damaged_database_is_reported_and_the_game_continues() {
    let folder = Folder::new("memory-damaged");
    let path = folder.path().join("progress.db");
    let mut game = quiz(folder.path(), "Ada");
    answer(&mut game);
    let mut damaged = fs::read(&path).unwrap();
    // Damage the page of the first index.
    damaged[2 * 4096..3 * 4096].fill(0);
    fs::write(&path, &damaged).unwrap();
    for arguments in [["progress", "--csv"], ["progress", "--json"]] {
        let refused = carrom(folder.path(), &arguments);
        assert_eq!(refused.status.code(), Some(1));
        assert!(refused.stdout.is_empty());
        let message = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(message.contains("it is damaged"), "{message}");
        assert_eq!(fs::read(&path).unwrap(), damaged);
    }
    let mut game = quiz(folder.path(), "Ada");
    game.press("60<Enter>30<Enter>2");
    let screen = game.screen();
    assert!(
        screen.contains("please note") && screen.contains("has been repaired. Everything"),
        "{screen}"
    );
    game.press("x");
    assert!(!game.screen().contains("please note"));
    assert_eq!(kept(folder.path(), Some("Ada")).len(), 2);
    let aside = folder.path().join("progress-damaged-1.db");
    assert_eq!(fs::read(aside).unwrap(), damaged);
}

/// If the path is a pipe, SQLite would wait until another program opens the pipe for writing.
#[cfg(unix)]
#[test]
fn a_path_that_is_not_a_file_is_refused_at_once() {
    let folder = Folder::new("memory-pipe");
    let path = folder.path().join("progress.db");
    let made = Command::new("mkfifo").arg(&path).status().unwrap();
    assert!(made.success());
    for _ in 0..2 {
        let refused = carrom(folder.path(), &["progress", "--csv"]);
        assert_eq!(refused.status.code(), Some(1));
        let message = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(message.contains("expected a file"), "{message}");
        let mut game = quiz(folder.path(), "Ada");
        game.press("60<Enter>30<Enter>2");
        assert!(
            game.screen().contains("expected a file"),
            "{}",
            game.screen()
        );
        // Next, try a folder.
        if path.is_dir() {
            return;
        }
        fs::remove_file(&path).unwrap();
        fs::create_dir(&path).unwrap();
    }
}

#[test]
fn a_failed_save_is_reported_once() {
    let folder = Folder::new("memory-no-folder");
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let mut game = quiz(&file, "Ada");
    game.press("60<Enter>30<Enter>2");
    let screen = game.screen();
    assert!(screen.contains("Your progress cannot be saved"), "{screen}");
    game.press("x<End><Enter>");
    for _ in 0..2 {
        answer(&mut game);
        assert!(!game.screen().contains("cannot be saved"));
        game.press("<Enter>");
    }
}

#[test]
fn stars_are_saved_only_for_the_player_who_won_them() {
    let folder = Folder::new("memory-stars");
    let app_of = |player| {
        let app = app(Route::Levels, player);
        let store = Store::in_folder(folder.path());
        // The first screen sends its requests once it gets the size of the window.
        let mut game = Headless::keeping(app, 80, 24, store);
        game.press("<Escape>v");
        game
    };
    let fresh = app_of("Ada");
    let first = fresh.app().context().shelf.levels().next();
    let (pack, level) = first
        .map(|(pack, level)| (pack.name.clone(), level.id.clone()))
        .unwrap();
    assert_eq!(fresh.app().context().shelf.stars(0), 0);
    let starred = Starred {
        pack,
        level,
        stars: 2,
    };
    let request = StoreRequest::Note(PlayerAction::Star("Ada".into(), starred));
    let done = Store::in_folder(folder.path())
        .answer(&StoreCall { ticket: 1, request })
        .done;
    assert_eq!(done, StoreReply::Noted(Ok(())));
    let mut ada = app_of("Ada");
    assert_eq!(ada.app().context().shelf.stars(0), 2);
    assert!(ada.screen().contains("1 of"), "{}", ada.screen());
    assert_eq!(
        ada.app().context().shelf.next(),
        Some(ada.app().context().shelf.at)
    );
    assert_eq!(app_of("Bo").app().context().shelf.stars(0), 0);
}

/// Names that a database may contain, although no player can have some of them.
fn hostile() -> [String; 6] {
    [
        "=HYPERLINK(\"http://x\")".into(),
        "-1+1".into(),
        "a \"quoted\",\r\nname".into(),
        "\u{1b}[2J\u{202e}\u{0}\u{7}".into(),
        "球👩‍👩‍👧".repeat(2_000),
        format!("e{}", "\u{301}".repeat(10_000)),
    ]
}

fn carrom(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(arguments)
        .arg("--data-dir")
        .arg(folder)
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

#[test]
fn no_name_breaks_the_screen_the_table_or_json() {
    let folder = Folder::new("memory-names");
    let mut game = quiz(folder.path(), "Ada");
    answer(&mut game);
    let model = kept(folder.path(), None).remove(0);
    let mut store = Store::in_folder(folder.path());
    for (i, name) in hostile().into_iter().enumerate() {
        let attempt = Attempt {
            player: name.clone(),
            topic: name.clone(),
            misconception: Some(name.clone()),
            ..model.clone()
        };
        for player in [name.as_str(), "Ada"] {
            let attempt = Attempt {
                player: player.into(),
                ..attempt.clone()
            };
            let request = StoreRequest::Note(PlayerAction::Record(Box::new(attempt)));
            let answer = store.answer(&StoreCall { ticket: 0, request });
            assert_eq!(answer.done, StoreReply::Noted(Ok(())), "{i}");
        }
        let app = app(Route::Progress, &name);
        let mut game = Headless::keeping(app, 80, 24, Store::in_folder(folder.path()));
        game.press("<Escape>p");
        for page in ["1", "2", "3", "4"] {
            game.press(page);
            let screen = game.screen();
            assert!(screen.contains("carrom : progress"), "{screen}");
            assert!(screen.contains("1 answer"), "{screen}");
            assert!(screen.is_ascii());
            game.press("U");
            let screen = game.screen();
            assert!(!screen.chars().any(|c| c.is_control() && c != '\n'));
            assert!(screen.len() < 100_000);
            game.press("U");
        }
    }
    let output = carrom(folder.path(), &["progress", "--csv", "--everyone"]);
    assert_eq!(output.status.code(), Some(0));
    let mut table = csv::Reader::from_reader(output.stdout.as_slice());
    let rows: Vec<_> = table.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 1 + 2 * hostile().len());
    for cell in rows.iter().flatten() {
        assert!(
            !cell.starts_with(['=', '+', '-', '@', '\t', '\r']),
            "{cell:.40}"
        );
    }
    let output = carrom(folder.path(), &["progress", "--json", "--player", "Ada"]);
    let read: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(read["summary"]["all"]["attempts"], 1 + hostile().len());
    for (i, name) in hostile().iter().enumerate() {
        // An unknown topic is named by the words of its id.
        assert_eq!(read["attempts"][i + 1]["topic"], name.replace('-', " "));
    }
}

#[test]
fn the_command_line_reports_database_errors() {
    let folder = Folder::new("memory-cli");
    let empty = carrom(folder.path(), &["progress", "--csv"]);
    assert_eq!(empty.status.code(), Some(0));
    assert_eq!(String::from_utf8_lossy(&empty.stdout).lines().count(), 1);
    assert!(!folder.path().join("progress.db").exists());
    let newer = rusqlite::Connection::open(folder.path().join("progress.db")).unwrap();
    newer
        .execute_batch("CREATE TABLE x (y); PRAGMA user_version = 7")
        .unwrap();
    drop(newer);
    let before = fs::read(folder.path().join("progress.db")).unwrap();
    let refused = carrom(folder.path(), &["progress", "--json"]);
    assert_eq!(refused.status.code(), Some(1));
    assert!(refused.stdout.is_empty());
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        message.contains("progress.db") && message.contains("newer version of carrom"),
        "{message}"
    );
    assert_eq!(fs::read(folder.path().join("progress.db")).unwrap(), before);
    let both = carrom(folder.path(), &["progress", "--json", "--csv"]);
    assert_eq!(both.status.code(), Some(2));
}

#[test]
fn the_progress_screen_responds_to_keys_and_the_mouse() {
    let folder = Folder::new("memory-screen");
    let mut game = quiz(folder.path(), "Ada");
    for _ in 0..3 {
        answer(&mut game);
        game.press("<Enter>");
    }
    game.press("<Escape>y<Escape>p");
    assert!(game.screen().contains("3 answers"), "{}", game.screen());
    for (keys, title) in [
        ("<Tab>", "2 topics"),
        ("<Right>", "3 how sure"),
        ("<Right>", "4 how sure, over time"),
        ("<Right>", "5 what you believed"),
        ("<Right>", "1 how far off"),
        ("<Left>", "5 what you believed"),
        ("2", "2 topics"),
    ] {
        game.press(keys);
        assert!(game.screen().contains(title), "{keys}: {}", game.screen());
    }
    game.click((10, 10));
    assert!(game.screen().contains("3 how sure"));
    // The next step is a page to read.
    game.press("<Enter>");
    assert!(game.screen().contains("page "), "{}", game.screen());
    game.press("<Escape>");
    assert!(game.screen().contains("carrom : progress"));
}

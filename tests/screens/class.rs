//! A class round on the screen: whole rounds by keys, with a real store.

use std::fs;
use std::path::Path;
use std::time::Duration;

use carrom::app::App;
use carrom::class::{ClassRound, ClassStep, Vote};
use carrom::cli;
use carrom::messages::{FileKind, Input, StoreCall, StoreReply, StoreRequest};
use carrom::quiz::{Code, Form, Response};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use carrom::widgets::Charset;

use crate::folder::Folder;
use crate::keys;

/// The keys with which a team enters this answer; a choice is one key.
fn said(form: &Form, said: &Response) -> String {
    let keys = keys::said(form, said);
    match form {
        Form::Choice { .. } => keys.replace("<Enter>", ""),
        _ => keys,
    }
}

const LONG: Duration = Duration::from_secs(120);

fn app(code: &str, teams: &[&str], charset: Charset) -> App {
    let settings = Settings {
        charset,
        reduced_motion: true,
        ..Settings::default()
    };
    let place = Route::Class {
        code: Some(Code::parse(code).unwrap()),
        teams: teams.iter().map(|name| (*name).to_owned()).collect(),
        name: String::new(),
    };
    App::new(place, settings, 7)
}

fn class(folder: &Path, code: &str, teams: &[&str]) -> Headless {
    let app = app(code, teams, Charset::Ascii);
    Headless::keeping(app, 80, 24, Store::in_folder(folder))
}

fn records(text: &str) -> Vec<csv::StringRecord> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.records().map(Result::unwrap).collect()
}

/// The text of the exported file with this name.
fn exported(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join("exports").join(name)).unwrap()
}

/// The saved rounds.
fn kept(folder: &Path) -> Vec<ClassRound> {
    let request = StoreCall {
        ticket: 0,
        request: StoreRequest::List(FileKind::Class),
    };
    match Store::in_folder(folder).answer(&request).done {
        StoreReply::Classes(Ok(rounds)) => rounds
            .into_iter()
            .map(|kept| *kept.content.unwrap())
            .collect(),
        other => panic!("{other:?}"),
    }
}

/// Of three teams, one is always right, one follows a misconception until the discussion, and one
/// follows it throughout.
#[test]
fn three_teams_play_a_round_and_get_its_tables() {
    let folder = Folder::new("class-round");
    let code = "mixed-7";
    let mut game = class(folder.path(), code, &["Ants", "=Bees()", "Cats"]);
    let round = ClassRound::new(Code::parse(code).unwrap(), vec!["A".into()]);
    game.press("<Enter>");
    for (i, question) in round.questions().iter().enumerate() {
        let form = &question.form;
        let (truth, held) = (form.truth(), question.beliefs[0].said);
        let place = format!("question {} of {}", i + 1, round.questions().len());
        assert!(game.screen().contains(&place), "{}", game.screen());
        game.press("<Enter><Enter>");
        for (team, vote) in [truth, held, held].iter().enumerate() {
            game.press(&format!("{}{}", team + 1, said(form, vote)));
        }
        assert_eq!(game.screen().matches("[x]").count(), 3, "{}", game.screen());
        game.press("<Enter>");
        assert!(game.screen().contains("Explain your"), "{}", game.screen());
        game.press("<Enter>2");
        game.press(&said(form, &truth));
        let screen = game.screen();
        assert_eq!(screen.matches("[=]").count(), 2, "{screen}");
        assert_eq!(screen.matches("[x]").count(), 1, "{screen}");
        game.press("<Enter>");
        assert!(game.settle(LONG));
        if !game.screen().contains("after talking") {
            game.press("<End>");
        }
        let screen = game.screen();
        assert!(
            screen.contains("Right at first") && screen.contains("1 of 3"),
            "{screen}"
        );
        assert!(screen.contains("2 of 3"), "{screen}");
        game.press("<Enter><Enter>");
        assert!(!game.screen().contains("NaN"));
    }
    assert!(
        game.screen().contains("for a spreadsheet"),
        "{}",
        game.screen()
    );
    assert!(game.screen().contains("100.0"), "{}", game.screen());
    game.press("e");
    assert!(
        game.screen().contains("class-items-1.csv"),
        "{}",
        game.screen()
    );

    let answers = records(&exported(folder.path(), "class-answers-1.csv"));
    assert_eq!(answers.len(), 3 * round.questions().len());
    for (i, row) in answers.iter().enumerate() {
        let (question, team) = (i / 3, i % 3);
        assert_eq!(&row[0], code);
        assert_eq!(row[1], (question + 1).to_string());
        assert_eq!(&row[6], ["Ants", "'=Bees()", "Cats"][team]);
        let held = round.questions()[question].beliefs[0].misconception.id();
        // first_right, first_misconception; second_right; points.
        assert_eq!(&row[8], ["yes", "no", "no"][team]);
        assert_eq!(&row[11], ["", held, held][team]);
        assert_eq!(&row[13], ["", "yes", ""][team]);
        if team < 2 {
            assert_eq!(&row[17], "10.0");
        }
    }
    let items = records(&exported(folder.path(), "class-items-1.csv"));
    assert_eq!(items.len(), round.questions().len());
    for (row, question) in items.iter().zip(round.questions()) {
        // 3 votes, one of them right; two are right after the discussion.
        assert_eq!((&row[6], &row[7]), ("3", "0.333"));
        assert_eq!((&row[10], &row[11]), ("3", "0.667"));
        let held = question.beliefs[0].misconception.id();
        assert_eq!((&row[15], &row[16]), (held, "2"));
    }
    // None of the votes is recorded as a player's own answer.
    assert!(game.attempts().is_empty());
}

#[test]
fn going_back_corrects_a_vote_and_the_scores() {
    let folder = Folder::new("class-back");
    let mut game = class(folder.path(), "from-angle2-7", &["Ants", "Bees"]);
    let round = ClassRound::new(Code::parse("from-angle2-7").unwrap(), vec!["A".into()]);
    let form = &round.questions()[0].form;
    let truth = said(form, &form.truth());
    game.press("<Enter><Enter><Enter><Enter>");
    game.press(&truth);
    assert!(
        game.screen().contains("one team without a vote"),
        "{}",
        game.screen()
    );
    game.press("<Enter>100<Enter>-100<Enter>");
    // Continue through the discussion and the second vote to the shot, then to the scores.
    game.press("<Enter><Enter><Enter>");
    if !game.screen().contains("after talking") {
        game.press("<End>");
    }
    game.press("<Enter>");
    let points = |folder: &Path| -> Vec<f64> {
        let rounds = kept(folder);
        (0..2).map(|team| rounds[0].points(0, team)).collect()
    };
    let before = points(folder.path());
    assert!(
        (before[0] - 10.0).abs() < 1e-9 && before[1] < 1.0,
        "{before:?}"
    );
    // From the next question, these keys lead back to the first vote on the first question.
    game.press("<Enter>");
    assert!(game.screen().contains("question 2 of 2"));
    game.press("[");
    assert!(game.screen().contains("question 1 of 2"));
    game.press("<Backspace><Backspace><Backspace><Backspace>");
    assert!(
        game.screen().contains("What you type is hidden"),
        "{}",
        game.screen()
    );
    game.press("2");
    assert!(
        !game.screen().contains("100.0"),
        "the class must not see the vote"
    );
    game.press("v");
    assert!(
        game.screen().contains("100.0"),
        "the team corrects its own vote"
    );
    game.press(&truth);
    let after = points(folder.path());
    assert!((after[1] - 10.0).abs() < 1e-9, "{after:?}");
    // A vote can be withdrawn.
    game.press("<Up>x");
    assert!(game.screen().contains("2 Bees [ ]"), "{}", game.screen());
    game.press("]");
    assert!(
        game.screen().contains("question 2 of 2"),
        "{}",
        game.screen()
    );
    // The key never leads to a question that has not been reached.
    game.press("]]");
    assert!(game.screen().contains("question 2 of 2"));
}

/// Every step used to return to its first page.
#[test]
fn a_step_returns_to_the_page_where_it_was_left() {
    let folder = Folder::new("class-pages");
    let mut game = class(folder.path(), "concept-1", &["Ants", "Bees"]);
    game.press("<Enter><PageDown>");
    assert!(game.screen().contains("page 2 of"), "{}", game.screen());
    game.press("<Enter>");
    assert!(game.screen().contains("page 1 of"), "{}", game.screen());
    game.press("<Backspace>");
    assert!(game.screen().contains("page 2 of"), "{}", game.screen());
}

/// A tap on the text of a choice is a vote for it, and at the recommended size all choices are on
/// the first page.
#[test]
fn a_tap_on_a_choice_is_a_vote_for_it() {
    let code = "concept1-4";
    let round = ClassRound::new(Code::parse(code).unwrap(), vec!["A".into()]);
    let Form::Choice { options, .. } = &round.questions()[0].form else {
        panic!("no choice");
    };
    for size in [(80, 24), (120, 40), (60, 20), (80, 60)] {
        let folder = Folder::new(&format!("class-taps-{}-{}", size.0, size.1));
        let mut game = class(folder.path(), code, &["Ants", "Bees"]);
        game.resize(size.0, size.1);
        game.press("<Enter><Enter><Enter>1");
        let mut places = Vec::new();
        let mut shown = String::new();
        let mut page = 0;
        while std::mem::replace(&mut shown, game.screen()) != game.screen() {
            places.extend(game.app().targets().into_iter().map(|cells| (page, cells)));
            game.press("<PageDown>");
            page += 1;
        }
        assert_eq!(places.len(), options.len(), "{size:?}:\n{shown}");
        game.press("<Escape>");
        for (choice, (page, cells)) in places.into_iter().enumerate() {
            game.press("1");
            game.press(&"<PageUp>".repeat(9));
            game.press(&"<PageDown>".repeat(page));
            game.click((cells.x + cells.width / 2, cells.y + cells.height / 2));
            let said = kept(folder.path())[0].ballot(0, 0).vote(Vote::First);
            assert_eq!(said, Some(Response::Choice(choice)), "{size:?}");
            assert!(page == 0 || size != (80, 24));
        }
    }
}

#[test]
fn a_pause_is_blank_until_somebody_continues() {
    let folder = Folder::new("class-pause");
    let mut game = class(folder.path(), "7", &["Ants"]);
    game.press("<Enter>");
    let before = game.screen();
    game.press("p");
    let paused = game.screen();
    assert!(
        !paused.contains("striker") && !paused.contains("question 1"),
        "{paused}"
    );
    for keys in ["x", "<Down>", "[", "e", "<Enter>", " "] {
        game.press(keys);
        assert_eq!(game.screen(), paused, "{keys}");
    }
    for back in ["p", "<Escape>"] {
        game.press(back);
        assert_eq!(game.screen(), before, "{back}");
        game.press("p");
    }
    game.press("p");
    // A pause in the middle of a vote changes nothing.
    game.press("<Enter><Enter><Enter>40");
    let before = game.screen();
    game.press("pp");
    assert_eq!(game.screen(), before);
}

/// The file once kept the only vote of a round after it had been withdrawn.
#[test]
fn the_only_vote_of_a_round_stays_withdrawn() {
    let folder = Folder::new("class-withdrawn");
    let voted = || kept(folder.path())[0].voted(0, Vote::First);
    let vote = "<Enter><Enter><Enter><Enter>60<Enter>30<Enter>";
    let mut game = class(folder.path(), "7", &["Ants", "Bees"]);
    game.press(vote);
    assert_eq!(voted(), 1);
    game.press("<Up>x");
    assert!(game.screen().contains("1 Ants [ ]"), "{}", game.screen());
    assert_eq!(voted(), 0);
    // A resumed round, too.
    game.press("<Enter>60<Enter>30<Enter>");
    drop(game);
    let mut game = class(folder.path(), "quick-1", &[]);
    game.press("<End><Enter><Enter>");
    game.press("<Up>x");
    assert!(game.screen().contains("1 Ants [ ]"), "{}", game.screen());
    assert_eq!(voted(), 0);
}

#[test]
fn a_killed_round_is_resumed_where_it_was_left() {
    let folder = Folder::new("class-killed");
    let teams = ["Ants", "Bees", "Cats"];
    let mut game = class(folder.path(), "7", &teams);
    game.press("<Enter><Enter><Enter>");
    game.press("<Enter>60<Enter>30<Enter>");
    // Nothing is saved at the end of the process: everything is saved after each vote.
    let rounds = kept(folder.path());
    assert_eq!(rounds.len(), 1);
    assert_eq!(rounds[0].voted(0, Vote::First), 1);
    assert_eq!(rounds[0].place().step, ClassStep::FirstVote);
    game.press("<Enter>45<Enter>45<Enter>");
    drop(game);
    let mut game = class(folder.path(), "quick-1", &[]);
    game.press("<End><Enter>");
    assert!(
        game.screen().contains("7, 3 teams") && game.screen().contains("Ants, Bees, Cats"),
        "{}",
        game.screen()
    );
    game.press("<Enter>");
    let screen = game.screen();
    assert_eq!(screen.matches("[x]").count(), 2, "{screen}");
    assert!(screen.contains("> 3 Cats"), "{screen}");
    game.press("<Enter>10<Enter>20<Enter><Enter>");
    assert!(game.screen().contains("Explain your"));
    // The resumed round is saved in the same file.
    let rounds = kept(folder.path());
    assert_eq!((rounds.len(), rounds[0].voted(0, Vote::First)), (1, 3));
    assert_eq!(rounds[0].place().step, ClassStep::Talk);
    // The round can be removed.
    let mut game = class(folder.path(), "quick-1", &[]);
    game.press("<End><Enter>dn");
    assert_eq!(kept(folder.path()).len(), 1);
    game.press("dy");
    assert!(kept(folder.path()).is_empty());
    assert!(game.screen().contains("There are none yet"));
}

#[test]
fn a_damaged_file_is_reported_and_not_changed() {
    let folder = Folder::new("class-damaged");
    fs::create_dir_all(folder.path().join("classes")).unwrap();
    let file = folder.path().join("classes/class-1.toml");
    fs::write(&file, "format = 1\ncode = \"7\"\nteams = []\n").unwrap();
    let mut game = class(folder.path(), "7", &["Ants"]);
    game.press("<End><Enter>");
    let screen = game.screen();
    assert!(screen.contains("This file cannot be read"), "{screen}");
    game.press("<Enter><Escape><End><Up><Up><Up><Enter><Enter><Enter><Enter>1<Enter>1<Enter>");
    assert!(fs::read_to_string(&file).unwrap().ends_with("teams = []\n"));
    assert!(folder.path().join("classes/class-2.toml").exists());
}

#[test]
fn hostile_names_damage_neither_screen_nor_table() {
    let endless = "x".repeat(10_000);
    let names = [
        "\u{202e}txet \u{5d0}\u{5d1}\u{5d2}",
        "e\u{301}\u{20d0}\u{a0}\u{1f600}\u{200d}\u{1f468}",
        &endless,
        "=cmd()",
        "+1\t@\"',;",
        "a\nb\r\nc\x1b[31m\0",
        "\u{fdfd}\u{fdfd}\u{fdfd}",
        "蟻蟻蟻蟻蟻蟻蟻蟻蟻蟻蟻蟻蟻蟻蟻蟻",
    ];
    for charset in [Charset::Ascii, Charset::Unicode] {
        let folder = Folder::new("class-hostile");
        let app = app("from-angle2-7", &names, charset);
        let mut game = Headless::keeping(app, 80, 24, Store::in_folder(folder.path()));
        let sizes = [(60, 20), (80, 24), (120, 40), (300, 100)];
        let look = |game: &mut Headless| {
            for (columns, rows) in sizes {
                game.resize(columns, rows);
                for line in game.screen().lines() {
                    let width = carrom::widgets::text::width(line);
                    assert!(width <= columns.into(), "{line}");
                    assert!(!line.chars().any(|c| c.is_control() || c == '\u{202e}'));
                    assert!(charset == Charset::Unicode || line.is_ascii(), "{line}");
                }
            }
        };
        look(&mut game);
        for key in ["<Enter>"; 3] {
            game.press(key);
            look(&mut game);
        }
        for team in 1..=8 {
            game.press(&team.to_string());
            look(&mut game);
            game.press("10<Enter>20<Enter>");
        }
        for _ in 0..6 {
            game.press("<Enter>");
            look(&mut game);
        }
        game.press("e");
        look(&mut game);
        let rows = records(&exported(folder.path(), "class-answers-1.csv"));
        assert_eq!(rows.len(), 16);
        assert!(rows.iter().all(|row| row.len() == 22));
        for row in &rows {
            assert!(
                !row[6].starts_with(['=', '+', '-', '@', '\t', '\r']),
                "{}",
                &row[6]
            );
            assert!(!row[6].contains('\n') && row[6].chars().count() <= 25);
        }
        assert_eq!(kept(folder.path()).len(), 1);
    }
}

#[test]
fn teams_are_added_changed_and_removed() {
    let mut game = Headless::from(cli::open("class --seed 3").unwrap());
    game.press("Ants<Enter>Bees<Enter>Cats<Enter><Enter>");
    game.press("<Home><Down><Backspace>t");
    assert!(game.screen().contains("team 2  Beet"), "{}", game.screen());
    game.press("<Delete>");
    assert!(!game.screen().contains("Beet"));
    // A typing error can be corrected in place.
    game.press("<Home><Delete>K<End>");
    assert!(game.screen().contains("team 2  Kats"), "{}", game.screen());
    // Two teams with the same name are refused, and so is an invalid code.
    game.press("<Down>ants<PageDown><PageDown><Up><Up><Up><Enter>");
    assert!(game.screen().contains("twice"), "{}", game.screen());
    game.press("<Home><Down><Down>2<PageDown><PageDown><Up><Up><Up><Up>seven<Enter><Enter>");
    assert!(
        game.screen().contains("expected the code"),
        "{}",
        game.screen()
    );
    game.press("<Backspace><Backspace><Backspace><Backspace><Backspace>speeds2-5<Enter><Enter>");
    assert!(
        game.screen().contains("question 1 of 2  code speeds2-5"),
        "{}",
        game.screen()
    );
    // Names can be pasted, one per line, up to eight.
    let mut game = Headless::from(cli::open("class").unwrap());
    game.input(&Input::Paste("A\nB\n\nC\nD\nE\nF\nG\nH\nI\nJ".into()));
    let screen = game.screen();
    assert!(
        screen.contains("team 8  H") && !screen.contains("team 9"),
        "{screen}"
    );
}

#[test]
fn arguments_are_checked() {
    let wrong = |arguments| cli::open(arguments).err().unwrap_or_default();
    assert!(wrong("class --code nonsense").contains("expected the code of a round"));
    assert!(wrong("class --teams A,a").contains("found \"a\" twice"));
    assert!(wrong("class --teams ,").contains("found none"));
    assert!(wrong("class --palette pink").contains("pink"));
    // The port is accepted, because an earlier round that is resumed may use devices.
    assert_eq!(wrong("class --port 9000"), "");
    let mut game = Headless::from(cli::open("class --teams A,B --code quick-7").unwrap());
    assert!(game.screen().contains("> Start"), "{}", game.screen());
    game.press("<Enter>");
    assert!(game.screen().contains("question 1 of 5  code quick-7"));
}

#[test]
fn one_key_switches_to_light_and_back_to_dark() {
    use carrom::widgets::Palette;
    let mut game = Headless::from(cli::open("class --teams A --code 7 --palette light").unwrap());
    assert_eq!(game.app().settings().palette, Palette::Light);
    game.press("<Enter>l");
    assert_eq!(game.app().settings().palette, Palette::Dark);
    game.press("l");
    assert_eq!(game.app().settings().palette, Palette::Light);
}

#[test]
fn escape_asks_for_confirmation_once_there_is_a_vote() {
    let mut game = Headless::from(cli::open("class --teams A --code 7").unwrap());
    game.press("<Enter><Enter><Enter><Enter>1<Enter>2<Enter>");
    game.press("<Escape>");
    assert!(
        game.screen().contains("Leave the round?"),
        "{}",
        game.screen()
    );
    game.press("n");
    assert!(!game.screen().contains("Leave the round?"));
    game.press("<Escape>y");
    assert!(game.screen().contains("carrom : home"));
}

/// The teacher sees the questions of a round before it begins, and the round then asks exactly
/// these questions.
#[test]
fn a_round_begins_with_the_questions_that_were_seen() {
    let folder = Folder::new("class-preview");
    let app = cli::open("class --teams A,B --seed 3").unwrap();
    let mut game = Headless::keeping(app, 80, 24, Store::in_folder(folder.path()));
    assert!(game.screen().contains("p: see the questions"));
    game.press("p");
    let round = ClassRound::new(Code::parse("even-3").unwrap(), vec!["A".into()]);
    let screen = game.screen();
    assert!(screen.contains("the questions of even-3"), "{screen}");
    let start = |text: &str| text.split(' ').take(6).collect::<Vec<_>>().join(" ");
    let first = start(&round.questions()[0].text);
    assert!(screen.contains(&first), "{first}: {screen}");
    assert!(!screen.contains("10  "), "it is longer than the screen");
    game.press(&"<PageDown>".repeat(8));
    assert!(game.screen().contains("10  "), "{}", game.screen());
    game.press("<Escape>");
    assert!(game.screen().contains("by its code: even-3"));
    game.press("<Enter>");
    let screen = game.screen();
    assert!(screen.contains("question 1 of 10  code even-3"), "{screen}");

    // In a text field a letter is typed, and text that is not a code is reported.
    let app = cli::open("class --teams A,B --code 7").unwrap();
    let mut game = Headless::new(app, 80, 24);
    game.press("<Up>p<Down>p");
    let screen = game.screen();
    assert!(
        screen.contains("code: 7p") && screen.contains("The code: expected the code of"),
        "{screen}"
    );
}

/// A class plays a teacher's own questions and can resume the round. Once the files of these
/// questions have changed, the round is refused, because the votes would be on other questions.
#[test]
fn a_round_of_own_questions_is_resumed_if_they_are_unchanged() {
    let folder = Folder::new("class-own");
    let mine = folder.path().join("mine");
    fs::create_dir_all(&mine).unwrap();
    let from = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/own-concepts/our-marbles.toml"
    );
    let text = fs::read_to_string(from).unwrap();
    fs::write(mine.join("our-marbles.toml"), &text).unwrap();
    let open = |arguments: &str| {
        let arguments = format!("class {arguments} --concepts '{}' --seed 3", mine.display());
        let app = cli::open(&arguments).unwrap();
        let store = Store::in_folder(folder.path()).with_own(&app.context().own);
        Headless::keeping(app, 80, 24, store)
    };
    let mut game = open("--teams A,B");
    let screen = game.screen();
    assert!(screen.contains("your own questions"), "{screen}");
    game.press("<Down><Down><Down><Down><Enter><Enter>");
    let screen = game.screen();
    assert!(screen.contains("question 1 of 2  code own-3"), "{screen}");
    game.press("<Enter><Enter>1b");
    assert!(game.screen().contains("A [x]"), "{}", game.screen());
    let mut game = open("");
    game.press("<End><Enter>");
    assert!(
        game.screen().contains("own-3, 2 teams"),
        "{}",
        game.screen()
    );
    game.press("<Enter>");
    assert!(game.screen().contains("A [x]"), "{}", game.screen());
    let without = text
        .split("\n[[item]]")
        .take(2)
        .collect::<Vec<_>>()
        .join("\n[[item]]");
    fs::write(mine.join("our-marbles.toml"), without).unwrap();
    let mut game = open("");
    game.press("<End><Enter>");
    let screen = game.screen();
    assert!(
        screen.contains("cannot be read") && screen.contains("changed"),
        "{screen}"
    );
}

/// While a round cannot be saved, carrom does not claim that it is saved.
#[test]
fn a_round_that_cannot_be_saved_warns_that_it_will_be_lost() {
    let folder = Folder::new("class-unsaved");
    fs::write(folder.path().join("classes"), "in the way").unwrap();
    let mut game = class(folder.path(), "7", &["Ants"]);
    game.press("<Enter><Enter><Enter>");
    game.press("140<Enter>30<Enter>");
    let screen = game.screen();
    assert!(screen.contains("cannot be saved"), "{screen}");
    game.press("<Down><Escape>");
    let screen = game.screen();
    assert!(screen.contains("will be lost"), "{screen}");
    assert!(!screen.contains("kept"), "{screen}");
    game.press("ne");
    assert!(exported(folder.path(), "class-answers-1.csv").contains("Ants"));
    // Once the round can be saved, carrom saves it and reports this.
    fs::remove_file(folder.path().join("classes")).unwrap();
    game.press("<Down><Enter><Escape>");
    let screen = game.screen();
    assert!(screen.contains("It is saved, and"), "{screen}");
    assert_eq!(kept(folder.path()).len(), 1);
}

#[test]
fn a_round_changed_by_another_carrom_moves_to_a_new_file() {
    let folder = Folder::new("class-two");
    let mut game = class(folder.path(), "7", &["Ants"]);
    game.press("<Enter><Enter><Enter>140<Enter>30<Enter>");
    let name = folder.path().join("classes/class-1.toml");
    let text = fs::read_to_string(&name).unwrap();
    fs::write(&name, text.replace("first-vote", "talk") + "\n").unwrap();
    game.press("<Enter>");
    let screen = game.screen();
    assert!(screen.contains("class-2.toml"), "{screen}");
}

#[test]
fn a_long_code_is_never_shown_in_part() {
    let folder = Folder::new("class-code");
    let code = "unequal-masses60-18446744073709551615";
    let mut game = class(folder.path(), code, &["Ants"]);
    game.press("<Enter>");
    let screen = game.screen();
    let first = screen.lines().next().unwrap().trim_end();
    assert!(first.ends_with(code) || first.ends_with(".."), "{first}");
    game.resize(60, 20);
    let screen = game.screen();
    let first = screen.lines().next().unwrap().trim_end();
    assert!(first.ends_with(".."), "{first}");
}

/// A class of 32 pupils votes with cards: the teacher only counts them and types the numbers. The
/// tables contain the same numbers.
#[test]
fn a_class_of_32_pupils_votes_with_cards_by_keys_alone() {
    let folder = Folder::new("class-cards");
    let mut game = class(folder.path(), "mixed-1", &[]);
    game.press("<End><Up><Up><Enter>");
    let round = ClassRound::with_tally(Code::parse("mixed-1").unwrap());
    let asked = round.questions().len();
    for (i, question) in round.questions().iter().enumerate() {
        let choices = round.choices(i);
        let truth = question.form.truth();
        let right = choices.iter().position(|it| *it == truth).unwrap();
        // Sixteen are right at first, and twenty-eight after the discussion.
        let counts = |of_right: usize| -> String {
            let others = choices.len() - 1;
            let counts = (0..choices.len()).map(|choice| {
                let wrong = 32 - of_right;
                let first_wrong = usize::from(right == 0);
                match choice {
                    choice if choice == right => of_right,
                    choice if choice == first_wrong => wrong - (others - 1),
                    _ => 1,
                }
            });
            counts
                .map(|it| it.to_string())
                .collect::<Vec<_>>()
                .join(" ")
        };
        game.press("<Enter><Enter>");
        let screen = game.screen();
        assert!(screen.contains("Count A B"), "{screen}");
        // The example has as many numbers as the question has choices.
        let line = { screen.lines() }.find_map(|line| line.split_once("type the numbers: "));
        let example = line.map(|(_, example)| example.split_whitespace().count());
        assert_eq!(example, Some(choices.len()), "{screen}");
        // Too few numbers are refused.
        game.press("32<Enter>");
        assert!(
            game.screen().contains("a number for each of A to"),
            "{}",
            game.screen()
        );
        game.press("<Backspace><Backspace>");
        game.press(&counts(16));
        assert!(game.screen().contains("32 in all"), "{}", game.screen());
        game.press("<Enter>");
        let screen = game.screen();
        assert!(screen.contains("discussion helps most now"), "{screen}");
        game.press("<Enter>");
        game.press(&counts(28));
        game.press("<Enter>");
        assert!(game.settle(LONG));
        if !game.screen().contains("after talking") {
            game.press("<End>");
        }
        let screen = game.screen();
        assert!(
            screen.contains("at first: 16 of 32, after talking: 28 of 32"),
            "{screen}"
        );
        game.press("<Enter><Enter>");
    }
    game.press("e");
    let items = records(&exported(folder.path(), "class-items-1.csv"));
    assert_eq!(items.len(), asked);
    for row in &items {
        assert_eq!(
            (&row[6], &row[7], &row[10], &row[11]),
            ("32", "0.500", "32", "0.875")
        );
        // The gain is three quarters of the possible gain; it is unknown which votes changed.
        assert_eq!((&row[17], &row[18], &row[19]), ("0.750", "", ""));
        assert!(
            row[20].contains(": 16") && row[21].contains(": 28"),
            "{row:?}"
        );
    }
    // The misconceptions are counted over all votes, because nobody knows who cast which vote.
    game.press("<Enter><Enter>");
    let screen = game.screen();
    assert!(
        screen.contains("The number of votes") && screen.contains("votes: "),
        "{screen}"
    );
    // Only the teacher can read the tables and the report, which may contain pupils' results.
    #[cfg(unix)]
    for table in [
        "class-items-1.csv",
        "class-answers-1.csv",
        "class-report-1.html",
    ] {
        use std::os::unix::fs::PermissionsExt;
        let about = fs::metadata(folder.path().join("exports").join(table)).unwrap();
        assert_eq!(about.permissions().mode() & 0o777, 0o600, "{table}");
    }
    // Counted votes are anonymous and therefore have no rows in this table.
    assert!(records(&exported(folder.path(), "class-answers-1.csv")).is_empty());
    let kept = kept(folder.path());
    assert_eq!((kept.len(), kept[0].voted(0, Vote::Second)), (1, 32));
}

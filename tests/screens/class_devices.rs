//! Classes whose pupils use their own devices: a whole round that a tape plays with a host and six
//! pupils, and single cases.

use std::collections::BTreeMap;
use std::fs;
use std::net::Ipv4Addr;
use std::time::Duration;

use carrom::app::App;
use carrom::class::protocol::{ClientMessage, Refusal};
use carrom::class::{JoinCode, SeatToken, Vote};
use carrom::cli;
use carrom::gradebook::HandIn;
use carrom::messages::{
    ConnectionId, HostCall, HostNews, Input, JoinCall, JoinDetails, JoinNews, Newcomer,
};
use carrom::quiz::Code;
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::shells::classroom::{Classroom, Who};
use carrom::shells::tape::{Tape, play};
use carrom::store::Store;

use crate::folder::Folder;

const TAPE: &str = include_str!("../classes/devices.tape");

/// The screens and the tables are identical each time, byte for byte.
#[test]
fn a_tape_plays_a_class_with_the_same_result_every_time() {
    let (run, steps) = TAPE.split_at(TAPE.find("Expect").unwrap());
    for set in [
        "Set Size 80x24\nSet Charset ascii\n",
        "Set Size 80x24\nSet Charset unicode\nSet Color truecolor\n",
    ] {
        let tape = Tape::parse(&format!("{run}{set}{steps}")).unwrap();
        let [once, again] = [0; 2].map(|_| {
            let folder = Folder::new("class-devices");
            let open = |arguments: &str| {
                let store = Store::in_folder(folder.path()).timeless();
                Ok(Headless::keeping(cli::open(arguments)?, 80, 24, store))
            };
            let screens = play(&tape, open).unwrap_or_else(|error| panic!("{set}{error}"));
            let texts = screens.iter().map(|screen| (screen.text(), screen.svg()));
            let exports = fs::read_dir(folder.path().join("exports")).unwrap();
            let tables: BTreeMap<_, _> = exports
                .map(|entry| entry.unwrap().path())
                .filter(|path| path.extension().is_some_and(|it| it == "csv"))
                .map(|path| {
                    (
                        path.file_name().unwrap().to_owned(),
                        fs::read(&path).unwrap(),
                    )
                })
                .collect();
            (texts.collect::<Vec<_>>(), tables)
        });
        assert_eq!((once.0.len(), once.1.len()), (4, 2));
        assert!(once == again, "{set}");
    }
}

fn pupil(name: &str, class: &Classroom) -> App {
    let place = Route::Join {
        address: None,
        code: class.code(),
        again: false,
    };
    let settings = Settings {
        player: name.to_owned(),
        ..Settings::default()
    };
    App::new(place, settings, 7)
}

/// A class in its lobby, saved in `folder`, and a pupil who has answered a question alone and has
/// come back without handing the answer in.
fn answered_alone(folder: &Folder) -> (Classroom, Who) {
    let place = Route::Host {
        code: Code::parse("from-angle2-7"),
        name: "10b".into(),
        nicknames: false,
    };
    let app = App::new(place, Settings::default(), 7);
    let store = Store::in_folder(folder.path()).timeless();
    let mut class = Classroom::new(Headless::keeping(app, 80, 24, store));
    let app = pupil("Ada", &class);
    let ada = class.add("Ada", app, 80, 24);
    press(&mut class, ada, "<Enter>", "You are in, Ada.");
    // There is nothing to hand in yet.
    assert!(!class.game(ada).screen().contains("hand in"));
    press(&mut class, ada, "<Escape>y", "Back to your class");
    press(&mut class, ada, "b<Enter>", "question 1");
    class.game(ada).press("60<Enter>30<Enter><Enter>");
    assert_eq!(class.game(ada).attempts().len(), 1);
    let home = "<Escape>y<Escape><Escape>";
    press(&mut class, ada, home, "Back to your class");
    press(&mut class, ada, "j", "hand in the 1 answer");
    (class, ada)
}

fn press(class: &mut Classroom, who: Who, keys: &str, shows: &str) {
    class.game(who).press(keys);
    class.settle();
    let screen = class.game(who).screen();
    assert!(screen.contains(shows), "{keys}: no {shows}:\n{screen}");
}

fn handed_in(folder: &Folder) -> Vec<HandIn> {
    let entries = fs::read_dir(folder.path().join("handed-in"));
    let paths = entries.into_iter().flatten().map(|it| it.unwrap().path());
    let files = paths.filter(|path| path.extension().is_some_and(|it| it == "json"));
    files
        .map(|path| HandIn::read(&fs::read(path).unwrap()).unwrap())
        .collect()
}

#[test]
fn answers_given_alone_are_handed_in_by_a_key() {
    let folder = Folder::new("hand-in-by-key");
    let (mut class, ada) = answered_alone(&folder);
    press(&mut class, ada, "h", "on your own (1 answer)");
    assert_eq!(handed_in(&folder), []);
    press(&mut class, ada, "y", "Handed in: 1 answer.");
    let files = handed_in(&folder);
    assert_eq!((files.len(), files[0].attempts.len()), (1, 1));
    assert_eq!((&*files[0].name, &*files[0].class), ("Ada", "10b"));
    press(&mut class, Who::Host, "w", "1 handed in");
    // Repeated hand-ins are kept in one file, and their number is limited.
    for _ in 1..20 {
        press(&mut class, ada, "hy", "Handed in: 1 answer.");
    }
    press(&mut class, ada, "hy", "carrom accepts no more");
    press(&mut class, Who::Host, "", "1 handed in");
    assert_eq!(handed_in(&folder).len(), 1);
}

#[test]
fn an_unconfirmed_hand_in_is_sent_again_after_the_connection_was_lost() {
    let folder = Folder::new("hand-in-lost");
    let (mut class, ada) = answered_alone(&folder);
    class.reach(ada, false);
    press(&mut class, ada, "hy", "Sending your answers");
    assert_eq!(handed_in(&folder), []);
    class.reach(ada, true);
    class.pass(Duration::from_secs(10));
    press(&mut class, ada, "", "Handed in: 1 answer.");
    assert_eq!(handed_in(&folder).len(), 1);
}

/// Nothing was saved, and both the pupil and the teacher see a message.
#[test]
fn a_failed_save_is_reported_on_both_sides() {
    let folder = Folder::new("hand-in-full");
    let (mut class, ada) = answered_alone(&folder);
    fs::write(folder.path().join("handed-in"), "in the way").unwrap();
    press(&mut class, ada, "hy", "Not handed in.");
    press(
        &mut class,
        Who::Host,
        "",
        "A pupil's hand-in cannot be saved",
    );
    fs::remove_file(folder.path().join("handed-in")).unwrap();
    press(&mut class, ada, "hy", "Handed in: 1 answer.");
}

/// The teacher looks up a term while a pupil joins, and a pupil looks one up while the round
/// begins.
#[test]
fn a_class_continues_while_the_glossary_is_open() {
    let place = Route::Host {
        code: Code::parse("from-angle2-7"),
        name: "10b".into(),
        nicknames: false,
    };
    let app = App::new(place, Settings::default(), 7);
    let mut class = Classroom::new(app.into());
    press(&mut class, Who::Host, "?g", "carrom : glossary");
    let app = pupil("Ada", &class);
    let ada = class.add("Ada", app, 80, 24);
    press(&mut class, ada, "<Enter>", "You are in, Ada.");
    press(&mut class, Who::Host, "", "carrom : glossary");
    press(&mut class, Who::Host, "<Escape>w", "Ada");
    press(&mut class, ada, "?g", "carrom : glossary");
    press(&mut class, Who::Host, "<Escape><Enter><Enter>", "voted");
    press(&mut class, ada, "<Escape>", "from");
    assert!(!class.game(ada).screen().contains("You are in, Ada."));
}

/// One pupil leaves the name empty, and another types a name. Both get a nickname, and each device
/// keeps its nickname when it returns.
#[test]
fn with_nicknames_a_device_does_not_choose_its_name() {
    let place = Route::Host {
        code: Code::parse("from-angle2-7"),
        name: "10b".into(),
        nicknames: true,
    };
    let app = App::new(place, Settings::default(), 7);
    let mut class = Classroom::new(app.into());
    press(
        &mut class,
        Who::Host,
        "",
        "carrom gives everyone a nickname",
    );
    let mut names = Vec::new();
    for player in [Settings::default().player.as_str(), "Zwetschga"] {
        let app = pupil(player, &class);
        let device = class.add("device", app, 80, 24);
        press(&mut class, device, "<Enter><Enter>", "You are in, ");
        let name = |class: &mut Classroom| {
            let screen = class.game(device).screen();
            let after = screen.split_once("You are in, ").unwrap().1;
            after.split_once('.').unwrap().0.to_owned()
        };
        let given = name(&mut class);
        press(&mut class, device, "<Escape>y", "Back to your class");
        press(&mut class, device, "j", "You are in, ");
        assert_eq!(name(&mut class), given);
        names.push(given);
    }
    assert!(names[0] != names[1] && !names.contains(&"Zwetschga".to_owned()));
    press(&mut class, Who::Host, "w", &names[1]);
    assert!(!class.game(Who::Host).screen().contains("Zwetschga"));
}

/// The set-up has a row that switches nicknames on.
#[test]
fn nicknames_are_chosen_in_the_set_up() {
    let place = Route::Class {
        code: Code::parse("from-angle2-7"),
        teams: Vec::new(),
        name: "10b".into(),
    };
    let mut game = Headless::new(App::new(place, Settings::default(), 7), 80, 24);
    game.press("<Home><Down><Down>");
    let row = |game: &mut Headless| {
        let screen = game.screen();
        let line = screen.lines().find(|it| it.contains("nicknames given"));
        line.unwrap().to_owned()
    };
    assert!(row(&mut game).contains("off"), "{}", game.screen());
    game.press("<Enter>");
    assert!(
        row(&mut game).ends_with("on│") || row(&mut game).contains(" on "),
        "{}",
        game.screen()
    );
}

/// The cell in the middle of this text on a screen.
fn place(screen: &str, text: &str) -> (u16, u16) {
    let rows = screen.lines().enumerate();
    let mut found = rows.filter_map(|(row, line)| Some((row, line.split_once(text)?.0)));
    let (row, before) = found
        .next()
        .unwrap_or_else(|| panic!("no {text}:\n{screen}"));
    let column = before.chars().count() + text.chars().count() / 2;
    (column as u16, row as u16)
}

fn tap(class: &mut Classroom, who: Who, at: (u16, u16)) {
    class.game(who).click(at);
    class.settle();
}

/// While the host was out of reach, a notice used to be shown above the question, and taps were
/// assigned to the wrong rows: a tap on B chose C, and a tap on a heading cast the vote.
#[test]
fn a_tap_chooses_what_is_drawn_there_while_the_host_is_out_of_reach() {
    for (columns, rows) in [(80, 24), (60, 40), (120, 30), (60, 20)] {
        let folder = Folder::new("class-taps");
        let place_of = Route::Host {
            code: Code::parse("concept-1"),
            name: String::new(),
            nicknames: false,
        };
        let app = App::new(place_of, Settings::default(), 7);
        let store = Store::in_folder(folder.path()).timeless();
        let mut class = Classroom::new(Headless::keeping(app, 80, 24, store));
        let app = pupil("Ada", &class);
        let ada = class.add("Ada", app, columns, rows);
        press(&mut class, ada, "<Enter>", "You are in, Ada.");
        press(&mut class, Who::Host, "<Enter><Enter>", "have voted");
        let choices = |screen: &str| -> Vec<(char, (u16, u16))> {
            let marks = |letter| [format!("|   {letter} "), format!("| > {letter} ")];
            let seen = |letter| marks(letter).into_iter().find(|it| screen.contains(it));
            let all = ('A'..='E').filter_map(|it| Some((it, seen(it)?)));
            all.map(|(it, mark)| (it, place(screen, &mark))).collect()
        };
        let near = choices(&class.game(ada).screen());
        assert!(near.len() >= 3, "{}", class.game(ada).screen());
        for is_in in [true, false] {
            class.reach(ada, is_in);
            class.settle();
            let screen = class.game(ada).screen();
            assert_eq!(screen.contains("Trying"), !is_in, "{screen}");
            let mut tapped = 0;
            for (letter, _) in choices(&screen) {
                // The tap on the previous choice may have scrolled the screen.
                let screen = class.game(ada).screen();
                let drawn = choices(&screen).into_iter().find(|(it, _)| *it == letter);
                let Some((_, at)) = drawn else { continue };
                tapped += 1;
                tap(&mut class, ada, at);
                let chosen = class.game(ada).screen();
                assert!(chosen.contains("How sure"), "{letter} {at:?}:\n{screen}");
                assert!(
                    chosen.contains(&format!("{letter}: ")),
                    "{letter}:\n{chosen}"
                );
                // A tap on a heading does not give an answer.
                tap(&mut class, ada, place(&chosen, "How sure"));
                let same = class.game(ada).screen();
                assert!(same.contains("How sure"), "a heading votes:\n{same}");
                press(&mut class, ada, "<Escape>", "A ");
            }
            assert!(tapped >= 2, "{tapped}:\n{screen}");
        }
        // The vote has the confidence that the screen shows.
        let seen = choices(&class.game(ada).screen());
        tap(&mut class, ada, seen[1].1);
        let screen = class.game(ada).screen();
        tap(&mut class, ada, place(&screen, "3 sure"));
        class.reach(ada, true);
        class.pass(Duration::from_secs(60));
        let kept = fs::read_to_string(folder.path().join("classes/class-1.toml")).unwrap();
        assert!(kept.contains("sure choice 2"), "{kept}");
    }
}

/// A round saved by an earlier version, whose file contained a vote that did not fit its question,
/// once crashed carrom whenever it was resumed.
#[test]
fn a_round_with_invalid_votes_is_resumed_without_them() {
    let folder = Folder::new("class-poisoned");
    fs::create_dir_all(folder.path().join("classes")).unwrap();
    let file = folder.path().join("classes/class-1.toml");
    let poisoned = "format = 3\ncode = \"concept-1\"\nway = \"devices\"\nteams = [\"Cy\", \"Dee\"]\n\
        number = 1\nstep = \"talk\"\n\n[[question]]\nfirst = [\"choice 99\", \"choice 1\"]\nsecond = []\n\n\
        [[then]]\nchanges = [\"vote 1 first 1 choice 98\", \"vote 1 first 1 rays 1 2\"]\n";
    fs::write(&file, poisoned).unwrap();
    let place = Route::Class {
        code: None,
        teams: Vec::new(),
        name: String::new(),
    };
    let app = App::new(place, Settings::default(), 7);
    let store = Store::in_folder(folder.path()).timeless();
    let mut class = Classroom::new(Headless::keeping(app, 100, 30, store));
    press(&mut class, Who::Host, "<End><Enter>", "concept-1");
    let told = "opened this round without 3 votes that did not fit the question";
    press(&mut class, Who::Host, "<Enter>", told);
    let app = pupil("Ada", &class);
    let ada = class.add("Ada", app, 80, 24);
    press(&mut class, ada, "<Enter>", "You are in, Ada.");
    // The first key closes the notice.
    press(&mut class, Who::Host, "<Enter>", "the code of this class");
    press(&mut class, Who::Host, "<Enter>", "Explain your");
    press(&mut class, ada, "", "Talk: find someone");
    let kept = fs::read_to_string(&file).unwrap();
    assert!(
        kept.contains("choice 1") && !kept.contains("choice 9"),
        "{kept}"
    );
}

/// A class in its lobby, in memory, with these pupils.
fn gathering(names: &[&str]) -> (Classroom, Vec<Who>) {
    let place = Route::Host {
        code: Code::parse("from-angle2-7"),
        name: "10b".into(),
        nicknames: false,
    };
    let app = App::new(place, Settings::default(), 7);
    let store = Store::in_memory().timeless();
    let mut class = Classroom::new(Headless::keeping(app, 80, 24, store));
    let pupils = names.iter().map(|name| {
        let app = pupil(name, &class);
        let who = class.add(name, app, 80, 24);
        press(&mut class, who, "<Enter>", "You are in");
        who
    });
    let pupils = pupils.collect();
    (class, pupils)
}

/// Leaving the list used to begin the round.
#[test]
fn leaving_the_list_of_names_in_the_lobby_does_not_start_the_round() {
    let (mut class, pupils) = gathering(&["Ada"]);
    for back in ["<Escape>", "w"] {
        press(&mut class, Who::Host, "w", "Ada");
        press(&mut class, Who::Host, back, "the code of this class");
        press(&mut class, pupils[0], "", "the round begins soon");
    }
    press(&mut class, Who::Host, "<Enter>", "the vote");
    // Once the round has begun, the list leads back to the question.
    press(&mut class, Who::Host, "w", "no vote yet");
    press(&mut class, Who::Host, "<Escape>", "the vote");
    press(&mut class, pupils[0], "", "Read it with the class");
}

/// The list used to stay in the state in which it was opened.
#[test]
fn the_list_of_participants_is_live() {
    let (mut class, pupils) = gathering(&["Ada", "Bo"]);
    press(&mut class, Who::Host, "<Enter><Enter>", "have voted");
    press(&mut class, Who::Host, "w", "2 in, 2 on the list");
    let app = pupil("Cy", &class);
    let cy = class.add("Cy", app, 80, 24);
    press(&mut class, cy, "<Enter>", "your vote");
    press(&mut class, Who::Host, "", "Cy ");
    // The mark stays on the same pupil, although those who have voted move to the end.
    press(&mut class, Who::Host, "<Down>", "> Bo");
    press(
        &mut class,
        pupils[0],
        "60<Enter>30<Enter><Enter>",
        "Your vote is in",
    );
    press(&mut class, Who::Host, "", "> Bo");
    assert_eq!(
        class.game(Who::Host).screen().matches("has voted").count(),
        1
    );
    class.reach(cy, false);
    press(&mut class, Who::Host, "", "no vote yet, away");
}

/// A confirmation applies to the pupil whom it named, even if it is answered later.
#[test]
fn the_named_pupil_is_removed_even_if_others_vote_before_the_confirmation() {
    let (mut class, pupils) = gathering(&["Ada", "Bo", "Cy"]);
    press(&mut class, Who::Host, "<Enter><Enter>w", "no vote yet");
    press(&mut class, Who::Host, "x", "Remove Ada");
    press(
        &mut class,
        pupils[0],
        "60<Enter>30<Enter><Enter>",
        "Your vote is in",
    );
    press(&mut class, Who::Host, "y", "2 in, 2 on the list");
    press(&mut class, pupils[0], "", "Your teacher has removed you");
    press(&mut class, pupils[1], "", "your vote");
}

/// A removed pupil used to be able to return with the same name.
#[test]
fn a_removed_pupil_stays_out_until_let_in() {
    let (mut class, pupils) = gathering(&["Ada", "Bo"]);
    let ada = pupils[0];
    press(&mut class, Who::Host, "w", "> Ada");
    press(&mut class, Who::Host, "xy", "1 in, 1 on the list");
    press(&mut class, Who::Host, "", "removed");
    press(&mut class, ada, "", "Your teacher has removed you");
    for _ in 0..3 {
        press(&mut class, ada, "<Enter>", "Your teacher has removed you");
        press(&mut class, Who::Host, "", "1 in, 1 on the list");
    }
    // A device that has lost its seat token is also refused.
    let app = pupil("ADA", &class);
    let again = class.add("ADA", app, 80, 24);
    press(&mut class, again, "<Enter>", "Your teacher has removed you");
    press(&mut class, Who::Host, "<End>", "let in again");
    press(&mut class, Who::Host, "<Enter>", "1 in, 1 on the list");
    assert!(!class.game(Who::Host).screen().contains("removed"));
    press(&mut class, ada, "<Enter>", "You are in, Ada.");
    press(&mut class, Who::Host, "", "2 in, 2 on the list");
}

/// One key removes any number of pupils, who may join again.
#[test]
fn one_key_removes_all_pupils_who_are_away_and_never_voted() {
    let (mut class, pupils) = gathering(&["Ada", "Bo", "Cy", "Di"]);
    press(
        &mut class,
        Who::Host,
        "<Enter><Enter>w",
        "4 in, 4 on the list",
    );
    assert!(!class.game(Who::Host).screen().contains("remove absentees"));
    press(
        &mut class,
        pupils[1],
        "60<Enter>30<Enter><Enter>",
        "Your vote is in",
    );
    for away in &pupils[1..] {
        class.reach(*away, false);
    }
    press(&mut class, Who::Host, "a", "Remove everyone who is away");
    press(&mut class, Who::Host, "y", "1 in, 2 on the list");
    press(&mut class, Who::Host, "", "Bo");
    class.reach(pupils[2], true);
    class.pass(Duration::from_secs(10));
    press(&mut class, Who::Host, "", "2 in, 3 on the list");
    press(&mut class, pupils[2], "", "your vote");
}

/// After the end of a round, a device used to show that it was still trying to reconnect.
#[test]
fn a_device_does_not_report_a_lost_host_after_the_round_is_over() {
    let (mut class, pupils) = gathering(&["Ada"]);
    class.game(Who::Host).press("<Enter><Enter>");
    class.settle();
    press(
        &mut class,
        pupils[0],
        "60<Enter>30<Enter><Enter>",
        "Your vote is in",
    );
    for _ in 0..30 {
        if class.game(pupils[0]).screen().contains("The round is over") {
            break;
        }
        class.game(Who::Host).press("<Enter>");
        class.settle();
    }
    press(&mut class, pupils[0], "", "The round is over.");
    press(&mut class, Who::Host, "<Escape>", "");
    class.pass(Duration::from_secs(20));
    let screen = class.game(pupils[0]).screen();
    assert!(screen.contains("The round is over.") && screen.contains("place 1"));
    assert!(!screen.contains("out of reach"), "{screen}");
}

/// A class saved in `folder`, with this code, this name, and these pupils, who join.
fn hosted(folder: &Folder, code: Option<&str>, name: &str, pupils: &[&str]) -> Classroom {
    let place = Route::Host {
        code: code.map(|code| Code::parse(code).unwrap()),
        name: name.into(),
        nicknames: false,
    };
    let app = App::new(place, Settings::default(), 7);
    let store = Store::in_folder(folder.path());
    let mut class = Classroom::new(Headless::keeping(app, 80, 24, store));
    for name in pupils {
        let app = pupil(name, &class);
        let who = class.add(name, app, 80, 24);
        press(&mut class, who, "<Enter>", "You are in");
    }
    class
}

fn files_of_classes(folder: &Folder) -> usize {
    let entries = fs::read_dir(folder.path().join("classes"));
    let names = entries.into_iter().flatten().map(|it| it.unwrap().path());
    names
        .filter(|path| path.extension().is_some_and(|it| it == "toml"))
        .count()
}

/// Continues through all questions, even if nobody votes.
fn play_to_the_end(class: &mut Classroom) {
    for _ in 0..40 {
        if class.game(Who::Host).screen().contains("for a spreadsheet") {
            return;
        }
        press(class, Who::Host, "<End><Enter>", "");
    }
    panic!("no end:\n{}", class.game(Who::Host).screen());
}

/// After a crash, the teacher used to have to look for the round in a list.
#[test]
fn an_interrupted_round_is_offered_when_the_class_is_hosted_again() {
    let folder = Folder::new("class-stopped");
    let mut class = hosted(&folder, Some("from-angle2-7"), "10b", &["Ada", "Bo"]);
    let code = class.code();
    press(&mut class, Who::Host, "<Enter><Enter>", "0 of 2 have voted");
    let ada = class.pupil("Ada").unwrap();
    press(
        &mut class,
        ada,
        "60<Enter>30<Enter><Enter>",
        "Your vote is in",
    );
    // The teacher's carrom ends as if it were killed.
    drop(class);
    for [width, height] in [[80, 24], [60, 20], [120, 40]] {
        let mut class = hosted(&folder, None, "", &[]);
        class.game(Who::Host).input(&Input::Resize(width, height));
        let screen = class.game(Who::Host).screen();
        let words: Vec<&str> = screen.split(['|', '\n']).map(str::trim).collect();
        let words = words
            .join(" ")
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ");
        assert!(words.contains("10b stopped at question 1"), "{screen}");
        assert!(words.contains("2 pupils"), "{screen}");
        assert_eq!(
            class.code(),
            None,
            "nobody can join before the teacher has decided"
        );
    }
    let mut class = hosted(&folder, None, "", &[]);
    press(&mut class, Who::Host, "<Enter>", "the code of this class");
    assert_eq!(class.code(), code);
    press(&mut class, Who::Host, "", "0 of 2 are in");
    press(&mut class, Who::Host, "<Enter>", "1 of 1 have voted");
    assert_eq!(
        files_of_classes(&folder),
        1,
        "the resumed round keeps its file"
    );
}

/// A round is offered only if it could be the intended one and is not over.
#[test]
fn a_round_that_is_over_or_of_another_class_is_not_offered() {
    let folder = Folder::new("class-not-offered");
    drop(hosted(&folder, Some("from-angle2-7"), "10b", &["Ada"]));
    for (code, name, shows) in [
        // The same class and the same questions, as when a command is repeated from the shell's
        // history.
        (Some("from-angle2-7"), "10b", "10b stopped at"),
        (Some("from-angle2-7"), "", "10b stopped at"),
        (None, "10b", "10b stopped at"),
        (None, "", "10b stopped at"),
        (Some("from-angle2-8"), "10b", "the code of this class"),
        (Some("from-angle2-7"), "11a", "the code of this class"),
        (None, "11a", "pupils' own devices"),
    ] {
        let mut class = hosted(&folder, code, name, &[]);
        press(&mut class, Who::Host, "", shows);
    }
    // Another round begins, and both are saved.
    let mut class = hosted(&folder, Some("from-angle2-7"), "10b", &[]);
    press(
        &mut class,
        Who::Host,
        "<Down><Enter>",
        "Nobody has joined yet",
    );
    let app = pupil("Bo", &class);
    let bo = class.add("Bo", app, 80, 24);
    press(&mut class, bo, "<Enter>", "You are in, Bo.");
    assert_eq!(files_of_classes(&folder), 2);
    // The round is played to its end and left.
    play_to_the_end(&mut class);
    press(&mut class, Who::Host, "<Escape>", "");
    let mut class = hosted(&folder, None, "10b", &[]);
    press(&mut class, Who::Host, "", "pupils' own devices");
}

/// carrom used to save a round without participants each time a round was opened for joining.
#[test]
fn a_round_that_nobody_joined_leaves_no_file() {
    let folder = Folder::new("class-nobody");
    let mut class = hosted(&folder, Some("from-angle2-7"), "10b", &[]);
    play_to_the_end(&mut class);
    press(&mut class, Who::Host, "<Escape>", "");
    assert_eq!(files_of_classes(&folder), 0);
    drop(class);
    let class = hosted(&folder, Some("from-angle2-7"), "10b", &["Ada"]);
    assert_eq!(files_of_classes(&folder), 1);
    drop(class);
}

/// The list used to show only the code and the names of the first pupils.
#[test]
fn the_list_of_earlier_rounds_shows_class_date_and_head_count() {
    let folder = Folder::new("class-earlier");
    drop(hosted(
        &folder,
        Some("from-angle2-7"),
        "10b",
        &["Ada", "Bo", "Cy"],
    ));
    let place = Route::Class {
        code: None,
        teams: Vec::new(),
        name: String::new(),
    };
    let app = App::new(place, Settings::default(), 7);
    let store = Store::in_folder(folder.path());
    let mut class = Classroom::new(Headless::keeping(app, 80, 24, store));
    let today = || jiff::Zoned::now().date().strftime("%-d %B %Y").to_string();
    let before = today();
    press(
        &mut class,
        Who::Host,
        "<End><Enter>",
        "10b: from-angle2-7, 3 pupils, ",
    );
    let screen = class.game(Who::Host).screen();
    let days = [before, today()].map(|day| format!("3 pupils, {day} "));
    assert!(days.iter().any(|day| screen.contains(day)), "{screen}");
    press(&mut class, Who::Host, "", "Ada, Bo, Cy");
}

/// Pupils' devices look for the round at its old address.
#[test]
fn the_teacher_is_warned_if_a_round_has_a_new_address() {
    let folder = Folder::new("class-moved");
    drop(hosted(&folder, Some("from-angle2-7"), "10b", &["Ada"]));
    let file = folder.path().join("classes/class-1.toml");
    let text = fs::read_to_string(&file).unwrap();
    let moved = text.replace("192.168.43.117:8090", "192.168.43.118:8090");
    assert_ne!(moved, text);
    for (text, tells) in [(text, false), (moved, true)] {
        fs::write(&file, text).unwrap();
        let mut class = hosted(&folder, None, "", &[]);
        press(&mut class, Who::Host, "<Enter>", "");
        let screen = class.game(Who::Host).screen();
        assert_eq!(screen.contains("192.168.43.118:8090"), tells, "{screen}");
    }
}

/// A host at the first vote of its round, which hundreds of devices try to join.
struct Crowd {
    host: Headless,
    connections: ConnectionId,
    /// The time in seconds.
    now_s: u64,
}

impl Crowd {
    fn new() -> Self {
        let place = Route::Host {
            code: Code::parse("from-angle2-7"),
            name: String::new(),
            nicknames: false,
        };
        let app = App::new(place, Settings::default(), 7);
        let mut host = Headless::new(app, 80, 24);
        let door = JoinDetails {
            code: JoinCode::of(7),
            addresses: vec!["192.168.43.117:8090".parse().unwrap()],
            page: Ok(()),
        };
        host.input(&Input::Hosted(vec![HostNews::Opened(Ok(door))]));
        host.press("<Enter><Enter>");
        let (connections, now_s) = (0, 0);
        Self {
            host,
            connections,
            now_s,
        }
    }

    /// A newcomer joins from an address. Returns the newcomer's connection, and the connections
    /// that are refused.
    fn come(&mut self, address: u32) -> (ConnectionId, Vec<(ConnectionId, Refusal)>) {
        self.connections += 1;
        let connection = self.connections;
        self.hear(HostNews::Came(Newcomer {
            connection,
            name: format!("Pupil {connection}"),
            seat: None,
            fresh: SeatToken::of(connection.into()),
            address: Ipv4Addr::from(address).into(),
            at: Duration::from_secs(self.now_s),
        }));
        let calls = self.host.take_host_calls();
        let sent_away = calls.iter().filter_map(|call| match call {
            HostCall::Refuse(connection, why) => Some((*connection, *why)),
            _ => None,
        });
        (connection, sent_away.collect())
    }

    /// Lets `count` newcomers join, each from an address of its own.
    fn fill(&mut self, count: u32) {
        for address in 1000..1000 + count {
            assert_eq!(self.come(address).1, []);
        }
    }

    fn hear(&mut self, news: HostNews) {
        self.host.input(&Input::Hosted(vec![news]));
    }

    fn vote(&mut self, connection: ConnectionId) {
        let vote = ClientMessage::Vote {
            q: 0,
            vote: Vote::First,
            said: "rays 60 30".into(),
            n: 1,
        };
        self.hear(HostNews::Said(connection, vote));
    }

    fn shows(&mut self, words: &str) {
        let screen = self.host.screen();
        assert!(screen.contains(words), "no {words}:\n{screen}");
    }
}

/// One address used to be able to fill the class at once.
#[test]
fn new_seats_for_one_address_become_available_with_time() {
    let mut crowd = Crowd::new();
    // A class of 40 is behind one router, and half of the pupils join again.
    for _ in 0..60 {
        assert_eq!(crowd.come(1).1, []);
    }
    let (connection, sent_away) = crowd.come(1);
    assert_eq!(sent_away, [(connection, Refusal::Later)]);
    assert_eq!(crowd.come(2).1, [], "another address can still join");
    for _ in 0..30 {
        crowd.now_s += 2;
        assert_eq!(crowd.come(1).1, []);
        assert_eq!(crowd.come(1).1[0].1, Refusal::Later);
    }
    crowd.shows("0 of 91 have voted");
}

/// A class could be full although nobody was connected.
#[test]
fn a_newcomer_to_a_full_class_takes_the_seat_of_somebody_away_who_never_voted() {
    let mut crowd = Crowd::new();
    crowd.fill(250);
    crowd.vote(2);
    let (connection, sent_away) = crowd.come(9);
    assert_eq!(
        sent_away,
        [(connection, Refusal::Full)],
        "everybody is connected"
    );
    for away in [1, 2, 3] {
        crowd.hear(HostNews::Gone(away));
    }
    crowd.shows("1 of 248 have voted");
    assert_eq!(crowd.come(9).1, []);
    assert_eq!(crowd.come(9).1, []);
    let (connection, sent_away) = crowd.come(9);
    assert_eq!(sent_away, [(connection, Refusal::Full)]);
    // A pupil who has voted keeps the seat and the vote.
    crowd.shows("1 of 250 have voted");
}

/// The class used to stay full as long as such a device stayed.
#[test]
fn a_device_that_holds_most_seats_of_a_full_class_gives_way() {
    let mut crowd = Crowd::new();
    crowd.fill(20);
    while crowd.connections < 250 {
        crowd.now_s += 2;
        assert_eq!(crowd.come(1).1, []);
    }
    crowd.vote(250);
    // A new connection from the device does not get one of the device's own seats.
    crowd.now_s += 2;
    let (connection, sent_away) = crowd.come(1);
    assert_eq!(sent_away, [(connection, Refusal::Full)]);
    // The device loses seats to newcomers until it holds half of all seats.
    for newcomer in 0..105 {
        let displaced = 249 - ConnectionId::from(newcomer);
        assert_eq!(crowd.come(2000 + newcomer).1, [(displaced, Refusal::Full)]);
    }
    let (connection, sent_away) = crowd.come(3000);
    assert_eq!(sent_away, [(connection, Refusal::Full)]);
    crowd.shows("1 of 250 have voted");
}

/// The pupil does not have to do anything: the device joins as soon as it is allowed.
#[test]
fn a_device_that_has_to_wait_shows_this_and_tries_again() {
    let place = Route::Join {
        address: Some("192.168.43.117:8090".into()),
        code: Some(JoinCode::of(7)),
        again: false,
    };
    let settings = Settings {
        player: "Ada".into(),
        ..Settings::default()
    };
    let mut game = Headless::new(App::new(place, settings, 7), 80, 24);
    game.press("<Enter>");
    for _ in 0..3 {
        let address = "192.168.43.117:8090".into();
        let dial = JoinCall::Dial { address };
        assert_eq!(game.take_join_calls(), [dial]);
        game.input(&Input::Joined(JoinNews::Reached));
        assert!(matches!(
            &game.take_join_calls()[..],
            [JoinCall::Say { .. }]
        ));
        let text = r#"{"t":"no","why":"later"}"#.into();
        game.input(&Input::Joined(JoinNews::Heard { text }));
        let screen = game.screen();
        assert!(screen.contains("automatically"), "{screen}");
        assert_eq!(game.take_join_calls(), []);
        game.pass(Duration::from_secs(6));
    }
}

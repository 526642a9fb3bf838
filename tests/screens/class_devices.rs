//! A tape plays a whole class on its own devices: the host and six pupils.

use std::collections::BTreeMap;
use std::fs;
use std::time::Duration;

use carrom::app::App;
use carrom::cli;
use carrom::gradebook::HandIn;
use carrom::quiz::Code;
use carrom::screens::{Place, Settings};
use carrom::shells::Headless;
use carrom::shells::classroom::{Classroom, Who};
use carrom::shells::tape::{Tape, play};
use carrom::store::Store;

use crate::folder::Folder;

const TAPE: &str = include_str!("../classes/devices.tape");

/// Screens and tables alike, byte by byte.
#[test]
fn a_tape_plays_a_class_and_is_the_same_every_time() {
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
    let place = Place::Join {
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

/// A class at its door, kept in `folder`, and a pupil who has answered a question alone, has come
/// back and has not handed it in.
fn answered_alone(folder: &Folder) -> (Classroom, Who) {
    let place = Place::Host {
        code: Code::parse("from-angle2-7"),
        name: "10b".into(),
    };
    let app = App::new(place, Settings::default(), 7);
    let store = Store::in_folder(folder.path()).timeless();
    let mut class = Classroom::new(Headless::keeping(app, 80, 24, store));
    let app = pupil("Ada", &class);
    let ada = class.add("Ada", app, 80, 24);
    press(&mut class, ada, "<Enter>", "You are in, Ada.");
    // There is nothing yet.
    assert!(!class.game(ada).screen().contains("hand in"));
    press(&mut class, ada, "<Escape>y", "Back to your class");
    press(&mut class, ada, "b", "question 1");
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
fn what_a_pupil_answered_alone_is_handed_in_by_a_key() {
    let folder = Folder::new("hand-in-by-key");
    let (mut class, ada) = answered_alone(&folder);
    press(&mut class, ada, "h", "answered alone (1 answer)");
    assert_eq!(handed_in(&folder), []);
    press(&mut class, ada, "y", "Handed in: 1 answer.");
    let files = handed_in(&folder);
    assert_eq!((files.len(), files[0].attempts.len()), (1, 1));
    assert_eq!((&*files[0].name, &*files[0].class), ("Ada", "10b"));
    press(&mut class, Who::Host, "w", "1 handed in");
    // Again and again: it stays one file, and there is an end to it.
    for _ in 1..20 {
        press(&mut class, ada, "hy", "Handed in: 1 answer.");
    }
    press(&mut class, ada, "hy", "carrom takes no more");
    press(&mut class, Who::Host, "", "1 handed in");
    assert_eq!(handed_in(&folder).len(), 1);
}

#[test]
fn what_was_on_its_way_when_the_host_was_lost_is_sent_again() {
    let folder = Folder::new("hand-in-lost");
    let (mut class, ada) = answered_alone(&folder);
    class.reach(ada, false);
    press(&mut class, ada, "hy", "on their way");
    assert_eq!(handed_in(&folder), []);
    class.reach(ada, true);
    class.pass(Duration::from_secs(10));
    press(&mut class, ada, "", "Handed in: 1 answer.");
    assert_eq!(handed_in(&folder).len(), 1);
}

/// Nothing was kept, and both are told so.
#[test]
fn what_cannot_be_kept_is_told_on_both_sides() {
    let folder = Folder::new("hand-in-full");
    let (mut class, ada) = answered_alone(&folder);
    fs::write(folder.path().join("handed-in"), "in the way").unwrap();
    press(&mut class, ada, "hy", "Not handed in.");
    press(
        &mut class,
        Who::Host,
        "",
        "What a pupil handed in cannot be kept",
    );
    fs::remove_file(folder.path().join("handed-in")).unwrap();
    press(&mut class, ada, "hy", "Handed in: 1 answer.");
}

/// A round whose file holds a vote that fits nothing, as an earlier carrom has kept it, once ended
/// carrom again whenever it was taken up.
#[test]
fn a_poisoned_round_is_taken_up_without_its_poisoned_votes() {
    let folder = Folder::new("class-poisoned");
    fs::create_dir_all(folder.path().join("classes")).unwrap();
    let file = folder.path().join("classes/class-1.toml");
    let poisoned = "format = 3\ncode = \"concept-1\"\nway = \"devices\"\nteams = [\"Cy\", \"Dee\"]\n\
        number = 1\nstep = \"talk\"\n\n[[question]]\nfirst = [\"choice 99\", \"choice 1\"]\nsecond = []\n\n\
        [[then]]\nchanges = [\"vote 1 first 1 choice 98\", \"vote 1 first 1 rays 1 2\"]\n";
    fs::write(&file, poisoned).unwrap();
    let place = Place::Class {
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
    // The first key puts the notice away.
    press(&mut class, Who::Host, "<Enter>", "the code of this class");
    press(&mut class, Who::Host, "<Enter>", "Find someone who");
    press(&mut class, ada, "", "Talk: find someone");
    let kept = fs::read_to_string(&file).unwrap();
    assert!(
        kept.contains("choice 1") && !kept.contains("choice 9"),
        "{kept}"
    );
}

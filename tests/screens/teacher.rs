//! The screen for teachers writes the same files as the commands.

use std::fs;

use carrom::app::App;
use carrom::gradebook::HandIn;
use carrom::paper::Paper;
use carrom::paper::worksheet::{Worksheet, cards};
use carrom::progress::Attempt;
use carrom::quiz::{Answer, Code, Confidence, Round};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;

use crate::folder::Folder;

fn opened(folder: &Folder) -> Headless {
    let app = App::new(Route::Teacher, Settings::default(), 7);
    Headless::keeping(app, 80, 24, Store::in_folder(folder.path()))
}

/// The content of an exported file.
fn written<'g>(game: &'g Headless, name: &str) -> &'g str {
    let file = game.exports().iter().find(|(it, _)| it == name);
    &file.unwrap_or_else(|| panic!("no {name}")).1
}

#[test]
fn a_worksheet_its_key_and_a_moodle_file_are_those_of_the_typed_code() {
    let folder = Folder::new("teacher-sheets");
    let mut game = opened(&folder);
    game.press("<Down>");
    for _ in 0.."even12-7".len() {
        game.press("<Backspace>");
    }
    // Home and End move the cursor, as in a text field of a browser.
    game.press("eeds-3<Home>sp<End><Enter>");
    let screen = game.screen();
    assert!(screen.contains("worksheet-speeds-3.html"), "{screen}");
    let round = Round::of(Code::parse("speeds-3").unwrap());
    let sheet = Worksheet::new(&round, None);
    assert_eq!(
        written(&game, "worksheet-speeds-3.html"),
        sheet.sheet_html()
    );
    assert_eq!(written(&game, "key-speeds-3.html"), sheet.key_html());
    game.press("<Down><Down><Enter>");
    let moodle = Worksheet::moodle_xml(&[Worksheet::new(&round, None)]);
    assert_eq!(written(&game, "moodle-speeds-3.xml"), moodle);
}

/// Typed letters go into the code, and text that is not a code is refused with a reason.
#[test]
fn text_that_is_not_a_code_is_refused_and_nothing_is_written() {
    let folder = Folder::new("teacher-refused");
    for (typed, reason) in [("x", "The code:"), ("<Backspace>", "The code:")] {
        let mut game = opened(&folder);
        game.press("<Down>");
        game.press(typed);
        if typed == "<Backspace>" {
            game.press("<Backspace>find");
        }
        game.press("<Enter>");
        assert!(game.screen().contains(reason), "{}", game.screen());
        assert!(game.exports().is_empty());
    }
}

#[test]
fn cards_are_written_for_the_chosen_number_of_pupils() {
    let folder = Folder::new("teacher-cards");
    let mut game = opened(&folder);
    game.press("<Down><Down><Right><Right>");
    assert!(game.screen().contains("1 sheet"), "{}", game.screen());
    game.press("<Enter>");
    assert_eq!(written(&game, "cards.html"), cards(1, Paper::default()));
}

#[test]
fn a_gradebook_has_everyone_who_handed_in_something_here() {
    let folder = Folder::new("teacher-gradebook");
    let mut game = opened(&folder);
    while !game.screen().contains("> Gradebook") {
        game.press("<Down>");
    }
    game.press("<Enter>");
    assert!(
        game.screen().contains("No hand-in was found"),
        "{}",
        game.screen()
    );
    let code = Code::parse("speeds-3").unwrap();
    let round = Round::of(code.clone());
    let question = &round.questions()[0];
    let answer = Answer::new(question.form.truth(), Confidence::Sure);
    fs::create_dir_all(folder.path().join("handed-in")).unwrap();
    for name in ["Ada", "Bo"] {
        let attempt = Attempt::of_quiz(name, &code, 1, question, &answer);
        let hand_in = HandIn::new(name, "10b", vec![attempt]);
        folder.file(
            &format!("handed-in/{}", hand_in.file_name()),
            hand_in.text().unwrap(),
        );
    }
    game.press("<Enter>");
    let page = written(&game, "gradebook.html");
    assert!(page.contains("Ada") && page.contains("Bo"));
}

#[test]
fn every_guide_is_written_as_a_page() {
    let folder = Folder::new("teacher-guides");
    let mut game = opened(&folder);
    game.press("<End><Enter>");
    assert!(written(&game, "carrom-start.html").contains("<h1>"));
    game.press("<Right><Enter>");
    assert!(written(&game, "carrom-class.html").contains("<h1>"));
    game.press("<Left><Left><Enter>");
    assert_eq!(game.exports().len(), 3, "the choice wraps around");
}

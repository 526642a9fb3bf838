//! Tests the on-screen keyboard of a phone with real taps and with the text input that such a
//! keyboard sends. The keyboard composes words and may change them, its keys have no names, and it
//! stays open only while a field has the focus.

use std::fs;
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

use crate::browser::{Browser, page};
use crate::folder::Folder;
use crate::teacher::{Teacher, kept};
use crate::touch::Phone;

/// The part of a phone's screen that an address bar leaves free.
const SMALL: (u32, u32) = (390, 664);

/// Draws a frame only every half second, as a slow phone does.
const SLOW_FRAMES: &str = "
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (draw) => setTimeout(() => request(draw), 500);";

impl Phone {
    /// Taps the field with this name; fails unless the keyboard then stays open for the field.
    fn open_keyboard(&mut self, name: &str) {
        self.tap_field(name);
        // A browser sends mouse events after the touch events.
        thread::sleep(Duration::from_millis(400));
        assert_eq!(self.typing_into(), name);
    }

    /// The name of the field for which the keyboard is open; empty if there is none.
    fn typing_into(&mut self) -> String {
        let script = "
            const input = document.activeElement;
            if (input.localName !== 'input' || input.readOnly) return '';
            return input.id === 'typing' ? '(none)' : input.labels[0].textContent;";
        let name = self.0.run(script, &[]);
        name.as_str().unwrap().to_owned()
    }

    /// The text in the field for which the keyboard is open.
    fn typed(&mut self) -> Value {
        self.0.run("return document.activeElement.value", &[])
    }

    fn insert(&mut self, text: &str) {
        self.0.debug("Input.insertText", &json!({ "text": text }));
    }

    /// Composes a word through these stages; the last one is not yet confirmed.
    fn compose(&mut self, stages: &[&str]) {
        for text in stages {
            let end = text.encode_utf16().count();
            let stage = json!({ "text": text, "selectionStart": end, "selectionEnd": end });
            self.0.debug("Input.imeSetComposition", &stage);
            self.wait();
        }
    }

    /// Presses an editing key without a name.
    fn edit(&mut self, command: &str) {
        for kind in ["rawKeyDown", "keyUp"] {
            let commands = if kind == "keyUp" {
                vec![]
            } else {
                vec![command]
            };
            let event = json!({
                "type": kind, "key": "Unidentified", "windowsVirtualKeyCode": 229,
                "commands": commands,
            });
            self.0.debug("Input.dispatchKeyEvent", &event);
        }
        self.wait();
    }

    /// Presses the keyboard's Enter key.
    fn enter(&mut self) {
        for kind in ["keyDown", "keyUp"] {
            let event = json!({
                "type": kind, "key": "Enter", "code": "", "windowsVirtualKeyCode": 13,
                "text": "\r",
            });
            self.0.debug("Input.dispatchKeyEvent", &event);
        }
        self.wait();
    }
}

/// A teacher in the lobby, and a phone on which the page is open at the class's address.
fn at_the_door(name: &str) -> (Folder, Teacher, Phone) {
    let page = page();
    let page = fs::read_to_string(page.trim_start_matches("file://")).unwrap();
    let folder = Folder::new(name);
    let teacher = Teacher::gathering(&folder, &page);
    let address = format!("http://127.0.0.1:{}/", teacher.port);
    let mut phone = Phone::sized(SMALL, &address, "");
    phone.expect("Your class is playing a round");
    (folder, teacher, phone)
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_phone_joins_a_class_and_votes_with_its_soft_keyboard() {
    let (folder, teacher, mut phone) = at_the_door("page-soft-keyboard");
    phone.open_keyboard("code");
    phone.insert(&teacher.code.to_lowercase());
    phone.enter();
    assert_eq!(phone.typing_into(), "name");
    phone.compose(&["A", "As", "A", "Ad", "Ada"]);
    phone.insert("Ada");
    phone.edit("deleteBackward");
    phone.compose(&["é"]);
    assert_eq!(phone.typed(), "Adé");
    phone.press("Join the class");
    phone.expect("You are in, Adé.");
    teacher.press("<Enter><Enter>", "0 of 1 have voted");
    phone.expect("Where will they go?");
    phone.type_in("6");
    phone.insert("7");
    phone.edit("deleteBackward");
    phone.insert("0");
    phone.enter();
    phone.insert("30");
    phone.edit("insertNewline");
    phone.expect("How sure are you?");
    assert_eq!(phone.typing_into(), "", "the keyboard closes");
    phone.go_on();
    phone.expect("Your vote is in.");
    teacher.wait_for("1 of 1 have voted");
    let said = kept(&folder)
        .ballot(0, 0)
        .vote(carrom::class::Vote::First)
        .unwrap()
        .rays()
        .unwrap();
    let degrees = [said.striker, said.target].map(|ray| ray.unwrap().abs().to_degrees());
    assert!((degrees[0] - 60.0).abs() < 1e-9, "{degrees:?}");
    assert!((degrees[1] - 30.0).abs() < 1e-9, "{degrees:?}");
    assert_eq!(kept(&folder).teams(), ["Adé"]);
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn enter_moves_from_field_to_field_and_the_keyboard_stays_open() {
    let (_folder, teacher, mut phone) = at_the_door("page-soft-enter");
    phone.open_keyboard("code");
    phone.insert(&teacher.code);
    phone.edit("insertNewline");
    assert_eq!(phone.typing_into(), "name");
    phone.insert("Bo");
    phone.enter();
    assert_eq!(phone.typing_into(), "", "the keyboard closes");
    phone.press("Join the class");
    phone.expect("You are in, Bo.");
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn the_next_button_takes_the_keyboard_to_the_next_name_and_a_choice_closes_it() {
    let page = page();
    let mut phone = Phone::sized(SMALL, &page, "table");
    phone.until("North's name", |phone| phone.tap_value("North"));
    phone.open_keyboard("South's name");
    phone.insert("Asha");
    phone.press("next");
    assert_eq!(phone.typing_into(), "North's name");
    phone.insert("Ben");
    phone.tap_value("your hands");
    assert_eq!(phone.typing_into(), "", "the keyboard closes");
    phone.press("play");
    phone.expect("Asha breaks");
    assert!(phone.shows("Asha 0 : 0 Ben"));
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_word_that_is_still_being_composed_is_sent_with_the_form() {
    let (_folder, teacher, mut phone) = at_the_door("page-soft-composed");
    phone.open_keyboard("code");
    phone.compose(&[&teacher.code]);
    phone.open_keyboard("name");
    phone.compose(&["C", "Ca", "Cem", "Cem "]);
    phone.press("Join the class");
    phone.expect("You are in, Cem.");
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn quickly_typed_letters_arrive_exactly_once() {
    let (_folder, teacher, mut phone) = at_the_door("page-soft-slow");
    phone.open_keyboard("code");
    phone.insert(&teacher.code);
    phone.open_keyboard("name");
    phone.0.run(SLOW_FRAMES, &[]);
    for letter in ["D", "o", "r", "a"] {
        phone.insert(letter);
    }
    phone.press("Join the class");
    phone.expect("You are in, Dora.");
    teacher.press("<Enter><Enter>", "0 of 1 have voted");
    phone.expect("Where will they go?");
    phone.type_in("4");
    phone.insert("5");
    phone.expect("45");
    assert!(!phone.shows("445"));
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_field_shows_only_the_accepted_text() {
    let (_folder, _teacher, mut phone) = at_the_door("page-soft-long");
    phone.open_keyboard("name");
    phone.insert(&"x".repeat(500));
    phone.wait();
    let taken = phone.typed().as_str().unwrap().len();
    assert!(taken < 500, "{taken} letters");
    phone.insert("y");
    phone.wait();
    assert_eq!(phone.typed(), Value::from("x".repeat(taken)));
    phone.edit("deleteBackward");
    phone.insert("z");
    phone.wait();
    let expected = format!("{}z", "x".repeat(taken - 1));
    assert_eq!(phone.typed(), Value::from(expected));
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn the_keyboard_of_the_menu_stays_open_and_each_letter_arrives_once() {
    let mut phone = Phone::sized(SMALL, &page(), "lab");
    phone.press("☰");
    phone.press("Show the keyboard");
    thread::sleep(Duration::from_millis(400));
    assert_eq!(phone.typing_into(), "(none)");
    let keys = "
        window.pressed = [];
        const call = program.call;
        program.call = (command, bytes) => {
          if (command.do === 'key') window.pressed.push(command.key);
          return call(command, bytes);
        };";
    phone.0.run(keys, &[]);
    phone.compose(&["a", "ab"]);
    phone.insert("ab");
    phone.edit("deleteBackward");
    phone.insert("c");
    phone.wait();
    let pressed = phone.0.run("return window.pressed", &[]);
    assert_eq!(pressed, json!(["a", "b", "Backspace", "c"]));
}

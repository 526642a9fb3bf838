//! A phone's keyboard on the page: it comes up by a tap on a field, and inserts, composes and
//! deletes texts instead of pressing keys.

use std::fs;

use serde_json::{Value, json};

use crate::browser::{Browser, page};
use crate::folder::Folder;
use crate::teacher::{Teacher, kept};
use crate::touch::Phone;

/// What has the focus: which element, in which field, and what is in it.
const FOCUS: &str = "
    const it = document.activeElement;
    return [it.localName, it.closest('.field')?.querySelector('label').textContent, it.value];";

/// Puts a word together that is not yet inserted.
fn compose(phone: &mut Phone, text: &str) {
    let end = text.len();
    let word = json!({ "text": text, "selectionStart": end, "selectionEnd": end });
    phone.0.debug("Input.imeSetComposition", &word);
    phone.wait();
}

/// Presses one of the keys that such a keyboard does press.
fn press(phone: &mut Phone, key: &str, number: u32) {
    for kind in ["rawKeyDown", "keyUp"] {
        let event = json!({ "type": kind, "key": key, "code": key,
            "windowsVirtualKeyCode": number, "nativeVirtualKeyCode": number });
        phone.0.debug("Input.dispatchKeyEvent", &event);
    }
    phone.wait();
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_word_that_is_still_composed_comes_in_once() {
    let page = fs::read_to_string(page().trim_start_matches("file://")).unwrap();
    let folder = Folder::new("page-soft-keyboard");
    let teacher = Teacher::gathering(&folder, &page);
    let address = format!("http://127.0.0.1:{}/", teacher.port);
    let mut phone = Phone::sized((390, 664), &address, "");
    phone.expect("Your class plays a round");
    phone.tap_field("code");
    let focus = |phone: &mut Phone| phone.0.run(FOCUS, &[]);
    let code = Value::from(teacher.code.clone());
    phone.0.debug("Input.insertText", &json!({ "text": code }));
    phone.wait();
    assert_eq!(focus(&mut phone), json!(["input", "code", code]));
    press(&mut phone, "Enter", 13);
    assert_eq!(focus(&mut phone), json!(["input", "name", ""]));
    for text in ["A", "Ad", "Adx", "Ad", "Ada"] {
        compose(&mut phone, text);
    }
    phone.0.debug("Input.insertText", &json!({ "text": "Ada" }));
    phone.wait();
    assert_eq!(focus(&mut phone), json!(["input", "name", "Ada"]));
    press(&mut phone, "Backspace", 8);
    assert_eq!(focus(&mut phone), json!(["input", "name", "Ad"]));
    // A tap on a button does not end what is being composed.
    compose(&mut phone, "a");
    phone.press("Come in");
    phone.expect("You are in, Ada.");
    teacher.press("<Enter><Enter>", "0 of 1 have voted");
    for angle in ["60", "30"] {
        phone.type_in(angle);
        phone.go_on();
    }
    phone.expect("How sure are you?");
    phone.go_on();
    phone.expect("Your vote is in.");
    assert_eq!(kept(&folder).teams(), ["Ada"]);
}

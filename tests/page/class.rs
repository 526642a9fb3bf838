//! The page as a pupil's device: served by a host, joined by a name, voted on, and
//! back in its place when it was reloaded or out of reach.

use std::fs;

use carrom::class::Vote;
use serde_json::Value;

use crate::browser::{Browser, page, wait_until_ready};
use crate::folder::Folder;
use crate::teacher::{Teacher, kept};
use crate::touch::Phone;

/// Types letters, as the keyboard of a phone does.
fn type_in(phone: &mut Phone, text: &str) {
    for letter in text.chars() {
        let script = "document.body.dispatchEvent(new KeyboardEvent('keydown',
            { key: arguments[0], bubbles: true, cancelable: true }))";
        phone.0.run(script, &[Value::from(letter.to_string())]);
    }
}

#[test]
fn a_phone_joins_votes_and_comes_back() {
    let Some(page) = page() else { return };
    let page = fs::read_to_string(page.trim_start_matches("file://")).unwrap();
    let folder = Folder::new("page-class");
    let teacher = Teacher::gathering(&folder, &page);
    let address = format!("http://127.0.0.1:{}/", teacher.port);
    let Some(mut phone) = Phone::open(&address, &format!("code={}", teacher.code)) else {
        return;
    };
    phone.expect("Your class plays a round");
    type_in(&mut phone, "Ada");
    phone.press("Enter");
    phone.press("Enter");
    phone.expect("You are in, Ada.");
    teacher.press("<Enter><Enter>", "0 of 1 have voted");
    phone.expect("Where will they go?");
    for angle in ["60", "30"] {
        type_in(&mut phone, angle);
        phone.press("Enter");
    }
    phone.expect("How sure are you?");
    phone.press("Enter");
    phone.expect("Your vote is in.");
    teacher.wait_for("1 of 1 have voted");
    let said = kept(&folder).ballot(0, 0).first.unwrap().rays().unwrap();
    assert!((said.striker.unwrap().abs().to_degrees() - 60.0).abs() < 1e-9);
    // The page is loaded again, as a phone does that was put away.
    phone.0.run("location.reload()", &[]);
    std::thread::sleep(std::time::Duration::from_millis(500));
    wait_until_ready(&mut phone.0);
    phone.expect("Your vote is in.");
    assert_eq!(kept(&folder).teams(), ["Ada"]);
    assert_eq!(kept(&folder).voted(0, Vote::First), 1);
}

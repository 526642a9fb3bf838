//! The page's address and the browser's history: each screen is an entry in the history, a reload
//! returns to the same screen, and a link opens exactly the screen from which it was copied.

use std::thread;
use std::time::Duration;

use serde_json::Value;

use crate::browser::{Browser, SCREEN, page, press, wait_until_ready};
use crate::chromium::Chromium;

/// Runs a script until it returns the expected value.
fn expect(browser: &mut Chromium, script: &str, expected: &str) {
    let mut last = Value::Null;
    for _ in 0..60 {
        last = browser.run(script, &[]);
        if last.as_str() == Some(expected) {
            return;
        }
        thread::sleep(Duration::from_millis(50));
    }
    let screen = browser.run(SCREEN, &[]);
    panic!("{script}: {last}, not {expected}:\n{screen}");
}

fn expect_hash(browser: &mut Chromium, expected: &str) {
    expect(browser, "return location.hash", expected);
}

fn expect_title(browser: &mut Chromium, expected: &str) {
    let script = "return document.getElementById('title').textContent";
    expect(browser, script, expected);
}

fn opened(fragment: &str) -> Chromium {
    let mut browser = Chromium::start((1000, 800), false);
    browser.open(&format!("{}#{fragment}", page()));
    wait_until_ready(&mut browser);
    browser
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn back_and_forward_return_to_the_same_screens() {
    let mut browser = opened("player=Ana");
    expect_title(&mut browser, "home");
    press(&mut browser, &["l"]);
    expect_hash(&mut browser, "#lab&player=Ana");
    press(&mut browser, &["ArrowRight"]);
    expect_hash(&mut browser, "#lab=b:15.5&player=Ana");
    browser.run("history.back()", &[]);
    expect_title(&mut browser, "home");
    expect_hash(&mut browser, "#player=Ana");
    browser.run("history.forward()", &[]);
    expect_hash(&mut browser, "#lab=b:15.5&player=Ana");
    expect_title(&mut browser, "lab");
    // The program's own key for going back also goes back in the history.
    press(&mut browser, &["Escape"]);
    expect_title(&mut browser, "home");
    expect(&mut browser, "return String(history.state.index)", "0");
    for (keys, hash) in [
        (["e", "Enter"], "#lesson=momentum-is-a-vector&player=Ana"),
        (["Escape", "Escape"], "#player=Ana"),
        (["v", "Enter"], "#level=first-hits/dead-stop&player=Ana"),
    ] {
        press(&mut browser, &keys);
        expect_hash(&mut browser, hash);
    }
    browser.run("history.back()", &[]);
    expect_hash(&mut browser, "#levels&player=Ana");
    // A dialog over the screen is closed first.
    press(&mut browser, &["?"]);
    expect(
        &mut browser,
        "return String(document.getElementById('layer').open)",
        "true",
    );
    browser.run("history.back()", &[]);
    expect(
        &mut browser,
        "return String(document.getElementById('layer').open)",
        "false",
    );
    expect_hash(&mut browser, "#levels&player=Ana");
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_reload_returns_to_the_same_question() {
    let mut browser = opened("quiz=quick-7");
    let status = "return document.getElementById('status').textContent.split(' · ')[0]";
    expect(&mut browser, status, "question 1 of 5");
    // Enters an answer and the confidence, steps through the hit to its end, and continues.
    press(&mut browser, &["1"]);
    for _ in 0..40 {
        press(&mut browser, &["Enter"]);
        thread::sleep(Duration::from_millis(100));
        if browser.run(status, &[]).as_str() == Some("question 2 of 5") {
            break;
        }
    }
    expect(&mut browser, status, "question 2 of 5");
    thread::sleep(Duration::from_millis(600));
    browser.run("location.reload()", &[]);
    thread::sleep(Duration::from_millis(300));
    wait_until_ready(&mut browser);
    expect(&mut browser, status, "question 2 of 5");
    // The link does not contain the answers.
    expect_hash(&mut browser, "#quiz=quick-7");
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn leaving_a_round_asks_for_confirmation() {
    let mut browser = opened("");
    expect(&mut browser, "return String(history.state?.index)", "0");
    browser.run("location.hash = 'quiz=quick-7'", &[]);
    let status = "return document.getElementById('status').textContent.split(' · ')[0]";
    expect(&mut browser, status, "question 1 of 5");
    press(&mut browser, &["1", "Enter", "Enter"]);
    expect_hash(&mut browser, "#quiz=quick-7");
    browser.run("history.back()", &[]);
    let kind = "return document.querySelector('#layer[open]')?.className || ''";
    expect(&mut browser, kind, "question");
    expect_hash(&mut browser, "#quiz=quick-7");
    press(&mut browser, &["Escape"]);
    expect(&mut browser, kind, "");
    expect_hash(&mut browser, "#quiz=quick-7");
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_link_opens_exactly_the_hit_from_which_it_was_copied() {
    let mut browser = opened("lab=m1:15,m2:5.5,b:12,e:0.8");
    expect_hash(&mut browser, "#lab=m2:5.5,b:12,e:0.8");
    let values = "return [...document.querySelectorAll('.field.number input')]
        .map((it) => it.value).join(' ')";
    let shown = browser.run(values, &[]);
    let shown = shown.as_str().unwrap();
    for value in ["12.0", "0.80", "5.5"] {
        assert!(shown.split(' ').any(|it| it == value), "{shown}");
    }
    // The outcome of this hit is nowhere in the page.
    let mut browser = opened("lab=m1:15,m2:5.5,b:12,e:0.8,hide");
    expect_hash(&mut browser, "#lab=m2:5.5,b:12,e:0.8,hide");
    let hides = "const shown = document.querySelector('#screen').outerHTML;
        return (shown.includes('separation') || shown.includes('energy kept')) + ''";
    expect(&mut browser, hides, "false");
    let mut browser = opened("lab=m1:1e9");
    let said =
        "return document.querySelector('#layer[open]')?.textContent.includes('expected') + ''";
    expect(&mut browser, said, "true");
}

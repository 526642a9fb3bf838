//! The page sends no network requests, its content security policy forbids them, and screen readers
//! get its text.

use std::thread;
use std::time::Duration;
use std::{env, fs};

use serde_json::{Value, json};

use crate::browser::{Browser, SCREEN, page, press, wait_until_ready};
use crate::chromium::Chromium;
use crate::folder::Folder;

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn no_network_request_is_sent() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    for place in ["quiz=mixed-7", "table&seed=3", "plain&quiz=mixed-7", "foil"] {
        chromium.open("about:blank");
        chromium.requests();
        let address = format!("{page}#{place}");
        chromium.open(&address);
        wait_until_ready(&mut chromium);
        press(&mut chromium, &["Enter", " ", "Enter", "e"]);
        thread::sleep(Duration::from_millis(300));
        // Requests from the page to itself do not use the network.
        let mut asked = chromium.requests();
        asked.retain(|it| !it.starts_with("data:") && !it.starts_with("blob:"));
        assert_eq!(asked, std::slice::from_ref(&page), "{place}");
    }
    // A request that is sent must appear in the log; otherwise the assertion above would prove
    // nothing.
    chromium.run("new Image().src = 'http://127.0.0.1:9/seen'", &[]);
    thread::sleep(Duration::from_millis(300));
    let asked = chromium.requests();
    assert!(asked.iter().any(|it| it.ends_with("/seen")), "{asked:?}");
    let policy = "return document.querySelector('meta[http-equiv]').content";
    let policy = chromium.run(policy, &[]);
    assert!(policy.as_str().unwrap().contains("connect-src 'none'"));
    // The page's policy forbids all requests.
    let fetched = "
        return fetch('http://127.0.0.1:9/').then(() => 'went out', (error) => error.name)
          .then((came) => new Promise((later) =>
            setTimeout(() => later(came + ' ' + window.forbidden), 200)));";
    let watch = "addEventListener('securitypolicyviolation',
        (event) => { window.forbidden = event.effectiveDirective; });";
    chromium.run(watch, &[]);
    let came = chromium.run(fetched, &[]);
    assert_eq!(came, json!("TypeError connect-src"));
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_file_of_another_kind_is_reported() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    chromium.open(&page);
    wait_until_ready(&mut chromium);
    for (name, text) in [
        ("game-1.toml", "format = 1\nplayer = 3"),
        ("level.toml", "[[disc]]\nkind = \"stone\""),
        ("chapter.md", "no chapter at all"),
        ("song.mp3", "la la"),
        ("progress.db", "no database"),
    ] {
        let drop = "
            const dropped = new DataTransfer();
            dropped.items.add(new File([arguments[1]], arguments[0]));
            dispatchEvent(new DragEvent('drop', { dataTransfer: dropped }));";
        chromium.run(drop, &[Value::from(name), Value::from(text)]);
        thread::sleep(Duration::from_millis(200));
        let screen = chromium.run(SCREEN, &[]);
        let screen = screen.as_str().unwrap();
        assert!(
            screen.contains(name) && screen.contains("open"),
            "{name}:\n{screen}"
        );
    }
}

/// The page as a screen reader gets it: the roles and names of its accessibility tree.
fn tree(chromium: &mut Chromium) -> Vec<(String, String)> {
    let tree = chromium.debug("Accessibility.getFullAXTree", &json!({}));
    let nodes = tree["nodes"].as_array().unwrap().iter();
    let seen = nodes.filter(|node| node["ignored"] != json!(true));
    let word = |node: &Value, what: &str| node[what]["value"].as_str().unwrap_or("").to_owned();
    seen.map(|node| (word(node, "role"), word(node, "name")))
        .collect()
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_screen_reader_gets_every_question_and_answer_as_text() {
    let (page, mut chromium) = (page(), Chromium::start((1000, 700), false));
    chromium.open(&page);
    wait_until_ready(&mut chromium);
    let tab = json!({ "type": "keyDown", "key": "Tab", "code": "Tab", "windowsVirtualKeyCode": 9 });
    chromium.debug("Input.dispatchKeyEvent", &tab);
    let focused = chromium.run("return document.activeElement.id", &[]);
    assert_eq!(
        focused,
        json!("to-plain"),
        "the first link leads to plain text"
    );
    chromium.open("about:blank");
    chromium.open(&format!("{page}#plain&quiz=mixed-7"));
    wait_until_ready(&mut chromium);
    // Plays a whole round using only the accessibility tree.
    for said in 0..60 {
        let tree = tree(&mut chromium);
        let texts: Vec<_> = tree
            .iter()
            .filter(|(role, _)| role == "StaticText")
            .collect();
        if texts.iter().any(|(_, text)| text.contains("Your round.")) {
            let has = |words: &str| texts.iter().filter(|(_, it)| it.contains(words)).count();
            for question in 1..=10 {
                assert_eq!(has(&format!("Question {question} of 10")), 1, "{texts:?}");
            }
            let is_answer = |text: &&&(String, String)| {
                text.1.contains("you said ") && text.1.contains("truth ")
            };
            let answers = texts.iter().filter(is_answer).count();
            assert!(
                answers >= 10,
                "{answers} answers with their truths: {texts:?}"
            );
            println!("a round of {said} lines, played with the accessibility tree alone");
            return;
        }
        let is_field = |(role, name): &(String, String)| role == "textbox" && name == "Your line";
        assert!(tree.iter().any(is_field), "the field is named: {tree:?}");
        // The last texts before the field: the question, its options and how to answer.
        let asks = |words| {
            texts
                .iter()
                .rev()
                .take(13)
                .any(|(_, it)| it.contains(words))
        };
        let line = match () {
            () if asks("How sure") => "3",
            () if asks("Which one?") => "a",
            () if asks("What next?") => "",
            () => "30",
        };
        let say = "
            document.getElementById('line').value = arguments[0];
            document.getElementById('answer').requestSubmit();";
        chromium.run(say, &[Value::from(line)]);
        thread::sleep(Duration::from_millis(300));
    }
    panic!("the round has no end: {:?}", tree(&mut chromium));
}

/// A browser that cannot parse the program's script runs none of it.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn an_old_browser_shows_a_message_within_a_second() {
    let path = page().replacen("file://", "", 1);
    let page = fs::read_to_string(path).unwrap();
    let unread = page.replacen("\"use strict\";", "\"use strict\"; let let;", 1);
    assert_ne!(unread, page);
    let folder = Folder::new("old-browser");
    let file = folder.file("carrom.html", unread);
    let mut chromium = Chromium::start((1000, 700), false);
    chromium.open(&format!("file://{file}"));
    thread::sleep(Duration::from_secs(1));
    let words = chromium.run("return document.getElementById('words').textContent", &[]);
    let words = words.as_str().unwrap();
    assert!(words.starts_with("This browser is too old"), "{words}");
    let early = include_str!("../../web/page/early.js");
    let newer = [
        "=>", "const ", "let ", "`", "?.", "??", "||=", "class ", "...",
    ];
    assert!(newer.iter().all(|it| !early.contains(it)), "{early}");
}

/// Checks every screen with axe-core; `CARROM_TEST_AXE` is the path of `axe.min.js` from the npm
/// package.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn axe_finds_no_problem_on_any_screen() {
    let path = env::var("CARROM_TEST_AXE").expect("CARROM_TEST_AXE: .ci/run fetches axe-core");
    let axe = fs::read_to_string(path).unwrap();
    let (page, mut chromium) = (page(), Chromium::start((390, 664), true));
    let mut found = Vec::new();
    for scheme in ["dark", "light"] {
        let media = json!({ "features": [{ "name": "prefers-color-scheme", "value": scheme }] });
        chromium.debug("Emulation.setEmulatedMedia", &media);
        for (place, keys) in [
            ("", "? Escape s"),
            ("lab", "? Escape Enter Enter Enter"),
            ("learn", ""),
            ("lesson=1", "Enter Enter"),
            ("quiz", "? Escape"),
            ("quiz=quick-7", "a Enter 2 Enter"),
            ("quiz=exam-3", ""),
            ("class", ""),
            ("join", ""),
            ("foil", ""),
            ("foil=2", ""),
            ("foil=3", ""),
            ("table&seed=3", "Enter ArrowUp Space"),
            ("rules", "ArrowRight"),
            ("levels", ""),
            ("level=dead-stop", "Enter"),
            ("progress", ""),
            ("settings", ""),
            ("glossary", ""),
            ("plain", ""),
        ] {
            chromium.open("about:blank");
            chromium.open(&format!("{page}#{place}"));
            wait_until_ready(&mut chromium);
            chromium.run(&axe, &[]);
            let mut before = String::new();
            for key in [""].into_iter().chain(keys.split_whitespace()) {
                if !key.is_empty() {
                    press(&mut chromium, &[key]);
                }
                thread::sleep(Duration::from_millis(400));
                let run = "
                    const only = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
                    return axe.run(document, { runOnly: only }).then(({ violations }) =>
                      violations.map((it) => `${it.impact} ${it.id}: ${it.nodes[0].html}`));";
                let faults = chromium.run(run, &[]);
                before = format!("{before} {key}");
                if faults != json!([]) {
                    found.push(format!("{scheme} {place}{before}: {faults}"));
                }
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

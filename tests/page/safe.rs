//! The page asks nothing of any network, says so in its policy, and has its words for those
//! who do not see.

use serde_json::{Value, json};

use crate::browser::{Browser, SCREEN, page, wait_until_ready};
use crate::chromium::Chromium;

#[test]
fn nothing_is_asked_of_a_network() {
    let Some((page, mut chromium)) = page().zip(Chromium::start((1000, 700), false)) else {
        return;
    };
    chromium.open(&format!("{page}#quiz=mixed-7"));
    wait_until_ready(&mut chromium);
    let asked = "return performance.getEntriesByType('resource').map(it => it.name)";
    assert_eq!(chromium.run(asked, &[]), json!([]));
    // Its policy forbids it to whoever would.
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
fn a_file_that_is_none_is_told() {
    let Some((page, mut chromium)) = page().zip(Chromium::start((1000, 700), false)) else {
        return;
    };
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
        std::thread::sleep(std::time::Duration::from_millis(200));
        let screen = chromium.run(SCREEN, &[]);
        let screen = screen.as_str().unwrap();
        assert!(
            screen.contains(name) && screen.contains("open"),
            "{name}:\n{screen}"
        );
    }
}

/// What a screen reader has of the page: the roles and names of its accessibility tree.
fn tree(chromium: &mut Chromium) -> Vec<(String, String)> {
    let tree = chromium.debug("Accessibility.getFullAXTree", &json!({}));
    let nodes = tree["nodes"].as_array().unwrap().iter();
    let seen = nodes.filter(|node| node["ignored"] != json!(true));
    let word = |node: &Value, what: &str| node[what]["value"].as_str().unwrap_or("").to_owned();
    seen.map(|node| (word(node, "role"), word(node, "name")))
        .collect()
}

#[test]
fn a_screen_reader_has_every_question_and_answer_as_text() {
    let Some((page, mut chromium)) = page().zip(Chromium::start((1000, 700), false)) else {
        return;
    };
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
    chromium.open(&format!("{page}#plain&quiz=mixed-7"));
    chromium.open("about:blank");
    chromium.open(&format!("{page}#plain&quiz=mixed-7"));
    wait_until_ready(&mut chromium);
    for line in ["", "a", "3"] {
        if !line.is_empty() {
            let say = "
                document.getElementById('line').value = arguments[0];
                document.getElementById('answer').requestSubmit();";
            chromium.run(say, &[Value::from(line)]);
            std::thread::sleep(std::time::Duration::from_millis(300));
        }
        let tree = tree(&mut chromium);
        let has = |words: &str| tree.iter().any(|(_, name)| name.contains(words));
        assert!(has("Question 1 of 10"), "{tree:?}");
        assert!(has("Your answer"), "the field is named: {tree:?}");
        if line == "3" {
            assert!(has("You said:") && has("It is:"), "{tree:?}");
            assert!(has("Question 2 of 10"), "{tree:?}");
        }
    }
}

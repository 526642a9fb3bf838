//! All the main tasks in carrom, from joining a class to playing a stroke: by touch alone on phones
//! and a tablet, in windows reduced by the browser's bars, and by keyboard alone on a computer,
//! also at 200 % zoom. `CARROM_TEST_SHOTS` is a folder that receives screenshots of every step, for
//! people to look at, and the text that a screen reader gets.

use std::path::Path;
use std::{env, fs};

use carrom::class::Vote;
use serde_json::{Value, json};

use crate::browser::{Browser, page};
use crate::chromium::Chromium;
use crate::folder::Folder;
use crate::teacher::{Teacher, kept};
use crate::touch::{Phone, answer};

/// A visitor on one device, and the screenshots of the visit.
struct Visit {
    phone: Phone,
    name: String,
    pictures: usize,
    has_keyboard: bool,
}

impl Visit {
    fn by_touch(width: u32, height: u32) -> Self {
        Self {
            phone: Phone(Chromium::start((width, height), true)),
            name: format!("{width}x{height}"),
            pictures: 0,
            has_keyboard: false,
        }
    }

    /// A visit by keyboard at this zoom, which makes CSS pixels larger, so that fewer fit in the
    /// window.
    fn by_keyboard(width: u32, height: u32, zoom: u32) -> Self {
        let mut chromium = Chromium::start((width, height), false);
        let seen = json!({
            "width": width / zoom, "height": height / zoom, "deviceScaleFactor": zoom,
            "mobile": false,
        });
        chromium.debug("Emulation.setDeviceMetricsOverride", &seen);
        Self {
            phone: Phone(chromium),
            name: format!("keyboard-{zoom}00"),
            pictures: 0,
            has_keyboard: true,
        }
    }

    /// Asserts that nothing scrolls sideways or is illegible; if `CARROM_TEST_SHOTS` names a folder,
    /// also saves a screenshot and the text of the page there.
    fn look(&mut self, what: &str) {
        self.phone.wait();
        self.phone.assert_fits();
        self.phone.assert_legible();
        let Some(folder) = env::var_os("CARROM_TEST_SHOTS") else {
            return;
        };
        let shot = self.phone.0.debug("Page.captureScreenshot", &json!({}));
        let tree = self
            .phone
            .0
            .debug("Accessibility.getFullAXTree", &json!({}));
        self.pictures += 1;
        let write = |kind: &str, text: &str| {
            let name = format!("{}-{:02}-{what}.{kind}", self.name, self.pictures);
            fs::write(Path::new(&folder).join(name), text).unwrap();
        };
        write("png.base64", shot["data"].as_str().unwrap());
        write("txt", &spoken(&tree));
    }

    /// Presses keys of a real keyboard, written as in a tape.
    fn keys(&mut self, keys: &str) {
        let mut rest = keys;
        while let Some(first) = rest.chars().next() {
            let named = rest.strip_prefix('<').and_then(|it| it.split_once('>'));
            let (key, after) = named.unwrap_or_else(|| rest.split_at(first.len_utf8()));
            rest = after;
            let text = match key {
                "Enter" => "\r",
                "Space" => " ",
                _ if named.is_some() => "",
                letter => letter,
            };
            let key = match key {
                "Space" => " ",
                "Right" => "ArrowRight",
                key => key,
            };
            let code = match key {
                "Enter" => 13,
                "Tab" => 9,
                "Escape" => 27,
                _ => 0,
            };
            for kind in ["keyDown", "keyUp"] {
                let text = if kind == "keyDown" { text } else { "" };
                let event = json!({
                    "type": kind, "key": key, "text": text, "windowsVirtualKeyCode": code,
                });
                self.phone.0.debug("Input.dispatchKeyEvent", &event);
            }
            self.phone.wait();
        }
    }

    /// Fills in the fields for the rays.
    fn say(&mut self, angles: [&str; 2]) {
        for (number, angle) in angles.into_iter().enumerate() {
            if self.has_keyboard {
                self.keys(&format!("{angle}<Enter>"));
            } else {
                self.phone.type_into(number, angle);
                self.phone.go_on();
            }
        }
    }

    /// Carries out the main action; by touch, returns whether there is a button for it.
    fn go_on(&mut self) -> bool {
        if self.has_keyboard {
            let skips = self.phone.shows("Go on without answering");
            self.keys(if skips { "s" } else { "<Enter>" });
            return true;
        }
        self.phone.go_on()
    }

    fn until(&mut self, words: &str) {
        for _ in 0..200 {
            if self.phone.shows(words) {
                return;
            }
            if !self.go_on() {
                self.phone.wait();
            }
        }
        self.phone.expect(words);
    }

    /// Joins a class and votes twice.
    fn class(&mut self) {
        let page = page();
        let page = fs::read_to_string(page.trim_start_matches("file://")).unwrap();
        let folder = Folder::new(&format!("page-visit-{}", self.name));
        let teacher = Teacher::gathering(&folder, &page);
        let address = format!("http://127.0.0.1:{}/", teacher.port);
        let code = format!("code={}", teacher.code);
        self.phone.go_to(&address, &code);
        self.phone.expect("Your class is playing a round");
        self.look("join");
        if self.has_keyboard {
            self.keys("Ada<Enter><Enter>");
        } else {
            self.phone.type_in("Ada");
            self.phone.press("Join the class");
        }
        self.phone.expect("You are in, Ada.");
        self.look("lobby");
        teacher.press("<Enter><Enter>", "0 of 1 have voted");
        self.vote(["60", "30"]);
        teacher.press("<Enter>", "Talk");
        self.phone.expect("Talk");
        self.look("talk");
        teacher.press("<Enter>", "0 of 1 have voted again");
        self.vote(["45", "45"]);
        teacher.wait_for("1 of 1 have voted again");
        for (vote, degrees) in [(Vote::First, 60.0), (Vote::Second, 45.0)] {
            let said = kept(&folder).ballot(0, 0).vote(vote).unwrap();
            let striker = said.rays().unwrap().striker.unwrap();
            assert!((striker.abs().to_degrees() - degrees).abs() < 1e-9);
        }
    }

    fn vote(&mut self, angles: [&str; 2]) {
        self.phone.expect("Where will they go?");
        self.look("vote");
        self.say(angles);
        self.phone.expect("How sure are you?");
        self.look("how-sure");
        self.go_on();
        self.phone.expect("Your vote is in.");
    }

    /// Plays a round of the quiz to its end.
    fn round(&mut self, code: &str, end: &str) {
        self.phone.go_to(&page(), &format!("quiz={code}"));
        for question in 1.. {
            assert!(question < 20, "{code} does not end");
            self.phone.expect(&format!("question {question} of"));
            self.look("question");
            self.answer();
            self.phone.expect("How sure");
            self.look("how-sure");
            if self.has_keyboard {
                self.keys("2");
            } else {
                assert!(self.phone.choose("think so"));
            }
            let next = format!("question {} of", question + 1);
            for step in 0..100 {
                if self.phone.shows(&next) || self.phone.shows(end) {
                    break;
                }
                if step == 3 {
                    self.look("told");
                }
                if !self.go_on() {
                    self.phone.wait();
                }
            }
            if self.phone.shows(end) {
                break;
            }
        }
        self.look("round");
    }

    /// Gives some answer to the question on the screen.
    fn answer(&mut self) {
        if !self.has_keyboard {
            return answer(&mut self.phone);
        }
        for key in ["a", "4", "<Enter>", "5", "<Enter>", "<Enter>"] {
            if self.phone.shows("How sure") {
                return;
            }
            self.keys(key);
        }
    }

    /// Plays a shot in the lab; on a touch screen, its offset and the predicted rays are dragged.
    fn lab(&mut self) {
        self.phone.go_to(&page(), "lab");
        self.look("lab");
        let before = self.field("offset");
        if self.has_keyboard {
            self.keys("<Right><Right>");
        } else {
            self.phone.drag([0.5, 0.5], [0.5, 0.42]);
        }
        assert_ne!(self.field("offset"), before);
        self.look("lab-aimed");
        self.go_on();
        self.phone.expect("Where will they go?");
        self.look("lab-predict");
        if !self.has_keyboard {
            self.phone.drag([0.6, 0.5], [0.8, 0.2]);
        }
        self.say(["60", "30"]);
        self.until("New shot");
        self.look("lab-shown");
    }

    /// The value in the field with this name.
    fn field(&mut self, name: &str) -> Value {
        let script = "
            const all = [...document.querySelectorAll('.field input')];
            return all.find((it) => it.closest('.field').textContent.includes(arguments[0])).value;";
        self.phone.0.run(script, &[name.into()])
    }

    /// Plays the first stroke of a board.
    fn stroke(&mut self) {
        self.phone.go_to(&page(), "table&seed=3");
        self.look("table");
        self.go_on();
        self.phone.expect("You break");
        self.look("table-aim");
        if self.has_keyboard {
            self.keys("<Right><Right><Space>");
        } else {
            self.phone.drag([0.5, 0.6], [0.4, 0.3]);
            self.look("table-aimed");
            self.phone.press("strike");
        }
        self.phone.wait();
        self.until("stroke 2");
        self.look("table-next");
    }

    /// Predicts and watches a level.
    fn level(&mut self) {
        self.phone.go_to(&page(), "level=dead-stop");
        self.until("Predict both paths");
        self.look("level");
        if self.has_keyboard {
            self.keys("<Right>");
        } else {
            self.phone.type_into(0, "44");
        }
        self.until("predict it");
        self.look("level-said");
        for _ in 0..4 {
            if self.phone.shows("predict it") {
                if self.has_keyboard {
                    self.keys("45<Enter>");
                } else {
                    self.phone.type_in("45");
                    self.phone.go_on();
                }
            }
        }
        self.until("Try again from the same aim");
        self.look("level-told");
    }

    /// Reads a chapter to its last page.
    fn chapter(&mut self) {
        self.phone.go_to(&page(), "lesson=1");
        for page in 0..40 {
            self.look("chapter");
            if self.phone.shows("chapters done") {
                return;
            }
            if self.has_keyboard {
                self.keys(if page % 2 == 0 { "<Enter>" } else { "n" });
            } else if !["next page", "skip", "next"]
                .iter()
                .any(|label| self.phone.button(label))
            {
                self.phone.go_on();
            }
        }
        panic!("the chapter does not end");
    }

    fn whole(mut self) {
        self.class();
        self.round("quick-7", "your round");
        self.round("find-out-7", "what you seem to believe");
        self.lab();
        self.stroke();
        self.level();
        self.chapter();
    }
}

/// The role, name and value of each named node of an accessibility tree.
fn spoken(tree: &Value) -> String {
    let nodes = tree["nodes"].as_array().into_iter().flatten();
    let lines = nodes.filter_map(|node| {
        let of = |field: &str| node[field]["value"].as_str().unwrap_or_default();
        let (role, name) = (of("role"), of("name"));
        let is_heard = node["ignored"] == json!(false) && role != "InlineTextBox";
        (is_heard && !name.is_empty()).then(|| format!("{role}: {name} {}\n", of("value")))
    });
    lines.collect()
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_visit_by_touch_at_320_by_568() {
    Visit::by_touch(320, 568).whole();
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_visit_by_touch_at_360_by_640() {
    Visit::by_touch(360, 640).whole();
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_visit_by_touch_at_390_by_664() {
    Visit::by_touch(390, 664).whole();
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_visit_by_touch_at_412_by_732() {
    Visit::by_touch(412, 732).whole();
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_visit_by_touch_at_768_by_1024() {
    Visit::by_touch(768, 1024).whole();
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_visit_by_keyboard_alone() {
    Visit::by_keyboard(1366, 650, 1).whole();
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_visit_by_keyboard_alone_at_200_percent() {
    Visit::by_keyboard(1366, 650, 2).whole();
}

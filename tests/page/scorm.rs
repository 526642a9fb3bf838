//! A SCORM package in a learning platform: the runtime `scorm-again` from npm, in a page that shows
//! the package in a frame. `CARROM_TEST_SCORM` is the path of its `scorm12.min.js`.

use std::io::Read;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

use serde_json::{Value, json};
use zip::ZipArchive;

use crate::browser::{Browser, page, wait_until_ready};
use crate::chromium::Chromium;
use crate::folder::Folder;
use crate::site::serve;
use crate::touch::{Phone, answer};

/// The size of a phone's window, without the browser's bars.
const SIZE: (u32, u32) = (390, 664);

/// The platform's page. It loads the data after `?` in its address, and keeps what a package
/// reports until the page is left.
const PLATFORM: &str = "<!doctype html><body style='margin:0'><script src='runtime.js'></script>
<script>
  window.API = new Scorm12API({ autocommit: false, logLevel: 5 });
  const kept = decodeURIComponent(location.search.slice(1));
  if (kept) API.loadFromJSON(JSON.parse(kept));
</script>
<iframe src='index.html' style='border:0;width:100vw;height:100vh;display:block'></iframe>";

/// Unpacks the package of a round beside the platform's page.
fn package(folder: &Path, code: &str) {
    let file = folder.join("round.zip");
    let mut carrom = Command::new(env!("CARGO_BIN_EXE_carrom"));
    carrom.args(["page", "--scorm", code, "--page"]);
    carrom.arg(page().trim_start_matches("file://"));
    assert!(carrom.arg("--out").arg(&file).status().unwrap().success());
    let mut package = ZipArchive::new(fs::File::open(file).unwrap()).unwrap();
    for name in ["imsmanifest.xml", "index.html"] {
        let mut text = String::new();
        package
            .by_name(name)
            .unwrap()
            .read_to_string(&mut text)
            .unwrap();
        fs::write(folder.join(name), text).unwrap();
    }
    let runtime = env::var("CARROM_TEST_SCORM");
    let runtime = runtime.expect("CARROM_TEST_SCORM: .ci/run fetches scorm-again");
    fs::copy(runtime, folder.join("runtime.js")).unwrap();
    fs::write(folder.join("platform.html"), PLATFORM).unwrap();
}

/// A phone on which the platform shows the package.
struct Lesson {
    phone: Phone,
    address: String,
}

impl Lesson {
    fn open(address: &str, prefs: &Value) -> Self {
        let phone = Phone(Chromium::start_as(SIZE, true, prefs));
        let mut lesson = Self {
            phone,
            address: address.to_owned(),
        };
        lesson.reopen("");
        lesson
    }

    /// Opens the platform again with the data that it has kept.
    fn reopen(&mut self, kept: &str) {
        let chromium = &mut self.phone.0;
        chromium.go_to_frame(false);
        chromium.open("about:blank");
        let script = "return encodeURIComponent(arguments[0])";
        let kept = chromium.run(script, &[kept.into()]);
        chromium.open(&format!("{}?{}", self.address, kept.as_str().unwrap()));
        chromium.go_to_frame(true);
        wait_until_ready(chromium);
        self.phone.wait();
    }

    /// The data that the platform has received from the package.
    fn received(&mut self) -> Value {
        self.phone.0.go_to_frame(false);
        let script = "return JSON.stringify(API.renderCMIToJSONObject().cmi)";
        let json = self.phone.0.run(script, &[]);
        self.phone.0.go_to_frame(true);
        serde_json::from_str(json.as_str().unwrap()).unwrap()
    }

    /// Answers the questions with these numbers by touch, in a round of `count` questions.
    fn answer(&mut self, questions: impl Iterator<Item = usize>, count: usize) {
        let phone = &mut self.phone;
        for question in questions {
            phone.expect(&format!("question {question} of {count}"));
            phone.assert_fits();
            answer(phone);
            phone.expect("How sure");
            assert!(phone.choose("think so"));
            let next = match question == count {
                true => "your round".to_owned(),
                false => format!("question {} of {count}", question + 1),
            };
            phone.until(&next, Phone::go_on);
        }
    }
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_learning_platform_receives_a_round_that_is_interrupted_and_finished() {
    let folder = Folder::new("page-scorm");
    package(folder.path(), "quick-7");
    let (port, _) = serve(folder.path().to_owned());
    let address = format!("http://127.0.0.1:{port}/platform.html");
    let mut lesson = Lesson::open(&address, &json!({}));
    lesson.answer(1..=2, 5);
    let first = lesson.received();
    let core = &first["core"];
    assert_eq!(core["lesson_status"], "incomplete");
    assert_eq!(core["exit"], "suspend");
    let kept = json!({
        "suspend_data": first["suspend_data"],
        "core": { "lesson_status": "incomplete", "entry": "resume" },
    });
    lesson.reopen(&kept.to_string());
    lesson.answer(3..=5, 5);
    let all = lesson.received();
    let core = &all["core"];
    assert_eq!(core["lesson_status"], "completed");
    assert!(core["session_time"].as_str().unwrap() > "0000:00:00");
    let score: f64 = core["score"]["raw"].as_str().unwrap().parse().unwrap();
    assert!((0.0..=100.0).contains(&score), "{score}");
    assert_eq!(core["score"]["max"], "100");
    let mut received = Vec::new();
    for part in [&first, &all] {
        for (_, it) in part["interactions"].as_object().unwrap() {
            if it["id"].is_string() {
                received.push(it.clone());
            }
        }
    }
    let ids: Vec<_> = received
        .iter()
        .map(|it| it["id"].as_str().unwrap())
        .collect();
    assert_eq!(ids, [1, 2, 3, 4, 5].map(|it| format!("quick-7.{it}")));
    for it in &received {
        let right = it["student_response"] == it["correct_responses"]["0"]["pattern"];
        assert!(
            it["result"] == "correct" || !right && it["result"] == "wrong",
            "{it}"
        );
        assert_ne!(it["student_response"], "");
    }
    // A finished round shows its result when it is opened again, and reports nothing more.
    lesson.reopen(
        &json!({
            "suspend_data": all["suspend_data"],
            "core": { "lesson_status": "completed", "entry": "resume" },
        })
        .to_string(),
    );
    lesson.phone.expect("your round");
    assert_eq!(lesson.received()["core"]["lesson_status"], "completed");
}

/// Some browsers do not let a page save anything if it is in a frame on another site.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_learning_platform_receives_a_round_from_a_browser_that_saves_nothing() {
    let folder = Folder::new("page-scorm-blocked");
    package(folder.path(), "quick-7");
    let (port, _) = serve(folder.path().to_owned());
    let address = format!("http://127.0.0.1:{port}/platform.html");
    let blocked = json!({ "profile.default_content_setting_values.cookies": 2 });
    let mut lesson = Lesson::open(&address, &blocked);
    let saves = "try { return !!localStorage } catch { return false }";
    assert_eq!(lesson.phone.0.run(saves, &[]), json!(false));
    lesson.answer(1..=5, 5);
    assert_eq!(lesson.received()["core"]["lesson_status"], "completed");
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn without_a_learning_platform_a_package_warns_that_nothing_is_reported() {
    let folder = Folder::new("page-scorm-alone");
    package(folder.path(), "quick-7");
    let (port, _) = serve(folder.path().to_owned());
    let mut phone = Phone(Chromium::start(SIZE, true));
    phone.0.open(&format!("http://127.0.0.1:{port}/index.html"));
    wait_until_ready(&mut phone.0);
    phone.expect("no learning platform");
}

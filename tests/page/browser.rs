//! The interface of every browser under test, and functions that use it.

use std::path::PathBuf;
use std::{env, fs};

use serde_json::{Value, json};

/// A browser; dropping the value closes it.
pub(crate) trait Browser {
    fn open(&mut self, address: &str);

    /// Runs the body of a function on the page and returns its result.
    fn run(&mut self, script: &str, arguments: &[Value]) -> Value;
}

/// The visible text of the page and the values of its fields, without the text that is only for
/// screen readers, which may be out of date.
pub(crate) const SCREEN: &str = "
    const values = [...document.querySelectorAll('#screen input')].map((it) => it.value);
    const isSeen = (it) => it.id !== 'news' && it.getClientRects().length > 0;
    const seen = [...document.body.children].filter(isSeen);
    return [...seen.map((it) => it.innerText), ...values].join('\\n').replaceAll('\\u00a0', ' ');";

/// The address of the page to test.
pub(crate) fn page() -> String {
    named_page().expect("a page: .ci/page builds it, and CARROM_TEST_PAGE names it")
}

/// The address of the page in `CARROM_TEST_PAGE`, if that is set.
pub(crate) fn named_page() -> Option<String> {
    let path = env::var_os("CARROM_TEST_PAGE").map(PathBuf::from)?;
    let path = fs::canonicalize(&path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
    Some(format!("file://{}", path.display()))
}

/// From now on, records the time of each frame in `frameTimes`.
pub(crate) const TIME_FRAMES: &str = "
    window.frameTimes = [];
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (draw) => request((time) => {
      window.frameTimes.push(time);
      draw(time);
    });";

/// Presses keys one after the other, as on a keyboard.
pub(crate) fn press(browser: &mut dyn Browser, keys: &[&str]) {
    let script = "
        for (const key of arguments[0]) {
          document.body.dispatchEvent(
            new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
        }";
    browser.run(script, &[json!(keys)]);
}

/// Waits until the program on the page is ready.
pub(crate) fn wait_until_ready(browser: &mut dyn Browser) {
    let ready = "return !!(window.carrom && window.carrom.isReady())";
    for _ in 0..200 {
        if browser.run(ready, &[]) == Value::Bool(true) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    let words = browser.run("return document.getElementById('words').textContent", &[]);
    panic!("the page did not open: {words}");
}

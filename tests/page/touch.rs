//! Touch-only use of the page, mostly on a phone in portrait.

use serde_json::{Value, json};

use crate::browser::{Browser, SCREEN, page, press, wait_until_ready};
use crate::chromium::Chromium;

/// A phone on which the page is open, used with a finger.
pub(crate) struct Phone(pub(crate) Chromium);

/// Window sizes of phones held upright and sideways, of a tablet and of a computer.
const SIZES: [(u32, u32); 6] = [
    (320, 568),
    (390, 664),
    (412, 732),
    (844, 390),
    (768, 1024),
    (1366, 650),
];
/// The size of a phone held upright.
const UPRIGHT: (u32, u32) = (390, 844);

impl Phone {
    pub(crate) fn open(page: &str, fragment: &str) -> Self {
        Self::sized(UPRIGHT, page, fragment)
    }

    /// Opens the page in a window of this size.
    pub(crate) fn sized(size: (u32, u32), page: &str, fragment: &str) -> Self {
        let mut phone = Self(Chromium::start(size, true));
        phone.go_to(page, fragment);
        phone
    }

    /// Reopens the page at a route.
    pub(crate) fn go_to(&mut self, page: &str, fragment: &str) {
        self.0.open("about:blank");
        self.0.open(&format!("{page}#{fragment}"));
        wait_until_ready(&mut self.0);
        self.wait();
    }

    /// Waits long enough for the last event to have been drawn, even on a busy machine.
    pub(crate) fn wait(&mut self) {
        std::thread::sleep(std::time::Duration::from_millis(120));
        self.draw();
    }

    /// Waits until two frames have been drawn.
    fn draw(&mut self) {
        let drawn = "return new Promise((done) =>
            requestAnimationFrame(() => requestAnimationFrame(() => done(true))));";
        self.0.run(drawn, &[]);
    }

    /// The text on the screen, line by line.
    fn screen(&mut self) -> Vec<String> {
        let screen = self.0.run(SCREEN, &[]);
        screen
            .as_str()
            .unwrap()
            .lines()
            .map(str::to_owned)
            .collect()
    }

    pub(crate) fn shows(&mut self, words: &str) -> bool {
        self.screen().iter().any(|row| row.contains(words))
    }

    pub(crate) fn expect(&mut self, words: &str) {
        for _ in 0..50 {
            if self.shows(words) {
                return;
            }
            self.wait();
        }
        panic!("no \"{words}\":\n{}", self.screen().join("\n"));
    }

    fn touch(&mut self, kind: &str, points: &[[f64; 2]]) {
        let points: Vec<_> = points
            .iter()
            .map(|[x, y]| json!({ "x": x, "y": y }))
            .collect();
        let event = json!({ "type": kind, "touchPoints": points });
        self.0.debug("Input.dispatchTouchEvent", &event);
    }

    pub(crate) fn tap(&mut self, at: [f64; 2]) {
        self.touch("touchStart", &[at]);
        self.touch("touchEnd", &[]);
        self.wait();
    }

    /// The centre of the element that a script finds, scrolled into view, once it is at rest: a
    /// person would not tap something that is still moving.
    fn middle(&mut self, script: &str, words: &str) -> Option<[f64; 2]> {
        let script = format!(
            "const seen = (it) => it.getClientRects().length > 0;
            const text = (it) => it.textContent.replaceAll('\\u00a0', ' ').trim().toLowerCase();
            const words = arguments[0].toLowerCase();
            const over = document.querySelector('dialog[open]') || document.getElementById('game');
            const found = (() => {{ {script} }})();
            if (!found) return null;
            found.scrollIntoView({{ block: 'nearest', inline: 'nearest' }});
            const box = found.getBoundingClientRect();
            return [box.left + box.width / 2, box.top + box.height / 2];"
        );
        let mut last = None;
        for _ in 0..20 {
            let place = self.0.run(&script, &[Value::from(words)]);
            let place = Some([place[0].as_f64()?, place[1].as_f64()?]);
            if place == last {
                return place;
            }
            last = place;
            self.draw();
        }
        last
    }

    /// Taps the button with this text or key; returns whether there is one.
    pub(crate) fn button(&mut self, label: &str) -> bool {
        let script = "
            const all = [...over.querySelectorAll('button')].filter(seen);
            return all.find((it) => text(it).replace(/!$/, '') === words)
              || all.find((it) => it.dataset.key === arguments[0]);"
            .replace("arguments[0]", &format!("{label:?}"));
        let place = self.middle(&script, label);
        place.map(|at| self.tap(at)).is_some()
    }

    /// Taps the main button; returns whether there is one.
    pub(crate) fn go_on(&mut self) -> bool {
        // The visits skip the question about what the player saw.
        if self.shows("Go on without answering") {
            return self.button("Go on without answering");
        }
        let script = "
            const all = over.querySelectorAll('#keys .primary, .answers button');
            return [...all].find(seen);";
        let place = self.middle(script, "");
        place.map(|at| self.tap(at)).is_some()
    }

    pub(crate) fn press(&mut self, label: &str) -> bool {
        assert!(self.button(label), "no {label}: {}", self.buttons());
        true
    }

    fn buttons(&mut self) -> Value {
        let script = "return [...document.querySelectorAll('button')].map(it => it.textContent)";
        self.0.run(script, &[])
    }

    /// Repeats an action until the page shows a text.
    pub(crate) fn until(&mut self, words: &str, mut act: impl FnMut(&mut Self) -> bool) {
        for _ in 0..1000 {
            if self.shows(words) {
                return;
            }
            if !act(self) {
                self.wait();
            }
        }
        panic!("no \"{words}\":\n{}", self.screen().join("\n"));
    }

    /// Taps the first option that contains this text; returns whether there is one.
    pub(crate) fn choose(&mut self, words: &str) -> bool {
        let script = "
            const all = [...over.querySelectorAll('.choice')].filter(seen);
            return all.find((it) => text(it).includes(words));";
        let place = self.middle(script, words);
        place.map(|at| self.tap(at)).is_some()
    }

    /// Taps the first empty field, or else the first field, and types with the keyboard that
    /// appears; returns whether there is a field.
    pub(crate) fn type_in(&mut self, text: &str) -> bool {
        let script = "
            const all = [...over.querySelectorAll('.field input')].filter(seen);
            return all.find((it) => it.value === '') || all[0];";
        let Some(place) = self.middle(script, "") else {
            return false;
        };
        self.tap(place);
        let inserted = json!({ "text": text });
        self.0.debug("Input.insertText", &inserted);
        self.wait();
        true
    }

    /// Taps the field with this number and types there.
    pub(crate) fn type_into(&mut self, number: usize, text: &str) {
        let script = "return [...over.querySelectorAll('.field input')].filter(seen)[words]";
        let place = self.middle(script, &number.to_string()).expect("a field");
        self.tap(place);
        let inserted = json!({ "text": text });
        self.0.debug("Input.insertText", &inserted);
        self.wait();
    }

    /// Taps the field with this name.
    pub(crate) fn tap_field(&mut self, name: &str) {
        let script = "
            const all = [...over.querySelectorAll('.field input')].filter(seen);
            return all.find((it) => text(it.closest('.field')).includes(words));";
        let place = self.middle(script, name).expect("a field");
        self.tap(place);
    }

    /// Taps the button beside this name, which sets the next value.
    pub(crate) fn tap_value(&mut self, name: &str) -> bool {
        let script = "
            const all = [...over.querySelectorAll('.field')].filter(seen);
            const field = all.find((it) => text(it.querySelector('.name')) === words);
            return field?.querySelector('button');";
        let place = self.middle(script, name);
        place.map(|at| self.tap(at)).is_some()
    }

    /// The value that the panel shows for a name.
    fn fact(&mut self, name: &str) -> Value {
        let script = format!(
            "const names = [...document.querySelectorAll('dt')];
            return names.find((it) => it.textContent === {name:?}).nextSibling.textContent;"
        );
        self.0.run(&script, &[])
    }

    /// The point in the window at these fractions of the picture's width and height.
    pub(crate) fn place(&mut self, [across, down]: [f64; 2]) -> [f64; 2] {
        let script = "
            const canvas = document.querySelector('#screen canvas');
            canvas.scrollIntoView({ block: 'nearest' });
            const box = canvas.getBoundingClientRect();
            return [box.left, box.top, box.width, box.height];";
        let found = self.0.run(script, &[]);
        let [left, top, width, height] = [0, 1, 2, 3].map(|i| found[i].as_f64().unwrap());
        [left + across * width, top + down * height]
    }

    /// Drags over the picture; the points are given as fractions of its width and height.
    pub(crate) fn drag(&mut self, from: [f64; 2], to: [f64; 2]) {
        let [from, to] = [from, to].map(|it| self.place(it));
        self.touch("touchStart", &[from]);
        for step in 1..=5 {
            let share = f64::from(step) / 5.0;
            let at = [0, 1].map(|i| from[i] + share * (to[i] - from[i]));
            self.touch("touchMove", &[at]);
        }
        // The finger must come to rest. If it were lifted while moving, the browser would see a
        // fling and take the next tap as its end.
        self.wait();
        self.touch("touchMove", &[to]);
        self.touch("touchEnd", &[]);
        self.wait();
    }

    /// Moves a finger up from a point of the window; returns how far the screen has scrolled.
    fn scroll_from(&mut self, [x, y]: [f64; 2]) -> f64 {
        self.touch("touchStart", &[[x, y]]);
        for step in 1..=8 {
            self.touch("touchMove", &[[x, y - 20.0 * f64::from(step)]]);
        }
        self.wait();
        self.touch("touchEnd", &[]);
        self.wait();
        let scrolled = "return document.getElementById('screen').scrollTop";
        self.0.run(scrolled, &[]).as_f64().unwrap_or_default()
    }

    /// Asserts that neither the page nor the screen in it scrolls sideways.
    pub(crate) fn assert_fits(&mut self) {
        let script = "
            const screen = document.getElementById('screen');
            return [document.documentElement.scrollWidth - innerWidth,
              screen.scrollWidth - screen.clientWidth];";
        let wide = self.0.run(script, &[]);
        assert_eq!(
            wide,
            json!([0, 0]),
            "it scrolls sideways: {}",
            self.buttons()
        );
    }

    /// Asserts that no letter is too small to read.
    pub(crate) fn assert_legible(&mut self) {
        let script = "
            const small = [...document.querySelectorAll('#game *, dialog[open] *')].filter((it) =>
              it.getClientRects().length > 0
              && [...it.childNodes].some((node) => node.nodeType === 3 && node.data.trim())
              && parseFloat(getComputedStyle(it).fontSize) < 14);
            return small.map((it) => it.outerHTML);";
        assert_eq!(self.0.run(script, &[]), json!([]));
    }
}

/// Every screen is also legible, at every size.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn no_screen_scrolls_sideways() {
    let page = page();
    for size in SIZES {
        let chromium = Chromium::start(size, true);
        let mut phone = Phone(chromium);
        // The keys lead to the states of each screen; Tab does nothing where it has no action.
        for (screen, keys) in [
            ("home", "? Escape s Enter"),
            ("lab", "Enter Enter Enter"),
            ("learn", "ArrowDown Enter"),
            ("lesson=3", "ArrowDown Tab Enter"),
            ("quiz", "Enter a Enter"),
            ("quiz=mixed-7", "Enter Enter"),
            ("class", "Enter Enter"),
            ("table&seed=3", "Enter c Enter Enter"),
            ("rules", "ArrowRight"),
            ("levels", "Enter"),
            ("level=dead-stop", "h Enter Enter"),
            ("foil", "ArrowDown Tab Enter"),
            ("foil", "ArrowDown Tab Tab"),
            ("progress", "ArrowDown Tab Tab Tab Tab"),
        ] {
            phone.go_to(&page, screen);
            phone.assert_fits();
            phone.assert_legible();
            for key in keys.split(' ') {
                press(&mut phone.0, &[key]);
                phone.wait();
                phone.assert_fits();
                phone.assert_legible();
            }
        }
    }
}

/// In a whole mixed round, every form of question is answered by tapping, dragging and typing.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_mixed_round_is_played_by_touch_alone() {
    let page = page();
    let mut phone = Phone::open(&page, "quiz=mixed-7&player=Ana");
    for question in 1..=10 {
        phone.expect(&format!("question {question} of 10"));
        phone.assert_fits();
        answer(&mut phone);
        // Chooses the confidence, then goes to the next question.
        phone.expect("How sure");
        assert!(phone.choose("think so"));
        let next = match question {
            10 => "your round".to_owned(),
            _ => format!("question {} of 10", question + 1),
        };
        phone.until(&next, Phone::go_on);
    }
}

/// Gives some answer to the question on the screen: rays are dragged if possible, and fields that
/// are still empty are filled in.
pub(crate) fn answer(phone: &mut Phone) {
    let has_choices = phone.choose("A ");
    for step in 0..6 {
        if phone.shows("How sure") {
            return;
        }
        let has_picture = "return !!document.querySelector('#screen canvas')";
        if !has_choices && step == 0 && phone.0.run(has_picture, &[]) == json!(true) {
            phone.drag([0.45, 0.5], [0.8, 0.2]);
        }
        let is_open =
            "return [...document.querySelectorAll('.field input')].some((it) => !it.value)";
        if phone.0.run(is_open, &[]) == json!(true) {
            phone.type_in("4");
        }
        phone.go_on();
    }
}

/// A chapter: its pages are turned with a button, and its figure is dragged.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_chapter_is_read_by_touch_alone() {
    let page = page();
    let mut phone = Phone::open(&page, "lesson=4");
    for _ in 0..3 {
        for label in ["next page", "skip", "next"] {
            if phone.button(label) {
                break;
            }
        }
    }
    phone.expect("Two curves");
    let script = "
        const canvas = document.querySelector('#screen canvas');
        return canvas.toDataURL();";
    let before = phone.0.run(script, &[]);
    phone.drag([0.6, 0.3], [0.4, 0.3]);
    assert_ne!(
        phone.0.run(script, &[]),
        before,
        "the finger must move the point"
    );
}

/// The shot of a level is aimed with the finger, predicted and watched to its end.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_level_is_played_by_touch_alone() {
    let page = page();
    let mut phone = Phone::open(&page, "levels");
    phone.choose("Dead stop");
    phone.until("Predict both paths", Phone::go_on);
    assert!(phone.shows("45.0"));
    // Aims slightly to one side of the coin's centre, so that the hit is not head-on.
    phone.drag([0.5, 0.6], [0.65, 0.395]);
    assert!(!phone.shows("45.0"), "the finger aims");
    phone.press("predict both paths");
    phone.assert_fits();
    phone.expect("predict it");
    phone.type_in("45");
    phone.go_on();
    phone.until("Not yet", Phone::go_on);
    phone.expect("you said");
    phone.assert_fits();
    phone.press("try again from the same aim");
    phone.expect("shot 1:");
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_hint_on_a_small_phone_is_scrolled_into_view_with_its_next_step() {
    let page = page();
    let mut phone = Phone::sized((390, 664), &page, "table&seed=3");
    phone.press("play");
    phone.expect("You break");
    for (step, next) in [
        ("hint", "Tell me more"),
        ("tell me more", "Set this stroke"),
    ] {
        phone.press(step);
        phone.expect(next);
        let script = "
            const all = [...document.querySelectorAll('#screen .prompt')];
            const next = all.find((it) => it.textContent === arguments[0]).getBoundingClientRect();
            return next.bottom <= document.getElementById('screen').getBoundingClientRect().bottom;";
        let is_seen = phone.0.run(script, &[Value::from(next)]);
        assert_eq!(is_seen, true, "{next}");
    }
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_finger_scrolls_the_row_of_keys_without_pressing_one() {
    let page = page();
    let mut phone = Phone::sized((390, 664), &page, "table&seed=3");
    phone.press("play");
    phone.expect("You break");
    let script =
        "return [...over.querySelectorAll('#keys button')].find((it) => text(it).startsWith('▶'))";
    let [x, y] = phone.middle(script, "").expect("the arrow");
    let left = phone.0.run(
        "return document.querySelector('#keys .row').scrollLeft",
        &[],
    );
    phone.touch("touchStart", &[[x, y]]);
    for step in 1..=8 {
        phone.touch("touchMove", &[[x - 20.0 * f64::from(step), y]]);
    }
    phone.wait();
    phone.touch("touchEnd", &[]);
    phone.wait();
    let now = phone.0.run(
        "return document.querySelector('#keys .row').scrollLeft",
        &[],
    );
    assert_ne!(now, left, "the row scrolls");
    assert_eq!(phone.fact("aim"), "90.0°");
    let at = phone.middle(script, "").expect("the arrow");
    phone.tap(at);
    assert_eq!(phone.fact("aim"), "89.0°", "a tap is one step");
}

/// A board of carrom against the computer, from the break to the last coin: the first stroke is
/// aimed with the finger, the others follow the hints.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_board_of_carrom_is_played_by_touch_alone() {
    let page = page();
    let mut phone = Phone::open(&page, "table&seed=3");
    phone.press("play");
    phone.expect("You break");
    let before = phone.fact("aim");
    phone.drag([0.5, 0.6], [0.4, 0.3]);
    assert_ne!(phone.fact("aim"), before, "the finger aims");
    phone.assert_fits();
    phone.press("strike");
    let mut strokes = 0;
    phone.until("the end of the board", |phone| {
        if !phone.button("h") {
            return phone.go_on();
        }
        strokes += 1;
        assert!(strokes < 100, "the board does not end");
        // The hints show the target, then the direction, then the exact stroke, which is then set.
        phone.until("Set this stroke", |phone| phone.button("h"));
        phone.press("set this stroke");
        phone.press("strike")
    });
    println!("a board of {strokes} strokes by touch");
    phone.assert_fits();
}

/// A finger that scrolls may begin on a button that changes a setting, or on a picture.
#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn a_finger_that_scrolls_changes_nothing() {
    let page = page();
    let mut phone = Phone::sized((390, 664), &page, "lab");
    let values = "return [...document.querySelectorAll('.field input')].map((it) => it.value)";
    let before = phone.0.run(values, &[]);
    let less = "return [...over.querySelectorAll('.field.number button')][4]";
    let at = phone.middle(less, "").expect("a button");
    assert!(phone.scroll_from(at) > 50.0);
    assert_eq!(phone.0.run(values, &[]), before);
    let at = phone.middle(less, "").expect("a button");
    phone.tap(at);
    assert_ne!(phone.0.run(values, &[]), before);

    phone.go_to(&page, "lesson=13:1");
    phone.choose("Neither");
    phone.until("Contact: 0.300 ms", Phone::go_on);
    let at = phone.place([0.5, 0.7]);
    assert!(phone.scroll_from(at) > 50.0);
    phone.expect("Contact: 0.300 ms");
    phone.drag([0.3, 0.5], [0.7, 0.5]);
    assert!(!phone.shows("Contact: 0.300 ms"));
}

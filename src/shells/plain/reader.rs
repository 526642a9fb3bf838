//! The app in plain lines: it reads a line and writes the changes.

use std::collections::VecDeque;
use std::time::Duration;

use ratatui::Terminal;
use ratatui::backend::TestBackend;

use super::number::number;
use super::page::{Asked, ON, OPEN, OptionKind, PlainOption, PlainPage, read, unit};
use super::spoken::sentence;
use crate::app::App;
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::numbers::capital;
use crate::shells::{AppHolder, FRAME};
use crate::widgets::input::KeyRow;
use crate::widgets::{PictureSizes, SheetKind, recorded};

/// The columns and rows of the invisible screen, which is large enough for everything.
const SIZE: (u16, u16) = (160, 200);

/// The sizes of the pictures on this screen.
const PICTURES: PictureSizes = PictureSizes {
    any: [40, 20],
    square: [40, 20],
};

/// The longest input line, in characters.
const LONGEST: usize = 1000;

/// The longest motion that is played at once.
const LONGEST_MOTION: Duration = Duration::from_secs(300);

/// The number of time steps between two checks of a moving screen.
const LISTENED: u32 = 12;

/// The number of recent lines that are remembered.
const RECENT: usize = 60;
/// The minimum length of a line that is not repeated while it is remembered.
const LONG: usize = 60;

/// The maximum number of steps from one value of a field to another.
const MOST_STEPS: usize = 60;

/// The range of numbers that can be typed in [`SIGNS`] characters.
const LEAST: f64 = -99_999_999.0;
const MOST: f64 = 999_999_999.0;

/// The maximum length of a typed number in characters.
const SIGNS: usize = 9;

/// The key for a disc that stays still.
const STILL: Key = Key::Char('x');

/// The help on the words that are understood on every screen.
const HELP: [&str; 3] = [
    "To choose something, type its label or its name. Enter alone continues.",
    "To set a value, type its name: speed = 3. Or choose it and type more or less.",
    "At any time: repeat reads the page again, glossary explains the terms of mechanics, rules \
     explains the game at the table, back goes back, quit saves your answers and ends carrom.",
];

/// The status in the title line when something could not be saved.
const NOT_SAVED: &str = "not saved";

/// The immediate reply to a line, or a line that explains what was expected.
type LineAnswer = Result<Vec<String>, String>;

/// Whether the current keys include an action with this id.
fn has_row(app: &App, id: &str) -> bool {
    app.keys().rows().iter().any(|row| row.id == id)
}

fn press(keys: impl IntoIterator<Item = Key>, holder: &mut dyn AppHolder) -> LineAnswer {
    keys.into_iter().for_each(|key| holder.input(&key.into()));
    Ok(Vec::new())
}

/// Whether Enter carries out one of these actions.
fn enters(holder: &mut dyn AppHolder, ids: &[&str]) -> bool {
    let table = holder.app().keys();
    let mut rows = table.rows().iter();
    rows.any(|row| ids.contains(&row.id.as_str()) && row.all_keys().any(|it| it == Key::Enter))
}

/// The app in plain lines.
pub struct PlainReader {
    screen: Terminal<TestBackend>,
    page: PlainPage,
    /// The lines written since the last input.
    said: Vec<String>,
    recent: VecDeque<String>,
}

impl PlainReader {
    /// Creates a reader for an app, with a screen that is large enough for everything.
    pub fn new(app: &mut App) -> Self {
        app.set_pictures(Some(PICTURES));
        app.settings_mut().charset = crate::widgets::Charset::Unicode;
        app.settings_mut().sees = false;
        let Ok(screen) = Terminal::new(TestBackend::new(SIZE.0, SIZE.1));
        Self {
            screen,
            page: PlainPage::default(),
            said: Vec::new(),
            recent: VecDeque::new(),
        }
    }

    /// The first lines of the output.
    pub fn begin(&mut self, holder: &mut dyn AppHolder) -> Vec<String> {
        holder.input(&Input::Resize(SIZE.0, SIZE.1));
        let mut lines =
            vec!["carrom in plain lines. Type help at any time, and quit to leave.".to_owned()];
        lines.extend(self.news(holder));
        lines
    }

    /// The changes that have happened by themselves since the last output.
    pub fn news(&mut self, holder: &mut dyn AppHolder) -> Vec<String> {
        let mut lines = self.settle(holder);
        if !lines.is_empty() {
            lines.push(self.page.question());
        }
        lines
    }

    /// The last output after the end of the input, if the only remaining step is to continue.
    pub fn end(&mut self, holder: &mut dyn AppHolder) -> Vec<String> {
        if !has_row(holder.app(), ON) {
            return Vec::new();
        }
        holder.input(&Key::Enter.into());
        self.settle(holder)
    }

    /// Handles an input line; returns the reply.
    pub fn hear(&mut self, line: &str, holder: &mut dyn AppHolder) -> Vec<String> {
        let visible = line.chars().filter(|c| !c.is_control()).take(LONGEST);
        let line = visible.collect::<String>().trim().to_owned();
        self.said.clear();
        let mut lines = self.take(&line, holder).unwrap_or_else(|it| vec![it]);
        lines.extend(self.settle(holder));
        lines.push(self.page.question());
        lines
    }

    fn take(&mut self, line: &str, holder: &mut dyn AppHolder) -> LineAnswer {
        let lower = line.to_lowercase();
        let is_text = self.is_text();
        if let Some(option) = self.labelled(line).filter(|_| !is_text) {
            return self.choose(&option, holder);
        }
        match lower.as_str() {
            // A single letter may be the text that was asked for, such as a name.
            "q" | "h" | "r" if is_text => {}
            "quit" | "exit" | "q" => return press([Key::Ctrl('c')], holder),
            "help" | "h" | "?" => return Ok(self.help(holder)),
            "glossary" | "rules" if !is_text && self.page.layer.is_none() => {
                let initial = lower.chars().next().map(Key::Char);
                return press([Key::Char('?')].into_iter().chain(initial), holder);
            }
            "repeat" | "r" => return Ok(changes(&PlainPage::default(), &self.page, &[])),
            "" | "shoot" => return press([Key::Enter], holder),
            _ => {}
        }
        if let Some((name, value)) = assignment(line)
            && !(is_text && self.field(name).is_none())
        {
            return self.set(name, value, holder);
        }
        if let Some(words) = lower.strip_prefix("choose ") {
            let option = self.labelled(words).or_else(|| self.named(words));
            let option = option.ok_or_else(|| self.expected())?;
            return self.choose(&option, holder);
        }
        if is_text {
            return self.type_text(line, holder);
        }
        // A single letter is not taken for the name of an option.
        if let Some(option) = self.named(&lower).filter(|_| lower.len() > 1) {
            return self.choose(&option, holder);
        }
        if let Some(key) = self.moved(&lower, holder.app()) {
            return press([key], holder);
        }
        match &self.page.asked {
            Asked::Number(..) | Asked::Angle(_) => self.type_number(line, holder),
            _ if has_row(holder.app(), ON) => {
                // The line already answers the next question.
                holder.input(&Key::Enter.into());
                let mut lines = self.settle(holder);
                lines.extend(self.take(line, holder)?);
                Ok(lines)
            }
            _ => Err(self.expected()),
        }
    }

    fn is_text(&self) -> bool {
        matches!(self.page.asked, Asked::Text(_))
    }

    /// The option with this label; an answer with a letter can also be chosen by its number.
    fn labelled(&self, label: &str) -> Option<PlainOption> {
        let label = label.trim_end_matches(['.', ':', ')']);
        let mut options = self.page.options.iter();
        let is = |it: &&PlainOption| !it.label.is_empty() && it.label.eq_ignore_ascii_case(label);
        let is_answer = |it: &&PlainOption| it.label.chars().any(char::is_uppercase);
        let numbered = || {
            let number: usize = label.parse().ok()?;
            let mut answers = self.page.options.iter().filter(is_answer);
            answers.nth(number.checked_sub(1)?)
        };
        options.find(is).or_else(numbered).cloned()
    }

    /// The option with this name, or the first whose name contains these words or longer forms of
    /// them.
    fn named(&self, words: &str) -> Option<PlainOption> {
        let meant: Vec<_> = words.split_whitespace().collect();
        let name_of = |it: &PlainOption| read(&it.words).to_lowercase();
        let options = || self.page.options.iter().map(|it| (it, name_of(it)));
        let all = |name: &str, is: fn(&str, &str) -> bool| {
            let words: Vec<_> = name.split([' ', ',', ':']).collect();
            let is_there = |meant: &&str| words.iter().any(|word| is(word, meant));
            meant.iter().all(is_there)
        };
        let begins = |word: &str, meant: &str| meant.len() > 2 && word.starts_with(meant);
        let whole = |name: &str| all(name, |word, meant| word == meant);
        let begun = |name: &str| all(name, begins);
        if !words.contains(char::is_alphabetic) {
            return None;
        }
        let exact = options().find(|(_, name)| name == words);
        let exact = exact.or_else(|| options().find(|(_, name)| whole(name)));
        let found = exact.or_else(|| options().find(|(_, name)| begun(name)));
        found.map(|(option, _)| option.clone())
    }

    /// The key for a step that is typed in words: "more", "much less", "strength more", "back",
    /// "next".
    fn moved(&self, words: &str, app: &App) -> Option<Key> {
        let table = app.keys();
        let (name, last) = words.rsplit_once(' ').unwrap_or(("", words));
        let is_more = match last {
            "more" => true,
            "less" => false,
            "back" if name.is_empty() => return table.keys().find(|it| *it == Key::Escape),
            "next" | "n" if name.is_empty() => {
                return table.keys().find(|it| *it == Key::Char('n'));
            }
            _ => return None,
        };
        let (name, nth) = match name.strip_prefix("much").map(str::trim) {
            Some(name) => (name, 1),
            None => (name, 0),
        };
        let rows = table.rows().iter().filter(|row| match name {
            "" => row.id.ends_with(".step") || row.id.ends_with(".dial") || row.id == "ray.turn",
            name => row.id.ends_with(&format!(".{name}")),
        });
        let is_big = |row: &&KeyRow<()>| row.id.ends_with(".big") && name.is_empty();
        let rows = rows.chain(table.rows().iter().filter(is_big));
        let less = ["Left", "Down", "-", ",", "<", "[", "{"].map(Key::parse);
        let is_meant = |key: &Key| less.contains(&Some(*key)) != is_more;
        rows.flat_map(KeyRow::keys).filter(is_meant).nth(nth)
    }

    /// The possible inputs in one line.
    fn expected(&self) -> String {
        let labels = self.page.options.iter().map(|it| it.label.as_str());
        let labels: Vec<_> = labels.filter(|it| !it.is_empty()).collect();
        match (&self.page.asked, &labels[..]) {
            (Asked::Angle(_), _) => "Please type an angle from minus 180 to 180, or still.".into(),
            (Asked::Number(..), _) => "Please type a number, such as 2.5.".into(),
            (_, []) => "Please press Enter to continue, or type help.".into(),
            (_, [one]) => format!("Please type {one}, or help."),
            (_, [first, .., last]) => {
                format!("Please type a label from {first} to {last}, the words after it, or help.")
            }
        }
    }

    fn choose(&mut self, option: &PlainOption, holder: &mut dyn AppHolder) -> LineAnswer {
        let opens = ["answer.enter", "list.open"];
        let is_entry = option.kind == OptionKind::Entry;
        // A click on a chosen entry would open it, and then Enter would open it again.
        let is_clicked = !(is_entry && option.is_chosen && enters(holder, &opens));
        match (option.key, option.cell) {
            (Some(key), _) => holder.input(&key.into()),
            (None, Some(cell)) if is_clicked => {
                for kind in [MouseKind::Down, MouseKind::Up] {
                    holder.input(&Input::Mouse(Mouse::over(kind, cell)));
                }
            }
            (None, _) => {}
        }
        if option.key == Some(STILL) && matches!(self.page.asked, Asked::Angle(_)) {
            self.enter(holder, &["ray.next"]);
        }
        // A click may have chosen the entry without opening it.
        let is_same = |it: &PlainOption| it.words == option.words && it.is_chosen;
        if is_entry && self.look(holder.app()).options.iter().any(is_same) {
            self.enter(holder, &opens);
        }
        let line = option.is_field().then(|| option.line());
        Ok(line.into_iter().collect())
    }

    /// Presses Enter if Enter carries out one of these actions and the screen is still the same.
    fn enter(&mut self, holder: &mut dyn AppHolder, ids: &[&str]) {
        if enters(holder, ids) && self.is_the_same(holder) {
            holder.input(&Key::Enter.into());
        }
    }

    /// Whether the app still shows the screen of `page`.
    fn is_the_same(&mut self, holder: &mut dyn AppHolder) -> bool {
        let now = self.look(holder.app());
        now.title == self.page.title && now.layer == self.page.layer
    }

    /// Types and enters a number.
    fn type_number(&mut self, line: &str, holder: &mut dyn AppHolder) -> LineAnswer {
        if matches!(self.page.asked, Asked::Angle(_)) && line.eq_ignore_ascii_case("still") {
            holder.input(&STILL.into());
            self.enter(holder, &["ray.next"]);
            return Ok(Vec::new());
        }
        let value = match &self.page.asked {
            Asked::Angle(_) => number(line, "°", -180.0, 180.0).map_err(|_| self.expected())?,
            Asked::Number(_, unit) => number(line, unit, LEAST, MOST)?,
            _ => return Err(self.expected()),
        };
        let digits = digits(value);
        press(digits.chars().map(Key::Char).chain([Key::Enter]), holder)?;
        self.enter(holder, &["dial.enter", "answer.enter"]);
        Ok(Vec::new())
    }

    /// Replaces the text and presses Enter.
    fn type_text(&mut self, line: &str, holder: &mut dyn AppHolder) -> LineAnswer {
        let before = self.page.options.iter().find_map(|it| match &it.kind {
            OptionKind::Text(before) if it.is_chosen => Some(before),
            _ => None,
        });
        if let Some(before) = before {
            let erase = before.chars().map(|_| Key::Backspace);
            press([Key::End].into_iter().chain(erase), holder)?;
        }
        press(line.chars().map(Key::Char).chain([Key::Enter]), holder)
    }

    fn field(&self, name: &str) -> Option<PlainOption> {
        let named = self.named(&name.to_lowercase());
        named.filter(PlainOption::is_field)
    }

    /// Sets the field with this name.
    fn set(&mut self, name: &str, value: &str, holder: &mut dyn AppHolder) -> LineAnswer {
        let Some(option) = self.field(name) else {
            let fields = self.page.options.iter().filter(|it| it.is_field());
            let names: Vec<_> = fields.map(|it| read(&it.words)).collect();
            return Err(match names.is_empty() {
                true => "Nothing can be set here.".into(),
                false => format!("Please name one of these: {}.", names.join(", ")),
            });
        };
        if !option.is_chosen {
            self.choose(&option, holder)?;
        }
        match &option.kind {
            OptionKind::Text(_) => self.type_text(value, holder),
            OptionKind::Field(shown) if is_number(shown) => {
                self.page.asked = Asked::Number(option.words, unit(shown));
                self.type_number(value, holder)
            }
            _ => self.step_to(&option, value, holder),
        }
    }

    /// Steps through the values of a field until it has the given value.
    fn step_to(
        &mut self,
        option: &PlainOption,
        value: &str,
        holder: &mut dyn AppHolder,
    ) -> LineAnswer {
        let value = value.to_lowercase();
        let mut seen = Vec::new();
        for key in [Key::Right, Key::Left] {
            let mut last = None;
            for _ in 0..MOST_STEPS {
                let page = self.look(holder.app());
                let mut fields = page.options.iter().filter(|it| it.words == option.words);
                let Some(OptionKind::Field(now)) = fields.next().map(|it| &it.kind) else {
                    return Err(self.expected());
                };
                let now = read(now);
                if now.to_lowercase().starts_with(&value) {
                    return Ok(Vec::new());
                }
                // The last value has been reached, or the values have begun to repeat.
                if last.as_ref() == Some(&now) || key == Key::Right && seen.contains(&now) {
                    break;
                }
                seen.push(now.clone());
                last = Some(now);
                holder.input(&key.into());
            }
        }
        seen.sort();
        seen.dedup();
        Err(format!(
            "{} can be: {}.",
            read(&option.words),
            seen.join("; ")
        ))
    }

    /// Describes the possible inputs and the purpose of the screen.
    fn help(&mut self, holder: &mut dyn AppHolder) -> Vec<String> {
        let mut lines = Vec::new();
        if self.page.layer.is_none() && !self.is_text() {
            holder.input(&Key::Char('?').into());
            let page = self.look(holder.app());
            if page.layer == Some(SheetKind::Help) {
                lines.extend(page.lines().cloned());
                holder.input(&Key::Escape.into());
            }
        }
        lines.extend(HELP.map(str::to_owned));
        lines.extend(self.page.deeds());
        lines
    }

    /// Skips animations and closes notices. Returns the lines that appeared meanwhile and the new
    /// page.
    fn settle(&mut self, holder: &mut dyn AppHolder) -> Vec<String> {
        // A collision is described at its end, after the explanation at the contact.
        for _ in 0..2 {
            if holder.app().motion().is_some() && has_row(holder.app(), "hit.end") {
                holder.input(&Key::End.into());
                holder.input(&Key::End.into());
            }
        }
        let mut lines = self.say(holder);
        let mut left = LONGEST_MOTION;
        let mut steps = 0;
        while let Some(wake) = holder.app().motion().filter(|_| !left.is_zero()) {
            let step = wake.max(FRAME).min(left);
            holder.pass(step);
            left -= step;
            steps += 1;
            if steps % LISTENED == 0 {
                lines.extend(self.say_moving(holder));
            }
        }
        if steps > 0 {
            lines.extend(self.say(holder));
        }
        if self.page.layer == Some(SheetKind::Notice) {
            holder.input(&Key::Escape.into());
            lines.extend(self.settle(holder));
        }
        lines
    }

    /// Returns the changes since the last output, and records them as written.
    fn say(&mut self, holder: &mut dyn AppHolder) -> Vec<String> {
        let page = self.look(holder.app());
        let mut lines = changes(&self.page, &page, &self.said);
        if self.page.title == page.title {
            lines.retain(|line| line.len() < LONG || !self.recent.contains(line));
        }
        self.page = page;
        self.note(&lines);
        lines
    }

    fn note(&mut self, lines: &[String]) {
        self.said.extend(lines.iter().cloned());
        self.recent.extend(lines.iter().cloned());
        let old = self.recent.len().saturating_sub(RECENT);
        self.recent.drain(..old);
    }

    /// The changes while something moves or time passes; numbers that keep changing, such as those
    /// of a countdown, are not reported.
    pub fn say_moving(&mut self, holder: &mut dyn AppHolder) -> Vec<String> {
        let mut page = self.look(holder.app());
        let known = self.said.iter().chain(self.page.lines());
        let known: Vec<_> = known.map(|it| without_figures(it)).collect();
        let mut lines = changes(&self.page, &page, &self.said);
        let deeds = page.deeds();
        let is_passing = |line: &String| deeds.contains(line) || page.shown.contains(line);
        lines.retain(|line| !known.contains(&without_figures(line)) && !is_passing(line));
        if !lines.is_empty() {
            // Actions are listed only when nothing moves.
            page.options.clone_from(&self.page.options);
            self.page = page;
            self.note(&lines);
        }
        lines
    }

    fn look(&mut self, app: &App) -> PlainPage {
        self.screen.current_buffer_mut().reset();
        let ((), sheets) = recorded(|| app.draw(&mut self.screen.get_frame()));
        PlainPage::new(app, &sheets)
    }
}

/// The changes since the previous page; on the same screen, lines that were recently written
/// (`said`) are not repeated.
fn changes(before: &PlainPage, now: &PlainPage, said: &[String]) -> Vec<String> {
    let mut lines = Vec::new();
    let is_new = before.title != now.title || before.layer != now.layer;
    if is_new {
        lines.push(capital(&sentence(&now.title)));
    }
    let mut status = now.status.clone();
    status.retain(|part| is_new || !before.status.contains(part));
    if !status.is_empty() {
        lines.push(format!("{}.", capital(&status.join(", "))));
    }
    let is_unsaved = |page: &PlainPage| page.status.iter().any(|it| it.starts_with(NOT_SAVED));
    if is_unsaved(before) && !is_unsaved(now) {
        lines.push("Everything is saved now.".into());
    }
    let known: Vec<_> = before.lines().collect();
    for section in &now.sections {
        let same = before.sections.iter().find(|it| it.title == section.title);
        let is_fresh = is_new || same.is_none_or(|same| same.subject != section.subject);
        let is_titled =
            !section.title.is_empty() && !section.title.contains(|c: char| c.is_ascii_digit());
        if is_titled && (is_new || same.is_none()) {
            lines.push(capital(&sentence(&section.title)));
        }
        for line in &section.lines {
            let is_known = known.contains(&line) || said.contains(line);
            // The same line may be an answer to another question.
            let is_entry = now.has_entry(line);
            let was_entry = before.has_entry(line);
            if !is_known || is_new || is_fresh && is_entry || was_entry && !is_entry {
                lines.push(line.clone());
            }
        }
    }
    let deeds_before = before.deeds();
    let mut deeds = now.deeds();
    deeds.retain(|it| is_new || !deeds_before.contains(it));
    lines.extend(deeds);
    lines
}

/// The line, but with one `#` in place of each run of digits.
fn without_figures(line: &str) -> String {
    let mut text = line.replace(|c: char| c.is_ascii_digit(), "#");
    while text.contains("##") {
        text = text.replace("##", "#");
    }
    text
}

/// A name and its new value: "speed = 3", "set speed 3".
fn assignment(line: &str) -> Option<(&str, &str)> {
    let set = line
        .strip_prefix("set ")
        .and_then(|it| it.trim().split_once(' '));
    let (name, value) = set.or_else(|| line.split_once('='))?;
    Some((name.trim(), value.trim()))
}

/// Whether the value of a field is a number, or will be once it is typed.
fn is_number(shown: &str) -> bool {
    shown.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '−' | OPEN))
}

/// A number in the form in which it is typed, in at most [`SIGNS`] characters.
fn digits(value: f64) -> String {
    let places = (0..=6).rev().map(|places| format!("{value:.places$}"));
    let mut exact = std::iter::once(format!("{value}")).chain(places);
    exact
        .find(|text| text.len() <= SIGNS)
        .unwrap_or_else(|| "0".into())
}

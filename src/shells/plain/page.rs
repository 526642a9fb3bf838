//! A screen in lines, and its possible inputs. Both are made from the blocks that are recorded
//! while the screen is being drawn.

use super::by_words::{KEY, by_words};
use super::formula::aloud;
use super::spoken::{spoken, unit_name, verbatim};
use crate::app::App;
use crate::files::one_line;
use crate::messages::Key;
use crate::numbers::capital;
use crate::widgets::flow::Run;
use crate::widgets::input::KeyRow;
use crate::widgets::{Item, Role, Section, Sheet, SheetKind, Words};

/// The parts of the key table that plain lines replace, or that only sighted users need.
const BY_OTHER_MEANS: [&str; 9] = [
    "list.", "form.", "number.", "dial.", "answer.", "ray.", "hit.", "shot.", "mystery.",
];

/// The rows in those parts that are offered nevertheless.
const OFFERED: [&str; 2] = ["ray.stays-still", "shot.impacts"];

/// The id of the row of the key for the next question.
pub(super) const ON: &str = "quiz.go-on";

/// The mark after the digits typed so far in a number field.
pub(super) const OPEN: char = '_';

/// A screen, or a layer over it, in lines.
#[derive(Debug, Default, PartialEq)]
pub(super) struct PlainPage {
    /// Its title.
    pub title: String,
    /// The layer over the screen, if there is one.
    pub layer: Option<SheetKind>,
    /// The parts of its status, such as the score.
    pub status: Vec<String>,
    /// Its sections in reading order.
    pub sections: Vec<PlainSection>,
    /// Its options.
    pub options: Vec<PlainOption>,
    /// How an input line is read.
    pub asked: Asked,
    /// Descriptions of its pictures.
    pub shown: Vec<String>,
}

/// The contents of one frame.
#[derive(Debug, Default, PartialEq)]
pub(super) struct PlainSection {
    /// The title of the frame.
    pub title: String,
    /// The first text in the frame, which identifies the frame's subject.
    pub subject: String,
    /// Its text.
    pub lines: Vec<String>,
}

/// An option of a screen.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PlainOption {
    /// The label that chooses it; empty if only its name does.
    pub label: String,
    /// Its name.
    pub words: String,
    /// Its kind.
    pub kind: OptionKind,
    /// The cell to click in order to choose it.
    pub cell: Option<(u16, u16)>,
    /// The key that chooses it.
    pub key: Option<Key>,
    /// Whether the option is currently chosen.
    pub(crate) is_chosen: bool,
}

/// The kind of an option.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum OptionKind {
    /// An answer, or an entry of a list.
    Entry,
    /// A value that can be set, as shown on the screen.
    Field(String),
    /// A text field with its current text.
    Text(String),
    /// An action.
    Deed,
}

/// What carrom expects in an input line that is not a choice.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) enum Asked {
    #[default]
    Nothing,
    /// A number with this name and unit.
    Number(String, String),
    /// An angle with this name, or the word "still".
    Angle(String),
    /// Text with this name.
    Text(String),
}

impl PlainPage {
    /// The page of an app, from the recorded sheets.
    pub(super) fn new(app: &App, sheets: &[Sheet]) -> Self {
        let Some(sheet) = sheets.last() else {
            return Self::default();
        };
        let table = app.keys();
        let rows = table.rows();
        let types = rows.iter().any(|row| row.id.ends_with(".type"));
        let mut page = Self {
            title: read(&sheet.title),
            layer: (sheet.kind != SheetKind::Screen).then_some(sheet.kind),
            status: parts(&sheet.status),
            asked: asked(sheet, types, rows),
            ..Self::default()
        };
        let items = || sheet.sections.iter().flat_map(|section| &section.items);
        let options = items().filter_map(|item| PlainOption::of(item, rows));
        let mut options: Vec<_> = options.collect();
        unlabel_articles(&mut options);
        let taken: Vec<_> = options.iter().filter_map(|it| it.key).collect();
        options.extend(rows.iter().filter_map(|row| deed(row, &taken)));
        let mut names: Vec<String> = Vec::new();
        options.retain(|option| {
            let is_new = option.kind != OptionKind::Deed || !names.contains(&option.words);
            names.push(option.words.clone());
            is_new
        });
        // Where Enter continues to the next question, the next line typed may already answer that
        // question. That line could be taken for a label, so nothing gets a label.
        if !rows.iter().any(|row| row.id == ON) {
            let has_values = options.iter().any(PlainOption::has_value);
            label(&mut options, types || has_values);
        }
        page.sections = sections(sheet, &options, rows);
        page.options = options;
        page.shown = items().flat_map(|item| shown(&item.words)).collect();
        page
    }

    /// All lines of its sections, without the title.
    pub(super) fn lines(&self) -> impl Iterator<Item = &String> {
        self.sections.iter().flat_map(|it| &it.lines)
    }

    /// Whether a line is an entry that can be chosen.
    pub(super) fn has_entry(&self, line: &str) -> bool {
        let is_it = |it: &PlainOption| it.kind == OptionKind::Entry && it.line() == line;
        self.options.iter().any(is_it)
    }

    /// The actions, one per line.
    pub(super) fn deeds(&self) -> Vec<String> {
        let deeds = self.options.iter().filter(|it| it.kind == OptionKind::Deed);
        deeds.map(PlainOption::line).collect()
    }

    /// The question at the end of the page.
    pub(super) fn question(&self) -> String {
        let is_entry = |it: &PlainOption| it.kind == OptionKind::Entry;
        let has_choice =
            self.options.iter().any(is_entry) && !self.options.iter().any(PlainOption::has_value);
        let asked = match &self.asked {
            Asked::Nothing if has_choice => "Which one?".into(),
            Asked::Nothing => "What next?".into(),
            Asked::Number(name, unit) if !unit.is_empty() => {
                format!("{name} in {}?", unit_name(unit))
            }
            Asked::Angle(name) => format!("{name}, in degrees?"),
            Asked::Number(name, _) | Asked::Text(name) => format!("{name}?"),
        };
        capital(&read(&asked))
    }
}

impl PlainOption {
    /// The option that an item offers; `None` if it cannot be chosen.
    fn of(item: &Item, rows: &[KeyRow<()>]) -> Option<Self> {
        let entry = |words| (words, OptionKind::Entry, None);
        let (words, kind, key) = match &item.words {
            Words::Prompt { words, key } => {
                let key = key.as_deref().and_then(Key::parse);
                let mut rows = rows.iter();
                let row = rows.find(|row| row.all_keys().any(|it| Some(it) == key));
                if row.is_some_and(is_by_other_means) {
                    return None;
                }
                (words.clone(), OptionKind::Deed, key)
            }
            Words::Field { name, value, .. } => {
                (field_name(name), OptionKind::Field(value.clone()), None)
            }
            Words::TextField { name, value } => {
                (name.clone(), OptionKind::Text(value.clone()), None)
            }
            Words::Text { mark, runs } => entry(format!("{mark} {}", joined(runs))),
            words => entry(same_text(words)?),
        };
        let is_deed = kind == OptionKind::Deed;
        if item.press.is_none() && !(is_deed && key.is_some()) {
            return None;
        }
        let (label, words) = match kind {
            OptionKind::Entry => own_label(words.trim()),
            _ => (String::new(), words),
        };
        let key = key.or_else(|| own_key(&label, rows));
        Some(Self {
            words: one_line(&words),
            label,
            kind,
            cell: item.press.map(|[column, row]| (column, row)),
            key,
            is_chosen: item.chosen == Some(true),
        })
    }

    /// Whether the option has a value or a text that can be set.
    pub(super) fn is_field(&self) -> bool {
        self.has_value() || matches!(self.kind, OptionKind::Text(_))
    }

    fn has_value(&self) -> bool {
        matches!(self.kind, OptionKind::Field(_))
    }

    /// The line that describes it.
    pub(super) fn line(&self) -> String {
        let words = match &self.kind {
            OptionKind::Field(value) => format!("{}: {}", self.words, value_words(value)),
            OptionKind::Text(value) if value.is_empty() => format!("{}: empty", self.words),
            OptionKind::Text(value) => format!("{}: {value}", self.words),
            OptionKind::Entry | OptionKind::Deed => self.words.clone(),
        };
        match self.label.as_str() {
            "" => read(&words),
            label => format!("{label}: {}", read(&words)),
        }
    }
}

/// An action that has a key but no item on the screen.
fn deed(row: &KeyRow<()>, taken: &[Key]) -> Option<PlainOption> {
    let mut keys = row.keys();
    let (Some(key), None) = (keys.next(), keys.next()) else {
        return None;
    };
    let is_offered = !is_by_other_means(row) && !row.name.is_empty();
    (is_offered && !taken.contains(&key)).then(|| PlainOption {
        label: String::new(),
        words: row.name.to_owned(),
        kind: OptionKind::Deed,
        cell: None,
        key: Some(key),
        is_chosen: false,
    })
}

/// Whether a typed line replaces the key, or only sighted users need it.
fn is_by_other_means(row: &KeyRow<()>) -> bool {
    let is = BY_OTHER_MEANS.iter().any(|part| row.id.starts_with(part))
        || row.id.ends_with(".export")
        || row.id.ends_with("scroll");
    is && !OFFERED.contains(&row.id.as_str())
}

/// Labels for items without a label: numbers, or letters if numbers can be typed. If the answers
/// have letters, or the choices are numbered confidence levels, the actions get no labels.
fn label(options: &mut [PlainOption], types: bool) {
    let own: Vec<_> = options.iter().map(|it| it.label.clone()).collect();
    let numbers = own.iter().filter_map(|it| it.parse::<usize>().ok());
    let last = numbers.max().unwrap_or(0);
    let is_letter = |label: &String| label.chars().any(char::is_alphabetic);
    if own.iter().any(is_letter) || (1..=3).contains(&last) {
        return;
    }
    let mut names: Box<dyn Iterator<Item = String>> = match types {
        true => Box::new(('a'..='z').map(String::from)),
        false => Box::new((last + 1..).map(|number| number.to_string())),
    };
    for option in options.iter_mut().filter(|it| it.label.is_empty()) {
        option.label = names.next().unwrap_or_default();
    }
}

/// The letter or number at the start of an entry, and the rest.
fn own_label(words: &str) -> (String, String) {
    let split = words.split_once(' ').unwrap_or((words, ""));
    let number = split.0.trim_end_matches('.');
    let is_number = !number.is_empty() && number.chars().all(|c| c.is_ascii_digit());
    let first = number.trim_end_matches(':');
    let rest = split.1.trim_start();
    let is_letter = first.len() == 1 && first.chars().all(|c| c.is_ascii_uppercase());
    match is_number || is_letter && !rest.is_empty() {
        true => (first.to_owned(), rest.to_owned()),
        false => (String::new(), words.to_owned()),
    }
}

/// Restores the first word of entries that begin with the article "A" and therefore look as if they
/// had the letter of a choice. In real choices, at least A and B occur.
fn unlabel_articles(options: &mut [PlainOption]) {
    if options.iter().any(|it| it.label == "B") {
        return;
    }
    for option in options.iter_mut().filter(|it| it.label == "A") {
        option.words = format!("{} {}", std::mem::take(&mut option.label), option.words);
        option.key = None;
    }
}

/// The key that immediately chooses the entry with this label.
fn own_key(label: &str, rows: &[KeyRow<()>]) -> Option<Key> {
    let letter: char = label.parse().ok()?;
    let key = Key::Char(letter.to_ascii_lowercase());
    let chooses = |row: &&KeyRow<()>| row.id.ends_with(".choose") || row.id.ends_with(".sure");
    let mut rows = rows.iter().filter(chooses);
    rows.any(|row| row.all_keys().any(|it| it == key))
        .then_some(key)
}

/// How an input line is read.
fn asked(sheet: &Sheet, types: bool, rows: &[KeyRow<()>]) -> Asked {
    let items = sheet.sections.iter().flat_map(|section| &section.items);
    let chosen = items.filter(|item| item.chosen == Some(true));
    for item in chosen {
        match &item.words {
            Words::TextField { name, .. } => return Asked::Text(name.clone()),
            Words::Field { name, value, .. } if types => {
                let name = field_name(name);
                return match rows.iter().any(|row| row.id == "ray.turn") {
                    true => Asked::Angle(name),
                    false => Asked::Number(name, unit(value)),
                };
            }
            _ => {}
        }
    }
    match types {
        true => Asked::Number("A number or an action".into(), String::new()),
        false => Asked::Nothing,
    }
}

/// The unit of a value: the word after its number, or both words of "g m/s".
pub(super) fn unit(value: &str) -> String {
    let number = |c: char| c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '−' | OPEN);
    let behind = value.trim_start_matches(number).trim_start();
    let is_number = behind.len() < value.len();
    let mut words = behind.split(' ');
    match (words.next().unwrap_or_default(), words.next()) {
        _ if !is_number => String::new(),
        (first @ ("g" | "kg"), Some("m/s")) => format!("{first} m/s"),
        (first, _) => first.to_owned(),
    }
}

fn value_words(value: &str) -> String {
    match value.split_once(OPEN) {
        Some(("", _)) => "not set yet".into(),
        Some((typed, unit)) => format!("{typed}{unit}"),
        None => value.to_owned(),
    }
}

/// The lines of each section.
fn sections(sheet: &Sheet, options: &[PlainOption], rows: &[KeyRow<()>]) -> Vec<PlainSection> {
    let mut left = options.iter().filter(|it| it.kind != OptionKind::Deed);
    let section = |section: &Section| {
        // The header row of the current table.
        let mut heads = None;
        let mut lines = Vec::new();
        let mut subject = None;
        for item in &section.items {
            let is_option =
                PlainOption::of(item, rows).is_some_and(|it| it.kind != OptionKind::Deed);
            let option = if is_option { left.next() } else { None };
            let columns = match &item.words {
                Words::Columns { name, values } => Some((name, values.as_slice())),
                _ => None,
            };
            let is_dim = |(_, values): &NamedRow| values.iter().all(|it| it.role == Role::Dim);
            let new_heads =
                columns.filter(|it| heads.is_none() && item.press.is_none() && is_dim(it));
            let line = match (columns, option) {
                _ if new_heads.is_some() || matches!(item.words, Words::Prompt { .. }) => None,
                (Some(columns), option) => Some(row(heads, columns, option)),
                (None, Some(option)) => Some(option.line()),
                (None, None) => text(&item.words, sheet.kind == SheetKind::Help),
            };
            heads = columns.and(heads.or(new_heads));
            let Some(line) = line.filter(|line| !line.is_empty()) else {
                continue;
            };
            if matches!(item.words, Words::Text { .. }) && !is_option {
                subject.get_or_insert_with(|| line.clone());
            }
            lines.extend(line.lines().map(str::to_owned));
        }
        PlainSection {
            title: title(&section.title),
            subject: subject.unwrap_or_default(),
            lines,
        }
    };
    sheet.sections.iter().map(section).collect()
}

/// A row of a table: its name and its values.
type NamedRow<'i> = (&'i Run, &'i [Run]);

/// A row of a table, with each value after the heading of its column.
fn row(heads: Option<NamedRow>, (name, values): NamedRow, option: Option<&PlainOption>) -> String {
    let (head_name, heads) =
        heads.map_or(("", [].as_slice()), |(name, heads)| (&*name.text, heads));
    let values = values.iter().enumerate().map(|(at, value)| {
        let head = heads.get(at).map_or("", |head| head.text.trim());
        format!("{head} {}", value.text.trim())
    });
    let values: Vec<_> = values.collect();
    let (label, name) = match option {
        Some(option) => (format!("{}: ", option.label), own_label(name.text.trim()).1),
        None => (String::new(), name.text.trim().to_owned()),
    };
    let mut name = vec![name.as_str(), head_name.trim()];
    name.retain(|it| !it.is_empty());
    let row = listed(&name.join(", "), values.iter().map(String::as_str));
    format!("{label}{}", read(&row))
}

/// The name of a field.
fn field_name(name: &str) -> String {
    name.trim_end_matches('=').trim().to_owned()
}

/// The text of an item if it is the same whether the item can be chosen or not.
fn same_text(words: &Words) -> Option<String> {
    Some(match words {
        Words::Tab { name } => name.clone(),
        Words::Large { runs } => joined(runs),
        Words::Pair { name, value } => listed(&name.text, [&*value.text]),
        Words::Columns { name, values } => listed(&name.text, values.iter().map(|it| &*it.text)),
        _ => return None,
    })
}

fn shown(words: &Words) -> Vec<String> {
    match words {
        Words::Picture { shows, .. } => shows.iter().map(|it| read(it)).collect(),
        _ => Vec::new(),
    }
}

/// The text of something that cannot be chosen; `None` if it is left out.
fn text(words: &Words, is_help: bool) -> Option<String> {
    Some(match words {
        Words::Picture { .. } => shown(words).join("\n"),
        Words::Text { runs, .. } if runs.iter().all(|run| run.role == Role::Key) => return None,
        Words::Text { mark, .. } if is_help && !mark.is_empty() => return None,
        Words::Text { mark, runs } => {
            let text = by_words(&joined(runs));
            let (mark, text) = match text.split_once(' ') {
                Some((inner @ ("✓" | "✗"), text)) => (inner, text.to_owned()),
                _ => (mark.trim(), text),
            };
            let text = match mark {
                mark if text.is_empty() || matches!(mark, "" | "-") => text,
                "✓" => format!("Right: {text}"),
                "✗" => format!("Not right: {text}"),
                mark => format!("{}: {text}", mark.trim_end_matches('.')),
            };
            read(&text)
        }
        Words::Equation { runs } => read(&format!("Formula: {}", joined(runs))),
        Words::Field { name, value, .. } => {
            read(&format!("{}: {}", field_name(name), value_words(value)))
        }
        Words::TextField { name, value } => read(&listed(name, [value.as_str()])),
        Words::Code(share) => format!("{}: {}", read(&share.text), share.command),
        Words::Meter { name, value, .. } => read(&listed(name, [value.as_str()])),
        words => read(&same_text(words)?),
    })
}

/// Text as it is read aloud, without drawing characters. File names stay unchanged.
pub(super) fn read(text: &str) -> String {
    let word = |word: &str| match is_path(word) {
        true => verbatim(word),
        false => word.replace('_', " "),
    };
    let words: Vec<_> = text.split(' ').map(word).collect();
    let is_read = |c: char| c.is_ascii() || c.is_alphanumeric();
    one_line(&spoken(&words.join(" ")).replace(|c| !is_read(c), " "))
}

/// Whether a word is the name of a file or a folder, possibly followed by a line number.
fn is_path(word: &str) -> bool {
    const ENDINGS: [&str; 8] = [
        ".md", ".toml", ".db", ".html", ".csv", ".json", ".tape", ".svg",
    ];
    let name = word.trim_end_matches(|c: char| c.is_ascii_digit() || ":,.)".contains(c));
    let is_below_root = word
        .strip_prefix('/')
        .is_some_and(|rest| rest.contains('/'));
    is_below_root || ENDINGS.iter().any(|ending| name.ends_with(ending))
}

/// The joined text of the runs, with names of keys marked.
fn joined(runs: &[Run]) -> String {
    let run = |run: &Run| match (&run.formula, run.role) {
        (Some(formula), _) => aloud(formula),
        (None, Role::Key) => format!("{KEY}{}", run.text),
        (None, _) => run.text.clone(),
    };
    runs.iter().map(run).collect()
}

/// A name and its values in one line.
fn listed<'v>(name: &str, values: impl IntoIterator<Item = &'v str>) -> String {
    let values = values.into_iter().map(one_line).filter(|it| !it.is_empty());
    let values: Vec<_> = values.collect();
    match (one_line(name), values.join(", ")) {
        (name, values) if values.is_empty() => name,
        (name, values) if name.is_empty() => values,
        (name, values) => format!("{name}: {values}"),
    }
}

/// The parts of the status in the title line.
fn parts(status: &str) -> Vec<String> {
    let parts = status.split("  ").map(|part| read(part.trim()));
    parts.filter(|part| !part.is_empty()).collect()
}

/// A frame's title, without the mark of the frame that has the keyboard focus.
fn title(title: &str) -> String {
    read(title.trim_start_matches('>').trim())
}

//! Every tape of the project that uses a single device plays in the page as in the native program:
//! whenever a tape takes a screenshot, expects or refuses something, the cells have the same
//! letters, and the page's elements have the same text.

use std::fs;
use std::path::{Path, PathBuf};

use carrom::cli;
use carrom::messages::MouseKind;
use carrom::shells::tape::{Instruction, ScreenSetting, Tape, play};
use carrom::widgets::{Charset, Depth};
use serde_json::{Value, json};

use crate::browser::{Browser, page, wait_until_ready};
use crate::chromium::Chromium;
use crate::firefox::Firefox;

/// Runs the commands one after the other. For each screen painted, returns the letters of its
/// cells, its blocks, and the text of the elements that the page makes from these blocks.
const PLAY: &str = "
    const screens = [];
    const shown = ['title', 'status', 'screen', 'layer'].map((id) => document.getElementById(id));
    const words = (node) => {
      if (node.nodeType === Node.TEXT_NODE) return node.data;
      const own = node.localName === 'canvas' ? node.getAttribute('aria-label') : node.value || '';
      return own + [...node.childNodes].map(words).join('');
    };
    for (const command of arguments[0]) {
      const reply = window.carrom.call(command);
      if (reply.fault) throw new Error(reply.fault + ': ' + JSON.stringify(command));
      if (!reply.painted) continue;
      const [columns, rows] = reply.painted.size;
      const cells = window.carrom.cells(columns * rows);
      const lines = [];
      for (let row = 0; row < rows; row++) {
        let line = '';
        for (let column = 0; column < columns; column++) {
          line += String.fromCodePoint(cells[4 * (row * columns + column)]);
        }
        lines.push(line);
      }
      // The sheets are omitted if they are the same as on the last screen or if there are none.
      if (reply.painted.sheets) window.carrom.show(reply.painted.sheets);
      screens.push({
        cells: lines.join('\\n'),
        sheets: reply.painted.sheets || [],
        elements: shown.map(words).join(' '),
      });
    }
    return screens;";

fn tapes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/tapes");
    let files = fs::read_dir(folder)
        .unwrap()
        .map(|file| file.unwrap().path());
    let mut tapes: Vec<_> = files
        .filter(|path| path.extension().is_some_and(|it| it == "tape"))
        // The page is a single device, so it cannot play tapes that use several.
        .filter(|path| !fs::read_to_string(path).unwrap().contains("\nAt \""))
        .collect();
    tapes.sort();
    tapes
}

/// A tape with this charset and size, which takes a screenshot before each of its checks.
fn tape(path: &Path, charset: &str, size: &str) -> Tape {
    let text = fs::read_to_string(path).unwrap();
    let mut lines: Vec<String> = Vec::new();
    let mut set = Some(format!("Set Size {size}\nSet Charset {charset}"));
    for (number, line) in text.lines().enumerate() {
        let word = line.split_whitespace().next().unwrap_or("");
        if !matches!(word, "Run" | "" | "#") {
            lines.extend(set.take());
        }
        if matches!(word, "Expect" | "Refuse") {
            lines.push(format!("Screenshot before-line-{number}"));
        }
        lines.push(line.to_owned());
    }
    Tape::parse(&lines.join("\n")).unwrap_or_else(|error| panic!("{path:?}:{error}"))
}

/// What a screen shows: the letter of each cell, and the texts of its blocks.
struct Shown {
    cells: String,
    texts: Vec<String>,
}

/// The screens that the native program shows for a tape.
fn here(tape: &Tape) -> Vec<Shown> {
    let screens = play(tape, cli::open).unwrap_or_else(|error| panic!("{error}"));
    let lines = |cells: &ratatui::buffer::Buffer| {
        let rows = cells.content().chunks(cells.area.width.into());
        let letter = |cell: &ratatui::buffer::Cell| cell.symbol().chars().next().unwrap_or(' ');
        let rows: Vec<String> = rows.map(|row| row.iter().map(letter).collect()).collect();
        rows.join("\n")
    };
    let shown = screens.iter().map(|screen| Shown {
        cells: lines(&screen.cells),
        texts: texts(&json!(screen.sheets)),
    });
    shown.collect()
}

/// The texts of blocks, each joined into one piece regardless of its colours.
fn texts(blocks: &Value) -> Vec<String> {
    match blocks {
        Value::String(text) => vec![text.clone()],
        Value::Array(all) if all.iter().any(|it| it.get("role").is_some()) => {
            let runs = all.iter().filter_map(|run| run["text"].as_str());
            vec![runs.collect()]
        }
        Value::Array(all) => all.iter().flat_map(texts).collect(),
        Value::Object(fields) => {
            // The page shows a link instead of a command.
            let hidden = ["is", "kind", "role", "key", "command", "address"];
            let fields = fields
                .iter()
                .filter(|(name, _)| !hidden.contains(&name.as_str()));
            fields.flat_map(|(_, value)| texts(value)).collect()
        }
        _ => Vec::new(),
    }
}

/// The letters and digits of a text; nothing else is compared, because the page capitalizes and
/// spaces its elements differently.
fn letters(text: &str) -> String {
    let letters = text.chars().filter(|letter| letter.is_alphanumeric());
    letters.flat_map(char::to_lowercase).collect()
}

/// The instructions of a tape as commands for the page.
fn commands(tape: &Tape) -> Vec<Value> {
    let mut size = (80, 24);
    let mut commands = vec![json!({
        "do": "open", "simulated": true, "columns": 80, "rows": 24, "seed": 1,
        "fragment": fragment(tape.arguments()),
    })];
    let mouse = |kind: &str, (column, row): (u16, u16)| {
        let [x, y] = [column, row].map(|cell| f64::from(cell) + 0.5);
        json!({ "do": "mouse", "kind": kind, "x": x, "y": y })
    };
    for instruction in tape.instructions() {
        match instruction {
            Instruction::Set(ScreenSetting::Size(columns, rows)) => {
                size = (*columns, *rows);
                commands.push(json!({ "do": "resize", "columns": columns, "rows": rows }));
            }
            Instruction::Set(ScreenSetting::Charset(charset)) => {
                let name = match charset {
                    Charset::Ascii => "ascii",
                    Charset::Unicode => "unicode",
                };
                commands.push(json!({ "do": "set", "charset": name }));
            }
            Instruction::Set(ScreenSetting::Color(depth)) => {
                let name = match depth {
                    Depth::None => "none",
                    Depth::Ansi16 => "16",
                    Depth::Indexed256 => "256",
                    Depth::True => "truecolor",
                };
                commands.push(json!({ "do": "set", "color": name }));
            }
            Instruction::Set(ScreenSetting::Day(time_s)) => {
                commands.push(json!({ "do": "now", "time_s": time_s, "offset_s": 0 }));
            }
            Instruction::Type(text) => commands.extend(text.chars().map(|letter| {
                let key = match letter {
                    '\n' => "Enter".to_owned(),
                    '\t' => "Tab".to_owned(),
                    other => other.to_string(),
                };
                json!({ "do": "key", "key": key })
            })),
            Instruction::Press(key, times) => {
                commands
                    .extend((0..*times).map(|_| json!({ "do": "key", "key": key.to_string() })));
            }
            Instruction::Click(at) => commands.extend([mouse("down", *at), mouse("up", *at)]),
            Instruction::Drag(from, to) => {
                commands.extend([mouse("down", *from), mouse("drag", *to), mouse("up", *to)]);
            }
            Instruction::Hold(from, to) => {
                commands.extend([mouse("down", *from), mouse("drag", *to)]);
            }
            Instruction::Release(at) => commands.push(mouse("up", *at)),
            Instruction::Scroll(way, notches, at) => {
                let kind = match way {
                    MouseKind::ScrollUp => "scroll-up",
                    _ => "scroll-down",
                };
                let at = at.unwrap_or((size.0 / 2, size.1 / 2));
                commands.extend((0..*notches).map(|_| mouse(kind, at)));
            }
            Instruction::Sleep(time) => {
                commands.push(json!({ "do": "pass", "ms": time.as_secs_f64() * 1e3 }));
            }
            Instruction::Screenshot(_) => commands.push(json!({ "do": "paint" })),
            // The screenshot taken just before is compared.
            Instruction::Expect(_) | Instruction::Refuse(_) => {}
            Instruction::At(_) | Instruction::Reach(..) => {
                unreachable!("a tape with several devices cannot be played in a page")
            }
        }
    }
    commands
}

/// The part of the page's address after `#` that corresponds to these command-line arguments.
fn fragment(arguments: &str) -> String {
    let mut parts: Vec<String> = vec!["charset=ascii".into(), "color=none".into()];
    let mut seed = None;
    let words = shlex::split(arguments).unwrap();
    let mut words = words.iter().map(String::as_str).peekable();
    let mut screen = None;
    while let Some(word) = words.next() {
        let mut value = || words.next().unwrap().to_owned();
        match word {
            "--seed" => seed = Some(value()),
            "--code" => screen = screen.map(|name: String| format!("{name}={}", value())),
            "--teams" => parts.push(format!("teams={}", value())),
            "--player" => parts.push(format!("player={}", value())),
            "--charset" | "--color" | "--palette" => {
                parts.push(format!("{}={}", &word[2..], value()));
            }
            other if other.starts_with("--") => panic!("{other} cannot be part of a link"),
            name => {
                let named = words.next_if(|next| !next.starts_with("--"));
                screen = Some(named.map_or(name.to_owned(), |it| format!("{name}={it}")));
            }
        }
    }
    parts.extend(seed.map(|seed| format!("seed={seed}")));
    // In a link, teams come after the class that they belong to.
    parts.splice(0..0, screen);
    parts.join("&")
}

/// Plays a tape natively and in the page, and reports the first screen that differs.
fn compare(
    browser: &mut dyn Browser,
    path: &Path,
    charset: &str,
    size: &str,
) -> Result<(), String> {
    let tape = tape(path, charset, size);
    let wanted = here(&tape);
    let found = browser.run(PLAY, &[Value::Array(commands(&tape))]);
    let found = found.as_array().unwrap();
    assert_eq!(found.len(), wanted.len(), "{path:?}");
    let name = path.file_stem().unwrap().display();
    for (number, (found, wanted)) in found.iter().zip(&wanted).enumerate() {
        let screen = format!("{name} in {charset} at {size}, screen {number}");
        let cells = found["cells"].as_str().unwrap_or_default();
        if !is_alike(cells, &wanted.cells) {
            return Err(format!(
                "{screen}: here\n{}\n\nin the page\n{cells}\n",
                wanted.cells
            ));
        }
        let there = texts(&found["sheets"]);
        if there != wanted.texts {
            return Err(format!(
                "{screen}: here\n{:?}\n\nin the page\n{there:?}\n",
                wanted.texts
            ));
        }
        let elements = letters(found["elements"].as_str().unwrap_or_default());
        if let Some(lost) = there.iter().find(|text| !elements.contains(&letters(text))) {
            return Err(format!(
                "{screen}: no element contains {lost:?}: {elements}"
            ));
        }
    }
    println!("{name}: {} screens", wanted.len());
    Ok(())
}

/// Whether two screens are the same except for at most one cell of dots: math libraries round
/// angles differently, and the last bit can move a dot of a curve.
fn is_alike(one: &str, other: &str) -> bool {
    let is_dots = |letter: char| ('\u{2800}'..'\u{2900}').contains(&letter);
    let pairs = one.chars().zip(other.chars());
    let unlike: Vec<_> = pairs.filter(|(a, b)| a != b).collect();
    let dots = unlike.iter().all(|(a, b)| is_dots(*a) && is_dots(*b));
    one.chars().count() == other.chars().count() && unlike.len() <= 1 && dots
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn every_tape_plays_in_chromium_as_in_the_program() {
    let (page, mut chromium) = (page(), Chromium::start((1280, 800), false));
    chromium.open(&page);
    wait_until_ready(&mut chromium);
    let mut wrong = Vec::new();
    for path in tapes() {
        for (charset, size) in [("unicode", "120x40"), ("ascii", "80x24")] {
            wrong.extend(compare(&mut chromium, &path, charset, size).err());
        }
    }
    assert!(
        wrong.is_empty(),
        "{} differ\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

#[test]
#[ignore = "needs the page: .ci/page builds it, and CARROM_TEST_PAGE names it"]
fn some_tapes_play_in_firefox_as_in_the_program() {
    let page = page();
    let mut firefox = Firefox::start();
    firefox.open(&page);
    wait_until_ready(&mut firefox);
    let paths = tapes();
    let sample = paths.iter().step_by(7);
    let compared = sample.map(|path| compare(&mut firefox, path, "unicode", "120x40"));
    let wrong: Vec<_> = compared.filter_map(Result::err).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

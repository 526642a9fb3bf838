//! Reads a tape.

use std::collections::HashMap;
use std::str::FromStr;
use std::time::Duration;

use jiff::civil::Date;
use jiff::tz::TimeZone;
use thiserror::Error;

use super::line::{Token, parts};
use super::{Instruction, ScreenSetting, Tape};
use crate::files::{LONGEST_QUOTE, escape_control};
use crate::messages::{Key, MouseKind};

/// The maximum number of presses or notches in one instruction.
const MOST: u32 = 10_000;
/// The maximum number of columns or rows.
const WIDEST: u16 = 1000;
/// The longest sleep, in seconds.
const HOUR: f64 = 3600.0;

/// A line of a tape that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{line}: {message}")]
pub struct ParseError {
    /// Number of the line, from 1.
    pub line: usize,
    /// What is wrong with the line, and what was expected.
    pub message: String,
}

impl Tape {
    /// Reads a tape.
    ///
    /// # Errors
    /// The first line that cannot be read, with what was expected there.
    pub fn parse(text: &str) -> Result<Self, ParseError> {
        let mut tape = Self {
            run: None,
            steps: Vec::new(),
        };
        let mut names = HashMap::new();
        for (line, text) in (1..).zip(text.lines()) {
            let added = tape.add(line, text, &mut names);
            added.map_err(|message| ParseError { line, message })?;
        }
        Ok(tape)
    }

    /// Adds a line. `names` contains the name of each earlier screenshot, with its line; no name
    /// may be used twice.
    fn add(
        &mut self,
        line: usize,
        text: &str,
        names: &mut HashMap<String, usize>,
    ) -> Result<(), String> {
        let parts = parts(text)?;
        let Some((first, rest)) = parts.split_first() else {
            return Ok(());
        };
        let arguments = Arguments { of: first, rest };
        if *first == Token::Word("Run".into()) {
            if self.run.is_some() || !self.steps.is_empty() {
                return Err("Run must be the first instruction and may appear only once".into());
            }
            let [run] = arguments.exactly("the arguments after carrom in quotes")?;
            self.run = Some((line, quoted(run, "the arguments in quotes")?));
            return Ok(());
        }
        let instruction = instruction(&arguments)?;
        if let Instruction::Screenshot(name) = &instruction {
            // Some file systems do not distinguish between upper and lower case.
            if let Some(before) = names.insert(name.to_lowercase(), line) {
                return Err(format!(
                    "Screenshot: the name {name} is taken by line {before}"
                ));
            }
        }
        self.steps.push((line, instruction));
        Ok(())
    }
}

/// The words and strings after the first word of a line.
struct Arguments<'a> {
    of: &'a Token,
    rest: &'a [Token],
}

impl<'a> Arguments<'a> {
    /// Exactly `N` arguments, or an error that says what was expected.
    fn exactly<const N: usize>(&self, expected: &str) -> Result<&'a [Token; N], String> {
        self.rest.try_into().map_err(|_| self.not(expected))
    }

    /// The value of the only argument.
    fn one<T>(
        &self,
        expected: &str,
        read: impl Fn(&Token) -> Result<T, String>,
    ) -> Result<T, String> {
        let [part] = self.exactly(expected)?;
        read(part)
    }

    fn not(&self, expected: &str) -> String {
        let found: Vec<_> = self.rest.iter().map(ToString::to_string).collect();
        let found = match found.as_slice() {
            [] => "nothing".into(),
            found => escape_control(&found.join(" "), LONGEST_QUOTE),
        };
        format!("{}: expected {expected}, found {found}", self.of)
    }
}

/// The name of the teacher's device.
const TEACHER: &str = "teacher";

fn instruction(arguments: &Arguments) -> Result<Instruction, String> {
    let Token::Word(name) = arguments.of else {
        return Err(format!("expected an instruction, found {}", arguments.of));
    };
    let one_text = || -> Result<String, String> {
        let expected = "a text in quotes";
        let text = arguments.one(expected, |text| quoted(text, expected))?;
        (!text.is_empty())
            .then_some(text)
            .ok_or_else(|| format!("{name}: expected a text that is not empty"))
    };
    Ok(match name.as_str() {
        "Set" => Instruction::Set(setting(arguments)?),
        "Type" => Instruction::Type(one_text()?),
        "Expect" => Instruction::Expect(one_text()?),
        "Refuse" => Instruction::Refuse(one_text()?),
        "Click" => Instruction::Click(arguments.one("a cell, such as 40,12", cell)?),
        "Drag" => {
            let [from, to] = arguments.exactly("two cells, such as 40,12 44,12")?;
            Instruction::Drag(cell(from)?, cell(to)?)
        }
        "Hold" => {
            let [from, to] = arguments.exactly("two cells, such as 40,12 44,12")?;
            Instruction::Hold(cell(from)?, cell(to)?)
        }
        "Release" => Instruction::Release(arguments.one("a cell, such as 44,12", cell)?),
        "Scroll" => scroll(arguments)?,
        "Sleep" => Instruction::Sleep(arguments.one("a time, such as 1.5s or 200ms", duration)?),
        "At" => {
            let [who] = arguments.exactly("\"teacher\" or the name of a pupil in quotes")?;
            let who = quoted(who, "a name in quotes")?;
            Instruction::At((who != TEACHER).then_some(who))
        }
        "Lose" | "Reach" => Instruction::Reach(one_text()?, name == "Reach"),
        "Screenshot" => Instruction::Screenshot(arguments.one("one name", file_name)?),
        other => {
            let Some(key) = Key::named(other) else {
                return Err(format!(
                    "unknown instruction {}; expected Run, Set, Type, Click, Drag, Hold, \
                     Release, Scroll, Sleep, At, Lose, Reach, Screenshot, Expect, Refuse or the name of a key",
                    arguments.of
                ));
            };
            let times = match arguments.rest {
                [] => 1,
                [times] => count(times)?,
                _ => return Err(arguments.not("at most one count")),
            };
            Instruction::Press(key, times)
        }
    })
}

fn setting(arguments: &Arguments) -> Result<ScreenSetting, String> {
    const EXPECTED: &str = "Size, Charset, Color or Day with a value";
    let [Token::Word(what), found @ Token::Word(value)] = arguments.rest else {
        return Err(arguments.not(EXPECTED));
    };
    let wrong = |expected| format!("Set {what}: expected {expected}, found {found}");
    Ok(match what.as_str() {
        "Size" => {
            let expected = "columns x rows, each up to 1000, such as 80x24";
            let (columns, rows) = two(value, 'x').ok_or_else(|| wrong(expected))?;
            ScreenSetting::Size(columns, rows)
        }
        "Charset" => ScreenSetting::Charset(value.parse().map_err(|_| wrong("ascii or unicode"))?),
        "Color" => {
            let depth = value.parse();
            ScreenSetting::Color(depth.map_err(|_| wrong("none, 16, 256 or truecolor"))?)
        }
        "Day" => ScreenSetting::Day(noon(value).ok_or_else(|| wrong("a day, such as 2026-01-05"))?),
        _ => return Err(arguments.not(EXPECTED)),
    })
}

/// Noon on a day, such as 2026-01-05, in seconds since the start of 1970 (UTC).
fn noon(day: &str) -> Option<i64> {
    let date: Date = day.parse().ok()?;
    let noon = date.at(12, 0, 0, 0).to_zoned(TimeZone::UTC).ok()?;
    let noon_s = noon.timestamp().as_second();
    (noon_s > 0 && date.to_string() == day).then_some(noon_s)
}

fn scroll(arguments: &Arguments) -> Result<Instruction, String> {
    let expected = "up or down, then optionally the number of notches and a cell";
    let (way, rest) = match arguments.rest {
        [Token::Word(way), rest @ ..] if rest.len() <= 2 => (way.as_str(), rest),
        rest => ("", rest),
    };
    let way = match way {
        "up" => MouseKind::ScrollUp,
        "down" => MouseKind::ScrollDown,
        _ => return Err(arguments.not(expected)),
    };
    let notches = rest.first().map_or(Ok(1), count)?;
    let at = rest.get(1).map(cell).transpose()?;
    Ok(Instruction::Scroll(way, notches, at))
}

fn quoted(part: &Token, expected: &str) -> Result<String, String> {
    match part {
        Token::Text(text) => Ok(text.clone()),
        Token::Word(_) => Err(format!("expected {expected}, found {part} without quotes")),
    }
}

/// A whole number from 0 to `most`, written only in digits.
fn within<N: FromStr + PartialOrd + Copy>(digits: &str, most: N) -> Option<N> {
    let is_plain = digits.bytes().all(|b| b.is_ascii_digit());
    let number = digits.parse().ok().filter(|_| is_plain);
    number.filter(|number| *number <= most)
}

fn count(part: &Token) -> Result<u32, String> {
    let number = part.word().and_then(|word| within(word, MOST));
    let number = number.filter(|times| *times > 0);
    number.ok_or_else(|| format!("expected a count from 1 to {MOST}, found {part}"))
}

/// Two columns or rows, with a letter between them.
fn two(text: &str, between: char) -> Option<(u16, u16)> {
    let (first, second) = text.split_once(between)?;
    Some((within(first, WIDEST)?, within(second, WIDEST)?))
}

fn cell(part: &Token) -> Result<(u16, u16), String> {
    let cell = part.word().and_then(|word| two(word, ','));
    cell.ok_or_else(|| format!("expected a cell as column,row such as 40,12, found {part}"))
}

fn duration(part: &Token) -> Result<Duration, String> {
    let seconds = part.word().and_then(|word| match word.strip_suffix("ms") {
        Some(number) => decimal(number).map(|ms| ms / 1000.0),
        None => word.strip_suffix('s').and_then(decimal),
    });
    let time = seconds
        .filter(|it| *it <= HOUR)
        .map(Duration::from_secs_f64);
    time.ok_or_else(|| {
        format!("Sleep: expected a time of at most 3600s, such as 1.5s or 200ms, found {part}")
    })
}

/// A decimal number; a sign, an exponent or `inf` is not allowed.
fn decimal(text: &str) -> Option<f64> {
    let plain = text.bytes().all(|b| b.is_ascii_digit() || b == b'.');
    plain.then(|| text.parse().ok())?
}

/// A name that is safe as a file name, even if the tape is not trusted.
fn file_name(part: &Token) -> Result<String, String> {
    let safe = |b: u8| b.is_ascii_alphanumeric() || b == b'-' || b == b'_';
    match part {
        Token::Word(name) if name.len() <= 64 && name.bytes().all(safe) => Ok(name.clone()),
        _ => Err(format!(
            "Screenshot: expected a name of at most 64 letters, digits, - and _, found {part}"
        )),
    }
}

//! The quiz and the lessons in plain lines.
//!
//! A talk blocks where it waits for a line, and a page must not block. So each time a line
//! is said the talk is held again from its beginning, with all lines so far: it says the
//! same, and stops where it would wait. What it asked of the store is not asked again.

use std::cell::Cell;
use std::io::{self, BufRead, Read, Write};
use std::sync::Arc;

use carrom::lessons::ChapterLibrary;
use carrom::messages::{StoreAnswer, StoreCall};
use carrom::quiz::Code;
use carrom::quiz::concepts::Library;
use carrom::shells::plain::{self, AnswerRecorder, Leave, Talk};

use crate::keeping::PageStorage;
use crate::opening::unescaped;

/// What a talk has had from the store so far.
#[derive(Default)]
pub(crate) struct Talked(Vec<StoreAnswer>);

/// Who is talked with, and about what.
pub(crate) struct Asked<'a> {
    pub(crate) fragment: &'a str,
    pub(crate) seed: u64,
    pub(crate) player: &'a str,
    pub(crate) own: &'a Arc<Library>,
    pub(crate) chapters: &'a ChapterLibrary,
}

impl Talked {
    /// What is said in a talk in which the player has said these lines, and whether it is
    /// over.
    pub(crate) fn go_on(
        &mut self,
        heard: &[String],
        asked: &Asked,
        keeping: &mut PageStorage,
    ) -> (Vec<String>, bool) {
        let heard: String = heard.iter().map(|line| format!("{line}\n")).collect();
        let ran_out = Cell::new(false);
        let mut heard = Heard {
            left: heard.as_bytes(),
            ran_out: &ran_out,
        };
        let mut said = Transcript {
            text: Vec::new(),
            ran_out: &ran_out,
        };
        let mut number = 0;
        let mut keep = |call: &StoreCall| {
            if number == self.0.len() {
                self.0.push(keeping.do_at_once(call));
            }
            number += 1;
            self.0[number - 1].clone()
        };
        let mut talk = Talk::new(&mut heard, &mut said);
        let mut recorder = AnswerRecorder::new(&mut talk, asked.player, &mut keep);
        let ended = hold(&mut recorder, asked);
        let over = !ran_out.get() || !matches!(ended, Err(Leave::Ended));
        let text = String::from_utf8_lossy(&said.text);
        (text.lines().map(str::to_owned).collect(), over)
    }
}

/// Holds the talk that the link asks for.
fn hold(recorder: &mut AnswerRecorder, asked: &Asked) -> Result<(), Leave> {
    let parts = asked.fragment.split('&');
    for (name, value) in parts.map(|part| part.split_once('=').unwrap_or((part, ""))) {
        let value = unescaped(value);
        match name {
            "learn" | "lesson" => {
                return plain::learn(recorder, asked.chapters, asked.chapters.find(&value));
            }
            "quiz" => {
                let code = Code::parse(&value).and_then(|code| code.with_own(asked.own).ok());
                return plain::quiz(recorder, code, asked.seed, asked.own);
            }
            _ => {}
        }
    }
    plain::quiz(recorder, None, asked.seed, asked.own)
}

/// Lines that were said to carrom.
struct Heard<'a> {
    left: &'a [u8],
    /// Whether it would wait for more.
    ran_out: &'a Cell<bool>,
}

impl Read for Heard<'_> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        self.fill_buf()?;
        self.left.read(into)
    }
}

impl BufRead for Heard<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.ran_out.set(self.ran_out.get() || self.left.is_empty());
        Ok(self.left)
    }

    fn consume(&mut self, count: usize) {
        self.left.consume(count);
    }
}

/// What carrom says until it waits.
struct Transcript<'a> {
    text: Vec<u8>,
    ran_out: &'a Cell<bool>,
}

impl Write for Transcript<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if !self.ran_out.get() {
            self.text.extend(bytes);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use carrom::app::Data;

    use super::*;

    /// Held again from its beginning with each line, a talk keeps each answer once.
    #[test]
    fn a_round_in_lines_keeps_each_answer_once() {
        let data = Data::default();
        let asked = Asked {
            fragment: "plain&quiz=separation2-7",
            seed: 1,
            player: "Ada",
            own: &data.own,
            chapters: data.book.library(),
        };
        let mut keeping = PageStorage::new(&data.own, true);
        let mut talked = Talked::default();
        let mut heard = Vec::new();
        let mut before = 0;
        for line in ["", "a", "3", "a", "3"] {
            if !line.is_empty() {
                heard.push(line.to_owned());
            }
            let (said, over) = talked.go_on(&heard, &asked, &mut keeping);
            assert!(said.len() > before, "{said:?}");
            before = said.len();
            assert_eq!(over, heard.len() == 4, "{said:?}");
        }
        assert_eq!(talked.0.len(), 2);
    }
}

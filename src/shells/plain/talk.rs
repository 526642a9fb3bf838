//! A dialogue that writes and reads lines.

use std::io::{self, BufRead, Write};

use super::spoken;
use crate::files::read_line;

/// The longest input line, in bytes; the rest of a longer line is skipped.
const LONGEST: usize = 1000;

/// The help on the words that are understood at any time.
const ALWAYS: &str = "At any time: repeat reads the question again, help explains how to answer, \
                      quit ends carrom.";

/// A dialogue in lines.
pub struct Talk<'a> {
    input: &'a mut dyn BufRead,
    output: &'a mut dyn Write,
}

/// Why a dialogue ends early.
#[derive(Debug)]
pub enum Leave {
    /// The player typed quit, the input has ended, or nobody reads the output any more.
    Ended,
    /// A line could not be written or read.
    Failed(io::Error),
}

impl From<io::Error> for Leave {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            // The program that reads the output has stopped.
            io::ErrorKind::BrokenPipe => Self::Ended,
            _ => Self::Failed(error),
        }
    }
}

impl<'a> Talk<'a> {
    /// Starts a dialogue with this input and output.
    pub fn new(input: &'a mut dyn BufRead, output: &'a mut dyn Write) -> Self {
        Self { input, output }
    }

    /// Writes each line of a text in spoken form.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn say(&mut self, text: &str) -> Result<(), Leave> {
        for line in text.lines() {
            let line = spoken(line);
            // This line of the working continues the line before it.
            let line = match line.strip_prefix("equals ") {
                Some(rest) => format!("This equals {rest}"),
                None => line,
            };
            if !line.is_empty() {
                writeln!(self.output, "{line}")?;
            }
        }
        self.output.flush()?;
        Ok(())
    }

    /// Writes these lines, one after the other.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub(super) fn say_all<S: AsRef<str>>(
        &mut self,
        lines: impl IntoIterator<Item = S>,
    ) -> Result<(), Leave> {
        lines.into_iter().try_for_each(|it| self.say(it.as_ref()))
    }

    /// Writes a question, and repeats it until an answer is understood. `help` explains how to
    /// answer. `read` gets a trimmed line, which may be empty; it returns the answer, or a line that
    /// explains what was expected.
    ///
    /// # Errors
    /// If the player quits, the input ends, or a line cannot be written or read.
    pub(super) fn ask_for<T>(
        &mut self,
        question: &str,
        help: &str,
        read: impl Fn(&str) -> Result<T, String>,
    ) -> Result<T, Leave> {
        self.say(question)?;
        loop {
            let heard = self.hear()?;
            match heard.to_lowercase().as_str() {
                "quit" | "q" | "exit" => return Err(Leave::Ended),
                "help" | "h" | "?" => self.say_all([help, ALWAYS])?,
                "repeat" | "r" => self.say(question)?,
                _ => match read(&heard) {
                    Ok(meant) => return Ok(meant),
                    Err(expected) => self.say_all([&*expected, question])?,
                },
            }
        }
    }

    fn hear(&mut self) -> Result<String, Leave> {
        let heard = hear(&mut *self.input)?.ok_or(Leave::Ended)?;
        let visible: String = heard.chars().filter(|c| !c.is_control()).collect();
        Ok(visible.trim().to_owned())
    }
}

/// Reads a line; `None` at the end of the input.
///
/// # Errors
/// If the input cannot be read.
pub(super) fn hear(input: &mut (impl BufRead + ?Sized)) -> io::Result<Option<String>> {
    let mut line = Vec::new();
    let heard = read_line(input, LONGEST, &mut line)?;
    Ok(heard.map(|_| String::from_utf8_lossy(&line).into_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hear_all(input: &[u8]) -> Vec<String> {
        let (mut input, mut output) = (input, Vec::new());
        let mut talk = Talk::new(&mut input, &mut output);
        let mut heard = Vec::new();
        while let Ok(line) = talk.hear() {
            heard.push(line);
        }
        heard
    }

    #[test]
    fn lines_with_any_line_endings_and_bytes_are_read() {
        assert_eq!(
            hear_all(b" 60 \r\nstill\n\nlast"),
            ["60", "still", "", "last"]
        );
        assert_eq!(hear_all(b"\xff\xfe\x1b[31m7\n"), ["\u{fffd}\u{fffd}[31m7"]);
        let long = [vec![b'x'; 5000], b"\nnext\n".to_vec()].concat();
        let heard = hear_all(&long);
        assert_eq!(
            (heard.len(), heard[0].len(), heard[1].as_str()),
            (2, 1000, "next")
        );
    }
}

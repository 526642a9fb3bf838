//! Names with their scores, in the largest letters that fit.

use crate::widgets::big::{Align, Big};
use crate::widgets::flow::Run;
use crate::widgets::{Lines, Role, Words, text};

/// The height of large letters, in rows.
const LETTERS: u16 = 4;
/// The number of rows for a name in large type: one for each row of its letters, one for its bar,
/// and one empty row if there is room.
const LARGE: [u16; 2] = [LETTERS + 1, LETTERS + 2];
/// The number of columns between a name and its points in large type.
const APART: u16 = 3;
/// The total number of columns beside a name for its points and its gain.
const NUMBERS: u16 = 20;
/// The number of columns for each of these two numbers.
const NUMBER: usize = 6;

/// A name with its score.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BoardRow {
    /// The rank and the name, such as "1. Ants", or a question, such as "Question 3".
    pub name: String,
    /// The points, such as "27.5", or the share of right votes, such as "75 %".
    pub points: String,
    /// The points gained most recently, such as "+9.3", or the change in the share.
    pub gain: String,
    /// The points as a fraction of all possible points, or the share of right votes.
    pub share: f64,
}

/// Writes the names and scores into the remaining rows.
pub(super) fn write(rows: &[BoardRow], lines: &mut Lines) {
    let high = lines.left() / (rows.len() as u16).max(1);
    match large(rows, high, lines) {
        Some(letters) => {
            for (row, [name, points]) in rows.iter().zip(&letters) {
                row.write_large([name, points], high, lines);
            }
        }
        None => rows.iter().for_each(|row| row.write(high, lines)),
    }
}

impl BoardRow {
    fn write_large(&self, [name, points]: [&Big; 2], high: u16, lines: &mut Lines) {
        let top = lines.written();
        let words = |_| Words::Pair {
            name: Run::new(&self.name, Role::Title),
            value: Run::new(&self.points, Role::Title),
        };
        lines.written_as(words, |lines| {
            lines.big(&[(name, Align::Left), (points, Align::Right)]);
        });
        lines.skip_to(top + LETTERS);
        let width = lines.width().saturating_sub(9);
        let gain = Run::new(&self.gain, Role::Title);
        lines.meter("", self.share, Role::Predicted, width, &gain);
        lines.skip_to(top + high.min(LARGE[1]));
    }

    /// Writes the name and the score in one line, with a bar below if there is room.
    fn write(&self, high: u16, lines: &mut Lines) {
        let top = lines.written();
        let room = usize::from(lines.width().saturating_sub(NUMBERS));
        let name = text::clipped(&self.name, room);
        let numbers = format!("{:>NUMBER$}  {:>NUMBER$}", self.points, self.gain);
        let [name, numbers] = [name, numbers].map(|text| Run::new(text, Role::Title));
        lines.pair(&name, &numbers);
        if high > 1 {
            let (width, nothing) = (lines.width().saturating_sub(1), Run::new("", Role::Text));
            lines.meter("", self.share, Role::Predicted, width, &nothing);
        }
        lines.skip_to(top + high.clamp(1, 3));
    }
}

/// The names and points in large type, if there is room for all of them.
fn large(rows: &[BoardRow], high: u16, lines: &Lines) -> Option<Vec<[Big; 2]>> {
    if high < LARGE[0] {
        return None;
    }
    let (width, charset) = (lines.width(), lines.charset());
    let texts = |of: fn(&BoardRow) -> &String| rows.iter().map(|row| of(row).as_str()).collect();
    let points: Vec<&str> = texts(|row| &row.points);
    let points = Big::fit_all(&points, (width + 1) / 3, LETTERS, charset)?;
    let widest = points.iter().map(Big::columns).max()?;
    let names: Vec<&str> = texts(|row| &row.name);
    let room = width.saturating_sub(widest + APART + 1);
    let names = Big::fit_all(&names, room, LETTERS, charset)?;
    let letters = names.into_iter().zip(points);
    Some(letters.map(<[Big; 2]>::from).collect())
}

//! Letters made of strokes: the smallest large type in ASCII, with three rows and a descender.
//!
//! The font is "Mini" by Glenn Chappell, in FIGlet format. The first line contains the height of
//! the letters and the number of comment lines. After the comment come the letters in ASCII order,
//! starting with the space: one line for each row of a letter. Each line ends with an end mark, and
//! the last line of a letter ends with two. A dollar sign stands for a space into which other
//! letters must not move.

use std::sync::LazyLock;

static FONT: &str = include_str!("../../../../assets/fonts/mini.flf");

/// The number of rows in a line of letters.
pub(super) const ROWS: usize = 4;
pub(super) const BLANK: usize = 3;
/// A space into which other letters must not move.
const HARD: char = '$';

/// The rows of a letter or of a line of letters, which all have the same length.
pub(super) type LetterRows = [Vec<char>; ROWS];

/// The letters from the space to the tilde in ASCII.
static LETTERS: LazyLock<Vec<LetterRows>> = LazyLock::new(|| {
    let mut lines = FONT.lines();
    let head = lines.next().unwrap_or_default();
    let remarks = head.split(' ').nth(5).and_then(|it| it.parse().ok());
    let lines: Vec<&str> = lines.skip(remarks.unwrap_or(0)).collect();
    let letter = |lines: &[&str]| {
        let row = |i| -> Vec<char> {
            let line: &str = lines.get(i).copied().unwrap_or_default();
            line.trim_end_matches('@').chars().collect()
        };
        std::array::from_fn(row)
    };
    lines.chunks_exact(ROWS).map(letter).take(95).collect()
});

/// The number of rows in a line; the row for descenders is included only if there are any.
pub(super) fn rows_of(line: &LetterRows) -> usize {
    let tails = line[ROWS - 1].iter().any(|c| *c != ' ');
    ROWS - usize::from(!tails)
}

/// The number of empty rows at the top of a line; a line of lower-case letters such as x has one.
pub(super) fn empty_rows(line: &LetterRows) -> usize {
    let is_empty = |row: &&Vec<char>| row.iter().all(|c| *c == ' ');
    line.iter().take_while(is_empty).count()
}

/// The number of rows from the top of a line to the top of the next line. The capitals of the next
/// line may share a row with the descenders of this line if the two do not touch.
pub(super) fn apart(above: &LetterRows, below: &LetterRows) -> usize {
    let tails = above[ROWS - 1].iter().enumerate();
    let mut tails = tails.filter(|(_, c)| **c != ' ').map(|(at, _)| at);
    let touch = tails.any(|at| {
        let beside = at.saturating_sub(1)..=at + 1;
        { beside }.any(|at| below[0].get(at).is_some_and(|c| *c != ' '))
    });
    ROWS - usize::from(!touch)
}

pub(super) fn beside(words: &[&LetterRows]) -> LetterRows {
    std::array::from_fn(|row| {
        let words: Vec<_> = words.iter().map(|word| word[row].as_slice()).collect();
        words.join(&[' '; BLANK][..])
    })
}

/// The letters of an ASCII word, as close together as possible without touching; `None` if any
/// letter has no strokes.
pub(super) fn joined(word: &str) -> Option<LetterRows> {
    let mut joined = LetterRows::default();
    for letter in word.chars() {
        let letter = LETTERS.get((letter as usize).checked_sub(' ' as usize)?)?;
        let overlap = (0..ROWS)
            .map(|row| {
                let after = joined[row].iter().rev().take_while(|c| **c == ' ').count();
                let before = letter[row].iter().take_while(|c| **c == ' ').count();
                after + before
            })
            .min();
        let (width, wide) = (joined[0].len(), letter[0].len());
        let start = width.saturating_sub(overlap.unwrap_or(0).min(wide));
        for (joined, letter) in joined.iter_mut().zip(letter) {
            joined.resize(width.max(start + wide), ' ');
            for (i, c) in letter.iter().enumerate().filter(|(_, c)| **c != ' ') {
                joined[start + i] = *c;
            }
        }
    }
    for hard in joined.iter_mut().flatten().filter(|c| **c == HARD) {
        *hard = ' ';
    }
    let has_ink = |at: &usize| joined.iter().any(|row| row[*at] != ' ');
    let mut columns = 0..joined[0].len();
    // Empty columns at the ends are removed.
    let first = columns.find(has_ink).unwrap_or(columns.end);
    let end = columns
        .rfind(has_ink)
        .map_or(columns.start, |last| last + 1);
    Some(joined.map(|row| row[first..end].to_vec()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ascii_letter_has_strokes_of_the_same_height() {
        assert_eq!(LETTERS.len(), 95);
        for (letter, rows) in (' '..='~').zip(LETTERS.iter()) {
            let inked = rows.iter().flatten().any(|c| ![' ', HARD].contains(c));
            assert_eq!(inked, letter != ' ', "{letter}");
            assert!(
                rows.iter().all(|row| row.len() == rows[0].len()),
                "{letter}"
            );
            assert!(rows.iter().flatten().all(|c| (' '..='~').contains(c)));
        }
    }

    #[test]
    fn words_are_set_in_a_line() {
        let words = ["a", "coin", "of"].map(|word| joined(word).unwrap());
        let line = beside(&words.each_ref());
        let text: Vec<String> = line.iter().map(|row| row.iter().collect()).collect();
        assert_eq!(
            text,
            [
                "                          _",
                " _.    _  _  o ._     _ _|_",
                "(_|   (_ (_) | | |   (_) | ",
                "                           ",
            ]
        );
        assert!(joined("α").is_none());
    }

    #[test]
    fn descenders_and_capitals_share_a_row_unless_they_touch() {
        let line = |word: &str| joined(word).unwrap();
        assert_eq!([rows_of(&line("coin")), rows_of(&line("gap"))], [3, 4]);
        assert_eq!([empty_rows(&line("coin")), empty_rows(&line("25"))], [1, 0]);
        assert_eq!(apart(&line("coin"), &line("To")), 3);
        assert_eq!(apart(&line("pace"), &line("a2")), 3);
        assert_eq!(apart(&line("gap"), &line("250")), 4);
    }
}

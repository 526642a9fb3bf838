//! A screen with its colours as text: its rows, then maps of letters for the foreground, the
//! background and the weight, and a legend that lists the roles and the colour of each letter.
//! Plain text on the background is left blank.

use std::collections::BTreeSet;
use std::fmt::Write;

use carrom::shells::tape::Screenshot;
use carrom::widgets::{Role, Theme};
use ratatui::buffer::Cell;
use ratatui::style::{Color, Modifier};

/// One letter per role, in the order of [`Role::ALL`].
const LETTERS: &str = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
/// The letter for a colour that no role has: a mixture, which is listed separately.
const MIXED: char = '*';

/// The letters for the colours of a screen.
struct Legend {
    theme: Theme,
}

impl Legend {
    /// The letter for a colour: the letter of the first role that has this colour.
    fn letter(&self, colour: Color) -> char {
        let mut roles = Role::ALL.iter().copied().zip(LETTERS.chars());
        let found = roles.find(|(role, _)| self.theme.colour(*role) == colour);
        found.map_or(MIXED, |(_, letter)| letter)
    }

    /// Which roles and which colour a letter stands for.
    fn meaning(&self, letter: char) -> String {
        let roles = Role::ALL.iter().copied().zip(LETTERS.chars());
        let first = roles.clone().find(|(_, other)| *other == letter);
        let colour = self.theme.colour(first.unwrap().0);
        let same = roles.filter(|(role, _)| self.theme.colour(*role) == colour);
        let names: Vec<_> = same.map(|(role, _)| format!("{role:?}")).collect();
        format!("{} {}", hex(colour), names.join(" "))
    }

    /// The letter for the foreground of a cell; blank for plain text.
    fn front(&self, cell: &Cell) -> char {
        if cell.symbol() == " " || cell.fg == self.theme.colour(Role::Text) {
            return ' ';
        }
        self.letter(cell.fg)
    }

    /// The letter for the background of a cell; blank for the usual background.
    fn behind(&self, cell: &Cell) -> char {
        if cell.bg == self.theme.colour(Role::Background) {
            return ' ';
        }
        self.letter(cell.bg)
    }
}

/// The letter for a cell's weight; `+` if it has several.
fn weight(cell: &Cell) -> char {
    match cell.modifier {
        Modifier::BOLD => 'b',
        Modifier::DIM => 'd',
        Modifier::UNDERLINED => 'u',
        Modifier::REVERSED => 'r',
        none if none.is_empty() => ' ',
        _ => '+',
    }
}

fn hex(colour: Color) -> String {
    match colour {
        Color::Rgb(r, g, b) => format!("{r:02x}{g:02x}{b:02x}"),
        other => other.to_string(),
    }
}

/// The screenshot as text, then its colours in `theme`.
pub(crate) fn written(screenshot: &Screenshot, theme: Theme) -> String {
    let legend = Legend { theme };
    let screen = &screenshot.cells;
    let rows: Vec<&[Cell]> = screen.content.chunks(screen.area.width.into()).collect();
    let mut text = screenshot.text();
    let mut used = BTreeSet::new();
    let mut map = |title: &str, letter: &dyn Fn(&Cell) -> char| {
        let _ = writeln!(text, "-- {title} --");
        for (y, cells) in rows.iter().enumerate() {
            let row: String = cells.iter().map(letter).collect();
            let row = row.trim_end();
            if !row.is_empty() {
                let _ = writeln!(text, "{y:2} {row}");
                if title != "weight" {
                    used.extend(row.chars());
                }
            }
        }
    };
    map("drawn", &|cell| legend.front(cell));
    map("behind", &|cell| legend.behind(cell));
    map("weight", &weight);
    text += "-- legend --\n";
    for letter in LETTERS.chars().filter(|letter| used.contains(letter)) {
        let _ = writeln!(text, "{letter} {}", legend.meaning(letter));
    }
    text += "-- mixed: columns drawn/behind --\n";
    for (y, cells) in rows.iter().enumerate() {
        let pair = |cell: &Cell| format!("{}/{}", hex(cell.fg), hex(cell.bg));
        let columns: Vec<_> = (0..cells.len()).collect();
        let runs: Vec<_> = columns
            .chunk_by(|&x, &next| pair(&cells[x]) == pair(&cells[next]))
            .map(|run| (&cells[run[0]], run[0], run[run.len() - 1]))
            .filter(|(cell, ..)| [legend.front(cell), legend.behind(cell)].contains(&MIXED))
            .map(|(cell, first, last)| match last - first {
                0 => format!("{first} {}", pair(cell)),
                _ => format!("{first}-{last} {}", pair(cell)),
            })
            .collect();
        if !runs.is_empty() {
            let _ = writeln!(text, "{y:2} {}", runs.join(", "));
        }
    }
    text
}

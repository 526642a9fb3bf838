//! Tables of comma-separated values. Every table that carrom writes is made here, so that no text
//! from a pupil, a player or a file can act as code in the program that opens the table.

use unicode_width::UnicodeWidthChar;

use super::is_invisible;

/// A table of comma-separated values as in RFC 4180: the headings, then the rows.
///
/// Headings and cells are made safe in the same way. Control characters other than line breaks and
/// tabs are left out, and so are marks that change the direction of text. Text that a spreadsheet
/// would read as a formula is preceded by an apostrophe, which makes it plain text; negative
/// numbers stay unchanged.
///
/// # Errors
/// Returns the reason if a row cannot be written, which does not happen in practice.
pub fn csv_table<'h>(
    heads: impl IntoIterator<Item = &'h str>,
    rows: &[Vec<String>],
) -> Result<String, String> {
    let heads = heads.into_iter().map(safe_cell).collect();
    let rows = { rows.iter() }.map(|row| row.iter().map(|cell| safe_cell(cell)).collect());
    let mut table = csv::Writer::from_writer(Vec::new());
    for record in std::iter::once::<Vec<String>>(heads).chain(rows) {
        table
            .write_record(record)
            .map_err(|error| error.to_string())?;
    }
    let bytes = table.into_inner().map_err(|error| error.to_string())?;
    String::from_utf8(bytes).map_err(|error| error.to_string())
}

/// Text that no spreadsheet reads as a formula and that cannot control a terminal.
///
/// Text that begins like a formula gets an apostrophe before it. So does such text after a
/// line break, a tab or a semicolon, because a spreadsheet may begin a new cell there: in many
/// languages it expects semicolons between cells.
fn safe_cell(text: &str) -> String {
    let visible: String = { text.chars() }
        .filter(|letter| breaks_line(*letter) || !is_invisible(*letter))
        .collect();
    if is_number(&visible) || !visible.contains(is_formula_sign) {
        return visible;
    }
    let mut safe = String::with_capacity(visible.len() + 1);
    let mut begins = true;
    for letter in visible.chars() {
        if begins && is_formula_sign(letter) {
            safe.push('\'');
        }
        // Spreadsheets skip spaces and zero-width characters.
        begins = breaks_line(letter)
            || letter == ';'
            || (begins && (letter.is_whitespace() || letter.width().unwrap_or(0) == 0));
        safe.push(letter);
    }
    safe
}

fn breaks_line(letter: char) -> bool {
    matches!(letter, '\n' | '\r' | '\t')
}

/// Whether a spreadsheet reads the text as a plain number: "-6.1", "1e-5". Rust's parser alone
/// would also accept "+1" and "-inf".
fn is_number(text: &str) -> bool {
    let is_digit =
        |letter: char| letter.is_ascii_digit() || matches!(letter, '.' | 'e' | 'E' | '-');
    text.chars().all(is_digit) && text.parse::<f64>().is_ok()
}

/// Whether a spreadsheet may read a cell that begins with this character as a formula. Spreadsheets
/// in East Asian languages also accept the wide forms of these characters.
fn is_formula_sign(letter: char) -> bool {
    matches!(
        letter,
        '=' | '+' | '-' | '@' | '\t' | '\r' | '＝' | '＋' | '－' | '＠'
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_and_cells_cannot_control_the_program_that_shows_the_table() {
        let hostile = "\u{1b}=cmd|A1\0\u{9b}\u{202e}";
        let written = csv_table([hostile, "b"], &[vec![hostile.into(), "x\ny".into()]]);
        assert_eq!(written.unwrap(), "'=cmd|A1,b\n'=cmd|A1,\"x\ny\"\n");
    }

    #[test]
    fn no_part_of_a_cell_becomes_a_formula_with_other_separators() {
        for (text, written) in [
            ("a;=1+1", "a;'=1+1"),
            ("a\n=1+1;b; @c", "a\n'=1+1;b; '@c"),
            ("a\t-1", "a\t'-1"),
            ("a-b=c", "a-b=c"),
            ("\u{feff}=1", "'=1"),
            ("\u{301}=1", "\u{301}'=1"),
        ] {
            assert_eq!(safe_cell(text), written);
        }
    }

    #[test]
    fn numbers_stay_numbers_and_similar_text_is_escaped() {
        for number in ["-6.1", "0", "12", "1e-5", "-1.5e3"] {
            assert_eq!(safe_cell(number), number);
        }
        for (text, written) in [("+1", "'+1"), ("-inf", "'-inf"), ("-1-1", "'-1-1")] {
            assert_eq!(safe_cell(text), written);
        }
    }
}

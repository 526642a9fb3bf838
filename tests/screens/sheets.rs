//! The texts of screens, recorded while they are drawn, for shells that display more than cells.

use std::collections::BTreeSet;
use std::fmt::Write;

use carrom::app::App;
use carrom::widgets::{Item, Section, Sheet, Words, gather, recorded};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::{Buffer, Cell};
use ratatui::layout::{Position, Rect};

use crate::key_tables::moments;

/// A size in columns and rows at which almost nothing is omitted or scrolled.
const ROOM: (u16, u16) = (160, 100);

/// The drawn cells, the areas of the pictures, and the recorded sheets.
fn drawn(app: &App) -> (Buffer, Vec<Rect>, Vec<Sheet>) {
    let mut terminal = Terminal::new(TestBackend::new(ROOM.0, ROOM.1)).unwrap();
    let ((buffer, pictures), sheets) = recorded(|| {
        gather(false, || {
            let mut frame = terminal.get_frame();
            app.draw(&mut frame);
            frame.buffer_mut().clone()
        })
    });
    let areas = pictures.iter().map(|picture| picture.area()).collect();
    (buffer, areas, sheets)
}

/// The whole text of a sheet, without white space.
fn said(sheet: &Sheet) -> String {
    let mut said = format!("{} {} ", sheet.title, sheet.status);
    for section in &sheet.sections {
        said += &section.title;
        for item in &section.items {
            // Every text of the item, whatever its field is called.
            let json = serde_json::to_value(&item.words).unwrap();
            write_words(&json, &mut said);
        }
    }
    said.retain(|letter| !letter.is_whitespace());
    said
}

fn write_words(json: &serde_json::Value, said: &mut String) {
    match json {
        serde_json::Value::String(words) => write!(said, "{words} ").unwrap(),
        serde_json::Value::Array(all) => all.iter().for_each(|it| write_words(it, said)),
        serde_json::Value::Object(all) => {
            let words = all
                .iter()
                .filter(|(key, _)| !["is", "role"].contains(&key.as_str()));
            words.for_each(|(_, it)| write_words(it, said));
        }
        _ => {}
    }
}

/// The words in the cells outside the pictures, made of letters and digits only: no frames, no
/// shapes.
fn words(buffer: &Buffer, pictures: &[Rect], rows: impl Iterator<Item = u16>) -> Vec<String> {
    let is_word = |letter: char| letter.is_alphanumeric();
    let mut words = Vec::new();
    for row in rows {
        let mut word = String::new();
        for column in 0..buffer.area.width {
            let at = Position::new(column, row);
            let cell = buffer.cell(at).map_or(" ", Cell::symbol);
            let letter = cell.chars().next().unwrap_or(' ');
            match is_word(letter) && !pictures.iter().any(|it| it.contains(at)) {
                true => word.push(letter),
                false => words.push(std::mem::take(&mut word)),
            }
        }
        words.push(word);
    }
    words.retain(|word| !word.is_empty());
    words
}

#[test]
fn the_record_has_every_word_in_the_cells() {
    let mut missing = BTreeSet::new();
    for moment in moments() {
        let mut game = moment.game();
        game.resize(ROOM.0, ROOM.1);
        let (buffer, pictures, sheets) = drawn(game.app());
        let said: String = sheets.iter().map(said).collect();
        // The line of keys and the name of the program are excluded.
        for word in words(&buffer, &pictures, 0..ROOM.1 - 1) {
            let is_chrome = word == "carrom" || word.starts_with("Page");
            // The panel of a measurement is longer than the screen.
            let is_chrome = is_chrome || (moment.name.starts_with("measured") && word == "more");
            // All pages of a step are recorded together, without page numbers.
            let is_page = moment.name.starts_with("class") && (word == "page" || word == "3");
            if !is_chrome && !is_page && !said.contains(&word) {
                missing.insert((moment.name, word));
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

#[test]
fn text_that_is_only_measured_is_not_recorded() {
    for moment in moments() {
        let mut game = moment.game();
        game.resize(ROOM.0, ROOM.1);
        let (.., sheets) = drawn(game.app());
        for section in sheets.iter().flat_map(|sheet| &sheet.sections) {
            for pressed in pressed(section) {
                let there = self::pressed(section).filter(|it| it.press == pressed.press);
                assert_eq!(there.count(), 1, "{}: {pressed:?}", moment.name);
            }
            let texts = section.items.iter().filter(|it| is_long(it));
            for text in texts {
                let same = section.items.iter().filter(|it| *it == text);
                assert_eq!(same.count(), 1, "{}: {text:?}", moment.name);
            }
        }
    }
}

/// The items that can be clicked, except text fields: a field may belong to a choice and share its
/// cell.
fn pressed(section: &Section) -> impl Iterator<Item = &Item> {
    let items = section.items.iter().filter(|item| item.press.is_some());
    items.filter(|item| !matches!(item.words, Words::TextField { .. }))
}

/// Whether a text is so long that it should appear only once.
fn is_long(item: &Item) -> bool {
    let Words::Text { runs, .. } = &item.words else {
        return false;
    };
    runs.iter().map(|run| run.text.len()).sum::<usize>() > 30
}

#[test]
fn nothing_is_recorded_without_a_request_and_the_cells_are_the_same() {
    for moment in moments().step_by(7) {
        let mut game = moment.game();
        game.resize(ROOM.0, ROOM.1);
        let (recorded, ..) = drawn(game.app());
        assert_eq!(&recorded, game.buffer(), "{}", moment.name);
    }
}

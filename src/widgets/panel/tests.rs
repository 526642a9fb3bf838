use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Panel, Writing};
use crate::widgets::cells::text;
use crate::widgets::{Blocks, Charset, Depth, Look, Palette, Role, Theme, recorded};

const LOOK: Look = Look {
    charset: Charset::Ascii,
    blocks: Blocks::Quadrants,
    theme: Theme::new(Palette::Dark, Depth::None),
};

fn key(action: &char) -> Option<String> {
    action.is_lowercase().then(|| action.to_string())
}

const WRITING: Writing<char> = Writing {
    look: LOOK,
    pages: None,
    key: &key,
};

/// An area for `rows` rows of 20 letters, with the margin.
fn place(rows: u16) -> Rect {
    Rect::new(3, 1, 22, rows)
}

fn drawn(panel: &Panel<char>, rows: u16, scrolled: u16) -> Vec<String> {
    let mut buf = Buffer::empty(Rect::new(0, 0, 28, rows + 2));
    let placed = panel.placed(place(rows), &WRITING);
    placed.draw(scrolled, &mut buf, &WRITING);
    text(&buf)
        .lines()
        .map(|row| row.trim().to_owned())
        .collect()
}

#[test]
fn a_text_that_is_too_long_for_its_field_is_shown_up_to_the_cursor() {
    let labelled = |label: &str, typed: (&str, &str), chosen| {
        let mut panel = Panel::new("");
        panel.text_field(label, typed, chosen, None::<char>);
        drawn(&panel, 1, 0).join(" ").trim().to_owned()
    };
    let shown = |before, after, chosen| labelled("code", (before, after), chosen);
    assert_eq!(shown("mixed-7", "", true), "> code    mixed-7_");
    assert_eq!(shown("any-mixed-1234", "", true), "> code    mixed-1234_");
    assert_eq!(shown("many-mixed-", "12", true), "> code    any-mixed-_");
    assert_eq!(shown("any-mixed-1234", "", false), "code    any-mixed-1");
    let long = labelled("south's name ", ("Bartholomew", ""), true);
    assert_eq!(long, "> south's name lomew_");
}

#[test]
fn the_lowest_priority_is_left_out_first_and_never_in_part() {
    let mut panel = Panel::new("");
    panel.line("always", Role::Text);
    panel.worth(1, |panel| {
        panel.gap();
        panel.line("one", Role::Text);
        panel.line("two", Role::Text);
    });
    panel.worth(2, |panel| panel.line("more", Role::Text));
    panel.line("always too", Role::Text);
    let kept = |rows| {
        drawn(&panel, rows, 0)
            .join(" ")
            .split_whitespace()
            .map(str::to_owned)
            .collect::<Vec<_>>()
            .join(" ")
    };
    assert_eq!(kept(2), "always always too");
    assert_eq!(kept(3), "always more always too");
    assert_eq!(kept(5), "always more always too");
    assert_eq!(kept(6), "always one two more always too");
}

#[test]
fn adjacent_gaps_are_merged_and_there_is_none_at_the_top() {
    let mut panel = Panel::new("");
    panel.worth(1, |panel| panel.line("gone with this row", Role::Text));
    panel.gap();
    panel.gap();
    panel.line("one", Role::Text);
    panel.gap();
    panel.worth(1, |panel| panel.line("and this", Role::Text));
    panel.gap();
    panel.line("two", Role::Text);
    assert_eq!(drawn(&panel, 6, 0)[1..4], ["one", "", "two"]);
}

#[test]
fn a_click_on_a_field_or_a_prompt_carries_out_its_action() {
    let mut panel = Panel::new("");
    panel.field("mass", ("5.5 g", false), (Role::Text, true), Some('m'));
    panel.prompts([("weigh it", 'w'), ("leave it alone", 'l')]);
    assert_eq!(
        drawn(&panel, 4, 0)[1..4],
        ["> mass         5.5 g", "w: weigh it. l:", "leave it alone."]
    );
    let placed = panel.placed(place(4), &WRITING);
    let at = |x, y| {
        let mut targets = placed.targets(0);
        targets.find_map(|(cells, action)| {
            cells
                .contains((x, y).into())
                .then(|| panel.action(action))?
        })
    };
    assert_eq!(
        [at(4, 1), at(24, 1), at(25, 1)],
        [Some('m'), Some('m'), None]
    );
    assert_eq!(
        [at(4, 2), at(15, 2), at(17, 2)],
        [Some('w'), Some('w'), Some('l')]
    );
    assert_eq!(
        [at(4, 3), at(18, 3), at(19, 3)],
        [Some('l'), Some('l'), None]
    );
    assert_eq!(at(4, 4), None);
}

#[test]
fn the_chosen_row_stays_visible_and_rows_scrolled_away_cannot_be_clicked() {
    let mut panel = Panel::new("");
    for c in 'a'..='f' {
        let chosen = c == 'e';
        panel.row((c.to_string(), Role::Text), ("", Role::Text), chosen, c);
    }
    let placed = panel.placed(place(3), &WRITING);
    assert_eq!((placed.overflow(), placed.following()), (3, 3));
    let seen: String = placed
        .targets(2)
        .filter_map(|(_, action)| panel.action(action))
        .collect();
    assert_eq!(seen, "cde");
}

#[test]
fn a_long_text_names_the_key_for_the_rest() {
    let mut panel = Panel::<char>::new("");
    panel.paragraph("one two three four five six seven", Role::Text);
    let mut buf = Buffer::empty(Rect::new(0, 0, 28, 3));
    let writing = Writing {
        pages: Some(["b".into(), "n".into()]),
        ..WRITING
    };
    for (scrolled, hint) in [(0, "n: more"), (1, "b: back")] {
        panel
            .placed(place(1), &writing)
            .draw(scrolled, &mut buf, &writing);
        assert!(text(&buf).contains(hint), "{}", text(&buf));
    }
}

#[test]
fn a_block_pinned_below_stays_there_and_can_be_clicked() {
    let mut panel = Panel::new("");
    for c in 'a'..='j' {
        panel.row((c.to_string(), Role::Text), ("", Role::Text), c == 'j', c);
    }
    panel.pin_below();
    panel.prompt("open it", 'o');
    assert_eq!(drawn(&panel, 14, 0)[10..13], ["> j", "", "o: open it."]);
    assert_eq!(drawn(&panel, 9, 3)[7..10], ["> j", "", "o: open it."]);
    let placed = panel.placed(place(9), &WRITING);
    assert_eq!(placed.overflow(), 3);
    let clicked = |row: u16| {
        let mut targets = placed.targets(placed.following());
        let hit = targets.find(|(cells, _)| cells.contains((5, row).into()));
        hit.and_then(|(_, at)| panel.action(at))
    };
    assert_eq!(clicked(1), Some('d'));
    assert_eq!(clicked(7), Some('j'));
    assert_eq!(clicked(8), None);
    assert_eq!(clicked(9), Some('o'));
}

#[test]
fn a_name_in_a_scrolled_grid_is_recorded_at_the_cell_where_it_is_seen() {
    let mut panel = Panel::new("");
    for _ in 0..3 {
        panel.line("text", Role::Text);
    }
    panel.grid([(["Ada".into(), String::new()], 'a')], None);
    panel.line("text", Role::Text);
    let placed = panel.placed(place(3), &WRITING);
    let mut buf = Buffer::empty(place(3));
    let ((), sheets) = recorded(|| placed.draw(2, &mut buf, &WRITING));
    let items = sheets.iter().flat_map(|sheet| &sheet.sections);
    let [x, y] = { items.flat_map(|section| &section.items) }
        .find_map(|item| item.press)
        .unwrap();
    let (cells, _) = placed.targets(2).next().unwrap();
    assert!(cells.contains((x, y).into()), "{cells} {x} {y}");
}

//! How the first screen looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::suggestion::is_new;
use super::{ENTRIES, Home};
use crate::screens::Context;
use crate::widgets::flow::Run;
use crate::widgets::input::ListView;
use crate::widgets::panels::draw_panel;
use crate::widgets::{Charset, Lines, Role, Room, Words, areas, text};

/// Columns of the menu.
const MENU: u16 = 42;
/// The same where there is no room for what each line is about.
const NARROW: u16 = 31;
const WIDE: u16 = 78;
/// Rows above the first choice.
const HEAD_ROWS: u16 = 3;
/// Columns of an entry's key and name.
const NAME: usize = 15;

/// Where the picture's frame and the menu are.
fn layout(room: Room) -> [Rect; 2] {
    let menu = match room.area.width < WIDE {
        true => NARROW,
        false => MENU,
    };
    areas::picture_and_panel(room, menu)
}

/// Which line of the menu stands at this cell.
pub(super) fn choice_at(home: &Home, cx: &Context, cell: (u16, u16)) -> Option<usize> {
    let [_, menu] = layout(cx.room());
    let rows = Rows::new(home, cx, menu);
    let row = ListView::row_at(menu, cell)?;
    (0..home.lines(cx)).find(|line| row == usize::from(rows.of(*line)))
}

/// On which rows of the menu its lines stand.
struct Rows {
    suggested: u16,
    /// Rows from one entry to the next.
    each: u16,
}

impl Rows {
    fn new(home: &Home, cx: &Context, menu: Rect) -> Self {
        let suggested = home.suggestions(cx).len() as u16;
        let room = menu
            .height
            .saturating_sub(HEAD_ROWS + suggested + STEPS_ROWS);
        Self {
            suggested,
            each: if room > 2 * ENTRIES.len() as u16 {
                2
            } else {
                1
            },
        }
    }

    /// The row of a line, counted from the first suggestion on.
    fn of(&self, line: usize) -> u16 {
        let line = line as u16;
        match line.checked_sub(self.suggested) {
            None => HEAD_ROWS + line,
            Some(entry) => {
                let gap = u16::from(self.suggested > 0);
                HEAD_ROWS + self.suggested + gap + self.each * entry
            }
        }
    }
}

/// Draws the menu beside a hit.
pub(super) fn draw(home: &Home, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let [picture, menu] = layout(cx.room());
    let title = "a glancing hit";
    let inside = draw_panel(buf, picture, title, look.charset, &look.theme);
    home.picture.picture(inside).draw(buf, &look);
    let chosen = home.list.chosen(home.lines(cx));
    let rows = Rows::new(home, cx, menu);
    let mut lines = Lines::new(menu, buf, look);
    lines.line("Aim. Say where both will go.", Role::Text);
    lines.line("Then watch the exact hit, and why.", Role::Text);
    let suggested = home.suggestions(cx).into_iter();
    let suggested = suggested.map(|it| (it.key(), it.text(), ""));
    let entries = ENTRIES.iter();
    let entries = entries.map(|it| (it.key, it.name.to_owned(), it.about));
    for (i, (key, name, about)) in suggested.chain(entries).enumerate() {
        while lines.written() < rows.of(i) {
            lines.line("", Role::Text);
        }
        let suggestion = i < usize::from(rows.suggested);
        let role = if suggestion { Role::Key } else { Role::Text };
        let recorded = |charset: Charset| Words::Pair {
            name: Run::new(name.clone(), role).spelt(charset),
            value: Run::new(about, Role::Dim).spelt(charset),
        };
        lines.clicked_as(recorded, Some(i == chosen), |lines| {
            let (mark, role) = role.of_choice(i == chosen);
            let name = format!("{mark} {key}  {name}");
            let room = usize::from(lines.width()).saturating_sub(NAME);
            match text::width(about) <= room && !about.is_empty() {
                true => lines.line(&format!("{name:NAME$}{about}"), role),
                false => lines.line(&name, role),
            }
        });
    }
    if !is_new(&home.history, &cx.book) {
        return;
    }
    let whole = lines.rows_by(first_steps);
    if lines.left() > whole {
        lines.gap();
        first_steps(&mut lines);
    } else if lines.left() > 1 {
        lines.gap();
        lines.line("New here? Press l, then Enter.", Role::Key);
    }
}

/// Rows of [`first_steps`] where it has the least room, with a gap above it.
const STEPS_ROWS: u16 = 7;

/// The way for someone who is here for the first time.
fn first_steps(lines: &mut Lines) {
    lines.line("New here? Three steps:", Role::Key);
    let steps = [
        (
            "1. ",
            "l for the lab, then Enter: say where both will go, and watch.",
        ),
        (
            "2. ",
            "Esc until you are back, then b: see what you believe.",
        ),
        ("3. ", "e for Learn: begin with the chapter it names."),
    ];
    for (number, step) in steps {
        lines.hanging(number, step, Role::Text);
    }
}

//! A list with one line selected, shared by the screens so that all lists behave in the same way.

use strum::{EnumMessage, IntoStaticStr};

use super::{KeyTable, Outcome};
use crate::messages::Key;

/// The number of lines by which a page key moves the selection.
const PAGE: isize = 10;

/// What the keys do on a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum ListAction {
    /// choose a line
    Choose(isize),
    /// go ten lines up or down
    Page(isize),
    /// go to the first or the last line
    End(isize),
    /// open the chosen line
    Open,
    /// choose this line; open it if it is already chosen
    Point(usize),
}

/// The selected line of a list. The selection does not wrap around.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct ListView {
    at: usize,
}

impl ListView {
    /// Creates a list in which the line with this index is selected.
    pub(crate) const fn at(at: usize) -> Self {
        Self { at }
    }

    /// The index of the selected line; 0 if there are no lines.
    pub(crate) fn chosen(&self, lines: usize) -> usize {
        self.at.min(lines.saturating_sub(1))
    }

    /// Selects a line.
    pub(crate) fn choose(&mut self, at: usize) {
        self.at = at;
    }

    /// The keys that move the selection and open the selected line; `open` is the label for
    /// opening.
    pub(crate) fn keys(open: &'static str) -> KeyTable<ListAction> {
        use ListAction::{Choose, End, Open, Page};
        KeyTable::new("list")
            .by([Key::Up, Key::Down], Choose, [-1, 1], "choose")
            .or([(Key::BackTab, Choose(-1)), (Key::Tab, Choose(1))])
            .on(Key::Enter, Open, open)
            .or([(Key::Char(' '), Open)])
            .by([Key::PageUp, Key::PageDown], Page, [-1, 1], "")
            .by([Key::Home, Key::End], End, [-1, 1], "")
    }

    /// Like [`Self::keys`], for a list in which some lines are text fields: in such a line
    /// (`is_text`), Home and End move the cursor to the ends of the text.
    pub(crate) fn keys_of_form(open: &'static str, is_text: bool) -> KeyTable<ListAction> {
        let ends: &[Key] = if is_text { &[Key::Home, Key::End] } else { &[] };
        Self::keys(open).without_keys(ends)
    }

    /// Carries out an action in a list of `lines` lines; returns `Done` with the index of the line
    /// to open.
    pub(crate) fn act(&mut self, action: ListAction, lines: usize) -> Outcome<usize> {
        match action {
            ListAction::Choose(by) => self.go(by, lines),
            ListAction::Page(by) => self.go(by * PAGE, lines),
            ListAction::End(by) => self.go(by.saturating_mul(isize::MAX), lines),
            ListAction::Open if lines > 0 => return Outcome::Done(self.chosen(lines)),
            ListAction::Open => {}
            ListAction::Point(line) if line == self.chosen(lines) => return Outcome::Done(line),
            ListAction::Point(line) => self.at = line,
        }
        Outcome::Used
    }

    fn go(&mut self, by: isize, lines: usize) {
        self.at = self.chosen(lines).saturating_add_signed(by);
        self.at = self.chosen(lines);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(list: &mut ListView, key: Key, lines: usize) -> Outcome<usize> {
        let action = ListView::keys("open").find(key);
        action.map_or(Outcome::Ignored, |action| list.act(action, lines))
    }

    #[test]
    fn the_mark_stops_at_the_ends() {
        let mut list = ListView::default();
        for (key, at) in [
            (Key::Up, 0),
            (Key::Down, 1),
            (Key::PageDown, 11),
            (Key::End, 24),
            (Key::Down, 24),
            (Key::PageUp, 14),
            (Key::Home, 0),
        ] {
            assert_eq!(press(&mut list, key, 25), Outcome::Used);
            assert_eq!(list.chosen(25), at, "{key}");
        }
    }

    #[test]
    fn enter_and_space_open_the_chosen_line_if_there_is_one() {
        let mut list = ListView::at(7);
        assert_eq!(press(&mut list, Key::Enter, 9), Outcome::Done(7));
        assert_eq!(press(&mut list, Key::Char(' '), 3), Outcome::Done(2));
        assert_eq!(press(&mut list, Key::Enter, 0), Outcome::Used);
    }

    #[test]
    fn a_click_chooses_and_then_opens() {
        let mut list = ListView::default();
        assert_eq!(list.act(ListAction::Point(3), 5), Outcome::Used);
        assert_eq!(list.act(ListAction::Point(3), 5), Outcome::Done(3));
    }
}

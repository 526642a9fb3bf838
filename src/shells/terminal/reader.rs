//! Reads the keyboard and the mouse.

use std::io;

use crossterm::event::{
    Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers, MouseButton, MouseEvent, MouseEventKind,
};

use super::message::{Inbox, Message};
use super::spawn;
#[cfg(unix)]
use super::tty::Tty;
use crate::messages::{Input, Key, Mouse, MouseKind};

/// Starts the reading thread. It ends when the process ends or the terminal is closed.
pub(super) fn start(inbox: Inbox) -> io::Result<()> {
    #[cfg(unix)]
    let mut source = Tty::open()?;
    #[cfg(unix)]
    let mut next = move || source.next();
    #[cfg(not(unix))]
    let next = || crossterm::event::read().map(|event| message(&event));
    let read = move || {
        loop {
            let message = next().unwrap_or_else(|error| Some(Message::Lost(error)));
            let is_last = matches!(message, Some(Message::Lost(_)));
            // A send fails only when carrom is quitting anyway.
            if message.is_some_and(|it| !inbox.send(it)) || is_last {
                return;
            }
        }
    };
    spawn("reader", read).map(drop)
}

/// The message for an event; `None` if carrom ignores the event.
pub(super) fn message(event: &Event) -> Option<Message> {
    let input = match event {
        Event::Key(event) => match key(event)? {
            // In raw mode the terminal does not handle Ctrl+Z itself.
            #[cfg(unix)]
            Key::Ctrl('z') => return Some(Message::Stop),
            key => Input::Key(key),
        },
        Event::Mouse(event) => Input::Mouse(mouse(event)?),
        Event::Paste(text) => Input::Paste(text.clone()),
        // On systems with signals, a signal reports the new size.
        Event::Resize(columns, rows) if cfg!(windows) => Input::Resize(*columns, *rows),
        Event::Resize(..) | Event::FocusGained | Event::FocusLost => return None,
    };
    Some(Message::Input(input))
}

/// The key that was pressed or repeated.
fn key(event: &KeyEvent) -> Option<Key> {
    let held = event.modifiers;
    // AltGr, which types characters, is reported as Control and Alt together on
    // Windows.
    let typed = held.contains(KeyModifiers::CONTROL | KeyModifiers::ALT) && cfg!(windows);
    let foreign =
        KeyModifiers::ALT | KeyModifiers::SUPER | KeyModifiers::HYPER | KeyModifiers::META;
    if event.kind == KeyEventKind::Release || (held.intersects(foreign) && !typed) {
        return None;
    }
    let control = held.contains(KeyModifiers::CONTROL) && !typed;
    Some(match event.code {
        KeyCode::Char(c) if control => {
            let letter = c.to_ascii_lowercase();
            return letter.is_ascii_lowercase().then_some(Key::Ctrl(letter));
        }
        KeyCode::Char(c) if c.is_control() => return None,
        KeyCode::Char(c) => Key::Char(c),
        KeyCode::Up => Key::Up,
        KeyCode::Down => Key::Down,
        KeyCode::Left => Key::Left,
        KeyCode::Right => Key::Right,
        KeyCode::Enter => Key::Enter,
        KeyCode::Esc => Key::Escape,
        KeyCode::Tab if held.contains(KeyModifiers::SHIFT) => Key::BackTab,
        KeyCode::Tab => Key::Tab,
        KeyCode::BackTab => Key::BackTab,
        KeyCode::Backspace => Key::Backspace,
        KeyCode::Delete => Key::Delete,
        KeyCode::PageUp => Key::PageUp,
        KeyCode::PageDown => Key::PageDown,
        KeyCode::Home => Key::Home,
        KeyCode::End => Key::End,
        KeyCode::F(n) => Key::F(n),
        _ => return None,
    })
}

fn mouse(event: &MouseEvent) -> Option<Mouse> {
    let kind = match event.kind {
        MouseEventKind::Down(MouseButton::Left) => MouseKind::Down,
        MouseEventKind::Drag(MouseButton::Left) => MouseKind::Drag,
        MouseEventKind::Up(MouseButton::Left) => MouseKind::Up,
        MouseEventKind::ScrollUp => MouseKind::ScrollUp,
        MouseEventKind::ScrollDown => MouseKind::ScrollDown,
        _ => return None,
    };
    Some(Mouse::over(kind, (event.column, event.row)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pressed(code: KeyCode, held: KeyModifiers) -> Option<Key> {
        key(&KeyEvent::new(code, held))
    }

    #[test]
    fn keys_are_translated() {
        use KeyModifiers as M;
        for (code, held, expected) in [
            (KeyCode::Char('a'), M::NONE, Some(Key::Char('a'))),
            (KeyCode::Char('A'), M::SHIFT, Some(Key::Char('A'))),
            (KeyCode::Char('ä'), M::NONE, Some(Key::Char('ä'))),
            (KeyCode::Char('c'), M::CONTROL, Some(Key::Ctrl('c'))),
            (
                KeyCode::Char('C'),
                M::CONTROL | M::SHIFT,
                Some(Key::Ctrl('c')),
            ),
            (KeyCode::Char(' '), M::CONTROL, None),
            (KeyCode::Char('\0'), M::NONE, None),
            (KeyCode::Char('a'), M::ALT, None),
            (KeyCode::Left, M::SHIFT, Some(Key::Left)),
            (KeyCode::BackTab, M::SHIFT, Some(Key::BackTab)),
            (KeyCode::Tab, M::SHIFT, Some(Key::BackTab)),
            (KeyCode::F(5), M::NONE, Some(Key::F(5))),
            (KeyCode::Insert, M::NONE, None),
        ] {
            assert_eq!(pressed(code, held), expected, "{code:?} {held:?}");
        }
    }

    #[test]
    fn a_repeated_key_is_a_press_but_a_released_key_is_not() {
        let with = |kind| {
            key(&KeyEvent::new_with_kind(
                KeyCode::Up,
                KeyModifiers::NONE,
                kind,
            ))
        };
        assert_eq!(with(KeyEventKind::Release), None);
        assert_eq!(with(KeyEventKind::Repeat), Some(Key::Up));
    }

    #[test]
    fn only_the_main_button_and_the_wheel_are_used() {
        let with = |kind| {
            mouse(&MouseEvent {
                kind,
                column: 3,
                row: 4,
                modifiers: KeyModifiers::NONE,
            })
        };
        let down = with(MouseEventKind::Down(MouseButton::Left));
        let expected = Mouse::over(MouseKind::Down, (3, 4));
        assert_eq!(down, Some(expected));
        assert_eq!(with(MouseEventKind::Down(MouseButton::Right)), None);
        assert_eq!(with(MouseEventKind::Moved), None);
    }
}

//! Decodes the bytes from a terminal into events.
//!
//! crossterm can do this too, but it holds back a paste until its end. A paste that never ends
//! (because its end was lost, or a program wrote its beginning to the screen) then grows without
//! limit and blocks every key, including Ctrl+C. Here a paste is truncated at a generous length,
//! Ctrl+C works within it, and it ends when no more bytes arrive.

use std::collections::VecDeque;
use std::time::Duration;

use crossterm::event::{
    Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers, MouseButton, MouseEvent, MouseEventKind,
};

/// The largest number of bytes of a paste that are used. No input field can hold more.
pub(super) const LARGEST_PASTE: usize = 1 << 16;
/// The marker at the start of a paste, without its control sequence introducer, and the marker at
/// the end.
const PASTE: &[u8] = b"200~";
const PASTE_END: &[u8] = b"\x1b[201~";
/// The largest number of bytes of a control sequence that are kept. The longest sequence that a
/// terminal sends has about 20 bytes.
const LONGEST_SEQUENCE: usize = 64;
/// How long a single Escape waits for more bytes. Every sequence begins with Escape, and a slow
/// connection may split a sequence.
const AFTER_ESCAPE: Duration = Duration::from_millis(10);
/// The pause in a paste after which the paste counts as ended.
const WITHIN_PASTE: Duration = Duration::from_secs(1);
/// The pause in a control string after which it counts as cut off. A terminal sends the string in
/// one piece, but a slow connection may split it.
const WITHIN_STRING: Duration = Duration::from_millis(100);
/// The start of the control string with the terminal's name and version, after its introducer.
const VERSION: &[u8] = b">|";

const ESCAPE: u8 = 0x1b;
const CTRL_C: u8 = 0x03;

/// Decodes bytes, and holds those of an incomplete sequence.
#[derive(Debug, Default)]
pub(super) struct Decoder {
    /// The bytes of a character or of a control sequence.
    pending: Vec<u8>,
    paste: Option<Paste>,
    string: Option<ControlString>,
    /// The name and version that the terminal has reported.
    version: Option<String>,
}

/// A paste that has not ended yet.
#[derive(Debug, Default)]
struct Paste {
    text: Vec<u8>,
    /// Whether the rest of the paste is dropped.
    is_over: bool,
    /// How many of the last bytes match the start of the end marker.
    ending: usize,
}

/// A device control string that has not ended yet.
#[derive(Debug, Default)]
struct ControlString {
    /// The first bytes of the string.
    text: Vec<u8>,
    /// Whether the last byte was Escape, which begins the end marker.
    is_ending: bool,
}

impl Decoder {
    /// The name and version that the terminal has reported since the last call.
    pub(super) fn take_version(&mut self) -> Option<String> {
        self.version.take()
    }

    /// How long to wait for more bytes before calling [`Self::pause`]; `None` means for ever.
    pub(super) fn patience(&self) -> Option<Duration> {
        match (&self.paste, &self.string) {
            (Some(_), _) => Some(WITHIN_PASTE),
            (_, Some(_)) => Some(WITHIN_STRING),
            _ => (!self.pending.is_empty()).then_some(AFTER_ESCAPE),
        }
    }

    /// Records that nothing has arrived for [`Self::patience`].
    pub(super) fn pause(&mut self, events: &mut VecDeque<Event>) {
        if let Some(paste) = self.paste.take() {
            paste.end(events);
        } else if *self.pending == [ESCAPE] {
            events.push_back(pressed(KeyCode::Esc, KeyModifiers::NONE));
        }
        self.string = None;
        self.pending.clear();
    }

    /// Handles bytes, and adds the completed events to `events`.
    pub(super) fn feed(&mut self, bytes: &[u8], events: &mut VecDeque<Event>) {
        for byte in bytes {
            match &mut self.paste {
                Some(paste) => {
                    if paste.take(*byte, events) {
                        self.paste = None;
                    }
                }
                None if self.string.is_some() => self.take_in_string(*byte, events),
                None => self.take(*byte, events),
            }
        }
    }

    fn take_in_string(&mut self, byte: u8, events: &mut VecDeque<Event>) {
        let Some(string) = &mut self.string else {
            return;
        };
        match byte {
            b'\\' if string.is_ending => {
                // A longer string is not a version.
                if string.text.len() < LONGEST_SEQUENCE
                    && let Some(version) = string.text.strip_prefix(VERSION)
                {
                    self.version = String::from_utf8(version.to_vec()).ok();
                }
                self.string = None;
            }
            ESCAPE if !string.is_ending => string.is_ending = true,
            0x20.. if !string.is_ending => {
                if string.text.len() < LONGEST_SEQUENCE {
                    string.text.push(byte);
                }
            }
            // The string was cut off. After Escape, another sequence begins; otherwise a key follows.
            _ => {
                let is_sequence = string.is_ending && byte >= 0x20;
                self.pending.extend(is_sequence.then_some(ESCAPE));
                self.string = None;
                self.take(byte, events);
            }
        }
    }

    fn take(&mut self, byte: u8, events: &mut VecDeque<Event>) {
        let is_whole = match self.pending.as_slice() {
            [] => byte < 0x80 && byte != ESCAPE,
            [ESCAPE] if byte == ESCAPE => {
                // The first Escape was a separate key.
                events.push_back(pressed(KeyCode::Esc, KeyModifiers::NONE));
                return;
            }
            [ESCAPE] if byte == b'P' => {
                self.pending.clear();
                self.string = Some(ControlString::default());
                return;
            }
            [ESCAPE] => byte < 0x80 && byte != b'[' && byte != b'O',
            [ESCAPE, b'O'] if byte >= 0x20 => true,
            // An old mouse report: three bytes follow, which need not be ASCII.
            [ESCAPE, b'[', b'M', rest @ ..] if byte >= 0x20 => rest.len() == 2,
            // Function keys of the Linux console.
            [ESCAPE, b'[', b'['] if byte >= 0x20 => true,
            [ESCAPE, b'['] if byte == b'[' || byte == b'M' => false,
            [ESCAPE, b'[', ..] if (0x20..0x7f).contains(&byte) => byte >= 0x40,
            // A character of several bytes, possibly after Escape, or invalid bytes.
            pending => {
                let letter = pending.strip_prefix(&[ESCAPE]).unwrap_or(pending);
                let length = letter
                    .first()
                    .map_or(1, |first| first.leading_ones() as usize);
                let is_in_letter = !letter.starts_with(b"[") && byte & 0xc0 == 0x80;
                if is_in_letter || letter.is_empty() {
                    letter.len() + 1 >= length
                } else {
                    self.pending.clear();
                    return self.take(byte, events);
                }
            }
        };
        if self.pending.len() < LONGEST_SEQUENCE {
            self.pending.push(byte);
        } else if is_whole {
            // The bytes cannot be decoded.
            self.pending.clear();
            return;
        }
        if !is_whole {
            return;
        }
        match self.pending.strip_prefix(b"\x1b[") {
            Some(PASTE) => self.paste = Some(Paste::default()),
            Some(sequence) => events.extend(control_sequence(sequence)),
            None => events.extend(letter(&self.pending, KeyModifiers::NONE)),
        }
        self.pending.clear();
    }
}

impl Paste {
    /// Adds a byte; returns whether it was the last byte of the paste.
    fn take(&mut self, byte: u8, events: &mut VecDeque<Event>) -> bool {
        if byte == CTRL_C {
            // Ctrl+C within a paste discards the paste.
            events.push_back(pressed(KeyCode::Char('c'), KeyModifiers::CONTROL));
            self.text.clear();
            self.is_over = true;
        }
        if PASTE_END.get(self.ending) == Some(&byte) {
            self.ending += 1;
            if self.ending == PASTE_END.len() {
                std::mem::take(self).end(events);
                return true;
            }
            return false;
        }
        let so_far = std::mem::take(&mut self.ending);
        self.add(PASTE_END.get(..so_far).unwrap_or_default(), events);
        match byte {
            ESCAPE => self.ending = 1,
            byte => self.add(&[byte], events),
        }
        false
    }

    fn add(&mut self, bytes: &[u8], events: &mut VecDeque<Event>) {
        if !self.is_over {
            self.text.extend_from_slice(bytes);
            if self.text.len() >= LARGEST_PASTE {
                std::mem::take(self).end(events);
                self.is_over = true;
            }
        }
    }

    /// Sends the pasted text as an event.
    fn end(self, events: &mut VecDeque<Event>) {
        if !self.is_over {
            let text = self.text.get(..LARGEST_PASTE).unwrap_or(&self.text);
            // The limit may have split a character.
            let whole = match str::from_utf8(text) {
                Err(error) if error.error_len().is_none() => error.valid_up_to(),
                _ => text.len(),
            };
            let text = text.get(..whole).unwrap_or_default();
            events.push_back(Event::Paste(String::from_utf8_lossy(text).into_owned()));
        }
    }
}

fn pressed(code: KeyCode, held: KeyModifiers) -> Event {
    Event::Key(KeyEvent::new(code, held))
}

/// A key without a control sequence: a character, a control character, either of these after Escape
/// (which means Alt), or a sequence of Escape, O and one more byte.
fn letter(bytes: &[u8], held: KeyModifiers) -> Option<Event> {
    let code = match bytes {
        [ESCAPE, b'O', last] => cursor_key(*last)?,
        [ESCAPE, rest @ ..] => return letter(rest, held | KeyModifiers::ALT),
        [b'\r'] => KeyCode::Enter,
        [b'\t'] => KeyCode::Tab,
        [0x7f] => KeyCode::Backspace,
        [control @ 0x01..=0x1a] => {
            let letter = char::from(control - 1 + b'a');
            return Some(pressed(KeyCode::Char(letter), held | KeyModifiers::CONTROL));
        }
        [0x00 | 0x1c..=0x1f] => return None,
        bytes => KeyCode::Char(str::from_utf8(bytes).ok()?.chars().next()?),
    };
    Some(pressed(code, held))
}

/// The key given by the last byte of a sequence without a key number.
fn cursor_key(last: u8) -> Option<KeyCode> {
    Some(match last {
        b'A' => KeyCode::Up,
        b'B' => KeyCode::Down,
        b'C' => KeyCode::Right,
        b'D' => KeyCode::Left,
        b'F' => KeyCode::End,
        b'H' => KeyCode::Home,
        b'P'..=b'S' => KeyCode::F(last - b'P' + 1),
        _ => return None,
    })
}

/// The event of a control sequence, given without its introducer: `A`, `1;5A`, `3~`, `<0;12;7M`.
fn control_sequence(sequence: &[u8]) -> Option<Event> {
    if let [b'M', button, column, row] = sequence {
        let [button, column, row] = [button, column, row].map(|it| it.saturating_sub(32));
        return mouse(button, column.into(), row.into(), false);
    }
    if let [b'[', last @ b'A'..=b'E'] = sequence {
        return Some(pressed(KeyCode::F(last - b'A' + 1), KeyModifiers::NONE));
    }
    let (last, numbers) = sequence.split_last()?;
    let numbers = str::from_utf8(numbers).ok()?;
    if matches!(last, b'M' | b'm') {
        let report = numbers.strip_prefix('<');
        let mut numbers = report.unwrap_or(numbers).split(';');
        let mut next = || numbers.next()?.parse::<u16>().ok();
        let button = u8::try_from(next()?).ok()?;
        let button = match report {
            Some(_) => button,
            None => button.checked_sub(32)?,
        };
        return mouse(button, next()?, next()?, *last == b'm');
    }
    let mut numbers = numbers.split(';');
    let first = numbers.next().unwrap_or_default();
    let (held, kind) = held(numbers.next().unwrap_or_default());
    let code = match last {
        b'~' => numbered_key(first.parse().ok()?)?,
        b'u' => match char::from_u32(first.split(':').next()?.parse().ok()?)? {
            '\x1b' => KeyCode::Esc,
            '\r' => KeyCode::Enter,
            '\t' => KeyCode::Tab,
            '\x7f' => KeyCode::Backspace,
            letter => KeyCode::Char(letter),
        },
        b'Z' => KeyCode::BackTab,
        // With numbers, this sequence reports the cursor's position.
        b'R' if !first.is_empty() => return None,
        last => cursor_key(*last)?,
    };
    Some(Event::Key(KeyEvent::new_with_kind(code, held, kind)))
}

fn numbered_key(number: u8) -> Option<KeyCode> {
    Some(match number {
        1 | 7 => KeyCode::Home,
        2 => KeyCode::Insert,
        3 => KeyCode::Delete,
        4 | 8 => KeyCode::End,
        5 => KeyCode::PageUp,
        6 => KeyCode::PageDown,
        11..=15 => KeyCode::F(number - 10),
        17..=21 => KeyCode::F(number - 11),
        23..=26 => KeyCode::F(number - 12),
        28 | 29 => KeyCode::F(number - 15),
        31..=34 => KeyCode::F(number - 17),
        _ => return None,
    })
}

/// The modifiers of a key, as a bit set plus one, and whether it was pressed, repeated or released:
/// `5`, `1:3`.
fn held(number: &str) -> (KeyModifiers, KeyEventKind) {
    const BITS: [KeyModifiers; 6] = [
        KeyModifiers::SHIFT,
        KeyModifiers::ALT,
        KeyModifiers::CONTROL,
        KeyModifiers::SUPER,
        KeyModifiers::HYPER,
        KeyModifiers::META,
    ];
    let (held, kind) = number.split_once(':').unwrap_or((number, ""));
    let bits = held.parse::<u8>().unwrap_or_default().saturating_sub(1);
    let is_held = |(place, _): &(usize, KeyModifiers)| bits >> place & 1 == 1;
    let held = BITS.into_iter().enumerate().filter(is_held);
    let held = held.map(|(_, modifier)| modifier).collect();
    let kind = match kind {
        "2" => KeyEventKind::Repeat,
        "3" => KeyEventKind::Release,
        _ => KeyEventKind::Press,
    };
    (held, kind)
}

/// The mouse event with these report bits: two for the button, three for the modifier keys, one for
/// a move, two more for the button. Columns and rows are counted from 1.
fn mouse(bits: u8, column: u16, row: u16, is_released: bool) -> Option<Event> {
    let is_moved = bits & 0x20 != 0;
    let kind = match (bits & 0x03) | ((bits & 0xc0) >> 4) {
        0 if is_released => MouseEventKind::Up(MouseButton::Left),
        0 if is_moved => MouseEventKind::Drag(MouseButton::Left),
        0 => MouseEventKind::Down(MouseButton::Left),
        // Old reports do not say which button was released.
        3 if !is_moved => MouseEventKind::Up(MouseButton::Left),
        4 if !is_moved => MouseEventKind::ScrollUp,
        5 if !is_moved => MouseEventKind::ScrollDown,
        // Other buttons, and moves without a button, are ignored.
        _ => return None,
    };
    Some(Event::Mouse(MouseEvent {
        kind,
        column: column.checked_sub(1)?,
        row: row.checked_sub(1)?,
        modifiers: KeyModifiers::NONE,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(chunks: &[&[u8]]) -> Vec<Event> {
        let (mut decoder, mut events) = (Decoder::default(), VecDeque::new());
        for chunk in chunks {
            decoder.feed(chunk, &mut events);
        }
        if decoder.patience().is_some() {
            decoder.pause(&mut events);
        }
        assert_eq!(decoder.patience(), None);
        events.into()
    }

    fn key(code: KeyCode) -> Event {
        pressed(code, KeyModifiers::NONE)
    }

    #[test]
    fn keys_are_decoded_from_whole_sequences_and_from_single_bytes() {
        let held = |code, held| pressed(code, held);
        let (control, shift) = (KeyModifiers::CONTROL, KeyModifiers::SHIFT);
        for (bytes, expected) in [
            ("a", key(KeyCode::Char('a'))),
            ("A", key(KeyCode::Char('A'))),
            ("ä", key(KeyCode::Char('ä'))),
            ("球", key(KeyCode::Char('球'))),
            ("😀", key(KeyCode::Char('😀'))),
            ("\r", key(KeyCode::Enter)),
            ("\t", key(KeyCode::Tab)),
            ("\x7f", key(KeyCode::Backspace)),
            ("\x1b", key(KeyCode::Esc)),
            ("\x03", held(KeyCode::Char('c'), control)),
            ("\x1a", held(KeyCode::Char('z'), control)),
            ("\x1ba", held(KeyCode::Char('a'), KeyModifiers::ALT)),
            ("\x1bä", held(KeyCode::Char('ä'), KeyModifiers::ALT)),
            ("\x1b[A", key(KeyCode::Up)),
            ("\x1bOB", key(KeyCode::Down)),
            ("\x1b[H", key(KeyCode::Home)),
            ("\x1b[F", key(KeyCode::End)),
            ("\x1b[1~", key(KeyCode::Home)),
            ("\x1b[3~", key(KeyCode::Delete)),
            ("\x1b[5~", key(KeyCode::PageUp)),
            ("\x1bOP", key(KeyCode::F(1))),
            ("\x1b[[C", key(KeyCode::F(3))),
            ("\x1b[15~", key(KeyCode::F(5))),
            ("\x1b[24~", key(KeyCode::F(12))),
            ("\x1b[Z", key(KeyCode::BackTab)),
            ("\x1b[1;5C", held(KeyCode::Right, control)),
            ("\x1b[3;2~", held(KeyCode::Delete, shift)),
            ("\x1b[97;5u", held(KeyCode::Char('a'), control)),
            ("\x1b[27u", key(KeyCode::Esc)),
        ] {
            let expected = [expected];
            assert_eq!(decoded(&[bytes.as_bytes()]), expected, "{bytes:?}");
            let single: Vec<&[u8]> = bytes.as_bytes().chunks(1).collect();
            assert_eq!(decoded(&single), expected, "{bytes:?}");
        }
        let released = "\x1b[97;1:3u".as_bytes();
        let [Event::Key(released)] = decoded(&[released])[..] else {
            panic!("no key");
        };
        assert_eq!(released.kind, KeyEventKind::Release);
    }

    #[test]
    fn mouse_reports_are_decoded() {
        let at = |kind, column, row| {
            let modifiers = KeyModifiers::NONE;
            vec![Event::Mouse(MouseEvent {
                kind,
                column,
                row,
                modifiers,
            })]
        };
        let left = MouseButton::Left;
        for (bytes, expected) in [
            (&b"\x1b[<0;1;1M"[..], at(MouseEventKind::Down(left), 0, 0)),
            (b"\x1b[<0;300;70m", at(MouseEventKind::Up(left), 299, 69)),
            (b"\x1b[<32;4;5M", at(MouseEventKind::Drag(left), 3, 4)),
            (b"\x1b[<64;5;5M", at(MouseEventKind::ScrollUp, 4, 4)),
            (b"\x1b[<65;5;5M", at(MouseEventKind::ScrollDown, 4, 4)),
            (b"\x1b[32;30;40M", at(MouseEventKind::Down(left), 29, 39)),
            (b"\x1b[M !\"", at(MouseEventKind::Down(left), 0, 1)),
            (b"\x1b[M#!\xff", at(MouseEventKind::Up(left), 0, 222)),
            // A cell that does not exist, other buttons, and a move without a button.
            (b"\x1b[<0;0;0M", vec![]),
            (b"\x1b[M   ", vec![]),
            (b"\x1b[<2;4;5M", vec![]),
            (b"\x1b[<35;4;5M", vec![]),
            (b"\x1b[<0;99999;1M", vec![]),
        ] {
            assert_eq!(decoded(&[bytes]), expected, "{bytes:?}");
        }
    }

    #[test]
    fn unknown_sequences_are_skipped_and_the_next_key_is_decoded() {
        for noise in [
            &b"\x1b[I"[..],
            b"\x1b[O",
            b"\x1b[12;40R",
            b"\x1b[?62;4c",
            b"\x1b[1;2",
            b"\x1bO",
            b"\x1b[",
            b"\x1b[[",
            b"\x1b[M !",
            b"\xff",
            b"\xc3",
            b"\x80\xbf",
            b"\x1b[\xc3\xa4",
            b"\x00",
            b"\x1b[201~",
        ] {
            let events = decoded(&[noise, b"\x03"]);
            let ctrl_c = pressed(KeyCode::Char('c'), KeyModifiers::CONTROL);
            assert_eq!(events.last(), Some(&ctrl_c), "{noise:?}");
        }
        let long = [&b"\x1b["[..], &b"1;".repeat(10_000), b"Aq"].concat();
        assert_eq!(decoded(&[&long]), [key(KeyCode::Char('q'))]);
        let twice = [key(KeyCode::Esc), key(KeyCode::Esc)];
        assert_eq!(decoded(&[b"\x1b\x1b"]), twice);
        assert_eq!(
            decoded(&[b"\x1b\x1b[A"]),
            [key(KeyCode::Esc), key(KeyCode::Up)]
        );
    }

    /// The events and the version of these chunks; time passes only after the last.
    fn answered(chunks: &[&[u8]]) -> (Vec<Event>, Option<String>) {
        let (mut decoder, mut events) = (Decoder::default(), VecDeque::new());
        for chunk in chunks {
            decoder.feed(chunk, &mut events);
        }
        decoder.pause(&mut events);
        (events.into(), decoder.take_version())
    }

    #[test]
    fn the_terminals_version_is_read_and_no_part_of_it_becomes_a_key() {
        let version = Some("kitty(0.40.0)".to_owned());
        let reply = b"\x1bP>|kitty(0.40.0)\x1b\\";
        assert_eq!(answered(&[reply]), (vec![], version.clone()));
        let single: Vec<&[u8]> = reply.chunks(1).collect();
        assert_eq!(answered(&single), (vec![], version.clone()));
        let q = vec![key(KeyCode::Char('q'))];
        assert_eq!(answered(&[reply, b"q"]), (q, version));
    }

    #[test]
    fn a_hostile_version_is_dropped_and_the_next_key_is_decoded() {
        let long = [&b"\x1bP>|"[..], &b"kitty ".repeat(100_000), b"\x1b\\"].concat();
        for reply in [
            &long[..],
            b"\x1bP\x1b\\",
            b"\x1bPkitty(0.40.0)\x1b\\",
            b"\x1bP>|kitty\xff(0.40.0)\x1b\\",
            b"\x1bP1$r0m\x1b\\",
            // The string never ends.
            b"\x1bP>|kitty(0.40.0)",
            b"\x1bP>|kitty(0.40.0)\x1b",
            &long[..long.len() - 2],
            // The string contains another sequence or a control character.
            b"\x1bP>|kitty\x1b[I",
            b"\x1bP>|kitty\x00",
            b"\x1bP>|kitty\x1bP>|\xff\x1b\\",
        ] {
            let (events, version) = answered(&[reply, b"\x03"]);
            let ctrl_c = pressed(KeyCode::Char('c'), KeyModifiers::CONTROL);
            assert_eq!(events.last(), Some(&ctrl_c), "{reply:?}");
            assert_eq!(version, None, "{reply:?}");
            let mut decoder = Decoder::default();
            let mut events = VecDeque::new();
            decoder.feed(reply, &mut events);
            decoder.pause(&mut events);
            events.clear();
            decoder.feed(b"q", &mut events);
            assert_eq!(events, [key(KeyCode::Char('q'))], "{reply:?}");
        }
    }

    #[test]
    fn a_paste_is_one_event_even_if_it_contains_key_sequences() {
        let text = "two\r\nlines \x1b[A \x1b[201 \x1b\x1b[20 ä";
        let bytes = format!("\x1b[200~{text}\x1b[201~q");
        let expected = [Event::Paste(text.into()), key(KeyCode::Char('q'))];
        assert_eq!(decoded(&[bytes.as_bytes()]), expected);
        let single: Vec<&[u8]> = bytes.as_bytes().chunks(1).collect();
        assert_eq!(decoded(&single), expected);
        // The end marker is missing.
        let open = "\x1b[200~abc".as_bytes();
        assert_eq!(decoded(&[open]), [Event::Paste("abc".into())]);
    }

    #[test]
    fn a_long_paste_is_sent_at_once_and_the_rest_is_dropped() {
        let long = "ä".repeat(LARGEST_PASTE);
        let (mut decoder, mut events) = (Decoder::default(), VecDeque::new());
        decoder.feed(format!("\x1b[200~x{long}").as_bytes(), &mut events);
        let cut = format!("x{}", &long[..LARGEST_PASTE - 2]);
        assert_eq!(events, [Event::Paste(cut)]);
        decoder.feed(format!("{long}\x1b[201~q").as_bytes(), &mut events);
        assert_eq!(events.len(), 2);
        assert_eq!(events[1], key(KeyCode::Char('q')));
    }

    #[test]
    fn ctrl_c_works_within_a_paste_and_the_rest_is_dropped() {
        let ctrl_c = pressed(KeyCode::Char('c'), KeyModifiers::CONTROL);
        let bytes = b"\x1b[200~abc\x03y\x03y\x1b[201~q";
        let expected = [ctrl_c.clone(), ctrl_c, key(KeyCode::Char('q'))];
        assert_eq!(decoded(&[bytes]), expected);
    }
}

//! How pupils come in: the address, the code, and a picture of both for phones.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::qr::Qr;
use crate::class::{DoorState, Session};
use crate::messages::OpenDoor;
use crate::screens::class::heading::{below, centred, column};
use crate::widgets::big::{Align, Big};
use crate::widgets::{Item, Lines, Look, Role, Words, areas, rehearsed, sheet};

/// What is said when nobody has come for a while.
const HINT: &str = "Nobody in yet? Devices must be in the same network as this computer. Many \
    school networks keep devices apart: then let this computer or a phone open a hotspot and \
    have all join that, or vote with hands or cards instead.";
/// Rows of an address in large letters.
const LETTERS: u16 = 4;
/// How many times as large a code for cameras may be, the largest first.
const SCALES: [usize; 3] = [3, 2, 1];
/// Columns beside it, for the address in plain letters at least.
const LEAST_WORDS: u16 = 24;
/// What all should know.
const OPENLY: &str = "Everyone on this network can see names and votes. Nicknames are fine.";

pub(in crate::screens::class) fn draw(
    session: &Session,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) {
    let door = match session.door() {
        DoorState::Open(door) => door,
        DoorState::Opening => {
            return centred("The door is being opened ..", area, buf, look, Role::Text);
        }
        DoorState::Failed(reason) => {
            let mut lines = Lines::new(column(area), buf, *look);
            lines.paragraph(&format!("Pupils cannot come in: {reason}."), Role::Warn);
            lines.gap();
            let words = "Enter goes on without them; the round can also be played with teams or \
                 with cards.";
            return lines.paragraph(words, Role::Text);
        }
    };
    let address = &address(door);
    let link = format!("http://{address}/#code={}", door.code);
    let body = above_foot(false, door, area, look)[0];
    let qr = Qr::of(&link, look).filter(|_| door.page.is_ok());
    let beside = qr.and_then(|qr| BesideQr::new(qr, address, body, look));
    // Beside a picture there is room for what to do when nobody comes.
    let waits = session.waits_long();
    let [body, foot_place] = above_foot(waits && beside.is_none(), door, area, look);
    let mut words = body;
    let mut address_below = None;
    if let Some(beside) = &beside {
        beside.qr.draw(beside.place, buf);
        words = beside.words;
        address_below = beside.address.as_ref();
    }
    if let Some((big, place)) = address_below {
        big.draw(*place, buf, look, Role::Title, Align::Centre);
    }
    let below = draw_words(session, door, address_below.is_some(), words, buf, look);
    if waits && beside.is_some() {
        Lines::new(below, buf, *look).paragraph(HINT, Role::Warn);
    }
    let mut lines = Lines::new(foot_place, buf, *look);
    write_foot(waits && beside.is_none(), door, &mut lines);
}

/// The address that is shown first.
fn address(door: &OpenDoor) -> String {
    let first = door.addresses.first();
    first.map(ToString::to_string).unwrap_or_default()
}

/// A code for cameras, and what stands around it.
struct BesideQr {
    qr: Qr,
    place: Rect,
    words: Rect,
    /// The address below it, where that is too long to be large beside it.
    address: Option<(Big, Rect)>,
}

impl BesideQr {
    /// The largest code that leaves room for the words; for the address in plain letters at least,
    /// and in large ones beside a code that could be smaller.
    fn new(qr: Qr, address: &str, body: Rect, look: &Look) -> Option<Self> {
        let mut qr = qr;
        for scale in SCALES {
            qr = qr.scaled(scale);
            let (columns, rows) = qr.size();
            if rows > body.height || columns + LEAST_WORDS > body.width {
                continue;
            }
            let [_, side] = areas::left(body, columns + 3);
            let is_large = large_address(address, side, look).is_some();
            let [above, below] = areas::upper(body, body.height.saturating_sub(LETTERS));
            let big = Big::fit(address, below.width, LETTERS, look.charset)
                .filter(|_| !is_large && rows <= above.height);
            if scale > 1 && !is_large && big.is_none() {
                continue;
            }
            let height = if big.is_some() { above } else { body }.height;
            return Some(Self {
                place: Rect {
                    x: body.x + 1,
                    y: body.y + (height - rows) / 2,
                    width: columns,
                    height: rows,
                },
                words: Rect { height, ..side },
                address: big.map(|big| (big, below)),
                qr,
            });
        }
        None
    }
}

fn write_foot(hints: bool, door: &OpenDoor, lines: &mut Lines) {
    if let Err(reason) = &door.page {
        let words = format!("Browsers cannot join: {reason}. Other computers: carrom join ADDRESS");
        lines.paragraph(&words, Role::Warn);
    }
    if hints {
        lines.paragraph(HINT, Role::Warn);
    } else {
        lines.paragraph(OPENLY, Role::Dim);
    }
}

/// An area cut above what stands at its foot.
fn above_foot(hints: bool, door: &OpenDoor, area: Rect, look: &Look) -> [Rect; 2] {
    let rows = rehearsed(area, *look, |lines| {
        write_foot(hints, door, lines);
        lines.written()
    });
    areas::upper(area, area.height.saturating_sub(rows))
}

/// Columns and rows of an address or a code in an area that has both, and words.
fn room(area: Rect) -> (u16, u16) {
    (
        area.width.saturating_sub(2),
        area.height.saturating_sub(6) / 2,
    )
}

/// An address in large letters for such an area.
fn large_address(address: &str, area: Rect, look: &Look) -> Option<Big> {
    let (width, room) = room(area);
    // Where one line is too long, the port stands below.
    let two_lines = address.replace(':', " :");
    Big::fit(address, width, room.min(8), look.charset)
        .or_else(|| Big::fit(&two_lines, width, room.max(8), look.charset))
}

/// The address, unless it stands `below` all that, and the code, as large as they fit, and how
/// many are in; gives the place that is left.
fn draw_words(
    session: &Session,
    door: &OpenDoor,
    address_is_below: bool,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) -> Rect {
    let address = &address(door);
    let code = door.code.to_string();
    let in_words = match (session.present(), session.round().participants().len()) {
        (0, 0) => "Nobody is in yet.".to_owned(),
        (1, 1) => "One is in.".to_owned(),
        (present, all) if present == all => format!("{all} are in."),
        (present, all) => format!("{present} of {all} are in."),
    };
    let (width, room) = room(area);
    let mut place = below(area, 1);
    let mut say = |words: &str, role: Role, place: Rect| {
        Lines::new(place, buf, *look).line(words, role);
        below(place, 1)
    };
    let asks = match address_is_below {
        true => "In the browser, type the address below",
        false => "In the browser, type the address",
    };
    place = say(asks, Role::Key, place);
    let large = |words: &str| Words::large(words, Role::Title);
    place = match large_address(address, area, look) {
        _ if address_is_below => place,
        Some(big) => {
            sheet::note(place, || Item::new(large(address)));
            big.draw(place, buf, look, Role::Title, Align::Left);
            below(place, big.rows() + 1)
        }
        None => {
            let rest = say(address, Role::Title, place);
            below(rest, 1)
        }
    };
    Lines::new(place, buf, *look).line("and the code of this class", Role::Key);
    place = below(place, 1);
    place = match Big::fit(&code, width, room.min(8), look.charset) {
        Some(big) => {
            sheet::note(place, || Item::new(large(&code)));
            big.draw(place, buf, look, Role::Title, Align::Left);
            below(place, big.rows() + 1)
        }
        None => {
            Lines::new(place, buf, *look).line(&code, Role::Title);
            below(place, 2)
        }
    };
    let mut lines = Lines::new(place, buf, *look);
    lines.line(&in_words, Role::Title);
    if session.is_shut() {
        lines.line("The door is closed: nobody new can come in.", Role::Warn);
    }
    for other in door.addresses.iter().skip(1).take(2) {
        lines.line(&format!("or {other}"), Role::Dim);
    }
    lines.gap();
    let written = lines.written();
    below(place, written)
}

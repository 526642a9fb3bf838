//! How pupils come in: the address, the code, and a picture of both for phones.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::qr::Qr;
use super::{DoorState, Hosting, PATIENCE};
use crate::class::ClassRound;
use crate::messages::OpenDoor;
use crate::screens::class::heading::{below, centred};
use crate::screens::class::view::column;
use crate::widgets::big::{Align, Big};
use crate::widgets::{Lines, Look, Role, areas, rehearsed};

/// What is said when nobody has come for a while.
const HINT: &str = "Nobody in yet? Devices must be in the same network as this computer. Many \
    school networks keep devices apart: then let this computer or a phone open a hotspot and \
    have all join that, or vote with hands or cards instead.";
/// What all should know.
const OPENLY: &str = "Whoever is in this network can see names and votes: nicknames will do.";

/// Draws the page.
pub(super) fn draw(
    hosting: &Hosting,
    round: &ClassRound,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) {
    let door = match &hosting.door {
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
    let address = door.addresses.first().map_or("", String::as_str);
    let link = format!("http://{address}/#code={}", door.code);
    let foot = foot_rows(hosting, door, area, look);
    let [body, foot_place] = areas::upper(area, area.height.saturating_sub(foot));
    // Beside the code there is room for the address in plain letters at least.
    let qr = Qr::of(&link, look).filter(|qr| {
        let (columns, rows) = qr.size();
        rows <= body.height && columns + 24 <= body.width && door.page.is_ok()
    });
    let words = match &qr {
        Some(qr) => {
            let (columns, rows) = qr.size();
            let top = (body.height - rows) / 2;
            let place = Rect {
                x: body.x + 1,
                y: body.y + top,
                width: columns,
                height: rows,
            };
            qr.draw(place, buf);
            Rect {
                x: body.x + columns + 3,
                width: body.width.saturating_sub(columns + 3),
                ..body
            }
        }
        None => body,
    };
    draw_words(hosting, round, door, words, buf, look);
    let mut lines = Lines::new(foot_place, buf, *look);
    write_foot(hosting, door, &mut lines);
}

fn write_foot(hosting: &Hosting, door: &OpenDoor, lines: &mut Lines) {
    if let Err(reason) = &door.page {
        let words = format!("Browsers cannot join: {reason}. Other computers: carrom join ADDRESS");
        lines.paragraph(&words, Role::Warn);
    }
    if hosting.presence.is_empty() && hosting.waited >= PATIENCE {
        lines.paragraph(HINT, Role::Warn);
    } else {
        lines.paragraph(OPENLY, Role::Dim);
    }
}

/// Rows of what stands below.
fn foot_rows(hosting: &Hosting, door: &OpenDoor, area: Rect, look: &Look) -> u16 {
    rehearsed(area, *look, |lines| {
        write_foot(hosting, door, lines);
        lines.written()
    })
}

/// The address and the code, as large as they fit, and how many are in.
fn draw_words(
    hosting: &Hosting,
    round: &ClassRound,
    door: &OpenDoor,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) {
    let address = door.addresses.first().map_or("", String::as_str);
    let code = door.code.to_string();
    let in_words = match (hosting.present(), round.teams().len()) {
        (0, 0) => "Nobody is in yet.".to_owned(),
        (1, 1) => "One is in.".to_owned(),
        (present, all) if present == all => format!("{all} are in."),
        (present, all) => format!("{present} of {all} are in."),
    };
    let room = area.height.saturating_sub(6) / 2;
    let width = area.width.saturating_sub(2);
    // Where one line is too long, the port stands below.
    let two_lines = address.replace(':', " :");
    let large = Big::fit(address, width, room.min(8), look.charset)
        .or_else(|| Big::fit(&two_lines, width, room.max(8), look.charset));
    let mut place = below(area, 1);
    let mut say = |words: &str, role: Role, place: Rect| {
        Lines::new(place, buf, *look).line(words, role);
        below(place, 1)
    };
    place = say("In the browser, type the address", Role::Key, place);
    place = match large {
        Some(big) => {
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
    if hosting.shut {
        lines.line("The door is closed: nobody new can come in.", Role::Warn);
    }
    for other in door.addresses.iter().skip(1).take(2) {
        lines.line(&format!("or {other}"), Role::Dim);
    }
}

//! How pupils join: the address, the code, and a QR code for phones.

use ratatui::layout::Rect;

use super::qr::Qr;
use super::{ClassAction, HostingAction};
use crate::class::Session;
use crate::messages::JoinDetails;
use crate::screens::view::WIDEST;
use crate::screens::{Context, View};
use crate::widgets::big::Big;
use crate::widgets::panel::Panel;
use crate::widgets::{Look, Role, Room, SplitLayout, areas, text};

/// The hint shown when nobody has joined for a while.
const HINT: &str = "Has nobody joined? Devices must be on the same network as this computer. Many \
                    school networks isolate devices: then open a hotspot on this computer or a \
                    phone and let everyone join it, or vote with hands or cards instead.";
/// The height of an address in large letters, in rows.
const LETTERS: u16 = 4;
/// The smallest height of the panel, in rows, at which the address and the code in it have large
/// letters.
const LARGE_FROM: u16 = 13;
/// The scales of a QR code, the largest first.
const SCALES: [usize; 3] = [3, 2, 1];
/// The smallest number of columns beside a QR code: enough for the address in plain letters.
const LEAST_WORDS: u16 = 24;
/// The notice that names and votes are not private.
const OPENLY: &str = "Everyone on this network can see names and votes. Nicknames are fine.";

/// The same notice, if carrom gives nicknames.
const NICKNAMES: &str = "carrom gives everyone a nickname: leave the name empty. Everyone on this \
                         network can see nicknames and votes.";

/// The instructions for joining.
pub(super) fn view<'s>(session: &Session, cx: &Context) -> View<'s, ClassAction> {
    let mut panel = Panel::new("");
    panel.open = true;
    let column = |room: Room| SplitLayout::open(Rect::default(), areas::middle(room.area, WIDEST));
    let joining = match session.hosting() {
        Some(Ok(joining)) => joining,
        None => {
            panel.line("Getting ready ..", Role::Text);
            return View::alone(column, panel);
        }
        Some(Err(reason)) => {
            panel.paragraph(format!("Pupils cannot join: {reason}."), Role::Warn);
            panel.gap();
            let words = "The round can also be played with teams or with cards.";
            panel.paragraph(words, Role::Text);
            let on = ClassAction::Hosting(HostingAction::GoOn);
            panel.prompt("continue without pupils", on);
            return View::alone(column, panel);
        }
    };
    let (look, area) = (cx.settings.look(), cx.body);
    let address = address(joining);
    let link = format!("http://{address}/#code={}", joining.code);
    let openly = match session.round().gives_nicknames() {
        true => NICKNAMES,
        false => OPENLY,
    };
    let rows = text::wrap(openly, area.width.saturating_sub(2).into()).len() as u16;
    let [body, _] = areas::upper(area, area.height.saturating_sub(rows));
    let qr = Qr::of(&link, &look).filter(|_| joining.page.is_ok());
    let beside = qr.and_then(|qr| BesideQr::new(qr, &address, body, &look));
    let is_below = beside.as_ref().is_some_and(|it| it.address_is_below);
    // Beside a QR code there is room for the hint; without a QR code, the hint replaces the notice
    // below.
    let waits = session.waits_long();
    write(session, joining, (&address, is_below), &mut panel);
    if waits && beside.is_some() {
        panel.gap();
        panel.paragraph(HINT, Role::Warn);
    }
    let mut foot = Panel::new("");
    if is_below {
        foot.large([address.as_str()], 0);
    }
    if let Err(reason) = &joining.page {
        let words = format!("Browsers cannot join: {reason}. Other computers: carrom join ADDRESS");
        foot.paragraph(words, Role::Warn);
    }
    match waits && beside.is_none() {
        true => foot.paragraph(HINT, Role::Warn),
        false => foot.paragraph(openly, Role::Dim),
    }
    let view = match beside {
        Some(BesideQr {
            qr, place, words, ..
        }) => {
            let draw = move |place, buf: &mut _, _: &_| qr.draw(place, buf);
            View::picture("", draw, panel).laid_out(move |_| SplitLayout::open(place, words))
        }
        None => View::alone(
            |room| SplitLayout::open(Rect::default(), areas::upper(room.area, 1)[1]),
            panel,
        ),
    };
    view.with_foot(foot)
}

/// Writes the code, the number of participants and, unless it is shown below the QR code, the
/// address.
fn write(
    session: &Session,
    joining: &JoinDetails,
    (address, is_below): (&str, bool),
    panel: &mut Panel<ClassAction>,
) {
    if is_below {
        panel.line("In the browser, type the address below", Role::Key);
    } else {
        panel.line("In the browser, type the address", Role::Key);
        let lines = in_lines(address);
        panel.large(lines.iter().map(String::as_str), LARGE_FROM);
        panel.gap();
    }
    panel.line("and the code of this class", Role::Key);
    panel.large([joining.code.to_string().as_str()], LARGE_FROM);
    panel.gap();
    let in_words = match (session.present(), session.round().participants().len()) {
        (0, 0) => "Nobody has joined yet.".to_owned(),
        (1, 1) => "One is in.".to_owned(),
        (present, all) if present == all => format!("{all} are in."),
        (present, all) => format!("{present} of {all} are in."),
    };
    panel.line(in_words, Role::Title);
    if session.is_shut() {
        panel.line("The round is closed: nobody new can join.", Role::Warn);
    }
    for other in joining.addresses.iter().skip(1).take(2) {
        panel.line(format!("or {other}"), Role::Dim);
    }
}

/// An address in one line, or in two, with the port on the second.
fn in_lines(address: &str) -> [String; 2] {
    [address.to_owned(), address.replace(':', " :")]
}

/// The address that is shown first.
fn address(joining: &JoinDetails) -> String {
    let first = joining.addresses.first();
    first.map(ToString::to_string).unwrap_or_default()
}

/// A QR code, and the layout around it.
struct BesideQr {
    qr: Qr,
    place: Rect,
    words: Rect,
    /// Whether the address is shown below the QR code, because it is too long for large letters
    /// beside the code.
    address_is_below: bool,
}

impl BesideQr {
    /// The largest QR code that leaves room for the address in large letters, or else the smallest,
    /// if that leaves room for the address in plain letters.
    fn new(qr: Qr, address: &str, body: Rect, look: &Look) -> Option<Self> {
        let mut qr = qr;
        for scale in SCALES {
            qr = qr.scaled(scale);
            let (columns, rows) = qr.size();
            if rows > body.height || columns + LEAST_WORDS > body.width {
                continue;
            }
            let [_, side] = areas::left(body, columns + 3);
            let is_large = |address: &str, width: u16, rows: u16| {
                Big::fit(address, width.saturating_sub(2), rows, look.charset).is_some()
            };
            let [one, two] = in_lines(address);
            let is_beside =
                is_large(&one, side.width, LETTERS) || is_large(&two, side.width, 2 * LETTERS);
            let [above, _] = areas::upper(body, body.height.saturating_sub(LETTERS));
            let is_below =
                !is_beside && rows <= above.height && is_large(&one, body.width, LETTERS);
            if scale > 1 && !is_beside && !is_below {
                continue;
            }
            let height = if is_below { above } else { body }.height;
            return Some(Self {
                place: Rect {
                    x: body.x + 1,
                    y: body.y + (height - rows) / 2,
                    width: columns,
                    height: rows,
                },
                words: areas::upper(Rect { height, ..side }, 1)[1],
                address_is_below: is_below,
                qr,
            });
        }
        None
    }
}

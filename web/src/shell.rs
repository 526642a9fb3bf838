//! The app with its screen and its saved data.

use std::mem;
use std::time::Duration;

use carrom::app::App;
use carrom::messages::{Effect, HostCall, HostNews, Input, JoinCall, Key, Mouse};
use carrom::shells::AppHolder;
use carrom::shells::plain::PlainReader;
use carrom::widgets::{
    PaintedCell, PaintedPicture, Role, Section, Sheet, gather, glyph_shape, inks, painted, recorded,
};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Modifier;

use crate::keeping::{Change, PageStorage};
use crate::message::{Command, Download, Keys, Opening, Painted, PictureMessage, Reply, split};
use crate::{message, opening, own, report};

/// The bit that marks a cell that a picture replaces.
const VECTOR: u32 = 1 << 16;

/// An instance of carrom in a page.
pub struct Shell {
    app: App,
    screen: Terminal<TestBackend>,
    /// The last frame, and the colours of its cells.
    drawn: Buffer,
    painted: Vec<PaintedCell>,
    /// The number of frames drawn.
    paints: u64,
    sent: Sent,
    keeping: PageStorage,
    downloads: Vec<Download>,
    calls: Vec<JoinCall>,
    opening: Opening,
    /// Writes the screen as lines, in plain mode only.
    reader: Option<PlainReader>,
}

/// The parts of a frame as they were last sent.
#[derive(Default)]
struct Sent {
    keys: Vec<Keys>,
    sheets: Vec<Sheet>,
    inks: Vec<(Role, u32)>,
    pictures: Vec<String>,
}

/// A part of the frame if it has changed since it was last `sent`.
fn changed<T: Clone + PartialEq>(sent: &mut T, now: T) -> Option<T> {
    (*sent != now).then(|| {
        sent.clone_from(&now);
        now
    })
}

impl Shell {
    /// Opens carrom as the page requests.
    #[must_use]
    pub fn open(opening: &Opening, bytes: &[u8]) -> (Self, Reply) {
        Self::open_with(opening, bytes, Vec::new())
    }

    /// Opens carrom again in place of this instance. Changes that the browser has not saved yet are
    /// passed on.
    #[must_use]
    pub fn reopen(self, opening: &Opening, bytes: &[u8]) -> (Self, Reply) {
        let left = match opening.simulated {
            true => Vec::new(),
            false => self.keeping.left(),
        };
        Self::open_with(opening, bytes, left)
    }

    fn open_with(opening: &Opening, bytes: &[u8], left: Vec<Change>) -> (Self, Reply) {
        let files = split(&opening.own, bytes);
        let mut data = own::data(&files);
        if opening.simulated {
            data.folder = None;
        }
        let keeping = PageStorage::new(&data.own, opening.simulated).taking_over(left);
        let app = opening::app(opening, data, own::settings(&files));
        let Ok(screen) = Terminal::new(TestBackend::new(opening.columns, opening.rows));
        let mut shell = Self {
            app,
            screen,
            drawn: Buffer::default(),
            painted: Vec::new(),
            paints: 0,
            sent: Sent::default(),
            keeping,
            downloads: Vec::new(),
            calls: Vec::new(),
            opening: opening.clone(),
            reader: None,
        };
        let mut reply = Reply::default();
        if opening::is_plain(&opening.fragment) {
            let mut reader = PlainReader::new(&mut shell.app);
            reply.lines = reader.begin(&mut shell);
            shell.reader = Some(reader);
        } else {
            shell.app.set_pictures(opening.pictures);
            shell.input(&Input::Resize(opening.columns, opening.rows));
        }
        let reply = shell.completed(reply);
        (shell, reply)
    }

    /// Carries out the page's command, which may be followed by bytes of files.
    pub fn call(&mut self, command: Command, bytes: &[u8]) -> Reply {
        let mut reply = Reply::default();
        let is_time = matches!(command, Command::Pass { .. } | Command::Now { .. });
        match command {
            Command::Open(_) => {}
            Command::Key { key } => {
                if let Some(key) = Key::parse(&key) {
                    self.input(&Input::Key(key));
                }
            }
            Command::Mouse { kind, x, y } => {
                if let Ok(kind) = kind.parse() {
                    self.input(&Input::Mouse(Mouse::at(kind, (x, y).into())));
                }
            }
            Command::Paste { text } => self.input(&Input::Paste(text)),
            // In plain mode the screen has a fixed size.
            Command::Resize { .. } if self.reader.is_some() => {}
            Command::Resize {
                columns,
                rows,
                pictures,
            } => {
                self.app.set_pictures(pictures);
                self.screen.backend_mut().resize(columns, rows);
                self.input(&Input::Resize(columns, rows));
            }
            Command::Pass { ms } => self.pass(Duration::from_secs_f64(ms.clamp(0.0, 3.6e6) / 1e3)),
            Command::Now { time_s, offset_s } => {
                self.keeping.store().stop_clock(time_s, offset_s);
            }
            Command::Set { charset, color } => {
                let settings = self.app.settings_mut();
                let charset = charset.and_then(|name| name.parse().ok());
                settings.charset = charset.unwrap_or(settings.charset);
                let depth = color.and_then(|name| name.parse().ok());
                settings.depth = depth.unwrap_or(settings.depth);
            }
            Command::Prefer { light, still } => {
                self.app.prefer(opening::palette(light), still);
            }
            Command::Paint { since } => reply.painted = Some(self.paint(since)),
            Command::Files { files } => {
                for answer in self.keeping.take_files(&split(&files, bytes)) {
                    self.input(&Input::Kept(Box::new(answer)));
                }
            }
            Command::Changed => match self.keeping.changes() {
                Ok((files, gone)) => {
                    reply.gone = gone;
                    for (path, content) in files {
                        reply.attach(path, &content);
                    }
                }
                Err(error) => reply.fault = Some(error),
            },
            Command::Kept { failed } => {
                for answer in self.keeping.kept(failed.as_deref()) {
                    self.input(&Input::Kept(Box::new(answer)));
                }
            }
            Command::Slow => {
                for ticket in self.keeping.tickets() {
                    self.input(&Input::Saving(ticket));
                }
            }
            Command::File { name } => match own::measured(&name, bytes) {
                Some(Ok(measurement)) => self.app.show(measurement),
                Some(Err(error)) => self.app.notify(error),
                None => match own::take_in(&mut self.keeping, &name, bytes) {
                    Ok((words, true)) => reply.renewed = Some(words),
                    Ok((words, false)) | Err(words) => self.app.notify(words),
                },
            },
            Command::Progress => match self.keeping.store().files() {
                Ok(files) => {
                    let mut files = files.into_iter();
                    if let Some((path, content)) = files.find(|(path, _)| path == own::PROGRESS) {
                        reply.attach(path, &content);
                    }
                }
                Err(error) => reply.fault = Some(error),
            },
            Command::Glyph { letter } => {
                if let Some((path, strength)) = glyph_shape(&letter) {
                    reply.lines = vec![path, strength.to_string()];
                }
            }
            Command::Line { text } => {
                reply.lines = self.read(|reader, shell| reader.hear(&text, shell));
            }
            Command::Joined { news } => self.input(&Input::Joined(news)),
            Command::Round { code, said } => {
                reply.round = report::of_round(&code, &said, &self.app.context().own);
            }
            Command::Tell { words } => self.app.notify(words),
        }
        reply.lines.extend(self.read(|reader, shell| match is_time {
            true => reader.say_moving(shell),
            false => reader.news(shell),
        }));
        self.completed(reply)
    }

    /// The cells that were painted last, four numbers each.
    #[must_use]
    pub fn cells(&self) -> Vec<u32> {
        let drawn = self.drawn.content();
        let mut cells = Vec::with_capacity(4 * drawn.len());
        for (cell, painted) in drawn.iter().zip(&self.painted) {
            let letter = cell.symbol().chars().next().unwrap_or(' ');
            let hidden = cell.modifier.contains(Modifier::HIDDEN);
            let letter = if hidden { ' ' } else { letter };
            let vector = if painted.is_vector { VECTOR } else { 0 };
            let bits = u32::from(painted.modifier.bits()) | vector;
            cells.extend([u32::from(letter), painted.ink, painted.paper, bits]);
        }
        cells
    }

    /// The lines to show in plain mode; none in other modes.
    fn read(
        &mut self,
        read: impl FnOnce(&mut PlainReader, &mut Self) -> Vec<String>,
    ) -> Vec<String> {
        let Some(mut reader) = self.reader.take() else {
            return Vec::new();
        };
        let lines = read(&mut reader, self);
        self.reader = Some(reader);
        lines
    }

    /// The reply to a command, with what every reply contains.
    fn completed(&mut self, reply: Reply) -> Reply {
        let exports = self.keeping.store().take_exports().into_iter();
        let exports = exports.map(|(name, content)| Download { name, content });
        let (address, depth) = self.app.address();
        Reply {
            wake_ms: self.app.wake().map(|wake| wake.as_secs_f64() * 1e3),
            keep: self.keeping.is_to_keep(),
            unsaved: self.keeping.unsaved(),
            quit: self.app.has_quit(),
            address,
            depth,
            calls: mem::take(&mut self.calls),
            downloads: self.downloads.drain(..).chain(exports).collect(),
            ..reply
        }
    }

    fn paint(&mut self, since: u64) -> Painted {
        if since != self.paints {
            self.sent = Sent::default();
        }
        self.paints += 1;
        let app = &self.app;
        let screen = &mut self.screen;
        let Ok(()) = screen.autoresize();
        // Tests compare the cells with those of a terminal.
        let hides_cells = !self.opening.simulated;
        // Without a terminal, the differences between two frames need not be computed.
        let ((drawn, pictures), sheets) = recorded(|| {
            gather(hides_cells, || {
                let mut frame = screen.get_frame();
                let area = frame.area();
                app.draw(&mut frame);
                mem::replace(screen.current_buffer_mut(), Buffer::empty(area))
            })
        });
        let (cells, pictures) = painted(&drawn, &pictures);
        self.painted = cells;
        self.drawn = drawn;
        Painted {
            number: self.paints,
            size: [self.drawn.area.width, self.drawn.area.height],
            pictures: self.changed_pictures(pictures),
            keys: changed(&mut self.sent.keys, keys(&self.app)),
            colours: self.colours(),
            inks: changed(&mut self.sent.inks, inks(&self.app.settings().theme())),
            sheets: self.changed_sheets(sheets),
        }
    }

    /// The pictures; those that have not changed since they were last sent have no vectors.
    fn changed_pictures(&mut self, pictures: Vec<PaintedPicture>) -> Vec<PictureMessage> {
        let before = mem::take(&mut self.sent.pictures);
        let reply = pictures.into_iter().enumerate().map(|(at, picture)| {
            let area = picture.area;
            let is_new = before.get(at) != Some(&picture.svg);
            self.sent.pictures.push(picture.svg.clone());
            PictureMessage {
                area: [area.x, area.y, area.width, area.height],
                paper: picture.paper,
                svg: is_new.then_some(picture.svg),
            }
        });
        reply.collect()
    }

    /// The text of the screen, without sections that have not changed since they were last sent;
    /// `None` if nothing has changed.
    fn changed_sheets(&mut self, sheets: Vec<Sheet>) -> Option<Vec<message::SheetMessage>> {
        if sheets == self.sent.sheets {
            return None;
        }
        let before = mem::take(&mut self.sent.sheets);
        let reply = sheets.iter().enumerate().map(|(at, sheet)| {
            let same = before.get(at).filter(|it| it.kind == sheet.kind);
            let section = |(number, section)| {
                let reply = same.and_then(|it| it.sections.get(number));
                (reply != Some(section)).then(|| Section::clone(section))
            };
            message::SheetMessage {
                kind: sheet.kind,
                title: sheet.title.clone(),
                status: sheet.status.clone(),
                sections: sheet.sections.iter().enumerate().map(section).collect(),
            }
        });
        let reply = reply.collect();
        self.sent.sheets = sheets;
        Some(reply)
    }

    /// The colours of plain text and of the background.
    fn colours(&self) -> [u32; 2] {
        let mut blank = Buffer::empty(Rect::new(0, 0, 1, 1));
        blank.set_style(blank.area, self.app.settings().theme().base());
        let (cells, _) = painted(&blank, &[]);
        cells.first().map_or([0, 0], |cell| [cell.ink, cell.paper])
    }
}

/// The current keys. A layer over a screen either has keys of its own or is closed by any key.
fn keys(app: &App) -> Vec<Keys> {
    let table = app.keys();
    let rows = table.rows().iter();
    let mut all: Vec<_> = rows
        .map(|row| Keys {
            id: row.id.clone(),
            keys: match row.keys().any(|key| matches!(key, Key::Char('0'..='9'))) {
                // This includes the decimal point and the minus sign of a number, which the bottom
                // line does not show.
                true => row.all_keys().map(|key| key.to_string()).collect(),
                false => row.keys().map(|key| key.to_string()).collect(),
            },
            name: row.name,
            help: row.help,
            words: row.words,
        })
        .collect();
    if table.keys().all(|key| key != Key::Escape) {
        all.push(Keys {
            id: "layer.go-on".into(),
            keys: vec![Key::Escape.to_string()],
            name: "go on",
            help: "",
            words: &[],
        });
    }
    all
}

impl AppHolder for Shell {
    fn app(&mut self) -> &mut App {
        &mut self.app
    }

    fn carry_out(&mut self, effect: Effect) -> Option<Input> {
        match effect {
            Effect::Keep(call) => {
                if let Some(answer) = self.keeping.ask(&call) {
                    self.input(&Input::Kept(Box::new(answer)));
                }
                // Without a browser, saving cannot fail.
                if self.opening.simulated && self.keeping.changes().is_ok() {
                    for answer in self.keeping.kept(None) {
                        self.input(&Input::Kept(Box::new(answer)));
                    }
                }
                None
            }
            Effect::Host(HostCall::Open { .. }) => {
                let words = "a page in a browser cannot host; the carrom program can".to_owned();
                Some(Input::Hosted(vec![HostNews::Opened(Err(words))]))
            }
            Effect::Host(_) => None,
            Effect::Join(call) => {
                self.calls.push(call);
                None
            }
            Effect::ExportPage { .. } => {
                let words =
                    "a page in a browser cannot write it; the carrom program can".to_owned();
                Some(Input::Exported(Err(words)))
            }
            Effect::Export { name, content } => {
                let place = match self.opening.simulated {
                    true => name.clone(),
                    false => format!("your downloads folder: {name}"),
                };
                self.downloads.push(Download { name, content });
                Some(Input::Exported(Ok(place)))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn paint(shell: &mut Shell, since: u64) -> Painted {
        let painted = shell.call(Command::Paint { since }, &[]).painted;
        painted.unwrap_or_default()
    }

    #[test]
    fn only_changed_sections_are_sent_and_all_after_a_missed_frame() {
        let opening = Opening {
            fragment: "lab".into(),
            columns: 110,
            rows: 100,
            ..Opening::default()
        };
        let (mut shell, _) = Shell::open(&opening, &[]);
        let reply = |painted: &Painted| -> Vec<bool> {
            let sheets = painted.sheets.iter().flatten();
            let sections = sheets.flat_map(|sheet| &sheet.sections);
            sections.map(Option::is_some).collect()
        };
        let first = paint(&mut shell, 0);
        assert_eq!(reply(&first), [true, true]);
        let same = paint(&mut shell, first.number);
        assert!(same.sheets.is_none() && same.keys.is_none() && same.inks.is_none());
        assert!(same.pictures.iter().all(|picture| picture.svg.is_none()));
        shell.call(
            Command::Key {
                key: "Right".into(),
            },
            &[],
        );
        let stepped = paint(&mut shell, same.number);
        assert_eq!(reply(&stepped), [false, true], "the settings");
        assert!(stepped.pictures.iter().any(|it| it.svg.is_some()));
        let missed = paint(&mut shell, first.number);
        assert_eq!(reply(&missed), [true, true]);
        assert!(missed.keys.is_some() && missed.pictures.iter().all(|it| it.svg.is_some()));
    }
}

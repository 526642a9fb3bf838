//! Plays a tape.

use ratatui::layout::Rect;
use thiserror::Error;

use super::{Instruction, ScreenSetting, Screenshot, Tape};
use crate::app::App;
use crate::files::quoted;
use crate::messages::{Key, MouseKind};
use crate::screens::{Route, Settings};
use crate::shells::classroom::Who;
use crate::shells::{Classroom, Headless};
use crate::widgets::recorded;

/// The instruction at which a tape failed.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{line}: {fault}")]
pub struct PlayError {
    /// Number of the line, from 1.
    pub line: usize,
    /// Why it failed.
    pub fault: PlayFault,
}

/// Why an instruction of a tape failed.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum PlayFault {
    /// carrom cannot be started with these arguments, for this reason.
    #[error("Run: {0}")]
    Run(String),
    /// No pupil has this name.
    #[error("there is no pupil {}", quoted(.0))]
    Pupil(String),
    /// The screen does not show the expected text.
    #[error("Expect: the screen does not show {}\n\n{screen}", quoted(text))]
    Expect {
        /// The expected text.
        text: String,
        /// The screen.
        screen: String,
    },
    /// The screen shows a text that must not appear.
    #[error("Refuse: the screen shows {}\n\n{screen}", quoted(text))]
    Refuse {
        /// The text that must not appear.
        text: String,
        /// The screen.
        screen: String,
    },
    /// The instruction follows after carrom has quit in this line.
    #[error("carrom quit in line {0}, so no instruction can follow")]
    Left(usize),
}

/// Plays `tape` on an app that `open` makes from the arguments after `carrom` (in one string, which
/// is split into words as in a shell), and returns its screenshots. Games are kept in memory unless
/// `open` returns an app with another store.
///
/// # Errors
/// The first instruction that failed.
pub fn play<G: Into<Headless>>(
    tape: &Tape,
    open: impl FnOnce(&str) -> Result<G, String>,
) -> Result<Vec<Screenshot>, PlayError> {
    let (line, arguments) = match &tape.run {
        Some((line, arguments)) => (*line, arguments.as_str()),
        None => (1, ""),
    };
    let opened = open(arguments).map_err(|reason| PlayError {
        line,
        fault: PlayFault::Run(reason),
    })?;
    let mut class = Classroom::new(opened.into());
    let mut who = Who::Host;
    let mut left = None;
    let mut screenshots = Vec::new();
    for (line, instruction) in &tape.steps {
        let failed = |fault| PlayError { line: *line, fault };
        if let Some(left) = left {
            return Err(failed(PlayFault::Left(left)));
        }
        let game = class.game(who);
        match instruction {
            Instruction::At(name) => {
                who = match name {
                    None => Who::Host,
                    Some(name) => class.pupil(name).unwrap_or_else(|| come(&mut class, name)),
                }
            }
            Instruction::Reach(name, reaches) => {
                let unknown = || failed(PlayFault::Pupil(name.clone()));
                let pupil = class.pupil(name).ok_or_else(unknown)?;
                class.reach(pupil, *reaches);
            }
            Instruction::Set(ScreenSetting::Size(columns, rows)) => game.resize(*columns, *rows),
            Instruction::Set(ScreenSetting::Charset(charset)) => {
                game.app_mut().settings_mut().charset = *charset;
            }
            Instruction::Set(ScreenSetting::Day(time_s)) => game.set_time(*time_s),
            Instruction::Set(ScreenSetting::Color(depth)) => {
                game.app_mut().settings_mut().depth = *depth;
            }
            Instruction::Type(text) => text.chars().for_each(|letter| game.key(typed(letter))),
            Instruction::Press(key, times) => (0..*times).for_each(|_| game.key(*key)),
            Instruction::Click(at) => game.click(*at),
            Instruction::Drag(from, to) => game.drag(*from, *to),
            Instruction::Hold(from, to) => {
                game.mouse(MouseKind::Down, *from);
                game.mouse(MouseKind::Drag, *to);
            }
            Instruction::Release(at) => game.mouse(MouseKind::Up, *at),
            Instruction::Scroll(way, notches, at) => {
                let at = at.unwrap_or_else(|| middle(game.buffer().area));
                (0..*notches).for_each(|_| game.mouse(*way, at));
            }
            Instruction::Sleep(time) => class.pass(*time),
            Instruction::Screenshot(name) => {
                let (cells, sheets) = recorded(|| game.buffer().clone());
                screenshots.push(Screenshot {
                    name: name.clone(),
                    cells,
                    sheets,
                });
            }
            Instruction::Expect(text) => judge(game, text, true).map_err(failed)?,
            Instruction::Refuse(text) => judge(game, text, false).map_err(failed)?,
        }
        class.settle();
        left = class.game(who).has_quit().then_some(*line);
    }
    Ok(screenshots)
}

/// Adds a pupil whose device has opened the page and uses the teacher's settings.
fn come(class: &mut Classroom, name: &str) -> Who {
    let code = class.code();
    let host = class.game(Who::Host);
    let settings = Settings {
        player: name.to_owned(),
        ..host.app().settings().clone()
    };
    let size = host.buffer().area;
    let route = Route::Join {
        address: None,
        code,
        again: false,
    };
    class.add(name, App::new(route, settings, 7), size.width, size.height)
}

/// Fails if `text` is `wanted` and the screen does not show it, or if it is not wanted and the
/// screen shows it.
fn judge(game: &mut Headless, text: &str, wanted: bool) -> Result<(), PlayFault> {
    let screen = game.screen();
    if screen.contains(text) == wanted {
        return Ok(());
    }
    let text = text.to_owned();
    Err(if wanted {
        PlayFault::Expect { text, screen }
    } else {
        PlayFault::Refuse { text, screen }
    })
}

/// The key that types a character.
fn typed(letter: char) -> Key {
    match letter {
        '\n' => Key::Enter,
        '\t' => Key::Tab,
        other => Key::Char(other),
    }
}

fn middle(area: Rect) -> (u16, u16) {
    (area.width / 2, area.height / 2)
}

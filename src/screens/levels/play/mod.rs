//! Playing a level: set the shot, say where the first hit sends the discs, watch, and
//! see what came about.

mod attempt;
mod board;
mod dials;
mod keys;
mod panel;
mod view;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::levels::Level;
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::physics::Shot;
use crate::quiz::Ray;
use crate::screens::levels::words;
use crate::screens::{Context, Help, Hint, Next, OldScreen, Place};
use crate::widgets::hit::{FRAME, point_at, side};
use crate::widgets::replay::{Impact, impacts};
use crate::widgets::{Lines, Outcome, RayInput, Scroll};

use attempt::{Attempt, Said};
use dials::Dials;

pub(super) use dials::name as dial_name;

/// Rows that a page of the panel is turned by.
const PAGE: i16 = 8;

/// A level being played.
#[derive(Debug, Clone)]
pub(crate) struct Play {
    /// Its number on the shelf, from 0.
    number: usize,
    level: Level,
    dials: Dials,
    /// How many hints have been asked for.
    hints: usize,
    /// Shots made since it was opened.
    shots: u32,
    /// What came of those that were looked at, the last one last.
    tries: Vec<Try>,
    phase: Phase,
    scroll: Scroll,
    /// Why the last shot could not be made.
    trouble: Option<String>,
}

/// What one is doing.
#[derive(Debug, Clone)]
enum Phase {
    /// Setting the shot.
    Aim,
    /// Saying where the first hit sends the discs.
    Say(Box<Saying>),
    /// Watching the shot.
    Watch(Box<Attempt>),
}

/// A shot that was made, in short.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Try {
    /// Its number, from 1.
    number: u32,
    /// How it was set.
    set: String,
    /// What came about: of the goals the first that was missed.
    told: String,
}

/// The shot that is about to be made, and what is being said of its first impact.
#[derive(Debug, Clone)]
struct Saying {
    rays: RayInput,
    shot: Shot,
    impact: Impact,
}

impl Play {
    /// The level of this number; `None` if there is none.
    pub(crate) fn new(number: usize, cx: &mut Context) -> Option<Self> {
        let (_, level) = cx.shelf.get(number)?;
        let level = level.clone();
        cx.shelf.at = number;
        Some(Self {
            number,
            dials: Dials::new(&level),
            level,
            hints: 0,
            shots: 0,
            tries: Vec::new(),
            phase: Phase::Aim,
            scroll: Scroll::default(),
            trouble: None,
        })
    }

    /// Whether the picture shows one impact, not the whole board.
    fn is_enlarged(&self) -> bool {
        match &self.phase {
            Phase::Aim => false,
            Phase::Say(_) => true,
            Phase::Watch(attempt) => attempt.zoom.is_some(),
        }
    }

    fn enter(&mut self, phase: Phase) {
        self.phase = phase;
        self.scroll = Scroll::default();
    }

    /// The rays of an impact that the level asks for.
    fn asks(&self, impact: &Impact) -> impl Iterator<Item = Ray> {
        let asked = impact
            .discs
            .map(|disc| self.level.say_first.contains(&disc));
        let both = Ray::BOTH.into_iter().zip(asked);
        both.filter_map(|(ray, asked)| asked.then_some(ray))
    }

    /// From aiming to saying, or to the shot where there is nothing to say.
    fn go(&mut self, cx: &mut Context) {
        self.dials.commit(&self.level);
        let scene = self.level.aimed(&self.dials.aim);
        let shot = match scene.play() {
            Ok(shot) => shot,
            Err(error) => {
                self.trouble = Some(format!("This shot cannot be played: {error}."));
                return;
            }
        };
        self.trouble = None;
        let first = impacts(&shot, scene.stroke.disc).next();
        let asked = first.map(|impact| self.asks(&impact).collect::<Vec<_>>());
        let asked = asked.unwrap_or_default();
        if let (Some(impact), true, false) = (first, cx.settings.predict, asked.is_empty()) {
            let both = RayInput::new(side(&impact.collision));
            let rays = match asked.as_slice() {
                [one] => both.only(*one),
                _ => both,
            };
            self.enter(Phase::Say(Box::new(Saying { rays, shot, impact })));
        } else {
            self.shoot(shot, !asked.is_empty(), None, cx);
        }
    }

    fn shoot(&mut self, shot: Shot, to_say: bool, said: Option<Said>, cx: &mut Context) {
        self.shots += 1;
        let reduced = cx.settings.reduced_motion;
        let attempt = Attempt::new(&self.level, shot, self.shots, to_say, said, reduced);
        self.enter(Phase::Watch(Box::new(attempt)));
        self.keep_if_told(cx);
    }

    /// Keeps a win once it has been told.
    fn keep_if_told(&self, cx: &mut Context) {
        if let Phase::Watch(attempt) = &self.phase
            && attempt.told
        {
            self.keep(attempt, cx);
        }
    }

    fn keep(&self, attempt: &Attempt, cx: &mut Context) {
        if let Some(win) = attempt.win {
            cx.won(self.number, win);
        }
    }

    /// Back to the aim. A win that was not watched to its end counts all the same.
    fn leave_shot(&mut self, cx: &mut Context) {
        if let Phase::Watch(attempt) = &self.phase {
            self.keep(attempt, cx);
            let findings = attempt.verdict.told(&self.level);
            let unmet = findings.iter().find(|finding| !finding.met);
            if let Some(finding) = unmet.or(findings.first()) {
                self.tries.push(Try {
                    number: self.shots,
                    set: self.dials.setting(&self.level),
                    told: finding.told.clone(),
                });
            }
        }
        self.enter(Phase::Aim);
    }

    fn next_level(&self, cx: &Context) -> Next {
        let number = self.number + 1;
        if number < cx.shelf.count() {
            Next::Replace(Place::Level { number })
        } else {
            Next::Back
        }
    }

    fn scroll_by(&mut self, rows: i16, cx: &Context) {
        let mut scroll = self.scroll;
        let area = view::layout(self, cx.body).panel;
        let look = cx.settings.look();
        scroll.by(rows, area, look, |lines| panel::write(self, lines, cx));
        self.scroll = scroll;
    }

    fn hint(&mut self, cx: &Context) {
        self.hints = (self.hints + 1).min(self.level.hints.len());
        self.scroll_by(i16::MAX, cx);
    }

    fn key(&mut self, key: Key, cx: &mut Context) -> Next {
        match key {
            Key::PageDown => {
                self.scroll_by(PAGE, cx);
                return Next::Stay;
            }
            Key::PageUp => {
                self.scroll_by(-PAGE, cx);
                return Next::Stay;
            }
            _ => {}
        }
        match self.phase {
            Phase::Aim => self.aim_key(key, cx),
            Phase::Say(_) => self.say_key(key, cx),
            Phase::Watch(_) => self.watch_key(key, cx),
        }
    }

    fn aim_key(&mut self, key: Key, cx: &mut Context) -> Next {
        if self.dials.update(&self.level, key) {
            return Next::Stay;
        }
        match key {
            Key::Enter | Key::Char(' ') => self.go(cx),
            Key::Char('h' | 'H') => self.hint(cx),
            Key::Char('p' | 'P') => cx.settings.predict = !cx.settings.predict,
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn say_key(&mut self, key: Key, cx: &mut Context) -> Next {
        let Phase::Say(saying) = &mut self.phase else {
            return Next::Ignored;
        };
        match saying.rays.update(key) {
            Outcome::Used => {}
            Outcome::Done(()) => {
                let said = Said::of(&saying.rays);
                let shot = std::mem::take(&mut saying.shot);
                self.shoot(shot, true, Some(said), cx);
            }
            Outcome::Ignored if key == Key::Escape => self.enter(Phase::Aim),
            Outcome::Ignored => return Next::Ignored,
        }
        Next::Stay
    }

    fn watch_key(&mut self, key: Key, cx: &mut Context) -> Next {
        let Phase::Watch(attempt) = &mut self.phase else {
            return Next::Ignored;
        };
        let enlarged = attempt.zoom.is_some();
        if attempt.update(&self.level, key, cx.settings.reduced_motion) {
            let changed = attempt.zoom.is_some() != enlarged;
            if changed || matches!(key, Key::Up | Key::Down | Key::Tab | Key::BackTab) {
                self.scroll = Scroll::default();
            }
            self.keep_if_told(cx);
            return Next::Stay;
        }
        let (told, won) = (attempt.told, attempt.win.is_some());
        match key {
            // What moves is first brought to its end.
            Key::Enter if !told => {
                attempt.update(&self.level, Key::End, false);
                self.keep_if_told(cx);
            }
            Key::Enter | Key::Char('n' | 'N') if told && won => return self.next_level(cx),
            Key::Enter | Key::Escape => self.leave_shot(cx),
            Key::Char('h' | 'H') if told && !won => self.hint(cx),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let layout = view::layout(self, cx.body);
        let cell = (mouse.column, mouse.row);
        let on_picture = layout.picture.contains(cell.into());
        let on_panel = layout.panel.contains(cell.into());
        let pressed = mouse.kind == MouseKind::Down;
        let held = pressed || mouse.kind == MouseKind::Drag;
        let wheel: i16 = match mouse.kind {
            MouseKind::ScrollUp => 1,
            MouseKind::ScrollDown => -1,
            _ => 0,
        };
        if wheel != 0 && on_panel {
            self.scroll_by(-wheel, cx);
            return Next::Stay;
        }
        match &mut self.phase {
            Phase::Aim if wheel != 0 => self.dials.wheel(&self.level, wheel.into()),
            Phase::Aim if held && on_picture => {
                let view = board::view(&self.level, layout.picture);
                let (at, near) = (view.world_at(cell.0, cell.1), view.per_row());
                self.dials.drag(&self.level, at, near, pressed);
            }
            Phase::Aim if pressed => {
                let Some(dial) = self.dial_at(layout.panel, cell, cx) else {
                    return Next::Ignored;
                };
                self.dials.choose(&self.level, dial);
            }
            Phase::Say(saying) if held && on_picture => {
                let collision = &saying.impact.collision;
                point_at(layout.picture, collision, &mut saying.rays, cell, pressed);
            }
            Phase::Watch(_) if wheel > 0 => return self.watch_key(Key::Char('.'), cx),
            Phase::Watch(_) if wheel < 0 => return self.watch_key(Key::Char(','), cx),
            Phase::Watch(_) if pressed && on_picture => {
                return self.watch_key(Key::Char(' '), cx);
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    /// The dial whose row is at this cell of the panel, while it is not scrolled.
    fn dial_at(&self, panel: Rect, cell: (u16, u16), cx: &Context) -> Option<usize> {
        if self.scroll != Scroll::default() || !panel.contains(cell.into()) {
            return None;
        }
        let mut scratch = Buffer::empty(panel);
        let mut lines = Lines::new(panel, &mut scratch, cx.settings.look());
        panel::goals(self, &mut lines);
        let row = (cell.1 - panel.y).checked_sub(lines.written())?;
        let count = self.level.adjust.dials().count();
        (usize::from(row) < count).then_some(row.into())
    }
}

impl OldScreen for Play {
    fn title(&self) -> String {
        self.level.title.clone()
    }

    fn status(&self, cx: &Context) -> String {
        let place = format!("level {} of {}", self.number + 1, cx.shelf.count());
        match cx.shelf.stars(self.number) {
            0 => place,
            stars => format!("{place}   {}", words::stars(stars)),
        }
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Key(key) => self.key(*key, cx),
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) -> Next {
        if let Phase::Watch(attempt) = &mut self.phase {
            attempt.advance(passed);
        }
        self.keep_if_told(cx);
        Next::Stay
    }

    fn wake(&self, _cx: &Context) -> Option<Duration> {
        match &self.phase {
            Phase::Watch(attempt) => match &attempt.zoom {
                Some(zoom) => zoom.watch.wake(),
                None => attempt.clock.is_running().then_some(FRAME),
            },
            _ => None,
        }
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }

    fn keys(&self, cx: &Context) -> Vec<Hint> {
        keys::shown(self, cx)
    }

    fn help(&self, _cx: &Context) -> Help {
        keys::help()
    }
}

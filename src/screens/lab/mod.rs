//! The lab: set up one glancing hit, say where both discs will go, watch it.

mod explain;
mod field;
mod mystery;
mod panel;
mod setup;
mod view;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Context, Help, Hint, Next, OldScreen};
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::physics::Frame;
use crate::widgets::hit::{Watch, drag_offset, point_at, side};
use crate::widgets::{NumberEntry, Outcome, RayInput, Scroll, SplitLayout};

use mystery::Mystery;

pub(super) use explain::explain;
pub(crate) use field::Field;
pub(crate) use setup::{PIECE_SETS, Setup};

/// The lab.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lab {
    setup: Setup,
    /// The setting that keys change, and the number being typed for it.
    field: usize,
    entry: NumberEntry,
    /// Whether the last number typed was out of range, and held to it.
    held: bool,
    phase: Phase,
    /// How far the explanation of the shot is scrolled.
    scroll: Scroll,
    /// The coin's mass is hidden, or was until it had been weighed.
    mystery: Option<Mystery>,
}

/// What one is doing in the lab.
#[derive(Debug, Clone, Default)]
enum Phase {
    /// Setting up.
    #[default]
    Aim,
    /// Saying where both will go.
    Predict(RayInput),
    /// Watching.
    Watch(Box<Watch>),
}

impl Lab {
    /// The lab with a hit set up.
    pub(crate) fn of(setup: Setup) -> Self {
        Self {
            setup,
            ..Self::default()
        }
    }

    /// The setting that keys change.
    fn field(&self) -> Field {
        Field::ALL[self.field.min(Field::ALL.len() - 1)]
    }

    fn commit_entry(&mut self) {
        if let Some(value) = self.entry.take() {
            self.set(value);
        }
    }

    fn set(&mut self, value: f64) {
        let field = self.field();
        self.held = !self.locks(field) && !field.allows(&self.setup, value);
        self.change(|setup| field.set(setup, value));
    }

    /// Changes the chosen setting, unless it is a secret. A coin that was weighed
    /// and is then changed is an ordinary one.
    fn change(&mut self, how: impl FnOnce(&mut Setup)) {
        if self.locks(self.field()) {
            return;
        }
        let before = self.setup.m2_g;
        how(&mut self.setup);
        if self.setup.m2_g.to_bits() != before.to_bits() {
            self.mystery = None;
        }
    }

    /// Whether a setting belongs to a coin that is still to be weighed.
    fn locks(&self, field: Field) -> bool {
        self.mystery.as_ref().is_some_and(|coin| coin.locks(field))
    }

    /// Whether the coin's mass must not be seen.
    fn hides_mass(&self) -> bool {
        self.mystery.as_ref().is_some_and(Mystery::is_open)
    }

    /// How a setting reads: as it is, or as a question.
    fn shown(&self, field: Field) -> String {
        if field == Field::CoinMass && self.hides_mass() {
            "? g".into()
        } else {
            field.shown(&self.setup)
        }
    }

    fn choose(&mut self, field: usize) {
        self.commit_entry();
        self.field = field % Field::ALL.len();
    }

    fn aim_key(&mut self, key: Key, cx: &mut Context) -> Next {
        self.held = false;
        match self.entry.update(key) {
            Outcome::Used => return Next::Stay,
            Outcome::Done(value) => {
                self.set(value);
                return Next::Stay;
            }
            Outcome::Ignored => {}
        }
        match key {
            Key::Up | Key::BackTab => self.choose(self.field + Field::ALL.len() - 1),
            Key::Down | Key::Tab => self.choose(self.field + 1),
            Key::Left => self.step(-1.0),
            Key::Right => self.step(1.0),
            Key::PageDown => self.step(-10.0),
            Key::PageUp => self.step(10.0),
            Key::Char('s' | 'S') => {
                self.commit_entry();
                self.mystery = None;
                self.setup.next_set();
            }
            Key::Char('m') => {
                self.commit_entry();
                self.mystery = Some(Mystery::put_out(&mut self.setup, cx.next_seed()));
            }
            Key::Char('b' | 'B') if !self.locks(Field::Contact) => {
                Field::Contact.step(&mut self.setup, 1.0);
            }
            Key::Char('r' | 'R') => {
                self.entry.take();
                self.mystery = None;
                self.setup = Setup::default();
            }
            Key::Char('p' | 'P') => cx.settings.predict = !cx.settings.predict,
            Key::Enter | Key::Char(' ') => {
                self.commit_entry();
                self.go(cx);
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn step(&mut self, steps: f64) {
        self.commit_entry();
        let field = self.field();
        self.change(|setup| field.step(setup, steps));
    }

    /// From aiming to predicting, or to the shot where no prediction is asked.
    fn go(&mut self, cx: &Context) {
        self.phase = if cx.settings.predict {
            Phase::Predict(RayInput::new(side(&self.setup.collision())))
        } else {
            self.shoot(None, cx)
        };
    }

    fn shoot(&mut self, rays: Option<&RayInput>, cx: &Context) -> Phase {
        let said = rays.and_then(RayInput::said);
        let reduced = cx.settings.reduced_motion;
        self.scroll = Scroll::default();
        Phase::Watch(Box::new(Watch::new(self.setup.collision(), said, reduced)))
    }

    fn key(&mut self, key: Key, cx: &mut Context) -> Next {
        match &mut self.phase {
            Phase::Aim => return self.aim_key(key, cx),
            Phase::Predict(rays) => match rays.update(key) {
                Outcome::Used => {}
                Outcome::Done(()) => {
                    let rays = rays.clone();
                    self.phase = self.shoot(Some(&rays), cx);
                }
                Outcome::Ignored if key == Key::Escape => self.phase = Phase::Aim,
                Outcome::Ignored => return Next::Ignored,
            },
            Phase::Watch(watch) => {
                let weighing = watch.is_told() && watch.frame() == Frame::Laboratory;
                if weighing && self.mystery.as_mut().is_some_and(|coin| coin.update(key)) {
                    return Next::Stay;
                }
                if watch.update(key) {
                    return Next::Stay;
                }
                match key {
                    Key::PageUp => self.scroll_by(-8, cx),
                    Key::PageDown => self.scroll_by(8, cx),
                    Key::Up => self.scroll_by(-1, cx),
                    Key::Down => self.scroll_by(1, cx),
                    Key::Enter | Key::Escape | Key::Char('n' | 'N' | ' ') => {
                        self.phase = Phase::Aim;
                    }
                    _ => return Next::Ignored,
                }
            }
        }
        Next::Stay
    }

    fn scroll_by(&mut self, rows: i16, cx: &Context) {
        if let Phase::Watch(watch) = &self.phase {
            let area = SplitLayout::new(cx.body).panel;
            let mut scroll = self.scroll;
            scroll.by(rows, area, cx.settings.look(), |lines| {
                panel::write_shot(self, watch, lines);
            });
            self.scroll = scroll;
        }
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &Context) -> Next {
        let layout = SplitLayout::new(cx.body);
        let cell = (mouse.column, mouse.row);
        let on_picture = layout.picture.contains(cell.into());
        let pressed = mouse.kind == MouseKind::Down;
        let held = pressed || mouse.kind == MouseKind::Drag;
        match &mut self.phase {
            Phase::Aim => {
                if held && on_picture {
                    self.entry.take();
                    let collision = self.setup.collision();
                    let offset = drag_offset(layout.picture, &collision, cell);
                    Field::Offset.set(&mut self.setup, (offset * 2000.0).round() / 2.0);
                } else if pressed && let Some(field) = panel::field_at(layout.panel, cell) {
                    self.choose(field);
                } else {
                    match mouse.kind {
                        MouseKind::ScrollUp => Field::Speed.step(&mut self.setup, 1.0),
                        MouseKind::ScrollDown => Field::Speed.step(&mut self.setup, -1.0),
                        _ => return Next::Ignored,
                    }
                }
            }
            Phase::Predict(rays) if held && on_picture => {
                let collision = self.setup.collision();
                point_at(layout.picture, &collision, rays, cell, pressed);
            }
            Phase::Watch(watch) => {
                let key = match mouse.kind {
                    MouseKind::ScrollUp => Key::Char('.'),
                    MouseKind::ScrollDown => Key::Char(','),
                    MouseKind::Down if on_picture => Key::Char(' '),
                    _ => return Next::Ignored,
                };
                if !watch.update(key) {
                    self.phase = Phase::Aim;
                }
            }
            Phase::Predict(_) => return Next::Ignored,
        }
        Next::Stay
    }
}

impl OldScreen for Lab {
    fn title(&self) -> String {
        "lab".into()
    }

    fn status(&self, _cx: &Context) -> String {
        let name = self
            .setup
            .piece_set()
            .map_or("own pieces", |i| PIECE_SETS[i].name);
        let (m1, m2) = (self.setup.m1_g, self.setup.m2_g);
        let e = self.setup.restitution;
        if self.hides_mass() {
            format!("mystery coin: {m1} g on ? g   e = {e:.2}")
        } else {
            format!("{name}: {m1} g on {m2} g   e = {e:.2}")
        }
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Key(key) => self.key(*key, cx),
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, passed: Duration, _cx: &mut Context) -> Next {
        if let Phase::Watch(watch) = &mut self.phase {
            watch.advance(passed);
        }
        Next::Stay
    }

    fn wake(&self, _cx: &Context) -> Option<Duration> {
        match &self.phase {
            Phase::Watch(watch) => watch.wake(),
            _ => None,
        }
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }

    fn keys(&self, cx: &Context) -> Vec<Hint> {
        match &self.phase {
            Phase::Aim => vec![
                Hint::new(
                    "Enter",
                    if cx.settings.predict {
                        "say where"
                    } else {
                        "shoot"
                    },
                ),
                Hint::new("Up Down", "choose"),
                Hint::new("Left Right", "change"),
                Hint::new("0-9", "type"),
                Hint::new("s", "pieces"),
                Hint::new("b", "slip/stick"),
                Hint::new("m", "mystery coin"),
                Hint::new("Esc", "back"),
            ],
            Phase::Predict(_) => vec![
                Hint::new("arrows", "turn"),
                Hint::new("0-9", "type"),
                Hint::new("x", "stays still"),
                Hint::new("Enter", "next, then shoot"),
                Hint::new("Esc", "back"),
            ],
            Phase::Watch(watch) => {
                let space = if watch.clock().is_over() {
                    "new shot"
                } else {
                    "go on"
                };
                vec![
                    Hint::new("Space", space),
                    Hint::new(", .", "step"),
                    Hint::new("a", "again"),
                    Hint::new("f", "frame"),
                    Hint::new("1-7", "layers"),
                    Hint::new("Esc", "set up"),
                    Hint::new("< >", "scrub"),
                ]
            }
        }
    }

    fn help(&self, _cx: &Context) -> Help {
        Help {
            text: vec![
                "One striker, one coin. Set how far off-centre they meet (the offset b), say where both will go, then watch: time slows at the contact and stops there, and the picture explains itself.",
                "The line of impact n joins the two centres at the contact. Along it the discs push each other; across it, along t, nothing pushes, so nothing changes. Everything else follows from that.",
                "Angles count from the striker's direction: for the striker to the side away from the coin, for the coin to its own side.",
                "The coin can be moved by the mouse, the rays too; the wheel changes the speed.",
            ],
            keys: vec![
                Hint::new("Up Down", "choose a setting, or turn a ray by 5°"),
                Hint::new(
                    "Left Right",
                    "change it, or turn a ray by 1°; PageUp and PageDown change faster",
                ),
                Hint::new("0-9 . -", "type a number; Enter sets it, Esc gives it up"),
                Hint::new("s", "next set of pieces"),
                Hint::new("b", "smooth discs that slip, or discs that stick"),
                Hint::new("m", "a mystery coin: find its mass from the two angles"),
                Hint::new("p", "predict before each shot, or just watch"),
                Hint::new("r", "back to the first setting"),
                Hint::new("Tab", "next setting, or the other ray"),
                Hint::new("x", "this disc will stay still"),
                Hint::new("Enter", "go on: set up, say where, shoot"),
                Hint::new("Space", "go on from the contact"),
                Hint::new(", .", "step through the hit"),
                Hint::new("< >", "bigger steps; Home and End for the ends"),
                Hint::new("a", "play it again"),
                Hint::new(
                    "f",
                    "see it from the centre of mass, or from the coin's own frame",
                ),
                Hint::new(
                    "1-7",
                    "layers: line of impact, split, velocities, angles, triangle, trails, what you said",
                ),
                Hint::new("n", "set up another shot"),
                Hint::new(
                    "PageUp PageDown",
                    "scroll an explanation that is longer than its place",
                ),
            ],
        }
    }
}

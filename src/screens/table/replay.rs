//! Watching a stroke: the one just made or an earlier one.

use std::time::Duration;

use glam::DVec2;

use crate::game::{Game, Piece};
use crate::messages::Key;
use crate::physics::{DiscState, Shot};
use crate::widgets::hit::FRAME;
use crate::widgets::replay::{Impact, ShotClock, WatchRate, impacts};

/// Seconds that `,` and `.` step by.
const STEP: f64 = 0.02;
/// Seconds that `<` and `>` scrub by.
const SCRUB: f64 = 0.25;

/// A stroke being watched.
#[derive(Debug, Clone)]
pub(super) struct Replay {
    /// The number of the move it was.
    pub(super) number: usize,
    /// Its shot.
    pub(super) shot: Shot,
    /// What each disc of the shot is.
    pub(super) pieces: Vec<Piece>,
    /// All its impacts.
    pub(super) impacts: Vec<Impact>,
    /// The one that is chosen, while they are listed.
    pub(super) chosen: Option<usize>,
    /// The time to go back to when the list is put away.
    listed_at: f64,
    /// Its clock.
    pub(super) clock: ShotClock,
}

impl Replay {
    /// A stroke on the board as it lay in `before`.
    pub(super) fn new(number: usize, shot: Shot, before: &Game, reduced: bool) -> Self {
        let coins = before.coins().iter().map(|coin| coin.piece);
        Self {
            number,
            pieces: std::iter::once(Piece::Striker).chain(coins).collect(),
            impacts: impacts(&shot, 0).collect(),
            chosen: None,
            listed_at: 0.0,
            clock: ShotClock::new(shot.duration(), WatchRate::REAL, reduced),
            shot,
        }
    }

    /// The discs on the board now, with where they are.
    pub(super) fn discs(&self) -> impl Iterator<Item = (usize, Piece, DVec2)> + '_ {
        let time = self.clock.time();
        self.pieces
            .iter()
            .enumerate()
            .filter_map(move |(disc, piece)| {
                let now = self.shot.at(disc, time);
                (now.state != DiscState::Pocketed).then_some((disc, *piece, now.position))
            })
    }

    /// The impact that is chosen.
    pub(super) fn impact(&self) -> Option<&Impact> {
        self.impacts.get(self.chosen?)
    }

    /// Lists the impacts, beginning with the one nearest before now, or puts the
    /// list away.
    pub(super) fn toggle_list(&mut self) {
        self.chosen = match self.chosen {
            Some(_) => return self.put_list_away(),
            None => {
                let now = self.clock.time();
                self.listed_at = now;
                let over = self.clock.is_over();
                let before = self.impacts.partition_point(|impact| impact.time <= now);
                // At the end, the first: that is the one the player aimed at.
                let near = if over { 0 } else { before.saturating_sub(1) };
                (!self.impacts.is_empty()).then_some(near)
            }
        };
        self.show_chosen();
    }

    fn put_list_away(&mut self) {
        self.chosen = None;
        self.clock.seek(self.listed_at);
    }

    fn choose(&mut self, further: bool) {
        let Some(chosen) = self.chosen else {
            return self.toggle_list();
        };
        let last = self.impacts.len().saturating_sub(1);
        self.chosen = Some(if further {
            (chosen + 1).min(last)
        } else {
            chosen.saturating_sub(1)
        });
        self.show_chosen();
    }

    /// Chooses an impact of the list.
    pub(super) fn choose_number(&mut self, number: usize) {
        if number < self.impacts.len() {
            self.chosen = Some(number);
            self.show_chosen();
        }
    }

    fn show_chosen(&mut self) {
        if let Some(impact) = self.impact() {
            let time = impact.time;
            self.clock.seek(time);
        }
    }

    /// Takes a key: time and the list. Says whether it was one of them.
    pub(super) fn update(&mut self, key: Key) -> bool {
        match key {
            Key::Char(' ') if !self.clock.is_over() => self.clock.go_on(),
            Key::Char(',') | Key::Left => self.clock.step(-STEP),
            Key::Char('.') | Key::Right => self.clock.step(STEP),
            Key::Char('<') => self.clock.step(-SCRUB),
            Key::Char('>') => self.clock.step(SCRUB),
            Key::Home => self.clock.seek(0.0),
            Key::End => self.clock.seek(f64::INFINITY),
            Key::Char('a' | 'A') => {
                self.chosen = None;
                self.clock.rewind();
            }
            Key::Char('+' | '=') => self.clock.set_rate(self.clock.rate().faster(1)),
            Key::Char('-') => self.clock.set_rate(self.clock.rate().faster(-1)),
            Key::Char('i' | 'I') => self.toggle_list(),
            Key::Up => self.choose(false),
            Key::Down => self.choose(true),
            Key::Escape if self.chosen.is_some() => self.put_list_away(),
            _ => return false,
        }
        true
    }

    /// Lets time pass on the screen.
    pub(super) fn advance(&mut self, passed: Duration) {
        self.clock.advance(passed);
    }

    /// When it next needs time.
    pub(super) fn wake(&self) -> Option<Duration> {
        self.clock.is_running().then_some(FRAME)
    }
}

//! What the player sets before the shot.

use glam::DVec2;

use crate::levels::{Dial, Level, LevelAim, Range};
use crate::messages::Key;
use crate::physics::units::mm_from_m;
use crate::widgets::{NumberEntry, Outcome};

/// Parts of a step that the keys for fine steps turn by.
const FINE: f64 = 0.1;
/// Steps that the keys for big steps turn by.
const BIG: f64 = 10.0;

/// The dials of a level, the one that keys turn and the number being typed for it.
#[derive(Debug, Clone)]
pub(super) struct Dials {
    pub(super) aim: LevelAim,
    chosen: usize,
    entry: NumberEntry,
    /// What the mouse drags.
    dragged: Option<Dial>,
}

impl Dials {
    /// As the level opens.
    pub(super) fn new(level: &Level) -> Self {
        Self {
            aim: level.start(),
            chosen: 0,
            entry: NumberEntry::default(),
            dragged: None,
        }
    }

    /// The dial that keys turn.
    pub(super) fn chosen(&self, level: &Level) -> Option<(Dial, Range)> {
        level.adjust.dials().nth(self.chosen)
    }

    /// Chooses a dial by its place in the list.
    pub(super) fn choose(&mut self, level: &Level, at: usize) {
        self.commit(level);
        self.chosen = at % level.adjust.dials().count().max(1);
    }

    /// Takes over a number that was typed and not entered.
    pub(super) fn commit(&mut self, level: &Level) {
        if let Some(number) = self.entry.take()
            && let Some((dial, _)) = self.chosen(level)
        {
            self.set(level, dial, number);
        }
    }

    /// Takes a key. Says whether it was one of the dials'.
    pub(super) fn update(&mut self, level: &Level, key: Key) -> bool {
        let fine = matches!(key, Key::Char('.')) && !self.entry.is_open();
        if !fine {
            match self.entry.update(key) {
                Outcome::Used => return true,
                Outcome::Done(number) => {
                    if let Some((dial, _)) = self.chosen(level) {
                        self.set(level, dial, number);
                    }
                    return true;
                }
                Outcome::Ignored => {}
            }
        }
        let count = level.adjust.dials().count();
        match key {
            Key::Up | Key::BackTab => self.choose(level, self.chosen + count.max(1) - 1),
            Key::Down | Key::Tab => self.choose(level, self.chosen + 1),
            Key::Right => self.turn(level, 1.0),
            Key::Left => self.turn(level, -1.0),
            Key::Char('.') => self.turn(level, FINE),
            Key::Char(',') => self.turn(level, -FINE),
            Key::Char('>') => self.turn(level, BIG),
            Key::Char('<') => self.turn(level, -BIG),
            Key::Char('r' | 'R') => {
                self.entry.take();
                self.aim = level.start();
            }
            _ => return false,
        }
        true
    }

    /// Turns the chosen dial to the right by so many steps: a direction to the right
    /// hand, everything else up.
    fn turn(&mut self, level: &Level, steps: f64) {
        self.commit(level);
        if let Some((dial, _)) = self.chosen(level) {
            let up = if dial == Dial::Direction {
                -steps
            } else {
                steps
            };
            self.step(level, dial, up);
        }
    }

    /// Turns a dial up by so many steps, on a grid of fine steps from where it starts.
    fn step(&mut self, level: &Level, dial: Dial, steps: f64) {
        let (start, fine) = (level.start().get(dial), FINE * dial.step());
        let moved = self.aim.get(dial) + steps * dial.step() - start;
        // Without the dust that rounding leaves on a sum of tenths.
        let setting = start + (moved / fine).round() * fine;
        self.set(level, dial, (setting * 1e6).round() / 1e6);
    }

    /// Sets a dial as near to a number as the level allows; a direction may be
    /// counted from either side of a whole turn.
    fn set(&mut self, level: &Level, dial: Dial, number: f64) {
        let Some(range) = level.adjust.range(dial) else {
            return;
        };
        let turns = if dial == Dial::Direction {
            [0.0, 360.0, -360.0]
        } else {
            [0.0; 3]
        };
        let apart = |number: &f64| (range.nearest(*number) - number).abs();
        let nearest = turns
            .into_iter()
            .map(|turn| number + turn)
            .min_by(|a, b| apart(a).total_cmp(&apart(b)));
        let setting = range.nearest(nearest.unwrap_or(number));
        self.aim = self.aim.with(dial, setting);
    }

    /// How a dial reads: as typed so far, or as it stands.
    pub(super) fn shown(&self, level: &Level, dial: Dial) -> String {
        let typing = self.chosen(level).is_some_and(|(chosen, _)| chosen == dial);
        if typing && self.entry.is_open() {
            return format!("{}_", self.entry.text());
        }
        with_unit(dial, self.aim.get(dial))
    }

    /// All dials as they stand, in one line.
    pub(super) fn setting(&self, level: &Level) -> String {
        let dials = level.adjust.dials();
        let set = dials.map(|(dial, _)| with_unit(dial, self.aim.get(dial)));
        set.collect::<Vec<_>>().join(", ")
    }

    /// The wheel turns the speed, or the chosen dial where the speed is fixed.
    pub(super) fn wheel(&mut self, level: &Level, up: f64) {
        self.commit(level);
        if level.adjust.range(Dial::Speed).is_some() {
            self.step(level, Dial::Speed, up);
        } else {
            self.turn(level, up);
        }
    }

    /// The button went down (`pressed`) or moved over a point of the board: drags the
    /// disc along its line if it was pressed on it, else points the shot there.
    pub(super) fn drag(&mut self, level: &Level, at: DVec2, near: f64, pressed: bool) {
        let scene = level.aimed(&self.aim);
        let Some(piece) = scene.pieces.get(scene.stroke.disc) else {
            return;
        };
        let way = at - piece.at;
        if pressed {
            self.commit(level);
            let on_disc = way.length() <= piece.disc.radius.max(near);
            let may = |dial| level.adjust.range(dial).map(|_| dial);
            self.dragged = may(Dial::Place)
                .filter(|_| on_disc)
                .or_else(|| may(Dial::Direction))
                .or_else(|| may(Dial::Place));
            let dials = || level.adjust.dials();
            let place = dials().position(|(dial, _)| Some(dial) == self.dragged);
            self.chosen = place.unwrap_or(self.chosen);
        }
        match self.dragged {
            Some(Dial::Place) => self.snap(level, Dial::Place, mm_from_m(at.x)),
            Some(Dial::Direction) if way.length() > near => {
                let degrees = way.to_angle().to_degrees();
                self.snap(level, Dial::Direction, degrees);
            }
            _ => {}
        }
    }

    /// Sets a dial by hand, to a whole step.
    fn snap(&mut self, level: &Level, dial: Dial, number: f64) {
        let step = dial.step();
        self.set(level, dial, (number / step).round() * step);
    }
}

/// What a dial is called on the screen.
pub(in crate::screens::levels) fn name(dial: Dial) -> &'static str {
    match dial {
        Dial::Direction => "direction",
        Dial::Speed => "speed",
        Dial::Place => "place",
        Dial::Mass => "mass",
        Dial::Restitution => "restitution",
    }
}

/// A setting with its unit, to one decimal more where fine steps need it.
fn with_unit(dial: Dial, setting: f64) -> String {
    let number = number(dial, setting);
    match dial {
        Dial::Direction => format!("{number}°"),
        Dial::Speed => format!("{number} m/s"),
        Dial::Place => format!("{number} mm"),
        Dial::Mass => format!("{number} g"),
        Dial::Restitution => format!("e = {number}"),
    }
}

fn number(dial: Dial, setting: f64) -> String {
    let decimals = match dial {
        Dial::Place => 0,
        Dial::Direction | Dial::Mass => 1,
        Dial::Speed | Dial::Restitution => 2,
    };
    let short = format!("{setting:.decimals$}");
    let told = short.parse::<f64>();
    let enough = told.is_ok_and(|told| (told - setting).abs() < 0.01 * dial.step());
    if enough {
        short
    } else {
        let decimals = decimals + 1;
        format!("{setting:.decimals$}")
    }
}

/// The range of a dial in words.
pub(super) fn range_words(dial: Dial, range: Range) -> String {
    let (from, to) = (number(dial, range.from), with_unit(dial, range.to));
    match dial {
        Dial::Restitution => format!("from {from} to {}", number(dial, range.to)),
        _ => format!("from {from} to {to}"),
    }
}

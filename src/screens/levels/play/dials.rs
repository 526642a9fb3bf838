//! The dials that the player sets before the shot.

use glam::DVec2;

use super::board::{FirstMet, first_met};
use crate::levels::{Dial, Level, LevelAim, Range};
use crate::physics::units::mm_from_m;
use crate::screens::levels::words::dial_words;
use crate::widgets::input::{Field, FieldValue, FormFields, SettingsForm};

/// A level, and its dials as the player has set them.
#[derive(Debug, Clone)]
pub(super) struct Dials {
    pub(super) level: Level,
    pub(super) aim: LevelAim,
    /// The first contact of the aimed shot.
    pub(super) met: Option<FirstMet>,
    dragged: Option<Dial>,
}

impl FormFields for Dials {
    fn fields(&self) -> Vec<Field> {
        self.fields_of(&self.aim)
    }

    fn set(&mut self, at: usize, value: f64) {
        let dial = self.level.adjust.dials().nth(at);
        if let Some((dial, _)) = dial {
            self.set_dial(dial, value);
        }
    }
}

impl Dials {
    fn fields_of(&self, aim: &LevelAim) -> Vec<Field> {
        let field = |(dial, range): (Dial, Range)| {
            // Turning to the right decreases the angle, and angles that differ by whole turns are
            // the same direction.
            let (range_held, step) = match dial {
                Dial::Direction => ((f64::NEG_INFINITY, f64::INFINITY), -dial.step()),
                _ => ((range.from, range.to), dial.step()),
            };
            let (name, unit, about) = dial_words(dial);
            let value = FieldValue::number(aim.get(dial), range_held, step, unit);
            let [from, to] = [range.from, range.to].map(|end| number(dial, end));
            let about = format!("{about}, from {from} to {to}{unit}");
            Field::new(name, (value, with_unit(dial, aim.get(dial))), about)
        };
        self.level.adjust.dials().map(field).collect()
    }

    pub(super) fn new(level: Level) -> Self {
        let mut dials = Self {
            aim: level.start(),
            met: None,
            level,
            dragged: None,
        };
        dials.reset();
        dials
    }

    /// Restores the level's initial aim.
    pub(super) fn reset(&mut self) {
        self.set_aim(self.level.start());
    }

    fn set_aim(&mut self, aim: LevelAim) {
        self.met = first_met(&self.level.aimed(&aim));
        self.aim = aim;
    }

    /// The index of a dial among the adjustable ones.
    fn place(&self, dial: Dial) -> Option<usize> {
        self.level.adjust.dials().position(|(own, _)| own == dial)
    }

    /// Sets a dial as close to a number as the level allows; a direction may differ from the number
    /// by a whole turn.
    fn set_dial(&mut self, dial: Dial, number: f64) {
        let Some(range) = self.level.adjust.range(dial) else {
            return;
        };
        let turns: &[f64] = match dial {
            Dial::Direction => &[0.0, 360.0, -360.0],
            _ => &[0.0],
        };
        let apart = |number: &f64| (range.nearest(*number) - number).abs();
        let counted = turns.iter().map(|turn| number + turn);
        let nearest = counted.min_by(|a, b| apart(a).total_cmp(&apart(b)));
        let setting = range.nearest(nearest.unwrap_or(number));
        self.set_aim(self.aim.with(dial, setting));
    }

    /// The values of all dials, in one line.
    pub(super) fn setting(&self) -> String {
        let set = self.fields().into_iter().map(|field| field.shown);
        set.collect::<Vec<_>>().join(", ")
    }

    /// The names of all dials, each with its value in this aim.
    pub(super) fn words_of(&self, aim: &LevelAim) -> String {
        let set = self.fields_of(aim).into_iter();
        let set = set.map(|field| format!("{} {}", field.name, field.shown));
        set.collect::<Vec<_>>().join(", ")
    }

    /// Handles the wheel, which changes the speed, or the chosen dial if the speed is fixed.
    pub(super) fn wheel(&mut self, form: &mut SettingsForm, up: f64) {
        form.commit(self);
        let chosen = form.selected(self.level.adjust.dials().count());
        form.step_at(self.place(Dial::Speed).unwrap_or(chosen), up, self);
    }

    /// Handles the mouse at a point on the board, where the button was `pressed` or, if not, the
    /// mouse was moved with the button down. If the level lets the player set both the place and
    /// the direction, drags the disc along its line if the button was pressed on the disc,
    /// otherwise aims the shot at that point.
    pub(super) fn drag(&mut self, form: &mut SettingsForm, at: DVec2, near: f64, pressed: bool) {
        let scene = self.level.aimed(&self.aim);
        let Some(piece) = scene.pieces.get(scene.stroke.disc) else {
            return;
        };
        let way = at - piece.at;
        if pressed {
            let on_disc = way.length() <= piece.disc.radius.max(near);
            let may = |dial| self.level.adjust.range(dial).map(|_| dial);
            self.dragged = may(Dial::Place)
                .filter(|_| on_disc)
                .or_else(|| may(Dial::Direction))
                .or_else(|| may(Dial::Place));
            form.commit(self);
            if let Some(place) = self.dragged.and_then(|dial| self.place(dial)) {
                form.select(place, self);
            }
        }
        match self.dragged {
            Some(Dial::Place) => self.snap(Dial::Place, mm_from_m(at.x)),
            Some(Dial::Direction) if way.length() > near => {
                self.snap(Dial::Direction, way.to_angle().to_degrees());
            }
            _ => {}
        }
    }

    /// A sentence about what can be dragged on the board.
    pub(super) fn drag_words(&self) -> Option<&'static str> {
        let may = |dial| self.level.adjust.range(dial).is_some();
        match (may(Dial::Place), may(Dial::Direction)) {
            (true, true) => Some("Drag the striker to place it, and beside it to aim."),
            (true, false) => Some("Drag the striker to place it."),
            (false, true) => Some("Drag in the picture to aim."),
            (false, false) => None,
        }
    }

    /// Sets a dial with the mouse, to a whole step.
    fn snap(&mut self, dial: Dial, number: f64) {
        let step = dial.step();
        self.set_dial(dial, (number / step).round() * step);
    }
}

/// A setting with its unit, with one more decimal if fine steps require it.
fn with_unit(dial: Dial, setting: f64) -> String {
    let number = number(dial, setting);
    match dial {
        Dial::Restitution => format!("e = {number}"),
        _ => format!("{number}{}", dial_words(dial).1),
    }
}

fn number(dial: Dial, setting: f64) -> String {
    let decimals = match dial {
        Dial::Place => 0,
        Dial::Direction | Dial::Mass => 1,
        Dial::Speed | Dial::Restitution => 2,
    };
    let short = format!("{setting:.decimals$}");
    let watched = short.parse::<f64>();
    match watched.is_ok_and(|watched| (watched - setting).abs() < 0.01 * dial.step()) {
        true => short,
        false => format!("{setting:.*}", decimals + 1),
    }
}

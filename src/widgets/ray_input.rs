//! Saying where both discs will go: two rays to turn, or two angles to type.

use super::entry::{NumberEntry, Typed};
use super::{Lines, Role};
use crate::messages::Key;
use crate::quiz::{Ray, Rays};

/// Furthest that a ray can be turned, in degrees either way.
const FURTHEST: f64 = 180.0;

/// A prediction in the making.
///
/// On the screen, angles are in degrees from the direction of the striker: the
/// striker's positive to the side away from the coin, the coin's positive to the
/// coin's own side. `None` is a disc that stays still.
#[derive(Debug, Clone, PartialEq)]
pub struct RayInput {
    angles_deg: [Option<f64>; 2],
    turning: Ray,
    /// The one ray that is asked for, if not both are.
    only: Option<Ray>,
    side: f64,
    entry: NumberEntry,
}

/// What a key meant to a [`RayInput`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turned {
    /// Nothing: it is somebody else's key.
    Ignored,
    /// A ray was turned, or another one chosen.
    Turning,
    /// Both have been said.
    Done,
}

impl RayInput {
    /// Both rays straight ahead. `side` is +1 where the coin lies to the right of
    /// the striker's way and −1 where it lies to the left.
    pub fn new(side: f64) -> Self {
        Self {
            angles_deg: [Some(0.0); 2],
            turning: Ray::Striker,
            only: None,
            side,
            entry: NumberEntry::default(),
        }
    }

    /// The same with these rays said, to be changed.
    #[must_use]
    pub fn saying(mut self, rays: &Rays) -> Self {
        for ray in Ray::BOTH {
            let angle = rays.get(ray).map(|angle| self.side * angle.to_degrees());
            // As it was typed, whatever rounding left.
            let angle = angle.map(|angle| (angle * 1e6).round() / 1e6 + 0.0);
            self.angles_deg[index(ray)] = angle;
        }
        self
    }

    /// The same with one ray alone to be said. The other one reads as a disc that
    /// stays still.
    #[must_use]
    pub fn only(mut self, ray: Ray) -> Self {
        self.angles_deg = [None; 2];
        self.angles_deg[index(ray)] = Some(0.0);
        Self {
            turning: ray,
            only: Some(ray),
            ..self
        }
    }

    /// Whether a ray is to be said.
    pub fn asks(&self, ray: Ray) -> bool {
        self.only.is_none_or(|only| only == ray)
    }

    /// Whether Enter ends it: the last ray that is asked for is being turned.
    pub fn is_last(&self) -> bool {
        self.only.is_some() || self.turning == Ray::Target
    }

    /// What has been said so far.
    pub fn said(&self) -> Rays {
        let signed = |angle: Option<f64>| angle.map(|angle| (self.side * angle).to_radians());
        Rays {
            striker: signed(self.angles_deg[0]),
            target: signed(self.angles_deg[1]),
        }
    }

    /// The ray that keys turn.
    pub fn turning(&self) -> Ray {
        self.turning
    }

    /// Takes a key.
    pub fn update(&mut self, key: Key) -> Turned {
        match self.entry.update(key) {
            Typed::Editing => {
                if let Some(angle) = self.entry.value() {
                    self.set(Some(angle));
                }
                return Turned::Turning;
            }
            Typed::Entered(angle) => {
                self.set(Some(angle));
                return self.next();
            }
            Typed::Ignored => {}
        }
        match key {
            Key::Right => self.turn(1.0),
            Key::Left => self.turn(-1.0),
            Key::Up => self.turn(5.0),
            Key::Down => self.turn(-5.0),
            Key::Char('x' | 'X') => {
                self.entry.take();
                let still = self.angle_deg(self.turning).is_none();
                self.set(still.then_some(0.0));
            }
            Key::Tab | Key::BackTab => self.choose(other(self.turning)),
            Key::Enter => return self.next(),
            _ => return Turned::Ignored,
        }
        Turned::Turning
    }

    /// Points a ray by hand, to the whole degree.
    pub fn point(&mut self, ray: Ray, angle_deg: f64) {
        self.choose(ray);
        self.set(Some(angle_deg.round()));
    }

    /// The angle of a ray as the screen counts it; `None` for a disc that stays still.
    pub fn angle_deg(&self, ray: Ray) -> Option<f64> {
        self.angles_deg[index(ray)]
    }

    /// How the answer for a ray reads: as typed so far, or as it stands.
    pub fn shown(&self, ray: Ray) -> String {
        if ray == self.turning && self.entry.is_open() {
            return format!("{}_", self.entry.text());
        }
        shown(self.angle_deg(ray))
    }

    /// Writes both rays, a row each; `target` is what the struck disc is called.
    pub fn write(&self, lines: &mut Lines, target: &str) {
        let both = [(Ray::Striker, "striker"), (Ray::Target, target)];
        for (ray, name) in both.into_iter().filter(|(ray, _)| self.asks(*ray)) {
            let (mark, role) = if ray == self.turning {
                (">", Role::Selected)
            } else {
                (" ", Role::Text)
            };
            lines.pair(&format!("{mark} {name}"), &self.shown(ray), role, role);
        }
    }

    /// How the angle of the ray that keys turn is counted, in a sentence.
    pub fn about(&self, target: &str) -> String {
        match self.turning {
            Ray::Striker => format!(
                "The striker: degrees from its old direction, to the side away from the {target}."
            ),
            Ray::Target => format!(
                "The {target}: degrees from the striker's old direction, to the {target}'s own side."
            ),
        }
    }

    fn next(&mut self) -> Turned {
        if self.is_last() {
            self.entry.take();
            return Turned::Done;
        }
        self.choose(Ray::Target);
        Turned::Turning
    }

    fn choose(&mut self, ray: Ray) {
        self.entry.take();
        self.turning = self.only.unwrap_or(ray);
    }

    fn set(&mut self, angle: Option<f64>) {
        // Adding 0 turns −0 into 0.
        let held = angle.map(|angle| angle.clamp(-FURTHEST, FURTHEST) + 0.0);
        self.angles_deg[index(self.turning)] = held;
    }

    fn turn(&mut self, degrees: f64) {
        self.entry.take();
        let angle = self.angle_deg(self.turning).unwrap_or(0.0);
        self.set(Some(angle + degrees));
    }
}

/// How an angle in degrees reads on the screen; `None` for a disc that stays still.
pub fn shown(angle_deg: Option<f64>) -> String {
    match angle_deg {
        Some(angle) => format!("{angle:.1}°"),
        None => "stays still".into(),
    }
}

/// The same in as little room as a table has: no unit, and one word for a disc that
/// stays still.
pub fn brief(angle_deg: Option<f64>) -> String {
    angle_deg.map_or("still".into(), |angle| format!("{angle:.1}"))
}

fn index(ray: Ray) -> usize {
    match ray {
        Ray::Striker => 0,
        Ray::Target => 1,
    }
}

fn other(ray: Ray) -> Ray {
    match ray {
        Ray::Striker => Ray::Target,
        Ray::Target => Ray::Striker,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(rays: &mut RayInput, keys: &str) -> Turned {
        let key = |c| match c {
            '\n' => Key::Enter,
            '\t' => Key::Tab,
            '>' => Key::Right,
            '^' => Key::Up,
            c => Key::Char(c),
        };
        keys.chars()
            .fold(Turned::Ignored, |_, c| rays.update(key(c)))
    }

    fn degrees(rays: &RayInput) -> [Option<f64>; 2] {
        Ray::BOTH.map(|ray| rays.angle_deg(ray))
    }

    #[test]
    fn two_numbers_typed_are_a_prediction() {
        let mut rays = RayInput::new(1.0);
        assert_eq!(press(&mut rays, "60\n30\n"), Turned::Done);
        assert_eq!(degrees(&rays), [Some(60.0), Some(30.0)]);
    }

    #[test]
    fn angles_count_from_the_coins_side() {
        let mut rays = RayInput::new(-1.0);
        press(&mut rays, "60\n30\n");
        assert!((rays.said().striker.unwrap() + 60.0_f64.to_radians()).abs() < 1e-12);
        assert!((rays.said().target.unwrap() + 30.0_f64.to_radians()).abs() < 1e-12);
    }

    #[test]
    fn arrows_turn_the_chosen_ray() {
        let mut rays = RayInput::new(1.0);
        press(&mut rays, ">>^\t^");
        assert_eq!(degrees(&rays), [Some(7.0), Some(5.0)]);
    }

    #[test]
    fn a_disc_can_be_said_to_stay_still() {
        let mut rays = RayInput::new(1.0);
        assert_eq!(press(&mut rays, "x\n0\n"), Turned::Done);
        assert_eq!(degrees(&rays), [None, Some(0.0)]);
        assert_eq!(rays.said().striker, None);
    }

    #[test]
    fn half_typed_numbers_count_only_as_far_as_they_are_numbers() {
        let mut rays = RayInput::new(1.0);
        press(&mut rays, "-\t");
        assert_eq!(rays.angle_deg(Ray::Striker), Some(0.0));
        assert_eq!(press(&mut rays, "999"), Turned::Turning);
        assert_eq!(rays.angle_deg(Ray::Target), Some(FURTHEST));
    }
}

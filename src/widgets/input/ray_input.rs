//! Predicting where both discs will go: two rays to turn, or two angles to type.

use strum::{EnumMessage, IntoStaticStr};

use super::{EntryAction, KeyTable, NumberEntry, Outcome};
use crate::messages::Key;
use crate::numbers::{fixed, true_minus};
use crate::physics::Collision;
use crate::quiz::{Ray, Rays};
use crate::widgets::{Role, panel::Panel};

/// The instruction shown while a ray has not been set.
const UNSAID: &str = "Turn the ray, or type its angle.";

/// The instruction shown after an angle that is too large has been entered.
const TOO_LARGE: &str = "Please give an angle from −180° to 180°.";

/// A prediction being entered.
///
/// On the screen, angles are in degrees from the striker's original direction: the striker's angle
/// is positive on the side away from the coin, the coin's angle on the coin's side. A ray is not
/// set until the player turns it, types its angle or marks its disc as staying still.
#[derive(Debug, Clone, PartialEq)]
pub struct RayInput {
    /// The predicted angle of each disc; `Some(None)` for a disc that stays still.
    angles_deg: [Option<Option<f64>>; 2],
    pub(crate) turning: Ray,
    /// The ray to predict, if only one is required.
    only: Option<Ray>,
    side: f64,
    entry: NumberEntry,
    /// Whether the latest action entered an angle of more than 180° to either side.
    refused: bool,
}

/// What the keys do while a prediction is being entered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum RayAction {
    /// turn the ray: Left and Right by 1°, Up and Down by 5°
    Turn(i8),
    /// this disc will be at rest after the collision
    StaysStill,
    /// switch to the other ray
    OtherRay,
    /// go on to the other ray, or continue once both are set
    Next,
    /// type a number for the ray
    Number(EntryAction),
    /// choose which ray to turn
    Choose(Ray),
}

impl RayInput {
    /// The hint that says what can be dragged in a picture with rays.
    pub(crate) const DRAG: &str = "Drag in the picture to turn the ray.";

    /// Creates an input that contains no prediction yet. `side` is +1 if the coin is to the right
    /// of the striker's path and −1 if it is to the left.
    pub(crate) fn new(side: f64) -> Self {
        Self {
            angles_deg: [None; 2],
            turning: Ray::Striker,
            only: None,
            side,
            entry: NumberEntry::default(),
            refused: false,
        }
    }

    /// This input with the given rays, so that the player can change them.
    #[must_use]
    pub(crate) fn saying(mut self, rays: &Rays) -> Self {
        for ray in Ray::BOTH {
            let angle = rays.get(ray).map(|angle| self.side * angle.to_degrees());
            // This removes rounding errors, so that the angle is shown as it was typed.
            let angle = angle.map(|angle| (angle * 1e6).round() / 1e6 + 0.0);
            self.angles_deg[ray as usize] = Some(angle);
        }
        self
    }

    /// This input with only one ray to set. The other disc is assumed to be at rest afterwards.
    #[must_use]
    pub(crate) fn only(mut self, ray: Ray) -> Self {
        self.turning = ray;
        self.only = Some(ray);
        self
    }

    /// Whether the player has to set this ray.
    pub(crate) fn asks(&self, ray: Ray) -> bool {
        self.only.is_none_or(|only| only == ray)
    }

    /// Whether the last required ray is being turned.
    pub(crate) fn is_last(&self) -> bool {
        self.only.is_some() || self.turning == Ray::Target
    }

    /// The prediction; `None` until it is complete.
    pub(crate) fn said(&self) -> Option<Rays> {
        let said = |ray| self.is_said(ray) || !self.asks(ray);
        Ray::BOTH.into_iter().all(said).then(|| self.so_far())
    }

    /// Both rays, if both are required and set.
    pub(crate) fn both(&self) -> Option<Rays> {
        self.said().filter(|_| self.only.is_none())
    }

    /// The rays so far; a disc whose ray is not set is assumed to be at rest afterwards.
    pub(crate) fn so_far(&self) -> Rays {
        let signed = |ray| Some((self.side * self.angle_deg(ray)?).to_radians());
        Rays {
            striker: signed(Ray::Striker),
            target: signed(Ray::Target),
        }
    }

    /// Whether a ray is set.
    pub(crate) fn is_said(&self, ray: Ray) -> bool {
        self.angles_deg[ray as usize].is_some()
    }

    /// The keys of the input; `next` is the label of Enter.
    pub(crate) fn keys(&self, next: &'static str) -> KeyTable<RayAction> {
        use RayAction::{Next, OtherRay, StaysStill, Turn};
        KeyTable::new("ray")
            .by(Key::ARROWS, Turn, [5, -5, -1, 1], "turn")
            .with(self.entry.keys(), RayAction::Number)
            .on('x', StaysStill, "stays still")
            .on(Key::Enter, Next, next)
            .on(Key::Tab, OtherRay, "other ray")
            .or([(Key::BackTab, OtherRay)])
            .when(self.only.is_none())
    }

    /// Carries out an action; returns `Done` once the prediction is complete. A typed angle of more
    /// than 180° to either side is refused.
    pub(crate) fn act(&mut self, action: RayAction) -> Outcome {
        self.refused = false;
        match action {
            RayAction::Turn(degrees) => self.turn(degrees.into()),
            RayAction::StaysStill => {
                self.entry.take();
                let still = self.angles_deg[self.turning as usize] == Some(None);
                self.angles_deg[self.turning as usize] = (!still).then_some(None);
            }
            RayAction::OtherRay => self.choose(other(self.turning)),
            RayAction::Choose(ray) => self.choose(ray),
            RayAction::Next => return self.next(),
            RayAction::Number(action) => match self.entry.act(action) {
                Outcome::Done(angle) if is_angle(angle) => {
                    self.set(angle);
                    return self.next();
                }
                Outcome::Done(_) => {
                    self.angles_deg[self.turning as usize] = None;
                    self.refused = true;
                }
                _ => match self.entry.value() {
                    Some(angle) if is_angle(angle) => self.set(angle),
                    Some(_) => self.angles_deg[self.turning as usize] = None,
                    None => {}
                },
            },
        }
        Outcome::Used
    }

    /// Points a ray in a direction, rounded to a whole degree.
    pub(crate) fn point(&mut self, ray: Ray, angle_deg: f64) {
        self.choose(ray);
        self.set(angle_deg.round());
    }

    /// The angle of a ray in degrees, with the screen's signs; `None` for a disc that stays still,
    /// and for a ray that is not set.
    pub(crate) fn angle_deg(&self, ray: Ray) -> Option<f64> {
        self.angles_deg[ray as usize].flatten()
    }

    /// The prediction for a ray as text: the text typed so far, or the current value.
    pub(crate) fn shown(&self, ray: Ray) -> String {
        let typed = self.entry.shown().filter(|_| ray == self.turning);
        typed.unwrap_or_else(|| self.angles_deg[ray as usize].map_or("_".into(), shown))
    }

    /// Writes the required rays, one per row; `target` is the name of the target.
    pub(crate) fn write(&self, panel: &mut Panel<RayAction>, target: &str) {
        let both = [(Ray::Striker, "striker"), (Ray::Target, target)];
        for (ray, name) in both.into_iter().filter(|(ray, _)| self.asks(*ray)) {
            let chosen = ray == self.turning;
            let action = Some(RayAction::Choose(ray));
            panel.field(name, (self.shown(ray), false), (Role::Text, chosen), action);
        }
    }

    /// Writes both predictions, one per row.
    pub(crate) fn write_said<A>(&self, target: &str, panel: &mut Panel<A>) {
        for (ray, name) in [(Ray::Striker, "striker"), (Ray::Target, target)] {
            let (name, shown) = (format!("  {name}"), self.shown(ray));
            panel.coloured_fact(name, shown, Role::Predicted);
        }
    }

    /// The action of the next prompt: entering the typed number, switching to the other ray, or
    /// submitting the prediction.
    pub(crate) fn go_on(&self) -> RayAction {
        match self.entry.is_open() {
            true => RayAction::Number(EntryAction::Enter),
            false => RayAction::Next,
        }
    }

    /// Writes the next prompt: to turn this ray, then to turn the other ray, then `last` once all
    /// rays are set.
    pub(crate) fn write_prompt(&self, panel: &mut Panel<RayAction>, target: &str, last: &str) {
        if self.refused {
            return panel.paragraph(TOO_LARGE, Role::Warn);
        }
        if !self.is_said(self.turning) {
            return panel.paragraph(UNSAID, Role::Key);
        }
        let other = match self.turning {
            Ray::Striker => target,
            Ray::Target => "striker",
        };
        match self.is_done() {
            true => panel.prompt(last, self.go_on()),
            false => panel.prompt(format!("next, the {other}"), self.go_on()),
        }
    }

    /// Writes the rays to set, a sentence on the sign convention for the ray that the keys turn,
    /// and the next prompt, which is `last` once all rays are set.
    pub(crate) fn write_all(&self, panel: &mut Panel<RayAction>, target: &str, last: &str) {
        self.write(panel, target);
        panel.gap();
        panel.paragraph(self.about(target), Role::Text);
        panel.gap();
        self.write_prompt(panel, target, last);
    }

    /// A sentence on the sign convention for the ray that the keys turn.
    pub(crate) fn about(&self, target: &str) -> String {
        match self.turning {
            Ray::Striker => format!(
                "The striker: degrees from its original direction, on the side away from the \
                 {target}."
            ),
            Ray::Target => format!(
                "The {target}: degrees from the striker's original direction, on the {target}'s \
                 side."
            ),
        }
    }

    /// Whether all rays are set and the last one is being turned.
    fn is_done(&self) -> bool {
        self.said().is_some() && self.is_last()
    }

    /// Once this ray is set, switches to the other ray; returns `Done` if this ray is the last one
    /// and all rays are set.
    fn next(&mut self) -> Outcome {
        if !self.is_said(self.turning) {
            return Outcome::Used;
        }
        if self.is_done() {
            self.entry.take();
            return Outcome::Done(());
        }
        self.choose(other(self.turning));
        Outcome::Used
    }

    fn choose(&mut self, ray: Ray) {
        self.entry.take();
        self.turning = self.only.unwrap_or(ray);
    }

    fn set(&mut self, angle_deg: f64) {
        // Adding 0 turns −0 into 0.
        let held = angle_deg.clamp(-Rays::FURTHEST_DEG, Rays::FURTHEST_DEG) + 0.0;
        self.angles_deg[self.turning as usize] = Some(Some(held));
    }

    fn turn(&mut self, degrees: f64) {
        self.entry.take();
        let angle = self.angle_deg(self.turning).unwrap_or(0.0);
        self.set(angle + degrees);
    }
}

fn is_angle(angle_deg: f64) -> bool {
    angle_deg.abs() <= Rays::FURTHEST_DEG
}

/// An angle in degrees as text; `None` is a disc that stays still.
pub fn shown(angle_deg: Option<f64>) -> String {
    match angle_deg {
        Some(_) => format!("{}°", brief(angle_deg)),
        None => "stays still".into(),
    }
}

/// An angle as short text for a table: no unit, and one word for a disc that stays still.
pub(crate) fn brief(angle_deg: Option<f64>) -> String {
    angle_deg.map_or("still".into(), |angle| true_minus(&fixed(angle, 1)))
}

fn other(ray: Ray) -> Ray {
    Ray::BOTH[1 - ray as usize]
}

/// True or predicted directions in degrees, with the signs used on the screen, which depend on the
/// side on which the coin lies.
pub fn degrees(collision: &Collision, rays: &Rays) -> [Option<f64>; 2] {
    Ray::BOTH.map(|ray| {
        let angle = rays.get(ray)?;
        Some(collision.side() * angle.to_degrees() + 0.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(rays: &mut RayInput, keys: &str) -> Outcome {
        let mut last = Outcome::Ignored;
        for c in keys.chars() {
            let key = match c {
                '\n' => Key::Enter,
                '\t' => Key::Tab,
                '>' => Key::Right,
                '^' => Key::Up,
                c => Key::Char(c),
            };
            let action = rays.keys("next").find(key);
            last = action.map_or(Outcome::Ignored, |action| rays.act(action));
        }
        last
    }

    fn degrees(rays: &RayInput) -> [Option<f64>; 2] {
        Ray::BOTH.map(|ray| rays.angle_deg(ray))
    }

    #[test]
    fn two_typed_numbers_make_a_prediction() {
        let mut rays = RayInput::new(1.0);
        assert_eq!(press(&mut rays, "60\n30\n"), Outcome::Done(()));
        assert_eq!(degrees(&rays), [Some(60.0), Some(30.0)]);
    }

    #[test]
    fn enter_alone_sets_no_ray() {
        let mut rays = RayInput::new(1.0);
        assert_eq!(press(&mut rays, "\n\n\n"), Outcome::Used);
        assert_eq!(rays.said(), None);
        assert_eq!(press(&mut rays, "\t30\n"), Outcome::Used);
        assert_eq!(rays.turning, Ray::Striker);
        assert_eq!(press(&mut rays, "60\n\n"), Outcome::Done(()));
    }

    #[test]
    fn signs_of_angles_depend_on_the_coins_side() {
        let mut rays = RayInput::new(-1.0);
        press(&mut rays, "60\n30\n");
        assert!((rays.said().unwrap().striker.unwrap() + 60.0_f64.to_radians()).abs() < 1e-12);
        assert!((rays.said().unwrap().target.unwrap() + 30.0_f64.to_radians()).abs() < 1e-12);
    }

    #[test]
    fn arrows_turn_the_chosen_ray() {
        let mut rays = RayInput::new(1.0);
        press(&mut rays, ">>^\t^");
        assert_eq!(degrees(&rays), [Some(7.0), Some(5.0)]);
    }

    #[test]
    fn a_disc_can_be_predicted_to_stay_still() {
        let mut rays = RayInput::new(1.0);
        assert_eq!(press(&mut rays, "x\n0\n"), Outcome::Done(()));
        assert_eq!(degrees(&rays), [None, Some(0.0)]);
        assert_eq!(rays.said().unwrap().striker, None);
    }

    #[test]
    fn a_typed_text_is_used_only_if_it_is_a_number() {
        let mut rays = RayInput::new(1.0);
        press(&mut rays, "-\t");
        assert_eq!(rays.said(), None);
    }

    #[test]
    fn an_angle_of_more_than_180_degrees_is_refused() {
        let mut rays = RayInput::new(1.0);
        assert_eq!(press(&mut rays, "99999\n"), Outcome::Used);
        assert_eq!((rays.turning, rays.refused), (Ray::Striker, true));
        assert!(!rays.is_said(Ray::Striker));
        press(&mut rays, "-180\n");
        assert_eq!(rays.angle_deg(Ray::Striker), Some(-180.0));
        assert_eq!((rays.turning, rays.refused), (Ray::Target, false));
    }
}

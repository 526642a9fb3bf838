//! A collision that the player first watches without any explanation and then describes.

use std::time::Duration;

use glam::DVec2;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::{
    Face, HitPace, Markings, Overlays, Watch, WatchAction, degrees, point_at, setup_picture,
};
use crate::messages::Key;
use crate::physics::Collision;
use crate::progress::Observation;
use crate::quiz::Rays;
use crate::widgets::input::{KeyTable, RayAction};
use crate::widgets::panel::Panel;
use crate::widgets::picture::Picture;
use crate::widgets::{Outcome, RayInput, Role, brief};

/// A collision that the player watches first and then describes by setting two rays. Neither ray is
/// set at the start, so that the player's prediction does not suggest the answer.
#[derive(Debug, Clone)]
pub(crate) struct Sighting {
    watch: Watch,
    /// The information given in the picture in which the rays are set.
    given: Markings,
    rays: RayInput,
}

/// What the keys do while the player is describing what they saw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum SightingAction {
    /// go on to the contact and to the end
    GoOn,
    /// set the rays to what you saw
    Say(RayAction),
    /// see the collision again
    Again,
    /// go on without saying what you saw
    Skip,
}

impl Sighting {
    /// Creates a sighting that begins at the start of the collision or, with reduced motion, at the
    /// contact.
    pub(crate) fn new(collision: Collision, given: Markings, pace: HitPace) -> Self {
        let watch = Watch::new(collision, None, pace).at_once();
        Self {
            rays: RayInput::new(collision.side()),
            watch: watch.with_layers(Overlays::NONE),
            given,
        }
    }

    /// Whether the collision is over, so that the rays can be set.
    fn is_over(&self) -> bool {
        self.watch.clock().is_over()
    }

    /// The hint that says what can be dragged, once the rays can be set.
    pub(crate) fn drag(&self) -> Option<&'static str> {
        self.is_over().then_some(RayInput::DRAG)
    }

    pub(crate) fn keys(&self) -> KeyTable<SightingAction> {
        use SightingAction::{Again, GoOn, Say, Skip};
        let keys = KeyTable::new("sighting");
        let keys = match self.is_over() {
            true => {
                keys.with(self.rays.keys("next, then compare"), Say)
                    .on('a', Again, "see it again")
            }
            false => keys.on(' ', GoOn, "go on").or([(Key::Enter, GoOn)]),
        };
        keys.on('s', Skip, "skip")
    }

    /// Carries out an action; returns `Done` with what the player saw, or with `None` if the player
    /// skips the question.
    pub(crate) fn act(&mut self, action: SightingAction) -> Outcome<Option<Rays>> {
        match action {
            SightingAction::GoOn => {
                self.watch.act(WatchAction::GoOn);
                self.pass_contact();
            }
            SightingAction::Say(action) => {
                if self.rays.act(action) == Outcome::Done(()) {
                    return Outcome::Done(self.rays.said());
                }
            }
            SightingAction::Again => self.watch.act(WatchAction::Again),
            SightingAction::Skip => return Outcome::Done(None),
        }
        Outcome::Used
    }

    /// Turns a ray when the player points at the picture.
    pub(crate) fn point(&mut self, picture: Rect, place: DVec2, pressed: bool) {
        if self.is_over() {
            let collision = *self.watch.collision();
            point_at(picture, &collision, &mut self.rays, place, pressed);
        }
    }

    /// Advances by `passed` of screen time.
    pub(crate) fn advance(&mut self, passed: Duration, pace: HitPace) {
        self.watch.advance(passed, pace);
        if pace != HitPace::Still {
            self.pass_contact();
        }
    }

    /// The delay until the picture next has to change.
    pub(crate) fn wake(&self, pace: HitPace) -> Option<Duration> {
        self.watch.wake(pace)
    }

    /// Continues past the contact, where an explained collision would stop.
    fn pass_contact(&mut self) {
        let clock = self.watch.clock();
        if clock.at_contact() && !clock.is_moving() {
            self.watch.act(WatchAction::GoOn);
        }
    }

    /// The title of the picture.
    pub(crate) fn title(&self) -> String {
        match self.is_over() {
            true => "what did you see?".into(),
            false => self.watch.slowed_title(),
        }
    }

    /// Until the collision is over, the picture of the moving discs; afterwards, the picture before
    /// the collision, with the rays.
    pub(crate) fn picture(&self, area: Rect) -> Picture {
        match self.is_over() {
            true => {
                let collision = self.watch.collision();
                let faces = Face::STRIKER_AND_COIN;
                setup_picture(area, faces, collision, self.given, Some(&self.rays))
            }
            false => self.watch.picture(area),
        }
    }

    /// Writes the question, and the rays once they can be set.
    pub(crate) fn write(&self, target: &str, panel: &mut Panel<SightingAction>) {
        if !self.is_over() {
            panel.heading("Watch where they go");
            let text = "In a moment carrom asks what you saw, before it shows any angle.";
            panel.paragraph(text, Role::Text);
            return panel.prompt("go on without answering", SightingAction::Skip);
        }
        panel.heading("What did you see?");
        panel.part(SightingAction::Say, |panel| self.rays.write(panel, target));
        panel.gap();
        let text = "Set both rays to where the discs really went, whatever you predicted.";
        panel.paragraph(text, Role::Text);
        panel.worth(1, |panel| {
            panel.gap();
            panel.paragraph(self.rays.about(target), Role::Dim);
        });
        panel.gap();
        panel.part(SightingAction::Say, |panel| {
            self.rays.write_prompt(panel, target, "compare");
        });
        panel.prompts([
            ("see it again", SightingAction::Again),
            ("go on without answering", SightingAction::Skip),
        ]);
    }
}

/// Writes what the player saw, and compares it with the prediction and the true outcome.
pub(crate) fn write_observation<A>(
    collision: &Collision,
    observation: &Observation,
    panel: &mut Panel<A>,
) {
    let [striker, target] = degrees(collision, &observation.seen).map(brief);
    panel.coloured_fact("you saw", format!("{striker}, {target}"), Role::Text);
    panel.paragraph(observation.words(), Role::Text);
}

#[cfg(test)]
mod tests {
    use ratatui::buffer::Buffer;

    use super::*;
    use crate::physics::CollisionSpec;
    use crate::widgets::{Look, cells::text};

    const PACES: [HitPace; 3] = [HitPace::Flowing, HitPace::Waiting, HitPace::Still];

    fn press(sighting: &mut Sighting, keys: &str) -> Outcome<Option<Rays>> {
        let mut last = Outcome::Ignored;
        for letter in keys.chars() {
            let key = if letter == '\n' {
                Key::Enter
            } else {
                Key::Char(letter)
            };
            let action = sighting.keys().find(key);
            last = action.map_or(Outcome::Ignored, |action| sighting.act(action));
        }
        last
    }

    fn run(sighting: &mut Sighting, pace: HitPace) {
        for _ in 0..2000 {
            if let Some(wake) = sighting.wake(pace) {
                sighting.advance(wake, pace);
            } else if sighting.drag().is_none() {
                press(sighting, "\n");
            }
        }
    }

    #[test]
    fn the_collision_runs_to_its_end_and_then_the_rays_are_empty() {
        for pace in PACES {
            let collision = CollisionSpec::default().collision();
            let mut sighting = Sighting::new(collision, Markings::ALL, pace);
            run(&mut sighting, pace);
            assert!(sighting.drag().is_some(), "{pace:?}");
            assert_eq!(press(&mut sighting, "\n\n"), Outcome::Used);
            press(&mut sighting, "a");
            assert!(sighting.drag().is_none());
            run(&mut sighting, pace);
            let Outcome::Done(Some(seen)) = press(&mut sighting, "58\n31\n") else {
                panic!("{pace:?}: nothing was seen");
            };
            assert!((seen.striker.unwrap().to_degrees() - 58.0).abs() < 1e-9);
            assert_eq!(press(&mut sighting, "s"), Outcome::Done(None));
        }
    }

    /// Watching relies on the eye alone: the picture has no angles, arrows or paths.
    #[test]
    fn no_number_of_the_outcome_is_drawn() {
        let collision = CollisionSpec::default().collision();
        let mut sighting = Sighting::new(collision, Markings::ALL, HitPace::Flowing);
        while !sighting.is_over() {
            let area = Rect::new(0, 0, 60, 24);
            let mut buf = Buffer::empty(area);
            sighting.picture(area).draw(&mut buf, &Look::default());
            let drawn = text(&buf);
            let is_sign = |c: char| c.is_ascii_digit() || c == '°' || c == 'v' || c == 'u';
            assert!(!drawn.contains(is_sign), "{drawn}");
            sighting.advance(super::super::FRAME, HitPace::Flowing);
        }
    }
}

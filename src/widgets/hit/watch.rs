//! Watching a collision: the clock, layers and reference frame, with their keys.

use std::time::Duration;

use glam::DVec2;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::explanation_step::ExplanationStep;
use super::playback::{HitPace, Playback};
use super::{HitLayout, Overlay, Overlays, moment::Moment, stage::time_in_sight};
use crate::messages::Key;
use crate::physics::{Collision, CollisionOutcome, Frame, Shot};
use crate::quiz::{AimTask, Form, Question, Rays, Response};
use crate::widgets::panels::{impact_angle, masses, offset, rim_facts, separation};
use crate::widgets::{Role, input::KeyTable, panel::Panel, picture::Picture};

/// The fraction of the shot's duration by which the keys `<` and `>` move the playback.
const SCRUB: f64 = 1.0 / 16.0;

/// A collision being watched.
#[derive(Debug, Clone)]
pub(crate) struct Watch {
    pub(super) collision: Collision,
    pub(super) outcome: CollisionOutcome,
    pub(super) shot: Option<Shot>,
    pub(super) clock: Playback,
    pub(super) layers: Overlays,
    /// The reference frame.
    pub(crate) frame: Frame,
    /// The player's prediction.
    pub(crate) said: Option<Rays>,
    pub(super) wanted: Option<AimTask>,
    pub(super) measured: bool,
    pub(super) faces: [Face; 2],
    /// The steps of the explanation at the contact.
    steps: &'static [ExplanationStep],
    /// The layer that the last key press switched on or off, if any.
    switched: Option<Overlay>,
}

/// What the keys do while a collision is being watched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum WatchAction {
    /// go on to the contact, through the explanation step by step, and to the end
    GoOn,
    /// move one step back or forward; at the contact, through the explanation
    Step(i8),
    /// move through the collision in bigger steps, skipping the explanation
    Scrub(i8),
    /// go to the start
    Start,
    /// skip to the last step of the explanation, then to the end
    End,
    /// replay the collision
    Again,
    /// switch between the laboratory, centre-of-mass and coin frames
    Frame,
    /// layers: line of impact, components, velocities, angles, triangle, trails, your prediction
    ToggleLayer(Overlay),
}

/// The appearance of a disc in a collision.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Face {
    /// The colour of the disc.
    pub role: Role,
    /// The letter on the disc.
    pub letter: char,
}

impl Face {
    /// The faces of a striker and a coin.
    pub(crate) const STRIKER_AND_COIN: [Self; 2] =
        [Self::new(Role::Striker, 'S'), Self::new(Role::Coin, 'C')];

    /// A face with this colour and letter.
    pub(crate) const fn new(role: Role, letter: char) -> Self {
        Self { role, letter }
    }
}

impl Watch {
    /// Creates the playback of a collision, with the player's prediction. It begins at the start of
    /// the collision or, with reduced motion, at the contact.
    pub(crate) fn new(collision: Collision, said: Option<Rays>, pace: HitPace) -> Self {
        let (contact, end) = times(&collision);
        let outcome = collision.outcome();
        let mut watch = Self {
            collision,
            outcome,
            shot: collision.shot(contact, end),
            clock: Playback::new(contact, end, Vec::new(), pace),
            layers: Overlays::default(),
            frame: Frame::Laboratory,
            said,
            wanted: None,
            measured: false,
            faces: Face::STRIKER_AND_COIN,
            steps: ExplanationStep::of(&collision, &outcome),
            switched: None,
        };
        // Each step lasts long enough for its text to be read.
        let holds = watch.steps.iter().map(|step| watch.hold(*step)).collect();
        watch.clock = Playback::new(contact, end, holds, pace);
        watch
    }

    /// The collision at the moment of contact, with the whole explanation.
    pub(crate) fn revealed(collision: Collision) -> Self {
        let mut watch = Self::new(collision, None, HitPace::Still);
        watch.reveal();
        watch
    }

    /// This collision without steps at the contact: the whole explanation appears immediately.
    #[must_use]
    pub(crate) fn at_once(self) -> Self {
        Self {
            steps: &[ExplanationStep::Whole],
            clock: self.clock.in_one_step(),
            ..self
        }
    }

    /// This collision in another frame.
    #[must_use]
    pub(crate) fn seen_from(self, frame: Frame) -> Self {
        Self { frame, ..self }
    }

    /// This collision with these faces instead of those of a striker and a coin.
    #[must_use]
    pub(crate) fn with_faces(self, faces: [Face; 2]) -> Self {
        Self { faces, ..self }
    }

    /// The real collision of a question, with the rays of an answer. A question that is answered by
    /// shooting shows the right shot. `None` if the question is not about one collision.
    pub(crate) fn of_question(
        question: &Question,
        said: Option<Response>,
        pace: HitPace,
    ) -> Option<Self> {
        let collision = match &question.form {
            Form::Shot(aim) => aim.with(aim.offset),
            _ => *question.picture.collision()?,
        };
        let rays = said.and_then(Response::rays);
        Some(Self::new(collision, rays, pace).seen_from(question.seen_from()))
    }

    /// This collision with the required path of one disc.
    #[must_use]
    pub(crate) fn with_wanted(mut self, aim: AimTask) -> Self {
        self.wanted = Some(aim);
        self
    }

    /// This collision with the masses and the impact angle beside it.
    #[must_use]
    pub(crate) fn with_measures(mut self) -> Self {
        self.measured = true;
        self
    }

    /// This collision with the given layers.
    #[must_use]
    pub(crate) fn with_layers(self, layers: Overlays) -> Self {
        Self { layers, ..self }
    }

    /// The collision that is watched.
    pub(crate) fn collision(&self) -> &Collision {
        &self.collision
    }

    /// The outcome of the collision.
    pub(crate) fn outcome(&self) -> &CollisionOutcome {
        &self.outcome
    }

    pub(crate) fn clock(&self) -> &Playback {
        &self.clock
    }

    /// The step of the explanation that has been reached; `None` before the contact.
    pub(super) fn step(&self) -> Option<ExplanationStep> {
        self.clock
            .step_reached()
            .and_then(|step| self.steps.get(step).copied())
    }

    /// Whether the outcome may be revealed, which is the case once all steps at the contact have
    /// been shown.
    pub(crate) fn is_revealed(&self) -> bool {
        self.clock.is_revealed()
    }

    /// The title of the picture: `name` in the laboratory frame, otherwise the name of the frame.
    /// After a layer has been switched on or off, the title shows the layer's name.
    pub(crate) fn title(&self, name: &str) -> String {
        if let Some(layer) = self.switched {
            let is_on = self.layers.shows(layer);
            let state = if is_on { "on" } else { "off" };
            return format!("{}: {state}", layer.name());
        }
        match self.frame {
            Frame::Laboratory => name.to_owned(),
            Frame::CentreOfMass => {
                let drift = Frame::CentreOfMass.velocity(&self.collision).length();
                format!("centre-of-mass frame, V = {drift:.2} m/s")
            }
            Frame::Target => "the target's frame".into(),
        }
    }

    /// The [`Watch::title`] of a collision in slow motion.
    pub(crate) fn slowed_title(&self) -> String {
        self.title(&format!("the hit, slowed {:.0}×", self.clock.slowed()))
    }

    /// Writes the current step of the explanation: its heading, if it has one, and its text.
    pub(crate) fn write_explanation<A>(&self, panel: &mut Panel<A>) {
        let (heading, words) = self.explanation();
        if let Some(heading) = heading {
            panel.paragraph(heading, Role::Title);
            panel.gap();
        }
        panel.paragraph(words, Role::Text);
    }

    /// Writes the facts of the collision, except `secret` masses, and everything that has been
    /// revealed so far. Returns whether the explanation should follow, which is the case in the
    /// laboratory frame once everything has been revealed.
    pub(crate) fn write_facts<A>(&self, secret: [bool; 2], panel: &mut Panel<A>) -> bool {
        offset(&self.collision, panel);
        impact_angle(&self.collision, panel);
        masses(&self.collision, secret, panel);
        if !self.is_revealed() {
            panel.gap();
            self.write_explanation(panel);
            return false;
        }
        separation(&self.collision, panel);
        rim_facts(&self.collision, panel);
        panel.gap();
        let seen = match self.frame {
            Frame::Laboratory => return true,
            Frame::CentreOfMass => {
                "Here the discs always move in opposite directions: the total momentum is zero."
            }
            Frame::Target => {
                "In this frame the target is at rest before the collision, so the rules for a \
                 target at rest apply."
            }
        };
        panel.paragraph(seen, Role::Text);
        false
    }

    /// The text for the current step of the explanation; from the contact on, it has a heading.
    pub(crate) fn explanation(&self) -> (Option<String>, String) {
        match self.step() {
            Some(step) => (Some(self.step_heading(step)), self.step_words(step)),
            None => (None, "Watch the contact …".into()),
        }
    }

    /// Goes to the contact and reveals the outcome immediately.
    pub(crate) fn reveal(&mut self) {
        self.clock.reveal();
    }

    /// The keys that control the collision.
    pub(crate) fn keys(&self) -> KeyTable<WatchAction> {
        use WatchAction::{Again, End, Frame, GoOn, Scrub, Start, Step, ToggleLayer};
        let layer = |digit: char| {
            let number = usize::from(digit as u8 - b'1');
            (Key::Char(digit), ToggleLayer(Overlay::ALL[number]))
        };
        // The last layer is the prediction.
        let last = if self.said.is_some() { '7' } else { '6' };
        KeyTable::new("hit")
            .on(' ', GoOn, "go on")
            .or((!self.is_revealed()).then_some((Key::Enter, GoOn)))
            .when(!self.clock.is_over())
            .by([',', '.'], Step, [-1, 1], "step")
            .or([(Key::Left, Step(-1)), (Key::Right, Step(1))])
            .on('a', Again, if self.is_revealed() { "again" } else { "" })
            .on('f', Frame, "frame")
            .each(('1'..=last).map(layer), "layers")
            .by(['<', '>'], Scrub, [-1, 1], "")
            .on(Key::End, End, if self.is_revealed() { "" } else { "all" })
            .on(Key::Home, Start, "")
    }

    /// Carries out an action.
    pub(crate) fn act(&mut self, action: WatchAction) {
        self.switched = None;
        match action {
            WatchAction::GoOn => self.clock.go_on(),
            WatchAction::Step(by) => self.clock.step(by),
            WatchAction::Scrub(by) => self.clock.scrub(SCRUB * f64::from(by)),
            WatchAction::Start => self.clock.halt_at_start(),
            WatchAction::End => self.clock.finish(),
            WatchAction::Again => self.clock.rewind(),
            WatchAction::Frame => {
                self.frame = match self.frame {
                    Frame::Laboratory => Frame::CentreOfMass,
                    Frame::CentreOfMass if self.collision.u2 != DVec2::ZERO => Frame::Target,
                    _ => Frame::Laboratory,
                }
            }
            WatchAction::ToggleLayer(layer) => {
                self.layers.toggle(layer);
                self.switched = Some(layer);
            }
        }
    }

    /// Advances by `passed` of screen time.
    pub(crate) fn advance(&mut self, passed: Duration, pace: HitPace) {
        self.clock.advance(passed, pace);
    }

    /// The delay until the collision next has to advance.
    pub(crate) fn wake(&self, pace: HitPace) -> Option<Duration> {
        self.clock.wake(pace)
    }

    /// The picture at the current time of the clock.
    #[must_use]
    pub(crate) fn picture(&self, area: Rect) -> Picture {
        let stage = HitLayout::new(area, &self.collision);
        Moment { watch: self, stage }.picture()
    }
}

/// The times of the contact and of the end, in the shot's own seconds. They are chosen so that
/// discs of any speed start well apart, and still count as inside the picture at the end.
fn times(collision: &Collision) -> (f64, f64) {
    let largest = collision.striker.radius.max(collision.target.radius);
    let relative = collision.relative_velocity().length();
    let [u1, u2] = [collision.u1, collision.u2].map(DVec2::length);
    let fastest = u1.max(u2).max(relative);
    let lead = (2.6 * largest / fastest).max(1.15 * collision.contact_distance() / relative);
    if lead.is_finite() && lead > 0.0 {
        (lead, lead + time_in_sight(collision).min(1.1 * lead))
    } else {
        // The discs have equal velocities, so nothing happens.
        (1.0, 2.0)
    }
}

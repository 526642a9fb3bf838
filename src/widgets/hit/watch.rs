//! Watching a hit: its clock, its layers and the frame it is seen from, with the
//! keys that work them.

use std::time::Duration;

use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::playback::{BEATS, FRAME, Playback};
use super::{HitLayout, Overlay, Overlays, moment::Moment, stage::time_in_sight};
use crate::messages::Key;
use crate::physics::{Bond, Collision, CollisionOutcome, Frame, Shot};
use crate::quiz::{AimTask, Rays};
use crate::widgets::{Role, input::KeyTable, picture::Picture};

/// Share of the whole that `,` and `.` step by.
const STEP: f64 = 1.0 / 96.0;
/// Share of the whole that `<` and `>` scrub by.
const SCRUB: f64 = 1.0 / 16.0;

/// A hit being watched.
#[derive(Debug, Clone)]
pub(crate) struct Watch {
    collision: Collision,
    pub(super) outcome: CollisionOutcome,
    pub(super) shot: Option<Shot>,
    pub(super) clock: Playback,
    pub(super) layers: Overlays,
    pub(super) frame: Frame,
    pub(super) said: Option<Rays>,
    pub(super) wanted: Option<AimTask>,
    pub(super) measured: bool,
    pub(super) faces: [Face; 2],
}

/// What keys do to a hit that is watched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum WatchAction {
    /// go on from the contact
    GoOn,
    /// step through the hit
    Step(i8),
    /// bigger steps through the hit
    Scrub(i8),
    /// to its start, to its end
    Start,
    /// to its end
    End,
    /// play it again
    Again,
    /// see it from the centre of mass, or from the coin's own frame
    Frame,
    /// layers: line of impact, split, velocities, angles, triangle, trails, what you said
    ToggleLayer(Overlay),
}

/// How a disc of a hit is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Face {
    /// Its colour.
    pub role: Role,
    /// The letter on it.
    pub letter: char,
}

impl Face {
    /// A striker and a coin.
    pub(crate) const STRIKER_AND_COIN: [Self; 2] =
        [Self::new(Role::Striker, 'S'), Self::new(Role::Coin, 'C')];

    /// A colour, and the letter on it.
    pub(crate) const fn new(role: Role, letter: char) -> Self {
        Self { role, letter }
    }
}

impl Watch {
    /// The hit from its start, with what the player said of it. With `reduced`
    /// motion it begins at the contact.
    pub(crate) fn new(collision: Collision, said: Option<Rays>, reduced: bool) -> Self {
        let (contact, end) = times(&collision);
        Self {
            collision,
            outcome: collision.outcome(),
            shot: collision.shot(contact, end),
            clock: Playback::new(contact, end, reduced),
            layers: Overlays::default(),
            frame: Frame::Laboratory,
            said,
            wanted: None,
            measured: false,
            faces: Face::STRIKER_AND_COIN,
        }
    }

    /// The same hit of other pieces than a striker and a coin.
    #[must_use]
    pub(crate) fn with_faces(self, faces: [Face; 2]) -> Self {
        Self { faces, ..self }
    }

    /// The same with the way that one of the two was to be sent.
    #[must_use]
    pub(crate) fn with_wanted(mut self, aim: AimTask) -> Self {
        self.wanted = Some(aim);
        self
    }

    /// The same with the masses and the impact angle written beside it.
    #[must_use]
    pub(crate) fn with_measures(mut self) -> Self {
        self.measured = true;
        self
    }

    /// The same with these layers.
    #[must_use]
    pub(crate) fn with_layers(self, layers: Overlays) -> Self {
        Self { layers, ..self }
    }

    /// The collision that is watched.
    pub(crate) fn collision(&self) -> &Collision {
        &self.collision
    }

    /// What becomes of it.
    pub(crate) fn outcome(&self) -> &CollisionOutcome {
        &self.outcome
    }

    /// Its clock.
    pub(crate) fn clock(&self) -> &Playback {
        &self.clock
    }

    /// What is drawn on top.
    pub(crate) fn layers(&self) -> Overlays {
        self.layers
    }

    /// From where it is seen.
    pub(crate) fn frame(&self) -> Frame {
        self.frame
    }

    /// What the player said.
    pub(crate) fn said(&self) -> Option<&Rays> {
        self.said.as_ref()
    }

    /// Whether it may be told what happened: once the contact is reached and the
    /// departures are drawn.
    pub(crate) fn is_told(&self) -> bool {
        self.clock.beats() == BEATS
    }

    /// What the picture shows, and how: its title.
    pub(crate) fn title(&self) -> String {
        match self.frame() {
            Frame::Laboratory => format!("the hit, slowed {:.0}×", self.clock.slowed()),
            Frame::CentreOfMass => "seen from the centre of mass".into(),
            Frame::Target => "seen riding with the target".into(),
        }
    }

    /// What the picture is just showing, before it is told what happened.
    pub(crate) fn telling(&self) -> &'static str {
        match self.clock.beats() {
            1 => {
                "Contact. The line of impact n joins the two centres: only along it do they push. The tangent t is square to it."
            }
            2 if self.collision.bond == Bond::Stick => {
                "So split u into uₙ along n and uₜ along t. Rims that stick pull along t as well, so here both take part in the hit."
            }
            2 => "So split u: uₙ along n takes part in the hit, uₜ along t does not notice it.",
            _ => "Watch the contact …",
        }
    }

    /// Goes to the contact at once and tells what happened.
    pub(crate) fn tell(&mut self) {
        self.clock.tell();
    }

    /// The keys that work it.
    pub(crate) fn keys(&self) -> KeyTable<WatchAction> {
        use WatchAction::{Again, End, Frame, GoOn, Scrub, Start, Step, ToggleLayer};
        let layer = |digit: char| {
            let number = usize::from(digit as u8 - b'1');
            (Key::Char(digit), ToggleLayer(Overlay::ALL[number]))
        };
        // The last layer is what was said.
        let last = if self.said.is_some() { '7' } else { '6' };
        KeyTable::new("hit")
            .on(' ', GoOn, "go on")
            .when(!self.clock.is_over())
            .by([',', '.'], Step, [-1, 1], "step")
            .or([(Key::Left, Step(-1)), (Key::Right, Step(1))])
            .on('a', Again, "again")
            .on('f', Frame, "frame")
            .each(('1'..=last).map(layer), "layers")
            .by(['<', '>'], Scrub, [-1, 1], "")
            .each([(Key::Home, Start), (Key::End, End)], "")
    }

    /// Does what a key stands for.
    pub(crate) fn act(&mut self, action: WatchAction) {
        match action {
            WatchAction::GoOn => self.clock.go_on(),
            WatchAction::Step(by) => self.clock.scrub(STEP * f64::from(by)),
            WatchAction::Scrub(by) => self.clock.scrub(SCRUB * f64::from(by)),
            WatchAction::Start => self.clock.scrub(-1.0),
            WatchAction::End => {
                self.clock.scrub(1.0);
                self.clock.scrub(1.0);
            }
            WatchAction::Again => self.clock.rewind(),
            WatchAction::Frame => {
                self.frame = match self.frame {
                    Frame::Laboratory => Frame::CentreOfMass,
                    Frame::CentreOfMass if self.collision.u2 != glam::DVec2::ZERO => Frame::Target,
                    _ => Frame::Laboratory,
                }
            }
            WatchAction::ToggleLayer(layer) => self.layers.toggle(layer),
        }
    }

    /// Lets time pass on the screen.
    pub(crate) fn advance(&mut self, passed: Duration) {
        self.clock.advance(passed);
    }

    /// When it next needs time.
    pub(crate) fn wake(&self) -> Option<Duration> {
        self.clock.is_running().then_some(FRAME)
    }

    /// The picture of the moment that its clock shows.
    #[must_use]
    pub(crate) fn picture(&self, area: Rect) -> Picture {
        let stage = HitLayout::new(area, &self.collision);
        Moment { watch: self, stage }.picture()
    }
}

/// When the discs meet and until when they are followed, in the shot's seconds: so
/// that they come from the picture's edge and go up to it, whatever their speeds.
fn times(collision: &Collision) -> (f64, f64) {
    let largest = collision.striker.radius.max(collision.target.radius);
    let relative = collision.relative_velocity().length();
    let fastest = collision
        .u1
        .length()
        .max(collision.u2.length())
        .max(relative);
    let lead = (2.6 * largest / fastest).max(1.15 * collision.contact_distance() / relative);
    if lead.is_finite() && lead > 0.0 {
        (lead, lead + time_in_sight(collision).min(1.1 * lead))
    } else {
        // They move alike, or not at all: nothing ever happens.
        (1.0, 2.0)
    }
}

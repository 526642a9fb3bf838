//! The purpose of a stroke, read from its record.
//!
//! Nothing is copied from the search: the story of a shot is read from its exact record, so the
//! description is true.

use glam::DVec2;

use super::wants::wants;
use super::words;
use crate::game::pieces::piece_of;
use crate::game::{Coin, Game, Piece};
use crate::physics::angle::signed_angle;
use crate::physics::{EventKind, Shot};

/// How often a stroke worked when it was simulated with an unsteady hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Chance {
    /// The number of rehearsals in which a wanted piece fell, and the striker did not.
    pub fell: u8,
    /// The total number of rehearsals.
    pub of: u8,
}

impl Chance {
    /// Whether the stroke worked in at least half of the rehearsals.
    pub(super) fn works_mostly(self) -> bool {
        self.fell > 0 && self.fell >= self.of - self.fell
    }

    pub(super) fn count(&mut self, fell: bool) {
        self.fell = self.fell.saturating_add(u8::from(fell));
        self.of = self.of.saturating_add(1);
    }
}

/// The first collision of the striker with a coin, which is at rest until then.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FirstContact {
    /// The index in [`Game::coins`] of the coin that the striker hit.
    pub coin: usize,
    /// The kind of that coin.
    pub piece: Piece,
    /// The number of cushions the striker had hit before.
    pub cushions: u8,
    /// The striker's direction before the collision, a unit vector.
    pub heading: DVec2,
    /// Impact angle α in radians, positive if the coin was to the right. This is also the coin's
    /// recoil angle θ₂.
    pub alpha: f64,
    /// Impact parameter b in metres, with the sign of α.
    pub offset: f64,
    /// Scattering angle θ₁ of the striker in radians, positive to the left; `None` if the striker
    /// stopped.
    pub theta1: Option<f64>,
    /// The fraction of its speed that the striker keeps, v₁/u₁.
    pub kept: f64,
}

/// How the first wanted piece fell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fall {
    /// The index of the coin in [`Game::coins`].
    pub coin: usize,
    /// The kind of that coin.
    pub piece: Piece,
    /// The corner into which the piece fell, numbered as in the engine.
    pub corner: usize,
    /// The last piece that collided with the fallen piece: the striker or a coin.
    pub sent_by: Piece,
    /// The number of cushions the piece hit after that.
    pub cushions: u8,
}

/// A short description of a shot.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Story {
    /// The first collision; `None` if the striker touched nothing.
    pub first_hit: Option<FirstContact>,
    /// The first wanted piece that fell, if any did.
    pub fall: Option<Fall>,
    /// The number of wanted pieces that fell after the first.
    pub also: u8,
}

impl Story {
    /// The story of `shot`, played from the position of `game` with its discs.
    pub fn of(game: &Game, shot: &Shot) -> Self {
        let mut falls = falls(game, shot);
        Self {
            first_hit: first_hit(game, shot),
            fall: falls
                .next()
                .and_then(|fallen| fallen.described(game.coins(), shot)),
            also: u8::try_from(falls.count()).unwrap_or(u8::MAX),
        }
    }

    /// Whether the striker went straight to the first piece that it hit, and sent that piece
    /// straight into a pocket.
    pub fn is_plain_cut(&self) -> bool {
        self.fall.zip(self.first_hit).is_some_and(|(fall, hit)| {
            let straight = hit.cushions == 0 && fall.cushions == 0;
            straight && fall.sent_by == Piece::Striker && fall.coin == hit.coin
        })
    }
}

fn first_hit(game: &Game, shot: &Shot) -> Option<FirstContact> {
    let mut cushions = 0_u8;
    for event in shot.events() {
        match event.kind {
            EventKind::Cushion { disc: 0, .. } => cushions = cushions.saturating_add(1),
            EventKind::Impact {
                discs: [a, b],
                normal,
                before,
                after,
            } if a == 0 || b == 0 => {
                // In the record of an impact, the coin may come before the striker.
                let (disc, u1, v1, normal) = match a {
                    0 => (b, before[0], after[0], normal),
                    _ => (a, before[1], after[1], -normal),
                };
                let reach = shot.discs().first()?.radius + shot.discs().get(disc)?.radius;
                let along = u1.try_normalize()?;
                return Some(FirstContact {
                    coin: disc.checked_sub(1)?,
                    piece: piece_of(game.coins(), disc)?,
                    cushions,
                    heading: along,
                    alpha: signed_angle(normal, along)?,
                    offset: reach * normal.perp_dot(along),
                    theta1: signed_angle(u1, v1),
                    kept: v1.length() / u1.length(),
                });
            }
            _ => {}
        }
    }
    None
}

/// A disc, the corner into which it fell, and the index of that event in the record.
struct Fallen {
    disc: usize,
    corner: usize,
    when: usize,
}

/// The wanted pieces that fell, in order.
fn falls(game: &Game, shot: &Shot) -> impl Iterator<Item = Fallen> {
    let events = shot.events().iter().enumerate();
    events.filter_map(|(when, event)| match event.kind {
        EventKind::Pocket { disc, corner } if wants(game, piece_of(game.coins(), disc)?) => {
            Some(Fallen { disc, corner, when })
        }
        _ => None,
    })
}

impl Fallen {
    /// How the piece reached the pocket, found by going back through the record to the last
    /// collision of the piece.
    fn described(&self, coins: &[Coin], shot: &Shot) -> Option<Fall> {
        let mut cushions = 0_u8;
        for event in shot.events().iter().take(self.when).rev() {
            if let Some(sender) = event.kind.partner(self.disc) {
                return Some(Fall {
                    coin: self.disc.checked_sub(1)?,
                    piece: piece_of(coins, self.disc)?,
                    corner: self.corner,
                    sent_by: piece_of(coins, sender)?,
                    cushions,
                });
            }
            if matches!(event.kind, EventKind::Cushion { disc, .. } if disc == self.disc) {
                cushions = cushions.saturating_add(1);
            }
        }
        None
    }
}

/// The effect of a chosen stroke if it is played exactly, and its reliability.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reason {
    /// Whether the pack was unbroken.
    pub breaking: bool,
    /// How often the stroke worked with an unsteady hand.
    pub chance: Chance,
    /// What happens in the stroke.
    pub story: Story,
}

impl Reason {
    /// The intended shot with its angles, and the reason for it, in the words of the player who
    /// struck it; `played` is the result.
    pub fn described(&self, played: &Story) -> String {
        let plan = words::plan(&self.story, self.breaking, played);
        let odds = self.story.fall.and_then(|_| words::odds(self.chance));
        plan + &odds.map_or(String::new(), |odds| format!(" {odds}"))
    }
}

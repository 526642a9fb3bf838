//! The first contact of an aim, and the striker's exact path up to it.

use glam::DVec2;

use super::aim::SPEEDS;
use crate::game::{Game, Strike};
use crate::physics::{DiscState, Shot};
use crate::widgets::replay::{ShotImpact, impacts};

/// The striker's path to the first disc that it hits.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Preview {
    /// The corners of the path, including its start and end.
    pub(super) way: Vec<DVec2>,
    /// The first impact, or how the path ends without one.
    pub(super) hit: Result<FirstHit, Miss>,
}

/// How the path of a striker that hits no coin ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Miss {
    /// The striker falls into a pocket.
    Falls,
    /// The striker comes to rest.
    Stops,
    /// The striker comes to rest before reaching the coin with this index, which it would hit if it
    /// were struck harder.
    TooSoft(usize),
}

impl FirstHit {
    /// The position of the striker at contact.
    pub(super) fn ghost(&self) -> DVec2 {
        let collision = &self.impact.collision;
        // Every impact has a line of impact.
        let normal = collision.normal().unwrap_or(DVec2::ZERO);
        self.at - collision.contact_distance() * normal
    }
}

/// The first impact of a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FirstHit {
    /// The index of the coin in the game.
    pub(super) coin: usize,
    /// The position of the coin.
    pub(super) at: DVec2,
    pub(super) impact: ShotImpact,
}

impl Preview {
    /// The path of `strike` up to its first contact; `None` if the stroke cannot be played.
    pub(super) fn of(strike: &Strike, game: &Game) -> Option<Self> {
        let shot = strike.shot(game).ok()?;
        let first = first_hit(&shot);
        let until = first.map_or(f64::INFINITY, |hit| hit.impact.time);
        let mut way = vec![strike.place];
        let legs = shot.path(0).take_while(|leg| leg.start < until);
        way.extend(legs.map(|leg| leg.to));
        let hit = first.ok_or_else(|| match shot.at(0, shot.duration()).state {
            DiscState::Pocketed => Miss::Falls,
            _ => too_soft(strike, game).map_or(Miss::Stops, Miss::TooSoft),
        });
        Some(Self { way, hit })
    }
}

/// The coin that the hardest stroke in this direction would hit.
fn too_soft(strike: &Strike, game: &Game) -> Option<usize> {
    let mut hardest = *strike;
    hardest.velocity = strike.velocity.try_normalize()? * SPEEDS.1;
    Some(first_hit(&hardest.shot(game).ok()?)?.coin)
}

/// The first impact of a stroke's shot. It is always the striker's, because nothing else moves
/// before it.
pub(super) fn first_hit(shot: &Shot) -> Option<FirstHit> {
    let impact = impacts(shot, 0).next()?;
    let coin = impact.discs[1];
    Some(FirstHit {
        coin: coin.checked_sub(1)?,
        at: shot.start(coin).position,
        impact,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::{GameSetup, Piece};

    #[test]
    fn straight_at_the_pack_the_first_hit_is_head_on() {
        let game = Game::new(GameSetup::default());
        let strike = Strike {
            place: DVec2::new(0.0, -0.2526),
            velocity: DVec2::new(0.0, 4.0),
            call: None,
        };
        let preview = Preview::of(&strike, &game).unwrap();
        let hit = preview.hit.unwrap();
        assert_eq!(game.coins()[hit.coin].piece, Piece::White);
        assert!(hit.impact.collision.offset.abs() < 1e-12);
        let reach = hit.impact.collision.contact_distance();
        let end = preview.way.last().unwrap();
        assert!((end.distance(hit.at) - reach).abs() < 1e-9);
    }

    #[test]
    fn the_preview_has_the_restitution_of_the_game() {
        let strike = Strike {
            place: DVec2::new(0.0, -0.2526),
            velocity: DVec2::new(0.0, 4.0),
            call: None,
        };
        for restitution in [1.0, 0.5, 0.0] {
            let game = Game::new(GameSetup {
                restitution,
                ..GameSetup::default()
            });
            let preview = Preview::of(&strike, &game).unwrap();
            let collision = preview.hit.unwrap().impact.collision;
            let outcome = collision.outcome();
            let separation = (outcome.v2 - outcome.v1).length();
            let approach = collision.u1.length();
            assert!((separation - restitution * approach).abs() < 1e-12);
        }
    }

    #[test]
    fn a_striker_that_hits_nothing_is_followed_to_the_end_of_its_path() {
        let game = Game::new(GameSetup::default());
        let mut strike = Strike {
            place: DVec2::new(0.0, -0.2526),
            velocity: DVec2::new(0.3, 0.0),
            call: None,
        };
        let preview = Preview::of(&strike, &game).unwrap();
        assert_eq!((preview.hit, preview.way.len()), (Err(Miss::Stops), 2));
        strike.velocity = DVec2::new(0.0, 0.3);
        let soft = Preview::of(&strike, &game).unwrap().hit;
        strike.velocity.y = 3.0;
        let hit = Preview::of(&strike, &game).unwrap().hit.unwrap();
        assert_eq!(soft, Err(Miss::TooSoft(hit.coin)));
        // The striker goes into the corner next to the base line.
        let corner = DVec2::new(0.370 - 0.022_25, -0.370 + 0.022_25);
        strike.velocity = (corner - strike.place).normalize() * 2.0;
        assert_eq!(Preview::of(&strike, &game).unwrap().hit, Err(Miss::Falls));
        strike.place = DVec2::ZERO;
        assert_eq!(Preview::of(&strike, &game), None);
    }
}

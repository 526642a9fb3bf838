//! The computer opponent: finds a stroke by playing it in its head.
//!
//! Geometry proposes strokes in closed form; the engine plays the most forgiving of
//! them; the laws judge what came of each; the best are played again as the hand
//! might slip. What is chosen depends on the game, the strength and the seed alone:
//! the search counts shots, not time, and chooses by + − × ÷ √ only, so that every
//! machine finds the same stroke.
//!
//! | file | holds |
//! |---|---|
//! | `sight` | clear ways, pockets, the image behind a cushion |
//! | `shots` | cuts, combinations and cushion shots, put together from the pocket back |
//! | `wants` | which pieces a player wants to pocket |
//! | `rehearsal` | a stroke played in the mind |
//! | `worth` | what a position is worth |
//! | `search` | from many strokes to one |
//! | `strength` | five strengths |
//! | `hand` | the error of the hand |
//! | `story` | what a shot was about, from its record, and why it was chosen |
//! | `words` | the same in words |
//! | `hint` | the same for the player |

mod hand;
mod hint;
mod rehearsal;
mod search;
mod shots;
mod sight;
mod story;
mod strength;
#[cfg(test)]
mod tests;
mod wants;
mod words;
mod worth;

pub use hand::{FASTEST, Hand, Slip};
pub use hint::StrokeHint;
pub use story::{Chance, Fall, FirstContact, Reason, Story};
pub use strength::Strength;

use rand::SeedableRng;
use rand_pcg::Pcg64;

use super::Game;
use crate::physics::Motion;
use rehearsal::Rehearsal;
use search::{Candidate, Search};
use strength::Skill;
use worth::Judge;

/// What the opponent decided to do, and did.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decision {
    /// The striker's motion as it was meant.
    pub meant: Motion,
    /// How far the hand slipped.
    pub slip: Slip,
    /// Why this stroke.
    pub reason: Reason,
}

impl Decision {
    /// The striker's motion as it was struck: what to play on the board.
    pub fn struck(&self) -> Motion {
        self.slip.applied_to(self.meant)
    }

    /// What the opponent says of its stroke afterwards, when `played` is what came of it:
    /// the shot it saw and why, with the angles, and how its hand slipped.
    pub fn afterwards(&self, played: &Story) -> String {
        let slipped = words::slipped(self.slip, self.meant.velocity);
        format!("{} {slipped}", self.reason.told(played))
    }
}

/// The stroke of an opponent of this strength for the player whose turn it is.
///
/// The same game, strength and seed give the same decision; take another seed
/// for each stroke. `None` if the board has ended or coins bar every place for the
/// striker: then [`Game::no_place`] is called for.
pub fn think(game: &Game, strength: Strength, seed: u64) -> Option<Decision> {
    let skill = strength.skill();
    let (choice, reason) = seek(game, skill, seed)?;
    // A generator of its own, so that the slip does not hang on how long the search was.
    let mut hand = Pcg64::seed_from_u64(!seed);
    Some(Decision {
        meant: choice.motion,
        slip: skill.hand.slip(&mut hand),
        reason,
    })
}

/// The best stroke for the player whose turn it is: sought like the champion's, but
/// for the hand of a club player. `None` as for [`think`].
///
/// A plain cut comes first, for it is what one can learn from; other shots only
/// where no cut works every other time.
///
/// Place, direction and speed are on the steps in which a player sets
/// them, and struck exactly so the striker does not fall, wherever there is such a
/// stroke.
pub fn hint(game: &Game, seed: u64) -> Option<StrokeHint> {
    let all = Skill {
        hand: Strength::Club.hand(),
        on_steps: true,
        ..Strength::Champion.skill()
    };
    let cuts = Skill {
        combinations: false,
        cushions: false,
        speeds: &[1.2, 1.6, 2.0],
        knocks: 0,
        refinements: 4,
        ..all
    };
    let plain = seek(game, cuts, seed).filter(|(choice, reason)| {
        reason.chance.works_mostly() && reason.story.is_plain_cut() && !choice.fouls
    });
    let (choice, reason) = plain.or_else(|| seek(game, all, seed))?;
    Some(StrokeHint {
        stand: game.base_lines().stand(choice.motion.position),
        stroke: choice.motion,
        reason,
        fouls: choice.fouls,
    })
}

fn seek(game: &Game, skill: Skill, seed: u64) -> Option<(Candidate, Reason)> {
    if game.play().won.is_some() {
        return None;
    }
    let mut search = Search {
        game,
        skill,
        judge: Judge {
            team: game.team(game.seat()),
            skill,
        },
        rehearsal: Rehearsal::new(game),
        chance: Pcg64::seed_from_u64(seed),
    };
    let choice = search.best()?;
    // Once more as it is meant, for the record.
    let story = match search.rehearsal.play(choice.motion) {
        Some(_) => Story::of(game, &search.rehearsal.shot),
        None => Story::default(),
    };
    let reason = Reason {
        breaking: game.play().is_unbroken(),
        chance: choice.chance,
        story,
    };
    Some((choice, reason))
}

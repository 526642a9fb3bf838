//! The computer opponent: finds a stroke by simulation.
//!
//! The search has four steps: geometry proposes strokes in closed form; the engine plays those with
//! the largest tolerance; the laws judge each result; and the best strokes are played again with
//! random errors of the hand. The choice depends only on the game, the strength and the seed: the
//! search is limited by a number of shots, not by time, and uses only + − × ÷ √, so every machine
//! finds the same stroke.
//!
//! | file | contents |
//! |---|---|
//! | `sight` | clear paths, pockets, the image behind a cushion |
//! | `shots` | cuts, combinations and cushion shots, built backwards from the pocket |
//! | `wants` | which pieces a player wants to pocket |
//! | `rehearsal` | a simulated stroke |
//! | `worth` | the value of a position |
//! | `search` | the choice of one stroke from many |
//! | `strength` | five strengths |
//! | `hand` | the errors of the hand |
//! | `story` | the purpose of a shot, from its record, and why it was chosen |
//! | `words` | the purpose of a shot in words |
//! | `hint` | a hint for the player |
//! | `clearing` | the strokes that clear a board for one player, for its par |
//! | `open_shots` | the directions that pocket a coin, for aiming with one key |

mod clearing;
mod hand;
mod hint;
mod open_shots;
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

pub use clearing::{clearing, par};
pub use hand::{FASTEST, Hand, Slip};
pub use hint::StrokeHint;
pub use open_shots::open_shots;
pub use story::{Chance, Fall, FirstContact, Reason, Story};
pub use strength::{PlayerHand, Strength};

use rand::SeedableRng;
use rand_pcg::Pcg64;

use super::Game;
use crate::physics::Motion;
use rehearsal::Rehearsal;
use search::{Candidate, Search};
use strength::Skill;
use worth::Judge;

/// The opponent's decision and its execution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decision {
    /// The intended motion of the striker.
    pub meant: Motion,
    /// The error of the hand.
    pub slip: Slip,
    /// Why this stroke was chosen.
    pub reason: Reason,
}

impl Decision {
    /// The actual motion of the striker, to be played on the board.
    pub fn struck(&self) -> Motion {
        self.slip.applied_to(self.meant)
    }

    /// The opponent's comment after a stroke with the result `played`: the intended shot with its
    /// angles, the reason, and the error of the hand.
    pub fn afterwards(&self, played: &Story) -> String {
        let slipped = self.slip.in_words("My stroke", self.meant.velocity);
        format!("{} {slipped}", self.reason.described(played))
    }
}

/// The stroke that an opponent of this strength chooses for the player whose turn it is.
///
/// The same game, strength and seed give the same decision; use another seed for each stroke.
/// `None` if the board has ended, or if coins block every position of the striker; then call
/// [`Game::no_place`].
pub fn think(game: &Game, strength: Strength, seed: u64) -> Option<Decision> {
    let skill = strength.skill();
    let (choice, reason) = seek(game, skill, seed)?;
    Some(Decision {
        meant: choice.motion,
        slip: skill.hand.slip_of(seed),
        reason,
    })
}

/// The best stroke for the player whose turn it is. The search is the champion's, but with the
/// errors of the player's hand. For an exact hand, a stroke is tried once without errors; all other
/// tries have the errors of a club player. `None` as for [`think`].
///
/// A plain cut is preferred, because players can learn most from it; other shots are considered
/// only if no cut is found, or if the best one works in fewer than half of the tries or pockets the
/// striker.
///
/// Position, direction and speed are on the steps in which a player sets them, and if possible the
/// striker does not fall when the stroke is exact.
pub fn hint(game: &Game, hand: PlayerHand, seed: u64) -> Option<StrokeHint> {
    let all = Skill {
        hand: hand.errors().unwrap_or(Strength::Club.hand()),
        is_exact: hand == PlayerHand::Exact,
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
    // The chosen stroke is played once more without errors, for its description.
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

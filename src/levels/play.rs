//! Playing the shot of a scene.

use super::scene::Scene;
use crate::physics::{Engine, EngineError, Limits, Shot};

/// The maximum number of seconds for which a shot is played on a board without friction, where the
/// motion may never end.
const WATCHED: f64 = 60.0;

/// The work budget of a shot, counted in tests of a pair of discs (see [`Limits::work`]). The
/// budget limits how long a player has to wait; no built-in level comes close to the limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Patience {
    /// A few seconds, for a single shot such as that of `carrom simulate`.
    Seconds,
    /// Five milliseconds, for a shot that is shown after a key press.
    AKey,
    /// One millisecond, for one shot out of thousands, and for the preview while a player is
    /// aiming.
    AMoment,
}

impl Patience {
    const fn work(self) -> u64 {
        match self {
            Self::Seconds => 1_000_000_000,
            Self::AKey => 1_000_000,
            Self::AMoment => 200_000,
        }
    }
}

impl Scene {
    /// Plays the shot to its end or, on a board without friction, for at most a minute.
    ///
    /// # Errors
    ///
    /// Returns an error if the shot has too many events or exceeds its work budget.
    pub fn play(&self, patience: Patience) -> Result<Shot, EngineError> {
        let mut shot = Shot::default();
        self.play_into(&mut Engine::default(), &mut shot, patience)?;
        Ok(shot)
    }

    /// Plays as much of the shot as the smallest work budget allows, which is enough to go beyond
    /// the first contact.
    pub(crate) fn play_for_a_moment(&self) -> Shot {
        let mut shot = Shot::default();
        // If there is an error, the record contains the shot up to that point.
        let _ = self.play_into(&mut Engine::default(), &mut shot, Patience::AMoment);
        shot
    }

    /// Plays the shot as [`Scene::play`] does, with an engine and a record that can be reused.
    ///
    /// # Errors
    ///
    /// The errors are those of [`Scene::play`].
    pub fn play_into(
        &self,
        engine: &mut Engine,
        shot: &mut Shot,
        patience: Patience,
    ) -> Result<(), EngineError> {
        let horizon = match self.board.friction > 0.0 {
            true => f64::INFINITY,
            false => WATCHED,
        };
        let limits = Limits {
            horizon,
            work: patience.work(),
            ..Limits::default()
        };
        engine.play_into(shot, &self.board, &self.discs(), &self.motions(), limits)
    }
}

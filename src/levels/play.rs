//! Playing the shot of a scene.

use super::scene::Scene;
use crate::physics::{Engine, EngineError, Limits, Shot};

/// How long a board without friction is watched, in seconds: nothing on it would
/// ever come to rest.
const WATCHED: f64 = 60.0;

impl Scene {
    /// Plays the shot to its end, or for a minute on a board without friction.
    ///
    /// # Errors
    ///
    /// If the shot has too many events or is too much work to be played to its end.
    pub fn play(&self) -> Result<Shot, EngineError> {
        let mut shot = Shot::default();
        self.play_into(&mut Engine::default(), &mut shot)?;
        Ok(shot)
    }

    /// Plays the shot as [`Scene::play`] does, into a record and with an engine that
    /// can be used again.
    ///
    /// # Errors
    ///
    /// As [`Scene::play`].
    pub fn play_into(&self, engine: &mut Engine, shot: &mut Shot) -> Result<(), EngineError> {
        let limits = if self.board.friction > 0.0 {
            Limits::default()
        } else {
            Limits::until(WATCHED)
        };
        engine.play_into(shot, &self.board, &self.discs(), &self.motions(), limits)
    }
}

//! Why a stroke was chosen.

use super::story::{Chance, Story};
use super::words;

/// What a chosen stroke does when it is struck exactly as it was meant, and how sure
/// it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reason {
    /// Whether the pack was unbroken.
    pub breaking: bool,
    /// How often it worked with an unsteady hand.
    pub chance: Chance,
    /// What happens in it.
    pub story: Story,
}

impl Reason {
    /// The shot that was seen and why, with its angles, told by who struck it, when
    /// `played` is what came of it.
    pub fn told(&self, played: &Story) -> String {
        let plan = words::plan(&self.story, self.breaking, played);
        let odds = self.story.fall.and_then(|_| words::odds(self.chance));
        plan + &odds.map_or(String::new(), |odds| format!(" {odds}"))
    }
}

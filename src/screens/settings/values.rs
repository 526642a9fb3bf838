//! What can be set, as it stands.

use crate::widgets::hit::HitPace;
use crate::widgets::input::Rebound;
use crate::widgets::replay::WatchRate;
use crate::widgets::{Charset, Depth, Look, Palette, Theme};

/// How the app looks and behaves for this player.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// Glyphs to draw with.
    pub charset: Charset,
    /// Colours by purpose: dark, light.
    pub palette: Palette,
    /// How many colours the screen has.
    pub depth: Depth,
    /// Jump from before the contact to the contact to after it.
    pub reduced_motion: bool,
    /// Each step of the explanation of a hit waits for a key, however long that takes.
    pub wait_at_beats: bool,
    /// How fast shots are watched, once that was chosen.
    pub watch_rate: Option<WatchRate>,
    /// Ask for a prediction before each shot in the lab and in levels.
    pub predict: bool,
    /// How often both ways were said rightly in the lab, as far as that counts: it unlocks
    /// the live picture.
    pub foretold: u8,
    /// Name of the player, as shown.
    pub player: String,
    /// Keys of the player's own choice.
    pub keys: Rebound,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            charset: Charset::Ascii,
            palette: Palette::Dark,
            depth: Depth::None,
            reduced_motion: false,
            wait_at_beats: false,
            watch_rate: None,
            predict: true,
            foretold: 0,
            player: "player".into(),
            keys: Rebound::default(),
        }
    }
}

impl Settings {
    /// How often both ways are to be said rightly before the lab's picture may be live.
    pub(crate) const ENOUGH_FORETOLD: u8 = 3;

    /// The styles that follow from palette and colour depth.
    pub fn theme(&self) -> Theme {
        Theme::new(self.palette, self.depth)
    }

    /// How hits are played.
    pub(crate) fn pace(&self) -> HitPace {
        match (self.reduced_motion, self.wait_at_beats) {
            (true, _) => HitPace::Still,
            (false, true) => HitPace::Waiting,
            (false, false) => HitPace::Flowing,
        }
    }

    /// Glyphs and styles together.
    pub fn look(&self) -> Look {
        Look {
            charset: self.charset,
            theme: self.theme(),
        }
    }
}

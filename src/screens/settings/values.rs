//! The values of the settings.

use crate::widgets::hit::HitPace;
use crate::widgets::input::Rebound;
use crate::widgets::replay::WatchRate;
use crate::widgets::{Blocks, Charset, Depth, Look, Palette, Theme};

/// The appearance and behaviour of the app for this player.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// The characters used to draw pictures.
    pub charset: Charset,
    /// The block elements that discs are drawn with, if the player has chosen them.
    pub blocks: Option<Blocks>,
    /// The block elements that the terminal is known to draw.
    pub known_blocks: Blocks,
    /// The colours for each purpose: dark, light or none.
    pub palette: Palette,
    /// The number of colours that the screen supports.
    pub depth: Depth,
    /// Whether pictures jump straight to the contact, and then to the result.
    pub reduced_motion: bool,
    /// Whether each step of the explanation of a collision waits for a key.
    pub wait_at_beats: bool,
    /// The speed of shots, if the player has chosen one.
    pub watch_rate: Option<WatchRate>,
    /// Whether the player is asked for a prediction before each shot in the lab and in levels.
    pub predict: bool,
    /// The number of times the player has predicted both paths correctly in the lab, up to the
    /// number that unlocks the live picture.
    pub predicted: u8,
    /// Whether carrom sometimes asks the player what they saw in a hit.
    pub observe: bool,
    /// The number of predicted hits that the player has watched, counted only as far as is needed
    /// to decide when to ask what they saw.
    pub watched: u8,
    /// Whether somebody is watching the pictures; in plain lines and in tapes nobody is.
    pub sees: bool,
    /// The player's name, as shown.
    pub player: String,
    /// The keys that the player has rebound.
    pub keys: Rebound,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            charset: Charset::Ascii,
            blocks: None,
            known_blocks: Blocks::default(),
            palette: Palette::Dark,
            depth: Depth::None,
            reduced_motion: false,
            wait_at_beats: false,
            watch_rate: None,
            predict: true,
            predicted: 0,
            observe: true,
            watched: 0,
            sees: false,
            player: "player".into(),
            keys: Rebound::default(),
        }
    }
}

impl Settings {
    /// The number of correct predictions of both paths that unlocks the lab's live picture.
    pub(crate) const ENOUGH_PREDICTED: u8 = 3;

    /// At first carrom asks after every predicted hit what the player saw; this is the number of
    /// those hits.
    const FIRST_OBSERVED: u8 = 3;
    /// The largest value of [`Self::watched`]: on the tenth hit after each question, the player is
    /// asked again.
    pub(crate) const MOST_WATCHED: u8 = Self::FIRST_OBSERVED + 9;

    /// Counts a predicted hit that is about to be watched; returns whether the player is asked what
    /// they saw: for the first three hits, and then for every tenth.
    pub(crate) fn asks_what_is_seen(&mut self) -> bool {
        if !(self.observe && self.sees) {
            return false;
        }
        let watched = self.watched;
        self.watched = match watched {
            Self::MOST_WATCHED => Self::FIRST_OBSERVED,
            fewer => fewer + 1,
        };
        watched < Self::FIRST_OBSERVED || watched == Self::MOST_WATCHED
    }

    /// The styles for the palette and colour depth.
    pub fn theme(&self) -> Theme {
        Theme::new(self.palette, self.depth)
    }

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
            blocks: self.blocks.unwrap_or(self.known_blocks),
            theme: self.theme(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_three_hits_are_observed_and_then_every_tenth() {
        let mut settings = Settings {
            sees: true,
            ..Settings::default()
        };
        let asked: Vec<_> = (1..=40).filter(|_| settings.asks_what_is_seen()).collect();
        assert_eq!(asked, [1, 2, 3, 13, 23, 33]);
        settings.observe = false;
        assert!((1..=40).all(|_| !settings.asks_what_is_seen()));
    }
}

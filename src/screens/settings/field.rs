//! The settings, each with its name, values and description.

use super::values::Settings;
use crate::widgets::input::{Field, FieldValue, FormFields};
use crate::widgets::replay::WatchRate;
use crate::widgets::{Blocks, Charset, Depth, Palette};

/// A setting with a fixed list of values.
pub(super) struct Setting {
    /// Its name in the file.
    pub(super) id: &'static str,
    /// Its values, as in the file and on the screen.
    pub(super) words: &'static [&'static str],
    /// Its name on the screen.
    name: &'static str,
    /// Its description on the screen.
    about: &'static str,
    /// The index of its current value.
    pub(super) at: fn(&Settings) -> usize,
    /// Sets it to the value at this index.
    pub(super) choose: fn(&mut Settings, usize),
}

/// All settings; those shown on the screen come first.
pub(super) static SETTINGS: [Setting; 11] = [
    Setting {
        id: "charset",
        words: &["ascii", "unicode"],
        name: "characters",
        about: "The characters used for pictures. ASCII works in every terminal and font; Unicode is finer. The help of every screen shows the key that switches between them.",
        at: |settings| settings.charset as usize,
        choose: |settings, at| settings.charset = [Charset::Ascii, Charset::Unicode][at.min(1)],
    },
    Setting {
        id: "blocks",
        words: &["automatic", "quadrants", "sextants", "octants"],
        name: "blocks",
        about: "The characters for the edges of discs in Unicode. Octants make discs roundest, then sextants; quadrants work with every font. Automatic: the finest that the terminal is known to draw. If you see boxes or question marks, choose quadrants.",
        at: |settings| settings.blocks.map_or(0, |blocks| blocks as usize + 1),
        choose: |settings, at| {
            use Blocks::{Octants, Quadrants, Sextants};
            settings.blocks = [None, Some(Quadrants), Some(Sextants), Some(Octants)][at.min(3)];
        },
    },
    Setting {
        id: "palette",
        words: &["dark", "light", "no colour"],
        name: "palette",
        about: "Dark for a desk, light for a projector in a bright room, or no colour at all. The help of every screen shows the key that switches the palette.",
        at: |settings| settings.palette as usize,
        choose: |settings, at| {
            settings.palette = [Palette::Dark, Palette::Light, Palette::Mono][at.min(2)];
        },
    },
    Setting {
        id: "colours",
        words: &["none", "16", "256", "truecolor"],
        name: "colours",
        about: "The number of colours. Choose fewer if some look wrong: nearly every terminal supports 16.",
        at: |settings| settings.depth as usize,
        choose: |settings, at| {
            use Depth::{Ansi16, Indexed256, None, True};
            settings.depth = [None, Ansi16, Indexed256, True][at.min(3)];
        },
    },
    Setting {
        id: "motion",
        words: &["full", "reduced"],
        name: "motion",
        about: "Reduced: nothing slides. Pictures jump straight to the contact, and then to the result. The help of every screen shows the key that changes this setting.",
        at: |settings| settings.reduced_motion.into(),
        choose: |settings, at| settings.reduced_motion = at > 0,
    },
    Setting {
        id: "steps",
        words: &["go on", "wait"],
        name: "steps of a hit",
        about: "At the contact a collision is explained step by step. Go on: each step stays long enough to read. Wait: each step stays until you go on.",
        at: |settings| settings.wait_at_beats.into(),
        choose: |settings, at| settings.wait_at_beats = at > 0,
    },
    Setting {
        id: "speed",
        words: &[
            "usual", "1/16", "1/8", "1/4", "1/2", "real", "double", "fourfold",
        ],
        name: "speed of shots",
        about: "The speed of shots on the board, at the table and in the levels. Usual means real speed at the table and a quarter of it in the levels. You can also change it while a shot is running.",
        at: |settings| {
            let chosen = |rate| WatchRate::all().position(|it| it == rate);
            settings.watch_rate.and_then(chosen).map_or(0, |at| at + 1)
        },
        choose: |settings, at| {
            settings.watch_rate = at.checked_sub(1).and_then(|at| WatchRate::all().nth(at));
        },
    },
    Setting {
        id: "predict_first",
        words: &["no", "yes"],
        name: "predict first",
        about: "In the lab and the levels you predict where both discs will go before you watch. That is what makes watching useful.",
        at: |settings| settings.predict.into(),
        choose: |settings, at| settings.predict = at > 0,
    },
    Setting {
        id: "what_you_saw",
        words: &["no", "yes"],
        name: "what did you see?",
        about: "In the lab and the quiz, before carrom shows the angles, it asks what you saw: in the first three hits that you predict, and then in every tenth. It is easy to see what you expect to see.",
        at: |settings| settings.observe.into(),
        choose: |settings, at| settings.observe = at > 0,
    },
    // These settings are saved, but the player cannot change them directly.
    Setting {
        id: "foretold",
        words: &["0", "1", "2", "3"],
        name: "",
        about: "",
        at: |settings| settings.predicted.into(),
        choose: |settings, at| settings.predicted = Settings::ENOUGH_PREDICTED.min(at as u8),
    },
    Setting {
        id: "hits_watched",
        words: &[
            "0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12",
        ],
        name: "",
        about: "",
        at: |settings| settings.watched.into(),
        choose: |settings, at| settings.watched = Settings::MOST_WATCHED.min(at as u8),
    },
];

/// The row of the player's name, below the settings.
pub(super) const PLAYER: usize = SETTINGS.len() - 2;

impl FormFields for Settings {
    fn fields(&self) -> Vec<Field> {
        let choice = |setting: &Setting| {
            let now = FieldValue::choice((setting.at)(self), setting.words);
            Field::new(setting.name, now, setting.about)
        };
        let player = Field::new(
            "player",
            FieldValue::choice(0, &[&self.player]),
            "The player to whom these answers, stars and bookmarks belong. Everyone on this computer can have their own.",
        );
        let shown = SETTINGS[..PLAYER].iter().map(choice);
        shown.chain([player]).collect()
    }

    fn set(&mut self, at: usize, value: f64) {
        if let Some(setting) = SETTINGS[..PLAYER].get(at) {
            (setting.choose)(self, value as usize);
        }
    }
}

//! What can be set: one place for a setting's name, its values and what they mean.

use crate::screens::Settings;
use crate::screens::lab::ENOUGH_FORETOLD;
use crate::widgets::input::{Field, FieldValue, FormFields};
use crate::widgets::replay::WatchRate;
use crate::widgets::{Charset, Depth, Palette};

/// A setting with a few values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SettingField {
    Charset,
    Palette,
    Colours,
    Motion,
    /// Whether the steps at the contact wait for a key.
    Steps,
    /// How fast shots are watched.
    Speed,
    Predict,
    /// How often both ways were said rightly in the lab; it is kept, but not set by hand.
    Foretold,
}

impl SettingField {
    /// All of them; those on the screen first.
    pub(super) const ALL: [Self; 8] = [
        Self::Charset,
        Self::Palette,
        Self::Colours,
        Self::Motion,
        Self::Steps,
        Self::Speed,
        Self::Predict,
        Self::Foretold,
    ];

    /// Those on the screen.
    pub(super) const SHOWN: &[Self] = Self::ALL.split_at(7).0;

    /// Its name in the file.
    pub(super) const fn id(self) -> &'static str {
        match self {
            Self::Charset => "charset",
            Self::Palette => "palette",
            Self::Colours => "colours",
            Self::Motion => "motion",
            Self::Steps => "steps",
            Self::Speed => "speed",
            Self::Predict => "predict_first",
            Self::Foretold => "foretold",
        }
    }

    /// Its values, as the file has them and the screen shows them.
    pub(super) const fn words(self) -> &'static [&'static str] {
        match self {
            Self::Charset => &["ascii", "unicode"],
            Self::Palette => &["dark", "light", "no colour"],
            Self::Colours => &["none", "16", "256", "truecolor"],
            Self::Motion => &["full", "reduced"],
            Self::Steps => &["go on", "wait"],
            Self::Speed => &[
                "usual", "1/16", "1/8", "1/4", "1/2", "real", "double", "fourfold",
            ],
            Self::Predict => &["no", "yes"],
            Self::Foretold => &["0", "1", "2", "3"],
        }
    }

    /// The place of its present value among its words.
    pub(super) fn at(self, settings: &Settings) -> usize {
        match self {
            Self::Charset => settings.charset as usize,
            Self::Palette => settings.palette as usize,
            Self::Colours => settings.depth as usize,
            Self::Motion => settings.reduced_motion.into(),
            Self::Steps => settings.wait_at_beats.into(),
            Self::Speed => {
                let chosen = |rate| WatchRate::ALL.iter().position(|it| *it == rate);
                settings.watch_rate.and_then(chosen).map_or(0, |at| at + 1)
            }
            Self::Predict => settings.predict.into(),
            Self::Foretold => settings.foretold.into(),
        }
    }

    /// Sets it to the value at this place.
    pub(super) fn choose(self, settings: &mut Settings, at: usize) {
        use Depth::{Ansi16, Indexed256, None, True};
        use Palette::{Dark, Light, Mono};
        match self {
            Self::Charset => settings.charset = [Charset::Ascii, Charset::Unicode][at.min(1)],
            Self::Palette => settings.palette = [Dark, Light, Mono][at.min(2)],
            Self::Colours => settings.depth = [None, Ansi16, Indexed256, True][at.min(3)],
            Self::Motion => settings.reduced_motion = at > 0,
            Self::Steps => settings.wait_at_beats = at > 0,
            Self::Speed => {
                let rate = at.checked_sub(1).and_then(|at| WatchRate::ALL.get(at));
                settings.watch_rate = rate.copied();
            }
            Self::Predict => settings.predict = at > 0,
            Self::Foretold => settings.foretold = ENOUGH_FORETOLD.min(at as u8),
        }
    }

    /// Its name on the screen, and what it is.
    const fn about(self) -> (&'static str, &'static str) {
        match self {
            Self::Charset => (
                "characters",
                "What pictures are drawn with. ASCII shows in every terminal and font; Unicode is finer. U switches it on every screen.",
            ),
            Self::Palette => (
                "palette",
                "Dark for a desk, light for a projector in a bright room, or no colour at all. T switches it on every screen.",
            ),
            Self::Colours => (
                "colours",
                "How many colours are used. Take fewer if some look wrong: 16 are shown by nearly every terminal.",
            ),
            Self::Motion => (
                "motion",
                "Reduced: nothing slides. Pictures jump from before the contact to the contact, and to what comes after. M switches it on every screen.",
            ),
            Self::Steps => (
                "steps of a hit",
                "At the contact a hit explains itself step by step. Go on: each step stands long enough to be read. Wait: each stays until you press Enter.",
            ),
            Self::Speed => (
                "speed of shots",
                "How fast shots on the board are watched, at the table and in the levels. Usual is real speed at the table and a quarter of it in the levels. Plus and minus change it while a shot runs.",
            ),
            Self::Predict => (
                "predict first",
                "In the lab and the levels you say where both will go before you watch. That is what makes watching teach.",
            ),
            Self::Foretold => ("", ""),
        }
    }
}

/// The row of the player's name, below the others.
pub(super) const PLAYER: usize = SettingField::SHOWN.len();

impl FormFields for Settings {
    fn fields(&self) -> Vec<Field> {
        let choice = |setting: &SettingField| {
            let (name, about) = setting.about();
            let (at, words) = (setting.at(self), setting.words());
            let value = FieldValue::Choice {
                at,
                count: words.len(),
            };
            let shown = words.get(at).copied().unwrap_or_default();
            Field::new(name, shown.into(), value, about)
        };
        let player = Field::new(
            "player",
            self.player.clone(),
            FieldValue::Choice { at: 0, count: 1 },
            "Whose answers, stars and bookmarks these are. Everyone on this computer can have their own: Enter, then type the name.",
        );
        SettingField::SHOWN
            .iter()
            .map(choice)
            .chain([player])
            .collect()
    }

    fn set(&mut self, at: usize, value: f64) {
        if let Some(setting) = SettingField::SHOWN.get(at) {
            setting.choose(self, value as usize);
        }
    }
}

//! The settings that are kept from one run to the next, in `settings.toml`.

use std::collections::BTreeMap;

use super::field::{SETTINGS, Setting};
use super::values::Settings;
use crate::files::{FileErrors, Source, all, is_blank_name};
use crate::game::is_player_name;
use crate::widgets::Depth;

const FORMAT: u32 = 1;
/// The size of the largest file that is read, in bytes.
const LARGEST: usize = 64 * 1024;
/// The greatest length of a name in the file.
const LONGEST: usize = 200;
const PLAYER_ID: &str = "player";

/// The settings that a player has changed. The others are determined anew at each start.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct KeptSettings {
    /// The index of the value of each changed setting, by its name.
    chosen: BTreeMap<&'static str, usize>,
    player: Option<String>,
}

impl KeptSettings {
    /// The name of the settings file in the data folder.
    pub const FILE: &str = "settings.toml";

    /// Records the settings that differ from `before`; returns whether any do.
    pub(crate) fn note(&mut self, before: &Settings, now: &Settings) -> bool {
        let differs = |setting: &&Setting| (setting.at)(before) != (setting.at)(now);
        let changed = SETTINGS.iter().filter(differs);
        let changed: Vec<_> = changed.map(|it| (it.id, (it.at)(now))).collect();
        let renamed = before.player != now.player;
        if renamed {
            self.player = Some(now.player.clone());
        }
        self.chosen.extend(changed.iter().copied());
        renamed || !changed.is_empty()
    }

    /// The given settings, overridden by the saved ones. A screen without colours stays without
    /// them.
    pub fn over(&self, mut settings: Settings) -> Settings {
        let depth = settings.depth;
        for setting in &SETTINGS {
            if let Some(at) = self.chosen.get(setting.id) {
                (setting.choose)(&mut settings, *at);
            }
        }
        if depth == Depth::None {
            settings.depth = depth;
        }
        if let Some(player) = &self.player {
            settings.player.clone_from(player);
        }
        settings
    }

    /// The text of the file.
    pub fn text(&self) -> String {
        let mut text = format!(
            "# The settings of carrom. carrom rewrites this file whenever a setting changes.\n\
             format = {FORMAT}\n"
        );
        let chosen = SETTINGS.iter().filter_map(|setting| {
            let at = *self.chosen.get(setting.id)?;
            Some((setting.id, *setting.words.get(at)?))
        });
        let player = self.player.iter().map(|name| (PLAYER_ID, name.as_str()));
        for (name, value) in chosen.chain(player) {
            text += &format!("{name} = {}\n", toml::Value::from(value));
        }
        text
    }

    /// Reads a settings file.
    ///
    /// # Errors
    /// If the file has errors; all of them are reported.
    pub fn read(file: &str, bytes: &[u8]) -> Result<Self, FileErrors> {
        let ids = SETTINGS.iter().map(|setting| setting.id);
        let known: Vec<_> = ["format", PLAYER_ID].into_iter().chain(ids).collect();
        let source = Source::of_bytes(file, bytes, LARGEST)?;
        source.document("settings of carrom", FORMAT..=FORMAT, &known, |fields| {
            let there = SETTINGS.iter().filter(|it| fields.has(it.id));
            let chosen = there.map(|setting| {
                let words: Vec<_> = setting.words.iter().copied().zip(0..).collect();
                Some((setting.id, fields.word(setting.id, &words)?))
            });
            let chosen = all(chosen.collect());
            let player = fields.or(PLAYER_ID, None, |id| {
                let name = fields.text(id, LONGEST)?;
                match is_player_name(name) {
                    true => Some(Some(name.to_owned())),
                    false if is_blank_name(name) => Some(None),
                    false => fields.refuse(id, "expected a name of 1 to 40 visible characters"),
                }
            });
            Some(Self {
                chosen: BTreeMap::from_iter(chosen?),
                player: player?,
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::widgets::{Blocks, Charset, Palette};

    #[test]
    fn only_changed_settings_are_saved_and_read_back() {
        let before = Settings::default();
        let mut kept = KeptSettings::default();
        assert!(!kept.note(&before, &before));
        let now = Settings {
            blocks: Some(Blocks::Sextants),
            palette: Palette::Mono,
            reduced_motion: true,
            player: "Ada \"the\" Lovelace".into(),
            ..before.clone()
        };
        assert!(kept.note(&before, &now));
        let read = KeptSettings::read("settings.toml", kept.text().as_bytes()).unwrap();
        assert_eq!(read, kept);
        // Settings that were not changed keep the given values.
        let found = Settings {
            charset: Charset::Unicode,
            ..Settings::default()
        };
        let over = read.over(found);
        assert_eq!(
            (over.charset, over.palette),
            (Charset::Unicode, Palette::Mono)
        );
        assert!(over.reduced_motion && over.player == now.player);
        assert_eq!(over.look().blocks, Blocks::Sextants);
    }

    #[test]
    fn automatic_blocks_are_those_that_the_terminal_draws() {
        for (file, blocks) in [
            ("format = 1\n", Blocks::Octants),
            ("format = 1\nblocks = \"automatic\"\n", Blocks::Octants),
            ("format = 1\nblocks = \"quadrants\"\n", Blocks::Quadrants),
        ] {
            let kept = KeptSettings::read("settings.toml", file.as_bytes()).unwrap();
            let mut over = kept.over(Settings::default());
            over.known_blocks = Blocks::Octants;
            assert_eq!(over.look().blocks, blocks, "{file}");
        }
    }

    #[test]
    fn a_screen_without_colours_stays_colourless() {
        let file = b"format = 1\ncolours = \"256\"\n";
        let kept = KeptSettings::read("settings.toml", file).unwrap();
        assert_eq!(kept.over(Settings::default()).depth, Depth::None);
        let shows = Settings {
            depth: Depth::True,
            ..Settings::default()
        };
        assert_eq!(kept.over(shows).depth, Depth::Indexed256);
    }

    #[test]
    fn a_file_of_format_1_can_always_be_read() {
        let file = "format = 1\ncharset = \"unicode\"\npalette = \"no colour\"\n\
            colours = \"16\"\nmotion = \"reduced\"\npredict_first = \"no\"\n\
            foretold = \"3\"\nplayer = \"Ada\"\n";
        let kept = KeptSettings::read("settings.toml", file.as_bytes()).unwrap();
        let over = kept.over(Settings {
            depth: Depth::True,
            ..Settings::default()
        });
        assert_eq!(
            (over.charset, over.palette),
            (Charset::Unicode, Palette::Mono)
        );
        assert_eq!((over.depth, over.predicted), (Depth::Ansi16, 3));
        assert!(over.reduced_motion && !over.predict && over.player == "Ada");
    }

    /// Earlier versions accepted an invisible name.
    #[test]
    fn an_invisible_name_is_ignored_and_the_other_settings_are_kept() {
        let file = "format = 1\ncharset = \"unicode\"\nplayer = \"\u{2800}\"\n";
        let kept = KeptSettings::read("settings.toml", file.as_bytes()).unwrap();
        let over = kept.over(Settings::default());
        assert_eq!(over.charset, Charset::Unicode);
        assert_eq!(over.player, Settings::default().player);
    }

    #[test]
    fn an_invalid_settings_file_is_refused() {
        for (file, said) in [
            ("", "format"),
            ("format = 2\n", "newer"),
            ("format = 1\ncharset = \"runes\"\n", "ascii, unicode"),
            (
                "format = 1\nblocks = \"dots\"\n",
                "settings.toml:2: blocks: expected one of automatic, quadrants, sextants, octants",
            ),
            ("format = 1\nplayer = \"\"\n", "player"),
            ("format = 1\ncolour = \"16\"\n", "colour"),
        ] {
            let refused = KeptSettings::read("settings.toml", file.as_bytes());
            let message = refused.unwrap_err().to_string();
            assert!(message.contains(said), "{message}");
        }
    }
}

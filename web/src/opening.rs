//! Opens the screen that a link names: `#quiz=mixed-7&player=Ana`. The names in the link are the
//! same as on the command line.

use carrom::app::{App, Data};
use carrom::class::team_names;
use carrom::files::{LONGEST_QUOTE, escape_control, tidy_name};
use carrom::game::is_player_name;
use carrom::quiz::Code;
use carrom::screens::{KeptSettings, Route, Settings};
use carrom::widgets::{Charset, Depth, Palette};

use crate::message::Opening;

/// The largest number of errors that are reported for one link.
const MOST_FAULTS: usize = 5;

/// The app that the page's [`Opening`] requests. The first screen reports the invalid parts of the
/// link, up to [`MOST_FAULTS`].
pub(crate) fn app(opening: &Opening, data: Data, kept: KeptSettings) -> App {
    let mut wanted = LinkTarget {
        route: Route::Home,
        settings: kept.over(Settings {
            charset: Charset::Unicode,
            depth: Depth::True,
            palette: palette(opening.light),
            reduced_motion: opening.still,
            sees: !opening.simulated,
            ..Settings::default()
        }),
        seed: None,
    };
    let mut faults = Vec::new();
    for part in opening.fragment.split('&').filter(|part| !part.is_empty()) {
        let (name, value) = part.split_once('=').unwrap_or((part, ""));
        let (name, value) = (unescaped(name), unescaped(value));
        if let Err(expected) = wanted.take(&name, &value, &data)
            && faults.len() < MOST_FAULTS
        {
            let found = escape_control(&format!("{name}={value}"), LONGEST_QUOTE);
            let expected = match expected.contains("expected") {
                true => expected,
                false => format!("expected {expected}"),
            };
            faults.push(format!("The link contains {found}: {expected}."));
        }
    }
    // As on the command line: a seed alone means ten hits.
    if let (Some(seed), Route::Quiz(None)) = (wanted.seed, &wanted.route) {
        wanted.route = Route::Quiz(Some(Code::hits(seed)));
    }
    let seed = wanted.seed.unwrap_or(opening.seed);
    let mut app = App::with_data(data, wanted.route, wanted.settings, seed);
    app.set_kept(Some(kept));
    if !faults.is_empty() {
        app.notify(faults.join(" "));
    }
    app
}

/// The palette for a light or a dark theme.
pub(crate) const fn palette(light: bool) -> Palette {
    if light { Palette::Light } else { Palette::Dark }
}

pub(crate) fn is_plain(fragment: &str) -> bool {
    fragment.split('&').any(|part| part == "plain")
}

struct LinkTarget {
    route: Route,
    settings: Settings,
    /// The seed, if the link contains one.
    seed: Option<u64>,
}

impl LinkTarget {
    fn take(&mut self, name: &str, value: &str, data: &Data) -> Result<(), String> {
        match name {
            "plain" => {}
            "class" => {
                let route = data.route(name, value)?;
                let before = std::mem::replace(&mut self.route, route);
                if let Route::Class { teams: named, .. } = before
                    && let Route::Class { teams, .. } = &mut self.route
                {
                    *teams = named;
                }
            }
            "code" => {
                let expected = "a six-letter class code, such as BCDFGH";
                self.route = Route::Join {
                    address: None,
                    code: Some(value.parse().map_err(|_| expected)?),
                    again: false,
                };
            }
            "said" => {
                let round = std::mem::replace(&mut self.route, Route::Home);
                self.route = round.with_answers(value)?;
            }
            "again" => {
                if let Route::Join { again, .. } = &mut self.route {
                    *again = true;
                }
            }
            "teams" => {
                let names = team_names(value.split(',')).map_err(|error| error.to_string())?;
                if !matches!(self.route, Route::Class { .. }) {
                    self.route = data.route("class", "")?;
                }
                if let Route::Class { teams, .. } = &mut self.route {
                    *teams = names;
                }
            }
            "player" if is_player_name(value.trim()) => self.settings.player = tidy_name(value),
            "player" => return Err("a name of 1 to 40 visible characters".into()),
            "seed" => self.seed = Some(value.parse().map_err(|_| "a whole number")?),
            "charset" => {
                self.settings.charset = value.parse().map_err(|_| "ascii or unicode")?;
            }
            "color" => {
                let depth = value.parse();
                self.settings.depth = depth.map_err(|_| "none, 16, 256 or truecolor")?;
            }
            "palette" => {
                self.settings.palette = match value {
                    "dark" => Palette::Dark,
                    "light" => Palette::Light,
                    _ => return Err("dark or light".into()),
                }
            }
            _ => self.route = data.route(name, value)?,
        }
        Ok(())
    }
}

/// A part of an address, decoded: `%20` and `+` become spaces.
pub(crate) fn unescaped(text: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = text.as_bytes();
    while let Some((first, after)) = rest.split_first() {
        let escaped = after.get(..2).filter(|_| *first == b'%');
        let byte = escaped
            .and_then(|digits| str::from_utf8(digits).ok())
            .and_then(|digits| u8::from_str_radix(digits, 16).ok());
        (rest, _) = match byte {
            Some(byte) => (&after[2..], bytes.push(byte)),
            None if *first == b'+' => (after, bytes.push(b' ')),
            None => (after, bytes.push(*first)),
        };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use carrom::shells::Headless;

    use super::*;

    fn opened(fragment: &str) -> App {
        let opening = Opening {
            fragment: fragment.into(),
            seed: 5,
            ..Opening::default()
        };
        app(&opening, Data::default(), KeptSettings::default())
    }

    /// A link may come from anybody: even a hostile one opens a screen, which briefly reports what
    /// is invalid.
    #[test]
    fn a_hostile_link_opens_the_first_screen_and_is_quoted_in_part() {
        // This letter does not otherwise occur on the screen.
        let long = "Ж".repeat(100_000);
        for fragment in [
            "quiz=mixed99999999999999999999-7".to_owned(),
            "quiz=review-7".into(),
            "quiz=own-7".into(),
            "lesson=99999999999999999999".into(),
            "lesson=-1".into(),
            "level=..%2f..%2fetc".into(),
            "code=%00%1b%5b2J".into(),
            "player=%e2%a0%80".into(),
            "seed=1e999".into(),
            "teams=,,,,,,,,,,,,,,,".into(),
            format!("quiz={long}"),
            format!("{long}={long}"),
            "x&".repeat(100_000),
        ] {
            let mut game = Headless::from(opened(&fragment));
            game.resize(120, 40);
            let screen = game.screen();
            assert!(
                screen.contains("The link contains"),
                "{fragment:.40}: {screen}"
            );
            assert!(screen.matches('Ж').count() <= LONGEST_QUOTE, "{screen}");
        }
    }

    #[test]
    fn parts_of_a_link_are_decoded() {
        for (spelt, text) in [
            ("Ana", "Ana"),
            ("Ada%20L", "Ada L"),
            ("Ada+L", "Ada L"),
            ("%C3%A4", "ä"),
            ("100%", "100%"),
            ("%zz%4", "%zz%4"),
        ] {
            assert_eq!(unescaped(spelt), text);
        }
    }

    #[test]
    fn a_link_opens_a_screen_by_its_name() {
        for name in ["lab", "quiz", "levels", "progress", "settings"] {
            let mut game = Headless::from(opened(name));
            let screen = game.screen();
            assert!(screen.contains(&format!("carrom : {name}")), "{screen}");
        }
    }

    #[test]
    fn a_link_sets_the_player_and_the_appearance() {
        let app = opened("quiz=mixed-7&player=Ana&palette=light&charset=ascii");
        let settings = app.settings();
        assert_eq!(settings.player, "Ana");
        assert_eq!(settings.palette, Palette::Light);
        assert_eq!(settings.charset, Charset::Ascii);
    }
}

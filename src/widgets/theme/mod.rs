//! The colours of everything on the screen.
//!
//! A picture specifies what a thing *is*, its [`Role`]; only the [`Theme`] knows how a role looks
//! in the player's [`Palette`] and with the colours of the terminal ([`Depth`]). The colours are
//! based on Okabe and Ito's set ("Color Universal Design", 2008), which people with the common
//! kinds of colour blindness can distinguish. A colour never carries meaning alone: a letter, a
//! line style or a weight always repeats it.
//!
//! The eye should find the collision first, so contrast decreases from the velocities of the two
//! discs, through the line of impact and the arcs, to the lines of the board and the frames.

mod colour;
mod role;

use ratatui::style::{Color, Modifier, Style};
use strum::{EnumString, VariantNames};

pub(super) use colour::Rgb;
pub use role::Role;

/// The set of colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Palette {
    /// Light on dark, for a terminal on a desk.
    #[default]
    Dark,
    /// Dark on light, with deeper colours, for a projector in a bright room.
    Light,
    /// No colours: only bold, dim, reverse and underline.
    Mono,
}

impl Palette {
    /// The next palette, cyclically.
    #[must_use]
    pub const fn next(self) -> Self {
        match self {
            Self::Dark => Self::Light,
            Self::Light => Self::Mono,
            Self::Mono => Self::Dark,
        }
    }
}

/// The number of colours that the terminal supports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, EnumString, VariantNames)]
pub enum Depth {
    /// No colours: the screen is monochrome in every palette.
    #[strum(serialize = "none")]
    None,
    /// The sixteen named colours.
    #[strum(serialize = "16")]
    Ansi16,
    /// The 256 indexed colours: a 6 × 6 × 6 cube and a range of greys.
    #[strum(serialize = "256")]
    Indexed256,
    /// Any colour, 24 bits.
    #[default]
    #[strum(serialize = "truecolor")]
    True,
}

/// A palette at a colour depth: the style of every [`Role`].
///
/// ```
/// use carrom::widgets::{Depth, Palette, Role, Theme};
/// let theme = Theme::new(Palette::Dark, Depth::Ansi16);
/// assert_ne!(theme.style(Role::StrikerOut), theme.style(Role::CoinOut));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Theme {
    /// The set of colours.
    pub palette: Palette,
    /// The number of colours available.
    pub depth: Depth,
}

impl Theme {
    /// Creates a theme of `palette` for a terminal with the colour depth `depth`.
    pub const fn new(palette: Palette, depth: Depth) -> Self {
        Self { palette, depth }
    }

    /// Whether no colour is used at all.
    pub(crate) fn is_mono(self) -> bool {
        self.palette == Palette::Mono || self.depth == Depth::None
    }

    /// Whether a disc of this role is drawn only as a rim, as black coins are if there is no colour
    /// to distinguish them from white coins.
    pub(crate) fn is_hollow(self, role: Role) -> bool {
        self.is_mono() && role == Role::Black
    }

    /// The style of plain text on the background, which is also used to clear a screen.
    pub fn base(self) -> Style {
        if self.is_mono() {
            return Style::new();
        }
        Style::new()
            .fg(self.colour(Role::Text))
            .bg(self.colour(Role::Background))
    }

    /// The colour and weight of something with this role. Only [`Role::Selected`] changes the
    /// background.
    pub fn style(self, role: Role) -> Style {
        if self.is_mono() {
            return Style::new().add_modifier(role.mono_modifier());
        }
        let (ink, paper) = (self.colour(role), self.colour(Role::Background));
        let style = Style::new().add_modifier(role.modifier());
        match role {
            Role::Selected => style.fg(paper).bg(ink),
            _ => style.fg(ink),
        }
    }

    /// Like [`Theme::style`], but faded towards the background: at age 0 the style is unchanged, at
    /// age 1 it is faint. `age` is clamped to the range from 0 to 1.
    pub(crate) fn faded(self, role: Role, age: f64) -> Style {
        let age = if age > 0.0 { age.min(1.0) } else { 0.0 };
        if age < 1.0 / 64.0 {
            return self.style(role);
        }
        if self.is_mono() {
            let plain = Style::new();
            return if age > 0.4 { plain.dim() } else { plain };
        }
        if self.depth == Depth::Ansi16 {
            return self.style(if age > 0.5 { Role::Dim } else { role });
        }
        // Even the oldest stroke keeps a quarter of its colour, so that it stays visible.
        let mixed = self.rgb(role).mixed(self.rgb(Role::Background), age * 0.75);
        Style::new().fg(self.reduced(mixed))
    }

    /// The style of a cell that a disc of this role covers completely.
    pub fn fill(self, role: Role) -> Style {
        if self.is_mono() {
            return Style::new();
        }
        let colour = self.colour(role);
        Style::new().fg(colour).bg(colour)
    }

    /// The style of a letter or a line on a disc of this role.
    pub fn on(self, role: Role) -> Style {
        if self.is_hollow(role) {
            return Style::new();
        }
        if self.is_mono() {
            return Style::new().add_modifier(Modifier::REVERSED);
        }
        let ink = if self.depth == Depth::Ansi16 {
            role.ansi_ink(self.palette)
        } else {
            self.reduced(self.rgb(role).ink())
        };
        Style::new().fg(ink).bg(self.colour(role))
    }

    /// Like [`Theme::on`], for marks that should not dominate the disc, such as geometry drawn over
    /// it.
    pub(crate) fn faintly_on(self, role: Role) -> Style {
        if self.is_mono() || self.depth == Depth::Ansi16 {
            return self.on(role);
        }
        let disc = self.rgb(role);
        self.on(role).fg(self.reduced(disc.ink().mixed(disc, 0.35)))
    }

    /// The colour of a role, without its weight; [`Color::Reset`] in monochrome.
    pub fn colour(self, role: Role) -> Color {
        if self.is_mono() {
            Color::Reset
        } else if self.depth == Depth::Ansi16 {
            role.ansi(self.palette)
        } else {
            self.reduced(self.rgb(role))
        }
    }

    /// The colour of a role on a terminal that can show every colour. In monochrome there are only
    /// three colours: text, fainter text, and the background.
    pub(super) fn rgb(self, role: Role) -> Rgb {
        let role = match role {
            Role::Background => role,
            _ if !self.is_mono() => role,
            _ if role.mono_modifier().contains(Modifier::DIM) => Role::Dim,
            _ => Role::Text,
        };
        role.rgb(self.palette)
    }

    /// Whether the terminal has shades between two colours.
    pub(super) fn has_shades(self) -> bool {
        !self.is_mono() && matches!(self.depth, Depth::Indexed256 | Depth::True)
    }

    /// The faint colour of a disc of this role, on which marks are clearly visible.
    pub(super) fn faint(self, role: Role) -> Rgb {
        self.rgb(Role::Background).mixed(self.rgb(role), 0.3)
    }

    /// The terminal's nearest colour.
    pub(super) fn reduced(self, rgb: Rgb) -> Color {
        if self.depth == Depth::Indexed256 {
            Color::Indexed(rgb.indexed())
        } else {
            rgb.into()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The contrast, as defined by the Web Content Accessibility Guidelines 2.1.
    fn contrast(a: Rgb, b: Rgb) -> f64 {
        let (a, b) = (a.luminance(), b.luminance());
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn contrast_decreases_from_the_collision_to_the_frame() {
        for palette in [Palette::Dark, Palette::Light] {
            let of = |role: Role| contrast(role.rgb(palette), Role::Background.rgb(palette));
            for strong in [Role::StrikerOut, Role::CoinOut, Role::Incoming, Role::Text] {
                assert!(of(strong) >= 4.5, "{palette:?} {strong:?} {}", of(strong));
                for middle in [Role::LineOfImpact, Role::Arc] {
                    assert!(of(strong) > of(middle), "{palette:?} {strong:?} {middle:?}");
                }
            }
            for middle in [Role::LineOfImpact, Role::Arc, Role::Dim] {
                assert!(of(middle) >= 3.0, "{palette:?} {middle:?} {}", of(middle));
                for weak in [Role::BoardLine, Role::Border] {
                    assert!(of(middle) > of(weak), "{palette:?} {middle:?} {weak:?}");
                }
            }
        }
    }

    #[test]
    fn contrast_on_a_board_decreases_from_the_pieces_to_its_own_lines() {
        for palette in [Palette::Dark, Palette::Light] {
            for depth in [Depth::Indexed256, Depth::True] {
                let theme = Theme::new(palette, depth);
                let shown = |role| match theme.colour(role) {
                    Color::Rgb(red, green, blue) => Rgb(red, green, blue),
                    Color::Indexed(index) => Rgb::fixed(index),
                    other => panic!("{other:?}"),
                };
                let of = |role: Role| contrast(shown(role), shown(Role::Surface));
                let strong = [
                    Role::Striker,
                    Role::Coin,
                    Role::Black,
                    Role::Queen,
                    Role::Marble,
                    Role::Aim,
                    Role::Trail,
                    Role::Predicted,
                    Role::Incoming,
                    Role::StrikerOut,
                    Role::CoinOut,
                    Role::Contact,
                    Role::Good,
                    Role::Key,
                    Role::Text,
                ];
                for role in strong {
                    assert!(of(role) >= 3.0, "{theme:?} {role:?} {}", of(role));
                }
                for role in [Role::BoardLine, Role::Rail, Role::BaseCircle] {
                    let weak = 1.2..3.0;
                    assert!(weak.contains(&of(role)), "{theme:?} {role:?} {}", of(role));
                }
            }
        }
    }

    #[test]
    fn letters_on_discs_are_legible() {
        for palette in [Palette::Dark, Palette::Light] {
            for &role in Role::ALL {
                let fill = role.rgb(palette);
                assert!(contrast(fill, fill.ink()) >= 4.5, "{palette:?} {role:?}");
            }
        }
    }

    #[test]
    fn without_colour_no_style_has_a_colour() {
        for theme in [
            Theme::new(Palette::Mono, Depth::True),
            Theme::new(Palette::Dark, Depth::None),
        ] {
            for &role in Role::ALL {
                for style in [
                    theme.base(),
                    theme.style(role),
                    theme.faded(role, 0.7),
                    theme.fill(role),
                    theme.on(role),
                ] {
                    assert_eq!((style.fg, style.bg), (None, None), "{role:?}");
                }
            }
        }
    }

    #[test]
    fn fading_ends_before_the_stroke_is_lost() {
        let theme = Theme::default();
        assert_eq!(theme.faded(Role::Trail, f64::NAN), theme.style(Role::Trail));
        let oldest = theme.faded(Role::Striker, 1.0);
        assert_eq!(oldest, theme.faded(Role::Striker, 9.0));
        assert_ne!(oldest.fg, Some(theme.colour(Role::Background)));
    }
}

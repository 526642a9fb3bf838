//! Colours as numbers, and their reduction to the colours of a terminal.

use std::fmt;

use ratatui::style::Color;

/// The levels of a channel in the cube of indexed colours.
const STEPS: [u8; 6] = [0, 95, 135, 175, 215, 255];

/// A colour in sRGB, with the channels red, green and blue. Its `Display` form is CSS notation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::widgets) struct Rgb(
    pub(in crate::widgets) u8,
    pub(in crate::widgets) u8,
    pub(in crate::widgets) u8,
);

impl fmt::Display for Rgb {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

impl Rgb {
    /// A colour from a code 0xRRGGBB.
    pub(in crate::widgets) const fn hex(code: u32) -> Self {
        Self((code >> 16) as u8, (code >> 8) as u8, code as u8)
    }

    /// A mixture of this colour and `other`; `amount`, from 0 to 1, is the fraction of `other`.
    pub(in crate::widgets) fn mixed(self, other: Self, amount: f64) -> Self {
        let mix = |a: u8, b: u8| {
            (f64::from(a) + (f64::from(b) - f64::from(a)) * amount.clamp(0.0, 1.0)).round() as u8
        };
        Self(
            mix(self.0, other.0),
            mix(self.1, other.1),
            mix(self.2, other.2),
        )
    }

    /// Relative luminance, 0 (black) to 1 (white), as defined by the Web Content Accessibility
    /// Guidelines 2.1.
    pub(super) fn luminance(self) -> f64 {
        let linear = |channel: u8| {
            let c = f64::from(channel) / 255.0;
            if c <= 0.040_45 {
                c / 12.92
            } else {
                ((c + 0.055) / 1.055).powf(2.4)
            }
        };
        0.2126 * linear(self.0) + 0.7152 * linear(self.1) + 0.0722 * linear(self.2)
    }

    /// Black or white, whichever is easier to read on top of this colour.
    pub(in crate::widgets) fn ink(self) -> Self {
        // The luminance at which black and white have the same contrast: √(1.05 × 0.05) − 0.05.
        if self.luminance() > 0.179 {
            Self::hex(0x000000)
        } else {
            Self::hex(0xffffff)
        }
    }

    /// One of the 240 fixed indexed colours, which start at 16: a 6 × 6 × 6 cube, then greys.
    pub(in crate::widgets) fn fixed(index: u8) -> Self {
        if let Some(grey) = index.checked_sub(232) {
            let level = 8 + 10 * grey;
            return Self(level, level, level);
        }
        let i = index.saturating_sub(16);
        let [red, green, blue] = [i / 36, i / 6 % 6, i % 6].map(|i| STEPS[usize::from(i)]);
        Self(red, green, blue)
    }

    /// The index of the nearest fixed colour.
    pub(super) fn indexed(self) -> u8 {
        let step = |channel: u8| {
            let steps = (0..).zip(STEPS);
            let nearest = steps.min_by_key(|(_, level)| level.abs_diff(channel));
            nearest.map_or(0, |(i, _)| i)
        };
        let cube: u8 = 16 + 36 * step(self.0) + 6 * step(self.1) + step(self.2);
        let mean = (u16::from(self.0) + u16::from(self.1) + u16::from(self.2)) / 3;
        let grey = 232 + (mean.saturating_sub(3) / 10).min(23) as u8;
        let off = |index| self.distance(Self::fixed(index));
        if off(grey) < off(cube) { grey } else { cube }
    }

    fn distance(self, other: Self) -> u32 {
        let square = |a: u8, b: u8| u32::from(a.abs_diff(b)).pow(2);
        square(self.0, other.0) + square(self.1, other.1) + square(self.2, other.2)
    }
}

impl From<Rgb> for Color {
    fn from(Rgb(r, g, b): Rgb) -> Self {
        Self::Rgb(r, g, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fixed_colours_keep_their_own_index() {
        for (code, index) in [
            (0x000000, 16),
            (0xffffff, 231),
            (0xff0000, 196),
            (0x5f87af, 67),
            (0x080808, 232),
            (0xeeeeee, 255),
        ] {
            assert_eq!(Rgb::hex(code).indexed(), index, "{code:06x}");
        }
    }
}

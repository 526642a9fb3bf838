//! The soft edge of a disc: the block element and the two colours that best fit a cell.

use super::cell::Cell;
use super::glyphs::block;
use crate::widgets::Role;
use crate::widgets::theme::{Rgb, Theme};

/// The true colours of a cell: of the discs, and of the board and the background beside them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shades {
    parts: [(u64, Rgb); 6],
}

impl Shades {
    pub(super) fn of(cell: &Cell, theme: &Theme) -> Self {
        let [top, below] = cell.discs.map(|disc| {
            let colour = match disc.faint {
                true => theme.faint(disc.role),
                false => theme.rgb(disc.role),
            };
            (disc.bits, colour)
        });
        let free = !cell.cover();
        let [a, b, c] = cell
            .ground
            .map(|part| (part.bits & free, theme.rgb(part.role)));
        let rest = (free & !(a.0 | b.0 | c.0), theme.rgb(Role::Background));
        Self {
            parts: [top, below, a, b, c, rest],
        }
    }

    /// The mean colour of a part of the cell, in a grid of 8 × 8.
    pub(super) fn mean(&self, bits: u64) -> Rgb {
        let [red, green, blue] = self.means(bits).map(|it| it.round() as u8);
        Rgb(red, green, blue)
    }

    fn means(&self, bits: u64) -> [f64; 3] {
        let all = f64::from(bits.count_ones().max(1));
        let parts = self.parts.iter().filter(|(part, _)| part & bits != 0);
        let sum = parts.fold([0.0; 3], |sum, (part, colour)| {
            let count = f64::from((part & bits).count_ones());
            let [red, green, blue] = channels(*colour);
            [
                sum[0] + count * red,
                sum[1] + count * green,
                sum[2] + count * blue,
            ]
        });
        sum.map(|channel| channel / all)
    }

    /// The sum of squared errors if a part of the cell is drawn in its mean colour.
    fn error(&self, bits: u64) -> f64 {
        let mean = self.means(bits);
        let off = |(part, colour): &(u64, Rgb)| {
            let square = |(a, b): (f64, f64)| (a - b) * (a - b);
            let apart: f64 = channels(*colour).into_iter().zip(mean).map(square).sum();
            f64::from((part & bits).count_ones()) * apart
        };
        let parts = self.parts.iter().filter(|(part, _)| part & bits != 0);
        parts.map(off).sum()
    }

    /// The block element with the smallest error, and its foreground and background colours.
    pub(super) fn fitted(&self) -> (char, [Rgb; 2]) {
        let off = |bits: u64| self.error(bits) + self.error(!bits);
        // The edge of a frame has the shape of a block element, so the search ends early.
        let is_part = |bits: u64| self.parts.iter().any(|part| part.0 == bits);
        let exact = || block::shapes().find(|it| is_part(it.1) && is_part(!it.1));
        let nearest = || block::shapes().min_by(|a, b| off(a.1).total_cmp(&off(b.1)));
        let (symbol, bits) = exact().or_else(nearest).unwrap_or((' ', 0));
        (symbol, [bits, !bits].map(|bits| self.mean(bits)))
    }
}

fn channels(Rgb(red, green, blue): Rgb) -> [f64; 3] {
    [red, green, blue].map(f64::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    const DISC: Rgb = Rgb(200, 100, 0);
    const OTHER: Rgb = Rgb(0, 0, 250);
    const PAPER: Rgb = Rgb(10, 20, 30);

    fn shades(disc: u64, other: u64) -> Shades {
        let other = other & !disc;
        let rest = (!(disc | other), PAPER);
        let mut parts = [(0, PAPER); 6];
        parts[..3].copy_from_slice(&[(disc, DISC), (other, OTHER), rest]);
        Shades { parts }
    }

    #[test]
    fn the_shape_of_a_block_element_has_no_error() {
        for (_, bits) in block::shapes() {
            let (symbol, [ink, paper]) = shades(bits, 0).fitted();
            let shown = block::shapes().find(|shape| shape.0 == symbol).unwrap().1;
            let of = |bit: u32| if shown >> bit & 1 == 1 { ink } else { paper };
            for bit in 0..64 {
                let true_one = if bits >> bit & 1 == 1 { DISC } else { PAPER };
                assert_eq!(of(bit), true_one, "{symbol}");
            }
        }
    }

    #[test]
    fn where_two_discs_touch_both_colours_are_kept() {
        let left = 0x0f0f_0f0f_0f0f_0f0f;
        let (symbol, colours) = shades(left, !left).fitted();
        assert_eq!((symbol, colours), ('▌', [DISC, OTHER]));
    }

    #[test]
    fn a_slope_is_drawn_no_worse_than_in_one_colour_and_a_sliver_becomes_a_shade() {
        // No block element has the shape of a staircase of eighths.
        let slope = (0..8).fold(0, |bits, row| bits | ((1_u64 << row) - 1) << (8 * row));
        let one = shades(slope, 0);
        let (symbol, [ink, paper]) = one.fitted();
        assert_ne!(ink, paper, "{symbol}");
        let sliver = shades(1, 0);
        let Rgb(red, ..) = sliver.mean(u64::MAX);
        assert!(red > PAPER.0 && red < 20, "{red}");
    }
}

//! The soft edge of a disc: the block element and the two colours that best fit a cell.

use super::cell::Cell;
use super::glyphs::block;
use crate::widgets::theme::{Rgb, Theme};
use crate::widgets::{Blocks, Role};

/// The true colours in a cell: those of discs, and those of the board and the background beside
/// them.
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

    /// The mean colour of part of a cell, which is divided into 8 × 8 squares.
    pub(super) fn mean(&self, bits: u64) -> Rgb {
        let all = f64::from(bits.count_ones().max(1));
        let [red, green, blue] = self.sum(bits).map(|sum| (sum / all).round() as u8);
        Rgb(red, green, blue)
    }

    /// The sum of each colour channel over part of the cell.
    fn sum(&self, bits: u64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (part, Rgb(red, green, blue)) in self.parts {
            let count = f64::from((part & bits).count_ones());
            for (sum, channel) in sum.iter_mut().zip([red, green, blue]) {
                *sum += count * f64::from(channel);
            }
        }
        sum
    }

    /// The sum of squared errors, up to a constant, if part of the cell and the rest are each drawn
    /// in their mean colour.
    fn error(&self, bits: u64) -> f64 {
        let square_of_mean = |bits: u64| {
            let squares: f64 = self.sum(bits).iter().map(|sum| sum * sum).sum();
            squares / f64::from(bits.count_ones().max(1))
        };
        -square_of_mean(bits) - square_of_mean(!bits)
    }

    /// The block element of a set that has the smallest error, with its foreground and background
    /// colours.
    pub(super) fn fitted(&self, set: Blocks) -> (char, [Rgb; 2]) {
        let (_, symbol, bits) = self.best(set);
        (symbol, [bits, !bits].map(|bits| self.mean(bits)))
    }

    /// The best block element: its error, its character and the part that it covers.
    fn best(&self, set: Blocks) -> (f64, char, u64) {
        block::shapes(set, self.parts.map(|(part, _)| part))
            .map(|(symbol, bits)| (self.error(bits), symbol, bits))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .unwrap_or_default()
    }
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
        for (_, bits) in block::shapes(Blocks::Quadrants, [0; 3]) {
            let (symbol, [ink, paper]) = shades(bits, 0).fitted(Blocks::Quadrants);
            let shown = block::shapes(Blocks::Quadrants, [0; 3])
                .find(|shape| shape.0 == symbol)
                .unwrap()
                .1;
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
        let (symbol, colours) = shades(left, !left).fitted(Blocks::Quadrants);
        assert_eq!((symbol, colours), ('▌', [DISC, OTHER]));
    }

    #[test]
    fn a_slope_is_drawn_no_worse_than_in_one_colour_and_a_sliver_becomes_a_shade() {
        // This slope is a staircase of eighths, for which no block element has the right shape.
        let slope = (0..8).fold(0, |bits, row| bits | ((1_u64 << row) - 1) << (8 * row));
        let one = shades(slope, 0);
        let (symbol, [ink, paper]) = one.fitted(Blocks::Quadrants);
        assert_ne!(ink, paper, "{symbol}");
        let sliver = shades(1, 0);
        let Rgb(red, ..) = sliver.mean(u64::MAX);
        assert!(red > PAPER.0 && red < 20, "{red}");
    }

    #[test]
    fn for_two_colours_no_finer_block_is_better_than_those_tried() {
        // The test uses the edges of discs, and irregular patterns.
        let edge = |at: u32| {
            let (x, y) = (
                f64::from(at) * 0.618 % 1.0 * 20.0 - 10.0,
                f64::from(at) * 0.755 % 20.0,
            );
            let inside = |bit: &u32| {
                let point = (f64::from(bit % 8) - x, f64::from(bit / 8) - y);
                point.0.hypot(point.1) < 12.0
            };
            (0..64)
                .filter(inside)
                .fold(0, |bits, bit| bits | 1_u64 << bit)
        };
        let random = |at: u32| u64::from(at + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        for cover in (0..100).flat_map(|at| [edge(at), random(at)]) {
            let shades = shades(cover, 0);
            for (set, rows) in [
                (Blocks::Sextants, &[0, 3, 5, 8][..]),
                (Blocks::Octants, &[0, 2, 4, 6, 8]),
            ] {
                let of_part = |bit: u32| {
                    let row = rows.iter().rposition(|row| *row <= bit / 8).unwrap();
                    2 * row as u32 + bit % 8 / 4
                };
                let best = (0..1_u32 << (2 * (rows.len() - 1))).map(|parts| {
                    let covered = (0..64).filter(|bit| parts >> of_part(*bit) & 1 == 1);
                    let bits = covered.fold(0, |bits, bit| bits | 1_u64 << bit);
                    shades.error(bits)
                });
                let best = best.fold(f64::INFINITY, f64::min);
                assert!(shades.best(set).0 <= best + 1e-6, "{set:?} {cover:x}");
            }
        }
    }
}

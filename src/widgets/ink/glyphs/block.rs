//! The block element nearest to a pattern in an 8 × 8 grid, for filled discs.

use std::sync::LazyLock;

use crate::widgets::Blocks;
use crate::widgets::text::blocks::{self, LEFT, LOWER, QUARTERS};

/// A block element. An inverse block is drawn in the background's colour on the disc's colour,
/// which gives shapes for which Unicode has no character.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(in super::super) struct BlockGlyph {
    pub(in super::super) symbol: char,
    pub(in super::super) inverse: bool,
    /// The squares of the 8 × 8 grid that the block covers, row by row from the top left.
    cover: u64,
}

static BLOCKS: LazyLock<Vec<BlockGlyph>> = LazyLock::new(|| {
    let mut blocks = Vec::new();
    let mut add = |symbol, inverse, cover| {
        blocks.push(BlockGlyph {
            symbol,
            inverse,
            cover,
        });
    };
    for (bits, symbol) in (0..).zip(QUARTERS) {
        let cover = grid(|x, y| bits >> (x / 4 + 2 * (y / 4)) & 1 == 1);
        add(symbol, false, cover);
    }
    for (eighths, symbol) in (1..).zip(LOWER) {
        let cover = grid(|_, y| y >= 8 - eighths);
        add(symbol, false, cover);
        add(symbol, true, !cover);
    }
    for (eighths, symbol) in (1..).zip(LEFT) {
        let cover = grid(|x, _| x < eighths);
        add(symbol, false, cover);
        add(symbol, true, !cover);
    }
    blocks
});

fn grid(inside: impl Fn(u32, u32) -> bool) -> u64 {
    (0..64)
        .filter(|&i| inside(i % 8, i / 8))
        .fold(0, |cover, i| cover | 1 << i)
}

/// The finer block elements of a set.
struct Finer {
    /// The part of a cell that corresponds to each bit.
    parts: Vec<u64>,
    /// The blocks, indexed by the bits of their parts; `None` for those that are among [`BLOCKS`].
    /// If some terminals with this set lack the character for a block, the block is drawn as the
    /// inverse of another one.
    blocks: Vec<Option<BlockGlyph>>,
}

static SEXTANTS: LazyLock<Finer> = LazyLock::new(|| Finer::new(&[0, 3, 5, 8], blocks::sextants()));
static OCTANTS: LazyLock<Finer> = LazyLock::new(|| Finer::new(&[0, 2, 4, 6, 8], blocks::octants()));

impl Finer {
    /// The finer blocks in a set: octants for shapes with edges at quarters of a cell's height,
    /// sextants for shapes with edges at thirds of it.
    fn of(set: Blocks) -> impl Iterator<Item = &'static Self> {
        [(Blocks::Sextants, &SEXTANTS), (Blocks::Octants, &OCTANTS)]
            .into_iter()
            .filter(move |(least, _)| set >= *least)
            .map(|(_, finer)| &**finer)
    }

    /// Creates blocks that have two columns, and rows between the given edges (in eighths of a
    /// cell).
    fn new(edges: &[u32], symbols: impl Iterator<Item = (char, u8)>) -> Self {
        let rows = edges.iter().zip(edges.iter().skip(1));
        let parts: Vec<u64> = rows
            .flat_map(|(from, to)| {
                [0, 1].map(|column| grid(|x, y| x / 4 == column && (from..to).contains(&&y)))
            })
            .collect();
        let mut blocks = vec![None; 1 << parts.len()];
        let all = blocks.len() - 1;
        for (symbol, bits) in symbols {
            let bits = usize::from(bits);
            let cover = (parts.iter().enumerate())
                .filter(|(bit, _)| bits >> bit & 1 == 1)
                .fold(0, |cover, (_, part)| cover | part);
            let block = |inverse, cover| BlockGlyph {
                symbol,
                inverse,
                cover,
            };
            blocks[bits] = Some(block(false, cover));
            blocks[all - bits].get_or_insert(block(true, !cover));
        }
        Self { parts, blocks }
    }

    /// The block made of the parts that are covered by `cover` to at least the same extent as the
    /// part `least`.
    fn split(&self, least: u64, cover: u64) -> Option<BlockGlyph> {
        let inside = |part: u64| (part & cover).count_ones();
        let lies =
            |part: u64| inside(part) * least.count_ones() >= inside(least) * part.count_ones();
        let bits = (self.parts.iter().enumerate())
            .filter(|(_, part)| lies(**part))
            .fold(0, |bits, (bit, _)| bits | 1 << bit);
        *self.blocks.get(bits)?
    }
}

/// The blocks to try in a cell whose colours have these areas, each with the area that its
/// character covers.
///
/// If the cell has two colours, the best of the finer blocks separates the parts with more of a
/// colour from those with less; for three colours this is nearly true. So only a few blocks need to
/// be tried.
pub(in super::super) fn shapes<const COLOURS: usize>(
    set: Blocks,
    colours: [u64; COLOURS],
) -> impl Iterator<Item = (char, u64)> {
    let upright = BLOCKS.iter().filter(|block| !block.inverse).copied();
    // If two colours fill the cell, splitting by either of them gives the same result.
    let is_needed = move |at: &usize| {
        let mut before = colours.iter().take(*at);
        colours[*at] != 0 && before.all(|it| *it != !colours[*at])
    };
    let finer = Finer::of(set).flat_map(move |finer| {
        let splits = move |at| {
            let parts = finer.parts.iter();
            parts.filter_map(move |part| finer.split(*part, colours[at]))
        };
        (0..colours.len()).filter(is_needed).flat_map(splits)
    });
    upright.chain(finer).map(|block| match block.inverse {
        true => (block.symbol, !block.cover),
        false => (block.symbol, block.cover),
    })
}

/// The block nearest to `cover`; inverse blocks are considered only if `inverse` is set.
pub(in super::super) fn nearest(set: Blocks, cover: u64, inverse: bool) -> BlockGlyph {
    BLOCKS
        .iter()
        .chain(Finer::of(set).flat_map(|finer| finer.blocks.iter().flatten()))
        .filter(|block| inverse || !block.inverse)
        .min_by_key(|block| (block.cover ^ cover).count_ones())
        .copied()
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_block_is_nearest_to_itself() {
        for set in [Blocks::Quadrants, Blocks::Sextants, Blocks::Octants] {
            let finer = Finer::of(set).flat_map(|finer| finer.blocks.iter().flatten());
            for block in BLOCKS.iter().chain(finer) {
                assert_eq!(nearest(set, block.cover, true).cover, block.cover);
            }
        }
    }

    #[test]
    fn every_pattern_of_the_parts_has_a_block() {
        for (set, patterns) in [(Blocks::Sextants, 1 << 6), (Blocks::Octants, 1 << 8)] {
            let parts = &Finer::of(set).last().unwrap().parts;
            assert_eq!(parts.iter().fold(0, |all, part| all | part), u64::MAX);
            for bits in 0..patterns {
                let chosen = parts
                    .iter()
                    .enumerate()
                    .filter(|(bit, _)| bits >> bit & 1 == 1);
                let cover = chosen.fold(0, |cover, (_, part)| cover | part);
                assert_eq!(nearest(set, cover, true).cover, cover, "{set:?} {bits:b}");
            }
        }
    }

    #[test]
    fn without_inverse_blocks_only_halves_and_quarters_remain() {
        assert_eq!(
            nearest(Blocks::Quadrants, grid(|x, _| x >= 3), false).symbol,
            '▐'
        );
        assert_eq!(
            nearest(Blocks::Quadrants, grid(|_, y| y < 5), false).symbol,
            '▀'
        );
        assert_eq!(nearest(Blocks::Quadrants, u64::MAX, false).symbol, '█');
        assert_eq!(nearest(Blocks::Quadrants, 0, false).symbol, ' ');
    }
}

//! The block element nearest to a pattern in an 8 × 8 grid, for filled discs.

use std::sync::LazyLock;

use crate::widgets::text::blocks::{LEFT, LOWER, QUARTERS};

/// A block element, and whether it is drawn in the background's colour on the disc's colour, which
/// gives shapes for which Unicode has no character.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(in super::super) struct BlockGlyph {
    pub(in super::super) symbol: char,
    pub(in super::super) inverse: bool,
    /// The cells of the 8 × 8 grid that it covers, row by row from the top left.
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

/// All block elements except the inverse ones, each with the cells that it covers.
pub(in super::super) fn shapes() -> impl Iterator<Item = (char, u64)> {
    let upright = BLOCKS.iter().filter(|block| !block.inverse);
    upright.map(|block| (block.symbol, block.cover))
}

/// The block nearest to `cover`; inverse blocks are used only if `inverse` is set.
pub(in super::super) fn nearest(cover: u64, inverse: bool) -> BlockGlyph {
    BLOCKS
        .iter()
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
        for block in BLOCKS.iter() {
            assert_eq!(nearest(block.cover, true).cover, block.cover);
        }
    }

    #[test]
    fn without_inverse_blocks_only_halves_and_quarters_remain() {
        assert_eq!(nearest(grid(|x, _| x >= 3), false).symbol, '▐');
        assert_eq!(nearest(grid(|_, y| y < 5), false).symbol, '▀');
        assert_eq!(nearest(u64::MAX, false).symbol, '█');
        assert_eq!(nearest(0, false).symbol, ' ');
    }
}

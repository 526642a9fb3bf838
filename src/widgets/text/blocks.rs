//! Characters that fill part of their cell.

/// Quarters of a cell. The bits of the index are: upper left, upper right, lower left, lower right.
pub(crate) const QUARTERS: [char; 16] = [
    ' ', '▘', '▝', '▀', '▖', '▌', '▞', '▛', '▗', '▚', '▐', '▜', '▄', '▙', '▟', '█',
];

/// One to seven eighths of a cell, filled from below.
pub(crate) const LOWER: [char; 7] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇'];

/// One to seven eighths of a cell, filled from the left.
pub(crate) const LEFT: [char; 7] = ['▏', '▎', '▍', '▌', '▋', '▊', '▉'];

/// The bit of each braille dot in the code point of its character, row by row from the top left in
/// a grid of 2 × 4. Unicode numbers dots 1-3 down the left, 4-6 down the right, then 7 and 8.
pub(crate) const BRAILLE: [u32; 8] = [0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80];

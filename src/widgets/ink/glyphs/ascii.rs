//! The ASCII glyph nearest to a pattern in a 3 × 5 grid.

use std::sync::LazyLock;

/// Samples in a cell: columns, rows.
pub(in super::super) const GRID: (usize, usize) = (3, 5);
const SAMPLES: usize = GRID.0 * GRID.1;

/// How much ink each glyph has in each sample, row by row from the top left, as
/// measured in a common monospace font. (The apostrophe of most fonts is upright;
/// the grave accent has its ink to the left.)
const INK: [(u8, [f32; SAMPLES]); 13] = [
    (b' ', [0.0; SAMPLES]),
    (
        b'.',
        [
            0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.37, 0.0, 0.0, 0.0, 0.0,
        ],
    ),
    (
        b'\'',
        [
            0.0, 0.0, 0.0, 0.0, 0.43, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        ],
    ),
    (
        b'`',
        [
            0.06, 0.06, 0.0, 0.01, 0.24, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        ],
    ),
    (
        b',',
        [
            0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.36, 0.0, 0.0, 0.28, 0.0,
        ],
    ),
    (
        b'-',
        [
            0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.05, 0.40, 0.06, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        ],
    ),
    (
        b'_',
        [
            0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.40, 0.40, 0.40,
        ],
    ),
    (
        b'|',
        [
            0.0, 0.0, 0.0, 0.0, 0.42, 0.0, 0.0, 0.42, 0.0, 0.0, 0.42, 0.0, 0.0, 0.42, 0.0,
        ],
    ),
    (
        b'/',
        [
            0.0, 0.0, 0.0, 0.0, 0.15, 0.31, 0.0, 0.46, 0.0, 0.31, 0.16, 0.0, 0.09, 0.0, 0.0,
        ],
    ),
    (
        b'\\',
        [
            0.0, 0.0, 0.0, 0.38, 0.08, 0.0, 0.02, 0.44, 0.0, 0.0, 0.25, 0.22, 0.0, 0.0, 0.09,
        ],
    ),
    (
        b'(',
        [
            0.0, 0.0, 0.0, 0.0, 0.40, 0.02, 0.0, 0.47, 0.0, 0.0, 0.46, 0.0, 0.0, 0.23, 0.02,
        ],
    ),
    (
        b')',
        [
            0.0, 0.0, 0.0, 0.02, 0.41, 0.0, 0.0, 0.47, 0.0, 0.0, 0.46, 0.0, 0.02, 0.23, 0.0,
        ],
    ),
    (
        b'"',
        [
            0.0, 0.0, 0.0, 0.18, 0.49, 0.18, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        ],
    ),
];

/// How much of a sample's ink its neighbours get: strokes are a little wider than
/// the samples they hit, and so are the glyphs.
const BLUR: f32 = 0.5;

/// How much ink a sample has that a stroke goes through.
const FULL: f32 = 0.4;

static NEAREST: LazyLock<Box<[u8]>> = LazyLock::new(|| {
    let inks = blurred_inks();
    (0..1 << SAMPLES)
        .map(|mask| nearest_by_search(mask, &inks))
        .collect()
});

/// The glyph nearest to a mask of samples (bit 0 is the top left one).
pub(in super::super) fn nearest(mask: u16) -> char {
    NEAREST
        .get(usize::from(mask))
        .map_or(' ', |&glyph| char::from(glyph))
}

fn blurred_inks() -> Vec<(u8, [f32; SAMPLES])> {
    INK.iter()
        .map(|&(glyph, ink)| (glyph, blurred(&ink)))
        .collect()
}

fn nearest_by_search(mask: u16, inks: &[(u8, [f32; SAMPLES])]) -> u8 {
    let drawn = std::array::from_fn(|i| if mask >> i & 1 == 1 { FULL } else { 0.0 });
    let drawn = blurred(&drawn);
    inks.iter()
        .map(|(glyph, ink)| {
            let off: f32 = ink.iter().zip(&drawn).map(|(a, b)| (a - b).powi(2)).sum();
            (*glyph, off)
        })
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map_or(b' ', |(glyph, _)| glyph)
}

fn blurred(ink: &[f32; SAMPLES]) -> [f32; SAMPLES] {
    let (columns, rows) = (GRID.0 as isize, GRID.1 as isize);
    std::array::from_fn(|i| {
        let (x, y) = (i as isize % columns, i as isize / columns);
        let mut sum = 0.0;
        for (dx, dy, share) in [
            (0, 0, 1.0),
            (-1, 0, BLUR),
            (1, 0, BLUR),
            (0, -1, BLUR),
            (0, 1, BLUR),
        ] {
            let (x, y) = (x + dx, y + dy);
            if (0..columns).contains(&x) && (0..rows).contains(&y) {
                sum += share * ink[(y * columns + x) as usize];
            }
        }
        sum
    })
}

//! The ASCII glyph nearest to a pattern in a 3 × 5 grid.

use std::sync::LazyLock;

/// The number of samples in a cell: columns, rows.
pub(in super::super) const GRID: (usize, usize) = (3, 5);
const SAMPLES: usize = GRID.0 * GRID.1;

/// The amount of ink of each glyph in each sample, in hundredths, row by row from the top left, as
/// measured in a common monospace font. (The apostrophe of most fonts is upright;
/// the grave accent has its ink on the left.)
const HUNDREDTHS: [(u8, [u8; SAMPLES]); 13] = [
    (b' ', [0; SAMPLES]),
    (b'.', [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 37, 0, 0, 0, 0]),
    (b'\'', [0, 0, 0, 0, 43, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
    (b'`', [6, 6, 0, 1, 24, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
    (b',', [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 36, 0, 0, 28, 0]),
    (b'-', [0, 0, 0, 0, 0, 0, 5, 40, 6, 0, 0, 0, 0, 0, 0]),
    (b'_', [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 40, 40, 40]),
    (b'|', [0, 0, 0, 0, 42, 0, 0, 42, 0, 0, 42, 0, 0, 42, 0]),
    (b'/', [0, 0, 0, 0, 15, 31, 0, 46, 0, 31, 16, 0, 9, 0, 0]),
    (b'\\', [0, 0, 0, 38, 8, 0, 2, 44, 0, 0, 25, 22, 0, 0, 9]),
    (b'(', [0, 0, 0, 0, 40, 2, 0, 47, 0, 0, 46, 0, 0, 23, 2]),
    (b')', [0, 0, 0, 2, 41, 0, 0, 47, 0, 0, 46, 0, 2, 23, 0]),
    (b'"', [0, 0, 0, 18, 49, 18, 0, 0, 0, 0, 0, 0, 0, 0, 0]),
];

/// The amounts of ink, where 1 is a full sample.
pub(in super::super) static INK: LazyLock<[(u8, [f32; SAMPLES]); GLYPHS]> = LazyLock::new(|| {
    HUNDREDTHS.map(|(glyph, ink)| (glyph, ink.map(|sample| f32::from(sample) / 100.0)))
});

/// The fraction of a sample's ink that each neighbouring sample receives, because both strokes and
/// glyphs are slightly wider than the samples that they pass through.
const BLUR: f32 = 0.5;

/// The amount of ink in a sample that a stroke passes through.
const FULL: f32 = 0.4;

/// The glyph nearest to each mask.
///
/// The squared distance between a drawing d and a glyph g is d² − 2 d·g + g². The first term is the
/// same for all glyphs, and d·g is a sum over the samples of the mask, so it can be split into one
/// sum for the low half of the mask and one for the high half.
static NEAREST: LazyLock<Box<[u8]>> = LazyLock::new(|| {
    let weights = INK.map(|(_, ink)| weights(&ink));
    let sizes = INK.map(|(_, ink)| blurred(&ink).iter().map(|ink| ink * ink).sum::<f32>());
    let sums = |first: usize, count: usize| -> Vec<[f32; GLYPHS]> {
        let sum = |mask: usize, weights: &[f32; SAMPLES]| {
            (0..count)
                .filter(|bit| mask >> bit & 1 == 1)
                .map(|bit| weights[first + bit])
                .sum()
        };
        (0..1 << count)
            .map(|mask| std::array::from_fn(|glyph| sum(mask, &weights[glyph])))
            .collect()
    };
    let (low, high) = (sums(0, LOW), sums(LOW, SAMPLES - LOW));
    let best = |low: &[f32; GLYPHS], high: &[f32; GLYPHS]| {
        let mut best = (b' ', f32::INFINITY);
        for (glyph, (symbol, _)) in INK.iter().enumerate() {
            let distance = sizes[glyph] - 2.0 * (low[glyph] + high[glyph]);
            if distance < best.1 {
                best = (*symbol, distance);
            }
        }
        best.0
    };
    high.iter()
        .flat_map(|high| low.iter().map(|low| best(low, high)))
        .collect()
});

const GLYPHS: usize = HUNDREDTHS.len();
/// The number of samples in the low half of a mask.
const LOW: usize = 8;

/// The glyph nearest to a mask of samples (bit 0 is the top left sample).
pub(in super::super) fn nearest(mask: u16) -> char {
    NEAREST
        .get(usize::from(mask))
        .map_or(' ', |&glyph| char::from(glyph))
}

/// The contribution of each sample of a drawing to its similarity to a glyph.
fn weights(ink: &[f32; SAMPLES]) -> [f32; SAMPLES] {
    let ink = blurred(ink);
    std::array::from_fn(|sample| {
        let mut alone = [0.0; SAMPLES];
        alone[sample] = FULL;
        blurred(&alone).iter().zip(&ink).map(|(a, b)| a * b).sum()
    })
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_agrees_with_an_exhaustive_search() {
        for mask in 0..1u16 << SAMPLES {
            let drawn = std::array::from_fn(|i| if mask >> i & 1 == 1 { FULL } else { 0.0 });
            let drawn = blurred(&drawn);
            let distance = |ink: &[f32; SAMPLES]| -> f32 {
                let ink = blurred(ink);
                ink.iter().zip(&drawn).map(|(a, b)| (a - b).powi(2)).sum()
            };
            let found = nearest(mask);
            let of_found = INK.iter().find(|(glyph, _)| char::from(*glyph) == found);
            let of_found = of_found.map(|(_, ink)| distance(ink));
            let least = INK.iter().map(|(_, ink)| distance(ink)).reduce(f32::min);
            let (Some(of_found), Some(least)) = (of_found, least) else {
                panic!("{found} is not one of the glyphs");
            };
            assert!(of_found <= least + 1e-4, "{mask:015b} {found}");
        }
    }

    #[test]
    fn simple_shapes_get_the_obvious_glyphs() {
        for (rows, glyph) in [
            (["...", "...", "...", "...", "..."], ' '),
            (["...", "...", "###", "...", "..."], '-'),
            (["...", "...", "...", "...", "###"], '_'),
            ([".#.", ".#.", ".#.", ".#.", ".#."], '|'),
            (["..#", "..#", ".#.", "#..", "#.."], '/'),
            (["#..", "#..", ".#.", "..#", "..#"], '\\'),
            (["...", "###", "...", "...", "..."], '"'),
            (["...", "...", "...", ".#.", "..."], '.'),
        ] {
            let drawn = rows.concat();
            let samples = drawn.bytes().enumerate().filter(|(_, ink)| *ink == b'#');
            let mask = samples.fold(0, |mask, (sample, _)| mask | 1 << sample);
            assert_eq!(nearest(mask), glyph, "{rows:?}");
        }
    }
}

//! Damages files at random.

use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_pcg::Pcg64Mcg;

/// Values that replace a number.
const NUMBERS: [&str; 14] = [
    "0",
    "-0.0",
    "-1",
    "1e300",
    "-1e300",
    "1e-300",
    "NaN",
    "inf",
    "-inf",
    "9999999999999999999",
    "0.1",
    "true",
    "\"x\"",
    "[]",
];

/// Damages a file at one random position.
pub(crate) fn change(bytes: &mut Vec<u8>, chance: &mut Pcg64Mcg) {
    if bytes.is_empty() {
        return bytes.push(chance.random());
    }
    let at = chance.random_range(0..bytes.len());
    let end = (at + chance.random_range(1..64)).min(bytes.len());
    match chance.random_range(0..8) {
        0 => bytes[at] ^= 1 << chance.random_range(0..8),
        1 => bytes[at] = chance.random(),
        2 => drop(bytes.drain(at..end)),
        3 => {
            let again = bytes[at..end].to_vec();
            bytes.splice(at..at, again);
        }
        4 => bytes.truncate(at),
        5 => {
            let noise: Vec<u8> = (at..end).map(|_| chance.random()).collect();
            bytes.splice(at..end, noise);
        }
        _ => {
            // Replaces the next number: most fields that matter are numbers.
            let is_part = |b: &u8| b.is_ascii_digit() || *b == b'.' || *b == b'-';
            let Some(start) = bytes[at..].iter().position(u8::is_ascii_digit) else {
                return;
            };
            let start = at + start;
            let length = bytes[start..].iter().take_while(|b| is_part(b)).count();
            let number = NUMBERS.choose(chance).copied().unwrap_or_default();
            bytes.splice(start..start + length, number.bytes());
        }
    }
}

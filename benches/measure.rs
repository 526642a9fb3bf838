//! Reads and measures a film of a million rows: `cargo bench --bench measure`.
//!
//! The benchmark fails if this takes more than two seconds.

use std::fmt::Write;
use std::time::Instant;

use carrom::measure::{Given, Measurement, Reading, read};

const ROWS: u32 = 1_000_000;
/// The maximum time in seconds.
const MOST: f64 = 2.0;

/// Two equal pucks that meet after half of the rows, with some noise.
fn film() -> String {
    let mut text = String::from("t,x1,y1,x2,y2\n");
    for row in 0..ROWS {
        let t = f64::from(row) * 1e-6 - 0.5;
        // This noise needs no random number generator.
        let noise = |turn: f64| 1e-3 * (turn * f64::from(row)).sin();
        let [x1, y1, x2, y2] = match t < 0.0 {
            true => [t, 0.0, 0.05, 0.0],
            false => [0.25 * t, 0.433 * t, 0.05 + 0.75 * t, -0.433 * t],
        };
        let _ = writeln!(
            text,
            "{t:.6},{:.6},{:.6},{:.6},{:.6}",
            x1 + noise(12.9),
            y1 + noise(78.2),
            x2 + noise(37.7),
            y2 + noise(93.9)
        );
    }
    text
}

fn main() {
    let text = film();
    let start = Instant::now();
    let tracks = read(&[("film.csv", text.as_bytes())], &Reading::default());
    let tracks = tracks.unwrap_or_else(|errors| panic!("{errors}"));
    let read = start.elapsed().as_secs_f64();
    let measured = Measurement::new(tracks, Given::default());
    let measured = measured.unwrap_or_else(|fault| panic!("{fault}"));
    let all = start.elapsed().as_secs_f64();
    println!("{}", measured.sentences().join("\n"));
    println!("{ROWS} rows: read in {read:.2} s, read and measured in {all:.2} s");
    assert!(all <= MOST, "more than {MOST} s");
}

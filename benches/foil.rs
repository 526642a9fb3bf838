//! How fast a beam is simulated and counted: `cargo bench --bench foil`.
//!
//! For each law, particles are counted into 36 bins on one core. The table of edges and the plain
//! loop, which computes the angle of each particle, run in the same rounds. Both count the same
//! particles, so their counts must be equal. The highest rate of many rounds and the median rate
//! are printed.

use std::hint::black_box;
use std::time::Instant;

use carrom::app::App;
use carrom::beams::{BIN_WIDTH, BINS, BeamTarget, Counts, METALS, Sampler, ScatteringLaw};
use carrom::physics::beam::Beam;
use carrom::physics::rutherford::RADIUM_C_ENERGY;
use carrom::screens::{FoilPage, Route, Settings};
use carrom::shells::{FRAME, Headless};
use carrom::widgets::{Charset, Depth};
use rand::Rng;
use rand_pcg::Pcg64;

const PARTICLES: u64 = 4_000_000;
const ROUNDS: usize = 40;
const SEED: u64 = 1913;

fn main() {
    let spheres = ScatteringLaw {
        target: BeamTarget::Hard,
        beam: Beam::Space,
    };
    let gold = ScatteringLaw {
        target: METALS[0].foil(2.1e-7, RADIUM_C_ENERGY),
        beam: Beam::Space,
    };
    compare("hard spheres", &spheres);
    compare("gold foil", &gold);
    whole(&spheres);
    pictures();
}

/// Times the table and the plain loop alternately.
fn compare(name: &str, law: &ScatteringLaw) {
    let sampler = Sampler::new(law);
    let mut times = [const { Vec::new() }; 2];
    for _ in 0..ROUNDS {
        let mut counts = Counts::default();
        let start = Instant::now();
        sampler.throw(SEED, 0..PARTICLES, black_box(&mut counts));
        times[0].push(start.elapsed().as_secs_f64());
        let start = Instant::now();
        let plain = black_box(plain(law));
        times[1].push(start.elapsed().as_secs_f64());
        assert_eq!(counts, plain, "{name}");
    }
    for (way, mut times) in ["table of edges", "plain loop"].into_iter().zip(times) {
        times.sort_by(f64::total_cmp);
        let rate = |time: f64| PARTICLES as f64 / time / 1e6;
        println!(
            "{name:<13} {way:<15} {:7.1} million a second (median {:.1})",
            rate(times[0]),
            rate(times[ROUNDS / 2]),
        );
    }
}

/// Computes a random number, an offset, an angle and a bin for each particle.
fn plain(law: &ScatteringLaw) -> Counts {
    let mut numbers = Pcg64::new(u128::from(SEED), 0x0a02_bdbf_7bb3_c0a7);
    let mut counts = Counts::default();
    for _ in 0..PARTICLES {
        let even = numbers.next_u64() as f64 / 2_f64.powi(64);
        let bin = (law.angle(even.sqrt()) / BIN_WIDTH) as usize;
        counts.bins[bin.min(BINS - 1)] += 1;
    }
    counts
}

/// Times the app's work for each frame, in a terminal of 120 columns and 40 rows, while a beam
/// of 10⁸ particles is running: one batch of the beam, and the drawing.
fn pictures() {
    let settings = Settings {
        predict: false,
        charset: Charset::Unicode,
        depth: Depth::True,
        ..Settings::default()
    };
    let mut game = Headless::new(
        App::new(Route::Foil(FoilPage::default()), settings, SEED),
        120,
        40,
    );
    game.press("<Tab><Down><Down><Down><Down><Down><Right><Right><Enter>");
    let mut times = Vec::new();
    while game.app().wake().is_some() {
        let start = Instant::now();
        game.pass(FRAME);
        black_box(game.buffer());
        times.push(start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    println!(
        "10^8 on screen: {} pictures, {:.2} ms each (median), {:.2} ms at worst",
        times.len(),
        times[times.len() / 2] * 1e3,
        times[times.len() - 1] * 1e3,
    );
}

/// Times the construction of the table, and a whole beam of 10⁸ at once.
fn whole(law: &ScatteringLaw) {
    let start = Instant::now();
    let sampler = black_box(Sampler::new(law));
    let made = start.elapsed();
    let mut counts = Counts::default();
    let start = Instant::now();
    sampler.throw(SEED, 0..100_000_000, &mut counts);
    println!(
        "tables {:.0} µs, 10^8 particles {:.2} s",
        made.as_secs_f64() * 1e6,
        start.elapsed().as_secs_f64()
    );
    black_box(&counts);
}

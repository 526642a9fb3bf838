//! Measures the size and speed of the page and prints the results for a person to judge: `cargo
//! test --test page figures -- --ignored --nocapture`.

use std::fs;
use std::time::Instant;

use carrom::cli;
use carrom::messages::Key;
use carrom::shells::Headless;
use serde_json::{Value, json};

use crate::browser::{Browser, TIME_FRAMES, page, press, wait_until_ready};
use crate::chromium::Chromium;

/// Reopens the page on a simulated computer that is slower by this factor.
fn open(chromium: &mut Chromium, page: &str, slower: f64) {
    chromium.open("about:blank");
    chromium.debug("Emulation.setCPUThrottlingRate", &json!({ "rate": slower }));
    chromium.open(page);
    wait_until_ready(chromium);
    std::thread::sleep(std::time::Duration::from_millis(500));
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// The time without a frame, in milliseconds, after which everything is considered to be at rest
/// and no more frames are expected.
const REST: f64 = 250.0;

/// The milliseconds between consecutive frames, until everything is at rest.
fn gaps(times: &[f64]) -> Vec<f64> {
    let pairs = times.windows(2).map(|pair| pair[1] - pair[0]);
    pairs.take_while(|gap| *gap < REST).collect()
}

/// Measures how many milliseconds of work each frame of a series takes.
const WORK: &str = "
    return Array.from({ length: 45 }, () => {
      const start = performance.now();
      window.carrom.step(16);
      return performance.now() - start;
    });";

#[test]
#[ignore = "measures times, which a person must judge"]
fn figures_of_the_page() {
    let (page, mut chromium) = (page(), Chromium::start((1280, 800), false));
    let path = page.strip_prefix("file://").unwrap();
    let bytes = fs::metadata(path).unwrap().len();
    println!("size: {:.2} MB", bytes as f64 / 1e6);
    for slower in [1.0, 4.0] {
        let first = (0..5).map(|_| {
            open(&mut chromium, &page, slower);
            chromium
                .run("return window.carrom.seen().first", &[])
                .as_f64()
                .unwrap()
        });
        println!(
            "first frame at {slower}x: {:.0} ms",
            median(first.collect())
        );
    }
    for (what, fragment, keys) in [
        (
            "the replay of a hit",
            "lab",
            vec!["Enter", "6", "0", "Enter", "3", "0", "Enter"],
        ),
        (
            "the replay of a break",
            "table&seed=3",
            vec!["Enter", "ArrowUp", " "],
        ),
    ] {
        open(&mut chromium, &format!("{page}#{fragment}"), 4.0);
        chromium.run(TIME_FRAMES, &[]);
        press(&mut chromium, &keys);
        std::thread::sleep(std::time::Duration::from_millis(2500));
        let times = chromium.run("return window.frameTimes", &[]);
        let times = times.as_array().unwrap().iter().filter_map(Value::as_f64);
        let gaps = gaps(&times.collect::<Vec<_>>());
        let seconds = gaps.iter().sum::<f64>() / 1e3;
        let each = gaps.len() as f64 / seconds;
        // On a busy computer frames are late, so the work for each frame is printed too.
        open(&mut chromium, &format!("{page}#{fragment}"), 4.0);
        press(&mut chromium, &keys);
        let work = chromium.run(WORK, &[]);
        let work = work.as_array().unwrap().iter().filter_map(Value::as_f64);
        let work = median(work.collect());
        println!(
            "{what} at 4x: {each:.0} frames per second for {seconds:.1} s, {work:.1} ms of work per frame"
        );
    }
    open(&mut chromium, &page, 1.0);
    let wakes = "return window.carrom.seen().wakes";
    let before = chromium.run(wakes, &[]);
    std::thread::sleep(std::time::Duration::from_secs(3));
    let after = chromium.run(wakes, &[]);
    println!("idle: {before} wake-ups before waiting 3 s, {after} after");
    a_break(&mut chromium);
}

/// The number of breaks timed together, because a page's clock is coarse.
const TOGETHER: usize = 20;

/// Times the same break in the page and natively.
fn a_break(chromium: &mut Chromium) {
    let script = "
        return Array.from({ length: 15 }, () => {
          let time = 0;
          for (let i = 0; i < arguments[0]; i++) {
            program.call({ do: 'open', columns: 80, rows: 24, seed: 3, fragment: 'table' });
            program.call({ do: 'key', key: 'Enter' });
            program.call({ do: 'key', key: 'Up' });
            const start = performance.now();
            program.call({ do: 'key', key: 'Space' });
            time += performance.now() - start;
          }
          return time / arguments[0];
        });";
    let there = chromium.run(script, &[json!(TOGETHER)]);
    let there = there.as_array().unwrap().iter().filter_map(Value::as_f64);
    let here = (0..15).map(|_| {
        let times = (0..TOGETHER).map(|_| {
            let mut game = Headless::from(cli::open("table --seed 3").unwrap());
            game.key(Key::Enter);
            game.key(Key::Up);
            let start = Instant::now();
            game.key(Key::Char(' '));
            start.elapsed().as_secs_f64() * 1e3
        });
        times.sum::<f64>() / TOGETHER as f64
    });
    let (there, here) = (median(there.collect()), median(here.collect()));
    println!(
        "a break: {there:.3} ms in the page, {here:.3} ms natively, a factor of {:.1}",
        there / here
    );
}

//! Measures the cost of a frame while something moves: its size in bytes in a pseudo-terminal, and
//! the time to draw it: `cargo bench --bench frames`.

#[cfg(unix)]
#[allow(dead_code, reason = "only the output is counted")]
#[path = "../tests/common/pty.rs"]
mod pty;

#[cfg(unix)]
fn main() {
    use std::thread;
    use std::time::{Duration, Instant};

    use carrom::cli::open;
    use carrom::shells::Headless;
    use pty::{Pty, carrom};

    /// The length, in bytes, of each frame that begins after the first `skipped` bytes.
    fn pictures(bytes: &[u8], skipped: usize) -> Vec<usize> {
        let text = String::from_utf8_lossy(bytes.get(skipped..).unwrap_or_default());
        let pictures = text.split("\x1b[?2026h").skip(1);
        pictures.map(str::len).collect()
    }

    // Each scene has a name, a screen, the keys that start a motion there (as a terminal sends
    // them, then by their names) and the number of seconds recorded; 0 means scrolling down a list.
    let scenes: [(_, _, &[&str], _, _); 4] = [
        // The strike key has no effect until another key is pressed.
        (
            "break",
            "table",
            &["\r", "\x1b[C", " "],
            "<Enter><Right><Space>",
            3.0,
        ),
        (
            "lab",
            "lab",
            &["\r", "60", "\r", "30", "\r"],
            "<Enter>60<Enter>30<Enter>",
            2.0,
        ),
        (
            "foil",
            "foil",
            &["\t", "\r", "e", "\r"],
            "<Tab><Enter>e<Enter>",
            2.0,
        ),
        ("scroll", "levels", &[], "<Down>", 0.0),
    ];
    let sets = [
        ("unicode", "--charset unicode --blocks quadrants"),
        ("octants", "--charset unicode --blocks octants"),
        ("ascii", "--charset ascii"),
    ];
    println!("scene   size     charset   pictures  bytes a picture (mean, most)  drawn in");
    for (name, place, keys, named, seconds) in scenes {
        for (columns, rows) in [(120, 40), (80, 24)] {
            for (charset, options) in sets {
                let arguments = format!("{place} {options} --color truecolor");
                let words: Vec<_> = arguments.split(' ').collect();
                let mut pty = Pty::start(carrom(&words));
                pty.wait_for("? help");
                pty.resize(columns, rows);
                thread::sleep(Duration::from_millis(300));
                for key in keys {
                    pty.press(key);
                    thread::sleep(Duration::from_millis(100));
                }
                let before = pty.bytes().len();
                if seconds > 0.0 {
                    thread::sleep(Duration::from_secs_f64(seconds));
                } else {
                    for _ in 0..60 {
                        pty.press("\x1b[B");
                        thread::sleep(Duration::from_millis(50));
                    }
                }
                let sizes = pictures(&pty.bytes(), before);
                pty.press("\x03");
                pty.wait();
                // The time to draw is measured without a terminal.
                let Ok(app) = open(&arguments) else {
                    continue;
                };
                let mut game = Headless::new(app, columns, rows);
                game.press(named);
                let (start, drawn) = (Instant::now(), 60);
                for _ in 0..drawn {
                    game.pass(Duration::from_millis(16));
                    game.buffer();
                }
                println!(
                    "{name:7} {columns:>3}x{rows}   {charset:8}  {:8}  {:13.0} {:8}         {:6.2} ms",
                    sizes.len(),
                    sizes.iter().sum::<usize>() as f64 / sizes.len().max(1) as f64,
                    sizes.iter().max().unwrap_or(&0),
                    start.elapsed().as_secs_f64() * 1e3 / f64::from(drawn),
                );
            }
        }
    }
}

#[cfg(not(unix))]
fn main() {
    println!("frames are counted in a pseudo-terminal, which this system does not have");
}

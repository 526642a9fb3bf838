//! A whole school at one host: the real program in a terminal of its own, a `carrom join` in
//! another, a page in Chromium where `CARROM_TEST_PAGE` names one, and some two hundred devices,
//! good and bad. What it measures is printed:
//! `cargo test --test program crowd -- --ignored --nocapture`.

use std::fs;
use std::io::{Read, Write};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Sender};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use carrom::class::{ClassRound, Vote};
use carrom::quiz::Response;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rustix::process::Signal;

use crate::browser::named_page;
use crate::folder::Folder;
use crate::pty::{Pty, carrom};
use crate::pupil::{Pupil, connect};
use crate::seen_devices::{self, SeenDevice};

/// Questions of the round.
const QUESTIONS: usize = 10;

/// A port that is free just now.
fn free_port() -> u16 {
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    listener.local_addr().unwrap().port()
}

/// The round as it is on the disk, once there is one.
fn kept(folder: &Path) -> Option<ClassRound> {
    let bytes = fs::read(folder.join("classes/class-1.toml")).ok()?;
    Some(ClassRound::read("kept", &bytes, &Arc::default()).unwrap())
}

/// The code of the class, once the door is open.
fn door(folder: &Path) -> String {
    let start = Instant::now();
    loop {
        if let Some(code) = kept(folder).and_then(|round| round.door()) {
            return code.to_string();
        }
        assert!(
            start.elapsed() < Duration::from_secs(20),
            "the door stays closed"
        );
        thread::sleep(Duration::from_millis(5));
    }
}

/// A host in a terminal, with a round of ten questions at its door.
fn host(folder: &Path, port: u16, code: &str) -> Pty {
    let (data, port) = (folder.to_str().unwrap(), port.to_string());
    let mut arguments = vec![
        "class",
        "--host",
        "--port",
        &port,
        "--code",
        code,
        "--data-dir",
        data,
    ];
    let page = named_page();
    if let Some(page) = &page {
        arguments.extend(["--page", page.trim_start_matches("file://")]);
    }
    let pty = Pty::start(carrom(&arguments));
    pty.wait_for("the code of this class");
    pty
}

/// What devices report: how long something took.
#[derive(Debug)]
enum Report {
    Joined(Duration),
    Acknowledged(Duration),
    /// The device shows the step of this name of this question.
    Shows(u64, String, Instant),
}

/// A vote on whatever is asked.
fn vote_on(state: &serde_json::Value, chance: &mut Pcg64) -> String {
    let form = &state["question"]["form"];
    if form.get("rays").is_some() {
        let [a, b] = [0; 2].map(|_| chance.random_range(1..90));
        format!("think-so rays {a} {b}")
    } else if let Some(options) = form["choice"]["options"].as_array() {
        format!("sure choice {}", chance.random_range(1..=options.len()))
    } else if form.get("shot").is_some() {
        format!("shot {}", chance.random_range(0..20))
    } else {
        format!("guess number {}", chance.random_range(1..50))
    }
}

/// A good device: it votes whenever it may, after a moment, and reports.
fn good(port: u16, code: &str, number: u64, spread: Duration, reports: &Sender<Report>) {
    let mut chance = Pcg64::seed_from_u64(number);
    let start = Instant::now();
    let mut pupil = Pupil::join(port, code, &format!("Pupil {number}"), None).unwrap();
    assert_eq!(pupil.why(), None, "{:?}", pupil.state);
    let _ = reports.send(Report::Joined(start.elapsed()));
    let mut shown = (u64::MAX, String::new());
    loop {
        let now = (pupil.state["q"].as_u64().unwrap(), pupil.text("step"));
        if now != shown {
            shown = now.clone();
            let _ = reports.send(Report::Shows(now.0, now.1.clone(), Instant::now()));
            if now.1.ends_with("vote") {
                thread::sleep(spread.mul_f64(chance.random_range(0.0..1.0)));
                let said = vote_on(&pupil.state, &mut chance);
                let start = Instant::now();
                pupil.vote(&said).unwrap();
                let _ = reports.send(Report::Acknowledged(start.elapsed()));
                continue;
            }
        }
        if now.1 == "end" || pupil.hear().is_err() {
            return;
        }
    }
}

/// A device that joins and then reads a byte now and then, or nothing.
fn slow(port: u16, code: &str, name: &str, reads: bool, over: &AtomicBool) {
    let Ok(mut pupil) = Pupil::join(port, code, name, None) else {
        return;
    };
    let mut byte = [0];
    while !over.load(Ordering::SeqCst) {
        thread::sleep(Duration::from_millis(20));
        if reads {
            let _ = pupil.socket.get_mut().read(&mut byte);
        }
    }
}

/// Somebody who wants to be in the way.
fn hostile(port: u16, kind: usize, over: &AtomicBool) {
    let mut held = Vec::new();
    while !over.load(Ordering::SeqCst) {
        let Ok(mut stream) = connect(port) else {
            thread::sleep(Duration::from_millis(10));
            continue;
        };
        let _ = match kind {
            // Large frames.
            0 => Pupil::dial(port).and_then(|mut it| it.say(&"x".repeat(10_000_000))),
            // Connections that say nothing, for ever.
            1 => {
                held.push(stream);
                held.drain(..held.len().saturating_sub(200));
                Ok(())
            }
            // Noise.
            2 => stream.write_all(&[0xa5; 4096]),
            // Heads that never end.
            3 => stream
                .write_all(b"GET / HTTP/1.1\r\nX: y")
                .map(|()| held.push(stream)),
            // Codes at random.
            _ => Pupil::join(port, "BCDFGH", "x", None).map(drop),
        };
        held.drain(..held.len().saturating_sub(200));
        thread::sleep(Duration::from_millis(5));
    }
}

/// Processor time in seconds, and the most memory in megabytes, of a process.
fn used(pid: i32) -> (f64, f64) {
    let stat = fs::read_to_string(format!("/proc/{pid}/stat")).unwrap();
    let fields: Vec<&str> = stat
        .rsplit(')')
        .next()
        .unwrap()
        .split_whitespace()
        .collect();
    let ticks: f64 = fields[11].parse::<f64>().unwrap() + fields[12].parse::<f64>().unwrap();
    let status = fs::read_to_string(format!("/proc/{pid}/status")).unwrap();
    let line = status
        .lines()
        .find(|line| line.starts_with("VmHWM"))
        .unwrap();
    let kb: f64 = line.split_whitespace().nth(1).unwrap().parse().unwrap();
    (ticks / 100.0, kb / 1024.0)
}

fn print(what: &str, times: &mut [Duration]) {
    times.sort();
    let at = |share: f64| {
        let i = (share * (times.len().max(1) - 1) as f64).round() as usize;
        times.get(i).map_or(f64::NAN, |it| 1e3 * it.as_secs_f64())
    };
    println!(
        "{what:34} n {:6}   p50 {:7.1} ms   p99 {:7.1} ms   max {:7.1} ms",
        times.len(),
        at(0.5),
        at(0.99),
        at(1.0)
    );
}

/// A device with a screen, and how long that took to show what it should.
struct SeenTimes {
    name: &'static str,
    device: Box<dyn SeenDevice>,
    votes: Vec<Duration>,
    steps: Vec<Duration>,
}

impl SeenTimes {
    fn new(name: &'static str, device: impl SeenDevice + 'static) -> Self {
        Self {
            name,
            device: Box::new(device),
            votes: Vec::new(),
            steps: Vec::new(),
        }
    }
}

/// Plays the round with so many good devices and the others; prints what it took.
fn play(devices: u64, bad: bool) {
    let folder = Folder::new("crowd");
    let port = free_port();
    let mut pty = host(folder.path(), port, &format!("mixed{QUESTIONS}-7"));
    let code = door(folder.path());
    let (reports, heard) = mpsc::channel();
    let over = Arc::new(AtomicBool::new(false));
    let mut others = Vec::new();
    if bad {
        for i in 0..21 {
            let (code, over) = (code.clone(), Arc::clone(&over));
            others.push(thread::spawn(move || {
                slow(port, &code, &format!("Slow {i}"), i < 20, &over);
            }));
        }
        for kind in 0..5 {
            let over = Arc::clone(&over);
            others.push(thread::spawn(move || hostile(port, kind, &over)));
        }
    }
    let address = format!("127.0.0.1:{port}");
    let joins = ["join", &address, "--code", &code, "--player", "Terminal"];
    let mut terminal = Pty::start(carrom(&joins));
    terminal.wait_for("Come in");
    terminal.press("\r");
    terminal.wait_for("You are in, Terminal.");
    let mut seen_devices = vec![SeenTimes::new("terminal", terminal)];
    if named_page().is_some() {
        let browser = seen_devices::browser(port, &code, "Browser");
        seen_devices.push(SeenTimes::new("browser", browser));
    }
    let pupils: Vec<_> = (0..devices)
        .map(|number| {
            let (code, reports) = (code.clone(), reports.clone());
            let work = move || good(port, &code, number, Duration::from_secs(1), &reports);
            let builder = thread::Builder::new().stack_size(256 * 1024);
            builder.spawn(work).unwrap()
        })
        .collect();
    drop(reports);
    let mut joined = Vec::new();
    while joined.len() < devices as usize {
        if let Report::Joined(took) = heard.recv_timeout(Duration::from_secs(30)).unwrap() {
            joined.push(took);
        }
    }
    let mut seen = Vec::new();
    let mut acknowledged = Vec::new();
    let start = Instant::now();
    // Past the door, then six steps a question; on devices nobody only predicts.
    // What a screen says at each; how the truth is told differs from question to question.
    let steps = [
        ("describe", "Read with the class"),
        ("first-vote", "Enter: then "),
        ("talk", "Talk: find someone"),
        ("second-vote", "Your first vote stays"),
        ("shot", ""),
        ("scores", ""),
    ];
    for question in 0..QUESTIONS as u64 {
        for (step, words) in steps {
            let pressed = Instant::now();
            pty.press(if step == "scores" { "\x1b[F\r" } else { "\r" });
            let votes = step.ends_with("vote");
            for it in seen_devices.iter_mut().filter(|_| !words.is_empty()) {
                it.device.wait_for(words);
                it.steps.push(pressed.elapsed());
            }
            let mut waits = devices as usize * (1 + usize::from(votes));
            while waits > 0 {
                match heard.recv_timeout(Duration::from_secs(30)) {
                    Ok(Report::Shows(q, name, at)) if (q, name.as_str()) == (question, step) => {
                        seen.push(at - pressed);
                        waits -= 1;
                    }
                    Ok(Report::Acknowledged(took)) => {
                        acknowledged.push(took);
                        waits -= 1;
                    }
                    Ok(_) => {}
                    Err(error) => panic!("{question} {step}: {error}\n{}", pty.screen()),
                }
            }
            for it in seen_devices.iter_mut().filter(|_| votes) {
                it.votes.push(it.device.vote());
            }
        }
    }
    let took = start.elapsed();
    let (cpu, memory) = used(pty.pid());
    let all = if bad {
        ", 20 slow, 1 deaf, 5 hostile"
    } else {
        ""
    };
    println!("\n{devices} devices{all}: {QUESTIONS} questions, two votes each");
    print("joining", &mut joined);
    print("from a vote to its acknowledgement", &mut acknowledged);
    print("from a key to each screen", &mut seen);
    for it in &mut seen_devices {
        print(
            &format!("{}: from a vote to \"in\"", it.name),
            &mut it.votes,
        );
        print(
            &format!("{}: from a key to its step", it.name),
            &mut it.steps,
        );
    }
    println!(
        "host: {cpu:.1} s of processor time in {:.0} s, {memory:.0} MB at most",
        took.as_secs_f64()
    );
    // Nothing that was acknowledged is lost.
    let round = kept(folder.path()).unwrap();
    let votes = |question| [Vote::First, Vote::Second].map(|it| round.voted(question, it));
    for question in 0..QUESTIONS {
        assert_eq!(
            votes(question),
            [devices as usize + seen_devices.len(); 2],
            "question {question}"
        );
    }
    over.store(true, Ordering::SeqCst);
    pty.press("\r");
    pty.wait_for("tables for a spreadsheet");
    for pupil in pupils {
        pupil.join().unwrap();
    }
    for it in &mut seen_devices {
        it.device.wait_for("The round is over.");
    }
    for other in others {
        let _ = other.join();
    }
    pty.signal(Signal::KILL);
    pty.wait();
}

#[test]
#[ignore = "measures: some minutes"]
fn two_hundred_devices_vote() {
    play(198, false);
}

#[test]
#[ignore = "measures: some minutes"]
fn two_hundred_devices_vote_beside_slow_and_hostile_ones() {
    play(198, true);
}

/// A small crowd, so that this is tried with every change.
#[test]
fn a_few_devices_vote_beside_slow_and_hostile_ones() {
    play(12, true);
}

/// What a device knows of its votes when its host is killed: the last one that was in.
type LastIn = Arc<Mutex<Vec<Option<u32>>>>;

/// Votes are counted in thousandths of a degree: an angle has a limit.
const COUNTS_PER_DEGREE: f64 = 1000.0;

/// A device that votes without end, until its host is gone; then it comes back.
fn voter(
    port: u16,
    code: &str,
    number: usize,
    seat: Option<&str>,
    known: &LastIn,
) -> Option<String> {
    let mut chance = Pcg64::seed_from_u64(number as u64);
    let name = format!("Pupil {number}");
    let mut pupil = Pupil::join(port, code, &name, seat).ok()?;
    let seat = pupil.text("seat");
    let mut count = known.lock().unwrap()[number].unwrap_or(0) + 1;
    loop {
        // Each says a larger number than all before, so that an older one would be seen.
        count += 1;
        let angle = f64::from(count) / COUNTS_PER_DEGREE;
        if pupil.vote(&format!("rays 1 {angle}")).is_err() {
            return Some(seat);
        }
        known.lock().unwrap()[number] = Some(count);
        thread::sleep(Duration::from_millis(chance.random_range(0..5)));
    }
}

/// Killed in the midst of votes, again and again (`CARROM_KILLS` times), the host has every vote of
/// which a device heard that it is in, and all are back where they sat.
#[test]
fn a_host_is_killed_in_the_midst_of_votes_and_loses_none() {
    let kills = std::env::var("CARROM_KILLS")
        .ok()
        .and_then(|it| it.parse().ok());
    let is_measured = kills.is_some();
    let kills: usize = kills.unwrap_or(8);
    const DEVICES: usize = 12;
    let folder = Folder::new("host-killed");
    let (data, port) = (folder.path().to_str().unwrap(), free_port().to_string());
    let mut chance = Pcg64::seed_from_u64(5);
    let known: LastIn = Arc::new(Mutex::new(vec![None; DEVICES]));
    let mut seats: Vec<Option<String>> = vec![None; DEVICES];
    let mut back = Vec::new();
    let mut votes = 0;
    for kill in 0..kills {
        let first = kill == 0;
        let common = ["class", "--host", "--port", &port, "--data-dir", data];
        let fresh = ["--code", "from-angle2-7"];
        let arguments = [&common[..], if first { &fresh } else { &[] }].concat();
        let mut pty = Pty::start(carrom(&arguments));
        if first {
            pty.wait_for("the code of this class");
            pty.press("\r\r");
            pty.wait_for("have voted");
        } else {
            pty.wait_for("Take up an earlier round");
            pty.press("\x1b[F\r");
            pty.wait_for("from-angle2-7");
            pty.press("\r");
            pty.wait_for("the code of this class");
            pty.press("\r");
            pty.wait_for("have voted");
        }
        let code = door(folder.path());
        let number: u16 = port.parse().unwrap();
        // Everybody comes back, and has what they were told is in.
        let start = Instant::now();
        for (i, seat) in seats.iter_mut().enumerate() {
            let name = format!("Pupil {i}");
            let pupil = Pupil::join(number, &code, &name, seat.as_deref()).unwrap();
            assert_eq!(pupil.text("name"), name);
            *seat = Some(pupil.text("seat"));
        }
        back.push(start.elapsed());
        let round = kept(folder.path()).unwrap();
        // What is on the disk is the last that was in, or one that was just on its way.
        for (i, last) in known.lock().unwrap().iter().enumerate() {
            let Some(last) = last else { continue };
            let said = round.ballot(0, i).first.and_then(Response::rays);
            let said = said.and_then(|rays| rays.target).unwrap().to_degrees();
            let said = (COUNTS_PER_DEGREE * said).round() as u32;
            assert!(
                said >= *last,
                "kill {kill}: {i} heard that {last} is in, {said} is there"
            );
            votes += 1;
        }
        let voters: Vec<_> = (0..DEVICES)
            .map(|i| {
                let (code, known, seat) = (code.clone(), Arc::clone(&known), seats[i].clone());
                thread::spawn(move || voter(number, &code, i, seat.as_deref(), &known))
            })
            .collect();
        thread::sleep(Duration::from_millis(chance.random_range(20..300)));
        pty.signal(Signal::KILL);
        pty.wait();
        for (i, voter) in voters.into_iter().enumerate() {
            if let Some(seat) = voter.join().unwrap() {
                assert_eq!(Some(&seat), seats[i].as_ref());
            }
        }
    }
    let slowest = back.iter().max().unwrap();
    println!("{kills} kills, {votes} votes looked up, none lost; all back within {slowest:?}");
    // Where it is measured; beside all other tests it takes as long as those let it.
    assert!(
        !is_measured || *slowest < Duration::from_secs(2),
        "{slowest:?}"
    );
}

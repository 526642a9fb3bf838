//! A whole school connected to one host: the real program in a terminal, a `carrom join` in another
//! terminal, a page in Chromium if `CARROM_TEST_PAGE` names one, and about two hundred well-behaved
//! and misbehaving devices. The test prints what it measures: `cargo test --test program crowd --
//! --ignored --nocapture`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{Read, Write};
use std::net::TcpListener;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU16, Ordering};
use std::sync::mpsc::{self, Sender};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use carrom::class::{ClassChange, ClassPlace, ClassRound, ClassStep, SeatToken, Vote};
use carrom::quiz::Code;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rustix::process::Signal;

use crate::browser::named_page;
use crate::folder::Folder;
use crate::pty::{Pty, carrom};
use crate::pupil::{Pupil, connect_from};
use crate::seen_devices::{self, SeenDevice};

/// A free port that no other test gets: neither from this function nor from the system, which gives
/// outgoing connections only ports above 32,767.
fn free_port() -> u16 {
    static TRIED: AtomicU16 = AtomicU16::new(0);
    let first = 20_000 + (std::process::id() % 10_000) as u16;
    loop {
        let port = first + TRIED.fetch_add(1, Ordering::SeqCst);
        if TcpListener::bind(("0.0.0.0", port)).is_ok() {
            return port;
        }
    }
}

/// The round stored on the disk.
fn kept(folder: &Path) -> ClassRound {
    let bytes = fs::read(folder.join("classes/class-1.toml")).unwrap();
    ClassRound::read("kept", &bytes, &Arc::default()).unwrap()
}

/// The code of the class.
const DOOR: &str = "BCDFGH";

/// Stores a stopped round with this code and one pupil, who does not come back. A host offers to
/// continue this round, so the tests know the code of the class.
fn stop_a_round(folder: &Path, code: &str) {
    let mut round = ClassRound::with_devices(Code::parse(code).unwrap()).of_class("10b");
    round.open(DOOR.parse().unwrap(), None);
    let (seat, name) = (SeatToken::of(1), "Not here".to_owned());
    round
        .change(&ClassChange::Join {
            seat: Some(seat),
            name,
        })
        .unwrap();
    fs::create_dir_all(folder.join("classes")).unwrap();
    fs::write(folder.join("classes/class-1.toml"), round.text().unwrap()).unwrap();
}

/// A host in a terminal that continues the stopped round. Without a given port, the host uses the
/// round's earlier port.
fn host(folder: &Path, port: Option<u16>) -> Pty {
    let port = port.map(|port| port.to_string());
    let mut arguments = vec!["class", "--host", "--data-dir", folder.to_str().unwrap()];
    if let Some(port) = &port {
        arguments.extend(["--port", port]);
    }
    let page = named_page();
    if let Some(page) = &page {
        arguments.extend(["--page", page.trim_start_matches("file://")]);
    }
    let mut pty = Pty::start(carrom(&arguments));
    pty.wait_for("10b stopped at question");
    pty.press("\r");
    pty.wait_for("the code of this class");
    pty
}

/// What a device reports: how long something took, or which step it shows.
#[derive(Debug)]
enum Report {
    Joined(Duration),
    Acknowledged(Duration),
    /// The number of the question, the step, and the time at which the device first showed it.
    Shows(u64, String, Instant),
}

/// A random vote that fits the question.
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

/// A well-behaved device, which votes after a moment whenever it can, and reports how long
/// everything took.
fn good(port: u16, number: u8, spread: Duration, reports: &Sender<Report>) {
    let mut chance = Pcg64::seed_from_u64(number.into());
    let start = Instant::now();
    let name = format!("Pupil {number}");
    let mut pupil = Pupil::join_from(number + 10, port, DOOR, &name, None).unwrap();
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

/// A device that joins and then reads only one byte now and then, or nothing at all.
fn slow(port: u16, name: &str, reads: bool, over: &AtomicBool) {
    let Ok(mut pupil) = Pupil::join_from(2, port, DOOR, name, None) else {
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

/// The address of the hostile devices, for [`connect_from`].
const HOSTILE: u8 = 3;

fn hostile(port: u16, kind: usize, over: &AtomicBool) {
    let mut held = Vec::new();
    while !over.load(Ordering::SeqCst) {
        let Ok(mut stream) = connect_from(HOSTILE, port) else {
            thread::sleep(Duration::from_millis(10));
            continue;
        };
        let _ = match kind {
            // Large frames.
            0 => Pupil::dial(port).and_then(|mut it| it.say(&"x".repeat(10_000_000))),
            // Connections that send nothing and stay open.
            1 => {
                held.push(stream);
                held.drain(..held.len().saturating_sub(200));
                Ok(())
            }
            // Random bytes.
            2 => stream.write_all(&[0xa5; 4096]),
            // Request heads that never end.
            3 => stream
                .write_all(b"GET / HTTP/1.1\r\nX: y")
                .map(|()| held.push(stream)),
            // Wrong codes.
            _ => Pupil::join_from(HOSTILE, port, "BCDFGJ", "x", None).map(drop),
        };
        held.drain(..held.len().saturating_sub(200));
        thread::sleep(Duration::from_millis(5));
    }
}

/// The processor time of a process in seconds, and its largest memory use in megabytes.
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

/// A device with a screen, and the times until it showed votes and steps.
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

/// Plays a round of this many questions with `devices` well-behaved devices, whose votes are spread
/// over the time `spread`, and with misbehaving ones if `bad`; prints the measured times.
fn play(questions: usize, devices: u8, spread: Duration, bad: bool) {
    let folder = Folder::new("crowd");
    let port = free_port();
    stop_a_round(folder.path(), &format!("mixed{questions}-7"));
    let mut pty = host(folder.path(), Some(port));
    let (reports, heard) = mpsc::channel();
    let over = Arc::new(AtomicBool::new(false));
    let mut others = Vec::new();
    if bad {
        for i in 0..21 {
            let over = Arc::clone(&over);
            others.push(thread::spawn(move || {
                slow(port, &format!("Slow {i}"), i < 20, &over);
            }));
        }
        for kind in 0..5 {
            let over = Arc::clone(&over);
            others.push(thread::spawn(move || hostile(port, kind, &over)));
        }
    }
    let address = format!("127.0.0.1:{port}");
    let joins = ["join", &address, "--code", DOOR, "--player", "Terminal"];
    let mut terminal = Pty::start(carrom(&joins));
    terminal.wait_for("Join the class");
    terminal.press("\r");
    terminal.wait_for("You are in, Terminal.");
    let mut seen_devices = vec![SeenTimes::new("terminal", terminal)];
    if named_page().is_some() {
        let browser = seen_devices::browser(port, DOOR, "Browser");
        seen_devices.push(SeenTimes::new("browser", browser));
    }
    let pupils: Vec<_> = (0..devices)
        .map(|number| {
            let reports = reports.clone();
            let work = move || good(port, number, spread, &reports);
            let builder = thread::Builder::new().stack_size(256 * 1024);
            builder.spawn(work).unwrap()
        })
        .collect();
    drop(reports);
    let mut joined = Vec::new();
    while joined.len() < usize::from(devices) {
        if let Report::Joined(took) = heard.recv_timeout(Duration::from_secs(30)).unwrap() {
            joined.push(took);
        }
    }
    let mut seen = Vec::new();
    let mut acknowledged = Vec::new();
    let start = Instant::now();
    // After the waiting room, each question has six steps on devices, most of them with a text that
    // the devices then show. The last two steps have none, because the devices show the right
    // answer, which differs from question to question.
    let steps = [
        ("describe", "Read it with the class"),
        ("first-vote", "Enter: next, "),
        ("talk", "Talk: find someone"),
        ("second-vote", "Your first vote counts"),
        ("shot", ""),
        ("scores", ""),
    ];
    for question in 0..questions as u64 {
        for (step, words) in steps {
            let pressed = Instant::now();
            pty.press(if step == "scores" { "\x1b[F\r" } else { "\r" });
            let votes = step.ends_with("vote");
            for it in seen_devices.iter_mut().filter(|_| !words.is_empty()) {
                it.device.wait_for(words);
                it.steps.push(pressed.elapsed());
            }
            let mut waits = usize::from(devices) * (1 + usize::from(votes));
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
        ", 20 slow, 1 that reads nothing, 5 hostile"
    } else {
        ""
    };
    println!("\n{devices} devices{all}: {questions} questions, two votes each");
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
    // No acknowledged vote is lost.
    let round = kept(folder.path());
    let votes = |question| [Vote::First, Vote::Second].map(|it| round.voted(question, it));
    for question in 0..questions {
        assert_eq!(
            votes(question),
            [usize::from(devices) + seen_devices.len(); 2],
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
#[ignore = "measures times; takes some minutes"]
fn two_hundred_devices_vote() {
    play(10, 198, Duration::from_secs(1), false);
}

#[test]
#[ignore = "measures times; takes some minutes"]
fn two_hundred_devices_vote_alongside_slow_and_hostile_ones() {
    play(10, 198, Duration::from_secs(1), true);
}

/// The crowd is small and the round is short, so that this test can run with every change.
pub(crate) fn a_few_devices_vote_alongside_slow_and_hostile_ones() {
    play(3, 12, Duration::from_millis(300), true);
}

/// The number of devices that are voting when their host is killed.
const VOTERS: usize = 12;
/// A vote's number is sent as an angle of that many thousandths of a degree, because angles are
/// limited.
const COUNTS_PER_DEGREE: f64 = 1000.0;

/// The acknowledged votes: the last number of each device for each question and vote.
type Acknowledged = Arc<Mutex<BTreeMap<(usize, &'static str, usize), u32>>>;

/// A device that votes again and again. If it loses its host, it reconnects by itself, gets its own
/// seat again, and reports that.
fn voter(port: u16, number: usize, known: &Acknowledged, back: &Sender<usize>, over: &AtomicBool) {
    let mut chance = Pcg64::seed_from_u64(number as u64);
    let name = format!("Pupil {number}");
    let mut seat: Option<String> = None;
    let mut count = 0;
    while !over.load(Ordering::SeqCst) {
        let joined = Pupil::join_from(number as u8 + 10, port, DOOR, &name, seat.as_deref());
        let Ok(mut pupil) = joined else {
            thread::sleep(Duration::from_millis(20));
            continue;
        };
        assert_eq!(pupil.text("name"), name);
        let own = pupil.text("seat");
        assert_eq!(*seat.get_or_insert_with(|| own.clone()), own);
        let _ = back.send(number);
        loop {
            let question = pupil.state["q"].as_u64().unwrap() as usize;
            let (vote, field) = match pupil.text("step").as_str() {
                "first-vote" => ("first", "first"),
                "second-vote" => ("second", "second"),
                _ => match pupil.hear() {
                    Ok(()) => continue,
                    Err(_) => break,
                },
            };
            // Each vote has a larger number than all earlier ones, so that the test notices an
            // older vote.
            count += 1;
            let angle = f64::from(count) / COUNTS_PER_DEGREE;
            if pupil.vote(&format!("rays 1 {angle}")).is_err() {
                break;
            }
            let is_same = pupil.state["q"].as_u64() == Some(question as u64);
            if is_same && number_in(&pupil.text(field)) == Some(count) {
                known
                    .lock()
                    .unwrap()
                    .insert((question, vote, number), count);
            }
            thread::sleep(Duration::from_millis(chance.random_range(0..5)));
        }
    }
}

fn number_in(said: &str) -> Option<u32> {
    let angle: f64 = said.rsplit_once(' ')?.1.parse().ok()?;
    Some((COUNTS_PER_DEGREE * angle).round() as u32)
}

/// Continues from this step to the next vote, if there is one; returns the number of the question,
/// and the title of the vote on devices.
fn to_the_next_vote(
    pty: &mut Pty,
    from: ClassPlace,
    questions: usize,
) -> Option<(usize, &'static str)> {
    let here = from.question + 1;
    let (keys, question, shows, title) = match from.step {
        ClassStep::Describe => ("\r", here, "have voted", "- your vote -"),
        ClassStep::FirstVote => ("\r\r", here, "have voted again", "- your second vote -"),
        _ if here == questions => return None,
        // The keys skip the shot, the scores and the description of the next question.
        _ => ("\r\x1b[F\r\r\r", here + 1, "have voted", "- your vote -"),
    };
    pty.press(keys);
    pty.wait_until("the vote", |screen| {
        screen.contains(&format!("question {question} of")) && screen.contains(shows)
    });
    Some((question, title))
}

/// The host is killed `CARROM_KILLS` times during a round, and restarted each time as in
/// docs/class.md: `carrom class --host`, Enter. The host still has every acknowledged vote, and all
/// devices reconnect by themselves, including a `carrom join`.
pub(crate) fn a_host_that_is_killed_during_a_round_loses_no_vote() {
    let kills = std::env::var("CARROM_KILLS").ok();
    let kills: usize = kills.and_then(|it| it.parse().ok()).unwrap_or(6);
    let questions = kills.div_ceil(3) + 1;
    let folder = Folder::new("host-killed");
    let port = free_port();
    stop_a_round(folder.path(), &format!("from-angle{questions}-7"));
    let mut chance = Pcg64::seed_from_u64(5);
    let (known, over) = (Acknowledged::default(), Arc::new(AtomicBool::new(false)));
    let (reports, heard) = mpsc::channel();
    let voters: Vec<_> = (0..VOTERS)
        .map(|number| {
            let (known, over) = (Arc::clone(&known), Arc::clone(&over));
            let reports = reports.clone();
            thread::spawn(move || voter(port, number, &known, &reports, &over))
        })
        .collect();
    let address = format!("127.0.0.1:{port}");
    let joins = ["join", &address, "--code", DOOR, "--player", "Terminal"];
    let mut terminal = Pty::start(carrom(&joins));
    terminal.wait_for("Join the class");
    terminal.press("\r");
    let mut back = Vec::new();
    let (mut votes, mut has_voted) = (0, false);
    let mut steps = BTreeSet::new();
    for kill in 0..=kills {
        // The port has to be given only the first time.
        let start = Instant::now();
        let mut pty = host(folder.path(), (kill == 0).then_some(port));
        // All devices reconnect.
        let mut away: BTreeSet<usize> = (0..VOTERS).collect();
        while !away.is_empty() {
            away.remove(&heard.recv_timeout(Duration::from_secs(120)).unwrap());
        }
        terminal.wait_for("You are in, Terminal.");
        terminal.wait_until("the host", |screen| !screen.contains("out of reach"));
        back.push(start.elapsed());
        let round = kept(folder.path());
        assert_eq!(
            round.teams().len(),
            VOTERS + 2,
            "no device got a second seat"
        );
        assert_eq!(round.dropped_votes(), 0);
        let place = round.place();
        steps.insert((place.question, place.step as usize));
        // The vote on the disk is the last acknowledged vote, or a later vote that was being sent.
        for (&(question, vote, number), last) in &*known.lock().unwrap() {
            let name = format!("Pupil {number}");
            let person = round.teams().iter().position(|it| *it == name).unwrap();
            let said = round.ballot(question, person).vote(vote.parse().unwrap());
            let said = said.and_then(|said| number_in(&said.to_text()));
            assert!(
                said >= Some(*last),
                "kill {kill}: vote {last} of {name} was acknowledged, {said:?} is stored"
            );
            votes += 1;
        }
        if kill == kills {
            over.store(true, Ordering::SeqCst);
            pty.signal(Signal::KILL);
            pty.wait();
            break;
        }
        // Continue the round at the same step.
        pty.press("\r");
        if has_voted {
            terminal.wait_for("Your vote is in.");
        }
        let goes_on = place.step.vote().is_none() || chance.random_bool(0.6);
        if goes_on && let Some((question, title)) = to_the_next_vote(&mut pty, place, questions) {
            terminal.wait_until("the vote", |screen| {
                screen.contains(&format!("question {question} of")) && screen.contains(title)
            });
            terminal.vote();
            has_voted = true;
        }
        thread::sleep(Duration::from_millis(chance.random_range(20..300)));
        pty.signal(Signal::KILL);
        pty.wait();
        if kill % 4 == 1 {
            // The teacher may need time to find the command; meanwhile the devices cannot
            // reconnect.
            terminal.wait_for("out of reach");
            thread::sleep(Duration::from_secs(1));
        }
    }
    terminal.wait_for("out of reach");
    for voter in voters {
        voter.join().unwrap();
    }
    let slowest = back.iter().max().unwrap();
    println!(
        "{kills} kills at {} steps, {votes} votes checked, none lost; from the start of the \
         program until all were back {slowest:?} at most",
        steps.len()
    );
}

//! A class whose pupils use their own devices, over real connections: the teacher's app without a
//! terminal, the server, and good, slow, faulty and hostile devices.

use std::fs;
use std::io::{ErrorKind, Read, Write};
use std::net::{Ipv4Addr, SocketAddrV4};
use std::path::PathBuf;
use std::thread;
use std::time::{Duration, Instant};

use carrom::class::Vote;
use carrom::gradebook::HandIn;
use carrom::messages::{HostCall, HostNews};
use carrom::quiz::Figures;
use carrom::shells::host::{Host, HostOptions};
use serde_json::{Value, json};
use tungstenite::Message;

use crate::folder::Folder;
use crate::handed_in::hand_in;
use crate::pupil::{Pupil, answer, connect};
use crate::teacher::{Teacher, kept};

/// The page that is served in these tests.
const STUB: &str = "<html lang=\"en\"><meta http-equiv=\"Content-Security-Policy\" \
                    content=\"default-src 'none'; connect-src 'none'\">a page</html>";

fn start(folder: &Folder) -> Teacher {
    Teacher::start(folder, STUB)
}

impl Teacher {
    fn join(&self, name: &str) -> Pupil {
        Pupil::join(self.port, &self.code, name, None).unwrap()
    }
}

#[test]
fn a_vote_is_on_the_disk_before_it_is_confirmed() {
    let folder = Folder::new("hosted-votes");
    let teacher = start(&folder);
    let mut pupils: Vec<_> = (0..20)
        .map(|i| teacher.join(&format!("Pupil {i}")))
        .collect();
    for angle in [10, 20, 30] {
        for (i, pupil) in pupils.iter_mut().enumerate() {
            pupil.vote(&format!("sure rays {angle} {i}")).unwrap();
            let said = kept(&folder)
                .ballot(0, i)
                .vote(Vote::First)
                .unwrap()
                .to_text();
            assert!(said.starts_with("rays "), "{said}");
            let rays = kept(&folder)
                .ballot(0, i)
                .vote(Vote::First)
                .unwrap()
                .rays()
                .unwrap();
            assert!((rays.striker.unwrap().to_degrees() - f64::from(angle)).abs() < 1e-9);
            assert_eq!(pupil.text("first"), format!("sure {said}"));
        }
    }
    teacher.wait_for("20 of 20 have voted");
    // One pupil withdraws a vote.
    pupils[3].vote("").unwrap();
    assert_eq!(
        (
            pupils[3].text("first").as_str(),
            kept(&folder).voted(0, Vote::First)
        ),
        ("", 19)
    );
    // Text that is not a vote on this question changes nothing.
    for said in ["choice 1", "rays 1 2 3", "x", "number 3"] {
        pupils[4].vote(said).unwrap();
        assert!(pupils[4].text("first").contains("rays "), "{said}");
    }
    assert_eq!(kept(&folder).voted(0, Vote::First), 19);
}

/// A vote like this once crashed the host at the next step, and again whenever the round was
/// continued.
#[test]
fn a_vote_for_a_missing_choice_does_not_crash_the_host() {
    let folder = Folder::new("hosted-misfit");
    let teacher = Teacher::with_round(&folder, STUB, "concept-1");
    teacher.press("<Enter><Enter>", "have voted");
    let [mut ada, mut bo] = ["Ada", "Bo"].map(|name| teacher.join(name));
    ada.vote("choice 1").unwrap();
    for said in [
        "choice 99",
        "sure choice 18446744073709551615",
        "number 1",
        "choice",
    ] {
        bo.vote(said).unwrap();
        assert_eq!(bo.state["misfit"], true, "{said}");
        assert_eq!(bo.text("first"), "", "{said}");
    }
    teacher.press("<Enter>", "Talk");
    bo.hear_until(|state| state["step"] == "talk").unwrap();
    assert_eq!(bo.state["spread"][0], 1);
    assert_eq!(bo.state.get("misfit"), None);
    // Only valid votes are on the disk.
    let text = fs::read_to_string(folder.path().join("classes/class-1.toml")).unwrap();
    assert!(
        text.contains("choice 1") && !text.contains("choice 9"),
        "{text}"
    );
    assert!(!text.contains("number 1"), "{text}");
    assert_eq!(kept(&folder).voted(0, Vote::First), 1);
    // A valid vote is accepted as before.
    teacher.press("<Enter>", "have voted again");
    bo.hear_until(|state| state["step"] == "second-vote")
        .unwrap();
    bo.vote("choice 99").unwrap();
    bo.vote("choice 2").unwrap();
    assert_eq!(
        (bo.text("second").as_str(), bo.state.get("misfit")),
        ("choice 2", None)
    );
}

/// A round was once resumed at the first free port from 8090 on, where its devices did not find it.
pub(crate) fn a_round_is_resumed_at_the_port_where_its_devices_look_for_it() {
    let free = || std::net::TcpListener::bind("0.0.0.0:0").unwrap();
    let port_of = |listener: &std::net::TcpListener| listener.local_addr().unwrap().port();
    let opened = |port: Option<u16>, before: u16| {
        let mut host = Host::new(HostOptions { port, page: None }, || ());
        host.call(&HostCall::Open {
            code: Some("BCDFGH".parse().unwrap()),
            address: Some(SocketAddrV4::new(Ipv4Addr::LOCALHOST, before)),
        });
        let HostNews::Opened(Ok(door)) = host.take_news().remove(0) else {
            panic!("the server is not open");
        };
        assert_eq!(door.code.to_string(), "BCDFGH");
        let ports: Vec<u16> = door.addresses.iter().map(|it| it.port()).collect();
        assert!(connect(ports[0]).is_ok());
        ports[0]
    };
    let before = port_of(&free());
    // Open the round twice, as after a crash.
    assert_eq!([opened(None, before), opened(None, before)], [before; 2]);
    // Another program uses the port now.
    let taken = free();
    assert_ne!(opened(None, port_of(&taken)), port_of(&taken));
    // The port that the teacher requests has priority.
    let wanted = port_of(&free());
    assert_eq!(opened(Some(wanted), before), wanted);
}

#[test]
fn a_returning_pupil_gets_the_same_seat() {
    let folder = Folder::new("hosted-back");
    let teacher = start(&folder);
    let mut ada = teacher.join("Ada");
    ada.vote("rays 60 30").unwrap();
    let seat = ada.text("seat");
    drop(ada);
    let back = Pupil::join(teacher.port, &teacher.code, "whoever", Some(&seat)).unwrap();
    assert_eq!(
        (back.text("name").as_str(), back.state["n"].as_u64()),
        ("Ada", Some(1))
    );
    assert!(back.text("first").starts_with("rays "));
    // A second tab replaces the first one.
    let mut first = back;
    let second = Pupil::join(teacher.port, &teacher.code, "Ada", Some(&seat)).unwrap();
    assert_eq!(second.text("name"), "Ada");
    first.hear().unwrap();
    assert_eq!(first.why(), Some("elsewhere"));
    // Ada's name does not give access to her seat, and neither does an invented token.
    let thief = teacher.join("ADA");
    assert_eq!(
        (thief.text("name").as_str(), thief.text("first").as_str()),
        ("ADA 2", "")
    );
    let forged = Pupil::join(teacher.port, &teacher.code, "Ada", Some(&"0".repeat(32))).unwrap();
    assert_eq!(forged.text("name"), "Ada 3");
}

pub(crate) fn nobody_gets_in_without_the_code() {
    let folder = Folder::new("hosted-code");
    let teacher = start(&folder);
    let codes = (0..20).map(|i| carrom::class::JoinCode::of(i).to_string());
    let typed = ["", "BCDFG", "😀😀😀😀😀😀", "' OR 1=1"].map(str::to_owned);
    // The codes are tried at the same time, because the reply to a wrong code is delayed.
    let tries: Vec<_> = codes
        .chain(typed)
        .map(|code| {
            let port = teacher.port;
            thread::spawn(move || {
                let start = Instant::now();
                let pupil = Pupil::join(port, &code, "x", None).unwrap();
                (pupil.why().map(str::to_owned), start.elapsed())
            })
        })
        .collect();
    for guess in tries {
        let (why, took) = guess.join().unwrap();
        assert_eq!(why.as_deref(), Some("code"));
        // At this rate, guessing the six letters takes years.
        assert!(took >= Duration::from_secs(1));
    }
    // The code as people type it.
    let code = teacher.code.to_lowercase();
    let spaced = format!(" {} {}", &code[..3], &code[3..]);
    let pupil = Pupil::join(teacher.port, &spaced, "Ada", None).unwrap();
    assert_eq!(pupil.text("name"), "Ada");
}

/// One device guesses codes over many new connections at once; the host once checked 1,277 codes a
/// second. Meanwhile another device can mistype the code and still join, and a device that has
/// joined from the guesser's address can return.
#[cfg(target_os = "linux")]
pub(crate) fn guessing_codes_is_slow_over_any_number_of_connections() {
    let folder = Folder::new("hosted-guesses");
    let teacher = start(&folder);
    let ada = teacher.join("Ada");
    let seat = ada.text("seat");
    drop(ada);
    let guess = |device: u8, code: &str| {
        let pupil = Pupil::join_from(device, teacher.port, code, "x", None).unwrap();
        pupil.why().map(str::to_owned)
    };
    let heard: Vec<Option<String>> = thread::scope(|scope| {
        let guesses: Vec<_> = (0..120)
            .map(|number| {
                let code = carrom::class::JoinCode::of(number).to_string();
                scope.spawn(move || guess(1, &code))
            })
            .collect();
        guesses.into_iter().map(|it| it.join().unwrap()).collect()
    });
    let said = |why: &str| heard.iter().filter(|it| it.as_deref() == Some(why)).count();
    // Sixty codes are checked at once, and one more every ten seconds.
    assert!((60..=63).contains(&said("code")), "{heard:?}");
    assert_eq!(said("code") + said("later"), 120);
    assert_eq!(guess(1, &teacher.code).as_deref(), Some("later"));
    let back = Pupil::join(teacher.port, &teacher.code, "Ada", Some(&seat)).unwrap();
    assert_eq!(back.text("name"), "Ada");
    assert_eq!(guess(2, "BCDFGH").as_deref(), Some("code"));
    assert_eq!(guess(2, &teacher.code), None);
}

/// One address once took 246 seats in 0.6 s, and a real pupil was refused because the class was
/// full.
#[cfg(target_os = "linux")]
#[test]
fn one_device_cannot_fill_the_class() {
    let folder = Folder::new("hosted-full");
    let teacher = start(&folder);
    let mut seats = Vec::new();
    let start = Instant::now();
    for number in 0..246 {
        let pupil = teacher.join(&format!("Nobody {number}"));
        match pupil.why() {
            None => seats.push(pupil.text("seat")),
            Some(why) => assert_eq!(why, "later"),
        }
    }
    // Sixty seats are given at once, and one more every two seconds.
    let most = 61 + start.elapsed().as_secs() as usize / 2;
    assert!((60..=most).contains(&seats.len()), "{}", seats.len());
    let newcomer = Pupil::join_from(2, teacher.port, &teacher.code, "Ada", None).unwrap();
    assert_eq!(newcomer.text("name"), "Ada");
    // A returning device takes no new seat.
    for (number, seat) in seats.iter().enumerate().take(20) {
        let back = Pupil::join(teacher.port, &teacher.code, "x", Some(seat)).unwrap();
        assert_eq!(back.text("name"), format!("Nobody {number}"));
    }
    teacher.wait_for("have voted");
}

#[test]
fn names_with_any_characters_stay_names() {
    let folder = Folder::new("hosted-names");
    let teacher = start(&folder);
    for (name, shown) in [
        ("<script>alert(1)</script>", "<script>alert(1)</script"),
        ("=1+1", "=1+1"),
        ("\u{202e}evil\u{202c}\u{7}", "evil"),
        ("Zoë 球 👩‍👩‍👧", "Zoë 球 👩👩👧"),
        ("  a\n\tb  ", "a b"),
        ("\u{1b}[31mred", "[31mred"),
    ] {
        assert_eq!(teacher.join(name).text("name"), shown);
    }
    for name in [
        "",
        "   ",
        "\u{200b}\u{200d}",
        "\u{0}\u{1}",
        "\u{2800}",
        "\u{3164}\u{3164}",
        "\u{115f}\u{1160} \u{ffa0}",
        "\u{180e}\u{fe0f}\u{200d}",
    ] {
        assert_eq!(teacher.join(name).why(), Some("name"), "{name:?}");
    }
    assert_eq!(teacher.join(&"x".repeat(10_000)).why(), Some("format"));
    assert_eq!(teacher.join(&"x".repeat(500)).text("name"), "x".repeat(24));
    // In a table a name is plain text and not a formula; in the file it is unchanged.
    let round = kept(&folder);
    let table = carrom::class::answers_csv(&round, "").unwrap();
    assert!(
        !table.contains(",=1+1") && table.contains("=1+1"),
        "{table}"
    );
    assert_eq!(round.teams().len(), 7);
}

#[test]
fn an_invalid_message_ends_the_connection() {
    let folder = Folder::new("hosted-format");
    let teacher = start(&folder);
    let said = |messages: &[Message]| {
        let mut pupil = Pupil::dial(teacher.port).unwrap();
        for message in messages {
            let _ = pupil.socket.send(message.clone());
        }
        let heard = pupil.hear();
        heard
            .map(|()| pupil.why().map(str::to_owned))
            .ok()
            .flatten()
    };
    let vote = r#"{"t":"vote","q":0,"vote":"first","said":"rays 1 2","n":1}"#;
    assert_eq!(said(&[Message::text(vote)]).as_deref(), Some("join"));
    let old = format!(
        r#"{{"t":"join","v":7,"code":"{}","name":"a"}}"#,
        teacher.code
    );
    assert_eq!(said(&[Message::text(old)]).as_deref(), Some("version"));
    for bad in [
        Message::text("{}"),
        Message::text("[".repeat(900)),
        Message::binary(vec![0; 10]),
        Message::text("x".repeat(1025)),
        Message::text("x".repeat(10_000_000)),
    ] {
        let why = said(std::slice::from_ref(&bad));
        assert!(matches!(why.as_deref(), Some("format") | None), "{why:?}");
    }
    // Random bytes, and an incomplete request head.
    for bytes in [
        &b"\xff\xfe\x00\x01\r\n\r\n"[..],
        &[7; 9000],
        b"GET /class HTT",
    ] {
        let mut stream = connect(teacher.port).unwrap();
        let _ = stream.write_all(bytes);
        let _ = stream.shutdown(std::net::Shutdown::Write);
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        assert!(!answer.starts_with(b"HTTP/1.1 1"));
    }
    let mut ada = teacher.join("Ada");
    ada.vote("rays 1 2").unwrap();
}

#[test]
fn only_the_served_page_can_connect_to_the_class() {
    let folder = Folder::new("hosted-origin");
    let teacher = start(&folder);
    let request = |path: &str, host: &str, more: &str| {
        let request = format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n{more}\r\n");
        answer(teacher.port, request.as_bytes())
    };
    let own = format!("127.0.0.1:{}", teacher.port);
    let page = request("/", &own, "");
    assert!(
        page.starts_with("HTTP/1.1 200 ") && page.contains("a page"),
        "{page}"
    );
    assert!(
        page.contains("connect-src 'self'") && !page.contains("connect-src 'none'"),
        "{page}"
    );
    let upgrade = "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n\
                   Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
    for (host, origin, status) in [
        ("evil.example", "", "403"),
        (own.as_str(), "Origin: http://evil.example\r\n", "403"),
        (own.as_str(), "Origin: null\r\n", "403"),
    ] {
        let refused = request("/class", host, &format!("{upgrade}{origin}"));
        assert!(
            refused.starts_with(&format!("HTTP/1.1 {status} ")),
            "{refused}"
        );
    }
    assert!(request("/", "evil.example", "").starts_with("HTTP/1.1 403 "));
    assert!(request("/class-1.toml", &own, "").starts_with("HTTP/1.1 404 "));
}

#[test]
fn pupils_can_join_alongside_a_thousand_connections() {
    let folder = Folder::new("hosted-thousand");
    let teacher = start(&folder);
    let mut early = teacher.join("Early");
    let mut idle = Vec::new();
    for _ in 0..1000 {
        match connect(teacher.port) {
            Ok(stream) => idle.push(stream),
            Err(error) => assert!(
                matches!(
                    error.kind(),
                    ErrorKind::ConnectionReset | ErrorKind::ConnectionRefused
                ),
                "{error}"
            ),
        }
    }
    let start = Instant::now();
    let mut late = teacher.join("Late");
    assert_eq!(late.text("name"), "Late");
    late.vote("rays 1 2").unwrap();
    early.vote("rays 3 4").unwrap();
    assert!(start.elapsed() < Duration::from_secs(10));
    teacher.wait_for("2 of 2 have voted");
}

#[test]
fn removed_pupils_and_refused_newcomers_see_the_reason() {
    let folder = Folder::new("hosted-door");
    let teacher = start(&folder);
    let mut ada = teacher.join("Ada");
    let mut bo = teacher.join("Bo");
    bo.vote("rays 1 2").unwrap();
    teacher.press("w", "no vote yet");
    // Pupils who have not voted are listed first.
    teacher.press("x", "Remove Ada");
    teacher.press("y", "1 in, 1 on the list");
    ada.hear().unwrap();
    assert_eq!(ada.why(), Some("kicked"));
    teacher.press("c", "The round is closed");
    assert_eq!(teacher.join("Cy").why(), Some("closed"));
    let seat = bo.text("seat");
    let bo = Pupil::join(teacher.port, &teacher.code, "Bo", Some(&seat)).unwrap();
    assert!(
        bo.text("first").starts_with("rays "),
        "a pupil who had joined can return"
    );
    teacher.press("c", "1 in");
    // Newcomers can join as soon as the round is open again.
    let mut stranger = teacher.join("Bob");
    while stranger.why() == Some("closed") {
        stranger = teacher.join("Bob");
    }
    stranger.vote("rays 5 6").unwrap();
    assert_eq!(kept(&folder).teams(), ["Bo", "Bob"]);
}

/// The files that were handed in, by name.
fn handed_in(folder: &Folder) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder.path().join("handed-in"));
    let paths = entries.into_iter().flatten().map(|it| it.unwrap().path());
    let mut files: Vec<_> = paths
        .filter(|path| path.extension().is_some_and(|it| it == "json"))
        .collect();
    files.sort();
    files
}

pub(crate) fn a_hand_in_is_on_the_disk_before_it_is_confirmed() {
    let folder = Folder::new("hosted-hand-in");
    let teacher = start(&folder);
    let mut ada = teacher.join("Ada");
    // The name in the file does not matter.
    let mut half = hand_in(1, "Bo", 10, 4);
    "9a".clone_into(&mut half.class);
    half.attempts.truncate(5);
    assert_eq!(
        ada.hand_in(&half.value().unwrap()).unwrap(),
        json!({"Ok": 5})
    );
    let files = handed_in(&folder);
    let first = fs::read(&files[0]).unwrap();
    let read = HandIn::read(&first).unwrap();
    assert_eq!((read.name.as_str(), read.class.as_str()), ("Ada", "10b"));
    let answers = |it: &HandIn| it.attempts.iter().map(|it| it.answer.clone()).collect();
    let [kept, sent]: [Vec<Figures>; 2] = [&read, &half].map(answers);
    assert_eq!(kept, sent);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = fs::metadata(&files[0]).unwrap().permissions().mode();
        assert_eq!(mode & 0o777, 0o600, "only the teacher can read it");
    }
    // Sending the same hand-in again creates no second file. A hand-in with more answers creates
    // another file, and the first file stays unchanged.
    ada.hand_in(&half.value().unwrap()).unwrap();
    assert_eq!(handed_in(&folder).len(), 1);
    let whole = hand_in(1, "Ada", 10, 4).value().unwrap();
    assert_eq!(ada.hand_in(&whole).unwrap(), json!({"Ok": 10}));
    assert_eq!(handed_in(&folder).len(), 2);
    assert_eq!(fs::read(&files[0]).unwrap(), first);
    // A returning pupil sees that the hand-in was accepted.
    let seat = ada.text("seat");
    let back = Pupil::join(teacher.port, &teacher.code, "Ada", Some(&seat)).unwrap();
    assert_eq!(back.state["handed"], json!({"n": 3, "kept": {"Ok": 10}}));
    teacher.press("w", "1 handed in");
    teacher.wait_for("no vote yet, handed in");
    teacher.wait_for("carrom gather");
}

#[test]
fn an_invalid_hand_in_is_not_stored() {
    let folder = Folder::new("hosted-no-hand-in");
    let teacher = start(&folder);
    let mut bo = teacher.join("../../Bo");
    let good = hand_in(1, "Bo", 3, 1).value().unwrap();
    let with = |change: &dyn Fn(&mut Value)| {
        let mut file = good.clone();
        change(&mut file);
        file
    };
    for bad in [
        json!([]),
        json!("x".repeat(900_000)),
        with(&|it| it["format"] = json!(9)),
        with(&|it| it["answers"][1]["credit"] = json!(1e9)),
        with(&|it| it["answers"] = json!([])),
    ] {
        // Each hand-in comes from a device of its own, because a device has to wait between
        // hand-ins.
        let mut pupil = teacher.join("Al");
        assert_eq!(pupil.hand_in(&bad).unwrap(), json!({"Err": "format"}));
    }
    assert_eq!(handed_in(&folder), Vec::<PathBuf>::new());
    // A hand-in that is too large, or that is sent before joining, ends only its own connection.
    let said = |mut pupil: Pupil, file: &Value| {
        let saying = json!({"t": "hand-in", "n": 1, "file": file});
        let _ = pupil.say(&saying.to_string());
        let heard = pupil.hear_until(|state| state["t"] == "no");
        heard.ok().map(|()| pupil.why().unwrap().to_owned())
    };
    let huge = json!("x".repeat(1 << 20));
    let other = json!({});
    let stranger = || Pupil::dial(teacher.port).unwrap();
    // The host waits until each device has read its reply.
    let replies = thread::scope(|scope| {
        let senders = [
            (teacher.join("Cy"), &huge),
            (stranger(), &good),
            (stranger(), &other),
        ];
        senders
            .map(|(pupil, file)| scope.spawn(move || said(pupil, file)))
            .map(|sender| sender.join().unwrap())
    });
    for why in &replies[..2] {
        assert!(matches!(why.as_deref(), Some("format") | None), "{why:?}");
    }
    assert_eq!(replies[2].as_deref(), Some("join"));
    assert_eq!(bo.hand_in(&good).unwrap(), json!({"Ok": 3}));
    let files = handed_in(&folder);
    assert_eq!(files[0].file_name().unwrap(), "hand-in-bo-1.json");
    assert_eq!(files.len(), 1);
}

#[test]
fn with_nicknames_no_typed_name_is_kept_and_a_device_returns_to_its_nickname() {
    let folder = Folder::new("hosted-nicknames");
    let teacher = Teacher::hosting(&folder, STUB, "from-angle2-7", true);
    teacher.wait_for("carrom gives everyone a nickname");
    let names = ["Ada", "Ada", "", "\u{200b}"];
    let pupils: Vec<_> = names.iter().map(|name| teacher.join(name)).collect();
    let nicknames: Vec<_> = pupils.iter().map(|it| it.text("name")).collect();
    for (i, name) in nicknames.iter().enumerate() {
        assert_eq!(name.split(' ').count(), 2, "{name}");
        assert!(!nicknames[..i].contains(name), "{nicknames:?}");
    }
    // A returning device is recognized by its seat, whatever its name is now.
    let seat = pupils[0].text("seat");
    let again = Pupil::join(teacher.port, &teacher.code, "Eve", Some(&seat)).unwrap();
    assert_eq!(again.text("name"), nicknames[0]);
    drop((pupils, again, teacher));
    let path = folder.path().join("classes/class-1.toml");
    let text = fs::read_to_string(path).unwrap();
    assert!(!text.contains("Ada") && !text.contains("Eve"), "{text}");
    assert!(kept(&folder).gives_nicknames());

    // In the next round the device asks for the nickname that it remembers.
    let next = Folder::new("hosted-nicknames-next");
    let teacher = Teacher::hosting(&next, STUB, "from-angle2-8", true);
    assert_eq!(teacher.join(&nicknames[1]).text("name"), nicknames[1]);
    assert_ne!(teacher.join(&nicknames[1]).text("name"), nicknames[1]);
}

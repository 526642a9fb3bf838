//! carrom is killed at random moments. A game loses at most the stroke that is in motion, and a
//! class's round loses no vote that carrom has shown as saved.

use std::collections::BTreeMap;
use std::path::Path;
use std::thread;
use std::time::Duration;

use carrom::app::App;
use carrom::class::ClassRound;
use carrom::game::SavedGame;
use carrom::messages::{FileKind, StoreCall, StoreReply, StoreRequest};
use carrom::quiz::{Form, Response};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rustix::process::Signal;

use crate::child::{self, Player};
use crate::folder::Folder;
use crate::pty::{Pty, carrom};
use crate::thorough::cases;

/// The keys from the page of a new game to a match for two people.
const TWO_PEOPLE: &str =
    "<Down><Down><Down><Left><Left><Down><Down><Down><Down><Right><Right><Enter>";
/// The keys that open the game that was played last.
const RESUME: &str = "s<Enter>";

/// Starts a player in the game that these keys lead to.
fn start(folder: &Path, seed: u64, keys: &str) -> Player {
    Player::start("kill::child_plays", folder, &[&seed.to_string(), keys])
}

/// All games by name; each must be readable.
fn games(folder: &Path) -> BTreeMap<String, SavedGame> {
    let request = StoreCall {
        ticket: 0,
        request: StoreRequest::List(FileKind::Game),
    };
    let StoreReply::Games(Ok(games)) = Store::in_folder(folder).answer(&request).done else {
        panic!("the games cannot be listed");
    };
    let read = games.into_iter().map(|kept| {
        let game = kept
            .content
            .unwrap_or_else(|why| panic!("{}: {why}", kept.name));
        (kept.name, game.0)
    });
    read.collect()
}

/// The number in `stroke 7 of 7` on the screen, while carrom is showing the last stroke.
fn stroke(screen: &str) -> Option<usize> {
    let after = screen.split("- stroke ").nth(1)?;
    let mut words = after.split_whitespace();
    let (number, of, all) = (words.next()?, words.next()?, words.next()?);
    (of == "of" && number == all).then(|| number.parse().ok())?
}

/// Plays until it is killed, and reports the number of each stroke as soon as it is on the screen.
#[test]
fn child_plays() {
    let Some((folder, words)) = child::told() else {
        return;
    };
    let seed = words[0].parse().unwrap();
    let settings = Settings {
        reduced_motion: true,
        ..Settings::default()
    };
    let app = App::new(Route::Table, settings, seed);
    let store = Store::in_folder(&folder);
    let mut game = Headless::keeping(app, 80, 24, store);
    game.press(&words[1]);
    let mut chance = Pcg64::seed_from_u64(seed);
    loop {
        if !game.screen().contains("Space strike") {
            // Continue after the end of a stroke or a board, once the key works again.
            game.pass(Duration::from_secs(2));
            game.press("<Enter>");
            continue;
        }
        game.press(&format!("{:.1} ", chance.random_range(20.0..160.0)));
        if let Some(number) = stroke(&game.screen()) {
            child::say(number);
        }
    }
}

#[test]
fn a_game_that_is_killed_again_and_again_loses_at_most_the_stroke_in_motion() {
    let folder = Folder::new("killed");
    let mut chance = Pcg64::seed_from_u64(60);
    let mut before = 0;
    let kills = cases(20, 60);
    for kill in 0..kills {
        let keys = if before > 0 { RESUME } else { TWO_PEOPLE };
        let player = start(folder.path(), kill, keys);
        // The test kills some processes without waiting for a stroke.
        let strokes = if kill % 10 == 9 {
            0
        } else {
            chance.random_range(1..8)
        };
        let said = player.kill(strokes, &mut chance).unwrap_or(before);
        let games = games(folder.path());
        let kept = games.values().map(|game| game.record.strokes()).max();
        let kept = kept.unwrap_or(0);
        assert!(games.len() <= 1, "a game has lost its file");
        assert!(
            kept == said || kept == said + 1,
            "{said} strokes were shown, {kept} are saved"
        );
        before = kept;
    }
    assert!(before as u64 > kills);
}

#[test]
fn two_killed_games_harm_neither_each_other_nor_older_games() {
    let folder = Folder::new("killed-two");
    let mut chance = Pcg64::seed_from_u64(2);
    let mut before = BTreeMap::new();
    for round in 0..10 {
        let players = [0, 1].map(|i| start(folder.path(), 2 * round + i, TWO_PEOPLE));
        let said = players.map(|player| {
            let strokes = chance.random_range(1..4);
            player.kill(strokes, &mut chance).unwrap()
        });
        let mut now = games(folder.path());
        for (name, game) in &before {
            assert_eq!(now.remove(name).as_ref(), Some(game), "{name} was harmed");
        }
        let mut kept: Vec<_> = now.values().map(|game| game.record.strokes()).collect();
        let mut said = said.to_vec();
        kept.sort_unstable();
        said.sort_unstable();
        assert_eq!(kept.len(), 2);
        for (kept, said) in kept.into_iter().zip(said) {
            assert!(
                kept == said || kept == said + 1,
                "{said} strokes were shown, {kept} are saved"
            );
        }
        before.extend(now);
    }
}

#[test]
fn the_real_game_in_a_terminal_continues_after_being_killed() {
    let folder = Folder::new("killed-pty");
    let data = folder.path().to_str().unwrap();
    let mut chance = Pcg64::seed_from_u64(3);
    let mut before = 0;
    for run in 0..8 {
        let mut pty = Pty::start(carrom(&["table", "--seed", "3", "--data-dir", data]));
        pty.wait_for("a new game");
        // With reduced motion strokes end at once; this setting is saved for the next run.
        pty.press(if run == 0 { "Ms" } else { "s" });
        if before == 0 {
            pty.wait_for("There are none yet");
            pty.press("\x1b");
            pty.wait_for("a new game");
            // North is another person instead of the computer.
            pty.press("\x1b[B\x1b[B\x1b[B\x1b[D\x1b[D\r");
        } else {
            pty.wait_for("Enter: resume");
            pty.press("\r");
        }
        let mut said = before;
        for _ in 0..chance.random_range(1..4) {
            pty.wait_for("Space strike");
            pty.press(&format!("{:.1} ", chance.random_range(40.0..140.0)));
            said += 1;
            pty.wait_for(&format!("stroke {said} of {said}"));
            pty.press("\r");
        }
        pty.wait_for("Space strike");
        // Kill the program during the next stroke.
        pty.press("90 ");
        thread::sleep(Duration::from_micros(chance.random_range(0..30_000)));
        pty.signal(Signal::KILL);
        pty.wait();
        let games = games(folder.path());
        assert_eq!(games.len(), 1);
        let kept = games
            .values()
            .map(|game| game.record.strokes())
            .max()
            .unwrap();
        assert!(
            kept == said || kept == said + 1,
            "{said} strokes were shown, {kept} are saved"
        );
        before = kept;
    }
}

/// The striker's angle in each team's first vote, in degrees as typed.
fn first_votes(folder: &Path) -> Vec<Option<u32>> {
    let request = StoreCall {
        ticket: 0,
        request: StoreRequest::List(FileKind::Class),
    };
    let StoreReply::Classes(Ok(rounds)) = Store::in_folder(folder).answer(&request).done else {
        panic!("the rounds cannot be listed");
    };
    let rounds: Vec<ClassRound> = rounds
        .into_iter()
        .map(|kept| *kept.content.unwrap())
        .collect();
    let [round] = &rounds[..] else {
        assert!(rounds.is_empty(), "the round has lost its file");
        return Vec::new();
    };
    let form = &round.questions()[0].form;
    let typed = |vote| match (form, vote) {
        (Form::Rays { side, .. }, Some(Response::Rays(rays))) => {
            Some((side * rays.striker?.to_degrees()).round() as u32)
        }
        _ => None,
    };
    let teams = 0..round.participants().len();
    teams
        .map(|team| typed(round.ballot(0, team).vote(carrom::class::Vote::First)))
        .collect()
}

/// The program saves each new or changed vote before it shows the list of teams again. So if it is
/// killed while teams vote, at most the vote that is being entered is lost.
#[test]
fn a_round_in_a_terminal_that_is_killed_during_votes_loses_no_vote() {
    const TEAMS: usize = 4;
    let folder = Folder::new("class-killed-pty");
    let data = folder.path().to_str().unwrap();
    let start = |arguments: &[&str]| {
        let arguments = [&["class", "--data-dir", data], arguments].concat();
        Pty::start(carrom(&arguments))
    };
    let mut chance = Pcg64::seed_from_u64(11);
    let mut safe: Vec<Option<u32>> = vec![None; TEAMS];
    let mut angle = 0;
    for kill in 0..20 {
        let mut pty = if safe.iter().any(Option::is_some) {
            let mut pty = start(&[]);
            pty.wait_for("Start");
            pty.press("\x1b[F\x1b[B\r");
            pty.wait_for("A, B, C, D");
            pty.press("\r");
            pty
        } else {
            let mut pty = start(&["--teams", "A,B,C,D", "--code", "7"]);
            pty.wait_for("> Start");
            pty.press("\r\r\r");
            pty
        };
        let voted = safe.iter().flatten().count();
        pty.wait_until("the votes so far", |screen| {
            !in_booth(screen)
                && screen.contains("Each team in turn")
                && screen.matches("[x]").count() >= voted
        });
        let mut last = None;
        for vote in 0..=chance.random_range(1..4) {
            let team = chance.random_range(0..TEAMS);
            angle += 1;
            pty.press(&(team + 1).to_string());
            pty.wait_until("a booth", in_booth);
            pty.press(&format!("{angle}\r30\r"));
            if vote > 0 && kill % 3 > 0 && chance.random_bool(0.3) {
                // Kill the program during this vote.
                last = Some((team, angle));
                break;
            }
            pty.wait_until("the teams", |screen| !in_booth(screen));
            safe[team] = Some(angle);
        }
        if last.is_some() {
            thread::sleep(Duration::from_micros(chance.random_range(0..6_000)));
        }
        pty.signal(Signal::KILL);
        pty.wait();
        let now = first_votes(folder.path());
        // The unfinished vote may have been saved too.
        if let Some((team, angle)) = last
            && now[team] == Some(angle)
        {
            safe[team] = Some(angle);
        }
        assert_eq!(now, safe, "kill {kill}");
    }
    assert!(angle > 40);
}

/// Whether a team is voting, with hidden input.
fn in_booth(screen: &str) -> bool {
    screen.contains("what is typed is hidden")
}

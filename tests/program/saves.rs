//! Saved games: what is written is read back, nothing else is accepted, and no game harms another.

use std::fs;
use std::path::Path;
use std::thread;

use carrom::app::App;
use carrom::game::opponent::{PlayerHand, Strength, clearing};
use carrom::game::{
    Aids, BoardCode, Company, Fingerprint, Game, GameSetup, Hands, Length, Move, Player, Record,
    Rules, SavedGame, Seat, SeatNames,
};
use carrom::messages::{FileContent, FileKind, KeptGame, StoreCall, StoreReply, StoreRequest};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use proptest::prelude::*;
use rand::SeedableRng;
use rand_pcg::Pcg64;

use crate::folder::Folder;
use crate::play::random_move;

/// A game after `moves` random moves.
fn saved(setup: GameSetup, moves: usize, seed: u64) -> SavedGame {
    let mut names = SeatNames::default();
    names.set(Seat::South, "Ada \"L\"");
    names.set(Seat::North, "B\u{f3}");
    let mut chance = Pcg64::seed_from_u64(seed);
    let mut record = Record::new(setup);
    let mut game = Game::new(setup);
    for _ in 0..moves {
        record.moves.push(random_move(&mut game, &mut chance));
    }
    SavedGame {
        player: "Ada \"L\" \u{e9}".into(),
        company: Company {
            players: [
                Player::Person,
                Player::Computer,
                Player::Computer,
                Player::Person,
            ],
            strengths: [
                Strength::Club,
                Strength::Beginner,
                Strength::Champion,
                Strength::Club,
            ],
            names,
            hand: PlayerHand::Club,
            call: true,
            aids: Aids {
                ghost: false,
                ..Aids::default()
            },
        },
        record,
        hints: vec![0, 2],
        end: Fingerprint::of(&game),
    }
}

fn friendly(seed: u64) -> GameSetup {
    GameSetup {
        rules: Rules::Friendly,
        seed: Some(seed),
        ..GameSetup::default()
    }
}

fn ask(store: &mut Store, ticket: u64, request: StoreRequest) -> StoreReply {
    store.answer(&StoreCall { ticket, request }).done
}

fn save(store: &mut Store, ticket: u64, game: &SavedGame) {
    let done = ask(
        store,
        ticket,
        StoreRequest::Save(FileContent::Game(Box::new(game.clone()))),
    );
    assert_eq!(done, StoreReply::Saved(Ok(())));
}

fn list(store: &mut Store) -> Vec<KeptGame> {
    match ask(store, 0, StoreRequest::List(FileKind::Game)) {
        StoreReply::Games(Ok(games)) => games,
        other => panic!("{other:?}"),
    }
}

fn readable(store: &mut Store) -> Vec<(String, SavedGame)> {
    let games = list(store).into_iter();
    games
        .filter_map(|kept| Some((kept.name, kept.content.ok()?.0)))
        .collect()
}

#[test]
fn a_game_is_read_back_bit_for_bit() {
    for (rules, hands) in [
        (Rules::Tournament, Hands::Two),
        (Rules::Tournament, Hands::Four),
        (Rules::Friendly, Hands::Two),
        (Rules::Points, Hands::Two),
        (Rules::Points, Hands::Four),
        (Rules::Practice, Hands::Two),
    ] {
        for (seed, restitution) in [(None, 1.0), (Some(7), 0.85), (Some(u64::MAX), 0.0)] {
            let setup = GameSetup {
                rules,
                hands,
                restitution,
                seed,
                ..GameSetup::default()
            };
            let saved = saved(setup, 40, 5);
            let text = saved.text().unwrap();
            let (read, game) = SavedGame::read("game", text.as_bytes()).unwrap();
            assert_eq!(read, saved);
            assert_eq!(read.text().unwrap(), text);
            assert_eq!(Fingerprint::of(&game), saved.end);
        }
    }
}

#[test]
fn a_truncated_game_is_refused() {
    let text = saved(friendly(1), 12, 1).text().unwrap();
    let bytes = text.as_bytes();
    for length in 0..bytes.len() - 1 {
        let fault = SavedGame::read("game", &bytes[..length]).expect_err("a part");
        assert!(fault.to_string().starts_with("game:"), "{fault}");
    }
    // A missing last line break does not matter.
    assert!(SavedGame::read("game", &bytes[..bytes.len() - 1]).is_ok());
}

/// Prints the game for `tests/saves/format-N.toml`, for the next N: 30 strokes by two players.
#[test]
#[ignore = "prints the file for a new format: cargo test --test program print_a_game -- --ignored --nocapture"]
fn print_a_game_to_pin() {
    let setup = GameSetup {
        rules: Rules::Points,
        restitution: 0.85,
        length: Length::Board,
        ..friendly(1)
    };
    let mut game = saved(setup, 30, 1);
    game.player = "Ada".into();
    assert_eq!(game.record.strokes(), 30);
    print!("{}", game.text().unwrap());
}

/// If this fails because the engine now plays a stroke differently, even by one bit, every saved
/// game is lost. Correct the engine, or keep the old engine for the old format.
#[test]
fn a_game_of_the_first_format_still_opens() {
    let bytes = include_bytes!("../saves/format-1.toml");
    let (saved, game) = SavedGame::read("format-1.toml", bytes).unwrap();
    assert_eq!(saved.player, "Ada");
    assert_eq!(saved.record.strokes(), 30);
    assert_eq!(saved.record.setup.restitution, 1.0);
    assert_eq!(Fingerprint::of(&game), saved.end);
    // Saved again, it is the same game.
    let text = saved.text().unwrap();
    let again = SavedGame::read("again", text.as_bytes()).unwrap();
    assert_eq!(again, (saved, game));
    // Invisible names were accepted in that version.
    let text = String::from_utf8_lossy(bytes).replace("\"Ada\"", "\"\u{3164}\"");
    let (saved, _) = SavedGame::read("format-1.toml", text.as_bytes()).unwrap();
    assert_eq!(saved.player, "No name");
}

#[test]
fn a_game_of_the_second_format_still_opens_with_its_restitution() {
    let text = include_str!("../saves/format-2.toml");
    let (saved, game) = SavedGame::read("format-2.toml", text.as_bytes()).unwrap();
    assert_eq!(saved.record.strokes(), 30);
    assert_eq!(saved.record.setup.restitution, 0.85);
    assert_eq!(Fingerprint::of(&game), saved.end);
    // A game of this format is a match, and every stroke is played exactly as it was aimed.
    assert_eq!(saved.record.setup.length, Length::Match);
    assert_eq!(saved.company.hand, PlayerHand::Exact);
    // Saved again, it is the same game.
    let again = SavedGame::read("again", saved.text().unwrap().as_bytes()).unwrap();
    assert_eq!(again, (saved, game));
    // With a different coefficient of restitution, the same strokes lead to a different outcome.
    let elastic = text.replacen("restitution = 0.85, ", "", 1);
    assert_ne!(elastic, text);
    assert!(SavedGame::read("elastic", elastic.as_bytes()).is_err());
}

#[test]
fn a_game_of_the_third_format_still_opens_with_its_length_and_hand() {
    let text = include_str!("../saves/format-3.toml");
    let (saved, game) = SavedGame::read("format-3.toml", text.as_bytes()).unwrap();
    assert_eq!(saved.record.strokes(), 30);
    assert_eq!(saved.record.setup.rules, Rules::Points);
    assert_eq!(saved.record.setup.length, Length::Board);
    assert_eq!(saved.company.hand, PlayerHand::Club);
    assert_eq!(saved.text().unwrap(), text);
    assert_eq!(Fingerprint::of(&game), saved.end);
    // With different rules, the same strokes lead to a different end.
    let friendly = text.replacen("\"points\"", "\"friendly\"", 1);
    assert!(SavedGame::read("friendly", friendly.as_bytes()).is_err());
    for (from, to) in [
        ("\"club\"\ncall", "\"firm\"\ncall"),
        ("\"board\"", "\"year\""),
    ] {
        assert!(text.contains(from), "{from}");
        let text = text.replacen(from, to, 1);
        assert!(SavedGame::read("game", text.as_bytes()).is_err(), "{to}");
    }
}

#[test]
fn games_without_names_still_open_and_odd_names_are_refused() {
    let text = include_str!("../saves/format-3.toml");
    let (saved, _) = SavedGame::read("format-3.toml", text.as_bytes()).unwrap();
    assert_eq!(saved.company.names, SeatNames::default());
    let long = "x".repeat(SeatNames::LONGEST + 1);
    for (names, expected) in [
        ("{ south = \"Ada\", north = \"\" }", None),
        ("{ north = \"\u{87fb}\" }", None),
        ("{ south = \" Ada\" }", Some("visible letters")),
        ("{ south = \"A\\u001b[31m\" }", Some("visible letters")),
        ("{ south = \"A\\u202eda\" }", Some("visible letters")),
        ("{ east = \"Ada\" }", Some("names")),
        ("[\"Ada\", \"Bo\"]", Some("names")),
        (
            &format!("{{ south = \"{long}\" }}"),
            Some("12 visible letters"),
        ),
    ] {
        let text = text.replacen("hand = ", &format!("names = {names}\nhand = "), 1);
        match (SavedGame::read("game", text.as_bytes()), expected) {
            (Ok((saved, _)), None) => assert_ne!(saved.company.names, SeatNames::default()),
            (Err(fault), Some(expected)) => {
                let fault = fault.to_string();
                assert!(fault.contains(expected), "{names}: {fault}");
            }
            (read, _) => panic!("{names}: {read:?}"),
        }
    }
}

#[test]
fn a_board_for_one_player_is_saved_and_a_forged_one_is_refused() {
    let text = include_str!("../saves/board.toml");
    let (saved, game) = SavedGame::read("board.toml", text.as_bytes()).unwrap();
    let code = BoardCode::parse("2026-11-26").unwrap();
    assert_eq!(saved.record.setup, code.setup());
    assert!(game.coins().is_empty());
    assert_eq!(saved.text().unwrap(), text);
    for (from, to, expected) in [
        ("seed = 20261126", "seed = 20261127", "lead to"),
        (
            "seed = 20261126",
            "seed = 20261131",
            "setup.seed: expected the code of a board",
        ),
        (
            "seed = 20261126",
            "seed = -1",
            "setup.seed: expected the code of a board",
        ),
        (
            ", seed = 20261126",
            "",
            "setup.seed: expected the code of a board",
        ),
        (
            "\"two\"",
            "\"four\"",
            "setup.seed: expected the code of a board",
        ),
        (
            "restitution = 1.0",
            "restitution = 0.5",
            "setup.seed: expected the code of a board",
        ),
        (
            "moves = [\n",
            "moves = [\n  \"next_board\",\n",
            "this board has not ended yet",
        ),
        (
            "moves = [\n",
            "moves = [\n  { lay_out = [] },\n",
            "only in a practice game",
        ),
        ("end = \"", "end = \"0123456789abcdef\" # ", "lead to"),
    ] {
        let forged = text.replacen(from, to, 1);
        assert_ne!(forged, text, "{from}");
        let error = SavedGame::read("game", forged.as_bytes()).unwrap_err();
        assert!(error.to_string().contains(expected), "{to}: {error}");
    }
    // A board ends when it is cleared.
    let more = text.replacen("]\nend", "  \"next_board\",\n]\nend", 1);
    let error = SavedGame::read("game", more.as_bytes()).unwrap_err();
    assert!(error.to_string().contains("the match is over"), "{error}");
}

/// Prints the game for `tests/saves/board.toml`.
#[test]
#[ignore = "prints the file: cargo test --test program print_a_board -- --ignored --nocapture"]
fn print_a_board_to_pin() {
    let code = BoardCode::parse("2026-11-26").unwrap();
    let mut game = saved(code.setup(), 0, 1);
    game.player = "Ada".into();
    game.hints.clear();
    for strike in clearing(code).unwrap() {
        game.record.moves.push(Move::Strike(strike));
    }
    game.end = Fingerprint::of(&game.record.replay().unwrap());
    print!("{}", game.text().unwrap());
}

#[test]
fn an_impossible_restitution_is_refused() {
    let text = include_str!("../saves/format-2.toml");
    for (value, found) in [
        ("nan", "nan"),
        ("inf", "inf"),
        ("-0.1", "-0.1"),
        ("1.0001", "1.0001"),
        ("\"0.85\"", "the text \"0.85\""),
        ("[0.85]", "[0.85]"),
        ("true", "true"),
    ] {
        let text = text.replacen("0.85", value, 1);
        let error = SavedGame::read("game.toml", text.as_bytes()).unwrap_err();
        let expected = format!(
            "game.toml:8: setup.restitution: expected a coefficient of restitution from 0 to 1, \
             found {found}"
        );
        assert_eq!(error.to_string(), expected);
    }
}

/// Files that are not saved games, each with its expected message.
fn bad() -> Vec<(&'static str, Vec<u8>, &'static str)> {
    let good = saved(friendly(2), 3, 2).text().unwrap();
    let with = |from: &str, to: &str| {
        assert!(good.contains(from), "{from}");
        good.replacen(from, to, 1).into_bytes()
    };
    let end = good.lines().last().unwrap().to_owned();
    let player = good.lines().nth(2).unwrap();
    let mut latin = good.clone().into_bytes();
    let at = good.find("Ada").unwrap();
    latin[at] = 0xe9;
    vec![
        (
            "empty",
            vec![],
            "line 1: format: expected a saved game with `format = 3`, found nothing",
        ),
        (
            "foreign",
            b"[package]\nname = \"x\"\n".to_vec(),
            "line 1: format: expected a saved game with `format = 3`, found nothing",
        ),
        ("other", b"%PDF-1.7 \x00\x01".to_vec(), "line 1: "),
        (
            "scene",
            b"format = 1\n[board]\n[[disc]]\nkind = \"striker\"\n".to_vec(),
            "line 2: board: unknown field; expected one of format, player, players, ",
        ),
        (
            "newer",
            b"format = 4\nwhatever = true\n".to_vec(),
            "line 1: format: 4 is newer than 3, the latest this version reads; a newer version may open it",
        ),
        (
            "format-text",
            with("format = 3", "format = \"3\""),
            "line 2: format: expected a saved game with `format = 3`, found the text \"3\"",
        ),
        (
            "latin",
            latin,
            "line 3: player: expected UTF-8 text, found other bytes",
        ),
        (
            "huge",
            vec![b'#'; (1 << 20) + 1],
            "line 1: expected a file of at most 1 MiB, found more",
        ),
        (
            "misspelt",
            with("moves =", "movse ="),
            "line 12: movse: unknown field; expected one of format, player, players, computer, computers, names, hand, call, aids, setup, hints, moves, end; did you mean moves?",
        ),
        (
            "no-player",
            with(player, "player = \"\""),
            "line 3: player: expected a name of 1 to 40 visible characters",
        ),
        ("bad-move", with("strike", "stroke"), "line 13: moves: "),
        (
            "no-number",
            with("velocity_m_s = [", "velocity_m_s = [nan, "),
            "line 13: ",
        ),
        (
            "impossible",
            with("place_m = [", "place_m = [1.0, "),
            "line 13: ",
        ),
        (
            "off-the-lines",
            with(
                "moves = [\n",
                "moves = [\n  { strike = { place_m = [0.0, 0.0], velocity_m_s = [0.0, 1.0] } },\n",
            ),
            "line 13: moves: move 1: ",
        ),
        (
            "no-angle",
            with(
                "moves = [\n",
                "moves = [\n  { strike = { place_m = [0.0, -0.2526], velocity_m_s = [0.0, 1.0], call = { coin_deg = nan } } },\n",
            ),
            "line 13: moves: expected an angle in degrees, found NaN",
        ),
        (
            "too-early",
            with("moves = [\n", "moves = [\n  \"next_board\",\n"),
            "line 13: moves: move 1: ",
        ),
        (
            "other-end",
            with(&end, "end = \"0123456789abcdef\""),
            "line 17: end: expected the moves to lead to 0123456789abcdef, but they lead to ",
        ),
        (
            "no-end",
            with(&end, "end = \"soon\""),
            "line 17: end: expected a fingerprint of 16 hexadecimal digits",
        ),
    ]
}

#[test]
fn an_invalid_file_is_reported_and_left_unchanged_and_the_others_can_be_used() {
    let folder = Folder::new("bad-saves");
    let mut store = Store::in_folder(folder.path());
    let good = saved(friendly(3), 5, 3);
    save(&mut store, 1, &good);
    let games = folder.path().join("games");
    for (name, bytes, _) in bad() {
        fs::write(games.join(format!("{name}.toml")), bytes).unwrap();
    }
    // A folder whose name looks like that of a saved game is ignored.
    fs::create_dir(games.join("a-folder.toml")).unwrap();
    fs::write(games.join("notes.txt"), "mine").unwrap();

    let mut other = Store::in_folder(folder.path());
    let listed = list(&mut other);
    assert_eq!(listed.len(), bad().len() + 1);
    for (name, _, expected) in bad() {
        let kept = listed.iter().find(|kept| kept.name == name).unwrap();
        let reason = kept.content.as_ref().unwrap_err();
        assert!(reason.starts_with(expected), "{name}: {reason}");
        let done = ask(
            &mut other,
            9,
            StoreRequest::Load(FileKind::Game, name.into()),
        );
        let StoreReply::Game(Err(reason)) = done else {
            panic!("{name} was loaded");
        };
        assert!(reason.contains(&format!("{name}.toml:")), "{reason}");
    }
    // One game continues and another begins; every other file stays unchanged.
    let longer = saved(friendly(3), 6, 3);
    save(&mut store, 1, &longer);
    save(&mut other, 2, &good);
    for (name, bytes, _) in bad() {
        let now = fs::read(games.join(format!("{name}.toml"))).unwrap();
        assert!(now == bytes, "{name}");
    }
    let mut kept = readable(&mut other);
    kept.sort_by(|a, b| a.0.cmp(&b.0));
    let expected = [("game-1".into(), longer), ("game-2".into(), good)];
    assert_eq!(kept, expected);
}

#[test]
fn a_file_changed_by_another_program_is_not_overwritten() {
    let folder = Folder::new("changed-saves");
    let mut store = Store::in_folder(folder.path());
    let path = folder.path().join("games/game-1.toml");
    for (moves, found) in [(2, &b"not ours"[..]), (3, b"")] {
        save(&mut store, 1, &saved(friendly(4), moves - 1, 4));
        let path = path.with_file_name(format!("game-{}.toml", moves - 1));
        fs::write(&path, found).unwrap();
        save(&mut store, 1, &saved(friendly(4), moves, 4));
        assert_eq!(fs::read(&path).unwrap(), found);
    }
    fs::remove_file(path.with_file_name("game-3.toml")).unwrap();
    save(&mut store, 1, &saved(friendly(4), 4, 4));
    let kept = readable(&mut store);
    assert_eq!(kept.len(), 1);
    assert_eq!(kept[0].1.record.strokes(), 4);
}

#[test]
fn a_game_resumed_twice_keeps_both_continuations() {
    let folder = Folder::new("same-save");
    save(
        &mut Store::in_folder(folder.path()),
        1,
        &saved(friendly(5), 4, 5),
    );
    let resume = || {
        let mut store = Store::in_folder(folder.path());
        let done = ask(
            &mut store,
            1,
            StoreRequest::Load(FileKind::Game, "game-1".into()),
        );
        assert!(matches!(done, StoreReply::Game(Ok(_))));
        store
    };
    let (mut one, mut two) = (resume(), resume());
    let ones = saved(friendly(5), 6, 5);
    let twos = saved(friendly(6), 7, 6);
    save(&mut one, 1, &ones);
    save(&mut two, 1, &twos);
    save(&mut one, 1, &ones);
    let mut kept: Vec<_> = readable(&mut one)
        .into_iter()
        .map(|(_, game)| game)
        .collect();
    kept.sort_by_key(|game| game.record.strokes());
    assert_eq!(kept, [ones, twos]);
}

#[test]
fn many_games_saved_at_once_do_not_harm_each_other() {
    let folder = Folder::new("many-saves");
    let games: Vec<_> = (0..4).map(|seed| saved(friendly(seed), 4, seed)).collect();
    thread::scope(|scope| {
        for game in &games {
            let path = folder.path();
            scope.spawn(move || {
                let mut store = Store::in_folder(path);
                for ticket in 0..5 {
                    for moves in 1..=4 {
                        let begun = game.record.moves.iter().take(moves).cloned();
                        let record = Record {
                            setup: game.record.setup,
                            moves: begun.collect(),
                        };
                        let end = Fingerprint::of(&record.replay().unwrap());
                        save(
                            &mut store,
                            ticket,
                            &SavedGame {
                                record,
                                end,
                                ..game.clone()
                            },
                        );
                    }
                }
            });
        }
    });
    let kept = readable(&mut Store::in_folder(folder.path()));
    assert_eq!(kept.len(), 20);
    for game in &games {
        let same = kept.iter().filter(|(_, kept)| kept == game);
        assert_eq!(same.count(), 5);
    }
    assert_eq!(leftovers(folder.path()), Vec::<String>::new());
}

/// The files in the folder for games, except the games and the lock.
fn leftovers(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder.join("games")).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names
        .filter(|name| !name.ends_with(".toml") && name != ".lock")
        .collect()
}

#[test]
fn an_export_never_replaces_another() {
    let folder = Folder::new("exports");
    let mut store = Store::in_folder(folder.path());
    let game = saved(friendly(7), 3, 7);
    let mut places = Vec::new();
    for _ in 0..3 {
        match ask(
            &mut store,
            1,
            StoreRequest::Export(FileContent::Game(Box::new(game.clone()))),
        ) {
            StoreReply::Exported(Ok(place)) => places.push(place),
            other => panic!("{other:?}"),
        }
    }
    for (i, place) in places.iter().enumerate() {
        assert!(place.ends_with(&format!("carrom-game-{}.toml", i + 1)));
        assert_eq!(fs::read_to_string(place).unwrap(), game.text().unwrap());
    }
}

#[test]
fn only_the_removed_game_is_deleted() {
    let folder = Folder::new("removed-save");
    for mut store in [Store::in_folder(folder.path()), Store::in_memory()] {
        for ticket in 1..=3 {
            save(&mut store, ticket, &saved(friendly(8), 3, ticket));
        }
        let removed = ask(
            &mut store,
            9,
            StoreRequest::Remove(FileKind::Game, "game-2".into()),
        );
        assert_eq!(removed, StoreReply::Removed(Ok(())));
        let names: Vec<_> = readable(&mut store)
            .into_iter()
            .map(|(name, _)| name)
            .collect();
        assert_eq!(names, ["game-3", "game-1"]);
    }
}

#[test]
fn a_file_with_a_huge_number_does_not_use_up_the_names() {
    let folder = Folder::new("huge-number");
    let games = folder.path().join("games");
    fs::create_dir(&games).unwrap();
    for number in [u64::MAX, u32::MAX.into()] {
        fs::write(games.join(format!("game-{number}.toml")), "").unwrap();
    }
    let mut store = Store::in_folder(folder.path());
    for ticket in 1..=2 {
        save(&mut store, ticket, &saved(friendly(8), 1, ticket));
    }
    assert_eq!(readable(&mut store).len(), 2);
}

/// A game of two people at the table.
fn table(store: Store) -> Headless {
    let settings = Settings {
        reduced_motion: true,
        ..Settings::default()
    };
    let app = App::new(Route::Table, settings, 5);
    let mut game = Headless::keeping(app, 80, 24, store);
    game.press("<Down><Down><Down><Left><Left>");
    game
}

#[test]
fn a_failed_save_is_reported_once_and_the_game_continues() {
    let folder = Folder::new("no-saves");
    // A file has the name of the folder for games, so that nobody, not even root, can save a game.
    let in_the_way = folder.path().join("games");
    fs::write(&in_the_way, "in the way").unwrap();
    let mut game = table(Store::in_folder(folder.path()));
    game.press("<Enter>90<Enter> ");
    let told = |game: &mut Headless| game.screen().contains("This game cannot be saved");
    assert!(told(&mut game), "{}", game.screen());
    game.press("<Enter>260 ");
    assert!(!told(&mut game), "{}", game.screen());
    assert!(game.screen().contains("stroke 2 of 2"), "{}", game.screen());
    assert_eq!(fs::read_to_string(&in_the_way).unwrap(), "in the way");
    // Once the file is removed, the whole game is saved.
    fs::remove_file(&in_the_way).unwrap();
    game.press("<Enter>100 ");
    let kept = readable(&mut Store::in_folder(folder.path()));
    assert_eq!(kept[0].1.record.strokes(), 3);
}

#[test]
fn a_game_is_resumed_where_it_was_left() {
    let folder = Folder::new("resumed");
    let mut game = table(Store::in_folder(folder.path()));
    game.press("<Enter>90<Enter> <Enter>260 <Enter>100 <Enter>");
    let left = game.screen();
    game.press("<Escape>y");
    assert!(game.screen().contains("a new game"), "{}", game.screen());

    // Resume it on another day.
    let mut game = table(Store::in_folder(folder.path()).timeless());
    game.press("s");
    assert!(game.screen().contains("board 1, 3"), "{}", game.screen());
    game.press("<Enter>");
    assert_eq!(game.screen(), left);
    game.press("95 <Enter>");
    let kept = readable(&mut Store::in_folder(folder.path()));
    assert_eq!(kept.len(), 1);
    assert_eq!(kept[0].1.record.strokes(), 4);

    // Replay it stroke by stroke.
    game.press("v");
    for stroke in 1..=4 {
        let expected = format!("stroke {stroke} of 4");
        assert!(game.screen().contains(&expected), "{}", game.screen());
        game.press("<Enter>");
    }
    assert!(game.screen().contains("strength"), "{}", game.screen());

    // A game is deleted only after confirmation.
    game.press("<Escape>ysd");
    assert!(
        game.screen().contains("Delete this game"),
        "{}",
        game.screen()
    );
    game.press("n");
    assert!(game.screen().contains("board 1, 4"), "{}", game.screen());
    game.press("dy");
    assert!(
        game.screen().contains("There are none yet"),
        "{}",
        game.screen()
    );
}

#[test]
fn unreadable_games_are_listed_with_the_reason() {
    let folder = Folder::new("unreadable");
    let games = folder.path().join("games");
    fs::create_dir_all(&games).unwrap();
    fs::write(games.join("game-1.toml"), "format = 9\n").unwrap();
    let mut game = table(Store::in_folder(folder.path()));
    game.press("s");
    let screen = game.screen();
    assert!(screen.contains("> game-1 ?"), "{screen}");
    assert!(screen.contains("9 is newer"), "{screen}");
    game.press("<Enter>ve");
    assert!(game.screen().contains("saved games"), "{}", game.screen());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn random_bytes_are_refused_as_a_game(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        prop_assert!(SavedGame::read("any", &bytes).is_err());
    }

    #[test]
    fn a_damaged_game_is_refused_or_leads_to_the_same_end(
        at in any::<prop::sample::Index>(),
        byte: u8,
        cut in 0..3usize,
    ) {
        let whole = saved(friendly(9), 6, 9);
        let mut bytes = whole.text().unwrap().into_bytes();
        let at = at.index(bytes.len());
        bytes.splice(at..(at + cut).min(bytes.len()), [byte]);
        if let Ok((read, _)) = SavedGame::read("damaged", &bytes) {
            prop_assert_eq!(read.end, whole.end);
        }
    }
}

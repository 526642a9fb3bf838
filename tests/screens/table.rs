//! The table, driven by keys: a whole board to its end, practice, the computer, and random input.

use std::time::Duration;

use carrom::app::App;
use carrom::game::opponent::{PlayerHand, Strength};
use carrom::game::{
    BoardCode, Colour, Game, GameStage, Length, Move, Piece, Player, Rules, Ruling, SavedGame,
    Seat, Strike, Team,
};
use carrom::messages::{FileContent, Input, Key, Mouse, MouseKind, StoreCall, StoreRequest};
use carrom::physics::angle::unit_vector;
use carrom::progress::{Calendar, Due, TABLE};
use carrom::quiz::Topic;
use carrom::screens::table::{Options, Table};
use carrom::screens::{Hosted, Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use carrom::widgets::Charset;
use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use crate::folder::Folder;
use crate::thorough::cases;

/// The seed of every game here.
const SEED: u64 = 11;

fn at_the_table(options: Options, settings: Settings) -> Headless {
    let table = Table::playing(options, SEED);
    rested(Headless::new(
        App::on(Box::new(Hosted::new(table)), settings, 1),
        120,
        40,
    ))
}

/// The options for a match between two people.
fn whole_match() -> Options {
    Options::two_people().with(|options| options.setup.length = Length::Match)
}

/// The game after a pause in which no key was pressed, so that the next press strikes.
fn rested(mut game: Headless) -> Headless {
    game.pass(Duration::from_secs(2));
    game
}

fn still() -> Settings {
    Settings {
        reduced_motion: true,
        ..Settings::default()
    }
}

/// A stroke as it can be set with keys: steps of 2 mm from the middle of the base line,
/// hundredths of a degree, tenths of m/s.
#[derive(Debug, Clone, Copy)]
struct Keyed {
    steps: i32,
    angle: u32,
    tenths: i32,
}

impl Keyed {
    fn random(chance: &mut Pcg64) -> Self {
        Self {
            steps: chance.random_range(-80..=80),
            angle: chance.random_range(1000..17000),
            tenths: chance.random_range(12..=50),
        }
    }

    /// The stroke that these keys set up.
    fn strike(self, game: &Game) -> Option<Strike> {
        let lines = game.base_lines();
        // A step goes to the right on the screen, which is North's left.
        let right = lines.along(glam::DVec2::X).signum();
        let place = lines.at(right * f64::from(self.steps * 20) / 10_000.0);
        let direction = game.seat().turn(unit_vector(f64::from(self.angle) / 100.0));
        Some(Strike {
            place,
            velocity: f64::from(self.tenths) / 10.0 * direction,
            call: None,
        })
    }

    /// The keys to press if the strength is `tenths` at first.
    fn keys(self, tenths: i32, seat: Seat) -> String {
        let times = |key: &str, other: &str, count: i32| {
            let key = if count < 0 { other } else { key };
            key.repeat(count.unsigned_abs() as usize)
        };
        format!(
            "{}{}{}{:.2} ",
            2 * self.steps.abs(),
            if self.steps < 0 { "[" } else { "]" },
            times("+", "-", self.tenths - tenths),
            (f64::from(self.angle) / 100.0 + seat.turned_by_deg()).rem_euclid(360.0)
        )
    }
}

/// The result of a stroke.
struct Tried {
    keyed: Keyed,
    after: Game,
    rulings: Vec<Ruling>,
    fell: Vec<Piece>,
}

fn attempt(game: &Game, keyed: Keyed) -> Option<Tried> {
    let strike = keyed.strike(game)?;
    let mut after = game.clone();
    let (shot, rulings) = Move::Strike(strike).make(&mut after).ok()?;
    let stroke = carrom::game::Stroke::from_shot(game.coins(), &shot?).ok()?;
    Some(Tried {
        keyed,
        after,
        rulings,
        fell: stroke.pocketed,
    })
}

/// The first of many random strokes with the `wanted` result.
fn seek(game: &Game, chance: &mut Pcg64, wanted: impl Fn(&Tried) -> bool) -> Tried {
    for _ in 0..20_000 {
        if let Some(tried) = attempt(game, Keyed::random(chance))
            && wanted(&tried)
        {
            return tried;
        }
    }
    panic!("no such stroke was found");
}

fn fell(tried: &Tried, piece: Piece) -> usize {
    tried.fell.iter().filter(|p| **p == piece).count()
}

/// The next stroke of South or North: South breaks, incurs a due, then pockets coins, the queen,
/// her cover, and the rest; North never pockets anything.
fn next_stroke(game: &Game, chance: &mut Pcg64, due_made: bool) -> Tried {
    let play = game.play();
    if game.team(game.seat()) == Team::Second {
        return seek(game, chance, |tried| tried.fell.is_empty());
    }
    let own = |tried: &Tried| fell(tried, Piece::White) > 0 && fell(tried, Piece::Striker) == 0;
    let nothing_else = |tried: &Tried| {
        fell(tried, Piece::Black) == 0 && fell(tried, Piece::Queen) == 0 && own(tried)
    };
    if play.is_unbroken() {
        seek(game, chance, |tried| tried.fell.is_empty())
    } else if !due_made {
        seek(game, chance, |tried| tried.fell == [Piece::Striker])
    } else if play.queen_to_cover() {
        seek(game, chance, nothing_else)
    } else if play.queen_on_board() && play.in_pockets(Colour::White) > 0 {
        seek(game, chance, |tried| tried.fell == [Piece::Queen])
    } else {
        seek(game, chance, nothing_else)
    }
}

/// The text of the panel, with its lines joined.
fn panel(game: &mut Headless) -> String {
    let screen = game.screen();
    let rows = screen.lines().filter_map(|row| row.get(74..119));
    let words: Vec<&str> = rows.flat_map(str::split_whitespace).collect();
    words.join(" ")
}

#[test]
fn a_whole_board_with_queen_cover_and_a_due_is_played_by_keys() {
    let options = whole_match();
    let mut game = Game::new(options.seeded(SEED));
    let mut screen = at_the_table(options, still());
    let mut chance = Pcg64::seed_from_u64(3);
    let mut tenths = 40;
    let mut due_made = false;
    let mut seen = [false; 4];
    for _ in 0..100 {
        let before_turn = game.seat();
        let tried = next_stroke(&game, &mut chance, due_made);
        screen.press(&tried.keyed.keys(tenths, before_turn));
        tenths = tried.keyed.tenths;
        let shown = panel(&mut screen);
        for ruling in &tried.rulings {
            assert!(ruling.law.is_some());
            let words = Charset::Ascii.text(&ruling.announced()).into_owned();
            assert!(shown.contains(&words), "{shown}\n{words}");
        }
        due_made |= tried.fell == [Piece::Striker] && before_turn == game.seat();
        game = tried.after;
        seen[0] |= shown.contains("South owes 1");
        seen[1] |= shown.contains("queen Q to be covered");
        seen[2] |= shown.contains("queen Q with South");
        screen.press("<Enter>");
        screen.pass(Duration::from_secs(2));
        seen[3] |= panel(&mut screen).contains("Cover the queen");
        if let GameStage::BoardOver(won) = game.stage() {
            assert_eq!(won.winner, Team::First);
            let text = screen.screen();
            assert!(
                text.contains(&format!("South {} : 0 North", won.points)),
                "{text}"
            );
            assert!(text.contains("The board goes to South."), "{text}");
            assert_eq!(seen, [true; 4]);
            screen.press("<Enter>");
            assert!(screen.screen().contains("North breaks, white"));
            return;
        }
    }
    panic!("the board never ended");
}

/// The number of visible pieces of each kind on the board: white, black, queen.
fn seen(game: &mut Headless, charset: Charset) -> [usize; 3] {
    let screen = game.screen();
    let (tokens, corners) = match charset {
        Charset::Ascii => (["o", "@", "Q"], "++"),
        Charset::Unicode => (["○W", "●B", "Q"], "╮╭"),
    };
    // Leave out the title, the keys and the panel beside the board.
    let frame = screen.lines().nth(1).unwrap();
    let columns = frame.split_once(corners).unwrap().0.chars().count();
    let rows = screen.lines().filter(|row| row.starts_with(['|', '│']));
    let board: String = rows.flat_map(|row| row.chars().take(columns)).collect();
    tokens.map(|any| board.chars().filter(|sign| any.contains(*sign)).count())
}

#[test]
fn every_piece_of_the_opening_is_seen_at_every_size() {
    let aims = ["", "73<Enter>14[", "97.6<Enter>", "60<Enter>80["];
    for charset in [Charset::Ascii, Charset::Unicode] {
        for (columns, rows) in [(60, 20), (80, 24), (100, 30), (120, 40), (200, 60)] {
            for aim in aims {
                let settings = Settings { charset, ..still() };
                let mut game = at_the_table(Options::two_people(), settings);
                game.resize(columns, rows);
                game.press(aim);
                let seen = seen(&mut game, charset);
                let told = format!("{charset:?} {columns} {aim}\n{}", game.screen());
                assert_eq!(seen, [9, 9, 1], "{told}");
            }
        }
    }
}

#[test]
fn a_hint_sets_the_stroke_that_it_describes_and_is_legal() {
    let mut game = at_the_table(Options::two_people(), still());
    game.press("hhh");
    let shown = panel(&mut game);
    let (_, hint) = shown.split_once("Place the striker ").unwrap();
    let (place, rest) = hint.split_once(", aim at ").unwrap();
    let (angle, rest) = rest.split_once(" and strike at ").unwrap();
    let (speed, _) = rest.split_once(" m/s.").unwrap();
    assert!(shown.contains(&format!("aim {angle}")), "{shown}");
    assert!(shown.contains(&format!("{speed} m/s place")), "{shown}");
    let place = place.trim_end_matches(" of the middle");
    assert!(shown.contains(&format!("place {place}")), "{shown}");
    assert!(!shown.contains("No stroke is"), "{shown}");
    assert!(!shown.contains("set this stroke"), "{shown}");
    game.press("<Right>");
    assert!(panel(&mut game).contains("set this stroke"));
    game.press("h");
    // The striker stays on the board.
    game.press(" ");
    assert!(panel(&mut game).contains("Space: go on."));
    assert!(!panel(&mut game).contains("striker fell"));
}

#[test]
fn place_and_strength_can_be_typed() {
    let mut game = at_the_table(Options::two_people(), still());
    game.press("57[2.5+101<Enter>");
    let shown = panel(&mut game);
    assert!(shown.contains("aim 101.0 deg"), "{shown}");
    assert!(shown.contains("2.5 m/s"), "{shown}");
    assert!(shown.contains("place 57 mm left"), "{shown}");
    // A typed place may be illegal, and the reason is then shown; a place reached by steps is
    // legal.
    game.press("200]");
    assert!(panel(&mut game).contains("not touch it"));
    game.press("]");
    assert!(panel(&mut game).contains("place 216 mm right"));
}

#[test]
fn in_practice_pieces_are_arranged_and_strokes_are_made_and_undone() {
    let options = Options::default().with(|it| it.setup.rules = Rules::Practice);
    let mut game = at_the_table(options, still());
    let pack = game.screen();
    game.press("80.5 ");
    assert!(game.screen().contains("stroke 1 of 1"));
    game.press("<Enter>");
    assert_ne!(game.screen(), pack);
    game.press("z90<Enter>");
    assert_eq!(game.screen(), pack, "taken back");
    // A coin can be moved anywhere except onto another.
    game.press("p<Tab> <Right> ");
    assert!(panel(&mut game).contains(" mm "));
    assert!(panel(&mut game).contains("overlap"), "{}", panel(&mut game));
    game.press("<Up><Up><Up><Up><Up><Up><Up><Up> p");
    assert_ne!(game.screen(), pack);
    game.press("z");
    assert_eq!(game.screen(), pack);
}

#[test]
fn a_call_is_graded_separately_from_the_score() {
    let options = Options::two_people().with(|it| it.company.call = true);
    let mut game = at_the_table(options, still());
    game.press("]] ");
    assert!(game.screen().contains("call it: where to?"));
    game.press("6<Enter>6<Enter>");
    let shown = panel(&mut game);
    assert!(shown.contains("your call"), "{shown}");
    assert!(shown.contains("South's calls"), "{shown}");
    game.press("i<Enter><End>");
    let closer = game.screen();
    assert!(closer.contains("the hit, slowed"), "{closer}");
    assert!(
        closer.contains("striker on white") && closer.contains("you"),
        "{closer}"
    );
    game.press("<Escape><Escape><Enter>");
    let screen = game.screen();
    assert!(screen.contains("South 0 : 0 North"), "{screen}");
}

/// A game with calls against the computer, or between two people, saved in this folder.
fn calling(options: Options, folder: &Folder) -> Headless {
    let table = Table::playing(options.with(|it| it.company.call = true), SEED);
    let settings = Settings {
        player: "Mia".into(),
        ..still()
    };
    let app = App::on(Box::new(Hosted::new(table)), settings, 1);
    Headless::keeping(app, 120, 40, Store::in_folder(folder.path()))
}

#[test]
fn a_call_is_saved_as_an_answer_of_the_only_player() {
    let folder = Folder::new("table-call");
    let mut game = calling(Options::default(), &folder);
    game.press("]] ");
    assert!(game.attempts().is_empty());
    game.press("60<Enter>60<Enter>");
    // Another copy of carrom reads the same answer from the database.
    let mut again = calling(Options::default(), &folder);
    let answers = again.attempts();
    assert_eq!(answers, game.attempts());
    let [answer] = answers.as_slice() else {
        panic!("{answers:?}");
    };
    let of = (answer.player.as_str(), answer.family.as_str());
    assert_eq!(of, ("Mia", TABLE));
    assert_eq!((answer.number, answer.seed), (1, SEED));
    assert!(answer.topic.starts_with("heavier-striker"), "{answer:?}");
    assert!(answer.fault().is_none() && !answer.right);
    let printed = carrom::progress::json(&answers, &[], None, serde_json::Value::Null).unwrap();
    let printed: serde_json::Value = serde_json::from_str(&printed).unwrap();
    assert_eq!(printed["attempts"][0]["family"], "table");
    assert_eq!(printed["summary"]["calls"]["made"], 1);
    assert_eq!(printed["summary"]["calls"]["within_2_deg"], 0);
    assert!(printed["attempts"][0]["truth"]["theta2_deg"].is_f64());
    // A wrong call is due for review at once.
    let due = Due::of(&answers, &Calendar::utc(answer.time_s));
    assert_eq!(due.now, [Topic::with_id(answer.topic.clone())]);
}

#[test]
fn a_call_of_two_people_at_one_keyboard_is_nobodys_answer() {
    let folder = Folder::new("table-call-shared");
    let mut game = calling(Options::two_people(), &folder);
    game.press("]] 6<Enter>6<Enter>");
    assert!(game.attempts().is_empty());
}

#[test]
fn a_call_to_the_wrong_sides_is_shown_with_its_signs() {
    let called = |keys: &str| {
        let mut game = Headless::new(App::new(Route::Table, still(), 4), 120, 40);
        game.press("<Enter>c]]]]]] ");
        game.press(keys);
        panel(&mut game)
    };
    let wrong = called("-17.7<Enter>-19.2<Enter>");
    assert!(wrong.contains("your call 0 of 10"), "{wrong}");
    assert!(
        wrong.contains("striker -17.7 17.7 coin -19.2 19.2"),
        "{wrong}"
    );
    let right = called("17.7<Enter>19.2<Enter>");
    assert!(right.contains("your call 10 of 10"), "{right}");
    assert!(
        right.contains("striker 17.7 17.7 coin 19.2 19.2"),
        "{right}"
    );
}

#[test]
fn the_paths_stay_hidden_while_the_player_calls() {
    let all = Options::two_people();
    let without = all.clone().with(|it| it.company.aids.rays = false);
    let board = |options: &Options| {
        let screen = at_the_table(options.clone(), still()).screen();
        let rows: Vec<String> = screen
            .lines()
            .map(|row| row.chars().take(72).collect())
            .collect();
        rows
    };
    assert_ne!(board(&all), board(&without));
    let calling = all.with(|it| it.company.call = true);
    assert_eq!(board(&calling), board(&without));
}

#[test]
fn the_computer_plays_and_explains_its_stroke() {
    let mut game = at_the_table(Options::default(), still());
    // A soft break, after which it is the computer's turn.
    game.press(&"-".repeat(30));
    game.press(" <Enter>");
    let mut strokes = 0;
    for _ in 0..12 {
        let shown = panel(&mut game);
        if shown.contains("Computer:") {
            assert!(shown.contains("My stroke"), "{shown}");
            strokes += 1;
        }
        game.press("<Enter>");
        if game.screen().contains("your stroke") {
            game.press("h");
            assert!(
                panel(&mut game).contains("h: tell me more"),
                "{}",
                panel(&mut game)
            );
            game.press("h");
            assert!(panel(&mut game).contains("Place the striker"));
            break;
        }
    }
    assert!(strokes > 0);
}

/// Presses Space twelve times, or holds it, from the end of a stroke through the computer's stroke
/// into the next turn, and once more after a pause.
#[test]
fn a_key_press_that_continues_never_strikes() {
    for (between, presses) in [(350, 12), (33, 600)] {
        let mut game = at_the_table(Options::default(), Settings::default());
        game.press(&"-".repeat(30));
        game.press(" ");
        // A held key repeats after a delay, then at 30 Hz.
        let delay = if presses > 12 { 660 } else { between };
        for press in 0..presses {
            game.press(" ");
            let wait = if press == 0 { delay } else { between };
            game.pass(Duration::from_millis(wait));
        }
        let shown = panel(&mut game);
        let what = format!("every {between} ms: {shown}");
        assert!(game.screen().contains("your stroke"), "{what}");
        assert!(shown.contains("Too soon after the last press"), "{what}");
        game.pass(Duration::from_secs(2));
        let shown = panel(&mut game);
        assert!(!shown.contains("Too soon"), "{shown}");
        game.press(" ");
        assert!(game.screen().contains("stroke 3 of 3"), "{}", game.screen());
        // Another key shows at once that the strike key was released.
        let mut game = at_the_table(Options::two_people(), still());
        game.press(" <Enter> ");
        assert!(game.screen().contains("North's stroke"));
        game.press("<Right> ");
        assert!(game.screen().contains("stroke 2 of 2"), "{}", game.screen());
    }
}

#[test]
fn a_replay_left_on_the_computers_turn_waits_for_the_player() {
    let mut game = at_the_table(Options::default(), still());
    game.press(&"-".repeat(30));
    game.press(" v");
    assert!(game.screen().contains("stroke 1 of 1"));
    game.press("<Escape>");
    game.pass(Duration::from_secs(20));
    let screen = game.screen();
    assert!(screen.contains("stroke 1 of 1"), "{screen}");
    assert!(screen.contains("go on"), "{screen}");
    game.press("<Escape>");
    assert!(game.screen().contains("Leave this game?"));
}

#[test]
fn the_rules_of_the_game_are_read_from_its_set_up_and_its_help() {
    let opened = |keys: &str| {
        let mut game = Headless::new(App::new(Route::Table, still(), 1), 80, 24);
        game.press(keys);
        game
    };
    for (keys, title) in [
        ("r", "the rules: tournament"),
        ("<Right>r", "the rules: friendly"),
        ("<Right><Enter>?r", "the rules: friendly"),
        ("<Right><Right>r", "the rules: points"),
        ("<Enter>?r<Left>", "the rules: board of the day"),
        ("<Enter>?r<Left><Left>", "the rules: practice"),
    ] {
        let mut game = opened(keys);
        assert!(game.screen().contains(title), "{keys}: {}", game.screen());
    }
    let mut game = opened("<Enter>?r<Escape>");
    assert!(game.screen().contains("your stroke"), "{}", game.screen());
}

#[test]
fn leaving_a_running_game_is_confirmed_once() {
    let mut game = at_the_table(Options::two_people(), still());
    game.press(" <Enter><Escape>");
    assert!(game.screen().contains("Leave this game?"));
    game.press("x");
    assert!(
        game.screen().contains("Leave this game?"),
        "other keys do not answer"
    );
    game.press("<Escape>");
    assert!(!game.screen().contains("Leave this game?"));
    game.press("<Escape>y");
    assert!(game.screen().contains("a new game"));
}

/// The row for e is below the row for the pieces. The number chosen there applies to this game and
/// to the next one.
#[test]
fn the_restitution_of_a_new_game_is_chosen_on_its_page() {
    let mut game = Headless::new(App::new(Route::Table, still(), 1), 80, 24);
    game.press(&"<Down>".repeat(7));
    let chosen = |game: &mut Headless, e: &str| {
        let screen = game.screen();
        let mut rows = screen.lines().filter(|row| row.contains("> restitution e"));
        assert!(rows.any(|row| row.contains(e)), "{e}: {screen}");
    };
    chosen(&mut game, "1.00");
    game.press("<Left>");
    chosen(&mut game, "0.95");
    game.press("7<Enter>");
    assert!(game.screen().contains("from 0 to 1"), "{}", game.screen());
    game.press("0.8<Enter><Enter>");
    assert!(game.screen().contains("e = 0.80"), "{}", game.screen());
    game.press("<Escape>");
    game.press(&"<Down>".repeat(7));
    chosen(&mut game, "0.80");
    // The rows above and below it still change with the keys.
    game.press("<Up><Right><Down><Down><Right>");
    let page = game.screen();
    let row = |name: &str, value: &str| {
        let mut rows = page.lines().filter(|row| row.contains(name));
        rows.any(|row| row.contains(value))
    };
    assert!(row("  pieces", "15 g on 15 g"), "{page}");
    assert!(row("> call it", " on "), "{page}");
}

#[test]
fn a_stroke_is_animated_and_then_nothing_moves() {
    let mut game = at_the_table(Options::two_people(), Settings::default());
    assert_eq!(game.app().wake(), None);
    game.press(" ");
    assert!(game.app().wake().is_some());
    game.pass(Duration::from_millis(500));
    assert!(game.screen().contains("0.50 s"));
    game.press(",,");
    assert_eq!(game.app().wake(), None, "a step pauses the replay");
    game.press(" ");
    assert!(game.settle(Duration::from_secs(120)));
    assert!(panel(&mut game).contains("(law"));
}

/// One thing that may happen at the table.
#[derive(Debug, Clone)]
enum Act {
    Tell(Input),
    Resize(u16, u16),
    Pass(u64),
}

fn act() -> impl Strategy<Value = Act> {
    use Key::*;
    let named = vec![
        Up, Down, Left, Right, Enter, Enter, Escape, Tab, PageUp, PageDown, Home, End,
    ];
    let kinds = vec![
        MouseKind::Down,
        MouseKind::Drag,
        MouseKind::Up,
        MouseKind::ScrollUp,
        MouseKind::ScrollDown,
    ];
    let typed = " []{}+-=,.<>0123456789iaczhplgrobqxwsdM";
    let typed: Vec<char> = typed.chars().collect();
    let tell = |key| Act::Tell(Input::Key(key));
    prop_oneof![
        8 => prop::sample::select(typed).prop_map(move |c| tell(Char(c))),
        4 => Just(tell(Char(' '))),
        6 => prop::sample::select(named).prop_map(tell),
        4 => (prop::sample::select(kinds), 0..130u16, 0..50u16).prop_map(
            |(kind, column, row)| Act::Tell(Input::Mouse(Mouse::over(kind, (column, row))))
        ),
        1 => (0..=300u16, 0..=100u16).prop_map(|(columns, rows)| Act::Resize(columns, rows)),
        1 => Just(Act::Resize(80, 24)),
        2 => (0..3000u64).prop_map(Act::Pass),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(12, 48)))]

    #[test]
    fn nothing_that_is_typed_at_the_table_makes_it_panic(
        rules in prop::sample::select(vec![
            Rules::Tournament,
            Rules::Friendly,
            Rules::Points,
            Rules::Practice,
        ]),
        hand in prop::sample::select(PlayerHand::ALL.to_vec()),
        length in prop::sample::select(vec![Length::Board, Length::Game, Length::Match]),
        computer: bool,
        call: bool,
        unicode: bool,
        acts in prop::collection::vec(act(), 1..80),
    ) {
        let players = if computer { Options::default() } else { Options::two_people() };
        let options = players.with(|it| {
            (it.setup.rules, it.setup.length) = (rules, length);
            (it.company.hand, it.company.call) = (hand, call);
        });
        let charset = if unicode { Charset::Unicode } else { Charset::Ascii };
        let mut game = at_the_table(options, Settings { charset, ..Settings::default() });
        for act in &acts {
            match act {
                Act::Tell(input) => game.input(input),
                Act::Resize(columns, rows) => game.resize(*columns, *rows),
                Act::Pass(ms) => game.pass(Duration::from_millis(*ms)),
            }
            let screen = game.screen();
            // Random keys may leave the table and change the charset in the settings.
            let unicode = game.app().settings().charset == Charset::Unicode;
            prop_assert!(unicode || screen.is_ascii());
            prop_assert!(!screen.contains("NaN"));
        }
    }
}

/// The cell of the screen at a position on the board, in millimetres from its middle, on a screen
/// of 80 × 24: the board is drawn in 39 columns and 20 rows from column 1, row 2.
fn cell(x_mm: f64, y_mm: f64) -> (u16, u16) {
    let column = 1.0 + 19.0 + x_mm / 740.0 * 38.0;
    let row = 2.0 + 9.5 - y_mm / 740.0 * 19.0;
    (column.round() as u16, row.round() as u16)
}

fn small(options: Options) -> Headless {
    let table = Table::playing(options, SEED);
    rested(Headless::new(
        App::on(Box::new(Hosted::new(table)), still(), 1),
        80,
        24,
    ))
}

#[test]
fn the_striker_is_pulled_back_and_released() {
    let mut game = small(Options::two_people());
    let striker = cell(0.0, -252.6);
    // A pull straight back keeps the aim.
    game.click(cell(100.0, 200.0));
    let aim = |game: &mut Headless| {
        let screen = game.screen();
        let row = screen.lines().find(|row| row.contains("aim "));
        row.map(str::to_owned).unwrap_or_default()
    };
    let pointed = aim(&mut game);
    assert!(!pointed.contains("90.0"), "{pointed}");
    let back = (striker.0, striker.1 + 3);
    game.mouse(MouseKind::Down, striker);
    game.mouse(MouseKind::Drag, back);
    assert!(
        game.screen().contains("Let go to strike."),
        "{}",
        game.screen()
    );
    assert_eq!(aim(&mut game), pointed);
    let near = game.screen();
    game.mouse(MouseKind::Drag, (striker.0, striker.1 + 4));
    assert_ne!(game.screen(), near, "farther is harder");
    // A pull a little to the side keeps the aim; a pull far to the side turns it.
    game.mouse(MouseKind::Drag, (striker.0 + 3, striker.1 + 4));
    assert_eq!(aim(&mut game), pointed);
    game.mouse(MouseKind::Drag, (striker.0 + 14, striker.1 + 3));
    let turned = aim(&mut game);
    assert_ne!(turned, pointed);
    // A release at the striker makes no stroke, and neither does Escape.
    game.mouse(MouseKind::Drag, striker);
    game.mouse(MouseKind::Up, striker);
    assert_eq!(aim(&mut game), pointed);
    game.mouse(MouseKind::Down, striker);
    game.mouse(MouseKind::Drag, back);
    game.press("<Escape>");
    assert_eq!(aim(&mut game), pointed);
    game.mouse(MouseKind::Drag, back);
    game.mouse(MouseKind::Up, back);
    assert!(
        !game.screen().contains("stroke 1 of 1"),
        "{}",
        game.screen()
    );
    // A release far enough back makes the stroke, even below the board.
    game.mouse(MouseKind::Down, striker);
    game.mouse(MouseKind::Drag, (striker.0, 23));
    game.mouse(MouseKind::Up, (striker.0, 23));
    assert!(game.screen().contains("stroke 1 of 1"), "{}", game.screen());
}

#[test]
fn north_pulls_upwards() {
    let mut game = small(Options::two_people());
    game.press("10]3.2+97.61 <Enter>");
    assert!(
        game.screen().contains("North's stroke"),
        "{}",
        game.screen()
    );
    let striker = cell(0.0, 252.6);
    game.mouse(MouseKind::Down, striker);
    game.mouse(MouseKind::Drag, (striker.0, 0));
    game.mouse(MouseKind::Up, (striker.0, 0));
    assert!(game.screen().contains("stroke 2 of 2"), "{}", game.screen());
}

#[test]
fn in_practice_the_striker_is_moved_and_pulled_by_the_mouse() {
    let options = Options::default().with(|it| it.setup.rules = Rules::Practice);
    let mut game = small(options);
    game.drag(cell(0.0, -252.6), cell(-200.0, -150.0));
    assert!(
        !game.screen().contains("stroke 1 of 1"),
        "{}",
        game.screen()
    );
    assert!(game.screen().contains("-195, "), "{}", game.screen());
    let at = cell(-200.0, -150.0);
    game.drag(at, (at.0, at.1 + 4));
    assert!(game.screen().contains("stroke 1 of 1"), "{}", game.screen());
}

/// Plays a game against the computer to its end, with `strike` for each of the player's strokes and
/// `go_on` to continue.
fn whole_game(
    strength: Strength,
    strike: impl Fn(&mut Headless, &mut Pcg64),
    go_on: impl Fn(&mut Headless),
) {
    let options = Options::default().with(|it| {
        it.company.strengths = [strength; 4];
        it.setup.length = Length::Match;
    });
    let mut game = small(options);
    let mut chance = Pcg64::seed_from_u64(9);
    for _ in 0..4000 {
        let screen = game.screen();
        let ended = screen.contains("games before this") && screen.contains("the game");
        if ended {
            game.press("<PageDown>");
            assert!(game.screen().contains("pocketing"), "{}", game.screen());
            return;
        }
        if screen.contains("your stroke") {
            strike(&mut game, &mut chance);
        } else {
            go_on(&mut game);
            game.pass(Duration::from_secs(2));
        }
    }
    panic!(
        "the game against the {strength} never ended:\n{}",
        game.screen()
    );
}

#[test]
fn a_whole_game_against_each_strength_is_played_by_mouse_alone() {
    for strength in Strength::ALL {
        let pull = |game: &mut Headless, chance: &mut Pcg64| {
            // Point anywhere up the board, then pull back from the striker's position.
            let at = cell(
                chance.random_range(-300.0..300.0),
                chance.random_range(-100.0..300.0),
            );
            game.click(at);
            let row = cell(0.0, -252.6).1;
            let column = (2..39).find(|column| game.buffer()[(*column, row)].symbol() == "S");
            let striker = (column.unwrap_or(20), row);
            game.drag(striker, (striker.0, row + chance.random_range(3..6)));
        };
        whole_game(strength, pull, |game| game.click(cell(0.0, 0.0)));
    }
}

#[test]
fn a_whole_game_against_each_strength_is_played_by_keys_alone() {
    for strength in Strength::ALL {
        let strike = |game: &mut Headless, chance: &mut Pcg64| {
            let turns = chance.random_range(0..60);
            let way = if chance.random() { "<Left>" } else { "<Right>" };
            game.press(&way.repeat(turns));
            game.press(" ");
        };
        whole_game(strength, strike, |game| game.press("<Enter>"));
    }
}

#[test]
fn a_stroke_that_is_too_soft_is_distinguished_from_a_miss() {
    let mut game = small(Options::two_people());
    game.press(&"-".repeat(60));
    assert!(
        game.screen().contains("too soft to reach the white"),
        "{}",
        game.screen()
    );
    game.press("0<Enter>");
    assert!(game.screen().contains("no hit"), "{}", game.screen());
    game.press(" ");
    assert!(game.settle(Duration::from_secs(60)));
    let screen = game.screen();
    assert!(screen.contains("Space: go on."), "{screen}");
    assert!(!screen.contains("the impacts"), "{screen}");
}

#[test]
fn hints_are_counted_shown_at_the_end_and_saved_with_the_game() {
    let mut game = small(whole_match());
    for _ in 0..200 {
        let screen = game.screen();
        if screen.contains("The board goes to") {
            let told = screen.replace(['|', '\n'], " ");
            assert!(told.contains("hint"), "{screen}");
            assert!(screen.contains("b best stroke"), "{screen}");
            game.press("b");
            assert!(game.screen().contains("stroke "), "{}", game.screen());
            assert!(
                !game.screen().contains("The board goes to"),
                "{}",
                game.screen()
            );
            return;
        }
        match screen.contains("aim ") {
            true => game.press("hhh "),
            false => game.press("<Enter>"),
        }
    }
    panic!("the board never ended:\n{}", game.screen());
}

/// Saves a stroke that Mia plays against the computer, and one that Bo plays in practice.
fn played(folder: &Folder) {
    let mia = Options::default().with(|it| {
        it.setup.rules = Rules::Friendly;
        it.setup.restitution = 0.85;
    });
    let bo = Options::default().with(|it| it.setup.rules = Rules::Practice);
    for (player, options) in [("Mia", mia), ("Bo", bo)] {
        let settings = Settings {
            player: player.into(),
            ..still()
        };
        let table = Hosted::new(Table::playing(options, SEED));
        let app = App::on(Box::new(table), settings, 1);
        let store = Store::in_folder(folder.path());
        let mut game = Headless::keeping(app, 120, 40, store);
        game.pass(Duration::from_secs(2));
        game.press(" ");
    }
}

/// The page of a new game, after a restart.
fn new_game(player: &str, folder: &Folder) -> String {
    let settings = Settings {
        player: player.into(),
        ..still()
    };
    let app = App::new(Route::Table, settings, 1);
    Headless::keeping(app, 120, 40, Store::in_folder(folder.path())).screen()
}

#[test]
fn the_setup_of_each_players_last_game_is_kept_over_a_restart() {
    let folder = Folder::new("table-setup");
    played(&folder);
    let head = |player| new_game(player, &folder).lines().next().unwrap().to_owned();
    let mia = head("Mia");
    assert!(
        mia.contains("friendly") && mia.contains("e = 0.85"),
        "{mia}"
    );
    assert!(head("Bo").contains("practice"), "{}", head("Bo"));
    assert!(head("Cy").contains("tournament"), "{}", head("Cy"));
    // A damaged game is left out, and the usual options return.
    for entry in std::fs::read_dir(folder.path().join("games")).unwrap() {
        std::fs::write(entry.unwrap().path(), "format = 2\n").unwrap();
    }
    assert!(head("Mia").contains("tournament"), "{}", head("Mia"));
}

/// The computers' game in `tests/saves`, with a person in the winner's or the loser's seat.
#[test]
fn boards_won_and_lost_are_counted_by_rules_and_strength() {
    let bytes = include_bytes!("../saves/board-over-1.toml");
    let (saved, game) = SavedGame::read("board-over-1.toml", bytes).unwrap();
    let winner = game.play().won.unwrap().winner;
    for (seat, team) in [(Seat::South, Team::First), (Seat::North, Team::Second)] {
        let folder = Folder::new("table-results");
        let mut store = Store::in_folder(folder.path());
        let mut mia = saved.clone();
        mia.player = "Mia".into();
        mia.company.players[seat as usize] = Player::Person;
        for ticket in [1, 2] {
            let request = StoreRequest::Save(FileContent::Game(Box::new(mia.clone())));
            store.answer(&StoreCall { ticket, request });
        }
        let page = new_game("Mia", &folder);
        let score = if team == winner { "2 : 0" } else { "0 : 2" };
        let row = { page.lines() }.find(|line| line.contains("friendly, club player"));
        assert!(row.unwrap().contains(score), "{page}");
        assert!(page.contains("longest turn"), "{page}");
        assert!(!new_game("Bo", &folder).contains("longest turn"));
    }
}

/// The options of point carrom for one board, with a club hand.
fn club_hand() -> Options {
    Options::default().with(|options| {
        options.setup.rules = Rules::Points;
        options.company.hand = PlayerHand::Club;
    })
}

#[test]
fn the_length_and_the_hand_are_chosen_on_the_page_of_a_new_game() {
    let mut game = Headless::new(App::new(Route::Table, still(), 1), 120, 40);
    let row = |game: &mut Headless, name: &str| {
        let page = game.screen();
        let row = page.lines().find(|line| line.contains(name));
        row.unwrap_or_else(|| panic!("{name}: {page}")).to_owned()
    };
    assert!(row(&mut game, "  your hand").contains("exact"));
    assert!(row(&mut game, "  length").contains("one board, about"));
    game.press(&"<Down>".repeat(4));
    game.press("<Left>");
    assert!(row(&mut game, "> your hand").contains("club"));
    assert!(
        game.screen().contains("within 1.0 deg"),
        "{}",
        game.screen()
    );
    game.press("<Down>");
    let minutes = |row: &str| {
        let about = row.split("about ").nth(1).unwrap_or_default();
        about
            .split(' ')
            .next()
            .unwrap_or_default()
            .parse::<u32>()
            .unwrap()
    };
    let board = minutes(&row(&mut game, "> length"));
    game.press("<Right>");
    let one_game = row(&mut game, "> length");
    assert!(one_game.contains("one game"), "{one_game}");
    game.press("<Right>");
    let whole = row(&mut game, "> length");
    assert!(whole.contains("match"), "{whole}");
    assert!(board < minutes(&one_game) && minutes(&one_game) < minutes(&whole));
    game.press("<Enter>");
    assert!(
        panel(&mut game).contains("+- 1.0 deg, +- 10 %"),
        "{}",
        game.screen()
    );
    assert!(
        game.screen().contains("so b varies by"),
        "{}",
        game.screen()
    );
}

/// The page of a new game between two people, with the row of South's name chosen.
fn two_people(folder: &Folder) -> Headless {
    let app = App::new(Route::Table, still(), 1);
    let mut game = Headless::keeping(app, 120, 40, Store::in_folder(folder.path()));
    game.press("<Down><Down><Down>");
    for _ in 0..6 {
        let page = game.screen();
        let row = page.lines().find(|line| line.contains("> North"));
        if row.unwrap().contains("a person") {
            game.press("<Down>");
            return game;
        }
        game.press("<Right>");
    }
    panic!("{}", game.screen());
}

#[test]
fn a_moving_board_for_one_player_counts_only_its_own_coins() {
    let code = BoardCode::parse("2026-11-26").ok();
    let settings = Settings {
        reduced_motion: false,
        ..still()
    };
    let mut game = Headless::new(App::new(Route::Board(code), settings, 1), 120, 40);
    game.press("<Enter>");
    let mut game = rested(game);
    game.press(" ");
    game.pass(Duration::from_millis(200));
    let shown = panel(&mut game);
    assert!(
        shown.contains("struck by") && shown.contains("white o 6"),
        "{shown}"
    );
    assert!(!shown.contains("queen"), "{shown}");
}

#[test]
fn the_page_of_a_new_game_fits_into_80_by_24() {
    for charset in [Charset::Ascii, Charset::Unicode] {
        let settings = Settings { charset, ..still() };
        let mut game = Headless::new(App::new(Route::Table, settings, 1), 80, 24);
        for (keys, prompt) in [
            ("", "s: saved games"),
            ("<Down><Down><Down><Left><Left>", "s: saved games"),
            ("<Down>", "Enter: next"),
        ] {
            game.press(keys);
            let page = game.screen();
            assert!(page.contains(prompt), "{page}");
            assert!(!page.contains("PageDown"), "{page}");
        }
    }
}

#[test]
fn two_people_at_one_keyboard_have_names_which_are_kept() {
    let folder = Folder::new("table-names");
    let mut game = two_people(&folder);
    // Letters that are keys elsewhere on the page, and a space, belong to the name.
    game.press("Bos  Ra<Enter>Mia<Enter>");
    let page = game.screen();
    assert!(page.contains("South's name Bos  Ra"), "{page}");
    assert!(page.contains("> your hands"), "{page}");
    game.press("<Enter>");
    let screen = game.screen();
    assert!(screen.contains("Bos Ra 0 : 0 Mia"), "{screen}");
    assert!(screen.contains("Bos Ra's stroke"), "{screen}");
    assert!(panel(&mut game).contains("Bos Ra breaks, white"));
    rested(game).press("- ");
    // The next game between two people has the same names, even after a game against the computer.
    let mut next = two_people(&folder);
    assert!(
        next.screen().contains("South's name Bos Ra_"),
        "{}",
        next.screen()
    );
    next.press("<Up><Right><Enter>");
    rested(next).press("- ");
    let mut next = two_people(&folder);
    next.press("<Down>");
    assert!(
        next.screen().contains("North's name Mia_"),
        "{}",
        next.screen()
    );
    // The page of saved games names both people.
    next.press("<Up><Up>s<Down>");
    let saved = next.screen();
    assert!(saved.contains("Bos Ra 0 : 0 Mia"), "{saved}");
    let turns = ["It is Bos Ra's", "It is Mia's"];
    assert!(turns.iter().any(|turn| saved.contains(turn)), "{saved}");
}

#[test]
fn names_are_short_visible_and_differ() {
    let folder = Folder::new("table-odd-names");
    let mut game = two_people(&folder);
    let pasted = "\u{1b}[31mAnna\nMaria\u{202e}Josefina";
    game.input(&Input::Paste(pasted.into()));
    game.press("<Enter> anna<Enter><Enter>");
    let screen = game.screen();
    assert!(screen.contains("[31mAnnaMari"), "{screen}");
    assert!(!screen.contains(['\u{1b}', '\u{202e}']), "{screen}");
    // Names that differ only in case are refused, even if one of them is the usual name of the
    // other seat.
    for names in ["Ada<Enter>ADA", "north<Enter>"] {
        let mut game = two_people(&folder);
        game.press(names);
        game.press("<Down><Enter>");
        let screen = game.screen();
        assert!(screen.contains("Both players are called"), "{screen}");
        game.press("<Up><Up>");
        game.press("x<Down><Down><Enter>");
        assert!(game.screen().contains("'s stroke"), "{}", game.screen());
    }
}

#[test]
fn a_board_between_two_named_people_is_reported_with_their_names() {
    let bytes = include_bytes!("../saves/board-over-1.toml");
    let (mut saved, game) = SavedGame::read("board-over-1.toml", bytes).unwrap();
    saved.company.players = [Player::Person; 4];
    saved.company.names.set(Seat::South, "Ada");
    saved.company.names.set(Seat::North, "Bo");
    let folder = Folder::new("table-named-end");
    let mut store = Store::in_folder(folder.path());
    let request = StoreRequest::Save(FileContent::Game(Box::new(saved)));
    store.answer(&StoreCall { ticket: 1, request });
    let app = App::new(Route::Table, still(), 1);
    let mut screen = Headless::keeping(app, 120, 40, store);
    screen.press("s<Enter>");
    let shown = panel(&mut screen);
    let winner = match game.play().won.unwrap().winner {
        Team::First => "Ada",
        Team::Second => "Bo",
    };
    assert!(
        shown.contains(&format!("{winner} wins the board!")),
        "{shown}"
    );
    assert!(shown.contains("Ada : Bo"), "{shown}");
    let screen = screen.screen();
    assert!(
        !screen.contains("South") && !screen.contains("North"),
        "{screen}"
    );
}

#[test]
fn an_unsteady_hand_slips_the_same_way_in_every_replay_and_saved_game() {
    let folder = Folder::new("table-hand");
    let played = |folder: &Folder| {
        let table = Hosted::new(Table::playing(club_hand(), SEED));
        let app = App::on(Box::new(table), still(), 1);
        let mut game = Headless::keeping(app, 120, 40, Store::in_folder(folder.path()));
        game.pass(Duration::from_secs(2));
        game.press(" ");
        game
    };
    let mut game = played(&folder);
    let told = panel(&mut game);
    assert!(told.contains("Your stroke was"), "{told}");
    let file = folder.path().join("games/game-1.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    let (saved, _) = SavedGame::read("game", text.as_bytes()).unwrap();
    assert_eq!(saved.company.hand, PlayerHand::Club);
    let struck = saved.record.moves.to_vec();
    let Move::Strike(strike) = &struck[0] else {
        panic!("{struck:?}");
    };
    assert!(
        strike.velocity.x != 0.0,
        "aimed at 90°, but the hand slipped"
    );
    let errors = PlayerHand::Club.errors().unwrap();
    assert!(strike.velocity.x.abs() < 6.0 * errors.direction * strike.velocity.y);
    // Another copy of carrom plays the same stroke, to the last bit.
    let again = Folder::new("table-hand-again");
    played(&again);
    assert_eq!(
        std::fs::read_to_string(again.path().join("games/game-1.toml")).unwrap(),
        text
    );
    // With an exact hand, the stroke goes exactly where it was aimed.
    let options = club_hand().with(|it| it.company.hand = PlayerHand::Exact);
    let mut exact = at_the_table(options, still());
    exact.press(" ");
    assert!(!panel(&mut exact).contains("Your stroke was"));
    // The saved game explains the error again.
    let app = App::new(Route::Table, still(), 1);
    let mut resumed = Headless::keeping(app, 120, 40, Store::in_folder(folder.path()));
    resumed.press("s<Enter>");
    resumed.press("<Enter>");
    resumed.press("v<End>");
    let told_again = panel(&mut resumed);
    let words = |panel: &str| {
        let at = panel.find("Your stroke was").unwrap();
        panel[at..].chars().take(40).collect::<String>()
    };
    assert_eq!(words(&told_again), words(&told));
}

#[test]
fn a_call_with_an_unsteady_hand_is_about_the_actual_stroke_and_cannot_be_aimed_again() {
    let options = club_hand().with(|it| it.company.call = true);
    let mut game = at_the_table(options.clone(), still());
    game.press("]] ");
    assert!(
        game.screen().contains("Where will they go?"),
        "{}",
        game.screen()
    );
    game.press("<Escape>");
    assert!(game.screen().contains("Leave this game?") || game.screen().contains("a new game"));
    let options = options.with(|it| it.company.hand = PlayerHand::Exact);
    let mut exact = at_the_table(options, still());
    exact.press("]] <Escape>");
    assert!(exact.screen().contains("your stroke"), "{}", exact.screen());
}

#[test]
fn one_board_of_points_carrom_is_played_with_hints_to_its_end() {
    let mut game = small(club_hand());
    for _ in 0..300 {
        let screen = game.screen();
        if screen.contains("win the board") || screen.contains("wins the board") {
            assert!(screen.contains("The board is won by"), "{screen}");
            assert!(screen.contains("Best stroke: number"), "{screen}");
            assert!(screen.contains("a new game"), "{screen}");
            return;
        }
        match screen.contains("aim ") {
            true => {
                assert!(screen.contains("points to 17"), "{screen}");
                assert!(!screen.contains("You break, white"), "{screen}");
                game.press("hhh ");
            }
            false => game.press("<Enter>"),
        }
    }
    panic!("the board never ended:\n{}", game.screen());
}

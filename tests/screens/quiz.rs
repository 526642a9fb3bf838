//! The quiz on the screen: whole rounds played by keys and by the mouse.

use std::time::Duration;

use carrom::app::App;
use carrom::messages::{Input, Key, Mouse, MouseKind};
use carrom::quiz::misconceptions::OF_RAYS as ALL;
use carrom::quiz::{Answer, Code, Confidence, Form, Question, Rays, Response, Round, explain};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::widgets::{Charset, SplitLayout};
use proptest::prelude::*;
use ratatui::layout::Rect;

use crate::thorough::cases;

const LONG: Duration = Duration::from_secs(120);

fn quiz(seed: u64, charset: Charset, (columns, rows): (u16, u16)) -> Headless {
    let settings = Settings {
        charset,
        ..Settings::default()
    };
    let place = Route::Quiz(Some(Code::hits(seed)));
    Headless::new(App::new(place, settings, seed), columns, rows)
}

fn plain(seed: u64) -> Headless {
    quiz(seed, Charset::Ascii, (80, 24))
}

/// The true directions of both discs.
fn truth(question: &Question) -> Rays {
    match question.form.truth() {
        Response::Rays(rays) => rays,
        other => panic!("not rays: {other:?}"),
    }
}

/// The answer that a misconception leads to, if it applies to the question.
fn held(question: &Question, i: usize) -> Option<Rays> {
    let belief = |it: &&carrom::quiz::WrongAnswer| it.misconception == ALL[i];
    match question.beliefs.iter().find(belief)?.said {
        Response::Rays(rays) => Some(rays),
        _ => None,
    }
}

/// The keys that answer with these rays, as a player would type them.
fn keys(question: &Question, rays: &Rays) -> String {
    let Form::Rays { side, .. } = question.form else {
        panic!("not rays: {question:?}");
    };
    [rays.striker, rays.target]
        .map(|angle| match angle {
            None => "x<Enter>".into(),
            Some(angle) => {
                format!("{:.1}<Enter>", side * angle.to_degrees())
            }
        })
        .concat()
}

/// Answers the question on the screen and waits for the outcome.
fn answer(game: &mut Headless, question: &Question, rays: &Rays, confidence: &str) {
    game.press(&keys(question, rays));
    game.press(confidence);
    assert!(game.settle(LONG));
}

/// The words in a part of the screen, separated by single spaces.
fn region(game: &mut Headless, area: Rect) -> String {
    let buffer = game.buffer();
    let mut text = String::new();
    for row in area.rows() {
        for position in row.positions() {
            text += buffer.cell(position).unwrap().symbol();
        }
        text += " ";
    }
    words(&text)
}

/// The words in the panel beside the picture.
fn panel(game: &mut Headless, (columns, rows): (u16, u16)) -> String {
    region(
        game,
        SplitLayout::new(Rect::new(0, 1, columns, rows - 2)).panel,
    )
}

fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// An answer far from every right answer and from the answer of every misconception.
const WILD: Rays = Rays::new(-1.3, -1.3);

#[test]
fn a_round_of_right_answers_earns_all_points() {
    for seed in [0, 7, 42] {
        let mut game = plain(seed);
        for (i, question) in Round::of(Code::hits(seed)).questions().iter().enumerate() {
            let screen = game.screen();
            let place = format!("question {} of 10  {i} right", i + 1);
            let place = place.replace(" 00.0", " 0.0");
            assert!(screen.contains(&place), "{place}\n{screen}");
            answer(&mut game, question, &truth(question), "3");
            let screen = game.screen();
            assert!(screen.contains("10.0 of 10 points"), "{screen}");
            assert!(screen.contains("100 %"), "{screen}");
            assert!(panel(&mut game, (80, 24)).contains(" right Right, and this is why."));
            game.press("<Enter>");
        }
        let screen = game.screen();
        assert!(
            screen.contains("10 of 10 right") && screen.contains("100.0 of 100 points"),
            "{screen}"
        );
        assert!(screen.contains("Sure 10 times: 10 right."), "{screen}");
        assert!(screen.contains(&format!("code {seed}")), "{screen}");
        assert!(!screen.contains("but wrong"), "{screen}");
    }
}

/// For every misconception, the screen shows its name and the whole explanation. Rounds in ASCII
/// and in Unicode alternate.
#[test]
fn every_misconception_is_named_and_fully_explained() {
    let mut met = [0; ALL.len()];
    for seed in 0..60 {
        let charset = [Charset::Ascii, Charset::Unicode][seed as usize % 2];
        let mut game = quiz(seed, charset, (80, 24));
        for question in Round::of(Code::hits(seed)).questions() {
            let (i, rays) = ALL
                .into_iter()
                .enumerate()
                .filter_map(|(i, _)| Some((i, held(question, i)?)))
                .min_by_key(|(i, _)| met[*i])
                .unwrap();
            met[i] += 1;
            answer(&mut game, question, &rays, "2");
            // The prediction is typed to a tenth of a degree.
            let tenth = |angle: f64| (angle.to_degrees() * 10.0).round() / 10.0;
            let rays = Rays {
                striker: rays.striker.map(|a| tenth(a).to_radians()),
                target: rays.target.map(|a| tenth(a).to_radians()),
            };
            let confidence = Confidence::ThinkSo;
            let explanation = explain(question, &Answer::new(Response::Rays(rays), confidence));
            let expected = format!("{} {}", ALL[i].name(), explanation.text);
            let expected = words(&charset.text(&expected));
            let shown = panel(&mut game, (80, 24));
            assert!(shown.contains(&expected), "{expected}\n{}", game.screen());
            game.press("<Enter>");
        }
        let screen = game.screen();
        assert!(!screen.contains("NaN"), "{screen}");
    }
    assert!(met.iter().all(|count| *count > 0), "{met:?}");
}

#[test]
fn a_misconception_held_throughout_is_named_at_the_end() {
    let mut game = plain(7);
    for question in Round::of(Code::hits(7)).questions() {
        let copied = held(question, 0);
        answer(&mut game, question, &copied.unwrap_or(truth(question)), "3");
        game.press("<Enter>");
    }
    let screen = game.screen();
    assert!(
        screen.contains(
            "It showed in 9 of 9 answers that could show it: impact angle used for both."
        ),
        "{screen}"
    );
    assert!(screen.contains("! sure, but wrong"), "{screen}");
    assert!(screen.contains("change the offset"), "{screen}");
}

#[test]
fn a_disc_that_stays_still_is_described_in_words() {
    let mut game = plain(7);
    let mut met = 0;
    for question in Round::of(Code::hits(7)).questions() {
        let truth = truth(question);
        answer(&mut game, question, &truth, "3");
        if truth.striker.is_none() {
            met += 1;
            let shown = panel(&mut game, (80, 24));
            assert!(shown.contains("striker still still 0.0"), "{shown}");
        }
        game.press("<Enter>");
    }
    assert_eq!(met, 1);
    assert!(
        game.screen().contains("rest    0     rest    0"),
        "{}",
        game.screen()
    );
}

#[test]
fn confidence_is_given_by_digit_by_arrows_or_by_the_mouse() {
    let question = Round::of(Code::hits(7)).questions()[0].clone();
    let rows = [("guess", 5), ("think so", 6), ("sure", 7)];
    for (sure, points) in [7, 9, 10].into_iter().enumerate() {
        let (name, _) = rows[sure];
        let expected = format!("{points}.0 of 10 points {name}");
        let digit = (sure + 1).to_string();
        let arrows = [
            "<Up><Up><Enter>",
            "<Down><Up><Enter>",
            "<Down><Down><Down><Enter>",
        ][sure];
        for presses in [digit.as_str(), arrows] {
            let mut game = plain(7);
            answer(&mut game, &question, &truth(&question), presses);
            assert!(
                panel(&mut game, (80, 24)).starts_with(&expected),
                "{presses}"
            );
        }
        let mut game = plain(7);
        game.press(&keys(&question, &truth(&question)));
        let line = game
            .screen()
            .lines()
            .position(|line| line.contains(&format!("{} {name}", sure + 1)));
        game.click((60, line.unwrap() as u16));
        assert!(game.settle(LONG));
        assert!(panel(&mut game, (80, 24)).starts_with(&expected), "click");
    }
}

#[test]
fn the_mouse_turns_the_rays() {
    let mut game = plain(7);
    let angle = |game: &mut Headless, name: &str| -> f64 {
        let shown = panel(game, (80, 24));
        let after = shown.split_once(&format!("{name} ")).unwrap().1;
        let after = after
            .rsplit_once(&format!("{name} "))
            .map_or(after, |(_, last)| last);
        after.split(' ').next().unwrap().parse().unwrap()
    };
    // The striker moves from left to right, and the coin lies above its path, so the coin's ray is
    // the upper one.
    game.drag((43, 9), (33, 3));
    let coin = angle(&mut game, "> coin");
    assert!((30.0..85.0).contains(&coin), "{coin}");
    assert!(coin.fract().abs() < 1e-9, "whole degrees");
    game.drag((35, 13), (30, 20));
    let striker = angle(&mut game, "> striker");
    assert!((30.0..85.0).contains(&striker), "{striker}");
}

#[test]
fn points_are_added_only_after_the_outcome_is_shown() {
    let question = Round::of(Code::hits(7)).questions()[0].clone();
    let mut game = plain(7);
    game.press(&keys(&question, &truth(&question)));
    game.press("3");
    assert!(game.screen().contains("question 1 of 10  0 right"));
    assert!(!panel(&mut game, (80, 24)).contains("of 10 points"));
    // Neither Space nor Enter shows the outcome at once: they step through the explanation.
    game.press("<Enter> <Enter>");
    assert!(!panel(&mut game, (80, 24)).contains("of 10 points"));
    game.press("<End>");
    assert!(game.screen().contains("question 1 of 10  1 right"));
    assert!(panel(&mut game, (80, 24)).contains("10.0 of 10 points sure"));
    // If the collision is replayed, the outcome stays visible.
    game.press("a");
    assert!(panel(&mut game, (80, 24)).contains("10.0 of 10 points sure"));
    game.press("<Enter>");
    assert!(game.screen().contains("question 2 of 10  1 right"));
}

#[test]
fn escape_goes_back_a_step_and_asks_before_a_round_is_lost() {
    let mut game = plain(7);
    game.press("4<Escape>");
    assert!(
        game.screen().contains("question 1"),
        "Escape first discards a typed number"
    );
    game.press("30<Enter>50<Enter>");
    assert!(game.screen().contains("How sure"));
    game.press("<Escape>");
    let shown = panel(&mut game, (80, 24));
    assert!(
        shown.contains("striker 30.0 deg > coin 50.0 deg"),
        "{shown}"
    );
    game.press("<Enter>1");
    assert!(game.settle(LONG));
    for _ in 0..2 {
        game.press("<Escape>");
        assert!(game.screen().contains("Leave the round?"));
        game.press("n");
        assert!(!game.screen().contains("Leave the round?"));
    }
    game.press("<Enter><Escape>");
    assert!(game.screen().contains("question 2"));
    assert!(game.screen().contains("Leave the round?"));
    game.press("y");
    assert!(game.screen().contains("choose a round"));
}

#[test]
fn negative_points_are_shown_with_their_sign() {
    let mut game = plain(7);
    let round = Round::of(Code::hits(7));
    let questions = round.questions();
    // Both rays point almost straight back, so neither is nearly right.
    answer(&mut game, &questions[0], &Rays::new(-3.0, -3.0), "2");
    let screen = game.screen();
    assert!(screen.contains("-2.0 of 10 points"), "{screen}");
    game.press("<Enter>");
    let right = truth(&questions[1]);
    answer(&mut game, &questions[1], &right, "3");
    let screen = game.screen();
    assert!(screen.contains("question 2 of 10  1 right"), "{screen}");
}

#[test]
fn a_round_without_answers_is_left_at_once() {
    let mut game = plain(7);
    game.press("<Escape>");
    assert!(game.screen().contains("choose a round"));
}

#[test]
fn a_round_is_followed_by_another_or_by_the_choice_of_a_round() {
    let mut game = plain(7);
    for question in Round::of(Code::hits(7)).questions() {
        answer(&mut game, question, &WILD, "1");
        game.press("<Enter>");
    }
    assert!(game.screen().contains("all answered"), "{}", game.screen());
    game.press("n");
    let screen = game.screen();
    assert!(screen.contains("question 1 of 10  0 right"), "{screen}");
    assert!(!screen.contains("code 7 "), "{screen}");
    game.press("<Escape>");
    assert!(game.screen().contains("choose a round"));
}

#[test]
fn the_home_screen_opens_the_round_for_the_seed_and_then_others() {
    let app = App::new(Route::Home, Settings::default(), 7);
    let mut game = Headless::new(app, 80, 24);
    game.press("zh");
    assert_eq!(game.screen(), plain(7).screen());
    game.press("<Escape>h");
    assert!(game.screen().contains("question 1 of 10"));
    assert!(!game.screen().contains("code 7 "), "{}", game.screen());
    game.press("<Escape><Escape>");
    assert!(game.screen().contains("carrom : home"));
}

#[test]
fn only_the_collision_moves() {
    let mut game = plain(7);
    assert_eq!(game.app().wake(), None);
    game.press("1<Enter>2<Enter>");
    assert_eq!(game.app().wake(), None);
    game.press("<Enter>");
    assert!(game.app().wake().is_some());
    assert!(game.settle(LONG));
    game.press(" ");
    assert!(game.app().wake().is_some());
    assert!(game.settle(LONG));
    // The replay is over; the same key plays it again.
    game.press(" ");
    assert!(game.app().wake().is_some());
    let mut still = plain(7);
    still.app_mut().settings_mut().reduced_motion = true;
    still.press("1<Enter>2<Enter><Enter>");
    assert!(still.screen().contains("1 of 6: contact"));
    assert_eq!(still.app().wake(), None);
    still.press("<Enter><Enter><Enter><Enter><Enter>");
    assert_eq!(still.app().wake(), None);
    assert!(still.screen().contains("of 10 points"));
}

#[test]
fn layers_stay_as_the_player_has_set_them() {
    let mut game = plain(7);
    let drawn = |game: &mut Headless| {
        let picture = SplitLayout::new(Rect::new(0, 1, 80, 22)).picture;
        region(game, picture).contains("you")
    };
    game.press("1<Enter>2<Enter><Enter><End>");
    assert!(drawn(&mut game));
    game.press("7");
    assert!(!drawn(&mut game));
    game.press("<Enter>1<Enter>2<Enter><Enter><End>");
    assert!(!drawn(&mut game), "in the next question");
    game.press("7");
    assert!(drawn(&mut game));
}

/// On the smallest screen no text is lost: text that does not fit can be scrolled.
#[test]
fn on_the_smallest_screen_every_text_can_be_reached() {
    const SMALL: (u16, u16) = (60, 20);
    let mut longer = 0;
    for seed in 0..12 {
        let charset = [Charset::Ascii, Charset::Unicode][seed as usize % 2];
        let mut game = quiz(seed, charset, SMALL);
        for question in Round::of(Code::hits(seed)).questions() {
            let asked = words(&charset.text(&question.text));
            assert!(
                panel(&mut game, SMALL).contains(&asked),
                "{}",
                game.screen()
            );
            answer(&mut game, question, &WILD, "1");
            longer += usize::from(game.screen().contains("PageDown: more"));
            let reason = words(&charset.text(&question.why));
            let last: Vec<_> = reason.rsplitn(4, ' ').take(3).collect();
            let last = format!("{} {} {}", last[2], last[1], last[0]);
            game.press("<PageDown><PageDown>");
            let shown = panel(&mut game, SMALL);
            assert!(shown.contains(&last), "{last}\n{}", game.screen());
            game.press("<PageUp><PageUp>");
            assert!(panel(&mut game, SMALL).contains("of 10 points"));
            game.press("<Enter>");
        }
        let top = game.screen();
        assert!(top.contains("of 100 points"));
        game.press(&"<Down>".repeat(40));
        let bottom = game.screen();
        assert!(!bottom.contains("PageDown"), "{bottom}");
        game.press(&"<Up>".repeat(40));
        assert_eq!(game.screen(), top);
    }
    assert!(
        longer > 0,
        "some texts are too long for the smallest screen"
    );
}

#[derive(Debug, Clone)]
enum Step {
    Key(Key),
    Mouse(MouseKind, u16, u16),
    Size(u16, u16),
    Time(u64),
}

fn step() -> impl Strategy<Value = Step> {
    let key = prop_oneof![
        8 => prop::sample::select(vec![Key::Enter, Key::Char('3'), Key::Char(' ')]),
        8 => prop::sample::select(vec![
            Key::Up, Key::Down, Key::Left, Key::Right, Key::Tab, Key::BackTab, Key::PageUp,
            Key::PageDown, Key::Home, Key::End, Key::Backspace, Key::Delete, Key::F(1),
        ]),
        1 => Just(Key::Escape),
        6 => prop::char::range(' ', '~').prop_map(Key::Char),
    ];
    let mouse = prop::sample::select(vec![
        MouseKind::Down,
        MouseKind::Drag,
        MouseKind::Up,
        MouseKind::ScrollUp,
        MouseKind::ScrollDown,
    ]);
    prop_oneof![
        12 => key.prop_map(Step::Key),
        3 => (mouse, 0..130_u16, 0..45_u16).prop_map(|(kind, x, y)| Step::Mouse(kind, x, y)),
        1 => (0..=300_u16, 0..=100_u16).prop_map(|(x, y)| Step::Size(x, y)),
        2 => (60..=130_u16, 20..=45_u16).prop_map(|(x, y)| Step::Size(x, y)),
        2 => (0..3000_u64).prop_map(Step::Time),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(24, 96)))]

    /// Whatever is pressed, clicked or resized, the quiz continues, and an ASCII screen contains
    /// only ASCII.
    #[test]
    fn any_input_leaves_a_round_usable(seed: u64, steps in prop::collection::vec(step(), 1..80)) {
        let mut game = quiz(seed, Charset::Ascii, (80, 24));
        for step in steps {
            match step {
                // Other charsets have tests of their own.
                Step::Key(Key::Char('U')) => continue,
                Step::Key(key) => game.key(key),
                Step::Mouse(kind, column, row) => {
                    game.input(&Input::Mouse(Mouse::over(kind, (column, row))));
                }
                Step::Size(columns, rows) => game.resize(columns, rows),
                Step::Time(ms) => game.pass(Duration::from_millis(ms)),
            }
            let screen = game.screen();
            // The charset can be changed in the settings.
            let ascii = game.app().settings().charset == Charset::Ascii;
            prop_assert!(!ascii || screen.bytes().all(|b| b == b'\n' || (b' '..=b'~').contains(&b)));
            prop_assert!(!screen.contains("NaN"));
        }
    }
}

#[test]
fn what_was_seen_in_a_question_is_no_answer_and_no_evidence() {
    let play = |sees: bool| {
        let settings = Settings {
            sees,
            ..Settings::default()
        };
        let place = Route::Quiz(Some(Code::hits(7)));
        let mut game = Headless::new(App::new(place, settings, 7), 100, 30);
        game.press("60<Enter>30<Enter>2");
        if sees {
            // The points and the answers appear only after this step; after a reload, the quiz
            // continues with them.
            let screen = game.screen();
            assert!(screen.contains("Watch where they go") && !screen.contains("points"));
            assert!(game.app().address().0.ends_with(';'));
            game.press("<Enter><Enter>45<Enter>45<Enter>");
        }
        game.press("<End>");
        assert_eq!(game.screen().contains("you saw"), sees, "{}", game.screen());
        game.history()
    };
    let (with, without) = (play(true), play(false));
    assert_eq!(with.attempts, without.attempts);
    assert_eq!(
        (with.observations.len(), without.observations.len()),
        (1, 0)
    );
}

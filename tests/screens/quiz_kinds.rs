//! Every kind of round on the screen: choosing one, codes, exams, reviews, and every family with
//! every kind of question.

use std::time::Duration;

use carrom::app::App;
use carrom::cli;
use carrom::quiz::{Code, Course, CourseKind, Round};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use carrom::widgets::Charset;

fn settings(charset: Charset) -> Settings {
    Settings {
        charset,
        reduced_motion: true,
        ..Settings::default()
    }
}

/// The screen on which a round is chosen, with a store that has a clock.
fn choosing() -> Headless {
    let app = App::new(Route::Quiz(None), settings(Charset::Ascii), 7);
    Headless::keeping(app, 80, 24, Store::in_memory())
}

/// A round that begins immediately.
fn round(code: Code, charset: Charset) -> Headless {
    let place = Route::Quiz(Some(code));
    Headless::new(App::new(place, settings(charset), 7), 80, 24)
}

fn coded(code: &str) -> Headless {
    round(Code::parse(code).unwrap(), Charset::Ascii)
}

/// Answers the question on the screen, in whatever form it requires, and states a confidence.
fn answer(game: &mut Headless, confidence: &str) {
    for _ in 0..2 {
        if !game.screen().contains("How sure are you?") {
            game.press("1<Enter>");
        }
    }
    let screen = game.screen();
    assert!(screen.contains("How sure are you?"), "{screen}");
    game.press(confidence);
    // A collision is explained step by step; End shows the whole explanation.
    let keys = game.app().keys();
    if keys.rows().iter().any(|row| row.id == "hit.end") {
        game.press("<End>");
    }
}

/// Continues from an explanation to the next question or the summary, past the right shot if there
/// is one.
fn go_on(game: &mut Headless) {
    assert!(game.settle(Duration::from_secs(120)));
    let number = top(game);
    for _ in 0..2 {
        if top(game) == number && game.screen().contains("of 10 points") {
            game.press("<Enter>");
        }
    }
}

/// The first part of the status: "question 2 of 5", "all answered".
fn top(game: &mut Headless) -> String {
    let screen = game.screen();
    let line = screen.lines().next().unwrap().to_owned();
    let status = line.split_once("carrom : quiz").unwrap().1.trim();
    status.split("  ").next().unwrap().to_owned()
}

#[test]
fn each_round_is_chosen_by_its_number_its_letter_the_arrows_or_the_mouse() {
    for (row, (letter, begins)) in [
        ("f", "question 1 of at most 12"),
        ("q", "question 1 of 5"),
        ("m", "question 1 of 10"),
        ("r", "There is nothing to review"),
        ("h", "question 1 of 10"),
        ("t", "choose a topic"),
        ("e", "question 1 of 15"),
        ("w", "First finish a chapter in"),
        ("c", "A code looks like even-7"),
    ]
    .into_iter()
    .enumerate()
    {
        let mut screens = Vec::new();
        let number = (row + 1).to_string();
        let arrows = "<Down>".repeat(row) + "<Enter>";
        for keys in [letter, &number, &arrows] {
            let mut game = choosing();
            game.press(keys);
            screens.push(game.screen());
        }
        let mut game = choosing();
        let name = format!(" {number} ");
        let screen = game.screen();
        let line = screen
            .lines()
            .position(|line| line.get(..8).is_some_and(|it| it.contains(&name)))
            .unwrap();
        game.click((12, line as u16));
        if row > 0 {
            game.click((12, line as u16));
        }
        screens.push(game.screen());
        assert!(screens[0].contains(begins), "{begins}\n{}", screens[0]);
        assert!(screens.iter().all(|screen| *screen == screens[0]), "{row}");
    }
}

#[test]
fn a_topic_is_chosen_from_all_topics() {
    for (i, family) in CourseKind::topics().enumerate() {
        let mut game = choosing();
        game.press("t");
        game.press(&"<Down>".repeat(i));
        let name = Charset::Ascii.text(family.name()).into_owned();
        assert!(game.screen().contains(&name), "{}", game.screen());
        game.press("<Enter>");
        let screen = game.screen();
        assert!(
            screen.contains(&format!("code {}-7", family.id())),
            "{screen}"
        );
        assert!(screen.contains("question 1 of 6"), "{screen}");
    }
}

#[test]
fn a_code_is_typed_and_corrected() {
    let mut game = choosing();
    game.press("c<Enter>");
    assert!(!game.screen().contains("not the code"), "nothing typed yet");
    game.press("Mixed?");
    assert!(game.screen().contains("carrom : help") || game.screen().contains("help"));
    game.press("<Escape>");
    game.press("<Enter>");
    assert!(game.screen().contains("not the code"), "{}", game.screen());
    game.press("1-7");
    assert!(!game.screen().contains("not the code"));
    assert!(
        game.screen().contains("mixed: 1 question, number 7."),
        "{}",
        game.screen()
    );
    game.press("<Backspace><Backspace><Backspace>-7<Enter>");
    assert_eq!(game.screen(), coded("mixed-7").screen());
    game.press("<Escape>");
    assert!(game.screen().contains("choose a round"));
    game.press("c<Escape><Escape>");
    assert!(game.screen().contains("carrom : home"), "{}", game.screen());
}

#[test]
fn the_page_of_a_code_promises_no_more_questions_than_there_may_be() {
    for (code, count) in [
        ("quick-7", "quick: 5 questions,"),
        ("even60-7", "even: at most 60 questions,"),
        ("beliefs-7", "beliefs: at most 12 questions,"),
    ] {
        let mut game = choosing();
        game.press(&format!("c<Enter>{code}"));
        assert!(game.screen().contains(count), "{}", game.screen());
    }
}

#[test]
fn an_exam_gives_no_feedback_before_its_end_and_then_all_of_it() {
    let mut game = coded("exam6-7");
    for number in 1..=6 {
        assert_eq!(top(&mut game), format!("question {number} of 6"));
        let screen = game.screen();
        let status = screen.lines().next().unwrap();
        assert!(!status.contains(" right") && status.contains("code exam6-7"));
        answer(&mut game, "3");
        assert!(!game.screen().contains("of 10 points"), "{}", game.screen());
        assert_eq!(game.attempts().len(), number, "kept at once");
    }
    assert_eq!(top(&mut game), "all answered");
    let screen = game.screen();
    assert!(screen.contains(" of 60 points"), "{screen}");
    assert!(screen.contains("carrom quiz --code exam6-7"), "{screen}");
    // Each answer can be opened, and closing it returns to its line.
    for number in 1..=6 {
        game.press("<Enter>");
        assert_eq!(top(&mut game), format!("question {number} of 6"));
        let screen = game.screen();
        assert!(screen.contains("of 10 points"), "{screen}");
        game.press("<Escape>");
        let screen = game.screen();
        assert!(screen.contains(&format!(">{number:>2}")), "{screen}");
        game.press("<Down>");
    }
    assert_eq!(
        game.attempts().len(),
        6,
        "looking at an answer does not count as answering"
    );
    game.press("<Escape>");
    assert!(game.screen().contains("choose a round"));
}

/// The answers of an exam that is left early can be looked at and are not lost.
#[test]
fn an_exam_that_is_left_shows_what_was_answered() {
    let mut game = coded("exam6-7");
    game.press("<Escape>");
    assert!(game.screen().contains("choose a round"), "nothing to show");
    let mut game = coded("exam6-7");
    answer(&mut game, "3");
    answer(&mut game, "2");
    game.press("<Escape>");
    let screen = words(&game.screen());
    assert!(screen.contains("End the exam"), "{screen}");
    assert!(!screen.contains("of 10 points"), "{screen}");
    game.press("n");
    assert_eq!(top(&mut game), "question 3 of 6");
    game.press("<Escape>");
    game.press("y");
    assert_eq!(top(&mut game), "2 of 6 answered", "{}", game.screen());
    let screen = game.screen();
    assert!(screen.contains(" of 20 points"), "{screen}");
    assert!(screen.lines().next().unwrap().contains(" right  code"));
    game.press("<Down><Enter>");
    assert_eq!(top(&mut game), "question 2 of 6");
    let screen = game.screen();
    assert!(screen.contains(" of 10 points"), "{screen}");
    assert!(screen.contains("Enter back to the list") || screen.contains("the right shot"));
    game.press("<Escape>");
    assert_eq!(top(&mut game), "2 of 6 answered");
    game.press("<Escape>");
    assert!(game.screen().contains("choose a round"));
}

/// Text without frame lines and with single spaces.
fn words(screen: &str) -> String {
    let bare = screen.replace(['|', '+'], " ");
    bare.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The number of due topics is the same wherever it is shown; a truncated list is marked.
#[test]
fn the_number_of_due_topics_is_the_same_everywhere() {
    let mut game = coded("exam-7");
    game.set_time(1_800_000_000);
    for _ in 0..15 {
        answer(&mut game, "1");
    }
    assert_eq!(top(&mut game), "all answered");
    game.press("<Escape>");
    let screen = game.screen();
    let due: usize = {
        let (before, _) = screen.split_once(" due").unwrap();
        before.rsplit(' ').next().unwrap().parse().unwrap()
    };
    assert!(due > Course::REVIEWED, "{screen}");
    game.press("<Down><Down><Down>");
    let screen = game.screen();
    let left = format!("and {} more after these", due - Course::REVIEWED);
    assert!(screen.contains(&left), "{screen}");
    game.press("<Enter>");
    let screen = game.screen();
    let asked = format!("question 1 of {}", Course::REVIEWED);
    assert!(screen.contains(&asked), "{screen}");
    let of = format!("review: {} of {due} due", Course::REVIEWED);
    assert!(screen.contains(&of), "{screen}");
    game.press("<Escape><Escape>p<Tab>");
    let screen = game.screen();
    assert!(screen.contains("carrom : progress"), "{screen}");
    assert!(screen.contains(&format!("{due} due")), "{screen}");
    assert!(
        screen.contains(&format!("and {} more", due - 6)),
        "{screen}"
    );
}

#[test]
fn a_line_of_the_summary_is_opened_by_a_click() {
    let mut game = coded("speeds3-7");
    for _ in 0..3 {
        answer(&mut game, "2");
        go_on(&mut game);
    }
    let screen = game.screen();
    let line = screen
        .lines()
        .position(|line| line.contains("|   2 "))
        .unwrap();
    game.click((20, line as u16));
    assert_eq!(top(&mut game), "all answered");
    game.click((20, line as u16));
    assert_eq!(top(&mut game), "question 2 of 3");
    game.press("<Enter>");
    assert!(game.screen().contains("> 2"), "{}", game.screen());
    game.press("n");
    assert_eq!(top(&mut game), "question 1 of 3");
    assert!(
        !game.screen().contains("code speeds3-7"),
        "{}",
        game.screen()
    );
}

/// A guessed topic is due at once; a review asks one question per topic, and has no code that could
/// be passed on.
#[test]
fn a_review_asks_about_the_topics_that_are_due() {
    let mut game = choosing();
    for code in ["speeds1-7", "from-angle1-7"] {
        game.press("c");
        game.press(code);
        game.press("<Enter>");
        answer(&mut game, "1");
        go_on(&mut game);
        assert_eq!(top(&mut game), "all answered", "{}", game.screen());
        game.press("<Escape>");
    }
    let screen = game.screen();
    assert!(screen.contains("choose a round  2 due"), "{screen}");
    game.press("<Down><Down><Down>");
    let screen = game.screen();
    for due in ["2 due", "Review what you missed", "equal masses", "speed"] {
        assert!(screen.contains(due), "{due}\n{screen}");
    }
    game.press("<Enter>");
    let mut asked = Vec::new();
    for number in 1..=2 {
        assert_eq!(top(&mut game), format!("question {number} of 2"));
        assert!(!game.screen().contains("code "), "{}", game.screen());
        answer(&mut game, "1");
        go_on(&mut game);
        asked.push(game.attempts().last().unwrap().topic.clone());
    }
    let mut due: Vec<_> = game.attempts()[..2]
        .iter()
        .map(|it| it.topic.clone())
        .collect();
    due.sort();
    asked.sort();
    assert_eq!(asked, due);
    let screen = game.screen();
    assert!(!screen.contains("for a friend"), "{screen}");
    game.press("n");
    assert!(game.screen().contains("choose a round"));
}

/// The questions of every topic can be read and answered, to the end of the round.
#[test]
fn every_family_is_played_on_every_screen() {
    for family in CourseKind::topics() {
        for (charset, size) in [
            (Charset::Ascii, (60, 20)),
            (Charset::Unicode, (80, 24)),
            (Charset::Ascii, (120, 40)),
        ] {
            let code = Code {
                course: Course::of(CourseKind::Topic(family), 6),
                seed: 11,
            };
            let questions = Round::of(code.clone());
            let mut game = round(code, charset);
            game.resize(size.0, size.1);
            for (i, question) in questions.questions().iter().enumerate() {
                assert_eq!(top(&mut game), format!("question {} of 6", i + 1));
                let screen = game.screen();
                let first = charset.text(&question.text).into_owned();
                let first = first.split(' ').take(2).collect::<Vec<_>>().join(" ");
                assert!(screen.contains(&first), "{first}\n{screen}");
                answer(&mut game, "2");
                assert!(game.screen().contains("of 10 points"), "{}", game.screen());
                assert!(!game.screen().contains("NaN"));
                go_on(&mut game);
            }
            assert_eq!(top(&mut game), "all answered");
        }
    }
}

/// A teacher's own questions have a separate line, with the files that were left out and the
/// reasons; the built-in rounds do not change.
#[test]
fn own_questions_make_a_round_of_their_own() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/own-concepts");
    let open = |arguments: &str| {
        let app = cli::open(&format!("{arguments} --concepts '{folder}'")).unwrap();
        Headless::from(app)
    };
    let mut game = open("quiz --code mixed-7");
    game.press("<Escape>");
    let screen = game.screen();
    assert!(screen.contains("10 your own questions"), "{screen}");
    assert!(screen.contains("of 2, 1 left out"), "{screen}");
    game.press("<End>");
    let screen = game.screen();
    assert!(
        screen.contains("Left out:") && screen.contains("flat-earth"),
        "{screen}"
    );
    game.press("o");
    assert_eq!(top(&mut game), "question 1 of 2");
    let screen = game.screen();
    assert!(
        screen.contains("code own-") && screen.contains("Two equal"),
        "{screen}"
    );
    game.press("a<Enter>2");
    assert!(game.settle(Duration::from_secs(120)));
    assert_eq!(game.attempts()[0].topic, "our-marbles");
    // The round can be opened by its code, but not without the folder.
    let mut game = open("quiz --code own-7");
    assert_eq!(top(&mut game), "question 1 of 2");
    assert!(
        cli::open("quiz --code own-7")
            .err()
            .unwrap()
            .contains("--concepts gives their folder")
    );
    let mut game = choosing();
    game.press("cown-7<Enter>");
    assert!(
        game.screen().contains("not the code of a round"),
        "{}",
        game.screen()
    );
    // The built-in questions are the same with and without the folder.
    let mixed = Round::of(Code::parse("mixed-7").unwrap());
    let text = &mixed.questions()[0].text;
    let mut game = open("quiz --code mixed-7");
    let first: Vec<_> = text.split(' ').take(4).collect();
    assert!(
        game.screen().contains(&first.join(" ")),
        "{}",
        game.screen()
    );
}

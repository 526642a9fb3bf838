//! The chapters on the screen: each is read with the keys, with its answers, bookmark and figures.

use carrom::app::App;
use carrom::cli;
use carrom::lessons::{Chapter, ChapterLibrary, ChapterPage, CheckpointKind};
use carrom::messages::Key;
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::widgets::Charset;

use crate::reading::answer;

fn open(number: usize, charset: Charset, size: (u16, u16)) -> Headless {
    let settings = Settings {
        charset,
        ..Settings::default()
    };
    let app = App::new(Route::Chapter(number), settings, 1);
    Headless::new(app, size.0, size.1)
}

fn chapter(name: &str) -> (usize, &'static Chapter) {
    let library = ChapterLibrary::embedded_once();
    let number = library.find(name).unwrap();
    (number, &library.chapters[number])
}

#[test]
fn every_chapter_can_be_read_from_first_page_to_last() {
    for (number, chapter) in ChapterLibrary::embedded_once().chapters.iter().enumerate() {
        for charset in [Charset::Ascii, Charset::Unicode] {
            for size in [(80, 24), (120, 40), (60, 20)] {
                let mut game = open(number, charset, size);
                for (at, page) in chapter.pages.iter().enumerate() {
                    let count = format!("page {} of {}", at + 1, chapter.pages.len());
                    let seen = |game: &mut Headless| {
                        let screen = game.screen();
                        assert!(screen.contains(&count), "{}: {count}\n{screen}", chapter.id);
                        for never in ["NaN", "undefined", "inf "] {
                            assert!(!screen.contains(never), "{} {count}\n{screen}", chapter.id);
                        }
                        assert!(
                            charset == Charset::Unicode
                                || !screen.contains('?')
                                || screen.is_ascii()
                        );
                    };
                    seen(&mut game);
                    answer(&mut game, page);
                    seen(&mut game);
                    game.press("n");
                }
                let book = &game.app().context().book;
                assert!(book.is_done(chapter), "{}", chapter.id);
                assert!(game.screen().contains("1 of "), "{}", game.screen());
                let asked = chapter
                    .pages
                    .iter()
                    .filter(|page| page.checkpoint.is_some());
                assert_eq!(game.attempts().len(), asked.count());
            }
        }
    }
}

#[test]
fn an_answer_is_saved_and_explained_at_once() {
    let (number, chapter) = chapter("the-line-of-impact");
    let mut game = open(number, Charset::Ascii, (80, 24));
    assert!(
        !game.screen().contains("v1 ="),
        "nothing is shown before the answer"
    );
    game.press("2<Enter>");
    let screen = game.screen();
    assert!(screen.contains("+ Along the line"), "{screen}");
    assert!(
        !screen.contains("v1 =") && !screen.contains("60.0"),
        "later pages ask for this answer: {screen}"
    );
    let attempt = game.attempts().remove(0);
    assert!(attempt.right && (attempt.credit - 1.0).abs() < 1e-12);
    assert_eq!((attempt.topic, attempt.number), (chapter.title.clone(), 1));
    assert_eq!(attempt.question["chapter"], chapter.id);
    for figures in [attempt.answer, attempt.truth] {
        assert_eq!((figures.len(), &figures["choice"]), (1, &2.into()));
    }
    // The question is asked again, and this answer is wrong.
    game.press("r1<Enter>s");
    let screen = game.screen();
    assert!(screen.contains("x In the striker"), "{screen}");
    assert!(
        screen.contains("+ Along the line"),
        "the right answer is shown too\n{screen}"
    );
    assert!(!game.attempts()[1].right);
}

#[test]
fn the_bookmark_is_saved_and_can_be_reset() {
    let (number, chapter) = chapter("the-line-of-impact");
    let mut game = open(number, Charset::Ascii, (80, 24));
    game.press("2<Enter>nn<Escape>");
    let screen = game.screen();
    assert!(screen.contains("read 3 of 5"), "{screen}");
    assert!(screen.contains("read on at page 3"), "{screen}");
    game.press("<Enter>");
    assert!(game.screen().contains("page 3 of 5"));
    game.press("bb");
    assert!(
        game.screen().contains("+ Along the line"),
        "the answer is still there"
    );
    game.press("n");
    game.press("Rn");
    assert!(
        game.screen().contains("page 2 of 5"),
        "only a confirmation deletes the bookmark"
    );
    game.press("Ry");
    let screen = game.screen();
    assert!(
        screen.contains("page 1 of 5") && screen.contains("starts again"),
        "{screen}"
    );
    let mark = game.app().context().book.mark(&chapter.id);
    assert_eq!(mark.unwrap().answered(chapter), 0);
    game.press("<Escape>R");
    let screen = game.screen();
    assert!(
        screen.contains("Forget chapter 2?") && screen.contains("read 1 of 5"),
        "{screen}"
    );
    game.press("n");
    assert!(
        game.app().context().book.mark(&chapter.id).is_some(),
        "only a confirmation deletes the bookmark"
    );
    game.press("Ry");
    assert!(game.app().context().book.mark(&chapter.id).is_none());
    assert_eq!(game.attempts().len(), 1, "the record of answers stays");
}

#[test]
fn a_checkpoint_can_be_skipped() {
    let (number, _) = chapter("the-line-of-impact");
    let mut game = open(number, Charset::Ascii, (80, 24));
    game.press("n");
    assert!(game.screen().contains("page 2 of 5"));
    assert_eq!(game.attempts().len(), 0);
}

/// The page of a chapter with this figure.
fn page_with(chapter: &Chapter, figure: carrom::lessons::FigureKind) -> usize {
    let has = |page: &ChapterPage| page.figure.is_some_and(|shown| shown.kind == figure);
    chapter.pages.iter().position(has).unwrap()
}

#[test]
fn the_point_on_the_curves_is_moved_by_keys_and_by_mouse() {
    use carrom::lessons::FigureKind;
    let (number, chapter) = chapter("speeds-and-angles");
    let mut game = open(number, Charset::Ascii, (80, 24));
    for _ in 0..page_with(chapter, FigureKind::Curves) {
        game.press("n");
    }
    game.press("<Home><Right>");
    for _ in 0..29 {
        game.key(Key::Right);
    }
    let screen = game.screen();
    // sin 30° and cos 30°.
    assert!(
        screen.contains("0.500") && screen.contains("0.866"),
        "{screen}"
    );
    game.drag((20, 6), (38, 6));
    let dragged = game.screen();
    assert_ne!(dragged, screen);
    game.press("<End>");
    let screen = game.screen();
    assert!(
        screen.contains("1.000") && screen.contains("0.000"),
        "{screen}"
    );
}

#[test]
fn a_shot_set_by_the_player_goes_through_the_steps_of_the_proof() {
    use carrom::lessons::FigureKind;
    let (number, chapter) = chapter("the-right-angle");
    let mut game = open(number, Charset::Ascii, (80, 24));
    for _ in 0..page_with(chapter, FigureKind::Triangle { step: 1 }) {
        game.press("n");
    }
    game.press("<Home><Right><Right><Right>");
    assert!(game.screen().contains("alpha = 3 deg"), "{}", game.screen());
    let first = page_with(chapter, FigureKind::Triangle { step: 1 });
    let last = page_with(chapter, FigureKind::Triangle { step: 3 });
    for page in &chapter.pages[first..last] {
        answer(&mut game, page);
        game.press("n");
    }
    answer(&mut game, &chapter.pages[last]);
    let screen = game.screen();
    assert!(screen.contains("alpha = 3 deg"), "{screen}");
    assert!(screen.contains("= 0.00"), "{screen}");
}

#[test]
fn a_figure_opens_in_the_lab_and_is_exported() {
    let (number, _) = chapter("the-line-of-impact");
    let mut game = open(number, Charset::Unicode, (80, 24));
    game.press("e");
    assert!(
        game.screen().contains("Give your answer first"),
        "the outcome is not revealed"
    );
    game.press("2<Enter>e");
    let (name, svg) = &game.exports()[0];
    assert_eq!(name, "carrom-the-line-of-impact-1.svg");
    assert!(svg.contains(">n<") && svg.contains(">t<"));
    // The next key closes the notice.
    assert!(
        game.screen()
            .contains("The figure is in carrom-the-line-of-impact-1.svg")
    );
    game.press("<Enter>o");
    let screen = game.screen();
    assert!(screen.contains("carrom : lab"), "{screen}");
    assert!(
        screen.contains("15.0 mm") && screen.contains("30.0°"),
        "{screen}"
    );
    game.press("<Escape>");
    assert!(game.screen().contains("page 1 of 5"));
}

#[test]
fn a_chapter_is_opened_by_number_or_name() {
    let title = |arguments: &str| {
        let mut game = Headless::new(cli::open(arguments).unwrap(), 80, 24);
        game.screen().lines().next().unwrap().to_owned()
    };
    assert!(title("learn").contains("carrom : learn"));
    assert!(title("learn 2").contains("2 The line of impact"));
    assert!(title("learn the-line-of-impact").contains("2 The line of impact"));
    let wrong = cli::open("learn nonsense").err().unwrap();
    assert!(
        wrong.contains("expected the number or the name of a chapter"),
        "{wrong}"
    );
}

#[test]
fn typed_text_is_visible_on_a_small_screen() {
    for (number, chapter) in ChapterLibrary::embedded_once().chapters.iter().enumerate() {
        let mut game = open(number, Charset::Ascii, (60, 20));
        for page in &chapter.pages {
            let asked = page.checkpoint.as_ref().map(|checkpoint| &checkpoint.asked);
            match asked {
                Some(CheckpointKind::Number { .. }) => {
                    game.press("48");
                    assert!(game.screen().contains("48_"), "{}", game.screen());
                }
                Some(CheckpointKind::Choice(_)) => {
                    game.key(Key::Up);
                    let screen = game.screen();
                    assert!(screen.contains("|>") || screen.contains(" >"), "{screen}");
                }
                Some(CheckpointKind::Rays) => {
                    game.press("48");
                    assert!(game.screen().contains("48_"), "{}", game.screen());
                }
                None => {}
            }
            let keys = game.screen().lines().last().unwrap_or_default().to_owned();
            assert!(keys.contains("Enter") && keys.contains("Esc"), "{keys}");
            if let Some(CheckpointKind::Number { .. } | CheckpointKind::Rays) = asked {
                // Escape discards what was typed.
                game.press("<Escape>");
            }
            answer(&mut game, page);
            let keys = game.screen().lines().last().unwrap_or_default().to_owned();
            assert!(keys.contains("Enter") && keys.contains("Esc"), "{keys}");
            game.press("n");
        }
    }
}

#[test]
fn the_text_of_a_page_stays_above_its_answer_where_there_is_room() {
    let (number, _) = chapter("momentum-is-a-vector");
    for (size, stays) in [((120, 40), true), ((60, 20), false)] {
        let mut game = open(number, Charset::Ascii, size);
        game.press("nnn");
        assert!(game.screen().contains("deflection angle"));
        game.press("3<Enter>s");
        let screen = game.screen();
        assert_eq!(screen.contains("deflection angle"), stays, "{screen}");
        assert!(screen.contains("Not this time"), "{screen}");
    }
}

#[test]
fn a_second_try_after_a_hint_earns_half_the_credit() {
    let (number, chapter) = chapter("the-line-of-impact");
    let mut game = open(number, Charset::Ascii, (80, 24));
    game.press("1<Enter>");
    let screen = game.screen();
    assert!(screen.contains("Not yet. A hint:"), "{screen}");
    assert!(
        !screen.contains("Newton"),
        "the right answer is not shown yet\n{screen}"
    );
    game.press("2<Enter>");
    let screen = game.screen();
    assert!(
        screen.contains("half the credit") && screen.contains("Newton"),
        "{screen}"
    );
    let credits: Vec<_> = game
        .attempts()
        .iter()
        .map(|it| (it.right, it.credit))
        .collect();
    assert_eq!(credits, [(false, 0.0), (true, 0.5)]);
    let mark = game.app().context().book.mark(&chapter.id).unwrap();
    assert_eq!(
        (mark.right(chapter), mark.right_after_hint(chapter)),
        (1, 1)
    );
    // If one of two rays is right, that ray stays. After a second wrong answer the right answer is
    // shown.
    game.press("nnn45<Enter>30<Enter>");
    assert!(
        game.screen().contains("The coin is right."),
        "{}",
        game.screen()
    );
    game.press("50<Enter><Enter>");
    assert!(game.settle(std::time::Duration::from_secs(120)));
    let screen = game.screen();
    assert!(
        screen.contains("60.0") && !screen.contains("half the credit"),
        "{screen}"
    );
    assert_eq!(game.attempts().len(), 4);
}

/// For a student who has predicted often enough, the lab shows outcomes while they aim.
#[test]
fn the_lab_hides_the_outcome_while_a_question_of_the_page_is_open() {
    let (number, chapter) = chapter("the-right-angle");
    let settings = Settings {
        predicted: 3,
        ..Settings::default()
    };
    let app = App::new(Route::Chapter(number), settings, 1);
    let mut game = Headless::new(app, 100, 30);
    let hidden = "hidden until you have";
    game.press("o");
    assert!(game.screen().contains(hidden), "{}", game.screen());
    game.press("<Esc>");
    answer(&mut game, &chapter.pages[0]);
    game.press("o");
    assert!(!game.screen().contains(hidden), "{}", game.screen());
}

//! Tests that the back row can read everything.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::play::ClassPlay;
use super::{Class, ClassScene, question};
use crate::class::{ClassPlace, ClassRound, ClassStep, Vote};
use crate::messages::Key;
use crate::quiz::Code;
use crate::screens::{AnyScreen, Context, Hosted, Settings};
use crate::widgets::panel::{Beside, Writing};
use crate::widgets::{Charset, cells};

const STEPS: [ClassStep; 6] = [
    ClassStep::Describe,
    ClassStep::Predict,
    ClassStep::FirstVote,
    ClassStep::Talk,
    ClassStep::SecondVote,
    ClassStep::Shot,
];

/// Every step of every question of three rounds has letters large enough for the back row, and a
/// short text fits on one or two pages.
#[test]
fn the_back_row_can_read_every_step_of_every_question() {
    let teams: Vec<String> = (1..=8).map(|team| format!("Team {team}")).collect();
    let mut asked = 0;
    let mut faults = Vec::new();
    for code in ["mixed-1", "mixed-2", "concept-1"] {
        let code = Code::parse(code).unwrap();
        let mut round = ClassRound::new(code, teams.clone());
        for number in 0..round.questions().len() {
            let truth = round.questions()[number].form.truth();
            round.vote(number, 0, Vote::First, Some(truth));
            for charset in [Charset::Ascii, Charset::Unicode] {
                for (columns, rows) in [(80, 24), (120, 40)] {
                    asked += 1;
                    let settings = Settings {
                        charset,
                        ..Settings::default()
                    };
                    let mut cx = Context::new(settings, 1);
                    cx.body = Rect::new(0, 1, columns, rows - 2);
                    for step in STEPS {
                        round.go(ClassPlace {
                            question: number,
                            step,
                        });
                        let play = ClassPlay::new(round.clone(), &mut cx);
                        faults.extend(illegible(&play, &cx, rows));
                    }
                }
            }
        }
    }
    assert_eq!(asked, 4 * 26);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The parts of a step that the back row cannot read or see.
fn illegible(play: &ClassPlay, cx: &Context, rows: u16) -> Vec<String> {
    let question = play.stage.question().unwrap();
    let writing = Writing {
        look: cx.settings.look(),
        pages: None,
    };
    let view = play.view(cx);
    let placed = view.placed(cx.room(), &writing, &|_| None);
    let mut faults = Vec::new();
    let mut fault = |what: &str| {
        let (code, number) = (play.stage.round().code(), play.stage.number() + 1);
        let (step, charset) = (play.stage.step(), cx.settings.charset);
        faults.push(format!(
            "{code} {number} {step:?} {rows} {charset:?}: {what}"
        ));
    };
    let Some(pages) = placed.pages() else {
        fault("plain type");
        return faults;
    };
    for (size, letters, pages, picture) in pages.parts() {
        if !size.is_legible(rows) {
            fault("too small");
        }
        if question::beside(question) != Beside::Nothing && picture.is_empty() {
            fault("no picture");
        }
        if rows == 24 && letters < 200 && pages > 2 {
            fault(&format!("{letters} letters on {pages} pages"));
        }
    }
    faults
}

/// Each of thirty-two pupils can be scrolled into view.
#[test]
fn a_long_scoreboard_can_be_scrolled_to_its_end() {
    let names = (0..32).map(|pupil| format!("Pupil {pupil:02}"));
    let code = Code::parse("from-angle2-7").unwrap();
    let mut round = ClassRound::new(code, names.collect());
    let truth = round.questions()[0].form.truth();
    round.vote(0, 0, Vote::First, Some(truth));
    round.go(ClassPlace {
        question: 0,
        step: ClassStep::Scores,
    });
    let mut cx = Context::new(Settings::default(), 1);
    cx.body = Rect::new(0, 0, 80, 19);
    let mut screen = Hosted::new(Class {
        scene: ClassScene::Play(Box::new(ClassPlay::new(round, &mut cx))),
        paused: false,
    });
    let shown = |screen: &Hosted<Class>, cx: &Context| {
        let mut buf = Buffer::empty(Rect::new(0, 0, 80, 20));
        screen.draw(&mut buf, cx);
        cells::text(&buf)
    };
    let mut seen = shown(&screen, &cx);
    assert!(seen.contains("PageDown: more"), "{seen}");
    for _ in 0..4 {
        screen.press(Key::PageDown, &mut cx);
        seen += &shown(&screen, &cx);
    }
    for pupil in 0..32 {
        assert!(seen.contains(&format!("Pupil {pupil:02}")), "{pupil}");
    }
}

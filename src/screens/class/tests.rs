//! Tests that the back row can read everything.

use std::collections::{BTreeMap, BTreeSet};

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::play::ClassPlay;
use super::{Class, ClassAction, ClassScene, question};
use crate::class::{ClassPlace, ClassRound, ClassStep, Vote, WayOfVoting};
use crate::messages::Key;
use crate::quiz::{Code, CourseKind, Family, Form, concepts};
use crate::screens::kept_files::KeptAction;
use crate::screens::{AnyScreen, Context, Hosted, Next, Screen, Settings};
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

/// Every step before the scores, of every question of three rounds, has letters large enough for
/// the back row; on 24 rows, a short text fits on one or two pages.
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
                        let play = ClassPlay::new(round.clone(), 1, &mut cx);
                        faults.extend(illegible(&play, &cx, rows));
                    }
                }
            }
        }
    }
    assert_eq!(asked, 4 * 26);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The parts of a step that cannot be read or seen from the back row.
fn illegible(play: &ClassPlay, cx: &Context, rows: u16) -> Vec<String> {
    let question = play.stage.question().unwrap();
    let writing = Writing {
        look: cx.settings.look(),
        pages: None,
        key: &|_| None,
    };
    let view = play.view(cx);
    let placed = view.placed(cx.room(), &writing);
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
    let together = !matches!(play.stage.step(), ClassStep::Describe | ClassStep::Predict);
    let mut parts = pages.parts().map(|(.., picture)| picture);
    if question::beside(question) != Beside::Nothing && parts.all(|it| it.is_empty()) {
        fault("no picture");
    }
    for (number, (size, letters, pages, _)) in pages.parts().enumerate() {
        let is_first = together && number == 0;
        if !(size.is_legible(rows) || is_first && size.is_large_enough(rows)) {
            fault("too small");
        }
        if is_first && pages > 1 && rows == 24 {
            fault("on several pages");
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
        scene: ClassScene::play(round, &mut cx),
        ..Class::new(None, &[], "", &cx)
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

/// The screen sizes for which the test counts the questions that show all choices at once.
const SCREENS: [(u16, u16); 3] = [(80, 24), (100, 30), (120, 40)];

/// How often questions were laid out (once for each way to vote), and how often all choices were on
/// the first page: in both votes (`vote`), and with their bars in the discussion (`talk`).
#[derive(Debug, Clone, Copy, Default)]
struct OnePage {
    asked: usize,
    vote: usize,
    talk: usize,
}

/// The questions laid out so far, and the pages counted for each number of rows and each charset.
#[derive(Default)]
struct OnePages {
    seen: BTreeSet<String>,
    pages: BTreeMap<(u16, &'static str), OnePage>,
    faults: Vec<String>,
}

impl OnePages {
    /// Lays out the questions for a code on these screens, for every way in which a class can vote
    /// on choices.
    fn lay_out(&mut self, code: &str, screens: &[(u16, u16)]) {
        let code = Code::parse(code).unwrap();
        let teams: Vec<String> = (1..=8).map(|team| format!("Team {team}")).collect();
        let rounds = [
            ClassRound::with_tally(code.clone()),
            ClassRound::new(code.clone(), teams),
            ClassRound::with_devices(code),
        ];
        for number in 0..rounds[0].questions().len() {
            let question = &rounds[0].questions()[number];
            let choices = rounds[0].choices(number);
            if !self.seen.insert(format!("{} {choices:?}", question.text)) {
                continue;
            }
            let has_any = matches!(question.form, Form::Choice { .. });
            for round in rounds
                .iter()
                .filter(|it| has_any || it.way() == WayOfVoting::Tally)
            {
                let mut round = round.clone();
                for vote in Vote::BOTH {
                    let counts: Vec<u32> = (0..choices.len() as u32).map(|it| 3 + 4 * it).collect();
                    round.count(number, vote, Some(&counts));
                    for (team, said) in (0..round.teams().len()).zip(choices.iter().cycle()) {
                        round.vote(number, team, vote, Some(*said));
                    }
                }
                for screen in screens {
                    self.lay_out_on(*screen, number, &mut round);
                }
            }
        }
    }

    fn lay_out_on(&mut self, (columns, rows): (u16, u16), number: usize, round: &mut ClassRound) {
        for (charset, name) in [(Charset::Ascii, "ASCII"), (Charset::Unicode, "Unicode")] {
            let settings = Settings {
                charset,
                ..Settings::default()
            };
            let mut cx = Context::new(settings, 1);
            cx.body = Rect::new(0, 1, columns, rows - 2);
            let steps = [ClassStep::FirstVote, ClassStep::Talk, ClassStep::SecondVote];
            let [first, talk, second] = steps.map(|step| {
                round.go(ClassPlace {
                    question: number,
                    step,
                });
                let mut play = ClassPlay::new(round.clone(), 1, &mut cx);
                play.host_page = None;
                let writing = Writing {
                    look: cx.settings.look(),
                    pages: None,
                    key: &|_| None,
                };
                let view = play.view(&cx);
                let placed = view.placed(cx.room(), &writing);
                let fits = placed
                    .pages()
                    .is_some_and(|it| it.begins_with_all_choices());
                if !fits {
                    let (way, text) = (round.way(), &round.questions()[number].text);
                    self.faults
                        .push(format!("{rows} {name} {step:?} {way:?}: {text}"));
                }
                fits
            });
            let page = self.pages.entry((rows, name)).or_default();
            page.asked += 1;
            page.vote += usize::from(first && second);
            page.talk += usize::from(talk);
        }
    }

    fn table(&self) -> String {
        let mut table = format!("{:<16}{:>8}{:>9}{:>9}\n", "screen", "pages", "vote", "talk");
        for ((rows, charset), it) in &self.pages {
            let percent = |part: usize| 100.0 * part as f64 / it.asked as f64;
            let (vote, talk) = (percent(it.vote), percent(it.talk));
            let screen = format!("{rows} {charset}");
            table += &format!("{screen:<16}{:>8}{vote:>8.1}%{talk:>8.1}%\n", it.asked);
        }
        table
    }
}

/// A class can compare all choices with their bars at a glance: on the recommended screen, two
/// questions of each family that has a round of its own show them on the first page.
#[test]
fn votes_are_shown_with_all_choices_on_one_page() {
    let mut pages = OnePages::default();
    for family in CourseKind::topics() {
        pages.lay_out(&format!("{}2-1", family.id()), &SCREENS[..1]);
    }
    assert!(pages.seen.len() > 25, "{}", pages.seen.len());
    assert!(pages.faults.is_empty(), "{}", pages.faults.join("\n"));
}

/// Tests every question in words, and at least twenty questions of every other family. On larger
/// screens letters have to be larger, and some choices are too long for one page.
#[test]
#[ignore = "twenty thousand layouts take minutes"]
fn all_questions_show_all_choices_on_one_page() {
    let mut pages = OnePages::default();
    for family in Family::ALL {
        let written = concepts::of(*family).len();
        let before = pages.seen.len();
        for seed in 1..200 {
            if pages.seen.len() - before >= written.max(20) {
                break;
            }
            let code = match family {
                Family::WhereTo => seed.to_string(),
                _ => format!("{}20-{seed}", family.id()),
            };
            pages.lay_out(&code, &SCREENS);
        }
    }
    println!("{}", pages.table());
    let recommended = { pages.faults.iter() }.filter(|it| it.starts_with("24 "));
    assert_eq!(recommended.collect::<Vec<_>>(), Vec::<&String>::new());
    let enough = |it: &OnePage| 100 * it.vote.min(it.talk) >= 80 * it.asked;
    assert!(
        pages.pages.values().all(enough),
        "{}",
        pages.faults.join("\n")
    );
}

#[test]
fn confirming_a_deletion_does_not_leave_a_round_that_has_opened_in_the_meantime() {
    let mut cx = Context::new(Settings::default(), 1);
    let mut class = Class::new(None, &[], "", &cx);
    let round = ClassRound::with_tally(Code::parse("quick-1").unwrap());
    class.scene = ClassScene::Play(Box::new(ClassPlay::new(round, 1, &mut cx)));
    let remove = ClassAction::Earlier(KeptAction::Remove);
    assert_eq!(class.confirmed(remove, &mut cx), Next::Stay);
}

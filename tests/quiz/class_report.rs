//! The report of a class round, as a page.

use carrom::class::{ClassChange, ClassRound, JoinCode, SeatToken, Vote};
use carrom::paper::class_report::{About, html};
use carrom::quiz::{Answer, Code, Response};
use scraper::{ElementRef, Html, Selector};

use crate::students::{Belief, Student};

const PUPILS: usize = 27;
const ABOUT: About = About {
    day: None,
    with_names: false,
};

/// A round of 27 simulated pupils; of those who are wrong at first, about half change to the right
/// answer.
fn played(code: &str) -> ClassRound {
    let mut round = ClassRound::with_devices(Code::parse(code).unwrap()).of_class("10b <x>");
    round.open(JoinCode::of(7), None);
    for person in 0..PUPILS {
        let seat = Some(SeatToken::of(person as u128 + 1));
        let name = format!("Pupil-{person}");
        round.change(&ClassChange::Join { seat, name }).unwrap();
        let belief = Belief::ALL[person % Belief::ALL.len()];
        let mut student = Student::new(belief, person % 3 == 0, person as u64);
        for number in 0..round.questions().len() {
            let question = round.questions()[number].clone();
            let Answer { said, .. } = student.answer(&question);
            round.vote(number, person, Vote::First, Some(said));
            if (person + number) % 2 == 0 {
                round.vote(number, person, Vote::Second, Some(question.form.truth()));
            }
        }
    }
    round
}

fn all<'p>(page: &'p Html, selector: &str) -> Vec<ElementRef<'p>> {
    page.select(&Selector::parse(selector).unwrap()).collect()
}

fn text(element: &ElementRef<'_>) -> String {
    element.text().collect::<Vec<_>>().join(" ")
}

/// If `CARROM_REPORTS` is set to a folder, the test writes the reports there for inspection.
#[test]
fn a_report_shows_each_question_with_its_votes_and_what_to_teach_next() {
    for code in ["quick-7", "mixed-3", "concept-2"] {
        let round = played(code);
        let page = html(&round, &ABOUT);
        if let Ok(folder) = std::env::var("CARROM_REPORTS") {
            std::fs::write(format!("{folder}/{code}.html"), &page).unwrap();
        }
        assert!(!page.contains("Pupil-") && !page.contains("<x>") && !page.contains("<script"));
        let page = Html::parse_document(&page);
        let questions = round.questions();
        assert_eq!(all(&page, "article.asked").len(), questions.len());
        for (number, article) in all(&page, "article.asked").iter().enumerate() {
            let rows = Selector::parse("table.votes tbody tr").unwrap();
            let counts = Selector::parse("td .count").unwrap();
            for vote in [Vote::First, Vote::Second] {
                let votes = article.select(&rows).map(|row| {
                    let cell = row.select(&counts).nth(vote as usize).unwrap();
                    let count: usize = text(&cell).split(' ').next().unwrap().parse().unwrap();
                    count
                });
                assert_eq!(votes.sum::<usize>(), PUPILS, "{code} {number}");
            }
            let right = Selector::parse("tr.right").unwrap();
            assert_eq!(article.select(&right).count(), 1, "{code} {number}");
        }
        // For the most widely held misconception, the report names a page of a chapter and a round.
        let beliefs = all(&page, ".belief");
        assert!(!beliefs.is_empty());
        let first = text(&beliefs[0]);
        assert!(
            first.contains("chapter ") && first.contains("carrom class --code"),
            "{first}"
        );
    }
}

#[test]
fn a_report_can_be_read_by_a_screen_reader() {
    let page = Html::parse_document(&html(&played("mixed-3"), &ABOUT));
    assert_eq!(all(&page, "html[lang=en]").len(), 1);
    for picture in all(&page, "svg") {
        assert_eq!(picture.value().attr("role"), Some("img"));
        let title = picture.select(&Selector::parse("title").unwrap()).next();
        assert!(title.is_some_and(|it| !text(&it).is_empty()));
    }
    assert!(
        all(&page, "th")
            .iter()
            .all(|it| it.value().attr("scope").is_some())
    );
    assert_eq!(
        all(&page, "tbody tr").len(),
        all(&page, "tbody tr > th[scope=row]").len()
    );
    let mut level = 1;
    for heading in all(&page, "h1, h2, h3, h4") {
        let own: u32 = heading.value().name()[1..].parse().unwrap();
        assert!(own <= level + 1, "{}", text(&heading));
        level = own;
    }
    // A bar repeats the number beside it.
    assert_eq!(
        all(&page, ".bar").len(),
        all(&page, ".bar[aria-hidden=true]").len()
    );
}

#[test]
fn a_report_contains_names_only_on_request() {
    let page = html(
        &played("quick-7"),
        &About {
            with_names: true,
            ..ABOUT
        },
    );
    assert!((0..PUPILS).all(|person| page.contains(&format!("Pupil-{person}<"))));
}

#[test]
fn every_way_of_voting_has_a_report() {
    let code = || Code::parse("quick-7").unwrap();
    let empty = html(&ClassRound::with_tally(code()), &ABOUT);
    assert!(empty.contains("Nobody has voted yet."));
    let mut tally = ClassRound::with_tally(code());
    let count = vec![5; tally.choices(0).len()];
    assert!(tally.count(0, Vote::First, Some(&count)));
    let votes = 5 * count.len();
    let page = html(&tally, &ABOUT);
    assert!(page.contains(&format!("up to {votes} hands counted in one vote")));
    assert!(page.contains("votes on 1 of 5 questions"));
    let mut teams = ClassRound::new(code(), vec!["Ants".into(), "Bees".into()]);
    teams.vote(0, 1, Vote::First, Some(Response::Number(1e9)));
    teams.vote(0, 0, Vote::First, Some(teams.questions()[0].form.truth()));
    assert!(html(&teams, &ABOUT).contains("2 teams"));
}

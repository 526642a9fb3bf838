//! Questions for Moodle's question bank, read back as Moodle reads them.

use std::collections::BTreeSet;
use std::fs;

use carrom::files::FileLibrary;
use carrom::paper::worksheet::Worksheet;
use carrom::quiz::concepts::{self, Library};
use carrom::quiz::{
    Code, CourseKind, Family, Form, Misconception, Question, Ray, Rays, Response, Round,
};
use roxmltree::{Document, Node};
use scraper::Html;

use crate::folder::Folder;
use crate::worksheet::{err, rounds, worksheet};

/// An answer that Moodle compares the student's answer with.
struct Known {
    fraction: f64,
    said: String,
    tolerance: Option<f64>,
    feedback: String,
}

impl Known {
    /// Whether Moodle accepts a number as this answer.
    fn is(&self, x: f64) -> bool {
        let known: f64 = self.said.parse().unwrap();
        (x - known).abs() <= self.tolerance.unwrap() * (1.0 + 1e-9)
    }
}

fn child<'a>(node: Node<'a, 'a>, name: &str) -> Node<'a, 'a> {
    let mut children = node.children().filter(|it| it.has_tag_name(name));
    let child = children.next().unwrap_or_else(|| panic!("no {name}"));
    assert!(children.next().is_none(), "{name} twice");
    child
}

/// The text of an element; in most elements the text is HTML.
fn text(node: Node, name: &str) -> String {
    let text = child(child(node, name), "text");
    text.text().unwrap_or_default().to_owned()
}

/// The words in HTML, with plain spaces.
fn words(html: &str) -> String {
    let page = Html::parse_fragment(html);
    let text: String = page.root_element().text().collect();
    text.replace('\u{a0}', " ")
}

/// The elements of the questions, without the categories.
fn questions<'a>(document: &'a Document<'a>) -> Vec<Node<'a, 'a>> {
    let quiz = document.root_element();
    assert!(quiz.has_tag_name("quiz"));
    let all = quiz.children().filter(Node::is_element);
    let is_asked = |it: &Node| it.attribute("type") != Some("category");
    all.filter(is_asked).collect()
}

fn answers(question: Node) -> Vec<Known> {
    let all = question.children().filter(|it| it.has_tag_name("answer"));
    let read = all.map(|answer| Known {
        fraction: answer.attribute("fraction").unwrap().parse().unwrap(),
        said: child(answer, "text").text().unwrap().to_owned(),
        tolerance: (answer.children().find(|it| it.has_tag_name("tolerance")))
            .map(|it| it.text().unwrap().parse().unwrap()),
        feedback: words(&text(answer, "feedback")),
    });
    read.collect()
}

/// The fields in the text of a question, split at the same characters as in Moodle.
fn fields(html: &str) -> Vec<(String, Vec<Known>)> {
    let mut fields = Vec::new();
    let mut rest = html;
    while let Some(start) = rest.find("{1:") {
        let (field, after) = rest[start + 3..].split_once('}').unwrap();
        let (kind, known) = field.split_once(':').unwrap();
        let known = known.split('~').map(|known| {
            let (said, feedback) = known.split_once('#').unwrap_or((known, ""));
            let (fraction, said) = match said.strip_prefix('=') {
                Some(said) => (100.0, said),
                None => (0.0, said),
            };
            let (said, tolerance) = match kind {
                "NUMERICAL" => said.split_once(':').unwrap(),
                _ => (said, ""),
            };
            // Moodle replaces entities once, and then shows the result as HTML.
            Known {
                fraction,
                said: said.into(),
                tolerance: tolerance.parse().ok(),
                feedback: words(&words(feedback)),
            }
        });
        fields.push((kind.to_owned(), known.collect()));
        rest = after;
    }
    fields
}

/// Rounds that together contain questions of every family, and all questions in words.
fn asked() -> Vec<Round> {
    let mut rounds: Vec<Round> = rounds().collect();
    let mut missing: BTreeSet<&str> = concepts::all().iter().map(|it| it.id.as_str()).collect();
    for seed in 0.. {
        for family in ["concept", "ideas"] {
            let round = Round::of(Code::parse(&format!("{family}60-{seed}")).unwrap());
            for question in round.questions() {
                missing.remove(question.figures["id"].as_str().unwrap());
            }
            rounds.push(round);
        }
        if missing.is_empty() {
            break;
        }
    }
    let families: BTreeSet<&str> = rounds
        .iter()
        .flat_map(Round::questions)
        .map(|question| question.family.id())
        .collect();
    assert_eq!(families.len(), Family::ALL.len());
    rounds
}

/// The feedback that Moodle shows for this answer, and its share of the points in percent.
fn graded(question: &Question, node: Node, said: &Response) -> (f64, String) {
    match (said, &question.form) {
        (Response::Number(x), _) => {
            let known = answers(node);
            let first = known.iter().find(|it| it.is(*x));
            first.map_or((0.0, String::new()), |it| {
                (it.fraction, it.feedback.clone())
            })
        }
        (Response::Choice(choice), _) => {
            let known = &answers(node)[*choice];
            (known.fraction, known.feedback.clone())
        }
        (Response::Rays(rays), _) => {
            let each = Ray::BOTH.map(|ray| {
                let words = ray.words(rays.get(ray));
                let side = match words.split(' ').next_back().unwrap() {
                    "left" | "ahead" | "back" => 0,
                    "right" => 1,
                    _ => 2,
                };
                (rays.get(ray).unwrap_or(0.0).abs().to_degrees(), side)
            });
            in_fields(node, &each)
        }
        (Response::Shot(offset), _) => {
            let size = (1000.0 * offset.abs(), usize::from(*offset > 0.0));
            in_fields(node, &[size])
        }
    }
}

/// Like [`graded`], but for numbers and sides in fields.
fn in_fields(node: Node, said: &[(f64, usize)]) -> (f64, String) {
    let fields = fields(&text(node, "questiontext"));
    assert_eq!(fields.len(), 2 * said.len());
    let (mut points, mut feedback) = (0.0, Vec::new());
    for ((x, side), pair) in said.iter().zip(fields.chunks(2)) {
        assert_eq!((&*pair[0].0, &*pair[1].0), ("NUMERICAL", "MULTICHOICE"));
        let known = [pair[0].1.iter().find(|it| it.is(*x)), pair[1].1.get(*side)];
        for known in known.into_iter().flatten() {
            points += known.fraction / fields.len() as f64;
            feedback.push(known.feedback.clone());
        }
    }
    (points, feedback.join("\n"))
}

#[test]
fn every_question_grades_its_answers_and_returns_the_feedback_of_each_misconception() {
    let (mut copied, mut kinds) = (0, BTreeSet::new());
    for round in asked() {
        let xml = Worksheet::moodle_xml(&[Worksheet::new(&round, None)]);
        let document = Document::parse(&xml).unwrap();
        let nodes = questions(&document);
        assert_eq!(nodes.len(), round.questions().len());
        for (question, node) in round.questions().iter().zip(nodes) {
            let node = node.to_owned();
            let kind = node.attribute("type").unwrap();
            kinds.insert(kind.to_owned());
            let name = text(node, "name");
            assert!(name.ends_with(&question.topic.name()), "{name}");
            let asked = words(&text(node, "questiontext"));
            assert!(asked.contains(&question.text), "{asked}");
            let general = words(&text(node, "generalfeedback"));
            assert!(general.contains(&question.why), "{general}");
            assert!(!asked.contains(&question.why));
            let truth = graded(question, node, &question.form.truth());
            assert!(truth.0 > 99.9, "{}: {:?}", question.text, truth);
            for belief in &question.beliefs {
                let (points, feedback) = graded(question, node, &belief.said);
                let most = match question.form {
                    Form::Rays { .. } | Form::Shot(_) => 80.0,
                    _ => 0.0,
                };
                assert!(
                    points <= most,
                    "{points} for {belief:?} in {}",
                    question.text
                );
                assert!(
                    feedback.contains(&belief.says),
                    "{belief:?} in {}: {feedback}",
                    question.text
                );
                let is_number = matches!(question.form, Form::Number { .. });
                if is_number && belief.misconception == Misconception::CopiedAngle {
                    assert_eq!(feedback, belief.says);
                    copied += 1;
                }
            }
            for (choice, says) in &question.replies {
                let (points, feedback) = graded(question, node, &Response::Choice(*choice));
                assert!(points <= 0.0 && feedback == *says, "{says}: {feedback}");
            }
            if let Form::Choice { options, .. } = &question.form {
                let said = answers(node).into_iter().map(|it| words(&it.said));
                assert_eq!(said.collect::<Vec<_>>(), *options);
            }
        }
    }
    assert_eq!(kinds.len(), 3, "{kinds:?}");
    assert!(copied > 0, "no number shows the copied angle");
}

/// Moodle's tolerance is the same on both sides, so where carrom compares numbers by their ratio,
/// Moodle also accepts a number up to 0.3 % below carrom's range.
#[test]
fn a_number_is_right_in_moodle_where_it_is_right_in_carrom() {
    for round in rounds() {
        let xml = Worksheet::moodle_xml(&[Worksheet::new(&round, None)]);
        let document = Document::parse(&xml).unwrap();
        for (question, node) in round.questions().iter().zip(questions(&document)) {
            let Form::Number { truth, .. } = question.form else {
                continue;
            };
            for percent in 0..200 {
                let said = Response::Number(truth * f64::from(percent) / 100.0 + 1e-4);
                let here = question.form.is_right(&said);
                let near = question.form.distance(&said, &question.form.truth());
                let there = graded(question, node, &said).0 > 99.0;
                assert!(
                    here == there || (0.99..1.06).contains(&near),
                    "{said:?}: {near} in {}",
                    question.text
                );
            }
        }
    }
}

#[test]
fn a_ray_that_is_wrong_loses_its_own_points_only() {
    let round = Round::of(Code::parse("from-angle-5").unwrap());
    let xml = Worksheet::moodle_xml(&[Worksheet::new(&round, None)]);
    let document = Document::parse(&xml).unwrap();
    for (question, node) in round.questions().iter().zip(questions(&document)) {
        let Form::Rays { truth, .. } = &question.form else {
            panic!("expected two rays");
        };
        let said = |by: f64| {
            let striker = truth.striker.map(|angle| angle + by.to_radians());
            let rays = Rays { striker, ..*truth };
            graded(question, node, &Response::Rays(rays)).0
        };
        for (by, percent) in [(0.0, 100.0), (3.9, 100.0), (-3.9, 100.0), (4.2, 75.0)] {
            assert!((said(by) - percent).abs() < 1e-9, "{by}: {}", said(by));
        }
    }
}

#[test]
fn pictures_are_in_the_file_and_show_no_answer_before_it_is_given() {
    let round = Round::of(Code::parse("mixed12-7").unwrap());
    let sheet = Worksheet::new(&round, None);
    let xml = Worksheet::moodle_xml(std::slice::from_ref(&sheet));
    let document = Document::parse(&xml).unwrap();
    let mut count = 0;
    for node in questions(&document) {
        for part in ["questiontext", "generalfeedback"] {
            let html = text(node, part);
            let files = child(node, part)
                .children()
                .filter(|it| it.has_tag_name("file"));
            let files: Vec<Node> = files.collect();
            assert_eq!(html.matches("@@PLUGINFILE@@").count(), files.len());
            for file in files {
                let name = file.attribute("name").unwrap();
                assert!(html.contains(&format!("src=\"@@PLUGINFILE@@/{name}\"")));
                assert_eq!(file.attribute("encoding"), Some("base64"));
                let bytes = data_encoding::BASE64.decode(file.text().unwrap().as_bytes());
                let svg = String::from_utf8(bytes.unwrap()).unwrap();
                Document::parse(&svg).unwrap();
                let is_answer = part == "generalfeedback";
                assert_eq!(name.starts_with("answer-"), is_answer, "{name}");
                assert!(is_answer || !svg.contains("θ₁"), "{name}");
                count += 1;
            }
        }
    }
    assert!(count > 12, "{count}");
}

/// What a teacher may write in a question of their own.
const ODD: &str = r##"
format = 1

[[item]]
id = "odd"
difficulty = "easy"
ask = "Is ]]> & <b> \\\\ or ~#/ \"fine\"?"
right = "Yes: ]]> & <i>"
why = "Because & < > ]]> ~ # are only text\uFFFE."

[[item.wrong]]
choice = "No: x ~ y # z"
misconception = "copied-angle"
says = "No: x ~ y # z is only text."

[[item.wrong]]
choice = "Perhaps"
says = "Perhaps not."
"##;

#[test]
fn any_characters_are_shown_as_text() {
    let mut library = Library::default();
    library.add_bytes("odd.toml".as_ref(), ODD.as_bytes());
    assert!(library.problems.is_empty(), "{:?}", library.problems);
    let code = Code::parse("own1-1").unwrap();
    let round = Round::of(code.with_own(&library.into()).unwrap());
    let xml = Worksheet::moodle_xml(&[Worksheet::new(&round, Some("<&]]>"))]);
    let document = Document::parse(&xml).unwrap();
    let question = &round.questions()[0];
    let node = questions(&document)[0];
    assert!(words(&text(node, "questiontext")).contains(&question.text));
    let general = words(&text(node, "generalfeedback"));
    assert!(general.contains("~ # are only text."), "{general}");
    let Form::Choice { options, .. } = &question.form else {
        panic!("expected choices");
    };
    let said = answers(node).into_iter().map(|it| words(&it.said));
    assert_eq!(said.collect::<Vec<_>>(), *options);
}

#[test]
fn each_version_has_a_category_of_its_own() {
    let folder = Folder::new("moodle");
    let file = folder.path().join("round.xml");
    let arguments = ["--code", "speeds2-3", "--moodle", file.to_str().unwrap()];
    let output = worksheet(&arguments);
    assert!(output.status.success(), "{}", err(&output));
    let printed = String::from_utf8(output.stdout).unwrap();
    assert_eq!(printed.trim(), file.display().to_string());
    let round = Round::of(Code::parse("speeds2-3").unwrap());
    let sheet = Worksheet::new(&round, None);
    let written = fs::read_to_string(&file).unwrap();
    assert_eq!(written, Worksheet::moodle_xml(&[sheet]));
    assert!(written.contains("<text>$course$/top/speeds2-3</text>"));
    assert_eq!(worksheet(&arguments).status.code(), Some(1), "it exists");

    let sheets = folder.path().join("sheets");
    let more = [
        "--versions",
        "2",
        "--force",
        "--out",
        sheets.to_str().unwrap(),
    ];
    let output = worksheet(&[&arguments[..], &more].concat());
    assert!(output.status.success(), "{}", err(&output));
    let written = fs::read_to_string(&file).unwrap();
    let document = Document::parse(&written).unwrap();
    assert_eq!(questions(&document).len(), 4);
    for version in ["A", "B"] {
        let category = format!("<text>$course$/top/speeds2-3, version {version}</text>");
        assert!(written.contains(&category), "{category}");
    }
    assert!(sheets.join("worksheet-b.html").is_file());
}

/// In a round about speeds, every answer has the unit m/s.
#[test]
fn a_number_may_be_entered_with_its_unit() {
    let kind = CourseKind::topics().find(|family| *family == Family::Speeds);
    assert!(kind.is_some());
    let round = Round::of(Code::parse("speeds-5").unwrap());
    let xml = Worksheet::moodle_xml(&[Worksheet::new(&round, None)]);
    let document = Document::parse(&xml).unwrap();
    for node in questions(&document) {
        let unit = child(child(node, "units"), "unit");
        assert_eq!(child(unit, "unit_name").text(), Some("m/s"));
        let asked = words(&text(node, "questiontext"));
        assert!(asked.contains("Give your answer in m/s."), "{asked}");
    }
}

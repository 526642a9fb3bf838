//! The report on a player's progress, for any name and any answers, read back by real parsers.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use carrom::app::App;
use carrom::files::is_invisible;
use carrom::lessons::{self, Bookmark, Chapter, Checkpoint, CheckpointKind, GivenAnswer};
use carrom::levels;
use carrom::levels::Starred;
use carrom::messages::{History, PlayerAction, StoreCall, StoreReply, StoreRequest};
use carrom::paper::clean;
use carrom::paper::report::{Report, Sources};
use carrom::progress::{Attempt, Calendar, LESSON, csv, json};
use carrom::quiz::Confidence;
use carrom::quiz::{Figures, Rays, Response};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::store::Store;
use carrom::widgets::Charset;
use pulldown_cmark::{Event, Options, Parser, Tag};
use scraper::{Html, Node, Selector};

use crate::folder::Folder;

fn nasty_names() -> Vec<String> {
    let mut names: Vec<String> = [
        "שלום עולם",
        "مرحبا",
        "a\u{202e}b\u{2066}c",
        "e\u{301}\u{302}\u{303}",
        "👩‍👩‍👧‍👦 🏴\u{e0067}\u{e0062}\u{e0065}\u{e006e}\u{e0067}\u{e007f}",
        "球 さん",
        "O'Hara \"Q\" & Söhne",
        "two\r\nlines\tand\u{2028}more",
        "</title></h1></script><script>alert(1)</script>",
        "<img src=x onerror=alert(1)>",
        "\"><svg onload=alert(1)>",
        "<!-- ]]> --> &amp; &#0; {{x}}",
        "=HYPERLINK(\"http://x.invalid\",\"y\")",
        "@SUM(A1)|cmd",
        "+1-1",
        "a;=1+1\n=1+1",
        "*a* _b_ `c` [d](e) ![f](g) | h | ~i~ $j$",
        "# a\n- b\n> c\n---",
        "\u{0}\u{1b}[2J\u{7f}\u{9b}x\u{feff}\u{fffe}",
        "\u{200b}",
        "../../etc/passwd",
        "'; DROP TABLE attempt; --",
    ]
    .map(str::to_owned)
    .into();
    names.push("x".repeat(10_000));
    names.push("球\n\"=<".repeat(2_000));
    names.push(format!("e{}", "\u{301}".repeat(10_000)));
    names
}

fn attempt(player: &str, number: u32) -> Attempt {
    Attempt {
        time_s: None,
        player: player.into(),
        family: "where-to".into(),
        topic: player.into(),
        seed: 7,
        number,
        question: Figures::new(),
        answer: Figures::new(),
        truth: Figures::new(),
        error_deg: Some(f64::from(number)),
        credit: 0.5,
        right: number <= 4,
        confidence: Some(Confidence::ThinkSo),
        misconception: (number > 4).then(|| "copied-angle".into()),
    }
}

fn ask(store: &mut Store, request: StoreRequest) -> StoreReply {
    store.answer(&StoreCall { ticket: 0, request }).done
}

/// A store's data about a player who answered six questions and won a level.
fn kept(folder: &Path, player: &str) -> (History, Vec<Starred>) {
    let mut store = Store::in_folder(folder);
    for number in 1..=6 {
        let request = StoreRequest::Note(PlayerAction::Record(Box::new(attempt(player, number))));
        assert_eq!(ask(&mut store, request), StoreReply::Noted(Ok(())));
    }
    let (pack, level) = first_level();
    let star = Starred {
        pack,
        level,
        stars: 2,
    };
    ask(
        &mut store,
        StoreRequest::Note(PlayerAction::Star(player.into(), star)),
    );
    let mut store = Store::in_folder(folder);
    let StoreReply::Recalled(Ok(history)) =
        ask(&mut store, StoreRequest::Recall(Some(player.into())))
    else {
        panic!("nothing is recalled");
    };
    let StoreReply::Stars(Ok(stars)) = ask(&mut store, StoreRequest::Stars(player.into())) else {
        panic!("no stars are recalled");
    };
    assert_eq!((history.attempts.len(), stars.len()), (6, 1));
    (*history, stars)
}

fn first_level() -> (String, String) {
    let pack = &levels::LevelLibrary::embedded_once().packs[0];
    (pack.name.clone(), pack.levels[0].id.clone())
}

fn report<'a>(player: &'a str, history: &'a History, stars: &'a [Starred]) -> Report<'a> {
    static UNREAD: BTreeMap<String, Bookmark> = BTreeMap::new();
    with_marks(player, history, stars, &UNREAD)
}

fn with_marks<'a>(
    player: &'a str,
    history: &'a History,
    stars: &'a [Starred],
    marks: &'a BTreeMap<String, Bookmark>,
) -> Report<'a> {
    Report::new(&Sources {
        player,
        history,
        marks,
        stars,
        next: "Find out what you believe.",
        levels: levels::LevelLibrary::embedded_once(),
        lessons: lessons::ChapterLibrary::embedded_once(),
    })
}

fn html(report: &Report) -> String {
    Report::html(std::slice::from_ref(report))
}

/// The elements of a document in order, and a function that returns the text of the first match for
/// a selector.
fn read_html(html: &str) -> (Vec<String>, impl Fn(&str) -> String + use<>) {
    let document = Html::parse_document(html);
    let mut elements = Vec::new();
    for node in document.tree.nodes() {
        if let Node::Element(element) = node.value() {
            elements.push(element.name().to_owned());
            for (name, value) in element.attrs() {
                assert!(!name.starts_with("on") && name != "src" && name != "href");
                assert!(!value.contains("script"), "{name}={value}");
            }
        }
    }
    assert!(!elements.iter().any(|it| it == "script" || it == "img"));
    let text = move |name: &str| {
        let selector = Selector::parse(name).unwrap();
        let found = document.select(&selector).next();
        found.map_or(String::new(), |it| it.text().collect())
    };
    (elements, text)
}

/// The tags of a document in order, and its first piece of text.
fn read_markdown(text: &str) -> (Vec<String>, String) {
    let (mut tags, mut first) = (Vec::new(), String::new());
    let options = Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH | Options::ENABLE_MATH;
    for event in Parser::new_ext(text, options) {
        match event {
            Event::Start(Tag::Image { dest_url, .. }) => tags.push(dest_url.to_string()),
            Event::Start(tag) => tags.push(format!("{:?}", tag.to_end())),
            Event::Text(text) if tags.len() == 1 => first.push_str(&text),
            Event::Text(_) | Event::End(_) | Event::Rule => {}
            other => panic!("{other:?}"),
        }
    }
    (tags, first)
}

#[test]
fn no_name_breaks_a_report() {
    let folder = Folder::new("report-names");
    let (plain, stars) = kept(folder.path(), "Ada");
    let plain = report("Ada", &plain, &stars);
    let elements = read_html(&html(&plain)).0;
    let tags = read_markdown(&plain.markdown("pictures")).0;
    assert!(elements.iter().filter(|it| *it == "svg").count() == 3 && tags.len() > 20);
    for name in nasty_names() {
        let (history, stars) = kept(folder.path(), &name);
        let report = report(&name, &history, &stars);
        let shown = match clean(&name, 44) {
            shown if shown.is_empty() => "a player without a name".to_owned(),
            shown => shown,
        };
        let html = html(&report);
        let (found, text) = read_html(&html);
        assert_eq!(found, elements, "{name:?}");
        assert_eq!(text("h1"), shown);
        assert_eq!(text("title"), format!("{shown}: glancing collisions"));
        // An unknown topic is named by the words of its id.
        assert_eq!(text("tbody td"), clean(&name.replace('-', " "), 40));
        let (found, first) = read_markdown(&report.markdown("pictures"));
        assert_eq!(found, tags, "{name:?}");
        assert_eq!(first, shown);
        for text in [&html, &report.markdown("pictures")] {
            let is_bad = |c: char| c.is_control() && c != '\n' || "\u{202e}\u{2066}".contains(c);
            assert!(!text.contains(is_bad), "{name:?}");
        }
        for picture in report.pictures() {
            roxmltree::Document::parse(&picture.svg.file()).unwrap();
        }
    }
}

#[test]
fn no_name_breaks_the_table_or_the_json() {
    let folder = Folder::new("report-table");
    for name in nasty_names() {
        let (history, _) = kept(folder.path(), &name);
        let table = csv(&history.attempts).unwrap();
        let rows: Vec<_> = csv_rows(&table);
        assert_eq!(rows.len(), 6);
        for row in &rows {
            assert_eq!(
                (row.len(), &row[11]),
                (18, if &row[9] <= "4" { "yes" } else { "no" })
            );
            let shown = |c: &char| matches!(c, '\n' | '\r' | '\t') || !is_invisible(*c);
            let shown: String = name.chars().filter(shown).collect();
            assert_eq!(row[1].replace('\'', ""), shown.replace('\'', ""));
        }
        let json = json(&history.attempts, &[], None, serde_json::Value::Null).unwrap();
        let read: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(read["attempts"][5]["player"], *name);
        assert_eq!(
            read["summary"]["topics"][0]["topic"],
            name.replace('-', " ")
        );
    }
}

fn csv_rows(table: &str) -> Vec<csv::StringRecord> {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    reader.records().map(Result::unwrap).collect()
}

#[test]
fn no_name_breaks_a_screen() {
    for name in nasty_names() {
        for charset in [Charset::Ascii, Charset::Unicode] {
            for place in [Route::Home, Route::Progress, Route::Levels, Route::Table] {
                let settings = Settings {
                    charset,
                    player: name.clone(),
                    ..Settings::default()
                };
                let mut game = Headless::new(App::new(place, settings, 7), 80, 24);
                let screen = game.screen();
                let lines: Vec<_> = screen.lines().collect();
                assert!(lines.len() <= 24);
                let is_bad = |c: char| {
                    c.is_control()
                        || "\u{202e}\u{2066}".contains(c)
                        || (charset == Charset::Ascii && !c.is_ascii())
                };
                for line in lines {
                    assert!(!line.contains(is_bad), "{line:?}");
                    assert!(
                        unicode_width::UnicodeWidthStr::width(line) <= 80,
                        "{line:?}"
                    );
                }
            }
        }
    }
}

/// An answer of the kind that a checkpoint requires.
fn fitting(checkpoint: &Checkpoint) -> Response {
    match checkpoint.asked {
        CheckpointKind::Rays => Response::Rays(Rays::new(1.0, 0.5)),
        CheckpointKind::Number { .. } => Response::Number(1.0),
        CheckpointKind::Choice(_) => Response::Choice(0),
    }
}

/// A bookmark with all pages of a chapter seen and answered, the first `right` questions correctly.
fn read_through(chapter: &Chapter, right: usize) -> Bookmark {
    let mut mark = Bookmark::default();
    let mut asked = 0;
    for page in &chapter.pages {
        let given = page.checkpoint.as_ref().map(|checkpoint| {
            asked += 1;
            GivenAnswer {
                asked: checkpoint.written.clone(),
                answer: fitting(checkpoint),
                right: asked <= right,
                first: None,
            }
        });
        mark.pages.insert(page.title.clone(), given);
    }
    mark
}

#[test]
fn the_report_lists_chapters_as_learn_does() {
    let chapters = &lessons::ChapterLibrary::embedded_once().chapters;
    let (first, second) = (&chapters[0], &chapters[1]);
    let marks = BTreeMap::from([
        (first.id.clone(), read_through(first, 2)),
        (second.id.clone(), Bookmark::at(&second.pages[0])),
    ]);
    let history = History {
        attempts: vec![attempt("Ada", 1)],
        observations: Vec::new(),
        calendar: Calendar::default(),
    };
    let report = with_marks("Ada", &history, &[], &marks);
    let html = html(&report);
    let text: String = Html::parse_document(&html).root_element().text().collect();
    // As in Learn, a chapter is done once it is read and answered, whether the answers are right or
    // not.
    assert!(text.contains(&format!("1 of {}chapters done", chapters.len())));
    let (pages, asked) = (first.pages.len(), first.checkpoints());
    let row = format!("{}{pages} of {pages}2 of {asked}", first.title);
    assert!(text.contains(&row), "{text}");
    let row = format!("{}1 of {}0 of", second.title, second.pages.len());
    assert!(text.contains(&row), "{text}");
    let markdown = report.markdown("pictures");
    let row = format!("| {} | {pages} of {pages} | 2 of {asked} |", first.title);
    assert!(markdown.contains(&row), "{markdown}");
}

#[test]
fn a_mean_error_requires_three_angles() {
    let of = |angles: u32| {
        let attempts = (1..=5).map(|i| Attempt {
            error_deg: (i <= angles).then_some(12.0),
            ..attempt("Ada", i)
        });
        History {
            attempts: attempts.collect(),
            observations: Vec::new(),
            calendar: Calendar::default(),
        }
    };
    assert!(!html(&report("Ada", &of(2), &[])).contains("mean error"));
    let (history, told) = (of(3), "12.0°</strong>");
    let html = html(&report("Ada", &history, &[]));
    assert!(html.contains(told) && html.contains("mean error of 3 angles"));
}

#[test]
fn the_report_of_a_player_without_answers_explains_that_there_are_none() {
    let history = History::default();
    let report = report("Ada", &history, &[]);
    assert!(report.pictures().is_empty());
    for text in [html(&report), report.markdown("pictures")] {
        assert!(text.contains("every game starts with a clean board"));
        assert!(text.contains("Find out what you believe"));
        assert!(!text.contains("NaN") && !text.contains("inf "));
    }
}

#[test]
fn one_answer_is_enough_for_a_report() {
    for error_deg in [None, Some(0.0), Some(180.0)] {
        let one = Attempt {
            error_deg,
            time_s: Some(1_795_000_000),
            ..attempt("Ada", 1)
        };
        let history = History {
            observations: Vec::new(),
            attempts: vec![one],
            calendar: Calendar::utc(Some(1_795_000_000)),
        };
        let report = report("Ada", &history, &[]);
        let html = html(&report);
        let (_, text) = read_html(&html);
        // 1 795 000 000 s is 18 November 2026, 11:06:40 UTC.
        assert_eq!(
            text("header"),
            "carrom · glancing collisionsAda1 answer on 18 November 2026"
        );
        assert!(!html.contains("NaN"), "{html}");
        let shown = usize::from(error_deg.is_some()) + 1;
        assert_eq!(report.pictures().len(), shown);
    }
}

#[test]
fn a_report_on_thousands_of_answers_fits_on_one_page() {
    let library = lessons::ChapterLibrary::embedded_once();
    let attempts: Vec<_> = (0..5_000_u32)
        .map(|i| {
            let read = i % 5 == 0;
            Attempt {
                time_s: Some(1_700_000_000 + i64::from(i) * 9_000),
                family: if read { LESSON } else { "where-to" }.into(),
                topic: format!("topic {}", i % 70),
                error_deg: Some(40.0 / (1.0 + f64::from(i) / 500.0)),
                right: i > 4_000,
                confidence: Some(Confidence::ALL[i as usize % 3]),
                misconception: carrom::quiz::Misconception::ALL
                    .get(i as usize % 13)
                    .map(|it| it.id().to_owned()),
                ..attempt("Ada", i % 9)
            }
        })
        .collect();
    let history = History {
        observations: Vec::new(),
        attempts,
        calendar: Calendar::utc(Some(1_795_000_000)),
    };
    let chapters = library.chapters.iter();
    let marks: BTreeMap<_, _> = chapters
        .map(|chapter| (chapter.id.clone(), read_through(chapter, 3)))
        .collect();
    let report = with_marks("Ada", &history, &[], &marks);
    let html = html(&report);
    let (elements, _) = read_html(&html);
    // Shortened tables keep the report on one page and the file small.
    assert!(elements.iter().filter(|it| *it == "tr").count() <= 35);
    assert!(html.len() < 60_000, "{}", html.len());
    assert!(html.contains("and 46 more"), "10 of 56 topics are shown");
    let first: f64 = (0..10).map(|i| 40.0 / (1.0 + f64::from(i) / 500.0)).sum();
    let first = format!("{:.1}° → ", first / 10.0);
    assert!(html.contains(&first), "{first}");
    let (tags, _) = read_markdown(&report.markdown("pictures"));
    assert!(tags.iter().filter(|it| *it == "TableRow").count() <= 50);
}

fn carrom(arguments: &[&str], data: &Path, folder: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carrom"))
        .args(arguments)
        .arg("--data-dir")
        .arg(data)
        .current_dir(folder)
        .output()
        .unwrap()
}

#[test]
fn a_report_is_written_to_the_given_path() {
    let folder = Folder::new("report-written");
    let name = "Zoë \"=<b>";
    kept(folder.path(), name);
    let run = |file: &str| {
        let arguments = ["progress", "--player", name, "--report", file];
        carrom(&arguments, folder.path(), folder.path())
    };
    for file in ["a.html", "B.HTML", "c.md", "my report (1).md"] {
        let output = run(file);
        assert!(output.status.success(), "{output:?}");
        assert!(output.stdout.is_empty() && output.stderr.is_empty());
    }
    let page = fs::read_to_string(folder.path().join("a.html")).unwrap();
    assert_eq!(read_html(&page).1("h1"), name);
    for (file, beside) in [("c.md", "c"), ("my report (1).md", "my report (1)")] {
        let text = fs::read_to_string(folder.path().join(file)).unwrap();
        let (tags, first) = read_markdown(&text);
        assert_eq!(first, name);
        let pictures: Vec<_> = tags.iter().filter(|it| it.ends_with(".svg")).collect();
        assert_eq!(pictures.len(), 3);
        for picture in pictures {
            // Spaces and brackets are percent-encoded in URLs.
            let place = picture
                .replace("%20", " ")
                .replace("%28", "(")
                .replace("%29", ")");
            assert!(place.starts_with(beside), "{place}");
            let svg = fs::read_to_string(folder.path().join(place)).unwrap();
            roxmltree::Document::parse(&svg).unwrap();
        }
    }
    // Another player has no answers, which is not an error.
    let output = carrom(
        &["progress", "--report", "d.md"],
        folder.path(),
        folder.path(),
    );
    assert!(output.status.success());
    assert!(!folder.path().join("d-pictures").exists());
}

#[test]
fn a_failed_write_is_reported() {
    let folder = Folder::new("report-refused");
    for file in ["a.pdf", "a", ".html", "html", "a.html.txt", ""] {
        let output = carrom(
            &["progress", "--report", file],
            folder.path(),
            folder.path(),
        );
        assert_eq!(output.status.code(), Some(2), "{file}");
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains("--report <FILE>"), "{said}");
        assert!(
            said.contains("ends in .html or .md") || file.is_empty(),
            "{said}"
        );
    }
    let both = ["progress", "--report", "a.html", "--csv"];
    assert_eq!(
        carrom(&both, folder.path(), folder.path()).status.code(),
        Some(2)
    );
    let nowhere = ["progress", "--report", "no/such/folder/a.html"];
    let output = carrom(&nowhere, folder.path(), folder.path());
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(
        said.contains("cannot write no/such/folder/a.html"),
        "{said}"
    );
}

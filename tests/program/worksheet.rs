//! Worksheets: the questions of a round and their answer key, on paper.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use carrom::paper::clean;
use carrom::paper::worksheet::Worksheet;
use carrom::quiz::{Code, CourseKind, Form, Illustration, Response, Round};
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use scraper::{Html, Selector};

use crate::folder::Folder;

/// One round of each topic, and rounds of other kinds.
pub(crate) fn rounds() -> impl Iterator<Item = Round> {
    let topics = CourseKind::topics().map(|family| format!("{}-5", family.id()));
    let mixed = ["mixed12-7", "mixed1-3", "quick-5", "exam-3", "7"].map(str::to_owned);
    let codes = topics.chain(mixed);
    codes.map(|code| Round::of(Code::parse(&code).unwrap_or_else(|| panic!("{code}"))))
}

fn select(page: &Html, selector: &str) -> Vec<String> {
    let selector = Selector::parse(selector).unwrap();
    let found = page.select(&selector);
    // No-break spaces matter only for line breaks, so they are read as spaces.
    let text = found.map(|it| it.text().collect::<String>());
    text.map(|it| it.replace('\u{a0}', " ")).collect()
}

/// The text on one line.
fn line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn the_sheet_has_the_questions_of_the_code_and_no_answers() {
    for round in rounds() {
        let sheet = Worksheet::new(&round, None);
        let (html, markdown) = (sheet.sheet_html(), sheet.sheet_markdown("pictures"));
        let page = Html::parse_document(&html);
        let texts: Vec<_> = round.questions().iter().map(|it| it.text.clone()).collect();
        assert!(!texts.is_empty());
        assert_eq!(select(&page, ".question .said > p:first-child"), texts);
        assert_eq!(select(&page, ".sure").len(), texts.len());
        let code = round.code().to_string();
        assert_eq!(select(&page, ".code strong"), [code.as_str()]);
        assert!(html.contains(&format!("carrom quiz --code {code}")));
        let plain = read(&markdown).0;
        for question in round.questions() {
            assert!(plain.contains(&line(&question.text)), "{plain}");
            assert!(!html.contains(&question.why) && !plain.contains(&line(&question.why)));
            if let Form::Choice { options, .. } = &question.form {
                for option in options {
                    assert!(select(&page, ".choices span").contains(option));
                    assert!(plain.contains(&line(option)), "{plain}");
                }
            }
        }
        for picture in sheet.pictures() {
            let Some(number) = picture.name.strip_prefix("question-") else {
                continue;
            };
            let number: usize = number.strip_suffix(".svg").unwrap().parse().unwrap();
            let asked = &round.questions()[number - 1];
            if matches!(asked.picture, Illustration::Before { .. }) {
                let file = picture.svg.file();
                for letter in ["θ", "v₁", "v₂"] {
                    assert!(!file.contains(letter), "{letter}: {}", asked.text);
                }
            }
        }
    }
}

#[test]
fn the_key_has_all_right_answers_and_all_misconceptions() {
    for round in rounds() {
        let sheet = Worksheet::new(&round, None);
        let page = Html::parse_document(&sheet.key_html());
        let truths = select(&page, ".truth");
        let glance = select(&page, ".glance li");
        let plain = read(&sheet.key_markdown("pictures")).0;
        assert_eq!(truths.len(), round.questions().len());
        assert_eq!(glance, truths);
        let rows = select(&page, ".beliefs tbody tr");
        for (question, truth) in round.questions().iter().zip(&truths) {
            let words = question.form.words(&question.form.truth());
            assert!(truth.ends_with(&words), "{truth}: {words}");
            for text in [&words, &question.why] {
                assert!(plain.contains(&line(text)), "{text} in {plain}");
            }
            for belief in &question.beliefs {
                let said = question.form.words(&belief.said);
                let name = belief.misconception.name();
                let parts = [said.as_str(), name, &belief.says];
                let is_it = |row: &String| parts.iter().all(|part| row.contains(part));
                assert!(rows.iter().any(is_it), "{parts:?}");
                assert!(plain.contains(&line(&belief.says)), "{plain}");
            }
        }
        // Choices without a known misconception have rows of their own with their replies.
        for question in round.questions() {
            for (choice, reply) in &question.replies {
                let said = question.form.words(&Response::Choice(*choice));
                let is_it = |row: &String| row.contains(&said) && row.contains(reply.as_str());
                assert!(rows.iter().any(is_it), "{said}: {reply}");
                assert!(plain.contains(&line(reply)), "{plain}");
            }
        }
        let told = round.questions().iter();
        let told = told.map(|it| it.beliefs.len() + it.replies.len());
        assert_eq!(rows.len(), told.sum::<usize>());
    }
}

#[test]
fn nothing_is_loaded_nothing_runs_and_every_number_is_finite() {
    for round in rounds() {
        let sheet = Worksheet::new(&round, None);
        for html in [sheet.sheet_html(), sheet.key_html(), sheet.html_with_key()] {
            let page = Html::parse_document(&html);
            for selector in ["[src]", "[href]", "script", "link", "iframe", "object"] {
                assert!(select(&page, selector).is_empty(), "{selector}");
            }
            let namespace = "xmlns=\"http://www.w3.org/2000/svg\"";
            let rest = html.replace(namespace, "");
            for word in ["://", "url(", "@import", "NaN", "inf ", "undefined"] {
                assert!(!rest.contains(word), "{word} in {}", round.code());
            }
        }
        for picture in sheet.pictures() {
            let file = picture.svg.file();
            assert!(!file.contains("NaN") && !file.contains("inf"));
            roxmltree::Document::parse(&file).unwrap();
        }
    }
}

#[test]
fn the_same_code_and_title_give_the_same_bytes() {
    let documents = || {
        let round = Round::of(Code::parse("mixed12-7").unwrap());
        let sheet = Worksheet::new(&round, Some("a"));
        let pictures = sheet.pictures().into_iter().map(|it| it.svg.file());
        let mut all: Vec<_> = pictures.collect();
        all.extend([sheet.html_with_key(), sheet.sheet_html(), sheet.key_html()]);
        all.extend([sheet.sheet_markdown("p"), sheet.key_markdown("p")]);
        all
    };
    assert_eq!(documents(), documents());
}

/// The text of a Markdown document with one line per block, its pictures, and its other elements.
fn read(document: &str) -> (String, Vec<String>, BTreeSet<String>) {
    let (mut text, mut pictures, mut others) = (String::new(), Vec::new(), BTreeSet::new());
    let options = Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH;
    for event in Parser::new_ext(document, options) {
        match event {
            Event::Text(piece) => text.push_str(&piece),
            Event::Start(Tag::Image { dest_url, .. }) => pictures.push(dest_url.to_string()),
            Event::Start(tag) => {
                let kind = format!("{tag:?}");
                let kind: String = kind.chars().take_while(|c| c.is_alphanumeric()).collect();
                others.insert(kind);
            }
            Event::End(_) => text.push('\n'),
            Event::SoftBreak => text.push(' '),
            other => {
                others.insert(format!("{other:?}"));
            }
        }
    }
    // No-break spaces matter only for line breaks, so they are read as spaces.
    (text.replace('\u{a0}', " "), pictures, others)
}

#[test]
fn any_title_is_shown_as_plain_text() {
    let round = Round::of(Code::parse("quick-1").unwrap());
    let usual = read(&Worksheet::new(&round, None).sheet_markdown("p")).2;
    let many = "x".repeat(10_000);
    for title in [
        "<script>alert(1)</script>",
        "</title></h1><img src=x onerror=alert(1)>",
        "\"' onload=\"x\" &amp; <!-- ]]>",
        "two\nlines\r\n# and [a](http://b.c) ![d](e) `f` *g* | h",
        "\u{202e}turned\u{0}\u{1b}[2J",
        "- a\n---\n1. b",
        "=1+1",
        "שלום 球 👩‍👩‍👧‍👦",
        many.as_str(),
    ] {
        let sheet = Worksheet::new(&round, Some(title));
        let html = sheet.html_with_key();
        let page = Html::parse_document(&html);
        let expected = clean(title, 120);
        let heads = select(&page, "h1");
        assert_eq!(heads, [expected.clone(), format!("Key: {expected}")]);
        assert_eq!(
            select(&page, "head > title"),
            std::slice::from_ref(&expected)
        );
        assert!(select(&page, "script").is_empty() && select(&page, "img").is_empty());
        let (text, pictures, others) = read(&sheet.sheet_markdown("p"));
        assert_eq!(text.lines().next().unwrap(), line(&expected));
        assert!(pictures.iter().all(|it| it.starts_with("p/question-")));
        assert_eq!(others, usual, "{title}");
    }
    for title in ["", " \n", "\u{200b}"] {
        let html = Worksheet::new(&round, Some(title)).sheet_html();
        assert!(html.contains("<h1><bdi>Glancing collisions</bdi></h1>"));
    }
}

/// The path for a file with this name in a folder.
fn within(folder: &Folder, name: &str) -> String {
    folder.path().join(name).to_str().unwrap().into()
}

pub(crate) fn worksheet(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carrom"))
        .arg("worksheet")
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

pub(crate) fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

#[test]
fn existing_worksheets_are_replaced_only_with_force() {
    let folder = Folder::new("files");
    let out = within(&folder, "new/sheets");
    let ask = ["--seed", "7", "--count", "12", "--out", &out];
    let output = worksheet(&ask);
    assert!(output.status.success(), "{}", err(&output));
    let named = String::from_utf8(output.stdout).unwrap();
    let names = ["worksheet.html", "worksheet.md", "key.html", "key.md"];
    let expected = names.map(|name| format!("{out}/{name}\n"));
    assert_eq!(named, expected.concat());
    let round = Round::of(Code::parse("mixed12-7").unwrap());
    let sheet = Worksheet::new(&round, None);
    let at = |name: &str| fs::read_to_string(Path::new(&out).join(name)).unwrap();
    assert_eq!(at("worksheet.html"), sheet.sheet_html());
    assert_eq!(at("key.html"), sheet.key_html());
    // Every picture that is referenced exists.
    for name in ["worksheet.md", "key.md"] {
        let pictures = read(&at(name)).1;
        assert!(!pictures.is_empty());
        for picture in pictures {
            assert!(at(&picture).contains("<svg "));
        }
    }
    // A second run changes nothing without --force.
    fs::write(Path::new(&out).join("key.md"), "mine").unwrap();
    fs::remove_file(Path::new(&out).join("worksheet.html")).unwrap();
    let output = worksheet(&ask);
    assert_eq!(output.status.code(), Some(1));
    let message = err(&output);
    assert!(message.contains("already exists (--force replaces it)"));
    assert_eq!(message.lines().count(), 1, "{message}");
    assert_eq!(at("key.md"), "mine");
    assert!(!Path::new(&out).join("worksheet.html").exists());
    assert!(
        worksheet(&[&ask[..], &["--force"]].concat())
            .status
            .success()
    );
    assert_eq!(at("key.md"), sheet.key_markdown("pictures"));
    assert_eq!(at("worksheet.html"), sheet.sheet_html());
}

#[test]
fn no_version_keeps_the_key_or_the_pictures_of_another_round() {
    let folder = Folder::new("versions");
    let out = within(&folder, "sheets");
    let ask = ["--versions", "2", "--out", &out, "--force"];
    let first = worksheet(&[&ask[..], &["--code", "mixed12-7"]].concat());
    assert!(first.status.success(), "{}", err(&first));
    let pictures = || fs::read_dir(format!("{out}/pictures-b")).unwrap().count();
    let before = pictures();
    let second = worksheet(&[&ask[..], &["--code", "mixed2-8", "--with-key"]].concat());
    assert!(second.status.success(), "{}", err(&second));
    for key in ["key-a.html", "key-a.md", "key-b.html", "key-b.md"] {
        assert!(!Path::new(&out).join(key).exists(), "{key}");
    }
    assert!(pictures() < before);
}

#[test]
fn one_document_can_have_a_code_a_title_and_the_key() {
    let folder = Folder::new("code");
    let out = within(&folder, "a");
    let arguments = [
        "--code",
        " Speeds-3 ",
        "--title",
        "-10b- <&>",
        "--with-key",
        "--out",
        &out,
    ];
    let output = worksheet(&arguments);
    assert!(output.status.success(), "{}", err(&output));
    let html = fs::read_to_string(folder.path().join("a/worksheet.html")).unwrap();
    let page = Html::parse_document(&html);
    assert_eq!(select(&page, "h1"), ["-10b- <&>", "Key: -10b- <&>"]);
    assert_eq!(select(&page, ".code strong"), ["speeds-3", "speeds-3"]);
    assert!(!folder.path().join("a/key.html").exists());
}

/// A typed title is shown literally in the Markdown of the sheet and the key too.
#[test]
fn a_title_is_escaped_in_markdown() {
    let folder = Folder::new("title");
    for (number, title) in [
        "# 1. *a* _b_ `c` ~~d~~ | e",
        "<script>alert(1)</script> &lt; <!-- x -->",
        "[a](http://b.c) ![d](e) [^1] www.f.g h@i.j",
        "1. $x$ ^y^ {{z}} ==m== ++n++ %%o%%",
        "- [ ] --- +",
    ]
    .into_iter()
    .enumerate()
    {
        let out = within(&folder, &number.to_string());
        let arguments = ["--code", "speeds2-3", "--title", title, "--out", &out];
        let output = worksheet(&arguments);
        assert!(output.status.success(), "{}", err(&output));
        for (name, heading) in [
            ("worksheet.md", title.to_owned()),
            ("key.md", format!("Key: {title}")),
        ] {
            let text = fs::read_to_string(Path::new(&out).join(name)).unwrap();
            let options = Options::all() - Options::ENABLE_SMART_PUNCTUATION;
            let mut events = Parser::new_ext(&text, options);
            let first = events.next();
            let is_heading = matches!(first, Some(Event::Start(Tag::Heading { .. })));
            assert!(is_heading, "{title}: {first:?}");
            let mut read = String::new();
            for event in events.by_ref() {
                match event {
                    Event::Text(text) => read.push_str(&text),
                    Event::End(TagEnd::Heading(_)) => break,
                    other => panic!("{title}: {other:?}"),
                }
            }
            assert_eq!(read, heading);
        }
    }
}

#[test]
fn invalid_options_are_reported() {
    let folder = Folder::new("wrong");
    let out = within(&folder, "out");
    fs::write(folder.path().join("file"), "").unwrap();
    let in_file = within(&folder, "file/sheets");
    for (arguments, status, message) in [
        (vec!["--out", &out], 2, "expected --seed N or --code CODE"),
        (
            vec!["--out", &out, "--seed", "1", "--code", "7"],
            2,
            "use either --seed or --code, not both",
        ),
        (
            vec!["--out", &out, "--count", "5", "--code", "7"],
            2,
            "cannot be used with",
        ),
        (vec!["--seed", "1"], 2, "--out <DIR>"),
        (
            vec!["--out", &out, "--seed", "1", "--count", "0"],
            2,
            "expected a number from 1 to 60",
        ),
        (
            vec!["--out", &out, "--seed", "1", "--count", "61"],
            2,
            "expected a number from 1 to 60",
        ),
        (
            vec!["--out", &out, "--seed", "1", "--count", "-3"],
            2,
            "expected a number from 1 to 60",
        ),
        (
            vec!["--out", &out, "--code", "review-7"],
            2,
            "a review has no code",
        ),
        (
            vec!["--out", &in_file, "--seed", "1"],
            1,
            "file: expected a folder, found a file",
        ),
    ] {
        let output = worksheet(&arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}");
        assert!(output.stdout.is_empty());
        let said = err(&output);
        assert!(said.contains(message), "{arguments:?}: {said}");
        assert!(!Path::new(&out).exists());
    }
}

/// A browser that can print, if this machine has one.
fn browser() -> Option<&'static str> {
    let names = ["chromium", "chromium-browser", "google-chrome"];
    names.into_iter().find(|name| {
        let mut command = Command::new(name);
        let command = command.arg("--version").stderr(Stdio::null());
        command.output().is_ok_and(|it| it.status.success())
    })
}

fn browse(browser: &str, folder: &Folder, arguments: &[&str]) -> String {
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu"])
        .arg(format!("--user-data-dir={}", within(folder, "profile")))
        .args(arguments)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", err(&output));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// A script that replaces the page with the height of each unbreakable block, and how far it
/// extends beyond the sheet on the right, in CSS pixels. A sheet is as wide on the screen as on
/// paper.
const MEASURE: &str = "<script>addEventListener('load', () => {
  const found = [...document.querySelectorAll('.question, .worked, figure, tr')];
  const lines = found.map(it => {
    const box = it.getBoundingClientRect();
    const sheet = it.closest('.worksheet').getBoundingClientRect();
    const svg = it.querySelector('svg');
    const right = Math.max(box.right, svg ? svg.getBoundingClientRect().right : 0);
    return `BOX ${it.tagName} ${Math.ceil(box.height)} ${Math.ceil(right - sheet.right)}`;
  });
  document.body.innerText = lines.join('\\n') + '\\n';
});</script></body>";

/// The height of an A4 page between its margins (270 mm), in CSS pixels.
const PAGE: f64 = 270.0 / 25.4 * 96.0;

pub(crate) fn printing_on_a4_splits_no_block_and_the_key_starts_a_page() {
    let Some(browser) = browser() else {
        eprintln!("skipped: Chromium was not found, so worksheets were not printed");
        return;
    };
    let folder = Folder::new("print");
    for code in ["mixed1-7", "mixed30-3"] {
        let round = Round::of(Code::parse(code).unwrap());
        let html = Worksheet::new(&round, None).html_with_key();
        let page = within(&folder, "page.html");
        // A browser keeps an unbreakable block on one page if the block fits on a page.
        let policy = html.find("<meta http-equiv").unwrap();
        let end = policy + html[policy..].find('>').unwrap() + 1;
        let measured = format!("{}{}", &html[..policy], &html[end..]).replace("</body>", MEASURE);
        fs::write(&page, measured).unwrap();
        let seen = browse(
            browser,
            &folder,
            &["--window-size=1000,1400", "--dump-dom", &page],
        );
        let boxes: Vec<Vec<&str>> = seen
            .split("BOX ")
            .skip(1)
            .map(|it| it.split(['<', '\n', ' ']).collect())
            .collect();
        assert!(boxes.len() > 2 * round.questions().len(), "{seen}");
        for found in boxes {
            let [height, over]: [f64; 2] = [1, 2].map(|i| found[i].parse().unwrap());
            assert!(height < PAGE && over <= 1.0, "{found:?} in {code}");
        }
        fs::write(&page, &html).unwrap();
        let pdf = within(&folder, "page.pdf");
        let print = format!("--print-to-pdf={pdf}");
        browse(browser, &folder, &["--no-pdf-header-footer", &print, &page]);
        pages(&pdf, round.questions().len());
    }
}

/// Checks the text of each printed page, if a tool to read it is installed.
fn pages(pdf: &str, questions: usize) {
    let Ok(output) = Command::new("pdftotext")
        .args(["-layout", pdf, "-"])
        .output()
    else {
        eprintln!("skipped: pdftotext was not found, so printed pages were not read");
        return;
    };
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let pages: Vec<&str> = text.trim_end_matches('\u{c}').split('\u{c}').collect();
    let key = pages.iter().position(|it| it.contains("Key: ")).unwrap();
    let first = pages[key].trim_start();
    assert!(first.starts_with("carrom · key"), "{first}");
    let sure = |page: &&str| page.matches("How sure?").count();
    let asked: Vec<_> = pages[..key].iter().map(sure).collect();
    assert_eq!(asked.iter().sum::<usize>(), questions);
    // Every page has a question, and there are not many more pages than necessary.
    assert!(asked.iter().all(|count| *count > 0), "{asked:?}");
    assert!(key <= 1 + questions / 2, "{key} pages for {questions}");
    assert_eq!(pages[key..].iter().map(sure).sum::<usize>(), 0);
}

fn written(arguments: &[&str]) {
    let done = worksheet(arguments);
    assert!(done.status.success(), "{arguments:?}: {}", err(&done));
}

#[test]
fn another_version_has_the_same_questions_with_other_numbers() {
    for round in rounds() {
        let other = round.version(2);
        assert_eq!(
            (round.version(1), round.version(2)),
            (round.clone(), other.clone())
        );
        assert_eq!(other.questions().len(), round.questions().len());
        let mut fresh = 0;
        for (one, two) in round.questions().iter().zip(other.questions()) {
            assert_eq!((one.family, &one.topic), (two.family, &two.topic));
            assert_eq!(one.difficulty, two.difficulty);
            let forms = [one, two].map(|it| std::mem::discriminant(&it.form));
            assert_eq!(forms[0], forms[1]);
            fresh += usize::from((&one.text, &one.form) != (&two.text, &two.form));
        }
        // A topic may have no other question, but that is rare.
        assert!(
            10 * fresh >= 9 * round.questions().len(),
            "{}: {fresh}",
            round.code()
        );
    }
}

#[test]
fn each_version_has_its_own_sheet_and_key() {
    let folder = Folder::new("versions");
    let out = folder.path().to_str().unwrap();
    written(&[
        "--seed",
        "7",
        "--versions",
        "2",
        "--paper",
        "letter",
        "--out",
        out,
    ]);
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    for (letter, on_screen) in [("a", true), ("b", false)] {
        let sheet = read(&format!("worksheet-{letter}.html"));
        let upper = letter.to_uppercase();
        assert!(sheet.contains(&format!("mixed-7, version {upper}")));
        assert!(sheet.contains("size: letter"));
        // The code opens only the first version on a screen.
        assert_eq!(sheet.contains("carrom quiz --code mixed-7"), on_screen);
        assert!(read(&format!("key-{letter}.md")).contains(&format!("version {upper}")));
        assert!(read(&format!("worksheet-{letter}.md")).contains(&format!("pictures-{letter}/")));
        assert!(folder.path().join(format!("pictures-{letter}")).is_dir());
    }
}

#[test]
fn a_sheet_has_four_cards() {
    let folder = Folder::new("cards");
    written(&["--cards", "3", "--out", folder.path().to_str().unwrap()]);
    let page = fs::read_to_string(folder.path().join("cards.html")).unwrap();
    let cards = select(&Html::parse_document(&page), ".card");
    assert_eq!(cards, ["A", "B", "C", "D"].repeat(3));
}

/// The command on a sheet of a teacher's own questions opens the round from any folder.
#[test]
fn the_command_on_a_sheet_of_a_teachers_own_questions_gives_their_folder() {
    let folder = Folder::new("own sheet");
    let mine = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/own-concepts");
    let copy = folder.path().join("my own");
    fs::create_dir(&copy).unwrap();
    let name = "our-marbles.toml";
    fs::copy(Path::new(mine).join(name), copy.join(name)).unwrap();
    let out = folder.path().join("sheet");
    let concepts = copy.to_str().unwrap();
    written(&[
        "--concepts",
        concepts,
        "--code",
        "own-7",
        "--out",
        out.to_str().unwrap(),
    ]);
    let page = fs::read_to_string(out.join("worksheet.html")).unwrap();
    let command = select(&Html::parse_document(&page), ".code code").remove(0);
    let words = shlex::split(&command).unwrap();
    let at = words.iter().position(|word| word == "--concepts").unwrap();
    assert_eq!(words[at + 1], concepts);
}

/// A number and its unit stay on one line, and so does an equation.
#[test]
fn no_line_breaks_before_a_unit() {
    let round = Round::of(Code::parse("mixed12-7").unwrap());
    let sheet = Worksheet::new(&round, None);
    for html in [sheet.sheet_html(), sheet.key_html()] {
        let page = Html::parse_document(&html);
        let asked = Selector::parse(".said > p:first-child, .asked").unwrap();
        for text in page.select(&asked).map(|it| it.text().collect::<String>()) {
            for broken in ["0 g", "0 m/s", "e = 1", "0 mm"] {
                assert!(!text.contains(broken), "{broken}: {text}");
            }
        }
    }
}

//! The chapters are complete: every number in the article on which they are based, and every
//! equation that the article lacks, is shown on a page, and the engine computes each number.

use std::collections::BTreeMap;

use carrom::app::App;
use carrom::lessons::{Chapter, ChapterLibrary, ChapterPage, Formula, TextBlock};
use carrom::physics::units::{deg_from_rad, rad_from_deg};
use carrom::physics::{Collision, Disc};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::widgets::{Charset, formula};
use glam::DVec2;
use include_dir::{Dir, include_dir};

use crate::reading::answer;

static LESSONS: Dir = include_dir!("$CARGO_MANIFEST_DIR/assets/lessons");

const SHOT: &str = "a-worked-shot";
const MARBLES: &str = "marbles";
const SPEEDS: &str = "speeds-and-angles";
const ATOM: &str = "to-the-atom";
const OFFSET: &str = "the-impact-parameter";
const REAL: &str = "A real striker";
const FAST: &str = "Which way, how fast?";

/// A number as it is written in the chapter's file, where the engine checks it when the file is
/// read, and as the screen shows it.
type Figure = (&'static str, &'static str);

/// The numbers that the article quotes, by chapter and page.
const FIGURES: [(&str, &str, &[Figure]); 11] = [
    // 15 g on 15 g at 4 m/s and 30°: 2 m/s at 60°, 2√3 m/s at 30°, 90° apart.
    (
        SHOT,
        "Split",
        &[
            ("{u1t carrom: 2.00}", "= 2.00 m/s"),
            ("{u1n carrom: 2 sqrt 3}", "= 2√3, about"),
            ("{u1n carrom: 3.46}", "about 3.46 m/s"),
        ],
    ),
    (
        SHOT,
        "Put together",
        &[
            ("{v1 carrom: 2.00}", "striker: 2.00 m/s"),
            ("{v2 carrom: 2 sqrt 3}", "coin: 2√3,"),
            ("{v2 carrom: 3.46}", "about 3.46 m/s"),
            ("{theta2_deg carrom: 30}", "at 30° to one"),
            ("{theta1_deg carrom: 60}", "60° to the other side"),
        ],
    ),
    (
        SHOT,
        "Check",
        &[
            ("{v1 carrom: 2}", "striker 2 m/s"),
            ("{theta1_deg carrom: 60}", "at 60°,"),
            ("{v2 carrom: 3.46}", "coin 3.46 m/s"),
            ("{theta2_deg carrom: 30}", "at 30°,"),
            ("{separation_deg carrom: 90}", "90° between them"),
        ],
    ),
    // 20 g on 40 g at 3 m/s and 45°: √5 m/s at 63.4°, √2 m/s at 45°, 108.4° apart.
    (
        MARBLES,
        "Split",
        &[("{u1n marbles: 2.12}", "about 2.12 m/s")],
    ),
    (
        MARBLES,
        FAST,
        &[
            ("{v1: sqrt 5}", "into speeds: √5,"),
            ("{v1: 2.24}", "about 2.24 m/s"),
            ("{v2: sqrt 2}", "and √2,"),
            ("{v2: 1.41}", "about 1.41 m/s"),
            ("{theta1_deg marbles: 63.4}", "gives 63.4°"),
            ("{theta2_deg marbles: 45}", "at 45°."),
            ("{separation_deg marbles: 108.4}", "sum: 108.4°"),
        ],
    ),
    // Equal masses share the energy equally at α = 45°.
    (
        SPEEDS,
        "Half and half",
        &[
            ("{half_energy_deg coins: 45}", "At 45°, where"),
            (
                "{energy1_share coins alpha_deg=45: 0.50}",
                "has 0.50 of the energy",
            ),
        ],
    ),
    (
        SPEEDS,
        "From the offset",
        &[("{theta1_deg radius: 60}", "deflected by 60°")],
    ),
    // Numbers that the article omits: masses as on a real board.
    (
        OFFSET,
        REAL,
        &[("{separation_deg real: 51.2}", "between the paths is 51.2°")],
    ),
    (
        OFFSET,
        "The greatest deflection",
        &[("{largest_deflection_deg real: 21.5}", "21.5°, at α = 34°")],
    ),
    // Rutherford's 1/sin⁴, and the measured counts.
    (
        ATOM,
        "How many, and where",
        &[
            ("{rutherford_ratio angle_deg=60 to_deg=120: 9}", "is 9."),
            (
                "{rutherford_ratio angle_deg=15 to_deg=150: 2999}",
                "factor of 2999",
            ),
        ],
    ),
    (
        ATOM,
        "The check",
        &[
            (
                "{rutherford_share angle_deg=45: 3.2e-7}",
                "share of 3.2×10⁻⁷",
            ),
            ("{measured_share: 3.7e-7}", "measured 3.7×10⁻⁷"),
        ],
    ),
];

/// The equations that the article refers to but does not show, by chapter and page.
const EQUATIONS: [(&str, &str, &[&str]); 17] = [
    (
        "momentum-is-a-vector",
        "One law, two lines",
        &[
            "m_1 vec(u) = m_1 vec(v_1) + m_2 vec(v_2)",
            "0 = p_1 sin theta_1 - p_2 sin theta_2",
        ],
    ),
    (
        "momentum-is-a-vector",
        "And along x",
        &["p = p_1 cos theta_1 + p_2 cos theta_2"],
    ),
    (
        "momentum-is-a-vector",
        "Count",
        &["(m_1 u^2)/2 = (m_1 v_1^2)/2 + (m_2 v_2^2)/2"],
    ),
    (
        "the-line-of-impact",
        "The split",
        &["u_1n = u cos alpha", "u_1t = u sin alpha"],
    ),
    (
        "the-line-of-impact",
        "What cannot change",
        &["v_1t = u_1t", "v_2t = u_2t = 0"],
    ),
    (
        "the-line-of-impact",
        "What can change",
        &[
            "v_1n = (m_1 - m_2)/(m_1 + m_2) u_1n",
            "v_2n = (2 m_1)/(m_1 + m_2) u_1n",
        ],
    ),
    (
        "the-right-angle",
        "Step 1: square",
        &[
            "vec(u) = vec(v_1) + vec(v_2)",
            "u^2 = v_1^2 + 2 vec(v_1) dot vec(v_2) + v_2^2",
        ],
    ),
    (
        "the-right-angle",
        "Step 2: subtract",
        &["u^2 = v_1^2 + v_2^2"],
    ),
    (
        "the-right-angle",
        "Step 3: conclude",
        &["v_1 v_2 cos phi = 0"],
    ),
    (SPEEDS, "From full to thin", &["v_1 = u sin alpha"]),
    (SPEEDS, "The other coin", &["v_2 = u cos alpha"]),
    (
        SPEEDS,
        "Which way?",
        &["theta_2 = alpha", "theta_1 = 90 deg - alpha"],
    ),
    (
        SPEEDS,
        "From the offset",
        &["theta_1 = 90 deg - arcsin(b/(2 r))"],
    ),
    (
        MARBLES,
        "Back to x and y",
        &[
            "vec(n) = (cos alpha, -sin alpha)",
            "vec(t) = (sin alpha, cos alpha)",
            "v_x = v_n n_x + v_t t_x",
            "v_y = v_n n_y + v_t t_y",
        ],
    ),
    (OFFSET, "How far off-centre", &["sin alpha = b/(r_1 + r_2)"]),
    (
        OFFSET,
        "Every b has its angle",
        &["theta_1 = 90 deg - arcsin(b/(2 r))"],
    ),
    (
        ATOM,
        "How many, and where",
        &["dσ/dΩ = (d^2)/(16 sin^4 (Theta / 2))"],
    ),
];

/// The text that a page shows before and after its question is answered.
#[derive(Default)]
struct Seen {
    /// The text in one line.
    words: String,
    /// The rows of the text.
    rows: Vec<String>,
}

/// The text on a screen: the content of the rightmost frame.
fn text_on(screen: &str) -> Vec<String> {
    let rows: Vec<Vec<char>> = screen.lines().map(|row| row.chars().collect()).collect();
    let corners = [['+', '+'], ['╮', '╭']];
    let top = &rows[1];

    let inner = top
        .windows(2)
        .position(|pair| corners.iter().any(|both| pair == both));
    let left = inner.map_or(1, |corner| corner + 2);
    let frame = &rows[2..rows.len() - 2];
    let text = frame
        .iter()
        .map(|row| row[left..row.len() - 1].iter().collect::<String>());
    text.map(|row| row.trim().to_owned()).collect()
}

/// The drawn pages of all chapters, by chapter and title.
fn walk(charset: Charset) -> BTreeMap<(String, String), Seen> {
    let mut pages = BTreeMap::new();
    for (number, chapter) in ChapterLibrary::embedded_once().chapters.iter().enumerate() {
        let settings = Settings {
            charset,
            reduced_motion: true,
            ..Settings::default()
        };
        let app = App::new(Route::Chapter(number), settings, 1);
        let mut game = Headless::new(app, 120, 40);
        for page in &chapter.pages {
            let seen: &mut Seen = pages
                .entry((chapter.id.clone(), page.title.clone()))
                .or_default();
            for asked in [true, false] {
                if !asked {
                    answer(&mut game, page);
                }
                seen.rows.extend(text_on(&game.screen()));
            }
            seen.words = seen.rows.join(" ");
            let words = seen.words.split_whitespace();
            seen.words = words.collect::<Vec<_>>().join(" ");
            game.press("n");
        }
    }
    pages
}

fn chapter(id: &str) -> &'static Chapter {
    let library = ChapterLibrary::embedded_once();
    &library.chapters[library.find(id).unwrap()]
}

fn page(id: &str, title: &str) -> &'static ChapterPage {
    let pages = chapter(id).pages.iter();
    let mut wanted = pages.filter(|page| page.title == title);
    wanted.next().unwrap_or_else(|| panic!("{id}: {title}"))
}

/// The source of one page in the chapter's file.
fn source(id: &str, title: &str) -> String {
    let file = LESSONS.get_file(&chapter(id).file).unwrap();
    let text = file.contents_utf8().unwrap();
    let start = text.find(&format!("\n# {title}\n")).unwrap() + 1;
    let rest = &text[start..];
    let end = rest.find("\n# ").unwrap_or(rest.len());
    rest[..end].to_owned()
}

#[test]
fn every_number_of_the_article_is_shown_on_its_page() {
    for charset in [Charset::Unicode, Charset::Ascii] {
        let pages = walk(charset);
        for (id, title, figures) in FIGURES {
            let seen = &pages[&(id.to_owned(), title.to_owned())].words;
            for (_, said) in figures {
                let said = charset.text(said);
                assert!(
                    seen.contains(&*said),
                    "{id}, {title}: {said} is not shown in\n{seen}"
                );
            }
        }
    }
}

/// A number counts as computed if the chapter is refused once the number has been changed.
#[test]
fn every_number_of_the_article_is_computed() {
    let figures = FIGURES.iter().flat_map(|(id, title, figures)| {
        figures
            .iter()
            .map(move |(computed, _)| (*id, *title, *computed))
    });
    for (id, title, computed) in figures {
        let text = source(id, title);
        assert!(text.contains(computed), "{id}, {title}: {computed}");
        let (name, shown) = computed.rsplit_once(": ").unwrap();
        let digit = shown.find(|c: char| c.is_ascii_digit()).unwrap();
        let digit = digit + shown[digit..].find(|c: char| c != '.').unwrap();
        let other = if shown[digit..].starts_with('7') {
            "8"
        } else {
            "7"
        };
        let mut wrong = shown.to_owned();
        wrong.replace_range(digit..=digit, other);
        let wrong = text.replace(computed, &format!("{name}: {wrong}"));
        let file = LESSONS.get_file(&chapter(id).file).unwrap();
        let whole = file.contents_utf8().unwrap().replace(&text, &wrong);
        let fault = Chapter::read(&chapter(id).file, whole.as_bytes());
        let message = fault.unwrap_err().to_string();
        let name = name.trim_start_matches('{').split(' ').next().unwrap();
        assert!(message.contains(&format!("{name} is ")), "{message}");
    }
}

fn formulas(blocks: &[TextBlock]) -> impl Iterator<Item = &Formula> {
    blocks.iter().filter_map(|block| match block {
        TextBlock::Formula(formula) => Some(formula),
        _ => None,
    })
}

#[test]
fn every_equation_that_the_article_lacks_is_shown() {
    for charset in [Charset::Unicode, Charset::Ascii] {
        let pages = walk(charset);
        for (id, title, equations) in EQUATIONS {
            let page = page(id, title);
            let asked = page.checkpoint.iter();
            let asked =
                asked.flat_map(|asked| formulas(&asked.question).chain(formulas(&asked.after)));
            let all: Vec<_> = formulas(&page.text).chain(asked).collect();
            for equation in equations {
                let wanted = Formula::read(equation).unwrap();
                assert!(all.contains(&&wanted), "{id}, {title}: {equation}");
                let seen = &pages[&(id.to_owned(), title.to_owned())].rows;
                let set = formula::set(&wanted, charset);
                let set: Vec<_> = set.iter().map(|row| row.trim()).collect();
                assert!(
                    seen.windows(set.len()).any(|rows| rows == set),
                    "{id}, {title}: {equation} is not shown in\n{}",
                    seen.join("\n")
                );
            }
        }
    }
}

/// The chapters print too few numbers to show whether the equations for an angle agree with the
/// engine.
#[test]
fn the_equations_of_the_angle_agree_with_the_engine() {
    let disc = Disc::from_g_mm(15.0, 15.0);
    let u = DVec2::new(4.0, 0.0);
    for b_mm in [0.1, 3.0, 15.0, 22.0, 29.9] {
        let alpha = (b_mm / 30.0_f64).asin();
        let outcome = Collision::at_angle(disc, disc, u, alpha).outcome();
        let theta1 = deg_from_rad(outcome.theta1.unwrap());
        let closed = 90.0 - deg_from_rad((b_mm / (2.0 * 15.0)).asin());
        assert!((theta1 - closed).abs() < 1e-9, "b = {b_mm} mm");
        let offset = Collision::at_angle(disc, disc, u, alpha).offset;
        assert!((offset - 1e-3 * b_mm).abs() < 1e-12, "b = {b_mm} mm");
    }
    let half = Collision::at_angle(disc, disc, u, rad_from_deg(45.0)).outcome();
    assert!((half.v1.length() - half.v2.length()).abs() < 1e-12);
}

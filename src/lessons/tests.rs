use std::collections::{BTreeMap, BTreeSet};

use super::*;
use crate::files::FileLibrary;
use crate::quiz::concepts;
use crate::quiz::{Dice, Difficulty, Family, Figures, Form, Misconception, Topic};

#[test]
fn all_built_in_chapters_are_valid() {
    let library = ChapterLibrary::embedded();
    assert_eq!(library.problems, []);
    assert!(!library.chapters.is_empty());
}

#[test]
fn each_misconception_and_each_topic_leads_to_a_page_that_exists() {
    let book = Book::default();
    for belief in Misconception::ALL {
        let named = book.named(belief.settled_by());
        assert!(named.is_some(), "{belief:?}: {:?}", belief.settled_by());
    }
    let written = concepts::all().iter().map(|concept| concept.topic());
    for topic in Topic::all().chain(written) {
        let named = topic.taught_on().and_then(|page| book.named(page));
        assert!(named.is_some(), "{topic}: {:?}", topic.taught_on());
    }
}

/// The source texts of the chapters, indexed by id.
fn chapters() -> BTreeMap<String, String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/lessons");
    let files = std::fs::read_dir(folder).unwrap().map(|it| it.unwrap());
    let chapter = |file: std::fs::DirEntry| {
        let name = file.file_name().into_string().unwrap();
        let id = name.split_once('-').unwrap().1.trim_end_matches(".md");
        (id.to_owned(), std::fs::read_to_string(file.path()).unwrap())
    };
    files.map(chapter).collect()
}

/// Reads a table with lines of the form `words | ids`: a page for one of the ids must contain at
/// least one of the words.
fn words_by_id(table: &'static str) -> BTreeMap<&'static str, Vec<&'static str>> {
    let mut all = BTreeMap::new();
    for line in table.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let (words, ids) = line.split_once('|').unwrap();
        let words: Vec<&str> = words.split(',').map(str::trim).collect();
        for id in ids.split_whitespace() {
            assert!(all.insert(id, words.clone()).is_none(), "{id} twice");
        }
    }
    all
}

/// A page about a misconception must contain at least one of the misconception's phrases, which are
/// written as they are in the chapters.
const OF_MISCONCEPTIONS: &str = "
    impact angle, at α =, 180 deg - 2 alpha, 90 deg - alpha | copied-angle
    90°, right angle, with equal masses | always-square square-on-the-ground
    45°, 90 deg - alpha, half, dead centre, 63.4, 71.6, tan(Theta/2), rebounds, greatest | half-and-half
    leaves along n, halves, halfway | swapped
    heavy puck, heavy striker, heavier | heavy-unmoved
    leaves at | straight-on
    along n, line of centres | pushed-ahead
    opposite directions | same-side
    higher up, the other side | sides-exchanged
    wall, loses all its speed, goes on, moves on, reversed, with equal masses, rebounds from | off-a-wall
    not a fraction of 90°, is the sine of α | offset-as-angle
    e = 0.8, e = 0, coefficient of restitution, e = 1, with a loss, is lost | lossless
    rebounds, the striker stops | always-stops
    components along x, arrow, two vectors, do not add up like numbers | scalar-momentum
    speeds do not | speeds-add
    momentum is conserved for any e, all the momentum, total momentum. a collision does not change | momentum-lost
    each momentum changes | each-keeps-momentum
    if the total is zero, only if the total momentum is zero | gone-at-rest
    energy is not momentum, the kinetic energy does increase | momentum-as-energy
    no components | energy-components
    with e = 1 the impulse is twice as large, a ball that rebounds | sticking-hits-harder
    equally hard, impulses are equal | heavier-pushes-harder
    head-on formulas, enough for a head-on collision | one-line-formula
    sin alpha, cos alpha, cos^2 alpha, sin theta_1, cos theta_1, u_1n, along t | sine-cosine
    speed only sets the scale, (4 - 197)/201 | speed-opens-angle
    square of the speed | energy-as-speed
    share of the mass, the lighter piece gets more | heavy-takes-energy
    equally likely, small angles are common | every-angle-alike
    m_1 - m_2, m_1 + m_2, m_1/m_2, m_1 / m_2, e m_2, three times the mass, less than the smaller mass | upside-down
    rebounds, heavier, heavy striker | heavy-rebounds
    small angles are common | counts-reversed
    b/(r_1 + r_2), half of d, half the force | direct-for-inverse
    greatest angle | beyond-largest
    along t, coefficient of restitution, common motion, e m_2 | loss-on-everything
    relative velocities, 1 - e^2 | e-as-energy
    less than 90° | loss-opens-angle
    90° | loss-forbids-square
    hold together | grip-ignored
    slip past each other | grip-stops-all
    in the frame of the centre of mass, laboratory frame, adding V | frames-mixed
    add V to both | frame-reversed
    nearer to the heavier one | halfway-centre
    half of Θ, halve both angles, half the angles | half-angle-forgotten
    fourth power | too-gentle
    came back | never-back
    at rest | coin-at-rest
    2 alpha, 2α, 2 theta_2 | double-angle-forgotten
    shorter time | force-as-impulse
    twice the time | time-as-impulse
    negligible | friction-in-contact
    all of the energy can be lost only, some motion has to remain | all-energy-lost
    halfway between the two paths | halfway-direction
    conserve energy in both steps | energy-through-impact
    equal and opposite pairs | momentum-from-explosion
    relative velocity is the same in every frame | loss-by-frame
    never between the two | reduced-as-mean
    at right angles to n | friction-only-slows
    neither disc spins | no-spin-from-rest
    in a different direction | careful-is-exact
    how many uncertainties | any-difference-disproves
    more frames do not help | frames-cure-scale
    keeps its shape | scale-turns-angles
";

/// A page about the subject of a topic's questions must contain at least one of the topic's
/// phrases. The format is that of [`OF_MISCONCEPTIONS`].
const OF_TOPICS: &str = "
    angle, deflect, direction, leaves, rebound | equal-masses equal-masses-by-offset equal-masses-lossy
    angle, deflect, direction, leaves, rebound | heavier-striker heavier-striker-by-offset from-the-picture
    angle, deflect, direction, leaves, rebound | heavier-target heavier-target-by-offset heavier-target-lossy
    rebound, head-on, dead centre, along n | equal-masses-head-on heavier-striker-head-on heavier-target-head-on
    angle, deflect, direction, leaves, rebound | unequal-masses
    along n, line of, right angles to n | line-of-impact
    angle, deflect, direction, leaves, speed | angles-and-speeds
    angle between the paths, right angle, along n, 90° | corner-without-loss right-angle
    angle between the paths, right angle, along n | corner-heavier-striker corner-lighter-striker
    loss, lost | corner-with-loss
    loss, restitution | square-in-spite-of-loss e-for-square e-from-angles
    relative velocities, e = | e-head-on
    e = 0, restitution, loss, lost | smooth-no-spring smooth-no-loss loss-and-grip
    together, centre of mass, restitution | sticking
    energy | energy-of-striker energy-of-target
    energy, momentum | energy
    loss, lost | energy-lost
    speed, m/s | target-speed striker-speed
    mass, heavier | which-is-heavier mass-from-angles
    momentum, momenta | mass-from-momentum
    mass, angle, speed, direction | measuring
    count, screen | counts-at-two-angles counts-angle-and-energy angle-of-count
    particle, deflect, count | scattering
    greatest, offset, limit | largest-turn limit-of-turn aim-for-largest-turn
    offset, direction, deflect, angle | send-coin send-striker
    offset, off-centre | offset
    both, frame, along n, along t | both-moving
    frame, centre of mass, offset | centre-of-mass frames
    momentum, impulse | momentum
    impulse, force | impulse
    momentum, momenta, energy | elastic-and-inelastic
    energy, mj | energy-and-the-centre-of-mass
    friction, rims, spin | rough-rims
    scale, marks, noise, uncertainty | uncertainty
";

/// A kind of wrong answer: the misconception (if a known misconception leads to the answer), the
/// topic, and the names of the case.
type Case = (Option<&'static str>, Topic, [String; 3]);

fn cases() -> BTreeMap<Case, Figures> {
    let mut cases = BTreeMap::new();
    let all = Family::ALL
        .iter()
        .flat_map(|family| Difficulty::ALL.map(|it| (*family, it)));
    for ((family, difficulty), seed) in all.flat_map(|it| (0..300).map(move |seed| (it, seed))) {
        let asked = family.ask(difficulty, &mut Dice::new(seed));
        if let Some((question, _)) = asked {
            let beliefs = question.beliefs.iter().map(|it| it.misconception.id());
            for id in beliefs.map(Some).chain([None]) {
                let names = Misconception::names_of_case(&question.topic, &question.figures);
                let case = (id, question.topic.clone(), names);
                cases.insert(case, question.figures.clone());
            }
        }
    }
    cases
}

/// The chapters that are only about equal masses that collide without loss.
const OF_EQUAL_MASSES: [&str; 2] = ["the-right-angle", "speeds-and-angles"];
/// The chapters that are only about unequal masses.
const OF_UNEQUAL_MASSES: [&str; 2] = ["marbles", "weighing-by-angle"];

/// The pages in these chapters that apply to all masses.
const OF_ANY_MASSES: [&str; 2] = ["A share of the energy", "The split of energy"];

/// Every wrong answer leads to a page about the same case: the page mentions the misconception, if
/// the answer shows one, and the subject of the question, and it is not about other masses.
#[test]
fn the_page_after_a_wrong_answer_treats_what_was_asked() {
    let chapters = chapters();
    let (misconceptions, topics) = (words_by_id(OF_MISCONCEPTIONS), words_by_id(OF_TOPICS));
    let cases = cases();
    let mut faults = Vec::new();
    for ((id, topic, names), figures) in &cases {
        let misconception = id.and_then(Misconception::with_id);
        let passage = match misconception {
            Some(it) => it.settled_in(topic, figures),
            None => topic.taught_for(figures).unwrap(),
        };
        let heading = format!("\n# {}\n", passage.page);
        let text = chapters[passage.chapter].split_once(&heading).unwrap().1;
        let text = text
            .split("\n# ")
            .next()
            .unwrap()
            .replace('\n', " ")
            .to_lowercase();
        let page = passage.page;
        let of_misconception = id.map(|id| &misconceptions[id]);
        for words in of_misconception.into_iter().chain([&topics[topic.id()]]) {
            if !words.iter().any(|word| text.contains(&word.to_lowercase())) {
                faults.push(format!("{id:?}, {names:?}: {page}: no {words:?}"));
            }
        }
        let figure = |name: &str| figures.get(name).and_then(|it| it.as_f64());
        let is_equal = figure("m1_g").zip(figure("m2_g")).map(|(m1, m2)| m1 == m2);
        let unfit: &[&str] = match is_equal {
            Some(true) if topic.id() != "which-is-heavier" => &OF_UNEQUAL_MASSES,
            Some(false) => &OF_EQUAL_MASSES,
            _ => &[],
        };
        if unfit.contains(&passage.chapter) && !OF_ANY_MASSES.contains(&page) {
            let chapter = passage.chapter;
            faults.push(format!(
                "{id:?}, {names:?}: {chapter}, {page}: other masses"
            ));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let met: BTreeSet<_> = cases.keys().filter_map(|(id, ..)| *id).collect();
    assert_eq!(met.len(), Misconception::ALL.len());
    // Every page listed under `elsewhere` is used.
    for misconception in Misconception::ALL {
        for name in misconception.settled_elsewhere() {
            let led_to = cases.keys().any(|(id, _, names)| {
                *id == Some(misconception.id()) && names.iter().any(|it| it == name)
            });
            assert!(led_to, "{}: {name}", misconception.id());
        }
    }
}

/// Every question in a chapter has a topic on which the quiz has further questions.
#[test]
fn every_checkpoint_has_a_topic_with_questions() {
    let mut asked = 0;
    for chapter in &ChapterLibrary::embedded_once().chapters {
        for page in chapter.pages.iter().filter(|it| it.checkpoint.is_some()) {
            let topic = Topic::of_checkpoint(&chapter.id, &page.title);
            let topic = topic.unwrap_or_else(|| panic!("{}: {}", chapter.id, page.title));
            assert!(!topic.families().is_empty(), "{topic}");
            asked += 1;
        }
    }
    let rows = include_str!("../../assets/checkpoints.csv").lines().count();
    assert_eq!(asked, rows - 1);
}

/// The symbols and the chapters in which they are used, from the table in `docs/notation.md`.
fn notation() -> BTreeMap<&'static str, &'static str> {
    let mut notation = BTreeMap::new();
    for row in include_str!("../../docs/notation.md").lines() {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        if let ["", symbol, _, _, chapters, ""] = cells[..] {
            let before = notation.insert(symbol, chapters);
            assert!(before.is_none(), "{symbol} has two meanings");
        }
    }
    notation
}

/// Whether a cell such as `from 4` or `3, 9` names the chapter.
fn names_chapter(cell: &str, chapter: usize) -> bool {
    match cell.strip_prefix("from ") {
        Some(first) => first.parse().is_ok_and(|first: usize| chapter >= first),
        None => cell.split(", ").any(|number| number.parse() == Ok(chapter)),
    }
}

/// The words of a line, without the subscripts of symbols.
fn words(line: &str) -> impl Iterator<Item = &str> {
    let ends = |c: char| !c.is_alphabetic() || "ₙₜₓᵧ".contains(c);
    line.split(ends).filter(|word| !word.is_empty())
}

/// The symbols in a formula, which are all its words except functions.
fn in_formula(formula: &Formula) -> Vec<String> {
    let functions = ["sin", "cos", "tan", "arcsin"];
    let line = formula.inline();
    let symbols = words(&line).filter(|word| !functions.contains(word));
    symbols.map(String::from).collect()
}

/// The symbols in a text: those in its formulas, and every word that contains a Greek letter.
fn in_text(text: &[Inline]) -> Vec<String> {
    let of_piece = |piece: &Inline| match piece {
        Inline::Formula(formula) => in_formula(formula),
        Inline::Text(text, _) => {
            let greek = |word: &&str| word.contains(|c| ('Α'..='ω').contains(&c));
            words(text).filter(greek).map(String::from).collect()
        }
        Inline::Live(_) => Vec::new(),
    };
    text.iter().flat_map(of_piece).collect()
}

fn in_blocks(blocks: &[TextBlock]) -> Vec<String> {
    let of_block = |block: &TextBlock| match block {
        TextBlock::Paragraph(text) | TextBlock::Item(_, text) => in_text(text),
        TextBlock::Formula(formula) => in_formula(formula),
    };
    blocks.iter().flat_map(of_block).collect()
}

fn on_page(page: &ChapterPage) -> Vec<String> {
    let mut symbols = in_blocks(&page.text);
    if let Some(checkpoint) = &page.checkpoint {
        for blocks in [&checkpoint.question, &checkpoint.hint, &checkpoint.after] {
            symbols.extend(in_blocks(blocks));
        }
        if let CheckpointKind::Choice(choices) = &checkpoint.asked {
            let texts = choices.iter().flat_map(|it| [&it.text, &it.why]);
            symbols.extend(texts.flat_map(|text| in_text(text)));
        }
    }
    symbols
}

#[test]
fn each_symbol_of_a_chapter_has_one_meaning_in_the_notation() {
    let notation = notation();
    for (chapter, number) in ChapterLibrary::embedded_once().chapters.iter().zip(1..) {
        for page in &chapter.pages {
            for symbol in on_page(page) {
                let chapters = notation.get(&*symbol);
                assert!(
                    chapters.is_some_and(|cell| names_chapter(cell, number)),
                    "chapter {number}, {}: docs/notation.md lists no meaning of {symbol} here",
                    page.title
                );
            }
        }
    }
}

#[test]
fn a_figure_is_refused_for_a_shot_that_it_cannot_show() {
    for words in [
        "curves rim_friction=0.2",
        "energy stick=true",
        "angles target_speed=1",
        "triangle target_speed=1",
        "triangle then target_speed=1",
    ] {
        let refused = Figure::from_words(words).unwrap_err();
        assert!(refused.starts_with("expected a shot without"), "{refused}");
    }
    for words in ["curves", "triangle stick=true", "frames target_speed=1"] {
        assert!(Figure::from_words(words).is_ok(), "{words}");
    }
}

#[test]
fn a_choice_shows_the_numbers_of_the_figure() {
    let text = "+++\nformat = 1\ntitle = \"T\"\nabout = \"A\"\n+++\n\
        # One\n::lab alpha_deg=30\n:::choice\nWhich?\n\
        - [ ] {v2} m/s\n  No.\n- [x] $v_1 = 2$\n  Yes.\n:::\n";
    let chapter = Chapter::read("01-test.md", text.as_bytes()).unwrap();
    let page = &chapter.pages[0];
    let collision = page.figure.unwrap().shot.collision();
    let form = page.checkpoint.as_ref().unwrap().form(Some(&collision));
    let Form::Choice { options, .. } = form else {
        panic!("the checkpoint is a choice");
    };
    assert_eq!(options, ["3.46 m/s", "v₁\u{a0}=\u{a0}2"]);
}

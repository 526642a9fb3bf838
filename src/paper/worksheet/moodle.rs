//! The questions of a round in Moodle's XML format.
//!
//! Moodle compares an answer with a list of answers; the first one that fits gives the points and
//! the feedback. So the list contains every misconception's answer, with its feedback. A question
//! that asks for two directions, or for an offset with its side, has several fields (Cloze). Moodle
//! judges such fields separately, so feedback that applies only to both directions together begins
//! by naming them.

use data_encoding::BASE64;
use maud::{Markup, PreEscaped, Render, html};

use super::pictures::{ANSWER, QUESTION};
use super::{Worksheet, WorksheetPicture, pictures, words};
use crate::numbers::{capital, figures, tenths};
use crate::physics::units::{deg_from_rad, mm_from_m};
use crate::quiz::{CourseKind, Form, Measure, Question, RIGHT_DEG, Ray, Rays, Response};
use crate::widgets::text::unbroken;

/// An answer that Moodle recognizes in a question or in one of its fields.
struct KnownAnswer {
    said: String,
    /// The number, and the largest deviation that still counts as this answer; `None` for a choice.
    number: Option<[f64; 2]>,
    is_right: bool,
    feedback: String,
}

/// A field of a question: all answers that it recognizes.
struct AnswerField(Vec<KnownAnswer>);

impl Worksheet<'_> {
    /// The questions of these worksheets for Moodle's question bank: a file in its XML format, with
    /// all answers, their feedback and the pictures, each worksheet in a separate category.
    pub fn moodle_xml(worksheets: &[Self]) -> String {
        let quiz = html! {
            quiz {
                @for worksheet in worksheets {
                    (category(worksheet))
                    @for (number, question) in (1..).zip(worksheet.round.questions()) {
                        (one(number, question))
                    }
                }
            }
        };
        let quiz = quiz.into_string();
        let xml = format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{quiz}\n");
        // XML allows neither of these characters, even escaped.
        xml.replace(['\u{fffe}', '\u{ffff}'], "")
    }
}

fn category(worksheet: &Worksheet) -> Markup {
    let name = match &worksheet.round.course().kind {
        // A single slash separates categories, so a slash in a title is doubled.
        CourseKind::Set(_) => worksheet.title.replace('/', "//"),
        _ => worksheet.round.code().to_string(),
    };
    html! {
        question type="category" {
            category { text { "$course$/top/" (worksheet.with_version(&name)) } }
            info format="html" {
                (inner(html! {
                    p { (worksheet.title) }
                    @if let Some(command) = worksheet.command() { p { code { (command) } } }
                }))
            }
        }
    }
}

fn one(number: usize, question: &Question) -> Markup {
    let (kind, fields, answers) = answering(question);
    let asked = WorksheetPicture::new(QUESTION, number, pictures::on_screen(question));
    let solved = WorksheetPicture::new(ANSWER, number, pictures::of_answer(question));
    html! {
        question type=(kind) {
            name { text { (format_args!("{number:02} {}", question.topic)) } }
            questiontext format="html" {
                (inner(html! {
                    p { (unbroken(&question.text)) }
                    @if let Some(picture) = &asked { (picture.image()) }
                    (fields)
                }))
                @if let Some(picture) = &asked { (picture.file()) }
            }
            generalfeedback format="html" {
                (inner(html! {
                    p { strong { (words::truth(question)) } }
                    p { (unbroken(&question.why)) }
                    @if let Some(picture) = &solved { (picture.image()) }
                }))
                @if let Some(picture) = &solved { (picture.file()) }
            }
            defaultgrade { (words::worth_of(question)) }
            penalty { "0.3333333" }
            hidden { "0" }
            (answers)
        }
    }
}

/// HTML as the text of an element.
fn inner(html: Markup) -> Markup {
    html! { text { (html.into_string()) } }
}

/// A picture that is embedded in the file of questions, and shown in a text.
impl WorksheetPicture {
    fn image(&self) -> Markup {
        let [width, height] = self.svg.size().map(|length| length.round());
        html! {
            p {
                img src=(format_args!("@@PLUGINFILE@@/{}", self.name)) alt=(self.svg.words())
                    width=(width) height=(height);
            }
        }
    }

    fn file(&self) -> Markup {
        html! {
            file name=(self.name) path="/" encoding="base64" {
                (BASE64.encode(self.svg.file().as_bytes()))
            }
        }
    }
}

/// How a question is answered: its type in Moodle, the text after the question (the unit of the
/// answer, or the fields for it), and the elements with the answers that have no fields.
fn answering(question: &Question) -> (&'static str, Markup, Markup) {
    match &question.form {
        Form::Number { quantity, truth } => {
            let unit = html! {
                @if let Some(unit) = unit_in_words(quantity) {
                    p { "Give your answer in " (unit) "." }
                }
            };
            ("numerical", unit, of_number(question, quantity, *truth))
        }
        Form::Choice { options, .. } => {
            let choices = of_choices(question, options);
            ("multichoice", Markup::default(), choices)
        }
        Form::Rays { truth, target, .. } => {
            let [striker, other] = of_rays(question, truth, target);
            let fields = html! {
                p {
                    "Measure each angle from the striker's original direction; left and right are as \
                     seen along its path. If a disc stays still, enter 0."
                }
                @for (name, [angle, side]) in [("striker", striker), (target, other)] {
                    p { (capital(name)) ": " (angle) "° " (side) }
                }
            };
            ("cloze", fields, Markup::default())
        }
        Form::Shot(aim) => {
            let [size, side] = of_shot(question, aim.offset);
            let fields = html! { p { "Offset of the target's centre: " (size) " mm " (side) } };
            ("cloze", fields, Markup::default())
        }
    }
}

/// The unit of an answer, if the question does not imply it.
fn unit_in_words(quantity: &Measure) -> Option<&str> {
    match quantity.unit() {
        "" | "times" => None,
        "°" => Some("degrees"),
        unit => Some(unit),
    }
}

fn of_number(question: &Question, quantity: &Measure, truth: f64) -> Markup {
    let known = |x: f64, is_right, feedback: &str| {
        KnownAnswer::number(x, quantity.tolerance(x), is_right, feedback)
    };
    let wrong = question.wrong_answers().into_iter();
    let wrong = wrong.filter_map(|(said, _, says)| match said {
        Response::Number(x) => Some(known(x, false, says)),
        _ => None,
    });
    let answers = std::iter::once(known(truth, true, RIGHT))
        .chain(wrong)
        .collect();
    html! {
        (AnswerField(answers).elements("moodle_auto_format"))
        @if !quantity.unit().is_empty() {
            units { unit { multiplier { "1" } unit_name { (quantity.unit()) } } }
        }
    }
}

/// The feedback for a right answer; the explanation follows it.
const RIGHT: &str = "Right.";

fn of_choices(question: &Question, options: &[String]) -> Markup {
    let known = question.wrong_answers();
    let answers = options.iter().enumerate().map(|(choice, text)| {
        let said = Response::Choice(choice);
        let is_right = question.form.is_right(&said);
        let feedback = known.iter().find(|(wrong, ..)| *wrong == said);
        let feedback = feedback.map_or("", |(_, _, says)| says);
        let text = html! { p { (unbroken(text)) } }.into_string();
        KnownAnswer::choice(&text, is_right, if is_right { RIGHT } else { feedback })
    });
    html! {
        single { "true" }
        shuffleanswers { "false" }
        answernumbering { "ABCD" }
        (AnswerField(answers.collect()).elements("html"))
    }
}

/// The sides in the list of a field.
const SIDES: [&str; 3] = ["to the left", "to the right", "stays still"];

/// The angle and the side of each ray.
fn of_rays(question: &Question, truth: &Rays, target: &str) -> [[Markup; 2]; 2] {
    let mut rays = Ray::BOTH.map(|ray| {
        let right = truth.get(ray);
        let angle = KnownAnswer::number(size_deg(right), RIGHT_DEG, true, RIGHT);
        [
            AnswerField(vec![angle]),
            AnswerField::of_sides(&SIDES, sides(ray, right)),
        ]
    });
    // Misconceptions that a single ray reveals come first: their feedback needs no condition.
    let alone = question.beliefs.iter().filter(|it| it.telltale.is_some());
    let together = question.beliefs.iter().filter(|it| it.telltale.is_none());
    for belief in alone.chain(together) {
        let Response::Rays(held) = belief.said else {
            continue;
        };
        let feedback = match belief.telltale {
            Some(_) => belief.says.clone(),
            None => format!("If you answered “{}”: {}", held.words(target), belief.says),
        };
        for (ray, [angle, side]) in Ray::BOTH.into_iter().zip(&mut rays) {
            let [said, right] = [&held, truth].map(|rays| rays.get(ray));
            let is_shown_here = belief.telltale.is_none_or(|it| it == ray);
            let gap = (size_deg(said) - size_deg(right)).abs();
            let [on, right_on] = [said, right].map(|angle| sides(ray, angle));
            let is_right_side = (0..3).any(|i| on[i] && right_on[i]);
            if is_shown_here && said.is_some() && gap > RIGHT_DEG {
                angle.add(size_deg(said), RIGHT_DEG, &feedback);
                break;
            }
            if is_shown_here && !is_right_side {
                side.add_to(on, &feedback);
                break;
            }
        }
    }
    rays.map(|[angle, side]| [angle.cloze("NUMERICAL"), side.cloze("MULTICHOICE")])
}

/// The size of an angle in degrees; 0 for a disc that stays still.
fn size_deg(angle: Option<f64>) -> f64 {
    deg_from_rad(angle.unwrap_or_default().abs())
}

/// For each of the [`SIDES`], whether it is correct for a ray. Straight ahead and straight back
/// are on neither side, so left and right are both accepted.
fn sides(ray: Ray, angle: Option<f64>) -> [bool; 3] {
    let Some(angle) = angle else {
        return [false, false, true];
    };
    let has_side = tenths(angle.abs()) % 1800 != 0;
    let is_left = ray.leftward(angle) > 0.0;
    [is_left || !has_side, !is_left || !has_side, false]
}

/// The size and the side of an offset; `right` is the right one.
fn of_shot(question: &Question, right: f64) -> [Markup; 2] {
    let sides = |offset: f64| [offset < 0.0, offset > 0.0, false];
    let mm = |offset: f64| {
        let tolerance = question.form.tolerance(&Response::Shot(offset));
        [offset.abs(), tolerance].map(mm_from_m)
    };
    let [size_mm, tolerance_mm] = mm(right);
    let size = KnownAnswer::number(size_mm, tolerance_mm, true, RIGHT);
    let mut size = AnswerField(vec![size]);
    let mut side = AnswerField::of_sides(&SIDES[..2], sides(right));
    for (said, _, says) in question.wrong_answers() {
        match said {
            Response::Shot(offset) if offset * right < 0.0 => side.add_to(sides(offset), says),
            Response::Shot(offset) => {
                let [size_mm, tolerance_mm] = mm(offset);
                size.add(size_mm, tolerance_mm, says);
            }
            _ => {}
        }
    }
    [size.cloze("NUMERICAL"), side.cloze("MULTICHOICE")]
}

impl KnownAnswer {
    fn number(x: f64, tolerance: f64, is_right: bool, feedback: &str) -> Self {
        Self {
            number: Some([x, tolerance]),
            ..Self::choice(&exact(x), is_right, feedback)
        }
    }

    fn choice(said: &str, is_right: bool, feedback: &str) -> Self {
        Self {
            said: said.into(),
            number: None,
            is_right,
            feedback: feedback.into(),
        }
    }

    /// Adds a sentence to the feedback.
    fn add(&mut self, feedback: &str) {
        if !self.feedback.is_empty() {
            self.feedback.push(' ');
        }
        self.feedback.push_str(feedback);
    }
}

/// A number with enough figures that its rounding is negligible beside any tolerance.
fn exact(x: f64) -> String {
    figures(x, 5)
}

impl AnswerField {
    /// A field with a list of sides, some of which are correct.
    fn of_sides(sides: &[&str], right: [bool; 3]) -> Self {
        let each = sides.iter().zip(right);
        let known = each
            .map(|(side, right)| KnownAnswer::choice(side, right, if right { RIGHT } else { "" }));
        Self(known.collect())
    }

    /// Adds the feedback on a wrong number. If this number is within the tolerance of an earlier
    /// one, Moodle never reaches this number, so the earlier one gets the feedback.
    fn add(&mut self, x: f64, tolerance: f64, feedback: &str) {
        let earlier = self.0.iter_mut().find(|it| {
            let fits = |[y, tolerance]: [f64; 2]| (x - y).abs() <= tolerance;
            it.number.is_some_and(fits)
        });
        match earlier {
            Some(earlier) => earlier.add(feedback),
            None => {
                let known = KnownAnswer::number(x, tolerance, false, feedback);
                self.0.push(known);
            }
        }
    }

    /// Adds the feedback on wrong choices.
    fn add_to(&mut self, choices: [bool; 3], feedback: &str) {
        let chosen = self.0.iter_mut().zip(choices);
        for (known, _) in chosen.filter(|(_, is_meant)| *is_meant) {
            known.add(feedback);
        }
    }

    /// The answers as elements of a question.
    fn elements(&self, format: &str) -> Markup {
        html! {
            @for known in &self.0 {
                answer fraction=(if known.is_right { 100 } else { 0 }) format=(format) {
                    text { (known.said) }
                    feedback format="html" {
                        (inner(html! {
                            @if !known.feedback.is_empty() { p { (unbroken(&known.feedback)) } }
                        }))
                    }
                    @if let Some([_, tolerance]) = known.number { tolerance { (exact(tolerance)) } }
                }
            }
        }
    }

    /// The field within a text: `{1:NUMERICAL:=60:4#Right.~30:4#...}`.
    fn cloze(&self, kind: &str) -> Markup {
        let each = self.0.iter().map(|known| {
            let sign = if known.is_right { "=" } else { "" };
            let tolerance = known.number.map(|[_, tolerance]| exact(tolerance));
            let tolerance = tolerance.map_or_else(String::new, |it| format!(":{it}"));
            let feedback = match known.feedback.as_str() {
                "" => String::new(),
                feedback => format!("#{}", escaped(feedback)),
            };
            format!("{sign}{}{tolerance}{feedback}", known.said)
        });
        let answers = each.collect::<Vec<_>>().join("~");
        PreEscaped(format!("{{1:{kind}:{answers}}}"))
    }
}

/// Feedback within a field. Moodle splits a field at some characters, then replaces entities once,
/// and the result is HTML.
fn escaped(feedback: &str) -> String {
    let mut escaped = String::new();
    for c in unbroken(feedback).render().into_string().chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '{' | '}' | '~' | '#' | '/' | '\\' | '"' => {
                escaped.push_str(&format!("&#{};", u32::from(c)));
            }
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_character_ends_the_feedback_in_a_field() {
        let escaped = escaped("a } ~ # / \\ \" {1:NM:=1} < & b");
        assert!(
            !escaped.contains(['{', '}', '~', '/', '\\', '"', '<']),
            "{escaped}"
        );
        assert_eq!(escaped.matches('#').count(), escaped.matches("&#").count());
        assert!(escaped.contains("&amp;lt;") && escaped.contains("&amp;amp;"));
    }
}

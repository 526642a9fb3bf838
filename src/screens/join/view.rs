//! How a pupil's place in the class looks.

use ratatui::buffer::Buffer;

use super::desk::{Desk, Doing};
use super::link::Link;
use crate::class::ClassStep;
use crate::class::protocol::PupilStep;
use crate::numbers;
use crate::quiz::{Confidence, Form, Illustration, Question, Ray, Response, letter};
use crate::widgets::bar::bar;
use crate::widgets::hit::Watch;
use crate::widgets::panel::written;
use crate::widgets::panels::said_and_true;
use crate::widgets::{
    AnswerInput, Lines, Look, Role, Room, Scroll, SplitLayout, Words, draw_question,
};

/// Where picture and words are: the words alone where there is nothing to be seen.
pub(super) fn layout(desk: Option<&Desk>, room: Room) -> SplitLayout {
    let question = desk.and_then(|desk| desk.question.as_ref());
    match question.map(|question| question.picture) {
        None | Some(Illustration::Nothing) => SplitLayout::card(room),
        _ => SplitLayout::new(room),
    }
}

/// Draws it.
pub(super) fn draw(
    desk: &Desk,
    scroll: &Scroll,
    room: Room,
    buf: &mut Buffer,
    look: &Look,
    write: impl Fn(&mut Lines),
) {
    let layout = layout(Some(desk), room);
    let kind = desk
        .question
        .as_ref()
        .map_or("your class", |it| it.family.name());
    let (picture, panel) = match &desk.doing {
        Doing::Watch(reveal) => {
            let title = reveal.watch().map(Watch::slowed_title);
            (title.unwrap_or_else(|| kind.into()), "and why")
        }
        _ => (kind.to_owned(), step_name(desk.state.step)),
    };
    let panel = if layout.picture.is_empty() {
        picture.as_str()
    } else {
        panel
    };
    layout.draw(buf, look, &picture, panel);
    if let Some(question) = &desk.question {
        match &desk.doing {
            Doing::Watch(reveal) if reveal.watch().is_some() => {
                let pictures = reveal.watch().map(|watch| watch.picture(layout.picture));
                pictures
                    .into_iter()
                    .for_each(|picture| picture.draw(buf, look));
            }
            Doing::Answer(input) | Doing::Sure(input, _) => {
                draw_question(layout.picture, buf, look, question, Some(input));
            }
            _ => draw_question(layout.picture, buf, look, question, None),
        }
    }
    scroll.draw(layout.panel, buf, *look, write);
}

/// What a step is called.
fn step_name(step: PupilStep) -> &'static str {
    match step {
        PupilStep::Lobby => "your class",
        PupilStep::End => "the end",
        PupilStep::Asked(step) => match step {
            ClassStep::Describe => "the question",
            ClassStep::Predict => "in silence",
            ClassStep::FirstVote => "your vote",
            ClassStep::Talk => "talk",
            ClassStep::SecondVote => "your second vote",
            ClassStep::Shot => "and why",
            ClassStep::Scores => "the scores",
        },
    }
}

/// Writes what there is to say, with how many answers may be handed in.
pub(super) fn write(desk: &Desk, link: &Link, answers: usize, lines: &mut Lines) {
    // After the end the host may go.
    if !link.is_in() && desk.state.step != PupilStep::End {
        let words = "The teacher's carrom is out of reach. Trying again ..";
        lines.paragraph(words, Role::Warn);
        lines.gap();
    }
    match (&desk.question, desk.state.step) {
        (Some(question), PupilStep::Asked(step)) => write_step(desk, question, step, link, lines),
        (_, PupilStep::End) => write_end(desk, link, answers, lines),
        _ => {
            lines.paragraph(&format!("You are in, {}.", desk.state.name), Role::Title);
            lines.gap();
            lines.paragraph("Look at the board: it begins soon.", Role::Text);
            write_hand_in(desk, link, answers, lines);
        }
    }
}

/// Writes what may be handed in, and what came of it.
fn write_hand_in(desk: &Desk, link: &Link, answers: usize, lines: &mut Lines) {
    let handed = desk.state.handed.map(|it| it.kept);
    let (words, role) = match (link.is_handing_in(), handed) {
        (true, _) if !link.is_in() && desk.state.step == PupilStep::End => (
            "Your answers wait until the teacher's carrom is in reach again.".to_owned(),
            Role::Warn,
        ),
        (true, _) => ("Your answers are on their way ..".to_owned(), Role::Warn),
        (false, Some(Ok(kept))) => {
            let kept = numbers::counted(kept, "answer");
            (format!("Handed in: {kept}."), Role::Good)
        }
        (false, Some(Err(why))) => (format!("Not handed in. {}", why.words()), Role::Warn),
        (false, None) => (String::new(), Role::Text),
    };
    if !words.is_empty() {
        lines.gap();
        lines.paragraph(&words, role);
    }
    if answers > 0 && !link.is_handing_in() && !matches!(handed, Some(Ok(_))) {
        lines.gap();
        let answers = numbers::counted(answers, "answer");
        let words = format!("h: hand in the {answers} that you gave alone.");
        lines.paragraph(&words, Role::Key);
    }
}

fn write_end(desk: &Desk, link: &Link, answers: usize, lines: &mut Lines) {
    lines.paragraph("The round is over.", Role::Title);
    if let Some((points, place)) = desk.state.score {
        lines.gap();
        let words = format!(
            "You have {} points: place {place}.",
            numbers::points(points)
        );
        lines.paragraph(&words, Role::Text);
    }
    write_hand_in(desk, link, answers, lines);
    lines.gap();
    lines.paragraph("Esc: all of carrom, for you alone.", Role::Key);
}

fn write_step(desk: &Desk, question: &Question, step: ClassStep, link: &Link, lines: &mut Lines) {
    match (&desk.doing, step) {
        (Doing::Answer(input), _) => write_answer(desk, question, input, link, lines),
        (Doing::Sure(input, sure), _) => write_sure(question, input, *sure, lines),
        (Doing::Watch(reveal), _) if reveal.is_telling() => {
            lines.paragraph(&question.text, Role::Dim);
            if let Some(watch) = reveal.watch() {
                lines.gap();
                written::<()>(lines, |panel| watch.write_telling(panel));
            }
        }
        (Doing::Watch(_), _) | (_, ClassStep::Scores) => write_told(desk, question, lines),
        (Doing::Look, step) => {
            // A text that is too long is cut at its end: what to do comes first.
            let words = match step {
                ClassStep::Describe => "Read with the class. The vote comes soon.",
                ClassStep::Predict => "Decide in silence. The vote comes soon.",
                ClassStep::Talk => "Talk: find someone who thinks otherwise, and say why.",
                _ => "",
            };
            if !words.is_empty() {
                lines.paragraph(words, Role::Key);
                lines.gap();
            }
            lines.paragraph(&question.text, Role::Text);
            lines.gap();
            let counts = match step {
                ClassStep::Talk => desk.state.spread.as_slice(),
                _ => &[],
            };
            write_choices(question, counts, lines);
            if let Some(said) = desk.said() {
                let said = lettered(&question.form, &said.response);
                lines.hanging("you said  ", &said, Role::Predicted);
            }
        }
    }
}

/// The choices of a question that has any, with how many were for each.
fn write_choices(question: &Question, counts: &[u32], lines: &mut Lines) {
    let Form::Choice { options, .. } = &question.form else {
        return;
    };
    let all: f64 = counts.iter().copied().map(f64::from).sum();
    for (i, option) in options.iter().enumerate() {
        lines.hanging(&format!("{}  ", letter(i)), option, Role::Text);
        if let Some(count) = counts.get(i) {
            let width = lines.width().saturating_sub(8);
            let share = f64::from(*count) / all.max(1.0);
            let bar = bar(share, width, lines.charset());
            let count = count.to_string();
            lines.written_as(
                |_| Words::meter("", share, &count, Role::Predicted),
                |lines| {
                    lines.pair(&format!("   {bar}"), &count, Role::Predicted, Role::Title);
                },
            );
        }
    }
    lines.gap();
}

/// Whether it is told above the question how a vote stands: a long text is cut at its end, and
/// everybody has to see that theirs is in.
fn is_told_first(desk: &Desk, link: &Link) -> bool {
    link.is_sending() || desk.state.misfit || desk.has_voted()
}

/// How a vote stands, and what Enter does.
fn standing(
    desk: &Desk,
    question: &Question,
    input: &AnswerInput,
    link: &Link,
) -> (&'static str, Role) {
    let given = desk.has_voted() && desk.said().map(|said| said.response) == input.said();
    match (link.is_sending(), desk.has_voted()) {
        (true, _) => ("Your vote is on its way ..", Role::Warn),
        (false, _) if desk.state.misfit => (
            "That answer does not fit the question and was not counted. Please vote again.",
            Role::Warn,
        ),
        (false, true) if given => (
            "Your vote is in. You may change it until all go on.",
            Role::Good,
        ),
        (false, true) => ("Your earlier vote is in. Enter makes this one.", Role::Key),
        (false, false) if desk.state.step == PupilStep::Asked(ClassStep::SecondVote) => (
            "Your first vote stays, unless you vote otherwise: Enter.",
            Role::Key,
        ),
        (false, false) => match (input, &question.form) {
            (AnswerInput::Rays(rays), Form::Rays { .. }) if rays.turning() == Ray::Striker => {
                ("Enter: then the other ray.", Role::Key)
            }
            _ => ("Enter: then how sure.", Role::Key),
        },
    }
}

fn write_answer(
    desk: &Desk,
    question: &Question,
    input: &AnswerInput,
    link: &Link,
    lines: &mut Lines,
) {
    let (words, role) = standing(desk, question, input, link);
    let is_first = is_told_first(desk, link);
    if is_first {
        lines.paragraph(words, role);
        lines.gap();
    }
    lines.paragraph(&question.text, Role::Text);
    lines.gap();
    input.write(&question.form, lines);
    if !is_first {
        lines.gap();
        lines.paragraph(words, role);
    }
    let about = input.about(&question.form);
    if lines.left() > lines.rows_of(&about) {
        lines.gap();
        lines.paragraph(&about, Role::Dim);
    }
}

fn write_sure(question: &Question, input: &AnswerInput, sure: Confidence, lines: &mut Lines) {
    lines.line("How sure are you?", Role::Title);
    lines.gap();
    for (number, confidence) in (1..).zip(Confidence::ALL) {
        lines.target(confidence as usize, |lines| {
            lines.choice(confidence == sure, Role::Text, |lines, mark, role| {
                lines.line(&format!("{mark} {number} {} ", confidence.name()), role);
            });
        });
    }
    lines.gap();
    if let Some(said) = input.said() {
        let said = lettered(&question.form, &said);
        lines.hanging("you say  ", &said, Role::Predicted);
        lines.gap();
    }
    lines.paragraph(
        "Enter: that is my vote. How sure you are changes no points here.",
        Role::Key,
    );
}

/// An answer in words, a choice with its letter.
fn lettered(form: &Form, said: &Response) -> String {
    match said {
        Response::Choice(i) => format!("{}: {}", letter(*i), form.words(said)),
        _ => form.words(said),
    }
}

/// What they said beside the truth, and why.
fn write_told(desk: &Desk, question: &Question, lines: &mut Lines) {
    let said = desk.said().map(|said| said.response);
    let truth = question.form.truth();
    if let Some(points) = desk.state.told.as_ref().and_then(|told| told.points) {
        let points = format!("{} of 10 points", numbers::points(points));
        lines.paragraph(&points, Role::Title);
        lines.gap();
    }
    let hit = question.picture.collision();
    match (&question.form, said, hit) {
        (Form::Rays { target, .. }, Some(Response::Rays(rays)), Some(hit)) => {
            let names = ["striker", target].map(Some);
            written::<()>(lines, |panel| said_and_true(hit, &rays, names, true, panel));
        }
        (form, said, _) => {
            let said = said.map_or("nothing".into(), |said| lettered(form, &said));
            lines.hanging("you    ", &said, Role::Predicted);
            lines.hanging("truth  ", &lettered(form, &truth), Role::Good);
        }
    }
    lines.gap();
    lines.paragraph(&question.why, Role::Text);
    if let Some((points, place)) = desk.state.score {
        lines.gap();
        let words = format!("{} points so far: place {place}", numbers::points(points));
        lines.paragraph(&words, Role::Title);
    }
}

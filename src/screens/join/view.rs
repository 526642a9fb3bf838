//! The view of a pupil's device in a class.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::JoinAction;
use super::joined::{Doing, JoinedClass};
use super::link::Link;
use crate::class::ClassStep;
use crate::class::protocol::{PupilState, PupilStep};
use crate::numbers;
use crate::quiz::{Form, Illustration, Question, letter};
use crate::screens::View;
use crate::widgets::hit::Watch;
use crate::widgets::panel::Panel;
use crate::widgets::{
    AnswerInput, Asking, AskingAction, Look, Role, SplitLayout, draw_question, lettered,
    write_beside_truth,
};

/// The view, with the number of answers that can be handed in.
pub(super) fn view<'s>(
    joined: &'s JoinedClass,
    link: &Link,
    answers: usize,
) -> View<'s, JoinAction> {
    let kind = { joined.question.as_ref() }.map_or("your class", |it| it.family.name());
    let (title, name) = match &joined.doing {
        Doing::Watch(reveal) => {
            let title = reveal.watch().map(Watch::slowed_title);
            (title.unwrap_or_else(|| kind.into()), "and why")
        }
        _ => (kind.to_owned(), step_name(joined.state.step)),
    };
    let mut panel = Panel::new(name);
    panel.subject = subject(&joined.state);
    write(joined, link, answers, &mut panel);
    match &joined.question {
        Some(question) if !matches!(question.picture, Illustration::Nothing) => View::picture(
            title,
            |area, buf, look| draw(joined, question, area, buf, look),
            panel,
        )
        .dragging(match &joined.doing {
            Doing::Vote(asking) => asking.input().drag(question),
            _ => None,
        }),
        _ => {
            panel.title = title;
            View::alone(SplitLayout::card, panel)
        }
    }
}

/// Draws the picture of the question, with the vote or the result.
fn draw(joined: &JoinedClass, question: &Question, area: Rect, buf: &mut Buffer, look: &Look) {
    let (watch, input) = match &joined.doing {
        Doing::Watch(reveal) => (reveal.watch(), None),
        Doing::Vote(asking) => (None, Some(asking.input())),
        Doing::Look => (None, None),
    };
    match watch {
        Some(watch) => watch.picture(area).draw(buf, look),
        None => draw_question(area, buf, look, question, input),
    }
}

/// A number for each step of each question, so that the text of a new step starts at its top.
fn subject(state: &PupilState) -> usize {
    let step = match state.step {
        PupilStep::Asked(step) => 2 + step as usize,
        PupilStep::Lobby => 0,
        PupilStep::End => 1,
    };
    16 * state.q + step
}

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

fn write(joined: &JoinedClass, link: &Link, answers: usize, panel: &mut Panel<JoinAction>) {
    // After the end of the round the host may quit.
    if !link.is_in() && joined.state.step != PupilStep::End {
        let words = "The teacher's carrom is out of reach. Trying again ..";
        panel.paragraph(words, Role::Warn);
        panel.gap();
        panel.pin();
    }
    match (&joined.question, joined.state.step) {
        (Some(question), PupilStep::Asked(step)) => write_step(joined, question, step, link, panel),
        (_, PupilStep::End) => write_end(joined, link, answers, panel),
        _ => {
            panel.paragraph(format!("You are in, {}.", joined.state.name), Role::Title);
            panel.gap();
            panel.paragraph("Look at the board: the round begins soon.", Role::Text);
            write_hand_in(joined, link, answers, panel);
        }
    }
}

/// Writes the prompt for handing in, and the result.
fn write_hand_in(joined: &JoinedClass, link: &Link, answers: usize, panel: &mut Panel<JoinAction>) {
    let handed = joined.state.handed.map(|it| it.kept);
    let (words, role) = match (link.is_handing_in(), handed) {
        (true, _) if !link.is_in() && joined.state.step == PupilStep::End => (
            "Your answers will be sent when the teacher's carrom can be reached again.".to_owned(),
            Role::Warn,
        ),
        (true, _) => ("Sending your answers ..".to_owned(), Role::Warn),
        (false, Some(Ok(kept))) => {
            let kept = numbers::counted(kept, "answer");
            (format!("Handed in: {kept}."), Role::Good)
        }
        (false, Some(Err(why))) => (format!("Not handed in. {why}"), Role::Warn),
        (false, None) => (String::new(), Role::Text),
    };
    if !words.is_empty() {
        panel.gap();
        panel.paragraph(&words, role);
    }
    if answers > 0 && !link.is_handing_in() && !matches!(handed, Some(Ok(_))) {
        panel.gap();
        let answers = numbers::counted(answers, "answer");
        let words = format!("hand in the {answers} you gave on your own");
        panel.prompt(words, JoinAction::HandIn);
    }
}

fn write_end(joined: &JoinedClass, link: &Link, answers: usize, panel: &mut Panel<JoinAction>) {
    panel.paragraph("The round is over.", Role::Title);
    if let Some((points, place)) = joined.state.score {
        panel.gap();
        let words = format!(
            "You have {} points: place {place}.",
            numbers::points(points)
        );
        panel.paragraph(&words, Role::Text);
    }
    write_hand_in(joined, link, answers, panel);
    panel.gap();
    panel.prompt("use carrom on your own", JoinAction::Leave);
}

fn write_step(
    joined: &JoinedClass,
    question: &Question,
    step: ClassStep,
    link: &Link,
    panel: &mut Panel<JoinAction>,
) {
    match (&joined.doing, step) {
        (Doing::Vote(asking), _) => match asking.sure() {
            None => write_answer(joined, question, asking.input(), link, panel),
            Some(_) => write_sure(question, asking, panel),
        },
        (Doing::Watch(reveal), _) if reveal.is_explaining() => {
            panel.paragraph(&question.text, Role::Dim);
            if let Some(watch) = reveal.watch() {
                panel.gap();
                watch.write_explanation(panel);
            }
        }
        (Doing::Watch(_), _) | (_, ClassStep::Scores) => write_result(joined, question, panel),
        (Doing::Look, step) => {
            // The end of a long text is visible only after scrolling, so the instruction comes
            // first.
            let words = match step {
                ClassStep::Describe => "Read it with the class. The vote comes soon.",
                ClassStep::Predict => "Decide in silence. The vote comes soon.",
                ClassStep::Talk => "Talk: find someone with a different answer, and explain yours.",
                _ => "",
            };
            if !words.is_empty() {
                panel.paragraph(words, Role::Key);
                panel.gap();
            }
            panel.paragraph(&question.text, Role::Text);
            panel.gap();
            write_choices(question, &joined.state.spread, panel);
            if let Some(said) = joined.said() {
                let said = lettered(&question.form, &said.response);
                panel.marked("you said  ", &said, Role::Predicted);
            }
        }
    }
}

/// The choices of a question, with the votes for each.
fn write_choices(question: &Question, counts: &[u32], panel: &mut Panel<JoinAction>) {
    let Form::Choice { options, .. } = &question.form else {
        return;
    };
    let all: f64 = counts.iter().copied().map(f64::from).sum();
    for (i, option) in options.iter().enumerate() {
        panel.marked(&format!("{}  ", letter(i)), option, Role::Text);
        if let Some(count) = counts.get(i) {
            panel.meter("", f64::from(*count) / all.max(1.0), count.to_string());
        }
    }
    panel.gap();
}

/// A sentence about the state of the pupil's vote, if there is anything to say.
fn standing(
    joined: &JoinedClass,
    input: &AnswerInput,
    link: &Link,
) -> Option<(&'static str, Role)> {
    let given = joined.has_voted() && joined.said().map(|said| said.response) == input.said();
    Some(match (link.is_sending(), joined.has_voted()) {
        (true, _) => ("Sending your vote ..", Role::Warn),
        (false, _) if joined.state.misfit => (
            "That answer does not fit the question and was not counted. Please vote again.",
            Role::Warn,
        ),
        (false, true) if given => (
            "Your vote is in. You can change it until the class goes on.",
            Role::Good,
        ),
        (false, true) => ("Your earlier vote counts until you vote again.", Role::Text),
        (false, false) if joined.state.step == PupilStep::Asked(ClassStep::SecondVote) => {
            ("Your first vote counts unless you vote again.", Role::Text)
        }
        (false, false) => return None,
    })
}

fn write_answer(
    joined: &JoinedClass,
    question: &Question,
    input: &AnswerInput,
    link: &Link,
    panel: &mut Panel<JoinAction>,
) {
    let form = &question.form;
    let write_standing = |panel: &mut Panel<JoinAction>| {
        if let Some((words, role)) = standing(joined, input, link) {
            panel.paragraph(words, role);
            panel.gap();
        }
    };
    // The state of the vote stays above the question: all pupils must see that their votes have
    // arrived, however long the text is.
    let is_first = link.is_sending() || joined.state.misfit || joined.has_voted();
    if is_first {
        write_standing(panel);
        panel.pin();
    }
    panel.paragraph(&question.text, Role::Text);
    panel.gap();
    panel.part(JoinAction::answer, |panel| {
        input.write(form, Some(2), panel);
    });
    panel.gap();
    if !is_first {
        write_standing(panel);
    }
    panel.part(JoinAction::answer, |panel| {
        panel.prompts([input.next(form, "next, how sure?")]);
    });
    panel.worth(1, |panel| {
        panel.gap();
        panel.paragraph(input.about(form), Role::Dim);
    });
}

fn write_sure(question: &Question, asking: &Asking, panel: &mut Panel<JoinAction>) {
    panel.part(JoinAction::Ask, |panel| {
        asking.write_confidence(&[], |_| Vec::new(), panel);
    });
    panel.gap();
    panel.line("Your answer", Role::Dim);
    asking.write_said(&question.form, panel);
    panel.gap();
    panel.prompt("that is my vote", JoinAction::Ask(AskingAction::Take));
    panel.paragraph(
        "Your confidence does not change your points here.",
        Role::Dim,
    );
}

/// The pupil's answer beside the true one, and the explanation.
fn write_result(joined: &JoinedClass, question: &Question, panel: &mut Panel<JoinAction>) {
    let said = joined.said().map(|said| said.response);
    let revealed = joined.state.revealed.as_ref();
    if let Some(points) = revealed.and_then(|it| it.points) {
        let points = format!("{} of 10 points", numbers::points(points));
        panel.paragraph(&points, Role::Title);
        panel.gap();
    }
    let hit = question.picture.collision();
    write_beside_truth(&question.form, hit, said, panel);
    panel.gap();
    panel.paragraph(&question.why, Role::Text);
    if let Some((points, place)) = joined.state.score {
        panel.gap();
        let words = format!("{} points so far: place {place}", numbers::points(points));
        panel.paragraph(&words, Role::Title);
    }
}

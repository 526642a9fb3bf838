//! The panel beside the quiz's picture: the question, the confidence, the answer and the
//! explanation.

use super::{AnsweredQuestion, OpenQuestion, QuizAction};
use crate::lessons::Book;
use crate::quiz::{Confidence, Grade, explain};
use crate::screens::leads;
use crate::widgets::hit::{Watch, write_observation};
use crate::widgets::panel::Panel;
use crate::widgets::{Role, write_beside_truth};

/// The question, and the answer so far.
pub(super) fn asked(asked: &OpenQuestion, panel: &mut Panel<QuizAction>) {
    let form = &asked.question.form;
    let input = asked.asking.input();
    panel.paragraph(&asked.question.text, Role::Text);
    panel.gap();
    panel.part(QuizAction::answer, |panel| {
        input.write(form, Some(1), panel);
    });
    panel.worth(3, |panel| {
        panel.gap();
        panel.paragraph(input.about(form), Role::Dim);
    });
    panel.worth(2, |panel| {
        panel.gap();
        panel.part(QuizAction::answer, |panel| {
            panel.prompts([input.next(form, "next, how sure?")]);
        });
    });
}

/// The confidence levels with their points, and the answer to which they apply.
pub(super) fn confidence(
    asked: &OpenQuestion,
    feedback_at_end: bool,
    panel: &mut Panel<QuizAction>,
) {
    panel.part(QuizAction::Ask, |panel| {
        let heads = ["points if", "wrong", "right"];
        let points = |confidence: Confidence| {
            [0.0, 1.0].map(|credit| format!("{:.0}", confidence.points(credit)))
        };
        let asking = &asked.asking;
        asking.write_confidence(&heads, |confidence| points(confidence).into(), panel);
    });
    panel.gap();
    panel.line("You said", Role::Dim);
    asked.asking.write_said(&asked.question.form, panel);
    panel.worth(2, |panel| {
        panel.gap();
        let advice = "Be honest with yourself: that earns the most points.";
        panel.paragraph(advice, Role::Dim);
    });
    panel.worth(1, |panel| {
        panel.gap();
        let next = match asked.question.picture.collision() {
            _ if feedback_at_end => "next question",
            Some(_) => "watch what happens",
            None => "see the answer",
        };
        panel.prompt(next, QuizAction::TAKE);
    });
}

/// The question, and the step that the picture is showing.
pub(super) fn watching(watched: &AnsweredQuestion, panel: &mut Panel<QuizAction>) {
    panel.paragraph(&watched.question.text, Role::Dim);
    panel.gap();
    if let Some(watch) = watched.reveal.watch() {
        watch.write_explanation(panel);
    }
}

/// The points, the answer beside the true one, and the explanation, which is never cut: if
/// there is not enough room, less important parts are dropped.
pub(super) fn feedback(watched: &AnsweredQuestion, book: &Book, panel: &mut Panel<QuizAction>) {
    let question = &watched.question;
    let grade = Grade::new(question, &watched.answer);
    let explanation = explain(question, &watched.answer);
    panel.worth(1, |panel| {
        panel.paragraph(&question.text, Role::Dim);
        panel.gap();
    });
    let role = if grade.right { Role::Good } else { Role::Text };
    panel.pair((grade.score(), role), (grade.confidence.name(), Role::Dim));
    panel.worth(6, |panel| {
        let percent = format!("{:.0} %", 100.0 * grade.credit);
        panel.meter("credit", grade.credit, percent);
    });
    panel.worth(4, Panel::gap);
    let hit = watched.reveal.watch().map(Watch::collision);
    write_beside_truth(&question.form, hit, Some(watched.answer.said), panel);
    panel.worth(5, Panel::gap);
    if let (Some(watch), Some(observed)) = (watched.reveal.watch(), &watched.observed) {
        write_observation(watch.collision(), observed, panel);
        panel.gap();
    }
    panel.paragraph(explanation.title, Role::Title);
    panel.paragraph(&explanation.text, Role::Text);
    panel.worth(3, Panel::gap);
    leads::write(explanation.passage, book, QuizAction::ReadUp, panel);
    panel.worth(2, |panel| {
        let next = match watched.opened {
            _ if watched.remedy.is_some() => "the right shot",
            Some(_) => "back to the list",
            None => "go on",
        };
        panel.prompt(next, QuizAction::GoOn);
    });
}

//! The panel of a page: its text and question, or the feedback on an answer.

use super::ReadingAction;
use super::page::{CheckpointStage, OpenPage};
use crate::lessons::{Checkpoint, CheckpointKind};
use crate::quiz::{Form, Rays, Response, why_of_hit};
use crate::screens::learn::figure::LiveFigure;
use crate::screens::learn::prose::Prose;
use crate::widgets::hit::{Watch, explain};
use crate::widgets::panel::Panel;
use crate::widgets::panels::{reason, said_and_true};
use crate::widgets::{AnswerAction, AnswerInput, Charset, Role};

/// The prompts have the lowest priority, because the line of keys shows them too; next comes the
/// text that has already been read.
const NEXT: u8 = 1;
const READ: u8 = 2;

/// The panel of page `at`; a notice stays visible at its top.
pub(super) fn panel(
    open: &OpenPage,
    at: usize,
    notice: Option<&str>,
    charset: Charset,
) -> Panel<ReadingAction> {
    let mut panel = Panel::new(open.page.title.as_str());
    panel.subject = 3 * at;
    if let Some(notice) = notice {
        panel.line(notice, Role::Key);
        panel.gap();
        panel.pin();
    }
    let prose = Prose {
        figure: open.collision(),
        charset,
    };
    if let Some(watch) = open.explaining() {
        watch.write_explanation(&mut panel);
        return panel;
    }
    let question = (&open.page.checkpoint, open.form(), &open.stage);
    let (Some(checkpoint), Some(form), Some(stage)) = question else {
        prose.write(&open.page.text, &mut panel);
        return panel;
    };
    match stage {
        CheckpointStage::Asking(input) => {
            panel.subject += usize::from(open.first.is_some());
            // The page is shown from its beginning until the student begins to answer.
            panel.from_top = *input == AnswerInput::new(&form);
            asking(open, checkpoint, (&form, input), prose, &mut panel);
        }
        CheckpointStage::Answered(answer) => {
            panel.subject += 2;
            // The text stays above the feedback, if there is room for both.
            panel.worth(READ, |panel| {
                prose.write_dimmed(&open.page.text, panel);
                if answer.rays().is_some() {
                    panel.gap();
                    prose.write_dimmed(&checkpoint.question, panel);
                }
                panel.gap();
            });
            revealed(open, checkpoint, (&form, answer), prose, &mut panel);
        }
    }
    panel
}

/// The question, and the answer being entered.
fn asking(
    open: &OpenPage,
    checkpoint: &Checkpoint,
    (form, input): (&Form, &AnswerInput),
    prose: Prose,
    panel: &mut Panel<ReadingAction>,
) {
    match &open.first {
        None => {
            prose.write(&open.page.text, panel);
            panel.gap();
        }
        Some(_) => panel.worth(READ, |panel| {
            prose.write_dimmed(&open.page.text, panel);
            panel.gap();
        }),
    }
    prose.write(&checkpoint.question, panel);
    panel.gap();
    if let Some(first) = &open.first {
        let verdict = match form.rays_grade(first) {
            Some(grade) if grade.striker.is_right() => {
                "The striker is right. The coin is not right yet."
            }
            Some(grade) if grade.target.is_right() => {
                "The coin is right. The striker is not right yet."
            }
            None if form.credit(first) > 0.0 => "Nearly. A hint:",
            _ => "Not yet. A hint:",
        };
        panel.paragraph(verdict, Role::Warn);
        prose.write(&checkpoint.hint_to(first), panel);
        panel.gap();
    }
    let said = input.said();
    let answer = |action| match action {
        // A click on the chosen option gives the answer.
        AnswerAction::Choose(at) if said == Some(Response::Choice(at)) => {
            ReadingAction::Answer(AnswerAction::Give(at))
        }
        action => ReadingAction::Answer(action),
    };
    panel.part(answer, |panel| input.write(form, None, panel));
    panel.worth(NEXT, |panel| {
        panel.gap();
        panel.part(answer, |panel| match (input, form) {
            (AnswerInput::Rays(rays), Form::Rays { target, .. }) => {
                panel.part(AnswerAction::Ray, |panel| {
                    rays.write_prompt(panel, target, "watch");
                });
            }
            _ if said.is_some() => panel.prompts([input.next(form, "confirm")]),
            _ => panel.paragraph(input.about(form), Role::Key),
        });
    });
}

/// The feedback on an answer.
fn revealed(
    open: &OpenPage,
    checkpoint: &Checkpoint,
    (form, answer): (&Form, &Response),
    prose: Prose,
    panel: &mut Panel<ReadingAction>,
) {
    if answer.rays().is_none() {
        prose.write(&checkpoint.question, panel);
        panel.gap();
    }
    let right = form.is_right(answer);
    match (answer, &checkpoint.asked, &open.figure) {
        (Response::Rays(rays), _, Some(figure)) => {
            if let Some(watch) = figure.watch() {
                write_rays(rays, watch, figure, panel);
            }
        }
        (Response::Choice(chosen), CheckpointKind::Choice(choices), _) => {
            let (mark, role) = match right {
                true => ("✓", Role::Good),
                false => ("✗", Role::Warn),
            };
            if let Some(choice) = choices.get(*chosen) {
                panel.flow(mark, prose.runs(&choice.text, role));
                panel.flow("", prose.runs(&choice.why, Role::Text));
            }
            if let Some(true_one) = choices.iter().find(|it| it.right && !right) {
                panel.gap();
                panel.flow("✓", prose.runs(&true_one.text, Role::Good));
            }
        }
        _ => write_number((form, answer), right, panel),
    }
    if open.first.is_some() && right {
        panel.paragraph("On the second try: half the credit.", Role::Dim);
    }
    if !checkpoint.after.is_empty() {
        panel.gap();
        prose.write(&checkpoint.after, panel);
    }
}

/// The predicted rays beside the true ones, and the explanation that starts from the prediction.
fn write_rays<A>(rays: &Rays, watch: &Watch, figure: &LiveFigure, panel: &mut Panel<A>) {
    let names = ["striker", "coin"].map(Some);
    said_and_true(watch.collision(), rays, names, false, panel);
    panel.gap();
    let why = match figure.question_by_angle() {
        Some(question) => why_of_hit(&question, Some(*rays)),
        None => explain(watch),
    };
    reason(&why, panel);
}

/// The student's number beside the right one.
fn write_number<A>((form, answer): (&Form, &Response), right: bool, panel: &mut Panel<A>) {
    let role = if right { Role::Good } else { Role::Warn };
    panel.pair(("you said", Role::Dim), (form.words(answer), role));
    match form.truth() {
        Response::Number(truth) if truth.is_infinite() => {}
        truth => panel.fact("truth", form.words(&truth)),
    }
    panel.gap();
    let verdict = match right {
        true => "Right.",
        false if form.credit(answer) > 0.0 => "Nearly.",
        false => "Not this time. Here is why:",
    };
    panel.paragraph(verdict, role);
}

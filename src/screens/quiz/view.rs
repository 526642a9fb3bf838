//! The view of the quiz.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{AnsweredQuestion, OpenQuestion, Quiz, QuizAction, QuizPhase, panel, summary};
use crate::quiz::{Form, Illustration, Question};
use crate::screens::{Context, View};
use crate::widgets::hit::Sighting;
use crate::widgets::panel::Panel;
use crate::widgets::{Look, SplitLayout, draw_question};

pub(super) fn view<'s>(quiz: &'s Quiz, cx: &Context) -> View<'s, QuizAction> {
    match &quiz.phase {
        QuizPhase::Asked(asked) => of_asked(quiz, asked),
        QuizPhase::See(sighting) => of_seen(quiz, sighting),
        QuizPhase::Watch(watched) => of_watched(quiz, watched, cx),
        QuizPhase::Summary(list) => {
            let at = list.chosen(quiz.answers.len());
            let layout = |area| SplitLayout::text_of(area, summary::WIDEST);
            View::alone(layout, summary::panel(quiz, at, &cx.book))
        }
    }
}

fn of_asked<'s>(quiz: &Quiz, asked: &'s OpenQuestion) -> View<'s, QuizAction> {
    let (question, sure) = (&asked.question, asked.asking.sure().is_some());
    let mut text = Panel::new("predict it");
    text.subject = 2 * quiz.number() + usize::from(sure);
    match sure {
        false => panel::asked(asked, &mut text),
        true => panel::confidence(asked, quiz.feedback_at_end(), &mut text),
    }
    let input = asked.asking.input();
    let draw = move |area, buf: &mut _, look: &_| {
        draw_question(area, buf, look, question, Some(input));
    };
    let view = beside_picture(question.family.name().into(), question, text, draw);
    view.dragging(input.drag(question).filter(|_| !sure))
}

fn of_seen<'s>(quiz: &Quiz, sighting: &'s Sighting) -> View<'s, QuizAction> {
    let mut text = Panel::new("watch");
    text.subject = 2 * quiz.number();
    let mut answered = quiz.round.questions().iter().zip(&quiz.answers);
    let target = match answered.next_back().map(|(question, _)| &question.form) {
        Some(Form::Rays { target, .. }) => target,
        _ => "coin",
    };
    text.part(QuizAction::See, |panel| sighting.write(target, panel));
    View::drawn(sighting.title(), |area| sighting.picture(area), text).dragging(sighting.drag())
}

fn of_watched<'s>(
    quiz: &Quiz,
    watched: &'s AnsweredQuestion,
    cx: &Context,
) -> View<'s, QuizAction> {
    let explaining = watched.reveal.is_explaining();
    let mut text = Panel::new(if explaining { "watch" } else { "and why" });
    text.subject = quiz.number();
    match explaining {
        true => panel::watching(watched, &mut text),
        false => panel::feedback(watched, &cx.book, &mut text),
    }
    let question = &watched.question;
    let draw = move |area, buf: &mut _, look: &_| match watched.reveal.watch() {
        Some(watch) => watch.picture(area).draw(buf, look),
        None => draw_question(area, buf, look, question, None),
    };
    beside_picture(title(watched), question, text, draw)
}

/// Text beside the question's picture; without a picture, the text alone, under the title that the
/// picture would have.
fn beside_picture<'s>(
    title: String,
    question: &Question,
    mut text: Panel<QuizAction>,
    draw: impl Fn(Rect, &mut Buffer, &Look) + 's,
) -> View<'s, QuizAction> {
    match question.picture {
        Illustration::Nothing => {
            text.title = title;
            View::alone(SplitLayout::card, text)
        }
        _ => View::picture(title, draw, text),
    }
}

fn title(watched: &AnsweredQuestion) -> String {
    let Some(watch) = watched.reveal.watch() else {
        return watched.question.family.name().into();
    };
    if let Form::Shot(aim) = &watched.question.form
        && watched.reveal.is_revealed()
    {
        return watch.title(match watch.collision().offset == aim.offset {
            true => "the shot that does it",
            false => "your shot",
        });
    }
    watch.slowed_title()
}

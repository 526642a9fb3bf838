//! The quiz: the player chooses a round, answers its questions, watches and reads the
//! explanations, and sees a summary at the end.

mod choose;
mod panel;
mod summary;
#[cfg(test)]
mod tests;
mod view;

pub(crate) use choose::Choosing;

use std::time::Duration;

use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::ahead::Ahead;
use super::{Confirmation, Context, Next, Route, Screen, View, leads};
use crate::lessons::Book;
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::physics::{Collision, Frame};
use crate::progress::{Attempt, Observation, ObservationPlace, Summary};
use crate::quiz::{
    Answer, Code, Course, CourseKind, Form, Grade, Illustration, Misconception, Passage, Question,
    Rays, Response, Round, explain,
};
use crate::widgets::hit::{Overlays, Reveal, Sighting, SightingAction, Watch, WatchAction};
use crate::widgets::input::{KeyTable, ListAction, ListView};
use crate::widgets::{AnswerAction, AnswerInput, Asking, AskingAction, Outcome, PAGE_ROWS};

/// If the verdict appears as soon as a confidence level is chosen, the first Enter within this time
/// does not close it: a player who presses a digit for the level and then Enter means to confirm
/// the digit.
const SETTLING: Duration = Duration::from_millis(500);

/// Returns to choosing a round.
const CHOOSE: Next = Next::Replace(Route::Quiz(None));

/// Actions in a round of the quiz.
#[derive(Debug, Clone, Copy, PartialEq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum QuizAction {
    /// answer the question
    Ask(AskingAction),
    /// watch without any explanation, and say what you saw
    See(SightingAction),
    /// watch the collision
    Watch(WatchAction),
    /// show what happens, then go on
    GoOn,
    /// choose a question, or open it
    LookBack(ListAction),
    /// start another round of the same kind
    Another,
    /// open the chapter page that explains the answer
    ReadUp,
    /// take the next step
    Next,
    /// check with two questions whether you still believe it
    Check,
    /// scroll a text that is longer than its panel
    Scroll(i16),
    /// go back, or leave the round
    Leave,
}

impl QuizAction {
    /// Confirms the chosen confidence.
    const TAKE: Self = Self::Ask(AskingAction::Take);

    const fn answer(action: AnswerAction) -> Self {
        Self::Ask(AskingAction::Answer(action))
    }
}

/// A round of the quiz.
#[derive(Debug, Clone)]
pub(crate) struct Quiz {
    round: Round,
    /// The answers, in the order of the questions.
    answers: Vec<Answer>,
    /// The answers in the form in which they are saved.
    attempts: Vec<Attempt>,
    phase: QuizPhase,
    /// The overlays that the player has switched on.
    layers: Overlays,
    /// The next step, requested with the summary.
    ahead: Option<Ahead>,
}

#[derive(Debug, Clone)]
enum QuizPhase {
    /// Answering, then choosing a confidence level.
    Asked(Box<OpenQuestion>),
    /// Observing the collision of the question just answered, without any explanation.
    See(Box<Sighting>),
    /// Watching what happens, if there is something to watch, and reading the explanation.
    Watch(Box<AnsweredQuestion>),
    /// The summary, with one question marked.
    Summary(ListView),
}

/// A question, and the answer so far.
#[derive(Debug, Clone)]
struct OpenQuestion {
    question: Question,
    asking: Asking,
}

/// A question and the answer to it.
#[derive(Debug, Clone)]
struct AnsweredQuestion {
    question: Question,
    answer: Answer,
    /// The collision, if the question is about one.
    reveal: Reveal,
    /// The right shot, which is shown next if the player's shot was wrong.
    remedy: Option<Watch>,
    /// The question's index, if it was opened from the summary.
    opened: Option<usize>,
    /// The rest of the time in which an Enter is ignored: see [`SETTLING`].
    settling: Duration,
    /// What the player saw, if they were asked.
    observed: Option<Observation>,
}

impl Quiz {
    /// The round with this code, at its first question.
    pub(crate) fn new(code: Code) -> Self {
        let mut quiz = Self {
            round: Round::of(code),
            answers: Vec::new(),
            attempts: Vec::new(),
            phase: QuizPhase::Summary(ListView::default()),
            layers: Overlays::default(),
            ahead: None,
        };
        quiz.ask();
        quiz
    }

    /// The round with this code, resumed after these answers, which are already saved.
    /// `is_explained` means that the last answer is still being explained. The first answer that
    /// does not fit its question is dropped, together with all that follow it.
    pub(crate) fn left_at(
        code: Code,
        answers: &[Answer],
        is_explained: bool,
        cx: &mut Context,
    ) -> Self {
        let mut quiz = Self::new(code);
        for answer in answers {
            let question = quiz.round.questions().get(quiz.answers.len()).cloned();
            let accepts = |it: &Question| it.form.accepts(&answer.said);
            let Some(question) = question.filter(accepts) else {
                break;
            };
            quiz.note(&question, *answer, cx);
        }
        quiz.ask();
        quiz.look_ahead(cx);
        if let Some(last) = quiz.answers.len().checked_sub(1)
            && is_explained
            && !quiz.feedback_at_end()
            && let Some(watched) = quiz.show(last, cx)
        {
            watched.reveal.at_once();
        }
        quiz
    }

    /// Asks the next question, or shows the summary after the last.
    fn ask(&mut self) {
        self.phase = match self.round.questions().get(self.answers.len()) {
            Some(question) => QuizPhase::Asked(Box::new(OpenQuestion {
                question: question.clone(),
                asking: Asking::new(AnswerInput::new(&question.form)),
            })),
            None => QuizPhase::Summary(ListView::default()),
        };
    }

    /// Whether every question has been answered.
    fn is_over(&self) -> bool {
        self.answers.len() >= self.round.questions().len()
    }

    /// Whether the summary, or a question opened from it, is shown.
    fn has_ended(&self) -> bool {
        match &self.phase {
            QuizPhase::Summary(_) => true,
            QuizPhase::Watch(watched) => watched.opened.is_some(),
            QuizPhase::Asked(_) | QuizPhase::See(_) => false,
        }
    }

    /// Whether feedback comes only at the end.
    fn feedback_at_end(&self) -> bool {
        self.round.course().feedback_at_end()
    }

    /// Records the answer to the current question, and returns it in the form in which it is saved.
    fn note(&mut self, question: &Question, answer: Answer, cx: &Context) -> Attempt {
        self.answers.push(answer);
        let (code, number) = (self.round.code(), self.answers.len() as u32);
        let attempt = Attempt::of_quiz(&cx.settings.player, code, number, question, &answer);
        self.attempts.push(attempt.clone());
        self.round.go_on(&self.answers);
        attempt
    }

    /// Records an answer, then shows the collision or asks the next question.
    fn answer(&mut self, question: &Question, answer: Answer, cx: &mut Context) {
        let attempt = self.note(question, answer, cx);
        // The answer is saved before the explanation is shown.
        cx.record(attempt);
        if self.feedback_at_end() {
            self.ask();
        } else if let Some(sighting) = sighting(question, &answer, cx) {
            self.phase = QuizPhase::See(Box::new(sighting));
        } else {
            self.explain(None, cx);
        }
    }

    /// Explains the question just answered, and records what the player saw, if they were asked and
    /// answered.
    fn explain(&mut self, seen: Option<Rays>, cx: &mut Context) {
        let last = self.answers.len().saturating_sub(1);
        if let Some(watched) = self.show(last, cx)
            && let Some(seen) = seen
            && let Some(said) = watched.answer.said.rays()
            && let Some(truth) = watched.question.form.truth().rays()
        {
            watched.observed = Some(cx.observe(ObservationPlace::Quiz, [said, truth, seen]));
        }
    }

    /// Opens an answered question from the summary, with its full explanation.
    fn open(&mut self, at: usize, cx: &Context) {
        if let Some(watched) = self.show(at, cx) {
            watched.opened = Some(at);
            watched.reveal.at_once();
        }
    }

    /// Shows what happens in an answered question, if it exists.
    fn show(&mut self, at: usize, cx: &Context) -> Option<&mut AnsweredQuestion> {
        let (question, answer) = self.round.questions().get(at).zip(self.answers.get(at))?;
        let watched = AnsweredQuestion::new(question.clone(), *answer, self.layers, cx);
        self.phase = QuizPhase::Watch(Box::new(watched));
        self.watched()
    }

    fn watched(&mut self) -> Option<&mut AnsweredQuestion> {
        match &mut self.phase {
            QuizPhase::Watch(watched) => Some(watched),
            _ => None,
        }
    }

    /// Plays another round of the same kind; a set has only one round, which is played again. After
    /// a review, other topics are due, so the player chooses a round.
    fn again(&mut self, cx: &mut Context) -> Next {
        let mut code = self.round.code().clone();
        match code.course.kind {
            CourseKind::Review(_) => return CHOOSE,
            CourseKind::Set(_) => {}
            _ => {
                while code.seed == self.round.code().seed {
                    code.seed = cx.next_seed();
                }
            }
        }
        *self = Self::new(code);
        Next::Stay
    }

    /// The misconception that was found, if the round looks for one.
    fn found(&self) -> Option<Misconception> {
        let follows = self.round.course().follows_answers();
        follows.then(|| self.summary().most_held()).flatten()
    }

    /// Asks further questions to check whether the player still has the misconception that was found.
    fn check(&mut self) {
        if let Some(misconception) = self.found() {
            let course = Course::new(CourseKind::Check(misconception));
            let seed = self.round.code().seed;
            *self = Self::new(Code { course, seed });
        }
    }

    /// Requests the next step, when the summary is shown.
    fn look_ahead(&mut self, cx: &mut Context) {
        if let (QuizPhase::Summary(_), None) = (&self.phase, &self.ahead) {
            self.ahead = Some(Ahead::ask(cx));
        }
    }

    /// The number of the current question, counted from 1.
    fn number(&self) -> usize {
        match &self.phase {
            QuizPhase::Asked(_) => self.answers.len() + 1,
            QuizPhase::Watch(watched) => watched.opened.map_or(self.answers.len(), |at| at + 1),
            QuizPhase::See(_) | QuizPhase::Summary(_) => self.answers.len(),
        }
    }

    /// A summary of the answers whose results have been shown.
    fn summary(&self) -> Summary<'_> {
        let watching = match &self.phase {
            QuizPhase::Watch(watched) => {
                usize::from(!watched.reveal.is_revealed() && watched.opened.is_none())
            }
            QuizPhase::See(_) => 1,
            _ => 0,
        };
        let feedback = self.attempts.len().saturating_sub(watching);
        Summary::new(self.attempts.get(..feedback).unwrap_or_default())
    }

    /// The page to read after a wrong answer, once the result has been shown; after a round, the
    /// page that its summary suggests, unless it is the next step anyway.
    fn passage(&self, book: &Book) -> Option<Passage> {
        match &self.phase {
            QuizPhase::Asked(_) | QuizPhase::See(_) => None,
            QuizPhase::Watch(watched) if watched.reveal.is_explaining() => None,
            QuizPhase::Watch(watched) => explain(&watched.question, &watched.answer).passage,
            QuizPhase::Summary(_) => self.summary().passage().filter(|page| {
                let ahead = self.ahead.as_ref();
                !ahead.is_some_and(|ahead| ahead.is_page(*page, book))
            }),
        }
    }

    /// Closes an answered question: goes to the next one, or back to the list from which it was
    /// opened.
    fn put_away(&mut self) {
        let QuizPhase::Watch(watched) = &self.phase else {
            return;
        };
        self.layers = watched.reveal.layers().unwrap_or(self.layers);
        match watched.opened {
            Some(at) => self.phase = QuizPhase::Summary(ListView::at(at)),
            None => self.ask(),
        }
    }

    /// Goes one step back from a confidence level or an opened question; otherwise leaves the
    /// round, after a confirmation unless nothing has been answered or the summary is shown. A
    /// round with feedback at the end then shows its results first.
    fn leave(&mut self) -> Next {
        if let QuizPhase::Asked(asked) = &mut self.phase
            && asked.asking.back()
        {
            return Next::Stay;
        }
        match &self.phase {
            QuizPhase::Watch(watched) if watched.opened.is_some() => {
                self.put_away();
                Next::Stay
            }
            QuizPhase::Summary(_) => CHOOSE,
            _ if self.answers.is_empty() => CHOOSE,
            _ => {
                let kept = match self.answers.len() {
                    1 => "Your answer is saved.".to_owned(),
                    count => format!("Your {count} answers are saved."),
                };
                let (what, yes) = match self.round.course().kind {
                    CourseKind::Exam => ("End the exam and see your answers?", "end the exam"),
                    CourseKind::Before | CourseKind::After => {
                        ("End the round and see your answers?", "end the round")
                    }
                    CourseKind::FindOut | CourseKind::FindOutFromAny => {
                        ("Stop here and see what your answers show?", "stop here")
                    }
                    _ => ("Leave the round?", "leave the round"),
                };
                Next::Confirm(Confirmation::new(format!("{what} {kept}"), yes, "stay"))
            }
        }
    }
}

impl AnsweredQuestion {
    /// The question with an answer just given. If the answer is a shot, that shot is shown.
    fn new(question: Question, answer: Answer, layers: Overlays, cx: &Context) -> Self {
        let rays = answer.said.rays();
        let pace = cx.settings.pace();
        let frame = question.seen_from();
        let watch = |collision: Collision| {
            Watch::new(collision, rays, pace)
                .with_layers(layers)
                .seen_from(frame)
        };
        let (watch, remedy) = match (&question.form, answer.said) {
            (Form::Shot(aim), Response::Shot(offset)) => {
                let shot = |offset| watch(aim.with(offset)).with_wanted(*aim);
                let right = Grade::new(&question, &answer).right;
                let remedy = (!right).then(|| shot(aim.offset).at_once());
                (Some(shot(offset)), remedy)
            }
            _ => (question.picture.collision().copied().map(watch), None),
        };
        Self {
            question,
            answer,
            reveal: Reveal::new(watch),
            remedy,
            opened: None,
            settling: Duration::ZERO,
            observed: None,
        }
    }
}

/// The collision to observe, if the answer predicts both rays and it is time to ask what the player
/// sees.
fn sighting(question: &Question, answer: &Answer, cx: &mut Context) -> Option<Sighting> {
    let (Illustration::Before { collision, shown }, Form::Rays { .. }) =
        (&question.picture, &question.form)
    else {
        return None;
    };
    let is_plain = question.seen_from() == Frame::Laboratory && answer.said.rays().is_some();
    let asks = is_plain && cx.settings.asks_what_is_seen();
    asks.then(|| Sighting::new(*collision, *shown, cx.settings.pace()))
}

impl Screen for Quiz {
    type Action = QuizAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "quiz";

    fn route(&self, _cx: &Context) -> Route {
        Route::OpenRound {
            code: self.round.code().clone(),
            answers: self.answers.clone(),
            is_explained: match &self.phase {
                QuizPhase::See(_) => true,
                QuizPhase::Watch(it) => it.opened.is_none(),
                QuizPhase::Asked(_) | QuizPhase::Summary(_) => false,
            },
        }
    }

    fn status(&self, _cx: &Context) -> String {
        let course = self.round.course();
        let count = self.round.questions().len();
        let mut status = match self.phase {
            QuizPhase::Summary(_) if self.is_over() => "all answered".into(),
            QuizPhase::Summary(_) => format!("{} of {count} answered", self.answers.len()),
            _ if course.follows_answers() => {
                format!("question {} of at most {}", self.number(), course.count)
            }
            _ => format!("question {} of {count}", self.number()),
        };
        let scores = !course.follows_answers();
        if scores && (!self.feedback_at_end() || self.has_ended()) {
            status += &format!("  {} right", self.summary().right());
        }
        match &course.kind {
            CourseKind::Review(_) if self.is_over() => status + "  review",
            CourseKind::Review(due) => format!("{status}  review: {count} of {} due", due.len()),
            CourseKind::Met(_) => status,
            _ => format!("{status}  code {}", self.round.code()),
        }
    }

    fn keys(&self, cx: &Context) -> KeyTable<QuizAction> {
        use QuizAction::{Another, Ask, Check, GoOn, Leave, LookBack, ReadUp, Scroll, Watch};
        let keys = KeyTable::new("quiz");
        match &self.phase {
            QuizPhase::Asked(asked) => {
                let next = match asked.question.picture.collision() {
                    _ if self.feedback_at_end() => "next",
                    Some(_) => "watch",
                    None => "see",
                };
                let leave = match asked.asking.sure() {
                    None => "leave",
                    Some(_) => "change it",
                };
                keys.with(asked.asking.keys("quiz", next), Ask)
                    .on(Key::Escape, Leave, leave)
                    .when(asked.asking.leaves_escape())
            }
            QuizPhase::See(sighting) => {
                keys.with(sighting.keys(), QuizAction::See)
                    .on(Key::Escape, Leave, "leave")
            }
            QuizPhase::Watch(watched) => {
                let next = match watched.opened {
                    _ if watched.remedy.is_some() => "the right shot",
                    Some(_) => "back to the list",
                    None if !self.is_over() => "next question",
                    None => "look back",
                };
                let away = match watched.opened {
                    Some(_) => "back",
                    None => "leave",
                };
                let scroll = match watched.reveal.watch() {
                    Some(_) => "",
                    None => "scroll",
                };
                // Until the explanation is complete, Enter steps through it.
                keys.on(Key::Enter, GoOn, next)
                    .when(!watched.reveal.is_explaining())
                    .on(Key::Char('c'), ReadUp, "chapter")
                    .when(self.passage(&cx.book).is_some())
                    .on(Key::Escape, Leave, away)
                    .with(watched.reveal.keys(), Watch)
                    .each([(Key::Up, Scroll(-1)), (Key::Down, Scroll(1))], scroll)
            }
            QuizPhase::Summary(_) => keys
                .with(ListView::keys("look at it"), LookBack)
                .on(Key::Char('x'), QuizAction::Next, "next step")
                .when(self.ahead.as_ref().is_some_and(|it| it.step().is_some()))
                .on(Key::Char('k'), Check, "check it")
                .when(self.found().is_some())
                .on(Key::Char('n'), Another, "another round")
                .on(Key::Escape, Leave, "other rounds")
                .on(Key::Char('c'), ReadUp, "chapter")
                .when(self.passage(&cx.book).is_some()),
        }
    }

    fn act(&mut self, action: QuizAction, cx: &mut Context) -> Next {
        match (action, &mut self.phase) {
            (QuizAction::Ask(action), QuizPhase::Asked(asked)) => {
                if let Outcome::Done((said, sure)) = asked.asking.act(action) {
                    let question = asked.question.clone();
                    self.answer(&question, Answer::new(said, sure), cx);
                    if let (AskingAction::Sure(_), Some(watched)) = (action, self.watched())
                        && watched.reveal.watch().is_none()
                    {
                        watched.settling = SETTLING;
                    }
                }
            }
            (QuizAction::See(action), QuizPhase::See(sighting)) => {
                if let Outcome::Done(seen) = sighting.act(action) {
                    self.explain(seen, cx);
                }
            }
            (QuizAction::Watch(action), QuizPhase::Watch(watched)) => watched.reveal.act(action),
            (QuizAction::GoOn, QuizPhase::Watch(watched)) if !watched.settling.is_zero() => {
                watched.settling = Duration::ZERO;
            }
            (QuizAction::GoOn, QuizPhase::Watch(watched)) => match watched.remedy.take() {
                Some(remedy) => watched.reveal.show(remedy),
                None => self.put_away(),
            },
            (QuizAction::LookBack(action), QuizPhase::Summary(list)) => {
                let count = self.answers.len();
                let before = list.chosen(count);
                let outcome = list.act(action, count);
                // At an end of the list, the text scrolls instead.
                let is_at_end = list.chosen(count) == before;
                match (outcome, action) {
                    (Outcome::Done(at), _) => self.open(at, cx),
                    (_, ListAction::Choose(by)) if is_at_end => return Next::scroll(by as i16),
                    (_, ListAction::Page(by) | ListAction::End(by)) if is_at_end => {
                        return Next::scroll(PAGE_ROWS * by as i16);
                    }
                    _ => {}
                }
            }
            (QuizAction::Another, _) => return self.again(cx),
            (QuizAction::ReadUp, _) => return leads::open(self.passage(&cx.book), cx),
            (QuizAction::Next, _) => {
                let ahead = self.ahead.as_ref();
                return match ahead.map_or(Next::Stay, |ahead| ahead.follow(cx)) {
                    // Another round replaces this one.
                    Next::Open(round @ Route::Quiz(_)) => Next::Replace(round),
                    other => other,
                };
            }
            (QuizAction::Check, _) => self.check(),
            (QuizAction::Scroll(rows), _) => return Next::scroll(rows),
            (QuizAction::Leave, _) => return self.leave(),
            _ => return Next::Ignored,
        }
        self.look_ahead(cx);
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        let ahead = self.ahead.as_mut();
        ahead.map_or(Next::Ignored, |ahead| ahead.input(input, cx))
    }

    fn resumed(&mut self, cx: &mut Context) {
        match &mut self.ahead {
            Some(ahead) => ahead.ask_again(cx),
            None => self.look_ahead(cx),
        }
    }

    fn confirmed(&mut self, _left: QuizAction, cx: &mut Context) -> Next {
        if self.feedback_at_end() {
            self.phase = QuizPhase::Summary(ListView::default());
            self.look_ahead(cx);
            return Next::Stay;
        }
        CHOOSE
    }

    fn point(&mut self, mouse: &Mouse, picture: Rect, _cx: &mut Context) -> Next {
        let pressed = mouse.kind == MouseKind::Down;
        let on_picture = picture.contains(mouse.cell().into());
        match &mut self.phase {
            QuizPhase::Asked(asked) if on_picture && mouse.is_held() => {
                let OpenQuestion { question, asking } = &mut **asked;
                let input = asking.input_mut();
                Next::after(
                    input.is_some_and(|input| {
                        input.point(question, picture, mouse.place(), pressed)
                    }),
                )
            }
            QuizPhase::See(sighting) if on_picture && mouse.is_held() => {
                sighting.point(picture, mouse.place(), pressed);
                Next::Stay
            }
            QuizPhase::Watch(watched) if pressed && on_picture => {
                if let Some(action) = watched.reveal.keys().find(Key::Char(' ')) {
                    watched.reveal.act(action);
                }
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        match &mut self.phase {
            QuizPhase::Summary(_) => {
                return self.act(QuizAction::LookBack(ListAction::Choose(by.into())), cx);
            }
            QuizPhase::Watch(watched) => watched.reveal.act(WatchAction::Step(-by)),
            QuizPhase::Asked(_) | QuizPhase::See(_) => return Next::scroll(by.into()),
        }
        Next::Stay
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        if let QuizPhase::See(sighting) = &mut self.phase {
            sighting.advance(passed, cx.settings.pace());
        }
        if let QuizPhase::Watch(watched) = &mut self.phase {
            watched.settling = watched.settling.saturating_sub(passed);
            watched.reveal.advance(passed, cx.settings.pace());
        }
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        match &self.phase {
            QuizPhase::Watch(watched) if !watched.settling.is_zero() => Some(watched.settling),
            QuizPhase::Watch(watched) => watched.reveal.wake(cx.settings.pace()),
            QuizPhase::See(sighting) => sighting.wake(cx.settings.pace()),
            _ => None,
        }
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, QuizAction> {
        view::view(self, cx)
    }
}

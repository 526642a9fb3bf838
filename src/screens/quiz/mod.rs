//! The quiz: a round is chosen; its questions are answered, watched and explained; then
//! comes a look back.

mod choose;
mod panel;
mod summary;
#[cfg(test)]
mod tests;
mod view;

pub(crate) use choose::Choosing;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Context, Help, Hint, Next, OldScreen, Place};
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::numbers;
use crate::physics::Collision;
use crate::progress::Attempt;
use crate::quiz::{
    Answer, Code, Confidence, CourseKind, Form, Grade, Question, Response, Round, Summary,
};
use crate::widgets::hit::{Overlays, Telling, Watch};
use crate::widgets::{AnswerInput, Outcome, Scroll};

/// Back to choosing a round.
const CHOOSE: Next = Next::Replace(Place::Quiz { code: None });

/// A round of the quiz.
#[derive(Debug, Clone)]
pub(crate) struct Quiz {
    round: Round,
    /// What has been answered, in the order of the questions.
    answers: Vec<Answer>,
    phase: Phase,
    /// What the player likes to see drawn on top of a hit.
    layers: Overlays,
    scroll: Scroll,
    /// Whether Escape was pressed in the middle of the round, and nothing since.
    leaving: bool,
}

/// What one is doing in a round.
#[derive(Debug, Clone)]
enum Phase {
    /// Answering.
    Asked(Box<Asked>),
    /// Saying how sure one is.
    Confidence(Box<Asked>, Confidence),
    /// Watching what happens, if there is anything to be watched, and reading why.
    Watch(Box<Watched>),
    /// Looking back, with the mark at one question, counted from 0.
    Summary(usize),
}

/// A question, and what has been said to it so far.
#[derive(Debug, Clone)]
struct Asked {
    question: Question,
    input: AnswerInput,
}

/// A question and the answer to it.
#[derive(Debug, Clone)]
struct Watched {
    question: Question,
    answer: Answer,
    /// The hit, where the question is about one.
    telling: Telling,
    /// The right shot, still to be seen, where the player's own was not it.
    remedy: Option<Watch>,
    /// Its number, from 0, where it was opened from the look back.
    opened: Option<usize>,
}

impl Quiz {
    /// The round of a code, at its first question.
    pub(crate) fn new(code: Code) -> Self {
        Self::of(Round::of(code))
    }

    /// A round, at its first question.
    pub(crate) fn of(round: Round) -> Self {
        let mut quiz = Self {
            round,
            answers: Vec::new(),
            phase: Phase::Summary(0),
            layers: Overlays::default(),
            scroll: Scroll::default(),
            leaving: false,
        };
        quiz.ask();
        quiz
    }

    /// Asks the next question, or looks back after the last.
    fn ask(&mut self) {
        let phase = match self.round.questions().get(self.answers.len()) {
            Some(question) => Phase::Asked(Box::new(Asked {
                question: question.clone(),
                input: AnswerInput::new(&question.form),
            })),
            None => Phase::Summary(0),
        };
        self.enter(phase);
    }

    fn enter(&mut self, phase: Phase) {
        self.phase = phase;
        self.scroll = Scroll::default();
    }

    /// Whether every question has been answered.
    fn is_over(&self) -> bool {
        self.answers.len() >= self.round.questions().len()
    }

    /// Whether one looks back over the round, or at one of its questions from there.
    fn has_ended(&self) -> bool {
        match &self.phase {
            Phase::Summary(_) => true,
            Phase::Watch(watched) => watched.opened.is_some(),
            Phase::Asked(_) | Phase::Confidence(..) => false,
        }
    }

    /// Whether one hears only at the end what was right.
    fn tells_at_end(&self) -> bool {
        self.round.course().tells_at_end()
    }

    /// Takes the answer, if there is one, and shows what happens, or asks on.
    fn answer(&mut self, asked: &Asked, confidence: Confidence, cx: &mut Context) {
        let Some(said) = asked.input.said() else {
            return;
        };
        let answer = Answer::new(said, confidence);
        self.answers.push(answer);
        let attempt = Attempt::of_quiz(
            &cx.settings.player,
            self.round.code(),
            self.answers.len() as u32,
            &asked.question,
            &answer,
        );
        // It is safe before the explanation is seen.
        cx.record(attempt);
        if self.tells_at_end() {
            return self.ask();
        }
        let watched = Watched::new(asked.question.clone(), answer, self.layers, cx);
        self.enter(Phase::Watch(Box::new(watched)));
    }

    /// Opens an answered question from the look back, with all that is to be told of it.
    fn open(&mut self, at: usize, cx: &Context) {
        let (Some(question), Some(answer)) = (self.round.questions().get(at), self.answers.get(at))
        else {
            return;
        };
        let mut watched = Watched::new(question.clone(), *answer, self.layers, cx);
        watched.opened = Some(at);
        watched.telling.tell();
        self.enter(Phase::Watch(Box::new(watched)));
    }

    /// Goes back to the look back, to the question that was opened.
    fn close(&mut self, at: usize, cx: &Context) {
        self.enter(Phase::Summary(at));
        self.show_line(at, cx);
    }

    /// Moves the mark of the look back; at its ends the text goes on.
    fn move_mark(&mut self, at: usize, by: isize, cx: &Context) -> Next {
        let last = self.answers.len().saturating_sub(1);
        let to = at.saturating_add_signed(by).min(last);
        if to == at {
            return self.scroll_by(by.signum() as i16, cx);
        }
        self.phase = Phase::Summary(to);
        self.show_line(to, cx);
        Next::Stay
    }

    /// Scrolls a line of the look back into sight.
    fn show_line(&mut self, at: usize, cx: &Context) {
        let look = cx.settings.look();
        let text = view::text_area(self, cx.body, look);
        let row = view::first_line(self, at, text, look).saturating_add(at as u16);
        let mut scroll = self.scroll;
        scroll.show(row, text, look, |lines| view::write(self, lines, look));
        self.scroll = scroll;
    }

    /// Plays another round of the same kind. What is due is another matter after every
    /// review.
    fn again(&mut self, cx: &mut Context) -> Next {
        let code = self.round.code();
        if let CourseKind::Review(_) = code.course.kind {
            return CHOOSE;
        }
        let mut seed = cx.next_seed();
        if seed == code.seed {
            seed = cx.next_seed();
        }
        *self = Self::of(Round::new(code.course.clone(), seed));
        Next::Stay
    }

    /// Number of the question at hand, from 1.
    fn number(&self) -> usize {
        match &self.phase {
            Phase::Asked(_) | Phase::Confidence(..) => self.answers.len() + 1,
            Phase::Watch(watched) => watched.opened.map_or(self.answers.len(), |at| at + 1),
            Phase::Summary(_) => self.answers.len(),
        }
    }

    /// A look back over the answers whose outcome has been told.
    fn summary(&self) -> Summary {
        let untold = match &self.phase {
            Phase::Watch(watched) => {
                usize::from(!watched.telling.is_told() && watched.opened.is_none())
            }
            _ => 0,
        };
        let told = self.answers.len().saturating_sub(untold);
        Summary::new(self.round.questions().iter().zip(&self.answers).take(told))
    }

    fn key(&mut self, key: Key, leaving: bool, cx: &mut Context) -> Next {
        match key {
            Key::PageUp => return self.scroll_by(-8, cx),
            Key::PageDown => return self.scroll_by(8, cx),
            _ => {}
        }
        match &mut self.phase {
            Phase::Asked(asked) => match asked.input.update(key) {
                Outcome::Used => {}
                Outcome::Done(()) => {
                    let asked = asked.clone();
                    self.enter(Phase::Confidence(asked, Confidence::ThinkSo));
                }
                Outcome::Ignored if key == Key::Escape => return self.leave(leaving),
                Outcome::Ignored => return Next::Ignored,
            },
            Phase::Confidence(..) => return self.confidence_key(key, cx),
            Phase::Watch(_) => return self.watch_key(key, leaving, cx),
            Phase::Summary(at) => {
                let at = *at;
                match key {
                    Key::Up | Key::BackTab => return self.move_mark(at, -1, cx),
                    Key::Down | Key::Tab => return self.move_mark(at, 1, cx),
                    Key::Enter | Key::Char(' ') => self.open(at, cx),
                    Key::Char('n' | 'N') => return self.again(cx),
                    Key::Escape => return CHOOSE,
                    _ => return Next::Ignored,
                }
            }
        }
        Next::Stay
    }

    fn confidence_key(&mut self, key: Key, cx: &mut Context) -> Next {
        let Phase::Confidence(asked, chosen) = &mut self.phase else {
            return Next::Ignored;
        };
        match key {
            Key::Up | Key::Left | Key::BackTab => *chosen = beside(*chosen, -1),
            Key::Down | Key::Right | Key::Tab => *chosen = beside(*chosen, 1),
            Key::Char(digit @ '1'..='3') => {
                let (asked, sure) = (asked.clone(), usize::from(digit as u8 - b'1'));
                self.answer(&asked, Confidence::ALL[sure], cx);
            }
            Key::Enter | Key::Char(' ') => {
                let (asked, chosen) = (asked.clone(), *chosen);
                self.answer(&asked, chosen, cx);
            }
            Key::Escape => {
                let asked = asked.clone();
                self.enter(Phase::Asked(asked));
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn watch_key(&mut self, key: Key, leaving: bool, cx: &Context) -> Next {
        let Phase::Watch(watched) = &mut self.phase else {
            return Next::Ignored;
        };
        if watched.telling.update(key) {
            return Next::Stay;
        }
        let opened = watched.opened;
        match key {
            // Nobody skips what happened by a key too many.
            Key::Enter if !watched.telling.is_told() => watched.telling.tell(),
            Key::Enter if watched.remedy.is_some() => {
                watched
                    .remedy
                    .take()
                    .into_iter()
                    .for_each(|remedy| watched.telling.show(remedy));
            }
            Key::Enter | Key::Escape if opened.is_some() => {
                self.layers = watched.telling.layers().unwrap_or(self.layers);
                self.close(opened.unwrap_or(0), cx);
            }
            Key::Enter => {
                self.layers = watched.telling.layers().unwrap_or(self.layers);
                self.ask();
            }
            Key::Up => return self.scroll_by(-1, cx),
            Key::Down => return self.scroll_by(1, cx),
            Key::Escape => return self.leave(leaving),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    /// Leaves the round: at once while nothing has been answered, else when asked
    /// twice. Whoever leaves an exam has yet to hear of what was answered.
    fn leave(&mut self, asked_before: bool) -> Next {
        match asked_before {
            _ if self.answers.is_empty() => return CHOOSE,
            true if self.tells_at_end() => self.enter(Phase::Summary(0)),
            true => return CHOOSE,
            false => self.leaving = true,
        }
        Next::Stay
    }

    /// What leaving the round now means.
    fn parting(&self) -> String {
        let count = self.answers.len();
        let kept = match count {
            1 => "Your answer is kept.".to_owned(),
            _ => format!("Your {count} answers are kept."),
        };
        match self.tells_at_end() {
            true => format!("Esc again ends the exam and shows what you answered. {kept}"),
            false => format!("Esc again leaves the round. {kept}"),
        }
    }

    fn scroll_by(&mut self, rows: i16, cx: &Context) -> Next {
        let look = cx.settings.look();
        let area = view::text_area(self, cx.body, look);
        let mut scroll = self.scroll;
        scroll.by(rows, area, look, |lines| view::write(self, lines, look));
        self.scroll = scroll;
        Next::Stay
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let layout = view::layout(self, cx.body);
        let cell = (mouse.column, mouse.row);
        let on_picture = layout.picture.contains(cell.into());
        let pressed = mouse.kind == MouseKind::Down;
        let look = cx.settings.look();
        let text = view::text_area(self, cx.body, look);
        match (mouse.kind, &mut self.phase) {
            (MouseKind::ScrollUp | MouseKind::ScrollDown, Phase::Watch(watched)) if on_picture => {
                let later = mouse.kind == MouseKind::ScrollUp;
                watched
                    .telling
                    .update(Key::Char(if later { '.' } else { ',' }));
            }
            (MouseKind::ScrollUp, _) => return self.scroll_by(-1, cx),
            (MouseKind::ScrollDown, _) => return self.scroll_by(1, cx),
            (MouseKind::Down | MouseKind::Drag, Phase::Asked(asked)) if on_picture => {
                let Asked {
                    question, input, ..
                } = &mut **asked;
                if !input.point(question, layout.picture, cell, pressed) {
                    return Next::Ignored;
                }
            }
            (MouseKind::Down, Phase::Asked(asked)) => {
                let rows = self
                    .scroll
                    .rows(text, look, |lines| panel::asked(asked, lines));
                let Some(chosen) = panel::choice_at(asked, text, rows, cell, look) else {
                    return Next::Ignored;
                };
                asked.choose(chosen);
            }
            (MouseKind::Down, Phase::Confidence(asked, _)) => {
                let Some(chosen) = panel::confidence_at(text, cell) else {
                    return Next::Ignored;
                };
                let asked = asked.clone();
                self.answer(&asked, chosen, cx);
            }
            (MouseKind::Down, Phase::Summary(at)) => {
                let at = *at;
                let Some(line) = view::line_at(self, at, cx.body, look, cell) else {
                    return Next::Ignored;
                };
                self.open(line, cx);
            }
            (MouseKind::Down, Phase::Watch(_)) if on_picture => {
                return self.watch_key(Key::Char(' '), false, cx);
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }
}

impl Asked {
    /// Puts the mark at a choice.
    fn choose(&mut self, choice: usize) {
        if let AnswerInput::Choice { chosen, .. } = &mut self.input {
            *chosen = Some(choice);
        }
    }
}

impl Watched {
    /// An answer just given. What was answered by shooting is what is watched.
    fn new(question: Question, answer: Answer, layers: Overlays, cx: &Context) -> Self {
        let rays = match answer.said {
            Response::Rays(rays) => Some(rays),
            _ => None,
        };
        let reduced = cx.settings.reduced_motion;
        let watch = |collision: Collision| Watch::new(collision, rays, reduced).with_layers(layers);
        let (watch, remedy) = match (&question.form, answer.said) {
            (Form::Shot(aim), Response::Shot(offset)) => {
                let shot = |offset| watch(aim.with(offset)).with_wanted(aim.into());
                let right = Grade::new(&question, &answer).right;
                let remedy = (!right).then(|| shot(aim.offset));
                (Some(shot(offset)), remedy)
            }
            _ => (question.picture.collision().copied().map(watch), None),
        };
        Self {
            question,
            answer,
            telling: Telling::new(watch),
            remedy,
            opened: None,
        }
    }
}

/// The confidence so many steps above, no further than to the ends.
fn beside(confidence: Confidence, steps: isize) -> Confidence {
    let last = Confidence::ALL.len() - 1;
    let index = (confidence as usize).saturating_add_signed(steps).min(last);
    Confidence::ALL[index]
}

impl OldScreen for Quiz {
    fn title(&self) -> String {
        "quiz".into()
    }

    fn status(&self, _cx: &Context) -> String {
        let place = match self.phase {
            Phase::Summary(_) if self.is_over() => "all answered".into(),
            Phase::Summary(_) => format!(
                "{} of {} answered",
                self.answers.len(),
                self.round.questions().len()
            ),
            _ => format!(
                "question {} of {}",
                self.number(),
                self.round.questions().len()
            ),
        };
        let mut status = place;
        if !self.tells_at_end() || self.has_ended() {
            status += &format!("  {} points", numbers::points(self.summary().points()));
        }
        match &self.round.course().kind {
            CourseKind::Review(_) if self.is_over() => status + "  review",
            CourseKind::Review(due) => {
                let asked = self.round.questions().len();
                format!("{status}  review: {asked} of {} due", due.len())
            }
            _ => format!("{status}  code {}", self.round.code()),
        }
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        if let Input::Kept(_) = input {
            return Next::Stay;
        }
        let leaving = std::mem::take(&mut self.leaving);
        match input {
            Input::Key(key) => self.key(*key, leaving, cx),
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, passed: Duration, _cx: &mut Context) -> Next {
        if let Phase::Watch(watched) = &mut self.phase {
            watched.telling.advance(passed);
        }
        Next::Stay
    }

    fn wake(&self, _cx: &Context) -> Option<Duration> {
        match &self.phase {
            Phase::Watch(watched) => watched.telling.wake(),
            _ => None,
        }
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }

    fn keys(&self, _cx: &Context) -> Vec<Hint> {
        match &self.phase {
            _ if self.leaving => vec![
                Hint::new(
                    "Esc",
                    if self.tells_at_end() {
                        "end the exam"
                    } else {
                        "leave the round"
                    },
                ),
                Hint::new("any other key", "stay"),
            ],
            Phase::Asked(asked) => match &asked.input {
                AnswerInput::Rays(_) => vec![
                    Hint::new("arrows", "turn"),
                    Hint::new("0-9", "type"),
                    Hint::new("x", "stays still"),
                    Hint::new("Enter", "next"),
                    Hint::new("Tab", "other ray"),
                    Hint::new("Esc", "leave"),
                ],
                AnswerInput::Number(_) => vec![
                    Hint::new("0-9", "type"),
                    Hint::new("arrows", "dial"),
                    Hint::new("Enter", "next"),
                    Hint::new("Esc", "leave"),
                ],
                AnswerInput::Choice { .. } => vec![
                    Hint::new("Up Down", "choose"),
                    Hint::new("a b c", "likewise"),
                    Hint::new("Enter", "next"),
                    Hint::new("Esc", "leave"),
                ],
                AnswerInput::Shot(_) => vec![
                    Hint::new("arrows", "set the offset"),
                    Hint::new("0-9", "type"),
                    Hint::new("Enter", "next"),
                    Hint::new("Esc", "leave"),
                ],
            },
            Phase::Confidence(asked, _) => vec![
                Hint::new("1 2 3", "how sure"),
                Hint::new("Up Down", "choose"),
                Hint::new(
                    "Enter",
                    match asked.question.picture.collision() {
                        _ if self.tells_at_end() => "next",
                        Some(_) => "watch",
                        None => "see",
                    },
                ),
                Hint::new("Esc", "change it"),
            ],
            Phase::Watch(watched) if !watched.telling.is_told() => vec![
                Hint::new("Enter", "show it"),
                Hint::new("Space", "go on"),
                Hint::new(", .", "step"),
                Hint::new("< >", "scrub"),
                Hint::new("1-7", "layers"),
            ],
            Phase::Watch(watched) => {
                let next = if watched.remedy.is_some() {
                    "the right shot"
                } else if watched.opened.is_some() {
                    "back to the list"
                } else if !self.is_over() {
                    "next question"
                } else {
                    "look back"
                };
                let Some(watch) = watched.telling.watch() else {
                    let away = if watched.opened.is_some() {
                        "back"
                    } else {
                        "leave"
                    };
                    return vec![
                        Hint::new("Enter", next),
                        Hint::new("Up Down", "scroll"),
                        Hint::new("Esc", away),
                    ];
                };
                let space = if watch.clock().is_over() {
                    "again"
                } else {
                    "go on"
                };
                vec![
                    Hint::new("Enter", next),
                    Hint::new("Space", space),
                    Hint::new(", .", "step"),
                    Hint::new("< >", "scrub"),
                    Hint::new("1-7", "layers"),
                    Hint::new("f", "frame"),
                ]
            }
            Phase::Summary(_) => vec![
                Hint::new("Up Down", "choose"),
                Hint::new("Enter", "look at it"),
                Hint::new("n", "another round"),
                Hint::new("Esc", "other rounds"),
            ],
        }
    }

    fn help(&self, _cx: &Context) -> Help {
        Help {
            text: vec![
                "Answer each question, say how sure you are, then watch what happens and read why. In an exam you hear nothing until the end. Rims are smooth unless a question says otherwise.",
                "Rays: angles count from the striker's direction before: for the striker to the side away from the coin, for the coin to its own side. A minus turns to the other side. A shot: set the offset that sends the disc along the dashed way to the mark.",
                "A ray is right within 4°, and so is a shot that sends its disc that near the way. Of numbers an angle, a share or e is right within a tenth of the truth, but never further off than 4°, 4 % or 0.04; any other within a twentieth.",
                "A ray within 2° earns all its credit, one that is 30° off none. \"Sure\" brings most points if you are right and costs most if you are not, so the honest answer is the one that pays. The sum may fall below nothing: else a wrong \"sure\" would cost nothing there.",
                "After the last question each one can be opened again; an exam that is left shows what was answered. The code at the top fixes the questions: with the same code a friend gets the same round.",
            ],
            keys: vec![
                Hint::new("Left Right", "turn a ray by 1°, or dial a number"),
                Hint::new(
                    "Up Down",
                    "turn a ray by 5°, dial in big steps, choose, or scroll",
                ),
                Hint::new("0-9 . -", "type an angle, a number or an offset"),
                Hint::new("a b c", "choose an answer"),
                Hint::new("x", "this disc will stay still"),
                Hint::new("Tab", "the other ray"),
                Hint::new("Enter", "go on"),
                Hint::new("1 2 3", "guess, think so, sure"),
                Hint::new("Space", "go on from the contact, or play it again"),
                Hint::new(", .", "step through the hit"),
                Hint::new("< >", "bigger steps; Home and End for the ends"),
                Hint::new("a", "play it again"),
                Hint::new("f", "see it from the centre of mass"),
                Hint::new(
                    "1-7",
                    "layers: line of impact, split, velocities, angles, triangle, trails, what you said",
                ),
                Hint::new(
                    "PageUp PageDown",
                    "scroll a text that is longer than its place",
                ),
                Hint::new(
                    "mouse",
                    "drag the rays, or the coin before a shot; click an answer, how sure you are, a line of the look back",
                ),
            ],
        }
    }
}

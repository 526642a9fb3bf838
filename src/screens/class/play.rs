//! A round being played: where it is, and the way through it.

use std::time::Duration;

use super::booth::{Booths, Polled};
use super::shown::Shown;
use crate::class::{ClassPlace, ClassRound, ClassStep, Vote};
use crate::messages::{Key, StoreAnswer, StoreReply, StoreRequest};
use crate::quiz::Question;
use crate::screens::Context;
use crate::widgets::Scroll;

/// A round being played.
#[derive(Debug, Clone)]
pub(super) struct Play {
    pub(super) round: ClassRound,
    pub(super) phase: Phase,
    pub(super) scroll: Scroll,
    /// Whether the words of the question have the screen to themselves.
    pub(super) words_alone: bool,
    /// The step at which each question stands.
    steps: Vec<ClassStep>,
    /// The last question that has been reached.
    furthest: usize,
    /// The ticket with which it is kept.
    ticket: u64,
    /// Whether it could not be saved as it stands: what is left now is lost.
    pub(super) unsaved: bool,
}

/// What there is to do at a step, where that is more than to look and go on.
#[derive(Debug, Clone)]
pub(super) enum Phase {
    Look,
    Vote(Booths),
    Shot(Box<Shown>),
    End(Page),
}

/// A page after the last question.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Page {
    /// The scoreboard.
    Board,
    /// What the class believed.
    Held,
    /// What each question showed.
    Items,
}

impl Page {
    pub(super) const ALL: [Self; 3] = [Self::Board, Self::Held, Self::Items];
}

impl Play {
    /// A round from its start.
    pub(super) fn new(round: ClassRound, cx: &mut Context) -> Self {
        let ticket = cx.ticket();
        Self::with_ticket(round, ticket, cx)
    }

    /// A round that was kept, where it was left.
    pub(super) fn with_ticket(round: ClassRound, ticket: u64, cx: &Context) -> Self {
        let place = round.place();
        let furthest = place.question.max(round.begun().saturating_sub(1));
        let steps = (0..round.questions().len()).map(|question| match question {
            question if question == place.question => place.step,
            question if question <= furthest => ClassStep::Scores,
            _ => ClassStep::Describe,
        });
        let mut play = Self {
            steps: steps.collect(),
            round,
            phase: Phase::Look,
            scroll: Scroll::default(),
            words_alone: false,
            furthest,
            ticket,
            unsaved: false,
        };
        play.arrive(cx);
        play
    }

    /// The question at hand.
    pub(super) fn question(&self) -> Option<&Question> {
        self.round.questions().get(self.number())
    }

    /// Its number, from 0.
    pub(super) fn number(&self) -> usize {
        self.round.place().question
    }

    /// The step at hand.
    pub(super) fn step(&self) -> ClassStep {
        self.round.place().step
    }

    /// Whether the last question is behind.
    pub(super) fn is_over(&self) -> bool {
        matches!(self.phase, Phase::End(_))
    }

    /// Whether leaving now would end something: a round in its midst, or one that is not
    /// kept.
    pub(super) fn asks_before_leaving(&self) -> bool {
        self.round.is_begun() && (self.unsaved || !self.is_over())
    }

    /// How many questions have their points: those before this one, and this one once
    /// the truth is told.
    pub(super) fn asked(&self) -> usize {
        match self.step() {
            ClassStep::Scores => self.number() + 1,
            _ => self.number(),
        }
    }

    /// Begins what there is to do at the place at hand.
    fn arrive(&mut self, cx: &Context) {
        let ClassPlace { question, step } = self.round.place();
        self.furthest = self.furthest.max(question);
        if let Some(kept) = self.steps.get_mut(question) {
            *kept = step;
        }
        self.phase = match step {
            ClassStep::FirstVote => Phase::Vote(Booths::new(&self.round, question, Vote::First)),
            ClassStep::SecondVote => Phase::Vote(Booths::new(&self.round, question, Vote::Second)),
            ClassStep::Shot => {
                match Shown::new(&self.round, question, cx.settings.reduced_motion) {
                    Some(shown) => Phase::Shot(Box::new(shown)),
                    None => Phase::Look,
                }
            }
            _ => Phase::Look,
        };
        self.scroll = Scroll::default();
        self.words_alone = false;
    }

    fn go(&mut self, question: usize, step: ClassStep, cx: &mut Context) {
        self.round.go(ClassPlace { question, step });
        self.arrive(cx);
        self.save(cx);
    }

    /// To what comes next.
    pub(super) fn forward(&mut self, cx: &mut Context) {
        let question = self.number();
        if let Phase::End(page) = self.phase {
            self.turn_page(page, 1);
        } else if let Some(next) = self.step().next() {
            self.go(question, next, cx);
        } else if let Some(step) = self.steps.get(question + 1) {
            self.go(question + 1, *step, cx);
        } else {
            self.phase = Phase::End(Page::Board);
            self.scroll = Scroll::default();
        }
    }

    /// To what came before.
    fn back(&mut self, cx: &mut Context) {
        let question = self.number();
        match self.phase {
            Phase::End(Page::Board) => self.go(question, ClassStep::Scores, cx),
            Phase::End(page) => self.turn_page(page, -1),
            _ => match (self.step().before(), question.checked_sub(1)) {
                (Some(before), _) => self.go(question, before, cx),
                (None, Some(question)) => self.go(question, ClassStep::Scores, cx),
                (None, None) => {}
            },
        }
    }

    /// To the question so many further, where it was left; never to one that has not
    /// been reached yet.
    fn leap(&mut self, by: isize, cx: &mut Context) {
        let from = match self.phase {
            Phase::End(_) => self.number() + 1,
            _ => self.number(),
        };
        let to = from.checked_add_signed(by);
        if let Some(to) = to.filter(|to| *to <= self.furthest)
            && let Some(step) = self.steps.get(to).copied()
        {
            self.go(to, step, cx);
        }
    }

    pub(super) fn turn_page(&mut self, page: Page, by: isize) {
        let at = Page::ALL.iter().position(|it| *it == page).unwrap_or(0);
        let to = at.saturating_add_signed(by).min(Page::ALL.len() - 1);
        self.phase = Phase::End(Page::ALL[to]);
        self.scroll = Scroll::default();
    }

    /// Has it kept as it stands, once there is a vote in it.
    fn save(&self, cx: &mut Context) {
        if self.round.is_begun() {
            cx.keep(
                self.ticket,
                StoreRequest::SaveClass(Box::new(self.round.clone())),
            );
        }
    }

    /// Takes in what came of saving and exporting.
    pub(super) fn take_answer(&mut self, answer: &StoreAnswer, cx: &mut Context) {
        match &answer.done {
            StoreReply::Saved(saved) if answer.ticket == self.ticket => {
                if let Err(reason) = saved
                    && !self.unsaved
                {
                    cx.tell(format!(
                        "This round cannot be saved: {reason}. You can play on, but it would be lost when you leave. e writes its tables."
                    ));
                }
                self.unsaved = saved.is_err();
            }
            StoreReply::Exported(Ok(place)) => {
                cx.tell(format!("Both tables are written: {place}"));
            }
            StoreReply::Exported(Err(reason)) => {
                cx.tell(format!("The tables cannot be written: {reason}."));
            }
            _ => {}
        }
    }

    /// Takes a key; says whether it was one of the round's.
    pub(super) fn key(&mut self, key: Key, cx: &mut Context) -> bool {
        match &mut self.phase {
            Phase::Vote(booths) => match booths.key(key, &mut self.round) {
                Polled::Stay => return true,
                Polled::Voted => {
                    self.save(cx);
                    return true;
                }
                Polled::GoOn => {
                    self.forward(cx);
                    return true;
                }
                Polled::Ignored if booths.input.is_some() => return false,
                Polled::Ignored => {}
            },
            Phase::Shot(shown) => {
                if shown.telling.update(key) {
                    return true;
                }
                if key == Key::Enter && !shown.telling.is_told() {
                    // Nobody skips what happened by a key too many.
                    shown.telling.tell();
                    return true;
                }
            }
            Phase::End(page) => match key {
                Key::Left => {
                    let page = *page;
                    self.turn_page(page, -1);
                    return true;
                }
                Key::Right => {
                    let page = *page;
                    self.turn_page(page, 1);
                    return true;
                }
                _ => {}
            },
            Phase::Look => {}
        }
        match key {
            Key::Enter | Key::Char(' ') => self.forward(cx),
            Key::Backspace => self.back(cx),
            Key::Char('[') => self.leap(-1, cx),
            Key::Char(']') => self.leap(1, cx),
            Key::Char('z' | 'Z') => self.words_alone = !self.words_alone,
            Key::Char('e' | 'E') => {
                cx.ask(StoreRequest::ExportClass(Box::new(self.round.clone())));
            }
            _ => return false,
        }
        true
    }

    /// Lets time pass.
    pub(super) fn advance(&mut self, passed: Duration) {
        if let Phase::Shot(shown) = &mut self.phase {
            shown.telling.advance(passed);
        }
    }

    /// When it next needs time.
    pub(super) fn wake(&self) -> Option<Duration> {
        match &self.phase {
            Phase::Shot(shown) => shown.telling.wake(),
            _ => None,
        }
    }
}

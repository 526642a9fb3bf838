//! A round in progress, and the navigation through its steps.

use std::collections::BTreeMap;
use std::time::Duration;

use ratatui::layout::Rect;

use super::ending::{EndAction, EndPage};
use super::hosting::{self, HostPage, HostingAction};
use super::shot::{self, ClassReveal};
use super::stage::Stage;
use super::tally::{self, Tally};
use super::vote::{TeamVotes, VoteAction};
use super::{ClassAction, RoundAction, question, scores, talk};
use crate::class::{
    ClassPlace, ClassRound, ClassStep, HandInOnItsWay, Session, SessionEffect, Vote, WayOfVoting,
};
use crate::messages::{
    FileContent, HostNews, Key, Mouse, MouseKind, StoreAnswer, StoreReply, StoreRequest,
};
use crate::quiz::Question;
use crate::screens::{Confirmation, Context, Next, View};
use crate::widgets::hit::HitPace;
use crate::widgets::input::{KeyTable, ListAction};
use crate::widgets::panel::{Beside, Panel};
use crate::widgets::panels::Heading;
use crate::widgets::{SplitLayout, draw_question};

/// A round that is being played.
#[derive(Debug, Clone)]
pub(super) struct ClassPlay {
    pub(super) stage: Stage,
    phase: ClassPhase,
    /// The step of each question: the current one, or the one at which the question was left.
    steps: Vec<ClassStep>,
    /// The last question that has been reached, or the number of questions if the end has been
    /// reached.
    furthest: usize,
    /// The ticket for saving the round.
    ticket: u64,
    /// Whether saving failed: leaving now would lose the round.
    pub(super) unsaved: bool,
    /// Hand-ins that are being saved, by their tickets.
    hand_ins: BTreeMap<u64, HandInOnItsWay>,
    /// The open page about pupils on devices.
    pub(super) host_page: Option<HostPage>,
}

/// What the class can do at the current step.
#[derive(Debug, Clone)]
enum ClassPhase {
    /// The class can only continue.
    Look,
    Vote(TeamVotes),
    Tally(Tally),
    Shot(Box<ClassReveal>),
    End(EndPage),
}

impl ClassPlay {
    /// A round, at the step where it was left; it is saved with this ticket.
    pub(super) fn new(round: ClassRound, ticket: u64, cx: &mut Context) -> Self {
        let place = round.place();
        let furthest = place.question.max(round.begun().saturating_sub(1));
        let steps = (0..round.questions().len()).map(|question| match question {
            question if question == place.question => place.step,
            question if question <= furthest => ClassStep::Scores,
            _ => ClassStep::Describe,
        });
        let steps = steps.collect();
        let session = Session::new(round);
        let mut play = Self {
            hand_ins: BTreeMap::new(),
            host_page: session.gathers().then_some(HostPage::Joining),
            steps,
            stage: Stage {
                session,
                countdown: None,
                words_alone: false,
                names_shown: false,
            },
            phase: ClassPhase::Look,
            furthest,
            ticket,
            unsaved: false,
        };
        play.arrive(cx);
        play.flush(cx);
        play
    }

    /// Whether the last question is over.
    pub(super) fn is_over(&self) -> bool {
        matches!(self.phase, ClassPhase::End(_))
    }

    /// Whether leaving now would interrupt a round, or lose one that is not saved.
    pub(super) fn asks_before_leaving(&self) -> bool {
        self.stage.round().is_begun() && (self.unsaved || !self.is_over())
    }

    /// Sets up the phase of the current step.
    fn arrive(&mut self, cx: &Context) {
        let ClassPlace { question, step } = self.stage.round().place();
        self.furthest = self.furthest.max(question);
        if let Some(kept) = self.steps.get_mut(question) {
            *kept = step;
        }
        let vote = |vote| match self.stage.round().way() {
            WayOfVoting::Teams => {
                ClassPhase::Vote(TeamVotes::new(self.stage.round(), question, vote))
            }
            WayOfVoting::Tally => ClassPhase::Tally(Tally::new(self.stage.round(), question, vote)),
            WayOfVoting::Devices => ClassPhase::Look,
        };
        self.phase = match step {
            ClassStep::FirstVote => vote(Vote::First),
            ClassStep::SecondVote => vote(Vote::Second),
            ClassStep::Shot => {
                let shown = ClassReveal::new(self.stage.round(), question, cx.settings.pace());
                shown.map_or(ClassPhase::Look, |it| ClassPhase::Shot(Box::new(it)))
            }
            _ => ClassPhase::Look,
        };
        self.stage.countdown = None;
        self.stage.words_alone = false;
    }

    fn go(&mut self, question: usize, step: ClassStep, cx: &mut Context) {
        self.stage.session.go(ClassPlace { question, step });
        self.arrive(cx);
        self.flush(cx);
    }

    /// Passes on the requests that the session has made.
    fn flush(&mut self, cx: &mut Context) {
        for effect in self.stage.session.take_effects() {
            match effect {
                SessionEffect::Host(call) => cx.host(call),
                SessionEffect::Save(round) => {
                    cx.keep(self.ticket, StoreRequest::Save(FileContent::Class(round)));
                }
                SessionEffect::Note(changes, round) => {
                    cx.keep(self.ticket, StoreRequest::NoteClass { changes, round });
                }
                SessionEffect::KeepHandIn(on_its_way, file) => {
                    let ticket = cx.ask(StoreRequest::KeepHandIn(file));
                    self.hand_ins.insert(ticket, on_its_way);
                }
                SessionEffect::Tell(words) => cx.notify(words),
            }
        }
        if let Some(page) = &mut self.host_page {
            page.renew(&self.stage.session);
        }
    }

    /// Handles messages from pupils on devices.
    pub(super) fn take_news(&mut self, news: &[HostNews], cx: &mut Context) {
        self.stage.session.take_news(news);
        self.flush(cx);
    }

    /// Carries out an action that concerns pupils on devices.
    pub(super) fn host(&mut self, action: HostingAction, cx: &mut Context) {
        let page = self.host_page.take();
        self.host_page = HostPage::act(page, action, &mut self.stage.session);
        self.flush(cx);
    }

    /// Disconnects pupils on devices.
    pub(super) fn leave(&mut self, cx: &mut Context) {
        self.stage.session.close();
        self.flush(cx);
    }

    /// The next or the previous step of the question, depending on `beside`; on devices, predicting
    /// and voting are one step.
    fn step_beside(&self, beside: impl Fn(ClassStep) -> Option<ClassStep>) -> Option<ClassStep> {
        let skips = self.stage.round().way() == WayOfVoting::Devices;
        match beside(self.stage.step())? {
            ClassStep::Predict if skips => beside(ClassStep::Predict),
            step => Some(step),
        }
    }

    /// Goes to the next step or page.
    fn forward(&mut self, cx: &mut Context) {
        let question = self.stage.number();
        if let ClassPhase::End(page) = &mut self.phase {
            *page = page.turned(1);
        } else if let Some(next) = self.step_beside(ClassStep::next) {
            self.go(question, next, cx);
        } else if let Some(step) = self.steps.get(question + 1) {
            self.go(question + 1, *step, cx);
        } else {
            self.end(cx);
        }
    }

    /// Goes to the previous step or page.
    fn back(&mut self, cx: &mut Context) {
        let question = self.stage.number();
        match &mut self.phase {
            ClassPhase::End(EndPage::Board) => self.go(question, ClassStep::Scores, cx),
            ClassPhase::End(page) => *page = page.turned(-1),
            _ => match (self.step_beside(ClassStep::before), question.checked_sub(1)) {
                (Some(before), _) => self.go(question, before, cx),
                (None, Some(question)) => self.go(question, ClassStep::Scores, cx),
                (None, None) => {}
            },
        }
    }

    /// The index of the question `by` questions after the current one; the end of the round comes
    /// after the last question. `None` if there is no such position or it has not been reached yet.
    fn leads_to(&self, by: isize) -> Option<usize> {
        let from = self.stage.number() + usize::from(self.is_over());
        let to = from.checked_add_signed(by)?;
        (to <= self.furthest).then_some(to)
    }

    /// Goes to the question `by` questions after the current one, at the step where it was left.
    fn leap(&mut self, by: isize, cx: &mut Context) {
        match self.leads_to(by).map(|to| (to, self.steps.get(to))) {
            Some((question, Some(step))) => self.go(question, *step, cx),
            Some((_, None)) => self.end(cx),
            None => {}
        }
    }

    fn end(&mut self, cx: &mut Context) {
        self.furthest = self.steps.len();
        self.phase = ClassPhase::End(EndPage::Board);
        self.stage.session.end();
        self.flush(cx);
    }

    /// Handles the results of saving and exporting.
    pub(super) fn take_answer(&mut self, answer: &StoreAnswer, cx: &mut Context) {
        match &answer.done {
            StoreReply::Saved(saved) if answer.ticket == self.ticket => {
                if let Err(reason) = saved
                    && !self.unsaved
                {
                    cx.notify(format!(
                        "This round cannot be saved: {reason}. You can continue, but it will be lost when you leave. The e key writes its tables."
                    ));
                }
                self.unsaved = saved.is_err();
                self.stage.session.saved();
                self.flush(cx);
            }
            StoreReply::HandedIn(folder) => {
                if let Some(on_its_way) = self.hand_ins.remove(&answer.ticket) {
                    self.stage.session.keeps_hand_in(on_its_way, folder);
                    self.flush(cx);
                }
            }
            StoreReply::Exported(exported) => cx.notify(match exported {
                Ok(place) => format!("The tables and the report have been written: {place}"),
                Err(reason) => format!("The tables cannot be written: {reason}."),
            }),
            _ => {}
        }
    }

    /// The keys of the current step.
    pub(super) fn keys(&self) -> KeyTable<ClassAction> {
        use RoundAction::{
            Backward, BoardNames, Countdown, Leap, Leave, Light, Pause, Tables, WordsAlone,
        };
        let keys = KeyTable::new("class");
        let table = KeyTable::new("class");
        if let Some(page) = &self.host_page {
            let page = page.keys(&self.stage.session);
            let free = page.exact(Key::Escape).is_none();
            let keys = keys.on(Key::Escape, Leave, "leave").when(free);
            return table
                .with(page, ClassAction::Hosting)
                .with(keys.on('l', Light, "dark or light"), ClassAction::Round);
        }
        let table = match &self.phase {
            ClassPhase::Vote(votes) => {
                let table = table.with(votes.keys(self.stage.round()), ClassAction::Vote);
                if votes.is_in_booth() {
                    let keys = keys.on('p', Pause, "pause").on('l', Light, "dark or light");
                    return table.with(keys, ClassAction::Round);
                }
                table
            }
            ClassPhase::Tally(_) => table.with(tally::keys(), ClassAction::Count),
            ClassPhase::Shot(shown) => {
                // The replay uses the space bar and, until its explanation is complete, Enter.
                let on = forward("the scores").when(!shown.reveal.is_explaining());
                let on = match shown.reveal.watch() {
                    Some(_) => on.without_keys(&[Key::Char(' ')]),
                    None => on,
                };
                let table = table.with(on, ClassAction::Round);
                table.with(shown.reveal.keys(), ClassAction::Watch)
            }
            ClassPhase::End(page) => {
                let on = forward("next page").when(*page != EndPage::Items);
                let table = table.with(on, ClassAction::Round);
                table.with(EndPage::keys(), ClassAction::End)
            }
            ClassPhase::Look => table.with(self.keys_to_look(), ClassAction::Round),
        };
        let step = self.stage.step();
        let reads = matches!(self.phase, ClassPhase::Look)
            && !matches!(step, ClassStep::Talk | ClassStep::Scores);
        let is_board = match &self.phase {
            ClassPhase::End(page) => *page == EndPage::Board,
            _ => step == ClassStep::Scores,
        };
        let words_alone = keys.on('z', WordsAlone, "text only").when(reads);
        let mut table = table.with(words_alone, ClassAction::Round);
        let is_hosted = self.stage.session.is_hosted();
        if is_hosted {
            table = table.with(hosting::step_keys(), ClassAction::Hosting);
        }
        let names = match self.stage.names_shown {
            true => "no names",
            false => "names",
        };
        let keys = KeyTable::new("class")
            .on('n', BoardNames, names)
            .when(is_hosted && is_board)
            .on('e', Tables, if self.is_over() { "tables" } else { "" })
            .on(Key::Backspace, Backward, "back")
            .on('p', Pause, "pause")
            .on('c', Countdown, "")
            .on('l', Light, "dark or light")
            .by(['[', ']'], Leap, [-1, 1], "questions")
            .when([-1, 1].iter().any(|by| self.leads_to(*by).is_some()))
            .on(Key::Escape, Leave, "leave");
        table.with(keys, ClassAction::Round)
    }

    /// The keys that continue from a step without actions of its own.
    fn keys_to_look(&self) -> KeyTable<RoundAction> {
        let is_last = self.stage.number() + 1 == self.stage.round().questions().len();
        let keys = forward(match self.stage.step() {
            ClassStep::Describe if self.stage.session.is_hosted() => "the vote",
            ClassStep::Describe => "predict",
            ClassStep::Predict => "first vote",
            ClassStep::FirstVote => "talk",
            ClassStep::Talk => "second vote",
            ClassStep::SecondVote => "the shot",
            ClassStep::Scores if is_last => "the end",
            ClassStep::Scores => "next question",
            ClassStep::Shot => "go on",
        });
        keys.on('g', RoundAction::ToTheShot, "the shot")
            .when(self.stage.step() == ClassStep::Talk)
    }

    /// Carries out the action of a key or a click.
    pub(super) fn act(&mut self, action: ClassAction, cx: &mut Context) -> Next {
        match (action, &mut self.phase) {
            (ClassAction::Round(action), _) => self.act_at_any_step(action, cx),
            (ClassAction::Hosting(action), _) => {
                let page = self.host_page.as_mut();
                if let Some(words) =
                    page.and_then(|it| it.confirmation(action, &self.stage.session))
                {
                    return Next::Confirm(Confirmation::new(words, "yes", "no"));
                }
                self.host(action, cx);
            }
            (ClassAction::Watch(action), ClassPhase::Shot(shown)) => shown.reveal.act(action),
            (ClassAction::Vote(action), ClassPhase::Vote(votes)) => {
                if votes.act(action, &mut self.stage.session) {
                    self.forward(cx);
                }
            }
            (ClassAction::Count(_), ClassPhase::Tally(tally)) => {
                if tally.give(&mut self.stage.session) {
                    self.forward(cx);
                }
            }
            (ClassAction::End(action), ClassPhase::End(page)) => {
                let EndAction::TurnPage(by) = action;
                *page = page.turned(by);
            }
            _ => return Next::Ignored,
        }
        self.flush(cx);
        Next::Stay
    }

    fn act_at_any_step(&mut self, action: RoundAction, cx: &mut Context) {
        match action {
            RoundAction::Forward => self.forward(cx),
            RoundAction::Backward => self.back(cx),
            RoundAction::Leap(by) => self.leap(by, cx),
            RoundAction::ToTheShot => self.go(self.stage.number(), ClassStep::Shot, cx),
            RoundAction::Countdown => {
                self.stage.countdown = Some(match self.stage.countdown {
                    Some(left) if !left.is_zero() => left + Duration::from_secs(30),
                    _ => Duration::from_secs(60),
                });
            }
            RoundAction::WordsAlone => self.stage.words_alone = !self.stage.words_alone,
            RoundAction::BoardNames => self.stage.names_shown = !self.stage.names_shown,
            RoundAction::Tables => {
                cx.ask(StoreRequest::Export(FileContent::Class(
                    self.stage.session.shared_round(),
                )));
            }
            // The screen itself handles these actions.
            RoundAction::Pause | RoundAction::Light | RoundAction::Leave => {}
        }
    }

    /// The action of the mouse wheel: it chooses a team or a participant, or turns the page.
    pub(super) fn wheel(&self, by: i8) -> Option<ClassAction> {
        let by = ListAction::Choose(by.into());
        match (&self.host_page, &self.phase) {
            (Some(_), _) => Some(ClassAction::Hosting(HostingAction::List(by))),
            (None, ClassPhase::Vote(votes)) if !votes.is_in_booth() => {
                Some(ClassAction::Vote(VoteAction::Teams(by)))
            }
            _ => None,
        }
    }

    /// The view of the current step.
    pub(super) fn view<'s>(&'s self, cx: &'s Context) -> View<'s, ClassAction> {
        if let Some(page) = &self.host_page {
            return page.view(&self.stage.session, cx);
        }
        let Some(question) = self.stage.question() else {
            return View::alone(SplitLayout::text_alone, Panel::new(""));
        };
        match (&self.phase, self.stage.step()) {
            (ClassPhase::Vote(votes), _) => votes.view(&self.stage, question),
            (ClassPhase::Tally(tally), _) => tally.view(&self.stage, question),
            (ClassPhase::Shot(shown), _) => shot::view(&self.stage, shown, question),
            (ClassPhase::End(page), _) => page.view(&self.stage),
            (ClassPhase::Look, ClassStep::Talk) => talk::view(&self.stage, question),
            (ClassPhase::Look, ClassStep::Scores) => {
                scores::view(&self.stage, Heading::new(&["Scores"], ""))
            }
            (ClassPhase::Look, step) => self.reading(step, question),
        }
    }

    /// The question while it is read out or predicted; on devices, also while pupils vote.
    fn reading<'s>(&'s self, step: ClassStep, question: &'s Question) -> View<'s, ClassAction> {
        let turnout = |vote| self.stage.session.turnout(vote);
        let heading = match step {
            ClassStep::FirstVote => Heading::new(
                &[&turnout(Vote::First)],
                "Everyone predicts in silence, and votes on their own device.",
            ),
            ClassStep::SecondVote => Heading::new(
                &[&turnout(Vote::Second)],
                "You may change your vote. Otherwise your first vote counts.",
            ),
            ClassStep::Predict => Heading::new(
                &["Predict in silence", "In silence"],
                "Everyone writes down an answer. Nobody speaks.",
            ),
            _ => Heading::new(&[&format!("Question {}", self.stage.number() + 1)], ""),
        };
        let heading = (!self.stage.words_alone || step.vote().is_some()).then_some(heading);
        let beside = match self.stage.words_alone {
            true => Beside::Nothing,
            false => question::beside(question),
        };
        let mut words = self.stage.words();
        question::write(&self.stage, question, None, |_| None, &mut words);
        let draw = move |area, buf: &mut _, look: &_| {
            draw_question(area, buf, look, question, None);
        };
        self.stage.step_view(heading, beside, draw, words)
    }

    /// Handles a key that edits text; returns whether the key was used.
    pub(super) fn typed(&mut self, key: Key) -> bool {
        let page = self.host_page.as_mut();
        match &mut self.phase {
            ClassPhase::Tally(entry) => entry.typed(key),
            _ => page.is_some_and(|page| page.typed(key)),
        }
    }

    /// Handles the mouse over the picture of a step; returns whether the mouse was used.
    pub(super) fn point(&mut self, mouse: &Mouse, picture: Rect) -> bool {
        let pressed = mouse.kind == MouseKind::Down;
        match (&mut self.phase, self.stage.question()) {
            (ClassPhase::Vote(votes), Some(question)) if mouse.is_held() => {
                let input = votes.input_mut();
                input.is_some_and(|input| input.point(question, picture, mouse.place(), pressed))
            }
            _ => false,
        }
    }

    pub(super) fn advance(&mut self, passed: Duration, pace: HitPace) {
        self.stage.session.advance(passed);
        self.stage.countdown = self.stage.countdown.map(|left| left.saturating_sub(passed));
        if let ClassPhase::Shot(shown) = &mut self.phase {
            shown.reveal.advance(passed, pace);
        }
    }

    /// The time until the round must next be advanced.
    pub(super) fn wake(&self, pace: HitPace) -> Option<Duration> {
        let shot = match &self.phase {
            ClassPhase::Shot(shown) => shown.reveal.wake(pace),
            _ => None,
        };
        // The time until the countdown shows the next second.
        let left = self.stage.countdown.filter(|left| !left.is_zero());
        let second = left.map(|left| match left.subsec_nanos() {
            0 => Duration::from_secs(1),
            nanos => Duration::from_nanos(nanos.into()),
        });
        let session = self.stage.session.wake();
        shot.into_iter().chain(second).chain(session).min()
    }
}

/// The keys that continue.
fn forward(name: &'static str) -> KeyTable<RoundAction> {
    KeyTable::new("class")
        .on(Key::Enter, RoundAction::Forward, name)
        .or([(' ', RoundAction::Forward)])
}

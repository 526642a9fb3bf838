//! A round being played: where it is, and the way through it.

use std::collections::BTreeMap;
use std::time::Duration;

use ratatui::layout::Rect;

use super::ClassAction;
use super::hosting::{self, HostPage, HostingAction};
use super::shown::ClassReveal;
use super::tally_entry::TallyEntry;
use super::vote_entry::VoteEntry;
use crate::class::{
    ClassPlace, ClassRound, ClassStep, HandInOnItsWay, Session, SessionEffect, Vote, WayOfVoting,
};
use crate::messages::{HostNews, Key, Mouse, MouseKind, StoreAnswer, StoreReply, StoreRequest};
use crate::quiz::Question;
use crate::screens::Context;
use crate::widgets::hit::HitPace;
use crate::widgets::input::{KeyTable, ListView};
use crate::widgets::{AnswerAction, Outcome, Scroll};

/// A round being played.
#[derive(Debug, Clone)]
pub(super) struct ClassPlay {
    pub(super) session: Session,
    pub(super) phase: ClassPhase,
    pub(super) scroll: Scroll,
    /// The page of the words of a step, from 0.
    pub(super) page: usize,
    /// The time that is left of a countdown, where one is shown.
    pub(super) countdown: Option<Duration>,
    /// Whether the words of the question have the screen to themselves.
    pub(super) words_alone: bool,
    /// Whether the names of pupils on devices may stand on the scoreboard.
    pub(super) names_shown: bool,
    /// The step at which each question stands.
    steps: Vec<ClassStep>,
    /// The last question that has been reached; their number if the end was.
    furthest: usize,
    /// The ticket with which it is kept.
    ticket: u64,
    /// Whether it could not be saved as it stands: what is left now is lost.
    pub(super) unsaved: bool,
    /// What was handed in and is on its way to the disk, by its ticket.
    hand_ins: BTreeMap<u64, HandInOnItsWay>,
    /// The page about pupils on devices that is open.
    pub(super) host_page: Option<HostPage>,
}

/// What there is to do at a step, where that is more than to look and go on.
#[derive(Debug, Clone)]
pub(super) enum ClassPhase {
    Look,
    Vote(VoteEntry),
    Tally(TallyEntry),
    Shot(Box<ClassReveal>),
    End(EndPage),
}

/// A page after the last question.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum EndPage {
    /// The scoreboard.
    Board,
    /// What the class believed.
    Held,
    /// What each question showed.
    Items,
}

impl EndPage {
    pub(super) const ALL: [Self; 3] = [Self::Board, Self::Held, Self::Items];
}

impl ClassPlay {
    /// A round from its start.
    pub(super) fn new(round: ClassRound, cx: &mut Context) -> Self {
        let ticket = cx.ticket();
        Self::with_ticket(round, ticket, cx)
    }

    /// A round that was kept, where it was left.
    pub(super) fn with_ticket(round: ClassRound, ticket: u64, cx: &mut Context) -> Self {
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
            host_page: session.gathers().then_some(HostPage::Door),
            steps,
            session,
            phase: ClassPhase::Look,
            scroll: Scroll::default(),
            page: 0,
            countdown: None,
            words_alone: false,
            names_shown: false,
            furthest,
            ticket,
            unsaved: false,
        };
        play.arrive(cx);
        play.flush(cx);
        play
    }

    /// The round as it stands.
    pub(super) fn round(&self) -> &ClassRound {
        self.session.round()
    }

    pub(super) fn question(&self) -> Option<&Question> {
        self.session.round().questions().get(self.number())
    }

    /// Its number, from 0.
    pub(super) fn number(&self) -> usize {
        self.session.round().place().question
    }

    pub(super) fn step(&self) -> ClassStep {
        self.session.round().place().step
    }

    /// Whether the last question is behind.
    pub(super) fn is_over(&self) -> bool {
        matches!(self.phase, ClassPhase::End(_))
    }

    /// Whether leaving now would end something: a round in its midst, or one that is not
    /// kept.
    pub(super) fn asks_before_leaving(&self) -> bool {
        self.session.round().is_begun() && (self.unsaved || !self.is_over())
    }

    /// Begins what there is to do at the place at hand.
    fn arrive(&mut self, cx: &Context) {
        let ClassPlace { question, step } = self.session.round().place();
        self.furthest = self.furthest.max(question);
        if let Some(kept) = self.steps.get_mut(question) {
            *kept = step;
        }
        let vote = |vote| match self.session.round().way() {
            WayOfVoting::Teams => {
                ClassPhase::Vote(VoteEntry::new(self.session.round(), question, vote))
            }
            WayOfVoting::Tally => {
                ClassPhase::Tally(TallyEntry::new(self.session.round(), question, vote))
            }
            WayOfVoting::Devices => ClassPhase::Look,
        };
        self.phase = match step {
            ClassStep::FirstVote => vote(Vote::First),
            ClassStep::SecondVote => vote(Vote::Second),
            ClassStep::Shot => {
                let shown = ClassReveal::new(self.session.round(), question, cx.settings.pace());
                shown.map_or(ClassPhase::Look, |it| ClassPhase::Shot(Box::new(it)))
            }
            _ => ClassPhase::Look,
        };
        self.scroll = Scroll::default();
        self.page = 0;
        self.countdown = None;
        self.words_alone = false;
    }

    fn go(&mut self, question: usize, step: ClassStep, cx: &mut Context) {
        self.session.go(ClassPlace { question, step });
        self.arrive(cx);
        self.flush(cx);
    }

    /// Asks for what the session wants of the world.
    fn flush(&mut self, cx: &mut Context) {
        for effect in self.session.take_effects() {
            match effect {
                SessionEffect::Host(call) => cx.host(call),
                SessionEffect::Save(round) => {
                    cx.keep(self.ticket, StoreRequest::SaveClass(round));
                }
                SessionEffect::Note(changes, round) => {
                    cx.keep(self.ticket, StoreRequest::NoteClass { changes, round });
                }
                SessionEffect::KeepHandIn(on_its_way, file) => {
                    let ticket = cx.ask(StoreRequest::KeepHandIn(file));
                    self.hand_ins.insert(ticket, on_its_way);
                }
                SessionEffect::Tell(words) => cx.tell(words),
            }
        }
        if let Some(page) = &mut self.host_page {
            page.renew(&self.session);
        }
    }

    /// Takes in what was heard of pupils on devices.
    pub(super) fn take_news(&mut self, news: &[HostNews], cx: &mut Context) {
        self.session.take_news(news);
        self.flush(cx);
    }

    /// Does what a key means for pupils on devices.
    pub(super) fn host(&mut self, action: HostingAction, cx: &mut Context) {
        let page = self.host_page.take();
        self.host_page = HostPage::act(page, action, &mut self.session);
        self.flush(cx);
    }

    /// Lets pupils on devices go.
    pub(super) fn leave(&mut self, cx: &mut Context) {
        self.session.close();
        self.flush(cx);
    }

    /// The step so many further in the question; on devices all predict where they vote.
    fn step_beside(&self, beside: impl Fn(ClassStep) -> Option<ClassStep>) -> Option<ClassStep> {
        let skips = self.session.round().way() == WayOfVoting::Devices;
        match beside(self.step())? {
            ClassStep::Predict if skips => beside(ClassStep::Predict),
            step => Some(step),
        }
    }

    /// To what comes next.
    fn forward(&mut self, cx: &mut Context) {
        let question = self.number();
        if let ClassPhase::End(page) = self.phase {
            self.turn_page(page, 1);
        } else if let Some(next) = self.step_beside(ClassStep::next) {
            self.go(question, next, cx);
        } else if let Some(step) = self.steps.get(question + 1) {
            self.go(question + 1, *step, cx);
        } else {
            self.end(cx);
        }
    }

    /// To what came before.
    fn back(&mut self, cx: &mut Context) {
        let question = self.number();
        match self.phase {
            ClassPhase::End(EndPage::Board) => self.go(question, ClassStep::Scores, cx),
            ClassPhase::End(page) => self.turn_page(page, -1),
            _ => match (self.step_beside(ClassStep::before), question.checked_sub(1)) {
                (Some(before), _) => self.go(question, before, cx),
                (None, Some(question)) => self.go(question, ClassStep::Scores, cx),
                (None, None) => {}
            },
        }
    }

    /// The question so many further, after the last of which comes the end; none where it
    /// has not been reached yet.
    fn leads_to(&self, by: isize) -> Option<usize> {
        let from = self.number() + usize::from(self.is_over());
        let to = from.checked_add_signed(by)?;
        (to <= self.furthest).then_some(to)
    }

    /// Goes there, to where it was left.
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
        self.scroll = Scroll::default();
        self.session.end();
        self.flush(cx);
    }

    fn turn_page(&mut self, page: EndPage, by: isize) {
        let to = (page as usize).saturating_add_signed(by);
        self.phase = ClassPhase::End(EndPage::ALL[to.min(EndPage::ALL.len() - 1)]);
        self.scroll = Scroll::default();
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
                self.session.saved();
                self.flush(cx);
            }
            StoreReply::HandedIn(folder) => {
                if let Some(on_its_way) = self.hand_ins.remove(&answer.ticket) {
                    self.session.keeps_hand_in(on_its_way, folder);
                    self.flush(cx);
                }
            }
            StoreReply::Exported(exported) => cx.tell(match exported {
                Ok(place) => format!("Both tables are written: {place}"),
                Err(reason) => format!("The tables cannot be written: {reason}."),
            }),
            _ => {}
        }
    }

    /// The keys of the step at hand.
    pub(super) fn keys(&self) -> KeyTable<ClassAction> {
        use ClassAction::{
            Backward, BoardNames, Count, Countdown, Forward, Leap, Leave, Light, NotYet, Pause,
            ShowTyped, Tables, TakeBack, Team, Teams, ToTheShot, TurnPage, Vote, Watch, WordsAlone,
        };
        let keys = KeyTable::new("class");
        if let Some(page) = &self.host_page {
            let page = page.keys(&self.session);
            let free = page.exact(Key::Escape).is_none();
            return keys
                .with(page, ClassAction::Hosting)
                .on(Key::Escape, Leave, "leave")
                .when(free)
                .on('l', Light, "dark or light");
        }
        let forward = |name| {
            let keys = KeyTable::new("class").on(Key::Enter, Forward, name);
            keys.or([(' ', Forward)])
        };
        let read = |name| forward(name).on('z', WordsAlone, "words alone");
        let is_last = self.number() + 1 == self.session.round().questions().len();
        let step =
            match (&self.phase, self.step()) {
                (ClassPhase::Vote(entry), _) => match &entry.input {
                    Some(input) => {
                        let input = input.keys();
                        let free = input.exact(Key::Escape).is_none();
                        let keys = keys.with(input, Vote);
                        let show = if entry.is_open { "hide" } else { "show" };
                        return scrolled(
                            keys.on(Key::Escape, NotYet, "not yet")
                                .when(free)
                                .on('v', ShowTyped, show)
                                .on('p', Pause, "pause")
                                .on('l', Light, "dark or light"),
                        );
                    }
                    None => {
                        let count = self.session.round().participants().len();
                        let numbers = ('1'..).zip((0..count).map(Team));
                        keys.with(ListView::keys("give a vote"), Teams)
                            .each(numbers, "a team")
                            .on('x', TakeBack, "take back")
                            .or([(Key::Delete, TakeBack)])
                            .when(entry.has_voted(self.session.round()))
                    }
                },
                (ClassPhase::Tally(_), _) => keys.on(Key::Enter, Count, "take it"),
                (ClassPhase::Shot(shown), _) => {
                    // What is watched has the space bar, and Enter until all is told.
                    let keys = match shown.reveal.watch() {
                        Some(_) => keys.on(Key::Enter, Forward, "the scores"),
                        None => forward("the scores"),
                    };
                    let keys = keys.when(!shown.reveal.is_telling());
                    keys.with(shown.reveal.keys(), Watch)
                }
                (ClassPhase::End(page), _) => forward("next page")
                    .when(*page != EndPage::Items)
                    .by([Key::Left, Key::Right], TurnPage, [-1, 1], ""),
                (_, ClassStep::Describe) if self.session.is_hosted() => read("the vote"),
                (_, ClassStep::FirstVote) => read("talk"),
                (_, ClassStep::SecondVote) => read("the shot"),
                (_, ClassStep::Describe) => read("predict"),
                (_, ClassStep::Predict) => read("first vote"),
                (_, ClassStep::Talk) => forward("second vote").on('g', ToTheShot, "the shot"),
                (_, ClassStep::Scores) if is_last => forward("the end"),
                (_, ClassStep::Scores) => forward("next question"),
                _ => forward("go on"),
            };
        let tables = match self.is_over() {
            true => "tables",
            false => "",
        };
        let is_board = matches!(
            (&self.phase, self.step()),
            (ClassPhase::End(EndPage::Board), _) | (ClassPhase::Look, ClassStep::Scores)
        );
        let names = if self.names_shown {
            "no names"
        } else {
            "names"
        };
        let step = match self.session.is_hosted() {
            true => step
                .with(hosting::step_keys(), ClassAction::Hosting)
                .on('n', BoardNames, names)
                .when(is_board),
            false => step,
        };
        let keys = step
            .on('e', Tables, tables)
            .on(Key::Backspace, Backward, "back")
            .on('p', Pause, "pause")
            .on('c', Countdown, "")
            .on('l', Light, "dark or light")
            .by(['[', ']'], Leap, [-1, 1], "questions")
            .when([-1, 1].iter().any(|by| self.leads_to(*by).is_some()))
            .on(Key::Escape, Leave, "leave");
        match self.phase {
            // A panel is scrolled by the keys of all panels.
            ClassPhase::End(EndPage::Held | EndPage::Items) => keys,
            _ => scrolled(keys),
        }
    }

    /// Does what a key stands for.
    pub(super) fn act(&mut self, action: ClassAction, cx: &mut Context) {
        match (action, &mut self.phase) {
            (ClassAction::Hosting(action), _) => self.host(action, cx),
            (ClassAction::Forward, _) => self.forward(cx),
            (ClassAction::Backward, _) => self.back(cx),
            (ClassAction::Leap(by), _) => self.leap(by, cx),
            (ClassAction::TurnPage(by), ClassPhase::End(page)) => {
                let page = *page;
                self.turn_page(page, by);
            }
            (ClassAction::Watch(action), ClassPhase::Shot(shown)) => shown.reveal.act(action),
            (ClassAction::Count, ClassPhase::Tally(entry)) => {
                let entry = entry.clone();
                if entry.give(&mut self.session) {
                    self.forward(cx);
                }
            }
            (ClassAction::ToTheShot, _) => self.go(self.number(), ClassStep::Shot, cx),
            (ClassAction::Countdown, _) => {
                self.countdown = Some(match self.countdown {
                    Some(left) if !left.is_zero() => left + Duration::from_secs(30),
                    _ => Duration::from_secs(60),
                });
            }
            (ClassAction::WordsAlone, _) => self.words_alone = !self.words_alone,
            (ClassAction::BoardNames, _) => {
                self.names_shown = !self.names_shown;
                self.scroll = Scroll::default();
            }
            (ClassAction::Tables, _) => {
                cx.ask(StoreRequest::ExportClass(self.session.shared_round()));
            }
            (ClassAction::Teams(action), ClassPhase::Vote(entry)) => {
                let outcome = entry
                    .teams
                    .act(action, self.session.round().participants().len() + 1);
                self.open(outcome, cx);
            }
            (ClassAction::Team(team), ClassPhase::Vote(entry)) => {
                entry.open(team, self.session.round());
            }
            (ClassAction::TakeBack, ClassPhase::Vote(entry)) => {
                let change = entry.take_back(self.session.round());
                self.session.enter(&change);
                self.flush(cx);
            }
            (ClassAction::Vote(action), ClassPhase::Vote(entry)) => {
                let outcome = entry.input.as_mut().map(|input| input.act(action));
                // A choice is given by one key.
                let is_chosen = matches!(action, AnswerAction::Choose(_));
                if is_chosen || outcome == Some(Outcome::Done(())) {
                    entry.give(&mut self.session);
                    self.flush(cx);
                }
            }
            (ClassAction::ShowTyped, ClassPhase::Vote(entry)) => entry.is_open = !entry.is_open,
            (ClassAction::NotYet, ClassPhase::Vote(entry)) => entry.input = None,
            _ => {}
        }
    }

    /// Takes a key of what is typed.
    pub(super) fn typed(&mut self, key: Key) -> bool {
        let page = self.host_page.as_mut();
        match &mut self.phase {
            ClassPhase::Tally(entry) => entry.typed(key),
            _ => page.is_some_and(|page| page.typed(key)),
        }
    }

    /// Takes the mouse over the picture of a step; says whether it meant something.
    pub(super) fn point(&mut self, mouse: &Mouse, picture: Rect) -> bool {
        let pressed = mouse.kind == MouseKind::Down;
        let question = self.session.round().questions().get(self.number());
        match (&mut self.phase, question) {
            (ClassPhase::Vote(entry), Some(question)) if mouse.is_held() => {
                let input = entry.input.as_mut();
                input.is_some_and(|input| input.point(question, picture, mouse.place(), pressed))
            }
            _ => false,
        }
    }

    /// Lets a team vote, or after the last one goes on.
    fn open(&mut self, row: Outcome<usize>, cx: &mut Context) {
        let count = self.session.round().participants().len();
        match (row, &mut self.phase) {
            (Outcome::Done(team), ClassPhase::Vote(entry)) if team < count => {
                entry.open(team, self.session.round());
            }
            (Outcome::Done(_), _) => self.forward(cx),
            _ => {}
        }
    }

    /// Lets time pass.
    pub(super) fn advance(&mut self, passed: Duration, pace: HitPace) {
        self.session.advance(passed);
        self.countdown = self.countdown.map(|left| left.saturating_sub(passed));
        if let ClassPhase::Shot(shown) = &mut self.phase {
            shown.reveal.advance(passed, pace);
        }
    }

    /// When it next needs time.
    pub(super) fn wake(&self, pace: HitPace) -> Option<Duration> {
        let shot = match &self.phase {
            ClassPhase::Shot(shown) => shown.reveal.wake(pace),
            _ => None,
        };
        // To where the next lower second is shown.
        let left = self.countdown.filter(|left| !left.is_zero());
        let second = left.map(|left| match left.subsec_nanos() {
            0 => Duration::from_secs(1),
            nanos => Duration::from_nanos(nanos.into()),
        });
        let door = self.session.wake();
        shot.into_iter().chain(second).chain(door).min()
    }
}

/// The keys with those that scroll or turn pages.
fn scrolled(keys: KeyTable<ClassAction>) -> KeyTable<ClassAction> {
    let keys_of_text = [Key::Up, Key::Down, Key::PageUp, Key::PageDown];
    keys.by(keys_of_text, ClassAction::Scroll, [-1, 1, -8, 8], "")
}

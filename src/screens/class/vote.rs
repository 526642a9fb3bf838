//! The page on which the teams, one after another, give one of their two votes on a question.

use strum::{EnumMessage, IntoStaticStr};

use super::stage::Stage;
use super::{ClassAction, question};
use crate::class::{ClassChange, ClassRound, Said, Session, Vote};
use crate::messages::Key;
use crate::quiz::{Form, Question, Response, letter};
use crate::screens::View;
use crate::widgets::input::{KeyTable, ListAction, ListView};
use crate::widgets::panel::Panel;
use crate::widgets::panels::Heading;
use crate::widgets::{AnswerAction, AnswerInput, Outcome, RayInput, Role, draw_question};

/// Answers that differ by less than this, in units of the tolerance, count as the same.
const SAME: f64 = 1e-6;

/// Who has voted, and the team that is voting now.
#[derive(Debug, Clone)]
pub(super) struct TeamVotes {
    vote: Vote,
    question: usize,
    /// The teams; after the last comes the row that continues the round.
    teams: ListView,
    booth: Option<Booth>,
}

/// The input of the marked team.
#[derive(Debug, Clone)]
struct Booth {
    input: AnswerInput,
    /// Whether the class can see what is typed.
    is_open: bool,
}

/// What the keys do while teams vote.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum VoteAction {
    /// choose a team, or go on
    Teams(ListAction),
    /// let this team enter or correct its vote
    Team(usize),
    /// take back the team's vote
    TakeBack,
    /// vote
    Vote(AnswerAction),
    /// leave the vote unchanged
    NotYet,
    /// show or hide what is typed
    ShowTyped,
}

impl TeamVotes {
    /// For the first vote, the mark starts at the first team without a vote. After the discussion
    /// every team keeps its vote unless it votes again, so the mark starts at the row that
    /// continues the round.
    pub(super) fn new(round: &ClassRound, question: usize, vote: Vote) -> Self {
        let mut votes = Self {
            vote,
            question,
            teams: ListView::default(),
            booth: None,
        };
        votes.choose_next(round);
        votes
    }

    /// Whether a team is voting now.
    pub(super) fn is_in_booth(&self) -> bool {
        self.booth.is_some()
    }

    /// The marked row: the index of a team, or the number of teams for the row that continues the
    /// round.
    fn at(&self, round: &ClassRound) -> usize {
        self.teams.chosen(round.participants().len() + 1)
    }

    /// Moves the mark to the first team without a vote; at the second vote, or if all have voted,
    /// to the row that continues the round.
    fn choose_next(&mut self, round: &ClassRound) {
        let count = round.participants().len();
        let waits = |team: &usize| {
            let ballot = round.ballot(self.question, *team);
            ballot.vote(Vote::First).is_none()
        };
        let waiting = (0..count).find(|team| self.vote == Vote::First && waits(team));
        self.teams.choose(waiting.unwrap_or(count));
    }

    /// The keys, except those that all steps share.
    pub(super) fn keys(&self, round: &ClassRound) -> KeyTable<VoteAction> {
        use VoteAction::{NotYet, ShowTyped, TakeBack, Team, Teams, Vote};
        let keys = KeyTable::new("class");
        let Some(booth) = &self.booth else {
            let count = round.participants().len();
            let ballot = round.ballot(self.question, self.at(round));
            // The page keys turn the pages of the question.
            let list = ListView::keys("give a vote").without_keys(&[Key::PageUp, Key::PageDown]);
            return keys
                .with(list, Teams)
                .each(('1'..).zip((0..count).map(Team)), "a team")
                .on('x', TakeBack, "take back")
                .or([(Key::Delete, TakeBack)])
                .when(ballot.vote(self.vote).is_some());
        };
        let input = booth.input.keys();
        let free = input.exact(Key::Escape).is_none();
        keys.with(input, Vote)
            .on(Key::Escape, NotYet, "not yet")
            .when(free)
            .on('v', ShowTyped, if booth.is_open { "hide" } else { "show" })
            .when(booth.is_typed())
    }

    /// Carries out an action; returns whether the class continues.
    pub(super) fn act(&mut self, action: VoteAction, session: &mut Session) -> bool {
        let round = session.round();
        let count = round.participants().len();
        match (action, &mut self.booth) {
            (VoteAction::Teams(action), _) => match self.teams.act(action, count + 1) {
                Outcome::Done(team) if team < count => self.open(team, round),
                Outcome::Done(_) => return true,
                _ => {}
            },
            (VoteAction::Team(team), _) => self.open(team, round),
            (VoteAction::TakeBack, _) => {
                let change = self.change(self.at(round), None);
                session.enter(&change);
            }
            (VoteAction::Vote(action), Some(booth)) => {
                let outcome = booth.input.act(action);
                // A choice requires only one key press.
                if matches!(action, AnswerAction::Choose(_)) || outcome == Outcome::Done(()) {
                    self.give(session);
                }
            }
            (VoteAction::NotYet, booth) => *booth = None,
            (VoteAction::ShowTyped, Some(booth)) => booth.is_open = !booth.is_open,
            (VoteAction::Vote(_) | VoteAction::ShowTyped, None) => {}
        }
        false
    }

    /// Lets a team make or change its vote.
    fn open(&mut self, team: usize, round: &ClassRound) {
        let Some(question) = round.questions().get(self.question) else {
            return;
        };
        self.teams.choose(team);
        let ballot = round.ballot(self.question, team);
        self.booth = Some(Booth {
            input: AnswerInput::saying(&question.form, ballot.said(self.vote)),
            is_open: false,
        });
    }

    fn change(&self, person: usize, said: Option<Response>) -> ClassChange {
        ClassChange::Vote {
            question: self.question,
            vote: self.vote,
            person,
            said: said.map(Said::from),
        }
    }

    /// Records the vote, and moves the mark on.
    fn give(&mut self, session: &mut Session) {
        let round = session.round();
        let team = self.at(round);
        let said = self.booth.take().and_then(|booth| booth.input.said());
        let before = round.ballot(self.question, team).vote(Vote::First);
        // The same answer again counts as an unchanged vote.
        let same = match (round.questions().get(self.question), said, before) {
            (Some(question), Some(said), Some(before)) => {
                question.form.distance(&said, &before) < SAME
            }
            _ => false,
        };
        let kept = self.vote == Vote::Second && same;
        session.enter(&self.change(team, said.filter(|_| !kept)));
        self.choose_next(session.round());
    }

    /// The answer being entered, which the mouse can set in the picture.
    pub(super) fn input_mut(&mut self) -> Option<&mut AnswerInput> {
        self.booth.as_mut().map(|booth| &mut booth.input)
    }

    /// The question and who has voted, without the votes; or the team that is voting now.
    pub(super) fn view<'s>(
        &'s self,
        play: &'s Stage,
        question: &'s Question,
    ) -> View<'s, ClassAction> {
        let heading = match self.vote {
            Vote::First => Heading::new(
                &["First vote", "Vote 1"],
                "Each team in turn. What you type is hidden.",
            ),
            Vote::Second => Heading::new(
                &["Second vote", "Vote 2"],
                "Each team may change its vote or keep it.",
            ),
        };
        let mut words = play.words();
        let picks = |choice| {
            let pick = VoteAction::Vote(AnswerAction::Choose(choice));
            self.is_in_booth().then_some(ClassAction::Vote(pick))
        };
        question::write(play, question, None, picks, &mut words);
        let mut foot = Panel::new("");
        foot.part(ClassAction::Vote, |foot| match &self.booth {
            None => self.write_teams(play.round(), foot),
            Some(booth) => {
                let name = play.round().name_of(self.at(play.round()));
                booth.write(name, &question.form, foot);
            }
        });
        let shown = self.booth.as_ref().filter(|booth| booth.is_open);
        let draw = move |area, buf: &mut _, look: &_| {
            draw_question(area, buf, look, question, shown.map(|booth| &booth.input));
        };
        let rays = shown.and_then(|booth| booth.input.rays());
        let view = play.step_view(Some(heading), question::beside(question), draw, words);
        view.with_foot(foot).dragging(rays.map(|_| RayInput::DRAG))
    }

    fn write_teams(&self, round: &ClassRound, foot: &mut Panel<VoteAction>) {
        let at = self.at(round);
        let point = |row| VoteAction::Teams(ListAction::Point(row));
        let teams = round.teams().into_iter().enumerate().map(|(team, name)| {
            let sign = sign(round, self.question, team, self.vote);
            ([name.to_owned(), sign.to_owned()], point(team))
        });
        foot.grid(teams, Some(at));
        let last = round.participants().len();
        let next = match self.vote {
            Vote::First => "Go on to the discussion",
            Vote::Second => "Go on to the shot",
        };
        let note = note(round, self.question, self.vote);
        foot.row(
            (next, Role::Text),
            (note, Role::Text),
            at == last,
            point(last),
        );
    }
}

impl Booth {
    /// Whether the answer has to be typed; a choice requires only one key press.
    fn is_typed(&self) -> bool {
        !matches!(self.input, AnswerInput::Choice { .. })
    }

    /// Writes the team's name and input. What is typed is shown only on request.
    fn write(&self, name: &str, form: &Form, foot: &mut Panel<VoteAction>) {
        if let Form::Choice { options, .. } = form {
            foot.line(name, Role::Title);
            let letters: Vec<String> = (0..options.len()).map(|i| letter(i).to_string()).collect();
            foot.line(
                format!("Type one letter: {}.", letters.join(", ")),
                Role::Key,
            );
            return;
        }
        let (hidden, show) = match self.is_open {
            true => ("", "hide what is typed"),
            false => ("what is typed is hidden", "show what is typed"),
        };
        foot.pair((name, Role::Title), (hidden, Role::Key));
        if self.is_open {
            foot.part(VoteAction::Vote, |foot| {
                self.input.write(form, Some(1), foot);
            });
        }
        foot.paragraph(self.input.about(form), Role::Text);
        let (words, next) = self.input.next(form, "that is our vote");
        let show = (show.to_owned(), VoteAction::ShowTyped);
        foot.prompts([(words, VoteAction::Vote(next)), show]);
    }
}

/// The sign beside a team: `[x]` if it has voted or changed its vote, `[=]` if it keeps its vote,
/// otherwise `[ ]`.
fn sign(round: &ClassRound, question: usize, team: usize, vote: Vote) -> &'static str {
    let ballot = round.ballot(question, team);
    match (vote, ballot.vote(Vote::First), ballot.vote(Vote::Second)) {
        (Vote::First, Some(_), _) | (Vote::Second, _, Some(_)) => "[x]",
        (Vote::Second, Some(_), None) => "[=]",
        (_, None, _) => "[ ]",
    }
}

/// The number of teams without a vote and, at the second vote, the number of changed votes.
fn note(round: &ClassRound, question: usize, vote: Vote) -> String {
    let missing = missing(round, question, Vote::Second);
    let voted = round.voted(question, vote);
    match vote {
        Vote::First if missing.is_empty() => "all have voted".into(),
        Vote::First => missing,
        Vote::Second if missing.is_empty() => format!("changed: {voted}"),
        Vote::Second => format!("changed: {voted}, {missing}"),
    }
}

/// "2 teams without a vote"; empty if all teams have voted.
pub(super) fn missing(round: &ClassRound, question: usize, vote: Vote) -> String {
    let said = round.said(question, vote).count();
    match round.participants().len().saturating_sub(said) {
        0 => String::new(),
        count => format!("{} without a vote", round.way().voters(count)),
    }
}

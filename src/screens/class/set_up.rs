//! Setting up a round: who plays, and which questions.

use std::sync::Arc;

use super::play::Play;
use crate::class::{ClassRound, LONGEST_NAME, MOST_TEAMS, team_names};
use crate::messages::Key;
use crate::quiz::concepts::Library;
use crate::quiz::{Code, Course, CourseKind, Family};
use crate::screens::Context;

/// What is said of what is no code.
const NO_CODE: &str = "expected the code of a round, such as mixed-7, or 7 for ten hits";
/// Most letters of a name or a code while it is typed.
const LONGEST: usize = 2 * LONGEST_NAME;

/// The page on which a round is set up.
#[derive(Debug, Clone)]
pub(super) struct SetUp {
    /// Names as typed.
    pub(super) teams: Vec<String>,
    /// Where the mark is.
    pub(super) at: Row,
    /// The kind of round that is chosen.
    pub(super) kind: Kind,
    /// The one topic, by its place among [`topics`].
    pub(super) topic: usize,
    /// The code as typed.
    pub(super) code: String,
    /// Why it cannot start.
    pub(super) trouble: Option<String>,
    /// The questions of the teacher's own.
    pub(super) own: Arc<Library>,
}

/// A row of the page that the mark can be at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Row {
    /// The name of a team, counted from 0.
    Team(usize),
    /// One more team.
    Add,
    /// A kind of round.
    Kind(Kind),
    /// Off we go.
    Start,
    /// The list of earlier rounds.
    Earlier,
}

/// Which questions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Mixed,
    Quick,
    Hits,
    Topic,
    Own,
    Code,
}

impl Kind {
    const ALL: [Self; 6] = [
        Self::Mixed,
        Self::Quick,
        Self::Hits,
        Self::Topic,
        Self::Own,
        Self::Code,
    ];
}

/// What follows from a key.
pub(super) enum Step {
    Stay,
    Ignored,
    Back,
    Start(Box<Play>),
    Earlier,
}

/// The families that a round of one topic can have.
pub(super) fn topics() -> Vec<Family> {
    let all = Family::ALL.into_iter();
    all.filter(|family| CourseKind::with_id(family.id()).is_some())
        .collect()
}

impl SetUp {
    /// The page with what is known already.
    pub(super) fn new(code: Option<&Code>, teams: Vec<String>, own: Arc<Library>) -> Self {
        let at = match (code, teams.is_empty()) {
            (_, true) => Row::Add,
            (None, false) => Row::Kind(Kind::Mixed),
            (Some(_), false) => Row::Start,
        };
        Self {
            teams,
            at,
            kind: if code.is_some() {
                Kind::Code
            } else {
                Kind::Mixed
            },
            topic: 0,
            code: code.map(ToString::to_string).unwrap_or_default(),
            trouble: None,
            own,
        }
    }

    /// The kinds of round there are; own questions only where there are any.
    pub(super) fn kinds(&self) -> Vec<Kind> {
        let all = Kind::ALL.into_iter();
        all.filter(|kind| *kind != Kind::Own || !self.own.concepts.is_empty())
            .collect()
    }

    /// All rows, from the top of the left side to the foot of the right one.
    pub(super) fn rows(&self) -> Vec<Row> {
        let mut rows: Vec<Row> = (0..self.teams.len()).map(Row::Team).collect();
        if self.teams.len() < MOST_TEAMS {
            rows.push(Row::Add);
        }
        rows.extend(self.kinds().into_iter().map(Row::Kind));
        rows.extend([Row::Start, Row::Earlier]);
        rows
    }

    /// The text that letters go to.
    fn text(&mut self) -> Option<&mut String> {
        match self.at {
            Row::Team(team) => self.teams.get_mut(team),
            Row::Kind(Kind::Code) => Some(&mut self.code),
            _ => None,
        }
    }

    /// Takes a key.
    pub(super) fn key(&mut self, key: Key, cx: &mut Context) -> Step {
        self.trouble = None;
        match key {
            Key::Up | Key::BackTab => self.walk(-1),
            Key::Down | Key::Tab => self.walk(1),
            Key::Home => self.at = self.rows()[0],
            Key::End => self.at = Row::Start,
            Key::Left => self.turn_topic(-1),
            Key::Right => self.turn_topic(1),
            Key::Enter => return self.enter(cx),
            Key::Delete => self.remove(),
            Key::Backspace => {
                let at_team = matches!(self.at, Row::Team(_));
                match self.text() {
                    Some(text) if text.is_empty() && at_team => self.remove(),
                    Some(text) => {
                        text.pop();
                    }
                    None => return Step::Ignored,
                }
            }
            Key::Escape => return Step::Back,
            Key::Char(c) => return self.letter(c),
            _ => return Step::Ignored,
        }
        Step::Stay
    }

    fn letter(&mut self, c: char) -> Step {
        match self.at {
            Row::Add => self.add(),
            Row::Kind(kind @ Kind::Code) => self.kind = kind,
            Row::Kind(kind) if c == ' ' => {
                self.kind = kind;
                return Step::Stay;
            }
            _ => {}
        }
        match self.text() {
            Some(text) => {
                if text.chars().count() < LONGEST && !c.is_control() {
                    text.push(c);
                }
                Step::Stay
            }
            None => Step::Ignored,
        }
    }

    /// Takes pasted text: where names are typed, a name a line.
    pub(super) fn paste(&mut self, pasted: &str) {
        let mut lines = pasted.lines();
        for c in lines.next().unwrap_or_default().chars().take(LONGEST) {
            self.letter(c);
        }
        if !matches!(self.at, Row::Team(_)) {
            return;
        }
        for line in lines.filter(|line| !line.trim().is_empty()) {
            if self.teams.len() < MOST_TEAMS {
                self.add();
                for c in line.chars().take(LONGEST) {
                    self.letter(c);
                }
            }
        }
    }

    fn add(&mut self) {
        self.at = Row::Team(self.teams.len());
        self.teams.push(String::new());
    }

    fn remove(&mut self) {
        if let Row::Team(team) = self.at {
            self.teams.remove(team);
            self.at = if team < self.teams.len() {
                Row::Team(team)
            } else {
                Row::Add
            };
        }
    }

    fn walk(&mut self, by: isize) {
        let rows = self.rows();
        let at = rows.iter().position(|row| *row == self.at).unwrap_or(0);
        let to = at.saturating_add_signed(by).min(rows.len() - 1);
        self.go(rows[to]);
    }

    /// Puts the mark at a row. A name that was left empty is none.
    fn go(&mut self, row: Row) {
        let mut row = row;
        if let Row::Team(left) = self.at
            && self.teams[left].trim().is_empty()
            && row != self.at
        {
            self.teams.remove(left);
            row = match row {
                Row::Team(team) if team > left => Row::Team(team - 1),
                row => row,
            };
        }
        self.at = if self.rows().contains(&row) {
            row
        } else {
            Row::Add
        };
    }

    fn turn_topic(&mut self, by: isize) {
        if self.at == Row::Kind(Kind::Topic) {
            let count = topics().len();
            self.topic = (self.topic + count).saturating_add_signed(by) % count.max(1);
            self.kind = Kind::Topic;
        }
    }

    fn enter(&mut self, cx: &mut Context) -> Step {
        match self.at {
            // An empty name is the way to the next thing.
            Row::Add => self.go(Row::Kind(self.kind)),
            Row::Team(_) => self.walk(1),
            Row::Kind(kind) => {
                self.kind = kind;
                self.go(Row::Start);
            }
            Row::Start => return self.start(cx),
            Row::Earlier => return Step::Earlier,
        }
        Step::Stay
    }

    fn start(&mut self, cx: &mut Context) -> Step {
        let names = match team_names(self.teams.iter().map(String::as_str)) {
            Ok(names) => names,
            Err(trouble) => {
                self.trouble = Some(format!("The teams: {trouble}."));
                return Step::Stay;
            }
        };
        let kind = match self.kind {
            Kind::Mixed => Some(CourseKind::Mixed),
            Kind::Quick => Some(CourseKind::Quick),
            Kind::Hits => Some(CourseKind::Hits),
            Kind::Topic => topics().get(self.topic).copied().map(CourseKind::Topic),
            Kind::Own => Some(CourseKind::Own(Arc::clone(&self.own))),
            Kind::Code => None,
        };
        let code = match kind {
            Some(kind) => Ok(Code {
                course: Course::new(kind),
                seed: cx.next_seed(),
            }),
            None => Code::parse(&self.code)
                .ok_or_else(|| NO_CODE.to_owned())
                .and_then(|code| code.with_own(&self.own)),
        };
        match code {
            Ok(code) => Step::Start(Box::new(Play::new(ClassRound::new(code, names), cx))),
            Err(trouble) => {
                self.at = Row::Kind(Kind::Code);
                self.trouble = Some(format!("The code: {trouble}."));
                Step::Stay
            }
        }
    }

    /// Clicks on a row: puts the mark there, and does what Enter would on one that
    /// cannot be typed into.
    pub(super) fn click(&mut self, row: Row, cx: &mut Context) -> Step {
        self.trouble = None;
        match row {
            Row::Add => self.add(),
            Row::Team(_) => self.go(row),
            Row::Kind(kind) => {
                self.go(row);
                self.kind = kind;
            }
            Row::Start | Row::Earlier => {
                self.go(row);
                return self.enter(cx);
            }
        }
        Step::Stay
    }
}

//! Setting up a round: the teams, and the questions.

use std::sync::Arc;

use strum::{EnumMessage, IntoStaticStr, VariantArray};

use super::ClassScene;
use super::earlier::ROUNDS;
use crate::class::{ClassRound, LONGEST_NAME, MOST_TEAMS, WayOfVoting, team_names};
use crate::messages::Key;
use crate::quiz::concepts::Library;
use crate::quiz::{Code, Course, CourseKind, Round};
use crate::screens::Context;
use crate::screens::kept_files::KeptFiles;
use crate::widgets::Outcome;
use crate::widgets::input::{KeyTable, ListAction, ListView, TextField};

/// The message for an invalid code.
const NO_CODE: &str = "expected the code of a round, such as mixed-7, or 7 for ten hits";
/// The maximum number of letters in a name or a code while it is being typed.
const LONGEST: usize = 2 * LONGEST_NAME;

/// The page on which a round is set up.
#[derive(Debug, Clone)]
pub(super) struct SetUp {
    /// The names of the teams, as typed.
    pub(super) teams: Vec<TextField>,
    /// The name of the class, as typed.
    pub(super) class: TextField,
    list: ListView,
    pub(super) kind: RoundKind,
    /// The chosen topic, as an index into [`CourseKind::topics`].
    pub(super) topic: usize,
    pub(super) code: TextField,
    /// Whether carrom gives nicknames to pupils' devices.
    pub(super) nicknames: bool,
    /// The reason why the round cannot start.
    pub(super) trouble: Option<String>,
    /// The teacher's own questions.
    pub(super) own: Arc<Library>,
}

/// A row of the page that can be chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SetUpRow {
    /// The name of a team, counted from 0.
    Team(usize),
    /// Adds a team.
    Add,
    /// The name of the class.
    Class,
    /// Whether carrom gives nicknames to pupils' devices.
    Nicknames,
    Kind(RoundKind),
    /// Starts the round, in which the class votes in this way.
    Start(WayOfVoting),
    /// The list of earlier rounds.
    Earlier,
}

/// The kind of round, by its questions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, VariantArray)]
pub(super) enum RoundKind {
    Mixed,
    Quick,
    Hits,
    Topic,
    Own,
    Code,
}

/// What the keys do on the set-up page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum SetUpAction {
    /// choose a row, or use it
    List(ListAction),
    /// choose another topic
    Topic(isize),
    /// remove the team
    Remove,
    /// see the questions of the chosen round
    Preview,
}

impl SetUp {
    /// The page with the known values filled in.
    pub(super) fn new(
        code: Option<&Code>,
        teams: &[String],
        class: &str,
        own: Arc<Library>,
    ) -> Self {
        let at = match (code, teams.is_empty()) {
            (_, true) => SetUpRow::Add,
            (None, false) => SetUpRow::Kind(RoundKind::Mixed),
            (Some(_), false) => SetUpRow::Start(WayOfVoting::Teams),
        };
        let teams = teams.iter().map(|name| TextField::new(name, LONGEST));
        let mut set_up = Self {
            teams: teams.collect(),
            class: TextField::new(class, LONGEST),
            list: ListView::default(),
            kind: code.map_or(RoundKind::Mixed, |_| RoundKind::Code),
            topic: 0,
            code: TextField::new(&code.map(ToString::to_string).unwrap_or_default(), LONGEST),
            nicknames: false,
            trouble: left_out(&own),
            own,
        };
        set_up.put(at);
        set_up
    }

    /// The marked row.
    pub(super) fn at(&self) -> SetUpRow {
        let rows = self.rows();
        rows[self.list.chosen(rows.len())]
    }

    /// Moves the mark to a row.
    pub(super) fn put(&mut self, row: SetUpRow) {
        let at = self.rows().iter().position(|it| *it == row);
        self.list.choose(at.unwrap_or(self.teams.len()));
    }

    /// The available kinds of round; the teacher's own questions are included only if they exist.
    pub(super) fn kinds(&self) -> Vec<RoundKind> {
        let mut kinds = RoundKind::VARIANTS.to_vec();
        kinds.retain(|kind| *kind != RoundKind::Own || !self.own.concepts.is_empty());
        kinds
    }

    /// The course of a kind of round; `None` for a round by its code, which contains the course.
    pub(super) fn course(&self, kind: RoundKind) -> Option<CourseKind> {
        Some(match kind {
            RoundKind::Mixed => CourseKind::Even,
            RoundKind::Quick => CourseKind::Quick,
            RoundKind::Hits => CourseKind::Hits,
            RoundKind::Topic => CourseKind::Topic(CourseKind::topics().nth(self.topic)?),
            RoundKind::Own => CourseKind::Own(Arc::clone(&self.own)),
            RoundKind::Code => return None,
        })
    }

    /// All rows, in the order in which the mark moves through them: the first ones on the left, the
    /// kinds of round on the right, then the others on the left.
    pub(super) fn rows(&self) -> Vec<SetUpRow> {
        let mut rows: Vec<SetUpRow> = (0..self.teams.len()).map(SetUpRow::Team).collect();
        if self.teams.len() < MOST_TEAMS {
            rows.push(SetUpRow::Add);
        }
        rows.extend([SetUpRow::Class, SetUpRow::Nicknames]);
        rows.extend(self.kinds().into_iter().map(SetUpRow::Kind));
        rows.extend(WayOfVoting::VARIANTS.iter().copied().map(SetUpRow::Start));
        rows.push(SetUpRow::Earlier);
        rows
    }

    /// The text that is being typed.
    fn field(&mut self) -> Option<&mut TextField> {
        match self.at() {
            SetUpRow::Team(team) => self.teams.get_mut(team),
            SetUpRow::Class => Some(&mut self.class),
            SetUpRow::Kind(RoundKind::Code) => Some(&mut self.code),
            _ => None,
        }
    }

    /// The keys of the marked row. If the row has a text field, letters are typed into the field.
    pub(super) fn keys(&self) -> KeyTable<SetUpAction> {
        use SetUpAction::{List, Preview, Remove, Topic};
        let at = self.at();
        let enter = match at {
            SetUpRow::Team(_) | SetUpRow::Add | SetUpRow::Class => "next",
            SetUpRow::Kind(_) => "choose it",
            SetUpRow::Start(_) => "start",
            SetUpRow::Nicknames => "switch",
            SetUpRow::Earlier => "open the list",
        };
        KeyTable::new("class")
            .by([Key::Left, Key::Right], Topic, [-1, 1], "another topic")
            .when(at == SetUpRow::Kind(RoundKind::Topic))
            .with(ListView::keys_of_form(enter, self.has_text()), List)
            .on(Key::Delete, Remove, "remove it")
            .when(matches!(at, SetUpRow::Team(_)))
            .on('p', Preview, "see the questions")
            .when(self.can_preview())
    }

    /// Whether the row has a text field.
    fn has_text(&self) -> bool {
        use SetUpRow::{Class, Kind, Team};
        matches!(self.at(), Team(_) | Class | Kind(RoundKind::Code))
    }

    /// Whether the preview key works here: in a row with a text field it types a letter instead.
    pub(super) fn can_preview(&self) -> bool {
        !self.has_text() && self.at() != SetUpRow::Add
    }

    /// Handles a key that edits text; returns whether the key was used.
    pub(super) fn typed(&mut self, key: Key) -> bool {
        if let (SetUpRow::Add, Key::Char(c)) = (self.at(), key)
            && !c.is_whitespace()
            && c != '?'
        {
            self.add();
        }
        // A question mark opens the help: no code and hardly any name contains one.
        let Some(field) = self.field().filter(|_| key != Key::Char('?')) else {
            return false;
        };
        // At the end of a name, Delete removes the team.
        let at_end = field.around_cursor().1.is_empty();
        if (key == Key::Delete && at_end) || !field.update(key) {
            return false;
        }
        self.trouble = None;
        if self.at() == SetUpRow::Kind(RoundKind::Code) {
            self.kind = RoundKind::Code;
        }
        true
    }

    /// Carries out the action of a key or a click; returns the page that follows.
    pub(super) fn act(&mut self, action: SetUpAction, cx: &mut Context) -> Outcome<ClassScene> {
        match action {
            SetUpAction::List(action) => self.listed(action, cx),
            SetUpAction::Topic(by) => {
                let count = CourseKind::topics().count();
                self.topic = (self.topic + count).saturating_add_signed(by) % count.max(1);
                self.kind = RoundKind::Topic;
                Outcome::Used
            }
            SetUpAction::Remove => {
                if let SetUpRow::Team(team) = self.at() {
                    self.teams.remove(team);
                }
                Outcome::Used
            }
            SetUpAction::Preview => {
                if let SetUpRow::Kind(kind) = self.at() {
                    self.kind = kind;
                }
                let Some(code) = self.chosen_code(cx) else {
                    return Outcome::Used;
                };
                // The round now has a code, so it will begin with the questions that were
                // previewed.
                self.code = TextField::new(&code.to_string(), LONGEST);
                self.kind = RoundKind::Code;
                self.put(SetUpRow::Start(WayOfVoting::Teams));
                Outcome::Done(ClassScene::Preview(Round::of(code)))
            }
        }
    }

    /// Moves the mark, or activates the marked row. An empty name is removed.
    fn listed(&mut self, action: ListAction, cx: &mut Context) -> Outcome<ClassScene> {
        self.trouble = None;
        let left = self.at();
        let rows = self.rows().len();
        match self.list.act(action, rows) {
            Outcome::Done(_) => return self.enter(cx),
            Outcome::Ignored => return Outcome::Ignored,
            Outcome::Used => {}
        }
        self.leave(left);
        Outcome::Used
    }

    /// Leaves a row, and removes an empty name.
    fn leave(&mut self, left: SetUpRow) {
        let row = self.at();
        if let SetUpRow::Team(team) = left
            && row != left
            && self.teams[team].text().trim().is_empty()
        {
            self.teams.remove(team);
            self.put(match row {
                SetUpRow::Team(other) if other > team => SetUpRow::Team(other - 1),
                row => row,
            });
        }
    }

    /// Handles pasted text; in the row of a team, each line is one name.
    pub(super) fn paste(&mut self, pasted: &str) {
        let mut lines = pasted.lines();
        let first = lines.next().unwrap_or_default();
        if self.at() == SetUpRow::Add && !first.trim().is_empty() {
            self.add();
        }
        if let Some(field) = self.field() {
            field.paste(first);
        }
        if !matches!(self.at(), SetUpRow::Team(_)) {
            return;
        }
        for line in lines.filter(|line| !line.trim().is_empty()) {
            if self.teams.len() < MOST_TEAMS {
                self.add();
                if let Some(field) = self.field() {
                    field.paste(line);
                }
            }
        }
    }

    fn add(&mut self) {
        self.teams.push(TextField::new("", LONGEST));
        self.put(SetUpRow::Team(self.teams.len() - 1));
    }

    fn enter(&mut self, cx: &mut Context) -> Outcome<ClassScene> {
        let at = self.at();
        match at {
            // If no further name has been typed, Enter continues to the kind of round.
            SetUpRow::Add | SetUpRow::Class => self.put(SetUpRow::Kind(self.kind)),
            SetUpRow::Team(team) => {
                self.list.choose(team + 1);
                self.leave(at);
            }
            SetUpRow::Kind(kind) => {
                self.kind = kind;
                self.put(SetUpRow::Start(WayOfVoting::Teams));
            }
            SetUpRow::Start(way) => return self.start(way, cx),
            SetUpRow::Nicknames => self.nicknames = !self.nicknames,
            SetUpRow::Earlier => {
                return Outcome::Done(ClassScene::Earlier(KeptFiles::ask(ROUNDS, cx)));
            }
        }
        Outcome::Used
    }

    fn start(&mut self, way: WayOfVoting, cx: &mut Context) -> Outcome<ClassScene> {
        let names = match team_names(self.teams.iter().map(TextField::text)) {
            Ok(names) => names,
            // Counted hands are anonymous, and pupils on devices enter their names themselves, so
            // the teams are not needed.
            Err(_) if way != WayOfVoting::Teams => Vec::new(),
            Err(trouble) => {
                self.trouble = Some(format!("The teams: {trouble}."));
                return Outcome::Used;
            }
        };
        let Some(code) = self.chosen_code(cx) else {
            return Outcome::Used;
        };
        let round = match way {
            WayOfVoting::Teams => ClassRound::new(code, names),
            WayOfVoting::Tally => ClassRound::with_tally(code),
            WayOfVoting::Devices => ClassRound::with_devices(code).with_nicknames(self.nicknames),
        };
        let round = round.of_class(self.class.text());
        Outcome::Done(ClassScene::play(round, cx))
    }

    /// The code of the chosen round, with a new seed unless it was typed; `None` if what was typed
    /// is not a valid code, and the page then shows the error.
    fn chosen_code(&mut self, cx: &mut Context) -> Option<Code> {
        let code = match self.course(self.kind) {
            Some(kind) => Ok(cx.next_code(Course::new(kind))),
            None => Code::parse(self.code.text())
                .ok_or_else(|| NO_CODE.to_owned())
                .and_then(|code| code.with_own(&self.own)?.same_for_all()),
        };
        match code {
            Ok(code) => Some(code),
            Err(trouble) => {
                self.put(SetUpRow::Kind(RoundKind::Code));
                self.trouble = Some(format!("The code: {trouble}."));
                None
            }
        }
    }
}

/// The message about files of the teacher's own questions that were left out because of errors.
fn left_out(own: &Library) -> Option<String> {
    let first = own.problems.first()?;
    Some(match own.problems.len() {
        1 => format!("Left out of your own questions: {first}"),
        all => format!(
            "Files with errors in your own questions are left out. carrom concept check lists all \
             {all} errors. The first: {first}"
        ),
    })
}

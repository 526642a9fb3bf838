//! A class round in a file, from which it can be resumed: its state, then everything that has
//! happened since, one change per line.

use std::sync::Arc;

use serde::Serialize;
use strum::VariantArray;

use super::ballot::Vote;
use super::names::{NameTrouble, tidy};
use super::old_formats;
use super::round::{ClassChange, ClassRound, Then};
use super::step::{ClassPlace, ClassStep};
use super::way::WayOfVoting;
use crate::files::{Fields, FileErrors, Source, is_blank_name};
use crate::quiz::concepts::Library;
use crate::quiz::{Code, CourseKind, Question};

/// The format of new files: since format 6, people and votes are changes in JSON. [`old_formats`]
/// reads earlier ones.
const FORMAT: u32 = 6;

/// The largest file that is read, in bytes; the largest round takes about 600 kB, and its changes
/// are merged into the state at each step.
const LARGEST: usize = 1 << 22;

/// The contents of a file.
#[derive(Serialize)]
struct Written<'a> {
    format: u32,
    code: String,
    #[serde(skip_serializing_if = "str::is_empty")]
    class: &'a str,
    way: &'a str,
    /// Whether carrom gives nicknames to pupils' devices.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    nicknames: bool,
    /// The current question, counted from 1.
    number: usize,
    step: &'a str,
    /// The ids of the teacher's own questions, whose files may change.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    asked: Vec<&'a str>,
    /// The code for joining.
    #[serde(skip_serializing_if = "Option::is_none")]
    door: Option<String>,
    /// The address at which pupils' devices last found the round: "192.168.43.117:8090".
    #[serde(skip_serializing_if = "Option::is_none")]
    address: Option<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    then: Vec<Then>,
}

const FIELDS: [&str; 11] = [
    "format",
    "code",
    "class",
    "way",
    "nicknames",
    "number",
    "step",
    "asked",
    "door",
    "address",
    "then",
];

/// The complete part of a file: a crash may leave a partial last line.
fn whole(bytes: &[u8]) -> &[u8] {
    let end = bytes.iter().rposition(|byte| *byte == b'\n');
    let is_changes = |end: usize| bytes[..=end].windows(8).any(|it| it == b"[[then]]");
    match end {
        Some(end) if is_changes(end) => &bytes[..=end],
        _ => bytes,
    }
}

/// All values of a field, each with its name in files.
fn named<T: VariantArray + Copy + Into<&'static str>>() -> Vec<(&'static str, T)> {
    let all = T::VARIANTS.iter().copied();
    all.map(|it| (it.into(), it)).collect()
}

impl ClassRound {
    /// The largest file that is read, in bytes.
    pub const LARGEST_FILE: usize = LARGEST;

    /// The text of its file.
    ///
    /// # Errors
    /// The reason if it cannot be written, which does not happen in practice.
    pub fn text(&self) -> Result<String, String> {
        let written = Written {
            format: FORMAT,
            code: self.code().to_string(),
            class: self.class(),
            way: self.way().into(),
            nicknames: self.gives_nicknames(),
            number: self.place().question + 1,
            step: self.place().step.into(),
            asked: self.own_ids(),
            door: self.join_code().map(|code| code.to_string()),
            address: self.address().map(|address| address.to_string()),
            then: self.changes().iter().map(Then::from).collect(),
        };
        toml::to_string(&written).map_err(|error| error.to_string())
    }

    /// The shortest list of changes that leads to the current state.
    fn changes(&self) -> Vec<ClassChange> {
        let join = |name: &str, seat| {
            let name = name.to_owned();
            ClassChange::Join { seat, name }
        };
        let removed = self.joining.iter().flat_map(|joining| &joining.removed);
        let mut changes: Vec<_> = removed
            .flat_map(|it| [join(&it.name, it.seat), ClassChange::Remove { person: 0 }])
            .collect();
        let people = self.participants().iter();
        changes.extend(people.map(|it| join(it.name(), it.seat)));
        for question in 0..self.questions().len() {
            for vote in Vote::BOTH {
                let given = self.participants().iter().enumerate();
                changes.extend(given.filter_map(|(person, it)| {
                    let said = Some(it.ballot(question).given(vote)?);
                    Some(ClassChange::Vote {
                        question,
                        vote,
                        person,
                        said,
                    })
                }));
                changes.extend(self.tally(question, vote).map(|counts| ClassChange::Count {
                    question,
                    vote,
                    counts: Some(counts.to_vec()),
                }));
            }
        }
        changes
    }

    /// The ids of the questions, if they are a teacher's own.
    fn own_ids(&self) -> Vec<&str> {
        let own = matches!(self.code().course.kind, CourseKind::Own(_));
        let questions: &[Question] = if own { self.questions() } else { &[] };
        let ids = questions.iter().map(|question| question.figures.get("id"));
        ids.filter_map(|id| id?.as_str()).collect()
    }

    /// Reads a round from its file; `name` is the file's name in messages, and `own` contains the
    /// teacher's own questions.
    ///
    /// # Errors
    /// All errors found, if the file is not that of a round or has a newer format, if a field or a
    /// change in it is invalid, or if it uses a teacher's questions that are missing or have
    /// changed. A vote that does not fit its question is not an error: it is dropped, and
    /// [`dropped_votes`](Self::dropped_votes) counts it.
    pub fn read(name: &str, bytes: &[u8], own: &Arc<Library>) -> Result<Self, FileErrors> {
        let source = Source::of_bytes(name, whole(bytes), LARGEST)?;
        let formats = old_formats::OLDEST..=FORMAT;
        source.document("a class round", formats, &old_formats::FIELDS, |fields| {
            let last = FORMAT as usize;
            let is_old = fields.whole("format", "a format", 1..=last)? < last;
            let fields = match is_old {
                true => fields.clone(),
                false => fields.clone().only(&FIELDS),
            };
            let mut round = Self::begun_in(&fields, own)?;
            match is_old {
                true => old_formats::read(&fields, &mut round)?,
                false => round.read_changes(&fields)?,
            }
            if round.way() == WayOfVoting::Teams && round.participants().is_empty() {
                let name = if is_old { "teams" } else { "then" };
                return fields.refuse(name, NameTrouble::None.to_string());
            }
            round.goes_where_it_was(&fields)?;
            Some(round)
        })
    }

    /// The round in a file, before anybody has joined.
    fn begun_in(fields: &Fields, own: &Arc<Library>) -> Option<Self> {
        let code = fields.text_as("code", |code| match Code::parse(code) {
            Some(code) => code.with_own(own)?.same_for_all(),
            None => Err("expected the code of a round, such as mixed-7".into()),
        });
        let way = fields.or("way", WayOfVoting::default(), |name| {
            fields.word(name, &named())
        });
        let class = fields.or("class", String::new(), |name| {
            fields.text_as(name, |class| match tidy(class) {
                tidy if tidy == class || is_blank_name(class) => Ok(tidy),
                _ => Err("expected a name of at most 24 visible characters".into()),
            })
        });
        let asked = fields.or("asked", None, |name| fields.any_texts(name).map(Some));
        let join_code = fields.or("door", None, |name| {
            let parse = |text: &str| text.parse().map_err(|error| format!("{error}"));
            fields.text_as(name, parse).map(Some)
        });
        let address = fields.or("address", None, |name| {
            let expected = "expected an address, such as 192.168.43.117:8090";
            let parse = |text: &str| text.parse().map_err(|_| expected.to_owned());
            fields.text_as(name, parse).map(Some)
        });
        let nicknames = fields.or("nicknames", false, |name| {
            fields.parsed(name, "true or false")
        });
        let round = Self::voting(way?, code?).of_class(&class?);
        let mut round = round.with_nicknames(nicknames?);
        if asked?.is_some_and(|asked| round.own_ids() != asked) {
            let message = "expected your own questions unchanged, but their files have changed";
            return fields.refuse("asked", message);
        }
        let (join_code, address) = (join_code?, address?);
        if let Some(code) = join_code {
            round.open(code, address);
        }
        Some(round)
    }

    /// Applies the changes in the file of a round.
    fn read_changes(&mut self, fields: &Fields) -> Option<()> {
        let then = fields.or("then", Vec::new(), |name| {
            fields.tables(name, 0..=usize::MAX, &["change"])
        })?;
        for then in then {
            // A crash may leave a table without its `change` line.
            let line = then.or("change", None, |name| then.text_as(name, Ok).map(Some))?;
            if let Some(line) = line
                && let Err(message) =
                    self.take_from_file(ClassChange::read(line), ClassChange::is_vote(line))
            {
                then.refuse::<()>("change", message);
            }
        }
        Some(())
    }

    /// Applies a change from a file. A vote that does not fit is dropped and counted, because no
    /// later change depends on it.
    pub(super) fn take_from_file(
        &mut self,
        change: Result<ClassChange, String>,
        is_vote: bool,
    ) -> Result<(), String> {
        match change.and_then(|change| self.change(&change)) {
            Err(_) if is_vote => {
                self.dropped += 1;
                Ok(())
            }
            done => done,
        }
    }

    /// Goes to the stored position or, if there is none, to the first question without votes.
    fn goes_where_it_was(&mut self, fields: &Fields) -> Option<()> {
        let last = self.questions().len().saturating_sub(1);
        let question = fields.or("number", self.begun().min(last), |name| {
            let expected = format!("the number of a question, 1 to {}", last + 1);
            Some(fields.whole(name, &expected, 1..=last + 1)? - 1)
        });
        let step = fields.or("step", ClassStep::default(), |name| {
            fields.word(name, &named())
        });
        self.go(ClassPlace {
            question: question?,
            step: step?,
        });
        Some(())
    }
}

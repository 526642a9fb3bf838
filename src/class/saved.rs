//! A class round as it is kept in a file, so that it can be taken up again.

use std::sync::Arc;

use serde::Serialize;
use strum::VariantArray;

use super::ballot::{Door, Removed};
use super::names::{kept_name, names_for, tidy};
use super::{ClassChange, ClassPlace, ClassRound, ClassStep, NameTrouble, Said, Vote, WayOfVoting};
use crate::files::{Fields, FileErrors, Source, is_blank_name};
use crate::quiz::concepts::Library;
use crate::quiz::{Code, CourseKind, Question};

/// The format of the files that are written now: since the second there are ways of voting,
/// people with devices, and changes behind the round; since the third the name of the class; since
/// the fourth who was removed; since the fifth where devices find it.
const FORMAT: u32 = 5;
/// The oldest format that still opens.
const OLDEST: u32 = 1;

/// Largest file that is read, in bytes; the fullest round takes some 600 kB, and the changes
/// behind it are taken into it at each step.
const LARGEST: usize = 1 << 22;

/// What stands in a file.
#[derive(Serialize)]
struct Written<'a> {
    format: u32,
    code: String,
    /// What the class is called.
    #[serde(skip_serializing_if = "str::is_empty")]
    class: &'a str,
    way: &'a str,
    teams: &'a [String],
    /// The question the class is at, counted from 1.
    number: usize,
    step: &'a str,
    /// The ids of questions of the teacher's own, whose files may change.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    asked: Vec<&'a str>,
    /// The code that lets pupils in.
    #[serde(skip_serializing_if = "Option::is_none")]
    door: Option<String>,
    /// Where their devices found it last: "192.168.43.117:8090".
    #[serde(skip_serializing_if = "Option::is_none")]
    address: Option<String>,
    /// What brings each of them back, empty for whom nothing does.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    seats: Vec<String>,
    /// Who was removed: what would bring them back, or a hyphen, and their name.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    removed: Vec<String>,
    question: Vec<Votes>,
}

/// The votes on a question, a text a team, empty where there is none; or how many were for
/// each choice.
#[derive(Serialize)]
struct Votes {
    #[serde(skip_serializing_if = "Vec::is_empty")]
    first: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    second: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    first_counts: Vec<u32>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    second_counts: Vec<u32>,
}

/// What is appended to a file: changes since it was written.
#[derive(Serialize)]
struct Appended {
    then: [Changes; 1],
}

#[derive(Serialize)]
struct Changes {
    changes: Vec<String>,
}

/// The fields of a file.
const FIELDS: [&str; 14] = [
    "format", "code", "class", "way", "teams", "number", "step", "asked", "door", "address",
    "seats", "removed", "question", "then",
];
/// The fields of a question in it.
const OF_QUESTION: [&str; 4] = ["first", "second", "first_counts", "second_counts"];

/// The text that is appended to the file of a round when this has changed.
///
/// # Errors
/// None that can be met in practice; the reason, should it not be writable.
pub fn appended(changes: &[ClassChange]) -> Result<String, String> {
    let changes = changes.iter().map(ToString::to_string).collect();
    let then = [Changes { changes }];
    toml::to_string(&Appended { then }).map_err(|error| error.to_string())
}

/// What of a file is whole: a machine that stops may leave a part of what was appended last.
fn whole(bytes: &[u8]) -> &[u8] {
    let end = bytes.iter().rposition(|byte| *byte == b'\n');
    let is_changes = |end: usize| bytes[..=end].windows(8).any(|it| it == b"[[then]]");
    match end {
        Some(end) if is_changes(end) => &bytes[..=end],
        _ => bytes,
    }
}

/// Who was removed, as a file says it.
fn removed_of(text: &str) -> Option<Removed> {
    let (seat, name) = text.split_once(' ')?;
    let seat = match seat {
        "-" => None,
        seat => Some(seat.parse().ok()?),
    };
    let name = name.to_owned();
    (tidy(&name) == name && !name.is_empty()).then_some(Removed { seat, name })
}

impl ClassRound {
    /// Largest file that is read, in bytes.
    pub const LARGEST_FILE: usize = LARGEST;

    /// The text of the file that keeps it.
    ///
    /// # Errors
    /// None that can be met in practice; the reason, should it not be writable.
    pub fn text(&self) -> Result<String, String> {
        let votes = |question: usize, vote: Vote| {
            let given = |team| self.ballot(question, team).given(vote);
            let text = |team| given(team).map(Said::to_text).unwrap_or_default();
            (0..self.teams().len()).map(text).collect()
        };
        let counts = |question: usize, vote: Vote| {
            let counts = self.tally(question, vote);
            counts.map(<[u32]>::to_vec).unwrap_or_default()
        };
        let door = self.door.as_ref();
        let token = |seat: &Option<_>| seat.map(String::from).unwrap_or_default();
        let removed = |it: &Removed| match it.seat {
            Some(seat) => format!("{seat} {}", it.name),
            None => format!("- {}", it.name),
        };
        let written = Written {
            format: FORMAT,
            code: self.code().to_string(),
            class: self.class(),
            way: self.way().into(),
            teams: self.teams(),
            number: self.place().question + 1,
            step: self.place().step.into(),
            asked: self.own_ids(),
            door: door.map(|door| door.code.into()),
            address: self.address().map(|address| address.to_string()),
            seats: door
                .map(|door| door.seats.iter().map(token).collect())
                .unwrap_or_default(),
            removed: door
                .map(|door| door.removed.iter().map(removed).collect())
                .unwrap_or_default(),
            question: (0..self.questions().len())
                .map(|question| Votes {
                    first: votes(question, Vote::First),
                    second: votes(question, Vote::Second),
                    first_counts: counts(question, Vote::First),
                    second_counts: counts(question, Vote::Second),
                })
                .collect(),
        };
        toml::to_string(&written).map_err(|error| error.to_string())
    }

    /// The ids of the questions, if they are a teacher's own.
    fn own_ids(&self) -> Vec<&str> {
        let own = matches!(self.code().course.kind, CourseKind::Own(_));
        let questions: &[Question] = if own { self.questions() } else { &[] };
        let ids = questions.iter().map(|question| question.figures.get("id"));
        ids.filter_map(|id| id?.as_str()).collect()
    }

    /// Reads such a file; `name` stands for it in messages, and `own` are the questions of
    /// the teacher's own there are.
    ///
    /// # Errors
    /// All that is wrong with it: that it is no such file, or a newer one; that its code or
    /// its teams are none; that it asks questions of the teacher's own that are not there
    /// or have changed. A vote that does not fit its question is no such fault: it is dropped,
    /// and [`dropped_votes`](Self::dropped_votes) counts it.
    pub fn read(name: &str, bytes: &[u8], own: &Arc<Library>) -> Result<Self, FileErrors> {
        let source = Source::of_bytes(name, whole(bytes), LARGEST)?;
        source.document_since("a class round", OLDEST..=FORMAT, &FIELDS, |fields| {
            Self::from_fields(fields, own)
        })
    }

    fn from_fields(fields: &Fields, own: &Arc<Library>) -> Option<Self> {
        let code = fields.text_as("code", |code| match Code::parse(code) {
            Some(code) => code.with_own(own)?.same_for_all(),
            None => Err("expected the code of a round, such as mixed-7".into()),
        });
        let way = fields.or("way", WayOfVoting::default(), |name| {
            let ways = WayOfVoting::VARIANTS.iter().map(|way| (way.into(), *way));
            fields.word(name, &ways.collect::<Vec<_>>())
        })?;
        let teams = fields.any_texts("teams").and_then(|texts| {
            let mut found: Vec<String> = texts.iter().map(|it| (*it).to_owned()).collect();
            for at in 0..found.len() {
                found[at] = kept_name(&found[at], &found);
            }
            match names_for(way, found.iter().map(String::as_str)) {
                Ok(teams) if teams.is_empty() && way == WayOfVoting::Teams => {
                    fields.refuse("teams", NameTrouble::None.to_string())
                }
                Ok(teams) if teams == found => Some(teams),
                Ok(_) => fields.refuse("teams", "expected names of 1 to 24 visible letters"),
                Err(error) => fields.refuse("teams", error.to_string()),
            }
        });
        let asked = fields.or("asked", None, |name| fields.any_texts(name).map(Some));
        let votes = fields.or("question", Vec::new(), |name| {
            fields.tables(name, 0..=usize::MAX, &OF_QUESTION)
        });
        let then = fields.or("then", Vec::new(), |name| {
            fields.tables(name, 0..=usize::MAX, &["changes"])
        });
        let class = fields.or("class", String::new(), |name| {
            fields.text_as(name, |class| match tidy(class) {
                tidy if tidy == class || is_blank_name(class) => Ok(tidy),
                _ => Err("expected a name of at most 24 visible letters".into()),
            })
        });
        let mut round = Self::voting(way, code?, teams?).of_class(&class?);
        round.door = Self::door_of(fields, round.teams().len())?;
        if asked?.is_some_and(|asked| round.own_ids() != asked) {
            let message =
                "expected the questions of your own as they were; their files have changed";
            return fields.refuse("asked", message);
        }
        let votes = votes?;
        for (question, votes) in votes.iter().enumerate() {
            for (vote, field) in Vote::BOTH.into_iter().zip(["first", "second"]) {
                let said = votes.or(field, Vec::new(), |name| votes.any_texts(name));
                let said = said.unwrap_or_default();
                for (team, text) in said.into_iter().enumerate() {
                    if let Err(message) = round.take(question, team, vote, text) {
                        votes.refuse_item::<()>(field, team, message);
                    }
                }
            }
        }
        for (question, votes) in votes.iter().enumerate() {
            for (vote, field) in Vote::BOTH
                .into_iter()
                .zip(["first_counts", "second_counts"])
            {
                let expected = "how many were for each choice";
                let counts: Option<Vec<u32>> = votes.or(field, None, |name| {
                    votes.all_parsed(name, expected).map(Some)
                })?;
                if counts.is_some_and(|counts| !round.count(question, vote, Some(&counts))) {
                    return votes.refuse(field, format!("expected {expected}"));
                }
            }
        }
        for then in then? {
            // What a machine that stopped has left may lack them.
            let changes = then.or("changes", Vec::new(), |name| then.any_texts(name))?;
            for (at, text) in changes.into_iter().enumerate() {
                let change = ClassChange::parse(text)
                    .ok_or_else(|| format!("expected a change, found \"{}\"", text.escape_debug()));
                let change = change.map(|change| round.with_kept_name(change));
                match change.and_then(|change| round.change(&change)) {
                    Ok(()) => {}
                    // Nothing after it depends on it.
                    Err(_) if ClassChange::is_vote(text) => round.dropped += 1,
                    Err(message) => drop(then.refuse_item::<()>("changes", at, message)),
                }
            }
        }
        let last = round.questions().len().saturating_sub(1);
        // Without one, the first question that nobody has voted on.
        let question = fields.or("number", round.begun().min(last), |name| {
            let expected = format!("the number of a question, 1 to {}", last + 1);
            Some(fields.whole(name, &expected, 1..=last + 1)? - 1)
        });
        let step = fields.or("step", ClassStep::default(), |name| {
            let steps = ClassStep::VARIANTS.iter().map(|step| (step.into(), *step));
            fields.word(name, &steps.collect::<Vec<_>>())
        });
        round.go(ClassPlace {
            question: question?,
            step: step?,
        });
        Some(round)
    }

    /// The door of a file, if it has one.
    #[expect(clippy::option_option, reason = "faults are noted; no door is none")]
    fn door_of(fields: &Fields, people: usize) -> Option<Option<Door>> {
        let code = fields.or("door", None, |name| {
            fields
                .text_as(name, |text| {
                    text.parse().map_err(|error| format!("{error}"))
                })
                .map(Some)
        })?;
        let Some(code) = code else {
            return Some(None);
        };
        let address = fields.or("address", None, |name| {
            let expected = "expected an address, such as 192.168.43.117:8090";
            let parse = |text: &str| text.parse().map_err(|_| expected.to_owned());
            fields.text_as(name, parse).map(Some)
        })?;
        let texts = fields.or("seats", Vec::new(), |name| fields.any_texts(name))?;
        let seats = texts.iter().map(|text| match text.is_empty() {
            true => Ok(None),
            false => text.parse().map(Some),
        });
        let texts = fields.or("removed", Vec::new(), |name| fields.any_texts(name))?;
        let removed: Option<Vec<_>> = texts.into_iter().map(removed_of).collect();
        let Some(removed) = removed else {
            return fields.refuse("removed", "expected a hyphen or a seat, and a name");
        };
        match seats.collect::<Result<Vec<_>, _>>() {
            Ok(seats) if seats.len() == people => Some(Some(Door {
                code,
                address,
                seats,
                removed,
            })),
            Ok(_) => fields.refuse("seats", format!("expected {people} texts")),
            Err(expected) => fields.refuse("seats", expected),
        }
    }

    /// A change from a file, with a name that can be seen.
    fn with_kept_name(&self, mut change: ClassChange) -> ClassChange {
        if let ClassChange::Join { name, .. } | ClassChange::Rename { name, .. } = &mut change {
            *name = kept_name(name, self.teams());
        }
        change
    }

    /// Takes a vote from a file; one that does not fit its question is dropped and counted.
    fn take(&mut self, question: usize, team: usize, vote: Vote, text: &str) -> Result<(), String> {
        if question >= self.questions().len() || team >= self.teams().len() {
            return Err(format!(
                "expected votes of {} teams on {} questions, found more",
                self.teams().len(),
                self.questions().len()
            ));
        }
        if text.is_empty() {
            return Ok(());
        }
        let said = Said::parse(text);
        if said.is_none() || !self.put(question, team, vote, said) {
            self.dropped += 1;
        }
        Ok(())
    }
}

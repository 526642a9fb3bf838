//! Files of formats 1 to 5, as earlier versions wrote them: names in a list, votes in one table per
//! question, and changes in a separate syntax. They must always open, so this module never
//! changes.

use super::ballot::{Said, Vote};
use super::names::{kept_name, names_for, tidy};
use super::round::{ClassChange, ClassRound, Removed};
use crate::files::Fields;

/// The oldest format that still opens.
pub(super) const OLDEST: u32 = 1;

pub(super) const FIELDS: [&str; 15] = [
    "format",
    "code",
    "class",
    "way",
    "nicknames",
    "teams",
    "number",
    "step",
    "asked",
    "door",
    "address",
    "seats",
    "removed",
    "question",
    "then",
];
/// The fields of a question in a file.
const OF_QUESTION: [&str; 4] = ["first", "second", "first_counts", "second_counts"];

/// Reads people, votes and changes into an empty round.
pub(super) fn read(fields: &Fields, round: &mut ClassRound) -> Option<()> {
    read_people(fields, round)?;
    let tables = |name, known: &[&'static str]| {
        fields.or(name, Vec::new(), |name| {
            fields.tables(name, 0..=usize::MAX, known)
        })
    };
    for (question, votes) in tables("question", &OF_QUESTION)?.iter().enumerate() {
        for (vote, [said, counts]) in Vote::BOTH
            .into_iter()
            .zip([["first", "first_counts"], ["second", "second_counts"]])
        {
            let texts = votes.or(said, Vec::new(), |name| votes.any_texts(name));
            for (person, text) in texts.unwrap_or_default().into_iter().enumerate() {
                if let Err(message) = take_vote(round, question, person, vote, text) {
                    votes.refuse_item::<()>(said, person, message);
                }
            }
            let expected = "the number of votes for each choice";
            let given: Option<Vec<u32>> = votes.or(counts, None, |name| {
                votes.all_parsed(name, expected).map(Some)
            })?;
            if given.is_some_and(|given| !round.count(question, vote, Some(&given))) {
                return votes.refuse(counts, format!("expected {expected}"));
            }
        }
    }
    for then in tables("then", &["changes"])? {
        // A crash may leave a table without its changes.
        let changes = then.or("changes", Vec::new(), |name| then.any_texts(name))?;
        for (at, text) in changes.into_iter().enumerate() {
            let change = change(text)
                .map(|change| with_kept_name(round, change))
                .ok_or_else(|| format!("expected a change, found \"{}\"", text.escape_debug()));
            if let Err(message) = round.take_from_file(change, text.starts_with("vote ")) {
                then.refuse_item::<()>("changes", at, message);
            }
        }
    }
    Some(())
}

/// Reads the participants, and those who were removed.
fn read_people(fields: &Fields, round: &mut ClassRound) -> Option<()> {
    let texts = fields.any_texts("teams")?;
    let mut names: Vec<String> = texts.iter().map(|it| (*it).to_owned()).collect();
    for at in 0..names.len() {
        let taken: Vec<&str> = names.iter().map(String::as_str).collect();
        names[at] = kept_name(&names[at], &taken);
    }
    match names_for(round.way(), names.iter().map(String::as_str)) {
        Ok(tidied) if tidied == names => {}
        Ok(_) => return fields.refuse("teams", "expected names of 1 to 24 visible letters"),
        Err(error) => return fields.refuse("teams", error.to_string()),
    }
    let Some(joining) = &mut round.joining else {
        names
            .into_iter()
            .for_each(|name| round.seat_new(name, None));
        return Some(());
    };
    let removed = fields.or("removed", Vec::new(), |name| fields.any_texts(name))?;
    let Some(removed) = removed.into_iter().map(removed_of).collect() else {
        return fields.refuse("removed", "expected a hyphen or a seat, and a name");
    };
    joining.removed = removed;
    let seats = fields.or("seats", Vec::new(), |name| fields.any_texts(name))?;
    if seats.len() != names.len() {
        return fields.refuse("seats", format!("expected {} texts", names.len()));
    }
    for (name, seat) in names.into_iter().zip(seats) {
        let seat = match seat.is_empty() {
            true => Ok(None),
            false => seat.parse().map(Some),
        };
        match seat {
            Ok(seat) => round.seat_new(name, seat),
            Err(expected) => return fields.refuse("seats", expected),
        }
    }
    Some(())
}

/// A removed participant: the seat token, or a hyphen, and the name.
fn removed_of(text: &str) -> Option<Removed> {
    let (seat, name) = text.split_once(' ')?;
    let seat = match seat {
        "-" => None,
        seat => Some(seat.parse().ok()?),
    };
    let name = name.to_owned();
    (tidy(&name) == name && !name.is_empty()).then_some(Removed { seat, name })
}

/// Adds a vote; one that does not fit its question is dropped and counted.
fn take_vote(
    round: &mut ClassRound,
    question: usize,
    person: usize,
    vote: Vote,
    text: &str,
) -> Result<(), String> {
    let (questions, people) = (round.questions().len(), round.participants().len());
    if question >= questions || person >= people {
        return Err(format!(
            "expected votes of {people} teams on {questions} questions, found more"
        ));
    }
    let Some(said) = Said::parse(text) else {
        round.dropped += usize::from(!text.is_empty());
        return Ok(());
    };
    let change = ClassChange::Vote {
        question,
        vote,
        person,
        said: Some(said),
    };
    round.take_from_file(Ok(change), true)
}

/// The change; a name without a visible letter is replaced by a free one.
fn with_kept_name(round: &ClassRound, mut change: ClassChange) -> ClassChange {
    if let ClassChange::Join { name, .. } | ClassChange::Rename { name, .. } = &mut change {
        *name = kept_name(name, &round.teams());
    }
    change
}

/// Reads the text of a change, such as "vote 3 first 17 rays 60 still", in which questions and
/// people are counted from 1; `None` if the text is not a change.
fn change(text: &str) -> Option<ClassChange> {
    let from_one = |text: &str| text.parse::<usize>().ok()?.checked_sub(1);
    let (what, rest) = text.split_once(' ')?;
    let (first, behind) = match rest.split_once(' ') {
        Some((first, behind)) => (first, Some(behind)),
        None => (rest, None),
    };
    Some(match (what, behind) {
        ("vote", Some(behind)) => {
            let mut parts = behind.splitn(3, ' ');
            ClassChange::Vote {
                question: from_one(first)?,
                vote: parts.next()?.parse().ok()?,
                person: from_one(parts.next()?)?,
                said: match parts.next() {
                    Some(said) => Some(Said::parse(said)?),
                    None => None,
                },
            }
        }
        ("count", Some(behind)) => {
            let (vote, counts) = behind.split_once(' ').unwrap_or((behind, ""));
            let counts = counts.split(' ').filter(|count| !count.is_empty());
            let counts: Result<Vec<u32>, _> = counts.map(str::parse).collect();
            ClassChange::Count {
                question: from_one(first)?,
                vote: vote.parse().ok()?,
                counts: Some(counts.ok()?).filter(|counts| !counts.is_empty()),
            }
        }
        ("join", Some(name)) => ClassChange::Join {
            seat: Some(first.parse().ok()?),
            name: name.to_owned(),
        },
        ("rename", Some(name)) => ClassChange::Rename {
            person: from_one(first)?,
            name: name.to_owned(),
        },
        ("remove", None) => ClassChange::Remove {
            person: from_one(first)?,
        },
        ("readmit", None) => ClassChange::Readmit {
            removed: from_one(first)?,
        },
        ("vacate", None) => ClassChange::Vacate {
            person: from_one(first)?,
        },
        ("merge", Some(into)) => ClassChange::Merge {
            from: from_one(first)?,
            into: from_one(into)?,
        },
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::change;

    #[test]
    fn only_valid_changes_are_read() {
        for text in [
            "vote 3 first 17 rays -0.5 still",
            "vote 3 second 17 sure choice 2",
            "vote 3 first 1",
            "count 1 first 4 17 9 2",
            "count 1 second",
            "join 00000000000000000000000000000007 Ada Lovelace",
            "rename 3 Bo  <b>",
            "remove 250",
            "readmit 1",
            "vacate 250",
            "merge 4 1",
        ] {
            assert!(change(text).is_some(), "{text}");
        }
        for text in [
            "",
            "vote",
            "vote 0 first 1",
            "vote 1 third 1",
            "vote 1 first 1 ",
            "vote 1 first 1 rays",
            "count 1 first x",
            "join 12 Ada",
            "remove 1 2",
            "merge 1",
            "leave 1",
        ] {
            assert_eq!(change(text), None, "{text}");
        }
    }
}

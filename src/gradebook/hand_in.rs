//! The file that a pupil hands in.

use std::collections::HashMap;

use indexmap::IndexSet;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::files::{BYTE_ORDER_MARK, LONGEST_QUOTE, escape_control, newer, quoted, short_name};
use crate::progress::{Attempt, LESSON, ROUND};
use crate::quiz::{Code, Course, CourseKind, Family, Topic};

/// The latest version of the format. It adds the predictions made at the table and in levels; a
/// file without them is written in the first version, which every carrom reads.
const FORMAT: u32 = 2;
/// The value that identifies such a file.
const KIND: &str = "hand-in";
/// The maximum number of letters in a name.
const LONGEST: usize = 60;

/// The maximum number of letters in a topic, which may be the title of a chapter.
const LONGEST_TOPIC: usize = 200;

/// All answers of a pupil, with name and class.
#[derive(Debug, Clone, PartialEq)]
pub struct HandIn {
    /// The pupil's name.
    pub name: String,
    /// The class, as the pupil wrote it; it may be empty.
    pub class: String,
    /// The answers in order.
    pub attempts: Vec<Attempt>,
}

/// The contents of a file; each answer is an [`Attempt`], read separately.
#[derive(Serialize, Deserialize)]
struct HandInFile<A> {
    format: u32,
    carrom: String,
    name: String,
    #[serde(default)]
    class: String,
    /// The codes of the rounds, for human readers of the file.
    #[serde(default)]
    codes: Vec<String>,
    /// The sum of the points for accuracy, 0 to 10 per answer, for human readers of the file.
    #[serde(default)]
    points: f64,
    answers: Vec<A>,
}

impl HandIn {
    /// The largest file that is read, in bytes; ten thousand answers are about 6 MB.
    pub(crate) const LARGEST_FILE: usize = 1 << 24;

    /// A pupil's hand-in. Names are tidied; a name without a visible letter becomes empty. Answers
    /// that a teacher's carrom would refuse, for example after damage, are left out, because
    /// otherwise it would refuse the whole file.
    pub fn new(name: &str, class: &str, attempts: Vec<Attempt>) -> Self {
        let mut known = KnownTopics::default();
        let sound = attempts.into_iter();
        let sound = sound.filter_map(|it| checked(it, &mut known).ok());
        Self::of(name, class, sound.collect())
    }

    fn of(name: &str, class: &str, attempts: Vec<Attempt>) -> Self {
        Self {
            name: short_name(name, LONGEST),
            class: short_name(class, LONGEST),
            attempts,
        }
    }

    /// The name of the file: letters, digits and hyphens, which any system accepts.
    pub fn file_name(&self) -> String {
        format!("{}.json", self.file_stem())
    }

    /// The file name without its extension.
    pub fn file_stem(&self) -> String {
        let plain = |c: char| match c.is_ascii_alphanumeric() {
            true => c.to_ascii_lowercase(),
            false => '-',
        };
        let name: String = self.name.chars().map(plain).collect();
        match name.trim_matches('-') {
            "" => KIND.into(),
            name => format!("{KIND}-{name}"),
        }
    }

    /// The text of the file.
    ///
    /// # Errors
    /// The reason if the text cannot be written, which does not happen in practice.
    pub fn text(&self) -> Result<String, String> {
        let text = serde_json::to_string_pretty(&self.written());
        text.map(|text| text + "\n")
            .map_err(|error| error.to_string())
    }

    /// The contents of the file, for sending.
    ///
    /// # Errors
    /// The same as for [`Self::text`].
    pub fn value(&self) -> Result<Value, String> {
        serde_json::to_value(self.written()).map_err(|error| error.to_string())
    }

    fn written(&self) -> HandInFile<Attempt> {
        let codes: IndexSet<String> = self.attempts.iter().map(Attempt::round).collect();
        let points: f64 = self.attempts.iter().map(Attempt::points).sum();
        let is_in_first = |it: &Attempt| it.is_of_quiz() || it.family == LESSON;
        let every_carrom_reads_it = self.attempts.iter().all(is_in_first);
        HandInFile {
            format: if every_carrom_reads_it { 1 } else { FORMAT },
            carrom: KIND.into(),
            name: self.name.clone(),
            class: self.class.clone(),
            codes: codes.into_iter().collect(),
            points: (10.0 * points).round() / 10.0,
            answers: self.attempts.clone(),
        }
    }

    /// Reads such a file.
    ///
    /// # Errors
    /// The reason, if the file is not a complete hand-in, is from a newer carrom, has no name, or
    /// has an impossible answer.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        if bytes.len() > Self::LARGEST_FILE {
            return Err("it is too large for a hand-in".into());
        }
        // Some editors and mail programs put a byte order mark before the text.
        let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
        // The kind of file and its format are checked first, whatever else is wrong.
        let value = serde_json::from_slice(bytes)
            .map_err(|error| format!("it is damaged or not a hand-in: {}", short(&error)))?;
        Self::of_value(value)
    }

    /// Reads a hand-in that was sent.
    ///
    /// # Errors
    /// The same as for [`Self::read`].
    pub(crate) fn of_value(value: Value) -> Result<Self, String> {
        let kind = value.get("carrom").and_then(Value::as_str);
        let format = value.get("format").and_then(Value::as_u64);
        let (Some(KIND), Some(format)) = (kind, format) else {
            return Err("expected a file written by carrom hand-in".into());
        };
        if format > FORMAT.into() {
            return Err(newer(format!("format {format}"), FORMAT));
        }
        let written: HandInFile<Value> = serde_json::from_value(value)
            .map_err(|error| format!("it is damaged: {}", short(&error)))?;
        let mut known = KnownTopics::default();
        let attempts = { 1.. }.zip(written.answers).map(|(number, answer)| {
            let read = serde_json::from_value(answer).map_err(|error| short(&error));
            let player = written.name.clone();
            read.and_then(|read| checked(Attempt { player, ..read }, &mut known))
                .map_err(|why| format!("it is damaged: answer {number} is impossible: {why}"))
        });
        let attempts = attempts.collect::<Result<_, _>>()?;
        let hand_in = Self::of(&written.name, &written.class, attempts);
        match hand_in.name.is_empty() {
            true => Err("it has no name".into()),
            false => Ok(hand_in),
        }
    }
}

/// Whether a topic belongs to a family. The results are cached, because a file has thousands of
/// answers on few topics.
type KnownTopics = HashMap<(Family, String), bool>;

/// Checks that carrom could have stored this answer, and writes its round and topic as carrom does.
///
/// Hand-ins become headings and cells of the teacher's tables, so every name is checked or tidied
/// here.
///
/// # Errors
/// What is impossible about the answer.
fn checked(mut attempt: Attempt, known: &mut KnownTopics) -> Result<Attempt, String> {
    if let Some(fault) = attempt.fault() {
        return Err(fault.into());
    }
    let code = name_round(&mut attempt)?;
    let most = match &code {
        _ if !attempt.is_of_quiz() => u32::MAX as usize,
        Some(code) => code.course.count,
        None => Course::MOST,
    };
    if !(1..=most).contains(&(attempt.number as usize)) {
        return Err(format!("its round has no question {}", attempt.number));
    }
    if attempt.family != LESSON {
        let family = match attempt.is_of_quiz() {
            true => Family::with_id(&attempt.family),
            false => Some(Family::WhereTo),
        };
        let id = &attempt.family;
        let unknown = || format!("its family is {}, which is unknown", quoted(id));
        let family = family.ok_or_else(unknown)?;
        let is_own = code.is_some_and(|code| {
            matches!(code.course.kind, CourseKind::Own(_) | CourseKind::Set(_))
        });
        // The topic of a teacher's own question is the name of its file.
        let is_free = is_own && family == Family::Concept;
        if !is_free && !is_topic_of(&attempt.topic, family, known) {
            let topic = quoted(&attempt.topic);
            return Err(format!("its topic is {topic}, which is not in its family"));
        }
    }
    attempt.topic = short_name(&attempt.topic, LONGEST_TOPIC);
    Ok(attempt)
}

/// Rewrites the name of an answer's round as carrom writes it, and returns the code of the round.
fn name_round(attempt: &mut Attempt) -> Result<Option<Code>, String> {
    // Earlier versions stored only the seed.
    let Some(round) = attempt.question.get_mut(ROUND) else {
        return Ok(None);
    };
    let noted = round.as_str().unwrap_or_default();
    let (name, code) = Code::read_noted(noted).map_err(|_| {
        let shown = round.as_str().map_or_else(|| round.to_string(), Into::into);
        format!("its round is {}, which is not a code", quoted(&shown))
    })?;
    if name != noted {
        *round = name.into();
    }
    Ok(code)
}

fn is_topic_of(topic: &str, family: Family, known: &mut KnownTopics) -> bool {
    let families = || Topic::with_id(topic.to_owned()).families();
    let known = known.entry((family, topic.to_owned()));
    *known.or_insert_with(|| families().contains(&family))
}

/// Shortens serde's message about a file, because it may quote the whole file.
fn short(error: &serde_json::Error) -> String {
    let message = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    match message.strip_suffix(&place) {
        Some(what) => escape_control(what, LONGEST_QUOTE) + &place,
        None => escape_control(&message, LONGEST_QUOTE),
    }
}

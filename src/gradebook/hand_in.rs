//! The file that a pupil hands in.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::files::{newer, tidy_name};
use crate::progress::{Attempt, LESSON};
use crate::quiz::{Code, Confidence, Family, Grade, NoCode};

use super::round_of;

/// The format that is written.
const FORMAT: u32 = 1;
/// What says that a file is one.
const KIND: &str = "hand-in";
/// Most letters of a name.
const LONGEST: usize = 60;

/// Most letters of a topic, which may be the title of a chapter.
const LONGEST_TOPIC: usize = 200;

/// All answers of a pupil, with who that is.
#[derive(Debug, Clone, PartialEq)]
pub struct HandIn {
    /// The pupil's name.
    pub name: String,
    /// The class, as the pupil calls it; perhaps empty.
    pub class: String,
    /// What was answered, in the order of the answers.
    pub attempts: Vec<Attempt>,
}

/// What stands in a file.
#[derive(Serialize, Deserialize)]
struct Written {
    format: u32,
    carrom: String,
    name: String,
    #[serde(default)]
    class: String,
    /// The codes of the rounds, for who looks into the file.
    #[serde(default)]
    codes: Vec<String>,
    /// 0 to 10 for each answer, by how near it was, for who looks into the file.
    #[serde(default)]
    points: f64,
    answers: Vec<WrittenAnswer>,
}

/// An answer in a file: an [`Attempt`] without its player.
#[derive(Serialize, Deserialize)]
struct WrittenAnswer {
    #[serde(default)]
    time_s: Option<i64>,
    family: String,
    topic: String,
    seed: u64,
    number: u32,
    question: Map<String, Value>,
    answer: Map<String, Value>,
    truth: Map<String, Value>,
    #[serde(default)]
    error_deg: Option<f64>,
    credit: f64,
    right: bool,
    #[serde(default)]
    confidence: Option<String>,
    #[serde(default)]
    misconception: Option<String>,
}

impl HandIn {
    /// Largest file that is read, in bytes; ten thousand answers take some 6 MB.
    pub const LARGEST_FILE: usize = 1 << 24;

    /// The file of a pupil. Names are made presentable; one without a visible letter stays
    /// empty.
    pub fn new(name: &str, class: &str, attempts: Vec<Attempt>) -> Self {
        Self {
            name: tidy(name),
            class: tidy(class),
            attempts,
        }
    }

    /// What the file is called: letters and digits that any system takes.
    pub fn file_name(&self) -> String {
        format!("{}.json", self.file_stem())
    }

    /// The same without its ending.
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
    /// None that can be met in practice; the reason, should it not be writable.
    pub fn text(&self) -> Result<String, String> {
        let text = serde_json::to_string_pretty(&self.written());
        text.map(|text| text + "\n")
            .map_err(|error| error.to_string())
    }

    /// The same, to be sent.
    ///
    /// # Errors
    /// As for [`Self::text`].
    pub fn value(&self) -> Result<Value, String> {
        serde_json::to_value(self.written()).map_err(|error| error.to_string())
    }

    fn written(&self) -> Written {
        let figures = |text: &str| serde_json::from_str(text).unwrap_or_default();
        let answer = |attempt: &Attempt| WrittenAnswer {
            time_s: attempt.time_s,
            family: attempt.family.clone(),
            topic: attempt.topic.clone(),
            seed: attempt.seed,
            number: attempt.number,
            question: figures(&attempt.question),
            answer: figures(&attempt.answer),
            truth: figures(&attempt.truth),
            error_deg: attempt.error_deg,
            credit: attempt.credit,
            right: attempt.right,
            confidence: attempt.confidence.map(|it| it.id().to_owned()),
            misconception: attempt.misconception.clone(),
        };
        let mut codes: Vec<String> = Vec::new();
        for round in self.attempts.iter().map(round_of) {
            if !codes.contains(&round) {
                codes.push(round);
            }
        }
        let credit: f64 = self.attempts.iter().map(|it| it.credit).sum();
        Written {
            format: FORMAT,
            carrom: KIND.into(),
            name: self.name.clone(),
            class: self.class.clone(),
            codes,
            points: (10.0 * Grade::MOST * credit).round() / 10.0,
            answers: self.attempts.iter().map(answer).collect(),
        }
    }

    /// Reads such a file.
    ///
    /// # Errors
    /// Why it is none, in words: not a whole hand-in, a newer one, one without a name, an answer
    /// that cannot be.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        if bytes.len() > Self::LARGEST_FILE {
            return Err("it is too large for a hand-in".into());
        }
        // Some editors and mail programs put a byte order mark before a text.
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        // Whatever else is in it: what it is and how new it is comes first.
        let value = serde_json::from_slice(bytes)
            .map_err(|error| format!("it is damaged or no hand-in: {error}"))?;
        Self::of_value(value)
    }

    /// Reads what was sent.
    ///
    /// # Errors
    /// As for [`Self::read`].
    pub fn of_value(value: Value) -> Result<Self, String> {
        let kind = value.get("carrom").and_then(Value::as_str);
        let format = value.get("format").and_then(Value::as_u64);
        let (Some(KIND), Some(format)) = (kind, format) else {
            return Err("expected a file written by carrom hand-in".into());
        };
        if format > FORMAT.into() {
            return Err(newer(format!("format {format}"), FORMAT));
        }
        let written: Written =
            serde_json::from_value(value).map_err(|error| format!("it is damaged: {error}"))?;
        let attempts = { 1.. }.zip(written.answers).map(|(number, answer)| {
            let attempt = answer.attempt(&written.name);
            attempt.ok_or_else(|| format!("it is damaged: answer {number} cannot be"))
        });
        let attempts = attempts.collect::<Result<_, _>>()?;
        let hand_in = Self::new(&written.name, &written.class, attempts);
        match hand_in.name.is_empty() {
            true => Err("it has no name in it".into()),
            false => Ok(hand_in),
        }
    }
}

impl WrittenAnswer {
    /// The answer; `None` if no carrom has noted such a one.
    fn attempt(self, player: &str) -> Option<Attempt> {
        let confidence = match &self.confidence {
            None => None,
            Some(id) => Some(Confidence::ALL.into_iter().find(|it| it.id() == id)?),
        };
        let is_known = self.family == LESSON || Family::with_id(&self.family).is_some();
        let round = self
            .question
            .get("round")
            .map(|it| it.as_str().map(Code::read));
        let has_round = match round {
            // Before codes were noted with the figures the seed was all there was.
            None => true,
            Some(Some(Ok(_) | Err(NoCode::Review))) => true,
            Some(_) => false,
        };
        let is_possible = is_known && has_round && (0.0..=1.0).contains(&self.credit);
        let text = |figures: Map<String, Value>| Value::Object(figures).to_string();
        is_possible.then(|| Attempt {
            time_s: self.time_s,
            player: player.to_owned(),
            family: self.family,
            topic: tidy_name(&self.topic).chars().take(LONGEST_TOPIC).collect(),
            seed: self.seed,
            number: self.number,
            question: text(self.question),
            answer: text(self.answer),
            truth: text(self.truth),
            error_deg: self.error_deg,
            credit: self.credit,
            right: self.right,
            confidence,
            misconception: self.misconception,
        })
    }
}

fn tidy(name: &str) -> String {
    let short: String = tidy_name(name).chars().take(LONGEST).collect();
    short.trim_end().to_owned()
}

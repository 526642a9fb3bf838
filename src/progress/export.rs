//! Exports attempts for use in other programs, as a table or as JSON.

use jiff::Timestamp;
use serde::{Serialize, Serializer};
use serde_json::{Value, json};

use super::attempt::{ROUND, figures_text};
use super::observation::observations_json;
use super::{
    Attempt, Calibrated, HeldBelief, Observation, ObservationCounts, TABLE, Tally, TopicStanding,
    beliefs, calibration, topics,
};
use crate::files::{csv_table, write_json};
use crate::numbers;
use crate::quiz::{Confidence, Figures};

/// A function that returns the value of a column for an attempt, as JSON.
type ColumnValue = fn(&Attempt) -> Value;

/// The columns, each with its heading and the function for its values.
const COLUMNS: [(&str, ColumnValue); 14] = [
    ("time", |it| it.time_s.and_then(utc).into()),
    ("player", |it| it.player.as_str().into()),
    ("family", |it| it.family.as_str().into()),
    ("topic", |it| it.topic_name().into()),
    ("seed", |it| it.seed.into()),
    ("number", |it| it.number.into()),
    ("question", |it| it.question.clone().into()),
    ("answer", |it| it.answer.clone().into()),
    ("truth", |it| it.truth.clone().into()),
    ("error_deg", |it| it.error_deg.into()),
    ("credit", |it| it.credit.into()),
    ("right", |it| it.right.into()),
    ("confidence", |it| it.confidence.map(Confidence::id).into()),
    ("misconception", |it| it.misconception.as_deref().into()),
];

/// The columns that follow the [`COLUMNS`] in a table. Their values could be worked out from the
/// other columns, some of which contain JSON, but users should not have to do that.
const IN_WORDS: [(&str, ColumnValue); 4] = [
    ("round", |it| {
        it.question.get(ROUND).and_then(Value::as_str).into()
    }),
    ("points", |it| numbers::points(it.points()).into()),
    ("answer_in_words", |it| words(&it.answer).into()),
    ("truth_in_words", |it| words(&it.truth).into()),
];

fn words(said: &Figures) -> String {
    let each = tidied(said).into_iter().map(|(name, value)| match value {
        Value::String(text) => text,
        Value::Null => format!("{name} none"),
        value => format!("{name} {value}"),
    });
    each.collect::<Vec<_>>().join(", ")
}

/// The attempts as a [table](csv_table), with one attempt per row.
///
/// # Errors
/// Returns the reason if a row cannot be written, which does not happen in practice.
pub fn csv(attempts: &[Attempt]) -> Result<String, String> {
    let cell = |column: &str, value: Value| match (column, value) {
        ("answer" | "truth", Value::Object(said)) => figures_text(&tidied(&said)),
        (_, Value::Null) => String::new(),
        (_, Value::String(text)) => text,
        (_, Value::Bool(right)) => if right { "yes" } else { "no" }.into(),
        (_, number) if number.is_f64() => number.as_f64().unwrap_or_default().to_string(),
        (_, number) => number.to_string(),
    };
    let columns = || COLUMNS.iter().chain(&IN_WORDS);
    let row = |attempt: &Attempt| {
        let cells = columns().map(|(head, value)| cell(head, value(attempt)));
        cells.collect()
    };
    let rows: Vec<Vec<String>> = attempts.iter().map(row).collect();
    csv_table(columns().map(|(head, _)| *head), &rows)
}

/// An answer without rounding noise. An angle of 30° is converted to radians and back, and would
/// otherwise be printed as 29.999999999999996.
fn tidied(said: &Figures) -> Figures {
    let mut said = said.clone();
    for value in said.values_mut() {
        match value.as_f64().map(numbers::tidy) {
            Some(x) if x.fract() == 0.0 && x.abs() < 1e15 => *value = json!(x as i64),
            Some(x) => *value = json!(x),
            None => {}
        }
    }
    said
}

/// Formats a time in seconds since the start of 1970 as 2026-11-21T10:00:00Z; `None` outside the
/// years 1970 to 9999.
pub fn utc(time_s: i64) -> Option<String> {
    let time = Timestamp::from_second(time_s).ok()?;
    (time_s >= 0).then(|| time.to_string())
}

/// The attempts and observations as the text of one JSON object, with a summary, the player's next
/// step, and the results of the games at the table.
///
/// # Errors
/// Returns the reason if a value cannot be written, which does not happen in practice.
pub fn json(
    attempts: &[Attempt],
    observed: &[Observation],
    next: Option<&str>,
    games: Value,
) -> Result<String, String> {
    let mut summary = summary(attempts, next);
    summary["games"] = games;
    summary["observations"] = json!(ObservationCounts::new(observed));
    let all = All {
        summary,
        attempts: attempts.iter().map(AttemptRow).collect(),
        observations: observations_json(observed),
    };
    let mut text = Vec::new();
    write_json(&mut text, &all).map_err(|error| error.to_string())?;
    String::from_utf8(text).map_err(|error| error.to_string())
}

#[derive(Serialize)]
struct All<'a> {
    summary: Value,
    attempts: Vec<AttemptRow<'a>>,
    observations: Value,
}

/// An attempt, serialized in the order of the [`COLUMNS`].
struct AttemptRow<'a>(&'a Attempt);

impl Serialize for AttemptRow<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(COLUMNS.iter().map(|(head, value)| (head, value(self.0))))
    }
}

/// The number of calls at the table, and the number of those that earn full credit because no ray
/// is more than 2° off.
fn calls(attempts: &[Attempt]) -> Value {
    let calls = || attempts.iter().filter(|it| it.family == TABLE);
    let close = calls().filter(|it| it.credit >= 1.0 - 1e-9).count();
    json!({"made": calls().count(), "within_2_deg": close})
}

/// The summary of the attempts.
fn summary(attempts: &[Attempt], next: Option<&str>) -> Value {
    let tally = |tally: &Tally| {
        json!({
            "attempts": tally.attempts,
            "right": tally.right,
            "angles": tally.angles(),
            "mean_error_deg": tally.mean_error_deg(),
        })
    };
    let topic = |it: &TopicStanding| {
        json!({
            "topic": it.name,
            "mastery": it.mastery().name(),
            "all": tally(&it.all),
            "lately": tally(&it.lately),
        })
    };
    let calibrated = |it: &Calibrated| {
        json!({
            "confidence": it.confidence.id(),
            "attempts": it.tally.attempts,
            "right": it.tally.right,
        })
    };
    let belief = |it: &HeldBelief| {
        json!({
            "misconception": it.misconception.id(),
            "before": it.before.times,
            "before_asked": it.before.asked,
            "since": it.since.times,
            "since_asked": it.since.asked,
            "before_evidence": it.before.weight,
            "since_evidence": it.since.weight,
            "trend": it.trend().name(),
        })
    };
    json!({
        "all": tally(&Tally::of(attempts)),
        "topics": topics(attempts).iter().map(topic).collect::<Value>(),
        "calibration": calibration(attempts).iter().map(calibrated).collect::<Value>(),
        "misconceptions": beliefs(attempts).iter().map(belief).collect::<Value>(),
        "calls": calls(attempts),
        "next": next,
    })
}

#[cfg(test)]
mod tests {
    use unicode_width::UnicodeWidthChar;

    use super::super::tally::tests::attempt;
    use super::*;
    use crate::files::is_invisible;

    fn read(attempts: &[Attempt]) -> Value {
        serde_json::from_str(&json(attempts, &[], None, Value::Null).unwrap()).unwrap()
    }

    #[test]
    fn no_name_breaks_the_table_or_becomes_a_formula() {
        let names = [
            "=1+1",
            "+1",
            "-1",
            "@SUM(A1)",
            "\tx",
            "\rx",
            "  =1+1",
            "\n=1+1",
            "\u{feff}=1+1",
            "\u{a0}\u{202e}@SUM(A1)",
            "＝1+1",
            "a \"quote\", and\nanother line\r\n",
            "\u{202e}\u{0}\u{1b}[2J 球",
            &"ä".repeat(10_000),
        ];
        let attempts = names.map(|name| Attempt {
            player: name.into(),
            topic: name.into(),
            misconception: Some(name.into()),
            ..attempt("a", 3.0)
        });
        let text = csv(&attempts).unwrap();
        let mut table = csv::Reader::from_reader(text.as_bytes());
        let columns = COLUMNS.iter().chain(&IN_WORDS);
        let heads: Vec<&str> = columns.map(|it| it.0).collect();
        assert_eq!(table.headers().unwrap(), heads);
        let rows: Vec<_> = table.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), names.len());
        for (row, name) in rows.iter().zip(names) {
            for column in [1, 3, 13] {
                let cell = &row[column];
                let first = cell.trim_start_matches(|c: char| c.width().unwrap_or(0) == 0);
                let first = first.trim_start();
                assert!(
                    !first.starts_with(['=', '+', '-', '@', '\t', '\r', '＝'])
                        || first.parse::<f64>().is_ok(),
                    "{cell:?}"
                );
                // An unknown topic is shown as the words in its id.
                let shown = match column {
                    3 => name.replace('-', " "),
                    _ => name.to_owned(),
                };
                let breaks = |c: &char| matches!(c, '\n' | '\r' | '\t');
                let shown: String = { shown.chars() }
                    .filter(|c| breaks(c) || !is_invisible(*c))
                    .collect();
                assert_eq!(cell.replacen('\'', "", 1), shown);
            }
            assert_eq!(&row[9], "3");
        }
        let read = read(&attempts);
        for (i, name) in names.iter().enumerate() {
            assert_eq!(read["attempts"][i]["player"], *name);
        }
    }

    #[test]
    fn times_are_written_in_utc() {
        assert_eq!(utc(0).as_deref(), Some("1970-01-01T00:00:00Z"));
        assert_eq!(utc(951_782_400).as_deref(), Some("2000-02-29T00:00:00Z"));
        for never in [-1, i64::MIN, i64::MAX] {
            assert_eq!(utc(never), None);
        }
    }

    #[test]
    fn the_summary_counts_the_attempts() {
        let attempts = [attempt("a", 2.0), attempt("b", 10.0), attempt("b", 6.0)];
        let read = read(&attempts);
        assert_eq!(read["summary"]["all"]["attempts"], 3);
        assert_eq!(read["summary"]["all"]["angles"], 3);
        assert_eq!(read["summary"]["all"]["right"], 1);
        assert_eq!(read["summary"]["all"]["mean_error_deg"], 6.0);
        assert_eq!(read["summary"]["topics"][1]["topic"], "b");
        assert!(self::read(&[])["summary"]["all"]["mean_error_deg"].is_null());
    }
}

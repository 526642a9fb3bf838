//! Writes to the tables and reads from them.

use rusqlite::types::{FromSql, FromSqlResult, ValueRef};
use rusqlite::{Connection, Params, Row, params};

use super::{Database, NAME};
use crate::levels::Starred;
use crate::numbers::counted;
use crate::progress::{Attempt, figures_text};
use crate::quiz::{Confidence, Figures};

const ATTEMPTS: &str = "SELECT * FROM attempt WHERE ?1 IS NULL OR player = ?1 ORDER BY id";

const STARS: &str = "SELECT * FROM star WHERE player = ?1 ORDER BY pack, level";

const PLAYERS: &str = "SELECT player, max(time_s) AS last_s FROM \
                       (SELECT player, time_s FROM attempt UNION ALL \
                       SELECT player, NULL FROM star UNION ALL SELECT player, NULL FROM bookmark \
                       UNION ALL SELECT player, NULL FROM lab_hit \
                       UNION ALL SELECT player, NULL FROM observation) \
                       GROUP BY player ORDER BY last_s DESC, player";

impl Database {
    /// All players about whom anything is stored, each with the time of their last answer, the most
    /// recent first.
    pub(crate) fn players(&mut self) -> Result<Vec<(String, Option<i64>)>, String> {
        let player = |row: &Row| Ok(Some((row.get("player")?, row.get("last_s")?)));
        self.rows(PLAYERS, [], player).map(|(players, _)| players)
    }

    /// Stores an answer.
    pub(crate) fn record(&mut self, attempt: &Attempt) -> Result<(), String> {
        self.change(&|transaction| insert_attempt(transaction, attempt))
    }

    /// All answers of a player, or of everyone, in the order in which they were stored. A notice
    /// reports once how many fit no question and are left out.
    pub(crate) fn attempts(&mut self, player: Option<&str>) -> Result<Vec<Attempt>, String> {
        let (attempts, misfits) = self.look_up(&|transaction| attempts(transaction, player))?;
        self.report_misfits(misfits, "answer", "that fit no question");
        Ok(attempts)
    }

    /// Adds a notice, only once, of how many rows were left out.
    pub(super) fn report_misfits(&mut self, misfits: usize, what: &str, why: &str) {
        if misfits > 0 && !self.reported_misfits && self.notice.is_none() {
            self.reported_misfits = true;
            self.notice = Some(format!(
                "carrom left out {} in {NAME} {why}. The file is damaged, or another program has \
                 changed it.",
                counted(misfits, what),
            ));
        }
    }

    /// Stores a player's stars for a level, unless at least as many are already stored.
    pub(crate) fn star(&mut self, player: &str, starred: &Starred) -> Result<(), String> {
        self.change(&|transaction| {
            transaction.execute(
                "INSERT INTO star (player, pack, level, stars) VALUES (?1, ?2, ?3, ?4) \
                 ON CONFLICT DO UPDATE SET stars = max(stars, excluded.stars)",
                params![player, starred.pack, starred.level, starred.stars],
            )
        })
    }

    /// The stars of all levels that a player has won.
    pub(crate) fn stars(&mut self, player: &str) -> Result<Vec<Starred>, String> {
        let starred = |row: &Row| {
            Ok(Some(Starred {
                pack: row.get("pack")?,
                level: row.get("level")?,
                stars: row.get("stars")?,
            }))
        };
        self.rows(STARS, [player], starred).map(|(stars, _)| stars)
    }

    /// The rows of a query that can be read, and the number of the others; see [`readable`].
    pub(super) fn rows<T>(
        &mut self,
        sql: &str,
        params: impl Params + Copy,
        read: impl Fn(&Row) -> rusqlite::Result<Option<T>>,
    ) -> Result<(Vec<T>, usize), String> {
        self.look_up(&|transaction| readable(transaction, sql, params, &read))
    }
}

pub(super) fn insert_attempt(
    connection: &Connection,
    attempt: &Attempt,
) -> rusqlite::Result<usize> {
    connection.execute(
        "INSERT INTO attempt (time_s, player, family, topic, seed, number, question, answer, \
         truth, error_deg, credit, is_right, confidence, misconception) \
         VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14)",
        params![
            attempt.time_s,
            attempt.player,
            attempt.family,
            attempt.topic,
            attempt.seed.cast_signed(),
            attempt.number,
            figures_text(&attempt.question),
            figures_text(&attempt.answer),
            figures_text(&attempt.truth),
            attempt.error_deg,
            attempt.credit,
            attempt.right,
            attempt.confidence.map(Confidence::id),
            attempt.misconception,
        ],
    )
}

/// The answers, and the number of invalid rows.
pub(super) fn attempts(
    connection: &Connection,
    player: Option<&str>,
) -> rusqlite::Result<(Vec<Attempt>, usize)> {
    readable(connection, ATTEMPTS, [player], attempt)
}

/// The rows of a query that can be read, and the number of the others. `read` returns `None` for a
/// row that carrom cannot have written.
pub(super) fn readable<T>(
    connection: &Connection,
    sql: &str,
    params: impl Params,
    read: impl Fn(&Row) -> rusqlite::Result<Option<T>>,
) -> rusqlite::Result<(Vec<T>, usize)> {
    let mut statement = connection.prepare(sql)?;
    let (mut sound, mut misfits) = (Vec::new(), 0);
    for row in statement.query_map(params, read)? {
        match row {
            Ok(Some(row)) => sound.push(row),
            Ok(None) => misfits += 1,
            Err(error) if is_nonsense(&error) => misfits += 1,
            Err(error) => return Err(error),
        }
    }
    Ok((sound, misfits))
}

/// Whether a row cannot be read because carrom cannot have written it. One damaged row must not
/// hide the others.
fn is_nonsense(error: &rusqlite::Error) -> bool {
    use rusqlite::Error as E;
    matches!(
        error,
        E::FromSqlConversionFailure(..)
            | E::IntegralValueOutOfRange(..)
            | E::InvalidColumnType(..)
            | E::Utf8Error(..)
    )
}

/// A string that can be read even if its bytes are not valid UTF-8.
pub(super) struct LossyText(pub(super) String);

impl FromSql for LossyText {
    fn column_result(value: ValueRef<'_>) -> FromSqlResult<Self> {
        value
            .as_bytes()
            .map(|bytes| Self(String::from_utf8_lossy(bytes).into_owned()))
    }
}

fn attempt(row: &Row) -> rusqlite::Result<Option<Attempt>> {
    let text = |name| row.get::<_, LossyText>(name).map(|text| text.0);
    // A row without the question's numbers is still valid; one without the given answer is not.
    let figures = |name| text(name).map(|text| read_figures(&text).unwrap_or_default());
    let answer = text("answer")?;
    let answer = read_figures(&answer).map_err(|error| {
        rusqlite::Error::FromSqlConversionFailure(0, rusqlite::types::Type::Text, Box::new(error))
    })?;
    let confidence: Option<LossyText> = row.get("confidence")?;
    let misconception: Option<LossyText> = row.get("misconception")?;
    let attempt = Attempt {
        time_s: row.get("time_s")?,
        player: text("player")?,
        family: text("family")?,
        topic: text("topic")?,
        seed: row.get::<_, i64>("seed")?.cast_unsigned(),
        number: row.get("number")?,
        question: figures("question")?,
        answer,
        truth: figures("truth")?,
        error_deg: row.get("error_deg")?,
        credit: nothing_or_more(row.get("credit")?),
        right: row.get("is_right")?,
        confidence: confidence.and_then(|it| Confidence::with_id(&it.0)),
        misconception: misconception.map(|it| it.0),
    };
    Ok(Some(attempt).filter(|it| it.fault().is_none()))
}

fn read_figures(text: &str) -> serde_json::Result<Figures> {
    serde_json::from_str(text)
}

/// A credit. In older rows the credit for a wrong answer is tiny instead of 0.
fn nothing_or_more(credit: f64) -> f64 {
    if credit < 1e-12 { 0.0 } else { credit }
}

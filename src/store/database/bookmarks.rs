//! The tables of bookmarks.
//!
//! Only what was done is written, row by row: of several who read at once each keeps
//! what it has seen and answered, and the last to turn a page says where the chapter
//! is open.

use std::collections::BTreeMap;

use rusqlite::{Connection, Row, params};

use crate::lessons::{Bookmark, CheckpointAnswer, Forget, GivenAnswer};

const PLACES: &str = "SELECT chapter, page, alpha_deg FROM bookmark WHERE player = ?1";

const PAGES: &str = "SELECT chapter, page, asked, answer, is_right FROM page_seen \
    WHERE player = ?1";

/// Fails unless both tables are there with all their columns.
pub(super) fn check(connection: &Connection) -> rusqlite::Result<()> {
    connection.prepare(PLACES)?;
    connection.prepare(PAGES)?;
    Ok(())
}

/// Adds what was done in a chapter to what is kept of it.
pub(super) fn merge(
    connection: &Connection,
    player: &str,
    chapter: &str,
    later: &Bookmark,
) -> rusqlite::Result<()> {
    connection.execute(
        "INSERT INTO bookmark (player, chapter, page, alpha_deg) VALUES (?1, ?2, ?3, ?4) \
         ON CONFLICT DO UPDATE SET page = coalesce(excluded.page, page), \
         alpha_deg = coalesce(excluded.alpha_deg, alpha_deg)",
        params![player, chapter, later.place, later.alpha_deg],
    )?;
    let mut seen = connection.prepare(
        "INSERT INTO page_seen (player, chapter, page, asked, answer, is_right) \
         VALUES (?1, ?2, ?3, ?4, ?5, ?6) \
         ON CONFLICT DO UPDATE SET asked = excluded.asked, answer = excluded.answer, \
         is_right = excluded.is_right WHERE excluded.answer IS NOT NULL",
    )?;
    for (page, given) in &later.pages {
        let given = given.as_ref();
        seen.execute(params![
            player,
            chapter,
            page,
            given.map(|given| &given.asked),
            given.map(|given| given.answer.json().to_string()),
            given.map(|given| given.right),
        ])?;
    }
    Ok(())
}

/// Forgets what is to be forgotten of a player's bookmarks.
pub(super) fn forget(connection: &Connection, player: &str, what: &Forget) -> rusqlite::Result<()> {
    match what {
        Forget::Answer { chapter, page } => {
            connection.execute(
                "UPDATE page_seen SET asked = NULL, answer = NULL, is_right = NULL \
                 WHERE player = ?1 AND chapter = ?2 AND page = ?3",
                [player, chapter, page],
            )?;
        }
        Forget::Chapter(chapter) => {
            for table in ["bookmark", "page_seen"] {
                let sql = format!("DELETE FROM {table} WHERE player = ?1 AND chapter = ?2");
                connection.execute(&sql, [player, chapter])?;
            }
        }
        Forget::All => {
            for table in ["bookmark", "page_seen"] {
                connection.execute(&format!("DELETE FROM {table} WHERE player = ?1"), [player])?;
            }
        }
    }
    Ok(())
}

/// All bookmarks of a player, by the ids of the chapters.
pub(super) fn all(
    connection: &Connection,
    player: &str,
) -> rusqlite::Result<BTreeMap<String, Bookmark>> {
    let mut marks = BTreeMap::<String, Bookmark>::new();
    let mut places = connection.prepare(PLACES)?;
    let mut rows = places.query([player])?;
    while let Some(row) = rows.next()? {
        let mark = marks.entry(row.get("chapter")?).or_default();
        mark.place = row.get("page")?;
        mark.alpha_deg = row.get("alpha_deg")?;
    }
    let mut pages = connection.prepare(PAGES)?;
    let mut rows = pages.query([player])?;
    while let Some(row) = rows.next()? {
        let mark = marks.entry(row.get("chapter")?).or_default();
        mark.pages.insert(row.get("page")?, given(row)?);
    }
    Ok(marks)
}

/// The answer in a row; none where it is not to be understood.
fn given(row: &Row) -> rusqlite::Result<Option<GivenAnswer>> {
    let (asked, answer): (Option<String>, Option<String>) = (row.get("asked")?, row.get("answer")?);
    let right: Option<bool> = row.get("is_right")?;
    let answer =
        answer.and_then(|text| CheckpointAnswer::of_json(&serde_json::from_str(&text).ok()?));
    let given = asked.zip(answer).map(|(asked, answer)| GivenAnswer {
        asked,
        answer,
        right: right.unwrap_or_default(),
    });
    Ok(given)
}

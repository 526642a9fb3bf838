//! The tables of bookmarks.
//!
//! Only changes are written, row by row. So if several copies of carrom run at once, all pages seen
//! are kept, each with its latest answer, and the last copy to turn a page decides where the
//! chapter opens.

use std::collections::BTreeMap;

use rusqlite::{Row, Transaction, params};

use super::Database;
use super::tables::{LossyText, readable};
use crate::lessons::{Bookmark, Forget, GivenAnswer, given_json, tries_of_json};

const PLACES: &str = "SELECT * FROM bookmark WHERE player = ?1";

const PAGES: &str = "SELECT * FROM page_seen WHERE player = ?1";

impl Database {
    /// Adds a player's latest actions in a chapter to the bookmark.
    pub(crate) fn mark(
        &mut self,
        player: &str,
        chapter: &str,
        later: &Bookmark,
    ) -> Result<(), String> {
        self.change(&|transaction| {
            transaction.execute(
                "INSERT INTO bookmark (player, chapter, page, alpha_deg) VALUES (?1, ?2, ?3, ?4) \
                 ON CONFLICT DO UPDATE SET page = coalesce(excluded.page, page), \
                 alpha_deg = coalesce(excluded.alpha_deg, alpha_deg)",
                params![player, chapter, later.place, later.alpha_deg],
            )?;
            let mut seen = transaction.prepare(
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
                    given.map(|given| given_json(given).to_string()),
                    given.map(|given| given.right),
                ])?;
            }
            Ok(())
        })
    }

    /// Deletes the given part of a player's bookmarks.
    pub(crate) fn forget(&mut self, player: &str, what: &Forget) -> Result<(), String> {
        if self.is_nowhere() {
            return Ok(());
        }
        self.change(&|transaction| match what {
            Forget::Answer { chapter, page } => transaction.execute(
                "UPDATE page_seen SET asked = NULL, answer = NULL, is_right = NULL \
                 WHERE player = ?1 AND chapter = ?2 AND page = ?3",
                [player, chapter, page],
            ),
            Forget::Chapter(chapter) => forget_all(transaction, player, Some(chapter)),
            Forget::All => forget_all(transaction, player, None),
        })
    }

    /// All bookmarks of a player, by chapter id.
    pub(crate) fn marks(&mut self, player: &str) -> Result<BTreeMap<String, Bookmark>, String> {
        self.look_up(&|transaction| {
            let (places, _) = readable(transaction, PLACES, [player], place)?;
            let mut marks: BTreeMap<_, Bookmark> = places.into_iter().collect();
            for (chapter, page, given) in readable(transaction, PAGES, [player], page)?.0 {
                let mark = marks.entry(chapter).or_default();
                mark.pages.insert(page, given);
            }
            Ok(marks)
        })
    }
}

/// Deletes a player's bookmark in one chapter, or in all of them.
fn forget_all(
    transaction: &Transaction,
    player: &str,
    chapter: Option<&str>,
) -> rusqlite::Result<usize> {
    let forget = |table| {
        let sql =
            format!("DELETE FROM {table} WHERE player = ?1 AND chapter = coalesce(?2, chapter)");
        transaction.execute(&sql, (player, chapter))
    };
    Ok(forget("bookmark")? + forget("page_seen")?)
}

/// A chapter and where its bookmark is.
fn place(row: &Row) -> rusqlite::Result<Option<(String, Bookmark)>> {
    let mark = Bookmark {
        place: row.get("page")?,
        alpha_deg: row.get("alpha_deg")?,
        ..Bookmark::default()
    };
    Ok(Some((row.get("chapter")?, mark)))
}

/// A page that was seen: its chapter, its title and the answer given on it.
fn page(row: &Row) -> rusqlite::Result<Option<(String, String, Option<GivenAnswer>)>> {
    Ok(Some((row.get("chapter")?, row.get("page")?, given(row)?)))
}

/// The answer in a row; `None` if there is none or it cannot be read.
fn given(row: &Row) -> rusqlite::Result<Option<GivenAnswer>> {
    let asked: Option<LossyText> = row.get("asked")?;
    let answer: Option<LossyText> = row.get("answer")?;
    let right: Option<bool> = row.get("is_right")?;
    let tries = answer.and_then(|text| tries_of_json(&serde_json::from_str(&text.0).ok()?));
    let given = asked
        .zip(tries)
        .map(|(asked, (answer, first))| GivenAnswer {
            asked: asked.0,
            answer,
            right: right.unwrap_or_default(),
            first,
        });
    Ok(given)
}

//! Copies all readable rows of a damaged database into a new one.

use std::collections::{BTreeSet, HashMap};

use rusqlite::types::{ToSqlOutput, ValueRef};
use rusqlite::{Connection, ErrorCode, params_from_iter};

use super::pages::{PageContents, PageLayout, Pages, Tree, values};

/// The table of answers, and the index that also lists them.
const ANSWERS: &str = "attempt";
const LIST_OF_ANSWERS: &str = "attempt_of_player";
/// The minimum size of an answer, in bytes. No id may be larger than the number of answers
/// of this size that the file has room for.
const LEAST_ANSWER: usize = 32;

/// The names of tables, each with a number of rows.
pub(super) type RowCounts = Vec<(String, usize)>;

#[derive(Debug, Default)]
pub(super) struct Saved {
    /// The number of rows saved from each table, in the order in which the tables were created.
    tables: RowCounts,
    /// The tables that have lost rows.
    pub(super) damaged: Vec<String>,
    /// The number of answers that are known to be lost.
    lost_answers: usize,
    /// Whether more answers may be lost.
    or_more: bool,
    /// The copy from which rows were restored, and the number of rows restored to each table.
    pub(super) copy: Option<(String, RowCounts)>,
}

/// A table of the new database, and the location of its rows in the damaged one.
struct SalvagedTable {
    name: String,
    columns: Columns,
    tree: Tree,
    /// The number of rows that were saved.
    rows: usize,
}

/// Copies all readable rows from the pages of a damaged database into the tables of `new`.
pub(super) fn salvage(pages: &mut Pages, new: &Connection) -> rusqlite::Result<Saved> {
    let roots = roots(pages);
    let mut tree = |name: &str, layout| match roots.get(name) {
        Some(root) => pages.tree(*root, layout),
        None => Tree::default(),
    };
    let list = tree(LIST_OF_ANSWERS, PageLayout::Index);
    let mut tables = Vec::new();
    for name in table_names(new)? {
        let columns = Columns::of(new, &name)?;
        tables.push(SalvagedTable {
            tree: tree(&name, columns.layout),
            name,
            columns,
            rows: 0,
        });
    }
    for table in &mut tables {
        for number in table.tree.pages.clone() {
            if let Some(contents) = pages.contents(number) {
                table.tree.is_whole &= contents.is_whole & table.take(&contents, new)?;
            }
        }
    }
    take_cut_off(pages, &mut tables, &list, new)?;
    let mut saved = Saved {
        tables: tables.iter().map(|it| (it.name.clone(), it.rows)).collect(),
        ..Saved::default()
    };
    for table in tables.iter().filter(|table| !table.tree.is_whole) {
        if table.name == ANSWERS {
            saved.count_lost_answers(&list, pages, new)?;
            if saved.lost_answers == 0 && !saved.or_more {
                continue;
            }
        }
        saved.damaged.push(table.name.clone());
    }
    Ok(saved)
}

/// Copies the rows on pages that no tree leads to any more, if only one table can have lost them.
fn take_cut_off(
    pages: &mut Pages,
    tables: &mut [SalvagedTable],
    list: &Tree,
    new: &Connection,
) -> rusqlite::Result<()> {
    let mut known = pages.unused();
    known.extend(&list.pages);
    known.extend(tables.iter().flat_map(|table| &table.tree.pages));
    for number in pages.numbers().filter(|number| !known.contains(number)) {
        let Some(contents) = pages.contents(number) else {
            continue;
        };
        let mut records = contents.cells.iter().filter_map(|it| it.record.as_deref());
        let Some(columns) = records.find_map(|it| Some(values(it)?.len())) else {
            continue;
        };
        let mut owners = tables.iter_mut().filter(|table| {
            !table.tree.is_whole
                && table.columns.layout == contents.layout
                && table.columns.names.len() == columns
        });
        if let (Some(owner), None) = (owners.next(), owners.next()) {
            owner.take(&contents, new)?;
        }
    }
    Ok(())
}

/// The first page of each table and index, by their names.
fn roots(pages: &mut Pages) -> HashMap<String, u32> {
    let mut roots = HashMap::new();
    for number in pages.tree(1, PageLayout::Table).pages {
        let cells = pages.contents(number).map(|it| it.cells);
        for record in cells.into_iter().flatten().filter_map(|it| it.record) {
            if let Some([_, ValueRef::Text(name), _, ValueRef::Integer(root), ..]) =
                values(&record).as_deref()
                && let Ok(root) = u32::try_from(*root)
            {
                roots.insert(String::from_utf8_lossy(name).into_owned(), root);
            }
        }
    }
    roots
}

impl SalvagedTable {
    /// Saves the rows of a page; returns whether all of them could be saved.
    fn take(&mut self, contents: &PageContents, new: &Connection) -> rusqlite::Result<bool> {
        let mut is_whole = true;
        for cell in &contents.cells {
            let values = cell.record.as_deref().and_then(values);
            let rows = match values {
                Some(values) => self.insert(cell.id, values, new)?,
                None => 0,
            };
            self.rows += rows;
            is_whole &= rows > 0;
        }
        Ok(is_whole)
    }

    /// Adds a row to the new table unchanged; its values are checked when they are read. Returns
    /// the number of rows added, which is 0 if the row is invalid or exists already.
    fn insert(
        &self,
        id: Option<i64>,
        mut values: Vec<ValueRef>,
        new: &Connection,
    ) -> rusqlite::Result<usize> {
        // A row that is older than a column has no value for that column.
        let names = match self.columns.names.get(..values.len()) {
            Some(names) if !names.is_empty() => names,
            _ => return Ok(0),
        };
        if let Some(id) = id
            && let Some(column) = self.columns.id
            && let Some(value) = values.get_mut(column)
        {
            *value = ValueRef::Integer(id);
        }
        let mut put = new.prepare_cached(&format!(
            "INSERT OR IGNORE INTO {} ({}) VALUES ({})",
            self.name,
            names.join(", "),
            vec!["?"; names.len()].join(", ")
        ))?;
        let values = values.into_iter().map(ToSqlOutput::Borrowed);
        match put.execute(params_from_iter(values)) {
            Err(error) if error.sqlite_error_code() == Some(ErrorCode::ConstraintViolation) => {
                Ok(0)
            }
            put => put,
        }
    }
}

/// The names of the tables, in the order in which they were created.
fn table_names(connection: &Connection) -> rusqlite::Result<Vec<String>> {
    let mut names = connection
        .prepare("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY rootpage")?;
    names.query_map([], |row| row.get(0))?.collect()
}

pub(super) struct Columns {
    /// The names of the columns, in the order of the values in a row.
    pub(super) names: Vec<String>,
    /// The index of the column that is the row's id.
    id: Option<usize>,
    layout: PageLayout,
}

impl Columns {
    /// The columns of the table with this name.
    pub(super) fn of(connection: &Connection, table: &str) -> rusqlite::Result<Self> {
        let mut query = connection.prepare(
            "SELECT list.wr, info.name, info.pk > 0 \
             FROM pragma_table_list(?1) AS list, pragma_table_info(?1) AS info \
             WHERE list.schema = 'main' \
             ORDER BY iif(list.wr AND info.pk, info.pk, 1 << 16), info.cid",
        )?;
        let mut rows = query.query([table])?;
        let mut columns = Self {
            names: Vec::new(),
            id: None,
            layout: PageLayout::Table,
        };
        while let Some(row) = rows.next()? {
            if row.get(0)? {
                columns.layout = PageLayout::Index;
            } else if row.get(2)? {
                columns.id = Some(columns.names.len());
            }
            columns.names.push(row.get(1)?);
        }
        Ok(columns)
    }
}

impl Saved {
    /// Counts the lost answers: those that are only in the list, and, if part of the list cannot be
    /// read either, all missing ids up to the largest known one.
    fn count_lost_answers(
        &mut self,
        list: &Tree,
        pages: &mut Pages,
        new: &Connection,
    ) -> rusqlite::Result<()> {
        let mut saved = new.prepare("SELECT id FROM attempt")?;
        let saved = saved.query_map([], |row| row.get(0))?;
        let saved = saved.collect::<rusqlite::Result<BTreeSet<i64>>>()?;
        let mut known = BTreeSet::new();
        let ids = 1..=i64::try_from(pages.size() / LEAST_ANSWER).unwrap_or(i64::MAX);
        self.or_more = !list.is_whole;
        for number in &list.pages {
            let contents = pages.contents(*number);
            self.or_more |= !contents.as_ref().is_some_and(|it| it.is_whole);
            for cell in contents.into_iter().flat_map(|it| it.cells) {
                match cell.record.as_deref().and_then(values).as_deref() {
                    Some([_, ValueRef::Integer(id)]) if ids.contains(id) => {
                        known.insert(*id);
                    }
                    _ => self.or_more = true,
                }
            }
        }
        if self.or_more {
            let last = known.last().max(saved.range(ids).last()).copied();
            known.extend(1..=last.unwrap_or_default());
        }
        self.lost_answers = known.difference(&saved).count();
        Ok(())
    }

    /// Sentences about what was saved and what was lost.
    pub(super) fn reported(&self) -> String {
        let saved = listed(&self.tables);
        let mut reported = match (saved.is_empty(), self.damaged.is_empty()) {
            (true, true) => return "There was nothing in it.".into(),
            (false, true) => return format!("Everything in it could be saved: {saved}."),
            (true, false) => "Nothing in it could be read.".into(),
            (false, false) => {
                let lost = self.damaged.iter().map(|table| self.lost(table));
                let lost = lost.collect::<Vec<_>>().join(", ");
                format!("Saved: {saved}. Could not be read: {lost}.")
            }
        };
        if let Some((copy, rows)) = &self.copy {
            let taken = match listed(rows) {
                nothing if nothing.is_empty() => "none of the missing rows".into(),
                taken => taken,
            };
            reported += &format!(" Restored from {copy}: {taken}.");
        }
        reported
    }

    /// The lost rows of a damaged table, in words.
    fn lost(&self, table: &str) -> String {
        match (table, self.lost_answers) {
            (ANSWERS, 1..) => {
                let or_more = if self.or_more { " or more" } else { "" };
                format!("{}{or_more}", counted(table, self.lost_answers))
            }
            _ => format!("some of the {}", things(table).1),
        }
    }
}

/// The numbers of rows of tables, in words; empty tables are left out.
fn listed(tables: &[(String, usize)]) -> String {
    let some = tables.iter().filter(|(_, rows)| *rows > 0);
    let some: Vec<_> = some.map(|(name, rows)| counted(name, *rows)).collect();
    some.join(", ")
}

/// A number of rows of a table, in the player's words.
fn counted(table: &str, rows: usize) -> String {
    let (one, more) = things(table);
    format!("{rows} {}", if rows == 1 { one } else { more })
}

/// The contents of a table in the player's words: singular and plural.
fn things(table: &str) -> (&str, &str) {
    match table {
        ANSWERS => ("answer", "answers"),
        "star" => ("level won", "levels won"),
        "bookmark" => ("chapter begun", "chapters begun"),
        "page_seen" => ("page read", "pages read"),
        "lab_hit" => ("hit in the notebook", "hits in the notebook"),
        "observation" => ("observation", "observations"),
        other => (other, other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_notice_counts_what_was_saved_and_what_was_not() {
        let tables = [(ANSWERS, 730), ("star", 1), ("bookmark", 0)];
        let mut saved = Saved {
            tables: tables.map(|(name, rows)| (name.into(), rows)).into(),
            ..Saved::default()
        };
        assert_eq!(
            saved.reported(),
            "Everything in it could be saved: 730 answers, 1 level won."
        );
        saved.damaged = vec![ANSWERS.into(), "star".into()];
        saved.lost_answers = 1;
        assert_eq!(
            saved.reported(),
            "Saved: 730 answers, 1 level won. Could not be read: 1 answer, some of the levels won."
        );
        saved.damaged.truncate(1);
        saved.or_more = true;
        saved.copy = Some((
            "progress-backup-2026-11-21.db".into(),
            vec![(ANSWERS.into(), 7)],
        ));
        assert_eq!(
            saved.reported(),
            "Saved: 730 answers, 1 level won. Could not be read: 1 answer or more. Restored from \
             progress-backup-2026-11-21.db: 7 answers."
        );
    }
}

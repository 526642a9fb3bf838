//! A database as bytes, because a browser has no files. The bytes are those of a `progress.db`
//! file.

use rusqlite::{Connection, TransactionBehavior};

use super::error::DatabaseError;
use super::{Database, Location, limits, mend, schema, tables, transact};
use crate::progress::Attempt;

/// The position of the write and read versions in the file's header: 2 means a write-ahead log,
/// which is a separate file and does not exist here; 1 means no such log.
const WAYS_OF_WRITING: std::ops::Range<usize> = 18..20;

/// Adds everything in one database, except the answers, to another.
const TAKE_IN: &str = include_str!("take-in.sql");

impl Database {
    /// A database in memory with the contents of these bytes. A database that a newer version of
    /// carrom has written stays unchanged, and refuses every request. If the bytes are damaged, all
    /// readable rows are copied and a notice reports the damage. Also returns whether the bytes
    /// were damaged, because the caller then has to keep them under the name `kept`.
    ///
    /// # Errors
    /// The reason why the bytes cannot be used: they are not carrom's, or too damaged.
    pub(crate) fn of_bytes(bytes: &[u8], kept: &str) -> Result<(Self, bool), String> {
        let sound = |location| Ok((Self::at(location), false));
        match open(bytes) {
            Ok(connection) => sound(Location::Memory(Some(connection))),
            Err(DatabaseError::Newer(found)) => sound(Location::Newer(found, bytes.into())),
            Err(trouble) if trouble.is_damage() => {
                let (connection, notice) = mend::mended_bytes(bytes, kept, &trouble)
                    .map_err(|why| DatabaseError::Unmended(Box::new(why)).to_string())?;
                let mut mended = Self::at(Location::Memory(Some(connection)));
                mended.notice = Some(notice);
                Ok((mended, true))
            }
            Err(trouble) => Err(trouble.to_string()),
        }
    }

    /// The bytes; `None` while nothing has been stored.
    ///
    /// # Errors
    /// The reason why they cannot be read.
    pub(crate) fn bytes(&mut self) -> Result<Option<Vec<u8>>, String> {
        Ok(match &mut self.location {
            Location::Memory(Some(connection)) => Some(
                connection
                    .serialize("main")
                    .map_err(|error| error.to_string())?
                    .to_vec(),
            ),
            Location::Newer(_, bytes) => Some(bytes.clone()),
            Location::Memory(None) | Location::Folder(_) => None,
        })
    }

    /// Adds everything from another database, given as bytes, that this database does not have yet.
    ///
    /// # Errors
    /// If the bytes are damaged, not carrom's, or from a newer version; then nothing is added.
    pub(crate) fn take_in(&mut self, bytes: &[u8]) -> Result<(), String> {
        let reported = |trouble: DatabaseError| trouble.to_string();
        let mut other = open(bytes).map_err(reported)?;
        let (theirs, _) = tables::attempts(&other, None).map_err(|error| reported(error.into()))?;
        let own = self.attempts(None)?;
        let fresh: Vec<_> = { theirs.iter() }.filter(|it| !own.contains(it)).collect();
        // This ensures that the tables exist.
        self.change(&|_| Ok(()))?;
        match &mut self.location {
            Location::Memory(Some(connection)) => {
                add(connection, &mut other, &fresh).map_err(reported)
            }
            _ => Ok(()),
        }
    }
}

/// A database in memory with the contents of these bytes, upgraded to the current version.
fn open(bytes: &[u8]) -> Result<Connection, DatabaseError> {
    let mut bytes = bytes.to_vec();
    if let Some(ways) = bytes.get_mut(WAYS_OF_WRITING) {
        ways.fill(1);
    }
    let mut connection = Connection::open_in_memory()?;
    limits::limit_work(&mut connection, bytes.len() as u64)?;
    connection.deserialize_read_exact("main", &*bytes, bytes.len(), false)?;
    schema::prepare(&mut connection)?;
    schema::check(&connection)?;
    // This connection stays open for as long as the page is open.
    limits::unlimit_work(&mut connection)?;
    Ok(connection)
}

/// Adds these answers, and everything else in `other`, as one transaction.
fn add(
    connection: &mut Connection,
    other: &mut Connection,
    fresh: &[&Attempt],
) -> Result<(), DatabaseError> {
    let bytes = other.serialize("main")?.to_vec();
    connection.execute_batch("ATTACH ':memory:' AS opened")?;
    connection.deserialize_read_exact("opened", &*bytes, bytes.len(), false)?;
    let added = transact(connection, TransactionBehavior::Immediate, &|transaction| {
        for attempt in fresh {
            tables::insert_attempt(transaction, attempt)?;
        }
        transaction.execute_batch(TAKE_IN)
    });
    connection.execute_batch("DETACH opened")?;
    added
}

#[cfg(test)]
mod tests {
    use super::super::tests as database_tests;
    use super::*;
    use crate::levels::Starred;
    use crate::quiz::Figures;

    fn attempt(number: u32) -> Attempt {
        Attempt {
            time_s: Some(1_800_000_000 + i64::from(number)),
            player: "Ada".into(),
            family: "speeds".into(),
            topic: "speeds".into(),
            seed: 7,
            number,
            question: Figures::new(),
            answer: Figures::new(),
            truth: Figures::new(),
            error_deg: None,
            credit: 0.5,
            right: false,
            confidence: None,
            misconception: None,
        }
    }

    fn with(numbers: &[u32], stars: u8) -> Database {
        let mut database = Database::in_memory();
        for number in numbers {
            database.record(&attempt(*number)).unwrap();
        }
        let starred = Starred {
            pack: "first".into(),
            level: "one".into(),
            stars,
        };
        database.star("Ada", &starred).unwrap();
        database
    }

    #[test]
    fn a_database_opens_from_its_bytes_and_from_those_of_a_file() {
        assert_eq!(Database::in_memory().bytes(), Ok(None));
        let mut bytes = with(&[1, 2], 3).bytes().unwrap().unwrap();
        // A file on a disk has these values.
        bytes[WAYS_OF_WRITING].fill(2);
        let (mut again, was_damaged) = Database::of_bytes(&bytes, "aside").unwrap();
        assert!(!was_damaged);
        assert_eq!(again.attempts(None).unwrap(), [attempt(1), attempt(2)]);
        assert_eq!(again.stars("Ada").unwrap()[0].stars, 3);
        again.record(&attempt(3)).unwrap();
        assert_eq!(again.attempts(None).unwrap().len(), 3);
    }

    #[test]
    fn the_contents_of_another_database_are_added_once() {
        let mut own = with(&[1, 2], 1);
        let other = with(&[2, 3], 3).bytes().unwrap().unwrap();
        for _ in 0..2 {
            own.take_in(&other).unwrap();
            let numbers: Vec<_> = own.attempts(None).unwrap();
            assert_eq!(numbers, [attempt(1), attempt(2), attempt(3)]);
            assert_eq!(own.stars("Ada").unwrap()[0].stars, 3);
        }
    }

    #[test]
    fn unusable_bytes_are_refused_and_those_of_a_newer_version_left_unchanged() {
        let whole = with(&[1], 1).bytes().unwrap().unwrap();
        assert!(Database::of_bytes(b"no database", "aside").is_err());
        assert!(with(&[2], 1).take_in(&whole[..whole.len() / 2]).is_err());
        let mut newer = Connection::open_in_memory().unwrap();
        newer
            .execute_batch("CREATE TABLE later (x); PRAGMA user_version = 99")
            .unwrap();
        let newer = newer.serialize("main").unwrap().to_vec();
        let (mut kept, was_damaged) = Database::of_bytes(&newer, "aside").unwrap();
        assert!(!was_damaged);
        assert!(kept.record(&attempt(9)).unwrap_err().contains("newer"));
        assert_eq!(kept.bytes(), Ok(Some(newer)));
    }

    #[test]
    fn damaged_bytes_are_repaired_like_a_file() {
        let numbers: Vec<_> = (1..=200).collect();
        let whole = with(&numbers, 2).bytes().unwrap().unwrap();
        let (mut same, _) = Database::of_bytes(&whole, "aside").unwrap();
        let is_leaf = |start: usize| whole[start] == 13 && whole[start + 4] > 0;
        let leaf = (1..)
            .map(|page| page * 4096)
            .find(|start| is_leaf(*start))
            .unwrap();
        let mut damaged = whole.clone();
        damaged[leaf..leaf + 4096].fill(0);
        for bytes in [damaged, whole[..whole.len() - 4096].to_vec()] {
            let (mut mended, was_damaged) = Database::of_bytes(&bytes, "aside").unwrap();
            assert!(was_damaged);
            let notice = mended.notice.take().unwrap();
            assert!(notice.contains("is kept as aside"), "{notice}");
            let answers = mended.attempts(None).unwrap();
            assert!(answers.len() > 100, "{}: {notice}", answers.len());
            let sound = same.attempts(None).unwrap();
            assert!(answers.iter().all(|answer| sound.contains(answer)));
            mended.record(&attempt(201)).unwrap();
        }
    }

    #[test]
    fn bytes_with_a_schema_that_is_not_ours_are_refused_before_they_are_queried() {
        for sql in database_tests::FOREIGN_SCHEMAS {
            let mut foreign =
                database_tests::with_foreign_schema(Connection::open_in_memory(), sql);
            let bytes = foreign.serialize("main").unwrap().to_vec();
            let refused = Database::of_bytes(&bytes, "aside").err().unwrap();
            let own = with(&[1], 1).take_in(&bytes).unwrap_err();
            for message in [refused, own] {
                assert!(
                    message.contains("not a carrom database"),
                    "{sql}: {message}"
                );
            }
        }
    }
}

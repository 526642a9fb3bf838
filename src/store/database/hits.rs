//! The tables of the lab's notebook and of observations.

use rusqlite::{Row, params};

use super::Database;
use super::tables::LossyText;
use crate::progress::{NotedHit, Observation, rays_of_text, rays_text};

const NOTEBOOK: &str = "SELECT * FROM lab_hit WHERE player = ?1 ORDER BY id DESC LIMIT ?2";

const OBSERVATIONS: &str = "SELECT * FROM observation WHERE ?1 IS NULL OR player = ?1 ORDER BY id";

impl Database {
    /// Adds a hit to a player's notebook.
    pub(crate) fn note_hit(&mut self, player: &str, hit: &NotedHit) -> Result<(), String> {
        self.change(&|transaction| {
            transaction.execute(
                "INSERT INTO lab_hit (time_s, player, setup, said) VALUES (?1, ?2, ?3, ?4)",
                params![
                    hit.time_s,
                    player,
                    hit.setup.to_link(),
                    hit.said.as_ref().map(rays_text)
                ],
            )
        })
    }

    /// The latest hits in a player's notebook, in the order in which they were made. A notice
    /// reports once how many are left out because carrom cannot have written them.
    pub(crate) fn notebook(&mut self, player: &str) -> Result<Vec<NotedHit>, String> {
        let latest = (player, NotedHit::MOST as i64);
        let (mut hits, misfits) = self.rows(NOTEBOOK, latest, noted_hit)?;
        hits.reverse();
        self.report_misfits(misfits, "hit", "that cannot be played");
        Ok(hits)
    }

    /// Deletes all hits in a player's notebook.
    pub(crate) fn clear_notebook(&mut self, player: &str) -> Result<(), String> {
        if self.is_nowhere() {
            return Ok(());
        }
        self.change(&|transaction| {
            transaction.execute("DELETE FROM lab_hit WHERE player = ?1", [player])
        })
    }

    /// Stores what a player saw.
    pub(crate) fn observe(&mut self, it: &Observation) -> Result<(), String> {
        self.change(&|transaction| {
            transaction.execute(
                "INSERT INTO observation (time_s, player, place, said, truth, seen) \
                 VALUES (?1, ?2, ?3, ?4, ?5, ?6)",
                params![
                    it.time_s,
                    it.player,
                    <&str>::from(it.place),
                    rays_text(&it.said),
                    rays_text(&it.truth),
                    rays_text(&it.seen)
                ],
            )
        })
    }

    /// All observations of a player, or of everyone, in the order in which they were made. Rows
    /// that carrom cannot have written are left out, and reported once.
    pub(crate) fn observations(
        &mut self,
        player: Option<&str>,
    ) -> Result<Vec<Observation>, String> {
        let (seen, misfits) = self.rows(OBSERVATIONS, [player], observation)?;
        self.report_misfits(misfits, "observation", "that fit no hit");
        Ok(seen)
    }
}

fn noted_hit(row: &Row) -> rusqlite::Result<Option<NotedHit>> {
    let setup: LossyText = row.get("setup")?;
    let said: Option<LossyText> = row.get("said")?;
    let said = said.as_ref().map(|said| said.0.as_str());
    Ok(NotedHit::of_texts(row.get("time_s")?, &setup.0, said))
}

fn observation(row: &Row) -> rusqlite::Result<Option<Observation>> {
    let text = |name| row.get::<_, LossyText>(name).map(|text| text.0);
    let rays = |name| text(name).map(|text| rays_of_text(&text));
    let (said, truth, seen) = (rays("said")?, rays("truth")?, rays("seen")?);
    let (Ok(place), Some(said), Some(truth), Some(seen)) =
        (text("place")?.parse(), said, truth, seen)
    else {
        return Ok(None);
    };
    Ok(Some(Observation {
        time_s: row.get("time_s")?,
        player: text("player")?,
        place,
        said,
        truth,
        seen,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::CollisionSpec;
    use crate::progress::ObservationPlace;
    use crate::quiz::Rays;

    fn hit(link: &str, said: Option<Rays>) -> NotedHit {
        NotedHit::new(CollisionSpec::from_link(link).unwrap(), said)
    }

    fn observation(player: &str) -> Observation {
        let still = Rays {
            striker: None,
            target: Some(0.0),
        };
        Observation {
            time_s: Some(1_800_000_000),
            player: player.into(),
            place: ObservationPlace::Quiz,
            said: still,
            truth: still,
            seen: still,
        }
    }

    #[test]
    fn each_player_has_a_notebook_that_can_be_cleared() {
        let mut database = Database::in_memory();
        let hits = [
            hit(
                "m2:5.5,b:-12.345678901234567,e:0.8",
                Some(Rays::new(0.0, 0.0)),
            ),
            hit("stick:true", None),
        ];
        for it in &hits {
            database.note_hit("Ada", it).unwrap();
        }
        database.note_hit("Bo", &hits[1]).unwrap();
        assert_eq!(database.notebook("Ada").unwrap(), hits);
        let players: Vec<_> = database.players().unwrap();
        assert_eq!(players, [("Ada".into(), None), ("Bo".into(), None)]);
        database.clear_notebook("Ada").unwrap();
        assert_eq!(database.notebook("Ada").unwrap(), []);
        assert_eq!(database.notebook("Bo").unwrap().len(), 1);
        assert_eq!(database.notice.take(), None);
    }

    #[test]
    fn only_the_latest_hits_are_read() {
        let mut database = Database::in_memory();
        for number in 0..NotedHit::MOST + 5 {
            let it = hit(&format!("u:{}", 1.0 + 0.001 * number as f64), None);
            database.note_hit("Ada", &it).unwrap();
        }
        let hits = database.notebook("Ada").unwrap();
        assert_eq!(hits.len(), NotedHit::MOST);
        assert!((hits[0].setup.speed - 1.005).abs() < 1e-12);
    }

    #[test]
    fn invalid_rows_are_left_out_and_counted_in_a_notice() {
        let mut database = Database::in_memory();
        for _ in 0..4 {
            database.note_hit("Ada", &hit("b:1", None)).unwrap();
            database.observe(&observation("Ada")).unwrap();
        }
        let spoil = |database: &mut Database, sql: &str| {
            let spoilt = database.change(&|transaction| transaction.execute_batch(sql));
            spoilt.unwrap();
        };
        spoil(
            &mut database,
            "UPDATE lab_hit SET setup = 'm1:-3' WHERE id = 1;
             UPDATE lab_hit SET setup = CAST(x'ff00' AS TEXT) WHERE id = 2;
             UPDATE lab_hit SET said = '{\"theta1_deg\":1e999}' WHERE id = 3;",
        );
        assert_eq!(database.notebook("Ada").unwrap().len(), 1);
        let notice = database.notice.take().unwrap();
        assert!(notice.contains("3 hits in progress.db"), "{notice}");
        database.reported_misfits = false;
        spoil(
            &mut database,
            "UPDATE observation SET place = 'table' WHERE id = 1;
             UPDATE observation SET seen = '{\"theta1_deg\":999,\"theta2_deg\":0}' WHERE id = 2;",
        );
        assert_eq!(database.observations(None).unwrap().len(), 2);
        let notice = database.notice.take().unwrap();
        assert!(notice.contains("2 observations in progress.db"), "{notice}");
    }

    #[test]
    fn observations_are_read_back_and_added_once_from_another_database() {
        let mut own = Database::in_memory();
        let mut other = Database::in_memory();
        for name in ["Ada", "Bo"] {
            own.observe(&observation(name)).unwrap();
        }
        other.observe(&observation("Bo")).unwrap();
        other.observe(&observation("Cy")).unwrap();
        other.note_hit("Cy", &hit("b:1", None)).unwrap();
        assert_eq!(own.observations(Some("Ada")).unwrap(), [observation("Ada")]);
        let bytes = other.bytes().unwrap().unwrap();
        for _ in 0..2 {
            own.take_in(&bytes).unwrap();
            let expected = ["Ada", "Bo", "Cy"].map(observation);
            assert_eq!(own.observations(None).unwrap(), expected);
            assert_eq!(own.notebook("Cy").unwrap().len(), 1);
        }
        // Observations are not answers.
        assert_eq!(own.attempts(None).unwrap(), []);
    }
}

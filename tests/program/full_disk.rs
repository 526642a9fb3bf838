//! A full disk: carrom reports it, and leaves no partial file on the disk.

use std::env;
use std::fs::{self, File};
use std::io::Write;
use std::path::Path;
use std::process::Command;

use carrom::levels::Starred;
use carrom::messages::{PlayerAction, StoreAnswer, StoreCall, StoreReply, StoreRequest};
use carrom::store::Store;
use rusqlite::Connection;

use crate::folder::Folder;

/// The environment variable with the folder of the small disk.
const DISK: &str = "CARROM_TEST_DISK";
/// The size of that disk in bytes.
const SIZE: u64 = 2 << 20;
/// Noon of 2026-11-21, UTC.
const NOON_S: i64 = 1_795_262_400;

/// Runs the test with this name again in a process with its own small disk. In that process,
/// returns the folder of the disk.
fn on_a_small_disk(test: &str) -> Option<String> {
    if let Ok(disk) = env::var(DISK) {
        return Some(disk);
    }
    let folder = Folder::new("full-disk");
    let script =
        format!("mount -t tmpfs -o size={SIZE} tmpfs \"${DISK}\" || exit 77; exec \"$0\" \"$@\"");
    let again = Command::new("unshare")
        .args(["-rm", "sh", "-c", &script])
        .arg(env::current_exe().unwrap())
        .args([test, "--exact", "--nocapture"])
        .env(DISK, folder.path())
        .output();
    match again {
        Ok(output) if output.status.code() != Some(77) && output.status.code() != Some(1) => {
            let said = [output.stdout, output.stderr].concat();
            let said = String::from_utf8_lossy(&said);
            assert!(output.status.success(), "{said}");
            assert!(said.contains("1 passed"), "{said}");
        }
        _ => println!("skipped: this system does not allow users to mount a disk"),
    }
    None
}

/// Fills the disk until only `free` bytes are left.
fn fill(disk: &Path, free: u64) {
    let _ = fs::remove_file(disk.join("filler"));
    let mut filler = File::create(disk.join("filler")).unwrap();
    let mut length = 0;
    while let Ok(written @ 1..) = filler.write(&[1; 4096]) {
        length += written as u64;
    }
    filler.set_len(length.saturating_sub(free)).unwrap();
}

fn ask(store: &mut Store, request: StoreRequest) -> StoreAnswer {
    store.answer(&StoreCall { ticket: 0, request })
}

fn star(store: &mut Store, level: &str) -> Result<(), String> {
    let starred = Starred {
        pack: "first".into(),
        level: level.into(),
        stars: 1,
    };
    match ask(
        store,
        StoreRequest::Note(PlayerAction::Star("Ada".into(), starred)),
    )
    .done
    {
        StoreReply::Noted(noted) => noted,
        other => panic!("{other:?}"),
    }
}

/// The number of levels that Ada has won.
fn stars(store: &mut Store) -> Result<usize, String> {
    match ask(store, StoreRequest::Stars("Ada".into())).done {
        StoreReply::Stars(stars) => stars.map(|it| it.len()),
        other => panic!("{other:?}"),
    }
}

/// An undamaged database that fills about a fifth of the disk.
fn sound(folder: &Path) -> Vec<u8> {
    star(&mut Store::in_folder(folder).timeless(), "level-0").unwrap();
    let path = folder.join("progress.db");
    let more = Connection::open(&path).unwrap();
    more.execute_batch(
        "WITH RECURSIVE place (n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM place WHERE n < 3000)
         INSERT INTO star SELECT 'Ada', 'pack', printf('%0100d', n), 1 FROM place",
    )
    .unwrap();
    drop(more);
    fs::read(path).unwrap()
}

/// The names of the files on the disk, except the filler, the lock and SQLite's files beside the
/// database.
fn names(disk: &Path) -> Vec<String> {
    let entries = fs::read_dir(disk).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<_> = names
        .filter(|name| !["filler", ".progress.lock"].contains(&name.as_str()))
        .filter(|name| !["progress.db-wal", "progress.db-shm"].contains(&name.as_str()))
        .collect();
    names.sort();
    names
}

#[test]
fn a_full_disk_is_reported_for_every_kind_of_write() {
    let Some(disk) = on_a_small_disk("full_disk::a_full_disk_is_reported_for_every_kind_of_write")
    else {
        return;
    };
    let disk = Path::new(&disk);
    for is_new in [true, false] {
        let mut failed = 0;
        for pages in 0..40 {
            for entry in fs::read_dir(disk).unwrap() {
                fs::remove_file(entry.unwrap().path()).unwrap();
            }
            if !is_new {
                star(&mut Store::in_folder(disk).timeless(), "level-0").unwrap();
            }
            fill(disk, pages * 4096);
            let mut store = Store::in_folder(disk).timeless();
            if let Err(message) = star(&mut store, "level-1") {
                failed += 1;
                println!("{pages} pages: {message}");
                assert!(
                    message.contains("there is no room on the disk"),
                    "{message}"
                );
                assert!(!message.contains("does not work"), "{message}");
            }
            fs::remove_file(disk.join("filler")).unwrap();
            assert_eq!(star(&mut store, "level-2"), Ok(()));
        }
        assert!(failed > 2, "{failed}");
    }
}

#[test]
fn a_copy_that_does_not_fit_on_the_disk_is_removed() {
    let Some(disk) = on_a_small_disk("full_disk::a_copy_that_does_not_fit_on_the_disk_is_removed")
    else {
        return;
    };
    let disk = Path::new(&disk);
    let sound = sound(disk);
    fill(disk, sound.len() as u64 / 2);
    let mut store = Store::in_folder(disk).at(NOON_S);
    assert_eq!(stars(&mut store), Ok(3001));
    assert_eq!(names(disk), ["progress.db"]);
    fs::remove_file(disk.join("filler")).unwrap();
    assert_eq!(stars(&mut Store::in_folder(disk).at(NOON_S)), Ok(3001));
    assert_eq!(
        names(disk),
        ["progress-backup-2026-11-21.db", "progress.db"]
    );
}

#[test]
fn a_repair_that_does_not_fit_on_the_disk_leaves_the_damaged_file_unchanged() {
    let Some(disk) = on_a_small_disk(
        "full_disk::a_repair_that_does_not_fit_on_the_disk_leaves_the_damaged_file_unchanged",
    ) else {
        return;
    };
    let disk = Path::new(&disk);
    let mut damaged = sound(disk);
    let path = disk.join("progress.db");
    let leaf = (1..damaged.len() / 4096).rfind(|page| damaged[page * 4096] == 10);
    let start = leaf.unwrap() * 4096;
    damaged[start..start + 4096].fill(0);
    let (mut failed, mut unrepaired) = (0, 0);
    for tenths in 0..30 {
        for name in names(disk) {
            fs::remove_file(disk.join(name)).unwrap();
        }
        let _ = fs::remove_file(disk.join("filler"));
        fs::write(&path, &damaged).unwrap();
        fill(disk, damaged.len() as u64 / 10 * tenths);
        let mut store = Store::in_folder(disk).timeless();
        match stars(&mut store) {
            Ok(stars) => {
                assert!(stars > 2900, "{stars}");
                assert_eq!(names(disk), ["progress-damaged-1.db", "progress.db"]);
            }
            Err(message) => {
                failed += 1;
                println!("{tenths} tenths: {message}");
                // Without room for its other files, SQLite does not even open the database.
                unrepaired +=
                    usize::from(message.contains("it is damaged and could not be repaired"));
                assert!(
                    message.contains("there is no room on the disk"),
                    "{message}"
                );
                assert_eq!(names(disk), ["progress.db"]);
                assert!(fs::read(&path).unwrap() == damaged);
                fs::remove_file(disk.join("filler")).unwrap();
                assert!(stars(&mut store).unwrap() > 2900);
            }
        }
    }
    assert!(failed > 5 && unrepaired > 5, "{unrepaired} of {failed}");
}

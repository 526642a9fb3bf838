//! Answers that cannot be saved at first are saved as soon as possible, in a real terminal: on a
//! disk that is full for a while, and while another program locks the database for a minute.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

use carrom::messages::{StoreCall, StoreReply, StoreRequest};
use carrom::store::Store;
use rusqlite::Connection;

use crate::folder::Folder;
use crate::pty::{Pty, carrom, command};

/// How long the database is locked.
const HELD: Duration = Duration::from_secs(60);

/// Runs carrom with its data on a small disk. Files in `$2` are signals to fill the disk and to
/// free it; at the end the script copies the database to `$2`, where it can be read.
const ON_A_SMALL_DISK: &str = "
    mount -t tmpfs -o size=512k tmpfs \"$1\" || exit 77
    (
        while [ ! -e \"$2/fill\" ]; do sleep 0.05; done
        cat /dev/zero > \"$1/filler\"
        touch \"$2/filled\"
        while [ ! -e \"$2/free\" ]; do sleep 0.05; done
        rm \"$1/filler\"
    ) 2> /dev/null &
    printf 'format = 1\\nwhat_you_saw = \"no\"\\n' > \"$1/settings.toml\"
    \"$3\" quiz --code hits-7 --data-dir \"$1\"
    cp \"$1\"/progress.db* \"$2\"
";

/// Answers the question with this number, and reads the explanation.
fn answer(pty: &mut Pty, number: u32) {
    pty.wait_for(&format!("question {number} of 10"));
    pty.press("60\r30\r");
    pty.wait_for("How sure are you?");
    pty.press("2");
    pty.wait_until("the result", |screen| !screen.contains("How sure are you?"));
    if pty.screen().contains("please note") {
        pty.press("x");
        pty.wait_until("the notice to close", |screen| {
            !screen.contains("please note")
        });
    }
    pty.press("\x1b[F");
    pty.wait_for("of 10 points");
}

/// Waits until everything is saved, and quits.
fn leave(mut pty: Pty) {
    pty.wait_until("everything to be saved", |screen| {
        !screen.contains("not saved") && !screen.contains("saving ..")
    });
    pty.press("\x03");
    assert_eq!(pty.wait(), 0);
    pty.assert_restored();
}

/// The numbers of the questions whose answers are stored.
fn kept(folder: &Path) -> Vec<u32> {
    let request = StoreRequest::Recall(None);
    let mut store = Store::in_folder(folder).only_looking();
    match store.answer(&StoreCall { ticket: 0, request }).done {
        StoreReply::Recalled(Ok(history)) => history.attempts.iter().map(|it| it.number).collect(),
        other => panic!("{other:?}"),
    }
}

pub(crate) fn answers_given_while_the_disk_is_full_are_saved_afterwards() {
    let can_mount = Command::new("unshare")
        .args(["-rm", "mount", "-t", "tmpfs", "tmpfs", "/mnt"])
        .output();
    if !can_mount.is_ok_and(|tried| tried.status.success()) {
        println!("skipped: this system does not allow users to mount a disk");
        return;
    }
    let (disk, told) = (Folder::new("unsaved-disk"), Folder::new("unsaved-told"));
    let [disk, told] = [&disk, &told].map(|it| it.path().to_str().unwrap());
    let program = env!("CARGO_BIN_EXE_carrom");
    let arguments = [
        "-rm",
        "sh",
        "-c",
        ON_A_SMALL_DISK,
        "sh",
        disk,
        told,
        program,
    ];
    let mut pty = Pty::start(command("unshare", &arguments));
    answer(&mut pty, 1);
    pty.press("\r");
    let told = Path::new(told);
    fs::write(told.join("fill"), "").unwrap();
    pty.wait_until("the disk to be full", |_| told.join("filled").exists());
    for number in 2..=5 {
        answer(&mut pty, number);
        pty.wait_for(&format!("not saved: {}", number - 1));
        pty.press("\r");
    }
    fs::write(told.join("free"), "").unwrap();
    leave(pty);
    assert_eq!(kept(told), [1, 2, 3, 4, 5]);
}

#[test]
#[ignore = "takes a minute"]
fn answers_given_while_the_database_is_locked_are_saved_afterwards() {
    let folder = Folder::new("unsaved-held");
    let data = folder.path().to_str().unwrap();
    let settings = "format = 1\nwhat_you_saw = \"no\"\n";
    fs::write(folder.path().join("settings.toml"), settings).unwrap();
    let mut pty = Pty::start(carrom(&["quiz", "--code", "hits-7", "--data-dir", data]));
    answer(&mut pty, 1);
    let other = Connection::open(folder.path().join("progress.db")).unwrap();
    other.execute_batch("BEGIN IMMEDIATE").unwrap();
    let start = Instant::now();
    for number in 2..=8 {
        pty.press("\r");
        answer(&mut pty, number);
    }
    // carrom shows this notice after it has waited for the lock for a while.
    pty.wait_for("not saved: 7");
    thread::sleep(HELD.saturating_sub(start.elapsed()));
    pty.wait_for("not saved: 7");
    other.execute_batch("COMMIT").unwrap();
    leave(pty);
    assert_eq!(kept(folder.path()), [1, 2, 3, 4, 5, 6, 7, 8]);
}

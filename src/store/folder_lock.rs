//! A lock on a folder that several copies of carrom use.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind};
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

/// How long to wait for other copies of carrom that use the same folder.
const PATIENCE: Duration = Duration::from_secs(3);

/// A lock that is held until it is dropped or the process ends.
pub(super) struct FolderLock {
    _lock: File,
    locked: bool,
}

impl FolderLock {
    /// Waits for an exclusive lock on `lock`, a file in `folder`; the folder is created if it does
    /// not exist.
    pub(super) fn alone(folder: &Path, lock: &str) -> io::Result<Self> {
        Self::take(folder, lock, File::try_lock)
    }

    /// Waits for a shared lock, which excludes only [`FolderLock::alone`].
    pub(super) fn shared(folder: &Path, lock: &str) -> io::Result<Self> {
        Self::take(folder, lock, File::try_lock_shared)
    }

    /// Whether the lock was really acquired, so that no other copy of carrom interferes.
    pub(super) fn is_certain(&self) -> bool {
        self.locked
    }

    fn take(
        folder: &Path,
        lock: &str,
        take: impl Fn(&File) -> Result<(), TryLockError>,
    ) -> io::Result<Self> {
        fs::create_dir_all(folder)?;
        let lock = OpenOptions::new()
            .create(true)
            .truncate(false)
            .read(true)
            .write(true)
            .open(folder.join(lock))?;
        let start = Instant::now();
        let locked = loop {
            match take(&lock) {
                Ok(()) => break true,
                Err(TryLockError::WouldBlock) if start.elapsed() < PATIENCE => {
                    thread::sleep(Duration::from_millis(5));
                }
                Err(TryLockError::WouldBlock) => {
                    let why = "another copy of carrom has been busy there for too long";
                    return Err(io::Error::new(ErrorKind::TimedOut, why));
                }
                // Some network folders do not support locks. Without a lock, work in the folder is
                // safe unless two copies of carrom do it at the same instant.
                Err(TryLockError::Error(_)) => break false,
            }
        };
        Ok(Self {
            _lock: lock,
            locked,
        })
    }
}

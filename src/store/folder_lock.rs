//! A lock between several carroms.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind};
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

/// How long to wait for other carroms that are at the same folder.
const PATIENCE: Duration = Duration::from_secs(3);

/// A held lock, until this is dropped or the process ends.
pub(super) struct FolderLock {
    _lock: File,
    /// Whether the lock was really acquired.
    locked: bool,
}

impl FolderLock {
    /// Waits until nobody else has a turn at `lock`, a file in `folder`, which is made
    /// if need be.
    pub(super) fn alone(folder: &Path, lock: &str) -> io::Result<Self> {
        Self::take(folder, lock, File::try_lock)
    }

    /// Waits until nobody is [`FolderLock::alone`] there; others may share it.
    pub(super) fn shared(folder: &Path, lock: &str) -> io::Result<Self> {
        Self::take(folder, lock, File::try_lock_shared)
    }

    /// Whether nobody else does the same, as far as that can be known.
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
                    let why = "another carrom has been busy there for too long";
                    return Err(io::Error::new(ErrorKind::TimedOut, why));
                }
                // Some network folders know no locks. What is done under one is safe
                // without, but for two carroms that do it in the same instant.
                Err(TryLockError::Error(_)) => break false,
            }
        };
        Ok(Self {
            _lock: lock,
            locked,
        })
    }
}

//! What several tests share.

pub mod bad_files;
pub mod child;
pub mod families;
pub mod folder;
pub mod keys;
pub mod lessons;
pub mod play;
#[cfg(unix)]
pub mod pty;

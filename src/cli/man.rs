//! `carrom man`: the manual page.

use clap::Command;

use super::Failure;

pub(super) fn run(command: Command) -> Result<(), Failure> {
    let mut page = Vec::new();
    clap_mangen::Man::new(command).render(&mut page)?;
    super::print(&page)
}

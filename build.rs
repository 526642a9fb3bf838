//! Rebuilds the program when a level or a chapter is added, because `include_dir!` itself notices
//! only changes to files that it already knows. Also embeds the page for browsers if `CARROM_PAGE`
//! names one.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=levels");
    println!("cargo::rerun-if-changed=assets/lessons");
    println!("cargo::rerun-if-env-changed=CARROM_PAGE");
    let page = env::var_os("CARROM_PAGE").map(PathBuf::from);
    let text = match page {
        Some(page) => {
            let page = fs::canonicalize(page)?;
            println!("cargo::rerun-if-changed={}", page.display());
            format!("Some(include_str!({page:?}))")
        }
        None => "None".to_owned(),
    };
    let out = env::var_os("OUT_DIR").unwrap_or_default();
    fs::write(Path::new(&out).join("page.rs"), text)
}

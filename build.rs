//! Rebuilds the program when a level, a chapter, a question in words or an example is added, because
//! `include_dir!` itself notices only changes to files that it already knows. Also embeds the page
//! for browsers: the file that `CARROM_PAGE` names, otherwise the one in the published package.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// Where `.ci/crate` puts the page in the package; the repository has no such file.
const PACKAGED: &str = "carrom.html";

fn main() -> io::Result<()> {
    for folder in [
        "levels",
        "assets/lessons",
        "assets/concepts",
        "assets/examples",
    ] {
        println!("cargo::rerun-if-changed={folder}");
    }
    println!("cargo::rerun-if-env-changed=CARROM_PAGE");
    let packaged = || Some(PathBuf::from(PACKAGED)).filter(|page| page.is_file());
    let text = match env::var_os("CARROM_PAGE")
        .map(PathBuf::from)
        .or_else(packaged)
    {
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

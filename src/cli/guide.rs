//! `carrom guide`: the built-in guides for teachers.

use std::path::{Path, PathBuf};

use super::{Failure, GlobalOptions, print_text, written};
use crate::files::Document;
use crate::numbers::capital;
use crate::paper::guide::{GUIDES, Guide, guide_page};

/// Read the guides: how to run a class, how to write levels and chapters, and what is simulated
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The guide to print (default: a list of all guides)
    #[arg(value_name = "NAME", value_parser = find)]
    name: Option<&'static Guide>,
    /// Write all guides as HTML to this folder; created if it does not exist
    #[arg(long, value_name = "DIR", conflicts_with = "name")]
    out: Option<PathBuf>,
    /// Replace existing guides
    #[arg(long, requires = "out")]
    force: bool,
}

pub(super) fn run(args: &Args, options: &GlobalOptions) -> Result<(), Failure> {
    if let Some(folder) = &args.out {
        return written::write_named(&documents(folder), args.force);
    }
    let text = match args.name {
        Some(guide) => guide.markdown.to_owned(),
        None => list(),
    };
    print_text(text.trim_end(), options)
}

/// The list of guides, and how to read them.
fn list() -> String {
    let line = |guide: &Guide| format!("  carrom guide {:<14}{}\n", guide.name, guide.about);
    let lines: String = GUIDES.iter().map(line).collect();
    format!("{lines}\nAll guides for a browser: carrom guide --out DIR")
}

/// The guides as HTML pages, and an index that links to them.
fn documents(folder: &Path) -> Vec<Document> {
    let link = |guide: &Guide| format!("- [{}]({}.md)\n", capital(guide.about), guide.name);
    let links: String = GUIDES.iter().map(link).collect();
    let contents = format!("# Guides to carrom\n\n{links}");
    let page = |name: &str, text: &str| (folder.join(format!("{name}.html")), guide_page(text));
    let guides = GUIDES.iter().map(|guide| {
        // In the Markdown source, this link points outside the folder of the guides.
        let text = guide.markdown.replace("../levels/README.md", "levels.md");
        page(guide.name, &text)
    });
    std::iter::once(page("index", &contents))
        .chain(guides)
        .collect()
}

fn find(name: &str) -> Result<&'static Guide, String> {
    let found = GUIDES.iter().find(|guide| guide.name == name);
    let names: Vec<_> = GUIDES.iter().map(|guide| guide.name).collect();
    found.ok_or_else(|| format!("expected one of {}", names.join(", ")))
}

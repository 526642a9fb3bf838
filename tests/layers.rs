//! Checks the layers of the crate: higher modules may use lower ones, never the reverse, and
//! modules of one layer do not use each other. The layers (`floors`) and modules (`rooms`) are
//! read from the maps in the documentation: for the crate in `lib.rs`, and for the inside of a
//! module in its `mod.rs`.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs;
use std::path::{Path, PathBuf};

/// The modules with a map of their inner layers.
const MAPPED: [&str; 2] = ["quiz", "widgets"];

/// The layers of the crate (`room` is empty) or inside one of its modules.
struct Map {
    room: String,
    floors: Vec<Vec<String>>,
    /// The names that the `mod.rs` of the module re-exports, and the inner module of each.
    taken: HashMap<String, String>,
}

impl Map {
    /// Reads the map in the documentation at the start of `source`: lines of dashes separate the
    /// layers, from the top; each module begins a line, and its description is indented further.
    fn parse(room: &str, source: &str) -> Self {
        let mut floors = vec![Vec::new()];
        let lines = source.lines().map_while(|line| line.strip_prefix("//!"));
        let map = lines
            .skip_while(|line| line.trim() != "```text")
            .skip(1)
            .take_while(|line| line.trim() != "```");
        let mut indent = None;
        for line in map {
            let entry = line.trim_start();
            let blanks = line.len() - entry.len();
            if entry.starts_with('─') {
                floors.push(Vec::new());
            } else if blanks == *indent.get_or_insert(blanks) {
                let name = entry.split_whitespace().next().unwrap_or_default();
                let name = name.trim_end_matches('/').trim_end_matches(".rs");
                floors.last_mut().unwrap().push(name.to_owned());
            }
        }
        let mut uses = Vec::new();
        for statement in code(source).split("use ").skip(1) {
            branches(statement, &[], &mut uses);
        }
        let taken = uses.iter().filter_map(|path| match path.as_slice() {
            [from, .., name] => Some((name.clone(), from.clone())),
            _ => None,
        });
        Self {
            room: room.to_owned(),
            taken: taken.collect(),
            floors,
        }
    }

    fn read(room: &str) -> Self {
        let file = if room.is_empty() { "lib.rs" } else { "mod.rs" };
        let source = fs::read_to_string(src().join(room).join(file)).unwrap();
        Self::parse(room, &source)
    }

    /// The layer of a module, counted from the top.
    fn floor(&self, room: &str) -> Option<usize> {
        let rooms = |floor: &Vec<String>| floor.iter().any(|other| other == room);
        self.floors.iter().position(rooms)
    }

    /// The part of a path that may name a module of this map.
    fn place<'a>(&self, path: &'a [String]) -> Option<&'a str> {
        let inner = match path {
            [room, inner @ ..] if !self.room.is_empty() && *room == self.room => inner,
            _ if self.room.is_empty() => path,
            _ => return None,
        };
        inner.first().map(String::as_str)
    }

    /// The error if code in `from` uses `to` and the map does not allow it.
    fn fault(&self, from: &[String], to: &[String]) -> Option<String> {
        let (from, to) = (self.place(from)?, self.place(to)?);
        let to = match self.taken.get(to) {
            Some(room) if self.floor(to).is_none() => room,
            _ => to,
        };
        let below = match (self.floor(from), self.floor(to)) {
            (Some(from), Some(to)) => from < to,
            // The `mod.rs` itself is above all modules inside it.
            (Some(_), None) => self.room.is_empty(),
            (None, _) => true,
        };
        (from != to && !below).then(|| format!("{from} uses {to}"))
    }
}

fn src() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// `source` without its comments, whose links may point anywhere.
fn code(source: &str) -> String {
    let lines = source.lines().map(|line| {
        let comment = line.find("//").unwrap_or(line.len());
        &line[..comment]
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// Adds every path in `code` that begins with `crate::` or `super::`, resolved from the root of the
/// crate; `here` is the module of the code.
fn paths(code: &str, here: &[String], found: &mut Vec<Vec<String>>) {
    let of_name = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let mut rest = code;
    while let Some(start) = rest
        .find("crate::")
        .into_iter()
        .chain(rest.find("super::"))
        .min()
    {
        let apart = !rest[..start].ends_with(of_name);
        rest = &rest[start..];
        let mut above = here.len();
        if let Some(after) = rest.strip_prefix("crate::") {
            (rest, above) = (after, 0);
        }
        while let Some(after) = rest.strip_prefix("super::") {
            (rest, above) = (after, above.saturating_sub(1));
        }
        if apart {
            branches(rest, &here[..above], found);
        }
    }
}

/// Adds the paths of `tree`, a path or a list in braces, relative to `trunk`.
fn branches(tree: &str, trunk: &[String], found: &mut Vec<Vec<String>>) {
    let tree = tree.trim_start();
    if let Some(list) = tree.strip_prefix('{') {
        let (mut depth, mut start) = (0, 0);
        for (i, c) in list.char_indices() {
            match c {
                '{' => depth += 1,
                '}' | ',' if depth == 0 => {
                    branches(&list[start..i], trunk, found);
                    start = i + 1;
                }
                '}' => depth -= 1,
                _ => {}
            }
            if c == '}' && start == i + 1 {
                break;
            }
        }
        return;
    }
    let end = tree.find(|c: char| !c.is_alphanumeric() && c != '_');
    let (name, after) = tree.split_at(end.unwrap_or(tree.len()));
    let mut path = trunk.to_vec();
    if !name.is_empty() && name != "self" {
        path.push(name.to_owned());
    }
    match after.strip_prefix("::") {
        Some(after) if !name.is_empty() => branches(after, &path, found),
        _ => found.push(path),
    }
}

/// The uses in `source` that a map does not allow; `path` is its path in `src`.
fn trespasses(maps: &[Map], path: &str, source: &str) -> Vec<String> {
    let module = path.trim_end_matches(".rs").trim_end_matches("/mod");
    let module: Vec<_> = module.split('/').map(str::to_owned).collect();
    let code = code(source);
    let (code, tests) = code.split_once("\nmod tests {").unwrap_or((&code, ""));
    let mut used = Vec::new();
    paths(code, &module, &mut used);
    let inside = [module.as_slice(), &["tests".to_owned()]].concat();
    paths(tests, &inside, &mut used);
    let faults = used
        .iter()
        .flat_map(|to| maps.iter().filter_map(|map| map.fault(&module, to)));
    let faults: BTreeSet<_> = faults.collect();
    let told = faults.iter().map(|fault| format!("src/{path}: {fault}"));
    told.collect()
}

/// Calls `look` for every source file in `folder` and its subfolders.
fn each_source(folder: &Path, look: &mut impl FnMut(&Path)) {
    for entry in folder.read_dir().unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            each_source(&path, look);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            look(&path);
        }
    }
}

/// The code of the crate by module, without comments and tests.
struct Files {
    code: BTreeMap<Vec<String>, String>,
    /// The names that a file imports from modules inside it, and the path of each.
    taken: BTreeMap<(Vec<String>, String), Vec<String>>,
}

impl Files {
    fn new<'s>(sources: impl IntoIterator<Item = (&'s str, String)>) -> Self {
        let module = |path: &str| {
            let path = path.trim_end_matches(".rs").trim_end_matches("/mod");
            path.split('/').map(str::to_owned).collect::<Vec<_>>()
        };
        let code_of = |source: String| {
            let code = code(&source);
            let end = code.find("\nmod tests {").unwrap_or(code.len());
            code[..end].to_owned()
        };
        let sources = sources.into_iter();
        let code = sources.map(|(path, source)| (module(path), code_of(source)));
        let mut files = Self {
            code: code.collect(),
            taken: BTreeMap::new(),
        };
        for (module, code) in &files.code {
            let mut used = Vec::new();
            for statement in code.split("use ").skip(1) {
                branches(statement, &[], &mut used);
            }
            for path in used {
                if let [first, .., name] = path.as_slice()
                    && files
                        .code
                        .contains_key(&[module.as_slice(), std::slice::from_ref(first)].concat())
                {
                    let from = [module, &path[..]].concat();
                    files.taken.insert((module.clone(), name.clone()), from);
                }
            }
        }
        files
    }

    /// The file that defines the item at a path, even if other files re-export it.
    fn home(&self, path: &[String]) -> Option<&Vec<String>> {
        let lengths = (1..=path.len()).rev();
        let mut known = lengths.filter_map(|it| self.code.get_key_value(&path[..it]));
        let (module, _) = known.next()?;
        let name = path.get(module.len());
        let from = name.and_then(|name| self.taken.get(&(module.clone(), name.clone())));
        match from {
            Some(from) if from.len() > path.len() => self.home(from),
            _ => Some(module),
        }
    }

    /// The files that a file uses.
    fn used(&self, module: &Vec<String>) -> BTreeSet<&Vec<String>> {
        let code = &self.code[module];
        let mut used = Vec::new();
        paths(code, module, &mut used);
        // Paths to modules inside this one need not begin with `crate` or `super`.
        for below in self.code.keys().filter(|it| it.starts_with(module)) {
            if let [name] = &below[module.len()..] {
                let name = format!("{name}::");
                let apart = |at: usize| {
                    !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == ':')
                };
                for (at, _) in code.match_indices(&name).filter(|(at, _)| apart(*at)) {
                    branches(&code[at..], module, &mut used);
                }
            }
        }
        let homes = used.iter().filter_map(|path| self.home(path));
        // What a file defines is shared by all modules inside it, so using that does not count.
        homes.filter(|home| !module.starts_with(home)).collect()
    }

    /// The dependency cycles: sets of files that can be reached from each other, the largest first.
    fn circles(&self) -> Vec<BTreeSet<String>> {
        let uses: BTreeMap<_, _> = self.code.keys().map(|it| (it, self.used(it))).collect();
        let reached = |from| {
            let mut reached = BTreeSet::new();
            let mut open = vec![from];
            while let Some(file) = open.pop() {
                open.extend(uses[file].iter().filter(|it| reached.insert(**it)));
            }
            reached
        };
        let reach: BTreeMap<_, _> = self.code.keys().map(|it| (it, reached(it))).collect();
        let circle = |file: &&Vec<String>| -> BTreeSet<String> {
            let both = reach[*file].iter().filter(|it| reach[**it].contains(*file));
            both.map(|it| it.join("/")).collect()
        };
        let all: BTreeSet<_> = self.code.keys().map(|it| circle(&it)).collect();
        let mut all: Vec<_> = all.into_iter().filter(|it| !it.is_empty()).collect();
        all.sort_by_key(|it| Reverse(it.len()));
        all
    }
}

/// The largest allowed number of files in a dependency cycle.
const LARGEST_CIRCLE: usize = 3;

#[test]
fn dependency_cycles_are_small() {
    let mut sources = Vec::new();
    each_source(&src(), &mut |path| {
        let place = path.strip_prefix(src()).unwrap().to_str().unwrap();
        if place != "lib.rs" && place != "main.rs" {
            sources.push((place.replace('\\', "/"), fs::read_to_string(path).unwrap()));
        }
    });
    let sources = sources.iter();
    let files = Files::new(sources.map(|(path, source)| (path.as_str(), source.clone())));
    let circles = files.circles().into_iter();
    let large = circles.filter(|circle| circle.len() > LARGEST_CIRCLE);
    let told: Vec<_> = large
        .map(|circle| format!("{} files in a cycle: {circle:?}", circle.len()))
        .collect();
    assert!(told.is_empty(), "{}", told.join("\n"));
}

#[test]
fn a_cycle_is_found_in_every_notation() {
    let sources = |shared: &str| {
        [
            (
                "lab/mod.rs",
                "mod a;\nmod b;\nmod c;\npub use a::A;\nfn f() { b::f() }".to_owned(),
            ),
            (
                "lab/a.rs",
                "use super::{b::B, c};\npub struct A;".to_owned(),
            ),
            ("lab/b.rs", format!("use {shared};")),
            (
                "lab/c.rs",
                "use crate::lab::b;\n#[cfg(test)]\nmod tests {\n    use super::super::A;\n}"
                    .to_owned(),
            ),
        ]
    };
    let circles = |shared: &str| Files::new(sources(shared)).circles();
    // The cycle goes through the `mod.rs` that re-exports `A`.
    let circle = ["lab/a", "lab/b", "lab/c"].map(str::to_owned);
    assert_eq!(circles("super::A"), [BTreeSet::from(circle)]);
    // Items of the `mod.rs` itself are shared by all modules inside it.
    assert_eq!(circles("super::f"), []);
    assert_eq!(circles("crate::physics::Disc"), []);
}

/// The map of the crate and the maps inside its modules.
fn maps() -> Vec<Map> {
    let rooms = [""].into_iter().chain(MAPPED);
    rooms.map(Map::read).collect()
}

/// The cells of tables are made safe in one file, so no other file may write tables.
#[test]
fn only_one_file_writes_comma_separated_values() {
    let mut found = Vec::new();
    each_source(&src(), &mut |path| {
        if fs::read_to_string(path).unwrap().contains("csv::Writer") {
            found.push(path.strip_prefix(src()).unwrap().to_owned());
        }
    });
    assert_eq!(found, [Path::new("files").join("csv_table.rs")]);
}

#[test]
fn every_module_uses_only_lower_ones() {
    let maps = maps();
    let mut found = Vec::new();
    let mut seen = 0;
    each_source(&src(), &mut |path| {
        let place = path.strip_prefix(src()).unwrap().to_str().unwrap();
        if place != "lib.rs" && place != "main.rs" {
            seen += 1;
            let place = place.replace('\\', "/");
            let source = fs::read_to_string(path).unwrap();
            found.extend(trespasses(&maps, &place, &source));
        }
    });
    assert!(seen > 20, "only {seen} files were found");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn the_maps_show_every_module_and_no_other() {
    for map in maps() {
        let entries = src().join(&map.room).read_dir().unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let rooms: BTreeSet<String> = names
            .map(|name| name.trim_end_matches(".rs").to_owned())
            .filter(|name| !["lib", "mod", "tests"].contains(&name.as_str()))
            .collect();
        let shown: Vec<_> = map.floors.concat();
        let once: BTreeSet<_> = shown.iter().cloned().collect();
        assert_eq!(once, rooms, "the map of src/{}", map.room);
        assert_eq!(once.len(), shown.len(), "a module is shown twice");
        assert!(map.floors.len() > 1, "src/{} has only one layer", map.room);
    }
}

/// Two example maps: of a crate and of its module `quiz`.
fn example() -> [Map; 2] {
    let crate_map = "//! # Modules\n//!\n//! ```text\n\
        //!   main.rs    runs\n//!   cli/       commands\n//!   ────\n\
        //!   shells/    what drives the app: a terminal,\n//!              a tape\n//!   ────\n\
        //!   app/\n//!   ────\n//!   screens/\n//!   ────\n//!   widgets/\n//!   ────\n\
        //!   messages/\n//!   ────\n//!   quiz/\n//!   levels/\n//!   ────\n\
        //!   physics/\n//! ```\n\npub mod app;\n";
    let quiz_map = "//! ```text\n//!   rounds/\n//!   ──\n//!   families/\n//!   concepts/\n\
        //!   ──\n//!   question/\n//! ```\n\
        pub(crate) use question::Question;\npub use rounds::{Round, code::Code};\npub struct Quiz;\n";
    [Map::parse("", crate_map), Map::parse("quiz", quiz_map)]
}

#[test]
fn a_map_is_read_from_its_drawing() {
    let [whole, quiz] = example();
    assert_eq!(whole.floors[0], ["main", "cli"]);
    assert_eq!(whole.floors[1], ["shells"]);
    assert_eq!(whole.floors[6], ["quiz", "levels"]);
    assert_eq!(whole.floors.len(), 8);
    assert_eq!(quiz.floors[1], ["families", "concepts"]);
    assert_eq!(quiz.taken["Code"], "rounds");
}

#[test]
fn a_forbidden_use_is_found_in_every_notation() {
    for (path, source, expected) in [
        (
            "physics/disc.rs",
            "use crate::widgets::Role;",
            "physics uses widgets",
        ),
        (
            "physics/mod.rs",
            "fn f() { crate::app::f() }",
            "physics uses app",
        ),
        (
            "quiz/mod.rs",
            "use crate::{physics::Disc, levels};",
            "quiz uses levels",
        ),
        (
            "quiz/a.rs",
            "use crate::{\n  physics::{Disc, A},\n  screens,\n};",
            "quiz uses screens",
        ),
        (
            "levels/scene.rs",
            "use super::super::quiz::Question;",
            "levels uses quiz",
        ),
        (
            "widgets/mod.rs",
            "use super::screens::Screen;",
            "widgets uses screens",
        ),
        (
            "screens/lab/view.rs",
            "use super::super::super::app::App;",
            "screens uses app",
        ),
        ("app/mod.rs", "pub(crate) use crate::cli;", "app uses cli"),
        (
            "levels/scene.rs",
            "#[cfg(test)]\nmod tests {\n    use super::super::super::quiz;\n}",
            "levels uses quiz",
        ),
        // Inside a module.
        (
            "quiz/question/mod.rs",
            "use super::rounds::Round;",
            "question uses rounds",
        ),
        (
            "quiz/families/speeds.rs",
            "use crate::quiz::{concepts::Library, question::Question};",
            "families uses concepts",
        ),
        (
            "quiz/question/grade.rs",
            "use super::super::Round;",
            "question uses rounds",
        ),
        (
            "quiz/question/grade.rs",
            "use crate::{physics::Disc, quiz::{Quiz}};",
            "question uses Quiz",
        ),
    ] {
        let found = trespasses(&example(), path, source);
        assert_eq!(found, [format!("src/{path}: {expected}")]);
    }
}

#[test]
fn allowed_uses_are_accepted() {
    for (path, source) in [
        ("cli/tape.rs", "use crate::shells::tape;"),
        (
            "quiz/mod.rs",
            "use crate::physics::Disc; use super::quiz::x; pub use rounds::Round;",
        ),
        (
            "physics/disc.rs",
            "/// See [`crate::widgets`].\n// crate::app\nuse crate::physics::x;",
        ),
        (
            "screens/lab/view.rs",
            "use super::super::Route; use crate::screens::Context;",
        ),
        (
            "shells/tape/mod.rs",
            "use crate::{app::App, messages::{Key, Input}};",
        ),
        (
            "quiz/rounds/code.rs",
            "use super::Round; use super::super::{families::{self, Family}, question::*};",
        ),
        (
            "quiz/rounds/code.rs",
            "use super::Round;\n#[cfg(test)]\nmod tests {\n    use super::super::Round;\n}",
        ),
        (
            "quiz/families/speeds.rs",
            "use crate::quiz::{Question, question::Hit}; use super::super::Question;",
        ),
        ("screens/quiz/mod.rs", "use crate::quiz::Round;"),
    ] {
        assert_eq!(
            trespasses(&example(), path, source),
            Vec::<String>::new(),
            "{path}"
        );
    }
}

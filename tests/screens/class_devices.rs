//! A tape plays a whole class on its own devices: the host and six pupils.

use std::collections::BTreeMap;
use std::fs;

use carrom::cli;
use carrom::shells::Headless;
use carrom::shells::tape::{Tape, play};
use carrom::store::Store;

use crate::folder::Folder;

const TAPE: &str = include_str!("../classes/devices.tape");

/// Screens and tables alike, byte by byte.
#[test]
fn a_tape_plays_a_class_and_is_the_same_every_time() {
    let (run, steps) = TAPE.split_at(TAPE.find("Expect").unwrap());
    for set in [
        "Set Size 80x24\nSet Charset ascii\n",
        "Set Size 80x24\nSet Charset unicode\nSet Color truecolor\n",
    ] {
        let tape = Tape::parse(&format!("{run}{set}{steps}")).unwrap();
        let [once, again] = [0; 2].map(|_| {
            let folder = Folder::new("class-devices");
            let open = |arguments: &str| {
                let store = Store::in_folder(folder.path()).timeless();
                Ok(Headless::keeping(cli::open(arguments)?, 80, 24, store))
            };
            let screens = play(&tape, open).unwrap_or_else(|error| panic!("{set}{error}"));
            let texts = screens.iter().map(|screen| (screen.text(), screen.svg()));
            let exports = fs::read_dir(folder.path().join("exports")).unwrap();
            let tables: BTreeMap<_, _> = exports
                .map(|entry| entry.unwrap().path())
                .filter(|path| path.extension().is_some_and(|it| it == "csv"))
                .map(|path| {
                    (
                        path.file_name().unwrap().to_owned(),
                        fs::read(&path).unwrap(),
                    )
                })
                .collect();
            (texts.collect::<Vec<_>>(), tables)
        });
        assert_eq!((once.0.len(), once.1.len()), (4, 2));
        assert!(once == again, "{set}");
    }
}

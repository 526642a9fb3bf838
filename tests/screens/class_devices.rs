//! A tape plays a whole class on its own devices: the host and six pupils.

use carrom::cli;
use carrom::shells::tape::{Tape, play};

const TAPE: &str = include_str!("../classes/devices.tape");

#[test]
fn a_tape_plays_a_class_and_is_the_same_every_time() {
    let (run, steps) = TAPE.split_at(TAPE.find("Expect").unwrap());
    for set in [
        "Set Size 80x24\nSet Charset ascii\n",
        "Set Size 80x24\nSet Charset unicode\nSet Color truecolor\n",
    ] {
        let tape = Tape::parse(&format!("{run}{set}{steps}")).unwrap();
        let [once, again] = [0; 2].map(|_| {
            let screens = play(&tape, cli::open).unwrap_or_else(|error| panic!("{set}{error}"));
            let texts = screens.iter().map(|screen| (screen.text(), screen.svg()));
            texts.collect::<Vec<_>>()
        });
        assert_eq!(once.len(), 4);
        assert!(once == again, "{set}");
    }
}

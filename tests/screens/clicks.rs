//! On a screen of any size, a click beside a picture activates the target that is drawn there.

use std::cell::Cell;

use carrom::screens::Settings;
use carrom::widgets::Charset;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::{RngSeed, TestRunner};

use crate::key_tables::{Moment, moments, seen};
use crate::thorough::cases;

/// A screen, and a cell of one of its targets.
#[derive(Debug, Clone)]
struct Clicked {
    size: (u16, u16),
    charset: Charset,
    target: Index,
    cell: [Index; 2],
}

fn clicked() -> impl Strategy<Value = Clicked> {
    let charsets = select(vec![Charset::Ascii, Charset::Unicode]);
    let sizes = (40_u16..200, 16_u16..70);
    let parts = (sizes, charsets, any::<Index>(), any::<[Index; 2]>());
    parts.prop_map(|(size, charset, target, cell)| Clicked {
        size,
        charset,
        target,
        cell,
    })
}

/// Clicks on a target, and activates the same target directly in a second game. Returns whether
/// there was a target, and whether the click changed anything.
fn click(moment: &Moment, clicked: &Clicked) -> Result<Option<bool>, TestCaseError> {
    let game = || {
        let mut game = moment.with(Settings {
            charset: clicked.charset,
            ..Settings::default()
        });
        game.resize(clicked.size.0, clicked.size.1);
        game
    };
    let mut by_click = game();
    let targets = by_click.app().targets();
    if targets.is_empty() {
        return Ok(None);
    }
    let number = clicked.target.index(targets.len());
    let cells = targets[number];
    let [across, down] = &clicked.cell;
    let before = seen(&mut by_click);
    by_click.click((
        cells.x + across.index(cells.width.into()) as u16,
        cells.y + down.index(cells.height.into()) as u16,
    ));
    let mut by_choice = game();
    by_choice.choose(number);
    let after = seen(&mut by_choice);
    prop_assert!(
        seen(&mut by_click) == after,
        "{}: target {number} at {cells:?}",
        moment.name
    );
    Ok(Some(after != before))
}

#[test]
fn a_click_on_a_target_does_what_the_target_does() {
    let (clicks, changes) = (Cell::new(0), Cell::new(0));
    for (number, moment) in (0..).zip(moments()) {
        let mut runner = TestRunner::new(ProptestConfig {
            // At each random size of the screen, one target is clicked.
            cases: cases(4, 12),
            failure_persistence: None,
            rng_seed: RngSeed::Fixed(number),
            ..ProptestConfig::default()
        });
        let outcome = runner.run(&clicked(), |clicked| {
            if let Some(changed) = click(&moment, &clicked)? {
                clicks.set(clicks.get() + 1);
                changes.set(changes.get() + u32::from(changed));
            }
            Ok(())
        });
        outcome.unwrap();
    }
    let (clicks, changes) = (clicks.get(), changes.get());
    // A click on a line that is already chosen may change nothing.
    assert!(
        clicks > cases(150, 400) && 5 * changes > 4 * clicks,
        "{changes} of {clicks}"
    );
}

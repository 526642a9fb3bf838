//! What is clicked beside a picture is what stands there.

use crate::key_tables::{moments, seen};

#[test]
fn a_click_in_the_middle_of_a_target_does_what_the_target_does() {
    let mut targets = 0;
    for size in [(80, 24), (120, 40), (60, 20), (61, 50)] {
        for moment in moments() {
            let game = || {
                let mut game = moment.game();
                game.resize(size.0, size.1);
                game
            };
            for (number, cells) in game().app().targets().into_iter().enumerate() {
                let (mut clicked, mut chosen) = (game(), game());
                clicked.click((cells.x + cells.width / 2, cells.y + cells.height / 2));
                chosen.choose(number);
                assert!(
                    seen(&mut clicked) == seen(&mut chosen),
                    "{} at {size:?}: target {number} at {cells:?}",
                    moment.name
                );
                targets += 1;
            }
        }
    }
    assert!(targets > 100, "{targets}");
}

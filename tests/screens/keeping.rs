//! What the player sees of keeping when it does not go as it should.

use carrom::app::App;
use carrom::messages::{Input, StoreAnswer, StoreReply};
use carrom::screens::{Place, Settings};
use carrom::shells::Headless;

#[test]
fn what_takes_long_and_what_is_lost_is_told_each_time() {
    let app = App::new(Place::Lab, Settings::default(), 1);
    let mut game = Headless::from(app);
    let kept = |ticket, done: Result<(), String>| {
        Input::Kept(Box::new(StoreAnswer {
            ticket,
            done: StoreReply::Noted(done),
            notice: None,
        }))
    };
    let lost = |ticket| kept(ticket, Err("it is locked".into()));
    let head = |game: &mut Headless| game.screen().lines().next().unwrap().to_owned();
    let calm = head(&mut game);
    game.input(&Input::Saving(901));
    assert!(head(&mut game).contains("saving"));
    game.input(&kept(901, Ok(())));
    assert_eq!(head(&mut game), calm);
    game.input(&Input::Saving(902));
    game.input(&lost(902));
    assert!(head(&mut game).contains("not kept: 1"));
    assert!(game.screen().contains("it is locked"));
    game.press("?<Escape>");
    game.input(&lost(903));
    assert!(head(&mut game).contains("not kept: 2"), "{}", game.screen());
    assert!(
        !game.screen().contains("it is locked"),
        "not in the way each time"
    );
    // After it went well again, another loss is news.
    game.input(&kept(904, Ok(())));
    game.input(&lost(905));
    assert!(game.screen().contains("it is locked"));
    assert!(head(&mut game).contains("not kept: 3"));
}

//! How a level looks.

use ratatui::buffer::Buffer;

use super::{LevelPhase, LevelPlay, PendingShot, board, panel};
use crate::quiz::Ray;
use crate::screens::Context;
use crate::screens::levels::words::face_of;
use crate::widgets::hit::{Markings, setup_picture};
use crate::widgets::{Room, SplitLayout};

/// What is given of the impact that the player speaks of: not the impact angle where it
/// is asked for, for along the line of impact the other disc leaves.
fn shown(pending: &PendingShot) -> Markings {
    Markings {
        offset: true,
        angle: !pending.rays.asks(Ray::Target),
        figures: true,
    }
}

/// Where the parts are: a square board, or a hit that takes all the room there is.
pub(super) fn layout(play: &LevelPlay, room: Room) -> SplitLayout {
    if play.is_enlarged() || play.level().is_of_the_first_hit() {
        SplitLayout::new(room)
    } else {
        SplitLayout::square(room)
    }
}

/// Draws the level.
pub(super) fn draw(play: &LevelPlay, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(play, cx.room());
    let level = play.level();
    let (title, side_title) = titles(play);
    layout.draw(buf, &look, &title, &side_title);
    let picture = match &play.phase {
        LevelPhase::Aim => {
            let scene = level.aimed(&play.dials.aim);
            board::of_aim(level, &scene, play.dials.met, layout.picture)
        }
        LevelPhase::Predict(pending) => {
            let faces = pending.impact.discs.map(|disc| face_of(&level.scene, disc));
            let (collision, rays) = (&pending.impact.collision, Some(&pending.rays));
            setup_picture(layout.picture, faces, collision, shown(pending), rays)
        }
        LevelPhase::Watch(made) => match made.player.zoom() {
            Some(watch) => watch.picture(layout.picture),
            None => board::of_made(level, made, layout.picture),
        },
    };
    picture.draw(buf, &look);
    play.scroll.draw(layout.panel, buf, look, |lines| {
        panel::write(play, lines, cx);
    });
}

/// The titles of picture and panel.
fn titles(play: &LevelPlay) -> (String, String) {
    match &play.phase {
        LevelPhase::Aim => ("aim".into(), play.level().title.clone()),
        LevelPhase::Predict(_) => ("where will they go?".into(), "say it first".into()),
        LevelPhase::Watch(made) => match made.player.zoom() {
            Some(watch) => (watch.slowed_title(), panel::impact_title(made)),
            None => (
                format!("shot {}", play.shots),
                match (made.told, &made.win) {
                    (false, _) => play.level().title.clone(),
                    (true, Some(_)) => "won".into(),
                    (true, None) => "not yet".into(),
                },
            ),
        },
    }
}

//! What a level shows.

use super::{LevelAction, LevelPhase, LevelPlay, board, panel};
use crate::quiz::Ray;
use crate::screens::levels::words::face_of;
use crate::screens::{Context, View};
use crate::widgets::hit::{Markings, setup_picture};
use crate::widgets::{Room, SplitLayout};

/// The board, or an impact enlarged, and the panel beside it.
pub(super) fn view<'s>(play: &'s LevelPlay, cx: &Context) -> View<'s, LevelAction> {
    let level = play.level();
    let panel = panel::panel(play, cx);
    let view = match &play.phase {
        LevelPhase::Aim => {
            let scene = level.aimed(&play.dials.aim);
            let board = move |area| board::of_aim(level, &scene, play.dials.met, area);
            View::picture(
                "aim",
                move |area, buf, look| board(area).draw(buf, look),
                panel,
            )
        }
        LevelPhase::Predict(pending) => {
            let faces = pending.impact.discs.map(|disc| face_of(&level.scene, disc));
            let (collision, rays) = (&pending.impact.collision, &pending.rays);
            // Along the line of impact the other disc leaves: its angle is not given where
            // that is asked for.
            let given = Markings {
                offset: true,
                angle: !rays.asks(Ray::Target),
                figures: true,
            };
            let draw = move |area, buf: &mut _, look: &_| {
                setup_picture(area, faces, collision, given, Some(rays)).draw(buf, look);
            };
            View::picture("where will they go?", draw, panel)
        }
        LevelPhase::Watch(made) => match made.player.zoom() {
            Some(watch) => {
                let draw = |area, buf: &mut _, look: &_| watch.picture(area).draw(buf, look);
                View::picture(watch.slowed_title(), draw, panel)
            }
            None => {
                let draw = move |area, buf: &mut _, look: &_| {
                    board::of_made(level, made, area).draw(buf, look);
                };
                View::picture(format!("shot {}", play.shots), draw, panel)
            }
        },
    };
    // A hit takes all the room there is; a board is square.
    let layout: fn(Room) -> SplitLayout = match play.is_enlarged() || level.is_of_the_first_hit() {
        true => SplitLayout::new,
        false => SplitLayout::square,
    };
    View { layout, ..view }
}

//! How a level looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Phase, Play, Saying, board, panel};
use crate::quiz::Ray;
use crate::screens::Context;
use crate::screens::levels::words::face_of;
use crate::widgets::SplitLayout;
use crate::widgets::hit::{Markings, setup_picture};

/// What is given of the impact that the player speaks of: not the impact angle where it
/// is asked for, for along the line of impact the other disc leaves.
fn shown(saying: &Saying) -> Markings {
    Markings {
        offset: true,
        angle: !saying.rays.asks(Ray::Target),
        figures: true,
    }
}

/// Where the parts are: a square board, or a hit that takes all the room there is.
pub(super) fn layout(play: &Play, area: Rect) -> SplitLayout {
    if play.is_enlarged() || play.level.is_of_the_first_hit() {
        SplitLayout::new(area)
    } else {
        SplitLayout::square(area)
    }
}

/// Draws the level.
pub(super) fn draw(play: &Play, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(play, area);
    let level = &play.level;
    let (title, side_title) = titles(play);
    layout.draw(buf, &look, &title, &side_title);
    let picture = match &play.phase {
        Phase::Aim => {
            let scene = level.aimed(&play.dials.aim);
            board::of_aim(level, &scene, layout.picture)
        }
        Phase::Say(saying) => {
            let faces = saying.impact.discs.map(|disc| face_of(&level.scene, disc));
            let (collision, rays) = (&saying.impact.collision, Some(&saying.rays));
            setup_picture(layout.picture, faces, collision, shown(saying), rays)
        }
        Phase::Watch(attempt) => match &attempt.zoom {
            Some(zoom) => zoom.watch.picture(layout.picture),
            None => board::of_attempt(level, attempt, layout.picture),
        },
    };
    picture.draw(buf, &look);
    play.scroll.draw(layout.panel, buf, look, |lines| {
        panel::write(play, lines, cx);
    });
}

/// The titles of picture and panel.
fn titles(play: &Play) -> (String, String) {
    match &play.phase {
        Phase::Aim => ("aim".into(), play.level.title.clone()),
        Phase::Say(_) => ("where will they go?".into(), "say it first".into()),
        Phase::Watch(attempt) => match &attempt.zoom {
            Some(zoom) => (
                format!("the hit, slowed {:.0}×", zoom.watch.clock().slowed()),
                format!("impact {} of {}", zoom.number + 1, attempt.impacts.len()),
            ),
            None => (
                format!("shot {}", play.shots),
                match (attempt.told, &attempt.win) {
                    (false, _) => play.level.title.clone(),
                    (true, Some(_)) => "won".into(),
                    (true, None) => "not yet".into(),
                },
            ),
        },
    }
}

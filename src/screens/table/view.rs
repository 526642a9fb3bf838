//! How a game at the table looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::sitting::{Phase, Sitting};
use super::{panel, picture};
use crate::game::Rules;
use crate::screens::Context;
use crate::widgets::Beside;
use crate::widgets::hit::{Face, Markings, setup_picture};

/// Where picture and panel are: for a whole board, which is square, or for one
/// `enlarged` impact, which takes all there is.
pub(super) fn layout(area: Rect, enlarged: bool) -> Beside {
    if enlarged {
        Beside::new(area)
    } else {
        Beside::square(area)
    }
}

/// Whether what is being done is shown enlarged.
pub(super) fn is_enlarged(sitting: &Sitting) -> bool {
    matches!(sitting.phase, Phase::Call(_) | Phase::Impact(_))
}

/// Draws the game.
pub(super) fn draw(sitting: &Sitting, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(area, is_enlarged(sitting));
    let (title, side_title) = titles(sitting);
    layout.draw(buf, &look, &title, &side_title);
    let area = layout.picture;
    let picture = match &sitting.phase {
        Phase::Call(calling) => {
            let given = Markings {
                offset: true,
                angle: true,
                figures: true,
            };
            let collision = &calling.hit.impact.collision;
            let rays = Some(&calling.rays);
            setup_picture(area, Face::STRIKER_AND_COIN, collision, given, rays)
        }
        Phase::Impact(zoom) => zoom.watch.picture(area),
        Phase::Aim => picture::of_aim(sitting, area),
        Phase::Watch(replay) => picture::of_replay(sitting, replay, area),
        Phase::Arrange(arrange) => picture::of_arrange(sitting, arrange, area),
        Phase::Think { .. } | Phase::Over => picture::of_coins(sitting, area),
    };
    picture.draw(buf, &look);
    panel::draw(sitting, layout.panel, buf, cx);
}

/// The titles of picture and panel.
fn titles(sitting: &Sitting) -> (String, String) {
    let turn = || match sitting.options.seat_name(sitting.seat()) {
        "you" => "your stroke".to_owned(),
        name => format!("{name}'s stroke"),
    };
    match &sitting.phase {
        Phase::Call(_) => ("call it: where to?".into(), "say it first".into()),
        Phase::Impact(zoom) => (
            format!("the impact, slowed {:.0}×", zoom.watch.clock().slowed()),
            "why".into(),
        ),
        Phase::Arrange(_) => (board_title(sitting), "lay the coins out".into()),
        Phase::Watch(replay) => {
            let time = format!(
                "{:.2} s, {}",
                replay.clock.time(),
                replay.clock.rate().words()
            );
            let name = if replay.chosen.is_some() {
                "impacts".into()
            } else {
                let session = &sitting.session;
                let stroke = session.strokes_before(replay.number + 1);
                format!("stroke {stroke} of {}", session.record().strokes())
            };
            (time, name)
        }
        Phase::Aim | Phase::Think { .. } => (board_title(sitting), turn()),
        Phase::Over => (board_title(sitting), "the end of the board".into()),
    }
}

/// Which board it is, and the score.
fn board_title(sitting: &Sitting) -> String {
    use crate::game::Team::{First, Second};
    let game = sitting.game();
    let score = game.score();
    let number = game.board_number();
    match game.setup().rules {
        Rules::Practice => "practice".into(),
        Rules::Friendly => format!(
            "boards won {} : {}",
            score.games[First], score.games[Second]
        ),
        Rules::Tournament => format!(
            "board {number}   {} {} : {} {}",
            sitting.options.team_name(First),
            score.points[First],
            score.points[Second],
            sitting.options.team_name(Second),
        ),
    }
}

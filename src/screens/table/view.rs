//! How a game at the table looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::sitting::{Phase, Sitting};
use super::{panel, picture};
use crate::game::Rules;
use crate::screens::Context;
use crate::widgets::hit::{Given, draw_setup};
use crate::widgets::panel::draw_panel;
use crate::widgets::{Look, board};

/// Fewest columns of the panel, with its frame.
const PANEL: u16 = 27;
/// Columns of the panel beside an enlarged impact.
const PANEL_BESIDE_IMPACT: u16 = 30;

/// Where the parts are: the inside of the picture's frame and of the panel's.
pub(super) struct Layout {
    pub(super) picture: Rect,
    pub(super) panel: Rect,
    frames: [Rect; 2],
}

/// Lays the screen out: for a whole board, which is square, or for one `enlarged`
/// impact, which takes all there is.
pub(super) fn layout(area: Rect, enlarged: bool) -> Layout {
    let panel = if enlarged {
        let roomy = if area.width >= 110 { 8 } else { 0 };
        PANEL_BESIDE_IMPACT + roomy
    } else {
        let inside = Rect::new(
            0,
            0,
            area.width.saturating_sub(PANEL + 2),
            area.height.saturating_sub(2),
        );
        area.width.saturating_sub(board::square(inside).width + 2)
    };
    let panel = panel.min(area.width / 2 + 8).min(area.width);
    let picture = Rect {
        width: area.width - panel,
        ..area
    };
    let panel = Rect {
        x: picture.right(),
        width: panel,
        ..area
    };
    let inside = |frame: Rect| Rect {
        x: (frame.x + 1).min(frame.right()),
        y: (frame.y + 1).min(frame.bottom()),
        width: frame.width.saturating_sub(2),
        height: frame.height.saturating_sub(2),
    };
    Layout {
        picture: inside(picture),
        panel: inside(panel),
        frames: [picture, panel],
    }
}

/// Draws both frames with their titles.
pub(super) fn frames(layout: &Layout, titles: [&str; 2], buf: &mut Buffer, look: &Look) {
    for (frame, title) in layout.frames.into_iter().zip(titles) {
        draw_panel(buf, frame, title, look.charset, &look.theme);
    }
}

/// Draws the game.
pub(super) fn draw(sitting: &Sitting, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let enlarged = matches!(sitting.phase, Phase::Call(_) | Phase::Impact(_));
    let layout = layout(area, enlarged);
    let (title, side_title) = titles(sitting);
    frames(&layout, [&title, &side_title], buf, &look);
    match &sitting.phase {
        Phase::Call(calling) => {
            let given = Given {
                offset: true,
                angle: true,
            };
            let collision = &calling.hit.impact.collision;
            draw_setup(
                layout.picture,
                buf,
                &look,
                collision,
                given,
                Some(&calling.rays),
            );
        }
        Phase::Impact(zoom) => zoom.watch.draw(layout.picture, buf, &look),
        Phase::Aim => picture::draw_aim(sitting, layout.picture, buf, &look),
        Phase::Watch(replay) => picture::draw_replay(sitting, replay, layout.picture, buf, &look),
        Phase::Arrange(arrange) => {
            picture::draw_arrange(sitting, arrange, layout.picture, buf, &look);
        }
        Phase::Think { .. } | Phase::Over => {
            picture::draw_coins(sitting, layout.picture, buf, &look)
        }
    }
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
                replay.clock.rate_words()
            );
            let name = if replay.chosen.is_some() {
                "impacts"
            } else {
                "the stroke"
            };
            (time, name.into())
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

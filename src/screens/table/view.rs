//! How a game at the table looks.

use ratatui::buffer::Buffer;

use super::active_game::{ActiveGame, TablePhase};
use super::{panel, picture, trays};
use crate::game::{Rules, Team};
use crate::screens::Context;
use crate::widgets::hit::{Face, Markings, setup_picture};
use crate::widgets::{Room, SplitLayout, board};

/// Where picture and panel are: for a whole board, which is square, or for one enlarged
/// impact, which takes all there is.
pub(super) fn layout(active: &ActiveGame, room: Room) -> SplitLayout {
    match &active.phase {
        TablePhase::Call(_) => SplitLayout::new(room),
        TablePhase::Watch(replay) if replay.player.zoom().is_some() => SplitLayout::new(room),
        _ => SplitLayout::square(room),
    }
}

/// Draws the game.
pub(super) fn draw(active: &ActiveGame, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(active, cx.room());
    let (title, side_title) = titles(active);
    layout.draw(buf, &look, &title, &side_title);
    let area = layout.picture;
    let picture = match &active.phase {
        TablePhase::Call(calling) => {
            let collision = &calling.hit.impact.collision;
            let rays = Some(&calling.rays);
            // Not the impact angle: along the line of impact the coin leaves.
            let shown = Markings {
                angle: false,
                ..Markings::ALL
            };
            setup_picture(area, Face::STRIKER_AND_COIN, collision, shown, rays)
        }
        TablePhase::Show(shown) => picture::of_show(active, shown, area),
        TablePhase::Aim => picture::of_aim(active, area),
        TablePhase::Watch(replay) => match replay.player.zoom() {
            Some(watch) => watch.picture(area),
            None => picture::of_replay(active, replay, area),
        },
        TablePhase::Arrange(arrange) => picture::of_arrange(active, arrange, area),
        TablePhase::Over => picture::of_pack(active.game().coins(), active.set(), area),
    };
    picture.draw(buf, &look);
    trays::draw(active, board::square(layout.picture), buf, &look);
    panel::draw(active, layout.panel, buf, cx);
}

/// The titles of picture and panel.
fn titles(active: &ActiveGame) -> (String, String) {
    let turn = || match active.options.seat_name(active.seat()) {
        "you" => "your stroke".to_owned(),
        name => format!("{name}'s stroke"),
    };
    match &active.phase {
        TablePhase::Call(_) => ("call it: where to?".into(), "say it first".into()),
        TablePhase::Arrange(_) => (board_title(active), "lay the coins out".into()),
        TablePhase::Watch(replay) => {
            let (clock, player) = (replay.player.clock(), &replay.player);
            if let Some(watch) = player.zoom() {
                return (watch.slowed_title(), "why".into());
            }
            let time = format!("{:.2} s, {}", clock.time(), clock.rate().words());
            let name = if player.list().is_some() {
                "impacts".into()
            } else {
                let history = &active.history;
                let stroke = history.strokes_before(replay.number + 1);
                format!("stroke {stroke} of {}", history.record().strokes())
            };
            (time, name)
        }
        TablePhase::Aim | TablePhase::Show(_) => (board_title(active), turn()),
        TablePhase::Over => (board_title(active), "the end of the board".into()),
    }
}

/// Which board it is, and the score.
fn board_title(active: &ActiveGame) -> String {
    let game = active.game();
    let score = game.score();
    match game.setup().rules {
        Rules::Practice => "practice".into(),
        Rules::Friendly => {
            let [first, second] = Team::BOTH.map(|team| score.games[team]);
            format!("boards won {first} : {second}")
        }
        Rules::Tournament => {
            let score = active.options.score(game);
            format!("board {}   {score}", game.board_number())
        }
    }
}

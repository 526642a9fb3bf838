//! The trays on the lower frame of the board, which show the pieces that each team has pocketed,
//! their number, and the pieces that are moving to the trays.

use std::iter;

use glam::{DVec2, dvec2};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::ActiveGame;
use super::watching::{FALL, StrokeReplay};
use crate::game::{ByTeam, Game, Piece, Rules, Team};
use crate::screens::table::words;
use crate::widgets::flow::Run;
use crate::widgets::ink::token;
use crate::widgets::{Item, Look, Role, Words, sheet, text};

/// Draws both trays on the frame around `board`, and during a replay the pieces on their way to
/// the trays.
pub(super) fn draw(
    active: &ActiveGame,
    replay: Option<&StrokeReplay>,
    board: Rect,
    buf: &mut Buffer,
    look: &Look,
) {
    if active.is_practice() || board.width < 20 || board.height < 8 {
        return;
    }
    let running = replay.filter(|replay| !replay.player.clock().is_over());
    let game = match (running, replay) {
        (Some(running), _) => active.history.past(running.number).map(|past| &past.before),
        (None, Some(over)) => Some(active.history.after(over.number)),
        (None, None) => None,
    };
    let game = game.unwrap_or(active.game());
    let mut trays = pocketed(game);
    let mut on_the_way = Vec::new();
    let now = replay.map_or(0.0, |replay| replay.player.clock().time());
    for fall in running.iter().flat_map(|replay| &replay.falls) {
        let share = (now - fall.time) / FALL;
        match owner(game, fall.piece) {
            Some(team) if share >= 1.0 => trays[team].push(fall.piece),
            Some(team) if share >= 0.0 => on_the_way.push((team, fall, share)),
            _ => {}
        }
    }
    let slots = Team::BOTH.map(|team| draw_tray(active, team, &trays[team], board, buf, look));
    for (team, fall, share) in on_the_way {
        let at = on_the_frame(board, fall.corner, slots[team as usize], share);
        let (sign, role) = sign(fall.piece, look);
        put(at, sign, role, buf, look);
    }
}

fn sign(piece: Piece, look: &Look) -> (&'static str, Role) {
    let role = words::role(piece);
    (token(role, look.charset), role)
}

/// The team into whose tray a piece goes; `None` for the striker.
fn owner(game: &Game, piece: Piece) -> Option<Team> {
    match piece {
        Piece::Striker => None,
        Piece::White | Piece::Black if game.setup().rules != Rules::Points => {
            { Team::BOTH.into_iter() }.find(|team| game.colour(*team).piece() == piece)
        }
        _ => Some(game.team(game.seat())),
    }
}

/// The pieces in the trays, which a practice game does not have. A queen that has not been covered
/// yet is in the tray of the team that has to cover her.
fn pocketed(game: &Game) -> ByTeam<Vec<Piece>> {
    let mut trays = ByTeam::<Vec<Piece>>::default();
    if let Some(code) = game.setup().board_code() {
        let fallen = code.coins().len().saturating_sub(game.coins().len());
        trays[Team::First] = vec![Piece::White; fallen];
        return trays;
    }
    for team in Team::BOTH {
        let colour = game.colour(team);
        trays[team] = match game.setup().rules {
            Rules::Points => game.play().taken(team),
            _ => vec![colour.piece(); usize::from(game.play().in_pockets(colour))],
        };
    }
    let with = match game.play().queen_covered_by {
        None if game.play().queen_to_cover() => Some(game.team(game.seat())),
        covered => covered,
    };
    if let Some(team) = with {
        trays[team].push(Piece::Queen);
    }
    trays
}

/// Draws a tray on the lower frame, the first team's on the left; returns the column of the next
/// piece.
fn draw_tray(
    active: &ActiveGame,
    team: Team,
    tray: &[Piece],
    board: Rect,
    buf: &mut Buffer,
    look: &Look,
) -> u16 {
    let half = board.width / 2;
    if tray.is_empty() {
        return board.x + 1 + half * team as u16;
    }
    let name = active.options.team_name(team);
    let count = format!(" {} ", tray.len());
    sheet::note(board, || {
        let signs = tray.iter().map(|piece| sign(*piece, look));
        let runs = iter::once(Run::new(format!("{name} "), Role::Dim));
        let runs = runs.chain(signs.map(|(sign, role)| Run::new(sign, role)));
        let runs = runs.chain([Run::new(count.as_str(), Role::Text)]);
        Item::new(Words::Text {
            mark: String::new(),
            runs: runs.collect(),
        })
    });
    let name = look.charset.text(name);
    // In a small window, one sign for each kind of piece leaves room for the name.
    let mut tray = tray.to_vec();
    if text::width(&name) + 2 + tray.len() + count.len() > usize::from(half) {
        tray.dedup();
    }
    let signs = || tray.iter().map(|piece| sign(*piece, look));
    let needed = (tray.len() + count.len()) as u16;
    let name = match text::width(&name) as u16 + 2 + needed <= half {
        true => format!(" {name} "),
        false => " ".to_owned(),
    };
    let width = text::width(&name) as u16 + needed;
    let mut column = match team {
        Team::First => board.x,
        Team::Second => board.right().saturating_sub(width),
    };
    for (words, role) in iter::once((name.as_str(), Role::Dim)).chain(signs()) {
        put((column, board.bottom()), words, role, buf, look);
        column += text::width(words) as u16;
    }
    put((column, board.bottom()), &count, Role::Text, buf, look);
    column
}

fn put((column, row): (u16, u16), words: &str, role: Role, buf: &mut Buffer, look: &Look) {
    if buf.area.contains((column, row).into()) {
        let room = usize::from(buf.area.right() - column);
        let style = look.theme.style(role);
        buf.set_stringn(column, row, look.charset.text(words), room, style);
    }
}

/// The cell of a piece on the frame, after a fraction of its path from its pocket to a column of
/// the lower frame.
fn on_the_frame(board: Rect, corner: usize, column: u16, share: f64) -> (u16, u16) {
    let left = f64::from(board.x) - 1.0;
    let right = f64::from(board.right());
    let (top, bottom) = (f64::from(board.y) - 1.0, f64::from(board.bottom()));
    let from = dvec2(
        if corner & 1 == 0 { left } else { right },
        if corner & 2 == 0 { bottom } else { top },
    );
    let turn = dvec2(from.x, bottom);
    let to = dvec2(f64::from(column), bottom);
    // A row is as high as two columns are wide.
    let (down, along) = (2.0 * from.distance(turn), turn.distance(to));
    let gone = share * (down + along);
    let at: DVec2 = if gone < down {
        from.lerp(turn, gone / down)
    } else {
        turn.lerp(to, ((gone - down) / along.max(1.0)).min(1.0))
    };
    (at.x.round() as u16, at.y.round() as u16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::Seat;
    use crate::screens::Settings;
    use crate::screens::table::Options;
    use crate::widgets::Charset;

    #[test]
    fn the_second_tray_ends_at_the_edge_of_the_board_whatever_the_letters_of_the_name() {
        let board = Rect::new(1, 2, 39, 20);
        for name in ["Ada", "Zoë", "Ольга", "李明"] {
            let mut options = Options::two_people();
            options.company.names.set(Seat::North, name);
            let active = ActiveGame::new(options, 1);
            for charset in [Charset::Ascii, Charset::Unicode] {
                let settings = Settings {
                    charset,
                    ..Settings::default()
                };
                let mut buf = Buffer::empty(Rect::new(0, 0, 80, 24));
                let (look, tray) = (settings.look(), [Piece::Black; 2]);
                let next = draw_tray(&active, Team::Second, &tray, board, &mut buf, &look);
                assert_eq!(next + " 2 ".len() as u16, board.right(), "{name}");
            }
        }
    }
}

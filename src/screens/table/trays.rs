//! The trays on the lower frame of the board: what each team has pocketed, counted, and
//! what has just fallen on its way there.

use std::iter;

use glam::{DVec2, dvec2};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::active_game::{ActiveGame, TablePhase};
use super::replay::{FALL, FallingPiece, StrokeReplay};
use super::words;
use crate::game::{ByTeam, Game, Piece, Rules, Team};
use crate::widgets::flow::Run;
use crate::widgets::ink::token;
use crate::widgets::{Item, Look, Role, Words, sheet, text};

/// What lies in a tray.
#[derive(Debug, Clone, Default)]
struct Tray {
    pieces: Vec<Piece>,
}

/// Draws both trays on the frame round `board`, and what is on its way into them.
pub(super) fn draw(active: &ActiveGame, board: Rect, buf: &mut Buffer, look: &Look) {
    if active.is_practice() || board.width < 20 || board.height < 8 {
        return;
    }
    let (game, on_the_way) = match &active.phase {
        TablePhase::Watch(replay) if replay.player.zoom().is_some() => return,
        TablePhase::Watch(replay) => seen(active, replay),
        TablePhase::Call(_) => return,
        _ => (active.game(), Vec::new()),
    };
    let mut trays = trays(game);
    let fallen = match &active.phase {
        TablePhase::Watch(replay) => fallen(replay),
        _ => Vec::new(),
    };
    for piece in fallen {
        if let Some(team) = owner(game, piece) {
            trays[team].pieces.push(piece);
        }
    }
    let mut slots = [(0, 0); 2];
    for team in Team::BOTH {
        slots[team as usize] = draw_tray(active, &trays[team], team, board, buf, look);
    }
    for (fall, share) in on_the_way {
        if let Some(team) = owner(game, fall.piece) {
            let at = on_the_frame(board, fall.corner, slots[team as usize].0, share);
            put(
                at,
                token(words::role(fall.piece), look.charset),
                words::role(fall.piece),
                buf,
                look,
            );
        }
    }
}

/// The game whose trays are seen while a stroke is watched, and what is on its way.
fn seen<'a>(active: &'a ActiveGame, replay: &StrokeReplay) -> (&'a Game, Vec<(FallingPiece, f64)>) {
    let clock = replay.player.clock();
    if clock.is_over() {
        return (active.history.after(replay.number), Vec::new());
    }
    let past = active.history.past(replay.number);
    let game = past.map_or(active.game(), |past| &past.before);
    let share = |fall: &FallingPiece| (clock.time() - fall.time) / FALL;
    let falls = replay.falls.iter().map(|fall| (*fall, share(fall)));
    (
        game,
        falls
            .filter(|(_, share)| (0.0..1.0).contains(share))
            .collect(),
    )
}

/// What has come into the trays since the stroke began, while it is watched.
fn fallen(replay: &StrokeReplay) -> Vec<Piece> {
    let clock = replay.player.clock();
    let there = |fall: &&FallingPiece| !clock.is_over() && clock.time() >= fall.time + FALL;
    replay
        .falls
        .iter()
        .filter(there)
        .map(|fall| fall.piece)
        .collect()
}

/// Whose tray a piece goes into; the striker goes into none.
fn owner(game: &Game, piece: Piece) -> Option<Team> {
    match piece {
        Piece::Striker => None,
        Piece::Queen => Some(game.team(game.seat())),
        coin => Team::BOTH
            .into_iter()
            .find(|team| game.colour(*team).piece() == coin),
    }
}

/// What lies in the trays of a game. A queen that is yet to be covered lies with those who
/// have to cover her.
fn trays(game: &Game) -> ByTeam<Tray> {
    let mut trays = ByTeam::<Tray>::default();
    for team in Team::BOTH {
        let colour = game.colour(team);
        let coins = usize::from(game.play().in_pockets(colour));
        trays[team].pieces = vec![colour.piece(); coins];
    }
    let with = match game.play().queen_covered_by {
        None if game.play().queen_to_cover() => Some(game.team(game.seat())),
        covered => covered,
    };
    if let Some(team) = with.filter(|_| game.setup().rules != Rules::Practice) {
        trays[team].pieces.push(Piece::Queen);
    }
    trays
}

/// Draws a tray on the lower frame, the first team's on the left; gives where the next piece
/// goes, and the column after it.
fn draw_tray(
    active: &ActiveGame,
    tray: &Tray,
    team: Team,
    board: Rect,
    buf: &mut Buffer,
    look: &Look,
) -> (u16, u16) {
    let half = board.width / 2;
    let name = active.options.team_name(team);
    let pieces = tray.pieces.len() as u16;
    let count = format!(" {pieces} ");
    let needed = pieces + count.len() as u16;
    let name = match text::width(name) as u16 + 2 + needed <= half {
        true => format!(" {name} "),
        false => " ".to_owned(),
    };
    if pieces == 0 {
        // Where its first piece will go.
        let first = if team == Team::First {
            board.x + 1
        } else {
            board.x + half + 1
        };
        return (first, first);
    }
    sheet::note(board, || {
        let piece = |piece: &Piece| {
            let role = words::role(*piece);
            Run::new(token(role, look.charset), role)
        };
        let name = Run::new(format!("{} ", active.options.team_name(team)), Role::Dim);
        let runs = { iter::once(name) }.chain(tray.pieces.iter().map(piece));
        let runs = runs.chain([Run::new(count.as_str(), Role::Text)]);
        Item::new(Words::Text {
            mark: String::new(),
            runs: runs.collect(),
        })
    });
    let row = board.bottom();
    let mut column = match team {
        Team::First => board.x,
        Team::Second => board.right().saturating_sub(needed + name.len() as u16),
    };
    let mut write = |words: &str, role: Role| {
        put((column, row), words, role, buf, look);
        column += text::width(words) as u16;
    };
    write(&name, Role::Dim);
    for piece in &tray.pieces {
        write(
            token(words::role(*piece), look.charset),
            words::role(*piece),
        );
    }
    let next = column;
    let mut write = |words: &str, role: Role| put((next, row), words, role, buf, look);
    write(&count, Role::Text);
    (next, next + 1)
}

fn put((column, row): (u16, u16), words: &str, role: Role, buf: &mut Buffer, look: &Look) {
    if buf.area.contains((column, row).into()) {
        let words = look.charset.text(words);
        buf.set_stringn(
            column,
            row,
            words,
            usize::from(buf.area.right() - column),
            look.theme.style(role),
        );
    }
}

/// Where on the frame a piece is that has gone a share of its way from the corner where it
/// fell to a column of the lower frame.
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
    // A row is as long as two columns.
    let (down, along) = (2.0 * from.distance(turn), turn.distance(to));
    let gone = share * (down + along);
    let at: DVec2 = if gone < down {
        from.lerp(turn, gone / down)
    } else {
        turn.lerp(to, ((gone - down) / along.max(1.0)).min(1.0))
    };
    (at.x.round() as u16, at.y.round() as u16)
}

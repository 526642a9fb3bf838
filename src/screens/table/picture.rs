//! Pictures of the board with its coins.

use glam::DVec2;
use ratatui::layout::Rect;

use super::words;
use crate::game::{Coin, Piece, PieceSet};
use crate::messages::Mouse;
use crate::physics::Board;
use crate::widgets::picture::{Body, Pen, Picture, View};
use crate::widgets::{Role, board};

/// The view of the board in an area.
fn view(area: Rect) -> View {
    board::view(board::square(area), &Board::default())
}

/// The position of the mouse on the board, in metres, and whether it is inside the picture.
pub(super) fn pointed(mouse: &Mouse, area: Rect) -> (DVec2, bool) {
    let at = view(area).to_world(mouse.place());
    (at, board::square(area).contains(mouse.cell().into()))
}

pub(super) fn ground(area: Rect) -> Picture {
    let mut picture = Picture::new(view(area));
    board::ground(&mut picture, &Board::default());
    picture
}

pub(super) fn body(set: PieceSet, piece: Piece, at: DVec2) -> Body {
    let face = words::face(piece);
    Body::new(at, set.disc(piece).radius, face.role, face.letter)
}

pub(super) fn bodies(set: PieceSet, coins: &[Coin]) -> impl Iterator<Item = Body> {
    coins.iter().map(move |coin| body(set, coin.piece, coin.at))
}

/// Coins on an otherwise empty board.
pub(super) fn of_pack(coins: &[Coin], set: PieceSet, area: Rect) -> Picture {
    let mut picture = ground(area);
    picture.discs(bodies(set, coins));
    picture
}

/// Draws a cross at the position of the hand.
pub(super) fn hand(picture: &mut Picture, at: DVec2) {
    let arm = 2.5 * picture.view().per_row();
    let gap = 0.8 * picture.view().per_row();
    for way in [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y] {
        picture.line(at + gap * way, at + arm * way, Pen::new(Role::Key));
    }
}

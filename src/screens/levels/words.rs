//! Words and marks that the list and a level share.

use crate::levels::{Kind, MOST_STARS, Scene};
use crate::widgets::Role;
use crate::widgets::hit::Face;

/// Stars as a row of marks, full ones first.
pub(super) fn stars(count: u8) -> String {
    let count = count.min(MOST_STARS);
    let full = "★".repeat(count.into());
    full + &"☆".repeat((MOST_STARS - count).into())
}

/// How a kind of disc is drawn.
pub(super) fn face(kind: Kind) -> Face {
    let (role, letter) = match kind {
        Kind::Striker => (Role::Striker, 'S'),
        Kind::White => (Role::Coin, 'C'),
        Kind::Black => (Role::Black, 'B'),
        Kind::Queen => (Role::Queen, 'Q'),
        Kind::Marble => (Role::Marble, 'M'),
    };
    Face { role, letter }
}

/// How a disc of a scene is drawn.
pub(super) fn face_of(scene: &Scene, disc: usize) -> Face {
    let kind = scene.pieces.get(disc).map(|piece| piece.kind);
    face(kind.unwrap_or(Kind::White))
}

/// A disc of a scene in one word.
pub(super) fn short(scene: &Scene, disc: usize) -> &'static str {
    match scene.pieces.get(disc).map(|piece| piece.kind) {
        Some(Kind::Striker) => "striker",
        Some(Kind::White | Kind::Black) => "coin",
        Some(Kind::Queen) => "queen",
        Some(Kind::Marble) => "marble",
        None => "disc",
    }
}

/// The same text with a capital to begin with.
pub(super) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    match letters.next() {
        Some(first) => first.to_uppercase().chain(letters).collect(),
        None => String::new(),
    }
}

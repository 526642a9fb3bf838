//! Strings and marks that the list and a level share.

use crate::levels::{Dial, DiscKind, MOST_STARS, Scene};
use crate::widgets::Role;
use crate::widgets::hit::Face;
use crate::widgets::replay::ShotImpact;

/// Stars as a row of marks, full ones first.
pub(super) fn stars(count: u8) -> String {
    let count = count.min(MOST_STARS);
    let full = "★".repeat(count.into());
    full + &"☆".repeat((MOST_STARS - count).into())
}

/// How a kind of disc is drawn.
pub(super) fn face(kind: DiscKind) -> Face {
    let (role, letter) = match kind {
        DiscKind::Striker => (Role::Striker, 'S'),
        DiscKind::White => (Role::Coin, 'C'),
        DiscKind::Black => (Role::Black, 'B'),
        DiscKind::Queen => (Role::Queen, 'Q'),
        DiscKind::Marble => (Role::Marble, 'M'),
    };
    Face { role, letter }
}

/// How the two discs of an impact are drawn.
pub(super) fn faces(scene: &Scene, impact: &ShotImpact) -> [Face; 2] {
    impact.discs.map(|disc| face_of(scene, disc))
}

/// How a disc of a scene is drawn.
pub(super) fn face_of(scene: &Scene, disc: usize) -> Face {
    let kind = scene.pieces.get(disc).map(|piece| piece.kind);
    face(kind.unwrap_or(DiscKind::White))
}

/// The name of a disc of a scene, in one word.
pub(super) fn short(scene: &Scene, disc: usize) -> &'static str {
    let piece = scene.pieces.get(disc);
    let name = piece.map_or("disc", |piece| piece.kind.name());
    name.trim_start_matches("white ")
        .trim_start_matches("black ")
}

/// The name of a dial on the screen, its unit, and its description, which is followed by the range.
pub(super) const fn dial_words(dial: Dial) -> (&'static str, &'static str, &'static str) {
    match dial {
        Dial::Direction => (
            "direction",
            "°",
            "the direction of the shot, anticlockwise from the right",
        ),
        Dial::Speed => ("speed", " m/s", "the disc's initial speed"),
        Dial::Place => ("place", " mm", "how far from the middle the disc starts"),
        Dial::Mass => ("mass", " g", "the mass of the disc"),
        Dial::Restitution => (
            "restitution",
            "",
            "e: speed of separation over speed of approach",
        ),
    }
}

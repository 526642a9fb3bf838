//! The names and appearance of pieces and players on the screen.

use std::fmt::Display;

use crate::game::{BoardCode, Game, Piece, PieceSet, Team};
use crate::widgets::Role;
use crate::widgets::hit::Face;

/// The appearance of a piece in a picture.
pub(super) const fn face(piece: Piece) -> Face {
    let (role, letter) = match piece {
        Piece::Striker => (Role::Striker, 'S'),
        Piece::White => (Role::Coin, 'W'),
        Piece::Black => (Role::Black, 'B'),
        Piece::Queen => (Role::Queen, 'Q'),
    };
    Face { role, letter }
}

/// The role in whose colour a piece is drawn.
pub(super) const fn role(piece: Piece) -> Role {
    face(piece).role
}

pub(super) const fn masses(set: PieceSet) -> &'static str {
    match set {
        PieceSet::Tournament => "15 g on 5.5 g",
        PieceSet::EqualMass => "15 g on 15 g",
    }
}

/// The name of a board for one player.
pub(super) fn solo_title(game: &Game) -> String {
    let code = game.setup().board_code();
    code.map_or_else(String::new, BoardCode::title)
}

/// A message that says where a game was exported, or why the export failed.
pub(super) fn exported(result: &Result<String, String>) -> String {
    match result {
        Ok(place) => format!("The game has been written to {place}"),
        Err(reason) => format!("The game cannot be exported: {reason}."),
    }
}

/// The name of a player within a sentence, as in "goes to the computer".
pub(super) fn player(name: &str) -> &str {
    match name {
        "computer" => "the computer",
        name => name,
    }
}

/// A name followed by its verb: "South plays" but "you play" and "S + N play".
pub(super) fn does(name: &str, third_person: &str) -> String {
    let verb = match name {
        "you" | "S + N" | "E + W" => third_person.strip_suffix('s').unwrap_or(third_person),
        _ => third_person,
    };
    format!("{name} {verb}")
}

/// Something that belongs to a player: "South's calls" but "your calls".
pub(super) fn whose(name: &str, what: &str) -> String {
    match name {
        "you" => format!("your {what}"),
        name => format!("{name}'s {what}"),
    }
}

/// The values of both teams, as in "3 : 1".
pub(super) fn versus<T: Display>(value: impl Fn(Team) -> T) -> String {
    let [first, second] = Team::BOTH.map(value);
    format!("{first} : {second}")
}

//! Pieces, seats and laws in the words and signs of the screen.

use crate::game::{Colour, Game, Piece, PieceSet, Rules, Ruling};
use crate::widgets::Role;
use crate::widgets::hit::Face;

/// The colour a piece is drawn in.
pub(super) const fn role(piece: Piece) -> Role {
    match piece {
        Piece::Striker => Role::Striker,
        Piece::White => Role::Coin,
        Piece::Black => Role::Black,
        Piece::Queen => Role::Queen,
    }
}

/// The letter on a large piece.
pub(super) const fn letter(piece: Piece) -> char {
    match piece {
        Piece::Striker => 'S',
        Piece::White => 'W',
        Piece::Black => 'B',
        Piece::Queen => 'Q',
    }
}

/// How a piece looks in a picture of one impact.
pub(super) fn face(piece: Option<Piece>) -> Face {
    let piece = piece.unwrap_or(Piece::White);
    Face {
        role: role(piece),
        letter: letter(piece),
    }
}

/// What a piece is called where there is little room.
pub(super) const fn short(piece: Piece) -> &'static str {
    match piece {
        Piece::Striker => "striker",
        Piece::White => "white",
        Piece::Black => "black",
        Piece::Queen => "queen",
    }
}

/// The coin of a colour.
pub(super) const fn coin(colour: Colour) -> Piece {
    match colour {
        Colour::White => Piece::White,
        Colour::Black => Piece::Black,
    }
}

/// The rules that are played.
pub(super) const fn rules(rules: Rules) -> &'static str {
    match rules {
        Rules::Tournament => "tournament",
        Rules::Friendly => "friendly",
        Rules::Practice => "practice",
    }
}

/// The masses of a set.
pub(super) const fn masses(set: PieceSet) -> &'static str {
    match set {
        PieceSet::Tournament => "15 g on 5.5 g",
        PieceSet::EqualMass => "15 g on 15 g",
    }
}

/// What somebody does, as in "South plays" but "you play".
pub(super) fn does(name: &str, third_person: &str) -> String {
    let verb = match name {
        "you" => third_person.strip_suffix('s').unwrap_or(third_person),
        _ => third_person,
    };
    format!("{name} {verb}")
}

/// The same at the beginning of a sentence.
pub(super) fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|letter| letter.to_ascii_uppercase());
    first.into_iter().chain(letters).collect()
}

/// A ruling with the number of its law.
pub(super) fn ruling(ruling: &Ruling) -> String {
    match ruling.law {
        Some(law) => format!("{} (law {law})", ruling.text),
        None => ruling.text.clone(),
    }
}

/// Where the queen is.
pub(super) fn queen(game: &Game, name_of: impl Fn(crate::game::Team) -> &'static str) -> String {
    let play = game.play();
    match play.queen_covered_by() {
        Some(team) => format!("with {}", name_of(team)),
        None if play.queen_on_board() => "on the board".into(),
        None => "to be covered".into(),
    }
}

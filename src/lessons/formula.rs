//! Formulas: how they are written in a chapter, and what they are made of.
//!
//! The grammar is a small one of our own; `docs/lessons.md` lists it. How a formula
//! looks over several rows is the business of `widgets::formula`.

mod inline;
mod letters;
mod parse;

use letters::letter;

/// A formula.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Formula(pub Vec<Term>);

/// A part of a formula, and whether a blank stands before it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Term {
    /// Whether a blank stands before it.
    pub apart: bool,
    /// What it is.
    pub node: Node,
}

/// What a formula is made of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Node {
    /// A letter, a number, a sign or a word, as Unicode writes it.
    Word(String),
    /// A fraction.
    Fraction(Formula, Formula),
    /// A square root.
    Root(Formula),
    /// Something in round brackets.
    Group(Formula),
    /// Something with an arrow over it.
    Vector(Formula),
    /// Something with a subscript, a superscript or both.
    Scripts {
        /// What they are written at.
        base: Box<Node>,
        /// The subscript.
        below: Option<Formula>,
        /// The superscript.
        above: Option<Formula>,
    },
}

impl From<Node> for Formula {
    fn from(node: Node) -> Self {
        Self(vec![Term { apart: false, node }])
    }
}

/// `text` as a subscript, if Unicode has all its letters.
pub(crate) fn subscript(text: &str) -> Option<String> {
    text.chars().map(letters::lowered).collect()
}

/// `text` as a superscript, if Unicode has all its letters.
pub(crate) fn superscript(text: &str) -> Option<String> {
    text.chars().map(letters::raised).collect()
}

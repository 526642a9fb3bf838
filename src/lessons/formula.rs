//! Formulas: their notation in a chapter, and their structure.
//!
//! The grammar is specific to carrom and described in `docs/lessons.md`. `widgets::formula` lays
//! out a formula over several rows.

mod inline;
mod letters;
mod parse;

use letters::letter;
pub(crate) use letters::{lowered, raised};

/// A formula, as a sequence of parts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Formula(pub Vec<Term>);

/// A part of a formula, with the space that may precede it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Term {
    /// Whether there is a space before the part.
    pub apart: bool,
    /// The part itself.
    pub node: Node,
}

/// A part of a formula.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Node {
    /// A letter, a number, a sign or a word, as written in Unicode.
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
        /// The base.
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

/// Converts `text` to subscript characters; `None` if [`letters`] lacks any of them.
pub(crate) fn subscript(text: &str) -> Option<String> {
    text.chars().map(lowered).collect()
}

/// Converts `text` to superscript characters; `None` if [`letters`] lacks any of them.
pub(crate) fn superscript(text: &str) -> Option<String> {
    text.chars().map(raised).collect()
}

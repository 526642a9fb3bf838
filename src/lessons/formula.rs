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

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// What was expected, in words.
    ///
    /// ```
    /// use carrom::lessons::Formula;
    /// let formula = Formula::read("v_1n = (m_1 - m_2)/(m_1 + m_2) u_1n").unwrap();
    /// assert_eq!(formula.inline(), "v₁ₙ = (m₁ − m₂)/(m₁ + m₂) u₁ₙ");
    /// ```
    pub fn read(text: &str) -> Result<Self, String> {
        parse::read(text)
    }

    /// The formula in one line of Unicode.
    pub fn inline(&self) -> String {
        inline::write(self)
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

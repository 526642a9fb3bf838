//! A formula in spoken form.

use super::spoken::{is_function, spoken_formula, unit_name};
use crate::lessons::formula::{Formula, Node, subscript, superscript};

/// A formula in words, which [`spoken`](super::spoken()) leaves unchanged.
pub(super) fn aloud(formula: &Formula) -> String {
    spoken_formula(&linear(formula))
}

/// A formula on one line, with fractions, roots and vectors in words and with Unicode symbols.
fn linear(formula: &Formula) -> String {
    let mut line = String::new();
    let (mut after_fraction, mut after_factor) = (false, false);
    for term in &formula.0 {
        let node = &term.node;
        // Without these words, a listener would think that terms after a fraction belong to its
        // denominator, and that a fraction or a root after a factor is something separate.
        line += match () {
            () if after_fraction && is_factor(node) => " × ",
            () if after_factor && matches!(node, Node::Fraction(..) | Node::Root(_)) => " × ",
            () if term.apart => " ",
            () => "",
        };
        line += &of_node(node);
        after_fraction = matches!(node, Node::Fraction(_, under) if !awaits(under));
        after_factor = is_factor(node) && !is_named(node);
    }
    line.trim().to_owned()
}

/// Whether the formula ends in a function without its argument.
fn awaits(formula: &Formula) -> bool {
    formula.0.last().is_some_and(|term| is_named(&term.node))
}

/// Whether the node is the name of a function, with or without a power.
fn is_named(node: &Node) -> bool {
    match node {
        Node::Word(word) => is_function(word),
        Node::Scripts { base, .. } => is_named(base),
        _ => false,
    }
}

/// Whether the node can be a factor, as everything but an operator can.
fn is_factor(node: &Node) -> bool {
    match node {
        Node::Word(word) => word.starts_with(char::is_alphanumeric),
        _ => true,
    }
}

fn of_node(node: &Node) -> String {
    match node {
        // Only a word with more than one letter can be a unit.
        Node::Word(word) if word.chars().count() > 1 => unit_name(word),
        Node::Word(word) => word.clone(),
        Node::Group(inside) => format!("({})", linear(inside)),
        // Many screen readers skip brackets.
        Node::Fraction(over, under) if over.0.len() > 1 || under.0.len() > 1 => {
            let (all, over) = match over.0.len() {
                1 => ("", linear(over)),
                _ => (", all that,", linear(over)),
            };
            let under = linear(under);
            format!(" the fraction {over}{all} over {under}, end of fraction ")
        }
        Node::Fraction(over, under) => format!(" {} over {} ", linear(over), linear(under)),
        Node::Root(inside) => format!(" the square root of {} ", tight(inside)),
        Node::Vector(inside) => format!(" vector {} ", linear(inside)),
        Node::Scripts { base, below, above } => {
            let mut line = of_node(base);
            if let Some(below) = below {
                let below = linear(below);
                line += &subscript(&below).unwrap_or_else(|| format!(" {below}"));
            }
            if let Some(above) = above {
                let above = linear(above);
                line += &superscript(&above).unwrap_or_else(|| format!(" to the power {above}"));
            }
            line
        }
    }
}

/// A formula in brackets, unless it is a single term.
fn tight(formula: &Formula) -> String {
    let line = linear(formula);
    if formula.0.len() == 1 {
        line
    } else {
        format!("({line})")
    }
}

#[cfg(test)]
mod tests {
    use super::super::spoken;
    use super::*;

    #[test]
    fn formulas_are_read_aloud() {
        for (written, read) in [
            (
                "u^2 = v_1^2 + v_2^2",
                "u squared equals v 1 squared plus v 2 squared",
            ),
            (
                "v_1n = (m_1 - m_2)/(m_1 + m_2) u_1n",
                "v 1 n equals the fraction m 1 minus m 2, all that, over m 1 plus m 2, end of fraction \
                 times u 1 n",
            ),
            (
                "v_2n = (2 m_1)/(m_1 + m_2) u_1n",
                "v 2 n equals the fraction 2 m 1, all that, over m 1 plus m 2, end of fraction times \
                 u 1 n",
            ),
            ("p = 2 m v", "p equals 2 m v"),
            (
                "mu = m_1 m_2/(m_1 + m_2)",
                "mu equals m 1 times the fraction m 2 over m 1 plus m 2, end of fraction",
            ),
            (
                "(3 sqrt(2))/2",
                "the fraction 3 times the square root of 2, all that, over 2, end of fraction",
            ),
            (
                "v_x = v_n n_x + v_t t_x",
                "v x equals v n times n x plus v t times t x",
            ),
            (
                "v = 4 \"m/s\" + 15 \"mm\"",
                "v equals 4 metres per second plus 15 millimetres",
            ),
            ("v_1 = u sin alpha", "v 1 equals u times the sine of alpha"),
            (
                "b = d/2 cot(Theta/2)",
                "b equals d over 2 times the cotangent of (capital theta over 2)",
            ),
            (
                "cot x = 1/(tan x)",
                "the cotangent of x equals the fraction 1 over the tangent of x, end of fraction",
            ),
            (
                "d/2 (1 + 1/sin(Theta/2))",
                "d over 2 times (1 plus 1 over the sine of (capital theta over 2))",
            ),
            (
                "theta_1 = 90 deg - arcsin(b/(2 r))",
                "theta 1 equals 90 degrees minus the arc sine of (the fraction b over 2 r, end of \
                 fraction)",
            ),
            (
                "dσ/dΩ = (d^2)/(16 sin^4 (Theta / 2))",
                "d sigma over d omega equals the fraction d squared over 16 times the sine to the \
                 power 4 of (capital theta over 2), end of fraction",
            ),
            (
                "E_1 : E_2 = sin^2 alpha : cos^2 alpha",
                "E 1 to E 2 equals the sine squared of alpha to the cosine squared of alpha",
            ),
            (
                "m_1 vec(u) = m_1 vec(v_1) + m_2 vec(v_2)",
                "m 1 vector u equals m 1 vector v 1 plus m 2 vector v 2",
            ),
            (
                "0 = 2 vec(v_1) dot vec(v_2)",
                "0 equals 2 vector v 1 dot vector v 2",
            ),
            (
                "v_1 dot v_2 = u_1 dot u_2",
                "v 1 dot v 2 equals u 1 dot u 2",
            ),
            ("10^(-7)", "10 to the power minus 7"),
        ] {
            let formula = Formula::read(written).unwrap();
            assert_eq!(spoken(&aloud(&formula)), read, "{written}");
        }
    }
}

//! A formula as it is read aloud.

use crate::lessons::{Formula, Node};

/// A formula in words and signs that [`spoken`](super::spoken()) spells.
pub(super) fn linear(formula: &Formula) -> String {
    let terms = formula.0.iter().map(|term| {
        let blank = if term.apart { " " } else { "" };
        format!("{blank}{}", of_node(&term.node))
    });
    terms.collect::<String>().trim().to_owned()
}

fn of_node(node: &Node) -> String {
    match node {
        Node::Word(word) => word.clone(),
        Node::Group(inside) => format!("({})", linear(inside)),
        Node::Fraction(over, under) => format!(" {} over {} ", tight(over), tight(under)),
        Node::Root(inside) => format!(" the square root of {} ", tight(inside)),
        Node::Vector(inside) => format!(" vector {} ", linear(inside)),
        Node::Scripts { base, below, above } => {
            let mut line = of_node(base);
            if let Some(below) = below {
                line += &format!(" {}", linear(below));
            }
            if let Some(above) = above {
                line += &match linear(above).as_str() {
                    "2" => " squared".to_owned(),
                    "3" => " cubed".to_owned(),
                    power => format!(" to the power {power}"),
                };
            }
            line
        }
    }
}

/// In brackets, unless it is a single thing.
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
                "v 1n equals (m 1 minus m 2) over (m 1 plus m 2) u 1n",
            ),
            ("v_1 = u sin alpha", "v 1 equals u times the sine of alpha"),
            (
                "m_1 vec(u) = m_1 vec(v_1) + m_2 vec(v_2)",
                "m 1 vector u equals m 1 vector v 1 plus m 2 vector v 2",
            ),
        ] {
            let formula = Formula::read(written).unwrap();
            assert_eq!(spoken(&linear(&formula)), read, "{written}");
        }
    }
}

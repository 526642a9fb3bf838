//! Formulas on a single line.

use super::{Formula, Node, subscript, superscript};

impl Formula {
    /// The formula on a single line of Unicode text.
    pub fn inline(&self) -> String {
        let mut line = String::new();
        for term in &self.0 {
            if term.apart {
                line.push(' ');
            }
            line += &of_node(&term.node);
        }
        line
    }
}

fn of_node(node: &Node) -> String {
    match node {
        Node::Word(word) => word.clone(),
        Node::Group(inside) => format!("({})", inside.inline()),
        Node::Fraction(over, under) => format!("{}/{}", tight(over), tight(under)),
        Node::Root(inside) => format!("√{}", tight(inside)),
        Node::Vector(inside) => inside.inline(),
        Node::Scripts { base, below, above } => {
            let mut line = of_node(base);
            if let Some(below) = below {
                line += &script('_', below, subscript);
            }
            if let Some(above) = above {
                line += &script('^', above, superscript);
            }
            line
        }
    }
}

/// The formula in brackets, unless it consists of a single part.
fn tight(formula: &Formula) -> String {
    let line = formula.inline();
    match formula.0.len() {
        1 => line,
        _ => format!("({line})"),
    }
}

fn script(mark: char, formula: &Formula, set: fn(&str) -> Option<String>) -> String {
    set(&formula.inline()).unwrap_or_else(|| format!("{mark}{}", tight(formula)))
}

//! Formulas set over several rows, as on paper: fractions, roots, superscripts and subscripts.

mod block;

use block::FormulaBlock;

use super::Charset;
use crate::lessons::formula::{Formula, Node, subscript, superscript};

/// A formula as rows of text of the same width.
///
/// ```
/// use carrom::lessons::Formula;
/// use carrom::widgets::{Charset, formula};
/// let third = Formula::read("x = (a + b)/3").unwrap();
/// assert_eq!(
///     formula::set(&third, Charset::Ascii),
///     ["     a + b ", "x = -------", "       3   "],
/// );
/// ```
pub fn set(formula: &Formula, charset: Charset) -> Vec<String> {
    Setter { charset }.row(formula).rows
}

/// Sets formulas in a charset.
struct Setter {
    charset: Charset,
}

impl Setter {
    fn row(&self, formula: &Formula) -> FormulaBlock {
        let mut row = FormulaBlock::default();
        for term in &formula.0 {
            // In ASCII the degree sign is spelt as a word.
            let degree = term.node == Node::Word("°".into()) && self.charset == Charset::Ascii;
            if term.apart || degree {
                row = row.beside(&FormulaBlock::line(" "));
            }
            row = row.beside(&self.node(&term.node));
        }
        row
    }

    fn node(&self, node: &Node) -> FormulaBlock {
        match node {
            Node::Word(word) => FormulaBlock::line(&self.charset.text(word)),
            Node::Group(inside) => self.bracketed(&self.row(inside)),
            Node::Fraction(over, under) => {
                let (over, under) = (self.row(over), self.row(under));
                let width = over.width().max(under.width()) + 2;
                over.over(&FormulaBlock::line(&self.charset.text("─").repeat(width)))
                    .with_base_at_end()
                    .over(&under)
            }
            Node::Root(inside) => self.root(&self.row(inside)),
            Node::Vector(inside) => {
                let arrow = FormulaBlock::line(&self.charset.text("→"));
                arrow.over(&self.row(inside)).with_base_at_end()
            }
            Node::Scripts { base, below, above } => {
                self.scripted(&self.node(base), below.as_ref(), above.as_ref())
            }
        }
    }

    fn bracketed(&self, inside: &FormulaBlock) -> FormulaBlock {
        let brackets = match self.charset {
            _ if inside.rows.len() == 1 => [["("; 3], [")"; 3]],
            Charset::Ascii => [["/", "|", "\\"], ["\\", "|", "/"]],
            Charset::Unicode => [["⎛", "⎜", "⎝"], ["⎞", "⎟", "⎠"]],
        };
        let [left, right] = brackets.map(|[top, middle, bottom]| {
            let last = inside.rows.len() - 1;
            let row = |i| match i {
                0 => top,
                i if i == last => bottom,
                _ => middle,
            };
            let rows = (0..inside.rows.len()).map(|i| row(i).to_owned());
            FormulaBlock::of(rows, inside.base)
        });
        left.beside(inside).beside(&right)
    }

    /// Sets a root: its sign on the left, and a line above the radicand.
    fn root(&self, inside: &FormulaBlock) -> FormulaBlock {
        let roof = "_".repeat(inside.width());
        let (hook, side) = match self.charset {
            Charset::Ascii => ("\\/", " |"),
            Charset::Unicode => ("√", "│"),
        };
        let last = inside.rows.len() - 1;
        let left = (0..=last).map(|i| if i == last { hook } else { side }.to_owned());
        let left = FormulaBlock::of(left, inside.base);
        let mut roofed = FormulaBlock::line(&roof).over(inside);
        roofed.base = inside.base + 1;
        left.beside(&roofed)
    }

    /// Sets superscripts and subscripts. A subscript is on the baseline if Unicode has letters for
    /// it (in ASCII they are spelt out), otherwise below the base. In Unicode, a superscript is on
    /// the baseline if there are letters for it and the base has a single row; in all other cases
    /// it is above the base.
    fn scripted(
        &self,
        base: &FormulaBlock,
        below: Option<&Formula>,
        above: Option<&Formula>,
    ) -> FormulaBlock {
        let mut set = base.clone();
        let mut low = None;
        if let Some(below) = below {
            match subscript(&below.inline()) {
                Some(letters) => set = set.beside(&self.spelt(&letters, base)),
                None => low = Some(self.row(below)),
            }
        }
        let mut high = None;
        if let Some(above) = above {
            match superscript(&above.inline()) {
                Some(letters) if self.charset == Charset::Unicode && base.rows.len() == 1 => {
                    set = set.beside(&FormulaBlock::line(&letters));
                }
                _ => high = Some(self.row(above)),
            }
        }
        set.with_scripts(high.as_ref(), low.as_ref())
    }

    /// Sets a subscript beside its base; in ASCII, an underscore separates two letters.
    fn spelt(&self, letters: &str, base: &FormulaBlock) -> FormulaBlock {
        let spelt = self.charset.text(letters);
        let joined = base.ends_with_letter() && spelt.starts_with(char::is_alphabetic);
        if joined && self.charset == Charset::Ascii {
            FormulaBlock::line(&format!("_{spelt}"))
        } else {
            FormulaBlock::line(&spelt)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::widgets::text::width;
    use proptest::prelude::*;

    fn ascii(text: &str) -> Vec<String> {
        let rows = set(&Formula::read(text).unwrap(), Charset::Ascii);
        rows.iter().map(|row| row.trim_end().to_owned()).collect()
    }

    fn unicode(text: &str) -> Vec<String> {
        let rows = set(&Formula::read(text).unwrap(), Charset::Unicode);
        rows.iter().map(|row| row.trim_end().to_owned()).collect()
    }

    #[test]
    fn fractions_are_set_over_several_rows() {
        let formula = "v_1n = (m_1 - m_2)/(m_1 + m_2) u_1n";
        assert_eq!(
            ascii(formula),
            [
                "        m1 - m2",
                "v1_n = --------- u1_n",
                "        m1 + m2",
            ]
        );
        assert_eq!(
            unicode(formula),
            ["       m₁ − m₂", "v₁ₙ = ───────── u₁ₙ", "       m₁ + m₂"]
        );
    }

    #[test]
    fn roots_and_scripts_are_set_in_both_charsets() {
        assert_eq!(ascii("2 sqrt 3"), ["    _", "2 \\/3"]);
        assert_eq!(unicode("sqrt(a + b)"), [" _____", "√a + b"]);
        assert_eq!(ascii("sin^2 alpha"), ["   2", "sin  alpha"]);
        assert_eq!(unicode("sin^2 alpha"), ["sin² α"]);
        assert_eq!(ascii("theta_1 = 60 deg"), ["theta1 = 60 deg"]);
        assert_eq!(
            ascii("1/(sin^4 (Theta/2))"),
            [
                "       1",
                "----------------",
                "    4 / Theta \\",
                " sin  |-------|",
                "      \\   2   /",
            ]
        );
        assert_eq!(unicode("x_max"), ["x", " max"]);
        assert_eq!(ascii("x^(1/2)"), ["  1", " ---", "  2", "x"]);
        assert_eq!(unicode("(a/b)"), ["⎛ a ⎞", "⎜───⎟", "⎝ b ⎠"]);
        assert_eq!(unicode("vec(v)_1 + v_2"), ["→", "v₁ + v₂"]);
    }

    proptest! {
        #[test]
        fn all_rows_have_the_same_width(text in "[-a-z0-9_^()/ =+]{1,40}") {
            if let Ok(formula) = Formula::read(&text) {
                for charset in [Charset::Ascii, Charset::Unicode] {
                    let rows = set(&formula, charset);
                    prop_assert!(rows.iter().all(|row| width(row) == width(&rows[0])), "{rows:?}");
                    prop_assert!(charset == Charset::Unicode || rows.iter().all(|row| row.is_ascii()));
                }
            }
        }
    }
}

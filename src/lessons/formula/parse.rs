//! The parser of formulas.

use super::{Formula, Node, Term, letter};

/// The maximum length of a formula, in characters.
const LONGEST: usize = 300;
/// The maximum depth of nested brackets.
const DEEPEST: usize = 12;

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// Returns a message that states what was expected.
    ///
    /// ```
    /// use carrom::lessons::Formula;
    /// let formula = Formula::read("v_1n = (m_1 - m_2)/(m_1 + m_2) u_1n").unwrap();
    /// assert_eq!(formula.inline(), "v₁ₙ = (m₁ − m₂)/(m₁ + m₂) u₁ₙ");
    /// ```
    pub fn read(text: &str) -> Result<Self, String> {
        let letters: Vec<char> = text.trim().chars().collect();
        if letters.is_empty() {
            return Err("expected a formula, found nothing".into());
        }
        if letters.len() > LONGEST {
            return Err(format!(
                "expected a formula of at most {LONGEST} characters"
            ));
        }
        let mut reader = FormulaReader {
            letters: &letters,
            at: 0,
            depth: 0,
        };
        let formula = reader.row()?;
        match reader.peek() {
            None => Ok(formula),
            Some(other) => Err(format!("expected the end of the formula, found {other}")),
        }
    }
}

struct FormulaReader<'a> {
    letters: &'a [char],
    at: usize,
    depth: usize,
}

impl FormulaReader<'_> {
    fn peek(&self) -> Option<char> {
        self.letters.get(self.at).copied()
    }

    fn peek_after(&self) -> Option<char> {
        self.letters.get(self.at + 1).copied()
    }

    fn take_while(&mut self, wanted: impl Fn(char) -> bool) -> String {
        let rest = self.letters.iter().skip(self.at).copied();
        let taken: String = rest.take_while(|c| wanted(*c)).collect();
        self.at += taken.chars().count();
        taken
    }

    /// Reads terms up to a closing bracket or the end of the formula.
    fn row(&mut self) -> Result<Formula, String> {
        let mut terms = Vec::new();
        loop {
            let apart = !self.take_while(|c| c == ' ').is_empty() && !terms.is_empty();
            match self.peek() {
                None | Some(')') => return Ok(Formula(terms)),
                Some(_) => {
                    let node = self.term()?;
                    // There is no space between a number and a degree sign.
                    let apart = apart && node != Node::Word("°".into());
                    terms.push(Term { apart, node });
                }
            }
        }
    }

    /// Reads a single term; a slash without spaces makes a fraction.
    fn term(&mut self) -> Result<Node, String> {
        let over = self.scripted()?;
        let is_operand = |c: char| c.is_alphanumeric() || c == '(' || c == '"';
        if self.peek() == Some('/') && self.peek_after().is_some_and(is_operand) {
            self.at += 1;
            let under = self.scripted()?;
            return Ok(Node::Fraction(unbracketed(over), unbracketed(under)));
        }
        Ok(over)
    }

    /// Reads an atom with its subscript and superscript.
    fn scripted(&mut self) -> Result<Node, String> {
        let base = self.atom()?;
        let (mut below, mut above) = (None, None);
        loop {
            let slot = match self.peek() {
                Some('_') => &mut below,
                Some('^') => &mut above,
                _ => break,
            };
            if slot.is_some() {
                return Err("expected at most one _ and one ^ after a letter".into());
            }
            self.at += 1;
            *slot = Some(self.script()?);
        }
        Ok(match (&below, &above) {
            (None, None) => base,
            _ => Node::Scripts {
                base: Box::new(base),
                below,
                above,
            },
        })
    }

    fn script(&mut self) -> Result<Formula, String> {
        if self.peek() == Some('(') {
            return self.bracketed();
        }
        let text = self.take_while(char::is_alphanumeric);
        if text.is_empty() {
            return Err("expected letters, digits or a bracket after _ or ^".into());
        }
        Ok(Node::Word(letter(&text).map_or(text, String::from)).into())
    }

    fn atom(&mut self) -> Result<Node, String> {
        let Some(first) = self.peek() else {
            return Err("expected more of the formula, found its end".into());
        };
        if first == '(' {
            return Ok(Node::Group(self.bracketed()?));
        }
        if first.is_ascii_digit() {
            let number = self.take_while(|c| c.is_ascii_digit() || c == '.');
            return Ok(Node::Word(number));
        }
        if first.is_alphabetic() {
            let name = self.take_while(char::is_alphabetic);
            return match name.as_str() {
                "sqrt" => Ok(Node::Root(self.argument()?)),
                "vec" => Ok(Node::Vector(self.argument()?)),
                _ => Ok(Node::Word(letter(&name).map_or(name, String::from))),
            };
        }
        if first == '"' {
            self.at += 1;
            let text = self.take_while(|c| c != '"');
            if self.peek().is_none() {
                return Err("expected a closing double quote".into());
            }
            self.at += 1;
            return Ok(Node::Word(text));
        }
        self.sign(first)
    }

    /// Reads the part under a root sign or an arrow: the contents of a bracket, or a single atom
    /// with its subscript and superscript.
    fn argument(&mut self) -> Result<Formula, String> {
        self.take_while(|c| c == ' ');
        self.deeper(|reader| match reader.peek() {
            Some('(') => reader.bracketed(),
            _ => Ok(reader.scripted()?.into()),
        })
    }

    fn bracketed(&mut self) -> Result<Formula, String> {
        self.at += 1;
        let inside = self.deeper(Self::row)?;
        if self.peek() != Some(')') {
            return Err("expected a closing bracket".into());
        }
        if inside.0.is_empty() {
            return Err("expected something between the brackets".into());
        }
        self.at += 1;
        Ok(inside)
    }

    fn deeper<T>(
        &mut self,
        read: impl FnOnce(&mut Self) -> Result<T, String>,
    ) -> Result<T, String> {
        if self.depth == DEEPEST {
            return Err(format!("expected brackets at most {DEEPEST} deep"));
        }
        self.depth += 1;
        let read = read(self);
        self.depth -= 1;
        read
    }

    fn sign(&mut self, first: char) -> Result<Node, String> {
        let (sign, length) = match (first, self.peek_after()) {
            ('<', Some('=')) => ('≤', 2),
            ('>', Some('=')) => ('≥', 2),
            ('!', Some('=')) => ('≠', 2),
            ('=', Some('>')) => ('⇒', 2),
            ('-', Some('>')) => ('→', 2),
            ('+', Some('-')) => ('±', 2),
            ('-', _) => ('−', 1),
            ('*', _) => ('·', 1),
            ('\'', _) => ('′', 1),
            (sign, _) if "−+=<>/|,;:%.°½".contains(sign) => (sign, 1),
            _ => {
                return Err(format!(
                    "expected a letter, a number or a sign, found {first}"
                ));
            }
        };
        self.at += length;
        Ok(Node::Word(sign.into()))
    }
}

/// The contents of a node if it is a bracket, otherwise the node itself.
fn unbracketed(node: Node) -> Formula {
    match node {
        Node::Group(inside) => inside,
        node => node.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn inline(text: &str) -> String {
        Formula::read(text).unwrap().inline()
    }

    #[test]
    fn formulas_of_the_chapters_are_set_in_one_line() {
        for (text, set) in [
            ("v_1 = u sin alpha", "v₁ = u sin α"),
            ("theta_1 = 90 deg - alpha", "θ₁ = 90° − α"),
            ("sqrt 5", "√5"),
            ("2 sqrt 3 approx 3.46", "2 √3 ≈ 3.46"),
            ("sqrt(a^2 + b^2)", "√(a² + b²)"),
            ("m_1/m_2", "m₁/m₂"),
            ("(1 + e) m_2/(m_1 + m_2)", "(1 + e) m₂/(m₁ + m₂)"),
            ("vec(u)_1 = vec(v)_1 + vec(v)_2", "u₁ = v₁ + v₂"),
            ("1/sin^4 (Theta/2)", "1/sin⁴ (Θ/2)"),
            ("v_1 dot v_2 = 0 => v_1 perp v_2", "v₁ · v₂ = 0 ⇒ v₁ ⟂ v₂"),
            ("10^(-7)", "10⁻⁷"),
            ("a / b", "a / b"),
            ("4 \"m/s\"", "4 m/s"),
            ("u_max", "u_max"),
        ] {
            assert_eq!(inline(text), set);
        }
    }

    #[test]
    fn formula_errors_are_reported() {
        for (text, message) in [
            ("", "expected a formula, found nothing"),
            ("(a + b", "expected a closing bracket"),
            ("a)", "expected the end of the formula, found )"),
            ("v_", "expected letters, digits or a bracket after _ or ^"),
            ("v_1_2", "expected at most one _ and one ^ after a letter"),
            ("\\frac", "expected a letter, a number or a sign, found \\"),
            ("\"m/s", "expected a closing double quote"),
            ("()", "expected something between the brackets"),
        ] {
            assert_eq!(Formula::read(text), Err(message.to_owned()));
        }
        assert!(Formula::read(&"(".repeat(200)).is_err());
        assert!(Formula::read(&"sqrt ".repeat(50)).is_err());
    }

    proptest! {
        #[test]
        fn any_text_is_a_formula_or_gives_an_error(text in "[-a-z0-9_^()/ \"=+.√αµ{}]{0,60}") {
            if let Ok(formula) = Formula::read(&text) {
                prop_assert!(!formula.inline().is_empty() || text.contains("\"\""));
            }
        }
    }
}

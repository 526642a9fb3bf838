//! The words of a directive: `lab carrom alpha_deg=40 own`.

use super::Constant;

/// The words of a directive. The parser takes the words that it knows out of this list, one by one.
#[derive(Debug, Clone, Default)]
pub(super) struct Words {
    bare: Vec<String>,
    fields: Vec<(String, String)>,
}

impl Words {
    /// Splits a directive at spaces; a value that contains spaces must be in quotes.
    ///
    /// # Errors
    /// Returns a message that states what was expected.
    pub(super) fn of(text: &str) -> Result<Self, String> {
        let mut words = Self::default();
        let parts = shlex::split(text).ok_or("expected a closing quote")?;
        for part in parts {
            match part.split_once('=') {
                Some(("", _)) => {
                    let message = format!("expected a field such as alpha_deg=45, found {part}");
                    return Err(message);
                }
                Some((name, _)) if words.fields.iter().any(|(known, _)| known == name) => {
                    return Err(format!("expected {name} once, found it twice"));
                }
                Some((name, value)) => words.fields.push((name.into(), value.into())),
                None => words.bare.push(part),
            }
        }
        Ok(words)
    }

    /// Takes the first word that is not a field.
    pub(super) fn first(&mut self) -> Option<String> {
        (!self.bare.is_empty()).then(|| self.bare.remove(0))
    }

    /// Takes the word `flag`, if it is present.
    pub(super) fn flag(&mut self, flag: &str) -> bool {
        let at = self.bare.iter().position(|word| word == flag);
        at.map(|at| self.bare.remove(at)).is_some()
    }

    /// Takes the value of a field, if the field is present.
    pub(super) fn field(&mut self, name: &str) -> Option<String> {
        let at = self.fields.iter().position(|(known, _)| known == name)?;
        Some(self.fields.remove(at).1)
    }

    /// Takes all fields whose names `wanted` accepts.
    pub(super) fn fields(&mut self, wanted: impl Fn(&str) -> bool) -> Vec<(String, String)> {
        let taken = self.fields.extract_if(.., |(name, _)| wanted(name));
        taken.collect()
    }

    /// The constant with this name, if there is one; also takes the fields of the constant.
    ///
    /// # Errors
    /// Returns a message about an invalid field.
    pub(super) fn constant(&mut self, name: &str) -> Result<Option<Constant>, String> {
        let Some(mut constant) = Constant::named(name) else {
            return Ok(None);
        };
        for (field, value) in self.fields(|_| true) {
            constant.set(&field, &value)?;
        }
        Ok(Some(constant))
    }

    /// Takes a field that is a number between two bounds.
    ///
    /// # Errors
    /// Returns a message that states what was expected.
    pub(super) fn number(
        &mut self,
        name: &str,
        least: f64,
        most: f64,
    ) -> Result<Option<f64>, String> {
        let Some(written) = self.field(name) else {
            return Ok(None);
        };
        let number = written.parse().ok();
        let number = number.filter(|value| (least..=most).contains(value));
        let expected = || format!("{name}: expected {least} to {most}, found {written}");
        number.map(Some).ok_or_else(expected)
    }

    /// Checks that no words are left.
    ///
    /// # Errors
    /// Returns a message about a word that is left.
    pub(super) fn finish(self) -> Result<(), String> {
        let fields = self.fields.into_iter().map(|(name, _)| name);
        match self.bare.into_iter().chain(fields).next() {
            None => Ok(()),
            Some(word) => Err(format!("expected no more words here, found {word}")),
        }
    }
}

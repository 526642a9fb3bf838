//! Forms with one setting per row: a number with a range and a step, a choice, or text.

use std::borrow::Cow;

use strum::{EnumMessage, IntoStaticStr};

use super::{EntryAction, KeyTable, NumberEntry, Outcome, TextField};
use crate::messages::Key;
use crate::numbers::fixed;
use crate::widgets::{Role, panel::Panel};

/// The size of a fine step, as a fraction of an ordinary step.
const FINE: f64 = 0.1;
/// The size of a big step, in ordinary steps.
const BIG: f64 = 10.0;

/// A setting with its current value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Field {
    /// The name in the panel.
    pub name: Cow<'static, str>,
    /// The value as text, with its unit.
    pub shown: String,
    /// The value and its range.
    pub value: FieldValue,
    /// A one-line description, shown while the field is selected.
    pub about: Cow<'static, str>,
    /// The reason why the field cannot be changed at present.
    pub locked: Option<&'static str>,
}

impl Field {
    /// Creates a field that can be changed.
    pub(crate) fn new(
        name: impl Into<Cow<'static, str>>,
        (value, shown): (FieldValue, String),
        about: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self {
            name: name.into(),
            shown,
            value,
            about: about.into(),
            locked: None,
        }
    }
}

/// The value and range of a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum FieldValue {
    /// A number that can be typed or changed in steps.
    Number {
        /// The value, in the unit shown on the screen.
        value: f64,
        /// The smallest and the largest value.
        range: (f64, f64),
        /// The change made by the right arrow key, which moves the value to a whole multiple of
        /// this step. It is negative if moving to the right means a smaller value.
        step: f64,
        /// The unit as written after a number: " mm", "°", or an empty string.
        unit: &'static str,
    },
    /// One of several options, counted from 0; the last option is followed by the first.
    Choice {
        /// The index of the current option.
        at: usize,
        /// The number of options.
        count: usize,
    },
    /// Text to be typed, with its maximum number of letters.
    Text(usize),
}

impl FieldValue {
    /// A number; see [`FieldValue::Number`].
    pub(crate) const fn number(
        value: f64,
        range: (f64, f64),
        step: f64,
        unit: &'static str,
    ) -> Self {
        Self::Number {
            value,
            range,
            step,
            unit,
        }
    }

    /// A number, and its text with this many decimals and its unit.
    pub(crate) fn decimal(
        value: f64,
        range: (f64, f64),
        step: f64,
        (decimals, unit): (usize, &'static str),
    ) -> (Self, String) {
        let number = Self::number(value, range, step, unit);
        (number, fixed(value, decimals) + unit)
    }

    /// One of several options, and its name.
    pub(crate) fn choice(at: usize, names: &[&str]) -> (Self, String) {
        let name = names.get(at).copied().unwrap_or_default();
        let count = names.len();
        (Self::Choice { at, count }, name.to_owned())
    }

    /// The value after `steps` steps, rounded to a whole multiple of the step, or of the given
    /// fraction of a step; a choice moves to the next or the previous option.
    pub(crate) fn stepped(self, steps: f64) -> f64 {
        match self {
            Self::Text(_) => 0.0,
            Self::Choice { at, count } => {
                let by = steps.signum() as i64;
                (at as i64 + by).rem_euclid(count.max(1) as i64) as f64
            }
            Self::Number { value, step, .. } => {
                let size = step.abs() * steps.abs().min(1.0);
                let by = steps * step / size;
                // A value that is within a thousandth of a step of a whole multiple counts as that
                // multiple.
                let onto = match by > 0.0 {
                    true => (value / size + by + 1e-3).floor(),
                    false => (value / size + by - 1e-3).ceil(),
                };
                // This removes the rounding error of adding tenths, and turns −0 into 0.
                (onto * size * 1e6).round() / 1e6 + 0.0
            }
        }
    }
}

/// A setting of `S` as a row of a table, with everything that a form needs.
#[derive(Debug)]
pub(crate) struct FieldRow<S> {
    /// The name in the panel.
    pub name: &'static str,
    /// A one-line description.
    pub about: &'static str,
    /// The value and its range, and the value as text, with its unit.
    pub now: fn(&S) -> (FieldValue, String),
    /// Sets a number, which must be in its range, or selects a choice by its index.
    pub put: fn(&mut S, f64),
}

impl<S> FieldRow<S> {
    /// The form field for this setting, with its current value.
    pub(crate) fn field(&self, of: &S) -> Field {
        Field::new(self.name, (self.now)(of), self.about)
    }

    /// Sets a number, clamped to its range, or selects a choice by its index.
    pub(crate) fn set(&self, of: &mut S, value: f64) {
        let (least, most) = match (self.now)(of).0 {
            FieldValue::Number { range, .. } => range,
            FieldValue::Choice { count, .. } => (0.0, count.saturating_sub(1) as f64),
            FieldValue::Text(_) => return,
        };
        // Adding 0 turns −0 into 0.
        (self.put)(of, value.clamp(least, most) + 0.0);
    }

    /// Changes the setting by `steps` steps; choices wrap around.
    pub(crate) fn step(&self, of: &mut S, steps: f64) {
        self.set(of, (self.now)(of).0.stepped(steps));
    }
}

/// The settings that a form edits.
pub(crate) trait FormFields {
    /// All fields with their values, from top to bottom.
    fn fields(&self) -> Vec<Field>;

    /// Sets the field at an index: a number, which is clamped to its range, or the index of a
    /// choice.
    fn set(&mut self, at: usize, value: f64);

    /// Sets the text of the field at an index.
    fn set_text(&mut self, _at: usize, _text: &str) {}
}

/// What the keys do on a form.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum FormAction {
    /// choose a setting
    Choose(isize),
    /// finish the text and go to the next setting
    Next,
    /// go to the first or the last setting
    End(isize),
    /// change the setting by one step
    Step(i8),
    /// change the setting by a tenth of a step
    Fine(i8),
    /// change the setting by ten steps
    Big(i8),
    /// type a number
    Number(EntryAction),
    /// choose this setting; if it has few values, go to the next value
    Point(usize),
}

/// The selected field of a form, and the number or the text being typed into it.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct SettingsForm {
    at: usize,
    entry: NumberEntry,
    /// The text that was typed last, with its cursor.
    line: Option<TextField>,
    /// Whether the number typed last was out of range and was clamped.
    held: bool,
}

impl SettingsForm {
    /// The action that accepts the typed number.
    pub(crate) const SET: FormAction = FormAction::Number(EntryAction::Enter);

    /// Creates a form in which the field at this index is selected.
    pub(crate) fn at(at: usize) -> Self {
        Self {
            at,
            ..Self::default()
        }
    }

    /// The index of the selected field, from 0.
    pub(crate) fn selected(&self, fields: usize) -> usize {
        self.at.min(fields.saturating_sub(1))
    }

    fn chosen(&self, form: &impl FormFields) -> Option<Field> {
        let fields = form.fields();
        let at = self.selected(fields.len());
        fields.into_iter().nth(at)
    }

    /// Selects a field, after accepting any number that was typed into the previous one.
    pub(crate) fn select(&mut self, at: usize, form: &mut impl FormFields) {
        self.commit(form);
        self.held = false;
        self.at = at;
    }

    /// The text of the selected field, with its cursor; `None` if that is not a text field.
    fn line(&self, form: &impl FormFields) -> Option<TextField> {
        let field = self.chosen(form)?;
        let FieldValue::Text(most) = field.value else {
            return None;
        };
        let same = self.line.clone().filter(|it| it.text() == field.shown);
        Some(same.unwrap_or_else(|| TextField::new(&field.shown, most)))
    }

    /// Whether the selected field is a text, into which letters are typed.
    pub(crate) fn is_at_text(&self, form: &impl FormFields) -> bool {
        self.line(form).is_some()
    }

    /// Handles a key that edits the selected text field; returns whether the key was used. A
    /// question mark is never used, because it opens the help.
    pub(crate) fn typed(&mut self, key: Key, form: &mut impl FormFields) -> bool {
        let line = self.line(form).filter(|_| key != Key::Char('?'));
        line.is_some_and(|mut line| line.update(key) && self.put(line, form))
    }

    /// Inserts pasted text into the selected text field; returns whether a text field is selected.
    pub(crate) fn paste(&mut self, pasted: &str, form: &mut impl FormFields) -> bool {
        self.line(form).is_some_and(|mut line| {
            line.paste(pasted.trim());
            self.put(line, form)
        })
    }

    fn put(&mut self, line: TextField, form: &mut impl FormFields) -> bool {
        form.set_text(self.selected(form.fields().len()), line.text());
        self.line = Some(line);
        true
    }

    /// Whether a number is being typed.
    pub(crate) fn is_typing(&self) -> bool {
        self.entry.is_open()
    }

    /// Discards the number that is being typed.
    pub(crate) fn give_up(&mut self) {
        self.entry.take();
    }

    /// The keys of the form.
    pub(crate) fn keys(&self, form: &impl FormFields) -> KeyTable<FormAction> {
        use FormAction::{Big, Choose, End, Fine, Next, Step};
        let many = form.fields().len() > 1;
        let text = self.is_at_text(form);
        let free = self.chosen(form).filter(|field| field.locked.is_none());
        let number = free.is_some_and(|it| matches!(it.value, FieldValue::Number { .. }));
        let entry = match number {
            true => self.entry.keys(),
            false => KeyTable::new("form"),
        };
        KeyTable::new("form")
            .on(Key::Enter, Next, "next")
            .when(text)
            .by([Key::Up, Key::Down], Choose, [-1, 1], "choose")
            .or([(Key::BackTab, Choose(-1)), (Key::Tab, Choose(1))])
            .when(many)
            .by([Key::Left, Key::Right], Step, [-1, 1], "change")
            .or((!number).then_some((' ', Step(1))))
            .when(!text)
            .by([',', '.'], Fine, [-1, 1], "")
            .when(number && !self.is_typing())
            .with(entry, FormAction::Number)
            .by(['<', '>'], Big, [-1, 1], "")
            .or([(Key::PageDown, Big(-1)), (Key::PageUp, Big(1))])
            .when(number)
            .by([Key::Home, Key::End], End, [-1, 1], "")
            .when(many && !text)
    }

    /// Carries out an action.
    pub(crate) fn act(&mut self, action: FormAction, form: &mut impl FormFields) {
        self.held = false;
        match action {
            FormAction::Choose(by) => self.go(by, form),
            FormAction::Next => self.go(1, form),
            FormAction::End(by) => self.go(by.saturating_mul(isize::MAX), form),
            FormAction::Step(by) => self.step(f64::from(by), form),
            FormAction::Fine(by) => self.step(FINE * f64::from(by), form),
            FormAction::Big(by) => self.step(BIG * f64::from(by), form),
            FormAction::Number(action) => {
                if let Outcome::Done(number) = self.entry.act(action) {
                    self.set(number, form);
                }
            }
            FormAction::Point(at) => self.point(at, form),
        }
    }

    /// Accepts a number that was typed but not confirmed with Enter.
    pub(crate) fn commit(&mut self, form: &mut impl FormFields) {
        if let Some(number) = self.entry.take() {
            self.set(number, form);
        }
    }

    /// Changes the selected field by `steps` steps, backwards if negative.
    pub(crate) fn step(&mut self, steps: f64, form: &mut impl FormFields) {
        self.step_at(self.at, steps, form);
    }

    /// Changes the field at the index `at` by `steps` steps, without selecting it.
    pub(crate) fn step_at(&mut self, at: usize, steps: f64, form: &mut impl FormFields) {
        self.commit(form);
        let fields = form.fields();
        let at = at.min(fields.len().saturating_sub(1));
        if let Some(field) = fields.get(at).filter(|field| field.locked.is_none()) {
            form.set(at, field.value.stepped(steps));
        }
    }

    /// Selects a field; if it is a choice, also switches to its next value.
    fn point(&mut self, at: usize, form: &mut impl FormFields) {
        self.select(at, form);
        let field = self.chosen(form);
        if field.is_some_and(|it| matches!(it.value, FieldValue::Choice { .. })) {
            self.step(1.0, form);
        }
    }

    fn go(&mut self, by: isize, form: &mut impl FormFields) {
        let count = form.fields().len();
        let to = self.selected(count).saturating_add_signed(by);
        self.select(to.min(count.saturating_sub(1)), form);
    }

    fn set(&mut self, number: f64, form: &mut impl FormFields) {
        if let Some(field) = self.chosen(form)
            && field.locked.is_none()
            && let FieldValue::Number { range, .. } = field.value
        {
            self.held = !(range.0..=range.1).contains(&number);
            form.set(self.selected(form.fields().len()), number);
        }
    }

    /// Writes all fields, one per row.
    pub(crate) fn write(&self, form: &impl FormFields, panel: &mut Panel<FormAction>) {
        let fields = form.fields();
        let selected = self.selected(fields.len());
        for (i, field) in fields.into_iter().enumerate() {
            let is_selected = i == selected;
            let action = Some(FormAction::Point(i));
            if let FieldValue::Text(_) = field.value {
                let line = self.line(form).filter(|_| is_selected);
                let typed = line.as_ref().map(TextField::around_cursor);
                let typed = typed.unwrap_or((&field.shown, ""));
                panel.text_field(format!("{} ", field.name), typed, is_selected, action);
            } else {
                let typed = self.entry.shown().filter(|_| is_selected);
                let shown = typed.unwrap_or(field.shown);
                let marked = (Role::Dim, is_selected);
                panel.field(field.name, (shown, field.locked.is_some()), marked, action);
            }
        }
    }

    /// Writes a line about the selected field: why it cannot be changed, its range if a number was
    /// clamped, or its description.
    pub(crate) fn write_about<A>(&self, form: &impl FormFields, panel: &mut Panel<A>) {
        let Some(field) = self.chosen(form) else {
            return;
        };
        match (field.locked, field.value) {
            (Some(why), _) => panel.paragraph(why, Role::Warn),
            (None, FieldValue::Number { range, unit, .. }) if self.held => {
                let (least, most) = range;
                panel.paragraph(format!("from {least} to {most}{unit}"), Role::Warn);
            }
            _ => panel.paragraph(field.about, Role::Text),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Hit {
        offset_mm: f64,
        stick: bool,
    }

    impl FormFields for Hit {
        fn fields(&self) -> Vec<Field> {
            vec![
                Field {
                    name: "offset".into(),
                    shown: format!("{:.1} mm", self.offset_mm),
                    value: FieldValue::Number {
                        value: self.offset_mm,
                        range: (-40.0, 40.0),
                        step: 0.5,
                        unit: " mm",
                    },
                    about: "how far off-centre".into(),
                    locked: None,
                },
                Field {
                    name: "contact".into(),
                    shown: if self.stick { "stick" } else { "slip" }.into(),
                    value: FieldValue::Choice {
                        at: self.stick.into(),
                        count: 2,
                    },
                    about: "do they stick?".into(),
                    locked: None,
                },
            ]
        }

        fn set(&mut self, at: usize, value: f64) {
            match at {
                0 => self.offset_mm = value.clamp(-40.0, 40.0),
                _ => self.stick = value > 0.5,
            }
        }
    }

    fn press(form: &mut SettingsForm, hit: &mut Hit, keys: &[Key]) {
        for key in keys {
            if let Some(action) = form.keys(hit).find(*key) {
                form.act(action, hit);
            }
        }
    }

    #[test]
    fn steps_end_on_the_grid() {
        let mut hit = Hit {
            offset_mm: 7.3,
            stick: false,
        };
        let mut form = SettingsForm::default();
        for (key, value) in [
            (Key::Right, 7.5),
            (Key::Left, 7.0),
            (Key::Char('.'), 7.05),
            (Key::Char(','), 7.0),
            (Key::Char('>'), 12.0),
            (Key::PageDown, 7.0),
        ] {
            press(&mut form, &mut hit, &[key]);
            assert_eq!(hit.offset_mm, value, "{key}");
        }
    }

    #[test]
    fn a_number_typed_for_the_selected_field_is_clamped_to_its_range() {
        let mut hit = Hit {
            offset_mm: 0.0,
            stick: false,
        };
        let mut form = SettingsForm::default();
        press(&mut form, &mut hit, &[Key::Char('9'), Key::Char('9')]);
        assert_eq!(hit.offset_mm, 0.0);
        press(&mut form, &mut hit, &[Key::Enter]);
        assert!(form.held && hit.offset_mm == 40.0);
        press(
            &mut form,
            &mut hit,
            &[Key::Char('5'), Key::Down, Key::Right],
        );
        assert!(!form.held && hit.offset_mm == 5.0 && hit.stick);
        press(&mut form, &mut hit, &[Key::Left, Key::Left, Key::Char('4')]);
        assert!(hit.stick && !form.is_typing());
    }
}

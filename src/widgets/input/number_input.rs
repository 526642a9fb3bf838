//! Entering a number by typing it or with the arrow keys.

use strum::{EnumMessage, IntoStaticStr};

use super::{EntryAction, KeyTable, NumberEntry, Outcome};
use crate::messages::Key;
use crate::numbers::{short, true_minus, with_unit};
use crate::quiz::Measure;
use crate::widgets::{Role, panel::Panel};

/// A number being entered.
#[derive(Debug, Clone, PartialEq)]
pub struct NumberInput {
    quantity: Measure,
    /// The range in which a number is accepted.
    range: (f64, f64),
    value: Option<f64>,
    entry: NumberEntry,
    /// Whether the latest action entered a number that is out of range.
    refused: bool,
}

/// What the keys do while a number is being entered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum NumberAction {
    /// change the number: Left and Right in small steps, Up and Down in big steps
    Dial(i8),
    /// enter the number
    Enter,
    /// type a number
    Number(EntryAction),
}

impl NumberInput {
    /// Creates an input that contains no number yet.
    pub(crate) fn new(quantity: Measure) -> Self {
        let (least, most) = (quantity.smallest(), quantity.largest());
        Self::within(quantity, least, most)
    }

    /// Creates an input that contains no number yet, and accepts only numbers from `least` to
    /// `most`.
    pub(crate) fn within(quantity: Measure, least: f64, most: f64) -> Self {
        Self {
            quantity,
            range: (least, most),
            value: None,
            entry: NumberEntry::default(),
            refused: false,
        }
    }

    /// The number, if one has been given.
    pub(crate) fn value(&self) -> Option<f64> {
        self.value
    }

    /// Sets the number, clamped to the range.
    pub(crate) fn set(&mut self, value: f64) {
        // Adding 0 turns −0 into 0.
        self.value = Some(value.clamp(self.range.0, self.range.1) + 0.0);
    }

    /// The keys for entering the number.
    pub(crate) fn keys(&self) -> KeyTable<NumberAction> {
        use NumberAction::{Dial, Enter};
        let keys = KeyTable::new("dial").with(self.entry.keys(), NumberAction::Number);
        match steps(&self.quantity) {
            Some((_, large)) => keys
                .by(Key::ARROWS, Dial, [large, -large, -1, 1], "dial")
                .on(Key::Enter, Enter, "next"),
            None => keys,
        }
    }

    /// Carries out an action; Enter returns `Done` once there is a number. A typed number outside
    /// the range is refused.
    pub(crate) fn act(&mut self, action: NumberAction) -> Outcome {
        self.refused = false;
        match action {
            NumberAction::Dial(by) => {
                if let Some((small, _)) = steps(&self.quantity) {
                    self.step(small * f64::from(by));
                }
            }
            NumberAction::Enter if self.value.is_some() => return Outcome::Done(()),
            NumberAction::Enter => {}
            NumberAction::Number(action) => match self.entry.act(action) {
                Outcome::Done(value) if self.holds(value) => {
                    self.set(value);
                    return Outcome::Done(());
                }
                Outcome::Done(_) => {
                    self.value = None;
                    self.refused = true;
                }
                _ => match self.entry.value() {
                    Some(value) if self.holds(value) => self.set(value),
                    Some(_) => self.value = None,
                    // A quantity without steps cannot be set with the arrow keys, so a number must
                    // be typed.
                    None if steps(&self.quantity).is_none() => self.value = None,
                    None => {}
                },
            },
        }
        Outcome::Used
    }

    /// The number as text: the text typed so far, or the current value.
    pub(crate) fn shown(&self) -> String {
        let unit = self.quantity.unit();
        let number = self.value.map_or("_".into(), |value| short(value, 3));
        with_unit(&self.entry.shown().unwrap_or(number), unit)
    }

    fn holds(&self, value: f64) -> bool {
        (self.range.0..=self.range.1).contains(&value)
    }

    /// Writes the number; if a number out of range has just been entered, also writes the range.
    pub(crate) fn write<A>(&self, name: &str, panel: &mut Panel<A>) {
        let name = match &self.quantity {
            Measure::Own { sign, .. } => format!("{sign} ="),
            _ => name.into(),
        };
        panel.field(name, (self.shown(), false), (Role::Text, true), None);
        if self.refused {
            let [least, most] = [self.range.0, self.range.1]
                .map(|end| with_unit(&true_minus(&short(end, 3)), self.quantity.unit()));
            let range = format!("Please give a number from {least} to {most}.");
            panel.paragraph(range, Role::Warn);
        }
    }

    /// The action that enters the current number.
    pub(crate) fn enter(&self) -> NumberAction {
        match self.entry.is_open() {
            true => NumberAction::Number(EntryAction::Enter),
            false => NumberAction::Enter,
        }
    }

    /// A sentence on how to enter the number.
    pub(crate) fn about(&self) -> String {
        match self.quantity.unit() {
            "" => "Type a number.".into(),
            "times" => "Type the factor.".into(),
            unit => format!("Type a number in {unit}."),
        }
    }

    fn step(&mut self, by: f64) {
        self.entry.take();
        // Rounding keeps sums of hundredths at whole hundredths.
        let stepped = self.value.unwrap_or(0.0) + by;
        self.set((stepped * 100.0).round() / 100.0);
    }
}

/// The size of a small step, and the number of small steps in a large one; `None` if the number can
/// only be typed.
const fn steps(quantity: &Measure) -> Option<(f64, i8)> {
    match quantity {
        Measure::Angle | Measure::Share => Some((1.0, 5)),
        Measure::Speed | Measure::Restitution => Some((0.05, 10)),
        Measure::Mass | Measure::Length | Measure::Times => Some((0.5, 10)),
        Measure::Own { .. } => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(number: &mut NumberInput, keys: &[Key]) -> Outcome {
        let press = |last, key: &Key| match number.keys().find(*key) {
            Some(action) => number.act(action),
            None => last,
        };
        keys.iter().fold(Outcome::Ignored, press)
    }

    #[test]
    fn enter_does_nothing_before_there_is_a_number() {
        let mut number = NumberInput::new(Measure::Speed);
        assert_eq!(press(&mut number, &[Key::Enter]), Outcome::Used);
        assert_eq!(number.value(), None);
        let typed = [Key::Char('2'), Key::Char('.'), Key::Char('1')];
        press(&mut number, &typed);
        assert_eq!(number.shown(), "2.1_ m/s");
        assert_eq!(press(&mut number, &[Key::Enter]), Outcome::Done(()));
        assert_eq!(number.value(), Some(2.1));
    }

    #[test]
    fn a_typed_number_outside_the_bounds_is_refused_and_asked_for_again() {
        let mut number = NumberInput::new(Measure::Share);
        let typed = ['1', '2', '0'].map(Key::Char);
        press(&mut number, &typed);
        assert_eq!(press(&mut number, &[Key::Enter]), Outcome::Used);
        assert_eq!((number.value(), number.refused), (None, true));
        press(&mut number, &[Key::Char('5')]);
        assert_eq!((number.value(), number.refused), (Some(5.0), false));
        assert_eq!(press(&mut number, &[Key::Enter]), Outcome::Done(()));
    }

    #[test]
    fn the_number_stays_within_its_bounds_when_dialled() {
        let mut number = NumberInput::new(Measure::Share);
        press(&mut number, &[Key::Up, Key::Up, Key::Right, Key::Left]);
        assert_eq!(number.shown(), "10 %");
        press(&mut number, &[Key::Down; 9]);
        assert_eq!(number.value(), Some(0.0));
        press(&mut number, &[Key::Up; 30]);
        assert_eq!(number.value(), Some(100.0));
    }
}

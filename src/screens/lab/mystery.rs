//! The mystery coin: its mass is hidden, and the student finds it from two angles.

use crate::messages::Key;
use crate::physics::resting_target::mass_ratio_from_angles;
use crate::physics::{Bond, CollisionSpec, Rims};
use crate::widgets::Role;
use crate::widgets::input::{CollisionField, EntryAction, KeyTable, NumberEntry, Outcome};
use crate::widgets::panel::Panel;

/// The smallest mass of a mystery coin in g, the step to the next mass in g, and the number of
/// masses.
const LIGHTEST_G: f64 = 4.0;
const STEP_G: f64 = 0.5;
const COINS: u64 = 60;
/// The tolerance of an answer, as a fraction of the mass.
const NEAR: f64 = 0.05;

/// A coin whose mass is hidden until it has been weighed.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Mystery {
    entry: NumberEntry,
    said_g: Option<f64>,
}

impl Mystery {
    /// Sets up a smooth coin at rest, without energy loss. Its mass follows from `seed` and is
    /// never the striker's.
    pub(super) fn put_out(setup: &mut CollisionSpec, seed: u64) -> Self {
        let mass = LIGHTEST_G + STEP_G * (seed % COINS) as f64;
        let same = (mass - setup.m1_g).abs() < STEP_G / 2.0;
        setup.m2_g = if same { mass + STEP_G } else { mass };
        setup.restitution = 1.0;
        setup.bond = Bond::Slip;
        setup.target_speed = 0.0;
        setup.rims = Rims::default();
        Self::default()
    }

    /// Whether the player has not entered a mass yet.
    pub(super) fn is_open(&self) -> bool {
        self.said_g.is_none()
    }

    /// The settings that cannot be changed until the coin has been weighed.
    pub(super) const LOCKED: [CollisionField; 5] = [
        CollisionField::CoinMass,
        CollisionField::Restitution,
        CollisionField::Contact,
        CollisionField::CoinSpeed,
        CollisionField::RimFriction,
    ];

    /// The keys that enter the mass while the collision is watched. A number can only begin with a
    /// digit, because the keys for a sign and a point have other meanings there.
    pub(super) fn keys(&self) -> KeyTable<EntryAction> {
        let table = KeyTable::new("mystery");
        match (self.is_open(), self.entry.is_open()) {
            (false, _) => table,
            (true, true) => table.with(self.entry.keys(), |action| action),
            (true, false) => {
                let digit = |c| (Key::Char(c), EntryAction::Type(c));
                table.each(('0'..='9').map(digit), "the mass")
            }
        }
    }

    pub(super) fn act(&mut self, action: EntryAction) {
        if let Outcome::Done(mass) = self.entry.act(action)
            && mass > 0.0
        {
            self.said_g = Some(mass);
        }
    }

    /// The instruction, or the result of the answer.
    pub(super) fn write(&self, setup: &CollisionSpec, panel: &mut Panel<EntryAction>) {
        let outcome = setup.collision().outcome();
        let (Some(theta1), Some(theta2)) = (outcome.theta1, outcome.theta2) else {
            let text = "You need two angles to weigh the coin: hit it off-centre.";
            return panel.paragraph(text, Role::Text);
        };
        let Some(ratio) = mass_ratio_from_angles(theta1, theta2, setup.restitution) else {
            let text =
                "These angles do not give a mass: try an offset between head-on and a graze.";
            return panel.paragraph(text, Role::Text);
        };
        match self.said_g {
            None => {
                panel.heading("How heavy is the coin?");
                let text = "m₁/m₂ = sin(θ₁ + 2θ₂) / sin θ₁. If the paths are more than 90° apart, the \
                            coin is heavier than the striker; if less, lighter.";
                panel.paragraph(text, Role::Text);
                panel.gap();
                let typed = format!("{}_ g", self.entry.text());
                panel.field("mass", (typed, false), (Role::Text, true), None);
                match self.entry.is_open() {
                    true => panel.prompt("weigh it", EntryAction::Enter),
                    false => panel.paragraph("Type the mass in grams.", Role::Key),
                }
            }
            Some(said) => {
                let off = (said - setup.m2_g).abs() / setup.m2_g;
                let well = off <= NEAR;
                panel.heading(if well { "well weighed" } else { "not quite" });
                panel.coloured_fact("you said", format!("{said:.1} g"), Role::Predicted);
                panel.coloured_fact("it is", format!("{:.1} g", setup.m2_g), Role::CoinOut);
                let text = format!(
                    "The angles give m₁/m₂ = {ratio:.3}, and {:.1} g / {ratio:.3} = {:.1} g. \
                     No scale was needed, and the speed did not matter.",
                    setup.m1_g, setup.m2_g
                );
                panel.paragraph(text, Role::Text);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_mystery_coin_differs_from_the_striker_and_can_be_weighed() {
        for seed in 0..200 {
            let mut setup = CollisionSpec::default();
            let mystery = Mystery::put_out(&mut setup, seed);
            assert!(mystery.is_open());
            assert!((setup.m2_g - setup.m1_g).abs() > 0.4);
            let outcome = setup.collision().outcome();
            let (theta1, theta2) = (outcome.theta1.unwrap(), outcome.theta2.unwrap());
            let ratio = mass_ratio_from_angles(theta1, theta2, 1.0).unwrap();
            assert!((setup.m1_g / ratio - setup.m2_g).abs() < 1e-9);
        }
    }

    #[test]
    fn a_typed_mass_is_an_answer_and_unlocks_the_settings() {
        let mut mystery = Mystery::default();
        assert_eq!(mystery.keys().find(Key::Char(',')), None);
        assert_eq!(mystery.keys().find(Key::Enter), None);
        for key in [Key::Char('8'), Key::Char('.'), Key::Char('5'), Key::Enter] {
            let action = mystery.keys().find(key).unwrap();
            mystery.act(action);
        }
        assert_eq!(mystery.said_g, Some(8.5));
        assert!(!mystery.is_open());
    }
}

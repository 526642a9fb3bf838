//! The settings of the lab.

use super::mystery::Mystery;
use crate::physics::{Bond, CollisionSpec};
use crate::widgets::input::{CollisionField, Field, FormFields, collision_fields, set_at};

#[derive(Debug, Clone, Default)]
pub(crate) struct LabSettings {
    pub(super) setup: CollisionSpec,
    /// The mystery coin, whose mass is hidden until it has been weighed.
    pub(super) mystery: Option<Mystery>,
}

impl LabSettings {
    /// A setting with its value and, if it cannot be changed, the reason.
    pub(super) fn field(&self, field: CollisionField) -> Field {
        self.fields().swap_remove(field as usize)
    }

    /// Whether the coin's mass must be hidden.
    pub(super) fn hides_mass(&self) -> bool {
        self.mystery.as_ref().is_some_and(Mystery::is_open)
    }
}

impl FormFields for LabSettings {
    fn fields(&self) -> Vec<Field> {
        let mut fields = collision_fields(&self.setup);
        if self.setup.bond == Bond::Stick {
            let restitution = &mut fields[CollisionField::Restitution as usize];
            restitution.locked = Some("Discs that stick do not rebound, whatever e is.");
            for field in fields.iter_mut().skip(CollisionField::RimFriction as usize) {
                field.locked = Some("Discs that stick do not slip: set the contact to slip.");
            }
        }
        if self.hides_mass() {
            fields[CollisionField::CoinMass as usize].shown = "? g".into();
            for field in Mystery::LOCKED {
                fields[field as usize].locked = Some("A mystery coin: weigh it first.");
            }
        }
        fields
    }

    /// A weighed mystery coin becomes an ordinary coin once its mass is changed.
    fn set(&mut self, at: usize, value: f64) {
        let before = self.setup.m2_g;
        set_at(at, &mut self.setup, value);
        if self.setup.m2_g.to_bits() != before.to_bits() {
            self.mystery = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sticking_discs_have_no_restitution_to_set() {
        let mut settings = LabSettings::default();
        assert_eq!(settings.field(CollisionField::Restitution).locked, None);
        settings.set(CollisionField::Contact as usize, 1.0);
        let locked = settings.field(CollisionField::Restitution).locked;
        assert!(locked.is_some_and(|why| why.contains("stick")));
        let locked = settings.field(CollisionField::RimFriction).locked;
        assert!(locked.is_some_and(|why| why.contains("slip")));
        assert_eq!(settings.field(CollisionField::CoinMass).locked, None);
    }

    #[test]
    fn spins_can_be_set_once_the_rims_have_friction() {
        let mut settings = LabSettings::default();
        let spin = CollisionField::StrikerSpin as usize;
        assert_eq!(settings.fields().len(), spin);
        settings.set(CollisionField::RimFriction as usize, 0.2);
        settings.set(spin, -30.0);
        settings.set(spin + 1, 12.5);
        assert_eq!(settings.fields().len(), spin + 2);
        let rims = settings.setup.collision().rims;
        assert_eq!((rims.friction, rims.spins), (0.2, [-30.0, 12.5]));
        // A spin stays visible, so that it can be set to 0.
        settings.set(CollisionField::RimFriction as usize, 0.0);
        assert_eq!(settings.fields().len(), spin + 2);
    }
}

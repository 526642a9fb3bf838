//! What can be set: one place for a setting's name, unit, range and step.

use super::FoilPage;
use super::setup::{FoilSetup, Obstacle};
use crate::beams::{CountedFor, METALS};
use crate::numbers::fixed;
use crate::physics::beam::Beam;
use crate::widgets::input::{Field, FieldValue, FormFields};

/// Powers of ten of the particles in a beam.
const EXPONENTS: (u32, u32) = (3, 9);

/// The settings of a page.
#[derive(Debug, Clone, Copy)]
pub(super) struct FoilFields {
    pub(super) page: FoilPage,
    pub(super) setup: FoilSetup,
}

impl FoilFields {
    /// Those that mean something on the page, in the order of its panel.
    pub(super) fn all(&self) -> &'static [FoilField] {
        let page: &[FoilField] = match (self.page, self.setup.obstacle) {
            (FoilPage::Tracks, Obstacle::Hard) => &[F::Obstacle, F::Offset],
            (FoilPage::Tracks, Obstacle::Nucleus) => &[F::Obstacle, F::Metal, F::Energy, F::Offset],
            (FoilPage::Counts, Obstacle::Hard) => {
                &[F::Obstacle, F::Beam, F::Particles, F::CountedFor]
            }
            (FoilPage::Counts, Obstacle::Nucleus) => &[
                F::Obstacle,
                F::Beam,
                F::Metal,
                F::Energy,
                F::Thickness,
                F::Particles,
                F::CountedFor,
            ],
            (FoilPage::Measured, _) => &[],
        };
        match page {
            // On a board there is only one way to count.
            [others @ .., F::CountedFor] if self.setup.counted_for().is_none() => others,
            all => all,
        }
    }
}

impl FormFields for FoilFields {
    fn fields(&self) -> Vec<Field> {
        let field = |field: &FoilField| field.field(&self.setup);
        self.all().iter().map(field).collect()
    }

    fn set(&mut self, at: usize, value: f64) {
        if let Some(field) = self.all().get(at) {
            field.set(&mut self.setup, value);
        }
    }
}

/// One setting of the foil.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FoilField {
    /// What stands in the way.
    Obstacle,
    /// Plane or space.
    Beam,
    /// Metal, and with it Z.
    Metal,
    /// Energy of the α particles.
    Energy,
    /// Thickness of the foil.
    Thickness,
    /// Impact parameter of one particle.
    Offset,
    /// Particles in a beam.
    Particles,
    /// What they are counted for.
    CountedFor,
}

use FoilField as F;

impl FoilField {
    /// Its name on the panel, and what it is.
    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Obstacle => ("target", "what stands in the way"),
            Self::Beam => ("beam", "spread evenly over a line or a disc"),
            Self::Metal => ("metal", "what the foil is made of"),
            Self::Energy => ("energy", "of the α particles"),
            Self::Thickness => ("foil", "how thick the foil is"),
            Self::Offset => ("offset b", "how far off-centre it flies"),
            Self::Particles => ("particles", "how many in a beam"),
            Self::CountedFor => ("counts", "on a small screen or in rings of 5°"),
        }
    }

    /// Its value, and what it may be.
    fn value(self, setup: &FoilSetup) -> FieldValue {
        let choice = |at, count| FieldValue::Choice { at, count };
        let number = |value, range, step, unit| FieldValue::Number {
            value,
            range,
            step,
            unit,
        };
        let (least, most) = EXPONENTS;
        match (self, setup.obstacle) {
            (Self::Obstacle, obstacle) => choice(usize::from(obstacle == Obstacle::Nucleus), 2),
            (Self::Beam, _) => choice(usize::from(setup.beam == Beam::Space), 2),
            (Self::Metal, _) => choice(setup.metal, METALS.len()),
            // Slower α particles than this hardly pass a foil.
            (Self::Energy, _) => number(setup.energy_mev, (4.0, 10.0), 0.25, " MeV"),
            (Self::Thickness, _) => number(setup.thickness_um, (0.05, 2.0), 0.05, " µm"),
            (Self::Offset, Obstacle::Hard) => number(setup.offset_share, (-1.5, 1.5), 0.05, " R"),
            (Self::Offset, Obstacle::Nucleus) => number(setup.offset_fm, (-60.0, 60.0), 1.0, " fm"),
            (Self::CountedFor, _) => choice(usize::from(setup.counted_for == CountedFor::Ring), 2),
            (Self::Particles, _) => {
                let at = setup.particles_exponent.saturating_sub(least);
                choice(at as usize, (most - least + 1) as usize)
            }
        }
    }

    /// The setting as it stands.
    pub(crate) fn field(self, setup: &FoilSetup) -> Field {
        let (name, about) = self.words();
        Field::new(name, self.shown(setup), self.value(setup), about)
    }

    /// Its value with its unit, as shown.
    fn shown(self, setup: &FoilSetup) -> String {
        match (self, setup.obstacle, setup.beam) {
            (Self::Obstacle, Obstacle::Hard, _) => "hard".into(),
            (Self::Obstacle, Obstacle::Nucleus, _) => "nucleus".into(),
            (Self::Beam, _, Beam::Board) => "in a plane".into(),
            (Self::Beam, _, Beam::Space) => "in space".into(),
            (Self::Metal, ..) => {
                let metal = setup.metal();
                format!("{}, Z {}", metal.name, metal.charge)
            }
            (Self::Energy, ..) => format!("{:.2} MeV", setup.energy_mev),
            (Self::Thickness, ..) => format!("{:.2} µm", setup.thickness_um),
            (Self::Offset, Obstacle::Hard, _) => fixed(setup.offset_share, 2) + " R",
            (Self::Offset, Obstacle::Nucleus, _) => fixed(setup.offset_fm, 1) + " fm",
            (Self::Particles, ..) => super::words::count(setup.particles()),
            (Self::CountedFor, ..) => Self::shown_counts(setup.counted_for).into(),
        }
    }

    /// What particles are counted for, as shown.
    pub(super) const fn shown_counts(counted_for: CountedFor) -> &'static str {
        match counted_for {
            CountedFor::Steradian => "small screen",
            CountedFor::Ring => "whole rings",
        }
    }

    /// Sets it, held to its range, a choice by its place.
    pub(crate) fn set(self, setup: &mut FoilSetup, value: f64) {
        let (low, high) = match self.value(setup) {
            FieldValue::Number { range, .. } => range,
            FieldValue::Choice { count, .. } => (0.0, count as f64 - 1.0),
        };
        // Adding 0 makes a plain 0 of -0.
        let value = value.clamp(low, high) + 0.0;
        let second = usize::from(value > 0.5);
        match (self, setup.obstacle) {
            (Self::Obstacle, _) => setup.obstacle = [Obstacle::Hard, Obstacle::Nucleus][second],
            (Self::Beam, _) => setup.beam = [Beam::Board, Beam::Space][second],
            (Self::Metal, _) => setup.metal = value as usize,
            (Self::Energy, _) => setup.energy_mev = value,
            (Self::Thickness, _) => setup.thickness_um = value,
            (Self::Offset, Obstacle::Hard) => setup.offset_share = value,
            (Self::Offset, Obstacle::Nucleus) => setup.offset_fm = value,
            (Self::Particles, _) => setup.particles_exponent = EXPONENTS.0 + value as u32,
            (Self::CountedFor, _) => {
                setup.counted_for = [CountedFor::Steradian, CountedFor::Ring][second];
            }
        }
    }

    /// Its value `steps` steps further and on the grid of steps; choices go round.
    pub(crate) fn stepped(self, setup: &FoilSetup, steps: f64) -> f64 {
        self.value(setup).stepped(steps)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [FoilField; 8] = [
        F::Obstacle,
        F::Beam,
        F::Metal,
        F::Energy,
        F::Thickness,
        F::Offset,
        F::Particles,
        F::CountedFor,
    ];

    fn step(field: FoilField, setup: &mut FoilSetup, steps: f64) {
        field.set(setup, field.stepped(setup, steps));
    }

    fn is_within(value: FieldValue) -> bool {
        match value {
            FieldValue::Choice { at, count } => at < count,
            FieldValue::Number { value, range, .. } => (range.0..=range.1).contains(&value),
        }
    }

    #[test]
    fn every_setting_stays_in_its_range() {
        for field in ALL {
            for wild in [-1e9, -0.0, 0.0, 0.7, 1e9] {
                let mut setup = FoilSetup::default();
                field.set(&mut setup, wild);
                assert!(is_within(field.value(&setup)), "{field:?}");
                step(field, &mut setup, 10.0);
                step(field, &mut setup, -1.0);
                assert!(is_within(field.value(&setup)), "{field:?}");
            }
        }
    }

    #[test]
    fn choices_go_round_and_numbers_land_on_the_grid() {
        let mut setup = FoilSetup::default();
        for _ in 0..METALS.len() {
            step(F::Metal, &mut setup, 1.0);
        }
        assert_eq!(setup, FoilSetup::default());
        step(F::Energy, &mut setup, 1.0);
        assert_eq!(setup.energy_mev, 7.75);
        step(F::Particles, &mut setup, 1.0);
        assert_eq!(setup.particles(), 10_000_000);
    }
}

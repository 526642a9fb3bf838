//! What can be set: one place for a setting's name, unit, range and step.

use super::Page;
use super::setup::{Obstacle, Setup};
use crate::beams::METALS;
use crate::physics::beam::Beam;

/// One setting of the foil.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Field {
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
}

use Field as F;

impl Field {
    /// The settings that mean something on a page, in the order of its panel.
    pub(crate) fn on(page: Page, setup: &Setup) -> &'static [Self] {
        match (page, setup.obstacle) {
            (Page::Tracks, Obstacle::Hard) => &[F::Obstacle, F::Offset],
            (Page::Tracks, Obstacle::Nucleus) => &[F::Obstacle, F::Metal, F::Energy, F::Offset],
            (Page::Counts, Obstacle::Hard) => &[F::Obstacle, F::Beam, F::Particles],
            (Page::Counts, Obstacle::Nucleus) => &[
                F::Obstacle,
                F::Beam,
                F::Metal,
                F::Energy,
                F::Thickness,
                F::Particles,
            ],
            (Page::Measured, _) => &[],
        }
    }

    /// Least value, greatest value and step; choices are numbered from 0.
    fn scale(self, setup: &Setup) -> (f64, f64, f64) {
        match self {
            Self::Obstacle | Self::Beam => (0.0, 1.0, 1.0),
            Self::Metal => (0.0, METALS.len() as f64 - 1.0, 1.0),
            // Slower α particles than this hardly pass a foil.
            Self::Energy => (4.0, 10.0, 0.25),
            Self::Thickness => (0.05, 2.0, 0.05),
            Self::Offset => match setup.obstacle {
                Obstacle::Hard => (-1.5, 1.5, 0.05),
                Obstacle::Nucleus => (-60.0, 60.0, 1.0),
            },
            Self::Particles => (3.0, 9.0, 1.0),
        }
    }

    /// Its name on the panel.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Obstacle => "target",
            Self::Beam => "beam",
            Self::Metal => "metal",
            Self::Energy => "energy",
            Self::Thickness => "foil",
            Self::Offset => "offset b",
            Self::Particles => "particles",
        }
    }

    /// Whether a number can be typed for it.
    pub(crate) fn is_number(self) -> bool {
        matches!(self, Self::Energy | Self::Thickness | Self::Offset)
    }

    /// Whether a number is in its range.
    pub(crate) fn allows(self, setup: &Setup, value: f64) -> bool {
        let (low, high, _) = self.scale(setup);
        (low..=high).contains(&value)
    }

    /// Its range, as shown.
    pub(crate) fn range(self, setup: &Setup) -> String {
        let (low, high, _) = self.scale(setup);
        let unit = match (self, setup.obstacle) {
            (Self::Energy, _) => " MeV",
            (Self::Thickness, _) => " µm",
            (Self::Offset, Obstacle::Hard) => " R",
            (Self::Offset, Obstacle::Nucleus) => " fm",
            _ => "",
        };
        format!("from {low} to {high}{unit}")
    }

    fn value(self, setup: &Setup) -> f64 {
        match self {
            Self::Obstacle => f64::from(u8::from(setup.obstacle == Obstacle::Nucleus)),
            Self::Beam => f64::from(u8::from(setup.beam == Beam::Space)),
            Self::Metal => setup.metal as f64,
            Self::Energy => setup.energy_mev,
            Self::Thickness => setup.thickness_um,
            Self::Offset => match setup.obstacle {
                Obstacle::Hard => setup.offset_share,
                Obstacle::Nucleus => setup.offset_fm,
            },
            Self::Particles => f64::from(setup.particles_exponent),
        }
    }

    /// Its value with its unit, as shown.
    pub(crate) fn shown(self, setup: &Setup) -> String {
        match self {
            Self::Obstacle => match setup.obstacle {
                Obstacle::Hard => "hard".into(),
                Obstacle::Nucleus => "nucleus".into(),
            },
            Self::Beam => match setup.beam {
                Beam::Board => "in a plane".into(),
                Beam::Space => "in space".into(),
            },
            Self::Metal => {
                let metal = setup.metal();
                format!("{}, Z {}", metal.name, metal.charge)
            }
            Self::Energy => format!("{:.2} MeV", setup.energy_mev),
            Self::Thickness => format!("{:.2} µm", setup.thickness_um),
            Self::Offset => match setup.obstacle {
                Obstacle::Hard => format!("{:.2} R", setup.offset_share),
                Obstacle::Nucleus => format!("{:.1} fm", setup.offset_fm),
            },
            Self::Particles => super::words::count(setup.particles()),
        }
    }

    /// Sets it, held to its range.
    pub(crate) fn set(self, setup: &mut Setup, value: f64) {
        let (low, high, _) = self.scale(setup);
        // Adding 0 makes a plain 0 of -0.
        let value = value.clamp(low, high) + 0.0;
        let second = value > 0.5;
        match self {
            Self::Obstacle => {
                setup.obstacle = [Obstacle::Hard, Obstacle::Nucleus][usize::from(second)];
            }
            Self::Beam => setup.beam = [Beam::Board, Beam::Space][usize::from(second)],
            Self::Metal => setup.metal = value as usize,
            Self::Energy => setup.energy_mev = value,
            Self::Thickness => setup.thickness_um = value,
            Self::Offset => match setup.obstacle {
                Obstacle::Hard => setup.offset_share = value,
                Obstacle::Nucleus => setup.offset_fm = value,
            },
            Self::Particles => setup.particles_exponent = value as u32,
        }
    }

    /// Moves it by `steps` steps and onto the grid of steps; choices go round.
    pub(crate) fn step(self, setup: &mut Setup, steps: f64) {
        let (low, high, size) = self.scale(setup);
        if matches!(self, Self::Obstacle | Self::Beam | Self::Metal) {
            let next = (self.value(setup) + steps.signum()).rem_euclid(high - low + 1.0);
            return self.set(setup, next);
        }
        let value = self.value(setup) / size + steps;
        // Within a thousandth of the grid counts as on it.
        let onto = if steps > 0.0 {
            (value + 1e-3).floor()
        } else {
            (value - 1e-3).ceil()
        };
        self.set(setup, onto * size);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Field; 7] = [
        F::Obstacle,
        F::Beam,
        F::Metal,
        F::Energy,
        F::Thickness,
        F::Offset,
        F::Particles,
    ];

    #[test]
    fn every_setting_stays_in_its_range() {
        for field in ALL {
            for wild in [-1e9, -0.0, 0.0, 0.7, 1e9] {
                let mut setup = Setup::default();
                field.set(&mut setup, wild);
                let (low, high, _) = field.scale(&setup);
                assert!((low..=high).contains(&field.value(&setup)), "{field:?}");
                field.step(&mut setup, 10.0);
                field.step(&mut setup, -1.0);
                assert!((low..=high).contains(&field.value(&setup)), "{field:?}");
            }
        }
    }

    #[test]
    fn choices_go_round_and_numbers_land_on_the_grid() {
        let mut setup = Setup::default();
        for _ in 0..METALS.len() {
            F::Metal.step(&mut setup, 1.0);
        }
        assert_eq!(setup, Setup::default());
        F::Energy.step(&mut setup, 1.0);
        assert_eq!(setup.energy_mev, 7.75);
        F::Particles.step(&mut setup, 1.0);
        assert_eq!(setup.particles(), 10_000_000);
    }
}

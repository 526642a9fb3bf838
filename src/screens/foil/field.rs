//! The settings of the foil, each with its name, unit, range and step.

use super::setup::{FoilSetup, Obstacle};
use super::words::count;
use crate::beams::{CountedFor, METALS};
use crate::physics::beam::Beam;
use crate::screens::route::FoilPage;
use crate::widgets::input::{Field, FieldRow, FieldValue, FormFields};

/// The settings of the foil, and the page that shows them.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct FoilFields {
    pub(super) page: FoilPage,
    pub(super) setup: FoilSetup,
}

type FoilRow = FieldRow<FoilSetup>;

impl FoilFields {
    /// The settings that apply on the page, in the order of its panel.
    pub(super) fn rows(&self) -> Vec<&'static FoilRow> {
        let [one, beam] = [FoilPage::Tracks, FoilPage::Counts].map(|page| page == self.page);
        let is_foil = self.setup.obstacle == Obstacle::Nucleus;
        // On a board there is only one way to count the hits.
        let in_space = self.setup.counted_for().is_some();
        let rows = [
            (&OBSTACLE, one || beam),
            (&BEAM, beam),
            (&METAL, (one || beam) && is_foil),
            (&ENERGY, (one || beam) && is_foil),
            (&THICKNESS, beam && is_foil),
            (&OFFSET, one),
            (&PARTICLES, beam),
            (&COUNTED_FOR, beam && in_space),
        ];
        let rows = rows.into_iter().filter(|(_, applies)| *applies);
        rows.map(|(row, _)| row).collect()
    }
}

impl FormFields for FoilFields {
    fn fields(&self) -> Vec<Field> {
        let rows = self.rows().into_iter();
        rows.map(|row| row.field(&self.setup)).collect()
    }

    fn set(&mut self, at: usize, value: f64) {
        if let Some(row) = self.rows().get(at) {
            row.set(&mut self.setup, value);
        }
    }
}

static OBSTACLE: FoilRow = FoilRow {
    name: "target",
    about: "what the particles hit",
    now: |setup| FieldValue::choice(setup.obstacle as usize, &["hard", "nucleus"]),
    put: |setup, at| setup.obstacle = [Obstacle::Hard, Obstacle::Nucleus][at as usize],
};

static BEAM: FoilRow = FoilRow {
    name: "beam",
    about: "spread evenly over a line or a disc",
    now: |setup| FieldValue::choice(setup.beam as usize, &["in a plane", "in space"]),
    put: |setup, at| setup.beam = [Beam::Board, Beam::Space][at as usize],
};

/// The metal, which also sets Z.
static METAL: FoilRow = FoilRow {
    name: "metal",
    about: "what the foil is made of",
    now: |setup| {
        let (at, count) = (setup.metal, METALS.len());
        let shown = format!("{}, Z {}", setup.metal().name, setup.metal().charge);
        (FieldValue::Choice { at, count }, shown)
    },
    put: |setup, at| setup.metal = at as usize,
};

static ENERGY: FoilRow = FoilRow {
    name: "energy",
    about: "of the α-particles",
    // In a thick foil, slower α-particles would lose much of their energy.
    now: |setup| FieldValue::decimal(setup.energy_mev, (4.0, 10.0), 0.25, (2, " MeV")),
    put: |setup, energy| setup.energy_mev = energy,
};

static THICKNESS: FoilRow = FoilRow {
    name: "foil",
    about: "how thick the foil is",
    now: |setup| FieldValue::decimal(setup.thickness_um, (0.05, 2.0), 0.05, (2, " µm")),
    put: |setup, thickness| setup.thickness_um = thickness,
};

/// Impact parameter of one particle.
pub(super) static OFFSET: FoilRow = FoilRow {
    name: "offset b",
    about: "how far off-centre the particle flies",
    now: |setup| match setup.obstacle {
        Obstacle::Hard => FieldValue::decimal(setup.offset_share, (-1.5, 1.5), 0.05, (2, " R")),
        Obstacle::Nucleus => FieldValue::decimal(setup.offset_fm, (-60.0, 60.0), 1.0, (1, " fm")),
    },
    put: |setup, offset| match setup.obstacle {
        Obstacle::Hard => setup.offset_share = offset,
        Obstacle::Nucleus => setup.offset_fm = offset,
    },
};

/// The smallest and the largest number of particles in a beam, as powers of ten.
const EXPONENTS: [u32; 2] = [3, 9];

static PARTICLES: FoilRow = FoilRow {
    name: "particles",
    about: "how many in a beam",
    now: |setup| {
        let [least, most] = EXPONENTS;
        let at = setup.particles_exponent.saturating_sub(least) as usize;
        let options = (most - least + 1) as usize;
        let value = FieldValue::Choice { at, count: options };
        (value, count(setup.particles()))
    },
    put: |setup, at| setup.particles_exponent = EXPONENTS[0] + at as u32,
};

static COUNTED_FOR: FoilRow = FoilRow {
    name: "counts",
    about: "on a small screen or in rings of 5°",
    now: |setup| {
        let names = [CountedFor::Steradian, CountedFor::Ring].map(shown_counts);
        FieldValue::choice(setup.counted_for as usize, &names)
    },
    put: |setup, at| setup.counted_for = [CountedFor::Steradian, CountedFor::Ring][at as usize],
};

/// The unit of the counts, as shown.
pub(super) const fn shown_counts(counted_for: CountedFor) -> &'static str {
    match counted_for {
        CountedFor::Steradian => "small screen",
        CountedFor::Ring => "whole rings",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [&FoilRow; 8] = [
        &OBSTACLE,
        &BEAM,
        &METAL,
        &ENERGY,
        &THICKNESS,
        &OFFSET,
        &PARTICLES,
        &COUNTED_FOR,
    ];

    fn is_within(value: FieldValue) -> bool {
        match value {
            FieldValue::Choice { at, count } => at < count,
            FieldValue::Number { value, range, .. } => (range.0..=range.1).contains(&value),
            FieldValue::Text(_) => true,
        }
    }

    #[test]
    fn every_setting_stays_in_its_range() {
        for row in ALL {
            for wild in [-1e9, -0.0, 0.0, 0.7, 1e9] {
                let mut setup = FoilSetup::default();
                row.set(&mut setup, wild);
                assert!(is_within((row.now)(&setup).0), "{}", row.name);
                row.step(&mut setup, 10.0);
                row.step(&mut setup, -1.0);
                assert!(is_within((row.now)(&setup).0), "{}", row.name);
            }
        }
    }

    #[test]
    fn choices_wrap_around_and_numbers_are_rounded_to_the_grid() {
        let mut setup = FoilSetup::default();
        for _ in 0..METALS.len() {
            METAL.step(&mut setup, 1.0);
        }
        assert_eq!(setup, FoilSetup::default());
        ENERGY.step(&mut setup, 1.0);
        assert_eq!(setup.energy_mev, 7.75);
        PARTICLES.step(&mut setup, 1.0);
        assert_eq!(setup.particles(), 10_000_000);
    }
}

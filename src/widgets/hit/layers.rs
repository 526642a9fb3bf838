//! The layers drawn on top of a collision, which can be turned on and off.

use strum::VariantArray;

/// One layer of the explanation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, VariantArray)]
pub enum Overlay {
    /// The line of impact n and the tangent t, through the point of contact.
    Lines,
    /// The components of the striker's velocity along n and t.
    Split,
    /// The velocities before and after the collision.
    Velocities,
    /// The arcs of θ₁ and θ₂, and the right-angle mark.
    Angles,
    /// The triangle of momenta.
    Triangle,
    /// The paths of the discs so far.
    Trails,
    /// The player's prediction.
    Prediction,
}

impl Overlay {
    /// All layers, in the order of their keys.
    pub(crate) const ALL: &'static [Self] = Self::VARIANTS;

    /// A short name for what the layer shows.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Lines => "line of impact",
            Self::Split => "components of u",
            Self::Velocities => "velocities",
            Self::Angles => "angles",
            Self::Triangle => "momentum triangle",
            Self::Trails => "trails",
            Self::Prediction => "prediction",
        }
    }
}

/// The set of layers that are switched on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Overlays {
    on: [bool; Overlay::ALL.len()],
}

impl Default for Overlays {
    /// All layers except the components, which would hide the final velocities.
    fn default() -> Self {
        let mut layers = Self {
            on: [true; Overlay::ALL.len()],
        };
        layers.toggle(Overlay::Split);
        layers
    }
}

impl Overlays {
    /// No layers.
    pub(crate) const NONE: Self = Self {
        on: [false; Overlay::ALL.len()],
    };

    pub(crate) fn shows(self, layer: Overlay) -> bool {
        self.on[layer as usize]
    }

    /// This set with the given layers switched off.
    #[must_use]
    pub(crate) fn without<const N: usize>(mut self, layers: [Overlay; N]) -> Self {
        for layer in layers {
            self.on[layer as usize] = false;
        }
        self
    }

    pub(crate) fn toggle(&mut self, layer: Overlay) {
        self.on[layer as usize] ^= true;
    }
}

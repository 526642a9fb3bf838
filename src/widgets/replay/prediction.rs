//! Predicting the directions after an impact, before the shot is watched.

use ratatui::layout::Rect;

use super::ShotImpact;
use crate::messages::{Mouse, MouseKind};
use crate::quiz::Ray;
use crate::widgets::RayInput;
use crate::widgets::hit::{Face, Markings, point_at, setup_picture};
use crate::widgets::panel::Panel;
use crate::widgets::panels::{contact_distance, impact_angle, masses, offset};
use crate::widgets::picture::Picture;

/// An impact, and the prediction of its directions as far as it has been entered.
///
/// The target leaves along the line of impact, so the impact angle is not shown if the player has
/// to predict the target's direction.
#[derive(Debug, Clone)]
pub(crate) struct ImpactPrediction {
    pub impact: ShotImpact,
    pub rays: RayInput,
}

impl ImpactPrediction {
    /// Lets the mouse over the picture turn a ray; returns whether the mouse was used.
    pub(crate) fn point(&mut self, mouse: &Mouse, area: Rect) -> bool {
        let used = mouse.is_held() && area.contains(mouse.cell().into());
        if used {
            let (collision, pressed) = (&self.impact.collision, mouse.kind == MouseKind::Down);
            point_at(area, collision, &mut self.rays, mouse.place(), pressed);
        }
        used
    }

    /// The discs before the collision, with the rays.
    pub(crate) fn picture(&self, faces: [Face; 2], area: Rect) -> Picture {
        let shown = Markings {
            angle: !self.rays.asks(Ray::Target),
            ..Markings::ALL
        };
        setup_picture(area, faces, &self.impact.collision, shown, Some(&self.rays))
    }

    /// Writes the facts of the collision, except `secret` masses.
    pub(crate) fn write_facts<A>(&self, secret: [bool; 2], panel: &mut Panel<A>) {
        let collision = &self.impact.collision;
        offset(collision, panel);
        match self.rays.asks(Ray::Target) {
            true => contact_distance(collision, panel),
            false => impact_angle(collision, panel),
        }
        masses(collision, secret, panel);
    }
}

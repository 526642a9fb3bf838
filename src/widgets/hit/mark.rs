//! The way that a disc is to be sent, with a mark at its end.

use super::labels::Labels;
use super::stage::Stage;
use crate::quiz::{AimTask, Ray};
use crate::widgets::Role;
use crate::widgets::ink::{Pen, Sheet, Side};

/// Where one of the two discs is to be sent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mark {
    /// Which of the two.
    pub ray: Ray,
    /// Its way: θ₁ or θ₂ in radians, with the signs of [`Rays`](crate::quiz::Rays).
    pub angle: f64,
}

impl From<&AimTask> for Mark {
    fn from(aim: &AimTask) -> Self {
        Self {
            ray: aim.ray,
            angle: aim.wanted,
        }
    }
}

impl Mark {
    /// A dashed way from the disc at the contact, and the mark where it leads.
    pub(super) fn draw(&self, sheet: &mut Sheet, labels: &mut Labels, stage: &Stage) {
        let body = usize::from(self.ray == Ray::Target);
        let centre = stage.centres[body];
        let direction = stage.direction(self.ray, self.angle);
        let reach = stage.room(centre, direction).min(2.9 * stage.unit());
        let end = centre + reach * direction;
        let rim = centre + stage.radius(body) * direction;
        sheet.line(rim, end, Pen::new(Role::Good).dashed());
        // Too small to be a disc: a token.
        sheet.disc(end, 0.01 * stage.view.per_row(), Role::Marble, ' ');
        labels.add("mark", end, Side::towards(direction), Role::Good);
    }
}

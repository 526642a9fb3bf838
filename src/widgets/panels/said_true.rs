//! Predicted directions next to the true directions.

use crate::numbers;
use crate::physics::Collision;
use crate::quiz::{Ray, Rays};
use crate::widgets::panel::Panel;
use crate::widgets::{Role, brief, input::degrees};

/// Writes the predicted angles next to the true angles, with the signs used on the screen, one row
/// per disc; a ray that was not required has no name and no row. If `errors` is set, the error of
/// each angle is added.
pub(crate) fn said_and_true<A>(
    collision: &Collision,
    said: &Rays,
    names: [Option<&str>; 2],
    errors: bool,
    panel: &mut Panel<A>,
) {
    let true_rays = Rays::from(&collision.outcome());
    let [said_deg, true_deg] = [said, &true_rays].map(|rays| degrees(collision, rays));
    let off = Ray::BOTH.map(|ray| {
        let apart = said.apart(&true_rays, ray);
        apart.map_or("-".into(), numbers::bare_degrees)
    });
    // For a pair that moves on together, the true path is that of the centre of mass.
    let truth = match collision.coalesces() {
        true => "V",
        false => "truth",
    };
    let dim = |text: &str| (text.to_owned(), Role::Dim);
    let mut heads = vec![dim(if errors { "you" } else { "you said" }), dim(truth)];
    heads.extend(errors.then(|| dim("off")));
    panel.columns(("degrees", Role::Dim), heads);
    for (body, name) in names.into_iter().enumerate() {
        let Some(name) = name else { continue };
        let truth = [Role::StrikerOut, Role::CoinOut][body];
        let mut values = vec![
            (brief(said_deg[body]), Role::Predicted),
            (brief(true_deg[body]), truth),
        ];
        values.extend(errors.then(|| (off[body].clone(), Role::Text)));
        panel.columns((name, Role::Dim), values);
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;
    use ratatui::buffer::Buffer;
    use ratatui::layout::Rect;

    use super::*;
    use crate::physics::Disc;
    use crate::widgets::cells::text;
    use crate::widgets::panel::Writing;
    use crate::widgets::{Charset, Look};

    /// The table for a coin to the left (−1) or to the right (+1) of the striker's path.
    fn table(side: f64, said: Rays, names: [Option<&str>; 2], errors: bool) -> String {
        let disc = Disc {
            mass: 0.01,
            radius: 0.02,
        };
        let alpha = side * 30_f64.to_radians();
        let collision = Collision::at_angle(disc, disc, DVec2::X, alpha);
        let area = Rect::new(0, 0, 33, 3);
        let mut buf = Buffer::empty(area);
        let look = Look {
            charset: Charset::Ascii,
            ..Look::default()
        };
        let mut panel = Panel::<()>::new("");
        said_and_true(&collision, &said, names, errors, &mut panel);
        let writing = Writing {
            look,
            pages: None,
            key: &|()| None,
        };
        panel.placed(area, &writing).draw(0, &mut buf, &writing);
        text(&buf)
    }

    #[test]
    fn a_ray_on_the_wrong_side_has_a_minus_sign() {
        let names = [Some("striker"), Some("coin")];
        for side in [1.0, -1.0] {
            let rays = |side: f64| Rays::new(side * 60_f64.to_radians(), side * 0.5);
            let right = table(side, rays(side), names, false);
            let wrong = table(side, rays(-side), names, false);
            assert!(
                !right.contains('-') && right.matches("60.0").count() == 2,
                "{right}"
            );
            assert!(
                wrong.contains("-60.0") && wrong.contains("-28.6"),
                "{wrong}"
            );
        }
    }

    #[test]
    fn only_required_rays_are_shown() {
        let said = Rays::new(1.0, 0.5);
        let shown = table(1.0, said, [None, Some("coin")], false);
        assert!(!shown.contains("60.0") && shown.contains("30.0"), "{shown}");
    }

    #[test]
    fn errors_are_shown_on_request() {
        let said = Rays {
            striker: Some(1.0),
            target: None,
        };
        let shown = table(1.0, said, [Some("striker"), Some("coin")], true);
        assert!(shown.contains("2.7") && shown.contains("still"), "{shown}");
    }
}

//! The shot of a scene is played on the board of the scene.

use carrom::levels::Scene;
use carrom::physics::{EventKind, Limits, play};

/// A 15 g striker moves along +x and hits a 5.5 g coin whose centre is 18.275 mm to the right
/// of the striker's path, half of r₁ + r₂.
fn scene(restitution: &str) -> Scene {
    let text = format!(
        "format = 1\n[board]\n{restitution}\n\
         [[disc]]\nkind = \"striker\"\nat_mm = [-150, 0]\nmass_g = 15\n\
         [[disc]]\nkind = \"white\"\nat_mm = [0, -18.275]\nmass_g = 5.5\n\
         [shot]\ndisc = 0\ndirection_deg = 0\nspeed = 2\n"
    );
    Scene::read("scene.toml", text.as_bytes()).unwrap_or_else(|fault| panic!("{fault}"))
}

/// The energy lost in the first impact, and ½μu_n², both in joules.
fn first_impact(scene: &Scene) -> (f64, f64) {
    let shot = play(
        &scene.board,
        &scene.discs(),
        &scene.motions(),
        Limits::default(),
    )
    .unwrap();
    let (m1, m2) = (0.015, 0.0055);
    let impact = shot.events().iter().find_map(|event| match event.kind {
        EventKind::Impact {
            normal,
            before: [u1, u2],
            after: [v1, v2],
            ..
        } => {
            let energy = |v1: glam::DVec2, v2: glam::DVec2| {
                0.5 * m1 * v1.length_squared() + 0.5 * m2 * v2.length_squared()
            };
            let approach = (u1 - u2).dot(normal);
            let along = 0.5 * m1 * m2 / (m1 + m2) * approach * approach;
            Some((energy(u1, u2) - energy(v1, v2), along))
        }
        _ => None,
    });
    impact.unwrap()
}

#[test]
fn a_scene_chooses_how_much_energy_a_collision_loses() {
    for e in [0.9, 0.5, 0.0] {
        let (lost, along) = first_impact(&scene(&format!("restitution = {e}")));
        assert!(along > 0.004, "{along}");
        assert!((lost - along * (1.0 - e * e)).abs() < 1e-15, "{e}: {lost}");
    }
}

#[test]
fn discs_are_elastic_unless_a_scene_sets_a_restitution() {
    let (lost, along) = first_impact(&scene(""));
    assert!(lost.abs() < 1e-12 * along, "{lost}");
}

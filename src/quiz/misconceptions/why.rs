//! Explanations of where the two discs of any collision go.

use glam::DVec2;

use super::{explain, reasoning};
use crate::numbers::{degrees, fixed};
use crate::physics::{Collision, Meeting, Rims};
use crate::quiz::question::{Answer, Confidence, Hit, Rays, Response};

/// Explains where the two discs of a collision go. If the rims are smooth and the target is at
/// rest, the explanation starts from the player's prediction, if there is one. Returns a title,
/// which may be empty, and a text.
pub fn why(collision: &Collision, said: Option<Rays>) -> (&'static str, String) {
    if collision.outcome().meeting != Meeting::Hit {
        let text = "The discs only graze each other: no force acts, and both move on as before.";
        return ("", text.into());
    }
    if collision.rims.friction > 0.0 {
        return ("", rough(collision));
    }
    if collision.u2 != DVec2::ZERO {
        return ("", both_moving(collision));
    }
    why_of_hit(&Hit::from(collision), said)
}

/// Explains where the two discs of a hit go, starting from the player's prediction if there is one.
/// Returns a title, which is empty if there is no prediction, and a text.
pub(crate) fn why_of_hit(hit: &Hit, said: Option<Rays>) -> (&'static str, String) {
    let Some(rays) = said else {
        return ("", reasoning(hit));
    };
    let answer = Answer::new(Response::Rays(rays), Confidence::ThinkSo);
    let explanation = explain(&hit.into(), &answer);
    (explanation.title, explanation.text)
}

/// Explains the effects of friction between the rims, with the numbers of the collision.
fn rough(collision: &Collision) -> String {
    let outcome = collision.outcome();
    let rims = Rims::default();
    let smooth = Collision { rims, ..*collision }.outcome();
    if outcome.friction_impulse == 0.0 {
        return "The rims do not slip past each other at the contact, so friction has no effect: \
                the discs leave as if their rims were smooth."
            .into();
    }
    let stops = match collision.rub_stops() {
        true => "stops the slip",
        false => "is not enough to stop the slip",
    };
    let apart = match (smooth.separation, outcome.separation) {
        (Some(smooth), Some(rough)) => format!(
            " The angle between the paths is {}; with smooth rims it would be {}.",
            degrees(rough),
            degrees(smooth)
        ),
        _ => String::new(),
    };
    let throw = degrees(collision.throw().unwrap_or_default().abs());
    format!(
        "Friction acts along t, against the slip of {} m/s, and {stops}. It throws the coin off \
         the line of impact by δ = {throw}, and it exerts torques in the same sense on both \
         discs.{apart}",
        fixed(collision.slip().unwrap_or_default().abs(), 2)
    )
}

/// Explains where two discs go if both move before the collision, with the numbers of the
/// collision.
fn both_moving(collision: &Collision) -> String {
    let outcome = collision.outcome();
    let (Some(n), Some(t)) = (outcome.normal, outcome.tangent) else {
        return String::new();
    };
    let [u1n, u2n] = [collision.u1, collision.u2].map(|u| fixed(u.dot(n), 2));
    let [v1n, v2n] = [outcome.v1, outcome.v2].map(|v| fixed(v.dot(n), 2));
    let [u1t, u2t] = [collision.u1, collision.u2].map(|u| fixed(u.dot(t), 2));
    format!(
        "Both discs move, but the rule is the same. Along n, {u1n} and {u2n} m/s become {v1n} and \
         {v2n} m/s. Along t, both keep their components: {u1t} and {u2t} m/s."
    )
}

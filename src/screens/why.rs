//! Reasons that more than one screen gives.

use crate::physics::{Collision, ImpactPoint, Meeting};
use crate::quiz::{self, Answer, Confidence, Hit, Pieces, Rays, Response};

/// Why two that both move go where they go, in their own numbers; nothing for a miss.
pub(super) fn both_moving(collision: &Collision) -> String {
    let outcome = collision.outcome();
    let (Some(n), Some(t)) = (outcome.normal, outcome.tangent) else {
        return String::new();
    };
    format!(
        "Both move, but the rule is the same. Along n: {:.2} and {:.2} m/s become {:.2} and {:.2}. Across, along t, both keep what they had: {:.2} and {:.2}.",
        collision.u1.dot(n),
        collision.u2.dot(n),
        outcome.v1.dot(n) + 0.0,
        outcome.v2.dot(n) + 0.0,
        collision.u1.dot(t) + 0.0,
        collision.u2.dot(t) + 0.0,
    )
}

/// Why any two smooth discs go where they go, starting from what the player said of
/// both, if they did: a title, which may be empty, and a text.
pub(crate) fn of_impact(collision: &Collision, said: Option<Rays>) -> (String, String) {
    let plain = |text: String| (String::new(), text);
    if collision.outcome().meeting != Meeting::Hit {
        return plain("They just brush: nothing is pushed, and both go on as before.".into());
    }
    if collision.u2 != glam::DVec2::ZERO {
        return plain(both_moving(collision));
    }
    let hit = Hit {
        pieces: Pieces::Own {
            striker: collision.striker,
            target: collision.target,
        },
        given: ImpactPoint::Offset {
            // A head-on hit is exactly that in words too, whatever rounding left.
            offset_mm: (collision.offset * 1e9).round() / 1e6,
        },
        restitution: collision.restitution,
        speed: collision.u1.length(),
        direction_deg: collision.u1.to_angle().to_degrees(),
    };
    match said {
        Some(rays) => {
            let (title, text) = of_hit(&hit, rays);
            (title.into(), text)
        }
        None => plain(quiz::reasoning(&hit)),
    }
}

/// Why the two of a hit go where they go, starting from what the player said of them: a
/// title and a text.
pub(super) fn of_hit(hit: &Hit, said: Rays) -> (&'static str, String) {
    let answer = Answer::new(Response::Rays(said), Confidence::ThinkSo);
    let explanation = quiz::explain(&hit.into(), &answer);
    (explanation.title, explanation.text)
}

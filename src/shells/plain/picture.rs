//! What the picture of a question shows, in words.

use crate::physics::Collision;
use crate::quiz::{Illustration, Question};

/// What the picture shows beyond the text of the question, which describes the hit
/// whole; empty where it shows nothing more.
pub(super) fn describe(question: &Question) -> String {
    match &question.picture {
        // Without figures the picture is all there is to go by.
        Illustration::Before { collision, shown } if !shown.figures => seen(collision, shown.angle),
        _ => String::new(),
    }
}

/// How a hit looks, as a careful eye would judge it.
fn seen(collision: &Collision, line: bool) -> String {
    let share = collision.offset / collision.contact_distance();
    let percent = (100.0 * share.abs()).round();
    let side = if share < 0.0 { "left" } else { "right" };
    let place = format!(
        "Seen along the striker's path, the target's centre lies to the {side} of the path, by \
         about {percent:.0} percent of the two radii together."
    );
    match collision.alpha() {
        Some(alpha) if line => format!(
            "{place} The line of impact is drawn, at about {:.0}° to the path.",
            (alpha.abs().to_degrees() / 5.0).round() * 5.0
        ),
        _ => place,
    }
}

//! The panel beside an enlarged impact: the explanation of the lab.

use crate::physics::Frame;
use crate::quiz::why;
use crate::screens::table::replay::StrokeReplay;
use crate::widgets::hit::Watch;
use crate::widgets::panels::{impact_angle, masses, offset, reason, separation};
use crate::widgets::{Lines, Role};

/// Which two met, in numbers, and why they go where they go.
pub(super) fn draw(replay: &StrokeReplay, watch: &Watch, lines: &mut Lines) {
    let collision = watch.collision();
    let names = names(replay);
    lines.line(&format!("{} on {}", names[0], names[1]), Role::Title);
    offset(collision, lines);
    impact_angle(collision, lines);
    masses(collision, [false; 2], lines);
    if !watch.is_told() {
        lines.gap();
        return watch.write_telling(lines);
    }
    separation(collision, lines);
    lines.gap();
    if watch.frame() != Frame::Laboratory {
        lines.paragraph(frame_words(watch.frame()), Role::Text);
        return;
    }
    if names[0] != "striker" {
        let here = format!("Here the {} plays the striker's part.", names[0]);
        lines.paragraph(&here, Role::Dim);
    }
    reason(&why(collision, watch.said().copied()), lines);
}

/// What the two are.
fn names(replay: &StrokeReplay) -> [&'static str; 2] {
    let impact = replay.player.chosen().map(|(_, impact)| impact);
    [0, 1].map(|body| {
        let disc = impact.map(|impact| impact.discs[body]);
        let piece = disc.and_then(|disc| replay.pieces.get(disc).copied());
        piece.map_or("disc", Into::into)
    })
}

fn frame_words(frame: Frame) -> &'static str {
    match frame {
        Frame::CentreOfMass => {
            "Seen from the centre of mass: momentum is zero before and after, so the two always fly back to back."
        }
        _ => {
            "Seen riding with body 2: here it lies still before the hit, so all you know of a resting coin holds."
        }
    }
}

//! The panel beside an enlarged impact: the explanation of the lab.

use crate::physics::Frame;
use crate::quiz::why;
use crate::screens::table::replay::StrokeReplay;
use crate::widgets::Role;
use crate::widgets::hit::Watch;
use crate::widgets::panel::Panel;
use crate::widgets::panels::{impact_angle, masses, offset, reason, separation};

/// Which two met, in numbers, and why they go where they go.
pub(super) fn write<A>(replay: &StrokeReplay, watch: &Watch, panel: &mut Panel<A>) {
    let collision = watch.collision();
    let names = names(replay);
    panel.heading(format!("{} on {}", names[0], names[1]));
    offset(collision, panel);
    impact_angle(collision, panel);
    masses(collision, [false; 2], panel);
    if !watch.is_told() {
        panel.gap();
        return watch.write_telling(panel);
    }
    separation(collision, panel);
    panel.gap();
    if watch.frame() != Frame::Laboratory {
        return panel.paragraph(frame_words(watch.frame()), Role::Text);
    }
    if names[0] != "striker" {
        let here = format!("Here the {} plays the striker's part.", names[0]);
        panel.paragraph(here, Role::Dim);
    }
    reason(&why(collision, watch.said().copied()), panel);
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

//! The keys of a level, for the bottom line and for the help page.

use super::{Phase, Play};
use crate::screens::{Context, Help, Hint};

/// The keys that mean something now, the most useful first.
pub(super) fn shown(play: &Play, cx: &Context) -> Vec<Hint> {
    match &play.phase {
        Phase::Aim => {
            let says = !play.level.say_first.is_empty() && cx.settings.predict;
            let go = if says { "say where" } else { "shoot" };
            let mut hints = vec![
                Hint::new("Enter", go),
                Hint::new("Left Right", "set"),
                Hint::new(", .", "finely"),
            ];
            if play.level.adjust.dials().count() > 1 {
                hints.push(Hint::new("Up Down", "choose"));
            }
            hints.extend([
                Hint::new("0-9", "type"),
                Hint::new("h", "hint"),
                Hint::new("Esc", "back"),
                Hint::new("< >", "by ten steps"),
            ]);
            hints
        }
        Phase::Say(_) => vec![
            Hint::new("arrows", "turn"),
            Hint::new("0-9", "type"),
            Hint::new("x", "stays still"),
            Hint::new("Enter", "next, then shoot"),
            Hint::new("Esc", "back"),
        ],
        Phase::Watch(attempt) => {
            if attempt.zoom.is_some() {
                let mut hints = vec![Hint::new("Space", "go on"), Hint::new(", .", "step")];
                if attempt.impacts.len() > 1 {
                    hints.push(Hint::new("Tab", "next impact"));
                }
                hints.extend([
                    Hint::new("f", "frame"),
                    Hint::new("1-7", "layers"),
                    Hint::new("Esc", "board"),
                ]);
                return hints;
            }
            let mut hints = match (attempt.told, attempt.win.is_some()) {
                (false, _) => vec![Hint::new("Space", "go on"), Hint::new("+ -", "speed")],
                (true, true) => vec![Hint::new("Enter", "next level")],
                (true, false) => vec![Hint::new("Enter", "try again"), Hint::new("h", "hint")],
            };
            if !attempt.impacts.is_empty() {
                hints.push(Hint::new("i", "the impact"));
            }
            hints.extend([
                Hint::new("a", "again"),
                Hint::new(", .", "step"),
                Hint::new("< >", "scrub"),
                Hint::new("Esc", "aim"),
            ]);
            hints
        }
    }
}

/// The page that explains a level.
pub(super) fn help() -> Help {
    Help {
        text: vec![
            "Set the shot so that all goals of the level come about. The dotted line shows the way up to the first thing the disc meets; what happens then is for you to find out.",
            "Some levels ask first where the discs will go after the first hit. Then watch, read what came about and by how much it missed, and look at the impact enlarged.",
            "Stars: one for winning, one for at most three shots, one for saying the rays within 4° (where nothing is asked: for winning with the first shot).",
            "With the mouse: point the shot, drag the disc where it may be placed, turn the wheel for the speed.",
        ],
        keys: vec![
            Hint::new("Up Down", "choose what to set"),
            Hint::new(
                "Left Right",
                "set it: a step down or up, a direction to the left or right",
            ),
            Hint::new(", .", "a tenth of a step"),
            Hint::new("< >", "ten steps"),
            Hint::new("0-9 . -", "type a number; Enter sets it, Esc gives it up"),
            Hint::new("r", "back to how the level opens"),
            Hint::new("Enter", "go on: say where, shoot, try again, next level"),
            Hint::new("h", "a hint; again for the next one"),
            Hint::new("p", "say first, or just shoot"),
            Hint::new("x", "when saying where: this disc stays still"),
            Hint::new("Space", "watching: go on, or to the end"),
            Hint::new(
                ", . < >",
                "watching: step and scrub; Home and End for the ends",
            ),
            Hint::new("+ -", "watching: faster, slower"),
            Hint::new("a", "watch it again"),
            Hint::new(
                "i",
                "the impact enlarged; Tab for the next one, 1-7 for the layers, f for the frame",
            ),
            Hint::new("PageDown", "the rest of the text; PageUp back"),
            Hint::new("n", "after a win: the next level"),
        ],
    }
}

//! The keys of the table, for the bottom line and the help page.

use super::sitting::{Phase, Sitting};
use crate::screens::{Help, Hint};

/// The keys that matter now, the most useful first.
pub(super) fn keys(sitting: &Sitting) -> Vec<Hint> {
    if sitting.leaving {
        return vec![Hint::new("Esc", "leave"), Hint::new("any key", "play on")];
    }
    match &sitting.phase {
        Phase::Aim => {
            let mut keys = vec![
                Hint::new("Space", "strike"),
                Hint::new("arrows", "aim"),
                Hint::new("+ -", "strength"),
                Hint::new("[ ] { }", "place"),
                Hint::new("h", "hint"),
                Hint::new("0-9", "type"),
                Hint::new("c", "call"),
                Hint::new("l g r", "aids"),
                Hint::new("i", "impacts"),
                Hint::new("v", "replay"),
                Hint::new("e", "export"),
            ];
            if sitting.is_practice() {
                keys.insert(6, Hint::new("p", "lay out"));
                keys.insert(7, Hint::new("z", "undo"));
            }
            keys
        }
        Phase::Think { .. } => vec![Hint::new("Esc", "leave")],
        Phase::Call(_) => vec![
            Hint::new("arrows", "turn"),
            Hint::new("0-9", "type"),
            Hint::new("x", "stays still"),
            Hint::new("Enter", "next, then strike"),
            Hint::new("Esc", "back"),
        ],
        Phase::Watch(replay) if replay.chosen.is_some() => vec![
            Hint::new("Up Down", "choose"),
            Hint::new("Enter", "look closer"),
            Hint::new("Esc", "back"),
        ],
        Phase::Watch(replay) => {
            let space = if replay.clock.is_running() {
                "skip"
            } else {
                "go on"
            };
            vec![
                Hint::new("Space", space),
                Hint::new("i", "impacts"),
                Hint::new(", .", "step"),
                Hint::new("< >", "scrub"),
                Hint::new("+ -", "speed"),
                Hint::new("a", "again"),
                Hint::new("p n", "other strokes"),
            ]
        }
        Phase::Impact(_) => vec![
            Hint::new("Space", "go on"),
            Hint::new(", .", "step"),
            Hint::new("f", "frame"),
            Hint::new("1-7", "layers"),
            Hint::new("a", "again"),
            Hint::new("Esc", "back"),
        ],
        Phase::Arrange(_) => vec![
            Hint::new("arrows", "move"),
            Hint::new("Space", "take, lay"),
            Hint::new("o b q", "add"),
            Hint::new("x", "remove"),
            Hint::new("z", "undo"),
            Hint::new("p", "done"),
        ],
        Phase::Over => vec![
            Hint::new("Enter", "next"),
            Hint::new("i", "strokes"),
            Hint::new("v", "replay"),
            Hint::new("e", "export"),
            Hint::new("Esc", "leave"),
        ],
    }
}

/// The page that explains the table.
pub(super) fn help() -> Help {
    Help {
        text: vec![
            "Carrom: pocket your nine coins with the striker before the other side does, and the queen on the way. Who breaks plays white; who pockets an own coin plays on.",
            "Put the striker on your base line (the side whose turn it is is marked), aim, choose the strength, strike. After the stroke the referee says what follows, with the number of the law.",
            "The aim line and the ghost show where the striker will meet its first coin; the two arrows show where both leave that hit. Switch them off one by one as you get better.",
            "Call it: before the stroke, say at which angles the two of the first hit will leave it. Good calls earn points of their own, which never mix with the score.",
            "After any stroke press i: choose one of its impacts and look at it as in the lab; p and n go to other strokes.",
            "Every game is saved after each stroke. On the page of a new game, s shows the games there are: resume one, or watch it stroke by stroke. What e writes can be played again on any machine: carrom replay FILE.",
            "Angles of the aim are as you see the board from your own side: 90 is straight across.",
        ],
        keys: vec![
            Hint::new("Left Right", "turn the aim by 1°; PageUp PageDown by 10°"),
            Hint::new("Up Down", "turn the aim by 0.1°"),
            Hint::new(
                "0-9 .",
                "type a number; Enter takes it as the angle, + as the strength, [ or ] as millimetres left or right",
            ),
            Hint::new("[ ] or a d", "move the striker by 2 mm; { } by 20 mm"),
            Hint::new("+ -", "strength; the wheel too"),
            Hint::new("mouse", "drag the striker, or point where to aim"),
            Hint::new("Space", "strike; skip to the end; go on"),
            Hint::new("l g r", "aim line, ghost, departures on or off"),
            Hint::new(
                "h",
                "hint: where to look; again: the whole stroke; once more: set it",
            ),
            Hint::new("c", "call it on or off"),
            Hint::new("i", "impacts of the stroke, or the last stroke again"),
            Hint::new(", . < >", "step and scrub; Home and End for the ends"),
            Hint::new(
                "PageUp PageDown",
                "scroll a text that is longer than its place",
            ),
            Hint::new("+ - (watching)", "faster or slower"),
            Hint::new("p n", "previous and next stroke (watching)"),
            Hint::new("v", "watch the whole game again, stroke by stroke"),
            Hint::new("e", "export: write the game to a file of its own"),
            Hint::new("p", "practice: lay the coins out"),
            Hint::new("z", "practice: take the last stroke back"),
            Hint::new("w s", "practice: striker up or down"),
        ],
    }
}

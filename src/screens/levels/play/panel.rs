//! The words beside a level: goals and dials, the rays being said, what came about
//! and why.

use super::made_shot::{MadeShot, asked};
use super::{LevelPhase, LevelPlay, PendingShot};
use crate::levels::{FEW_SHOTS, Win};
use crate::numbers;
use crate::physics::Frame;
use crate::quiz::{Ray, why};
use crate::screens::Context;
use crate::screens::levels::words;
use crate::widgets::hit::Watch;
use crate::widgets::panel::{Panel, written};
use crate::widgets::panels::{
    contact_distance, impact_angle, masses, offset, reason, said_and_true, separation,
};
use crate::widgets::replay::ShotImpact;
use crate::widgets::{Lines, RayInput, Role};

/// Shots that are shown while the next one is set.
const SHOWN_EARLIER: usize = 2;

/// Writes all of it.
pub(super) fn write(play: &LevelPlay, lines: &mut Lines, cx: &Context) {
    match &play.phase {
        LevelPhase::Aim => aim(play, lines, cx),
        LevelPhase::Predict(pending) => say(play, pending, lines),
        LevelPhase::Watch(made) => match made.player.zoom() {
            Some(watch) => enlarged(play, made, watch, lines),
            None if made.told => outcome(play, made, lines, cx),
            None => watching(play, made, lines),
        },
    }
}

/// Rows of the goals, above the dials.
pub(super) fn goals(play: &LevelPlay, lines: &mut Lines) {
    lines.line("Goal", Role::Title);
    for goal in &play.level().goals {
        lines.paragraph(&goal.describe(&play.level().scene), Role::Text);
    }
    lines.gap();
}

fn aim(play: &LevelPlay, lines: &mut Lines, cx: &Context) {
    goals(play, lines);
    written(lines, |panel| {
        play.form.write(&play.dials, panel);
        play.form.write_about(&play.dials, panel);
    });
    lines.gap();
    if let Some(trouble) = &play.trouble {
        lines.paragraph(trouble, Role::Warn);
        lines.gap();
    }
    let says = !play.level().say_first.is_empty();
    let next = match (says, cx.settings.predict) {
        (true, true) => "Enter: say where they go.",
        (true, false) => "Enter: shoot. (p: say first)",
        (false, _) => "Enter: shoot.",
    };
    lines.paragraph(next, Role::Key);
    earlier(play, lines);
    hints(play, lines);
}

/// The last shots and what came of them, to compare.
fn earlier(play: &LevelPlay, lines: &mut Lines) {
    let hidden = play.earlier.len().saturating_sub(SHOWN_EARLIER);
    for made in play.earlier.iter().skip(hidden) {
        lines.gap();
        lines.line(&format!("shot {}: {}", made.number, made.set), Role::Dim);
        lines.paragraph(&format!("{}.", numbers::capital(&made.told)), Role::Dim);
    }
    if !play.earlier.is_empty() {
        lines.gap();
    }
}

/// The hints asked for, and how to get the next.
fn hints(play: &LevelPlay, lines: &mut Lines) {
    let all = &play.level().hints;
    for (number, hint) in all.iter().take(play.hints).enumerate() {
        lines.gap();
        lines.line(
            &format!("Hint {} of {}", number + 1, all.len()),
            Role::Title,
        );
        lines.paragraph(hint, Role::Text);
    }
    if play.hints == 0 {
        lines.paragraph("h: a hint.", Role::Key);
    } else if play.hints < all.len() {
        lines.gap();
        lines.paragraph("h: another hint.", Role::Key);
    }
}

fn say(play: &LevelPlay, pending: &PendingShot, lines: &mut Lines) {
    let scene = &play.level().scene;
    let [_, target] = pending.impact.discs;
    let name = words::short(scene, target);
    let collision = &pending.impact.collision;
    written(lines, |panel| {
        offset(collision, panel);
        if pending.rays.asks(Ray::Target) {
            // The angle itself is what is asked for.
            contact_distance(collision, panel);
        } else {
            impact_angle(collision, panel);
        }
        bodies(&pending.impact, &play.level().unknown_mass, panel);
        panel.gap();
        panel.heading("The first hit");
        pending.rays.write(panel, name);
    });
    lines.gap();
    lines.paragraph(&pending.rays.about(name), Role::Text);
    lines.gap();
    lines.paragraph(&pending.rays.prompt(name, "shoot!"), Role::Key);
}

/// Where two meet, and what they are, but for the masses of `secret` discs.
fn given<A>(impact: &ShotImpact, secret: &[usize], panel: &mut Panel<A>) {
    offset(&impact.collision, panel);
    impact_angle(&impact.collision, panel);
    bodies(impact, secret, panel);
}

/// What the two are, but for the masses of `secret` discs.
fn bodies<A>(impact: &ShotImpact, secret: &[usize], panel: &mut Panel<A>) {
    let secret = impact.discs.map(|disc| secret.contains(&disc));
    masses(&impact.collision, secret, panel);
}

fn watching(play: &LevelPlay, made: &MadeShot, lines: &mut Lines) {
    goals(play, lines);
    let time = format!("{:.2} s", made.player.clock().time());
    lines.fact("time", &time);
    lines.fact("watched at", &made.player.clock().rate().words());
    lines.gap();
    lines.paragraph("Space: go on, or to the end.", Role::Key);
}

/// What came about.
fn outcome(play: &LevelPlay, made: &MadeShot, lines: &mut Lines, cx: &Context) {
    match &made.win {
        Some(win) => {
            let won = match play.hints {
                0 => "Won!".into(),
                hints => format!("Won, with {}!", numbers::counted(hints, "hint")),
            };
            lines.pair(&won, &words::stars(win.stars()), Role::Good, Role::Good);
        }
        None => {
            let (met, all) = (made.verdict.met(), play.level().goals.len());
            let cheer = match met {
                0 => "Not yet. See what was off, then change one thing at a time.".into(),
                _ => format!("Not yet, but {met} of {all} goals are met: you are on the way."),
            };
            lines.paragraph(&cheer, Role::Title);
        }
    }
    lines.gap();
    for finding in made.verdict.told(play.level()) {
        let (mark, role) = if finding.met {
            ("✓", Role::Good)
        } else {
            ("✗", Role::Warn)
        };
        let told = numbers::capital(&finding.told);
        lines.paragraph(&format!("{mark} {told}."), role);
    }
    if let Some(impact) = made.player.impacts().first() {
        answers(play, made, impact, lines);
    }
    lines.gap();
    match &made.win {
        Some(win) => won(play, *win, lines, cx),
        None => {
            lines.paragraph("Enter: try again from the same aim.", Role::Key);
            if !made.player.impacts().is_empty() {
                lines.paragraph("i: look at the hit, enlarged.", Role::Key);
            }
            hints(play, lines);
        }
    }
}

/// The explanation, what the stars were for, and where to go on.
fn won(play: &LevelPlay, win: Win, lines: &mut Lines, cx: &Context) {
    lines.paragraph(&play.level().explanation, Role::Text);
    lines.gap();
    if !win.has_few_shots() {
        let text = format!("A star more: win with at most {FEW_SHOTS} shots and no hint.");
        lines.paragraph(&text, Role::Dim);
    }
    if !win.is_accurate() {
        let text = match win.said_right {
            Some(_) if cx.settings.predict => "A star more: say within 4° where the discs go.",
            Some(_) => "A star more: say first where the discs go (p).",
            None => "A star more: win with the first shot.",
        };
        lines.paragraph(text, Role::Dim);
    }
    let next = if play.number + 1 < cx.shelf.count() {
        "Enter: the next level."
    } else {
        "That was the last level! Enter: back to the list."
    };
    lines.paragraph(next, Role::Key);
}

/// What was said beside the truth.
fn answers(play: &LevelPlay, made: &MadeShot, impact: &ShotImpact, lines: &mut Lines) {
    let Some(said) = &made.said else {
        return;
    };
    lines.gap();
    let mut names = [None; 2];
    for ray in asked(said) {
        let body = usize::from(ray == Ray::Target);
        names[body] = Some(words::short(&play.level().scene, impact.discs[body]));
    }
    written::<()>(lines, |panel| {
        said_and_true(&impact.collision, &said.so_far(), names, false, panel);
    });
}

/// Which of the impacts is enlarged.
pub(super) fn impact_title(made: &MadeShot) -> String {
    let number = made.player.chosen().map_or(0, |(number, _)| number);
    format!("impact {} of {}", number + 1, made.player.impacts().len())
}

/// One impact, enlarged: the explanation of the lab.
fn enlarged(play: &LevelPlay, made: &MadeShot, watch: &Watch, lines: &mut Lines) {
    let scene = &play.level().scene;
    let Some((number, impact)) = made.player.chosen() else {
        return;
    };
    let [first, second] = impact.discs.map(|disc| scene.name(disc));
    let met = numbers::capital(&format!("{first} on {second}"));
    lines.paragraph(&met, Role::Title);
    // What a win has shown is no secret any more.
    let secret = match made.win {
        Some(_) => &[],
        None => play.level().unknown_mass.as_slice(),
    };
    written::<()>(lines, |panel| given(impact, secret, panel));
    if !watch.is_told() {
        lines.gap();
        return written::<()>(lines, |panel| watch.write_telling(panel));
    }
    written::<()>(lines, |panel| separation(&impact.collision, panel));
    match watch.frame() {
        Frame::Laboratory => {}
        Frame::CentreOfMass => {
            lines.gap();
            return lines.paragraph("From the centre of mass the two always fly back to back: momentum is zero before and after.", Role::Text);
        }
        Frame::Target => {
            lines.gap();
            return lines.paragraph("Riding with body 2: here it lies still before the hit, so all you know of a resting coin holds.", Role::Text);
        }
    }
    let said = made.said.as_ref().filter(|_| number == 0);
    if said.is_some() {
        answers(play, made, impact, lines);
    }
    lines.gap();
    if impact.discs.iter().any(|disc| secret.contains(disc)) {
        let text = "A mass here is for you to find. The angles of the first hit tell it: where nothing is lost, m₁ / m₂ = sin(θ₁ + 2 θ₂) / sin θ₁.";
        return lines.paragraph(text, Role::Text);
    }
    let why = why(&impact.collision, said.and_then(RayInput::both));
    written::<()>(lines, |panel| reason(&why, panel));
}

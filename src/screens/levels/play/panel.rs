//! The words beside a level: goals and dials, the rays being said, what came about
//! and why.

use super::attempt::{Attempt, Zoom};
use super::{Phase, Play, Saying, dials};
use crate::levels::{FEW_SHOTS, Win};
use crate::numbers;
use crate::physics::Frame;
use crate::physics::units::mm_from_m;
use crate::quiz::Ray;
use crate::screens::levels::words;
use crate::screens::{Context, why};
use crate::widgets::panels::{impact_angle, masses, offset, said_and_true, separation};
use crate::widgets::replay::Impact;
use crate::widgets::{Lines, Role};

/// Shots that are shown while the next one is set.
const SHOWN_TRIES: usize = 2;

/// Writes all of it.
pub(super) fn write(play: &Play, lines: &mut Lines, cx: &Context) {
    match &play.phase {
        Phase::Aim => aim(play, lines, cx),
        Phase::Say(saying) => say(play, saying, lines),
        Phase::Watch(attempt) => match &attempt.zoom {
            Some(zoom) => enlarged(play, attempt, zoom, lines),
            None if attempt.told => outcome(play, attempt, lines, cx),
            None => watching(play, attempt, lines),
        },
    }
}

/// Rows of the goals, above the dials.
pub(super) fn goals(play: &Play, lines: &mut Lines) {
    lines.line("Goal", Role::Title);
    for goal in &play.level.goals {
        lines.paragraph(&goal.describe(&play.level.scene), Role::Text);
    }
    lines.gap();
}

fn aim(play: &Play, lines: &mut Lines, cx: &Context) {
    goals(play, lines);
    let chosen = play.dials.chosen(&play.level);
    for (dial, _) in play.level.adjust.dials() {
        let (mark, name_role, value_role) = if chosen.is_some_and(|(chosen, _)| chosen == dial) {
            (">", Role::Selected, Role::Selected)
        } else {
            (" ", Role::Dim, Role::Text)
        };
        let name = format!("{mark} {}", dials::name(dial));
        let value = play.dials.shown(&play.level, dial);
        lines.pair(&name, &value, name_role, value_role);
    }
    if let Some((dial, range)) = chosen {
        let range = format!("  {}", dials::range_words(dial, range));
        lines.line(&range, Role::Dim);
    }
    lines.gap();
    if let Some(trouble) = &play.trouble {
        lines.paragraph(trouble, Role::Warn);
        lines.gap();
    }
    let says = !play.level.say_first.is_empty();
    let next = match (says, cx.settings.predict) {
        (true, true) => "Enter: say where they go.",
        (true, false) => "Enter: shoot. (p: say first)",
        (false, _) => "Enter: shoot.",
    };
    lines.paragraph(next, Role::Key);
    tries(play, lines);
    hints(play, lines);
}

/// The last shots and what came of them, to compare.
fn tries(play: &Play, lines: &mut Lines) {
    let earlier = play.tries.len().saturating_sub(SHOWN_TRIES);
    for made in play.tries.iter().skip(earlier) {
        lines.gap();
        lines.line(&format!("shot {}: {}", made.number, made.set), Role::Dim);
        lines.paragraph(&format!("{}.", numbers::capital(&made.told)), Role::Dim);
    }
    if !play.tries.is_empty() {
        lines.gap();
    }
}

/// The hints asked for, and how to get the next.
fn hints(play: &Play, lines: &mut Lines) {
    let all = &play.level.hints;
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

fn say(play: &Play, saying: &Saying, lines: &mut Lines) {
    let scene = &play.level.scene;
    let [_, target] = saying.impact.discs;
    let name = words::short(scene, target);
    let collision = &saying.impact.collision;
    offset(collision, lines);
    if saying.rays.asks(Ray::Target) {
        // The angle itself is what is asked for.
        let reach = format!("{:.1} mm", mm_from_m(collision.contact_distance()));
        lines.pair("r₁ + r₂", &reach, Role::Dim, Role::Text);
    } else {
        impact_angle(collision, lines);
    }
    bodies(&saying.impact, &play.level.unknown_mass, lines);
    lines.gap();
    lines.line("The first hit", Role::Title);
    saying.rays.write(lines, name);
    lines.gap();
    lines.paragraph(&saying.rays.about(name), Role::Text);
    lines.gap();
    let next = if saying.rays.is_last() {
        "Enter: shoot!".into()
    } else {
        format!("Enter: then the {name}.")
    };
    lines.paragraph(&next, Role::Key);
}

/// Where two meet, and what they are, but for the masses of `secret` discs.
fn given(impact: &Impact, secret: &[usize], lines: &mut Lines) {
    offset(&impact.collision, lines);
    impact_angle(&impact.collision, lines);
    bodies(impact, secret, lines);
}

/// What the two are, but for the masses of `secret` discs.
fn bodies(impact: &Impact, secret: &[usize], lines: &mut Lines) {
    let secret = impact.discs.map(|disc| secret.contains(&disc));
    masses(&impact.collision, secret, lines);
}

fn watching(play: &Play, attempt: &Attempt, lines: &mut Lines) {
    goals(play, lines);
    let time = format!("{:.2} s", attempt.clock.time());
    lines.pair("time", &time, Role::Dim, Role::Text);
    lines.pair(
        "watched at",
        &attempt.clock.rate().words(),
        Role::Dim,
        Role::Text,
    );
    lines.gap();
    lines.paragraph("Space: go on, or to the end.", Role::Key);
}

/// What came about.
fn outcome(play: &Play, attempt: &Attempt, lines: &mut Lines, cx: &Context) {
    match &attempt.win {
        Some(win) => {
            lines.pair("Won!", &words::stars(win.stars()), Role::Good, Role::Good);
        }
        None => {
            let (met, all) = (attempt.verdict.met(), play.level.goals.len());
            let cheer = match met {
                0 => "Not yet. See what was off, then change one thing at a time.".into(),
                _ => format!("Not yet, but {met} of {all} came about: you are on the way."),
            };
            lines.paragraph(&cheer, Role::Title);
        }
    }
    lines.gap();
    for finding in attempt.verdict.told(&play.level) {
        let (mark, role) = if finding.met {
            ("✓", Role::Good)
        } else {
            ("✗", Role::Warn)
        };
        let told = numbers::capital(&finding.told);
        lines.paragraph(&format!("{mark} {told}."), role);
    }
    if let Some(impact) = attempt.impacts.first() {
        answers(play, attempt, impact, lines);
    }
    lines.gap();
    match &attempt.win {
        Some(win) => won(play, *win, lines, cx),
        None => {
            lines.paragraph("Enter: try again from the same aim.", Role::Key);
            if !attempt.impacts.is_empty() {
                lines.paragraph("i: look at the hit, enlarged.", Role::Key);
            }
            hints(play, lines);
        }
    }
}

/// The explanation, what the stars were for, and where to go on.
fn won(play: &Play, win: Win, lines: &mut Lines, cx: &Context) {
    lines.paragraph(&play.level.explanation, Role::Text);
    lines.gap();
    if !win.has_few_shots() {
        let text = format!("A star more: win with at most {FEW_SHOTS} shots.");
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
fn answers(play: &Play, attempt: &Attempt, impact: &Impact, lines: &mut Lines) {
    let Some(said) = &attempt.said else {
        return;
    };
    lines.gap();
    let mut names = [None; 2];
    for (body, _) in said.asked() {
        names[body] = Some(words::short(&play.level.scene, impact.discs[body]));
    }
    said_and_true(&impact.collision, &said.rays, names, false, lines);
}

/// One impact, enlarged: the explanation of the lab.
fn enlarged(play: &Play, attempt: &Attempt, zoom: &Zoom, lines: &mut Lines) {
    let scene = &play.level.scene;
    let Some(impact) = attempt.enlarged() else {
        return;
    };
    let watch = &zoom.watch;
    let [first, second] = impact.discs.map(|disc| scene.name(disc));
    let met = numbers::capital(&format!("{first} on {second}"));
    lines.paragraph(&met, Role::Title);
    // What a win has shown is no secret any more.
    let secret = match attempt.win {
        Some(_) => &[],
        None => play.level.unknown_mass.as_slice(),
    };
    given(impact, secret, lines);
    if !watch.is_told() {
        lines.gap();
        lines.paragraph(watch.telling(), Role::Text);
        return;
    }
    separation(&impact.collision, lines);
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
    let said = attempt.said.filter(|_| zoom.number == 0);
    if said.is_some() {
        answers(play, attempt, impact, lines);
    }
    lines.gap();
    if impact.discs.iter().any(|disc| secret.contains(disc)) {
        let text = "A mass here is for you to find. The angles of the first hit tell it: where nothing is lost, m₁ / m₂ = sin(θ₁ + 2 θ₂) / sin θ₁.";
        return lines.paragraph(text, Role::Text);
    }
    let (title, text) = why::of_impact(&impact.collision, said.and_then(|said| said.both()));
    if !title.is_empty() {
        lines.paragraph(&title, Role::Title);
    }
    lines.paragraph(&text, Role::Text);
}

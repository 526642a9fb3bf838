//! The panel beside the lab's picture: settings, the prediction, the shot in numbers.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::explain::{explain, turns_a_second};
use super::view::live_hit;
use super::{Lab, LabField};
use crate::physics::frames::cm_scattering_angle;
use crate::physics::{Bond, Frame, Meeting};
use crate::quiz::Rays;
use crate::screens::Context;
use crate::widgets::hit::{VelocityNames, Watch, degrees};
use crate::widgets::panels::{reason, said_and_true, separation};
use crate::widgets::{Lines, RayInput, Role, shown};

/// The setting whose row is at this cell.
pub(super) fn field_at(panel: Rect, (column, row): (u16, u16)) -> Option<usize> {
    if !panel.contains((column, row).into()) {
        return None;
    }
    let field = usize::from(row - panel.y);
    (field < LabField::ALL.len()).then_some(field)
}

/// The settings, and what follows from them.
pub(super) fn draw_settings(lab: &Lab, area: Rect, buf: &mut Buffer, cx: &Context) {
    let mut lines = Lines::new(area, buf, cx.settings.look());
    lab.form.write(&lab.settings, &mut lines);
    let live = lab.is_live(cx);
    let next = if live {
        "Enter: watch it. v: live off."
    } else if cx.settings.predict && lab.may_live(cx) {
        "Enter: say where both will go. v: live."
    } else if cx.settings.predict {
        "Enter: now say where both will go."
    } else {
        "Enter: shoot. (p: predict first)"
    };
    geometry(lab, &mut lines);
    if live {
        answers(&live_hit(lab), &mut lines);
    }
    let about = |lines: &mut Lines| lab.form.write_about(&lab.settings, lines);
    let mut spare = lines.spare(lines.rows_of(next));
    let apart = spare.take(1);
    if spare.take(lines.rows_by(about)) {
        if spare.take(1) {
            lines.gap();
        }
        about(&mut lines);
    }
    if apart {
        lines.gap();
    }
    lines.paragraph(next, Role::Key);
}

/// b/(r₁+r₂), and that they miss if they do.
fn geometry(lab: &Lab, lines: &mut Lines) {
    let setup = &lab.settings.setup;
    let ratio = setup.offset_mm().abs() / setup.contact_distance_mm();
    lines.fact("b / (r₁+r₂)", &format!("{ratio:.3}"));
    if setup.collision().normal().is_none() {
        let why = if ratio > 1.0 {
            "above 1: they will miss"
        } else {
            "same velocity: no hit"
        };
        lines.line(why, Role::Warn);
    }
}

/// The two rays being said.
pub(super) fn draw_prediction(
    lab: &Lab,
    rays: &RayInput,
    area: Rect,
    buf: &mut Buffer,
    cx: &Context,
) {
    let mut lines = Lines::new(area, buf, cx.settings.look());
    given(lab, &mut lines);
    for (field, name) in [
        (LabField::StrikerMass, "striker"),
        (LabField::CoinMass, "coin"),
    ] {
        lines.fact(name, &lab.settings.field(field).shown);
    }
    lines.gap();
    lines.line("Where will they go?", Role::Title);
    rays.write(&mut lines, "coin");
    lines.gap();
    lines.paragraph(&rays.about("coin"), Role::Text);
    lines.gap();
    lines.paragraph(&rays.prompt("coin", "shoot!"), Role::Key);
}

/// The shot in numbers, what was said of it, and why it went as it did. The
/// explanation comes whole; where there is not room for all, numbers that the
/// player set and knows give way first.
pub(super) fn write_shot(lab: &Lab, watch: &Watch, lines: &mut Lines) {
    if !watch.is_told() {
        given(lab, lines);
        lines.gap();
        return watch.write_telling(lines);
    }
    if watch.frame() != Frame::Laboratory {
        given(lab, lines);
        lines.gap();
        match watch.frame() {
            Frame::Target => from_target(watch, lines),
            _ => from_centre_of_mass(watch, lines),
        }
        return;
    }
    if let Some(coin) = &lab.settings.mystery {
        answers(watch, lines);
        lines.gap();
        coin.write(&lab.settings.setup, watch.outcome(), lines);
        return;
    }
    let why = explain(watch);
    let mut spare = lines.spare(ANSWER_ROWS + lines.rows_by(|lines| reason(&why, lines)));
    let gap = spare.take(1);
    if spare.take(GIVEN_ROWS + 1) {
        given(lab, lines);
        lines.gap();
    }
    answers(watch, lines);
    if gap {
        lines.gap();
    }
    reason(&why, lines);
}

/// Rows that [`given`] takes at most.
const GIVEN_ROWS: u16 = 4;
/// Rows that [`answers`] takes at most.
const ANSWER_ROWS: u16 = 5;

/// Where they meet.
fn given(lab: &Lab, lines: &mut Lines) {
    for field in [LabField::Offset, LabField::ImpactAngle] {
        let field = field.field(&lab.settings.setup);
        lines.fact(&field.name, &field.shown);
    }
    geometry(lab, lines);
}

fn answers(watch: &Watch, lines: &mut Lines) {
    let outcome = watch.outcome();
    let sticks = watch.collision().bond == Bond::Stick && outcome.meeting == Meeting::Hit;
    let truth = degrees(watch.collision(), &Rays::from(outcome));
    match watch.said() {
        Some(said) => {
            let names = ["striker", "coin"].map(Some);
            said_and_true(watch.collision(), said, names, false, lines);
        }
        None if sticks => lines.pair(
            "direction of V",
            &shown(truth[0]),
            Role::Dim,
            Role::StrikerOut,
        ),
        None => {
            for (i, name) in ["striker θ₁", "coin θ₂"].into_iter().enumerate() {
                let role = [Role::StrikerOut, Role::CoinOut][i];
                lines.pair(name, &shown(truth[i]), Role::Dim, role);
            }
        }
    }
    separation(watch.collision(), lines);
    if outcome.energy_before > 0.0 {
        let kept = 100.0 * outcome.energy_after / outcome.energy_before;
        lines.fact("energy kept", &format!("{kept:.1} %"));
    }
}

fn from_centre_of_mass(watch: &Watch, lines: &mut Lines) {
    let collision = watch.collision();
    let outcome = watch.outcome();
    let drift = Frame::CentreOfMass.velocity(collision);
    lines.line("From the centre of mass", Role::Title);
    lines.fact("V", &format!("{:.2} m/s", drift.length()));
    let [v1, v2] = collision.centres_after();
    let names = VelocityNames::new(collision, Frame::CentreOfMass);
    let before = [collision.u1, collision.u2];
    for (body, after) in [v1, v2].into_iter().enumerate() {
        let disc = ["striker", "coin"][body];
        for (name, v) in [
            (names.before[body], before[body]),
            (names.after[body], after),
        ] {
            let speed = format!("{:.2} m/s", (v - drift).length());
            lines.fact(&format!("{disc} {name}"), &speed);
        }
    }
    let turned = collision
        .alpha()
        .and_then(|alpha| cm_scattering_angle(alpha, collision.restitution));
    if let Some(turned) = turned
        && collision.bond == Bond::Slip
    {
        let turned = format!("{:.1}°", turned.to_degrees().abs());
        lines.fact("turned by Θ", &turned);
    }
    lines.gap();
    let sticks = collision.bond == Bond::Stick && outcome.meeting == Meeting::Hit;
    let text = if !sticks {
        "Here the two always fly back to back: momentum is zero before and after. Add V to both and you are on the board again.".into()
    } else if outcome.energy_rotation > 0.0 {
        format!(
            "They come from opposite sides and do not part. Their centre of mass lies still here, and they turn about it {} times a second; the speeds after are those of the two centres. Add V, and the pair moves on as it turns.",
            turns_a_second(outcome)
        )
    } else {
        "They come from opposite sides, stick and lie still: momentum is zero before and after. Add V, and the pair moves on.".into()
    };
    lines.paragraph(&text, Role::Text);
}

fn from_target(watch: &Watch, lines: &mut Lines) {
    let seen = Frame::Target.view(watch.collision()).outcome();
    let apart = |angle: f64| format!("{:.1}°", angle.to_degrees());
    let (name, value, text) = match (watch.collision().bond, seen.meeting) {
        (Bond::Stick, Meeting::Hit) => (
            "V here",
            format!("{:.2} m/s", seen.v1.length()),
            "Here the coin lies still before the hit. The centre of mass moves with V before and after; stuck together, the two can only turn about it.",
        ),
        _ => (
            "separation here",
            seen.separation.map_or("none".into(), apart),
            "Here the coin lies still before the hit, so everything you know of a resting coin holds: for equal masses and e = 1 they part at 90° in this frame.",
        ),
    };
    lines.line("Riding with the coin", Role::Title);
    lines.fact(name, &value);
    lines.gap();
    lines.paragraph(text, Role::Text);
}

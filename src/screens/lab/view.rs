//! The view of the lab: the picture, and beside it the settings, the prediction or the shot in
//! numbers.

use glam::DVec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Lab, LabAction, LabPhase, notebook};
use crate::lessons::FigureKind;
use crate::physics::{Bond, Frame};
use crate::quiz::Rays;
use crate::screens::{Context, View};
use crate::widgets::curves::curves_picture;
use crate::widgets::hit::{
    Face, Markings, Overlay, Overlays, VelocityNames, Watch, degrees, explain, setup_picture,
    turns_a_second, write_observation,
};
use crate::widgets::input::{CollisionField, SettingsForm};
use crate::widgets::panel::Panel;
use crate::widgets::panels::{reason, rim_facts, said_and_true, separation};
use crate::widgets::{Look, RayInput, Role, areas, shown};

/// The picture, and the panel beside it.
pub(super) fn view<'s>(lab: &'s Lab, cx: &'s Context) -> View<'s, LabAction> {
    let setup = |rays: Option<&'s RayInput>| {
        move |area| {
            let collision = lab.settings.setup.collision();
            let faces = Face::STRIKER_AND_COIN;
            setup_picture(area, faces, &collision, Markings::ALL, rays)
        }
    };
    match &lab.phase {
        LabPhase::Aim if lab.is_live(cx) => {
            let draw = |area, buf: &mut _, look: &_| live(lab, area, buf, look, cx);
            View::picture("live: follows your settings", draw, settings(lab, cx)).dragging(DRAG)
        }
        LabPhase::Aim => {
            View::drawn("set up the hit", setup(None), settings(lab, cx)).dragging(DRAG)
        }
        LabPhase::Predict(rays) => {
            let panel = prediction(lab, rays);
            View::drawn("where will they go?", setup(Some(rays)), panel).dragging(RayInput::DRAG)
        }
        LabPhase::See(sighting, _) => {
            let mut panel = Panel::new("watch");
            panel.part(LabAction::See, |panel| sighting.write("coin", panel));
            let picture = |area| sighting.picture(area);
            View::drawn(sighting.title(), picture, panel).dragging(sighting.drag())
        }
        LabPhase::Notebook(notebook) => notebook::view(notebook, LabAction::Notebook),
        LabPhase::Watch(watch) => {
            let picture = |area| watch.picture(area);
            View::drawn(watch.slowed_title(), picture, shot(lab, watch))
        }
    }
}

const DRAG: &str = "Drag the coin up or down to set the offset.";

/// The note shown in the lab if a link hides the outcome.
const HIDDEN: &str = "The outcome of this hit is hidden until you have predicted it.";

/// The smallest number of rows of a picture with room for the curves.
const ROOM_FOR_CURVES: u16 = 18;

/// The collision with the current settings, with its whole explanation.
fn live_hit(lab: &Lab) -> Watch {
    let layers = Overlays::default().without([Overlay::Triangle, Overlay::Trails]);
    Watch::revealed(lab.settings.setup.collision()).with_layers(layers)
}

/// The area of the collision in the picture: above the curves, if they are drawn.
pub(super) fn hit_area(lab: &Lab, picture: Rect, cx: &Context) -> Rect {
    match lab.is_live(cx) && has_curves(lab, picture) {
        true => areas::upper(picture, picture.height * 11 / 20)[0],
        false => picture,
    }
}

/// Whether there are curves to draw (only for smooth discs and a coin at rest), and room for them.
fn has_curves(lab: &Lab, picture: Rect) -> bool {
    let collision = lab.settings.setup.collision();
    let plain = collision.bond == Bond::Slip && collision.u2 == DVec2::ZERO;
    let plain = plain && collision.rims.friction <= 0.0;
    plain && collision.alpha().is_some() && picture.height >= ROOM_FOR_CURVES
}

/// Draws the collision and, if [`has_curves`] allows it, both speeds against the impact angle.
fn live(lab: &Lab, picture: Rect, buf: &mut Buffer, look: &Look, cx: &Context) {
    let hit = hit_area(lab, picture, cx);
    live_hit(lab).picture(hit).draw(buf, look);
    if hit.height < picture.height {
        let [_, below] = areas::upper(picture, hit.height);
        let collision = lab.settings.setup.collision();
        curves_picture(FigureKind::Curves, &collision, below, look).draw(buf, look);
    }
}

/// The settings, and the quantities that follow from them.
fn settings(lab: &Lab, cx: &Context) -> Panel<LabAction> {
    use LabAction::{Go, Live, Predict};
    let mut panel = Panel::new("settings");
    panel.part(LabAction::Set, |panel| {
        lab.form.write(&lab.settings, panel);
    });
    geometry(lab, &mut panel);
    let live = lab.is_live(cx);
    if live {
        answers(&live_hit(lab), &mut panel);
    }
    panel.worth(1, Panel::gap);
    panel.worth(2, |panel| lab.form.write_about(&lab.settings, panel));
    panel.worth(3, Panel::gap);
    let next = if lab.form.is_typing() {
        vec![("set it", LabAction::Set(SettingsForm::SET))]
    } else if live {
        vec![("watch it", Go), ("live off", Live)]
    } else if lab.hidden {
        panel.paragraph(HIDDEN, Role::Text);
        vec![("now predict both paths", Go)]
    } else if !cx.settings.predict {
        vec![("shoot", Go), ("predict first", Predict)]
    } else if lab.may_live(cx) {
        vec![("predict both paths", Go), ("live", Live)]
    } else {
        vec![("now predict both paths", Go)]
    };
    panel.prompts(next);
    panel
}

/// b/(r₁+r₂), with a note if the discs do not collide.
fn geometry<A>(lab: &Lab, panel: &mut Panel<A>) {
    let setup = &lab.settings.setup;
    let ratio = setup.offset_mm().abs() / setup.contact_distance_mm();
    panel.fact("b / (r₁+r₂)", format!("{ratio:.3}"));
    if setup.collision().normal().is_none() {
        let why = if ratio > 1.0 {
            "above 1: they will miss"
        } else {
            "same velocity: no collision"
        };
        panel.line(why, Role::Warn);
    }
}

/// The two predicted rays.
fn prediction(lab: &Lab, rays: &RayInput) -> Panel<LabAction> {
    let mut panel = Panel::new("predict it");
    given(lab, &mut panel);
    let shown = |field| lab.settings.field(field).shown;
    panel.fact("striker", shown(CollisionField::StrikerMass));
    panel.fact("coin", shown(CollisionField::CoinMass));
    panel.gap();
    panel.heading("Where will they go?");
    panel.part(LabAction::Say, |panel| {
        rays.write_all(panel, "coin", "shoot!");
    });
    panel
}

/// The shot in numbers, the prediction, and the explanation. The explanation is never truncated; if
/// there is not enough room, the numbers that the player set are omitted first.
fn shot(lab: &Lab, watch: &Watch) -> Panel<LabAction> {
    let mut panel = Panel::new("the shot");
    let revealed = watch.is_revealed();
    if !revealed || watch.frame != Frame::Laboratory {
        given(lab, &mut panel);
        panel.gap();
        match watch.frame {
            _ if !revealed => watch.write_explanation(&mut panel),
            Frame::Target => from_target(watch, &mut panel),
            _ => from_centre_of_mass(watch, &mut panel),
        }
        return panel;
    }
    if let Some(coin) = &lab.settings.mystery {
        answers(watch, &mut panel);
        panel.gap();
        panel.part(LabAction::Weigh, |panel| {
            coin.write(&lab.settings.setup, panel);
        });
        return panel;
    }
    panel.worth(1, |panel| {
        given(lab, panel);
        panel.gap();
    });
    answers(watch, &mut panel);
    panel.worth(2, Panel::gap);
    if let Some(observed) = &lab.observed {
        write_observation(watch.collision(), observed, &mut panel);
        panel.gap();
    }
    reason(&explain(watch), &mut panel);
    panel
}

/// The position of the contact.
fn given<A>(lab: &Lab, panel: &mut Panel<A>) {
    for field in [CollisionField::Offset, CollisionField::ImpactAngle] {
        let field = field.field(&lab.settings.setup);
        panel.fact(field.name, field.shown);
    }
    geometry(lab, panel);
}

fn answers<A>(watch: &Watch, panel: &mut Panel<A>) {
    let outcome = watch.outcome();
    let sticks = watch.collision().coalesces();
    let truth = degrees(watch.collision(), &Rays::from(outcome));
    match &watch.said {
        Some(said) => {
            let names = ["striker", "coin"].map(Some);
            said_and_true(watch.collision(), said, names, false, panel);
        }
        None if sticks => panel.coloured_fact("direction of V", shown(truth[0]), Role::StrikerOut),
        None => {
            panel.coloured_fact("striker θ₁", shown(truth[0]), Role::StrikerOut);
            panel.coloured_fact("coin θ₂", shown(truth[1]), Role::CoinOut);
        }
    }
    separation(watch.collision(), panel);
    if outcome.energy_before > 0.0 {
        let kept = 100.0 * outcome.energy_after / outcome.energy_before;
        panel.fact("energy kept", format!("{kept:.1} %"));
    }
    rim_facts(watch.collision(), panel);
}

fn from_centre_of_mass<A>(watch: &Watch, panel: &mut Panel<A>) {
    let collision = watch.collision();
    let outcome = watch.outcome();
    let drift = Frame::CentreOfMass.velocity(collision);
    panel.heading("Centre-of-mass frame");
    panel.fact("V", format!("{:.2} m/s", drift.length()));
    let names = VelocityNames::new(collision, Frame::CentreOfMass);
    let (before, after) = ([collision.u1, collision.u2], collision.centres_after());
    for (body, disc) in ["striker", "coin"].into_iter().enumerate() {
        for (names, velocities) in [(names.before, before), (names.after, after)] {
            let speed = (velocities[body] - drift).length();
            panel.fact(format!("{disc} {}", names[body]), format!("{speed:.2} m/s"));
        }
    }
    if let Some(turned) = collision.cm_deflection()
        && collision.bond == Bond::Slip
    {
        let turned = format!("{:.1}°", turned.to_degrees().abs());
        panel.fact("deflection Θ", turned);
    }
    panel.gap();
    let text = if !collision.coalesces() {
        "Here the discs always move in opposite directions: the total momentum is zero. Add V to \
         both for the laboratory frame."
            .into()
    } else if outcome.energy_rotation > 0.0 {
        format!(
            "The discs stay together. Here their centre of mass is at \
             rest, and they rotate about it {} times a second; the final speeds are those of the \
             two centres. Add V, and the pair moves on, rotating.",
            turns_a_second(outcome)
        )
    } else {
        "The discs stick and stay at rest: the total momentum is zero. \
         Add V, and the pair moves on."
            .into()
    };
    panel.paragraph(text, Role::Text);
}

fn from_target<A>(watch: &Watch, panel: &mut Panel<A>) {
    let seen = Frame::Target.view(watch.collision()).outcome();
    let apart = |angle: f64| format!("{:.1}°", angle.to_degrees());
    let (name, value, text) = match watch.collision().rims.friction > 0.0 {
        _ if watch.collision().coalesces() => (
            "V here",
            format!("{:.2} m/s", seen.v1.length()),
            "Here the coin is at rest at first. The centre of mass moves at V throughout; stuck \
             together, the two can only rotate about it.",
        ),
        true => (
            "separation here",
            seen.separation.map_or("none".into(), apart),
            "Here the coin is at rest before the collision. With smooth rims, equal masses and \
             e = 1 the paths would be at 90° in this frame; friction changes that angle.",
        ),
        false => (
            "separation here",
            seen.separation.map_or("none".into(), apart),
            "Here the coin is at rest before the collision, so the rules for a coin at rest hold: \
             for equal masses and e = 1 the paths are at 90° in this frame.",
        ),
    };
    panel.heading("The coin's frame");
    panel.fact(name, value);
    panel.gap();
    panel.paragraph(text, Role::Text);
}

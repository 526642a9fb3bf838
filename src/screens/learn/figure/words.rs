//! Describes the figure of a page in words, with numbers computed by the engine.

use glam::DVec2;

use super::contact::ContactForce;
use super::parts::EnergyParts;
use super::{LiveFigure, film, momenta};
use crate::lessons::{ChapterPage, CheckpointKind, Expected, FigureKind};
use crate::numbers::{degrees, millimetres, significant, with_unit};
use crate::physics::beam::Beam;
use crate::physics::impact::kinetic_energy;
use crate::physics::units::{g_from_kg, mm_from_m, rad_from_deg};
use crate::physics::{Bond, Collision, CollisionOutcome, CollisionSpec, Disc, Frame, worked};

/// Describes a figure, as the student has set it, in sentences. The outcome is left out while it is
/// hidden; most figures of a collision also leave it out if one of the `later` pages asks for it.
pub(in crate::screens::learn) fn describe(live: &LiveFigure, later: &[ChapterPage]) -> Vec<String> {
    let (shot, collision) = (&live.figure.shot, &live.collision);
    let revealed = !live.hidden;
    let (given, outcome) = match live.figure.kind {
        FigureKind::Foil { .. } => {
            let text = "The figure sends many particles towards a repulsive centre and counts how \
                        many leave in each direction. carrom foil shows this on a screen.";
            return vec![text.into()];
        }
        FigureKind::Shots { space, beyond_deg } => shots(space, beyond_deg),
        FigureKind::Force { time_ms } => force(collision, time_ms),
        kind @ (FigureKind::Coalesce | FigureKind::Explosion { .. }) => {
            momenta_in_words(kind, collision)
        }
        FigureKind::Film { filming } => return film::in_words(collision, filming, revealed),
        FigureKind::Parts => parts_in_words(collision),
        // These figures are text already.
        FigureKind::Worked { .. } | FigureKind::Solve => return Vec::new(),
        kind => {
            let mut lines = vec![format!("Figure: {}", set_up(shot, collision))];
            if revealed {
                lines.push(weighed(collision));
                lines.extend(outcome(kind, collision, is_asked(later, shot)));
            } else {
                lines.extend(plotted(kind, collision));
            }
            return lines;
        }
    };
    let outcome = outcome.into_iter().filter(|_| revealed);
    let given = format!("Figure: {given}");
    [given].into_iter().chain(outcome).collect()
}

/// What a figure shows from the beginning, and the sentences about the outcome.
type GivenAndOutcome = (String, Vec<String>);

/// Whether one of these pages asks for the outcome of this shot.
fn is_asked(later: &[ChapterPage], shot: &CollisionSpec) -> bool {
    later.iter().any(|page| {
        let figure = page.figure.as_ref();
        let in_figure = figure.is_some_and(|figure| figure.shot == *shot);
        match page.checkpoint.as_ref().map(|checkpoint| &checkpoint.asked) {
            Some(CheckpointKind::Rays) => in_figure,
            Some(CheckpointKind::Number { expected, .. }) => match expected {
                Expected::Figure(_) => in_figure,
                Expected::Of(_, of) => of == shot,
                Expected::Fixed(..) => false,
            },
            _ => false,
        }
    })
}

/// The outcome of a collision, as a figure of this kind shows it; only the lines, the components or
/// the plotted values if a later page asks for the outcome (`is_asked`).
fn outcome(kind: FigureKind, collision: &Collision, is_asked: bool) -> Vec<String> {
    match kind {
        FigureKind::Split { lines } => split(collision, lines),
        FigureKind::Curves | FigureKind::Angles | FigureKind::Energy => plotted(kind, collision),
        _ if is_asked => Vec::new(),
        FigureKind::Frames => in_the_centre(collision),
        FigureKind::Triangle { .. } => triangle(collision),
        _ => result(collision),
    }
}

/// The values that a figure plots, which it shows even before the page's question is answered.
fn plotted(kind: FigureKind, collision: &Collision) -> Vec<String> {
    match kind {
        FigureKind::Curves => every_ten(collision, |alpha_deg, outcome| {
            let [v1, v2] = [outcome.v1, outcome.v2].map(speed);
            format!("At α = {alpha_deg}° the striker leaves at {v1} and the other disc at {v2}.")
        }),
        FigureKind::Angles => every_ten(collision, |_, outcome| {
            let angle = |theta: Option<f64>| theta.map(|theta| degrees(theta.abs()));
            match (angle(outcome.theta1), angle(outcome.theta2)) {
                (Some(theta1), Some(theta2)) => {
                    format!("θ₁ = {theta1} corresponds to θ₂ = {theta2}.")
                }
                _ => "Head-on, the striker stops and has no direction.".into(),
            }
        }),
        FigureKind::Energy => every_ten(collision, |alpha_deg, outcome| {
            let share = |disc: Disc, v: DVec2| {
                significant(100.0 * kinetic_energy(disc.mass, v) / outcome.energy_before)
            };
            let kept = share(collision.striker, outcome.v1);
            let taken = share(collision.target, outcome.v2);
            format!(
                "At α = {alpha_deg}° the striker keeps {kept} % of the energy, and the other disc \
                 receives {taken} %."
            )
        }),
        _ => Vec::new(),
    }
}

/// Unaimed shots at a disc at rest; all discs are equal.
fn shots(space: bool, beyond_deg: f64) -> GivenAndOutcome {
    let (beam, over) = match space {
        true => (Beam::Space, "a round target of radius r₁ + r₂"),
        false => (Beam::Board, "a line, from 0 to r₁ + r₂ on either side"),
    };
    let share = beam.share_within(rad_from_deg(beyond_deg).cos());
    let percent = significant(100.0 * share);
    let counted = format!("{percent} % of them are deflected by more than {beyond_deg}°.");
    (format!("shots evenly spread over {over}."), vec![counted])
}

/// The force during a contact as a function of time, and the average and greatest forces of shorter
/// and longer contacts.
fn force(collision: &Collision, time_ms: f64) -> GivenAndOutcome {
    let time = |ms: f64| with_unit(&significant(ms), "ms");
    let lasts = time(time_ms);
    let given = format!("the force of a contact plotted against time, a hump that lasts {lasts}.");
    let impulse = significant(g_from_kg(collision.outcome().impulse));
    let mut outcome = vec![format!(
        "The area under the curve is the impulse, {impulse} g m/s, however long the contact lasts."
    )];
    outcome.extend([0.3, 0.6, 0.9, 1.2, 1.5].map(|ms| {
        let force = ContactForce::new(collision, ms);
        let [average, greatest] = [force.average(), force.greatest()].map(significant);
        let time = time(ms);
        format!(
            "In a contact of {time} the average force is {average} N, the greatest {greatest} N."
        )
    }));
    (given, outcome)
}

/// The given momenta, the result and the energy; for discs that coalesce, also the final speed at
/// several angles between the two momenta.
fn momenta_in_words(kind: FigureKind, collision: &Collision) -> GivenAndOutcome {
    let [given, result, energy] = momenta::words(kind, collision);
    let about = match kind {
        FigureKind::Explosion { .. } => "the momenta of the pieces of a body that explodes",
        _ => "the momenta of two discs before they coalesce, and their sum",
    };
    let mut outcome = vec![format!("{result}; {energy}.")];
    if kind == FigureKind::Coalesce {
        outcome.extend([0, 45, 90, 135, 180].map(|angle| {
            let mut turned = *collision;
            momenta::turn_second(&mut turned, angle.into());
            let v = speed(turned.centre_of_mass_velocity());
            format!("If they move at {angle}° to each other, they move on together at {v}.")
        }));
    }
    (format!("{about}, as arrows tip to tail. {given}."), outcome)
}

/// The two parts of the energy, and what is left of the second at several values of e.
fn parts_in_words(collision: &Collision) -> GivenAndOutcome {
    let all = significant(1e3 * collision.outcome().energy_before);
    let given = format!(
        "the kinetic energy of two discs before the collision, {all} mJ, as a bar in two parts: \
         that of the motion of the centre of mass, and that of the relative motion."
    );
    let outcome = [1.0, 0.75, 0.5, 0.25, 0.0].map(|restitution| {
        let parts = EnergyParts::new(&Collision {
            restitution,
            ..*collision
        });
        let [before, after] = parts.relative.map(significant);
        let [e, kept] = [restitution, parts.of_centre].map(significant);
        format!(
            "At e = {e}, {after} mJ of the {before} mJ of the relative motion remain, and all \
             {kept} mJ of the motion of the centre of mass."
        )
    });
    (given, outcome.into())
}

/// The set-up, as the picture before the collision shows it.
fn set_up(spec: &CollisionSpec, collision: &Collision) -> String {
    let place = match collision.alpha() {
        _ if collision.offset.abs() <= 0.0 => "head-on".to_owned(),
        Some(alpha) if !spec.is_by_offset() => {
            let alpha = degrees(alpha.abs());
            format!("with the line of impact at {alpha} to its path")
        }
        _ => {
            let b = millimetres(mm_from_m(collision.offset.abs()));
            format!("with an offset of b = {b}")
        }
    };
    let target = match collision.u2.length() > 0.0 {
        true => format!("one that moves at {}", speed(collision.u2)),
        false => "one at rest".to_owned(),
    };
    let u1 = speed(collision.u1);
    format!("a disc moves at {u1} towards {target}, {place}.")
}

/// The properties that no picture shows: the masses, and the kind of contact.
fn weighed(collision: &Collision) -> String {
    let [m1, m2] = [collision.striker, collision.target]
        .map(|disc| with_unit(&significant(g_from_kg(disc.mass)), "g"));
    let contact = match collision.bond {
        Bond::Stick => "They coalesce.".to_owned(),
        Bond::Slip if collision.restitution < 1.0 => {
            format!("e = {}.", significant(collision.restitution))
        }
        Bond::Slip if collision.rims.friction > 0.0 => "e = 1.".to_owned(),
        Bond::Slip => "No energy is lost.".to_owned(),
    };
    let rims = rims(collision);
    format!("The first disc has a mass of {m1}, the other {m2}. {contact}{rims}")
}

/// The coefficient of friction between the rims, and the spins; empty if there is neither friction
/// nor spin.
fn rims(collision: &Collision) -> String {
    if collision.rims.is_plain() {
        return String::new();
    }
    let friction = significant(collision.rims.friction);
    let spins = match collision.rims.spins {
        [0.0, 0.0] => "Neither disc spins before the collision.".to_owned(),
        spins => {
            let [one, other] = spins.map(significant);
            format!("They spin at {one} and {other} rad/s, positive anticlockwise.")
        }
    };
    format!(" The coefficient of friction between the rims is {friction}. {spins}")
}

/// The outcome, as the worked solution summarizes it.
fn result(collision: &Collision) -> Vec<String> {
    let last = worked::steps(collision, false).pop();
    last.map(|step| step.why).into_iter().collect()
}

fn speed(v: DVec2) -> String {
    with_unit(&significant(v.length()), "m/s")
}

/// A line of text for every ten degrees of the impact angle, from head-on to nearly grazing.
fn every_ten(
    collision: &Collision,
    line: impl Fn(u32, &CollisionOutcome) -> String,
) -> Vec<String> {
    let revealed = |alpha_deg: u32| {
        let alpha = rad_from_deg(alpha_deg.into());
        line(alpha_deg, &collision.with_alpha(alpha).outcome())
    };
    (0..90).step_by(10).map(revealed).collect()
}

/// The lines at the contact if only the `lines` are shown, otherwise the two components of the
/// striker's velocity.
fn split(collision: &Collision, lines: bool) -> Vec<String> {
    let Collision { u1, .. } = collision;
    let outcome = collision.outcome();
    let (Some(n), Some(t)) = (outcome.normal, outcome.tangent) else {
        return Vec::new();
    };
    let [along, across] = [n, t].map(|axis| significant(u1.dot(axis).abs()));
    vec![match lines {
        true => {
            "Two lines run through the point where the rims touch: n through both centres, and \
                 t along the rims, at right angles to n."
                .into()
        }
        false => format!(
            "The striker's velocity has components of {along} m/s along the line of impact and \
             {across} m/s perpendicular to it."
        ),
    }]
}

fn triangle(collision: &Collision) -> Vec<String> {
    let outcome = collision.outcome();
    let [m1, m2] = [collision.striker.mass, collision.target.mass];
    let sides = [
        m1 * collision.u1.length(),
        m1 * outcome.v1.length(),
        m2 * outcome.v2.length(),
    ];
    let [before, striker, target] = sides.map(|momentum| significant(1e3 * momentum));
    let momenta = format!(
        "The momenta form a triangle: {before} g m/s before; afterwards {striker} g m/s for the \
         striker and {target} g m/s for the other disc."
    );
    let apart = outcome.separation.map(degrees);
    let apart = apart.map(|angle| format!("The angle between the two paths is {angle}."));
    [momenta].into_iter().chain(apart).collect()
}

fn in_the_centre(collision: &Collision) -> Vec<String> {
    let centre = Frame::CentreOfMass.view(collision);
    let outcome = centre.outcome();
    let drift = speed(collision.centre_of_mass_velocity());
    let [u1, u2, v1, v2] =
        [centre.u1, centre.u2, outcome.v1, outcome.v2].map(|v| significant(v.length()));
    let came = format!(
        "The centre of mass moves at {drift} throughout. In its frame the discs approach at {u1} \
         and {u2} m/s from opposite sides, and"
    );
    let mut lines = result(collision);
    if collision.coalesces() {
        lines.push(format!("{came} stay together."));
        return lines;
    }
    lines.push(format!(
        "{came} leave at {v1} and {v2} m/s in opposite directions."
    ));
    if let Some(turn) = outcome.theta1.filter(|_| outcome.v1.length() > 1e-9) {
        let turn = degrees(turn.abs());
        lines.push(format!("Both are deflected by Θ = {turn}."));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lessons::Figure;
    use crate::screens::learn::figure::FigureAction;

    #[test]
    fn the_description_follows_what_the_student_sets() {
        for (words, action, before, after) in [
            (
                "curves alpha_deg=30",
                FigureAction::Alpha(20),
                "30.0°",
                "50.0°",
            ),
            (
                "force time_ms=0.6",
                FigureAction::Dial(3),
                "0.600 ms",
                "0.900 ms",
            ),
        ] {
            let mut live = LiveFigure::new(Figure::from_words(words).unwrap(), None, false);
            let first = |live: &LiveFigure| describe(live, &[]).swap_remove(0);
            assert!(first(&live).contains(before), "{}", first(&live));
            live.act(action);
            assert!(first(&live).contains(after), "{}", first(&live));
        }
    }
}

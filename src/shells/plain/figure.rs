//! What the figure of a page shows, in words, computed by the engine.

use crate::lessons::{Figure, FigureKind};
use crate::physics::beam::Beam;
use crate::physics::units::{deg_from_rad, g_from_kg, mm_from_m, rad_from_deg};
use crate::physics::worked::{self, Given};
use crate::physics::{Bond, Collision, Frame, Meeting, Outcome};
use crate::quiz::words::{degrees, millimetres, significant};

/// What a figure shows, a line each. Before it may be `told` that is only how the hit is
/// set up.
pub(super) fn describe(figure: &Figure, told: bool) -> Vec<String> {
    let collision = figure.shot.collision();
    let outcome = collision.outcome();
    let set_up = set_up(&collision);
    match figure.kind {
        FigureKind::Foil { .. } => {
            return vec![
                "The figure throws many particles at a centre that repels them, and counts where \
                 they go. carrom foil does so on a screen."
                    .into(),
            ];
        }
        FigureKind::Shots { space, beyond_deg } => return shots(space, beyond_deg, told),
        FigureKind::Worked { blank } => {
            let shown = blank.filter(|_| !told).map(|step| step - 1);
            return working(&collision, figure.shot.is_by_offset(), shown);
        }
        FigureKind::Solve => return working(&collision, figure.shot.is_by_offset(), None),
        _ => {}
    }
    let mut lines = vec![format!("Figure: {set_up}")];
    lines.extend(match figure.kind {
        FigureKind::Curves => every_ten(&collision, |alpha_deg, outcome| {
            format!(
                "At α = {alpha_deg}° the striker leaves with {} m/s and the other disc with {} m/s.",
                significant(outcome.v1.length()),
                significant(outcome.v2.length())
            )
        }),
        FigureKind::Angles => every_ten(&collision, |_, outcome| {
            match (outcome.theta1, outcome.theta2) {
                (Some(theta1), Some(theta2)) => format!(
                    "θ₂ = {} goes with θ₁ = {}.",
                    degrees(theta2.abs()),
                    degrees(theta1.abs())
                ),
                _ => "Head-on the striker stops, and has no angle.".into(),
            }
        }),
        FigureKind::Energy => every_ten(&collision, |alpha_deg, outcome| {
            let share = |mass: f64, speed: f64| {
                significant(100.0 * 0.5 * mass * speed * speed / outcome.energy_before)
            };
            format!(
                "At α = {alpha_deg}° the striker keeps {} % of the energy, the other disc takes {} %.",
                share(collision.striker.mass, outcome.v1.length()),
                share(collision.target.mass, outcome.v2.length())
            )
        }),
        _ if !told => Vec::new(),
        FigureKind::Frames => in_the_centre(&collision),
        FigureKind::Split => split(&collision, &outcome),
        FigureKind::Triangle { .. } => triangle(&collision, &outcome),
        _ => result(&collision),
    });
    lines
}

/// Shots that nobody aimed, between equal discs.
fn shots(space: bool, beyond_deg: f64, told: bool) -> Vec<String> {
    let (beam, over) = if space {
        (Beam::Space, "a round target of radius r₁ + r₂")
    } else {
        (Beam::Board, "a line, from 0 to r₁ + r₂ on either side")
    };
    let mut lines = vec![format!("Figure: shots evenly spread over {over}.")];
    if told {
        let share = beam.share_within(rad_from_deg(beyond_deg).cos());
        lines.push(format!(
            "{} % of them are turned by more than {beyond_deg}°.",
            significant(100.0 * share)
        ));
    }
    lines
}

/// How the hit is set up.
fn set_up(collision: &Collision) -> String {
    let (m1, m2) = (
        g_from_kg(collision.striker.mass),
        g_from_kg(collision.target.mass),
    );
    let place = match collision.alpha() {
        _ if collision.offset.abs() <= 0.0 => "head-on".to_owned(),
        Some(alpha) => format!(
            "with the line of impact at {} to its path",
            degrees(alpha.abs())
        ),
        None => format!(
            "and misses it: the offset is {}",
            millimetres(mm_from_m(collision.offset.abs()))
        ),
    };
    let target = match collision.u2.length() {
        speed if speed > 0.0 => format!(
            "one of {} g that moves at {} m/s",
            significant(m2),
            significant(speed)
        ),
        _ => format!("one of {} g at rest", significant(m2)),
    };
    let contact = match collision.bond {
        Bond::Stick => "They stick together.".to_owned(),
        Bond::Slip if collision.restitution < 1.0 => {
            format!("e = {}.", significant(collision.restitution))
        }
        Bond::Slip => "No energy is lost.".to_owned(),
    };
    format!(
        "a disc of {} g comes at {} m/s to {target}, {place}. {contact}",
        significant(m1),
        significant(collision.u1.length())
    )
}

/// What becomes of it, as the worked solution sums it up.
fn result(collision: &Collision) -> Vec<String> {
    let steps = worked::steps(collision, Given::Angle);
    steps
        .into_iter()
        .next_back()
        .map(|step| step.why)
        .into_iter()
        .collect()
}

/// The steps of the worked solution, or the first so many of them.
fn working(collision: &Collision, by_offset: bool, shown: Option<usize>) -> Vec<String> {
    let given = if by_offset {
        Given::Offset
    } else {
        Given::Angle
    };
    let steps = worked::steps(collision, given);
    let shown = shown.unwrap_or(steps.len()).min(steps.len());
    let each = (1..).zip(&steps[..shown]);
    each.flat_map(|(number, step)| {
        let head = format!("Step {number}: {}. {}", step.title, step.why);
        std::iter::once(head).chain(step.lines.iter().cloned())
    })
    .collect()
}

/// A line every ten degrees of the impact angle, from head-on to nearly a graze.
fn every_ten(collision: &Collision, line: impl Fn(u32, &Outcome) -> String) -> Vec<String> {
    (0..9)
        .map(|tens| {
            let alpha_deg = 10 * tens;
            let outcome = collision
                .with_alpha(rad_from_deg(f64::from(alpha_deg)))
                .outcome();
            line(alpha_deg, &outcome)
        })
        .collect()
}

fn split(collision: &Collision, outcome: &Outcome) -> Vec<String> {
    let (Some(n), Some(t)) = (outcome.normal, outcome.tangent) else {
        return Vec::new();
    };
    let part = |v: glam::DVec2, axis: glam::DVec2| significant(v.dot(axis).abs());
    let mut lines = vec![format!(
        "Of the striker's velocity {} m/s lie along the line of impact and {} m/s across it.",
        part(collision.u1, n),
        part(collision.u1, t)
    )];
    lines.extend(result(collision));
    lines
}

fn triangle(collision: &Collision, outcome: &Outcome) -> Vec<String> {
    let sides = [
        collision.striker.mass * collision.u1.length(),
        collision.striker.mass * outcome.v1.length(),
        collision.target.mass * outcome.v2.length(),
    ];
    let [before, striker, target] = sides.map(|momentum| significant(1e3 * momentum));
    let mut lines = vec![format!(
        "The momenta make a triangle: {before} g m/s before, and after it {striker} g m/s of the \
         striker and {target} g m/s of the other disc."
    )];
    if let Some(separation) = outcome.separation {
        lines.push(format!(
            "The angle between the two paths is {}.",
            degrees(separation)
        ));
    }
    lines
}

fn in_the_centre(collision: &Collision) -> Vec<String> {
    let centre = Frame::CentreOfMass.view(collision);
    let outcome = centre.outcome();
    let mut lines = result(collision);
    if collision.bond == Bond::Stick && outcome.meeting == Meeting::Hit {
        lines.push(format!(
            "The centre of mass moves at {} m/s all the while. Seen from there the discs come with \
             {} and {} m/s from opposite sides, and stay.",
            significant(collision.centre_of_mass_velocity().length()),
            significant(centre.u1.length()),
            significant(centre.u2.length())
        ));
        return lines;
    }
    lines.push(format!(
        "The centre of mass moves at {} m/s all the while. Seen from there the discs come with {} \
         and {} m/s from opposite sides, and leave with {} and {} m/s, back to back.",
        significant(collision.centre_of_mass_velocity().length()),
        significant(centre.u1.length()),
        significant(centre.u2.length()),
        significant(outcome.v1.length()),
        significant(outcome.v2.length())
    ));
    let turn = centre
        .u1
        .perp_dot(outcome.v1)
        .atan2(centre.u1.dot(outcome.v1));
    if outcome.v1.length() > 1e-9 {
        lines.push(format!(
            "Both are turned by Θ = {:.1}°.",
            deg_from_rad(turn).abs()
        ));
    }
    lines
}

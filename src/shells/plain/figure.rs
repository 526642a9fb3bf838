//! What the figure of a page shows, in words, computed by the engine.

use super::spoken::sentence;
use crate::lessons::{Chapter, ChapterPage, CheckpointKind, Expected, Figure, FigureKind};
use crate::numbers::{degrees, millimetres, significant};
use crate::physics::beam::Beam;
use crate::physics::units::{deg_from_rad, g_from_kg, mm_from_m, rad_from_deg};
use crate::physics::{Bond, Collision, CollisionOutcome, Frame, Meeting};
use crate::physics::{CollisionSpec, worked};

/// What the figure of a page shows, a line each; before the page's question is
/// `answered`, and where a later page asks for it, no more than how the hit is set up.
pub(super) fn describe(chapter: &Chapter, at: usize, answered: bool) -> Vec<String> {
    let Some((page, figure)) = chapter
        .pages
        .get(at)
        .and_then(|page| Some((page, page.figure.as_ref()?)))
    else {
        return Vec::new();
    };
    let told = answered || page.checkpoint.is_none();
    let figure = &Figure {
        shot: if told { figure.after } else { figure.shot },
        ..*figure
    };
    let later = chapter.pages.get(at + 1..).unwrap_or_default();
    let collision = figure.shot.collision();
    match figure.kind {
        FigureKind::Foil { .. } => vec![
            "The figure throws many particles at a centre that repels them, and counts where they \
             go. carrom foil does so on a screen."
                .into(),
        ],
        FigureKind::Shots { space, beyond_deg } => shots(space, beyond_deg, told),
        FigureKind::Worked { blank } => {
            let blank = match told {
                true => next_blank(later, &figure.shot),
                false => blank,
            };
            let steps = working(&collision, figure);
            let shown = blank.map_or(steps.len(), |step| step - 1);
            steps.into_iter().take(shown).flatten().collect()
        }
        FigureKind::Solve => working(&collision, figure).concat(),
        kind => {
            let mut lines = vec![format!("Figure: {}", set_up(figure, &collision))];
            if told {
                lines.push(weighed(&collision));
                lines.extend(outcome(kind, &collision, is_asked(later, &figure.shot)));
            } else {
                lines.extend(plotted(kind, &collision));
            }
            lines
        }
    }
}

/// Whether one of these pages asks what becomes of a shot.
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

/// The first step of a shot's worked solution that one of these pages leaves blank.
fn next_blank(later: &[ChapterPage], shot: &CollisionSpec) -> Option<usize> {
    later.iter().find_map(|page| {
        let figure = page.figure.as_ref().filter(|figure| figure.shot == *shot)?;
        match figure.kind {
            FigureKind::Worked { blank } => blank.filter(|_| page.checkpoint.is_some()),
            _ => None,
        }
    })
}

/// What becomes of a hit, as a figure of this kind tells it; of what `is_asked` later
/// only what is drawn of the hit itself.
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

/// What a figure plots against the impact angle, whatever is asked beside it.
fn plotted(kind: FigureKind, collision: &Collision) -> Vec<String> {
    match kind {
        FigureKind::Curves => every_ten(collision, |alpha_deg, outcome| {
            format!(
                "At α = {alpha_deg}° the striker leaves with {} m/s and the other disc with {} m/s.",
                significant(outcome.v1.length()),
                significant(outcome.v2.length())
            )
        }),
        FigureKind::Angles => every_ten(collision, |_, outcome| {
            match (outcome.theta1, outcome.theta2) {
                (Some(theta1), Some(theta2)) => format!(
                    "θ₂ = {} goes with θ₁ = {}.",
                    degrees(theta2.abs()),
                    degrees(theta1.abs())
                ),
                _ => "Head-on the striker stops, and has no angle.".into(),
            }
        }),
        FigureKind::Energy => every_ten(collision, |alpha_deg, outcome| {
            let share = |mass: f64, speed: f64| {
                significant(100.0 * 0.5 * mass * speed * speed / outcome.energy_before)
            };
            format!(
                "At α = {alpha_deg}° the striker keeps {} % of the energy, the other disc takes {} %.",
                share(collision.striker.mass, outcome.v1.length()),
                share(collision.target.mass, outcome.v2.length())
            )
        }),
        _ => Vec::new(),
    }
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

/// How the hit is set up, as far as the picture before it shows.
fn set_up(figure: &Figure, collision: &Collision) -> String {
    let place = match collision.alpha() {
        _ if collision.offset.abs() <= 0.0 => "head-on".to_owned(),
        Some(alpha) if !figure.shot.is_by_offset() => format!(
            "with the line of impact at {} to its path",
            degrees(alpha.abs())
        ),
        _ => format!(
            "with its path at b = {} beside the other\'s centre",
            millimetres(mm_from_m(collision.offset.abs()))
        ),
    };
    let target = match collision.u2.length() {
        speed if speed > 0.0 => format!("one that moves at {} m/s", significant(speed)),
        _ => "one at rest".to_owned(),
    };
    format!(
        "a disc comes at {} m/s to {target}, {place}.",
        significant(collision.u1.length())
    )
}

/// What no picture shows of the two: their masses, and how they push.
fn weighed(collision: &Collision) -> String {
    let [m1, m2] = [collision.striker, collision.target].map(|disc| {
        let mass_g = g_from_kg(disc.mass);
        format!("{} g", significant(mass_g))
    });
    let contact = match collision.bond {
        Bond::Stick => "They stick together.".to_owned(),
        Bond::Slip if collision.restitution < 1.0 => {
            format!("e = {}.", significant(collision.restitution))
        }
        Bond::Slip => "No energy is lost.".to_owned(),
    };
    format!("The first has {m1}, the other one {m2}. {contact}")
}

/// What becomes of it, as the worked solution sums it up.
fn result(collision: &Collision) -> Vec<String> {
    let steps = worked::steps(collision, false);
    steps
        .into_iter()
        .next_back()
        .map(|step| step.why)
        .into_iter()
        .collect()
}

/// The steps of the worked solution, each in lines.
fn working(collision: &Collision, figure: &Figure) -> Vec<Vec<String>> {
    let by_offset = figure.shot.is_by_offset();
    let each = (1..).zip(worked::steps(collision, by_offset));
    each.map(|(number, step)| {
        let head = format!("Step {number}: {} {}", sentence(step.title), step.why);
        std::iter::once(head).chain(step.lines).collect()
    })
    .collect()
}

/// A line every ten degrees of the impact angle, from head-on to nearly a graze.
fn every_ten(
    collision: &Collision,
    line: impl Fn(u32, &CollisionOutcome) -> String,
) -> Vec<String> {
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

/// The lines at the contact, and unless it is these `lines` alone, the two parts of the
/// striker's velocity.
fn split(collision: &Collision, lines: bool) -> Vec<String> {
    let Collision { u1, .. } = collision;
    let outcome = collision.outcome();
    let (Some(n), Some(t)) = (outcome.normal, outcome.tangent) else {
        return Vec::new();
    };
    let part = |axis: glam::DVec2| significant(u1.dot(axis).abs());
    match lines {
        true => vec![
            "Two lines run through the point where the rims touch: n through both centres, and t \
             along the rims, square to n."
                .into(),
        ],
        false => vec![format!(
            "Of the striker's velocity {} m/s lie along the line of impact and {} m/s across it.",
            part(n),
            part(t)
        )],
    }
}

fn triangle(collision: &Collision) -> Vec<String> {
    let outcome = collision.outcome();
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

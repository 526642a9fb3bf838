//! A beam, counted by angle while it runs.

use std::f64::consts::PI;

use glam::{DVec2, dvec2};
use ratatui::layout::Rect;

use super::setup::{FoilSetup, Obstacle};
use super::{FoilAction, FoilScreen, cautions, guess, words};
use crate::beams::{BIN_WIDTH, BINS, BeamTarget, CountedFor, Counts, ScatteringLaw};
use crate::physics::beam::Beam;
use crate::physics::rutherford::FM;
use crate::quiz::{Response, letter};
use crate::screens::Context;
use crate::widgets::flow::Run;
use crate::widgets::input::SettingsForm;
use crate::widgets::panel::Panel;
use crate::widgets::picture::{LabelSide, Pen, Picture};
use crate::widgets::plot::{Axis, Plot};
use crate::widgets::{AnswerAction, AnswerInput, Look, Role};

/// The title of the picture: the target and, in three dimensions, the unit of the counts.
pub(super) fn title(foil: &FoilScreen) -> &'static str {
    use CountedFor::{Ring, Steradian};
    match (foil.fields.setup.obstacle, foil.fields.setup.counted_for()) {
        (Obstacle::Hard, None) => "hard discs on a board",
        (Obstacle::Hard, Some(Steradian)) => "hard spheres: counts on a small screen",
        (Obstacle::Hard, Some(Ring)) => "hard spheres: counts in whole rings",
        (Obstacle::Nucleus, None) => "a foil in two dimensions",
        (Obstacle::Nucleus, Some(Steradian)) => "a foil: counts on a small screen",
        (Obstacle::Nucleus, Some(Ring)) => "a foil: counts in whole rings",
    }
}

/// The label of the axis of the counts.
fn name_of_counts(counted_for: Option<CountedFor>) -> &'static str {
    match counted_for {
        None => "particles in each 5°",
        Some(CountedFor::Ring) => "particles in each ring of 5°",
        Some(CountedFor::Steradian) => "particles per steradian",
    }
}

/// The counts and, once there are any, the law's curve.
pub(super) fn picture(foil: &FoilScreen, area: Rect, look: Look) -> Picture {
    let law = foil.fields.setup.law();
    let particles = foil.fields.setup.particles();
    let name = name_of_counts(foil.fields.setup.counted_for());
    // On a board every bin covers the same angle, so its counts need no correction for the size of
    // the ring.
    let counted_for = foil.fields.setup.counted_for().unwrap_or(CountedFor::Ring);
    let most = Counts::expected(&law, particles)
        .into_iter()
        .enumerate()
        .map(|(bin, expected)| expected / counted_for.in_bin(bin))
        .fold(1.0, f64::max);
    let angle = Axis::linear("scattering angle Θ (°)", 0.0, 180.0).every(30.0);
    let (count, top) = if foil.is_log() {
        (Axis::log(name, 0.5, 2.0 * most), 2.0 * most)
    } else {
        (Axis::linear(name, 0.0, 1.15 * most), 1.15 * most)
    };
    let mut plot = Plot::new(area, look, angle, count);
    if let Some(run) = &foil.run {
        let degrees = |bin: usize| (bin as f64 * BIN_WIDTH).to_degrees();
        for (bin, count) in run.counts.bins.iter().enumerate() {
            let height = *count as f64 / counted_for.in_bin(bin);
            plot.bar(degrees(bin), degrees(bin + 1), height, Role::Trail);
        }
        // Where almost no counts are expected there is no line, because it would coincide with the
        // axis. Near 0° the law can exceed the top of the plot.
        let least = plot.least_clear();
        let thrown = run.thrown();
        let expected = |at| {
            expected_at(&law, counted_for, thrown, at).filter(|count| (least..=top).contains(count))
        };
        plot.function(expected, Pen::new(Role::StrikerOut));
        use LabelSide::{Above, AboveLeft, AboveRight, Right};
        let sides = [AboveRight, Above, AboveLeft, Right];
        let places = label_places(expected);
        plot.label_along("the law", places, &sides, Role::StrikerOut);
    }
    plot.picture()
}

/// The number of particles expected at an angle in degrees: for counts per steradian, the law
/// itself; for a ring, its integral over ±2.5°, so that the curve passes through the expected count
/// at the middle of each bin.
pub(super) fn expected_at(
    law: &ScatteringLaw,
    counted_for: CountedFor,
    thrown: u64,
    degrees: f64,
) -> Option<f64> {
    let at = degrees.to_radians();
    let half = BIN_WIDTH / 2.0;
    let share = match counted_for {
        CountedFor::Steradian => law.share_per_steradian(at)?,
        CountedFor::Ring if at < half - 1e-9 || at > PI - half + 1e-9 => return None,
        CountedFor::Ring => law.share_beyond(at - half) - law.share_beyond((at + half).min(PI)),
    };
    Some(thrown as f64 * share)
}

/// Possible positions of the curve's label, from just past the middle of the curve to its
/// beginning.
fn label_places(expected: impl Fn(f64) -> Option<f64>) -> impl Iterator<Item = DVec2> {
    let places = (0..20).map(|bin| 97.5 - 5.0 * f64::from(bin));
    places.filter_map(move |at| Some(dvec2(at, expected(at)?)))
}

/// Writes the question before a beam.
pub(super) fn write_guess(foil: &FoilScreen, said: &AnswerInput, panel: &mut Panel<FoilAction>) {
    panel.heading("Predict it:");
    let question = "how many are deflected by more than 90°?";
    panel.paragraph(question, Role::Title);
    let setup = &foil.fields.setup;
    let thrown_at = match setup.obstacle {
        Obstacle::Hard => format!("(of all that hit a {})", setup.obstacle_name()),
        Obstacle::Nucleus => {
            format!("({:.2} µm of {})", setup.thickness_um, setup.metal().name)
        }
    };
    panel.line(thrown_at, Role::Dim);
    panel.gap();
    for (i, (name, _)) in guess::CHOICES.iter().enumerate() {
        let is_said = said.said() == Some(Response::Choice(i));
        let text = vec![Run::new(*name, Role::Text)];
        let say = FoilAction::Guess(AnswerAction::Choose(i));
        panel.choice(letter(i), text, is_said, say);
    }
    panel.gap();
    match said.said() {
        Some(_) => panel.prompt("predict and start", FoilAction::Guess(AnswerAction::Enter)),
        None => panel.paragraph("Choose an answer.", Role::Key),
    }
}

/// Writes the text below the settings.
pub(super) fn write(foil: &FoilScreen, panel: &mut Panel<FoilAction>, cx: &Context) {
    panel.gap();
    let Some(run) = &foil.run else {
        use FoilAction::{Predict, Throw};
        panel.prompts(match cx.settings.predict {
            _ if foil.form.is_typing() => vec![("set it", FoilAction::Set(SettingsForm::SET))],
            true => vec![("predict the result, then start", Throw)],
            false => vec![("start the beam", Throw), ("predict first", Predict)],
        });
        panel.gap();
        cautions::write(&foil.fields.setup, panel);
        panel.paragraph(about(&foil.fields.setup), Role::Text);
        return;
    };
    let share = run.thrown() as f64 / run.particles as f64;
    panel.meter("", share, format!("{:.0} %", (100.0 * share).floor()));
    let state = match (run.is_over(), run.is_running()) {
        (true, _) => "sent",
        (false, true) => "sent so far",
        (false, false) => "stopped at",
    };
    panel.fact(state, words::count(run.thrown()));
    panel.gap();
    let share = run.law.share_beyond(PI / 2.0);
    panel.line("deflected by over 90°:", Role::Dim);
    panel.fact("counted", words::count(run.counts.beyond_bin(BINS / 2)));
    let counted = run.share_turned_back().map_or("none".into(), words::share);
    panel.fact("share", counted);
    panel.coloured_fact("the law", words::share(share), Role::StrikerOut);
    if run.is_running() {
        return;
    }
    panel.gap();
    if let Some(said) = run.said {
        panel.paragraph(guess::explain(said, share), Role::Title);
    }
    panel.paragraph(reason(&run.law, share), Role::Text);
    panel.gap();
    cautions::write(&foil.fields.setup, panel);
    // The standard deviation, √(n p (1 − p)), of a count out of n particles, each with this
    // probability p.
    let chance = (run.thrown() as f64 * share * (1.0 - share)).sqrt();
    let chance = words::count(words::rounded(chance.max(1.0)) as u64);
    let text =
        format!("By chance alone this count varies by about {chance} from one beam to the next.");
    panel.paragraph(text, Role::Dim);
}

/// The description of a beam before it starts.
fn about(setup: &FoilSetup) -> &'static str {
    match (setup.obstacle, setup.beam) {
        (Obstacle::Hard, Beam::Board) => "Every offset along the line up to R is equally likely.",
        (Obstacle::Hard, Beam::Space) => {
            "Every point of the target's circular face is equally likely: there is more area far \
             out than near the middle."
        }
        (Obstacle::Nucleus, Beam::Board) => {
            "As on a board, every offset along a line is equally likely."
        }
        (Obstacle::Nucleus, Beam::Space) => {
            "Nobody can aim at a nucleus. Each particle passes through some point of the foil, and \
             the nearest nucleus deflects it."
        }
    }
}

/// Explains why this share of the particles is deflected by more than 90°.
fn reason(law: &ScatteringLaw, share: f64) -> String {
    let nearness = law.nearness(PI / 2.0);
    match (law.target, law.beam) {
        (BeamTarget::Hard, Beam::Board) => format!(
            "Offsets below R cos 45° = {nearness:.3} R turn a particle back. On a line they \
             are {} of all.",
            words::share(share)
        ),
        (BeamTarget::Hard, Beam::Space) => format!(
            "Offsets below R cos 45° = {nearness:.3} R turn a particle back. In space offsets fill \
             a disc, and this fraction of the radius has {nearness:.3}² = {} of the area. Spheres \
             scatter equally in all directions: on a small screen the counts are equal, and whole \
             rings count most at 90° only because that ring is the largest.",
            words::share(share)
        ),
        (BeamTarget::Coulomb { half_width, .. }, beam) => {
            let near = nearness * half_width / FM;
            let room = words::count(words::rounded(half_width / FM) as u64);
            let power = if beam == Beam::Space { "²" } else { "" };
            format!(
                "Only particles aimed within d/2 = {near:.1} fm of a nucleus turn back. But each \
                 nucleus has {room} fm of room around it: ({near:.1}/{room}){power} is {}.",
                words::share(share)
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_passes_through_the_expected_count_of_each_bin() {
        for obstacle in [Obstacle::Hard, Obstacle::Nucleus] {
            for beam in [Beam::Board, Beam::Space] {
                let law = FoilSetup {
                    obstacle,
                    beam,
                    ..FoilSetup::default()
                }
                .law();
                let expected = Counts::expected(&law, 1000);
                let on_curve = |middle| expected_at(&law, CountedFor::Ring, 1000, middle);
                for (bin, expected) in expected.into_iter().enumerate() {
                    let on_curve = on_curve((bin as f64 + 0.5) * 5.0).unwrap();
                    assert!((on_curve - expected).abs() < 1e-9 * expected.max(1e-3));
                }
                assert_eq!(on_curve(0.0), None);
            }
        }
    }
}

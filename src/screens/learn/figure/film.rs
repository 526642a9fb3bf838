//! Measurements from a simulated film of the collision; the student sets how well it is filmed.

use std::sync::Arc;

use glam::{DVec2, dvec2};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::FigureArea;
use crate::lessons::{FilmSetting, Filming};
use crate::measure::{Camera, Given, Measurement, Model, SlowingDown, State};
use crate::numbers::short;
use crate::physics::Collision;
use crate::physics::units::{m_from_mm, rad_from_deg};
use crate::widgets::picture::{Picture, View};
use crate::widgets::{Lines, Role, measured_picture, points_picture};

/// The length of the striker's path before the contact, in metres; the film has as many frames
/// after the contact as before it.
const REACH: f64 = 0.35;
/// The time from the last frame before the contact to the contact itself, as a fraction of the time
/// between two frames.
const WITHIN: f64 = 0.37;
/// The rows below the picture, enough for the longest verdict in the narrowest figure.
const ROWS: u16 = 7;

/// A film and its measurement.
#[derive(Debug, Clone)]
pub(super) struct FilmFigure {
    filming: Filming,
    /// The measurement, or why there is none.
    measured: Result<Arc<Measurement>, String>,
}

impl FilmFigure {
    /// Films and measures a collision. The noise always has the same seed, so only the setting
    /// changes the results.
    pub(super) fn new(collision: &Collision, filming: Filming) -> Self {
        let outcome = collision.outcome();
        let seconds = REACH / collision.u1.length().max(0.01);
        let before = (filming.rate * seconds).floor().max(1.0);
        let (first, second) = collision.placed_at_contact();
        let truth = State::new(
            (before - 1.0 + WITHIN) / filming.rate,
            [first, second],
            [[collision.u1, outcome.v1], [collision.u2, outcome.v2]],
            [0.0; 2],
        );
        let camera = Camera {
            rate: filming.rate,
            frames: 2 * before as usize,
            noise: DVec2::splat(m_from_mm(filming.noise_mm)),
        };
        let mut random = Pcg64Mcg::seed_from_u64(17);
        let names = ["striker", "coin"];
        let mut tracks = camera.tracks(&truth, &Model::default(), names, &mut random);
        let scale = 1.0 + 0.01 * filming.scale_percent;
        let seen = scale * dvec2(1.0, rad_from_deg(filming.tilt_deg).cos());
        for point in tracks.iter_mut().flat_map(|track| &mut track.points) {
            point.at *= seen;
        }
        let given = Given {
            masses: Some(collision.discs().map(|disc| disc.mass)),
            restitution: collision.restitution,
            slowing: SlowingDown::Never,
            ..Given::default()
        };
        let measured = Measurement::new(tracks, given);
        Self {
            filming,
            measured: measured.map(Arc::new).map_err(|it| it.to_string()),
        }
    }

    /// How the collision was filmed. While the outcome is `hidden`, so is the error of the scale,
    /// because it is the answer to a question.
    fn film(&self, hidden: bool) -> String {
        let it = &self.filming;
        let [rate, noise, tilt] = [it.rate, it.noise_mm, it.tilt_deg].map(|of| short(of, 1));
        let mut text = format!("{rate} frames/s, noise {noise} mm");
        let has_scale = it.scale_percent.abs() > 0.0 || it.sets == FilmSetting::Scale;
        if has_scale && !hidden {
            let sign = if it.scale_percent > 0.0 { "+" } else { "" };
            text += &format!(", scale {sign}{} %", short(it.scale_percent, 1));
        }
        if it.tilt_deg > 0.0 || it.sets == FilmSetting::Tilt {
            text += &format!(", tilt {tilt}°");
        }
        text
    }

    fn results(&self) -> Vec<String> {
        let measurement = match &self.measured {
            Ok(measurement) => measurement,
            Err(reason) => return vec![reason.clone()],
        };
        let first = measurement.sentences().into_iter().take(1);
        let [e, u1] = ["restitution", "u1"].map(|id| measurement.printed(id));
        first.chain([format!("e = {e}, u₁ = {u1}")]).collect()
    }

    fn write(&self, hidden: bool, lines: &mut Lines) {
        lines.paragraph(&self.film(hidden), Role::Dim);
        if !hidden {
            for line in self.results() {
                lines.paragraph(&line, Role::Text);
            }
        }
    }

    /// The points, the fitted and the predicted paths and the results; the paths and the results
    /// are left out while the outcome is hidden.
    pub(super) fn lay_out(&self, figure: FigureArea) -> Picture {
        let hidden = figure.hidden;
        let (area, mut lines) = figure.split(ROWS);
        self.write(hidden, &mut lines);
        match &self.measured {
            Ok(measurement) if hidden => points_picture(area, measurement),
            Ok(measurement) => measured_picture(area, measurement),
            Err(_) => Picture::new(View::fit(area, DVec2::NEG_ONE, DVec2::ONE)),
        }
    }
}

/// The film in words, and how the results depend on the setting.
pub(super) fn in_words(collision: &Collision, filming: Filming, revealed: bool) -> Vec<String> {
    let film = FilmFigure::new(collision, filming);
    let mut lines = vec![format!(
        "Figure: the points of a striker and a coin in a simulated film ({}).",
        film.film(!revealed)
    )];
    if revealed {
        let (least, most, _) = filming.sets.range();
        let middle = 0.5 * (least + most);
        for value in [least, middle, most] {
            let mut filming = filming;
            *filming.of(filming.sets) = value;
            let film = FilmFigure::new(collision, filming);
            let results = film.results().join(" ");
            lines.push(format!("{}: {results}.", film.film(false)));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use ratatui::buffer::Buffer;
    use ratatui::layout::Rect;

    use super::*;
    use crate::physics::CollisionSpec;
    use crate::widgets::{Charset, Look};

    fn angle_e_u1(filming: Filming) -> [(f64, f64); 3] {
        let shot = CollisionSpec {
            speed: 1.0,
            ..CollisionSpec::default()
        };
        let film = FilmFigure::new(&shot.collision(), filming);
        let measurement = film.measured.unwrap();
        ["between", "restitution", "u1"].map(|id| {
            let (_, estimate) = measurement.quantity(id).unwrap();
            (estimate.value, estimate.uncertainty())
        })
    }

    /// The figure beside the text of a chapter has 39 columns at 80×24.
    #[test]
    fn the_results_of_every_film_are_shown_whole() {
        let area = Rect::new(0, 0, 39, ROWS);
        let shot = |restitution| CollisionSpec {
            speed: 1.0,
            restitution,
            ..CollisionSpec::default()
        };
        for (sets, restitution) in [
            (FilmSetting::Rate, 1.0),
            (FilmSetting::Noise, 1.0),
            (FilmSetting::Noise, 0.8),
            (FilmSetting::Scale, 1.0),
            (FilmSetting::Tilt, 1.0),
        ] {
            let (least, most, step) = sets.range();
            let mut value = least;
            while value <= most {
                let mut filming = Filming {
                    noise_mm: 2.0,
                    sets,
                    ..Filming::default()
                };
                *filming.of(sets) = value;
                let film = FilmFigure::new(&shot(restitution).collision(), filming);
                for charset in [Charset::Ascii, Charset::Unicode] {
                    let look = Look {
                        charset,
                        ..Look::default()
                    };
                    let mut buf = Buffer::empty(area);
                    let mut lines = Lines::unseen(area, &mut buf, look);
                    film.write(false, &mut lines);
                    assert!(
                        lines.written() <= ROWS,
                        "{}: {:?}",
                        film.film(false),
                        film.results()
                    );
                }
                value += step;
            }
        }
    }

    /// The settings have the effects that the chapter describes.
    #[test]
    fn noise_widens_more_frames_narrow_and_a_wrong_scale_changes_only_speeds() {
        let plain = Filming::default();
        let [first, ..] = angle_e_u1(plain);
        let [noisy, ..] = angle_e_u1(Filming {
            noise_mm: 2.0,
            ..plain
        });
        assert!((noisy.1 / first.1 - 2.0).abs() < 0.05);
        let [often, ..] = angle_e_u1(Filming {
            rate: 240.0,
            ..plain
        });
        assert!(
            (0.35..0.65).contains(&(often.1 / first.1)),
            "{often:?} {first:?}"
        );
        let scaled = angle_e_u1(Filming {
            scale_percent: 2.0,
            ..plain
        });
        let right = angle_e_u1(plain);
        assert!((scaled[0].0 - right[0].0).abs() < 1e-6);
        assert!((scaled[1].0 - right[1].0).abs() < 1e-6);
        assert!((scaled[2].0 / right[2].0 - 1.02).abs() < 1e-6);
        let [tilted, ..] = angle_e_u1(Filming {
            tilt_deg: 20.0,
            ..plain
        });
        assert!((tilted.0 - first.0).abs() > 5.0 * first.1);
    }
}

//! Simulated measurements.

use glam::{DVec2, dvec2};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::measure::Track;
use crate::measure::film::Camera;
use crate::measure::model::{Model, State};

/// A collision and how it is filmed. Lengths are in metres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Film {
    pub(super) masses: [f64; 2],
    pub(super) radii: [f64; 2],
    pub(super) u: [DVec2; 2],
    /// The impact angle.
    pub(super) alpha: f64,
    pub(super) restitution: f64,
    /// The coefficient of friction of the rims.
    pub(super) rim: f64,
    /// The deceleration of both bodies.
    pub(super) slowing: f64,
    /// Frames per second.
    pub(super) rate: f64,
    /// The numbers of frames before and after the contact.
    pub(super) frames: [usize; 2],
    /// The standard deviation of the noise of a point, in pixels.
    pub(super) noise: f64,
    /// The size of a pixel along x and along y.
    pub(super) pixel: DVec2,
}

impl Film {
    /// The collision, with the contact at `time`. The discs are solid and do not spin before the
    /// collision; friction at the rims stops the slip if it is strong enough.
    pub(super) fn truth(&self, time: f64) -> State {
        let [m1, m2] = self.masses;
        let w = self.u[0] - self.u[1];
        let n = DVec2::from_angle(w.to_angle() - self.alpha);
        let t = n.perp();
        let mu = m1 * m2 / (m1 + m2);
        let normal = (1.0 + self.restitution) * mu * w.dot(n);
        let slip = w.dot(t);
        let tangential = slip.signum() * (self.rim * normal).min(mu * slip.abs() / 3.0);
        let impulse = normal * n + tangential * t;
        let first = dvec2(0.31, 0.22);
        let centres = [first, first + (self.radii[0] + self.radii[1]) * n];
        let v = [self.u[0] - impulse / m1, self.u[1] + impulse / m2];
        let velocities = [[self.u[0], v[0]], [self.u[1], v[1]]];
        State::new(time, centres, velocities, [self.slowing; 2])
    }

    /// The model of the motion in the film.
    pub(super) fn model(&self) -> Model {
        Model {
            slows: [[self.slowing > 0.0; 2]; 2],
            apart: None,
        }
    }

    /// The truth and the tracks of a film with this seed.
    pub(super) fn shot(&self, seed: u64) -> (State, [Track; 2]) {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let within: f64 = random.random();
        let truth = self.truth((self.frames[0] as f64 - 1.0 + within) / self.rate);
        let camera = Camera {
            rate: self.rate,
            frames: self.frames[0] + self.frames[1],
            noise: self.noise * self.pixel,
        };
        let tracks = camera.tracks(&truth, &self.model(), ["mass A", "mass B"], &mut random);
        (truth, tracks)
    }
}

/// A puck of 30 g that hits another at rest, filmed at 60 frames a second.
pub(super) const PUCKS: Film = Film {
    masses: [0.030, 0.030],
    radii: [0.025, 0.025],
    u: [dvec2(0.8, 0.1), DVec2::ZERO],
    alpha: 0.5,
    restitution: 0.99,
    rim: 0.0,
    slowing: 0.0,
    rate: 60.0,
    frames: [20, 24],
    noise: 0.5,
    pixel: DVec2::splat(0.001),
};

/// Both tracks in the form in which Tracker copies them.
fn tracker(tracks: &[Track; 2], head: &str) -> String {
    let mut text = format!("{head}#multi:\n\tmass A\t\tmass B\t\t\nt\tx\ty\tx\ty\t\n");
    for (first, second) in tracks[0].points.iter().zip(&tracks[1].points) {
        let numbers = [first.t, first.at.x, first.at.y, second.at.x, second.at.y];
        let numbers = numbers.map(|number| format!("{number:.4E}\t"));
        text += &format!("{}\n", numbers.concat());
    }
    text
}

/// The tracks in the form in which a spreadsheet writes them if a comma is the decimal sign, in
/// units of `per` metres.
fn spreadsheet(tracks: &[Track; 2], head: &str, unit: &str, per: DVec2) -> String {
    let heads = ["x1", "y1", "x2", "y2"].map(|name| format!(";{name} ({unit})"));
    let mut text = format!("{head}t (s){}\n", heads.concat());
    for (row, (first, second)) in tracks[0].points.iter().zip(&tracks[1].points).enumerate() {
        let numbers = [first.at / per, second.at / per].map(|at| [at.x, at.y]);
        // The mark of the second body was lost in two frames.
        let is_lost = |body: usize| body == 1 && matches!(row, 5 | 6);
        let cells = numbers.iter().enumerate().flat_map(|(body, at)| {
            at.map(|number| match is_lost(body) {
                true => ";".to_owned(),
                false => format!(";{number:.2}"),
            })
        });
        let cells: String = cells.collect();
        text += &format!("{:.4}{cells}\n", first.t).replace('.', ",");
    }
    text
}

/// The examples that come with carrom.
pub(super) fn examples() -> [(&'static str, String); 3] {
    let clean = Film {
        noise: 0.8,
        ..PUCKS
    };
    let coins = Film {
        masses: [0.0085, 0.0075],
        radii: [0.012_875, 0.011_625],
        u: [dvec2(0.9, -0.15), DVec2::ZERO],
        alpha: -0.6,
        restitution: 0.85,
        rim: 0.15,
        slowing: 1.0,
        rate: 60.0,
        frames: [20, 26],
        noise: 0.6,
        pixel: DVec2::splat(0.0006),
    };
    let hopeless = Film {
        rate: 30.0,
        frames: [5, 5],
        alpha: 0.9,
        noise: 10.0,
        ..PUCKS
    };
    let first = "# Simulated, not filmed: two air-hockey pucks of 30 g and 25 mm radius, 60 frames a \
                 second.\n";
    let second = "# Simulated, not filmed: a 2-euro coin (8.5 g, 12.875 mm) hits a 1-euro coin (7.5 g, \
                  11.625 mm) on a powdered board, 60 frames a second.\n";
    let third = "# Simulated, not filmed: two pucks of 30 g and 25 mm radius, 30 frames a second, marked \
                 carelessly; a pixel is 1 mm.\n";
    [
        ("pucks.txt", tracker(&clean.shot(3).1, first)),
        (
            "coins.csv",
            spreadsheet(&coins.shot(5).1, second, "cm", DVec2::splat(0.01)),
        ),
        (
            "careless.csv",
            spreadsheet(&hopeless.shot(4).1, third, "px", DVec2::splat(0.001)),
        ),
    ]
}

#[test]
fn shipped_examples_are_simulated() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/examples/measured/");
    for (name, text) in examples() {
        let path = format!("{folder}{name}");
        if std::env::var_os("CARROM_WRITE_EXAMPLES").is_some() {
            std::fs::write(&path, &text).unwrap();
        }
        assert_eq!(std::fs::read_to_string(path).unwrap(), text, "{name}");
    }
}

//! The figure of a page.

use strum::{EnumString, IntoStaticStr, VariantNames};

use super::{CollisionSpec, header::Shots, words::Words};
use crate::physics::Bond;

/// The kind of picture in a figure.
#[derive(Debug, Clone, Copy, PartialEq, EnumString, VariantNames)]
#[strum(serialize_all = "lowercase")]
pub enum FigureKind {
    /// The collision, as in the lab.
    Lab,
    /// The collision at the contact, with n, t and the components of u.
    Split {
        /// Whether only the lines n and t are drawn.
        lines: bool,
    },
    /// The triangle of momenta, up to a step of the proof.
    Triangle {
        /// The step, 1 to 3.
        step: u8,
    },
    /// The collision in the laboratory frame and in the centre-of-mass frame.
    Frames,
    /// Both final speeds plotted against α.
    Curves,
    /// θ₁ plotted against θ₂.
    Angles,
    /// The fractions of the energy plotted against α.
    Energy,
    /// A worked solution.
    Worked {
        /// The first step, counted from 1, whose results are left blank until the checkpoint has
        /// been answered.
        blank: Option<usize>,
    },
    /// A worked solution for numbers that the student sets.
    Solve,
    /// The contact force plotted against time; the area under the curve is the impulse.
    Force {
        /// How long the contact lasts, in milliseconds.
        time_ms: f64,
    },
    /// The momenta of two discs that coalesce, drawn tip to tail.
    Coalesce,
    /// The momenta of the pieces of a body that explodes. An explosion is the reverse of two discs
    /// coalescing.
    Explosion {
        /// The mass of a third piece in grams, if the body was at rest and the two discs of the
        /// shot are the other pieces.
        third_g: Option<f64>,
    },
    /// Two bars, before and after, each with the energy of the centre-of-mass motion and that of
    /// the relative motion.
    Parts,
    /// A simulated film of the collision, measured the way `carrom measure` does it.
    Film {
        /// How it is filmed.
        filming: Filming,
    },
    /// Particles passing a centre of repulsion.
    Foil {
        /// The page about the foil: 1 for a single particle, 2 for a beam, 3 for the counts of
        /// 1913.
        page: u8,
        /// Whether the figure shows how far the counts of 1913 deviate from the law.
        levelled: bool,
        /// Whether the particles of a beam are counted in whole rings instead of on a small screen.
        rings: bool,
    },
    /// Many random shots at one disc.
    Shots {
        /// Whether the offsets fill a disc, as for spheres in space, instead of a line.
        space: bool,
        /// The angle, in degrees, beyond which shots are counted.
        beyond_deg: f64,
    },
}

/// How the collision in a figure is filmed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Filming {
    /// Frames per second.
    pub rate: f64,
    /// The standard deviation of a marked point's position, in millimetres.
    pub noise_mm: f64,
    /// By how many per cent all lengths are too large.
    pub scale_percent: f64,
    /// The tilt of the camera in degrees, which makes lengths along y seem shorter.
    pub tilt_deg: f64,
    /// The setting that the student can change.
    pub sets: FilmSetting,
}

impl Default for Filming {
    fn default() -> Self {
        Self {
            rate: 60.0,
            noise_mm: 1.0,
            scale_percent: 0.0,
            tilt_deg: 0.0,
            sets: FilmSetting::Noise,
        }
    }
}

/// What a student can set in a figure of a film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumString, IntoStaticStr, VariantNames)]
#[strum(serialize_all = "lowercase")]
pub enum FilmSetting {
    /// The frame rate.
    Rate,
    /// The noise of the points.
    Noise,
    /// The error of the scale.
    Scale,
    /// The tilt of the camera.
    Tilt,
}

impl FilmSetting {
    /// The smallest and the largest value, and the step.
    pub(crate) fn range(self) -> (f64, f64, f64) {
        match self {
            Self::Rate => (30.0, 240.0, 30.0),
            Self::Noise => (0.2, 6.0, 0.2),
            Self::Scale => (-10.0, 10.0, 1.0),
            Self::Tilt => (0.0, 40.0, 5.0),
        }
    }
}

impl Filming {
    /// The value of a setting.
    pub(crate) fn of(&mut self, setting: FilmSetting) -> &mut f64 {
        match setting {
            FilmSetting::Rate => &mut self.rate,
            FilmSetting::Noise => &mut self.noise_mm,
            FilmSetting::Scale => &mut self.scale_percent,
            FilmSetting::Tilt => &mut self.tilt_deg,
        }
    }

    fn read(words: &mut Words) -> Result<Self, String> {
        let mut filming = Self::default();
        for name in FilmSetting::VARIANTS {
            let Ok(setting) = name.parse::<FilmSetting>() else {
                continue;
            };
            let (least, most, _) = setting.range();
            let given = words.number(name, least, most)?;
            given.into_iter().for_each(|it| *filming.of(setting) = it);
        }
        if let Some(name) = words.field("sets") {
            let expected = || format!("sets: expected {}", FilmSetting::VARIANTS.join(", "));
            filming.sets = name.parse().map_err(|_| expected())?;
        }
        Ok(filming)
    }
}

/// The figure of a page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figure {
    /// The kind of picture.
    pub kind: FigureKind,
    /// The shot that the figure shows.
    pub shot: CollisionSpec,
    /// The shot that the figure shows after the page's question has been answered, which is usually
    /// the same shot.
    pub after: CollisionSpec,
    /// Whether the figure uses the impact angle to which the student last set the chapter's
    /// figures.
    pub own: bool,
}

impl FigureKind {
    /// The shortest and the longest contact time in a figure, in milliseconds.
    pub(crate) const CONTACT_MS: (f64, f64) = (0.3, 1.5);

    /// Whether the figure shows the collision itself, so that the student can turn rays in the
    /// figure.
    pub fn is_hit(self) -> bool {
        matches!(self, Self::Lab | Self::Split { .. })
    }

    /// Checks that the figure can show this shot.
    fn check(self, shot: &CollisionSpec) -> Result<(), String> {
        let is_curve = matches!(self, Self::Curves | Self::Angles | Self::Energy);
        let is_for_rest = is_curve || matches!(self, Self::Triangle { .. });
        Err(match shot {
            _ if is_curve && shot.rims.friction > 0.0 => {
                "expected a shot without rim_friction: the curves are for smooth rims"
            }
            _ if is_curve && shot.bond == Bond::Stick => {
                "expected a shot without stick: the curves are for discs that separate"
            }
            _ if is_for_rest && shot.target_speed > 0.0 => {
                "expected a shot without target_speed: the figure is for a target at rest"
            }
            _ => return Ok(()),
        }
        .into())
    }
}

impl Figure {
    /// Reads the words of a figure: `lab carrom alpha_deg=40`. Fields after `then` change the shot
    /// once the page's question has been answered.
    ///
    /// # Errors
    /// Returns a message that states what was expected.
    pub(super) fn read(text: &str, shots: &Shots) -> Result<Self, String> {
        let (text, then) = text.split_once(" then ").unwrap_or((text, ""));
        let mut words = Words::of(text)?;
        let name = words.first().unwrap_or_default();
        let Ok(mut kind) = name.parse() else {
            let names = FigureKind::VARIANTS.join(", ");
            return Err(format!("expected a figure ({names}), found \"{name}\""));
        };
        let own = words.flag("own");
        match &mut kind {
            FigureKind::Split { lines } => *lines = words.flag("lines"),
            FigureKind::Triangle { step } => {
                *step = words.number("step", 1.0, 3.0)?.map_or(3, |step| step as u8);
            }
            FigureKind::Worked { blank } => {
                *blank = words.number("blank", 1.0, 9.0)?.map(|step| step as usize);
            }
            FigureKind::Force { time_ms } => {
                let (least, most) = FigureKind::CONTACT_MS;
                *time_ms = words.number("time_ms", least, most)?.unwrap_or(0.6);
            }
            FigureKind::Explosion { third_g } => {
                *third_g = words.number("third_g", 0.1, 1000.0)?;
            }
            FigureKind::Film { filming } => *filming = Filming::read(&mut words)?,
            FigureKind::Foil {
                page,
                levelled,
                rings,
            } => {
                *rings = words.flag("rings");
                *page = words.number("page", 1.0, 3.0)?.map_or(1, |page| page as u8);
                *levelled = words.flag("levelled");
            }
            FigureKind::Shots { space, beyond_deg } => {
                *space = words.flag("space");
                *beyond_deg = words.number("beyond_deg", 5.0, 85.0)?.unwrap_or(60.0);
            }
            _ => {}
        }
        let shot = shots.take(&mut words, None)?.unwrap_or_default();
        words.finish()?;
        let mut then = Words::of(then)?;
        let after = shots.take(&mut then, Some(shot))?.unwrap_or(shot);
        then.finish()?;
        kind.check(&shot)?;
        kind.check(&after)?;
        Ok(Self {
            kind,
            shot,
            after,
            own,
        })
    }

    /// Reads a figure as specified on the command line, where no shot has a name: fields change the
    /// worked shot.
    ///
    /// # Errors
    /// Returns a message that states what was expected.
    pub(crate) fn from_words(text: &str) -> Result<Self, String> {
        Self::read(text, &Shots::default())
    }
}

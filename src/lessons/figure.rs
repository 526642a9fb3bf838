//! The figure of a page.

use strum::{EnumString, VariantNames};

use super::{CollisionSpec, header::Shots, words::Words};

/// What a figure shows.
#[derive(Debug, Clone, Copy, PartialEq, EnumString, VariantNames)]
#[strum(serialize_all = "lowercase")]
pub enum FigureKind {
    /// The collision, as in the lab.
    Lab,
    /// The collision at the contact with n, t and the components of u.
    Split {
        /// Whether only the lines n and t are drawn.
        lines: bool,
    },
    /// The triangle of momenta, up to a step of the proof.
    Triangle {
        /// The step, 1 to 3.
        step: u8,
    },
    /// The collision in the laboratory frame and the centre-of-mass frame.
    Frames,
    /// Both speeds against α.
    Curves,
    /// θ₁ against θ₂.
    Angles,
    /// The shares of the energy plotted against α.
    Energy,
    /// The worked solution.
    Worked {
        /// The first step, from 1, whose results are blank until the checkpoint is answered.
        blank: Option<usize>,
    },
    /// The worked solution for numbers that the student sets.
    Solve,
    /// The force of the contact plotted against time, with the impulse as its area.
    Force {
        /// How long the contact lasts, in milliseconds.
        time_ms: f64,
    },
    /// The momenta of two discs that coalesce, tip to tail.
    Coalesce,
    /// The momenta of the pieces of a body that explodes: the reverse of two discs that coalesce.
    Explosion {
        /// The mass of a third piece in grams, if the body was at rest and the shot's discs are its
        /// other two pieces.
        third_g: Option<f64>,
    },
    /// The energy of the motion of the centre of mass and of the relative motion, as bars.
    Parts,
    /// Particles passing a centre of repulsion.
    Foil {
        /// The page of the foil: 1 for a particle, 2 for a beam, 3 for the counts of 1913.
        page: u8,
        /// Whether the counts of 1913 are shown relative to the law.
        levelled: bool,
        /// Whether a beam is counted in whole rings rather than on a small screen.
        rings: bool,
    },
    /// Many random shots at one disc.
    Shots {
        /// Whether the offsets fill a disc, as in space, rather than a line.
        space: bool,
        /// The angle in degrees beyond which shots are counted.
        beyond_deg: f64,
    },
}

/// A figure of a page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figure {
    /// The kind of picture.
    pub kind: FigureKind,
    /// The shot that the figure shows.
    pub shot: CollisionSpec,
    /// The shot that the figure shows once the page's question is answered, usually the same shot.
    pub after: CollisionSpec,
    /// Whether the figure uses the impact angle that the student set last in the chapter.
    pub own: bool,
}

impl FigureKind {
    /// The shortest and the longest contact that a figure shows, in milliseconds.
    pub(crate) const CONTACT_MS: (f64, f64) = (0.3, 1.5);

    /// Whether the figure shows the collision itself, so that rays can be turned in it.
    pub fn is_hit(self) -> bool {
        matches!(self, Self::Lab | Self::Split { .. })
    }
}

impl Figure {
    /// Reads the words of a figure: `lab carrom alpha_deg=40`. Fields after `then` change its shot
    /// once the page's question is answered.
    ///
    /// # Errors
    /// A message that states what was expected.
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
        let plots = [FigureKind::Curves, FigureKind::Angles, FigureKind::Energy];
        if plots.contains(&kind) && [shot, after].iter().any(|it| it.rims.friction > 0.0) {
            return Err(
                "expected a shot without rim_friction: the curves are for smooth rims".into(),
            );
        }
        Ok(Self {
            kind,
            shot,
            after,
            own,
        })
    }

    /// Reads a figure as the command line names it; the only shot available is the worked one.
    ///
    /// # Errors
    /// A message that states what was expected.
    pub(crate) fn from_words(text: &str) -> Result<Self, String> {
        Self::read(text, &Shots::default())
    }
}

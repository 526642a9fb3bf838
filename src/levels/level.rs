//! A level: a scene with a goal.

use glam::DVec2;

use super::aim::{Adjust, Dial, LevelAim};
use super::goal::Goal;
use super::scene::{PlacedDisc, Scene, read_discs, tidy};
use crate::files::{self, Fields, FileErrors, Range, Source, all};
use crate::physics::units::{g_from_kg, kg_from_g, m_from_mm, mm_from_m};

/// The version of the format that this program reads and writes.
pub(crate) const FORMAT: u32 = 1;

/// The maximum number of goals in a level.
const MOST_GOALS: usize = 8;

/// The tables and fields of a level file.
const FIELDS: [&str; 8] = [
    "format", "level", "board", "disc", "shot", "adjust", "goal", "solution",
];

/// The fields of the `[level]` table.
const ABOUT: [&str; 6] = [
    "id",
    "title",
    "hints",
    "explanation",
    "say_first",
    "unknown_mass",
];

/// A scene with goals, settings for the player to change, and an explanation.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// A name that never changes: lower-case letters, digits and hyphens.
    pub id: String,
    /// The title shown to players.
    pub title: String,
    /// Hints, each more direct than the previous one.
    pub hints: Vec<String>,
    /// The explanation shown after the shot, in paragraphs separated by empty lines.
    pub explanation: String,
    /// The discs for which the player predicts the direction after the first impact.
    pub say_first: Vec<usize>,
    /// The discs whose mass is hidden until the level is won.
    pub(crate) unknown_mass: Vec<usize>,
    /// The board, the discs, and the initial shot.
    pub scene: Scene,
    /// The dials that the player may change.
    pub adjust: Adjust,
    /// The goals, all of which must be met.
    pub goals: Vec<Goal>,
    /// An aim that wins.
    pub solution: LevelAim,
}

impl Level {
    /// Reads a level from the bytes of a file, which is called `name` in messages.
    ///
    /// # Errors
    ///
    /// Returns all errors in the file.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, FileErrors> {
        Self::read_beside(name, bytes, &[])
    }

    /// Reads a level whose id must differ from those of other levels.
    pub(super) fn read_beside(
        name: &str,
        bytes: &[u8],
        others: &[Self],
    ) -> Result<Self, FileErrors> {
        let source = Source::of_bytes(name, bytes, files::LARGEST)?;
        source.document("a level", FORMAT..=FORMAT, &FIELDS, |fields| {
            Self::from_fields(fields, others)
        })
    }

    fn from_fields(fields: &Fields, others: &[Self]) -> Option<Self> {
        let about = fields.table("level", &ABOUT);
        let (scene, count) = Scene::from_fields(fields);
        let goals = fields
            .tables("goal", 1..=MOST_GOALS, &[])
            .and_then(|goals| {
                let goals = goals.into_iter();
                all(goals.map(|goal| Goal::from_fields(goal, count)).collect())
            });
        let adjust = fields.table("adjust", &Dial::fields());
        let adjust = adjust.and_then(|table| read_adjust(&table, scene.as_ref()));
        let solution = fields.table("solution", &Dial::fields());
        let about = about?;
        let id = about.id("id").and_then(|id| {
            if others.iter().any(|other| other.id == id) {
                let message = format!("expected a unique id, found \"{id}\" twice");
                return about.refuse("id", message);
            }
            Some(id)
        });
        let title = about.text("title", 40);
        let hints = about.texts("hints", 1..=5, 300);
        let explanation = about.text("explanation", 3000);
        let discs = |name, most| {
            about.or(name, Vec::new(), |name| {
                read_discs(&about, name, count, most)
            })
        };
        let say_first = discs("say_first", 2);
        let unknown_mass = discs("unknown_mass", count);
        let (scene, adjust) = (scene?, adjust?);
        let solution = adjust.read_setting(&solution?, start(&scene));
        Some(Self {
            id: id?.into(),
            title: title?.trim().into(),
            hints: hints?,
            explanation: paragraphs(explanation?),
            say_first: say_first?,
            unknown_mass: unknown_mass?,
            scene,
            adjust,
            goals: goals?,
            solution: solution?,
        })
    }

    /// The initial aim.
    pub fn start(&self) -> LevelAim {
        start(&self.scene)
    }

    /// Whether the level is decided by the first collision alone: it has no pockets, and all goals
    /// are about this collision.
    pub(crate) fn is_of_the_first_hit(&self) -> bool {
        let no_pockets = self.scene.board.pocket_diameter <= 0.0;
        no_pockets && self.goals.iter().all(Goal::is_of_the_first_hit)
    }

    /// The scene after setting an aim, which is clamped to the permitted ranges.
    pub fn aimed(&self, aim: &LevelAim) -> Scene {
        let mut within = self.start();
        for (dial, range) in self.adjust.dials() {
            within = within.with(dial, range.nearest(aim.get(dial)));
        }
        let mut scene = self.scene.clone();
        scene.stroke.direction_deg = within.get(Dial::Direction);
        scene.stroke.speed = within.get(Dial::Speed);
        scene.board.restitution = within.get(Dial::Restitution);
        if let Some(piece) = scene.pieces.get_mut(scene.stroke.disc) {
            piece.disc.mass = kg_from_g(within.get(Dial::Mass));
            piece.at.x = m_from_mm(within.get(Dial::Place));
        }
        scene
    }
}

impl Scene {
    /// Reads a scene from the bytes of a file, which is called `name` in messages. If the file
    /// contains a level, the whole level is read and checked, and the scene of the level is
    /// returned.
    ///
    /// # Errors
    ///
    /// Returns all errors in the file.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, FileErrors> {
        let source = Source::of_bytes(name, bytes, files::LARGEST)?;
        source.document("a scene", FORMAT..=FORMAT, &[], |fields| {
            if fields.has("level") {
                let fields = fields.clone().only(&FIELDS);
                Level::from_fields(&fields, &[]).map(|level| level.scene)
            } else {
                let fields = fields.clone().only(&["format", "board", "disc", "shot"]);
                Self::from_fields(&fields).0
            }
        })
    }
}

/// The settings of all dials in a scene.
fn start(scene: &Scene) -> LevelAim {
    let piece = scene.pieces.get(scene.stroke.disc);
    LevelAim::new(|dial| match dial {
        Dial::Direction => scene.stroke.direction_deg,
        Dial::Speed => scene.stroke.speed,
        Dial::Place => piece.map_or(0.0, |piece| mm_from_m(piece.at.x)),
        Dial::Mass => piece.map_or(0.0, |piece| g_from_kg(piece.disc.mass)),
        Dial::Restitution => scene.board.restitution,
    })
}

/// Reads the dials that the player may change. Their ranges must contain the initial aim, and there
/// must be room for the disc at every permitted position.
fn read_adjust(fields: &Fields, scene: Option<&Scene>) -> Option<Adjust> {
    let adjust = Adjust::from_fields(fields)?;
    let scene = scene?;
    let start = start(scene);
    for (dial, range) in adjust.dials() {
        // The setting has rounding errors, because millimetres and grams were converted to SI units
        // and back.
        let setting = start.get(dial);
        if (range.nearest(setting) - setting).abs() > 1e-9 * setting.abs() {
            let message = format!(
                "expected a range that contains the initial value {setting}, found {} to {}",
                range.from, range.to
            );
            fields.refuse::<()>(dial.field(), message);
        }
    }
    if let Some(range) = adjust.range(Dial::Place)
        && let Err(message) = check_places(scene, range.scaled(1e-3))
    {
        fields.refuse::<()>(Dial::Place.field(), message);
    }
    Some(adjust)
}

/// Checks that the disc that is shot has room at every x, in metres, in a range. It is enough to
/// check both ends of the range and the points that are nearest to each of the other discs and
/// pockets.
fn check_places(scene: &Scene, range: Range) -> Result<(), String> {
    let number = scene.stroke.disc;
    let Some(&piece) = scene.pieces.get(number) else {
        return Ok(());
    };
    let discs = scene.pieces.iter().map(|other| other.at.x);
    let holes = scene.board.pockets().map(|hole| hole.x);
    let nearest = discs.chain(holes).map(|x| range.nearest(x));
    for x in nearest.chain([range.from, range.to]) {
        let moved = PlacedDisc {
            at: DVec2::new(x, piece.at.y),
            ..piece
        };
        let others = scene.pieces.iter().enumerate();
        moved
            .check_place(&scene.board, others.filter(|(other, _)| *other != number))
            .map_err(|message| format!("at x = {} mm: {message}", tidy(mm_from_m(x))))?;
    }
    Ok(())
}

/// Replaces the line breaks in a text with spaces, except for empty lines between paragraphs.
fn paragraphs(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let paragraphs = lines.split(|line| line.is_empty());
    let paragraphs = paragraphs.filter(|lines| !lines.is_empty());
    let paragraphs: Vec<String> = paragraphs.map(|lines| lines.join(" ")).collect();
    paragraphs.join("\n\n")
}

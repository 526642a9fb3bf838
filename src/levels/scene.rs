//! A scene: a board with discs on it, and a shot.

use glam::DVec2;

use super::kind::DiscKind;
use super::quantity as q;
use crate::files::{Fields, all};
use crate::numbers::short;
use crate::physics::direction::direction;
use crate::physics::units::{kg_from_g, m_from_mm, mm_from_m};
use crate::physics::{Board, Disc, Motion};

/// The maximum number of discs in a scene.
pub(crate) const MOST_DISCS: usize = 256;

/// The distance, in metres, by which discs may overlap each other or the frame. As in the engine,
/// this allows for the rounding errors of discs that are meant to touch.
const SLACK: f64 = 1e-10;

/// A disc and its position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedDisc {
    /// The kind of the disc.
    pub kind: DiscKind,
    /// The mass and the radius of the disc.
    pub disc: Disc,
    /// The position of the disc's centre, in metres from the centre of the board.
    pub at: DVec2,
}

/// The shot of one of the discs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Launch {
    /// The number of the disc that is shot.
    pub disc: usize,
    /// The direction in degrees from +x, anticlockwise, stored as in the file so that a quarter
    /// turn is exact.
    pub direction_deg: f64,
    /// The speed in m/s.
    pub speed: f64,
}

impl Launch {
    /// The velocity in m/s, exact along the axes and symmetric in all four quadrants.
    pub(crate) fn velocity(&self) -> DVec2 {
        self.speed * unit_vector(self.direction_deg)
    }
}

/// A board, the discs on it, and a shot.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The board.
    pub board: Board,
    /// The discs, indexed by number.
    pub pieces: Vec<PlacedDisc>,
    /// The shot of one of the discs.
    pub stroke: Launch,
}

impl Scene {
    /// Reads the scene; also returns the number of discs in the file, whether they are valid or
    /// not.
    pub(super) fn from_fields(fields: &Fields) -> (Option<Self>, usize) {
        let board = fields.or("board", Board::default(), |_| read_board(fields));
        let tables = fields.tables("disc", 1..=MOST_DISCS, &DISC_FIELDS);
        let tables = tables.unwrap_or_default();
        let mut pieces: Vec<Option<PlacedDisc>> = Vec::new();
        for table in &tables {
            let piece = read_piece(table);
            let others = pieces.iter().enumerate();
            let others = others.filter_map(|(number, other)| Some((number, other.as_ref()?)));
            let placed = piece.zip(board).and_then(|(piece, board)| {
                match piece.check_place(&board, others) {
                    Ok(()) => Some(piece),
                    Err(message) => table.refuse("at_mm", message),
                }
            });
            pieces.push(placed);
        }
        let stroke = read_launch(fields, tables.len());
        let scene = || {
            Some(Self {
                board: board?,
                pieces: all(pieces).filter(|pieces| !pieces.is_empty())?,
                stroke: stroke?,
            })
        };
        (scene(), tables.len())
    }

    /// The discs, indexed by number.
    pub fn discs(&self) -> Vec<Disc> {
        self.pieces.iter().map(|piece| piece.disc).collect()
    }

    /// The initial motion of each disc: all discs are at rest except the disc that is shot.
    pub fn motions(&self) -> Vec<Motion> {
        let at_rest = self.pieces.iter().map(|piece| Motion::at_rest(piece.at));
        let mut motions: Vec<_> = at_rest.collect();
        if let Some(motion) = motions.get_mut(self.stroke.disc) {
            motion.velocity = self.stroke.velocity();
        }
        motions
    }

    /// The name of a disc: "the striker" or, if there are several discs of the same kind, "white
    /// coin 2", where the discs of this kind are numbered in order.
    pub fn name(&self, disc: usize) -> String {
        let Some(kind) = self.pieces.get(disc).map(|piece| piece.kind) else {
            return format!("disc {disc}");
        };
        let alike = |pieces: &[PlacedDisc]| pieces.iter().filter(|p| p.kind == kind).count();
        match alike(&self.pieces) {
            0 | 1 => format!("the {}", kind.name()),
            _ => {
                let ordinal = self.pieces.get(..=disc).map_or(0, alike);
                format!("{} {ordinal}", kind.name())
            }
        }
    }
}

const DISC_FIELDS: [&str; 4] = ["kind", "at_mm", "mass_g", "radius_mm"];

const BOARD_FIELDS: [&str; 5] = [
    "side_mm",
    "pocket_diameter_mm",
    "friction",
    "restitution",
    "cushion_restitution",
];

fn read_board(fields: &Fields) -> Option<Board> {
    let fields = fields.table("board", &BOARD_FIELDS)?;
    let usual = Board::default();
    let length =
        |name, usual, spec| fields.or(name, usual, |name| fields.number(name, spec).map(m_from_mm));
    let number = |name, usual, spec| fields.or(name, usual, |name| fields.number(name, spec));
    let side = length("side_mm", usual.side, &q::SIDE);
    let pocket_diameter = length("pocket_diameter_mm", usual.pocket_diameter, &q::POCKET);
    let friction = number("friction", usual.friction, &q::FRICTION);
    let restitution = number("restitution", usual.restitution, &q::RESTITUTION);
    let cushion_restitution = number(
        "cushion_restitution",
        usual.cushion_restitution,
        &q::RESTITUTION,
    );
    let board = Board {
        side: side?,
        pocket_diameter: pocket_diameter?,
        friction: friction?,
        restitution: restitution?,
        cushion_restitution: cushion_restitution?,
    };
    if board.pocket_diameter > 0.5 * board.side {
        let message = format!(
            "expected at most half the side of the board, {} mm, found {}",
            tidy(mm_from_m(0.5 * board.side)),
            tidy(mm_from_m(board.pocket_diameter)),
        );
        return fields.refuse("pocket_diameter_mm", message);
    }
    Some(board)
}

fn read_piece(fields: &Fields) -> Option<PlacedDisc> {
    let kind = fields.word("kind", &DiscKind::NAMED);
    let at = fields.pair("at_mm", "[x, y]", &q::COORDINATE);
    let optional = |name, spec| fields.or(name, None, |name| fields.number(name, spec).map(Some));
    let mass = optional("mass_g", &q::MASS);
    let radius = optional("radius_mm", &q::RADIUS);
    let usual = kind?.disc();
    Some(PlacedDisc {
        kind: kind?,
        disc: Disc {
            mass: mass?.map_or(usual.mass, kg_from_g),
            radius: radius?.map_or(usual.radius, m_from_mm),
        },
        at: point(at?),
    })
}

/// Converts a point from millimetres to metres.
pub(super) fn point(mm: [f64; 2]) -> DVec2 {
    DVec2::from(mm.map(m_from_mm))
}

/// Reads the shot in a scene with `count` discs.
fn read_launch(fields: &Fields, count: usize) -> Option<Launch> {
    let fields = fields.table("shot", &["disc", "direction_deg", "speed"])?;
    let disc = read_disc(&fields, "disc", count);
    let direction_deg = fields.number("direction_deg", &q::DIRECTION);
    let speed = fields.number("speed", &q::SPEED);
    Some(Launch {
        disc: disc?,
        direction_deg: direction_deg?,
        speed: speed?,
    })
}

/// Reads the number of one of `count` discs. If `count` is 0, returns `None` without an error,
/// because the missing discs have already been reported.
pub(super) fn read_disc(fields: &Fields, name: &str, count: usize) -> Option<usize> {
    let last = count.checked_sub(1)?;
    fields.whole(name, &disc_number(last), 0..=last)
}

/// Reads a list of 1 to `most` different discs, out of `count` discs.
pub(super) fn read_discs(
    fields: &Fields,
    name: &str,
    count: usize,
    most: usize,
) -> Option<Vec<usize>> {
    let disc = disc_number(count.checked_sub(1)?);
    let expected = format!("a list of 1 to {most} different discs, {disc}");
    fields.different(name, &expected, 1..=most, count)
}

fn disc_number(last: usize) -> String {
    match last {
        0 => "disc 0, the only one".into(),
        _ => format!("a disc from 0 to {last}"),
    }
}

impl PlacedDisc {
    /// Checks that the disc is inside the frame, outside the pockets and clear of other discs; the
    /// error says what was expected.
    pub(super) fn check_place<'a>(
        &self,
        board: &Board,
        mut others: impl Iterator<Item = (usize, &'a Self)>,
    ) -> Result<(), String> {
        let reach = 0.5 * board.side - self.disc.radius;
        let out = self.at.abs().max_element() - reach;
        if out > SLACK {
            return Err(format!(
                "expected a place inside the frame, found the disc {} mm beyond it",
                small(out)
            ));
        }
        if board.has_pocket_at(self.at) {
            return Err("expected a place outside the pockets, found one in a pocket".into());
        }
        let overlap =
            |other: &Self| self.disc.radius + other.disc.radius - self.at.distance(other.at);
        match others.find(|(_, other)| overlap(other) > SLACK) {
            Some((number, other)) => Err(format!(
                "expected a place clear of other discs, found {} mm of overlap with disc {number}",
                small(overlap(other))
            )),
            None => Ok(()),
        }
    }
}

/// Formats a length in millimetres with enough digits that the length is not printed as zero.
fn small(length: f64) -> String {
    let mm = mm_from_m(length);
    if mm < 0.01 {
        format!("{mm:.1e}")
    } else {
        tidy(mm)
    }
}

/// Formats a number with two decimal places, but without trailing zeros.
pub(super) fn tidy(number: f64) -> String {
    short(number, 2)
}

/// Formats a measured length in millimetres with three significant figures, but never in steps
/// coarser than 1 mm or finer than 0.01 mm.
pub(super) fn figures(mm: f64) -> String {
    let decimals = match mm.abs() {
        ..10.0 => 2,
        ..100.0 => 1,
        _ => 0,
    };
    format!("{mm:.decimals$}")
}

/// The unit vector at an angle in degrees. The sine and cosine are those of an angle of at most
/// 45°, and the result is rotated by quarter turns, so that the vector is exact along the axes.
fn unit_vector(angle_deg: f64) -> DVec2 {
    let quarters = (angle_deg / 90.0).round();
    let within = direction((angle_deg - 90.0 * quarters).to_radians());
    match quarters.rem_euclid(4.0) as u8 {
        0 => within,
        1 => within.perp(),
        2 => -within,
        _ => -within.perp(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_6};

    #[test]
    fn quarter_turns_are_exact() {
        for turn in [-360.0, 0.0, 360.0] {
            assert_eq!(unit_vector(turn), DVec2::X);
            assert_eq!(unit_vector(turn + 90.0), DVec2::Y);
            assert_eq!(unit_vector(turn - 90.0), -DVec2::Y);
            assert_eq!(unit_vector(turn + 180.0), -DVec2::X);
        }
    }

    #[test]
    fn other_directions_agree_with_sine_and_cosine() {
        let near = |angle, x: f64, y: f64| unit_vector(angle).distance(DVec2::new(x, y)) < 1e-15;
        assert!(near(30.0, FRAC_PI_6.cos(), 0.5));
        assert!(near(135.0, -FRAC_1_SQRT_2, FRAC_1_SQRT_2));
        assert!(near(-120.0, -0.5, -FRAC_PI_6.cos()));
        assert!(near(300.0, 0.5, -FRAC_PI_6.cos()));
    }

    #[test]
    fn discs_are_named_by_kind_and_numbered_if_there_are_several() {
        let text = "format = 1\n\
            [[disc]]\nkind = \"white\"\nat_mm = [0, 0]\n\
            [[disc]]\nkind = \"striker\"\nat_mm = [0, -200]\n\
            [[disc]]\nkind = \"white\"\nat_mm = [100, 0]\n\
            [shot]\ndisc = 1\ndirection_deg = 90\nspeed = 1\n";
        let scene = Scene::read("a.toml", text.as_bytes()).unwrap();
        assert_eq!(scene.name(0), "white coin 1");
        assert_eq!(scene.name(1), "the striker");
        assert_eq!(scene.name(2), "white coin 2");
    }

    #[test]
    fn numbers_have_no_trailing_zeros() {
        for (number, text) in [(0.5, "0.5"), (3.0, "3"), (-0.001, "0"), (12.345, "12.35")] {
            assert_eq!(tidy(number), text);
        }
    }
}

//! The board seen from above: its surface, frame, pockets and lines, and the discs on it.
//!
//! The lengths are those of the Laws of Carrom of the International Carrom Federation, section I.

use glam::DVec2;
use ratatui::layout::Rect;

use super::Role;
use super::picture::{DrawLayer, Pen, Picture, Region, View};
use crate::numbers::capital;
use crate::physics::Board;
use crate::physics::units::mm_from_m;

/// The length of a base line, in metres.
const BASE_LENGTH: f64 = 0.470;
/// The distance from the frame to the outer line of a pair of base lines, in metres.
const BASE_FROM_FRAME: f64 = 0.1015;
/// The distance between the two lines of a pair, which is also the diameter of the circles at their
/// ends, in metres.
const BASE_WIDTH: f64 = 0.0318;
/// The smallest breadth of the frame that the Laws allow, in metres.
const FRAME: f64 = 0.0635;
/// The distance from the point of a diagonal arrow to its pocket, in metres.
const ARROW_FROM_POCKET: f64 = 0.050;
/// The length of a diagonal arrow, in metres.
const ARROW_LENGTH: f64 = 0.267;
/// The length of each of the two strokes of an arrow's head, in metres.
const ARROW_HEAD: f64 = 0.030;
/// The radius of the outer circle, in metres.
const OUTER_CIRCLE: f64 = 0.085;
/// The radius of the centre circle, in metres.
const CENTRE_CIRCLE: f64 = 0.0159;

/// The largest part of `area` that looks square if a cell is twice as high as it is wide. The part
/// is left-aligned and vertically centred.
pub(crate) fn square(area: Rect) -> Rect {
    // The width is one column less than twice the number of rows, because the board's edges run
    // through the middles of the outermost cells.
    let height = area.height.min(area.width.div_ceil(2));
    Rect {
        x: area.x,
        y: area.y + (area.height - height) / 2,
        width: (2 * height).saturating_sub(1),
        height,
    }
}

/// The view of a whole board in a [`square`] area. A surface without a frame is drawn at the scale
/// of a tournament board.
pub(crate) fn view(area: Rect, board: &Board) -> View {
    let side = Some(board.side).filter(|side| side.is_finite());
    let half = DVec2::splat(side.unwrap_or(Board::default().side) / 2.0);
    View::stretch(area, -half, half)
}

/// The centre of a corner's pocket; corners are numbered as in the engine: lower left, lower right,
/// upper left, upper right. `None` if there is no such corner or no pocket.
pub(crate) fn pocket(board: &Board, corner: usize) -> Option<DVec2> {
    let middle = board.pockets().nth(corner)?;
    middle.is_finite().then_some(middle)
}

/// Draws the surface with its frame, pockets and lines. An open surface has no frame, pockets or
/// lines, and a board without pockets has no lines.
pub(crate) fn ground(picture: &mut Picture, board: &Board) {
    if !board.side.is_finite() {
        return;
    }
    let half = board.side / 2.0;
    picture.ground(Region::Square(half + FRAME), Role::Rail, None);
    picture.ground(Region::Square(half), Role::Surface, Some(Role::Rail));
    let radius = board.pocket_radius();
    if radius <= 0.0 {
        return;
    }
    // The lengths are those of a tournament board; the lines of other boards are scaled.
    let scale = board.side / Board::default().side;
    for pocket in board.pockets() {
        let hole = Region::Circle(pocket, radius);
        picture.ground(hole, Role::Hole, Some(Role::Pocket));
        arrow(picture, pocket, radius, scale);
    }
    for quarter in 0..4 {
        base_lines(picture, half, scale, f64::from(quarter));
    }
    picture.circle(DVec2::ZERO, OUTER_CIRCLE * scale, Role::BoardLine);
    if CENTRE_CIRCLE * scale > 1.5 * picture.view().per_column() {
        picture.circle(DVec2::ZERO, CENTRE_CIRCLE * scale, Role::BoardLine);
    }
}

/// Describes the positions of discs in millimetres from the centre of the board, one sentence per
/// disc.
pub(crate) fn places_in_words(discs: impl IntoIterator<Item = (String, DVec2)>) -> Vec<String> {
    let way = |metres: f64, [less, more]: [&str; 2]| {
        let mm = mm_from_m(metres).round();
        format!("{} mm {}", mm.abs(), if mm < 0.0 { less } else { more })
    };
    let place = |(name, at): (String, DVec2)| {
        let [x, y] = [way(at.x, ["left", "right"]), way(at.y, ["down", "up"])];
        capital(&format!("{name}: {x}, {y}."))
    };
    discs.into_iter().map(place).collect()
}

/// Draws the outline of a disc at contact, dotted if it is large enough.
pub(crate) fn ghost(picture: &mut Picture, at: DVec2, radius: f64, role: Role) {
    let pen = Pen::new(role).on(DrawLayer::Trail);
    let large = radius > picture.view().per_row();
    picture.circle(at, radius, if large { pen.dotted() } else { pen });
}

/// Draws the diagonal arrow that points to a pocket, unless it is too small to be recognizable.
fn arrow(picture: &mut Picture, pocket: DVec2, radius: f64, scale: f64) {
    if ARROW_HEAD * scale < picture.view().per_row() {
        return;
    }
    let outwards = pocket.normalize_or_zero();
    let tip = pocket - (radius + ARROW_FROM_POCKET * scale) * outwards;
    let pen = Pen::new(Role::BoardLine);
    picture.line(tip - ARROW_LENGTH * scale * outwards, tip, pen);
    for turn in [-0.75, 0.75] {
        let back = DVec2::from_angle(turn * std::f64::consts::PI).rotate(outwards);
        picture.line(tip, tip + ARROW_HEAD * scale * back, pen);
    }
}

/// Draws the base lines of one side; `quarter` is the number of quarter turns from the bottom side.
fn base_lines(picture: &mut Picture, half: f64, scale: f64, quarter: f64) {
    let axis = DVec2::from_angle(quarter * std::f64::consts::FRAC_PI_2);
    let place = |across: f64, from_frame: f64| {
        axis.rotate(DVec2::new(across * scale, from_frame * scale - half))
    };
    let end = (BASE_LENGTH - BASE_WIDTH) / 2.0;
    let middle = BASE_FROM_FRAME + BASE_WIDTH / 2.0;
    let pen = Pen::new(Role::BoardLine);
    // If the two lines are too close to be distinguished, only one is drawn.
    if BASE_WIDTH * scale < 1.2 * picture.view().per_row() {
        picture.line(place(-end, middle), place(end, middle), pen);
        return;
    }
    for from_frame in [BASE_FROM_FRAME, BASE_FROM_FRAME + BASE_WIDTH] {
        picture.line(place(-end, from_frame), place(end, from_frame), pen);
    }
    for across in [-end, end] {
        let circle = Region::Circle(place(across, middle), BASE_WIDTH * scale / 2.0);
        picture.ground(circle, Role::BaseCircle, Some(Role::BaseCircle));
    }
}

#[cfg(test)]
mod tests {
    use ratatui::buffer::Buffer;

    use super::*;
    use crate::widgets::picture::Mark;
    use crate::widgets::{Charset, Depth, Look, Palette, Theme};

    /// Draws the board in an area with two cells of free space around it.
    fn drawn(size: (u16, u16), board: &Board, charset: Charset, depth: Depth) -> (Rect, Buffer) {
        let theme = Theme::new(Palette::Dark, depth);
        let area = Rect::new(2, 2, size.0, size.1);
        let mut cells = Buffer::empty(Rect::new(0, 0, size.0 + 4, size.1 + 4));
        let mut picture = Picture::new(view(area, board));
        ground(&mut picture, board);
        picture.draw(
            &mut cells,
            &Look {
                charset,
                theme,
                ..Look::default()
            },
        );
        (area, cells)
    }

    #[test]
    fn the_surface_fills_every_cell_of_the_board_and_none_outside() {
        for (size, charset) in [
            ((39, 20), Charset::Unicode),
            ((71, 36), Charset::Unicode),
            ((39, 20), Charset::Ascii),
            ((71, 36), Charset::Ascii),
        ] {
            let (area, cells) = drawn(size, &Board::default(), charset, Depth::True);
            let untouched = Buffer::empty(Rect::new(0, 0, 1, 1));
            for at in cells.area.positions() {
                let is_inside = area.contains(at);
                assert_eq!(
                    cells[at] != untouched[(0, 0)],
                    is_inside,
                    "{charset:?} {at}"
                );
                assert_eq!(
                    cells[at].bg != untouched[(0, 0)].bg,
                    is_inside,
                    "{charset:?} {at}"
                );
            }
            // Halfway between the centre and the rail there is nothing but the surface.
            let at = (area.x + area.width / 2, area.y + area.height / 4 + 1);
            let surface = Theme::new(Palette::Dark, Depth::True).colour(Role::Surface);
            assert_eq!((cells[at].symbol(), cells[at].bg), (" ", surface));
        }
    }

    #[test]
    fn a_rail_follows_the_edge_of_the_surface() {
        let board = Board::default();
        for (charset, depth, signs) in [
            (Charset::Unicode, Depth::True, ["▌", "▌", "▀", "▀"]),
            (Charset::Unicode, Depth::None, ["⢸", "⢸", "⠤", "⠤"]),
            (Charset::Ascii, Depth::True, ["|", "|", "-", "-"]),
            (Charset::Ascii, Depth::None, ["|", "|", "-", "-"]),
        ] {
            let (area, cells) = drawn((39, 20), &board, charset, depth);
            let (x, y) = (area.x + 19, area.y + 10);
            let right_and_bottom = [(area.right() - 1, y), (x, area.bottom() - 1)];
            let [left, top] = [(area.left(), y), (x, area.top())].map(|at| &cells[at]);
            let [right, bottom] = right_and_bottom.map(|at| &cells[at]);
            let found = [left, right, top, bottom].map(|cell| cell.symbol());
            assert_eq!(found, signs, "{charset:?} {depth:?}");
            // In block elements the rail is the outer half of each cell.
            let colours = match charset {
                Charset::Unicode => [left.fg, right.bg, top.fg, bottom.bg],
                Charset::Ascii => [left.fg, right.fg, top.fg, bottom.fg],
            };
            let rail = Theme::new(Palette::Dark, depth).colour(Role::Rail);
            assert_eq!(colours, [rail; 4], "{charset:?} {depth:?}");
        }
    }

    #[test]
    fn an_open_surface_has_no_edge() {
        let (_, cells) = drawn((39, 20), &Board::open(1.0), Charset::Unicode, Depth::True);
        assert_eq!(cells, Buffer::empty(cells.area));
    }

    #[test]
    fn the_diagonal_arrows_pass_between_the_base_circles() {
        let area = Rect::new(0, 0, 71, 36);
        let mut picture = Picture::new(view(area, &Board::default()));
        ground(&mut picture, &Board::default());
        let (mut arrows, mut circles) = (Vec::new(), Vec::new());
        for mark in &picture.marks {
            match *mark {
                Mark::Line { from, to, .. } if from.distance(to) > 0.5 * ARROW_LENGTH => {
                    let is_diagonal = (from.x.abs() - from.y.abs()).abs() < 1e-9;
                    arrows.extend(is_diagonal.then_some([from, to]));
                }
                Mark::Ground {
                    region: Region::Circle(centre, _),
                    role: Role::BaseCircle,
                    ..
                } => circles.push(centre),
                _ => {}
            }
        }
        assert_eq!((arrows.len(), circles.len()), (4, 8));
        for [from, to] in arrows {
            assert!((from.distance(to) - 0.267).abs() < 1e-9);
            let along = (to - from).normalize();
            for centre in &circles {
                assert!((*centre - from).perp_dot(along).abs() > 0.0159, "{centre}");
            }
        }
    }

    #[test]
    fn the_board_is_square_in_every_area() {
        for (width, height) in [(80, 22), (44, 20), (30, 38), (5, 5), (1, 1), (0, 0)] {
            let area = square(Rect::new(3, 1, width, height));
            assert!(area.width <= width && area.height <= height);
            if area.height > 1 {
                let view = view(area, &Board::default());
                assert!((view.per_row() - 2.0 * view.per_column()).abs() < 1e-12);
            }
        }
    }
}

//! Where discs appear in a picture made of cells, for tests.

use glam::{DMat3, DVec2, DVec3, dvec2};
use ratatui::{buffer::Buffer, layout::Rect, style::Color};

use super::super::Canvas;
use super::super::glyphs::{ascii, block};
use crate::widgets::picture::{Body, Mark, Picture};
use crate::widgets::theme::Rgb;
use crate::widgets::{Blocks, Charset, Look, Role, Theme};

/// The form in which discs are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Drawn {
    Token,
    /// The disc is drawn as a circle or a block.
    Round,
}

/// The discs drawn together in a picture, each with its form and the displacement, in cells, of its
/// drawn centre from the true centre.
pub(crate) fn centre_errors(picture: &Picture, charset: Charset) -> Vec<(Body, Drawn, DVec2)> {
    let look = Look {
        charset,
        ..Look::default()
    };
    let canvas = Canvas::of(picture, &look);
    let discs = picture.marks.iter().filter_map(|mark| match mark {
        Mark::Discs(bodies) => Some(bodies),
        _ => None,
    });
    let error = |body: &Body, drawn: DVec2| drawn - canvas.view().to_cell(body.at);
    let mut errors = Vec::new();
    for bodies in discs {
        if canvas.are_round(bodies) {
            errors.extend(bodies.iter().map(|body| {
                let drawn = round_at(&canvas, body, canvas.is_block(body, bodies), &look);
                (*body, Drawn::Round, error(body, drawn))
            }));
        } else {
            let corner = canvas.view().area().as_position();
            let corner = dvec2(corner.x.into(), corner.y.into());
            errors.extend(
                canvas
                    .token_places(bodies)
                    .into_iter()
                    .map(|(place, body)| {
                        let drawn = corner + dvec2(f64::from(place.0), f64::from(place.1)) + 0.5;
                        (*body, Drawn::Token, error(body, drawn))
                    }),
            );
        }
    }
    errors
}

/// The position at which a disc appears when it is drawn on its own, as a circle or a block.
fn round_at(canvas: &Canvas, body: &Body, is_block: bool, look: &Look) -> DVec2 {
    let mut alone = Canvas::of(&Picture::new(*canvas.view()), look);
    let letter = match look.charset {
        Charset::Ascii => ' ',
        Charset::Unicode => body.letter,
    };
    match is_block {
        true => alone.block(body),
        false => alone.round(&Body { letter, ..*body }),
    }
    // The cells of the disc, plus one more on each side.
    let half = dvec2(1.0, 0.5) * body.radius / alone.view().per_column() + 1.0;
    let [low, high] = [-half, half].map(|to| alone.view().to_cell(body.at) + to);
    let cells = Rect::new(low.x as u16, low.y as u16, 0, 0).union(Rect::new(
        high.x.ceil() as u16,
        high.y.ceil() as u16,
        0,
        0,
    ));
    let mut buffer = Buffer::empty(alone.view().area().intersection(cells));
    alone.draw(&mut buffer, &look.theme);
    match look.charset {
        Charset::Ascii => rim_at(&buffer),
        Charset::Unicode => seen_at(&buffer, body.role),
    }
}

/// The centre of the circle that best fits the ink in a buffer, in cells (Kåsa's least squares).
fn rim_at(buffer: &Buffer) -> DVec2 {
    let (mut matrix, mut right) = (DMat3::ZERO, DVec3::ZERO);
    for at in buffer.area.positions() {
        let samples = samples(buffer[at].symbol());
        let sums = samples.fold(DVec3::ZERO, |sums, (inside, ink)| {
            sums + ink * inside.extend(1.0)
        });
        if sums.z > 0.0 {
            // The fit uses paper coordinates, in which a circle is round: a row is two columns
            // high.
            let at = dvec2(at.x.into(), at.y.into()) + sums.truncate() / sums.z;
            let at = dvec2(at.x, 2.0 * at.y).extend(1.0);
            matrix += DMat3::from_cols(at * at.x, at * at.y, at);
            right += at * at.truncate().length_squared();
        }
    }
    let fit = matrix.inverse() * right;
    dvec2(fit.x / 2.0, fit.y / 4.0)
}

/// The position at which a single disc on a canvas appears: the mean position of its colour, in
/// cells.
pub(super) fn seen_at(buffer: &Buffer, role: Role) -> DVec2 {
    let theme = Theme::default();
    let channels = |Rgb(red, green, blue): Rgb| [red, green, blue].map(f64::from);
    let of = |colour| match colour {
        Color::Rgb(red, green, blue) => channels(Rgb(red, green, blue)),
        _ => channels(theme.rgb(Role::Background)),
    };
    let [disc, paper] = [role, Role::Background].map(|role| channels(theme.rgb(role)));
    let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let less = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|i| a[i] - b[i]);
    let whole: [f64; 3] = less(disc, paper);
    let share = |colour| dot(less(of(colour), paper), whole) / dot(whole, whole);
    let (mut sum, mut weight) = (DVec2::ZERO, 0.0);
    for at in buffer.area.positions() {
        let cell = &buffer[at];
        let mut shapes = block::shapes(Blocks::Quadrants, [0; 3]);
        let shape = shapes.find(|(sign, _)| cell.symbol() == sign.to_string());
        let bits = match (cell.symbol(), shape) {
            ("█", _) => u64::MAX,
            (_, shape) => shape.map_or(0, |(_, bits)| bits),
        };
        for bit in 0..64_u32 {
            let inside = dvec2(f64::from(bit % 8), f64::from(bit / 8)) / 8.0 + 1.0 / 16.0;
            let share = share(if bits >> bit & 1 == 1 {
                cell.fg
            } else {
                cell.bg
            });
            sum += share * (dvec2(at.x.into(), at.y.into()) + inside);
            weight += share;
        }
    }
    sum / weight
}

/// The middles of the samples of a glyph, in cells from the upper left corner, each with its amount
/// of ink.
fn samples(glyph: &str) -> impl Iterator<Item = (DVec2, f64)> {
    let known = ascii::INK
        .iter()
        .find(|(sign, _)| glyph.as_bytes() == [*sign]);
    let ink = known.map(|(_, ink)| ink.iter().enumerate());
    ink.into_iter().flatten().map(|(sample, ink)| {
        let [x, y] = [sample % ascii::GRID.0, sample / ascii::GRID.0].map(|it| it as f64 + 0.5);
        (
            dvec2(x / ascii::GRID.0 as f64, y / ascii::GRID.1 as f64),
            f64::from(*ink),
        )
    })
}

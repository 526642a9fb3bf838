//! The checks that are made before the engine plays a shot.

use super::super::{Board, Disc, Motion};
use super::grid::WORTHWHILE;
use super::{EngineError, Limits};

/// The distance, in metres, by which discs may overlap each other or the frame at the start: an
/// allowance for rounding errors in the positions of discs that are meant to touch.
const ROUNDING: f64 = 1e-10;

pub(in super::super) fn check(
    board: &Board,
    discs: &[Disc],
    start: &[Motion],
    limits: Limits,
) -> Result<(), EngineError> {
    check_board(board, limits)?;
    if discs.len() != start.len() {
        return Err(EngineError::Count {
            discs: discs.len(),
            motions: start.len(),
        });
    }
    for (i, (disc, motion)) in discs.iter().zip(start).enumerate() {
        check_disc(i, disc, motion)?;
        let outermost = motion.position.abs().max_element() + disc.radius;
        let beyond = outermost - 0.5 * board.side;
        if beyond > ROUNDING {
            return Err(EngineError::OffBoard {
                disc: i,
                beyond_mm: beyond * 1000.0,
            });
        }
    }
    check_apart(discs, start)
}

fn check_board(board: &Board, limits: Limits) -> Result<(), EngineError> {
    let unit = 0.0..=1.0;
    let size = 0.0..f64::INFINITY;
    let expected = if board.side.is_nan() || board.side <= 0.0 {
        "side must be greater than 0"
    } else if !size.contains(&board.pocket_diameter) {
        "pocket diameter must be finite and at least 0"
    } else if board.pocket_diameter > board.side {
        "pockets must not be wider than its side"
    } else if !size.contains(&board.friction) {
        "friction must be finite and at least 0"
    } else if !unit.contains(&board.restitution) {
        "restitution must be from 0 to 1"
    } else if !unit.contains(&board.cushion_restitution) {
        "cushion restitution must be from 0 to 1"
    } else if limits.horizon.is_nan() || limits.horizon < 0.0 {
        return Err(EngineError::Horizon);
    } else if board.friction == 0.0 && board.side.is_finite() && limits.horizon.is_infinite() {
        return Err(EngineError::Endless);
    } else {
        return Ok(());
    };
    Err(EngineError::Board(expected))
}

fn check_disc(i: usize, disc: &Disc, motion: &Motion) -> Result<(), EngineError> {
    let expected = if !(disc.mass.is_finite() && disc.mass > 0.0) {
        "mass must be finite and greater than 0"
    } else if !(disc.radius.is_finite() && disc.radius > 0.0) {
        "radius must be finite and greater than 0"
    } else if !motion.position.is_finite() {
        "position must be finite"
    } else if !motion.velocity.is_finite() {
        "velocity must be finite"
    } else {
        return Ok(());
    };
    Err(EngineError::Disc { disc: i, expected })
}

fn check_apart(discs: &[Disc], start: &[Motion]) -> Result<(), EngineError> {
    if discs.len() >= WORTHWHILE {
        return check_many_apart(discs, start);
    }
    for second in 1..discs.len() {
        for first in 0..second {
            check_pair(discs, start, first, second)?;
        }
    }
    Ok(())
}

/// The discs are sorted by their left edges: a disc can only overlap discs whose left edge lies
/// before its own right edge.
fn check_many_apart(discs: &[Disc], start: &[Motion]) -> Result<(), EngineError> {
    let left = |i: usize| start[i].position.x - discs[i].radius;
    let right = |i: usize| start[i].position.x + discs[i].radius;
    let mut order: Vec<usize> = (0..discs.len()).collect();
    order.sort_by(|&a, &b| left(a).total_cmp(&left(b)));
    for (place, &i) in order.iter().enumerate() {
        for &k in order[place + 1..]
            .iter()
            .take_while(|&&k| left(k) < right(i))
        {
            check_pair(discs, start, i.min(k), i.max(k))?;
        }
    }
    Ok(())
}

#[inline]
fn check_pair(
    discs: &[Disc],
    start: &[Motion],
    first: usize,
    second: usize,
) -> Result<(), EngineError> {
    let apart = start[second].position - start[first].position;
    let contact_distance = discs[first].radius + discs[second].radius;
    let least = contact_distance - ROUNDING;
    if apart.length_squared() < least * least {
        return Err(EngineError::Overlap {
            first,
            second,
            depth_mm: (contact_distance - apart.length()) * 1000.0,
        });
    }
    Ok(())
}

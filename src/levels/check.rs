//! Checks whether a level can be won, and how hard that is.

use super::aim::LevelAim;
use super::judge::{Judgement, judge};
use super::level::Level;
use super::play::Patience;
use crate::physics::{Engine, EngineError, Shot};

/// The result of playing the stored solution of a level.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// Whether each goal was met.
    pub verdict: Judgement,
    /// Whether the initial aim also wins, so that there is nothing to solve.
    pub opens_won: bool,
}

impl Trial {
    /// Plays the stored solution and the initial aim of a level.
    ///
    /// # Errors
    ///
    /// Returns an error if a shot has too many events or exceeds its work budget.
    pub fn of(level: &Level) -> Result<Self, EngineError> {
        let verdict = |aim: &LevelAim| {
            let shot = level.aimed(aim).play(Patience::AKey)?;
            Ok(judge(level, &shot))
        };
        Ok(Self {
            verdict: verdict(&level.solution)?,
            opens_won: verdict(&level.start())?.won(),
        })
    }
}

/// The fraction, from 0 to 1, of winning aims among `tries` aims spread evenly over all possible
/// settings. It measures how easily the level can be won by chance. A shot that cannot be played
/// does not win.
///
/// The aims are the points of an additive recurrence with the negative powers of the root of
/// x^(d+1) = x + 1 (M. Roberts' R sequence). This sequence fills d dimensions evenly and is always
/// the same.
pub fn winning_share(level: &Level, tries: u32) -> f64 {
    let dials: Vec<_> = level.adjust.dials().collect();
    let root = root_for(dials.len());
    let mut engine = Engine::default();
    let mut shot = Shot::default();
    let won = (0..tries).filter(|&n| {
        let mut aim = level.start();
        let mut ratio = 1.0;
        for (dial, range) in &dials {
            ratio /= root;
            let share = (0.5 + ratio * f64::from(n)).fract();
            aim = aim.with(*dial, range.at(share));
        }
        let played = level
            .aimed(&aim)
            .play_into(&mut engine, &mut shot, Patience::AMoment);
        played.is_ok() && judge(level, &shot).won()
    });
    won.count() as f64 / f64::from(tries.max(1))
}

/// The root of x^(d+1) = x + 1 that is greater than 1.
fn root_for(dimensions: usize) -> f64 {
    let power = 1.0 / (dimensions + 1) as f64;
    (0..60).fold(2.0_f64, |x, _| (1.0 + x).powf(power))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_dimension_uses_the_golden_ratio() {
        assert!((root_for(1) - f64::midpoint(1.0, 5.0_f64.sqrt())).abs() < 1e-14);
    }
}

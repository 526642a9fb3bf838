//! The scoreboard.

use super::round::ClassRound;

/// Where a team stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Standing {
    /// The team, counted from 0.
    pub team: usize,
    /// Its place, from 1; teams that are level share one.
    pub place: usize,
    /// Points so far.
    pub points: f64,
    /// How many of them the last question brought.
    pub gain: f64,
}

/// Where the teams stand after the first `asked` questions, the best first; teams that
/// are level in the order in which they were named.
pub fn standings(round: &ClassRound, asked: usize) -> Vec<Standing> {
    let sum = |team: usize, questions: usize| -> f64 {
        let each = (0..questions).map(|question| round.points(question, team));
        each.sum()
    };
    let mut standings: Vec<Standing> = (0..round.participants().len())
        .map(|team| Standing {
            team,
            place: 0,
            points: sum(team, asked),
            gain: match asked.checked_sub(1) {
                Some(last) => round.points(last, team),
                None => 0.0,
            },
        })
        .collect();
    // As shown: nobody is ahead by a hair that cannot be seen.
    let tenths = |points: f64| (10.0 * points).round() as i64;
    standings.sort_by_key(|it| (std::cmp::Reverse(tenths(it.points)), it.team));
    let points: Vec<i64> = standings.iter().map(|it| tenths(it.points)).collect();
    for standing in &mut standings {
        let own = tenths(standing.points);
        standing.place = 1 + points.iter().filter(|other| **other > own).count();
    }
    standings
}

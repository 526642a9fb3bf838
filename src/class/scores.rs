//! The scoreboard.

use super::round::ClassRound;

/// The standing of a team.
#[derive(Debug, Clone, PartialEq)]
pub struct Standing {
    /// The team, counted from 0.
    pub team: usize,
    /// The team's rank, from 1; teams with equal points share a rank.
    pub place: usize,
    /// Points so far.
    pub points: f64,
    /// Points for the last question.
    pub gain: f64,
}

/// The standings after the first `asked` questions, the best first; teams with equal points are in
/// the order in which they were named.
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
    // Rounded as shown, so that nobody leads by an invisible difference.
    let tenths = |points: f64| (10.0 * points).round() as i64;
    standings.sort_by_key(|it| (std::cmp::Reverse(tenths(it.points)), it.team));
    let points: Vec<i64> = standings.iter().map(|it| tenths(it.points)).collect();
    for standing in &mut standings {
        let own = tenths(standing.points);
        standing.place = 1 + points.iter().filter(|other| **other > own).count();
    }
    standings
}

//! The summary of a board at its end.

use super::game_history::{GameHistory, Past};
use crate::game::opponent::Story;
use crate::game::{ByTeam, Move, Piece, Rules, RulingEffect, Team};
use crate::physics::units::deg_from_rad;

#[derive(Debug, Clone, PartialEq)]
pub(super) struct BoardReport {
    pub(super) teams: ByTeam<TeamReport>,
    /// The move number of the best stroke; `None` if no stroke counts for
    /// [`TeamReport::pocketing`].
    pub(super) best: Option<usize>,
    /// The points of both teams after each board of this game.
    pub(super) run: Vec<ByTeam<u8>>,
}

/// The figures of a team for a board.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct TeamReport {
    pub(super) strokes: u32,
    /// Strokes that pocketed a piece that the team wanted, but not the striker.
    pub(super) pocketing: u32,
    /// Strokes that pocketed the striker.
    pub(super) fouls: u32,
    /// Coins of the team that were put back on the board.
    pub(super) put_back: u32,
    pub(super) hints: u32,
}

impl TeamReport {
    /// [`Self::pocketing`] as a percentage of all strokes, as shown.
    pub(super) fn share(&self) -> String {
        let share = (100 * self.pocketing + self.strokes / 2).checked_div(self.strokes);
        share.map_or_else(|| "none".into(), |percent| format!("{percent} %"))
    }
}

impl BoardReport {
    /// The summary of the last board of a game.
    pub(super) fn of(history: &GameHistory) -> Self {
        let moves = &history.record().moves;
        let last_pack = moves.iter().rposition(|made| *made == Move::NextBoard);
        let first = last_pack.map_or(0, |number| number + 1);
        let mut report = Self {
            teams: ByTeam::default(),
            best: None,
            run: run(history),
        };
        let mut best = 0.0;
        let moves = history.moves().iter().enumerate().skip(first);
        for (number, past) in moves.filter(|(number, _)| history.strike(*number).is_some()) {
            report.count(past, history.hints().contains(&number));
            let rank = rank(past);
            if rank > best {
                (best, report.best) = (rank, Some(number));
            }
        }
        report
    }

    fn count(&mut self, past: &Past, hinted: bool) {
        let team = past.before.team(past.before.seat());
        let own = past.before.colour(team).piece();
        let any = past.before.setup().rules == Rules::Points;
        let counts = |piece| piece == own || (any && piece != Piece::Queen);
        let is_own = |effect: &&RulingEffect| matches!(effect, RulingEffect::PutBack(coin) if counts(coin.piece));
        let effects = past.rulings.iter().flat_map(|ruling| &ruling.effects);
        let report = &mut self.teams[team];
        report.strokes += 1;
        report.pocketing += u32::from(rank(past) > 0.0);
        report.fouls += u32::from(past.fallen.contains(&Piece::Striker));
        report.put_back += effects.filter(is_own).count() as u32;
        report.hints += u32::from(hinted);
    }
}

/// The rank of a stroke: first by how many wanted pieces it pocketed, then by how difficult that
/// was; 0 if it pocketed none of them, or if it also pocketed the striker.
fn rank(past: &Past) -> f64 {
    let Some(Story {
        first_hit: Some(hit),
        fall: Some(fall),
        also,
    }) = &past.story
    else {
        return 0.0;
    };
    if past.fallen.contains(&Piece::Striker) {
        return 0.0;
    }
    let driven = u8::from(fall.sent_by != Piece::Striker);
    let cushions = fall.cushions + hit.cushions;
    1000.0 * f64::from(1 + also)
        + 100.0 * f64::from(cushions + driven)
        + deg_from_rad(hit.alpha).abs()
}

/// The points after each board of the current game.
fn run(history: &GameHistory) -> Vec<ByTeam<u8>> {
    let mut run = Vec::new();
    for (number, past) in history.moves().iter().enumerate() {
        let mut effects = past.rulings.iter().flat_map(|it| &it.effects);
        if effects.any(|effect| matches!(effect, RulingEffect::BoardWon(_))) {
            let score = history.after(number).score();
            if score.boards <= 1 {
                run.clear();
            }
            run.push(score.points);
        }
    }
    run
}

/// The points after each board, as in "5:0, 5:3".
pub(super) fn run_words(run: &[ByTeam<u8>]) -> String {
    let boards = run.iter().map(|points| {
        let [first, second] = Team::BOTH.map(|team| points[team]);
        format!("{first}:{second}")
    });
    boards.collect::<Vec<_>>().join(", ")
}

//! A player's results at the table, counted from the saved games.

use serde::Serialize;

use super::opponent::{PlayerHand, Strength};
use super::pieces::pocketed;
use super::score::Score;
use super::{BoardCode, BoardWon, ByTeam, Game, Piece, Player, Rules, SavedGame, Seat, Team};

/// The results of one player against the computer. A game counts only if this player is the only
/// person in it and the computer plays on the other side; practice does not count. Boards cleared
/// alone are counted separately.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub(crate) struct Results {
    /// One row for each combination of rules, strength of the computer and steadiness of the
    /// player's hand, the latest first.
    #[serde(rename = "results")]
    pub(crate) rows: Vec<ResultsRow>,
    /// The most pieces that the player pocketed in one turn.
    pub(crate) longest_turn: usize,
    /// The best result on each cleared board for one player, the latest code first.
    pub(crate) boards: Vec<ClearedBoard>,
}

/// The best result on a board for one player.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub(crate) struct ClearedBoard {
    pub(crate) code: BoardCode,
    /// The fewest strokes in which the player cleared the board.
    pub(crate) strokes: usize,
}

/// The results with one set of rules, against one strength of the computer and with one steadiness
/// of the player's hand.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct ResultsRow {
    pub(crate) rules: Rules,
    /// The strength of the computer opponent, or of the stronger of two.
    pub(crate) strength: Strength,
    pub(crate) hand: PlayerHand,
    /// The boards that were won and lost.
    #[serde(rename = "boards_won_and_lost")]
    pub(crate) boards: [usize; 2],
    /// The games that were won and lost; except in tournaments, each board counts as a game.
    #[serde(rename = "games_won_and_lost")]
    pub(crate) games: [usize; 2],
}

impl Results {
    /// The results of the player with this name. The saved games must be in order, the latest
    /// first.
    pub(crate) fn of<'a>(
        player: &str,
        games: impl IntoIterator<Item = &'a (SavedGame, Game)>,
    ) -> Self {
        let mut results = Self::default();
        for (saved, game) in games.into_iter().filter(|(it, _)| it.player == player) {
            if let Some(code) = saved.record.setup.board_code() {
                results.add_board(code, saved, game);
            } else if let Some((seat, strength)) = against_computer(saved) {
                let versus = (game.setup().rules, strength, saved.company.hand);
                results.add(game, game.team(seat), versus);
                let turn = longest_turn(saved, seat);
                results.longest_turn = results.longest_turn.max(turn);
            }
        }
        results
    }

    fn add_board(&mut self, code: BoardCode, saved: &SavedGame, game: &Game) {
        if game.play.won.is_none_or(|won| won.winner != Team::First) {
            return;
        }
        let strokes = saved.record.strokes();
        match self.boards.binary_search_by(|it| code.cmp(&it.code)) {
            Ok(at) => self.boards[at].strokes = strokes.min(self.boards[at].strokes),
            Err(at) => self.boards.insert(at, ClearedBoard { code, strokes }),
        }
    }

    /// The fewest strokes in which the player cleared a board; `None` if it was never cleared.
    pub(crate) fn fewest(&self, code: BoardCode) -> Option<usize> {
        let board = self.boards.iter().find(|board| board.code == code);
        board.map(|board| board.strokes)
    }

    fn add(
        &mut self,
        game: &Game,
        team: Team,
        (rules, strength, hand): (Rules, Strength, PlayerHand),
    ) {
        let won: Vec<BoardWon> = game.finished.iter().copied().chain(game.play.won).collect();
        if won.is_empty() {
            return;
        }
        let both = [team, team.other()];
        let boards = both.map(|team| won.iter().filter(|it| it.winner == team).count());
        let games: ByTeam<u8> = Score::after(game.setup(), &won)
            .before_next_board(game.setup())
            .games;
        let games = match rules {
            Rules::Tournament => both.map(|team| games[team].into()),
            _ => boards,
        };
        let known =
            |row: &&mut ResultsRow| (row.rules, row.strength, row.hand) == (rules, strength, hand);
        match self.rows.iter_mut().find(known) {
            Some(row) => {
                for side in 0..both.len() {
                    row.boards[side] += boards[side];
                    row.games[side] += games[side];
                }
            }
            None => self.rows.push(ResultsRow {
                rules,
                strength,
                hand,
                boards,
                games,
            }),
        }
    }
}

/// The seat of the only person in a game, and the strength of the computer on the other side.
fn against_computer(saved: &SavedGame) -> Option<(Seat, Strength)> {
    let setup = &saved.record.setup;
    let is = |seat: &Seat, player| saved.company.players[*seat as usize] == player;
    let seats = || { Seat::ALL.into_iter() }.filter(|seat| setup.hands.plays(*seat));
    let mut people = seats().filter(|seat| is(seat, Player::Person));
    let (seat, None) = (people.next()?, people.next()) else {
        return None;
    };
    let others = seats().filter(|other| setup.hands.team(*other) != setup.hands.team(seat));
    let strengths = others.map(|other| saved.company.strengths[other as usize]);
    let strength = strengths.reduce(|a, b| if b > a { b } else { a })?;
    (!setup.rules.is_alone()).then_some((seat, strength))
}

/// The most pieces pocketed by the player at this seat in one turn of a game. The player's own
/// coins and the queen count or, in point carrom, all pieces.
fn longest_turn(saved: &SavedGame, seat: Seat) -> usize {
    let (mut longest, mut turn) = (0, 0);
    // A saved game was replayed when it was read, so it has no error.
    let _ = saved.record.play_through(|before, _, shot, _| {
        let Some(shot) = shot.filter(|_| before.seat() == seat) else {
            turn = 0;
            return;
        };
        let fallen = pocketed(before.coins(), &shot);
        let own = before.colour(before.team(seat)).piece();
        let any = before.setup().rules == Rules::Points;
        let counts = |piece: &Piece| any || *piece == own || *piece == Piece::Queen;
        let count = fallen.iter().filter(|piece| counts(piece)).count();
        turn = match count == 0 || fallen.contains(&Piece::Striker) {
            true => 0,
            false => turn + count,
        };
        longest = longest.max(turn);
    });
    longest
}

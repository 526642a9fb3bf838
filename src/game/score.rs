//! Points, boards, games and the match (25, 29, 30).

use serde::{Deserialize, Serialize};

use super::laws::{BoardWon, Rules};
use super::seat::{ByTeam, Team};
use super::table::GameSetup;

/// The number of points that win a game (29a).
pub(super) const GAME_POINTS: u8 = 25;
/// The number of boards after which the leader wins a game (29a).
pub(super) const GAME_BOARDS: u8 = 8;
/// The number of games that win a match: the best of three (30).
pub(super) const MATCH_GAMES: u8 = 2;

/// How long a game at the table lasts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Length {
    /// One board.
    Board,
    /// One game of a tournament; with other rules, each board is a game.
    Game,
    /// A match of a tournament; with other rules, one board after another without end.
    #[default]
    Match,
}

/// The score, calculated from the boards played.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Score {
    /// Points in the current game.
    pub points: ByTeam<u8>,
    /// Boards finished in the current game.
    pub boards: u8,
    /// Earlier games won.
    pub games: ByTeam<u8>,
}

impl Score {
    /// The score after `boards`, the last of which has just finished: if it decided a game, the
    /// points of that game are still included.
    pub(crate) fn after<'a>(
        setup: &GameSetup,
        boards: impl IntoIterator<Item = &'a BoardWon>,
    ) -> Self {
        boards.into_iter().fold(Self::default(), |score, board| {
            let mut score = score.before_next_board(setup);
            let points = &mut score.points[board.winner];
            *points = points.saturating_add(board.points);
            score.boards = score.boards.saturating_add(1);
            score
        })
    }

    /// The score at the start of the next board, after a won game is counted.
    pub(crate) fn before_next_board(mut self, setup: &GameSetup) -> Self {
        if let Some(winner) = self.game_winner(setup) {
            self.points = ByTeam::default();
            self.boards = 0;
            let games = &mut self.games[winner];
            *games = games.saturating_add(1);
        }
        self
    }

    /// The winner of the current game, if there is one.
    ///
    /// In a tournament it is the team that reaches 25 points or leads after the eighth board; extra
    /// boards are played until a tie is broken (29). With other rules, or if only one board is
    /// played, it is the team that wins the board. Practice has no winner.
    pub(crate) fn game_winner(&self, setup: &GameSetup) -> Option<Team> {
        let points = |team: Team| self.points[team];
        let leader =
            { Team::BOTH.into_iter() }.find(|team| points(*team) > points(team.other()))?;
        let decided = match (setup.rules, setup.length) {
            (Rules::Practice, _) => false,
            (Rules::Tournament, Length::Game | Length::Match) => {
                points(leader) >= GAME_POINTS || self.boards >= GAME_BOARDS
            }
            (Rules::Tournament, Length::Board)
            | (Rules::Friendly | Rules::Points | Rules::Solo, _) => self.boards > 0,
        };
        decided.then_some(leader)
    }

    /// Whether the current game is tied after its last board, so that one more is needed (29b).
    pub(crate) fn is_tied(&self, setup: &GameSetup) -> bool {
        setup.rules == Rules::Tournament
            && self.boards >= GAME_BOARDS
            && self.game_winner(setup).is_none()
    }

    /// The winner of the match, if there is one: the first team to win two games of a tournament
    /// (30), or the only game. With other rules, games do not form a match.
    pub(crate) fn match_winner(&self, setup: &GameSetup) -> Option<Team> {
        let winner = self.game_winner(setup)?;
        let needed = match (setup.length, setup.rules) {
            (Length::Board | Length::Game, _) => 1,
            (Length::Match, Rules::Tournament) => MATCH_GAMES,
            (Length::Match, _) => return None,
        };
        (self.games[winner] + 1 >= needed).then_some(winner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn boards(list: &[(Team, u8)]) -> Vec<BoardWon> {
        list.iter()
            .map(|(winner, points)| BoardWon {
                winner: *winner,
                points: *points,
            })
            .collect()
    }

    fn score(list: &[(Team, u8)]) -> Score {
        Score::after(&GameSetup::default(), &boards(list))
    }

    fn setup(rules: Rules, length: Length) -> GameSetup {
        GameSetup {
            rules,
            length,
            ..GameSetup::default()
        }
    }

    use Team::{First, Second};

    #[test]
    fn law_29a_a_game_is_won_at_25_points() {
        let score = score(&[(First, 12), (First, 12), (Second, 5), (First, 1)]);
        assert_eq!(score.points[First], 25);
        assert_eq!(score.game_winner(&GameSetup::default()), Some(First));
        let next = score.before_next_board(&GameSetup::default());
        assert_eq!(next.games[First], 1);
        assert_eq!((next.points[First], next.boards), (0, 0));
    }

    #[test]
    fn law_29a_the_leader_after_eight_boards_wins() {
        let seven = [(First, 1); 7];
        assert_eq!(score(&seven).game_winner(&GameSetup::default()), None);
        let eight = score(&[(First, 1); 8]);
        assert_eq!(eight.game_winner(&GameSetup::default()), Some(First));
    }

    #[test]
    fn law_29b_a_tie_after_eight_boards_is_decided_by_an_extra_board() {
        let mut list = vec![(First, 2); 4];
        list.extend([(Second, 2); 4]);
        let tied = score(&list);
        assert!(tied.is_tied(&GameSetup::default()));
        assert_eq!(tied.game_winner(&GameSetup::default()), None);
        list.push((Second, 1));
        let decided = score(&list);
        assert_eq!(decided.boards, 9);
        assert_eq!(decided.game_winner(&GameSetup::default()), Some(Second));
    }

    #[test]
    fn law_30_a_match_is_the_best_of_three_games() {
        let game = |team| [(team, 12), (team, 12), (team, 1)];
        let one_all = [game(First), game(Second)].concat();
        assert_eq!(score(&one_all).match_winner(&GameSetup::default()), None);
        let won = score(&[game(First), game(Second), game(First)].concat());
        assert_eq!(won.match_winner(&GameSetup::default()), Some(First));
        assert_eq!(
            score(&[game(Second), game(Second)].concat()).match_winner(&GameSetup::default()),
            Some(Second)
        );
    }

    #[test]
    fn a_friendly_board_is_a_game_and_there_is_no_match() {
        let list = boards(&[(First, 4), (Second, 1), (First, 2)]);
        for rules in [Rules::Friendly, Rules::Points] {
            let setup = setup(rules, Length::Match);
            let score = Score::after(&setup, &list);
            assert_eq!(score.game_winner(&setup), Some(First));
            assert_eq!((score.games[First], score.games[Second]), (1, 1));
            assert_eq!(score.match_winner(&setup), None);
        }
    }

    #[test]
    fn a_shorter_length_ends_after_one_board_or_one_game() {
        let one = boards(&[(Second, 1)]);
        for rules in [Rules::Tournament, Rules::Friendly, Rules::Points] {
            let setup = setup(rules, Length::Board);
            let score = Score::after(&setup, &one);
            assert_eq!(score.match_winner(&setup), Some(Second), "{rules:?}");
        }
        let setup = setup(Rules::Tournament, Length::Game);
        let score = Score::after(&setup, &one);
        assert_eq!(score.match_winner(&setup), None);
        let won = Score::after(&setup, &boards(&[(First, 12), (First, 12), (First, 1)]));
        assert_eq!(won.match_winner(&setup), Some(First));
    }
}

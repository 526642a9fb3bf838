//! A whole game at the table: boards one after another, and the score.

use glam::DVec2;
use serde::{Serialize, Serializer};
use strum::IntoStaticStr;

use super::laws::{self, BoardWon, Law, Rules, Ruling, RulingEffect, Verdict};
use super::pack::{jittered_pack, pack};
use super::pieces::{Coin, Colour, Piece, PieceSet};
use super::placing::{BaseLines, Misplaced, check_anywhere};
use super::play::BoardInPlay;
use super::score::{Length, Score};
use super::seat::{ByTeam, Hands, Seat, Team};
use super::stroke::{Stroke, StrokeError};
use super::validity::{GameError, check_coins};
use crate::physics::{Board, Disc, Motion};

/// The settings that are agreed before the first break.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GameSetup {
    /// The rules that the referee applies.
    pub rules: Rules,
    /// Singles or doubles.
    pub hands: Hands,
    /// How long the game lasts.
    pub length: Length,
    /// The set of pieces, which determines their sizes and masses.
    pub set: PieceSet,
    /// Coefficient of restitution of two discs, 0 to 1.
    pub restitution: f64,
    /// The player who won the toss and breaks first (13, 15).
    pub first_breaker: Seat,
    /// Seed for the small irregularities in each pack; `None` for a pack that is exact and the same
    /// every time.
    #[serde(serialize_with = "signed", skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
}

impl Default for GameSetup {
    fn default() -> Self {
        Self {
            rules: Rules::default(),
            hands: Hands::default(),
            length: Length::default(),
            set: PieceSet::default(),
            restitution: Board::default().restitution,
            first_breaker: Seat::default(),
            seed: None,
        }
    }
}

/// Writes a seed as the signed number with the same bits, because TOML has no unsigned numbers.
fn signed<S: Serializer>(seed: &Option<u64>, to: S) -> Result<S::Ok, S::Error> {
    seed.map(u64::cast_signed).serialize(to)
}

/// The state of a game.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr)]
#[strum(serialize_all = "snake_case")]
pub enum GameStage {
    /// A board is being played.
    Playing,
    /// A board has ended, and the game continues with the next.
    BoardOver(BoardWon),
    /// The game has been won, and another may follow.
    GameOver(Team),
    /// The match has been won.
    MatchOver(Team),
}

/// A game of carrom: its settings, the finished boards and the board in play.
///
/// Everything else is calculated from these. To undo, keep a clone of the game.
#[derive(Debug, Clone, PartialEq)]
pub struct Game {
    pub(super) setup: GameSetup,
    pub(super) finished: Vec<BoardWon>,
    pub(super) play: BoardInPlay,
}

impl Game {
    /// A new game with the pack set up. In singles, South breaks first unless `setup` names North,
    /// because nobody sits at East or West.
    pub fn new(setup: GameSetup) -> Self {
        let first_breaker = match setup.hands {
            Hands::Two if !setup.hands.plays(setup.first_breaker) => Seat::South,
            _ => setup.first_breaker,
        };
        let setup = GameSetup {
            first_breaker,
            ..setup
        };
        Self {
            setup,
            finished: Vec::new(),
            play: break_board(&setup, 0, first_breaker),
        }
    }

    /// The settings that are agreed before the first break.
    pub fn setup(&self) -> &GameSetup {
        &self.setup
    }

    /// The board that the discs slide on, with the restitution of this game.
    pub(crate) fn board(&self) -> Board {
        Board {
            restitution: self.setup.restitution,
            ..Board::default()
        }
    }

    /// The board in play.
    pub fn play(&self) -> &BoardInPlay {
        &self.play
    }

    /// The coins on the board.
    pub fn coins(&self) -> &[Coin] {
        &self.play.coins
    }

    /// Whose turn it is.
    pub fn seat(&self) -> Seat {
        self.play.seat
    }

    /// The team of a seat.
    pub fn team(&self, seat: Seat) -> Team {
        self.setup.hands.team(seat)
    }

    /// The colour a team has in this board (16).
    pub fn colour(&self, team: Team) -> Colour {
        self.play.colour(team)
    }

    /// The number of this board in its game, from 1.
    pub(crate) fn board_number(&self) -> u8 {
        self.score_before().boards.saturating_add(1)
    }

    /// The score, including this board once it has ended.
    pub fn score(&self) -> Score {
        match &self.play.won {
            Some(won) => Score::after(&self.setup, self.finished.iter().chain([won])),
            None => self.score_before(),
        }
    }

    /// The points of both teams: in the current game or, in point carrom, on this board.
    pub fn points(&self) -> ByTeam<u8> {
        let mut points = self.score().points;
        if self.setup.rules == Rules::Points {
            for team in Team::BOTH {
                points[team] = self.play.points_taken(team);
            }
        }
        points
    }

    /// The stage of the game.
    pub fn stage(&self) -> GameStage {
        let setup = &self.setup;
        let Some(won) = self.play.won else {
            return GameStage::Playing;
        };
        let score = self.score();
        match (score.match_winner(setup), score.game_winner(setup)) {
            (Some(team), _) => GameStage::MatchOver(team),
            (None, Some(team)) => GameStage::GameOver(team),
            (None, None) => GameStage::BoardOver(won),
        }
    }

    /// The base lines of the player whose turn it is.
    pub fn base_lines(&self) -> BaseLines<'_> {
        BaseLines::new(self.setup.set, self.seat(), self.coins())
    }

    /// Whether the striker may be placed at `at` for the next stroke: within the base lines or, in
    /// a practice game, at any free position.
    ///
    /// # Errors
    /// Returns the reason if the striker may not be placed there.
    pub(crate) fn check_place(&self, at: DVec2) -> Result<(), Misplaced> {
        match self.setup.rules {
            Rules::Practice => check_anywhere(self.setup.set, self.coins(), at),
            _ => self.base_lines().check(at),
        }
    }

    /// The discs and motions of the next stroke, for the engine: the striker with
    /// its motion first, then the coins at rest in their order.
    pub fn discs(&self, striker: Motion) -> (Vec<Disc>, Vec<Motion>) {
        let striker = (self.setup.set.disc(Piece::Striker), striker);
        let coins = self
            .coins()
            .iter()
            .map(|coin| (self.setup.set.disc(coin.piece), Motion::at_rest(coin.at)));
        std::iter::once(striker).chain(coins).unzip()
    }

    /// Applies the rules to a stroke of the player whose turn it is, and returns the referee's
    /// rulings, the decisive one first.
    ///
    /// # Errors
    /// Returns an error if the board has ended or the stroke is impossible on it; the game is then
    /// unchanged.
    pub fn apply(&mut self, stroke: &Stroke) -> Result<Vec<Ruling>, StrokeError> {
        if self.play.won.is_some() {
            return Err(StrokeError::Ended);
        }
        stroke.check(self.coins())?;
        let team = self.team(self.seat());
        let case = self.play.case(team, &self.score_before(), stroke);
        let verdict = laws::judge(self.setup.rules, &case);
        self.play.take_in(&self.setup, stroke);
        Ok(self.carry_out(verdict))
    }

    /// Passes the turn because coins block every position of the striker.
    ///
    /// # Errors
    /// Returns an error if the board has ended.
    pub fn no_place(&mut self) -> Result<Vec<Ruling>, StrokeError> {
        if self.play.won.is_some() {
            return Err(StrokeError::Ended);
        }
        let verdict = laws::no_place(self.setup.rules, self.play.queen_to_cover());
        Ok(self.carry_out(verdict))
    }

    /// Sets up the pack for the next board, and for the next game when one has been won.
    ///
    /// # Errors
    /// Returns an error if this board has not ended, or if the match has.
    pub fn next_board(&mut self) -> Result<(), GameError> {
        let Some(won) = self.play.won else {
            return Err(GameError::StillPlaying);
        };
        if let GameStage::MatchOver(_) = self.stage() {
            return Err(GameError::MatchOver);
        }
        self.finished.push(won);
        let breaker = self.breaker();
        let board = u64::try_from(self.finished.len()).unwrap_or(u64::MAX);
        self.play = break_board(&self.setup, board, breaker);
        Ok(())
    }

    /// Places `coins` on the board as given, in a practice game.
    ///
    /// # Errors
    /// Returns an error if this is not a practice game, or if the coins cannot be at these
    /// positions; the game is then unchanged.
    pub(crate) fn lay_out(&mut self, coins: Vec<Coin>) -> Result<(), GameError> {
        if self.setup.rules != Rules::Practice {
            return Err(GameError::NotInPractice);
        }
        check_coins(&coins, self.setup.set)?;
        let seat = self.seat();
        let mut play = BoardInPlay::new(coins, seat, self.play.white);
        play.queen_covered_by = (!play.queen_on_board()).then(|| self.team(seat));
        self.play = play;
        Ok(())
    }

    /// Carries out a verdict, and announces the end of a game or match that it causes.
    fn carry_out(&mut self, verdict: Verdict) -> Vec<Ruling> {
        let mut rulings = self.play.carry_out(&self.setup, verdict);
        if self.play.won.is_some() && self.setup.rules != Rules::Solo {
            rulings.extend(self.announce_end());
        }
        rulings
    }

    /// The rulings on the game and the match after a finished board.
    fn announce_end(&self) -> Vec<Ruling> {
        let GameSetup { rules, length, .. } = self.setup;
        let score = self.score();
        let mut rulings = Vec::new();
        let mut announce = |law, text, effect| {
            rulings.push(Ruling {
                law: (rules == Rules::Tournament).then_some(law),
                text,
                effects: vec![effect],
            });
        };
        if score.is_tied(&self.setup) {
            let text = "The score is level after the last board, so one more decides.".to_owned();
            announce(Law::EXTRA_BOARD, text, RulingEffect::ExtraBoard);
        }
        if let Some(team) = score.game_winner(&self.setup)
            && rules == Rules::Tournament
            && length != Length::Board
        {
            let (won, lost) = (score.points[team], score.points[team.other()]);
            let text = format!("{} wins the game by {won} to {lost}.", self.colour(team));
            announce(Law::GAME, text, RulingEffect::GameWon(team));
        }
        if let Some(team) = score.match_winner(&self.setup)
            && length == Length::Match
        {
            let colour = self.colour(team);
            let text = format!("That makes two games for {colour}, who wins the match.");
            announce(Law::MATCH, text, RulingEffect::MatchWon(team));
        }
        rulings
    }

    fn score_before(&self) -> Score {
        Score::after(&self.setup, &self.finished).before_next_board(&self.setup)
    }

    /// The player who breaks the board after the finished ones: the break passes from seat to seat
    /// with each board (22), and each game begins one seat further on (22a). This order, not a toss
    /// (29b), also decides who breaks an extra board.
    fn breaker(&self) -> Seat {
        let score = self.score_before();
        let steps = match self.setup.rules {
            Rules::Practice | Rules::Solo => 0,
            _ => {
                let games = Team::BOTH.map(|team| u32::from(score.games[team]));
                games.iter().sum::<u32>() + u32::from(score.boards)
            }
        };
        // After four steps the order repeats, in doubles and in singles.
        (0..steps % 4).fold(self.setup.first_breaker, |seat, _| {
            self.setup.hands.next(seat)
        })
    }
}

fn break_board(setup: &GameSetup, board: u64, breaker: Seat) -> BoardInPlay {
    let white = setup.hands.team(breaker);
    if let Some(code) = setup.board_code() {
        return BoardInPlay {
            break_tries: None,
            queen_covered_by: Some(white),
            ..BoardInPlay::new(code.coins(), breaker, white)
        };
    }
    let coins = match setup.seed {
        Some(seed) => jittered_pack(setup.set, breaker, seed.wrapping_add(board)),
        None => pack(setup.set, breaker),
    };
    BoardInPlay::new(coins, breaker, white)
}

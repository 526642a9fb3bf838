//! A game in progress at the table. Each phase has its own file: aiming, showing the computer's
//! aim, calling, watching a stroke and examining its impacts, arranging coins, and the end of a
//! board.

mod aiming;
mod arranging;
mod calling;
mod keeping;
mod over;
mod pictures;
mod playing;
mod pulling;
mod score;
mod showing;
#[cfg(test)]
mod tests;
mod trays;
mod watching;

use strum::{EnumMessage, IntoStaticStr};

use super::aim::Aim;
use super::game_history::GameHistory;
use super::options::Options;
use super::pointer::Pointer;
use super::preview::{FirstHit, Preview};
use crate::game::opponent::StrokeHint;
use crate::game::{BoardCode, Game, GameStage, Move, PieceSet, Player, Rules, Seat, Strike};
use crate::numbers::capital;
use crate::physics::Shot;
use crate::screens::{Context, Next, StrikeGuard};
use crate::widgets::NumberEntry;
pub(super) use aiming::AimAction;
use arranging::Arrange;
pub(super) use arranging::ArrangeAction;
use calling::Calling;
use keeping::GameKeeping;
pub(super) use playing::Playing;
use pulling::Grip;
use showing::ShownStroke;
pub(super) use watching::StrokeAction;
use watching::StrokeReplay;

/// A game in progress, and the stroke that is being set up.
#[derive(Debug, Clone)]
pub(super) struct ActiveGame {
    pub(super) options: Options,
    pub(super) history: GameHistory,
    pub(super) aim: Aim,
    /// The first contact of the aim, cached because the engine has to compute it.
    pub(super) preview: Option<Preview>,
    /// The aim for which the preview was computed, and the number of moves at that time.
    previewed: Option<(Aim, usize)>,
    /// A number that is being typed.
    entry: NumberEntry,
    /// The hint for the next stroke, if the player has requested one.
    pub(super) hint: Option<Hinted>,
    /// What the mouse is dragging.
    grip: Grip,
    /// A notice about the last action, such as why it had no effect.
    notice: Option<String>,
    guard: StrikeGuard,
    keeping: GameKeeping,
    /// The par of a board for one player.
    par: Option<usize>,
}

#[derive(Debug, Clone)]
enum GamePhase {
    /// Aiming the next stroke.
    Aim,
    /// The computer's aim is shown before its stroke.
    Show(Box<ShownStroke>),
    /// Predicting the directions after the first impact.
    Call(Box<Calling>),
    Watch(Box<StrokeReplay>),
    /// Arranging the coins of a practice game.
    Arrange(Arrange),
    /// The board has ended.
    Over,
}

/// What the keys do in a game, apart from aiming, calls, replays and arranging coins.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum GameAction {
    /// show the last stroke again, with its impacts
    LookBack,
    /// watch the whole game again, stroke by stroke
    WatchAll,
    /// export: write the game to a separate file
    Export,
    /// let the computer strike at once
    StrikeShown,
    /// call: predict the directions of the two discs after the first collision of the computer's stroke
    CallShown,
    /// start the next board, or end the match
    NextBoard,
    /// watch the best stroke of the board again
    WatchBest,
    /// go back
    Back,
}

/// The consequence of an input.
#[derive(Debug)]
enum After {
    /// Another phase begins.
    Phase(GamePhase),
    /// The phase continues, with a consequence for the whole screen.
    Screen(Next),
}

/// Another phase; with `None` the current one continues.
impl From<Option<GamePhase>> for After {
    fn from(phase: Option<GamePhase>) -> Self {
        phase.map_or(Self::Screen(Next::Stay), Self::Phase)
    }
}

/// A hint that the player has requested.
#[derive(Debug, Clone)]
pub(super) struct Hinted {
    hint: StrokeHint,
    /// The coin that the hint refers to, if any, and its pocket.
    pub(super) pointer: Option<Pointer>,
    /// Whether the whole hint is shown, not only where to look.
    whole: bool,
}

impl ActiveGame {
    pub(super) fn new(options: Options, seed: u64) -> Self {
        let history = GameHistory::new(options.seeded(seed));
        Self::with(options, history)
    }

    /// Begins a game on a board for one player with this par.
    pub(super) fn on_board(code: BoardCode, par: Option<usize>) -> Self {
        Self {
            par,
            ..Self::new(Options::solo(), code.seed())
        }
    }

    fn with(options: Options, history: GameHistory) -> Self {
        let mut active = Self {
            aim: Aim::begin(history.game()),
            par: None,
            options,
            history,
            preview: None,
            previewed: None,
            entry: NumberEntry::default(),
            hint: None,
            grip: Grip::default(),
            notice: None,
            guard: StrikeGuard::default(),
            keeping: GameKeeping::default(),
        };
        active.look_ahead();
        active
    }

    /// The game in its current state.
    pub(super) fn game(&self) -> &Game {
        self.history.game()
    }

    /// The set of pieces in use.
    pub(super) fn set(&self) -> PieceSet {
        self.game().setup().set
    }

    /// The seat whose turn it is.
    pub(super) fn seat(&self) -> Seat {
        self.game().seat()
    }

    pub(super) fn is_practice(&self) -> bool {
        self.game().setup().rules == Rules::Practice
    }

    /// The code of the board, if it is a board for one player.
    fn board_code(&self) -> Option<BoardCode> {
        self.game().setup().board_code()
    }

    fn is_computers_turn(&self) -> bool {
        self.options.player(self.seat()) == Player::Computer
    }

    /// Whether leaving now would interrupt a game.
    fn is_running(&self) -> bool {
        self.history.len() > 0 && !matches!(self.game().stage(), GameStage::MatchOver(_))
    }

    /// The next phase of the game: the player's aim, the computer's aim, or the end of the
    /// board.
    fn turn(&mut self, cx: &Context) -> GamePhase {
        match self.game().stage() {
            GameStage::Playing if self.is_computers_turn() => self.think(cx),
            GameStage::Playing => GamePhase::Aim,
            _ => GamePhase::Over,
        }
    }

    /// The next phase after earlier strokes have been watched. If it is the computer's turn, the
    /// end of the last stroke is shown until the game continues.
    fn turn_after_replay(&mut self, cx: &Context) -> GamePhase {
        if self.game().stage() == GameStage::Playing
            && self.is_computers_turn()
            && let Some(GamePhase::Watch(mut last)) = self.look_back(cx)
        {
            last.live = true;
            return GamePhase::Watch(last);
        }
        self.turn(cx)
    }

    /// Makes a move and begins the next turn; shows a notice if the move is impossible. Returns
    /// the shot if the move was a stroke.
    fn make(&mut self, next: Move) -> Option<Shot> {
        match self.history.make(next) {
            Ok(shot) => {
                self.begin_turn();
                shot
            }
            Err(error) => {
                self.notice = Some(format!("{}.", capital(&error.to_string())));
                None
            }
        }
    }

    /// Plays a stroke and starts its replay; `None` if the stroke cannot be played.
    fn play(&mut self, strike: Strike, cx: &Context) -> Option<GamePhase> {
        let number = self.history.len();
        let shot = self.make(Move::Strike(strike))?;
        let past = self.history.past(number)?;
        let at_end = cx.settings.reduced_motion;
        let mut replay = StrokeReplay::new(number, shot, past, at_end, cx);
        replay.live = true;
        Some(GamePhase::Watch(Box::new(replay)))
    }

    /// The replay of an earlier stroke, at its end or from its beginning.
    fn look_at(&mut self, stroke: Option<usize>, at_end: bool, cx: &Context) -> Option<GamePhase> {
        let Some(number) = stroke else {
            self.notice = Some("There is no stroke to look at yet.".into());
            return None;
        };
        let (past, shot) = (self.history.past(number)?, self.history.shot(number)?);
        let replay = StrokeReplay::new(number, shot, past, at_end, cx);
        Some(GamePhase::Watch(Box::new(replay)))
    }

    /// The replay of the last stroke, at its end.
    fn look_back(&mut self, cx: &Context) -> Option<GamePhase> {
        let last = self.history.stroke_before(self.history.len());
        self.look_at(last, true, cx)
    }

    /// The replay of the game from its first stroke.
    fn watch_all(&mut self, cx: &Context) -> Option<GamePhase> {
        let first = self.history.stroke_from(0);
        self.look_at(first, cx.settings.reduced_motion, cx)
    }

    /// Sets the aim for the next turn. In a practice game it stays the same if possible, so that
    /// the player can try again with a small change.
    fn begin_turn(&mut self) {
        if !self.is_practice() || self.game().check_place(self.aim.place).is_err() {
            let speed = self.aim.speed;
            self.aim = Aim::begin(self.game());
            if !self.game().play().is_unbroken() {
                self.aim.speed = speed;
            }
        }
        self.entry.take();
        self.hint = None;
        self.grip = Grip::default();
    }

    /// Passes, because coins block every position of the striker.
    fn pass(&mut self) {
        let number = self.history.len();
        self.make(Move::NoPlace);
        if let Some(past) = self.history.past(number) {
            self.notice = past.rulings.first().map(|ruling| ruling.text.clone());
        }
    }

    /// The aim, with the direction that is being typed.
    pub(super) fn aimed(&self) -> Aim {
        let mut aim = self.aim;
        if let Some(degrees) = self.entry.value() {
            aim.set_shown(degrees, self.seat());
        }
        aim
    }

    /// Computes the first contact if the aim or the game has changed.
    fn look_ahead(&mut self) {
        let aim = (self.aimed(), self.history.len());
        if self.previewed.replace(aim) != Some(aim) {
            self.preview = Preview::of(&aim.0.strike(self.seat()), self.game());
        }
    }

    /// The first collision of the aim, if there is one.
    pub(super) fn first_hit(&self) -> Option<FirstHit> {
        self.preview.as_ref()?.hit.ok()
    }
}

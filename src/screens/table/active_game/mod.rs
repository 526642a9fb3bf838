//! A game in progress at the table.
//!
//! One file a thing that one does there: aiming, calling, watching a stroke,
//! looking into one impact, laying coins out, keeping the game.

mod aiming;
mod arranging;
mod calling;
mod keeping;
mod pulling;
mod showing;
mod thinking;
mod watching;

use std::time::Duration;

use glam::DVec2;

use super::aim::Aim;
use super::arrange::Arrange;
use super::computer_stroke::ComputerStroke;
use super::game_history::{CallTally, GameHistory};
use super::keys::TableAction;
use super::options::Options;
use super::pointer::Pointer;
use super::preview::{FirstHit, Preview};
use super::replay::StrokeReplay;
use super::tale::BoardTale;
use super::{panel, view};
use crate::game::opponent::StrokeHint;
use crate::game::{ByTeam, Game, GameStage, Move, PieceSet, Rules, Seat};
use crate::messages::{Input, Mouse, MouseKind, StoreRequest};
use crate::numbers::capital;
use crate::physics::{Board, Shot};
use crate::screens::{Confirmation, Context, Next};
use crate::widgets::hit::HitPace;
use crate::widgets::replay::ShotAction;
use crate::widgets::{NumberEntry, Outcome, RayInput, Scroll, SplitLayout, board};
pub(super) use keeping::GameKeeping;
pub(super) use pulling::Grip;
pub(super) use showing::ShownStroke;

/// A game in progress, and what is being done at the table.
#[derive(Debug, Clone)]
pub(super) struct ActiveGame {
    pub(super) options: Options,
    pub(super) history: GameHistory,
    pub(super) aim: Aim,
    /// What the aim will meet; kept, because it takes an engine to know.
    pub(super) preview: Option<Preview>,
    /// An angle being typed.
    pub(super) entry: NumberEntry,
    pub(super) phase: TablePhase,
    /// What has to be said just now: why something cannot be done.
    pub(super) notice: Option<String>,
    /// Help with the next stroke.
    pub(super) hint: Option<Hinted>,
    /// How far the panel is scrolled.
    pub(super) scroll: Scroll,
    /// How it is kept.
    pub(super) keeping: GameKeeping,
    /// What the mouse holds while its button is down.
    pub(super) grip: Grip,
}

/// What is being done at the table.
#[derive(Debug, Clone)]
pub(super) enum TablePhase {
    /// Aiming the next stroke.
    Aim,
    /// Seeing the computer's stroke before it is struck.
    Show(Box<ShownStroke>),
    /// Saying where the two of the first impact will go.
    Call(Box<Calling>),
    /// Watching a stroke.
    Watch(Box<StrokeReplay>),
    /// Laying coins out, in practice.
    Arrange(Arrange),
    /// The board has ended.
    Over,
}

/// A hint that was asked for.
#[derive(Debug, Clone)]
pub(super) struct Hinted {
    pub(super) hint: StrokeHint,
    /// What it speaks of on the board, if it speaks of a coin.
    pub(super) pointer: Option<Pointer>,
    /// Whether all of it is told, or only where to look.
    pub(super) whole: bool,
}

/// A call in the making.
#[derive(Debug, Clone)]
pub(super) struct Calling {
    pub(super) hit: FirstHit,
    pub(super) rays: RayInput,
    /// The computer's stroke, if it is one of those.
    pub(super) of: Option<Box<ComputerStroke>>,
}

impl ActiveGame {
    /// Sits down to a new game.
    pub(super) fn new(options: Options, seed: u64) -> Self {
        Self::with(options, GameHistory::new(options.setup(seed)))
    }

    fn with(options: Options, history: GameHistory) -> Self {
        let mut active = Self {
            aim: Aim::begin(history.game()),
            options,
            history,
            preview: None,
            entry: NumberEntry::default(),
            phase: TablePhase::Aim,
            notice: None,
            hint: None,
            scroll: Scroll::default(),
            keeping: GameKeeping::default(),
            grip: Grip::default(),
        };
        active.look_ahead();
        active
    }

    /// Whether there is a long hint to read, for which the page keys are needed.
    pub(super) fn reads_hint(&self) -> bool {
        self.hint.as_ref().is_some_and(|hinted| hinted.whole)
    }

    /// The game as it stands.
    pub(super) fn game(&self) -> &Game {
        self.history.game()
    }

    /// The pieces it is played with.
    pub(super) fn set(&self) -> PieceSet {
        self.game().setup().set
    }

    /// Whose turn it is.
    pub(super) fn seat(&self) -> Seat {
        self.game().seat()
    }

    /// Whether this is practice.
    pub(super) fn is_practice(&self) -> bool {
        self.game().setup().rules == Rules::Practice
    }

    /// Does what a key stands for. What it asks about is leaving the game.
    pub(super) fn act(&mut self, action: TableAction, cx: &mut Context) -> Next {
        self.hand_over(cx);
        if let TableAction::Scroll(rows) = action {
            self.scroll_by(rows, cx);
            return Next::Stay;
        }
        self.scroll = Scroll::default();
        self.notice = None;
        let next = self.act_now(action, cx);
        if next == Next::Stay {
            self.hand_over(cx);
        }
        self.save(cx);
        next
    }

    fn act_now(&mut self, action: TableAction, cx: &mut Context) -> Next {
        match action {
            TableAction::Number(action) => {
                if let Outcome::Done(degrees) = self.entry.act(action) {
                    self.aim.set_shown(degrees, self.seat());
                }
                self.look_ahead();
            }
            TableAction::Ray(action) => self.act_on_call(action, cx),
            TableAction::Replay(action) => self.act_on_replay(action, cx),
            TableAction::GoOn => self.go_on_from_stroke(cx),
            TableAction::ToTheEnd => self.act_on_replay(ShotAction::Seek(f64::INFINITY), cx),
            TableAction::StrokeBefore => {
                let watched = self.watched();
                self.look_at(self.history.stroke_before(watched), true, cx);
            }
            TableAction::StrokeAfter => {
                let watched = self.watched();
                self.look_at(self.history.stroke_from(watched + 1), true, cx);
            }
            TableAction::LookBack => {
                let last = self.history.stroke_before(self.history.len());
                self.look_at(last, true, cx);
            }
            TableAction::WatchAll => self.watch_all(cx),
            TableAction::WatchBest => {
                let best = self.tale().best;
                self.look_at(best, cx.settings.reduced_motion, cx);
            }
            TableAction::StrikeShown => self.strike_shown(cx),
            TableAction::CallShown => self.call_shown(cx),
            TableAction::Export => {
                let game = Box::new(self.saved(cx));
                cx.ask(StoreRequest::Export(game));
            }
            TableAction::NextBoard => {
                if let GameStage::MatchOver(_) = self.game().stage() {
                    return Next::Back;
                }
                self.make(Move::NextBoard);
                self.go_on();
            }
            TableAction::Back => return self.back(cx),
            action if matches!(self.phase, TablePhase::Arrange(_)) => self.act_on_layout(action),
            action => self.act_on_aim(action, cx),
        }
        Next::Stay
    }

    /// One step back: out of a call, a stroke that is watched, or laying out; from there
    /// out of the game.
    fn back(&mut self, cx: &Context) -> Next {
        match self.phase {
            TablePhase::Aim if self.is_pulling() => self.let_slip(),
            TablePhase::Call(_) => self.leave_call(cx),
            TablePhase::Arrange(_) => self.phase = TablePhase::Aim,
            TablePhase::Watch(ref replay) if !replay.live || !self.is_running() => self.go_on(),
            _ if self.is_running() => return Next::Confirm(self.parting()),
            _ => return Next::Back,
        }
        Next::Stay
    }

    /// What is asked before the game is left.
    fn parting(&self) -> Confirmation {
        let kept = match self.keeping.saved {
            Some(true) => " It is saved: on the page of a new game, s brings it back.",
            _ => "",
        };
        Confirmation::new(format!("Leave this game?{kept}"), "leave", "play on")
    }

    /// Takes an input that is no key.
    pub(super) fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        self.hand_over(cx);
        let used = match input {
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            Input::Kept(answer) => {
                self.take_answer(answer);
                true
            }
            _ => false,
        };
        self.hand_over(cx);
        self.save(cx);
        Next::after(used)
    }

    /// A click on the board at its end is the key to go on with.
    fn over_mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> bool {
        let on_board = view::layout(self, cx.room()).picture;
        let clicked = mouse.kind == MouseKind::Down && on_board.contains(mouse.cell().into());
        // The match is left by a key: by a click it would be gone unread.
        if clicked && !matches!(self.game().stage(), GameStage::MatchOver(_)) {
            self.act_now(TableAction::NextBoard, cx);
        }
        clicked
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> bool {
        self.notice = None;
        match &mut self.phase {
            TablePhase::Aim => self.aiming_mouse(mouse, cx),
            TablePhase::Show(_) => self.showing_mouse(mouse, cx),
            TablePhase::Call(_) => self.calling_mouse(mouse, cx),
            TablePhase::Watch(_) => self.watching_mouse(mouse, cx),
            TablePhase::Arrange(_) => self.arranging_mouse(mouse, cx),
            TablePhase::Over => self.over_mouse(mouse, cx),
        }
    }

    /// Where on the board the mouse is, and whether that is on its picture.
    fn pointed(mouse: &Mouse, cx: &Context) -> (DVec2, bool) {
        let area = board::square(SplitLayout::square(cx.room()).picture);
        let at = board::view(area, &Board::default()).to_world(mouse.place());
        (at, area.contains(mouse.cell().into()))
    }

    fn scroll_by(&mut self, rows: i16, cx: &Context) {
        let area = view::layout(self, cx.room()).panel;
        let look = cx.settings.look();
        self.scroll = self
            .scroll
            .by(rows, area, look, |lines| panel::write(self, lines));
    }

    /// Lets time pass on the screen.
    pub(super) fn advance(&mut self, passed: Duration, cx: &mut Context) {
        self.hand_over(cx);
        if let TablePhase::Watch(replay) = &mut self.phase {
            replay.player.advance(passed, cx.settings.pace());
        }
        self.advance_end(passed, cx);
        self.advance_shown(passed, cx);
    }

    /// When it next needs time.
    pub(super) fn wake(&self, pace: HitPace) -> Option<Duration> {
        match &self.phase {
            TablePhase::Watch(replay) => {
                let running = replay.player.wake(pace);
                running.or_else(|| self.end_left(pace))
            }
            TablePhase::Show(shown) => shown.wake(),
            TablePhase::Aim if self.is_computers_turn() => Some(Duration::ZERO),
            _ => None,
        }
    }

    /// Whether leaving now would break a game off.
    fn is_running(&self) -> bool {
        self.history.len() > 0 && !matches!(self.game().stage(), GameStage::MatchOver(_))
    }

    /// Goes on with the game as it stands: aiming, or the end of the board.
    fn go_on(&mut self) {
        self.phase = match self.game().stage() {
            GameStage::Playing => TablePhase::Aim,
            _ => TablePhase::Over,
        };
    }

    /// Makes a move and begins the turn that follows; says in words if it cannot be
    /// made. Gives the shot if it was a stroke.
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

    /// A fresh aim for the game as it stands. In practice the aim stays as long as it
    /// can, to try the same again with a little more or less of something.
    fn begin_turn(&mut self) {
        if !self.is_practice() || self.aim.check(self.game()).is_err() {
            let speed = self.aim.speed;
            self.aim = Aim::begin(self.game());
            if !self.game().play().is_unbroken() {
                self.aim.speed = speed;
            }
        }
        self.entry.take();
        self.hint = None;
        self.grip = Grip::default();
        self.look_ahead();
    }

    /// What the calls have brought.
    pub(super) fn calls(&self) -> ByTeam<CallTally> {
        self.history
            .calls(|game, seat| self.options.caller(game, seat))
    }

    /// What there is to tell of the present board.
    pub(super) fn tale(&self) -> BoardTale {
        BoardTale::of(&self.history)
    }

    /// Passes, because coins bar every place for the striker.
    fn pass(&mut self) {
        let number = self.history.len();
        self.phase = TablePhase::Aim;
        self.make(Move::NoPlace);
        if let Some(past) = self.history.past(number) {
            self.notice = past.rulings.first().map(|ruling| ruling.text.clone());
        }
    }

    /// The aim with the number that is being typed for its direction.
    pub(super) fn aimed(&self) -> Aim {
        let mut aim = self.aim;
        if let Some(degrees) = self.entry.value() {
            aim.set_shown(degrees, self.seat());
        }
        aim
    }

    /// Works out what the aim will meet.
    fn look_ahead(&mut self) {
        self.preview = Preview::of(&self.aimed().strike(self.seat()), self.game());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::SavedGame;
    use crate::messages::Key;
    use crate::screens::Settings;

    fn context() -> Context {
        let settings = Settings {
            reduced_motion: true,
            ..Settings::default()
        };
        Context::new(settings, 1)
    }

    fn press(active: &mut ActiveGame, keys: &str, cx: &mut Context) {
        for letter in keys.chars() {
            let key = match letter {
                '\n' => Key::Enter,
                '\t' => Key::Tab,
                '^' => Key::Up,
                other => Key::Char(other),
            };
            let action = super::super::keys::keys(active).find(key);
            if let Some(action) = action {
                active.act(action, cx);
            }
        }
    }

    /// What was written down leads to what is on the table, to the last bit, also by
    /// way of a file.
    fn assert_recorded(active: &ActiveGame, cx: &Context) {
        let text = active.saved(cx).text().unwrap();
        let (read, game) = SavedGame::read("a game", text.as_bytes()).unwrap();
        assert_eq!(&game, active.game());
        let again = ActiveGame::resume_saved(&read, 1).unwrap();
        assert_eq!(again.options, active.options);
        assert_eq!(again.history.len(), active.history.len());
        assert_eq!(again.calls(), active.calls());
    }

    #[test]
    fn the_record_replays_to_the_game_on_the_table() {
        let mut cx = context();
        let mut active = ActiveGame::new(Options::two_people(), 4);
        press(&mut active, "c[[97.3 60\n30\n\n", &mut cx);
        press(&mut active, "c]]]]268 \n+++++}101 \n{{300.55 \n", &mut cx);
        assert_eq!(active.history.len(), 4);
        assert!(active.history.past(0).unwrap().called.is_some());
        assert_recorded(&active, &cx);

        let practice = Options {
            rules: Rules::Practice,
            ..Options::default()
        };
        let mut active = ActiveGame::new(practice, 4);
        press(&mut active, "91 \np\t ^^^^^^^^ p80 \n85 \nz", &mut cx);
        assert_eq!(active.history.len(), 3);
        assert_recorded(&active, &cx);
    }

    #[test]
    fn the_computer_shows_its_stroke_and_then_plays_it() {
        let mut cx = context();
        let options = Options {
            players: [super::super::options::Player::Computer; 4],
            ..Options::default()
        };
        let mut active = ActiveGame::new(options, 4);
        // Nobody has to press a key for it.
        assert!(active.wake(HitPace::Still).is_some());
        active.advance(Duration::ZERO, &mut cx);
        assert!(matches!(active.phase, TablePhase::Show(_)));
        assert_eq!(active.history.len(), 0);
        active.advance(Duration::from_secs(2), &mut cx);
        assert!(matches!(active.phase, TablePhase::Watch(_)));
        assert!(active.history.past(0).unwrap().meant.is_some());
        assert_recorded(&active, &cx);
        press(&mut active, "\n", &mut cx);
        assert!(matches!(active.phase, TablePhase::Show(_)));
    }

    #[test]
    fn computers_play_on_by_themselves_unless_all_waits() {
        let mut cx = Context::new(Settings::default(), 1);
        let options = Options {
            players: [super::super::options::Player::Computer; 4],
            ..Options::default()
        };
        let mut active = ActiveGame::new(options, 4);
        active.play(Move::Strike(active.aim.strike(active.seat())), &cx);
        let mut waits = active.clone();
        let mut passed = 0;
        while matches!(active.phase, TablePhase::Watch(_)) {
            let wake = active.wake(HitPace::Flowing);
            assert!(wake.is_some() && passed < 100_000);
            active.advance(wake.unwrap(), &mut cx);
            passed += 1;
        }
        assert!(matches!(active.phase, TablePhase::Aim));
        // Whoever wants to press a key for each step is waited for here, too.
        cx.settings.wait_at_beats = true;
        waits.advance(Duration::from_secs(60), &mut cx);
        waits.advance(Duration::from_secs(60), &mut cx);
        assert!(matches!(waits.phase, TablePhase::Watch(_)));
        assert_eq!(waits.wake(HitPace::Waiting), None);
    }

    #[test]
    fn nothing_moves_but_a_stroke_that_is_watched() {
        let mut cx = Context::new(Settings::default(), 1);
        let mut active = ActiveGame::new(Options::two_people(), 4);
        assert_eq!(active.wake(HitPace::Still), None);
        press(&mut active, " ", &mut cx);
        assert!(active.wake(HitPace::Still).is_some());
        active.advance(Duration::from_secs(60), &mut cx);
        assert_eq!(active.wake(HitPace::Still), None);
    }
}

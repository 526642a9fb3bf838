//! A game and its current phase. Each phase has its own keys, picture and panel.

use std::time::Duration;

use ratatui::layout::Rect;

use super::{ActiveGame, After, AimAction, GameAction, GamePhase, arranging, pictures, trays};
use crate::game::laws::POINTS_TO_WIN;
use crate::game::{GameStage, Piece, Rules};
use crate::messages::{Key, Mouse, StoreRequest};
use crate::screens::table::{TableAction, TablePanel, picture, words};
use crate::screens::{Confirmation, Context, Next, StrikeGuard, View};
use crate::widgets::hit::{CONTACT, Face, HitPace, contact_picture};
use crate::widgets::input::KeyTable;
use crate::widgets::panel::Panel;
use crate::widgets::picture::Picture;
use crate::widgets::{Charset, RayInput, board};

use GameAction::{Back, CallShown, Export, LookBack, NextBoard, StrikeShown, WatchAll, WatchBest};

/// A game and its current phase.
#[derive(Debug, Clone)]
pub(crate) struct Playing {
    pub(crate) game: ActiveGame,
    pub(super) phase: GamePhase,
}

impl From<ActiveGame> for Playing {
    /// A game that begins or is resumed; if it is the computer's turn, the computer chooses its
    /// stroke as soon as time passes.
    fn from(game: ActiveGame) -> Self {
        let phase = match game.game().stage() {
            GameStage::Playing => GamePhase::Aim,
            _ => GamePhase::Over,
        };
        Self { game, phase }
    }
}

impl Playing {
    /// Replays a saved game from its beginning.
    pub(crate) fn watch_all(&mut self, cx: &mut Context) {
        let first = self.game.watch_all(cx);
        self.follow(first.into(), cx);
    }

    /// The current keys, the most useful first.
    pub(crate) fn keys(&self) -> KeyTable<TableAction> {
        let none = KeyTable::new("table");
        let game = KeyTable::new("table");
        let (own, game) = match &self.phase {
            GamePhase::Aim => return self.game.aim_keys(),
            GamePhase::Show(_) => {
                let strike = game
                    .on(' ', StrikeShown, "strike")
                    .or([(Key::Enter, StrikeShown)])
                    .on('c', CallShown, "your call");
                (none, strike.on(Key::Escape, Back, "leave"))
            }
            GamePhase::Call(calling) => {
                let rays = calling.prediction.rays.keys("next, then strike");
                let back = game.on(Key::Escape, Back, "back");
                (rays.map(TableAction::Call), back)
            }
            GamePhase::Watch(replay) => {
                let zoomed = replay.player.chosen().is_some();
                let game = game
                    .on(Key::Escape, Back, "")
                    .on('v', WatchAll, "")
                    .on('e', Export, "");
                let watch = replay.keys(&self.game.history);
                (watch.map(TableAction::Watch), game.without(|_| zoomed))
            }
            GamePhase::Arrange(_) => {
                let done = game.on('p', Back, "done").or([(Key::Escape, Back)]);
                let arrange = arranging::keys().map(TableAction::Arrange);
                (arrange, done.on('e', Export, ""))
            }
            GamePhase::Over => {
                let next = game
                    .on(Key::Enter, NextBoard, "next")
                    .or([(' ', NextBoard)])
                    .on('i', LookBack, "strokes")
                    .on('b', WatchBest, "best stroke")
                    .on('v', WatchAll, "replay")
                    .on('e', Export, "export")
                    .on(Key::Escape, Back, "leave");
                (none, next)
            }
        };
        own.with(game, TableAction::Game)
    }

    /// Carries out the action of a key or a click.
    pub(crate) fn act(&mut self, action: TableAction, cx: &mut Context) -> Next {
        use TableAction::{Aim, Arrange, Call, Game, Watch};
        self.game.notice = None;
        self.hand_over(cx);
        let game = &mut self.game;
        match (&self.phase, action) {
            (GamePhase::Aim, Aim(AimAction::Strike)) | (GamePhase::Over, Game(NextBoard)) => {
                if !game.guard.allows() {
                    return Next::Stay;
                }
            }
            _ => game.guard.release(),
        }
        let after = match (&mut self.phase, action) {
            (_, Game(LookBack)) => game.look_back(cx).into(),
            (_, Game(WatchAll)) => game.watch_all(cx).into(),
            (_, Game(Export)) => {
                cx.ask(StoreRequest::Export(game.saved(cx)));
                After::Screen(Next::Stay)
            }
            (phase, Game(Back)) => phase.back(game, cx),
            (GamePhase::Aim, Aim(action)) => game.aim_by(action, cx).into(),
            (GamePhase::Show(shown), Game(StrikeShown)) => After::Phase(shown.strike(game, cx)),
            (GamePhase::Show(shown), Game(CallShown)) => After::Phase(shown.call(game, cx)),
            (GamePhase::Call(calling), Call(action)) => calling.act(action, game, cx).into(),
            (GamePhase::Watch(replay), Watch(action)) => replay.act(action, game, cx).into(),
            (GamePhase::Arrange(hand), Arrange(action)) => {
                hand.act(action, game);
                After::Screen(Next::Stay)
            }
            (GamePhase::Over, Game(NextBoard)) => game.next_board(cx),
            (GamePhase::Over, Game(WatchBest)) => game.watch_best(cx).into(),
            _ => After::Screen(Next::Ignored),
        };
        self.follow(after, cx)
    }

    /// Handles the mouse over the picture.
    pub(crate) fn point(&mut self, mouse: &Mouse, area: Rect, cx: &mut Context) -> Next {
        self.game.notice = None;
        self.hand_over(cx);
        let (game, pressed) = (&mut self.game, mouse.presses(area));
        if mouse.is_held() && matches!(self.phase, GamePhase::Aim) {
            game.guard.release();
        }
        let after = match &mut self.phase {
            GamePhase::Aim => game.aim_at(mouse, area, cx),
            GamePhase::Show(shown) if pressed => After::Phase(shown.strike(game, cx)),
            GamePhase::Call(calling) => {
                After::Screen(Next::after(calling.prediction.point(mouse, area)))
            }
            GamePhase::Watch(replay) if pressed => replay.click(game, cx),
            GamePhase::Arrange(hand) => hand.point(mouse, area, game),
            GamePhase::Over if pressed && game.guard.allows() => game.click_on_end(cx),
            _ => After::Screen(Next::Ignored),
        };
        self.follow(after, cx)
    }

    /// Handles a turn of the mouse wheel.
    pub(crate) fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        self.game.notice = None;
        self.game.guard.release();
        let after = match &mut self.phase {
            GamePhase::Aim => {
                self.game.strengthen(-by);
                After::Screen(Next::Stay)
            }
            GamePhase::Watch(replay) => match replay.player.wheel(by) {
                Some(action) => replay.work(action, cx).into(),
                None => After::Screen(Next::Ignored),
            },
            _ => After::Screen(Next::Ignored),
        };
        self.follow(after, cx)
    }

    pub(crate) fn advance(&mut self, passed: Duration, cx: &mut Context) {
        self.hand_over(cx);
        self.game.guard.advance(passed);
        let after = match &mut self.phase {
            GamePhase::Show(shown) => shown.advance(passed, &mut self.game, cx),
            GamePhase::Watch(replay) => replay.advance(passed, &mut self.game, cx),
            _ => None,
        };
        self.follow(after.into(), cx);
    }

    /// The time until the game must next be advanced.
    pub(crate) fn wake(&self, pace: HitPace) -> Option<Duration> {
        match &self.phase {
            GamePhase::Watch(replay) => replay.wake(&self.game, pace),
            GamePhase::Show(shown) => shown.left,
            GamePhase::Aim if self.game.is_computers_turn() => Some(Duration::ZERO),
            GamePhase::Aim | GamePhase::Over => self.game.guard.wake(),
            _ => None,
        }
    }

    /// Lets the computer decide if it has not done so yet: when a game begins or is resumed, and
    /// after the computer has passed.
    fn hand_over(&mut self, cx: &Context) {
        if matches!(self.phase, GamePhase::Aim) && self.game.is_computers_turn() {
            self.phase = self.game.turn(cx);
        }
    }

    /// Changes the phase or the screen as the result of an action requires, and saves the game.
    fn follow(&mut self, after: After, cx: &mut Context) -> Next {
        let next = match after {
            After::Phase(phase) => {
                self.phase = phase;
                self.game.guard = StrikeGuard::default();
                Next::Stay
            }
            After::Screen(next) => next,
        };
        self.game.look_ahead();
        self.game.save(cx);
        next
    }

    /// The view of the current phase.
    pub(crate) fn view(&self, charset: Charset) -> View<'_, TableAction> {
        let (game, phase) = (&self.game, &self.phase);
        let (title, panel_title) = phase.titles(game);
        let mut panel = Panel::new(panel_title);
        panel.subject = game.history.len();
        panel.warning(game.keeping.trouble.as_deref());
        panel.gap();
        phase.write(game, charset, &mut panel);
        let dragging = match phase {
            // From the third stroke on the player knows this, and a phone has little room.
            GamePhase::Aim if game.history.record().strokes() < 2 => Some(
                "Touch the board to aim. Drag the striker along its base line; pull it back and \
                 let go to strike.",
            ),
            // No words are shown, but dragging a finger on the picture still does not scroll the
            // page.
            GamePhase::Aim => Some(""),
            GamePhase::Call(_) => Some(RayInput::DRAG),
            GamePhase::Arrange(_) => Some("Drag a coin to its place."),
            _ => None,
        };
        if phase.is_enlarged() {
            return View::drawn(title, |area| phase.picture(game, area), panel).dragging(dragging);
        }
        let hit = { game.first_hit() }.filter(|_| matches!(phase, GamePhase::Aim));
        let hit = hit.filter(|_| game.options.company.aids.ghost);
        let contact = hit.and_then(|hit| {
            let coin = game.game().coins().get(hit.coin)?;
            let faces = [Piece::Striker, coin.piece].map(words::face);
            Some(move |area| contact_picture(area, faces, &hit.impact.collision))
        });
        let draw = |area: Rect, buf: &mut _, look: &_| {
            phase.picture(game, area).draw(buf, look);
            let replay = match phase {
                GamePhase::Watch(replay) => Some(replay.as_ref()),
                _ => None,
            };
            trays::draw(game, replay, board::square(area), buf, look);
        };
        View::picture(title, draw, panel)
            .square()
            .with_inset(CONTACT, contact)
            .dragging(dragging)
    }
}

impl GamePhase {
    /// Goes one step back: cancels a pull, or leaves a call, a replay or the arrangement of coins;
    /// otherwise leaves the game.
    fn back(&mut self, game: &mut ActiveGame, cx: &Context) -> After {
        match self {
            Self::Aim if game.is_pulling() => game.let_slip(),
            Self::Call(calling) if calling.can_be_left(game) => {
                return After::Phase(calling.leave(game, cx));
            }
            Self::Arrange(_) => return After::Phase(Self::Aim),
            Self::Watch(replay) if !replay.live || !game.is_running() => {
                return After::Phase(game.turn_after_replay(cx));
            }
            _ if game.is_running() => return After::Screen(Next::Confirm(parting(game))),
            _ => return After::Screen(Next::Back),
        }
        After::Screen(Next::Stay)
    }

    /// Whether an enlarged impact is shown instead of the board.
    fn is_enlarged(&self) -> bool {
        match self {
            Self::Call(_) => true,
            Self::Watch(replay) => replay.player.zoom().is_some(),
            _ => false,
        }
    }

    fn picture(&self, game: &ActiveGame, area: Rect) -> Picture {
        match self {
            Self::Aim => pictures::of_aim(game, area),
            Self::Show(shown) => pictures::of_show(game, shown, area),
            Self::Call(calling) => calling.prediction.picture(Face::STRIKER_AND_COIN, area),
            Self::Watch(replay) => match replay.player.zoom() {
                Some(watch) => watch.picture(area),
                None => pictures::of_replay(game, replay, area),
            },
            Self::Arrange(hand) => hand.picture(game, area),
            Self::Over => picture::of_pack(game.game().coins(), game.set(), area),
        }
    }

    /// The titles of the picture and the panel.
    fn titles(&self, game: &ActiveGame) -> (String, String) {
        let panel = match self {
            Self::Call(_) => return ("call it: where to?".into(), "predict it".into()),
            Self::Watch(replay) => return replay.titles(&game.history),
            Self::Arrange(_) => "lay the coins out".into(),
            Self::Aim | Self::Show(_) => {
                words::whose(game.options.seat_name(game.seat()), "stroke")
            }
            Self::Over => "the end of the board".into(),
        };
        (board_title(game), panel)
    }

    fn write(&self, game: &ActiveGame, charset: Charset, panel: &mut TablePanel) {
        match self {
            Self::Aim => game.write_aim(charset, panel),
            Self::Show(shown) => shown.write(game, charset, panel),
            Self::Call(calling) => calling.write(panel),
            Self::Watch(replay) => replay.write(game, charset, panel),
            Self::Arrange(hand) => hand.write(game, charset, panel),
            Self::Over => game.write_end(panel),
        }
    }
}

/// The confirmation before the player leaves the game.
fn parting(game: &ActiveGame) -> Confirmation {
    let kept = match game.keeping.saved {
        Some(true) => " It is saved, and you can resume it later from the list of saved games.",
        _ => "",
    };
    Confirmation::new(format!("Leave this game?{kept}"), "leave", "play on")
}

/// The title of the board's picture, such as the number of the board and the score.
fn board_title(active: &ActiveGame) -> String {
    let game = active.game();
    let score = active.options.score(game);
    match game.setup().rules {
        Rules::Practice => "practice".into(),
        Rules::Solo => words::solo_title(game),
        Rules::Friendly => format!("boards won   {score}"),
        Rules::Points => format!("points to {POINTS_TO_WIN}   {score}"),
        Rules::Tournament => format!("board {}   {score}", game.board_number()),
    }
}

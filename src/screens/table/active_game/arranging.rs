//! Practice: arranging the coins by hand.

use glam::DVec2;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::{ActiveGame, After, GameAction, score};
use crate::game::pieces::{COINS_EACH, count};
use crate::game::{Coin, Game, Move, Piece};
use crate::messages::{Key, Mouse, MouseKind};
use crate::physics::Board;
use crate::screens::Next;
use crate::screens::table::aim::millimetres;
use crate::screens::table::{TableAction, TablePanel, picture};
use crate::widgets::input::KeyTable;
use crate::widgets::picture::Picture;
use crate::widgets::{Charset, Role};

/// The small step of the hand, in metres.
const STEP: f64 = 0.002;

/// The notice that is shown if there is no coin to pick up.
const NO_COIN: &str = "There is no coin under the hand.";

/// A hand that may hold a coin; at first it is empty and over the middle of the board.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Arrange {
    /// The position of the hand, in metres.
    hand: DVec2,
    /// The index, in the game, of the coin that the hand holds.
    held: Option<usize>,
}

/// What the keys do while the player is arranging coins.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum ArrangeAction {
    /// move the hand by 20 mm or by 2 mm
    Hand(i8, i8),
    /// pick up the coin under the hand, or put it down
    TakeOrLay,
    /// move the hand to the next coin
    NextCoin,
    /// add a white coin, a black coin or the queen
    Add(Piece),
    /// remove the coin under the hand
    RemoveCoin,
    /// practice: undo the last stroke or the last change to the coins
    Undo,
}

pub(super) fn keys() -> KeyTable<ArrangeAction> {
    use ArrangeAction::{Add, Hand, NextCoin, RemoveCoin, TakeOrLay, Undo};
    let ways = [(0, 1), (0, -1), (-1, 0), (1, 0)];
    let near = ways.map(|(x, y)| Hand(x, y));
    let pieces = [Piece::White, Piece::Black, Piece::Queen];
    KeyTable::new("table")
        .by(Key::ARROWS, |(x, y)| Hand(10 * x, 10 * y), ways, "move")
        .or(['w', 's', 'a', 'd'].into_iter().zip(near))
        .on(' ', TakeOrLay, "take, lay")
        .or([(Key::Enter, TakeOrLay)])
        .by(['o', 'b', 'q'], Add, pieces, "add")
        .called(&["white", "black", "queen"])
        .on('x', RemoveCoin, "remove")
        .or([Key::Delete, Key::Backspace].map(|key| (key, RemoveCoin)))
        .on('z', Undo, "undo")
        .on(Key::Tab, NextCoin, "")
}

impl Arrange {
    pub(super) fn act(&mut self, action: ArrangeAction, game: &mut ActiveGame) {
        match action {
            ArrangeAction::Hand(x, y) => {
                let step = STEP * DVec2::new(f64::from(x), f64::from(y));
                self.put_hand(self.hand + step, game.game());
            }
            ArrangeAction::TakeOrLay => self.take_or_lay(game),
            ArrangeAction::NextCoin => self.reach_next(game.game()),
            ArrangeAction::Add(piece) => self.add(piece, game),
            ArrangeAction::RemoveCoin => {
                let mut coins = game.game().coins().to_vec();
                match self.held.or_else(|| self.under(game.game())) {
                    Some(gone) if gone < coins.len() => {
                        coins.remove(gone);
                        self.lay_out(coins, game);
                    }
                    _ => game.notice = Some(NO_COIN.into()),
                }
            }
            ArrangeAction::Undo => {
                self.held = None;
                game.undo();
            }
        }
    }

    /// Moves the hand with the mouse: a press picks a coin up, the release puts it down.
    pub(super) fn point(&mut self, mouse: &Mouse, area: Rect, game: &mut ActiveGame) -> After {
        let (at, inside) = picture::pointed(mouse, area);
        match mouse.kind {
            MouseKind::Down if inside => {
                self.put_hand(at, game.game());
                self.held = self.under(game.game());
            }
            MouseKind::Drag => self.put_hand(at, game.game()),
            MouseKind::Up if self.held.is_some() => self.take_or_lay(game),
            _ => return After::Screen(Next::Ignored),
        }
        After::Screen(Next::Stay)
    }

    /// The coin under the hand: the nearest one that it touches.
    fn under(&self, game: &Game) -> Option<usize> {
        let reach = 1.2 * game.setup().set.coin_radius();
        let distance = |coin: &Coin| coin.at.distance(self.hand);
        let coins = game.coins().iter().map(distance).enumerate();
        let touched = coins.filter(|(_, distance)| *distance <= reach);
        let nearest = touched.min_by(|(_, a), (_, b)| a.total_cmp(b));
        nearest.map(|(i, _)| i)
    }

    /// Moves an empty hand over the next coin.
    fn reach_next(&mut self, game: &Game) {
        let next = self.under(game).map_or(0, |i| i + 1);
        let coin = game.coins().get(next).or(game.coins().first());
        if let Some(coin) = coin.filter(|_| self.held.is_none()) {
            self.hand = coin.at;
        }
    }

    /// Moves the hand to a point, rounded to whole millimetres and kept within the frame.
    fn put_hand(&mut self, at: DVec2, game: &Game) {
        let room = Board::default().side / 2.0 - game.setup().set.coin_radius();
        let whole = (at * 1000.0).round() / 1000.0;
        self.hand = whole.clamp(DVec2::splat(-room), DVec2::splat(room));
    }

    /// Picks up the coin under the hand, or puts the held one down.
    fn take_or_lay(&mut self, game: &mut ActiveGame) {
        let mut coins = game.game().coins().to_vec();
        match self.held.and_then(|held| coins.get_mut(held)) {
            Some(coin) => {
                coin.at = self.hand;
                self.lay_out(coins, game);
            }
            None => {
                self.held = self.under(game.game());
                if self.held.is_none() {
                    game.notice = Some(NO_COIN.into());
                }
            }
        }
    }

    /// Adds a piece of this kind under the hand, if the set has one left.
    fn add(&self, piece: Piece, game: &mut ActiveGame) {
        let most = if piece == Piece::Queen { 1 } else { COINS_EACH };
        if count(game.game().coins(), piece) >= most {
            game.notice = Some(format!("A set has no more than {most} of these."));
            return;
        }
        let at = self.hand;
        let coins = [game.game().coins(), &[Coin { piece, at }]].concat();
        game.make(Move::LayOut(coins));
    }

    /// Uses this arrangement of coins if it is allowed; then the hand is empty.
    fn lay_out(&mut self, coins: Vec<Coin>, game: &mut ActiveGame) {
        game.make(Move::LayOut(coins));
        if game.notice.is_none() {
            self.held = None;
        }
    }

    pub(super) fn picture(&self, game: &ActiveGame, area: Rect) -> Picture {
        let mut coins = game.game().coins().to_vec();
        if let Some(held) = self.held.and_then(|held| coins.get_mut(held)) {
            held.at = self.hand;
        }
        let mut picture = picture::of_pack(&coins, game.set(), area);
        picture::hand(&mut picture, self.hand);
        picture
    }

    pub(super) fn write(&self, game: &ActiveGame, charset: Charset, panel: &mut TablePanel) {
        let (what, next) = match self.held {
            Some(_) => ("Move the coin and put it down.", "put it down"),
            None => (
                "Put the hand over a coin and pick it up, or drag it with the mouse.",
                "pick it up",
            ),
        };
        panel.paragraph(what, Role::Text);
        panel.fact("place", millimetres(self.hand));
        panel.prompt(next, TableAction::Arrange(ArrangeAction::TakeOrLay));
        panel.gap();
        panel.warning(game.notice.as_deref());
        panel.gap();
        score::write_pieces(game, charset, panel);
        panel.gap();
        panel.prompt("done", TableAction::Game(GameAction::Back));
    }
}

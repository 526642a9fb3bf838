//! The computer's stroke before it is played: position, aim and strength, so that the player can
//! predict the result; and hints for the player.
//!
//! Neither the search for a stroke nor the search for a hint uses a separate thread: nothing moves
//! on the board meanwhile, and a search takes too little time to be noticed
//! (`docs/performance.md`).

use std::time::Duration;

use super::aiming::{first_hit, strength};
use super::calling::Calling;
use super::{
    ActiveGame, Aim, GameAction, GamePhase, Hinted, Options, Player, Pointer, Preview, score,
};
use crate::game::opponent::{PlayerHand, Slip};
use crate::game::{Call, Strike, opponent};
use crate::physics::Motion;
use crate::screens::Context;
use crate::screens::table::computer_stroke::ComputerStroke;
use crate::screens::table::{TableAction, TablePanel};
use crate::widgets::{Charset, Role};

/// How long each part of the aim is visible before the next one appears, and how long the whole aim
/// is visible after that, in milliseconds.
const PARTS_MS: [u64; 3] = [250, 250, 700];

/// The computer's next stroke, while it is being shown.
#[derive(Debug, Clone)]
pub(super) struct ShownStroke {
    pub(super) stroke: ComputerStroke,
    /// How many of its parts are visible: the position, the direction, the strength.
    pub(super) parts: usize,
    /// The time until the next part, or the stroke; `None` if carrom is waiting for a key.
    pub(super) left: Option<Duration>,
}

impl ShownStroke {
    /// The computer's next stroke, with its first part visible or, with reduced motion, all parts.
    pub(super) fn new(stroke: ComputerStroke, options: &Options, cx: &Context) -> Self {
        let parts = match cx.settings.reduced_motion {
            true => PARTS_MS.len(),
            false => 1,
        };
        Self {
            stroke,
            parts,
            left: part_lasts(parts, options, cx),
        }
    }

    /// Plays the stroke at once.
    pub(super) fn strike(&self, game: &mut ActiveGame, cx: &Context) -> GamePhase {
        game.play_for_the_computer(&self.stroke, None, cx)
    }

    /// Lets the player predict the directions after the first collision. The call is about the
    /// actual stroke, which includes the error of the hand.
    pub(super) fn call(&self, game: &mut ActiveGame, cx: &Context) -> GamePhase {
        let [struck, _] = self.stroke.strikes();
        let preview = Preview::of(&struck, game.game());
        let Some(hit) = preview.and_then(|it| it.hit.ok()) else {
            return self.strike(game, cx);
        };
        let calling = Calling::new(hit, Some(self.stroke.clone()));
        GamePhase::Call(Box::new(calling))
    }

    /// Advances the time: the parts appear one after another, then the stroke is played.
    pub(super) fn advance(
        &mut self,
        mut passed: Duration,
        game: &mut ActiveGame,
        cx: &Context,
    ) -> Option<GamePhase> {
        while let Some(left) = self.left {
            if passed < left {
                self.left = Some(left - passed);
                break;
            }
            passed -= left;
            if self.parts == PARTS_MS.len() {
                return Some(self.strike(game, cx));
            }
            self.parts += 1;
            self.left = part_lasts(self.parts, &game.options, cx);
        }
        None
    }

    /// Writes the visible parts of the stroke.
    pub(super) fn write(&self, game: &ActiveGame, charset: Charset, panel: &mut TablePanel) {
        game.write_turn(panel);
        // The question is above the parts, so that it does not move when they appear.
        panel.paragraph("What will happen? Predict it.", Role::Text);
        panel.prompts([
            ("your call", TableAction::Game(GameAction::CallShown)),
            ("strike", TableAction::Game(GameAction::StrikeShown)),
        ]);
        panel.gap();
        let aim = &self.stroke.aim;
        panel.fact("place", aim.place_words(game.game()));
        if self.parts > 1 {
            panel.fact("aim", game.direction(aim));
        }
        if self.parts > 2 {
            strength(aim, panel);
        }
        panel.gap();
        let hit = { self.stroke.preview.as_ref() }.and_then(|it| it.hit.ok());
        if let Some(hit) = hit.filter(|_| self.parts > 2) {
            first_hit(game.game(), &hit, false, panel);
        }
        panel.gap();
        score::write(game, charset, panel);
    }
}

/// How long a stroke is shown with `parts` of its parts visible; a faster replay speed shortens the
/// time. For players who predict strokes, the whole aim stays visible until they go on (`None`).
fn part_lasts(parts: usize, options: &Options, cx: &Context) -> Option<Duration> {
    let waits = options.company.call && options.count(Player::Person) > 0;
    if waits && parts == PARTS_MS.len() {
        return None;
    }
    let rate = cx.settings.watch_rate.map_or(1.0, |rate| rate.seconds());
    let lasts = PARTS_MS.get(parts - 1).copied().unwrap_or_default();
    Some(Duration::from_millis(lasts).div_f64(rate.max(1.0)))
}

impl ActiveGame {
    /// Plays the stroke that the computer has decided on, with the player's call.
    pub(super) fn play_for_the_computer(
        &mut self,
        stroke: &ComputerStroke,
        call: Option<Call>,
        cx: &Context,
    ) -> GamePhase {
        let number = self.history.len();
        for strike in stroke.strikes() {
            if let Some(watching) = self.play(Strike { call, ..strike }, cx) {
                self.history.notify(number, stroke.clone());
                self.notice = None;
                return watching;
            }
        }
        // Neither stroke can be played, so a person plays on; otherwise the game would stop.
        self.options.company.players[self.seat() as usize] = Player::Person;
        GamePhase::Aim
    }

    /// Lets the computer decide, and shows its stroke before it is played; without a stroke, the
    /// computer passes.
    pub(super) fn think(&mut self, cx: &Context) -> GamePhase {
        let strength = self.options.company.strengths[self.seat() as usize];
        match opponent::think(self.game(), strength, self.next_seed()) {
            Some(decision) => {
                let stroke = ComputerStroke::new(decision, self.game());
                GamePhase::Show(Box::new(ShownStroke::new(stroke, &self.options, cx)))
            }
            None => {
                self.pass();
                GamePhase::Aim
            }
        }
    }

    /// Gives a hint; the next time, shows the whole stroke; the third time, sets the aim.
    pub(super) fn help(&mut self) {
        match &mut self.hint {
            Some(hinted) if hinted.whole => {
                let stroke = hinted.hint.stroke;
                self.aim = Aim::of(&stroke.into(), self.seat());
            }
            Some(hinted) => hinted.whole = true,
            None => self.find_hint(),
        }
    }

    fn find_hint(&mut self) {
        self.history.take_hint();
        let found = opponent::hint(self.game(), self.hand(), self.next_seed());
        if found.is_none() {
            self.notice = Some("No stroke was found here.".into());
        }
        self.hint = found.map(|hint| Hinted {
            pointer: Pointer::of(&hint.reason.story, &hint.stroke.into(), self.game()),
            hint,
            whole: false,
        });
    }

    /// The seed of the next stroke: different for each stroke, but the same when the game is
    /// replayed.
    fn next_seed(&self) -> u64 {
        self.seed_of(self.history.len())
    }

    /// The seed of the stroke with this move number.
    fn seed_of(&self, number: usize) -> u64 {
        let seed = self.game().setup().seed.unwrap_or(0);
        seed.rotate_left(32) ^ number as u64
    }

    /// How steady the human players' hands are; in a practice game, strokes are exact.
    pub(super) fn hand(&self) -> PlayerHand {
        match self.is_practice() {
            true => PlayerHand::Exact,
            false => self.options.company.hand,
        }
    }

    /// The stroke that results from the aim and the error of the player's hand.
    pub(super) fn struck(&self) -> Strike {
        let meant = self.aim.strike(self.seat());
        let Some(errors) = self.hand().errors() else {
            return meant;
        };
        let slip = errors.slip_of(self.next_seed());
        slip.applied_to(Motion::new(meant.place, meant.velocity))
            .into()
    }

    /// The error of the hand in the move with this number, if a person made it with an unsteady
    /// hand.
    pub(super) fn slip(&self, number: usize) -> Option<Slip> {
        let past = self.history.past(number)?;
        let is_person = self.options.player(past.before.seat()) == Player::Person;
        let slipped = is_person && past.meant.is_none();
        let errors = self.hand().errors().filter(|_| slipped)?;
        Some(errors.slip_of(self.seed_of(number)))
    }
}

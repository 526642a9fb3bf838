//! Aiming: the position, the direction and the strength of the next stroke.

use glam::DVec2;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::arranging::Arrange;
use super::calling::Calling;
use super::{ActiveGame, After, Aim, FirstHit, GameAction, GamePhase, Hinted, Preview, score};
use crate::game::steps::{PLACE_STEP, STEPS_PER_DEGREE, STEPS_PER_SPEED};
use crate::game::{Game, Rules, opponent};
use crate::messages::{Key, Mouse, MouseKind};
use crate::numbers::{capital, fixed};
use crate::physics::units::{m_from_mm, mm_from_m};
use crate::screens::table::aim::{SPEEDS, along_the_screen, rightwards};
use crate::screens::table::preview::Miss;
use crate::screens::table::{TableAction, TablePanel, picture, words};
use crate::screens::{Context, Next};
use crate::widgets::input::{EntryAction, KeyTable};
use crate::widgets::panel::Panel;
use crate::widgets::panels::{impact_angle, offset};
use crate::widgets::{Charset, Outcome, Role};

/// The step of the speed, in m/s.
const SPEED_STEP: f64 = 1.0 / STEPS_PER_SPEED;
/// The step of the direction, in degrees.
const DIRECTION_STEP: f64 = 1.0 / STEPS_PER_DEGREE;

/// What the keys do while aiming.
#[derive(Debug, Clone, Copy, PartialEq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum AimAction {
    /// strike
    Strike,
    /// turn the aim by 0.1° or by 1°
    Turn(i16),
    /// turn the aim by 10°
    TurnFar(i16),
    /// aim at the next coin for you to pocket, to the right or to the left, so that it goes into the nearest open pocket; Tab works, too
    NextShot(i8),
    /// change the strength by 0.1 m/s or by 1 m/s; the wheel works, too
    Strength(i8),
    /// move the striker by 2 mm or by 20 mm
    Place(i8),
    /// practice: move the striker up or down
    PlaceUp(i8),
    /// type a number: the angle or, with a key after it, the strength or the position in millimetres
    Number(EntryAction),
    /// turn the aim line, the ghost or the predicted paths on or off
    Aid(AimAid),
    /// turn calls on or off: before each stroke, predict the directions of the two discs after the first collision
    Call,
    /// hint: where to look; again: the whole stroke; a third time: set it
    Hint,
    /// practice: arrange the coins
    LayOut,
    /// practice: undo the last stroke or the last change to the coins
    Undo,
}

/// An aid for aiming.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AimAid {
    /// The striker's path to the first coin.
    Line,
    /// The position of the striker at its first contact.
    Ghost,
    /// The paths of both discs after the first collision.
    Rays,
}

impl ActiveGame {
    pub(super) fn aim_keys(&self) -> KeyTable<TableAction> {
        use AimAction::{
            Aid, Call, Hint, LayOut, NextShot, Number, Place, PlaceUp, Strength, Strike, Turn,
            TurnFar, Undo,
        };
        use AimAid::{Ghost, Line, Rays};
        use GameAction::{Back, Export, LookBack, WatchAll};
        let typing = self.entry.is_open();
        let practice = self.is_practice();
        // A long hint is scrolled with the page keys.
        let reads = self.hint.as_ref().is_some_and(|hinted| hinted.whole);
        let back = if self.is_pulling() { "cancel" } else { "" };
        // While a number is being typed, the bottom line begins with the keys that set it.
        let (first, last) = (self.entry.keys(), self.entry.keys());
        let first = first
            .without(|_| !typing)
            .renamed("", |it| matches!(it, EntryAction::Type(_)))
            .renamed("aim", |it| it == EntryAction::Enter);
        let (coin, turn, place) = match typing {
            true => ("", "", "mm left or right"),
            // In a practice game the bottom line has no room for all three names.
            false if practice => ("", "aim", "place"),
            false => ("coin", "aim", "place"),
        };
        let aim = KeyTable::new("table")
            .with(first, Number)
            .on(' ', Strike, "strike")
            .or((!typing).then_some((Key::Enter, Strike)))
            .by(['n', 'N'], NextShot, [1, -1], coin)
            .called(&["next", "previous"])
            .or([(Key::Tab, NextShot(1)), (Key::BackTab, NextShot(-1))])
            .on('h', Hint, if typing { "" } else { "hint" })
            .when(self.board_code().is_none())
            .on('p', LayOut, "lay out")
            .when(practice)
            .on('z', Undo, "undo")
            .when(practice)
            .by(Key::ARROWS, Turn, [-1, 1, -10, 10], turn)
            .by(['+', '-', '>', '<'], Strength, [1, -1, 10, -10], "strength")
            .called(&["harder", "softer", "much harder", "much softer"])
            .or([('=', Strength(1)), ('_', Strength(-1))])
            .when(!typing)
            .on('+', Strength(1), "strength")
            .or([('=', Strength(1))])
            .when(typing)
            .by(['[', ']', '{', '}'], Place, [-1, 1, -10, 10], place)
            .called(&["left", "right", "far left", "far right"])
            .or([('a', Place(-1)), ('d', Place(1))])
            .with(last.without(|_| typing), Number)
            .on('c', Call, "call")
            .by(['l', 'g', 'r'], Aid, [Line, Ghost, Rays], "aids")
            .called(&["line", "ghost", "arrows"])
            .in_brief("n", |it| matches!(it, NextShot(_)))
            .in_brief("+ -", |it| it == Strength(1) && !typing)
            .in_brief("[ ]", |it| matches!(it, Place(_)))
            .in_brief("arrows, 68.2", |it| {
                // In a practice game the bottom line has no room for this example.
                matches!(it, Turn(_)) && !typing && !practice
            });
        let shared = KeyTable::new("table")
            .on('i', LookBack, "impacts")
            .on('v', WatchAll, "replay")
            .on('e', Export, "export")
            .on(Key::Escape, Back, back)
            .when(!typing);
        let unnamed = KeyTable::new("table")
            .by(['w', 's'], PlaceUp, [1, -1], "")
            .when(practice)
            .by([Key::PageUp, Key::PageDown], TurnFar, [-1, 1], "")
            .when(!reads);
        aim.map(TableAction::Aim)
            .with(shared, TableAction::Game)
            .with(unnamed, TableAction::Aim)
    }

    /// Aims, or carries out another action. A typed number is a direction, unless the key after it
    /// makes it a position or a speed.
    pub(super) fn aim_by(&mut self, action: AimAction, cx: &Context) -> Option<GamePhase> {
        if !matches!(action, AimAction::Number(_))
            && let Some(number) = self.entry.take()
        {
            match action {
                AimAction::Strength(1) => self.aim.set_speed(number),
                AimAction::Place(1) => self.stand(m_from_mm(number)),
                AimAction::Place(-1) => self.stand(-m_from_mm(number)),
                _ => self.aim.set_shown(number, self.seat()),
            }
            if let AimAction::Strength(1) | AimAction::Place(1 | -1) = action {
                return None;
            }
        }
        let right = rightwards(self.seat());
        match action {
            AimAction::Number(action) => {
                if let Outcome::Done(degrees) = self.entry.act(action) {
                    self.aim.set_shown(degrees, self.seat());
                }
            }
            AimAction::Turn(tenths) => self.aim.turn(f64::from(tenths) * DIRECTION_STEP * right),
            AimAction::TurnFar(tens) => self.aim.turn(10.0 * f64::from(tens) * right),
            AimAction::NextShot(sense) => {
                let shots = opponent::open_shots(self.game(), self.aim.place);
                let before = self.aim;
                self.aim.turn_to_next(&shots, sense, self.seat());
                if self.aim == before {
                    self.notice = Some(match shots.is_empty() {
                        false => "There is no other direct shot from here.".to_owned(),
                        true => format!("No {} can be hit directly from here.", self.wanted_coin()),
                    });
                }
            }
            AimAction::Strength(steps) => self.strengthen(steps),
            AimAction::Place(steps) => {
                let along = along_the_screen(self.seat(), self.game().setup().rules);
                self.shift(steps, along);
            }
            AimAction::PlaceUp(steps) => self.shift(steps, DVec2::Y),
            AimAction::Aid(AimAid::Line) => self.options.company.aids.line ^= true,
            AimAction::Aid(AimAid::Ghost) => self.options.company.aids.ghost ^= true,
            AimAction::Aid(AimAid::Rays) => self.options.company.aids.rays ^= true,
            AimAction::Call => self.options.company.call ^= true,
            AimAction::LayOut => return Some(GamePhase::Arrange(Arrange::default())),
            AimAction::Undo => self.take_back(),
            AimAction::Hint => self.help(),
            AimAction::Strike => return self.strike(cx),
        }
        None
    }

    /// A coin that the player may want to pocket.
    fn wanted_coin(&self) -> &'static str {
        let any =
            matches!(self.options.setup.rules, Rules::Points | Rules::Solo) || self.is_practice();
        if any { "coin" } else { "coin of yours" }
    }

    /// Increases the speed of the stroke by `steps` steps.
    pub(super) fn strengthen(&mut self, steps: i8) {
        let by = f64::from(steps) * SPEED_STEP;
        self.aim.set_speed(self.aim.speed + by);
    }

    /// Moves the striker by `steps` steps in a direction on the screen.
    fn shift(&mut self, steps: i8, way: DVec2) {
        let step = f64::from(steps) * PLACE_STEP * way;
        self.aim.move_by(step, self.history.game());
    }

    /// Puts the striker at a distance in metres to the right of the middle (or above it), as seen
    /// on the screen.
    fn stand(&mut self, metres: f64) {
        let game = self.history.game();
        let along = along_the_screen(game.seat(), game.setup().rules);
        let beside = self.aim.place - along * self.aim.place.dot(along);
        self.aim.put(beside + metres * along, game);
    }

    /// Takes the last move back; after a stroke, its aim is restored so that the player can try
    /// again.
    fn take_back(&mut self) {
        let last = self.history.len().checked_sub(1);
        let strike = last.and_then(|last| self.history.strike(last).copied());
        if !self.undo() {
            self.notice = Some("There is nothing to take back.".into());
        } else if let Some(strike) = strike {
            self.aim = Aim::of(&strike, self.seat());
        }
    }

    /// Takes the last move back; returns whether there was one.
    pub(super) fn undo(&mut self) -> bool {
        let undone = self.history.undo();
        if undone {
            self.begin_turn();
        }
        undone
    }

    /// Makes the stroke, or first lets the player call it.
    pub(super) fn strike(&mut self, cx: &Context) -> Option<GamePhase> {
        let lines = self.game().base_lines();
        if !self.is_practice() && lines.nearest(DVec2::ZERO).is_none() {
            self.pass();
            return Some(self.turn(cx));
        }
        if let Err(why) = self.game().check_place(self.aim.place) {
            self.notice = Some(format!("No stroke is possible from there: {why}."));
            return None;
        }
        // A call is about the actual stroke, which includes the error of the hand.
        let struck = self.struck();
        let preview = { self.options.company.call }.then(|| Preview::of(&struck, self.game()));
        match preview.flatten().and_then(|it| it.hit.ok()) {
            Some(hit) => Some(GamePhase::Call(Box::new(Calling::new(hit, None)))),
            None => self.play(struck, cx),
        }
    }

    pub(super) fn aim_at(&mut self, mouse: &Mouse, area: Rect, cx: &Context) -> After {
        let (at, inside) = picture::pointed(mouse, area);
        match mouse.kind {
            MouseKind::Down if inside => self.take_hold(at),
            MouseKind::Drag => self.lead(at),
            MouseKind::Up => return self.let_go(at, cx),
            _ => return After::Screen(Next::Ignored),
        }
        After::Screen(Next::Stay)
    }

    /// Writes the aim, its first contact, and the score.
    pub(super) fn write_aim(&self, charset: Charset, panel: &mut TablePanel) {
        self.write_turn(panel);
        score::write_warning(self, panel);
        let aim = self.aimed();
        // The refusal is above the aim, because a phone shows only the top of the panel.
        let refusal = self.refusal(&aim);
        panel.warning(refusal.as_deref());
        let typed = self.entry.shown();
        panel.fact("aim", typed.unwrap_or_else(|| self.direction(&aim)));
        strength(&aim, panel);
        panel.fact("place", aim.place_words(self.game()));
        if self.entry.is_open() {
            panel.part(TableAction::Aim, |panel| {
                panel.prompts([
                    ("aim", AimAction::Number(EntryAction::Enter)),
                    ("mm left", AimAction::Place(-1)),
                    ("mm right", AimAction::Place(1)),
                    ("as the strength", AimAction::Strength(1)),
                ]);
            });
        }
        if self.is_pulling() {
            let what = match self.is_drawn() {
                true => "Let go to strike. Return to the striker to cancel.",
                false => "Pull farther back to strike.",
            };
            panel.paragraph(what, Role::Key);
        }
        panel.gap();
        if let Some(hinted) = &self.hint {
            let is_set = aim == Aim::of(&hinted.hint.stroke.into(), self.seat());
            hint(hinted, is_set, panel);
        } else if refusal.is_none() {
            self.write_ahead(panel);
            self.write_hand(panel);
        }
        panel.gap();
        score::write(self, charset, panel);
    }

    /// The notice about the last action, or why no stroke is possible.
    fn refusal(&self, aim: &Aim) -> Option<String> {
        let blocked = || {
            let why = self.game().check_place(aim.place).err()?;
            Some(format!("No stroke is possible from here: {why}."))
        };
        let notice = self.notice.as_deref().or(self.guard.refusal());
        notice.map(str::to_owned).or_else(blocked)
    }

    pub(super) fn direction(&self, aim: &Aim) -> String {
        format!("{:.1}°", aim.shown_deg(self.seat()))
    }

    /// Writes whose turn it is, and that player's colour; on a board for one player, the number of
    /// the stroke and the par.
    pub(super) fn write_turn<A>(&self, panel: &mut Panel<A>) {
        if self.is_practice() {
            return;
        }
        let game = self.game();
        if self.board_code().is_some() {
            let stroke = self.history.record().strokes() + 1;
            let par = self.par.map(|par| format!(" (par {par})"));
            let par = par.unwrap_or_default();
            panel.line(format!("Stroke {stroke}{par}"), Role::Title);
            return;
        }
        let colour = game.colour(game.team(self.seat()));
        let name = self.options.seat_name(self.seat());
        let does = match game.play().is_unbroken() {
            true => "breaks",
            false => "plays",
        };
        let does = words::does(name, does);
        let turn = match game.setup().rules {
            Rules::Points => does,
            _ => format!("{does}, {}", colour.adjective()),
        };
        panel.line(capital(&turn), Role::Title);
    }

    /// Writes what the striker will hit first.
    fn write_ahead<A>(&self, panel: &mut Panel<A>) {
        let Some(preview) = &self.preview else {
            return;
        };
        match preview.hit {
            // Before a call the impact angle would reveal the coin's direction.
            Ok(hit) => first_hit(self.game(), &hit, !self.options.company.call, panel),
            Err(Miss::Falls) => panel.line("no hit: into the pocket", Role::Warn),
            Err(Miss::Stops) => panel.line("no hit", Role::Dim),
            Err(Miss::TooSoft(coin)) => {
                let coin = self.game().coins().get(coin);
                let coin = coin.map_or_else(|| "coin".to_owned(), |coin| coin.piece.to_string());
                panel.line(format!("too soft to reach the {coin}"), Role::Warn);
            }
        }
        if self.options.company.call && preview.hit.is_ok() {
            panel.line("you will call this hit", Role::Key);
        }
    }

    /// Writes the errors of the player's hand, and how much they change the impact parameter b.
    fn write_hand<A>(&self, panel: &mut Panel<A>) {
        let Some(errors) = self.hand().errors() else {
            return;
        };
        let [degrees, percent] = errors.in_figures();
        panel.fact("your hand", format!("± {degrees}°, ± {percent} %"));
        if let Some(Preview { way, hit: Ok(_) }) = &self.preview {
            let length: f64 = way.windows(2).map(|leg| leg[0].distance(leg[1])).sum();
            let beside = fixed(mm_from_m(errors.direction * length), 1);
            panel.fact("so b varies by", format!("± {beside} mm"));
        }
    }
}

/// Writes the strength of the stroke.
pub(super) fn strength<A>(aim: &Aim, panel: &mut Panel<A>) {
    let speed = format!("{:.1} m/s", aim.speed);
    panel.meter("strength", aim.speed / SPEEDS.1, speed);
}

/// Writes the hint: first where to look, then the whole stroke.
fn hint(hinted: &Hinted, is_set: bool, panel: &mut TablePanel) {
    let (words, more) = match hinted.whole {
        false => (hinted.hint.which(), "tell me more"),
        true => (hinted.hint.how(), "set this stroke"),
    };
    panel.paragraph(words, Role::Good);
    if !(hinted.whole && is_set) {
        panel.prompt(more, TableAction::Aim(AimAction::Hint));
    }
}

fn piece(game: &Game, coin: usize) -> &'static str {
    let coin = game.coins().get(coin);
    coin.map_or("coin", |coin| coin.piece.into())
}

/// Writes the facts of the first collision: the coin, b and, if `tells_angle`, α.
pub(super) fn first_hit<A>(game: &Game, hit: &FirstHit, tells_angle: bool, panel: &mut Panel<A>) {
    panel.fact("first hit", piece(game, hit.coin));
    offset(&hit.impact.collision, panel);
    if tells_angle {
        impact_angle(&hit.impact.collision, panel);
    }
}

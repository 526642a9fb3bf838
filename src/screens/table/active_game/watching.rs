//! Watching strokes, and examining their impacts.

use std::time::Duration;

use glam::DVec2;
use strum::{EnumMessage, IntoStaticStr};

use super::{ActiveGame, After, GameAction, GameHistory, GamePhase, Player, score};
use crate::game::Piece;
use crate::messages::Key;
use crate::numbers::capital;
use crate::physics::{EventKind, Shot};
use crate::quiz::why;
use crate::screens::table::calls::Called;
use crate::screens::table::game_history::Past;
use crate::screens::table::{TableAction, TablePanel, words};
use crate::screens::{Context, Next};
use crate::widgets::hit::{HitPace, Watch};
use crate::widgets::ink::token;
use crate::widgets::input::{KeyTable, ListAction};
use crate::widgets::panel::Panel;
use crate::widgets::panels::{reason, said_and_true};
use crate::widgets::replay::{ShotAction, ShotClock, ShotPlayer, WatchRate};
use crate::widgets::{Charset, Role};

/// The time that a pocketed piece takes to reach its tray, in seconds.
pub(super) const FALL: f64 = 0.6;

/// The time, in seconds at real speed, for which the end of a stroke is shown before computers play
/// on.
const END_SEEN: f64 = 4.0;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FallingPiece {
    pub(super) piece: Piece,
    /// The time of the fall, in seconds since the start of the stroke.
    pub(super) time: f64,
    /// The index of the corner, as in the engine.
    pub(super) corner: usize,
}

#[derive(Debug, Clone)]
pub(super) struct StrokeReplay {
    /// The number of the stroke's move in the game.
    pub(super) number: usize,
    /// Whether the game waits for the end of this replay; going back then means leaving the game,
    /// unless the game is over.
    pub(super) live: bool,
    /// How long the end has been visible; counted only while carrom does not wait for a key.
    end_seen: Duration,
    /// The piece of each disc in the shot.
    pub(super) pieces: Vec<Piece>,
    /// The pieces that fall, in order.
    pub(super) falls: Vec<FallingPiece>,
    /// The shot, its clock and its impacts.
    pub(super) player: ShotPlayer,
}

/// What the keys do while the player is watching a stroke.
#[derive(Debug, Clone, Copy, PartialEq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum StrokeAction {
    /// control the time and the list of impacts
    Replay(ShotAction),
    /// go on: to the next stroke, or back to the game
    GoOn,
    /// skip to the end of the stroke
    ToTheEnd,
    /// go to the previous stroke
    StrokeBefore,
    /// go to the next stroke
    StrokeAfter,
}

impl StrokeReplay {
    /// The replay of a stroke, with the prediction for its first impact; from its
    /// beginning, or `at_end`.
    pub(super) fn new(number: usize, shot: Shot, past: &Past, at_end: bool, cx: &Context) -> Self {
        let coins = past.before.coins().iter().map(|coin| coin.piece);
        let pieces: Vec<_> = std::iter::once(Piece::Striker).chain(coins).collect();
        let faces = pieces.iter().copied().map(words::face).collect();
        let rate = cx.settings.watch_rate.unwrap_or(WatchRate::REAL);
        let falls = shot.events().iter().filter_map(|event| match event.kind {
            EventKind::Pocket { disc, corner } => Some(FallingPiece {
                piece: *pieces.get(disc)?,
                time: event.time,
                corner,
            }),
            _ => None,
        });
        let falls: Vec<_> = falls.collect();
        // The replay lasts at least until the last piece has reached its tray.
        let last = falls.last().map_or(0.0, |fall| fall.time + FALL);
        let clock = ShotClock::new(shot.duration().max(last), rate, at_end);
        let called = past.called.as_ref().map(|called| called.said);
        let player = ShotPlayer::new(shot, 0, clock).with_faces(faces);
        Self {
            number,
            live: false,
            end_seen: Duration::ZERO,
            pieces,
            falls,
            player: player.with_said(called).with_list(),
        }
    }

    /// The discs that are now on the board, with their positions.
    pub(super) fn discs(&self) -> impl Iterator<Item = (Piece, DVec2)> {
        let discs = self.player.discs();
        discs.filter_map(|(disc, at)| Some((*self.pieces.get(disc)?, at)))
    }

    pub(super) fn keys(&self, history: &GameHistory) -> KeyTable<StrokeAction> {
        use StrokeAction::{GoOn, Replay, StrokeAfter, StrokeBefore, ToTheEnd};
        let over = self.player.clock().is_over();
        let board = self.player.chosen().is_none();
        let before = history.stroke_before(self.number);
        let before = before.map(|_| ('p', StrokeBefore));
        let after = history.stroke_from(self.number + 1);
        let after = after.map(|_| ('n', StrokeAfter));
        KeyTable::new("table")
            .on(' ', GoOn, "go on")
            .or([(Key::Enter, GoOn)])
            .when(over && board)
            .with(self.player.keys(), Replay)
            .on(Key::Enter, ToTheEnd, "")
            .when(!over && board)
            .each(before.into_iter().chain(after), "other strokes")
            .called(&["before", "after"])
            .when(board)
    }

    pub(super) fn act(
        &mut self,
        action: StrokeAction,
        game: &mut ActiveGame,
        cx: &mut Context,
    ) -> Option<GamePhase> {
        match action {
            StrokeAction::Replay(action) => self.work(action, cx),
            StrokeAction::ToTheEnd => self.work(ShotAction::Seek(f64::INFINITY), cx),
            StrokeAction::GoOn => Some(self.go_on(game, cx)),
            StrokeAction::StrokeBefore => {
                game.look_at(game.history.stroke_before(self.number), true, cx)
            }
            StrokeAction::StrokeAfter => {
                game.look_at(game.history.stroke_from(self.number + 1), true, cx)
            }
        }
    }

    /// Controls the clock or the list of impacts; the replay does not end.
    pub(super) fn work(&mut self, action: ShotAction, cx: &mut Context) -> Option<GamePhase> {
        let settings = &mut cx.settings;
        let pace = settings.pace();
        self.player.act(action, &mut settings.watch_rate, pace);
        None
    }

    /// Continues with the next stroke, or with the game.
    fn go_on(&self, game: &mut ActiveGame, cx: &Context) -> GamePhase {
        let next = game.history.stroke_from(self.number + 1);
        let still = cx.settings.reduced_motion;
        let watching = next.and_then(|next| game.look_at(Some(next), still, cx));
        watching.unwrap_or_else(|| game.turn(cx))
    }

    /// Handles a click on the picture. At the end of the replay, a click continues.
    pub(super) fn click(&mut self, game: &mut ActiveGame, cx: &mut Context) -> After {
        match self.player.clicked() {
            Some(action) => self.work(action, cx).into(),
            None if self.is_at_its_end() => After::Phase(self.go_on(game, cx)),
            None => After::Screen(Next::Ignored),
        }
    }

    /// Whether the replay is at its end and no impact is open.
    fn is_at_its_end(&self) -> bool {
        self.player.clock().is_over() && self.player.chosen().is_none()
    }

    /// The time left until a game between computers continues after a stroke; `None` if the stroke
    /// is still being shown, or if the game waits for a key.
    fn left_at_end(&self, game: &ActiveGame, pace: HitPace) -> Option<Duration> {
        let alone = game.options.count(Player::Person) == 0 && pace == HitPace::Flowing;
        let goes_on = self.live && alone && self.is_at_its_end();
        let all = Duration::from_secs_f64(END_SEEN / self.player.clock().rate.seconds());
        goes_on.then(|| all.saturating_sub(self.end_seen))
    }

    /// Advances the time of the stroke, and of the pause at its end.
    pub(super) fn advance(
        &mut self,
        passed: Duration,
        game: &mut ActiveGame,
        cx: &Context,
    ) -> Option<GamePhase> {
        let pace = cx.settings.pace();
        self.player.advance(passed, pace);
        self.left_at_end(game, pace)?;
        self.end_seen += passed;
        let over = self.left_at_end(game, pace) == Some(Duration::ZERO);
        over.then(|| self.go_on(game, cx))
    }

    pub(super) fn wake(&self, game: &ActiveGame, pace: HitPace) -> Option<Duration> {
        let running = self.player.wake(pace);
        running.or_else(|| self.left_at_end(game, pace))
    }

    /// The titles of the picture and the panel.
    pub(super) fn titles(&self, history: &GameHistory) -> (String, String) {
        if let Some(watch) = self.player.zoom() {
            return (watch.slowed_title(), "why".into());
        }
        let clock = self.player.clock();
        let time = format!("{:.2} s, {}", clock.time(), clock.rate.words());
        let name = match self.player.list() {
            Some(_) => "impacts".into(),
            None => {
                let stroke = history.strokes_before(self.number + 1);
                format!("stroke {stroke} of {}", history.record().strokes())
            }
        };
        (time, name)
    }

    pub(super) fn write(&self, game: &ActiveGame, charset: Charset, panel: &mut TablePanel) {
        if self.player.list().is_some() {
            return self.write_list(panel);
        }
        match (self.player.zoom(), game.history.past(self.number)) {
            (Some(watch), _) => self.write_impact(watch, panel),
            (None, Some(past)) if self.is_at_its_end() => {
                self.write_end(past, game, charset, panel);
            }
            (None, Some(past)) => {
                let name = game.options.seat_name(past.before.seat());
                self.write_so_far(name, charset, panel);
            }
            (None, None) => {}
        }
    }

    /// Writes the facts about a stroke whose pieces are still moving.
    fn write_so_far<A>(&self, name: &str, charset: Charset, panel: &mut Panel<A>) {
        let player = &self.player;
        let speed = player.shot().start(0).velocity.length();
        panel.fact("struck by", name);
        panel.fact("at", format!("{speed:.1} m/s"));
        let now = player.clock().time();
        let so_far = player.impacts().iter().filter(|it| it.time <= now);
        panel.fact("impacts", so_far.count().to_string());
        panel.gap();
        let pieces = [Piece::White, Piece::Black, Piece::Queen].into_iter();
        for piece in pieces.filter(|piece| self.pieces.contains(piece)) {
            let sign = token(words::role(piece), charset);
            let name = format!("{} {sign}", <&str>::from(piece));
            let there = self.discs().filter(|(other, _)| *other == piece);
            panel.pair((name, Role::Text), (there.count().to_string(), Role::Text));
        }
    }

    /// Writes the result of the stroke.
    fn write_end(&self, past: &Past, game: &ActiveGame, charset: Charset, panel: &mut TablePanel) {
        past.write_rulings(panel);
        if let (Some(meant), Some(played)) = (&past.meant, &past.story) {
            let name = game.options.seat_name(past.before.seat());
            panel.line(format!("{}:", capital(name)), Role::Title);
            panel.paragraph(meant.decision.afterwards(played), Role::Text);
            panel.gap();
        }
        let struck = game.history.strike(self.number);
        if let Some((slip, strike)) = game.slip(self.number).zip(struck) {
            let stroke = words::whose(game.options.seat_name(past.before.seat()), "stroke");
            let slip = slip.in_words(&capital(&stroke), strike.velocity);
            panel.paragraph(slip, Role::Text);
            panel.gap();
        }
        if let Some(called) = &past.called {
            write_call(called, panel);
        }
        panel.warning(game.notice.as_deref());
        if self.number + 1 == game.history.len() {
            score::write(game, charset, panel);
        }
        panel.gap();
        let go_on = TableAction::Watch(StrokeAction::GoOn);
        let impacts = TableAction::Watch(StrokeAction::Replay(ShotAction::Impacts));
        let back = TableAction::Game(GameAction::Back);
        panel.prompts(match game.history.stroke_from(self.number + 1) {
            Some(_) => vec![("the next stroke", go_on), ("back to the game", back)],
            None if self.player.impacts().is_empty() => vec![("go on", go_on)],
            None => vec![("go on", go_on), ("the impacts", impacts)],
        });
    }

    /// Writes the list of impacts, with the chosen one marked.
    fn write_list(&self, panel: &mut TablePanel) {
        let list = |action| TableAction::Watch(StrokeAction::Replay(ShotAction::List(action)));
        panel.prompt("look closer", list(ListAction::Open));
        panel.gap();
        panel.pin();
        let chosen = self.player.chosen().map(|(number, _)| number);
        for (i, impact) in self.player.impacts().iter().enumerate() {
            let [a, b] = impact.discs.map(|disc| self.name(disc));
            let name = (format!("{} {a} on {b}", i + 1), Role::Text);
            let time = (format!("{:.5} s", impact.time), Role::Text);
            panel.row(name, time, chosen == Some(i), list(ListAction::Point(i)));
        }
    }

    /// Writes the explanation of an enlarged impact: the two discs, the numbers, and the reason for
    /// their directions.
    fn write_impact<A>(&self, watch: &Watch, panel: &mut Panel<A>) {
        let impact = self.player.chosen().map(|(_, impact)| impact.discs);
        let [first, second] = impact.unwrap_or_default().map(|disc| self.name(disc));
        panel.heading(format!("{first} on {second}"));
        if !watch.write_facts([false; 2], panel) {
            return;
        }
        if first != "striker" {
            let here = format!("Here the {first} acts as the striker.");
            panel.paragraph(here, Role::Dim);
        }
        reason(&why(watch.collision(), watch.said), panel);
    }

    fn name(&self, disc: usize) -> &'static str {
        self.pieces
            .get(disc)
            .map_or("disc", |piece| (*piece).into())
    }
}

/// Writes the call beside the true directions.
fn write_call<A>(called: &Called, panel: &mut Panel<A>) {
    let points = format!("{} of {}", called.points(), Called::MOST);
    panel.pair(("your call", Role::Title), (points, Role::Title));
    let names = ["striker", "coin"].map(Some);
    said_and_true(&called.collision, &called.said, names, false, panel);
    panel.gap();
}

impl Past {
    /// Writes the referee's announcements about the move, with the numbers of the laws.
    pub(super) fn write_rulings<A>(&self, panel: &mut Panel<A>) {
        for ruling in &self.rulings {
            panel.paragraph(ruling.announced(), Role::Text);
        }
        panel.gap();
    }
}

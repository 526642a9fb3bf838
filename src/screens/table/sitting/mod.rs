//! A game in progress at the table.
//!
//! One file a thing that one does there: aiming, calling, watching a stroke,
//! looking into one impact, laying coins out, keeping the game.

mod aiming;
mod arranging;
mod calling;
mod keeping;
mod thinking;
mod watching;

use std::time::Duration;

use super::aim::Aim;
use super::arrange::Arrange;
use super::calls::Called;
use super::options::Options;
use super::pointer::Pointer;
use super::preview::{FirstHit, Preview};
use super::replay::Replay;
use super::session::Session;
use super::words::sentence;
use super::{panel, view};
use crate::game::opponent::Hint;
use crate::game::{Game, Move, PieceSet, Record, RecordError, Rules, Seat, Stage};
use crate::messages::{Input, Key, Mouse};
use crate::physics::Shot;
use crate::screens::Context;
use crate::widgets::hit::Watch;
use crate::widgets::{NumberEntry, RayInput, Scroll};
pub(super) use keeping::Keeping;

/// A game in progress, and what is being done at the table.
#[derive(Debug, Clone)]
pub(super) struct Sitting {
    pub(super) options: Options,
    pub(super) session: Session,
    pub(super) aim: Aim,
    /// What the aim will meet; kept, because it takes an engine to know.
    pub(super) preview: Option<Preview>,
    /// An angle being typed.
    pub(super) entry: NumberEntry,
    pub(super) phase: Phase,
    /// What has to be said just now: why something cannot be done.
    pub(super) notice: Option<String>,
    /// Help with the next stroke.
    pub(super) hint: Option<Hinted>,
    /// How far the panel is scrolled.
    pub(super) scroll: Scroll,
    /// Whether the player has been asked about leaving.
    pub(super) leaving: bool,
    /// How it is kept.
    pub(super) keeping: Keeping,
    /// What the mouse holds while its button is down.
    grip: Grip,
}

/// What is being done at the table.
#[derive(Debug, Clone)]
pub(super) enum Phase {
    /// Aiming the next stroke.
    Aim,
    /// Waiting for the computer's stroke.
    Think {
        /// By which the answer is known.
        ticket: u64,
    },
    /// Saying where the two of the first impact will go.
    Call(Box<Calling>),
    /// Watching a stroke.
    Watch(Box<Replay>),
    /// Looking into one impact of it.
    Impact(Box<Zoom>),
    /// Laying coins out, in practice.
    Arrange(Arrange),
    /// The board has ended.
    Over,
}

/// A hint on its way, or there.
#[derive(Debug, Clone)]
pub(super) enum Hinted {
    /// Asked for.
    Asked {
        /// By which the answer is known.
        ticket: u64,
    },
    /// There.
    Told {
        hint: Box<Hint>,
        /// What it speaks of on the board, if it speaks of a coin.
        pointer: Option<Pointer>,
        /// Whether all of it is told, or only where to look.
        whole: bool,
    },
}

/// A call in the making.
#[derive(Debug, Clone)]
pub(super) struct Calling {
    pub(super) hit: FirstHit,
    pub(super) rays: RayInput,
}

/// One impact of a stroke, enlarged.
#[derive(Debug, Clone)]
pub(super) struct Zoom {
    pub(super) watch: Watch,
    /// The stroke to go back to.
    pub(super) replay: Replay,
}

/// What the mouse holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Grip {
    /// The direction of the aim.
    Aim,
    /// The striker.
    Striker,
}

/// What became of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Taken {
    /// It was used.
    Used,
    /// It meant nothing here.
    Ignored,
    /// The player leaves the game.
    Leave,
}

impl Sitting {
    /// Sits down to a new game.
    pub(super) fn new(options: Options, seed: u64) -> Self {
        Self::with(options, Session::new(options.setup(seed)))
    }

    /// Sits down to a game that has been begun. What the record was agreed on counts,
    /// whatever the options say.
    ///
    /// # Errors
    /// If the record cannot be played.
    pub(super) fn resume(options: Options, record: Record) -> Result<Self, RecordError> {
        let setup = *record.setup();
        let options = Options {
            rules: setup.rules,
            hands: setup.hands,
            set: setup.set,
            ..options
        };
        let mut sitting = Self::with(options, Session::from_record(record)?);
        sitting.go_on();
        Ok(sitting)
    }

    fn with(options: Options, session: Session) -> Self {
        let mut sitting = Self {
            aim: Aim::begin(session.game()),
            options,
            session,
            preview: None,
            entry: NumberEntry::default(),
            phase: Phase::Aim,
            notice: None,
            hint: None,
            scroll: Scroll::default(),
            leaving: false,
            keeping: Keeping::default(),
            grip: Grip::Aim,
        };
        sitting.look_ahead();
        sitting
    }

    /// The game as it stands.
    pub(super) fn game(&self) -> &Game {
        self.session.game()
    }

    /// All that is needed to play the game again.
    pub(super) fn record(&self) -> &Record {
        self.session.record()
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

    /// What came of the call of a stroke.
    pub(super) fn called(&self, number: usize) -> Option<&Called> {
        self.session.past(number)?.called.as_ref()
    }

    /// Takes an input.
    pub(super) fn update(&mut self, input: &Input, cx: &mut Context) -> Taken {
        self.hand_over(cx);
        let taken = match input {
            Input::Key(key) => self.key(*key, cx),
            Input::Mouse(mouse) if !self.leaving => self.mouse(mouse, cx),
            Input::Searched(thought) => {
                self.thought(thought, cx);
                Taken::Used
            }
            Input::Kept(answer) => {
                self.take_answer(answer);
                Taken::Used
            }
            _ => Taken::Ignored,
        };
        if taken != Taken::Leave {
            self.hand_over(cx);
        }
        self.save(cx);
        taken
    }

    fn key(&mut self, key: Key, cx: &mut Context) -> Taken {
        if self.leaving {
            self.leaving = false;
            return match key {
                Key::Escape | Key::Enter | Key::Char('y') => Taken::Leave,
                _ => Taken::Used,
            };
        }
        // While aiming they turn the aim, unless there is a long hint to read.
        let reads = matches!(self.hint, Some(Hinted::Told { whole: true, .. }));
        if (reads || !matches!(self.phase, Phase::Aim))
            && let Key::PageUp | Key::PageDown = key
        {
            self.scroll_by(if key == Key::PageUp { -8 } else { 8 }, cx);
            return Taken::Used;
        }
        self.scroll = Scroll::default();
        self.notice = None;
        let taken = match &mut self.phase {
            Phase::Aim => self.aiming_key(key, cx),
            Phase::Call(_) => self.calling_key(key, cx),
            Phase::Watch(_) => self.watching_key(key, cx),
            Phase::Impact(_) => self.impact_key(key),
            Phase::Arrange(_) => self.arranging_key(key),
            Phase::Think { .. } => thinking_key(key),
            Phase::Over => self.over_key(key),
        };
        let taken = match taken {
            Taken::Ignored => self.keeping_key(key, cx),
            taken => taken,
        };
        if taken == Taken::Leave && self.is_running() {
            self.leaving = true;
            return Taken::Used;
        }
        taken
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &Context) -> Taken {
        self.notice = None;
        match &mut self.phase {
            Phase::Aim => self.aiming_mouse(mouse, cx),
            Phase::Call(_) => self.calling_mouse(mouse, cx),
            Phase::Watch(_) => self.watching_mouse(mouse, cx),
            Phase::Impact(_) => self.impact_mouse(mouse),
            Phase::Arrange(_) => self.arranging_mouse(mouse, cx),
            Phase::Think { .. } | Phase::Over => Taken::Ignored,
        }
    }

    fn scroll_by(&mut self, rows: i16, cx: &Context) {
        let area = view::layout(cx.body, view::is_enlarged(self)).panel;
        let mut scroll = self.scroll;
        scroll.by(rows, area, cx.settings.look(), |lines| {
            panel::write(self, lines);
        });
        self.scroll = scroll;
    }

    /// Lets time pass on the screen.
    pub(super) fn advance(&mut self, passed: Duration, cx: &mut Context) {
        self.hand_over(cx);
        match &mut self.phase {
            Phase::Watch(replay) => replay.advance(passed),
            Phase::Impact(zoom) => zoom.watch.advance(passed),
            _ => {}
        }
    }

    /// When it next needs time.
    pub(super) fn wake(&self) -> Option<Duration> {
        match &self.phase {
            Phase::Watch(replay) => replay.wake(),
            Phase::Impact(zoom) => zoom.watch.wake(),
            Phase::Aim if self.is_computers_turn() => Some(Duration::ZERO),
            _ => None,
        }
    }

    /// Whether leaving now would break a game off.
    fn is_running(&self) -> bool {
        self.session.len() > 0 && !matches!(self.game().stage(), Stage::MatchOver(_))
    }

    /// Goes on with the game as it stands: aiming, or the end of the board.
    fn go_on(&mut self) {
        self.phase = match self.game().stage() {
            Stage::Playing => Phase::Aim,
            _ => Phase::Over,
        };
    }

    /// Makes a move and begins the turn that follows; says in words if it cannot be
    /// made. Gives the shot if it was a stroke.
    fn make(&mut self, next: Move) -> Option<Shot> {
        match self.session.make(next) {
            Ok(shot) => {
                self.begin_turn();
                shot
            }
            Err(error) => {
                self.notice = Some(format!("{}.", sentence(&error.to_string())));
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
        self.look_ahead();
    }

    /// Passes, because coins bar every place for the striker.
    fn pass(&mut self) {
        let number = self.session.len();
        self.phase = Phase::Aim;
        self.make(Move::NoPlace);
        if let Some(past) = self.session.past(number) {
            self.notice = past.rulings.first().map(|ruling| ruling.text.clone());
        }
    }

    /// The aim with the number that is being typed for its direction.
    pub(super) fn aimed(&self) -> Aim {
        let mut aim = self.aim;
        if let Some(degrees) = self.entry.value() {
            aim.set_direction(degrees);
        }
        aim
    }

    /// Works out what the aim will meet.
    fn look_ahead(&mut self) {
        self.preview = Preview::of(&self.aimed().strike(self.seat()), self.game());
    }

    /// The board after one that has ended.
    fn over_key(&mut self, key: Key) -> Taken {
        match key {
            Key::Enter | Key::Char(' ') => {
                if let Stage::MatchOver(_) = self.game().stage() {
                    return Taken::Leave;
                }
                self.make(Move::NextBoard);
                self.go_on();
            }
            Key::Char('i' | 'I') => self.look_back(self.session.len()),
            Key::Escape => return Taken::Leave,
            _ => return Taken::Ignored,
        }
        Taken::Used
    }
}

/// While the computer thinks one can only leave.
fn thinking_key(key: Key) -> Taken {
    match key {
        Key::Escape => Taken::Leave,
        _ => Taken::Ignored,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::SavedGame;
    use crate::game::opponent;
    use crate::messages::{Effect, Found, SearchResult, SearchTask, Wanted};
    use crate::physics::Board;
    use crate::screens::Settings;

    fn context() -> Context {
        let settings = Settings {
            reduced_motion: true,
            ..Settings::default()
        };
        Context::new(settings, 1)
    }

    fn press(sitting: &mut Sitting, keys: &str, cx: &mut Context) {
        for letter in keys.chars() {
            let key = match letter {
                '\n' => Key::Enter,
                '\t' => Key::Tab,
                '^' => Key::Up,
                other => Key::Char(other),
            };
            sitting.update(&Input::Key(key), cx);
        }
    }

    fn asked(cx: &mut Context) -> Vec<SearchTask> {
        let effects = cx.take_asked().into_iter();
        effects
            .filter_map(|effect| match effect {
                Effect::Search(task) => Some(*task),
                _ => None,
            })
            .collect()
    }

    /// What was written down leads to what is on the table, to the last bit, also by
    /// way of a file.
    fn assert_recorded(sitting: &Sitting, cx: &Context) {
        let text = sitting.saved(cx).text().unwrap();
        let (read, game) = SavedGame::read("a game", text.as_bytes()).unwrap();
        assert_eq!(&game, sitting.game());
        let again = Sitting::resume_saved(&read, 1).unwrap();
        assert_eq!(again.options, sitting.options);
        assert_eq!(again.session.len(), sitting.session.len());
        assert_eq!(again.session.calls(), sitting.session.calls());
    }

    #[test]
    fn the_record_replays_to_the_game_on_the_table() {
        let mut cx = context();
        let mut sitting = Sitting::new(Options::two_people(), 4);
        press(&mut sitting, "c[[97.3 60\n30\n\n", &mut cx);
        press(&mut sitting, "c]]]]88 \n+++++}101 \n{{120.55 \n", &mut cx);
        assert_eq!(sitting.session.len(), 4);
        assert!(sitting.session.has_calls());
        assert_recorded(&sitting, &cx);

        let practice = Options {
            rules: Rules::Practice,
            ..Options::default()
        };
        let mut sitting = Sitting::new(practice, 4);
        press(&mut sitting, "91 \np\t ^^^^^^^^ p80 \n85 \nz", &mut cx);
        assert_eq!(sitting.session.len(), 3);
        assert_recorded(&sitting, &cx);
    }

    #[test]
    fn only_the_thought_that_is_waited_for_is_taken_in() {
        let mut cx = context();
        let options = Options {
            players: [super::super::options::Player::Computer; 4],
            ..Options::default()
        };
        let mut sitting = Sitting::new(options, 4);
        // Nobody has to press a key for it.
        assert!(sitting.wake().is_some());
        sitting.advance(Duration::ZERO, &mut cx);
        assert_eq!(sitting.wake(), None);
        let tasks = asked(&mut cx);
        assert_eq!(tasks.len(), 1);
        let SearchTask {
            ticket,
            game,
            seed,
            wanted: Wanted::Stroke(strength),
        } = &tasks[0]
        else {
            panic!("a stroke was wanted");
        };
        let decision = opponent::think(game, &Board::default(), *strength, *seed);
        let thought = SearchResult {
            ticket: *ticket,
            found: Found::Stroke(decision),
        };
        let stale = SearchResult {
            ticket: thought.ticket + 1,
            ..thought
        };
        for unwanted in [
            stale,
            SearchResult {
                found: Found::Hint(None),
                ..thought
            },
        ] {
            sitting.update(&Input::Searched(Box::new(unwanted)), &mut cx);
            assert!(matches!(sitting.phase, Phase::Think { .. }));
        }
        let mut failing = sitting.clone();
        sitting.update(&Input::Searched(Box::new(thought)), &mut cx);
        assert!(matches!(sitting.phase, Phase::Watch(_)));
        assert!(sitting.session.past(0).unwrap().told.is_some());
        // The same thought again comes too late.
        sitting.update(&Input::Searched(Box::new(thought)), &mut cx);
        assert_eq!(sitting.session.len(), 1);
        assert_recorded(&sitting, &cx);
        assert_eq!(asked(&mut cx), vec![]);
        press(&mut sitting, "\n", &mut cx);
        assert_eq!(asked(&mut cx).len(), 1);
        // Where the computer fails a person plays on, and is told so.
        failing.update(&Input::Searched(Box::new(tasks[0].failed())), &mut cx);
        assert!(matches!(failing.phase, Phase::Aim));
        assert!(failing.notice.is_some() && !failing.is_computers_turn());
        assert_eq!(asked(&mut cx), vec![]);
        press(&mut failing, " ", &mut cx);
        assert_eq!(failing.session.len(), 1);
    }

    #[test]
    fn a_hint_that_fails_is_told_and_can_be_asked_for_again() {
        let mut cx = context();
        let mut sitting = Sitting::new(Options::two_people(), 4);
        for _ in 0..2 {
            sitting.ask_for_hint(&mut cx);
            let tasks = asked(&mut cx);
            assert_eq!(tasks.len(), 1);
            sitting.update(&Input::Searched(Box::new(tasks[0].failed())), &mut cx);
            assert!(sitting.hint.is_none() && sitting.notice.is_some());
        }
    }

    #[test]
    fn nothing_moves_but_a_stroke_that_is_watched() {
        let mut cx = Context::new(Settings::default(), 1);
        let mut sitting = Sitting::new(Options::two_people(), 4);
        assert_eq!(sitting.wake(), None);
        press(&mut sitting, " ", &mut cx);
        assert!(sitting.wake().is_some());
        sitting.advance(Duration::from_secs(60), &mut cx);
        assert_eq!(sitting.wake(), None);
    }
}

//! The keys of the table: what they are called, and when they mean something.

use strum::{EnumMessage, IntoStaticStr};

use super::active_game::{ActiveGame, TablePhase};
use super::new_game::NewGame;
use crate::game::{Aids, Piece};
use crate::messages::Key;
use crate::screens::kept_files::KeptAction;
use crate::widgets::input::{EntryAction, FormAction, KeyTable, RayAction};
use crate::widgets::replay::ShotAction;
use crate::widgets::scroll_keys;

/// What keys do at the table.
#[derive(Debug, Clone, Copy, PartialEq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum TableAction {
    /// agree on the game
    Agree(FormAction),
    /// play
    Play,
    /// the games that are saved: resume one, or watch it again
    SavedGames,
    /// choose a saved game, resume or remove it
    Saved(KeptAction),
    /// watch the whole game again, stroke by stroke
    WatchAll,
    /// the best stroke of the board again
    WatchBest,
    /// export: write the game to a file of its own
    Export,
    /// turn the aim: Left and Right by 1°, Up and Down by 0.1°
    Turn(i16),
    /// turn the aim by 10°
    TurnFar(i16),
    /// strength; the wheel too
    Strength(i8),
    /// move the striker: square brackets by 2 mm, braces by 20 mm
    Place(i8),
    /// practice: striker up or down
    PlaceUp(i8),
    /// a number typed: Enter takes it as the angle, + as the strength, a square bracket as millimetres left or right
    Number(EntryAction),
    /// aim line, ghost, departures on or off
    Aid(AimAid),
    /// call it on or off: before each stroke say where the two of the first hit will go
    Call,
    /// hint: where to look; again: the whole stroke; once more: set it
    Hint,
    /// strike
    Strike,
    /// let the computer strike at once
    StrikeShown,
    /// your call: say first where the two of the computer's hit will go
    CallShown,
    /// turn the rays of the call
    Ray(RayAction),
    /// the last stroke again, with its impacts
    LookBack,
    /// practice: lay the coins out
    LayOut,
    /// practice: take the last stroke back
    Undo,
    /// move the hand: arrows by 20 mm, letters by 2 mm
    Hand(i8, i8),
    /// take the coin under the hand, or lay it down
    TakeOrLay,
    /// put the hand over the next coin
    NextCoin,
    /// add a white, a black, or the queen
    Add(Piece),
    /// remove the coin under the hand
    RemoveCoin,
    /// time, and the list of impacts
    Replay(ShotAction),
    /// go on: the next stroke, or back to the game
    GoOn,
    /// to the end of the stroke
    ToTheEnd,
    /// the stroke before
    StrokeBefore,
    /// the stroke after
    StrokeAfter,
    /// the next board, or the end of the match
    NextBoard,
    /// scroll a text that is longer than its place
    Scroll(i16),
    /// back
    Back,
}

/// A help while aiming.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AimAid {
    /// The striker's way to its first coin.
    Line,
    /// Where the striker will be then.
    Ghost,
    /// Where both will leave that hit.
    Rays,
}

impl AimAid {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Line, Self::Ghost, Self::Rays];

    /// Whether it is on.
    pub(super) fn of(self, aids: &mut Aids) -> &mut bool {
        match self {
            Self::Line => &mut aids.line,
            Self::Ghost => &mut aids.ghost,
            Self::Rays => &mut aids.rays,
        }
    }
}

use TableAction as Do;

/// The keys of the page on which a new game is agreed.
pub(super) fn new_game(page: &NewGame) -> KeyTable<TableAction> {
    KeyTable::new("table")
        .on(Key::Enter, Do::Play, "play")
        .on('s', Do::SavedGames, "saved games")
        .with(page.form.keys(&page.options), Do::Agree)
        .on(Key::Escape, Do::Back, "back")
}

/// The keys of a game, the most useful first.
pub(super) fn keys(game: &ActiveGame) -> KeyTable<TableAction> {
    let table = KeyTable::new("table");
    let table = match &game.phase {
        TablePhase::Aim => return aiming(game, table),
        TablePhase::Show(_) => computer_aims(),
        TablePhase::Call(calling) => {
            let rays = calling.rays.keys("next, then strike");
            table.with(rays, Do::Ray).on(Key::Escape, Do::Back, "back")
        }
        TablePhase::Watch(replay) => {
            let over = replay.player.clock().is_over();
            let board = replay.player.chosen().is_none();
            let before = game.history.stroke_before(replay.number);
            let before = before.map(|_| ('p', Do::StrokeBefore));
            let after = game.history.stroke_from(replay.number + 1);
            let after = after.map(|_| ('n', Do::StrokeAfter));
            table
                .on(' ', Do::GoOn, "go on")
                .or([(Key::Enter, Do::GoOn)])
                .when(over && board)
                .with(replay.player.keys(), Do::Replay)
                .on(Key::Enter, Do::ToTheEnd, "")
                .when(!over && board)
                .each(before.into_iter().chain(after), "other strokes")
                .when(board)
                .on(Key::Escape, Do::Back, "")
                .when(board)
        }
        TablePhase::Arrange(_) => arranging(table),
        TablePhase::Over => table.with(end_of_board(), |action| action),
    };
    let over = matches!(game.phase, TablePhase::Over);
    let named = |name| if over { name } else { "" };
    let arranges = matches!(game.phase, TablePhase::Arrange(_));
    let board = match &game.phase {
        TablePhase::Watch(replay) => replay.player.chosen().is_none(),
        _ => over || arranges,
    };
    table
        .on('v', Do::WatchAll, named("replay"))
        .when(board && !arranges)
        .on('e', Do::Export, named("export"))
        .when(board)
        .each(scroll_keys(Do::Scroll), "")
        .on(Key::Escape, Do::Back, "leave")
        .when(over)
}

/// The keys while the computer's aim is seen.
fn computer_aims() -> KeyTable<TableAction> {
    KeyTable::new("table")
        .on(' ', Do::StrikeShown, "strike")
        .or([(Key::Enter, Do::StrikeShown)])
        .on('c', Do::CallShown, "your call")
        .on(Key::Escape, Do::Back, "leave")
}

/// The keys with which the next board is begun.
fn end_of_board() -> KeyTable<TableAction> {
    KeyTable::new("table")
        .on(Key::Enter, Do::NextBoard, "next")
        .or([(' ', Do::NextBoard)])
        .on('i', Do::LookBack, "strokes")
        .on('b', Do::WatchBest, "best stroke")
}

fn aiming(game: &ActiveGame, table: KeyTable<TableAction>) -> KeyTable<TableAction> {
    let typing = game.entry.is_open();
    let practice = game.is_practice();
    let reads = game.reads_hint();
    table
        .on(' ', Do::Strike, "strike")
        .or((!typing).then_some((Key::Enter, Do::Strike)))
        .by(Key::ARROWS, Do::Turn, [-1, 1, -10, 10], "aim")
        .by(['+', '-'], Do::Strength, [1, -1], "strength")
        .or([('=', Do::Strength(1)), ('_', Do::Strength(-1))])
        .when(!typing)
        .on('+', Do::Strength(1), "as the strength")
        .or([('=', Do::Strength(1))])
        .when(typing)
        .by(['[', ']', '{', '}'], Do::Place, [-1, 1, -10, 10], "place")
        .or([('a', Do::Place(-1)), ('d', Do::Place(1))])
        .on('p', Do::LayOut, "lay out")
        .when(practice)
        .on('z', Do::Undo, "undo")
        .when(practice)
        .on('h', Do::Hint, "hint")
        .with(game.entry.keys(), Do::Number)
        .on('c', Do::Call, "call")
        .by(['l', 'g', 'r'], Do::Aid, AimAid::ALL, "aids")
        .on('i', Do::LookBack, "impacts")
        .on('v', Do::WatchAll, "replay")
        .on('e', Do::Export, "export")
        .by(['w', 's'], Do::PlaceUp, [1, -1], "")
        .when(practice)
        .each(scroll_keys(Do::Scroll), "")
        .when(reads)
        .by([Key::PageUp, Key::PageDown], Do::TurnFar, [-1, 1], "")
        .when(!reads)
        .on(
            Key::Escape,
            Do::Back,
            if game.is_pulling() { "not now" } else { "" },
        )
        .when(!typing)
}

fn arranging(table: KeyTable<TableAction>) -> KeyTable<TableAction> {
    let ways = [(0, 1), (0, -1), (-1, 0), (1, 0)];
    let far = |(x, y)| Do::Hand(10 * x, 10 * y);
    let near = ways.map(|(x, y)| Do::Hand(x, y));
    let coins = [Piece::White, Piece::Black, Piece::Queen];
    table
        .by(Key::ARROWS, far, ways, "move")
        .or(['w', 's', 'a', 'd'].into_iter().zip(near))
        .on(' ', Do::TakeOrLay, "take, lay")
        .or([(Key::Enter, Do::TakeOrLay)])
        .by(['o', 'b', 'q'], Do::Add, coins, "add")
        .on('x', Do::RemoveCoin, "remove")
        .or([Key::Delete, Key::Backspace].map(|key| (key, Do::RemoveCoin)))
        .on('z', Do::Undo, "undo")
        .on('p', Do::Back, "done")
        .or([(Key::Escape, Do::Back)])
        .on(Key::Tab, Do::NextCoin, "")
}

/// What the page of help says before the keys.
pub(super) fn about() -> Vec<&'static str> {
    vec![
        "Carrom: pocket your nine coins with the striker before the other side does, and the queen on the way. Who breaks plays white; who pockets an own coin plays on.",
        "Put the striker on your base line (the side whose turn it is is marked), aim, choose the strength, strike. After the stroke the referee says what follows, with the number of the law.",
        "The aim line and the ghost show where the striker will meet its first coin; the two arrows show where both leave that hit. Switch them off one by one as you get better.",
        "Call it: before the stroke, say at which angles the two of the first hit will leave it. Good calls earn points of their own, which never mix with the score.",
        "After any stroke press i: choose one of its impacts and look at it as in the lab; p and n go to other strokes.",
        "Every game is saved after each stroke. On the page of a new game, s shows the games there are: resume one, or watch it stroke by stroke. What e writes can be played again on any machine: carrom replay FILE.",
        "Angles, left and right are those of the screen, whoever strikes: 0 is to the right, 90 up, 180 to the left, 270 down.",
        "With the mouse or a finger: point where to aim, drag the striker along its base lines, pull it back and let go to strike. The farther you pull, the harder; a pull to the side turns the aim. Back to the striker, or Escape: no stroke.",
        "The computer is seen aiming before it strikes: Space strikes at once, and c lets you say first where the two of its first hit will go. Afterwards the line it meant is drawn beside the line it played.",
    ]
}

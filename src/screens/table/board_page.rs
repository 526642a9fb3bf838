//! The page of a board for one player: today's board, that of another day, or one with a code.

use jiff::ToSpan;
use jiff::civil::Date;
use strum::{EnumMessage, IntoStaticStr};

use super::{TableAction, picture};
use crate::game::opponent::par;
use crate::game::{BoardCode, PieceSet, Results};
use crate::messages::{FileKind, Key, StoreAnswer, StoreReply, StoreRequest};
use crate::numbers::{capital, counted};
use crate::screens::{Context, View};
use crate::widgets::input::{EntryAction, KeyTable};
use crate::widgets::panel::Panel;
use crate::widgets::{NumberEntry, Outcome, Role};

/// The number of earlier results that are listed.
const LISTED: usize = 7;

#[derive(Debug, Clone, Default)]
pub(super) struct BoardPage {
    /// The code of the board that is shown; `None` until a code is given or today's date is
    /// known.
    pub(super) code: Option<BoardCode>,
    pub(super) par: Option<usize>,
    today: Option<Date>,
    /// The code that is being typed.
    entry: NumberEntry,
    results: Results,
    notice: Option<String>,
}

/// What the keys do on the page of a board.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum BoardAction {
    /// play the board
    Play,
    /// show the board of the day before, or of the next day
    Neighbour(i8),
    /// type the code of another board: a number, or a date such as 20261126
    Code(EntryAction),
    /// read the rules of these boards
    Rules,
    /// go back
    Back,
}

impl BoardPage {
    /// Opens the page of the board with this code, or of today's board. Requests today's date, and
    /// the saved games, from which the results are counted.
    pub(super) fn ask(code: Option<BoardCode>, cx: &mut Context) -> Self {
        cx.ask(StoreRequest::Today);
        cx.ask(StoreRequest::List(FileKind::Game));
        Self {
            code,
            par: code.and_then(par),
            ..Self::default()
        }
    }

    fn show(&mut self, code: BoardCode) {
        if self.code != Some(code) {
            self.par = par(code);
            self.code = Some(code);
        }
    }

    /// Handles today's date, and the list of saved games.
    pub(super) fn take_answer(&mut self, answer: &StoreAnswer, cx: &Context) {
        match &answer.done {
            StoreReply::Today(today) => {
                self.today = *today;
                match today.map(BoardCode::of_day) {
                    _ if self.code.is_some() => {}
                    Some(Ok(code)) => self.show(code),
                    _ => {
                        let text = "Today's date is unknown. Type the code of a board.";
                        self.notice = Some(text.into());
                    }
                }
            }
            StoreReply::Games(Ok(games)) => {
                let games = games.iter().filter_map(|kept| kept.content.as_deref().ok());
                self.results = Results::of(&cx.settings.player, games);
            }
            _ => {}
        }
    }

    pub(super) fn keys(&self) -> KeyTable<BoardAction> {
        use BoardAction::{Back, Code, Neighbour, Play, Rules};
        let typing = self.entry.is_open();
        KeyTable::new("board")
            .on(Key::Enter, Play, "play")
            .when(!typing && self.code.is_some())
            .by([Key::Left, Key::Right], Neighbour, [-1, 1], "another day")
            .when(self.code.is_some())
            .on('r', Rules, "rules")
            .with(self.entry.keys(), Code)
            .on(Key::Escape, Back, "back")
            .when(!typing)
    }

    /// Carries out an action that changes which board is shown.
    pub(super) fn act(&mut self, action: BoardAction) {
        self.notice = None;
        match action {
            BoardAction::Neighbour(by) => self.go(by),
            BoardAction::Code(action) => {
                if let Outcome::Done(number) = self.entry.act(action) {
                    // `parse` also refuses a number with a fraction.
                    let shown = BoardCode::parse(&number.to_string()).map(|code| self.show(code));
                    let refused = shown.err();
                    self.notice = refused.map(|why| format!("{}.", capital(&why.to_string())));
                }
            }
            BoardAction::Play | BoardAction::Rules | BoardAction::Back => {}
        }
    }

    /// Goes to the board of the day before or of the next day; none comes after today's.
    fn go(&mut self, by: i8) {
        let day = self.code.and_then(BoardCode::day);
        let Some(next) = day.and_then(|day| day.checked_add(i64::from(by).days()).ok()) else {
            self.notice = Some("This board does not belong to a day.".into());
            return;
        };
        match BoardCode::of_day(next) {
            Ok(_) if by > 0 && self.today.is_some_and(|today| next > today) => {
                self.notice = Some("The next board is tomorrow's.".into());
            }
            Ok(code) => self.show(code),
            Err(_) => {}
        }
    }

    /// The coins on the board, and beside them the par and the results.
    pub(super) fn view(&self) -> View<'_, TableAction> {
        let mut panel = Panel::new("clear the board");
        panel.part(TableAction::Board, |panel| self.write(panel));
        let coins = self.code.map_or_else(Vec::new, BoardCode::coins);
        let board = move |area| picture::of_pack(&coins, PieceSet::default(), area);
        let title = self.code.map_or_else(String::new, BoardCode::title);
        View::drawn(title, board, panel).square()
    }

    fn write(&self, panel: &mut Panel<BoardAction>) {
        if let Some(code) = self.code {
            panel.paragraph(capital(&code.title()), Role::Title);
            let same = match code.day() {
                Some(_) => "Everyone has the same board on the same day.",
                None => "Everyone with this code has the same board.",
            };
            let text = format!("Pocket the six coins in as few strokes as you can. {same}");
            panel.paragraph(text, Role::Text);
            panel.gap();
            let strokes = |count| counted(count, "stroke");
            panel.fact("par", self.par.map_or("unknown".into(), strokes));
            let best = self.results.fewest(code);
            panel.fact("your best", best.map_or("not cleared yet".into(), strokes));
            panel.gap();
        }
        if let Some(typed) = self.entry.shown() {
            panel.fact("code", typed);
            panel.prompt("open it", BoardAction::Code(EntryAction::Enter));
        } else if let Some(code) = self.code {
            panel.prompt("play!", BoardAction::Play);
            if code.day().is_some() {
                panel.prompt("the day before", BoardAction::Neighbour(-1));
            }
            panel.prompt("the rules", BoardAction::Rules);
        }
        panel.warning(self.notice.as_deref());
        panel.paragraph("Type a number for another board.", Role::Dim);
        if let Some(code) = self.code {
            panel.gap();
            let command = format!("carrom board {code}");
            panel.code("This board for a friend", command, format!("board={code}"));
        }
        if !self.results.boards.is_empty() {
            panel.gap();
            panel.pair(("your boards", Role::Title), ("strokes", Role::Dim));
            for board in self.results.boards.iter().take(LISTED) {
                panel.fact(capital(&board.code.title()), board.strokes.to_string());
            }
        }
    }
}

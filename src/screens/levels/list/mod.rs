//! The list of levels: what there is, what has been won, what comes next.

mod view;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::levels::Shelf;
use crate::messages::{Input, Key, StoreReply, StoreRequest};
use crate::screens::list::{Chosen, chosen};
use crate::screens::{Context, Help, Hint, Next, OldScreen, Place};

/// The list of levels. Which one is chosen belongs to the [`Shelf`].
#[derive(Debug, Clone, Default)]
pub(crate) struct Levels {
    /// Whether the player has chosen for themselves.
    moved: bool,
}

impl Levels {
    /// The list, at the first level that was never won. Which ones the player has won
    /// before is asked for, and the list goes on to the next when that is known.
    pub(crate) fn new(cx: &mut Context) -> Self {
        cx.shelf.at = cx.shelf.next().unwrap_or(0);
        let player = cx.settings.player.clone();
        cx.ask(StoreRequest::Stars(player));
        Self::default()
    }
}

/// How many lines can be chosen: the levels, and after them the problems.
fn choices(shelf: &Shelf) -> usize {
    shelf.count() + shelf.library().problems.len()
}

/// Opens the chosen level; a problem has nothing to open.
fn open(shelf: &Shelf) -> Next {
    if shelf.at < shelf.count() {
        Next::Open(Place::Level { number: shelf.at })
    } else {
        Next::Stay
    }
}

impl OldScreen for Levels {
    fn title(&self) -> String {
        "levels".into()
    }

    fn status(&self, cx: &Context) -> String {
        let shelf = &cx.shelf;
        let won = (0..shelf.count()).filter(|number| shelf.stars(*number) > 0);
        format!("{} of {} won", won.count(), shelf.count())
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        let (body, shelf) = (cx.body, &mut cx.shelf);
        let line_at = |cell| view::choice_at(shelf, body, cell);
        match chosen(input, shelf.at, choices(shelf), line_at) {
            Chosen::Line(line) => shelf.at = line,
            Chosen::Open => return open(shelf),
            Chosen::Nothing => match input {
                Input::Key(Key::Char('n' | 'N')) => shelf.at = shelf.next().unwrap_or(shelf.at),
                Input::Kept(answer)
                    if matches!(answer.done, StoreReply::Stars(_)) && !self.moved =>
                {
                    shelf.at = shelf.next().unwrap_or(0);
                }
                _ => return Next::Ignored,
            },
        }
        self.moved |= matches!(input, Input::Key(_) | Input::Mouse(_));
        Next::Stay
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(area, buf, cx);
    }

    fn keys(&self, _cx: &Context) -> Vec<Hint> {
        vec![
            Hint::new("Up Down", "choose"),
            Hint::new("Enter", "play"),
            Hint::new("n", "next to win"),
            Hint::new("Esc", "back"),
        ]
    }

    fn help(&self, cx: &Context) -> Help {
        Help {
            text: vec![
                "Each level is a small puzzle on the board: set the shot so that its goals come about. All of them are open; they get harder from the top down.",
                "A level gives up to three stars: one for winning it, one for at most three shots, and one for saying first where the discs will go (where nothing is asked: for winning with the first shot). Come back for more as often as you like; the best counts.",
                "Levels of your own: carrom --levels DIR. A file that cannot be read is listed at the end with what is wrong with it.",
            ],
            keys: self.keys(cx),
        }
    }
}

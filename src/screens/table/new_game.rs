//! The page on which a new game is agreed.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::options::{Options, Player, compass};
use super::{picture, view, words};
use crate::game::opponent::Strength;
use crate::game::pack::pack;
use crate::game::{Hands, PieceSet, Rules, Seat};
use crate::messages::{Key, Mouse, MouseKind};
use crate::screens::{Context, Hint};
use crate::widgets::{Lines, Role};

/// The page: what is chosen, and the line that keys change.
#[derive(Debug, Clone, Default)]
pub(super) struct NewGame {
    pub(super) options: Options,
    chosen: usize,
}

/// One thing to be agreed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Row {
    Rules,
    Hands,
    Seat(Seat),
    Strength,
    Pieces,
    Call,
    Line,
    Ghost,
    Rays,
}

/// What became of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Agreed {
    /// Something may have been changed.
    Changing,
    /// All is agreed: play.
    Play,
    /// Go on with a game that was saved.
    SavedGames,
    /// It meant nothing here.
    Ignored,
}

impl NewGame {
    /// The page with what was agreed last time.
    pub(super) fn with(options: Options) -> Self {
        Self { options, chosen: 0 }
    }

    fn rows(&self) -> Vec<Row> {
        let mut rows = vec![Row::Rules];
        if self.options.rules != Rules::Practice {
            rows.push(Row::Hands);
            rows.extend(self.options.seats().map(Row::Seat));
            if self.options.count(Player::Computer) > 0 {
                rows.push(Row::Strength);
            }
        }
        rows.extend([Row::Pieces, Row::Call, Row::Line, Row::Ghost, Row::Rays]);
        rows
    }

    fn row(&self) -> Row {
        let rows = self.rows();
        rows.get(self.chosen).copied().unwrap_or(Row::Rules)
    }

    pub(super) fn key(&mut self, key: Key) -> Agreed {
        let count = self.rows().len();
        match key {
            Key::Up | Key::BackTab => self.chosen = (self.chosen + count - 1) % count,
            Key::Down | Key::Tab => self.chosen = (self.chosen + 1) % count,
            Key::Right | Key::Char(' ') => self.row().change(&mut self.options, true),
            Key::Left => self.row().change(&mut self.options, false),
            Key::Enter => return Agreed::Play,
            Key::Char('s' | 'S') => return Agreed::SavedGames,
            _ => return Agreed::Ignored,
        }
        Agreed::Changing
    }

    pub(super) fn mouse(&mut self, mouse: &Mouse, cx: &Context) -> Agreed {
        let panel = view::layout(cx.body, false).panel;
        if mouse.kind != MouseKind::Down || !panel.contains((mouse.column, mouse.row).into()) {
            return Agreed::Ignored;
        }
        let line = usize::from(mouse.row - panel.y);
        let rows = self.rows();
        if line < rows.len() {
            self.chosen = line;
            self.row().change(&mut self.options, true);
            return Agreed::Changing;
        }
        Agreed::Ignored
    }

    /// Draws the page: the pack on the board, and beside it what is agreed.
    pub(super) fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        let layout = view::layout(area, false);
        layout.draw(buf, &look, "the pack", "a new game");
        let coins = pack(self.options.set, Seat::South);
        picture::of_pack(&coins, self.options.set, layout.picture).draw(buf, &look);
        let mut lines = Lines::new(layout.panel, buf, look);
        for (i, row) in self.rows().into_iter().enumerate() {
            let chosen = i == self.chosen;
            let (mark, name_role, role) = if chosen {
                (">", Role::Selected, Role::Selected)
            } else {
                (" ", Role::Dim, Role::Text)
            };
            let name = format!("{mark} {}", row.name());
            lines.pair(&name, &row.value(&self.options), name_role, role);
        }
        lines.gap();
        lines.paragraph(self.row().about(&self.options), Role::Text);
        lines.gap();
        lines.paragraph("Enter: play!", Role::Key);
        lines.paragraph("s: saved games", Role::Key);
    }

    /// The keys of the page.
    pub(super) fn keys() -> Vec<Hint> {
        vec![
            Hint::new("Enter", "play"),
            Hint::new("s", "saved games"),
            Hint::new("Up Down", "choose"),
            Hint::new("Left Right", "change"),
            Hint::new("Esc", "back"),
        ]
    }
}

impl Row {
    fn name(self) -> &'static str {
        match self {
            Self::Rules => "rules",
            Self::Hands => "hands",
            Self::Seat(seat) => compass(seat),
            Self::Strength => "computer",
            Self::Pieces => "pieces",
            Self::Call => "call it",
            Self::Line => "aim line",
            Self::Ghost => "ghost",
            Self::Rays => "departures",
        }
    }

    fn value(self, options: &Options) -> String {
        let switch = |on: bool| if on { "on" } else { "off" };
        let value = match self {
            Self::Strength => return options.strength.to_string(),
            Self::Rules => words::rules(options.rules),
            Self::Hands => match options.hands {
                Hands::Two => "two",
                Hands::Four => "four",
            },
            Self::Seat(seat) => match options.player(seat) {
                Player::Person if options.count(Player::Person) == 1 => "you",
                Player::Person => "a person",
                Player::Computer => "computer",
            },
            Self::Pieces => words::masses(options.set),
            Self::Call => switch(options.call),
            Self::Line => switch(options.aids.line),
            Self::Ghost => switch(options.aids.ghost),
            Self::Rays => switch(options.aids.rays),
        };
        value.into()
    }

    fn about(self, options: &Options) -> &'static str {
        match (self, options.rules) {
            (Self::Rules, Rules::Tournament) => {
                "The Laws of Carrom: boards of up to 12 points, a game to 25 or eight boards, the best of three."
            }
            (Self::Rules, Rules::Friendly) => {
                "As most families play: whoever clears first wins the board."
            }
            (Self::Rules, Rules::Practice) => {
                "No turns and no dues: striker and coins anywhere, and every stroke can be taken back."
            }
            (Self::Hands, _) => match options.hands {
                Hands::Two => "South against North.",
                Hands::Four => "Partners sit opposite: South and North against East and West.",
            },
            (Self::Seat(_), _) => "A person at this keyboard, or the computer.",
            (Self::Strength, _) => {
                "How far the computer looks, and how steady its hand is. It always says what it saw."
            }
            (Self::Pieces, _) => match options.set {
                PieceSet::Tournament => {
                    "A heavy striker on light coins: it is turned aside by at most 21.5°, and they part at less than 90°."
                }
                PieceSet::EqualMass => {
                    "Striker and coins weigh the same, so the two of a hit part at 90°."
                }
            },
            (Self::Call, _) => {
                "Before each stroke, say at which angles the two of the first hit leave it. Good calls earn points of their own."
            }
            (Self::Line, _) => "The way of the striker to the first coin it meets.",
            (Self::Ghost, _) => "Where the striker will be when they meet.",
            (Self::Rays, _) => {
                "Where both leave the first hit. While you call it they stay hidden."
            }
        }
    }

    /// The next value, or the one before.
    fn change(self, options: &mut Options, forward: bool) {
        match self {
            Self::Rules => {
                options.rules = match (options.rules, forward) {
                    (Rules::Tournament, true) | (Rules::Practice, false) => Rules::Friendly,
                    (Rules::Friendly, true) | (Rules::Tournament, false) => Rules::Practice,
                    (Rules::Practice, true) | (Rules::Friendly, false) => Rules::Tournament,
                };
            }
            Self::Hands => {
                options.hands = match options.hands {
                    Hands::Two => Hands::Four,
                    Hands::Four => Hands::Two,
                };
            }
            Self::Pieces => {
                options.set = match options.set {
                    PieceSet::Tournament => PieceSet::EqualMass,
                    PieceSet::EqualMass => PieceSet::Tournament,
                };
            }
            Self::Seat(seat) => {
                let other = match options.player(seat) {
                    Player::Person => Player::Computer,
                    Player::Computer => Player::Person,
                };
                options.set_player(seat, other);
            }
            Self::Strength => {
                let all = Strength::ALL;
                let now = all.iter().position(|s| *s == options.strength).unwrap_or(0);
                let step = if forward { 1 } else { all.len() - 1 };
                options.strength = all[(now + step) % all.len()];
            }
            Self::Call => options.call ^= true,
            Self::Line => options.aids.line ^= true,
            Self::Ghost => options.aids.ghost ^= true,
            Self::Rays => options.aids.rays ^= true,
        }
    }
}

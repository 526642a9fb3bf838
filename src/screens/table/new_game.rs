//! The page on which a new game is agreed.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::options::{Options, Player, compass};
use super::{picture, view, words};
use crate::game::opponent::Strength;
use crate::game::pack::pack;
use crate::game::{Hands, PieceSet, Rules, Seat};
use crate::messages::Mouse;
use crate::screens::Context;
use crate::widgets::input::{Field, FieldValue, FormAction, FormFields, SettingsForm};
use crate::widgets::{Lines, Outcome, Role};

/// The page: what is chosen, and the line that keys change.
#[derive(Debug, Clone, Default)]
pub(super) struct NewGame {
    pub(super) options: Options,
    pub(super) form: SettingsForm,
}

/// One thing to be agreed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Agreement {
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

impl NewGame {
    /// The page with what was agreed last time.
    pub(super) fn with(options: Options) -> Self {
        Self {
            options,
            form: SettingsForm::default(),
        }
    }

    /// Does what a key of the form stands for.
    pub(super) fn act(&mut self, action: FormAction) {
        self.form.act(action, &mut self.options);
    }

    /// A click on a row selects it and changes it; the wheel goes through the rows.
    pub(super) fn mouse(&mut self, mouse: &Mouse, cx: &Context) -> Outcome {
        let panel = view::layout(cx.body, false).panel;
        let row = panel.contains((mouse.column, mouse.row).into());
        let row = row.then(|| usize::from(mouse.row - panel.y));
        self.form.mouse(mouse, row, &mut self.options)
    }

    /// Draws the page: the pack on the board, and beside it what is agreed.
    pub(super) fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        let layout = view::layout(area, false);
        layout.draw(buf, &look, "the pack", "a new game");
        let coins = pack(self.options.set, Seat::South);
        picture::of_pack(&coins, self.options.set, layout.picture).draw(buf, &look);
        let mut lines = Lines::new(layout.panel, buf, look);
        self.form.write(&self.options, &mut lines);
        lines.gap();
        self.form.write_about(&self.options, &mut lines);
        lines.gap();
        lines.paragraph("Enter: play!", Role::Key);
        lines.paragraph("s: saved games", Role::Key);
    }
}

/// What is to be agreed, in the order of the page.
fn agreements(options: &Options) -> Vec<Agreement> {
    let mut rows = vec![Agreement::Rules];
    if options.rules != Rules::Practice {
        rows.push(Agreement::Hands);
        rows.extend(options.seats().map(Agreement::Seat));
        if options.count(Player::Computer) > 0 {
            rows.push(Agreement::Strength);
        }
    }
    use Agreement::{Call, Ghost, Line, Pieces, Rays};
    rows.extend([Pieces, Call, Line, Ghost, Rays]);
    rows
}

impl FormFields for Options {
    fn fields(&self) -> Vec<Field> {
        let field = |row: Agreement| {
            let (at, count) = row.choice(self);
            Field {
                name: row.name().into(),
                shown: row.value(self),
                value: FieldValue::Choice { at, count },
                about: row.about(self).into(),
                locked: None,
            }
        };
        agreements(self).into_iter().map(field).collect()
    }

    fn set(&mut self, at: usize, value: f64) {
        if let Some(row) = agreements(self).get(at) {
            row.choose(self, value as usize);
        }
    }
}

impl Agreement {
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

    /// Which of its values it has, and how many there are.
    fn choice(self, options: &Options) -> (usize, usize) {
        let place = |found: Option<usize>| found.unwrap_or(0);
        match self {
            Self::Rules => (place(RULES.iter().position(|it| *it == options.rules)), 3),
            Self::Hands => (usize::from(options.hands == Hands::Four), 2),
            Self::Pieces => (usize::from(options.set == PieceSet::EqualMass), 2),
            Self::Seat(seat) => (usize::from(options.player(seat) == Player::Computer), 2),
            Self::Strength => {
                let all = Strength::ALL;
                (
                    place(all.iter().position(|it| *it == options.strength)),
                    all.len(),
                )
            }
            Self::Call => (options.call.into(), 2),
            Self::Line => (options.aids.line.into(), 2),
            Self::Ghost => (options.aids.ghost.into(), 2),
            Self::Rays => (options.aids.rays.into(), 2),
        }
    }

    /// Gives it one of its values.
    fn choose(self, options: &mut Options, at: usize) {
        let second = at > 0;
        match self {
            Self::Rules => options.rules = RULES[at % RULES.len()],
            Self::Hands => options.hands = if second { Hands::Four } else { Hands::Two },
            Self::Pieces => {
                let sets = [PieceSet::Tournament, PieceSet::EqualMass];
                options.set = sets[usize::from(second)];
            }
            Self::Seat(seat) => {
                let players = [Player::Person, Player::Computer];
                options.set_player(seat, players[usize::from(second)]);
            }
            Self::Strength => options.strength = Strength::ALL[at % Strength::ALL.len()],
            Self::Call => options.call = second,
            Self::Line => options.aids.line = second,
            Self::Ghost => options.aids.ghost = second,
            Self::Rays => options.aids.rays = second,
        }
    }
}

/// The rules, in the order in which they are chosen.
const RULES: [Rules; 3] = [Rules::Tournament, Rules::Friendly, Rules::Practice];

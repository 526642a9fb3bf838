//! The page on which a new game is agreed.

use ratatui::buffer::Buffer;

use super::options::{Options, Player};
use super::{picture, words};
use crate::game::opponent::Strength;
use crate::game::pack::pack;
use crate::game::{Hands, PieceSet, Rules, Seat};
use crate::messages::{Mouse, MouseKind};
use crate::screens::{Context, Next};
use crate::widgets::input::{Field, FieldValue, FormAction, FormFields, ListView, SettingsForm};
use crate::widgets::panel::written;
use crate::widgets::{Lines, Role, SplitLayout};

/// The page: what is chosen, and the line that keys change.
#[derive(Debug, Clone, Default)]
pub(super) struct NewGame {
    pub(super) options: Options,
    pub(super) form: SettingsForm,
}

/// One thing to be agreed.
struct Agreement {
    field: Field,
    /// The options with each of its choices.
    options: Vec<Options>,
}

impl Agreement {
    /// What is agreed `now`, and its choices: the options with each, how it reads and what
    /// it is.
    fn new(
        now: Options,
        name: &'static str,
        choices: impl IntoIterator<Item = (Options, impl ToString, &'static str)>,
    ) -> Self {
        let choices: Vec<_> = choices.into_iter().collect();
        let at = choices.iter().position(|choice| choice.0 == now);
        let at = at.unwrap_or(0);
        let count = choices.len();
        let value = FieldValue::Choice { at, count };
        let chosen = choices.get(at);
        let shown = chosen.map_or(String::new(), |(_, shown, _)| shown.to_string());
        let about = chosen.map_or("", |(_, _, about)| about);
        let options = choices.iter().map(|choice| choice.0).collect();
        Self {
            field: Field::new(name, shown, value, about),
            options,
        }
    }
}

impl NewGame {
    /// Does what a key of the form stands for.
    pub(super) fn act(&mut self, action: FormAction) {
        self.form.act(action, &mut self.options);
    }

    /// Whether a click is on the board: then the game begins.
    pub(super) fn plays(&self, mouse: &Mouse, cx: &Context) -> bool {
        let board = SplitLayout::square(cx.room()).picture;
        mouse.kind == MouseKind::Down && board.contains(mouse.cell().into())
    }

    /// A click on a row selects it and changes it; the wheel goes through the rows.
    pub(super) fn mouse(&mut self, mouse: &Mouse, cx: &Context) -> Next {
        let row = ListView::row_at(SplitLayout::square(cx.room()).panel, mouse.cell());
        let outcome = self.form.mouse(mouse, row, &mut self.options);
        Next::after(outcome.is_used())
    }

    /// Draws the page: the pack on the board, and beside it what is agreed.
    pub(super) fn draw(&self, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        let layout = SplitLayout::square(cx.room());
        layout.draw(buf, &look, "the pack", "a new game");
        let coins = pack(self.options.set, Seat::South);
        picture::of_pack(&coins, self.options.set, layout.picture).draw(buf, &look);
        let mut lines = Lines::new(layout.panel, buf, look);
        written(&mut lines, |panel| {
            self.form.write(&self.options, panel);
            panel.gap();
            self.form.write_about(&self.options, panel);
        });
        lines.gap();
        lines.paragraph("Enter, or a click on the board: play!", Role::Key);
        lines.paragraph("s: saved games", Role::Key);
    }
}

/// What is to be agreed, in the order of the page.
fn agreements(now: Options) -> Vec<Agreement> {
    let rules = [
        (
            Rules::Tournament,
            "The Laws of Carrom: boards of up to 12 points, a game to 25 or eight boards, the best of three.",
        ),
        (
            Rules::Friendly,
            "As most families play: whoever clears first wins the board.",
        ),
        (
            Rules::Practice,
            "No turns and no dues: striker and coins anywhere, and every stroke can be taken back.",
        ),
    ];
    let rules = rules.map(|(rules, about)| (Options { rules, ..now }, <&str>::from(rules), about));
    let mut rows = vec![Agreement::new(now, "rules", rules)];
    if now.rules != Rules::Practice {
        let hands = [
            (Hands::Two, "two", "South against North."),
            (
                Hands::Four,
                "four",
                "Partners sit opposite: South and North against East and West.",
            ),
        ];
        let hands = hands.map(|(hands, shown, about)| (Options { hands, ..now }, shown, about));
        rows.push(Agreement::new(now, "hands", hands));
        rows.extend(now.seats().map(|seat| seated(seat, now)));
    }
    let sets = [
        (
            PieceSet::Tournament,
            "A heavy striker on light coins: it is turned aside by at most 21.5°, and they part at less than 90°.",
        ),
        (
            PieceSet::EqualMass,
            "Striker and coins weigh the same, so the two of a hit part at 90°.",
        ),
    ];
    let sets = sets.map(|(set, about)| (Options { set, ..now }, words::masses(set), about));
    rows.push(Agreement::new(now, "pieces", sets));
    rows.extend(SWITCHES.map(|(name, switch, about)| {
        let choice = |(on, shown)| {
            let mut options = now;
            *switch(&mut options) = on;
            (options, shown, about)
        };
        Agreement::new(now, name, [(false, "off"), (true, "on")].map(choice))
    }));
    rows
}

/// Who plays from a seat.
fn seated(seat: Seat, now: Options) -> Agreement {
    let mut person = now;
    person.set_player(seat, Player::Person);
    let shown = match person.count(Player::Person) {
        1 => "you",
        _ => "a person",
    };
    let about = "A person at this keyboard, or the computer in five strengths.";
    let mut choices = vec![(person, shown.to_owned(), about)];
    choices.extend(Strength::ALL.map(|strength| {
        let mut options = now;
        options.set_player(seat, Player::Computer);
        options.strengths[seat as usize] = strength;
        let about = "The computer: the stronger, the farther it looks and the steadier its hand is. It always says what it saw.";
        (options, format!("computer, {strength}"), about)
    }));
    // How strong a computer would be where a person sits makes no other game.
    if now.player(seat) == Player::Person {
        choices[0].0 = now;
    }
    Agreement::new(now, seat.into(), choices)
}

/// What is on or off: its name, where it stands, and what it is.
type Switch = (&'static str, fn(&mut Options) -> &mut bool, &'static str);

const SWITCHES: [Switch; 4] = [
    (
        "call it",
        |options| &mut options.call,
        "Before each stroke, say at which angles the two of the first hit leave it. Good calls earn points of their own.",
    ),
    (
        "aim line",
        |options| &mut options.aids.line,
        "The striker's path to the first coin it meets.",
    ),
    (
        "ghost",
        |options| &mut options.aids.ghost,
        "Where the striker will be when they meet.",
    ),
    (
        "departures",
        |options| &mut options.aids.rays,
        "Where both leave the first hit. While you call it they stay hidden.",
    ),
];

impl FormFields for Options {
    fn fields(&self) -> Vec<Field> {
        let rows = agreements(*self).into_iter();
        rows.map(|row| row.field).collect()
    }

    fn set(&mut self, at: usize, value: f64) {
        let row = agreements(*self).into_iter().nth(at);
        if let Some(options) = row.and_then(|row| row.options.get(value as usize).copied()) {
            *self = options;
        }
    }
}

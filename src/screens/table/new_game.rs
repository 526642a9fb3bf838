//! The page on which the options of a new game are chosen.

use std::borrow::Cow;

use strum::{EnumMessage, IntoStaticStr};

use super::options::Options;
use super::{TableAction, picture, words};
use crate::game::opponent::{PlayerHand, Strength};
use crate::game::pack::pack;
use crate::game::{Hands, Length, PieceSet, Player, Results, Rules, Seat, SeatNames, Team};
use crate::messages::{FileKind, Key, StoreAnswer, StoreReply, StoreRequest};
use crate::numbers::counted;
use crate::screens::{Context, View};
use crate::widgets::Role;
use crate::widgets::input::{Field, FieldValue, FormAction, FormFields, KeyTable, SettingsForm};
use crate::widgets::panel::Panel;

/// The page: the options chosen so far, and the form that changes them.
#[derive(Debug, Clone)]
pub(super) struct NewGame {
    pub(super) options: Options,
    pub(super) form: SettingsForm,
    /// The ticket of the request for the saved games.
    asked: u64,
    /// Whether the options of the player's last game may still replace the defaults.
    is_fresh: bool,
    results: Results,
    /// Why the game cannot begin.
    trouble: Option<String>,
}

/// One line of the page.
enum OptionRow {
    /// Its name and its choices.
    Choice(&'static str, Vec<Choice>),
    /// The name of the person at a seat.
    Name(Seat),
    Restitution,
}

/// A choice on a line: the options that result from it, its text and its description.
type Choice = (Options, String, Cow<'static, str>);

/// What the keys do on the new-game page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum NewGameAction {
    /// change the options of the game
    Agree(FormAction),
    /// play
    Play,
    /// open the board of the day
    Board,
    /// read the rules of the game
    Rules,
    /// saved games: resume one, or watch it again
    SavedGames,
    /// go back
    Back,
}

impl NewGame {
    /// Opens the page, and requests the saved games: they provide the player's results and, if
    /// `options` is `None`, the options to start from.
    pub(super) fn ask(options: Option<Options>, cx: &mut Context) -> Self {
        Self {
            is_fresh: options.is_none(),
            options: options.unwrap_or_default(),
            form: SettingsForm::default(),
            asked: cx.ask(StoreRequest::List(FileKind::Game)),
            results: Results::default(),
            trouble: None,
        }
    }

    /// Handles the list of saved games. Games that cannot be read are left out.
    pub(super) fn take_answer(&mut self, answer: &StoreAnswer, cx: &Context) {
        let StoreReply::Games(Ok(games)) = &answer.done else {
            return;
        };
        if answer.ticket != self.asked {
            return;
        }
        let player = &cx.settings.player;
        let games = games.iter().filter_map(|kept| kept.content.as_deref().ok());
        let own = || games.clone().filter(|(saved, _)| saved.player == *player);
        self.results = Results::of(player, own());
        let last = own().find(|(saved, _)| saved.record.setup.rules != Rules::Solo);
        // Options that the player has already changed are kept.
        if let Some((last, _)) = last
            && self.is_fresh
            && self.options == Options::default()
        {
            self.options = Options::of(last);
        }
        let (none, names) = (SeatNames::default(), &mut self.options.company.names);
        if *names == none
            && let Some((named, _)) = own().find(|(saved, _)| saved.company.names != none)
        {
            *names = named.company.names.clone();
        }
        self.is_fresh = false;
    }

    /// Writes what the player has won and lost.
    fn write_results(&self, panel: &mut Panel<TableAction>) {
        if self.results.rows.is_empty() {
            return;
        }
        panel.gap();
        for hand in PlayerHand::ALL {
            let rows = self.results.rows.iter();
            let mut rows = rows.filter(|row| row.hand == hand).peekable();
            if rows.peek().is_some() {
                let title = match hand {
                    PlayerHand::Exact => "your boards",
                    PlayerHand::Steady => "with a steady hand",
                    PlayerHand::Club => "with a club hand",
                };
                panel.pair((title, Role::Title), ("won : lost", Role::Dim));
            }
            for row in rows {
                let [won, lost] = row.boards;
                let name = format!("{}, {}", <&str>::from(row.rules), row.strength);
                panel.fact(name, format!("{won} : {lost}"));
                if row.rules == Rules::Tournament && row.games != [0; 2] {
                    let [won, lost] = row.games;
                    panel.fact("games", format!("{won} : {lost}"));
                }
            }
        }
        let longest = counted(self.results.longest_turn, "coin");
        panel.fact("longest turn", longest);
    }

    /// Carries out an action on the form.
    pub(super) fn agree(&mut self, action: FormAction) {
        self.trouble = None;
        self.form.act(action, &mut self.options);
    }

    /// Handles a key that edits a name; returns whether the key was used.
    pub(super) fn typed(&mut self, key: Key) -> bool {
        let typed = self.form.typed(key, &mut self.options);
        self.trouble = self.trouble.take().filter(|_| !typed);
        typed
    }

    /// The chosen options, if a game can begin with them.
    pub(super) fn chosen(&mut self) -> Option<Options> {
        self.form.commit(&mut self.options);
        self.options.company.names = self.options.company.names.tidied();
        let [first, second] = Team::BOTH.map(|team| self.options.team_name(team));
        if self.options.has_names() && first.to_lowercase() == second.to_lowercase() {
            self.trouble = Some(format!("Both players are called {first}."));
            return None;
        }
        Some(self.options.clone())
    }

    pub(super) fn keys(&self) -> KeyTable<NewGameAction> {
        let named = self.form.is_at_text(&self.options);
        KeyTable::new("table")
            .on(Key::Enter, NewGameAction::Play, "play")
            .when(!self.form.is_typing() && !named)
            .on('b', NewGameAction::Board, "board of the day")
            .when(!named)
            .on('r', NewGameAction::Rules, "rules")
            .when(!named)
            .on('s', NewGameAction::SavedGames, "saved games")
            .when(!named)
            .with(self.form.keys(&self.options), NewGameAction::Agree)
            .on(Key::Escape, NewGameAction::Back, "back")
            .when(!self.form.is_typing())
    }

    /// The pack on the board, and the options beside it.
    pub(super) fn view(&self) -> View<'_, TableAction> {
        let mut panel = Panel::new("a new game");
        panel.part(TableAction::NewGame, |panel| {
            panel.part(NewGameAction::Agree, |panel| {
                self.form.write(&self.options, panel);
                panel.gap();
                self.form.write_about(&self.options, panel);
            });
        });
        self.write_results(&mut panel);
        panel.pin_below();
        panel.warning(self.trouble.as_deref());
        panel.part(TableAction::NewGame, |panel| {
            if self.form.is_at_text(&self.options) {
                return panel.prompt("next", NewGameAction::Agree(FormAction::Next));
            }
            panel.prompts([
                match self.form.is_typing() {
                    true => ("set it", NewGameAction::Agree(SettingsForm::SET)),
                    false => ("play!", NewGameAction::Play),
                },
                ("board of the day", NewGameAction::Board),
            ]);
            panel.prompts([
                ("the rules", NewGameAction::Rules),
                ("saved games", NewGameAction::SavedGames),
            ]);
        });
        let set = self.options.setup.set;
        let board = move |area| picture::of_pack(&pack(set, Seat::South), set, area);
        View::drawn("the pack", board, panel).square()
    }
}

impl Options {
    /// A choice that changes these options.
    fn choice(
        &self,
        shown: impl Into<String>,
        about: impl Into<Cow<'static, str>>,
        change: impl FnOnce(&mut Self),
    ) -> Choice {
        (self.clone().with(change), shown.into(), about.into())
    }
}

/// The lines of the page, in order.
fn rows(now: &Options) -> Vec<OptionRow> {
    use OptionRow::{Choice, Name, Restitution};
    let rules = [
        (
            Rules::Tournament,
            "The Laws of Carrom: boards of up to 12 points, a game to 25 or eight boards, the best \
             of three.",
        ),
        (
            Rules::Friendly,
            "As most families play: the first to clear their coins wins the board.",
        ),
        (
            Rules::Points,
            "Either colour counts for both sides: black 1, white 2, the queen 5; the first to 17 wins.",
        ),
        (
            Rules::Practice,
            "No turns, no penalties: place the striker and coins anywhere; take back any stroke.",
        ),
    ];
    let rules = rules
        .map(|(rules, about)| now.choice(<&str>::from(rules), about, |it| it.setup.rules = rules));
    let mut rows = vec![Choice("rules", rules.into())];
    if now.setup.rules != Rules::Practice {
        let hands = [
            (Hands::Two, "two", "South against North."),
            (
                Hands::Four,
                "four",
                "Partners sit opposite each other: South and North against East and West.",
            ),
        ];
        let hands = hands
            .map(|(hands, shown, about)| now.choice(shown, about, |it| it.setup.hands = hands));
        rows.push(Choice("hands", hands.into()));
        rows.extend({ now.seats() }.map(|seat| Choice(seat.into(), players(seat, now))));
        rows.extend(now.seats().filter(|_| now.has_names()).map(Name));
        let hands = PlayerHand::ALL.map(|hand| of_hand(hand, now));
        match now.count(Player::Person) {
            0 => {}
            1 => rows.push(Choice("your hand", hands.into())),
            _ => rows.push(Choice("your hands", hands.into())),
        }
        rows.push(Choice("length", lengths(now)));
    }
    let sets = [
        (
            PieceSet::Tournament,
            "A heavy striker on light coins: the paths are less than 90° apart; at e = 1 the striker is \
             deflected by at most 21.5°.",
        ),
        (
            PieceSet::EqualMass,
            "Striker and coins have equal masses, so the paths are 90° apart if e = 1.",
        ),
    ];
    let sets =
        sets.map(|(set, about)| now.choice(words::masses(set), about, |it| it.setup.set = set));
    rows.push(Choice("pieces", sets.into()));
    rows.push(Restitution);
    rows.extend(SWITCHES.map(|(name, switch, about)| {
        let choice = |(on, shown)| now.choice(shown, about, |it| *switch(it) = on);
        Choice(name, [(false, "off"), (true, "on")].map(choice).into())
    }));
    rows
}

/// The players that can be chosen for a seat.
fn players(seat: Seat, now: &Options) -> Vec<Choice> {
    let mut person = now.clone();
    person.company.players[seat as usize] = Player::Person;
    let shown = match person.count(Player::Person) {
        1 => "you",
        _ => "a person",
    };
    let about = "A person at this keyboard, or the computer at one of five strengths.";
    let mut choices = vec![(person, shown.to_owned(), about.into())];
    choices.extend(Strength::ALL.map(|strength| {
        let about = "The stronger the computer, the farther it looks ahead and the steadier its \
                     hand. It always explains its stroke.";
        now.choice(format!("computer, {strength}"), about, |options| {
            options.company.players[seat as usize] = Player::Computer;
            options.company.strengths[seat as usize] = strength;
        })
    }));
    choices
}

/// The choice of this steadiness for the hands of all people who play. Its description gives the
/// size of the errors.
fn of_hand(hand: PlayerHand, now: &Options) -> Choice {
    let about: Cow<'static, str> = match hand.errors() {
        None => "Every stroke is played exactly as you aim it.".into(),
        Some(errors) => {
            let [degrees, percent] = errors.in_figures();
            let whose = match hand {
                PlayerHand::Club => "a club player",
                _ => "an expert",
            };
            format!("Like {whose}'s: within {degrees}° and {percent} % in 2 of 3 strokes.").into()
        }
    };
    now.choice(<&str>::from(hand), about, |it| it.company.hand = hand)
}

/// The lengths of a game, with an estimate in minutes. Only under tournament rules can a game
/// consist of several boards.
fn lengths(now: &Options) -> Vec<Choice> {
    let lengths = [Length::Board, Length::Game, Length::Match].into_iter();
    let offered = lengths.filter(|it| now.setup.rules == Rules::Tournament || *it != Length::Game);
    let choice = |length| {
        let options = now.clone().with(|it| it.setup.length = length);
        let (name, last) = match (length, now.setup.rules) {
            (Length::Board, _) => ("one board", "One board."),
            (Length::Game, _) => ("one game", "A game to 25 points or eight boards."),
            (Length::Match, Rules::Tournament) => ("match", "The best of three games."),
            (Length::Match, _) => ("open", "One board after another, until you stop."),
        };
        let minutes = options.minutes().unwrap_or(0);
        let each = match (length, now.setup.rules) {
            (Length::Match, Rules::Friendly | Rules::Points) => " a board",
            _ => "",
        };
        let about = format!("{last} About {minutes} min{each} between equals, at 15 s a stroke.");
        let shown = format!("{name}, about {minutes} min{each}");
        (options, shown, about.into())
    };
    offered.map(choice).collect()
}

/// An option that is on or off: its name, its field in the options, and its description.
type Switch = (&'static str, fn(&mut Options) -> &mut bool, &'static str);

const SWITCHES: [Switch; 4] = [
    (
        "call it",
        |options| &mut options.company.call,
        "Before each stroke, predict both directions after the first collision. Good calls earn \
         separate points.",
    ),
    (
        "aim line",
        |options| &mut options.company.aids.line,
        "The striker's path to the first coin it meets.",
    ),
    (
        "ghost",
        |options| &mut options.company.aids.ghost,
        "The striker's position at contact.",
    ),
    (
        "departures",
        |options| &mut options.company.aids.rays,
        "Both paths after the first collision. They are hidden while you call.",
    ),
];

impl FormFields for Options {
    fn fields(&self) -> Vec<Field> {
        let field = |row| match row {
            OptionRow::Choice(name, choices) => {
                let at = choices.iter().position(|(options, ..)| options == self);
                let (at, count) = (at.unwrap_or(0), choices.len());
                let chosen = choices.into_iter().nth(at);
                let (shown, about) = chosen.map_or_else(Default::default, |it| (it.1, it.2));
                Field::new(name, (FieldValue::Choice { at, count }, shown), about)
            }
            OptionRow::Name(seat) => Field::new(
                format!("{}'s name", <&str>::from(seat)),
                (
                    FieldValue::Text(SeatNames::LONGEST),
                    self.company.names.of(seat).to_owned(),
                ),
                "Type a name, or leave it empty. The score and the saved game show it.",
            ),
            OptionRow::Restitution => Field::new(
                "restitution e",
                FieldValue::decimal(self.setup.restitution, (0.0, 1.0), 0.05, (2, "")),
                "At e = 1 two discs lose no kinetic energy; real discs lose some. At a cushion e is \
                 always 0.8.",
            ),
        };
        rows(self).into_iter().map(field).collect()
    }

    fn set(&mut self, at: usize, value: f64) {
        match rows(self).into_iter().nth(at) {
            Some(OptionRow::Restitution) => {
                self.setup.restitution = value.clamp(0.0, 1.0) + 0.0;
            }
            Some(OptionRow::Choice(_, choices)) => {
                if let Some((options, ..)) = choices.into_iter().nth(value as usize) {
                    *self = options;
                }
            }
            Some(OptionRow::Name(_)) | None => {}
        }
    }

    fn set_text(&mut self, at: usize, text: &str) {
        if let Some(OptionRow::Name(seat)) = rows(self).into_iter().nth(at) {
            self.company.names.set(seat, text);
        }
    }
}

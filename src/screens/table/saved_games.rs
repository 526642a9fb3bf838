//! The page of saved games, on which the player can resume, watch, export or delete one.

use strum::{EnumMessage, IntoStaticStr};

use super::active_game::{ActiveGame, Playing};
use super::options::Options;
use super::{TableAction, picture, words};
use crate::game::opponent::PlayerHand;
use crate::game::{ByTeam, Game, GameStage, Rules, SavedGame, Team};
use crate::messages::{
    FileContent, FileKind, KeptGame, Key, StoreAnswer, StoreReply, StoreRequest,
};
use crate::numbers::{capital, counted};
use crate::screens::kept_files::{KeptAction, KeptFiles, KeptKind};
use crate::screens::{Context, Next, View};
use crate::widgets::Role;
use crate::widgets::input::{KeyTable, ListAction};
use crate::widgets::panel::Panel;

const GAMES: KeptKind = KeptKind {
    file: FileKind::Game,
    one: "game",
    all: "saved games",
    saved: "carrom saves every game after each stroke.",
};

#[derive(Debug, Clone)]
pub(super) struct SavedGames {
    /// The options of the previous page, for going back.
    pub(super) options: Options,
    pub(super) files: KeptFiles<(SavedGame, Game)>,
    /// The ticket of a game that will be replayed from its beginning.
    watch: Option<u64>,
}

/// What the keys do on the page of saved games.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum SavedGamesAction {
    /// choose a saved game, then resume or remove it
    Saved(KeptAction),
    /// watch the whole game again, stroke by stroke
    WatchAll,
    /// export: write the game to a separate file
    Export,
    /// go back
    Back,
}

impl SavedGames {
    /// Opens the page, and requests the saved games; `options` are those of the previous page.
    pub(super) fn ask(options: Options, cx: &mut Context) -> Self {
        Self {
            options,
            files: KeptFiles::ask(GAMES, cx),
            watch: None,
        }
    }

    pub(super) fn keys(&self) -> KeyTable<SavedGamesAction> {
        use SavedGamesAction::{Back, Export, Saved, WatchAll};
        let open = self.files.content().is_some();
        KeyTable::new("table")
            .with(self.files.keys("resume"), Saved)
            .on('v', WatchAll, "replay")
            .when(open)
            .on('e', Export, "export")
            .when(open)
            .on(Key::Escape, Back, "back")
    }

    pub(super) fn act(&mut self, action: SavedGamesAction, cx: &mut Context) -> Next {
        match action {
            SavedGamesAction::Saved(action) => return self.files.act(action, cx),
            SavedGamesAction::WatchAll => self.watch = self.files.load(cx),
            SavedGamesAction::Export => {
                if let Some((saved, _)) = self.files.content() {
                    let saved = FileContent::Game(Box::new(saved.clone()));
                    cx.ask(StoreRequest::Export(saved));
                }
            }
            SavedGamesAction::Back => return Next::Back,
        }
        Next::Stay
    }

    /// Handles the results of requests; returns the game to resume, if there is one.
    pub(super) fn take_answer(
        &mut self,
        answer: &StoreAnswer,
        cx: &mut Context,
    ) -> Option<Box<Playing>> {
        match &answer.done {
            StoreReply::Games(games) => self.files.listed(games.clone()),
            StoreReply::Game(loaded) if self.files.take_loaded(answer.ticket) => {
                let active = loaded.clone().and_then(|saved| {
                    let active = ActiveGame::resume_saved(&saved, answer.ticket);
                    active.map_err(|error| error.to_string())
                });
                match active.map(Playing::from) {
                    Ok(mut playing) => {
                        if self.watch == Some(answer.ticket) {
                            playing.watch_all(cx);
                        }
                        return Some(Box::new(playing));
                    }
                    Err(reason) => {
                        self.files.notice = Some(format!("The game cannot be resumed: {reason}."));
                    }
                }
            }
            StoreReply::Removed(result) => self.files.removed(result, cx),
            StoreReply::Exported(result) => self.files.notice = Some(words::exported(result)),
            _ => {}
        }
        None
    }

    /// The board of the chosen game, with the list beside it.
    pub(super) fn view(&self) -> View<'_, TableAction> {
        let mut panel = Panel::new("saved games");
        panel.part(
            |action| TableAction::Saved(SavedGamesAction::Saved(action)),
            |panel| self.files.write_list(title, panel),
        );
        panel.pin_below();
        panel.part(TableAction::Saved, |panel| {
            self.files.write_chosen(panel, |(saved, game), panel| {
                panel.paragraph(about(saved, game), Role::Text);
                panel.gap();
                let resume = KeptAction::List(ListAction::Open);
                panel.prompts([
                    ("resume it", SavedGamesAction::Saved(resume)),
                    ("watch it from its start", SavedGamesAction::WatchAll),
                ]);
            });
        });
        let (coins, set) = match self.files.content() {
            Some((_, game)) => (game.coins(), game.setup().set),
            None => (&[][..], self.options.setup.set),
        };
        let name = self.files.chosen().map_or("", |kept| kept.name.as_str());
        let board = move |area| picture::of_pack(coins, set, area);
        View::drawn(name, board, panel).square()
    }
}

/// The title of a game: the players and the score.
fn title(kept: &KeptGame) -> String {
    let Ok(game) = &kept.content else {
        return format!("{} ?", kept.name);
    };
    let (saved, game) = &**game;
    let options = Options::of(saved);
    match options.setup.rules {
        Rules::Practice => "practice".into(),
        Rules::Solo => words::solo_title(game),
        Rules::Tournament if game.score().games != ByTeam::default() => {
            let games = words::versus(|team| game.score().games[team]);
            format!("{} ({games})", options.score(game))
        }
        _ => options.score(game),
    }
}

/// Further facts about a game.
fn about(saved: &SavedGame, game: &Game) -> String {
    let options = Options::of(saved);
    let strokes = counted(saved.record.strokes(), "stroke");
    let (board, games) = match options.setup.rules {
        Rules::Tournament => {
            let games = words::versus(|team| game.score().games[team]);
            let board = game.board_number();
            (format!(", board {board}"), format!(", games won {games}"))
        }
        _ => Default::default(),
    };
    let rules = match options.setup.rules {
        Rules::Solo => capital(&words::solo_title(game)),
        rules => capital(rules.into()),
    };
    let hand = match options.company.hand {
        PlayerHand::Exact => String::new(),
        hand => format!(", {} hand", <&str>::from(hand)),
    };
    let stands = match game.stage() {
        GameStage::MatchOver(Team::First) if options.setup.rules == Rules::Solo => {
            " Cleared.".into()
        }
        _ if options.setup.rules.is_alone() => String::new(),
        GameStage::Playing => match options.seat_name(game.seat()) {
            "you" => " It is your turn.".into(),
            name => format!(" It is {}'s turn.", words::player(name)),
        },
        GameStage::BoardOver(won) => {
            let winner = words::player(options.team_name(won.winner));
            format!(" The board went to {winner}.")
        }
        GameStage::GameOver(team) => format!(" {}.", options.wins(team, "game")),
        GameStage::MatchOver(team) => format!(" {}.", options.wins(team, options.whole())),
    };
    let whose = match saved.player.as_str() {
        // A player without a name is saved as "player".
        "player" => String::new(),
        name => format!("{name}'s game. "),
    };
    format!("{whose}{rules}{hand}{board}, {strokes}{games}.{stands}")
}

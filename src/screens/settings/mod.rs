//! The settings: appearance, motion, the player, and where the data is kept.

mod field;
mod kept;
mod values;

pub use kept::KeptSettings;
pub use values::Settings;

use strum::{EnumMessage, IntoStaticStr};

use super::{Confirmation, Context, Next, Route, Screen, View};
use crate::files::tidy_name;
use crate::game::is_player_name;
use crate::messages::{Input, Key, KnownPlayer, StoreReply, StoreRequest};
use crate::progress::long_day;
use crate::widgets::input::{
    FormAction, FormFields, KeyTable, ListAction, ListView, SettingsForm, TextField,
};
use crate::widgets::panel::Panel;
use crate::widgets::{Outcome, Role};
use field::PLAYER;

/// The largest number of characters in a name.
const LONGEST: usize = 40;

#[derive(Debug, Clone, Default)]
pub(crate) struct SettingsScreen {
    form: SettingsForm,
    /// The players who have a record in this data folder.
    players: Vec<KnownPlayer>,
    /// The list of players, while one is being chosen.
    choosing: Option<ListView>,
    /// The name of a new player while it is being typed.
    typed: Option<TextField>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum SettingsAction {
    /// choose a setting and change it
    Set(FormAction),
    /// go to the next value or, for the player, open the list of players
    Enter,
    /// choose a player, or add one
    Players(ListAction),
    /// use the typed name; carrom asks before it adds a new player
    Take,
    /// go back; discard a name that is being typed
    Back,
}

impl SettingsScreen {
    /// Whether the row of the player's name is chosen.
    fn is_at_player(&self, cx: &Context) -> bool {
        self.form.selected(cx.settings.fields().len()) == PLAYER
    }

    /// Requests the players.
    pub(crate) fn ask(cx: &mut Context) -> Self {
        cx.ask(StoreRequest::Players);
        Self::default()
    }

    /// Opens the list of players (or, if it is empty, the field for a new name), or goes to a
    /// setting's next value.
    fn enter(&mut self, cx: &mut Context) {
        if !self.is_at_player(cx) {
            self.form.act(FormAction::Step(1), &mut cx.settings);
        } else if self.players.is_empty() {
            self.typed = Some(TextField::new("", LONGEST));
        } else {
            let present = |it: &KnownPlayer| it.name == cx.settings.player;
            let at = self.players.iter().position(present);
            self.choosing = Some(ListView::at(at.unwrap_or(0)));
        }
    }

    /// Switches to the chosen player; the line after the last player is for a new one.
    fn choose(&mut self, action: ListAction, cx: &mut Context) -> Next {
        let Some(list) = &mut self.choosing else {
            return Next::Ignored;
        };
        let outcome = list.act(action, self.players.len() + 1);
        if let Outcome::Done(at) = outcome {
            match self.players.get(at) {
                Some(player) => self.change_to(player.name.clone(), cx),
                None => self.typed = Some(TextField::new("", LONGEST)),
            }
        }
        Next::after(outcome.is_used())
    }

    fn change_to(&mut self, name: String, cx: &mut Context) {
        (self.choosing, self.typed) = (None, None);
        cx.change_player(name);
        cx.ask(StoreRequest::Players);
    }

    /// Uses the typed name, if it is valid. A new name has to be confirmed, so that a typing error
    /// does not begin a new record.
    fn take(&mut self, cx: &mut Context) -> Next {
        let Some(typed) = &self.typed else {
            return Next::Stay;
        };
        let name = tidy_name(typed.text());
        if !is_player_name(&name) {
            if !typed.text().is_empty() {
                cx.notify("A name has 1 to 40 visible characters.".into());
            }
            self.typed = None;
            return Next::Stay;
        }
        if name == cx.settings.player || self.players.iter().any(|it| it.name == name) {
            self.change_to(name, cx);
            return Next::Stay;
        }
        let is_like = |it: &&KnownPlayer| it.name.to_lowercase() == name.to_lowercase();
        let like = match self.players.iter().find(is_like) {
            Some(it) => format!(" There is already a player called {}.", it.name),
            None => String::new(),
        };
        let text = format!("Begin a new record for {name}?{like}");
        Next::Confirm(Confirmation::new(text, "begin", "go back"))
    }
}

impl Screen for SettingsScreen {
    type Action = SettingsAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "settings";
    const ROUTE: Route = Route::Settings;

    fn keys(&self, cx: &Context) -> KeyTable<SettingsAction> {
        use SettingsAction::{Back, Enter, Players, Set, Take};
        let keys = KeyTable::new("settings");
        if self.typed.is_some() {
            return keys
                .on(Key::Enter, Take, "use it")
                .on(Key::Escape, Back, "cancel");
        }
        if self.choosing.is_some() {
            return keys
                .with(ListView::keys("choose"), Players)
                .on(Key::Escape, Back, "cancel");
        }
        let enter = match self.is_at_player(cx) {
            true => "players",
            false => "next value",
        };
        keys.on(Key::Enter, Enter, enter)
            .with(self.form.keys(&cx.settings), Set)
            .on(Key::Escape, Back, "back")
            .distinct()
    }

    fn typed(&mut self, key: Key, _cx: &mut Context) -> bool {
        let typed = self.typed.as_mut();
        typed.is_some_and(|typed| !matches!(key, Key::Char('?')) && typed.update(key))
    }

    fn act(&mut self, action: SettingsAction, cx: &mut Context) -> Next {
        match action {
            // A click elsewhere ends the choice of a player.
            SettingsAction::Set(action) => {
                (self.choosing, self.typed) = (None, None);
                self.form.act(action, &mut cx.settings);
            }
            SettingsAction::Enter => self.enter(cx),
            SettingsAction::Players(action) => return self.choose(action, cx),
            SettingsAction::Take => return self.take(cx),
            SettingsAction::Back if self.typed.is_some() => self.typed = None,
            SettingsAction::Back if self.choosing.is_some() => self.choosing = None,
            SettingsAction::Back => return Next::Back,
        }
        Next::Stay
    }

    fn confirmed(&mut self, _action: SettingsAction, cx: &mut Context) -> Next {
        if let Some(typed) = &self.typed {
            self.change_to(tidy_name(typed.text()), cx);
        }
        Next::Stay
    }

    fn input(&mut self, input: &Input, _cx: &mut Context) -> Next {
        match (input, &mut self.typed) {
            (Input::Paste(text), Some(typed)) => typed.paste(text.trim()),
            (Input::Kept(answer), _) => {
                if let StoreReply::Players(Ok(players)) = &answer.done {
                    self.players.clone_from(players);
                }
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        if self.choosing.is_some() {
            return self.choose(ListAction::Choose(by.into()), cx);
        }
        if self.typed.is_none() {
            self.form
                .act(FormAction::Choose(by.into()), &mut cx.settings);
        }
        Next::Stay
    }

    /// The settings, and a description of the chosen one.
    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, SettingsAction> {
        let mut form = Panel::new("settings");
        form.part(SettingsAction::Set, |panel| {
            self.form.write(&cx.settings, panel);
        });
        if let Some(list) = &self.choosing {
            form.gap();
            form.heading("Players");
            let chosen = list.chosen(self.players.len() + 1);
            let days = self.players.iter().map(|it| {
                let last = it.last.map(long_day).unwrap_or_default();
                (it.name.as_str(), last)
            });
            let lines = days.chain([("someone new", String::new())]);
            for (at, (name, last)) in lines.enumerate() {
                let action = SettingsAction::Players(ListAction::Point(at));
                let name = (name.to_owned(), Role::Text);
                form.row(name, (last, Role::Dim), at == chosen, action);
            }
        }
        if let Some(typed) = &self.typed {
            form.gap();
            form.text_field("name", typed.around_cursor(), true, None);
        }
        let mut about = Panel::new("this setting");
        self.form.write_about(&cx.settings, &mut about);
        about.gap();
        let choose = SettingsAction::Players(ListAction::Open);
        match (&self.typed, self.is_at_player(cx)) {
            (Some(_), _) => about.prompt("use it", SettingsAction::Take),
            (None, true) if self.choosing.is_some() => about.prompt("choose", choose),
            (None, true) => about.prompt("players", SettingsAction::Enter),
            (None, false) => about.prompt("next value", SettingsAction::Enter),
        }
        about.gap();
        about.heading("Where your data is kept");
        match &cx.folder {
            Some(folder) => about.paragraph(folder, Role::Text),
            None => about.paragraph("Nowhere: it is lost when carrom ends.", Role::Text),
        }
        about.paragraph(
            "Answers, bookmarks, games and these settings are kept there and nowhere else.",
            Role::Dim,
        );
        about.worth(1, |about| {
            about.gap();
            about.paragraph("The help explains how to change keys.", Role::Dim);
        });
        View::panels(form, about)
    }
}

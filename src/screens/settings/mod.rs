//! The settings: appearance, motion, the player, and where the data is kept.

mod field;
mod kept;
mod values;

pub use kept::KeptSettings;
pub use values::Settings;

use strum::{EnumMessage, IntoStaticStr};

use super::{Context, Next, Route, Screen, View};
use crate::files::tidy_name;
use crate::game::is_player_name;
use crate::messages::{Input, Key};
use crate::widgets::Role;
use crate::widgets::input::{FormAction, FormFields, KeyTable, SettingsForm, TextField};
use crate::widgets::panel::Panel;
use field::PLAYER;

/// The largest number of characters of a name.
const LONGEST: usize = 40;

#[derive(Debug, Clone, Default)]
pub(crate) struct SettingsScreen {
    form: SettingsForm,
    /// The player's name while it is being typed.
    typed: Option<TextField>,
}

/// Actions of the settings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum SettingsAction {
    /// choose a setting and change it
    Set(FormAction),
    /// go to the next value, or type the player's name
    Enter,
    /// use the typed name
    Take,
    /// go back; discard a name that is being typed
    Back,
}

impl SettingsScreen {
    /// Whether the row of the player's name is chosen.
    fn is_at_player(&self, cx: &Context) -> bool {
        self.form.selected(cx.settings.fields().len()) == PLAYER
    }

    /// Starts typing the player's name, or goes to a setting's next value.
    fn enter(&mut self, cx: &mut Context) {
        if self.is_at_player(cx) {
            self.typed = Some(TextField::new("", LONGEST));
        } else {
            self.form.act(FormAction::Step(1), &mut cx.settings);
        }
    }

    /// Uses the typed name, if it is valid.
    fn take(&mut self, cx: &mut Context) {
        let Some(typed) = self.typed.take() else {
            return;
        };
        let name = tidy_name(typed.text());
        if is_player_name(&name) {
            cx.change_player(name);
        } else if !typed.text().is_empty() {
            cx.notify("A name has 1 to 40 visible characters.".into());
        }
    }
}

impl Screen for SettingsScreen {
    type Action = SettingsAction;

    fn title(&self) -> String {
        "settings".into()
    }

    fn route(&self, _cx: &Context) -> Route {
        Route::Settings
    }

    fn keys(&self, cx: &Context) -> KeyTable<SettingsAction> {
        use SettingsAction::{Back, Enter, Set, Take};
        let keys = KeyTable::new("settings");
        if self.typed.is_some() {
            return keys
                .on(Key::Enter, Take, "use it")
                .on(Key::Escape, Back, "cancel");
        }
        let enter = match self.is_at_player(cx) {
            true => "type a name",
            false => "next value",
        };
        keys.on(Key::Enter, Enter, enter)
            .with(self.form.keys(&cx.settings), Set)
            .on(Key::Escape, Back, "back")
            .distinct()
    }

    fn about(&self, _cx: &Context) -> Vec<&'static str> {
        include_str!("help.txt").lines().collect()
    }

    fn typed(&mut self, key: Key, _cx: &mut Context) -> bool {
        let typed = self.typed.as_mut();
        typed.is_some_and(|typed| !matches!(key, Key::Char('?')) && typed.update(key))
    }

    fn act(&mut self, action: SettingsAction, cx: &mut Context) -> Next {
        match action {
            // A click elsewhere accepts the typed name.
            SettingsAction::Set(action) => {
                self.take(cx);
                self.form.act(action, &mut cx.settings);
            }
            SettingsAction::Enter => self.enter(cx),
            SettingsAction::Take => self.take(cx),
            SettingsAction::Back if self.typed.is_some() => self.typed = None,
            SettingsAction::Back => return Next::Back,
        }
        Next::Stay
    }

    fn input(&mut self, input: &Input, _cx: &mut Context) -> Next {
        match (input, &mut self.typed) {
            (Input::Paste(text), Some(typed)) => typed.paste(text.trim()),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        if self.typed.is_none() {
            self.form
                .act(FormAction::Choose(by.into()), &mut cx.settings);
        }
        Next::Stay
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, SettingsAction> {
        view(self, cx)
    }
}

/// The settings, and a description of the chosen one.
fn view<'s>(screen: &SettingsScreen, cx: &Context) -> View<'s, SettingsAction> {
    let mut form = Panel::new("settings");
    form.part(SettingsAction::Set, |panel| {
        screen.form.write(&cx.settings, panel);
    });
    if let Some(typed) = &screen.typed {
        form.gap();
        form.text_field("name", typed.around_cursor(), true, None);
    }
    let mut about = Panel::new("this setting");
    screen.form.write_about(&cx.settings, &mut about);
    about.gap();
    match (&screen.typed, screen.is_at_player(cx)) {
        (Some(_), _) => about.prompt("use it", SettingsAction::Take),
        (None, true) => about.prompt("type a name", SettingsAction::Enter),
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

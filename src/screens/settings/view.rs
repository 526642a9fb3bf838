//! The view of the settings.

use super::{SettingsAction, SettingsScreen};
use crate::screens::{Context, View};
use crate::widgets::Role;
use crate::widgets::panel::Panel;

/// The settings, and a description of the chosen one.
pub(super) fn view<'s>(screen: &SettingsScreen, cx: &'s Context) -> View<'s, SettingsAction> {
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

//! A measured collision: its picture, and everything that follows from it.

use std::sync::Arc;

use strum::{EnumMessage, IntoStaticStr};

use super::{Context, Next, Route, Screen, SharedAction, View};
use crate::measure::Measurement;
use crate::messages::Key;
use crate::numbers::capital;
use crate::widgets::input::KeyTable;
use crate::widgets::panel::Panel;
use crate::widgets::text::sheet;
use crate::widgets::{Role, measured_picture, measured_words};

/// The key actions on the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum MeasuredAction {
    /// scroll the results
    Scroll(i16),
    /// go back
    Leave,
}

/// The screen of a measured collision.
#[derive(Debug, Clone)]
pub(crate) struct MeasuredScreen {
    pub(crate) measurement: Arc<Measurement>,
}

impl Screen for MeasuredScreen {
    type Action = MeasuredAction;

    const HELP: &'static str = include_str!("help.txt");

    fn title(&self) -> String {
        "a measured collision".into()
    }

    fn route(&self, _cx: &Context) -> Route {
        Route::Measured {
            measurement: Arc::clone(&self.measurement),
        }
    }

    fn keys(&self, _cx: &Context) -> KeyTable<MeasuredAction> {
        use MeasuredAction::{Leave, Scroll};
        KeyTable::new("measured")
            .each([(Key::Up, Scroll(-1)), (Key::Down, Scroll(1))], "scroll")
            .on(Key::Escape, Leave, "back")
    }

    fn act(&mut self, action: MeasuredAction, _cx: &mut Context) -> Next {
        match action {
            MeasuredAction::Scroll(rows) => Next::Shared(SharedAction::Scroll(rows)),
            MeasuredAction::Leave => Next::Back,
        }
    }

    fn view<'s>(&'s self, _cx: &'s Context) -> View<'s, MeasuredAction> {
        let mut panel = Panel::new("what it shows");
        panel.from_top = true;
        for sentence in self.measurement.sentences() {
            panel.item(sentence, Role::Text);
        }
        for warning in self.measurement.warnings() {
            panel.item(warning, Role::Warn);
        }
        for section in self.measurement.sections() {
            panel.gap();
            panel.heading(section.title);
            for row in section.rows {
                panel.item(format!("{}: {}", capital(&row.name), row.text), Role::Text);
            }
        }
        let picture = |area| {
            sheet::next_picture_shows(|| vec![measured_words(&self.measurement)]);
            measured_picture(area, &self.measurement)
        };
        View::drawn("points, fit and prediction", picture, panel)
    }
}

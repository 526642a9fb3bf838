//! A measured collision: its picture, and everything that follows from it.

mod settings;
mod view;

use std::sync::Arc;

use strum::{EnumMessage, IntoStaticStr};

use super::{Context, Next, Route, Screen, View};
use crate::measure::Measurement;
use crate::messages::{Input, Key};
use crate::paper::measured_html;
use crate::widgets::input::{FormAction, KeyTable, SettingsForm};

use settings::MeasuredSettings;

/// The name of the exported report.
const FILE: &str = "measured-collision.html";

/// What the keys do on the screen of a measured collision.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum MeasuredAction {
    /// scroll the results
    Scroll(i16),
    /// show every result with its uncertainty
    Everything,
    /// set the masses, the radii, the scale and the value of e for the prediction
    Settings,
    /// change the settings
    Set(FormAction),
    /// write a report with the picture and all results, to print or to hand in
    Export,
    /// go back to the conclusion
    Back,
    /// go back
    Leave,
}

/// What the panel shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum MeasuredPage {
    /// The conclusion and the main numbers.
    Summary,
    /// Every result.
    Everything,
    /// The settings and the conclusion.
    Settings,
}

/// The screen of a measured collision.
#[derive(Debug, Clone)]
pub(crate) struct MeasuredScreen {
    measurement: Arc<Measurement>,
    shown: MeasuredPage,
    form: SettingsForm,
    settings: MeasuredSettings,
    /// Why the tracks cannot be measured with the current settings; the previous results are
    /// then kept.
    fault: Option<String>,
}

impl MeasuredScreen {
    pub(crate) fn new(measurement: Arc<Measurement>) -> Self {
        Self {
            settings: MeasuredSettings::new(&measurement.given),
            measurement,
            shown: MeasuredPage::Summary,
            form: SettingsForm::default(),
            fault: None,
        }
    }

    /// Changes the settings, and measures again if they have changed.
    fn edit(&mut self, change: impl FnOnce(&mut SettingsForm, &mut MeasuredSettings)) {
        change(&mut self.form, &mut self.settings);
        let given = self.settings.given(&self.measurement.given);
        if given == self.measurement.given {
            self.fault = None;
            return;
        }
        match self.measurement.again(given) {
            Ok(measurement) => {
                self.measurement = Arc::new(measurement);
                self.fault = None;
            }
            Err(fault) => self.fault = Some(fault.to_string()),
        }
    }
}

impl Screen for MeasuredScreen {
    type Action = MeasuredAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "a measured collision";

    fn route(&self, _cx: &Context) -> Route {
        Route::Measured(Arc::clone(&self.measurement))
    }

    fn keys(&self, _cx: &Context) -> KeyTable<MeasuredAction> {
        use MeasuredAction::{Back, Everything, Export, Leave, Scroll, Set, Settings};
        let table = KeyTable::new("measured");
        if self.shown == MeasuredPage::Settings {
            let typing = self.form.is_typing();
            return table
                .with(self.form.keys(&self.settings), Set)
                .or((!typing).then_some((Key::Enter, Back)))
                .on(Key::Escape, Back, "done");
        }
        let is_summary = self.shown == MeasuredPage::Summary;
        table
            .each([(Key::Up, Scroll(-1)), (Key::Down, Scroll(1))], "scroll")
            .on('a', Everything, "all results")
            .when(is_summary)
            .on('m', Settings, "settings")
            .on('e', Export, "report")
            .on(Key::Escape, Back, "conclusion")
            .when(!is_summary)
            .on(Key::Escape, Leave, "back")
            .when(is_summary)
    }

    fn act(&mut self, action: MeasuredAction, cx: &mut Context) -> Next {
        match action {
            MeasuredAction::Scroll(rows) => return Next::scroll(rows),
            MeasuredAction::Everything => self.shown = MeasuredPage::Everything,
            MeasuredAction::Settings => self.shown = MeasuredPage::Settings,
            MeasuredAction::Set(action) => self.edit(|form, settings| form.act(action, settings)),
            MeasuredAction::Export => {
                let bodies = self.measurement.names().map(str::to_owned);
                cx.export(FILE.into(), measured_html(&self.measurement, &bodies));
            }
            MeasuredAction::Back => {
                self.edit(|form, settings| form.commit(settings));
                self.shown = MeasuredPage::Summary;
            }
            MeasuredAction::Leave => return Next::Back,
        }
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        if let Input::Exported(exported) = input {
            cx.notify_of_export("report", exported);
        }
        Next::Stay
    }

    fn view<'s>(&'s self, _cx: &'s Context) -> View<'s, MeasuredAction> {
        view::view(self)
    }
}

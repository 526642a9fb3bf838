//! The view of a measured collision: the conclusion and the main numbers, every result, or the
//! settings.

use super::{MeasuredAction, MeasuredPage, MeasuredScreen};
use crate::screens::View;
use crate::widgets::input::SettingsForm;
use crate::widgets::panel::Panel;
use crate::widgets::text::sheet;
use crate::widgets::{Role, measured_picture, measured_words};

/// The main numbers: the name of each, short enough for a narrow panel, and its id.
const MAIN: [(&str, &str); 6] = [
    ("u₁", "u1"),
    ("v₁", "v1"),
    ("v₂", "v2"),
    ("e", "restitution"),
    ("angle", "between"),
    ("E kept", "energy_kept"),
];

pub(super) fn view(screen: &MeasuredScreen) -> View<'_, MeasuredAction> {
    let panel = match screen.shown {
        MeasuredPage::Summary => summary(screen),
        MeasuredPage::Everything => everything(screen),
        MeasuredPage::Settings => settings(screen),
    };
    let picture = |area| {
        sheet::next_picture_shows(|| vec![measured_words(&screen.measurement)]);
        measured_picture(area, &screen.measurement)
    };
    View::drawn("points, fit and prediction", picture, panel)
}

/// Removes the options of the command line, which are in brackets, from a sentence.
fn without_options(sentence: &str) -> String {
    let mut parts = sentence.split(" (--");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |before, part| {
        before + part.split_once(')').map_or("", |(_, after)| after)
    })
}

/// The sentences about the measurement.
fn sentences(screen: &MeasuredScreen) -> impl Iterator<Item = String> {
    let sentences = screen.measurement.sentences().into_iter();
    sentences.map(|sentence| without_options(&sentence))
}

/// The first sentence and the main numbers.
fn conclusion(screen: &MeasuredScreen, panel: &mut Panel<MeasuredAction>) {
    panel.paragraph(sentences(screen).next().unwrap_or_default(), Role::Text);
    panel.gap();
    for (name, id) in MAIN {
        // There is room for only one degree sign: "70.26 ± 0.12°".
        panel.fact(name, screen.measurement.printed(id).replacen('°', "", 1));
    }
}

fn summary(screen: &MeasuredScreen) -> Panel<MeasuredAction> {
    let mut panel = Panel::new("what it shows");
    panel.from_top = true;
    conclusion(screen, &mut panel);
    panel.gap();
    panel.prompts([
        ("all results", MeasuredAction::Everything),
        ("masses, radii, scale", MeasuredAction::Settings),
    ]);
    let warnings = screen.measurement.warnings();
    if !warnings.is_empty() {
        panel.gap();
    }
    for warning in warnings {
        panel.item(without_options(&warning), Role::Warn);
    }
    panel
}

fn everything(screen: &MeasuredScreen) -> Panel<MeasuredAction> {
    let mut panel = Panel::new("all results");
    panel.from_top = true;
    for sentence in sentences(screen) {
        panel.item(sentence, Role::Text);
    }
    for section in screen.measurement.sections() {
        panel.gap();
        panel.heading(section.title);
        for row in section.rows {
            panel.item(format!("{}: {}", row.name, row.text), Role::Text);
        }
    }
    panel
}

fn settings(screen: &MeasuredScreen) -> Panel<MeasuredAction> {
    let mut panel = Panel::new("masses, radii, scale");
    panel.part(MeasuredAction::Set, |panel| {
        screen.form.write(&screen.settings, panel);
    });
    panel.gap();
    screen.form.write_about(&screen.settings, &mut panel);
    if let Some(fault) = &screen.fault {
        panel.paragraph(fault.clone(), Role::Warn);
    }
    panel.gap();
    match screen.form.is_typing() {
        true => panel.prompt("set it", MeasuredAction::Set(SettingsForm::SET)),
        false => panel.prompt("done", MeasuredAction::Back),
    }
    panel.gap();
    panel.worth(1, |panel| conclusion(screen, panel));
    panel
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_screen_does_not_mention_the_command_line() {
        for (sentence, shown) in [
            (
                "The masses are assumed to be equal: set them (--m1-g and --m2-g).",
                "The masses are assumed to be equal: set them.",
            ),
            (
                "Set e = 0.84 (--restitution 0.84) to predict with the e found here.",
                "Set e = 0.84 to predict with the e found here.",
            ),
            ("It agrees with 90° (1.0 σ).", "It agrees with 90° (1.0 σ)."),
        ] {
            assert_eq!(without_options(sentence), shown);
        }
    }
}

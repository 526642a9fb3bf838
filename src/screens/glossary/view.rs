//! The view of the glossary.

use super::{GlossaryAction, GlossaryScreen};
use crate::lessons::GlossaryEntry;
use crate::screens::{Context, View, leads};
use crate::widgets::Role;
use crate::widgets::input::ListAction;
use crate::widgets::panel::Panel;

/// All terms by topic, and an explanation of the chosen one.
pub(super) fn view<'s>(glossary: &GlossaryScreen, cx: &Context) -> View<'s, GlossaryAction> {
    let (chosen, entry) = glossary.chosen();
    let mut list = Panel::new("glossary");
    let mut topic = "";
    for (i, entry) in GlossaryEntry::all().iter().enumerate() {
        if entry.topic != topic {
            topic = &entry.topic;
            list.gap();
            list.heading(topic);
        }
        let action = GlossaryAction::List(ListAction::Point(i));
        let symbol = entry.symbol.clone().unwrap_or_default();
        let name = (entry.term.clone(), Role::Text);
        list.row(name, (symbol, Role::Dim), i == chosen, action);
    }
    let mut about = Panel::new("the term");
    about.subject = chosen;
    if let Some(entry) = entry {
        about.paragraph(&entry.term, Role::Title);
        about.gap();
        about.paragraph(&entry.meaning, Role::Text);
        about.gap();
        if let Some(symbol) = &entry.symbol {
            about.fact("symbol", symbol);
        }
        if let Some(unit) = &entry.unit {
            about.fact("unit", unit);
        }
        about.gap();
        let page = Some(entry.introduced_by());
        leads::write(page, &cx.book, GlossaryAction::Read, &mut about);
    }
    View::panels(list, about)
}

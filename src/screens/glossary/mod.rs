//! The glossary: each term with its meaning, and the page that introduces it.

use strum::{EnumMessage, IntoStaticStr};

use super::{Context, Next, Route, Screen, View, leads};
use crate::lessons::GlossaryEntry;
use crate::messages::Key;
use crate::widgets::Role;
use crate::widgets::input::{KeyTable, ListAction, ListView};
use crate::widgets::panel::Panel;

#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum GlossaryAction {
    /// read the page that introduces the term
    Read,
    /// choose a term
    List(ListAction),
    /// go back
    Leave,
}

#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct GlossaryScreen {
    list: ListView,
}

impl GlossaryScreen {
    /// The chosen entry, and its number from 0.
    fn chosen(&self) -> (usize, Option<&'static GlossaryEntry>) {
        let all = GlossaryEntry::all();
        let at = self.list.chosen(all.len());
        (at, all.get(at))
    }

    /// Opens the page that introduces the chosen term.
    fn read(&self, cx: &Context) -> Next {
        let (_, entry) = self.chosen();
        leads::open(entry.map(GlossaryEntry::introduced_by), cx)
    }
}

impl Screen for GlossaryScreen {
    type Action = GlossaryAction;

    const HELP: &'static str = include_str!("help.txt");
    const TITLE: &'static str = "glossary";
    const ROUTE: Route = Route::Glossary;

    fn keys(&self, _cx: &Context) -> KeyTable<GlossaryAction> {
        // Enter has its own action here: in plain mode, choosing a term must not open the page at
        // once.
        KeyTable::new("glossary")
            .on(Key::Enter, GlossaryAction::Read, "read")
            .or([(Key::Char(' '), GlossaryAction::Read)])
            .with(ListView::keys("read"), GlossaryAction::List)
            .on(Key::Escape, GlossaryAction::Leave, "back")
    }

    fn act(&mut self, action: GlossaryAction, cx: &mut Context) -> Next {
        match action {
            GlossaryAction::List(action) => {
                let outcome = self.list.act(action, GlossaryEntry::all().len());
                Next::of(outcome, |_| self.read(cx))
            }
            GlossaryAction::Read => self.read(cx),
            GlossaryAction::Leave => Next::Back,
        }
    }

    fn wheel(&mut self, by: i8, cx: &mut Context) -> Next {
        self.act(GlossaryAction::List(ListAction::Choose(by.into())), cx)
    }

    /// All terms by topic, and an explanation of the chosen one.
    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, GlossaryAction> {
        let (chosen, entry) = self.chosen();
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
}

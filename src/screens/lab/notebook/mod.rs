//! The lab's notebook: every hit as a row of a table, and any two columns as a plot.

mod columns;
mod plot;
mod view;

use strum::{EnumMessage, IntoStaticStr};

use crate::files::csv_table;
use crate::messages::{Key, PlayerAction, StoreAnswer, StoreReply, StoreRequest};
use crate::physics::CollisionSpec;
use crate::progress::{NotedHit, utc};
use crate::screens::{Confirmation, Context, Next};
use crate::widgets::Outcome;
use crate::widgets::input::{CollisionField, KeyTable, ListAction, ListView};

use columns::NotebookColumn;
pub(super) use view::view;

/// The file name of the exported table.
const FILE: &str = "carrom-notebook.csv";

/// The open notebook.
#[derive(Debug, Clone)]
pub(super) struct Notebook {
    /// The ticket of the request for the hits.
    ticket: u64,
    /// The hits, or the reason why they cannot be loaded; `None` until the store has answered.
    hits: Option<Result<Vec<NotedHit>, String>>,
    list: ListView,
    /// Whether the plot is shown instead of the table.
    plots: bool,
    /// The columns on the two axes, as indices of the [columns](NotebookColumn::all).
    axes: [usize; 2],
}

/// What the keys do in the notebook.
#[derive(Debug, Clone, Copy, PartialEq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum NotebookAction {
    /// choose a hit, or set it up again
    List(ListAction),
    /// choose another hit
    Choose(isize),
    /// switch between the table and the plot
    Plot,
    /// plot another column along the x axis
    Across(isize),
    /// plot another column along the y axis
    Up(isize),
    /// export all hits as a table for a spreadsheet
    Export,
    /// delete all hits in the notebook
    Clear,
}

impl Notebook {
    /// Opens the notebook, and requests its hits from the store.
    pub(super) fn ask(cx: &mut Context) -> Self {
        let player = cx.settings.player.clone();
        Self {
            ticket: cx.ask(StoreRequest::Notebook(player)),
            hits: None,
            list: ListView::at(usize::MAX),
            plots: false,
            axes: ["alpha_deg", "theta1_deg"].map(NotebookColumn::index),
        }
    }

    /// Handles an answer from the store, if it belongs to the request.
    pub(super) fn take(&mut self, answer: &StoreAnswer) {
        if let (None, StoreReply::Notebook(hits)) = (&self.hits, &answer.done)
            && self.ticket == answer.ticket
        {
            self.hits = Some(hits.clone());
        }
    }

    /// The hits in the order in which they were made; none before they are loaded.
    fn hits(&self) -> &[NotedHit] {
        match &self.hits {
            Some(Ok(hits)) => hits,
            _ => &[],
        }
    }

    /// The index of the chosen hit, and the hit.
    fn chosen(&self) -> Option<(usize, &NotedHit)> {
        let at = self.list.chosen(self.hits().len());
        Some((at, self.hits().get(at)?))
    }

    fn axes(&self) -> [&'static NotebookColumn; 2] {
        self.axes.map(|at| &NotebookColumn::all()[at])
    }

    pub(super) fn keys(&self) -> KeyTable<NotebookAction> {
        use NotebookAction::{Across, Choose, Clear, Export, List, Plot, Up};
        let some = !self.hits().is_empty();
        let other = if self.plots { "table" } else { "plot" };
        let list = match some && !self.plots {
            true => ListView::keys("set it up again"),
            false => KeyTable::new("list"),
        };
        KeyTable::new("notebook")
            .with(list, List)
            .by([Key::Up, Key::Down], Choose, [-1, 1], "choose")
            .when(self.plots)
            .on('g', Plot, other)
            .when(some)
            .by(['x', 'X'], Across, [1, -1], "across")
            .when(self.plots)
            .by(['y', 'Y'], Up, [1, -1], "up")
            .when(self.plots)
            .on('e', Export, "export")
            .when(some)
            .on('C', Clear, "clear")
            .when(some)
    }

    /// Carries out an action other than [`NotebookAction::Clear`]; returns the settings of a hit to
    /// set up again.
    pub(super) fn act(
        &mut self,
        action: NotebookAction,
        cx: &mut Context,
    ) -> Option<CollisionSpec> {
        match action {
            NotebookAction::List(action) => {
                if let Outcome::Done(at) = self.list.act(action, self.hits().len()) {
                    return Some(self.hits().get(at)?.setup);
                }
            }
            NotebookAction::Choose(by) => self.choose(by),
            NotebookAction::Plot => self.plots ^= true,
            NotebookAction::Across(by) => self.turn(0, by),
            NotebookAction::Up(by) => self.turn(1, by),
            NotebookAction::Export => match self.csv() {
                Ok(text) => cx.export(FILE.into(), text),
                Err(reason) => cx.notify(format!("The table cannot be written: {reason}")),
            },
            NotebookAction::Clear => {}
        }
        None
    }

    /// Plots the next useful column on an axis.
    fn turn(&mut self, axis: usize, by: isize) {
        let count = NotebookColumn::all().len() as isize;
        let mut at = self.axes[axis];
        for _ in 0..count {
            at = (at as isize + by).rem_euclid(count) as usize;
            if self.is_worth_plotting(&NotebookColumn::all()[at]) {
                break;
            }
        }
        self.axes[axis] = at;
    }

    /// Whether a column has numbers that differ between hits, if there are several hits. The impact
    /// angle and the offset are always worth plotting.
    fn is_worth_plotting(&self, column: &NotebookColumn) -> bool {
        use CollisionField::{ImpactAngle, Offset};
        let values = || self.hits().iter().map(|hit| column.value(hit));
        let differs = || values().zip(values().skip(1)).any(|(a, b)| a != b);
        let is_place = matches!(column.setting(), Some(ImpactAngle | Offset));
        column.is_number() && (is_place || self.hits().len() < 2 || differs())
    }

    /// The question before the notebook is cleared.
    pub(super) fn ask_to_clear(&self) -> Next {
        let what = match self.hits().len() {
            1 => "The hit in your notebook".to_owned(),
            count => format!("All {count} hits in your notebook"),
        };
        let text = format!(
            "{what} will be deleted, here and on the disk. Export them first if you want to keep them."
        );
        Next::Confirm(Confirmation::new(text, "clear the notebook", "keep it"))
    }

    /// Deletes all hits, now that the player has agreed.
    pub(super) fn clear(&mut self, cx: &mut Context) {
        cx.note(PlayerAction::ClearNotebook(cx.settings.player.clone()));
        self.hits = Some(Ok(Vec::new()));
        self.plots = false;
    }

    /// All hits as a table for a spreadsheet, with all digits.
    fn csv(&self) -> Result<String, String> {
        let columns = NotebookColumn::all();
        let ids = columns.iter().map(|column| column.id);
        let heads = ["hit", "time"].into_iter().chain(ids).chain(["link"]);
        let row = |(number, hit): (usize, &NotedHit)| {
            let time = hit.time_s.and_then(utc).unwrap_or_default();
            let cells = columns.iter().map(|column| column.cell(hit));
            let start = [number.to_string(), time].into_iter();
            start.chain(cells).chain([link(&hit.setup)]).collect()
        };
        let rows: Vec<Vec<String>> = (1..).zip(self.hits()).map(row).collect();
        csv_table(heads, &rows)
    }

    /// Chooses another hit.
    pub(super) fn choose(&mut self, by: isize) {
        self.list.act(ListAction::Choose(by), self.hits().len());
    }
}

/// The address of a hit, as in a link.
fn link(setup: &CollisionSpec) -> String {
    match setup.to_link() {
        usual if usual.is_empty() => "lab".into(),
        link => format!("lab={link}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Otherwise a player would have to go through thirty columns to reach the setting they varied.
    #[test]
    fn a_column_that_is_the_same_in_all_hits_is_not_offered_for_the_plot() {
        let hit = |link| NotedHit::new(CollisionSpec::from_link(link).unwrap(), None);
        let mut notebook = Notebook {
            ticket: 0,
            hits: Some(Ok(vec![
                hit("b:5,e:0.8"),
                hit("b:12,e:0.8"),
                hit("b:5,m2:5.5,e:0.8"),
            ])),
            list: ListView::at(0),
            plots: true,
            axes: [0, 0],
        };
        let mut offered = Vec::new();
        while offered.len() < 2 || notebook.axes[0] != 0 {
            notebook.turn(0, 1);
            offered.push(notebook.axes()[0].id);
        }
        for id in [
            "alpha_deg",
            "m2_g",
            "theta1_deg",
            "v1_m_s",
            "energy_after_mj",
        ] {
            assert!(offered.contains(&id), "{id}");
        }
        for id in ["e", "m1_g", "contact", "spin1_rad_s", "said_theta1_deg"] {
            assert!(!offered.contains(&id), "{id}");
        }
        notebook.turn(0, -1);
        assert_eq!(notebook.axes()[0].id, offered[offered.len() - 2]);
    }
}

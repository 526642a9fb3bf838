//! The view of the notebook.

use super::columns::NotebookColumn;
use super::{Notebook, NotebookAction, link, plot};
use crate::physics::CollisionSpec;
use crate::progress::NotedHit;
use crate::screens::View;
use crate::widgets::input::ListAction;
use crate::widgets::panel::{Panel, TableColumn, TableRow};
use crate::widgets::{Look, Role, SplitLayout, sheet};

/// The maximum width of the table with its frame, in columns.
const WIDEST: u16 = 160;
/// The number of rows that are left free below the table.
const BELOW: u16 = 4;

/// The table, or the plot with the chosen hit beside it.
pub(in crate::screens::lab) fn view<'s, A: Copy>(
    notebook: &'s Notebook,
    wrap: impl Fn(NotebookAction) -> A,
) -> View<'s, A> {
    let mut panel = Panel::new("notebook");
    if !notebook.plots {
        panel.part(wrap, |panel| table(notebook, panel));
        return View::alone(|room| SplitLayout::text_of(room, WIDEST), panel);
    }
    panel.part(wrap, |panel| beside_plot(notebook, panel));
    let [x, y] = notebook.axes();
    let draw = |area, buf: &mut _, look: &Look| {
        sheet::next_picture_shows(|| plot::in_words(notebook));
        plot::picture(notebook, area, look).draw(buf, look);
    };
    View::picture(format!("{} against {}", y.symbol, x.symbol), draw, panel)
}

fn table(notebook: &Notebook, panel: &mut Panel<NotebookAction>) {
    match &notebook.hits {
        None => return panel.paragraph("Loading …", Role::Dim),
        Some(Err(reason)) => {
            let text = format!("Your notebook cannot be loaded: {reason}.");
            return panel.paragraph(text, Role::Warn);
        }
        Some(Ok(hits)) if hits.is_empty() => {
            let text = "There is nothing here yet: every hit that you make in the lab becomes a \
                        row, with its settings, your prediction and the result. Hits with a \
                        mystery coin that has not been weighed are left out.";
            return panel.paragraph(text, Role::Text);
        }
        Some(Ok(_)) => {}
    }
    let number = |id, width, room| {
        let column = NotebookColumn::named(id);
        let head = TableColumn::numbers(column.symbol, width);
        (head.from(room), vec![column])
    };
    let pair = |head: &str, ids: [&str; 2], width| {
        let columns = ids.map(NotebookColumn::named).into();
        (TableColumn::numbers(head, width), columns)
    };
    let (heads, shown): (Vec<_>, Vec<Vec<&NotebookColumn>>) = [
        number("b_mm", 5, 0),
        number("alpha_deg", 5, 85),
        pair("m₁    m₂", ["m1_g", "m2_g"], 11),
        number("e", 4, 0),
        number("u1_m_s", 5, 93),
        pair("said S    C", ["said_theta1_deg", "said_theta2_deg"], 11),
        pair("true S    C", ["theta1_deg", "theta2_deg"], 11),
        pair("v₁   v₂", ["v1_m_s", "v2_m_s"], 9),
        number("energy_before_mj", 8, 114),
        number("energy_after_mj", 7, 114),
        number("px_after_g_m_s", 8, 136),
        number("py_after_g_m_s", 8, 136),
    ]
    .into_iter()
    .unzip();
    let columns = [TableColumn::numbers("hit", 3)].into_iter().chain(heads);
    let cell = |hit: &NotedHit, columns: &[&NotebookColumn]| {
        let each = columns.iter().map(|it| format!("{:>5}", it.shown(hit)));
        each.collect::<Vec<_>>().join(" ")
    };
    let (at, _) = notebook.chosen().unzip();
    let row = |(number, hit): (usize, &NotedHit)| TableRow {
        cells: std::iter::once((number + 1).to_string())
            .chain(shown.iter().map(|columns| cell(hit, columns)))
            .collect(),
        role: Role::Text,
        chosen: Some(number) == at,
        action: Some(NotebookAction::List(ListAction::Point(number))),
    };
    let rows = notebook.hits().iter().enumerate().map(row).collect();
    panel.table(columns.collect(), rows, Some(BELOW));
    panel.gap();
    let again = NotebookAction::List(ListAction::Open);
    panel.prompts([
        ("plot two columns", NotebookAction::Plot),
        ("export as CSV", NotebookAction::Export),
        ("clear the notebook", NotebookAction::Clear),
        ("set the chosen hit up again", again),
    ]);
}

/// The axes, the chosen hit's values on them, an explanation of the curve, and a link to the hit.
fn beside_plot(notebook: &Notebook, panel: &mut Panel<NotebookAction>) {
    let [x, y] = notebook.axes();
    for (axis, column, other) in [
        ("across", x, NotebookAction::Across(1)),
        ("up", y, NotebookAction::Up(1)),
    ] {
        panel.row((axis, Role::Text), (column.name(), Role::Key), false, other);
    }
    let Some((at, hit)) = notebook.chosen() else {
        return;
    };
    panel.gap();
    panel.heading(format!("Hit {} of {}", at + 1, notebook.hits().len()));
    for column in [x, y] {
        let value = column.shown(hit);
        let shown = match (value.as_str(), column.unit) {
            ("", _) => "none".into(),
            (value, "°") => format!("{value}°"),
            (value, unit) => format!("{value} {unit}"),
        };
        panel.fact(column.symbol, shown);
    }
    panel.gap();
    panel.paragraph(plot::about_curve(notebook), Role::Dim);
    panel.worth(1, |panel| {
        panel.gap();
        share(&hit.setup, panel);
    });
}

/// The command and the link that open exactly this hit.
fn share(setup: &CollisionSpec, panel: &mut Panel<NotebookAction>) {
    let settings = setup.to_link().replace(':', "=");
    let set = match settings.as_str() {
        "" => "carrom lab".to_owned(),
        settings => format!("carrom lab --set {settings}"),
    };
    panel.code("This hit for a friend", set, link(setup));
}

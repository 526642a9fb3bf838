//! The layout of panels in cells: how many rows each block has, which blocks fit, and which cells
//! can be clicked.

use std::ops::Range;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::pages::PlacedPages;
use super::{Beside, Block, Content, Panel, TableColumn, TableRow, board};
use crate::widgets::bar::{bar, stretch};
use crate::widgets::flow::Run;
use crate::widgets::{Charset, Lines, Look, Role, Room, Words, areas, formula, text};

/// How a panel is written: its glyphs and colours, and the labels of the page keys.
#[derive(Debug, Clone)]
pub(crate) struct Writing {
    pub look: Look,
    /// The labels of the keys that go back and forward one page, if the text has pages.
    pub pages: Option<[String; 2]>,
}

/// A panel after layout: the blocks that fit, with their positions.
pub(crate) struct Placed<'p> {
    area: Rect,
    /// The blocks that stay visible above the scrollable text, and those below it.
    fixed: [Fixed<'p>; 2],
    /// Each block with its first row, counted from the top of the text.
    blocks: Vec<(u16, PlacedBlock<'p>)>,
    rows: u16,
    targets: Vec<Target>,
    /// The rows of the selected item.
    chosen: Option<Range<u16>>,
    /// Whether the selected item belongs to a list rather than being a setting.
    pub(crate) is_list: bool,
    /// The height, in rows, of the area in which the panel was laid out.
    whole: u16,
    /// The pages in large letters, if the panel is read page by page.
    pages: Option<PlacedPages<'p>>,
}

/// Blocks that are not scrolled.
#[derive(Default)]
struct Fixed<'p> {
    area: Rect,
    pieces: Vec<PlacedBlock<'p>>,
    targets: Vec<Target>,
    rows: u16,
}

/// A block without its actions.
struct PlacedBlock<'p> {
    content: &'p Content,
    worth: Option<u8>,
    /// For each action, the label of its key; `None` if the action has no key or the label is not
    /// shown.
    keys: Vec<Option<String>>,
}

/// Cells that can be clicked, in rows from the top of the text and columns from the left.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Target {
    rows: Range<u16>,
    columns: Range<u16>,
    action: ActionAt,
}

impl Target {
    /// This target moved down by `rows` rows.
    fn below(self, rows: u16) -> Self {
        Self {
            rows: rows + self.rows.start..rows + self.rows.end,
            ..self
        }
    }

    /// The cells of the target in an area whose text is scrolled by `scrolled` rows; `None` if the
    /// target is not visible.
    fn cells(&self, area: Rect, scrolled: u16) -> Option<Rect> {
        let top = area.y + self.rows.start.saturating_sub(scrolled);
        let below = area.y + self.rows.end.checked_sub(scrolled)?;
        let cells = Rect {
            x: area.x + self.columns.start,
            y: top,
            width: self.columns.end - self.columns.start,
            height: below.saturating_sub(top),
        };
        let cells = cells.intersection(area);
        (!cells.is_empty()).then_some(cells)
    }
}

/// The position of an action in a panel: the index of the block, and the index of the action in the
/// block.
pub(super) type ActionAt = (usize, usize);

impl<A: Copy> Panel<A> {
    /// Lays the panel out in `area`; a panel that is too long can be scrolled. `key` returns the
    /// label of an action's key.
    pub(crate) fn placed(
        &self,
        area: Rect,
        writing: &Writing,
        key: &dyn Fn(&A) -> Option<String>,
    ) -> Placed<'_> {
        let piece = |block: &'_ Block<A>| -> Vec<Option<String>> {
            match block.content {
                Content::Prompts(_) => block.actions.iter().map(key).collect(),
                _ => vec![None; block.actions.len()],
            }
        };
        let pieces = self.blocks.iter().map(|block| PlacedBlock {
            content: &block.content,
            worth: block.worth,
            keys: piece(block),
        });
        let below = self.below.unwrap_or(self.blocks.len());
        let mut placed = placed(pieces.collect(), self.pinned..below, area, writing);
        if self.open && placed.overflow() > 0 {
            // The note that there is more text has a separate row.
            placed.area.height = placed.area.height.saturating_sub(1);
        }
        placed
    }

    /// Lays the panel out on pages in large letters beside a picture, on a screen whose body has
    /// `body_rows` rows; `None` if any letter has no large form.
    pub(crate) fn paged(
        &self,
        beside: Beside,
        room: Room,
        body_rows: u16,
        writing: &Writing,
    ) -> Option<Placed<'_>> {
        let pages = PlacedPages::new(self, beside, room, body_rows, &writing.look)?;
        Some(Placed {
            pages: Some(pages),
            ..Placed::empty(room.area)
        })
    }

    /// The action at this position, which is triggered by clicking its target.
    pub(crate) fn action(&self, (block, own): ActionAt) -> Option<A> {
        self.blocks.get(block)?.actions.get(own).copied()
    }
}

/// Lays out blocks; the blocks in `middle` can be scrolled.
fn placed<'p>(
    pieces: Vec<PlacedBlock<'p>>,
    middle: Range<usize>,
    area: Rect,
    writing: &Writing,
) -> Placed<'p> {
    let mut scratch = Buffer::empty(area);
    let mut lines = Lines::unseen(area, &mut scratch, writing.look);
    let mut lengths = Vec::new();
    for (number, piece) in pieces.iter().enumerate() {
        let from = lines.written();
        let mut targets = Vec::new();
        piece.write(&mut lines, &mut |rows, columns, own| {
            targets.push(Target {
                rows: rows.start - from..rows.end - from,
                columns,
                action: (number, own),
            });
        });
        lengths.push((lines.written() - from, targets));
    }
    let is_shown = with_room(&pieces, area.height, lengths.iter().map(|(rows, _)| *rows));
    let rows = |part: Range<usize>| -> u16 { lengths[part].iter().map(|(rows, _)| rows).sum() };
    let head = rows(0..middle.start);
    // An empty row separates the foot from the blocks above.
    let foot = match rows(middle.end..pieces.len()) {
        0 => 0,
        rows => rows + 1,
    };
    // If there is hardly any room left for the middle, the head and the foot are scrolled too.
    let (head, foot, middle) = match head + foot + LEAST <= area.height {
        true => (head, foot, middle),
        false => (0, 0, 0..pieces.len()),
    };
    let [above, rest] = areas::upper(area, head);
    let [area, _] = areas::upper(rest, rest.height - foot);
    let mut placed = Placed {
        whole: area.height + head + foot,
        ..Placed::empty(area)
    };
    let mut after_gap = true;
    let blocks = pieces.into_iter().zip(is_shown).zip(lengths);
    for (number, ((piece, shown), (rows, targets))) in blocks.enumerate() {
        if !middle.contains(&number) {
            let part = &mut placed.fixed[usize::from(number >= middle.end)];
            part.targets
                .extend(targets.into_iter().map(|it| it.below(part.rows)));
            part.rows += rows;
            part.pieces.push(piece);
            continue;
        }
        let is_gap = matches!(piece.content, Content::Gap);
        // Adjacent gaps, and a gap at the top, are removed.
        if !shown || is_gap && after_gap {
            continue;
        }
        after_gap = is_gap;
        let top = placed.rows;
        if piece.content.is_chosen() {
            placed.chosen = Some(top..top + rows);
            let sets = matches!(
                piece.content,
                Content::Field { .. } | Content::TextField { .. }
            );
            placed.is_list = !sets;
        }
        placed
            .targets
            .extend(targets.into_iter().map(|it| it.below(top)));
        placed.blocks.push((top, piece));
        placed.rows += rows;
    }
    let [_, below] = areas::upper(rest, placed.rows.min(area.height) + u16::from(foot > 0));
    placed.fixed[0].area = above;
    placed.fixed[1].area = below;
    placed
}

/// For each block, whether it is shown in a panel of this height.
fn with_room(pieces: &[PlacedBlock], height: u16, rows: impl Iterator<Item = u16>) -> Vec<bool> {
    let rows: Vec<u16> = rows.collect();
    let of = |worth: Option<u8>| -> u16 {
        let blocks = pieces.iter().zip(&rows);
        blocks
            .filter(|(block, _)| block.worth == worth)
            .map(|(_, rows)| rows)
            .sum()
    };
    let mut worths: Vec<_> = pieces.iter().filter_map(|block| block.worth).collect();
    worths.sort_unstable_by(|a, b| b.cmp(a));
    worths.dedup();
    let mut spare = height.saturating_sub(of(None));
    worths.retain(|worth| {
        let needed = of(Some(*worth));
        let fits = needed <= spare;
        spare -= if fits { needed } else { 0 };
        fits
    });
    let shown = |block: &PlacedBlock| block.worth.is_none_or(|worth| worths.contains(&worth));
    pieces.iter().map(shown).collect()
}

impl<'p> Placed<'p> {
    fn empty(area: Rect) -> Self {
        Self {
            area,
            fixed: Default::default(),
            blocks: Vec::new(),
            rows: 0,
            targets: Vec::new(),
            chosen: None,
            is_list: false,
            whole: area.height,
            pages: None,
        }
    }

    /// This panel in another area of the same size.
    #[must_use]
    pub(crate) fn moved(self, area: Rect) -> Self {
        Self { area, ..self }
    }

    /// The pages, if the panel is read page by page.
    pub(crate) fn pages(&self) -> Option<&PlacedPages<'p>> {
        self.pages.as_ref()
    }

    /// The number of rows in the scrollable text.
    pub(crate) fn rows(&self) -> u16 {
        self.rows
    }

    /// The number of rows that do not fit into the area; if there are pages, the number of pages
    /// after the first.
    pub(crate) fn overflow(&self) -> u16 {
        match &self.pages {
            Some(pages) => pages.count().saturating_sub(1),
            None => self.rows.saturating_sub(self.area.height),
        }
    }

    /// The first row of the selected item.
    pub(crate) fn chosen(&self) -> Option<u16> {
        self.chosen.as_ref().map(|rows| rows.start)
    }

    /// The scroll position until the player scrolls: if not everything fits, the selected item is
    /// in the middle.
    pub(crate) fn following(&self) -> u16 {
        let chosen = self.chosen().unwrap_or(0);
        let above = chosen.saturating_sub(self.area.height / 2);
        above.min(self.overflow())
    }

    /// The cells that can be clicked and their actions, with the text scrolled by `scrolled` rows.
    pub(crate) fn targets(&self, scrolled: u16) -> impl Iterator<Item = (Rect, ActionAt)> + '_ {
        let [head, foot] = &self.fixed;
        let parts = [
            (&head.targets, head.area, 0),
            (&self.targets, self.area, scrolled),
            (&foot.targets, foot.area, 0),
        ];
        let targets = parts.into_iter().flat_map(|(targets, area, scrolled)| {
            let cells = move |it: &Target| Some((it.cells(area, scrolled)?, it.action));
            targets.iter().filter_map(cells)
        });
        let pages = self.pages.iter();
        targets.chain(pages.flat_map(move |pages| pages.targets(scrolled)))
    }

    /// Draws the panel, scrolled by `scrolled` rows. If the panel does not fit, the bottom of the
    /// frame names the key that shows the rest.
    pub(crate) fn draw(&self, scrolled: u16, buf: &mut Buffer, writing: &Writing) {
        if let Some(pages) = &self.pages {
            return pages.draw(scrolled, buf, writing);
        }
        let write_fixed = |part: &Fixed, buf: &mut Buffer| {
            let mut lines = Lines::new(part.area, buf, writing.look).of_whole(self.whole);
            for piece in &part.pieces {
                piece.write(&mut lines, &mut |_, _, _| ());
            }
        };
        write_fixed(&self.fixed[0], buf);
        let lines = Lines::new(self.area, buf, writing.look).of_whole(self.whole);
        let mut lines = lines.scrolled(scrolled);
        for (row, piece) in &self.blocks {
            debug_assert_eq!(lines.written(), *row);
            piece.write(&mut lines, &mut |_, _, _| ());
        }
        write_fixed(&self.fixed[1], buf);
        if let (Some([back, on]), 1..) = (&writing.pages, self.overflow()) {
            let hint = match scrolled < self.overflow() {
                true => format!(" {on}: more "),
                false => format!(" {back}: back "),
            };
            text::hint_below(self.area, buf, writing.look, &hint);
        }
    }
}

/// A callback for cells that can be clicked: their rows, their columns, and the index of the action
/// in its block.
type TakeTarget<'t> = dyn FnMut(Range<u16>, Range<u16>, usize) + 't;

impl PlacedBlock<'_> {
    /// Writes the block, and passes the cells that can be clicked to `take`.
    fn write(&self, lines: &mut Lines, take: &mut TakeTarget) {
        let from = lines.written();
        match self.content {
            Content::Table {
                columns,
                rows,
                leaves,
            } => return write_table(columns, rows, *leaves, lines, take),
            Content::Prompts(prompts) => return write_prompts(prompts, &self.keys, lines, take),
            Content::Tabs { names, open } => return write_tabs(names, *open, lines, take),
            Content::Grid { cells, chosen } => return write_grid(cells, *chosen, lines, take),
            content => write(content, lines),
        }
        if !self.keys.is_empty() {
            take(from..lines.written(), 0..lines.width() + 1, 0);
        }
    }
}

/// Writes a block that has a single action for all its cells, or none.
fn write(content: &Content, lines: &mut Lines) {
    match content {
        Content::Gap => lines.gap(),
        Content::Heading(text) => lines.line(text, Role::Title),
        Content::Large(texts, role, from) => lines.large(texts, *role, *from),
        Content::LargeText(text) => {
            let words = |charset| text.words(charset);
            let write = |lines: &mut Lines| lines.paragraph(&text.text, text.role);
            match text.whole {
                true => lines.clicked_as(words, Some(false), write),
                false => lines.written_as(words, write),
            }
            lines.gap();
        }
        Content::PageBreak => lines.gap(),
        Content::Board(rows) => board::write(rows, lines),
        Content::Line(text, role) => lines.line(text, *role),
        Content::Paragraph(text, role) => lines.paragraph(text, *role),
        Content::Code {
            text,
            command,
            address,
            is_result,
        } => {
            let recorded = |_| Words::Code {
                text: text.clone(),
                command: command.clone(),
                address: address.clone(),
                is_result: *is_result,
            };
            lines.written_as(recorded, |lines| {
                lines.paragraph(&format!("{text}: {command}"), Role::Dim);
            });
        }
        Content::Fact { name, value, roles } => lines.pair(name, value, roles[0], roles[1]),
        Content::Columns { name, values } => {
            let values: Vec<_> = values
                .iter()
                .map(|(it, role)| (it.as_str(), *role))
                .collect();
            lines.columns((&name.0, name.1), &values);
        }
        Content::Row {
            name,
            side,
            roles,
            chosen,
        } => {
            let (_, side_role) = roles[1].of_choice(*chosen);
            lines.choice(*chosen, roles[0], |lines, mark, role| {
                let name = format!("{mark} {name}");
                // The name takes precedence over the text beside it.
                let room = usize::from(lines.width()).saturating_sub(text::width(&name) + 2);
                let side = Some(side).filter(|side| text::width(side) <= room);
                lines.pair(&name, side.map_or("", String::as_str), role, side_role);
            });
        }
        Content::Entry {
            letter,
            name,
            about,
            role,
            chosen,
        } => {
            let recorded = |charset: Charset| Words::Pair {
                name: Run::new(name, *role).spelt(charset),
                value: Run::new(about, Role::Dim).spelt(charset),
            };
            let (mark, role) = role.of_choice(*chosen);
            let mut row = format!("{mark} {letter}  {name}");
            let room = usize::from(lines.width()).saturating_sub(ENTRY);
            if text::width(about) <= room && !about.is_empty() {
                row = format!("{row:ENTRY$}{about}");
            }
            lines.clicked_as(recorded, Some(*chosen), |lines| lines.line(&row, role));
        }
        Content::Flow(mark, runs) => {
            let indent = match mark.as_str() {
                "" => 0,
                mark => text::width(mark) as u16 + 1,
            };
            lines.flowing(mark, indent, runs);
        }
        Content::Formula(formula, role) => {
            let recorded = |charset| Words::Equation {
                runs: vec![Run::formula(formula, *role).spelt(charset)],
            };
            lines.written_as(recorded, |lines| {
                for row in formula::set(formula, lines.charset()) {
                    lines.line(&format!("{:1$}{row}", "", FORMULA.into()), *role);
                }
            });
        }
        Content::Working(line) => lines.equation(line, WORKING, Role::Text),
        Content::Field {
            name,
            value,
            role,
            chosen,
            locked,
        } => {
            let (mark, name_role) = role.of_choice(*chosen);
            let (value, value_role) = match (locked, name_role) {
                (true, role) => (format!("({value})"), role),
                (false, Role::Dim) => (value.clone(), Role::Text),
                (false, role) => (value.clone(), role),
            };
            let words = |charset: Charset| Words::Field {
                name: charset.text(name).into_owned(),
                value: charset.text(&value).into_owned(),
                locked: *locked,
            };
            lines.clicked_as(words, Some(*chosen), |lines| {
                lines.pair(&format!("{mark} {name}"), &value, name_role, value_role);
            });
        }
        Content::Marked { mark, text, role } => lines.hanging(mark, text, *role),
        Content::Meter { name, share, value } => {
            let before = match name.as_str() {
                "" => String::new(),
                name => format!("{name}  "),
            };
            let beside = text::width(&before) + text::width(value).max(SHARE) + 2;
            let width = lines.width().saturating_sub(beside as u16);
            let bar = bar(*share, width, lines.charset());
            lines.written_as(
                |_| Words::meter(name, *share, value, Role::Text),
                |lines| lines.pair(&format!("{before}{bar}"), value, Role::Text, Role::Text),
            );
        }
        Content::Gauge {
            share,
            value,
            role,
            meant: (from, to),
            name,
        } => {
            let width = lines
                .width()
                .min(LONGEST_GAUGE)
                .saturating_sub(BESIDE_GAUGE);
            let full = bar(*share, width, lines.charset());
            lines.written_as(
                |_| Words::meter("", *share, value, *role),
                |lines| lines.pair(&full, value, *role, Role::Text),
            );
            let stretch = stretch(*from, *to, width, lines.charset());
            let shares = format!("from {:.0} to {:.0} %", 100.0 * from, 100.0 * to);
            let [meant, shares] = [name, &shares].map(|it| Run::new(it.as_str(), Role::Dim));
            lines.written_as(
                |_| Words::Pair {
                    name: meant,
                    value: shares,
                },
                |lines| lines.pair(&stretch, name, Role::Dim, Role::Dim),
            );
        }
        Content::Choice {
            letter,
            text,
            chosen,
        } => {
            lines.choice(*chosen, Role::Text, |lines, mark, role| {
                let mark = format!("{mark} {letter} ");
                match text.as_slice() {
                    [run] => lines.hanging(&mark, &run.text, role),
                    runs => lines.flowing(&mark, 4, runs),
                }
            });
        }
        Content::ChoiceColumns {
            name,
            values,
            chosen,
        } => {
            let values: Vec<_> = values.iter().map(|it| (it.as_str(), Role::Text)).collect();
            lines.choice(*chosen, Role::Text, |lines, mark, role| {
                lines.columns((&format!("{mark} {name}"), role), &values);
            });
        }
        Content::TextField {
            label,
            typed: [before, after],
            chosen,
        } => {
            let (mark, role) = Role::Text.of_choice(*chosen);
            let cursor = if *chosen { "_" } else { "" };
            let name = label.trim_end().trim_end_matches(':');
            let words = |_| Words::text_field(name, &format!("{before}{after}"));
            lines.clicked_as(words, Some(*chosen), |lines| {
                let row = format!("{mark} {label:LABEL$}{before}{cursor}{after} ");
                lines.line(&row, role);
            });
        }
        Content::Table { .. }
        | Content::Prompts(_)
        | Content::Tabs { .. }
        | Content::Grid { .. } => {}
    }
}

/// Writes the names of several pages side by side.
fn write_tabs(names: &[String], open: usize, lines: &mut Lines, take: &mut TakeTarget) {
    let row = lines.written();
    let mut column = 0;
    for (i, name) in names.iter().enumerate() {
        let (mark, role) = Role::Dim.of_choice(i == open);
        let shown = format!("{mark}{name} ");
        let words = |charset: Charset| Words::Tab {
            name: charset.text(name).into_owned(),
        };
        lines.beside(column, words, &shown, role, i == open);
        let end = column + text::width(&shown) as u16;
        // The first column of a panel is its margin.
        take(row..row + 1, column + 1..end + 1, i);
        column = end + BETWEEN_TABS;
    }
    lines.unrecorded(|lines| lines.line("", Role::Text));
}

/// Writes names side by side, as closely together as possible. If there are too many rows, only
/// some of them are shown, including the row of the selected name or, if there is none, the last.
fn write_grid(
    cells: &[[String; 2]],
    chosen: Option<usize>,
    lines: &mut Lines,
    take: &mut TakeTarget,
) {
    let widest = cells.iter().map(|[name, _]| text::width(name)).max();
    let widest = widest.unwrap_or(0) + BESIDE_NAME;
    let width = usize::from(lines.width() + 1);
    let per_row = (width / widest).max(1);
    let most = usize::from(lines.whole()) * MOST_ROWS / 10;
    let rows: Vec<_> = cells.chunks(per_row).enumerate().collect();
    let at = chosen
        .unwrap_or(cells.len())
        .min(cells.len().saturating_sub(1))
        / per_row;
    let first = (at + 1).saturating_sub(most.max(1));
    let column = (width / per_row) as u16;
    for (row, cells) in rows.into_iter().skip(first).take(most.max(1)) {
        let top = lines.written();
        for (i, [name, sign]) in cells.iter().enumerate() {
            let number = row * per_row + i;
            let is_chosen = chosen == Some(number);
            let (mark, role) = Role::Title.of_choice(is_chosen);
            let room = usize::from(column).saturating_sub(BESIDE_NAME);
            let name = text::clipped(name, room);
            let words = format!("{} {name} {sign}", number + 1);
            let start = i as u16 * column;
            let row = format!("{mark} {words}");
            let words = |charset| Words::text(Run::new(words, role).spelt(charset));
            lines.beside(start, words, &row, role, is_chosen);
            take(top..top + 1, start..start + column, number);
        }
        lines.unrecorded(|lines| lines.line("", Role::Text));
    }
}

/// The number of columns added to a name in a grid, for its mark, number and sign.
const BESIDE_NAME: usize = 10;
/// The maximum height of a grid, in tenths of the panel's rows.
const MOST_ROWS: usize = 3;

/// The minimum number of rows for the text that scrolls between fixed blocks.
const LEAST: u16 = 6;

/// The indentation of formulas, in columns.
const FORMULA: u16 = 2;
/// The indentation of continuation lines of working, in columns.
const WORKING: u16 = 4;
/// The maximum width of a gauge, in columns.
const LONGEST_GAUGE: u16 = 52;
const BESIDE_GAUGE: u16 = 10;

/// The width of a share such as `100 %`, in columns.
const SHARE: usize = 5;

/// The width of a text field's label, including the space after it, in columns.
const LABEL: usize = 8;

/// The number of columns between the names of adjacent tabs.
const BETWEEN_TABS: u16 = 2;

/// The width of the letter and the name in a line of a menu, in columns.
const ENTRY: usize = 15;

/// The minimum width, in columns, of a panel in which a table has gaps before its numbers.
const WIDE_TABLE: u16 = 72;

/// Writes a table: its headings, then one line per row. There are gaps between numbers and the text
/// after them and, if there is room, before numbers. A table that `leaves` some rows free shows
/// only the part around its selected row.
fn write_table(
    columns: &[TableColumn],
    rows: &[TableRow<()>],
    leaves: Option<u16>,
    lines: &mut Lines,
    take: &mut TakeTarget,
) {
    let width = lines.width();
    let gap = if width >= WIDE_TABLE { "   " } else { "" };
    let charset = lines.charset();
    let written = |mark: &str, cells: &mut dyn Iterator<Item = &str>| {
        let mut row = mark.to_owned();
        let shown = columns.iter().zip(cells);
        let mut before: Option<&TableColumn> = None;
        for (column, cell) in shown.filter(|(column, _)| width >= column.room) {
            let cell = charset.text(cell);
            let pad = usize::from(column.width).saturating_sub(text::width(&cell));
            let pad = " ".repeat(pad);
            row += &match (column.flush_right, before) {
                (true, None) => format!("{pad}{cell}"),
                (true, Some(_)) => format!("{gap}{pad}{cell}"),
                (false, Some(before)) if before.flush_right => format!("  {cell}{pad}"),
                (false, _) => format!("{cell}{pad}"),
            };
            before = Some(column);
        }
        row
    };
    let recorded = |cells: &[&str], role: Role, charset: Charset| {
        let shown = columns.iter().zip(cells);
        let shown = shown.filter(|(column, _)| width >= column.room && !column.drawn);
        let mut runs = shown.map(|(_, cell)| Run::new(*cell, role).spelt(charset));
        Words::Columns {
            name: runs.next().unwrap_or_else(|| Run::new("", role)),
            values: runs.collect(),
        }
    };
    let heads: Vec<_> = columns.iter().map(|column| column.head.as_str()).collect();
    // Only rows with an action can be selected.
    let has_marks = rows.iter().any(|row| row.action.is_some());
    let head = written(if has_marks { " " } else { "" }, &mut heads.iter().copied());
    lines.written_as(
        |charset| recorded(&heads, Role::Dim, charset),
        |lines| lines.line(&head, Role::Dim),
    );
    let most = leaves.map(|leaves| usize::from(lines.whole().saturating_sub(leaves + 1).max(3)));
    let most = most.unwrap_or(rows.len());
    let chosen = rows.iter().position(|row| row.chosen).unwrap_or(0);
    let first = chosen.saturating_sub(most / 2);
    let first = first.min(rows.len().saturating_sub(most));
    for (own, row) in rows.iter().enumerate().skip(first).take(most) {
        let (mark, role) = row.role.of_choice(row.chosen);
        let from = lines.written();
        let cells: Vec<_> = row.cells.iter().map(String::as_str).collect();
        let mark = if has_marks { mark } else { "" };
        let line = written(mark, &mut cells.iter().copied());
        lines.clicked_as(
            |charset| recorded(&cells, row.role, charset),
            row.action.map(|_| row.chosen),
            |lines| lines.line(&line, role),
        );
        if row.action.is_some() {
            take(from..lines.written(), 0..width + 1, own);
        }
    }
}

/// Writes the possible next actions as running text, each with its key and its description.
fn write_prompts(
    prompts: &[String],
    keys: &[Option<String>],
    lines: &mut Lines,
    take: &mut TakeTarget,
) {
    let charset = lines.charset();
    let sentence = |(words, key): (&String, &Option<String>)| {
        let stop = if words.ends_with(['.', '!', '?']) {
            ""
        } else {
            "."
        };
        let words = match key {
            Some(key) => format!("{key}: {words}{stop}"),
            None => format!("{words}{stop}"),
        };
        charset.text(&words).into_owned()
    };
    let sentences: Vec<String> = prompts.iter().zip(keys).map(sentence).collect();
    let from = lines.written();
    let rows = lines.hung("", &sentences.join(" ")).1;
    // The written rows differ from the text only in their spaces, so only the other characters are
    // counted.
    let letters = |text: &str| text.chars().filter(|c| !c.is_whitespace()).count();
    let mut end = 0;
    for (number, sentence) in sentences.iter().enumerate() {
        let own = end..end + letters(sentence);
        end = own.end;
        let mut before = 0;
        let mut first = None;
        for (row, text) in (from..).zip(&rows) {
            let mut columns: Option<Range<u16>> = None;
            // The first column of a panel is its margin.
            let mut column = 1;
            for letter in text.chars() {
                let next = column + text::width(letter.encode_utf8(&mut [0; 4])) as u16;
                if !letter.is_whitespace() {
                    if own.contains(&before) {
                        columns = Some(columns.map_or(column, |it| it.start)..next);
                    }
                    before += 1;
                }
                column = next;
            }
            if let Some(columns) = columns {
                first.get_or_insert((columns.start - 1, row));
                take(row..row + 1, columns, number);
            }
        }
        lines.record_prompt(&prompts[number], keys[number].clone(), first);
    }
    lines.unrecorded(|lines| lines.paragraph(&sentences.join(" "), Role::Key));
}

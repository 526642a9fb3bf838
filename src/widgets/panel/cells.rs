//! The layout of panels in cells: how many rows each block has, which blocks fit, and which cells
//! can be clicked.

use std::iter;
use std::ops::Range;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use unicode_segmentation::UnicodeSegmentation;

use super::pages::PlacedPages;
use super::{Beside, Block, Content, Panel, TableColumn, TableRow, board};
use crate::widgets::bar::stretch;
use crate::widgets::flow::Run;
use crate::widgets::{Charset, Lines, Look, Role, Room, Words, areas, formula, text};

/// How a panel is written: its glyphs and colours, and the labels of keys.
pub(crate) struct Writing<'k, A> {
    pub look: Look,
    /// The labels of the keys that go back and forward one page, if there are such keys.
    pub pages: Option<[String; 2]>,
    /// Returns the label of an action's key.
    pub key: &'k dyn Fn(&A) -> Option<String>,
}

/// A panel after layout: the blocks that fit, with their positions.
#[derive(Default)]
pub(crate) struct Placed<'p> {
    /// The blocks that stay visible above the text.
    head: PanelPart<'p>,
    /// The text, which can be scrolled.
    body: PanelPart<'p>,
    /// The blocks that stay visible below the text.
    foot: PanelPart<'p>,
    /// The first row of the selected item.
    pub(crate) chosen: Option<u16>,
    /// Whether the selected item belongs to a list rather than being a setting.
    pub(crate) is_list: bool,
    /// The height, in rows, of the area in which the panel was laid out.
    whole: u16,
    /// The pages in large letters, if the panel is read page by page.
    pages: Option<PlacedPages<'p>>,
}

/// Consecutive blocks, and the cells that can be clicked, counted from the first row of the part.
#[derive(Default)]
struct PanelPart<'p> {
    area: Rect,
    blocks: Vec<PlacedBlock<'p>>,
    targets: Vec<(Rect, ActionAt)>,
    rows: u16,
}

impl<'p> PanelPart<'p> {
    /// Adds a block below the others.
    fn push(&mut self, block: PlacedBlock<'p>) {
        let targets = block.targets.iter().map(|(cells, action)| {
            let y = self.rows + cells.y;
            (Rect { y, ..*cells }, *action)
        });
        self.targets.extend(targets);
        self.rows += block.rows;
        self.blocks.push(block);
    }

    /// The cells of the screen that can be clicked if the part is scrolled by `scrolled` rows.
    fn targets(&self, scrolled: u16) -> impl Iterator<Item = (Rect, ActionAt)> + '_ {
        let area = self.area;
        self.targets.iter().filter_map(move |(cells, action)| {
            let top = cells.y.saturating_sub(scrolled);
            let height = cells.bottom().checked_sub(scrolled)? - top;
            let seen = Rect::new(area.x + cells.x, area.y + top, cells.width, height);
            let seen = seen.intersection(area);
            (!seen.is_empty()).then_some((seen, *action))
        })
    }

    /// Draws this part of a panel, scrolled by `scrolled` rows; the panel has `whole` rows in all.
    fn draw(&self, scrolled: u16, whole: u16, buf: &mut Buffer, look: Look) {
        let mut lines = Lines::new(self.area, buf, look).of_panel(whole, scrolled);
        for block in &self.blocks {
            block.write(&mut lines);
        }
    }
}

/// A block with its size.
struct PlacedBlock<'p> {
    block: &'p Block,
    /// For each action, the label of its key; `None` if the action has no key or the label is not
    /// shown.
    keys: Vec<Option<String>>,
    /// The number of rows.
    rows: u16,
    /// The cells that can be clicked, counted from the first row of the block.
    targets: Vec<(Rect, ActionAt)>,
}

/// The position of an action in a panel: the index of the block, and the index of the action in the
/// block.
pub(super) type ActionAt = (usize, usize);

impl<A: Copy> Panel<A> {
    /// Lays the panel out in `area`; a panel that is too long can be scrolled.
    pub(crate) fn placed(&self, area: Rect, writing: &Writing<A>) -> Placed<'_> {
        let mut scratch = Buffer::empty(area);
        let mut lines = Lines::unseen(area, &mut scratch, writing.look);
        let blocks = self.blocks.iter().enumerate();
        let blocks = blocks.map(|(number, (block, actions))| {
            let keys = match block.content {
                Content::Prompts(_) => actions.iter().map(writing.key).collect(),
                _ => vec![None; actions.len()],
            };
            let mut placed = PlacedBlock {
                block,
                keys,
                rows: 0,
                targets: Vec::new(),
            };
            let top = lines.written();
            placed.write(&mut lines);
            placed.rows = lines.written() - top;
            let targets = lines.targets.drain(..).map(|(cells, own)| {
                let y = cells.y - top;
                (Rect { y, ..cells }, (number, own))
            });
            placed.targets = targets.collect();
            placed
        });
        let below = self.below.unwrap_or(self.blocks.len());
        let mut placed = placed(blocks.collect(), self.pinned..below, area);
        if self.open && placed.overflow() > 0 {
            // The note that there is more text has a separate row.
            placed.body.area.height = placed.body.area.height.saturating_sub(1);
        }
        placed
    }

    /// Lays the panel out on pages in large letters beside a picture, on a screen whose body has
    /// `body_rows` rows; `None` if any letter has no large form or the text does not fit.
    pub(crate) fn paged(
        &self,
        beside: Beside,
        room: Room,
        body_rows: u16,
        writing: &Writing<A>,
    ) -> Option<Placed<'_>> {
        let pages = PlacedPages::new(self, beside, room, body_rows, &writing.look)?;
        Some(Placed {
            pages: Some(pages),
            ..Placed::empty(room.area)
        })
    }

    /// The action at this position, which is triggered by clicking its target.
    pub(crate) fn action(&self, (block, own): ActionAt) -> Option<A> {
        let (_, actions) = self.blocks.get(block)?;
        actions.get(own).copied()
    }
}

/// Lays out blocks; the blocks in `middle` can be scrolled.
fn placed(blocks: Vec<PlacedBlock<'_>>, middle: Range<usize>, area: Rect) -> Placed<'_> {
    let is_shown = with_room(&blocks, area.height);
    let rows = |part: &[PlacedBlock]| -> u16 { part.iter().map(|it| it.rows).sum() };
    let head = rows(&blocks[..middle.start]);
    // An empty row separates the foot from the blocks above.
    let foot = match rows(&blocks[middle.end..]) {
        0 => 0,
        rows => rows + 1,
    };
    // If there is hardly any room left for the middle, the head and the foot are scrolled too.
    let (head, foot, middle) = match head + foot + LEAST <= area.height {
        true => (head, foot, middle),
        false => (0, 0, 0..blocks.len()),
    };
    let [above, rest] = areas::upper(area, head);
    let [area, _] = areas::upper(rest, rest.height - foot);
    let mut placed = Placed {
        whole: area.height + head + foot,
        ..Placed::empty(area)
    };
    let mut after_gap = true;
    for (number, (block, shown)) in blocks.into_iter().zip(is_shown).enumerate() {
        if number < middle.start {
            placed.head.push(block);
            continue;
        }
        if number >= middle.end {
            placed.foot.push(block);
            continue;
        }
        let content = &block.block.content;
        let is_gap = matches!(content, Content::Gap);
        // Adjacent gaps are reduced to one, and gaps at the top are removed.
        if !shown || is_gap && after_gap {
            continue;
        }
        after_gap = is_gap;
        if block.block.chosen == Some(true) {
            placed.chosen = Some(placed.body.rows);
            let sets = matches!(content, Content::Field { .. } | Content::TextField { .. });
            placed.is_list = !sets;
        }
        placed.body.push(block);
    }
    let body_rows = placed.body.rows.min(area.height);
    placed.head.area = above;
    placed.foot.area = areas::upper(rest, body_rows + u16::from(foot > 0))[1];
    placed
}

/// For each block, whether it is shown in a panel of this height.
fn with_room(blocks: &[PlacedBlock], height: u16) -> Vec<bool> {
    let worth = |it: &PlacedBlock| it.block.worth;
    let of = |own: Option<u8>| -> u16 {
        let blocks = blocks.iter().filter(|it| worth(it) == own);
        blocks.map(|it| it.rows).sum()
    };
    let mut worths: Vec<_> = blocks.iter().filter_map(worth).collect();
    worths.sort_unstable_by(|a, b| b.cmp(a));
    worths.dedup();
    let mut spare = height.saturating_sub(of(None));
    worths.retain(|worth| {
        let needed = of(Some(*worth));
        let fits = needed <= spare;
        spare -= if fits { needed } else { 0 };
        fits
    });
    let shown = |block| worth(block).is_none_or(|worth| worths.contains(&worth));
    blocks.iter().map(shown).collect()
}

impl<'p> Placed<'p> {
    fn empty(area: Rect) -> Self {
        let body = PanelPart {
            area,
            ..PanelPart::default()
        };
        Self {
            body,
            whole: area.height,
            ..Self::default()
        }
    }

    /// This panel, which must have no fixed blocks, in another area of the same width.
    #[must_use]
    pub(crate) fn moved(mut self, area: Rect) -> Self {
        self.body.area = area;
        self
    }

    /// The pages, if the panel is read page by page.
    pub(crate) fn pages(&self) -> Option<&PlacedPages<'p>> {
        self.pages.as_ref()
    }

    /// The number of rows in the scrollable text.
    pub(crate) fn rows(&self) -> u16 {
        self.body.rows
    }

    /// The number of rows that do not fit into the area; if there are pages, the number of pages
    /// after the first.
    pub(crate) fn overflow(&self) -> u16 {
        match &self.pages {
            Some(pages) => pages.count().saturating_sub(1),
            None => self.body.rows.saturating_sub(self.body.area.height),
        }
    }

    /// The scroll position until the player scrolls: if not everything fits, the selected item is
    /// as near to the middle as possible.
    pub(crate) fn following(&self) -> u16 {
        let above = self.body.area.height / 2;
        let first = self.chosen.unwrap_or(0).saturating_sub(above);
        first.min(self.overflow())
    }

    /// The cells that can be clicked and their actions, with the text scrolled by `scrolled` rows.
    pub(crate) fn targets(&self, scrolled: u16) -> impl Iterator<Item = (Rect, ActionAt)> + '_ {
        let targets = self.head.targets(0).chain(self.body.targets(scrolled));
        let targets = targets.chain(self.foot.targets(0));
        let pages = self.pages.iter();
        targets.chain(pages.flat_map(move |pages| pages.targets(scrolled)))
    }

    /// Draws the panel, scrolled by `scrolled` rows. If the panel does not fit, a hint below it
    /// names the key that shows more or, at the end, the key that goes back.
    pub(crate) fn draw<A>(&self, scrolled: u16, buf: &mut Buffer, writing: &Writing<A>) {
        if let Some(pages) = &self.pages {
            return pages.draw(scrolled, buf, writing);
        }
        for (part, scrolled) in [(&self.head, 0), (&self.body, scrolled), (&self.foot, 0)] {
            part.draw(scrolled, self.whole, buf, writing.look);
        }
        if let (Some([back, on]), 1..) = (&writing.pages, self.overflow()) {
            let hint = match scrolled < self.overflow() {
                true => format!(" {on}: more "),
                false => format!(" {back}: back "),
            };
            text::hint_below(self.body.area, buf, writing.look, &hint);
        }
    }
}

impl PlacedBlock<'_> {
    /// Writes the block, with the cells that can be clicked.
    fn write(&self, lines: &mut Lines) {
        let Some(chosen) = self.block.chosen else {
            return write_content(self, lines);
        };
        let action = (!self.keys.is_empty()).then_some(0);
        lines.item(Some(chosen), action, |lines| write_content(self, lines));
    }
}

fn write_content(PlacedBlock { block, keys, .. }: &PlacedBlock, lines: &mut Lines) {
    let chosen = block.chosen;
    match &block.content {
        Content::Gap | Content::PageBreak => lines.gap(),
        Content::Large(texts, from) => lines.large(texts, *from),
        Content::LargeText(text) => {
            let words = |charset| text.words(charset);
            lines.written_as(words, |lines| lines.paragraph(&text.text, text.role));
            lines.gap();
        }
        Content::Board(rows) => board::write(rows, lines),
        Content::Line(run) => lines.line(&run.text, run.role),
        Content::Paragraph(mark, run) => lines.hanging(mark, &run.text, run.role),
        Content::Code(share) => {
            let text = format!("{}: {}", share.text, share.command);
            let words = |_| Words::Code(share.clone());
            lines.written_as(words, |lines| lines.paragraph(&text, Role::Dim));
        }
        Content::Fact(name, value) => lines.pair(name, value),
        Content::Columns(name, values) => lines.columns(&marked(name, chosen), values),
        Content::Row(name, side) => {
            let name = marked(name, chosen);
            // The name takes precedence over the text beside it.
            let room = usize::from(lines.width()).saturating_sub(text::width(&name.text) + 2);
            let shown = Some(&side.text).filter(|side| text::width(side) <= room);
            let (_, role) = side.role.of_choice(chosen == Some(true));
            lines.pair(&name, &Run::new(shown.map_or("", String::as_str), role));
        }
        Content::Entry {
            letter,
            name,
            about,
        } => {
            let recorded = |charset: Charset| Words::Pair {
                name: name.spelt(charset),
                value: Run::new(about, Role::Dim).spelt(charset),
            };
            let named = Run::new(format!("{letter}  {}", name.text), name.role);
            let Run { mut text, role, .. } = marked(&named, chosen);
            let room = usize::from(lines.width()).saturating_sub(ENTRY);
            if text::width(about) <= room && !about.is_empty() {
                text = format!("{text:ENTRY$}{about}");
            }
            lines.written_as(recorded, |lines| lines.line(&text, role));
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
            locked,
        } => {
            let shown = marked(name, chosen);
            let value = match (locked, shown.role) {
                (true, role) => Run::new(format!("({value})"), role),
                (false, Role::Dim) => Run::new(value, Role::Text),
                (false, role) => Run::new(value, role),
            };
            let words = |charset: Charset| Words::Field {
                name: charset.text(&name.text).into_owned(),
                value: charset.text(&value.text).into_owned(),
                locked: *locked,
            };
            lines.written_as(words, |lines| lines.pair(&shown, &value));
        }
        Content::Meter { name, share, value } => {
            let gaps = if name.is_empty() { 2 } else { 4 };
            let beside = text::width(name) + text::width(value).max(SHARE) + gaps;
            let width = lines.width().saturating_sub(beside as u16);
            let value = Run::new(value, Role::Text);
            lines.meter(name, *share, Role::Text, width, &value);
        }
        Content::Gauge {
            share,
            value,
            role,
            meant: (from, to),
            name,
        } => {
            let widest = lines.width().min(LONGEST_GAUGE);
            let width = widest.saturating_sub(BESIDE_GAUGE);
            lines.meter("", *share, *role, width, &Run::new(value, Role::Text));
            let shares = format!("from {:.0} to {:.0} %", 100.0 * from, 100.0 * to);
            let stretch = stretch(*from, *to, width, lines.charset());
            let [name, shares, stretch] =
                [name, &shares, &stretch].map(|it| Run::new(it, Role::Dim));
            let words = |_| Words::Pair {
                name: name.clone(),
                value: shares,
            };
            lines.written_as(words, |lines| lines.pair(&stretch, &name));
        }
        Content::Choice(letter, text) => {
            let mark = marked(&Run::new(format!("{letter} "), Role::Text), chosen);
            match text.as_slice() {
                [run] => lines.hanging(&mark.text, &run.text, mark.role),
                runs => lines.flowing(&mark.text, 4, runs),
            }
        }
        Content::TextField {
            label,
            typed: [before, after],
        } => {
            let is_chosen = chosen == Some(true);
            let cursor = if is_chosen { "_" } else { "" };
            let beside = MARK + text::width(label).max(LABEL) + 1;
            let room = usize::from(lines.width()).saturating_sub(beside);
            // A long text is shown up to the cursor.
            let seen = match is_chosen {
                true => end_of(before, room),
                false => before,
            };
            let row = format!("{label:LABEL$}{seen}{cursor}{after} ");
            let row = marked(&Run::new(row, Role::Text), chosen);
            let name = label.trim_end().trim_end_matches(':');
            let words = |_| Words::TextField {
                name: name.to_owned(),
                value: format!("{before}{after}"),
            };
            lines.written_as(words, |lines| lines.line(&row.text, row.role));
        }
        Content::Table {
            columns,
            rows,
            leaves,
        } => write_table(columns, rows, *leaves, lines),
        Content::Prompts(prompts) => write_prompts(prompts, keys, lines),
        Content::Tabs { names, open } => write_tabs(names, *open, lines),
        Content::Grid { cells, chosen } => write_grid(cells, *chosen, lines),
    }
}

/// The longest end of a text that fits into this number of columns.
fn end_of(text: &str, columns: usize) -> &str {
    let mut ends = text.grapheme_indices(true).map(|(at, _)| &text[at..]);
    ends.find(|end| text::width(end) <= columns).unwrap_or("")
}

/// Text, preceded by its mark if it is one of several items.
fn marked(run: &Run, chosen: Option<bool>) -> Run {
    match chosen.map(|chosen| run.role.of_choice(chosen)) {
        Some((mark, role)) => Run::new(format!("{mark} {}", run.text), role),
        None => run.clone(),
    }
}

/// Writes the names of several tabs side by side.
fn write_tabs(names: &[String], open: usize, lines: &mut Lines) {
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
        let cells = Rect::new(column + 1, row, end - column, 1);
        lines.targets.push((cells, i));
        column = end + BETWEEN_TABS;
    }
    lines.unrecorded(|lines| lines.line("", Role::Text));
}

/// Writes names side by side, as many in a row as fit. If there are too many rows, only some of
/// them are shown, including the row of the selected name or, if there is none, the last.
fn write_grid(cells: &[[String; 2]], chosen: Option<usize>, lines: &mut Lines) {
    let widest = cells.iter().map(|[name, _]| text::width(name)).max();
    let widest = widest.unwrap_or(0) + BESIDE_NAME;
    let width = usize::from(lines.width() + 1);
    let per_row = (width / widest).max(1);
    let most = usize::from(lines.whole()) * MOST_ROWS / 10;
    let rows: Vec<_> = cells.chunks(per_row).enumerate().collect();
    let last = cells.len().saturating_sub(1);
    let at = chosen.map_or(last, |at| at.min(last)) / per_row;
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
            lines
                .targets
                .push((Rect::new(start, top, column, 1), number));
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

/// The width of the mark of an item, including the space after it, in columns.
const MARK: usize = 2;
/// The minimum width of a text field's label, including the space after it, in columns.
const LABEL: usize = 8;

/// The number of columns between adjacent tabs.
const BETWEEN_TABS: u16 = 2;

/// The width of the mark, the letter and the name in a line of a menu, in columns.
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
) {
    let width = lines.width();
    let gap = if width >= WIDE_TABLE { "   " } else { "" };
    let charset = lines.charset();
    let written = |mark: &str, cells: &[String]| {
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
    let recorded = |cells: &[String], role: Role| {
        let shown = columns.iter().zip(cells);
        let shown = shown.filter(|(column, _)| width >= column.room && !column.drawn);
        let mut runs = shown.map(|(_, cell)| Run::new(cell, role).spelt(charset));
        Words::Columns {
            name: runs.next().unwrap_or_else(|| Run::new("", role)),
            values: runs.collect(),
        }
    };
    let heads: Vec<_> = columns.iter().map(|column| column.head.clone()).collect();
    // Only rows with an action can be selected.
    let has_marks = rows.iter().any(|row| row.action.is_some());
    let head = written(if has_marks { " " } else { "" }, &heads);
    let words = |_| recorded(&heads, Role::Dim);
    lines.written_as(words, |lines| lines.line(&head, Role::Dim));
    let most = leaves.map(|leaves| usize::from(lines.whole().saturating_sub(leaves + 1).max(3)));
    let most = most.unwrap_or(rows.len());
    let chosen = rows.iter().position(|row| row.chosen).unwrap_or(0);
    let first = chosen.saturating_sub(most / 2);
    let first = first.min(rows.len().saturating_sub(most));
    for (own, row) in rows.iter().enumerate().skip(first).take(most) {
        let (mark, role) = row.role.of_choice(row.chosen);
        let line = written(if has_marks { mark } else { "" }, &row.cells);
        let words = |_| recorded(&row.cells, row.role);
        let (chosen, action) = row.action.map(|()| (row.chosen, own)).unzip();
        lines.item(chosen, action, |lines| {
            lines.written_as(words, |lines| lines.line(&line, role));
        });
    }
}

/// Writes the possible next actions as running text, each with its key and its description.
fn write_prompts(prompts: &[String], keys: &[Option<String>], lines: &mut Lines) {
    let charset = lines.charset();
    let sentence = |(words, key): (&String, &Option<String>)| {
        let has_stop = words.ends_with(['.', '!', '?']);
        let stop = if has_stop { "" } else { "." };
        let key = key.as_ref().map_or(String::new(), |key| format!("{key}: "));
        charset.text(&format!("{key}{words}{stop}")).into_owned()
    };
    let sentences: Vec<String> = prompts.iter().zip(keys).map(sentence).collect();
    let from = lines.written();
    let rows = lines.hung("", &sentences.join(" ")).1;
    // The written rows differ from the text only in their spaces, so spaces are not counted.
    let letters = |text: &str| text.chars().filter(|c| !c.is_whitespace()).count();
    let owners = sentences.iter().enumerate();
    let mut owners = owners.flat_map(|(own, text)| iter::repeat_n(own, letters(text)));
    let mut places: Vec<Vec<Rect>> = vec![Vec::new(); sentences.len()];
    for (row, text) in (from..).zip(&rows) {
        // The first column of a panel is its margin.
        let mut column = 1;
        for letter in text.chars() {
            let width = text::width(letter.encode_utf8(&mut [0; 4])) as u16;
            if !letter.is_whitespace()
                && let Some(places) = owners.next().and_then(|own| places.get_mut(own))
            {
                match places.last_mut().filter(|place| place.y == row) {
                    Some(place) => place.width = column + width - place.x,
                    None => places.push(Rect::new(column, row, width, 1)),
                }
            }
            column += width;
        }
    }
    for (own, places) in places.into_iter().enumerate() {
        let first = places.first().map(|place| (place.x - 1, place.y));
        lines.record_prompt(&prompts[own], keys[own].clone(), first);
        let places = places.into_iter();
        lines.targets.extend(places.map(|place| (place, own)));
    }
    lines.unrecorded(|lines| lines.paragraph(&sentences.join(" "), Role::Key));
}

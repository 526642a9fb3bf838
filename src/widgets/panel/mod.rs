//! The text beside a picture, as a list of blocks that describe the meaning of the text and the
//! actions triggered by clicks, but not the positions of letters. [`cells`] lays a panel out and
//! draws it.

mod board;
mod cells;
mod pages;
#[cfg(test)]
mod tests;

pub(crate) use board::BoardRow;
pub(crate) use cells::{Placed, Writing};
pub(crate) use pages::{Beside, PlacedPages};

use cells::ActionAt;

use crate::lessons::Formula;
use crate::widgets::Role;
use crate::widgets::flow::Run;
use crate::widgets::sheet::Share;

/// A list of blocks under a title, from top to bottom; `A` is the type of their actions.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Panel<A> {
    /// The title on the frame; empty for none.
    pub title: String,
    /// A number that identifies the panel's subject: when it changes, the scroll position is reset.
    pub subject: usize,
    /// Whether the panel starts at the top instead of following the selected item.
    pub(crate) from_top: bool,
    /// Whether the first page of large text must show everything, or at least all choices, in
    /// smaller letters if necessary.
    pub(crate) together: bool,
    /// Whether the panel stays scrolled when it is shown again.
    pub(crate) stays: bool,
    /// Whether the panel has no frame.
    pub(crate) open: bool,
    /// The blocks, each with the actions triggered by clicks: none or one for most blocks, but one
    /// for each tab, each name in a grid, each row of a table that can be selected, and each prompt.
    blocks: Vec<(Block, Vec<A>)>,
    /// The number of blocks at the top that stay visible when the panel is scrolled.
    pinned: usize,
    /// The index of the first block that stays visible at the bottom, if any do.
    below: Option<usize>,
    /// The priority of the blocks that are being written.
    worth: Option<u8>,
}

/// A block of a panel, with its priority.
#[derive(Debug, Clone, PartialEq)]
struct Block {
    content: Content,
    /// Whether this is the selected one of several items; `None` if it cannot be selected.
    chosen: Option<bool>,
    /// If not all blocks fit, those with the highest priority are kept. Blocks of the same priority
    /// are either all shown or all left out; a block without a priority is always shown.
    worth: Option<u8>,
}

/// The content of a block.
#[derive(Debug, Clone, PartialEq)]
enum Content {
    /// An empty row after the block above.
    Gap,
    /// Short text in large letters if the panel has at least the given number of rows; the first of
    /// the strings that fits is used.
    Large(Vec<String>, u16),
    /// Text in the largest letters that fit.
    LargeText(LargeText),
    /// Starts a new page in a panel with [`LargeText`].
    PageBreak,
    /// Names side by side, each with a sign, in several rows if necessary.
    Grid {
        cells: Vec<[String; 2]>,
        chosen: Option<usize>,
    },
    /// Names with their scores, large if there is room.
    Board(Vec<BoardRow>),
    /// Short text in a single row.
    Line(Run),
    /// Text that is wrapped over several rows, all indented to the right of a mark, which may be
    /// empty.
    Paragraph(String, Run),
    /// Something to share.
    Code(Share),
    /// The name of a quantity, and its value.
    Fact(Run, Run),
    /// One row of a table, which may be one of several items: a name, and a value for each column.
    Columns(Run, Vec<Run>),
    /// An item of a list, in a single row: its name, and the text at the right edge.
    Row(Run, Run),
    /// A line of a menu: the letter that opens it, the name, and, if there is room, the
    /// description.
    Entry {
        letter: char,
        name: Run,
        about: String,
    },
    /// The names of several tabs in one row, one of which is open.
    Tabs { names: Vec<String>, open: usize },
    /// Text in more than one style, after an optional mark.
    Flow(String, Vec<Run>),
    /// A formula, which may have several rows.
    Formula(Formula, Role),
    /// A line of working: it may be broken before an operator, and the continuation is indented.
    Working(String),
    /// A setting.
    Field {
        name: Run,
        value: String,
        locked: bool,
    },
    /// A fraction between 0 and 1, as a bar.
    Meter {
        name: String,
        share: f64,
        value: String,
    },
    /// A fraction between 0 and 1, and its target range, each with a description.
    Gauge {
        share: f64,
        value: String,
        role: Role,
        meant: (f64, f64),
        name: String,
    },
    /// One of several answers, with its letter.
    Choice(char, Vec<Run>),
    /// A text field, with the text before and after the cursor, which is visible while the field is
    /// selected.
    TextField { label: String, typed: [String; 2] },
    /// Rows of cells under column headings; rows can be selected.
    Table {
        columns: Vec<TableColumn>,
        rows: Vec<TableRow<()>>,
        /// The number of panel rows that a long table leaves free; only the part around the
        /// selected row is shown.
        leaves: Option<u16>,
    },
    /// The possible next actions, the most likely first.
    Prompts(Vec<String>),
}

/// Text large enough for the back row of a class.
#[derive(Debug, Clone, PartialEq)]
struct LargeText {
    text: String,
    role: Role,
    /// Whether the text must stay on one page.
    whole: bool,
    /// The fraction that a bar below the text shows, if there is a bar.
    share: Option<f64>,
}

/// A column of a [`Content::Table`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct TableColumn {
    /// The heading above the cells.
    pub head: String,
    /// The minimum width of the column, in terminal cells.
    pub width: u16,
    /// Whether the cells are right-aligned, as numbers are.
    pub(crate) flush_right: bool,
    /// The minimum width, in terminal cells, of a panel that shows the column.
    pub room: u16,
    /// Whether the cells are graphics that repeat the information in other cells.
    pub drawn: bool,
}

impl TableColumn {
    /// A column of text, with a heading and a minimum width in terminal cells.
    pub(crate) fn words(head: &str, width: u16) -> Self {
        Self {
            head: head.into(),
            width,
            flush_right: false,
            room: 0,
            drawn: false,
        }
    }

    /// A column of numbers, with a heading and a minimum width in terminal cells.
    pub(crate) fn numbers(head: &str, width: u16) -> Self {
        Self {
            flush_right: true,
            ..Self::words(head, width)
        }
    }

    /// This column, but shown only in panels that are at least `room` terminal cells wide.
    pub(crate) fn from(self, room: u16) -> Self {
        Self { room, ..self }
    }
}

/// A row of a [`Content::Table`].
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TableRow<A> {
    /// A cell for each column.
    pub cells: Vec<String>,
    /// The role of the text unless the row is selected.
    pub role: Role,
    /// Whether the row is selected.
    pub chosen: bool,
    /// The action triggered by clicking the row.
    pub action: Option<A>,
}

impl<A> TableRow<A> {
    /// A row that cannot be selected.
    pub(crate) fn of(cells: Vec<String>, role: Role) -> Self {
        Self {
            cells,
            role,
            chosen: false,
            action: None,
        }
    }

    /// Separates the row from the action triggered by clicking it.
    fn apart(self) -> (TableRow<()>, Option<A>) {
        let row = TableRow {
            cells: self.cells,
            role: self.role,
            chosen: self.chosen,
            action: self.action.as_ref().map(|_| ()),
        };
        (row, self.action)
    }
}

impl<A> Panel<A> {
    /// Creates an empty panel with a title.
    pub(crate) fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            subject: 0,
            from_top: false,
            together: false,
            stays: false,
            open: false,
            blocks: Vec::new(),
            pinned: 0,
            below: None,
            worth: None,
        }
    }

    fn push(&mut self, content: Content) {
        self.push_with(content, None, []);
    }

    fn push_with(
        &mut self,
        content: Content,
        chosen: Option<bool>,
        actions: impl IntoIterator<Item = A>,
    ) {
        let block = Block {
            content,
            chosen,
            worth: self.worth,
        };
        self.blocks.push((block, actions.into_iter().collect()));
    }

    /// Writes blocks that are left out unless all blocks of this priority fit.
    pub(crate) fn worth(&mut self, worth: u8, write: impl FnOnce(&mut Self)) {
        let around = self.worth.replace(worth);
        write(self);
        self.worth = around;
    }

    /// Keeps the blocks written so far visible when the rest is scrolled.
    pub(crate) fn pin(&mut self) {
        self.pinned = self.blocks.len();
    }

    /// Keeps the following blocks visible, below the scrolling ones.
    pub(crate) fn pin_below(&mut self) {
        self.below = Some(self.blocks.len());
    }

    /// Writes a part that has actions of its own, and converts them to the panel's actions.
    pub(crate) fn part<B>(&mut self, wrap: impl Fn(B) -> A, write: impl FnOnce(&mut Panel<B>)) {
        let mut part = Panel::new("");
        write(&mut part);
        let worth = self.worth;
        let blocks = part.blocks.into_iter().map(|(mut block, actions)| {
            block.worth = block.worth.or(worth);
            (block, actions.into_iter().map(&wrap).collect())
        });
        self.blocks.extend(blocks);
    }

    /// Adds an empty row after the block above, if there is one.
    pub(crate) fn gap(&mut self) {
        self.push(Content::Gap);
    }

    /// Adds a heading for the next blocks, in a single row.
    pub(crate) fn heading(&mut self, text: impl Into<String>) {
        self.line(text, Role::Title);
    }

    /// Adds text that is legible from a distance if the panel has at least `from` rows: the first
    /// of the `texts` that fits in large letters.
    pub(crate) fn large<'t>(&mut self, texts: impl IntoIterator<Item = &'t str>, from: u16) {
        let texts = texts.into_iter().map(str::to_owned).collect();
        self.push(Content::Large(texts, from));
    }

    /// Adds text that must be legible from the back row, in the largest letters that fit.
    pub(crate) fn large_text(&mut self, text: impl Into<String>, role: Role) {
        self.push(Content::LargeText(LargeText {
            text: text.into(),
            role,
            whole: false,
            share: None,
        }));
    }

    /// Adds a choice in the largest letters that fit, with the fraction of people who chose it and
    /// the action triggered by clicking it.
    pub(crate) fn large_choice(
        &mut self,
        text: impl Into<String>,
        share: Option<f64>,
        action: Option<A>,
    ) {
        let content = Content::LargeText(LargeText {
            text: text.into(),
            role: Role::Text,
            whole: true,
            share,
        });
        self.push_with(content, Some(false), action);
    }

    /// Starts a new page in a panel with large text.
    pub(crate) fn page_break(&mut self) {
        self.push(Content::PageBreak);
    }

    /// Adds names side by side, each with a sign and the action triggered by clicking it.
    pub(crate) fn grid(
        &mut self,
        cells: impl IntoIterator<Item = ([String; 2], A)>,
        chosen: Option<usize>,
    ) {
        let (cells, actions): (_, Vec<A>) = cells.into_iter().unzip();
        self.push_with(Content::Grid { cells, chosen }, None, actions);
    }

    /// Adds names with their scores, in the largest letters that fit.
    pub(crate) fn board(&mut self, rows: Vec<BoardRow>) {
        self.push(Content::Board(rows));
    }

    /// Adds short text in a single row.
    pub(crate) fn line(&mut self, text: impl Into<String>, role: Role) {
        self.push(Content::Line(Run::new(text, role)));
    }

    /// Adds text that is wrapped over several rows.
    pub(crate) fn paragraph(&mut self, text: impl Into<String>, role: Role) {
        self.marked("", text, role);
    }

    /// Adds a notice that says what is wrong, if there is one.
    pub(crate) fn warning(&mut self, notice: Option<&str>) {
        if let Some(notice) = notice {
            self.paragraph(notice, Role::Warn);
        }
    }

    /// Adds something to share: a description, the command that opens it, and an address, which the
    /// web page shows as a link.
    pub(crate) fn code(
        &mut self,
        text: impl Into<String>,
        command: impl Into<String>,
        address: impl Into<String>,
    ) {
        self.push(Content::Code(Share {
            text: text.into(),
            command: command.into(),
            address: address.into(),
            is_result: false,
        }));
    }

    /// Adds a result to share, which the web page copies together with its link.
    pub(crate) fn result(&mut self, text: String, command: String, address: String) {
        self.push(Content::Code(Share {
            text,
            command,
            address,
            is_result: true,
        }));
    }

    /// Adds the name of a quantity, and its value.
    pub(crate) fn fact(&mut self, name: impl Into<String>, value: impl Into<String>) {
        self.coloured_fact(name, value, Role::Text);
    }

    /// Adds a name and a value; the value has a colour, such as that of its arrow.
    pub(crate) fn coloured_fact(
        &mut self,
        name: impl Into<String>,
        value: impl Into<String>,
        role: Role,
    ) {
        self.pair((name, Role::Dim), (value, role));
    }

    /// Adds a name and a value, each in its own colour.
    pub(crate) fn pair(&mut self, name: impl Into<Run>, value: impl Into<Run>) {
        self.push(Content::Fact(name.into(), value.into()));
    }

    /// Adds one row of a table: a name, and a value for each column.
    pub(crate) fn columns(
        &mut self,
        name: impl Into<Run>,
        values: impl IntoIterator<Item = impl Into<Run>>,
    ) {
        let values = values.into_iter().map(Into::into).collect();
        self.push(Content::Columns(name.into(), values));
    }

    /// Adds one of several items of a list, with a name, the text at the right edge, and the action
    /// triggered by clicking it.
    pub(crate) fn row(
        &mut self,
        name: impl Into<Run>,
        side: impl Into<Run>,
        chosen: bool,
        action: A,
    ) {
        let content = Content::Row(name.into(), side.into());
        self.push_with(content, Some(chosen), [action]);
    }

    /// Adds a line of a menu, with a letter, a name, a description, and the action triggered by
    /// clicking it.
    pub(crate) fn entry(
        &mut self,
        letter: char,
        (name, about): (impl Into<String>, impl Into<String>),
        (role, chosen): (Role, bool),
        action: A,
    ) {
        let (name, about) = (Run::new(name, role), about.into());
        let content = Content::Entry {
            letter,
            name,
            about,
        };
        self.push_with(content, Some(chosen), [action]);
    }

    /// Adds a row of tabs, one of which is open, each with a name and the action triggered by
    /// clicking it.
    pub(crate) fn tabs<N: Into<String>>(
        &mut self,
        pages: impl IntoIterator<Item = (N, A)>,
        open: usize,
    ) {
        let labelled = |(name, action): (N, A)| (name.into(), action);
        let (names, actions): (_, Vec<A>) = pages.into_iter().map(labelled).unzip();
        self.push_with(Content::Tabs { names, open }, None, actions);
    }

    pub(crate) fn item(&mut self, text: impl Into<String>, role: Role) {
        self.flow("-", vec![Run::new(text, role)]);
    }

    /// Adds text in more than one style, after an optional mark.
    pub(crate) fn flow(&mut self, mark: impl Into<String>, runs: Vec<Run>) {
        self.push(Content::Flow(mark.into(), runs));
    }

    /// Adds a formula on rows of its own.
    pub(crate) fn formula(&mut self, formula: Formula, role: Role) {
        self.push(Content::Formula(formula, role));
    }

    pub(crate) fn working(&mut self, line: impl Into<String>) {
        self.push(Content::Working(line.into()));
    }

    /// Adds a setting, with a name, a value as text, whether it is locked (cannot be changed at
    /// present), and the action triggered by clicking it.
    pub(crate) fn field(
        &mut self,
        name: impl Into<String>,
        (value, locked): (impl Into<String>, bool),
        (role, chosen): (Role, bool),
        action: Option<A>,
    ) {
        let content = Content::Field {
            name: Run::new(name, role),
            value: value.into(),
            locked,
        };
        self.push_with(content, Some(chosen), action);
    }

    /// Adds text after a mark, with all rows indented to the right of the mark.
    pub(crate) fn marked(&mut self, mark: &str, text: impl Into<String>, role: Role) {
        self.push(Content::Paragraph(mark.into(), Run::new(text, role)));
    }

    /// Adds a fraction between 0 and 1, as a bar with its value.
    pub(crate) fn meter(&mut self, name: &str, share: f64, value: impl Into<String>) {
        self.push(Content::Meter {
            name: name.into(),
            share,
            value: value.into(),
        });
    }

    /// Adds a fraction between 0 and 1, as a bar with its value, and a named target range.
    pub(crate) fn gauge(
        &mut self,
        (share, value, role): (f64, impl Into<String>, Role),
        (meant, name): ((f64, f64), impl Into<String>),
    ) {
        self.push(Content::Gauge {
            share,
            value: value.into(),
            role,
            meant,
            name: name.into(),
        });
    }

    /// Adds one of several answers, with a letter and the action triggered by clicking it.
    pub(crate) fn choice(&mut self, letter: char, text: Vec<Run>, chosen: bool, action: A) {
        self.push_with(Content::Choice(letter, text), Some(chosen), [action]);
    }

    /// Adds one of several items of a list, with a value for each column.
    pub(crate) fn choice_columns(
        &mut self,
        name: impl Into<String>,
        values: impl IntoIterator<Item = String>,
        chosen: bool,
        action: A,
    ) {
        let values = values.into_iter().map(|value| Run::new(value, Role::Text));
        let content = Content::Columns(Run::new(name, Role::Text), values.collect());
        self.push_with(content, Some(chosen), [action]);
    }

    /// Adds a text field, with the action triggered by clicking it.
    pub(crate) fn text_field(
        &mut self,
        label: impl Into<String>,
        (before, after): (&str, &str),
        chosen: bool,
        action: Option<A>,
    ) {
        let (label, typed) = (label.into(), [before.into(), after.into()]);
        self.push_with(Content::TextField { label, typed }, Some(chosen), action);
    }

    /// Adds a table with column headings; either all its rows can be selected or none. `leaves` is
    /// the number of panel rows left for other blocks; if it is given, the table may be longer than
    /// the panel, and only the part around the selected row is shown.
    pub(crate) fn table(
        &mut self,
        columns: Vec<TableColumn>,
        rows: Vec<TableRow<A>>,
        leaves: Option<u16>,
    ) {
        let (rows, actions): (_, Vec<_>) = rows.into_iter().map(TableRow::apart).unzip();
        let content = Content::Table {
            columns,
            rows,
            leaves,
        };
        self.push_with(content, None, actions.into_iter().flatten());
    }

    /// Adds a possible next action, with a short description that does not mention the key.
    pub(crate) fn prompt(&mut self, words: impl Into<String>, action: A) {
        self.prompts([(words, action)]);
    }

    /// Adds several possible next actions, most likely first.
    pub(crate) fn prompts<W: Into<String>>(&mut self, prompts: impl IntoIterator<Item = (W, A)>) {
        let labelled = |(words, action): (W, A)| (words.into(), action);
        let (words, actions): (_, Vec<A>) = prompts.into_iter().map(labelled).unzip();
        self.push_with(Content::Prompts(words), None, actions);
    }
}

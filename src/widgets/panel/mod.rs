//! The text beside a picture, as a list of blocks with their meaning and the actions of clicks, but
//! without the positions of letters. [`cells`] lays a panel out and draws it.

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

/// A list of blocks under a title, one below the other; `A` is the type of their actions.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Panel<A> {
    /// The title on the frame; empty for none.
    pub title: String,
    /// The number of the panel's subject: a new number resets the scroll position.
    pub subject: usize,
    /// Whether the panel starts at its top, rather than following the chosen item.
    pub(crate) from_top: bool,
    /// Whether the panel has no frame.
    pub(crate) open: bool,
    blocks: Vec<Block<A>>,
    /// The number of blocks at the top that stay visible when the panel is scrolled.
    pinned: usize,
    /// The index of the first block that stays visible at the bottom, if any do.
    below: Option<usize>,
    /// The priority of the blocks being written.
    worth: Option<u8>,
}

/// One block of a panel.
#[derive(Debug, Clone, PartialEq)]
struct Block<A> {
    content: Content,
    /// The actions of clicks: none or one; for the rows of a table and for prompts, one each.
    actions: Vec<A>,
    /// If there is not room for all blocks, those of the highest priority come first. Either all
    /// blocks of one priority are shown or none; a block without a priority is always shown.
    worth: Option<u8>,
}

/// The content of a block.
#[derive(Debug, Clone, PartialEq)]
enum Content {
    /// An empty row after the block above.
    Gap,
    /// A heading for the next blocks, in one row.
    Heading(String),
    /// Short text in large letters, if the panel has this many rows: the first of these strings
    /// that fits.
    Large(Vec<String>, Role, u16),
    /// Text in the largest letters that fit.
    LargeText(LargeText),
    /// The next block begins a new page, in a panel of [`LargeText`].
    PageBreak,
    /// Names side by side, each with a sign, in as many rows as necessary.
    Grid {
        cells: Vec<[String; 2]>,
        chosen: Option<usize>,
    },
    /// Names with their scores, large if there is room.
    Board(Vec<BoardRow>),
    /// Short text in one row.
    Line(String, Role),
    /// Text that is wrapped over several rows.
    Paragraph(String, Role),
    /// Something to share: its description, the command that opens it, and its address.
    Code {
        text: String,
        command: String,
        address: String,
        /// Whether the page copies the description, too.
        is_result: bool,
    },
    /// The name of a quantity, and its value.
    Fact {
        name: String,
        value: String,
        roles: [Role; 2],
    },
    /// One row of a table: a name, and a value for each column.
    Columns {
        name: (String, Role),
        values: Vec<(String, Role)>,
    },
    /// One of several items to choose from, in one row.
    Row {
        name: String,
        /// The text at the right edge.
        side: String,
        /// The role of the line while another is chosen.
        roles: [Role; 2],
        chosen: bool,
    },
    /// A line of a menu: the letter that opens it, its name, and its description if there is
    /// room.
    Entry {
        letter: char,
        name: String,
        about: String,
        /// The role of the name while another setting is chosen.
        role: Role,
        chosen: bool,
    },
    /// Several pages, one of which is open, in one row.
    Tabs { names: Vec<String>, open: usize },
    /// Text in more than one style, after an optional mark.
    Flow(String, Vec<Run>),
    /// A formula, which may have several rows.
    Formula(Formula, Role),
    /// A line of working: it may be broken before an operator, and the rest is indented.
    Working(String),
    /// A setting.
    Field {
        name: String,
        value: String,
        /// The role of its name while another setting is chosen.
        role: Role,
        chosen: bool,
        locked: bool,
    },
    /// Text after a mark, indented so that nothing is below the mark.
    Marked {
        mark: String,
        text: String,
        role: Role,
    },
    /// A share of a whole, from 0 to 1, as a bar.
    Meter {
        name: String,
        share: f64,
        value: String,
    },
    /// A share of a whole and its target range, each with a description.
    Gauge {
        share: f64,
        value: String,
        role: Role,
        meant: (f64, f64),
        name: String,
    },
    /// One of several answers, with its letter.
    Choice {
        letter: char,
        text: Vec<Run>,
        chosen: bool,
    },
    /// One of several items to choose from, with a value for each column.
    ChoiceColumns {
        name: String,
        values: Vec<String>,
        chosen: bool,
    },
    /// A text field: the text before the cursor and the text after it; the cursor is visible while
    /// the field is chosen.
    TextField {
        label: String,
        typed: [String; 2],
        chosen: bool,
    },
    /// Rows of cells under column headings; each row can be chosen.
    Table {
        columns: Vec<TableColumn>,
        rows: Vec<TableRow<()>>,
        /// The rows of the panel that a long table leaves free: it shows only the part around the
        /// chosen row.
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
    /// Whether it must not be split over pages.
    whole: bool,
    /// The share that a bar below the text shows, if it has one.
    share: Option<f64>,
}

/// A column of a [`Content::Table`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct TableColumn {
    /// Its heading.
    pub head: String,
    /// The number of letters in its widest cell.
    pub width: u16,
    /// Whether its cells are right-aligned, as numbers are.
    pub(crate) flush_right: bool,
    /// The minimum width of the panel at which the column is shown, in columns.
    pub room: u16,
    /// Whether its cells are graphics that repeat the information of other cells.
    pub drawn: bool,
}

impl TableColumn {
    /// A column of text, with its heading and the number of letters in its widest cell.
    pub(crate) fn words(head: &str, width: u16) -> Self {
        Self {
            head: head.into(),
            width,
            flush_right: false,
            room: 0,
            drawn: false,
        }
    }

    /// A column of numbers, with its heading and the number of letters in its widest cell.
    pub(crate) fn numbers(head: &str, width: u16) -> Self {
        Self {
            flush_right: true,
            ..Self::words(head, width)
        }
    }

    /// This column, shown only in panels with at least this many columns.
    pub(crate) fn from(self, room: u16) -> Self {
        Self { room, ..self }
    }
}

/// A row of a [`Content::Table`].
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TableRow<A> {
    /// A cell for each column.
    pub cells: Vec<String>,
    /// The role of its text while another row is chosen.
    pub role: Role,
    /// Whether the row is chosen.
    pub chosen: bool,
    /// The action of a click on the row.
    pub action: Option<A>,
}

impl<A> TableRow<A> {
    /// A row that cannot be chosen.
    pub(crate) fn of(cells: Vec<String>, role: Role) -> Self {
        Self {
            cells,
            role,
            chosen: false,
            action: None,
        }
    }

    /// The row without its action, and the action of a click on it.
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
    /// An empty panel.
    pub(crate) fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            subject: 0,
            from_top: false,
            open: false,
            blocks: Vec::new(),
            pinned: 0,
            below: None,
            worth: None,
        }
    }

    fn push(&mut self, content: Content) {
        self.push_with(content, []);
    }

    fn push_with(&mut self, content: Content, actions: impl IntoIterator<Item = A>) {
        self.blocks.push(Block {
            content,
            actions: actions.into_iter().collect(),
            worth: self.worth,
        });
    }

    /// Writes blocks that are left out if there is no room for all blocks of this priority.
    pub(crate) fn worth(&mut self, worth: u8, write: impl FnOnce(&mut Self)) {
        let around = self.worth.replace(worth);
        write(self);
        self.worth = around;
    }

    /// Keeps the blocks written so far visible when the rest is scrolled.
    pub(crate) fn pin(&mut self) {
        self.pinned = self.blocks.len();
    }

    /// Keeps the following blocks visible below the previous ones when those are scrolled.
    pub(crate) fn pin_below(&mut self) {
        self.below = Some(self.blocks.len());
    }

    /// Writes a part of the panel whose actions are wrapped in the panel's actions.
    pub(crate) fn part<B>(&mut self, wrap: impl Fn(B) -> A, write: impl FnOnce(&mut Panel<B>)) {
        let mut part = Panel::new("");
        write(&mut part);
        let worth = self.worth;
        let blocks = part.blocks.into_iter().map(|block| Block {
            content: block.content,
            actions: block.actions.into_iter().map(&wrap).collect(),
            worth: block.worth.or(worth),
        });
        self.blocks.extend(blocks);
    }

    /// Adds an empty row after the block above, if there is one.
    pub(crate) fn gap(&mut self) {
        self.push(Content::Gap);
    }

    /// Adds a heading for the next blocks.
    pub(crate) fn heading(&mut self, text: impl Into<String>) {
        self.push(Content::Heading(text.into()));
    }

    /// Adds text that can be read from a distance, in a panel of at least this many rows: the first
    /// of these strings that fits in large letters.
    pub(crate) fn large<'t>(
        &mut self,
        texts: impl IntoIterator<Item = &'t str>,
        role: Role,
        from: u16,
    ) {
        let texts = texts.into_iter().map(str::to_owned).collect();
        self.push(Content::Large(texts, role, from));
    }

    /// Adds text for the back row, in the largest letters that fit.
    pub(crate) fn large_text(&mut self, text: impl Into<String>, role: Role) {
        self.push(Content::LargeText(LargeText {
            text: text.into(),
            role,
            whole: false,
            share: None,
        }));
    }

    /// Adds a choice in the largest letters that fit, with the share of people who chose it and the
    /// action of a click.
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
        self.push_with(content, action);
    }

    /// Begins a new page, in a panel of large text.
    pub(crate) fn page_break(&mut self) {
        self.push(Content::PageBreak);
    }

    /// Adds names side by side, each with a sign and the action of a click.
    pub(crate) fn grid(
        &mut self,
        cells: impl IntoIterator<Item = ([String; 2], A)>,
        chosen: Option<usize>,
    ) {
        let (cells, actions): (_, Vec<A>) = cells.into_iter().unzip();
        self.push_with(Content::Grid { cells, chosen }, actions);
    }

    /// Adds names with their scores, in the largest letters that fit.
    pub(crate) fn board(&mut self, rows: Vec<BoardRow>) {
        self.push(Content::Board(rows));
    }

    /// Adds short text in one row.
    pub(crate) fn line(&mut self, text: impl Into<String>, role: Role) {
        self.push(Content::Line(text.into(), role));
    }

    /// Adds text that is wrapped over several rows.
    pub(crate) fn paragraph(&mut self, text: impl Into<String>, role: Role) {
        self.push(Content::Paragraph(text.into(), role));
    }

    /// Adds something to share: its description, the command that opens it, and its address, which
    /// the web page shows as a link.
    pub(crate) fn code(
        &mut self,
        text: impl Into<String>,
        command: impl Into<String>,
        address: impl Into<String>,
    ) {
        self.push(Content::Code {
            text: text.into(),
            command: command.into(),
            address: address.into(),
            is_result: false,
        });
    }

    /// Adds a result to share, which the web page copies together with its link.
    pub(crate) fn result(&mut self, text: String, command: String, address: String) {
        self.push(Content::Code {
            text,
            command,
            address,
            is_result: true,
        });
    }

    /// Adds the name of a quantity, and its value.
    pub(crate) fn fact(&mut self, name: impl Into<String>, value: impl Into<String>) {
        self.coloured_fact(name, value, Role::Text);
    }

    /// Adds a name, and a value in a colour such as that of its arrow.
    pub(crate) fn coloured_fact(
        &mut self,
        name: impl Into<String>,
        value: impl Into<String>,
        role: Role,
    ) {
        self.pair((name, Role::Dim), (value, role));
    }

    /// Adds a name and a value, each in its own colour.
    pub(crate) fn pair(
        &mut self,
        (name, name_role): (impl Into<String>, Role),
        (value, value_role): (impl Into<String>, Role),
    ) {
        self.push(Content::Fact {
            name: name.into(),
            value: value.into(),
            roles: [name_role, value_role],
        });
    }

    /// Adds one row of a table: a name, and a value for each column.
    pub(crate) fn columns<V: Into<String>>(
        &mut self,
        (name, role): (impl Into<String>, Role),
        values: impl IntoIterator<Item = (V, Role)>,
    ) {
        let values = values.into_iter().map(|(value, role)| (value.into(), role));
        self.push(Content::Columns {
            name: (name.into(), role),
            values: values.collect(),
        });
    }

    /// Adds one of several items to choose from: its name, the text at the right edge, and the
    /// action of a click.
    pub(crate) fn row(
        &mut self,
        (name, role): (impl Into<String>, Role),
        (side, side_role): (impl Into<String>, Role),
        chosen: bool,
        action: A,
    ) {
        let content = Content::Row {
            name: name.into(),
            side: side.into(),
            roles: [role, side_role],
            chosen,
        };
        self.push_with(content, [action]);
    }

    /// Adds a line of a menu: its letter, its name, its description, and the action of a click.
    pub(crate) fn entry(
        &mut self,
        letter: char,
        (name, about): (impl Into<String>, impl Into<String>),
        (role, chosen): (Role, bool),
        action: A,
    ) {
        let content = Content::Entry {
            letter,
            name: name.into(),
            about: about.into(),
            role,
            chosen,
        };
        self.push_with(content, [action]);
    }

    /// Adds the names of several pages, one of which is open, and the action of a click on each.
    pub(crate) fn tabs<N: Into<String>>(
        &mut self,
        pages: impl IntoIterator<Item = (N, A)>,
        open: usize,
    ) {
        let pages = pages.into_iter();
        let (names, actions): (_, Vec<A>) =
            pages.map(|(name, action)| (name.into(), action)).unzip();
        self.push_with(Content::Tabs { names, open }, actions);
    }

    pub(crate) fn item(&mut self, text: impl Into<String>, role: Role) {
        self.flow("-", vec![Run::new(text, role)]);
    }

    /// Adds text in more than one style, after an optional mark.
    pub(crate) fn flow(&mut self, mark: impl Into<String>, runs: Vec<Run>) {
        self.push(Content::Flow(mark.into(), runs));
    }

    /// Adds a formula in rows of its own.
    pub(crate) fn formula(&mut self, formula: Formula, role: Role) {
        self.push(Content::Formula(formula, role));
    }

    pub(crate) fn working(&mut self, line: impl Into<String>) {
        self.push(Content::Working(line.into()));
    }

    /// Adds a setting: its name, its value as text, and the action of a click.
    pub(crate) fn field(
        &mut self,
        name: impl Into<String>,
        value: impl Into<String>,
        (role, chosen): (Role, bool),
        action: Option<A>,
    ) {
        let content = Content::Field {
            name: name.into(),
            value: value.into(),
            role,
            chosen,
            locked: false,
        };
        self.push_with(content, action);
    }

    /// Adds a setting that cannot be changed at present.
    pub(crate) fn locked_field(
        &mut self,
        name: impl Into<String>,
        value: impl Into<String>,
        (role, chosen): (Role, bool),
        action: Option<A>,
    ) {
        let content = Content::Field {
            name: name.into(),
            value: value.into(),
            role,
            chosen,
            locked: true,
        };
        self.push_with(content, action);
    }

    /// Adds text after a mark, indented so that nothing is below the mark.
    pub(crate) fn marked(&mut self, mark: &str, text: impl Into<String>, role: Role) {
        self.push(Content::Marked {
            mark: mark.into(),
            text: text.into(),
            role,
        });
    }

    /// Adds a share of a whole, from 0 to 1, as a bar with its value.
    pub(crate) fn meter(&mut self, name: &str, share: f64, value: impl Into<String>) {
        self.push(Content::Meter {
            name: name.into(),
            share,
            value: value.into(),
        });
    }

    /// Adds a share of a whole, from 0 to 1, as a bar with its value, and the named range in which
    /// it should be.
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

    /// Adds one of several answers, with its letter and the action of a click.
    pub(crate) fn choice(&mut self, letter: char, text: Vec<Run>, chosen: bool, action: Option<A>) {
        let content = Content::Choice {
            letter,
            text,
            chosen,
        };
        self.push_with(content, action);
    }

    /// Adds one of several items to choose from, with a value for each column.
    pub(crate) fn choice_columns(
        &mut self,
        name: impl Into<String>,
        values: impl IntoIterator<Item = String>,
        chosen: bool,
        action: A,
    ) {
        let content = Content::ChoiceColumns {
            name: name.into(),
            values: values.into_iter().collect(),
            chosen,
        };
        self.push_with(content, [action]);
    }

    /// Adds a text field, and the action of a click on it.
    pub(crate) fn text_field(
        &mut self,
        label: impl Into<String>,
        (before, after): (&str, &str),
        chosen: bool,
        action: Option<A>,
    ) {
        let content = Content::TextField {
            label: label.into(),
            typed: [before.into(), after.into()],
            chosen,
        };
        self.push_with(content, action);
    }

    /// Adds a table with column headings, in which either every row can be chosen or none can.
    pub(crate) fn table(&mut self, columns: Vec<TableColumn>, rows: Vec<TableRow<A>>) {
        self.push_table(columns, rows, None);
    }

    /// Adds a table that may be longer than the panel: then only the part around the chosen row is
    /// shown, and these rows of the panel stay free for other blocks.
    pub(crate) fn long_table(
        &mut self,
        columns: Vec<TableColumn>,
        rows: Vec<TableRow<A>>,
        leaves: u16,
    ) {
        self.push_table(columns, rows, Some(leaves));
    }

    fn push_table(
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
        self.push_with(content, actions.into_iter().flatten());
    }

    /// Adds a possible next action: a short description without the key, and the action.
    pub(crate) fn prompt(&mut self, words: impl Into<String>, action: A) {
        self.prompts([(words, action)]);
    }

    /// Adds several possible next actions, the most likely first.
    pub(crate) fn prompts<W: Into<String>>(&mut self, prompts: impl IntoIterator<Item = (W, A)>) {
        let prompts = prompts.into_iter();
        let (words, actions): (_, Vec<A>) = prompts
            .map(|(words, action)| (words.into(), action))
            .unzip();
        self.push_with(Content::Prompts(words), actions);
    }
}

impl Content {
    /// Whether the block is chosen.
    fn is_chosen(&self) -> bool {
        match self {
            Self::Field { chosen, .. }
            | Self::Row { chosen, .. }
            | Self::Entry { chosen, .. }
            | Self::Choice { chosen, .. }
            | Self::ChoiceColumns { chosen, .. }
            | Self::TextField { chosen, .. } => *chosen,
            _ => false,
        }
    }
}

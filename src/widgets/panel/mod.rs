//! What stands beside a picture, as a list of blocks: what they mean and what a click on
//! them does, not where their letters are. [`cells`] lays a panel out and draws it.

mod cells;
#[cfg(test)]
mod tests;

pub(crate) use cells::{Placed, Writing, written};

use crate::widgets::Role;
use crate::widgets::flow::Run;

/// A list of blocks under a title, one below the other; `A` is what they can do.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Panel<A> {
    /// Its title, on its frame; empty for none.
    pub title: String,
    /// The number of what it is about: with another one it begins at its top again, however
    /// far it was scrolled.
    pub subject: usize,
    blocks: Vec<Block<A>>,
    /// How many of the blocks, from the first on, stay in sight however far it is scrolled.
    pinned: usize,
    /// The worth of the blocks being written.
    worth: Option<u8>,
}

/// One block of a panel.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Block<A> {
    /// What it is.
    pub content: Content<A>,
    /// Where there is room for some only, blocks of the greatest worth come first, all of
    /// one worth together or none; a block without a worth is always there.
    pub worth: Option<u8>,
}

/// What a block is.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Content<A> {
    /// A distance to what is above.
    Gap,
    /// What the next blocks are about, in one row.
    Heading(String),
    /// A few words of their own, in one row.
    Line(String, Role),
    /// A text.
    Paragraph(String, Role),
    /// What something is called, and its value.
    Fact {
        name: String,
        value: String,
        roles: [Role; 2],
    },
    /// One row of a table: its name, and a value for each column.
    Columns {
        name: (String, Role),
        values: Vec<(String, Role)>,
    },
    /// One of several things to choose from, in one row.
    Row {
        name: String,
        /// What stands flush right.
        side: String,
        /// How it is written while another one is chosen.
        roles: [Role; 2],
        chosen: bool,
        /// What a click on it does.
        action: A,
    },
    /// One of several texts, behind a mark.
    Item(String, Role),
    /// Something that can be set.
    Field {
        name: String,
        value: String,
        /// How its name is written while another one is chosen.
        role: Role,
        chosen: bool,
        locked: bool,
        /// What a click on it does.
        action: Option<A>,
    },
    /// A text behind a mark, under which nothing else stands.
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
    /// One of several answers, with its letter.
    Choice {
        letter: char,
        text: Vec<Run>,
        chosen: bool,
        /// What a click on it does.
        action: Option<A>,
    },
    /// One of several things to choose from, with a value in each of some columns.
    ChoiceColumns {
        name: String,
        values: Vec<String>,
        chosen: bool,
        action: A,
    },
    /// A text that can be typed: what is before the cursor and what is behind it, while it is
    /// chosen.
    TextField {
        label: String,
        typed: [String; 2],
        chosen: bool,
        /// What a click on it does.
        action: Option<A>,
    },
    /// Rows of cells under heads, each of which can be chosen.
    Table {
        columns: Vec<TableColumn>,
        rows: Vec<TableRow<A>>,
    },
    /// What can be done next, the likeliest first: in words, and what it is.
    Prompts(Vec<(String, A)>),
}

/// A column of a [`Content::Table`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct TableColumn {
    /// What stands above it.
    pub head: String,
    /// Letters of its widest cell.
    pub width: u16,
    /// Whether its cells are flush right, as numbers are.
    pub flush_right: bool,
    /// Columns of the panel from which on there is room for it.
    pub room: u16,
}

/// A row of a [`Content::Table`].
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TableRow<A> {
    /// A cell for each column.
    pub cells: Vec<String>,
    /// How it is written while another one is chosen.
    pub role: Role,
    /// Whether it is the one that is chosen.
    pub chosen: bool,
    /// What a click on it does.
    pub action: A,
}

impl<A> Panel<A> {
    /// An empty panel.
    pub(crate) fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            subject: 0,
            blocks: Vec::new(),
            pinned: 0,
            worth: None,
        }
    }

    fn push(&mut self, content: Content<A>) {
        let worth = self.worth;
        self.blocks.push(Block { content, worth });
    }

    /// Writes blocks that are left out where there is no room for all of this worth.
    pub(crate) fn worth(&mut self, worth: u8, write: impl FnOnce(&mut Self)) {
        let around = self.worth.replace(worth);
        write(self);
        self.worth = around;
    }

    /// Keeps what has been written so far in sight, however far the rest is scrolled.
    pub(crate) fn pin(&mut self) {
        self.pinned = self.blocks.len();
    }

    /// Writes a part whose actions are wrapped in actions of the whole.
    pub(crate) fn part<B>(&mut self, wrap: impl Fn(B) -> A, write: impl FnOnce(&mut Panel<B>)) {
        let mut part = Panel::new("");
        write(&mut part);
        let worth = self.worth;
        let blocks = part.blocks.into_iter().map(|block| Block {
            content: block.content.map(&wrap),
            worth: block.worth.or(worth),
        });
        self.blocks.extend(blocks);
    }

    /// A distance to what is above, if there is anything.
    pub(crate) fn gap(&mut self) {
        self.push(Content::Gap);
    }

    /// What the next blocks are about.
    pub(crate) fn heading(&mut self, text: impl Into<String>) {
        self.push(Content::Heading(text.into()));
    }

    /// A few words in one row.
    pub(crate) fn line(&mut self, text: impl Into<String>, role: Role) {
        self.push(Content::Line(text.into(), role));
    }

    /// A text over as many rows as it takes.
    pub(crate) fn paragraph(&mut self, text: impl Into<String>, role: Role) {
        self.push(Content::Paragraph(text.into(), role));
    }

    /// What something is called, and its value.
    pub(crate) fn fact(&mut self, name: impl Into<String>, value: impl Into<String>) {
        self.coloured_fact(name, value, Role::Text);
    }

    /// The same with a value in a colour of its own, such as that of its arrow.
    pub(crate) fn coloured_fact(
        &mut self,
        name: impl Into<String>,
        value: impl Into<String>,
        role: Role,
    ) {
        self.pair((name, Role::Dim), (value, role));
    }

    /// The same with both in colours of their own.
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

    /// One row of a table: its name, and a value for each column.
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

    /// One of several things to choose from: its name, what stands flush right, and what a
    /// click on it does.
    pub(crate) fn row(
        &mut self,
        (name, role): (impl Into<String>, Role),
        (side, side_role): (impl Into<String>, Role),
        chosen: bool,
        action: A,
    ) {
        self.push(Content::Row {
            name: name.into(),
            side: side.into(),
            roles: [role, side_role],
            chosen,
            action,
        });
    }

    /// One of several texts.
    pub(crate) fn item(&mut self, text: impl Into<String>, role: Role) {
        self.push(Content::Item(text.into(), role));
    }

    /// Something that can be set: what it is called, how its value reads, and what a click
    /// on it does.
    pub(crate) fn field(
        &mut self,
        name: impl Into<String>,
        value: impl Into<String>,
        (role, chosen): (Role, bool),
        action: Option<A>,
    ) {
        self.push(Content::Field {
            name: name.into(),
            value: value.into(),
            role,
            chosen,
            locked: false,
            action,
        });
    }

    /// The same of something that cannot be changed just now.
    pub(crate) fn locked_field(
        &mut self,
        name: impl Into<String>,
        value: impl Into<String>,
        (role, chosen): (Role, bool),
        action: Option<A>,
    ) {
        self.push(Content::Field {
            name: name.into(),
            value: value.into(),
            role,
            chosen,
            locked: true,
            action,
        });
    }

    /// A text behind a mark, under which nothing else stands.
    pub(crate) fn marked(&mut self, mark: &str, text: impl Into<String>, role: Role) {
        self.push(Content::Marked {
            mark: mark.into(),
            text: text.into(),
            role,
        });
    }

    /// A share of a whole, from 0 to 1, and how it reads.
    pub(crate) fn meter(&mut self, name: &str, share: f64, value: impl Into<String>) {
        self.push(Content::Meter {
            name: name.into(),
            share,
            value: value.into(),
        });
    }

    /// One of several answers, with its letter and what a click on it does.
    pub(crate) fn choice(&mut self, letter: char, text: Vec<Run>, chosen: bool, action: Option<A>) {
        self.push(Content::Choice {
            letter,
            text,
            chosen,
            action,
        });
    }

    /// One of several things to choose from, a value in each column beside it.
    pub(crate) fn choice_columns(
        &mut self,
        name: impl Into<String>,
        values: impl IntoIterator<Item = String>,
        chosen: bool,
        action: A,
    ) {
        self.push(Content::ChoiceColumns {
            name: name.into(),
            values: values.into_iter().collect(),
            chosen,
            action,
        });
    }

    /// A text that can be typed, and what a click on it does.
    pub(crate) fn text_field(
        &mut self,
        label: impl Into<String>,
        (before, after): (&str, &str),
        chosen: bool,
        action: Option<A>,
    ) {
        self.push(Content::TextField {
            label: label.into(),
            typed: [before.into(), after.into()],
            chosen,
            action,
        });
    }

    /// Rows under heads, one of which can be chosen.
    pub(crate) fn table(&mut self, columns: Vec<TableColumn>, rows: Vec<TableRow<A>>) {
        self.push(Content::Table { columns, rows });
    }

    /// What can be done next, in a few words without a key, and what it is.
    pub(crate) fn prompt(&mut self, words: impl Into<String>, action: A) {
        self.prompts([(words.into(), action)]);
    }

    /// The same with several things, the likeliest first.
    pub(crate) fn prompts(&mut self, prompts: impl IntoIterator<Item = (String, A)>) {
        self.push(Content::Prompts(prompts.into_iter().collect()));
    }
}

impl<A> Content<A> {
    /// Whether it is the one that is chosen.
    fn is_chosen(&self) -> bool {
        match self {
            Self::Field { chosen, .. }
            | Self::Row { chosen, .. }
            | Self::Choice { chosen, .. }
            | Self::ChoiceColumns { chosen, .. }
            | Self::TextField { chosen, .. } => *chosen,
            _ => false,
        }
    }

    fn map<B>(self, wrap: impl Fn(A) -> B) -> Content<B> {
        match self {
            Self::Gap => Content::Gap,
            Self::Heading(text) => Content::Heading(text),
            Self::Line(text, role) => Content::Line(text, role),
            Self::Paragraph(text, role) => Content::Paragraph(text, role),
            Self::Fact { name, value, roles } => Content::Fact { name, value, roles },
            Self::Columns { name, values } => Content::Columns { name, values },
            Self::Row {
                name,
                side,
                roles,
                chosen,
                action,
            } => Content::Row {
                name,
                side,
                roles,
                chosen,
                action: wrap(action),
            },
            Self::Item(text, role) => Content::Item(text, role),
            Self::Field {
                name,
                value,
                role,
                chosen,
                locked,
                action,
            } => Content::Field {
                name,
                value,
                role,
                chosen,
                locked,
                action: action.map(wrap),
            },
            Self::Marked { mark, text, role } => Content::Marked { mark, text, role },
            Self::Meter { name, share, value } => Content::Meter { name, share, value },
            Self::Choice {
                letter,
                text,
                chosen,
                action,
            } => Content::Choice {
                letter,
                text,
                chosen,
                action: action.map(wrap),
            },
            Self::ChoiceColumns {
                name,
                values,
                chosen,
                action,
            } => Content::ChoiceColumns {
                name,
                values,
                chosen,
                action: wrap(action),
            },
            Self::TextField {
                label,
                typed,
                chosen,
                action,
            } => Content::TextField {
                label,
                typed,
                chosen,
                action: action.map(wrap),
            },
            Self::Table { columns, rows } => {
                let rows = rows.into_iter().map(|row| TableRow {
                    cells: row.cells,
                    role: row.role,
                    chosen: row.chosen,
                    action: wrap(row.action),
                });
                Content::Table {
                    columns,
                    rows: rows.collect(),
                }
            }
            Self::Prompts(prompts) => {
                let wrapped = prompts
                    .into_iter()
                    .map(|(words, action)| (words, wrap(action)));
                Content::Prompts(wrapped.collect())
            }
        }
    }
}

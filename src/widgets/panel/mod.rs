//! What stands beside a picture, as a list of blocks: what they mean and what a click on
//! them does, not where their letters are. [`cells`] lays a panel out and draws it.

mod cells;
#[cfg(test)]
mod tests;

pub(crate) use cells::{Placed, Writing, written};

use crate::widgets::Role;

/// A list of blocks under a title, one below the other; `A` is what they can do.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Panel<A> {
    /// Its title, on its frame; empty for none.
    pub title: String,
    blocks: Vec<Block<A>>,
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
    /// A text that is being typed: what it is, it so far, and the same with its cursor.
    Typed {
        name: String,
        text: String,
        shown: String,
    },
    /// What can be done next, the likeliest first: in words, and what it is.
    Prompts(Vec<(String, A)>),
}

impl<A> Panel<A> {
    /// An empty panel.
    pub(crate) fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            blocks: Vec::new(),
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
        self.push(Content::Fact {
            name: name.into(),
            value: value.into(),
            roles: [Role::Dim, role],
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

    /// A text that is being typed: what it is called, and what has been typed so far, with
    /// and without a mark for the cursor.
    pub(crate) fn typed(&mut self, name: &str, text: &str, shown: String) {
        self.push(Content::Typed {
            name: name.to_owned(),
            text: text.to_owned(),
            shown,
        });
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
        matches!(
            self,
            Self::Field { chosen: true, .. } | Self::Row { chosen: true, .. }
        )
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
            Self::Typed { name, text, shown } => Content::Typed { name, text, shown },
            Self::Prompts(prompts) => {
                let wrapped = prompts
                    .into_iter()
                    .map(|(words, action)| (words, wrap(action)));
                Content::Prompts(wrapped.collect())
            }
        }
    }
}

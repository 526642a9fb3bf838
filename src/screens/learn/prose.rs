//! The text of a page, as blocks of a panel.

use crate::lessons::{Inline, TextBlock, Tone};
use crate::physics::Collision;
use crate::widgets::flow::Run;
use crate::widgets::panel::Panel;
use crate::widgets::{Charset, Role, formula};

/// The settings for writing the text of a page.
#[derive(Clone, Copy)]
pub(super) struct Prose<'a> {
    /// The collision from which the live numbers are computed.
    pub figure: Option<&'a Collision>,
    /// The charset, which determines how many rows a formula takes.
    pub charset: Charset,
}

impl Prose<'_> {
    pub(super) fn write<A>(self, blocks: &[TextBlock], panel: &mut Panel<A>) {
        self.write_in(None, blocks, panel);
    }

    /// Writes blocks of text that the student has already read, all in a faint style.
    pub(super) fn write_dimmed<A>(self, blocks: &[TextBlock], panel: &mut Panel<A>) {
        self.write_in(Some(Role::Dim), blocks, panel);
    }

    /// Writes blocks of text, each word in its own style, or all words in the style `one`.
    fn write_in<A>(self, one: Option<Role>, blocks: &[TextBlock], panel: &mut Panel<A>) {
        let runs = |pieces: &[Inline]| {
            let mut runs = self.runs(pieces, Role::Text);
            if let Some(one) = one {
                runs.iter_mut().for_each(|run| run.role = one);
            }
            runs
        };
        for (at, block) in blocks.iter().enumerate() {
            if at > 0 && !self.belong_together(&blocks[at - 1], block) {
                panel.gap();
            }
            match block {
                TextBlock::Paragraph(pieces) => panel.flow("", runs(pieces)),
                TextBlock::Item(number, pieces) => {
                    let mark = number.map_or("-".into(), |number| format!("{number}."));
                    panel.flow(mark, runs(pieces));
                }
                TextBlock::Formula(formula) => {
                    panel.formula(formula.clone(), one.unwrap_or(Role::Title));
                }
            }
        }
    }

    /// Whether two blocks are written without an empty row between them.
    fn belong_together(self, before: &TextBlock, after: &TextBlock) -> bool {
        let low = |formula| formula::set(formula, self.charset).len() == 1;
        match (before, after) {
            (TextBlock::Item(..), TextBlock::Item(..)) => true,
            // A fraction right below another would look like a part of it.
            (TextBlock::Formula(before), TextBlock::Formula(after)) => low(before) || low(after),
            (TextBlock::Paragraph(pieces), TextBlock::Item(..) | TextBlock::Formula(_)) => {
                matches!(pieces.last(), Some(Inline::Text(text, _)) if text.ends_with([':', ',']))
            }
            _ => false,
        }
    }

    /// Pieces of text as runs in their styles; `plain` is the style of plain text.
    pub(super) fn runs(self, pieces: &[Inline], plain: Role) -> Vec<Run> {
        let run = |piece: &Inline| match piece {
            Inline::Text(text, tone) => {
                let role = match tone {
                    Tone::Plain => plain,
                    Tone::Emphasis | Tone::Strong => Role::Title,
                    Tone::Key => Role::Key,
                };
                Run::new(text.as_str(), role)
            }
            // A formula is kept together, because one that is broken over two rows is hard to read.
            Inline::Formula(formula) => Run::formula(formula, plain),
            Inline::Live(quantity) => {
                let value = self.figure.map(|collision| quantity.shown(collision));
                Run::new(value.unwrap_or_default(), Role::Title)
            }
        };
        pieces.iter().map(run).collect()
    }
}

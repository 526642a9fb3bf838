//! The text of a page, written row by row.

use crate::lessons::{Inline, TextBlock, Tone};
use crate::physics::Collision;
use crate::widgets::flow::Run;
use crate::widgets::{Charset, Lines, Role, Words, formula};

/// Columns by which formulas and the rows of a list are set in.
const INDENT: u16 = 2;

/// Writes blocks of text; live numbers are those of `figure`.
pub(super) fn write(blocks: &[TextBlock], lines: &mut Lines, figure: Option<&Collision>) {
    write_in(None, blocks, lines, figure);
}

/// Writes blocks of text that have been read, all in one faint style.
pub(super) fn write_dimmed(blocks: &[TextBlock], lines: &mut Lines, figure: Option<&Collision>) {
    write_in(Some(Role::Dim), blocks, lines, figure);
}

/// Writes blocks of text, each word in its own style or all of them in `one`.
fn write_in(
    one: Option<Role>,
    blocks: &[TextBlock],
    lines: &mut Lines,
    figure: Option<&Collision>,
) {
    let runs = |pieces: &[Inline]| {
        let mut runs = runs(pieces, Role::Text, figure);
        if let Some(one) = one {
            runs.iter_mut().for_each(|run| run.role = one);
        }
        runs
    };
    let mut before: Option<&TextBlock> = None;
    for block in blocks {
        if let Some(before) = before
            && !belong_together(before, block, lines.charset())
        {
            lines.gap();
        }
        match block {
            TextBlock::Paragraph(pieces) => lines.flowing("", 0, &runs(pieces)),
            TextBlock::Item(number, pieces) => {
                let mark = number.map_or("-".into(), |number| format!("{number}."));
                let indent = mark.len() as u16 + 1;
                lines.flowing(&mark, indent, &runs(pieces));
            }
            TextBlock::Formula(formula) => {
                let role = one.unwrap_or(Role::Title);
                let recorded = |charset| Words::Equation {
                    runs: vec![Run::new(formula.inline(), role).spelt(charset)],
                };
                let rows = formula::set(formula, lines.charset());
                lines.written_as(recorded, |lines| {
                    for row in rows {
                        lines.line(&format!("{:1$}{row}", "", INDENT.into()), role);
                    }
                });
            }
        }
        before = Some(block);
    }
}

/// Whether two blocks stand without an empty row between them.
fn belong_together(before: &TextBlock, after: &TextBlock, charset: Charset) -> bool {
    let low = |formula| formula::set(formula, charset).len() == 1;
    match (before, after) {
        (TextBlock::Item(..), TextBlock::Item(..)) => true,
        // One fraction right below another reads as one of three storeys.
        (TextBlock::Formula(before), TextBlock::Formula(after)) => low(before) || low(after),
        (TextBlock::Paragraph(pieces), TextBlock::Item(..) | TextBlock::Formula(_)) => {
            matches!(pieces.last(), Some(Inline::Text(text, _)) if text.ends_with([':', ',']))
        }
        _ => false,
    }
}

/// Pieces of text as stretches in their styles; `plain` is that of plain words.
pub(super) fn runs(pieces: &[Inline], plain: Role, figure: Option<&Collision>) -> Vec<Run> {
    let run = |piece: &Inline| match piece {
        Inline::Text(text, tone) => {
            let role = match tone {
                Tone::Plain => plain,
                Tone::Emphasis | Tone::Strong => Role::Title,
                Tone::Key => Role::Key,
            };
            Run::new(text.as_str(), role)
        }
        // Held together, as a formula broken over two rows is hard to read.
        Inline::Formula(formula) => Run::new(formula.inline().replace(' ', "\u{a0}"), plain),
        Inline::Live(quantity) => {
            let value = figure.map(|collision| quantity.shown(collision));
            Run::new(value.unwrap_or_default(), Role::Title)
        }
    };
    pieces.iter().map(run).collect()
}

//! The questions of a round that is being set up.

use super::ClassAction;
use crate::quiz::Round;
use crate::screens::View;
use crate::widgets::Role;
use crate::widgets::panel::Panel;

/// The list of a round's questions, without their answers.
pub(super) fn view(round: &Round) -> View<'_, ClassAction> {
    let mut panel = Panel::new(format!("the questions of {}", round.code()));
    for (number, question) in (1..).zip(round.questions()) {
        panel.marked(&format!("{number:>2}  "), &question.text, Role::Text);
        let (family, difficulty) = (question.family.name(), question.difficulty.id());
        let kind = format!("{family}: {}, {difficulty}", question.topic);
        panel.marked("    ", kind, Role::Dim);
        panel.gap();
    }
    View::text(panel)
}

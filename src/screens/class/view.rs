//! How a round being played looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::heading::{Heading, centred};
use super::play::{ClassPhase, ClassPlay, EndPage};
use super::{ending_view, question_view, scores_view, shown_view, spread_view, vote_view};
use crate::class::{ClassStep, Vote};
use crate::widgets::big::{Align, Big};
use crate::widgets::{Lines, Look, Role};

/// A text that may be longer than its place: the place, and what writes it.
pub(super) type Text<'a> = (Rect, Box<dyn Fn(&mut Lines) + 'a>);

/// Columns of what is read line by line.
const WIDEST: u16 = 100;

/// Draws a round.
pub(super) fn draw(play: &ClassPlay, area: Rect, buf: &mut Buffer, look: &Look) {
    match (&play.phase, play.step()) {
        (ClassPhase::End(page), _) => ending_view::draw(play, *page, area, buf, look),
        (ClassPhase::Vote(entry), _) => match &entry.input {
            Some(input) => vote_view::draw_entry(play, entry, input, area, buf, look),
            None => vote_view::draw_teams(play, entry, area, buf, look),
        },
        (ClassPhase::Shot(shown), _) => shown_view::draw(play, shown, area, buf, look),
        (ClassPhase::Look, ClassStep::Talk) => spread_view::draw(play, area, buf, look),
        (ClassPhase::Look, ClassStep::Scores) => {
            let rest = Heading::new(&["Scores"], "").draw(area, buf, look);
            scores_view::draw(&play.round, play.asked(), rest, buf, look);
        }
        (ClassPhase::Look, _) => question_view::draw(play, area, buf, look),
    }
    if let Some((place, write)) = text(play, area, look) {
        play.scroll.draw(place, buf, *look, write);
    }
}

/// The text of a step that can be scrolled.
fn text<'a>(play: &'a ClassPlay, area: Rect, look: &'a Look) -> Option<Text<'a>> {
    match (&play.phase, play.step()) {
        (ClassPhase::End(EndPage::Board), _) => None,
        (ClassPhase::End(page), _) => Some(ending_view::text(play, *page, area, look)),
        (ClassPhase::Vote(entry), _) => vote_view::text(play, entry, area),
        (ClassPhase::Shot(shown), _) => Some(shown_view::text(play, shown, area, look)),
        (ClassPhase::Look, ClassStep::Talk) => spread_view::text(play, area, look),
        (ClassPhase::Look, ClassStep::Scores) => None,
        (ClassPhase::Look, _) => question_view::text(play, area, look),
    }
}

/// Scrolls what can be scrolled.
pub(super) fn scroll(play: &mut ClassPlay, rows: i16, area: Rect, look: &Look) {
    let mut scroll = play.scroll;
    if let Some((place, write)) = text(play, area, look) {
        scroll.by(rows, place, *look, write);
    }
    play.scroll = scroll;
}

/// The calm screen of a pause.
pub(super) fn paused(area: Rect, buf: &mut Buffer, look: &Look) {
    let big = Big::fit("paused", area.width, area.height / 2, look.charset);
    let rows = big.as_ref().map_or(1, Big::rows);
    let top = area.y + area.height.saturating_sub(rows) / 2;
    match big {
        Some(big) => {
            let place = Rect::new(area.x, top, area.width, rows);
            big.draw(place, buf, look, Role::Dim, Align::Centre);
        }
        None => centred("paused", top, area, buf, look, Role::Dim),
    }
}

/// The middle of an area, no wider than a line that reads well.
pub(super) fn column(area: Rect) -> Rect {
    let width = area.width.min(WIDEST);
    Rect {
        x: area.x + (area.width - width) / 2,
        width,
        ..area
    }
}

/// "one team", "3 teams".
pub(super) fn teams(count: usize) -> String {
    match count {
        1 => "one team".into(),
        count => format!("{count} teams"),
    }
}

/// Which of both votes, as a heading.
pub(super) const fn vote_name(vote: Vote) -> &'static str {
    match vote {
        Vote::First => "First vote",
        Vote::Second => "Second vote",
    }
}

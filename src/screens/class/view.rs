//! How a round being played looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::heading::{Heading, centred};
use super::play::{Page, Phase, Play};
use super::{ending_view, question_view, scores_view, shown_view, spread_view, vote_view};
use crate::class::{ClassStep, Vote};
use crate::widgets::big::{Align, Big};
use crate::widgets::{Lines, Look, Role};

/// A text that may be longer than its place: the place, and what writes it.
pub(super) type Text<'a> = (Rect, Box<dyn Fn(&mut Lines) + 'a>);

/// Columns of what is read line by line.
const WIDEST: u16 = 100;

/// Draws a round.
pub(super) fn draw(play: &Play, leaving: bool, area: Rect, buf: &mut Buffer, look: &Look) {
    match (&play.phase, play.step()) {
        (Phase::End(page), _) => ending_view::draw(play, *page, area, buf, look),
        (Phase::Vote(booths), _) => match &booths.input {
            Some(input) => vote_view::draw_booth(play, booths, input, area, buf, look),
            None => vote_view::draw_teams(play, booths, area, buf, look),
        },
        (Phase::Shot(shown), _) => shown_view::draw(play, shown, area, buf, look),
        (Phase::Look, ClassStep::Talk) => spread_view::draw(play, area, buf, look),
        (Phase::Look, ClassStep::Scores) => {
            let rest = Heading::new(&["Scores"], "").draw(area, buf, look);
            scores_view::draw(&play.round, play.asked(), rest, buf, look);
        }
        (Phase::Look, _) => question_view::draw(play, area, buf, look),
    }
    if let Some((place, write)) = text(play, area, look) {
        play.scroll.draw(place, buf, *look, write);
    }
    if leaving {
        let row = area.bottom().saturating_sub(1);
        let foot = Rect::new(area.x, row, area.width, area.height.min(1));
        buf.set_style(foot, look.theme.style(Role::Text));
        let words = if play.unsaved {
            "It cannot be saved: Esc again loses the round; e writes its tables first"
        } else {
            "Esc again leaves the round; it is kept to be taken up again"
        };
        blank(foot, buf);
        centred(words, row, area, buf, look, Role::Warn);
    }
}

/// The text of a step that can be scrolled.
fn text<'a>(play: &'a Play, area: Rect, look: &'a Look) -> Option<Text<'a>> {
    match (&play.phase, play.step()) {
        (Phase::End(Page::Board), _) => None,
        (Phase::End(page), _) => Some(ending_view::text(play, *page, area, look)),
        (Phase::Vote(booths), _) => vote_view::text(play, booths, area),
        (Phase::Shot(shown), _) => Some(shown_view::text(play, shown, area, look)),
        (Phase::Look, ClassStep::Talk) => spread_view::text(play, area, look),
        (Phase::Look, ClassStep::Scores) => None,
        (Phase::Look, _) => question_view::text(play, area, look),
    }
}

/// Scrolls what can be scrolled.
pub(super) fn scroll(play: &mut Play, rows: i16, area: Rect, look: &Look) {
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

/// Empties an area.
fn blank(area: Rect, buf: &mut Buffer) {
    for position in area.positions() {
        if let Some(cell) = buf.cell_mut(position) {
            cell.set_char(' ');
        }
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

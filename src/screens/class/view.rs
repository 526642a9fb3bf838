//! How a round being played looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::heading::{Heading, below, centred};
use super::play::{ClassPhase, ClassPlay, EndPage};
use super::{ending_view, question_view, scores_view, shown_view, spread_view, vote_view};
use crate::class::ClassStep;
use crate::widgets::big::{Align, Big};
use crate::widgets::{Lines, Look, Role, areas};

/// A text that may be longer than its place: the place, and what writes it.
pub(super) type Text<'a> = (Rect, Box<dyn Fn(&mut Lines) + 'a>);

/// Columns of what is read line by line.
const WIDEST: u16 = 100;
/// Rows of a body from which on there is a heading above the picture of a shot, too.
const HEADED_FROM: u16 = 34;

/// The heading of what is on the screen, if it has one.
fn heading(play: &ClassPlay, area: Rect) -> Option<Heading> {
    let number = format!("Question {}", play.number() + 1);
    let (texts, line): (&[&str], _) = match (&play.phase, play.step()) {
        (ClassPhase::End(EndPage::Board), _) => (
            &["The end"],
            "e: write the answers as tables for a spreadsheet",
        ),
        (ClassPhase::End(EndPage::Held), _) => (&["What you held", "You held"], ""),
        (ClassPhase::End(EndPage::Items), _) => (&["Questions"], ""),
        (ClassPhase::Vote(entry), _) if entry.input.is_some() => return None,
        (ClassPhase::Vote(_), ClassStep::SecondVote) => (
            &["Second vote", "Vote 2"],
            "Who wants to change? All others keep their vote.",
        ),
        (ClassPhase::Vote(_), _) => (
            &["First vote", "Vote 1"],
            "Each team in turn. What was said before is hidden.",
        ),
        (ClassPhase::Shot(_), _) if area.height < HEADED_FROM => return None,
        (ClassPhase::Shot(_), _) => (&["The shot"], ""),
        (ClassPhase::Look, ClassStep::Talk) => (
            &["Talk"],
            "These are the votes. Find someone who thinks otherwise, and say why.",
        ),
        (ClassPhase::Look, ClassStep::Scores) => (&["Scores"], ""),
        (ClassPhase::Look, _) if play.words_alone => return None,
        (ClassPhase::Look, ClassStep::Predict) => (
            &["Predict in silence", "In silence"],
            "Everyone writes down an answer. Nobody speaks.",
        ),
        (ClassPhase::Look, _) => (&[&number], ""),
    };
    Some(Heading::new(texts, line))
}

/// What is left of an area below the heading.
pub(super) fn rest(play: &ClassPlay, area: Rect, look: &Look) -> Rect {
    heading(play, area).map_or(area, |heading| heading.rest(area, look))
}

/// Draws a round but for the text of its step, which can be scrolled and is given.
fn draw_around<'a>(
    play: &'a ClassPlay,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) -> Option<Text<'a>> {
    if let Some(heading) = heading(play, area) {
        heading.draw(area, buf, look);
    }
    let question = play.question()?;
    let rest = rest(play, area, look);
    match (&play.phase, play.step()) {
        (ClassPhase::End(EndPage::Board), _) | (ClassPhase::Look, ClassStep::Scores) => {
            scores_view::draw(&play.round, play.asked(), rest, buf, look);
            None
        }
        (ClassPhase::End(page), _) => Some(ending_view::text(play, *page, rest)),
        (ClassPhase::Vote(entry), _) => vote_view::draw(play, question, entry, rest, buf, look),
        (ClassPhase::Shot(shown), _) => {
            Some(shown_view::draw(play, question, shown, rest, buf, look))
        }
        (ClassPhase::Look, ClassStep::Talk) => spread_view::draw(play, question, rest, buf, look),
        (ClassPhase::Look, _) => question_view::draw(play, question, rest, buf, look),
    }
}

/// Draws a round.
pub(super) fn draw(play: &ClassPlay, area: Rect, buf: &mut Buffer, look: &Look) {
    if let Some((place, write)) = draw_around(play, area, buf, look) {
        play.scroll.draw(place, buf, *look, write);
    }
}

/// Scrolls what can be scrolled.
pub(super) fn scroll(play: &mut ClassPlay, rows: i16, area: Rect, look: &Look) {
    let text = draw_around(play, area, &mut Buffer::empty(area), look);
    if let Some(scroll) = text.map(|(place, write)| play.scroll.by(rows, place, *look, write)) {
        play.scroll = scroll;
    }
}

/// The calm screen of a pause.
pub(super) fn paused(area: Rect, buf: &mut Buffer, look: &Look) {
    let big = Big::fit("paused", area.width, area.height / 2, look.charset);
    let rows = big.as_ref().map_or(1, Big::rows);
    let place = below(area, area.height.saturating_sub(rows) / 2);
    match big {
        Some(big) => big.draw(place, buf, look, Role::Dim, Align::Centre),
        None => centred("paused", place, buf, look, Role::Dim),
    }
}

/// The middle of an area, no wider than a line that reads well.
pub(super) fn column(area: Rect) -> Rect {
    areas::middle(area, WIDEST)
}

/// One of the places of so many rows into which an area is cut, from 0 at its top.
pub(super) fn slot(area: Rect, number: usize, rows: u16) -> Rect {
    let place = below(area, rows.saturating_mul(number as u16));
    Rect {
        height: rows.min(place.height),
        ..place
    }
}

/// "one team", "3 teams".
pub(super) fn teams(count: usize) -> String {
    match count {
        1 => "one team".into(),
        count => format!("{count} teams"),
    }
}

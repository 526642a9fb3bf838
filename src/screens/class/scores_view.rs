//! The scoreboard: everyone's place, points and gain.

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::heading::{Text, below, column, slot};
use super::play::ClassPlay;
use crate::class::{ClassRound, WayOfVoting, items, standings};
use crate::numbers;
use crate::quiz::Grade;
use crate::widgets::bar::bar;
use crate::widgets::big::{Align, Big};
use crate::widgets::flow::Run;
use crate::widgets::{Item, Lines, Look, Role, Words, sheet, text};

/// Rows of large letters.
const LETTERS: u16 = 4;
/// Rows of a team in large type: its letters, one of its bar, and if possible one empty.
const LARGE: [u16; 2] = [LETTERS + 1, LETTERS + 2];
/// Columns between a name and the points in large type.
const APART: u16 = 3;

/// What is said of a team.
struct ScoreRow {
    /// "1. Ants"
    name: String,
    /// "27.5"
    points: String,
    /// "+9.3"
    gain: String,
    /// Its share of all points there were.
    share: f64,
}

/// Draws where the class stands.
pub(super) fn draw(play: &ClassPlay, area: Rect, buf: &mut Buffer, look: &Look) {
    if let Some((place, write)) = text(play, area) {
        return play.scroll.draw(place, buf, *look, write);
    }
    let area = column(area);
    let rows = rows(play);
    let high = area.height / (rows.len() as u16).max(1);
    match large(&rows, high, area.width, look) {
        Some(letters) => draw_large(&rows, &letters, high.min(LARGE[1]), area, buf, look),
        None => draw_plain(&rows, high.clamp(1, 3), area, buf, look),
    }
}

/// The scoreboard as a text, where it is too long for its place.
pub(super) fn text(play: &ClassPlay, area: Rect) -> Option<Text<'_>> {
    let rows = rows(play);
    let mut place = column(area);
    if rows.len() <= place.height.into() {
        return None;
    }
    // The last row is for the word that there is more.
    place.height = place.height.saturating_sub(1);
    let write = move |lines: &mut Lines| rows.iter().for_each(|row| row.write(lines));
    Some((place, Box::new(write)))
}

/// A row for each of the teams; for each of the questions where there are no names, or none that
/// all may see.
fn rows(play: &ClassPlay) -> Vec<ScoreRow> {
    let has_names = match play.round().way() {
        WayOfVoting::Tally => false,
        WayOfVoting::Teams => true,
        WayOfVoting::Devices => play.names_shown,
    };
    let asked = play.session.with_points();
    match has_names {
        true => of_teams(play.round(), asked),
        false => of_questions(play.round(), asked),
    }
}

impl ScoreRow {
    /// Writes it in one line.
    fn write(&self, lines: &mut Lines) {
        let room = usize::from(lines.width().saturating_sub(20));
        let name = text::clipped(&self.name, room);
        let numbers = format!("{:>6}  {:>6}", self.points, self.gain);
        lines.pair(&name, &numbers, Role::Title, Role::Title);
    }
}

/// A row for each of the teams, the best first.
fn of_teams(round: &ClassRound, asked: usize) -> Vec<ScoreRow> {
    let most = Grade::MOST * asked.max(1) as f64;
    let standings = standings(round, asked).into_iter().map(|it| ScoreRow {
        name: format!("{}. {}", it.place, round.name_of(it.team)),
        points: numbers::points(it.points),
        gain: format!("+{}", numbers::points(it.gain)),
        share: it.points / most,
    });
    standings.collect()
}

/// A row for each question, with the share that was right after talking, and by how much it
/// rose.
fn of_questions(round: &ClassRound, asked: usize) -> Vec<ScoreRow> {
    let items = items(round, asked).into_iter();
    let rows = items.map(|it| {
        let [first, second] = it.votes.map(|it| it.share_right().unwrap_or(0.0));
        ScoreRow {
            name: format!("Question {}", it.question + 1),
            points: format!("{:.0} %", 100.0 * second),
            gain: format!("{:+.0} %", 100.0 * (second - first)),
            share: second,
        }
    });
    rows.collect()
}

/// Names and points in large type, if there is room for all of them.
fn large(rows: &[ScoreRow], high: u16, width: u16, look: &Look) -> Option<Vec<[Big; 2]>> {
    if high < LARGE[0] {
        return None;
    }
    let texts = |of: fn(&ScoreRow) -> &String| rows.iter().map(|row| of(row).as_str()).collect();
    let points: Vec<&str> = texts(|row| &row.points);
    let points = Big::fit_lines(&points, width / 3, look.charset)?;
    let widest = points.iter().map(Big::columns).max()?;
    let names: Vec<&str> = texts(|row| &row.name);
    let room = width.saturating_sub(widest + APART + 2);
    let names = Big::fit_lines(&names, room, look.charset)?;
    let letters = names.into_iter().zip(points);
    Some(letters.map(<[Big; 2]>::from).collect())
}

fn draw_large(
    rows: &[ScoreRow],
    letters: &[[Big; 2]],
    high: u16,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) {
    for (i, (row, [name, points])) in rows.iter().zip(letters).enumerate() {
        let whole = slot(area, i, high);
        let place = whole.inner(Margin::new(1, 0));
        let pair = |(name, value): (&str, &str)| Words::Pair {
            name: Run::new(name, Role::Title),
            value: Run::new(value, Role::Title),
        };
        sheet::note(area, || Item::new(pair((&row.name, &row.points))));
        name.draw(place, buf, look, Role::Title, Align::Left);
        points.draw(place, buf, look, Role::Title, Align::Right);
        let mut lines = Lines::new(below(whole, LETTERS), buf, *look);
        let width = lines.width().saturating_sub(9);
        let bar = bar(row.share, width, look.charset);
        sheet::note(area, || {
            Item::new(Words::meter("", row.share, &row.gain, Role::Predicted))
        });
        lines.unrecorded(|lines| lines.pair(&bar, &row.gain, Role::Predicted, Role::Title));
    }
}

fn draw_plain(rows: &[ScoreRow], high: u16, area: Rect, buf: &mut Buffer, look: &Look) {
    for (i, row) in rows.iter().enumerate() {
        let mut lines = Lines::new(slot(area, i, high), buf, *look);
        row.write(&mut lines);
        if high > 1 {
            let width = lines.width().saturating_sub(1);
            lines.written_as(
                |_| Words::meter("", row.share, "", Role::Predicted),
                |lines| lines.line(&bar(row.share, width, look.charset), Role::Predicted),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::class::{ClassPlace, ClassStep, Vote};
    use crate::quiz::Code;
    use crate::screens::{Context, Settings};
    use crate::widgets::cells;

    /// Of thirty-two pupils each can be brought into sight.
    #[test]
    fn a_long_board_is_scrolled_to_its_end() {
        let names = (0..32).map(|pupil| format!("Pupil {pupil:02}"));
        let code = Code::parse("from-angle2-7").unwrap();
        let mut round = ClassRound::new(code, names.collect());
        let truth = round.questions()[0].form.truth();
        round.vote(0, 0, Vote::First, Some(truth));
        round.go(ClassPlace {
            question: 0,
            step: ClassStep::Scores,
        });
        let mut cx = Context::new(Settings::default(), 1);
        let area = Rect::new(0, 0, 80, 18);
        let look = cx.settings.look();
        let mut play = ClassPlay::new(round, &mut cx);
        let shown = |play: &ClassPlay| {
            let mut buf = Buffer::empty(Rect::new(0, 0, 80, 20));
            draw(play, area, &mut buf, &look);
            cells::text(&buf)
        };
        let mut seen = shown(&play);
        assert!(seen.contains("PageDown: more"), "{seen}");
        for _ in 0..4 {
            let (place, write) = text(&play, area).unwrap();
            play.scroll = { play.scroll }.by(8, place, look, write);
            seen += &shown(&play);
        }
        for pupil in 0..32 {
            assert!(seen.contains(&format!("Pupil {pupil:02}")), "{pupil}");
        }
    }
}

//! The scoreboard: everyone's rank, points and gain.

use ratatui::layout::Rect;

use super::ClassAction;
use super::stage::Stage;
use crate::class::{ClassRound, WayOfVoting, items, standings};
use crate::numbers;
use crate::quiz::Grade;
use crate::screens::View;
use crate::screens::view::WIDEST;
use crate::widgets::panel::BoardRow;
use crate::widgets::panels::Heading;
use crate::widgets::{Room, SplitLayout, areas};

/// The standings of the class, under a heading.
pub(super) fn view(play: &Stage, heading: Heading) -> View<'_, ClassAction> {
    let mut panel = play.words();
    panel.board(rows(play));
    let middle = |room: Room| SplitLayout::open(Rect::default(), areas::middle(room.area, WIDEST));
    View {
        heading: Some(heading),
        ..View::alone(middle, panel)
    }
}

/// One row per team, or per question if there are no names or if they are hidden.
fn rows(play: &Stage) -> Vec<BoardRow> {
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

/// One row per team, the best first.
fn of_teams(round: &ClassRound, asked: usize) -> Vec<BoardRow> {
    let most = Grade::MOST * asked.max(1) as f64;
    let standings = standings(round, asked).into_iter().map(|it| BoardRow {
        name: format!("{}. {}", it.place, round.name_of(it.team)),
        points: numbers::points(it.points),
        gain: format!("+{}", numbers::points(it.gain)),
        share: it.points / most,
    });
    standings.collect()
}

/// One row per question, with the share of right votes after the discussion, and the change from
/// the share before it.
fn of_questions(round: &ClassRound, asked: usize) -> Vec<BoardRow> {
    let items = items(round, asked).into_iter();
    let rows = items.map(|it| {
        let [first, second] = it.votes.map(|it| it.share_right().unwrap_or(0.0));
        BoardRow {
            name: format!("Question {}", it.question + 1),
            points: format!("{:.0} %", 100.0 * second),
            gain: format!("{:+.0} %", 100.0 * (second - first)),
            share: second,
        }
    });
    rows.collect()
}

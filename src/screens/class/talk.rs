//! The distribution of the first votes, without the right answer and without names, for the
//! discussion.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use glam::dvec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::stage::Stage;
use super::{ClassAction, question, vote};
use crate::class::{Advice, Vote, WayOfVoting};
use crate::physics::Collision;
use crate::physics::units::mm_from_m;
use crate::quiz::{Form, Question, Ray, Response};
use crate::screens::View;
use crate::widgets::flow::Run;
use crate::widgets::hit::{HitLayout, degrees};
use crate::widgets::panel::{Beside, Panel};
use crate::widgets::panels::Heading;
use crate::widgets::picture::{LabelSide, Pen, Picture};
use crate::widgets::plot::{Axis, Plot};
use crate::widgets::{Lines, Look, Role, areas, brief, draw_question};

/// The maximum number of different angles that are listed in words for a ray.
const MOST_ANGLES: usize = 5;

/// The question with the number of votes for each choice, and the votes in its picture or below it.
pub(super) fn view<'s>(play: &'s Stage, question: &'s Question) -> View<'s, ClassAction> {
    let heading = Heading::new(
        &["Talk"],
        "These are the votes. Explain your vote to someone who disagrees.",
    );
    let mut words = play.words();
    question::write(play, question, Some(Vote::First), |_| None, &mut words);
    let mut foot = Panel::new("");
    write_more(play, question, &mut foot);
    let draw = move |area, buf: &mut _, look: &_| draw(play, question, area, buf, look);
    let view = play.step_view(Some(heading), beside(play, question), draw, words);
    view.with_foot(foot)
}

/// Writes the most frequent directions of each ray, the number of participants who have not voted,
/// and the advice.
fn write_more(play: &Stage, question: &Question, panel: &mut Panel<ClassAction>) {
    let votes: Vec<_> = play.round().said(play.number(), Vote::First).collect();
    let advice = Advice::of(play.round(), play.number());
    if let (Form::Rays { target, .. }, false, WayOfVoting::Teams | WayOfVoting::Devices) =
        (&question.form, votes.is_empty(), play.round().way())
    {
        let [striker, coin] = [Ray::Striker, Ray::Target].map(|ray| listed(question, &votes, ray));
        let words = format!("degrees: striker {striker}; {target} {coin}");
        panel.paragraph(words, Role::Text);
    }
    let missing = match play.round().way() {
        WayOfVoting::Tally if advice.is_none() => "No votes counted yet.".to_owned(),
        WayOfVoting::Tally => String::new(),
        _ => vote::missing(play.round(), play.number(), Vote::First),
    };
    match (advice, missing.as_str()) {
        (None, missing) => panel.line(missing, Role::Dim),
        (Some(advice), "") => panel.line(advice.words(), Role::Key),
        (Some(advice), missing) => {
            let advice = Run::new(advice.words(), Role::Key);
            panel.flow(
                "",
                vec![advice, Run::new(format!(" ({missing})"), Role::Dim)],
            );
        }
    }
}

/// How much the picture adds to the text: only the picture shows a distribution of rays or numbers.
fn beside(play: &Stage, question: &Question) -> Beside {
    match question.form {
        _ if play.round().way() == WayOfVoting::Tally => question::beside(question),
        Form::Choice { .. } => question::beside(question),
        Form::Rays { .. } | Form::Number { .. } | Form::Shot(_) => Beside::Needed,
    }
}

/// Draws the picture of a question, with the votes in it or below it.
fn draw(play: &Stage, question: &Question, area: Rect, buf: &mut Buffer, look: &Look) {
    let votes: Vec<_> = play.round().said(play.number(), Vote::First).collect();
    let votes = votes.as_slice();
    let is_tally = play.round().way() == WayOfVoting::Tally;
    let unit = match &question.form {
        Form::Choice { .. } => return draw_question(area, buf, look, question, None),
        Form::Rays { .. } => {
            // The rays are drawn first, so they do not cover the question's own labels.
            if let Some(collision) = question.picture.collision() {
                draw_fan(collision, votes, area, buf, look);
            }
            return draw_question(area, buf, look, question, None);
        }
        _ if is_tally => return draw_question(area, buf, look, question, None),
        Form::Number { quantity, .. } => quantity.unit(),
        Form::Shot(_) => "mm, negative to the left",
    };
    let rows = match question::beside(question) {
        Beside::Nothing => 0,
        _ => area.height / 2,
    };
    let [picture, line] = areas::upper(area, rows);
    draw_question(picture, buf, look, question, None);
    draw_line(unit, votes, line, buf, look);
}

/// The most frequent angles for a ray, in ascending order, with the number of equal votes:
/// "30.0, 45.0 (2)".
fn listed(question: &Question, votes: &[Response], ray: Ray) -> String {
    let index = usize::from(ray == Ray::Target);
    let mut angles: Vec<Option<f64>> = votes
        .iter()
        .filter_map(|said| match (said, question.picture.collision()) {
            (Response::Rays(rays), Some(collision)) => Some(degrees(collision, rays)[index]),
            _ => None,
        })
        .collect();
    angles.sort_by(|a, b| {
        let value = |angle: &Option<f64>| angle.unwrap_or(f64::INFINITY);
        value(a).total_cmp(&value(b))
    });
    let shown: Vec<String> = angles.into_iter().map(brief).collect();
    let same = shown.chunk_by(|a, b| a == b);
    let mut same: Vec<(usize, &[String])> = same.enumerate().collect();
    let more = if same.len() > MOST_ANGLES { " …" } else { "" };
    // The sort is stable, so of equally frequent angles the smallest are listed.
    same.sort_by_key(|(_, same)| Reverse(same.len()));
    same.truncate(MOST_ANGLES);
    same.sort_unstable_by_key(|(at, _)| *at);
    let words = same.into_iter().map(|(_, same)| match same {
        [one] => one.clone(),
        _ => format!("{} ({})", same[0], same.len()),
    });
    words.collect::<Vec<_>>().join(", ") + more
}

/// If the votes for a disc have at most this many directions, all of them are labelled; otherwise
/// only the most frequent ones are.
const MANY_WAYS: usize = 8;

/// Draws all rays, each from the position of its disc at contact.
fn draw_fan(collision: &Collision, votes: &[Response], area: Rect, buf: &mut Buffer, look: &Look) {
    let stage = HitLayout::new(area, collision);
    let mut picture = Picture::new(stage.view);
    let bodies = [
        (Ray::Striker, "S", Role::StrikerOut),
        (Ray::Target, "C", Role::CoinOut),
    ];
    for (ray, name, role) in bodies {
        // Many votes of a class are equal, so each direction in whole degrees is drawn only once.
        let mut ways: BTreeMap<i64, (usize, f64)> = BTreeMap::new();
        let said = votes.iter().filter_map(|said| said.rays()?.get(ray));
        for angle in said {
            let degree = angle.to_degrees().round() as i64;
            ways.entry(degree).or_insert((0, angle)).0 += 1;
        }
        let most = ways.values().map(|(count, _)| *count).max();
        let many = ways.len() > MANY_WAYS;
        for (count, angle) in ways.values() {
            let (direction, [start, tip]) = stage.ray(ray, *angle);
            let pen = match ray {
                Ray::Striker if many => Pen::new(role).dotted(),
                Ray::Striker => Pen::new(role),
                Ray::Target => Pen::new(role).dashed(),
            };
            picture.line(start, tip, pen);
            if !many || Some(*count) == most {
                picture.label(name, tip, &LabelSide::towards(direction), role);
            }
        }
    }
    picture.draw(buf, look);
}

/// Draws bars on a number line: the more answers are equal, the higher their bar.
fn draw_line(unit: &str, votes: &[Response], area: Rect, buf: &mut Buffer, look: &Look) {
    let numbers = votes.iter().filter_map(|said| match said {
        Response::Number(x) => Some(*x),
        Response::Shot(x) => Some(mm_from_m(*x)),
        _ => None,
    });
    let numbers: Vec<_> = numbers.collect();
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if numbers.is_empty() {
        Lines::new(area, buf, *look).paragraph("Nobody has voted.", Role::Text);
        return;
    }
    // Leaves some room on both sides, even if all answers are equal.
    let margin = (0.15 * (largest - least)).max(0.1 * largest.abs()).max(0.5);
    let votes = format!("your votes ({unit})");
    let x = Axis::linear(votes, least - margin, largest + margin);
    let mut heaps: Vec<(f64, usize)> = Vec::new();
    for number in &numbers {
        match heaps.iter_mut().find(|(x, _)| (x - number).abs() < 1e-9) {
            Some((_, count)) => *count += 1,
            None => heaps.push((*number, 1)),
        }
    }
    let highest = heaps.iter().map(|(_, count)| *count).max().unwrap_or(1);
    let y = Axis::linear("votes", 0.0, (highest + 1) as f64).every(1.0);
    let mut plot = Plot::new(area, *look, x, y);
    // Each bar is wide enough to be seen from the back row.
    let half = 0.012 * (largest - least + 2.0 * margin);
    for (number, count) in &heaps {
        plot.bar(number - half, number + half, *count as f64, Role::Predicted);
    }
    for (number, count) in &heaps {
        let label = format!("{}", (number * 1000.0).round() / 1000.0 + 0.0);
        let at = dvec2(*number, *count as f64);
        let sides = [LabelSide::Above, LabelSide::AboveRight];
        plot.label(&label, at, &sides, Role::Title);
    }
    plot.picture().draw(buf, look);
}

//! How the first votes are spread, without the truth and without names: something to
//! talk about.

use glam::dvec2;
use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};

use super::play::ClassPlay;
use super::view::{Text, column, slot, teams};
use crate::class::Vote;
use crate::physics::Collision;
use crate::physics::units::mm_from_m;
use crate::quiz::{Form, Question, Ray, Response, letter};
use crate::widgets::bar::bar;
use crate::widgets::big::{Align, Big};
use crate::widgets::hit::{HitLayout, degrees};
use crate::widgets::panels::draw_panel;
use crate::widgets::picture::{LabelSide, Pen, Picture};
use crate::widgets::plot::{Axis, Plot};
use crate::widgets::{Lines, Look, Role, SplitLayout, brief, draw_question};

/// Draws the spread; gives the list of rays beside their picture.
pub(super) fn draw<'a>(
    play: &'a ClassPlay,
    question: &'a Question,
    area: Rect,
    buf: &mut Buffer,
    look: &Look,
) -> Option<Text<'a>> {
    let votes: Vec<_> = play.round.said(play.number(), Vote::First).collect();
    match &question.form {
        Form::Choice { options, .. } => draw_bars(options, &votes, column(area), buf, look),
        Form::Rays { target, .. } => {
            let beside = SplitLayout::square(area);
            beside.draw(buf, look, "all who voted", "the votes");
            // The question's own labels stay whole.
            if let Some(collision) = question.picture.collision() {
                draw_fan(collision, &votes, beside.picture, buf, look);
            }
            draw_question(beside.picture, buf, look, question, None);
            let write = move |lines: &mut Lines| write_rays(play, question, target, &votes, lines);
            return Some((beside.panel, Box::new(write)));
        }
        Form::Number { quantity, .. } => draw_line(quantity.unit(), &votes, area, buf, look),
        Form::Shot(_) => {
            let unit = "mm offset, a minus for the left";
            draw_line(unit, &votes, area, buf, look);
        }
    }
    None
}

fn write_rays(
    play: &ClassPlay,
    question: &Question,
    target: &str,
    votes: &[Response],
    lines: &mut Lines,
) {
    lines.paragraph(&question.text, Role::Text);
    for (ray, name) in [(Ray::Striker, "striker"), (Ray::Target, target)] {
        lines.gap();
        lines.line(&format!("{name}, degrees"), Role::Dim);
        lines.paragraph(&listed(question, votes, ray), Role::Title);
    }
    let missing = play.round.teams().len() - votes.len();
    if missing > 0 {
        lines.gap();
        lines.paragraph(&format!("{} without a vote", teams(missing)), Role::Dim);
    }
}

/// The angles said of a ray, in order, with how many said the same: "30.0, 45.0 (2)".
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
    let words = shown.chunk_by(|a, b| a == b).map(|same| match same {
        [one] => one.clone(),
        _ => format!("{} ({})", same[0], same.len()),
    });
    words.collect::<Vec<_>>().join(", ")
}

/// All rays, from where the two will meet.
fn draw_fan(collision: &Collision, votes: &[Response], area: Rect, buf: &mut Buffer, look: &Look) {
    let stage = HitLayout::new(area, collision);
    let mut picture = Picture::new(stage.view);
    let bodies = [
        (Ray::Striker, "S", Role::StrikerOut),
        (Ray::Target, "C", Role::CoinOut),
    ];
    for said in votes {
        let Response::Rays(rays) = said else { continue };
        for (ray, name, role) in bodies {
            let Some(angle) = rays.get(ray) else {
                continue;
            };
            let (direction, [start, tip]) = stage.ray(ray, angle);
            let pen = match ray {
                Ray::Striker => Pen::new(role),
                Ray::Target => Pen::new(role).dashed(),
            };
            picture.line(start, tip, pen);
            picture.label(name, tip, &LabelSide::towards(direction), role);
        }
    }
    picture.draw(buf, look);
}

/// Columns of a letter or a number in large type beside a bar, with air.
const SIDE: u16 = 10;
/// Rows of it.
const LARGE: u16 = 4;

/// Bars for choices: how many teams are for each.
fn draw_bars(options: &[String], votes: &[Response], area: Rect, buf: &mut Buffer, look: &Look) {
    let rows = area.height / (options.len() as u16).max(1);
    let most = votes.len().max(1);
    for (i, option) in options.iter().enumerate() {
        let place = slot(area, i, rows);
        let count = votes.iter().filter(|said| **said == Response::Choice(i));
        let count = count.count();
        let sides = [letter(i).to_string(), count.to_string()];
        let large = sides.each_ref().map(|side| {
            let side = Big::fit(side, SIDE, LARGE, look.charset);
            side.filter(|_| rows > LARGE)
        });
        let [Some(name), Some(number)] = large else {
            let mut lines = Lines::new(place, buf, *look);
            lines.hanging(&format!("{}: ", letter(i)), option, Role::Text);
            let width = lines.width().saturating_sub(4);
            let bar = bar(count as f64 / most as f64, width, look.charset);
            lines.pair(&bar, &count.to_string(), Role::Predicted, Role::Title);
            continue;
        };
        name.draw(place, buf, look, Role::Title, Align::Left);
        number.draw(place, buf, look, Role::Title, Align::Right);
        let between = place.inner(Margin::new(SIDE, 0));
        let mut lines = Lines::new(between, buf, *look);
        lines.paragraph(option, Role::Text);
        let bar = bar(count as f64 / most as f64, between.width, look.charset);
        for _ in lines.written()..LARGE {
            lines.line(&bar, Role::Predicted);
        }
    }
}

/// Bars on a number line, the higher the more said the same.
fn draw_line(unit: &str, votes: &[Response], area: Rect, buf: &mut Buffer, look: &Look) {
    let numbers = votes.iter().filter_map(|said| match said {
        Response::Number(x) => Some(*x),
        Response::Shot(x) => Some(mm_from_m(*x)),
        _ => None,
    });
    let numbers: Vec<_> = numbers.collect();
    let area = column(area);
    let inside = draw_panel(buf, area, "the votes", look.charset, &look.theme);
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if numbers.is_empty() {
        Lines::new(inside, buf, *look).paragraph("Nobody has voted.", Role::Text);
        return;
    }
    // Some room on both sides, even where all said the same.
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
    let y = Axis::linear("teams", 0.0, (highest + 1) as f64).every(1.0);
    let mut plot = Plot::new(inside, *look, x, y);
    // Wide enough to be seen from the back row.
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
    plot.draw(buf);
}

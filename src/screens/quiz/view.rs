//! How the quiz looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Asked, Phase, Quiz, Watched, panel, summary};
use crate::physics::Frame;
use crate::quiz;
use crate::screens::Context;
use crate::widgets::hit::{Given, draw_setup};
use crate::widgets::panel::draw_panel;
use crate::widgets::{Beside, Lines, Look, Role};

/// Columns of the look back at most, with its frame.
const WIDEST: u16 = 108;

/// The frame of the look back.
fn summary_frame(area: Rect) -> Rect {
    let width = area.width.min(WIDEST);
    Rect {
        x: area.x + (area.width - width) / 2,
        width,
        ..area
    }
}

/// Where the text of the phase at hand is.
pub(super) fn text_area(quiz: &Quiz, area: Rect) -> Rect {
    let panel = match quiz.phase {
        Phase::Summary => {
            let frame = summary_frame(area);
            Rect::new(
                frame.x + 1,
                frame.y + 1,
                frame.width.saturating_sub(2),
                frame.height.saturating_sub(2),
            )
        }
        _ => Beside::new(area).panel,
    };
    // The notice has the top row to itself.
    let notice = u16::from(quiz.leaving).min(panel.height);
    Rect {
        y: panel.y + notice,
        height: panel.height - notice,
        ..panel
    }
}

/// Writes the text of the phase at hand.
pub(super) fn write(quiz: &Quiz, lines: &mut Lines, look: Look) {
    match &quiz.phase {
        Phase::Rays(asked) => panel::rays(asked, lines),
        Phase::Confidence(asked, chosen) => panel::confidence(asked, *chosen, lines),
        Phase::Watch(watched) if watched.told => panel::told(watched, lines, look.charset),
        Phase::Watch(watched) => panel::untold(watched, lines),
        Phase::Summary => summary::write(quiz, lines),
    }
}

/// Draws the quiz.
pub(super) fn draw(quiz: &Quiz, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = Beside::new(area);
    match &quiz.phase {
        Phase::Rays(asked) => {
            layout.draw(buf, &look, "where will they go?", "say it first");
            setup(asked, layout.picture, buf, &look);
        }
        Phase::Confidence(asked, _) => {
            layout.draw(buf, &look, "where will they go?", "say it first");
            setup(asked, layout.picture, buf, &look);
        }
        Phase::Watch(watched) => {
            let side = if watched.told { "and why" } else { "watch" };
            layout.draw(buf, &look, &title(watched), side);
            watched.watch.draw(layout.picture, buf, &look);
        }
        Phase::Summary => {
            let frame = summary_frame(area);
            draw_panel(buf, frame, "your round", look.charset, &look.theme);
        }
    }
    let text = text_area(quiz, area);
    if quiz.leaving {
        Lines::new(layout.panel, buf, look).line("Esc again leaves the round", Role::Warn);
    }
    quiz.scroll
        .draw(text, buf, look, |lines| write(quiz, lines, look));
}

/// What is asked, with no more drawn in than the question gives.
fn setup(asked: &Asked, area: Rect, buf: &mut Buffer, look: &Look) {
    let by_angle = matches!(asked.question.given, quiz::Given::Angle { .. });
    let given = Given {
        offset: !by_angle,
        angle: by_angle,
    };
    let collision = asked.question.collision();
    draw_setup(area, buf, look, &collision, given, Some(&asked.rays));
}

fn title(watched: &Watched) -> String {
    match watched.watch.frame() {
        Frame::Laboratory => {
            format!("the hit, slowed {:.0}×", watched.watch.clock().slowed())
        }
        Frame::CentreOfMass => "seen from the centre of mass".into(),
        Frame::Target => "seen riding with the target".into(),
    }
}

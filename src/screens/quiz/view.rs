//! How the quiz looks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Phase, Quiz, Watched, panel, summary};
use crate::physics::Frame;
use crate::quiz::{Picture, Question};
use crate::screens::Context;
use crate::widgets::panel::draw_panel;
use crate::widgets::{Beside, Lines, Look, Role, draw_question};

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

/// Where picture and panel are: the panel alone for what is asked in words.
pub(super) fn layout(quiz: &Quiz, area: Rect) -> Beside {
    match question(quiz).map(|question| &question.picture) {
        Some(Picture::Nothing) => Beside::text_alone(area),
        _ => Beside::new(area),
    }
}

/// The question at hand.
fn question(quiz: &Quiz) -> Option<&Question> {
    match &quiz.phase {
        Phase::Asked(asked) | Phase::Confidence(asked, _) => Some(&asked.question),
        Phase::Watch(watched) => Some(&watched.question),
        Phase::Summary => None,
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
        _ => layout(quiz, area).panel,
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
        Phase::Asked(asked) => panel::asked(asked, lines),
        Phase::Confidence(asked, chosen) => panel::confidence(asked, *chosen, lines),
        Phase::Watch(watched) if watched.told => panel::told(watched, lines, look.charset),
        Phase::Watch(watched) => panel::untold(watched, lines),
        Phase::Summary => summary::write(quiz, lines),
    }
}

/// Draws the quiz.
pub(super) fn draw(quiz: &Quiz, area: Rect, buf: &mut Buffer, cx: &Context) {
    let look = cx.settings.look();
    let layout = layout(quiz, area);
    match &quiz.phase {
        Phase::Asked(asked) | Phase::Confidence(asked, _) => {
            let title = asked.question.family.name();
            layout.draw(buf, &look, title, "say it first");
            draw_question(
                layout.picture,
                buf,
                &look,
                &asked.question,
                Some(&asked.input),
            );
        }
        Phase::Watch(watched) => {
            let side = if watched.told { "and why" } else { "watch" };
            layout.draw(buf, &look, &title(watched), side);
            if let Some(watch) = &watched.watch {
                watch.draw(layout.picture, buf, &look);
            }
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

fn title(watched: &Watched) -> String {
    let Some(watch) = &watched.watch else {
        return watched.question.family.name().into();
    };
    match watch.frame() {
        Frame::Laboratory => {
            format!("the hit, slowed {:.0}×", watch.clock().slowed())
        }
        Frame::CentreOfMass => "seen from the centre of mass".into(),
        Frame::Target => "seen riding with the target".into(),
    }
}

//! A chapter being read: text beside a figure, page by page, with checkpoints.

mod panel;
mod view;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::figure::{LiveFigure, svg_of};
use super::question::{Question, Said};
use super::record;
use crate::lessons::{Bookmark, Chapter, ChapterPage, CheckpointAnswer, Forget, GivenAnswer};
use crate::messages::{Input, Key, Mouse, MouseKind, StoreReply};
use crate::screens::{Context, Help, Hint, Next, OldScreen, Place};
use crate::widgets::{Scroll, SplitLayout, overflow};

/// A chapter being read.
#[derive(Debug, Clone)]
pub struct Reading {
    number: usize,
    chapter: Chapter,
    at: usize,
    figure: Option<LiveFigure>,
    question: Option<Question>,
    answer: Option<CheckpointAnswer>,
    /// Whether keys go to the figure first.
    on_figure: bool,
    /// The impact angle that was set since the bookmark was moved last, in degrees.
    alpha_deg: Option<f64>,
    /// Whether the student has been asked about beginning anew.
    forgetting: bool,
    scroll: Scroll,
    notice: Option<String>,
    /// Whether a page is open; none is before it is known where the chapter was left.
    is_open: bool,
}

impl Reading {
    /// A chapter, at the page where it was left; `None` beyond the last.
    pub fn new(number: usize, cx: &mut Context) -> Option<Self> {
        let mut reading = Self::closed(number, cx.book.chapter(number)?);
        cx.book.at = number;
        if cx.book.is_known() {
            reading.open_where_left(cx);
        }
        Some(reading)
    }

    fn closed(number: usize, chapter: &Chapter) -> Self {
        Self {
            number,
            chapter: chapter.clone(),
            at: 0,
            figure: None,
            question: None,
            answer: None,
            on_figure: false,
            alpha_deg: None,
            forgetting: false,
            scroll: Scroll::default(),
            notice: None,
            is_open: false,
        }
    }

    /// A page as it is before and, with an `answer`, after its checkpoint: to see
    /// whether it fits.
    pub(super) fn of_page(chapter: &Chapter, at: usize, answer: Option<CheckpointAnswer>) -> Self {
        let mut reading = Self::closed(0, chapter);
        reading.at = at;
        reading.lay_out(None, answer);
        reading
    }

    fn open_where_left(&mut self, cx: &mut Context) {
        let mark = cx.book.mark(&self.chapter.id);
        let at = mark.map_or(0, |mark| mark.page(&self.chapter));
        self.open(at, cx);
    }

    /// Opens a page.
    fn open(&mut self, at: usize, cx: &mut Context) {
        self.at = at.min(self.chapter.pages.len().saturating_sub(1));
        let Some(page) = self.chapter.pages.get(self.at) else {
            return;
        };
        let here = Bookmark {
            alpha_deg: self.alpha_deg.take(),
            ..Bookmark::at(page)
        };
        cx.mark(&self.chapter.id, here);
        let mark = cx.book.mark(&self.chapter.id);
        let answer = mark.and_then(|mark| mark.given(page));
        let answer = answer.map(|given| given.answer);
        self.lay_out(mark.and_then(|mark| mark.alpha_deg), answer);
    }

    fn lay_out(&mut self, alpha_deg: Option<f64>, answer: Option<CheckpointAnswer>) {
        self.is_open = true;
        self.scroll = Scroll::default();
        self.notice = None;
        let Some(page) = self.chapter.pages.get(self.at) else {
            return;
        };
        let hidden = page.checkpoint.is_some();
        let figure = page
            .figure
            .map(|figure| LiveFigure::new(figure, alpha_deg, hidden));
        let collision = figure.as_ref().map(|figure| *figure.collision());
        let question = page.checkpoint.as_ref();
        let question = question.map(|checkpoint| Question::new(checkpoint, collision.as_ref()));
        self.figure = figure;
        self.question = question;
        self.answer = None;
        self.on_figure = self.is_open_to_figure();
        if let Some(answer) = answer
            && self.question.is_some()
        {
            self.tell(answer, true);
        }
    }

    /// Whether keys go to the figure first on a page as it is opened.
    fn is_open_to_figure(&self) -> bool {
        !self.is_asking() && self.figure.as_ref().is_some_and(LiveFigure::is_set_by_keys)
    }

    fn page(&self) -> Option<&ChapterPage> {
        self.chapter.pages.get(self.at)
    }

    /// Whether a question waits for its answer.
    fn is_asking(&self) -> bool {
        self.question.is_some() && self.answer.is_none()
    }

    /// Shows what belongs to an answer.
    fn tell(&mut self, answer: CheckpointAnswer, reduced: bool) {
        self.answer = Some(answer);
        self.scroll = Scroll::default();
        if let Some(figure) = &mut self.figure {
            let said = match answer {
                CheckpointAnswer::Rays(rays) => Some(rays),
                _ => None,
            };
            figure.reveal(said, reduced);
        }
        self.on_figure = self.is_open_to_figure();
    }

    /// Takes an answer: marks it, keeps it, and tells what is so.
    fn answered(&mut self, answer: CheckpointAnswer, cx: &mut Context) {
        let Some(page) = self.page() else {
            return;
        };
        let Some(checkpoint) = &page.checkpoint else {
            return;
        };
        let figure = self.figure.as_ref().map(LiveFigure::collision);
        let right = answer.is_right(checkpoint, figure);
        let player = &cx.settings.player;
        let attempt = record::attempt(player, &self.chapter, self.at, &answer, checkpoint, figure);
        let given = GivenAnswer {
            asked: checkpoint.written.clone(),
            answer,
            right,
        };
        let mut mark = Bookmark::at(page);
        mark.pages.insert(page.title.clone(), Some(given));
        cx.record(attempt);
        cx.mark(&self.chapter.id, mark);
        self.tell(answer, cx.settings.reduced_motion);
    }

    fn key(&mut self, key: Key, cx: &mut Context) -> Next {
        self.notice = None;
        if std::mem::take(&mut self.forgetting) {
            if let Key::Char('y' | 'Y') = key {
                self.begin_anew(cx);
            }
            return Next::Stay;
        }
        if self.is_asking()
            && !self.on_figure
            && let Some(question) = &mut self.question
        {
            match question.update(key) {
                Said::Part => {
                    self.show_answer(cx);
                    return Next::Stay;
                }
                Said::Answer(answer) => {
                    self.answered(answer, cx);
                    return Next::Stay;
                }
                Said::Nothing => {}
            }
        }
        let scrolls = matches!(key, Key::Up | Key::Down);
        if (self.on_figure || !scrolls) && self.figure_key(key) {
            return Next::Stay;
        }
        match key {
            Key::Tab | Key::BackTab if self.figure.is_some() => self.on_figure = !self.on_figure,
            Key::Up => {
                self.scroll_by(-1, cx);
            }
            Key::Down => {
                self.scroll_by(1, cx);
            }
            Key::PageUp => {
                if !self.scroll_by(-8, cx) {
                    return self.back(cx);
                }
            }
            Key::PageDown => {
                if !self.scroll_by(8, cx) {
                    return self.on(cx);
                }
            }
            Key::Enter | Key::Char(' ') if self.is_asking() => self.on_figure = false,
            Key::Enter | Key::Char(' ' | 'n' | 'N') => return self.on(cx),
            Key::Char('b' | 'B') => return self.back(cx),
            Key::Char('r') => self.ask_again(cx),
            Key::Char('R') => {
                self.forgetting = true;
                self.notice = Some("Forget your answers here? y/n".into());
            }
            Key::Char('o' | 'O') => return self.full_size(),
            Key::Char('e' | 'E') => self.export(cx),
            Key::Escape => {
                self.keep_alpha(cx);
                return Next::Back;
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn begin_anew(&mut self, cx: &mut Context) {
        cx.forget(Forget::Chapter(self.chapter.id.clone()));
        self.alpha_deg = None;
        self.open(0, cx);
        self.notice = Some("The chapter begins anew.".into());
    }

    /// Gives a key to the figure; says whether it was one of its own.
    fn figure_key(&mut self, key: Key) -> bool {
        let used = self
            .figure
            .as_mut()
            .is_some_and(|figure| figure.update(key));
        if used {
            self.note_alpha();
        }
        used
    }

    /// Notes the impact angle that the student has set.
    fn note_alpha(&mut self) {
        let figure = self.figure.as_ref();
        if let Some(figure) = figure.filter(|figure| figure.is_own()) {
            self.alpha_deg = Some(figure.alpha_deg());
        }
    }

    /// Keeps the impact angle that the student has set: not at each step of a dial, but
    /// when the page is left.
    fn keep_alpha(&mut self, cx: &mut Context) {
        if let Some(alpha_deg) = self.alpha_deg.take() {
            let later = Bookmark {
                alpha_deg: Some(alpha_deg),
                ..Bookmark::default()
            };
            cx.mark(&self.chapter.id, later);
        }
    }

    /// To the next page; from the last one to the contents.
    fn on(&mut self, cx: &mut Context) -> Next {
        if self.at + 1 < self.chapter.pages.len() {
            self.open(self.at + 1, cx);
            return Next::Stay;
        }
        let first = Bookmark {
            place: self.chapter.pages.first().map(|page| page.title.clone()),
            alpha_deg: self.alpha_deg.take(),
            ..Bookmark::default()
        };
        cx.mark(&self.chapter.id, first);
        // The next chapter, or after the last one how far one has come.
        cx.book.at = self.number + 1;
        Next::Back
    }

    fn back(&mut self, cx: &mut Context) -> Next {
        if self.at > 0 {
            self.open(self.at - 1, cx);
        }
        Next::Stay
    }

    fn ask_again(&mut self, cx: &mut Context) {
        if let Some(page) = self.page() {
            cx.forget(Forget::Answer {
                chapter: self.chapter.id.clone(),
                page: page.title.clone(),
            });
        }
        self.open(self.at, cx);
    }

    /// The figure in the lab, or the foil.
    fn full_size(&mut self) -> Next {
        let Some(figure) = &self.figure else {
            return Next::Stay;
        };
        match figure.foil_page() {
            None => {
                let setup = figure.setup();
                Next::Open(Place::LabOf { setup })
            }
            // It would show the answer.
            Some(_) if self.is_asking() => {
                self.notice = Some("First say what you think.".into());
                Next::Stay
            }
            Some(page) => Next::Open(Place::FoilAt { page }),
        }
    }

    fn export(&mut self, cx: &mut Context) {
        if self.is_asking() {
            self.notice = Some("First say what you think.".into());
        } else if let Some(figure) = &self.figure {
            let name = format!("carrom-{}-{}.svg", self.chapter.id, self.at + 1);
            let look = cx.settings.look();
            cx.export(name, svg_of(figure, &look));
        }
    }

    /// Scrolls the text; says whether there was more of it.
    fn scroll_by(&mut self, rows: i16, cx: &Context) -> bool {
        let area = view::layout(self, cx.body).panel;
        let mut scroll = self.scroll;
        scroll.by(rows, area, cx.settings.look(), |lines| {
            panel::write(self, lines);
        });
        let moved = scroll != self.scroll;
        self.scroll = scroll;
        moved
    }

    /// Scrolls the answer in the making into sight.
    fn show_answer(&mut self, cx: &Context) {
        let (area, look) = (view::layout(self, cx.body).panel, cx.settings.look());
        if let Some(row) = panel::row_of_answer(self, area, look) {
            let mut scroll = self.scroll;
            scroll.show(row, area, look, |lines| panel::write(self, lines));
            self.scroll = scroll;
        }
    }

    /// Rows that the text takes, and rows there are for it.
    pub(super) fn rows(&self, cx: &Context) -> (u16, u16) {
        let area = view::layout(self, cx.body).panel;
        let more = overflow(area, cx.settings.look(), |lines| panel::write(self, lines));
        (area.height + more, area.height)
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let SplitLayout { picture, panel, .. } = view::layout(self, cx.body);
        let cell = (mouse.column, mouse.row);
        let look = cx.settings.look();
        if picture.contains(cell.into()) {
            let rays = match &mut self.question {
                Some(Question::Rays(rays)) if self.answer.is_none() => Some(rays),
                _ => None,
            };
            let used = self
                .figure
                .as_mut()
                .is_some_and(|figure| figure.mouse(mouse, picture, rays, &look));
            if used {
                self.note_alpha();
                return Next::Stay;
            }
        } else if panel.contains(cell.into()) {
            match mouse.kind {
                MouseKind::ScrollUp => {
                    self.scroll_by(-1, cx);
                    return Next::Stay;
                }
                MouseKind::ScrollDown => {
                    self.scroll_by(1, cx);
                    return Next::Stay;
                }
                MouseKind::Down if self.is_asking() => {
                    let line = panel::choice_at(self, panel, cell, look);
                    if let (Some(line), Some(question)) = (line, &mut self.question) {
                        if question.choose(line) {
                            self.answered(CheckpointAnswer::Choice(line), cx);
                        }
                        return Next::Stay;
                    }
                }
                _ => {}
            }
        }
        Next::Ignored
    }
}

impl OldScreen for Reading {
    fn title(&self) -> String {
        format!("{} {}", self.chapter.number, self.chapter.title)
    }

    fn status(&self, _cx: &Context) -> String {
        if !self.is_open {
            return String::new();
        }
        format!("page {} of {}", self.at + 1, self.chapter.pages.len())
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        if !self.is_open {
            if matches!(input, Input::Kept(answer) if matches!(answer.done, StoreReply::Marks(_))) {
                self.open_where_left(cx);
            }
            return Next::Ignored;
        }
        match input {
            Input::Key(key) => self.key(*key, cx),
            Input::Mouse(_) if self.forgetting => Next::Stay,
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            Input::Exported(exported) => {
                cx.tell_of_export("figure", exported);
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, passed: Duration, _cx: &mut Context) -> Next {
        if let Some(figure) = &mut self.figure {
            figure.advance(passed);
        }
        Next::Stay
    }

    fn wake(&self, _cx: &Context) -> Option<Duration> {
        self.figure.as_ref()?.wake()
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }

    fn keys(&self, _cx: &Context) -> Vec<Hint> {
        if !self.is_open {
            return vec![Hint::new("Esc", "contents")];
        }
        if self.forgetting {
            return vec![
                Hint::new("y", "begin the chapter anew"),
                Hint::new("any other key", "leave it"),
            ];
        }
        // What is needed comes first: where there is no room for all, the rest gives way.
        let leave = Hint::new("Esc", "contents");
        let mut keys = Vec::new();
        if self.is_asking() && !self.on_figure {
            keys.extend(match &self.question {
                Some(Question::Rays(_)) => vec![
                    Hint::new("Enter", "next, then watch"),
                    Hint::new("arrows", "turn"),
                    leave,
                    Hint::new("0-9", "type"),
                    Hint::new("x", "stays still"),
                ],
                Some(Question::Number(_)) => vec![
                    Hint::new("0-9", "type"),
                    Hint::new("Enter", "say it"),
                    leave,
                ],
                _ => vec![
                    Hint::new("Up Down", "choose"),
                    Hint::new("Enter", "say it"),
                    leave,
                ],
            });
            keys.push(Hint::new("n", "skip"));
        } else {
            let is_last = self.at + 1 >= self.chapter.pages.len();
            let on = if is_last { "finish" } else { "next page" };
            keys.extend([Hint::new("Enter", on), leave]);
            let figure = self.figure.iter().flat_map(LiveFigure::keys);
            keys.extend(figure.map(|(key, does)| Hint::new(key, does)));
        }
        keys.push(Hint::new("b", "back"));
        if let Some(figure) = &self.figure {
            keys.push(Hint::new(
                "Tab",
                if self.on_figure { "text" } else { "figure" },
            ));
            keys.push(match figure.foil_page() {
                None => Hint::new("o", "in the lab"),
                Some(_) => Hint::new("o", "the foil"),
            });
            keys.push(Hint::new("e", "export"));
        }
        keys
    }

    fn help(&self, _cx: &Context) -> Help {
        Help {
            text: vec![
                "A chapter: a few lines to read, beside a figure that is the real thing. Where a question is asked, say first what you think; only then the figure shows what happens. Your place is kept.",
                "Every page can be read again, skipped, or asked again. A wrong answer is a good start: the explanation begins from it.",
            ],
            keys: vec![
                Hint::new("Enter", "give the answer, then go on to the next page"),
                Hint::new("n b", "next page, page before; PageDown and PageUp too"),
                Hint::new("Tab", "let keys go to the figure first, or to the text"),
                Hint::new(
                    "Left Right",
                    "in a figure: change α, step through the hit or through the working",
                ),
                Hint::new("< >", "the same in bigger steps"),
                Hint::new("Space", "in a hit: go on from the contact"),
                Hint::new("a f 1-7", "in a hit: play again, other frame, layers"),
                Hint::new("o", "open the figure full-size: in the lab, or on the foil"),
                Hint::new("e", "export the figure as an SVG picture"),
                Hint::new("r", "ask this page's question again"),
                Hint::new("R", "forget all answers of this chapter and begin anew"),
            ],
        }
    }
}

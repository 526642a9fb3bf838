//! A chapter being read: text beside a figure, page by page, with checkpoints.

mod panel;
mod view;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::figure::{FigureAction, LiveFigure, svg_of};
use super::question::{CheckpointAction, CheckpointInput};
use super::record;
use crate::lessons::{Bookmark, Chapter, ChapterPage, Forget};
use crate::messages::{Input, Key, Mouse, MouseKind, StoreReply};
use crate::physics::Collision;
use crate::quiz::Response;
use crate::screens::{Confirmation, Context, Next, Place, Screen};
use crate::widgets::hit::{HitPace, Watch};
use crate::widgets::input::KeyTable;
use crate::widgets::{Lines, Look, Outcome, Scroll, SplitLayout, overflow};

/// What keys do in a chapter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum ReadingAction {
    /// answer the question
    Answer(CheckpointAction),
    /// work the figure
    Figure(FigureAction),
    /// let keys go to the figure first, or to the text
    Switch,
    /// go on to the next page, whether the question is answered or not
    Next,
    /// the page before
    Back,
    /// scroll, or to the page before or the next one
    Page(i16),
    /// scroll
    Scroll(i16),
    /// show how it is, without a second try
    ShowIt,
    /// ask this page's question again
    AskAgain,
    /// forget all answers of this chapter and start it over
    Forget,
    /// open the figure full-size: in the lab, or on the foil
    FullSize,
    /// export the figure as an SVG picture
    Export,
    /// leave the chapter
    Leave,
}

/// A chapter being read.
#[derive(Debug, Clone)]
pub(crate) struct Reading {
    number: usize,
    chapter: Chapter,
    at: usize,
    figure: Option<LiveFigure>,
    question: Option<CheckpointInput>,
    answer: Option<Response>,
    /// The wrong answer before it, after which there was a hint; while there is no answer
    /// yet, the second try is being made.
    first: Option<Response>,
    /// Whether keys go to the figure first.
    on_figure: bool,
    /// The impact angle that was set since the bookmark was moved last, in degrees.
    alpha_deg: Option<f64>,
    scroll: Scroll,
    notice: Option<String>,
    /// Whether a page is open; none is before it is known where the chapter was left.
    is_open: bool,
    /// The page that it was opened at to look something up.
    visited: Option<usize>,
}

impl Reading {
    /// A chapter, at the page where it was left; `None` beyond the last.
    pub(crate) fn new(number: usize, cx: &mut Context) -> Option<Self> {
        let mut reading = Self::closed(number, cx.book.chapter(number)?);
        cx.book.at = number;
        if cx.book.is_known() {
            reading.open_where_left(cx);
        }
        Some(reading)
    }

    /// A chapter, opened at a page to look something up; `None` beyond the last. Where it
    /// was left stays.
    pub(crate) fn visit(number: usize, page: usize, cx: &mut Context) -> Option<Self> {
        let mut reading = Self::closed(number, cx.book.chapter(number)?);
        reading.visited = Some(page);
        cx.ask_for_marks();
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
            first: None,
            on_figure: false,
            alpha_deg: None,
            scroll: Scroll::default(),
            notice: None,
            is_open: false,
            visited: None,
        }
    }

    /// A page as it is before its checkpoint, after a `first` wrong answer to it, or with an
    /// `answer` after it: to see whether it fits.
    pub(super) fn of_page(
        chapter: &Chapter,
        at: usize,
        first: Option<Response>,
        answer: Option<Response>,
    ) -> Self {
        let mut reading = Self::closed(0, chapter);
        reading.at = at;
        reading.lay_out(None, answer.map(|answer| (answer, first)));
        reading.first = first;
        reading
    }

    fn open_where_left(&mut self, cx: &mut Context) {
        let mark = cx.book.mark(&self.chapter.id);
        let left = mark.map_or(0, |mark| mark.page(&self.chapter));
        self.open(self.visited.unwrap_or(left), cx);
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
        self.mark(here, cx);
        let mark = cx.book.mark(&self.chapter.id);
        let answer = mark.and_then(|mark| mark.given(page));
        let answer = answer.map(|given| (given.answer, given.first));
        self.lay_out(mark.and_then(|mark| mark.alpha_deg), answer);
    }

    /// Keeps what was done; who looks something up keeps the place where they read on.
    fn mark(&self, mut later: Bookmark, cx: &mut Context) {
        if self.visited.is_some() {
            later.place = None;
        }
        cx.mark(&self.chapter.id, later);
    }

    fn lay_out(&mut self, alpha_deg: Option<f64>, tries: Option<(Response, Option<Response>)>) {
        self.is_open = true;
        self.scroll = Scroll::default();
        self.notice = None;
        let Some(page) = self.chapter.pages.get(self.at) else {
            return;
        };
        let (figure, checkpoint) = (page.figure, page.checkpoint.as_ref());
        let hidden = checkpoint.is_some();
        let figure = figure.map(|figure| LiveFigure::new(figure, alpha_deg, hidden));
        let collision = figure.as_ref().map(LiveFigure::collision);
        self.question = checkpoint.map(|asked| CheckpointInput::new(asked, collision));
        self.figure = figure;
        self.answer = None;
        self.first = None;
        self.on_figure = self.is_open_to_figure();
        if let Some((answer, first)) = tries
            && self.question.is_some()
        {
            self.first = first;
            self.tell(answer, HitPace::Still);
            self.figure.iter_mut().for_each(LiveFigure::tell);
        }
    }

    /// Whether keys go to the figure first on a page as it is opened.
    fn is_open_to_figure(&self) -> bool {
        !self.is_asking() && self.figure.as_ref().is_some_and(LiveFigure::is_set_by_keys)
    }

    fn page(&self) -> Option<&ChapterPage> {
        self.chapter.pages.get(self.at)
    }

    /// The collision of the figure.
    fn collision(&self) -> Option<&Collision> {
        self.figure.as_ref().map(LiveFigure::collision)
    }

    /// Whether a question waits for its answer.
    fn is_asking(&self) -> bool {
        self.question.is_some() && self.answer.is_none()
    }

    /// The hit that is just telling what happens, step by step.
    fn telling(&self) -> Option<&Watch> {
        let watch = self.figure.as_ref().and_then(LiveFigure::watch);
        watch.filter(|watch| !self.is_asking() && !watch.is_told())
    }

    /// Shows what belongs to an answer.
    fn tell(&mut self, answer: Response, pace: HitPace) {
        self.answer = Some(answer);
        self.scroll = Scroll::default();
        if let Some(figure) = &mut self.figure {
            figure.reveal(answer.rays(), pace);
        }
        self.on_figure = self.is_open_to_figure();
    }

    /// Takes an answer: marks it and keeps it. A first wrong one gets a hint, if there is
    /// one, else it is told what is so.
    fn answered(&mut self, answer: Response, cx: &mut Context) {
        let Some(page) = self.page() else {
            return;
        };
        let Some(checkpoint) = &page.checkpoint else {
            return;
        };
        let figure = self.collision();
        let player = &cx.settings.player;
        let tried = (&answer, self.first.is_some());
        let attempt = record::attempt(player, &self.chapter, self.at, tried, checkpoint, figure);
        let right = attempt.right;
        cx.record(attempt);
        if self.first.is_none() && checkpoint.offers_second_try(&answer, figure) {
            let anew = |question: &CheckpointInput| question.anew(checkpoint, figure);
            self.question = self.question.as_ref().map(anew);
            self.first = Some(answer);
            self.scroll = Scroll::default();
            return;
        }
        let mark = Bookmark::answering(page, checkpoint, (answer, self.first), right);
        self.mark(mark, cx);
        self.tell(answer, cx.settings.pace());
    }

    /// Tells what is so after the first try alone.
    fn show_it(&mut self, cx: &mut Context) {
        let first = self.first.take();
        if let Some((page, answer)) = self.page().zip(first)
            && let Some(checkpoint) = &page.checkpoint
        {
            let mark = Bookmark::answering(page, checkpoint, (answer, None), false);
            self.mark(mark, cx);
            self.tell(answer, cx.settings.pace());
        }
    }

    fn begin_anew(&mut self, cx: &mut Context) {
        cx.forget(Forget::Chapter(self.chapter.id.clone()));
        self.alpha_deg = None;
        self.open(0, cx);
        self.notice = Some("The chapter starts over.".into());
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
        self.mark(first, cx);
        if self.visited.is_none() {
            // The next chapter, or after the last one how far one has come.
            cx.book.at = self.number + 1;
        }
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
        let area = view::layout(self, cx.room()).panel;
        let write = |lines: &mut Lines| panel::write(self, lines);
        let before = self.scroll;
        self.scroll = before.by(rows, area, cx.settings.look(), write);
        self.scroll != before
    }

    /// Scrolls the answer in the making into sight.
    fn show_answer(&mut self, cx: &Context) {
        let (area, look) = (view::layout(self, cx.room()).panel, cx.settings.look());
        if let Some(row) = panel::row_of_answer(self, area, look) {
            let write = |lines: &mut Lines| panel::write(self, lines);
            self.scroll = self.scroll.show(row, area, look, write);
        }
    }

    /// Rows that the text takes, and rows there are for it.
    pub(super) fn rows(&self, cx: &Context) -> (u16, u16) {
        let area = view::layout(self, cx.room()).panel;
        let more = overflow(area, cx.settings.look(), |lines| panel::write(self, lines));
        (area.height + more, area.height)
    }

    /// The mouse over the picture.
    fn point(&mut self, mouse: &Mouse, picture: Rect, look: &Look) -> Next {
        let question = self.question.as_mut().filter(|_| self.answer.is_none());
        let rays = question.and_then(CheckpointInput::rays_mut);
        let figure = self.figure.as_mut();
        let used = figure.is_some_and(|figure| figure.mouse(mouse, picture, rays, look));
        if used {
            self.note_alpha();
        }
        Next::after(used)
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let SplitLayout { picture, panel, .. } = view::layout(self, cx.room());
        let (cell, look) = (mouse.cell(), cx.settings.look());
        if picture.contains(cell.into()) {
            return self.point(mouse, picture, &look);
        }
        if !panel.contains(cell.into()) {
            return Next::Ignored;
        }
        if let Some(by) = mouse.wheel() {
            self.scroll_by(-i16::from(by), cx);
            return Next::Stay;
        }
        if mouse.kind == MouseKind::Down
            && self.is_asking()
            && let Some(line) = panel::choice_at(self, panel, cell, look)
            && let Some(question) = &mut self.question
        {
            if question.choose(line) {
                self.answered(Response::Choice(line), cx);
            }
            return Next::Stay;
        }
        Next::Ignored
    }
}

impl Screen for Reading {
    type Action = ReadingAction;

    fn title(&self) -> String {
        format!("{} {}", self.chapter.number, self.chapter.title)
    }

    fn status(&self, _cx: &Context) -> String {
        if !self.is_open {
            return String::new();
        }
        format!("page {} of {}", self.at + 1, self.chapter.pages.len())
    }

    fn keys(&self, _cx: &Context) -> KeyTable<ReadingAction> {
        use ReadingAction::{
            Answer, AskAgain, Back, Export, Figure, Forget, FullSize, Leave, Next, Page, Scroll,
            ShowIt, Switch,
        };
        let keys = || KeyTable::new("reading");
        let asking = self.is_asking();
        let answering = asking && !self.on_figure;
        let telling = self.telling().is_some();
        let away = self.visited.map_or("contents", |_| "back");
        if !self.is_open {
            return keys().on(Key::Escape, Leave, away);
        }
        let question = self.question.iter().filter(|_| answering);
        let mut table = question.fold(keys(), |table, it| table.with(it.keys(), Answer));
        let on = match self.at + 1 >= self.chapter.pages.len() {
            true => "finish",
            false => "next page",
        };
        let here = keys()
            .on(Key::Char('s'), ShowIt, "show it")
            .when(asking && self.first.is_some())
            .on(Key::Enter, Switch, "text")
            .when(asking && self.on_figure)
            .on(Key::Enter, Next, on)
            .or([(Key::Char('n'), Next)])
            .when(!asking && !telling)
            // Enter and Space go through what the hit tells.
            .on(Key::Char('n'), Next, on)
            .when(telling)
            .on(Key::Escape, Leave, away)
            .on(Key::Char('n'), Next, "skip")
            .when(asking);
        table = table.with(here, |action| action);
        if let Some(figure) = &self.figure {
            // Up and Down scroll the text, unless keys go to the figure first.
            let lines: &[Key] = match self.on_figure {
                true => &[],
                false => &[Key::Up, Key::Down],
            };
            table = table.with(figure.keys().without_keys(lines), Figure);
        }
        let foil = self.figure.as_ref().and_then(LiveFigure::foil_page);
        let full_size = foil.map_or("in the lab", |_| "the foil");
        let other = if self.on_figure { "text" } else { "figure" };
        let rest = keys()
            .on(Key::Char(' '), Next, "")
            .when(!asking)
            .on(Key::Char('b'), Back, "back")
            .on(Key::Tab, Switch, other)
            .or([(Key::BackTab, Switch)])
            .when(self.figure.is_some())
            .on(Key::Char('o'), FullSize, full_size)
            .when(self.figure.is_some())
            .on(Key::Char('e'), Export, "export")
            .when(self.figure.is_some())
            .each([(Key::Up, Scroll(-1)), (Key::Down, Scroll(1))], "")
            .each([(Key::PageUp, Page(-1)), (Key::PageDown, Page(1))], "")
            .on(Key::Char('r'), AskAgain, "")
            .when(self.question.is_some())
            .on(Key::Char('R'), Forget, "");
        table.with(rest, |action| action).distinct()
    }

    fn about(&self, _cx: &Context) -> Vec<&'static str> {
        vec![
            "A chapter: a few lines to read, beside a figure that is the real thing. Where a question is asked, say first what you think; only then the figure shows what happens. Your place is kept.",
            "Every page can be read again, skipped, or asked again. A wrong answer is a good start: mostly you get a hint and a second try, for half the credit, and the explanation begins from what you said.",
        ]
    }

    fn act(&mut self, action: ReadingAction, cx: &mut Context) -> Next {
        self.notice = None;
        match action {
            ReadingAction::Answer(action) => {
                let outcome = self.question.as_mut().map(|question| question.act(action));
                match outcome {
                    Some(Outcome::Done(answer)) => self.answered(answer, cx),
                    Some(Outcome::Used) => self.show_answer(cx),
                    _ => {}
                }
            }
            ReadingAction::Figure(action) => {
                if let Some(figure) = &mut self.figure {
                    figure.act(action);
                    self.note_alpha();
                }
            }
            ReadingAction::Switch => self.on_figure = !self.on_figure,
            ReadingAction::Next => return self.on(cx),
            ReadingAction::Back => return self.back(cx),
            ReadingAction::Page(by) => {
                if !self.scroll_by(Scroll::PAGE * by, cx) {
                    return if by < 0 { self.back(cx) } else { self.on(cx) };
                }
            }
            ReadingAction::Scroll(by) => {
                self.scroll_by(by, cx);
            }
            ReadingAction::ShowIt => self.show_it(cx),
            ReadingAction::AskAgain => self.ask_again(cx),
            ReadingAction::Forget => {
                return Next::Confirm(Confirmation::new(
                    "Forget your answers in this chapter, and start it over?",
                    "start it over",
                    "leave it",
                ));
            }
            ReadingAction::FullSize => return self.full_size(),
            ReadingAction::Export => self.export(cx),
            ReadingAction::Leave => {
                self.keep_alpha(cx);
                return Next::Back;
            }
        }
        Next::Stay
    }

    fn confirmed(&mut self, _forget: ReadingAction, cx: &mut Context) -> Next {
        self.begin_anew(cx);
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Kept(answer) if matches!(answer.done, StoreReply::Marks(_)) => {
                if !self.is_open {
                    self.open_where_left(cx);
                }
                Next::Ignored
            }
            Input::Mouse(mouse) if self.is_open => self.mouse(mouse, cx),
            Input::Exported(exported) if self.is_open => {
                cx.tell_of_export("figure", exported);
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        if let Some(figure) = &mut self.figure {
            figure.advance(passed, cx.settings.pace());
        }
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        self.figure.as_ref()?.wake(cx.settings.pace())
    }

    fn draw(&self, _area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, buf, cx);
    }
}

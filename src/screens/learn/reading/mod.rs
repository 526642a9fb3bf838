//! A chapter being read: text beside a figure, page by page, with checkpoints.

mod page;
mod panel;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::figure::{FigureAction, LiveFigure, svg_of, words};
use super::record;
use crate::lessons::{Bookmark, Chapter, Forget};
use crate::messages::{Input, Key, Mouse, StoreReply};
use crate::physics::CollisionSpec;
use crate::quiz::Response;
use crate::screens::{Confirmation, Context, Next, Route, Screen, View};
use crate::widgets::input::{KeyTable, RayAction};
use crate::widgets::panel::Panel;
use crate::widgets::{
    AnswerAction, AnswerInput, Look, Outcome, PAGE_ROWS, RayInput, Role, SplitLayout, sheet,
};

use page::{CheckpointStage, OpenPage};

/// What the keys do in a chapter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum ReadingAction {
    /// answer the question
    Answer(AnswerAction),
    /// use the figure
    Figure(FigureAction),
    /// send keys to the figure first, or to the text
    Switch,
    /// go to the next page, even if the question is not answered
    Next,
    /// go to the previous page
    Back,
    /// scroll, or go to the previous or next page
    Page(i16),
    /// show the answer, without a second try
    ShowIt,
    /// ask this page's question again
    AskAgain,
    /// forget all answers in this chapter and start it again
    Forget,
    /// open the figure full-size: in the lab, or in the foil
    FullSize,
    /// export the figure as an SVG picture
    Export,
    /// leave the chapter
    Leave,
}

#[derive(Debug, Clone)]
pub(crate) struct Reading {
    number: usize,
    chapter: Chapter,
    at: usize,
    /// The open page; `None` until the bookmark is known.
    open: Option<OpenPage>,
    /// The impact angle in degrees, if it has been set since the bookmark was last moved.
    alpha_deg: Option<f64>,
    notice: Option<&'static str>,
    /// The page that was opened to look something up.
    visited: Option<usize>,
}

/// Why the figure cannot be opened full-size or exported yet.
const SAY_FIRST: &str = "Give your answer first.";

impl Reading {
    /// A chapter, at the page where it was left or, to look something up, at the `visited` page;
    /// then the bookmark does not move. `None` if there is no such chapter.
    pub(crate) fn new(number: usize, visited: Option<usize>, cx: &mut Context) -> Option<Self> {
        let mut reading = Self {
            visited,
            ..Self::closed(number, cx.book.chapter(number)?)
        };
        match visited {
            None => cx.book.at = number,
            Some(_) => cx.ask_for_marks(),
        }
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
            open: None,
            alpha_deg: None,
            notice: None,
            visited: None,
        }
    }

    /// A page before its checkpoint is answered, after a `first` wrong answer, or with its final
    /// `answer`, to check whether it fits on the screen.
    pub(super) fn of_page(
        chapter: &Chapter,
        at: usize,
        first: Option<Response>,
        answer: Option<Response>,
    ) -> Self {
        let tries = answer.map(|answer| (answer, None));
        let page = chapter.pages.get(at).cloned();
        let mut open = page.map(|page| OpenPage::new(page, None, tries));
        if let (Some(open), Some(first)) = (&mut open, first)
            && let Some(form) = open.form()
        {
            open.ask_again(first, &form);
        }
        Self {
            at,
            open,
            ..Self::closed(0, chapter)
        }
    }

    fn open_where_left(&mut self, cx: &mut Context) {
        let left = cx.book.left_at(&self.chapter);
        self.open(self.visited.unwrap_or(left), cx);
    }

    fn open(&mut self, at: usize, cx: &mut Context) {
        self.at = at.min(self.chapter.pages.len().saturating_sub(1));
        let Some(page) = self.chapter.pages.get(self.at).cloned() else {
            return;
        };
        self.mark(Bookmark::at(&page), cx);
        let mark = cx.book.mark(&self.chapter.id);
        let given = mark.and_then(|mark| mark.given(&page));
        let tries = given.map(|given| (given.answer, given.first));
        let alpha_deg = mark.and_then(|mark| mark.alpha_deg);
        self.open = Some(OpenPage::new(page, alpha_deg, tries));
        self.notice = None;
    }

    /// Saves the progress, and the impact angle that the student has set; looking something up does
    /// not move the bookmark.
    fn mark(&mut self, mut later: Bookmark, cx: &mut Context) {
        later.alpha_deg = self.alpha_deg.take();
        if self.visited.is_some() {
            later.place = None;
        }
        cx.mark(&self.chapter.id, later);
    }

    fn is_asking(&self) -> bool {
        self.open.as_ref().is_some_and(OpenPage::is_asking)
    }

    fn figure(&self) -> Option<&LiveFigure> {
        self.open.as_ref()?.figure.as_ref()
    }

    /// Handles an answer: marks and saves it. A first wrong answer may be followed by a hint and a
    /// second try; otherwise the right answer is shown.
    fn answered(&mut self, answer: Response, cx: &mut Context) {
        let Some(open) = &mut self.open else {
            return;
        };
        let (Some(checkpoint), Some(form)) = (&open.page.checkpoint, open.form()) else {
            return;
        };
        let (player, first) = (&cx.settings.player, open.first);
        let (asked, tried) = ((&form, open.collision()), (&answer, first.is_some()));
        let attempt = record::attempt(player, &self.chapter, self.at, asked, tried);
        cx.record(attempt);
        if first.is_none() && checkpoint.offers_second_try(&form, &answer) {
            return open.ask_again(answer, &form);
        }
        self.reveal((answer, first), form.is_right(&answer), cx);
    }

    /// Saves the final answer and the first one, if there was one, and shows the right answer.
    fn reveal(&mut self, tries: (Response, Option<Response>), right: bool, cx: &mut Context) {
        if let Some(open) = &mut self.open {
            open.reveal(tries.0, cx.settings.pace());
            let mark = Bookmark::answering(&open.page, tries, right);
            self.mark(mark, cx);
        }
    }

    /// Shows the right answer after the first try.
    fn show_it(&mut self, cx: &mut Context) {
        let first = self.open.as_mut().and_then(|open| open.first.take());
        if let Some(answer) = first {
            self.reveal((answer, None), false, cx);
        }
    }

    /// Records the impact angle that the student has set.
    fn note_alpha(&mut self) {
        if let Some(figure) = self.figure().filter(|it| it.figure.own) {
            self.alpha_deg = Some(figure.alpha_deg());
        }
    }

    /// Saves the impact angle that the student has set: not at each step, but when the page is
    /// left.
    fn keep_alpha(&mut self, cx: &mut Context) {
        if self.alpha_deg.is_some() {
            self.mark(Bookmark::default(), cx);
        }
    }

    /// Goes to the next page; leaves the chapter after the last one.
    fn on(&mut self, cx: &mut Context) -> Next {
        if self.at + 1 < self.chapter.pages.len() {
            self.open(self.at + 1, cx);
            return Next::Stay;
        }
        let first = Bookmark {
            place: self.chapter.pages.first().map(|page| page.title.clone()),
            ..Bookmark::default()
        };
        self.mark(first, cx);
        if self.visited.is_none() {
            // The contents then show the next chapter or, after the last one, the overall progress.
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
        if let Some(open) = &self.open {
            cx.forget(Forget::Answer {
                chapter: self.chapter.id.clone(),
                page: open.page.title.clone(),
            });
        }
        self.open(self.at, cx);
    }

    /// Opens the figure in the lab, or on the foil's own screen.
    fn full_size(&mut self) -> Next {
        let Some(figure) = self.figure() else {
            return Next::Stay;
        };
        match figure.foil_page() {
            None => {
                let setup = CollisionSpec::from(&figure.collision);
                // The lab must not show the answer either.
                let hidden = self.is_asking();
                Next::Open(Route::LabOf { setup, hidden })
            }
            // The foil's own screen would show the answer.
            Some(_) if self.is_asking() => {
                self.notice = Some(SAY_FIRST);
                Next::Stay
            }
            Some(page) => Next::Open(Route::Foil(page)),
        }
    }

    fn export(&mut self, cx: &mut Context) {
        if self.is_asking() {
            self.notice = Some(SAY_FIRST);
        } else if let Some(figure) = self.figure() {
            let name = format!("carrom-{}-{}.svg", self.chapter.id, self.at + 1);
            let look = cx.settings.look();
            cx.export(name, svg_of(figure, &look));
        }
    }

    /// The keys for answering. Enter switches to the other ray, because Tab switches to the figure.
    fn answer_keys(open: &OpenPage) -> KeyTable<AnswerAction> {
        // These names are left out, because on a small screen the bottom line needs their space for
        // the key that goes back to the contents.
        let spare = |action| {
            use AnswerAction::{Choose, Ray};
            matches!(action, Choose(_) | Ray(RayAction::StaysStill))
        };
        let input = open.input().filter(|_| !open.on_figure);
        let keys = input.map_or(KeyTable::new("answer"), |input| input.keys());
        let keys = keys.renamed("", spare);
        keys.without_keys(&[Key::Tab, Key::BackTab])
    }
}

impl Screen for Reading {
    type Action = ReadingAction;

    const HELP: &'static str = include_str!("help.txt");

    fn title(&self) -> String {
        format!("{} {}", self.chapter.number, self.chapter.title)
    }

    fn route(&self, _cx: &Context) -> Route {
        match self.visited {
            Some(visited) => Route::Page {
                chapter: self.number,
                page: self.open.as_ref().map_or(visited, |_| self.at),
            },
            None => Route::Chapter(self.number),
        }
    }

    fn status(&self, _cx: &Context) -> String {
        match self.open {
            Some(_) => format!("page {} of {}", self.at + 1, self.chapter.pages.len()),
            None => String::new(),
        }
    }

    fn keys(&self, _cx: &Context) -> KeyTable<ReadingAction> {
        use ReadingAction::{
            Answer, AskAgain, Back, Export, Figure, Forget, FullSize, Leave, Next, Page, ShowIt,
            Switch,
        };
        let keys = || KeyTable::new("reading");
        let away = self.visited.map_or("contents", |_| "back");
        let Some(open) = &self.open else {
            return keys().on(Key::Escape, Leave, away);
        };
        let (asking, explaining) = (open.is_asking(), open.explaining().is_some());
        // While a number is being typed, Enter and Escape apply to it.
        let typing = self.figure().is_some_and(LiveFigure::is_typing);
        let on = match self.at + 1 >= self.chapter.pages.len() {
            true => "finish",
            false => "next page",
        };
        let mut table = keys()
            .with(Self::answer_keys(open), Answer)
            .on(Key::Char('s'), ShowIt, "show it")
            .when(open.hinted().is_some())
            .on(Key::Enter, Switch, "text")
            .when(asking && open.on_figure)
            .on(Key::Enter, Next, on)
            .or([(Key::Char('n'), Next)])
            .when(!asking && !explaining && !typing)
            // Enter and Space step through the explanation of the collision, so going on has a
            // key of its own.
            .on(Key::Char('n'), Next, on)
            .when(explaining)
            .on(Key::Escape, Leave, away)
            .when(!typing)
            .on(Key::Char('n'), Next, "skip")
            .when(asking);
        if let Some(figure) = &open.figure {
            // Up and Down scroll the text, unless keys go to the figure first.
            let lines: &[Key] = match open.on_figure {
                true => &[],
                false => &[Key::Up, Key::Down],
            };
            table = table.with(figure.keys().without_keys(lines), Figure);
        }
        let has_figure = open.figure.is_some();
        let foil = self.figure().and_then(LiveFigure::foil_page);
        let full_size = foil.map_or("in the lab", |_| "the foil");
        let other = if open.on_figure { "text" } else { "figure" };
        table
            .on(Key::Char(' '), Next, "")
            .when(!asking)
            .on(Key::Char('b'), Back, "back")
            .on(Key::Tab, Switch, other)
            .or([(Key::BackTab, Switch)])
            .when(has_figure)
            .on(Key::Char('o'), FullSize, full_size)
            .when(self.figure().is_some_and(LiveFigure::is_for_the_lab))
            .on(Key::Char('e'), Export, "export")
            .when(has_figure)
            .each([(Key::PageUp, Page(-1)), (Key::PageDown, Page(1))], "")
            .on(Key::Char('r'), AskAgain, "")
            .when(open.stage.is_some())
            .on(Key::Char('R'), Forget, "")
            .distinct()
    }

    fn act(&mut self, action: ReadingAction, cx: &mut Context) -> Next {
        self.notice = None;
        match action {
            ReadingAction::Answer(action) => {
                let input = self.open.as_mut().and_then(OpenPage::input_mut);
                let outcome = input.map(|input| (input.act(action), input.said()));
                if let Some((Outcome::Done(()), Some(said))) = outcome {
                    self.answered(said, cx);
                }
            }
            ReadingAction::Figure(action) => {
                if let Some(figure) = self.open.as_mut().and_then(|it| it.figure.as_mut()) {
                    figure.act(action);
                    self.note_alpha();
                }
            }
            ReadingAction::Switch => {
                if let Some(open) = &mut self.open {
                    open.on_figure = !open.on_figure;
                }
            }
            ReadingAction::Next => return self.on(cx),
            ReadingAction::Back => return self.back(cx),
            ReadingAction::Page(by) => return Next::scroll(PAGE_ROWS * by),
            ReadingAction::ShowIt => self.show_it(cx),
            ReadingAction::AskAgain => self.ask_again(cx),
            ReadingAction::Forget => {
                let text = "Forget your answers in this chapter, and start it again?";
                return Next::Confirm(Confirmation::new(text, "start it again", "keep them"));
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
        cx.forget(Forget::Chapter(self.chapter.id.clone()));
        self.alpha_deg = None;
        self.open(0, cx);
        self.notice = Some("The chapter starts again.");
        Next::Stay
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Kept(answer)
                if self.open.is_none() && matches!(answer.done, StoreReply::Marks(_)) =>
            {
                self.open_where_left(cx);
                Next::Ignored
            }
            Input::Exported(exported) if self.open.is_some() => {
                cx.notify_of_export("figure", exported);
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn view<'s>(&'s self, cx: &'s Context) -> View<'s, ReadingAction> {
        let Some(open) = &self.open else {
            let mut panel = Panel::new(self.chapter.title.as_str());
            panel.line("Loading …", Role::Dim);
            return View::alone(SplitLayout::text_alone, panel);
        };
        let panel = panel::panel(open, self.at, self.notice, cx.settings.charset);
        let Some(figure) = &open.figure else {
            return View::alone(SplitLayout::text_alone, panel);
        };
        let rays = open.rays();
        let view = if let Some(worked) = figure.worked() {
            let mut shown = Panel::new(figure.title());
            shown.part(ReadingAction::Figure, |shown| {
                worked.write(&figure.collision, shown);
            });
            View::panels(shown, panel)
        } else {
            let title = rays.map_or_else(|| figure.title(), |_| "where will they go?".into());
            let draw = move |area: Rect, buf: &mut Buffer, look: &Look| {
                let later = self.chapter.pages.get(self.at + 1..).unwrap_or_default();
                sheet::next_picture_shows(|| words::describe(figure, later));
                figure.draw(area, buf, look, rays);
            };
            View::picture(title, draw, panel)
        };
        View {
            focus: Some(open.on_figure),
            drag: rays.map(|_| RayInput::DRAG),
            ..view.square()
        }
    }

    /// Handles the mouse over the picture.
    fn point(&mut self, mouse: &Mouse, picture: Rect, cx: &mut Context) -> Next {
        let used = picture.contains(mouse.cell().into())
            && self.open.as_mut().is_some_and(|open| {
                let rays = match &mut open.stage {
                    Some(CheckpointStage::Asking(AnswerInput::Rays(rays))) => Some(rays),
                    _ => None,
                };
                let figure = open.figure.as_mut();
                figure.is_some_and(|figure| figure.mouse(mouse, picture, rays, &cx.settings.look()))
            });
        if used {
            self.note_alpha();
        }
        Next::after(used)
    }

    /// Goes to another page when a page key scrolls the text beyond one of its ends.
    fn scrolled_out(&mut self, by: i16, cx: &mut Context) -> Next {
        match by {
            PAGE_ROWS => self.on(cx),
            by if by == -PAGE_ROWS => self.back(cx),
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        if let Some(figure) = self.open.as_mut().and_then(|it| it.figure.as_mut()) {
            figure.advance(passed, cx.settings.pace());
        }
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        self.figure()?.wake(cx.settings.pace())
    }
}

//! A screen in the app's stack: its keys are looked up here, so that the type of its actions is
//! hidden.

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::{Margin, Rect};
use strum::{EnumMessage, IntoStaticStr};

use super::view::{Part, PlacedPanel, PlacedView, View};
use super::{Context, Next, Route, Screen};
use crate::game::Rules;
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::widgets::input::KeyTable;
use crate::widgets::panel::{Panel, Placed, Writing};
use crate::widgets::{Item, Lines, Look, PAGE_ROWS, Role, Words, areas, sheet, text};

/// What the keys do on every screen, unless a screen uses a key for something else.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub enum SharedAction {
    /// explain this screen
    Help,
    /// go back
    Back,
    /// switch between ASCII and Unicode
    Charset,
    /// next theme: dark, light, no colour
    Theme,
    /// reduce motion, or restore it
    Motion,
    /// quit carrom
    Quit,
    /// scroll a text that is longer than its panel
    Scroll(i16),
}

/// The keys that every screen shares.
pub(crate) fn shared_keys() -> KeyTable<SharedAction> {
    use SharedAction::{Back, Charset, Help, Motion, Quit, Theme};
    KeyTable::new("everywhere")
        .each([(Key::Char('?'), Help)], "")
        .or([(Key::F(1), Help)])
        .on(Key::Escape, Back, "")
        .each([(Key::Char('U'), Charset), (Key::F(2), Charset)], "")
        .each([(Key::Char('T'), Theme), (Key::F(3), Theme)], "")
        .each([(Key::Char('M'), Motion), (Key::F(4), Motion)], "")
        .on(Key::Ctrl('c'), Quit, "")
}

/// The keys that scroll the panels of a view.
fn view_keys() -> KeyTable<SharedAction> {
    use SharedAction::Scroll;
    let pages = [-PAGE_ROWS, PAGE_ROWS];
    KeyTable::new("everywhere")
        .by([Key::PageUp, Key::PageDown], Scroll, pages, "")
        .or([(Key::Up, Scroll(-1)), (Key::Down, Scroll(1))])
}

/// The action of a key on a screen: one of the screen's own, or a shared one.
#[derive(Clone, Copy, PartialEq)]
enum Pressed<A> {
    Own(A),
    Shared(SharedAction),
}

/// A screen with any type of actions, for the app's stack.
pub trait AnyScreen {
    /// See [`Screen::title`].
    fn title(&self) -> String;
    /// See [`Screen::route`].
    fn route(&self, cx: &Context) -> Route;
    /// See [`Screen::status`].
    fn status(&self, cx: &Context) -> String;
    /// The keys that currently work, with the player's changes: the screen's own keys, then the
    /// shared ones.
    fn table(&self, cx: &Context) -> KeyTable<()>;
    /// See [`Screen::HELP`].
    fn help(&self) -> &'static str;
    /// See [`Screen::rules`].
    fn rules(&self) -> Option<Rules>;
    /// Handles a key press.
    fn press(&mut self, key: Key, cx: &mut Context) -> Next;
    /// Handles a confirmation that the player has accepted.
    fn confirmed(&mut self, cx: &mut Context) -> Next;
    /// See [`Screen::input`].
    fn input(&mut self, input: &Input, cx: &mut Context) -> Next;
    /// The areas that react to a click, panel by panel.
    fn targets(&self, cx: &Context) -> Vec<Rect>;
    /// Carries out the action of the target with this number, as a click on it would.
    fn choose(&mut self, target: usize, cx: &mut Context) -> Next;
    /// See [`Screen::resumed`].
    fn resumed(&mut self, cx: &mut Context);
    /// See [`Screen::advance`].
    fn advance(&mut self, passed: Duration, cx: &mut Context);
    /// See [`Screen::wake`].
    fn wake(&self, cx: &Context) -> Option<Duration>;
    /// See [`Screen::shares_time`].
    fn shares_time(&self) -> bool;
    /// Draws the screen into [`Context::body`].
    fn draw(&self, buf: &mut Buffer, cx: &Context);
}

/// The smallest number of rows in which the two discs of a collision in an inset look like circles.
const INSET_ROWS: u16 = 5;

/// A screen, the action that awaits confirmation, and the scroll positions of its panels.
pub struct Hosted<S: Screen> {
    pub(super) screen: S,
    asked: Option<S::Action>,
    /// Whether the mouse button has been held down since a click chose something; until the button
    /// is released, the picture ignores the mouse.
    has_chosen: bool,
    scrolled: Vec<Scrolled>,
}

/// How far the player has scrolled a panel, in rows or, if the panel has pages, in pages.
struct Scrolled {
    /// The panel's title and subject.
    of: (String, usize),
    rows: u16,
    /// The row of the item that was chosen when the player scrolled. Once another item is chosen,
    /// the panel scrolls to that item.
    chosen: Option<u16>,
    /// Whether the position is remembered while the panel is not shown.
    stays: bool,
}

impl Scrolled {
    fn is_of<A>(&self, panel: &Panel<A>) -> bool {
        let (title, subject) = &self.of;
        *title == panel.title && *subject == panel.subject
    }
}

impl<S: Screen> Hosted<S> {
    /// A screen without a pending confirmation.
    pub fn new(screen: S) -> Self {
        Self {
            screen,
            asked: None,
            has_chosen: false,
            scrolled: Vec::new(),
        }
    }

    fn keys(&self, cx: &Context) -> KeyTable<Pressed<S::Action>> {
        let own = self.screen.keys(cx).map(Pressed::Own);
        let own = own.with(view_keys(), Pressed::Shared);
        // The same id on every screen, so that the player changes this key on all of them at once.
        own.with(shared_keys(), Pressed::Shared)
            .identified(Key::Escape, "everywhere.back")
            .distinct()
            .rebound(&cx.settings.keys)
    }

    fn act(&mut self, action: S::Action, cx: &mut Context) -> Next {
        let next = self.screen.act(action, cx);
        self.asked = matches!(next, Next::Confirm(_)).then_some(action);
        match next {
            Next::Shared(SharedAction::Scroll(rows)) => match self.scroll(rows, None, cx) {
                Next::Ignored => Next::Stay,
                next => next,
            },
            next => next,
        }
    }

    /// Runs a function on the view, laid out in the body with its panels scrolled.
    fn with_panels<T>(
        &self,
        view: &View<S::Action>,
        cx: &Context,
        take: impl FnOnce(&PlacedView<S::Action>, &Writing<S::Action>) -> T,
    ) -> T {
        let keys = self.keys(cx);
        let key = |action: &S::Action| Some(keys.key_of(&Pressed::Own(*action))?.to_string());
        let look = cx.settings.look();
        let page = |rows| keys.key_of(&Pressed::Shared(SharedAction::Scroll(rows)));
        let pages = page(-PAGE_ROWS).zip(page(PAGE_ROWS));
        let pages = pages.map(|(back, on)| [back.to_string(), on.to_string()]);
        let writing = Writing {
            look,
            pages,
            key: &key,
        };
        // Only a picture can have a size that does not follow from the area.
        let room = match view.first {
            Part::Picture(..) | Part::Nothing => cx.room(),
            Part::Panel(_) => cx.body.into(),
        };
        let mut placed = view.placed(room, &writing);
        for it in &mut placed.panels {
            it.rows = self.scrolled(it.panel, &it.placed);
            if let Some(pages) = it.placed.pages() {
                [placed.layout.picture, it.area] = pages.places(it.rows);
            }
        }
        take(&placed, &writing)
    }

    /// How far a panel is scrolled, in rows or, if the panel has pages, in pages.
    fn scrolled(&self, panel: &Panel<S::Action>, placed: &Placed) -> u16 {
        match self.scrolled.iter().find(|it| it.is_of(panel)) {
            Some(it) if it.chosen == placed.chosen => it.rows.min(placed.overflow()),
            _ if panel.from_top => 0,
            _ => placed.following(),
        }
    }

    /// Scrolls the panel at a cell or, without a cell, the last panel that is longer than its area.
    fn scroll(&mut self, by: i16, cell: Option<(u16, u16)>, cx: &mut Context) -> Next {
        let view = self.screen.view(cx);
        let scrolled = self.with_panels(&view, cx, |view, _| {
            let is_meant = |shown: &&PlacedPanel<S::Action>| match cell {
                Some(cell) => shown.area.contains(cell.into()),
                None => shown.placed.overflow() > 0,
            };
            let mut panels = view.panels.iter().rev();
            let shown = panels.find(is_meant)?;
            let by = match shown.placed.pages() {
                Some(_) => by.signum(),
                None => by,
            };
            let rows = shown.rows.saturating_add_signed(by);
            let rows = rows.min(shown.placed.overflow());
            (rows != shown.rows).then(|| Scrolled {
                of: (shown.panel.title.clone(), shown.panel.subject),
                rows,
                chosen: shown.placed.chosen,
                stays: shown.panel.stays,
            })
        });
        drop(view);
        let Some(scrolled) = scrolled else {
            return self.screen.scrolled_out(by, cx);
        };
        self.scrolled.retain(|it| it.of != scrolled.of);
        self.scrolled.push(scrolled);
        Next::Stay
    }

    /// Forgets the scroll positions of panels that are no longer shown, except those that are to be
    /// remembered.
    fn settle(&mut self, cx: &Context) {
        if self.scrolled.is_empty() {
            return;
        }
        let view = self.screen.view(cx);
        let is_shown = |it: &Scrolled| {
            it.is_of(&view.second) || view.first.panel().is_some_and(|panel| it.is_of(panel))
        };
        self.scrolled.retain(|it| it.stays || is_shown(it));
    }

    /// The rows that the panel beside the picture needs, and the rows available.
    pub(super) fn rows(&self, cx: &Context) -> (u16, u16) {
        let view = self.screen.view(cx);
        self.with_panels(&view, cx, |view, _| {
            let rows = view.layout.panel.height;
            let more = view.panels.last().map_or(0, |it| it.placed.overflow());
            (rows + more, rows)
        })
    }

    /// The areas that react to a click, panel by panel, and their actions.
    fn actions(&self, cx: &Context) -> Vec<(Rect, S::Action)> {
        let view = self.screen.view(cx);
        self.with_panels(&view, cx, |view, _| {
            let of = |shown: &PlacedPanel<S::Action>| -> Vec<_> {
                let targets = shown.placed.targets(shown.rows);
                let action = |(cells, at)| Some((cells, shown.panel.action(at)?));
                targets.filter_map(action).collect()
            };
            view.panels.iter().flat_map(of).collect()
        })
    }

    /// Handles the mouse over the view: a click in a panel carries out the action there.
    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let view = self.screen.view(cx);
        let cell = mouse.cell();
        let has_picture = matches!(view.first, Part::Picture(..));
        let (picture, hit, under) = self.with_panels(&view, cx, |view, _| {
            let mut panels = view.panels.iter();
            let under = panels.find(|it| it.area.contains(cell.into()));
            let hit = under.and_then(|it| {
                let mut targets = it.placed.targets(it.rows);
                let (_, at) = targets.find(|(cells, _)| cells.contains(cell.into()))?;
                it.panel.action(at)
            });
            // Over a list, the wheel moves the mark, and the list scrolls with the mark. The same
            // applies over pages, because a list may be beside them.
            let is_followed = |it: &PlacedPanel<S::Action>| {
                let placed = &it.placed;
                let is_list = placed.is_list || placed.pages().is_some();
                is_list || !has_picture && placed.chosen.is_some()
            };
            let is_long = under.map(|it| it.placed.overflow() > 0 && !is_followed(it));
            (view.layout.picture, hit, is_long)
        });
        drop(view);
        let wheel = mouse.wheel().map(|up| -up);
        let had_chosen = self.has_chosen && matches!(mouse.kind, MouseKind::Drag | MouseKind::Up);
        self.has_chosen = had_chosen && mouse.kind == MouseKind::Drag;
        if let (MouseKind::Down, Some(action)) = (mouse.kind, hit) {
            self.has_chosen = true;
            return self.act(action, cx);
        }
        if had_chosen {
            return Next::Ignored;
        }
        if wheel.is_none() || under.is_none() {
            let next = self.screen.point(mouse, picture, cx);
            if next != Next::Ignored {
                return next;
            }
        }
        let Some(wheel) = wheel else {
            return Next::Ignored;
        };
        match under == Some(true) {
            true => self.scroll(wheel.into(), Some(cell), cx),
            false => match self.screen.wheel(wheel, cx) {
                Next::Shared(SharedAction::Scroll(rows)) => self.scroll(rows, Some(cell), cx),
                next => next,
            },
        }
    }
}

impl<S: Screen> AnyScreen for Hosted<S> {
    fn title(&self) -> String {
        self.screen.title()
    }

    fn route(&self, cx: &Context) -> Route {
        self.screen.route(cx)
    }

    fn status(&self, cx: &Context) -> String {
        self.screen.status(cx)
    }

    fn table(&self, cx: &Context) -> KeyTable<()> {
        self.keys(cx).map(|_| ())
    }

    fn help(&self) -> &'static str {
        S::HELP
    }

    fn rules(&self) -> Option<Rules> {
        self.screen.rules()
    }

    fn press(&mut self, key: Key, cx: &mut Context) -> Next {
        if self.screen.typed(key, cx) {
            return Next::Stay;
        }
        let next = match self.keys(cx).find(key) {
            Some(Pressed::Own(action)) => self.act(action, cx),
            Some(Pressed::Shared(SharedAction::Scroll(rows))) => self.scroll(rows, None, cx),
            Some(Pressed::Shared(action)) => Next::Shared(action),
            None => Next::Ignored,
        };
        self.settle(cx);
        next
    }

    fn confirmed(&mut self, cx: &mut Context) -> Next {
        let asked = self.asked.take();
        asked.map_or(Next::Stay, |action| self.screen.confirmed(action, cx))
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        let next = match input {
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            input => self.screen.input(input, cx),
        };
        self.settle(cx);
        next
    }

    fn targets(&self, cx: &Context) -> Vec<Rect> {
        let actions = self.actions(cx).into_iter();
        actions.map(|(cells, _)| cells).collect()
    }

    fn choose(&mut self, target: usize, cx: &mut Context) -> Next {
        let meant = self.actions(cx).get(target).map(|(_, action)| *action);
        let next = meant.map_or(Next::Ignored, |action| self.act(action, cx));
        self.settle(cx);
        next
    }

    fn resumed(&mut self, cx: &mut Context) {
        self.screen.resumed(cx);
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        self.screen.advance(passed, cx);
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        self.screen.wake(cx)
    }

    fn shares_time(&self) -> bool {
        self.screen.shares_time()
    }

    fn draw(&self, buf: &mut Buffer, cx: &Context) {
        let view = self.screen.view(cx);
        self.with_panels(&view, cx, |placed, writing| {
            // Parts are drawn in reading order.
            let (tabs, panels) = placed.panels.split_at(view.tabs.is_some().into());
            for shown in tabs {
                shown.placed.draw(0, buf, writing);
            }
            let look = &writing.look;
            if let Some(heading) = &view.heading {
                heading.draw(placed.area, buf, look, placed.small_heading);
            }
            if let Some(words) = &view.corner {
                draw_corner(words, placed.area, buf, look);
            }
            let [first, second] = view.titles();
            placed.layout.draw(buf, look, &first, &second);
            if let Part::Picture(_, draw) = &view.first
                && !placed.layout.picture.is_empty()
            {
                sheet::next_picture_drags(view.drag);
                draw(placed.layout.picture, buf, look);
            }
            for shown in panels {
                shown.placed.draw(shown.rows, buf, writing);
            }
            if let (Some((title, draw)), Some(shown)) = (&view.inset, panels.last())
                && cx.room().pictures.is_none()
            {
                let area = shown.area.inner(Margin::new(1, 0));
                let [_, below] = areas::upper(area, shown.placed.rows() + 1);
                let [head, below] = areas::upper(below, 1);
                if below.height >= INSET_ROWS && below.width >= 2 * INSET_ROWS {
                    Lines::new(head, buf, *look).line(title, Role::Dim);
                    draw(below, buf, look);
                }
            }
        });
    }
}

/// Draws a short text in the upper right corner of an area, over its contents.
fn draw_corner(words: &str, area: Rect, buf: &mut Buffer, look: &Look) {
    sheet::note(area, || Item::new(Words::large(words, Role::Selected)));
    let words = format!(" {words} ");
    let width = text::width(&words);
    let column = area.right().saturating_sub(width as u16);
    let style = look.theme.style(Role::Selected);
    buf.set_stringn(column, area.y, &words, width, style);
}

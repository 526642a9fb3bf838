//! The view of a screen: a picture or a panel, alone or with a panel beside it.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::widgets::panel::{Beside, Panel, Placed, PlacedPages, Writing};
use crate::widgets::panels::Heading;
use crate::widgets::picture::Picture;
use crate::widgets::{Look, Room, SplitLayout, areas};

/// What a screen shows.
pub struct View<'s, A> {
    /// The names of the screen's pages, in one row above both parts.
    pub(super) tabs: Option<Panel<A>>,
    /// The heading, in large letters above both parts.
    pub(super) heading: Option<Heading>,
    /// A short text in the upper right corner.
    pub(super) corner: Option<String>,
    /// The layout of both parts, between the tabs and heading above and the foot below.
    pub(super) layout: Layout<'s>,
    /// The larger part.
    pub(super) first: Part<'s, A>,
    /// The panel beside it.
    pub(super) second: Panel<A>,
    /// A small picture, made of cells, below the second part if that part leaves enough cells.
    pub(super) inset: Option<(&'static str, DrawPicture<'s>)>,
    /// A panel that is always visible below both parts, as high as its text.
    pub(super) foot: Option<Panel<A>>,
    /// Whether keys go to the larger part first; `None` if only one part takes keys.
    pub(super) focus: Option<bool>,
    /// A sentence about what can be dragged in the picture, with a finger or the mouse.
    pub(super) drag: Option<&'static str>,
}

/// The layout of the two parts of a view.
pub(super) enum Layout<'s> {
    /// The layout that this function returns.
    At(Box<dyn Fn(Room) -> SplitLayout + 's>),
    /// The text in letters that the back row can read, and the picture in the remaining room.
    ForTheBackRow(Beside),
}

/// The larger part of a view.
pub(super) enum Part<'s, A> {
    /// A picture in a frame with a title.
    Picture(String, DrawPicture<'s>),
    /// Text.
    Panel(Panel<A>),
    /// Nothing: the other part fills the view.
    Nothing,
}

impl<A> Part<'_, A> {
    pub(super) fn panel(&self) -> Option<&Panel<A>> {
        match self {
            Self::Panel(panel) => Some(panel),
            Self::Picture(..) | Self::Nothing => None,
        }
    }
}

/// A function that draws a picture into its area.
type DrawPicture<'s> = Box<dyn Fn(Rect, &mut Buffer, &Look) + 's>;

impl<'s, A: Copy> View<'s, A> {
    /// A picture under a title, and a panel beside it.
    pub(super) fn picture(
        title: impl Into<String>,
        draw: impl Fn(Rect, &mut Buffer, &Look) + 's,
        second: Panel<A>,
    ) -> Self {
        let first = Part::Picture(title.into(), Box::new(draw));
        Self::new(SplitLayout::new, first, second)
    }

    /// Like [`Self::picture`], with a picture that depends only on its area.
    pub(super) fn drawn(
        title: impl Into<String>,
        picture: impl Fn(Rect) -> Picture + 's,
        second: Panel<A>,
    ) -> Self {
        let draw = move |area, buf: &mut _, look: &_| picture(area).draw(buf, look);
        Self::picture(title, draw, second)
    }

    /// This view with another layout.
    pub(super) fn laid_out(self, layout: impl Fn(Room) -> SplitLayout + 's) -> Self {
        let layout = Layout::At(Box::new(layout));
        Self { layout, ..self }
    }

    /// This view with a picture just wide enough for a square board.
    pub(super) fn square(self) -> Self {
        self.laid_out(SplitLayout::square)
    }

    /// A picture alone, which fills the view.
    pub fn picture_alone(draw: impl Fn(Rect, &mut Buffer, &Look) + 's) -> Self {
        Self::picture("", draw, Panel::new(""))
            .laid_out(|room| SplitLayout::open(room.area, Rect::default()))
    }

    /// A panel, with another beside it for details.
    pub(super) fn panels(first: Panel<A>, second: Panel<A>) -> Self {
        Self::new(SplitLayout::new, Part::Panel(first), second)
    }

    /// A panel alone.
    pub(super) fn alone(layout: impl Fn(Room) -> SplitLayout + 's, panel: Panel<A>) -> Self {
        Self::new(layout, Part::Nothing, panel)
    }

    /// A panel of running text alone.
    pub(super) fn text(panel: Panel<A>) -> Self {
        Self::alone(|room| SplitLayout::text_of(room, WIDEST), panel)
    }

    fn new(
        layout: impl Fn(Room) -> SplitLayout + 's,
        first: Part<'s, A>,
        second: Panel<A>,
    ) -> Self {
        Self {
            tabs: None,
            heading: None,
            corner: None,
            layout: Layout::At(Box::new(layout)),
            first,
            second,
            inset: None,
            foot: None,
            focus: None,
            drag: None,
        }
    }

    /// This view with a small picture, which has a title, below the panel if the panel leaves
    /// enough cells. A browser, whose pictures are not made of cells, does not need the small
    /// picture.
    pub(super) fn with_inset(
        self,
        title: &'static str,
        picture: Option<impl Fn(Rect) -> Picture + 's>,
    ) -> Self {
        let inset = picture.map(|picture| {
            let draw: DrawPicture = Box::new(move |area, buf, look| picture(area).draw(buf, look));
            (title, draw)
        });
        Self { inset, ..self }
    }

    /// This view with a panel that is always visible below both parts.
    pub(super) fn with_foot(self, foot: Panel<A>) -> Self {
        let foot = Some(foot);
        Self { foot, ..self }
    }

    /// This view with a picture in which something can be dragged.
    pub(super) fn dragging(self, drag: impl Into<Option<&'static str>>) -> Self {
        let drag = drag.into();
        Self { drag, ..self }
    }

    /// The titles of both parts, with a mark before the one that receives keys.
    pub(super) fn titles(&self) -> [String; 2] {
        let first = match &self.first {
            Part::Picture(title, _) => title,
            Part::Panel(panel) => &panel.title,
            Part::Nothing => "",
        };
        let marked = |title: &str, first: bool| match self.focus == Some(first) {
            true => format!("> {title}"),
            false => title.to_owned(),
        };
        [marked(first, true), marked(&self.second.title, false)]
    }

    /// Lays the view out in `room`.
    pub(super) fn placed(&self, room: Room, writing: &Writing<A>) -> PlacedView<'_, A> {
        let under = |small: bool| self.placed_under(small, room, writing);
        let large = under(false);
        // A small heading leaves more rows for the pages. The large heading is used only if the
        // pages look just as good with it.
        if !matches!(self.layout, Layout::ForTheBackRow(_)) || self.heading.is_none() {
            return large;
        }
        let small = under(true);
        let both = large.pages().zip(small.pages());
        match both.is_some_and(|(large, small)| large.are_as_good_as(small)) {
            true => large,
            false => small,
        }
    }

    /// Lays the view out in `room`, with a `small` or a large heading.
    fn placed_under(&self, small: bool, room: Room, writing: &Writing<A>) -> PlacedView<'_, A> {
        let look = &writing.look;
        let [above, area] = areas::upper(room.area, self.tabs.is_some().into());
        let heading = self.heading.as_ref();
        let rest = heading.map_or(area, |it| it.rest(area, look, small));
        let foot = { self.foot.as_ref() }.map(|foot| (foot, foot.placed(rest, writing)));
        let foot_rows = foot.as_ref().map_or(0, |(_, it)| it.rows());
        let [middle, below] = areas::upper(rest, rest.height.saturating_sub(foot_rows));
        let middle = Room {
            area: middle,
            ..room
        };
        let (layout, second) = match &self.layout {
            Layout::At(layout) => {
                let layout = layout(middle);
                (layout, self.second.placed(layout.panel, writing))
            }
            Layout::ForTheBackRow(beside) => {
                let rows = room.area.height;
                let paged = self.second.paged(*beside, middle, rows, writing);
                let second = paged.unwrap_or_else(|| {
                    let column = areas::middle(middle.area, WIDEST);
                    self.second.placed(column, writing)
                });
                let [picture, words] = match (second.pages(), beside) {
                    (Some(pages), _) => pages.places(0),
                    (None, Beside::Nothing) => [Rect::default(), middle.area],
                    (None, _) => {
                        let [words, picture] = areas::upper(middle.area, second.rows());
                        [picture, words]
                    }
                };
                (SplitLayout::open(picture, words), second)
            }
        };
        let at = |panel, placed, area| PlacedPanel {
            panel,
            placed,
            area,
            rows: 0,
        };
        let tabs = { self.tabs.as_ref() }.map(|it| at(it, it.placed(above, writing), above));
        let first = self.first.panel().map(|it| {
            let place = layout.picture;
            at(it, it.placed(place, writing), place)
        });
        let second = at(&self.second, second, layout.panel);
        let foot = foot.map(|(foot, placed)| at(foot, placed.moved(below), below));
        let panels = tabs.into_iter().chain(first).chain([second]).chain(foot);
        PlacedView {
            area,
            small_heading: small,
            layout,
            panels: panels.collect(),
        }
    }
}

/// The largest number of columns for running text.
pub(super) const WIDEST: u16 = 100;

/// A view after layout.
pub(super) struct PlacedView<'v, A> {
    /// The area below the tabs.
    pub(super) area: Rect,
    pub(super) small_heading: bool,
    pub(super) layout: SplitLayout,
    pub(super) panels: Vec<PlacedPanel<'v, A>>,
}

/// A panel of a view after layout.
pub(super) struct PlacedPanel<'v, A> {
    pub(super) panel: &'v Panel<A>,
    pub(super) placed: Placed<'v>,
    pub(super) area: Rect,
    /// How far the panel is scrolled, in rows.
    pub(super) rows: u16,
}

impl<A> PlacedView<'_, A> {
    pub(super) fn pages(&self) -> Option<&PlacedPages<'_>> {
        self.panels.iter().find_map(|it| it.placed.pages())
    }
}

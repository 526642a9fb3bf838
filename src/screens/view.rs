//! What a screen shows: a picture or a panel, and a panel beside it, or one panel alone.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::widgets::panel::Panel;
use crate::widgets::picture::Picture;
use crate::widgets::{Look, Room, SplitLayout, areas};

/// What a screen shows.
pub struct View<'s, A> {
    /// One row above both parts: the names of the screen's pages.
    pub(super) tabs: Option<Panel<A>>,
    /// Where both parts stand in the area of the screen, or below the tabs.
    pub(super) layout: fn(Room) -> SplitLayout,
    /// The part that has most of the room.
    pub(super) first: Part<'s, A>,
    /// What stands beside it.
    pub(super) second: Panel<A>,
    /// Whether keys go to the larger part first, where they may go to either.
    pub(super) focus: Option<bool>,
    /// What can be dragged in the picture, in a sentence for fingers and the mouse.
    pub(super) drag: Option<&'static str>,
}

/// The larger part of a view.
pub(super) enum Part<'s, A> {
    /// A picture in a frame with a title.
    Picture(String, DrawPicture<'s>),
    /// Text.
    Panel(Panel<A>),
    /// Nothing: the other part has all the room.
    Nothing,
}

/// What draws a picture into its place.
type DrawPicture<'s> = Box<dyn Fn(Rect, &mut Buffer, &Look) + 's>;

impl<'s, A> View<'s, A> {
    /// A picture under a title, and a panel beside it.
    pub(super) fn picture(
        title: impl Into<String>,
        draw: impl Fn(Rect, &mut Buffer, &Look) + 's,
        second: Panel<A>,
    ) -> Self {
        let first = Part::Picture(title.into(), Box::new(draw));
        Self::new(SplitLayout::new, first, second)
    }

    /// The same with a picture that follows from its place alone.
    pub(super) fn drawn(
        title: impl Into<String>,
        picture: impl Fn(Rect) -> Picture + 's,
        second: Panel<A>,
    ) -> Self {
        let draw = move |area, buf: &mut _, look: &_| picture(area).draw(buf, look);
        Self::picture(title, draw, second)
    }

    /// The same with a picture just as wide as a square board needs.
    pub(super) fn square(self) -> Self {
        Self {
            layout: SplitLayout::square,
            ..self
        }
    }

    /// A panel, and one beside it that tells more.
    pub(super) fn panels(first: Panel<A>, second: Panel<A>) -> Self {
        Self::new(SplitLayout::new, Part::Panel(first), second)
    }

    /// A panel alone, in the middle.
    pub(super) fn alone(layout: fn(Room) -> SplitLayout, panel: Panel<A>) -> Self {
        Self::new(layout, Part::Nothing, panel)
    }

    fn new(layout: fn(Room) -> SplitLayout, first: Part<'s, A>, second: Panel<A>) -> Self {
        Self {
            tabs: None,
            layout,
            first,
            second,
            focus: None,
            drag: None,
        }
    }

    /// The same with a picture in which something can be dragged.
    pub(super) fn dragging(self, drag: impl Into<Option<&'static str>>) -> Self {
        Self {
            drag: drag.into(),
            ..self
        }
    }

    /// The titles of both parts, with a mark before the one that keys go to.
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

    /// Where both parts stand in a room, and all its panels, each with the place it has.
    pub(super) fn places(&self, room: Room) -> (SplitLayout, Vec<(&Panel<A>, Rect)>) {
        let [above, area] = areas::upper(room.area, self.tabs.is_some().into());
        let layout = (self.layout)(Room { area, ..room });
        let tabs = self.tabs.as_ref().map(|tabs| (tabs, above));
        let first = match &self.first {
            Part::Panel(panel) => Some((panel, layout.picture)),
            Part::Picture(..) | Part::Nothing => None,
        };
        let panels = tabs.into_iter().chain(first);
        let panels = panels.chain([(&self.second, layout.panel)]).collect();
        (layout, panels)
    }
}

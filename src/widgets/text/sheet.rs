//! A record of the text of a screen, for shells that can show more than cells.
//!
//! A screen writes its text into cells, so the meaning of the text is lost: whether it is a
//! heading, a value, or one of several choices. A browser has an element for each of these, so its
//! shell records the text during a call that draws the screen, just as the shell collects the
//! pictures. Only the caller of [`recorded`] receives the record.

use std::cell::RefCell;

use ratatui::layout::Rect;
use serde::Serialize;

use super::flow::Run;
use crate::widgets::Role;

thread_local! {
    static RECORDED: RefCell<Option<Recorder>> = const { RefCell::new(None) };
}

/// The text of a screen, or of a layer over it, as a list.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sheet {
    /// The kind of the sheet.
    pub kind: SheetKind,
    /// The title of the screen or layer.
    pub title: String,
    /// The text beside the title, which summarizes the state of the screen.
    pub status: String,
    /// The sections, in reading order.
    pub sections: Vec<Section>,
}

/// The kind of a sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SheetKind {
    /// The screen itself.
    Screen,
    /// A page that explains the screen.
    Help,
    /// A message for the player.
    Notice,
    /// A question for the player.
    Question,
}

/// The contents of a frame, or of a part of the screen that has no frame.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Section {
    /// The title of the frame; empty for none.
    pub title: String,
    /// The items, from top to bottom.
    pub items: Vec<Item>,
    /// For each item, whether it is in the right half of the section, and the top row of its area.
    #[serde(skip)]
    places: Vec<(bool, u16)>,
    #[serde(skip)]
    area: Rect,
    #[serde(skip)]
    is_framed: bool,
}

/// One item of a section.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Item {
    /// The kind of the item, and its text.
    #[serde(flatten)]
    pub words: Words,
    /// The cell, as column and row, where a click triggers the item's action.
    pub press: Option<[u16; 2]>,
    /// Whether the item is selected; `None` if it cannot be selected.
    pub chosen: Option<bool>,
}

/// The kind of an item, and its text.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "is", rename_all = "kebab-case")]
pub enum Words {
    /// A gap between two items.
    Gap,
    /// One of the pictures on the screen.
    Picture {
        /// The index of the picture among all the pictures drawn, from 0.
        number: usize,
        /// A description of the picture in sentences; empty if the text beside the picture gives
        /// the same information.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        shows: Vec<String>,
        /// A sentence that says what can be dragged in the picture.
        #[serde(skip_serializing_if = "Option::is_none")]
        drag: Option<&'static str>,
    },
    /// Text, which may have a mark before it.
    Text {
        /// The mark, such as "1." or "-"; empty for none.
        mark: String,
        /// The text in several styles.
        runs: Vec<Run>,
    },
    /// An equation on a separate row.
    Equation {
        /// The text of the equation.
        runs: Vec<Run>,
    },
    /// The name of a quantity, and its value.
    Pair {
        /// The name of the quantity.
        name: Run,
        /// The value of the quantity.
        value: Run,
    },
    /// A row of a table.
    Columns {
        /// The name of the row.
        name: Run,
        /// A value for each column.
        values: Vec<Run>,
    },
    /// A setting.
    Field {
        /// The name of the setting.
        name: String,
        /// The value as text; a number that is being typed ends in `_`.
        value: String,
        /// Whether the setting cannot be changed at present.
        locked: bool,
    },
    /// A text field.
    TextField {
        /// The name of the text field.
        name: String,
        /// The typed text.
        value: String,
    },
    /// A possible next action.
    Prompt {
        /// A description of the action.
        words: String,
        /// The name of the key for the action.
        key: Option<String>,
    },
    /// The tab of one of several pages.
    Tab {
        /// The name of the page.
        name: String,
    },
    /// A fraction of a whole.
    Meter {
        /// The name, written before the bar.
        name: String,
        /// The fraction, from 0 to 1.
        share: f64,
        /// The fraction as text, written after the bar.
        value: String,
        /// The role, which determines the colour of the bar.
        role: Role,
    },
    /// Something to share.
    Code(Share),
    /// Large text for the back row.
    Large {
        /// The text in several styles.
        runs: Vec<Run>,
    },
}

/// Something to share.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Share {
    /// A description of what is shared.
    pub text: String,
    /// The command that opens it.
    pub command: String,
    /// The part of the link's address after `#`.
    pub address: String,
    /// Whether the page copies the description together with the link.
    pub is_result: bool,
}

#[derive(Default)]
struct Recorder {
    sheets: Vec<Sheet>,
    pictures: usize,
    /// A description of the next picture, in sentences.
    shows: Vec<String>,
    drag: Option<&'static str>,
}

impl Recorder {
    fn sheet(&mut self) -> &mut Sheet {
        if self.sheets.is_empty() {
            self.sheets.push(Sheet::new(SheetKind::Screen, "", ""));
        }
        let last = self.sheets.len() - 1;
        &mut self.sheets[last]
    }

    fn note(&mut self, area: Rect, item: Item) {
        // Pictures may be drawn after the text around them, so items are sorted by their positions.
        let section = self.sheet().section(area);
        let is_right = 2 * area.x.saturating_sub(section.area.x) >= section.area.width.max(1);
        let place = (is_right, area.y);
        let at = section.places.partition_point(|it| *it <= place);
        section.places.insert(at, place);
        section.items.insert(at, item);
    }
}

impl Sheet {
    fn new(kind: SheetKind, title: &str, status: &str) -> Self {
        Self {
            kind,
            title: title.to_owned(),
            status: status.to_owned(),
            sections: Vec::new(),
        }
    }

    /// The section for an area: that of the smallest frame around the area, otherwise the unframed
    /// section of exactly this area, which may be new.
    fn section(&mut self, area: Rect) -> &mut Section {
        let round = |frame: &Section| frame.is_framed && frame.area.union(area) == frame.area;
        let sections = self.sections.iter().enumerate();
        let framed = sections.filter(|(_, it)| round(it));
        let framed = framed.min_by_key(|(_, it)| it.area.area());
        let own = |it: &Section| !it.is_framed && it.area == area;
        let at = framed.map(|(at, _)| at);
        let at = at.or_else(|| self.sections.iter().position(own));
        let at = at.unwrap_or_else(|| {
            self.sections.push(Section::new("", area, false));
            self.sections.len() - 1
        });
        &mut self.sections[at]
    }
}

impl Section {
    fn new(title: &str, area: Rect, is_framed: bool) -> Self {
        Self {
            title: title.to_owned(),
            items: Vec::new(),
            places: Vec::new(),
            area,
            is_framed,
        }
    }
}

impl Words {
    /// Text in one style.
    pub(crate) fn text(run: Run) -> Self {
        Self::Text {
            mark: String::new(),
            runs: vec![run],
        }
    }

    /// Large text for the back row.
    pub(crate) fn large(words: &str, role: Role) -> Self {
        Self::Large {
            runs: vec![Run::new(words, role)],
        }
    }

    /// A fraction of a whole, with its name and its text.
    pub(crate) fn meter(name: &str, share: f64, value: &str, role: Role) -> Self {
        Self::Meter {
            name: name.to_owned(),
            share,
            value: value.to_owned(),
            role,
        }
    }
}

impl Item {
    /// An item without an action.
    pub(crate) const fn new(words: Words) -> Self {
        Self {
            words,
            press: None,
            chosen: None,
        }
    }
}

/// Runs the drawing function and returns its result together with the recorded text: first the text
/// of the screen, then that of the layers over the screen.
pub fn recorded<T>(draw: impl FnOnce() -> T) -> (T, Vec<Sheet>) {
    RECORDED.set(Some(Recorder::default()));
    let drawn = draw();
    let sheets = RECORDED.take().unwrap_or_default().sheets;
    (drawn, sheets.into_iter().map(tidied).collect())
}

/// The sheet without empty sections, without repeated gaps, and without gaps at the start and end
/// of each section.
fn tidied(mut sheet: Sheet) -> Sheet {
    for section in &mut sheet.sections {
        let is_gap = |item: &Item| matches!(item.words, Words::Gap);
        section.items.dedup_by(|b, a| is_gap(a) && is_gap(b));
        if section.items.last().is_some_and(is_gap) {
            section.items.pop();
        }
        if section.items.first().is_some_and(is_gap) {
            section.items.remove(0);
        }
    }
    sheet.sections.retain(|section| !section.items.is_empty());
    sheet
}

pub(crate) fn is_recording() -> bool {
    RECORDED.with_borrow(Option::is_some)
}

fn with(note: impl FnOnce(&mut Recorder)) {
    RECORDED.with_borrow_mut(|recorder| recorder.as_mut().map_or((), note));
}

/// Records the start of a screen, or of a layer over the screen.
pub(crate) fn begin(kind: SheetKind, title: &str, status: &str) {
    with(|recorder| recorder.sheets.push(Sheet::new(kind, title, status)));
}

/// Records a frame: items drawn inside it from now on belong to it.
pub(crate) fn frame(area: Rect, title: &str) {
    if area.is_empty() {
        return;
    }
    with(|recorder| {
        let frame = Section::new(title, area, true);
        recorder.sheet().sections.push(frame);
    });
}

/// Records a picture that has just been drawn.
pub(crate) fn picture(area: Rect) {
    with(|recorder| {
        let number = recorder.pictures;
        recorder.pictures += 1;
        let shows = std::mem::take(&mut recorder.shows);
        let drag = recorder.drag.take();
        let words = Words::Picture {
            number,
            shows,
            drag,
        };
        recorder.note(area, Item::new(words));
    });
}

/// Describes the next picture in sentences, for users who cannot see the picture. `say` is called
/// only while a shell is recording.
pub(crate) fn next_picture_shows(say: impl FnOnce() -> Vec<String>) {
    if is_recording() {
        let shows = say();
        with(|recorder| recorder.shows = shows);
    }
}

/// Says what can be dragged in the next picture.
pub(crate) fn next_picture_drags(drag: Option<&'static str>) {
    with(|recorder| recorder.drag = drag);
}

/// Records something that has been written into an area. `make` is called only while a shell is
/// recording.
pub(crate) fn note(area: Rect, make: impl FnOnce() -> Item) {
    if is_recording() {
        let item = make();
        with(|recorder| recorder.note(area, item));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_in_a_frame_belong_to_it_wherever_their_areas_begin() {
        let text = |words: &str| Item::new(Words::text(Run::new(words, Role::Text)));
        let ((), sheets) = recorded(|| {
            begin(SheetKind::Screen, "lab", "");
            frame(Rect::new(0, 0, 10, 10), "picture");
            frame(Rect::new(10, 0, 10, 10), "panel");
            frame(Rect::new(0, 0, 0, 10), "no room");
            note(Rect::new(12, 1, 7, 8), || text("beside"));
            picture(Rect::new(1, 1, 8, 8));
            note(Rect::new(0, 12, 20, 1), || text("below"));
            note(Rect::new(1, 1, 8, 1), || text("above it"));
            picture(Rect::new(1, 5, 8, 3));
            note(Rect::new(1, 2, 8, 1), || text("between"));
        });
        let titles: Vec<_> = sheets[0].sections.iter().map(|it| &it.title).collect();
        assert_eq!(titles, ["picture", "panel", ""]);
        assert_eq!(sheets[0].sections[1].items, [text("beside")]);
        let numbered = |number| {
            let shows = Vec::new();
            Item::new(Words::Picture {
                number,
                shows,
                drag: None,
            })
        };
        assert_eq!(
            sheets[0].sections[0].items,
            [numbered(0), text("above it"), text("between"), numbered(1)]
        );
        let ((), none) = recorded(|| ());
        assert!(none.is_empty());
    }
}

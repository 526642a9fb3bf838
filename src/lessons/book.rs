//! The chapters that are available to this player, and their bookmarks.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Bookmark, Chapter, ChapterLibrary};
use crate::quiz::Passage;

/// What to delete from the bookmarks. The record of answers is always kept.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Forget {
    /// The answer given on a page.
    Answer {
        /// The id of the chapter.
        chapter: String,
        /// The title of the page.
        page: String,
    },
    /// The whole bookmark of the chapter with this id.
    Chapter(String),
    /// The bookmarks of all chapters.
    All,
}

/// All chapters, with the player's bookmark in each of them.
#[derive(Debug, Clone, Default)]
pub struct Book {
    /// `None` if there are only the built-in chapters, which are read when they are first needed.
    library: Option<Arc<ChapterLibrary>>,
    /// The line of the table of contents that was selected last.
    pub at: usize,
    /// The bookmarks, indexed by the id of the chapter; `None` until the stored bookmarks are
    /// known.
    marks: Option<BTreeMap<String, Bookmark>>,
}

impl Book {
    /// Creates a book with the chapters of this library.
    pub fn new(library: ChapterLibrary) -> Self {
        Self {
            library: Some(Arc::new(library)),
            ..Self::default()
        }
    }

    /// The chapters, and the errors in the files that were left out.
    pub fn library(&self) -> &ChapterLibrary {
        let own = self.library.as_deref();
        own.unwrap_or_else(|| ChapterLibrary::embedded_once())
    }

    /// The chapter with this index; `None` if there is no such chapter.
    pub fn chapter(&self, number: usize) -> Option<&Chapter> {
        self.library().chapters.get(number)
    }

    /// The position of a page: the index of the chapter, and the index of the page in the chapter,
    /// both counted from 0; `None` if there is no such page.
    pub fn find(&self, passage: Passage) -> Option<(usize, usize)> {
        let chapters = &self.library().chapters;
        let of_it = |chapter: &Chapter| chapter.id == passage.chapter;
        let number = chapters.iter().position(of_it)?;
        let mut pages = chapters[number].pages.iter();
        let page = pages.position(|page| page.title == passage.page)?;
        Some((number, page))
    }

    /// The description of a page: "chapter 3, page 7: When energy is lost".
    pub fn named(&self, passage: Passage) -> Option<String> {
        let (number, page) = self.find(passage)?;
        let chapter = self.chapter(number)?.number;
        let Passage { page: title, .. } = passage;
        Some(format!("chapter {chapter}, page {}: {title}", page + 1))
    }

    /// Whether the bookmarks are known.
    pub(crate) fn is_known(&self) -> bool {
        self.marks.is_some()
    }

    /// Sets the bookmarks that were stored, unless they are known already; the book itself keeps
    /// them up to date.
    pub(crate) fn recall(&mut self, marks: BTreeMap<String, Bookmark>) {
        self.marks.get_or_insert(marks);
    }

    /// Drops all bookmarks, because those of another player will be requested.
    pub(crate) fn close(&mut self) {
        self.marks = None;
    }

    /// The bookmark in a chapter; `None` if there is none or the bookmarks are not known yet.
    pub fn mark(&self, id: &str) -> Option<&Bookmark> {
        self.marks.as_ref()?.get(id)
    }

    /// The index of the page where the player left a chapter.
    pub(crate) fn left_at(&self, chapter: &Chapter) -> usize {
        self.mark(&chapter.id).map_or(0, |mark| mark.page(chapter))
    }

    /// Adds what the player has done in a chapter to the bookmark in that chapter.
    pub fn merge(&mut self, id: &str, later: Bookmark) {
        let marks = self.marks.get_or_insert_default();
        marks.entry(id.to_owned()).or_default().merge(later);
    }

    /// Deletes these parts of the bookmarks.
    pub(crate) fn forget(&mut self, what: &Forget) {
        let Some(marks) = &mut self.marks else {
            return;
        };
        match what {
            Forget::Answer { chapter, page } => {
                if let Some(mark) = marks.get_mut(chapter) {
                    mark.pages.insert(page.clone(), None);
                }
            }
            Forget::Chapter(chapter) => {
                marks.remove(chapter);
            }
            Forget::All => marks.clear(),
        }
    }

    /// Of the chapters that have been opened but are not done, the last one in the book, and the
    /// page at which the player continues. This is the page where the player left the chapter or,
    /// once all pages have been read, the first page with an unanswered question.
    pub(crate) fn begun(&self) -> Option<(usize, usize)> {
        let chapters = self.library().chapters.iter().enumerate();
        let begun = chapters.rev().find_map(|(at, chapter)| {
            let mark = self.mark(&chapter.id)?;
            let is_begun = mark.place.is_some() && !mark.is_done(chapter);
            is_begun.then_some((at, chapter, mark))
        });
        let (at, chapter, mark) = begun?;
        let unanswered = { chapter.pages.iter() }
            .position(|page| page.checkpoint.is_some() && mark.given(page).is_none());
        match mark.seen(chapter) < chapter.pages.len() {
            true => Some((at, mark.page(chapter))),
            false => Some((at, unanswered?)),
        }
    }

    /// Whether anything has been read.
    pub fn is_begun(&self) -> bool {
        self.marks.as_ref().is_some_and(|marks| !marks.is_empty())
    }

    /// Whether a chapter has been completely read and answered.
    pub fn is_done(&self, chapter: &Chapter) -> bool {
        let mark = self.mark(&chapter.id);
        mark.is_some_and(|mark| mark.is_done(chapter))
    }

    /// The number of completed chapters and the total number: "2 of 12".
    pub fn done(&self) -> String {
        let chapters = &self.library().chapters;
        let done = chapters.iter().filter(|chapter| self.is_done(chapter));
        format!("{} of {}", done.count(), chapters.len())
    }

    /// The chapters in which every page has been seen.
    pub fn read_through(&self) -> impl Iterator<Item = &Chapter> {
        let seen = |chapter: &&Chapter| {
            let mark = self.mark(&chapter.id);
            mark.is_some_and(|mark| mark.seen(chapter) == chapter.pages.len())
        };
        self.library().chapters.iter().filter(seen)
    }

    /// The first chapter that is not done; `None` if all chapters are done.
    pub fn next(&self) -> Option<usize> {
        let chapters = &self.library().chapters;
        chapters.iter().position(|chapter| !self.is_done(chapter))
    }
}

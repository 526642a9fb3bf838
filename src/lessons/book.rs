//! The chapters there are for this player, and how far they have been read.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Bookmark, Chapter, ChapterLibrary};

/// What is to be forgotten of bookmarks. The record of answers stays in any case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Forget {
    /// The answer given on a page.
    Answer {
        /// The id of the chapter.
        chapter: String,
        /// The title of the page.
        page: String,
    },
    /// All of the chapter of this id.
    Chapter(String),
    /// All of all chapters.
    All,
}

/// All chapters, with a bookmark in each.
#[derive(Debug, Clone, Default)]
pub struct Book {
    /// `None` where there are those of the program alone, which are read only when
    /// they are looked at.
    library: Option<Arc<ChapterLibrary>>,
    /// The line of the contents that was looked at last.
    pub at: usize,
    /// By the ids of the chapters; `None` until it is known what was kept.
    marks: Option<BTreeMap<String, Bookmark>>,
}

impl Book {
    /// A book of other chapters than those of the program alone.
    pub fn new(library: ChapterLibrary) -> Self {
        Self {
            library: Some(Arc::new(library)),
            ..Self::default()
        }
    }

    /// The chapters, and what was wrong with files that are left out.
    pub fn library(&self) -> &ChapterLibrary {
        let own = self.library.as_deref();
        own.unwrap_or_else(|| ChapterLibrary::embedded_once())
    }

    /// A chapter; `None` beyond the last.
    pub fn chapter(&self, number: usize) -> Option<&Chapter> {
        self.library().chapters.get(number)
    }

    /// Whether it is known how far the chapters have been read.
    pub fn is_known(&self) -> bool {
        self.marks.is_some()
    }

    /// Takes the bookmarks that were kept; from then on the book knows them itself.
    pub(crate) fn recall(&mut self, marks: BTreeMap<String, Bookmark>) {
        self.marks.get_or_insert(marks);
    }

    /// The bookmark in a chapter, if it was ever opened.
    pub fn mark(&self, id: &str) -> Option<&Bookmark> {
        self.marks.as_ref()?.get(id)
    }

    /// Adds to the bookmark in a chapter what was done there.
    pub(crate) fn merge(&mut self, id: &str, later: Bookmark) {
        let marks = self.marks.get_or_insert_default();
        marks.entry(id.to_owned()).or_default().merge(later);
    }

    /// Forgets what is to be forgotten.
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

    /// Whether anything has been read.
    pub fn is_begun(&self) -> bool {
        self.marks.as_ref().is_some_and(|marks| !marks.is_empty())
    }

    /// Whether all of a chapter has been read and answered.
    pub fn is_done(&self, chapter: &Chapter) -> bool {
        let mark = self.mark(&chapter.id);
        mark.is_some_and(|mark| mark.is_done(chapter))
    }

    /// How many chapters are done, and how many there are, in words: "2 of 12".
    pub fn done(&self) -> String {
        let chapters = &self.library().chapters;
        let done = chapters.iter().filter(|chapter| self.is_done(chapter));
        format!("{} of {}", done.count(), chapters.len())
    }

    /// The first chapter that is not done; `None` if all are.
    pub fn next(&self) -> Option<usize> {
        let chapters = &self.library().chapters;
        chapters.iter().position(|chapter| !self.is_done(chapter))
    }
}

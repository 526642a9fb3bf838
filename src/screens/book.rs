//! The chapters there are for this player, and how far they have been read.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::learn::Answer;
use crate::lessons::{Chapter, Library};

/// All chapters, with a bookmark in each.
#[derive(Debug, Clone, Default)]
pub struct Book {
    /// `None` where there are those of the program alone, which are read only when
    /// they are looked at.
    library: Option<Arc<Library>>,
    /// The line of the contents that was looked at last.
    pub at: usize,
    marks: BTreeMap<String, Bookmark>,
}

/// How far a chapter has been read.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Bookmark {
    /// The page it is open at, from 0.
    pub page: usize,
    /// The impact angle that the student set last in its figures, in degrees.
    pub alpha_deg: Option<f64>,
    seen: BTreeSet<usize>,
    answers: BTreeMap<usize, (Answer, bool)>,
}

impl Bookmark {
    /// Opens a page.
    pub fn open(&mut self, page: usize) {
        self.page = page;
        self.seen.insert(page);
    }

    /// Notes an answer and whether it was right.
    pub fn answer(&mut self, page: usize, answer: Answer, right: bool) {
        self.answers.insert(page, (answer, right));
    }

    /// The answer given on a page.
    pub fn answer_on(&self, page: usize) -> Option<&Answer> {
        self.answers.get(&page).map(|(answer, _)| answer)
    }

    /// Forgets the answer given on a page, so that it is asked again.
    pub fn forget(&mut self, page: usize) {
        self.answers.remove(&page);
    }

    /// How many pages have been seen.
    pub fn seen(&self) -> usize {
        self.seen.len()
    }

    /// How many checkpoints have been answered.
    pub fn answered(&self) -> usize {
        self.answers.len()
    }

    /// How many were answered right.
    pub fn right(&self) -> usize {
        self.answers.values().filter(|(_, right)| *right).count()
    }
}

impl Book {
    /// A book of other chapters than those of the program alone.
    pub fn new(library: Library) -> Self {
        Self {
            library: Some(Arc::new(library)),
            ..Self::default()
        }
    }

    /// The chapters, and what was wrong with files that are left out.
    pub fn library(&self) -> &Library {
        let own = self.library.as_deref();
        own.unwrap_or_else(|| Library::embedded_once())
    }

    /// A chapter; `None` beyond the last.
    pub fn chapter(&self, number: usize) -> Option<&Chapter> {
        self.library().chapters.get(number)
    }

    /// The bookmark in a chapter, if it was ever opened.
    pub fn mark(&self, id: &str) -> Option<&Bookmark> {
        self.marks.get(id)
    }

    /// The bookmark in a chapter.
    pub fn mark_mut(&mut self, id: &str) -> &mut Bookmark {
        self.marks.entry(id.to_owned()).or_default()
    }

    /// Takes the bookmark out of a chapter: nothing of it has been read.
    pub fn reset(&mut self, id: &str) {
        self.marks.remove(id);
    }

    /// Whether all of a chapter has been read and answered.
    pub fn is_done(&self, chapter: &Chapter) -> bool {
        self.mark(&chapter.id).is_some_and(|mark| {
            mark.seen() >= chapter.pages.len() && mark.answered() >= checkpoints(chapter)
        })
    }

    /// The first chapter that is not done; `None` if all are.
    pub fn next(&self) -> Option<usize> {
        let chapters = &self.library().chapters;
        chapters.iter().position(|chapter| !self.is_done(chapter))
    }
}

/// How many checkpoints a chapter has.
pub(super) fn checkpoints(chapter: &Chapter) -> usize {
    let pages = chapter.pages.iter();
    pages.filter(|page| page.checkpoint.is_some()).count()
}

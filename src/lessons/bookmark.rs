//! How far a chapter has been read.

use std::collections::BTreeMap;

use super::{Chapter, ChapterPage};
use crate::quiz::Response;

/// How far a chapter has been read.
///
/// A bookmark identifies pages by their titles and answers by their questions, so it can still be
/// used after the chapter has changed: missing pages are ignored, and an answer to a different
/// question is not shown.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Bookmark {
    /// The title of the current page; `None` for the first page.
    pub place: Option<String>,
    /// The impact angle, in degrees, to which the student last set the chapter's figures.
    pub alpha_deg: Option<f64>,
    /// The titles of the pages that have been seen, each with the answer that was given on the
    /// page.
    pub pages: BTreeMap<String, Option<GivenAnswer>>,
}

/// An answer that was given at a checkpoint.
#[derive(Debug, Clone, PartialEq)]
pub struct GivenAnswer {
    /// The question: [`Checkpoint::written`](super::Checkpoint::written).
    pub asked: String,
    /// The answer; after a hint, the second answer.
    pub answer: Response,
    /// Whether the answer was right.
    pub right: bool,
    /// The first, wrong answer, if a hint followed it.
    pub first: Option<Response>,
}

impl Bookmark {
    /// Creates a bookmark at a page, which then counts as seen.
    pub fn at(page: &ChapterPage) -> Self {
        Self {
            place: Some(page.title.clone()),
            pages: BTreeMap::from([(page.title.clone(), None)]),
            ..Self::default()
        }
    }

    /// Creates a bookmark at a page, with an answer to the page's question; `right` says whether
    /// the answer is right.
    #[must_use]
    pub(crate) fn answering(
        page: &ChapterPage,
        (answer, first): (Response, Option<Response>),
        right: bool,
    ) -> Self {
        let mut mark = Self::at(page);
        let given = page.checkpoint.as_ref().map(|asked| GivenAnswer {
            asked: asked.written.clone(),
            answer,
            right,
            first,
        });
        mark.pages.insert(page.title.clone(), given);
        mark
    }

    /// The index of the current page, from 0; the first page if the current page no longer exists.
    pub fn page(&self, chapter: &Chapter) -> usize {
        let here = |page: &ChapterPage| Some(&page.title) == self.place.as_ref();
        chapter.pages.iter().position(here).unwrap_or(0)
    }

    /// The number of pages of the chapter that have been seen.
    pub fn seen(&self, chapter: &Chapter) -> usize {
        let seen = |page: &&ChapterPage| self.pages.contains_key(&page.title);
        chapter.pages.iter().filter(seen).count()
    }

    /// The answer that was given to a page's question; `None` if there is none or if it does not
    /// fit the question.
    pub fn given(&self, page: &ChapterPage) -> Option<&GivenAnswer> {
        let asked = page.checkpoint.as_ref()?;
        let given = self.pages.get(&page.title)?.as_ref();
        // In a modified database, an answer may not fit its question.
        let form = asked.form(None);
        let fits = |said: &Response| form.accepts(said);
        given.filter(|given| {
            given.asked == asked.written
                && fits(&given.answer)
                && given.first.as_ref().is_none_or(fits)
        })
    }

    /// All answers given to the chapter's questions.
    pub fn answers(&self, chapter: &Chapter) -> impl Iterator<Item = &GivenAnswer> {
        chapter.pages.iter().filter_map(|page| self.given(page))
    }

    /// The number of checkpoints in the chapter that have been answered.
    pub fn answered(&self, chapter: &Chapter) -> usize {
        self.answers(chapter).count()
    }

    /// The number of checkpoints that have been answered correctly.
    pub fn right(&self, chapter: &Chapter) -> usize {
        self.answers(chapter).filter(|given| given.right).count()
    }

    /// The number of correct answers that took a second try.
    pub fn right_after_hint(&self, chapter: &Chapter) -> usize {
        let answers = self.answers(chapter).filter(|given| given.right);
        answers.filter(|given| given.first.is_some()).count()
    }

    /// Whether the chapter has been completely read and answered.
    pub fn is_done(&self, chapter: &Chapter) -> bool {
        self.seen(chapter) == chapter.pages.len() && self.answered(chapter) == chapter.checkpoints()
    }

    /// Whether all questions in the chapter have been answered correctly.
    pub fn is_right(&self, chapter: &Chapter) -> bool {
        self.right(chapter) == chapter.checkpoints()
    }

    /// How far the chapter has been read and answered: "read 7 of 7, right 2 of 6".
    pub fn words(&self, chapter: &Chapter) -> String {
        let read = format!("read {} of {}", self.seen(chapter), chapter.pages.len());
        match chapter.checkpoints() {
            0 => read,
            asked => format!("{read}, right {} of {asked}", self.right(chapter)),
        }
    }

    /// Adds later entries. Their current page and their angle, if they have them, replace the
    /// earlier ones. A page that has been seen remains seen, and keeps its answer until the
    /// question is answered again.
    pub(crate) fn merge(&mut self, later: Self) {
        self.place = later.place.or_else(|| self.place.take());
        self.alpha_deg = later.alpha_deg.or(self.alpha_deg);
        for (title, given) in later.pages {
            let page = self.pages.entry(title).or_default();
            *page = given.or_else(|| page.take());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHAPTER: &str = "+++\nformat = 1\ntitle = \"T\"\nabout = \"A\"\n+++\n\
        # One\nText.\n\n# Two\n:::choice\nWhich?\n- [ ] This.\n  No.\n- [x] That.\n  Yes.\n:::\n\n\
        # Three\nText.\n";

    fn chapter(text: &str) -> Chapter {
        Chapter::read("01-test.md", text.as_bytes()).unwrap()
    }

    /// A bookmark with two seen pages; the second page is answered and is the current page.
    fn read(chapter: &Chapter) -> Bookmark {
        let mut mark = Bookmark::at(&chapter.pages[0]);
        mark.merge(Bookmark::at(&chapter.pages[1]));
        mark.merge(answer(&chapter.pages[1], 1, true));
        mark
    }

    fn answer(page: &ChapterPage, line: usize, right: bool) -> Bookmark {
        let given = GivenAnswer {
            asked: page.checkpoint.as_ref().unwrap().written.clone(),
            answer: Response::Choice(line),
            right,
            first: None,
        };
        Bookmark {
            pages: BTreeMap::from([(page.title.clone(), Some(given))]),
            ..Bookmark::default()
        }
    }

    /// The index of the current page, and the numbers of pages that were seen, answered, and
    /// answered correctly.
    fn standing(mark: &Bookmark, chapter: &Chapter) -> [usize; 4] {
        [
            mark.page(chapter),
            mark.seen(chapter),
            mark.answered(chapter),
            mark.right(chapter),
        ]
    }

    #[test]
    fn reading_progress_adds_up() {
        let chapter = chapter(CHAPTER);
        let mut mark = read(&chapter);
        assert_eq!(standing(&mark, &chapter), [1, 2, 1, 1]);
        assert!(!mark.is_done(&chapter));
        // A page that is seen again keeps its answer; a page that is answered again has the later
        // answer.
        mark.merge(Bookmark::at(&chapter.pages[1]));
        assert_eq!(standing(&mark, &chapter), [1, 2, 1, 1]);
        mark.merge(answer(&chapter.pages[1], 0, false));
        mark.merge(Bookmark::at(&chapter.pages[2]));
        assert_eq!(standing(&mark, &chapter), [2, 3, 1, 0]);
        assert!(mark.is_done(&chapter));
        assert_eq!(mark.words(&chapter), "read 3 of 3, right 0 of 1");
    }

    /// A modified database may contain an answer that does not fit its question.
    #[test]
    fn an_answer_that_does_not_fit_its_question_is_ignored() {
        let chapter = chapter(CHAPTER);
        let page = &chapter.pages[1];
        for said in [Response::Choice(99), Response::Number(1.0)] {
            let mut mark = answer(page, 1, true);
            let given = mark.pages.get_mut(&page.title).unwrap().as_mut().unwrap();
            given.answer = said;
            assert_eq!(mark.given(page), None);
            let mut mark = answer(page, 1, true);
            let given = mark.pages.get_mut(&page.title).unwrap().as_mut().unwrap();
            given.first = Some(said);
            assert_eq!(mark.given(page), None);
        }
        assert!(answer(page, 1, true).given(page).is_some());
    }

    #[test]
    fn a_bookmark_fits_a_chapter_that_has_changed() {
        let mark = read(&chapter(CHAPTER));
        let standing = |text: &str| standing(&mark, &chapter(text));
        let header = CHAPTER.split("# One").next().unwrap();
        let inserted = CHAPTER.replace("# One", "# Zero\nText.\n\n# One");
        assert_eq!(standing(&inserted), [2, 2, 1, 1], "a page was added");
        assert_eq!(standing(&format!("{header}# One\nText.\n")), [0, 1, 0, 0]);
        assert_eq!(standing(&CHAPTER.replace("# Two", "# 2")), [0, 1, 0, 0]);
        assert_eq!(
            standing(&CHAPTER.replace("\"T\"", "\"Other\"")),
            [1, 2, 1, 1]
        );
        let other = CHAPTER.replace("Which?", "Which not?");
        assert_eq!(standing(&other), [1, 2, 0, 0], "another question");
        let number = ":::number answer=1 tolerance=1\nHow many?\n---\nOne.\n:::";
        let start = CHAPTER.find(":::choice").unwrap();
        let end = start + CHAPTER[start..].find("\n:::").unwrap() + 4;
        let asked = format!("{}{number}{}", &CHAPTER[..start], &CHAPTER[end..]);
        assert_eq!(standing(&asked), [1, 2, 0, 0], "another kind of question");
        let unasked = format!("{}Text.{}", &CHAPTER[..start], &CHAPTER[end..]);
        assert_eq!(standing(&unasked), [1, 2, 0, 0], "the question was removed");
    }
}

//! How far a chapter has been read.

use std::collections::BTreeMap;

use super::{Chapter, ChapterPage, Checkpoint};
use crate::quiz::Response;

/// How far a chapter has been read.
///
/// It knows pages by their titles and answers by what was asked. So it still fits a chapter that
/// has changed since: missing pages are ignored, and an answer to a different question is not
/// shown.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Bookmark {
    /// The title of the page it is open at; `None` at the first.
    pub place: Option<String>,
    /// The impact angle that the student set last in its figures, in degrees.
    pub alpha_deg: Option<f64>,
    /// The pages that have been seen, by title, each with the answer given there.
    pub pages: BTreeMap<String, Option<GivenAnswer>>,
}

/// An answer that was given at a checkpoint.
#[derive(Debug, Clone, PartialEq)]
pub struct GivenAnswer {
    /// What was asked: [`Checkpoint::written`](super::Checkpoint::written).
    pub asked: String,
    /// What was answered.
    pub answer: Response,
    /// Whether it was right.
    pub right: bool,
    /// The wrong answer before it, after which there was a hint.
    pub first: Option<Response>,
}

impl Bookmark {
    /// A bookmark at a page, which is seen with that.
    pub fn at(page: &ChapterPage) -> Self {
        Self {
            place: Some(page.title.clone()),
            pages: BTreeMap::from([(page.title.clone(), None)]),
            ..Self::default()
        }
    }

    /// The same with an answer given to what its page asks, `right` or not.
    #[must_use]
    pub(crate) fn answering(
        page: &ChapterPage,
        asked: &Checkpoint,
        (answer, first): (Response, Option<Response>),
        right: bool,
    ) -> Self {
        let mut mark = Self::at(page);
        let asked = asked.written.clone();
        let given = GivenAnswer {
            asked,
            answer,
            right,
            first,
        };
        mark.pages.insert(page.title.clone(), Some(given));
        mark
    }

    /// The page it is open at, from 0; the first where that page is gone.
    pub fn page(&self, chapter: &Chapter) -> usize {
        let here = |page: &ChapterPage| Some(&page.title) == self.place.as_ref();
        chapter.pages.iter().position(here).unwrap_or(0)
    }

    /// How many pages of the chapter have been seen.
    pub fn seen(&self, chapter: &Chapter) -> usize {
        let seen = |page: &&ChapterPage| self.pages.contains_key(&page.title);
        chapter.pages.iter().filter(seen).count()
    }

    /// The answer that was given to what a page asks; none where it does not fit that.
    pub fn given(&self, page: &ChapterPage) -> Option<&GivenAnswer> {
        let asked = page.checkpoint.as_ref()?;
        let given = self.pages.get(&page.title)?.as_ref();
        // A modified database may contain such an answer.
        let form = asked.form(None, |_| String::new());
        let fits = |said: &Response| form.accepts(said);
        given.filter(|given| {
            given.asked == asked.written
                && fits(&given.answer)
                && given.first.as_ref().is_none_or(fits)
        })
    }

    /// All answers given to what the chapter asks.
    pub fn answers(&self, chapter: &Chapter) -> impl Iterator<Item = &GivenAnswer> {
        chapter.pages.iter().filter_map(|page| self.given(page))
    }

    /// How many checkpoints of the chapter have been answered.
    pub fn answered(&self, chapter: &Chapter) -> usize {
        self.answers(chapter).count()
    }

    /// How many of them were answered right.
    pub fn right(&self, chapter: &Chapter) -> usize {
        self.answers(chapter).filter(|given| given.right).count()
    }

    /// How many of those took a second try.
    pub fn right_after_hint(&self, chapter: &Chapter) -> usize {
        let answers = self.answers(chapter).filter(|given| given.right);
        answers.filter(|given| given.first.is_some()).count()
    }

    /// Whether all of the chapter has been read and answered.
    pub fn is_done(&self, chapter: &Chapter) -> bool {
        self.seen(chapter) == chapter.pages.len() && self.answered(chapter) == chapter.checkpoints()
    }

    /// Whether all that it asks was answered right.
    pub fn is_right(&self, chapter: &Chapter) -> bool {
        self.right(chapter) == chapter.checkpoints()
    }

    /// How far the chapter has been read and answered, in words: "read 7 of 7, right 2
    /// of 6".
    pub fn words(&self, chapter: &Chapter) -> String {
        let read = format!("read {} of {}", self.seen(chapter), chapter.pages.len());
        match chapter.checkpoints() {
            0 => read,
            asked => format!("{read}, right {} of {asked}", self.right(chapter)),
        }
    }

    /// Adds later entries: their place and angle, if any, replace the earlier ones; a page stays
    /// seen, and answered until it is answered again.
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

    /// The first two pages seen, the second answered, left at the second.
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

    /// Page, pages seen, answered, right.
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
        // Seen again, a page keeps its answer; answered again, it has the later one.
        mark.merge(Bookmark::at(&chapter.pages[1]));
        assert_eq!(standing(&mark, &chapter), [1, 2, 1, 1]);
        mark.merge(answer(&chapter.pages[1], 0, false));
        mark.merge(Bookmark::at(&chapter.pages[2]));
        assert_eq!(standing(&mark, &chapter), [2, 3, 1, 0]);
        assert!(mark.is_done(&chapter));
        assert_eq!(mark.words(&chapter), "read 3 of 3, right 0 of 1");
    }

    /// A modified database may contain such an answer.
    #[test]
    fn an_answer_that_does_not_fit_what_is_asked_is_none() {
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
    fn it_fits_a_chapter_that_was_changed() {
        let mark = read(&chapter(CHAPTER));
        let standing = |text: &str| standing(&mark, &chapter(text));
        let header = CHAPTER.split("# One").next().unwrap();
        let inserted = CHAPTER.replace("# One", "# Zero\nText.\n\n# One");
        assert_eq!(standing(&inserted), [2, 2, 1, 1], "a page more");
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
        assert_eq!(standing(&unasked), [1, 2, 0, 0], "no question any more");
    }
}

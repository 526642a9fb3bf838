use super::*;
use crate::files::FileLibrary;
use crate::quiz::concepts;
use crate::quiz::{Misconception, Topic};

#[test]
fn the_chapters_in_the_program_are_whole() {
    let library = ChapterLibrary::embedded();
    assert_eq!(library.problems, []);
    assert!(!library.chapters.is_empty());
}

#[test]
fn each_misconception_and_each_topic_leads_to_a_page_that_exists() {
    let book = Book::default();
    for belief in Misconception::ALL {
        let named = book.named(belief.settled_by());
        assert!(named.is_some(), "{belief:?}: {:?}", belief.settled_by());
    }
    let written = concepts::all().iter().map(|concept| concept.topic());
    for topic in Topic::all().chain(written) {
        let named = topic.taught_on().and_then(|page| book.named(page));
        assert!(named.is_some(), "{topic}: {:?}", topic.taught_on());
    }
}

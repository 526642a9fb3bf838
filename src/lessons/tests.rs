use super::*;

#[test]
fn the_chapters_in_the_program_are_whole() {
    let library = ChapterLibrary::embedded();
    assert_eq!(library.problems, []);
    assert!(!library.chapters.is_empty());
}

//! How the truth is told.

use super::shown::ClassReveal;
use super::words::Paragraph;
use crate::class::WayOfVoting;
use crate::quiz::{Question, Response, letter};
use crate::widgets::Role;

/// What is told of the shot: while it explains itself its words; then the truth with the one
/// sentence that matters, and on further pages all of why.
pub(super) fn said(
    way: WayOfVoting,
    question: &Question,
    shown: &ClassReveal,
) -> Vec<Vec<Paragraph>> {
    if let Some(watch) = shown.reveal.watch()
        && shown.reveal.is_telling()
    {
        let (heading, words) = watch.telling();
        let heading = heading.map(|it| Paragraph::new(it, Role::Title));
        let words = Paragraph::new(words, Role::Text);
        return vec![heading.into_iter().chain([words]).collect()];
    }
    let truth = question.form.truth();
    let mut words = question.form.words(&truth);
    if let Response::Choice(i) = truth {
        words = format!("{}: {words}", letter(i));
    }
    let mut first = vec![Paragraph::new(words, Role::Title)];
    if let Some((name, count)) = &shown.held {
        let words = format!("{}: {name}.", way.voters(*count));
        first.push(Paragraph::new(words, Role::Title));
    }
    let (sentence, rest) = first_sentence(&shown.why);
    first.push(Paragraph::new(sentence, Role::Text));
    let mut said = vec![first];
    if !rest.is_empty() {
        said.push(vec![Paragraph::new(rest, Role::Text)]);
    }
    said
}

/// The first sentence of a text, and what comes after it.
fn first_sentence(text: &str) -> (&str, &str) {
    let ends = text
        .char_indices()
        .filter(|(_, c)| ['.', '!', '?'].contains(c));
    let mut ends = ends.map(|(at, _)| at + 1);
    let end = ends.find(|at| {
        let mut next = text[*at..].chars();
        next.next().is_some_and(char::is_whitespace) && next.next().is_some_and(char::is_uppercase)
    });
    let (first, rest) = text.split_at(end.unwrap_or(text.len()));
    (first, rest.trim_start())
}

#[cfg(test)]
mod tests {
    use super::first_sentence;

    #[test]
    fn the_first_sentence_ends_where_another_begins() {
        let parts = |text| first_sentence(text);
        assert_eq!(parts("At 4.00 m/s. Then?"), ("At 4.00 m/s.", "Then?"));
        assert_eq!(parts("One, e. g. this one"), ("One, e. g. this one", ""));
        assert_eq!(parts(""), ("", ""));
    }
}

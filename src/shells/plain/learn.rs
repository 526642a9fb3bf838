//! The chapters in lines.

use std::collections::BTreeMap;

use super::by_words::{KEY, by_words};
use super::own_shot::{HELP, ShotWish};
use super::recorder::AnswerRecorder;
use super::spoken::{sentence, verbatim};
use super::talk::{Leave, Talk};
use super::{answering, figure, formula, own_shot};
use crate::lessons::{
    Bookmark, Chapter, ChapterLibrary, ChapterPage, Checkpoint, CheckpointKind, Figure, FigureKind,
    Inline, TextBlock, Tone,
};
use crate::messages::{StoreReply, StoreRequest};
use crate::numbers::with_unit;
use crate::physics::{Collision, CollisionSpec, worked};
use crate::quiz::{Form, Response};
use crate::screens::learn::attempt;

/// What may be said between two pages.
const MOVES: &str = "Enter or next for the next page, back for the one before, contents for the \
                     chapters, quit to leave.";

/// What is said of a page whose figure can be set.
const OWN: &str = "You can set a shot of your own here: help says how.";

/// Reads the chapters to the player, from `chapter` (from 0) on, or from the contents.
///
/// # Errors
/// If the player quits, or nothing more is to be heard: the place is kept.
pub fn learn(
    recorder: &mut AnswerRecorder,
    library: &ChapterLibrary,
    chapter: Option<usize>,
) -> Result<(), Leave> {
    let talk = &mut *recorder.talk;
    talk.say("carrom, the lessons. Type help at any time, and quit to leave.")?;
    for fault in &library.problems {
        talk.say(&format!("Left out: {}", verbatim(&fault.to_string())))?;
    }
    let mut chosen = chapter;
    loop {
        let at = match chosen.take() {
            Some(at) => at,
            None => contents(recorder, library)?,
        };
        if let Some(chapter) = library.chapters.get(at)
            && read(recorder, chapter)?
        {
            chosen = Some(at + 1).filter(|next| *next < library.chapters.len());
        }
    }
}

/// Asks which chapter it shall be.
fn contents(recorder: &mut AnswerRecorder, library: &ChapterLibrary) -> Result<usize, Leave> {
    let marks = marks(recorder)?;
    let mut lead = vec!["The chapters.".to_owned()];
    lead.extend((1..).zip(&library.chapters).map(|(number, chapter)| {
        let title = sentence(&chapter.title);
        let read = match marks.get(&chapter.id) {
            Some(mark) if mark.is_done(chapter) => " Done.".to_owned(),
            Some(mark) => {
                let seen = mark.seen(chapter);
                format!(" {seen} of {} pages read.", chapter.pages.len())
            }
            None => String::new(),
        };
        format!("{number}: {title} {}{read}", chapter.about)
    }));
    let asked = "Which one? Type its number.";
    let help = "Type the number of a chapter. It opens at the page where you left it.";
    recorder.talk.ask_for(&lead, asked, help, |heard| {
        let number: Option<usize> = heard.parse().ok();
        let at = number.and_then(|number| number.checked_sub(1));
        at.filter(|at| *at < library.chapters.len())
            .ok_or_else(|| format!("Please type a number from 1 to {}.", library.chapters.len()))
    })
}

/// The player's bookmarks; none where they cannot be looked up.
fn marks(recorder: &mut AnswerRecorder) -> Result<BTreeMap<String, Bookmark>, Leave> {
    let player = recorder.player.to_owned();
    Ok(match recorder.wish(StoreRequest::Marks(player))? {
        StoreReply::Marks(Ok(marks)) => marks,
        _ => BTreeMap::new(),
    })
}

/// Reads a chapter from where it was left; whether to its end.
fn read(recorder: &mut AnswerRecorder, chapter: &Chapter) -> Result<bool, Leave> {
    let marks = marks(recorder)?;
    let mut at = marks.get(&chapter.id).map_or(0, |mark| mark.page(chapter));
    let title = sentence(&chapter.title);
    let opening = format!("Chapter {}: {title}", chapter.number);
    recorder.talk.say(&opening)?;
    let mut shown = ShownPage::default();
    while let Some(page) = chapter.pages.get(at) {
        mark(recorder, chapter, Bookmark::at(page))?;
        let (title, count) = (sentence(&page.title), chapter.pages.len());
        let heading = format!("Page {} of {count}: {title}", at + 1);
        recorder.talk.say(&heading)?;
        let collision = page.figure.map(|figure| figure.shot.collision());
        let figure = collision.as_ref();
        recorder.talk.say_all(texts(&page.text, figure))?;
        shown.open(recorder.talk, figure::describe(chapter, at, false))?;
        if let Some(checkpoint) = &page.checkpoint
            && ask(recorder, chapter, (at, page), checkpoint, figure)?
        {
            shown.add(recorder.talk, figure::describe(chapter, at, true))?;
        }
        let Some(next) = turn(recorder.talk, at, page)? else {
            return Ok(false);
        };
        if next <= at {
            shown = ShownPage::default();
        }
        at = next;
    }
    recorder.talk.say("That is the end of the chapter.")?;
    // It is opened at its beginning the next time.
    if let Some(first) = chapter.pages.first() {
        mark(recorder, chapter, Bookmark::at(first))?;
    }
    Ok(true)
}

/// Asks where to go from a page, and plays shots of one's own until then; `None` is to the
/// contents.
fn turn(talk: &mut Talk, at: usize, page: &ChapterPage) -> Result<Option<usize>, Leave> {
    enum ReadingWish {
        Turn(Option<usize>),
        Shot(ShotWish),
    }
    let is_hit = |figure: &Figure| {
        !matches!(
            figure.kind,
            FigureKind::Foil { .. } | FigureKind::Shots { .. }
        )
    };
    let settable = page.figure.filter(is_hit);
    let mut shot = settable.map_or_else(CollisionSpec::default, |figure| figure.shot);
    if settable.is_some() {
        talk.say(OWN)?;
    }
    let help = format!("{MOVES} {HELP}");
    loop {
        let read = |heard: &str| match heard.to_lowercase().as_str() {
            "" | "next" | "n" => Ok(ReadingWish::Turn(Some(at + 1))),
            "back" | "b" => Ok(ReadingWish::Turn(Some(at.saturating_sub(1)))),
            "contents" | "c" => Ok(ReadingWish::Turn(None)),
            _ => match ShotWish::read(heard, &shot) {
                Some(wish) => wish.map(ReadingWish::Shot),
                None => Err(MOVES.to_owned()),
            },
        };
        match talk.ask_for(&[], "Next?", &help, read)? {
            ReadingWish::Turn(to) => return Ok(to),
            ReadingWish::Shot(ShotWish::Set(new)) => {
                shot = new;
                own_shot::say_set(talk, &shot)?;
            }
            ReadingWish::Shot(ShotWish::Shoot) => own_shot::shoot(talk, &shot)?,
        }
    }
}

/// What the figures of a chapter have shown, so that it is said once rather than on every
/// page anew.
#[derive(Default)]
struct ShownPage(Vec<String>);

impl ShownPage {
    /// Says what the figure of a page shows as the page is opened.
    fn open(&mut self, talk: &mut Talk, lines: Vec<String>) -> Result<(), Leave> {
        match lines.first() {
            Some(first) if self.0.contains(first) => talk.say("Figure: the same as before.")?,
            _ => {}
        }
        self.add(talk, lines)
    }

    /// Says what is new of it.
    fn add(&mut self, talk: &mut Talk, lines: Vec<String>) -> Result<(), Leave> {
        for line in lines {
            if !self.0.contains(&line) {
                talk.say(&line)?;
                self.0.push(line);
            }
        }
        Ok(())
    }
}

fn mark(recorder: &mut AnswerRecorder, chapter: &Chapter, later: Bookmark) -> Result<(), Leave> {
    recorder.wish(StoreRequest::Mark {
        player: recorder.player.to_owned(),
        chapter: chapter.id.clone(),
        later: Box::new(later),
    })?;
    Ok(())
}

/// Asks what a page asks, keeps the answer, and says how it is; whether there was one.
fn ask(
    recorder: &mut AnswerRecorder,
    chapter: &Chapter,
    (at, page): (usize, &ChapterPage),
    checkpoint: &Checkpoint,
    figure: Option<&Collision>,
) -> Result<bool, Leave> {
    let form = checkpoint.form(figure, |text| pieces(text, figure));
    let question = texts(&checkpoint.question, figure);
    let Some(mut answer) = answering::answer(recorder.talk, &question, &form)? else {
        recorder.talk.say("Left open.")?;
        return Ok(false);
    };
    let player = recorder.player;
    recorder.record(attempt(player, chapter, at, &form, (&answer, false)))?;
    let mut first = None;
    if checkpoint.offers_second_try(&form, &answer) {
        recorder
            .talk
            .say("Not yet. Here is a hint, for a second try.")?;
        let hint = texts(&checkpoint.hint_to(&answer), figure);
        if let Some(second) = answering::answer(recorder.talk, &hint, &form)? {
            recorder.record(attempt(player, chapter, at, &form, (&second, true)))?;
            first = Some(std::mem::replace(&mut answer, second));
        }
    }
    let right = form.is_right(&answer);
    let later = Bookmark::answering(page, checkpoint, (answer, first), right);
    mark(recorder, chapter, later)?;
    tell(recorder.talk, &answer, (checkpoint, &form), figure)?;
    recorder.talk.say_all(texts(&checkpoint.after, figure))?;
    Ok(true)
}

/// Says how an answer was.
fn tell(
    talk: &mut Talk,
    answer: &Response,
    (checkpoint, form): (&Checkpoint, &Form),
    figure: Option<&Collision>,
) -> Result<(), Leave> {
    let right = form.is_right(answer);
    talk.say(if right { "Right." } else { "Not quite." })?;
    match (answer, &checkpoint.asked) {
        (Response::Rays(rays), _) => match figure {
            Some(collision) => own_shot::tell_rays(talk, (*rays, right), collision, "coin"),
            None => Ok(()),
        },
        (Response::Choice(chosen), CheckpointKind::Choice(choices)) => {
            let chosen = choices.get(*chosen);
            talk.say_all(chosen.map(|chosen| pieces(&chosen.why, figure)))?;
            match choices.iter().find(|choice| choice.right) {
                Some(true_one) if !right => {
                    talk.say(&format!("It is: {}", pieces(&true_one.text, figure)))?;
                    talk.say(&pieces(&true_one.why, figure))
                }
                _ => Ok(()),
            }
        }
        (
            _,
            CheckpointKind::Number {
                expected,
                tolerance,
            },
        ) => {
            let (_, unit) = expected.sign_and_unit();
            let truth = expected.value(figure);
            let truth = truth.map(|truth| worked::beside(truth, *tolerance));
            talk.say_all(truth.map(|truth| format!("It is {}.", with_unit(&truth, unit))))
        }
        _ => Ok(()),
    }
}

/// Blocks of text, a line each.
fn texts(blocks: &[TextBlock], figure: Option<&Collision>) -> Vec<String> {
    let line = |block: &TextBlock| match block {
        TextBlock::Paragraph(text) => pieces(text, figure),
        TextBlock::Item(Some(number), text) => format!("{number}: {}", pieces(text, figure)),
        TextBlock::Item(None, text) => format!("Item: {}", pieces(text, figure)),
        TextBlock::Formula(written) => format!("Formula: {}", formula::aloud(written)),
    };
    blocks.iter().map(line).collect()
}

fn pieces(pieces: &[Inline], figure: Option<&Collision>) -> String {
    let words = |piece: &Inline| match piece {
        Inline::Text(key, Tone::Key) => format!("{KEY}{key}"),
        Inline::Text(text, _) => text.clone(),
        Inline::Formula(written) => formula::aloud(written),
        Inline::Live(quantity) => figure.map(|it| quantity.shown(it)).unwrap_or_default(),
    };
    by_words(&pieces.iter().map(words).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::super::spoken;
    use super::*;
    use crate::lessons::Formula;

    /// Every text of the chapters: what is read, asked, chosen from and explained.
    fn every_text(library: &ChapterLibrary) -> Vec<(&[TextBlock], Option<Collision>)> {
        let pages = library.chapters.iter().flat_map(|chapter| &chapter.pages);
        pages
            .flat_map(|page| {
                let hit = page.figure.map(|figure| figure.shot.collision());
                let checkpoint = page.checkpoint.iter();
                let asked = checkpoint.flat_map(|it| [&it.question[..], &it.hint, &it.after]);
                std::iter::once(&page.text[..])
                    .chain(asked)
                    .map(move |text| (text, hit))
            })
            .collect()
    }

    fn choices(library: &ChapterLibrary) -> impl Iterator<Item = &[Inline]> {
        let pages = library.chapters.iter().flat_map(|chapter| &chapter.pages);
        let asked = pages.filter_map(|page| page.checkpoint.as_ref());
        let choices = asked.flat_map(|checkpoint| match &checkpoint.asked {
            CheckpointKind::Choice(choices) => &choices[..],
            _ => &[],
        });
        choices.flat_map(|choice| [&choice.text[..], &choice.why])
    }

    fn formulas(library: &ChapterLibrary) -> Vec<&Formula> {
        let texts = every_text(library);
        let blocks = texts.into_iter().flat_map(|(text, _)| text);
        let mut formulas = Vec::new();
        let mut lines: Vec<&[Inline]> = choices(library).collect();
        for block in blocks {
            match block {
                TextBlock::Formula(formula) => formulas.push(formula),
                TextBlock::Paragraph(line) | TextBlock::Item(_, line) => lines.push(line),
            }
        }
        formulas.extend(lines.into_iter().flatten().filter_map(|piece| match piece {
            Inline::Formula(formula) => Some(formula),
            _ => None,
        }));
        formulas
    }

    #[test]
    fn no_formula_of_the_chapters_is_spoken_with_a_unit() {
        let units = ["metre", "gram", "second", "joule", "volt", "percent"];
        let formulas = formulas(ChapterLibrary::embedded_once());
        assert!(formulas.len() > 100, "{}", formulas.len());
        for formula in formulas {
            let said = spoken(&formula::aloud(formula));
            assert!(!units.iter().any(|unit| said.contains(unit)), "{said}");
            super::super::assert_spoken(&said);
        }
    }

    #[test]
    fn every_text_of_the_chapters_is_spoken_whole() {
        let library = ChapterLibrary::embedded_once();
        for (text, hit) in every_text(library) {
            for line in texts(text, hit.as_ref()) {
                super::super::assert_spoken(&spoken(&line));
            }
        }
        for text in choices(library) {
            super::super::assert_spoken(&spoken(&pieces(text, None)));
        }
        for chapter in &library.chapters {
            for at in 0..chapter.pages.len() {
                for answered in [false, true] {
                    for line in figure::describe(chapter, at, answered) {
                        super::super::assert_spoken(&spoken(&line));
                    }
                }
            }
        }
    }

    #[test]
    fn no_figure_tells_what_a_later_page_of_it_asks() {
        let library = ChapterLibrary::embedded_once();
        let chapter = &library.chapters[1];
        let asks_rays = |page: &ChapterPage| {
            let asked = page.checkpoint.as_ref().map(|checkpoint| &checkpoint.asked);
            matches!(asked, Some(CheckpointKind::Rays))
        };
        let rays = chapter.pages.iter().position(asks_rays).unwrap();
        let leaves = |at, answered| {
            let lines = figure::describe(chapter, at, answered);
            lines.iter().any(|line| line.contains("leaves at"))
        };
        assert!((0..rays).all(|at| !leaves(at, true)));
        assert!(!leaves(rays, false) && leaves(rays, true));
    }
}

//! How a step of a question looks: one line of what to do, then picture and words as large as
//! they fit, then what is entered.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::heading::{Heading, below, column};
use super::play::{ClassPhase, ClassPlay};
use super::words::{Beside, Paragraph, PlacedWords, screen_rows};
use super::{question_view, shown_view, spread_view, tally_entry, vote_view};
use crate::class::{ClassStep, Vote};
use crate::quiz::Question;
use crate::widgets::{
    Item, Lines, Look, Role, Room, Words, areas, draw_question, rehearsed, sheet,
};

/// A step laid out on the screen.
pub(super) struct StepView<'a> {
    play: &'a ClassPlay,
    question: &'a Question,
    heading: Option<Heading>,
    /// Where the heading stands.
    area: Rect,
    /// What is said, and what is told beyond it, each on pages of its own.
    said: Vec<Said>,
    /// Rows below the words.
    foot: Rect,
    /// Between both.
    middle: Rect,
}

/// Words that belong together.
struct Said {
    paragraphs: Vec<Paragraph>,
    /// Where they are; `None` where a letter is not to be had in large type.
    placed: Option<PlacedWords>,
}

impl Said {
    fn pages(&self) -> usize {
        self.placed.as_ref().map_or(1, PlacedWords::pages)
    }
}

impl<'a> StepView<'a> {
    /// Lays a step out. The heading is large only where the words are so too, and where that costs
    /// them neither a page nor the size of their letters, and the picture not much.
    pub(super) fn new(play: &'a ClassPlay, room: Room, look: &Look) -> Option<Self> {
        let question = play.question()?;
        let heading = play.heading();
        let small = heading
            .clone()
            .filter(|it| !it.is_bare())
            .map(Heading::small);
        let with = |heading| Self::under(play, question, heading, room, look);
        let large = with(heading);
        let small = with(small);
        let as_good = match (large.first(), small.first()) {
            (Some(large), Some(small)) => {
                (large.pages(), small.pages()) == (1, 1)
                    && large.size == small.size
                    && large.size.is_of_names(look.charset)
                    && 4 * large.picture(0).height >= 3 * small.picture(0).height
            }
            _ => false,
        };
        Some(if as_good { large } else { small })
    }

    fn under(
        play: &'a ClassPlay,
        question: &'a Question,
        heading: Option<Heading>,
        room: Room,
        look: &Look,
    ) -> Self {
        let area = room.area;
        let rest = heading.as_ref().map_or(area, |it| it.rest(area, look));
        let foot = match &play.phase {
            ClassPhase::Vote(entry) => vote_view::foot_rows(play, question, entry, rest, look),
            ClassPhase::Tally(_) => tally_entry::ROWS,
            _ if play.step() == ClassStep::Talk => rehearsed(rest, *look, |lines| {
                spread_view::write_more(play, question, lines);
                lines.written()
            }),
            _ => 0,
        };
        let [middle, foot] = areas::upper(rest, rest.height.saturating_sub(foot));
        let said = said(play, question);
        let many = said.len() > 1;
        let beside = beside(play, question);
        let rows = screen_rows(area);
        let within = Room {
            area: middle,
            ..room
        };
        let each = said.into_iter().map(|paragraphs| Said {
            placed: PlacedWords::new(&paragraphs, beside, many, within, rows, look),
            paragraphs,
        });
        Self {
            play,
            question,
            heading,
            area,
            said: each.collect(),
            foot,
            middle,
        }
    }

    fn first(&self) -> Option<&PlacedWords> {
        self.said.first()?.placed.as_ref()
    }

    /// How many pages there are.
    pub(super) fn pages(&self) -> usize {
        self.said.iter().map(Said::pages).sum()
    }

    /// The words that are shown, and the number of the page among theirs.
    fn at(&self) -> Option<(&Said, usize)> {
        let mut page = self.play.page.min(self.pages().saturating_sub(1));
        self.said.iter().find_map(|said| {
            if page < said.pages() {
                return Some((said, page));
            }
            page -= said.pages();
            None
        })
    }

    /// The place of the picture; of no cell where there is none.
    pub(super) fn picture(&self) -> Rect {
        let at = self.at();
        let place = at.and_then(|(said, page)| Some(said.placed.as_ref()?.picture(page)));
        place.unwrap_or(Rect {
            width: 0,
            ..self.middle
        })
    }

    /// Where what is entered stands.
    pub(super) const fn foot(&self) -> Rect {
        self.foot
    }

    /// The choice at a cell, from 0.
    pub(super) fn choice_at(&self, cell: (u16, u16)) -> Option<usize> {
        let (said, page) = self.at()?;
        said.placed.as_ref()?.at(page, cell)?.checked_sub(1)
    }

    pub(super) fn draw(&self, buf: &mut Buffer, look: &Look) {
        if let Some(heading) = &self.heading {
            heading.draw(self.area, buf, look);
        }
        let Some((said, page)) = self.at() else {
            return;
        };
        if let Some(left) = self.play.countdown {
            let seconds = left.as_nanos().div_ceil(1_000_000_000);
            let words = format!(" {}:{:02} ", seconds / 60, seconds % 60);
            let column = self.area.right().saturating_sub(words.len() as u16);
            sheet::note(self.area, || {
                Item::new(Words::large(words.trim(), Role::Selected))
            });
            let style = look.theme.style(Role::Selected);
            buf.set_stringn(column, self.area.y, &words, words.len(), style);
        }
        match &said.placed {
            Some(placed) => {
                draw_picture(self.play, self.question, self.picture(), buf, look);
                placed.draw(page, &said.paragraphs, buf, look);
                self.draw_number(placed.words(page), buf, look);
            }
            None => self.draw_plain(&said.paragraphs, buf, look),
        }
        match &self.play.phase {
            ClassPhase::Vote(entry) => {
                vote_view::draw(self.play, self.question, entry, self.foot, buf, look);
            }
            ClassPhase::Tally(entry) => entry.draw(self.play.round(), self.foot, buf, look),
            ClassPhase::Look if self.play.step() == ClassStep::Talk => {
                let mut lines = Lines::new(self.foot, buf, *look);
                spread_view::write_more(self.play, self.question, &mut lines);
            }
            _ => {}
        }
    }

    /// Says which page it is, where there are several.
    fn draw_number(&self, words: Rect, buf: &mut Buffer, look: &Look) {
        let pages = self.pages();
        if pages < 2 || words.height == 0 {
            return;
        }
        let page = self.play.page.min(pages - 1) + 1;
        let key = match page == pages {
            true => "PageUp: back",
            false => "PageDown: the rest",
        };
        let note = format!("page {page} of {pages}  {key}");
        let column = words.right().saturating_sub(note.len() as u16).max(words.x);
        let style = look.theme.style(Role::Key);
        let room = words.right() - column;
        buf.set_stringn(column, words.bottom() - 1, note, room.into(), style);
    }

    /// Words of which a letter is not to be had in large type.
    fn draw_plain(&self, paragraphs: &[Paragraph], buf: &mut Buffer, look: &Look) {
        let write = |lines: &mut Lines| {
            for paragraph in paragraphs {
                lines.paragraph(&paragraph.text, paragraph.role);
                lines.gap();
            }
        };
        let place = column(self.middle);
        let rows = rehearsed(place, *look, |lines| {
            write(lines);
            lines.written()
        });
        write(&mut Lines::new(place, buf, *look));
        let rest = below(self.middle, rows);
        if beside(self.play, self.question) != Beside::Nothing {
            draw_picture(self.play, self.question, rest, buf, look);
        }
    }
}

/// What is said at a step, and what is told on a key.
fn said(play: &ClassPlay, question: &Question) -> Vec<Vec<Paragraph>> {
    match (&play.phase, play.step()) {
        (ClassPhase::Shot(shown), _) => shown_view::said(play.round().way(), question, shown),
        (ClassPhase::Look, ClassStep::Talk) => vec![spread_view::said(play, question)],
        (ClassPhase::Tally(entry), _) => {
            // Before the second vote is counted all see the first.
            let shown = (entry.vote == Vote::Second).then_some(Vote::First);
            vec![question_view::paragraphs(play, question, shown)]
        }
        _ => vec![question_view::paragraphs(play, question, None)],
    }
}

/// The picture of a step.
fn beside(play: &ClassPlay, question: &Question) -> Beside {
    match (&play.phase, play.step()) {
        (ClassPhase::Look, _) if play.words_alone => Beside::Nothing,
        (ClassPhase::Shot(shown), _) if shown.reveal.watch().is_some() => Beside::Needed,
        (ClassPhase::Look, ClassStep::Talk) => spread_view::beside(play, question),
        _ => question_view::beside(question),
    }
}

/// Draws the picture of a step.
fn draw_picture(play: &ClassPlay, question: &Question, place: Rect, buf: &mut Buffer, look: &Look) {
    if place.width == 0 || place.height == 0 {
        return;
    }
    match (&play.phase, play.step()) {
        (ClassPhase::Shot(shown), _) => match shown.reveal.watch() {
            Some(watch) => watch.picture(place).draw(buf, look),
            None => draw_question(place, buf, look, question, None),
        },
        (ClassPhase::Look, ClassStep::Talk) => {
            spread_view::draw(play, question, place, buf, look);
        }
        (ClassPhase::Vote(entry), _) => {
            let input = entry.input.as_ref().filter(|_| entry.is_open);
            draw_question(place, buf, look, question, input);
        }
        _ => draw_question(place, buf, look, question, None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::class::{ClassPlace, ClassRound};
    use crate::quiz::Code;
    use crate::screens::{Context, Settings};
    use crate::widgets::Charset;

    /// Every step of every question of three rounds has letters that the back row reads, on one
    /// page or two where the text is short.
    #[test]
    fn the_back_row_reads_every_step_of_every_question() {
        let teams: Vec<String> = (1..=8).map(|team| format!("Team {team}")).collect();
        let mut asked = 0;
        let mut faults = Vec::new();
        for code in ["mixed-1", "mixed-2", "concept-1"] {
            for charset in [Charset::Ascii, Charset::Unicode] {
                for (columns, rows) in [(80, 24), (120, 40)] {
                    let code = Code::parse(code).unwrap();
                    let mut round = ClassRound::new(code, teams.clone());
                    for number in 0..round.questions().len() {
                        asked += 1;
                        let truth = round.questions()[number].form.truth();
                        round.vote(number, 0, Vote::First, Some(truth));
                        for step in [
                            ClassStep::Describe,
                            ClassStep::Predict,
                            ClassStep::FirstVote,
                            ClassStep::Talk,
                            ClassStep::SecondVote,
                            ClassStep::Shot,
                        ] {
                            let place = ClassPlace {
                                question: number,
                                step,
                            };
                            round.go(place);
                            let settings = Settings {
                                charset,
                                ..Settings::default()
                            };
                            let mut cx = Context::new(settings, 1);
                            cx.body = Rect::new(0, 1, columns, rows - 2);
                            let play = ClassPlay::new(round.clone(), &mut cx);
                            faults.extend(illegible(&play, &cx, rows));
                        }
                    }
                }
            }
        }
        assert_eq!(asked, 4 * 26);
        assert!(faults.is_empty(), "{}", faults.join("\n"));
    }

    /// What the back row cannot read of a step, or does not see.
    fn illegible(play: &ClassPlay, cx: &Context, rows: u16) -> Vec<String> {
        let question = play.question().unwrap();
        let step = StepView::new(play, cx.room(), &cx.settings.look()).unwrap();
        let mut faults = Vec::new();
        let mut fault = |what: &str| {
            faults.push(format!(
                "{} {} {:?} {rows} {:?}: {what}",
                play.round().code(),
                play.number() + 1,
                play.step(),
                cx.settings.charset
            ));
        };
        for said in &step.said {
            let Some(placed) = &said.placed else {
                fault("plain type");
                continue;
            };
            if !placed.size.is_legible(rows) {
                fault("too small");
            }
            if beside(play, question) != Beside::Nothing && placed.picture(0).is_empty() {
                fault("no picture");
            }
            let letters = { said.paragraphs.iter() }.map(|it| it.text.chars().count());
            let letters: usize = letters.sum();
            let pages = placed.pages();
            if rows == 24 && letters < 200 && pages > 2 {
                fault(&format!("{letters} letters on {pages} pages"));
            }
        }
        faults
    }
}

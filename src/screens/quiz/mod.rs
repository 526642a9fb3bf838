//! The quiz: ten hits to predict, each watched and explained, then a look back.

mod panel;
mod summary;
mod view;

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Context, Help, Hint, Next, Screen};
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::progress::Attempt;
use crate::quiz::{Answer, Confidence, Question, Round, Summary};
use crate::widgets::hit::{Layers, Watch, point_at};
use crate::widgets::{Beside, RayInput, Scroll, Turned};

/// A round of the quiz.
#[derive(Debug, Clone)]
pub struct Quiz {
    round: Round,
    /// What has been answered, in the order of the questions.
    answers: Vec<Answer>,
    phase: Phase,
    /// What the player likes to see drawn on top of a hit.
    layers: Layers,
    scroll: Scroll,
    /// Whether Escape was pressed in the middle of the round, and nothing since.
    leaving: bool,
}

/// What one is doing in a round.
#[derive(Debug, Clone)]
enum Phase {
    /// Saying where both will go.
    Rays(Asked),
    /// Saying how sure one is.
    Confidence(Asked, Confidence),
    /// Watching what happens.
    Watch(Box<Watched>),
    /// Looking back.
    Summary,
}

/// A question, and what has been said to it so far.
#[derive(Debug, Clone)]
struct Asked {
    question: Question,
    rays: RayInput,
}

/// A question, the answer to it and the hit itself.
#[derive(Debug, Clone)]
struct Watched {
    question: Question,
    answer: Answer,
    watch: Watch,
    /// Whether the outcome has been told; it stays so while the hit is seen again.
    told: bool,
}

impl Quiz {
    /// The round of a seed, at its first question.
    pub fn new(seed: u64) -> Self {
        let mut quiz = Self {
            round: Round::new(seed),
            answers: Vec::new(),
            phase: Phase::Summary,
            layers: Layers::default(),
            scroll: Scroll::default(),
            leaving: false,
        };
        quiz.ask();
        quiz
    }

    /// Asks the next question, or looks back after the last.
    fn ask(&mut self) {
        let phase = match self.round.questions().get(self.answers.len()) {
            Some(&question) => Phase::Rays(Asked {
                question,
                rays: RayInput::new(question.side()),
            }),
            None => Phase::Summary,
        };
        self.enter(phase);
    }

    fn enter(&mut self, phase: Phase) {
        self.phase = phase;
        self.scroll = Scroll::default();
    }

    /// Takes the answer and shows the hit.
    fn answer(&mut self, asked: &Asked, confidence: Confidence, cx: &mut Context) {
        let answer = Answer {
            rays: asked.rays.said(),
            confidence,
        };
        self.answers.push(answer);
        let attempt = Attempt::of_quiz(
            &cx.settings.player,
            self.round.seed(),
            self.answers.len() as u32,
            &asked.question,
            &answer,
        );
        // It is safe before the explanation is seen.
        cx.record(attempt);
        let collision = asked.question.collision();
        let watch = Watch::new(collision, Some(answer.rays), cx.settings.reduced_motion)
            .with_layers(self.layers);
        let told = watch.is_told();
        self.enter(Phase::Watch(Box::new(Watched {
            question: asked.question,
            answer,
            watch,
            told,
        })));
    }

    /// Number of the question at hand, from 1.
    fn number(&self) -> usize {
        match self.phase {
            Phase::Rays(_) | Phase::Confidence(..) => self.answers.len() + 1,
            Phase::Watch(_) | Phase::Summary => self.answers.len(),
        }
    }

    /// A look back over the answers whose outcome has been told.
    fn summary(&self) -> Summary {
        let untold = match &self.phase {
            Phase::Watch(watched) => usize::from(!watched.told),
            _ => 0,
        };
        let told = self.answers.len().saturating_sub(untold);
        Summary::new(self.round.questions().iter().zip(&self.answers).take(told))
    }

    fn key(&mut self, key: Key, leaving: bool, cx: &mut Context) -> Next {
        match key {
            Key::PageUp => return self.scroll_by(-8, cx),
            Key::PageDown => return self.scroll_by(8, cx),
            _ => {}
        }
        match &mut self.phase {
            Phase::Rays(asked) => match asked.rays.update(key) {
                Turned::Turning => {}
                Turned::Done => {
                    let asked = asked.clone();
                    self.enter(Phase::Confidence(asked, Confidence::ThinkSo));
                }
                Turned::Ignored if key == Key::Escape => return self.leave(leaving),
                Turned::Ignored => return Next::Ignored,
            },
            Phase::Confidence(..) => return self.confidence_key(key, cx),
            Phase::Watch(_) => return self.watch_key(key, leaving, cx),
            Phase::Summary => match key {
                Key::Up => return self.scroll_by(-1, cx),
                Key::Down => return self.scroll_by(1, cx),
                Key::Enter | Key::Char('n' | 'N') => *self = Self::new(cx.next_seed()),
                Key::Escape => return Next::Back,
                _ => return Next::Ignored,
            },
        }
        Next::Stay
    }

    fn confidence_key(&mut self, key: Key, cx: &mut Context) -> Next {
        let Phase::Confidence(asked, chosen) = &mut self.phase else {
            return Next::Ignored;
        };
        match key {
            Key::Up | Key::Left | Key::BackTab => *chosen = beside(*chosen, -1),
            Key::Down | Key::Right | Key::Tab => *chosen = beside(*chosen, 1),
            Key::Char(digit @ '1'..='3') => {
                let (asked, sure) = (asked.clone(), usize::from(digit as u8 - b'1'));
                self.answer(&asked, Confidence::ALL[sure], cx);
            }
            Key::Enter | Key::Char(' ') => {
                let (asked, chosen) = (asked.clone(), *chosen);
                self.answer(&asked, chosen, cx);
            }
            Key::Escape => {
                let asked = asked.clone();
                self.enter(Phase::Rays(asked));
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn watch_key(&mut self, key: Key, leaving: bool, cx: &Context) -> Next {
        let Phase::Watch(watched) = &mut self.phase else {
            return Next::Ignored;
        };
        let key = match key {
            Key::Char(' ') if watched.watch.clock().is_over() => Key::Char('a'),
            key => key,
        };
        if watched.watch.update(key) {
            watched.look();
            return Next::Stay;
        }
        match key {
            // Nobody skips what happened by a key too many.
            Key::Enter if !watched.told => {
                watched.watch.tell();
                watched.look();
            }
            Key::Enter => {
                self.layers = watched.watch.layers();
                self.ask();
            }
            Key::Up => return self.scroll_by(-1, cx),
            Key::Down => return self.scroll_by(1, cx),
            Key::Escape => return self.leave(leaving),
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    /// Leaves the round: at once while nothing has been answered, else when asked
    /// twice.
    fn leave(&mut self, asked_before: bool) -> Next {
        if asked_before || self.answers.is_empty() {
            return Next::Back;
        }
        self.leaving = true;
        Next::Stay
    }

    fn scroll_by(&mut self, rows: i16, cx: &Context) -> Next {
        let look = cx.settings.look();
        let area = view::text_area(self, cx.body);
        let mut scroll = self.scroll;
        scroll.by(rows, area, look, |lines| view::write(self, lines, look));
        self.scroll = scroll;
        Next::Stay
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let layout = Beside::new(cx.body);
        let cell = (mouse.column, mouse.row);
        let on_picture =
            layout.picture.contains(cell.into()) && !matches!(self.phase, Phase::Summary);
        let pressed = mouse.kind == MouseKind::Down;
        match (mouse.kind, &mut self.phase) {
            (MouseKind::ScrollUp | MouseKind::ScrollDown, Phase::Watch(watched)) if on_picture => {
                let later = mouse.kind == MouseKind::ScrollUp;
                let key = Key::Char(if later { '.' } else { ',' });
                watched.watch.update(key);
                watched.look();
            }
            (MouseKind::ScrollUp, _) => return self.scroll_by(-1, cx),
            (MouseKind::ScrollDown, _) => return self.scroll_by(1, cx),
            (MouseKind::Down | MouseKind::Drag, Phase::Rays(asked)) if on_picture => {
                let collision = asked.question.collision();
                point_at(layout.picture, &collision, &mut asked.rays, cell, pressed);
            }
            (MouseKind::Down, Phase::Confidence(asked, _)) => {
                let Some(chosen) = panel::confidence_at(layout.panel, cell) else {
                    return Next::Ignored;
                };
                let asked = asked.clone();
                self.answer(&asked, chosen, cx);
            }
            (MouseKind::Down, Phase::Watch(_)) if on_picture => {
                return self.watch_key(Key::Char(' '), false, cx);
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }
}

impl Watched {
    /// Notes whether the outcome may be told by now.
    fn look(&mut self) {
        self.told |= self.watch.is_told();
    }
}

/// The confidence so many steps above, no further than to the ends.
fn beside(confidence: Confidence, steps: isize) -> Confidence {
    let last = Confidence::ALL.len() - 1;
    let index = (confidence as usize).saturating_add_signed(steps).min(last);
    Confidence::ALL[index]
}

impl Screen for Quiz {
    fn title(&self) -> String {
        "quiz".into()
    }

    fn status(&self, _cx: &Context) -> String {
        let place = match self.phase {
            Phase::Summary => "all answered".into(),
            _ => format!(
                "question {} of {}",
                self.number(),
                self.round.questions().len()
            ),
        };
        let points = self.summary().points();
        format!("{place}  {points:.1} points  code {}", self.round.seed())
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        if let Input::Kept(_) = input {
            return Next::Stay;
        }
        let leaving = std::mem::take(&mut self.leaving);
        match input {
            Input::Key(key) => self.key(*key, leaving, cx),
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, passed: Duration, _cx: &mut Context) -> Next {
        if let Phase::Watch(watched) = &mut self.phase {
            watched.watch.advance(passed);
            watched.look();
        }
        Next::Stay
    }

    fn wake(&self, _cx: &Context) -> Option<Duration> {
        match &self.phase {
            Phase::Watch(watched) => watched.watch.wake(),
            _ => None,
        }
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }

    fn keys(&self, _cx: &Context) -> Vec<Hint> {
        match &self.phase {
            _ if self.leaving => vec![
                Hint::new("Esc", "leave the round"),
                Hint::new("any other key", "stay"),
            ],
            Phase::Rays(_) => vec![
                Hint::new("arrows", "turn"),
                Hint::new("0-9", "type"),
                Hint::new("x", "stays still"),
                Hint::new("Enter", "next"),
                Hint::new("Tab", "other ray"),
                Hint::new("Esc", "leave"),
            ],
            Phase::Confidence(..) => vec![
                Hint::new("1 2 3", "how sure"),
                Hint::new("Up Down", "choose"),
                Hint::new("Enter", "watch"),
                Hint::new("Esc", "back to the rays"),
            ],
            Phase::Watch(watched) if !watched.told => vec![
                Hint::new("Enter", "show it"),
                Hint::new("Space", "go on"),
                Hint::new(", .", "step"),
                Hint::new("< >", "scrub"),
                Hint::new("1-7", "layers"),
            ],
            Phase::Watch(watched) => {
                let next = if self.number() < self.round.questions().len() {
                    "next question"
                } else {
                    "look back"
                };
                let space = if watched.watch.clock().is_over() {
                    "again"
                } else {
                    "go on"
                };
                vec![
                    Hint::new("Enter", next),
                    Hint::new("Space", space),
                    Hint::new(", .", "step"),
                    Hint::new("< >", "scrub"),
                    Hint::new("1-7", "layers"),
                    Hint::new("f", "frame"),
                ]
            }
            Phase::Summary => vec![
                Hint::new("Enter", "new round"),
                Hint::new("Up Down", "scroll"),
                Hint::new("Esc", "back"),
            ],
        }
    }

    fn help(&self, _cx: &Context) -> Help {
        Help {
            text: vec![
                "Ten hits. For each, say where the striker and the coin will go, and how sure you are; then watch what happens and read why.",
                "Angles count from the striker's direction before: for the striker to the side away from the coin, for the coin to its own side. A minus turns to the other side.",
                "A ray within 2° earns all its credit, one that is 30° off none. \"Sure\" brings most points if you are right and costs most if you are not, so the honest answer is the one that pays.",
                "The code at the top fixes the ten questions: with the same code a friend gets the same round.",
            ],
            keys: vec![
                Hint::new("Left Right", "turn a ray by 1°"),
                Hint::new("Up Down", "turn a ray by 5°, choose, or scroll"),
                Hint::new("0-9 . -", "type an angle"),
                Hint::new("x", "this disc will stay still"),
                Hint::new("Tab", "the other ray"),
                Hint::new("Enter", "go on"),
                Hint::new("1 2 3", "guess, think so, sure"),
                Hint::new("Space", "go on from the contact, or play it again"),
                Hint::new(", .", "step through the hit"),
                Hint::new("< >", "bigger steps; Home and End for the ends"),
                Hint::new("a", "play it again"),
                Hint::new("f", "see it from the centre of mass"),
                Hint::new(
                    "1-7",
                    "layers: line of impact, split, velocities, angles, triangle, trails, what you said",
                ),
                Hint::new(
                    "PageUp PageDown",
                    "scroll a text that is longer than its place",
                ),
                Hint::new("mouse", "drag the rays, click how sure you are"),
            ],
        }
    }
}

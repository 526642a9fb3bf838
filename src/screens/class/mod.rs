//! A round for a class round one screen: one keyboard, a projector, teams.
//!
//! A question goes through the [`ClassStep`]s of [`crate::class`]; `play` knows the way
//! through them, and every step has a view of its own.

mod booth;
mod earlier;
mod earlier_view;
mod ending_view;
mod heading;
mod play;
mod question_view;
mod scores_view;
mod set_up;
mod set_up_view;
mod shown;
mod shown_view;
mod spread_view;
mod view;
mod vote_view;

use std::sync::Arc;
use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Context, Help, Hint, Next, OldScreen};
use crate::class::ClassStep;
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::quiz::Code;
use crate::widgets::{AnswerInput, Palette};
use earlier::Earlier;
use play::{Page, Phase, Play};
use set_up::{Row, SetUp};

/// A round for a class round one screen.
#[derive(Debug, Clone)]
pub(crate) struct Class {
    scene: Scene,
    /// Whether the screen is blank until someone goes on.
    paused: bool,
    /// Whether Escape was pressed in the middle of a round, and nothing since.
    leaving: bool,
}

/// What is on the screen.
#[derive(Debug, Clone)]
enum Scene {
    SetUp(SetUp),
    Earlier(Earlier),
    Play(Box<Play>),
}

impl Class {
    /// The page on which a round is set up, with what is known of it already.
    pub(crate) fn new(code: Option<&Code>, teams: Vec<String>, cx: &Context) -> Self {
        Self {
            scene: Scene::SetUp(SetUp::new(code, teams, Arc::clone(&cx.own))),
            paused: false,
            leaving: false,
        }
    }

    fn key(&mut self, key: Key, leaving: bool, cx: &mut Context) -> Next {
        if self.paused {
            // Not any key: someone may lean on the table.
            if matches!(key, Key::Char('p' | 'P')) {
                self.paused = false;
            }
            return Next::Stay;
        }
        match &mut self.scene {
            Scene::SetUp(set_up) => {
                let step = set_up.key(key, cx);
                self.set_up_step(step, cx)
            }
            Scene::Earlier(earlier) => {
                let step = earlier.key(key, cx);
                self.earlier_step(step)
            }
            Scene::Play(_) => self.play_key(key, leaving, cx),
        }
    }

    fn set_up_step(&mut self, step: set_up::Step, cx: &mut Context) -> Next {
        match step {
            set_up::Step::Stay => {}
            set_up::Step::Ignored => return Next::Ignored,
            set_up::Step::Back => return Next::Back,
            set_up::Step::Start(play) => self.scene = Scene::Play(play),
            set_up::Step::Earlier => {
                if let Scene::SetUp(set_up) = &self.scene {
                    self.scene = Scene::Earlier(Earlier::ask(set_up.clone(), cx));
                }
            }
        }
        Next::Stay
    }

    fn earlier_step(&mut self, step: earlier::Step) -> Next {
        match step {
            earlier::Step::Stay => {}
            earlier::Step::Ignored => return Next::Ignored,
            earlier::Step::Back(set_up) => self.scene = Scene::SetUp(*set_up),
            earlier::Step::TakeUp(play) => self.scene = Scene::Play(play),
        }
        Next::Stay
    }

    fn play_key(&mut self, key: Key, leaving: bool, cx: &mut Context) -> Next {
        match key {
            Key::PageUp => return self.scroll(-8, cx),
            Key::PageDown => return self.scroll(8, cx),
            _ => {}
        }
        let Scene::Play(play) = &mut self.scene else {
            return Next::Ignored;
        };
        if play.key(key, cx) {
            return Next::Stay;
        }
        match key {
            Key::Char('p' | 'P') => self.paused = true,
            Key::Char('l' | 'L') => {
                cx.settings.palette = match cx.settings.palette {
                    Palette::Light => Palette::Dark,
                    Palette::Dark | Palette::Mono => Palette::Light,
                };
            }
            Key::Up => return self.scroll(-1, cx),
            Key::Down => return self.scroll(1, cx),
            Key::Escape if leaving || !play.asks_before_leaving() => return Next::Back,
            Key::Escape => self.leaving = true,
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn scroll(&mut self, rows: i16, cx: &Context) -> Next {
        if let Scene::Play(play) = &mut self.scene {
            view::scroll(play, rows, cx.body, &cx.settings.look());
        }
        Next::Stay
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let cell = (mouse.column, mouse.row);
        let pressed = mouse.kind == MouseKind::Down;
        match (mouse.kind, &mut self.scene) {
            _ if self.paused => {}
            (MouseKind::ScrollUp, Scene::Play(_)) => return self.scroll(-1, cx),
            (MouseKind::ScrollDown, Scene::Play(_)) => return self.scroll(1, cx),
            (MouseKind::Down, Scene::SetUp(set_up)) => {
                let Some(row) = set_up_view::row_at(set_up, cx.body, cell) else {
                    return Next::Ignored;
                };
                let step = set_up.click(row, cx);
                return self.set_up_step(step, cx);
            }
            (MouseKind::Down | MouseKind::Drag, Scene::Play(play)) => {
                let question = play.question().cloned();
                let look = cx.settings.look();
                let Play { phase, round, .. } = play.as_mut();
                match (phase, question) {
                    (Phase::Vote(booths), Some(question)) => match &mut booths.input {
                        Some(input) => {
                            let layout = vote_view::booth_layout(&question, cx.body);
                            input.point(&question, layout.picture, cell, pressed);
                        }
                        None if pressed => {
                            match vote_view::row_at(round, booths.vote, cx.body, &look, cell) {
                                Some(team) if team < round.teams().len() => {
                                    booths.open(team, round);
                                }
                                Some(_) => play.forward(cx),
                                None => return Next::Ignored,
                            }
                        }
                        None => {}
                    },
                    _ => return Next::Ignored,
                }
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }
}

impl OldScreen for Class {
    fn title(&self) -> String {
        "class".into()
    }

    fn status(&self, _cx: &Context) -> String {
        match &self.scene {
            Scene::Play(play) if !self.paused => format!(
                "question {} of {}  code {}",
                play.number() + 1,
                play.round.questions().len(),
                play.round.code()
            ),
            _ => String::new(),
        }
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        if let Input::Kept(answer) = input {
            match &mut self.scene {
                Scene::SetUp(_) => {}
                Scene::Earlier(earlier) => {
                    let step = earlier.take_answer(answer, cx);
                    return self.earlier_step(step);
                }
                Scene::Play(play) => play.take_answer(answer, cx),
            }
            return Next::Stay;
        }
        let leaving = std::mem::take(&mut self.leaving);
        match input {
            Input::Key(key) => self.key(*key, leaving, cx),
            Input::Mouse(mouse) => self.mouse(mouse, cx),
            Input::Paste(text) => {
                if let Scene::SetUp(set_up) = &mut self.scene {
                    set_up.paste(text);
                }
                Next::Stay
            }
            _ => Next::Ignored,
        }
    }

    fn advance(&mut self, passed: Duration, _cx: &mut Context) -> Next {
        if let Scene::Play(play) = &mut self.scene {
            play.advance(passed);
        }
        Next::Stay
    }

    fn wake(&self, _cx: &Context) -> Option<Duration> {
        match &self.scene {
            Scene::Play(play) if !self.paused => play.wake(),
            _ => None,
        }
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        match &self.scene {
            _ if self.paused => view::paused(area, buf, &look),
            Scene::SetUp(set_up) => set_up_view::draw(set_up, area, buf, &look),
            Scene::Earlier(earlier) => earlier_view::draw(earlier, area, buf, &look),
            Scene::Play(play) => view::draw(play, self.leaving, area, buf, &look),
        }
    }

    fn keys(&self, _cx: &Context) -> Vec<Hint> {
        match &self.scene {
            _ if self.paused => vec![Hint::new("p", "go on")],
            Scene::SetUp(set_up) => set_up_keys(set_up),
            Scene::Earlier(earlier) if earlier.removing => vec![
                Hint::new("y", "remove it"),
                Hint::new("any other key", "keep it"),
            ],
            Scene::Earlier(_) => vec![
                Hint::new("Enter", "take it up"),
                Hint::new("Up Down", "choose"),
                Hint::new("d", "remove"),
                Hint::new("Esc", "back"),
            ],
            Scene::Play(play) if self.leaving && play.unsaved => vec![
                Hint::new("Esc", "leave the round; it is lost"),
                Hint::new("e", "write its tables"),
                Hint::new("any other key", "stay"),
            ],
            Scene::Play(_) if self.leaving => vec![
                Hint::new("Esc", "leave the round; it is kept"),
                Hint::new("any other key", "stay"),
            ],
            Scene::Play(play) => play_keys(play),
        }
    }

    fn help(&self, _cx: &Context) -> Help {
        Help {
            text: vec![
                "One laptop, one projector, up to eight teams. Each question goes the same way: it is read out; everyone predicts in silence; the teams enter their first vote; all see how the votes are spread, and talk; the teams may change; then the shot, and why; then the scores.",
                "Let every team write its answer down while it is silent: then nobody copies what is typed first.",
                "Rims are smooth unless a question says otherwise. Points come from how near the last vote is, up to ten a question. There are no timers, and nobody is faster than anybody.",
                "Everything is saved after each vote. Leave when the bell rings, and take the round up again another day.",
            ],
            keys: vec![
                Hint::new("Enter", "go on"),
                Hint::new("Backspace", "the step before"),
                Hint::new(
                    "[ ]",
                    "the question before, the next one, where it was left",
                ),
                Hint::new("p", "pause: a blank screen until p again"),
                Hint::new("l", "dark on light for a projector, or light on dark"),
                Hint::new("z", "the question's words alone, as large as they fit"),
                Hint::new("1-8", "let this team enter or correct its vote"),
                Hint::new("x", "take a team's vote back"),
                Hint::new(
                    "e",
                    "write two tables for a spreadsheet: answers and questions",
                ),
                Hint::new("Space , . < > a f", "watch the hit, as in the lab"),
                Hint::new("Up Down", "choose, or scroll"),
                Hint::new("Esc", "leave; the round is kept where it can be saved"),
            ],
        }
    }
}

fn set_up_keys(set_up: &SetUp) -> Vec<Hint> {
    let mut keys = match set_up.at {
        Row::Team(_) | Row::Add => vec![
            Hint::new("letters", "a team's name"),
            Hint::new("Enter", "next"),
            Hint::new("Delete", "remove it"),
        ],
        Row::Kind(set_up::Kind::Topic) => vec![
            Hint::new("Left Right", "another topic"),
            Hint::new("Enter", "choose it"),
        ],
        Row::Kind(set_up::Kind::Code) => vec![
            Hint::new("letters", "the code"),
            Hint::new("Enter", "choose it"),
        ],
        Row::Kind(_) => vec![Hint::new("Enter", "choose it")],
        Row::Start => vec![Hint::new("Enter", "start")],
        Row::Earlier => vec![Hint::new("Enter", "open the list")],
    };
    keys.extend([
        Hint::new("Up Down", "other rows"),
        Hint::new("F3", "dark or light"),
        Hint::new("Esc", "back"),
    ]);
    keys
}

fn play_keys(play: &Play) -> Vec<Hint> {
    let tail = [
        Hint::new("Backspace", "back"),
        Hint::new("p", "pause"),
        Hint::new("l", "dark or light"),
        Hint::new("[ ]", "questions"),
        Hint::new("Esc", "leave"),
    ];
    let mut keys = match (&play.phase, play.step()) {
        (Phase::Vote(booths), _) => match &booths.input {
            Some(input) => return input_keys(input),
            None => vec![
                Hint::new("Enter", "give a vote"),
                Hint::new("1-8", "a team"),
                Hint::new("x", "take back"),
            ],
        },
        (Phase::Shot(shown), _) if !shown.telling.is_told() => vec![
            Hint::new("Enter", "show it"),
            Hint::new("Space", "go on"),
            Hint::new(", .", "step"),
        ],
        (Phase::Shot(shown), _) => {
            let mut keys = vec![Hint::new("Enter", "the scores")];
            if let Some(watch) = shown.telling.watch() {
                let space = if watch.clock().is_over() {
                    "again"
                } else {
                    "go on"
                };
                keys.push(Hint::new("Space", space));
                keys.push(Hint::new("f", "frame"));
            }
            keys
        }
        (Phase::End(page), _) => {
            let mut keys = Vec::new();
            if *page != Page::Items {
                keys.push(Hint::new("Enter", "next page"));
            }
            keys.extend([Hint::new("e", "tables"), Hint::new("Up Down", "scroll")]);
            keys
        }
        (_, ClassStep::Describe) => {
            vec![Hint::new("Enter", "predict"), Hint::new("z", "words alone")]
        }
        (_, ClassStep::Predict) => vec![
            Hint::new("Enter", "first vote"),
            Hint::new("z", "words alone"),
        ],
        (_, ClassStep::Talk) => vec![Hint::new("Enter", "second vote")],
        (_, ClassStep::Scores) if play.number() + 1 < play.round.questions().len() => {
            vec![Hint::new("Enter", "next question")]
        }
        (_, ClassStep::Scores) => vec![Hint::new("Enter", "the end")],
        _ => vec![Hint::new("Enter", "go on")],
    };
    keys.extend(tail);
    keys
}

fn input_keys(input: &AnswerInput) -> Vec<Hint> {
    let mut keys = match input {
        AnswerInput::Rays(_) => vec![
            Hint::new("0-9", "type"),
            Hint::new("arrows", "turn"),
            Hint::new("x", "stays still"),
            Hint::new("Tab", "other ray"),
        ],
        AnswerInput::Number(_) | AnswerInput::Shot(_) => {
            vec![Hint::new("0-9", "type"), Hint::new("arrows", "dial")]
        }
        AnswerInput::Choice { .. } => {
            vec![
                Hint::new("a b c", "choose"),
                Hint::new("Up Down", "likewise"),
            ]
        }
    };
    keys.extend([
        Hint::new("Enter", "vote"),
        Hint::new("Esc", "not yet"),
        Hint::new("p", "pause"),
    ]);
    keys
}

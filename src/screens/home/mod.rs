//! The first screen: where to go.

mod view;

use glam::DVec2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Context, Help, Hint, Next, OldScreen, Place};
use crate::messages::{Input, Key, MouseKind};
use crate::physics::{Collision, Disc};
use crate::widgets::hit::{Overlay, Overlays, Watch};

/// The first screen.
#[derive(Debug, Clone)]
pub struct Home {
    chosen: usize,
    picture: Watch,
}

impl Default for Home {
    /// The first choice, beside a hit at its contact.
    fn default() -> Self {
        let mut layers = Overlays::default();
        layers.toggle(Overlay::Triangle);
        Self {
            chosen: 0,
            picture: Watch::new(worked_shot(), None, true).with_layers(layers),
        }
    }
}

/// 15 g on 15 g at 4 m/s and 30°: the shot that everything here is explained on.
fn worked_shot() -> Collision {
    let disc = Disc::from_g_mm(15.0, 15.0);
    Collision::at_angle(disc, disc, DVec2::new(4.0, 0.0), 30_f64.to_radians())
}

/// A line of the menu.
struct Choice {
    key: char,
    name: &'static str,
    about: &'static str,
    place: Place,
}

const CHOICES: [Choice; 8] = [
    Choice {
        key: 'e',
        name: "Learn",
        about: "chapters, read by doing",
        place: Place::Learn,
    },
    Choice {
        key: 'l',
        name: "Lab",
        about: "one hit: set it, say, watch",
        place: Place::Lab,
    },
    Choice {
        key: 'z',
        name: "Quiz",
        about: "find out what you know",
        place: Place::Quiz { code: None },
    },
    Choice {
        key: 'c',
        name: "Class",
        about: "teams, one screen, two votes",
        place: Place::Class {
            code: None,
            teams: Vec::new(),
        },
    },
    Choice {
        key: 't',
        name: "Table",
        about: "carrom, every hit explained",
        place: Place::Table,
    },
    Choice {
        key: 'v',
        name: "Levels",
        about: "puzzles, solved by aiming",
        place: Place::Levels,
    },
    Choice {
        key: 'f',
        name: "Foil",
        about: "beams: from board to atom",
        place: Place::Foil,
    },
    Choice {
        key: 'p',
        name: "Progress",
        about: "how far you have come",
        place: Place::Progress,
    },
];

impl OldScreen for Home {
    fn title(&self) -> String {
        "home".into()
    }

    fn update(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Key(Key::Up) => {
                self.chosen = (self.chosen + CHOICES.len() - 1) % CHOICES.len();
            }
            Input::Key(Key::Down | Key::Tab) => self.chosen = (self.chosen + 1) % CHOICES.len(),
            Input::Key(Key::Enter | Key::Char(' ')) => {
                return Next::Open(CHOICES[self.chosen].place.clone());
            }
            Input::Key(Key::Char('q')) => return Next::Quit,
            // Nothing lies behind the first screen; leaving it takes a plain Q.
            Input::Key(Key::Escape) => {}
            Input::Key(Key::Char(c)) => {
                // What the class had before its own letter was free.
                let c = if *c == 'g' { 'c' } else { *c };
                let Some(i) = CHOICES.iter().position(|choice| choice.key == c) else {
                    return Next::Ignored;
                };
                self.chosen = i;
                return Next::Open(CHOICES[i].place.clone());
            }
            Input::Mouse(mouse) if mouse.kind == MouseKind::Down => {
                if let Some(i) = view::choice_at(cx.body, mouse.column, mouse.row) {
                    self.chosen = i;
                    return Next::Open(CHOICES[i].place.clone());
                }
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        view::draw(self, area, buf, cx);
    }

    fn keys(&self, _cx: &Context) -> Vec<Hint> {
        vec![
            Hint::new("Up Down", "choose"),
            Hint::new("Enter", "open"),
            Hint::new("q", "quit"),
        ]
    }

    fn help(&self, _cx: &Context) -> Help {
        Help {
            text: vec![
                "carrom teaches one thing well: what happens when one disc hits another off-centre.",
                "Everywhere in it you first say what will happen, then watch the exact hit, then read why. A wrong prediction is the best start there is.",
                "New here? Open the lab and press Enter: a hit in a minute. Then read the first chapter of Learn.",
            ],
            keys: self.keys(_cx),
        }
    }
}

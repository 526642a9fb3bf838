//! A pupil's device in a class: coming in, voting, and hearing what is true.

mod desk;
mod door;
mod link;
mod view;

#[cfg(not(target_family = "wasm"))]
pub(crate) use door::{code_of, host_of};

use std::time::Duration;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use strum::{EnumMessage, IntoStaticStr};

use super::{Confirmation, Context, Next, Screen, Settings};
use crate::class::DoorCode;
use crate::messages::{Input, Key, Mouse, MouseKind};
use crate::quiz::Confidence;
use crate::widgets::hit::WatchAction;
use crate::widgets::input::{KeyTable, ListAction, ListView};
use crate::widgets::{AnswerAction, Lines, Scroll, SplitLayout, scroll_keys};
use desk::{Desk, Doing};
use door::DoorForm;
use link::{Link, LinkNews};

/// What keys do on a pupil's device.
#[derive(Debug, Clone, Copy, PartialEq, IntoStaticStr, EnumMessage)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum JoinAction {
    /// choose what to type, or come in
    Form(ListAction),
    /// make the vote
    Answer(AnswerAction),
    /// guess, think so, sure
    Sure(usize),
    /// choose how sure you are
    MoreSure(isize),
    /// vote, as sure as chosen
    Take,
    /// take the vote back
    TakeBack,
    /// watch the hit
    Watch(WatchAction),
    /// scroll a text that is longer than its place
    Scroll(i16),
    /// back to the answer, or leave the class
    Leave,
}

/// A pupil's device in a class.
#[derive(Debug, Clone)]
pub(crate) struct Join {
    form: DoorForm,
    link: Option<Link>,
    desk: Option<Desk>,
    scroll: Scroll,
}

impl Join {
    /// Before coming in, with what is known. Without an address the page came from there.
    /// Whoever comes `again` is not asked once more.
    pub(crate) fn new(
        address: Option<&str>,
        code: Option<DoorCode>,
        again: bool,
        cx: &mut Context,
    ) -> Self {
        let player = &cx.settings.player;
        let name = match *player == Settings::default().player {
            true => "",
            false => player,
        };
        let mut join = Self {
            form: DoorForm::new(address, code, name),
            link: None,
            desk: None,
            scroll: Scroll::default(),
        };
        if again {
            let entry = join.form.entry();
            join.knock(entry, cx);
        }
        join
    }

    /// The desk, once one is in.
    fn desk(&self) -> Option<(&Desk, &Link)> {
        self.desk.as_ref().zip(self.link.as_ref())
    }

    fn layout(&self, area: Rect) -> SplitLayout {
        view::layout(self.desk.as_ref(), area)
    }

    fn write(&self, lines: &mut Lines) {
        match self.desk() {
            Some((desk, link)) => view::write(desk, link, lines),
            None if self.link.is_some() => lines.paragraph("Knocking at the door ..", Role::Text),
            None => self.form.write(lines),
        }
    }

    fn knock(&mut self, entry: Option<door::Entry>, cx: &mut Context) {
        if let Some(it) = entry {
            self.link = Some(Link::dial(&it.address, &it.code, &it.name, cx));
        }
    }

    fn scroll_by(&mut self, rows: i16, cx: &Context) {
        let panel = self.layout(cx.body).panel;
        let look = cx.settings.look();
        self.scroll = self.scroll.by(rows, panel, look, |lines| self.write(lines));
    }

    /// Leaves the class.
    fn hang_up(&mut self, cx: &mut Context) {
        if let Some(link) = &mut self.link {
            link.hang_up(cx);
        }
        self.link = None;
        self.desk = None;
    }

    fn vote(&mut self, sure: Confidence, cx: &mut Context) {
        if let (Some(desk), Some(link)) = (&mut self.desk, &mut self.link) {
            desk.vote(sure, link, cx);
        }
    }
}

use crate::widgets::Role;

impl Screen for Join {
    type Action = JoinAction;

    fn title(&self) -> String {
        "class".into()
    }

    fn status(&self, _cx: &Context) -> String {
        match &self.desk {
            Some(desk) => format!(
                "{}  question {} of {}",
                desk.state.name,
                desk.state.q + 1,
                desk.state.of
            ),
            None => String::new(),
        }
    }

    fn keys(&self, _cx: &Context) -> KeyTable<JoinAction> {
        use JoinAction::{Answer, Form, Leave, MoreSure, Scroll, Sure, Take, TakeBack, Watch};
        let keys = KeyTable::new("join");
        let pages = scroll_keys(Scroll);
        let lines = [(Key::Up, Scroll(-1)), (Key::Down, Scroll(1))];
        let Some((desk, _)) = self.desk() else {
            return match &self.link {
                None => keys.with(self.form.keys(), Form),
                Some(_) => keys,
            }
            .on(Key::Escape, Leave, "back");
        };
        match &desk.doing {
            Doing::Look => keys
                .on(Key::Escape, Leave, "leave")
                .each(lines, "")
                .or(pages),
            Doing::Answer(input) => {
                let input = input.keys();
                let free = input.exact(Key::Escape).is_none();
                keys.with(input, Answer)
                    .on(Key::Delete, TakeBack, "take it back")
                    .when(desk.has_voted())
                    .on(Key::Escape, Leave, "leave")
                    .when(free)
                    .each(pages, "")
            }
            Doing::Sure(..) => {
                let sure = ('1'..).zip((0..Confidence::ALL.len()).map(Sure));
                keys.each(sure, "how sure")
                    .by([Key::Up, Key::Down], MoreSure, [-1, 1], "choose")
                    .on(Key::Enter, Take, "vote")
                    .or([(Key::Char(' '), Take)])
                    .on(Key::Escape, Leave, "change it")
                    .each(pages, "")
            }
            Doing::Watch(reveal) => keys
                .with(reveal.keys(), Watch)
                .on(Key::Escape, Leave, "leave")
                .each(lines, "")
                .or(pages),
        }
    }

    fn about(&self, _cx: &Context) -> Vec<&'static str> {
        vec![
            "Your class plays a round, and you vote here, alone. The address and the code are on the board. What you vote is kept on the teacher's computer; only how many voted for what is shown to all.",
            "Vote in silence first, then talk, then vote again if you think otherwise now. The last vote counts, by how near it is; nobody is faster than anybody.",
            "Should the connection be lost, carrom comes back by itself, and your votes are still there.",
        ]
    }

    fn typed(&mut self, key: Key, _cx: &mut Context) -> bool {
        self.link.is_none() && self.form.typed(key)
    }

    fn act(&mut self, action: JoinAction, cx: &mut Context) -> Next {
        match (action, &mut self.desk) {
            (JoinAction::Form(action), _) => {
                let entry = self.form.act(action);
                self.knock(entry, cx);
            }
            (JoinAction::Answer(action), Some(desk)) => drop(desk.answer(action)),
            (JoinAction::Sure(at), _) => self.vote(Confidence::ALL[at], cx),
            (JoinAction::MoreSure(by), Some(desk)) => {
                if let Doing::Sure(_, sure) = &mut desk.doing {
                    let at = (*sure as usize).saturating_add_signed(by);
                    *sure = Confidence::ALL[at.min(Confidence::ALL.len() - 1)];
                }
            }
            (JoinAction::Take, Some(desk)) => {
                if let Doing::Sure(_, sure) = desk.doing {
                    self.vote(sure, cx);
                }
            }
            (JoinAction::TakeBack, Some(desk)) => {
                if let Some(link) = &mut self.link {
                    desk.take_back(link, cx);
                }
            }
            (JoinAction::Watch(action), Some(desk)) => {
                if let Doing::Watch(reveal) = &mut desk.doing {
                    reveal.act(action);
                }
            }
            (JoinAction::Scroll(rows), _) => self.scroll_by(rows, cx),
            (JoinAction::Leave, Some(desk)) => {
                if let Doing::Sure(input, _) = &desk.doing {
                    desk.doing = Doing::Answer(input.clone());
                    return Next::Stay;
                }
                return Next::Confirm(Confirmation::new(
                    "Leave the class? With the same name here you can come back to your place.",
                    "leave the class",
                    "stay",
                ));
            }
            (JoinAction::Leave, None) if self.link.is_some() => self.hang_up(cx),
            (JoinAction::Leave, None) => return Next::Back,
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn confirmed(&mut self, _action: JoinAction, cx: &mut Context) -> Next {
        self.hang_up(cx);
        Next::Back
    }

    fn input(&mut self, input: &Input, cx: &mut Context) -> Next {
        match input {
            Input::Mouse(mouse) => return self.mouse(mouse, cx),
            Input::Paste(text) if self.link.is_none() => self.form.paste(text),
            Input::Joined(news) => {
                let pace = cx.settings.pace();
                let came = self.link.as_mut().map(|link| link.take(news, cx));
                match came {
                    Some(LinkNews::State(state)) => match &mut self.desk {
                        Some(desk) => {
                            let before = (desk.state.q, desk.state.step);
                            desk.take(*state, pace);
                            if (desk.state.q, desk.state.step) != before {
                                self.scroll = Scroll::default();
                            }
                        }
                        None => self.desk = Some(Desk::new(*state, pace)),
                    },
                    Some(LinkNews::Refused(why)) => {
                        self.link = None;
                        self.desk = None;
                        self.form.trouble = Some(why.words().into());
                    }
                    Some(LinkNews::Nothing) | None => {}
                }
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn mouse(&mut self, mouse: &Mouse, cx: &mut Context) -> Next {
        let layout = self.layout(cx.body);
        let (cell, look) = (mouse.cell(), cx.settings.look());
        let pressed = mouse.kind == MouseKind::Down;
        if let Some(by) = mouse.wheel() {
            self.scroll_by(-i16::from(by), cx);
            return Next::Stay;
        }
        if self.link.is_none() {
            let row = ListView::row_at(layout.panel, cell).filter(|_| pressed);
            let entry = row.and_then(|row| self.form.point(row));
            self.knock(entry, cx);
            return Next::after(row.is_some());
        }
        let on_picture = layout.picture.contains(cell.into());
        let choice = self.desk().and_then(|(desk, link)| {
            view::choice_at(desk, link, &self.scroll, layout.panel, cell, look)
        });
        let Some(desk) = &mut self.desk else {
            return Next::Ignored;
        };
        match &mut desk.doing {
            Doing::Answer(input) if on_picture && mouse.is_held() => {
                let question = desk.question.as_ref();
                let used = question.is_some_and(|question| {
                    input.point(question, layout.picture, mouse.place(), pressed)
                });
                return Next::after(used);
            }
            Doing::Answer(_) if pressed => {
                if let Some(choice) = choice {
                    desk.answer(AnswerAction::Choose(choice));
                    desk.answer(AnswerAction::Enter);
                }
            }
            Doing::Sure(..) if pressed => {
                if let Some(sure) = view::confidence_at(layout.panel, cell) {
                    self.vote(sure, cx);
                }
            }
            Doing::Watch(reveal) if pressed && on_picture => {
                if let Some(action) = reveal.keys().find(Key::Char(' ')) {
                    reveal.act(action);
                }
            }
            _ => return Next::Ignored,
        }
        Next::Stay
    }

    fn advance(&mut self, passed: Duration, cx: &mut Context) {
        if let Some(link) = &mut self.link {
            link.advance(passed, cx);
        }
        if let Some(desk) = &mut self.desk {
            desk.advance(passed, cx.settings.pace());
        }
    }

    fn wake(&self, cx: &Context) -> Option<Duration> {
        let link = self.link.as_ref().and_then(Link::wake);
        let desk = self.desk.as_ref();
        let desk = desk.and_then(|desk| desk.wake(cx.settings.pace()));
        link.into_iter().chain(desk).min()
    }

    fn draw(&self, area: Rect, buf: &mut Buffer, cx: &Context) {
        let look = cx.settings.look();
        if let Some((desk, link)) = self.desk() {
            return view::draw(desk, link, &self.scroll, area, buf, &look);
        }
        let layout = self.layout(area);
        layout.draw(buf, &look, "your class", "your class");
        self.scroll
            .draw(layout.panel, buf, look, |lines| self.write(lines));
    }
}

//! What pupils on devices hand in: read as what may come from anybody, and kept before they
//! are told so.

use std::collections::BTreeMap;

use serde_json::Value;

use super::{Hosting, Scene};
use crate::class::ClassRound;
use crate::class::protocol::{HandedIn, NotTaken};
use crate::gradebook::HandIn;
use crate::messages::{LineId, StoreRequest};
use crate::screens::Context;

/// How often somebody may hand in while the door is open.
const MOST: usize = 20;
/// Most bytes that all may hand in while it is open.
const MOST_BYTES: usize = 1 << 26;

/// What is being handed in, and what was.
#[derive(Debug, Clone, Default)]
pub(super) struct HandingIn {
    /// What is on its way to the disk, by its ticket.
    under_way: BTreeMap<u64, UnderWay>,
    /// How many bytes all have handed in.
    bytes: usize,
    folder: Option<String>,
}

/// Something on its way to the disk.
#[derive(Debug, Clone, Copy)]
struct UnderWay {
    line: LineId,
    n: u64,
    answers: usize,
}

impl Hosting {
    /// How many have handed in something that is kept.
    pub(in crate::screens::class) fn handed_in(&self) -> usize {
        let all = self.presence.iter();
        all.filter(|it| it.has_handed_in).count()
    }

    /// The folder with what was handed in, once there is something.
    pub(super) fn handed_in_where(&self) -> Option<&str> {
        self.handing_in.folder.as_deref()
    }

    /// Somebody hands something in.
    pub(super) fn hand_in(
        &mut self,
        person: usize,
        line: LineId,
        n: u64,
        file: &Value,
        round: &ClassRound,
        cx: &mut Context,
    ) {
        if self.presence[person].handed.is_none_or(|it| it.n < n) {
            let presence = &mut self.presence[person];
            presence.times += 1;
            match self.handing_in.read(presence.times, file) {
                Ok(mut hand_in) => {
                    // Under the name that the class knows, whatever stands in the file.
                    round.teams()[person].clone_into(&mut hand_in.name);
                    if !round.class().is_empty() {
                        round.class().clone_into(&mut hand_in.class);
                    }
                    let answers = hand_in.attempts.len();
                    let ticket = cx.ask(StoreRequest::KeepHandIn(Box::new(hand_in)));
                    let under_way = UnderWay { line, n, answers };
                    self.handing_in.under_way.insert(ticket, under_way);
                    return;
                }
                Err(why) => {
                    let kept = Err(why);
                    self.presence[person].handed = Some(HandedIn { n, kept });
                }
            }
        }
        self.keeping.wait(line);
    }

    /// What was handed in is kept in this folder, or why it is not; whoever it is of is told.
    pub(in crate::screens::class) fn keeps_hand_in(
        &mut self,
        ticket: u64,
        folder: &Result<String, String>,
        round: &ClassRound,
        scene: Scene,
        cx: &mut Context,
    ) {
        let Some(UnderWay { line, n, answers }) = self.handing_in.under_way.remove(&ticket) else {
            return;
        };
        let kept = match folder {
            Ok(folder) => {
                self.handing_in.folder = Some(folder.clone());
                Ok(answers)
            }
            Err(reason) => {
                cx.tell(format!("What a pupil handed in cannot be kept: {reason}."));
                Err(NotTaken::NotWritten)
            }
        };
        // Who has lost the connection meanwhile hands in again.
        if let Some(person) = self.person(line) {
            let presence = &mut self.presence[person];
            presence.handed = Some(HandedIn { n, kept });
            presence.has_handed_in |= kept.is_ok();
            self.keeping.wait(line);
            self.go_on(round, scene, cx);
        }
    }
}

impl HandingIn {
    /// What is in a file that may be anything, unless there were too many.
    fn read(&mut self, times: usize, file: &Value) -> Result<HandIn, NotTaken> {
        let bytes = self.bytes + file.to_string().len();
        if times > MOST || bytes > MOST_BYTES {
            return Err(NotTaken::TooMany);
        }
        self.bytes = bytes;
        let read = HandIn::of_value(file.clone()).map_err(|_| NotTaken::Format)?;
        match read.attempts.is_empty() {
            true => Err(NotTaken::Format),
            false => Ok(read),
        }
    }
}

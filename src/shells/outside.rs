//! What a program can reach outside the app: the class that it hosts, the class that it joins, and
//! the files that it exports.

use std::io;
use std::path::Path;

use super::client::Client;
use super::host::{Host, HostOptions};
use crate::files::UnplacedFile;
use crate::messages::{Effect, Input, StoreCall};

pub(super) struct Outside {
    host: Host,
    client: Client,
    /// Sends an input to the app.
    send: Box<dyn Fn(Input)>,
}

impl Outside {
    /// `hosted` is called when there is [`news`](Self::news); `send` sends an input to the app.
    pub(super) fn new(
        options: HostOptions,
        hosted: impl Fn() + Send + Sync + 'static,
        send: impl Fn(Input) + Clone + Send + Sync + 'static,
    ) -> Self {
        let joined = send.clone();
        Self {
            host: Host::new(options, hosted),
            client: Client::new(move |news| joined(Input::Joined(news))),
            send: Box::new(send),
        }
    }

    /// The news from the class that this program hosts.
    pub(super) fn news(&mut self) -> Input {
        Input::Hosted(self.host.take_news())
    }

    /// Carries out a request of the app. A request to the store is not carried out but returned.
    pub(super) fn carry_out(&mut self, effect: Effect) -> Option<StoreCall> {
        match effect {
            Effect::Keep(call) => return Some(call),
            Effect::Host(call) => self.host.call(&call),
            Effect::Join(call) => self.client.call(&call),
            Effect::Export { name, content } => self.export(&name, Ok(content.into_bytes())),
            Effect::ExportPage { name, round } => {
                self.export(&name, self.host.page_document(round.as_ref()));
            }
        }
        None
    }

    /// Writes a file, and sends the result to the app.
    fn export(&self, name: &str, content: Result<Vec<u8>, String>) {
        let result = content.and_then(|content| write(name, &content));
        (self.send)(Input::Exported(result));
    }
}

/// How many names are tried before giving up.
const MOST: u32 = 1000;

/// Writes a file with this name to the current folder. If the file exists, a number is
/// added to the name, so nothing is ever overwritten. Returns the file's path, or why it could not
/// be written.
fn write(name: &str, content: &[u8]) -> Result<String, String> {
    let failed = |error: io::Error| error.to_string();
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, "txt"));
    let draft = UnplacedFile::write(Path::new("."), content, false).map_err(failed)?;
    for number in 1..=MOST {
        let name = match number {
            1 => format!("{stem}.{ending}"),
            number => format!("{stem}-{number}.{ending}"),
        };
        if draft.place(Path::new(&name)).map_err(failed)? {
            let path = std::path::absolute(&name);
            return Ok(path.map_or(name, |path| path.display().to_string()));
        }
    }
    Err(format!("there are already {MOST} files with this name"))
}

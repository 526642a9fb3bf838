//! A teacher without a terminal, for a class whose pupils use their own devices: the app, and the
//! server that it starts.

use std::fs;
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use carrom::app::App;
use carrom::class::ClassRound;
use carrom::messages::{HostNews, Input};
use carrom::screens::{Route, Settings};
use carrom::shells::Headless;
use carrom::shells::PageFile;
use carrom::shells::host::{Host, HostOptions};
use carrom::store::Store;

use crate::folder::Folder;

/// The teacher of a class, in a separate thread.
pub(crate) struct Teacher {
    pub(crate) port: u16,
    pub(crate) code: String,
    keys: Option<Sender<String>>,
    screen: Arc<Mutex<String>>,
    thread: Option<JoinHandle<()>>,
}

impl Teacher {
    /// Starts a round of two rays questions, saved in `folder`, and continues to the first vote.
    pub(crate) fn start(folder: &Folder, page: &str) -> Self {
        let teacher = Self::gathering(folder, page);
        teacher.press("<Enter><Enter>", "have voted");
        teacher
    }

    /// Starts the same round and waits in the lobby.
    pub(crate) fn gathering(folder: &Folder, page: &str) -> Self {
        Self::with_round(folder, page, "from-angle2-7")
    }

    /// Starts the round with this code and waits in the lobby.
    pub(crate) fn with_round(folder: &Folder, page: &str, round: &str) -> Self {
        Self::hosting(folder, page, round, false)
    }

    /// Starts the round with this code, with names or nicknames, and waits in the lobby.
    pub(crate) fn hosting(folder: &Folder, page: &str, round: &str, nicknames: bool) -> Self {
        let code = carrom::quiz::Code::parse(round);
        let page = Arc::new(PageFile::new(page.to_owned(), Ok(Vec::new())));
        let (keys, pressed) = mpsc::channel();
        let (told, opened) = mpsc::channel();
        let screen = Arc::new(Mutex::new(String::new()));
        let (path, shown) = (folder.path().to_owned(), Arc::clone(&screen));
        let thread = thread::spawn(move || {
            let name = "10b".to_owned();
            let app = App::new(
                Route::Host {
                    code,
                    name,
                    nicknames,
                },
                Settings::default(),
                7,
            );
            let store = Store::in_folder(&path);
            let game = Headless::keeping(app, 80, 24, store);
            teach(game, page, &pressed, &told, &shown);
        });
        let (port, code) = opened.recv().unwrap();
        Self {
            port,
            code,
            keys: Some(keys),
            screen,
            thread: Some(thread),
        }
    }

    /// Presses keys and waits until the screen shows a text.
    pub(crate) fn press(&self, keys: &str, shows: &str) {
        self.keys.as_ref().unwrap().send(keys.into()).unwrap();
        self.wait_for(shows);
    }

    pub(crate) fn wait_for(&self, shows: &str) {
        let start = Instant::now();
        while !self.screen.lock().unwrap().contains(shows) {
            let late = start.elapsed() > Duration::from_secs(20);
            assert!(!late, "no {shows:?}:\n{}", self.screen.lock().unwrap());
            thread::sleep(Duration::from_millis(5));
        }
    }
}

impl Drop for Teacher {
    fn drop(&mut self) {
        self.keys = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Drives the teacher's app as the terminal's shell does, until there are no more keys.
fn teach(
    mut game: Headless,
    page: Arc<PageFile>,
    keys: &Receiver<String>,
    told: &Sender<(u16, String)>,
    shown: &Mutex<String>,
) {
    let (wake, woken) = mpsc::channel();
    // Any port that is free.
    let options = HostOptions {
        port: Some(0),
        page: Some(Ok(page)),
    };
    let mut host = Host::new(options, move || {
        // This fails only after the test has ended.
        let _ = wake.send(());
    });
    *shown.lock().unwrap() = game.screen();
    loop {
        for call in game.take_host_calls() {
            host.call(&call);
        }
        let pressed = match keys.try_recv() {
            Ok(keys) => {
                game.press(&keys);
                true
            }
            Err(mpsc::TryRecvError::Disconnected) => return,
            Err(mpsc::TryRecvError::Empty) => {
                let _ = woken.recv_timeout(Duration::from_millis(2));
                false
            }
        };
        let news = host.take_news();
        for it in &news {
            if let HostNews::Opened(Ok(door)) = it {
                let port = door.addresses[0].port();
                told.send((port, door.code.to_string())).unwrap();
            }
        }
        let has_news = !news.is_empty();
        if has_news {
            game.input(&Input::Hosted(news));
        }
        // The screen is drawn only after a change, because drawing large letters takes time, and
        // the devices have to wait meanwhile.
        if pressed || has_news {
            *shown.lock().unwrap() = game.screen();
        }
    }
}

/// The round as saved on disk.
pub(crate) fn kept(folder: &Folder) -> ClassRound {
    let path = folder.path().join("classes/class-1.toml");
    ClassRound::read("kept", &fs::read(path).unwrap(), &Arc::default()).unwrap()
}

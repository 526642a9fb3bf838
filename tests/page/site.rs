//! The site for a static server: it is installed on the first visit and opens without a network
//! afterwards.

use std::io::{BufRead, BufReader, Write};
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use std::{env, fs, thread};

use crate::browser::{Browser, SCREEN, press, wait_until_ready};
use crate::chromium::Chromium;

/// Serves the files of a folder. Returns the port, and a flag: once the flag is set, the server no
/// longer responds.
pub(crate) fn serve(folder: PathBuf) -> (u16, Arc<AtomicBool>) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    let down = Arc::new(AtomicBool::new(false));
    let is_down = Arc::clone(&down);
    thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            if is_down.load(Ordering::SeqCst) {
                continue;
            }
            let folder = folder.clone();
            thread::spawn(move || answer(stream, &folder));
        }
    });
    (port, down)
}

fn answer(mut stream: std::net::TcpStream, folder: &Path) {
    let mut line = String::new();
    if BufReader::new(&stream).read_line(&mut line).is_err() {
        return;
    }
    let path = line
        .split(' ')
        .nth(1)
        .unwrap_or("/")
        .trim_start_matches('/');
    let path = path.split('?').next().unwrap_or(path);
    let path = if path.is_empty() { "index.html" } else { path };
    let kind = match path.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript",
        Some("png") => "image/png",
        Some("webmanifest") => "application/manifest+json",
        _ => "application/octet-stream",
    };
    let (status, content) = match fs::read(folder.join(path)) {
        Ok(content) => ("200 OK", content),
        Err(_) => ("404 Not Found", Vec::new()),
    };
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nConnection: close\r\n\r\n",
        content.len()
    );
    let _ = stream.write_all(head.as_bytes());
    let _ = stream.write_all(&content);
}

#[test]
#[ignore = "needs the site: .ci/site builds it, and CARROM_TEST_SITE names it"]
fn the_site_is_installed_and_plays_a_round_without_a_network() {
    let site = env::var_os("CARROM_TEST_SITE");
    let site =
        PathBuf::from(site.expect("a site: .ci/site builds it, and CARROM_TEST_SITE names it"));
    let (port, down) = serve(fs::canonicalize(site).unwrap());
    let mut browser = Chromium::start((390, 664), true);
    browser.open(&format!("http://localhost:{port}/"));
    wait_until_ready(&mut browser);
    let kept = "const names = await caches.keys();
        const all = await Promise.all(names.map(async (it) => (await caches.open(it)).keys()));
        return String(all.flat().length);";
    let script = format!("return (async () => {{ {kept} }})()");
    let files = |browser: &mut Chromium| browser.run(&script, &[]).as_str().unwrap().to_owned();
    let mut count = 0;
    for _ in 0..100 {
        count = files(&mut browser).parse().unwrap();
        if count > 5 {
            break;
        }
        thread::sleep(Duration::from_millis(100));
    }
    assert!(count > 5, "only {count} files are cached");
    let faults = browser.debug("Page.getInstallabilityErrors", &serde_json::json!({}));
    let faults = faults["installabilityErrors"].as_array().unwrap().clone();
    let own = |fault: &&serde_json::Value| fault["errorId"] != "in-incognito";
    assert_eq!(faults.iter().filter(own).count(), 0, "{faults:?}");
    down.store(true, Ordering::SeqCst);
    browser.open("about:blank");
    browser.open(&format!("http://localhost:{port}/#quiz=quick-7"));
    wait_until_ready(&mut browser);
    for question in 1..=5 {
        let place = format!("question {question} of 5");
        for _ in 0..40 {
            let screen = browser.run(SCREEN, &[]);
            if !screen.as_str().unwrap().contains(&place) {
                break;
            }
            press(&mut browser, &["1", "Enter"]);
            thread::sleep(Duration::from_millis(100));
        }
    }
    thread::sleep(Duration::from_millis(300));
    let screen = browser.run(SCREEN, &[]);
    assert!(
        screen
            .as_str()
            .unwrap()
            .contains("The same round for a friend"),
        "{screen}"
    );
}

//! The page that the host serves. The content security policy in the file allows no connections;
//! the policy in the served copy allows connections to the server.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, Write};

use flate2::Compression;
use flate2::write::GzEncoder;

/// The part on connections in the policy of the file, and in that of the served copy.
const CONNECT: [&str; 2] = ["connect-src 'none'", "connect-src 'self'"];
/// The root element of the file, and that of the served copy, in which an attribute shows that the
/// page is served to a class.
const ROOT: [&str; 2] = ["<html lang=\"en\">", "<html lang=\"en\" data-class=\"\">"];
/// The text before the policy in the file.
const POLICY: &str = "http-equiv=\"Content-Security-Policy\" content=\"";

/// The page that the host serves.
#[derive(Debug)]
pub(super) struct ServedPage {
    text: String,
    packed: Vec<u8>,
    /// The tag of the contents (`ETag`). It changes with them, so that browsers do not show an
    /// outdated page.
    tag: String,
    policy: String,
}

impl ServedPage {
    /// The copy of a page that is served.
    ///
    /// # Errors
    /// None in practice, because the page is compressed in memory.
    pub(super) fn new(page: &str) -> io::Result<Self> {
        let text = page.replacen(CONNECT[0], CONNECT[1], 1);
        let text = text.replacen(ROOT[0], ROOT[1], 1);
        let policy = text
            .split_once(POLICY)
            .and_then(|(_, rest)| rest.split_once('"'));
        let policy = match policy {
            Some((policy, _)) => format!("{policy}; frame-ancestors 'none'"),
            None => format!("default-src 'none'; {}; frame-ancestors 'none'", CONNECT[1]),
        };
        let mut packer = GzEncoder::new(Vec::new(), Compression::default());
        packer.write_all(text.as_bytes())?;
        let mut hasher = DefaultHasher::new();
        text.hash(&mut hasher);
        Ok(Self {
            packed: packer.finish()?,
            tag: format!("\"{:016x}\"", hasher.finish()),
            policy,
            text,
        })
    }

    /// The head and the body of the response with the page.
    pub(super) fn answer(&self, gzip: bool, known: Option<&str>) -> (String, &[u8]) {
        let common = format!(
            "ETag: {}\r\nContent-Security-Policy: {}\r\nCache-Control: no-cache\r\n\
             Vary: Accept-Encoding\r\nX-Content-Type-Options: nosniff\r\n\
             Referrer-Policy: no-referrer\r\nConnection: close\r\n",
            self.tag, self.policy
        );
        if known.is_some_and(|known| known.contains(&self.tag)) {
            return (format!("HTTP/1.1 304 Not Modified\r\n{common}\r\n"), &[]);
        }
        let (encoding, body) = match gzip {
            true => ("Content-Encoding: gzip\r\n", self.packed.as_slice()),
            false => ("", self.text.as_bytes()),
        };
        let head = format!(
            "HTTP/1.1 200 OK\r\nContent-Type: text/html; charset=utf-8\r\n{encoding}\
             Content-Length: {}\r\n{common}\r\n",
            body.len()
        );
        (head, body)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_served_copy_can_connect_only_to_its_server() {
        let file = "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; \
                    script-src 'sha256-x'; connect-src 'none'\">";
        let page = ServedPage::new(file).unwrap();
        let (head, body) = page.answer(false, None);
        let body = std::str::from_utf8(body).unwrap();
        assert!(body.contains("connect-src 'self'") && !body.contains("connect-src 'none'"));
        let policy = "Content-Security-Policy: default-src 'none'; script-src 'sha256-x'; \
                      connect-src 'self'; frame-ancestors 'none'\r\n";
        assert!(head.contains(policy), "{head}");
    }

    #[test]
    fn a_cached_page_is_not_sent_again_but_a_changed_one_is() {
        let [old, new] = ["one", "two"].map(|text| ServedPage::new(text).unwrap());
        let (head, _) = old.answer(true, Some(&old.tag));
        assert!(head.starts_with("HTTP/1.1 304 "));
        let (head, body) = new.answer(true, Some(&old.tag));
        assert!(head.starts_with("HTTP/1.1 200 ") && body.starts_with(&[0x1f, 0x8b]));
    }
}

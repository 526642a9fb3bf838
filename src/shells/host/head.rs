//! The head of an HTTP request: what it requests, and whether that is allowed.
//!
//! Another web page that a pupil has open must not reach the class: to prevent DNS rebinding,
//! the `Host` has to be an IP address or localhost, with this server's port; and the `Origin` of a
//! WebSocket has to be the page that was served here.

use std::net::IpAddr;

/// The maximum size of a head, in bytes.
pub(super) const LONGEST: usize = 8 * 1024;
/// The maximum number of headers in a head.
const MOST_LINES: usize = 64;
pub(crate) const TALK: &str = "/class";

#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum HttpRequest {
    Page {
        /// Whether the response may be compressed.
        gzip: bool,
        /// The tag of the page in the browser's cache.
        known: Option<String>,
        /// Whether the client requests only the head (`HEAD`).
        head_only: bool,
    },
    /// A WebSocket connection with this key.
    Talk(String),
    /// A refusal: the status and the message.
    No(u16, &'static str),
}

/// The message for requests that do not use the address on the board.
const BY_ADDRESS: &str = "Open the address that is shown on the board.";

/// Reads a complete head; `None` while it is incomplete.
pub(super) fn read(bytes: &[u8], port: u16) -> Option<(usize, HttpRequest)> {
    let mut lines = [httparse::EMPTY_HEADER; MOST_LINES];
    let mut request = httparse::Request::new(&mut lines);
    let length = match request.parse(bytes) {
        Ok(httparse::Status::Complete(length)) => length,
        Ok(httparse::Status::Partial) if bytes.len() < LONGEST => return None,
        Ok(httparse::Status::Partial) => return Some((0, HttpRequest::No(431, "Too long."))),
        Err(_) => {
            return Some((
                0,
                HttpRequest::No(400, "This is not a request from a browser."),
            ));
        }
    };
    Some((length, requested(&request, port)))
}

fn requested(request: &httparse::Request, port: u16) -> HttpRequest {
    // A header that occurs twice is ignored, because its meaning is unclear.
    let only = |name: &str| {
        let mut found = request
            .headers
            .iter()
            .filter(|it| it.name.eq_ignore_ascii_case(name));
        match (found.next(), found.next()) {
            (Some(line), None) => std::str::from_utf8(line.value).ok(),
            _ => None,
        }
    };
    let has = |name: &str| {
        request
            .headers
            .iter()
            .any(|it| it.name.eq_ignore_ascii_case(name))
    };
    let Some(host) = only("host").filter(|host| is_own(host, port)) else {
        return HttpRequest::No(403, BY_ADDRESS);
    };
    let path = request.path.unwrap_or_default();
    let path = path.split('?').next().unwrap_or_default();
    let method = request.method.unwrap_or_default();
    match (method, path) {
        ("GET", TALK) => {
            let origin = only("origin");
            if has("origin") && origin != Some(format!("http://{host}").as_str()) {
                return HttpRequest::No(403, BY_ADDRESS);
            }
            let upgrades = only("upgrade").is_some_and(|it| it.eq_ignore_ascii_case("websocket"));
            let version = only("sec-websocket-version") == Some("13");
            match only("sec-websocket-key").filter(|_| upgrades && version) {
                Some(key) => HttpRequest::Talk(key.to_owned()),
                None => HttpRequest::No(426, "This address is for the devices of a class."),
            }
        }
        ("GET" | "HEAD", "/" | "/index.html" | "/carrom.html") => HttpRequest::Page {
            gzip: only("accept-encoding").is_some_and(takes_gzip),
            known: only("if-none-match").map(str::to_owned),
            head_only: method == "HEAD",
        },
        ("GET" | "HEAD", _) => HttpRequest::No(404, "There is nothing here. The class is at /."),
        _ => HttpRequest::No(405, "Only GET and HEAD are allowed."),
    }
}

/// Whether a `Host` header names this server: any IP address or localhost, with this port.
fn is_own(host: &str, port: u16) -> bool {
    let (name, its_port) = match host.rsplit_once(':') {
        Some((name, its_port)) if !host.ends_with(']') => (name, its_port.parse().ok()),
        _ => (host, Some(80)),
    };
    let bare = name.strip_prefix('[').and_then(|it| it.strip_suffix(']'));
    let is_address = bare.unwrap_or(name).parse::<IpAddr>().is_ok();
    its_port == Some(port) && (is_address || name.eq_ignore_ascii_case("localhost"))
}

fn takes_gzip(encodings: &str) -> bool {
    encodings.split(',').any(|it| {
        let mut parts = it.split(';').map(str::trim);
        let is_gzip = matches!(parts.next(), Some("gzip" | "*"));
        is_gzip && !parts.any(|it| matches!(it, "q=0" | "q=0.0"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn requested(lines: &[&str]) -> HttpRequest {
        let head = format!("{}\r\n\r\n", lines.join("\r\n"));
        read(head.as_bytes(), 8090).unwrap().1
    }

    const UPGRADE: [&str; 3] = [
        "Upgrade: websocket",
        "Sec-WebSocket-Version: 13",
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
    ];

    fn talk(host: &str, origin: Option<&str>) -> HttpRequest {
        let origin = origin.map(|it| format!("Origin: {it}"));
        let host = format!("Host: {host}");
        let mut lines = vec!["GET /class HTTP/1.1", host.as_str()];
        lines.extend(UPGRADE);
        lines.extend(origin.as_deref());
        requested(&lines)
    }

    #[test]
    fn the_host_is_this_server_by_its_address() {
        for host in [
            "192.168.1.5:8090",
            "127.0.0.1:8090",
            "[::1]:8090",
            "localhost:8090",
        ] {
            assert!(matches!(talk(host, None), HttpRequest::Talk(_)), "{host}");
        }
        for host in [
            "evil.example:8090",
            "192.168.1.5",
            "192.168.1.5:80",
            "192.168.1.5:8091",
            "",
            "localhost.evil.example:8090",
            "0x7f.1:8090",
            "127.0.0.1.evil.example:8090",
        ] {
            assert_eq!(talk(host, None), HttpRequest::No(403, BY_ADDRESS), "{host}");
        }
        assert_eq!(
            requested(&["GET / HTTP/1.1"]),
            HttpRequest::No(403, BY_ADDRESS)
        );
        let twice = [
            "GET / HTTP/1.1",
            "Host: 127.0.0.1:8090",
            "Host: evil.example",
        ];
        assert_eq!(requested(&twice), HttpRequest::No(403, BY_ADDRESS));
    }

    #[test]
    fn only_the_served_page_can_open_a_websocket() {
        let host = "192.168.1.5:8090";
        assert!(matches!(
            talk(host, Some("http://192.168.1.5:8090")),
            HttpRequest::Talk(_)
        ));
        for origin in [
            "null",
            "http://evil.example",
            "https://192.168.1.5:8090",
            "http://192.168.1.5",
            "http://192.168.1.5:8090.evil.example",
            "http://localhost:8090",
            "",
        ] {
            assert_eq!(
                talk(host, Some(origin)),
                HttpRequest::No(403, BY_ADDRESS),
                "{origin}"
            );
        }
    }

    #[test]
    fn an_invalid_request_is_refused() {
        assert_eq!(read(b"GET / HT", 8090), None);
        for bytes in [
            &b"\x16\x03\x01\x02\x00\x01\x00"[..],
            b"\0\0\0\r\n\r\n",
            b"hello there\r\n\r\n",
        ] {
            assert!(matches!(
                read(bytes, 8090),
                Some((0, HttpRequest::No(400, _)))
            ));
        }
        let long = format!("GET / HTTP/1.1\r\nHost: {}", "x".repeat(LONGEST));
        assert!(matches!(
            read(long.as_bytes(), 8090),
            Some((0, HttpRequest::No(431, _)))
        ));
        let host = "Host: localhost:8090";
        assert!(matches!(
            requested(&["POST / HTTP/1.1", host]),
            HttpRequest::No(405, _)
        ));
        assert!(matches!(
            requested(&["GET /../x HTTP/1.1", host]),
            HttpRequest::No(404, _)
        ));
        assert!(matches!(
            requested(&["GET /class HTTP/1.1", host]),
            HttpRequest::No(426, _)
        ));
    }

    #[test]
    fn the_page_is_compressed_for_browsers_that_accept_it() {
        for (encodings, wanted) in [("gzip, br", true), ("br", false), ("gzip;q=0", false)] {
            let encodings = format!("Accept-Encoding: {encodings}");
            let lines = ["GET /?x HTTP/1.1", "Host: localhost:8090", &encodings];
            assert!(matches!(requested(&lines), HttpRequest::Page { gzip, .. } if gzip == wanted));
        }
    }
}

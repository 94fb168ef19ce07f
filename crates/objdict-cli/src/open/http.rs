//! As much of HTTP/1.1 as the page of `objdict open` needs: one request on a connection, with bounds for its size and its time.
//!
//! No HTTP crate is used: tiny_http has no read timeout, keeps connections open and had its last release in 2022;
//! an asynchronous server needs a runtime.

use std::borrow::Cow;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::{Duration, Instant};

use serde_json::json;

use crate::ending::Failure;

/// The largest head of a request; browsers send the cookies of all ports of a host.
const MAX_HEAD: u64 = 32 << 10;
/// How long a head may take, a body, and what is sent after a refusal.
const HEAD_TIME: Duration = Duration::from_secs(10);
const BODY_TIME: Duration = Duration::from_secs(60);
const DRAIN_TIME: Duration = Duration::from_secs(2);

/// Why a request is refused: the status, and what the page says.
pub(super) struct HttpRefusal(pub(super) u16, pub(super) Failure);

impl HttpRefusal {
    pub(super) fn new(status: u16, message: impl std::fmt::Display) -> Self {
        Self(status, Failure::new(message))
    }

    pub(super) fn help(self, help: impl AsRef<str>) -> Self {
        Self(self.0, self.1.help(help))
    }
}

/// A stream that is read until a time.
struct Timed {
    stream: TcpStream,
    until: Instant,
}

impl Read for Timed {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let left = self.until.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Err(io::ErrorKind::TimedOut.into());
        }
        self.stream.set_read_timeout(Some(left))?;
        self.stream.read(buffer)
    }
}

/// A request, whose body is not read yet.
pub(super) struct HttpRequest {
    stream: BufReader<Timed>,
    pub(super) method: String,
    pub(super) target: String,
    headers: Vec<(String, String)>,
}

impl HttpRequest {
    /// The request of a connection; `None` when the other side sends nothing, as browsers do that connect in advance.
    pub(super) fn read(stream: TcpStream) -> Option<Result<Self, HttpRefusal>> {
        let mut stream = BufReader::new(Timed { stream, until: Instant::now() + HEAD_TIME });
        let mut head = stream.by_ref().take(MAX_HEAD);
        let mut lines: Vec<String> = Vec::new();
        loop {
            let mut line = Vec::new();
            match head.read_until(b'\n', &mut line) {
                Ok(0) if lines.is_empty() => return None,
                Ok(_) if line.ends_with(b"\n") => {}
                _ if head.limit() == 0 => {
                    return Some(Err(HttpRefusal::new(431, "the head of the request is too long")));
                }
                _ => return None,
            }
            let Ok(line) = String::from_utf8(line) else { return Some(Err(malformed())) };
            match line.trim_end_matches(['\r', '\n']) {
                "" => break,
                line => lines.push(line.to_owned()),
            }
        }
        Some(Self::of(stream, &lines).ok_or_else(malformed))
    }

    fn of(stream: BufReader<Timed>, lines: &[String]) -> Option<Self> {
        let (first, lines) = lines.split_first()?;
        let mut parts = first.split(' ');
        let (method, target, version) = (parts.next()?.to_owned(), parts.next()?.to_owned(), parts.next()?);
        let header = |line: &String| {
            let (name, value) = line.split_once(':')?;
            let is_name = !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_graphic());
            is_name.then(|| (name.to_ascii_lowercase(), value.trim().to_owned()))
        };
        let headers = lines.iter().map(header).collect::<Option<_>>()?;
        let is_known = version.starts_with("HTTP/1.") && parts.next().is_none();
        is_known.then_some(Self { stream, method, target, headers })
    }

    /// The value of a header; one that is there twice could mean either.
    pub(super) fn header(&self, name: &str) -> Result<Option<&str>, HttpRefusal> {
        let mut values = self.headers.iter().filter(|(own, _)| own == name).map(|(_, value)| &**value);
        match (values.next(), values.next()) {
            (value, None) => Ok(value),
            _ => Err(malformed()),
        }
    }

    /// The body, of at most so many bytes.
    pub(super) fn body(&mut self, max: u64) -> Result<Vec<u8>, HttpRefusal> {
        let length =
            self.header("content-length")?.filter(|_| matches!(self.header("transfer-encoding"), Ok(None)));
        let length =
            length.ok_or_else(|| HttpRefusal::new(411, "the request does not say how long its body is"))?;
        let is_number = !length.is_empty() && length.bytes().all(|byte| byte.is_ascii_digit());
        let length: u64 = length.parse().ok().filter(|_| is_number).ok_or_else(malformed)?;
        if length > max {
            let message = format!("the file has {length} bytes, more than the limit of {max}");
            return Err(HttpRefusal::new(413, message).help("raise the limit with `--max-size`"));
        }
        if self.header("expect")?.is_some() {
            // what cannot be written is not read either
            let _ = self.stream.get_mut().stream.write_all(b"HTTP/1.1 100 Continue\r\n\r\n");
        }
        self.stream.get_mut().until = Instant::now() + BODY_TIME;
        let mut body = Vec::new();
        match self.stream.by_ref().take(length).read_to_end(&mut body) {
            Ok(read) if read as u64 == length => Ok(body),
            _ => Err(HttpRefusal::new(400, "the body of the request is not complete")),
        }
    }
}

fn malformed() -> HttpRefusal {
    HttpRefusal::new(400, "the request is malformed")
}

/// What is answered.
pub(super) struct HttpResponse<'a> {
    pub(super) status: u16,
    pub(super) kind: &'static str,
    pub(super) etag: Option<String>,
    pub(super) body: Cow<'a, [u8]>,
}

impl From<HttpRefusal> for HttpResponse<'_> {
    fn from(HttpRefusal(status, failure): HttpRefusal) -> Self {
        let error = json!({ "message": failure.message, "help": failure.help });
        let body = json!({ "error": error }).to_string().into_bytes();
        Self { status, kind: "application/json", etag: None, body: body.into() }
    }
}

impl HttpResponse<'_> {
    /// Sends it, or its head alone, and ends the connection. No other page may frame, read or keep what it has.
    pub(super) fn send(&self, mut stream: &TcpStream, is_head: bool) -> io::Result<()> {
        let etag = self.etag.as_ref().map(|etag| format!("ETag: {etag}\r\n")).unwrap_or_default();
        let head = format!(
            "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\n{etag}Connection: close\r\n\
             Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n\
             Referrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\n\r\n",
            self.status,
            if self.status < 400 { "OK" } else { "Refused" },
            self.kind,
            self.body.len()
        );
        stream.set_write_timeout(Some(BODY_TIME))?;
        stream.write_all(head.as_bytes())?;
        let body: &[u8] = if is_head { &[] } else { &self.body };
        stream.write_all(body)?;
        stream.shutdown(Shutdown::Write)?;
        // closing what has unread bytes would reset the connection before the answer is read
        let rest = Timed { stream: stream.try_clone()?, until: Instant::now() + DRAIN_TIME };
        io::copy(&mut { rest }, &mut io::sink()).map(drop)
    }
}

//! `objdict lsp`.
//!
//! The transport of `lsp-server` ends the process at the first message that it cannot read, or allocates what a header says.

use std::io::{self, BufRead, Read, Write};
use std::thread;

use lsp_server::{Connection, ErrorCode, Message};
use serde_json::json;

use super::ending::{Failure, Outcome};

/// The header of a message, in lower case.
const LENGTH: &[u8] = b"content-length:";

/// The largest message, in bytes: a file of the hard limit as JSON.
const MAX_MESSAGE: u64 = 2 << 30;

/// Serves the editor at the other end of standard input and output.
pub(super) fn run() -> Result<Outcome, Failure> {
    let (server, Connection { sender, receiver }) = Connection::memory();
    let reader = thread::Builder::new().spawn(move || -> io::Result<()> {
        let mut input = io::stdin().lock();
        while let Some(body) = next_body(&mut input)? {
            match body.and_then(|body| message(&body)) {
                Ok(message) => {
                    let is_exit = matches!(&message, Message::Notification(note) if note.method == "exit");
                    if sender.send(message).is_err() || is_exit {
                        break;
                    }
                }
                Err(error) => send(&error)?,
            }
        }
        Ok(())
    })?;
    let writer =
        thread::Builder::new().spawn(move || receiver.iter().try_for_each(|message| send(&message)))?;
    objdict_lsp::serve(&server).map_err(Failure::new)?;
    // the thread that writes ends with the last sender
    drop(server);
    for thread in [reader, writer] {
        thread
            .join()
            .map_err(|_| Failure::new("the language server lost its connection to the editor"))??;
    }
    Ok(Outcome::Clean)
}

fn send(message: &impl serde::Serialize) -> io::Result<()> {
    let mut body = serde_json::to_value(message)?;
    body["jsonrpc"] = json!("2.0");
    let body = body.to_string();
    let mut out = io::stdout().lock();
    write!(out, "Content-Length: {}\r\n\r\n{body}", body.len())?;
    out.flush()
}

/// The answer to what is no message. Its number is not known.
fn refusal(code: ErrorCode, reason: &str) -> serde_json::Value {
    json!({ "id": null, "error": { "code": code as i32, "message": reason } })
}

fn message(body: &[u8]) -> Result<Message, serde_json::Value> {
    serde_json::from_slice(body).map_err(|error| {
        let code = if error.is_data() { ErrorCode::InvalidRequest } else { ErrorCode::ParseError };
        refusal(code, &error.to_string())
    })
}

/// The bytes of the next message, or why there are none; `None` at the end. What is before a header is the rest of a message that is
/// longer than it says.
fn next_body(input: &mut impl BufRead) -> io::Result<Option<Result<Vec<u8>, serde_json::Value>>> {
    let mut length = None;
    loop {
        let mut line = Vec::new();
        if input.read_until(b'\n', &mut line)? == 0 {
            return Ok(None);
        }
        let line = line.trim_ascii().to_ascii_lowercase();
        if let Some(at) = line.windows(LENGTH.len()).position(|window| window == LENGTH) {
            let number = String::from_utf8_lossy(&line[at + LENGTH.len()..]).trim().to_owned();
            length = number.parse().ok().filter(|length| *length <= MAX_MESSAGE);
            if length.is_none() {
                return Ok(Some(Err(refusal(ErrorCode::ParseError, "the Content-Length is not valid"))));
            }
        }
        if let Some(length) = length.filter(|_| line.is_empty()) {
            let mut body = Vec::new();
            let is_whole = input.take(length).read_to_end(&mut body)? as u64 == length;
            return Ok(is_whole.then_some(Ok(body)));
        }
    }
}

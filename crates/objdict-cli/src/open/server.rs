//! The server of `objdict open`: the page, the list of its files, and their bytes. Only a program on this computer reaches it, only one that
//! knows the token is answered, and only a page that it served itself may write.
//!
//! The token is part of the path, so the page can ask for `files/3` without knowing it. A file is compared by its
//! SHA-256 under a lock before it is written; only a different program could change it in between.

use std::borrow::Cow;
use std::collections::VecDeque;
use std::fmt::Write as _;
use std::io::Write as _;
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError, RwLock, RwLockReadGuard};
use std::thread;
use std::time::{Duration, Instant};

use super::files::ServedFiles;
use super::http::{HttpRefusal, HttpRequest, HttpResponse};
use crate::Texts;
use crate::args::OpenArgs;
use crate::ending::{Failure, Outcome, note};
use crate::stdout::Output;
use crate::written_files::private;
use objdict_model::diagnostic::plural;

/// So many requests with the token are served at a time.
const MAX_REQUESTS: usize = 32;

/// So many connections may have shown no token yet. One more ends the oldest, so none of them keeps a request out.
const MAX_WAITING: usize = 64;

/// How long a browser may take until it has read the file that leads to the page.
const BROWSER_TIME: Duration = Duration::from_secs(60);

struct PageServer {
    files: RwLock<ServedFiles>,
    page: String,
    port: u16,
    token: String,
    requests: AtomicUsize,
    /// The connections that have shown no token yet, the oldest first.
    waiting: Mutex<VecDeque<(u64, TcpStream)>>,
    /// Whether the page was asked for.
    is_open: AtomicBool,
}

pub(crate) fn run(args: &OpenArgs, texts: &Texts, out: &mut Output) -> Result<Outcome, Failure> {
    let files = ServedFiles::gather(args)?;
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, args.port)).map_err(|error| {
        let message = format!("cannot listen on port {}: {error}", args.port);
        Failure::new(message).help("choose a different one with `--port`, or leave it out")
    })?;
    let port = listener.local_addr()?.port();
    let count = files.count();
    let files = RwLock::new(files);
    let (page, token) = (page(texts)?, token()?);
    let (requests, waiting, is_open) = (AtomicUsize::new(0), Mutex::default(), AtomicBool::new(false));
    let server = Arc::new(PageServer { files, page, port, token, requests, waiting, is_open });
    let address = format!("http://127.0.0.1:{port}/{}/", server.token);
    writeln!(out, "{address}")?;
    out.finish()?;
    note(&format!("serving {} to this computer until Ctrl-C\n", plural(count, "file")));
    if !args.no_browser {
        start_browser(address, &server);
    }
    serve(&listener, &server)
}

/// The page with what the single file on disk does without: the place of the files, and the permission to ask for them. It is the file that
/// the variable `OBJDICT_WORKBENCH` names, or the one in this program.
fn page(texts: &Texts) -> Result<String, Failure> {
    let page = match std::env::var_os("OBJDICT_WORKBENCH") {
        Some(path) => Cow::Owned(std::fs::read_to_string(&path).map_err(|error| {
            let message = format!("cannot read the workbench `{}`: {error}", path.display());
            Failure::new(message)
                .help("build it with `cd web && npm run build`, or unset `OBJDICT_WORKBENCH`")
        })?),
        None => Cow::Borrowed(texts.workbench.ok_or_else(without_page)?),
    };
    let place = "<meta name=\"objdict-files\" content=\"files\">\n<title>";
    let policy = "default-src 'none'; connect-src 'self'";
    Ok(page.replacen("default-src 'none'", policy, 1).replacen("<title>", place, 1))
}

fn without_page() -> Failure {
    let help = "install a package, or build the page and name it with `OBJDICT_WORKBENCH` (docs/guides/workbench.md); \
                `web/dist/objdict-workbench.html` opens files without the command";
    Failure::new("this `objdict` was built without the workbench").help(help)
}

fn token() -> Result<String, Failure> {
    let mut random = [0; 16];
    getrandom::fill(&mut random)
        .map_err(|error| Failure::new(format_args!("cannot draw a random number: {error}")))?;
    Ok(random.iter().fold(String::new(), |mut token, byte| {
        let _ = write!(token, "{byte:02x}");
        token
    }))
}

/// Opens a file that leads to the page: the arguments of a program, unlike the file, can be read by every user, and the address has
/// the token.
fn start_browser(address: String, server: &Arc<PageServer>) {
    let (program, arguments): (_, &[&str]) = match std::env::consts::OS {
        "windows" => ("cmd", &["/C", "start", ""]),
        "macos" => ("open", &[]),
        _ => ("xdg-open", &[]),
    };
    let server = Arc::clone(server);
    // the program may run as long as the browser
    let _ = thread::Builder::new().spawn(move || {
        let page = format!("<!DOCTYPE html><meta http-equiv=\"refresh\" content=\"0;url={address}\">\n");
        let mut command = Command::new(program);
        command.args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        let started = private("workbench.html", page.as_bytes())
            .and_then(|file| Ok((command.arg(&file.path).spawn()?, file)));
        let is_started = started.is_ok_and(|(mut process, _file)| {
            let until = Instant::now() + BROWSER_TIME;
            while !server.is_open.load(Ordering::SeqCst) && Instant::now() < until {
                if matches!(process.try_wait(), Ok(Some(status)) if !status.success()) {
                    return false;
                }
                thread::sleep(Duration::from_millis(100));
            }
            server.is_open.load(Ordering::SeqCst)
        });
        if !is_started {
            note(&format!("note: `{program}` did not start a browser: open the address in one\n"));
        }
    });
}

fn serve(listener: &TcpListener, server: &Arc<PageServer>) -> Result<Outcome, Failure> {
    for number in 0.. {
        let accepted = listener.accept().and_then(|(stream, _)| Ok((stream.try_clone()?, stream)));
        let Ok((waiting, stream)) = accepted else {
            // as with too many open files, which are fewer later
            thread::sleep(Duration::from_millis(100));
            continue;
        };
        server.wait(number, waiting);
        let of_thread = Arc::clone(server);
        let started = thread::Builder::new().spawn(move || {
            of_thread.converse(number, stream);
            of_thread.leave(number);
        });
        if started.is_err() {
            server.leave(number);
        }
    }
    Ok(Outcome::Clean)
}

impl PageServer {
    /// Adds a connection that has shown no token yet.
    fn wait(&self, number: u64, stream: TcpStream) {
        let mut waiting = self.waiting.lock().unwrap_or_else(PoisonError::into_inner);
        waiting.push_back((number, stream));
        if waiting.len() > MAX_WAITING
            && let Some((_, oldest)) = waiting.pop_front()
        {
            // its thread reads no more, and ends
            let _ = oldest.shutdown(Shutdown::Both);
        }
    }

    fn leave(&self, number: u64) {
        let mut waiting = self.waiting.lock().unwrap_or_else(PoisonError::into_inner);
        waiting.retain(|(other, _)| *other != number);
    }

    fn converse(&self, number: u64, stream: TcpStream) {
        let Ok(answers) = stream.try_clone() else { return };
        let Some(request) = HttpRequest::read(stream) else { return };
        let is_head = request.as_ref().is_ok_and(|request| request.method == "HEAD");
        let mut has_token = false;
        let response = request.and_then(|mut request| {
            let path = self.admit(&request)?;
            has_token = true;
            if self.requests.fetch_add(1, Ordering::SeqCst) >= MAX_REQUESTS {
                return Err(HttpRefusal::new(503, "too many requests are served already"));
            }
            self.leave(number);
            self.answer(&mut request, &path)
        });
        // a page that was closed meanwhile needs no answer
        let _ = response.unwrap_or_else(HttpResponse::from).send(&answers, is_head);
        if has_token {
            self.requests.fetch_sub(1, Ordering::SeqCst);
        }
    }

    fn answer(&self, request: &mut HttpRequest, path: &str) -> Result<HttpResponse<'_>, HttpRefusal> {
        let ok = |kind, etag, body| HttpResponse { status: 200, kind, etag, body };
        match (&*request.method, path) {
            ("GET" | "HEAD", "") => {
                self.is_open.store(true, Ordering::SeqCst);
                Ok(ok("text/html; charset=utf-8", None, self.page.as_bytes().into()))
            }
            ("GET" | "HEAD", "files") => {
                // known files remain in the list even if they left their folder
                drop(self.files.write().unwrap_or_else(PoisonError::into_inner).look_again());
                let list = self.files().list().map_err(|failure| HttpRefusal(500, failure))?;
                Ok(ok("application/json", None, list.into()))
            }
            ("GET" | "HEAD", path) => {
                let (bytes, etag) = self.files().read(number(path)?)?;
                Ok(ok("application/octet-stream", Some(etag), bytes.into()))
            }
            ("PUT", path) => {
                let number = number(path)?;
                let unstated = || {
                    HttpRefusal::new(428, "the request does not say which version of the file it replaces")
                };
                let expected = request.header("if-match")?.ok_or_else(unstated)?.to_owned();
                let body = request.body(self.files().max_size())?;
                let etag = self.files().write(number, &expected, &body)?;
                Ok(ok("text/plain", Some(etag), [].as_slice().into()))
            }
            _ => Err(HttpRefusal::new(405, "only `GET`, `HEAD` and `PUT` are answered")),
        }
    }

    fn files(&self) -> RwLockReadGuard<'_, ServedFiles> {
        self.files.read().unwrap_or_else(PoisonError::into_inner)
    }

    /// The path of a request below the token. A page of another site has another `Origin`; and it has another `Host` if its name was made to
    /// mean this computer.
    fn admit(&self, request: &HttpRequest) -> Result<String, HttpRefusal> {
        let hosts = ["127.0.0.1", "localhost"].map(|host| format!("{host}:{}", self.port));
        let host = request.header("host")?.unwrap_or_default();
        if !hosts.iter().any(|own| own == host) {
            return Err(HttpRefusal::new(403, "the request is for a different host"));
        }
        let origin = request.header("origin")?;
        let is_own = origin
            .map_or(matches!(&*request.method, "GET" | "HEAD"), |origin| origin == format!("http://{host}"));
        if !is_own {
            return Err(HttpRefusal::new(403, "the request is from the page of a different site"));
        }
        let (token, path) =
            request.target.strip_prefix('/').and_then(|path| path.split_once('/')).unwrap_or_default();
        if !is_equal(token, &self.token) {
            return Err(HttpRefusal::new(403, "the address lacks its token")
                .help("open the address that `objdict open` printed"));
        }
        Ok(path.split('?').next().unwrap_or_default().to_owned())
    }
}

/// The number of a file in `files/3`.
fn number(path: &str) -> Result<usize, HttpRefusal> {
    let digits =
        path.strip_prefix("files/").filter(|digits| digits.bytes().all(|digit| digit.is_ascii_digit()));
    digits
        .and_then(|digits| digits.parse().ok())
        .ok_or_else(|| HttpRefusal::new(404, "the address names no file of the list"))
}

/// Compares in a time that does not depend on how much is equal.
fn is_equal(one: &str, other: &str) -> bool {
    let differences =
        one.bytes().zip(other.bytes()).fold(0, |differences, (one, other)| differences | (one ^ other));
    one.len() == other.len() && differences == 0
}

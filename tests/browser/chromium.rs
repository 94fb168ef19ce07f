//! Chromium without a window, driven over two pipes by the DevTools protocol: a message is JSON and ends with NUL.

use std::collections::HashMap;
use std::env;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{ChildStdin, Command, Stdio};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, OnceLock};
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

use crate::support::skips::skip_unless_ci;

/// How long anything may take before it counts as hanging. Machines of CI are slow, and a large page takes its time.
pub(crate) const PATIENCE: Duration = Duration::from_secs(60);

/// The program reads messages from 3 and writes them to 4. It ends when our end of the pipe closes, also because this
/// process was killed; the shell then removes the folder of the profile, because no one else can.
const SCRIPT: &str = r#""$0" "$@" 3<&0 4>&1 </dev/null >/dev/null; rm -rf "$PROFILE""#;

const OPTIONS: [&str; 12] = [
    "--headless=new",
    // as root, as in most containers, there is no sandbox
    "--no-sandbox",
    "--disable-gpu",
    // containers have 64 MB of it
    "--disable-dev-shm-usage",
    "--remote-debugging-pipe",
    "--no-first-run",
    "--no-default-browser-check",
    "--disable-extensions",
    "--disable-background-networking",
    // tabs that are not in front work at full speed
    "--disable-background-timer-throttling",
    "--disable-backgrounding-occluded-windows",
    "--disable-renderer-backgrounding",
];

/// A running Chromium, shared by all tests of this binary.
pub(crate) struct Chromium {
    input: Mutex<ChildStdin>,
    next: AtomicU64,
    inbox: Arc<Inbox>,
}

/// Messages of the browser that are not yet consumed.
#[derive(Default)]
struct Inbox {
    mail: Mutex<Mail>,
    arrived: Condvar,
}

#[derive(Default)]
struct Mail {
    answers: HashMap<u64, Value>,
    /// By the session of a tab, in the order of their arrival.
    events: HashMap<String, Vec<Value>>,
    complaints: String,
    ended: bool,
}

impl Chromium {
    /// The browser, started by the first test that needs it. `None` without Chromium: the test is skipped, or fails with
    /// `CI=true`.
    pub(crate) fn shared() -> Option<&'static Self> {
        static CHROMIUM: OnceLock<Option<Chromium>> = OnceLock::new();
        let found = CHROMIUM.get_or_init(|| executable().map(|path| Self::start(&path))).as_ref();
        if found.is_none() {
            skip_unless_ci("no Chromium: install the package `chromium`");
        }
        found
    }

    fn start(path: &Path) -> Self {
        let profile = tempfile::Builder::new().prefix("objdict-browser-").tempdir().unwrap().keep();
        let mut data = std::ffi::OsString::from("--user-data-dir=");
        data.push(&profile);
        let mut child = Command::new("sh")
            .arg("-c")
            .arg(SCRIPT)
            .arg(path)
            .args(OPTIONS)
            .arg(data)
            .arg("about:blank")
            .env("PROFILE", &profile)
            .env("TMPDIR", &profile)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap_or_else(|error| panic!("cannot start {}: {error}", path.display()));
        let input = Mutex::new(child.stdin.take().unwrap());
        let inbox = Arc::new(Inbox::default());
        let (output, complaints) = (child.stdout.take().unwrap(), child.stderr.take().unwrap());
        let sorted = Arc::clone(&inbox);
        thread::spawn(move || {
            sorted.sort(BufReader::new(output));
            let _ = child.wait();
        });
        let told = Arc::clone(&inbox);
        thread::spawn(move || told.listen(BufReader::new(complaints)));
        let chromium = Self { input, next: AtomicU64::new(1), inbox };
        chromium.call(None, "Browser.getVersion", &json!({}));
        chromium
    }

    /// Sends a command to the browser or to one of its tabs, and waits for the result.
    #[track_caller]
    pub(crate) fn call(&self, session: Option<&str>, method: &str, parameters: &Value) -> Value {
        let id = self.next.fetch_add(1, Ordering::Relaxed);
        let mut message = json!({ "id": id, "method": method, "params": parameters });
        if let Some(session) = session {
            message["sessionId"] = session.into();
        }
        let mut bytes = serde_json::to_vec(&message).unwrap();
        bytes.push(0);
        // where the pipe is broken, the inbox knows that the browser has ended, and what it said
        let _ = self.input.lock().unwrap().write_all(&bytes);
        let mut answer = self.inbox.wait(method, |mail| mail.answers.remove(&id));
        if let Some(error) = answer.get("error") {
            panic!("{method} {parameters}: {error}");
        }
        answer["result"].take()
    }

    /// Waits for an event of a tab and takes it; the events before it stay.
    #[track_caller]
    pub(crate) fn event(&self, session: &str, method: &str) -> Value {
        self.inbox.wait(method, |mail| {
            let events = mail.events.get_mut(session)?;
            let at = events.iter().position(|event| event["method"] == method)?;
            Some(events.remove(at)["params"].take())
        })
    }

    /// Takes the events of a tab that have one of the names, as they came.
    pub(crate) fn events(&self, session: &str, methods: &[&str]) -> Vec<Value> {
        let mut mail = self.inbox.mail.lock().unwrap();
        let Some(events) = mail.events.get_mut(session) else { return Vec::new() };
        let wanted = |event: &mut Value| methods.iter().any(|method| event["method"] == *method);
        events.extract_if(.., wanted).collect()
    }

    /// Throws away what a tab said that is no more.
    pub(crate) fn forget(&self, session: &str) {
        // a test that fails while it holds the lock must not fail again here
        if let Ok(mut mail) = self.inbox.mail.lock() {
            mail.events.remove(session);
        }
    }
}

impl Inbox {
    #[track_caller]
    fn wait<T>(&self, what: &str, mut take: impl FnMut(&mut Mail) -> Option<T>) -> T {
        let mut taken = None;
        let mail = self.mail.lock().unwrap();
        let (mail, _) = self
            .arrived
            .wait_timeout_while(mail, PATIENCE, |mail| {
                taken = take(mail);
                taken.is_none() && !mail.ended
            })
            .unwrap();
        let (ended, complaints) = (mail.ended, mail.complaints.clone());
        drop(mail);
        match taken {
            Some(taken) => taken,
            None if ended => panic!("chromium has ended, {what} is not answered; it said:\n{complaints}"),
            None => panic!("no {what} within {PATIENCE:?}; chromium said:\n{complaints}"),
        }
    }

    fn sort(&self, mut output: impl BufRead) {
        let mut bytes = Vec::new();
        while output.read_until(0, &mut bytes).is_ok_and(|read| read > 0) {
            bytes.pop();
            let message: Value = serde_json::from_slice(&bytes).unwrap_or_default();
            bytes.clear();
            let mut mail = self.mail.lock().unwrap();
            if let Some(id) = message["id"].as_u64() {
                mail.answers.insert(id, message);
            } else if let Some(session) = message["sessionId"].as_str() {
                mail.events.entry(session.to_owned()).or_default().push(message);
            }
            self.arrived.notify_all();
        }
        self.mail.lock().unwrap().ended = true;
        self.arrived.notify_all();
    }

    /// Keeps what the browser says of itself, as far as anybody would read it.
    fn listen(&self, complaints: impl BufRead) {
        for line in complaints.split(b'\n').map_while(Result::ok) {
            let line = String::from_utf8_lossy(&line);
            let mut mail = self.mail.lock().unwrap();
            // that there is no desktop is said a hundred times
            if mail.complaints.len() < 16 * 1024 && !line.contains("dbus/") {
                mail.complaints.push_str(&line);
                mail.complaints.push('\n');
            }
        }
    }
}

/// The program: what `OBJDICT_CHROMIUM` says, else the first of the usual names in `PATH`.
fn executable() -> Option<PathBuf> {
    if let Some(path) = env::var_os("OBJDICT_CHROMIUM") {
        // an empty one says that these tests are to be skipped
        return Some(PathBuf::from(path)).filter(|path| !path.as_os_str().is_empty());
    }
    let names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
    let folders: Vec<PathBuf> = env::split_paths(&env::var_os("PATH")?).collect();
    let mut paths = names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    paths.find(|path| path.is_file())
}

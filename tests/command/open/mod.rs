//! `objdict open`: requests as bytes, and what is on the disk afterwards. The page is another one (page.html); web/test has the workbench.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

/// The command with a folder of its own, where it serves what the arguments name.
struct Server {
    process: Child,
    folder: tempfile::TempDir,
    port: u16,
    token: String,
}

struct Answer {
    status: u16,
    head: String,
    body: Vec<u8>,
}

const DRIVE: &str = "fixtures/eds/drive-402.eds";

impl Server {
    fn start(arguments: &str, prepare: impl FnOnce(&Path)) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::copy(DRIVE, folder.path().join("drive.eds")).unwrap();
        prepare(folder.path());
        let mut process = command(folder.path(), arguments).stdout(Stdio::piped()).spawn().unwrap();
        let mut address = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut address).unwrap();
        let rest = address.trim().strip_prefix("http://127.0.0.1:").unwrap_or_else(|| panic!("{address}"));
        let (port, token) = rest.trim_end_matches('/').split_once('/').unwrap();
        assert_eq!(token.len(), 32);
        let (port, token) = (port.parse().unwrap(), token.to_owned());
        Self { process, folder, port, token }
    }

    /// Sends bytes, with what they mean of the server, and returns the answer; `None` if there is none.
    fn send(&self, request: &str) -> Option<Answer> {
        let request =
            request.replace("HOST", &format!("127.0.0.1:{}", self.port)).replace("TOKEN", &self.token);
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        // what refuses a request may not read all of it
        let _ = stream.write_all(request.as_bytes());
        let mut bytes = Vec::new();
        let _ = stream.read_to_end(&mut bytes);
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n")? + 4;
        let head = String::from_utf8(bytes[..end].to_vec()).unwrap();
        let status = head.strip_prefix("HTTP/1.1 ")?.get(..3)?.parse().ok()?;
        Some(Answer { status, head, body: bytes[end..].to_vec() })
    }

    fn get(&self, path: &str) -> Answer {
        self.send(&format!("GET /TOKEN/{path} HTTP/1.1\r\nHost: HOST\r\n\r\n")).unwrap()
    }

    fn put(&self, path: &str, tag: &str, body: &str) -> Answer {
        let head = "Host: HOST\r\nOrigin: http://HOST\r\nIf-Match:";
        let length = body.len();
        self.send(&format!(
            "PUT /TOKEN/{path} HTTP/1.1\r\n{head} {tag}\r\nContent-Length: {length}\r\n\r\n{body}"
        ))
        .unwrap()
    }

    fn list(&self) -> Vec<Value> {
        let answer = self.get("files");
        assert_eq!(answer.status, 200);
        serde_json::from_slice::<Value>(&answer.body).unwrap()["files"].as_array().unwrap().clone()
    }

    fn names(&self) -> Vec<String> {
        self.list().iter().map(|file| file["name"].as_str().unwrap().replace('\\', "/")).collect()
    }

    fn disk(&self, name: &str) -> Vec<u8> {
        fs::read(self.folder.path().join(name)).unwrap()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.process.kill().unwrap();
        self.process.wait().unwrap();
    }
}

impl Answer {
    fn header(&self, name: &str) -> &str {
        let line = self.head.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(": "));
        line.unwrap_or_else(|| panic!("no {name}: {}", self.head))
    }

    fn message(&self) -> String {
        let answer: Value = serde_json::from_slice(&self.body).unwrap();
        format!("{} {}", answer["error"]["message"], answer["error"]["help"])
    }
}

fn command(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(crate::program());
    command.arg("open").args(arguments.split_whitespace()).current_dir(folder);
    command.env("OBJDICT_WORKBENCH", concat!(env!("CARGO_MANIFEST_DIR"), "/tests/command/open/page.html"));
    command.stdin(Stdio::null()).stderr(Stdio::null());
    command
}

#[test]
fn the_page_may_ask_for_its_files_and_nothing_else() {
    let server = Server::start("--no-browser drive.eds", |_| {});
    let page = server.get("");
    let text = String::from_utf8(page.body).unwrap();
    assert!(text.contains(r#"content="default-src 'none'; connect-src 'self'; base-uri"#), "{text}");
    assert!(text.contains(r#"<meta name="objdict-files" content="files">"#), "{text}");
    let list = server.list();
    assert_eq!(list.len(), 1);
    assert_eq!((&list[0]["name"], &list[0]["is_open"]), (&"drive.eds".into(), &true.into()));
    let file = server.get("files/0");
    assert_eq!(file.body, server.disk("drive.eds"));
    for answer in [&file, &server.get("files"), &server.get("files/1")] {
        assert_eq!(answer.header("Cache-Control"), "no-store");
        assert_eq!(answer.header("X-Content-Type-Options"), "nosniff");
    }
}

/// What is refused, as bytes: each with the status, `0` for no answer.
const REFUSED: &[(u16, &str)] = &[
    (403, "GET / HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (403, "GET /files HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (403, "GET /TOKEN HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (403, "GET /0TOKEN/files HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (403, "GET /00000000000000000000000000000000/files HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (403, "GET //TOKEN/files HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (403, "GET http://HOST/TOKEN/files HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (403, "GET /TOKEN/files HTTP/1.1\r\n\r\n"),
    (403, "GET /TOKEN/files HTTP/1.1\r\nHost: example.com\r\n\r\n"),
    (403, "GET /TOKEN/files HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"),
    (403, "GET /TOKEN/files HTTP/1.1\r\nHost: HOST.example.com\r\n\r\n"),
    (403, "GET /TOKEN/files HTTP/1.1\r\nHost: HOST\r\nOrigin: http://example.com\r\n\r\n"),
    (403, "GET /TOKEN/files HTTP/1.1\r\nHost: HOST\r\nOrigin: null\r\n\r\n"),
    (403, "PUT /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nIf-Match: ETAG\r\nContent-Length: 1\r\n\r\nx"),
    (
        403,
        "PUT /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nOrigin: https://HOST\r\nIf-Match: ETAG\r\nContent-Length: 1\r\n\r\nx",
    ),
    (403, "POST /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nContent-Length: 1\r\n\r\nx"),
    (404, "GET /TOKEN/files/1 HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (404, "GET /TOKEN/files/ HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (404, "GET /TOKEN/files/-1 HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (404, "GET /TOKEN/files/99999999999999999999999 HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (404, "GET /TOKEN/secret.eds HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (404, "GET /TOKEN/files/secret.eds HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (404, "GET /TOKEN/files/../secret.eds HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (404, "GET /TOKEN/../../../../etc/passwd HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (404, "GET /TOKEN/%2e%2e/secret.eds HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (404, "GET /TOKEN//etc/passwd HTTP/1.1\r\nHost: HOST\r\n\r\n"),
    (
        404,
        "PUT /TOKEN/files/../secret.eds HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\nContent-Length: 1\r\n\r\nx",
    ),
    (404, "PUT /TOKEN/ HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\nContent-Length: 1\r\n\r\nx"),
    (405, "DELETE /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\n\r\n"),
    (428, "PUT /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\nContent-Length: 1\r\n\r\nx"),
    (
        412,
        "PUT /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\nIf-Match: *\r\nContent-Length: 1\r\n\r\nx",
    ),
    (411, "PUT /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\nIf-Match: ETAG\r\n\r\n"),
    (
        411,
        "PUT /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\nIf-Match: ETAG\r\nTransfer-Encoding: chunked\r\nContent-Length: 1\r\n\r\nx",
    ),
    (
        400,
        "PUT /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\nIf-Match: ETAG\r\nContent-Length: +1\r\n\r\nx",
    ),
    (
        400,
        "PUT /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\nIf-Match: ETAG\r\nContent-Length: 1\r\nContent-Length: 2\r\n\r\nxx",
    ),
    (
        413,
        "PUT /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\nIf-Match: ETAG\r\nContent-Length: 100001\r\n\r\n",
    ),
    (
        413,
        "PUT /TOKEN/files/0 HTTP/1.1\r\nHost: HOST\r\nOrigin: http://HOST\r\nIf-Match: ETAG\r\nContent-Length: 18446744073709551615\r\n\r\n",
    ),
    (400, "GET /TOKEN/files\r\nHost: HOST\r\n\r\n"),
    (400, "GET /TOKEN/files FTP/1.1\r\nHost: HOST\r\n\r\n"),
    (400, "GET /TOKEN/files HTTP/1.1\r\nHost: HOST\r\nHost: example.com\r\n\r\n"),
    (400, "GET /TOKEN/files HTTP/1.1\r\nHost : HOST\r\n\r\n"),
    (400, "GET /TOKEN/files HTTP/1.1\r\nHost: HOST\r\n folded\r\n\r\n"),
    (400, "\r\n"),
    (400, "\u{0}\u{1}\r\n\r\n"),
];

#[test]
fn what_is_refused_changes_nothing() {
    let server = Server::start("--no-browser --max-size 100000 drive.eds", |folder| {
        fs::write(folder.join("secret.eds"), "secret").unwrap();
    });
    let before = server.disk("drive.eds");
    let tag = server.get("files/0").header("ETag").to_owned();
    for (status, request) in REFUSED {
        let answer =
            server.send(&request.replace("ETAG", &tag)).unwrap_or_else(|| panic!("no answer: {request}"));
        assert_eq!(answer.status, *status, "{request}{}", answer.message());
        assert!(!String::from_utf8_lossy(&answer.body).contains(&server.token), "{request}");
    }
    let long = format!("GET /TOKEN/ HTTP/1.1\r\nHost: HOST\r\nCookie: {}\r\n\r\n", "x".repeat(40_000));
    assert_eq!(server.send(&long).unwrap().status, 431);
    assert_eq!(server.disk("drive.eds"), before);
    assert_eq!(server.disk("secret.eds"), b"secret");
    assert_eq!(fs::read_dir(server.folder.path()).unwrap().count(), 2);
    // and the next one is answered
    assert_eq!(server.get("files/0").body, before);
}

#[test]
fn a_file_is_replaced_if_it_is_as_it_was_read() {
    let server = Server::start("--no-browser drive.eds", |_| {});
    let old = server.get("files/0").header("ETag").to_owned();
    let saved = server.put("files/0", &old, "[FileInfo]\r\n");
    assert_eq!(saved.status, 200);
    assert_eq!(server.disk("drive.eds"), b"[FileInfo]\r\n");
    assert_eq!(saved.header("ETag"), server.get("files/0").header("ETag"));
    let refused = server.put("files/0", &old, "[DeviceInfo]\r\n");
    assert_eq!(refused.status, 412);
    assert!(
        refused.message().contains("`drive.eds` was changed by a different program"),
        "{}",
        refused.message()
    );
    fs::write(server.folder.path().join("drive.eds"), "; by hand\r\n").unwrap();
    assert_eq!(server.put("files/0", saved.header("ETag"), "[DeviceInfo]\r\n").status, 412);
    assert_eq!(server.disk("drive.eds"), b"; by hand\r\n");
    fs::remove_file(server.folder.path().join("drive.eds")).unwrap();
    assert_eq!(server.get("files/0").status, 404);
    assert_eq!(server.put("files/0", saved.header("ETag"), "[DeviceInfo]\r\n").status, 404);
    assert_eq!(fs::read_dir(server.folder.path()).unwrap().count(), 0, "no temporary file is left");
}

#[cfg(unix)]
#[test]
fn links_lead_to_no_other_file() {
    use std::os::unix::fs::symlink;
    let outside = tempfile::tempdir().unwrap();
    let secret = outside.path().join("secret.eds");
    fs::copy(DRIVE, &secret).unwrap();
    let server =
        Server::start("--no-browser .", |folder| symlink(&secret, folder.join("linked.eds")).unwrap());
    assert_eq!(server.names(), ["drive.eds", "linked.eds"]);
    // it is shown, as `check` shows it, and not changed
    let tag = server.get("files/1").header("ETag").to_owned();
    assert_eq!(server.put("files/1", &tag, "x").status, 403);
    let drive = server.folder.path().join("drive.eds");
    fs::remove_file(&drive).unwrap();
    symlink(&secret, &drive).unwrap();
    assert_eq!(server.get("files/0").status, 404);
    assert_eq!(server.put("files/0", &tag, "x").status, 404);
    assert_eq!(fs::read(&secret).unwrap(), fs::read(DRIVE).unwrap());
}

#[test]
fn a_folder_is_its_descriptions_and_networks() {
    let network = "[bus]\nbit-rate = 250\n[node.a]\nnode-id = 5\nfile = \"drive.eds\"\n[node.b]\nnode-id = 6\nfile = \"parts/io.eds\"\n";
    let server = Server::start("--no-browser", |folder| {
        fs::create_dir_all(folder.join("parts")).unwrap();
        fs::create_dir_all(folder.join(".git")).unwrap();
        fs::copy("fixtures/eds/io-401.eds", folder.join("parts/io.eds")).unwrap();
        fs::copy(DRIVE, folder.join(".hidden.eds")).unwrap();
        fs::write(folder.join("network.toml"), network).unwrap();
        fs::write(folder.join("Cargo.toml"), "[package]\nname = \"a\"\n").unwrap();
        fs::write(folder.join("notes.txt"), "[FileInfo]\n").unwrap();
    });
    assert_eq!(server.names(), ["drive.eds", "network.toml", "parts/io.eds"]);
    let list = server.list();
    assert_eq!((&list[1]["kind"], &list[1]["nodes"]), (&"network".into(), &serde_json::json!([0, 2])));
    assert!(list.iter().all(|file| file["is_open"] == false));
    // alone it brings its descriptions
    let folder = server.folder.path();
    let alone = Server::start("--no-browser network.toml", |other| {
        fs::write(other.join("network.toml"), network).unwrap();
        fs::create_dir_all(other.join("parts")).unwrap();
        fs::copy(folder.join("parts/io.eds"), other.join("parts/io.eds")).unwrap();
        fs::write(other.join("other.eds"), "[FileInfo]\n").unwrap();
    });
    assert_eq!(alone.names(), ["network.toml", "drive.eds", "parts/io.eds"]);
    assert_eq!(alone.get("files/2").body, server.disk("parts/io.eds"));
}

#[test]
fn of_several_writers_one_is_first() {
    let server = Server::start("--no-browser drive.eds", |_| {});
    let idle: Vec<TcpStream> =
        (0..16).map(|_| TcpStream::connect(("127.0.0.1", server.port)).unwrap()).collect();
    let tag = server.get("files/0").header("ETag").to_owned();
    let statuses: Vec<(u16, String)> = thread::scope(|scope| {
        let writers = (0..8).map(|number| {
            let (server, tag) = (&server, &tag);
            scope.spawn(move || {
                let text = format!("; {number}\r\n").repeat(1000);
                assert_eq!(server.get("files").status, 200);
                (server.put("files/0", tag, &text).status, text)
            })
        });
        let writers: Vec<_> = writers.collect();
        writers.into_iter().map(|writer| writer.join().unwrap()).collect()
    });
    let first: Vec<&String> =
        statuses.iter().filter(|(status, _)| *status == 200).map(|(_, text)| text).collect();
    assert_eq!(first.len(), 1, "{statuses:?}");
    assert_eq!(server.disk("drive.eds"), first[0].as_bytes());
    assert_eq!(statuses.iter().filter(|(status, _)| *status == 412).count(), 7);
    drop(idle);
}

#[test]
fn connections_that_say_nothing_keep_no_one_out() {
    let server = Server::start("--no-browser drive.eds", |_| {});
    let connect = |_| TcpStream::connect(("127.0.0.1", server.port)).unwrap();
    let mut idle: Vec<TcpStream> = (0..100).map(connect).collect();
    idle.iter_mut().for_each(|stream| _ = stream.write_all(b"GET /"));
    let start = Instant::now();
    assert_eq!(server.get("files").status, 200);
    assert!(start.elapsed() < Duration::from_secs(8), "heads may take ten seconds");
    // the oldest are closed when others come, and all of them after a time
    for stream in &mut idle {
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        assert!(matches!(stream.read(&mut [0]), Ok(0) | Err(_)));
    }
    assert_eq!(server.get("files").status, 200);
}

#[test]
fn python_reads_and_saves() {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/command/open/client.py");
    let server = Server::start("--no-browser --max-size 100000 drive.eds", |_| {});
    let address = format!("http://127.0.0.1:{}/{}/", server.port, server.token);
    let output = Command::new("python3").arg(script).arg(address).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let (before, after) = (fs::read(DRIVE).unwrap(), server.disk("drive.eds"));
    assert_eq!(before.iter().zip(&after).filter(|(one, other)| one != other).count(), "dv".len());
}

/// What the command prints when it does not serve.
fn refusal(folder: &Path, arguments: &str) -> String {
    let output = command(folder, arguments).stderr(Stdio::piped()).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn what_cannot_be_served_is_said_at_once() {
    let server = Server::start("--no-browser drive.eds", |_| {});
    let folder = server.folder.path();
    assert!(refusal(folder, "--no-browser none.eds").contains("`none.eds`"));
    assert!(refusal(folder, "--no-browser drive.eds none/*.eds").contains("no file matches `none/*.eds`"));
    assert!(refusal(folder, "--no-browser -").contains("`<stdin>` is not a file"));
    let taken = refusal(folder, &format!("--no-browser --port {} drive.eds", server.port));
    assert!(
        taken.contains(&format!("cannot listen on port {}", server.port)) && taken.contains("--port"),
        "{taken}"
    );
}

#[cfg(unix)]
#[test]
fn a_browser_is_started_and_a_signal_ends_it() {
    use std::os::unix::fs::PermissionsExt;
    let programs = tempfile::tempdir().unwrap();
    let browser = programs.path().join(if cfg!(target_os = "macos") { "open" } else { "xdg-open" });
    fs::write(&browser, "#!/bin/sh\nprintf %s \"$1\" > started.new && mv started.new started\n").unwrap();
    fs::set_permissions(&browser, fs::Permissions::from_mode(0o755)).unwrap();
    let folder = tempfile::tempdir().unwrap();
    fs::copy(DRIVE, folder.path().join("drive.eds")).unwrap();
    let path = format!("{}:{}", programs.path().display(), std::env::var("PATH").unwrap());
    let mut process =
        command(folder.path(), "drive.eds").env("PATH", path).stdout(Stdio::piped()).spawn().unwrap();
    let mut address = String::new();
    BufReader::new(process.stdout.take().unwrap()).read_line(&mut address).unwrap();
    let started = folder.path().join("started");
    wait_until(|| started.exists());
    // every user can read the arguments, and nobody else the file
    let page = PathBuf::from(fs::read_to_string(&started).unwrap());
    assert!(fs::read_to_string(&page).unwrap().contains(&format!("url={}\"", address.trim())));
    let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
    assert_eq!((mode(&page), mode(page.parent().unwrap())), (0o600, 0o700));
    let (host, path) = address.trim().strip_prefix("http://").unwrap().split_once('/').unwrap();
    let mut stream = TcpStream::connect(host).unwrap();
    write!(stream, "GET /{path} HTTP/1.1\r\nHost: {host}\r\n\r\n").unwrap();
    stream.read_to_end(&mut Vec::new()).unwrap();
    wait_until(|| !page.parent().unwrap().exists());
    assert!(Command::new("kill").args(["-TERM", &process.id().to_string()]).status().unwrap().success());
    assert!(!process.wait().unwrap().success());
}

#[cfg(unix)]
fn wait_until(holds: impl Fn() -> bool) {
    let wait = |_: &i32| {
        holds() || {
            thread::sleep(Duration::from_millis(100));
            false
        }
    };
    (0..600).find(wait).unwrap();
}

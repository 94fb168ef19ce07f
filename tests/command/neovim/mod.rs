//! Neovim of Debian 12 with `objdict lsp`, driven by keys: what it shows, and the bytes that it writes.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::support::skips::skip_unless_ci;

mod screen;

/// So long an answer may take on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// An editor with a file of a folder of its own.
struct Neovim {
    process: Child,
    folder: tempfile::TempDir,
    file: &'static str,
}

/// The version of Neovim, such as `v0.7.2`; `None` says that the test is skipped.
fn version() -> Option<String> {
    let output = Command::new("nvim").arg("--version").output().ok();
    let printed = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    let version = printed.and_then(|text| Some(text.lines().next()?.strip_prefix("NVIM ")?.to_owned()));
    if version.is_none() {
        skip_unless_ci("no `nvim`: install the package `neovim`");
    }
    version
}

impl Neovim {
    /// Opens a file with a text.
    fn open(file: &'static str, text: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(file), text).unwrap();
        let init = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/command/neovim/init.lua");
        let process = Command::new("nvim")
            .args(["--headless", "--clean", "--listen", "socket", "-u"])
            .arg(init)
            .arg(file)
            .env("OBJDICT", crate::program())
            .envs(["XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"].map(|name| (name, folder.path())))
            .current_dir(folder.path())
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let neovim = Self { process, folder, file };
        let start = Instant::now();
        while !neovim.path("socket").exists() {
            assert!(start.elapsed() < PATIENCE, "Neovim does not start");
            sleep(Duration::from_millis(20));
        }
        neovim.until("luaeval('vim.tbl_count(vim.lsp.buf_get_clients(0))')", "1");
        neovim
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn remote(&self, option: &str, text: &str) -> String {
        let mut command = Command::new("nvim");
        command.args(["--server", "socket", option, text]).current_dir(self.folder.path());
        let output = command.output().unwrap();
        // version 0.7 prints a value to the standard error
        format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
    }

    /// Presses keys.
    fn keys(&self, keys: &str) {
        self.remote("--remote-send", keys);
    }

    /// The value of an expression.
    fn value(&self, expression: &str) -> String {
        self.remote("--remote-expr", expression)
    }

    /// Waits for a value of an expression that meets a condition.
    fn wait(&self, expression: &str, is_met: impl Fn(&str) -> bool) -> String {
        let start = Instant::now();
        loop {
            let value = self.value(expression);
            if is_met(&value) {
                return value;
            }
            assert!(
                start.elapsed() < PATIENCE,
                "`{expression}` is {value}; messages: {}",
                self.value("execute('messages')")
            );
            sleep(Duration::from_millis(50));
        }
    }

    fn until(&self, expression: &str, wanted: &str) {
        self.wait(expression, |value| value == wanted);
    }

    /// Calls a function of `screen.lua`.
    fn call(&self, function: &str, is_met: impl Fn(&str) -> bool) -> String {
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/command/neovim/screen.lua");
        self.wait(&format!("luaeval(\"dofile('{}').{function}()\")", script.display()), is_met)
    }

    /// The messages of the findings, in the order of their lines.
    fn findings(&self, is_met: impl Fn(&[String]) -> bool) -> Vec<String> {
        let of = |value: &str| serde_json::from_str::<Vec<String>>(value).unwrap_or_default();
        let found = "luaeval(\"vim.fn.json_encode(vim.tbl_map(function(found) return found.message end, vim.diagnostic.get(0)))\")";
        of(&self.wait(found, |value| value.starts_with('[') && is_met(&of(value))))
    }

    /// The bytes of the file, after it is written.
    fn written(&self) -> String {
        self.keys("<Esc>:silent write<CR>");
        self.until("&modified", "0");
        fs::read_to_string(self.path(self.file)).unwrap()
    }
}

impl Drop for Neovim {
    fn drop(&mut self) {
        // without a window nothing is asked
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// What the command prints for a file, and whether it succeeds.
fn objdict(folder: &Path, arguments: &[&str]) -> String {
    let output = Command::new(crate::program()).args(arguments).current_dir(folder).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

/// A drive, as Neovim reads it.
fn drive() -> String {
    fs::read_to_string("fixtures/eds/drive-402.eds").unwrap().replace('\r', "")
}

/// The keys that go to a line.
fn to(line: &str) -> String {
    format!("<Esc>:call search('^{line}$', 'w')<CR>")
}

#[test]
fn findings_are_those_of_check_and_a_fix_is_a_key_away() {
    if version().is_none() {
        return;
    }
    let text = drive().replacen("AccessType=ro", "AccessType = ro", 1);
    let neovim = Neovim::open("drive-402.eds", &text);
    let found = neovim.findings(|found| !found.is_empty());
    let checked = objdict(neovim.folder.path(), &["check", "drive-402.eds", "--format", "json"]);
    let checked: serde_json::Value = serde_json::from_str(&checked).unwrap();
    let message = checked.pointer("/0/message").or_else(|| checked.pointer("/findings/0/message"));
    let message = message.and_then(serde_json::Value::as_str).unwrap_or_else(|| panic!("{checked}"));
    assert!(found.len() == 1 && found[0].starts_with(message), "{found:?} {message}");
    neovim.keys(&format!("{}:lua vim.lsp.buf.code_action()<CR>", to("AccessType = ro")));
    assert_eq!(neovim.findings(<[String]>::is_empty), [] as [String; 0]);
    assert_eq!(neovim.written(), drive().replacen("AccessType=ro", "AccessType= ro", 1));
}

#[test]
fn a_mapping_is_explained_completed_and_renamed() {
    if version().is_none() {
        return;
    }
    let neovim = Neovim::open("drive-402.eds", &drive());
    neovim.keys(&format!("{}$:lua vim.lsp.buf.hover()<CR>", to("DefaultValue=0x60410010")));
    let said = neovim.call("floating", |text| !text.is_empty());
    assert!(said.contains("Statusword") && said.contains("6041h"), "{said}");
    // the value is typed again: the list has the entries that a TPDO carries
    neovim.keys("<Esc>0f=C=0x604<C-x><C-o>");
    neovim.until("pumvisible()", "1");
    let items = neovim.value("json_encode(map(complete_info(['items']).items, 'v:val.word'))");
    assert!(items.contains("0x60410010") && !items.contains("0x60400010"), "{items}");
    neovim.keys("<C-y>");
    assert_eq!(neovim.written(), drive());
    neovim.keys(&format!("{}l:lua vim.lsp.buf.rename('2041')<CR>", to("\\[6041\\]")));
    neovim.until("search('60410010', 'wn')", "0");
    assert_eq!(neovim.written(), drive().replace("6041", "2041"));
}

#[test]
fn formatting_is_that_of_fmt() {
    if version().is_none() {
        return;
    }
    let text = drive().replace("DataType=", "datatype=");
    let neovim = Neovim::open("drive-402.eds", &text);
    neovim.keys("<Esc>:lua vim.lsp.buf.formatting_sync(nil, 60000)<CR>");
    neovim.until("search('datatype=', 'wn')", "0");
    let written = neovim.written();
    let beside = tempfile::tempdir().unwrap();
    fs::write(beside.path().join("drive-402.eds"), text).unwrap();
    objdict(beside.path(), &["fmt", "drive-402.eds"]);
    assert_eq!(written, fs::read_to_string(beside.path().join("drive-402.eds")).unwrap());
}

//! Pages that the command makes, opened.

use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

use crate::support::fixtures;
use crate::tab::Tab;

/// A page in a tab. When it is dropped, it must have complained of nothing and asked for nothing.
pub(crate) struct Page {
    tab: Tab,
    pub(crate) path: PathBuf,
    _folder: TempDir,
}

impl Page {
    /// The page of a fixture at a fragment; `None` where there is no browser.
    pub(crate) fn open(fixture: &str, fragment: &str) -> Option<Self> {
        Self::with(&fixtures().join(fixture), &[], fragment)
    }

    /// The page of a description, made with options.
    pub(crate) fn with(description: &Path, options: &[&str], fragment: &str) -> Option<Self> {
        Some(Self::in_tab(Tab::new()?, description, options, fragment))
    }

    /// The page of a fixture, at a fragment, in a browser that runs no script.
    pub(crate) fn without_script(fixture: &str, fragment: &str) -> Option<Self> {
        let tab = Tab::new()?;
        tab.without_script();
        Some(Self::in_tab(tab, &fixtures().join(fixture), &[], fragment))
    }

    fn in_tab(tab: Tab, description: &Path, options: &[&str], fragment: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("page.html");
        make(description, options, &path);
        tab.open(&path, fragment);
        Self { tab, path, _folder: folder }
    }

    /// The page of what changes between two fixtures.
    pub(crate) fn of_changes(old: &str, new: &str) -> Option<Self> {
        Self::printed("diff", &[old, new])
    }

    /// The page that a command prints about fixtures.
    pub(crate) fn printed(command: &str, names: &[&str]) -> Option<Self> {
        let tab = Tab::new()?;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("page.html");
        let paths = names.iter().map(|name| fixtures().join(name));
        let mut program = Command::new(env!("CARGO_BIN_EXE_objdict"));
        let output = program.args([command, "--format", "html"]).args(paths).output().unwrap();
        std::fs::write(&path, output.stdout).unwrap();
        tab.open(&path, "");
        Some(Self { tab, path, _folder: folder })
    }

    /// The page of logs, made by `objdict decode` with these arguments.
    pub(crate) fn of_logs(tab: Tab, arguments: &[&str]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("page.html");
        let mut program = Command::new(env!("CARGO_BIN_EXE_objdict"));
        let output = program.arg("decode").args(arguments).arg("--html").arg(&path).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        tab.open(&path, "");
        Self { tab, path, _folder: folder }
    }

    /// The page that a command writes to a path.
    pub(crate) fn made(command: impl FnOnce(&Path) -> Command) -> Option<Self> {
        let tab = Tab::new()?;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("page.html");
        command(&path).output().unwrap();
        tab.open(&path, "");
        Some(Self { tab, path, _folder: folder })
    }

    /// The anchors of the objects that are to be seen.
    pub(crate) fn objects(&self) -> Vec<String> {
        self.texts("[...document.querySelectorAll('.o')].filter(of => of.checkVisibility()).map(of => of.id)")
    }

    /// The anchors of the rows that are to be seen below an object.
    pub(crate) fn rows(&self, object: &str) -> Vec<String> {
        self.texts(&format!(
            "[...document.getElementById('{object}').querySelectorAll('tbody tr')]
                .filter(row => row.checkVisibility({{ contentVisibilityAuto: false }}) && row.closest('details').open)
                .map(row => row.id)"
        ))
    }
}

impl Deref for Page {
    type Target = Tab;

    fn deref(&self) -> &Tab {
        &self.tab
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        if !std::thread::panicking() {
            assert_eq!(self.tab.complaints(), [""; 0]);
            assert_eq!(self.tab.requests(), [""; 0]);
        }
    }
}

/// Writes the page of a description, or the site of a folder of them.
pub(crate) fn make(description: &Path, options: &[&str], path: &Path) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_objdict"));
    command.args(["docs", "--format", "html"]).args(options).arg("-o").arg(path).arg(description);
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {said}", description.display());
}

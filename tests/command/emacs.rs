//! Emacs of Debian 12 with Eglot and the configuration of docs/guides/editors.md: what arrives, and the bytes that it writes.

use std::fs;
use std::process::Command;

use serde_json::Value;

use crate::support::skips::skip_unless_ci;

/// The block of `docs/guides/editors.md` in this language.
fn configuration(language: &str) -> String {
    let page = fs::read_to_string("docs/guides/editors.md").unwrap();
    let (_, block) = page.split_once(&format!("```{language}\n")).unwrap();
    block.split_once("```").unwrap().0.to_owned()
}

/// Whether Emacs has Eglot.
fn has_eglot() -> bool {
    let packages = "(progn (require 'package) (package-initialize) (require 'eglot))";
    let found = Command::new("emacs").args(["--batch", "--eval", packages]).output();
    let is_there = found.is_ok_and(|output| output.status.success());
    if !is_there {
        skip_unless_ci("no Emacs with Eglot: install the packages `emacs-nox` and `elpa-eglot`");
    }
    is_there
}

#[test]
fn the_configuration_of_the_page_finds_completes_and_renames() {
    if !has_eglot() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let (file, lisp) = (folder.path().join("drive-402.eds"), folder.path().join("init.el"));
    let drive = fs::read_to_string("fixtures/eds/drive-402.eds").unwrap().replace('\r', "");
    let broken = drive.replacen("AccessType=ro", "AccessType=rx", 1);
    fs::write(&file, &broken).unwrap();
    fs::write(&lisp, configuration("lisp")).unwrap();
    let program = std::path::Path::new(crate::program());
    let path = format!("{}:{}", program.parent().unwrap().display(), std::env::var("PATH").unwrap());
    let output = Command::new("emacs")
        .args(["--batch", "--load", "tests/command/emacs.el"])
        .envs([("FILE", file.as_os_str()), ("CONFIGURATION", lisp.as_os_str()), ("PATH", path.as_ref())])
        .env("HOME", folder.path())
        .output()
        .unwrap();
    let said: Value = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&output.stderr)));
    assert_eq!(said["mode"], "eds-mode");
    let texts = |of: &Value| -> Vec<String> { serde_json::from_value(of.clone()).unwrap() };
    let (findings, offered) = (texts(&said["findings"]), texts(&said["offered"]));
    assert!(findings.len() == 1 && findings[0].contains("`rx` is not a valid `AccessType`"), "{findings:?}");
    let has = |start: &str| offered.iter().any(|label| label.starts_with(start));
    assert!(has("0x20410010 Statusword") && !has("0x60400010"), "{offered:?}");
    assert_eq!(fs::read_to_string(&file).unwrap(), broken.replace("6041", "2041"));
}

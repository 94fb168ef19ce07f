//! Runs the lines of docs/install.md, each block with an empty home folder and no command in the path.
//!
//! A block follows a comment: `<!-- try NAME -->`, or `<!-- not here: REASON -->` for what cannot run. What a block leaves in its
//! home folder is removed.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::{make_folder, root, write};

/// What every block ends with: a finding of a rule, by the command that it installed.
const FINDING: &str = "cia306/invalid-value";

/// A block of the page.
#[derive(Debug, PartialEq)]
enum Block<'a> {
    Try { name: &'a str, script: &'a str },
    NotHere { reason: &'a str, script: &'a str },
}

/// Runs each block that can run here and lists the others.
pub(crate) fn try_out() -> Result<(), String> {
    let root = root();
    let page = root.join("docs/install.md");
    let text = fs::read_to_string(&page).map_err(|error| format!("{}: {error}", page.display()))?;
    let tried = root.join("target/dist/try");
    for block in blocks(&text)? {
        match block {
            Block::NotHere { reason, script } => {
                let line = script.lines().next().unwrap_or_default();
                println!("not here: `{line}`: {reason}");
            }
            Block::Try { name, script } => {
                if let Some(program) = missing(script) {
                    println!("{name}: there is no `{program}`: not tried");
                    continue;
                }
                let home = tried.join(name);
                fs::remove_dir_all(&home).ok();
                let took = run(name, script, &home, &root)?;
                println!("{name}: {:.1} s", took.as_secs_f64());
                fs::remove_dir_all(&home).map_err(|error| format!("{}: {error}", home.display()))?;
            }
        }
    }
    Ok(())
}

/// The blocks of the page in the language `sh`; each must say whether it runs.
fn blocks(page: &str) -> Result<Vec<Block<'_>>, String> {
    let mut blocks = Vec::new();
    let mut pieces = page.split("```sh\n");
    let mut before = pieces.next().unwrap_or_default();
    for piece in pieces {
        let (script, behind) = piece.split_once("```").unwrap_or((piece, ""));
        let comment = before.trim_end().rsplit('\n').next().unwrap_or_default();
        let comment =
            comment.strip_prefix("<!-- ").and_then(|rest| rest.strip_suffix(" -->")).unwrap_or_default();
        blocks.push(match (comment.strip_prefix("try "), comment.strip_prefix("not here: ")) {
            (Some(name), _) => Block::Try { name, script },
            (_, Some(reason)) => Block::NotHere { reason, script },
            _ => return Err(format!("docs/install.md: nothing says whether this is tried:\n{script}")),
        });
        before = behind;
    }
    Ok(blocks)
}

/// A program that a block needs and this machine lacks.
fn missing(script: &str) -> Option<&str> {
    let programs = script.lines().filter_map(|line| line.trim_start_matches("sudo ").split(' ').next());
    // `objdict` is what the block installs
    programs.filter(|program| !program.contains('/') && *program != "objdict").find(|program| {
        let found =
            Command::new("sh").args(["-c", "command -v \"$0\"", program]).stdout(Stdio::null()).status();
        !found.is_ok_and(|status| status.success())
    })
}

fn run(name: &str, script: &str, home: &Path, root: &Path) -> Result<Duration, String> {
    let programs = home.join("programs");
    substitutes(&programs, home)?;
    let mut path = vec![programs, home.join("bin"), home.join("root/usr/bin")];
    path.extend(std::env::split_paths(&std::env::var_os("PATH").unwrap_or_default()));
    let path = std::env::join_paths(path).map_err(|error| error.to_string())?;
    let mut bash = Command::new("bash");
    bash.args(["-e", "-u", "-c", script]).current_dir(root).env("HOME", home).env("PATH", path);
    // below the home folder, as the defaults of a user are
    bash.env("NPM_CONFIG_PREFIX", home).env("NPM_CONFIG_UPDATE_NOTIFIER", "false");
    // the compiler is no part of what is tried
    let cargo_home = std::env::var_os("CARGO_HOME").map(std::path::PathBuf::from);
    let of_user = |name| std::env::var_os("HOME").map(|home| Path::new(&home).join(name));
    if let Some(folder) = cargo_home.or_else(|| of_user(".cargo")) {
        bash.env("CARGO_HOME", folder);
    }
    if let Some(folder) = of_user(".rustup").filter(|folder| folder.exists()) {
        bash.env("RUSTUP_HOME", folder);
    }
    let start = Instant::now();
    let output = bash.stdin(Stdio::null()).output().map_err(|error| format!("bash: {error}"))?;
    let took = start.elapsed();
    let printed = String::from_utf8_lossy(&output.stdout);
    // the last line finds an error in a fixture
    if output.status.code() == Some(1) && printed.contains(FINDING) {
        return Ok(took);
    }
    let errors = String::from_utf8_lossy(&output.stderr);
    Err(format!("{name}: {}, and no finding `{FINDING}`:\n{script}\n{printed}\n{errors}", output.status))
}

/// Programs in front of others: what would change the machine changes the home folder, and what was built is not built again.
fn substitutes(folder: &Path, home: &Path) -> Result<(), String> {
    make_folder(&home.join("root/var/lib/dpkg/info"))?;
    make_folder(&home.join("root/var/lib/dpkg/updates"))?;
    write(&home.join("root/var/lib/dpkg/status"), b"")?;
    let cargo =
        format!("exec \"{}\" \"$@\" --debug --offline --target-dir target --root \"$HOME\"", env!("CARGO"));
    let programs = [
        ("sudo", "exec \"$@\""),
        ("dpkg", "exec /usr/bin/dpkg --root=\"$HOME/root\" --force-not-root \"$@\""),
        // that of a distribution is not in the folder of rustup
        ("cargo", cargo.as_str()),
    ];
    for (name, line) in programs {
        let file = folder.join(name);
        write(&file, format!("#!/bin/sh\n{line}\n").as_bytes())?;
        #[cfg(unix)]
        fs::set_permissions(&file, std::os::unix::fs::PermissionsExt::from_mode(0o755))
            .map_err(|error| format!("{}: {error}", file.display()))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_says_whether_it_runs() {
        let page = "a\n\n<!-- try one -->\n```sh\nx\n```\n\n<!-- not here: no y -->\n```sh\ny\n```\n";
        let expected =
            [Block::Try { name: "one", script: "x\n" }, Block::NotHere { reason: "no y", script: "y\n" }];
        assert_eq!(blocks(page).unwrap(), expected);
        assert!(blocks("a\n\n```sh\nx\n```\n").unwrap_err().contains("x\n"));
    }

    #[test]
    fn a_program_that_is_missing_is_named() {
        assert_eq!(missing("sudo sh -c x\n./own\nobjdict check\n"), None);
        assert_eq!(missing("sh\nno-such-program a\n"), Some("no-such-program"));
    }
}

//! The files that are meant by the arguments of a command: files, folders and patterns.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use ignore::WalkBuilder;

use super::Failure;

/// The endings of the descriptions that are looked for in folders.
const ENDINGS: [&str; 6] = ["eds", "dcf", "xdd", "xdc", "nxdd", "nxdc"];

/// A file that is meant.
#[derive(Debug)]
pub(super) struct File {
    /// Where it is.
    pub path: PathBuf,
    /// Whether an argument names it; else it was found in a folder or by a pattern.
    pub is_named: bool,
    /// Its size in bytes; 0 where that is not known.
    pub size: u64,
}

/// The files that are meant by the arguments, in their order, those of a folder sorted; and what could not be found. A
/// file that was found is there once, a file that is named is there as often as it is named.
pub(super) fn gather(arguments: &[PathBuf]) -> (Vec<File>, Vec<Failure>) {
    let mut gathered = Gathered::default();
    for argument in arguments {
        gathered.add(argument);
    }
    (gathered.files, gathered.failures)
}

#[derive(Default)]
struct Gathered {
    files: Vec<File>,
    failures: Vec<Failure>,
    seen: HashSet<PathBuf>,
}

impl Gathered {
    fn add(&mut self, argument: &Path) {
        if argument.is_dir() {
            let before = self.files.len();
            self.walk(argument);
            if self.files.len() == before {
                self.nothing_in(format_args!("there is no description in `{}`", argument.display()));
            }
        } else if is_pattern(argument) && !argument.exists() {
            self.expand(argument);
        } else {
            self.push(argument.to_owned(), true);
        }
    }

    /// The descriptions in a folder and below, but for what is hidden or named by a `.gitignore`.
    fn walk(&mut self, folder: &Path) {
        let mut walk = WalkBuilder::new(folder);
        walk.require_git(false).sort_by_file_name(Ord::cmp);
        for found in walk.build() {
            match found {
                Ok(found) if is_description(found.path()) && found.path().is_file() => {
                    // what is found in the current folder is called by its name
                    let path = found.path();
                    self.push(path.strip_prefix("./").unwrap_or(path).to_owned(), false);
                }
                Ok(_) => {}
                Err(error) => self.failures.push(Failure::new(error)),
            }
        }
    }

    /// The files that a pattern matches, whatever their ending, and the descriptions in the folders that it matches.
    fn expand(&mut self, pattern: &Path) {
        let shown = pattern.display();
        let matches = match glob::glob(&pattern.to_string_lossy()) {
            Ok(matches) => matches,
            Err(error) => {
                self.failures.push(Failure::new(format_args!("`{shown}` is no pattern: {}", error.msg)));
                return;
            }
        };
        let before = self.files.len();
        for found in matches {
            match found {
                Ok(path) if path.is_dir() => self.walk(&path),
                Ok(path) => self.push(path, false),
                Err(error) => self.failures.push(Failure::new(error)),
            }
        }
        if self.files.len() == before {
            self.nothing_in(format_args!("no file matches `{shown}`"));
        }
    }

    fn push(&mut self, path: PathBuf, is_named: bool) {
        if self.seen.insert(path.clone()) || is_named {
            let size = path.metadata().map_or(0, |metadata| metadata.len());
            self.files.push(File { path, is_named, size });
        }
    }

    fn nothing_in(&mut self, message: std::fmt::Arguments<'_>) {
        let endings: Vec<String> = ENDINGS.iter().map(|ending| format!(".{ending}")).collect();
        let help = format!(
            "descriptions end in {}; a file that is named is read whatever its ending",
            endings.join(", ")
        );
        self.failures.push(Failure::new(message).help(help));
    }
}

fn is_pattern(path: &Path) -> bool {
    path.to_string_lossy().contains(['*', '?', '['])
}

fn is_description(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default();
    ENDINGS.iter().any(|known| ending.eq_ignore_ascii_case(known))
}

//! The files that are meant by the arguments of a command: files, folders and patterns.

use std::collections::{BTreeMap, HashSet};
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, LazyLock};

use ignore::WalkBuilder;

use super::ending::{Failure, detail, note};
use super::input::{FileKind, name_of, source_name};
use super::settings::{CommandSettings, Project};
use objdict_format::identify::{ContentKind, identify};
use objdict_model::source::{self, MAX_TOML_SIZE};
use objdict_network_file::may_be_network;

/// The endings of the descriptions that are looked for in folders.
static ENDINGS: LazyLock<Vec<&str>> = LazyLock::new(|| {
    let has_own = |kind: &FileKind| kind.format().is_some_and(|format| FileKind::from(format) == *kind);
    let kinds = FileKind::read().filter(|kind| has_own(kind) && *kind != FileKind::Toml);
    kinds.flat_map(|kind| kind.endings().iter().copied()).collect()
});

/// Those of projects and of many other files.
const SHARED_ENDINGS: [&str; 2] = ["xml", "od"];

/// A file that is meant.
pub(super) struct InputFile {
    /// Where it is.
    pub path: PathBuf,
    /// The configuration that holds for it.
    pub project: Option<Arc<Project>>,
    /// Whether an argument names it; else it was found in a folder or by a pattern.
    pub is_named: bool,
    /// Whether a link led to it, out of the folder that was searched. Such a file is only read.
    pub is_outside: bool,
    /// Its size in bytes; 0 where that is not known.
    pub size: u64,
}

/// The files that are meant by the arguments, in their order, those of a folder sorted; and what could not be found. A
/// file that was found is there once, a file that is named is there as often as it is named, even if it is excluded.
///
/// # Errors
/// When a configuration cannot be opened.
pub(super) fn gather(
    arguments: &[PathBuf],
    settings: &mut CommandSettings,
) -> Result<(Vec<InputFile>, Vec<Failure>), Failure> {
    gather_with(arguments, settings, |_| false)
}

/// The same with the files of folders that are `also` looked for.
pub(super) fn gather_with(
    arguments: &[PathBuf],
    settings: &mut CommandSettings,
    also: fn(&Path) -> bool,
) -> Result<(Vec<InputFile>, Vec<Failure>), Failure> {
    let (files, failures, seen) = (Vec::new(), Vec::new(), HashSet::new());
    let mut gathered = Gathered { settings, also, files, failures, seen };
    for argument in arguments {
        gathered.add(argument)?;
    }
    Ok((gathered.files, gathered.failures))
}

struct Gathered<'s> {
    settings: &'s mut CommandSettings,
    also: fn(&Path) -> bool,
    files: Vec<InputFile>,
    failures: Vec<Failure>,
    seen: HashSet<PathBuf>,
}

impl Gathered<'_> {
    fn add(&mut self, argument: &Path) -> Result<(), Failure> {
        if argument.is_dir() {
            let before = self.files.len();
            self.walk(argument, &real(argument))?;
            if self.files.len() == before {
                self.nothing_in(format_args!("no descriptions in `{}`", name_of(argument)));
            }
        } else if is_pattern(argument) && !argument.exists() {
            self.expand(argument)?;
        } else {
            self.push(argument.to_owned(), true, false)?;
        }
        Ok(())
    }

    /// The descriptions in a folder and below, but for what is hidden or named by a `.gitignore`.
    fn walk(&mut self, folder: &Path, searched: &Path) -> Result<(), Failure> {
        let mut walk = WalkBuilder::new(folder);
        walk.require_git(false).sort_by_file_name(Ord::cmp);
        let also = self.also;
        let is_wanted = |path: &Path| (is_description(path) || also(path)) && path.is_file();
        let leads_out = |path: &Path| !real(path).starts_with(searched);
        // below it, links to folders are not followed
        let is_outside = leads_out(folder);
        for found in walk.build() {
            match found {
                Ok(found) if is_wanted(found.path()) => {
                    let is_outside = is_outside || found.path_is_symlink() && leads_out(found.path());
                    // what is found in the current folder is called by its name
                    let path = found.path();
                    self.push(path.strip_prefix("./").unwrap_or(path).to_owned(), false, is_outside)?;
                }
                Ok(_) => {}
                Err(error) => self.failures.push(Failure::new(error)),
            }
        }
        Ok(())
    }

    /// The files that a pattern matches, whatever their ending, and the descriptions in the folders that it matches.
    fn expand(&mut self, pattern: &Path) -> Result<(), Failure> {
        let shown = name_of(pattern);
        // as the system compares names
        let options = glob::MatchOptions { case_sensitive: !cfg!(windows), ..glob::MatchOptions::new() };
        let matches = match glob::glob_with(&pattern.to_string_lossy(), options) {
            Ok(matches) => matches,
            Err(error) => {
                self.failures
                    .push(Failure::new(format_args!("`{shown}` is not a valid pattern: {}", error.msg)));
                return Ok(());
            }
        };
        let before = self.files.len();
        let is_plain = |part: &Component<'_>| !is_pattern(part.as_ref());
        let searched = real(&pattern.components().take_while(is_plain).collect::<PathBuf>());
        for found in matches {
            match found {
                Ok(path) if path.is_dir() => self.walk(&path, &searched)?,
                Ok(path) if path.is_file() => {
                    let is_outside = !real(&path).starts_with(&searched);
                    self.push(path, false, is_outside)?;
                }
                Ok(path) => {
                    let message = format!("`{}` is a pipe or a device, not a file", name_of(&path));
                    self.failures.push(Failure::new(message).help("name it to read it"));
                }
                Err(error) => self.failures.push(Failure::new(error)),
            }
        }
        if self.files.len() == before {
            self.nothing_in(format_args!("no file matches `{shown}`"));
        }
        Ok(())
    }

    /// Adds a file that was found, or that an argument names.
    fn push(&mut self, path: PathBuf, is_named: bool, is_outside: bool) -> Result<(), Failure> {
        // whatever it is called; `-` is what no other name is
        let real = real(&path);
        if self.seen.contains(&real) {
            return Ok(());
        }
        let project = self.settings.project_of(&path)?;
        let is_excluded = project.as_ref().is_some_and(|project| project.config.excludes(&path));
        if is_named || !is_excluded {
            detail(&source_name(&path));
            self.seen.insert(real);
            let size = path.metadata().map_or(0, |metadata| metadata.len());
            self.files.push(InputFile { path, project, is_named, is_outside, size });
        }
        Ok(())
    }

    fn nothing_in(&mut self, message: std::fmt::Arguments<'_>) {
        let endings: Vec<String> = ENDINGS.iter().map(|ending| format!(".{ending}")).collect();
        let help =
            format!("descriptions end in {}; a file named explicitly is always read", endings.join(", "));
        self.failures.push(Failure::new(message).help(help));
    }
}

/// Says which files are not changed, because a link out of the folder led to them.
pub(super) fn note_outside(files: &[InputFile]) {
    for file in files.iter().filter(|file| file.is_outside) {
        let name = name_of(&file.path);
        note(&format!(
            "note: `{name}` is unchanged because a link points outside the folder; name the file to change it\n"
        ));
    }
}

/// A path without links; as it is where it leads nowhere.
fn real(path: &Path) -> PathBuf {
    let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
    path.canonicalize().unwrap_or_else(|_| path.to_owned())
}

fn is_pattern(path: &Path) -> bool {
    let path = path.to_string_lossy();
    // `\\?\C:\drive.eds` is a path of Windows
    path.strip_prefix(r"\\?\").unwrap_or(&path).contains(['*', '?', '['])
}

/// Whether a file is a `device.toml`, a network, a patch or a project by what is in it; others may have these endings too.
pub(super) fn is_source(path: &Path) -> bool {
    (may_be_network(path) || has_ending(path, &SHARED_ENDINGS))
        && path.metadata().is_ok_and(|metadata| metadata.len() <= MAX_TOML_SIZE)
        && source::read(path, MAX_TOML_SIZE)
            .is_ok_and(|bytes| identify(&source_name(path), &bytes).kind != ContentKind::Unknown)
}

fn is_description(path: &Path) -> bool {
    has_ending(path, &ENDINGS)
}

fn has_ending(path: &Path, endings: &[&str]) -> bool {
    let ending = path.extension().unwrap_or_default();
    endings.iter().any(|known| ending.eq_ignore_ascii_case(known))
}

/// Names the folders in which several DCFs were found, because each is checked alone.
pub(super) fn note_networks(files: &[InputFile]) {
    let mut counts: BTreeMap<&Path, usize> = BTreeMap::new();
    for file in files.iter().filter(|file| !file.is_named && has_ending(&file.path, &["dcf"])) {
        *counts.entry(file.path.parent().unwrap_or(Path::new(""))).or_default() += 1;
    }
    for (folder, count) in counts.into_iter().filter(|(_, count)| *count > 1) {
        let pattern = name_of(&folder.join("*.dcf"));
        note(&format!(
            "note: {count} DCFs are checked one by one; if they are a network, `objdict network check {pattern}` checks them together\n"
        ));
    }
}

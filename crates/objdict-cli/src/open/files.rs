//! The files that the page of `objdict open` sees. It knows them by numbers, so no request can name another file.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::Serialize;

use super::http::HttpRefusal;
use crate::args::OpenArgs;
use crate::ending::{Failure, note};
use crate::files::{InputFile, gather_with};
use crate::input::{SizeArgs, name_of, source_name};
use crate::settings::{CommandSettings, SettingsArgs};
use crate::written_files::save_in_place;
use objdict_build::pipeline::Hash;
use objdict_format::identify::{ContentKind, identify};
use objdict_network_file::{NetworkFile, PathOptions, may_be_network};

/// So many of the files that are named are open when the page is loaded; the others are in its list.
const MAX_OPEN: usize = 20;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum OpenKind {
    Description,
    Network,
    Other,
}

/// A file, as the page lists it.
#[derive(Debug, Serialize)]
struct ServedFile {
    #[serde(skip)]
    path: PathBuf,
    /// What `path` was when the command started: it must not become a link to another file.
    #[serde(skip)]
    real: PathBuf,
    name: String,
    kind: OpenKind,
    /// Of a network, the numbers of the descriptions of its nodes.
    nodes: BTreeSet<usize>,
    is_open: bool,
    is_read_only: bool,
}

/// All of them.
#[derive(Debug)]
pub(super) struct ServedFiles {
    list: Vec<ServedFile>,
    /// What the command was given.
    arguments: Vec<PathBuf>,
    settings: SettingsArgs,
    size: SizeArgs,
    /// A file is compared and written by one request at a time.
    writing: Mutex<()>,
}

impl ServedFiles {
    /// The files that the arguments name, and the descriptions of networks among them.
    pub(super) fn gather(args: &OpenArgs) -> Result<Self, Failure> {
        let settings = SettingsArgs::from(&args.config);
        let arguments = args.files.clone();
        let (found, failures) =
            gather_with(&arguments, &mut CommandSettings::new(&settings)?, may_be_network)?;
        let mut failures = failures.into_iter();
        failures.next().map_or(Ok(()), Err)?;
        let size = SizeArgs { max_size: args.size.max_size };
        let mut files = Self { list: Vec::new(), arguments, settings, size, writing: Mutex::default() };
        for file in &found {
            match files.add(file) {
                // one file of a folder keeps no other one closed
                Err(failure) if !file.is_named => failure.print(),
                added => added?,
            }
        }
        files.add_all_nodes(0)?;
        if files.list.is_empty() {
            return Err(
                Failure::new("there is nothing to open").help("name a description, a network or a folder")
            );
        }
        let open = files.list.iter_mut().filter(|file| file.is_open);
        open.skip(MAX_OPEN).for_each(|file| file.is_open = false);
        Ok(files)
    }

    /// Adds the files that are new in the folders; those of the list keep their numbers.
    pub(super) fn look_again(&mut self) -> Result<(), Failure> {
        let mut settings = CommandSettings::new(&self.settings)?;
        let (found, _) = gather_with(&self.arguments, &mut settings, may_be_network)?;
        let known = self.list.len();
        for file in found.iter().filter(|file| !file.is_named) {
            // one that cannot be read keeps no other one out
            drop(self.add(file));
        }
        self.add_all_nodes(known)
    }

    /// Adds the descriptions of the nodes of all networks from a number on.
    fn add_all_nodes(&mut self, first: usize) -> Result<(), Failure> {
        let networks = (first..self.list.len()).filter(|&number| self.list[number].kind == OpenKind::Network);
        networks.collect::<Vec<_>>().into_iter().try_for_each(|number| self.add_nodes(number))
    }

    /// The list as JSON.
    pub(super) fn list(&self) -> Result<Vec<u8>, Failure> {
        serde_json::to_vec(&serde_json::json!({ "files": self.list })).map_err(Failure::new)
    }

    pub(super) fn count(&self) -> usize {
        self.list.len()
    }

    fn add(&mut self, file: &InputFile) -> Result<(), Failure> {
        let path = &file.path;
        if file.is_named && path.exists() && !path.is_file() || path == Path::new("-") {
            let message = format!("`{}` is not a file, so it cannot be saved in place", name_of(path));
            return Err(Failure::new(message).help("write it to a file and open that"));
        }
        let kind = match is_clear(path) && !file.is_named {
            true => OpenKind::Description,
            false => kind_of(path, &self.size.bytes(path)?),
        };
        if kind == OpenKind::Other && !file.is_named {
            return Ok(());
        }
        self.push(path, kind, file.is_named, file.is_outside).map(drop)
    }

    /// Adds the descriptions of the nodes of a network.
    fn add_nodes(&mut self, number: usize) -> Result<(), Failure> {
        let network = &self.list[number];
        let is_read_only = network.is_read_only;
        let network = NetworkFile::open(&network.path, &PathOptions::default()).map_err(Failure::new)?;
        let files = network.files.iter().filter(|path| path.is_file());
        let nodes = files.map(|path| self.push(path, OpenKind::Description, false, is_read_only));
        let nodes: BTreeSet<usize> = nodes.collect::<Result<_, Failure>>()?;
        self.list[number].nodes = nodes;
        Ok(())
    }

    /// The number of a file, which is in the list once.
    fn push(
        &mut self,
        path: &Path,
        kind: OpenKind,
        is_open: bool,
        is_read_only: bool,
    ) -> Result<usize, Failure> {
        let failed = |error| Failure::new(format_args!("cannot read `{}`: {error}", name_of(path)));
        let real = path.canonicalize().map_err(failed)?;
        if let Some(number) = self.list.iter().position(|known| known.real == real) {
            self.list[number].is_open |= is_open;
            return Ok(number);
        }
        let here = std::env::current_dir().unwrap_or_default();
        // as `gather` calls what is in the current folder
        let path = path.strip_prefix(here).unwrap_or(path);
        let name = source_name(path.strip_prefix(".").unwrap_or(path));
        let path = path.to_owned();
        self.list.push(ServedFile { path, real, name, kind, nodes: BTreeSet::new(), is_open, is_read_only });
        Ok(self.list.len() - 1)
    }

    /// The bytes of a file, and the tag that they have.
    pub(super) fn read(&self, number: usize) -> Result<(Vec<u8>, String), HttpRefusal> {
        let file = self.get(number)?;
        let bytes = self.size.bytes(&file.path).map_err(|failure| HttpRefusal(404, failure))?;
        let tag = tag(&bytes);
        Ok((bytes, tag))
    }

    /// Replaces a file that still has the bytes of a tag, and returns the tag of the new ones.
    pub(super) fn write(&self, number: usize, expected: &str, bytes: &[u8]) -> Result<String, HttpRefusal> {
        let _writing = self.writing.lock().unwrap_or_else(PoisonError::into_inner);
        let file = self.get(number)?;
        let name = name_of(&file.path);
        if file.is_read_only {
            let message = format!("`{name}` is not changed: a link leads out of the folder");
            return Err(HttpRefusal::new(403, message).help("name the file to change it"));
        }
        if self.read(number)?.1 != expected {
            let help =
                "save your version under a different name, or close the file and open it again from the list";
            let message =
                format!("`{name}` was changed by a different program since it was read, so it was not saved");
            return Err(HttpRefusal::new(412, message).help(help));
        }
        save_in_place(&file.path, bytes).map_err(|failure| HttpRefusal(500, failure))?;
        note(&format!("saved {name}\n"));
        Ok(tag(bytes))
    }

    pub(super) fn max_size(&self) -> u64 {
        self.size.max_size
    }

    fn get(&self, number: usize) -> Result<&ServedFile, HttpRefusal> {
        let file = self.list.get(number).ok_or_else(|| HttpRefusal::new(404, "no file has this number"))?;
        if file.path.canonicalize().is_ok_and(|real| real == file.real) {
            return Ok(file);
        }
        let message = format!("`{}` was moved, removed or replaced by a link", name_of(&file.path));
        Err(HttpRefusal::new(404, message).help("start `objdict open` again"))
    }
}

/// What `If-Match` has of bytes that were read.
fn tag(bytes: &[u8]) -> String {
    format!("\"{}\"", Hash::of(bytes))
}

/// Whether the name alone says that a file of a folder is a description.
fn is_clear(path: &Path) -> bool {
    !may_be_network(path)
}

fn kind_of(path: &Path, bytes: &[u8]) -> OpenKind {
    match identify(&source_name(path), bytes).kind {
        ContentKind::NodeList | ContentKind::BusConfiguration | ContentKind::Network => OpenKind::Network,
        kind if kind.format().is_some() => OpenKind::Description,
        _ => OpenKind::Other,
    }
}

//! The file that a `device.toml` extends, and recursively the files that it extends.

use std::fs;
use std::path::{Path, PathBuf};

use super::merge::Merged;
use crate::identify::{ContentKind, identify_source};
use objdict_keyed::rules::WRONG_TYPE;
use objdict_keyed::toml;
use objdict_keyed::tree::{KeyedTree, Kind, Pair};
use objdict_model::diagnostic::{Diagnostic, Findings, Text, say};
use objdict_model::source::{Folder, MAX_TOML_SIZE, SourceFile, SourceOptions, Span, is_file};

/// The maximum number of files that extend each other.
const MAX_FILES: usize = 16;

/// The file that a text extends.
#[derive(Clone, Debug)]
pub(super) struct Base {
    /// Its name in the text.
    pub(super) name: String,
    /// Its position in the text.
    pub(super) span: Span,
    /// The files that were read, the nearest first.
    pub(super) files: Vec<PathBuf>,
    /// The merged content of the files, all at the position of the name.
    pub(super) merged: Merged,
}

/// Reads the file that a text of this name extends; an unusable file is a finding at the key.
pub(super) fn read(text: &str, name: &str, findings: &mut Findings) -> Option<Base> {
    // most texts need not be read twice
    let tree = text.contains("extends").then(|| toml::read(text, &mut Findings::new())).flatten()?;
    let named = tree.get("extends")?;
    let span = named.span;
    let refuse = |message: Text, help: Text, findings: &mut Findings| {
        findings.push(Diagnostic::new(&WRONG_TYPE, span, message).help(help));
    };
    let mut chain = Chain { files: vec![PathBuf::from(name)], trees: Vec::new() };
    let mut next = Some(named.clone());
    while let Some(named) = next {
        match chain.follow(&named, span) {
            Ok(further) => next = further,
            Err((message, help)) => {
                refuse(message, help, findings);
                return None;
            }
        }
    }
    chain.files.remove(0);
    let farthest = Merged::new(chain.trees.pop()?);
    let merged = chain.trees.iter().rev().fold(farthest, Merged::with);
    Some(Base { name: named.spelled(), span, files: chain.files, merged })
}

/// The files read so far, starting with the extending one.
struct Chain {
    files: Vec<PathBuf>,
    trees: Vec<KeyedTree>,
}

impl Chain {
    /// Reads one more file; returns the file that it extends.
    fn follow(&mut self, named: &KeyedTree, span: Span) -> Result<Option<KeyedTree>, (Text, Text)> {
        let name = named.spelled();
        let Some(file) = self.files.last().filter(|file| is_file(file)) else {
            let help = "read the file by its path, not from the standard input";
            return Err((say!("the location of `{}` is unknown", name), help.into()));
        };
        if named.text().is_none() {
            return Err((say!("`extends` is {}", named.kind_name()), "write the name of a file".into()));
        }
        let path = Folder::of(file).resolve(&name).map_err(|error| {
            let help = error.help().unwrap_or("write the name of a `device.toml` relative to this file");
            (say!("`{}` cannot be extended: {}", name, error.to_string()), say!("{}", help))
        })?;
        let real = |path: &Path| fs::canonicalize(path).ok();
        if let Some(first) = self.files.iter().position(|file| real(file) == real(&path)) {
            let shown = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let files = self.files[first..].iter().map(PathBuf::as_path).chain([path.as_path()]);
            let circle = files.map(shown).collect::<Vec<_>>().join(" → ");
            return Err((say!("files extend each other: {}", circle), "remove one `extends`".into()));
        }
        if self.trees.len() == MAX_FILES {
            let message = say!("more than {} files extend each other", MAX_FILES);
            return Err((message, "merge some of them".into()));
        }
        let tree = opened(&path).map_err(|error| {
            let help = "run `objdict check` on that file";
            (say!("`{}` cannot be extended: {}", name, error), help.into())
        })?;
        let further = tree.get("extends").cloned();
        self.trees.push(placed(&only_device(&tree), span));
        self.files.push(path);
        Ok(further)
    }
}

/// The tree of a file.
fn opened(path: &Path) -> Result<KeyedTree, String> {
    let options = SourceOptions { encoding: None, max_size: MAX_TOML_SIZE };
    let source = SourceFile::open(path, &options).map_err(|error| error.to_string())?;
    if identify_source(&source).kind != ContentKind::DeviceToml {
        return Err("it is not a `device.toml`".to_owned());
    }
    let mut findings = Findings::new();
    toml::read(source.text(), &mut findings).ok_or_else(|| {
        let first = findings.iter().next().map(|finding| finding.message.shown().into_owned());
        first.unwrap_or_default()
    })
}

/// The content about a file's device: variants belong only to their file.
fn only_device(tree: &KeyedTree) -> KeyedTree {
    let is_other = |entry: &&Pair| !matches!(entry.key.text(), Some("format" | "extends" | "variant"));
    let entries = tree.entries().unwrap_or_default().iter().filter(is_other);
    KeyedTree::new(tree.span, Kind::Map(entries.cloned().collect()))
}

/// The tree with all its values at one position.
fn placed(tree: &KeyedTree, span: Span) -> KeyedTree {
    let kind = match &*tree.kind {
        Kind::List(items) => Kind::List(items.iter().map(|item| placed(item, span)).collect()),
        Kind::Map(entries) => {
            let entries = entries
                .iter()
                .map(|Pair { key, value }| Pair { key: placed(key, span), value: placed(value, span) });
            Kind::Map(entries.collect())
        }
        kind => kind.clone(),
    };
    KeyedTree::new(span, kind)
}

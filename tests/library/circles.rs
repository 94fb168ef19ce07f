//! Modules of a crate do not import each other in a circle: whoever reads one can stop at its imports. A module is a file. Imports are
//! paths that begin with `crate` or `super`; one that leads to a re-export leads to the file of the item. Declarations of modules,
//! re-exports and tests are not asked.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::namesakes::{declaration, sources, without_tests};

/// Circles by the crate and the first of their files, and why they stay.
const CIRCLES: [(&str, &str); 1] =
    [("objdict-xdd xdd/findings/ids", "one walk calls the checks of elements, which continue the walk")];

/// The names of a module and of those around it.
type ModulePath = Vec<String>;

#[derive(Default)]
struct Module {
    imports: Vec<Import>,
    items: BTreeSet<String>,
    code: String,
}

struct Import {
    path: ModulePath,
    /// The name in this module.
    name: String,
    exported: bool,
}

#[test]
fn modules_do_not_import_each_other_in_circles() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("crates");
    let mut crates: BTreeMap<String, BTreeMap<ModulePath, Module>> = BTreeMap::new();
    for path in sources() {
        let Ok(inner) = path.strip_prefix(&root) else { continue };
        let mut parts: ModulePath =
            inner.iter().map(|part| part.to_str().unwrap().trim_end_matches(".rs").into()).collect();
        parts.pop_if(|last| ["lib", "main", "mod"].contains(&last.as_str()));
        let modules = crates.entry(parts[0].clone()).or_default();
        modules.insert(parts.split_off(2), Module::new(&fs::read_to_string(&path).unwrap()));
    }
    let mut found = BTreeMap::new();
    for (name, modules) in &crates {
        for circle in circles(&edges(modules)) {
            let files: Vec<String> = circle.iter().map(|path| path.join("/")).collect();
            found.insert(format!("{name} {}", files[0]), files);
        }
    }
    let added: BTreeMap<_, _> =
        found.iter().filter(|(name, _)| CIRCLES.iter().all(|(known, _)| known != name)).collect();
    assert!(added.is_empty(), "move what both sides need to a file of its own: {added:#?}");
    let gone: Vec<_> = CIRCLES.iter().filter(|(known, _)| !found.contains_key(*known)).collect();
    assert!(gone.is_empty(), "remove these from `CIRCLES`, they are untied: {gone:?}");
}

impl Module {
    fn new(text: &str) -> Self {
        let mut module = Self::default();
        let mut lines = without_tests(text).map(without_texts);
        while let Some(line) = lines.next() {
            let (declared, exported) = declaration(&line);
            if let Some(path) = declared.strip_prefix("use ") {
                let mut path = path.to_owned();
                while !path.contains(';') {
                    path += lines.next().unwrap_or_else(|| ";".to_owned()).trim();
                }
                module.import("", path.trim_end_matches(';'), exported);
            } else {
                let words = [
                    "const",
                    "unsafe",
                    "async",
                    "fn",
                    "static",
                    "struct",
                    "enum",
                    "trait",
                    "type",
                    "union",
                    "macro_rules!",
                ];
                let name = declared.split([' ', '(', '<', ':', ';', '{']).find(|word| !words.contains(word));
                let is_item = words
                    .iter()
                    .any(|word| declared.strip_prefix(word).is_some_and(|rest| rest.starts_with(' ')));
                module.items.extend(name.filter(|_| is_item).map(str::to_owned));
                module.code += &line;
                module.code.push('\n');
            }
        }
        module
    }

    /// Adds the paths of an import, groups in braces expanded.
    fn import(&mut self, front: &str, path: &str, exported: bool) {
        if let Some((more, group)) = path.split_once('{') {
            let group = group.rsplit_once('}').map_or(group, |(group, _)| group);
            let (mut depth, mut start) = (0, 0);
            for (at, c) in group.char_indices().chain([(group.len(), ',')]) {
                match c {
                    '{' => depth += 1,
                    '}' => depth -= 1,
                    ',' if depth == 0 => {
                        self.import(&format!("{front}{more}"), group[start..at].trim(), exported);
                        start = at + 1;
                    }
                    _ => {}
                }
            }
        } else if !path.is_empty() {
            let (path, name) =
                path.split_once(" as ").map_or((path, None), |(path, name)| (path, Some(name)));
            let mut path: ModulePath = format!("{front}{path}").split("::").map(str::to_owned).collect();
            path.pop_if(|last| last == "self");
            let name = name.map(str::to_owned).or_else(|| path.last().cloned()).unwrap_or_default();
            self.imports.push(Import { path, name, exported });
        }
    }

    /// The imported paths and those in code, as they are written.
    fn paths(&self) -> impl Iterator<Item = ModulePath> {
        let is_name = |c: char| c.is_alphanumeric() || c == '_';
        let words: BTreeSet<&str> = self.code.split(|c: char| !is_name(c)).collect();
        let is_used = move |import: &&Import| !import.exported || words.contains(import.name.as_str());
        let imported = self.imports.iter().filter(is_used).map(|import| import.path.clone());
        let in_code =
            self.code.split(move |c: char| !is_name(c) && c != ':').map(|word| word.trim_end_matches(':'));
        let in_code = in_code.filter(|word| word.starts_with("crate::") || word.starts_with("super::"));
        let in_code = in_code.map(|word| word.split("::").map(str::to_owned).collect());
        imported.filter(|path: &ModulePath| path[0] == "crate" || path[0] == "super").chain(in_code)
    }
}

/// A line without its comment and the contents of its strings.
fn without_texts(line: &str) -> String {
    let parts = line.split('"').step_by(2).collect::<Vec<_>>().join("\"\"");
    parts.split_once("//").map_or(parts.as_str(), |(code, _)| code).to_owned()
}

/// The files that each file imports.
fn edges<'m>(
    modules: &'m BTreeMap<ModulePath, Module>,
) -> BTreeMap<&'m ModulePath, BTreeSet<&'m ModulePath>> {
    let files = |(path, module): (&'m ModulePath, &'m Module)| {
        let imports = module.paths().filter_map(|import| absolute(modules, path, &import));
        (
            path,
            imports.filter_map(|import| file_of(modules, &import, 0)).filter(|file| *file != path).collect(),
        )
    };
    modules.iter().map(files).collect()
}

/// A path from the root of the crate; none for one that begins with another crate.
fn absolute(modules: &BTreeMap<ModulePath, Module>, of: &[String], path: &[String]) -> Option<ModulePath> {
    let ups = path.iter().take_while(|part| *part == "super").count();
    let (base, rest) = match path[0].as_str() {
        "crate" => (&[][..], &path[1..]),
        "self" => (of, &path[1..]),
        "super" => (&of[..of.len().checked_sub(ups)?], &path[ups..]),
        child if modules.contains_key(&[of, &[child.to_owned()]].concat()) => (of, path),
        _ => return None,
    };
    Some([base, rest].concat())
}

/// The file of the item that a path leads to, through re-exports.
fn file_of<'m>(
    modules: &'m BTreeMap<ModulePath, Module>,
    path: &[String],
    depth: usize,
) -> Option<&'m ModulePath> {
    let (file, module, rest) = (0..=path.len()).rev().find_map(|length| {
        let (file, module) = modules.get_key_value(&path[..length])?;
        Some((file, module, &path[length..]))
    })?;
    let Some((name, rest)) = rest.split_first().filter(|_| depth < 8) else { return Some(file) };
    if module.items.contains(name) {
        return Some(file);
    }
    let follow = |import: &Import, rest: &[String]| {
        let end = import.path.len() - usize::from(import.name == "*");
        let target = absolute(modules, file, &import.path[..end])?;
        file_of(modules, &[&target, rest].concat(), depth + 1)
    };
    let named = module.imports.iter().find(|import| import.name == *name);
    let of_all = || {
        let globs = module.imports.iter().filter(|import| import.name == "*");
        globs
            .filter_map(|import| follow(import, std::slice::from_ref(name)))
            .find(|file| modules[*file].items.contains(name))
    };
    named.and_then(|import| follow(import, rest)).or_else(of_all).or(Some(file))
}

/// The groups of files in which each reaches all others.
fn circles<'m>(edges: &BTreeMap<&'m ModulePath, BTreeSet<&'m ModulePath>>) -> Vec<BTreeSet<&'m ModulePath>> {
    let reached = |from: &'m ModulePath| {
        let (mut reached, mut open) = (BTreeSet::new(), vec![from]);
        while let Some(file) = open.pop() {
            open.extend(edges[file].iter().filter(|next| reached.insert(**next)));
        }
        reached
    };
    let reached: BTreeMap<_, _> = edges.keys().map(|file| (*file, reached(file))).collect();
    let circle = |file: &&'m ModulePath| -> BTreeSet<_> {
        reached[file].iter().copied().filter(|other| reached[other].contains(file)).collect()
    };
    let circles: BTreeSet<_> = edges.keys().map(circle).filter(|circle| circle.len() > 1).collect();
    circles.into_iter().collect()
}

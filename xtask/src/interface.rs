//! tests/interface.txt: the public items of the crates that users depend on, with signatures, from the JSON of rustdoc.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use public_api::{Builder, PublicItem};
use serde_json::Value;

/// The compiler that the list is made with. Other compilers write other versions of the JSON, or other paths of the standard library.
const COMPILER: &str = "rustc 1.95.";

/// The crates that users depend on.
const ROOTS: [&str; 2] = ["objdict", "objdict_device"];

/// The crates that `objdict` is made of: their items are listed where it exports them.
const PARTS: [&str; 15] = [
    "objdict_build",
    "objdict_bus",
    "objdict_document",
    "objdict_eds",
    "objdict_format",
    "objdict_generate",
    "objdict_lint",
    "objdict_model",
    "objdict_network",
    "objdict_network_file",
    "objdict_node",
    "objdict_profile",
    "objdict_project",
    "objdict_traffic",
    "objdict_xdd",
];

/// The variable with the real rustdoc, while cargo calls this program as rustdoc. Only rustdoc gets `RUSTC_BOOTSTRAP`, because build
/// scripts of dependencies read it, and cargo would compile these again.
pub(crate) const RUSTDOC: &str = "OBJDICT_INTERFACE_RUSTDOC";

/// Writes the list, or with `check` fails when it is not what it would write.
pub(crate) fn run(check: bool) -> Result<(), String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().ok_or("no folder above xtask")?;
    let version =
        Command::new("rustc").arg("--version").output().map_err(|error| format!("rustc: {error}"))?;
    let version = String::from_utf8_lossy(&version.stdout);
    if !version.starts_with(COMPILER) {
        let message = format!("the list of the interface needs {COMPILER}x, found {}", version.trim());
        if !check {
            return Err(message);
        }
        // what another compiler writes is no change of the interface
        println!("{message}: skipped");
        return Ok(());
    }
    let list = list(&documentation(root)?)?;
    let file = root.join("tests/interface.txt");
    if !check {
        return fs::write(&file, list).map_err(|error| format!("tests/interface.txt: {error}"));
    }
    let kept = fs::read_to_string(&file).map_err(|error| format!("tests/interface.txt: {error}"))?;
    let [old, new] = [&kept, &list].map(|text| text.lines().collect::<BTreeSet<_>>());
    let mut changes = String::new();
    old.difference(&new).for_each(|line| _ = writeln!(changes, "- {line}"));
    new.difference(&old).for_each(|line| _ = writeln!(changes, "+ {line}"));
    match kept == list {
        true => Ok(()),
        false => Err(format!(
            "{changes}tests/interface.txt is stale: run `cargo xtask interface`, and add the change to CHANGELOG.md"
        )),
    }
}

/// Writes the JSON of each crate, and returns its folder. The arguments are those of `cargo doc` in the gate, which has checked all
/// dependencies with the same features.
fn documentation(root: &Path) -> Result<PathBuf, String> {
    let own = std::env::current_exe().map_err(|error| format!("the path of xtask: {error}"))?;
    let target =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), |folder| root.join(folder));
    let status = Command::new("cargo")
        .args(["doc", "--quiet", "--workspace", "--exclude", "objdict-crates"])
        .args(["--no-deps", "--all-features", "--lib"])
        .current_dir(root)
        .env("OBJDICT_WORKBENCH", root.join("tests/command/open/page.html"))
        .env(RUSTDOC, std::env::var_os("RUSTDOC").unwrap_or_else(|| "rustdoc".into()))
        .env("RUSTDOC", own)
        .env("RUSTDOCFLAGS", "-Z unstable-options --output-format json")
        .status();
    match status {
        Ok(status) if status.success() => Ok(target.join("doc")),
        Ok(status) => Err(format!("cargo doc: {status}")),
        Err(error) => Err(format!("cargo doc: {error}")),
    }
}

/// Called by cargo as rustdoc: documents the crates of the list.
pub(crate) fn rustdoc(arguments: &[&str]) -> Result<(), String> {
    let program = std::env::var(RUSTDOC).map_err(|error| format!("{RUSTDOC}: {error}"))?;
    let name = arguments.windows(2).find(|pair| pair[0] == "--crate-name").map(|pair| pair[1]);
    if name.is_some_and(|name| !ROOTS.contains(&name) && !PARTS.contains(&name)) {
        return Ok(());
    }
    let status = Command::new(&program).args(arguments).env("RUSTC_BOOTSTRAP", "1").status();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{program}: {status}")),
        Err(error) => Err(format!("{program}: {error}")),
    }
}

/// The items of a crate, and where its `use` lead to.
struct Crate {
    items: Vec<PublicItem>,
    uses: BTreeMap<u32, String>,
}

impl Crate {
    fn read(file: &Path) -> Result<Self, String> {
        let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", file.display());
        let api = Builder::from_rustdoc_json(file).omit_auto_trait_impls(true).omit_blanket_impls(true);
        let items = api.build().map_err(|error| fail(&error))?.into_items().collect();
        let text = fs::read(file).map_err(|error| fail(&error))?;
        let json: Value = serde_json::from_slice(&text).map_err(|error| fail(&error))?;
        let items_by_id = json["index"].as_object().into_iter().flatten();
        let uses = items_by_id.filter_map(|(id, item)| {
            Some((id.parse().ok()?, item["inner"]["use"]["source"].as_str()?.to_owned()))
        });
        Ok(Self { items, uses: uses.collect() })
    }
}

/// The list: a part for each crate, with its items in the order of their paths.
fn list(folder: &Path) -> Result<String, String> {
    let names = ROOTS.iter().chain(&PARTS);
    let read = |name: &&'static str| Ok((*name, Crate::read(&folder.join(name).with_extension("json"))?));
    let crates: BTreeMap<&str, Crate> = names.map(read).collect::<Result<_, String>>()?;
    let names = Names::of(&crates);
    let mut text = String::new();
    for root in ROOTS {
        let mut lines = Lines { crates: &crates, names: &names, found: Vec::new() };
        lines.add(root, root, "");
        let mut seen = BTreeSet::new();
        // a rule's page is a module, but nothing that callers name
        let is_page = |line: &str| line.strip_prefix("mod rules::").is_some_and(|path| path.contains("::"));
        lines.found.retain(|line| !is_page(line) && seen.insert(line.clone()));
        let _ =
            writeln!(text, "{}# {root}\n{}", if text.is_empty() { "" } else { "\n" }, lines.found.join("\n"));
    }
    Ok(text)
}

/// The crates that have a type of each name: one of several is shown with its crate.
struct Names(BTreeMap<String, BTreeSet<String>>);

impl Names {
    fn of(crates: &BTreeMap<&str, Crate>) -> Self {
        let mut names: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for (of, item) in crates.iter().flat_map(|(of, one)| one.items.iter().map(move |item| (of, item))) {
            let text = item.to_string();
            let is_type = ["enum ", "struct ", "trait ", "type "]
                .iter()
                .any(|kind| text.contains(&format!("pub {kind}objdict")));
            if let Some(name) = own_path(&text).rsplit("::").next().filter(|_| is_type) {
                names.entry(name.to_owned()).or_default().insert((*of).to_owned());
            }
        }
        Self(names)
    }

    /// Replaces paths by names: those of other crates lead through private modules.
    fn shortened(&self, text: &str) -> String {
        let mut shown = String::new();
        let mut rest = text;
        while let Some(start) = rest.find(is_of_path) {
            let (before, path) = rest.split_at(start);
            let end = path.find(|c| !is_of_path(c)).unwrap_or(path.len());
            let (path, behind) = path.split_at(end);
            // `T:` before its bounds
            let path_alone = path.strip_suffix(':').filter(|path| !path.ends_with(':')).unwrap_or(path);
            let _ = write!(shown, "{before}{}{}", self.name(path_alone), &path[path_alone.len()..]);
            rest = behind;
        }
        shown + rest
    }

    fn name(&self, path: &str) -> String {
        let parts: Vec<&str> = path.split("::").collect();
        let (first, last) = (parts[0], parts[parts.len() - 1]);
        let is_shared = self.0.get(last).is_some_and(|of| of.len() > 1);
        match (first, parts.len()) {
            (_, 1) | ("", _) => path.to_owned(),
            // `fmt::Result`, `io::Error` and others that are no names of the prelude
            ("core" | "alloc" | "std", _) if ["Error", "Result"].contains(&last) && parts[1] != "result" => {
                format!("{}::{last}", parts[1])
            }
            ("core" | "alloc" | "std", _) => last.to_owned(),
            (first, _) if first.starts_with("objdict") && !is_shared => last.to_owned(),
            (first, _) if first.starts_with(char::is_uppercase) => path.to_owned(),
            (first, _) => format!("{}::{last}", first.trim_start_matches("objdict_")),
        }
    }
}

fn is_of_path(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || c == ':'
}

/// The path of an item that is no `impl`: the first in its text.
fn own_path(text: &str) -> &str {
    let start = text.find("objdict").unwrap_or(0);
    let path = &text[start..];
    let path = &path[..path.find(|c| !is_of_path(c)).unwrap_or(path.len())];
    path.trim_end_matches(':')
}

/// The lines of a root, with those of the parts that it exports.
struct Lines<'a> {
    crates: &'a BTreeMap<&'a str, Crate>,
    names: &'a Names,
    found: Vec<String>,
}

impl Lines<'_> {
    /// Adds the items of a crate at a path and below, as items of the path `shown`.
    fn add(&mut self, of: &str, path: &str, shown: &str) {
        let part = &self.crates[of];
        // the paths of items by their ids: an `impl` is below its type
        let mut paths: BTreeMap<u32, String> = BTreeMap::new();
        let mut of_traits = BTreeSet::new();
        for item in &part.items {
            let (id, parent) = (item.id().0, item.parent_id().map(|id| id.0));
            let text = item.to_string();
            let above = parent.and_then(|parent| paths.get(&parent)).filter(|_| text.starts_with("impl"));
            let own = above.map_or_else(|| own_path(&text).to_owned(), String::clone);
            paths.insert(id, own.clone());
            if text.starts_with("impl") && text.contains(" for ") {
                of_traits.insert(id);
            }
            let below = own.strip_prefix(path).filter(|rest| rest.is_empty() || rest.starts_with("::"));
            let Some(below) = below else { continue };
            let place = format!("{shown}{below}");
            let place = place.trim_start_matches("::");
            // the methods of an `impl` follow from its trait
            let is_known =
                parent.is_some_and(|parent| of_traits.contains(&parent)) && !text.starts_with("pub type ");
            match part.uses.get(&id) {
                _ if is_known || place.is_empty() => {}
                Some(source) => self.follow(of, source, place),
                None if text.starts_with("impl") => self.implementation(&text, &own, place),
                None => {
                    let (before, behind) = text.split_once(&own).unwrap_or(("", &text));
                    let before = before.replacen("pub ", "", 1);
                    self.found.push(format!("{before}{place}{}", self.names.shortened(behind)));
                }
            }
        }
    }

    /// Adds a `use`: the items themselves if a part has them.
    fn follow(&mut self, of: &str, source: &str, place: &str) {
        let source = source.replacen("crate::", &format!("{of}::"), 1);
        let from = source.split("::").next().unwrap_or_default();
        match PARTS.contains(&from) {
            true => self.add(from, &source, place),
            false => self.found.push(format!("use {place} = {source}")),
        }
    }

    /// Adds an `impl`: the traits of a type without parameters share a line. Lines of methods show an `impl` without parameters and trait.
    fn implementation(&mut self, text: &str, own: &str, place: &str) {
        let plain = text.strip_prefix("impl ");
        match plain.map(|plain| plain.split_once(" for ")) {
            Some(None) => {}
            _ if text.contains("::StructuralPartialEq for ") => {}
            Some(Some((name, subject))) if subject == own => {
                let name = self.names.shortened(name);
                let start = format!("impl {place}: ");
                match self.found.last_mut().filter(|line| line.starts_with(&start)) {
                    Some(line) => _ = write!(line, " + {name}"),
                    None => self.found.push(start + &name),
                }
            }
            _ => self.found.push(self.names.shortened(text)),
        }
    }
}

#[test]
fn signatures_have_the_names_of_types_alone() {
    let names =
        Names(BTreeMap::from([("Options".to_owned(), BTreeSet::from(["a".to_owned(), "b".to_owned()]))]));
    for (text, shown) in [
        ("(&mut core::fmt::Formatter<'_>) -> core::fmt::Result", "(&mut Formatter<'_>) -> fmt::Result"),
        (
            "<T: core::marker::Copy>(u8) -> core::result::Result<T, std::io::error::Error>",
            "<T: Copy>(u8) -> Result<T, io::Error>",
        ),
        ("(objdict_model::device::Device, &objdict_lint::Options)", "(Device, &lint::Options)"),
        (
            "<'_, D>::at(Self::Room) -> serde_core::ser::Serialize",
            "<'_, D>::at(Self::Room) -> serde_core::Serialize",
        ),
    ] {
        assert_eq!(names.shortened(text), shown);
    }
}

//! What pages say of installing: nothing that works only with packages in registries, until `PUBLISHED` says that they are there, and no
//! way that `cargo xtask dist try` does not run.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use objdict::registry;
use objdict_model::diagnostic::{HOME, PUBLISHED, RuleInfo, Severity};

use crate::pages::{pages, pages_for_users, read};

/// What works only when the crates and packages are in registries.
const OF_REGISTRIES: [&str; 12] = [
    "cargo install objdict",
    "cargo install --locked objdict",
    "cargo binstall objdict",
    "cargo add objdict",
    "objdict = \"",
    "objdict = { version",
    "objdict-device = { version",
    "pip install canopen-objdict",
    "uvx --from canopen-objdict",
    "pipx install canopen-objdict",
    "npm install canopen-objdict",
    "docs.rs/objdict",
];

/// Packages of others that have our name.
const OF_OTHERS: [&str; 6] = [
    "pip install objdict",
    "pipx install objdict",
    "uvx objdict",
    "npm install objdict",
    "npx objdict",
    "npm install --global objdict",
];

/// What a line that installs objdict begins with.
const INSTALLING: [&str; 8] = [
    "cargo install --locked --path",
    "cargo install --path",
    "~/objdict/bin/pip install",
    "pip install target",
    "uvx ",
    "pipx ",
    "npm install --global",
    "sudo dpkg",
];

/// All that users read: pages and the documentation in the crates, each as one line.
fn texts() -> Vec<(String, String)> {
    let one_line = |text: String| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut texts: Vec<_> =
        pages().iter().map(|page| (page.display().to_string(), one_line(read(page)))).collect();
    let packages = fs::read_dir("crates").unwrap().map(|package| package.unwrap().path());
    for package in packages.chain([PathBuf::from(".")]) {
        let library = package.join("src/lib.rs");
        let documentation = fs::read_to_string(&library).unwrap();
        texts.push((library.display().to_string(), one_line(documentation)));
    }
    texts
}

fn found(words: &[&str]) -> Vec<String> {
    let mut found = Vec::new();
    for (page, text) in texts() {
        found.extend(words.iter().filter(|word| text.contains(**word)).map(|word| format!("{page}: {word}")));
    }
    found
}

#[test]
fn no_page_shows_what_is_not_published() {
    if PUBLISHED {
        assert!(read(Path::new("README.md")).contains("pip install canopen-objdict"));
    } else {
        assert_eq!(found(&OF_REGISTRIES), [""; 0], "`PUBLISHED` is false");
    }
}

#[test]
fn no_page_names_a_package_of_others() {
    assert_eq!(found(&OF_OTHERS), [""; 0]);
}

#[test]
fn rules_have_an_address_as_soon_as_there_is_a_page() {
    let rule = RuleInfo::bare("cia306/file-name", Severity::Note);
    let address = rule.address();
    assert_eq!(address.is_some(), PUBLISHED);
    assert_eq!(HOME.is_some(), PUBLISHED);
    let expected = "https://docs.rs/objdict/latest/objdict/rules/cia306/file_name/index.html";
    assert!(address.is_none_or(|address| address == expected));
}

/// A link to the page of a rule leads to a module that exists, whose text is the page.
#[test]
fn the_address_of_each_rule_is_a_module_with_its_page() {
    let names: Vec<&str> = registry::GROUPS.iter().map(|group| group.name).collect();
    assert!(registry::groups().into_iter().eq(names.iter().copied()), "{names:?}");
    let modules = read(Path::new("src/rule_pages.rs"));
    for rule in registry::rules() {
        let (id, address) = (rule.id, rule.page_address());
        let parts: Vec<&str> = address.split('/').collect();
        let ["rules", group, module, "index.html"] = parts[..] else { panic!("{address}") };
        let (_, group) = modules.split_once(&format!(" pub mod {group} {{")).unwrap();
        let declared = format!("include_str!(\"../docs/rules/{id}.md\")] pub mod {module} {{}}");
        assert!(group.lines().next().unwrap().contains(&declared), "{address}");
        let page = read(&Path::new("docs/rules").join(id).with_extension("md"));
        assert!(page.starts_with(&format!("# {}\n\n`{id}` · **", rule.name())), "{address}: of another rule");
    }
}

/// What README and pages show is a line of docs/install.md, which `cargo xtask dist try` runs.
#[test]
fn each_way_to_install_is_tried() {
    let lines = |text: &str| -> Vec<String> { text.lines().map(|line| line.trim().to_owned()).collect() };
    let tried: BTreeSet<String> = lines(&read(Path::new("docs/install.md"))).into_iter().collect();
    let mut others = Vec::new();
    let mut shown = 0;
    for page in pages_for_users() {
        for line in lines(&read(&page)) {
            if INSTALLING.iter().any(|start| line.starts_with(start)) {
                shown += 1;
                if !tried.contains(&line) {
                    others.push(format!("{}: {line}", page.display()));
                }
            }
        }
    }
    assert_eq!(others, [""; 0]);
    assert!(
        shown > tried.iter().filter(|line| INSTALLING.iter().any(|start| line.starts_with(start))).count()
    );
    let readme = read(Path::new("README.md"));
    let (_, install) = readme.split_once("## Install\n").unwrap();
    let first = install.split("```sh\n").nth(1).unwrap().lines().next().unwrap();
    assert!(tried.contains(first), "README.md begins with `{first}`");
}

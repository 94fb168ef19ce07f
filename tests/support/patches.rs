//! The fixtures as files. Most of those of the rules are written down as what is different from another device, because that
//! is what they are about: `fixtures/README.md` says how.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Copies a folder, with the devices that patches make of others.
pub(super) fn expand(from: &Path, to: &Path) {
    let mut used = BTreeSet::new();
    copy(from, to, &mut |patches| {
        let text = fs::read_to_string(patches).unwrap();
        let patches = Patches { of: patches, bases: &from.join("bases"), to: &to_rule(from, patches, to) };
        used.extend(patches.write(text.strip_suffix('\n').unwrap_or(&text)));
    });
    let bases = fs::read_dir(from.join("bases")).unwrap().map(|base| base.unwrap().file_name());
    let unused: Vec<_> = bases.filter(|base| !used.contains(&*base.to_string_lossy())).collect();
    assert!(unused.is_empty(), "no rule is based on {unused:?}");
}

/// The folder of the devices of `rules/<group>/<rule>.diff`.
fn to_rule(from: &Path, patches: &Path, to: &Path) -> PathBuf {
    to.join(patches.strip_prefix(from).unwrap()).with_extension("")
}

/// Copies files; `patch` makes others of those that end with `.diff`.
fn copy(from: &Path, to: &Path, patch: &mut impl FnMut(&Path)) {
    fs::create_dir_all(to).unwrap();
    let mut paths: Vec<PathBuf> = fs::read_dir(from).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort(); // the whole files of a rule are in the folder `<rule>`, before `<rule>.diff`
    for path in paths {
        if path.extension().is_some_and(|ending| ending == "diff") {
            patch(&path);
        } else if path.is_dir() {
            copy(&path, &to.join(path.file_name().unwrap()), patch);
        } else {
            fs::copy(&path, to.join(path.file_name().unwrap())).unwrap();
        }
    }
}

/// The devices of a rule.
struct Patches<'a> {
    of: &'a Path,
    bases: &'a Path,
    to: &'a Path,
}

impl Patches<'_> {
    /// Writes each device behind its two lines `--- base` and `+++ device`; gives the bases.
    fn write(&self, text: &str) -> Vec<String> {
        fs::create_dir_all(self.to).unwrap();
        let mut bases = Vec::new();
        let devices = text.strip_prefix("--- ").unwrap_or_else(|| self.fail("it begins with `--- `", text));
        for patch in devices.split("\n--- ") {
            let mut lines = patch.split('\n');
            let base = lines.next().unwrap_or_default();
            let device = lines.next().and_then(|line| line.strip_prefix("+++ "));
            let device = device.unwrap_or_else(|| self.fail("behind `--- ` comes `+++ `", base));
            let text = named(&self.base(base), base, device);
            let patched = self.patched(&text, lines);
            fs::write(self.to.join(device), patched).unwrap();
            bases.push(base.to_owned());
        }
        bases
    }

    /// Another device of the rule, a base, or a healthy device.
    fn base(&self, name: &str) -> String {
        let places = [self.to.join(name), self.bases.join(name), self.bases.join("..").join(name)];
        let text = places.iter().find_map(|path| fs::read_to_string(path).ok());
        text.unwrap_or_else(|| self.fail("there is no base", name))
    }

    /// The text with some lines less and others more. What is kept or goes is looked for from the place before on.
    fn patched<'t>(&self, base: &'t str, patch: impl Iterator<Item = &'t str>) -> String {
        let end = if base.contains("\r\n") { "\r\n" } else { "\n" };
        let lines: Vec<&str> = base.split(end).collect();
        let mut rest = lines.as_slice();
        let mut patched: Vec<&str> = Vec::new();
        for line in patch {
            match line.split_at_checked(1) {
                Some(("+", new)) => patched.push(new),
                Some((mark @ (" " | "-"), wanted)) => {
                    let at = rest.iter().position(|line| *line == wanted);
                    let at = at.unwrap_or_else(|| self.fail("further down there is no such line", line));
                    patched.extend(&rest[..at]);
                    patched.extend((mark == " ").then_some(wanted));
                    rest = &rest[at + 1..];
                }
                _ => self.fail("a line begins with ` `, `-` or `+`", line),
            }
        }
        patched.extend(rest);
        patched.join(end)
    }

    fn fail(&self, what: &str, line: &str) -> ! {
        panic!("{}: {what}: `{line}`", self.of.display())
    }
}

/// A device has the name of its file in it.
fn named(text: &str, base: &str, device: &str) -> String {
    let base = base.rsplit('/').next().unwrap_or(base);
    let [eds, xdd] = [|name: &str| format!("FileName={name}"), |name: &str| format!("fileName=\"{name}\"")];
    text.replace(&eds(base), &eds(device)).replace(&xdd(base), &xdd(device))
}

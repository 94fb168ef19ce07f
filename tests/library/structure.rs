//! The XDD or XDC of every device is valid against CiA 311.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use objdict::diagnostic::Findings;
use objdict::format::{self, Format, WriteOptions, XddVersion};
use objdict::model::Device;
use objdict::source::{SourceFile, SourceOptions};
use objdict_xdd::xml::Tree;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

use crate::support;
use crate::support::devices::{Texts, device};
use crate::support::skips::{has, sample, samples_all};

fn devices(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(folder);
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let is_device = |path: &PathBuf| {
        path.extension()
            .is_some_and(|ending| ["eds", "dcf", "xdd", "xdc"].iter().any(|known| ending == *known))
    };
    let mut paths: Vec<PathBuf> = entries.filter(is_device).collect();
    paths.sort();
    paths
}

/// What the rules of the groups `cia311` and `xml` find in a text, a line each.
fn report(bytes: Vec<u8>) -> String {
    let source = SourceFile::from_bytes("written.xdd", bytes, &SourceOptions::default()).unwrap();
    let mut findings = Findings::new();
    let tree = Tree::new(source, &mut findings);
    assert!(tree.root().is_some());
    findings.append(format::check_structure(&tree));
    let lines = findings.iter().map(|finding| {
        let at = finding.labels.first().map(|label| &label.at);
        let line = match at {
            Some(objdict::diagnostic::At::Span(span)) => tree.source().line_column(span.start).line,
            _ => 0,
        };
        format!("  {line}: {} {}\n", finding.rule.id, finding.message)
    });
    lines.collect()
}

#[test]
fn what_is_written_holds_against_the_structure() {
    let mut errors = String::new();
    let mut files = 0;
    for path in ["eds", "dcf", "xdd"].into_iter().flat_map(devices) {
        let description = format::open(&path, &SourceOptions::default()).unwrap();
        for (format, xdd_version) in [(Format::Xdd, XddVersion::V1_0), (Format::Xdc, XddVersion::V1_1)] {
            let mut options = WriteOptions::default();
            options.xdd_version = xdd_version;
            options.embed = true;
            let written = format::write(description.device(), format, &options).unwrap();
            let report = report(written.bytes);
            if !report.is_empty() {
                errors.push_str(&format!(
                    "{} as {} {xdd_version:?}\n{report}",
                    path.display(),
                    format.name()
                ));
            }
            files += 1;
        }
    }
    assert!(files > 0);
    assert!(errors.is_empty(), "{errors}");
}

/// The folder with a schema of each version, and xmllint to validate with; `None` without xmllint.
fn schemas() -> Option<PathBuf> {
    if !has("xmllint", "libxml2-utils") {
        return None;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("xsd");
    fs::create_dir_all(&folder).unwrap();
    for version in XddVersion::ALL {
        fs::write(folder.join(format!("{}.xsd", version.name())), objdict_xdd::xdd::xsd(version)).unwrap();
    }
    Some(folder)
}

/// A sample of all descriptions of the fixtures, every one below `OBJDICT_CORPUS_DIR`, and random devices.
fn all_devices() -> Vec<(String, Device)> {
    let endings = ["eds", "dcf", "xdd", "xdc", "xpd", "nxdd"];
    let mut paths = sample(support::files("", &endings));
    if let Some(folder) = std::env::var_os("OBJDICT_CORPUS_DIR") {
        paths.extend(support::files_below(Path::new(&folder), &endings));
    }
    let open = |path: PathBuf| {
        let description = format::open(&path, &SourceOptions::default()).ok()?;
        Some((path.display().to_string(), description.into_device()))
    };
    let mut devices: Vec<(String, Device)> = paths.into_iter().filter_map(open).collect();
    let (mut runner, random) = (TestRunner::deterministic(), device(Texts::Any));
    devices.extend((0..8).map(|number| {
        let device = random.new_tree(&mut runner).unwrap().current();
        (format!("random device {number}"), device)
    }));
    devices
}

/// Of other fixtures, `what_is_written_holds_against_the_structure` compares every healthy one with the table that the schema is
/// made from.
#[test]
fn xmllint_accepts_what_is_written() {
    let Some(schemas) = schemas() else { return };
    let devices = all_devices();
    for version in XddVersion::ALL {
        let folder = schemas.join(version.name());
        fs::remove_dir_all(&folder).ok();
        fs::create_dir_all(&folder).unwrap();
        let mut files = Vec::new();
        for (number, (name, device)) in devices.iter().enumerate() {
            let formats = [(Format::Xdd, false), (Format::Xdc, true)];
            // in a sample, one of both in each version
            let is_used =
                |at: usize| samples_all() || (number + at) % 2 == usize::from(version == XddVersion::V1_0);
            for (_, (format, embed)) in formats.into_iter().enumerate().filter(|(at, _)| is_used(*at)) {
                let mut options = WriteOptions::default();
                (options.xdd_version, options.embed) = (version, embed);
                let written = format::write(device, format, &options);
                let written = written.unwrap_or_else(|error| panic!("{name} as {}: {error}", format.name()));
                let file = folder.join(format!("{number}-{embed}.{}", format.name()));
                fs::write(&file, written.bytes).unwrap();
                files.push(file);
            }
        }
        assert_valid(&schemas, version, &files);
    }
}

fn assert_valid(schemas: &Path, version: XddVersion, files: &[PathBuf]) {
    for files in files.chunks(200) {
        let mut xmllint = Command::new("xmllint");
        xmllint.args(["--noout", "--huge", "--schema"]).arg(schemas.join(format!("{}.xsd", version.name())));
        let output = xmllint.args(files).output().unwrap();
        let text = String::from_utf8_lossy(&output.stderr);
        let errors: Vec<_> = text.lines().filter(|line| !line.ends_with(" validates")).take(20).collect();
        assert!(output.status.success(), "{}", errors.join("\n"));
    }
}

/// A document with an element less, an element more, two in another order, or another value; each element is a line.
fn changed(text: &str, number: usize) -> String {
    const VALUES: [&str; 8] = ["", "x y", "1", "-1", "0x10", "true", "12:00:00", "1999-02-30"];
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let whole: Vec<usize> =
        (0..lines.len()).filter(|&at| lines[at].ends_with("/>") || lines[at].contains("</")).collect();
    // steps through all lines that are elements of their own
    let at = whole[number * 7919 % whole.len()];
    match number % 4 {
        0 if lines[at].ends_with("/>") => _ = lines.remove(at),
        1 if lines[at].ends_with("/>") => lines.insert(at, lines[at].clone()),
        2 if lines[at].ends_with("/>") && lines[at + 1].ends_with("/>") => lines.swap(at, at + 1),
        _ => {
            let mut parts: Vec<&str> = lines[at].split('"').collect();
            let values = parts.len() / 2;
            if values > 0 {
                parts[number / 4 % values * 2 + 1] = VALUES[number / 3 % VALUES.len()];
            }
            lines[at] = parts.join("\"");
        }
    }
    lines.join("\n")
}

/// What is edited is judged by the table alone, so the schema may not be stricter. Each fourth change is of another kind than the
/// one before, so a sample has all four; the table itself has the tests of `objdict-xdd`.
#[test]
fn xmllint_accepts_what_has_no_violation() {
    let Some(schemas) = schemas() else { return };
    let mutants = sample(0..150);
    let devices: Vec<_> = ["press-402", "all-types"]
        .map(|name| {
            let path = support::fixtures().join(format!("xdd/{name}.xdd"));
            format::open(&path, &SourceOptions::default()).unwrap().into_device()
        })
        .into();
    for version in XddVersion::ALL {
        let folder = schemas.join(format!("changed-{}", version.name()));
        fs::remove_dir_all(&folder).ok();
        fs::create_dir_all(&folder).unwrap();
        let mut files = Vec::new();
        for (number, device) in devices.iter().enumerate() {
            let mut options = WriteOptions::default();
            options.xdd_version = version;
            let text =
                String::from_utf8(format::write(device, Format::Xdd, &options).unwrap().bytes).unwrap();
            for &mutant in &mutants {
                let text = changed(&text, mutant);
                let source = SourceFile::from_text("changed.xdd", text.as_str());
                if format::read(source, Format::Xdd).violations().is_empty() {
                    files.push(folder.join(format!("{number}-{mutant}.xdd")));
                    fs::write(files.last().unwrap(), text).unwrap();
                }
            }
        }
        assert!(
            (mutants.len() / 4..mutants.len() * 7 / 4).contains(&files.len()),
            "{} are valid",
            files.len()
        );
        assert_valid(&schemas, version, &files);
    }
}

//! The XDD or XDC of every device is valid against CiA 311.

use std::fs;
use std::path::{Path, PathBuf};

use objdict::diagnostic::Findings;
use objdict::format::xml::Tree;
use objdict::format::{self, Format, WriteOptions, XddVersion};
use objdict::source::{SourceFile, SourceOptions};

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
            let written = format::write(description.device(), format, &options);
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

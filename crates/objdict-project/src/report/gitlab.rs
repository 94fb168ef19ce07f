//! The code quality report of GitLab: a subset of the Code Climate format.

use std::collections::HashMap;
use std::io::{self, Write};
use std::path::Path;

use serde::Serialize;

use super::fingerprint::listed;
use super::path::RelativeBase;
use super::{Fingerprint, Location, Report, Subject};
use objdict_model::diagnostic::one_line;
use objdict_model::diagnostic::{Diagnostic, Findings, Severity};

/// Findings as a JSON list, one a line.
#[derive(Debug)]
pub struct Gitlab<W> {
    out: W,
    base: RelativeBase,
    is_empty: bool,
    /// How often each fingerprint was written.
    seen: HashMap<Fingerprint, u32>,
}

#[derive(Serialize)]
struct Issue<'a> {
    description: String,
    check_name: &'a str,
    fingerprint: Fingerprint,
    severity: &'static str,
    location: GitlabPosition<'a>,
}

#[derive(Serialize)]
struct GitlabPosition<'a> {
    path: &'a str,
    lines: GitlabLines,
}

#[derive(Serialize)]
struct GitlabLines {
    begin: u32,
    end: u32,
}

impl<W: Write> Gitlab<W> {
    /// A report that writes to `out`.
    pub fn new(out: W) -> Self {
        Self { out, base: RelativeBase::default(), is_empty: true, seen: HashMap::new() }
    }

    /// Sets the folder that paths are relative to, which is the repository's.
    #[must_use]
    pub fn base(mut self, folder: &Path) -> Self {
        self.base = RelativeBase::new(folder);
        self
    }
}

impl<W: Write> Report for Gitlab<W> {
    fn file(&mut self, subject: Subject<'_>, findings: &Findings) -> io::Result<()> {
        let path = self.base.relative(subject.source().name());
        for (finding, fingerprint) in listed(subject, findings) {
            // all must be unique; without the name of the file they remain when it moves. Those of one file
            // are numbered upwards
            let number = self.seen.entry(fingerprint).or_default();
            let fingerprint = fingerprint.repeated(*number);
            *number = if *number == 0 { u32::MAX } else { *number - 1 };
            self.out.write_all(if self.is_empty { b"[\n" } else { b",\n" })?;
            self.is_empty = false;
            objdict_model::json::write(&mut self.out, &issue(&path, subject, finding, fingerprint))?;
        }
        Ok(())
    }

    fn finish(&mut self) -> io::Result<()> {
        self.out.write_all(if self.is_empty { b"[]\n" } else { b"\n]\n" })?;
        self.out.flush()
    }
}

fn issue<'a>(
    path: &'a str,
    subject: Subject<'_>,
    finding: &'a Diagnostic,
    fingerprint: Fingerprint,
) -> Issue<'a> {
    let at = finding.labels.first().map(|label| Location::new(subject, label));
    let (begin, end) = at.map_or((1, 1), |at| (at.start.line, at.end.line));
    Issue {
        description: one_line(&finding.message.shown()),
        check_name: finding.rule.id,
        fingerprint,
        severity: match finding.severity {
            Severity::Error => "major",
            Severity::Warning => "minor",
            Severity::Note => "info",
        },
        location: GitlabPosition { path, lines: GitlabLines { begin, end } },
    }
}

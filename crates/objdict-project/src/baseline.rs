//! Known findings: a check with a baseline reports only new ones (docs/reference/config.md).

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::report::{FINGERPRINT_NAME, Fingerprint, Subject, fingerprints};
use objdict_model::diagnostic::Findings;
use objdict_model::source::absolute;

/// The maximum size of a baseline in bytes: 80,000 findings, which need 40 MB of memory.
pub const MAX_SIZE: u64 = 16 << 20;

/// The version of the file.
const VERSION: u32 = 1;

/// The findings of some files, identified by fingerprints. The caller chooses the names of the files.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Baseline {
    files: BTreeMap<String, BTreeSet<Known>>,
}

/// A finding that is known. The message is for readers of the file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Known {
    rule: String,
    fingerprint: Fingerprint,
    message: String,
}

/// The reason why a text is not a baseline.
#[derive(Debug)]
#[non_exhaustive]
pub enum BaselineError {
    /// It is not the JSON of a baseline.
    Json(serde_json::Error),
    /// It was written by a different version of this program, or its fingerprints use a different method.
    Version,
}

objdict_model::error_messages! { BaselineError: from serde_json::Error as Json {
    Self::Json(error) => "is not a baseline: {error}";
    Self::Version => "is a baseline of a different version, so its findings cannot be matched";
} }

/// The JSON of a baseline.
#[derive(Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BaselineJson {
    /// The version of the document.
    #[cfg_attr(feature = "schema", schemars(with = "objdict_model::json::Version<VERSION>"))]
    version: u32,
    /// The method of the fingerprints.
    fingerprints: String,
    /// The known findings, sorted.
    findings: Vec<BaselineLine>,
}

/// A known finding.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Finding"))]
struct BaselineLine {
    /// The file, relative to the folder of the baseline.
    file: String,
    /// The id of the rule.
    rule: String,
    /// The identification of the finding in its file.
    fingerprint: String,
    /// The problem, for readers.
    message: String,
}

impl Baseline {
    /// Parses a baseline.
    ///
    /// # Errors
    /// If the text is not a baseline, or its findings cannot be recognised.
    pub fn read(text: &str) -> Result<Self, BaselineError> {
        let document: BaselineJson = serde_json::from_str(text)?;
        if document.version != VERSION || document.fingerprints != FINGERPRINT_NAME {
            return Err(BaselineError::Version);
        }
        let mut baseline = Self::default();
        for BaselineLine { file, rule, fingerprint, message } in document.findings {
            let fingerprint = fingerprint.parse().map_err(serde::de::Error::custom);
            let fingerprint = fingerprint.map_err(BaselineError::Json)?;
            baseline.files.entry(file).or_default().insert(Known { rule, fingerprint, message });
        }
        Ok(baseline)
    }

    /// The text of the baseline: JSON with one finding per line, sorted, so that a change of one finding
    /// changes one line.
    pub fn write(&self) -> String {
        let mut text =
            format!("{{\"version\":{VERSION},\"fingerprints\":\"{FINGERPRINT_NAME}\",\"findings\":[");
        let mut separator = "\n";
        for (file, known) in &self.files {
            for Known { rule, fingerprint, message } in known {
                let (file, rule, message) = (file.clone(), rule.clone(), message.clone());
                let line = BaselineLine { file, rule, fingerprint: fingerprint.to_string(), message };
                text.push_str(separator);
                // a struct of texts is always JSON
                text.push_str(&objdict_model::json::text(&line).unwrap_or_default());
                separator = ",\n";
            }
        }
        text.push_str("\n]}\n");
        text
    }

    /// Adds the findings of a file, or of one more device in it.
    pub fn add<'a>(&mut self, file: &str, subject: impl Into<Subject<'a>>, findings: &Findings) {
        let prints = fingerprints(subject, findings);
        let known = findings.iter().zip(prints).map(|(finding, fingerprint)| Known {
            rule: finding.rule.id.to_owned(),
            fingerprint,
            message: finding.message.to_string(),
        });
        self.files.entry(file.to_owned()).or_default().extend(known);
    }

    /// Takes a finding that has a fingerprint of its own, such as an incident of a log.
    pub fn insert(&mut self, file: &str, rule: &str, fingerprint: Fingerprint, message: String) {
        let known = Known { rule: rule.to_owned(), fingerprint, message };
        self.files.entry(file.to_owned()).or_default().insert(known);
    }

    /// The file of such a finding that is known; it may be found in another one now.
    pub fn file_of(&self, rule: &str, fingerprint: Fingerprint) -> Option<&str> {
        let is_it = |known: &Known| known.rule == rule && known.fingerprint == fingerprint;
        self.files.iter().find(|(_, known)| known.iter().any(is_it)).map(|(file, _)| &**file)
    }

    /// Takes the findings of a file away that are known, and says how many that are. A file that is not in the baseline and has all the
    /// findings of one that `is_gone` is that file, moved.
    pub fn suppress<'a>(
        &self,
        file: &str,
        subject: impl Into<Subject<'a>>,
        findings: &mut Findings,
        is_gone: impl Fn(&str) -> bool,
    ) -> usize {
        if findings.is_empty() {
            return 0;
        }
        let prints = fingerprints(subject, &*findings);
        let Some(known) = self.files.get(file).or_else(|| self.moved(&prints, is_gone)) else { return 0 };
        let known: BTreeSet<(&str, Fingerprint)> =
            known.iter().map(|known| (&*known.rule, known.fingerprint)).collect();
        let mut prints = prints.into_iter();
        let before = findings.len();
        findings.suppress(|finding| {
            prints.next().is_some_and(|fingerprint| known.contains(&(finding.rule.id, fingerprint)))
        });
        before - findings.len()
    }

    /// Like [`Baseline::suppress`], for a baseline in a file: files that no longer exist relative to it are
    /// gone.
    pub fn suppress_beside<'a>(
        &self,
        path: &Path,
        subject: impl Into<Subject<'a>>,
        findings: &mut Findings,
    ) -> usize {
        let subject = subject.into();
        let is_gone = |file: &str| !folder_of(path).join(file).exists();
        self.suppress(&name_in(path, subject.source().name()), subject, findings, is_gone)
    }

    /// The findings of a file that no longer exists and had the same ones, because it was moved.
    fn moved(&self, prints: &[Fingerprint], is_gone: impl Fn(&str) -> bool) -> Option<&BTreeSet<Known>> {
        let prints: BTreeSet<Fingerprint> = prints.iter().copied().collect();
        let is_same = |known: &BTreeSet<Known>| {
            known.len() == prints.len() && known.iter().all(|known| prints.contains(&known.fingerprint))
        };
        self.files.iter().find(|(file, known)| is_same(known) && is_gone(file)).map(|(_, known)| known)
    }

    /// The files, each with the number of its findings.
    pub fn files(&self) -> impl Iterator<Item = (&str, usize)> {
        self.files.iter().map(|(file, known)| (&**file, known.len()))
    }

    /// Number of findings.
    pub fn len(&self) -> usize {
        self.files.values().map(BTreeSet::len).sum()
    }

    /// Whether there are no known findings.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// The folder that the names in a baseline start from.
pub fn folder_of(path: &Path) -> PathBuf {
    let path = absolute(path);
    path.parent().unwrap_or(&path).to_owned()
}

/// The name of a file relative to the folder of a baseline, with `/` between folders.
pub fn name_in(baseline: &Path, file: &str) -> String {
    if file.starts_with('<') {
        // the standard input
        return file.to_owned();
    }
    let (folder, path) = (folder_of(baseline), absolute(Path::new(file)));
    let mut up = String::new();
    for ancestor in folder.ancestors() {
        if let Ok(below) = path.strip_prefix(ancestor) {
            let names: Vec<_> = below.components().map(|part| part.as_os_str().to_string_lossy()).collect();
            return up + &names.join("/");
        }
        up.push_str("../");
    }
    // on a different drive
    path.display().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_format as format;
    use objdict_format::{Description, Format};
    use objdict_model::source::SourceFile;

    const BROKEN: &str = include_str!("../../../fixtures/broken/octal.eds");

    fn description(text: &str) -> Description {
        format::read(SourceFile::from_text("octal.eds", text), Format::Eds)
    }

    fn baseline(text: &str) -> Baseline {
        let description = description(text);
        let mut baseline = Baseline::default();
        baseline.add("octal.eds", &description, &crate::check(&description));
        baseline
    }

    #[test]
    fn a_baseline_is_read_as_it_was_written() {
        let baseline = baseline(BROKEN);
        assert!(baseline.len() > 3);
        let text = baseline.write();
        assert_eq!(text.lines().count(), baseline.len() + 2);
        assert_eq!(Baseline::read(&text).unwrap(), baseline);
        assert_eq!(Baseline::read(&Baseline::default().write()).unwrap(), Baseline::default());
    }

    #[test]
    fn only_what_is_new_is_left() {
        let baseline = baseline(BROKEN);
        let text = format!("; one more line\r\n{BROKEN}\r\n[Nonsense\r\n");
        let description = description(&text);
        let mut findings = crate::check(&description);
        let all = findings.len();
        let known = baseline.suppress("octal.eds", &description, &mut findings, |_| true);
        assert_eq!(known, baseline.len());
        assert_eq!(findings.len(), all - known);
        assert_eq!(findings.suppressed() as usize, known);
        assert!(findings.iter().any(|finding| finding.rule.id == "cia306/unclosed-section"));
        let mut findings = crate::check(&description);
        assert_eq!(baseline.suppress("other.eds", &description, &mut findings, |_| true), 0);
    }

    #[test]
    fn a_moved_file_is_known() {
        let (baseline, description) = (baseline(BROKEN), description(BROKEN));
        for (is_gone, known) in [(false, 0), (true, baseline.len())] {
            let mut findings = crate::check(&description);
            let gone = |file: &str| is_gone && file == "octal.eds";
            assert_eq!(baseline.suppress("moved/octal.eds", &description, &mut findings, gone), known);
        }
    }

    #[test]
    fn what_cannot_be_known_again_is_refused() {
        for (text, message) in [
            ("{}", "is not a baseline: missing field `version` at line 1 column 2"),
            (
                "{\"version\":2,\"fingerprints\":\"x\",\"findings\":[]}",
                "is a baseline of a different version, so its findings cannot be matched",
            ),
        ] {
            assert_eq!(Baseline::read(text).unwrap_err().to_string(), message);
        }
        let text = baseline(BROKEN).write().replacen("\"fingerprint\":\"", "\"fingerprint\":\"z", 1);
        assert!(Baseline::read(&text).is_err());
    }

    #[test]
    fn files_are_called_from_the_folder_of_the_baseline() {
        let name = |baseline: &str, file: &str| name_in(Path::new(baseline), file);
        assert_eq!(name("/a/ci/known.json", "/a/ci/x/b.eds"), "x/b.eds");
        assert_eq!(name("/a/ci/known.json", "/a/b.eds"), "../b.eds");
        assert_eq!(name("known.json", "x/../b.eds"), "b.eds");
        assert_eq!(name("known.json", "<stdin>"), "<stdin>");
    }
}

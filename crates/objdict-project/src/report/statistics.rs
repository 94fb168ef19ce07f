//! The number of findings per rule.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::io::{self, Write};

use super::Subject;
use objdict_model::diagnostic::{Diagnostic, Findings, Fix, Severity};

/// The content of a report.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Detail {
    /// The findings.
    #[default]
    Findings,
    /// The findings, and their number per rule.
    Both,
    /// Only the number of findings per rule.
    Statistics,
}

impl Detail {
    pub(super) fn has_findings(self) -> bool {
        self != Self::Statistics
    }

    pub(super) fn has_statistics(self) -> bool {
        self != Self::Findings
    }
}

/// Counts the findings of each rule.
#[derive(Clone, Debug, Default)]
pub struct Statistics {
    rules: BTreeMap<&'static str, Statistic>,
}

/// The findings of a rule, as numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "full", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Statistic {
    /// The rule's id.
    pub rule: &'static str,
    /// The highest severity of its findings.
    pub severity: Severity,
    /// The number of its findings, including findings that were only counted.
    pub findings: usize,
    /// The number of files with a finding.
    pub files: usize,
    /// The number of findings whose fix is offered ([`Fix::is_offered`]).
    pub fixable: usize,
}

impl Statistics {
    /// Adds the findings of one file.
    pub fn add(&mut self, subject: Subject<'_>, findings: &Findings) {
        let mut counts: BTreeMap<&'static str, Statistic> = BTreeMap::new();
        for finding in findings {
            let (rule, severity) = (finding.rule.id, finding.severity);
            let new = || Statistic { rule, severity, findings: 0, files: 1, fixable: 0 };
            let count = counts.entry(rule).or_insert_with(new);
            count.severity = count.severity.max(severity);
            count.findings += 1;
            count.fixable += usize::from(offer(subject, finding).is_some());
        }
        for (rule, omitted) in findings.omitted() {
            if let Some(count) = counts.get_mut(rule) {
                count.findings += omitted as usize;
            }
        }
        for (rule, count) in counts {
            match self.rules.get_mut(rule) {
                Some(sum) => {
                    sum.severity = sum.severity.max(count.severity);
                    sum.findings += count.findings;
                    sum.files += count.files;
                    sum.fixable += count.fixable;
                }
                None => {
                    self.rules.insert(rule, count);
                }
            }
        }
    }

    /// The rules with findings: by severity, then by number of findings, then by id.
    pub fn rows(&self) -> Vec<Statistic> {
        let mut rows: Vec<Statistic> = self.rules.values().copied().collect();
        rows.sort_by_key(|row| (Reverse(row.severity), Reverse(row.findings), row.rule));
        rows
    }

    /// Writes a table followed by an empty line; nothing if there are no findings.
    pub(super) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let rows = self.rows();
        if rows.is_empty() {
            return Ok(());
        }
        writeln!(out, "Findings  Files  Fixable  Severity  Rule")?;
        for Statistic { rule, severity, findings, files, fixable } in rows {
            let severity = severity.to_string();
            writeln!(out, "{findings:>8}  {files:>5}  {fixable:>7}  {severity:<8}  {rule}")?;
        }
        writeln!(out)
    }
}

/// The first offered fix for the findings of a cause.
pub(super) fn offer<'a>(subject: Subject<'_>, finding: &'a Diagnostic) -> Option<&'a Fix> {
    let description = subject.description()?;
    let mut fixes = std::iter::once(finding).chain(&finding.also).filter_map(|one| one.fix.as_ref());
    fixes.find(|fix| fix.is_offered && description.can_fix(fix))
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_model::diagnostic::{MAX_PER_RULE, RuleInfo, Severity};
    use objdict_model::source::{SourceFile, Span};

    static FEW: RuleInfo = RuleInfo::bare("test/few", Severity::Error);
    static MANY: RuleInfo = RuleInfo::bare("test/many", Severity::Note);

    #[test]
    fn the_worst_rules_are_first() {
        let source = SourceFile::from_text("a", "");
        let mut statistics = Statistics::default();
        let mut findings = Findings::new();
        findings.push(Diagnostic::new(&FEW, Span::empty(0), "m"));
        statistics.add((&source).into(), &findings);
        for _ in 0..MAX_PER_RULE + 5 {
            findings.push(Diagnostic::new(&MANY, Span::empty(0), "m"));
        }
        findings.push(Diagnostic::new(&MANY, Span::empty(0), "m").severity(Severity::Warning));
        statistics.add((&source).into(), &findings);
        let mut out = Vec::new();
        statistics.write(&mut out).unwrap();
        let table = "\
Findings  Files  Fixable  Severity  Rule
       2      2        0  error     test/few
    1006      1        0  warning   test/many

";
        assert_eq!(String::from_utf8(out).unwrap(), table);
    }

    #[test]
    fn nothing_found_is_no_table() {
        let mut out = Vec::new();
        Statistics::default().write(&mut out).unwrap();
        assert!(out.is_empty());
    }
}

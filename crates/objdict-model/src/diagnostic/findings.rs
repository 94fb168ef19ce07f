//! The collection of findings.

use std::collections::BTreeMap;

use super::{Diagnostic, RuleInfo, Severity};

/// The maximum number of findings kept per rule and file; further ones are only counted. This limits memory
/// use for hostile files.
pub const MAX_PER_RULE: u32 = 1000;

/// The findings of one file.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    kept: Vec<Diagnostic>,
    seen: BTreeMap<&'static str, u32>,
    suppressed: u32,
}

impl Findings {
    /// An empty collection.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a finding, or only counts it if its rule already has [`MAX_PER_RULE`].
    pub fn push(&mut self, diagnostic: Diagnostic) {
        let seen = self.seen.entry(diagnostic.rule.id).or_default();
        *seen = seen.saturating_add(1);
        if *seen <= MAX_PER_RULE {
            self.kept.push(diagnostic);
        }
    }

    /// Adds a finding of `rule`, or only counts it without creating it if the rule already has
    /// [`MAX_PER_RULE`].
    pub fn push_with(&mut self, rule: &'static RuleInfo, make: impl FnOnce() -> Diagnostic) {
        if self.is_full(rule) {
            let seen = self.seen.entry(rule.id).or_default();
            *seen = seen.saturating_add(1);
        } else {
            self.push(make());
        }
    }

    /// Changes each finding; removed ones are not counted.
    pub fn filter_map(self, mut change: impl FnMut(Diagnostic) -> Option<Diagnostic>) -> Self {
        let Self { kept, mut seen, suppressed } = self;
        let change = |diagnostic: Diagnostic| {
            let rule = diagnostic.rule.id;
            let changed = change(diagnostic);
            if let Some(seen) = seen.get_mut(rule).filter(|_| changed.is_none()) {
                *seen = seen.saturating_sub(1);
            }
            changed
        };
        let kept = kept.into_iter().filter_map(change).collect();
        Self { kept, seen, suppressed }
    }

    /// Changes the list of kept findings; the counts stay.
    #[must_use]
    pub fn rearrange(mut self, change: impl FnOnce(Vec<Diagnostic>) -> Vec<Diagnostic>) -> Self {
        self.kept = change(self.kept);
        self
    }

    /// Removes the findings of rules, including those that were only counted.
    pub fn remove_rules(&mut self, mut is_removed: impl FnMut(&'static str) -> bool) {
        self.kept.retain(|finding| !is_removed(finding.rule.id));
        self.seen.retain(|rule, _| !is_removed(rule));
    }

    /// Removes the findings that are suppressed, and counts them.
    pub fn suppress(&mut self, mut is_suppressed: impl FnMut(&Diagnostic) -> bool) {
        let Self { kept, seen, suppressed } = self;
        kept.retain(|finding| {
            let is_suppressed = is_suppressed(finding);
            if is_suppressed {
                *suppressed = suppressed.saturating_add(1);
                if let Some(seen) = seen.get_mut(finding.rule.id) {
                    *seen = seen.saturating_sub(1);
                }
            }
            !is_suppressed
        });
    }

    /// Whether no more findings of `rule` are kept, so that expensive searches can be skipped.
    pub fn is_full(&self, rule: &RuleInfo) -> bool {
        self.seen.get(rule.id).is_some_and(|&seen| seen >= MAX_PER_RULE)
    }

    /// Lowers the severities from the finding of this number on to at most `highest`.
    pub fn limit_from(&mut self, first: usize, highest: Severity) {
        for finding in self.kept.iter_mut().skip(first) {
            finding.severity = finding.severity.min(highest);
        }
    }

    /// Adds all findings of `other`, including its counts.
    pub fn append(&mut self, other: Findings) {
        let omitted: Vec<(&'static str, u32)> = other.omitted().collect();
        let suppressed = other.suppressed;
        for diagnostic in other.kept {
            self.push(diagnostic);
        }
        // added after the kept findings, because earlier counts would reduce the number kept
        for (rule, count) in omitted {
            let seen = self.seen.entry(rule).or_default();
            *seen = seen.saturating_add(count);
        }
        self.suppressed = self.suppressed.saturating_add(suppressed);
    }

    /// The kept findings.
    pub fn iter(&self) -> std::slice::Iter<'_, Diagnostic> {
        self.kept.iter()
    }

    /// Sorts the findings by their keys; the sort is stable.
    pub fn sort_by_key<K: Ord>(&mut self, key: impl FnMut(&Diagnostic) -> K) {
        self.kept.sort_by_cached_key(key);
    }

    /// The kept findings as a list.
    pub fn into_vec(self) -> Vec<Diagnostic> {
        self.kept
    }

    /// Whether there are no findings.
    pub fn is_empty(&self) -> bool {
        self.kept.is_empty()
    }

    /// The number of findings kept.
    pub fn len(&self) -> usize {
        self.kept.len()
    }

    /// The highest severity found.
    pub fn worst(&self) -> Option<Severity> {
        self.kept.iter().map(|diagnostic| diagnostic.severity).max()
    }

    /// Whether there is a finding of severity error.
    pub fn has_errors(&self) -> bool {
        self.worst() == Some(Severity::Error)
    }

    /// The number of findings suppressed by the file, the configuration or a baseline.
    pub fn suppressed(&self) -> u32 {
        self.suppressed
    }

    /// The rules with more findings than kept, each with the number omitted.
    pub fn omitted(&self) -> impl Iterator<Item = (&'static str, u32)> + '_ {
        self.seen
            .iter()
            .filter(|&(_, &seen)| seen > MAX_PER_RULE)
            .map(|(&rule, &seen)| (rule, seen - MAX_PER_RULE))
    }
}

impl<'a> IntoIterator for &'a Findings {
    type Item = &'a Diagnostic;
    type IntoIter = std::slice::Iter<'a, Diagnostic>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::{RuleInfo, Severity};
    use crate::source::Span;

    static TEST: RuleInfo = RuleInfo::bare("test/test", Severity::Note);

    fn findings(count: u32) -> Findings {
        let mut findings = Findings::new();
        for _ in 0..count {
            findings.push(Diagnostic::new(&TEST, Span::empty(0), "message"));
        }
        findings
    }

    #[test]
    fn too_many_are_counted() {
        let findings = findings(MAX_PER_RULE + 5);
        assert_eq!(findings.len(), MAX_PER_RULE as usize);
        assert_eq!(findings.omitted().collect::<Vec<_>>(), [("test/test", 5)]);
    }

    #[test]
    fn what_is_appended_keeps_as_many_as_there_is_room_for() {
        for (first, second) in
            [(0, MAX_PER_RULE + 5), (3, MAX_PER_RULE), (600, 600), (MAX_PER_RULE, 7), (2, 3)]
        {
            let mut all = findings(first);
            all.append(findings(second));
            let total = first + second;
            assert_eq!(all.len(), total.min(MAX_PER_RULE) as usize, "{first} and {second}");
            let omitted = all.omitted().map(|(_, count)| count).sum::<u32>();
            assert_eq!(omitted, total.saturating_sub(MAX_PER_RULE), "{first} and {second}");
        }
    }
}

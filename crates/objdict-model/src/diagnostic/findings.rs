//! The collection of findings.

use std::collections::BTreeMap;

use super::{Diagnostic, RuleInfo, Severity};

/// The maximum number of findings of one rule and file in a report.
pub const MAX_PER_RULE: u32 = 1000;

/// Once a file has this many findings, further findings of a rule that has [`MAX_PER_RULE`] are only counted. This
/// limits memory use for hostile files. The maximum among several hundred real files is 2,015, so baselines contain all
/// of them.
const MAX_KEPT: usize = 4_000;

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

    /// Adds a finding, or only counts it if there are too many ([`Self::is_full`]).
    pub fn push(&mut self, diagnostic: Diagnostic) {
        let is_full = self.is_full(diagnostic.rule);
        let seen = self.seen.entry(diagnostic.rule.id).or_default();
        *seen = seen.saturating_add(places_of(&diagnostic));
        if !is_full {
            self.kept.push(diagnostic);
        }
    }

    /// Adds a finding of `rule`, or only counts it without creating it if there are too many ([`Self::is_full`]).
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
            let (rule, places) = (diagnostic.rule.id, places_of(&diagnostic));
            let changed = change(diagnostic);
            if let Some(seen) = seen.get_mut(rule).filter(|_| changed.is_none()) {
                *seen = seen.saturating_sub(places);
            }
            changed
        };
        let kept = kept.into_iter().filter_map(change).collect();
        Self { kept, seen, suppressed }
    }

    /// Changes the list of kept findings: removed ones are not counted, joined ones ([`Diagnostic::also`]) are.
    #[must_use]
    pub fn rearrange(mut self, change: impl FnOnce(Vec<Diagnostic>) -> Vec<Diagnostic>) -> Self {
        let omitted: Vec<(&'static str, u32)> = self.omitted().collect();
        self.kept = change(self.kept);
        self.seen = places_of_rules(&self.kept);
        for (rule, count) in omitted {
            let seen = self.seen.entry(rule).or_default();
            *seen = seen.saturating_add(count);
        }
        self
    }

    /// Removes the findings of rules, including findings that were only counted.
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
                    *seen = seen.saturating_sub(places_of(finding));
                }
            }
            !is_suppressed
        });
    }

    /// Whether no more findings of `rule` are kept, so that expensive searches can be skipped.
    pub fn is_full(&self, rule: &RuleInfo) -> bool {
        self.kept.len() >= MAX_KEPT && self.seen.get(rule.id).is_some_and(|&seen| seen >= MAX_PER_RULE)
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
    pub fn omitted(&self) -> impl Iterator<Item = (&'static str, u32)> {
        self.missing_in(&self.kept)
    }

    /// The findings that a report lists: at most [`MAX_PER_RULE`] of each rule.
    pub fn listed(&self) -> impl Iterator<Item = &Diagnostic> {
        let mut listed: BTreeMap<&'static str, u32> = BTreeMap::new();
        self.kept.iter().filter(move |finding| {
            let count = listed.entry(finding.rule.id).or_default();
            *count += 1;
            *count <= MAX_PER_RULE
        })
    }

    /// The rules with more findings than [listed](Self::listed), each with the number of unlisted ones.
    pub fn unlisted(&self) -> impl Iterator<Item = (&'static str, u32)> {
        self.missing_in(self.listed())
    }

    fn missing_in<'a>(
        &'a self,
        findings: impl IntoIterator<Item = &'a Diagnostic>,
    ) -> impl Iterator<Item = (&'static str, u32)> {
        let there = places_of_rules(findings);
        let missing = |(rule, seen): (&&'static str, &u32)| {
            (*rule, seen.saturating_sub(there.get(rule).copied().unwrap_or_default()))
        };
        let missing: Vec<_> = self.seen.iter().map(missing).filter(|(_, count)| *count > 0).collect();
        missing.into_iter()
    }
}

/// The number of places of a finding and those joined with it.
fn places_of(finding: &Diagnostic) -> u32 {
    u32::try_from(finding.also.len()).unwrap_or(u32::MAX).saturating_add(1)
}

/// The number of places of each rule.
fn places_of_rules<'a>(findings: impl IntoIterator<Item = &'a Diagnostic>) -> BTreeMap<&'static str, u32> {
    let mut places: BTreeMap<&'static str, u32> = BTreeMap::new();
    for finding in findings {
        let count = places.entry(finding.rule.id).or_default();
        *count = count.saturating_add(places_of(finding));
    }
    places
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

    const MANY: u32 = MAX_KEPT as u32;

    #[test]
    fn a_report_lists_some_of_a_rule_and_all_are_known() {
        let findings = findings(MAX_PER_RULE + 5);
        assert_eq!(findings.len(), MAX_PER_RULE as usize + 5);
        assert_eq!(findings.omitted().count(), 0);
        assert_eq!(findings.listed().count(), MAX_PER_RULE as usize);
        assert_eq!(findings.unlisted().collect::<Vec<_>>(), [("test/test", 5)]);
    }

    #[test]
    fn too_many_are_counted() {
        static OTHER: RuleInfo = RuleInfo::bare("test/other", Severity::Note);
        let mut findings = findings(MANY + 5);
        assert_eq!(findings.len(), MAX_KEPT);
        assert_eq!(findings.omitted().collect::<Vec<_>>(), [("test/test", 5)]);
        assert_eq!(findings.unlisted().collect::<Vec<_>>(), [("test/test", MANY + 5 - MAX_PER_RULE)]);
        for _ in 0..MAX_PER_RULE + 3 {
            findings.push(Diagnostic::new(&OTHER, Span::empty(0), "message"));
        }
        assert_eq!(findings.omitted().collect::<Vec<_>>(), [("test/other", 3), ("test/test", 5)]);
    }

    #[test]
    fn what_is_rearranged_is_counted_by_place() {
        let findings = findings(MANY + 5).rearrange(|mut kept| {
            let also = kept.split_off(10);
            kept[0].also = also;
            kept.pop();
            kept
        });
        assert_eq!(findings.omitted().collect::<Vec<_>>(), [("test/test", 5)]);
        assert_eq!(findings.unlisted().collect::<Vec<_>>(), [("test/test", 5)]);
    }

    #[test]
    fn what_is_appended_keeps_as_many_as_there_is_room_for() {
        for (first, second) in [(0, MANY + 5), (3, MANY), (600, 600), (MANY, 7), (2, 3)] {
            let mut all = findings(first);
            all.append(findings(second));
            let total = first + second;
            assert_eq!(all.len(), total.min(MANY) as usize, "{first} and {second}");
            let omitted = all.omitted().map(|(_, count)| count).sum::<u32>();
            assert_eq!(omitted, total.saturating_sub(MANY), "{first} and {second}");
        }
    }
}

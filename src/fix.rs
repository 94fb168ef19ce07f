//! Findings fixed: fixes applied, and proven by reading and checking the text again.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Applicability, At, Diagnostic, Findings};
use crate::format::{self, Description};
use crate::model::Part;
use crate::source::{Edits, Encoding, SourceFile, SourceOptions, Span};

/// So often the text is read and checked anew; what needs more rounds than that is left.
const MAX_ROUNDS: u32 = 10;

/// So many texts are tried in a round to find the fixes that do harm.
const MAX_TRIALS: u32 = 100;

/// The rules that find what a fix of another rule leaves open: a new section lacks what only its author knows.
const LEFT_OPEN: [&str; 4] = [
    "cia306/missing-device-info-key",
    "cia306/missing-file-info-key",
    "cia306/missing-last-eds",
    "cia306/no-baud-rate",
];

/// A rule with so many fixes in a round that did harm gets no further trial.
const MAX_HARM: usize = 8;

/// A description with its findings fixed.
#[derive(Debug)]
pub struct Fixed {
    /// The description as it is now.
    pub description: Description,
    /// What is still found in it.
    pub findings: Findings,
    /// The fixes that were made, in their order.
    pub applied: Vec<AppliedFix>,
    /// The fixes that were not made, for their finding would still be there, or another one would have come.
    pub skipped: Vec<AppliedFix>,
}

/// A fix of a finding.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct AppliedFix {
    /// The rule.
    pub rule: &'static str,
    /// What was found.
    pub message: String,
    /// What was done about it, or was not.
    pub title: String,
}

impl Fixed {
    /// The bytes of the file.
    pub fn bytes(&self) -> Vec<u8> {
        self.description.print()
    }
}

/// Fixes what `check` finds in a description and a fix no less safe than `safety` can fix. Fixes that touch each other are
/// made one after the other: after each round the text is read and checked again, at most ten times. A fix after which its
/// finding is still there, or another one has come, is taken back.
pub fn fix(
    description: Description,
    safety: Applicability,
    check: impl Fn(&Description) -> Findings,
) -> Fixed {
    let findings = check(&description);
    let mut fixed = Fixed { description, findings, applied: Vec::new(), skipped: Vec::new() };
    for _ in 0..MAX_ROUNDS {
        let candidates = candidates(&fixed, safety);
        if candidates.is_empty() {
            break;
        }
        round(&mut fixed, &candidates, &check);
    }
    fixed
}

/// A fix as what it does to the text.
struct Candidate {
    applied: AppliedFix,
    key: Key,
    edits: Vec<(Span, String)>,
    encoding: Option<Encoding>,
}

/// The fixes to be made in one round: those that do not touch one that was taken before.
fn candidates(fixed: &Fixed, safety: Applicability) -> Vec<Candidate> {
    let description = &fixed.description;
    let refused: BTreeSet<&AppliedFix> = fixed.skipped.iter().collect();
    let mut taken = Taken::default();
    let mut candidates = Vec::new();
    for finding in &fixed.findings {
        let Some(fix) = finding.fix.as_ref().filter(|fix| fix.safety <= safety) else { continue };
        let applied = AppliedFix {
            rule: finding.rule.id,
            message: finding.message.to_string(),
            title: fix.title.to_string(),
        };
        if refused.contains(&applied) {
            continue;
        }
        let key = Key::of(finding);
        if let Some(encoding) = description.encoding_of(fix) {
            // alone: in another encoding everything may be another text
            return vec![Candidate { applied, key, edits: Vec::new(), encoding: Some(encoding) }];
        }
        if let Some(edits) = description.edits(fix)
            && taken.take(&edits)
        {
            candidates.push(Candidate { applied, key, edits, encoding: None });
        }
    }
    candidates
}

/// Makes those of the fixes that do no harm.
fn round(fixed: &mut Fixed, candidates: &[Candidate], check: &impl Fn(&Description) -> Findings) {
    let before = Counts::of(&fixed.findings);
    let mut trials = Trials {
        description: &fixed.description,
        candidates,
        check,
        before,
        left: MAX_TRIALS,
        best: None,
        harmful: Vec::new(),
    };
    let mut numbers: Vec<usize> = (0..candidates.len()).collect();
    // those of one rule fail together, and are found fast where they stand together
    numbers.sort_by_key(|&number| candidates[number].applied.rule);
    let mut accepted = trials.narrow(Vec::new(), &numbers);
    accepted.sort_unstable();
    let Trials { best, harmful, .. } = trials;
    let applied = |numbers: Vec<usize>| numbers.into_iter().map(|number| candidates[number].applied.clone());
    fixed.applied.extend(applied(accepted));
    fixed.skipped.extend(applied(harmful));
    if let Some((description, findings)) = best {
        (fixed.description, fixed.findings) = (description, findings);
    }
}

/// The search for the fixes that can be made together.
struct Trials<'a, F> {
    description: &'a Description,
    candidates: &'a [Candidate],
    check: &'a F,
    before: Counts,
    /// How many more texts may be tried.
    left: u32,
    /// What came of the last text that was better than the one before.
    best: Option<(Description, Findings)>,
    harmful: Vec<usize>,
}

impl<F: Fn(&Description) -> Findings> Trials<'_, F> {
    /// Those of `numbers` that can be made with the `accepted` ones, and these. Mostly that is all of them; else each half
    /// is tried alone.
    fn narrow(&mut self, accepted: Vec<usize>, numbers: &[usize]) -> Vec<usize> {
        let mut all = accepted.clone();
        all.extend(numbers);
        if let Some(outcome) = self.attempt(&all) {
            self.best = Some(outcome);
            return all;
        }
        if let [only] = numbers {
            self.harmful.push(*only);
            return accepted;
        }
        if self.is_hopeless(numbers) {
            self.harmful.extend(numbers);
            return accepted;
        }
        let (first, second) = numbers.split_at(numbers.len() / 2);
        let accepted = self.narrow(accepted, first);
        self.narrow(accepted, second)
    }

    /// Whether all of these are fixes of one rule that did harm often enough.
    fn is_hopeless(&self, numbers: &[usize]) -> bool {
        let rule = |number: &usize| self.candidates[*number].applied.rule;
        let Some(first) = numbers.first().map(rule) else { return false };
        let harm = self.harmful.iter().filter(|number| rule(number) == first).count();
        harm >= MAX_HARM && numbers.iter().all(|number| rule(number) == first)
    }

    /// The description with some fixes made, where each fixes its finding and none makes another.
    fn attempt(&mut self, numbers: &[usize]) -> Option<(Description, Findings)> {
        self.left = self.left.checked_sub(1)?;
        let source = self.description.source();
        let mut edits = Edits::new(source);
        let mut encoding = source.encoding();
        let mut fixed = BTreeMap::new();
        for &number in numbers {
            let candidate = &self.candidates[number];
            candidate.edits.iter().for_each(|(span, text)| edits.replace(*span, text.as_str()));
            encoding = candidate.encoding.unwrap_or(encoding);
            *fixed.entry(&candidate.key).or_default() += 1;
        }
        let bytes = encoding.encode(&edits.text().ok()?).ok()?;
        let mut options = SourceOptions::default();
        (options.encoding, options.max_size) = (Some(encoding), u64::MAX);
        let source = SourceFile::from_bytes(source.name(), bytes, &options).ok()?;
        let number = self.description.number();
        let description = format::read(source, self.description.format()).select(number)?;
        let findings = (self.check)(&description);
        Counts::of(&findings).is_better_than(&self.before, &fixed).then_some((description, findings))
    }
}

/// What a finding is counted by: its rule, and the part of the description where it is.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Key(&'static str, Option<Part>);

impl Key {
    fn of(finding: &Diagnostic) -> Self {
        let part = match finding.labels.first().map(|label| &label.at) {
            Some(At::Place(place)) => Some(place.part.clone()),
            _ => None,
        };
        Self(finding.rule.id, part)
    }
}

/// How many findings there are of each kind.
struct Counts {
    parts: BTreeMap<Key, u32>,
    /// By rule alone, those that were only counted among them.
    rules: BTreeMap<&'static str, u32>,
    /// The rules of which not all findings are known.
    capped: BTreeSet<&'static str>,
}

impl Counts {
    fn of(findings: &Findings) -> Self {
        let mut counts = Self { parts: BTreeMap::new(), rules: BTreeMap::new(), capped: BTreeSet::new() };
        for finding in findings {
            *counts.parts.entry(Key::of(finding)).or_default() += 1;
            *counts.rules.entry(finding.rule.id).or_default() += 1;
        }
        for (rule, omitted) in findings.omitted() {
            *counts.rules.entry(rule).or_default() += omitted;
            counts.capped.insert(rule);
        }
        counts
    }

    /// Whether the findings that were `fixed` are gone and no other has come but what a new section leaves open.
    fn is_better_than(&self, before: &Self, fixed: &BTreeMap<&Key, u32>) -> bool {
        let adds_section = fixed.keys().any(|key| key.0 == "cia306/missing-section");
        let is_open = |rule: &str| adds_section && LEFT_OPEN.contains(&rule);
        let mut fixed_of_rules: BTreeMap<&str, u32> = BTreeMap::new();
        for (key, count) in fixed {
            *fixed_of_rules.entry(key.0).or_default() += count;
        }
        let is_less = |now: u32, before: Option<&u32>, fixed: Option<&u32>| {
            now + fixed.copied().unwrap_or_default() <= before.copied().unwrap_or_default()
        };
        let is_known = |key: &Key| !self.capped.contains(key.0) && !before.capped.contains(key.0);
        let rule_is_less =
            |rule: &str, now| is_less(now, before.rules.get(rule), fixed_of_rules.get(rule)) || is_open(rule);
        self.rules.iter().all(|(rule, &now)| rule_is_less(rule, now))
            && self
                .parts
                .iter()
                .filter(|(key, _)| is_known(key))
                .all(|(key, &now)| is_less(now, before.parts.get(key), fixed.get(key)) || is_open(key.0))
    }
}

/// The spans that fixes of a round replace.
#[derive(Default)]
struct Taken(BTreeMap<u32, u32>);

impl Taken {
    /// Takes the spans of a fix, unless one of them overlaps a span that was taken. Texts that are put in may not even touch
    /// another change, for it would be open which comes first.
    fn take(&mut self, edits: &[(Span, String)]) -> bool {
        if edits.iter().any(|(span, _)| self.is_taken(*span)) {
            return false;
        }
        self.0.extend(edits.iter().map(|(span, _)| (span.start, span.end)));
        true
    }

    fn is_taken(&self, span: Span) -> bool {
        let near = self.0.range(..=span.end).rev().take(2);
        near.map(|(&start, &end)| Span::new(start, end)).any(|taken| {
            if taken.is_empty() || span.is_empty() {
                taken.start <= span.end && span.start <= taken.end
            } else {
                taken.start < span.end && span.start < taken.end
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_that_touch_an_insertion_are_taken() {
        let mut taken = Taken::default();
        let edit = |start, end| vec![(Span::new(start, end), String::new())];
        assert!(taken.take(&edit(5, 8)) && taken.take(&edit(8, 10)) && taken.take(&edit(20, 20)));
        for (start, end) in [(4, 6), (9, 9), (10, 10), (5, 5), (20, 20), (19, 20), (20, 21), (0, 30)] {
            assert!(!taken.take(&edit(start, end)), "{start}..{end}");
        }
        assert!(taken.take(&edit(10, 12)) && taken.take(&edit(3, 4)));
        let both = [(Span::new(14, 15), String::new()), (Span::new(9, 10), String::new())];
        assert!(!taken.take(&both) && taken.take(&edit(14, 15)), "all of a fix or nothing");
    }
}

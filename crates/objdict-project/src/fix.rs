//! Fixes findings: applies fixes, and verifies them by reading and checking the text again.
//!
//! All fixes that do not overlap are applied together, the text is read and checked again, and ineffective fixes
//! are reverted.

use std::collections::{BTreeMap, BTreeSet};

use crate::check::conflict;
use crate::check_with;
use crate::compat::with_refused_spellings;
use objdict_format as format;
use objdict_format::{Description, Syntax};
use objdict_lint::Options;
use objdict_model::diagnostic::{Applicability, At, Change, Diagnostic, Findings, Fix, Severity};
use objdict_model::model::{Device, ObjectList, Part};
use objdict_model::source::{Edits, Encoding, SourceFile, SourceOptions, Span};

/// The total size of texts that are read and checked to fix a file, which takes a few seconds, but at least
/// [`MIN_TRIALS`]. Fixes that need more remain ([`Fixed::is_unfinished`]).
const MAX_FIX_BYTES: usize = 64 << 20;
const MIN_TRIALS: usize = 8;

/// The same limit for finding the fixes that a report offers. A larger file has no offered fixes, because two
/// descriptions of it would be in memory.
const MAX_OFFER_BYTES: usize = 8 << 20;

/// The maximum number of texts that are read and checked, regardless of their size.
const MAX_TRIALS: usize = 1000;

/// The time and memory of an object or entry in equivalent bytes, because its text may only be ten bytes
/// long.
const BYTES_PER_PART: usize = 128;

/// The number of trials for a description of this size.
fn trials(description: &Description, bytes: usize, least: usize) -> u32 {
    let parts: usize = description.device().objects.values().map(|object| 1 + object.subs.len()).sum();
    let affordable = bytes / (description.source().text().len() + parts * BYTES_PER_PART).max(1);
    affordable.clamp(least, MAX_TRIALS) as u32
}

/// The rules about content that a fix of another rule leaves open: a new section lacks content that only its
/// author knows.
const LEFT_OPEN: [&str; 4] = [
    "cia306/missing-device-info-key",
    "cia306/missing-file-info-key",
    "cia306/missing-last-eds",
    "cia306/no-baud-rate",
];

/// A rule with this many harmful fixes in a round gets no further trial.
const MAX_HARM: usize = 8;

/// A description with its findings fixed.
#[derive(Debug)]
#[non_exhaustive]
pub struct Fixed {
    /// The resulting description.
    pub description: Description,
    /// The remaining findings.
    pub findings: Findings,
    /// The applied fixes, in order.
    pub applied: Vec<AppliedFix>,
    /// The fixes that cannot be applied, because their finding would remain, or a new one would appear.
    pub skipped: Vec<AppliedFix>,
    /// Whether fixes remain because the limit of trials was reached; fixing the result again continues.
    pub is_unfinished: bool,
}

/// A fix of a finding.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct AppliedFix {
    /// The rule.
    pub rule: &'static str,
    /// The message of the finding.
    pub message: String,
    /// The title of the fix.
    pub title: String,
}

impl Fixed {
    /// The bytes of the file.
    pub fn bytes(&self) -> Vec<u8> {
        self.description.print()
    }
}

/// Fixes the findings of `check` in a description with fixes that are at least as safe as `safety`. Fixes that touch
/// each other are applied one after the other: after each round the text is read and checked again. A fix whose finding
/// remains, or that causes a new one, is reverted, and tried again when other fixes have changed the text. So another
/// run finds nothing more to fix, unless [`Fixed::is_unfinished`].
pub fn fix(
    description: Description,
    safety: Applicability,
    check: impl Fn(&Description) -> Findings,
) -> Fixed {
    let findings = check(&description);
    let mut left = trials(&description, MAX_FIX_BYTES, MIN_TRIALS);
    let (applied, skipped) = (Vec::new(), Vec::new());
    let mut fixed = Fixed { description, findings, applied, skipped, is_unfinished: false };
    // by the numbers of their findings; valid only for this text
    let mut refused: BTreeMap<usize, AppliedFix> = BTreeMap::new();
    loop {
        let Fixed { description, findings, .. } = &fixed;
        let mut candidates = candidates(description, findings, safety, &refused);
        // on its own: a different encoding may change the whole text
        if let Some(number) = candidates.iter().position(|candidate| candidate.encoding.is_some()) {
            candidates = vec![candidates.swap_remove(number)];
        }
        if candidates.is_empty() || left == 0 {
            fixed.is_unfinished = !candidates.is_empty();
            break;
        }
        let mut trials = Trials::new(description, findings, &candidates, &check, left);
        let accepted = trials.run();
        left = trials.left;
        let applied = |number: usize| candidates[number].applied.clone();
        match trials.best.take() {
            Some((description, findings)) => {
                refused.clear();
                fixed.applied.extend(accepted.into_iter().map(applied));
                (fixed.description, fixed.findings) = (description, findings);
            }
            None => refused.extend(trials.harmful.iter().map(|&n| (candidates[n].finding, applied(n)))),
        }
    }
    fixed.skipped.extend(refused.into_values());
    fixed
}

/// Like [`fix`], but also fixes spellings that CiA 306 allows and readers reject: empty numbers, missing keys of
/// `[DummyUsage]`, keys in different case and, without unsafe fixes, a text that is not UTF-8. If the options contain
/// tools, only the fixes that these need are applied.
pub fn fix_for_readers(description: Description, safety: Applicability, options: &Options) -> Fixed {
    let check = |description: &Description| check_with(description, options);
    if description.format().syntax() != Syntax::Ini || !options.tools.is_empty() {
        return fix(description, safety, check);
    }
    let with_spellings = |description: &Description| {
        with_refused_spellings(description, safety, check(description), &options.severities)
    };
    let fixed = fix(description, safety, with_spellings);
    Fixed { findings: check(&fixed.description), ..fixed }
}

/// The findings, offering only the fixes ([`Fix::is_offered`](objdict_model::diagnostic::Fix::is_offered)) that [`fix`]
/// applies to this text at once: no two of them touch each other, and each fixes its finding and causes no other. If
/// some are harmful together, others at their places may be missing.
///
/// Fixes are verified on the text without unrelated objects, if their findings also occur in that; [`fix`] verifies
/// them on the whole text.
pub fn with_sound_fixes(
    description: &Description,
    findings: Findings,
    check: impl Fn(&Description) -> Findings,
) -> Findings {
    let candidates = candidates(description, &findings, Applicability::Unsafe, &BTreeMap::new());
    let trials = trials(description, MAX_OFFER_BYTES, 0);
    let mut trials =
        Trials { is_offer: true, ..Trials::new(description, &findings, &candidates, &check, trials) };
    trials.omit_unrelated_objects();
    let offers: BTreeSet<_> = trials.run().into_iter().map(|number| candidates[number].finding).collect();
    findings.rearrange(|mut kept| {
        for (number, finding) in kept.iter_mut().enumerate() {
            finding.fix.iter_mut().for_each(|fix| fix.is_offered = offers.contains(&number));
        }
        kept
    })
}

/// The objects that a fix adds to object lists or removes from them.
fn listed(device: &Device, fix: &Fix) -> Vec<u16> {
    let mut changed = Vec::new();
    for change in &fix.changes {
        if let Change::List(list, indexes) = change {
            let before: BTreeSet<u16> = device.lists.get(*list).iter().copied().collect();
            let after: BTreeSet<u16> = indexes.iter().copied().collect();
            changed.extend(before.symmetric_difference(&after));
        }
    }
    changed
}

/// The objects that are unrelated to any fix, with their spans. Related objects are those that a fix changes or whose findings
/// it fixes, objects of the same name, mapped objects, the communication profile, and the device profile if a fix
/// changes part of it or the device type.
fn unrelated_objects(description: &Description, candidates: &[Candidate]) -> Vec<(u16, Span)> {
    let (device, mut objects) = (description.device(), description.object_spans());
    let mut related = BTreeSet::new();
    for (span, _) in candidates.iter().flat_map(|candidate| &candidate.edits) {
        let from = objects.partition_point(|(_, written)| written.end < span.start);
        let edited = objects[from..].iter().take_while(|(_, written)| written.start <= span.end);
        related.extend(edited.map(|(index, _)| *index));
    }
    related.extend(candidates.iter().filter_map(|candidate| candidate.key.1.as_ref()?.object()));
    related.extend(candidates.iter().flat_map(|candidate| &candidate.listed));
    let name = |index: &u16| device.objects.get(index).map(|object| hash_of_name(&object.main.name));
    let names: BTreeSet<_> = related.iter().filter_map(name).collect();
    let is_profile = |index: u16| index >= 0x6000;
    // 1000h says which profile applies
    let is_profile_related = related.iter().any(|&index| is_profile(index) || index == 0x1000);
    related.extend(device.pdos().flat_map(|pdo| pdo.mapped().map(|object| object.index).collect::<Vec<_>>()));
    objects.retain(|(index, _)| {
        let is_named = || name(index).is_some_and(|name| names.contains(&name));
        let is_related = *index < 0x2000
            || related.contains(index)
            || is_profile_related && is_profile(*index)
            || is_named();
        !is_related
    });
    objects
}

/// A hash that is equal for names which differ only in spaces and case. Other names may have it too: their objects are
/// then related without need.
fn hash_of_name(name: &str) -> u64 {
    let letters = name.bytes().filter(|byte| !byte.is_ascii_whitespace());
    letters.fold(0, |hash, byte| (hash ^ u64::from(byte.to_ascii_lowercase())).wrapping_mul(0x0100_0000_01B3))
}

/// A fix as edits of the text.
struct Candidate {
    applied: AppliedFix,
    safety: Applicability,
    /// The number of its finding.
    finding: usize,
    key: FindingKey,
    edits: Vec<(Span, String)>,
    encoding: Option<Encoding>,
    /// The indexes that it adds to object lists or removes from them.
    listed: Vec<u16>,
}

/// The fixes to apply in one round: those that do not touch a previously selected one. Safe ones come first.
fn candidates(
    description: &Description,
    findings: &Findings,
    safety: Applicability,
    refused: &BTreeMap<usize, AppliedFix>,
) -> Vec<Candidate> {
    if conflict::is_in(description.source().text()) {
        return Vec::new();
    }
    let fixes = findings.iter().enumerate().filter_map(|(number, finding)| {
        let fix =
            finding.fix.as_ref().filter(|fix| fix.safety <= safety && !refused.contains_key(&number))?;
        Some((number, finding, fix))
    });
    let mut fixes: Vec<_> = fixes.collect();
    fixes.sort_by_key(|(.., fix)| fix.safety);
    let mut taken = Taken::default();
    let candidates = fixes.into_iter().filter_map(|(number, finding, fix)| {
        let encoding = description.encoding_of(fix);
        let edits = match encoding {
            Some(_) => Vec::new(),
            None => description.edits(fix).filter(|edits| taken.take(edits))?,
        };
        let (message, title) = (finding.message.to_string(), fix.title.to_string());
        let applied = AppliedFix { rule: finding.rule.id, message, title };
        let (safety, key) = (fix.safety, FindingKey::of(finding));
        let listed = listed(description.device(), fix);
        Some(Candidate { applied, safety, finding: number, key, edits, encoding, listed })
    });
    candidates.collect()
}

/// The search for the fixes that can be made together.
struct Trials<'a, F> {
    description: &'a Description,
    /// Whether the encoding of the file differs from the one detected from its bytes.
    is_encoding_given: bool,
    candidates: &'a [Candidate],
    check: &'a F,
    /// The omitted parts of the text in which the fixes are tried.
    omitted: Vec<Span>,
    /// The omitted objects, each of which would be a finding of its object list.
    unlisted: BTreeSet<u16>,
    before: Counts,
    /// How many more texts may be tried.
    left: u32,
    /// Whether only the numbers are needed, so that no text is kept.
    is_offer: bool,
    /// The result of the last text that was an improvement.
    best: Option<(Description, Findings)>,
    harmful: Vec<usize>,
}

impl<'a, F: Fn(&Description) -> Findings> Trials<'a, F> {
    fn new(
        description: &'a Description,
        findings: &Findings,
        candidates: &'a [Candidate],
        check: &'a F,
        left: u32,
    ) -> Self {
        let before = Counts::of(findings);
        let source = description.source();
        let is_encoding_given = Encoding::detect(&source.to_bytes()) != source.encoding();
        let (best, harmful, is_offer) = (None, Vec::new(), false);
        let (omitted, unlisted) = (Vec::new(), BTreeSet::new());
        Self {
            description,
            is_encoding_given,
            candidates,
            check,
            omitted,
            unlisted,
            before,
            left,
            is_offer,
            best,
            harmful,
        }
    }

    /// Omits the objects that are unrelated to all fixes, unless that removes a finding to be fixed.
    fn omit_unrelated_objects(&mut self) {
        let (indexes, omitted) = unrelated_objects(self.description, self.candidates).into_iter().unzip();
        self.omitted = omitted;
        if self.omitted.is_empty() {
            return;
        }
        let lists = &self.description.device().lists;
        // a list that is not in order has findings about its order, which must remain
        if ObjectList::ALL.into_iter().all(|list| lists.get(list).is_sorted()) {
            self.unlisted = indexes;
        }
        let counts = self.amended(&[]).map(|(description, _)| Counts::of(&(self.check)(&description)));
        let is_found = |counts: &Counts| {
            let mut keys = self.candidates.iter().map(|candidate| &candidate.key);
            keys.all(|key| counts.parts.get(key) == self.before.parts.get(key))
        };
        match counts.filter(is_found) {
            Some(counts) => self.before = counts,
            None => (self.omitted, self.unlisted) = (Vec::new(), BTreeSet::new()),
        }
    }

    /// Selects the fixes of this round, in the order of their findings. Safe ones are tried first, because they must be
    /// harmless without the others.
    fn run(&mut self) -> Vec<usize> {
        let mut numbers: Vec<usize> = (0..self.candidates.len()).collect();
        // fixes of one rule fail together, and are found faster if they are adjacent
        numbers.sort_by_key(|&number| (self.candidates[number].safety, self.candidates[number].applied.rule));
        let is_safe = |&number: &usize| self.candidates[number].safety == Applicability::Safe;
        let (safe, others) = numbers.split_at(numbers.partition_point(is_safe));
        let mut accepted = Vec::new();
        for numbers in [safe, others].into_iter().filter(|numbers| !numbers.is_empty()) {
            accepted = self.narrow(accepted, numbers);
        }
        accepted.sort_by_key(|&number| self.candidates[number].finding);
        accepted
    }

    /// Those of `numbers` that can be applied together with the `accepted` ones, and these. Usually that is
    /// all of them.
    fn narrow(&mut self, accepted: Vec<usize>, numbers: &[usize]) -> Vec<usize> {
        let mut all = accepted.clone();
        all.extend(numbers);
        match self.attempt(&all) {
            Ok(outcome) => {
                self.best = Some(outcome).filter(|_| !self.is_offer);
                all
            }
            Err(harm) => self.part(accepted, numbers, &harm),
        }
    }

    /// Like [`narrow`](Self::narrow), for `numbers` that are harmful together: those at problematic places are tried
    /// separately from the others; if all are, each half is.
    fn part(&mut self, accepted: Vec<usize>, numbers: &[usize], harm: &[FindingKey]) -> Vec<usize> {
        if self.left == 0 {
            return accepted;
        }
        if let [only] = numbers {
            self.harmful.push(*only);
            return accepted;
        }
        if self.is_hopeless(numbers) {
            self.harmful.extend(numbers);
            return accepted;
        }
        let is_harmless =
            |&number: &usize| !harm.iter().any(|harm| self.candidates[number].key.is_near(harm));
        let (mut first, mut second): (Vec<_>, Vec<_>) = numbers.iter().copied().partition(is_harmless);
        let is_apart = !first.is_empty() && !second.is_empty();
        if !is_apart {
            first = numbers.to_vec();
            second = first.split_off(numbers.len() / 2);
        }
        let all = accepted.len() + first.len();
        let accepted = self.narrow(accepted, &first);
        if accepted.len() < all {
            self.narrow(accepted, &second)
        } else if is_apart && self.is_offer {
            accepted
        } else {
            // with these, it equals the previous trial
            self.part(accepted, &second, harm)
        }
    }

    /// Whether all of these are fixes of one rule that did harm often enough.
    fn is_hopeless(&self, numbers: &[usize]) -> bool {
        let rule = |number: &usize| self.candidates[*number].applied.rule;
        let Some(first) = numbers.first().map(rule) else { return false };
        let harm = self.harmful.iter().filter(|number| rule(number) == first).count();
        harm >= MAX_HARM && numbers.iter().all(|number| rule(number) == first)
    }

    /// The description with some fixes applied, if each fixes its finding and causes no other; otherwise, if known, the
    /// excess findings.
    fn attempt(&mut self, numbers: &[usize]) -> Result<(Description, Findings), Vec<FindingKey>> {
        self.left = self.left.checked_sub(1).ok_or_else(Vec::new)?;
        let (description, fixed) = self.amended(numbers).ok_or_else(Vec::new)?;
        let findings = (self.check)(&description);
        match Counts::of(&findings).harm(&self.before, &fixed) {
            harm if harm.is_empty() => Ok((description, findings)),
            harm => Err(harm),
        }
    }

    /// The description with some fixes applied, and the number of findings of each kind that they fix; `None`
    /// if validation rejects it.
    fn amended(&self, numbers: &[usize]) -> Option<(Description, BTreeMap<&'a FindingKey, u32>)> {
        let source = self.description.source();
        let mut edits = Edits::new(source);
        self.omitted.iter().for_each(|span| edits.replace(*span, ""));
        let mut encoding = source.encoding();
        let mut fixed = BTreeMap::new();
        for &number in numbers {
            let candidate = &self.candidates[number];
            candidate.edits.iter().for_each(|(span, text)| edits.replace(*span, text.as_str()));
            encoding = candidate.encoding.unwrap_or(encoding);
            *fixed.entry(&candidate.key).or_default() += 1;
        }
        let bytes = encoding.encode(&edits.text().ok()?).ok()?;
        // without the bytes that a fix removes, a different encoding may be detected
        let mut options = SourceOptions::default();
        options.encoding = self.is_encoding_given.then_some(encoding);
        options.max_size = u64::MAX;
        let source = SourceFile::from_bytes(source.name(), bytes, &options).ok()?;
        let number = self.description.number();
        let mut description = format::read(source, self.description.format()).select(number)?;
        if !self.unlisted.is_empty() {
            description = description.listing_only(|index| !self.unlisted.contains(&index));
        }
        // rules may be disabled
        description.is_as_valid_as(self.description).then_some((description, fixed))
    }
}

/// The key for counting findings: its rule, and its part of the description.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct FindingKey(&'static str, Option<Part>);

impl FindingKey {
    fn of(finding: &Diagnostic) -> Self {
        let part = match finding.labels.first().map(|label| &label.at) {
            Some(At::Place(place)) => Some(place.part.clone()),
            _ => None,
        };
        Self(finding.rule.id, part)
    }

    /// Whether both are findings about the same part or, if no part is known, of the same rule.
    fn is_near(&self, other: &Self) -> bool {
        match (&self.1, &other.1) {
            (Some(part), Some(other)) => part == other,
            _ => self.0 == other.0,
        }
    }
}

/// The number of findings of each kind.
#[derive(Default)]
struct Counts {
    parts: BTreeMap<FindingKey, u32>,
    /// By rule only, including findings that were only counted.
    rules: BTreeMap<&'static str, u32>,
    /// The kept findings, by rule and minimum severity.
    severe: BTreeMap<(&'static str, Severity), u32>,
    /// The rules with findings that were only counted.
    capped: BTreeSet<&'static str>,
}

impl Counts {
    fn of(findings: &Findings) -> Self {
        let mut counts = Self::default();
        for finding in findings {
            *counts.parts.entry(FindingKey::of(finding)).or_default() += 1;
            *counts.rules.entry(finding.rule.id).or_default() += 1;
            for least in
                [Severity::Warning, Severity::Error].into_iter().filter(|&least| least <= finding.severity)
            {
                *counts.severe.entry((finding.rule.id, least)).or_default() += 1;
            }
        }
        for (rule, omitted) in findings.omitted() {
            *counts.rules.entry(rule).or_default() += omitted;
            counts.capped.insert(rule);
        }
        counts
    }

    /// The excess findings: those that were `fixed` but remain, and those that are new or have become more severe,
    /// except those that a new section leaves open.
    fn harm(&self, before: &Self, fixed: &BTreeMap<&FindingKey, u32>) -> Vec<FindingKey> {
        let adds_section = fixed.keys().any(|key| key.0 == "cia306/missing-section");
        let is_open = |rule: &str| adds_section && LEFT_OPEN.contains(&rule);
        let fixed_of =
            |rule: &str| fixed.iter().filter(|(key, _)| key.0 == rule).map(|(_, count)| count).sum();
        let is_more =
            |now: u32, before: Option<&u32>, fixed: u32| now + fixed > before.copied().unwrap_or_default();
        let is_known = |rule: &str| !self.capped.contains(rule) && !before.capped.contains(rule);
        let rules = self
            .rules
            .iter()
            .filter(|&(rule, &now)| !is_known(rule) && is_more(now, before.rules.get(rule), fixed_of(rule)));
        let severe = self
            .severe
            .iter()
            .filter(|&(key, &now)| is_known(key.0) && is_more(now, before.severe.get(key), 0));
        let parts = self.parts.iter().filter(|&(key, &now)| {
            let fixed = fixed.get(key).copied().unwrap_or_default();
            is_known(key.0) && is_more(now, before.parts.get(key), fixed)
        });
        let whole = rules
            .map(|(rule, _)| *rule)
            .chain(severe.map(|((rule, _), _)| *rule))
            .map(|rule| FindingKey(rule, None));
        whole.chain(parts.map(|(key, _)| key.clone())).filter(|key| !is_open(key.0)).collect()
    }
}

/// The spans that fixes of a round replace.
#[derive(Default)]
struct Taken(BTreeMap<u32, u32>);

impl Taken {
    /// Reserves the spans of a fix, unless one of them overlaps a reserved span. Inserted texts may not even touch
    /// another change, because their order would be undefined.
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

//! Which lines two versions of a text do not share. Lines that stand once in both are matched first, as many as keep their
//! order; between them, the shortest difference is looked for (Myers, in linear space), with a bound: beyond it, what is
//! between two matches counts as replaced.

use std::collections::HashMap;
use std::ops::Range;

/// Lines of the old version that lines of the new one replace; one of the ranges may be empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineChange {
    /// The lines of the old text.
    pub old: Range<usize>,
    /// The lines of the new text.
    pub new: Range<usize>,
}

/// So many steps a search may take, some tenths of a second: enough for some thousand changes.
const MAX_STEPS: usize = 1 << 26;

/// The changes that make `new` of `old`, in order.
pub fn changes(old: &[&str], new: &[&str]) -> Vec<LineChange> {
    changes_within(MAX_STEPS, old, new)
}

fn changes_within(mut patience: usize, old: &[&str], new: &[&str]) -> Vec<LineChange> {
    let mut numbers = HashMap::new();
    let mut number = |line| {
        let next = numbers.len();
        *numbers.entry(line).or_insert(next)
    };
    let old: Vec<usize> = old.iter().map(|line| number(*line)).collect();
    let new: Vec<usize> = new.iter().map(|line| number(*line)).collect();
    let mut diff = Diff::new(&old, &new);
    let (mut from_old, mut from_new) = (0, 0);
    for (at_old, at_new) in anchors(&old, &new, patience) {
        diff.between(from_old..at_old, from_new..at_new, &mut patience);
        (from_old, from_new) = (at_old + 1, at_new + 1);
    }
    diff.between(from_old..old.len(), from_new..new.len(), &mut patience);
    slide(&new, &mut diff.is_new);
    diff.changes()
}

/// Two ranges without the lines that they share at their starts and at their ends.
fn without_ends(
    old: &[usize],
    new: &[usize],
    mut in_old: Range<usize>,
    mut in_new: Range<usize>,
) -> (Range<usize>, Range<usize>) {
    while !in_old.is_empty() && !in_new.is_empty() && old[in_old.start] == new[in_new.start] {
        (in_old.start, in_new.start) = (in_old.start + 1, in_new.start + 1);
    }
    while !in_old.is_empty() && !in_new.is_empty() && old[in_old.end - 1] == new[in_new.end - 1] {
        (in_old.end, in_new.end) = (in_old.end - 1, in_new.end - 1);
    }
    (in_old, in_new)
}

/// The positions of lines that stand once in either version, as many as have the same order in both.
fn anchors(old: &[usize], new: &[usize], mut patience: usize) -> Vec<(usize, usize)> {
    let single = |lines: &[usize]| {
        let mut counts: HashMap<usize, u32> = HashMap::new();
        lines.iter().for_each(|line| *counts.entry(*line).or_default() += 1);
        (0..lines.len()).filter(|&at| counts.get(&lines[at]) == Some(&1)).collect::<Vec<usize>>()
    };
    let (places_old, places_new) = (single(old), single(new));
    let lines =
        |lines: &[usize], places: &[usize]| places.iter().map(|&at| lines[at]).collect::<Vec<usize>>();
    let (single_old, single_new) = (lines(old, &places_old), lines(new, &places_new));
    let mut diff = Diff::new(&single_old, &single_new);
    diff.between(0..single_old.len(), 0..single_new.len(), &mut patience);
    let shared =
        |places: Vec<usize>, marks: Vec<bool>| places.into_iter().zip(marks).filter(|(_, mark)| !mark);
    let pairs = shared(places_old, diff.is_old).zip(shared(places_new, diff.is_new));
    pairs.map(|((at_old, _), (at_new, _))| (at_old, at_new)).collect()
}

/// The lines of two versions as numbers, and which of them are not shared.
struct Diff<'a> {
    old: &'a [usize],
    new: &'a [usize],
    is_old: Vec<bool>,
    is_new: Vec<bool>,
}

impl<'a> Diff<'a> {
    fn new(old: &'a [usize], new: &'a [usize]) -> Self {
        Self { old, new, is_old: vec![false; old.len()], is_new: vec![false; new.len()] }
    }

    /// Marks the lines of two ranges that are not shared.
    fn between(&mut self, mut old: Range<usize>, mut new: Range<usize>, patience: &mut usize) {
        // what lies behind a split waits in a list: a text does not decide how deep calls go
        let mut parts = Vec::new();
        loop {
            (old, new) = without_ends(self.old, self.new, old, new);
            let lines = (&self.old[old.clone()], &self.new[new.clone()]);
            let is_one_sided = old.is_empty() || new.is_empty();
            let split = if is_one_sided { None } else { split(lines.0, lines.1, patience) };
            // a way with a step on either side of the split gets shorter on both
            let point = split.map(|(rows, columns)| (old.start + rows, new.start + columns));
            let is_inside = |&point: &(usize, usize)| {
                point != (old.start, new.start)
                    && point != (old.end, new.end)
                    && point.0 <= old.end
                    && point.1 <= new.end
            };
            if let Some((at_old, at_new)) = point.filter(is_inside) {
                parts.push((at_old..old.end, at_new..new.end));
                (old.end, new.end) = (at_old, at_new);
                continue;
            }
            self.is_old[old].fill(true);
            self.is_new[new].fill(true);
            match parts.pop() {
                Some(part) => (old, new) = part,
                None => return,
            }
        }
    }

    /// The changes that the marks say.
    fn changes(&self) -> Vec<LineChange> {
        let mut changes = Vec::new();
        let (mut old, mut new) = (0, 0);
        while old < self.old.len() || new < self.new.len() {
            let change =
                LineChange { old: old..run_end(&self.is_old, old), new: new..run_end(&self.is_new, new) };
            // both have a shared line there, or both are at their ends
            (old, new) = (change.old.end + 1, change.new.end + 1);
            if !change.old.is_empty() || !change.new.is_empty() {
                changes.push(change);
            }
        }
        changes
    }
}

/// How far paths of a number of steps come on each diagonal, counted from the lowest.
struct Reach {
    reached: Vec<usize>,
    lowest: isize,
}

impl Reach {
    /// For paths of at most so many steps.
    fn new(steps: usize) -> Self {
        Self { reached: vec![0; 2 * steps + 3], lowest: -(steps as isize) - 1 }
    }

    fn of(&mut self, diagonal: isize) -> &mut usize {
        &mut self.reached[(diagonal - self.lowest) as usize]
    }

    /// How far one more step comes on a diagonal: from the one above, with a line of `new`, or from the one below, with a
    /// line of `old`.
    fn next(&mut self, diagonal: isize, steps: isize) -> usize {
        let (below, above) = (*self.of(diagonal - 1), *self.of(diagonal + 1));
        let is_from_above = diagonal == -steps || (diagonal != steps && below < above);
        if is_from_above { above } else { below + 1 }
    }
}

/// A point on a shortest way from the start of two ranges to their ends, where paths from either side meet (E. W. Myers, *An
/// O(ND) difference algorithm and its variations*, §4b); `None` when finding it takes too long.
fn split(old: &[usize], new: &[usize], patience: &mut usize) -> Option<(usize, usize)> {
    let (rows, columns) = (old.len(), new.len());
    // to look for a way of so many steps takes their square
    let most = (rows + columns).div_ceil(2).min(patience.isqrt());
    let (mut forward, mut backward) = (Reach::new(most), Reach::new(most));
    let delta = rows as isize - columns as isize;
    let is_odd = delta % 2 != 0;
    for steps in 0..=most as isize {
        for diagonal in (-steps..=steps).rev().step_by(2) {
            let start = forward.next(diagonal, steps);
            let column = start.wrapping_add_signed(-diagonal);
            let shared = old
                .get(start..)
                .zip(new.get(column..))
                .map_or(0, |(old, new)| old.iter().zip(new).take_while(|(old, new)| old == new).count());
            *forward.of(diagonal) = start + shared;
            *patience = patience.checked_sub(1 + shared)?;
            let opposite = delta - diagonal;
            if is_odd && opposite.abs() < steps && start + shared + *backward.of(opposite) >= rows {
                return Some((start, column));
            }
        }
        for diagonal in (-steps..=steps).rev().step_by(2) {
            let start = backward.next(diagonal, steps);
            let column = start.wrapping_add_signed(-diagonal);
            let left = rows.checked_sub(start).zip(columns.checked_sub(column));
            let shared = left.map_or(0, |(rows, columns)| {
                let pairs = old[..rows].iter().rev().zip(new[..columns].iter().rev());
                pairs.take_while(|(old, new)| old == new).count()
            });
            *backward.of(diagonal) = start + shared;
            *patience = patience.checked_sub(1 + shared)?;
            let opposite = delta - diagonal;
            if !is_odd && opposite.abs() <= steps && start + shared + *forward.of(opposite) >= rows {
                return Some((rows.checked_sub(start + shared)?, columns.checked_sub(column + shared)?));
            }
        }
    }
    None
}

/// Moves each run of new lines up to the run before it, where the text allows that, so that they become one, and then down
/// as far as it goes: what is added behind a section leaves the section that was there unmarked.
fn slide(lines: &[usize], is_new: &mut [bool]) {
    let mut at = 0;
    while let Some(found) = is_new[at..].iter().position(|mark| *mark) {
        let mut start = at + found;
        let mut end = run_end(is_new, start);
        while start > 0 && lines[start - 1] == lines[end - 1] {
            (start, end) = (start - 1, end - 1);
            is_new.swap(start, end);
            while start > 0 && is_new[start - 1] {
                start -= 1;
            }
        }
        while end < lines.len() && lines[start] == lines[end] {
            is_new.swap(start, end);
            (start, end) = (start + 1, run_end(is_new, end));
        }
        at = end;
    }
}

/// Where a run of marks ends.
fn run_end(marks: &[bool], from: usize) -> usize {
    marks[from..].iter().position(|mark| !mark).map_or(marks.len(), |at| from + at)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn diff(old: &str, new: &str) -> String {
        let (old, new): (Vec<&str>, Vec<&str>) = (old.split(' ').collect(), new.split(' ').collect());
        let changes = changes(&old, &new).into_iter().map(|change| {
            let start = change.old.start;
            format!("{start}: -{} +{}", old[change.old].concat(), new[change.new].concat())
        });
        changes.collect::<Vec<_>>().join(", ")
    }

    #[test]
    fn changes_of_hand() {
        assert_eq!(diff("a b c", "a b c"), "");
        assert_eq!(diff("a b c", "a x c"), "1: -b +x");
        assert_eq!(diff("a b c", "b c d"), "0: -a +, 3: - +d");
        assert_eq!(diff("a b c", "x y"), "0: -abc +xy");
        assert_eq!(diff("a b c a b b a", "c b a b a c"), "0: -ab +, 3: -a +, 5: - +a, 7: - +c");
    }

    #[test]
    fn a_section_that_is_added_keeps_the_one_behind_it() {
        // a section is a head, its lines and an empty one
        assert_eq!(diff("h1 x . h3 x .", "h1 x . h2 x . h3 x ."), "3: - +h2x.");
        assert_eq!(diff("x . x .", "x . x . x ."), "4: - +x.");
    }

    #[test]
    fn sections_that_change_places_are_matched_by_their_heads() {
        assert_eq!(diff("h1 x . h2 y . h3 x .", "h2 y . h3 x . h1 x ."), "0: -h1x. +, 9: - +h1x.");
    }

    #[test]
    fn a_search_without_end_is_given_up() {
        let lines = |seed: usize| {
            let random = std::iter::successors(Some(seed), |last| Some(last.wrapping_mul(0x5DEE_CE66D) + 11));
            random.skip(1).take(100_000).map(|number| (number >> 20) % 50).map(|number| number.to_string())
        };
        let (old, new): (Vec<String>, Vec<String>) = (lines(1).collect(), lines(2).collect());
        let [old, new] = [&old, &new].map(|lines| lines.iter().map(String::as_str).collect::<Vec<_>>());
        let start = std::time::Instant::now();
        assert!(!changes_within(1 << 22, &old, &new).is_empty());
        assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]
        #[test]
        fn changes_applied_to_the_old_text_give_the_new_one(
            old in prop::collection::vec(0u8..6, 0..40),
            new in prop::collection::vec(0u8..6, 0..40),
        ) {
            let texts: Vec<String> = (0..6).map(|line| line.to_string()).collect();
            let lines = |numbers: &[u8]| -> Vec<&str> { numbers.iter().map(|&number| texts[usize::from(number)].as_str()).collect() };
            let (old, new) = (lines(&old), lines(&new));
            let mut applied = Vec::new();
            let mut at = 0;
            for change in changes(&old, &new) {
                prop_assert!(at <= change.old.start);
                applied.extend_from_slice(&old[at..change.old.start]);
                prop_assert_eq!(applied.len(), change.new.start);
                applied.extend_from_slice(&new[change.new]);
                at = change.old.end;
            }
            applied.extend_from_slice(&old[at..]);
            prop_assert_eq!(applied, new);
        }
    }
}

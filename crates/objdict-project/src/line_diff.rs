//! The lines in which two versions of a text differ.

use std::collections::HashMap;
use std::ops::Range;

use similar::{Algorithm, DiffOp, capture_diff_slices};

/// Lines of the old version that lines of the new one replace; one of the ranges may be empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineChange {
    /// The lines of the old text.
    pub old: Range<usize>,
    /// The lines of the new text.
    pub new: Range<usize>,
}

/// The maximum number of line pairs compared in total: a larger range between two matches is treated as replaced. There
/// is no time limit, so the difference of two texts is the same everywhere.
const MAX_PAIRS: usize = 1 << 26;

/// The changes from `old` to `new`, in order. Lines that are unique in both are matched first, so that
/// sections keep their lines.
pub fn changes(old: &[&str], new: &[&str]) -> Vec<LineChange> {
    let (mut pairs, mut at) = (MAX_PAIRS, [0, 0]);
    let mut joined: Vec<LineChange> = Vec::new();
    for next in anchors(old, new).into_iter().chain([[old.len(), new.len()]]) {
        for change in between([old, new], at, next, &mut pairs) {
            match joined
                .last_mut()
                .filter(|last| [last.old.end, last.new.end] == [change.old.start, change.new.start])
            {
                Some(last) => (last.old.end, last.new.end) = (change.old.end, change.new.end),
                None => joined.push(change),
            }
        }
        at = next.map(|line| line + 1);
    }
    joined
}

/// The changes between two matches; `pairs` is the number of remaining comparisons.
fn between(
    [old, new]: [&[&str]; 2],
    start: [usize; 2],
    end: [usize; 2],
    pairs: &mut usize,
) -> Vec<LineChange> {
    let (old, new) = (&old[start[0]..end[0]], &new[start[1]..end[1]]);
    let is_same = |(old, new): &(&&str, &&str)| old == new;
    let before = old.iter().zip(new).take_while(is_same).count();
    let (old, new) = (&old[before..], &new[before..]);
    let behind = old.iter().rev().zip(new.iter().rev()).take_while(is_same).count();
    let (old, new) = (&old[..old.len() - behind], &new[..new.len() - behind]);
    let shifted = |range: Range<usize>, by: usize| range.start + by + before..range.end + by + before;
    let change = |old, new| LineChange { old: shifted(old, start[0]), new: shifted(new, start[1]) };
    let count = old.len().saturating_mul(new.len());
    if count == 0 || count > *pairs {
        let is_change = !old.is_empty() || !new.is_empty();
        return is_change.then(|| change(0..old.len(), 0..new.len())).into_iter().collect();
    }
    *pairs -= count;
    let operations = capture_diff_slices(Algorithm::Myers, old, new);
    let changes = operations.iter().filter(|operation| !matches!(operation, DiffOp::Equal { .. }));
    changes.map(|operation| change(operation.old_range(), operation.new_range())).collect()
}

/// The longest sequence of lines that are unique in both texts and in the same order, with their numbers in
/// both.
fn anchors(old: &[&str], new: &[&str]) -> Vec<[usize; 2]> {
    const NEVER: usize = usize::MAX;
    const OFTEN: usize = usize::MAX - 1;
    let mut lines: HashMap<&str, [usize; 2]> = HashMap::new();
    for (side, texts) in [old, new].into_iter().enumerate() {
        for (number, text) in texts.iter().enumerate() {
            let at = &mut lines.entry(text).or_insert([NEVER; 2])[side];
            *at = if *at == NEVER { number } else { OFTEN };
        }
    }
    let mut once: Vec<_> = lines.into_values().filter(|at| at.iter().all(|&at| at < OFTEN)).collect();
    once.sort_unstable();
    // for each length, the chain that ends first in the new text
    let (mut ends, mut previous): (Vec<usize>, Vec<Option<usize>>) = (Vec::new(), Vec::new());
    for (number, [_, new]) in once.iter().enumerate() {
        let length = ends.partition_point(|&end| once[end][1] < *new);
        previous.push(length.checked_sub(1).map(|shorter| ends[shorter]));
        match ends.get_mut(length) {
            Some(end) => *end = number,
            None => ends.push(number),
        }
    }
    let mut chain: Vec<_> =
        std::iter::successors(ends.last().copied(), |&end| previous[end]).map(|end| once[end]).collect();
    chain.reverse();
    chain
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
        assert_eq!(changes(&old, &new), [LineChange { old: 0..old.len(), new: 0..new.len() }]);
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

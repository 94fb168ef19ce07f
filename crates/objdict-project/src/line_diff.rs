//! Which lines two versions of a text do not share.

use std::ops::Range;
use std::time::{Duration, Instant};

use similar::{Algorithm, DiffOp, capture_diff_slices_deadline};

/// Lines of the old version that lines of the new one replace; one of the ranges may be empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineChange {
    /// The lines of the old text.
    pub old: Range<usize>,
    /// The lines of the new text.
    pub new: Range<usize>,
}

/// After this time, what lies between two matches counts as replaced. Thousands of changes take less.
const PATIENCE: Duration = Duration::from_secs(2);

/// The changes that make `new` of `old`, in order. Lines that both have once are matched first, so that sections keep their lines.
pub fn changes(old: &[&str], new: &[&str]) -> Vec<LineChange> {
    let operations =
        capture_diff_slices_deadline(Algorithm::Patience, old, new, Some(Instant::now() + PATIENCE));
    let changes = operations.iter().filter(|operation| !matches!(operation, DiffOp::Equal { .. }));
    let mut joined: Vec<LineChange> = Vec::new();
    for operation in changes {
        let (old, new) = (operation.old_range(), operation.new_range());
        match joined.last_mut().filter(|last| last.old.end == old.start && last.new.end == new.start) {
            Some(last) => (last.old.end, last.new.end) = (old.end, new.end),
            None => joined.push(LineChange { old, new }),
        }
    }
    joined
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
        let start = Instant::now();
        assert!(!changes(&old, &new).is_empty());
        assert!(start.elapsed() < 10 * PATIENCE, "{:?}", start.elapsed());
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

//! Several values of a bit field with one meaning as a mask.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use super::BitFieldFacts;

/// The values of a bit field with one meaning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Values {
    /// One value, or one range.
    Range(RangeInclusive<u64>),
    /// Its bits, the highest first: `x01x 0111`. An `x` may be 0 or 1.
    Mask(String),
}

impl<'a> BitFieldFacts<'a> {
    /// The meanings in ascending order; single values with one meaning are a mask where that has all of them and no other.
    pub fn masked(&self) -> Vec<(Values, &'a str)> {
        let is_single = |range: &RangeInclusive<u64>| range.start() == range.end();
        let mut singles: BTreeMap<&str, Vec<u64>> = BTreeMap::new();
        for (range, name) in self.meanings().filter(|(range, _)| is_single(range)) {
            singles.entry(name).or_default().push(*range.start());
        }
        let masks: BTreeMap<&str, (u64, String)> = singles
            .into_iter()
            .filter_map(|(name, values)| Some((name, (*values.first()?, self.mask(&values)?))))
            .collect();
        let shown = self.meanings().filter_map(|(range, name)| match masks.get(name) {
            Some((first, mask)) if is_single(&range) => {
                (range.start() == first).then(|| (Values::Mask(mask.clone()), name))
            }
            _ => Some((Values::Range(range), name)),
        });
        shown.collect()
    }

    /// The mask that has these values and no others; `None` for one value, or if there is none.
    fn mask(&self, values: &[u64]) -> Option<String> {
        let all = values.iter().fold(u64::MAX, |bits, value| bits & value);
        let free = values.iter().fold(0, |bits, value| bits | value) & !all;
        if values.len() < 2 || u32::try_from(values.len()) != Ok(1 << free.count_ones().min(31)) {
            return None;
        }
        let bits = u32::from(self.last - self.first) + 1;
        // documents write a word from its lowest bit in groups of four
        let shown = if self.first == 0 { bits.next_multiple_of(4) } else { bits };
        let mut mask = String::new();
        for bit in (0..shown).rev() {
            mask.push(match () {
                () if bit >= bits || free >> bit & 1 == 1 => 'x',
                () if all >> bit & 1 == 1 => '1',
                () => '0',
            });
            mask.push_str(if bit > 0 && bit % 4 == 0 { " " } else { "" });
        }
        Some(mask)
    }
}

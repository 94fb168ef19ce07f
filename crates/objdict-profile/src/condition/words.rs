//! Conditions in the wording of CiA documents: `1000h bit 16 is set and bit 23 is not`.

use super::{Condition, Term, place_of};
use crate::model::Device;

impl Condition {
    /// The condition as the end of a sentence, with the indexes of a logical device, counted from 0.
    pub fn in_words(&self, device: &Device, block: u8) -> String {
        let mut words = ConditionWords { rest: &self.terms, device, block, text: String::new(), last: None };
        words.term(true, false);
        words.text
    }
}

/// A condition being written.
struct ConditionWords<'a> {
    rest: &'a [Term],
    device: &'a Device,
    block: u8,
    text: String,
    /// Object and predicate of the previous clause.
    last: Option<(u16, &'static str)>,
}

impl ConditionWords<'_> {
    /// Writes the next term or its negation. Alternatives need brackets among terms joined by "and".
    fn term(&mut self, holds: bool, in_all: bool) {
        let Some((term, rest)) = self.rest.split_first() else { return };
        self.rest = rest;
        match *term {
            Term::Not => self.term(!holds, in_all),
            Term::All(count) => self.joined(count, holds, holds, in_all),
            Term::OneOf(count) if holds && self.one_bit(count) => {}
            Term::OneOf(count) => self.joined(count, !holds, holds, in_all),
            Term::Described(index, sub) => {
                let is = if holds { "is described" } else { "is not described" };
                let sub = sub.map(|sub| format!("sub-index {sub}"));
                self.clause(index, sub.as_deref(), is);
            }
            Term::BitsIn(index, _, [first, last], count) => self.bits(index, [first, last], count, holds),
            Term::ValueIn(index, sub, count) => {
                let has_subs = self
                    .device
                    .object(place_of(index, self.device, self.block))
                    .is_some_and(|o| o.object_type().has_subs());
                let sub = (sub > 0 || has_subs).then(|| format!("sub-index {sub}"));
                let ranges = self.ranges(count);
                self.clause(index, sub.as_deref(), if holds { "is" } else { "is not" });
                self.text.push_str(&ranges);
            }
            Term::Range(..) => {}
        }
    }

    fn joined(&mut self, count: u32, is_all: bool, holds: bool, in_all: bool) {
        let has_brackets = in_all && !is_all;
        if has_brackets {
            self.text.push('(');
        }
        for number in 0..count {
            if number > 0 {
                self.text.push_str(if is_all { " and " } else { " or " });
            }
            self.term(holds, is_all);
        }
        if has_brackets {
            self.text.push(')');
        }
    }

    /// Writes alternatives that are set bits of one object as `one of bits 7 to 9 of 6502h is set`; `false` if they are others.
    fn one_bit(&mut self, count: u32) -> bool {
        let terms = self.rest.chunks(2).take(count as usize);
        let bit = |terms: &[Term]| match *terms {
            [Term::BitsIn(index, 0, [first, last], 1), Term::Range(1, _)] if first == last => {
                Some((index, first))
            }
            _ => None,
        };
        let Some(bits) = terms.map(bit).collect::<Option<Vec<_>>>() else { return false };
        let [(index, first), .., (_, last)] = bits[..] else { return false };
        if bits.len() < 3 || bits.iter().any(|(other, _)| *other != index) {
            return false;
        }
        let is_range = usize::from(last.saturating_sub(first)) + 1 == bits.len() && bits.is_sorted();
        let listed: Vec<String> = bits.iter().map(|(_, bit)| bit.to_string()).collect();
        let listed = if is_range { format!("{first} to {last}") } else { listed.join(", ") };
        let place = place_of(index, self.device, self.block);
        self.text.push_str(&format!("one of bits {listed} of {place:04X}h is set"));
        self.rest = self.rest.get(2 * bits.len()..).unwrap_or_default();
        self.last = None;
        true
    }

    fn bits(&mut self, index: u16, [first, last]: [u8; 2], count: u32, holds: bool) {
        let bits = if first == last { format!("bit {first}") } else { format!("bits {first} to {last}") };
        let wanted = match self.rest.first() {
            Some(Term::Range(1, high)) if count == 1 && (first == last || *high == i128::MAX) => Some(holds),
            Some(Term::Range(0, 0)) if count == 1 => Some(!holds),
            _ => None,
        };
        let ranges = self.ranges(count);
        match (wanted, first == last) {
            (Some(true), true) => self.clause(index, Some(&bits), "is set"),
            (Some(false), true) => self.clause(index, Some(&bits), "is not set"),
            (Some(true), false) => self.clause(index, Some(&bits), "are not 0"),
            (Some(false), false) => self.clause(index, Some(&bits), "are 0"),
            (None, _) => {
                let is = match (first == last, holds) {
                    (true, true) => "is",
                    (true, false) => "is not",
                    (false, true) => "are",
                    (false, false) => "are not",
                };
                self.clause(index, Some(&bits), is);
                self.text.push_str(&ranges);
            }
        }
    }

    /// A subject and its predicate, without parts that the previous clause already contains.
    fn clause(&mut self, index: u16, part: Option<&str>, is: &'static str) {
        let index = place_of(index, self.device, self.block);
        let before = self.last.filter(|(other, _)| *other == index).map(|(_, is)| is);
        if before.is_none() || part.is_none() {
            self.text.push_str(&format!("{index:04X}h{}", if part.is_some() { " " } else { "" }));
        }
        self.text.push_str(part.unwrap_or_default());
        let is_shorter = part.is_some() && before == Some("is set") && is == "is not set";
        self.text.push(' ');
        self.text.push_str(if is_shorter { "is not" } else { is });
        self.last = Some((index, is));
    }

    /// The next ranges, preceded by a space.
    fn ranges(&mut self, count: u32) -> String {
        let (ranges, rest) = self.rest.split_at_checked(count as usize).unwrap_or_default();
        self.rest = rest;
        let range = |term: &Term| match *term {
            Term::Range(first, last) if first == last => format!("{first}"),
            Term::Range(i128::MIN, last) => format!("at most {last}"),
            Term::Range(first, i128::MAX) => format!("at least {first}"),
            Term::Range(first, last) => format!("{first} to {last}"),
            _ => String::new(),
        };
        let ranges: Vec<String> = ranges.iter().map(range).collect();
        format!(" {}", ranges.join(" or "))
    }
}

//! Size of the files in flash and RAM.

use super::cell::Location;
use super::plan::Plan;
use crate::SizeReport;
use crate::dictionary::Dictionary;
use crate::memory::{Extent, Memory, Tally};

/// What the sizes include.
const COUNTED: &str = "the tables and values, on a processor of 32 bits; without code and stack internals";

pub(super) fn report(dictionary: &Dictionary<'_>, plan: &Plan) -> SizeReport {
    let (byte, half, pointer) = (Extent::BYTE, Extent::HALF, Extent::POINTER);
    let row = Extent::structure([half, byte, half, half, pointer]);
    let of_record = Extent::structure([pointer, half, half]);
    let mut tally = Tally::of_dictionary(dictionary);
    for object in &plan.rows {
        tally.of(object.index, Memory::Flash, row.size + of_record.times(object.record.len()).size);
    }
    for location in Location::ALL {
        let word = [(None, Extent::WORD)]; // before and behind the variables, and not zero
        let variables = plan.of(&location).flat_map(|variable| variable.extents.iter().copied());
        let members: Vec<_> = word.into_iter().chain(variables).chain(word).collect();
        tally.structure(Memory::Initialised, &members);
    }
    tally.rest(Memory::Flash, 1); // what a row without an entry refers to
    tally.report(COUNTED)
}

//! Size of the files in flash and RAM.

use super::cell::{Planned, Type};
use super::layout::Layout;
use super::para::{Parameters, RESTORE, STORE};
use super::view::{Row, has};
use crate::SizeReport;
use crate::dictionary::Dictionary;
use crate::memory::{Extent, Memory, Tally};

/// What the sizes include.
const COUNTED: &str = "the tables and values, on a processor of 32 bits; without code, the node specification and stack internals";

/// Key, type and data of a row: `CO_OBJ`.
fn row() -> Extent {
    Extent::structure([Extent::WORD, Extent::POINTER, Extent::POINTER])
}

/// `CO_PARA`.
fn group() -> Extent {
    let (word, pointer, reset) = (Extent::WORD, Extent::POINTER, Extent::BYTE);
    Extent::structure([word, word, pointer, pointer, reset, pointer, word])
}

pub(super) fn report(
    dictionary: &Dictionary<'_>,
    planned: &[Vec<Planned>],
    layout: &Layout,
    parameters: &Parameters,
    rows: &[Row],
) -> SizeReport {
    let mut tally = Tally::of_dictionary(dictionary);
    for object in rows {
        tally.of(object.index, Memory::Flash, row().size);
    }
    tally.rest(Memory::Flash, row().size); // the end mark
    let begin = |zero: bool| if zero { Memory::Zeroed } else { Memory::Initialised };
    for variable in &layout.variables {
        tally.of(variable.index, begin(variable.zero), variable.extent.size);
    }
    for group in &layout.groups {
        let members: Vec<_> =
            group.members.iter().map(|member| (Some(member.index), member.extent)).collect();
        tally.structure(begin(group.members.iter().all(|member| member.zero)), &members);
        tally.structure(Memory::Flash, &members); // the defaults
    }
    for &(index, memory, bytes) in &layout.taken {
        tally.of(index, memory, bytes);
    }
    tally.of(STORE, Memory::Flash, parameters.store.len() * group().size);
    tally.of(RESTORE, Memory::Flash, parameters.restore.len() * group().size);
    tally.rest(Memory::Flash, usize::from(parameters.nothing));
    for type_ in [Type::Block, Type::Bytes] {
        let functions = if has(planned, type_) { 5 } else { 0 };
        tally.rest(Memory::Flash, Extent::POINTER.times(functions).size);
    }
    tally.report(COUNTED)
}

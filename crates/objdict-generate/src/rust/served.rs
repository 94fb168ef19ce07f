//! What the node of `objdict-device` does with communication objects.

use std::ops::RangeInclusive;

use crate::Note;
use crate::model::Place;
use crate::table::Table;

/// Objects that SDOs may write without an effect on the node, or with less than CiA 301 and 302 say.
const NOT_SERVED: [(RangeInclusive<u16>, &str); 10] = [
    (0x1006..=0x1006, "the node sends SYNC with this period, but does not monitor the SYNC of another node"),
    (0x1007..=0x1007, "the node does not serve the window of SYNC"),
    (0x100C..=0x100D, "the node does not serve node guarding"),
    (0x1012..=0x1013, "the node does not serve TIME"),
    (
        0x1020..=0x1020,
        "the node does not clear the date and time of the configuration when another value changes",
    ),
    (0x1028..=0x1028, "the node does not serve the emergency messages of other nodes"),
    (0x1280..=0x12FF, "the node has no SDO client; use `SdoClient`"),
    (0x1F50..=0x1F51, "the node does not serve programs; use `WithProgram`"),
    (0x1F80..=0x1F80, "the node starts by itself if bit 2 is 0, but is no NMT master"),
    (0x1F81..=0x1F8F, "the node is no NMT master"),
];

/// The object that stores values.
const STORE: RangeInclusive<u16> = 0x1010..=0x1011;

/// Notes about objects that can be written and that the node does not serve.
pub(super) fn notes(table: &Table) -> Vec<Note> {
    let is_written = |indexes: &RangeInclusive<u16>| {
        let mut rows = table.rows.iter().filter(|row| indexes.contains(&row.index));
        rows.find(|row| row.resolved.access.is_writable()).map(|row| row.index)
    };
    let not_served = NOT_SERVED.iter().filter_map(|(indexes, text)| Some((is_written(indexes)?, *text)));
    let nothing = "the node stores no values and answers 08000020h; `--group` gives it values to store";
    let stores_nothing = is_written(&STORE).filter(|_| table.groups.is_empty()).map(|index| (index, nothing));
    not_served.chain(stores_nothing).map(|(index, text)| Note::new(Place::object(index), text)).collect()
}

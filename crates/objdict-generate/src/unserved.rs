//! Communication objects that the node of `objdict-device` does not implement.

use std::ops::RangeInclusive;

use crate::{Note, model::Place, table::DeviceTable};

/// Objects that SDOs may write without an effect on the node, or with less effect than CiA 301 and 302
/// specify.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Unserved {
    /// The indexes.
    pub indexes: RangeInclusive<u16>,
    /// The service, and the section that describes it; `None` if the node serves part of it.
    pub service: Option<(&'static str, &'static str)>,
    /// The missing behaviour.
    pub text: &'static str,
}

const fn row(
    indexes: RangeInclusive<u16>,
    service: Option<(&'static str, &'static str)>,
    text: &'static str,
) -> Unserved {
    Unserved { indexes, service, text }
}

/// All such objects, by index.
pub const UNSERVED: [Unserved; 10] = [
    row(
        0x1006..=0x1006,
        None,
        "the node sends SYNC with this period, but does not monitor the SYNC of another node",
    ),
    row(0x1007..=0x1007, Some(("SYNC window", "7.5.2.7")), "the node does not serve the window of SYNC"),
    row(0x100C..=0x100D, Some(("node guarding", "7.2.8.3.2")), "the node does not serve node guarding"),
    row(0x1012..=0x1013, Some(("TIME", "7.2.6")), "the node does not serve TIME"),
    row(
        0x1028..=0x1028,
        Some(("emergency consumer", "7.5.2.31")),
        "the node does not serve the emergency messages of other nodes",
    ),
    row(0x1280..=0x12FF, Some(("SDO client", "7.5.2.34")), "the node has no SDO client; use `SdoClient`"),
    row(0x1F50..=0x1F51, None, "the node does not serve programs; use `WithProgram`"),
    row(
        0x1F52..=0x1F55,
        Some(("expected programs", "CiA 302-3")),
        "the node does not compare its program with the expected one",
    ),
    row(0x1F80..=0x1F80, None, "the node starts by itself if bit 2 is 0, but is not an NMT master"),
    row(0x1F81..=0x1F8F, Some(("NMT master", "CiA 302-2")), "the node is not an NMT master"),
];

/// The object that stores values.
const STORE: RangeInclusive<u16> = 0x1010..=0x1011;

/// Notes about objects that can be written and that the node does not serve.
pub(crate) fn notes(table: &DeviceTable) -> Vec<Note> {
    let is_written = |indexes: &RangeInclusive<u16>| {
        let mut rows = table.rows.iter().filter(|row| indexes.contains(&row.index));
        rows.find(|row| row.resolved.access.is_writable()).map(|row| row.index)
    };
    let unserved = UNSERVED.iter().filter_map(|row| Some((is_written(&row.indexes)?, row.text)));
    let nothing = "the node stores no values and answers 08000020h; `--group` gives it values to store";
    let stores_nothing = is_written(&STORE).filter(|_| table.groups.is_empty()).map(|index| (index, nothing));
    unserved.chain(stores_nothing).map(|(index, text)| Note::new(Place::object(index), text)).collect()
}

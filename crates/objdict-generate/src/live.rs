//! The entries of a device as the generated tables have them, for programs that serve a description without compiling it.

use super::dictionary::{self, ResolvedEntry};
use super::resolve::{Encoded, Resolver};
use super::stored::group_of;
use super::{Options, gaps};
use crate::model::{DataType, Device};

/// An entry of a device on a node: the content of a row of a generated table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LiveEntry {
    /// Index of the object.
    pub index: u16,
    /// Sub-index of the entry.
    pub sub: u8,
    /// The data type of its transfers; `None` for a device-specific type.
    pub data_type: Option<DataType>,
    /// The maximum number of bytes of a value, which is also the minimum except for strings, octets and
    /// DOMAINs; 0 for a DOMAIN without capacity.
    pub size: usize,
    /// Whether an SDO upload may read it.
    pub is_readable: bool,
    /// Whether an SDO download may write it.
    pub is_writable: bool,
    /// Whether TPDOs may map it.
    pub fits_tpdo: bool,
    /// Whether RPDOs may map it.
    pub fits_rpdo: bool,
    /// The value at power-on: the configured one, otherwise the default, as an SDO transfers it.
    pub value: Vec<u8>,
    /// The minimum value: two's complement with sign, or the bits of a REAL.
    pub low: Option<u64>,
    /// The highest value, as [`LiveEntry::low`].
    pub high: Option<u64>,
    /// Whether the object is in a storage group, of the options or of the description.
    pub is_grouped: bool,
}

/// The entries of a device on a node in ascending order. Entries that a table cannot contain are omitted; a value
/// that cannot be represented is 0.
pub fn live_entries(device: &Device, node_id: u8, options: &Options) -> Vec<LiveEntry> {
    let (device, _) = gaps::filled(device);
    let mut resolver = Resolver::new(&device, options);
    let mut entries = Vec::new();
    for (&index, object) in &device.objects {
        let object = dictionary::resolve(&mut resolver, options, index, object);
        let Some(object) = object else { continue };
        let is_grouped = group_of(&object, options).is_some();
        for ResolvedEntry { sub, resolved, .. } in object.entries {
            let word = |datum: &Encoded| datum.on_node(Some(node_id));
            let size = resolved.shape.size();
            entries.push(LiveEntry {
                index,
                sub,
                data_type: resolved.shape.data_type(),
                size,
                is_readable: resolved.access.is_readable(),
                is_writable: resolved.access.is_writable(),
                fits_tpdo: resolved.tpdo,
                fits_rpdo: resolved.rpdo,
                value: resolved.default.bytes_on(Some(node_id), size),
                low: resolved.low.as_ref().map(word),
                high: resolved.high.as_ref().map(word),
                is_grouped,
            });
        }
    }
    entries
}

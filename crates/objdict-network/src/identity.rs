//! What a node is by its description.

use crate::model::{Device, Field, Part, Place};
use crate::network::Node;

/// The number in an entry.
pub(crate) fn number(device: &Device, index: u16, sub: u8, node_id: u8) -> Option<u32> {
    let number = device.object(index)?.value(sub)?.integer_for(node_id)?;
    u32::try_from(number).ok()
}

/// Device type, vendor-ID, product code, revision number and serial number (0 where not stated), each with its place:
/// `DeviceInfo` counts more than 1018h, as in dcfgen.
pub(crate) fn described(device: &Device, node_id: u8) -> [(u32, Place); 5] {
    let info = device.device_info.as_ref();
    let of_info = |number: Option<u32>, field| Some((number?, Place::of(Part::DeviceInfo).field(field)));
    let serial = device.commissioning.as_ref().and_then(|node| node.lss_serial_number);
    let place = Place::of(Part::Commissioning).field(Field::LssSerialNumber);
    let or = |stated: Option<(u32, Place)>, index, sub| {
        let present = || (number(device, index, sub, node_id).unwrap_or(0), device.value_place(index, sub));
        stated.unwrap_or_else(present)
    };
    [
        or(None, 0x1000, 0),
        or(info.and_then(|info| of_info(info.vendor_number, Field::VendorNumber)), 0x1018, 1),
        or(info.and_then(|info| of_info(info.product_number, Field::ProductNumber)), 0x1018, 2),
        or(info.and_then(|info| of_info(info.revision_number, Field::RevisionNumber)), 0x1018, 3),
        or(serial.map(|serial| (serial, place)), 0x1018, 4),
    ]
}

/// What the manager expects of the node: what the network file states counts more than the description.
pub(crate) fn expected(node: &Node, node_id: u8) -> [u32; 5] {
    let mut identity = described(&node.device, node_id).map(|(number, _)| number);
    for (stated, place) in [(node.revision_number, 3), (node.serial_number, 4)] {
        identity[place] = stated.map_or(identity[place], |stated| stated.value);
    }
    identity
}
